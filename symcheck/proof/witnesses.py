"""Existence: a witness, and a zero of a function of an angle that changes its sign under a turn by 90 degrees."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from symcheck.proof.equations import equations_here, identity_here
from symcheck.proof.knowledge import Knowledge, ring_of, starting
from symcheck.proof.polynomial import Ring, unfold, variables
from symcheck.proof.theorems import conjuncts
from symcheck.statement import Certificate, Formula, Problem, Term

ANGLE = "turn"  # the angle of a witness's point (u, v) = (cos turn, sin turn) of the unit circle


Search = Callable[[Formula, Knowledge], Certificate | None]


def prove_existence(problem: Problem, ring: Ring, prove_body: Search) -> Certificate | None:
    """The proof of an "exists" claim from the hinted point, or by a quarter turn if there is none.

    A point may contain two letters of its own, such as u and v: some point (u, v) of the unit circle. A claim about
    such a point itself, "exists c, s: c^2 + s^2 = 1 and ...", is read so too.
    """
    point: dict[str, Term] = {name[6:]: value for name, value in problem.hints if name.startswith("point_")}
    bound, body = problem.claim[1], problem.claim[2]
    if not point and len(bound) == 1:
        point = {bound[0]: ANGLE}
    if not point and len(bound) == 2:
        point = {bound[0]: ("cos", ANGLE), bound[1]: ("sin", ANGLE)}
    if set(point) != set(bound):
        return None
    plain = Problem(problem.id, problem.claim, problem.definitions, problem.hypotheses)
    own = set().union(*(variables(term) for term in point.values())) - {*ring_of(plain).names, ANGLE}
    letters = sorted(name for name in own if name[:4] not in ("sin_", "cos_") and not name.startswith("sqrt_"))
    if len(letters) not in (0, 2):
        return None
    circle: dict[str, Term] = {x: (f, ANGLE) for x, f in zip(letters, ("cos", "sin"), strict=False)}
    point = {name: substitute(term, circle) for name, term in point.items()}
    shown = substitute(unfold(body, {n: t for n, t in problem.definitions if n not in point}), point)
    known = starting(problem, Ring({*ring.names, *variables(shown)}, ring.definitions))
    turns = conjuncts(shown) if any(ANGLE in str(term) for term in point.values()) else [None]
    for equation in turns:
        if (proof := _witness(point, shown, known, equation, prove_body)) is not None:
            return proof
    return None


def _witness(
    point: Mapping[str, Term], shown: Formula, known: Knowledge, equation: Formula | None, prove_body: Search
) -> Certificate | None:
    """The proof with that point; the angle in it is one where the equation holds."""
    if equation is None:
        then = equations_here(shown, known) or prove_body(shown, known)
        return None if then is None else {"rule": "witness", "point": point, "then": then}
    if equation[0] != "=" or f"cos_{ANGLE}" not in known.ring.generator:
        return None
    leading: Term = ("+", equation[1], ("-", equation[2]))
    turned = _turned(leading)
    premise = identity_here(("=", turned, ("-", leading)), known)
    if premise is None or known.ideal().reduce(known.ring.ratio(leading).num) == 0:
        return None
    then = _witness(point, shown, known.assume(("=", leading, 0)), None, prove_body)
    if then is None:
        return None
    return {"rule": "theorem", "of": ["quarter_turn", leading, ANGLE], "premises": [premise], "then": then}


def _turned(node: Any) -> Any:
    """The term 90 degrees further."""
    if node == ("cos", ANGLE):
        return ("-", ("sin", ANGLE))
    if node == ("sin", ANGLE):
        return ("cos", ANGLE)
    return (node[0], *map(_turned, node[1:])) if isinstance(node, tuple) else node


def substitute(node: Formula | Term, values: dict[str, Term]) -> Formula:
    """The term or formula with variables replaced by terms."""
    if isinstance(node, str):
        return values.get(node, node)  # type: ignore[return-value]
    if not isinstance(node, tuple):
        return node  # type: ignore[return-value]
    return (node[0], *(substitute(child, values) for child in node[1:]))
