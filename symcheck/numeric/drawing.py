"""Figures without a display. Matplotlib is imported only when one is drawn."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal, TypedDict

import numpy as np
from numpy.typing import NDArray

from symcheck.core.extras import installing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Panels = NDArray[Any]  # of Axes; NumPy has no other type for an array of objects
Figures = dict[str, Callable[[], object]]  # each draws a Figure, Axes or several


class Line(TypedDict):
    """How a line is drawn."""

    color: str
    linewidth: float
    linestyle: str


def figure_of(axes: Any) -> Figure:
    """The figure that some Axes, or an array of them, belong to."""
    figure: Figure = np.ravel(np.array(axes, dtype=object))[0].get_figure(root=True)
    return figure


def new_figure(
    size: tuple[float, float] | None = None, layout: Literal["constrained"] | None = "constrained"
) -> Figure:
    """A figure that is on no screen and that no window keeps; ModuleNotFoundError says what to install for it."""
    try:
        from matplotlib.figure import Figure
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(f"figures need {error.name}; run `{installing('plots')}`", name=error.name) from error

    return Figure(figsize=size, layout=layout)
