"""The ledger of every paper: complete, decided, with evidence for whatever it accuses."""

from __future__ import annotations

import json
import re
import tempfile
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from warm_cache import warm_cache

import symcheck
from symcheck import kernels, papers
from symcheck.audit import expand, reasons
from symcheck.audit.checked import reason
from symcheck.audit.decide import decide
from symcheck.checker import check_all
from symcheck.checker.__main__ import main
from symcheck.core.verdicts import Loss, Origin, Reading, Role, SymcheckError, Verdict
from symcheck.ledger import Record, line
from symcheck.selftest.statements import unguarded
from symcheck.views.model import Fault, Relation, condition

IDS = [obligation.id for paper in papers.load().values() for obligation in expand(paper)]


@cache
def records() -> tuple[Record, ...]:
    with pytest.MonkeyPatch.context() as patch, tempfile.TemporaryDirectory() as folder:
        patch.setenv("SYMCHECK_CACHE", warm_cache(Path(folder) / "cache"))
        return tuple(symcheck.check(jobs=0))


def claims() -> list[Record]:
    return [record for record in records() if record.role in (Role.CLAIM, Role.OURS)]


def errata() -> list[Record]:
    return [record for record in records() if record.erratum]


def test_at_least_98_percent_of_the_relations_are_decided_and_the_rest_say_why() -> None:
    undecided = [record for record in claims() if record.verdict is Verdict.UNDECIDED]
    assert len(undecided) <= 0.02 * len(claims()), [(r.id, r.reason) for r in undecided]
    assert all(record.reason for record in undecided)


def test_every_decided_relation_carries_certificates_the_checker_accepts() -> None:
    used = {id for record in claims() for each in record.certificates for id, _ in each.get("lemmas", ())}
    lemmas = [each for record in claims() if record.id in used for each in record.certificates]
    for record in claims():
        if record.verdict is Verdict.UNDECIDED:
            continue
        assert record.certificates, record.id
        for certificate, fault in zip(record.certificates, reasons([*record.certificates, *lemmas]), strict=False):
            assert fault is None, (record.id, certificate["claim"])


def test_what_is_refuted_or_misprinted_has_an_erratum_and_nothing_else_has_one() -> None:
    fine = (Reading.AS_PRINTED, Reading.STANDING, Reading.DAMAGED, Reading.WORDS, Reading.ADDED)
    accused = {r.id for r in claims() if r.verdict is Verdict.REFUTED or r.reading not in fine}
    meaningless = {r.id for r in claims() if r.reading is Reading.MISPRINT and r.verdict is Verdict.PROVED}
    assert accused == {record.id for record in errata()} | meaningless
    assert all(r.corrected and r.kind and r.origin and r.reason for r in claims() if r.reading is Reading.DAMAGED)


def test_what_is_called_printed_is_printed() -> None:
    for record in errata():
        label, before, _ = Fault((Relation(record),)).compared
        if label == "printed":
            assert bare(before) in bare(record.printed), record.id


def bare(latex: str) -> str:
    """The letters and numbers of a formula."""
    return "".join(re.findall(r"\w", re.sub(r"\\(?:left|right|cdot|quad)(?![A-Za-z])", "", latex)))


def test_the_readme_counts_what_is_there() -> None:
    text = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
    relations = [record for record in records() if record.verdict]
    refuted = Counter(record.origin for record in relations if record.verdict is Verdict.REFUTED)
    printed = [record for record in relations if record.printed]
    ours = sum(record.role is Role.OURS for record in relations)
    damaged = sum(record.reading is Reading.DAMAGED for record in printed)
    words = len(relations) - len(printed) - ours
    for said in (
        f"but for {damaged} in damaged text",
        f"{len(relations):,} relations",
        f"{len(printed):,} of them are printed as formulas; {words} are sentences",
        f"{ours} are our own",
        f"{refuted.total()} that are refuted, {refuted[Origin.PAPER]} are errors of the papers",
        f"{refuted[Origin.OCR]} of the digitised text",
        f"of {refuted[Origin.UNCERTAIN]} nobody can tell",
    ):
        assert said in " ".join(text.split()), said


def test_every_erratum_is_a_whole_bundle() -> None:
    for record in errata():
        assert record.erratum
        assert record.erratum.verdict is Verdict.PROVED, (record.id, record.erratum.reason)
        assert record.erratum.certificates, record.id
        assert all((record.corrected, record.kind, record.reason)), record.id
        assert record.origin in set(Origin), record.id
        assert record.counterexample or record.erratum.empty, record.id
        assert record.erratum.edit or record.erratum.added, record.id


def test_a_counterexample_satisfies_the_hypotheses_and_gives_both_sides() -> None:
    for record in errata():
        if record.verdict is Verdict.REFUTED:
            refuted = [c for c in record.certificates if c["verdict"] == "refuted"]
            assert refuted, record.id
            assert record.counterexample, record.id
            letters = {name for c in refuted for name in re.findall(r"[A-Za-z]\w*", json.dumps(c["claim"]))}
            assert record.counterexample["values"] or "shown" in record.counterexample or not letters, record.id
            assert "shown" in record.counterexample or refuted[0]["claim"][0] in ("=>", "<=>", "and"), record.id


def test_a_hypothesis_that_is_needed_shows_what_is_lost_without_it() -> None:
    weighed = [(row, row.need) for record in claims() for row in record.hypotheses if row.need]
    shown = [(row, need) for row, need in weighed if need.needed]
    assert {need.lost for _, need in shown} == set(Loss)
    for row, need in shown:
        assert need.counterexample
        assert reason(need.counterexample) is None
        assert condition(row).without.startswith(need.lost)
    assert not any(need.lost for _, need in weighed if not need.needed)


