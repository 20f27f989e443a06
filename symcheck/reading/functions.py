"""The functions that print knows by name, each with the terms it is made of."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce

from symcheck.core.terms import PI, Term, node

Build = Callable[[Term], Term]


def _known(name: str) -> Build:
    return lambda t: node(name, t)


def _half(sign: int) -> Build:
    """Half the sum, or the difference, of exp t and exp -t."""

    def built(t: Term) -> Term:
        back = node("exp", node("-", t))
        return node("/", node("+", node("exp", t), back if sign > 0 else node("-", back)), 2)

    return built


def _over(top: Build | None, bottom: Build) -> Build:
    return lambda t: node("/", top(t) if top else 1, bottom(t))


def _logarithm_of(inner: Build) -> Build:
    return lambda t: node("log", inner(t))


def _shifted_root(shift: int) -> Build:
    """t + sqrt(t**2 + shift)."""
    return lambda t: node("+", t, node("sqrt", node("+", node("^", t, 2), shift)))


def _error_function(t: Term) -> Term:
    bell = node("exp", node("-", node("^", "t", 2)))
    return node("*", node("/", 2, node("sqrt", PI)), node("integral", bell, "t", 0, t))


def extreme(name: str, terms: Sequence[Term]) -> Term:
    """The "max" or "min" of numbers: half the sum of two and their distance, or the negative of it."""

    def of_two(a: Term, b: Term) -> Term:
        gap = node("sqrt", node("^", node("+", a, node("-", b)), 2))
        return node("/", node("+", a, b, gap if name == "max" else node("-", gap)), 2)

    return reduce(of_two, terms)


_SIN, _COS, _SINH, _COSH = _known("sin"), _known("cos"), _half(-1), _half(1)
REAL: dict[str, Build] = {
    "sin": _SIN, "cos": _COS, "tan": _known("tan"), "cot": _over(_COS, _SIN),
    "sec": _over(None, _COS), "csc": _over(None, _SIN),
    "arcsin": _known("arcsin"), "arccos": _known("arccos"), "arctan": _known("arctan"),
    "sinh": _SINH, "cosh": _COSH, "tanh": _over(_SINH, _COSH), "coth": _over(_COSH, _SINH),
    "sech": _over(None, _COSH), "csch": _over(None, _SINH),
    "arsinh": _logarithm_of(_shifted_root(1)), "arcosh": _logarithm_of(_shifted_root(-1)),
    "artanh": lambda t: node("/", node("log", node("/", node("+", 1, t), node("+", 1, node("-", t)))), 2),
    "arcoth": lambda t: node("/", node("log", node("/", node("+", t, 1), node("+", t, -1))), 2),
    "arsech": lambda t: _logarithm_of(_shifted_root(-1))(node("/", 1, t)),
    "arcsch": lambda t: _logarithm_of(_shifted_root(1))(node("/", 1, t)),
    "exp": _known("exp"), "ln": _known("log"), "lg": lambda t: node("/", node("log", t), node("log", 10)),
    "lb": lambda t: node("/", node("log", t), node("log", 2)), "Gamma": _known("gamma"),
    "erf": _error_function, "erfc": lambda t: node("+", 1, node("-", _error_function(t))),
}  # fmt: skip
SPELLED = {  # other names of the same functions
    "tg": "tan", "ctg": "cot", "cotan": "cot", "cosec": "csc", "arctg": "arctan", "asin": "arcsin", "acos": "arccos",
    "atan": "arctan", "sh": "sinh", "ch": "cosh", "th": "tanh", "cth": "coth", "arcsinh": "arsinh", "asinh": "arsinh",
    "arccosh": "arcosh", "acosh": "arcosh", "arctanh": "artanh", "atanh": "artanh", "arsh": "arsinh", "arch": "arcosh",
    "arth": "artanh", "arccoth": "arcoth", "acoth": "arcoth", "arcsech": "arsech",
    "arccsch": "arcsch", "arctan2": "atan2",
}  # fmt: skip
INVERSES = {"sin": "arcsin", "cos": "arccos", "tan": "arctan", "sinh": "arsinh", "cosh": "arcosh", "tanh": "artanh"}
OF_MATRICES = ("det", "tr", "Tr", "vec", "Re", "Im", "rank", "sign", "max", "min", "log")
FIELDS = ("grad", "div", "curl", "rot", "laplacian", "derivative")  # operators on fields, which take one factor
OPAQUE = (  # that are read and have no algebraic form
    "arg", "Arg", "Pr", "Var", "Cov", "var", "cov", "dim", "deg",
    "gcd", "ker", "adj", "span", "sgn", "floor", "ceil", "sn", "cn", "dn", "am",
    "atan2", "arctan2",
    *FIELDS, "average", "overlined",
)  # fmt: skip
NAMES = frozenset(REAL) | frozenset(SPELLED) | frozenset(OF_MATRICES) | frozenset(OPAQUE)


def applied(name: str, t: Term) -> Term | None:
    """The term that a function of this name is at t; None if it has no algebraic form."""
    built = REAL.get(SPELLED.get(name, name))
    return built(t) if built else None


COMMANDS = NAMES & {  # those that TeX has a command for
    "sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "coth", "exp", "ln",
    "log", "lg", "det", "max", "min", "Gamma",
}  # fmt: skip
