"""That terms under integrals, sums and quantifiers have values at a point, with proofs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symcheck.core.calculus import Lambda, letters, owed, substituted
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import Binder, Formula, Quantified, Relation, Term, node
from symcheck.proof.algebra.facts import Hypothesis
from symcheck.proof.algebra.knowledge import formulas_of
from symcheck.proof.algebra.polynomial import unfold
from symcheck.proof.algebra.variables import table
from symcheck.proof.rules.choose import Choose
from symcheck.proof.rules.compute import AT_POINT, Compute, Point
from symcheck.proof.rules.each import Each
from symcheck.proof.rules.every import Every
from symcheck.proof.rules.proof import Prover
from symcheck.proof.rules.step import Step
from symcheck.proof.search.angle_points import There


def owed_by(problem: Problem) -> list[Formula]:
    """What must be so lest a part under a binder have no value, definitions unfolded."""
    definitions = dict(problem.definitions)
    return owed(*(unfold(each, definitions) for each in formulas_of(problem)))


def computed(formula: Formula) -> bool:
    """Whether it is computed at a point, and needs no proof there."""
    return isinstance(formula, Relation) and not any(isinstance(side, Binder) for side in formula.outside)


def with_values(problem: Problem, point: Point, prove: Prover) -> Point | None:
    """The point with proofs of what is owed there; None if one has no proof."""
    needed = owed_by(problem)
    if not needed:
        return point
    values: dict[str, Term] = {**dict.fromkeys(set().union(*map(letters, needed)), 1), **point.values}
    known = {node("=", substituted(t, values), value): why for t, value, why in point.functions}
    there = There(replace(problem, definitions=()), dict(sorted(values.items())), prove, {**known, **dict(point.facts)})
    shown = [None if computed(each) else _shown(each, there) for each in needed]
    if any(fact is None and not computed(each) for fact, each in zip(shown, needed, strict=True)):
        return None
    facts = tuple(there.facts.items())[len(known) :]
    if point.proof is None:
        return replace(point, values=there.values, facts=facts)
    places = [*there.facts]
    by = [() if fact is None else (Hypothesis(AT_POINT, len(values) + places.index(fact)),) for fact in shown]
    return replace(point, facts=facts, proof=Each((point.proof, *map(Compute, by))))


def _shown(formula: Formula, there: There) -> Formula | None:
    """The fact that shows it: about numbers, or, as signs of letters may help more than values, about letters."""
    closed, values = formula, dict(there.values)
    for _ in values:  # coordinates may be given by others
        closed = substituted(closed, values)
    if (step := _of_numbers(closed, there)) is not None:
        there.facts[closed] = step
        return closed
    if not isinstance(formula, Relation):
        return None
    for x in sorted(letters(formula)):
        _ = there.learn(node(">", x, 0)) or there.learn(node("<", x, 0))
    if (step := there.proof(formula, hints=True)) is not None:
        there.facts[formula] = step
    return formula if step is not None else None


def _of_numbers(formula: Formula, there: There) -> Step | None:
    """The proof of what no letter occurs in, by itself."""
    if formula.tag == "or":
        parts = ((k, _of_numbers(part, there)) for k, part in enumerate(formula.formulas))
        return next((Choose(k, step) for k, step in parts if step is not None), None)
    names: tuple[str, ...] = ()
    body = formula
    if isinstance(formula, Quantified):
        names = tuple(map(table().fresh, formula.bound))
        body = substituted(formula.body, dict(zip(formula.bound, names, strict=True)))
    applied = (hint for hint in there.problem.hints if isinstance(hint, Applied))
    proof = there.prove(Problem("value", body, hints=tuple(_about(hint, there.values) for hint in applied)))
    if proof is None or proof.nonzero:
        return None
    return Every(names, proof.step) if names else proof.step


def _about(hint: Applied[Term], values: Mapping[str, Term]) -> Applied[Term]:
    """The theorem about a point."""
    terms, functions = (substituted(t, values) for t in hint.terms), list[Lambda]()
    for own, body in hint.functions:
        functions.append((own, substituted(body, {x: value for x, value in values.items() if x not in own})))
    return Applied(hint.theorem, tuple(terms), tuple(functions))
