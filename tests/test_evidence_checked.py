"""Nothing is told of a relation that the checker has not accepted: not by a prover, not by the cache, not in part."""

from __future__ import annotations

import json
import os
import sqlite3
import sys
from collections.abc import Callable, Mapping
from copy import deepcopy
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from msgspec.structs import replace

from symcheck import papers
from symcheck.audit import Cache, Serial, accepted, checked, decide, run
from symcheck.audit.cache import FILE
from symcheck.audit.checked import NOT_ACCEPTED
from symcheck.core.verdicts import Verdict
from symcheck.ledger import Need, Record

REFUTED = "poloskov2004:4.0.27"  # with a correction, and a hypothesis that it needs
PROVED = "poloskov2004:2.1.2"  # with a proof that does without a hypothesis
EQUALITY = "mirer2009:2.3"  # an inequality with its set of equality
RESTING = "mirer2009:2.2.1"  # on a lemma
LEMMA = "mirer2009:2.1.7"
OTHER = "poloskov2004:2.4.2"
DECIDED = {id: decide.weigh((id, decide.decide(id))) for id in (REFUTED, PROVED, EQUALITY, RESTING, LEMMA, OTHER)}


@pytest.fixture(autouse=True)
def _own_key(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


def copied(id: str) -> Record:
    """The first record of a declaration, which may be spoilt."""
    return Record.from_json(json.loads(json.dumps(DECIDED[id][0].to_json())))


def told_of(record: Record, *beside: str) -> Record:
    others: Mapping[str, tuple[Record, ...]] = {id: DECIDED[id] for id in beside}
    return accepted({"it": (record,)}, others)["it"][0]


def test_accepted_results_are_reported_unchanged() -> None:
    assert accepted(DECIDED) == DECIDED


def test_a_proof_from_a_lemma_is_accepted_with_the_proof_of_the_lemma_only() -> None:
    assert told_of(copied(RESTING), LEMMA).verdict is Verdict.PROVED
    alone = told_of(copied(RESTING))
    assert (alone.verdict, alone.certificates) == (Verdict.UNDECIDED, ())
    assert alone.reason == f"{NOT_ACCEPTED} (a lemma is not proved, or under other assumptions)"


def _relabelled(record: Record) -> Record:
    return replace(record, verdict=Verdict.PROVED)


def _bare(record: Record) -> Record:
    return replace(record, certificates=())


def _of_another(record: Record) -> Record:
    return replace(record, certificates=copied(OTHER).certificates)


def _false(record: Record) -> Record:
    """A claim that its proof does not show."""
    spoilt = deepcopy(record.certificates)
    spoilt[0]["claim"] = ["=", 0, 1]
    return replace(record, certificates=spoilt)


def _certificate_relabelled(record: Record) -> Record:
    return replace(record, verdict=Verdict.PROVED, certificates=({**record.certificates[0], "verdict": "proved"},))


def _malformed(record: Record) -> Record:
    return replace(record, certificates=({"id": record.id, "verdict": record.verdict},))


def _equality_spoilt(record: Record) -> Record:
    spoilt = deepcopy(record.certificates)
    spoilt[-1]["claim"][2] = ["=", 0, 0]
    return replace(record, certificates=spoilt)


VERDICTS: dict[str, tuple[str, Callable[[Record], Record], str]] = {
    "a verdict without proof": (REFUTED, _relabelled, "there is none"),
    "a verdict without certificates": (PROVED, _bare, "there is none"),
    "a certificate of another relation": (PROVED, _of_another, f"it is of {OTHER}"),
    "another claim": (PROVED, _false, "not the combination"),
    "a refutation called a proof": (REFUTED, _certificate_relabelled, "a step without proof"),
    "half a certificate": (PROVED, _malformed, "malformed"),
    "a set of equality that is not shown": (EQUALITY, _equality_spoilt, ""),
}


@pytest.mark.parametrize(("id", "spoil", "reason"), VERDICTS.values(), ids=VERDICTS.keys())
def test_a_verdict_that_its_certificates_do_not_show_is_undecided(
    id: str, spoil: Callable[[Record], Record], reason: str
) -> None:
    found = told_of(spoil(copied(id)))
    assert found.verdict is Verdict.UNDECIDED
    assert found.reason.startswith(f"{NOT_ACCEPTED} (")
    assert reason in found.reason
    assert not found.certificates
    assert found.counterexample is None


def test_a_correction_that_its_certificates_do_not_show_is_undecided() -> None:
    record = copied(REFUTED)
    assert record.erratum is not None
    record.erratum.certificates[0]["claim"] = ["=", 0, 1]
    found = told_of(record)
    assert found.verdict is Verdict.REFUTED
    assert found.erratum is not None
    assert found.erratum.verdict is Verdict.UNDECIDED
    assert found.erratum.reason.startswith(NOT_ACCEPTED)
    assert found.erratum.certificates == ()


def _changed(record: Record, name: str, **changes: Any) -> Record:
    rows = tuple(
        replace(row, need=replace(row.need, **changes)) if row.need and row.name == name else row
        for row in record.hypotheses
    )
    return replace(record, hypotheses=rows)


def _hypothesis(record: Record, needed: bool) -> str:
    rows = (row for row in record.hypotheses if row.need and row.need.needed is needed)
    return next(row.name for row in rows if needed or (row.need and row.need.proofs))


def _need_told(record: Record, name: str) -> Need | None:
    return next(row.need for row in told_of(record).hypotheses if row.name == name)


@pytest.mark.parametrize(
    "changes",
    [
        {"counterexample": None},
        {"lost": ""},
        {"lost": "a term is long"},
        {"lost": "nothing of the kind exists"},
        {"needed": False},
        {"needed": None},
        {"counterexample": DECIDED[OTHER][0].certificates[0]},
    ],
    ids=lambda changes: str(changes)[:40],
)
def test_a_need_that_is_not_shown_is_unknown(changes: dict[str, Any]) -> None:
    record = copied(EQUALITY)
    name = _hypothesis(record, True)
    assert _need_told(_changed(record, name, **changes), name) == Need(needed=None)


@pytest.mark.parametrize("changes", [{"proofs": ()}, {"needed": True}], ids=str)
def test_a_hypothesis_is_needless_if_a_proof_does_without_it(changes: dict[str, Any]) -> None:
    record = copied(PROVED)
    name = _hypothesis(record, False)
    assert told_of(record) == record
    assert _need_told(_changed(record, name, **changes), name) == Need(needed=None)


@pytest.mark.parametrize("many", [1, 10**6], ids=["two processes", "one process"])
def test_one_process_or_two_say_the_same(many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checked, "MANY", many)
    monkeypatch.setattr(checked, "_may_fork", lambda: sys.platform == "linux")
    assert accepted(DECIDED) == DECIDED
    spoilt = {id: tuple(_false(copied(id)) for _ in range(2)) for id in (PROVED, OTHER, RESTING, EQUALITY)}
    found = accepted(spoilt | {LEMMA: DECIDED[LEMMA]})
    assert {record.verdict for id in spoilt for record in found[id]} == {Verdict.UNDECIDED}
    assert found[LEMMA] == DECIDED[LEMMA]


@pytest.mark.skipif(sys.platform != "linux", reason="no other process is asked")
def test_what_a_killed_process_does_not_say_is_checked_here(monkeypatch: pytest.MonkeyPatch) -> None:
    here = os.getpid()

    def answer(sender: Any, certificates: Any) -> None:
        assert os.getpid() != here
        os._exit(9)

    monkeypatch.setattr(checked, "MANY", 1)
    monkeypatch.setattr(checked, "_may_fork", lambda: True)
    monkeypatch.setattr(checked, "_send", answer)
    assert accepted(DECIDED) == DECIDED


# --- the cache


class Said(list[str]):
    """Collects what the cache says."""

    __call__ = list.append


def audited(folder: Path, said: Said, decider: Any = decide, weigh: bool = True) -> list[Record]:
    cache, ids, known = Cache(folder, said), [REFUTED, PROVED], papers.load()
    try:
        return run.audit(ids, papers=known, decide=decider, cache=cache, executor=Serial(), timeout=60.0, weigh=weigh)
    finally:
        cache.close()


def deciding(*forged: Record) -> Any:
    """The decider, which answers with a forged record where there is one."""
    answers = {record.id: (record,) for record in forged}
    return SimpleNamespace(
        expand=decide.expand,
        fingerprint=decide.fingerprint,
        placed=decide.placed,
        weigh=decide.weigh,
        decide=lambda id: answers.get(id, DECIDED.get(id) or decide.decide(id)),
    )


def test_needs_are_decided_after_the_verdict_when_they_are_asked_for_and_kept(tmp_path: Path) -> None:
    def asked(decider: Any, weigh: bool) -> list[Record]:
        return audited(tmp_path, said, decider, weigh)

    def refuse(_: object) -> Any:
        raise AssertionError("this is known")

    said = Said()
    bare = asked(SimpleNamespace(**{**vars(decide), "weigh": refuse}), weigh=False)
    assert any(record.hypotheses for record in bare)
    assert not any(row.need for record in bare for row in record.hypotheses)
    whole = asked(SimpleNamespace(**{**vars(decide), "decide": refuse}), weigh=True)
    weighed = {record.id: record.hypotheses for id in (PROVED, REFUTED) for record in DECIDED[id]}
    assert {record.id: record.hypotheses for record in whole} == weighed
    nothing = SimpleNamespace(**{**vars(decide), "decide": refuse, "weigh": refuse})
    assert asked(nothing, weigh=True) == whole
    assert asked(nothing, weigh=False) == bare


ROWS = {
    "a verdict": 'UPDATE records SET records = replace(records, \'"verdict":"refuted"\', \'"verdict":"proved"\')',
    "a word": "UPDATE records SET records = replace(records, 'printed', 'PRINTED')",
    "another row": f"UPDATE records SET records = (SELECT records FROM records WHERE id = '{PROVED}')",
    "a row with its signature": "UPDATE records SET (records, signature) = "
    f"(SELECT records, signature FROM records WHERE id = '{PROVED}')",
    "a number for a signature": "UPDATE records SET signature = 7",
    "no signature": "UPDATE records SET signature = NULL",
    "letters for a signature": "UPDATE records SET signature = 'ф'",
}


@pytest.mark.parametrize("edit", ROWS.values(), ids=ROWS.keys())
def test_an_edited_row_is_decided_anew(edit: str, tmp_path: Path) -> None:
    said = Said()
    right = audited(tmp_path, said, deciding())
    connection = sqlite3.connect(tmp_path / FILE)
    with connection:
        connection.execute(f"{edit} WHERE id = '{REFUTED}'")
    connection.close()
    assert audited(tmp_path, said, deciding()) == right
    assert len(said) == 1
    assert "could not be read back; deciding again" in said[0]


FORGED = {name: spoil for name, (id, spoil, _) in VERDICTS.items() if id == REFUTED}


@pytest.mark.parametrize("spoil", FORGED.values(), ids=FORGED.keys())
def test_a_row_that_was_signed_is_checked_again_all_the_same(spoil: Callable[[Record], Record], tmp_path: Path) -> None:
    said, forger = Said(), deciding(spoil(copied(REFUTED)))
    assert audited(tmp_path, said, forger)[1].verdict is Verdict.UNDECIDED
    assert audited(tmp_path, said, deciding()) == audited(tmp_path / "other", said, deciding())
    assert said == ["1 of the results in the cache is not accepted by the checker; deciding again"]


def test_the_cache_of_somebody_else_is_not_believed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    said = Said()
    audited(tmp_path, said, deciding(_relabelled(copied(REFUTED))))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "of another user"))
    assert audited(tmp_path, said, deciding())[1].verdict is Verdict.REFUTED
    assert said == [f"2 results in the cache {tmp_path / FILE} could not be read back; deciding again"]


def test_a_key_that_cannot_be_kept_costs_the_cache_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "file"))
    said = Said()
    assert audited(tmp_path, said, deciding())[1].verdict is Verdict.REFUTED
    assert len(said) == 1
    assert said[0].startswith("no cache, as there is no key to sign it with")
    assert not (tmp_path / FILE).exists()
