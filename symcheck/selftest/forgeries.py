"""Forged proofs: accepted certificates, as the checker reads them, made to say or to show something else."""

from __future__ import annotations

import copy
import json
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from random import Random
from typing import Any, NamedTuple

from symcheck.checker import check_all
from symcheck.evidence import translation
from symcheck.proof import proof_of
from symcheck.proof.theorems import conjuncts
from symcheck.selftest.certificates import DROPPED, TURNED, beside, follows, groups
from symcheck.selftest.evidence import hints_of, is_shown
from symcheck.selftest.trial import Fate, FaultClass, Trial, mixed
from symcheck.statement import Problem

CLAIM, ASSUMED, DEFINED = "another claim", "other hypotheses", "other definitions"
SHIFTED, REMOVED, MOVED = "references shifted", "conditions removed", "witnesses removed or moved"
RELABELLED, PROOF = "verdict relabelled", "another proof"
CONDITIONS = ("nonzero", "positive", "premises", "clear", "times", "cases", "parts")
BARE: tuple[dict[str, Any], ...] = (
    {"rule": "identity"},
    {"rule": "absurd"},
    {"rule": "compute"},
    {"rule": "absurd", "cofactors": [["here", 0], "1"]},
    {"rule": "implies", "then": {"rule": "absurd", "cofactors": [[["here", 0], "1"]]}},
)
NOTHING: list[Any] = ["=", 0, 1]
Path = tuple[Any, ...]


class Forgery(NamedTuple):
    """A change: its kind, what it is in words, and new values by place."""

    kind: str
    words: str
    changes: tuple[tuple[Path, Any], ...]

    def of(self, original: Mapping[str, Any]) -> dict[str, Any]:
        """The forged certificate."""
        forged: dict[str, Any] = copy.deepcopy(dict(original))
        for path, value in self.changes:
            node: Any = forged
            for key in path[:-1]:
                node = node[key]
            if value is DROPPED:
                node.pop(path[-1], None) if isinstance(node, dict) else node.pop(path[-1])
            else:
                node[path[-1]] = copy.deepcopy(value)
        return forged


def forgeries(original: Mapping[str, Any], donor: Mapping[str, Any]) -> Iterator[Forgery]:
    """Everything that is tried with a certificate; another one gives parts of itself."""
    yield from _whole(original, donor)
    for path, node in _places(original):
        words = "/".join(map(str, path))
        match path:
            case ("claim", *_):
                yield from _stated(CLAIM, path, node, words)
            case ("hypotheses", _) | ("hypotheses", _, int()):
                yield Forgery(ASSUMED, f"{words} dropped", ((path, DROPPED),))
                if len(path) == 3 and (other := _formula_of(donor)) is not None:
                    yield Forgery(ASSUMED, f"{words} is another", ((path, other),))
            case ("hypotheses", _, *_):
                yield from _stated(ASSUMED, path, node, words)
            case ("definitions", int()):
                yield Forgery(DEFINED, f"{words} dropped", ((path, DROPPED),))
            case ("definitions", int(), 1, *_):
                yield from _stated(DEFINED, path, node, words)
            case ("nonzero", int()) | ("lemmas", int()):
                yield Forgery(REMOVED, f"{words} dropped", ((path, DROPPED),))
            case ("proof", *_):
                yield from _of_proof(path, node, words)
            case (("witnesses" | "point"), *_):
                yield from _of_point(path, node, words)


