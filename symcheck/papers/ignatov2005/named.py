r"""The sentences and tables that name vertices or faces with their distance, as they stand in the source.

Their labels are read like those of the lists, so that a wrong one is found: at its distance, or as one that is named
twice while another is not named at all.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from symcheck.core.claims import Claim
from symcheck.papers import listing
from symcheck.papers.declare import claim
from symcheck.papers.ignatov2005.listed import Block, Declared, permutation
from symcheck.papers.ignatov2005.rows import AND, pattern_of, vector
from symcheck.papers.listing import Label
from symcheck.reading import Notation

_MATH = re.compile(r"\$([^$]+)\$")  # mathematics within a sentence
_PIECE = re.compile(r"\$([^$]+)\$|\.(?=\s)")  # a piece of mathematics, or the end of a sentence
_LABELS = re.compile(r"[VF]['_][^VF]*(,\s*[VF]['_][^VF]*)*")  # labels with commas between them, not an edge `V_1V_2`
_DISTANCE = re.compile(r"\s*d_\d = (?!d_)")  # `d_1 = 4 \sin a`, not `d_1 = d_2`


@dataclass(frozen=True)
class Named:
    """Some vertices or faces with the distance printed for all of them; it is empty where its cell is.

    line     where they are named, or where their distance stands
    printed  their labels verbatim, if they stand on that line
    """

    line: int
    printed: tuple[str, ...]
    labels: tuple[Label, ...]
    distance: str = ""

    @property
    def indices(self) -> tuple[int, ...]:
        """The numbers of the labels, each once: what lies opposite is as far."""
        return tuple(dict.fromkeys(label.index for label in self.labels))

    @property
    def words(self) -> str:
        """What is named, in words."""
        names = [f"{self.labels[0].letter}_{index}" for index in self.indices]
        one = len(names) == 1
        listed = names[0] if one else f"{', '.join(names[:-1])} and {names[-1]}"
        return f"{listed} and {'its opposite' if one else 'their opposites'}"


def _named(line: int, printed: Sequence[str], distance: str = "") -> Named:
    labels = (label for piece in printed for label in listing.labels(piece, line))
    return Named(line, tuple(printed), tuple(labels), distance)


def in_sentence(block: Block) -> tuple[Named, ...]:
    """Labels, and in the same sentence behind them their distance: `$V_1$ and $V'_1$ are $d_1 = 4 \\sin a$ away`."""
    found, pieces = list[Named](), list[str]()
    for match in _PIECE.finditer(block.text):
        piece = (match[1] or "").strip()
        if _LABELS.fullmatch(piece):
            pieces.append(piece)
        elif _DISTANCE.match(piece):
            found.append(_named(block.line, pieces, piece))
            pieces = []
        elif not piece:
            pieces = []
    return tuple(found)


def _cells(block: Block) -> Iterator[tuple[int, list[str]]]:
    """The cells of a table without its headings, line by line."""
    for line, text in enumerate(block.text.split("\n")[1:], block.line + 1):
        yield line, text.split("\t")


def in_columns(block: Block) -> tuple[Named, ...]:
    """A table with pairs of columns, labels and their distance, row by row."""
    found = []
    for line, cells in _cells(block):
        pairs = zip(cells[::2], [*cells[1::2], ""], strict=False)
        found += [_named(line, _pieces(labels), "".join(_pieces(far))) for labels, far in pairs if labels]
    return tuple(found)


def in_rows(block: Block) -> tuple[Named, ...]:
    """A table with its labels in the headings, and the distances below them: it is these that stand on the line."""
    headings, (line, distances) = block.text.split("\n")[0].split("\t"), next(_cells(block))
    found = (_named(block.line, _pieces(labels)) for labels in headings[1:])
    pairs = zip(found, distances[1:], strict=True)
    return tuple(replace(named, line=line, printed=(), distance="".join(_pieces(far))) for named, far in pairs)


def _pieces(cell: str) -> list[str]:
    return [piece.strip() for piece in _MATH.findall(cell)]


def together(*named: Named) -> Named:
    """What shares one cell with a distance that spans several rows."""
    first = named[0]
    printed, labels = (tuple(x for each in named for x in getattr(each, of)) for of in ("printed", "labels"))
    return Named(first.line, printed, labels, next(each.distance for each in named if each.distance))


def faces(of: Declared) -> tuple[str, ...]:
    """The faces F_1, F_2, ... of a list by the momenta of the wheels, "1, 1, u, v"."""
    return tuple(", ".join(pattern_of(signs)) for _, signs in sorted(of.names.faces.items()))


def points(named: Named) -> list[str]:
    """The vertices in a statement."""
    return [vector(label) for label in named.labels]


def every_one_once(number: str, of: Declared, named: Sequence[Named], words: str, notation: Notation) -> Claim:
    """That each vertex, or each face, of a list is named once."""
    labels = [label for each in named for label in each.labels]
    known = of.names.vertices if labels[0].letter == "V" else of.names.faces
    parts = [
        permutation(letter, [label.index for label in labels if label.primed == prime], len(known))
        for letter, prime in (("l_1", False), ("l_2", True))
    ]
    return claim(
        number,
        named[0].line,
        words=words,
        states=AND.join(part.states for part in parts),
        uses=[f"{of.section}{labels[0].letter}.0"],
        notation=notation,
    )


# --- as printed

VERTICES_OF_FOUR = Block(
    164,
    r"""Приведем некоторые метрические характеристики многогранника  $P$ . Все его ребра имеют длину 2. Следовательно, все грани – ромбы. Вершины  $V_1$  и  $V'_1$  находятся на расстоянии  $d_1 = 4 \sin a \sin b$  от начала координат - точки  $O$ , вершины  $V_6$  и  $V'_6$  отстоят от этой точки на расстояние  $d_2 = 4 \sin a \cos b$ , а вершины  $V_7$  и  $V'_7$  на расстояние  $d_3 = 4 \cos a$ . Расстояния до вершин  $V_2, V_3, V_4, V_5$  и  $V'_2, V'_3, V'_4, V'_5$  от точки  $O$  равны  $d_4 = 2$ . Равенство  $d_1 = d_2$  имеет место при  $b = p/4 = 45^\circ$ , равенство  $d_1 = d_2 = d_3$  достигается при одновременном выполнении условий  $a = \arctg \sqrt{2} = 54.7^\circ$  и  $b = p/4 = 45^\circ$ .""",
)

