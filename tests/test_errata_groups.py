"""Errata are told in the order in which a reviewer wants them: the few that matter before the many that do not."""

from __future__ import annotations

import io
from typing import Any

import pytest
from msgspec.structs import replace
from rich.console import Console
from stand_in import correction

from symcheck.core.verdicts import SLIPS, Group, Origin, Reading, Role, Verdict
from symcheck.ledger import Record
from symcheck.views import terminal
from symcheck.views.model import Fault, Relation, errata, erring, headline

WRONG = Record(
    id="toy:2.1",
    paper="toy",
    section="2",
    line=7,
    role=Role.CLAIM,
    read="x = -x",
    verdict=Verdict.REFUTED,
    reading=Reading.MISPRINT,
    kind="sign",
    origin=Origin.PAPER,
    reason="as the next line has it",
    corrected="x = x",
    erratum=correction(),
)
ROW = replace(WRONG, id="toy:2.1V.3a", printed="V_3 : [1, -1]", corrected="V_3 : [1, 1]", erratum=correction(row=True))
GROUPS = {
    Group.STATEMENT: WRONG,
    Group.ROW: ROW,
    Group.SLIP: replace(WRONG, id="toy:2.2", kind="lost prime"),
    Group.DAMAGED: replace(WRONG, id="toy:2.3", reading=Reading.DAMAGED, erratum=None),
}


def told(*records: Record) -> str:
    out = Console(file=io.StringIO(), width=150, highlight=False, markup=False)
    terminal.errata(out, records)
    text = out.file.getvalue()  # type: ignore[attr-defined]
    assert isinstance(text, str)
    return text


@pytest.mark.parametrize("group", GROUPS)
def test_each_erratum_has_its_group(group: Group) -> None:
    assert GROUPS[group].group is group
    assert GROUPS[group].to_json()["group"] == group


INSTEAD = r"4 \sqrt{1 + 3 x}"
CELL = {"read": r"r_7 = 4 \sqrt{1 + 15 x}", "corrected": r"r_7 = 4 \sqrt{1 + 3 x}"}
BESIDE: dict[str, tuple[dict[str, Any], tuple[str, str, str], str]] = {
    "a formula": ({"printed": "x =-x", "read": "x = -x"}, ("printed", "x = -x", "x = x"), "x = -x"),
    "a link of a chain": (
        {"id": "toy:2.1b", "printed": r"y &= \quad x = -\,x, \\"},
        ("printed", "x = -x", "x = x"),
        "x = -x",
    ),
    "letters that stand nowhere": ({"printed": "(р = IT}", "read": "F = x"}, ("read as", "F = x", "x = x"), "(р = IT}"),
    "words": ({"words": "x is odd", "place": "line 7: so … odd"}, ("read as", "x = -x", "x = x"), ""),
    "a cell": (
        {"printed": r"4 \sqrt{1 + 15 x}", **CELL, "erratum": correction(instead=f"${INSTEAD}$")},
        ("printed", r"4 \sqrt{1 + 15 x}", INSTEAD),
        r"4 \sqrt{1 + 15 x}",
    ),
    "a row": (
        {"printed": "V_3 : [1, -1]", "corrected": "V_3 : [1, 1]", "erratum": correction(row=True)},
        ("printed", "V_3 : [1, -1]", "V_3 : [1, 1]"),
        "V_3 : [1, -1]",
    ),
}


@pytest.mark.parametrize("kind", BESIDE)
def test_what_stands_beside_the_right_form_is_called_printed_where_it_is(kind: str) -> None:
    fields, compared, printed = BESIDE[kind]
    fault = Fault((Relation(replace(WRONG, **fields)),))
    assert fault.compared == compared
    facts = [(fact.label, fact.text) for fact in fault.facts if fact.text]
    assert [text for label, text in facts if label == "printed"] == [printed] * bool(printed)
    assert (compared[0], compared[1]) in facts
    assert ("correct", compared[2]) in facts


