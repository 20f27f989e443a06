"""The set over which a verdict was shown, read off its certificates, never off the declaration."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from symcheck.core.verdicts import Certificate, SymcheckError, Verdict
from symcheck.core.words import term


def domain(certificates: Iterable[Certificate]) -> dict[str, list[str]]:
    """The hypotheses that proofs use (or that are in force where a lemma is used), and what must not vanish there."""
    proofs = [each for each in certificates if each.get("verdict") == Verdict.PROVED]
    names = {name for each in proofs for name in each.get("hypotheses", {})}
    conditions = {term(condition) for each in proofs for condition in each.get("nonzero", ())}
    return {"hypotheses": sorted(names), "nonzero": sorted(conditions)}


def refuse_wider(id: str, certificates: Iterable[Certificate], told: Iterable[dict[str, Any]]) -> None:
    """SymcheckError if a proof uses a hypothesis that is not told beside the verdict: it would claim too much."""
    missing = set(domain(certificates)["hypotheses"]) - {hypothesis["name"] for hypothesis in told}
    if missing:
        names = ", ".join(map(repr, sorted(missing)))
        raise SymcheckError(f"{id} is shown under {names}, which the record leaves out; list it in given= or needs=")
