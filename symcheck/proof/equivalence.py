"""Statements beside the one claimed: edited into another form."""

from __future__ import annotations

from dataclasses import replace

from symcheck.proof.knowledge import proportional, ring_of, starting
from symcheck.proof.polynomial import Unsupported, alone
from symcheck.proof.theorems import RELATIONS
from symcheck.statement import Formula, Problem

MIRROR = {"<": ">", "<=": ">="}


def equivalent(f: Formula, g: Formula, problem: Problem) -> bool:
    """Whether two formulas say the same: sides equal modulo the hypotheses, or differences equal up to a constant.

    Decided exactly; False if that cannot be seen (Unsupported terms included).
    """
    both = replace(problem, claim=("and", f, g))
    with alone(both):
        return f == g or _equivalent(f, g, both)


def _equivalent(f: Formula, g: Formula, problem: Problem) -> bool:
    try:
        ring = ring_of(problem)
        ideal = starting(problem, ring).ideal()
    except Unsupported:
        return False

    def same(a: Formula, b: Formula) -> bool:
        if a[0] not in RELATIONS or b[0] not in RELATIONS:
            if a[0] != b[0] or len(a) != len(b):
                return False
            parts = zip(a[2:], b[2:], strict=True) if a[0] == "exists" else zip(a[1:], b[1:], strict=True)
            return (a[0] != "exists" or a[1] == b[1]) and all(same(x, y) for x, y in parts)
        a, b = _larger_first(a), _larger_first(b)
        if a[0] != b[0]:
            return False
        first, second = ring.subtract(*a[1:]), ring.subtract(*b[1:])
        if first.den.keys() != second.den.keys():
            return all(ideal.reduce(ring.subtract(x, y).num) == 0 for x, y in zip(a[1:], b[1:], strict=True))
        p, q = ideal.reduce(first.num), ideal.reduce(second.num)
        if p == q:
            return True
        factor = proportional(p, q)
        return factor is not None and (factor > 0 or a[0] in ("=", "!="))

    try:
        return same(f, g)
    except Unsupported:
        return False


def _larger_first(formula: Formula) -> Formula:
    return (MIRROR[formula[0]], formula[2], formula[1]) if formula[0] in MIRROR else formula
