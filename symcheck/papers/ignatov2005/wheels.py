r"""Sets of wheels along the side edges of a pyramid, and the theorems that the paper has for each of them.

Sections 2 and 3 say much the same of four and of six wheels, and of those that work when one has failed. What they say
alike is declared here; a section names the place of each.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations

from symcheck.core.claims import Claim, Definition, Exclusion, Hypothesis, Ours, Premise
from symcheck.papers.declare import Scope
from symcheck.papers.ignatov2005 import derivation, envelopes, lists
from symcheck.papers.ignatov2005.hypotheses import WITHIN_LIMITS, lost_pi, rhombi
from symcheck.papers.ignatov2005.notation import five_of_six, four_wheels, six_wheels, three_of_four
from symcheck.papers.ignatov2005.rows import Array
from symcheck.proof import cases, identity
from symcheck.reading import Notation

AND = r" \land "
OUTLINE = (
    "No three axes lie in a plane, so that seen along any of the n axes the n - 1 others are not parallel: the outline has "
    "2 (n - 1) corners, and each is an edge along that axis."
)
PAIRS = (
    "No three of the n axes lie in a plane, so that each two span two opposite faces, on which the other wheels have the signs "
    "of these triple products and of the opposite ones."
)
CORNERS = (
    "As a combination of axes with the signs of the other momenta vanishes, no plane has all of them on one side; all that are "
    "left are corners of faces, by the signs of the triple products"
)
ALONG = {"x": "({}, 0, 0)", "y": "(0, {}, 0)", "z": "(0, 0, {})"}  # a vector along an axis


@dataclass(frozen=True, kw_only=True)
class Wheels(Scope):
    """The first wheels of a pyramid, as a scope: their axes and H are in force.

    wheels  how many work
    array   their axes in whole numbers
    unit    of their triple products: a number, and what is positive for all angles of the range
    region  what the paper calls the region of their momenta: P, or P' if one wheel has failed
    """

    wheels: int
    array: Array
    unit: tuple[str, str]
    region: str

    @property
    def numbers(self) -> range:
        """1, 2, ..."""
        return range(1, self.wheels + 1)

    def bracket(self, entry: Callable[[int], str]) -> str:
        """Momenta of the wheels as H, "[h_1, h_2, h_3]", by the number of the wheel."""
        return f"[{', '.join(map(entry, self.numbers))}]"

    def momenta(self, letter: str = "h") -> str:
        """[h_1, h_2, ...]"""
        return self.bracket(lambda i: f"{letter}_{i}")

    def turned(self, matrix: str, images: str) -> str:
        """The linear map takes the axes to the vectors given, plus or minus axes, so that P is mapped onto itself."""
        pairs = zip(self.numbers, images.split(", "), strict=True)
        return AND.join(rf"{matrix} \mathbf{{e}}_{i} = {image[:-1]}\mathbf{{e}}_{image[-1]}" for i, image in pairs)

    # --- the axes, the momentum

    def numbers_of_wheels(self, number: str, line: int) -> Exclusion:
        reason = "range of the number of a wheel, used in the notation"
        return self.exclusion(number, line, rf"i=1,\dots,{self.wheels}", reason=reason)

    def unit_vectors(self, number: str, line: int, uses: Sequence[str] = ()) -> Claim:
        return self.claim(
            number, line, words="The e_i are unit vectors.", states=r"(\mathbf{e}_i, \mathbf{e}_i) = 1", uses=uses
        )

    def angle_to_oz(self, number: str, line: int, downwards: str, axes: str) -> Claim:
        return self.claim(
            number,
            line,
            words=f"a is the angle between the axis of a wheel and OZ (as lines: {downwards} point downwards).",
            states=r"(\mathbf{e}_i, (0, 0, 1))^2 = \cos^2 a",
            uses=[axes],
        )

    def total_momentum(self, number: str, line: int, wheels: str = "wheels", uses: Sequence[str] = ()) -> Claim:
        addends = [rf"h_{i} \mathbf{{e}}_{i}" for i in self.numbers]
        return self.claim(
            number,
            line,
            rf"\mathbf{{H}} = {' + '.join(addends)},",
            words=f"The sum of the momenta of the {wheels}.",
            uses=uses,
        )

    def equal_wheels(self, number: str, line: int, printed: Sequence[str], notation: Notation) -> Premise:
        return self.premise(
            number,
            line,
            printed,
            words="The wheels are equal; h_max is the largest momentum of a wheel, one more parameter.",
            states=r"-h_{\max} \leq h_i \leq h_{\max}",
            notation=notation,
        )

    def shorthand(self, number: str, line: int, total: str, words: str = "") -> Claim:
        return self.claim(
            number,
            line,
            rf"\mathbf{{H}} = {self.momenta()}",
            words=f"{words}({total}) in short.",
            uses=[total],
        )

    def round_brackets(self, number: str, line: int) -> Exclusion:
        return self.exclusion(
            number,
            line,
            r"\mathbf{H} = (H_x, H_y, H_z)",
            reason="round brackets list components, as usual; the notation has them so",
        )

    def unit_of_momentum(
        self,
        number: str,
        line: int,
        shorthand: str,
        notation: Notation,
        words: str = "No generality is lost with h_max = 1: the momenta are those for h_max = 1, times h_max.",
    ) -> Claim:
        scaled = self.bracket(lambda i: rf"h_{{\max}} h_{i}")
        return self.claim(
            number,
            line,
            r"h_{\max} = 1",
            words=words,
            states=rf"{scaled} = h_{{\max}} {self.momenta()}",
            uses=[shorthand],
            notation=notation,
        )

    # --- the region of the momentum

    def region_of_momenta(self, number: str, line: int) -> Premise:
        return self.premise(number, line, r"|h_i| \leq 1", words=f"{self.region} is the region of all H with such h_i.")

    def symmetric_region(self, number: str, line: int, shorthand: str) -> Claim:
        return self.claim(
            number,
            line,
            words=f"{self.region} is symmetric about the origin.",
            states=f"{self.bracket(lambda i: f'-h_{i}')} = -{self.momenta()}",
            uses=[shorthand],
        )

    def full_momenta_at_vertices(self, number: str, line: int, shorthand: str) -> Claim:
        count = 2**self.wheels
        more, less = (self.momenta().replace("h_1", f"h_1 {sign} u") for sign in "+-")
        return self.claim(
            number,
            line,
            f"{count} = 2^{self.wheels}",
            words=f"At a vertex every wheel has full momentum, else H is the middle of a segment in {self.region}; so there are at "
            f"most {count} vertices.",
            states=(f"{more} + {less} = 2{self.momenta()}", f"{count} = 2^{self.wheels}"),
            uses=[shorthand],
        )

    def no_three_in_a_plane(
        self, number: str, line: int, words: str, given: Sequence[Hypothesis], uses: Sequence[str]
    ) -> Ours:
        triples = combinations(self.numbers, 3)
        return self.by_cases.ours(
            number,
            line,
            words=f"No three axes lie in one plane{words}",
            states=[rf"(\mathbf{{e}}_{i}, \mathbf{{e}}_{j} \times \mathbf{{e}}_{k}) \ne 0" for i, j, k in triples],
            given=given,
            uses=uses,
        )

    # --- vertices, edges, faces

    def pairs_of_vertices(
        self,
        number: str,
        line: int,
        printed: str,
        words: str = ": it is -V_i, and so it is written in formal statements.",
    ) -> Definition:
        return self.definition(number, line, printed, words=f"V'_i lies opposite to V_i{words}", opaque=True)

    def parameter_of_edges(self, number: str, line: int) -> Definition:
        return self.definition(
            number,
            line,
            (r"-1 \leq u \leq 1", "u = -1", "u = 1"),
            words="An edge begins at its first vertex with u = -1 and ends at its last with u = 1.",
            states=r"-1 \leq u \leq 1",
            opaque=True,
        )

    # --- how many there are

    @property
    def triple_products(self) -> str:
        """Each triple product of the axes in positive units, for all angles of the range: their signs make P what it is."""
        products = (
            f"{product} = {value} \\cdot {' '.join(self.unit).strip()}"
            for product, value in envelopes.triples(self.array.axes)
        )
        return AND.join((*products, f"{self.unit[-1]} > 0"))

    @property
    def on_no_side(self) -> str:
        """Combinations of the axes that vanish, so that of other momenta +-1 than those of vertices no plane touches P."""
        parts = self.array.no_others(self.array.envelope.combinatorics.vertices)
        return "".join(part.states + AND for part in parts)

    def counted(self, number: str, line: int, words: str, count: str, *uses: str) -> Claim:
        """A number of vertices, edges or faces, from the triple products."""
        states = f"{self.triple_products}{AND}{count}"
        return self.by_cases.claim(number, line, words=words, states=states, given=self.array.given, uses=uses)

    def number_of_vertices(self, number: str, line: int, words: str, *uses: str) -> Claim:
        every, found = 2**self.wheels, len(self.array.envelope.combinatorics.vertices)
        return self.counted(
            number,
            line,
            f"{self.region} has {found} vertices{words}",
            f"{self.on_no_side}2^{self.wheels} - {every - found} = {found}",
            *uses,
        )

    @property
    def _edges(self) -> tuple[str, str]:
        """How many edges there are, in words and as arithmetic."""
        n = self.wheels
        edges = 2 * n * (n - 1)
        return f"{self.region} has {edges} edges. {OUTLINE}", rf"2 \cdot {n} ({n} - 1) = {edges}"

    def number_of_edges(self, number: str, line: int, *uses: str) -> Claim:
        return self.counted(number, line, *self._edges, *uses)

    def edges_counted(self, number: str, line: int, *uses: str) -> Ours:
        """The same where the paper says something else."""
        words, count = self._edges
        states = f"{self.triple_products}{AND}{count}"
        return self.by_cases.ours(number, line, words=words, states=states, given=self.array.given, uses=uses)

    def number_of_faces(self, number: str, line: int, words: str, *uses: str) -> Claim:
        n = self.wheels
        return self.counted(
            number,
            line,
            f"{self.region} has {n * (n - 1)} faces{words}. {PAIRS}",
            f"{n} ({n} - 1) = {n * (n - 1)}",
            *uses,
        )

    def pairs_of_faces(self, number: str, line: int, printed: str) -> Definition:
        return self.definition(number, line, printed, words="F'_i lies opposite to F_i.", opaque=True)

    def sense_of_edges(self, number: str, line: int) -> Exclusion:
        words = "V_2 V_1 and V_1 V_2 are one edge, begun at either end."
        return self.exclusion(number, line, words=words, reason="a convention on names")

    def edges_of_length_two(self, number: str, line: int, uses: Sequence[str]) -> Claim:
        whole = "All edges have the length 2: from u = -1 to u = 1 is 2 e_i."
        return self.claim(
            number,
            line,
            words=whole if self.region == "P" else f"The edges of {self.region} have the length 2.",
            states=r"(\mathbf{e}_i - (-\mathbf{e}_i), \mathbf{e}_i - (-\mathbf{e}_i)) = 2^2",
            uses=uses,
        )

    def faces_are_rhombi(self, number: str, line: int, given: Sequence[Hypothesis], edges: str) -> Claim:
        whole = "So all faces are rhombi: parallelograms with sides of one length along two axes that are not parallel."
        return self.by_cases.claim(
            number,
            line,
            words=whole if self.region == "P" else f"So all faces of {self.region} are rhombi.",
            states=rhombi(tuple(combinations(self.numbers, 2))),
            given=given,
            uses=[edges],
        )

    # --- symmetries, largest momenta

    def half_turns(self, number: str, line: int, axes: str, *images: str) -> Claim:
        """The images of the axes in a half turn about OX, about OY and about OZ."""
        turns = (
            r"\operatorname{diag}(1, -1, -1)",
            r"\operatorname{diag}(-1, 1, -1)",
            r"\operatorname{diag}(-1, -1, 1)",
        )
        return self.by_cases.claim(
            number,
            line,
            words="P goes over into itself when turned about OX, OY or OZ by any multiple of pi.",
            states=[self.turned(turn, to) for turn, to in zip(turns, images, strict=True)],
            uses=[axes],
            damage=lost_pi(r"n\pi"),
        )

    def planes_of_symmetry(self, number: str, line: int, axes: str, *images: str) -> Claim:
        """The images of the axes in the planes across OX, across OY and across OZ."""
        planes = (r"\operatorname{diag}(-1, 1, 1)", r"\operatorname{diag}(1, -1, 1)", r"\operatorname{diag}(1, 1, -1)")
        return self.by_cases.claim(
            number,
            line,
            words="The coordinate planes are planes of symmetry of P.",
            states=[self.turned(plane, to) for plane, to in zip(planes, images, strict=True)],
            uses=[axes],
        )

    def largest_component(
        self,
        number: str,
        line: int,
        largest: str,
        momenta: str,
        missing: str,
        given: Sequence[Hypothesis],
        components: str,
    ) -> Claim:
        """The largest component along an axis, "H_x = 4 \\sin a": the momenta that give it, and what is missing to it."""
        component, most = largest.split(" = ")
        return self.claim(
            number,
            line,
            largest,
            words=f"The largest {component} that the wheels can have, alone.",
            states=(
                f"[{momenta}] = {ALONG[component[-1]].format(most)}",
                rf"{WITHIN_LIMITS} \Rightarrow {component} \leq {most}",
            ),
            given=given,
            by={"a": identity, "b": cases(missing)},
            uses=[components],
        )


def points(names: str, letter: str = "V") -> list[str]:
    """The vertices named in a text, V'_i or V_i' as -V_i."""
    found = re.findall(r"V_(\d|\{\d+\})('?)", names)
    return [("-" if prime else "") + rf"\mathbf{{{letter}}}_{number}" for number, prime in found]


def moments_of_inertia(craft: Scope, number: str, line: int, words: str) -> Premise:
    """The spacecraft of both sections."""
    return craft.premise(
        number,
        line,
        (r"J_x = 1000 \text{ кг м}^2", r"J_y = 1600 \text{ кг м}^2", r"J_z = 800 \text{ кг м}^2"),
        words=f"The principal central moments of inertia, in kg m^2{words}.",
        states="J_x = 1000, J_y = 1600, J_z = 800",
    )


four = Wheels(
    notation=four_wheels,
    where=partial(derivation.momentum_of_wheels, 4),
    wheels=4,
    array=lists.four,
    unit=("", r"\sin^2 a \cos a \sin b \cos b"),
    region="P",
)
three = replace(
    four,
    notation=three_of_four,
    where=partial(derivation.momentum_of_wheels, 3),
    wheels=3,
    array=lists.three,
    region="P'",
)
six = Wheels(
    notation=six_wheels,
    where=partial(derivation.momentum_of_six, 6),
    wheels=6,
    array=lists.six,
    unit=(r"\frac{\sqrt{3}}{4}", r"\sin^2 a \cos a"),
    region="P",
)
five = replace(
    six, notation=five_of_six, where=partial(derivation.momentum_of_six, 5), wheels=5, array=lists.five, region="P'"
)
