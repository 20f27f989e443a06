"""The functions of the numeric layer on arrays in chunks: dask arrays and xarray's, lazily, and NumPy's at no cost.

A decorator names the axes of the last dimensions, as NumPy's generalised universal functions do; all other axes are
leading ones, which broadcast and may come in chunks. Neither dask nor xarray is imported unless an argument is theirs.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from functools import wraps
from itertools import chain
from typing import TypeVar, get_args, get_type_hints

import numpy as np

from symcheck.numeric.chunked.arrays import Axes, Function, Results, Signature, Size, apply, is_chunked

F = TypeVar("F", bound=Function)


def signature_of(text: str, **sizes: Size) -> Signature:
    """The signature that is written like NumPy's: "(k),(i,k)->(i)"; ValueError if it is not of this form.

    >>> signature_of("(),(n)->(mode)", mode=lambda size: size["n"] + 1).outputs
    (('mode',),)
    """
    if not re.fullmatch(r"\([\w,]*\)(,\([\w,]*\))*->\([\w,]*\)(,\([\w,]*\))*", text):
        raise ValueError(f"signature = {text!r} must be of the form (k),(i,k)->(i)")
    inputs, outputs = (re.findall(r"\((.*?)\)", side) for side in text.split("->"))
    return Signature(_axes(inputs), _axes(outputs), sizes)


def _axes(words: list[str]) -> tuple[Axes, ...]:
    return tuple(tuple(filter(None, word.split(","))) for word in words)


def gufunc(signature: str, **sizes: Size) -> Callable[[F], F]:
    """A decorator by which a function of NumPy arrays takes dask arrays and xarray.DataArrays as well.

    signature  last axes of the first arguments, and of the results; a NamedTuple counts as its fields
    sizes      lengths of axes that are in results only: numbers, or functions of the lengths of the others

    The function must broadcast over leading axes, and its annotations tell the types of its results. For dask arrays
    the result is lazy; for DataArrays it keeps coordinates and the attributes on which all arguments agree, but no
    units. Unnamed arrays with leading axes cannot be mixed with DataArrays: ValueError.

    >>> @gufunc("(i),(i)->()")
    ... def dot(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    ...     return (x * y).sum(axis=-1)
    >>> dot(np.eye(2), np.array([3.0, 4.0])).tolist()
    [3.0, 4.0]
    """
    declared = signature_of(signature, **sizes)
    unknown = {*chain(*declared.outputs)} - {*chain(*declared.inputs)} - {*sizes}
    if unknown:
        raise ValueError(f"signature = {signature!r} must have the lengths of {sorted(unknown)} as further arguments")

    def decorate(function: F) -> F:
        @wraps(function)
        def dispatching(*args: object, **kwargs: object) -> object:
            if not is_chunked(*args, *kwargs.values()):
                return function(*args, **kwargs)
            bound = inspect.signature(function).bind(*args, **kwargs)
            bound.apply_defaults()
            return apply(dispatching, bound.arguments, declared, results_of(function))

        dispatching.signature = declared  # type: ignore[attr-defined]
        return dispatching  # type: ignore[return-value]

    return decorate


def pointwise(signature: str) -> Callable[[F], F]:
    """A decorator that only declares the last axes: a sweep calls the function once for each set of parameters.

    An axis named `realization` is that of an ensemble: the function then takes `seed` and `first`, and gives the same
    whatever pieces it is asked for.

    >>> @pointwise("(i,j)->(i)")
    ... def largest_rows(matrix: np.ndarray) -> np.ndarray:
    ...     return matrix.max(axis=1)
    >>> largest_rows.signature.inputs
    (('i', 'j'),)
    """
    declared = signature_of(signature)

    def decorate(function: F) -> F:
        function.signature = declared  # type: ignore[attr-defined]
        return function

    return decorate


def results_of(function: Function) -> Results:
    """By the annotations: those of a NamedTuple's fields, or one array under the name of the function.

    >>> results_of(signature_of).names
    ['signature_of']
    """
    function = inspect.unwrap(function)
    kind = get_type_hints(function)["return"]
    if not hasattr(kind, "_fields"):
        return Results([function.__name__], [_dtype(kind)], [{}], lambda only: only)
    hints = get_type_hints(kind)
    return Results(kind._fields, [_dtype(hints[name]) for name in kind._fields], [{}] * len(kind._fields), kind)


def _dtype(annotation: object) -> np.dtype[np.generic]:
    """That of NDArray[...]; doubles where an annotation does not say."""
    of_array = get_args(annotation)[1:]
    return np.dtype(get_args(of_array[0])[0] if of_array else np.float64)
