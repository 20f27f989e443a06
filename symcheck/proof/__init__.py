"""Proof methods: untrusted search, exact results, certificates for the checker."""

from symcheck.proof.search.certificate import Lemmas, certificate
from symcheck.proof.search.counterexample import fails_at
from symcheck.proof.search.equivalence import equivalent
from symcheck.proof.search.methods import (
    cases,
    combined,
    existence,
    find_witnesses,
    identity,
    looking_at,
    nonnegative,
    proof_of,
    refute,
    theorems,
)
from symcheck.proof.search.necessity import Without, fails_without

__all__ = [
    "Lemmas",
    "Without",
    "cases",
    "certificate",
    "combined",
    "equivalent",
    "existence",
    "fails_at",
    "fails_without",
    "find_witnesses",
    "identity",
    "looking_at",
    "nonnegative",
    "proof_of",
    "refute",
    "theorems",
]
