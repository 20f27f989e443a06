"""The ledger as an editor's list of problems: a line, or a result of SARIF, for each relation at its place."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

from symcheck import __version__, papers
from symcheck.core.claims import Declaration, Paper
from symcheck.core.verdicts import Verdict
from symcheck.ledger import Record, by_paper
from symcheck.views.dimensions import conflict
from symcheck.views.model import Relation

MISFIT = "dimensions"  # what is said of a relation beside its verdict
LONGEST = 300  # characters of a formula that is shown in one line
SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
RULES: dict[str, str] = {
    Verdict.REFUTED: "The relation fails at a point that satisfies all that it follows from.",
    Verdict.UNDECIDED: "The relation is neither proved nor refuted.",
    Verdict.PROVED: "The relation is proved, and the proof is checked.",
    MISFIT: "The terms of the relation do not measure the same.",
}
LEVELS: dict[str, str] = {
    Verdict.REFUTED: "error",
    Verdict.PROVED: "none",
}  # as SARIF calls them; all others are warnings


@dataclass(frozen=True)
class Diagnostic:
    """What is said of one relation, and where it stands."""

    id: str
    file: str
    line: int
    verdict: str
    message: str

    @property
    def text(self) -> str:
        """In one line, as compilers print it."""
        return f"{self.file}:{self.line}: {self.verdict}: {self.message}"

    def sarif(self) -> dict[str, object]:
        """As a result of SARIF 2.1.0."""
        path, mark, cell = self.file.partition("#")
        uri = Path(path).as_uri() if Path(path).is_absolute() else quote(Path(path).as_posix())
        place = {"artifactLocation": {"uri": uri + mark + cell}, "region": {"startLine": max(self.line, 1)}}
        return {
            "ruleId": str(self.verdict),
            "kind": "pass" if self.verdict == Verdict.PROVED else "fail",
            "level": LEVELS.get(self.verdict, "warning"),
            "message": {"text": self.message},
            "locations": [{"physicalLocation": place, "logicalLocations": [{"fullyQualifiedName": self.id}]}],
        }


def diagnostics(records: Iterable[Record]) -> Iterator[Diagnostic]:
    """Those of all relations that are decided, or could not be, in printed order."""
    for key, rows in by_paper(records).items():
        paper = papers.load()[key]
        items = {item.number: item for _, _, item in paper.items()}
        for record in rows:
            file = file_of(paper, items[record.declaration.removeprefix(f"{key}:")])
            if record.verdict:
                yield Diagnostic(record.id, file, record.line, record.verdict, _message(record))
            if misfit := conflict(record.dimension):
                yield Diagnostic(record.id, file, record.line, MISFIT, f"{record.number}: {misfit}")


def file_of(paper: Paper, item: Declaration) -> str:
    """The file in which a declaration stands."""
    folder = papers.load().folders.get(paper.key)
    file = Path(paper.source).parent / (item.source.file or Path(paper.source).name)
    if folder is None:
        return str(file)
    return near(folder / file)


def near(file: str | Path) -> str:
    """The path of a file from here if it lies below, else as a whole."""
    whole = os.path.normpath(file)
    short = os.path.relpath(whole)
    return whole if short.startswith(os.pardir) else short


def _message(record: Record) -> str:
    relation = Relation(record)
    statement = " ".join((record.read or relation.statement).split())
    said = [f"{record.number}: {statement if len(statement) <= LONGEST else statement[: LONGEST - 3] + '...'}"]
    if relation.fails_at:
        said.append(f"fails at {relation.fails_at}")
    said += [f"it should be {record.corrected}"] if record.corrected else []
    if record.verdict is not Verdict.PROVED and record.reason:
        said.append(record.reason.replace("$", ""))
    return " ".join("; ".join(said).split())


def plain(records: Sequence[Record]) -> str:
    """A line for each relation: `file:line: verdict: message`."""
    return "\n".join(each.text for each in diagnostics(records))


def sarif(records: Sequence[Record]) -> str:
    """A log of SARIF 2.1.0 with one run."""
    rules = [{"id": str(verdict), "shortDescription": {"text": text}} for verdict, text in RULES.items()]
    driver = {"name": "symcheck", "version": __version__, "rules": rules}
    run = {"tool": {"driver": driver}, "results": [each.sarif() for each in diagnostics(records)]}
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, ensure_ascii=False, indent=1)


FORMATS = {"plain": plain, "sarif": sarif}
