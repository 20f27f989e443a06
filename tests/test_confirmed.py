"""What is shown of Coq's confirmation is what generated/coq says, and only of the certificates it was said of."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import stand_in
from click.testing import Result
from msgspec.structs import replace
from unpacked import unpacked

from symcheck import kernels, papers
from symcheck.coq import confirmed
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import digest, digest_of, store
from symcheck.ledger.store import COQ
from symcheck.views import pictures
from symcheck.views.page import sources

Run = Callable[..., Result]
RIGHT, WRONG = (record for number in ("1.1", "1.3") for record in stand_in.decide(f"toy:{number}"))
D1, D3C = (digest([digest_of(each)]) for each in (stand_in.CERTIFICATE, stand_in.CORRECTED))
STATES = {
    "confirmed": ("", "yes"),
    "not confirmed": ("no integral", "no: no integral"),
}


@pytest.fixture
def folder(toy: Path) -> Path:
    """The folder generated/ of the toy paper."""
    return toy / "generated"


@pytest.fixture
def shown(symcheck: Run, toy: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], Iterator[tuple[str, str, str]]]:
    """What every output says of toy:1.1 and of toy:1.3: (its name, the one, the other)."""
    monkeypatch.setattr(sources, "kernels", lambda *_: {})
    for name, empty in (("envelopes", []), ("densities", []), ("stability", None)):
        monkeypatch.setattr(pictures, name, lambda found=empty: found)
    monkeypatch.chdir(toy)

    def exported(name: str) -> str:
        result = symcheck("export", "--jobs", "0", "--format", name, "toy:1.1", "toy:1.3")
        assert result.exit_code == 0, result.output
        return result.stdout

    def of_show(number: str) -> str:
        lines = symcheck("show", f"toy:{number}").stdout.splitlines()
        return "".join(line[14:] for line in lines if line.startswith("Coq confirms"))

    def read() -> Iterator[tuple[str, str, str]]:
        yield "show", of_show("1.1"), of_show("1.3")
        one, other = (row["confirmed by Coq"] for row in csv.DictReader(io.StringIO(exported("csv"))))
        yield "csv", one, other
        found = json.loads(exported("json"))["coq"]
        yield "json", found["toy:1.1"], f"correction: {found['toy:1.3, corrected']}"
        rows = [line.split(" | ")[-1].removesuffix(" |") for line in exported("markdown").splitlines()]
        yield "markdown", rows[-2], rows[-1]
        assert symcheck("report", "--jobs", "0", "toy:1.1", "toy:1.3", "--output", "page.html").exit_code == 0
        index = unpacked((toy / "page.html").read_text("utf-8").partition('id="folded-index">')[2].partition("<")[0])
        yield "report", *(index["names"][row[5]] for row in index["rows"])

    return read


@pytest.mark.parametrize(("reason", "said"), STATES.values(), ids=STATES)
def test_every_output_says_what_is_recorded(reason: str, said: str, folder: Path, shown: Any) -> None:
    confirmed.record_all(folder, {"toy:1.1": (D1, reason), "toy:1.3, corrected": (D3C, reason)})
    for name, one, other in shown():
        assert (one, other) == (said, f"correction: {said}"), name


@pytest.mark.parametrize("digests", [("another", "another"), None], ids=["other certificates", "nothing recorded"])
def test_what_was_said_of_other_certificates_is_not_believed(
    digests: tuple[str, str] | None, folder: Path, shown: Any
) -> None:
    if digests:
        confirmed.record_all(folder, {"toy:1.1": (digests[0], ""), "toy:1.3, corrected": (digests[1], "")})
    for name, one, other in shown():
        assert (one, other) == ("not tried", "correction: not tried"), name


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ({}, ""),
        ({"toy:1": "yes"}, "Coq confirms the proof"),
        ({"toy:1, corrected": "yes"}, "Coq confirms the correction"),
        ({"toy:1": "yes", "toy:1, corrected": "yes"}, "Coq confirms the proof and the correction"),
        (
            {"toy:1": "yes", "toy:1, corrected": "no: no integral"},
            "Coq confirms the proof; Coq does not confirm the correction: no integral",
        ),
        ({"toy:1": "not tried"}, "Coq was not asked about the proof"),
    ],
)
def test_people_are_told_in_a_sentence(said: dict[str, str], told: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(confirmed, "confirmed", lambda _: said)
    assert confirmed.sentence(replace(RIGHT, id="toy:1")) == told


def test_a_changed_certificate_is_not_confirmed(folder: Path) -> None:
    confirmed.record_all(folder, {RIGHT.id: (D1, "")})
    assert confirmed.confirmed(RIGHT, folder) == {RIGHT.id: "yes"}
    changed = replace(RIGHT, certificates=({**stand_in.CERTIFICATE, "digest": "d2"},))
    assert confirmed.confirmed(changed, folder) == {RIGHT.id: "not tried"}
    longer = replace(RIGHT, certificates=(stand_in.CERTIFICATE, {**stand_in.CERTIFICATE, "digest": "d2"}))
    assert confirmed.confirmed(longer, folder) == {RIGHT.id: "not tried"}


def test_another_proof_of_the_same_statement_is_not_confirmed(folder: Path) -> None:
    confirmed.record_all(folder, {RIGHT.id: (D1, "")})
    proof = {"rule": "identity", "cofactors": []}
    changed = replace(RIGHT, certificates=({**stand_in.CERTIFICATE, "proof": proof},))
    assert confirmed.confirmed(changed, folder) == {RIGHT.id: "not tried"}


EDITS = {
    "an outcome": ('"slow"', '""'),
    "a digest of certificates": (D1, D3C),
    "an entry left out": (f'"toy:1.1": ["{D1}",""],\n', ""),
    "the digest": ('"digest": "', '"digest": "0'),
    "a relation": ("toy:1.1", "toy:1.2a"),
}


@pytest.mark.parametrize(("old", "new"), EDITS.values(), ids=EDITS.keys())
def test_what_was_changed_by_hand_is_refused(old: str, new: str, folder: Path, symcheck: Run) -> None:
    assert symcheck("generate").exit_code == 0
    confirmed.record_all(folder, {"toy:1.1": (D1, ""), "toy:1.3, corrected": (D3C, "slow")})
    file = folder / COQ / "toy.json"
    text = file.read_text("utf-8")
    assert old in text
    file.write_text(text.replace(old, new, 1), encoding="utf-8")
    for refused in (symcheck("generate", "--check"), symcheck("show", "toy:1.1")):
        assert refused.exit_code == 2
        assert refused.stderr.count("\n") == 1
        assert "toy.json cannot be read (its outcomes are not those that its digest is of)" in refused.stderr
    assert confirmed.record_all(folder, {"toy:1.1": (D1, "")}) == [file]  # `make coq` begins anew
    assert confirmed.recorded(folder, "toy") == {"toy:1.1": (D1, "")}


def test_coq_is_asked_of_what_is_proved_alone() -> None:
    assert [corrected for corrected, _ in confirmed.asked(RIGHT)] == [False]
    assert [corrected for corrected, _ in confirmed.asked(WRONG)] == [True]
    (undecided,), (definition,) = (stand_in.decide(f"toy:{number}") for number in ("1.4", "1.5"))
    assert [*confirmed.asked(undecided), *confirmed.asked(definition)] == []
    assert confirmed.summary(undecided) == ""


def test_what_is_recorded_of_other_relations_stays(folder: Path) -> None:
    confirmed.record_all(folder, {"toy:1": ("a", ""), "toy:2": ("b", "slow")})
    assert confirmed.record_all(folder, {"toy:2": ("c", "")}) == [folder / COQ / "toy.json"]
    assert confirmed.recorded(folder, "toy") == {"toy:1": ("a", ""), "toy:2": ("c", "")}
    assert [file.name for file in (folder / COQ).iterdir()] == ["toy.json"]


def test_a_failed_write_leaves_what_was_recorded(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(self: Path, target: Path) -> None:
        raise OSError(28, "No space left on device")

    confirmed.record_all(folder, {"toy:1": ("a", "")})
    monkeypatch.setattr(Path, "replace", fail)
    with pytest.raises(OSError, match="No space"):
        confirmed.record_all(folder, {"toy:1": ("b", "")})
    assert confirmed.recorded(folder, "toy") == {"toy:1": ("a", "")}
    assert [file.name for file in (folder / COQ).iterdir()] == ["toy.json"]


@pytest.mark.parametrize(
    ("outcomes", "told"),
    [
        ({"toy:1": ("a", ""), "toy:2": ("b", "slow")}, []),
        ({"toy:1": ("new", ""), "toy:2": ("b", ""), "toy:3": ("c", "slow")}, []),
        ({"toy:1": ("a", "Coq rejects the proof"), "toy:2": ("b", "")}, ["Coq rejects the proof"]),
        ({"toy:1": ("new", "slow"), "toy:2": ("b", "slow")}, ["slow"]),
        ({"toy:2": ("b", "slow")}, ["Coq was not asked"]),
        ({}, ["Coq was not asked"]),
    ],
)
def test_what_is_no_longer_confirmed_is_named(
    outcomes: dict[str, confirmed.Outcome], told: list[str], folder: Path
) -> None:
    confirmed.record_all(folder, {"toy:1": ("a", ""), "toy:2": ("b", "slow")})
    assert [*confirmed.lost(folder, outcomes)] == [
        f"toy:1 is recorded as confirmed by Coq, and is not: {reason}" for reason in told
    ]
    assert [*confirmed.lost(folder, outcomes, ["other"])] == []


def test_generate_keeps_what_is_said_of_these_certificates_and_drops_the_rest(symcheck: Run, folder: Path) -> None:
    assert symcheck("generate").exit_code == 0
    confirmed.record_all(folder, {"toy:1.1": (D1, ""), "toy:1.3, corrected": (D3C, "slow")})
    assert symcheck("generate", "--check").exit_code == 0
    confirmed.record_all(folder, {"toy:1.1": ("another", ""), "toy:gone": (D1, "")})
    told = symcheck("generate", "--check")
    assert told.exit_code == 1
    assert "generated/coq/toy.json: differs from line 2 on" in told.stderr
    assert symcheck("generate").exit_code == 0
    assert confirmed.recorded(folder, "toy") == {"toy:1.3, corrected": (D3C, "slow")}
    confirmed.record_all(folder, {"toy:1.3, corrected": ("another", "")})
    assert "generated/coq/toy.json: superfluous" in symcheck("generate", "--check").stderr
    assert symcheck("generate").exit_code == 0
    assert not (folder / COQ / "toy.json").exists()


@pytest.mark.parametrize(
    "text", ["", "[]", "{", '{"schema": 1, "paper": "toy", "items": {"toy:1": 3}}', "null", "\xff"]
)
def test_a_damaged_file_is_one_clear_line(text: str, folder: Path) -> None:
    (folder / COQ).mkdir(parents=True)
    (folder / COQ / "toy.json").write_text(text, encoding="latin-1")
    with pytest.raises(SymcheckError, match=r"toy\.json cannot be read.*make coq"):
        confirmed.confirmed(RIGHT, folder)


def certificates(paper: str) -> list[dict[str, Any]]:
    data = json.loads((kernels.folder() / "certificates" / f"{paper}.json").read_text(encoding="utf-8"))
    found: list[dict[str, Any]] = data["certificates"]
    return found


def test_coq_confirms_nine_tenths_of_all_and_every_inequality_of_mirer2009() -> None:
    folder = kernels.folder()
    proved = [id for paper in papers.load() for id, v in store.expected(folder, paper).items() if v is Verdict.PROVED]
    said = {name: reason for paper in papers.load() for name, (_, reason) in confirmed.recorded(folder, paper).items()}
    assert sum(said.get(id) == "" for id in proved) >= 0.9 * len(proved) > 1000
    orders = {each["id"] for each in certificates("mirer2009") if each["claim"][0] in ("<", "<=", ">", ">=")}
    assert [id for id in proved if id in orders and said.get(id) != ""] == []
    assert len(orders & {*proved}) > 10
