"""Whether Claims.v states what is printed: both are read anew, and compared at a point with rational coordinates.

`python -m symcheck.coq.comparison FOLDER`. The checker and Coq share one transcription of the printed formula;
this looks for what may have been lost on the way from it to Coq.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from mpmath import mp, mpf

from symcheck.audit import Context, Unit, context_of, equality_claims, obligation_of, units
from symcheck.coq.files import manifest
from symcheck.coq.meaning import Meaning, Number, Smooth, Values
from symcheck.coq.reader import claims
from symcheck.core.claims import for_letter
from symcheck.core.counts import number_of
from symcheck.core.ids import Id
from symcheck.core.terms import Connective, Formula, Node, Quantified, Relation, Term, node
from symcheck.reading import read

TOLERANCE = mpf(10) ** -12
OPERATIONS = {**Meaning.operations,  # of all numbers, as points are drawn whatever the domain of a function
    **{name: getattr(mp, name) for name in ("sqrt", "log")}, "arcsin": mp.asin, "arccos": mp.acos,
    "pow": lambda base, exponent: base**exponent,
}  # fmt: skip


class Point(Meaning):
    """Values of terms at one point: a random rational number for each letter, the same in all statements."""

    operations = OPERATIONS

    def __init__(self, definitions: Mapping[str, Term]) -> None:
        super().__init__(Smooth(Random(0)), definitions)
        self.known: Values = {}

    def value(self, term: Term) -> Number:
        """The number that a term stands for."""
        return self.term(term, self.known)

    def unknown(self, x: str) -> Number:
        return _number(x)

    def shape(self, formula: Node) -> Any:
        """The formula with the difference of both sides in the place of each relation."""
        match formula:
            case Relation(tag=sign, terms=sides):
                left, right = map(self.value, sides)
                return ("<" + sign[1:], right - left) if sign[0] == ">" else (sign, left - right)
            case Quantified(tag=kind, bound=own, body=body):
                return (kind, sorted(own), self.shape(body))
            case Connective(tag=kind, formulas=parts):
                inner = [self.shape(part) for part in parts]
                if kind not in ("and", "or"):
                    return (kind, inner)
                flat = [shape for part in inner for shape in (part[1] if part[0] == kind else [part])]
                return flat[0] if len(flat) == 1 else (kind, flat)
        raise KeyError(str(formula))


@cache
def _number(x: str) -> Number:
    rng = Random(x)
    return mpf(rng.randint(1, 10**4)) / rng.randint(10**3, 10**4)


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
    table: Mapping[str, Any] = context.table
    at, rest = Point(table), formula
    premises = list(premises)
    while rest.tag == "=>" and premises:  # these premises are part of what is printed
        conclusion = node("=>", premises.pop(), conclusion)
        rest = rest.formulas[1] if isinstance(rest, Connective) else rest
    if not same(at.shape(conclusion), at.shape(formula)):
        yield "the conclusion is not what is printed"
    known = [f for hypothesis in context.item.hypotheses for f in context.hypothesis(hypothesis)[1]]
    shapes = [at.shape(f) for f in known]
    for premise in premises:
        shape = at.shape(premise)
        left, right = premise.terms if isinstance(premise, Relation) else (0, 1)
        defines = shape[0] == "=" and left in table and _near(shape[1], 0)
        divides = shape[0] == "!=" and right == 0
        if not (defines or divides or any(same(shape, other) for other in shapes)):
            yield "a premise is neither a hypothesis, nor a definition, nor that a denominator is not zero"


def main(arguments: Sequence[str]) -> int:
    """0 all statements are those printed, 1 some are not."""
    folder = Path(arguments[0])
    faults: list[str] = []
    count = 0
    for paper, entry in manifest(folder).items():
        names = {id: row["claims"] for id, row in entry["claims"].items() if row["claims"]}
        count += sum(map(len, names.values()))
        faults += differences((folder / paper / "Claims.v").read_text(encoding="utf-8"), names)
    print(*faults, f"{number_of(count, 'statement')} read back, {number_of(len(faults), 'fault')}", sep="\n")
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
