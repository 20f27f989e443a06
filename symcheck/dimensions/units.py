"""What a unit measures: exact exponents of base quantities, and their spelling.

The units below are the coherent ones of the SI and those that are numbers; a test compares them with pint's registry,
which is asked, and imported, for all others. A name in square brackets is a base quantity of its own: `[rad]/s` counts
turns, `[EUR]/kg` is a price.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache
from types import MappingProxyType
from typing import Any

from symcheck.core.extras import installing
from symcheck.core.verdicts import SymcheckError

Dimension = Mapping[str, Fraction]  # exponents by base quantity, such as "kg"; without zeros
NUMBER: Dimension = MappingProxyType({})
SI: dict[str, dict[str, int]] = {
    **{name: {name: 1} for name in ("kg", "m", "s", "A", "K", "mol", "cd")},
    **{name: {} for name in ("rad", "sr", "deg", "degree", "percent")},
    "g": {"kg": 1},
    "Hz": {"s": -1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "C": {"A": 1, "s": 1},
    "V": {"kg": 1, "m": 2, "s": -3, "A": -1},
    "ohm": {"kg": 1, "m": 2, "s": -3, "A": -2},
    "S": {"kg": -1, "m": -2, "s": 3, "A": 2},
    "F": {"kg": -1, "m": -2, "s": 4, "A": 2},
    "H": {"kg": 1, "m": 2, "s": -2, "A": -2},
    "T": {"kg": 1, "s": -2, "A": -1},
    "Wb": {"kg": 1, "m": 2, "s": -2, "A": -1},
}
_BASES = {
    "[mass]": "kg", "[length]": "m", "[time]": "s", "[current]": "A", "[temperature]": "K", "[substance]": "mol",
    "[luminosity]": "cd",
}  # fmt: skip
# a base quantity in brackets or a name; a number; a sign between them
_TOKEN = re.compile(r"\s*(?:(\[[^\[\]]+\]|[^\W\d_]\w*|µ\w*|%|°\w*)|(\d+(?:\.\d+)?)|(\*\*|[-+*/^().·⋅]))")
LONGEST, MOST = 200, 99  # characters of a unit; the largest exponent: beyond are slips


@lru_cache(maxsize=1024)
def dimension(unit: str) -> Dimension:
    """The exponents that a unit stands for.

    Parameters
    ----------
    unit
        Such as `kg m^2/s`, `N m s/rad`, `1`, `1/s^(1/2)`: what stands behind a slash up to the next space, product or
        end is divided by; names are those of pint.

    Returns
    -------
    mapping of str to Fraction
        By base quantity; empty for a number.

    Raises
    ------
    SymcheckError
        If there is no such unit, or it is not spelled as one; the message has the way out.

    Examples
    --------
    >>> shown(dimension("N m s/rad"))
    'kg m^2/s'
    """
    if len(unit) > LONGEST:
        raise SymcheckError(f"the unit {unit[:40]}... has {len(unit)} characters; more than {LONGEST} are no unit")
    tokens, at = list[str](), 0
    while unit[at:].strip():
        found = _TOKEN.match(unit, at)
        if not found:
            raise _fault(unit, f"{unit[at:].strip()[0]!r} is no part of a unit")
        tokens.append(found[0].strip())
        at = found.end()
    if not tokens:
        raise _fault(unit, "it is empty; write 1 for a number")
    total, rest = _product(unit, tokens)
    if rest:
        raise _fault(unit, f"{rest[0]!r} closes nothing")
    return MappingProxyType(total)


def _fault(unit: str, why: str) -> SymcheckError:
    return SymcheckError(f"{unit!r} is no unit: {why}; units are written as kg m^2/s or 1/s^(1/2)")


def _product(unit: str, tokens: list[str]) -> tuple[dict[str, Fraction], list[str]]:
    """The product up to the end or a closing bracket, and what is left."""
    total: dict[str, Fraction] = {}
    sign, open_ = 1, True
    while tokens and tokens[0] != ")":
        if tokens[0] in ("*", "·", "⋅", "/", "."):
            if open_:
                raise _fault(unit, f"nothing stands before {tokens[0]!r}")
            sign, open_ = (-1 if tokens[0] == "/" else 1), True
            tokens = tokens[1:]
            continue
        factor, tokens = _factor(unit, tokens)
        for base, n in factor.items():
            total[base] = total.get(base, Fraction(0)) + sign * n
        sign, open_ = 1, False
    if open_:
        raise _fault(unit, "a factor is missing")
    return {base: n for base, n in total.items() if n}, tokens


def _factor(unit: str, tokens: list[str]) -> tuple[dict[str, Fraction], list[str]]:
    head, *rest = tokens
    if head == "(":
        value, rest = _product(unit, rest)
        if not rest:
            raise _fault(unit, "a bracket is not closed")
        rest = rest[1:]
    elif head[0].isdigit():
        value = {}
    elif head[0].isalpha() or head[0] in "[µ%°":
        value = dict(_named(unit, head))
    else:
        raise _fault(unit, f"nothing stands before {head!r}")
    if rest and rest[0] in ("^", "**"):
        power, rest = _exponent(unit, rest[1:])
        value = {base: n * power for base, n in value.items()}
    return value, rest


def _exponent(unit: str, tokens: list[str]) -> tuple[Fraction, list[str]]:
    bracket = tokens[:1] == ["("]
    end = tokens.index(")") if bracket and ")" in tokens else 0
    if bracket and not end:
        raise _fault(unit, "a bracket is not closed")
    inside = tokens[1:end] if bracket else tokens[: 2 if tokens[:1] in (["-"], ["+"]) else 1]
    try:
        power = Fraction("".join(inside))
    except (ValueError, ZeroDivisionError):
        raise _fault(unit, f"{''.join(inside)!r} is no exponent") from None
    if abs(power) > MOST or power.denominator > MOST:
        raise _fault(unit, f"the exponent {power} is out of all proportion")
    return power, tokens[end + 1 :] if bracket else tokens[len(inside) :]


def _named(unit: str, name: str) -> Mapping[str, Fraction]:
    if name.startswith("["):
        return {_BASES.get(name, name[1:-1].strip()): Fraction(1)}
    if name in SI:
        return {base: Fraction(n) for base, n in SI[name].items()}
    return _of_pint(unit, name)


@lru_cache(maxsize=256)
def _of_pint(unit: str, name: str) -> Mapping[str, Fraction]:
    try:
        import pint
    except ImportError:
        raise SymcheckError(
            f"{unit!r} is no unit: {name!r} is none of {', '.join(SI)}; others need pint, `{installing('units')}`"
        ) from None
    try:
        registry: Any = pint.application_registry
        found = registry.parse_units(name).dimensionality
    except Exception as error:  # whatever a name of somebody else makes the parser of another project raise
        raise SymcheckError(
            f"{unit!r} is no unit: {name!r} is not known; a base quantity of its own is written [{name}]"
        ) from error
    return {_BASES.get(base, base[1:-1]): Fraction(n).limit_denominator(MOST) for base, n in found.items()}


def shown(measured: Mapping[str, Fraction]) -> str:
    """The spelling of a dimension, in base units: `kg m^2/s`; `1` for a number."""
    order = {base: k for k, base in enumerate(SI)}
    ordered = sorted(measured.items(), key=lambda pair: (order.get(pair[0], len(order)), pair[0]))
    top = " ".join(_power(base, n) for base, n in ordered if n > 0)
    bottom = [_power(base, -n) for base, n in ordered if n < 0]
    below = f"({' '.join(bottom)})" if len(bottom) > 1 else "".join(bottom)
    return f"{top or 1}/{below}" if below else top or "1"


def _power(base: str, n: Fraction) -> str:
    name = base if base in _BASES.values() else f"[{base}]"
    return name if n == 1 else f"{name}^{n}" if n.denominator == 1 else f"{name}^({n})"
