"""Where a sweep is kept while it runs, in OUT.partial.zarr, and how it becomes OUT when it is finished.

Decision: one process writes, that of the sweep itself; workers send what they have computed. Reason: they need not
share a file system, and a chunk that is computed twice does no harm. A chunk counts as finished by a line in a
journal that has the digest of its values: a chunk that was cut off, damaged or exchanged does not have it and is
computed again. OUT itself appears at once, by renaming.

The folder may be anybody's: it is opened as Zarr of format 3 alone (older ones may run code when they are
decoded), and refused in one line unless it is laid out as the sweep that is asked for.
"""

from __future__ import annotations

import os
import re
import shutil
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from hashlib import sha256
from itertools import product
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np
import xarray
import zarr
from numpy.typing import NDArray
from zarr.codecs import BloscCodec
from zarr.errors import ZarrUserWarning

from symcheck.numeric.sweep.functions import SweepError
from symcheck.numeric.sweep.plan import Plan

COMPRESSION = BloscCodec(cname="lz4", clevel=1, shuffle="shuffle")  # takes no longer than to write without any
IDENTITY = "symcheck_sweep"  # attribute with the `Identity` of the sweep
LINE = re.compile(r"^(\d+) (\d+) ([0-9a-f]{32})$", re.MULTILINE)  # chunk, values that are not finite, digest
DIGITS = 32  # of a digest: 128 bits
AS_ZARR = {"engine": "zarr", "consolidated": False, "zarr_format": 3}  # no other format, no second copy of metadata
Values = Mapping[str, NDArray[np.generic]]


class Identity(msgspec.Struct):
    """The specification of a sweep, the code that computes it, and the lengths of its chunks."""

    spec: dict[str, object]
    code: str
    chunks: dict[str, Annotated[int, msgspec.Meta(gt=0)]]


