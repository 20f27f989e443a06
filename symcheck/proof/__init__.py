"""Proof methods: untrusted search, exact results, certificates for the checker."""

from symcheck.proof.certificate import certificate
from symcheck.proof.counterexample import refute
from symcheck.proof.methods import cases, existence, identity, nonnegative
from symcheck.proof.variants import equivalent, needed

__all__ = ["cases", "certificate", "equivalent", "existence", "identity", "needed", "nonnegative", "refute"]
