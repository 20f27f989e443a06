"""What a mix of arguments makes of a formula: the same values by fewer operations on arrays."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from kernel_reference import cases, random_points

from symcheck.kernels.grouping import grouped, patterns_of
from symcheck.kernels.planning import Plan
from symcheck.kernels.runtime import DOUBLE
from symcheck.kernels.tracing import Operand, Pattern, Step, Trace, trace

EXACT: dict[str, Callable[..., Any]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "divide": operator.truediv,
    "negative": operator.neg,
}
ARRAY, ROW, COLUMN, NUMBER = 3, 2, 1, None
EVERY = frozenset(range(9))


def on_arrays(traced: Trace, patterns: Sequence[Pattern], positive: frozenset[int] = frozenset()) -> int:
    """How many operations have the shape of the results, once they are put in order."""
    found = grouped(traced, patterns, positive)
    return sum(pattern == ARRAY for pattern in patterns_of(found, patterns)[found.arity :])


def exact(traced: Trace, values: Sequence[Fraction]) -> list[Fraction]:
    """The outputs in fractions."""
    held = [*values]
    for step in traced.steps:
        held.append(EXACT[step.function](*(Fraction(x) if type(x) is float else held[int(x)] for x in step.operands)))
    return [held[place] for place in traced.outputs]


def random_trace(rng: np.random.Generator, arity: int) -> Trace:
    """Operations on arguments, on numbers and on one another; divisors are arguments, which are not 0."""
    steps: list[Step] = []
    for place in range(arity, arity + 12):
        function = str(rng.choice([*EXACT]))
        x, y = (int(n) if rng.random() < 0.7 else max(0, place - 1) for n in rng.integers(0, place, 2))
        other: Operand = float(rng.choice([-1, 0.5, 1, 2, 3])) if rng.random() < 0.2 else y
        if function == "divide":
            other = int(rng.integers(arity))
        steps.append(Step(function, (x,) if function == "negative" else (x, other)))
    return Trace(arity, tuple(steps), tuple(arity + int(n) for n in {11, *rng.integers(0, 12, 2).tolist()}))


def test_the_order_does_not_change_the_values() -> None:
    rng = np.random.default_rng(24)
    for _ in range(300):
        traced = random_trace(rng, 5)
        patterns = [(ARRAY, ROW, COLUMN, NUMBER)[n] for n in rng.integers(0, 4, 5)]
        positive = frozenset(k for k in range(5) if rng.random() < 0.5)
        values = [Fraction(int(n), 7) for n in rng.integers(1, 50, 5)]
        found = grouped(traced, patterns, positive)
        assert exact(found, values) == exact(traced, values)
        assert all(place >= found.arity for place in found.outputs)  # no output is an argument


def test_factors_of_one_shape_come_together() -> None:
    assert on_arrays(trace(lambda x, u, v: x * u * v), [ARRAY, NUMBER, NUMBER]) == 1
    assert on_arrays(trace(lambda x, u, v: -(2.0 * (x * u)) / v), [ARRAY, NUMBER, NUMBER]) == 1
    assert on_arrays(trace(lambda x, r, s: x * r / s), [ARRAY, ROW, ROW]) == 1
    assert on_arrays(trace(lambda x, r, c, u: r * x * c * u), [ARRAY, ROW, COLUMN, NUMBER]) == 2


def test_what_divides_stays_a_divisor() -> None:
    found = grouped(trace(lambda x, u: -(x / u)), [ARRAY, NUMBER], EVERY)
    assert [step.function for step in found.steps] == ["negative", "divide"]


def test_sums_are_put_in_order_only_where_nothing_cancels() -> None:
    total, mix = trace(lambda x, u, v: x + u + v), [ARRAY, NUMBER, NUMBER]
    assert on_arrays(total, mix, EVERY) == 1
    assert on_arrays(total, mix) == 2
    assert on_arrays(total, mix, frozenset({0, 1})) == 2
    assert on_arrays(trace(lambda x, u, v: x * x + u * u + v * v), mix) == 2
    assert on_arrays(trace(lambda x, u, v: x + u - v), mix, EVERY) == 1
    assert on_arrays(trace(lambda x, u, v: x - u - v), mix, EVERY) == 2
    assert on_arrays(trace(lambda x, u, v: x - (u - v)), mix, EVERY) == 1  # u - v is a number already
    assert on_arrays(trace(lambda x, u, v: u - (v - x)), mix, EVERY) == 2
    assert on_arrays(trace(lambda x, u, v: x - u + v), mix, EVERY) == 2


def test_a_difference_that_cancels_keeps_its_digits_beside_numbers() -> None:
    difference = grouped(trace(lambda x, u, v: (x - u) - v), [1, None, None], EVERY)
    found = Plan(difference, [1, None, None], 1, DOUBLE, "difference")
    assert found.whole(np.array([1e16]), 1e16, 1.0)[0] == -1.0


@pytest.mark.parametrize("single", [False, True])
def test_every_function_of_a_plan_has_the_same_values(single: bool) -> None:
    kind = np.dtype(np.float32) if single else DOUBLE
    traced = trace(lambda x, r, c, u: (x * r + c * u, r * u, u + 1.0, x * r * c))
    values: list[Any] = [np.arange(1, 13, dtype=kind).reshape(3, 4), np.arange(1, 5, dtype=kind)]
    values += [np.arange(1, 4, dtype=kind).reshape(3, 1), 2.0]
    x, r, c, u = values
    expected = [x * r + c * u, r * u + 0 * x, u + 1 + 0 * x, x * r * c]
    found = Plan(traced, [ARRAY, ROW, COLUMN, NUMBER], ARRAY, kind, "sums")
    outputs = [np.empty((3, 4), kind) for _ in expected]
    found.into(*values, *outputs)
    for results in (found.whole(*values), outputs):
        for one, other in zip(results, expected, strict=True):
            assert one.dtype == kind
            np.testing.assert_array_equal(one, other)


def test_what_is_computed_by_blocks_has_the_bits_of_the_whole() -> None:
    case = cases()["mirer2009:distances_from_bounds"]
    columns = random_points(case.kernel, 600, np.random.default_rng(3), decades=0.3)
    mixed = [x[:20, None] if k % 2 else x[:30] for k, x in enumerate(columns)]
    whole = case.function.ways.of_anything([np.array(x) for x in np.broadcast_arrays(*mixed)], many=True)
    for part in (slice(0, 1), slice(3, 17)):
        block = [x[part] if x.ndim == 2 else x for x in mixed]
        for one, other in zip(case.function.ways.of_anything(block, many=True), whole, strict=True):
            np.testing.assert_array_equal(one, other[part])