def _whole(original: Mapping[str, Any], donor: Mapping[str, Any]) -> Iterator[Forgery]:
    yield Forgery(CLAIM, f"that of {donor['id']}", ((("claim",), donor["claim"]),))
    yield Forgery(CLAIM, "0 = 1", ((("claim",), NOTHING),))
    yield Forgery(ASSUMED, f"those of {donor['id']}", ((("hypotheses",), donor["hypotheses"]),))
    yield Forgery(ASSUMED, "none", ((("hypotheses",), {}),))
    yield Forgery(DEFINED, f"those of {donor['id']}", ((("definitions",), donor["definitions"]),))
    other = "refuted" if original["verdict"] == "proved" else "proved"
    label = (("verdict",), other)
    yield Forgery(RELABELLED, other, (label,))
    without: tuple[tuple[Path, Any], ...] = tuple(((key,), DROPPED) for key in ("proof", "point", "witnesses"))
    if other == "proved":
        shows = [donor["proof"]] if "proof" in donor else []
        values = {"values": original["point"]["values"]}
        for proof in (*BARE, *shows, original["point"].get("proof", BARE[0])):
            for points in ([], [values]):
                new = ((("proof",), proof), (("witnesses",), points))
                yield Forgery(RELABELLED, f"proved by {proof['rule']}", (*without, label, *new))
        return
    for point in (*original.get("witnesses", ()), *([donor["point"]] if "point" in donor else ())):
        yield Forgery(RELABELLED, "refuted at a point", (*without, label, (("point",), point)))
    for proof in (*BARE, *([donor["proof"]] if "proof" in donor else ())):
        yield Forgery(PROOF, f"by {proof['rule']}", ((("proof",), proof),))
    if "witnesses" in original:
        yield Forgery(MOVED, "all removed", ((("witnesses",), DROPPED),))
        yield Forgery(MOVED, "of another", ((("witnesses",), donor.get("witnesses", [{"values": {}}])),))


def _stated(kind: str, path: Path, node: Any, words: str) -> Iterator[Forgery]:
    """Other numbers, signs, letters, and members of what is stated."""
    if type(node) is int and path[-1] != 0:
        yield Forgery(kind, f"{words}: {node} -> {node + 1}", ((path, node + 1),))
    elif isinstance(node, str) and path[-1] == 0 and node in TURNED:
        yield Forgery(kind, f"{words}: {node} -> {TURNED[node]}", ((path, TURNED[node]),))
    elif isinstance(node, str) and path[-1] != 0 and "_" in node:
        other = f"{node[:-1]}{int(node[-1]) % 3 + 1}" if node[-1].isdigit() else f"{node}_1"
        yield Forgery(kind, f"{words}: {node} -> {other}", ((path, other),))
    elif isinstance(node, list) and len(node) > 3 and node[0] in ("+", "*", "and", "or"):
        yield Forgery(kind, f"{words}: the last of {node[0]} dropped", ((path, node[:-1]),))


def _of_proof(path: Path, node: Any, words: str) -> Iterator[Forgery]:
    match node:
        case ["hyp", _, int(k)] | [("here" | "point"), int(k)]:
            for new in (k - 1, k + 1):
                yield Forgery(SHIFTED, f"{words}: {k} -> {new}", ((path, [*node[:-1], new]),))
        case {"rule": _, "then": then} if len(path) > 0:
            yield Forgery(PROOF, f"{words}: a step left out", ((path, then),))
        case {"rule": _}:
            yield Forgery(PROOF, f"{words}: absurd", ((path, {"rule": "absurd", "cofactors": []}),))
    if len(path) > 2 and path[-2] in CONDITIONS and type(path[-1]) is int:
        yield Forgery(REMOVED, f"{words} dropped", ((path, DROPPED),))


def _of_point(path: Path, node: Any, words: str) -> Iterator[Forgery]:
    if path[0] == "witnesses" and len(path) == 2:
        yield Forgery(MOVED, f"{words} removed", ((path, DROPPED),))
    if len(path) >= 2 and path[-2] == "values":
        yield Forgery(MOVED, f"{words} dropped", ((path, DROPPED),))
        yield Forgery(MOVED, f"{words} and 1 more", ((path, ["+", node, 1]),))
        yield Forgery(MOVED, f"{words} is infinite", ((path, ["infinity"]),))


def _places(node: Any, path: Path = ()) -> Iterator[tuple[Path, Any]]:
    """Every part with its path, but for the place of a derivative, which the search takes for the letter itself."""
    yield path, node
    node = node[:-1] if isinstance(node, list) and node[:1] == ["diff"] else node
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in children:
        yield from _places(child, (*path, key))


def _formula_of(certificate: Mapping[str, Any]) -> Any:
    return next((formulas[0] for formulas in certificate["hypotheses"].values() if formulas), certificate["claim"])


