"""What tests ask of a declaration of any class."""

from __future__ import annotations

from collections.abc import Mapping

from symcheck.core.claims import Assertion, Claim, Declaration, Erratum, Hypothesis


def errata(item: Declaration) -> Mapping[str, Erratum]:
    """By link letter what is wrong with it; nothing but a claim can be wrong."""
    return item.errata if isinstance(item, Claim) else {}


def hypotheses(item: Declaration) -> tuple[Hypothesis, ...]:
    """All hypotheses it speaks of."""
    return item.hypotheses if isinstance(item, Assertion) else ()


def formulas(item: Declaration) -> tuple[str, ...]:
    """All LaTeX of a declaration but for its hypotheses: printed, read instead, stated, corrected."""
    damage = item.source.damage
    corrected = (each.corrected for each in errata(item).values() if each.corrected)
    return (*item.source.printed, *([damage.read_as] if damage else []), *item.stated, *corrected)
