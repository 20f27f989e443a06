"""How a generated kernel runs: on numbers and a handful of points by `math`, on small arrays at once, else by blocks.

A generated module `<key>.py` has the formulas as functions of floats, each under the decorator `kernel`, with what is
known of it as data. `_<key>.py` next to it has the same formulas as calls of ufuncs on registers. A block of points
stays in the caches of its processor, so that the values between two operations never travel to memory; the registers
are kept from call to call, one set for each thread. NumPy and the standard library alone.

Numbers of whatever types go through the formula. Numbers beside arrays, and arrays that broadcast, go through the same
text of ufuncs with other functions under their names: what depends on numbers alone stays a number and is computed
once, and each value in between has the shape of what it depends on.

Decision: one thread for a call. Reason: an operation on a block takes microseconds, and two threads that ask for the
interpreter's lock that often wait for one another longer than they compute (measured: 0 to 20 % gained, except where
sines prevail). Callers share large work among processes or threads by themselves; each thread has its own registers.

Decision: the test for floats is written out for each kernel, in `_<key>.py`. Reason: a loop over `*arguments` here
takes 70 ns, and many a formula takes 100.
"""

from __future__ import annotations

import math
import operator
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import cache, update_wrapper
from itertools import combinations, product
from math import isfinite, prod
from types import FunctionType
from typing import Any

import numpy as np
from numpy import array, ndarray
from numpy.typing import NDArray

from symcheck.kernels.specification import KernelFunction, Specification

BLOCK = 8192  # elements: 64 kB of doubles
DOUBLE = np.dtype(np.float64)
LINE = 64  # bytes of a cache line: registers that begin on one are read twice as fast
SMALL = 12288  # elements: up to here a second block costs more time than it saves
FEW = 200  # elements: up to here sines and cosines cost no more than the tangents that replace them in a block

# What `math` raises where NumPy gives infinity or NaN, and warns.
UNDEFINED: tuple[type[Exception], ...] = (ValueError, ZeroDivisionError, OverflowError)

Array = NDArray[np.float64]
Values = float | NDArray[np.float64 | np.float32 | np.int64 | np.int32]
DType = np.dtype[np.float64]  # or of float32, as are the arrays then
Out = Array | Sequence[Array] | None
Results = Array | tuple[Array, ...]
Block = Callable[..., Results]
Formula = Callable[..., float | tuple[float, ...]]
NUMBERS = {float, int, np.float64, np.int64, np.int32}
OPERATORS: dict[str, Callable[..., float]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "divide": operator.truediv,
    "negative": operator.neg,
}
WORTH = 8  # operations that are done one by one with a look at their operands, in the time of one that is saved
MATH = {"power": "pow", "arctan": "atan"}  # names in `math` that differ from those of ufuncs
_local = threading.local()


def kernel(paths: Callable[[Formula], Any], said: Specification) -> Callable[[Formula], KernelFunction]:
    """The decorator of a formula: the function of numbers and arrays that `paths` makes of it, with its data."""

    def decorated(formula: Formula) -> KernelFunction:
        function = paths(formula)
        update_wrapper(function, formula)
        del function.__wrapped__  # whose signature has no `out`
        function.specification = said
        kernel: KernelFunction = function
        return kernel

    return decorated


def on_arrays(
    formula: Formula, block: Block, registers: int, order: Sequence[int], handful: int
) -> tuple[Block, Callable[[Sequence[Array], Out], Results]]:
    """A kernel of arrays of doubles of one shape, and one of the tuple of anything that broadcasts and `out`.

    formula    computes one point, of floats
    block      computes arrays of one shape; further arguments are arrays for results and for values in between
    registers  how many of the latter there are
    order      for each output, which of the block's results it is
    handful    up to so many points the formula takes less time than the block
    """
    distinct = max(order) + 1
    shared = order if distinct < len(order) else ()

    def same_shape(*inputs: Array) -> Results:
        size = inputs[0].size
        if size > SMALL:
            outputs = [np.empty(inputs[0].shape) for _ in range(distinct)]
            _of_one_shape(block, registers, inputs, outputs)
            return _one_or_tuple([outputs[k] for k in order])
        if 0 < size <= handful:
            try:
                return _by_formula(formula, inputs, shared)
            except UNDEFINED:
                return others(inputs, None)
        return block(*inputs)

    free = _free(block)

    def others(inputs: Sequence[Array], out: Out) -> Results:
        if out is None and NUMBERS.issuperset(map(type, inputs)):
            try:
                return _of_numbers(formula, inputs)
            except UNDEFINED:
                pass
        return _of_anything(block, free, registers, order, inputs, out)

    return same_shape, others


