"""Certificates with one thing changed: a coefficient, a relation, a name, or the list of hypotheses."""

from __future__ import annotations

import copy
import json
import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from random import Random
from typing import Any, NamedTuple

from symcheck.audit.judge import lemma
from symcheck.core.certificates import Certificate
from symcheck.core.formulas import CONTRARY, conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import RELATIONS, Formula, Reader, node
from symcheck.core.verdicts import Loss
from symcheck.ledger import Record, lemmas_of, reached
from symcheck.proof import fails_without, proof_of
from symcheck.selftest.evidence import MALFORMED, holds, is_proved, problem_of
from symcheck.selftest.trial import FaultClass, Status, Trial, drawn

TURNED = {sign: CONTRARY[sign] for sign in RELATIONS}
BATCH = 40  # certificates that one task goes through
Path = tuple[str | int, ...]
DROPPED: object = None  # stands for no new value


class Change(NamedTuple):
    """A change of a certificate: its kind, what it is in words, and new values by place."""

    kind: str
    words: str
    values: tuple[tuple[Path, object], ...]

    def of(self, original: Certificate) -> Certificate:
        """The changed certificate."""
        new = copy.deepcopy(original)
        for path, value in self.values:
            place: Any = new
            for key in path[:-1]:
                place = place[key]
            if value is not DROPPED:
                place[path[-1]] = copy.deepcopy(value)
            elif not isinstance(place, dict) or path[-1] in place:
                del place[path[-1]]
        return new


def one(kind: str, words: str, path: Path, value: object) -> Change:
    """A change at one place."""
    return Change(kind, words, ((path, value),))


def changes(original: Certificate) -> Iterator[Change]:
    """Every number, letter, sign, cofactor, relation, fact, hypothesis and coordinate, each changed alone."""
    for path, value in places(original):
        name = "/".join(map(str, path))
        match path:
            case (("claim" | "definitions" | "hypotheses"), *_):
                yield from _of_statement(path, value, name)
                if path[0] == "hypotheses" and len(path) == 3:
                    yield one("hypothesis list", f"{name} dropped", path, DROPPED)
            case "proof", *_:
                yield from _of_proof(original, path, value, name)
            case "point", _, _, *_:
                yield from _of_point(path, value, name)


def _of_statement(path: Path, value: object, name: str) -> Iterator[Change]:
    if type(value) is int:
        yield one("coefficient", f"{name}: {value} + 1", path, value + 1)
    elif isinstance(value, str) and path[-1] == 0 and value in TURNED:
        yield one("relation", f"{name}: {value} -> {TURNED[value]}", path, TURNED[value])
    elif isinstance(value, str) and path[-1] != 0 and re.fullmatch(r"\w+_\d+", value):
        other = value[:-1] + str(int(value[-1]) % 3 + 1)
        yield one("index", f"{name}: {value} -> {other}", path, other)


def _of_proof(original: Certificate, path: Path, value: object, name: str) -> Iterator[Change]:
    match value:
        case str() if path[-3:-2] == ("cofactors",) and path[-1] != 0:
            yield from (one("coefficient", f"{name}: {text}", path, text) for text in polynomial_edits(value))
        case list() if len(path) >= 2 and path[-2] == "cofactors":
            yield one("hypothesis list", f"{name} dropped", path, DROPPED)
        case ["hyp", str(label), number]:
            for k in range(len(original["hypotheses"][label])):
                if k != number:
                    yield one("hypothesis list", f"{name}: {k}", path, ["hyp", label, k])
        case int() if type(value) is int:
            yield one("coefficient", f"{name}: {value} + 1", path, value + 1)


def _of_point(path: Path, value: object, name: str) -> Iterator[Change]:
    if path[1] == "shown" and type(value) is int:
        yield one("coordinate", f"{name}: {value} + 1", path, value + 1)
    elif path[1] == "values" and len(path) == 3:
        yield one("coordinate", f"{name}: {value} and 1 more", path, ["+", value, 1])
        yield one("coordinate", f"{name} dropped", path, DROPPED)


def polynomial_edits(text: str) -> Iterator[str]:
    """Every number in a printed polynomial raised by one, every sign turned, every variable doubled."""
    for number in re.finditer(r"(?<![\w_])\d+|(?<=\^)\d+", text):
        yield text[: number.start()] + str(int(number[0]) + 1) + text[number.end() :]
    for sign in re.finditer(r" ([+-]) ", text):
        yield text[: sign.start(1)] + "+-"[sign[1] == "+"] + text[sign.end(1) :]
    yield text.removeprefix("-") if text.startswith("-") else "-" + text


def places(data: object, path: Path = ()) -> Iterator[tuple[Path, object]]:
    """Whatever a certificate is made of, with its place."""
    yield path, data
    if isinstance(data, (dict, list)):
        for key, child in data.items() if isinstance(data, dict) else enumerate(data):
            yield from places(child, (*path, key))


