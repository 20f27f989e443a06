"""Counterexamples where angles are compared: at the ends of the intervals, half way between them, at well-known angles.

What digits cannot tell, such as that the tangent of arctan t is t, has a proof.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import cycle, islice, pairwise

from symcheck.checker.enclosures import enclosed
from symcheck.core.calculus import Unknown
from symcheck.core.calculus import letters as letters_in
from symcheck.core.formulas import conjuncts, contrary
from symcheck.core.problems import Applied, Problem
from symcheck.core.terms import PI, Binder, Formula, Node, Quantified, Term, Value, mapped, node
from symcheck.proof.algebra.forms import term_of
from symcheck.proof.algebra.knowledge import formulas_of, ring_of, stated
from symcheck.proof.algebra.polynomial import Ring, Unsupported, canonical, subterms, unfold, variables, with_arguments
from symcheck.proof.algebra.variables import circle
from symcheck.proof.rules.compute import AT_POINT, Point
from symcheck.proof.rules.enclosure import Numbers, prove_numbers
from symcheck.proof.rules.proof import Prover
from symcheck.proof.rules.step import Step
from symcheck.proof.rules.theorem import applied
from symcheck.proof.search.angles import KNOWN_ANGLES, KNOWN_SINES, compared, compares_angles, multiple_of_pi
from symcheck.proof.search.number_points import refute_at

MAX_LETTERS = 3  # each has some twenty values: with more letters no point would be reached in which all are changed
MAX_POINTS = 80  # of which the papers need 16
MAX_PROOFS = 8  # of some seconds each, of which the papers need three
FEW_NUMBERS: tuple[tuple[Term, ...], ...] = ((1, 2, 3), (2, 3, 1), (3, 1, 2), (1, 1, 1))  # a second each
MAX_FACTS = 3  # rounds in which what a proof divides by is shown not to vanish
SAME = 20  # bits: ends of intervals that differ in fewer (of 160) are the same angle
Ends = dict[str, list[Term]]  # by angle: what it is compared with


def refute_about_angles(problem: Problem, prove: Prover) -> Point | None:
    """A point where the hypotheses hold and the claim does not, by digits or by a proof; None if none was found."""
    proofs = 0
    for point in islice(_points(problem), MAX_POINTS):
        if (found := refute_at(problem, point)) is not None:
            return found
        if proofs < MAX_PROOFS and _may_refute(problem, point):
            proofs += 1
            if (found := _proved(problem, point, prove)) is not None:
                return found
    return None


def refute_with_hints(problem: Problem, prove: Prover) -> Point | None:
    """The same at a few numbers, where the problem names theorems that say what its functions are."""
    letters = sorted(_letters(unfold(formula, dict(problem.definitions)) for formula in formulas_of(problem)))
    for values in FEW_NUMBERS if _applied(problem) else ():
        point = dict(zip(letters, cycle(values), strict=False))
        if _is_excluded(problem, point):
            continue
        if (found := _proved(problem, point, prove)) is not None:
            return found
    return None


def _applied(problem: Problem) -> tuple[Applied[Term], ...]:
    return tuple(hint for hint in problem.hints if isinstance(hint, Applied))


def _points(problem: Problem) -> Iterator[dict[str, Term]]:
    """Values for all letters, if all of them are angles: first of those whose ends depend on no others."""
    definitions = dict(problem.definitions)
    ring = Ring(with_arguments(ring_of(problem).names), definitions)
    formulas = [unfold(formula, definitions) for formula in formulas_of(problem)]
    if not compares_angles(ring) or any(isinstance(part, Quantified) for part in subterms(*formulas)):
        return
    ends: Ends = {x: [] for function, x in filter(None, map(circle, ring.names)) if function == "sin"}
    for pair in (pair for formula in formulas for pair in compared(formula, ring)):
        if isinstance(pair.angle, str):
            ends.setdefault(pair.angle, []).append(pair.end)
    letters = _letters(formulas)
    if len(letters) <= MAX_LETTERS and letters <= ends.keys():
        yield from _assigned({}, ends, sorted(letters, key=lambda x: (len(_letters(ends[x])), x)))


def _letters(terms: Iterable[Term]) -> set[str]:
    return set().union(*map(letters_in, terms))


def _assigned(point: Mapping[str, Term], ends: Ends, letters: list[str]) -> Iterator[dict[str, Term]]:
    """The point with values for the other letters too."""
    if not letters:
        yield dict(point)
        return
    closed = [end for end in (_at(end, point) for end in ends[letters[0]]) if not _letters([end])]
    for value in _values(closed):
        yield from _assigned({**point, letters[0]: value}, ends, letters[1:])


def _at(term: Term, point: Mapping[str, Term]) -> Term:
    """A term at the point, with the sines and cosines of well-known angles."""
    known = {multiple_of_pi(multiple): multiple for multiple in KNOWN_SINES}
    match term:
        case Value(tag="sin" | "cos" as function, terms=(str(x),)) if point.get(x) in known:
            return KNOWN_SINES[known[point[x]]][function == "cos"]
        case Node():
            return mapped(term, lambda part: _at(part, point))
    return point.get(term, term) if isinstance(term, str) else term


def _values(ends: list[Term]) -> list[Term]:
    """The ends of intervals, angles half way between them, well-known angles; last negative ones and a turn more."""
    known: list[Term] = [multiple_of_pi(multiple) for multiple in KNOWN_ANGLES]
    sizes: dict[int, Term] = {}
    for term in (*ends, known[0], known[-1]):
        try:
            sizes.setdefault(enclosed(term).low >> SAME, term)
        except Unknown:
            continue
    ordered = [term for _, term in sorted(sizes.items())]
    between: list[Term] = [node("/", node("+", low, high), 2) for low, high in pairwise(ordered)]
    negative: list[Term] = [node("-", term) for term in known[1:]]
    turned: list[Term] = [node("+", term, node("*", 2, PI)) for term in between]
    return list(dict.fromkeys([*ends, *known, *between, *negative, *turned]))


def _may_refute(problem: Problem, point: Mapping[str, Term]) -> bool:
    """Whether digits do not exclude it."""
    try:
        numbers = Numbers.of(problem, point)
        if numbers is None or numbers.truth(problem.claim):
            return False
        return not any(numbers.truth(formula) is False for _, formula in stated(problem))
    except (Unknown, Unsupported, RecursionError):
        return False


def _is_excluded(problem: Problem, point: Mapping[str, Term]) -> bool:
    """Whether a hypothesis fails at a point, by digits."""
    try:
        numbers = Numbers.of(problem, point)
        return numbers is not None and any(numbers.truth(formula) is False for _, formula in stated(problem))
    except (Unknown, Unsupported, RecursionError):
        return False


def _proved(problem: Problem, point: Mapping[str, Term], prove: Prover) -> Point | None:
    """Proofs that at the point no denominator vanishes, the hypotheses hold and the claim does not."""
    there = There(problem, dict(sorted(point.items())), prove)
    given = [formula for _, formula in stated(problem)]
    bottoms = [part for f in (*given, problem.claim) for part in _denominators(f) if _letters([part]) <= point.keys()]
    if not all(there.learn(node("!=", bottom, 0)) for bottom in dict.fromkeys(bottoms)):
        return None
    for formula in given if _applied(problem) else ():
        there.learn(formula)
    goal = node("and", *given, contrary(problem.claim))
    proof = there.proof(goal, hints=True)
    if proof is None:  # what digits tell need not follow from the theorems that tell the rest
        other = contrary(_told(problem))
        parts = dict.fromkeys([*conjuncts(goal), other, *_cleared(other)])
        told = [there.learn(part, prove_numbers) for part in parts]
        proof = there.proof(goal, hints=True) if any(told) else None
    return None if proof is None else Point(there.values, facts=tuple(there.facts.items()), proof=proof)


@dataclass
class There:
    """What is proved at a point; facts about the point are numbered in the order of its letters."""

    problem: Problem
    values: Mapping[str, Term]
    prove: Prover
    facts: dict[Formula, Step] = field(default_factory=dict)
    tried: set[Formula] = field(default_factory=set)

    def learn(self, claim: Formula, prove: Prover | None = None) -> bool:
        """One more fact, if it has a proof."""
        if claim not in self.tried | self.facts.keys():
            self.tried.add(claim)
            if (proof := self.proof(claim, prove)) is not None:
                self.facts[claim] = proof
        return claim in self.facts

    def proof(self, claim: Formula, prove: Prover | None = None, *, hints: bool = False) -> Step | None:
        """The proof without any condition: of what must not vanish there is one first."""
        kept = _applied(self.problem) if hints else ()
        for _ in range(MAX_FACTS):
            points: list[Formula] = [node("=", x, value) for x, value in self.values.items()]
            known = ((AT_POINT, (*points, *self.facts)),)
            try:
                proof = (prove or self.prove)(replace(self.problem, claim=claim, hypotheses=known, hints=kept))
            except Unsupported:
                return None
            if proof is None:
                return None
            bottoms = (*proof.nonzero, *proof.step.positive)  # facts of this place are not known to a whole proof
            missing = [f for bottom in bottoms if (f := node("!=", bottom, 0)) not in self.facts]
            if not missing:
                return replace(proof.step, positive=())
            if not all(map(self.learn, missing)):
                return None
        return None


def _told(problem: Problem) -> Formula:
    """The claim with what theorems say in the place of integrals and sums."""
    definitions = dict(problem.definitions)
    values: dict[str, Term] = {}
    for hint in _applied(problem):
        said = applied(hint.theorem, *hint.functions, *hint.terms).said(definitions).conclusion
        equations = (part.terms for part in conjuncts(said) if part.tag == "=")
        values |= {canonical(left): right for left, right in equations if isinstance(left, Binder)}

    def told(tree: Term) -> Term:
        if isinstance(tree, Binder) and (text := canonical(tree)) in values:
            return told(values[text])
        return mapped(tree, told) if isinstance(tree, Node) else tree

    return mapped(unfold(problem.claim, definitions), told)


def _cleared(formula: Formula) -> Iterator[Formula]:
    """The same of two fractions without denominators."""
    if formula.tag == "!=":
        yield node("!=", term_of(Ring(variables(*formula.terms)).subtract(*formula.terms).num), 0)


def _denominators(formula: Formula) -> Iterator[Term]:
    """What a formula divides by, as far as it depends on letters."""
    for part in subterms(formula):
        match part:
            case ("/", _, bottom) if _letters([bottom]):
                yield bottom
            case ("tan", angle):
                yield node("cos", angle)
