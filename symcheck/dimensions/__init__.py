"""Dimensions: what the letters of a relation measure, and whether its terms fit together."""

from symcheck.dimensions.rules import Known, Linear, Scale, form_of
from symcheck.dimensions.units import dimension, shown
from symcheck.dimensions.verdict import (
    CONSISTENT,
    INCONSISTENT,
    UNDETERMINED,
    Dimensions,
    dimensions,
    inferred,
    of_printed,
    shown_form,
)

__all__ = [
    "CONSISTENT",
    "INCONSISTENT",
    "UNDETERMINED",
    "Dimensions",
    "Known",
    "Linear",
    "Scale",
    "dimension",
    "dimensions",
    "form_of",
    "general",
    "inferred",
    "of_printed",
    "rules",
    "shown",
    "shown_form",
]
