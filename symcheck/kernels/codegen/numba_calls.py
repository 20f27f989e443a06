"""How a kernel for Numba is called: on anything that broadcasts, in one thread or several. Written into its text.

Compiled code takes contiguous arrays of one type. Other arrays are copied by pieces that
stay in a cache.

Decisions. The loop is compiled as it stands: @vectorize has one output, and the loop that
@guvectorize makes has strides and is not vectorised. Threads are Python's, since Numba's parallel loops take seconds to
compile, and its thread layer without dependencies ends a process that calls it from two threads.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from symcheck.kernels.calling import fitting

DOUBLE = np.dtype(np.float64)
PIECE = 4096  # points that are copied at once
SHARE = 32768  # points that are worth a thread


def evaluate(points: Any, order: Sequence[int], inputs: Sequence[Any], out: Any, threads: int) -> Any:
    """One call of a kernel: an array of the broadcast shape, or a tuple of them; numbers give numbers.

    `order` tells for each output which result of `points` it is; those that are the same are one array.
    """
    if not isinstance(threads, int) or threads < 1:
        raise ValueError(f"threads = {threads!r} must be a positive whole number")
    direct = _as_compiled(inputs)
    if direct and threads == 1:  # what is asked otherwise takes longer than many a kernel
        if out is None:
            results = [np.empty(inputs[0].shape) for _ in range(max(order) + 1)]
            points(*[x if x.ndim == 1 else x.reshape(-1) for x in (*inputs, *results)])
            return results[0] if len(order) == 1 else tuple([results[k] for k in order])
        given = fitting(out, len(order), inputs[0].shape, DOUBLE)
        if len({*order}) == len(order) and all(y.flags.carray for y in given):
            points(*[x if x.ndim == 1 else x.reshape(-1) for x in (*_apart(inputs, given), *given)])
            return given[0] if len(order) == 1 else tuple(given)
    if direct:
        dtype, shape, arrays = DOUBLE, inputs[0].shape, list(inputs)
    else:
        dtype = np.result_type(*inputs)
        dtype = dtype if dtype == np.float32 else DOUBLE
        arrays = [x if x.ndim else x.astype(dtype, casting="same_kind") for x in map(np.asarray, inputs)]
        shape = np.broadcast_shapes(*(x.shape for x in arrays))
    if out is None:
        results = [np.empty(shape, dtype) for _ in range(max(order) + 1)]
        given = [results[k] for k in order]
    else:  # an output must not overwrite what is read later
        given = fitting(out, len(order), shape, dtype)
        arrays = _apart(arrays, given)
        results = [given[order.index(k)] for k in range(max(order) + 1)]
    _shared(points, arrays, results, threads)
    for each, k in zip(given, order, strict=True):
        if each is not results[k]:
            np.copyto(each, results[k])
    values = given if shape or out is not None else [x[()] for x in given]
    return values[0] if len(order) == 1 else tuple(values)


def _apart(arrays: Sequence[Any], given: Sequence[Any]) -> list[Any]:
    """The arrays, copied where one that is given lies in their memory; those that own theirs need no longer look."""
    found = list(arrays)
    for y in given:
        own = y.flags.owndata
        found = [
            x.copy() if x is y or (not (own and x.flags.owndata) and np.may_share_memory(x, y)) else x for x in found
        ]
    return found


def _as_compiled(arrays: Sequence[Any]) -> bool:
    """Whether these are arrays as the compiled loop takes them, of doubles."""
    for x in arrays:
        if type(x) is not np.ndarray or x.dtype is not DOUBLE or not x.flags.carray or x.shape != arrays[0].shape:
            return False
    return bool(arrays[0].ndim)


def _shared(points: Any, arrays: list[Any], results: list[Any], threads: int) -> None:
    shape = results[0].shape
    count = min(threads, results[0].size // SHARE)
    if count < 2:
        _run(points, arrays, results)
        return
    axis = shape.index(max(shape))
    full = [x if x.shape == shape else np.broadcast_to(x, shape) for x in (*arrays, *results)]
    parts = zip(*(np.array_split(x, count, axis) for x in full), strict=True)
    with ThreadPoolExecutor(count) as pool:
        list(pool.map(lambda part: _run(points, part[: len(arrays)], part[len(arrays) :]), parts))


def _run(points: Any, arrays: Sequence[Any], results: Sequence[Any]) -> None:
    shape, dtype = results[0].shape, results[0].dtype
    if all(x.shape == shape and x.dtype == dtype and x.flags.carray for x in (*arrays, *results)):
        points(*[x if x.ndim == 1 else x.reshape(-1) for x in (*arrays, *results)])
        return
    chunks: Any = np.nditer  # its types know neither `with` nor lists of modes
    modes = [["readonly"]] * len(arrays) + [["writeonly"]] * len(results)
    flags = ["external_loop", "buffered", "zerosize_ok", "delay_bufalloc"]
    rows = np.empty((len(modes), PIECE), dtype)
    with chunks(
        [*arrays, *results], flags, modes, [dtype] * len(modes), casting="same_kind", buffersize=PIECE
    ) as iterator:
        iterator.reset()
        for chunk in iterator:
            pieces = [row[: chunk[0].size] for row in rows]
            for piece, x in zip(pieces[: len(arrays)], chunk, strict=False):
                piece[...] = x
            points(*pieces)
            for piece, y in zip(pieces[len(arrays) :], chunk[len(arrays) :], strict=True):
                y[...] = piece
