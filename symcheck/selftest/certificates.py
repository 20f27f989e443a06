"""Certificates with one thing changed: a coefficient, a relation, a name, or the list of hypotheses."""

from __future__ import annotations

import copy
import json
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from random import Random
from typing import Any

from symcheck.evidence.checked import certificates
from symcheck.evidence.judge import lemma
from symcheck.evidence.record import Record
from symcheck.proof import digest, fails_without, proof_of
from symcheck.proof.theorems import conjuncts
from symcheck.selftest.evidence import holds, is_shown, problem_of
from symcheck.selftest.trial import Fate, FaultClass, Trial, mixed
from symcheck.statement import Certificate, Loss, Problem

STATED = ("claim", "definitions", "hypotheses")
TURNED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "=": "!=", "!=": "="}
TOGETHER = 40  # certificates that one task goes through
Path = tuple[Any, ...]
Change = tuple[str, str, Path, Any]  # kind, words, where, the new value
DROPPED = object()


def changed(original: Certificate, path: Path, value: Any) -> Certificate:
    """A copy with another value at one place (or without it), and a digest that fits."""
    edited = copy.deepcopy(original)
    node: Any = edited
    for key in path[:-1]:
        node = node[key]
    if value is DROPPED:
        del node[path[-1]]
    else:
        node[path[-1]] = value
    edited["digest"] = digest(edited)
    return edited


def changes(original: Certificate) -> Iterator[Change]:
    """Every number, letter, sign, cofactor, relation, fact, hypothesis and coordinate, each changed alone."""
    for path, value in _places(original):
        section, name = (path or ("",))[0], "/".join(map(str, path))
        if section in STATED:
            yield from _of_statement(path, value, name)
        elif section == "proof":
            yield from _of_proof(original, path, value, name)
        elif section == "point" and len(path) > 1 and path[1] in ("values", "sides"):
            yield from _of_point(path, value, name)
        if section == "hypotheses" and len(path) == 3:
            yield "hypothesis list", f"{name} dropped", path, DROPPED


def _of_statement(path: Path, value: Any, name: str) -> Iterator[Change]:
    if type(value) is int:
        yield "coefficient", f"{name}: {value} + 1", path, value + 1
    elif isinstance(value, str) and path[-1] == 0 and value in TURNED:
        yield "relation", f"{name}: {value} -> {TURNED[value]}", path, TURNED[value]
    elif isinstance(value, str) and path[-1] != 0 and re.fullmatch(r"\w+_\d+", value):
        other = value[:-1] + str(int(value[-1]) % 3 + 1)
        yield "index", f"{name}: {value} -> {other}", path, other


def _of_proof(original: Certificate, path: Path, value: Any, name: str) -> Iterator[Change]:
    if type(value) is int and path[-1] != "or":
        yield "coefficient", f"{name}: {value} + 1", path, value + 1
    elif isinstance(value, str) and "cofactors" in path and path[-1] != 0 and path[-2] != 0:
        yield from (("coefficient", f"{name}: {text}", path, text) for text in polynomial_edits(value))
    elif isinstance(value, list) and len(path) >= 2 and path[-2] == "cofactors":
        yield "hypothesis list", f"{name} dropped", path, DROPPED
    elif isinstance(value, list) and value[:1] == ["hyp"]:
        for k in range(len(original["hypotheses"][value[1]])):
            if k != value[2]:
                yield "hypothesis list", f"{name}: {k}", path, ["hyp", value[1], k]


def _of_point(path: Path, value: Any, name: str) -> Iterator[Change]:
    if isinstance(value, str) and len(path) == 3 and value not in ("true", "false"):
        yield "coordinate", f"{name}: {value} and 1 more", path, ["+", _number(value), 1]
    if len(path) == 3 and path[1] == "values":
        yield "coordinate", f"{name} dropped", path, DROPPED


def _number(text: str) -> Any:
    """A printed fraction as a term."""
    top, _, bottom = text.partition("/")
    return ["/", int(top), int(bottom or 1)]


def polynomial_edits(text: str) -> Iterator[str]:
    """Every number in a printed polynomial raised by one, every sign turned, every variable doubled."""
    for found in re.finditer(r"(?<![\w_])\d+|(?<=\^)\d+", text):
        yield text[: found.start()] + str(int(found[0]) + 1) + text[found.end() :]
    for found in re.finditer(r" ([+-]) ", text):
        yield text[: found.start(1)] + "+-"[found[1] == "+"] + text[found.end(1) :]
    yield text.removeprefix("-") if text.startswith("-") else "-" + text


def _places(node: Any, path: Path = ()) -> Iterator[tuple[Path, Any]]:
    yield path, node
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in children:
        yield from _places(child, (*path, key))


def is_so(original: Certificate, edited: Certificate) -> bool:
    """Whether what an edited certificate states is so, by a decision that owes nothing to its own proof or point."""
    return follows(problem_of(original), problem_of(edited), edited["verdict"] == original["verdict"] == "refuted")


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
    every = list(dict.fromkeys(json.dumps(each) for record in records for each in certificates(record)))
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
        for name in json.loads(todo.pop()).get("lemmas", ()):
            texts = named.get(name) or [json.dumps(each) for each in lemma(*name.split(":", 1))[1]]
            new = [text for text in texts if text not in found]
            found |= dict.fromkeys(new)
            todo += new
    return [*found]


def beside(original: Certificate, lemmas: Sequence[Certificate]) -> list[Certificate]:
    """Those of the lemmas that a certificate may need; to check none is quicker."""
    return [*lemmas] if original.get("lemmas") else []


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """Some certificates: each as it is, and so many changes of all of them."""
    group, lemmas = json.loads(place)
    for original in group:
        kept = holds(original, beside(original, lemmas))
        yield Trial("as it is", original["id"], Fate.KEPT if kept else Fate.FALSELY_REJECTED)
    for k, original in enumerate(group):
        by_kind: dict[str, list[Change]] = defaultdict(list)
        for change in changes(original):
            by_kind[change[0]].append(change)
        share = count * (k + 1) // len(group) - count * k // len(group)
        for kind, words, path, value in _first(mixed(by_kind, rng), share):
            edited = changed(original, path, value)
            yield Trial(kind, f"{original['id']} {words}", fate(original, edited, beside(original, lemmas)))


def fate(original: Certificate, edited: Certificate, lemmas: Sequence[Certificate] = ()) -> Fate:
    """What the checker makes of a changed certificate; one that holds is right if what it states is so."""
    if not holds(edited, lemmas):
        return Fate.REJECTED
    return Fate.EQUIVALENT if is_so(original, edited) else Fate.ACCEPTED


def _first(drawn: Iterator[Change], count: int) -> Iterator[Change]:
    return (change for change, _ in zip(drawn, range(count), strict=False))


CLASS = FaultClass(
    "certificates",
    "certificates with one thing changed, before the checker",
    ("coefficient", "relation", "index", "hypothesis list", "coordinate", "as it is"),
    share=4300,
    places=groups,
    trials=trials,
)
