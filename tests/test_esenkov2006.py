"""Esenkov's damaged texts: nothing of them is left out, and the stability found is that of the equations of motion."""

from __future__ import annotations

import cmath
import math
import random
import re
from pathlib import Path

import pytest
from declarations import errata

from symcheck import papers
from symcheck.core.claims import Exclusion
from symcheck.papers.esenkov2006 import derivation

PAPER = papers.load()["esenkov2006"]
# what is no formula: Russian words, the heads and ends of pages, references, numbers of sections and formulas
PROSE = re.compile(
    r"\[стр\.,? ?\d+\]|\[Back\]|\[17,24,67\]|2006|§ 2|1\.[2-4](\.1)?|\((1\.13|2\.[13]|1\.3[1-5]|132)\)"
    r"|относительно Д|\b(29|34|35)\b|\b[А-Яа-я]{2,}\b|\b[Ввкаисп]\b|[().,\s]"
)


def test_every_character_outside_of_prose_belongs_to_a_declaration(sources: Path) -> None:
    text = re.sub(r"\s+", " ", (sources / PAPER.source).read_text(encoding="utf-8"))
    pieces = {re.sub(r"\s+", " ", piece) for _, _, item in PAPER.items() for piece in item.source.printed}
    for piece in sorted(pieces, key=len, reverse=True):
        assert piece in text
        text = text.replace(piece, " ")
    assert PROSE.sub("", text) == ""


def test_what_is_damaged_says_why_it_is_read_so() -> None:
    for _, _, item in PAPER.items():
        if item.source.printed and not isinstance(item, Exclusion):
            assert item.text != item.source.printed, item.number
            assert item.reason or errata(item), item.number


def growth(a: float, delta: float, spin: float, inertia: float, natural: float) -> float:
    """Largest growth rate of A W' + i D w W + S' - i w S = 0, S' - i l S + E W' = 0: one mode, a_1 = 1.

    Solved for the derivatives: (A - E) W' = -i D w W + i (w - l) S, S' = i l S - E W'.
    """
    top = (-1j * delta * spin / (a - inertia), 1j * (spin - natural) / (a - inertia))
    bottom = (-inertia * top[0], 1j * natural - inertia * top[1])
    trace, det = top[0] + bottom[1], top[0] * bottom[1] - top[1] * bottom[0]
    root = cmath.sqrt(trace**2 - 4 * det)
    return max(((trace + root) / 2).real, ((trace - root) / 2).real)


def test_the_motion_grows_exactly_between_the_boundaries() -> None:
    rng, grown = random.Random(2006), 0
    for _ in range(2000):
        a, spin = rng.uniform(1, 3), rng.uniform(-2, 2)
        inertia, ratio, delta = rng.uniform(0, a), rng.uniform(-1, 2), rng.uniform(-a, a)
        u2, v2 = inertia * (1 - ratio), ratio * (a - inertia)
        inside = 0 < ratio < 1 and abs(delta + u2 + v2) < 2 * math.sqrt(u2 * v2)
        rate = growth(a, delta, spin, inertia, ratio * spin) / abs(spin)
        assert (rate > 1e-6) == inside or abs(abs(delta + u2 + v2) - 2 * math.sqrt(max(u2 * v2, 0))) < 1e-6
        grown += inside
    assert grown > 200


def frequencies(modes: int, **values: float) -> list[complex]:
    """The roots of the characteristic polynomial."""
    import sympy as sp

    symbols = {sp.Symbol(name, real=True): value for name, value in values.items()}
    polynomial = derivation.characteristic_polynomial(modes).subs(symbols)
    return [complex(root) for root in sp.Poly(polynomial, sp.Symbol("eta", real=True)).nroots(n=30)]


def inertias(rng: random.Random, modes: int) -> dict[str, float]:
    """Moments of the modes, together less than A = 2."""
    return {f"E_{n}": rng.uniform(0.05, 0.6) for n in range(1, modes + 1)}


@pytest.mark.parametrize("modes", [2, 3])
def test_off_the_band_every_frequency_is_real_and_separated(modes: int) -> None:
    rng = random.Random(31)
    for _ in range(10):
        spin = rng.uniform(0.5, 2)
        natural = sorted(spin * rng.choice([rng.uniform(-2, -0.1), rng.uniform(1.1, 3)]) for _ in range(modes))
        values = {f"lambda_{n}": value for n, value in enumerate(natural, 1)} | inertias(rng, modes)
        found = frequencies(modes, A=2.0, C=rng.uniform(0, 4), omega_0=spin, **values)
        assert all(abs(root.imag) < 1e-15 for root in found)
        real = sorted(root.real for root in found)
        between = [x for pair in zip(real, natural, strict=False) for x in pair] + real[-1:]
        assert between == sorted(between)


@pytest.mark.parametrize(("least", "stable"), [(2.0, True), (1.0, False)])
def test_with_several_modes_only_a_long_body_is_unstable(least: float, stable: bool) -> None:
    rng, found = random.Random(35), []
    for _ in range(30):
        natural = {f"lambda_{n}": rng.uniform(-0.5, 1.5) for n in (1, 2, 3)}
        found += frequencies(3, A=2.0, C=least + rng.uniform(0.05, 0.9), omega_0=1.0, **natural, **inertias(rng, 3))
    assert all(abs(root.imag) < 1e-15 for root in found) == stable
