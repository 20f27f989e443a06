"""Kernels that are asked to look at their arguments: what lies in the domain passes, what does not is named."""

from __future__ import annotations

import doctest

import numpy as np
import pytest
from kernel_reference import cases, random_points

from symcheck import kernels
from symcheck.kernels import checked

CASES = cases()
LOOKING = {paper: kernels.load(paper, check=True) for paper in sorted({case.paper for case in CASES.values()})}


@pytest.mark.parametrize("name", CASES)
def test_points_of_the_domain_pass_and_others_are_named(name: str) -> None:
    case = CASES[name]
    looking = LOOKING[case.paper].KERNELS[case.name]
    assert looking.specification is case.function.specification
    points = random_points(case.kernel, 7, np.random.default_rng(1))
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(looking(*points), case.function(*points))
        by_name = dict(zip((argument.name for argument in case.kernel.arguments), points, strict=True))
        np.testing.assert_array_equal(looking(**by_name), case.function(*points))
    for place, argument in enumerate(case.kernel.arguments):
        outside = [np.nan, np.inf]
        outside += [-1e30] if argument.low else []
        outside += [0.0] if argument.low == "0" and not argument.closed else []
        outside += [1e30] if argument.high else []
        for value in outside:
            bad = [column.copy() for column in points]
            bad[place][3] = value
            with pytest.raises(ValueError, match=rf"{case.name}: \w+\[3\] = .* must (satisfy|be)"):
                looking(*bad)
            with pytest.raises(ValueError, match=rf"{case.name}: \w+ = .* must (satisfy|be)"):
                looking(*(float(column[3]) for column in bad))


def test_what_is_missing_is_said_by_the_kernel() -> None:
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'b'"):
        LOOKING["ignatov2005"].volume_of_four_wheels(0.5)


def test_kernels_that_are_not_asked_look_at_nothing() -> None:
    assert np.isfinite(kernels.load("ignatov2005").volume_of_four_wheels(0.5, -1.0))


def test_examples_hold() -> None:
    assert doctest.testmod(checked).failed == 0
