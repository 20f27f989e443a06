"""Printed errors on the polytope: which vertex, edge or face the row of a list speaks of, by the momenta it gives."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from symcheck.core.verdicts import Group
from symcheck.ledger import Record
from symcheck.views.model import errata, listing

_MOMENTA = re.compile(r"\\mathbf\{H\}\s*=\s*\[([^\]]*)\]")  # the momenta at a vertex or edge: "\mathbf{H} = [1, -1, u]"
_LABEL = re.compile(r"([VF])(')?_\{?(\d+)\}?(')?")  # a vertex or a face, with a prime on either side of the index
_FREE = {"u": "0", "v": "0"}


def marks(envelope: Mapping[str, Any], records: Iterable[Record]) -> list[dict[str, Any]]:
    """The errata of the lists of an envelope: the cell each is about, its number, kind and group, the weightiest first.

    A cell is "v", "e" or "f" with its number; rows about a list as a whole have none and are left out.
    """
    lists = {f"{envelope['paper']}:{each}" for each in envelope["lists"]}
    own = [record for record in records if record.corrected and listing(record) in lists]
    known = _cells(envelope)
    found = [
        {
            "cell": cell,
            "id": fault.first.record.id,
            "kind": fault.first.record.kind,
            "slip": group in (Group.SLIP, Group.DAMAGED),
        }
        for group, lists in errata(own)
        for faults in lists
        for fault in faults.faults
        if (cell := known.get(_momenta(fault.first.record)) or known.get(_label(fault.first.record)))
    ]
    return list({(each["cell"], each["id"]): each for each in found}.values())


def _momenta(record: Record) -> str:
    """The momenta a row gives, 0 where a wheel is free: "1 0 -1"; empty if it gives none."""
    given = _MOMENTA.search(record.corrected) or _MOMENTA.search(record.printed)
    return " ".join(_FREE.get(each.strip(), each.strip()) for each in given[1].split(",")) if given else ""


def _label(record: Record) -> str:
    """The label a row of a table begins with, as the vertices are named: "V_2'"."""
    given = _LABEL.search(record.corrected or record.printed)
    return f"{given[1]}_{given[3]}{chr(39) * bool(given[2] or given[4])}" if given else ""


def _cells(envelope: Mapping[str, Any]) -> dict[str, str]:
    """Each vertex, edge and face by the momenta of the wheels there; the vertices by their names too."""
    signs = envelope["signs"]
    found = {name: f"v{k}" for k, name in enumerate(envelope["names"])}
    found |= {_written(zip(each, strict=True)): f"v{k}" for k, each in enumerate(signs)}
    for letter, cells in (("e", envelope["edges"]), ("f", envelope["faces"])):
        found |= {_written(zip(*(signs[v] for v in cell), strict=True)): f"{letter}{k}" for k, cell in enumerate(cells)}
    return found


def _written(columns: Iterable[tuple[int, ...]]) -> str:
    """The momenta that all of several vertices have, 0 where they differ."""
    return " ".join(str(column[0]) if len(set(column)) == 1 else "0" for column in columns)