def _one_or_tuple(results: Sequence[Array]) -> Results:
    return results[0] if len(results) == 1 else tuple(results)


def _of_numbers(formula: Formula, inputs: Sequence[Any]) -> Results:
    """The results at one point of numbers of several types; OverflowError where NumPy is to warn."""
    found = formula(*map(float, inputs))
    point = found if isinstance(found, tuple) else (found,)
    if not isfinite(sum(point)):
        raise OverflowError
    results: list[Any] = [*map(np.float64, point)]
    return _one_or_tuple(results)


def _of_anything(
    block: Block, free: Block, registers: int, order: Sequence[int], inputs: Sequence[Array], out: Out
) -> Results:
    """One call of a kernel on anything that broadcasts: one array of the broadcast shape, or a tuple of them.

    Results that are the same are one array. float32 if all arrays are, else float64. ValueError if `out` does not fit.
    NumPy's warnings are the caller's.
    """
    dtype = np.result_type(*inputs)
    if dtype != np.float32:
        dtype = DOUBLE
    arrays = [x if type(x) is ndarray else np.asarray(x) for x in inputs]
    shapes = {x.shape for x in arrays} - {()} or {()}
    shape = np.broadcast_shapes(*shapes) if len(shapes) > 1 else shapes.pop()
    given = None if out is None else fitting(out, len(order), shape, dtype)
    results = None
    if shape and (len(shapes) > 1 or _many_of_numbers(block, tuple([not x.ndim for x in arrays]))):
        with suppress(*UNDEFINED):  # in what only numbers have part in
            results = _of_own_shapes(free, registers, order, arrays, given, shape, dtype)
    if results is None:
        own = block if dtype == DOUBLE else _single(block)
        if prod(shape) <= SMALL:
            results = _at_once(own, arrays, shape, dtype)
        else:
            results = _by_blocks(own, registers, order, arrays, given, shape, dtype)
    if given:
        for each, result in zip(given, results, strict=True):
            if each is not result:
                np.copyto(each, result)
        results = given
    return _one_or_tuple(results)


def _at_once(block: Block, arrays: Sequence[Array], shape: tuple[int, ...], dtype: DType) -> Sequence[Array]:
    """The results in new arrays; numbers for numbers."""
    whole = [x if shape and x.shape == shape and x.dtype == dtype else _filled(x, shape or (1,), dtype) for x in arrays]
    found = block(*whole)
    results = found if isinstance(found, tuple) else (found,)
    return results if shape else [x[0] for x in results]


def _filled(x: Array, shape: tuple[int, ...], dtype: DType) -> Array:
    whole = np.empty(shape, dtype)
    np.copyto(whole, x, casting="same_kind")
    return whole


def _by_blocks(
    block: Block,
    registers: int,
    order: Sequence[int],
    arrays: Sequence[Array],
    given: Sequence[Array] | None,
    shape: tuple[int, ...],
    dtype: DType,
) -> Sequence[Array]:
    """The results, in the arrays that are given."""
    arrays = [x if x.ndim else x.astype(dtype, casting="same_kind") for x in arrays]
    arrays, outputs = _apart(arrays, given), _outputs(order, given, shape, dtype)
    _run(block, registers, arrays, outputs, shape, dtype)
    return [outputs[k] for k in order]


