"""Pictures in space that can be turned by hand, of axes and envelopes. Plotly is imported only when one is made."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from symcheck.core.extras import installing
from symcheck.numeric.domain import Array, require
from symcheck.numeric.wheels.polytope import Envelope
from symcheck.numeric.wheels.sets import wheels_of

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

COLOURS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b")


def interactive_envelope(
    *envelopes: Envelope, names: Mapping[str, ArrayLike] | None = None, unit: str = "N m s"
) -> Figure:
    """One or more envelopes in one picture that can be turned: of momenta, or what failures leave of them.

    Parameters
    ----------
    *envelopes
        The envelopes, the outer ones first.
    names
        Points, shape (3,), by name, to be marked.
    unit
        Unit of the axes; "N m" for torque envelopes.

    Returns
    -------
    Figure
        A figure of Plotly: `figure.show()`, or `figure.write_html(file)`.

    Raises
    ------
    ValueError
        If there is no envelope.
    ModuleNotFoundError
        If Plotly is not installed; the message says what to install.

    Examples
    --------
    >>> from symcheck.numeric.wheels import envelope
    >>> figure = interactive_envelope(envelope(np.eye(3)))  # doctest: +SKIP
    """
    require(len(envelopes) > 0, "envelopes", envelopes, "be one at least")
    plotly = _plotly()
    traces: list[Any] = []
    for number, each in enumerate(envelopes):
        colour, name = COLOURS[number % len(COLOURS)], f"envelope {number + 1}"
        triangles = _triangles(each)
        if len(triangles):
            corners = dict(zip("ijk", triangles.T, strict=True))
            traces.append(
                plotly.Mesh3d(
                    **_places(each.vertices), **corners, color=colour, opacity=0.3, name=name, hoverinfo="skip"
                )
            )
        traces.append(plotly.Scatter3d(**_places(_with_gaps(each)), mode="lines", line={"color": colour}, name=name))
    if names:
        points = np.array([np.asarray(place, dtype=float) for place in names.values()])
        traces.append(plotly.Scatter3d(**_places(points), mode="markers+text", text=[*names], name="points"))
    return _figure(plotly, traces, unit)


def interactive_axes(axes: ArrayLike) -> Figure:
    """The axes of wheels as unit vectors from one point, in a picture that can be turned.

    Parameters
    ----------
    axes
        Unit vectors; shape (n, 3).

    Returns
    -------
    Figure
        A figure of Plotly.

    Raises
    ------
    ValueError
        If the axes are not unit vectors of one set of wheels.
    ModuleNotFoundError
        If Plotly is not installed; the message says what to install.

    Examples
    --------
    >>> figure = interactive_axes(np.eye(3))  # doctest: +SKIP
    """
    units = wheels_of(axes).axes
    require(units.ndim == 2, "axes", units.shape, "be one set of wheels, of the shape (n, 3)", "(2.1)")
    plotly = _plotly()
    traces = [
        plotly.Scatter3d(
            **_places(np.array([[0, 0, 0], unit])), mode="lines+text", text=["", f"e{k}"], name=f"wheel {k}"
        )
        for k, unit in enumerate(units, 1)
    ]
    return _figure(plotly, traces, "1")


def _plotly() -> Any:
    try:
        from plotly import graph_objects
    except ModuleNotFoundError as error:
        command = installing("interactive")
        raise ModuleNotFoundError(f"interactive figures need {error.name}; run `{command}`", name=error.name) from error
    return graph_objects


def _triangles(envelope: Envelope) -> Array:
    """All faces cut into triangles from their first vertices, as numbers of vertices; shape (t, 3)."""
    if envelope.dimension < 2:
        return np.empty((0, 3), int)
    corners, begins = envelope.faces
    faces = [corners[first:last] for first, last in pairwise(begins)]
    return np.array([(face[0], *pair) for face in faces for pair in pairwise(face[1:])])


def _with_gaps(envelope: Envelope) -> Array:
    """The ends of all edges in a row, with NaN between two edges."""
    ends = envelope.vertices[envelope.edges]
    return np.concatenate([ends, np.full((len(ends), 1, 3), np.nan)], axis=1).reshape(-1, 3)


def _places(points: Array) -> dict[str, Array]:
    return dict(zip("xyz", points.T, strict=True))


def _figure(plotly: Any, traces: list[Any], unit: str) -> Figure:
    scene = {f"{k}axis": {"title": {"text": f"{k.upper()}, {unit}"}} for k in "xyz"} | {"aspectmode": "data"}
    figure: Figure = plotly.Figure(traces, layout={"scene": scene, "margin": dict.fromkeys("lrbt", 0)})
    return figure
