"""Printed LaTeX -> the tree as printed -> formulas. The one trusted way from a paper to a statement.

`tex` cuts the string into TeX tokens, `lexer` looks up the letters in the `notation` and settles line breaks, `grammar`
parses, `parser` builds the `tree`, `relations` takes it apart, `lowering` gives indices and components their values;
`printing` goes back, `edits` lists every slip of the pen.

Decision: the grammar knows products only as runs of factors; `parser` settles what an implicit product means.
Reason: it depends on the letters (`f_1(J_2)` applies, `k(J_1 + J_2)` multiplies), the grammar stays free of conflicts,
and each ambiguity is refused by name (`1/2x`, `\\sin x^2`, `\\sin x/2`). Not for documents: prose is not read.
"""

from symcheck.reading.edits import Edit, edits
from symcheck.reading.lexer import LAYOUT, layout
from symcheck.reading.lowering import algebraic, free_indices, lower, term
from symcheck.reading.notation import Letter, Notation
from symcheck.reading.parser import read
from symcheck.reading.printing import to_latex, with_brackets
from symcheck.reading.relations import Relation, relations
from symcheck.reading.sympy_bridge import from_sympy, to_sympy
from symcheck.reading.tex import split_tag
from symcheck.reading.tree import Iff, System, Tree

__all__ = [
    "LAYOUT",
    "Edit",
    "Iff",
    "Letter",
    "Notation",
    "Relation",
    "System",
    "Tree",
    "algebraic",
    "edits",
    "free_indices",
    "from_sympy",
    "layout",
    "lower",
    "read",
    "relations",
    "split_tag",
    "term",
    "to_latex",
    "to_sympy",
    "with_brackets",
]
