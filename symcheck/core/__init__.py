"""What everything else speaks in, on the standard library alone: terms, formulas, declarations, verdicts.

Its names stand in its modules; nothing is imported here, as the checker starts with this package.
"""

__all__ = [
    "calculus",
    "certificates",
    "claims",
    "counts",
    "extras",
    "fields",
    "files",
    "formulas",
    "ids",
    "interrupts",
    "lazy",
    "matrices",
    "problems",
    "terms",
    "verdicts",
    "words",
]
