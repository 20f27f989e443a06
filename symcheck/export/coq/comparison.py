"""Whether Claims.v states what is printed: both are read anew, and compared at a point with rational coordinates.

`python -m symcheck.export.coq.comparison FOLDER`. The checker and Coq share one transcription of the printed formula;
this looks for what may have been lost on the way from it to Coq.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import mpmath

from symcheck.evidence.context import Context, for_letter
from symcheck.evidence.judge import Unit, equality_claims, units
from symcheck.evidence.obligation import obligation_of
from symcheck.export.coq.reader import claims
from symcheck.proof.theorems import RELATIONS
from symcheck.reading import read
from symcheck.statement import Formula, Role

DIGITS, TOLERANCE = 60, mpmath.mpf(10) ** -12
CALLS = {"arctan": "atan", "arcsin": "asin", "arccos": "acos"}


class Point:
    """The values of terms at one point: a random rational number for each letter, the same in all statements."""

    def __init__(self, unfold: Mapping[str, Any]) -> None:
        self.unfold = unfold
        self.known: dict[str, Any] = {}

    def value(self, term: Any, at: Mapping[str, Any]) -> Any:
        """The number that a term stands for where some letters have other values than usual."""
        match term:
            case int():
                return mpmath.mpf(term)
            case "pi":
                return mpmath.pi
            case str():
                return self.letter(term, at)
            case ("+", *parts):
                return mpmath.fsum(self.value(part, at) for part in parts)
            case ("*", *parts):
                return mpmath.fprod(self.value(part, at) for part in parts)
            case ("-", inner):
                return -self.value(inner, at)
            case ("/", top, bottom):
                return self.value(top, at) / self.value(bottom, at)
            case ("^", base, n):
                return self.value(base, at) ** n
            case ("pow", base, exponent):
                return self.value(base, at) ** self.value(exponent, at)
            case ("diff", (x, body), place, n):
                return mpmath.diff(self.along(body, x, at), self.value(place, at), n)
            case ("diff", body, x, n):
                return mpmath.diff(self.along(body, x, at), self.letter(x, at), n)
            case ("integral", (x, body), low, high):
                return mpmath.quad(
                    self.along(body, x, at), mpmath.linspace(self.value(low, at), self.value(high, at), 9)
                )
            case ("integral", body, x, low, high):
                return self.value(("integral", (x, body), low, high), at)
            case ("mean", body, x):
                return mpmath.quad(self.along(body, x, at), mpmath.linspace(0, 2 * mpmath.pi, 9)) / (2 * mpmath.pi)
            case ("call", function, orders, *arguments) if not any(orders):  # some function, the same in all statements
                values = [self.value(each, at) for each in arguments]
                weights = [_number(f"{function} {k}") for k in range(len(values))]
                return mpmath.sin(_number(f"{function} at 0") + mpmath.fdot(weights, values))
            case (function, inner):
                return getattr(mpmath, CALLS.get(function, function))(self.value(inner, at))
        raise KeyError(str(term))

    def along(self, body: Any, x: str, at: Mapping[str, Any]) -> Callable[[Any], Any]:
        return lambda value: self.value(body, {**at, x: value})

    def letter(self, x: str, at: Mapping[str, Any]) -> Any:
        if x in at:
            return at[x]
        if x in self.unfold:
            if at:  # the definition may depend on what has another value
                return self.value(self.unfold[x], at)
            if x not in self.known:
                self.known[x] = self.value(self.unfold[x], at)
            return self.known[x]
        return _number(x)

    def shape(self, formula: Any) -> Any:
        """The formula with the difference of both sides in the place of each relation."""
        kind, *parts = formula
        if kind in RELATIONS:
            left, right = (self.value(part, {}) for part in parts)
            return ("<" + kind[1:], right - left) if kind[0] == ">" else (kind, left - right)
        if kind == "exists":
            return (kind, sorted(parts[0]), self.shape(parts[1]))
        inner = [self.shape(part) for part in parts]
        if kind in ("and", "or"):
            flat = [each for part in inner for each in (part[1] if part[0] == kind else [part])]
            return flat[0] if len(flat) == 1 else (kind, flat)
        return (kind, inner)


@cache
def _number(x: str) -> Any:
    rng = random.Random(x)
    return mpmath.mpf(rng.randint(1, 10**4)) / rng.randint(10**3, 10**4)


def same(one: Any, other: Any) -> bool:
    """Whether two shapes agree; an equation may have its sides exchanged."""
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        if len(one) == 2 == len(other) and one[0] == other[0] and one[0] in ("=", "!="):
            return _near(one[1], other[1]) or _near(one[1], -other[1])
        return len(one) == len(other) and all(map(same, one, other))
    return one == other if isinstance(one, str) or isinstance(other, str) else _near(one, other)


def _near(a: Any, b: Any) -> bool:
    return bool(abs(a - b) <= TOLERANCE * (1 + abs(a)))


def printed(id: str, corrected: bool) -> Iterator[tuple[Context, Formula]]:
    """The formulas of a printed relation (or of its correction), read anew, each with what is in force there."""
    declared = id if _is_declared(id) else id[:-1]
    obligation = obligation_of(declared)
    context = Context(obligation.paper, obligation.item)
    unit = next(unit for unit in units(context) if unit.letter == id[len(declared) :])
    context = context.having(letter=unit.letter)
    for formula in _formulas(context, unit, corrected):
        yield context, formula


def _is_declared(id: str) -> bool:
    try:
        return obligation_of(id).item.role in (Role.CLAIM, Role.OURS)
    except Exception:
        return False


def _formulas(context: Context, unit: Unit, corrected: bool) -> Sequence[Formula]:
    erratum = context.item.errata.get(unit.letter)
    if corrected and erratum and erratum.corrected:
        return unit.reworded(context, read(erratum.corrected, context.notation)).formulas
    equality = for_letter(context.item.equality, unit.letter)
    return (*unit.formulas, *(equality_claims(context, unit, equality) if equality else ()))


def differences(text: str, names: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """One line for each statement of a Claims.v that is not what is printed; `names` by the id of the relation."""
    stated = claims(text)
    for id, own in names.items():
        number, _, corrected = id.partition(", ")
        formulas = list(printed(number, bool(corrected)))
        for name in own:
            part = int(name.rpartition("_part")[2]) - 1 if "_part" in name else 0
            context, formula = formulas[part]
            yield from (f"{name}: {fault}" for fault in _faults(context, formula, *stated[name][1:]))


def _faults(context: Context, formula: Formula, premises: Sequence[Any], conclusion: Any) -> Iterator[str]:
    mpmath.mp.dps = DIGITS
    at, rest = Point(context.table), formula
    premises = list(premises)
    while rest[0] == "=>" and premises:  # these premises are part of what is printed
        conclusion, rest = ("=>", premises.pop(), conclusion), rest[2]
    if not same(at.shape(conclusion), at.shape(formula)):
        yield "the conclusion is not what is printed"
    item = context.item
    known = [f for each in (*item.given, *item.needs, *item.equality_given) for f in context.hypothesis(each)[1]]
    shapes = [at.shape(f) for f in known]
    for premise in premises:
        shape = at.shape(premise)
        defines = shape[0] == "=" and premise[1] in context.table and _near(shape[1], 0)
        divides = shape[0] == "!=" and premise[2] == 0
        if not (defines or divides or any(same(shape, each) for each in shapes)):
            yield "a premise is neither a hypothesis, nor a definition, nor that a denominator is not zero"


def main(arguments: Sequence[str]) -> int:
    """0 all statements are those printed, 1 some are not."""
    import json

    folder = Path(arguments[0])
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    faults: list[str] = []
    count = 0
    for paper, entry in manifest.items():
        names = {id: row["claims"] for id, row in entry["claims"].items() if row["claims"]}
        count += sum(map(len, names.values()))
        faults += differences((folder / paper / "Claims.v").read_text(encoding="utf-8"), names)
    print(*faults, f"{count} statements read back, {len(faults)} faults", sep="\n")
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