def _of_own_shapes(
    free: Block,
    registers: int,
    order: Sequence[int],
    arrays: Sequence[Array],
    given: Sequence[Array] | None,
    shape: tuple[int, ...],
    dtype: DType,
) -> Sequence[Array]:
    """The results of arrays that broadcast, in pieces: each value in between has the shape of what it depends on."""
    if given is None and prod(shape) <= SMALL:
        return [_spread(x, shape, dtype) for x in _found(free, arrays, dtype)]
    outputs = _outputs(order, given, shape, dtype)
    aligned = [x.reshape((1,) * (len(shape) - x.ndim) + x.shape) if x.ndim else x for x in _apart(arrays, given)]
    rows = _registers(registers, dtype)
    for part in _parts(shape):
        into = [output[part] for output in outputs]
        own = [row[: into[0].size].reshape(into[0].shape) for row in rows]
        found = _found(free, [_part(x, part) for x in aligned], dtype, *into, *own)
        for k, result in zip(order, found, strict=True):
            if result is not into[k]:
                into[k][...] = result
    return [outputs[k] for k in order]


def _found(free: Block, arrays: Sequence[Array], dtype: DType, *memory: Array) -> Sequence[Any]:
    """What a free block gives for arrays: a number for each that is one."""
    alike = [x if x.dtype == dtype else x.astype(dtype, casting="same_kind") for x in arrays]
    found = free(*[x if x.ndim else x.item() for x in alike], *memory)
    return found if isinstance(found, tuple) else (found,)


def _spread(value: Any, shape: tuple[int, ...], dtype: DType) -> Array:
    """A result as an array of its own, of this shape and type."""
    if type(value) is ndarray and value.shape == shape and value.dtype == dtype:
        return value
    return _filled(np.asarray(value), shape, dtype)


