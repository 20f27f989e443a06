"""Statements and proofs for Coq: they say what is printed, and Coq confirms what is right and nothing else."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest
import stand_in

from symcheck import kernels
from symcheck.audit.decide import decide
from symcheck.checker.theorems import NAMES
from symcheck.coq import compile as compiler
from symcheck.coq.claims import Claim
from symcheck.coq.comparison import Point, differences
from symcheck.coq.confirmed import record_all, recorded
from symcheck.coq.files import OURS, files
from symcheck.coq.printing import printed
from symcheck.coq.reader import CLAIM, claims, formula
from symcheck.coq.script import script
from symcheck.coq.statements import statement as stated
from symcheck.coq.terms import NotExported, polynomial
from symcheck.coq.theorems import CONGRUENCE, UNSTATED, identifier, statement
from symcheck.coq.values import QUARTER, turns
from symcheck.coq.witnesses import HEAD, NONE, angles_only, circle, near, witnesses
from symcheck.core.problems import Problem
from symcheck.core.terms import Reader as Terms
from symcheck.core.terms import Term, node
from symcheck.proof import certificate as certificate_of
from symcheck.proof import combined

DECLARED = (
    "mirer2009:2.12", "mirer2009:2.13", "mirer2009:2.1", "mirer2009:2.1.7", "mirer2009:2.13.4", "mirer2009:2.0.5",
    "mirer2009:2.0.6", "mirer2009:2.3.5", "mirer2009:2.8", "mirer2009:B.4", "poloskov2004:3.2.4", "poloskov2004:3.2.3",
    "poloskov2004:B.4", "esenkov2006:N.11", "esenkov2006:1.35", "ignatov2005:2.1V.1", "ignatov2005:T1.5",
    "ignatov2005:2.1.34", "ignatov2005:2.3.8", "ignatov2005:3.2.31", "esenkov2006:B.6", "mirer2009:B.11",
)  # fmt: skip
COQ = pytest.mark.skipif(compiler.missing() is not None, reason=str(compiler.missing()))
FORMULAS = {
    r"- (a - b) ^ 2 * c / 3 <= / a ^ 2": [
        "<=",
        ["/", ["*", ["-", ["^", ["+", "a", ["-", "b"]], 2]], "c"], 3],
        ["^", "a", -2],
    ],
    r"(a = 0 \/ b <> 0) /\ c > 1 -> x <= y <-> sin x >= cos (2 * y)": [
        "=>",
        ["and", ["or", ["=", "a", 0], ["!=", "b", 0]], [">", "c", 1]],
        ["<=>", ["<=", "x", "y"], [">=", ["sin", "x"], ["cos", ["*", 2, "y"]]]],
    ],
    "exists R' x : R, R' * x = 1": ["exists", ["R", "x"], ["=", ["*", "R", "x"], 1]],
    "a - (b + c) = a + b * - 3": ["=", ["+", "a", ["-", ["+", "b", "c"]]], ["+", "a", ["*", "b", -3]]],
}


@pytest.fixture(scope="module")
def exported() -> dict[str, str]:
    """The files of some declarations of all papers."""
    return dict(files([record for id in DECLARED for record in decide(id)]))


@pytest.fixture(scope="module")
def folder(exported: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same, written."""
    root = tmp_path_factory.mktemp("coq")
    for name, text in exported.items():
        (root / name).parent.mkdir(exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    return root


def names_of(exported: dict[str, str], paper: str) -> dict[str, list[str]]:

    return {id: row["claims"] for id, row in json.loads(exported["manifest.json"])[paper]["claims"].items()}


@pytest.mark.parametrize("text", FORMULAS)
def test_formulas_have_as_few_brackets_as_coq_needs(text: str) -> None:
    assert printed(Terms().formula(FORMULAS[text])) == text


@pytest.mark.parametrize("text", FORMULAS)
def test_what_is_written_is_read_back_as_it_was(text: str) -> None:
    def plain(node: object) -> object:
        return tuple(map(plain, node)) if isinstance(node, (list, tuple)) else node

    def binary(node: object) -> object:
        """Sums and products of two, as the parser builds them; negative numbers and powers as Coq writes them."""
        match node:
            case int() if node < 0:
                return ("-", -node)
            case ["+" | "*" as sign, first, *rest]:
                total = binary(first)
                for part in rest:
                    total = (sign, total, binary(part))
                return total
            case ["^", base, int(n)]:
                return ("^", binary(base), n) if n > 0 else ("/", 1, ("^", binary(base), -n))
            case ["exists", bound, body]:
                return ("exists", tuple(bound), binary(body))
            case list():
                return (node[0], *map(binary, node[1:]))
        return node

    assert plain(formula(text)) == binary(FORMULAS[text])


def test_a_polynomial_loses_no_coefficient() -> None:
    found = Terms().term(["+", ["*", 3, ["^", "a", 2], "b"], ["-", ["*", 4, "c"]], 8])
    assert polynomial("3/4*a^2*b - c + 2", {}) == (found, 4)


def test_every_statement_is_the_printed_one(exported: dict[str, str]) -> None:
    for paper in ("mirer2009", "poloskov2004", "esenkov2006", "ignatov2005"):
        assert claims(exported[f"{paper}/Claims.v"])
        assert list(differences(exported[f"{paper}/Claims.v"], names_of(exported, paper))) == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("J_1 * J_3 = (", "J_1 * J_2 = ("),
        ("a_23 ^ 2", "a_23 ^ 3"),
        (" + I_2 * I_3", " - I_2 * I_3"),
        ("= 1 ->", "= 2 ->"),
    ],
)
def test_the_second_reader_sees_a_slip_in_a_statement(exported: dict[str, str], old: str, new: str) -> None:
    text, names = exported["mirer2009/Claims.v"], {"mirer2009:2.12": ["2_12"]}
    own = next(found[0] for found in CLAIM.finditer(text) if found[1] == "2_12")
    assert old in own
    assert list(differences(own, names)) == []
    assert list(differences(own.replace(old, new), names))


