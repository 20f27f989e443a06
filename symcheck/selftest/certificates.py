"""Certificates with one thing changed: a coefficient, a relation, a name, or the list of hypotheses."""

from __future__ import annotations

import copy
import json
import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from random import Random
from typing import Any, NamedTuple

from symcheck.audit.judge import lemma
from symcheck.core.claims import Problem
from symcheck.core.formulas import conjuncts
from symcheck.core.terms import Reader, node
from symcheck.core.verdicts import Certificate, Loss
from symcheck.ledger.record import Record
from symcheck.proof import fails_without, proof_of
from symcheck.selftest.evidence import MALFORMED, holds, is_shown, problem_of
from symcheck.selftest.trial import Fate, FaultClass, Trial, mixed

STATED = ("claim", "definitions", "hypotheses")
TURNED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "=": "!=", "!=": "="}
TOGETHER = 40  # certificates that one task goes through
Path = tuple[Any, ...]
DROPPED = object()


class Change(NamedTuple):
    """A change of a certificate: its kind, what it is in words, and new values by place."""

    kind: str
    words: str
    values: tuple[tuple[Path, Any], ...]

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


def one(kind: str, words: str, path: Path, value: Any) -> Change:
    """A change at one place."""
    return Change(kind, words, ((path, value),))


def changes(original: Certificate) -> Iterator[Change]:
    """Every number, letter, sign, cofactor, relation, fact, hypothesis and coordinate, each changed alone."""
    for path, value in places(original):
        section, name = (path or ("",))[0], "/".join(map(str, path))
        if section in STATED:
            yield from _of_statement(path, value, name)
        elif section == "proof":
            yield from _of_proof(original, path, value, name)
        elif section == "point" and len(path) > 2:
            yield from _of_point(path, value, name)
        if section == "hypotheses" and len(path) == 3:
            yield one("hypothesis list", f"{name} dropped", path, DROPPED)


def _of_statement(path: Path, value: Any, name: str) -> Iterator[Change]:
    if type(value) is int:
        yield one("coefficient", f"{name}: {value} + 1", path, value + 1)
    elif isinstance(value, str) and path[-1] == 0 and value in TURNED:
        yield one("relation", f"{name}: {value} -> {TURNED[value]}", path, TURNED[value])
    elif isinstance(value, str) and path[-1] != 0 and re.fullmatch(r"\w+_\d+", value):
        other = value[:-1] + str(int(value[-1]) % 3 + 1)
        yield one("index", f"{name}: {value} -> {other}", path, other)


def _of_proof(original: Certificate, path: Path, value: Any, name: str) -> Iterator[Change]:
    if type(value) is int:
        yield one("coefficient", f"{name}: {value} + 1", path, value + 1)
    elif isinstance(value, str) and path[-3:-2] == ("cofactors",) and path[-1] != 0:
        yield from (one("coefficient", f"{name}: {text}", path, text) for text in polynomial_edits(value))
    elif isinstance(value, list) and len(path) >= 2 and path[-2] == "cofactors":
        yield one("hypothesis list", f"{name} dropped", path, DROPPED)
    elif isinstance(value, list) and value[:1] == ["hyp"]:
        for k in range(len(original["hypotheses"][value[1]])):
            if k != value[2]:
                yield one("hypothesis list", f"{name}: {k}", path, ["hyp", value[1], k])


def _of_point(path: Path, value: Any, name: str) -> Iterator[Change]:
    if path[1] == "shown" and type(value) is int:
        yield one("coordinate", f"{name}: {value} + 1", path, value + 1)
    elif path[1] == "values" and len(path) == 3:
        yield one("coordinate", f"{name}: {value} and 1 more", path, ["+", value, 1])
        yield one("coordinate", f"{name} dropped", path, DROPPED)


def polynomial_edits(text: str) -> Iterator[str]:
    """Every number in a printed polynomial raised by one, every sign turned, every variable doubled."""
    for found in re.finditer(r"(?<![\w_])\d+|(?<=\^)\d+", text):
        yield text[: found.start()] + str(int(found[0]) + 1) + text[found.end() :]
    for found in re.finditer(r" ([+-]) ", text):
        yield text[: found.start(1)] + "+-"[found[1] == "+"] + text[found.end(1) :]
    yield text.removeprefix("-") if text.startswith("-") else "-" + text


def places(data: Any, path: Path = ()) -> Iterator[tuple[Path, Any]]:
    """Whatever a certificate is made of, with its place."""
    yield path, data
    children = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, child in children:
        yield from places(child, (*path, key))


