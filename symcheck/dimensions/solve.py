"""The equations of dimensions solved over the rationals, exactly, with the combination that shows a conflict."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations
from types import MappingProxyType

from symcheck.dimensions.rules import Atom, Equation, Linear, Rational, added, is_base, ratio, scaled

FEW = 24  # equations among which a smallest conflict is looked for by trying
Combination = Mapping[int, Rational]
NONE: Combination = MappingProxyType({})


class System:
    """Equations in triangular form; each pivot is an atom that they express by others."""

    def __init__(self) -> None:
        self.pivots: dict[Atom, tuple[Linear, Combination]] = {}

    def reduced(self, form: Linear, combination: Combination = NONE) -> tuple[Linear, Combination]:
        """A form without pivots, and the combination of equations that was added to it."""
        while pivot := next((atom for atom in form if atom in self.pivots), None):
            row, made = self.pivots[pivot]
            factor = -form[pivot]
            form, combination = added(form, row, factor), added(combination, made, factor)
        return form, combination

    def add(self, number: int, form: Linear) -> Combination | None:
        """Add an equation; the combination that leaves base quantities alone if it contradicts the others."""
        form, combination = self.reduced(form, {number: 1})
        unknown = [atom for atom in form if not is_base(atom)]
        if not unknown:
            return combination if form else None
        pivot = min(unknown, key=_order)
        factor = ratio(1, form[pivot])
        self.pivots[pivot] = scaled(form, factor), scaled(combination, factor)
        return None

    def left(self) -> list[Linear]:
        """Each equation with the pivots that can be replaced replaced: what it still says of atoms."""
        return [added({pivot: 1}, self.reduced(_rest(row, pivot))[0]) for pivot, (row, _) in self.pivots.items()]

    def value(self, form: Linear) -> Linear:
        """What a form is by the equations."""
        return self.reduced(form)[0]


def _rest(row: Linear, pivot: Atom) -> Linear:
    return {atom: n for atom, n in row.items() if atom != pivot}


def is_letter(atom: Atom) -> bool:
    """Is it a printed letter?"""
    return isinstance(atom, str) and atom.isidentifier()


def _order(atom: Atom) -> tuple[int, str]:
    """What is expressed by others first: what nobody can declare; powers of known quantities last."""
    if isinstance(atom, tuple):
        return (3 if is_base(atom[1]) else 0), str(atom)
    return (2 if is_letter(atom) else 1), atom


def solved(equations: Sequence[Equation], wanted: Iterable[int]) -> tuple[System, Combination | None]:
    """The system of some equations, up to the first that contradicts those before it, and how it does."""
    system = System()
    for number in wanted:
        if (conflict := system.add(number, equations[number].form)) is not None:
            return system, conflict
    return system, None


def smallest(equations: Sequence[Equation], conflict: Combination, among: Sequence[int]) -> Combination:
    """A combination of as few equations as can be found, of those that are given."""
    for number in among:
        if all(map(is_base, equations[number].form)):
            return {number: 1}
    if len(among) <= FEW:
        for size in range(2, min(len(conflict), 4)):
            for some in combinations(among, size):
                if (found := solved(equations, some)[1]) is not None:
                    return found
    for number in sorted(conflict):
        fewer = [each for each in sorted(conflict) if each != number]
        if (found := solved(equations, fewer)[1]) is not None:
            conflict = found
    return conflict
