"""Whether Claims.v states what is printed: both are read anew, and compared at a point with rational coordinates.

`python -m symcheck.coq.comparison FOLDER`. The checker and Coq share one transcription of the printed formula;
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

from symcheck.audit.context import Context, context_of
from symcheck.audit.judge import Unit, equality_claims, units
from symcheck.audit.obligation import obligation_of
from symcheck.coq.reader import claims
from symcheck.core.claims import for_letter
from symcheck.core.ids import Id
from symcheck.core.terms import Binder, Call, Connective, Formula, Node, Quantified, Relation, Term, Value, node
from symcheck.reading import read

DIGITS, TOLERANCE = 60, mpmath.mpf(10) ** -12
Number = Any  # of mpmath
OPERATIONS: dict[str, Callable[..., Number]] = {
    "pi": lambda: +mpmath.pi, "+": lambda *parts: mpmath.fsum(parts), "*": lambda *parts: mpmath.fprod(parts),
    "-": lambda part: -part, "/": lambda top, bottom: top / bottom, "^": lambda base, n: base ** int(n),
    "pow": lambda base, exponent: base**exponent, "arctan": mpmath.atan, "arcsin": mpmath.asin, "arccos": mpmath.acos,
    **{name: getattr(mpmath, name) for name in ("sin", "cos", "tan", "sqrt", "exp", "log")},
}  # fmt: skip


class Point:
    """The values of terms at one point: a random rational number for each letter, the same in all statements."""

    def __init__(self, unfold: Mapping[str, Term]) -> None:
        self.unfold = unfold
        self.known: dict[str, Number] = {}

    def value(self, term: Term, at: Mapping[str, Number]) -> Number:
        """The number that a term stands for where some letters have other values than usual."""
        match term:
            case int():
                return mpmath.mpf(term)
            case str():
                return self.letter(term, at)
            case Binder(tag=tag, body=body, letter=x, outside=rest):
                return self.bound(tag, lambda value: self.value(body, {**at, x: value}), *rest, at=at)
            case Call(function=function, orders=orders, terms=arguments) if not any(orders):
                # some function, the same in all statements
                values = [self.value(each, at) for each in arguments]
                weights = [_number(f"{function} {k}") for k in range(len(values))]
                return mpmath.sin(_number(f"{function} at 0") + mpmath.fdot(weights, values))
            case Value(tag=tag, terms=parts):
                return OPERATIONS[tag](*(self.value(part, at) for part in parts))
        raise KeyError(str(term))

    def bound(self, tag: str, body: Callable[[Number], Number], *rest: Term, at: Mapping[str, Number]) -> Number:
        """A derivative, an integral or a mean."""
        match tag, *(self.value(each, at) for each in rest):
            case "diff", order, place:
                return mpmath.diff(body, place, int(order))
            case "integral", low, high:
                return mpmath.quad(body, mpmath.linspace(low, high, 9))
            case ("mean",):
                return mpmath.quad(body, mpmath.linspace(0, 2 * mpmath.pi, 9)) / (2 * mpmath.pi)
        raise KeyError(tag)

    def letter(self, x: str, at: Mapping[str, Number]) -> Number:
        if x in at:
            return at[x]
        if x in self.unfold:
            if at:  # the definition may depend on what has another value
                return self.value(self.unfold[x], at)
            if x not in self.known:
                self.known[x] = self.value(self.unfold[x], at)
            return self.known[x]
        return _number(x)

    def shape(self, formula: Node) -> Any:
        """The formula with the difference of both sides in the place of each relation."""
        match formula:
            case Relation(tag=sign, terms=sides):
                left, right = (self.value(side, {}) for side in sides)
                return ("<" + sign[1:], right - left) if sign[0] == ">" else (sign, left - right)
            case Quantified(tag=kind, bound=own, body=body):
                return (kind, sorted(own), self.shape(body))
            case Connective(tag=kind, formulas=parts):
                inner = [self.shape(part) for part in parts]
                if kind not in ("and", "or"):
                    return (kind, inner)
                flat = [each for part in inner for each in (part[1] if part[0] == kind else [part])]
                return flat[0] if len(flat) == 1 else (kind, flat)
        raise KeyError(str(formula))


@cache
def _number(x: str) -> Number:
    rng = random.Random(x)
    return mpmath.mpf(rng.randint(1, 10**4)) / rng.randint(10**3, 10**4)


def same(one: Any, other: Any) -> bool:
    """Whether two shapes agree; an equation may have its sides exchanged."""
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        if len(one) == 2 == len(other) and one[0] == other[0] and one[0] in ("=", "!="):
            return _near(one[1], other[1]) or _near(one[1], -other[1])
        return len(one) == len(other) and all(map(same, one, other))
    return one == other if isinstance(one, str) or isinstance(other, str) else _near(one, other)


def _near(a: Number, b: Number) -> bool:
    return bool(abs(a - b) <= TOLERANCE * (1 + abs(a)))


def printed(id: str, corrected: bool) -> Iterator[tuple[Context, Formula]]:
    """The formulas of a printed relation (or of its correction), read anew, each with what is in force there."""
    asked = Id.parse(id)
    context = context_of(obligation_of(str(asked.declaration)))
    unit = next(unit for unit in units(context) if unit.letter == asked.link)
    context = context.having(letter=unit.letter)
    yield from ((context, formula) for formula in _formulas(context, unit, corrected))


def _formulas(context: Context, unit: Unit, corrected: bool) -> Sequence[Any]:
    erratum = context.item.erratum(unit.letter)
    if corrected and erratum and erratum.corrected:
        return unit.reworded(context, read(erratum.corrected, context.notation)).formulas
    equality = for_letter(context.item.statement.equality, unit.letter)
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


def _faults(context: Context, formula: Formula, premises: Sequence[Formula], conclusion: Formula) -> Iterator[str]:
    mpmath.mp.dps = DIGITS
    table: Mapping[str, Any] = context.table
    at, rest = Point(table), formula
    premises = list(premises)
    while rest.tag == "=>" and premises:  # these premises are part of what is printed
        conclusion = node("=>", premises.pop(), conclusion)
        rest = rest.formulas[1] if isinstance(rest, Connective) else rest
    if not same(at.shape(conclusion), at.shape(formula)):
        yield "the conclusion is not what is printed"
    known = [f for each in context.item.hypotheses for f in context.hypothesis(each)[1]]
    shapes = [at.shape(f) for f in known]
    for premise in premises:
        shape = at.shape(premise)
        left, right = premise.terms if isinstance(premise, Relation) else (0, 1)
        defines = shape[0] == "=" and left in table and _near(shape[1], 0)
        divides = shape[0] == "!=" and right == 0
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
