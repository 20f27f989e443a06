"""Kernels of a paper that run as compiled code: in C, by the machine's compiler, or by Numba.

What is compiled stays in the user's cache, under the digest of all it depends on; a library whose own digest differs
from the one beside it is made anew.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import platform
import shutil
import subprocess
import sys
import warnings
from collections.abc import Callable, Mapping, Sequence
from functools import cache, update_wrapper
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from math import prod
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType
from typing import Any

import numpy as np
from platformdirs import user_cache_path

from symcheck.core.extras import installing
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.calling import NUMBERS, fitting
from symcheck.kernels.runtime import DOUBLE, Array, Ways
from symcheck.kernels.specification import KernelFunction

ENGINES = ("numpy", "numba", "c")
FLAGS = (
    "-std=c99",
    "-O3",
    "-march=native",
    *(["-mprefer-vector-width=512"] if platform.machine() in ("x86_64", "AMD64") else []),
    "-fopenmp-simd",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-shared",
    "-fPIC",
)
LEAST = 1000  # points from which a call of C takes less time than one of NumPy
PIECE = 4096  # points that are copied at once where arrays are not as compiled code takes them
LIMIT = 120  # seconds for the compiler


def compiled_module(module: ModuleType, engine: str) -> ModuleType:
    """A module like a generated one, whose kernels another engine runs; the module itself, and a warning, without it.

    SymcheckError if there is no engine of that name.
    """
    if engine not in ENGINES:
        raise SymcheckError(f"engine = {engine!r} must be one of {', '.join(map(repr, ENGINES))}")
    if engine == "numpy":
        return module
    if missing := _missing(engine):
        warnings.warn(f"{missing}; the kernels run in NumPy meanwhile", RuntimeWarning, stacklevel=3)
        return module
    own: Mapping[str, KernelFunction] = vars(module)["KERNELS"]
    made = _by_numba(module, own) if engine == "numba" else {name: _in_c(kernel) for name, kernel in own.items()}
    found = ModuleType(module.__name__, module.__doc__)
    vars(found).update(vars(module) | made | {"KERNELS": made})
    return found


def _missing(engine: str) -> str:
    """What an engine lacks here, in words."""
    if engine == "numba":
        return "" if find_spec("numba") else f"Numba is not installed: {installing('numba')}"
    return "" if _compiler() else "there is no C compiler: install GCC or Clang, or name one in $CC"


def _compiler() -> str | None:
    return next(filter(None, map(shutil.which, filter(None, (os.environ.get("CC"), "cc", "gcc", "clang")))), None)


def _folder() -> Path:
    return user_cache_path("symcheck") / "kernels"


# --- Numba


def _by_numba(module: ModuleType, kernels: Mapping[str, KernelFunction]) -> dict[str, KernelFunction]:
    from symcheck.kernels.codegen import numba_target, traced

    key = module.__name__.rpartition(".")[2]
    text = numba_target.files(key, {name: traced.compiled(kernel) for name, kernel in kernels.items()})[f"{key}.py"]
    file = _folder() / f"symcheck_{key}_{_digest(text)}.py"
    if not file.is_file() or file.read_text(encoding="utf-8") != text:
        _write(file, text.encode())
    spec = spec_from_file_location(file.stem, file)
    assert spec
    assert spec.loader
    sys.modules[spec.name] = found = module_from_spec(spec)  # what Numba keeps names the module it is of
    spec.loader.exec_module(found)
    for name, kernel in kernels.items():
        own: Any = getattr(found, name)
        own.__doc__, own.specification, own.ways = kernel.__doc__, kernel.specification, kernel.ways
    return {name: getattr(found, name) for name in kernels}


# --- C


def _in_c(kernel: KernelFunction) -> KernelFunction:
    """A kernel whose arrays of LEAST points or more go through C: for each mix of numbers and arrays its own loop."""
    ways: Ways = kernel.ways
    names = [argument.name for argument in ways.said.arguments]

    def call(*arguments: Any, out: Any = None, **named: Any) -> Any:
        inputs: Sequence[Any] = arguments
        if named or len(arguments) != len(names):
            inputs = [*arguments, *(named[name] for name in names[len(arguments) :] if name in named)]
            if len(inputs) != len(names) or len(arguments) + len(named) != len(names):
                return kernel(*arguments, out=out, **named)  # which says what is missing
        uniform = tuple([type(x) in NUMBERS for x in inputs])
        shape, dtype, ready = _common(inputs)
        if prod(shape) < LEAST or (loop := _loop(ways, uniform)) is None:
            return kernel(*inputs, out=out)
        order = ways.order
        first = [order.index(k) for k in range(max(order) + 1)]
        given = None if out is None else fitting(out, len(order), shape, dtype)
        values = [*inputs]
        if not ready or True in uniform:
            values = [float(x) if number else np.asarray(x) for x, number in zip(inputs, uniform, strict=True)]
        for y in given or ():
            own = y.flags.owndata
            values = [x.copy() if type(x) is not float and _shared(x, y, own) else x for x in values]
        results = [np.empty(shape, dtype) if given is None else given[k] for k in first]
        if ready and (given is None or all(x.flags.carray for x in results)):
            loop(results[0].size, *[x if type(x) is float else _address(x) for x in (*values, *results)])
        else:
            _run_pieces(loop, values, results)
        for each, k in zip(given or (), order, strict=False):
            if each is not results[k]:
                each[...] = results[k]
        every = [results[k] for k in order] if given is None else given
        return every[0] if len(every) == 1 else tuple(every)

    update_wrapper(call, kernel)
    found: KernelFunction = call  # type: ignore[assignment]
    return found


def _shared(x: Array, y: Array, own: bool) -> bool:
    """Whether two arrays share memory, of which the second has its own or not."""
    return x is y or (not (own and x.flags.owndata) and np.may_share_memory(x, y))


def _address(x: Any) -> int:
    """Where an array lies; what is asked of NumPy takes fifteen times as long (measured)."""
    return ctypes.addressof(ctypes.c_char.from_buffer(x)) if x.flags.writeable else int(x.ctypes.data)


def _common(inputs: Sequence[Any]) -> tuple[tuple[int, ...], Any, bool]:
    """The shape and type of the results, and whether all arrays are as compiled code takes them."""
    shape = None
    for x in inputs:
        if type(x) is np.ndarray:
            if x.dtype is not DOUBLE or (shape is not None and x.shape != shape) or not x.flags.carray:
                break
            shape = x.shape
        elif type(x) not in NUMBERS:
            break
    else:
        if shape is not None:
            return shape, DOUBLE, True
    single = np.result_type(*inputs) == np.float32
    return np.broadcast_shapes(*map(np.shape, inputs)), np.dtype(np.float32) if single else DOUBLE, False


def _run_pieces(loop: Callable[..., None], values: Sequence[Any], results: Sequence[Array]) -> None:
    """The loop over pieces, which are copied where they are not as it takes them."""
    places = [k for k, x in enumerate(values) if type(x) is not float]
    arrays = [*(values[k] for k in places), *results]
    given = [*values]
    chunks: Any = np.nditer  # its types know neither `with` nor lists of modes
    modes = [["readonly", "contig", "aligned"]] * len(places) + [["writeonly", "contig", "aligned"]] * len(results)
    flags = ["external_loop", "buffered", "zerosize_ok", "delay_bufalloc"]
    kinds = [DOUBLE] * len(modes)
    with chunks(arrays, flags, modes, kinds, casting="same_kind", buffersize=PIECE) as iterator:
        iterator.reset()
        for chunk in iterator:
            for k, piece in zip(places, chunk, strict=False):
                given[k] = _address(piece)
            loop(chunk[0].size, *given, *map(_address, chunk[len(places) :]))


_loops: dict[tuple[str, str, tuple[bool, ...]], Any] = {}


def _loop(ways: Ways, uniform: tuple[bool, ...]) -> Any:
    """The loop for arrays and numbers of such a mix; None, and a warning, if it does not compile."""
    key = ways.said.paper, ways.said.name, uniform
    if key not in _loops:
        try:
            _loops[key] = _compiled_loop(ways, uniform)
        except (OSError, subprocess.SubprocessError) as error:
            why = getattr(error, "stderr", "") or str(error)
            said = f"{ways.said.name} does not compile ({why.strip().splitlines()[0]}); it runs in NumPy"
            warnings.warn(said, RuntimeWarning, stacklevel=3)
            _loops[key] = None
    return _loops[key]


def _compiled_loop(ways: Ways, uniform: tuple[bool, ...]) -> Any:
    from symcheck.kernels.codegen import c_target, traced

    said, trace = ways.said, ways.traced()
    outputs = dict(zip(trace.outputs, (each.name for each in said.outputs), strict=True))  # equal ones have one array
    distinct = trace._replace(outputs=tuple(outputs))
    whole = traced.program(distinct, [each.name for each in said.arguments], outputs.values())
    numbers = [each.name for each, number in zip(said.arguments, uniform, strict=True) if number]
    text = c_target.alone(said.paper, said.name, whole, numbers)
    loop = getattr(_library(text), f"{said.paper}_{said.name}")
    kinds = [ctypes.c_double if number else ctypes.c_void_p for number in uniform]
    loop.argtypes, loop.restype = [ctypes.c_size_t, *kinds, *[ctypes.c_void_p] * len(outputs)], None
    return loop


def _library(text: str) -> ctypes.CDLL:
    """The library of a text: from the cache, or compiled."""
    compiler = _compiler()
    if compiler is None:
        raise OSError("there is no C compiler")
    file = _folder() / f"{_digest(text, *FLAGS, _version(compiler), _processor())}.so"
    mark = file.with_suffix(".sha256")
    if not (file.is_file() and mark.is_file() and mark.read_text(encoding="ascii") == _digest(file.read_bytes())):
        with TemporaryDirectory(prefix="symcheck-c-") as folder:
            source, library = Path(folder, "kernel.c"), Path(folder, "kernel.so")
            source.write_text(text, encoding="utf-8")
            command = [compiler, *FLAGS, str(source), "-o", str(library), "-lm"]
            subprocess.run(command, check=True, capture_output=True, text=True, timeout=LIMIT)
            made = library.read_bytes()
        _write(file, made)
        _write(mark, _digest(made).encode())
    return ctypes.CDLL(str(file))


@cache
def _version(compiler: str) -> str:
    return subprocess.run([compiler, "--version"], check=True, capture_output=True, text=True, timeout=LIMIT).stdout


@cache
def _processor() -> str:
    """What -march=native depends on."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    known = [line for line in lines if line.startswith(("model name", "flags", "Features", "CPU part"))]
    return "\n".join([platform.machine(), platform.processor(), *dict.fromkeys(known)])


def _digest(*parts: str | bytes) -> str:
    found = hashlib.sha256()
    for part in parts:
        found.update(part if isinstance(part, bytes) else part.encode())
        found.update(b"\0")
    return found.hexdigest()[:32]


def _write(file: Path, content: bytes) -> None:
    """The content in a file that others never see half-written."""
    file.parent.mkdir(parents=True, exist_ok=True)
    new = file.with_name(f"{file.name}.{os.getpid()}")
    new.write_bytes(content)
    new.replace(file)