def test_nothing_is_admitted(exported: dict[str, str]) -> None:
    for text in exported.values():
        assert not re.search(r"\b(Admitted|admit|Axiom|Parameter|Conjecture|Abort)\b", text)


def test_every_theorem_of_the_checker_is_proved_as_it_stands_there_or_has_a_reason_why_not(
    exported: dict[str, str],
) -> None:
    proved = re.findall(r"^Theorem (\w+) :\n(.*?)\.\nProof\.", exported["Theorems.v"], re.DOTALL | re.MULTILINE)
    stated = {identifier(name): statement(name) for name in (*NAMES, *CONGRUENCE) if name not in UNSTATED}
    assert dict(proved) == stated
    assert len(proved) == len(stated) > 60
    assert UNSTATED.keys() <= {*NAMES, "enclosure"}
    assert all(UNSTATED.values())


@pytest.mark.parametrize(
    ("name", "stated"),
    [
        ("root_of_product", "forall (s t : R), s >= 0 -> t >= 0 -> sqrt (s * t) = sqrt s * sqrt t"),
        ("power_of_power", "forall (b : R) (n : Z) (u : R), b > 0 -> "
         "Rpower (powerRZ b n) u = Rpower b (IZR n * u) /\\ Rpower 1 u = 1"),
        ("mean", "forall (f : R -> R) (c : R) (g : R -> R), polynomial_in_circle g -> "
         "(forall x : R, f x = c + Derive (fun x => g x) x) -> RInt (fun x => f x) 0 (2 * PI) / (2 * PI) = c"),
        ("arccosine < back", "forall (a t : R), t ^ 2 <= 1 -> 0 <= a -> a <= PI -> t < cos a -> a < acos t"),
        ("telescoping_product", "forall (f g : R -> R) (s t : R), whole s -> whole t -> s - 1 <= t -> g (s - 1) = 1 -> "
         "(forall x : R, x >= s - 1 -> g (x + 1) = g x * f (x + 1)) -> product_between (fun x => f x) s t = g t"),
        ("shifted", "forall (f g : R -> R) (a : R), (forall x : R, f x = g (x + a)) -> "
         "integral_over_line (fun x => f x) = integral_over_line (fun x => g x) /\\ "
         "diverges_over_line (fun x => f x) = diverges_over_line (fun x => g x)"),
        ("gaussian_wave", "forall (f g : R -> R) (a b c u v : R), polynomial_in_waves g -> a > 0 -> "
         "(forall x : R, f x = Derive (fun x => exp (b * x - a * x ^ 2) * g x) x"
         " + c * exp (b * x - a * x ^ 2) * cos (u * x + v)) -> integral_over_line (fun x => f x) ="
         " c * exp ((b ^ 2 - u ^ 2) / (4 * a)) * cos (b * u / (2 * a) + v) * sqrt (PI / a) /\\ "
         "diverges_over_line (fun x => f x) = 0"),
        ("congruence of two", "forall (f : R -> R -> R) (s t u v : R), s = t -> u = v -> f s u = f t v"),
    ],
)  # fmt: skip
def test_a_theorem_is_stated_with_all_its_premises(name: str, stated: str) -> None:
    assert " ".join(statement(name).split()) == stated


