"""A generated kernel on dask arrays and DataArrays, and what its declaration says of arguments and results."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Mapping
from functools import partial, wraps
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from symcheck import kernels
from symcheck.kernels.specification import Argument, Output, specification
from symcheck.numeric.chunked.arrays import Function, Leaf, Results, Signature, apply, is_chunked

FLOAT = np.dtype(np.float32)


class Declaration(NamedTuple):
    """Meaning and unit of each argument and each result, as attributes of arrays."""

    arguments: Mapping[str, Mapping[str, str]]
    results: Mapping[str, Mapping[str, str]]


def declaration(kernel: Function) -> Declaration:
    """What the specification of a kernel says, as attributes of arrays.

    >>> declaration(kernels.find("ignatov2005", "volume_of_three_wheels")).results["volume"]["units"]
    'h_max^3'
    """
    declared = specification(kernel)
    return Declaration(_attributes(declared.arguments), _attributes(declared.outputs))


def kernel(paper: str, name: str) -> Function:
    """The kernel of this name for NumPy arrays and numbers, dask arrays and DataArrays alike.

    Parameters
    ----------
    paper
        Key of the paper, as "ignatov2005".
    name
        Name of the kernel.

    Returns
    -------
    callable
        The kernel; DataArrays get the units of its declaration.

    Notes
    -----
    Chunks of whatever size are computed as many points are, so that results are those of plain calls with arrays of
    more than 200 elements, to the last bit.

    Examples
    --------
    >>> volume = kernel("ignatov2005", "volume_of_three_wheels")
    >>> round(volume(0.5, 1.0), 6)
    2.93465
    """
    function = kernels.find(paper, name)
    declared = declaration(function)
    signature = Signature(((),) * len(declared.arguments), ((),) * len(declared.results))

    @wraps(function)
    def dispatching(*args: Leaf, **kwargs: Leaf) -> object:
        if not is_chunked(*args, *kwargs.values()):
            return function(*args, **kwargs)
        arguments = inspect.signature(function).bind(*args, **kwargs).arguments
        dtype = _dtype(arguments.values())
        results = Results([*declared.results], [dtype] * len(declared.results), [*declared.results.values()], _together)
        return apply(partial(by_blocks, paper, name), arguments, signature, results)

    return dispatching


def by_blocks(paper: str, name: str, /, **arguments: ArrayLike) -> Any:
    """The kernel of this name on arrays or numbers that broadcast: the same bits for few points and for many.

    >>> by_blocks("ignatov2005", "volume_of_four_wheels", a=np.full((2, 1), 0.5), b=np.full(3, 1.0)).shape
    (2, 3)
    """
    function = kernels.find(paper, name)
    return function.ways.of_anything([arguments[x.name] for x in specification(function).arguments], many=True)


def _together(*results: object) -> object:
    return results if len(results) > 1 else results[0]


def _dtype(arguments: Iterable[Leaf]) -> np.dtype[np.generic]:
    common = np.result_type(*(getattr(x, "dtype", x) for x in arguments))
    return common if common == FLOAT else np.dtype(np.float64)


def _attributes(listed: Iterable[Argument | Output]) -> dict[str, dict[str, str]]:
    return {x.name: {"long_name": x.meaning, "units": x.unit.removeprefix("units of ")} for x in listed}
