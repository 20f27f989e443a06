"""Statements that something exists, or is so of all numbers, where no other letter and no hypothesis occurs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from symcheck.core.calculus import letters, substituted
from symcheck.core.formulas import conjuncts, contrary
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import Formula, Quantified, Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof.algebra.flint import by_powers, fraction
from symcheck.proof.algebra.forms import number_term
from symcheck.proof.algebra.polynomial import Ring, Unsupported, variables
from symcheck.proof.algebra.variables import table
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.each import Each
from symcheck.proof.rules.every import Every
from symcheck.proof.rules.proof import Proof, Prover
from symcheck.proof.rules.step import Step, Whole
from symcheck.proof.rules.witness import Witness
from symcheck.proof.search.counterexample import refute


def decide_alone(problem: Problem, prove: Prover) -> Outcome | None:
    """The outcome for a quantifier over everything; None where nothing was found, or other letters occur."""
    claim = problem.claim
    if not isinstance(claim, Quantified) or problem.hypotheses or problem.definitions or letters(claim):
        return None
    names = tuple(map(table().fresh, claim.bound))
    opened = substituted(claim.body, dict(zip(claim.bound, names, strict=True)))
    exists = claim.tag == "exists"
    if (shown := _every(names, contrary(opened) if exists else opened, prove)) is not None:
        return _refuted(shown) if exists else _proved(shown)
    if (shown := _witness(claim, names, opened if exists else contrary(opened), prove)) is not None:
        return _proved(shown) if exists else _refuted(shown)
    return None


def _proved(step: Step) -> Outcome:
    return Outcome(Verdict.PROVED, proof=Proof(Whole(step)))


def _refuted(step: Step) -> Outcome:
    return Outcome(Verdict.REFUTED, point=Point({}, proof=Each((step,))))


def _every(names: tuple[str, ...], formula: Formula, prove: Prover) -> Step | None:
    proof = _plainly(formula, prove)
    return proof and Every(names, proof)


def _plainly(formula: Formula, prove: Prover) -> Step | None:
    """A proof that assumes of no denominator that it is not zero."""
    try:
        proof = prove(Problem("all", formula))
    except Unsupported:
        return None
    return proof.step if proof is not None and not proof.nonzero else None


def _witness(claim: Quantified, names: tuple[str, ...], formula: Formula, prove: Prover) -> Step | None:
    """By a solution of an equation of the second degree, or by a point that a search finds."""
    for values in _candidates(names, formula):
        if (then := _plainly(substituted(formula, values), prove)) is not None:
            return Witness({x: values[name] for x, name in zip(claim.bound, names, strict=True)}, then)
    return None


def _candidates(names: tuple[str, ...], formula: Formula) -> Iterator[Mapping[str, Term]]:
    for part in conjuncts(formula) if len(names) == 1 else ():
        if part.tag == "=":
            yield from ({names[0]: root} for root in _roots(part, names[0]))
    if (point := refute(Problem("some", contrary(formula)))) is not None and {*names} <= point.values.keys():
        yield point.values


def _roots(equation: Formula, x: str) -> Iterator[Term]:
    """The solutions of an equation of the first or second degree."""
    left, right = equation.terms
    if variables(left, right) != {x}:
        return
    gap = Ring({x}).subtract(left, right).num
    by = {power: fraction(factor.leading_coefficient()) for power, factor in by_powers(gap, x).items()}
    a, b, c = (by.get(power, Fraction(0)) for power in (2, 1, 0))
    inner = b * b - 4 * a * c
    if max(by, default=0) == 1:
        yield number_term(-c / b)
    elif max(by, default=0) == 2 and inner >= 0:
        root = node("sqrt", number_term(inner))
        yield from (node("/", node("+", number_term(-b), term), number_term(2 * a)) for term in (root, node("-", root)))
