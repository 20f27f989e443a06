"""What an audit leaves open, or says in a circle: nothing here is decided."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from symcheck.core.claims import Assertion, Declaration, Paper
from symcheck.core.ids import Id
from symcheck.core.verdicts import Role, Verdict
from symcheck.document.asked import SAY
from symcheck.document.lock import digest
from symcheck.document.paper import Document
from symcheck.document.rewriting import rewritten
from symcheck.ledger import Record
from symcheck.papers import FILES

Fault = tuple[Declaration | None, str, int, str]  # where: a declaration, else file and line; what

WITHOUT_UNIT = frozenset({"index", "differential"})  # kinds of letters that have none


def faults(paper: Paper, records: Sequence[Record]) -> Iterator[Fault]:
    """All that is to be said of an audit."""
    items = [item for _, _, item in paper.items()]
    yield from _without_role(paper, items)
    yield from _uncorrected(items, records)
    for item in items:
        yield from ((item, "", 0, text) for text in _circles(item))
    place = {item.number: k for k, item in enumerate(items)}
    for k, item in enumerate(items):
        for number in item.uses:
            of = Id.of(paper.key, number).number
            if place.get(of, -1) > k and items[place[of]].role in (Role.CLAIM, Role.OURS):
                yield item, "", 0, f"{item.number} uses {number}, which is claimed later"
    yield from _without_unit(paper)


def _without_role(paper: Paper, items: Sequence[Declaration]) -> Iterator[Fault]:
    """The relations of the source that no line of the audit names, and rules that change none of them."""
    named = {item.number for item in items}
    for document in (each for each in vars(_module(paper)).values() if isinstance(each, Document)):
        for rule in document.rules:
            if not any(rewritten(each.latex, [rule])[1] for each in document.formulas):
                yield None, str(document.folder / FILES[0]), 1, f"nothing is rewritten by {rule.text}"
        for number, formula in zip(document.numbers, document.formulas, strict=True):
            if number not in named:
                file = document.path.parent / formula.file if formula.file else document.path
                yield None, str(file), formula.line, f"{formula.place} has no role: {formula.latex}"


def _module(paper: Paper) -> object:
    return sys.modules.get(f"symcheck.papers.{paper.key}", paper)


def _uncorrected(items: Sequence[Declaration], records: Sequence[Record]) -> Iterator[Fault]:
    """Refutations without what is right, and what fails of which nobody says whether a condition is missing."""
    by_number = {item.number: item for item in items}
    for record in records:
        if record.verdict is Verdict.UNDECIDED and record.reason.endswith(SAY):
            yield by_number[Id.parse(record.id).number], "", 0, f"{record.number}: {record.reason}"
        if record.verdict is Verdict.REFUTED and not record.corrected:
            number = Id.parse(record.id).number
            yield by_number[number], "", 0, f"{record.number} is refuted, and nothing is said of what is right"


def _circles(item: Declaration) -> Iterator[str]:
    """The claim among its own hypotheses."""
    if not isinstance(item, Assertion):
        return
    texts = [item.text] if isinstance(item.text, str) else [*item.text]
    own = {digest(text) for text in texts}
    relied = [(each.states, repr(each.name)) for each in item.statement.given]
    relied += [(text, text) for text in getattr(item.question, "assumed", ())]
    for text, name in relied:
        if digest(text) in own:
            yield f"{item.number} is assumed for its own proof: {name}"


def _without_unit(paper: Paper) -> Iterator[Fault]:
    bare = [x for x in paper.notation.letters if not x.unit and x.kind not in WITHOUT_UNIT and not x.number]
    lines = dict(_letters(Path(getattr(_module(paper), "__file__", "") or "")))
    for letter in bare:
        file, line = lines.get(letter.latex.replace(" ", ""), ("", 0))
        yield None, file or paper.source, line, f"{letter.latex} has no unit; write '1' for a pure number"


def _letters(file: Path) -> Iterator[tuple[str, tuple[str, int]]]:
    """The letters that the files of an audit declare, with their places."""
    for each in sorted(file.parent.glob("*.py")) if file.is_file() else ():
        for call in ast.walk(ast.parse(each.read_text(encoding="utf-8"))):
            if isinstance(call, ast.Call) and getattr(call.func, "id", "").lower() == "letter" and call.args:
                name = getattr(call.args[0], "value", None)
                if isinstance(name, str):
                    yield name.replace(" ", ""), (str(each), call.lineno)
