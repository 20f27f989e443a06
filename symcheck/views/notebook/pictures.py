"""Figures of the numeric layer as cells show them."""

from __future__ import annotations

from io import BytesIO
from typing import TYPE_CHECKING, Any

from symcheck.numeric import figures
from symcheck.numeric.drawing import figure_of
from symcheck.views.notebook.output import Output, Picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DPI = 90  # the width of a notebook's page, at the size the figures are drawn


def figure(name: str) -> Output:
    """A figure of the numeric layer by its name, as `symcheck plot` lists them."""
    return _picture(figures.figure(name), figures.summary(name))


def drawing(axes: Any, caption: str) -> Output:
    """What a function of the numeric layer has drawn: its axes, or an array of them."""
    return _picture(figure_of(axes), caption)


def _picture(drawn: Figure, caption: str) -> Output:
    data = BytesIO()
    drawn.savefig(data, format="png", dpi=DPI, bbox_inches="tight", metadata={"Software": None})
    return Output((Picture(data.getvalue(), caption),))
