"""Saboteurs inside the ledger: proof methods, provers, the reader and the cache lie, and the ledger must not repeat it.

What judges is what judges every day: `run.audit`, with the deciding of `evidence.decide`, the check of
`audit.checked.accepted` and the file of `audit.cache`. Only the part that a saboteur has taken over is another one.
"""

from __future__ import annotations

import json
import re
import sqlite3
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any
from unittest.mock import patch

from msgspec import structs

from symcheck import papers
from symcheck.audit import (
    Cache,
    Context,
    Index,
    Serial,
    context_of,
    decide,
    fingerprint,
    judge,
    obligation_of,
    run,
    units,
)
from symcheck.audit.cache import FILE
from symcheck.checker.statements import Index as StatementIndex
from symcheck.core.calculus import letters
from symcheck.core.certificates import Certificate
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import node
from symcheck.core.verdicts import Role, SymcheckError, Verdict
from symcheck.ledger import Record, store
from symcheck.proof import fails_at, identity
from symcheck.proof.algebra.polynomial import unfold
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.identity import Identity
from symcheck.proof.rules.proof import Proof
from symcheck.proof.rules.step import Whole
from symcheck.reading import read
from symcheck.selftest.statements import declared
from symcheck.selftest.trial import FaultClass, Status, Trial

PROVED = Outcome(Verdict.PROVED, proof=Proof(Whole(Identity())))
DOUBLE = Problem("double", node("=", node("+", "x", "x"), node("*", 2, "x")))
LIMIT = 60.0  # seconds for one declaration
MOST = 20_000  # characters of the certificates of a declaration: some proofs hang on longer ones for minutes
OTHER = {Verdict.PROVED: Verdict.REFUTED, Verdict.REFUTED: Verdict.PROVED}
Decide = Callable[[Problem], Outcome]
Truth = Mapping[str, Verdict]


def always_yes(problem: Problem) -> Outcome:
    """Everything is proved."""
    return PROVED


def always_no(problem: Problem) -> Outcome:
    """Everything is refuted, at the point where all letters are 1."""
    stated = (0, 1) if len(problem.claim) == 3 else ()
    return Outcome(Verdict.REFUTED, point=Point(dict.fromkeys(_letters(problem), 1), stated))


def compares_with_itself(problem: Problem) -> Outcome:
    """The left side equals the left side."""
    claim = problem.claim
    side = claim.terms[0] if claim.tag == "=" else 0
    return identity.decide(replace(problem, claim=node("=", side, side)))


def swallows_exceptions(problem: Problem) -> Outcome:
    """What fails is taken for done."""
    try:
        raise NotImplementedError
    except Exception:
        return PROVED


def none_is_true(problem: Problem) -> Outcome:
    """Where no proof was found, none is taken for one."""
    outcome = identity.decide(replace(problem, hypotheses=()))
    return PROVED if outcome.proof is None else outcome


def one_sample_point(problem: Problem) -> Outcome:
    """Holds where all letters are 1, so it holds."""
    return Outcome(Verdict.UNDECIDED, reason="no") if fails_at(problem, dict.fromkeys(_letters(problem), 1)) else PROVED


def ignores_the_domain(problem: Problem) -> Outcome:
    """Takes a counterexample where it finds one, in force or not."""
    return identity.decide(replace(problem, hypotheses=()))


def assumes_the_claim(problem: Problem) -> Outcome:
    """Treats the claim as one of its own hypotheses: everything follows."""
    return identity.decide(replace(problem, hypotheses=(*problem.hypotheses, ("assumed", (problem.claim,)))))


def proves_another_statement(problem: Problem) -> Outcome:
    """The proof of one statement for every other one."""
    return identity.decide(DOUBLE)


SABOTEURS: tuple[Decide, ...] = (
    always_yes,
    always_no,
    compares_with_itself,
    swallows_exceptions,
    none_is_true,
    one_sample_point,
    ignores_the_domain,
    assumes_the_claim,
    proves_another_statement,
)


def _letters(problem: Problem) -> list[str]:
    """The letters without a definition."""
    definitions = dict(problem.definitions)
    formulas = [problem.claim, *(formula for _, stated in problem.hypotheses for formula in stated)]
    return sorted(set().union(*(letters(unfold(formula, definitions)) for formula in formulas)))


