"""What is checked in under generated/: the certificates of each paper, the verdicts expected of it, and its kernels.

All files are written from the records of an audit and depend on nothing else: no times, no versions. Each certificate
and each expectation has its own line, so that a diff shows what changed. The folder also holds what Coq said
of the certificates, see `symcheck.coq.confirmed`, and what the self-test found, see `symcheck.ledger.selftested`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from difflib import unified_diff
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

import msgspec

from symcheck.core.files import put as put_file
from symcheck.core.ids import Id
from symcheck.core.verdicts import Reading, SymcheckError, Verdict
from symcheck.kernels.codegen.target import MARK
from symcheck.ledger.digests import line, short_digest
from symcheck.ledger.record import Record

T = TypeVar("T")
SCHEMA = 1  # of the recorded outcomes
PROOFS = 3  # the schema of certificates and of the statements they are compared with
CERTIFICATES = "certificates"
EXPECTED = "expected"
STATEMENTS = "statements"
COQ = "coq"
SELFTEST = "selftest.json"
OURS = (
    "*.py",
    "*.pyi",
    f"{CERTIFICATES}/*.json",
    f"{EXPECTED}/*.json",
    f"{STATEMENTS}/*.json",
    f"{COQ}/*.json",
    SELFTEST,
)  # what `write` may remove
UNKNOWN = "unknown; no command writes it, so remove it"


def write(folder: Path, contents: Mapping[str, bytes]) -> None:
    """Make `folder` hold exactly these of our files; each appears whole or not at all. Unknown files are left alone."""
    _write(folder, contents, _ours(folder) - set(contents), "generate in a checkout")


def put(folder: Path, contents: Mapping[str, bytes]) -> None:
    """Write these files, each whole, to a folder of the user's, where everything else is left as it is."""
    present = (folder / name for name in contents if (folder / name).is_file())
    if foreign := [file for file in present if MARK.encode() not in file.read_bytes()]:
        raise SymcheckError(f"{foreign[0]} was not written by `symcheck generate`; choose another folder with --output")
    _write(folder, contents, (), "choose another with --output")


def _write(folder: Path, contents: Mapping[str, bytes], gone: Iterable[str], advice: str) -> None:
    try:
        for name, data in contents.items():
            put_file(folder / name, data)
        for name in gone:
            (folder / name).unlink()
    except OSError as error:
        raise SymcheckError(f"{folder} cannot be written ({error.strerror}); {advice}") from error


def differences(folder: Path, contents: Mapping[str, bytes], alone: bool = True) -> list[str]:
    """One line for each file that is missing or different, and superfluous or unknown if ours should be `alone`."""
    present, ours = (
        _present(folder) if alone else {name for name in contents if (folder / name).is_file()},
        _ours(folder),
    )
    reasons = {name: "superfluous" if name in ours else UNKNOWN for name in present - set(contents)}
    for name, data in contents.items():
        if name not in present:
            reasons[name] = "missing"
        elif (old := (folder / name).read_bytes()) != data:
            reasons[name] = f"differs from line {_first_difference(old, data)} on"
    return [f"{name}: {reasons[name]}" for name in sorted(reasons)]


def diff(folder: Path, contents: Mapping[str, bytes]) -> str:
    """How the kernels would change, as a unified diff that `git apply` takes; "" if they would not."""
    patch: list[str] = []
    for name in sorted(contents):
        if not name.endswith(".json") and (folder / name).is_file():
            sides = (data.decode(errors="replace") for data in ((folder / name).read_bytes(), contents[name]))
            old, new = (side.splitlines(keepends=True) for side in sides)
            patch += unified_diff(old, new, f"a/{folder.name}/{name}", f"b/{folder.name}/{name}")
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in patch)


def stored(file: Path, read: Callable[[bytes], T], advice: str) -> T | None:
    """What a file of ours holds, None if there is none; SymcheckError, with what to do, if it cannot be read."""
    try:
        return read(file.read_bytes())
    except FileNotFoundError:
        return None
    except (OSError, ValueError, LookupError, TypeError, AttributeError, msgspec.DecodeError) as error:
        raise SymcheckError(f"{file} cannot be read ({error}); {advice}") from error


