"""What the form of formulas alone shows: sizes of printed matrices, indices without a component, letters too early."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from symcheck.document.printed import Printed
from symcheck.document.survey import Seen

# a printed matrix that contains no other environment
_MATRIX = re.compile(r"\\begin\{([pbB]?matrix)\}((?:(?!\\begin).)*?)\\end\{\1\}", re.DOTALL)
_ROW = re.compile(r"\\\\(?:\[[^\]]*\])?")  # the end of a row, with a space behind it
# entries that may be blocks, or stand for several: dots, bold letters and capitals, and nothing at all
_BLOCK = re.compile(r"dots|\\(?:math|bm|bold|vec|hat|text|operatorname|multicol)|[A-Z]|&\s*&|&\s*$|^\s*&")
# a size that stands for a printed matrix, and the T of its transposed
_SIZE = re.compile(r"<(\d+),(\d+)>\s*(\^\s*(?:\{\s*)?(?:T|\\top|\\mathsf T|\\intercal)(?:\s*\})?)?")
# matrices one behind the other, and nothing else
_PRODUCT = re.compile(rf"(?:{_SIZE.pattern}\s*)+")
_EQUALS = re.compile(r"(?<![<>:])=")  # between the sides of an equation
# all components of a vector, each printed: `(x_1, x_2, x_3)`
_COMPONENTS = re.compile(
    r"(?:=|\\in)\s*(?:\\left)?[(\[]\s*((?:\\?[A-Za-z]+)_\{?1\}?(?:\s*,\s*\\?[A-Za-z]+_\{?\d\}?)+)\s*(?:\\right)?[)\]]"
)
# one of them
_COMPONENT = re.compile(r"(\\?[A-Za-z]+)_\{?(\d+)\}?")
# words that introduce the letter that the next display defines
_INTRODUCES = re.compile(r"\b(?:defin\w+|denot\w+|introduc\w+)\b[^.]*$", re.IGNORECASE)


@dataclass(frozen=True)
class Mark:
    """Something to look at in one formula."""

    number: int
    message: str


def marks(formulas: Sequence[Printed], seen: Sequence[Seen], mentions: Sequence[tuple[str, int]]) -> list[Mark]:
    """All of them, in printed order."""
    found = [*_shapes(formulas), *_components(formulas), *_too_early(formulas, seen, mentions)]
    return sorted(found, key=lambda mark: mark.number)


def _shapes(formulas: Sequence[Printed]) -> Iterator[Mark]:
    """Products and equations of printed matrices whose sizes do not fit."""
    for k, formula in enumerate(formulas):
        members = [_printed(member) for member in _EQUALS.split(_matrices_closed(formula.latex))]
        for sizes in members:
            if any(a[1] != b[0] for a, b in pairwise(sizes)):
                yield Mark(k, f"sizes that do not fit in a product: {_shown(sizes)}")
        for left, right in pairwise(members):
            if left and right and (left[0][0], left[-1][1]) != (right[0][0], right[-1][1]):
                yield Mark(k, f"sizes that are not equal: {_shown(left)} and {_shown(right)}")


def _matrices_closed(latex: str) -> str:
    """The formula with each printed matrix as its size, as `<3,1>`, if its entries are no blocks."""

    def size(match: re.Match[str]) -> str:
        rows = [row for row in _ROW.split(match[2]) if row.strip()]
        columns = {row.count("&") + 1 for row in rows}
        if len(columns) != 1 or _BLOCK.search(match[2]):
            return "?"
        return f"<{len(rows)},{columns.pop()}>"

    return _MATRIX.sub(size, latex)


def _printed(member: str) -> list[tuple[int, int]]:
    """The sizes of the matrices whose product a side is, if it is nothing else."""
    if not _PRODUCT.fullmatch(member.strip(" .,;")):
        return []
    found = []
    for rows, columns, transposed in _SIZE.findall(member):
        found.append((int(columns), int(rows)) if transposed else (int(rows), int(columns)))
    return found


def _shown(sizes: Sequence[tuple[int, int]]) -> str:
    return " times ".join(f"{rows} x {columns}" for rows, columns in sizes)


def _components(formulas: Sequence[Printed]) -> Iterator[Mark]:
    """Components of a vector of which a section prints fewer, all of them."""
    known: dict[tuple[int, str], set[int]] = {}
    for formula in formulas:
        for match in _COMPONENTS.finditer(formula.latex):
            parts = _COMPONENT.findall(match[1])
            names, numbers = {name for name, _ in parts}, [int(n) for _, n in parts]
            if len(names) == 1 and numbers == [*range(1, len(numbers) + 1)]:
                known.setdefault((formula.scope[0], names.pop()), set()).add(len(numbers))
    for k, formula in enumerate(formulas):
        for name, number in dict.fromkeys(_COMPONENT.findall(formula.latex)):
            sizes = known.get((formula.scope[0], name), set())
            if len(sizes) == 1 and int(number) > max(sizes) and len(number) == 1:
                yield Mark(k, f"{name}_{number}, though {name} has {max(sizes)} components in this section")


def _too_early(
    formulas: Sequence[Printed], seen: Sequence[Seen], mentions: Sequence[tuple[str, int]]
) -> Iterator[Mark]:
    """Letters that a later section introduces, and that nothing before names."""
    first: dict[str, int] = {}
    for k, each in enumerate(seen):
        for name in each.names if formulas[k].display else ():
            first.setdefault(name, k)
    named: dict[str, int] = {}
    for text, k in mentions:
        named[text] = min(k, named.get(text, k))
    heads: dict[str, int] = {}
    for k, each in enumerate(seen):
        for head in each.heads:
            heads.setdefault(head, k)
    for letter, k in heads.items():
        used = first.get(letter, k)
        if formulas[used].scope[0] >= formulas[k].scope[0] or not formulas[k].display:
            continue
        introduced = _INTRODUCES.search(formulas[k].before) is not None
        if introduced and named.get(letter, len(seen)) > used + 1 and ("_" in letter or letter[:1] == "\\"):
            yield Mark(used, f"{letter} is used here and introduced at {formulas[k].place}")
