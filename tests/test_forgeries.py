"""No forged certificate is accepted, and each is rejected for the reason that is true."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from forgeries import FORGERIES, GROUPS, Forgery, above, by, each, here, hyp, implies, proved, refuted

from symcheck.checker import check, check_all
from symcheck.checker.rules import RULES
from symcheck.checker.theorems import NAMES

pytestmark = pytest.mark.whole
JSON = Any
ROOT = Path(__file__).resolve().parent.parent
VALID: dict[str, JSON] = {
    "a circle": proved(["=", ["+", ["^", ["sin", "x"], 2], ["^", ["cos", "x"], 2]], 1], {"rule": "identity"}),
    "a hypothesis": proved(["=", "x", 0], by(hyp()), [["=", "x", 0]], at={"x": 0}),
    "a denominator": proved(["=", ["/", "x", "x"], 1], {"rule": "identity"}, nonzero=["x"], at={"x": 1}),
    "an implication": proved(["=>", ["=", "x", 0], ["=", "x", 0]], implies(by(here())), at={"x": 0}),
    "an order": proved([">=", ["^", "x", 2], 0], above(["^", "x", 2])),
}


def reason(forgery: Forgery) -> str | None:
    *_, found = check_all([*forgery.others, forgery.certificate])
    return found


@pytest.mark.parametrize("name", FORGERIES)
def test_a_forgery_is_rejected_for_the_reason_that_is_true(name: str) -> None:
    found = reason(FORGERIES[name])
    assert found, "accepted"
    assert FORGERIES[name].reason in found
    assert "malformed" not in found


def test_there_are_enough_forgeries_and_no_two_have_one_name() -> None:
    assert len(FORGERIES) == sum(map(len, GROUPS)) >= 200


def test_every_rule_and_every_theorem_is_forged() -> None:
    steps = [step for forgery in FORGERIES.values() for step in objects(forgery.certificate)]
    assert {step.get("rule") for step in steps} >= RULES.keys()
    assert {step.get("of") for step in steps} >= {*NAMES, "congruence", "enclosure"}


def objects(data: JSON) -> list[dict[str, JSON]]:
    children = data.values() if isinstance(data, dict) else data if isinstance(data, list) else ()
    return [*([data] if isinstance(data, dict) else []), *(step for child in children for step in objects(child))]


@pytest.mark.parametrize("name", VALID)
def test_what_the_forgeries_are_made_of_is_right(name: str) -> None:
    assert check(VALID[name]) is None


@pytest.mark.parametrize("name", VALID)
@pytest.mark.parametrize("key", ["id", "verdict", "claim", "proof"])
def test_no_part_of_a_certificate_can_be_left_out(name: str, key: str) -> None:
    assert check({k: v for k, v in VALID[name].items() if k != key})


@pytest.mark.parametrize("name", VALID)
def test_no_part_of_a_certificate_may_be_a_stand_in(name: str) -> None:
    for key in ("claim", "proof", "verdict", "id"):
        for stand_in in (None, 0, False, True, "", 1.5, [], {}):
            if (key, stand_in) != ("id", ""):
                assert check({**VALID[name], key: stand_in}), (key, stand_in)


REFUTED: dict[str, JSON] = {
    "a letter": refuted(["=", "x", 0], {"x": 1}),
    "two letters": refuted(["=", ["+", "x", "y"], ["*", "x", "y"]], {"x": 1, "y": 1}),
    "an order": refuted([">", "x", ["^", "x", 2]], {"x": 2}, [[">", "x", 0]]),
    "a converse": refuted(["=>", ["=", ["^", "x", 2], 1], ["=", "x", 1]], {"x": -1}),
    "a root": refuted(["=", ["sqrt", ["^", "x", 2]], "x"], {"x": -2}),
    "a conjunction": refuted(["and", ["=", "x", "x"], ["=", "x", 1]], {"x": 0}),
    "an equivalence": refuted(["<=>", ["=", ["*", "x", "y"], 0], ["=", "x", 0]], {"x": 1, "y": 0}),
    "a fraction": refuted(["=", ["/", "x", "y"], ["/", "y", "x"]], {"x": 1, "y": 2}),
    "an angle": refuted(["=", ["sin", ["*", 2, "x"]], ["*", 2, ["sin", "x"]]], {"x": ["/", ["pi"], 2]}),
    "a function": refuted(
        ["=", ["call", "f", [0], 1], ["call", "f", [0], 2]],
        {},
        calls=[[["call", "f", [0], 1], 0], [["call", "f", [0], 2], 1]],
    ),
}


def proofs() -> list[JSON]:
    """Every proof object at hand: those of right certificates, those of the forgeries, and trivial ones."""
    trivial = [{"rule": name} for name in RULES]
    trivial += [{"rule": name, "cofactors": [], "then": {"rule": "compute"}} for name in ("implies", "have", "every")]
    trivial += [implies({"rule": "absurd"}), each(*[{"rule": "identity"}] * 2), each(*[{"rule": "compute"}] * 2)]
    forged = [forgery.certificate for forgery in FORGERIES.values() if isinstance(forgery.certificate, dict)]
    others = [made["proof"] for made in (*VALID.values(), *forged) if "proof" in made]
    return [*trivial, *others, True, None, [], {}]


def relabelled(made: JSON, proof: JSON) -> list[JSON]:
    """The certificate of a refutation called a proof, with this evidence."""
    plain = {key: value for key, value in made.items() if key != "point"}
    point = {"values": made["point"]["values"]}
    return [
        {**plain, "verdict": "proved", "proof": proof},
        {**plain, "verdict": "proved", "proof": proof, "witnesses": [point]},
        {**made, "verdict": "proved", "proof": proof},
    ]


@pytest.mark.parametrize("name", REFUTED)
def test_a_refutation_relabelled_as_proved_is_rejected(name: str) -> None:
    assert check(REFUTED[name]) is None
    for proof in proofs():
        for made in relabelled(REFUTED[name], proof):
            assert check(made), made
    assert check({**REFUTED[name], "verdict": "proved"})


def refutations_of_the_papers() -> list[JSON]:
    found = []
    for path in sorted((ROOT / "generated" / "certificates").glob("*.json")):
        stated = json.loads(path.read_text(encoding="utf-8"))
        if stated["schema"] == 3:
            found += [made for made in stated["certificates"] if made["verdict"] == "refuted"]
    return found


def test_every_refuted_relation_of_the_papers_relabelled_as_proved_is_rejected() -> None:
    every = refutations_of_the_papers()
    if not every:
        pytest.skip("the recorded certificates are of another schema")
    steps = proofs()
    made = [
        each
        for k, one in enumerate(every)
        for j in range(4)
        for each in relabelled(one, steps[(7 * k + j) % len(steps)])
    ]
    assert None not in [*check_all(made)]


@pytest.mark.slow
def test_every_refuted_relation_of_the_papers_with_many_proofs_is_rejected() -> None:
    every = refutations_of_the_papers()
    if not every:
        pytest.skip("the recorded certificates are of another schema")
    for proof in proofs()[::6]:
        assert None not in [*check_all(made for one in every for made in relabelled(one, proof)[:2])]


def test_a_key_that_is_there_twice_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from symcheck.checker import __main__ as program

    written = json.dumps({"schema": 3, "certificates": [VALID["a circle"]]})
    path = tmp_path / "certificates.json"
    for key, value in (("verdict", "refuted"), ("claim", ["=", 0, 0]), ("proof", {"rule": "identity"})):
        twice = written.replace(f'"{key}":', f'"{key}": {json.dumps(value)}, "{key}":')
        path.write_text(twice, encoding="utf-8")
        assert program.main([str(path)]) == 2
        assert "a key occurs twice" in capsys.readouterr().err