def _parts(shape: tuple[int, ...]) -> Iterator[tuple[slice, ...]]:
    """Slices that cover a shape, each of a number of elements that stays in the cache."""
    size, axis = prod(shape), 0
    while axis < len(shape) - 1 and size > BLOCK * shape[axis]:  # not even one of this axis is small
        size //= shape[axis]
        axis += 1
    step = max(1, BLOCK * shape[axis] // max(size, 1))
    for before in product(*(range(n) for n in shape[:axis])):
        for first in range(0, shape[axis], step):
            yield (*(slice(k, k + 1) for k in before), slice(first, first + step))


def _part(x: Array, part: tuple[slice, ...]) -> Array:
    """The slice of an array that broadcasts: all of an axis of length 1."""
    return x[tuple([slice(None) if n == 1 else each for n, each in zip(x.shape, part, strict=False)])] if x.ndim else x


def _apart(arrays: Sequence[Array], given: Sequence[Array] | None) -> list[Array]:
    """The arrays, copied where an output would overwrite what is read later."""
    return [x.copy() if any(np.may_share_memory(x, y) for y in given or ()) else x for x in arrays]


def _outputs(
    order: Sequence[int], given: Sequence[Array] | None, shape: tuple[int, ...], dtype: DType
) -> Sequence[Array]:
    """The arrays of the distinct results: some of those that are given, or new ones."""
    count = max(order) + 1
    return (
        [np.empty(shape, dtype) for _ in range(count)]
        if given is None
        else [given[order.index(k)] for k in range(count)]
    )


def _of_one_shape(block: Block, registers: int, inputs: Sequence[Array], outputs: Sequence[Array]) -> None:
    """The results, in `outputs`, of many points in arrays of doubles of one shape."""
    if all(x.flags.c_contiguous for x in inputs):
        flat = [x.reshape(-1) for x in (*inputs, *outputs)]
        _pieces(block, _registers(registers, DOUBLE), flat, outputs[0].size)
    else:
        _run(block, registers, inputs, outputs, outputs[0].shape, DOUBLE)


def _by_formula(formula: Formula, inputs: Sequence[Array], shared: Sequence[int]) -> Results:
    """The results at a handful of points in arrays of doubles of one shape: each point through `math`, as numbers are.

    OverflowError where a result is not finite: NumPy is to compute it, and to warn. `shared` tells for each output
    which result it is, if some are the same.
    """
    first = inputs[0]
    if first.size == 1:
        found = formula(*[x.item() for x in inputs])
        point = found if isinstance(found, tuple) else (found,)
        total = sum(point)
        columns: list[Any] = [[x] for x in point]
    else:
        flat = inputs if first.ndim == 1 else [x.ravel() for x in inputs]
        rows = [*map(formula, *[x.tolist() for x in flat])]
        columns = [rows] if type(rows[0]) is float else [*zip(*rows, strict=True)]
        total = sum(map(sum, columns))
    if not isfinite(total):
        raise OverflowError
    if shared:
        columns = [*dict(zip(shared, columns, strict=True)).values()]
    outputs = [array(column) for column in columns]
    if first.ndim != 1:
        outputs = [x.reshape(first.shape) for x in outputs]
    if shared:
        outputs = [outputs[k] for k in shared]
    return outputs[0] if len(outputs) == 1 else tuple(outputs)


def _single(block: Any) -> Block:
    """The block with its numbers in single precision."""
    numbers = tuple(x if x is None else x.astype(np.float32) for x in block.__defaults__ or ())
    return FunctionType(block.__code__, block.__globals__, argdefs=numbers)


def _free(block: Any) -> Block:
    """The block with functions in which numbers stay numbers, and registers of another shape are not used."""
    names = {name: _function(name, block.__globals__[name]) for name in block.__code__.co_names}
    numbers = tuple(x if x is None else x.item() for x in block.__defaults__ or ())
    return FunctionType(block.__code__, names, argdefs=numbers)


@cache
def _many_of_numbers(block: Any, numbers: tuple[bool, ...]) -> bool:
    """Whether so many operations of a block have to do with numbers alone that to compute these once saves time.

    numbers  which arguments are numbers
    """
    found: list[bool] = []

    def operation(*operands: Any) -> bool:
        found.append(all(operands[:-1]))
        return found[-1]

    marked = FunctionType(
        block.__code__,
        dict.fromkeys(block.__code__.co_names, operation),
        argdefs=tuple(x is not None for x in block.__defaults__ or ()),
    )
    marked(*numbers)
    return sum(found) * WORTH > len(found)


def _function(name: str, function: Any) -> Any:
    """What a free block calls under a name, of floats and arrays; the last argument is a register, or anything."""
    of_float = OPERATORS.get(name) or getattr(math, MATH.get(name, name), None)
    if of_float is None:
        return lambda *x: function(*_alike(x[:-1]))

    def unary(x: Any, out: Any) -> Any:
        if type(x) is float:
            return of_float(x)
        return function(x, out) if type(out) is ndarray and out.shape == x.shape else function(x)

    def binary(x: Any, y: Any, out: Any) -> Any:
        if type(x) is float:
            if type(y) is float:
                return of_float(x, y)
            fits = type(out) is ndarray and y.shape == out.shape
        else:
            fits = type(out) is ndarray and x.shape == out.shape and (type(y) is float or y.shape == out.shape)
        return function(x, y, out) if fits else function(x, y)

    return unary if function.nin == 1 else binary


def _alike(values: tuple[Any, ...]) -> list[Any]:
    """The values of a function of `ratios`: floats, or arrays."""
    dtype = np.result_type(*values)
    return [*values] if {float} == {*map(type, values)} else [np.asarray(x, dtype) for x in values]


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
    block: Block,
    registers: int,
    arrays: Sequence[Array],
    outputs: Sequence[Array],
    shape: tuple[int, ...],
    dtype: DType,
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


def _pieces(block: Block, rows: Sequence[Array], flat: Sequence[Array], size: int) -> None:
    for first in range(0, size, BLOCK):
        last = min(first + BLOCK, size)
        pieces = flat if last - first == size else [x[first:last] if x.ndim else x for x in flat]
        block(*pieces, *(rows if last - first == BLOCK else [row[: last - first] for row in rows]))


def _registers(count: int, dtype: DType) -> list[Array]:
    kept: dict[DType, list[Array]] = _local.__dict__.setdefault("registers", {})
    rows = kept.setdefault(dtype, [])
    while len(rows) < count:
        memory = np.empty(BLOCK * dtype.itemsize + LINE, np.uint8)
        begin = -memory.ctypes.data % LINE
        rows.append(memory[begin : begin + BLOCK * dtype.itemsize].view(dtype))
    return rows[:count]
