"""How a generated kernel runs: on numbers and a handful of points by `math`, on small arrays at once, else by pieces.

A generated module has each formula once, as a function of floats under the decorator `kernel`, and a second time for
many points where a tangent replaces sines and cosines. `planning` makes of it functions of arrays when it is first
called with a mix of arguments: what depends on numbers alone is computed once, and each value has the shape of what
it depends on. A piece of points stays in the caches of its processor, so that the values between two operations never
travel to memory; the registers are kept from call to call, one set for each thread. NumPy and the standard library
alone.

Decision: one thread for a call. Reason: an operation on a piece takes microseconds, and two threads that ask for the
interpreter's lock that often wait for one another longer than they compute (measured: 0 to 20 % gained, except where
sines prevail). Callers share large work among processes or threads by themselves; each thread has its own registers.
"""

from __future__ import annotations

import re
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache, partial, update_wrapper
from inspect import cleandoc
from itertools import product, repeat
from math import isfinite, prod
from typing import Any

import numpy as np
from numpy import array, ndarray
from numpy.typing import NDArray

from symcheck.kernels import calling
from symcheck.kernels.calling import NUMBERS, PLAIN, UNDEFINED, fitting
from symcheck.kernels.documentation import numpy_docstring
from symcheck.kernels.grouping import grouped
from symcheck.kernels.planning import Plan
from symcheck.kernels.quantities import in_units, is_quantity, with_units
from symcheck.kernels.specification import Argument, KernelFunction, Output, Specification
from symcheck.kernels.tracing import Pattern, Trace, trace

__all__ = [
    "BLOCK",
    "DOUBLE",
    "FEW",
    "SMALL",
    "Argument",
    "Array",
    "Output",
    "Values",
    "for_arrays",
    "kernel",
]

BLOCK = 8192  # elements: 64 kB of doubles
DOUBLE, SINGLE = np.dtype(np.float64), np.dtype(np.float32)
LINE = 64  # bytes of a cache line: registers that begin on one are read twice as fast
SMALL = 12288  # elements: up to here a second piece costs more time than it saves
KEPT = 256  # shapes that a mix of arguments is prepared for
FEW = 200  # elements: up to here sines and cosines cost no more than the tangents that replace them beyond

Array = NDArray[np.float64]
Values = float | NDArray[np.float64 | np.float32 | np.int64 | np.int32]
DType = np.dtype[np.float64]  # or of float32, as are the arrays then
Out = Array | Sequence[Array] | None
Results = Any  # an array or a number, or a tuple of them
Block = Callable[..., Any]
Formula = Callable[..., float | tuple[float, ...]]
IN_DEGREES = re.compile(r"(arc)?deg|arcmin|arcsec|°|rpm", re.IGNORECASE)  # as pint and CF conventions spell them
_local = threading.local()


def kernel(
    *said: Argument | Output,
    ulp: int,
    claims: Mapping[str, str],
    forms: str = "",
    condition: str = "",
    degenerate: str = "",
) -> Callable[[Formula], KernelFunction]:
    """The decorator of a formula of floats: a function of numbers and arrays that broadcast, and of `out=`.

    said    its arguments and outputs
    claims  the relations of the paper that it rests on; see `Specification` for these and the others
    """

    def decorated(formula: Any) -> KernelFunction:
        paper = formula.__module__.rpartition(".")[2]
        text = cleandoc(formula.__doc__ or "")
        specification = Specification(
            paper=paper,
            name=formula.__name__,
            says=" ".join(text.partition("\n\n")[0].split()),
            arguments=tuple([x for x in said if isinstance(x, Argument)]),
            outputs=tuple([x for x in said if isinstance(x, Output)]),
            ulp=ulp,
            condition=condition,
            degenerate=degenerate,
            claims={f"{paper}:{number}": digest for number, digest in claims.items()},
            forms=forms,
        )
        ways = Ways(formula, specification)
        function: KernelFunction = ways.call
        update_wrapper(function, formula)
        vars(function).pop("__wrapped__")  # whose signature has no `out`
        function.__doc__ = numpy_docstring(specification, text) if text else None
        function.specification = specification
        function.ways = ways
        return function

    return decorated


def for_arrays(function: KernelFunction) -> Callable[[Formula], Formula]:
    """The decorator of a formula that a kernel is to take for more than FEW points, with the same values."""

    def decorated(formula: Formula) -> Formula:
        function.ways.many = formula
        return formula

    return decorated


