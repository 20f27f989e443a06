"""The dependencies between the claims of a paper as arcs: claims in printed order down a line, an arc for each use."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log2
from textwrap import shorten

from symcheck.core.ids import Id
from symcheck.core.verdicts import Verdict
from symcheck.ledger import Record
from symcheck.views.model import Relation

STEP, LEFT, WIDEST = 17, 310, 400  # of the drawing, in pixels: between two claims, before the line, the largest arc

LETTERS = 30  # of a name


@dataclass(frozen=True)
class Node:
    """A declaration, or all rows of a list: those of one name in a section are drawn as one."""

    id: str
    label: str
    name: str  # cut short where it is long
    verdict: str
    y: int


@dataclass(frozen=True)
class Arc:
    """What `to` uses: the number of each node, and the curve."""

    used: int
    by: int
    path: str


@dataclass(frozen=True)
class Graph:
    """The drawing of one paper."""

    paper: str
    nodes: tuple[Node, ...]
    arcs: tuple[Arc, ...]
    left: int = LEFT

    @property
    def height(self) -> int:
        """In pixels."""
        return STEP * (len(self.nodes) + 1)

    @property
    def width(self) -> int:
        """In pixels."""
        return LEFT + WIDEST


def graph(paper: str, records: Sequence[Record]) -> Graph:
    """The dependencies between the claims of a paper; claims that use nothing and are not used are left out."""
    together: dict[tuple[str, str], list[Record]] = {}
    for record in records:
        together.setdefault((record.section, record.name or record.declaration), []).append(record)
    owner = {
        name: key for key, members in together.items() for member in members for name in (member.id, member.declaration)
    }
    pairs = {
        (owner[used], key)
        for key, members in together.items()
        for member in members
        for used in member.uses
        if used in owner and owner[used] != key
    }
    shown = [key for key in together if any(key in pair for pair in pairs)]
    place = {key: number for number, key in enumerate(shown)}
    nodes = tuple(_node(together[key], STEP * (place[key] + 1)) for key in shown)
    arcs = sorted((place[used], place[by]) for used, by in pairs)
    return Graph(paper, nodes, tuple(Arc(used, by, _curve(nodes[used].y, nodes[by].y)) for used, by in arcs))


def _node(members: Sequence[Record], y: int) -> Node:
    ids = [Id.parse(member.id) for member in members]
    label = ids[0].number if len({id.number for id in ids}) == 1 else ids[-1].listing.number
    verdicts = {member.verdict for member in members}
    worst = next((each for each in (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.PROVED) if each in verdicts), None)
    first = Relation(members[0])
    return Node(first.record.id, label, shorten(first.name, LETTERS, placeholder="…"), worst or first.state, y)


def _curve(one: int, other: int) -> str:
    """A curve that bulges the more the farther apart its ends are."""
    bulge = LEFT + 12 + round(min(WIDEST, 22 * log2(1 + abs(other - one) / STEP) ** 1.45))
    return f"M{LEFT} {one}C{bulge} {one} {bulge} {other} {LEFT} {other}"
