"""Figures of a spinning body with liquid: the map of its stability, and its frequencies against C - A."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.numeric.domain import Array, increasing
from symcheck.numeric.drawing import Figures, Panels, new_figure
from symcheck.numeric.liquid.boundary import StabilityMap, stability_map, unstable_intervals
from symcheck.numeric.liquid.spectrum import stability

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOMENT = "C − A, kg m²"


def plot_stability_map(result: StabilityMap, ax: Axes | None = None) -> Axes:
    """The growth rate as colour over C - A and the first mode's natural frequency, with the boundary of stability.

    Parameters
    ----------
    result
        Result of `stability_map` whose Delta and b_1 increase.
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If an axis of the map does not increase.

    Notes
    -----
    A colour bar gives the growth rate; white is stable. The boundary is that of `unstable_intervals`, for one mode
    (1.35).

    Examples
    --------
    >>> result = stability_map(1.0, [0.2], np.linspace(-0.99, 0.2, 40), np.linspace(-0.2, 1.2, 30))
    >>> plot_stability_map(result).get_xlabel()
    'C − A, kg m²'
    """
    increasing("Delta", result.Delta)
    increasing("b_1", result.b_1)
    ax = new_figure((7, 5)).subplots() if ax is None else ax
    growing = np.ma.masked_equal(result.growth_rate, 0)
    mesh = ax.pcolormesh(result.Delta, result.b_1, growing, cmap="YlOrRd", vmin=0, shading="nearest", rasterized=True)
    ax.figure.colorbar(mesh, ax=ax, label="growth rate, 1/s")
    ax.plot(*_ends(result).T, "k.", markersize=2, label="boundary of stability")
    ax.axvline(0, color="0.6", linewidth=0.8, linestyle=":")
    ax.set(
        xlabel=MOMENT,
        ylabel="natural frequency of the first mode / spin, $b_1$",
        title="Stability of a body with liquid",
    )
    ax.set(xlim=result.Delta[[0, -1]], ylim=result.b_1[[0, -1]])
    ax.legend(loc="upper right")
    return ax


def plot_frequencies(
    A: float, E_n: ArrayLike, lambda_n: ArrayLike, omega_0: float, Delta: ArrayLike, axes: Panels | None = None
) -> Panels:
    """The frequencies against C - A, above, and below them the growth rate.

    Parameters
    ----------
    A, E_n, lambda_n, omega_0
        As for `unstable_intervals`.
    Delta
        Values of C - A, kg m^2; shape (p,), increasing and greater than -A.
    axes
        Two Axes to draw in; by default those of a new figure.

    Returns
    -------
    ndarray
        Two Axes.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Where two frequencies are a conjugate pair their real part is drawn in red. Source: (1.31).

    Examples
    --------
    >>> upper, lower = plot_frequencies(1.0, [0.2], [0.5], 1.0, np.linspace(-0.99, 0.5, 40))
    >>> upper.get_ylabel(), lower.get_ylabel()
    ('frequency η, rad/s', 'growth rate, 1/s')
    """
    moments = increasing("Delta", Delta)
    spectrum = stability(A, A + moments, E_n, lambda_n, omega_0)
    panels = _pair() if axes is None else np.asarray(axes)
    upper, lower = panels
    paired = np.where(spectrum.frequencies.imag != 0, spectrum.frequencies.real, np.nan)
    upper.plot(
        moments, spectrum.frequencies.real, color="black", linewidth=1.2, label=_once("real", spectrum.frequencies)
    )
    upper.plot(moments, paired, color="tab:red", linewidth=2.5, label=_once("real part of a pair", paired))
    for natural in np.atleast_1d(lambda_n):
        upper.axhline(natural, color="0.6", linewidth=0.8, linestyle=":")
    lower.plot(moments, spectrum.growth_rate, color="tab:red")
    upper.set(ylabel="frequency η, rad/s", title="Frequencies of a body with liquid (dotted: those of the modes)")
    lower.set(xlabel=MOMENT, ylabel="growth rate, 1/s")
    upper.set_xlabel("")
    upper.legend(loc="best")
    return panels


def _ends(result: StabilityMap) -> Array:
    """Points (C - A, b_1) of the boundary of stability, shape (points, 2)."""
    rows = [np.append(ratio, result.further_b) * result.omega_0 for ratio in result.b_1]
    ends = [unstable_intervals(result.A, result.E_n, natural, result.omega_0).ravel() for natural in rows]
    return np.column_stack([np.concatenate(ends), np.repeat(result.b_1, [row.size for row in ends])])


def _once(label: str, columns: NDArray[np.generic]) -> list[str]:
    """The label for the first of several curves."""
    return [label, *["_"] * (columns.shape[-1] - 1)]


def _pair() -> Panels:
    panels: Panels = new_figure((7, 6)).subplots(2, sharex=True, height_ratios=(2, 1))
    return panels


def _map_of_one_mode() -> Axes:
    """Where a body with liquid that moves in one mode is unstable, over C - A and the mode's frequency."""
    return plot_stability_map(stability_map(1.0, [0.2], np.linspace(-0.999, 0.2, 400), np.linspace(-0.1, 1.1, 401)))


def _map_of_two_modes() -> Axes:
    """Where a body with liquid that moves in two modes, the second at 0.7 of the spin, is unstable."""
    moments, ratios = np.linspace(-0.999, 0.2, 240), np.linspace(-0.1, 1.1, 241)
    return plot_stability_map(stability_map(1.0, [0.2, 0.02], moments, ratios, further_b=[0.7]))


def _frequencies() -> Panels:
    """Frequencies and growth rate of a body with two modes of its liquid, against C - A."""
    return plot_frequencies(1.0, [0.1, 0.02], [0.3, 0.7], 1.0, np.linspace(-0.999, 0.4, 1500))


FIGURES: Figures = {
    "liquid-stability-map": _map_of_one_mode,
    "liquid-stability-map-of-two-modes": _map_of_two_modes,
    "liquid-frequencies": _frequencies,
}
