"""What a reader turns where a kernel runs and ipywidgets is installed; everywhere else it is a cell as all others.

The notebooks are committed without widgets, and what executes them drops the widgets' views: what is compared is what
the cell shows for the values written in it.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from symcheck.core.verdicts import SymcheckError
from symcheck.views.notebook.output import Output, Prose
from symcheck.views.notebook.pictures import drawing
from symcheck.views.notebook.results import fields, numbers

VIEW = "application/vnd.jupyter.widget-view+json"
STEPS = 60  # of a slider
Range = tuple[float, float, float]


@dataclass(frozen=True, repr=False)
class Live(Output):
    """An output, with what makes a widget of it where one can be shown."""

    widget: Callable[[], Any]

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        plain = super()._repr_mimebundle_(include, exclude)
        view = self.widget()._repr_mimebundle_().get(VIEW) if _in_kernel() else None
        return {**plain, VIEW: view} if view else plain


def sliders(
    caption: str, *steps: Callable[..., Any], degrees: Mapping[str, Range] | None = None, **values: Range
) -> Output:
    """What functions of the numeric layer give, one after the other; where a kernel runs, with a slider for each value.

    Parameters
    ----------
    caption
        What is shown.
    steps
        The first takes the values by name, each further one what the one before returned. The last one draws, or
        returns a named tuple, numbers or an array.
    degrees
        Angles by name, each as (lowest, shown first, highest) in degrees; the first function is given radians.
    values
        Other values, each as (lowest, shown first, highest).

    Raises
    ------
    SymcheckError
        For a value that is not between the two others.

    Examples
    --------
    >>> from symcheck.numeric import wheels
    >>> sliders("axes of four wheels", wheels.four_wheels, degrees={"a": (20, 60, 80), "b": (10, 45, 80)}).parts[0].head
    ('', 'value')
    """
    angles = degrees or {}
    ranges = {**angles, **values}
    for name, (low, first, high) in ranges.items():
        if not low <= first <= high:
            raise SymcheckError(f"{name} is to be {first} first, which is not between {low} and {high}")

    def shown(**at: float) -> Output:
        result: Any = steps[0](**{name: math.radians(x) if name in angles else x for name, x in at.items()})
        for step in steps[1:]:
            result = step(result)
        return _output(result, caption)

    def widget() -> Any:
        import ipywidgets

        controls = {
            name: ipywidgets.FloatSlider(
                value=first,
                min=low,
                max=high,
                step=(high - low) / STEPS,
                description=f"{name}, degrees" if name in angles else name,
                continuous_update=False,
            )
            for name, (low, first, high) in ranges.items()
        }
        return tried(shown, controls)

    return Live(shown(**{name: first for name, (_, first, _) in ranges.items()}).parts, widget)


def tried(shows: Callable[..., Output], controls: Mapping[str, Any], button: str = "") -> Any:
    """A widget that shows an output anew for what its controls say: at once, or when the button is pressed."""
    import ipywidgets
    from IPython.display import display

    def show(**values: Any) -> None:
        try:
            found = shows(**values)
        except SymcheckError as error:
            found = Output((Prose("", str(error)),))
        display(Output(found.parts))

    pressed = {"manual": True, "manual_name": button} if button else {}
    return ipywidgets.interactive(show, pressed, **controls)


def _output(result: Any, caption: str) -> Output:
    if hasattr(result, "_fields"):
        return fields(result)
    drawn = hasattr(np.asarray(result, dtype=object).flat[0], "figure")  # axes, or an array of them
    return drawing(result, caption) if drawn else numbers(**{caption: result})


def _in_kernel() -> bool:
    """Whether a kernel runs here that can show widgets."""
    interactive = sys.modules.get("IPython")
    if interactive is None or getattr(interactive.get_ipython(), "kernel", None) is None:
        return False
    try:
        import ipywidgets  # noqa: F401
    except ImportError:
        return False
    return True
