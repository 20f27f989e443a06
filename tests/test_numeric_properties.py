"""What holds of every function of the numeric layer: whole and in pieces, whatever the arrays are, in any unit."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import combinations
from typing import Any

import mpmath
import numpy as np
import pytest
from chunked_samples import LEAD, arguments, functions, is_long

import symcheck.numeric
from symcheck.numeric import attitude, inertia, liquid, random_rotation, wheels
from symcheck.numeric.domain import Array
from symcheck.numeric.inertia import decay

Call = Callable[..., Any]
MANY = 5000
FURTHER: dict[str, tuple[Call, Any]] = {  # functions that are not declared elementwise, but broadcast, with arguments
    "inertia.free_decay": (
        inertia.free_decay,
        lambda rng: [
            rng.uniform(2, 3, (*LEAD, 3)),
            np.diag([0.1, 0.2, 0.3]),
            rng.uniform(0.1, 1, (*LEAD, 3)),
            [0, 1, 2],
        ],
    ),
    "liquid.with_body": (
        liquid.with_body,
        lambda rng: [
            *rng.uniform(1, 2, (2, *LEAD)),
            liquid.Liquid(*rng.uniform(1, 2, (2, *LEAD)), *rng.uniform(1, 2, (2, *LEAD, 3))),
        ],
    ),
    "wheels.null_torque": (
        wheels.null_torque,
        lambda rng: [wheels.four_wheels(1.0, 0.7), *rng.uniform(-1, 1, (2, *LEAD, 4)), 0.1, rng.uniform(0.1, 1, LEAD)],
    ),
    "wheels.design": (
        wheels.design,
        lambda rng: [rng.uniform(2, 3, (*LEAD, 3)), rng.uniform(0.1, 1, (*LEAD, 3)), rng.uniform(1, 2, LEAD)],
    ),
    "wheels.failures": (wheels.failures, lambda rng: [wheels.four_wheels(*rng.uniform(0.5, 1, (2, *LEAD)))]),
}
FUNCTIONS: dict[str, tuple[Call, list[Any]]] = {
    **{name: (function, arguments(function)) for name, function in functions()},
    **{name: (function, sample(np.random.default_rng(3))) for name, (function, sample) in FURTHER.items()},
}
NOT_OF_POINTS = ("wheels", "times")  # results that no leading axis has: of failures


def leaves(value: Any) -> list[Array]:
    """All arrays of a result, of NamedTuples in one too."""
    if not hasattr(value, "_fields"):
        return list(value) if isinstance(value, tuple) else [np.asarray(value)]
    return [
        leaf
        for field, each in zip(value._fields, value, strict=True)
        if field not in NOT_OF_POINTS
        for leaf in leaves(each)
    ]


def changed(values: list[Any], change: Callable[[Array], Any]) -> list[Any]:
    """The arguments, those with the leading axes changed, fields of NamedTuples too."""

    def leaf(value: Any) -> Any:
        return change(value) if is_long(value) else value

    return [type(v)(*map(leaf, v)) if hasattr(v, "_fields") else leaf(v) for v in values]


def outcome(function: Call, values: list[Any]) -> list[Array] | str:
    """What a function gives, or what it says instead."""
    try:
        return leaves(function(*values))
    except ValueError as error:
        return str(error)


def assert_equal(found: Any, expected: Any, tolerance: float = 1e-12) -> None:
    assert type(found) is type(expected)
    if isinstance(expected, str):
        return
    for one, other in zip(found, expected, strict=True):
        assert one.shape == other.shape
        assert one.dtype == other.dtype
        size = np.abs(other[np.isfinite(other)]).max(initial=0)
        np.testing.assert_allclose(one, other, rtol=tolerance, atol=tolerance * size)


# --- properties, each of a function and arguments


def pieces_are_the_whole(function: Call, values: list[Any]) -> None:
    slow = function in (inertia.free_decay, wheels.allocate_least_squares)
    count = 100 if slow else MANY
    long = changed(values, lambda array: np.resize(array.reshape(-1, *array.shape[2:]), (count, *array.shape[2:])))
    whole = leaves(function(*long))
    tolerance = 1e-9 if slow else 1e-12  # that of an integration, which depends on who takes part
    for step, upto in ((1, 10), (7, 70), (4096, count)):
        parts = [leaves(function(*_of(long, count, slice(k, min(k + step, upto))))) for k in range(0, upto, step)]
        joined = [np.concatenate(column) for column in zip(*parts, strict=True)]
        assert_equal(joined, [array[:upto] for array in whole], tolerance)


def _of(values: list[Any], count: int, part: slice) -> list[Any]:
    def leaf(value: Any) -> Any:
        return value[part] if np.shape(value)[:1] == (count,) else value

    return [type(v)(*map(leaf, v)) if hasattr(v, "_fields") else leaf(v) for v in values]


def no_points_give_no_results(function: Call, values: list[Any]) -> None:
    expected = [array[:0] for array in leaves(function(*values))]
    assert_equal(leaves(function(*changed(values, lambda array: array[:0]))), expected)


def forms_of_arrays_do_not_matter(function: Call, values: list[Any]) -> None:
    expected = leaves(function(*values))
    forms: list[Callable[[Array], Any]] = [
        lambda array: array.tolist(),
        lambda array: array.astype(">f8"),
        np.asfortranarray,
        lambda array: np.repeat(array, 2, axis=1)[:, ::2],
        lambda array: array[::-1].copy()[::-1],
        _read_only,
    ]
    for form in forms:
        assert_equal(leaves(function(*changed(values, form))), expected)


def _read_only(array: Array) -> Array:
    array = array.copy()
    array.flags.writeable = False
    return array


def other_numbers_are_taken_for_the_doubles_that_they_are(function: Call, values: list[Any]) -> None:
    for form in (lambda array: array.astype(np.float32), _whole_numbers):
        given, doubles = changed(values, form), changed(values, lambda array, f=form: f(array).astype(np.float64))
        assert_equal(outcome(function, given), outcome(function, doubles))


def _whole_numbers(array: Array) -> Any:
    return np.rint(3 * array).astype(np.int64) if np.isfinite(array).all() else array


def what_is_no_finite_number_is_refused(function: Call, values: list[Any]) -> None:
    forms: list[Callable[[Array], Any]] = [
        lambda array: np.where(np.arange(array.size).reshape(array.shape) == 5, np.nan, array),
        lambda array: np.ma.array(array, mask=array > array.mean()),
        lambda array: array.astype(complex),
        lambda array: array.astype(str),
        lambda array: array > 0,
    ]
    for place in range(len(values)):
        for form in forms:
            bad = values[:place] + changed(values[place : place + 1], form) + values[place + 1 :]
            assert isinstance(outcome(function, bad), str) or all(map(_same, bad, values))


def _same(one: Any, other: Any) -> bool:
    return one is other or (hasattr(one, "_fields") and all(map(_same, one, other)))


def results_have_memory_of_their_own(function: Call, values: list[Any]) -> None:
    given = [leaf for value in values for leaf in leaves(value)]
    for arguments_ in (values, _crossed(values)):
        found = leaves(function(*arguments_))
        for result in found:
            result[...] = result  # is not read-only
            assert not any(np.may_share_memory(result, each) for each in given)
        assert not any(np.may_share_memory(one, other) for one, other in combinations(found, 2))


def _crossed(values: list[Any]) -> list[Any]:
    """Some arguments along the one leading axis only, some along the other."""
    rest: Iterator[int] = iter(range(100))
    return changed(values, lambda array: array[:, :1] if next(rest) % 2 else array[:1])


def arguments_broadcast(function: Call, values: list[Any]) -> None:
    crossed = _crossed(values)
    spread = [type(v)(*map(_spread, v)) if hasattr(v, "_fields") else _spread(v) for v in crossed]
    found, expected = leaves(function(*crossed)), leaves(function(*spread))
    assert_equal([np.broadcast_to(one, other.shape) for one, other in zip(found, expected, strict=True)], expected)


def _spread(value: Any) -> Any:
    shape = np.shape(value)
    return np.broadcast_to(value, (*LEAD, *shape[2:])).copy() if shape[:2] in ((LEAD[0], 1), (1, LEAD[1])) else value


PROPERTIES: list[Callable[[Call, list[Any]], None]] = [
    pieces_are_the_whole,
    no_points_give_no_results,
    forms_of_arrays_do_not_matter,
    other_numbers_are_taken_for_the_doubles_that_they_are,
    what_is_no_finite_number_is_refused,
    results_have_memory_of_their_own,
    arguments_broadcast,
]


@pytest.mark.parametrize("holds", PROPERTIES, ids=lambda holds: holds.__name__)
@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_function(name: str, holds: Callable[[Call, list[Any]], None]) -> None:
    holds(*FUNCTIONS[name])


# --- functions of one set of parameters

TURNED = attitude.turn(np.eye(3), [2.0, 3.0, 4.0], [1, 2, 3], 1.0, points=3)
SKEW = np.array([[0.6, 0.8, 0], [0, 0.6, 0.8], [0.8, 0, 0.6], [0, 0, 1.0]])
NOT_MOVED: dict[str, tuple[Call, list[Any]]] = {  # their results, as arrays or text
    "attitude.turn": (lambda e, J, u: attitude.turn(e, J, u, 1.0, points=3), [SKEW, [2.0, 3, 4], [1.0, 2, 3]]),
    "attitude.fly": (lambda e, J, u: attitude.fly(TURNED, e, J, u), [np.eye(3), [2.0, 3, 4], [1.0, 2, 3]]),
    "attitude.agility_after_failures": (
        lambda e, J, u: attitude.agility_after_failures(e, J, u).agility,
        [SKEW, [2.0, 3, 4], [1.0, 2, 3]],
    ),
    "attitude.rotation": (lambda e: attitude.rotation(e).as_matrix(), [SKEW[[0, 0, 0]] * 0 + np.eye(3)]),
    "attitude.to_42": (lambda e, h: attitude.to_42(e, h, 1.0, 1.0), [SKEW, [1.0, 2, 3, 4]]),
    "attitude.to_basilisk": (lambda e, h: attitude.to_basilisk(e, h, 1.0, 1.0), [SKEW, [1.0, 2, 3, 4]]),
    "liquid.liquid_in_a_cylinder": (liquid.liquid_in_a_cylinder, [5.0, 1.0, 2.0, 3.0]),
    "liquid.stability_map": (
        lambda E, D, b: liquid.stability_map(4.0, E, D, b).growth_rate,
        [[1.0], [-2.0, -1, 1], [1.0, 2]],
    ),
    "liquid.unstable_intervals": (lambda E, lam: liquid.unstable_intervals(4.0, E, lam, 3.0), [[1.0], [2.0]]),
    "wheels.clear_momenta": (lambda e, h: wheels.clear_momenta(e, h, 4.0).momenta, [SKEW, [1.0, -2, 3, 1]]),
    "wheels.envelope": (lambda e, h: wheels.envelope(e, h).vertices, [SKEW, [1.0, 2, 3, 4]]),
    "wheels.null_motions": (wheels.null_motions, [SKEW, [1.0, 2, 3, 4]]),
    "wheels.pareto_front": (wheels.pareto_front, [[[1.0, 5], [2, 2], [3, 3]]]),
    "wheels.torque_envelope": (lambda e, u: wheels.torque_envelope(e, u).vertices, [SKEW, [1.0, 2, 3, 4]]),
    "wheels.trade": (
        lambda J: wheels.trade(J, [wheels.WheelType("one", 1.0, 1.0, 1.0, 1.0)], [4]).rates,
        [[2.0, 3, 4]],
    ),
    "wheels.wheels_of": (lambda e, h: wheels.wheels_of(e, h).limits, [SKEW, [1.0, 2, 3, 4]]),
}


def told(function: Call, values: list[Any]) -> Any:
    """What a function gives, or says."""
    try:
        found = function(*values)
    except ValueError as error:
        return str(error)
    return found if isinstance(found, str) else leaves(found)


def equal(one: Any, other: Any) -> bool:
    if isinstance(one, str) or isinstance(other, str):
        return bool(one == other)
    return all(np.allclose(x, y, rtol=1e-9, atol=1e-9) for x, y in zip(one, other, strict=True))


@pytest.mark.parametrize("name", NOT_MOVED)
def test_forms_of_one_set_of_parameters_do_not_matter(name: str) -> None:
    function, given = NOT_MOVED[name]
    arrays = [np.array(value, float) for value in given]
    expected = told(function, arrays)
    assert not isinstance(expected, str) or "must" not in expected
    same: list[Callable[[Array], Any]] = [
        lambda array: array.tolist(),
        lambda array: array.astype(">f8"),
        lambda array: np.asfortranarray(array) if array.ndim else array,
        lambda array: array[..., ::-1].copy()[..., ::-1] if array.ndim else array,
        _read_only,
    ]
    for form in same:
        assert equal(told(function, [form(array) for array in arrays]), expected)
    single = [array.astype(np.float32) for array in arrays]
    assert equal(told(function, single), told(function, [array.astype(float) for array in single]))
    whole = [array.astype(int) if (array == np.rint(array)).all() else array for array in arrays]
    assert equal(told(function, whole), expected)


@pytest.mark.parametrize("name", NOT_MOVED)
def test_what_is_no_finite_number_is_refused_in_one_set_of_parameters(name: str) -> None:
    function, given = NOT_MOVED[name]
    arrays = [np.array(value, float) for value in given]
    bad: list[Callable[[Array], Any]] = [
        lambda array: np.where(np.arange(array.size).reshape(array.shape) == 0, np.nan, array),
        lambda array: np.where(np.arange(array.size).reshape(array.shape) == 0, np.inf, array),
        lambda array: np.ma.array(array, mask=True),
        lambda array: array.astype(complex),
        lambda array: array.astype(str),
        lambda array: array > 0,
    ]
    for place in range(len(arrays)):
        for form in bad:
            with pytest.raises(ValueError, match=r"must|is a masked array|is not an array of real numbers"):
                function(*arrays[:place], form(arrays[place]), *arrays[place + 1 :])


ELSEWHERE = {  # public functions whose properties other files test, and why
    "attitude": set(),
    "inertia": set(),
    "liquid": set(),
    "random_rotation": {"simulate", "stationary_sample"},  # random: test_numeric_random_rotation
    "wheels": {
        *("best_parameters", "listed_vertices"),  # a search, and names: test_numeric_wheels
        *("interactive_axes", "interactive_envelope"),  # pictures: test_numeric_control
    },
}


@pytest.mark.parametrize("part", ELSEWHERE)
def test_every_public_function_has_its_properties_tested(part: str) -> None:
    module = getattr(symcheck.numeric, part)
    known = {name.partition(".")[2] for name in [*FUNCTIONS, *NOT_MOVED] if name.startswith(f"{part}.")}
    public = {name for name in module.__all__ if name[0].islower() and not name.startswith("plot_")}
    assert public - known == ELSEWHERE[part]


# --- units


AXES = np.linalg.qr(np.random.default_rng(4).normal(size=(3, 3)))[0]
WHEELS = np.vstack([AXES, wheels.six_wheels(0.9)[:2]])
LIMITS, BIAS = np.array([1.0, 2.0, 0.5, 1.5, 0.7]), np.array([0.1, -0.1, 0.05, 0.0, 0.02])
MOMENTUM, SEMI_AXES, MOMENTS = np.array([0.7, -0.4, 0.3]), np.array([0.3, 0.2, 0.1]), np.array([2.0, 3.0, 4.0])
DAMPING, RATE, TIMES = AXES.T @ np.diag([0.2, 0.3, 0.4]) @ AXES, np.array([0.1, 0.2, 0.3]), np.linspace(0, 3, 4)


def _bounds(s: float) -> wheels.HalfSpaces:
    return wheels.half_spaces(WHEELS, LIMITS * s, BIAS * s)


def _flat(s: float) -> wheels.HalfSpaces:
    return wheels.half_spaces(WHEELS[:2], LIMITS[:2] * s, BIAS[:2] * s, complete=True)


DRAG, EVEN, ODD = np.array([0.01, -0.02, 0.03]), np.array([0.1, 0.2, -0.1]), np.array([0.2, -0.1, 0.1])

IN_UNITS: dict[str, Callable[[float], Any]] = {  # what does not depend on the unit, of which a quantity has s
    "turn_time": lambda s: attitude.turn_time(1.3, [0.5 / s, 2 / s], 0.25 / s / s) / s,
    "agility": lambda s: attitude.agility(_bounds(s), _bounds(s), MOMENTS * s, MOMENTUM * s, 1.3),
    "agility_after_failures": lambda s: (
        attitude.agility_after_failures(
            WHEELS, MOMENTS * s, MOMENTUM, 1.3, momentum=LIMITS * s, torque=LIMITS * s
        ).agility
    ),
    "turn": lambda s: attitude.turn(WHEELS, MOMENTS * s, MOMENTUM * s, 1.3, momentum=LIMITS * s, torque=LIMITS * s)[:3],
    "momentum_of_a_period": lambda s: np.divide(attitude.momentum_of_a_period(DRAG * s, EVEN * s, ODD * s, 2.0), s),
    "momentum_in_time": lambda s: (
        attitude.momentum_in_time(TIMES * s, DRAG, EVEN, ODD, 2.0 / s, MOMENTUM * s, [[0.0], [0.1 / s]]) / s
    ),
    "time_to_saturation": lambda s: attitude.time_to_saturation(_bounds(s), DRAG * s, EVEN * s, ODD * s, 2.0),
    "time_to_saturation of times": lambda s: (
        attitude.time_to_saturation(_bounds(1), DRAG / s, EVEN / s, ODD / s, 2.0 / s, dumping=0.01 / s) / s
    ),
    "torque_range": lambda s: np.divide(
        wheels.torque_range(LIMITS * s, s * 0.9, LIMITS * 1.5 * s, 0.2 * s, np.ones(5) * s), s
    ),
    "torque_half_spaces": lambda s: wheels.torque_half_spaces(WHEELS, LIMITS * s, LIMITS * s, LIMITS * s).distances / s,
    "torque_envelope": lambda s: wheels.torque_envelope(WHEELS, LIMITS * s, LIMITS * s, LIMITS * s).vertices / s,
    "null_motions": lambda s: np.abs(wheels.null_motions(WHEELS, LIMITS * s)[0]),
    "null_torque": lambda s: wheels.null_torque(WHEELS, BIAS * s, LIMITS * s, 0.1 * s) / s,
    "trade": lambda s: wheels.trade(MOMENTS * s, [wheels.WheelType("one", s, s, 1.0, 1.0)], [4]).rates,
    "liquid_in_an_ellipsoid": lambda s: np.array(liquid.liquid_in_an_ellipsoid(s, 0.7, 1.2, s)[2:]) / s,
    "liquid_in_an_ellipsoid of lengths": lambda s: (
        liquid.liquid_in_an_ellipsoid(1.0, 0.7 * s, 1.2 * s, 1.0).E_n / s / s
    ),
    "liquid_in_a_cylinder": lambda s: liquid.liquid_in_a_cylinder(1.0, 0.7 * s, 1.2 * s, s).E_n / s / s,
    "half_spaces": lambda s: (_bounds(s).distances / s, _bounds(s).centre / s, _flat(s).distances / s),
    "face_distances": lambda s: wheels.face_distances(WHEELS, LIMITS * s) / s,
    "failures": lambda s: wheels.failures(WHEELS, LIMITS * s, BIAS * s, count=2).half_spaces.distances / s,
    "envelope": lambda s: wheels.envelope(WHEELS, LIMITS * s, BIAS * s).vertices / s,
    "envelope in a plane": lambda s: wheels.envelope(WHEELS[:2], LIMITS[:2] * s, BIAS[:2] * s).vertices / s,
    "total_momentum": lambda s: wheels.total_momentum(WHEELS, LIMITS * s) / s,
    "volume": lambda s: np.cbrt(wheels.volume(WHEELS, LIMITS * s)) / s,
    "margin": lambda s: wheels.margin(_bounds(s), MOMENTUM * s) / s,
    "ellipsoid_margin": lambda s: wheels.ellipsoid_margin(_bounds(s), SEMI_AXES * s, AXES) / s,
    "ellipsoid_scale": lambda s: wheels.ellipsoid_scale(_bounds(s), SEMI_AXES * s, AXES),
    "ellipsoid_scale of semi-axes": lambda s: wheels.ellipsoid_scale(_bounds(1), SEMI_AXES * s) * s,
    "largest_momentum": lambda s: wheels.largest_momentum(_bounds(s), MOMENTUM) / s,
    "largest_momentum in a plane": lambda s: wheels.largest_momentum(_flat(s), WHEELS[0] + WHEELS[1]) / s,
    "largest_momentum of a direction": lambda s: wheels.largest_momentum(_bounds(1), MOMENTUM * s * s),
    "guaranteed_rate": lambda s: wheels.guaranteed_rate(_bounds(s), MOMENTS) / s,
    "rates": lambda s: wheels.rates(_bounds(1), MOMENTS * s).distances * s,
    "allocate": lambda s: wheels.allocate(WHEELS, MOMENTUM * s, LIMITS * s, BIAS * s).momenta / s,
    "allocate_least_squares": lambda s: (
        wheels.allocate_least_squares(WHEELS, MOMENTUM * s, LIMITS * s, BIAS * s).momenta / s
    ),
    "best_angles_of_four_wheels": lambda s: wheels.best_angles_of_four_wheels(MOMENTS * s),
    "best_angle_of_six_wheels": lambda s: wheels.best_angle_of_six_wheels(MOMENTS * s),
    "equal_rates_of_four_wheels": lambda s: wheels.equal_rates_of_four_wheels(MOMENTS * s),
    "equal_rates_of_six_wheels": lambda s: wheels.equal_rates_of_six_wheels(MOMENTS * s),
    "principal_inertia": lambda s: inertia.principal_inertia(DAMPING * s * s).moments / s / s,
    "characteristic_roots": lambda s: inertia.characteristic_roots(MOMENTS, DAMPING * s * s) / s / s,
    "equal_moment_axes": lambda s: inertia.equal_moment_axes(MOMENTS * s, 0.3),
    "equal_moment_angles": lambda s: inertia.equal_moment_angles(MOMENTS * s),
    "bound_at_given_moment": lambda s: np.cbrt(inertia.bound_at_given_moment(MOMENTS * s, 3 * s)) / s,
    "product_of_axial_moments": lambda s: np.cbrt(inertia.product_of_axial_moments(MOMENTS * s, AXES)) / s,
    "stability_degree_in_pitch": lambda s: inertia.stability_degree_in_pitch(1.0, MOMENTS * s, 0.3),
    "free_decay of masses": lambda s: inertia.free_decay(MOMENTS * s, DAMPING * s, RATE, TIMES),
    "free_decay of times": lambda s: inertia.free_decay(MOMENTS, DAMPING / s / s, RATE / s / s, TIMES * s * s) * s * s,
    "stability of masses": lambda s: liquid.stability(s, 0.5 * s, [0.2 * s, 0.01 * s], [0.5, -0.3], 1.0).frequencies,
    "stability of rates": lambda s: (
        liquid.stability(s, 0.5 * s, [0.2 * s, 0.01 * s], [0.5 * s, -0.3 * s], s).frequencies / s
    ),
    "stability of one mode": lambda s: liquid.stability(s, 0.5 * s, [0.2 * s], [0.5 * s], s).frequencies / s,
    "is_stable": lambda s: liquid.is_stable(s, [0.5 * s, 1.5 * s], [0.2 * s], [0.5 * s], s),
    "unstable_intervals": lambda s: liquid.unstable_intervals(s, [0.01 * s, 0.002 * s], [0.2 * s, 0.8 * s], s) / s,
    "boundary_of_stability": lambda s: liquid.boundary_of_stability(s, 0.2 * s, 0.3).width / s,
    "mean_square_of_amplitude": lambda s: np.sqrt(random_rotation.mean_square_of_amplitude(0.1, s, 0.3)) / s,
    "mean_square_of_frequency": lambda s: np.sqrt(random_rotation.mean_square_of_frequency(0.6, 0.5, s, 1.5)) / s,
    "density_of_amplitude": lambda s: random_rotation.density_of_amplitude(0.7 * s * s, 0.1 / s, s, 0.3 / s) * s * s,
    "density_of_frequency": lambda s: random_rotation.density_of_frequency(0.3 * s * s, 0.6 * s, 0.5, s, 1.5) * s * s,
    "distribution_of_amplitude": lambda s: random_rotation.distribution_of_amplitude(0.7 * s * s, 0.1 / s, s, 0.3 / s),
    "distribution_of_frequency": lambda s: random_rotation.distribution_of_frequency(-0.3 * s, 0.6, 0.5, s, 1.5),
    "quantile_of_amplitude": lambda s: random_rotation.quantile_of_amplitude(0.3, 0.1, s, 0.3) / s,
    "quantile_of_frequency": lambda s: random_rotation.quantile_of_frequency(0.3, 0.6, 0.5, s, 1.5) / s,
    "moment_of_amplitude": lambda s: np.cbrt(random_rotation.moment_of_amplitude(3, 0.1, s, 0.3)) / s,
    "moment_of_frequency": lambda s: np.cbrt(random_rotation.moment_of_frequency(3, 0.6, 0.5, s, 1.5)) / s,
    "mode_of_amplitude": lambda s: random_rotation.mode_of_amplitude(0.1, s, 0.3) / s,
    "amplitude_phase_frequency": lambda s: np.divide(
        random_rotation.amplitude_phase_frequency(RATE * s, 0.5), [s, 1.0, s]
    ),
    "angular_velocity": lambda s: random_rotation.angular_velocity(0.7 * s, 0.3, 0.2 * s, 0.5) / s,
    "angular_acceleration of masses": lambda s: inertia.angular_acceleration(MOMENTS * s, DAMPING * s, RATE),
    "axial_moments": lambda s: inertia.axial_moments(MOMENTS * s, AXES) / s,
    "second_order_moments": lambda s: np.sqrt(inertia.second_order_moments(MOMENTS * s, AXES)) / s,
    "sum_of_products": lambda s: np.cbrt(inertia.sum_of_products(MOMENTS * s, AXES)) / s,
    "inertia_tensor": lambda s: inertia.inertia_tensor(MOMENTS * s, AXES) / s,
    "triangle_slack": lambda s: inertia.triangle_slack(MOMENTS * s) / s,
    "second_moments_of_mass": lambda s: inertia.second_moments_of_mass(MOMENTS * s) / s,
    "characteristic_coefficients": lambda s: (
        np.cbrt(inertia.characteristic_coefficients(MOMENTS * s, RATE * s, AXES)) / s
    ),
    "damping_matrix": lambda s: inertia.damping_matrix(RATE * s, AXES) / s,
    "orthogonal_devices": lambda s: inertia.orthogonal_devices(DAMPING * s).gains / s,
    "optimal_devices": lambda s: inertia.optimal_devices(MOMENTS * s, 0.3).gains / s,
    "gains_in_proportion": lambda s: inertia.gains_in_proportion(0.3, MOMENTS * s, AXES) / s,
    "stability_degree": lambda s: inertia.stability_degree(MOMENTS, DAMPING * s) / s,
    "harmonic_mean_of_rates": lambda s: np.divide(inertia.harmonic_mean_of_rates(RATE * s), s),
    "decay_rate of energies": lambda s: inertia.decay_rate([0, 1, 2], MOMENTS * s),
    "decay_rate of times": lambda s: inertia.decay_rate(TIMES[:3] * s, MOMENTS) * s,
    "kinetic_energy of masses": lambda s: inertia.kinetic_energy(MOMENTS * s, [RATE]) / s,
    "frequencies": lambda s: liquid.frequencies(s, 0.5 * s, [0.2 * s, 0.01 * s], [0.5, -0.3], 1.0),
    "growth_rate": lambda s: liquid.growth_rate(s, 0.5 * s, [0.2 * s, 0.01 * s], [0.5 * s, -0.3 * s], s) / s,
    "mode_inertia": lambda s: liquid.mode_inertia(3.0 * s, 0.7 * s, 1.1 * s),
    "stability_map": lambda s: (
        liquid.stability_map(4 * s, [s], np.array([-2.0, -1, 1]) * s, [0.5, 1], s).growth_rate / s
    ),
    "with_body": lambda s: liquid.with_body(2 * s, s, liquid.liquid_in_an_ellipsoid(s, 0.7, 1.2, 1.0)).A / s,
    "clear_momenta": lambda s: wheels.clear_momenta(SKEW, np.array([1.0, -2, 3, 1]) * s, 4.0 * s).momenta / s,
    "design": lambda s: wheels.design(MOMENTS * s, RATE, s).six.guaranteed_rate,
    "pareto_front": lambda s: wheels.pareto_front(np.array([[1.0, 5], [2, 2], [3, 3]]) * s),
    "wheels_of": lambda s: wheels.wheels_of(SKEW, s).limits / s,
}
WITHOUT_UNITS = {  # of angles and directions alone, of logarithms of quantities, zeros, text, pictures and searches
    *("axes_of_mrp", "axes_of_quaternion", "axes_of_rotation", "mrp", "quaternion", "rotation"),
    *("attitude_angles", "direction_cosines", "cone", "four_wheels", "six_wheels", "listed_vertices"),
    *("logarithm_of_constant_of_amplitude", "logarithm_of_constant_of_frequency", "mode_of_frequency"),
    *("fly", "to_42", "to_basilisk", "interactive_axes", "interactive_envelope", "best_parameters"),
    *("simulate", "stationary_sample"),
}


def test_every_public_function_is_asked_in_other_units_or_has_none() -> None:
    asked = {name.partition(" ")[0] for name in IN_UNITS}
    public = {
        name
        for part in ELSEWHERE
        for name in getattr(symcheck.numeric, part).__all__
        if name[0].islower() and not name.startswith("plot_")
    }
    assert public - asked == WITHOUT_UNITS


@pytest.mark.parametrize("name", IN_UNITS)
def test_values_do_not_depend_on_the_unit_over_200_decades(name: str) -> None:
    expected = leaves(IN_UNITS[name](1.0))
    for exponent in (-325, -250, -34, 34, 250, 325):  # 1e-98 to 1e98
        assert_equal(leaves(IN_UNITS[name](2.0**exponent)), expected, 1e-10)


@pytest.mark.parametrize("unit", [1e-300, 1e-98, 1e-20, 1.0, 1e20, 1e98])
def test_the_origin_outside_is_noticed_in_any_unit(unit: float) -> None:
    outside = wheels.half_spaces(np.eye(3), unit, [5 * unit, 0, 0])
    for call in (wheels.largest_momentum, wheels.ellipsoid_scale):
        with pytest.raises(ValueError, match="margin of the origin"):
            call(outside, [1, 0, 0])


HUGE = {
    "half-spaces": lambda: wheels.half_spaces(np.eye(3), 1e308),
    "total momentum": lambda: wheels.total_momentum(np.eye(3), [1e308, 0, 0]),
    "demand": lambda: wheels.allocate(np.eye(3), [1e308, 0, 0]),
    "volume that is no double": lambda: wheels.volume(np.eye(3), 1e-200),
    "factor of growth": lambda: wheels.ellipsoid_scale(wheels.half_spaces(np.eye(3), 1e200), [1e-200, 0, 0]),
    "rates": lambda: wheels.rates(wheels.half_spaces(np.eye(3), 1e300), [1e-99, 1e-99, 1e-99]),
    "axes": lambda: inertia.axial_moments([2, 3, 4], 1e200 * np.eye(3)),
    "coefficients": lambda: inertia.characteristic_coefficients([2, 3, 4], [1e200, 1e200, 1e200], np.eye(3)),
    "gains": lambda: inertia.gains_in_proportion(1e308, [2, 3, 4], np.eye(3)),
    "devices": lambda: inertia.optimal_devices([2, 3, 4], 1e308),
    "mean": lambda: inertia.harmonic_mean_of_rates([1e-320, 1e-320, 1e300]),
    "acceleration": lambda: inertia.angular_acceleration([2, 3, 4], np.eye(3), [1e200, 1e200, 1e200]),
    "energy": lambda: inertia.kinetic_energy([2, 3, 4], [[1e200, 0, 0]]),
    "decay": lambda: inertia.decay_rate([0, 1e-320], [2, 1]),
    "velocity": lambda: random_rotation.angular_velocity(1, 0, 1e200, 1e-200),
    "mode": lambda: random_rotation.mode_of_amplitude(0.1, 1, 1e200),
    "far away": lambda: random_rotation.density_of_frequency(1e200, 0.6, 1.0, 1.0, 1.5),
}


@pytest.mark.parametrize("name", HUGE)
def test_what_leaves_the_doubles_is_said(name: str) -> None:
    with pytest.raises(ValueError, match=r"must (be|lie|have)"):
        HUGE[name]()


# --- laws and loads whose arguments differ by many decades


def amplitude_exceeded(a: Any, alpha: Any, beta: Any, gamma: Any) -> tuple[Any, Any]:
    """The probability of a greater amplitude, and the exponent of its power law."""
    power = (4 * gamma**2 - alpha**2) / (3 * alpha**2)
    return (1 + 3 * (alpha * a / beta) ** 2 / 4) ** -power, power


def test_laws_of_amplitude_and_frequency_hold_whatever_the_sizes_of_their_coefficients() -> None:
    rng = np.random.default_rng(8)
    with mpmath.workdps(60):
        for _ in range(200):
            alpha, beta = 10 ** rng.uniform(-90, 90, 2)
            gamma = alpha * 10 ** rng.uniform(-0.2, 2)
            a = beta / gamma * 10 ** rng.uniform(-2, 1)
            values = [mpmath.mpf(float(x)) for x in (a, alpha, beta, gamma)]
            exceeded, power = amplitude_exceeded(*values)
            slope = exceeded * 2 * power * 3 * values[1] ** 2 * values[0] / (4 * values[2] ** 2)
            slope /= 1 + 3 * (values[1] * values[0] / values[2]) ** 2 / 4
            found = random_rotation.distribution_of_amplitude(a, alpha, beta, gamma)
            assert float(found) == pytest.approx(float(1 - exceeded), rel=1e-11)
            if slope * values[2] / values[3] > 1e-290 and slope < 1e290:
                found = random_rotation.density_of_amplitude(a, alpha, beta, gamma)
                assert float(found) == pytest.approx(float(slope), rel=1e-11)

            g_13, g_23, k = 10 ** rng.uniform(-45, 45), *10 ** rng.uniform(-90, 90, 2)
            d_33 = g_13**2 * 10 ** rng.uniform(0.1, 2)
            Omega = k * g_23 / np.sqrt(d_33) * 10 ** rng.uniform(-2, 1)
            values = [mpmath.mpf(float(x)) for x in (Omega, k, g_13, g_23, d_33)]
            unit = values[3] * values[1] / mpmath.sqrt(2 * values[4])
            freedom, t = 2 * values[4] / values[2] ** 2, values[0] / unit
            student = mpmath.gamma((freedom + 1) / 2) / mpmath.gamma(freedom / 2) / mpmath.sqrt(mpmath.pi * freedom)
            density = student * (1 + t**2 / freedom) ** (-(freedom + 1) / 2) / unit
            if density * unit > 1e-290 and 1e-290 < density < 1e290:
                found = random_rotation.density_of_frequency(Omega, k, g_13, g_23, d_33)
                assert float(found) == pytest.approx(float(density), rel=1e-11)
            square = unit**2 * freedom / (freedom - 2)
            if 1e-290 < square < 1e290:
                found = random_rotation.mean_square_of_frequency(k, g_13, g_23, d_33)
                assert float(found) == pytest.approx(float(square), rel=1e-12)


def exact_load(axes: Array, demand: Array, limits: Array) -> tuple[Fraction, float]:
    """The least load of a demand, by exact half-spaces; and the distance of the nearest face."""
    rows, target, most = ([Fraction(float(x)) for x in np.ravel(part)] for part in (axes, demand, limits))
    vectors = [rows[k : k + 3] for k in range(0, len(rows), 3)]
    load, nearest = Fraction(0), np.inf
    for u, v in combinations(vectors, 2):
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        distance = sum(h * abs(sum(map(_times, normal, axis))) for h, axis in zip(most, vectors, strict=True))
        load = max(load, abs(sum(map(_times, normal, target))) / distance)
        nearest = min(nearest, float(distance) / float(sum(map(_times, normal, normal))) ** 0.5)
    return load, nearest


def _times(x: Fraction, y: Fraction) -> Fraction:
    return x * y


def test_limits_that_differ_by_many_decades_are_shared_as_exact_numbers_say() -> None:
    rng = np.random.default_rng(1)
    whole = np.vstack([np.eye(3), [[0.6, 0.8, 0], [0, 0.6, -0.8], [0.8, 0, 0.6]]])
    for case in range(120):
        count = int(rng.integers(3, 7))
        axes = whole[rng.permutation(count)] if case % 2 else rng.normal(size=(count, 3))
        axes = axes / np.linalg.norm(axes, axis=1)[:, None]
        if np.linalg.matrix_rank(axes) < 3:
            continue
        limits = 10.0 ** rng.choice([-12, -9, -6, 0, 5, 9, 12], count)
        demand = rng.normal(size=3) * 10 ** rng.uniform(-10, 10)
        expected, nearest = exact_load(axes, demand, limits)
        found = wheels.allocate(axes, demand, limits)
        rounding = 1e-14 * np.linalg.norm(demand)  # of the demand itself, as a load of the smallest wheels
        assert float(found.load) == pytest.approx(float(expected), rel=1e-9, abs=rounding / nearest)
        assert np.abs(found.momenta @ axes - demand).max() <= 1e-12 * np.abs(demand).max()


# --- fast and slow modes


def test_rates_far_apart_take_no_more_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    counts, ends = [], []
    solve = decay.solve_ivp

    def counted(*args: Any, **options: Any) -> Any:
        solution = solve(*args, **options)
        counts.append(solution.nfev)
        return solution

    monkeypatch.setattr(decay, "solve_ivp", counted)
    for fast in (1e4, 1e8, 1e9, 1e12):
        damping = AXES.T @ np.diag([fast, 0.3, 0.4]) @ AXES
        ends.append(inertia.free_decay(MOMENTS, (damping + damping.T) / 2, RATE, [0, 20])[-1])
    assert max(counts) < 2 * counts[0]
    np.testing.assert_allclose(ends[1], ends[2], rtol=1e-5)  # the slow modes do not feel how fast the fast one is


# --- numbers far apart, and at the ends of the doubles


def test_slacks_of_nearly_flat_bodies_are_right_to_rounding() -> None:
    rng = np.random.default_rng(6)
    for _ in range(200):
        least, middle = 10 ** rng.uniform(-30, 0), rng.uniform(1, 2)
        moments = [least, middle, middle + least * rng.choice([0.0, 0.5, 1.0])]
        one, two, three = map(Fraction, moments)
        exact = [two + three - one, three + one - two, one + two - three]
        np.testing.assert_allclose(inertia.triangle_slack(moments), list(map(float, exact)), rtol=4e-16)
        if min(exact) >= 0:
            half = [float(x / 2) for x in exact]
            np.testing.assert_allclose(inertia.second_moments_of_mass(moments), half, rtol=4e-16)
    for scale in (1e-320, 1.5e308):
        assert inertia.triangle_slack(scale * np.ones(3)).tolist() == [scale] * 3
    with pytest.raises(ValueError, match="the slack"):
        inertia.triangle_slack([-1.7e308, 1.7e308, 1.7e308])


def test_torques_with_a_power_are_right_at_both_ends_of_the_doubles() -> None:
    numbers = [5e-324, 1e-310, 1e-200, 1e-100, 1.0, 1e100, 1e200, 1e300]
    for power in [0.0, *numbers]:
        for rotor in numbers:
            for stored in numbers:
                found = float(wheels.torque_range([stored], 1e300, power=power, rotor_inertia=rotor).greatest[0])
                exact = min(Fraction(power) * Fraction(rotor) / Fraction(stored), Fraction(1e300))
                assert found == pytest.approx(float(exact), rel=1e-15, abs=5e-324)


@pytest.mark.parametrize("zeros", [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)])
def test_the_phase_of_no_amplitude_is_0_whatever_the_signs_of_zeros(zeros: tuple[float, float]) -> None:
    found = random_rotation.amplitude_phase_frequency([*zeros, 1.0], 0.5).psi
    assert found == 0
    assert not np.signbit(found)


def test_the_time_of_a_slow_turn_is_right_where_its_rate_is_a_denormal() -> None:
    for angle, gain in ((1.5e-323, 5e-324), (1e-315, 1e-320), (1e-260, 5e-324), (3.0, 2.0)):
        expected = 2 * mpmath.sqrt(mpmath.mpf(angle) / mpmath.mpf(gain))
        assert attitude.turn_time(angle, 10.0, gain) == pytest.approx(float(expected), rel=1e-15)
    assert attitude.turn_time(1e-320, 5e-324, 1e300) == pytest.approx(1e-320 / 5e-324, rel=1e-15)


def test_momenta_are_exact_after_many_turns_and_of_rates_that_are_tiny() -> None:
    rng = np.random.default_rng(9)
    with mpmath.workdps(400):
        for case in range(300):
            w = 10 ** rng.uniform(-6, 1) if case % 3 else 10 ** rng.uniform(-140, -40)
            t = 10 ** rng.uniform(-2, 30) / w
            k = (0.0, 1 / t, 5e-324, w * 1e-30, 1e3 * w)[case % 5]
            T, P, Q, G = (x * y for x, y in zip(rng.normal(size=4), (1 / t, w, w, 1.0), strict=True))
            found = attitude.momentum_in_time([t], [T, 0, 0], [P, 0, 0], [Q, 0, 0], w, [G, 0, 0], k)[0, 0]
            exact = [mpmath.mpf(float(x)) for x in (T, P, Q, w, t, k, G)]
            T_, P_, Q_, w_, t_, k_, G_ = exact
            sine, cosine = mpmath.sin(w_ * t_), mpmath.cos(w_ * t_)
            left, both = mpmath.exp(-k_ * t_), w_**2 + k_**2
            kept = (1 - left) / k_ if k_ else t_
            even = (k_ * cosine + w_ * sine - k_ * left) / both
            odd = (k_ * sine - w_ * cosine + w_ * left) / both
            value = G_ * left + T_ * kept + P_ * even + Q_ * odd
            size = max(abs(x) for x in (G_, T_ * t_, P_ / w_, Q_ / w_))
            assert abs(float(found - value)) <= 1e-14 * float(size)


def test_waves_of_flat_tanks_carry_what_exact_numbers_say() -> None:
    with mpmath.workdps(40):
        for slenderness in (1e-4, 1.0, 1e2, 1e4, 1e6):
            found = liquid.liquid_in_a_cylinder(1.0, 1.0, 2 / slenderness, 1.0, modes=1)
            half = mpmath.mpf(2 / slenderness) / 2
            wave = mpmath.pi / (2 * half)
            start = float(wave) * np.sqrt(max(4 / float(found.lambda_n[0]) ** 2 - 1, 0))
            x = mpmath.findroot(
                lambda x: x * mpmath.besselj(0, x) + (mpmath.hypot(1, x / wave) - 1) * mpmath.besselj(1, x),  # noqa: B023
                2.4 if slenderness > 1e3 else start,
            )
            tau = 2 / mpmath.hypot(1, x / wave)
            carried = 4 * tau**2 * (2 + tau) / (half**2 * wave**4 * (2 - tau) * (2 * wave**2 + 2 - tau))
            assert float(found.E_n[0]) == pytest.approx(float(carried), rel=1e-12, abs=0)


def test_volumes_of_limits_far_apart_are_right() -> None:
    flat = [[1, 0, 0], [0, 1, 0], [0.6, 0.8, 0], [0, 0, 1]]
    cases = [
        (np.eye(3), [1e200, 1e-150, 1e-150], 8e-100),
        (np.eye(3), [1e90, 1e-120, 1e-120], 8e-150),
        (np.eye(3), [1e302, 1e-300, 1e300], 8e302),
        (flat, [1e200, 1e200, 1e200, 1e-300], 8 * 2.4e100),
        (flat, [1e-320, 1.0, 0.0, 1e300], 8 * 1e-320 * 1e300),
        (flat[:3], [1e200, 1e200, 1e200], 0.0),
    ]
    for axes, limits, expected in cases:
        assert float(wheels.volume(axes, limits)) == pytest.approx(expected, rel=1e-14, abs=0)
    several = wheels.volume(
        np.eye(3), [limits for axes, limits, _ in cases if len(axes) == 3 and limits[0] < 1e302][:2]
    )
    assert several == pytest.approx([8e-100, 8e-150], rel=1e-14, abs=0)


def test_what_modes_leave_of_a_body_is_exact_where_they_nearly_take_all_of_it() -> None:
    A, E_n = 1.0, np.array([0.1, 0.2, 0.3, 0.4 - 4e-16])
    rest = Fraction(A) - sum(map(Fraction, E_n.tolist()))
    assert rest > 0
    assert float(rest) != A - E_n.sum()
    found = liquid.frequencies(A, 2.0, E_n, [2.0, 3.0, 4.0, 5.0], 1.0).real[-1]
    with mpmath.workdps(50):
        modes = [(mpmath.mpf(float(e)), n) for e, n in zip(E_n, (2, 3, 4, 5), strict=True)]
        expected = mpmath.findroot(
            lambda eta: A * eta + 1 - eta * (eta - 1) * sum(e / (eta - n) for e, n in modes), float(found)
        )
    assert found == pytest.approx(float(expected), rel=1e-12)
    with pytest.raises(ValueError, match="sum of E_n"):
        liquid.frequencies(1.0, 2.0, [0.1] * 10, [2.0] * 10, 1.0)


def test_gyroscopic_torques_are_right_to_rounding_where_moments_nearly_coincide() -> None:
    rng = np.random.default_rng(12)
    for gap in (0.0, 2.0**-50, 1e-10, 1e-3):
        moments, rate = np.array([1.1, 1.1 + gap, 0.7]), rng.normal(size=3)
        I_1, I_2, I_3 = map(Fraction, moments.tolist())
        w_1, w_2, w_3 = map(Fraction, rate.tolist())
        exact = [(I_2 - I_3) * w_2 * w_3 / I_1, (I_3 - I_1) * w_3 * w_1 / I_2, (I_1 - I_2) * w_1 * w_2 / I_3]
        found = inertia.angular_acceleration(moments, np.zeros((3, 3)), rate)
        np.testing.assert_allclose(found, list(map(float, exact)), rtol=1e-15)
    spin = inertia.free_decay([2, 2, 3], np.zeros((3, 3)), [0.1, 0.2, 0.3], [0, 5, 50])[:, 2]
    assert spin == pytest.approx(0.3, rel=1e-15)


def test_decay_rates_are_right_of_energies_nearly_equal_and_far_apart() -> None:
    for first, last in ((1 + 1e-10, 1.0), (1.0, 1 + 1e-13), (1.0, 1.0), (1e-200, 1e120), (1e300, 5e-324), (2.0, 1.0)):
        with mpmath.workdps(50):
            exact = mpmath.log(mpmath.mpf(first) / mpmath.mpf(last)) / 2
        assert float(inertia.decay_rate([0, 1], [first, last])) == pytest.approx(float(exact), rel=1e-15, abs=0)


def test_energies_of_slow_rotations_are_no_silent_zeros() -> None:
    assert float(inertia.kinetic_energy([1e100, 1e100, 1e100], [[1e-170, 0, 0]])[0]) == pytest.approx(5e-241, abs=0)


def test_torques_of_null_motion_keep_to_their_limits_whatever_the_gain() -> None:
    axes = wheels.four_wheels(1.0, 0.7)
    for momenta, gain in ((1e302, 1e10), (1e302, 1e-320), (1.0, 1e308), (1e-310, 1e300)):
        found = wheels.null_torque(axes, np.array([1, -1, -1, 1]) * momenta, np.zeros(4), 0.01, gain)
        expected = min(Fraction(momenta) * Fraction(gain), Fraction(0.01))
        np.testing.assert_allclose(found, np.array([-1, 1, 1, -1]) * float(expected), rtol=1e-9)