def status_of(original: Certificate, edited: Certificate, lemmas: Sequence[Certificate] = ()) -> Status:
    """What the checker makes of a changed certificate; one that it accepts is no fault if what it states is shown."""
    if not holds(edited, lemmas):
        return Status.REJECTED
    try:
        return Status.EQUIVALENT if is_so(original, edited) else Status.ACCEPTED
    except MALFORMED:
        return Status.ACCEPTED  # it states nothing that can be shown


def is_so(original: Certificate, edited: Certificate) -> bool:
    """Whether what is stated is so: it is what the original states, or it is shown without its own proof or point.

    A denominator whose nonzero condition was removed must be proved nonzero.
    """
    known, problem = problem_of(original), problem_of(edited)
    refuted = edited["verdict"] == "refuted"
    if edited["verdict"] != original["verdict"]:
        return follows(replace(problem, claim=node("=", 0, 1)), problem, refuted)
    conditions = [term for term in original.get("nonzero", ()) if term not in edited.get("nonzero", ())]
    claims = (Reader().formula(["!=", term, 0]) for term in conditions)
    return all(_is_proved(problem, claim) for claim in claims) and follows(known, problem, refuted)


def _is_proved(problem: Problem, claim: Formula) -> bool:
    open_ = replace(problem, claim=claim)
    return is_proved(open_, proof_of(open_))


def follows(known: Problem, problem: Problem, refuted: bool) -> bool:
    """Whether a problem is proved (or refuted), where another one is known to be.

    What is known is: the parts of its claim under no less than its hypotheses, or that the claim fails under some of
    them. The rest is put to the provers, whose proofs and points the checker has to accept.
    """
    given, before = ({f for _, formulas in p.hypotheses for f in formulas} for p in (problem, known))
    same_definitions = problem.definitions == known.definitions
    if refuted:
        if same_definitions and problem.claim == known.claim and given <= before:
            return True
        lost = fails_without(problem)
        return lost is not None and lost.loss is Loss.TRUTH and holds(lost.certificate)
    shown = conjuncts(known.claim) if same_definitions and given >= before else []
    return all(_is_proved(problem, part) for part in conjuncts(problem.claim) if part not in shown)


def groups(records: Sequence[Record]) -> list[str]:
    """All certificates in groups, each with those of the lemmas that they rest on."""
    every = list(dict.fromkeys(json.dumps(evidence) for record in records for evidence in record.all_certificates()))
    named: dict[str, list[str]] = defaultdict(list)
    for record in records:
        named[record.id] += map(json.dumps, record.certificates)
    size = len(every) // BATCH + 1
    return [f"[[{','.join(own)}],[{','.join(_lemmas(own, named))}]]" for own in (every[k::size] for k in range(size))]


def _lemmas(own: Sequence[str], named: Mapping[str, Sequence[str]]) -> list[str]:
    """The certificates of the lemmas of certificates, and of the lemmas of these."""

    def named_by(text: str) -> Iterator[str]:
        for name in lemmas_of([json.loads(text)]):
            yield from named.get(name) or map(json.dumps, lemma(name)[1])

    return reached((text for certificate in own for text in named_by(certificate)), named_by)


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """Some certificates: each as it is, and so many changes of all of them."""
    group, lemmas = json.loads(place)
    for original in group:
        kept = holds(original, _needed(original, lemmas))
        yield Trial("as it is", original["id"], Status.KEPT if kept else Status.FALSELY_REJECTED)
    yield from changed(group, lemmas, changes, count, rng)


def changed(
    group: Sequence[Certificate],
    lemmas: Sequence[Certificate],
    listed: Callable[[Certificate], Iterable[Change]],
    count: int,
    rng: Random,
) -> Iterator[Trial]:
    """So many changes of a group of certificates, of each about as many."""
    for k, original in enumerate(group):
        share = count * (k + 1) // len(group) - count * k // len(group)
        for kind, change in drawn(((change.kind, change) for change in listed(original)), share, rng):
            if (edited := change.of(original)) != original:
                status = status_of(original, edited, _needed(original, lemmas))
                yield Trial(kind, f"{original['id']} {change.words}", status)


def _needed(original: Certificate, lemmas: Sequence[Certificate]) -> Sequence[Certificate]:
    """Those of the lemmas that a certificate may need; to check none is quicker."""
    return lemmas if original.get("lemmas") else ()


CLASS = FaultClass(
    "certificates",
    "certificates with one thing changed, before the checker",
    ("coefficient", "relation", "index", "hypothesis list", "coordinate", "as it is"),
    share=4300,
    places=groups,
    trials=trials,
)
