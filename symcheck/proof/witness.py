"""Witnesses: an exact point at which everything a statement rests on holds together, so that it is not true for want
of a case.

A witness is a counterexample to "0 = 1", and is found as one: its form is that of a counterexample's point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from symcheck.proof.counterexample import refute
from symcheck.proof.polynomial import alone, subterms
from symcheck.proof.theorems import BINDING, conjuncts
from symcheck.statement import Certificate, Formula, Outcome, Problem, Term

FALSE: Formula = ("=", 0, 1)
MAX_FORMULAS = 400
Prover = Callable[[Problem], Outcome | None]
Definitions = tuple[tuple[str, Term], ...]
_DOMAINS: dict[str, Callable[..., Formula]] = {
    "/": lambda _, bottom: ("!=", bottom, 0),
    "sqrt": lambda radicand: (">=", radicand, 0),
    "log": lambda number: (">", number, 0),
    "gamma": lambda number: (">", number, 0),
    "tan": lambda angle: ("!=", ("cos", angle), 0),
    "pow": lambda base, _: (">", base, 0),
    "arcsin": lambda sine: ("<=", ("^", sine, 2), 1),
    "arccos": lambda cosine: ("<=", ("^", cosine, 2), 1),
}


def implications(claim: Formula) -> list[Formula]:
    """The premises of a claim that is an implication, or a conjunction with implications."""
    return [part[1] for part in conjuncts(claim) if part[0] == "=>"]


def find_witnesses(problem: Problem, nonzero: Sequence[Term], prove: Prover) -> list[Certificate] | None:
    """Points where the hypotheses hold, definitions have values and the terms `nonzero` are not zero; None if none.

    One point for all implications of the claim, where their premises hold too; or, where there is no such point or it
    is not found, one for each of them.
    """
    premises = implications(problem.claim)
    together = _witness(problem, nonzero, premises, prove)
    if together is not None or len(premises) < 2:
        return None if together is None else [together]
    each = [_witness(problem, nonzero, [premise], prove) for premise in premises]
    found = [point for point in each if point is not None]
    return found if len(found) == len(each) else None


def _witness(problem: Problem, nonzero: Sequence[Term], premises: Sequence[Formula], prove: Prover) -> Any:
    stated = [part for _, formulas in problem.hypotheses for formula in formulas for part in conjuncts(formula)]
    stated += [part for premise in premises for part in conjuncts(premise)]
    stated += [("!=", term, 0) for term in nonzero]
    definitions = dict(problem.definitions)
    reached = [term for name, term in problem.definitions]
    conditions = [condition for node in (*stated, *reached) for condition in _domains(node)]
    said = tuple(dict.fromkeys((*stated, *conditions)))
    used = {part for formula in said for part in subterms(unfold_names(formula, definitions)) if isinstance(part, str)}
    return _search(tuple((x, term) for x, term in problem.definitions if x in used), said, prove)


def unfold_names(node: Any, definitions: dict[str, Term]) -> tuple[Any, ...]:
    """A node made of all the parts of a formula and of the definitions it rests on."""
    open_, seen = [node], set[str]()
    parts: list[Any] = []
    while open_:
        parts.append(part := open_.pop())
        names = {name for name in subterms(part) if isinstance(name, str)} & definitions.keys() - seen
        open_ += [definitions[name] for name in sorted(names)]
        seen |= names
    return ("", *parts)


def _domains(node: Any) -> Iterator[Formula]:
    """What must hold for a term or formula to have a value."""
    if not isinstance(node, tuple) or node[0] in BINDING:
        return
    if node[0] in _DOMAINS:
        yield _DOMAINS[node[0]](*node[1:])
    if node[0] == "^" and node[2] < 0:
        yield "!=", node[1], 0
    for part in node[1:]:
        yield from _domains(part)


_FOUND: dict[Any, Certificate | None] = {}


def _search(definitions: Definitions, said: tuple[Formula, ...], prove: Prover) -> Certificate | None:
    key = definitions, said
    if key not in _FOUND:
        problem = Problem("witness", FALSE, definitions, (("said", said),))
        with alone(problem):
            point = refute(problem, prove)
        _FOUND[key] = None if point is None else {name: part for name, part in point.items() if name != "sides"}
    return _FOUND[key]
