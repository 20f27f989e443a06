"""From declarations to verdicts: what there is to decide, deciding, and the check of every certificate."""
