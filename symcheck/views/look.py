"""The first look at a document, as text: what to look at comes last."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Sequence

from symcheck.core.counts import number_of
from symcheck.document.letters import shown
from symcheck.document.look import Finding, Look

WIDTH = 80  # columns
MOST_PLACES = 12  # of one refusal
LONGEST = 300  # characters of a formula that is shown


def text(look: Look) -> str:
    """All of it, in lines of 80 columns."""
    return "\n".join(_lines(look))


def _lines(look: Look) -> Iterator[str]:
    displays = sum(formula.display for formula in look.formulas)
    inline = len(look.formulas) - displays
    read = sum(look.read)
    yield from _wrapped(
        f"{look.file}: {number_of(displays, 'display')}, {number_of(inline, 'inline relation')}; "
        f"{read} read, {len(look.read) - read} not; {look.seconds:.1f} s"
    )
    for note in look.notes:
        yield from _wrapped(f"left out: {note}")
    yield from ("", f"Letters ({len(look.letters)})")
    names = [shown(each.letter) for each in look.letters]
    width = min(16, max(map(len, names), default=0))
    for name, each in zip(names, look.letters, strict=True):
        taken = f"not the same everywhere: {', '.join(each.others)}" if each.others else f"{each.taken} ({each.why})"
        yield from _wrapped(f"{name:{width}}  {taken}", "  ", " " * (width + 4))
    if look.refusals:
        yield from ("", f"Not read ({len(look.read) - read})")
    for refusal in look.refusals:
        yield from _wrapped(f"{len(refusal.places):4}  {refusal.reason}", "", " " * 6)
        yield from _wrapped(_places(refusal.places, MOST_PLACES), " " * 6, " " * 6)
    if look.valueless:
        yield from ("", f"Read, but something in it has no value ({sum(len(each.places) for each in look.valueless)})")
    for refusal in look.valueless:
        yield from _wrapped(f"{len(refusal.places):4}  {refusal.reason}", "", " " * 6)
        yield from _wrapped(_places(refusal.places, MOST_PLACES), " " * 6, " " * 6)
    for title, places in (
        ("Hold for all values of their letters", look.holds),
        ("Follow from relations before them", look.follows),
    ):
        if places:
            yield from ("", f"{title} ({len(places)})", *_wrapped(_places(places), "  ", "  "))
    yield from ("", f"To look at ({len(look.findings)})" if look.findings else "Nothing to look at was found.")
    for finding in look.findings:
        yield from _finding(finding)


def _finding(finding: Finding) -> Iterator[str]:
    yield from _wrapped(f"{finding.place}: {finding.message}", "  ", "    ")
    for name, values in (
        ("", [finding.formula] if finding.formula else []),
        ("at", [", ".join(f"{x} = {value}" for x, value in finding.point.items())] if finding.point else []),
        ("there", finding.values),
        ("but", finding.dimensions),
        ("as", finding.units),
        ("with", finding.definitions),
        ("holds", finding.nearest),
    ):
        for n, value in enumerate(values):
            yield from _wrapped(f"{name if not n else '':6}{_short(value)}", "    ", " " * 10)


def _places(places: Sequence[str], most: int = 1000) -> str:
    """Places, with the word `line` once where all of them are lines."""
    named = [*places[:most]]
    if len(named) > 1 and all(place.startswith("line ") for place in named):
        named = ["lines " + named[0][5:], *(place[5:] for place in named[1:])]
    more = f" and {len(places) - most} more" if len(places) > most else ""
    return ", ".join(named) + more


def _short(formula: str) -> str:
    return formula if len(formula) <= LONGEST else formula[: LONGEST - 3] + "..."


def _wrapped(line: str, first: str = "", rest: str = "  ") -> Iterable[str]:
    return textwrap.wrap(line, WIDTH, initial_indent=first, subsequent_indent=rest, break_on_hyphens=False) or [""]
