"""Kernels on arrays of JAX, PyTorch and other libraries of the array API standard, by the text written for these."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import numpy as np

from symcheck.core.extras import installing
from symcheck.kernels.calling import is_foreign
from symcheck.kernels.codegen import array_target, traced
from symcheck.kernels.specification import KernelFunction


def in_libraries(kernel: KernelFunction) -> Any:
    """The function of a kernel for arrays of any library of the array API standard, which can be traced.

    ImportError, which says how to install it, without array-api-compat.
    """
    if not find_spec("array_api_compat"):
        raise ImportError(
            f"arrays of other libraries than NumPy need array-api-compat: {installing('arrays')}",
            name="array_api_compat",
        )

    name, paper = kernel.specification.name, kernel.specification.paper
    text = array_target.files(paper, {name: traced.compiled(kernel)})[f"{paper}.py"]
    space: dict[str, Any] = {"__name__": f"symcheck_arrays_{paper}"}
    exec(compile(text, f"<{name} in libraries>", "exec"), space)  # our own text
    function = space[name]

    def call(*inputs: Any) -> Any:
        library = space["array_namespace"](*(x for x in inputs if is_foreign(type(x))))
        return function(*(library.asarray(x) if isinstance(x, np.ndarray) and x.ndim else _number(x) for x in inputs))

    return call


def _number(x: Any) -> Any:
    """NumPy's numbers, and arrays without dimensions, as Python's."""
    return x.item() if isinstance(x, (np.ndarray, np.generic)) else x
