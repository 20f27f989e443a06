"""Pictures of the randomly driven rotation: densities, alone or over histograms of samples, and sample paths."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.domain import Array, number, real, require
from symcheck.numeric.drawing import Panels, new_figure
from symcheck.numeric.random_rotation.amplitude import density_of_amplitude, quantile_of_amplitude
from symcheck.numeric.random_rotation.ensemble import Ensemble
from symcheck.numeric.random_rotation.frequency import density_of_frequency, quantile_of_frequency
from symcheck.numeric.random_rotation.variables import amplitude_phase_frequency

if TYPE_CHECKING:
    from matplotlib.axes import Axes

TAIL = 0.002  # probability that a picture leaves out at each end
POINTS, BINS = 401, 60  # of a curve that looks smooth; of a histogram of some 10,000 samples


def plot_amplitude(
    alpha: float, beta: float, gamma: float, *, sample: ArrayLike | None = None, ax: Axes | None = None
) -> Axes:
    """The stationary density of the amplitude, over the histogram of a sample if one is given (figure 1).

    Parameters
    ----------
    alpha, beta, gamma
        Parameters of `density_of_amplitude`; one number each.
    sample
        Amplitudes, rad/s, of any shape, drawn as a histogram.
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If no stationary density exists, or a parameter is not one number.

    Notes
    -----
    Source: (3.4), 4.0.20.

    Examples
    --------
    >>> plot_amplitude(1.0, 0.75**0.5, 1.0).get_xlabel()
    'amplitude a, rad/s'
    """
    parameters = number("alpha", alpha), number("beta", beta), number("gamma", gamma)
    end = quantile_of_amplitude(1 - TAIL, *parameters)
    grid = np.linspace(0, end, POINTS)
    return _density(ax, density_of_amplitude, grid, parameters, sample, "amplitude a, rad/s", "(3.4)")


def plot_frequency(
    k: float, g_13: float, g_23: float, d_33: float, *, sample: ArrayLike | None = None, ax: Axes | None = None
) -> Axes:
    """The stationary density of the frequency, over the histogram of a sample if one is given (figure 2).

    Parameters
    ----------
    k, g_13, g_23, d_33
        Parameters of `density_of_frequency`; one number each.
    sample
        Frequencies, rad/s, of any shape, drawn as a histogram.
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If no stationary density exists, or a parameter is not one number.

    Notes
    -----
    Source: (3.5), 4.0.20.

    Examples
    --------
    >>> plot_frequency(0.6, 1.0, 1.0, 1.5).get_ylabel()
    'density, s/rad'
    """
    parameters = number("k", k), number("g_13", g_13), number("g_23", g_23), number("d_33", d_33)
    end = quantile_of_frequency(1 - TAIL, *parameters)
    grid = np.linspace(-end, end, POINTS)
    return _density(ax, density_of_frequency, grid, parameters, sample, "frequency Ω, rad/s", "(3.5)")


def plot_paths(ensemble: Ensemble, k: float, *, paths: int = 5, axes: Panels | None = None) -> Panels:
    """Amplitude and frequency of the first sample paths against time.

    Parameters
    ----------
    ensemble
        Result of `simulate` with `every`.
    k
        Ratio (A - C)/A of the moments of inertia; one number.
    paths
        Number of paths.
    axes
        Two Axes to draw in; by default those of a new figure.

    Returns
    -------
    ndarray
        Two Axes.

    Raises
    ------
    ValueError
        If k is not positive.

    Notes
    -----
    Source: (2.3).

    Examples
    --------
    >>> from symcheck.numeric.random_rotation import RandomTorques, simulate
    >>> D = [[1, 0.3, 0.2], [0.2, 0.5, 0.1], [0.2, 0.1, 0.9]]
    >>> torques = RandomTorques(0.01, 0.6, D, g_1=[0.6, 0.8, 0.7], g_2=[1, 0, 1])
    >>> ensemble = simulate(torques, [[1.0, 0.0, 2.0]] * 3, 2.0, 50, seed=1, every=1)
    >>> len(plot_paths(ensemble, torques.k)[0].lines)
    3
    """
    axes = new_figure().subplots(2, 1, sharex=True) if axes is None else axes
    rotation = amplitude_phase_frequency(ensemble.angular_velocity[:, :paths], k)
    for ax, values, label in zip(
        axes, (rotation.a, rotation.Omega), ("amplitude a, rad/s", "frequency Ω, rad/s"), strict=True
    ):
        ax.plot(ensemble.time, values, linewidth=0.8)
        ax.set_ylabel(label)
    axes[-1].set_xlabel("time, s")
    return axes


def _density(
    ax: Axes | None,
    density: Callable[..., Array],
    grid: Array,
    parameters: tuple[float, ...],
    sample: ArrayLike | None,
    label: str,
    source: str,
) -> Axes:
    ax = new_figure().subplots() if ax is None else ax
    if sample is not None:
        _histogram(ax, real("sample", sample).ravel(), grid)
    ax.plot(grid, density(grid, *parameters), label=f"stationary density {source}")
    ax.set(xlabel=label, ylabel="density, s/rad", xlim=(grid[0], grid[-1]))
    ax.set_ylim(bottom=0)
    ax.legend()
    return ax


def _histogram(ax: Axes, sample: Array, grid: Array) -> None:
    """Normalised by the whole sample, also by what lies beyond the picture."""
    require(sample.size > 0, "sample", sample, "hold at least one value")
    counts, edges = np.histogram(sample, np.linspace(grid[0], grid[-1], BINS + 1))
    ax.stairs(counts / sample.size / np.diff(edges), edges, fill=True, alpha=0.35, label=f"{sample.size:,} samples")
