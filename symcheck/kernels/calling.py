"""What a call does first, written out for each number of arguments and each mix of their types.

A formula of ten operations takes a microsecond or two, and a loop over its arguments that looks at types, shapes and
memory would take as long again. What is found out of a mix when it is first met is kept in the names of its function.
NumPy and the standard library alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial
from itertools import combinations
from math import isfinite
from types import CodeType, FunctionType
from typing import Any

import numpy as np
from numpy import array, ndarray

# What `math` raises where NumPy gives infinity or NaN, and warns.
UNDEFINED: tuple[type[Exception], ...] = (ValueError, ZeroDivisionError, OverflowError)
PLAIN = frozenset({float, int})
NUMBERS = PLAIN | {np.float64, np.int64, np.int32}
LIBRARIES = frozenset(
    {"cupy", "jax", "jaxlib", "torch"}
)  # whose types of arrays do not all have what the standard asks
CALL = """def call({inputs}, out=None):
    if out is None and float is {types}:
        try:
            return formula({inputs})
        except UNDEFINED:
            pass
    elif ndarray is {types}:
        return of_arrays({inputs}, out)
    kinds = {kinds}
    return (ways.get(kinds) or way(kinds))({inputs}, out)
"""
OF_NUMBERS = """def of_numbers({inputs}, out):
    if out is None:
        try:
            {body}
        except UNDEFINED:
            pass
    return others({inputs}, out)
"""
OF_ARRAYS = """def of_arrays({inputs}, out):
    if KIND is {dtypes}:
        if {alike}:
            size, into = {first}.size, None
            try:
                if few < size <= most:
                    if out is None:
                        return of_few({values})
                    into = into_few
                elif less < size <= more:
                    if out is None:
                        return of_many({values})
                    into = into_many
                elif size == 1 and {first}.shape == (1,):
                    if out is None:
                        {results} = formula({items})
                        if isfinite({total}):
                            {made}
                            return {singles}
                    else:
                        into = of_single
                elif 0 < size <= few and {first}.ndim:
                    if out is None:
                        return of_handful({values})
                    into = of_handful
                if into and {several}:
                    {given}, = {out}
                    if {fits}:
                        into({values}, {into})
                        {copies}
                        return {handed}
            except UNDEFINED:
                pass
            return of_one_shape(({values},), out)
        found = known.get({every_shape}) if out is None else None
        if found:
            try:
                return found({values})
            except UNDEFINED:
                pass
        return of_shapes(({values},), out)
    return others({inputs}, out)
"""
OF_SINGLE = """def of_single({inputs}, {into}):
    {results} = formula({items})
    if not isfinite({total}):
        raise OverflowError
    {stores}
