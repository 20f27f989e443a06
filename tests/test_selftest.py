"""The self-test plants what it says, counts it right, and notices an audit that lets faults pass."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace
from functools import cache
from random import Random
from typing import Any

import pytest
from msgspec import structs

from symcheck import papers
from symcheck.audit import Serial, checked, decide, expand
from symcheck.audit.judge import judge
from symcheck.core.claims import Assertion
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Record
from symcheck.ledger.selftested import STATUSES
from symcheck.reading import read
from symcheck.selftest import certificates, engines, forgeries, hypotheses, kernels, methods, statements
from symcheck.selftest.evidence import ledger_verdict
from symcheck.selftest.run import Result, classes, run, tasks
from symcheck.selftest.slips import arguments, connectives, slips_of
from symcheck.selftest.statements import proved
from symcheck.selftest.trial import Count, Status, Trial, limits, mixed

IDS = (
    "mirer2009:2.12",
    "mirer2009:2.1.7",
    "esenkov2006:1.34.4",
    "ignatov2005:T7.1",
    "poloskov2004:4.0.27",
    "esenkov2006:2.3.2",
)
FAULTS = 100


@cache
def records() -> tuple[Record, ...]:
    return tuple(record for id in IDS for record in decide.weigh((id, decide.decide(id))))


@cache
def result() -> Result:
    return run(records(), Serial(), FAULTS, seed=3)


def test_nothing_is_accepted_and_nothing_right_rejected() -> None:
    assert result().is_sound
    assert result().whole.errors == []
    assert result().whole.planted > FAULTS / 2


def test_every_kind_that_is_planted_is_declared_and_every_class_plants() -> None:
    for name, kinds in result().counts.items():
        assert set(kinds) == set(classes()[name].kinds)
        assert sum(count.planted + count.right for count in kinds.values()) > 0, name


def test_the_same_seed_plants_the_same_and_another_one_something_else() -> None:
    assert tasks(records(), FAULTS, 3) == tasks(records(), FAULTS, 3) != tasks(records(), FAULTS, 4)
    trials = [[*statements.trials(IDS[0], 5, Random(n))] for n in (1, 1, 2)]
    assert trials[0] == trials[1] != trials[2]


def test_the_counts_add_up_in_json() -> None:
    data: Any = json.loads(json.dumps(result().to_json()))
    for name in (*STATUSES, "right", "false_rejections"):
        assert data[name] == sum(each[name] for each in data["classes"].values())
        for each in data["classes"].values():
            assert each[name] == sum(kind[name] for kind in each["kinds"].values())
            assert not each["papers"] or each[name] == sum(paper[name] for paper in each["papers"].values())
    assert {*data["classes"]["statements"]["papers"]} == {"mirer2009", "poloskov2004", "esenkov2006", "ignatov2005"}
    assert data["planted"] == sum(data[name] for name in STATUSES[1:])
    assert data["seed"] == 3


def test_limits_contain_the_rate_and_shrink_with_the_number() -> None:
    few, many = limits(10, 10), limits(10_000, 10_000)
    assert few
    assert many
    assert few[0] < many[0] < many[1] == 1 == many[2]
    assert limits(0, 0) is None
    assert limits(1, 2) == pytest.approx([0.0126, 0.5, 0.9874], abs=1e-4)


def test_kinds_take_turns_and_rare_ones_begin() -> None:
    drawn = [member for _, member in mixed({"a": ["a"] * 9, "b": ["b"], "c": ["c"] * 9}, Random(0), rare=["b"])]
    assert drawn[0] == "b"
    assert set(drawn[:3]) == {"a", "b", "c"}
    assert len(drawn) == 19


def test_a_checker_that_holds_everything_true_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(certificates, "holds", lambda certificate, beside=(): True)
    place = json.dumps([[each for record in records() for each in record.certificates], []])
    statuses = [trial.status for trial in certificates.trials(place, 60, Random(0))]
    assert Status.ACCEPTED in statuses


def test_an_audit_that_proves_everything_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    everything = proved(IDS[0])[0]
    finding = statements.judge(everything.context, everything.unit, everything.given)
    monkeypatch.setattr(statements, "judge", lambda *_: finding)
    monkeypatch.setattr(hypotheses, "judge", lambda *_: finding)
    assert Status.ACCEPTED in {trial.status for trial in statements.trials(IDS[0], 20, Random(0))}
    assert Status.ACCEPTED in {trial.status for trial in hypotheses.trials(IDS[0], 6, Random(0))}


def test_a_slip_that_the_reader_drops_is_accepted_and_not_equivalent(monkeypatch: pytest.MonkeyPatch) -> None:
    original = proved(IDS[0])[0]
    monkeypatch.setattr(statements, "read", lambda *_: original.unit.tree)
    monkeypatch.setattr(statements.Unit, "reworded", lambda unit, *_: unit)
    statuses = {
        statements.status_of(original, edit) for edit in statements.slips(original) if edit.kind != "equality case"
    }
    assert statuses == {Status.ACCEPTED}


def test_weaker_and_stronger_statements_have_their_own_status() -> None:
    def statuses(id: str, *words: str) -> list[Status]:
        (original,) = proved(id)
        found = {edit.description: edit for edit in statements.slips(original)}
        return [statements.status_of(original, next(e for text, e in found.items() if word in text)) for word in words]

    assert statuses("mirer2009:2.17", "from left to right only") == [Status.WEAKER]
    assert statuses("esenkov2006:N.9", r"< -> \le") == [Status.WEAKER]
    assert statuses("poloskov2004:4.0.10", "both directions") == [Status.STRONGER]
    assert statements.says_more("poloskov2004:4.0.10")


def test_every_kind_of_argument_and_connective_is_changed() -> None:
    notation = proved("poloskov2004:2.4.2")[0].context.notation
    assert any(edit.kind == "argument" for edit in slips_of(arguments, read(r"\sin \psi = 0", notation)))
    equivalence = read(r"a = 0 \Leftrightarrow k = 0", notation)
    kinds = {edit.description.split(" in ")[0] for edit in slips_of(connectives, equivalence)}
    assert {"from left to right only", "from right to left only"} <= kinds


def test_a_checker_that_accepts_all_forged_proofs_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    place = forgeries.CLASS.places(records())[0]
    honest = Counter(trial.status for trial in forgeries.trials(place, 40, Random(0)))
    assert honest[Status.ACCEPTED] == 0 < honest[Status.REJECTED]
    monkeypatch.setattr(certificates, "holds", lambda certificate, beside=(): True)
    assert Status.ACCEPTED in {trial.status for trial in forgeries.trials(place, 40, Random(0))}


def test_a_ledger_that_believes_its_provers_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    refuted = next(place for place in methods.CLASS.places(records()) if "refuted" in place)
    everything = len(methods.CLASS.kinds)
    assert {trial.status for trial in methods.trials(refuted, everything, Random(0))} <= {
        Status.REJECTED,
        Status.EQUIVALENT,
    }
    monkeypatch.setattr(checked, "reasons", lambda certificates: [None for _ in certificates])
    statuses = {trial.kind: trial.status for trial in methods.trials(refuted, everything, Random(0))}
    assert statuses["always yes"] is statuses["cache row signed"] is statuses["rows relabelled"] is Status.ACCEPTED


def test_a_comparison_that_is_always_content_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernels.Forms, "survives", lambda *_: True)
    place = kernels.CLASS.places(records())[0]
    assert Status.ACCEPTED in {trial.status for trial in kernels.trials(place, 10, Random(0))}


def test_a_single_false_rejection_or_too_many_accepted_faults_fail() -> None:
    def having(*statuses: Status) -> Result:
        count = Count()
        for status in statuses:
            count.add(Trial("k", "w", status))
        return Result(0, {"c": {"k": count}})

    assert having(*[Status.REJECTED] * 999, Status.ACCEPTED).is_sound
    assert not having(*[Status.REJECTED] * 900, Status.ACCEPTED).is_sound
    assert not having(Status.FALSELY_REJECTED).is_sound
    assert not replace(having(Status.REJECTED), unfinished=["x"]).is_sound


def test_three_engines_agree_about_every_refutation_and_notice_a_wrong_one() -> None:
    found = engines.agreement(records())
    assert found.points > 3
    assert found.all_three > 1
    assert found.disagreements == []
    refuted = next(each for record in records() for each in record.all_certificates() if each["verdict"] == "refuted")
    wrong = certificates.one("", "", ("claim",), ["=", 1, 1]).of(refuted)
    assert {engines.refutes(name, wrong) for name in engines.ENGINES} == {False}


def test_hypotheses_that_contradict_one_another_prove_nothing() -> None:
    (original,) = proved("esenkov2006:B.12")
    contraries = [each for h in original.given if (each := hypotheses.contrary(original, h))]
    assert contraries
    assert {hypotheses.contradicted(original, each) for each in contraries} == {Status.REJECTED}


def test_a_record_tells_the_set_over_which_it_was_shown() -> None:
    for record in records():
        if record.domain is not None:
            assert set(record.domain["hypotheses"]) <= {hypothesis.name for hypothesis in record.hypotheses}


def test_a_record_that_leaves_a_hypothesis_out_is_refused() -> None:
    record = next(each for each in records() if each.domain and each.domain["hypotheses"])
    record.refuse_wider()
    narrow = record.domain["hypotheses"][0]  # type: ignore[index]
    told = tuple(hypothesis for hypothesis in record.hypotheses if hypothesis.name != narrow)
    with pytest.raises(SymcheckError, match="which the record leaves out"):
        structs.replace(record, hypotheses=told).refuse_wider()
    with pytest.raises(SymcheckError, match="which the record leaves out"):
        Record.from_json(structs.replace(record, hypotheses=told).to_json())


@pytest.mark.slow
def test_no_inequality_keeps_its_proof_and_its_equality_case_with_another_bound() -> None:
    verdicts = Counter(
        ledger_verdict(changed.context, changed.unit, judge(changed.context, changed.unit, changed.given))
        for paper in papers.load().values()
        for each in expand(paper)
        if isinstance(each.item, Assertion) and each.item.statement.equality
        for original in proved(each.id)
        if original.equality
        for edit in statements.slips(original)
        if edit.kind == "bound"
        for changed in [statements.with_slip(original, edit)]
    )
    assert Verdict.PROVED not in verdicts
    assert verdicts[Verdict.UNDECIDED] > 60  # the relation or its set of equality has no proof
