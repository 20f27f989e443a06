"""How records look on a terminal: the ledger, one relation in full, the errata, the papers. Computes nothing."""

from __future__ import annotations

import json
import os
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from string import ascii_lowercase
from typing import Any

from rich import box
from rich.cells import cell_len, set_cell_size
from rich.console import Console
from rich.table import Table
from rich.text import Text

from symcheck.coq.confirmed import told
from symcheck.core.claims import Paper
from symcheck.core.verdicts import Certificate, Group, Verdict
from symcheck.core.words import term
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.ledger.digests import digest_of
from symcheck.ledger.record import Record
from symcheck.views.faults import fails_at, without
from symcheck.views.steps import shown

_STYLES = {Verdict.PROVED: "green", Verdict.REFUTED: "bold red", Verdict.UNDECIDED: "yellow"}
_METHOD, _STATEMENT = 28, 20  # columns of the ledger: the method at most, the statement at least
_INDENT = 14  # of the values beside their labels
_WIDTH = 150  # of a ledger that goes to a file or a pipe


class _Console(Console):
    def on_broken_pipe(self) -> None:
        """Leave it to the command line what a reader that went away means."""
        raise BrokenPipeError


def console() -> Console:
    """The standard output; a fixed width when it is no terminal, so that a saved ledger does not depend on chance."""
    width = None if sys.stdout.isatty() or "COLUMNS" in os.environ else _WIDTH
    return _Console(width=width, highlight=False, markup=False, emoji=False)