def fate(original: Mapping[str, Any], forged: Mapping[str, Any], lemmas: Sequence[Mapping[str, Any]]) -> Fate:
    """What the checker makes of a forged certificate; one that it accepts is no fault if what it states is shown."""
    if next(iter(check_all([dict(forged), *map(dict, lemmas)]))) is not None:
        return Fate.REJECTED
    try:
        return Fate.EQUIVALENT if is_so(original, forged) else Fate.ACCEPTED
    except (LookupError, TypeError, ValueError, AttributeError):
        return Fate.ACCEPTED  # it states nothing that can be shown


def is_so(original: Mapping[str, Any], forged: Mapping[str, Any]) -> bool:
    """Whether what is stated is so: it is what the original states, or it is shown without the forged proof.

    A denominator that is no longer said not to vanish is to be shown not to.
    """
    known, problem = problem_of(original), problem_of(forged)
    if forged["verdict"] != original["verdict"]:
        return follows(replace(problem, claim=("=", 0, 1)), problem, forged["verdict"] == "refuted")
    conditions = [term for term in original.get("nonzero", ()) if term not in forged.get("nonzero", ())]
    open_ = [replace(problem, claim=("!=", searched(term), 0)) for term in conditions]
    if forged["verdict"] == "proved" and not all(is_shown(each, proof_of(each)) for each in open_):
        return False
    return follows(known, problem, forged["verdict"] == "refuted")


def problem_of(certificate: Mapping[str, Any]) -> Problem:
    """What a certificate states, as a problem for the provers, with the definitions that are reached."""
    claim = searched(certificate["claim"])
    hypotheses = tuple(
        (name, tuple(part for f in formulas for part in conjuncts(searched(f))))
        for name, formulas in certificate["hypotheses"].items()
    )
    terms = {name: searched(term) for name, term in certificate["definitions"]}
    reached, todo = set[str](), [claim, hypotheses]
    while todo:
        for name in _names(todo.pop()) - reached:
            if name in terms:
                reached.add(name)
                todo.append(terms[name])
    definitions = tuple((name, term) for name, term in terms.items() if name in reached)
    hints = tuple(dict.fromkeys(hints_of(certificate.get("proof", {}), searched)))
    return Problem(certificate["id"], claim, definitions, hypotheses, hints)


def _names(value: Any) -> set[str]:
    if isinstance(value, str):
        return {value}
    return set().union(*map(_names, value)) if isinstance(value, tuple) else set()


def searched(node: Any) -> Any:
    """A term or formula of the checker in the words of the search."""
    match node:
        case [("pi" | "infinity") as name]:
            return name
        case ["-infinity"]:
            return ("-", "infinity")
        case ["diff", body, x, order, place] if x == place:
            return ("diff", searched(body), x, order)
        case [*parts]:
            return tuple(map(searched, parts))
    return node


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many forgeries of a group of certificates."""
    group, lemmas = json.loads(place)
    read = [(translation.certificate(each), beside(each, lemmas)) for each in group]
    for k, (original, own) in enumerate(read):
        donor = rng.choice(read)[0]
        by_kind: dict[str, list[Forgery]] = defaultdict(list)
        for forgery in forgeries(original, donor):
            by_kind[forgery.kind].append(forgery)
        share = count * (k + 1) // len(read) - count * k // len(read)
        told = [translation.certificate(each) for each in own] if share else []
        for forgery in _first(mixed(by_kind, rng), share):
            forged = forgery.of(original)
            if forged != original:
                yield Trial(forgery.kind, f"{original['id']} {forgery.words}", fate(original, forged, told))


def _first(drawn: Iterable[Forgery], count: int) -> Iterator[Forgery]:
    return (each for each, _ in zip(drawn, range(count), strict=False))


CLASS = FaultClass(
    "forged proofs",
    "certificates made to say or show something else, before the checker",
    (CLAIM, ASSUMED, DEFINED, SHIFTED, REMOVED, MOVED, RELABELLED, PROOF),
    share=2500,
    places=groups,
    trials=trials,
)
