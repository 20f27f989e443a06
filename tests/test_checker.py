"""The checker accepts no certificate in which anything has been changed, and stands alone."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from fractions import Fraction
from math import prod
from pathlib import Path
from typing import Any

import pytest
from statements import FALSE, TRUE

from symcheck import checker, enclosures, residues, theorems
from symcheck.checker import check
from symcheck.proof import certificate, identity
from symcheck.proof.certificate import digest
from symcheck.selftest.certificates import DROPPED, changed, changes
from symcheck.statement import Certificate, Problem

ROOT = Path(__file__).resolve().parent.parent
BY_ID = {problem.id: problem for problem in (*TRUE, *FALSE)}
CORRUPTED = ("2.12", "2.13", "2.10", "row 2 from rows 3 and 1", "f_1 greatest only at c")


def evidence(name: str) -> Certificate:
    problem = BY_ID[name]
    plain: Certificate = json.loads(json.dumps(certificate(problem, identity.decide(problem))))
    return plain


def written(folder: Path, certificates: list[Certificate]) -> Path:
    folder.mkdir(exist_ok=True)
    content = {"schema": 1, "paper": "test", "certificates": certificates}
    (folder / "test.json").write_text(json.dumps(content), encoding="utf-8")
    return folder


def states_the_same(one: Certificate, other: Certificate) -> bool:
    """Changes that only rename: a hypothesis or claim scaled by a number says the same."""
    return (
        one["claim"] == other["claim"] and one["hypotheses"] == other["hypotheses"] and one["proof"] == other["proof"]
    )


@pytest.mark.parametrize("name", CORRUPTED)
def test_every_single_change_of_a_certificate_is_rejected(name: str) -> None:
    original = evidence(name)
    assert check(original) is None
    every = [(f"{kind} {what}", changed(original, path, value)) for kind, what, path, value in changes(original)]
    accepted = [what for what, other in every if not states_the_same(other, original) and check(other) is None]
    assert len(every) > 30
    assert accepted == []


def test_every_single_change_of_a_point_is_rejected() -> None:
    original = evidence("2.12 with a sign flipped")
    for name, value in original["point"]["values"].items():
        assert check(changed(original, ("point", "values", name), value + "1")), name
        assert check(changed(original, ("point", "values", name), DROPPED)), name
    for k in range(2):
        assert check(changed(original, ("point", "sides", k), "1"))


def test_an_irrational_point_is_checked_exactly() -> None:
    original = evidence("left equality for equal moments")
    assert check(original) is None
    path = ("point", "values", "a_11")
    assert check(changed(original, path, ["*", ["/", 1, 3], ["sqrt", 7]]))
    assert check(changed(original, path, "81649658092772603/100000000000000000"))


def rule(proof: dict[str, Any], claim: Any, hypotheses: dict[str, Any] | None = None) -> str | None:
    made: Certificate = {"id": "t", "claim": claim, "definitions": [], "hypotheses": hypotheses or {}}
    return check({**made, "digest": digest(made), "verdict": "proved", "proof": proof})


IDENTITY: dict[str, Any] = {"rule": "identity", "cofactors": []}
X_POSITIVE = {"h": [[">", "x", 0]]}
FORGED: dict[str, tuple[dict[str, Any], Any, dict[str, Any] | None]] = {
    "identity of an order": (IDENTITY, ["<", 0, 0], None),
    "a fact nobody stated": ({"rule": "identity", "cofactors": [[["hyp", "h", 0], "1"]]}, ["=", "x", 0], None),
    "its own claim as a fact": ({"rule": "identity", "cofactors": [[["here", 0], "1"]]}, ["=", "x", 0], None),
    "sign of a free letter": ({"rule": "nonnegative", "form": "x", "cofactors": []}, [">=", "x", 0], None),
    "square said to be positive": (
        {"rule": "nonnegative", "form": ["^", "x", 2], "cofactors": []},
        [">", ["^", "x", 2], 0],
        None,
    ),
    "difference of squares": (
        {"rule": "nonnegative", "form": ["+", ["^", "x", 2], ["-", ["^", "y", 2]]], "cofactors": []},
        [">=", ["+", ["^", "x", 2], ["-", ["^", "y", 2]]], 0],
        None,
    ),
    "a multiplier that may be zero": (
        {"rule": "nonnegative", "form": 0, "multiplier": ["^", "x", 2], "cofactors": []},
        [">=", "x", 0],
        None,
    ),
    "a false axiom": (
        {"rule": "identity", "cofactors": [[["axiom", "sqrt", 4], "1"]]},
        ["=", ["^", "sqrt_4", 2], 4],
        None,
    ),
    "a case left out": (
        {"rule": "implies", "then": {"rule": "cases_or", "or": ["here", 0], "cases": [IDENTITY]}},
        ["=>", ["or", ["=", "x", 0], ["=", "x", 1]], ["=", "x", 0]],
        None,
    ),
    "a factor left out": (
        {
            "rule": "implies",
            "then": {"rule": "split", "factors": [["x", 1]], "cofactors": [[["here", 0], "1"]], "cases": [IDENTITY]},
        },
        ["=>", ["=", ["*", "x", "y"], 0], ["=", "x", 0]],
        None,
    ),
    "power zero": (
        {"rule": "split", "factors": [["x", 0]], "cofactors": [[["hyp", "h", 0], "1"]], "cases": [IDENTITY]},
        ["=", "x", 0],
        {"h": [["=", 1, 0]]},
    ),
    "addends of two signs vanish": (
        {
            "rule": "implies",
            "then": {
                "rule": "vanish",
                "form": ["+", "x", "y"],
                "cofactors": [[["here", 0], "1"]],
                "then": {"rule": "identity", "cofactors": [[["here", 1], "1"]]},
            },
        },
        ["=>", ["=", ["+", "x", "y"], 0], ["=", "x", 0]],
        None,
    ),
    "contradiction from nothing": ({"rule": "absurd", "times": [], "cofactors": []}, ["=", "x", 0], None),
    "contradiction from zero": (
        {"rule": "absurd", "times": [["hyp", "h", 0]], "cofactors": [[["hyp", "h", 0], "1"]]},
        ["=", 0, 1],
        X_POSITIVE,
    ),
    "a part of a conjunction left out": (
        {"rule": "each", "parts": [IDENTITY]},
        ["and", ["=", 0, 0], ["=", 0, 1]],
        None,
    ),
    "one direction only": (
        {"rule": "each", "parts": [{"rule": "implies", "then": IDENTITY}]},
        ["<=>", ["=", 0, 1], ["=", 0, 0]],
        None,
    ),
    "another alternative": ({"rule": "choose", "index": -1, "then": IDENTITY}, ["or", ["=", 0, 1], ["=", 0, 0]], None),
    "another bound variable": (
        {"rule": "witness", "point": {"y": 1}, "then": IDENTITY},
        ["exists", ["x"], ["=", "x", 1]],
        None,
    ),
    "a zero on no circle": (
        {"rule": "theorem", "of": ["quarter_turn", "t", "t"], "premises": [IDENTITY], "then": IDENTITY},
        ["=", 0, 0],
        None,
    ),
    "a denominator that turns": (
        {
            "rule": "theorem",
            "of": ["quarter_turn", ["/", 0, ["cos", "t"]], "t"],
            "premises": [IDENTITY],
            "then": IDENTITY,
            "nonzero": [["cos_t"]],
        },
        ["=", 0, 0],
        None,
    ),
    "an angle that is said to exist and is another": (
        {
            "rule": "theorem",
            "of": ["quarter_turn", ["cos", "t"], "t"],
            "premises": [IDENTITY],
            "then": {"rule": "identity", "cofactors": [[["here", 0], "1"]]},
        },
        ["=", ["cos", "t"], 0],
        None,
    ),
    "a mean that depends on the phase": (
        {
            "rule": "theorem",
            "of": ["mean", ["sin", "t"], "t", ["sin", "t"], 0],
            "premises": [IDENTITY],
            "then": {"rule": "identity", "cofactors": [[["here", 0], "1"]]},
        },
        ["=", ["mean", ["sin", "t"], "t"], ["sin", "t"]],
        None,
    ),
    "a mean that is defined by the phase": (
        {
            "rule": "theorem",
            "of": ["mean", ["sin", "t"], "t", "m", 0],
            "premises": [IDENTITY],
            "then": {"rule": "identity", "cofactors": [[["here", 0], "1"]]},
        },
        ["=", ["mean", ["sin", "t"], "t"], "m"],
        {"m": [["=", "m", ["sin", "t"]]]},
    ),
    "a primitive that is not periodic": (
        {
            "rule": "theorem",
            "of": ["mean", 1, "t", 0, "t"],
            "premises": [IDENTITY],
            "then": {"rule": "identity", "cofactors": [[["here", 0], "1"]]},
        },
        ["=", ["mean", 1, "t"], 0],
        None,
    ),
    "a zero of a step": (
        {
            "rule": "theorem",
            "of": ["intermediate_value", ["/", 1, "x"], "x", -1, 1],
            "premises": [
                {"rule": "nonnegative", "form": 2, "cofactors": []},
                {"rule": "nonnegative", "form": 1, "cofactors": []},
            ],
            "then": {"rule": "absurd", "times": [], "cofactors": [[["here", 2], "x"]]},
            "nonzero": [["x"]],
        },
        ["or"],
        None,
    ),
    "the root of a negative number": (
        {
            "rule": "theorem",
            "of": ["root", -1],
            "premises": [{"rule": "nonnegative", "form": 0, "cofactors": []}],
            "then": IDENTITY,
        },
        ["=", 0, 0],
        None,
    ),
    "what a theorem is said to say of itself": (
        {"rule": "theorem", "of": ["have", ["=", 0, 1]], "premises": [IDENTITY], "then": IDENTITY},
        ["=", 0, 0],
        None,
    ),
    "no side condition": (IDENTITY, ["=", ["/", "x", "x"], 1], None),
    "a side condition about nothing": ({**IDENTITY, "nonzero": [["x"]]}, ["=", "x", "x"], None),
    "a witness divided by what may be zero": (
        {"rule": "witness", "point": {"x": ["/", ["-", "b"], "a"]}, "then": IDENTITY, "nonzero": [["a"]]},
        ["exists", ["x"], ["=", ["+", ["*", "a", "x"], "b"], 0]],
        None,
    ),
    "a form divided by what may be zero": (
        {"rule": "nonnegative", "form": ["/", ["^", "x", 2], 1], "cofactors": [], "positive": ["x"]},
        [">=", ["/", ["^", "x", 3], "x"], 0],
        None,
    ),
    "a derivative taken for a function of values": (
        {
            "rule": "theorem",
            "of": ["congruence", "diff", ["x", "x", 1], [2, "x", 1]],
            "premises": [{"rule": "identity", "cofactors": [[["hyp", "h", 0], "1"]]}, IDENTITY, IDENTITY],
            "then": {"rule": "absurd", "cofactors": [[["here", 0], "1"]]},
        },
        ["=", 0, 1],
        {"h": [["=", "x", 2]]},
    ),
    "infinity taken for a number": (
        {
            "rule": "theorem",
            "of": ["constant", 1, "t", 0, "infinity"],
            "premises": [],
            "then": {"rule": "identity", "cofactors": [[["here", 0], "1"]]},
        },
        ["=", ["integral", 1, "t", 0, "infinity"], "infinity"],
        None,
    ),
    "a constant of mathematics for a witness": (
        {"rule": "witness", "point": {"pi": 3}, "then": IDENTITY},
        ["exists", ["pi"], ["=", "pi", 3]],
        None,
    ),
    "half a power": (
        {"rule": "split", "factors": [["x", 0.5]], "cofactors": [[["hyp", "h", 0], "1"]], "cases": [IDENTITY]},
        ["=", "x", 0],
        {"h": [["=", "x", 0]]},
    ),
    "a power that hides a division": (
        {"rule": "witness", "point": {"x": ["*", ["-", "b"], ["pow", "a", -1]]}, "then": IDENTITY},
        ["exists", ["x"], ["=", ["+", ["*", "a", "x"], "b"], 0]],
        None,
    ),
    "zero taken for a multiple of a denominator": (IDENTITY, ["=", ["/", "x", "x"], 1], {"h": [[">", 0, 0]]}),
    "an unused hypothesis": (IDENTITY, ["=", "x", "x"], X_POSITIVE),
    "an unknown rule": ({"rule": "trust me"}, ["=", 0, 1], None),
    "no proof": ({}, ["=", 0, 0], None),
    "half an angle": (IDENTITY, ["=", ["sin", ["/", "x", 2]], ["sin", ["/", "x", 2]]], None),
}


@pytest.mark.parametrize("what", FORGED)
def test_a_forged_proof_is_rejected(what: str) -> None:
    proof, claim, hypotheses = FORGED[what]
    assert rule(proof, claim, hypotheses)


def test_degrees_that_the_random_point_could_not_tell_apart_are_rejected() -> None:
    power = ["^", ["^", "x", 99], 99]
    assert rule(IDENTITY, ["=", power, power])
    doubled = [[f"x_{k + 1}", ["*", f"x_{k}", f"x_{k}"]] for k in range(70)]
    made: Certificate = {"id": "t", "claim": ["=", "x_70", "x_70"], "definitions": doubled, "hypotheses": {}}
    assert "degree" in (check({**made, "verdict": "proved", "proof": IDENTITY}) or "")


def test_no_number_is_zero_in_every_run() -> None:
    for _ in range(3):
        prime = residues.Chance().prime
        assert prime.bit_length() > 250
        assert prime != checker.chance().prime
        assert rule(IDENTITY, ["=", prime, 0])


def test_the_roots_the_checker_computes_with_are_positive() -> None:
    chance = residues.Chance()
    assert chance.root((9, 4)) * 2 % chance.prime == 3
    assert chance.root((6, 1)) == chance.root((2, 1)) * chance.root((3, 1)) % chance.prime
    assert chance.root((0, 1)) == 0
    assert pow(chance.letter("sqrt_43"), 2, chance.prime) == 43
    for number in ((47, 1), (47 * 47, 1), (-1, 1), (1, 53), None):
        with pytest.raises(residues.Reject):
            chance.root(number)


def test_sines_and_cosines_lie_on_the_circle() -> None:
    chance = residues.Chance()
    assert (chance.letter("sin_x") ** 2 + chance.letter("cos_x") ** 2) % chance.prime == 1


@pytest.mark.parametrize("number", [Fraction(0), Fraction(-3, 7), Fraction(10**20, 3), Fraction(-(2**90), 2**80 + 1)])
def test_a_number_is_found_from_its_residue(number: Fraction) -> None:
    chance = residues.Chance()
    assert chance.rational(number.numerator * chance.inverse(number.denominator)) == number.as_integer_ratio()


@pytest.mark.parametrize(
    "text",
    [
        "",
        "-",
        "x^-1",
        "x^1000",
        "x^y",
        "x^2^2",
        "x/2",
        "2^3",
        "1/0",
        "1/x",
        "1/2/3",
        "x y",
        "(x)",
        "_x",
        "x^½",
        "é",
        "2x",
    ],
)
def test_what_is_no_printed_polynomial_is_rejected(text: str) -> None:
    for rest in ("", " + y", " - 1", "*y"):
        assert rule(
            {"rule": "identity", "cofactors": [[["hyp", "h", 0], text + rest]]}, ["=", 0, 1], {"h": [["=", 1, 0]]}
        )
        with pytest.raises((residues.Reject, ValueError)):
            checker.chance().polynomial(text + rest)


def test_a_printed_polynomial_has_the_value_of_the_term() -> None:
    algebra = checker.Algebra([])
    term = ["+", ["*", ["/", -3, 4], ["^", "x", 2], "y"], ["*", -1, "y"], "x", ["-", ["/", 5, 7]], 2]
    assert algebra.polynomial("-3/4*x^2*y - y + x - 5/7 + 2") == algebra.value(term) % algebra.prime


def test_a_letter_is_free_in_one_certificate_and_defined_in_the_next() -> None:
    free, five, six = [], [["x", 5]], [["x", 6]]

    def holds(definitions: list[Any], claim: Any) -> bool:
        return (
            check(
                {"verdict": "proved", "claim": claim, "definitions": definitions, "hypotheses": {}, "proof": IDENTITY}
            )
            is None
        )

    for _ in range(2):
        assert holds(free, ["=", ["+", "x", "x"], ["*", 2, "x"]])
        assert holds(five, ["=", "x", 5])
        assert holds(six, ["=", ["*", "x", "y"], ["*", 6, "y"]])
        assert not holds(free, ["=", "x", 5])
        assert not holds(six, ["=", "x", 5])
        assert not holds(five, ["=", ["*", "x", "y"], ["*", 6, "y"]])


def test_a_mean_does_not_depend_on_the_phase_through_a_definition() -> None:
    claim = ["=", ["mean", ["sin", "t"], "t"], "m"]
    proof = {
        "rule": "theorem",
        "of": ["mean", ["sin", "t"], "t", "m", 0],
        "premises": [IDENTITY],
        "then": {"rule": "identity", "cofactors": [[["here", 0], "1"]]},
    }
    made: Certificate = {"id": "t", "claim": claim, "definitions": [["m", ["sin", "t"]]], "hypotheses": {}}
    assert "the letter t is taken" in (check({**made, "verdict": "proved", "proof": proof}) or "")


@pytest.mark.parametrize("name", ["pi", "infinity", "sin_x", "sqrt_2"])
def test_what_has_a_meaning_of_its_own_is_not_defined(name: str) -> None:
    made: Certificate = {"id": "t", "claim": ["=", name, 5], "definitions": [[name, 5]], "hypotheses": {}}
    assert check({**made, "verdict": "proved", "proof": IDENTITY})


def test_facts_of_one_case_are_forgotten_in_the_next() -> None:
    claim = ["=>", ["or", ["=", "x", 0], ["=", "y", 0]], ["=", "x", 0]]
    uses = {"rule": "identity", "cofactors": [[["here", 1], "1"]]}
    assert rule({"rule": "implies", "then": {"rule": "cases_or", "or": ["here", 0], "cases": [uses, uses]}}, claim)


def test_the_checker_imports_the_standard_library_only() -> None:
    source = Path(checker.__file__).read_text(encoding="utf-8")
    source += "".join(Path(part.__file__).read_text(encoding="utf-8") for part in (enclosures, theorems, residues))
    imported = set(re.findall(r"^(?:from|import) ([\w.]+)", source, re.MULTILINE))
    own = {"symcheck.proof.enclosures", "symcheck.export.coq.residues", "symcheck.proof.theorems", "collections.abc"}
    assert imported - own <= set(sys.stdlib_module_names)


def test_the_checker_can_be_read_in_one_sitting() -> None:
    assert len(Path(checker.__file__).read_text(encoding="utf-8").splitlines()) <= 500


BLOCKED = """
import os, runpy, sys
class Block:
    def find_spec(self, name, path=None, target=None):
        if name.split('.')[0] in ('sympy', 'numpy', 'flint', 'mpmath', 'lark'):
            raise ImportError(name + ' is blocked')
