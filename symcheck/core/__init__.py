"""Terms, formulas and derivatives: what the checker and those who look for proofs have in common."""
