"""Array kernels on a GPU: time per point, and how much of the memory bandwidth they reach. Run by `make bench-gpu`.

    symcheck generate --target array --output FOLDER
    python tests/bench_gpu.py FOLDER [--device cpu] [--points N] [--kernels WORD] [--libraries NAME ...]

It needs the folder, array-api-compat, rich, and at least one of PyTorch, JAX and CuPy, not symcheck itself. What is
missing is told, with the way to get it. The fused forms (torch.compile, jax.jit) are the ones to judge: they read each
argument and write each result once, so that memory is their limit. `--device cpu` runs the same code without a GPU.
"""

from __future__ import annotations

import argparse
import importlib
import os
import runpy
import statistics
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from inspect import signature
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table

ROUNDS, REPEATS = 7, 10  # runs of each form, in turn; calls in a run, with one wait at the end
POINTS = {"cuda": 10_000_000, "cpu": 100_000}
CACHES = {"cuda": 256_000_000, "cpu": 0}  # bytes of arguments that are gone through in turn: no cache holds them
LOW, HIGH = 0.1, 1.2  # arguments: also angles that are less than a quarter turn
PIP = {"torch": "torch", "jax": "jax[cuda13]", "cupy": "cupy-cuda13x"}


class MissingError(Exception):
    """A library cannot compute on the device, for this reason."""


@dataclass(frozen=True)
class Library:
    """put: an array, from NumPy; wait: until some results are there; copy: an array; forms: how kernels are called."""

    name: str
    put: Callable[[Any], Any]
    wait: Callable[[Any], Any]
    copy: Callable[[Any], Any]
    forms: dict[str, Callable[[Any], Callable[..., Any]]]


def eager(function: Callable[..., Any]) -> Callable[..., Any]:
    return function


def torch(device: str) -> Library:
    import torch

    if device == "cuda" and not torch.cuda.is_available():
        build = f"built for CUDA {torch.version.cuda}" if torch.version.cuda else "built without CUDA"
        raise MissingError(f"PyTorch {torch.__version__}, {build}, finds no CUDA GPU")
    return Library(
        "torch",
        lambda x: torch.asarray(x, device=device),
        lambda _: torch.cuda.synchronize() if device == "cuda" else None,
        lambda x: x.clone(),
        {"torch": eager, "torch.compile": lambda f: torch.compile(f, fullgraph=True, dynamic=False)},
    )


def jax(device: str) -> Library:
    os.environ.setdefault("XLA_PYTHON_CLIENT_PREALLOCATE", "false")  # other libraries need memory too
    import jax

    jax.config.update("jax_enable_x64", True)
    try:
        place = jax.devices(device)[0]
    except RuntimeError as error:
        raise MissingError(f"JAX {jax.__version__} finds no {device} device ({str(error).splitlines()[0]})") from error
    copy = jax.jit(jax.numpy.copy)
    return Library("jax", lambda x: jax.device_put(x, place), jax.block_until_ready, copy, {"jax.jit": jax.jit})


def cupy(device: str) -> Library:
    import cupy

    if device != "cuda":
        raise MissingError("CuPy computes on GPUs only")
    try:
        cupy.cuda.runtime.getDeviceCount()
    except cupy.cuda.runtime.CUDARuntimeError as error:
        raise MissingError(f"CuPy {cupy.__version__} finds no CUDA GPU ({error})") from error
    wait = cupy.cuda.get_current_stream().synchronize
    return Library("cupy", cupy.asarray, lambda _: wait(), cupy.copy, {"cupy": eager})


LIBRARIES = {"torch": torch, "jax": jax, "cupy": cupy}


def libraries(names: list[str], device: str) -> Iterator[Library]:
    """Those that can compute on the device; why the others cannot is printed."""
    for name in names:
        try:
            importlib.import_module("array_api_compat")
            yield LIBRARIES[name](device)
        except MissingError as error:
            print(
                f"{name}: {error}. A GPU needs NVIDIA's driver (`nvidia-smi` lists it) and pip install '{PIP[name]}'."
            )
        except ModuleNotFoundError as error:
            module = error.name or name
            print(f"{name}: {module} is not installed; pip install '{PIP.get(module, module.replace('_', '-'))}'.")


def kernels(folder: Path, word: str) -> Iterator[tuple[str, Callable[..., Any]]]:
    """The kernels of a folder that was written by `symcheck generate --target array`, by name."""
    for file in sorted(folder.glob("*.py")):
        space = runpy.run_path(str(file))
        yield from ((name, space[name]) for name in space["__all__"] if word in name)


def arguments(count: int, points: int, dtype: Any, device: str) -> list[list[Any]]:
    """So many sets of arguments that no cache of the device holds them all."""
    rng = np.random.default_rng(2005)
    size = count * points * np.dtype(dtype).itemsize
    sets = 1 + CACHES[device] // size
    return [[rng.uniform(LOW, HIGH, points).astype(dtype) for _ in range(count)] for _ in range(sets)]


