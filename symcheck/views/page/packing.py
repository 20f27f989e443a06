"""What is folded: JSON, deflated and written as text, unfolded by the browser's own DecompressionStream.

Two characters hold 13 bits, the lowest first: 91 printable characters are left without "<", "&" and the backslash, and
91^2 > 2^13. That is a thirteenth shorter than in base 64.
"""

from __future__ import annotations

import base64
import json

import deflate
from markupsafe import Markup

DIGITS = "".join(chr(code) for code in range(33, 127) if chr(code) not in "<&\\")
BITS = 13  # packed in two digits, 2^13 = 8192 of 91^2 = 8281 pairs
PAIRS = [DIGITS[n % 91] + DIGITS[n // 91] for n in range(1 << BITS)]
CHUNK = BITS * 100  # bytes, which make 800 whole pairs: no number gets long


def packed(data: object) -> Markup:
    """The data as deflated JSON, for the text of a <script>, which needs no escapes."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    deflated = bytes(deflate.zlib_compress(text.encode(), 12))  # a twelfth shorter than by zlib, in a second a megabyte
    parts = []
    for start in range(0, len(deflated), CHUNK):
        part = deflated[start : start + CHUNK]
        number = int.from_bytes(part, "little")
        for _ in range(-(-8 * len(part) // BITS)):
            parts.append(PAIRS[number & (1 << BITS) - 1])
            number >>= BITS
    surplus = BITS * len(parts) // 8 - len(deflated)  # a byte of zeros; a single digit at the end marks it as padding
    return Markup("".join(parts) + DIGITS[0] * surplus)


def address(kind: str, data: bytes) -> Markup:
    """A file as an address that holds it whole."""
    return Markup(f"data:{kind};base64,{base64.b64encode(data).decode()}")
