"""All figures of the numeric layer, without a registry: a module that has some lists them in `FIGURES`,

    FIGURES = {"name": function}

where the function takes nothing, says in the first line of its docstring what is drawn, and returns a Figure, Axes or
an array of Axes.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Callable
from difflib import get_close_matches
from importlib import import_module
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

from symcheck import numeric
from symcheck.core.files import put
from symcheck.numeric.drawing import figure_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

UNDATED: dict[str, dict[str, None]] = {".png": {}, ".pdf": {"CreationDate": None}, ".svg": {"Date": None}}


def figures() -> dict[str, Callable[[], object]]:
    """All figures by name.

    Returns
    -------
    dict
        Functions without parameters that draw a figure, in the order of their names.

    Raises
    ------
    ValueError
        If two modules give one name to different figures.

    Examples
    --------
    >>> [name for name in figures() if name.startswith("liquid")]
    ['liquid-frequencies', 'liquid-stability-map', 'liquid-stability-map-of-two-modes']
    """
    declared: dict[str, tuple[str, Callable[[], object]]] = {}
    for module in pkgutil.walk_packages(numeric.__path__, f"{numeric.__name__}."):
        for name, function in _declared(module.name).items():
            owner, known = declared.setdefault(name, (module.name, function))
            if known is not function:
                raise ValueError(f"{owner} and {module.name} both have a figure {name!r}; rename one of them")
    return {name: declared[name][1] for name in sorted(declared)}


def summary(name: str) -> str:
    """What the figure of that name shows, in one line.

    Parameters
    ----------
    name
        Name of a figure, one of `figures`.

    Returns
    -------
    str
        The first line of the docstring of the function that draws it.

    Raises
    ------
    ValueError
        If there is no such figure; the message suggests the nearest name.

    Examples
    --------
    >>> summary("liquid-frequencies")
    'Frequencies and growth rate of a body with two modes of its liquid, against C - A.'
    """
    return (_function(name).__doc__ or name).strip().splitlines()[0]


def figure(name: str) -> Figure:
    """The figure of that name, drawn anew.

    Parameters
    ----------
    name
        Name of a figure, one of `figures`.

    Returns
    -------
    Figure
        Matplotlib's figure.

    Raises
    ------
    ValueError
        If there is no such figure; the message suggests the nearest name.

    Examples
    --------
    >>> len(figure("liquid-frequencies").axes)
    2
    """
    return figure_of(_function(name)())


def draw(name: str, output: Path | str) -> Path:
    """Write the figure of that name to a .png, .pdf or .svg file and return its path.

    The file appears when it is whole, in the place of one of that name; a pipe or a device gets the bytes, which are
    the same each time.

    Parameters
    ----------
    name
        Name of a figure, one of `figures`.
    output
        Path of a .png, .pdf or .svg file.

    Returns
    -------
    Path
        The path that was written.

    Raises
    ------
    ValueError
        If there is no such figure, or the file's ending is another.
    OSError
        If it cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     draw("liquid-frequencies", Path(folder) / "frequencies.svg").name
    'frequencies.svg'
    """
    path = Path(output)
    kind = path.suffix.lower()
    if kind not in UNDATED:
        raise ValueError(f"output = {path} must end in {', '.join(UNDATED)}, which says how the figure is written")
    drawn = figure(name)
    from matplotlib import rc_context

    written = BytesIO()
    with rc_context({"svg.hashsalt": name, "savefig.dpi": 150}):
        drawn.savefig(written, format=kind[1:], metadata=UNDATED[kind])
    put(path, written.getvalue())
    return path


def _declared(module: str) -> dict[str, Callable[[], object]]:
    """The figures of a module; none if it needs a library that is not installed, as optional ones may not be."""
    try:
        declared: dict[str, Callable[[], object]] = getattr(import_module(module), "FIGURES", {})
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] == __package__.partition(".")[0]:
            raise
        return {}
    return declared


def _function(name: str) -> Callable[[], object]:
    known = figures()
    if name not in known:
        near = get_close_matches(name, known, n=1, cutoff=0)
        raise ValueError(f"there is no figure {name!r}" + (f"; did you mean {near[0]}?" if near else ""))
    return known[name]