sys.meta_path.insert(0, Block())
sys.path.insert(0, ROOT)
sys.argv = ['checker.py', sys.argv[2]]
def end(code):
    loaded = {name for name in sys.modules if name.startswith('symcheck')}
    assert loaded == {'symcheck', 'symcheck.proof.enclosures', 'symcheck.export.coq.residues', 'symcheck.proof.theorems'}, loaded
    sys.exit(code)
os._exit = end
runpy.run_module('symcheck.checker', run_name='__main__')
raise AssertionError('the checker has not ended the process')
"""


def test_the_checker_runs_where_nothing_else_can_be_imported(tmp_path: Path) -> None:
    folder = written(tmp_path / "certificates", [evidence("2.12"), evidence("2.12 with a sign flipped")])
    program = BLOCKED.replace("ROOT", repr(str(ROOT)))
    command = [sys.executable, "-I", "-S", "-c", program, "-", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    assert (done.returncode, done.stdout.strip()) == (0, "2 certificates, all hold"), done.stderr


def test_a_failure_is_named_and_the_exit_code_is_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bad = changed(evidence("2.12"), ("proof", "cofactors", 0, 1), "7")
    assert checker.main([str(written(tmp_path / "c", [evidence("2.13"), bad]))]) == 1
    out = capsys.readouterr().out
    assert "2.12" in out
    assert "1 do not hold" in out


DAMAGED = {
    "half a file": '{"schema": 1, "certificates": [',
    "another schema": '{"schema": 2, "certificates": []}',
    "no object": "[]",
    "no list": '{"schema": 1, "certificates": 5}',
    "no id": '{"schema": 1, "certificates": [{}]}',
    "a number": '{"schema": 1, "certificates": [7]}',
    "not text": "\udcff",
}


@pytest.mark.parametrize("content", DAMAGED.values(), ids=DAMAGED)
def test_a_damaged_file_is_told_in_one_line(content: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.json").write_bytes(content.encode("utf-8", "surrogateescape"))
    assert checker.main([str(tmp_path)]) == 2
    captured = capsys.readouterr()
    assert captured.err.startswith("checker: ")
    assert captured.err.count("\n") == 1


def test_missing_folders_are_told_in_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert checker.main([]) == 2
    assert checker.main([str(tmp_path / "nowhere")]) == 2
    assert capsys.readouterr().err.count("\n") == 2


MALFORMED: dict[str, Any] = {
    "claim is a number": 7,
    "claim is empty": [],
    "claim is a word": "x",
    "no right side": ["=", "x"],
    "unknown sign": ["~", "x", "y"],
    "a number that is none": ["=", 1.5, "x"],
    "a name that is none": ["=", "x y", "x y"],
    "an exponent that is no whole number": ["=", ["^", "x", 2.0], ["^", "x", 2.0]],
    "three sides": ["=", "x", "x", "x"],
    "deep": ["=", *[json.loads("[" * 900 + "1" + "]" * 900)] * 2],
}


@pytest.mark.parametrize("claim", MALFORMED.values(), ids=MALFORMED)
def test_a_malformed_claim_is_rejected_without_an_exception(claim: Any) -> None:
    assert rule(IDENTITY, claim)


@pytest.mark.parametrize("problem", [BY_ID["2.12"], BY_ID["tangent"]], ids=lambda p: p.id)
def test_the_prover_and_the_checker_expand_terms_alike(problem: Problem) -> None:
    from symcheck.proof.knowledge import ring_of

    ring = ring_of(problem)
    algebra = checker.Algebra(json.loads(json.dumps(problem.definitions)))
    for side in problem.claim[1:]:
        value, ratio = algebra.value(json.loads(json.dumps(side))), ring.ratio(side)
        den = prod(algebra.polynomial(text) ** exponent for text, (_, exponent) in ratio.den.items())
        assert (value * den - algebra.polynomial(str(ratio.num))) % algebra.prime == 0
