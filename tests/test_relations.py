"""What the numeric layer uses beyond the papers is proved from its own text, and its kernels are accurate."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import mpmath
import numpy as np
import pytest

import symcheck
from symcheck import decide
from symcheck.numeric.relations import FOLDER, kernels_of_relations

EXPECTED = json.loads((FOLDER / "generated" / "expected" / "relations.json").read_text(encoding="utf-8"))["items"]
TURN = r"w \left(s - \frac{w}{\alpha}\right) = \theta"


def test_every_relation_is_recorded_as_proved() -> None:
    assert {verdict for verdict, _ in EXPECTED.values() if verdict} == {"proved"}
    assert {reading for verdict, reading in EXPECTED.values() if verdict} == {"as printed"}


def test_the_certificates_are_accepted_by_the_checker() -> None:
    run = [sys.executable, "-m", "symcheck.checker", str(FOLDER / "generated")]
    found = subprocess.run(run, capture_output=True, text=True, cwd=Path(symcheck.__file__).parents[1])
    assert found.returncode == 0, found.stdout + found.stderr


@pytest.mark.slow
def test_what_is_recorded_is_what_is_decided_now() -> None:
    run = [sys.executable, "-m", "symcheck", "generate", str(FOLDER), "--check", "--jobs", "0"]
    found = subprocess.run(run, capture_output=True, text=True, cwd=Path(symcheck.__file__).parents[1])
    assert found.returncode == 0, found.stdout + found.stderr


WRONG = {  # relations of the text with one token changed, and what they rest on
    r"s = \frac{\theta}{w} - \frac{w}{\alpha}": {"where": TURN, "given": r"w > 0, \alpha > 0"},
    r"\left(\frac{\theta}{w} + \frac{w}{\alpha}\right)^2 \ge \frac{5 \theta}{\alpha}": {
        "given": r"\theta > 0, w > 0, \alpha > 0"
    },
    r"H = G + T t + \frac{Q}{\omega} \sin^2\left(\frac{\omega t}{2}\right)": {
        "where": r"H = G + T t + \frac{Q}{\omega} (1 - \cos(\omega t))",
        "given": r"\omega > 0",
    },
    r"(C - A + E - A b)^2 + 4 (A - E) (C - A) b = \frac{m^2 (a^2 - c^2)^3 (4 a^2 - c^2)}{25 (a^2 + c^2)^2}": {
        "where": r"E = \frac{4 m a^2 c^2}{5 (a^2 + c^2)}, A = \frac{m (a^2 + c^2)}{5}, C = \frac{2 m a^2}{5}, "
        r"b = \frac{2 a^2}{a^2 + c^2}",
        "given": "a > 0, c > 0",
    },
}


@pytest.mark.parametrize("relation", WRONG)
def test_a_relation_with_one_token_changed_is_refuted(relation: str) -> None:
    assert str(decide(relation, **WRONG[relation]).verdict) == "refuted"


PRECISE = {
    "time_of_a_turn": lambda theta, w, alpha: theta / w + w / alpha,
    "momentum_of_a_disturbance": lambda G, T, t, P, omega, Q: (
        G + T * t + P / omega * mpmath.sin(omega * t) + Q / omega * (1 - mpmath.cos(omega * t))
    ),
    "natural_frequency_of_an_ellipsoid": lambda a, Omega, c: 2 * a**2 * Omega / (a**2 + c**2),
    "mode_inertia_of_an_ellipsoid": lambda m, a, c: 4 * m * a**2 * c**2 / 5 / (a**2 + c**2),
    "mode_inertia_of_a_cylinder": lambda m, tau, c, k, a: (
        4 * m * tau**2 * (2 + tau) / (c**2 * k**4 * (2 - tau) * (2 * k**2 * a**2 + 2 - tau))
    ),
}


@pytest.mark.parametrize("name", PRECISE)
def test_a_kernel_is_as_accurate_as_it_says(name: str) -> None:
    kernel = kernels_of_relations.KERNELS[name]
    declared, rng = kernel.specification, np.random.default_rng(1)
    names = [argument.name for argument in declared.arguments]
    points = rng.uniform(0.05, 1.95, (300, len(names)))
    with mpmath.workdps(50):
        for point in points:
            exact = PRECISE[name](**{letter: mpmath.mpf(float(x)) for letter, x in zip(names, point, strict=True)})
            assert abs(kernel(*map(float, point)) - exact) <= declared.ulp * np.spacing(float(abs(exact)))
