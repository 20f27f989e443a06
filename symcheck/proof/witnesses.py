"""Existence: a witness, and a zero of a function on a circle that changes its sign under a turn by 90 degrees."""

from __future__ import annotations

from symcheck.proof.equations import written
from symcheck.proof.ideal import Fact, Ideal
from symcheck.proof.knowledge import Knowledge, proportional, ring_of, starting
from symcheck.proof.polynomial import Poly, Ring, flatten, unfold, variables
from symcheck.statement import Certificate, Formula, Problem, Term


def prove_existence(problem: Problem, ring: Ring) -> Certificate | None:
    """The proof of an "exists" claim from the hinted point, if any, or by a quarter turn."""
    point = {name[6:]: value for name, value in problem.hints if name.startswith("point_")}
    known = starting(problem, ring)
    if not point:
        return _turn(problem.claim, known)
    if set(point) != set(problem.claim[1]):
        return None
    body = substitute(unfold(problem.claim[2], dict(problem.definitions)), point)
    fresh = sorted(set().union(*(_names(t) for t in point.values())) - set(ring_of_claim(problem).names))
    if fresh:
        circle = ("=", ("+", *(("^", name, 2) for name in fresh)), 1)
        then = _turn(("exists", tuple(fresh), ("and", circle, body)), known) if len(fresh) == 2 else None
    else:
        then = _all_of(body, known)
    if then is None:
        return None
    return {"rule": "witness", "point": point, **({"fresh": fresh} if fresh else {}), "then": then}


def ring_of_claim(problem: Problem) -> Ring:
    """The ring of the problem without its hints."""
    return ring_of(Problem(problem.id, problem.claim, problem.definitions, problem.hypotheses))


def _names(term: Term) -> set[str]:
    return {name for name in variables(term) if not name.startswith("sqrt_")}


def substitute(node: Formula, values: dict[str, Term]) -> Formula:
    """The formula with variables replaced by terms."""
    if isinstance(node, str):
        return values.get(node, node)
    if not isinstance(node, tuple):
        return node
    return (node[0], *(substitute(child, values) for child in node[1:]))


def _all_of(body: Formula, known: Knowledge) -> Certificate | None:
    from symcheck.proof.splitting import prove_here

    return prove_here(body, known)


def _turn(goal: Formula, known: Knowledge) -> Certificate | None:
    """P(-s, c) = -P(c, s) modulo what is known and the circle; every other equation is a multiple of P there."""
    equations = flatten(goal[2])
    if any(f[0] != "=" for f in equations):
        return None
    ring = known.ring
    bound = tuple(goal[1])
    pairs = [(f"cos_{bound[0]}", f"sin_{bound[0]}")] if len(bound) == 1 else [bound, bound[::-1]]
    for c, s in pairs:
        if len(bound) > 2 or c not in ring.generator or s not in ring.generator:
            continue
        if (proof := _turn_with(c, s, [ring.difference(f) for f in equations], known)) is not None:
            return proof
    return None


def _turn_with(c: str, s: str, equations: list[Poly], known: Knowledge) -> Certificate | None:
    ring = known.ring
    x, y = ring.generator[c], ring.generator[s]
    circle: Fact = (["fact", 0], x**2 + y**2 - 1)
    axioms = [axiom for axiom in ring.axioms() if proportional(axiom[1], circle[1]) is None]
    ideal = Ideal(ring, [circle, *axioms, *known.facts])
    for index, leading in enumerate(equations):
        moved = {c: -y, s: x}
        turned = leading.compose(*(moved.get(n, ring.generator[n]) for n in ring.names), ctx=ring.context)
        cofactors = ideal.cofactors(leading + turned)
        if cofactors is None or ideal.reduce(leading) == 0:
            continue
        others = [_multiple(poly, leading, ideal) for poly in equations]
        if all(other is not None for other in others):
            return {
                "rule": "quarter_turn", "cos": c, "sin": s, "index": index,
                "cofactors": written(cofactors), "others": others,
            }  # fmt: skip
    return None


def _multiple(poly: Poly, leading: Poly, ideal: Ideal) -> list[object] | None:
    """[multiple, cofactors] with poly - multiple * leading in the ideal."""
    factor = proportional(ideal.reduce(poly), ideal.reduce(leading)) or 0
    multiple = ideal.ring.number(factor)
    cofactors = ideal.cofactors(poly - multiple * leading)
    return None if cofactors is None else [str(multiple), written(cofactors)]