def call(function: str, *arguments: Term, orders: tuple[int, ...] = ()) -> Any:
    return node("call", function, orders or (0,) * len(arguments), *arguments)


SECOND = call("g", "x", call("f", "y"))
UNKNOWN = Problem(
    "toy:1",
    node("=>", node(">", call("f", "y"), 2), node(">", node("+", call("f", node("+", "x", "x")), SECOND), SECOND)),
    (("z", node("*", 2, "x")),),
    (("given", (node(">", call("f", "z"), 0),)),),
)


def certified(problem: Problem) -> dict[str, Any]:
    outcome = combined().decide(problem)
    assert outcome is not None
    return certificate_of(problem, outcome)


def test_unknown_functions_are_any_functions() -> None:
    text = stated(certified(UNKNOWN)).text()
    assert " ".join(text.split()) == (
        "forall (f : R -> R) (g : R -> R -> R) (y x z : R), z = 2 * x -> (* given *) f z > 0 -> "
        "f y > 2 -> f (x + x) + g x (f y) > g x (f y)"
    )
    names, premises, (sign, great, less) = claims(f"Definition claim_1 : Prop :=\n{text}.\n")["1"]
    assert names == ["f", "g", "y", "x", "z"]
    assert [premise[0] for premise in premises] == ["=", ">", ">"]
    assert (sign, great) == (">", ("+", call("f", ("+", "x", "x")), less))
    assert less == call("g", "x", call("f", "y"))


def test_an_unknown_function_has_one_value_for_equal_arguments_and_others_for_others() -> None:
    point = Point({"z": node("*", 2, "x")})
    one, *others = (
        point.value(each)
        for each in (
            call("f", node("+", "x", "x")),
            call("f", "z"),
            call("f", "x"),
            call("g", "z"),
            call("f", "z", "z"),
        )
    )
    assert [abs(one - other) < 1e-12 for other in others] == [True, False, False, False]


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        (("=", call("f", "x", orders=(1,)), call("f", "x", orders=(1,))), "a derivative of an unknown function"),
        (("=", call("x", "x"), call("x", "x")), "the name of a letter"),
        (("=", ("+", call("f", "x"), call("f", "x", "x")), ("+", call("f", "x", "x"), call("f", "x"))), "two numbers"),
    ],
    ids=["derivative", "name of a letter", "two numbers of arguments"],
)
def test_what_is_not_stated_of_unknown_functions_has_a_reason(claim: Any, reason: str) -> None:
    certificate = {"definitions": [], "hypotheses": {}, "claim": json.loads(json.dumps(claim)), "proof": {}}
    with pytest.raises(NotExported, match=reason):
        stated(certificate).text()


def test_every_set_of_hypotheses_has_a_point_that_satisfies_it(exported: dict[str, str]) -> None:
    for paper, entry in json.loads(exported["manifest.json"]).items():
        assert entry["no witness"] == {}, paper


@pytest.mark.parametrize(
    ("angle", "sine", "cosine"),
    [
        (["*", 2, ["arctan", ["/", -1, 3]]], ["/", -3, 5], ["/", 4, 5]),
        (["*", 2, ["arctan", ["/", ["sqrt", 3], ["+", 1, 2]]]], ["sqrt", 3], 2),
        (["pi"], 0, -1),
    ],
    ids=["rational", "with a root, as written", "pi"],
)
def test_an_angle_at_a_point_has_a_sine_and_a_cosine(angle: Any, sine: Any, cosine: Any) -> None:
    read = Terms().term
    assert circle(read(angle)) == (read(sine), read(cosine))


