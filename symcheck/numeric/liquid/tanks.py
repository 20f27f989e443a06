"""The modes of an ideal liquid that fills a tank, where they are known in closed form: spheres, ellipsoids, cylinders.

The tank is a body of revolution about the axis of the spin, at the centre of which the moments are taken. A full
ellipsoid has one mode, of uniform vorticity. A full cylinder has infinitely many inertial waves; those that carry most
are given.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.domain import (
    Array,
    common_shape,
    exact,
    finite,
    moderate,
    not_negative,
    positive,
    power_of_two,
    real,
    whole,
)
from symcheck.numeric.relations import kernels_of_relations

SMALLEST, LARGEST = 1e-100, 1e100  # of a mass, length or rate: a mass times the square of a length is a double
FLAT, LONG = 1e-6, 1e6  # of radius over half height: fifth powers are doubles
HALVINGS = 64  # of an interval: no double is left inside
MOST = 100  # modes: their table of candidates has a hundred radial numbers


class Liquid(NamedTuple):
    """A liquid in a tank, as `stability` and the other functions want it; N modes.

    Parameters
    ----------
    A
        Transverse moment of inertia of the frozen liquid, kg m^2; shape (...). Add the body's own.
    C
        Axial moment of inertia of the frozen liquid, kg m^2; shape (...). Add the body's own.
    E_n
        Moments of inertia that the modes carry, kg m^2; shape (..., N).
    lambda_n
        Natural frequencies of the modes, rad/s; shape (..., N).
    """

    A: Array
    C: Array
    E_n: Array
    lambda_n: Array


@gufunc("(),(),(),()->(),(),(mode),(mode)", mode=1)
def liquid_in_an_ellipsoid(mass: ArrayLike, a: ArrayLike, c: ArrayLike, omega_0: ArrayLike) -> Liquid:
    """The liquid that fills an ellipsoid of revolution, such as a sphere.

        E = 4 m a^2 c^2/(5 (a^2 + c^2)),  lambda = 2 a^2 w/(a^2 + c^2)

    Parameters
    ----------
    mass
        Mass m of the liquid, kg; shape (...), positive.
    a
        Semi-axis across the spin, m; shape (...), positive.
    c
        Semi-axis along the spin, m; shape (...), positive. For a sphere c = a.
    omega_0
        Spin w, rad/s; shape (...), positive.

    Returns
    -------
    Liquid
        Its moments when it is frozen, and its one mode.

    Raises
    ------
    ValueError
        If an argument is not between 1e-100 and 1e100.

    Notes
    -----
    In a sphere the frequency is the spin and the mode carries all of the liquid, as no wall can turn it. An oblate tank
    has lambda > w, off the band, and is stable; of a shell without mass the frequencies are complex for a < c < 3 a.
    Source: relations:12 to relations:30, from Helmholtz's equation of the vorticity; the result for the shell is
    Kelvin's.

    Examples
    --------
    >>> found = liquid_in_an_ellipsoid(5.0, 0.3, 0.3, 2.0)
    >>> found.E_n.round(9).tolist(), found.lambda_n.tolist(), found.C.round(9)
    ([0.18], [2.0], np.float64(0.18))
    """
    named = {"mass": mass, "a": a, "c": c, "omega_0": omega_0}
    m, across, along, spin = (_moderate(name, value) for name, value in named.items())
    shape = common_shape(mass=m, a=across, c=along, omega_0=spin)
    m, across, along, spin = (np.broadcast_to(value, shape) for value in (m, across, along, spin))
    unit = power_of_two(np.maximum(across, along))
    shaped = {"a": across / unit, "c": along / unit}
    size = m * unit**2  # of a moment; the rest is a number
    carried = finite("E_n", size * kernels_of_relations.mode_inertia_of_an_ellipsoid(m=1.0, **shaped))
    natural = finite("lambda_n", kernels_of_relations.natural_frequency_of_an_ellipsoid(Omega=spin, **shaped))
    transverse, axial = size * (shaped["a"] ** 2 + shaped["c"] ** 2) / 5, 2 * size * shaped["a"] ** 2 / 5
    return Liquid(np.asarray(transverse), np.asarray(axial), np.array(carried)[..., None], np.array(natural)[..., None])


def liquid_in_a_cylinder(
    mass: ArrayLike, radius: ArrayLike, height: ArrayLike, omega_0: ArrayLike, *, modes: int = 3
) -> Liquid:
    """The liquid that fills a cylinder whose axis is that of the spin, with the modes that carry most.

    Parameters
    ----------
    mass
        Mass m of the liquid, kg; a positive number.
    radius
        Radius a of the cylinder, m; a positive number.
    height
        Height 2 c of the cylinder, m; a positive number.
    omega_0
        Spin w, rad/s; a positive number.
    modes
        How many modes are kept, those with the greatest E_n first.

    Returns
    -------
    Liquid
        Its moments when it is frozen, A = m (a^2/4 + c^2/3) and C = m a^2/2, and the modes.

    Raises
    ------
    ValueError
        If an argument is not between 1e-100 and 1e100, the cylinder is a disc or a needle, or the number of modes is
        not from 1 to 100.

    Notes
    -----
    With k = (2 j - 1) pi/(2 c), j = 1, 2, ... a mode has the frequency tau w, where x J_1'(x) + 2 J_1(x)/tau = 0 and
    x^2 = k^2 a^2 (4 - tau^2)/tau^2. For each j there is one root x between any two zeros of J_1 with tau > 0, and from
    the second interval on one with tau < 0. The mode carries

        E = 4 m tau^2 (2 + tau)/(c^2 k^4 (2 - tau) (2 k^2 a^2 + 2 - tau)).

    All modes together carry what distinguishes the frozen from a liquid at rest in space. Source: relations:31 to
    relations:38.

    Examples
    --------
    >>> found = liquid_in_a_cylinder(5.0, 0.3, 0.8, 2.0)
    >>> found.E_n.round(5).tolist(), found.lambda_n.round(5).tolist()
    ([0.16605, 0.02519, 0.01466], [1.51344, 0.75792, -0.98617])
    """
    named = {"mass": mass, "radius": radius, "height": height, "omega_0": omega_0}
    m, a, whole_height, spin = (exact(name, _moderate(name, value), ()) for name, value in named.items())
    count, c = whole("modes", modes, 1, MOST), whole_height / 2
    slenderness = float(moderate("radius over half of height", a / c, FLAT, LONG))
    carried, ratios = _waves(slenderness, count)
    transverse, axial = np.asarray(m * (a**2 / 4 + c**2 / 3)), np.asarray(m * a**2 / 2)
    return Liquid(transverse, axial, m * a**2 * carried, spin * ratios)


def with_body(A: ArrayLike, C: ArrayLike, liquid: Liquid) -> Liquid:
    """A body together with its liquid: the moments of both, and the modes.

    Parameters
    ----------
    A
        Transverse moment of inertia of the body alone about the centre of the tank, kg m^2; shape (...), not negative.
    C
        Axial moment of inertia of the body alone, kg m^2; shape (...), not negative.
    liquid
        The liquid in its tank.

    Returns
    -------
    Liquid
        What `stability(*whole, omega_0)` takes, with arrays of one leading shape.

    Raises
    ------
    ValueError
        If a moment is negative or the shapes do not fit.

    Notes
    -----
    Source: (1.31), where A and C are those with the liquid at rest.

    Examples
    --------
    >>> tank = liquid_in_an_ellipsoid(1.0, 1.0, 2.0, 1.0)
    >>> whole = with_body(0.5, 0.25, tank)
    >>> float(whole.A), float(whole.C)
    (1.5, 0.65)
    """
    transverse, axial = not_negative("A", A), not_negative("C", C)
    whole_a, whole_c = real("A of liquid", liquid.A), real("C of liquid", liquid.C)
    carried = real("E_n of liquid", liquid.E_n, (None,))
    natural = real("lambda_n of liquid", liquid.lambda_n, carried.shape[-1:])
    shape = common_shape(A=transverse, C=axial, A_of_liquid=whole_a, E_n_of_liquid=carried[..., 0])

    def spread(value: Array, *further: int) -> Array:
        return np.array(np.broadcast_to(value, (*shape, *further)))

    modes = carried.shape[-1]
    return Liquid(spread(transverse + whole_a), spread(axial + whole_c), spread(carried, modes), spread(natural, modes))


def _moderate(name: str, value: ArrayLike) -> Array:
    return moderate(name, positive(name, value), SMALLEST, LARGEST)


def _waves(slenderness: float, count: int) -> tuple[Array, Array]:
    """E_n for the unit mass and radius, and tau, of the waves that carry most, of a cylinder with radius/half height.

    More axial and radial numbers are taken until none of the waves that are left out carries more than those kept.
    """
    size = 4
    while True:
        carried, ratios = _table(slenderness, size)
        order = np.argsort(-carried, axis=None)[:count]
        rows, _, columns = np.unravel_index(order, carried.shape)
        if len(order) == count and max(rows.max(), columns.max()) < size - 1:
            return carried.ravel()[order], ratios.ravel()[order]
        size *= 2


def _table(slenderness: float, size: int) -> tuple[Array, Array]:
    """E_n and tau by axial number, sense of the frequency, and number of the zero; E_n = 0 where there is no wave."""
    from scipy.special import jn_zeros, jv

    zeros = np.concatenate([[0.0], jn_zeros(1, size)])
    k = (np.arange(1, 2 * size, 2) * (np.pi / 2) * slenderness)[:, None, None]  # k a
    sense = np.array([1.0, -1.0])[:, None]
    shape = (size, 2, size)
    low, high = np.broadcast_to(zeros[:-1], shape), np.broadcast_to(zeros[1:], shape)
    outer = np.sign(jv(1, (zeros[:-1] + zeros[1:]) / 2))  # of J_1 between two zeros
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        value = middle * jv(0, middle) - jv(1, middle) + sense * np.hypot(1, middle / k) * jv(1, middle)
        before = value * outer > 0  # x J_1'/J_1 falls from plus to minus infinity, crossing each bound once
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    slope = high / k
    length = np.hypot(1, slope)
    tau = sense * 2 / length
    kernel = kernels_of_relations.mode_inertia_of_a_cylinder
    half = 1 / slenderness
    arguments = {"m": 1.0, "tau": tau, "c": half, "k": k, "a": 1.0}
    # E has the factor (2 + tau)/(2 - tau), and in a flat tank |tau| rounds away what it lacks to 2
    lacks, rounded = 2 * slope**2 / (length * (1 + length)), 2 - np.abs(tau)
    exactly = np.divide(lacks, rounded, out=np.ones(shape), where=rounded > 0) ** -sense
    found = np.array(np.broadcast_to(kernel(**arguments) * exactly, shape))
    found[:, 1, 0] = 0.0
    return found, np.broadcast_to(tau, shape)