def fate(original: Certificate, edited: Certificate, lemmas: Sequence[Certificate] = ()) -> Fate:
    """What the checker makes of a changed certificate; one that it accepts is no fault if what it states is shown."""
    if not holds(edited, lemmas):
        return Fate.REJECTED
    try:
        return Fate.EQUIVALENT if is_so(original, edited) else Fate.ACCEPTED
    except MALFORMED:
        return Fate.ACCEPTED  # it states nothing that can be shown


def is_so(original: Certificate, edited: Certificate) -> bool:
    """Whether what is stated is so: it is what the original states, or it is shown without its own proof or point.

    A denominator that is no longer said not to vanish is to be shown not to.
    """
    known, problem = problem_of(original), problem_of(edited)
    refuted = edited["verdict"] == "refuted"
    if edited["verdict"] != original["verdict"]:
        return follows(replace(problem, claim=node("=", 0, 1)), problem, refuted)
    conditions = [term for term in original.get("nonzero", ()) if term not in edited.get("nonzero", ())]
    open_ = [replace(problem, claim=Reader().formula(["!=", term, 0])) for term in conditions]
    return all(is_shown(each, proof_of(each)) for each in open_) and follows(known, problem, refuted)


def follows(known: Problem, problem: Problem, refuted: bool) -> bool:
    """Whether a problem is proved (or refuted), where another one is known to be.

    What is known is: the parts of its claim under no less than its hypotheses, or that the claim fails under some of
    them. The rest is put to the provers, whose proofs and points the checker has to accept.
    """
    given, before = ({f for _, formulas in each.hypotheses for f in formulas} for each in (problem, known))
    alike = problem.definitions == known.definitions
    if refuted:
        weaker = alike and problem.claim == known.claim and given <= before
        found = None if weaker else fails_without(problem)
        return weaker or (found is not None and found.loss is Loss.TRUTH and holds(found.certificate))
    shown = conjuncts(known.claim) if alike and given >= before else []
    open_ = [replace(problem, claim=part) for part in conjuncts(problem.claim) if part not in shown]
    return all(is_shown(each, proof_of(each)) for each in open_)


def groups(records: Sequence[Record]) -> list[str]:
    """All certificates in groups, each with those of the lemmas that they rest on."""
    every = list(dict.fromkeys(json.dumps(each) for record in records for each in record.all_certificates()))
    named: dict[str, list[str]] = defaultdict(list)
    for record in records:
        named[record.id] += [json.dumps(each) for each in record.certificates]
    size = len(every) // TOGETHER + 1
    return [f"[[{','.join(own)}],[{','.join(_lemmas(own, named))}]]" for own in (every[k::size] for k in range(size))]


def _lemmas(own: Sequence[str], named: Mapping[str, Sequence[str]]) -> list[str]:
    """The certificates of the lemmas of certificates, and of the lemmas of these."""
    found: dict[str, None] = {}
    todo = [*own]
    while todo:
        for name, _ in json.loads(todo.pop()).get("lemmas", ()):
            texts = named.get(name) or [json.dumps(each) for each in lemma(*name.split(":", 1))[1]]
            new = [text for text in texts if text not in found]
            found |= dict.fromkeys(new)
            todo += new
    return [*found]


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """Some certificates: each as it is, and so many changes of all of them."""
    group, lemmas = json.loads(place)
    for original in group:
        kept = holds(original, beside(original, lemmas))
        yield Trial("as it is", original["id"], Fate.KEPT if kept else Fate.FALSELY_REJECTED)
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
        by_kind: dict[str, list[Change]] = defaultdict(list)
        for change in listed(original):
            by_kind[change.kind].append(change)
        share = count * (k + 1) // len(group) - count * k // len(group)
        for change in islice(mixed(by_kind, rng), share):
            if (edited := change.of(original)) != original:
                known = beside(original, lemmas)
                yield Trial(change.kind, f"{original['id']} {change.words}", fate(original, edited, known))


def beside(original: Certificate, lemmas: Sequence[Certificate]) -> list[Certificate]:
    """Those of the lemmas that a certificate may need; to check none is quicker."""
    return [*lemmas] if original.get("lemmas") else []


CLASS = FaultClass(
    "certificates",
    "certificates with one thing changed, before the checker",
    ("coefficient", "relation", "index", "hypothesis list", "coordinate", "as it is"),
    share=4300,
    places=groups,
    trials=trials,
)
