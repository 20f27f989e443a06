"""Terms and formulas as Coq reads them, with the standard library's names and as few brackets as it needs."""

from __future__ import annotations

from symcheck.coq.terms import NotExported
from symcheck.core.terms import Binder, Call, Connective, End, Node, Quantified, Relation, Term, Value

RELATIONS = {"=": "=", "!=": "<>", "<": "<", "<=": "<=", ">": ">", ">=": ">="}
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
COMPARED, AND, OR, IFF, IMPLIES, BINDS = 70, 80, 85, 95, 99, 200


def name(letter: str) -> str:
    """A letter as an identifier of Coq."""
    return f"{letter}'" if letter in TAKEN else letter


def printed(tree: Term, level: int = BINDS) -> str:
    """A term or formula, in brackets if it binds more loosely than the level."""
    return Printer().text(tree, level)


def spelled(tree: Term, level: int = BINDS) -> str:
    """The same with a - b spelled a + - b, as terms stand in Coq once `Rminus` is unfolded."""
    return Printer(subtracts=False).text(tree, level)


class Printer:
    """Prints terms; some letters may stand for whole numbers."""

    def __init__(self, subtracts: bool = True, whole: tuple[str, ...] = ()) -> None:
        self.subtracts, self.whole = subtracts, whole

    def text(self, tree: Term, level: int = BINDS) -> str:
        """A term or formula, in brackets if it binds more loosely than the level."""
        text, own = self._formula(tree) if isinstance(tree, (Relation, Connective, Quantified)) else self._term(tree)
        return text if own <= level else f"({text})"

    def _term(self, term: Term) -> tuple[str, int]:
        match term:
            case int():
                return (str(term), ATOM) if term >= 0 else (f"- {-term}", MINUS)
            case str():
                return (f"IZR {term}", APPLIED) if term in self.whole else (name(term), ATOM)
            case Value(tag="pi"):
                return "PI", ATOM
            case Value(tag="+", terms=(first, *rest)):
                return " ".join([self.text(first, PLUS), *map(self._addend, rest)]), PLUS
            case Value(tag="-", terms=(inner,)):
                return f"- {self.text(inner, POWER)}", MINUS
            case Value(tag="*", terms=(first, *rest)):
                return " * ".join([self.text(first, TIMES), *(self.text(t, TIMES - 1) for t in rest)]), TIMES
            case Value(tag="/", terms=(top, bottom)):
                return f"{self.text(top, TIMES)} / {self.text(bottom, TIMES - 1)}", TIMES
            case Value(tag="^", terms=(base, int(n))):
                power = f"{self.text(base, APPLIED)} ^ {abs(n)}"
                return (power, POWER) if n >= 0 else (f"/ {power}", MINUS)
            case Value(tag="^", terms=(base, str(n))):
                return f"powerRZ {self.text(base, APPLIED - 1)} {n}", APPLIED
            case Value(tag=function, terms=arguments) if function in FUNCTIONS:
                return self._applied(FUNCTIONS[function], *arguments), APPLIED
            case Call(function=function, orders=orders, terms=arguments) if not any(orders):
                return self._applied(name(function), *arguments), APPLIED
            case Binder(body=body, letter=x, outside=rest):
                return self._binder(term.tag, f"(fun {name(x)} => {self.text(body)})", rest)
        raise NotExported(reason(term))

    def _addend(self, term: Term) -> str:
        match term:
            case Value(tag="-", terms=(inner,)):
                return f"- {self.text(inner, PLUS - 1)}" if self.subtracts else f"+ - {self.text(inner, POWER)}"
        return f"+ {self.text(term, PLUS - 1)}"

    def _applied(self, function: str, *arguments: Term) -> str:
        return " ".join([function, *(self.text(t, APPLIED - 1) for t in arguments)])

    def _binder(self, tag: str, function: str, rest: tuple[Term, ...]) -> tuple[str, int]:
        match tag, *rest:
            case "diff", 1, place:
                return self._applied(f"Derive {function}", place), APPLIED
            case "diff", order, place:
                return self._applied(f"Derive_n {function}", order, place), APPLIED
            case ("mean",):
                return f"RInt {function} 0 (2 * PI) / (2 * PI)", TIMES
            case "integral", low, high:
                return self._applied(f"RInt {function}", low, high), APPLIED
            case "diverges", *_:
                raise NotExported("the convergence of an improper integral is not stated in Coq")
        raise NotExported(f"the binder {tag}")

    def _formula(self, formula: Node) -> tuple[str, int]:
        match formula:
            case Relation(tag=sign, terms=(left, right)):
                return f"{self.text(left, PLUS)} {RELATIONS[sign]} {self.text(right, PLUS)}", COMPARED
            case Connective(tag="and" | "or", formulas=(only,)):
                return self._formula(only)
            case Connective(tag="and" | "or" as kind, formulas=parts):
                own, sign, empty = (AND, r" /\ ", "True") if kind == "and" else (OR, r" \/ ", "False")
                return (sign.join(self.text(t, own - 1) for t in parts), own) if parts else (empty, ATOM)
            case Connective(tag="=>", formulas=(first, second)):
                return f"{self.text(first, IMPLIES - 1)} -> {self.text(second, IMPLIES)}", IMPLIES
            case Connective(formulas=(first, second)):
                return f"{self.text(first, IFF - 1)} <-> {self.text(second, IFF - 1)}", IFF
            case Quantified(tag=kind, bound=bound, body=body):
                return f"{kind} {' '.join(map(name, bound))} : R, {self.text(body)}", BINDS
        raise AssertionError(formula)


def reason(term: Term) -> str:
    """Why a term has no form in Coq."""
    match term:
        case End():
            return "an integral without an end needs Euler's beta function, which the libraries have not"
        case Value(tag="gamma"):
            return "Euler's gamma function is not in Coq's libraries"
        case Call():
            return "a derivative of an unknown function is not stated in Coq"
    return f"the term {term!r}"