class Ways:
    """The ways in which a kernel runs.

    formula  computes one point, of floats
    many     the same, with functions that take less time where there are many points
    call     the function of numbers and arrays
    """

    def __init__(self, formula: Formula, said: Specification) -> None:
        self.formula = self.many = formula
        self.said = said
        self._traces: dict[Formula, Trace] = {}
        self._plans: dict[tuple[Any, ...], Plan] = {}
        self._ways: dict[tuple[type, ...], Callable[..., Any]] = {}
        names = [argument.name for argument in said.arguments]

        def of_arrays(*inputs_and_out: Any) -> Any:
            call.__globals__["of_arrays"] = found = self._way((ndarray,) * len(names))
            return found(*inputs_and_out)

        space = {"formula": formula, "of_arrays": of_arrays, "ways": self._ways, "way": self._way}
        self.call = call = calling.call_of(said.name, names, space)

    def _way(self, kinds: tuple[type, ...]) -> Callable[..., Any]:
        """What arguments of these types go through; the first time."""
        self._ways[kinds] = found = self._new_way(kinds)
        return found

    def _new_way(self, kinds: tuple[type, ...]) -> Callable[..., Any]:
        numbers = {*kinds} - {ndarray}
        if any(map(calling.is_foreign, numbers)):
            return self._of_library

        def others(*inputs_and_out: Any) -> Any:
            return self._of_any_types(inputs_and_out[:-1], inputs_and_out[-1])

        if not numbers <= NUMBERS:
            return others
        if ndarray not in kinds:
            return calling.of_numbers(kinds, self.order, {"formula": self.formula, "others": others})
        patterns: tuple[Pattern, ...] = tuple([1 if kind is ndarray else None for kind in kinds])
        found: Callable[..., Any] = others
        dtypes: Sequence[Any] = (SINGLE, DOUBLE) if numbers <= PLAIN else (DOUBLE,)
        for dtype in dtypes:
            space: dict[str, Any] = {"formula": self.formula, "others": found, "known": {}}
            space["of_handful"] = partial(self._of_handful, kinds.index(ndarray), dtype)
            space["of_one_shape"] = partial(self._of_one_shape, space, patterns, dtype)
            space["of_shapes"] = partial(self._of_shapes, space["known"], dtype)
            found = calling.of_arrays(kinds, dtype, self.order, space)
        return found

    def traced(self, many: bool = False) -> Trace:
        """The operations for few points, or for many."""
        formula = self.many if many else self.formula
        if formula not in self._traces:
            self._traces[formula] = trace(formula)
        return self._traces[formula]

    @cached_property
    def order(self) -> list[int]:
        """For each output, which of the distinct results it is."""
        return self.traced().order

    def plan(
        self, many: bool, patterns: tuple[Pattern, ...], full: int, dtype: DType, *, as_written: bool = False
    ) -> Plan:
        """How arguments of these patterns are computed; sines are no slower than tangents in single precision.

        `as_written` keeps the order of the formula, so that bits do not depend on which arguments have which axes.
        """
        many = many and dtype is DOUBLE and self.many is not self.formula
        key = many, patterns, full, dtype, as_written
        if key not in self._plans:
            traced = self.traced(many)
            ordered = traced if as_written or {*patterns} == {full} else grouped(traced, patterns, self._positive)
            self._plans[key] = Plan(ordered, patterns, full, dtype, self.said.name)
        return self._plans[key]

    @cached_property
    def _positive(self) -> frozenset[int]:
        """The places of arguments that are not negative, by their domains."""
        return frozenset(k for k, argument in enumerate(self.said.arguments) if argument.low == "0")

    def of_anything(self, inputs: Sequence[Any], out: Out = None, many: bool = False) -> Results:
        """The results of anything that broadcasts: arrays of the broadcast shape, or numbers of numbers.

        Results that are the same are one array. float32 if all arrays are, else float64. ValueError if `out` does not
        fit. NumPy's warnings are the caller's. `many` computes few points as many are, to the last bit.
        """
        return self._of_any_types(inputs, out, many) if many else self.call(*inputs, out=out)

    def _of_library(self, *inputs_and_out: Any) -> Any:
        """The results of arrays of another library of the array API standard, by that library."""
        if inputs_and_out[-1] is not None:
            raise ValueError(f"{self.said.name}: out= is for NumPy's arrays; leave it out")
        return self._in_libraries(*inputs_and_out[:-1])

    @cached_property
    def _in_libraries(self) -> Any:
        from symcheck.kernels.libraries import in_libraries

        return in_libraries(self.call)

    def _of_one_shape(
        self, space: dict[str, Any], patterns: tuple[Pattern, ...], dtype: DType, values: Sequence[Any], out: Out
    ) -> Results:
        """The results of arrays of one shape and floats; their function is kept for later calls of such a mix."""
        first = values[patterns.index(1)]
        size, shape = first.size, first.shape
        if not shape:
            return self._of_any_types(values, out)
        many = size > FEW and dtype is DOUBLE and self.many is not self.formula
        found = self.plan(many, patterns, 1, dtype)
        if many:
            space.update(of_many=found.whole, less=max(FEW, found.handful), more=SMALL)
        elif size:
            alone = dtype is SINGLE or self.many is self.formula
            space.update(of_few=found.whole, few=found.handful, most=SMALL if alone else FEW)
        if size and out is not None:
            space["into_many" if many else "into_few"] = found.into
        given = None if out is None else fitting(out, len(self.said.outputs), shape, dtype)
        return self._computed(found, values, shape, dtype, given, one_by_one=True)

    def _of_handful(self, first: int, dtype: DType, *values_and_given: Any) -> Results:
        """The results at a handful of points in arrays of one shape, of which one has the place `first`."""
        count = len(self.said.arguments)
        values, given = values_and_given[:count], values_and_given[count:]
        every = [given[k] for k in self.order] if given else None
        return self._one_by_one(values, values[first].shape, dtype, every)

    def _of_shapes(self, known: dict[Any, Any], dtype: DType, values: Sequence[Any], out: Out) -> Results:
        """The results of arrays that broadcast and floats; their function is kept for later calls with such shapes."""
        shapes = tuple([x.shape for x in values if type(x) is ndarray])
        if () in shapes:
            return self._of_any_types(values, out)
        shape, patterns, full = _aligned(tuple([x.shape if type(x) is ndarray else () for x in values]))
        size = prod(shape)
        alike = size == 1 or {*patterns} <= {None, full}
        found = self.plan(size > FEW, patterns, full, dtype)
        if 0 < size <= SMALL and len(known) < KEPT:
            known[shapes] = found.whole
            if alike and size <= found.handful:
                known[shapes] = lambda *values: self._one_by_one(values, shape, dtype, None)
        given = None if out is None else fitting(out, len(self.said.outputs), shape, dtype)
        return self._computed(found, values, shape, dtype, given, one_by_one=alike)

    def _of_quantities(self, inputs: Sequence[Any], out: Out, many: bool) -> Any:
        """The results with their units, of quantities in any units of the same dimensions."""
        values, registry = in_units(self.said, inputs)
        if out is not None:
            raise ValueError(f"{self.said.name}: out= is for plain arrays, which keep no unit; leave it out")
        return with_units(self.said, self.of_anything(values, many=many), registry)

    def _of_any_types(self, inputs: Sequence[Any], out: Out, many: bool = False) -> Results:
        if any(map(is_quantity, map(type, inputs))):
            return self._of_quantities(inputs, out, many)
        self._refuse_what_would_be_lost(inputs)
        dtype: DType = np.result_type(*inputs)
        if dtype != np.float32:
            dtype = DOUBLE
        arrays = [x if type(x) is ndarray else np.asarray(x) for x in inputs]
        shape, patterns, full = _aligned(tuple([x.shape for x in arrays]))
        given = None if out is None else fitting(out, len(self.said.outputs), shape, dtype)
        if not shape:
            return self._of_point(arrays, dtype, given)
        size = prod(shape)
        values: list[Any] = []
        for x, pattern in zip(arrays, patterns, strict=True):
            if x.dtype != dtype and (pattern != full or size <= SMALL):
                x = x.astype(dtype, casting="same_kind")
            values.append(x if x.ndim else x.item())
        found = self.plan(many or size > FEW, patterns, full, dtype, as_written=many)
        alike = size == 1 or {*patterns} <= {None, full}
        return self._computed(found, values, shape, dtype, given, one_by_one=not many and alike)

    def _refuse_what_would_be_lost(self, inputs: Sequence[Any]) -> None:
        """ValueError for a unit or a mask, of which an array of numbers keeps nothing."""
        for argument, x in zip(self.said.arguments, inputs, strict=True):
            units = str(getattr(x, "attrs", {}).get("units", ""))
            if IN_DEGREES.match(units):
                raise ValueError(
                    f"{self.said.name}: {argument.name} has units {units!r}; angles are in radians, rates in rad/s"
                )
            if isinstance(x, np.ma.MaskedArray):
                raise ValueError(
                    f"{self.said.name}: {argument.name} is a masked array, whose mask would be lost; pass its filled() "
                    "or compressed() values"
                )

    def _of_point(self, arrays: Sequence[Array], dtype: DType, given: Sequence[Array] | None) -> Results:
        """The results of arrays without dimensions: numbers."""
        whole = [_filled(x, (1,), dtype) for x in arrays]
        found = self.plan(False, (1,) * len(whole), 1, dtype).whole(*whole)
        results = [x[0] for x in (found if isinstance(found, tuple) else (found,))]
        return _one_or_tuple(results if given is None else _put(results, given))

    def _computed(
        self,
        found: Plan,
        values: Sequence[Any],
        shape: tuple[int, ...],
        dtype: DType,
        given: Sequence[Array] | None,
        *,
        one_by_one: bool,
    ) -> Results:
        """The results of floats and arrays; arrays have the type of the results unless they are large."""
        size = prod(shape)
        try:
            if size <= found.handful and one_by_one and size:
                return self._one_by_one(values, shape, dtype, given)
            if size > SMALL:
                return self._in_pieces(found, values, shape, dtype, given)
            return self._at_once(found, values, given)
        except UNDEFINED:  # in what only numbers have part in
            return self._of_whole_arrays(values, shape, dtype, given, many=not one_by_one)

    def _one_by_one(
        self, values: Sequence[Any], shape: tuple[int, ...], dtype: DType, given: Sequence[Array] | None
    ) -> Results:
        """The results at a handful of points in arrays of one shape: each point through `math`, as numbers are.

        OverflowError where a result is not finite: NumPy is to compute it, and to warn.
        """
        if prod(shape) == 1:
            found: Any = self.formula(*[x if type(x) is float else x.item() for x in values])
            if type(found) is float:
                found = (found,)
            total = sum(found)
            columns: list[Any] = [[x] for x in found]
        else:
            rows = [*map(self.formula, *[repeat(x) if type(x) is float else x.ravel().tolist() for x in values])]
            columns = [rows] if type(rows[0]) is float else [*zip(*rows, strict=True)]
            total = sum(map(sum, columns))
        if not isfinite(total):
            raise OverflowError
        if given is not None:
            for each, column in zip(given, columns, strict=True):
                each[...] = column if len(shape) == 1 else array(column, dtype).reshape(shape)
            return _one_or_tuple(given)
        order = self.order
        shared = len({*order}) < len(order)
        if shared:
            columns = [columns[order.index(k)] for k in range(max(order) + 1)]
        outputs = [array(column, dtype) for column in columns]
        if len(shape) != 1:
            outputs = [x.reshape(shape) for x in outputs]
        return _one_or_tuple([outputs[k] for k in order] if shared else outputs)

    def _at_once(self, found: Plan, values: Sequence[Any], given: Sequence[Array] | None) -> Results:
        """The results of small arrays; those that are given are written to last, as they may be arguments."""
        results = found.whole(*values)
        return (
            results if given is None else _one_or_tuple(_put(results if type(results) is tuple else (results,), given))
        )

    def _in_pieces(
        self,
        found: Plan,
        values: Sequence[Any],
        shape: tuple[int, ...],
        dtype: DType,
        given: Sequence[Array] | None,
    ) -> Results:
        """The results of large arrays, piece by piece."""
        order = self.order
        distinct = range(max(order) + 1)
        outputs = [np.empty(shape, dtype) if given is None else given[order.index(k)] for k in distinct]
        ready = found.prelude(*(values if given is None else _apart(values, given)))
        into = [outputs[k] for k in found.even]
        taken = ready[: found.taken]
        if into and all(x.shape in (shape, ()) for x in taken):
            _run(found.block, found.registers, taken, into, shape, dtype)
        elif into:
            _run_parts(found.block, found.registers, taken, into, shape, dtype)
        for k, value in zip([k for k in distinct if k not in found.even], ready[found.taken :], strict=True):
            outputs[k][...] = value
        results = [outputs[k] for k in order]
        return _one_or_tuple(results if given is None else _put(results, given))

    def _of_whole_arrays(
        self,
        values: Sequence[Any],
        shape: tuple[int, ...],
        dtype: DType,
        given: Sequence[Array] | None,
        many: bool,
    ) -> Results:
        """The results by NumPy alone, which gives infinity or NaN where `math` raises, and warns."""
        size, full = prod(shape), (1 << len(shape)) - 1
        found = self.plan(many or size > FEW, (full,) * len(values), full, dtype)
        if size <= SMALL:
            whole = [_filled(x, shape, dtype) for x in values]
            return self._at_once(found, whole, given)
        return self._in_pieces(found, [array(x, dtype) if type(x) is float else x for x in values], shape, dtype, given)


