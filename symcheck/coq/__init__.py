"""Coq: the proved claims as statements over the reals, their certificates as proofs that Coq's kernel checks.

Claims.v    the statements alone, in printed order and shape: the only file to read
Proofs*.v   a proof of each, made by machine
Witnesses.v a point for each set of hypotheses, so that none of them says nothing
Symcheck.v  the lemmas and tactics behind the proofs
Theorems.v  what the checker takes for granted, proved; the proofs apply it

`files` writes them, `compile` has Coq check them, `confirmed` reads what came out; `reader` reads the statements back,
`meaning` evaluates them, `comparison` compares both with the ledger.
"""

__all__ = ["comparison", "compile", "confirmed", "files", "meaning", "reader"]
