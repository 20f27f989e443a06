"""How a notebook that was executed differs from the one that is committed: sources, values and LaTeX, not pictures."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from symcheck.views.notebook.output import PNG

if TYPE_CHECKING:
    from nbformat import NotebookNode

TOLERANCE = 2e-5  # relative, of decimals that are shown with six digits
_DECIMAL = re.compile(r"-?\d+\.\d+(?:e[+-]?\d+)?|-?\d+e[+-]?\d+")  # numbers that may differ by rounding


def differences(executed: NotebookNode, committed: NotebookNode) -> Iterator[str]:
    """One line for each cell that was added, left out or changed, or shows something else."""
    now, before = ({cell.id: cell for cell in each.cells} for each in (executed, committed))
    if executed.metadata != committed.metadata:
        yield "its metadata differ"
    if [id for id in now if id in before] != [id for id in before if id in now]:
        yield "its cells stand in another order"
    for id in [*now, *(id for id in before if id not in now)]:
        if id not in before:
            yield f"cell {id} is new"
        elif id not in now:
            yield f"cell {id} is not in its source any more"
        elif difference := _difference(now[id], before[id]):
            yield f"cell {id} {difference}"


def _difference(now: NotebookNode, before: NotebookNode) -> str:
    if (now.cell_type, now.source) != (before.cell_type, before.source):
        return "has another source"
    found, kept = ([output.data for output in cell.get("outputs", ())] for cell in (now, before))
    if [set(data) for data in found] != [set(data) for data in kept]:
        return "shows something of another kind"
    for new, old in zip(found, kept, strict=True):
        for kind in new:
            if kind != PNG and not same(new[kind], old[kind]):
                return f"shows other {kind}: {_first(new[kind], old[kind])}"
    return ""


def same(new: str, old: str) -> bool:
    """Equal texts, but for the last digits of decimals."""
    if new == old:
        return True
    if _DECIMAL.sub("#", new) != _DECIMAL.sub("#", old):
        return False
    pairs = zip(_DECIMAL.findall(new), _DECIMAL.findall(old), strict=True)
    return all(math.isclose(float(x), float(y), rel_tol=TOLERANCE) for x, y in pairs)


def _first(new: str, old: str) -> str:
    lines = zip(new.splitlines(), old.splitlines(), strict=False)
    pair = next(((x, y) for x, y in lines if not same(x, y)), ("more or fewer lines", ""))
    return " instead of ".join(json.dumps(each, ensure_ascii=False)[:100] for each in pair if each)
