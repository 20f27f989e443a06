"""Sweeps: a function on the outer product of its parameters, in chunks, on threads or a cluster, to a file.

The sweep is told by a TOML file:

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
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symcheck.numeric.sweep.functions import SweepError, code

if TYPE_CHECKING:
    from symcheck.numeric.sweep.chunks import Chunks
    from symcheck.numeric.sweep.spec import Plan
    from symcheck.numeric.sweep.store import Store
    from symcheck.numeric.sweep.workers import Workers

__all__ = ["SweepError", "sweep"]

NEEDED = {".zarr": ("xarray", "zarr", "filelock"), ".nc": ("xarray", "zarr", "filelock", "dask", "h5netcdf", "h5py")}
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
    out = _place(out)
    _require(out, scheduler)
    from filelock import FileLock, Timeout

    from symcheck.numeric.sweep.spec import plan, read
    from symcheck.numeric.sweep.store import Store
    from symcheck.numeric.sweep.workers import cluster
    from symcheck.numeric.sweep.workers import threads as local

    text, store = read(spec), Store(out)
    lock = FileLock(out.with_name(f"{out.name}.lock"), timeout=0)
    try:
        with lock, _removed(Path(lock.lock_file)):
            swept = plan(text)
            if store.is_finished(json.loads(text)):
                return f"{out} is finished already; nothing was computed"
            layout = _prepared(text, swept, store, chunks or {}, memory)
            with cluster(scheduler, patience) if scheduler else local(threads) as workers:
                return _compute(text, swept, store, layout, workers, progress)
    except Timeout:
        raise SweepError(f"another sweep is writing {out}; wait for it, or name another --out") from None
    except OSError as error:
        raise SweepError(f"{out} cannot be written: {error.strerror or error}") from None


@contextmanager
def _removed(path: Path) -> Iterator[None]:
    """Leave no file there, where the system lets it be removed while it is open."""
    try:
        yield
    finally:
        with suppress(OSError):
            path.unlink()


def _prepared(text: str, swept: Plan, store: Store, asked: Mapping[str, int], memory: float) -> Chunks:
    """Lay the sweep out, or take up the one that was begun."""
    from symcheck.numeric.sweep.chunks import chunks_of

    try:
        results = swept.results()
    except (ValueError, ArithmeticError, MemoryError, TypeError, ImportError) as error:
        raise SweepError(_reason(swept, error)) from None
    is_complex = [name for name, each in results.items() if each.dtype.kind == "c"]
    if is_complex and store.out.suffix == ".nc":
        raise SweepError(f"{is_complex[0]} is complex, and netCDF has no complex numbers; take --out FILE.zarr")
    begun, chunks = store.begun(), chunks_of(swept, results, asked, memory)
    if begun is None:
        store.begin(swept, results, chunks, {"spec": json.loads(text), "code": code(), "chunks": chunks.lengths})
    else:
        _require_same(begun, text, store)
        chunks = replace(chunks, lengths=begun["chunks"])
        if asked.items() - begun["chunks"].items():
            raise SweepError(
                f"the sweep was begun with chunks {begun['chunks']}; leave --chunk out, or remove {store.partial}"
            )
    store.open(results, chunks)
    return chunks


def _require_same(begun: Mapping[str, Any], text: str, store: Store) -> None:
    """The sweep that was begun is the one that is asked for."""
    asked = json.loads(text)
    there = f"remove {store.partial} to begin anew, or name another --out"
    if begun["spec"] != asked:
        names = sorted(name for name in {*begun["spec"], *asked} if begun["spec"].get(name) != asked.get(name))
        raise SweepError(f"{store.partial} is the beginning of another sweep ({', '.join(names)} differ); {there}")
    if begun["code"] != code():
        raise SweepError(f"{store.partial} was begun with another version of symcheck or NumPy; {there}")


def _compute(text: str, swept: Plan, store: Store, chunks: Chunks, workers: Workers, progress: Progress) -> str:
    """Compute the chunks that are missing and finish."""
    from symcheck.numeric.sweep.workers import compute

    done = store.finished(chunks)
    kept = len(done)
    calls = ((k, (text, code(), chunks.slices(k))) for k in range(chunks.count) if k not in done)
    progress(kept, chunks.count)
    try:
        with ThreadPoolExecutor(1) as writer:  # Ctrl-C does not cut off what another thread is writing
            for number, values in workers.completed(compute, calls):
                done[number] = writer.submit(store.write, number, chunks.slices(number), values).result()
                progress(len(done), chunks.count)
        store.finish()
    except KeyboardInterrupt:
        raise KeyboardInterrupt(f"; {_said(store, chunks)}") from None
    except (ValueError, ArithmeticError, MemoryError, ImportError) as error:
        raise SweepError(f"{_reason(swept, error)}; {_said(store, chunks)}") from None
    return _summary(store.out, chunks, kept, sum(done.values()))


def _said(store: Store, chunks: Chunks) -> str:
    return f"{store.count()} of {chunks.count} chunks are done and kept; the same command goes on from there"


def _reason(swept: Plan, error: Exception) -> str:
    return str(error) if isinstance(error, SweepError) else f"{swept.function}: {error or type(error).__name__}"


def _summary(out: Path, chunks: Chunks, kept: int, not_finite: int) -> str:
    shape = " x ".join(f"{name} {size}" for name, size in chunks.sizes.items())
    lines = f"{out}: {shape}, {chunks.count} chunks, {kept} of them from before"
    return f"{lines}; {not_finite} values are infinite or no number" if not_finite else lines


def _place(out: Path) -> Path:
    """Where the file really is, if that is a link to it."""
    if out.exists() and not (out.is_file() or out.is_dir()):
        raise SweepError(f"--out {out} is a device or a pipe; name a file, in which parts can be sought")
    return Path(os.path.realpath(out)) if out.is_symlink() else out


def _require(out: Path, scheduler: str | None) -> None:
    """The file can be written, and the packages for it are installed."""
    if out.suffix not in NEEDED:
        raise SweepError(f"--out {out} must end with .zarr or .nc")
    if not out.absolute().parent.is_dir():
        raise SweepError(f"--out {out}: there is no folder {out.parent}")
    needed = (*NEEDED[out.suffix], *(("distributed",) if scheduler else ()))
    missing = [name for name in needed if find_spec(name) is None]
    if missing:
        raise SweepError(f"a sweep needs {', '.join(missing)}; run `pip install 'symcheck[sweep]'`")
