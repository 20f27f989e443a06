"""The figures of Ignatov's paper, and what failures leave, drawn with the paper's angles and h_max = 1 N m s."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from symcheck.numeric.domain import Array
from symcheck.numeric.drawing import Figures
from symcheck.numeric.wheels.plots import plot_axes, plot_envelope, plot_failures, plot_projection, plot_projections
from symcheck.numeric.wheels.polytope import envelope
from symcheck.numeric.wheels.sets import four_wheels, listed_vertices, six_wheels

FOUR, SIX = (np.radians(67), np.radians(32)), (np.radians(72),)  # a and b of table 1, a of table 6
WORDS = {3: "four wheels without wheel 4", 4: "four wheels", 5: "six wheels without wheel 6", 6: "six wheels"}


def _axes(working: int) -> Array:
    """The first wheels of their pyramid, which work."""
    return (four_wheels(*FOUR) if working < 5 else six_wheels(*SIX))[:working]


def _figure(words: str, draw: Callable[[], object]) -> Callable[[], object]:
    draw.__doc__ = words
    return draw


def _drawing(plot: Callable[..., object], words: str, working: int, figure: int) -> Callable[[], object]:
    """The function that draws the envelope of so many working wheels, its vertices named as in the paper."""

    def draw() -> object:
        return plot(envelope(_axes(working)), names=listed_vertices(working, *(FOUR if working < 5 else SIX)))

    return _figure(f"{words} of the momentum envelope of {WORDS[working]}: figure {figure}.", draw)


FIGURES: Figures = {
    "wheels-four-axes": _figure(
        "The axes of four wheels along the side edges of a four-sided pyramid: figure 1.", lambda: plot_axes(_axes(4))
    ),
    "wheels-four-envelope": _drawing(plot_envelope, "View", 4, 2),
    "wheels-four-projections": _drawing(plot_projections, "Projections", 4, 3),
    "wheels-four-failures": _figure(
        "The momentum envelope of four wheels after the failure of each of them, inside that of all four.",
        lambda: plot_failures(_axes(4)),
    ),
    "wheels-three-envelope": _drawing(plot_envelope, "View", 3, 4),
    "wheels-three-projections": _drawing(plot_projections, "Projections", 3, 5),
    "wheels-six-axes": _figure(
        "The axes of six wheels along the side edges of a regular six-sided pyramid: figure 6.",
        lambda: plot_axes(_axes(6)),
    ),
    "wheels-six-envelope": _drawing(plot_envelope, "View", 6, 7),
    "wheels-six-projections": _drawing(plot_projections, "Projections", 6, 8),
    "wheels-six-projection": _drawing(plot_projection, "Projection on OXY", 6, 9),
    "wheels-six-failures": _figure(
        "The momentum envelope of six wheels after the failure of each of them, inside that of all six.",
        lambda: plot_failures(_axes(6)),
    ),
    "wheels-five-envelope": _drawing(plot_envelope, "View", 5, 10),
    "wheels-five-projections": _drawing(plot_projections, "Projections", 5, 11),
    "wheels-five-projection": _drawing(plot_projection, "Projection on OXY", 5, 12),
}
