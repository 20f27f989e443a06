"""A second reader: Claims.v read back into terms and formulas, by a parser that shares nothing with what wrote it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from symcheck.core.terms import Connective, Formula, Node, Quantified, Term, node

TOKEN = re.compile(r"\s*(\(\*|<->|->|=>|<=|>=|<>|/\\|\\/|[A-Za-z_][\w']*|\d+|[()+\-*/^=<>:,.])")
CLAIM = re.compile(r"^Definition claim_(\w+) : Prop :=\n(.*?)\.\n$", re.DOTALL | re.MULTILINE)
RELATIONS = {"=": "=", "<>": "!=", "<": "<", "<=": "<=", ">": ">", ">=": ">="}
UNARY = {"sin": "sin", "cos": "cos", "tan": "tan", "sqrt": "sqrt", "exp": "exp", "ln": "log", "atan": "arctan",
         "asin": "arcsin", "acos": "arccos"}  # fmt: skip
WORDS = {"True": node("and"), "False": node("or"), "PI": node("pi")}


def claims(text: str) -> dict[str, tuple[list[str], list[Formula], Formula]]:
    """By its name each statement of a Claims.v: (letters, premises, conclusion)."""
    return {name: _stated(Reader(body).whole()) for name, body in CLAIM.findall(text)}


def _stated(formula: Formula) -> tuple[list[str], list[Formula], Formula]:
    bound, premises = list[str](), list[Formula]()
    while isinstance(formula, Quantified) and formula.tag == "forall":
        bound += formula.bound
        formula = formula.body
    while isinstance(formula, Connective) and formula.tag == "=>":
        premise, formula = formula.formulas
        premises.append(premise)
    return bound, premises, formula


def uncommented(text: str) -> str:
    """The text without its comments, which may be nested."""
    out, depth = [], 0
    for piece in re.split(r"(\(\*|\*\))", text):
        depth += (piece == "(*") - (piece == "*)")
        if not depth and piece != "*)":
            out.append(piece)
    return "".join(out)


def tokens(text: str) -> Iterator[str]:
    """The words and signs of a formula."""
    at, text = 0, text.strip()
    while at < len(text):
        found = TOKEN.match(text, at)
        if found is None:
            raise ValueError(f"unknown text {text[at : at + 20]!r}")
        yield found[1]
        at = found.end()


class Reader:
    """One formula, by recursive descent; each method reads what binds at least as tightly as its name says."""

    def __init__(self, text: str) -> None:
        self.tokens = [*tokens(uncommented(text)), ""]
        self.at = 0
        self.functions: dict[str, int] = {}  # unknown ones, with the numbers of their arguments

    def whole(self) -> Formula:
        formula = self.implication()
        self.take("")
        assert isinstance(formula, Node)
        return formula

    def peek(self) -> str:
        return self.tokens[self.at]

    def take(self, *expected: str) -> str:
        found = self.tokens[self.at]
        if expected and found not in expected:
            raise ValueError(f"{found!r} instead of {' or '.join(map(repr, expected))}")
        self.at += 1
        return found

    def implication(self) -> Term:
        if self.peek() in ("forall", "exists"):
            kind, names = self.take(), []
            while self.peek() == "(":
                names += self.binders()
            if self.peek() != ",":
                names += self.typed()
            self.take(",")
            return node(kind, tuple(names), self.implication())
        left = self.equivalence()
        if self.peek() != "->":
            return left
        self.take("->")
        return node("=>", left, self.implication())

    def binders(self) -> list[str]:
        """Letters, or a function, in brackets."""
        self.take("(")
        names = self.typed()
        self.take(")")
        return names

    def typed(self) -> list[str]:
        """Letters, or the names of functions, and their type."""
        names: list[str] = []
        while self.peek() != ":":
            names.append(letter(self.take()))
        self.take(":"), self.take("R")
        while self.peek() == "->":
            self.take("->"), self.take("R")
            self.functions |= {function: self.functions.get(function, 0) + 1 for function in names}
        return names

    def equivalence(self) -> Term:
        left = self.disjunction()
        if self.peek() != "<->":
            return left
        self.take("<->")
        return node("<=>", left, self.disjunction())

    def disjunction(self) -> Term:
        left = self.conjunction()
        if self.peek() != "\\/":
            return left
        self.take("\\/")
        return node("or", left, self.disjunction())

    def conjunction(self) -> Term:
        left = self.relation()
        if self.peek() != "/\\":
            return left
        self.take("/\\")
        return node("and", left, self.implication() if self.peek() == "exists" else self.conjunction())

    def relation(self) -> Term:
        left = self.sum()
        if self.peek() not in RELATIONS:
            return left
        return node(RELATIONS[self.take()], left, self.sum())

    def sum(self) -> Term:
        total = self.product()
        while self.peek() in ("+", "-"):
            sign, term = self.take(), self.product()
            total = node("+", total, term if sign == "+" else node("-", term))
        return total

    def product(self) -> Term:
        total = self.signed()
        while self.peek() in ("*", "/"):
            total = node(self.take(), total, self.signed())
        return total

    def signed(self) -> Term:
        match self.peek():
            case "-":
                self.take()
                return node("-", self.signed())
            case "/":
                self.take()
                return node("/", 1, self.signed())
        return self.power()

    def power(self) -> Term:
        base = self.applied()
        if self.peek() != "^":
            return base
        self.take("^")
        return node("^", base, int(self.take()))

    def applied(self) -> Term:
        head = self.peek()
        if head in UNARY:
            self.take()
            return node(UNARY[head], self.atom())
        if head == "Rpower":
            self.take()
            return node("pow", self.atom(), self.atom())
        if head in ("Derive", "Derive_n"):
            self.take()
            x, body = self.function()
            order = int(self.take()) if head == "Derive_n" else 1
            return node("diff", body, x, order, self.atom())
        if head == "RInt":
            self.take()
            x, body = self.function()
            return node("integral", body, x, self.atom(), self.atom())
        if letter(head) in self.functions:
            function = letter(self.take())
            arguments = [self.atom() for _ in range(self.functions[function])]
            return node("call", function, (0,) * len(arguments), *arguments)
        return self.atom()

    def function(self) -> tuple[str, Term]:
        self.take("("), self.take("fun")
        x = letter(self.take())
        self.take("=>")
        body = self.sum()
        self.take(")")
        return x, body

    def atom(self) -> Term:
        found = self.take()
        if found == "(":
            inner = self.implication()
            self.take(")")
            return inner
        if found.isdigit():
            return int(found)
        if not re.fullmatch(r"[A-Za-z][\w']*", found):
            raise ValueError(f"{found!r} instead of a letter")
        return WORDS[found] if found in WORDS else letter(found)


def letter(name: str) -> str:
    """A letter of a paper; one that means something to Coq is written with a prime."""
    return name.removesuffix("'")
