"""Sweeps: a function on the outer product of its parameters, in chunks, on threads or a cluster, to a file.

A TOML file describes the sweep:

    function = "liquid.growth_rate"

    [parameters]
    A = 1.0                                            # a number
    C = { start = 0.1, stop = 2.0, count = 500 }       # an axis of the result, scale = "log" if wanted
    omega_0 = [0.5, 1.0, 2.0]                          # another one
    E_n = [0.2]                                        # a vector, whose components may be axes
    lambda_n = [{ start = -1.0, stop = 1.0, count = 200 }]

A parameter may be the result of a function itself, `axes = { function = "wheels.four_wheels", a = 0.9, b = [...] }`;
wheels may fail, `failures = [[], [0], [0, 1]]`; and with `seed = 1` and `realizations = 1000` parameters may be random,
`a = { normal = [0.9, 0.01] }`, and ensembles be swept, as "random_rotation.simulate".
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from importlib.util import find_spec
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING

from symcheck.core.extras import installing
from symcheck.numeric.sweep.functions import SweepError, code

if TYPE_CHECKING:
    from symcheck.numeric.sweep.plan import Plan
    from symcheck.numeric.sweep.store import Identity, Store
    from symcheck.numeric.sweep.workers import Workers

__all__ = ["SweepError", "sweep"]

NEEDED = {".zarr": ("xarray", "zarr", "filelock"), ".nc": ("xarray", "zarr", "filelock", "dask", "h5netcdf", "h5py")}
MOST = 10**6  # chunks: each is a file, and all of them are counted before the first is computed
Progress = Callable[[int, int], None]


def sweep(
    spec: Path,
    out: Path,
    *,
    scheduler: str | None = None,
    threads: int = 1,
    chunks: Mapping[str, int] | None = None,
    memory: float = 32e6,
    patience: float = 10.0,
    progress: Progress = lambda done, total: None,
) -> str:
    """Run a sweep, or go on with one that was stopped, and say what was done.

    Parameters
    ----------
    spec
        The TOML file.
    out
        Path FILE.zarr or FILE.nc; it appears when all is done, until then the sweep is in OUT.partial.zarr.
    scheduler
        Address of a dask.distributed scheduler; by default threads of this process compute.
    threads
        Number of threads.
    chunks
        Points of a chunk along the axes named; along others as many as fit in `memory`.
    memory
        Bytes of results in a chunk.
    patience
        Seconds to wait for the scheduler and for workers.
    progress
        Called with the number of chunks done and that of all chunks.

    Returns
    -------
    str
        One line that says what was done.

    Raises
    ------
    SweepError
        One line that says what does not fit, or what keeps it from going on.
    KeyboardInterrupt
        With a message that says what is kept.

    Notes
    -----
    Values do not depend on chunks, threads or workers, as long as these have processors of one kind.
    """
    _require(out, scheduler)
    from filelock import FileLock, Timeout

    from symcheck.numeric.sweep.plan import plan, read
    from symcheck.numeric.sweep.store import Store, writing
    from symcheck.numeric.sweep.workers import cluster
    from symcheck.numeric.sweep.workers import threads as local

    text, store = read(spec), Store(Path(os.path.realpath(out)) if out.is_symlink() else out)
    lock = FileLock(store.out.with_name(f"{store.out.name}.lock"), timeout=0)
    with writing(store.out):
        try:
            lock.acquire()
        except Timeout:
            raise SweepError(f"another sweep is writing {store.out}; wait for it, or name another --out") from None
        try:
            swept = plan(text)
            if store.is_finished(json.loads(text)):
                return f"{store.out} is finished already; nothing was computed"
            _prepare(text, swept, store, chunks or {}, memory)
            with cluster(scheduler, patience) if scheduler else local(threads) as workers:
                return _compute(text, swept, store, workers, progress)
        finally:
            with suppress(OSError):  # where the system lets an open file be removed
                Path(lock.lock_file).unlink()
            lock.release()


def _prepare(text: str, swept: Plan, store: Store, asked: Mapping[str, int], memory: float) -> None:
    """Set up the sweep, or continue the one that was begun."""
    from symcheck.numeric.sweep.store import Identity

    for name, length in asked.items():
        if name not in swept.sizes:
            raise SweepError(f"--chunk {name}={length}: the axes of the sweep are {', '.join(swept.sizes)}")
    try:
        results = swept.first()
    except (ValueError, ArithmeticError, MemoryError, TypeError, ImportError) as error:
        raise SweepError(_reason(swept, error)) from None
    is_complex = [name for name, array in results.items() if array.dtype.kind == "c"]
    if is_complex and store.out.suffix == ".nc":
        raise SweepError(f"{is_complex[0]} is complex, and netCDF has no complex numbers; take --out FILE.zarr")
    begun = store.begun()
    if begun is None or not store.has_chunks():
        lengths = _lengths(swept.sizes, asked, memory // max(1, sum(array.nbytes for array in results.values())))
        identity = Identity(json.loads(text), code(), lengths)
        store.begin(swept, results, identity)
    else:
        _require_same(begun, json.loads(text), asked, store)
        identity = begun
    store.open(swept, results, identity)


def _lengths(sizes: dict[str, int], asked: Mapping[str, int], room: float) -> dict[str, int]:
    """Chunks of the lengths asked for, else as long as this many points have room, the last axes first."""
    lengths: dict[str, int] = {}
    for axis, size in reversed(sizes.items()):
        lengths[axis] = asked.get(axis, max(1, min(size, int(room))))
        room //= lengths[axis]
    if (count := prod(-(-size // lengths[axis]) for axis, size in sizes.items())) > MOST:
        raise SweepError(f"the sweep has {count:,} chunks, more than {MOST:,}; take larger ones, or fewer points")
    return {axis: lengths[axis] for axis in sizes}


def _require_same(begun: Identity, spec: Mapping[str, object], asked: Mapping[str, int], store: Store) -> None:
    """The sweep that was begun is the one that is asked for."""
    there = f"remove {store.partial} to begin anew, or name another --out"
    if begun.spec != spec:
        names = sorted(name for name in {*begun.spec, *spec} if begun.spec.get(name) != spec.get(name))
        raise SweepError(f"{store.partial} is the beginning of another sweep ({', '.join(names)} differ); {there}")
    if begun.code != code():
        raise SweepError(f"{store.partial} was begun with another version of symcheck or NumPy; {there}")
    if asked.items() - begun.chunks.items():
        raise SweepError(
            f"the sweep was begun with chunks {begun.chunks}; leave --chunk out, or remove {store.partial}"
        )


def _compute(text: str, swept: Plan, store: Store, workers: Workers, progress: Progress) -> str:
    """Compute the chunks that are missing and finish."""
    from symcheck.numeric.sweep.workers import compute

    kept, count = len(store.done), len(store.parts)
    calls = ((k, (text, code(), part)) for k, part in enumerate(store.parts) if k not in store.done)
    progress(kept, count)
    try:
        with ThreadPoolExecutor(1) as writer:  # Ctrl-C does not cut off what another thread is writing
            for number, values in workers.completed(compute, calls):
                writer.submit(store.write, number, values).result()
                progress(len(store.done), count)
        store.finish()
    except KeyboardInterrupt:
        raise KeyboardInterrupt(f"; {store.progress()}") from None
    except (ValueError, ArithmeticError, MemoryError, ImportError) as error:
        raise SweepError(f"{_reason(swept, error)}; {store.progress()}") from None
    shape = " x ".join(f"{name} {size}" for name, size in swept.sizes.items())
    summary = f"{store.out}: {shape}, {count} chunks, {kept} of them from before"
    not_finite = sum(store.done.values())
    return f"{summary}; {not_finite} values are infinite or not a number" if not_finite else summary


def _reason(swept: Plan, error: Exception) -> str:
    return str(error) if isinstance(error, SweepError) else f"{swept.function}: {error or type(error).__name__}"


def _require(out: Path, scheduler: str | None) -> None:
    """The file can be written, and the packages for it are installed."""
    if out.exists() and not (out.is_file() or out.is_dir()):
        raise SweepError(f"--out {out} is a device or a pipe; name a file, in which parts can be sought")
    if out.suffix not in NEEDED:
        raise SweepError(f"--out {out} must end with .zarr or .nc")
    if not out.absolute().parent.is_dir():
        raise SweepError(f"--out {out}: there is no folder {out.parent}")
    needed = (*NEEDED[out.suffix], *(("distributed",) if scheduler else ()))
    missing = [name for name in needed if find_spec(name) is None]
    if missing:
        raise SweepError(f"a sweep needs {', '.join(missing)}; run `{installing('sweep')}`")
