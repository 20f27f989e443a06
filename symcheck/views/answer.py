"""The answer to a question, as text."""

from __future__ import annotations

from collections.abc import Mapping

from symcheck.core.counts import number_of
from symcheck.core.terms import JSON
from symcheck.dimensions import INCONSISTENT
from symcheck.question.answer import Answer
from symcheck.views.dimensions import fits, in_general


def text(answer: Answer, measured: bool = False) -> str:
    """All that a person wants to know, a line for each thing; with dimensions if units are said, or do not fit."""
    lines = [str(answer.verdict) + (f": {answer.reason}" if answer.reason else "")]
    if answer.reading:
        lines.append(f"  read as         {answer.reading}")
    if answer.letters:
        width = max(map(len, answer.letters))
        lines += [
            f"  {'letters' if n == 0 else '':15} {letter:{width}}  {taken}"
            for n, (letter, taken) in enumerate(answer.letters.items())
        ]
    if answer.counterexample:
        lines.append(f"  fails at        {', '.join(f'{x} = {v}' for x, v in answer.counterexample.items())}")
    lines += [f"  {'there' if n == 0 else '':15} {value}" for n, value in enumerate(answer.values)]
    if answer.used:
        lines.append(f"  rests on        {'; '.join(answer.used)}")
    lines += [
        f"  {'true would be' if n == 0 else '':15} {repair['relation']}" for n, repair in enumerate(answer.repairs)
    ]
    if answer.certificate:
        lines.append(
            f"  evidence        {number_of(len(answer.certificate), 'certificate')}, accepted by the checker; "
            f"--json prints {'it' if len(answer.certificate) == 1 else 'them'}"
        )
    of = answer.dimension
    if of is not None and (measured or of.verdict == INCONSISTENT):
        lines += [f"  {'dimension' if n == 0 else '':15} {line}" for n, line in enumerate((*fits(of), *in_general(of)))]
    if measured and (form := answer.general) is not None:
        lines.append(f"  in general      proved too, with {number_of(len(form.certificate), 'certificate')}")
    lines.append(f"  {answer.seconds:.2f} s")
    return "\n".join(lines)


def line(answer: Mapping[str, JSON]) -> str:
    """One line of a batch."""
    reason = f"  {answer['reason']}" if answer["reason"] else ""
    return f"{answer['id']}  {answer['verdict']}  {answer['reading']}{reason}"
