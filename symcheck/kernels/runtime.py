"""How a generated kernel runs: on numbers and a handful of points by `math`, on small arrays at once, else by pieces.

A generated module has each formula once, as a function of floats under the decorator `kernel`, and a second time for
many points where a tangent replaces sines and cosines. `tracing` makes of it functions of arrays when it is first
called with a mix of arguments: what depends on numbers alone is computed once, and each value has the shape of what
it depends on. A piece of points stays in the caches of its processor, so that the values between two operations never
travel to memory; the registers are kept from call to call, one set for each thread. NumPy and the standard library
alone.

Decision: one thread for a call. Reason: an operation on a piece takes microseconds, and two threads that ask for the
interpreter's lock that often wait for one another longer than they compute (measured: 0 to 20 % gained, except where
sines prevail). Callers share large work among processes or threads by themselves; each thread has its own registers.

Decision: the test for floats is written out for each number of arguments. Reason: a loop over `*arguments` takes
70 ns, and many a formula takes 100.
"""

from __future__ import annotations

import re
import sys
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, cached_property, lru_cache, update_wrapper
from inspect import cleandoc
from itertools import combinations, product, repeat
from math import isfinite, prod
from types import CodeType, FunctionType
from typing import Any

import numpy as np
from numpy import array, ndarray
from numpy.typing import NDArray

from symcheck.kernels.documentation import numpy_docstring
from symcheck.kernels.quantities import in_units, is_quantity, with_units
from symcheck.kernels.specification import Argument, KernelFunction, Output, Specification
from symcheck.kernels.tracing import Pattern, Plan, Trace, plan, trace

__all__ = [
    "BLOCK",
    "DOUBLE",
    "FEW",
    "SMALL",
    "Argument",
    "Array",
    "Output",
    "Values",
    "fitting",
    "for_arrays",
    "kernel",
]

BLOCK = 8192  # elements: 64 kB of doubles
DOUBLE, SINGLE = np.dtype(np.float64), np.dtype(np.float32)
LINE = 64  # bytes of a cache line: registers that begin on one are read twice as fast
SMALL = 12288  # elements: up to here a second piece costs more time than it saves
FEW = 200  # elements: up to here sines and cosines cost no more than the tangents that replace them beyond

# What `math` raises where NumPy gives infinity or NaN, and warns.
UNDEFINED: tuple[type[Exception], ...] = (ValueError, ZeroDivisionError, OverflowError)

Array = NDArray[np.float64]
Values = float | NDArray[np.float64 | np.float32 | np.int64 | np.int32]
DType = np.dtype[np.float64]  # or of float32, as are the arrays then
Out = Array | Sequence[Array] | None
Results = Any  # an array or a number, or a tuple of them
Block = Callable[..., Any]
Formula = Callable[..., float | tuple[float, ...]]
PLAIN = frozenset({float, int})
NUMBERS = PLAIN | {np.float64, np.int64, np.int32}
IN_DEGREES = re.compile(r"(arc)?deg|arcmin|arcsec|°|rpm", re.IGNORECASE)  # as pint and CF conventions spell them
CALL = """def call({inputs}, out=None):
    if out is None:
        if float is {types}:
            try:
                return formula({inputs})
            except UNDEFINED:
                pass
        elif ndarray is {types} and DOUBLE is {dtypes} and () != {shapes}:
            if few < x0.size <= most:
                return whole({inputs})
            return of_one_shape({inputs})
        elif float64 is {types}:
            try:
                return {of_doubles}
            except UNDEFINED:
                pass
    return of_anything(({inputs},), out)
"""
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


