r"""What the rows of the lists and tables state, and where one is wrong the row that is right.

The axes are whole numbers, component by component times positive units such as sin a sin b. So the momentum envelope
has the same vertices, edges and faces for all angles of the open range, and a plane that touches it is found with whole
numbers. From there the declarations have their witnesses and corrections; the statements themselves are about the
axes with their angles, and decided like all others.

What a label means, which momenta the wheels have at V_5, is settled by all rows of a configuration together, so that
the damage of a single row does not change what the others say. The right row is the one that differs least from what
is printed.
"""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import combinations, product

from symcheck.core.claims import Derived, Hypothesis
from symcheck.core.problems import Method
from symcheck.core.verdicts import SymcheckError
from symcheck.mechanics.zonotope import UNIT_VECTORS, Envelope, Signs, envelope, opposite, triple_product
from symcheck.papers.listing import EdgeRow, FaceRow, Label, Pattern, Row, TableRow, VertexRow
from symcheck.proof import existence, identity
from symcheck.reading import Notation

Unit = tuple[Fraction, str, str]  # number, root, function: 1/2, \sqrt{3}, \sin a
Edges = tuple[tuple[Label, Label], ...]
AND = r" \land "
ORDERS = {1: "> 0", -1: "< 0", 0: "= 0"}
PRIMES = {"lost prime", "prime"}
HALF_UNIT = 0.0005  # of the last digit in the tables


@dataclass(frozen=True)
class Part:
    """One statement of a row, how it is shown, and whether it is true of the whole numbers."""

    states: str
    holds: bool
    by: Method = identity


