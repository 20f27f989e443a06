"""Derived expressions as LaTeX in the letters of their paper, long sums in several lines."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING

from symcheck.core.counts import number_of
from symcheck.core.lazy import lazy
from symcheck.reading import Notation

if TYPE_CHECKING:
    from sympy import Expr

sp = lazy("sympy")

WIDTH = 95  # signs in a line of mathematics
MOST = 6  # lines of one expression
_BREAKS = (
    {r"\Leftrightarrow", r"\Rightarrow"},
    {r"\lor", r"\land", r"\quad"},
    {"=", r"\le", r"\ge", r"\approx"},
    {"+", "-"},
)
_OPEN, _CLOSE = {"(", "[", "{", r"\{", r"\begin"}, {")", "]", "}", r"\}", r"\end"}
_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\S")  # a command, an escaped sign, or any other sign
_BOLD = re.compile(r"\\(?:mathbf|boldsymbol)\{(.*)\}")  # a bold letter; its components are printed in plain type
_INDEXED = re.compile(r"(.+?)_(\d+(?:_\d+)*)")  # a letter's name and its indices: "a_1_2"


def letter(name: str, notation: Notation) -> str:
    r"""The printed letter of a variable: "domega_3" -> \dot{\omega}_{3}; SymPy's own spelling if the paper has none."""
    declared = {each.stem: each for each in reversed(notation.letters)}
    if name in declared:
        return declared[name].latex
    found = _INDEXED.fullmatch(name)
    if found and found[1] in declared:
        base = declared[found[1]]
        plain = _BOLD.sub(r"\1", base.latex) if base.kind in ("vector", "matrix") else base.latex  # a component of it
        return f"{plain}_{{{found[2].replace('_', ', ')}}}"
    spelled: str = sp.latex(sp.Symbol(name))
    return spelled


def expression(value: Expr, notation: Notation) -> str:
    """A SymPy expression as LaTeX in these letters."""
    names = {symbol: letter(symbol.name, notation) for symbol in value.free_symbols}
    text: str = sp.latex(value, symbol_names=names, fold_func_brackets=True, inv_trig_style="full")
    return text


def lines(value: Expr, notation: Notation) -> list[str]:
    """The same in lines, cut if there are very many."""
    broken = split(expression(value, notation))
    return (
        [*broken[:MOST], rf"\ldots \quad\text{{and {number_of(len(broken) - MOST, 'more line')}}}"]
        if len(broken) > MOST + 1
        else broken
    )


def split(latex: str) -> list[str]:
    """A formula in lines of the usual width, broken before connectives, else relations, else signs, not in brackets."""
    if width(latex) <= WIDTH or r"\begin" in latex:  # an environment has its own lines
        return [latex]
    for signs in _BREAKS:
        places = [at for at, sign in _outside(latex) if sign in signs and at]
        if places:
            ends = [0, *places, len(latex)]
            pieces = [latex[start:end].strip() for start, end in pairwise(ends)]
            return _filled([line for piece in pieces for line in split(piece)])
    return [latex]


def _outside(latex: str) -> Iterator[tuple[int, str]]:
    """The tokens that stand in no bracket or environment, with their places."""
    depth = 0
    for found in _TOKEN.finditer(latex):
        token = found[0]
        depth += (token in _OPEN) - (token in _CLOSE)
        if not depth and token not in _CLOSE:
            yield found.start(), token


def _filled(pieces: list[str]) -> list[str]:
    """As many pieces in a line as it holds."""
    filled = pieces[:1]
    for piece in pieces[1:]:
        if width(filled[-1] + piece) <= WIDTH:
            filled[-1] += f" {piece}"
        else:
            filled.append(piece)
    return filled


def width(latex: str) -> int:
    """How many signs a formula has, about: what takes no room is not counted, and a relation takes more."""
    wide = re.sub(r"\\(?:Leftrightarrow|Rightarrow|land|lor|quad|qquad|le|ge|approx)(?![A-Za-z])|=", " xxx", latex)
    wide = re.sub(r"\\(?:sin|cos|tan|operatorname)(?![A-Za-z])", " xxx", wide)
    bare = re.sub(r"\\(?:left|right|frac|mathbf|displaystyle|begin|end)(?![A-Za-z])|\\[,;:! ]", "", wide)
    one_each = re.sub(r"\\[A-Za-z]+", "x", bare)  # before spaces go: "\psi xxx" is four signs, not one command
    return len(re.sub(r"[{}_^\s]", "", one_each))


def equations(values: Mapping[str, Expr], notation: Notation) -> list[str]:
    """Rows "name & = expression" of an aligned display."""
    return [
        row
        for name, value in values.items()
        for row in _rows(f"{letter(name, notation)} & = ", lines(sp.sympify(value), notation))
    ]


def expressions(values: Iterable[Expr], notation: Notation) -> list[str]:
    """Rows of an aligned display without names."""
    return [row for value in values for row in _rows("& ", lines(sp.sympify(value), notation))]


def _rows(head: str, broken: list[str]) -> Iterator[str]:
    yield head + broken[0]
    yield from (rf"& \qquad {line}" for line in broken[1:])


def aligned(rows: list[str]) -> str:
    """The rows under each other, at their marks."""
    return r"\begin{aligned}" + r" \\[4pt] ".join(rows) + r"\end{aligned}"