TABLE_3 = Block(
    179,
    r"""Грани	Расстояние	Грани	Расстояние	Грани	Расстояние
$F_1, F'_1$	$\frac{2 \sin 2a \sin b}{\sqrt{1 - \sin^2 a \cos^2 b}}$	$F_2, F'_2$	$\frac{2 \sin 2a \cos b}{\sqrt{1 - \sin^2 a \sin^2 b}}$	$F_3, F'_3$	$2 \sin a \sin 2b$
$F_5, F'_5$	$\frac{2 \sin 2a \sin b}{\sqrt{1 - \sin^2 a \cos^2 b}}$	$F_4, F'_4$	$\frac{2 \sin 2a \cos b}{\sqrt{1 - \sin^2 a \sin^2 b}}$	$F_6, F'_6$""",
)

VERTICES_OF_THREE = Block(
    235,
    r"""Параллелепипед  $P'$  представляет собой многогранник  $P$  с длиной ребер  $V_4V_7'$ ,  $V_1V_5'$ ,  $V_3V_6'$ ,  $V_7V_4$ ,  $V_5V_1$ ,  $V_6V_3$  равной нулю, поскольку именно эти ребра параллельны орту  $e_4$  и, соответственно, оси отключенного маховика. Таким образом, в декартовой системе координат  $OXYZ$ , координаты вершин  $V_4'$ ,  $V_1'$ ,  $V_3'$ ,  $V_4$ ,  $V_1$ ,  $V_3$  параллелепипеда  $P'$  совпадают с координатами середин ребер  $V_4V_7'$ ,  $V_1V_5'$ ,  $V_3V_6'$ ,  $V_7V_4$ ,  $V_5V_1$ ,  $V_6V_3$  многогранника  $P$  соответственно. Приведем некоторые метрические характеристики многогранника  $P'$ . Его ребра имеют длину 2. Следовательно, все грани – ромбы. Вершины  $V_1$  и  $V_1'$  находятся на расстоянии  $d_1 = \sqrt{8\sin^2 a \sin^2 b + 1}$  от начала координат - точки  $O$ , вершины  $V_3$  и  $V_3'$  отстоят от этой точки на расстояние  $d_2 = \sqrt{8\sin^2 a \cos^2 b + 1}$ , а вершины  $V_4$  и  $V_4'$  на расстояние  $d_3 = \sqrt{8\cos^2 a + 1}$ . Расстояния до вершин  $V_2$  и  $V_2'$  от точки  $O$  равны  $d_4 = 1$ . Равенство  $d_1 = d_2$  имеет место при  $b = p/4 = 45^\circ$ , равенство  $d_1 = d_2 = d_3$  достигается при одновременном выполнении условий  $a = \arctg \sqrt{2} = 54.7^\circ$  и  $b = p/4 = 45^\circ$ .""",
)

