"""Proof methods: untrusted search, exact results, certificates for the checker."""

from symcheck.proof.certificate import certificate, digest
from symcheck.proof.counterexample import refute
from symcheck.proof.methods import cases, existence, identity, nonnegative, proof_of
from symcheck.proof.variants import equivalent, needed

__all__ = [
    "cases",
    "certificate",
    "digest",
    "equivalent",
    "existence",
    "identity",
    "needed",
    "nonnegative",
    "proof_of",
    "refute",
]
