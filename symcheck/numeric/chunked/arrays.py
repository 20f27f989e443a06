"""A function of NumPy arrays on those of dask and of xarray: what goes in and comes out, and the call on chunks."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import chain, islice
from math import prod
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from symcheck.kernels.runtime import FEW
from symcheck.numeric.domain import in_radians, rows_of

if TYPE_CHECKING:
    import dask.array as da
    import xarray

Leaf: TypeAlias = "ArrayLike | da.Array | xarray.DataArray"  # an argument, or a field of a NamedTuple among them
Function: TypeAlias = Callable[..., object]
Chunk: TypeAlias = NDArray[np.generic] | tuple[NDArray[np.generic], ...]
Call: TypeAlias = Callable[..., Chunk]
Size = int | Callable[[Mapping[str, int]], int]
Axes = tuple[str, ...]
CHUNKED = (("dask.array", "Array"), ("xarray", "DataArray"))  # an argument is one of these only if it is loaded
DESCRIBES_VALUES = ("units", "long_name", "standard_name")  # attributes that are not those of a function's value


@dataclass(frozen=True)
class Signature:
    """The last axes of each array that goes in and comes out.

    inputs, outputs  names of axes; equal names mean equal lengths
    sizes            lengths of the axes that are in outputs only: numbers, or functions of the lengths of the others
                     and of the arguments, by name
    """

    inputs: tuple[Axes, ...]
    outputs: tuple[Axes, ...]
    sizes: Mapping[str, Size] = field(default_factory=dict)


class Results(NamedTuple):
    """What comes out of a function: names and types, what each means where that is known, and the object of them."""

    names: Sequence[str]
    dtypes: Sequence[np.dtype[np.generic]]
    attributes: Sequence[Mapping[str, str]]
    together: Function


def is_chunked(*values: object) -> bool:
    """Whether a value, or a field of a NamedTuple among them, is a dask array or a DataArray.

    >>> is_chunked(1.0, np.ones(3))
    False
    """
    modules = sys.modules
    if "xarray" not in modules and "dask.array" not in modules:  # the common case, in a tenth of a microsecond
        return False
    kinds = tuple([getattr(modules[k], name) for k, name in CHUNKED if k in modules and hasattr(modules[k], name)])
    return any(isinstance(leaf, kinds) for leaf in _leaves(values))


def apply(function: Function, arguments: Mapping[str, object], signature: Signature, results: Results) -> object:
    """The function on chunks of its named arguments, lazily; it is what workers import and call.

    What it returns is what a decorated function does: a dask array or DataArray, or several of them together.

    >>> import dask.array as da
    >>> results = Results(["x"], [np.dtype(float)], [{}], lambda only: only)
    >>> apply(np.real, {"val": da.ones(4, chunks=2)}, Signature(((),), ((),)), results).compute().tolist()
    [1.0, 1.0, 1.0, 1.0]
    """
    axes = iter(signature.inputs)
    leaves = [(leaf, next(axes, ())) for leaf in _leaves(arguments.values())]
    is_array = [_is_array(leaf, core) for leaf, core in leaves]
    arrays = [leaf for leaf, given in zip(leaves, is_array, strict=True) if given]
    numbers = {name: value for name, value in arguments.items() if isinstance(value, int)}
    lengths = numbers | {axis: size for leaf, core in leaves for axis, size in _lengths(leaf, core)}
    own = {axis: size(lengths) if callable(size) else size for axis, size in signature.sizes.items()}
    missing = {*chain(*signature.outputs)} - {*chain(*(core for _, core in arrays))}
    sizes = {axis: own[axis] if axis in own else lengths[axis] for axis in missing}
    constants = [None if given else leaf for (leaf, _), given in zip(leaves, is_array, strict=True)]
    call: Call = partial(_call, function, dict(arguments), constants, is_array)
    if not any(chain(signature.inputs, signature.outputs)):
        call = partial(_as_of_many, call)
    xarray = sys.modules.get("xarray")
    named = xarray is not None and any(isinstance(leaf, xarray.DataArray) for leaf, _ in arrays)
    return results.together(*(_named if named else _unnamed)(call, signature, arrays, sizes, results))


def _leaves(values: Iterable[object]) -> Iterator[Leaf]:
    for value in values:
        yield from _fields(value) or (rows_of(value),)


def _fields(value: object) -> tuple[Leaf, ...]:
    """Those of a NamedTuple; a plain tuple is an array."""
    return value if isinstance(value, tuple) and hasattr(value, "_fields") else ()


def _is_array(leaf: Leaf, core: Axes) -> bool:
    """Whether it goes through the chunks: what has no leading axes stays as it is in all of them."""
    return is_chunked(leaf) or np.ndim(leaf) > len(core)


def _lengths(leaf: Leaf, core: Axes) -> Iterator[tuple[str, int]]:
    if core and np.ndim(leaf) >= len(core):
        yield from zip(core, np.shape(leaf)[-len(core) :], strict=True)


def _as_of_many(call: Call, *arrays: NDArray[np.generic]) -> Chunk:
    """The call point by point, of few points repeated: kernels compute few with other last bits than many."""
    shape = np.broadcast_shapes(*map(np.shape, arrays))
    if not 0 < prod(shape) <= FEW:
        return call(*arrays)
    again = FEW // prod(shape) + 1
    result = call(*(np.broadcast_to(array, (again, *shape)) for array in arrays))
    return tuple(array[0] for array in result) if isinstance(result, tuple) else result[0]


def _call(
    function: Function,
    arguments: Mapping[str, object],
    constants: Sequence[Leaf],
    is_array: Sequence[bool],
    *arrays: NDArray[np.generic],
) -> Chunk:
    """The function on one chunk of each array."""
    chunks = iter(arrays)
    leaves = iter([next(chunks) if given else constant for constant, given in zip(constants, is_array, strict=True)])
    rebuilt = {
        name: type(value)(*islice(leaves, len(_fields(value)))) if _fields(value) else next(leaves)
        for name, value in arguments.items()
    }
    result = function(**rebuilt)
    return tuple(map(np.asarray, result)) if isinstance(result, tuple) else np.asarray(result)


def _unnamed(
    call: Call, signature: Signature, arrays: Sequence[tuple[Leaf, Axes]], sizes: Mapping[str, int], results: Results
) -> Sequence[da.Array]:
    import dask.array as da

    inputs, outputs = (
        ",".join(f"({','.join(core)})" for core in cores) for cores in ([core for _, core in arrays], signature.outputs)
    )
    kinds = list(results.dtypes) if len(signature.outputs) > 1 else results.dtypes[0]
    values = [leaf for leaf, _ in arrays]
    lazy = da.apply_gufunc(
        call, f"{inputs}->{outputs}", *values, output_dtypes=kinds, output_sizes=sizes, allow_rechunk=True
    )
    return lazy if isinstance(lazy, tuple) else (lazy,)


def _named(
    call: Call, signature: Signature, arrays: Sequence[tuple[Leaf, Axes]], sizes: Mapping[str, int], results: Results
) -> Sequence[xarray.DataArray]:
    import xarray

    names: dict[str, str] = {}
    for leaf, core in arrays:
        if not isinstance(leaf, xarray.DataArray):
            raise ValueError(
                f"an array of shape {np.shape(leaf)} together with DataArrays must be one too: name its axes"
            )
        in_radians(leaf.name or "a DataArray", leaf)
        names = {axis: str(dim) for axis, dim in zip(core, _last(leaf, core), strict=True)} | names
    named = xarray.apply_ufunc(
        call,
        *(leaf for leaf, _ in arrays),
        input_core_dims=[_last(leaf, core) for leaf, core in arrays],
        output_core_dims=[[names.get(axis, axis) for axis in core] for core in signature.outputs],
        output_dtypes=list(results.dtypes),
        dask="parallelized",
        keep_attrs="drop_conflicts",
        dask_gufunc_kwargs={"output_sizes": {names.get(k, k): n for k, n in sizes.items()}, "allow_rechunk": True},
    )
    several = named if isinstance(named, tuple) else (named,)
    return [_described(*result) for result in zip(several, results.names, results.attributes, strict=True)]


def _last(array: xarray.DataArray, core: Axes) -> tuple[str, ...]:
    return tuple(array.dims[array.ndim - len(core) :])


def _described(array: xarray.DataArray, name: str, attributes: Mapping[str, str]) -> xarray.DataArray:
    kept = {key: value for key, value in array.attrs.items() if key not in DESCRIBES_VALUES}
    array.attrs = {**kept, **attributes}
    return array.rename(name)
