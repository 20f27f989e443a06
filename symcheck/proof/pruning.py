"""Proofs without the assumptions that they make no use of."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


def without(proof: Any, numbers: Sequence[int]) -> Any:
    """The proof without the assumptions of consecutive numbers, later ones renumbered; None if it refers to them."""
    if isinstance(proof, dict):
        parts = {key: without(part, numbers) for key, part in proof.items()}
        return None if None in parts.values() else parts
    if not isinstance(proof, list):
        return proof
    if len(proof) == 2 and proof[0] == "here":
        shift = len(numbers) if proof[1] >= numbers[0] else 0
        return None if proof[1] in numbers else ["here", proof[1] - shift]
    each = [without(part, numbers) for part in proof]
    return None if None in each else each
