"""True statements written otherwise: reordered, expanded, factored, renamed. None of them may be rejected."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice
from random import Random
from typing import Any

from symcheck.evidence.judge import judge
from symcheck.proof.theorems import CONSTANTS
from symcheck.selftest.evidence import answered, told_of
from symcheck.selftest.statements import Proved, places, proved
from symcheck.selftest.trial import Fate, FaultClass, Trial, mixed
from symcheck.statement import Formula, Problem, Term, Verdict

RENAMED = "renamed"
FIRST = {"exists": 2, "call": 3}  # the first part that is a term or formula
Rewriting = tuple[str, Proved, int, Formula]


def rewritings(value: Any, rng: Random) -> Iterator[tuple[str, Any]]:
    """The same formula (or term) with one sum or product in it written otherwise."""
    if not isinstance(value, tuple):
        return
    yield from _here(value, rng)
    for k, part in enumerate(value):
        if k >= FIRST.get(value[0], 1):
            for kind, new in rewritings(part, rng):
                yield kind, (*value[:k], new, *value[k + 1 :])


def _here(value: tuple[Any, ...], rng: Random) -> Iterator[tuple[str, Any]]:
    head, *parts = value
    if head in ("+", "*", "and", "or") and len(parts) > 1:
        yield "reordered", (head, *rng.sample(parts, len(parts)))
    if head == "*":
        yield from (("expanded", new) for new in _multiplied_out(parts))
    if head == "+" and len(parts) > 1:
        yield "factored", _factored(parts)


def _multiplied_out(parts: Sequence[Term]) -> Iterator[Term]:
    for k, part in enumerate(parts):
        if isinstance(part, tuple) and part[0] == "+":
            yield ("+", *(("*", *parts[:k], addend, *parts[k + 1 :]) for addend in part[1:]))


def _factored(parts: Sequence[Term]) -> Term:
    """The first factor that two addends have in common before a bracket; else a sign before it."""
    for k, first in enumerate(parts):
        for n in range(k):
            shared = next((f for f in _factors(first) if f in _factors(parts[n])), None)
            if shared is not None:
                both = ("*", shared, ("+", _divided(parts[n], shared), _divided(first, shared)))
                rest = [part for m, part in enumerate(parts) if m not in (k, n)]
                return ("+", both, *rest) if rest else both
    return ("-", ("+", *(("-", part) for part in parts)))


def _factors(term: Term) -> tuple[Term, ...]:
    if isinstance(term, tuple) and term[0] == "-":
        return _factors(term[1])
    return term[1:] if isinstance(term, tuple) and term[0] == "*" else ()


def _divided(term: Any, factor: Term) -> Term:
    if term[0] == "-":
        return ("-", _divided(term[1], factor))
    k = term.index(factor, 1)
    return ("*", *term[1:k], *term[k + 1 :]) if len(term) > 2 else 1


def renamed(problem: Problem) -> Problem:
    """The same problem with another name for each letter: a "q" before it."""
    hints = tuple((_renamed_hint(name), _renamed(value)) for name, value in problem.hints)
    hypotheses = tuple((name, tuple(map(_renamed, formulas))) for name, formulas in problem.hypotheses)
    definitions = tuple((_renamed(name), _renamed(term)) for name, term in problem.definitions)
    return Problem(problem.id, _renamed(problem.claim), definitions, hypotheses, hints)


def _renamed(value: Any) -> Any:
    if isinstance(value, str):
        return value if value in CONSTANTS else f"q{value}"
    if not isinstance(value, tuple):
        return value
    if value[0] == "exists":
        return ("exists", tuple(map(_renamed, value[1])), _renamed(value[2]))
    if value[0] == "call":
        return ("call", _renamed(value[1]), value[2], *map(_renamed, value[3:]))
    return (value[0], *map(_renamed, value[1:]))


def _renamed_hint(name: str) -> str:
    for prefix in ("point_", "point."):
        if name.startswith(prefix):
            return f"{prefix}{_renamed(name.removeprefix(prefix))}"
    return name


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many other forms of the relations of one declaration."""
    by_kind: dict[str, list[Rewriting]] = defaultdict(list)
    for original in proved(place):
        for n, formula in enumerate(original.unit.formulas):
            for kind, new in rewritings(formula, rng):
                if new != formula:
                    by_kind[kind].append((kind, original, n, new))
            if not original.context.item.lemmas:
                by_kind[RENAMED].append((RENAMED, original, n, formula))
    for kind, original, n, formula in islice(mixed(by_kind, rng), count):
        right = _renaming_is_proved(original, n) if kind == RENAMED else _is_proved(original, n, formula)
        yield Trial(kind, f"{original.id} as {formula}", Fate.KEPT if right else Fate.FALSELY_REJECTED)


def _is_proved(original: Proved, n: int, formula: Formula) -> bool:
    context, unit, given, _ = original
    formulas = (*unit.formulas[:n], formula, *unit.formulas[n + 1 :])
    finding = judge(context, replace(unit, formulas=formulas), given)
    return told_of(context, unit, finding) is Verdict.PROVED


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
