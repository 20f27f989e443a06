"""The ledger as one JSON object: every item whole, and the errata by id, the weightiest first."""

from __future__ import annotations

import json
from collections.abc import Sequence

from symcheck.evidence.faults import errata
from symcheck.evidence.record import Record
from symcheck.export import Format


def text(records: Sequence[Record]) -> str:
    """`{"schema": 1, "items": [...], "errata": {group: [ids]}}`, an item on each line as in `symcheck check --json`."""
    items = ",\n".join(json.dumps(record.to_json(), ensure_ascii=False) for record in records)
    found = {
        str(group): [each.id for alike in members for fault in alike.faults for each in fault.records]
        for group, members in errata(records)
    }
    return f'{{"schema": 1, "items": [\n{items}\n], "errata": {json.dumps(found)}}}\n'


FORMAT = Format("everything that is known, certificates too", text)