def runner(library: Library, function: Callable[..., Any], sets: list[list[Any]]) -> Callable[[], float]:
    """Seconds of one call, the mean of some that follow one another; the function is compiled and warm already."""
    turns = cycle([[library.put(x) for x in each] for each in sets])

    def run() -> float:
        library.wait(())
        begin = time.perf_counter()
        for _ in range(REPEATS):
            results = function(*next(turns))
        library.wait(results)
        return (time.perf_counter() - begin) / REPEATS

    run()
    return run


def medians(runs: dict[str, Callable[[], float]]) -> dict[str, float]:
    """The median of each run; in every round each runs once, in turn."""
    rounds = [{name: run() for name, run in runs.items()} for _ in range(ROUNDS)]
    return {name: statistics.median(each[name] for each in rounds) for name in runs}


def forms(found: list[Library], function: Callable[..., Any], sets: list[list[Any]]) -> dict[str, Callable[[], float]]:
    """A function in all its forms."""
    return {name: runner(library, form(function), sets) for library in found for name, form in library.forms.items()}


def measured(found: list[Library], chosen: list[Any], points: int, dtype: Any, device: str) -> Table:
    """A line for each kernel: bytes that it has to move, and of each form the nanoseconds and the share of a copy."""
    item = np.dtype(dtype).itemsize
    ones = arguments(1, points, dtype, device)
    copies = {library.name: runner(library, library.copy, ones) for library in found}
    of = {form: library.name for library in found for form in library.forms}
    table = Table("kernel", "bytes", *of, box=box.SIMPLE_HEAD)
    shares: dict[str, list[float]] = {form: [] for form in of}
    speeds: list[dict[str, float]] = []
    for name, function in chosen:
        count = len(signature(function).parameters)
        results = function(*(np.full(1, HIGH, dtype) for _ in range(count)))
        size = item * (count + len({id(x) for x in (results if isinstance(results, tuple) else (results,))}))
        runs = forms(found, function, arguments(count, points, dtype, device))
        seconds = medians({**runs, **{f"copy of {each}": copy for each, copy in copies.items()}})
        speeds.append({each: 2 * item * points / seconds[f"copy of {each}"] for each in copies})
        for form, library in of.items():
            shares[form].append(size * points / seconds[form] / speeds[-1][library])
        cells = (f"{seconds[form] / points * 1e9:.4f} ns {shares[form][-1]:>5.0%}" for form in of)
        table.add_row(name, str(size), *cells)
    table.add_row("geometric mean", "", *(f"{statistics.geometric_mean(each):.0%}" for each in shares.values()))
    moved = (f"{each} {statistics.median(speed[each] for speed in speeds) / 1e9:.1f} GB/s" for each in copies)
    table.title = f"{np.dtype(dtype)}, {points:,} points; a copy moves: {', '.join(moved)}"
    return table


def overhead(found: list[Library], name: str, function: Callable[..., Any]) -> str:
    """What a call costs without points: no time per point is told apart below it."""
    single = [[np.full(1, HIGH) for _ in signature(function).parameters]]
    said = (f"{form} {seconds * 1e6:.0f} us" for form, seconds in medians(forms(found, function, single)).items())
    return f"a call of {name} on one point: {', '.join(said)}"


def main() -> None:
    """Measure and print, or say what is missing."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folder", type=Path, help="what `symcheck generate --target array --output FOLDER` wrote")
    parser.add_argument("--device", choices=POINTS, default="cuda")
    parser.add_argument("--points", type=int, help="points of each call; 10^7 on a GPU")
    parser.add_argument("--kernels", default="", metavar="WORD", help="only those whose name contains it")
    parser.add_argument("--libraries", nargs="+", choices=LIBRARIES, default=list(LIBRARIES))
    asked = parser.parse_args()
    found = list(libraries(asked.libraries, asked.device))
    if not found:
        print(f"Nothing to measure on {asked.device}; --device cpu runs the same code without a GPU.")
        return
    chosen = list(kernels(asked.folder, asked.kernels))
    if not chosen:
        parser.error(f"no kernels in {asked.folder}: symcheck generate --target array --output {asked.folder}")
    np.seterr(all="ignore")
    warnings.filterwarnings("ignore", "Dynamo detected a call to a `functools.lru_cache`")  # of array-api-compat
    out = Console(width=150, highlight=False)
    out.print(overhead(found, *chosen[0]))
    for dtype in (np.float64, np.float32):
        out.print(measured(found, chosen, asked.points or POINTS[asked.device], dtype, asked.device))


if __name__ == "__main__":
    main()
