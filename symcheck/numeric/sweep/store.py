"""Where a sweep is kept while it runs, in OUT.partial.zarr, and how it becomes OUT when it is finished.

Decision: one process writes, that of the sweep itself; workers send what they have computed. Reason: they need not
share a file system, and a chunk that is computed twice does no harm. A chunk counts as finished by a line in a
journal that has the digest of its values: what was written by halves, or damaged, does not have it and is computed
again. OUT itself appears at once, by renaming.

What is found there may be anybody's: it is opened as Zarr of format 3 alone (older ones may run code when they are
decoded), and refused in one line unless it is laid out as the sweep is that is asked for.
"""

from __future__ import annotations

import json
import os
import re
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
import xarray
import zarr
from zarr.codecs import BloscCodec

from symcheck.numeric.sweep.chunks import Chunks
from symcheck.numeric.sweep.functions import SweepError
from symcheck.numeric.sweep.spec import Plan, Result

COMPRESSION = BloscCodec(cname="lz4", clevel=1, shuffle="shuffle")  # takes no longer than to write without any
IDENTITY = "symcheck_sweep"  # attribute with what the sweep was asked for
FORMAT = 3  # of Zarr
AS_ZARR: Mapping[str, Any] = {"engine": "zarr", "consolidated": False, "zarr_format": FORMAT}
LINE = re.compile(r"\d+ [0-9a-f]{32} \d+")


class Store:
    """A sweep on its way: chunks are written to it, in any order, until it can be finished."""

    def __init__(self, out: Path) -> None:
        self.out = out
        self.partial = out.with_name(f"{out.name}.partial.zarr")
        self.journal = out.with_name(f"{out.name}.partial.finished")
        self.arrays: dict[str, Any] = {}

    def is_finished(self, spec: Any) -> bool:
        """Whether the file is there and is this sweep; SweepError if it is something else."""
        if not self.out.exists():
            return False
        how = {"engine": "h5netcdf"} if self.out.suffix == ".nc" else AS_ZARR
        try:
            with xarray.open_dataset(self.out, **how) as found:
                is_this = json.loads(found.attrs[IDENTITY])["spec"] == spec
        except Exception:  # whatever the libraries raise of a foreign file
            is_this = False
        if not is_this:
            raise SweepError(f"{self.out} exists and is not this sweep; remove it, or name another --out")
        return True

    def begun(self) -> dict[str, Any] | None:
        """What the sweep that is on its way here was asked for; None if there is none."""
        if not self.partial.exists():
            return None
        try:
            attributes = zarr.open_group(self.partial, mode="r", zarr_format=FORMAT, use_consolidated=False).attrs
            return _identity(json.loads(str(attributes[IDENTITY])))
        except Exception as error:  # whatever Zarr raises of a foreign folder
            raise SweepError(
                f"{self.partial} is not the beginning of a sweep ({_in_a_line(error)}); remove it"
            ) from None

    def begin(self, plan: Plan, results: Mapping[str, Result], chunks: Chunks, identity: Mapping[str, Any]) -> None:
        """Lay out all arrays, with coordinates, units and nothing in them."""
        new = self.partial.with_name(f"{self.partial.name}.new")
        with _writing(self.partial):
            shutil.rmtree(new, ignore_errors=True)
            self.journal.unlink(missing_ok=True)
            _coordinates(plan, identity).to_zarr(new, zarr_format=FORMAT, consolidated=False)
            group = zarr.open_group(new, mode="r+", zarr_format=FORMAT)
            for name, result in results.items():
                shape, lengths = _layout(result, chunks)
                group.create_array(
                    name,
                    shape=shape,
                    chunks=lengths,
                    dtype=result.dtype,
                    compressors=COMPRESSION,
                    fill_value=np.zeros((), result.dtype)[()],
                    dimension_names=[*chunks.sizes, *result.axes],
                    attributes=dict(result.attributes),
                )
            new.rename(self.partial)

    def open(self, results: Mapping[str, Result], chunks: Chunks) -> None:
        """Take up the arrays of these results; SweepError if they are laid out otherwise."""
        try:
            group = zarr.open_group(self.partial, mode="r+", zarr_format=FORMAT, use_consolidated=False)
            self.arrays = {name: group[name] for name in results}
            found = {name: (each.shape, each.chunks, each.dtype) for name, each in self.arrays.items()}
            asked = {name: (*_layout(each, chunks), np.dtype(each.dtype)) for name, each in results.items()}
            if found != asked:
                raise ValueError("its arrays have other shapes, chunks or types")
        except Exception as error:  # whatever Zarr raises of a foreign folder
            raise SweepError(
                f"{self.partial} is not the beginning of this sweep ({_in_a_line(error)}); remove it"
            ) from None

    def finished(self, chunks: Chunks) -> dict[int, int]:
        """The chunks that are there as they were written, each with how many of its values are not finite."""
        kept = {}
        for line in self._lines():
            number, digest, not_finite = line.split()
            if int(number) < chunks.count and _digest(self._read(chunks.slices(int(number)))) == digest:
                kept[int(number)] = int(not_finite)
        with _writing(self.partial):
            text = "".join(f"{line}\n" for line in self._lines() if int(line.split()[0]) in kept)
            _replace(self.journal, text)
        return kept

    def write(self, number: int, slices: Mapping[str, slice], values: Mapping[str, Any]) -> int:
        """Write a chunk, and then the line by which it counts; how many of its values are not finite."""
        not_finite = sum(int(np.count_nonzero(~np.isfinite(each))) for each in values.values())
        with _writing(self.partial):
            for name, each in values.items():
                self.arrays[name][tuple(slices.values())] = each
            with open(self.journal, "ab", buffering=0) as journal:
                journal.write(f"{number} {_digest(values)} {not_finite}\n".encode())
        return not_finite

    def count(self) -> int:
        """How many chunks count as finished."""
        return len(self._lines())

    def finish(self) -> None:
        """Make it the file that was asked for, whole or not at all."""
        with _writing(self.out):
            for left in self.partial.rglob("*.partial"):  # of chunks whose writing was cut off
                left.unlink()
            if self.out.suffix == ".nc":
                _to_netcdf(self.partial, self.out)
                shutil.rmtree(self.partial)
            else:
                _sync()
                self.partial.rename(self.out)
            self.journal.unlink(missing_ok=True)

    def _lines(self) -> list[str]:
        """Whole lines of the journal."""
        try:
            text = self.journal.read_text(encoding="utf-8", errors="replace")
        except FileNotFoundError:
            return []
        return [line for line in text[: text.rfind("\n") + 1].splitlines() if LINE.fullmatch(line)]

    def _read(self, slices: Mapping[str, slice]) -> dict[str, Any]:
        try:
            return {name: array[tuple(slices.values())] for name, array in self.arrays.items()}
        except (OSError, ValueError, RuntimeError):  # what is there cannot be decoded
            return {}


