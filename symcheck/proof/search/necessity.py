"""Why a statement needs a hypothesis: without it the statement fails at a point, nothing of the kind exists, or a term
has no value. Each has a certificate.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from symcheck.core import certificates
from symcheck.core.calculus import letters
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Candidate, Outcome, Problem
from symcheck.core.terms import RELATIONS, Formula, Node, Quantified, Term, mapped, node
from symcheck.core.verdicts import Loss, Verdict
from symcheck.proof.algebra.knowledge import ORDERS, formulas_of
from symcheck.proof.algebra.polynomial import Unsupported, alone, letters_of, subterms
from symcheck.proof.algebra.variables import Table
from symcheck.proof.rules.compute import Point
from symcheck.proof.search.angle_points import refute_about_angles
from symcheck.proof.search.certificate import certificate
from symcheck.proof.search.counterexample import failing
from symcheck.proof.search.methods import proof_of, refute, whole_proof
from symcheck.proof.search.witnesses import ZERO_IS_ONE

PLAIN = {"+", "-", "*", "/", "^", "and", "or", "=>", "<=>", *RELATIONS}
DRAWN = range(-5, 6)  # for each letter: small numbers make equations hold by chance
DRAWS = 500  # points: those of the papers are among the first 453
TURNS = {"sin": "sine", "cos": "cosine"}
RIGHT_ANGLES = ((0, 1), (1, 0))  # the sine and the cosine of 0 and of 90 degrees
HAVING_A_VALUE: dict[str, Callable[..., Formula]] = {
    "/": lambda _, bottom: node("!=", bottom, 0),
    "sqrt": lambda radicand: node(">=", radicand, 0),
    "log": lambda number: node(">", number, 0),
    "gamma": lambda number: node(">", number, 0),
    "tan": lambda angle: node("!=", node("cos", angle), 0),
    "pow": lambda base, _: node(">", base, 0),
}


class Without(NamedTuple):
    """What is lost without a hypothesis.

    Parameters
    ----------
    loss
        Truth, a value, or existence.
    certificate
        A refutation, or a proof that nothing exists.
    """

    loss: Loss
    certificate: certificates.Certificate


def fails_without(problem: Problem) -> Without | None:
    """Find out what a problem has lost with a hypothesis.

    Parameters
    ----------
    problem
        The problem without the hypothesis.

    Returns
    -------
    Without or None
        What is lost, with a certificate; None if nothing was found to be.
    """
    if problem.claim[0] == "exists":
        none = next(filter(None, map(_none_exists, _at_special_angles(problem))), None)
        return Without(Loss.EXISTENCE, none) if none else None
    if (point := _refuted(problem)) is not None:
        return Without(Loss.TRUTH, point)
    without_value = next(filter(None, map(_refuted, _meaningful(problem))), None)
    return Without(Loss.VALUE, without_value) if without_value else None


def _refuted(problem: Problem) -> certificates.Certificate | None:
    point = refute(problem) or _refuted_by_proof(problem) or _refuted_by_chance(problem)
    used = tuple(name for name, _ in problem.hypotheses)
    return certificate(problem, Outcome(Verdict.REFUTED, point=point, used=used)) if point else None


def _refuted_by_proof(problem: Problem) -> Point | None:
    """Where angles are compared, a point at which the contrary has a proof."""
    try:
        with alone(problem):
            return refute_about_angles(problem, whole_proof)
    except Unsupported:
        return None


def _refuted_by_chance(problem: Problem) -> Point | None:
    """A point whose coordinates are drawn from the small whole numbers; not where there are functions."""
    terms = dict(problem.definitions)
    stated = [*formulas_of(problem), *terms.values()]
    if any(isinstance(tree, Node) and tree.tag not in PLAIN for tree in subterms(*stated)):
        return None
    names = sorted(set().union(*map(letters, stated)) - terms.keys())
    draw, fails = random.Random(problem.id), failing(problem)
    for _ in range(DRAWS if fails else 0):
        point = {letter: draw.choice(DRAWN) for letter in names}
        if fails and fails(point):
            return refute(replace(problem, hints=(Candidate(tuple(point.items())),)))
    return None


def _meaningful(problem: Problem) -> Iterator[Problem]:
    """What must hold for terms of the claim to have values, each to be refuted."""
    table, stated = dict(problem.definitions), dict[Formula, None]()
    todo: list[Term] = [problem.claim]
    while todo:
        for tree in subterms(todo.pop()):
            if isinstance(tree, str) and tree in table:
                todo.append(table.pop(tree))
            elif isinstance(tree, Node) and tree.tag in HAVING_A_VALUE:
                stated[HAVING_A_VALUE[tree.tag](*tree.terms)] = None
    for condition in stated:
        if any(isinstance(tree, str) for tree in subterms(condition)):
            yield replace(problem, claim=condition)


def _none_exists(problem: Problem) -> certificates.Certificate | None:
    """The relations, as few as will do, hold together for no values of the bound letters."""
    assert isinstance(problem.claim, Quantified)
    relations = list(conjuncts(problem.claim.body))
    if _contradictory(problem, relations) is None:
        return None
    for relation in tuple(relations):
        rest = [other for other in relations if other != relation]
        relations = relations if _contradictory(problem, rest) is None else rest
    return _contradictory(problem, relations)


def _contradictory(problem: Problem, relations: Sequence[Formula]) -> certificates.Certificate | None:
    """The proof that the relations never hold together; one of them has to be an order."""
    if not any(relation.tag in ORDERS for relation in relations):
        return None
    together = node("and", *relations) if relations[1:] else relations[0]
    failing = replace(problem, claim=node("=>", together, ZERO_IS_ONE))
    proof = proof_of(failing)
    return certificate(failing, proof) if proof else None


def _at_special_angles(problem: Problem) -> Iterator[Problem]:
    """The problem where an angle is right or zero, its sine and cosine letters with definitions; only if there the
    hypotheses hold somewhere.
    """
    stated = (*formulas_of(problem), *(term for _, term in problem.definitions))
    angles = sorted(set().union(*map(_angle_of, subterms(*stated))))
    taken = Table(letters_of(problem))
    for angle in angles:
        for values in RIGHT_ANGLES:
            names: dict[Term, str] = {node(f, angle): taken.fresh(f"{word}_of_{angle}") for f, word in TURNS.items()}
            special = _renamed(problem, names, dict(zip(names.values(), values, strict=True)))
            if not problem.hypotheses or refute(replace(special, claim=ZERO_IS_ONE)) is not None:
                yield special


def _angle_of(term: Term) -> set[str]:
    """The letter of which this is the sine or cosine, if it is one."""
    return {x for x in term.terms if isinstance(x, str)} if isinstance(term, Node) and term.tag in TURNS else set()


def _renamed(problem: Problem, names: Mapping[Term, str], values: Mapping[str, Term]) -> Problem:
    def new(term: Term) -> Term:
        return names[term] if term in names else mapped(term, new) if isinstance(term, Node) else term

    return replace(
        problem,
        claim=mapped(problem.claim, new),
        definitions=(*values.items(), *((name, new(term)) for name, term in problem.definitions)),
        hypotheses=tuple(
            (name, tuple(mapped(formula, new) for formula in formulas)) for name, formulas in problem.hypotheses
        ),
        hints=(),
    )
