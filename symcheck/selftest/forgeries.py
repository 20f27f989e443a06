"""Forged proofs: accepted certificates, as the checker reads them, made to say or to show something else."""

from __future__ import annotations

import json
from collections.abc import Iterator
from random import Random

from symcheck.core.certificates import Certificate
from symcheck.core.terms import JSON
from symcheck.selftest.certificates import DROPPED, TURNED, Change, Path, changed, groups, one, places
from symcheck.selftest.trial import FaultClass, Trial

CLAIM, ASSUMED, DEFINED = "another claim", "other hypotheses", "other definitions"
SHIFTED, REMOVED, MOVED = "references shifted", "conditions removed", "witnesses removed or moved"
RELABELLED, PROOF = "verdict relabelled", "another proof"
CONDITIONS = ("nonzero", "positive", "premises", "times", "cases", "parts")
BARE: tuple[dict[str, JSON], ...] = (
    {"rule": "identity"},
    {"rule": "absurd"},
    {"rule": "compute"},
    {"rule": "absurd", "cofactors": [["here", 0], "1"]},
    {"rule": "implies", "then": {"rule": "absurd", "cofactors": [[["here", 0], "1"]]}},
)
NOTHING = ["=", 0, 1]


def forgeries(original: Certificate, donor: Certificate) -> Iterator[Change]:
    """Everything that is tried with a certificate; another one gives parts of itself."""
    yield from _whole(original, donor)
    for path, node in places(original):
        words = "/".join(map(str, path))
        match path:
            case ("claim", *_):
                yield from _stated(CLAIM, path, node, words)
            case ("hypotheses", _) | ("hypotheses", _, int()):
                yield one(ASSUMED, f"{words} dropped", path, DROPPED)
                if len(path) == 3 and (other := _formula_of(donor)) is not None:
                    yield one(ASSUMED, f"{words} is another", path, other)
            case ("hypotheses", _, *_):
                yield from _stated(ASSUMED, path, node, words)
            case ("definitions", int()):
                yield one(DEFINED, f"{words} dropped", path, DROPPED)
            case ("definitions", int(), 1, *_):
                yield from _stated(DEFINED, path, node, words)
            case ("nonzero", int()) | ("lemmas", int()):
                yield one(REMOVED, f"{words} dropped", path, DROPPED)
            case ("proof", *_):
                yield from _of_proof(path, node, words)
            case (("witnesses" | "point"), *_):
                yield from _of_point(path, node, words)


def _whole(original: Certificate, donor: Certificate) -> Iterator[Change]:
    yield one(CLAIM, f"that of {donor['id']}", ("claim",), donor["claim"])
    yield one(CLAIM, "0 = 1", ("claim",), NOTHING)
    yield one(ASSUMED, f"those of {donor['id']}", ("hypotheses",), donor["hypotheses"])
    yield one(ASSUMED, "none", ("hypotheses",), {})
    yield one(DEFINED, f"those of {donor['id']}", ("definitions",), donor["definitions"])
    other = "refuted" if original["verdict"] == "proved" else "proved"
    label = (("verdict",), other)
    yield Change(RELABELLED, other, (label,))
    without: tuple[tuple[Path, object], ...] = tuple(((key,), DROPPED) for key in ("proof", "point", "witnesses"))
    if other == "proved":
        shows = [donor["proof"]] if "proof" in donor else []
        values = {"values": original["point"]["values"]}
        for proof in (*BARE, *shows, original["point"].get("proof", BARE[0])):
            for points in ([], [values]):
                new: tuple[tuple[Path, object], ...] = ((("proof",), proof), (("witnesses",), points))
                yield Change(RELABELLED, f"proved by {proof['rule']}", (*without, label, *new))
        return
    for point in (*original.get("witnesses", ()), *([donor["point"]] if "point" in donor else ())):
        yield Change(RELABELLED, "refuted at a point", (*without, label, (("point",), point)))
    for proof in (*BARE, *([donor["proof"]] if "proof" in donor else ())):
        yield one(PROOF, f"by {proof['rule']}", ("proof",), proof)
    if "witnesses" in original:
        yield one(MOVED, "all removed", ("witnesses",), DROPPED)
        yield one(MOVED, "of another", ("witnesses",), donor.get("witnesses", [{"values": {}}]))


def _stated(kind: str, path: Path, node: object, words: str) -> Iterator[Change]:
    """Other numbers, signs, letters, and members of what is stated."""
    if type(node) is int and path[-1] != 0:
        yield one(kind, f"{words}: {node} -> {node + 1}", path, node + 1)
    elif isinstance(node, str) and path[-1] == 0 and node in TURNED:
        yield one(kind, f"{words}: {node} -> {TURNED[node]}", path, TURNED[node])
    elif isinstance(node, str) and path[-1] != 0 and "_" in node:
        other = f"{node[:-1]}{int(node[-1]) % 3 + 1}" if node[-1].isdigit() else f"{node}_1"
        yield one(kind, f"{words}: {node} -> {other}", path, other)
    elif isinstance(node, list) and len(node) > 3 and node[0] in ("+", "*", "and", "or"):
        yield one(kind, f"{words}: the last of {node[0]} dropped", path, node[:-1])


def _of_proof(path: Path, node: object, words: str) -> Iterator[Change]:
    match node:
        case ["hyp", _, int(k)] | [("here" | "point"), int(k)]:
            for new in (k - 1, k + 1):
                yield one(SHIFTED, f"{words}: {k} -> {new}", path, [*node[:-1], new])
        case {"rule": _, "then": then} if len(path) > 0:
            yield one(PROOF, f"{words}: a step left out", path, then)
        case {"rule": _}:
            yield one(PROOF, f"{words}: absurd", path, {"rule": "absurd", "cofactors": []})
    if len(path) > 2 and path[-2] in CONDITIONS and type(path[-1]) is int:
        yield one(REMOVED, f"{words} dropped", path, DROPPED)


def _of_point(path: Path, node: object, words: str) -> Iterator[Change]:
    if path[0] == "witnesses" and len(path) == 2:
        yield one(MOVED, f"{words} removed", path, DROPPED)
    if len(path) >= 2 and path[-2] == "values":
        yield one(MOVED, f"{words} dropped", path, DROPPED)
        yield one(MOVED, f"{words} and 1 more", path, ["+", node, 1])
        yield one(MOVED, f"{words} is infinite", path, ["infinity"])


def _formula_of(certificate: Certificate) -> object:
    formulas = [formula for stated in certificate["hypotheses"].values() for formula in stated]
    return formulas[0] if formulas else certificate["claim"]


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many forgeries of a group of certificates."""
    group, lemmas = json.loads(place)
    yield from changed(group, lemmas, lambda original: forgeries(original, rng.choice(group)), count, rng)


CLASS = FaultClass(
    "forged proofs",
    "certificates made to say or show something else, before the checker",
    (CLAIM, ASSUMED, DEFINED, SHIFTED, REMOVED, MOVED, RELABELLED, PROOF),
    share=2500,
    places=groups,
    trials=trials,
)
