"""The certificates of the ledger as JSON data, as `symcheck.checker` reads them. What proofs are made of, it knows."""

from __future__ import annotations

from typing import NotRequired, TypeAlias, TypedDict

from symcheck.core.terms import JSON

Form: TypeAlias = list[JSON]  # a formula or a compound term, as `symcheck.core.terms` writes it
Step: TypeAlias = dict[str, JSON]  # of a proof, with those above it


class Point(TypedDict):
    """A point, closed terms for its letters, and what is shown there, which is computed or has a proof."""

    values: dict[str, JSON]
    shown: NotRequired[list[Form]]
    calls: NotRequired[JSON]
    functions: NotRequired[JSON]
    proof: NotRequired[Step]


class Certificate(TypedDict):
    """A claim with what it means and rests on, and either the proof of it or the point that refutes it."""

    id: str
    verdict: str
    claim: Form
    definitions: list[tuple[str, JSON]]
    hypotheses: dict[str, list[Form]]
    proof: NotRequired[Step]
    nonzero: NotRequired[list[JSON]]  # what must not vanish where it holds
    witnesses: NotRequired[list[Point]]  # where all that is supposed holds together
    lemmas: NotRequired[list[tuple[str, Form]]]  # id and formula of each relation it rests on
    point: NotRequired[Point]


class MatrixProof(TypedDict):
    """An equation between matrices of all sizes with its proof; terms are those of `symcheck.core.matrices`."""

    id: str
    verdict: str
    matrices: dict[str, list[int | str]]  # the shape of each letter
    hypotheses: dict[str, list[JSON]]
    inverses: dict[str, JSON]  # what letters are the inverses of
    claim: list[JSON]
    proof: list[list[JSON]]  # each a fact, and a term that vanishes with it
    witness: dict[str, list[int]]  # fractions for which all that is assumed is so
