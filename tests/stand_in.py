"""A toy paper and a decider for it, so that the shell is tested without any algebra.

The module has the functions of `symcheck.audit.decide`. What a declaration does is told by its number.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from symcheck.core.certificates import Certificate
from symcheck.core.claims import Claim, Declaration, Definition, Paper, Plan, Section, Source, Statement
from symcheck.core.problems import Method, Outcome
from symcheck.core.verdicts import Origin, Reading, Role, Verdict
from symcheck.ledger import Correction, Edit, HypothesisRow, Need, Record, Repair

PROOF = {
    "rule": "each",
    "parts": [
        {"rule": "identity", "cofactors": [[["hyp", "orthogonal", 0], "2*a_11 - 1"]]},
        {
            "rule": "cases_or",
            "or": ["here", 0],
            "cases": [{"rule": "absurd", "times": [["here", 1]], "cofactors": []}],
        },
    ],
}
CERTIFICATE = {
    "id": "toy:1.1",
    "claim": ["=", ["+", ["^", "a_11", 2], ["-", "b"]], ["/", 1, ["+", "c", 1]]],
    "definitions": [],
    "hypotheses": {"orthogonal": [["=", ["^", "a_11", 2], 1]]},
    "verdict": "proved",
    "proof": PROOF,
}
POINT = {"values": {"x": ["/", 2, 7], "y": ["sqrt", 3]}, "shown": [["=", "x", 1], ["=", "y", -1]]}
POINT_WITHOUT = {**CERTIFICATE, "hypotheses": {}, "verdict": "refuted", "point": POINT}
REFUTED = {**CERTIFICATE, "id": "toy:1.3", "verdict": "refuted", "point": POINT}
CORRECTED = {**CERTIFICATE, "id": "toy:1.3"}
SLEEP = 3600
SECTION = Section("1", "The only section", ModuleType("section"))


@dataclass(frozen=True)
class Obligation:
    id: str
    paper: Paper
    section: Section
    item: Declaration


METHOD = Method("none", lambda problem: Outcome(Verdict.UNDECIDED))


def _item(number: str, role: Role = Role.CLAIM) -> Declaration:
    source = Source(10)
    if role is Role.DEFINITION:
        return Definition(number=number, source=source)
    return Claim(number=number, source=source, statement=Statement(), plan=Plan(METHOD))


NUMBERS = {
    "1.1": Role.CLAIM,
    "1.2": Role.CLAIM,
    "1.3": Role.CLAIM,
    "1.4": Role.CLAIM,
    "1.5": Role.DEFINITION,
    "1.12": Role.CLAIM,
}


def papers() -> dict[str, Paper]:
    empty: Any = None
    return {key: Paper(key, f"The {key} paper", f"{key}.txt", empty, ()) for key in ("toy", "other")}


def expand(paper: Paper) -> tuple[Obligation, ...]:
    numbers = dict(NUMBERS) if paper.key == "toy" else {"1": Role.CLAIM}
    if paper.key == "toy":
        numbers |= dict.fromkeys(filter(None, os.environ.get("STAND_IN_MORE", "").split()), Role.CLAIM)
    return tuple(Obligation(f"{paper.key}:{n}", paper, SECTION, _item(n, role)) for n, role in numbers.items())


def fingerprint(obligation: Obligation) -> str:
    return obligation.id + os.environ.get("STAND_IN_SOURCES", "")


def placed(obligation: Obligation, records: Sequence[Record]) -> tuple[Record, ...]:
    return tuple(records)


def decide(id: str) -> tuple[Record, ...]:
    if log := os.environ.get("STAND_IN_LOG"):
        with open(log, "a", encoding="utf-8") as file:
            file.write(id + "\n")
    paper, _, number = id.partition(":")
    if number == "hang":
        time.sleep(SLEEP)
    if number == "die":
        os._exit(7)
    if number == "raise":
        raise ValueError("the letter\nq is unknown")
    return _records(paper, number)


def weigh(declared: tuple[str, Sequence[Record]]) -> tuple[Record, ...]:
    raise AssertionError("nothing here is left to weigh")


def _records(paper: str, number: str) -> tuple[Record, ...]:
    common: dict[str, Any] = {"paper": paper, "section": "1", "line": 10, "role": Role.CLAIM, "seconds": 0.25}
    id = f"{paper}:{number}"
    match number:
        case "1.1":
            lost = Need(needed=True, lost="the relation fails", counterexample=POINT_WITHOUT)
            hypotheses = (
                hypothesis("orthogonal", "A is orthogonal", "printed", lost),
                hypothesis("x > 0", "x is positive", "added", Need(needed=False)),
                hypothesis("n", "n is odd", "added", lost),
            )
            return (
                Record(
                    id=id,
                    verdict=Verdict.PROVED,
                    name="square_of_a",
                    printed=r"a_{11}^2 - b = \frac{1}{c + 1}",
                    read="a_{11}^2-b",
                    method="ideal",
                    certificates=(CERTIFICATE,),
                    hypotheses=hypotheses,
                    used_by=("toy:1.3",),
                    **common,
                ),
            )
        case "1.2":
            return tuple(
                Record(id=id + letter, words=f"a link [{letter}] of a chain", **_plain(id + letter), **common)
                for letter in "ab"
            )
        case "1.3":
            return (
                Record(
                    id=id,
                    verdict=Verdict.REFUTED,
                    printed="x = -x",
                    reading=Reading.MISPRINT,
                    corrected="x = x",
                    kind="sign",
                    origin=Origin.PAPER,
                    reason="the next line has the right sign",
                    certificates=(REFUTED,),
                    erratum=correction(
                        certificates=(CORRECTED,),
                        edit=(Edit(printed="- x", corrected="x"),),
                        repairs=(Repair(kind="sign", edit="drop the minus", relation="x = x"),),
                        unique=True,
                    ),
                    **common,
                ),
            )
        case "1.4":
            return (
                Record(
                    id=id, verdict=Verdict.UNDECIDED, words="order does not matter", reason="out of reach", **common
                ),
            )
        case "1.5":
            return (Record(id=id, printed="J = 1", **{**common, "role": Role.DEFINITION}),)
    return (Record(id=id, words="filler", **_plain(id), **common),)


def hypothesis(name: str, words: str, given: str, need: Need | None) -> HypothesisRow:
    return HypothesisRow(name=name, words=words, states="", given=given, need=need)


def correction(**fields: Any) -> Correction:
    """What is right, proved, with these fields."""
    plain: dict[str, Any] = {"verdict": Verdict.PROVED, "reason": "", "certificates": (), "edit": (), "added": ()}
    plain |= {"repairs": None, "unique": None, "empty": False, "row": False}
    return Correction(**{**plain, **fields})


def _plain(id: str) -> dict[str, Any]:
    """A verdict with its certificate."""
    return {"verdict": Verdict.PROVED, "certificates": ({**CERTIFICATE, "id": id, "hypotheses": {}},)}


def reasons(certificates: Sequence[Certificate]) -> list[str | None]:
    """What a checker would say of these certificates, whose proofs are made up."""
    return [None if each.get("proof") == PROOF else "it is none of ours" for each in certificates]


class StandIn(dict[str, Paper]):
    """The toy papers as those that come with the package; there are no folders of users."""

    def __init__(self) -> None:
        super().__init__(papers())
        self.built_in, self.folders = [*self], dict[str, Path]()


def install(patch: Any = setattr) -> None:
    """Put the toy paper and this decider in the place of the real ones."""
    import symcheck.audit.checked
    import symcheck.audit.library
    import symcheck.papers

    patch(symcheck.papers, "load", StandIn)
    patch(symcheck.audit, "decide", sys.modules["stand_in"])
    patch(symcheck.audit.checked, "reasons", reasons)
    patch(symcheck.audit.library, "PRELOAD", ())


if __name__ == "__main__":
    import stand_in

    from symcheck.cli import main

    stand_in.install()
    main()
