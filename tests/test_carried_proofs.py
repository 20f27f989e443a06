"""Proofs are carried over to the same statements about other terms."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace

from symcheck import papers
from symcheck.audit.context import Context
from symcheck.audit.judge import judge, units
from symcheck.checker import check
from symcheck.core.calculus import functions, letters, substituted
from symcheck.core.claims import Assertion
from symcheck.core.problems import Problem
from symcheck.core.terms import RELATIONS, Formula, Term, node
from symcheck.proof import certificate
from symcheck.proof.rules.proof import Proof
from symcheck.proof.search.carried import carried

STEP = 15  # all of them take minutes
CASES = [
    (key, item.number)
    for key, paper in papers.load().items()
    for _, _, item in paper.items()
    if isinstance(item, Assertion) and not item.question
]


def proofs(key: str, number: str) -> list[tuple[Problem, Proof]]:
    """What is printed there with its proofs, as far as these need no lemmas and speak of letters that are numbers."""
    item = next(each for _, _, each in papers.load()[key].items() if each.number == number)
    assert isinstance(item, Assertion)
    context = Context(papers.load()[key], item)
    found = []
    for unit in units(context):
        finding = judge(context, unit, item.statement.given)
        for problem, outcome in zip(finding.concrete, finding.outcomes, strict=True):
            stated = [problem.claim, *(f for _, formulas in problem.hypotheses for f in formulas)]
            if outcome.proof is not None and not any(map(functions, stated)) and problem in finding.problems:
                found.append((problem, outcome.proof))
    return found


def about(problem: Problem, mean: dict[str, Term]) -> Problem:
    """The same about other terms."""
    return Problem(
        problem.id,
        substituted(problem.claim, mean),
        tuple((name, substituted(term, mean)) for name, term in problem.definitions),
        tuple((name, tuple(substituted(f, mean) for f in formulas)) for name, formulas in problem.hypotheses),
    )


def free(problem: Problem) -> set[str]:
    trees: list[Formula | Term] = [problem.claim, *(term for _, term in problem.definitions)]
    trees += [f for _, formulas in problem.hypotheses for f in formulas]
    return set().union(*map(letters, trees)) - {name for name, _ in problem.definitions}


def test_proofs_are_those_of_the_same_about_multiples_and_of_nothing_else() -> None:
    found = Counter[str | None]()
    for key, number in CASES[::STEP]:
        for problem, proof in proofs(key, number):
            mean: dict[str, Term] = {x: node("*", "factor", x) for x in sorted(free(problem))}
            wanted = about(problem, mean)
            outcome = carried(proof, problem, mean, wanted)
            if outcome is None:
                found["not carried"] += 1
                continue
            found[check(json.loads(json.dumps(certificate(wanted, outcome))))] += 1
            if wanted.claim.tag in RELATIONS:
                left, right = wanted.claim.terms
                other = replace(wanted, claim=node(wanted.claim.tag, node("+", "other", left), right))
                assert carried(proof, problem, mean, other) is None, (number, wanted.claim)
    assert 2 * found[None] > found.total(), found
