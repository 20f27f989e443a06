"""`symcheck.decide`: the verdict on one formula."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping

from symcheck.checker import check
from symcheck.core.calculus import letters
from symcheck.core.terms import Relation
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.proof import certificate, identity
from symcheck.question.answer import Answer, Status
from symcheck.question.prepare import Asked, Reading, readings
from symcheck.reading import to_latex


def decide(
    relation: str,
    where: Iterable[str] | str = (),
    given: Iterable[str] | str = (),
    letters: Mapping[str, str] | None = None,
) -> Answer:
    started = time.perf_counter()
    asked = Asked(relation, _several(where), _several(given), tuple((letters or {}).items()))
    try:
        found = [(reading, _decided(reading, asked)) for reading in readings(asked)]
    except SymcheckError as error:
        return Answer(Status.UNREADABLE, reason=str(error), seconds=time.perf_counter() - started)
    from dataclasses import replace

    verdicts = {answer.verdict for _, answer in found}
    seconds = time.perf_counter() - started
    if len(verdicts) == 1:
        return replace(found[0][1], seconds=seconds)
    shown = "; ".join(f"{', '.join(r.inference.choices)}: {a.verdict}" for r, a in found)
    return Answer(Status.AMBIGUOUS, reading=" | ".join(a.reading for _, a in found), reason=shown, seconds=seconds)


def _several(texts: Iterable[str] | str) -> tuple[str, ...]:
    return (texts,) if isinstance(texts, str) else tuple(texts)


def _decided(reading: Reading, asked: Asked) -> Answer:
    shown = {g.letter.latex: f"{g.taken} ({g.why})" for g in reading.inference.guesses}
    base = Answer(Status.UNDECIDED, to_latex(reading.tree), shown)
    from dataclasses import replace

    certificates, status, reasons = [], Status.PROVED, []
    for problem in reading.problems:
        outcome = identity.decide(problem)
        if outcome.verdict is Verdict.UNDECIDED:
            status = Status.UNDECIDED
            reasons.append(outcome.reason)
            continue
        made = certificate(problem, outcome)
        if (fault := check(made)) is not None:
            status = Status.UNDECIDED
            reasons.append(f"the certificate was not accepted ({fault})")
            continue
        certificates.append(made)
        if outcome.verdict is Verdict.REFUTED:
            point = {x: str(v) for x, v in made["point"]["values"].items()}
            return replace(base, verdict=Status.REFUTED, counterexample=point, certificate=(made,))
    return replace(base, verdict=status, certificate=tuple(certificates), reason="; ".join(dict.fromkeys(reasons)))
