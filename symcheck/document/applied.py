"""Functions at places, and integrals of functions: letters that stand for them, and what these are by definitions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from symcheck.core.verdicts import SymcheckError

if TYPE_CHECKING:
    from sympy import Expr, Symbol

OF = "function of "  # a phrase


@dataclass(frozen=True)
class Known:
    """What equations say that functions and letters are, and at which letters a function is printed without them."""

    functions: Mapping[Any, tuple[tuple[Symbol, ...], Expr]] = field(default_factory=dict)
    letters: Mapping[Symbol, Expr] = field(default_factory=dict)
    own: Mapping[Any, tuple[Expr, ...]] = field(default_factory=dict)


NOTHING = Known()


def known_of(
    given: Iterable[tuple[Expr, Expr]], others: Iterable[tuple[Expr, Expr]], said: Iterable[tuple[str, str]] = ()
) -> Known:
    """What given equations say; the others only print functions at letters.

    Of a function that is said at several letters, `said` tells which one stands for any value.
    """
    from sympy.core.function import AppliedUndef

    given = [*given]
    functions: dict[Any, tuple[tuple[Symbol, ...], Expr]] = {}
    letters: dict[Symbol, Expr] = {}
    own: dict[Any, tuple[Expr, ...]] = {}
    of = {_name(x): (*map(_name, phrase.removeprefix(OF).split(",")),) for x, phrase in said if phrase.startswith(OF)}
    both = [(*sides, sides in given) for sides in (*given, *others)]
    for head, value, is_given in (*both, *((right, left, is_given) for left, right, is_given in both)):
        if head.is_Symbol and is_given and head not in value.free_symbols:
            letters.setdefault(head, value)
        if isinstance(head, AppliedUndef) and _at_letters(head):
            if any(each.func == head.func for each in value.atoms(AppliedUndef)):
                continue
            if not {*head.args} <= value.free_symbols or of.get(str(head.func), names := _names(head)) != names:
                continue  # its value at one place
            own.setdefault(head.func, head.args)
            if is_given:
                functions.setdefault(head.func, (head.args, value))
    every = {each for left, right, _ in both for side in (left, right) for each in side.atoms(AppliedUndef)}
    for each in sorted(filter(_at_letters, every), key=lambda x: (of.get(str(x.func)) != _names(x), str(x))):
        own.setdefault(each.func, each.args)
    return Known(functions, letters, own)


def _name(letter: str) -> str:
    """A letter as SymPy names it."""
    return re.sub(r"[\\{}\s]", "", letter)


def _names(term: Any) -> tuple[str, ...]:
    return tuple(str(x) for x in term.args)


def _at_letters(term: Any) -> bool:
    from sympy import Dummy

    symbols = all(each.is_Symbol and not isinstance(each, Dummy) for each in term.args)
    return symbols and len({*term.args}) == len(term.args)


def is_special(side: Expr) -> bool:
    """Does a side hold integrals, or functions elsewhere than at letters?"""
    from sympy import Integral, Subs
    from sympy.core.function import AppliedUndef

    return side.has(Integral, Subs) or not all(map(_at_letters, side.atoms(AppliedUndef)))


def lettered(side: Expr, known: Known = NOTHING, primed: bool = False) -> tuple[Expr, dict[Expr, Symbol]]:
    """A side with a letter for each function, rate of change and integral of functions, and what these stand for.

    Where it is primed, a derivative by a letter is that of the function at this letter.
    """
    found: dict[Expr, Symbol] = {}
    return _lettered(side, known, primed, found), found


def _lettered(tree: Any, known: Known, primed: bool, found: dict[Expr, Symbol]) -> Any:
    from sympy import Derivative, Integral, Subs, Symbol
    from sympy.core.function import AppliedUndef

    if not tree.args:
        return tree
    of = tree.expr if isinstance(tree, Derivative) and isinstance(tree.expr, AppliedUndef) else None
    if of is not None and primed and known.own.get(of.func, of.args) != of.args:
        places = [Symbol(f"place_{n}", real=True) for n in range(len(of.args))]
        slope = Derivative(of.func(*places), *((places[of.args.index(x)], n) for x, n in tree.variable_count))
        tree = Subs(slope, tuple(places), of.args)
    open_ = isinstance(tree, Derivative | Subs | AppliedUndef)
    if isinstance(tree, Integral):
        by = {*tree.variables}
        defined = (known.letters[x] for x in tree.function.free_symbols - by if x in known.letters)
        open_ = tree.has(AppliedUndef, Derivative, Subs) or any(by & value.free_symbols for value in defined)
        if not open_:
            return tree
    if open_:
        if isinstance(tree, Derivative) and of is not None:
            _lettered(of, known, primed, found)
        named = isinstance(tree, AppliedUndef) and all(x.is_Symbol for x in tree.args)
        named = named and known.own.get(tree.func, tree.args) == tree.args
        return found.setdefault(tree, Symbol(tree.func.__name__ if named else str(tree), real=True))
    parts = [_lettered(part, known, primed, found) for part in tree.args]
    return tree if all(new is old for new, old in zip(parts, tree.args, strict=True)) else tree.func(*parts)


def valued(term: Expr, known: Known) -> Expr | None:
    """What an integral, or a function at a place, is by definitions; None if these do not say it."""
    from sympy import Derivative, Integral, Subs
    from sympy.core.function import AppliedUndef

    if isinstance(term, Derivative) or (isinstance(term, AppliedUndef) and known.own.get(term.func) == term.args):
        return None
    try:
        value: Expr = _valued(term, known)
    except SymcheckError:
        return None
    pure = isinstance(term, Integral) or not value.has(Integral)
    return value if pure and not value.has(AppliedUndef, Derivative, Subs) else None


def _valued(tree: Any, known: Known) -> Any:
    from sympy import Derivative, Integral, Subs
    from sympy.core.function import AppliedUndef

    if isinstance(tree, AppliedUndef) and tree.func in known.functions:
        letters, value = known.functions[tree.func]
        if len(letters) != len(tree.args):
            raise SymcheckError("a function has as many arguments as it is said to have")
        return value.subs(dict(zip(letters, (_valued(x, known) for x in tree.args), strict=True)), simultaneous=True)
    if isinstance(tree, Derivative) and isinstance(of := tree.expr, AppliedUndef) and of.func in known.functions:
        letters, value = known.functions[of.func]
        if of.args != letters and value.free_symbols.difference(letters) & {*tree.variables}:
            raise SymcheckError("by the letter, or by the place?")
        return _valued(of, known).diff(*tree.variable_count)
    if isinstance(tree, Subs):
        return _valued(tree.expr, known).subs(dict(zip(tree.variables, tree.point, strict=True)), simultaneous=True)
    if isinstance(tree, Integral):
        by = {*tree.variables}
        said = {x: known.letters[x] for x in tree.function.free_symbols - by if x in known.letters}
        said = {x: value for x, value in said.items() if by & value.free_symbols}
        limits = [(x, *(_valued(bound, known) for bound in bounds)) for x, *bounds in tree.limits]
        return Integral(_valued(tree.function.subs(said, simultaneous=True), known), *limits)
    return tree.func(*(_valued(part, known) for part in tree.args)) if tree.args else tree
