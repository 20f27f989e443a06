"""Whether two formulas say the same: the question about a relation that was edited."""

from __future__ import annotations

from dataclasses import replace

from symcheck.core.problems import Problem
from symcheck.core.terms import RELATIONS, Formula, Quantified, node
from symcheck.proof.algebra.knowledge import larger_first, proportional, ring_of, starting
from symcheck.proof.algebra.polynomial import Unsupported, alone


def equivalent(f: Formula, g: Formula, problem: Problem) -> bool:
    """Tell whether two formulas say the same under some hypotheses.

    Parameters
    ----------
    f, g
        The formulas.
    problem
        Hypotheses and definitions in force.

    Returns
    -------
    bool
        True if both sides are equal modulo the hypotheses, or the differences of the sides up to a constant; False
        also if that cannot be seen.
    """
    both = replace(problem, claim=node("and", f, g))
    with alone(both):
        return f == g or _equivalent(f, g, both)


def _equivalent(f: Formula, g: Formula, problem: Problem) -> bool:
    try:
        ring = ring_of(problem)
        ideal = starting(problem, ring).ideal()
    except Unsupported:
        return False

    def same(a: Formula, b: Formula) -> bool:
        if a.tag not in RELATIONS or b.tag not in RELATIONS:
            if isinstance(a, Quantified) and isinstance(b, Quantified):
                return a.tag == b.tag and a.bound == b.bound and same(a.body, b.body)
            same_shape = a.tag == b.tag and len(a.formulas) == len(b.formulas) > 0
            return same_shape and all(map(same, a.formulas, b.formulas))
        a, b = larger_first(a), larger_first(b)
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
