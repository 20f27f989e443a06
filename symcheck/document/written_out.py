r"""What a document prints in components: derivatives by a letter that it writes out, and entries of its matrices.

Where it says that q is `[x, \theta]^T`, the derivative of a number V by q is the list of those by x and \theta: as a
column or a row, whatever it is compared with.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass

from symcheck.document.macros import bare
from symcheck.document.printed import Printed
from symcheck.document.rewriting import WILD
from symcheck.document.survey import Link, Seen
from symcheck.reading.names import is_letter

# a list of components, and what stands between two of them
COMPONENTS = re.compile(r"\\begin\{pmatrix\}(.*)\\end\{pmatrix\}(?:\^T)?|[(\[](.*)[)\]](?:\^T)?", re.DOTALL)
SEPARATORS = re.compile(r"&|\\\\|,(?![^{]*\})")  # no comma of a subscript
ROWS = re.compile(r"\\\\(?:\[[^\]]*\])?")  # the end of a row, with a space behind it
_NAME = r"(?:\\[a-zA-Z]+\s*\{[^{}]*\}|\\?[a-zA-Z]+)(?:\s*_\s*(?:\w|\{[^{}]*\}))?"
# the partial derivative of a letter by another one, or by its rate
_PARTIAL = re.compile(
    rf"\\[dt]?frac\s*\{{\s*\\partial\s*({_NAME})\s*\}}\s*\{{\s*\\partial\s*(\\dot\s*(?:\{{{_NAME}\}}|{_NAME})|{_NAME})\s*\}}"
)
# a letter with a dot
_DOT = re.compile(r"\\dot\s*(?:\{(.*)\}|(.+))", re.DOTALL)
# a matrix that is printed in a formula
_PRINTED = re.compile(r"\\begin\{(?:[pbBvV]|small)?matrix\*?\}(.*?)\\end\{(?:[pbBvV]|small)?matrix\*?\}", re.DOTALL)
# what stands beside a term, and beside no factor
_BEFORE = re.compile(r"(?:^|[=+\-&,(]|\\left\s*[(\[]|\\q?quad)\s*$")
# and behind one
_BEHIND = re.compile(r"\s*(?:$|[=+\-&,.;)\]]|\\right|\\\\|\\q?quad)")
# two numbers below a letter that tell a row and a column
_ENTRY = re.compile(r"(\\[a-zA-Z]+\{\\?[a-zA-Z]+\}|\\?[a-zA-Z]+)\s*_\s*\{\s*(\d)\s*(?:,|\\[,;: ])?\s*(\d)\s*\}")
UNIT = "the identity"  # what letters are taken for
LARGEST = 9  # rows, or columns: of larger matrices one digit does not tell a row


def partial_rules(formulas: Sequence[Printed], seen: Sequence[Seen], lists: Set[str]) -> list[str]:
    """Rules of rewriting for the derivatives of numbers by letters that are written out; `lists` are no numbers."""
    written = {bare(x): parts for x, parts in _written_out(seen).items()}
    found: dict[tuple[str, str], list[tuple[Printed, re.Match[str]]]] = {}
    for formula in formulas:
        for each in _PARTIAL.finditer(formula.latex):
            if bare(_undotted(each[2])) in written and bare(each[1]) not in lists:
                found.setdefault((each[1], each[2]), []).append((formula, each))
    rules = []
    for (of, by), places in found.items():
        parts = written[bare(_undotted(by))]
        letters = parts if _undotted(by) == by else [rf"\dot{{{x}}}" for x in parts]
        derivatives = [rf"\frac{{\partial {of}}}{{\partial {x}}}" for x in letters]
        shapes = {shape for f, _ in places for shape in _shapes(f.latex, len(parts))}
        terms = all(_BEFORE.search(f.latex[: m.start()]) and _BEHIND.match(f.latex[m.end() :]) for f, m in places)
        wild = any(x in bare(text) for text in (of, by, *parts) for x in WILD)
        if terms and len(shapes) == 1 and not wild:
            listed = rf" {shapes.pop()} ".join(derivatives)
            left = rf"\frac{{\partial {of}}}{{\partial {by}}}"
            rules.append(rf"{left} -> \begin{{pmatrix}} {listed} \end{{pmatrix}}")
    return rules


def _shapes(latex: str, count: int) -> Iterator[str]:
    """What parts the entries of the columns and rows of so many that a formula prints."""
    for found in _PRINTED.finditer(latex):
        rows = [row for row in ROWS.split(found[1]) if row.strip()]
        if len(rows) == count and "&" not in found[1]:
            yield r"\\"
        elif len(rows) == 1 and rows[0].count("&") == count - 1:
            yield "&"


def _written_out(seen: Sequence[Seen]) -> dict[str, tuple[str, ...]]:
    """The letters that a document writes out as lists of letters, the same wherever it does."""
    every: dict[str, set[tuple[str, ...]]] = {}
    for link in (link for each in seen for link in each.links):
        if is_letter(link.left) and (parts := _letters(link)):
            every.setdefault(link.left, set()).add(parts)
    return {x: min(several) for x, several in every.items() if len(several) == 1}


def _letters(link: Link) -> tuple[str, ...]:
    """The components on the right side of an equation, if these are letters, each once."""
    found = COMPONENTS.fullmatch(link.right.strip())
    parts = tuple(each.strip() for each in SEPARATORS.split(found[1] or found[2])) if found else ()
    single = len(parts) > 1 and len({*parts}) == len(parts)
    return parts if single and all(map(is_letter, parts)) else ()


# a term that is a list, its rate, or the brackets around one, where the sign \0 stands for a list
_TERM = r"(?:\\frac\{d\}\{d ?t\} ?)?(?:\\left\( ?)?\0(?: ?\\right\))?"
# terms with signs between them
_TERMS = re.compile(rf"[+-]? ?{_TERM}(?: [+-] {_TERM})*")
# the partial derivative of a name by a name or by its rate, in normal form
_SLOPE = re.compile(rf"\\frac\{{\\partial ({_NAME})\}}\{{\\partial (\\dot\{{{_NAME}\}}|{_NAME})\}}")


@dataclass(frozen=True)
class Gradient:
    """Equations between the entries of lists of derivatives, and the letters by which a number is differentiated."""

    equations: tuple[str, ...]
    of: str
    by: tuple[str, ...]


def gradient(link: Link) -> Gradient | None:
    """An equation between lists of which one is a gradient, entry by entry; rows are compared with columns alike.

    Or one that says what a single derivative is.
    """
    if (alone := _SLOPE.fullmatch(link.left.strip())) and not _SLOPE.fullmatch(link.right.strip()):
        return Gradient((link.latex,), alone[1], (_undotted(alone[2]),))
    lists = [match[1] for match in _PRINTED.finditer(link.latex)]
    rows = [[row for row in ROWS.split(each) if row.strip()] for each in lists]
    if not lists or any(len(each) > 1 and "&" in text for each, text in zip(rows, lists, strict=True)):
        return None
    parts = [[x.strip() for x in SEPARATORS.split(text) if x.strip()] for text in lists]
    if len({*map(len, parts)}) > 1 or any(r"\begin" in text for text in lists):
        return None
    if not all(_TERMS.fullmatch(_PRINTED.sub("\0", side).strip()) for side in (link.left, link.right)):
        return None
    slopes = [found for own in parts if all(found := [_SLOPE.fullmatch(x) for x in own])]
    of = {x[1] for found in slopes for x in found if x}
    by = {tuple(_undotted(x[2]) for x in found if x) for found in slopes}
    if len(of) != 1 or len(by) != 1 or len({*min(by)}) < len(parts[0]):
        return None
    if any(all(_SLOPE.fullmatch(x) for own in parts for x in own) for _ in slopes):
        return None  # another way to write it

    def entry(k: int) -> str:
        own = iter(parts)

        def put(found: re.Match[str]) -> str:
            text = next(own)[k]
            return rf"\left({text}\right)" if link.latex[: found.start()].rstrip().endswith("-") else text

        return _PRINTED.sub(put, link.latex)

    return Gradient(tuple(entry(k) for k in range(len(parts[0]))), of.pop(), by.pop())


def _undotted(letter: str) -> str:
    dotted = _DOT.fullmatch(letter)
    return str(dotted[1] or dotted[2]) if dotted else letter


def with_units(formulas: Sequence[Printed], seen: Sequence[Seen], called: Set[str]) -> list[Seen]:
    """The same, in which letters are identity matrices that words call so, or that are such between matrices.

    A letter that is something of its own somewhere, or a factor where words do not call it so, is none.
    """
    heads = {x for each in seen for x in each.heads}
    used = {role.letter for each in seen for role in each.roles if role.taken.startswith(UNIT)}
    beside = {x: [f.latex for f, each in zip(formulas, seen, strict=True) if _names(each, x)] for x in used}
    units = {x for x in used - heads if all(_is_added(x, text) for text in beside[x])}
    units |= {role.letter for each in seen for role in each.roles if bare(role.letter) in called} - heads
    every = zip(formulas, seen, strict=True)
    return [each.with_units({x for x in units if _is_added(x, f.latex)}) for f, each in every]


def _names(seen: Seen, letter: str) -> bool:
    return any(role.letter == letter for role in seen.roles)


def _is_added(letter: str, latex: str) -> bool:
    """Does a letter stand nowhere before what it would multiply?"""
    places = re.finditer(rf"(?<![A-Za-z\\]){re.escape(letter)}(?![A-Za-z])", latex)
    behind = [latex[found.end() :] for found in places]
    return bool(behind) and all(_BEHIND.match(rest) for rest in behind)


@dataclass(frozen=True)
class Entry:
    """An entry of a printed matrix that has a name elsewhere: `A_{43}` of A."""

    number: int  # of the formula that prints the matrix
    place: int  # of the equation in it
    name: str
    value: str

    @property
    def latex(self) -> str:
        """The equation."""
        return f"{self.name} = {self.value}"


def entries(seen: Sequence[Seen]) -> Iterator[Entry]:
    """The entries of printed matrices of which a document speaks by row and column.

    A matrix in whose entries such names stand is defined by them, and so do small letters not tell entries then.
    """
    names: dict[str, dict[tuple[int, int], set[str]]] = {}
    heads = {bare(x) for each in seen for x in each.heads}
    for each in seen:
        for role in each.roles:
            if role.kind == "scalar" and (found := _ENTRY.fullmatch(role.letter.strip())):
                place = int(found[2]), int(found[3])
                names.setdefault(bare(found[1]), {}).setdefault(place, set()).add(role.letter)
    for base, link, k, rows in _matrices(seen):
        small = base.lower() if base.isalpha() and base.isupper() and base.lower() not in heads else base
        for own in (names.get(x, {}) for x in dict.fromkeys((base, small))):
            inside = {x for several in own.values() for x in several}
            if inside & link.names[1] or any(0 in place for place in own):  # rows that are counted from zero
                continue
            for (n, m), spelled in own.items():
                if 1 <= n <= len(rows) and 1 <= m <= len(rows[0]):
                    for name in sorted(spelled):
                        yield Entry(k, link.place, name, rows[n - 1][m - 1])


def _matrices(seen: Sequence[Seen]) -> Iterator[tuple[str, Link, int, list[list[str]]]]:
    """The letters that are said once to be a printed matrix, with its rows."""
    found: dict[str, list[tuple[Link, int, list[list[str]]]]] = {}
    for k, each in enumerate(seen):
        for link in each.links:
            printed = _PRINTED.fullmatch(link.right.strip())
            if each.reason or printed is None or not is_letter(link.left) or r"\begin" in printed[1]:
                continue
            rows = [[x.strip() for x in row.split("&")] for row in ROWS.split(printed[1]) if row.strip()]
            widths = {len(row) for row in rows}
            if len(widths) == 1 and 1 < max(widths) <= LARGEST and 1 < len(rows) <= LARGEST:
                found.setdefault(bare(link.left), []).append((link, k, rows))
    for base, several in found.items():
        if len({link.right for link, _, _ in several}) == 1:
            for link, k, rows in several:
                yield base, link, k, rows