def test_the_errata_are_counted_with_what_they_are() -> None:
    empty = replace(WRONG, id="toy:2.9", verdict=Verdict.PROVED)
    said = "2 errata: 1 refuted, 1 that says nothing or is read as it must be meant"
    assert erring([WRONG, empty, GROUPS[Group.DAMAGED]]) == said
    assert erring([WRONG, empty, empty]) == "3 errata: 1 refuted, 2 that say nothing or are read as they must be meant"
    assert erring([WRONG]) == "1 erratum, refuted"
    assert erring([WRONG, ROW]) == "2 errata, all refuted"
    assert erring([]) == "no errata"


def test_what_is_right_has_no_group() -> None:
    right = replace(WRONG, corrected="", reading=Reading.AS_PRINTED, verdict=Verdict.PROVED)
    assert right.group is None
    assert replace(right, verdict=Verdict.REFUTED).group is Group.STATEMENT  # nobody knows what is right instead
    assert replace(right, verdict=Verdict.REFUTED, role=Role.OURS).group is None


def test_a_record_with_its_group_is_read_back() -> None:
    assert Record.from_json(ROW.to_json()) == ROW


@pytest.mark.parametrize("kind", sorted(SLIPS))
def test_a_slip_in_a_row_is_a_slip(kind: str) -> None:
    assert replace(ROW, kind=kind).group is Group.SLIP


def test_the_weightiest_come_first() -> None:
    text = told(*reversed(GROUPS.values()))
    places = [text.index(group.upper()) for group in Group]
    assert places == sorted(places)


def test_the_authors_own_come_first_and_of_these_that_on_which_most_rests() -> None:
    used = replace(WRONG, id="other:2.9", paper="other", kind="number", used_by=("other:3.1",))
    unsure = replace(WRONG, id="toy:2.0", kind="letter", origin=Origin.UNCERTAIN, used_by=("toy:2.1", "toy:2.2"))
    [(_, lists)] = errata([unsure, WRONG, used])
    assert [relation.record.id for each in lists for relation in each.relations] == ["other:2.9", "toy:2.1", "toy:2.0"]


def test_rows_stay_in_printed_order() -> None:
    later = replace(ROW, id="toy:2.1V.4a", printed="V_4 : [1, -1]", used_by=("toy:3.1",))
    [(_, lists)] = errata([ROW, later])
    assert [fault.number for each in lists for fault in each.faults] == ["2.1V.3a", "2.1V.4a"]


def test_a_group_without_members_is_left_out() -> None:
    assert Group.SLIP.upper() not in told(WRONG, ROW)


def test_the_parts_of_a_row_are_one_line() -> None:
    text = told(ROW, replace(ROW, id="toy:2.1V.3b"), replace(ROW, id="toy:2.1V.4a", printed="V_4 : [1, 0]"))
    rows = [line.strip().split("  ")[0] for line in text.splitlines() if line.strip().startswith("2.1V")]
    assert rows == ["2.1V.3a, b", "2.1V.4a"]


def test_rows_of_one_list_kind_and_origin_stand_under_one_heading() -> None:
    label = replace(ROW, id="toy:2.1V.5a", kind="label")
    text = told(ROW, label, replace(ROW, id="toy:2.1V.6a"), replace(ROW, id="toy:3.1V.6a"))
    headings = [line for line in text.splitlines() if line.startswith("toy:")]
    assert headings == [f"toy:{each}, the paper's own" for each in ("2.1V: sign", "2.1V: label", "3.1V: sign")]
    assert text.count(ROW.reason) == 3


def test_a_different_reason_stands_in_its_row() -> None:
    text = told(ROW, replace(ROW, id="toy:2.1V.6a"), replace(ROW, id="toy:2.1V.7a", reason="stands alone"))
    line = next(line for line in text.splitlines() if "2.1V.7a" in line)
    assert "stands alone" in line


def test_the_head_of_a_ledger_says_why_there_are_more_errata_than_refutations() -> None:
    empty = replace(WRONG, id="toy:2.9", verdict=Verdict.PROVED)
    assert list(headline([WRONG, empty]))[-1] == erring([WRONG, empty])
    assert not any("errat" in line for line in headline([WRONG]))


def test_large_counts_are_parted_by_commas() -> None:
    first, *more = headline([WRONG] * 1200)
    assert first == "1,200 relations: 0 proved, 1,200 refuted, 0 undecided"
    assert any(line.startswith("Refuted: 1,200 ") for line in more)
