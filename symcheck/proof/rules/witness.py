"""Existence: a witness, and a zero of a function of an angle that changes its sign under a turn by 90 degrees."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from symcheck.core.calculus import substituted
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.problems import Witness as Hinted
from symcheck.core.terms import Formula, Node, Quantified, Term, mapped, node
from symcheck.proof.algebra.knowledge import Knowledge, ring_of, starting
from symcheck.proof.algebra.polynomial import Ring, subterms, unfold, variables
from symcheck.proof.algebra.variables import cosine, table
from symcheck.proof.rules.identity import equations_here, identity_here
from symcheck.proof.rules.step import Prove, Step
from symcheck.proof.rules.theorem import applied, of


@dataclass(frozen=True)
class Witness(Step):
    """Something exists, as it is so of these terms."""

    rule: ClassVar[str] = "witness"
    point: Mapping[str, Term]
    then: Step

    def speaks_of(self, definitions: Mapping[str, Term]) -> Iterable[Term]:
        return self.point.values()


def prove_existence(problem: Problem, ring: Ring, prove_body: Prove) -> Step | None:
    """The proof of an "exists" claim from the hinted point, or by a quarter turn if there is none.

    A point may contain two new letters, such as u and v: some point (u, v) of the unit circle. A claim about
    such a point itself, "exists c, s: c^2 + s^2 = 1 and ...", is read so too.
    """
    point = dict(pair for hint in problem.hints if isinstance(hint, Hinted) for pair in hint.values)
    if not isinstance(problem.claim, Quantified):
        return None
    bound, body = problem.claim.bound, problem.claim.body
    angle = table().letter(table().fresh("turn"))  # (u, v) = (cos turn, sin turn)
    if not point and len(bound) == 1:
        point = {bound[0]: angle}
    if not point and len(bound) == 2:
        point = {bound[0]: node("cos", angle), bound[1]: node("sin", angle)}
    if set(point) != set(bound):
        return None
    plain = Problem(problem.id, problem.claim, problem.definitions, problem.hypotheses)
    own = set().union(*(variables(term) for term in point.values())) - {*ring_of(plain).names, angle}
    letters = sorted(name for name in own if not table().stands(name))
    if len(letters) not in (0, 2):
        return None
    circle: dict[str, Term] = {x: node(f, angle) for x, f in zip(letters, ("cos", "sin"), strict=False)}
    point = {name: substituted(term, circle) for name, term in point.items()}
    shown = substituted(unfold(body, {n: t for n, t in problem.definitions if n not in point}), point)
    known = starting(problem, Ring({*ring.names, *variables(shown)}, ring.definitions))
    if not any(part == angle for term in point.values() for part in subterms(term)):
        return _witness(point, shown, known, prove_body)
    turns = (_at_zero(point, shown, known, equation, angle, prove_body) for equation in conjuncts(shown))
    return next(filter(None, turns), None)


def _witness(point: Mapping[str, Term], shown: Formula, known: Knowledge, prove_body: Prove) -> Step | None:
    """The proof with that point."""
    then = equations_here(shown, known) or prove_body(shown, known)
    return None if then is None else Witness(point, then)


def _at_zero(
    point: Mapping[str, Term], shown: Formula, known: Knowledge, equation: Formula, angle: str, prove_body: Prove
) -> Step | None:
    """The proof with that point; the angle in it is one where the equation holds."""
    if equation.tag != "=" or cosine(angle) not in known.ring.generator:
        return None
    left, right = equation.terms
    leading: Term = node("+", left, node("-", right))
    sin, cos = node("sin", angle), node("cos", angle)
    further: dict[Term, Term] = {cos: node("-", sin), sin: cos}
    premise = identity_here(node("=", _turned(leading, further), node("-", leading)), known)
    if premise is None or known.ideal().reduce(known.ring.ratio(leading).num) == 0:
        return None
    then = _witness(point, shown, known.assume(node("=", leading, 0)), prove_body)
    if then is None:
        return None
    return applied("quarter_turn", of(angle, leading)).step([premise], then)


def _turned(term: Term, further: Mapping[Term, Term]) -> Term:
    """The term 90 degrees further."""
    if term in further:
        return further[term]
    return mapped(term, lambda part: _turned(part, further)) if isinstance(term, Node) else term
