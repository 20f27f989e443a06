"""Figures of Mirer's paper and of what follows from it. Matplotlib is imported only when one is drawn.

Each function draws into `ax`, or into a new figure, and returns the axes; `axes.figure.savefig(...)` keeps it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.domain import Array, Orientation, positive, principal_moments, real
from symcheck.numeric.drawing import Figures, new_figure
from symcheck.numeric.inertia.damping import (
    characteristic_roots,
    damping_matrix,
    gains_in_proportion,
    stability_degree,
    stability_degree_in_pitch,
)
from symcheck.numeric.inertia.decay import decay_rate, free_decay, kinetic_energy
from symcheck.numeric.inertia.orientation import direction_cosines, equal_moment_angles, equal_moment_axes
from symcheck.numeric.inertia.tensors import axial_moments, bound_at_given_moment, product_of_axial_moments

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from mpl_toolkits.mplot3d import Axes3D

BODY = (2.0, 3.0, 4.5)  # kg m^2, of figures that are drawn without arguments
ANGLES = (0.7, 0.6, 0.5)  # rad
SWEEP = np.linspace(0, 1, 201)  # so many points that curves look smooth


def plot_attitude_angles(
    pitch: float = ANGLES[0], yaw: float = ANGLES[1], roll: float = ANGLES[2], ax: Axes3D | None = None
) -> Axes3D:
    """Draw figure 1: axes y, principal axes x, and the arcs of pitch alpha, yaw beta and roll gamma, in rad.

    Each arc is the path of a principal axis in one of the three turns from y: of x_1 in the first two, of x_2 in the
    third.

    Parameters
    ----------
    pitch, yaw, roll
        Angles alpha, beta and gamma, rad.
    ax
        Three-dimensional Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If an angle is not a finite number.

    Examples
    --------
    >>> plot_attitude_angles().get_zlabel()
    'along $y_3$'
    """
    drawn = _space(ax)
    for letter, axes, colour in (("y", np.eye(3), "0.4"), ("x", direction_cosines(pitch, yaw, roll).T, "C0")):
        for number, axis in enumerate(axes, 1):
            drawn.plot(*np.outer(axis, [0, 1.2]), color=colour)
            drawn.text(*(1.3 * axis), f"${letter}_{number}$", color=colour)
    arcs = (
        (r"\alpha", direction_cosines(pitch * SWEEP, 0, 0)[..., 0]),
        (r"\beta", direction_cosines(pitch, yaw * SWEEP, 0)[..., 0]),
        (r"\gamma", direction_cosines(pitch, yaw, roll * SWEEP)[..., 1]),
    )
    for number, (letter, arc) in enumerate(arcs, 1):
        drawn.plot(*arc.T, color=f"C{number}")
        drawn.text(*(1.1 * arc[SWEEP.size // 2]), f"${letter}$", color=f"C{number}")
    drawn.view_init(elev=25, azim=70, vertical_axis="y")
    return _in_space(drawn, "y", least=-0.6)


def plot_equal_moment_axes(moments: ArrayLike = BODY, ax: Axes3D | None = None) -> Axes3D:
    """Draw the curves on the unit sphere along which the axes of equal moments move, and the paper's triple (2.9).

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (3,).
    ax
        Three-dimensional Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If a moment is not positive.

    Examples
    --------
    >>> plot_equal_moment_axes([2, 3, 4.5]).get_xlabel()
    'along $x_1$'
    """
    moments = real("moments", moments, (3,))
    drawn = _space(ax)
    for nappe, label in ((1, "axes of equal moments"), (-1, None)):
        curve = equal_moment_axes(moments, 2 * np.pi * SWEEP, nappe=nappe)[:, 0]
        drawn.plot(*curve.T, color="C0", label=label)
    for number, axis in enumerate(direction_cosines(*equal_moment_angles(moments)), 1):
        drawn.plot(*np.outer(axis, [0, 1]), color="C1", label="axes of (2.9)" if number == 1 else None)
        drawn.text(*(1.1 * axis), f"$y_{number}$", color="C1")
    drawn.legend()
    return _in_space(drawn, "x")


def plot_bound_of_product(moments: ArrayLike = BODY, axes: Orientation | None = None, ax: Axes | None = None) -> Axes:
    """Draw f_1, the greatest product J_1 J_2 J_3 for each J_2 on [0, 3c/2], with its maximum c^3 and the least product.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (3,).
    axes
        Orientations whose products are marked; shape (n, 3, 3). By default some that cover all angles evenly.
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        As `bound_at_given_moment` and `product_of_axial_moments` do.

    Examples
    --------
    >>> plot_bound_of_product([2, 3, 4]).get_xlabel()
    '$J_2$, kg m$^2$'
    """
    moments, axes = principal_moments(moments), _orientations() if axes is None else np.asarray(axes)
    mean = moments.mean()
    given = 1.5 * mean * SWEEP
    product = product_of_axial_moments(moments, axes)
    drawn = new_figure().add_subplot() if ax is None else ax
    drawn.plot(given, bound_at_given_moment(moments, given), label="$f_1(J_2)$")
    drawn.plot(
        axial_moments(moments, axes)[..., 1], product.value, ".", markersize=3, label="$J_1 J_2 J_3$ of some axes"
    )
    drawn.plot(mean, mean**3, "o", label="$c^3$ at $J_2 = c$")
    drawn.axhline(np.ravel(product.least)[0], color="0.5", linestyle="--", label="$I_1 I_2 I_3$")
    drawn.legend()
    return _labelled(drawn, "$J_2$, kg m$^2$", "product, kg$^3$ m$^6$")


def plot_free_decay(
    moments: ArrayLike = BODY,
    damping: ArrayLike | None = None,
    rate: ArrayLike = (0.02, 0.03, 0.01),
    times: ArrayLike = 150 * SWEEP,
    ax: Axes | None = None,
) -> Axes:
    """Draw how the rotation decays, as sqrt(T/T_0), between the fastest and the slowest decay that the roots allow.

    Parameters
    ----------
    moments
        Principal moments of inertia, kg m^2; shape (3,).
    damping
        Damping matrix, N m s/rad; shape (3, 3). By default that of gains 0.1 J_i along the axes of figure 1.
    rate
        Angular rate at the first time, rad/s; shape (3,).
    times
        Increasing times, s; shape (n,).
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError, FloatingPointError
        As `free_decay` does.

    Notes
    -----
    The legend gives the stability degree and the decay rate measured over the last quarter of the times.

    Examples
    --------
    >>> plot_free_decay().get_yscale()
    'log'
    """
    axes = direction_cosines(*ANGLES)
    damping = damping_matrix(gains_in_proportion(0.1, moments, axes), axes) if damping is None else damping
    times = real("times", times, (None,))
    energy = kinetic_energy(moments, free_decay(moments, damping, rate, times))
    late = times.size - max(times.size // 4, 2)
    measured = decay_rate(times[late:], energy[late:])
    greatest, degree = -characteristic_roots(moments, damping)[0], stability_degree(moments, damping)
    drawn = new_figure().add_subplot() if ax is None else ax
    drawn.plot(times, np.sqrt(energy / energy[0]), label=f"integrated; at the end {measured:.6g} 1/s")
    for value, style, name in ((degree, "--", "stability degree"), (greatest, ":", "greatest damping rate")):
        drawn.plot(times, np.exp(-value * (times - times[0])), style, label=f"{name} {value:.6g} 1/s")
    drawn.set_yscale("log")
    drawn.legend()
    return _labelled(drawn, "time, s", r"$\sqrt{T/T_0}$")


def plot_damping_over_pitch(
    ratios: ArrayLike = 100**SWEEP,
    pitch: ArrayLike = np.pi / 2 * SWEEP,
    ax: Axes | None = None,
) -> Axes:
    """Draw the stability degree of gains k J_i, in units of k, over the pitch and the ratio of the moments I_1, I_3.

    Parameters
    ----------
    ratios
        Increasing ratios I_1/I_3; shape (n,).
    pitch
        Increasing angles alpha, rad; shape (m,).
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If a ratio is not positive.

    Examples
    --------
    >>> plot_damping_over_pitch().get_xlabel()
    'pitch, degrees'
    """
    ratios, pitch = positive("ratios", ratios, "mirer2009:2.0.6", (None,)), real("pitch", pitch, (None,))
    moments = np.stack([ratios, ratios, np.ones_like(ratios)], axis=-1)
    degree = stability_degree_in_pitch(1.0, moments[:, None], pitch)
    drawn = new_figure().add_subplot() if ax is None else ax
    levels = drawn.contourf(np.rad2deg(pitch), ratios, degree, levels=np.linspace(0.5, 1, 21))
    drawn.figure.colorbar(levels, ax=drawn, label=r"stability degree $\xi/k$")
    drawn.set_yscale("log")
    return _labelled(drawn, "pitch, degrees", "$I_1/I_3$")


FIGURES: Figures = {
    "attitude-angles": plot_attitude_angles,
    "bound-of-product": plot_bound_of_product,
    "damping-over-pitch": plot_damping_over_pitch,
    "equal-moment-axes": plot_equal_moment_axes,
    "free-decay": plot_free_decay,
}


def _space(ax: Axes3D | None) -> Axes3D:
    return new_figure().add_subplot(projection="3d") if ax is None else ax


def _labelled(ax: Axes, across: str, up: str) -> Axes:
    ax.set(xlabel=across, ylabel=up)
    return ax


def _in_space(ax: Axes3D, frame: str, least: float = -1.2) -> Axes3D:
    """A cube that holds the unit vectors, with its directions named."""
    ax.set(**{f"{axis}label": f"along ${frame}_{i}$" for i, axis in enumerate("xyz", 1)}, aspect="equal")
    ax.set(**{f"{axis}ticks": (-1, 0, 1) for axis in "xyz"}, **{f"{axis}lim": (least, 1.2) for axis in "xyz"})
    return ax


def _orientations() -> Array:
    """800 orientations that cover pitch, sine of yaw and roll evenly: multiples of powers of 1/g with g^4 = g + 1."""
    pitch, sine, roll = np.outer(1.2207440846057596 ** -np.arange(1.0, 4.0), np.arange(1, 801)) % 1
    return direction_cosines(2 * np.pi * pitch, np.arcsin(2 * sine - 1), 2 * np.pi * roll)
