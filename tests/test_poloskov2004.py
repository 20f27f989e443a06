"""Poloskov 2004: the errors that are found, and the derivation and the closed integrals against plain numbers."""

from __future__ import annotations

import math
import random

import pytest
import sympy
from declarations import errata
from test_reading_sensitivity import unnoticed

from symcheck import papers
from symcheck.audit import context_of, obligation_of, units
from symcheck.core.terms import Node, Term, mapped
from symcheck.core.verdicts import Origin
from symcheck.papers.poloskov2004 import derivation
from symcheck.reading import Notation, read, to_latex, to_sympy

PAPER = papers.load()["poloskov2004"]


def test_the_errors_of_the_paper_are_these() -> None:
    items = [item for _, _, item in PAPER.items()]
    assert {item.number: errata(item)[""].kind for item in items if errata(item)} == {
        "2.3.2": "dots lost",
        "2.4.3": "bracket too long",
        "2.4.4": "wrong sign",
        "3.2.8": "missing hypothesis",
        "4.0.10": "wrong number",
        "4.0.27": "missing hypothesis",
    }
    assert {item.number for item in items if item.source.damage} == {"2.4.5", "3.2.2", "4.0.13"}
    assert all(item.reason for item in items if item.source.damage)
    assert {erratum.origin for item in items for erratum in errata(item).values()} <= set(Origin)


def test_drift_and_noise_by_finite_differences() -> None:
    """v and h move x = x(a, psi, Omega) as the right side of (1.1) says: J (v, h) against the torques."""
    rng = random.Random(2004)
    symbols = sorted({s for v in derivation.stratonovich_system().values() for s in v.free_symbols}, key=str)
    at = {s: rng.uniform(0.5, 1.5) for s in symbols}
    value = {str(s): x for s, x in at.items()}
    a, psi, frequency, k, small = (value[name] for name in ("a", "psi", "Omega", "k", "varepsilon"))

    def place(y: list[float]) -> list[float]:
        return [y[0] * math.cos(y[1]), -y[0] * math.sin(y[1]), y[2] / k]

    def pushed(rates: list[float], step: float = 1e-6) -> list[float]:
        ends = [place([y + s * step * r for y, r in zip((a, psi, frequency), rates, strict=True)]) for s in (1, -1)]
        return [(p - q) / (2 * step) for p, q in zip(*ends, strict=True)]

    x = place([a, psi, frequency])
    system = {name: float(term.subs(at)) for name, term in derivation.stratonovich_system().items()}
    drift = [-small * sum(value[f"d_{i}{j}"] * x[j - 1] for j in (1, 2, 3)) for i in (1, 2, 3)]
    assert pushed([system[f"v_{i}"] for i in (1, 2, 3)]) == pytest.approx(drift, abs=1e-8)
    for j in range(1, 7):
        axis, size = (j - 1) % 3, value[f"g_{(j - 1) // 3 + 1}{(j - 1) % 3 + 1}"]
        noise = [math.sqrt(small) * size * (x[axis] if j < 4 else 1) * (i == axis) for i in range(3)]
        assert pushed([system[f"h_{i}{j}"] for i in (1, 2, 3)]) == pytest.approx(noise, abs=1e-8)


def unfolded(term: Term, table: dict[str, Term]) -> Term:
    if isinstance(term, str):
        return unfolded(table[term], table) if term in table else term
    return mapped(term, lambda part: unfolded(part, table)) if isinstance(term, Node) else term


POINT = {
    "alpha": 1, "beta": sympy.Rational(6, 5), "gamma": 2, "g_13": sympy.Rational(3, 4), "g_23": sympy.Rational(4, 3),
    "k": sympy.Rational(2, 5), "d_33": 2, "m": sympy.Rational(3, 2), "q": 2,
}  # fmt: skip
POINT_SYMBOLS = {sympy.Symbol(name, real=True): value for name, value in POINT.items()}


@pytest.mark.parametrize("number", ["B.1", "B.6", "B.7"])
def test_a_closed_integral_agrees_with_quadrature(number: str) -> None:
    context = context_of(obligation_of(f"poloskov2004:{number}"))
    (unit,) = units(context)
    ((_, left, right),) = unit.formulas
    sides = [to_sympy(unfolded(side, context.table)).subs(POINT_SYMBOLS) for side in (left, right)]
    assert float(sides[0].evalf()) == pytest.approx(float(sides[1].evalf()), rel=1e-9)


@pytest.mark.parametrize(("number", "density", "constant"), [("B.2", "p_s1", "C_1"), ("B.5", "p_s3", "C_2")])
def test_a_constant_of_normalisation_makes_the_integral_one(number: str, density: str, constant: str) -> None:
    context = context_of(obligation_of(f"poloskov2004:{number}"))
    (unit,) = units(context)
    ((_, (_, integral, one), (_, name, value)),) = unit.formulas
    assert (one, name) == (1, constant)
    exact = to_sympy(unfolded(value, context.table))
    total = to_sympy(unfolded(integral, context.table)).subs(sympy.Symbol(constant, real=True), exact)
    assert float(total.subs(POINT_SYMBOLS).evalf()) == pytest.approx(1, rel=1e-9)
    assert density in context.table


def test_the_printed_constants_follow_from_the_printed_values_and_k() -> None:
    printed = {"alpha": 1, "beta": sympy.sqrt(3) / 2, "gamma": 1, "g_13": 1, "g_23": 1, "d_33": sympy.Rational(3, 2)}
    values = {}
    for number, constant in (("B.2", "C_1"), ("B.5", "C_2")):
        context = context_of(obligation_of(f"poloskov2004:{number}"))
        exact = to_sympy(unfolded(units(context)[0].formulas[0][2][2], context.table))
        values[constant] = sympy.simplify(exact.subs({sympy.Symbol(n, real=True): v for n, v in printed.items()}))
    assert values["C_1"] == sympy.Rational(9, 4)
    assert sympy.simplify(values["C_2"].subs(sympy.Symbol("k", real=True), sympy.Rational(3, 5))) == 54 / (
        125 * sympy.pi
    )
    assert values["C_2"].has(sympy.Symbol("k", real=True))


def read_items() -> list[tuple[str, Notation]]:
    """Everything of the ledger that is read: what is printed, or what is read in its place, and what is stated."""
    found = []
    for _, _, item in PAPER.items():
        latex = item.text if isinstance(item.text, str) else r" \\ ".join(item.text)
        found += [(latex, item.notation or PAPER.notation)] if latex else []
    return found


def test_whatever_is_read_survives_printing() -> None:
    assert len(read_items()) > 80
    for latex, notation in read_items():
        tree = read(latex, notation)
        assert read(to_latex(tree), notation) == tree


@pytest.mark.slow
def test_no_change_of_a_printed_formula_goes_unnoticed() -> None:
    total = 0
    for _, _, item in PAPER.items():
        if item.text and item.text == item.source.printed:
            missed, count = unnoticed(item.source.printed, item.notation or PAPER.notation)
            assert missed == [], item.number
            total += count
    assert total > 2000
