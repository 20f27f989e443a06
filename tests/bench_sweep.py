"""What a sweep costs besides the function itself: python tests/bench_sweep.py. Minima of five."""

from __future__ import annotations

import json
import shutil
import tempfile
import timeit
from pathlib import Path

import numpy as np

from symcheck.numeric.chunked import gufunc
from symcheck.numeric.sweep import store as sweep_store
from symcheck.numeric.sweep import sweep
from symcheck.numeric.sweep import workers as sweep_workers
from symcheck.numeric.sweep.functions import code
from symcheck.numeric.sweep.plan import plan, read

SPEC = """
function = "ignatov2005.face_distances_of_four_wheels"
[parameters]
a = { start = 0.1, stop = 1.5, count = 2000 }
b = { start = 0.2, stop = 1.2, count = 2000 }
"""
REPEAT, CALLS = 5, 100_000


def main() -> None:
    """Print the cost of a dispatch, of each chunk, and of taking a sweep up again."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "sweep.toml").write_text(SPEC)
        text = read(folder / "sweep.toml")
        swept = plan(text)
        whole = {axis: slice(0, size) for axis, size in swept.sizes.items()}
        points = 4_000_000
        computing = min(timeit.repeat(lambda: swept.compute(whole), number=1, repeat=REPEAT))
        print(f"computing alone, in one piece  {1e9 * computing / points:6.1f} ns/point")
        for threads in (1, 2):
            took = min(timeit.repeat(lambda n=threads: _run(folder, n), number=1, repeat=REPEAT))
            print(f"sweep, {threads} threads               {1e9 * took / points:6.1f} ns/point")
        took = min(timeit.repeat(lambda: _taken_up(folder, text), number=1, repeat=REPEAT))
        print(f"checking all that is finished  {1e9 * took / points:6.1f} ns/point")
    dispatching = gufunc("()->()")(_nothing)
    took, plain = (min(timeit.repeat(lambda f=f: f(1.0), number=CALLS, repeat=REPEAT)) for f in (dispatching, _nothing))
    print(f"dispatch with xarray loaded    {1e6 * (took - plain) / CALLS:6.2f} us")


def _nothing(x: float) -> np.ndarray:
    return x  # type: ignore[return-value]


def _run(folder: Path, threads: int) -> None:
    shutil.rmtree(folder / "out.zarr", ignore_errors=True)
    sweep(folder / "sweep.toml", folder / "out.zarr", threads=threads)


def _taken_up(folder: Path, text: str) -> None:
    """Half of a sweep is written by the first call, and read by all."""
    store, swept = sweep_store.Store(folder / "half.zarr"), plan(text)
    results, identity = swept.first(), sweep_store.Identity(json.loads(text), code(), {"a": 400, "b": 2000})
    if store.begun() is None:
        store.begin(swept, results, identity)
        store.open(swept, results, identity)
        for number, part in enumerate(store.parts):
            store.write(number, sweep_workers.compute(text, code(), part))
    else:
        store.open(swept, results, identity)
    assert len(store.done) == len(store.parts)


if __name__ == "__main__":
    main()
