"""Terms and formulas as Coq reads them, with the standard library's names and as few brackets as it needs."""

from __future__ import annotations

from dataclasses import dataclass

from symcheck.coq.terms import NotExported
from symcheck.core.terms import RELATIONS, Binder, Call, Connective, End, Node, Quantified, Term, Value

FUNCTIONS = {
    "sin": "sin", "cos": "cos", "tan": "tan", "sqrt": "sqrt", "exp": "exp", "log": "ln",
    "arctan": "atan", "arcsin": "asin", "arccos": "acos", "pow": "Rpower",
}  # fmt: skip
TAKEN = frozenset((
    "as", "at", "by", "cofix", "do", "else", "end", "exists", "exists2", "fix", "for", "forall", "fun", "if", "in",
    "let", "match", "mod", "return", "then", "using", "where", "with", "Prop", "Set", "Type", "SProp", "R", "Z", "N",
    "nat", "IZR", "INR", "PI", "sin", "cos", "tan", "sqrt", "exp", "ln", "atan", "asin", "acos", "Rpower", "RInt",
    "Derive", "Derive_n", "pow", "True", "False", "not", "and", "or",
))  # fmt: skip
ATOM, APPLIED, POWER, MINUS, TIMES, PLUS = 0, 10, 30, 35, 40, 50  # levels of Coq's operators
COMPARED, AND, OR, IFF, IMPLIES, BINDS = 70, 80, 85, 95, 99, 200  # levels of Coq's relations, connectives and binders


INFIX = {  # the sign, its level, and up to which levels the first operand and the others need no brackets
    "*": ("*", TIMES, TIMES, TIMES - 1), "/": ("/", TIMES, TIMES, TIMES - 1), "and": ("/\\", AND, AND - 1, AND - 1),
    "or": ("\\/", OR, OR - 1, OR - 1), "<=>": ("<->", IFF, IFF - 1, IFF - 1),
    "=>": ("->", IMPLIES, IMPLIES - 1, IMPLIES),
    **{sign: ("<>" if sign == "!=" else sign, COMPARED, PLUS, PLUS) for sign in RELATIONS},
}  # fmt: skip
WORDS = {"pi": "PI", "and": "True", "or": "False"}  # of nodes without parts


def name(letter: str) -> str:
    """A letter as an identifier of Coq."""
    return f"{letter}'" if letter in TAKEN else letter


def printed(tree: Term, level: int = BINDS) -> str:
    """A term or formula, in brackets if it binds more loosely than the level."""
    return Printer().text(tree, level)


def spelled(tree: Term, level: int = BINDS) -> str:
    """The same with a - b spelled a + - b, as terms stand in Coq once `Rminus` is unfolded."""
    return Printer(subtracts=False).text(tree, level)


@dataclass(frozen=True)
class Printer:
    """Prints terms and formulas; some letters may stand for whole numbers.

    of_theorems  whether sums, products and integrals over the whole line have a form: Theorems.v alone defines them
    """

    subtracts: bool = True
    whole: tuple[str, ...] = ()
    of_theorems: bool = False

    def text(self, tree: Term, level: int = BINDS) -> str:
        """A term or formula, in brackets if it binds more loosely than the level."""
        text, own = self._with_level(tree)
        return text if own <= level else f"({text})"

    def _with_level(self, tree: Term) -> tuple[str, int]:
        match tree:
            case int():
                return (str(tree), ATOM) if tree >= 0 else (f"- {-tree}", MINUS)
            case str():
                return (f"IZR {tree}", APPLIED) if tree in self.whole else (name(tree), ATOM)
            case Value(tag="+", terms=(first, *rest)):
                return " ".join([self.text(first, PLUS), *map(self._addend, rest)]), PLUS
            case Value(tag="-", terms=(inner,)):
                return f"- {self.text(inner, POWER)}", MINUS
            case Value(tag="^", terms=(base, int(n))):
                power = f"{self.text(base, APPLIED)} ^ {abs(n)}"
                return (power, POWER) if n >= 0 else (f"/ {power}", MINUS)
            case Value(tag="^", terms=(base, str(n))):
                return f"{self._applied('powerRZ', base)} {n}", APPLIED
            case Value(tag=function, terms=arguments) if function in FUNCTIONS:
                return self._applied(FUNCTIONS[function], *arguments), APPLIED
            case Call(function=function, orders=orders, terms=arguments) if not any(orders):
                return self._applied(name(function), *arguments), APPLIED
            case Binder():
                return self._binder(tree)
            case Quantified(tag=kind, bound=bound, body=body):
                return f"{kind} {' '.join(map(name, bound))} : R, {self.text(body)}", BINDS
            case Connective(tag="and" | "or", formulas=(only,)):
                return self._with_level(only)
            case Node(tag=tag, outside=(first, *rest)) if tag in INFIX:
                sign, level, left, right = INFIX[tag]
                return f" {sign} ".join([self.text(first, left), *(self.text(part, right) for part in rest)]), level
            case Node(tag=tag, outside=()) if tag in WORDS:
                return WORDS[tag], ATOM
        raise NotExported(reason(tree))

    def _addend(self, term: Term) -> str:
        match term:
            case Value(tag="-", terms=(inner,)):
                return f"- {self.text(inner, PLUS - 1)}" if self.subtracts else f"+ - {self.text(inner, POWER)}"
        return f"+ {self.text(term, PLUS - 1)}"

    def _applied(self, function: str, *arguments: Term) -> str:
        return " ".join([function, *(self.text(t, APPLIED - 1) for t in arguments)])

    def _binder(self, term: Binder) -> tuple[str, int]:
        function = f"(fun {name(term.letter)} => {self.text(term.body)})"
        match term.tag, *term.outside:
            case "diff", 1, place:
                return self._applied(f"Derive {function}", place), APPLIED
            case "diff", order, place:
                return self._applied(f"Derive_n {function}", order, place), APPLIED
            case ("mean",):
                return f"RInt {function} 0 (2 * PI) / (2 * PI)", TIMES
            case "sum" | "product" as kind, low, high if self.of_theorems:
                return self._applied(f"{kind}_between {function}", low, high), APPLIED
            case "integral" | "diverges" as kind, End(tag="-infinity"), End() if self.of_theorems:
                return f"{kind}_over_line {function}", APPLIED
            case "integral", low, high:
                return self._applied(f"RInt {function}", low, high), APPLIED
        raise NotExported(reason(term))


def reason(term: Term) -> str:
    """Why a term has no form in Coq."""
    match term:
        case End():
            return "an integral without an end needs Euler's beta function, which the libraries have not"
        case Value(tag="gamma"):
            return "Euler's gamma function is not in Coq's libraries"
        case Call():
            return "a derivative of an unknown function is not stated in Coq"
        case Binder(tag="diverges"):
            return "the convergence of an improper integral is not stated in Coq"
        case Binder():
            return f"the binder {term.tag}"
    return f"the term {term!r}"
