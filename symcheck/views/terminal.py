"""How records look on a terminal: the ledger, one relation in full, the errata, the papers. Computes nothing."""

from __future__ import annotations

import json
import os
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from rich import box
from rich.cells import cell_len, set_cell_size
from rich.console import Console
from rich.table import Table
from rich.text import Text

from symcheck.audit.dimensions import Unit
from symcheck.core.certificates import Certificate
from symcheck.core.claims import Paper
from symcheck.core.counts import number_of
from symcheck.core.verdicts import Group, Verdict
from symcheck.dimensions import INCONSISTENT, UNDETERMINED
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.ledger import Record, digest_of
from symcheck.ledger.changes import Change
from symcheck.views import model
from symcheck.views.diagnostics import near
from symcheck.views.dimensions import conflict, fits, in_general, unlike
from symcheck.views.model import FaultList, Relation
from symcheck.views.steps import claim, proof_lines

if TYPE_CHECKING:
    from symcheck.question.answer import General

_STYLES = {Verdict.PROVED: "green", Verdict.REFUTED: "bold red", Verdict.UNDECIDED: "yellow"}
_METHOD, _STATEMENT = 28, 30  # columns of the ledger: the method at most, the statement at least
_LISTED = 40  # faults, or reasons why nothing is decided, at the end of a ledger: about a screen
_REPAIRS = 3  # edits that repair a relation, listed one by one; a longer list says nothing new
_ALWAYS = 3  # the columns of a ledger that are never left out: number, statement, verdict
_INDENT = 14  # of the values beside their labels
_WIDTH = 150  # of a ledger that goes to a file or a pipe


class _Console(Console):
    def on_broken_pipe(self) -> None:
        """The command line decides what a closed pipe means."""
        raise BrokenPipeError


def console() -> Console:
    """The standard output; a fixed width unless it is a terminal, so that a saved ledger is always the same."""
    width = None if sys.stdout.isatty() or "COLUMNS" in os.environ else _WIDTH
    return _Console(width=width, highlight=False, markup=False, emoji=False)


