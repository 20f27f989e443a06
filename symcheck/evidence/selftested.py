"""What the self-test found: what `symcheck selftest --record` left in generated/selftest.json."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from symcheck.evidence.checked import certificates
from symcheck.evidence.confirmed import digest
from symcheck.evidence.record import Record
from symcheck.evidence.store import SCHEMA, SELFTEST, replace
from symcheck.statement import SymcheckError


@dataclass(frozen=True)
class Row:
    """The counts of a class of faults, of one kind in it, or of all."""

    name: str
    is_class: bool
    counts: Mapping[str, Any]

    @property
    def rate(self) -> str:
        """Rejected of those that are faults, in per cent with 95 % limits; empty of none."""
        found = self.counts["rejected_of_faults"]
        return f"{100 * found[1]:.2f} % ({100 * found[0]:.2f} to {100 * found[2]:.2f})" if found else ""


def rows(result: Mapping[str, Any]) -> list[Row]:
    """A line for each class, its kinds behind it, and last for all."""
    found = []
    for name, counts in result["classes"].items():
        found.append(Row(name, True, counts))
        found += [Row(kind, False, each) for kind, each in counts["kinds"].items()]
    return [*found, Row("all", True, result)]


def evidence(records: Iterable[Record]) -> str:
    """One digest of all certificates."""
    return digest(sorted(each["digest"] for record in records for each in certificates(record)))


def recorded(folder: Path) -> dict[str, Any] | None:
    """What is recorded, with the digest of its evidence under "evidence"; None if nothing is."""
    file = folder / SELFTEST
    try:
        data: dict[str, Any] = json.loads(file.read_bytes())
        if data["schema"] != SCHEMA or not data["classes"] or not data["evidence"]:
            raise ValueError(f"it is not of schema {SCHEMA}")
    except FileNotFoundError:
        return None
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise SymcheckError(
            f"{file} cannot be read ({error}); delete it, or run `symcheck selftest --record`"
        ) from error
    return data


def files(folder: Path) -> dict[str, bytes]:
    """What is to stay in `folder`: a result says itself of which evidence it is."""
    return {SELFTEST: (folder / SELFTEST).read_bytes()} if recorded(folder) else {}


def record(folder: Path, result: Mapping[str, Any], records: Iterable[Record]) -> Path:
    """Write a result whole; the findings are left out, as the ledger has them."""
    kept = {"evidence": evidence(records), **{key: value for key, value in result.items() if key != "findings"}}
    text = json.dumps(kept, ensure_ascii=False, indent=1)
    replace(folder / SELFTEST, f"{text}\n".encode())
    return folder / SELFTEST
