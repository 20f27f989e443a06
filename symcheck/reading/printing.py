"""The tree printed back as LaTeX: reading the result gives the same tree."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextvars import ContextVar
from typing import Any

from symcheck.reading import tex
from symcheck.reading.functions import COMMANDS, FIELDS
from symcheck.reading.tree import (
    BRACKETED,
    Add,
    And,
    Antiderivative,
    Bars,
    BigProduct,
    BigSum,
    Binomial,
    Blank,
    Call,
    CaseList,
    Chain,
    Cross,
    Degrees,
    Derivative,
    Diag,
    Div,
    Dots,
    ElementsOf,
    Evaluated,
    Exists,
    Factorial,
    Forall,
    Given,
    Iff,
    Implies,
    Indexed,
    Infinity,
    Integral,
    Interval,
    Limiting,
    Located,
    Marked,
    MatrixOf,
    Mean,
    Mul,
    Name,
    Neg,
    Norm,
    Number,
    Operated,
    Or,
    Over,
    Pair,
    Piecewise,
    PlusMinus,
    Pow,
    Qualifier,
    Root,
    Sqrt,
    System,
    Total,
    Transpose,
    Tree,
    Tuple,
    Values,
    Words,
    walk,
)

# how tightly a printed form holds together: what is looser than its place needs is put in brackets
LIST, IMPLIES, OR, AND, CHAIN, SUM, TERM, PRODUCT, FACTOR, ATOM = range(10)
_LEVEL: dict[type[Tree], int] = {
    System: LIST, CaseList: LIST, Located: LIST, Exists: LIST, Qualifier: LIST, Values: LIST, Forall: LIST, Words: LIST,
    BigProduct: PRODUCT,
    Operated: TERM, Limiting: PRODUCT, Over: PRODUCT, Marked: FACTOR, Indexed: FACTOR, Iff: LIST,
    Implies: IMPLIES, Or: OR, And: AND, Chain: CHAIN, Add: SUM, Neg: SUM, PlusMinus: SUM, Cross: TERM, Mul: PRODUCT,
    BigSum: PRODUCT, Integral: PRODUCT, Antiderivative: PRODUCT, Call: FACTOR, Pow: FACTOR, Transpose: FACTOR,
    Total: FACTOR, Degrees: FACTOR, Derivative: FACTOR, Div: FACTOR,
}  # fmt: skip
_BRACKETS = (r"\left(", "(", "[")
_VECTOR = re.compile(r"\\(?:mathbf|boldsymbol|bm|pmb|vec)(?![a-z])")  # faces of vectors
_CONNECTIVE = {And: r" \land ", Or: r" \lor ", Implies: r" \Rightarrow ", Iff: r" \Leftrightarrow "}


_bracketed: ContextVar[bool] = ContextVar("whether arguments of functions stand in brackets", default=False)


def with_brackets(tree: Tree) -> str:
    r"""Print a tree with brackets around all arguments of functions that are more than a letter or a number.

    Parameters
    ----------
    tree
        What was read.

    Returns
    -------
    str
        LaTeX that reads as this tree, and that a person cannot read otherwise.

    See Also
    --------
    to_latex : With no more brackets than needed.

    Examples
    --------
    >>> from symcheck.reading import Letter, Notation, read
    >>> letters = Notation([Letter("a", depends="")])
    >>> with_brackets(read(r"\sin 2a = a", letters))
    '\\sin\\left(2 a\\right) = a'
    """
    before = _bracketed.set(True)
    try:
        return to_latex(tree)
    finally:
        _bracketed.reset(before)


def to_latex(tree: Tree) -> str:
    """Print a tree.

    Parameters
    ----------
    tree
        What was read.

    Returns
    -------
    str
        LaTeX that reads as this tree, with no more brackets than needed.
    """
    return _print(tree, LIST)


def _print(tree: Tree, level: int) -> str:
    text = _PRINTERS[type(tree)](tree)
    return text if _level(tree) >= level else rf"\left({text}\right)"


def _level(tree: Tree) -> int:
    if isinstance(tree, Derivative) and not _is_short(tree.body):
        return PRODUCT
    if isinstance(tree, Call) and not tree.arguments:
        return ATOM
    return _LEVEL.get(type(tree), ATOM)


def _index(value: int | str) -> str:
    return f"{value} " if isinstance(value, str) and value.startswith("\\") else str(value)


def _name(tree: Name) -> str:
    text = _dotted(tree.letter, tree.dots) + "'" * tree.primes
    if not tree.subscripts:
        return text
    several = len(tree.subscripts) > 1 and any(isinstance(v, int) and v > 9 for v in tree.subscripts)
    inside = (", " if several else "").join(map(_index, tree.subscripts)).strip()
    return f"{text}_{inside}" if len(inside) == 1 else f"{text}_{{{inside}}}"


def _dotted(letter: str, dots: int) -> str:
    """The letter below dots; a subscript that belongs to it stands behind them."""
    if not dots:
        return letter
    if " " in letter:
        return tex.with_dots(letter, dots)
    base, underscore, rest = letter.partition("_") if not letter.endswith("}") or "_{" in letter else (letter, "", "")
    return rf"\{'d' * dots}ot{{{base}}}{underscore}{rest}"


def _add(tree: Add) -> str:
    text = ""
    for k, term in enumerate(tree.terms):
        if isinstance(term, PlusMinus):
            text += (" " if k else "") + _plus_minus(term)
        elif isinstance(term, Neg):
            text += (" - " if k else "-") + _ended(term.value, last=k + 1 == len(tree.terms))
        else:
            text += (" + " if k else "") + _ended(term, last=k + 1 == len(tree.terms))
    return text


def _ended(term: Tree, *, last: bool) -> str:
    """A term; one that ends with a maximum, or its like, stands in brackets before a sign."""
    end = term.factors[-1] if isinstance(term, Mul) else term
    limits = isinstance(end, Limiting) and end.operator not in ("sum", "prod")
    return _print(term, ATOM if limits and not last else TERM)


def _plus_minus(tree: PlusMinus) -> str:
    return rf"\{'mp' if tree.minus else 'pm'} {_print(tree.value, TERM)}"


def _mul(tree: Mul) -> str:
    text = ""
    last = len(tree.factors) - 1
    for k, factor in enumerate(tree.factors):
        shown = _factor(factor, last=k == last)
        if k:
            needed = not _is_gradient(tree.factors, k) and _needs_dot(tree.factors[k - 1], factor)
            text += r" \cdot " if k in tree.dotted or needed else " "
        within = k != last and k + 1 not in tree.dotted and _is_gradient(tree.factors, k + 1)
        text += rf"\left({shown}\right)" if within else shown
    return text


def _is_gradient(factors: tuple[Tree, ...], k: int) -> bool:
    """Does a derivative by a vector stand before these brackets, where a dot would be a scalar product?"""
    before = factors[k - 1]
    vectors = isinstance(before, Derivative) and _VECTOR.search(_print(before, FACTOR))
    return bool(vectors) and _print(factors[k], FACTOR).startswith(_BRACKETS)


def _factor(factor: Tree, *, last: bool) -> str:
    if isinstance(factor, BigSum | Integral | Antiderivative | Limiting | Over) and last:
        return _print(factor, PRODUCT)
    return _print(factor, FACTOR)


def _needs_dot(before: Tree, factor: Tree) -> bool:
    """Would juxtaposition be read as something else?"""
    first = _first(factor)
    if isinstance(first, Number):
        return True
    if isinstance(before, Number):
        return isinstance(factor, Div) and isinstance(factor.top, Number) and isinstance(factor.bottom, Number)
    shown = _print(factor, FACTOR)
    if shown.startswith(_BRACKETS) and (
        isinstance(before, Derivative) or any(_is_function_letter(n) for _, n in walk(before))
    ):
        return True
    if isinstance(before, Pow) and isinstance(before.base, Call | Name):
        before = before.base
    if isinstance(before, Call) and isinstance(before.function, str) and _is_bare(before):
        called = isinstance(first, Call) and isinstance(first.function, Name)
        if isinstance(first, Name | Div) or called or shown.startswith(_BRACKETS):
            return True
        argument = before.arguments[0]
        before = argument.factors[-1] if isinstance(argument, Mul) else argument
    if not shown.startswith(_BRACKETS):
        return False
    return _is_function_letter(before) or (isinstance(before, Name) and not isinstance(factor, Add | Neg | PlusMinus))


def _is_function_letter(tree: Tree) -> bool:
    return isinstance(tree, Call) and not tree.arguments


def _first(tree: Tree) -> Tree:
    while isinstance(tree, Pow | Transpose | Degrees) and not isinstance(tree, Call):
        tree = tree.base if isinstance(tree, Pow) else tree.value
    return tree


_IN_BRACKETS = BRACKETED | {*FIELDS, "average", "overlined"}  # functions whose argument is printed in brackets


def _is_bare(tree: Call) -> bool:
    """Can the argument of a function stand without brackets?"""
    if len(tree.arguments) != 1 or str(tree.function).partition("_")[0] in _IN_BRACKETS:
        return False
    argument = tree.arguments[0]
    factors = argument.factors if isinstance(argument, Mul) else (argument,)
    return all(_is_plain(f) for f in factors[1:]) and (isinstance(factors[0], Number) or _is_plain(factors[0]))


def _is_plain(tree: Tree) -> bool:
    """A letter that is no vector by its print."""
    if _is_function_letter(tree):
        return True
    return isinstance(tree, Name) and "mathbf" not in tree.letter and "boldsymbol" not in tree.letter


def _call(tree: Call, power: str = "") -> str:
    inside = ", ".join(_print(a, SUM) for a in tree.arguments)
    if isinstance(tree.function, Name):
        return f"{_name(tree.function)}({inside})" if tree.arguments else _name(tree.function)
    name, _, below = tree.function.partition("_")
    head = name if name in COMMANDS else rf"operatorname{{{name}}}" + (f"_{below}" if below else "")
    if below and name in ("grad", "derivative"):  # by what
        head = ("nabla" if name == "grad" else "partial") + f"_{below}"
    single = isinstance(tree.arguments[0], Name | Number)
    if _is_bare(tree) and (single or not _bracketed.get()):
        return rf"\{head}{power} {inside}"
    return rf"\{head}{power}\left({inside}\right)"


def _pow(tree: Pow) -> str:
    exponent = _print(tree.exponent, SUM)
    power = f"^{exponent}" if len(exponent) == 1 else f"^{{{exponent}}}"
    base = tree.base
    if isinstance(base, Call) and isinstance(base.function, str):
        if isinstance(tree.exponent, Neg):
            return rf"\left({_call(base)}\right){power}"
        return _call(base, power)
    if isinstance(base, Name) and base.primes and not base.subscripts:
        return f"{_name(base)}{power}"
    return _base(base) + power


def _base(base: Tree) -> str:
    """What an exponent stands on."""
    if isinstance(base, Call) and isinstance(base.function, Name):
        return _print(base, FACTOR)
    return _print(base, ATOM)


def _sum(tree: BigSum) -> str:
    low = f" = {_print(tree.low, SUM)}" if tree.low is not None else ""
    high = f"^{{{_print(tree.high, SUM)}}}" if tree.high is not None else ""
    sign = r"\prod" if isinstance(tree, BigProduct) else r"\sum"
    return rf"{sign}_{{{', '.join(tree.indices)}{low}}}{high} {_print(tree.body, PRODUCT)}"


def _operator(tree: Limiting) -> str:
    return rf"\{tree.operator}" if tree.operator in ("sum", "prod", "int") else rf"\operatorname{{{tree.operator}}}"


def _integral(tree: Integral) -> str:
    bounds = f"_{{{_print(tree.low, SUM)}}}^{{{_print(tree.high, SUM)}}}"
    return rf"\int{bounds} {_print(tree.body, PRODUCT)} \, d{_print(tree.variable, ATOM)}"


def _piecewise(tree: Piecewise) -> str:
    rows = [
        rf"{_print(value, SUM)} & {_print(where, CHAIN) if where is not None else chr(92) + 'text{otherwise}'}"
        for value, where in tree.cases
    ]
    return rf"\begin{{cases}} {(' ' + chr(92) * 2 + ' ').join(rows)} \end{{cases}}"


def _evaluated(tree: Evaluated) -> str:
    body = rf"\left[{_print(tree.body, SUM)}\right]_{{{_print(tree.variable, ATOM)} = "
    if tree.low is None:
        return rf"{body}{_print(tree.high, SUM)}}}"
    return rf"{body}{_print(tree.low, SUM)}}}^{{{_print(tree.high, SUM)}}}"


def _operand(tree: Tree) -> str:
    """The left side of a cross product: a sum must not run on into it."""
    last = tree.factors[-1] if isinstance(tree, Mul) else tree
    return _print(tree, ATOM if isinstance(last, BigSum | Integral | Limiting | Over) else PRODUCT)


def _is_short(body: Tree) -> bool:
    return isinstance(body, Name | Mul | Call)


def _derivative(tree: Derivative) -> str:
    d = r"\partial " if tree.partial else "d"
    total = sum(order for _, order in tree.variables)
    power = f"^{total}" if total > 1 else ""
    below = " ".join(f"{d}{_print(v, FACTOR)}{f'^{n}' if n > 1 else ''}" for v, n in tree.variables)
    if _is_short(tree.body):
        return rf"\frac{{{d.strip()}{power} {_print(tree.body, PRODUCT)}}}{{{below}}}"
    if isinstance(tree.body, Blank):  # an operator that stands alone
        return rf"\frac{{{d.strip()}{power}}}{{{below}}}"
    return rf"\frac{{{d.strip()}{power}}}{{{below}}} \left({_print(tree.body, SUM)}\right)"


def _matrix(tree: MatrixOf) -> str:
    rows = r" \\ ".join(" & ".join(_print(entry, SUM) for entry in row) for row in tree.rows)
    return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}"


def _tuple(tree: Tuple) -> str:
    inside = ", ".join(_print(item, SUM) for item in tree.items)
    left, right = {"()": ("(", ")"), "[]": ("[", "]"), "{}": (r"\{", r"\}")}[tree.kind]
    return f"{left}{inside}{right}"


def _chain(tree: Chain) -> str:
    text = _print(tree.members[0], SUM)
    for sign, member in zip(tree.signs, tree.members[1:], strict=True):
        text += f" {sign} {_print(member, SUM)}"
    return text


def _qualifier(tree: Qualifier) -> str:
    return f"{', '.join(tree.indices)} = {', '.join(map(str, tree.values))}"


def _values(tree: Values) -> str:
    return f"{_print(tree.name, ATOM)} = {', '.join(_print(value, SUM) for value in tree.values)}"


def _system(tree: System) -> str:
    parts = [_part(part) for part in tree.parts]
    return r", \quad ".join([*parts, *map(_qualifier, tree.qualifiers)])


def _part(part: Tree) -> str:
    return _print(part, LIST if isinstance(part, Located | Values | Forall | Words) else AND)


def _cases(tree: CaseList) -> str:
    return r"; \quad ".join(f"{label} {to_latex(case)}" for label, case in tree.cases)


def _joined(tree: And | Or) -> str:
    level = CHAIN if isinstance(tree, And) else AND
    return _CONNECTIVE[type(tree)].join(_print(part, level) for part in tree.parts)


def _arrow(tree: Implies | Iff) -> str:
    return _CONNECTIVE[type(tree)].join([_print(tree.left, OR), _print(tree.right, OR)])


def _exists(tree: Exists) -> str:
    names = ", ".join(_print(name, ATOM) for name in tree.names)
    return rf"\exists {names} : {_print(tree.body, OR)}"


_PRINTERS: dict[type[Tree], Callable[[Any], str]] = {
    Number: lambda t: t.text,
    Name: _name,
    Add: _add,
    Neg: lambda t: f"-{_print(t.value, TERM)}",
    Mul: _mul,
    Div: lambda t: rf"\frac{{{_print(t.top, SUM)}}}{{{_print(t.bottom, SUM)}}}",
    Pow: _pow,
    Call: _call,
    Sqrt: lambda t: rf"\sqrt{{{_print(t.value, SUM)}}}",
    Root: lambda t: rf"\sqrt[{_print(t.order, SUM)}]{{{_print(t.value, SUM)}}}",
    Binomial: lambda t: rf"\binom{{{_print(t.top, SUM)}}}{{{_print(t.bottom, SUM)}}}",
    Norm: lambda t: rf"\left\|{_print(t.value, SUM)}\right\|",
    Antiderivative: lambda t: rf"\int {_print(t.body, PRODUCT)} \, d{_print(t.variable, ATOM)}",
    Evaluated: _evaluated,
    Piecewise: _piecewise,
    Factorial: lambda t: f"{_base(t.value)}!",
    Degrees: lambda t: rf"{_print(t.value, ATOM)}^\circ",
    BigSum: _sum,
    BigProduct: _sum,
    Limiting: lambda t: rf"{_operator(t)}{t.scripts} {_print(t.body, PRODUCT)}",
    Over: lambda t: rf"{t.sign}{t.below} {_print(t.body, PRODUCT)} \, d{_print(t.variable, ATOM)}",
    Marked: lambda t: rf"\left({_print(t.value, SUM)}\right){t.mark}",
    Indexed: lambda t: f"{_print(t.name, ATOM)}[{', '.join(_print(place, SUM) for place in t.places)}]",
    Operated: lambda t: rf"{_operand(t.left)} {t.sign} {_operand(t.right)}",
    Given: lambda t: f"{', '.join(map(to_latex, t.items))} {t.sign} {', '.join(map(to_latex, t.conditions))}",
    Words: lambda t: to_latex(t.name),
    Forall: lambda t: rf"\forall {_print(t.scope, CHAIN)}",
    Pair: lambda t: f"({_print(t.left, SUM)}, {_print(t.right, SUM)})",
    Infinity: lambda t: r"\infty",
    Integral: _integral,
    Interval: lambda t: f"{t.ends[0]}{_print(t.low, SUM)}, {_print(t.high, SUM)}{t.ends[1]}",
    Mean: lambda t: rf"\langle {_print(t.body, SUM)} \rangle_{{{_print(t.phase, ATOM)}}}",
    PlusMinus: _plus_minus,
    Values: _values,
    Tuple: _tuple,
    Cross: lambda t: rf"{_operand(t.left)} \times {_print(t.right, PRODUCT)}",
    Transpose: lambda t: f"{_base(t.value)}^T",
    MatrixOf: _matrix,
    Diag: lambda t: rf"\operatorname{{diag}}({', '.join(_print(e, SUM) for e in t.entries)})",
    Bars: lambda t: rf"\left|{_print(t.value, SUM)}\right|",
    ElementsOf: lambda t: rf"\left\|{_print(t.value, SUM)}\right\|",
    Derivative: _derivative,
    Total: lambda t: (
        f"d{_print(t.value, ATOM)}" if isinstance(t.value, Name) else rf"d\left({_print(t.value, SUM)}\right)"
    ),
    Blank: lambda t: "",
    Dots: lambda t: r"\dots",
    Chain: _chain,
    Qualifier: _qualifier,
    System: _system,
    CaseList: _cases,
    Located: lambda t: f"{_print(t.place, SUM)} : {_print(t.statement, IMPLIES)}",
    And: _joined,
    Or: _joined,
    Implies: _arrow,
    Iff: _arrow,
    Exists: _exists,
}