class _Mix:
    """What is known of arguments by their types.

    known       whether all are doubles, whole numbers or arrays
    quantities  whether some are quantities of pint
    plain       whether the numbers are Python's
    first       which is the first array, None if all are numbers or not all are known
    rest        which others are arrays
    weak        whether they leave single precision single
    patterns    of arrays of one shape
    plans       those of arrays of one shape, once there are any, by their type and whether points are many
    """

    __slots__ = ("first", "known", "patterns", "plain", "plans", "quantities", "rest", "weak")

    def __init__(self, kinds: tuple[type, ...]) -> None:
        numbers = {*kinds} - {ndarray}
        arrays = [k for k, kind in enumerate(kinds) if kind is ndarray]
        self.known = numbers <= NUMBERS
        self.quantities = not self.known and any(map(is_quantity, numbers))
        self.weak = numbers <= PLAIN
        self.plain = numbers <= {float} if arrays else self.weak
        self.first = arrays[0] if arrays and self.known else None
        self.rest = arrays[1:]
        self.patterns: tuple[Pattern, ...] = tuple([1 if kind is ndarray else None for kind in kinds])
        self.plans: dict[tuple[Any, ...], Plan] = {}


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
        self._mixes: dict[tuple[type, ...], _Mix] = {}
        names = [argument.name for argument in said.arguments]
        self._space: dict[str, Any] = {
            "DOUBLE": DOUBLE,
            "UNDEFINED": UNDEFINED,
            "doubles": _doubles,
            "few": sys.maxsize,  # until `whole` is there
            "float64": np.float64,
            "formula": formula,
            "most": 0,
            "ndarray": ndarray,
            "of_anything": self.of_anything,
            "of_one_shape": self.of_one_shape,
        }
        code = _call(len(names), not formula.__code__.co_names).replace(
            co_varnames=(*names, "out"), co_name=said.name, co_qualname=said.name
        )
        self.call: Any = FunctionType(code, self._space, said.name, (None,))

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

    def plan(self, many: bool, patterns: tuple[Pattern, ...], full: int, dtype: DType) -> Plan:
        """How arguments of these patterns are computed; sines are no slower than tangents in single precision."""
        many = many and dtype is DOUBLE and self.many is not self.formula
        key = many, patterns, full, dtype
        if key not in self._plans:
            self._plans[key] = plan(self.traced(many), patterns, full, dtype, self.said.name)
        return self._plans[key]

    def of_one_shape(self, *inputs: Array) -> Results:
        """The results of arrays of doubles of one shape."""
        space, size, full = self._space, inputs[0].size, (1,) * len(inputs)
        if "whole" not in space:
            found = self.plan(False, full, 1, DOUBLE)
            most = SMALL if self.many is self.formula else FEW
            space.update(whole=found.whole, few=found.handful, most=most)
            if found.handful < size <= most:
                return found.whole(*inputs)
        if 0 < size <= space["few"]:
            try:
                return self._one_by_one(inputs, inputs[0].shape, DOUBLE, None)
            except UNDEFINED:
                return space["whole"](*inputs)
        found = self.plan(True, full, 1, DOUBLE)
        if size <= SMALL:
            return found.whole(*inputs)
        return self._in_pieces(found, inputs, inputs[0].shape, DOUBLE, None)

    def of_anything(self, inputs: Sequence[Any], out: Out = None, many: bool = False) -> Results:
        """The results of anything that broadcasts: arrays of the broadcast shape, or numbers of numbers.

        Results that are the same are one array. float32 if all arrays are, else float64. ValueError if `out` does not
        fit. NumPy's warnings are the caller's. `many` computes few points as many are, to the last bit.
        """
        mix = self._mixes.get(kinds := tuple(map(type, inputs))) or self._mix(kinds)
        if mix.first is None:
            if mix.known and out is None and not many:
                try:
                    return self._of_numbers(inputs, plain=mix.plain)
                except UNDEFINED:
                    pass
            if mix.quantities:
                return self._of_quantities(inputs, out, many)
            return self._of_any_types(inputs, out, many)
        first = inputs[mix.first]
        shape, dtype, alike = first.shape, first.dtype, True
        if (dtype is not DOUBLE and (dtype is not SINGLE or not mix.weak)) or not shape:
            return self._of_any_types(inputs, out, many)
        for k in mix.rest:
            x = inputs[k]
            if x.dtype is not dtype:
                return self._of_any_types(inputs, out, many)
            if (own := x.shape) != shape:
                if not own:
                    return self._of_any_types(inputs, out, many)
                alike = False
        if not mix.plain:
            inputs = [x if type(x) is ndarray else float(x) for x in inputs]
        size = first.size if alike else 0
        found = mix.plans.get((dtype, many or size > FEW)) if alike else None
        if found is None:
            patterns, full = mix.patterns, 1
            if not alike:
                shape, patterns, full = _aligned(tuple([x.shape if type(x) is ndarray else () for x in inputs]))
                size = prod(shape)
            found = self.plan(many or size > FEW, patterns, full, dtype)
            if alike:
                mix.plans[dtype, many or size > FEW] = found
        given = None if out is None else fitting(out, len(self.said.outputs), shape, dtype)
        if given is None and not found.uneven and found.handful < size <= SMALL:
            try:
                return found.whole(*inputs)
            except UNDEFINED:  # in what only numbers have part in
                return self._of_whole_arrays(inputs, shape, dtype, None, many)
        return self._computed(found, inputs, shape, dtype, given, one_by_one=alike and not many)

    def _mix(self, kinds: tuple[type, ...]) -> _Mix:
        """What is known of arguments of these types; the first time."""
        self._mixes[kinds] = mix = _Mix(kinds)
        return mix

    def _of_numbers(self, inputs: Sequence[Any], plain: bool) -> Results:
        """The results at one point of numbers of several types; OverflowError where NumPy is to warn."""
        found: Any = self.formula(*map(float, inputs))
        return found if plain else _doubles(found)

    def _of_quantities(self, inputs: Sequence[Any], out: Out, many: bool) -> Any:
        """The results with their units, of quantities in any units of the same dimensions."""
        values, registry = in_units(self.said, inputs)
        if out is not None:
            raise ValueError(f"{self.said.name}: out= is for plain arrays, which keep no unit; leave it out")
        return with_units(self.said, self.of_anything(values, many=many), registry)

    def _of_any_types(self, inputs: Sequence[Any], out: Out, many: bool) -> Results:
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
        found = self.plan(many or size > FEW, patterns, full, dtype)
        return self._computed(found, values, shape, dtype, given, one_by_one=not many and {*patterns} <= {None, full})

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
            if given is None and not found.uneven:
                return found.whole(*values)
            return self._at_once(found, values, shape, dtype, given)
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

    def _at_once(
        self,
        found: Plan,
        values: Sequence[Any],
        shape: tuple[int, ...],
        dtype: DType,
        given: Sequence[Array] | None,
    ) -> Results:
        """The results of small arrays, in the arrays that are given, or where not all outputs have the whole shape."""
        results = found.whole(*values)
        several = results if isinstance(results, tuple) else (results,)
        if given is not None:  # to be written to last, as they may share memory with the arguments
            return _one_or_tuple(_put(several, given))
        whole = [*several]
        for places in found.uneven:
            x = _filled(several[places[0]], shape, dtype)
            for place in places:
                whole[place] = x
        return _one_or_tuple(whole)

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
        ready = values if given is None else _apart(values, given)
        if found.prelude:
            ready = found.prelude(*ready)
        into = [outputs[k] for k in found.full]
        taken = ready[: found.taken]
        if into and all(x.shape in (shape, ()) for x in taken):
            _run(found.block, found.registers, taken, into, shape, dtype)
        elif into:
            _run_parts(found.block, found.registers, taken, into, shape, dtype)
        for k, value in zip([k for k in distinct if k not in found.full], ready[found.taken :], strict=True):
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
            return self._at_once(found, whole, shape, dtype, given)
        return self._in_pieces(found, [array(x, dtype) if type(x) is float else x for x in values], shape, dtype, given)


