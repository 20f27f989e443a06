"""Quantities of pint that go into kernels and come out: converted to the units that a kernel declares.

Nothing here imports pint: who has a quantity has imported it. Kernels of plain numbers and arrays never come here.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Sequence
from typing import Any

from symcheck.kernels.specification import Argument, Output, Specification

# A number of units of something else, such as "units of h_max^3" or "units of h_max/(kg m^2)": what it is one of is 1.
_RELATIVE = re.compile(r"units of \w+(\^\d+)?")


def is_quantity(kind: type) -> bool:
    """Is it a type of quantities of pint?"""
    pint = sys.modules.get("pint")
    return pint is not None and issubclass(kind, pint.Quantity)


def in_units(said: Specification, inputs: Sequence[Any]) -> tuple[list[Any], Any]:
    """The numbers and arrays in the units of the arguments, and the registry of the quantities.

    ValueError where a quantity measures something else, or a plain number stands for an argument that has a unit.
    """
    registry = next(x._REGISTRY for x in inputs if is_quantity(type(x)))
    return [_plain(said, argument, x, registry) for argument, x in zip(said.arguments, inputs, strict=True)], registry


def _plain(said: Specification, argument: Argument, x: Any, registry: Any) -> Any:
    unit = _unit(said, argument, registry)
    if not is_quantity(type(x)):
        if not unit.dimensionless:
            raise ValueError(
                f"{said.name}: {argument.name} is a plain number, and other arguments are quantities; give it with a "
                f"unit, such as {argument.unit}"
            )
        return x
    if "rad" in argument.unit and "hertz" in str(x.units):
        raise ValueError(
            f"{said.name}: {argument.name} is in {x.units}: turns or radians? Give it in rad/s, or in turn/s"
        )
    if not x.is_compatible_with(unit):
        raise ValueError(
            f"{said.name}: {argument.name} is in {x.units}, which measures {x.dimensionality}; it is wanted in "
            f"{argument.unit}"
        )
    return x.m_as(str(unit))  # in its own registry


def _unit(said: Specification, each: Argument | Output, registry: Any) -> Any:
    try:
        return registry.parse_units(_RELATIVE.sub("1", each.unit))
    except Exception as error:  # whatever a unit such as (rad/s)^m makes the parser of another project raise
        raise ValueError(
            f"{said.name}: {each.name} is in {each.unit}, which is no unit of its own; pass numbers without units"
        ) from error


def with_units(said: Specification, results: Any, registry: Any) -> Any:
    """The results of a kernel as quantities in the units of its outputs."""
    several: Iterable[Any] = results if isinstance(results, tuple) else (results,)
    found = tuple(
        registry.Quantity(x, _unit(said, output, registry)) for x, output in zip(several, said.outputs, strict=True)
    )
    return found if isinstance(results, tuple) else found[0]
