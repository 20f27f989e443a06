"""What an argument may be: every public function of the numeric layer says by these what does not fit.

An error names the argument, the value and the condition, with the equation it comes from; no value that is not finite
comes in, so that none comes out unseen.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def real(name: str, value: ArrayLike, shape: tuple[int | None, ...] = ()) -> Array:
    """The value as an array of doubles whose last axes have this shape, None for any length.

    ValueError if it is not an array of finite real numbers, or its last axes are others.
    """
    array = doubles(name, value, shape)
    require(np.isfinite(array), name, array, "be finite")
    return array


def doubles(name: str, value: ArrayLike, shape: tuple[int | None, ...] = ()) -> Array:
    """`real` for a caller whose own condition no NaN and no infinity satisfies: these pass here."""
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "iuf":
            raise TypeError
        array = array.astype(np.float64, copy=False)
    except (TypeError, ValueError):
        raise ValueError(f"{name} = {shortened(value)} is no array of real numbers") from None
    last = array.shape[array.ndim - len(shape) :]
    if last != shape and (len(last) < len(shape) or any(map(_differs, shape, last))):
        words = ", ".join("n" if asked is None else str(asked) for asked in shape)
        raise ValueError(f"{name} has shape {array.shape}; its last axes must be ({words})")
    return array


def _differs(asked: int | None, found: int) -> bool:
    return asked is not None and asked != found


def require(holds: Any, name: str, value: Any, condition: str, source: str = "") -> None:
    """ValueError naming the first value for which `holds` is not true: "I = ... must ... (source)"."""
    if np.count_nonzero(holds) == holds.size if isinstance(holds, np.ndarray) else holds:  # all() takes twice as long
        return
    holds = np.asarray(holds)
    value = np.asarray(value)
    place = tuple(int(k) for k in np.argwhere(~holds)[0])
    shown = value[place] if value.ndim >= len(place) and value.shape[: len(place)] == holds.shape else value
    where = f"{name}[{', '.join(map(str, place))}]" if place and value.ndim else name
    raise ValueError(f"{where} = {shortened(shown)} must {condition}{f' ({source})' if source else ''}")


def shortened(value: Any) -> str:
    """A value on one line."""
    value = value.item() if isinstance(value, np.generic) else value
    text = np.array2string(value, precision=6, threshold=12) if isinstance(value, np.ndarray) else repr(value)
    text = " ".join(text.split())
    return text if len(text) <= 100 else f"{text[:97]}..."


def engine_module(engine: str, module: str) -> Any:
    """The module of an engine that needs a library of the same name; ImportError says if that is missing."""
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        if error.name != engine:
            raise
        raise ImportError(
            f"engine={engine!r} needs {engine}: pip install {engine}, or leave engine='numpy'", name=engine
        ) from error