@dataclass(frozen=True)
class Array:
    """Wheels on a pyramid: their axes in whole numbers, and the units of coordinates and of normals."""

    section: str
    axes: tuple[tuple[int, int, int], ...]
    units: tuple[Unit, Unit, Unit]
    normals: tuple[str, str, str]
    notation: Notation
    given: tuple[Hypothesis, ...]
    table: Hypothesis  # the angles of the table of coordinates
    where: Derived | None = None

    @cached_property
    def envelope(self) -> Envelope:
        """The momentum envelope in whole numbers."""
        return envelope(self.axes)

    @cached_property
    def normals_of_faces(self) -> dict[Signs, tuple[int, ...]]:
        """The outward normal of each face, in lowest terms."""
        normals = {face: self.envelope.normal(face) for face in self.envelope.combinatorics.faces}
        return {face: tuple(n // math.gcd(*normal) for n in normal) for face, normal in normals.items()}

    def coordinates(self, signs: Signs) -> tuple[str, ...]:
        """The components of H, as the paper prints them."""
        return tuple(_multiple(n, *unit) for n, unit in zip(self.envelope.point(signs), self.units, strict=True))

    @cached_property
    def angles(self) -> dict[str, int]:
        """The angles of the table of coordinates, in degrees."""
        return {angle: int(degrees) for angle, degrees in re.findall(r"(\w) = (\d+)\^\\circ", self.table.states)}

    def values(self, signs: Signs) -> tuple[float, ...]:
        """The components of H at the angles of the table."""
        found = []
        for n, (number, root, function) in zip(self.envelope.point(signs), self.units, strict=True):
            factors = [
                getattr(math, name)(math.radians(self.angles[angle]))
                for name, angle in re.findall(r"\\(sin|cos) (\w)", function)
            ]
            found.append(n * float(number) * (math.sqrt(3) if root else 1) * math.prod(factors))
        return tuple(found)

    def touching(self, signs: Signs) -> Part:
        """That some plane touches the envelope where the wheels are so, free where 0 stands, and nowhere else."""
        lattice = self.envelope.combinatorics
        orders = (rf"(\mathbf{{c}}, \mathbf{{e}}_{k}) {ORDERS[s]}" for k, s in enumerate(signs, 1))
        holds = any(signs in cells for cells in (lattice.vertices, lattice.edges, lattice.faces))
        faces = (f for f in lattice.faces if all(t in (0, s) for s, t in zip(signs, f, strict=True)))
        normals = [self.normals_of_faces[face] for face in faces]
        total = [sum(column) for column in zip(*normals, strict=True)] if holds else []
        point = {
            f"c_{k}": rf"{n} \cdot {unit}" for k, (n, unit) in enumerate(zip(total, self.normals, strict=False), 1)
        }
        return Part(rf"\exists c_1, c_2, c_3 : ({AND.join(orders)})", holds, existence(**point))

    def combinations(self, free: int) -> Iterator[Signs]:
        """All sign vectors with so many wheels free."""
        return (h for h in product((1, 0, -1), repeat=len(self.axes)) if h.count(0) == free)

    def no_others(self, cells: Mapping[Signs, object]) -> Iterator[Part]:
        """That sign vectors with as many free wheels, but not among these, are not vertices, edges or faces.

        By combinations of axes, one of each opposite two: where the c_k e_k add up to zero and no c_k has the sign that
        h_k has not, no plane has all h_k e_k on one side. The wheels that are free do not matter.
        """
        free = next(iter(cells)).count(0)
        others = [h for h in self.combinations(free) if h not in cells and next(filter(None, h)) == 1]
        found = (
            next((c for c in self.circuits if all(n * s >= 0 for n, s in zip(c, h, strict=True))), ()) for h in others
        )
        each = list(dict.fromkeys(found))
        if each:
            yield Part(AND.join(f"{bracket(c)} = 0" for c in each), () not in each)

    @cached_property
    def circuits(self) -> list[tuple[int, ...]]:
        """The combinations of four axes that vanish, with either sign."""
        found = []
        for four in combinations(range(len(self.axes)), 4):
            minors = [triple_product(*(self.axes[m] for m in four if m != k)) for k in four]
            row = dict(zip(four, (n * (-1) ** place for place, n in enumerate(minors)), strict=True))
            least = math.gcd(*minors)
            whole = tuple(row.get(k, 0) // least for k in range(len(self.axes)))
            found += [whole, opposite(whole)]
        return found


def _multiple(whole: int, number: Fraction, root: str, function: str) -> str:
    """A whole number of units."""
    value = whole * number
    if not value:
        return "0"
    top = f"{abs(value.numerator) if abs(value.numerator) > 1 or (value.denominator > 1 and not root) else ''}{root}"
    fraction = top if value.denominator == 1 else rf"\frac{{{top}}}{{{value.denominator}}}"
    return f"{'-' * (value < 0)}{fraction} {function}".replace("- ", "-").strip()


# --- what the labels mean


def labels_of(row: Row) -> tuple[Label, ...]:
    """All labels in a row, in printed order."""
    match row:
        case VertexRow() | TableRow():
            return (row.label,)
        case EdgeRow():
            return row.first, row.last
        case FaceRow():
            return (row.label, *_ends(row.edges))
    return ()


@dataclass(frozen=True)
class Names:
    """What the labels of a configuration mean: V_i as momenta of the wheels, F_i with 0 for those that are free."""

    vertices: Mapping[int, Signs]
    faces: Mapping[int, Signs]
    cycles: Mapping[Signs, Sequence[Edges]]  # around each face, from each vertex on, in both directions

    def signs(self, label: Label) -> Signs:
        """The momenta at a vertex, or on a face; none if there is no such label."""
        known = self.vertices if label.letter == "V" else self.faces
        signs = known.get(label.index, ())
        return opposite(signs) if label.primed else signs

    @cached_property
    def labels(self) -> dict[tuple[str, Signs], Label]:
        """The label of each vertex and face."""
        known = {"V": self.vertices, "F": self.faces}
        return {
            (letter, signs): Label(letter, index, primed)
            for letter, means in known.items()
            for index, own in means.items()
            for signs, primed in ((opposite(own), True), (own, False))
        }

    def label(self, letter: str, signs: Signs) -> Label:
        """The label of a vertex or face."""
        if (letter, signs) not in self.labels:
            raise SymcheckError(f"no label {letter}_i means {signs}; look for it among the rows of the list")
        return self.labels[letter, signs]


def settled(
    array: Array,
    vertices: Sequence[VertexRow],
    edges: Sequence[EdgeRow],
    faces: Sequence[FaceRow],
    table: Sequence[TableRow],
) -> Names:
    """What the labels mean by most of the rows.

    The row of a vertex has a vote for its momenta, a row of the table for the vertex nearest to its numbers, an edge for
    each end, a face for its momenta and for the vertices around it; a vote for V'_i is one for the opposite of V_i.
    """
    votes: dict[tuple[str, int], Counter[Signs]] = defaultdict(Counter)
    values = {signs: array.values(signs) for signs in array.envelope.combinatorics.vertices}

    def vote(label: Label, signs: Signs) -> None:
        votes[label.letter, label.index][opposite(signs) if label.primed else signs] += 1

    def settled_so_far(letter: str) -> dict[int, Signs]:
        return {i: count.most_common(1)[0][0] for (of, i), count in sorted(votes.items()) if of == letter}

    for row in vertices:
        vote(row.label, signs_of(row.pattern))
    for cells in table:
        point = [float(cell) for _, cell in cells.cells]
        vote(cells.label, min(values, key=lambda signs: math.dist(values[signs], point)))
    for edge in edges:
        vote(edge.first, signs_of(edge.pattern, -1))
        vote(edge.last, signs_of(edge.pattern, 1))
    names = Names(settled_so_far("V"), {}, {})
    cycles = _cycles(array, names)
    for face in faces:
        vote(face.label, signs_of(face.pattern))
        vote(face.label, _around(cycles, face))
    return Names(names.vertices, settled_so_far("F"), cycles)


def _around(cycles: Mapping[Signs, Sequence[Edges]], row: FaceRow) -> Signs:
    """The face whose vertices are nearest to those that a row names."""
    printed, own = _ends(row.edges), signs_of(row.pattern)
    numbers = [label.index for label in printed]
    if any(numbers == [label.index for label in _ends(around)] for around in cycles.get(own, ())):
        return own
    every = ((signs, around) for signs, each in cycles.items() for around in each)
    return min(every, key=lambda pair: len(_faults_of_labels(printed, _ends(pair[1]))))[0]


def signs_of(pattern: Pattern, *parameters: int) -> Signs:
    """The momenta with the parameters u, v at these values, or 0."""
    values = {"u": 0, "v": 0, **dict(zip("uv", parameters, strict=False))}
    return tuple(values[entry] if entry in values else int(entry) for entry in pattern)


def pattern_of(signs: Signs) -> Pattern:
    """Momenta as they are printed, the free ones as u and v."""
    parameters = iter("uv")
    return tuple(str(s) if s else next(parameters) for s in signs)


def _cycles(array: Array, names: Names) -> dict[Signs, list[Edges]]:
    """Every face with its edges, from each vertex on, in both directions."""
    found = {}
    for signs, cycle in array.envelope.combinatorics.faces.items():
        labels = [names.label("V", vertex) for vertex in cycle]
        starts = (turn[k:] + turn[:k] for turn in (labels, labels[::-1]) for k in range(len(labels)))
        found[signs] = [tuple(zip(around, [*around[1:], around[0]], strict=True)) for around in starts]
    return found


def _ends(edges: Edges) -> list[Label]:
    return [label for edge in edges for label in edge]


# --- right rows


def right_row(array: Array, names: Names, row: Row) -> Row:
    """The row that differs least from what is printed; of equally many faults those that come late.

    If it has one fault, or has lost primes only, then it is about what its momenta (or its label) say: no row is nearer.
    """

    def differing(right: Row) -> tuple[int, list[bool]]:
        return len(faults(row, right)), [a != b for a, b in zip(labels_of(row), labels_of(right), strict=False)]

    for meant in _right_rows(array, names, row, only=True):
        if not (found := faults(row, meant)) or (len(found) == 1 and not isinstance(row, FaceRow)):
            return meant
    meant = min(_right_rows(array, names, row, only=True), key=differing, default=row)
    if meant is not row and set(faults(row, meant)) <= PRIMES:
        return meant
    return min(_right_rows(array, names, row), key=differing)


def _right_rows(array: Array, names: Names, row: Row, *, only: bool = False) -> Iterator[Row]:
    """All rows there could be, or only those about what the momenta of the row (or its label) say it is about."""
    lattice = array.envelope.combinatorics
    match row:
        case VertexRow():
            at = signs_of(row.pattern)
            for signs in lattice.vertices if not only else [at] if at in lattice.vertices else []:
                yield replace(
                    row,
                    label=names.label("V", signs),
                    pattern=pattern_of(signs),
                    coordinates=array.coordinates(signs),
                    directions=tuple((1 if k > 0 else -1, abs(k)) for k in lattice.vertices[signs]),
                )
        case EdgeRow():
            at = signs_of(row.pattern)
            for signs in lattice.edges if not only else [at] if at in lattice.edges else []:
                first, last = (names.label("V", end) for end in lattice.edges[signs])
                yield replace(row, first=first, last=last, pattern=pattern_of(signs))
        case FaceRow():
            at = signs_of(row.pattern)
            for signs in lattice.faces if not only else [at] if at in lattice.faces else []:
                label, pattern = names.label("F", signs), pattern_of(signs)
                for around in names.cycles[signs]:
                    yield replace(row, label=label, edges=around, pattern=pattern)
        case TableRow():
            every = (s for own in names.vertices.values() for s in (own, opposite(own)))
            for signs in every if not only else [names.signs(row.label)]:
                values = zip(row.cells, array.values(signs), strict=True)
                cells = ((name, cell if _rounds(value, cell) else _rounded(value)) for (name, cell), value in values)
                yield replace(row, label=names.label("V", signs), cells=tuple(cells))


def _rounds(value: float, cell: str) -> bool:
    """Whether a cell is a value, rounded; a whole number is exact."""
    return abs(value - float(cell)) < (HALF_UNIT if "." in cell else 1e-9)


def _rounded(value: float) -> str:
    return f"{value:.3f}" if abs(value) > 1e-9 else "0"


# --- how a row differs from the right one: a word for each place


def faults(row: Row, right: Row) -> list[str]:
    """The kinds of the faults of a row."""
    match row, right:
        case VertexRow(), VertexRow():
            return [
                *_faults_of_labels([row.label], [right.label]),
                *_faults_of_pattern(row.pattern, right.pattern),
                *_faults_of_coordinates(row.coordinates, right.coordinates),
                *_faults_of_directions(row, right),
            ]
        case EdgeRow(), EdgeRow():
            labels = _faults_of_labels([row.first, row.last], [right.first, right.last])
            return labels + _faults_of_pattern(row.pattern, right.pattern)
        case FaceRow(), FaceRow():
            labels = _faults_of_labels([row.label, *_ends(row.edges)], [right.label, *_ends(right.edges)])
            return labels + _faults_of_pattern(row.pattern, right.pattern)
        case TableRow(), TableRow():
            cells = ((a, b) for (_, a), (_, b) in zip(row.cells, right.cells, strict=True) if a != b)
            slips = ["rounding" if _is_slip(*cell) else "number" for cell in cells]
            return _faults_of_labels([row.label], [right.label]) + slips
    raise SymcheckError("rows of different kinds are compared; compare a row with its own correction")


def _faults_of_labels(labels: Sequence[Label], right: Sequence[Label]) -> list[str]:
    found = []
    for label, other in zip(labels, right, strict=False):
        if label.index != other.index:
            found.append("label")
        if label.primed != other.primed:
            found.append("lost prime" if other.primed else "prime")
    return found + ["missing cell"] * 2 * abs(len(labels) - len(right))


def _faults_of_pattern(pattern: Pattern, right: Pattern) -> list[str]:
    pairs = ((a, b) for a, b in zip(pattern, right, strict=True) if a != b)
    return ["letter" if {a, b} & {"u", "v"} else "sign" for a, b in pairs]


def _faults_of_coordinates(coordinates: Sequence[str], right: Sequence[str]) -> list[str]:
    found = []
    for one, other in zip(coordinates, right, strict=False):
        a, b = (re.sub(r"\s", "", each) for each in (one, other))
        if a != b:
            waves = [re.findall(r"\\(?:sin|cos)\w", each) for each in (a, b)]
            found.append(
                "sign" if a.lstrip("-") == b.lstrip("-") else "coefficient" if waves[0] == waves[1] else "function"
            )
    return found + ["missing cell"] * abs(len(coordinates) - len(right))


def _faults_of_directions(row: VertexRow, right: VertexRow) -> list[str]:
    printed, wanted = set(row.directions), set(right.directions)
    wheels = {k for _, k in printed ^ wanted}
    signs = [k for k in wheels if {k} <= {n for _, n in printed} & {n for _, n in wanted}]
    extra, missing = (len({k for _, k in each} - set(signs)) for each in (printed - wanted, wanted - printed))
    return ["sign"] * len(signs) + ["letter"] * max(extra, missing)


def _is_slip(cell: str, right: str) -> bool:
    """Whether the last digit is off by one."""
    return round(abs(float(cell) - float(right)), 6) == 2 * HALF_UNIT


# --- what a row states


def vector(label: Label) -> str:
    """A vertex, or the middle of a face, in a statement; V'_i is -V_i."""
    index = f"{{{label.index}}}" if label.index > 9 else f"{label.index}"
    return rf"{'-' * label.primed}\mathbf{{{label.letter}}}_{index}"


def _between(first: Label, last: Label) -> str:
    """From one vertex to another."""
    begin = f"({vector(first)})" if first.primed else vector(first)
    return f"{vector(last)} - {begin}"


def bracket(entries: Sequence[object]) -> str:
    """Momenta of the wheels as H."""
    return f"[{', '.join(map(str, entries))}]"


def parts(array: Array, names: Names, row: Row, right: Row) -> tuple[Part, ...]:
    """The statements of a row; the right row tells how pieces belong together."""
    match row, right:
        case VertexRow(), VertexRow():
            return _parts_of_vertex(array, names, row, right)
        case EdgeRow(), EdgeRow():
            first, last = (signs_of(row.pattern, u) for u in (-1, 1))
            return (
                _is_at(names, first, row.first),
                _is_at(names, last, row.last),
                array.touching(signs_of(row.pattern)),
            )
        case FaceRow(), FaceRow():
            return _parts_of_face(array, names, row, right)
        case TableRow(), TableRow():
            return _parts_of_cells(array, names, row)
    raise SymcheckError("rows of different kinds are compared; compare a row with its own correction")


def _is_at(names: Names, signs: Signs, label: Label) -> Part:
    """That the wheels have these momenta at a vertex, or in the middle of a face."""
    return Part(f"{bracket(signs)} = {vector(label)}", names.signs(label) == signs)


def _parts_of_vertex(array: Array, names: Names, row: VertexRow, right: VertexRow) -> tuple[Part, ...]:
    signs = signs_of(row.pattern)
    coordinates = f"{bracket(signs)} = ({', '.join(row.coordinates)})"
    return (
        Part(coordinates, not _faults_of_coordinates(row.coordinates, array.coordinates(signs))),
        _is_at(names, signs, row.label),
        array.touching(signs),
        _leading(array, names, row, right),
    )


def _leading(array: Array, names: Names, row: VertexRow, right: VertexRow) -> Part:
    """That 2 along each direction is the other end of an edge, and there are as many directions as edges."""
    signs, own = signs_of(row.pattern), signs_of(right.pattern)
    found, holds = [], len(row.directions) == len(right.directions)
    for (turn, wheel), (_, other) in _paired(row.directions, right.directions):
        end = tuple(-s if k == other else s for k, s in enumerate(own, 1))
        found.append(rf"{bracket(signs)} {'+-'[turn < 0]} 2\mathbf{{e}}_{wheel} = {vector(names.label('V', end))}")
        step = tuple(s + 2 * turn * (k == wheel) for k, s in enumerate(signs, 1))
        holds = holds and array.envelope.point(step) == array.envelope.point(end)
    if len(row.directions) != len(right.directions):
        found.append(f"{len(row.directions)} = {len(right.directions)}")
    return Part(AND.join(found), holds)


def _paired(
    directions: Sequence[tuple[int, int]], right: Sequence[tuple[int, int]]
) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Printed directions with right ones: those along the same axis, then the rest in order."""
    same = [(one, other) for one in directions for other in right if one[1] == other[1]]
    rest = [one for one in directions if one not in [a for a, _ in same]]
    left = [other for other in right if other not in [b for _, b in same]]
    return sorted([*same, *zip(rest, left, strict=False)], key=lambda pair: pair[0][1])


def _parts_of_face(array: Array, names: Names, row: FaceRow, right: FaceRow) -> tuple[Part, ...]:
    free = [k for k, entry in enumerate(right.pattern) if entry in ("u", "v")]
    corners = [[names.signs(begin)[k] for k in free] for begin, _ in right.edges]
    begins = (begin for begin, _ in row.edges)
    at_corners = [_is_at(names, signs_of(row.pattern, *uv), begin) for uv, begin in zip(corners, begins, strict=False)]
    return (
        _sides(array, names, row, right),
        Part(AND.join(part.states for part in at_corners), all(part.holds for part in at_corners)),
        array.touching(signs_of(row.pattern)),
        _is_at(names, signs_of(row.pattern), row.label),
    )


def _sides(array: Array, names: Names, row: FaceRow, right: FaceRow) -> Part:
    """That each pair of labels is a side of the face: its ends are 2 apart, along one of the two free axes."""
    found, holds = [], len(row.edges) == len(right.edges)
    for (first, last), ends in zip(row.edges, right.edges, strict=False):
        begin, end = map(names.signs, ends)
        ((turn, wheel),) = ((t, k) for k, (s, t) in enumerate(zip(begin, end, strict=True), 1) if s != t)
        found.append(rf"{_between(first, last)} = {'-' * (turn < 0)}2\mathbf{{e}}_{wheel}")
        gap = (x - y for x, y in zip(*(array.envelope.point(names.signs(v)) for v in (last, first)), strict=True))
        holds = holds and tuple(gap) == tuple(2 * turn * x for x in array.axes[wheel - 1])
    if len(row.edges) != len(right.edges):
        found.append(f"{len(row.edges)} = {len(right.edges)}")
    return Part(AND.join(found), holds)


def _parts_of_cells(array: Array, names: Names, row: TableRow) -> tuple[Part, ...]:
    found = []
    for along, (_, cell), value in zip(UNIT_VECTORS, row.cells, array.values(names.signs(row.label)), strict=True):
        sign = r"\approx" if "." in cell else "="
        found.append(Part(f"({vector(row.label)}, {along}) {sign} {cell}", _rounds(value, cell)))
    return tuple(found)


# --- a row as it should be printed


def to_latex(row: Row) -> str:
    """The row as it should be printed."""
    match row:
        case VertexRow():
            directions = ", ".join(rf"{'-' * (turn < 0)}\mathbf{{e}}_{k}" for turn, k in row.directions)
            coordinates = ", ".join(row.coordinates)
            return rf"{row.label.printed} : \mathbf{{H}} = {bracket(row.pattern)} = ({coordinates}), \{{{directions}\}}"
        case EdgeRow():
            return rf"{row.first.printed} {row.last.printed} : \mathbf{{H}} = {bracket(row.pattern)}"
        case FaceRow():
            edges = ", ".join(f"{first.printed} {last.printed}" for first, last in row.edges)
            return rf"{row.label.printed} = \{{{edges}\}}, \mathbf{{H}} = {bracket(row.pattern)}"
        case TableRow():
            return ", ".join([row.label.printed, *(f"{name} = {cell}" for name, cell in row.cells)])
    raise SymcheckError("only rows of lists and tables can be shown")