@contextmanager
def progress_bar(what: str) -> Iterator[Any]:
    """A function (done, total) that moves a progress bar on standard error."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn(what), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(what, total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)


def ledger(out: Console, paper: str, records: Iterable[Record]) -> None:
    """One row per relation of a paper: number, statement, verdict, reading, method, time.

    Written line by line: a library's table takes a second to lay out two thousand rows that need no wrapping.
    """
    rows = [("number", "statement", "verdict", "reading", "method", "time")]
    rows += [
        (
            record.id.partition(":")[2],
            statement(record),
            record.verdict or record.role,
            record.reading,
            record.method,
            f"{record.seconds:.3f} s" if record.verdict else "",
        )
        for record in records
    ]
    widths = [max(map(cell_len, column)) for column in zip(*rows, strict=True)]
    widths[4] = min(widths[4], _METHOD)
    widths[1] = max(out.width - sum(widths[:1] + widths[2:]) - 2 * len(widths), _STATEMENT)
    out.print(Text(paper, style="bold"))
    for n, row in enumerate(rows):
        number, said, verdict, reading, method, seconds = map(_fitted, row, widths)
        style = _STYLES.get(row[2], "dim") if n else "bold"  # type: ignore[call-overload]
        line = Text.assemble(f" {number}  {said}  ", (verdict, style), f"  {reading}  {method}  ")
        line.append(seconds.strip().rjust(widths[5]))
        out.print(line, style="bold" if not n else "", soft_wrap=True)
        if not n:
            out.print(Text(" " + "─" * (out.width - 2)), soft_wrap=True)
    out.print()


def _fitted(text: str, width: int) -> str:
    """The text in so many columns of the terminal."""
    return set_cell_size(text, width) if cell_len(text) <= width else set_cell_size(text, width - 1) + "…"


def summary(out: Console, records: Iterable[Record]) -> None:
    """How many of each verdict, and how many declarations that claim nothing."""
    rows = list(records)
    verdicts = Counter(record.verdict for record in rows if record.verdict)
    others = Counter(record.role for record in rows if not record.verdict)
    decided = ", ".join(f"{verdicts[verdict]} {verdict}" for verdict in Verdict)
    rest = "".join(f"; {count} of role {role}" for role, count in sorted(others.items()))
    out.print(f"{sum(verdicts.values())} relations: {decided}{rest}")


def show(out: Console, record: Record, whole_certificate: bool = False) -> None:
    """Everything that is known of one relation."""
    out.print(Text(f"{record.id}  {record.name.replace('_', ' ')}".rstrip(), style="bold"))
    _field(out, "verdict", _verdict(record))
    _field(out, "reading", record.reading)
    _field(out, "role", f"{record.role}, section {record.section}, line {record.line} of the source")
    _field(out, "printed", record.printed)
    _field(out, "words", record.words)
    _field(out, "read as", record.read)
    _field(out, "reason", record.reason)
    for hypothesis in record.hypotheses:
        _field(out, "hypothesis", _hypothesis(hypothesis))
    _field(out, "shown where", ", ".join(f"{each} ≠ 0" for each in (record.domain or {}).get("nonzero", ())))
    _field(out, "method", f"{record.method}, {record.seconds:.3f} s" if record.method else "")
    _field(out, "uses", ", ".join(record.uses))
    _field(out, "used by", ", ".join(record.used_by))
    _counterexample(out, record)
    _erratum(out, record)
    _field(out, "Coq confirms", told(record))
    for certificate in record.certificates:
        _certificate(out, certificate, whole_certificate)


def kernel(out: Console, key: str, name: str, declared: Kernel, records: Iterable[Record]) -> None:
    """What a kernel computes, how accurately, and the relations it rests on, each with its verdict and certificates."""
    shown = declared.derived()
    out.print(Text(f"{name}  generated/{key}.py", style="bold"))
    _field(out, "says", declared.says)
    for output in declared.outputs:
        _field(out, output.name, f"{shown[output.name]}    {output.meaning}, {output.unit}")
    for argument in declared.arguments:
        _field(out, f"  {argument.name}", f"{argument.meaning}, {argument.unit}; {argument.domain}")
    _field(out, "accuracy", " ".join(f"{declared.ulp} ulp. {declared.condition} {declared.degenerate}".split()))
    for record in records:
        _field(out, "rests on", f"{record.id}, line {record.line}: {record.read}")
        _field(out, "verdict", _verdict(record))
        for certificate in record.certificates:
            _field(out, "certificate", _digest(certificate))


def errata(out: Console, records: Sequence[Record]) -> None:
    """What is wrong as printed, the weightiest first: statements in full, rows and slips of one kind in a table."""
    for group in Group:
        members = [record for record in records if record.group is group]
        if not members:
            continue
        out.print(Text(f"{group} ({len(members)})".upper(), style="bold cyan"), end="\n\n")
        if group is Group.STATEMENT:
            for record in members:
                _wrong(out, record)
        else:
            for alike in _alike(members):
                _table(out, alike)


def _wrong(out: Console, record: Record) -> None:
    """What is printed, where it fails, what is right, how the two differ."""
    out.print(Text(f"{record.id}  {record.name.replace('_', ' ')}".rstrip(), style="bold"))
    _field(out, "verdict", _verdict(record))
    _field(out, "reading", record.reading)
    _field(out, "line", str(record.line))
    _field(out, "printed", record.printed)
    _field(out, "words", record.words)
    _field(out, "read as", record.read)
    _counterexample(out, record)
    _erratum(out, record)
    out.print()


def _alike(records: Iterable[Record]) -> list[list[Record]]:
    """Those of one list (or section), kind and origin together."""
    found: dict[tuple[str | None, ...], list[Record]] = {}
    for record in records:
        found.setdefault((_place(record), record.kind, record.origin), []).append(record)
    return list(found.values())


def _place(record: Record) -> str:
    """The list or table of a row, "ignatov2005:2.1V", or else the paper."""
    return re.sub(r"(\.\d+)?[a-z]?$", "", record.id) if record.is_row else record.paper


def _table(out: Console, records: Sequence[Record]) -> None:
    """Errata of one kind: where, as printed, what is right. Parts of one row are one line."""
    first, count = records[0], len(records)
    out.print(Text(f"{_place(first)}: {first.kind}, {first.origin or 'cannot tell'}", style="bold"))
    reasons = Counter(record.reason for record in records)
    (reason, shared), *_ = reasons.most_common(1)
    common = shared > 1 or count == 1
    if common:
        out.print(Text(reason), soft_wrap=True)
    table = Table("number", "line", "printed", "correct", box=box.SIMPLE_HEAD, pad_edge=False)
    if len(reasons) > common:
        table.add_column("why")
    rows: dict[tuple[str, ...], list[str]] = {}
    for record in records:
        # of a statement in several links the one link is shown; a damaged text is read otherwise, so as printed
        link = "" if record.is_row or record.group is Group.DAMAGED else record.read
        printed = link or record.printed or record.words
        why = () if len(reasons) == common else ("" if common and record.reason == reason else record.reason,)
        number = record.id.rstrip(ascii_lowercase) if record.verdict else record.id
        key = (number, str(record.line), " ".join(printed.split()), " ".join(record.corrected.split()), *why)
        rows.setdefault(key, []).append(record.id[len(number) :])
    for (number, *cells), letters in rows.items():
        table.add_row(Text(number.partition(":")[2] + ",".join(letters)), *map(Text, cells))
    out.print(table)


def papers(out: Console, counts: Mapping[str, tuple[Paper, Counter[str]]]) -> None:
    """One row per paper: key, title, source, how many declarations of each role."""
    table = Table("key", "title", "source", "declarations", box=box.SIMPLE_HEAD, pad_edge=False)
    for key, (paper, roles) in counts.items():
        table.add_row(key, Text(paper.title), Text(paper.source), ", ".join(f"{n} {role}" for role, n in roles.items()))
    out.print(table)


def statement(record: Record) -> str:
    """What a ledger row says in one line: the link of a chain as read, the printed form, or the words."""
    link = record.read if record.id[-1].isalpha() else ""
    return " ".join((link or record.words or record.printed or record.name.replace("_", " ")).split())


def _verdict(record: Record) -> Text:
    return Text(record.verdict, style=_STYLES[record.verdict]) if record.verdict else Text(record.role, style="dim")


def _field(out: Console, label: str, value: str | Text) -> None:
    """A labelled value, whole: a long line is left to the terminal to wrap. Nothing for an empty value."""
    if not value:
        return
    text = value if isinstance(value, Text) else Text(value.replace("\n", "\n" + " " * _INDENT))
    out.print(Text(label.ljust(_INDENT), style="cyan"), text, sep="", soft_wrap=True)


def _hypothesis(hypothesis: Mapping[str, Any]) -> str:
    needed = {True: "needed", False: "not needed", None: "need not known"}[hypothesis.get("needed")]
    given = "not printed, added" if hypothesis.get("given") == "added" else hypothesis.get("given", "")
    words = hypothesis.get("words") or hypothesis.get("name", "")
    text = f"{words} ({', '.join(filter(None, (given, needed)))})"
    lost = without(hypothesis)
    return f"{text}; without it {lost}" if lost else text


def _counterexample(out: Console, record: Record) -> None:
    if record.counterexample:
        _field(out, "fails at", fails_at(record.counterexample))


def _erratum(out: Console, record: Record) -> None:
    _field(out, "corrected", record.corrected)
    _field(out, "kind", record.kind)
    _field(out, "origin", f"{record.origin}: {record.reason}" if record.origin else "")
    repair = record.erratum or {}
    _field(
        out,
        "edit",
        "\n".join(f"{e['printed'] or 'nothing'}  →  {e['corrected'] or 'nothing'}" for e in repair.get("edit") or ()),
    )
    _field(out, "repairs", _repairs(repair) if record.corrected and repair.get("edit") else "")
    _field(out, "added", "; ".join(repair.get("added") or ()))
    _field(out, "then", f"{repair['verdict']} {repair.get('reason', '')}".rstrip() if repair else "")
    for certificate in repair.get("certificates") or ():
        _field(out, "its proof", _digest(certificate))


def _repairs(repair: Mapping[str, Any]) -> str:
    """Every single edit of the printed relation that makes it true; empty if they were not searched."""
    if (repairs := repair.get("repairs")) is None:
        return ""
    found = [f"{each['edit']}: {each['relation']}" for each in repairs]
    count = {0: "no single edit repairs it", 1: "one single edit repairs it"}
    return "\n".join([count.get(len(found), f"{len(found)} single edits repair it"), *found])


def _certificate(out: Console, certificate: Certificate, whole: bool) -> None:
    _field(out, "certificate", _digest(certificate))
    _field(out, "decides", term(certificate["claim"]) if "claim" in certificate else "")
    _field(out, "proof", "\n".join(shown(certificate)))
    if whole:
        print(
            json.dumps(certificate, ensure_ascii=False, indent=2, sort_keys=True),
            file=out.file,
        )


def _digest(certificate: Certificate) -> str:
    size = len(json.dumps(certificate, ensure_ascii=False, separators=(",", ":")).encode())
    parts = (certificate.get("id"), certificate.get("verdict"), f"sha256 {digest_of(certificate)}")
    return ", ".join(str(part) for part in (*parts, f"{size} bytes") if part)
