"""True statements written otherwise: reordered, expanded, factored, renamed. None of them may be rejected."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from random import Random
from typing import Any

from symcheck.audit.dimensions import of_formulas
from symcheck.audit.judge import judge
from symcheck.core.problems import Candidate, Hint, Problem, Witness
from symcheck.core.terms import Formula, Node, Term, Value, node
from symcheck.core.verdicts import Verdict
from symcheck.dimensions import INCONSISTENT
from symcheck.selftest.evidence import answered, ledger_verdict, relettered
from symcheck.selftest.statements import Proved, places, proved
from symcheck.selftest.trial import FaultClass, Status, Trial, drawn

RENAMED = "renamed"


def rewritings(tree: Any, rng: Random) -> Iterator[tuple[str, Any]]:
    """The same formula (or term) with one sum or product in it written otherwise."""
    if not isinstance(tree, Node):
        return
    yield from _here(tree, rng)
    for k, part in enumerate(tree):
        for kind, new in rewritings(part, rng):
            yield kind, node(tree.tag, *tree[1:k], new, *tree[k + 1 :])


def _here(tree: Node, rng: Random) -> Iterator[tuple[str, Node]]:
    head, parts = tree.tag, tree.outside
    if head in ("+", "*", "and", "or") and len(parts) > 1:
        yield "reordered", node(head, *rng.sample(parts, len(parts)))
    if head == "*":
        yield from (("expanded", new) for new in _multiplied_out(parts))
    if head == "+" and len(parts) > 1:
        yield "factored", _factored(parts)


def _multiplied_out(parts: Sequence[Term]) -> Iterator[Node]:
    for k, part in enumerate(parts):
        if isinstance(part, Value) and part.tag == "+":
            yield node("+", *(node("*", *parts[:k], addend, *parts[k + 1 :]) for addend in part.terms))


def _factored(parts: Sequence[Term]) -> Node:
    """The first factor that two addends have in common before a bracket; else a sign before it."""
    for k, first in enumerate(parts):
        for n in range(k):
            shared = next((f for f in _factors(first) if f in _factors(parts[n])), None)
            if shared is not None:
                both = node("*", shared, node("+", _divided(parts[n], shared), _divided(first, shared)))
                rest = [part for m, part in enumerate(parts) if m not in (k, n)]
                return node("+", both, *rest) if rest else both
    return node("-", node("+", *(node("-", part) for part in parts)))


def _factors(term: Term) -> tuple[Term, ...]:
    match term:
        case Value(tag="-", terms=(inner,)):
            return _factors(inner)
        case Value(tag="*", terms=factors):
            return factors
    return ()


def _divided(term: Term, factor: Term) -> Term:
    """The term without one of its factors."""
    assert isinstance(term, Value)
    if term.tag == "-":
        return node("-", _divided(term.terms[0], factor))
    k = term.terms.index(factor)
    return node("*", *term.terms[:k], *term.terms[k + 1 :]) if len(term.terms) > 1 else 1


def renamed(problem: Problem) -> Problem:
    """The same problem with another name for each letter: a "q" before it."""
    hints = tuple(map(_renamed_hint, problem.hints))
    hypotheses = tuple((name, tuple(map(_renamed, formulas))) for name, formulas in problem.hypotheses)
    definitions = tuple((_renamed(name), _renamed(term)) for name, term in problem.definitions)
    return Problem(problem.id, _renamed(problem.claim), definitions, hypotheses, hints)


def _renamed(value: Any) -> Any:
    return relettered(value, lambda name: f"q{name}")


def _renamed_hint(hint: Hint[Term]) -> Hint[Term]:
    new: Hint[Term] = hint.mapped(_renamed)
    if isinstance(new, Witness | Candidate):
        return replace(new, values=tuple((_renamed(letter), value) for letter, value in new.values))
    return new


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many other forms of the relations of one declaration."""
    for kind, (original, n, formula) in drawn(_rewritten(proved(place), rng), count, rng):
        right = _renaming_is_proved(original, n) if kind == RENAMED else _is_proved(original, n, formula)
        yield Trial(kind, f"{original.id} as {formula}", Status.KEPT if right else Status.FALSELY_REJECTED)


def _rewritten(relations: Iterable[Proved], rng: Random) -> Iterator[tuple[str, tuple[Proved, int, Formula]]]:
    for original in relations:
        for n, formula in enumerate(original.unit.formulas):
            yield from ((kind, (original, n, new)) for kind, new in rewritings(formula, rng) if new != formula)
            if not original.context.item.plan.lemmas:
                yield RENAMED, (original, n, formula)


def _is_proved(original: Proved, n: int, formula: Formula) -> bool:
    context, unit, given, _ = original
    formulas = (*unit.formulas[:n], formula, *unit.formulas[n + 1 :])
    if of_formulas(formulas, context.notation).verdict == INCONSISTENT:
        return False
    finding = judge(context, replace(unit, formulas=formulas), given)
    return ledger_verdict(context, unit, finding) is Verdict.PROVED


def _renaming_is_proved(original: Proved, n: int) -> bool:
    context, unit, given, _ = original
    method = context.method(unit.letter)
    problem = renamed(context.problem(unit.formulas[n], given, method, n))
    return answered(problem, method.decide(problem)) is Verdict.PROVED


CLASS = FaultClass(
    "rewritings",
    "true statements written otherwise, before the audit",
    ("reordered", "expanded", "factored", RENAMED),
    share=400,
    places=places,
    trials=trials,
)
