"""What everything else speaks in, on the standard library alone: terms, formulas, declarations, verdicts."""
