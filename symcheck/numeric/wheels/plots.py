"""Figures of arrays of wheels: their axes, their envelopes in space and in projection, and what failures leave.

What a solid body hides is dashed. Matplotlib is imported only when a figure is drawn.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.numeric.domain import Array, one_of, require
from symcheck.numeric.drawing import Line, Panels, new_figure
from symcheck.numeric.wheels import polytope
from symcheck.numeric.wheels.polytope import Envelope
from symcheck.numeric.wheels.sets import wheels_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from mpl_toolkits.mplot3d import Axes3D

SIDE = 1e-9  # of a unit normal: a face that is seen edgewise is not seen
PLANES = {"XY": (0, 1), "XZ": (0, 2), "YZ": (1, 2)}
INDEX, SUBSCRIPT = r"_(\d+)", r"_{\1}"  # TeX lowers all digits of an index only if they stand in braces
Names = Mapping[str, ArrayLike]
SOLID = Line(color="black", linewidth=1.0, linestyle="-")
DASHED = Line(color="0.6", linewidth=0.7, linestyle="--")


def plot_axes(axes: ArrayLike, ax: Axes3D | None = None) -> Axes3D:
    """Draw the axes of wheels as unit vectors e_1, ..., e_n from one point: figures 1 and 6.

    Parameters
    ----------
    axes
        Unit vectors; shape (n, 3).
    ax
        Axes to draw in; by default those of a new figure.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If the axes are not unit vectors.

    Notes
    -----
    Source: figures 1 and 6.

    Examples
    --------
    >>> from symcheck.numeric.wheels import six_wheels
    >>> plot_axes(six_wheels(1.0)).get_zlabel()
    'Z'
    """
    units = wheels_of(axes).axes
    drawn = _in_space(ax)
    zero = np.zeros(len(units))
    drawn.quiver(zero, zero, zero, *units.T, color="tab:blue", arrow_length_ratio=0.1)
    for number, unit in enumerate(units, 1):
        drawn.text(*(1.15 * unit), f"$e_{{{number}}}$", ha="center", va="center")
    reach = 1.1 * max(1e-3, np.abs(units).max())
    drawn.locator_params(nbins=5)
    drawn.set(xlabel="X", ylabel="Y", zlabel="Z", **{f"{k}lim": (-reach, reach) for k in "xyz"}, aspect="equal")
    return drawn


def plot_envelope(
    envelope: Envelope, names: Names | None = None, ax: Axes3D | None = None, *, unit: str = "N m s"
) -> Axes3D:
    """Draw a momentum envelope in space, with the names of the vertices that are seen: figures 2, 4, 7, 10.

    Parameters
    ----------
    envelope
        The envelope.
    names
        Places, shape (3,), by name, as "V_1"; by default the vertices are numbered.
    ax
        Axes to draw in; by default those of a new figure.
    unit
        Unit of the axes; "N m" for a torque envelope.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If a name stands for no vertex.

    Notes
    -----
    Source: figures 2, 4, 7, 10.

    Examples
    --------
    >>> from symcheck.numeric.wheels import envelope, four_wheels
    >>> plot_envelope(envelope(four_wheels(1.0, 0.5))).get_xlabel()
    '$H_x$, N m s'
    """
    drawn = _in_space(ax)
    view = _towards_the_viewer(drawn)
    seen, hidden = _edges(envelope, view)
    for ends, style in ((hidden, DASHED), (seen, SOLID)):
        for line in ends:
            drawn.plot(*line.T, **style)
    if envelope.dimension > 1:
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        shown = [envelope.face(int(k)) for k in np.flatnonzero(_in_front(envelope, view))]
        drawn.add_collection3d(Poly3DCollection(shown, facecolor="tab:blue", alpha=0.15))
    for place, name in _labels(envelope, view, names):
        drawn.text(*place, name, fontsize=11)
    drawn.locator_params(nbins=5)
    drawn.set(**{f"{k}label": _label(k, unit) for k in "xyz"}, aspect="equal")
    return drawn


def plot_projection(
    envelope: Envelope,
    plane: str = "XY",
    names: Names | None = None,
    ax: Axes | None = None,
    *,
    unit: str = "N m s",
) -> Axes:
    """Draw the projection of a momentum envelope on a coordinate plane, with the names of what is seen: figures 9, 12.

    Parameters
    ----------
    envelope
        The envelope.
    plane
        Plane "XY", "XZ" or "YZ": across, then up; the viewer is where these turn counterclockwise.
    names
        Places, shape (3,), by name; an empty mapping leaves the names out.
    ax
        Axes to draw in; by default those of a new figure.
    unit
        Unit of the axes; "N m" for a torque envelope.

    Returns
    -------
    Axes
        The Axes.

    Raises
    ------
    ValueError
        If the plane is another, or a name stands for no vertex.

    Notes
    -----
    Source: figures 9, 12.

    Examples
    --------
    >>> from symcheck.numeric.wheels import envelope, four_wheels
    >>> plot_projection(envelope(four_wheels(1.0, 0.5)), "YZ").get_xlabel()
    '$H_y$, N m s'
    """
    across, up = _directions(plane)
    view = np.cross(np.eye(3)[across], np.eye(3)[up])
    drawn: Axes = _figure(1)[0] if ax is None else ax
    seen, hidden = _edges(envelope, view)
    for ends, style in ((hidden, DASHED), (seen, SOLID)):
        for line in ends:
            drawn.plot(line[:, across], line[:, up], **style)
    for place, name in _merged(_labels(envelope, view, names), across, up):
        drawn.annotate(name, place, xytext=(3, 3), textcoords="offset points", fontsize=10)
    drawn.margins(0.12)
    drawn.set(xlabel=_label("xyz"[across], unit), ylabel=_label("xyz"[up], unit), aspect="equal")
    return drawn


def plot_projections(
    envelope: Envelope, names: Names | None = None, axes: Panels | None = None, *, unit: str = "N m s"
) -> Panels:
    """Draw the three projections of a momentum envelope on the coordinate planes: figures 3, 5, 8, 11.

    Parameters
    ----------
    envelope, names
        As for `plot_projection`.
    axes
        Three Axes to draw in; by default those of a new figure.
    unit
        Unit of the axes; "N m" for a torque envelope.

    Returns
    -------
    ndarray
        Three Axes.

    Raises
    ------
    ValueError
        If a name stands for no vertex.

    Examples
    --------
    >>> from symcheck.numeric.wheels import envelope
    >>> [ax.get_ylabel() for ax in plot_projections(envelope(np.eye(3)))]
    ['$H_y$, N m s', '$H_z$, N m s', '$H_z$, N m s']
    """
    panels = _figure(3) if axes is None else np.asarray(axes)
    for plane, ax in zip(PLANES, panels.flat, strict=True):
        plot_projection(envelope, plane, names, ax, unit=unit)
    return panels


def plot_failures(axes: ArrayLike, limits: ArrayLike = 1.0, plane: str = "XY") -> Panels:
    """Draw what is left of an envelope after the failure of each wheel, in projection, inside the whole envelope.

    Parameters
    ----------
    axes, limits
        As for `envelope`.
    plane
        Plane, as in `plot_projection`.

    Returns
    -------
    ndarray
        One Axes for each wheel.

    Raises
    ------
    ValueError
        As `envelope` does.

    Notes
    -----
    Source: sections 2.2, 3.2.

    Examples
    --------
    >>> plot_failures(np.eye(3))[2].get_title()
    'without wheel 3'
    """
    whole = polytope.envelope(axes, limits)
    units, working, _ = whole.wheels
    panels, (across, up) = _figure(len(units)), _directions(plane)
    for number, ax in enumerate(panels.flat):
        for line in whole.vertices[whole.edges]:
            ax.plot(line[:, across], line[:, up], color="0.8", linewidth=0.6)
        left = polytope.envelope(units, np.where(np.arange(len(units)) == number, 0, working))
        plot_projection(left, plane, {}, ax).set_title(f"without wheel {number + 1}")
    return panels


def _label(axis: str, unit: str) -> str:
    """H for momenta, M for torques and whatever else."""
    return f"${'H' if unit == 'N m s' else 'M'}_{axis}$, {unit}"


def _directions(plane: str) -> tuple[int, int]:
    one_of("plane", plane, PLANES)
    return PLANES[plane]


def _in_front(envelope: Envelope, view: Array) -> NDArray[np.bool_]:
    """Whether each face is seen from that direction; all of something flat is."""
    if envelope.dimension < 3:
        return np.ones(envelope.counts[2], bool)
    towards = envelope.half_spaces.normals @ view
    return np.concatenate([towards, -towards]) > SIDE


def _corners_in_front(envelope: Envelope, view: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The numbers of the vertices of the faces that are seen, and their next ones."""
    corners, begins = envelope.faces
    after = np.append(corners[1:], 0)
    after[begins[1:] - 1] = corners[begins[:-1]]
    seen = np.repeat(_in_front(envelope, view), np.diff(begins))
    return corners[seen], after[seen]


