"""What is folded: JSON, deflated and written as text, unfolded by the browser's own DecompressionStream."""

from __future__ import annotations

import base64
import json
import zlib
from typing import Any

from markupsafe import Markup


def packed(data: Any) -> Markup:
    """The data as base64 of deflated JSON, which needs no escape in HTML."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return Markup(base64.b64encode(zlib.compress(text.encode(), 9)).decode())


def unpacked(text: str) -> Any:
    """The inverse of `packed`."""
    return json.loads(zlib.decompress(base64.b64decode(text)))


def address(kind: str, data: bytes) -> Markup:
    """A file as an address that holds it whole."""
    return Markup(f"data:{kind};base64,{base64.b64encode(data).decode()}")
