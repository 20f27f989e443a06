"""What Coq says of a record: read from what `make coq` leaves, and only if it was said of these certificates."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from symcheck.evidence.record import Record
from symcheck.statement import SymcheckError, Verdict

FILE = Path("build/coq/confirmed.json")
NOT_TRIED = "not tried"


def confirmed(record: Record, file: Path = FILE, corrected: bool = False) -> str:
    """ "yes", "no: " with the reason, or "not tried", of a proved relation or of what a wrong one should be."""
    own = (record.erratum or {}).get("certificates") or () if corrected else record.certificates
    digests = [each["digest"] for each in own if each["verdict"] == Verdict.PROVED]
    said = _said(file).get(f"{record.id}, corrected" if corrected else record.id)
    if not digests or said is None or said["certificates"] != digests:
        return NOT_TRIED
    return "yes" if said["confirmed"] else f"no: {said['reason']}"


@cache
def _said(file: Path) -> dict[str, Any]:
    try:
        found: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except (OSError, ValueError) as error:
        raise SymcheckError(f"{file} cannot be read ({error}); delete it, or run `make coq` again") from error
    return found