def test_an_angle_in_radians_is_replaced_by_one_close_by_with_fractions() -> None:
    close = near(1)
    assert close is not None
    assert circle(close) == (node("/", 132, 157), node("/", 85, 157))
    assert near("a") is None
    assert near(node("sqrt", 2)) is None
    for given, angles in (([[">", ["sin", "a"], 0]], {"a"}), ([[">", ["sin", "a"], 0], ["<", "a", 3]], set())):
        claim = {"definitions": [], "hypotheses": {"given": given}, "claim": ["=", "a", "a"], "proof": {}}
        assert angles_only(stated(claim)) == angles


def test_quarter_turns_of_an_angle_are_counted() -> None:
    pi = node("pi")
    for angle, parts in (
        (node("+", pi, node("-", "a")), {"a": -1, QUARTER: 2}),
        (node("+", node("*", 2, "a"), node("/", pi, 2)), {"a": 2, QUARTER: 1}),
    ):
        whole, rest = turns(angle)
        assert dict(whole) == parts
        assert rest == 0
    assert turns(node("*", 5, pi)) == ([], node("*", 5, pi))


@pytest.mark.parametrize(
    ("values", "reason"),
    [({"x": 1, "y": 2}, None), ({"x": 1}, NONE), ({"x": 1, "y": ["*", 2, "z"]}, NONE), (None, NONE)],
    ids=["all letters", "one letter less", "by another letter", "no point"],
)
def test_a_point_is_taken_from_the_certificate_if_it_tells_all_letters(
    values: dict[str, Any] | None, reason: str | None
) -> None:
    certificate: dict[str, Any] = {
        "definitions": [], "hypotheses": {"given": [["<", "x", "y"]]}, "claim": ["<", ["*", 2, "x"], ["*", 2, "y"]],
        "proof": {}, "witnesses": [{"values": values}] if values else [],
    }  # fmt: skip
    each = Claim("1", stand_in.decide("toy:1.1")[0], certificate, "", False, stated(certificate))
    text, missing = witnesses([each])
    assert missing == ({"1": reason} if reason else {})
    assert ("exists 1.\nexists 2.\n" in text) == (reason is None)


