"""A second reader: Claims.v read back into terms and formulas, by a parser that shares nothing with what wrote it."""

from __future__ import annotations

import re
from functools import cache
from typing import NamedTuple

from lark import Lark, Token, Transformer, v_args

from symcheck.core.terms import Connective, Formula, Node, Quantified, Term, node

# a stated claim: its name, and what stands up to the full stop at the end of a line
CLAIM = re.compile(r"^Definition claim_(\w+) : Prop :=\n(.*?)\.\n$", re.DOTALL | re.MULTILINE)
GRAMMAR = r"""
?formula: iff | iff "->" formula -> implies | FORALL binders "," formula -> quantified | exists
?iff: or | or "<->" or -> equivalent
?or: and | and "\\/" or -> either
?and: relation | relation "/\\" (and | exists) -> both
?exists: EXISTS binders "," formula -> quantified
?relation: sum | sum SIGN sum -> related
?sum: product | sum "+" product -> plus | sum "-" product -> minus
?product: signed | product "*" signed -> times | product "/" signed -> over
?signed: power | "-" signed -> opposite | "/" signed -> inverse
?power: applied | applied "^" NUMBER -> raised
?applied: atom | NAME atom+ -> applied
?atom: NUMBER -> number | NAME -> letter | "(" formula ")" | "(" "fun" NAME "=>" sum ")" -> function
binders: ("(" typed ")")* typed | ("(" typed ")")+
typed: NAME+ ":" type
type: "R" | "R" "->" type -> arrow
FORALL: "forall"
EXISTS: "exists"
SIGN: "=" | "<>" | "<=" | ">=" | "<" | ">"
NAME: /[A-Za-z]\w*'*/
NUMBER: /\d+/
%ignore /\s+/
"""
UNARY = {"sin": "sin", "cos": "cos", "tan": "tan", "sqrt": "sqrt", "exp": "exp", "ln": "log", "atan": "arctan",
         "asin": "arcsin", "acos": "arccos"}  # fmt: skip
WORDS = {"True": node("and"), "False": node("or"), "PI": node("pi")}


class Function(NamedTuple):
    """What "fun x => t" is read as."""

    letter: str
    body: Term


def claims(text: str) -> dict[str, tuple[list[str], list[Formula], Formula]]:
    """By its name each statement of a Claims.v: (letters, premises, conclusion)."""
    return {name: _stated(formula(body)) for name, body in CLAIM.findall(text)}


def _stated(formula: Formula) -> tuple[list[str], list[Formula], Formula]:
    bound, premises = list[str](), list[Formula]()
    while isinstance(formula, Quantified) and formula.tag == "forall":
        bound += formula.bound
        formula = formula.body
    while isinstance(formula, Connective) and formula.tag == "=>":
        premise, formula = formula.formulas
        premises.append(premise)
    return bound, premises, formula


def formula(text: str) -> Formula:
    """A statement of Coq as a formula."""
    result = Nodes().transform(_parser().parse(uncommented(text)))
    assert isinstance(result, Node)
    return result


@cache
def _parser() -> Lark:
    return Lark(GRAMMAR, start="formula", parser="lalr")


def uncommented(text: str) -> str:
    """The text without its comments, which may be nested."""
    out, depth = [], 0
    for piece in re.split(r"(\(\*|\*\))", text):
        depth += (piece == "(*") - (piece == "*)")
        if not depth and piece != "*)":
            out.append(piece)
    return "".join(out)


def letter(name: str) -> str:
    """A letter of a paper; one that means something to Coq is written with a prime."""
    return name.removesuffix("'")


def _binary(tag: str) -> staticmethod[[Term, Term], Term]:
    return staticmethod(lambda left, right: node(tag, left, right))


@v_args(inline=True)
class Nodes(Transformer[Token, Term]):
    """The node of each rule of the grammar; functions are known from the binders in front of them."""

    def __init__(self) -> None:
        super().__init__()
        self.functions: dict[str, int] = {}  # unknown ones, with the numbers of their arguments

    implies, equivalent, either, both = map(_binary, ("=>", "<=>", "or", "and"))
    plus, times, over = map(_binary, "+*/")

    def minus(self, left: Term, right: Term) -> Term:
        return node("+", left, node("-", right))

    def opposite(self, term: Term) -> Term:
        return node("-", term)

    def inverse(self, term: Term) -> Term:
        return node("/", 1, term)

    def raised(self, base: Term, exponent: Token) -> Term:
        return node("^", base, int(exponent))

    def related(self, left: Term, sign: Token, right: Term) -> Term:
        return node("!=" if sign == "<>" else str(sign), left, right)

    def number(self, digits: Token) -> Term:
        return int(digits)

    def letter(self, name: Token) -> Term:
        return WORDS[name] if name in WORDS else letter(name)

    def function(self, x: Token, body: Term) -> Function:
        return Function(letter(x), body)

    def quantified(self, kind: Token, bound: tuple[str, ...], body: Term) -> Term:
        return node(str(kind), bound, body)

    def binders(self, *groups: tuple[str, ...]) -> tuple[str, ...]:
        return sum(groups, ())

    def typed(self, *parts: Token | int) -> tuple[str, ...]:
        *names, arity = parts
        own = tuple(letter(str(name)) for name in names)
        self.functions |= dict.fromkeys(own, int(arity)) if arity else {}
        return own

    def type(self) -> int:
        return 0

    def arrow(self, arity: int) -> int:
        return arity + 1

    def applied(self, name: Token, first: Term | Function, *rest: Term) -> Term:
        if isinstance(first, Function):
            return self.bound(name, first, *rest)
        if name in UNARY and not rest:
            return node(UNARY[name], first)
        if name == "Rpower" and len(rest) == 1:
            return node("pow", first, *rest)
        if self.functions.get(letter(name)) != 1 + len(rest):
            raise ValueError(f"{name} is applied to {1 + len(rest)} arguments")
        return node("call", letter(name), (0,) * (1 + len(rest)), first, *rest)

    def bound(self, name: str, function: Function, *rest: Term) -> Term:
        match name, *rest:
            case "Derive", place:
                return node("diff", function.body, function.letter, 1, place)
            case "Derive_n", order, place:
                return node("diff", function.body, function.letter, order, place)
            case "RInt", low, high:
                return node("integral", function.body, function.letter, low, high)
        raise ValueError(f"{name} of a function and {len(rest)} more arguments")
