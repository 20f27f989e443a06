"""What every method does: look for a proof; failing that, for an exact counterexample; failing that, say why."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from symcheck.checker.theorems import SHOWN
from symcheck.core.calculus import letters, strict
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import Formula, Node, Relation, Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof.algebra.facts import Grounds
from symcheck.proof.algebra.flint import Poly, occurring
from symcheck.proof.algebra.forms import form_on_the_circle
from symcheck.proof.algebra.knowledge import Knowledge, formulas_of, hypotheses_of, ring_of, starting, stated
from symcheck.proof.algebra.polynomial import Ring, Unsupported, beneath, function_arguments, unfold, variables
from symcheck.proof.algebra.printed import term_of_text
from symcheck.proof.algebra.variables import atoms, prime, table
from symcheck.proof.rules.enclosure import prove_numbers
from symcheck.proof.rules.proof import Proof
from symcheck.proof.rules.step import Step, Whole, mentioned, printed, written
from symcheck.proof.rules.theorem import Instance, Theorem
from symcheck.proof.search import splitting
from symcheck.proof.search.counterexample import refute
from symcheck.proof.search.functions import SIGNS
from symcheck.proof.search.number_points import refute_numbers
from symcheck.proof.search.quantified import decide_alone
from symcheck.proof.search.values import with_values
from symcheck.proof.search.wellformed import checked
from symcheck.proof.search.witnesses import find_witnesses

VACUOUS = (
    "it follows from what is given, but no point was found at which that holds: hypotheses, premises, "
    "and that no denominator is zero"
)
_NAMES = re.compile(r"\w+")  # variables in a printed polynomial, and numbers, which stand for nothing
Divisors = dict[tuple[str, ...], Poly]  # by numerator and the denominators inside, printed

UNSETTLED = "neither a proof nor a counterexample was found within the limits of the search"


def decide(problem: Problem) -> Outcome:
    """Proved with steps, refuted with a point, or undecided with the reason; no statement raises."""
    try:
        problem = checked(problem)
        problem = replace(problem, claim=strict(problem.claim))
        if (outcome := decide_alone(problem, prove)) is not None:
            return _complete(problem, outcome)
        point = refute_numbers(problem)
        if point is None:
            if (proof := prove_numbers(problem) or _by_steps(problem)) is not None:
                complete = with_witnesses(problem, proof)
                return proved(problem, complete) if complete else Outcome(Verdict.UNDECIDED, reason=VACUOUS)
            point = refute(problem, prove)
            if point is not None and (point.functions or point.facts or point.proof):
                point = with_values(problem, point, prove)
            written(point and point.certificate())  # a number may be too long to be written
    except Unsupported as error:
        return Outcome(Verdict.UNDECIDED, reason=str(error))
    except (RecursionError, ArithmeticError, ValueError) as error:
        return Outcome(Verdict.UNDECIDED, reason=f"a limit of the search was reached ({type(error).__name__})")
    if point is not None:
        return Outcome(Verdict.REFUTED, point=point, used=tuple(name for name, _ in problem.hypotheses))
    return Outcome(Verdict.UNDECIDED, reason=UNSETTLED)


def _complete(problem: Problem, outcome: Outcome) -> Outcome:
    """The outcome with points, and proofs that all terms have values there."""
    if outcome.point is not None:
        point = with_values(problem, outcome.point, prove)
        return replace(outcome, point=point) if point else Outcome(Verdict.UNDECIDED, reason=VACUOUS)
    assert outcome.proof is not None
    complete = with_witnesses(problem, outcome.proof)
    return proved(problem, complete) if complete else Outcome(Verdict.UNDECIDED, reason=VACUOUS)


def proved(problem: Problem, proof: Proof) -> Outcome:
    """The outcome, with the hypotheses that are used."""
    given = {hypothesis.name for hypothesis in proof.given}
    return Outcome(Verdict.PROVED, proof=proof, used=tuple(name for name, _ in problem.hypotheses if name in given))


def with_witnesses(problem: Problem, proof: Proof) -> Proof | None:
    """The proof with points at which all it rests on holds together; None if none was found."""
    points = find_witnesses(problem, proof.nonzero, prove)
    if points is None:
        return None
    written([proof.step, *(point.certificate() for point in points)])
    return replace(proof, witnesses=tuple(points))


def prove(problem: Problem) -> Proof | None:
    """A proof, or None; no counterexample is looked for. Unsupported for terms that have no place in a ring."""
    if (proof := prove_numbers(problem)) is not None:
        return proof
    return None if refute_numbers(problem) else _by_steps(problem)


def _by_steps(problem: Problem) -> Proof | None:
    ring = ring_of(problem)
    step = splitting.prove(problem, ring)
    return None if step is None else _completed(problem, ring, step)


def _completed(problem: Problem, ring: Ring, step: Step) -> Proof | None:
    """The proof with what it rests on, and the denominators' side conditions.

    None if the proof divides by something that the statement does not divide by and that is not known to be non-zero.
    """
    given = hypotheses_of(step.references)
    nonzero: list[tuple[str, ...]] = []
    positive: list[Term] = []
    own = [unfold(term, ring.definitions) for term in mentioned(step, ring.definitions)]
    if ring.divisors or own or any(name in atoms() or beneath(name) for name in ring.names):
        own += [unfold(side, ring.definitions) for formula in formulas_of(problem) for side in _sides(formula)]
        inner = [t for term in own for bodies in (True, False) for t in function_arguments(term, bodies)]
        names = set(ring.names).union(*map(variables, [*own, *inner]))
        known, before = starting(problem, Ring(names, ring.definitions)), -1
        while len(given) > before:  # a hypothesis that is used has denominators of its own
            before = len(given)
            conditions = _conditions(problem, step, known, given)
            if conditions is None:
                return None
            nonzero, positive, given = conditions
    whole = Whole(_named(step), {}, tuple(positive)) if positive else _named(step)
    return Proof(whole, given, tuple(_fraction(*texts) for texts in sorted(nonzero)))


def _named(step: Step) -> Whole:
    """The step with what variables stand for: integrals only behind the theorems that show that they have values."""
    if isinstance(step, Theorem) and _shows_values(step):
        return Whole(replace(step, then=_named(step.then)), _atoms(step.premises))
    return Whole(step, _atoms(step))


def _shows_values(step: Step) -> bool:
    return isinstance(step, Theorem) and (step.instance.name in SHOWN or _shows_values(step.then))


def _atoms(step: object) -> dict[str, Term]:
    names = {name for text in printed(step) for name in _NAMES.findall(text)}
    return {name: table().term(name) for name in sorted(names) if table().stands(name)}


def _fraction(top: str, *below: str) -> Term:
    """A denominator; one with denominators in it is a fraction."""
    numerator, *bottoms = map(term_of_text, (top, *below))
    if not bottoms:
        return numerator
    return node("/", numerator, bottoms[0] if len(bottoms) == 1 else node("*", *bottoms))


def _conditions(
    problem: Problem, step: Step, known: Knowledge, given: Grounds
) -> tuple[list[tuple[str, ...]], list[Term], Grounds] | None:
    """(denominators of the statement about which no hypothesis speaks, the proof's own as positive terms, hypotheses).

    A denominator that contains others is written as its numerator and those others. Hypotheses are added to the given.
    """
    formulas = [problem.claim, *(formula for ref, formula in stated(problem) if ref in given)]
    sides = [side for formula in formulas for side in _sides(formula)]
    statement = _divisors(sides, known.ring)
    bound = statement.keys() - _divisors(sides, known.ring, bodies=False).keys()  # what only integrands divide by
    nonzero: list[tuple[str, ...]] = []
    positive: list[Term] = []
    free = set().union(*(letters(unfold(f, known.ring.definitions)) for f in formulas))
    shown = known
    for instance in _signs(step):
        shown = shown.assume(instance.said(known.ring.definitions).conclusion)
    for texts, divisor in {**statement, **_divisors(mentioned(step, known.ring.definitions), known.ring)}.items():
        refs = shown.nonzero(divisor) if len(texts) == 1 else None
        if refs is not None:
            given |= hypotheses_of(refs)
        elif not _letters(divisor) <= free:
            continue  # under a binder, or in a premise about all numbers, where it is shown
        elif texts in statement and (texts not in bound or _letters(divisor)):
            nonzero.append(texts)
        elif (form := _positive(divisor, texts[1:], known)) is not None:
            given |= known.sign(form)[1]
            positive += [form, form.terms[0]] if len(texts) > 1 and isinstance(form, Node) else [form]
        elif texts in statement:
            nonzero.append(texts)
        else:
            return None
    return nonzero, positive, given


def _signs(step: Step) -> Iterator[Instance]:
    """The theorems about signs that come before all else, so that what they say is in force everywhere."""
    while isinstance(step, Theorem) and step.instance.name in SIGNS:
        yield step.instance
        step = step.then


def _letters(poly: Poly) -> set[str]:
    """The letters of a polynomial, also of what its variables stand for."""
    return letters(node("+", 0, *map(table().term, sorted(occurring(poly)))))


def _sides(formula: Formula) -> list[Term]:
    """Both sides of every relation, of those under quantifiers too: what is divided by there may be free of letters."""
    if isinstance(formula, Relation):
        return [*formula.terms]
    return [side for part in (*formula.inside, *formula.outside) if isinstance(part, Node) for side in _sides(part)]


def _positive(top: Poly, below: tuple[str, ...], known: Knowledge) -> Term | None:
    """A manifestly positive term that is the fraction or its negative, or None."""
    for variable, axiom in known.ring.axioms().items():
        top = divmod(top, axiom)[1] if prime(variable) else top  # a root squared is a number
    form = form_on_the_circle(top, known) or form_on_the_circle(-top, known)
    bottoms = [form_on_the_circle(known.ring.poly(term_of_text(text)), known) for text in below]
    known_bottoms = [bottom for bottom in bottoms if bottom is not None]
    if form is None or len(known_bottoms) < len(bottoms):
        return None
    whole: Term = node("/", form, node("*", 1, *known_bottoms)) if bottoms else form
    return whole if known.sign(whole)[0] == 2 else None


def _divisors(terms: Iterable[Term], ring: Ring, *, bodies: bool = True) -> Divisors:
    """The denominators met in the terms, also in the arguments of functions, and in what stands under binders."""
    outside, inside = (Ring(ring.names, ring.definitions) for _ in range(2))
    inside.inside = True
    for term in terms:
        plain = unfold(term, ring.definitions)
        for part in (term, *function_arguments(plain, bodies=False)):
            outside.ratio(part)
        for part in function_arguments(plain, bodies=True) if bodies else ():
            inside.ratio(part)
    return {**outside.divisors, **inside.divisors}
