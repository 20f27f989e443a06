"""Positive combinations of columns of numbers that are zero, exactly."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

Column = dict[tuple[int, ...], Fraction]  # by monomial


def positive_relation(columns: Sequence[tuple[Column, bool]]) -> dict[int, Fraction] | None:
    """Numbers >= 0, not all zero for the marked columns, with which the sum of the columns is zero; None if none are.

    Exact: the simplex method by Bland's rule, after columns that nothing can cancel are left out.
    """
    open_ = _cancelling({k: column for k, (column, _) in enumerate(columns) if column})
    marked = {k for k in open_ if columns[k][1]}
    free = next((k for k, (column, mark) in enumerate(columns) if mark and not column), None)
    if free is not None:
        return {free: Fraction(1)}
    if not marked:
        return None
    rows = sorted({monomial for k in open_ for monomial in columns[k][0]})
    table = [[columns[k][0].get(row, Fraction(0)) for k in open_] + [Fraction(0)] for row in rows]
    table.append([Fraction(int(k in marked)) for k in open_] + [Fraction(1)])
    solution = _feasible(table)
    return None if solution is None else {open_[j]: value for j, value in solution.items() if value}


def _cancelling(columns: dict[int, Column]) -> list[int]:
    """The columns left when none has a monomial that occurs with one sign only."""
    while True:
        signs: dict[tuple[int, ...], set[bool]] = {}
        for column in columns.values():
            for monomial, value in column.items():
                signs.setdefault(monomial, set()).add(value > 0)
        kept = {k: column for k, column in columns.items() if all(len(signs[m]) == 2 for m in column)}
        if len(kept) == len(columns):
            return list(kept)
        columns = kept


def _feasible(table: list[list[Fraction]]) -> dict[int, Fraction] | None:
    """x >= 0 with A x = b for rows (A | b), b >= 0, by minimising the sum of one slack for each row."""
    width = len(table[0]) - 1
    basis = [width + k for k in range(len(table))]  # the slacks, which never come back
    cost = [sum(column, Fraction(0)) for column in zip(*table, strict=True)]
    while cost[-1]:
        enters = next((j for j in range(width) if cost[j] > 0), None)
        if enters is None:
            return None
        ratios = [(row[-1] / row[enters], basis[i], i) for i, row in enumerate(table) if row[enters] > 0]
        _, _, leaves = min(ratios)
        pivot = table[leaves] = [value / table[leaves][enters] for value in table[leaves]]
        basis[leaves] = enters
        for row in (*(row for i, row in enumerate(table) if i != leaves), cost):
            if factor := row[enters]:
                row[:] = [value - factor * p if p else value for value, p in zip(row, pivot, strict=True)]
    return {j: table[i][-1] for i, j in enumerate(basis) if j < width}