def _edges(envelope: Envelope, view: Array) -> tuple[Array, Array]:
    """The ends of the edges that are seen and of those that are not, shape (edges, 2, 3)."""
    places = envelope.vertices[envelope.edges]
    if envelope.dimension < 3:
        return places, places[:0]
    one, other = _corners_in_front(envelope, view)
    count = len(envelope.vertices)
    seen = np.isin(envelope.edges @ [count, 1], np.minimum(one, other) * count + np.maximum(one, other))
    return places[seen], places[~seen]


def _labels(envelope: Envelope, view: Array, names: Names | None) -> list[tuple[Array, str]]:
    """The vertices that are seen, with their names."""
    if names is None:
        names = {f"{number}": place for number, place in enumerate(envelope.vertices)}
    seen = np.arange(len(envelope.vertices)) if envelope.dimension < 3 else _corners_in_front(envelope, view)[0]
    size = 1 + np.abs(envelope.vertices).max()
    labels = []
    for name, place in names.items():
        distance = np.linalg.norm(envelope.vertices - np.asarray(place), axis=1)
        require(distance.min() <= SIDE * size, f"names[{name!r}]", place, "be a vertex of the envelope")
        if distance.argmin() in seen:
            labels.append((envelope.vertices[distance.argmin()], f"${re.sub(INDEX, SUBSCRIPT, name)}$"))
    return labels


def _merged(labels: list[tuple[Array, str]], across: int, up: int) -> list[tuple[tuple[float, float], str]]:
    """One label for all vertices at one place of the projection."""
    merged: dict[tuple[float, float], list[str]] = {}
    for place, name in labels:
        merged.setdefault((round(float(place[across]), 9), round(float(place[up]), 9)), []).append(name)
    return [(place, ", ".join(names)) for place, names in merged.items()]


def _towards_the_viewer(ax: Axes3D) -> Array:
    height, azimuth = np.radians(ax.elev), np.radians(ax.azim)
    return np.array([np.cos(height) * np.cos(azimuth), np.cos(height) * np.sin(azimuth), np.sin(height)])


def _in_space(ax: Axes3D | None) -> Axes3D:
    return new_figure((7, 6), layout=None).add_subplot(projection="3d", elev=22, azim=28) if ax is None else ax


def _figure(count: int) -> Panels:
    columns = min(count, 3)
    rows = -(-count // columns)
    panels = new_figure((4.5 * columns, 4.5 * rows)).subplots(rows, columns, squeeze=False)
    for spare in panels.flat[count:]:
        spare.remove()
    return panels.flat[:count]
