"""How a generated kernel runs: on numbers and a handful of points by `math`, on small arrays at once, else by blocks.

A block stays in the caches of its processor, so that the values between two operations never travel to memory; the
registers that hold them are kept from call to call, one set for each thread. NumPy and the standard library alone.

Decision: one thread for a call. Reason: an operation on a block takes microseconds, and two threads that ask for the
interpreter's lock that often wait for one another longer than they compute (measured: 0 to 20 % gained, except where
sines prevail). Callers share large work among processes or threads by themselves; each thread has its own registers.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from itertools import combinations
from math import isfinite, prod
from types import FunctionType
from typing import Any

import numpy as np
from numpy import array

BLOCK = 8192  # elements: 64 kB of doubles
DOUBLE = np.dtype(np.float64)
LINE = 64  # bytes of a cache line: registers that begin on one are read twice as fast
SMALL = 12288  # elements: up to here a second block costs more time than it saves
FEW = 200  # elements: up to here sines and cosines cost no more than the tangents that replace them in a block

Block = Callable[..., Any]
_local = threading.local()


def evaluate(block: Block, registers: int, order: Sequence[int], inputs: Sequence[Any], out: Any) -> Any:
    """One call of a kernel on anything that broadcasts: one array of the broadcast shape, or a tuple of them.

    `order` tells for each output which of the block's results it is; those that are the same are one array.
    float32 if all arrays are, else float64. ValueError if `out` does not fit. NumPy's warnings are the caller's.
    """
    dtype = np.result_type(*inputs)
    if dtype == np.float32:
        block = _single(block)
    else:
        dtype = DOUBLE
    arrays = [x if type(x) is np.ndarray else np.asarray(x) for x in inputs]
    shapes = {x.shape for x in arrays} - {()} or {()}
    shape = np.broadcast_shapes(*shapes) if len(shapes) > 1 else shapes.pop()
    given = None if out is None else fitting(out, len(order), shape, dtype)
    if prod(shape) <= SMALL:
        results = _at_once(block, arrays, shape, dtype)
    else:
        results = _by_blocks(block, registers, order, arrays, given, shape, dtype)
    if given:
        for each, result in zip(given, results, strict=True):
            if each is not result:
                np.copyto(each, result)
        results = given
    return results[0] if len(order) == 1 else tuple(results)


def _at_once(block: Block, arrays: list[Any], shape: tuple[int, ...], dtype: Any) -> Sequence[Any]:
    """The results in arrays of their own; numbers for numbers."""
    whole = [x if shape and x.shape == shape and x.dtype == dtype else _filled(x, shape or (1,), dtype) for x in arrays]
    results = block(*whole)
    results = results if type(results) is tuple else (results,)
    return results if shape else [x[0] for x in results]


def _filled(x: Any, shape: tuple[int, ...], dtype: Any) -> Any:
    whole = np.empty(shape, dtype)
    np.copyto(whole, x, casting="same_kind")
    return whole


def _by_blocks(
    block: Block,
    registers: int,
    order: Sequence[int],
    arrays: list[Any],
    given: list[Any] | None,
    shape: tuple[int, ...],
    dtype: Any,
) -> Sequence[Any]:
    """The results, in the arrays that are given."""
    arrays = [x if x.ndim else x.astype(dtype, casting="same_kind") for x in arrays]
    if given is None:
        outputs = [np.empty(shape, dtype) for _ in range(max(order) + 1)]
    else:  # an output must not overwrite what is read later
        arrays = [x.copy() if any(np.may_share_memory(x, y) for y in given) else x for x in arrays]
        outputs = [given[order.index(k)] for k in range(max(order) + 1)]
    _run(block, registers, arrays, outputs, shape, dtype)
    return [outputs[k] for k in order]


def evaluate_handful(expression: Callable[..., Any], inputs: Sequence[Any], order: Sequence[int] = ()) -> Any:
    """The same for a handful of points in arrays of doubles of one shape: each point through `math`, as numbers are.

    OverflowError where a result is not finite: NumPy is to compute it, and to warn. `order` as above, if any outputs
    are the same.
    """
    first = inputs[0]
    columns: list[Any]
    if first.size == 1:
        point = expression(*[x.item() for x in inputs])
        columns = [[point]] if type(point) is float else [[x] for x in point]
    else:
        flat = inputs if first.ndim == 1 else [x.ravel() for x in inputs]
        rows = [*map(expression, *[x.tolist() for x in flat])]
        columns = [rows] if type(rows[0]) is float else [*zip(*rows, strict=True)]
    if not isfinite(sum(map(sum, columns))):
        raise OverflowError
    if order:
        columns = [*dict(zip(order, columns, strict=True)).values()]
    outputs = [array(column) for column in columns]
    if first.ndim != 1:
        outputs = [x.reshape(first.shape) for x in outputs]
    if order:
        outputs = [outputs[k] for k in order]
    return outputs[0] if len(outputs) == 1 else tuple(outputs)


def evaluate_alike(block: Block, registers: int, order: Sequence[int], inputs: Sequence[Any]) -> Any:
    """The same for arrays of doubles that all have one shape."""
    shape = inputs[0].shape
    outputs = [np.empty(shape) for _ in range(max(order) + 1)]
    flat = inputs if len(shape) == 1 else [x.reshape(-1) if x.flags.c_contiguous else None for x in inputs]
    if any(x is None for x in flat):
        _run(block, registers, inputs, outputs, shape, DOUBLE)
    else:
        _pieces(block, _registers(registers, DOUBLE), [*flat, *(x.reshape(-1) for x in outputs)], outputs[0].size)
    return outputs[0] if len(order) == 1 else tuple([outputs[k] for k in order])


def _single(block: Any) -> Block:
    """The block with its numbers in single precision."""
    numbers = tuple(x if x is None else x.astype(np.float32) for x in block.__defaults__ or ())
    return FunctionType(block.__code__, block.__globals__, argdefs=numbers)


def fitting(out: Any, outputs: int, shape: tuple[int, ...], dtype: Any) -> list[Any]:
    """The arrays of `out`; ValueError if they are not as many as the outputs, or do not fit."""
    results = list(out) if isinstance(out, (tuple, list)) else [out]
    if len(results) != outputs:
        raise ValueError(f"out has {len(results)} arrays; this kernel has {outputs} outputs")
    for each in results:
        if not isinstance(each, np.ndarray) or each.shape != shape or each.dtype != dtype:
            found = f"{each.shape} {each.dtype}" if isinstance(each, np.ndarray) else type(each).__name__
            raise ValueError(f"out is {found}; an array of shape {shape} and type {dtype} is needed")
    if any(np.shares_memory(x, y) for x, y in combinations(results, 2)):
        raise ValueError("two arrays of out share memory; each output needs memory of its own")
    return results


def _run(
    block: Block, registers: int, arrays: Sequence[Any], outputs: list[Any], shape: tuple[int, ...], dtype: Any
) -> None:
    everything = (*arrays, *outputs)
    if all(x.shape in (shape, ()) and x.dtype == dtype and x.flags.c_contiguous for x in everything):
        flat = [x.reshape(-1) if x.shape == shape else x for x in everything]
        _pieces(block, _registers(registers, dtype), flat, outputs[0].size)
        return
    chunks: Any = np.nditer  # its types know neither `with` nor lists of modes
    modes = [["readonly"]] * len(arrays) + [["writeonly"]] * len(outputs)
    flags = ["external_loop", "buffered", "zerosize_ok", "delay_bufalloc"]
    rows = _registers(registers, dtype)
    with chunks(everything, flags, modes, [dtype] * len(modes), casting="same_kind", buffersize=BLOCK) as iterator:
        iterator.reset()
        for chunk in iterator:
            block(*chunk, *(row[: chunk[0].size] for row in rows))


def _pieces(block: Block, rows: list[Any], flat: list[Any], size: int) -> None:
    for first in range(0, size, BLOCK):
        last = min(first + BLOCK, size)
        pieces = flat if last - first == size else [x[first:last] if x.ndim else x for x in flat]
        block(*pieces, *(rows if last - first == BLOCK else [row[: last - first] for row in rows]))


def _registers(count: int, dtype: Any) -> list[Any]:
    kept: dict[Any, list[Any]] = _local.__dict__.setdefault("registers", {})
    rows = kept.setdefault(dtype, [])
    while len(rows) < count:
        memory = np.empty(BLOCK * dtype.itemsize + LINE, np.uint8)
        begin = -memory.ctypes.data % LINE
        rows.append(memory[begin : begin + BLOCK * dtype.itemsize].view(dtype))
    return rows[:count]
