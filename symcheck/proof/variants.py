"""Statements beside the one claimed: with a hypothesis left out, or edited into another form."""

from __future__ import annotations

from dataclasses import replace

from symcheck.proof.counterexample import refute
from symcheck.proof.knowledge import proportional, ring_of, starting
from symcheck.proof.polynomial import RELATIONS, Unsupported
from symcheck.statement import Certificate, Formula, Method, Problem, Verdict

Need = tuple[bool | None, Certificate | None]
MIRROR = {"<": ">", "<=": ">="}


def needed(problem: Problem, method: Method) -> dict[str, Need]:
    """For each hypothesis whether the claim needs it: left out, is the claim refuted, or still proved?

    (True, point) if it is refuted then, (False, None) if it is proved, (None, None) if neither is found.
    """
    found: dict[str, Need] = {}
    for name, _ in problem.hypotheses:
        without = replace(problem, hypotheses=tuple(item for item in problem.hypotheses if item[0] != name))
        point = refute(without)  # most hypotheses are needed, and a point is found faster than that there is no proof
        proved = point is None and method.decide(without).verdict is Verdict.PROVED
        found[name] = (True, point) if point else (False if proved else None, None)
    return found


def equivalent(f: Formula, g: Formula, problem: Problem) -> bool:
    """Whether two formulas say the same: sides equal modulo the hypotheses, or differences equal up to a constant.

    Decided exactly; False if that cannot be seen (Unsupported terms included).
    """
    if f == g:
        return True
    try:
        ring = ring_of(replace(problem, claim=("and", f, g)))
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
