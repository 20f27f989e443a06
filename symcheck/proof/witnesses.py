"""Existence: a witness, and a zero of a function of an angle that changes its sign under a turn by 90 degrees."""

from __future__ import annotations

from collections.abc import Callable

from symcheck.proof.equations import written
from symcheck.proof.ideal import Ideal
from symcheck.proof.knowledge import Knowledge, proportional, ring_of, starting
from symcheck.proof.polynomial import Poly, Ring, flatten, unfold, variables
from symcheck.statement import Certificate, Formula, Problem, Term

ANGLE = "turn"  # the angle of a witness's point (u, v) = (cos turn, sin turn) of the unit circle


def prove_existence(
    problem: Problem, ring: Ring, prove_body: Callable[[Formula, Knowledge], Certificate | None]
) -> Certificate | None:
    """The proof of an "exists" claim from the hinted point, or by a quarter turn if there is none.

    A point may contain two letters of its own, such as u and v: some point (u, v) of the unit circle. A claim about
    such a point itself, "exists c, s: c^2 + s^2 = 1 and ...", is read so too.
    """
    point: dict[str, Term] = {name[6:]: value for name, value in problem.hints if name.startswith("point_")}
    bound, body = problem.claim[1], problem.claim[2]
    if not point and len(bound) == 1:
        return _turn(bound[0], body, starting(problem, ring))
    if not point and len(bound) == 2:
        point = {bound[0]: ("cos", ANGLE), bound[1]: ("sin", ANGLE)}
    if set(point) != set(bound):
        return None
    plain = Problem(problem.id, problem.claim, problem.definitions, problem.hypotheses)
    own = set().union(*(variables(term) for term in point.values())) - set(ring_of(plain).names)
    letters = sorted(name for name in own if name[:4] not in ("sin_", "cos_") and not name.startswith("sqrt_"))
    if len(letters) not in (0, 2):
        return None
    circle: dict[str, Term] = {x: (f, ANGLE) for x, f in zip(letters, ("cos", "sin"), strict=False)}
    point = {name: substitute(term, circle) for name, term in point.items()}
    angles = [ANGLE] if any(ANGLE in str(term) for term in point.values()) else []
    shown = substitute(unfold(body, {n: t for n, t in problem.definitions if n not in point}), point)
    known = starting(problem, Ring({*ring.names, *variables(shown)}, ring.definitions))
    then = _turn(ANGLE, shown, known) if angles else prove_body(shown, known)
    if then is None:
        return None
    return {"rule": "witness", "point": point, **({"angle": angles} if angles else {}), "then": then}


def substitute(node: Formula | Term, values: dict[str, Term]) -> Formula:
    """The term or formula with variables replaced by terms."""
    if isinstance(node, str):
        return values.get(node, node)  # type: ignore[return-value]
    if not isinstance(node, tuple):
        return node  # type: ignore[return-value]
    return (node[0], *(substitute(child, values) for child in node[1:]))


def _turn(angle: str, body: Formula, known: Knowledge) -> Certificate | None:
    """P(-s, c) = -P(c, s) modulo what is known; every other equation is a multiple of P there."""
    ring, equations = known.ring, flatten(body)
    if any(f[0] != "=" for f in equations) or f"cos_{angle}" not in ring.generator:
        return None
    polys, ideal = [ring.difference(f) for f in equations], known.ideal()
    c, s = f"cos_{angle}", f"sin_{angle}"
    moved = {c: -ring.generator[s], s: ring.generator[c]}
    for index, leading in enumerate(polys):
        turned = leading.compose(*(moved.get(n, ring.generator[n]) for n in ring.names), ctx=ring.context)
        cofactors = ideal.cofactors(leading + turned)
        if cofactors is None or ideal.reduce(leading) == 0:
            continue
        others = [_multiple(poly, leading, ideal) for poly in polys]
        if all(other is not None for other in others):
            return {"rule": "quarter_turn", "index": index, "cofactors": written(cofactors), "others": others}
    return None


def _multiple(poly: Poly, leading: Poly, ideal: Ideal) -> list[object] | None:
    """[multiple, cofactors] with poly - multiple * leading in the ideal."""
    factor = proportional(ideal.reduce(poly), ideal.reduce(leading)) or 0
    multiple = ideal.ring.number(factor)
    cofactors = ideal.cofactors(poly - multiple * leading)
    return None if cofactors is None else [str(multiple), written(cofactors)]
