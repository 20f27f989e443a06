"""Exact algebra that the search for proofs rests on: polynomials, ideals, signs, and what is known at one place."""
