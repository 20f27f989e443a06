"""What the page has folded, unfolded again: the inverse of `symcheck.views.page.packing.packed`."""

from __future__ import annotations

import json
import zlib
from typing import Any

from symcheck.views.page.packing import BITS, DIGITS


def unpacked(text: str) -> Any:
    """The data; zeros behind the end are left alone."""
    values = {digit: value for value, digit in enumerate(DIGITS)}
    number, found = 0, bytearray()
    for k in range(0, len(text) & ~1, 2):
        number |= (values[text[k]] + 91 * values[text[k + 1]]) << BITS * (k // 2 % 8)
        if k // 2 % 8 == 7 or k + 2 == len(text) & ~1:
            found += number.to_bytes(BITS, "little")
            number = 0
    return json.loads(zlib.decompressobj().decompress(bytes(found)))
