"""What every method does: look for a proof; failing that, for an exact counterexample; failing that, say why."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace

from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import Formula, Node, Relation, Term, node
from symcheck.core.verdicts import Certificate, Verdict
from symcheck.proof.closed import decide_numbers
from symcheck.proof.counterexample import refute
from symcheck.proof.knowledge import Knowledge, given_of, ring_of, starting
from symcheck.proof.mentions import nonzero_terms, references, terms_in, texts_in
from symcheck.proof.orders import form_on_the_circle
from symcheck.proof.polynomial import Poly, Ring, Unsupported, function_arguments, unfold, variables
from symcheck.proof.variables import atoms, table
from symcheck.proof.wellformed import checked
from symcheck.proof.witness import find_witnesses

VACUOUS = (
    "it follows from what is given, but no point was found at which that holds: hypotheses, premises, "
    "and that no denominator is zero"
)
Search = Callable[[Problem, Ring], Certificate | None]


def decide(problem: Problem, search: Search) -> Outcome:
    """Proved with a rule tree, refuted with a point, or undecided with the reason; no statement raises."""
    try:
        problem = checked(problem)
        outcome = decide_numbers(problem) or _search(problem, search)
        if outcome is not None:
            return outcome if outcome.verdict is Verdict.REFUTED else with_witnesses(problem, outcome, search)
        point = refute(problem, lambda inner: prove(inner, search))
        json.dumps(point)  # a number may be too long to be written
    except Unsupported as error:
        return Outcome(Verdict.UNDECIDED, reason=str(error))
    except (RecursionError, ArithmeticError, ValueError) as error:
        return Outcome(Verdict.UNDECIDED, reason=f"a limit of the search was reached ({type(error).__name__})")
    if point is not None:
        return Outcome(Verdict.REFUTED, point=point, used=tuple(name for name, _ in problem.hypotheses))
    return Outcome(
        Verdict.UNDECIDED, reason="neither a proof nor a counterexample was found within the limits of the search"
    )


def with_witnesses(problem: Problem, outcome: Outcome, search: Search) -> Outcome:
    """The proof with points at which all it rests on holds together; undecided if none was found."""
    assert outcome.proof is not None
    found = find_witnesses(problem, nonzero_terms(outcome.proof), lambda inner: prove(inner, search))
    if found is None:
        return Outcome(Verdict.UNDECIDED, reason=VACUOUS)
    json.dumps([outcome.proof, found])
    return replace(outcome, proof={**outcome.proof, "witnesses": found})


def prove(problem: Problem, search: Search) -> Outcome | None:
    """Proved, or None; no counterexample is looked for. Unsupported for terms that have no place in a ring."""
    if (decided := decide_numbers(problem)) is not None:
        return decided if decided.verdict is Verdict.PROVED else None
    return _search(problem, search)


def _search(problem: Problem, search: Search) -> Outcome | None:
    ring = ring_of(problem)
    proof = search(problem, ring)
    return None if proof is None else _proved(problem, ring, proof)


def _proved(problem: Problem, ring: Ring, proof: Certificate) -> Outcome | None:
    """Completes a proof: the denominators' side conditions and the list of what it rests on.

    None if the proof divides by something that the statement does not divide by and that is not known to be non-zero.
    """
    given = references(proof)
    own = [unfold(term, ring.definitions) for term in terms_in(proof, ring.definitions)]
    if ring.divisors or own or atoms().keys() & set(ring.names):
        stated = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs)]
        own += [unfold(side, ring.definitions) for formula in stated for side in _sides(formula)]
        inner = [t for term in own for bodies in (True, False) for t in function_arguments(term, bodies)]
        names = set(ring.names).union(*map(variables, [*own, *inner]))
        known, before = starting(problem, Ring(names, ring.definitions)), -1
        while len(given) > before:  # a hypothesis that is used has denominators of its own
            before = len(given)
            listed, positive = _conditions(problem, proof, known, given)
            if listed is None:
                return None
        proof |= {"nonzero": sorted(listed)} if listed else {}
        proof |= {"positive": positive} if positive else {}
    names = set(re.findall(r"\w+", " ".join(texts_in(proof))))
    meant = {name: table().term(name) for name in sorted(names) if table().stands(name)}
    proof |= {"atoms": meant} if meant else {}
    proof["given"] = sorted([name, k] for name, k in given)
    used = {name for name, _ in given}
    return Outcome(Verdict.PROVED, proof=proof, used=tuple(name for name, _ in problem.hypotheses if name in used))


def _conditions(
    problem: Problem, proof: Certificate, known: Knowledge, given: set[tuple[str, int]]
) -> tuple[list[list[str]] | None, list[Term]]:
    """(denominators of the statement about which no hypothesis speaks, the proof's own as positive terms).

    A denominator that contains others is written as its numerator and those others. Adds to the hypotheses given.
    """
    parts = [(name, k, f) for name, fs in problem.hypotheses for k, f in enumerate(p for f in fs for p in conjuncts(f))]
    stated = [problem.claim, *(f for name, k, f in parts if (name, k) in given)]
    statement = _divisors([side for formula in stated for side in _sides(formula)], known.ring)
    listed: list[list[str]] = []
    positive: list[Term] = []
    for texts, divisor in {**statement, **_divisors(terms_in(proof, known.ring.definitions), known.ring)}.items():
        refs = known.nonzero(divisor) if len(texts) == 1 else None
        if refs is not None:
            given |= given_of(refs)
        elif texts in statement:
            listed.append([*texts])
        elif (form := _positive(divisor, texts[1:], known)) is not None:
            given |= known.sign(form)[1]
            positive += [form, form[1]] if len(texts) > 1 and isinstance(form, tuple) else [form]
        else:
            return None, []
    return listed, positive


def _sides(formula: Formula) -> list[Term]:
    """Both sides of every relation, of those under quantifiers too: what is divided by there may be free of letters."""
    if isinstance(formula, Relation):
        return [*formula.terms]
    return [side for part in (*formula.inside, *formula.outside) if isinstance(part, Node) for side in _sides(part)]


def _positive(top: Poly, below: tuple[str, ...], known: Knowledge) -> Term | None:
    """A manifestly positive term that is the fraction or its negative, or None."""
    for name, axiom in known.ring.axioms():
        top = divmod(top, axiom)[1] if name[1] == "sqrt" else top  # a root squared is a number
    form = form_on_the_circle(top, known) or form_on_the_circle(-top, known)
    found = [form_on_the_circle(known.ring.text(text), known) for text in below]
    bottoms = [bottom for bottom in found if bottom is not None]
    if form is None or len(bottoms) < len(found):
        return None
    whole: Term = node("/", form, node("*", 1, *bottoms)) if bottoms else form
    return whole if known.sign(whole)[0] == 2 else None


def _divisors(terms: list[Term], ring: Ring) -> dict[tuple[str, ...], Poly]:
    """The denominators met in the terms, also in the arguments of functions."""
    outside, inside = (Ring(ring.names, ring.definitions) for _ in range(2))
    inside.inside = True
    for term in terms:
        plain = unfold(term, ring.definitions)
        for part in (term, *function_arguments(plain, bodies=False)):
            outside.ratio(part)
        for part in function_arguments(plain, bodies=True):
            inside.ratio(part)
    return {**outside.divisors, **inside.divisors}