"""
Space = dict[str, Any]


def is_foreign(kind: type) -> bool:
    """Whether it is a type of arrays of another library of the array API standard: JAX, PyTorch, CuPy and others."""
    if issubclass(kind, (ndarray, np.generic)):
        return False
    return hasattr(kind, "__array_namespace__") or any(
        x.__module__.partition(".")[0] in LIBRARIES for x in kind.__mro__
    )


def call_of(name: str, names: Sequence[str], space: Space) -> Any:
    """The function of a kernel: of floats the `formula` of the space, of arrays alone its `of_arrays`.

    Of any other mix it is what `ways` has under the types of the arguments, or what `way` finds for them.
    """
    code = _code(len(names)).replace(co_varnames=(*names, "out", "kinds"), co_name=name, co_qualname=name)
    return FunctionType(code, space | {"UNDEFINED": UNDEFINED, "ndarray": ndarray}, name, (None,))


@cache
def _code(count: int) -> CodeType:
    """The code of a call with so many arguments, whose names are replaced."""
    inputs = [f"x{k}" for k in range(count)]
    types = [f"type({x})" for x in inputs]
    made: Any = _made(CALL, {}, inputs=inputs, types=" is ".join(types), kinds=f"({', '.join(types)},)")
    code: CodeType = made.__code__
    return code


def of_numbers(kinds: Sequence[type], order: Sequence[int], space: Space) -> Callable[..., Any]:
    """What numbers of several types go through: a `formula` of floats, or `others` where NumPy is to warn.

    `order` says of each output which of the distinct results it is.
    """
    body = f"return formula({', '.join(_values(kinds))})"
    if not PLAIN.issuperset(kinds):
        results, firsts, distinct = _outputs(order)
        doubles = "; ".join(f"z{n} = float64(y{n})" for n in distinct)
        body = (
            f"{', '.join(results)} = {body[7:]}\n            "
            f"if isfinite({' + '.join(f'y{n}' for n in distinct)}):\n                "
            f"{doubles}; return {', '.join(f'z{n}' for n in firsts)}"
        )
    space |= {"float64": np.float64, "isfinite": isfinite}
    return _made(OF_NUMBERS, space, inputs=_inputs(kinds), body=body)


def _outputs(order: Sequence[int]) -> tuple[list[str], list[int], list[int]]:
    """A name for each output, for each which is the first with its result, and which those are."""
    firsts = [order.index(k) for k in order]
    return [f"y{n}" for n in range(len(order))], firsts, [n for n, first in enumerate(firsts) if n == first]


def of_arrays(kinds: Sequence[type], dtype: np.dtype[Any], order: Sequence[int], space: Space) -> Callable[..., Any]:
    """What arrays of one type with numbers beside them go through, which keeps what it learns in `space`.

    Of the space `formula` is for a single point, `of_handful` for a handful of points, `of_one_shape` for arrays of one
    shape whose function is not known yet, or that are large, `of_shapes` for arrays that broadcast, and `others` for
    arrays of another type. `order` says of each output which of the distinct results it is.
    """
    inputs = _inputs(kinds)
    arrays = [x for x, kind in zip(inputs, kinds, strict=True) if kind is ndarray]
    shapes = [f"{x}.shape" for x in arrays]
    space |= {"few": 0, "most": 0, "less": 0, "more": 0, "into_few": None, "into_many": None}
    space |= {"KIND": dtype, "isfinite": isfinite, "ndarray": ndarray}
    space["array"] = array if dtype == np.float64 else partial(array, dtype=dtype)
    count, (results, firsts, distinct) = len(order), _outputs(order)
    values, given = _values(kinds), [f"g{n}" for n in range(count)]
    parts: dict[str, str | list[str]] = {
        "inputs": inputs,
        "into": [given[n] for n in distinct],
        "results": results,
        "items": [f"{x}.item()" if kind is ndarray else y for x, kind, y in zip(inputs, kinds, values, strict=True)],
        "total": " + ".join(f"y{n}" for n in distinct),
        "stores": "; ".join(f"g{n}[0] = y{n}" for n in distinct),
    }
    _made(OF_SINGLE, space, **parts)
    return _made(
        OF_ARRAYS,
        space,
        **parts,
        values=values,
        dtypes=" is ".join(f"{x}.dtype" for x in arrays),
        alike=" == ".join(shapes) if len(shapes) > 1 else "True",
        every_shape=f"({', '.join(shapes)},)",
        first=arrays[0],
        arrays=arrays,
        made="; ".join(f"z{n} = array([y{n}])" for n in distinct),
        singles=[f"z{n}" for n in firsts],
        given=given,
        several="True" if count == 1 else "(type(out) is tuple or type(out) is list)",
        out="out if type(out) is tuple else (out,)" if count == 1 else "out",
        fits=_fits(given, arrays),
        copies="; ".join(f"g{n}[...] = g{first}" for n, first in enumerate(firsts) if n != first) or "pass",
        handed=given,
    )


def _fits(given: Sequence[str], arrays: Sequence[str]) -> str:
    """Whether a glance shows that the arrays given fit, and that nothing else lies in their memory, as text."""
    types = " is ".join(["ndarray", *(f"type({x})" for x in given)])
    dtypes = " is ".join(["KIND", *(f"{x}.dtype" for x in given)])
    shapes = " == ".join([f"{arrays[0]}.shape", *(f"{x}.shape" for x in given)])
    found = [types, dtypes, shapes, *(f"{x}.flags.owndata" for x in given)]
    apart = f"{{}} is not {given[0]}"
    if len(given) > 1:
        found.append(f"len(places := {{{', '.join(f'id({x})' for x in given)}}}) == {len(given)}")
        apart = "id({}) not in places"
    for x in arrays:
        owner = f"type(owner) is ndarray and owner.base is None and {apart.format('owner')}"
        found += [apart.format(x), f"((owner := {x}.base) is None or {owner})"]
    return " and ".join(found)


def _made(text: str, space: Space, **parts: str | Iterable[str]) -> Callable[..., Any]:
    """The function of a text, with its parts put in; `space` is what it calls by name, and its own."""
    filled = {name: part if isinstance(part, str) else ", ".join(part) for name, part in parts.items()}
    space["UNDEFINED"] = UNDEFINED
    exec(text.format_map(filled), space)  # our own text, of names chosen above
    made: Callable[..., Any] = space[text[4 : text.index("(")]]
    return made


def _inputs(kinds: Sequence[type]) -> list[str]:
    return [f"x{k}" for k in range(len(kinds))]


def _values(kinds: Sequence[type]) -> list[str]:
    """The arguments, with numbers as floats."""
    return [f"x{k}" if kind in (float, ndarray) else f"float(x{k})" for k, kind in enumerate(kinds)]


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
