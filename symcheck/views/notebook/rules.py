"""What a cell may hold: calls of the package and names for their results. Mathematics belongs in the package.

A cell of code imports from symcheck and a few names of NumPy, gives results names, and ends in what it shows. It
defines no function or class, writes no formula (no operator but a sign, no comparison, no LaTeX), and reaches into no
module for SymPy or a solver. Prose has letters between dollars, and no relations: those come from the records.
"""

from __future__ import annotations

import ast
import builtins
import re
from collections.abc import Iterator

ALLOWED = (ast.Import, ast.ImportFrom, ast.Assign, ast.Expr)
PARTS = (
    *(
        ast.alias,
        ast.Attribute,
        ast.Call,
        ast.Constant,
        ast.Dict,
        ast.keyword,
        ast.List,
        ast.Load,
        ast.Module,
        ast.Name,
    ),
    *(ast.Slice, ast.Starred, ast.Store, ast.Subscript, ast.Tuple, ast.UnaryOp, ast.USub),
)
NUMPY = frozenset({"linspace", "radians", "degrees"})  # grids and units
BUILTINS = frozenset({"dict", "float", "int", "len", "list", "round", "set", "sorted", "tuple"})
# what makes a formula a statement
_RELATION = re.compile(r"[=<>]|\\(?:le|ge|lt|gt|leq|geq|neq?|approx|equiv|sim|to|mapsto|in)(?![A-Za-z])")
_MATHEMATICS = re.compile(r"\$([^$]+)\$")  # mathematics within a sentence


def faults_of_code(text: str) -> Iterator[str]:
    """What a cell of code does that it may not, one line each."""
    try:
        tree = ast.parse(text)
    except SyntaxError as error:
        yield f"is not valid Python ({error.msg})"
        return
    imported = {name for statement in tree.body for name in _imported(statement)}
    for statement in tree.body:
        if not isinstance(statement, ALLOWED):
            yield f"has a statement {type(statement).__name__.lower()}; a cell imports, names results and shows"
    for node in ast.walk(tree):
        yield from _faults(node, imported)
    if not tree.body or isinstance(tree.body[-1], ast.Assign):
        yield "shows nothing; its last line must be what it shows"


def _imported(statement: ast.stmt) -> Iterator[str]:
    if isinstance(statement, ast.Import | ast.ImportFrom):
        yield from (alias.asname or alias.name for alias in statement.names)


def _faults(node: ast.AST, imported: set[str]) -> Iterator[str]:
    match node:
        case ast.Import(names=names):
            yield from (f"imports {each.name}; import from symcheck" for each in names)
        case ast.ImportFrom(module="numpy", names=names):
            yield from (
                f"imports {each.name} of NumPy; only {', '.join(sorted(NUMPY))}"
                for each in names
                if each.name not in NUMPY
            )
        case ast.ImportFrom(module=module):
            if not f"{module}.".startswith("symcheck."):
                yield f"imports from {module}; import from symcheck"
        case ast.Attribute(attr=name) if name.startswith("_") or name in ("sp", "np", "sympy", "numpy", "lazy"):
            yield f"reaches for {name}; call a public function of the package"
        case ast.Name(id=name, ctx=ast.Load()) if name.startswith("__"):
            yield f"reaches for {name}"
        case ast.Constant(value=str(text)) if "\\" in text or _RELATION.search(text):
            yield f"holds the formula {text!r}; formulas come from the records"
        case ast.Call(func=ast.Name(id=name)) if name in vars(builtins) and name not in BUILTINS | imported:
            yield f"calls {name}; a cell calls functions of the package"
        case ast.stmt() | ast.expr_context() | ast.Attribute() | ast.Name() | ast.Constant():
            return
        case _ if not isinstance(node, PARTS):
            yield f"holds a {type(node).__name__.lower()}; computing belongs in the package"


def faults_of_prose(text: str) -> Iterator[str]:
    """What a cell of prose states that it may not."""
    if "$$" in text or r"\[" in text or r"\begin" in text:
        yield "displays a formula; formulas come from the records"
    for found in _MATHEMATICS.finditer(text):
        if _RELATION.search(found[1]):
            yield f"states {found[0]}; relations come from the records"
