"""Printed LaTeX -> the tree as printed -> formulas. The one trusted way from a paper to a statement."""

from symcheck.reading.edits import Edit, edits
from symcheck.reading.lowering import free_indices, lower, term
from symcheck.reading.notation import Letter, Notation
from symcheck.reading.parser import read
from symcheck.reading.printing import to_latex
from symcheck.reading.relations import Relation, relations
from symcheck.reading.sympy_bridge import from_sympy, to_sympy
from symcheck.reading.tex import split_tag
from symcheck.reading.tree import System, Tree

__all__ = [
    "Edit",
    "Letter",
    "Notation",
    "Relation",
    "System",
    "Tree",
    "edits",
    "free_indices",
    "from_sympy",
    "lower",
    "read",
    "relations",
    "split_tag",
    "term",
    "to_latex",
    "to_sympy",
]