def require(holds: object, whole: str) -> None:
    """ValueError if a file that is read is not what it should be."""
    if not holds:
        raise ValueError(whole)


def expected(folder: Path, paper: str) -> dict[str, Verdict | None]:
    """The recorded verdict of each id of a paper, None for what claims nothing; empty if nothing was recorded."""

    def read(text: bytes) -> dict[str, Verdict | None]:
        data = msgspec.json.decode(text, type=_Expected)
        require((data.schema, data.paper) == (SCHEMA, paper), f"it is not of schema {SCHEMA} and paper {paper}")
        return {id: verdict for id, (verdict, _) in data.items.items()}

    file = folder / EXPECTED / f"{paper}.json"
    return stored(file, read, "run `symcheck generate` to write it anew") or {}


class _Expected(msgspec.Struct, forbid_unknown_fields=True):
    """What is recorded of a paper: verdict and reading by id."""

    schema: int
    paper: str
    items: dict[str, tuple[Verdict | None, Reading]]


def disagreements(records: Iterable[Record], recorded: Mapping[str, Verdict | None], complete: bool) -> list[str]:
    """One line for each record whose verdict is not the recorded one; if `complete`, also for each that is gone."""
    rows = {record.id: record for record in records}
    if rows and not recorded:
        return [f"{Id.parse(min(rows)).paper} has no recorded verdicts; run `symcheck generate` to record these"]
    lines = [_disagreement(row, recorded) for id, row in rows.items() if (id, row.verdict) not in recorded.items()]
    gone = [id for id in recorded if complete and id not in rows]
    return lines + [f"{id} is recorded and no longer declared; run `symcheck generate` to accept" for id in gone]


def _disagreement(record: Record, recorded: Mapping[str, Verdict | None]) -> str:
    now = record.verdict or f"a {record.role}"
    if record.id not in recorded:
        return f"{record.id} is new ({now}); run `symcheck generate` to record it"
    change = "newly passes" if record.verdict == Verdict.PROVED else "newly fails"
    why = f" ({record.reason})" if record.verdict == Verdict.UNDECIDED and record.reason else ""
    return f"{record.id} {change}: {now}{why}, recorded as {recorded[record.id] or 'claiming nothing'}"


def document(
    paper: str,
    name: str,
    brackets: str,
    lines: Iterable[str],
    sealed: bool = False,
    schema: int = SCHEMA,
    others: Mapping[str, object] = MappingProxyType({}),
) -> bytes:
    """A file of a paper: one JSON object, its members under `name` between `brackets`, a line for each.

    If it is `sealed`, with a digest of them, so that nobody changes one by hand unnoticed. `others` stand before.
    """
    body = ",\n".join(lines)
    seal = f', "digest": {line(short_digest(body))}' if sealed else ""
    before = "".join(f'"{key}": {line(value)},\n' for key, value in others.items())
    head = f'{{"schema": {schema}, "paper": {line(paper)}, {before}"{name}": {brackets[0]}\n'
    return f"{head}{body}\n{brackets[1]}{seal}}}\n".encode()


def _present(folder: Path) -> set[str]:
    """All files but the package's own and what Python compiled."""
    files = (file.relative_to(folder) for file in folder.rglob("*") if file.is_file())
    return {file.as_posix() for file in files if "__pycache__" not in file.parts} - {"__init__.py"}


def _ours(folder: Path) -> set[str]:
    """Those that `generate` may have written: a module of somebody else has not its mark."""
    found = (file for pattern in OURS for file in folder.glob(pattern))
    files = (file for file in found if file.suffix not in (".py", ".pyi") or MARK.encode() in file.read_bytes())
    return {file.relative_to(folder).as_posix() for file in files} & _present(folder)


def _first_difference(old: bytes, new: bytes) -> int:
    pairs = zip(old.split(b"\n"), new.split(b"\n"), strict=False)
    return next((n for n, (a, b) in enumerate(pairs, 1) if a != b), min(old.count(b"\n"), new.count(b"\n")) + 1)
