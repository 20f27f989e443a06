"""Momentum that disturbance torques leave in the wheels, with and without dumping, and when the wheels are full.

The body keeps its orientation, so that axes fixed in it are fixed in space. A disturbance is the torque
T + P cos(w t) + Q sin(w t) with the frequency w of the orbit or a multiple of it; dumping takes off k H.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.numeric.arrays import results
from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import Array, finite, moderate, momentum, not_negative, positive, power_of_two, real
from symcheck.numeric.relations import kernels_of_relations
from symcheck.numeric.wheels.faces import HalfSpaces
from symcheck.numeric.wheels.margins import checked_half_spaces

ACROSS = 1e-12  # of a vector: what rounding leaves of it across its own plane
SHORT = 2.0**-60  # of a turn or of dumping, in radians: what lies between two expressions then is rounding
HALF = 26  # of the bits of a double: the product of two halves is exact
HALVINGS = 64  # of an interval: no double is left inside


class MomentumOfAPeriod(NamedTuple):
    """What one period of a disturbance leaves in the wheels.

    Parameters
    ----------
    secular
        Momentum that stays after each period, N m s; shape (..., 3).
    cyclic
        Amplitude by which the momentum swings about its mean course, along each axis, N m s; shape (..., 3).
    """

    secular: Array
    cyclic: Array


@gufunc("(axis),(axis),(axis),()->(axis),(axis)")
def momentum_of_a_period(
    constant: ArrayLike, cosine: ArrayLike, sine: ArrayLike, frequency: ArrayLike
) -> MomentumOfAPeriod:
    """The momentum that a period of a disturbance leaves, 2 pi T/w, and by how much it swings, sqrt(P^2 + Q^2)/w.

    Parameters
    ----------
    constant
        Torque T, N m; shape (..., 3).
    cosine
        Amplitudes P of the torque that goes with the cosine, N m; shape (..., 3).
    sine
        Amplitudes Q of the torque that goes with the sine, N m; shape (..., 3).
    frequency
        Angular frequency w, rad/s; shape (...), positive.

    Returns
    -------
    MomentumOfAPeriod
        The secular and the cyclic part.

    Raises
    ------
    ValueError
        If the frequency is not positive, a number is not finite, or a result leaves the range of doubles.

    Notes
    -----
    Source: relations:6.

    Examples
    --------
    >>> found = momentum_of_a_period([1e-6, 0, 0], [3e-6, 0, 0], [4e-6, 0, 0], 1e-3)
    >>> found.secular.round(6).tolist(), found.cyclic.round(6).tolist()
    ([0.006283, 0.0, 0.0], [0.005, 0.0, 0.0])
    """
    mean, even, odd = (real(name, x, (3,)) for name, x in (("constant", constant), ("cosine", cosine), ("sine", sine)))
    rate = positive("frequency", frequency)[..., None]
    with np.errstate(over="ignore"):
        secular, cyclic = 2 * np.pi * (mean / rate), np.hypot(even / rate, odd / rate)
    return MomentumOfAPeriod(*results(finite("the secular momentum", secular), finite("the cyclic momentum", cyclic)))


@gufunc("(time),(axis),(axis),(axis),(),(axis),()->(time,axis)")
def momentum_in_time(
    times: ArrayLike,
    constant: ArrayLike,
    cosine: ArrayLike,
    sine: ArrayLike,
    frequency: ArrayLike,
    initial: ArrayLike = (0.0, 0.0, 0.0),
    dumping: ArrayLike = 0.0,
) -> Array:
    """The momentum in the wheels under a constant and a periodic torque: dH/dt = T + P cos(w t) + Q sin(w t) - k H.

    Parameters
    ----------
    times
        Times from the beginning on, s; shape (..., n), not negative.
    constant, cosine, sine, frequency
        As for `momentum_of_a_period`.
    initial
        Momentum at the time 0, N m s; shape (..., 3).
    dumping
        Rate k of dumping, 1/s; shape (...), not negative. With 0 nothing is dumped.

    Returns
    -------
    ndarray
        Momentum, N m s; shape (..., n, 3).

    Raises
    ------
    ValueError
        If an argument does not fit, or a momentum leaves the range of doubles.

    Notes
    -----
    Exact to rounding of the greatest of its terms, also after many turns. Source: relations:6, relations:10.

    Examples
    --------
    >>> momentum_in_time([0, 1000, 2000], [1e-6, 0, 0], [0, 0, 0], [0, 0, 0], 1e-3)[:, 0].round(6).tolist()
    [0.0, 0.001, 0.002]
    >>> momentum_in_time([1e6], [1e-6, 0, 0], [0, 0, 0], [0, 0, 0], 1e-3, dumping=1e-4)[:, 0].round(6).tolist()
    [0.01]
    """
    moments_ = not_negative("times", times, shape=(None,))[..., None]
    at = _Disturbance.of(constant, cosine, sine, frequency, initial, dumping)
    return at.momentum(moments_, *(each[..., None, :] for each in at.parts()))


@gufunc("(p,axis),(p),(axis),(axis),(axis),(axis),(),(axis),()->()")
def time_to_saturation(
    half_spaces: HalfSpaces,
    constant: ArrayLike,
    cosine: ArrayLike,
    sine: ArrayLike,
    frequency: ArrayLike,
    initial: ArrayLike = (0.0, 0.0, 0.0),
    dumping: ArrayLike = 0.0,
) -> Array:
    """When the momentum of `momentum_in_time` first reaches the boundary of the envelope.

    Parameters
    ----------
    half_spaces
        Half-spaces of one momentum envelope, or of many, as `wheels.half_spaces` gives them.
    constant, cosine, sine, frequency, initial, dumping
        As for `momentum_in_time`.

    Returns
    -------
    ndarray
        Time, s; shape (...): 0 if the momentum begins outside or on the boundary, infinite if it never gets there.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Nothing is stepped through. Along each normal the momentum of a time one period later is greater, or for every time
    less; so the first time lies within the first period, or within the one that begins when its upper envelope reaches
    the plane, which is known in closed form. There the zeros of its slope are bracketed by phases that are known, and
    between them it is monotone, so that bisection finds the time to rounding, after ten orbits or after ten million.
    Source: relations:6, relations:10.

    Examples
    --------
    >>> from symcheck.numeric.wheels import half_spaces
    >>> bounds = half_spaces(np.eye(3), 0.01)
    >>> time_to_saturation(bounds, [1e-6, 0, 0], [0, 0, 0], [0, 0, 0], 1e-3).round(6)
    np.float64(10000.0)
    >>> float(time_to_saturation(bounds, [1e-6, 0, 0], [0, 0, 0], [0, 0, 0], 1e-3, dumping=2e-4))
    inf
    """
    bounds = checked_half_spaces(half_spaces)
    vectors, unit = _Disturbance.of(constant, cosine, sine, frequency, initial, dumping).in_turns()
    normals, offset = bounds.normals, vectors.initial - bounds.centre

    def along(vector: Array) -> Array:
        """The components along both senses of each normal."""
        value = np.einsum("...jk,...k->...j", normals, vector)
        return np.concatenate([value, -value], axis=-1)

    size = np.linalg.norm([np.linalg.norm(each, axis=-1) for each in np.broadcast_arrays(*vectors[:3])], axis=0)
    within = np.abs(along(offset)) <= ACROSS * np.linalg.norm(offset, axis=-1)[..., None]
    still = (
        np.linalg.norm([along(each) for each in np.broadcast_arrays(*vectors[:3])], axis=0) <= ACROSS * size[..., None]
    )
    distances = np.concatenate([bounds.distances] * 2, axis=-1)
    largest = distances.max(axis=-1, where=np.isfinite(distances), initial=0)[..., None]
    flat = (distances <= ACROSS * largest) & within & still  # motion in the plane of a flat envelope does not leave it
    one = vectors._replace(
        constant=along(vectors.constant), cosine=along(vectors.cosine), sine=along(vectors.sine),
        initial=along(vectors.initial), frequency=vectors.frequency[..., None], dumping=vectors.dumping[..., None],
    )  # fmt: skip
    limit = distances + along(bounds.centre)
    with np.errstate(all="ignore"):
        times = np.where(flat, np.inf, _first(one, limit))
        times = times / unit[..., None]
    return np.asarray(times.min(axis=-1, initial=np.inf))


class _Disturbance(NamedTuple):
    """Checked arguments: vectors (..., 3), or their components along some normals."""

    constant: Array
    cosine: Array
    sine: Array
    initial: Array
    frequency: Array
    dumping: Array

    @classmethod
    def of(
        cls,
        constant: ArrayLike,
        cosine: ArrayLike,
        sine: ArrayLike,
        frequency: ArrayLike,
        initial: ArrayLike,
        dumping: ArrayLike,
    ) -> _Disturbance:
        named = (("constant", constant), ("cosine", cosine), ("sine", sine))
        torques = [moderate(name, real(name, value, (3,))) for name, value in named]
        mean, even, odd = torques
        return cls(
            mean,
            even,
            odd,
            momentum("initial", initial, (3,)),
            positive("frequency", frequency),
            not_negative("dumping", dumping),
        )

    def in_turns(self) -> tuple[_Disturbance, Array]:
        """The same in a unit of time in which the frequency is nearly 1, so that its powers are doubles; and 1/unit."""
        unit = power_of_two(self.frequency)
        with np.errstate(all="ignore"):
            torques = [finite("a torque", each / unit[..., None]) for each in self[:3]]
            scaled = finite("dumping", self.dumping / unit)
        return _Disturbance(torques[0], torques[1], torques[2], self.initial, self.frequency / unit, scaled), unit

    def parts(self) -> tuple[Array, ...]:
        """All of them, numbers with an axis for that of the vectors."""
        return (*self[:4], self.frequency[..., None], self.dumping[..., None])

    def momentum(self, time: Array, *parts: Array) -> Array:
        """The momentum at some times, from parts of one shape with them."""
        arguments = np.broadcast_arrays(time, *(parts or self))
        time, constant, cosine, sine, initial, frequency, dumping = arguments
        with np.errstate(all="ignore"):
            short = np.maximum(frequency, dumping) * time < SHORT
            found = initial + time * (constant + cosine + sine * (frequency * time / 2))
            unit = power_of_two(np.maximum(frequency, dumping))
            frequency, dumping, time = frequency / unit, dumping / unit, time * unit
            named = {"T": constant / unit, "P": cosine / unit, "Q": sine / unit, "omega": frequency}
            turned = _within_a_turn(frequency, time)
            dumped = ~short & (dumping * time >= SHORT)

            def of(kernel: str, where: NDArray[np.bool_], **further: Array) -> Array:
                chosen = {name: value[where] for name, value in {**named, **further, "t": turned}.items()}
                value: Array = getattr(kernels_of_relations, kernel)(**chosen)
                return value

            free, before = ~short & ~dumped, initial + named["T"] * (time - turned)
            found[free] = of("momentum_of_a_disturbance", free, G=before)
            gone = -np.expm1(-dumping * time)
            found[dumped] = of("momentum_with_dumping", dumped, G=initial, k=dumping, q=gone)
        return found if parts == () else finite("a momentum", found)


def _within_a_turn(frequency: Array, time: Array) -> Array:
    """A time at which the phase is that of the given time, which is greater by whole turns.

    The phase is the exact product: its rounding is as great as the phase after 1e16 radians.
    """
    (rate, power), (span, further) = np.frexp(frequency), np.frexp(time)
    phase, high, above = rate * span, *(np.ldexp(np.rint(np.ldexp(x, HALF)), -HALF) for x in (rate, span))
    low, below = rate - high, span - above
    lost = ((high * above - phase) + high * below + low * above) + low * below
    phase, lost = np.ldexp(phase, power + further), np.ldexp(lost, power + further)
    sine, cosine, beside, along = np.sin(phase), np.cos(phase), np.sin(lost), np.cos(lost)
    angle = np.arctan2(sine * along + cosine * beside, cosine * along - sine * beside)
    return np.asarray(np.where(phase < 1, time, angle / frequency))


def _first(one: _Disturbance, limit: Array) -> Array:
    """When each component first reaches its limit, infinity if never."""
    rate, k = one.frequency, one.dumping
    both = k**2 + rate**2
    even, odd = (k * one.cosine - rate * one.sine) / both, (k * one.sine + rate * one.cosine) / both
    swing = np.hypot(even, odd)
    gain = one.constant - k * (one.initial - even)  # of the course about which the momentum swings
    room = limit - one.initial + even - swing
    reached = np.where(gain > 0, room / gain, np.where(room <= 0, 0.0, np.inf))
    begin = np.where(k * reached >= SHORT, -np.log1p(-k * reached) / k, reached)
    begin = np.where(gain > 0, np.where(k * reached >= 1, np.inf, np.maximum(begin, 0)), 0.0)
    some = np.isfinite(begin)
    start = np.where(some, begin, 0.0)
    ends = _monotone(one, start)
    values = np.stack([one.momentum(end) for end in ends])
    over = values[1:] >= limit
    which = np.argmax(over, axis=0)[None]
    low, high = (np.take_along_axis(part, which, axis=0)[0] for part in (ends[:-1], ends[1:]))
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        beyond = one.momentum(middle) >= limit
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    crossed = np.where(some & over.any(axis=0), high, np.inf)
    return np.asarray(np.where(one.initial >= limit, 0.0, crossed))


def _monotone(one: _Disturbance, start: Array) -> Array:
    """Times from the start over one period and a half, between which the momentum is monotone; shape (times, ...).

    Its slope is p cos(w t) + q sin(w t) + r e^(-kt), relations:42. It is 0 once at most between two times at which its
    product with e^(kt) is extreme.
    """
    rate, k = one.frequency, one.dumping
    both = k**2 + rate**2
    p = rate * (k * one.sine + rate * one.cosine) / both
    q = -rate * (k * one.cosine - rate * one.sine) / both
    r = one.constant + one.cosine - k * one.initial - p

    def rises(time: Array) -> NDArray[np.bool_]:
        phase = rate * time
        return np.asarray(p * np.cos(phase) + q * np.sin(phase) + r * np.exp(-k * time) > 0)

    first = np.arctan2(-(k * p + rate * q), k * q - rate * p)
    before = np.ceil((rate * start - first) / np.pi)
    turns = [np.broadcast_to((first + np.pi * (before + step)) / rate, start.shape) for step in range(4)]
    end = start + 3 * np.pi / rate
    grid = [start, *(np.clip(turn, start, end) for turn in turns), end]
    ends = [start]
    for low, high in pairwise(grid):
        rising = rises(low)
        left, right = low, high
        for _ in range(HALVINGS):
            middle = (left + right) / 2
            same = rises(middle) == rising
            left, right = np.where(same, middle, left), np.where(same, right, middle)
        ends += [right, high]
    return np.stack(np.broadcast_arrays(*ends))
