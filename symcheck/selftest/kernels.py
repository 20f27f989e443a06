"""Kernels with one token changed: a constant, an operator, a function or an operand."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import islice
from random import Random

import numpy as np

from symcheck.ledger import Record
from symcheck.selftest.kernel_mutants import CONSTANTS, SYMBOLIC, Forms, Mutant
from symcheck.selftest.kernel_points import crowded_points, random_points
from symcheck.selftest.kernel_truth import Case, Truth, cases
from symcheck.selftest.trial import FaultClass, Status, Trial, mixed

POINTS = 3  # random ones, and as many near degenerate places


@cache
def _prepared(case: Case) -> tuple[Forms, Truth, dict[str, list[Mutant]]]:
    rng = np.random.default_rng(0)
    pairs = zip(*(draw(case.kernel, POINTS, rng) for draw in (random_points, crowded_points)), strict=True)
    found = Forms(case)
    by_kind: dict[str, list[Mutant]] = defaultdict(list)
    for mutant in found.mutants():
        by_kind[kind(mutant)].append(mutant)
    return found, case.truth(tuple(np.concatenate(pair) for pair in pairs)), by_kind


def kind(mutant: Mutant) -> str:
    """Which kind of token is changed."""
    if isinstance(mutant.node, ast.Constant) or mutant.value in CONSTANTS:
        return "constant"
    operator = isinstance(mutant.node, ast.BinOp | ast.UnaryOp) or mutant.value in SYMBOLIC
    return "operator" if operator else "operand"


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """One kernel: its forms as they are, and so many tokens changed."""
    case = cases()[place]
    found, truth, by_kind = _prepared(case)
    for form in found.forms:
        yield Trial("as it is", f"{place} {form}", Status.KEPT if found.right(form, truth) else Status.FALSELY_REJECTED)
    for _, mutant in islice(mixed(by_kind, rng), count):
        yield Trial(kind(mutant), f"{place} {mutant}", status_of(found, mutant, truth))


def status_of(forms: Forms, mutant: Mutant, truth: Truth) -> Status:
    """Whether the values give a mutant away; one with the right values is equivalent if it means the same."""
    if not forms.survives(mutant, truth):
        return Status.REJECTED
    return Status.EQUIVALENT if forms.equivalent(mutant) else Status.ACCEPTED


def _kernels(records: Sequence[Record]) -> list[str]:
    papers = {record.paper for record in records}
    return [id for id, case in cases().items() if case.paper in papers]


CLASS = FaultClass(
    "kernels",
    "kernels with one token changed, before values of 50 digits at a handful of points",
    ("constant", "operator", "operand", "as it is"),
    share=4500,
    places=_kernels,
    trials=trials,
)