def _one_or_tuple(results: Sequence[Any]) -> Any:
    return results[0] if len(results) == 1 else tuple(results)


def _put(results: Sequence[Any], given: Sequence[Array]) -> Sequence[Array]:
    """The arrays that are given, with the results in them."""
    for each, result in zip(given, results, strict=True):
        if each is not result:
            each[...] = result
    return given


@lru_cache(256)
def _aligned(shapes: tuple[tuple[int, ...], ...]) -> tuple[tuple[int, ...], tuple[Pattern, ...], int]:
    """The shape to which shapes broadcast, which of its axes each has in full as bits, and all of them."""
    shape = np.broadcast_shapes(*shapes)
    patterns: list[Pattern] = []
    for own in shapes:
        axes = enumerate(zip(reversed(shape), reversed(own), strict=False), 1)
        patterns.append(sum(1 << len(shape) - k for k, (n, its) in axes if its == n) if own else None)
    return shape, tuple(patterns), (1 << len(shape)) - 1


def _filled(x: Any, shape: tuple[int, ...], dtype: DType) -> Array:
    whole = np.empty(shape, dtype)
    np.copyto(whole, x, casting="same_kind")
    return whole


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


def _apart(values: Sequence[Any], given: Sequence[Array]) -> list[Any]:
    """The values, copied where an output would overwrite what is read later."""
    return [x.copy() if type(x) is ndarray and any(_share(x, y) for y in given) else x for x in values]


