"""What a reader of a notebook tries: a relation changed in a cell, decided anew, and exercises with hidden answers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from symcheck.audit import obligation_of
from symcheck.audit.decide import decide_declared
from symcheck.core.claims import Assertion, Claim
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError
from symcheck.ledger import Record
from symcheck.views.notebook.errata import erratum, evaluated
from symcheck.views.notebook.live import Live, tried
from symcheck.views.notebook.output import Heading, Hidden, Output, Part, Prose
from symcheck.views.notebook.records import records
from symcheck.views.notebook.relations import checked, formula, statement


def changed(id: str, printed: Mapping[str, str] | None = None, without: Sequence[str] = ()) -> Output:
    """A relation as a reader changes it, decided here and now: its verdict, and where it fails if it does.

    The recorded relation stays as it is, and so does its verdict. Where a kernel runs that shows widgets, the formula
    can be written in, and hypotheses left out, below the cell.

    Parameters
    ----------
    id
        "mirer2009:2.12", without the letter of a link.
    printed
        Pieces of the printed LaTeX with what is to stand in their place, wherever they stand.
    without
        Names of hypotheses that are left out.

    Raises
    ------
    SymcheckError
        For a piece that is not printed, or a hypothesis that is not given; the message says what is.

    Examples
    --------
    >>> print(changed("mirer2009:2.18", without=["orthogonal"]).parts[0].text.rpartition("**")[0])
    changed (2.18) — **refuted
    """
    obligation = obligation_of(id)
    item = obligation.item
    if not isinstance(item, Assertion):
        raise SymcheckError(f"{id} is a {item.role}, which claims nothing that could be decided; choose a claim")
    names = [each.name for each in item.statement.given]
    if unknown := [each for each in without if each not in names]:
        raise SymcheckError(f"{id} is not given {unknown[0]!r}; it is given {', '.join(map(repr, names)) or 'nothing'}")
    given = tuple(each for each in item.statement.given if each.name not in without)
    texts = {"printed": item.source.printed, "states": item.statement.states}
    for piece, other in (printed or {}).items():
        if not any(piece in text for written in texts.values() for text in written):
            there = " ".join(item.source.printed or item.statement.states)
            raise SymcheckError(f"{piece!r} is not printed in {id}; there stands {there}")
        texts = {name: tuple(text.replace(piece, other) for text in written) for name, written in texts.items()}
    new = replace(
        item,
        source=replace(item.source, printed=texts["printed"], damage=None),
        statement=replace(item.statement, given=given, states=texts["states"]),
    )
    if isinstance(new, Claim):
        new = replace(new, errata={})  # what would be right instead of the recorded relation is no question here
    left_out = [each.words for each in item.statement.given if each.name in without]
    parts = [part for record in decide_declared(replace(obligation, item=new)) for part in _decided(record, left_out)]
    return Live(tuple(parts), lambda: _form(id, item, without))


def _form(id: str, item: Assertion, without: Sequence[str]) -> Any:
    """The printed formulas to write in, and the hypotheses to leave out."""
    import ipywidgets

    printed = list(item.source.printed or item.statement.states)
    given = {each.name: each.words for each in item.statement.given}
    wide = ipywidgets.Layout(width="95%")
    texts = {
        f"text_{n}": ipywidgets.Textarea(text, description="printed", layout=wide) for n, text in enumerate(printed)
    }
    boxes = {
        f"given_{name}": ipywidgets.Checkbox(name not in without, description=words, indent=False, layout=wide)
        for name, words in given.items()
    }

    def decided(**values: Any) -> Output:
        pieces = {text: values[f"text_{n}"] for n, text in enumerate(printed) if values[f"text_{n}"] != text}
        return changed(id, pieces, [name for name in given if not values[f"given_{name}"]])

    return tried(decided, {**texts, **boxes}, "Decide")


def _decided(record: Record, left_out: Sequence[str]) -> Iterator[Part]:
    yield Heading(f"changed ({Id.parse(record.id).place}) — **{record.verdict or record.role}**")
    yield formula("changed to", record.read)
    if left_out:
        yield Prose("without", "; ".join(left_out))
    if record.refutation:
        yield from evaluated(record, record.refutation, "the changed relation")
    elif record.certificates:
        yield Prose("checker", checked(record.certificates))
    elif record.reason:
        yield Prose("because", record.reason)


def exercise(id: str, question: str = "Something in it is wrong. What, and what is right?") -> Output:
    """A wrong relation as it is printed, with a question; what the audit says of it is folded away below."""
    [record] = records(id)
    shown: list[Part] = [Heading(f"**Exercise.** ({record.number}), line {record.line}")]
    if record.words:
        shown.append(Prose("", record.words))
    shown += statement([record])
    if record.hypotheses:
        shown.append(Prose("given", "; ".join(each.words or each.name for each in record.hypotheses)))
    return Output((*shown, Prose("", question), Hidden("The answer", erratum(id).parts)))
