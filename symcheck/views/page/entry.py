"""One record with everything that the page shows with it, and the formulas that may be typeset."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from symcheck.ledger import Record
from symcheck.views.latex import formulas_of
from symcheck.views.model import Fault, Relation
from symcheck.views.page.formulas import Formulas
from symcheck.views.page.sources import Excerpt, Meaning, Publication

LONGEST = 400  # signs of the terms of a general form: about two lines of a formula


@dataclass(frozen=True)
class Entry(Relation):
    """A record with its paper, its kernels, the notebook cells that show it, and what its letters mean."""

    paper: Publication
    kernels: Sequence[Excerpt]
    cells: Sequence[Excerpt]
    letters: Sequence[Meaning] = ()

    @property
    def section(self) -> str:
        """The section's number and title."""
        return " ".join((self.record.section, self.paper.sections.get(self.record.section, ""))).strip()


def general(entry: Entry) -> list[str]:
    """The formulas of the general form, which the page sets; none where they are too long to be read there."""
    forms = entry.record.dimension.general if entry.record.dimension else ()
    written = [json.dumps(each, ensure_ascii=False, separators=(",", ":")) for each in forms]
    return written if sum(map(len, written)) <= LONGEST else []


def texts(records: Iterable[Record]) -> Iterator[str]:
    """All that may be typeset."""
    for record in records:
        yield from (record.printed, record.read, *Fault((Relation(record),)).compared[1:])
        yield from formulas_of(record.reason)
        yield from (hypothesis.states for hypothesis in record.hypotheses)
        yield from (each.relation for each in (record.erratum and record.erratum.repairs) or ())
        if record.erratum:
            yield from formulas_of(f"{record.erratum.summary} {record.erratum.instead}")


def difference(relation: Relation, formulas: Formulas, fallback: bool = False) -> tuple[str, Markup, Markup]:
    """What is wrong, with its label, beside what is right, the differences marked; of a chain the one link."""
    label, before, after = Fault((relation,)).compared
    return label, *formulas.pair(before, after, fallback)