def _share(x: Array, y: Array) -> bool:
    return x is y or (not (x.flags.owndata and y.flags.owndata) and np.may_share_memory(x, y))


def _run(
    block: Block,
    registers: int,
    taken: Sequence[Array],
    outputs: Sequence[Array],
    shape: tuple[int, ...],
    dtype: DType,
) -> None:
    """The results of arrays of one shape and of arrays without dimensions."""
    everything = (*taken, *outputs)
    rows = _registers(registers, dtype)
    if all(x.shape in (shape, ()) and x.dtype == dtype and x.flags.c_contiguous for x in everything):
        flat = [x.reshape(-1) if x.shape == shape else x for x in everything]
        _pieces(block, rows, flat, outputs[0].size)
        return
    chunks: Any = np.nditer  # its types know neither `with` nor lists of modes
    wide = [k for k, x in enumerate(taken) if x.ndim]
    modes = [["readonly"]] * len(wide) + [["writeonly"]] * len(outputs)
    flags = ["external_loop", "buffered", "zerosize_ok", "delay_bufalloc"]
    operands = [*(taken[k] for k in wide), *outputs]
    pieces = [*taken]
    with chunks(operands, flags, modes, [dtype] * len(modes), casting="same_kind", buffersize=BLOCK) as iterator:
        iterator.reset()
        for chunk in iterator:
            for k, piece in zip(wide, chunk, strict=False):
                pieces[k] = piece
            block(*pieces, *chunk[len(wide) :], *(row[: chunk[0].size] for row in rows))


def _run_parts(
    block: Block,
    registers: int,
    taken: Sequence[Array],
    outputs: Sequence[Array],
    shape: tuple[int, ...],
    dtype: DType,
) -> None:
    """The results of arrays that broadcast, in pieces along their axes."""
    aligned = [x.reshape((1,) * (len(shape) - x.ndim) + x.shape) if x.ndim else x for x in taken]
    narrow = [k for k, x in enumerate(taken) if x.shape not in (shape, ())]
    rows = _registers(registers + len(narrow), dtype)
    before: dict[int, Any] = {}
    for part in _parts(shape):
        into = [output[part] for output in outputs]
        own = [row[: into[0].size].reshape(into[0].shape) for row in rows]
        pieces = [_part(x, part) for x in aligned]
        for k, row in zip(narrow, own[registers:], strict=True):
            place = into[0].shape, [each for n, each in zip(aligned[k].shape, part, strict=False) if n > 1]
            if before.get(k) != place:  # else it is there
                row[...] = pieces[k]
                before[k] = place
            pieces[k] = row
        block(*[x if x.dtype == dtype else x.astype(dtype) for x in pieces], *into, *own[:registers])


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