def _identity(found: Any) -> dict[str, Any]:
    """What a sweep was asked for, if it is of that form."""
    of_form = isinstance(found, dict) and isinstance(found.get("spec"), dict) and isinstance(found.get("code"), str)
    lengths = found.get("chunks") if of_form else None
    if not isinstance(lengths, dict) or not all(type(each) is int and each > 0 for each in lengths.values()):
        raise ValueError("it does not say of which sweep")
    return {**found}


def _layout(result: Result, chunks: Chunks) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """The shape of an array of results, and that of its chunks."""
    own = result.axes.values()
    shape = (*chunks.sizes.values(), *own)
    return shape, (*(chunks.lengths[name] for name in chunks.sizes), *(max(1, length) for length in own))


def _in_a_line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__


def _coordinates(plan: Plan, identity: Mapping[str, Any]) -> xarray.Dataset:
    coordinates: dict[str, Any] = {name: (name, axis.coordinates, axis.attributes) for name, axis in plan.axes.items()}
    further = {name: array for axis in plan.axes.values() for name, array in axis.further.items()}
    return xarray.Dataset(
        coords={**coordinates, **further}, attrs={"title": plan.function, IDENTITY: json.dumps(identity)}
    )


def _to_netcdf(partial: Path, out: Path) -> None:
    new = out.with_name(f"{out.name}.new")
    with xarray.open_dataset(partial, **AS_ZARR, chunks={}) as found:
        found.to_netcdf(new, engine="h5netcdf")
    _sync()
    new.replace(out)


def _digest(values: Mapping[str, Any]) -> str:
    digest = sha256()
    for each in values.values():
        digest.update(np.ascontiguousarray(each).view(np.uint8).data)
    return digest.hexdigest()[:32]


def _replace(path: Path, text: str) -> None:
    new = path.with_name(f"{path.name}.new")
    new.write_text(text, encoding="utf-8")
    new.replace(path)


def _sync() -> None:
    """Have the system write what it still holds back, where it can be told to."""
    if hasattr(os, "sync"):
        os.sync()


@contextmanager
def _writing(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise SweepError(f"{path} cannot be written: {error.strerror or error}") from None
