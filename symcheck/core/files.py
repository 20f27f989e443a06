"""How every file that somebody asked for is written: whole or not at all, and where it really is."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from pathlib import Path
from stat import S_IMODE, S_ISREG


def put(file: Path, data: bytes) -> None:
    """Write a file; a reader sees the old contents or the new, never a part. OSError if it cannot be written.

    A link is followed: what it points to is written. A device or a pipe has no contents to replace, so that the data
    go into it; and so do they into the standard output or error, by whatever name.
    """
    file.parent.mkdir(parents=True, exist_ok=True)
    try:
        there = file.stat()
    except FileNotFoundError:
        _replace(file, data, None)
        return
    for stream in (sys.__stdout__, sys.__stderr__):
        if stream and not stream.closed and os.path.samestat(there, os.fstat(stream.fileno())):
            stream.flush()
            _write(os.dup(stream.fileno()), data)
            return
    if S_ISREG(there.st_mode):
        _replace(file, data, S_IMODE(there.st_mode))
    else:
        _write(os.open(file, os.O_WRONLY), data)


def _replace(file: Path, data: bytes, mode: int | None) -> None:
    """Write beside the file, or beside what it is a link to, and rename."""
    target = Path(os.path.realpath(file))
    temporary = target.with_name(f".symcheck-{os.getpid()}-{os.urandom(4).hex()}")
    try:
        _write(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666), data)
        if mode is not None:
            temporary.chmod(mode)
        temporary.replace(target)
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


def _write(descriptor: int, data: bytes) -> None:
    """Write all of it and close; an error of the last byte is an error too, as that of a full device."""
    with open(descriptor, "wb", buffering=0) as stream:
        rest = memoryview(data)
        while rest:
            rest = rest[stream.write(rest) :]
