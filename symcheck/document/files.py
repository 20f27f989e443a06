"""The text of a file, or one line that says why it has none."""

from __future__ import annotations

import codecs
import stat
from pathlib import Path

from symcheck.core.verdicts import SymcheckError

MAX_BYTES = 10_000_000  # a book of 1,000 pages has a third of it
CONTROLS = frozenset(range(32)) - {*b"\t\n\v\f\r\x1a\x1b"}  # what no text has, in any encoding that extends ASCII
MARKS = {codecs.BOM_UTF8: "utf-8-sig", codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16"}


def text_of(file: Path) -> str:
    """The text; what is neither UTF-8 nor marked as UTF-16 is taken for an extension of ASCII, as formulas are."""
    try:
        mode = file.stat().st_mode
        if not stat.S_ISREG(mode):
            what = "a directory" if stat.S_ISDIR(mode) else "no regular file"
            raise SymcheckError(f"{file} is {what}; give a document")
        if file.stat().st_size > MAX_BYTES:
            raise SymcheckError(f"{file} has more than {MAX_BYTES // 1_000_000} MB; give one chapter of it")
        data = file.read_bytes()
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or error
        raise SymcheckError(f"{file} cannot be read ({why}); give a document") from error
    if not data.strip():
        raise SymcheckError(f"{file} is empty")
    encoding = next((name for mark, name in MARKS.items() if data.startswith(mark)), "")
    if not encoding and CONTROLS.intersection(data):
        raise SymcheckError(f"{file} is no text; give the source of the document")
    try:
        text = data.decode(encoding or "utf-8")
    except UnicodeDecodeError:
        if encoding:
            raise SymcheckError(
                f"{file} begins as {encoding.upper()} and does not go on so; save it as UTF-8"
            ) from None
        text = data.decode("latin-1")
    if "\0" in text:
        raise SymcheckError(f"{file} is no text; give the source of the document")
    return text.replace("\r\n", "\n").replace("\r", "\n")