def _answer(saboteur: Decide, problem: Problem) -> Outcome:
    """A method that fails answers nothing."""
    try:
        return saboteur(problem)
    except Exception:
        return Outcome(Verdict.UNDECIDED, reason="it failed")


def _proof(saboteur: Decide, problem: Problem) -> Outcome | None:
    outcome = _answer(saboteur, problem)
    return outcome if outcome.verdict is Verdict.PROVED else None


def _point(saboteur: Decide, problem: Problem) -> Point | None:
    return _answer(saboteur, problem).point


@contextmanager
def sabotaged(saboteur: Decide) -> Iterator[None]:
    """All methods and provers of the ledger are the saboteur."""
    method = Context.method
    answer, proof, point = partial(_answer, saboteur), partial(_proof, saboteur), partial(_point, saboteur)
    with (
        _forgetful(),
        patch.object(Context, "method", lambda context, letter: replace(method(context, letter), decide=answer)),
        patch.object(judge, "proof_of", proof),
        patch.object(judge, "refute", point),
        patch.object(judge, "_is_vacuous", lambda *_: False),
    ):
        yield


@contextmanager
def _reading(drop: Callable[[str], str]) -> Iterator[None]:
    """Every text of a declaration is read without something."""

    def other(latex: str | tuple[str, ...], *rest: Any) -> Any:
        return read(tuple(map(drop, latex)) if isinstance(latex, tuple) else drop(latex), *rest)

    with _forgetful(), patch.object(judge, "read", other):
        yield


@contextmanager
def _forgetful() -> Iterator[None]:
    """What was proved before is not known, and what is proved now is forgotten."""
    judge.lemma.cache_clear()
    try:
        yield
    finally:
        judge.lemma.cache_clear()


def audited(id: str, folder: Path | None = None, decider: Any = decide) -> list[Record]:
    """What an audit of one declaration reports, with a cache in this folder."""
    kept = Cache(folder, lambda _: None)
    try:
        known, serial = papers.load(), Serial()
        return run.audit([id], papers=known, decide=decider, cache=kept, executor=serial, timeout=LIMIT, weigh=False)
    finally:
        kept.close()


class Relabelling:
    """A decider that turns every verdict round, and keeps the certificates, with their verdicts turned round too."""

    expand = staticmethod(decide.expand)
    fingerprint = staticmethod(decide.fingerprint)
    weigh = staticmethod(decide.weigh)

    @staticmethod
    def decide(id: str) -> tuple[Record, ...]:
        return tuple(map(turned, decide.decide(id)))


def turned(record: Record) -> Record:
    """A record with the other verdict."""
    if record.verdict not in OTHER:
        return record
    other = OTHER[record.verdict]
    spoilt = tuple(Certificate(**{**evidence, "verdict": str(other)}) for evidence in record.certificates)
    return structs.replace(record, verdict=other, certificates=spoilt)


def from_cache(id: str, signed: bool) -> list[Record]:
    """The outcome for a declaration whose cached row says the contrary, with a valid signature or not."""
    rows = decide.decide(id)
    false = tuple(map(turned, rows))
    with TemporaryDirectory() as name:
        folder = Path(name)
        kept = Cache(folder, lambda _: None)
        kept.put(id, fingerprint(obligation_of(id)), false if signed else rows)
        kept.close()
        if not signed:
            text = json.dumps([record.to_json() for record in false], ensure_ascii=False)
            with closing(sqlite3.connect(folder / FILE)) as connection, connection:
                connection.execute("UPDATE records SET records = ?", (text,))
        return audited(id, folder)


def dropped(latex: str, share: float) -> str:
    """The text without one of its tokens, the one so far along."""
    tokens = list(re.finditer(r"\\[A-Za-z]+|\\.|\d|[^\s\\]", latex))
    if len(tokens) < 2:
        return latex
    token = tokens[int(share * len(tokens))]
    return latex[: token.start()] + " " + latex[token.end() :]


