"""The ledger as one JSON object: every item whole, the errata by id, the weightiest first, and what Coq says."""

from __future__ import annotations

import json
from collections.abc import Sequence

from symcheck.coq.confirmed import confirmed
from symcheck.ledger import Record
from symcheck.views.exports import Format
from symcheck.views.model import errata


def text(records: Sequence[Record]) -> str:
    """`{"schema": 1, "items": [...], "errata": {group: [ids]}, "coq": {id: "yes"}}`, items as in `check --json`."""
    items = ",\n".join(json.dumps(record.to_json(), ensure_ascii=False) for record in records)
    found = {
        str(group): [relation.record.id for faults in lists for relation in faults.relations]
        for group, lists in errata(records)
    }
    coq = json.dumps({name: said for record in records for name, said in confirmed(record).items()})
    return f'{{"schema": 1, "items": [\n{items}\n], "errata": {json.dumps(found)}, "coq": {coq}}}\n'


FORMAT = Format("everything that is known, certificates too", text)