def test_every_inequality_that_may_be_an_equality_says_where_and_is_proved_with_that() -> None:
    assert unguarded(records()) == []
    assert len([record for record in claims() if any(c["claim"][0] in ("<=", ">=") for c in record.certificates)]) > 20


def test_definitions_premises_and_exclusions_claim_nothing() -> None:
    for record in records():
        if record.role not in (Role.CLAIM, Role.OURS):
            assert record.verdict is None, record.id


def test_a_record_survives_json() -> None:
    for record in records():
        assert Record.from_json(json.loads(json.dumps(record.to_json()))).id == record.id


def test_uses_refer_to_declared_items_and_make_no_circle() -> None:
    uses = {record.id: record.uses for record in records()}
    declared = set(IDS)

    def visit(id: str, above: tuple[str, ...]) -> None:
        assert id not in above, f"circle: {' -> '.join((*above, id))}"
        for other in next((u for key, u in uses.items() if key.rstrip("abcdefgh") == id), ()):
            assert other in declared, f"{id} uses {other}"
            visit(other, (*above, id))

    for id in IDS:
        visit(id, ())


def test_the_recorded_certificates_are_those_of_the_ledger() -> None:
    for key in papers.load():
        data = json.loads((kernels.folder() / "certificates" / f"{key}.json").read_bytes())
        recorded = {line(certificate) for certificate in data["certificates"]}
        assert {line(c) for r in claims() if r.paper == key for c in r.certificates} <= recorded


def test_ours_are_marked_and_proved() -> None:
    ours = [record for record in records() if record.role is Role.OURS]
    assert ours
    assert all(record.verdict is Verdict.PROVED for record in ours)


def test_an_unknown_id_is_named() -> None:
    with pytest.raises(SymcheckError, match=r"mirer2009:9\.9"):
        decide("mirer2009:9.9")


def recorded(key: str) -> dict[str, object]:
    data: dict[str, object] = json.loads((kernels.folder() / "certificates" / f"{key}.json").read_bytes())
    return data


@pytest.fixture
def outcome(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Callable[[dict[str, object]], tuple[int, str]]:
    """The checker's exit code and output for one file of certificates."""

    def run(data: dict[str, object]) -> tuple[int, str]:
        file = tmp_path / "certificates.json"
        file.write_text(json.dumps(data), encoding="utf-8")
        return main([str(file)]), capsys.readouterr().out

    return run


def test_a_proof_from_a_lemma_falls_with_the_lemma(outcome: Callable[[dict[str, object]], tuple[int, str]]) -> None:
    data = recorded("mirer2009")
    every = data["certificates"]
    assert isinstance(every, list)
    lemma = "mirer2009:2.13.4"
    leaning = {each["id"] for each in every if lemma in [id for id, _ in each.get("lemmas", ())]}
    assert outcome(data)[0] == 0
    code, text = outcome({**data, "certificates": [each for each in every if each["id"] != lemma]})
    assert code == 1
    assert "mirer2009:2.10a: a lemma is not proved" in text
    assert leaning >= {"mirer2009:2.10a", "mirer2009:2.17"}


def test_a_result_depends_on_the_lemmas_it_may_use(monkeypatch: pytest.MonkeyPatch) -> None:
    from symcheck.audit import obligation
    from symcheck.papers.mirer2009 import sec2

    def prints() -> dict[str, str]:
        obligation._paper_context.cache_clear()
        return {each.id: obligation.fingerprint(each) for each in expand(papers.load()["mirer2009"])}

    before = prints()
    lemma = sec2.product_and_its_excess
    changed = replace(lemma, statement=replace(lemma.statement, states=(r"J_1 J_2 J_3 = I_1 I_2 I_3",)))
    monkeypatch.setattr(sec2, "product_and_its_excess", changed)
    after = prints()
    monkeypatch.undo()
    assert prints() == before
    assert after["mirer2009:2.10"] != before["mirer2009:2.10"]


def test_a_lemma_needs_its_own_hypotheses_in_force(outcome: Callable[[dict[str, object]], tuple[int, str]]) -> None:
    data = recorded("mirer2009")
    for each in data["certificates"]:  # type: ignore[attr-defined]
        if "lemmas" in each:
            each["hypotheses"].pop("orthogonal", None)
    code, text = outcome(data)
    assert code == 1
    assert "a lemma is not proved, or under other assumptions" in text


def test_a_lemma_does_not_speak_of_a_letter_defined_otherwise() -> None:
    equation = ["=", "J", ["*", 1, "x"]]
    lemma = {"id": "p:1", "verdict": "proved", "claim": equation, "definitions": [["J", "x"]]}
    lemma["proof"] = {"rule": "identity", "cofactors": []}
    by = {"rule": "implies", "then": {"rule": "identity", "cofactors": [[["here", 0], "1"]]}}
    use = {**lemma, "id": "p:2", "lemmas": [["p:1", equation]], "proof": by}

    def fault(changed: dict[str, object], *beside: dict[str, object]) -> str | None:
        *_, answer = check_all([*beside, changed])
        return answer

    assert fault(use, lemma) is None
    assert fault({**use, "definitions": [["J", 8]]}, lemma)
    assert fault({**use, "lemmas": [["p:1", ["=", "J", "y"]]]}, lemma)
    assert fault(use)
    assert fault(use, {**lemma, "claim": ["=", "J", 8]})