def _reader_drops(id: str, truth: Truth, rng: Random) -> Status:
    """What becomes of a declaration that is read without a token, which is layout if it is read the same without it.

    It is noticed if it cannot be read, if the verdict is not the recorded one, or if the certificates do not claim what
    a fresh reading states: by this the checker ties them to the print.
    """
    share, obligation = rng.random(), obligation_of(id)
    context = context_of(obligation)
    before = [unit.formulas for unit in units(context)]
    statements = _statements(obligation.paper.key)
    try:
        with _reading(partial(dropped, share=share)):
            if [unit.formulas for unit in units(context)] == before:
                return Status.EQUIVALENT
            records = audited(id)
    except SymcheckError:
        return Status.REJECTED
    noticed = store.disagreements([record for record in records if record.id in truth], truth, complete=True)
    shown = [evidence for record in records for evidence in record.certificates]
    names = tuple(f"{record.id}:" for record in records)
    noticed += [line for line in statements.differences(shown) if line.startswith(names)]
    return Status.REJECTED if noticed else Status.ACCEPTED


@cache
def _statements(key: str) -> StatementIndex:
    """What the relations of a paper state, read anew."""
    index = Index(papers.load()[key])
    known = {"definitions": index.definitions, "hypotheses": index.hypotheses, "statements": index.statements}
    return StatementIndex(json.loads(json.dumps(known)))


def status_of(truth: Truth, records: Sequence[Record], equal: Status) -> Status:
    """Outcomes that differ from the truth: false verdicts are accepted faults."""
    verdicts = {record.id: record.verdict for record in records}
    if any(verdicts.get(id) is OTHER[verdict] for id, verdict in truth.items()):
        return Status.ACCEPTED
    return equal if all(verdicts.get(id) is verdict for id, verdict in truth.items()) else Status.REJECTED


def _by_saboteur(saboteur: Decide, id: str, truth: Truth, rng: Random) -> Status:
    with sabotaged(saboteur):
        return status_of(truth, audited(id), Status.EQUIVALENT)  # it happened to be right


def _relabelled(id: str, truth: Truth, rng: Random) -> Status:
    return status_of(truth, audited(id, decider=Relabelling), Status.ACCEPTED)


def _cache_row(id: str, truth: Truth, rng: Random, signed: bool) -> Status:
    return status_of(truth, from_cache(id, signed), Status.REJECTED)  # it was decided anew


KINDS: dict[str, Callable[[str, Truth, Random], Status]] = {
    **{saboteur.__name__.replace("_", " "): partial(_by_saboteur, saboteur) for saboteur in SABOTEURS},
    "rows relabelled": _relabelled,
    "cache row edited": partial(_cache_row, signed=False),
    "cache row signed": partial(_cache_row, signed=True),
    "reader drops a token": _reader_drops,
}


def _places(records: Sequence[Record]) -> list[str]:
    """Declarations with a refuted relation, and as many without one; each with what is true of its relations."""
    found: dict[str, dict[str, Verdict]] = {}
    size: dict[str, int] = {}
    for record in records:
        if record.verdict in OTHER and record.role in (Role.CLAIM, Role.OURS):
            id = declared(record)
            found.setdefault(id, {})[record.id] = record.verdict
            size[id] = size.get(id, 0) + len(json.dumps(record.certificates))
    short = {id: truth for id, truth in found.items() if size[id] < MOST}
    refuted = [json.dumps([id, truth]) for id, truth in short.items() if Verdict.REFUTED in truth.values()]
    proved = [json.dumps([id, truth]) for id, truth in short.items() if Verdict.REFUTED not in truth.values()]
    return refuted + proved[:: max(1, len(proved) // max(1, len(refuted)))]


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """Each saboteur in the ledger, for one declaration."""
    id, verdicts = json.loads(place)
    truth = {name: Verdict(verdict) for name, verdict in verdicts.items()}
    for kind in rng.sample([*KINDS], min(count, len(KINDS))):
        yield Trial(kind, id, KINDS[kind](id, truth, rng))


CLASS = FaultClass(
    "saboteurs",
    "sabotaged methods, provers, readers and caches, inside the ledger",
    (*KINDS,),
    share=150,
    places=_places,
    trials=trials,
)
