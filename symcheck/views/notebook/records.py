"""Records and declarations by id, from the cache or decided here and now; verdicts recorded in generated/expected."""

from __future__ import annotations

from functools import cache

from symcheck import kernels, papers
from symcheck.audit import check, expand, obligation_of
from symcheck.core.claims import Claim, Declaration, Erratum, Paper
from symcheck.core.ids import Id
from symcheck.core.verdicts import SLIPS, Group, Origin, SymcheckError, Verdict
from symcheck.ledger import Record, store
from symcheck.reading import Notation


def records(id: str) -> tuple[Record, ...]:
    """The records of a relation, or of all links of a chain; SymcheckError with the nearest id if there is none."""
    found = tuple(record for record in decided(id) if id in (record.id, record.declaration))
    if not found:
        raise SymcheckError(f"there is no relation {id}; there are {', '.join(record.id for record in decided(id))}")
    return found


def decided(id: str) -> tuple[Record, ...]:
    """All records of the declaration to which a relation or a link belongs."""
    return _audited((_declaration(id),))


def _declaration(id: str) -> str:
    return str(Id.parse(id).declaration)


def list_rows(id: str) -> tuple[tuple[Record, ...], ...]:
    """The records of each row of a list or table, "ignatov2005:2.1V"."""
    rows: dict[str, list[Record]] = {}
    for record in _audited((id,)):
        rows.setdefault(record.declaration, []).append(record)
    return tuple(map(tuple, rows.values()))


def group_of(erratum: Erratum) -> Group:
    """Which errata a declared one belongs to, before anything is decided."""
    if erratum.kind in SLIPS:
        return Group.SLIP
    return Group.ROW if erratum.shown else Group.STATEMENT


def serious(key: str) -> tuple[Record, ...]:
    """The records of wrong formulas and statements of a paper, in printed order."""
    found = _audited(tuple(str(Id(key, each.number)) for _, each in declared(key) if _may_be_serious(each)))
    return tuple(record for record in found if record.group is Group.STATEMENT)


def _may_be_serious(item: Declaration) -> bool:
    """Whether a printed relation says something else than is right, or says nothing by its author's fault."""
    groups = map(group_of, item.errata.values() if isinstance(item, Claim) else ())
    damage = item.source.damage
    return Group.STATEMENT in groups or (damage is not None and damage.origin is Origin.PAPER)


@cache
def _audited(ids: tuple[str, ...]) -> tuple[Record, ...]:
    return tuple(check(ids, warn=lambda said: None))  # readers need not know what is decided again


def item(id: str) -> Declaration:
    """The declaration of a relation or of the chain of which it is a link."""
    return obligation_of(_declaration(id)).item


def paper(key: str) -> Paper:
    """The paper of this key."""
    return papers.load()[key]


def notation(id: str) -> Notation:
    """The letters of a declaration."""
    return item(id).notation or paper(Id.parse(id).paper).notation


def declared(key: str) -> tuple[tuple[str, Declaration], ...]:
    """All declarations of a paper with the titles of their sections, in printed order."""
    return tuple((each.section.title, each.item) for each in expand(paper(key)))


def recorded(key: str) -> dict[str, Verdict | None]:
    """The recorded verdicts of a paper by id."""
    return store.expected(kernels.folder(), key)
