"""Whether a statement is one of the term language, before anything is looked for."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from symcheck.proof.theorems import BINDING, CONSTANTS, OPAQUE, RELATIONS
from symcheck.proof.variables import Unsupported
from symcheck.statement import Problem, Term

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
MAX_DEPTH = 200
_SIZES: dict[str, range] = {
    **dict.fromkeys(("-", "sin", "cos", "tan", *OPAQUE), range(1, 2)),
    **dict.fromkeys(("/", "^", "pow", "mean"), range(2, 3)),
    **dict.fromkeys(("+", "*"), range(1, 100_000)),
    "diff": range(3, 4),
    "integral": range(4, 5),
    "diverges": range(4, 5),
    "call": range(3, 100),
}


def check_terms(problem: Problem) -> None:
    """Unsupported, with the reason, unless the claim, hypotheses, definitions and hints are terms and formulas."""
    for name, term in problem.definitions:
        _letter(name)
        _term(term)
    for formula in (problem.claim, *(f for _, formulas in problem.hypotheses for f in formulas)):
        _formula(formula)


def _require(condition: bool, what: str) -> None:
    if not condition:
        raise Unsupported(what)


def _letter(name: Any) -> None:
    proper = isinstance(name, str) and NAME.fullmatch(name) is not None and name not in CONSTANTS
    _require(proper, f"{name!r} is no name of a letter")


def _formula(formula: Any, depth: int = 0) -> None:
    _require(isinstance(formula, tuple) and formula != () and depth < MAX_DEPTH, f"{formula!r:.80} is no statement")
    kind, *parts = formula
    if kind in RELATIONS:
        _require(len(parts) == 2, f"a relation of {len(parts)} sides")
        for side in parts:
            _term(side, depth + 1)
        return
    if kind == "exists":
        _require(len(parts) == 2 and isinstance(parts[0], tuple) and parts[0] != (), "a quantifier without letters")
        for x in parts[0]:
            _letter(x)
        _formula(parts[1], depth + 1)
        return
    _require(kind in ("and", "or") or (kind in ("=>", "<=>") and len(parts) == 2), f"{kind!r} is no connective")
    for part in parts:
        _formula(part, depth + 1)


def _term(term: Any, depth: int = 0, end: bool = False) -> None:
    """`end` for the end of an interval, which alone may be infinite."""
    if type(term) is int:
        return
    if isinstance(term, str):
        _require(term == "pi" or (end and term == "infinity") or _is_letter(term), f"{term!r} is no number")
        return
    _require(isinstance(term, tuple) and term != () and depth < MAX_DEPTH, f"{term!r:.80} is no term")
    kind, *parts = term
    sizes = _SIZES.get(kind, ()) if isinstance(kind, str) else ()
    _require(len(parts) in sizes, f"the term {kind!r} of {len(parts)} parts is not known")
    if kind in _SHAPES:
        parts = _SHAPES[kind](*parts)
    infinite = kind in ("integral", "diverges")
    for k, part in enumerate(parts):
        _term(part, depth + 1, (infinite and k > 0) or (end and kind == "-"))


def _is_letter(name: str) -> bool:
    return name not in CONSTANTS and NAME.fullmatch(name) is not None


def _power(base: Term, exponent: Any) -> list[Term]:
    _require(type(exponent) is int, f"the exponent {exponent!r:.40} of a whole power")
    return [base]


def _derivative(inner: Term, x: Any, order: Any) -> list[Term]:
    _letter(x)
    _require(type(order) is int and 1 <= order <= 8, f"a derivative of the order {order!r:.40}")
    return [inner]


def _bound(body: Term, x: Any, *ends: Term) -> list[Term]:
    _letter(x)
    return [body, *ends]


def _call(function: Any, orders: Any, *arguments: Term) -> list[Term]:
    _letter(function)
    whole = isinstance(orders, tuple) and all(type(n) is int and 0 <= n < 99 for n in orders)
    _require(whole and len(orders) == len(arguments) > 0, f"the orders {orders!r:.40} of {function}")
    return [*arguments]


_SHAPES: dict[str, Callable[..., list[Term]]] = {
    "^": _power,
    "diff": _derivative,
    **dict.fromkeys(BINDING, _bound),
    "call": _call,
}