class Store:
    """A sweep on its way: chunks are written to it, in any order, until it can be finished."""

    def __init__(self, out: Path) -> None:
        self.out = out
        self.partial = out.with_name(f"{out.name}.partial.zarr")
        self.journal = out.with_name(f"{out.name}.partial.finished")
        self.arrays: dict[str, zarr.Array] = {}
        self.parts: list[dict[str, slice]] = []
        self.done: dict[int, int] = {}  # chunks, with how many of their values are not finite

    def is_finished(self, spec: Mapping[str, object]) -> bool:
        """Whether the file is there and is this sweep; SweepError if it is something else."""
        if not self.out.exists():
            return False
        options = {"engine": "h5netcdf"} if self.out.suffix == ".nc" else AS_ZARR
        try:
            with xarray.open_dataset(self.out, **options) as there:
                is_this = _identity(there.attrs).spec == spec
        except Exception:  # whatever the libraries raise of a foreign file
            is_this = False
        if not is_this:
            raise SweepError(f"{self.out} exists and is not this sweep; remove it, or name another --out")
        return True

    def begun(self) -> Identity | None:
        """The identity of the sweep that has begun here, if any."""
        if not self.partial.exists():
            return None
        with self._foreign("a"):
            return _identity(self._group().attrs)

    def has_chunks(self) -> bool:
        """Whether a chunk of what has begun is finished."""
        return bool(LINE.search(self._journal()))

    def begin(self, plan: Plan, results: Mapping[str, xarray.DataArray], identity: Identity) -> None:
        """Create all arrays, empty, with coordinates and units."""
        new = self.partial.with_name(f"{self.partial.name}.new")
        attributes = {"title": plan.function, IDENTITY: msgspec.json.encode(identity).decode()}
        with writing(self.partial):
            shutil.rmtree(new, ignore_errors=True)
            self.journal.unlink(missing_ok=True)
            empty = xarray.Dataset(coords=plan.coordinates, attrs=attributes)
            empty.to_zarr(new, consolidated=False, zarr_format=3)
            group = zarr.open_group(new, mode="r+", zarr_format=3)
            for name, (shape, chunks, dtype) in _layout(plan, results, identity).items():
                dims, units = results[name].dims, results[name].attrs
                options = {"compressors": COMPRESSION, "dimension_names": dims, "attributes": units}
                group.create_array(name, shape=shape, chunks=chunks, dtype=dtype, **options)
            shutil.rmtree(self.partial, ignore_errors=True)  # a beginning of which no chunk is finished
            new.rename(self.partial)

    def open(self, plan: Plan, results: Mapping[str, xarray.DataArray], identity: Identity) -> None:
        """Continue with the results that are there; SweepError if their layout is different."""
        with self._foreign("this"):
            group = self._group("r+")
            self.arrays = {name: group[name] for name in results}
            there = {name: (array.shape, array.chunks, array.dtype) for name, array in self.arrays.items()}
            if there != _layout(plan, results, identity):
                raise ValueError("its arrays have other shapes, chunks or types")
            steps = {axis: range(0, size, identity.chunks[axis]) for axis, size in plan.sizes.items()}
        ends = {axis: [slice(k, min(k + step.step, step.stop)) for k in step] for axis, step in steps.items()}
        self.parts = [dict(zip(steps, places, strict=True)) for places in product(*ends.values())]
        for number, not_finite, digest in re.findall(LINE, self._journal()):
            if int(number) < len(self.parts) and _digest(self._read(self.parts[int(number)])) == digest:
                self.done[int(number)] = int(not_finite)

    def write(self, number: int, values: Values) -> None:
        """Write a chunk, and then the line by which it counts."""
        not_finite = sum(int(np.count_nonzero(~np.isfinite(array))) for array in values.values())
        with writing(self.partial):
            for name, array in values.items():
                self.arrays[name][tuple(self.parts[number].values())] = array
            with open(self.journal, "ab", buffering=0) as journal:
                journal.write(f"\n{number} {not_finite} {_digest(values)}\n".encode())  # the last may be cut off
        self.done[number] = not_finite

    def progress(self) -> str:
        """How much is done, for whoever starts it again."""
        kept = f"{len(self.done)} of {len(self.parts)} chunks are done and kept"
        return f"{kept}; the same command goes on from there" if self.done else "no chunk is finished"

    def finish(self) -> None:
        """Make it the file OUT, whole or not at all."""
        with writing(self.out):
            for left in self.partial.rglob("*.partial"):  # of chunks whose writing was cut off
                left.unlink()
            if self.out.suffix == ".nc":
                _to_netcdf(self.partial, self.out)
                shutil.rmtree(self.partial)
            else:
                _consolidate(self.partial)
                _sync(self.partial)
                self.partial.rename(self.out)
            self.journal.unlink(missing_ok=True)

    def _journal(self) -> str:
        return self.journal.read_text(encoding="utf-8", errors="replace") if self.journal.exists() else ""

    def _group(self, mode: str = "r") -> zarr.Group:
        return zarr.open_group(self.partial, mode=mode, zarr_format=3, use_consolidated=False)

    def _read(self, part: Mapping[str, slice]) -> Values:
        try:
            return {name: np.asarray(array[tuple(part.values())]) for name, array in self.arrays.items()}
        except (OSError, ValueError, RuntimeError):  # what is there cannot be decoded
            return {}

    @contextmanager
    def _foreign(self, which: str) -> Iterator[None]:
        try:
            yield
        except Exception as error:  # whatever Zarr raises of a foreign folder
            reason = " ".join(str(error).split()) or type(error).__name__
            raise SweepError(f"{self.partial} is not the beginning of {which} sweep ({reason}); remove it") from None


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """SweepError in place of an error of the file system."""
    try:
        yield
    except OSError as error:
        raise SweepError(f"{path} cannot be written: {error.strerror or error}") from None


def _identity(attributes: Mapping[str, str]) -> Identity:
    return msgspec.json.decode(attributes[IDENTITY], type=Identity)


def _layout(
    plan: Plan, results: Mapping[str, xarray.DataArray], identity: Identity
) -> dict[str, tuple[tuple[int, ...], tuple[int, ...], np.dtype[np.generic]]]:
    """The shape of each array of results, that of its chunks, and its type."""
    sizes = {name: {**array.sizes, **plan.sizes} for name, array in results.items()}
    return {
        name: (
            tuple(sizes[name][dim] for dim in array.dims),
            tuple(max(1, identity.chunks.get(dim, sizes[name][dim])) for dim in array.dims),
            array.dtype,
        )
        for name, array in results.items()
    }


def _to_netcdf(partial: Path, out: Path) -> None:
    new = out.with_name(f"{out.name}.new")
    with xarray.open_dataset(partial, **AS_ZARR, chunks={}) as whole:
        whole.to_netcdf(new, engine="h5netcdf")
    _sync(new)
    new.replace(out)


def _digest(values: Values) -> str:
    digest = sha256()
    for array in values.values():
        digest.update(np.ascontiguousarray(array).view(np.uint8).data)
    return digest.hexdigest()[:DIGITS]


def _consolidate(folder: Path) -> None:
    """Write the second copy of the metadata without which xarray warns whenever it opens the folder."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ZarrUserWarning)  # that the format does not specify it yet
        zarr.consolidate_metadata(folder, zarr_format=3)


def _sync(path: Path) -> None:
    """Flush a file, or all files of a folder, from the buffers of the system."""
    for file in [path] if path.is_file() else filter(Path.is_file, path.rglob("*")):
        with open(file, "rb+") as written:
            os.fsync(written.fileno())
