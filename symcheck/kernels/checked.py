"""Kernels that refuse what lies outside of their domain, where others compute whatever comes out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, update_wrapper
from math import pi
from types import CodeType, ModuleType
from typing import Any

import numpy as np

from symcheck.kernels.specification import Argument, KernelFunction, Specification

KNOWN = {"__builtins__": {}, "pi": pi, "sqrt": np.sqrt}  # what ends of domains are made of, beside arguments


def checked(kernel: KernelFunction) -> KernelFunction:
    """The kernel, with a look at its arguments: ValueError names the first that lies outside of its domain.

    >>> from symcheck.kernels import find
    >>> checked(find("ignatov2005", "volume_of_three_wheels"))(0.5, 2.0)
    Traceback (most recent call last):
        ...
    ValueError: volume_of_three_wheels: b = 2.0 must satisfy 0 < b < pi/2
    """
    said = kernel.specification
    names = [argument.name for argument in said.arguments]

    def call(*arguments: Any, **named: Any) -> Any:
        given = dict(zip(names, arguments, strict=False)) | named
        if given.keys() >= {*names}:  # else the kernel says what is missing
            _look(said, given)
        return kernel(*arguments, **named)

    update_wrapper(call, kernel)
    looking: KernelFunction = call  # type: ignore[assignment]
    return looking


def checked_module(module: ModuleType) -> ModuleType:
    """A module of kernels, all of them `checked`."""
    kernels: Mapping[str, KernelFunction] = vars(module)["KERNELS"]
    looking = {name: checked(kernel) for name, kernel in kernels.items()}
    copy = ModuleType(module.__name__, module.__doc__)
    vars(copy).update(vars(module) | looking | {"KERNELS": looking})
    return copy


def _look(said: Specification, given: Mapping[str, Any]) -> None:
    values = {argument.name: np.asarray(given[argument.name]) for argument in said.arguments}
    with np.errstate(all="ignore"):
        for argument in said.arguments:
            value = values[argument.name]
            inside = _inside(argument, values) & np.isfinite(value)
            if not inside.all():
                place = np.unravel_index(int(np.argmin(inside)), inside.shape)
                shown = np.broadcast_to(value, inside.shape)[place].item()
                where = f"[{', '.join(map(str, place))}]" if value.shape == inside.shape and place else ""
                asked = f"satisfy {argument.domain}" if argument.low or argument.high else "be a finite number"
                raise ValueError(f"{said.name}: {argument.name}{where} = {shown!r} must {asked}")


def _inside(argument: Argument, values: Mapping[str, Any]) -> Any:
    """Where an argument is between the ends of its domain, which may depend on others."""
    compare: Callable[..., Any] = np.less_equal if argument.closed else np.less
    value = values[argument.name]
    inside = np.ones(np.shape(value), bool)
    if argument.low:
        inside = inside & compare(_end(argument.low, values), value)
    if argument.high:
        inside = inside & compare(value, _end(argument.high, values))
    return inside


def _end(text: str, values: Mapping[str, Any]) -> Any:
    """An end of a domain. To evaluate it is no more than to import the module that says it, which is code itself."""
    return eval(_compiled(text), KNOWN, dict(values))


@cache
def _compiled(text: str) -> CodeType:
    return compile(text, "<end of a domain>", "eval")