@contextmanager
def progress_bar(what: str) -> Iterator[Callable[[int, int], None]]:
    """A function (done, total) that moves a progress bar on standard error."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn(what), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(what, total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)


def ledger(out: Console, paper: str, records: Iterable[Record]) -> None:
    """One row per relation of a paper: number, statement, verdict, and what has room of reading, method, time.

    Written line by line: a library's table takes a second to lay out two thousand rows that need no wrapping.
    """
    rows = [("number", "statement", "verdict", "reading", "method", "time")]
    for relation in map(Relation, records):
        record = relation.record
        seconds = f"{record.seconds:.3f} s" if record.verdict else ""
        rows += [(record.number, statement(relation), relation.state, record.reading, record.method, seconds)]
    widths = [max(map(cell_len, column)) for column in zip(*rows, strict=True)]
    widths[4] = min(widths[4], _METHOD)
    while len(widths) > _ALWAYS and (room := _room(out.width, widths)) < _STATEMENT:
        widths.pop()
    widths[1] = max(room, 1)
    out.print(Text(paper, style="bold"))
    for n, row in enumerate(rows):
        number, said, verdict, *others = map(_fitted, row, widths)
        if len(widths) == len(row):
            others[-1] = others[-1].strip().rjust(widths[-1])
        style = _STYLES.get(row[2], "dim") if n else "bold"  # type: ignore[call-overload]
        line = Text.assemble(f" {number}  {said}  ", (verdict, style), *(f"  {each}" for each in others))
        out.print(line, style="bold" if not n else "", soft_wrap=True)
        if not n:
            out.print(Text(" " + "─" * (out.width - 2)), soft_wrap=True)
    out.print()


def _room(width: int, widths: Sequence[int]) -> int:
    """The columns that are left for the statement."""
    return width - sum(widths) + widths[1] - 2 * len(widths)


def _fitted(text: str, width: int) -> str:
    """The text in so many columns of the terminal."""
    return set_cell_size(text, width) if cell_len(text) <= width else set_cell_size(text, width - 1) + "…"


def findings(out: Console, records: Sequence[Record]) -> None:
    """What is not decided, with the reason, then what is wrong: the serious faults by name, the others counted."""
    undecided = [record for record in records if record.verdict is Verdict.UNDECIDED]
    _listed(out, "Not decided", ((record.id, record.reason or "no reason is known") for record in undecided))
    faults = [(fault, group) for group, lists in model.errata(records) for each in lists for fault in each.faults]
    serious = [fault for fault, group in faults if group is Group.STATEMENT]
    _listed(out, "Wrong as printed", ((each.first.record.id, each.first.fault) for each in serious))
    others = Counter(group for fault, group in faults if group is not Group.STATEMENT for _ in fault.relations)
    if others:
        counted = "; ".join(f"{group}: {count}" for group, count in others.items())
        _wrapped(out, f"{'And' if serious else 'Wrong as printed:'} {counted}")
    open_ = [record for record in records if record.dimension and record.dimension.verdict == UNDETERMINED]
    _listed(out, "Dimensions that are not determined", ((each.id, unlike(each.dimension)) for each in open_))
    conflicts = [record for record in records if record.dimension and record.dimension.verdict == INCONSISTENT]
    _listed(out, "Dimensions that do not fit", ((each.id, conflict(each.dimension)) for each in conflicts))
    kinds = Counter(record.kind for record in records if record.verdict is Verdict.REFUTED and record.kind)
    if kinds.total() > 1:
        _wrapped(
            out, f"Causes of what is refuted: {', '.join(f'{count} {kind}' for kind, count in kinds.most_common())}"
        )
    if undecided or faults or open_ or conflicts:
        out.print()


def changes(out: Console, name: str, found: Sequence[Change]) -> None:
    """What changed since an older ledger: the verdicts by name, all else counted."""
    verdicts = [each for each in found if each.verdict]
    others = Counter(each.what.partition(":")[0].partition(";")[0] for each in found if not each.verdict)
    counted = Counter(each.what for each in verdicts) + others
    said = "; ".join(f"{count} {what}" for what, count in counted.most_common())
    _wrapped(out, f"Since {name}: {said or 'nothing has changed'}")
    _listed(out, "Other verdicts", ((each.id, each.what) for each in verdicts))
    out.print()


def _listed(out: Console, title: str, rows: Iterable[tuple[str, str]]) -> None:
    """Ids with what is said of each, as many as are read at once."""
    listed = list(rows)
    if not listed:
        return
    out.print(Text(f"{title}: {len(listed)}", style="bold"))
    width = max(cell_len(id) for id, _ in listed[:_LISTED])
    for id, said in listed[:_LISTED]:
        _wrapped(out, said.replace("$", ""), Text(f" {id.ljust(width)}  "))
    if len(listed) > _LISTED:
        out.print(f" and {len(listed) - _LISTED} more")


def next_steps(out: Console, records: Sequence[Record], folders: Mapping[str, Path]) -> None:
    """Commands that show more of what was found; a paper of a folder is called by its folder."""
    wrong = (fault.first.record for _, lists in model.errata(records) for each in lists for fault in each.faults)
    undecided = (record for record in records if record.verdict is Verdict.UNDECIDED)
    example = next(wrong, None) or next(undecided, None)
    if example:
        name = near(folders[example.paper]) + os.sep if example.paper in folders else example.paper
        errata = [f"symcheck errata {name}"] if example.is_erratum else []
        commands = [f"symcheck show {name}:{example.number}", *errata, f"symcheck report {name} --open"]
        _wrapped(out, "Next: " + ", ".join(f"`{each}`" for each in commands))


def summary(out: Console, records: Sequence[Record]) -> None:
    """How many of each verdict, and how many declarations that claim nothing."""
    others = Counter(record.role for record in records if not record.verdict)
    rest = f"; {model.roles(dict(sorted(others.items())))}" if others else ""
    first, *more = model.headline(records)
    for line in (f"{first}{rest}", *more):
        _wrapped(out, line)


def show(out: Console, record: Record, whole_certificate: bool = False, general: General | None = None) -> None:
    """Everything that is known of one relation, and its form for any value of a quantity that is printed as 1."""
    relation = Relation(record)
    out.print(Text(relation.title, style="bold"))
    _print(out, _fields(relation))
    for certificate in record.certificates:
        _certificate(out, certificate, whole_certificate)
    if general:
        _print(out, [("in general", f"{general.relation}: proved too")])
        for certificate in general.certificate:
            _certificate(out, certificate, whole_certificate)


def _fields(relation: Relation, as_erratum: bool = False) -> Iterator[tuple[str, str | Text]]:
    """What is known of a relation, each with its label; of one `as_erratum` what is wrong and what is right."""
    record, erratum = relation.record, relation.record.erratum
    if erratum:
        yield "in short", erratum.summary.replace("$", "")
        yield "to print", erratum.instead.replace("$", "")
    yield "verdict", _verdict(relation)
    yield "reading", record.reading
    yield "role", f"{record.role}, section {record.section}, line {record.line} of the source"
    yield "printed", record.printed
    yield "words", record.words
    yield "in the text", record.place
    yield "read as", record.read
    if not as_erratum:
        yield "reason", record.reason.replace("$", "")
        for each in relation.conditions:
            yield "hypothesis", f"{each.line}; without it {each.without}" if each.without else each.line
        yield "shown where", relation.nonzero
        yield "method", f"{record.method}, {record.seconds:.3f} s" if record.method else ""
        yield "uses", ", ".join(record.uses)
        yield "used by", ", ".join(record.used_by)
    yield "fails at", relation.fails_at
    if record.dimension and (not as_erratum or record.dimension.verdict == INCONSISTENT):
        yield "dimension", "\n".join((*fits(record.dimension), *in_general(record.dimension)))
    yield "corrected", record.corrected
    yield "kind", record.kind
    yield "origin", f"{relation.whose}: {record.reason}".replace("$", "") if record.origin else ""
    if erratum:
        yield "edit", "\n".join(f"{before}  →  {after}" for before, after in relation.edits)
        if erratum.edit and relation.repairs:
            listed = [f"{each.edit}: {each.relation}" for each in erratum.repairs or ()]
            more = [f"and {len(listed) - _REPAIRS} more (--json lists them)"] if len(listed) > _REPAIRS else []
            yield "repairs", "\n".join((relation.repairs, *listed[:_REPAIRS], *more))
        yield "given", "; ".join(relation.added)
        yield "then", relation.outcome
        for certificate in erratum.certificates:
            yield "its proof", _digest(certificate)
        if relation.exposed:
            yield "exposed", "by dimension alone: what is right is consistent"
    if not as_erratum:
        yield "Coq confirms", relation.coq


def kernel(out: Console, key: str, name: str, declared: Kernel, records: Iterable[Record]) -> None:
    """What a kernel computes, how accurately, and the relations it rests on, each with its verdict and certificates."""
    shown = declared.derived()
    out.print(Text(f"{name}  generated/{key}.py", style="bold"))
    accuracy = f"{declared.ulp} ulp. {declared.condition} {declared.degenerate}"
    fields: list[tuple[str, str | Text]] = [("says", declared.says)]
    fields += [(output.name, f"{shown[output.name]}    {output.meaning}, {output.unit}") for output in declared.outputs]
    fields += [
        (f"  {argument.name}", f"{argument.meaning}, {argument.unit}; {argument.domain}")
        for argument in declared.arguments
    ]
    fields += [("accuracy", " ".join(accuracy.split()))]
    for record in records:
        fields += [("rests on", f"{record.id}, line {record.line}: {record.read}")]
        fields += [("verdict", _verdict(Relation(record)))]
        fields += [("certificate", _digest(certificate)) for certificate in record.certificates]
    _print(out, fields)


def errata(out: Console, records: Iterable[Record]) -> None:
    """What is wrong as printed, the weightiest first: statements in full, rows and slips of one kind in a table."""
    for group, lists in model.errata(records):
        count = sum(len(each.relations) for each in lists)
        out.print(Text(f"{group} ({count})".upper(), style="bold cyan"), end="\n\n")
        for faults in lists:
            if group is Group.STATEMENT:
                for relation in faults.relations:
                    out.print(Text(relation.title, style="bold"))
                    _print(out, _fields(relation, as_erratum=True))
                    out.print()
            else:
                _table(out, faults)


def counted_errata(out: Console, records: Sequence[Record]) -> None:
    """How many errata there are, what they are, and whose."""
    damaged = sum(record.group is Group.DAMAGED for record in records)
    places = f"; {number_of(damaged, 'place')} of damaged text" if damaged else ""
    _wrapped(out, model.erring(records) + places)
    if blamed := model.blame(records):
        _wrapped(out, f"Refuted: {blamed}")


def _table(out: Console, faults: FaultList) -> None:
    """Errata of one kind: where, as printed, what is right, and why where that is not the reason of most of them."""
    out.print(Text(faults.title, style="bold"))
    common, *others = faults.reasons or [""]
    if common:
        out.print(Text(common), soft_wrap=True)
    table = Table("number", "line", "printed", "correct", box=box.SIMPLE_HEAD, pad_edge=False)
    if others:
        table.add_column("why")
    for fault in faults.faults:
        record = fault.first.record
        cells = [fault.number, str(record.line), *fault.compared[1:]]
        why = [record.reason if record.reason != common else ""] if others else []
        table.add_row(*(Text(" ".join(cell.split())) for cell in (*cells, *why)))
    out.print(table)


def papers(out: Console, counts: Mapping[str, tuple[Paper, Counter[str]]]) -> None:
    """One row per paper: key, title, source, how many declarations of each role."""
    table = Table("key", "title", "source", "declarations", box=box.SIMPLE_HEAD, pad_edge=False)
    for key, (paper, roles) in counts.items():
        table.add_row(key, Text(paper.title), Text(paper.source), model.roles(roles))
    out.print(table)


def units(out: Console, rows: Iterable[Unit]) -> None:
    """One row per letter: how it is printed, what it measures, who says so, what it stands for."""
    table = Table("letter", "measures", "says", "meaning", box=box.SIMPLE_HEAD, pad_edge=False)
    for row in rows:
        table.add_row(*map(Text, (row.letter, row.measures, row.source, row.meaning)))
    out.print(table)


def statement(relation: Relation) -> str:
    """What a ledger row says in one line: in words rather than in LaTeX, but for the link of a chain."""
    record = relation.record
    return " ".join((relation.statement if record.link else record.words or relation.statement).split())


def _verdict(relation: Relation) -> Text:
    verdict = relation.record.verdict
    return Text(relation.state, style=_STYLES[verdict] if verdict else "dim")


def _print(out: Console, fields: Iterable[tuple[str, str | Text]]) -> None:
    """Labelled values, each beside its label. Nothing for an empty value."""
    for label, value in fields:
        if value:
            _wrapped(out, value, Text(label.ljust(_INDENT), style="cyan"))


def _wrapped(out: Console, value: str | Text, before: Text | None = None) -> None:
    """Words on as many lines of the terminal as they need, none torn; whole lines for a file or a pipe."""
    before = before or Text()
    text = value if isinstance(value, Text) else Text(value)
    on_screen = out.is_terminal or "COLUMNS" in os.environ
    lines = [*_on_screen(out, text, out.width - before.cell_len)] if on_screen else text.split("\n")
    for n, line in enumerate(lines):
        line.rstrip()
        out.print(Text.assemble(before if n == 0 else " " * before.cell_len, line), soft_wrap=True)


def _on_screen(out: Console, text: Text, width: int) -> Iterator[Text]:
    """Lines of at most so many columns; what goes on in another one is as far from the margin as where it began."""
    for line in text.split("\n", allow_blank=True):
        indent = len(line.plain) - len(line.plain.lstrip())
        margin = indent if 2 * indent < width else 0
        for part in line[indent:].wrap(out, max(width - margin, 1)) or [Text()]:
            yield Text.assemble(" " * margin, part)


def _certificate(out: Console, certificate: Certificate, whole: bool) -> None:
    fields = {"certificate": _digest(certificate), "decides": claim(certificate)}
    _print(out, {**fields, "proof": "\n".join(proof_lines(certificate))}.items())
    if whole:
        print(json.dumps(certificate, ensure_ascii=False, indent=2, sort_keys=True), file=out.file)


def _digest(certificate: Certificate) -> str:
    size = len(json.dumps(certificate, ensure_ascii=False, separators=(",", ":")).encode())
    return f"{certificate['id']}, {certificate['verdict']}, sha256 {digest_of(certificate)}, {size} bytes"
