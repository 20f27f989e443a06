"""What the self-test found: what `symcheck selftest --record` left in generated/selftest.json.

It says of which certificates, verdicts and kernels it is, and has a digest of the counts in it: a file that was changed
by hand is refused.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from symcheck import kernels
from symcheck.core.files import put
from symcheck.kernels.codegen.target import MARK
from symcheck.ledger.digests import digest, digest_of, line, short_digest
from symcheck.ledger.record import Record
from symcheck.ledger.store import SCHEMA, SELFTEST, require, stored

STATUSES = ("planted", "rejected", "accepted", "equivalent", "weaker", "stronger", "open")  # as a result names them
MISFITS = "by dimension"  # the name of the count of faults that dimensions alone expose


@dataclass(frozen=True)
class Row:
    """The counts of a class of faults, of one kind in it, of what was planted in one paper, or of all."""

    name: str
    of: Literal["class", "kind", "paper"]
    counts: Mapping[str, Any]

    @property
    def is_class(self) -> bool:
        return self.of == "class"

    @property
    def rate(self) -> str:
        """Rejected of those that are faults, in per cent with 95 % limits; empty of none."""
        found = self.counts["rejected_of_faults"]
        return f"{100 * found[1]:.2f} % ({100 * found[0]:.2f} to {100 * found[2]:.2f})" if found else ""

    def number(self, name: str) -> str:
        """A count in words: "-" for none."""
        return f"{count:,}" if (count := self.counts.get(name, 0)) else "-"


def rows(result: Mapping[str, Any]) -> list[Row]:
    """A line for each class, behind it its kinds and the papers, if they are counted, and last for all."""
    found = []
    for name, counts in result["classes"].items():
        found.append(Row(name, "class", counts))
        found += [Row(kind, "kind", each) for kind, each in counts["kinds"].items()]
        found += [Row(f"in {paper}", "paper", each) for paper, each in counts.get("papers", {}).items()]
    return [*found, Row("all", "class", result)]


def evidence(records: Iterable[Record], folder: Path | None = None) -> dict[str, str]:
    """What a self-test is of, in digests: all certificates with their proofs, all verdicts, the kernels in a folder."""
    rows = list(records)
    folder = folder or kernels.folder()
    texts = sorted(file for file in folder.glob("*.py") if MARK in file.read_text(encoding="utf-8"))
    return {
        "certificates": digest(
            sorted(digest_of(certificate) for row in rows for certificate in row.all_certificates())
        ),
        "ledger": digest(sorted(line([row.id, row.verdict, row.reading]) for row in rows)),
        "kernels": digest(short_digest(file.read_text(encoding="utf-8")) for file in texts),
    }


def recorded(folder: Path) -> dict[str, Any] | None:
    """What is recorded, with the digests of its evidence under "evidence"; None if nothing is.

    SymcheckError if it cannot be read, or was changed by hand.
    """
    return stored(folder / SELFTEST, _read, "delete it, or run `symcheck selftest --record`")


def _read(text: bytes) -> dict[str, Any]:
    data: dict[str, Any] = json.loads(text)
    known = data["schema"] == SCHEMA and data["classes"] and {**data["evidence"]}
    require(known, f"it is not of schema {SCHEMA}")
    require(data["digest"] == _seal(data), "its counts are not those that its digest is of")
    return data


def _seal(data: Mapping[str, Any]) -> str:
    return short_digest(line({key: value for key, value in data.items() if key != "digest"}))


def files(folder: Path) -> dict[str, bytes]:
    """What is to stay in `folder`: a result says itself of which evidence it is."""
    return {SELFTEST: (folder / SELFTEST).read_bytes()} if recorded(folder) else {}


def outdated(folder: Path, records: Iterable[Record]) -> list[str]:
    """A line if what is recorded was found with other evidence than there is now."""
    if (found := recorded(folder)) is None:
        return []
    now = evidence(records, folder)
    others = [name for name in now if found["evidence"].get(name) != now[name]]
    return [f"{SELFTEST}: of other {', '.join(others)}; run `symcheck selftest --record`"] if others else []


def record(folder: Path, result: Mapping[str, Any], records: Iterable[Record]) -> Path:
    """Write a result whole; the findings are left out, as the ledger has them."""
    kept = {key: value for key, value in result.items() if key != "findings"}
    kept = json.loads(json.dumps({**kept, "evidence": evidence(records, folder)}))
    text = json.dumps({"digest": _seal(kept), **kept}, ensure_ascii=False, indent=1)
    put(folder / SELFTEST, f"{text}\n".encode())
    return folder / SELFTEST
