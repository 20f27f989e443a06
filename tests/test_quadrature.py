"""Integrals in numbers are right, or none."""

from __future__ import annotations

import numpy as np
import pytest

from symcheck.document.quadrature import integral

RIGHT = {
    "a power": (lambda x: x**3, 0.0, 2.0, 4.0),
    "backwards": (lambda x: x**3, 2.0, 0.0, -4.0),
    "a singular end": (lambda x: 1 / np.sqrt(x), 0.0, 1.0, 2.0),
    "no value at an end": (lambda x: np.log(x) / (1 - x), 0.0, 1.0, -(np.pi**2) / 6),
    "all of the axis": (lambda x: np.exp(-(x**2)), -np.inf, np.inf, np.sqrt(np.pi)),
    "a narrow density": (lambda x: np.exp(-100 * x**2), -np.inf, np.inf, np.sqrt(np.pi) / 10),
    "a half axis": (lambda x: x * np.exp(-3 * x), 0.0, np.inf, 1 / 9),
    "the other half": (lambda x: np.exp(3 * x), -np.inf, 0.0, 1 / 3),
}


@pytest.mark.parametrize("name", RIGHT)
def test_an_integral_has_its_value(name: str) -> None:
    integrand, low, high, value = RIGHT[name]
    assert integral(integrand, low, high, 1) == pytest.approx([value], rel=1e-7)


def test_each_point_has_its_own_bounds() -> None:
    assert integral(lambda x: 2 * x, 0.0, np.array([1.0, 2.0, 3.0]), 3) == pytest.approx([1, 4, 9])


NONE = {
    "a divergent integral": (lambda x: 1 / x, 0.0, 1.0),
    "a pole inside": (lambda x: 1 / (x - 0.3), 0.0, 1.0),
    "an integral that converges slowly": (lambda x: np.sin(x) / x, 0.0, np.inf),
    "no value inside": (lambda x: np.sqrt(x - 1), 0.0, 2.0),
}


@pytest.mark.parametrize("name", NONE)
def test_what_does_not_converge_has_no_value(name: str) -> None:
    assert np.all(np.isnan(integral(*NONE[name], 1)))
