"""Checks what is said of dimensions, with whole numbers: it solves nothing, and trusts the rules of `rules` alone.

A certificate states the units of letters, and either what all other letters measure, so that every equation of
the formulas holds, or how many times each equation is taken for a sum in which base quantities alone are left.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import lcm

from symcheck.core.fields import by_key, listed, raw
from symcheck.core.terms import JSON, Formula
from symcheck.dimensions.rules import (
    Atom,
    Equation,
    Kind,
    Known,
    Linear,
    Rules,
    Scale,
    added,
    is_base,
    ratio,
    scaled_equations,
)

DOT = "·"  # between letters of an exponent and what they multiply
Written = dict[str, JSON]  # forms by name, each whole numbers by atom over one denominator


def written(forms: Mapping[str, Linear | None]) -> Written:
    """Forms as JSON data; null for what may measure anything."""
    return {name: None if form is None else _form(form) for name, form in forms.items()}


def _form(form: Linear) -> JSON:
    below = lcm(*(Fraction(n).denominator for n in form.values()))
    exponents: dict[str, JSON] = {_name(atom): int(n * below) for atom, n in form.items()}
    return [exponents, below]


def _name(atom: Atom) -> str:
    return DOT.join((*atom[0], atom[1])) if isinstance(atom, tuple) else atom


def _atom(name: str) -> Atom:
    *monomial, bare = name.split(DOT)
    return (tuple(monomial), bare) if monomial else bare


def fault(certificate: Mapping[str, JSON], formulas: Sequence[Formula]) -> str | None:
    """Why a certificate does not show what it states of formulas; None if it does.

    Parameters
    ----------
    certificate
        "units" of letters and "scales" that are 1; "letters", which shows that the formulas are consistent with these
        units, or "combination", which shows that they are not.
    formulas
        The relation, lowered.

    Returns
    -------
    str or None
        The first fault found.
    """
    try:
        known = _forms(certificate["units"])
        rules = Rules(known)
        for formula in formulas:
            rules.state(formula)
        scales = [Scale(name, form) for name, form in _forms(certificate["scales"]).items() if form is not None]
        return unlike(certificate, scaled_equations(rules.equations, scales))
    except (KeyError, TypeError, ValueError, ZeroDivisionError, IndexError) as error:
        return f"it is no certificate ({type(error).__name__}: {error})"


def unlike(certificate: Mapping[str, JSON], equations: Sequence[Equation]) -> str | None:
    """Why a certificate does not show what it states of equations; None if it does."""
    if "letters" in certificate:
        return _unlike(equations, _forms(certificate["letters"]))
    return _no_conflict(equations, certificate["combination"])


def _forms(data: JSON) -> Known:
    found: Known = {}
    for name, form in by_key(raw)(data).items():
        if form is None:
            found[name] = None
            continue
        exponents, below = listed(raw, 2)(form)
        found[name] = {_atom(x): ratio(_whole(n), _whole(below)) for x, n in by_key(raw)(exponents).items()}
    return found


def _whole(data: object) -> int:
    if type(data) is not int:
        raise ValueError(f"{data!r} is no whole number")
    return data


def _unlike(equations: Sequence[Equation], letters: Known) -> str | None:
    """The first equation that does not hold where letters measure this."""
    for name, form in letters.items():
        if name[:1] in ("[", "?") or form is None or not all(map(_is_known, form)):
            return f"it does not say what {name} measures"
    for number, each in enumerate(equations):
        if each.kind is not Kind.DEFAULT and (left := _inserted(each.form, letters)):
            return f"in equation {number} {', '.join(map(_name, left))} are left"
    return None


def _inserted(form: Linear, letters: Known) -> Linear:
    total: Linear = {}
    for atom, n in form.items():
        monomial, bare = atom if isinstance(atom, tuple) else ((), atom)
        value = letters.get(bare) or ({} if bare in letters else {bare: 1})
        total = added(total, {_under(monomial, each): m for each, m in value.items()}, n)
    return total


def _under(monomial: tuple[str, ...], atom: Atom) -> Atom:
    more, bare = atom if isinstance(atom, tuple) else ((), atom)
    both = tuple(sorted((*monomial, *more)))
    return (both, bare) if both else bare


def _is_known(atom: Atom) -> bool:
    return is_base(atom[1] if isinstance(atom, tuple) else atom)


def _no_conflict(equations: Sequence[Equation], combination: JSON) -> str | None:
    """Why a sum of equations is no contradiction: letters are left in it, or nothing is."""
    total: Linear = {}
    for number, factor in (listed(raw, 2)(pair) for pair in listed(raw)(combination)):
        each = equations[_whole(number)] if _whole(number) >= 0 else None
        if each is None or each.kind is not Kind.RULE:
            return f"equation {number} is none that must hold"
        total = added(total, each.form, _whole(factor))
    if left := [atom for atom in total if not is_base(atom)]:
        return f"{', '.join(map(_name, left))} are left"
    return None if total else "nothing is left"