@pytest.mark.parametrize(
    ("after", "reason", "code", "left"),
    [
        ("--record", "", 0, ("new", "")),
        ("--record", "slow", 0, ("new", "slow")),
        ("--check", "", 0, ("old", "")),
        ("--check", "slow", 1, ("old", "")),
        (None, "slow", 0, ("old", "")),
    ],
)
def test_outcomes_are_recorded_or_compared(
    after: str | None,
    reason: str,
    code: int,
    left: tuple[str, str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(compiler, "missing", lambda: None)
    monkeypatch.setattr(compiler, "confirm", lambda *_: ({"toy:1": ("new", reason)}, []))
    monkeypatch.setattr(kernels, "folder", lambda: tmp_path)
    (tmp_path / "manifest.json").write_text("{}")
    record_all(tmp_path, {"toy:1": ("old", "")})
    assert compiler.main([str(tmp_path), *filter(None, (after,))]) == code
    assert recorded(tmp_path, "toy") == {"toy:1": left}
    told = capsys.readouterr().out
    assert ("toy:1 is recorded as confirmed by Coq, and is not: slow" in told) == bool(code)
    assert ("1 outcomes are not as recorded" in told) == (after == "--check")


@pytest.fixture(scope="module")
def library(exported: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What all theorems rest on, compiled."""
    root = tmp_path_factory.mktemp("library")
    (root / "Symcheck.v").write_text(exported["Symcheck.v"], encoding="utf-8")
    assert compiler.coqc(root, "Symcheck.v")[0] == 0
    return root


@pytest.mark.slow
@COQ
@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("telescoping_product", "  whole t ->\n", ""),
        ("telescoping_product", "g (s - 1) = 1", "g s = 1"),
        ("telescope", "  s - 1 <= t ->\n", ""),
        ("sum_of_sums", "x >= s ->", "x > s ->"),
        ("full_turn", "2 * PI * u / r", "PI * u / r"),
        ("full_turn", "  r >= 0 ->\n", ""),
        ("shifted", "f x = g (x + a)", "f x = g (a * x)"),
    ],
)
def test_a_theorem_with_another_statement_does_not_compile(
    name: str, old: str, new: str, exported: dict[str, str], library: Path
) -> None:
    before, start, rest = exported["Theorems.v"].partition(f"Theorem {identifier(name)} :")
    said, proof, _ = re.split(r"(?=Proof\.)|(?<=Qed\.)", rest, maxsplit=2)
    assert old in said
    for own, code in ((said, 0), (said.replace(old, new), 1)):
        (library / "Changed.v").write_text(before + start + own + proof, encoding="utf-8")
        assert compiler.coqc(library, "Changed.v")[0] == code


def test_what_is_not_installed_is_said(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert compiler.main(["build/coq"]) == 2
    assert "apt-get install coq" in capsys.readouterr().err


def test_a_theorem_is_left_out_with_what_rests_on_it() -> None:
    text = (
        "Theorem proof_a : claim_a.\nProof.\nring.\nQed.\n\n"
        "Theorem proof_b : claim_b.\nProof.\nexact proof_a.\nQed.\n\n"
        "Theorem proof_c : claim_c.\nProof.\nring.\nQed.\n\n"
        "Lemma everything : True.\nProof.\npose proof proof_a.\npose proof proof_b.\npose proof proof_c.\n"
        "exact I.\nQed.\n"
    )
    rest, names = compiler.without(text, 3)
    assert names == ["a", "b"]
    assert "proof_a" not in rest
    assert "proof_b" not in rest
    assert rest.count("proof_c") == 2


def test_a_file_without_a_claim_to_leave_out_is_not_tried_for_ever() -> None:
    with pytest.raises(ValueError, match="does not prove a claim"):
        compiler.without("Lemma zero {a : R} : a = 0.\nProof. ring. Qed.\n", 2)


@pytest.mark.slow
@COQ
def test_coq_confirms_them_on_the_reals_alone(folder: Path) -> None:
    outcomes, failed = compiler.confirm(folder)
    assert failed == []
    assert len(outcomes) >= len(DECLARED)
    assert [(id, reason) for id, (_, reason) in outcomes.items() if reason] == []


@COQ
def test_coq_confirms_a_claim_about_unknown_functions(tmp_path: Path) -> None:
    found = certified(UNKNOWN)
    own = stated(found)
    proof = f"Theorem proof_1 :\n{own.text()}.\nProof.\n{script(own, found).text}\nQed.\n"
    (tmp_path / "Symcheck.v").write_text(Path(compiler.__file__).with_name("Symcheck.v").read_text("utf-8"), "utf-8")
    assert compiler.coqc(tmp_path, "Symcheck.v")[0] == 0
    for text, code in ((proof, 0), (proof.replace("f z > 0", "f z >= 0"), 1)):
        (tmp_path / "Proof.v").write_text(HEAD + text, encoding="utf-8")
        assert compiler.coqc(tmp_path, "Proof.v")[0] == code


def flipped(statement: str) -> str | None:
    """The statement with one sign of its conclusion flipped, or an inequality turned round."""
    head, arrow, conclusion = statement.rpartition("->\n")
    for old, new in ((" + ", " - "), (" - ", " + "), (" <= ", " > "), (" >= ", " < "), (" = ", " <> ")):
        if old in conclusion:
            return head + arrow + conclusion.replace(old, new, 1)
    return None


@pytest.mark.slow
@COQ
def test_a_flipped_sign_does_not_compile(folder: Path, exported: dict[str, str]) -> None:
    claims_file = folder / "mirer2009/Claims.v"
    kept = claims_file.read_text(encoding="utf-8")
    names = [name for own in names_of(exported, "mirer2009").values() for name in own][:14]
    changed = CLAIM.sub(lambda m: flipped(m[0]) or m[0] if m[1] in names else m[0], kept)
    wrong = [name for name in names if claims(changed)[name] != claims(kept)[name]]
    assert len(wrong) >= 10
    failed: dict[str, str] = {}
    for file in OURS:
        assert list(compiler.checked(folder, file, failed))
    claims_file.write_text(changed, encoding="utf-8")
    assert list(compiler.checked(folder, "mirer2009/Claims.v", failed))
    assert failed == {}
    for file in sorted((folder / "mirer2009").glob("Proofs*.v")):
        assert list(compiler.checked(folder, f"mirer2009/{file.name}", failed))
    assert set(wrong) <= failed.keys()
