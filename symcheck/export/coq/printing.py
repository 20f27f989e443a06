"""Terms and formulas as Coq reads them, with the standard library's names and as few brackets as it needs."""

from __future__ import annotations

from typing import Any

from symcheck.export.coq.terms import NotExported

RELATIONS = {"=": "=", "!=": "<>", "<": "<", "<=": "<=", ">": ">", ">=": ">="}
CALLS = {
    "sin": "sin", "cos": "cos", "tan": "tan", "sqrt": "sqrt", "exp": "exp", "log": "ln",
    "arctan": "atan", "arcsin": "asin", "arccos": "acos", "pow": "Rpower", "powerRZ": "powerRZ", "IZR": "IZR",
}  # fmt: skip
TAKEN = frozenset(
    [
        "as",
        "at",
        "cofix",
        "do",
        "else",
        "end",
        "exists",
        "exists2",
        "fix",
        "for",
        "forall",
        "fun",
        "if",
        "in",
        "let",
        "match",
        "mod",
        "return",
        "then",
        "using",
        "where",
        "with",
        "by",
        "Prop",
        "Set",
        "Type",
        "SProp",
        "R",
        "Z",
        "N",
        "nat",
        "IZR",
        "INR",
        "PI",
        "sin",
        "cos",
        "tan",
        "sqrt",
        "exp",
        "ln",
        "atan",
        "asin",
        "acos",
        "Rpower",
        "RInt",
        "Derive",
        "Derive_n",
        "pow",
        "True",
        "False",
        "not",
        "and",
        "or",
    ]
)
ATOM, APPLIED, POWER, MINUS, TIMES, PLUS, COMPARED, AND, OR, IFF, IMPLIES, BINDS = (
    0,
    10,
    30,
    35,
    40,
    50,
    70,
    80,
    85,
    95,
    99,
    200,
)


def name(letter: str) -> str:
    """A letter as an identifier of Coq."""
    return f"{letter}'" if letter in TAKEN else letter


def printed(node: Any, level: int = BINDS) -> str:
    """A term or formula, in brackets if it binds more loosely than the level."""
    text, own = _printed(node)
    return text if own <= level else f"({text})"


def spelled(node: Any, level: int = BINDS) -> str:
    """The same with a - b spelled a + - b, as terms stand in Coq once `Rminus` is unfolded."""
    return printed(_without_minus(node), level)


def _without_minus(node: Any) -> Any:
    if not isinstance(node, list):
        return node
    parts = [_without_minus(part) for part in node]
    if parts[:1] == ["+"]:
        return [
            "+",
            parts[1],
            *(["minus", part[1]] if isinstance(part, list) and part[0] == "-" else part for part in parts[2:]),
        ]
    return parts


def _printed(node: Any) -> tuple[str, int]:
    match node:
        case bool():
            raise NotExported(f"the term {node!r}")
        case int():
            return (str(node), ATOM) if node >= 0 else (f"- {-node}", MINUS)
        case "pi":
            return "PI", ATOM
        case "infinity":
            raise NotExported("an integral without an end needs Euler's beta function, which the libraries have not")
        case str():
            return name(node), ATOM
        case ["+", first, *rest]:
            return _sum(first, rest), PLUS
        case ["-" | "minus", inner]:
            return f"- {printed(inner, POWER)}", MINUS
        case ["*", first, *rest]:
            return " * ".join([printed(first, TIMES), *(printed(t, TIMES - 1) for t in rest)]), TIMES
        case ["/", top, bottom]:
            return f"{printed(top, TIMES)} / {printed(bottom, TIMES - 1)}", TIMES
        case ["^", base, int(n)]:
            power = f"{printed(base, APPLIED)} ^ {abs(n)}"
            return (power, POWER) if n >= 0 else (f"/ {power}", MINUS)
        case ["diff", body, x, 1]:
            return f"Derive (fun {name(x)} => {printed(body)}) {name(x)}", APPLIED
        case ["diff", body, x, int(n)]:
            return f"Derive_n (fun {name(x)} => {printed(body)}) {n} {name(x)}", APPLIED
        case ["mean", body, x]:
            return f"RInt (fun {name(x)} => {printed(body)}) 0 (2 * PI) / (2 * PI)", TIMES
        case ["integral", body, x, low, high]:
            return f"RInt (fun {name(x)} => {printed(body)}) {printed(low, ATOM)} {printed(high, ATOM)}", APPLIED
        case ["diverges", *_]:
            raise NotExported("the convergence of an improper integral is not stated in Coq")
        case ["gamma", _]:
            raise NotExported("Euler's gamma function is not in Coq's libraries")
        case [function, *arguments] if function in CALLS:
            return " ".join([CALLS[function], *(printed(t, APPLIED - 1) for t in arguments)]), APPLIED
        case [sign, left, right] if sign in RELATIONS:
            return f"{printed(left, PLUS)} {RELATIONS[sign]} {printed(right, PLUS)}", COMPARED
        case ["and" | "or", only]:
            return _printed(only)
        case ["and" | "or" as kind, *parts]:
            own, sign, empty = (AND, r" /\ ", "True") if kind == "and" else (OR, r" \/ ", "False")
            shown = [*(printed(t, own - 1) for t in parts[:-1]), *(printed(t, own - 1) for t in parts[-1:])]
            return (sign.join(shown), own) if parts else (empty, ATOM)
        case ["=>", first, second]:
            return f"{printed(first, IMPLIES - 1)} -> {printed(second, IMPLIES)}", IMPLIES
        case ["<=>", first, second]:
            return f"{printed(first, IFF - 1)} <-> {printed(second, IFF - 1)}", IFF
        case ["exists" | "forall" as kind, bound, body]:
            return f"{kind} {' '.join(map(name, bound))} : R, {printed(body)}", BINDS
        case ["call", function, orders, *arguments]:
            if any(orders):
                raise NotExported("a derivative of an unknown function is not stated in Coq")
            return " ".join([name(function), *(printed(t, APPLIED - 1) for t in arguments)]), APPLIED
    raise NotExported(f"the term {node!r}")


def _sum(first: Any, rest: list[Any]) -> str:
    shown = [printed(first, PLUS)]
    for term in rest:
        match term:
            case ["-", inner]:
                shown.append(f"- {printed(inner, PLUS - 1)}")
            case _:
                shown.append(f"+ {printed(term, PLUS - 1)}")
    return " ".join(shown)
