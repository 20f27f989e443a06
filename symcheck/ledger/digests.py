"""Text that depends on a value alone, and digests of it."""

from __future__ import annotations

import json
from collections.abc import Iterable
from hashlib import sha256

from symcheck.core.certificates import Certificate

DIGITS = 16  # of a digest: enough where nobody constructs collisions


def short_digest(text: str) -> str:
    """The beginning of the SHA-256 of a text."""
    return sha256(text.encode()).hexdigest()[:DIGITS]


def line(value: object) -> str:
    """JSON that depends on the value alone."""
    return json.dumps(value, sort_keys=True, ensure_ascii=False, separators=(",", ":"))


def digest(digests: Iterable[str]) -> str:
    """One digest for several."""
    return short_digest("\n".join(digests))


def digest_of(certificate: Certificate) -> str:
    """The digest of a certificate, its proof included."""
    return short_digest(line(certificate))
