"""What is printed for a quantity that is 1 is proved in general, from definitions and hypotheses in general."""

from __future__ import annotations

import copy
import json

import pytest
from click.testing import CliRunner
from sampling import every

from symcheck import decide, papers
from symcheck.audit.decide import decide as decided
from symcheck.checker import check
from symcheck.cli import cli
from symcheck.core.claims import Assertion
from symcheck.core.verdicts import Verdict
from symcheck.question import general
from symcheck.question.ask import decided_one
from symcheck.reading.measures import scales
from symcheck.views.show import show

ENERGY = {"E": "J", "m": "kg", "p": "kg m/s", "v": "m/s", "g": "1", "c": "m/s = 1"}


def of(letters: str) -> dict[str, str]:
    """The units of some of these letters, and what is 1."""
    return {letter: ENERGY[letter] for letter in (*letters, "c")}


PROVED = {  # relation, definitions and conditions, units, the general form
    "energy": ("E^2 = p^2 + m^2", ["E = g m", "p = g m v", "g^2 (1 - v^2) = 1"], ENERGY, "E^2 = c^2*p^2 + c^4*m^2"),
    "a definition": ("E = m g + m", ["E = m (g + 1)"], of("Emg"), "E = c^2*(m*g) + c^2*m"),
    "an inequality": (
        "E^2 > p^2",
        ["E = g m", "p = g m v", "g^2 (1 - v^2) = 1", "m > 0"],
        ENERGY,
        "E^2 > c^2*p^2",
    ),
    "components": (
        r"\mathbf{E} = \mathbf{p} + \mathbf{q}",
        [r"\mathbf{q} = \mathbf{E} - \mathbf{p}"],
        {r"\mathbf{E}": "J", r"\mathbf{p}": "kg m/s", r"\mathbf{q}": "J", "c": "m/s = 1"},
        "E_1 = c*p_1 + q_1; E_2 = c*p_2 + q_2; E_3 = c*p_3 + q_3",
    ),
}


@pytest.mark.parametrize(("relation", "where", "said", "wanted"), PROVED.values(), ids=PROVED)
def test_the_general_form_is_proved_and_the_checker_accepts_it(
    relation: str, where: list[str], said: dict[str, str], wanted: str
) -> None:
    answer = decide(relation, where=where, units=said)
    assert answer.verdict == "proved"
    assert answer.general is not None
    assert answer.general.relation == wanted
    for certificate in answer.general.certificate:
        assert check(json.loads(json.dumps(certificate))) is None
        assert '"c"' in json.dumps(certificate["claim"])
        forged = copy.deepcopy(json.loads(json.dumps(certificate)))
        forged["claim"][2] = ["*", "c", forged["claim"][2]]
        assert check(forged) is not None
    assert json.loads(json.dumps(answer.as_json()))["general"]["relation"] == wanted


def test_conditions_are_those_of_smaller_quantities() -> None:
    answer = decide("E^2 = p^2 + m^2", where=PROVED["energy"][1], units=ENERGY)
    assert answer.general is not None
    (certificate,) = answer.general.certificate
    assert json.dumps(["/", "v", "c"]) in json.dumps(certificate["hypotheses"])


NONE = {
    "it is false": ("E = 2 m", ["E = m"], of("Em")),
    "nothing is missing": ("E = m v^2", ["E = v^2 m"], of("Emv")),
    "nothing is 1": ("v = p", ["p = v"], {"p": "m/s", "v": "m/s"}),
    "a unit is not known": ("E = m + x y", ["x = (E - m) / y"], {"E": "J", "m": "kg", "c": "m/s = 1"}),
    "the root of it is missing": ("E = m", ["m = E"], {"E": "kg", "m": "kg m^(1/2)", "c": "m = 1"}),
    "it is a letter of its own": ("E = m + c - c", ["m = E"], of("Em")),
}


@pytest.mark.parametrize(("relation", "where", "said"), NONE.values(), ids=NONE)
def test_no_general_form_is_made_up(relation: str, where: list[str], said: dict[str, str]) -> None:
    assert decide(relation, where=where, units=said).general is None


def test_the_commands_tell_it(capsys: pytest.CaptureFixture[str]) -> None:
    given = [part for letter, unit in of("Emg").items() for part in ("--unit", f"{letter}: {unit}")]
    told = CliRunner().invoke(cli, ["decide", "E = m g + m", "--where", "E = m (g + 1)", *given]).output
    assert "in general      proved too, with 1 certificate" in told
    show("ignatov2005:S.9b", records=lambda ids: [each for each in decided("ignatov2005:S.9") if each.id in ids])
    assert "h_max^2*(4*sin(a))^2: proved too" in " ".join(capsys.readouterr().out.split())


ONES = [
    f"{key}:{item.number}"
    for key, paper in papers.load().items()
    if scales(paper.notation)
    for _, _, item in paper.items()
    if isinstance(item, Assertion) and not item.question
]


@pytest.mark.parametrize("id", every(20, ONES))
def test_what_a_paper_prints_for_1_is_proved_in_general_where_it_is_as_printed(id: str) -> None:
    for record in decided(id):
        if record.dimension and record.dimension.general:
            form = general.of_relation(record.id, decided_one)
            assert (form is not None) is (record.verdict is Verdict.PROVED), record.id