TABLE_5 = Block(
    243,
    r"""Грани	Расстояние	Грани	Расстояние	Грани	Расстояние
$F_1, F'_1$	$\frac{\sin 2a \sin b}{\sqrt{1 - \sin^2 a \cos^2 b}}$	$F_2, F'_2$	$\frac{\sin 2a \cos b}{\sqrt{1 - \sin^2 a \sin^2 b}}$	$F_3, F'_3$	$\sin a \sin 2b$""",
)

VERTICES_OF_SIX = Block(
    443,
    r"""Приведем некоторые метрические характеристики многогранника  $P$ . Все его ребра имеют длину 2. Следовательно, все грани – ромбы. Вершины  $V_1$  и  $V'_1$  находятся на расстоянии  $d_1 = 6\cos a$  от начала координат - точки  $O$ , вершины  $V_{14}$ ,  $V'_{14}$ ,  $V_{15}$ ,  $V'_{15}$  и  $V_{16}$ ,  $V'_{16}$  отстоят от этой точки на расстояние  $d_2 = 4\sin a$ , а вершины  $V_2$ ,  $V'_2$ ,  $V_3$ ,  $V'_3$ ,  $V_4$ ,  $V'_4$ ,  $V_5$ ,  $V'_5$ ,  $V_6$ ,  $V'_6$  и  $V_7$ ,  $V'_7$  на расстояние  $d_3 = 2\sqrt{3\cos^2 a + 1}$ . Расстояния до вершин  $V_8$ ,  $V'_8$ ,  $V_9$ ,  $V'_9$ ,  $V_{10}$ ,  $V'_{10}$ ,  $V_{11}$ ,  $V'_{11}$ ,  $V_{12}$ ,  $V'_{12}$  и  $V_{13}$ ,  $V'_{13}$  от точки  $O$  равны  $d_4 = 2\sqrt{2\sin^2 a + 1}$ . Соотношения между расстояниями  $d_1$ ,  $d_2$ ,  $d_3$ ,  $d_4$  выражаются неравенствами, приведенными в табл. 7.""",
)

TABLE_8 = Block(
    466,
    r"""Грани	$F_1, F'_1, F_2, F'_2, F_3, F'_3,$ $F_4, F'_4, F_5, F'_5, F_6, F'_6$	$F_7, F'_7, F_8, F'_8, F_9, F'_9,$ $F_{10}, F'_{10}, F_{11}, F'_{11}, F_{12}, F'_{12}$	$F_{13}, F'_{13}, F_{14}, F'_{14}, F_{15}, F'_{15}$
Расстояние	$3 \sin 2a \sqrt{\frac{3}{3 + \cos^2 a}}$	$4 \sin 2a \sqrt{\frac{1}{1 + 15 \cos^2 a}}$	$2\sqrt{3} \sin a$""",
)

TABLE_10 = Block(
    590,
    r"""Вершины	Расстояние
$V_1, V_1'$	$d_1 = \sqrt{24\cos^2 a + 1}$
$V_2, V_2', V_6, V_6'$	$d_2 = \sqrt{2\cos^2 a + 7}$
$V_3, V_3', V_5, V_5'$	$d_3 = \sqrt{6\cos^2 a + 3}$
$V_4, V_4'$	$d_4 = \sqrt{8\cos^2 a + 1}$
$V_7, V_7'$	$d_5 = \sqrt{8\sin^2 a + 1}$
$V_8, V_8', V_{11}, V_{11}'$	$d_6 = \sqrt{12\sin^2 a + 1}$
$V_9, V_9', V_{10}, V_{10}'$	$d_7 = \sqrt{6\sin^2 a + 1}$""",
)

TABLE_11 = Block(
    603,
    r"""Грани	Расстояние	Грани	Расстояние
$F_1, F_1'$	$\frac{7}{2}\sin 2a\sqrt{\frac{1}{4-3\sin^2 a}}$	$F_2, F_2'$	$\frac{5}{2}\sin 2a\sqrt{\frac{3}{4-\sin^2 a}}$
$F_6, F_6'$	$3\sin 2a\sqrt{\frac{1}{4-3\sin^2 a}}$	$F_3, F_3'$	$2\sin 2a\sqrt{\frac{3}{4-\sin^2 a}}$
$F_8, F_8'$		$F_4, F_4'$
$F_7, F_7'$	$\frac{5}{2}\sin 2a\sqrt{\frac{1}{4-3\sin^2 a}}$	$F_9, F_9'$	$\frac{3\sqrt{3}}{2}\sin a$
		$F_{10}, F_{10}'$""",
)