@cache
def _call(count: int, arithmetic: bool) -> CodeType:
    """The code of a call with so many arguments, whose names are replaced.

    arithmetic  whether the formula calls no function: then it takes NumPy's numbers as they are, in less time
    """
    inputs = [f"x{k}" for k in range(count)]
    types, dtypes, shapes = (
        form.join(text.format(x) for x in inputs)
        for form, text in ((" is ", "type({})"), (" is ", "{}.dtype"), (" == ", "{}.shape"))
    )
    space: dict[str, Any] = {}
    floats = ", ".join(inputs if arithmetic else (f"float({x})" for x in inputs))
    of_doubles = f"formula({floats})" if arithmetic else f"doubles(formula({floats}))"
    exec(CALL.format(inputs=", ".join(inputs), of_doubles=of_doubles, types=types, dtypes=dtypes, shapes=shapes), space)
    code: CodeType = space["call"].__code__
    return code


def _doubles(found: Any) -> Any:
    """The results of a formula as NumPy's; OverflowError where NumPy is to warn."""
    if type(found) is float:
        if not isfinite(found):
            raise OverflowError
        return np.float64(found)
    if not isfinite(sum(found)):
        raise OverflowError
    return tuple([np.float64(x) for x in found])


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
        whole = (1,) * (len(shape) - len(own)) + own
        patterns.append(sum(1 << k for k, n in enumerate(shape) if whole[k] == n) if own else None)
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


def fitting(out: Any, outputs: int, shape: tuple[int, ...], dtype: Any) -> list[Any]:
    """The arrays of `out`; ValueError if they are not as many as the outputs, or do not fit."""
    results = list(out) if isinstance(out, (tuple, list)) else [out]
    if len(results) != outputs:
        raise ValueError(f"out has {len(results)} arrays; this kernel has {outputs} outputs")
    for each in results:
        if not isinstance(each, np.ndarray) or each.shape != shape or each.dtype != dtype:
            found = f"{each.shape} {each.dtype}" if isinstance(each, np.ndarray) else type(each).__name__
            raise ValueError(f"out is {found}; an array of shape {shape} and type {dtype} is needed")
    own = outputs == 1 or (len({*map(id, results)}) == outputs and all(x.flags.owndata for x in results))
    if not own and any(np.shares_memory(x, y) for x, y in combinations(results, 2)):
        raise ValueError("two arrays of out share memory; each output needs memory of its own")
    return results


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
    rows = _registers(registers, dtype)
    for part in _parts(shape):
        into = [output[part] for output in outputs]
        own = [row[: into[0].size].reshape(into[0].shape) for row in rows]
        pieces = [x if x.dtype == dtype else x.astype(dtype) for x in (_part(x, part) for x in aligned)]
        block(*pieces, *into, *own)


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
