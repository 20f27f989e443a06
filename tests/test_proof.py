"""The proof engine proves what is true, refutes what is false, and its evidence holds for the checker."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import combinations
from typing import Any

import pytest
from saboteurs import unsound
from statements import DISTINCT, DISTINCT_AS_PRINTED, FALSE, ORTHOGONAL, RIGHT, TRUE, J, L, eq, mul, over, sq, sub

from symcheck import kernels
from symcheck.audit.checked import reason
from symcheck.checker import certificates, check
from symcheck.checker.rules import Prover
from symcheck.core.certificates import Certificate
from symcheck.core.problems import Form, Method, Problem, Witness
from symcheck.core.terms import Formula, node
from symcheck.core.verdicts import Verdict
from symcheck.core.words import term
from symcheck.proof import cases, certificate, equivalent, existence, identity, nonnegative
from symcheck.proof.algebra.facts import Assumed, Hypothesis
from symcheck.proof.algebra.forms import positive_form
from symcheck.proof.algebra.groebner import Basis, lcm
from symcheck.proof.algebra.ideal import Ideal
from symcheck.proof.algebra.knowledge import ring_of, starting
from symcheck.proof.algebra.polynomial import Ring, Unsupported, square_free
from symcheck.proof.rules.each import Each
from symcheck.proof.rules.identity import Identity
from symcheck.proof.rules.step import Cofactor
from symcheck.selftest.methods import SABOTEURS

BY_ID = {problem.id: problem for problem in (*TRUE, *FALSE)}
METHODS = (identity, nonnegative(), cases(), existence())


def evidence(problem: Problem, method: Method = identity) -> Certificate:
    plain: Certificate = json.loads(json.dumps(certificate(problem, method.decide(problem))))
    return plain


@pytest.mark.parametrize("problem", TRUE, ids=lambda p: p.id)
def test_a_true_statement_is_proved_and_the_checker_agrees(problem: Problem) -> None:
    found = evidence(problem)
    assert found["verdict"] == "proved"
    assert reason(found) is None


@pytest.mark.parametrize("problem", FALSE, ids=lambda p: p.id)
def test_a_false_statement_is_refuted_and_the_checker_agrees(problem: Problem) -> None:
    found = evidence(problem)
    assert found["verdict"] == "refuted"
    assert reason(found) is None


def test_there_are_enough_bad_statements() -> None:
    assert len(FALSE) >= 15


@pytest.mark.parametrize("method", METHODS, ids=lambda m: m.name)
def test_no_real_method_is_unsound(method: Method) -> None:
    assert unsound(method) == []


@pytest.mark.parametrize("decide", SABOTEURS, ids=lambda f: f.__name__)
def test_a_sabotaged_method_is_caught(decide: object) -> None:
    assert unsound(Method("sabotaged", decide))  # type: ignore[arg-type]


def test_only_the_hypotheses_used_are_listed() -> None:
    assert identity.decide(BY_ID["2.12"]).used == ("orthogonal",)
    assert identity.decide(BY_ID["2.11 without squares"]).used == ("right-handed",)
    assert set(evidence(BY_ID["2.12"])["hypotheses"]) == {"orthogonal"}


class Attentive(Prover):
    """Notes the factors of products whose vanishing a proof assumes and makes no use of."""

    assumed, idle = 0, list[str]()

    splits = False  # whether the step that is being checked splits a product

    def prove(self, goal: Any, proof: Any) -> None:
        self.splits = proof["rule"] == "split"
        super().prove(goal, proof)

    def branch(self, goal: Any, proof: Any, *assumed: Any, **cleared: Any) -> None:
        splits, number = self.splits, ("here", self.depth)
        self.used.discard(number)
        super().branch(goal, proof, *assumed, **cleared)
        self.splits = splits
        Attentive.assumed += splits
        Attentive.idle += [str(assumed)] if splits and number not in self.used else []


@pytest.mark.parametrize("paper", ["mirer2009", "esenkov2006", "poloskov2004"])
def test_every_case_of_a_proof_uses_what_it_assumes(paper: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(certificates, "Prover", Attentive)
    monkeypatch.setattr(Attentive, "assumed", 0)
    monkeypatch.setattr(Attentive, "idle", [])
    text = (kernels.folder() / "certificates" / f"{paper}.json").read_text(encoding="utf-8")
    proofs = [each for each in json.loads(text)["certificates"] if each["verdict"] == "proved"]
    assert {*map(check, proofs)} <= {None, "a lemma is not proved, or under other assumptions"}
    assert Attentive.assumed > 0
    assert Attentive.idle == []


def test_a_proof_does_without_an_assumption_that_it_does_not_refer_to() -> None:
    cofactors = (Cofactor(Assumed(1), ("x",)), Cofactor(Hypothesis("h", 0), ("2",)))
    proof, shorter = (Identity((Assumed(number),), cofactors) for number in (4, 2))
    assert proof.without([2, 3]) == shorter
    assert proof.without([5]) == proof
    assert proof.without([1]) is None
    assert Each((shorter, proof)).without([4]) is None


def test_pairwise_distinct_is_more_than_the_printed_chain() -> None:
    assert len(DISTINCT[1]) == len(DISTINCT_AS_PRINTED[1]) + 1
    point = identity.decide(BY_ID["six cases as printed"]).point
    assert point is not None
    assert point.values["I_1"] == point.values["I_3"]


def test_a_displayed_point_is_small() -> None:
    point = evidence(BY_ID["2.12 with a sign flipped"])["point"]
    assert all(len(term(value)) <= 4 for value in point["values"].values())
    assert len(point["shown"]) == 2


def test_a_point_gives_no_value_to_a_letter_that_is_bound_where_its_definition_is_used() -> None:
    wave = node("*", "c", node("cos", "x"))
    made = evidence(Problem("bound", eq(node("mean", mul("f", "f"), "x"), "a"), (("f", wave),)))
    assert made["point"]["values"].keys() == {"a", "c"}
    assert reason(made) is None


def test_equal_moments_without_principal_axes_are_found_in_roots() -> None:
    point = evidence(BY_ID["left equality for equal moments"])["point"]
    assert any("sqrt" in str(value) for value in point["values"].values())


def test_denominators_become_side_conditions() -> None:
    assert evidence(BY_ID["ratio"])["nonzero"] == ["y", "z"]
    free = Problem("divided", eq(node("/", mul("x", "y"), "y"), "x"))
    assert evidence(free)["nonzero"] == ["y"]
    given = replace(free, hypotheses=(("y", (node("!=", "y", 0),)),))
    assert "nonzero" not in evidence(given)
    assert reason(evidence(given)) is None


def test_a_wrong_form_leaves_a_true_order_undecided() -> None:
    problem = replace(BY_ID["2.10"], hints=(Form(mul("I_1", sq("a_11"))),))
    assert identity.decide(problem).verdict is Verdict.UNDECIDED


UNREADABLE = {
    "a mean without digits": node("=", node("mean", node("exp", node("sin", "x")), "x"), 1),
    "division by zero": node("=", node("/", 1, 0), "x"),
}
REFUTED_BY_DIGITS = {
    "half angle": node("=", node("sin", node("/", "alpha", 2)), 0),
    "function of a half angle": node("=", node("sqrt", node("sin", node("/", "x", 2))), 1),
    "exponential": node("=", node("exp", "x"), "x"),
    "logarithm of a power": node("=", node("log", node("pow", "x", 3)), node("log", "x")),
}


@pytest.mark.parametrize("claim", REFUTED_BY_DIGITS.values(), ids=REFUTED_BY_DIGITS)
def test_a_false_statement_about_functions_is_refuted_by_digits(claim: Formula) -> None:
    made = evidence(Problem("digits", claim))
    assert made["verdict"] == "refuted"
    assert reason(made) is None


@pytest.mark.parametrize("claim", UNREADABLE.values(), ids=UNREADABLE)
def test_a_statement_outside_the_algebra_is_undecided_with_a_reason(claim: tuple[object, ...]) -> None:
    outcome = identity.decide(Problem("outside", claim))
    assert outcome.verdict is Verdict.UNDECIDED
    assert outcome.reason


def test_circular_definitions_are_undecided() -> None:
    outcome = identity.decide(Problem("circle", eq("x", 1), (("x", "y"), ("y", "x"))))
    assert outcome.verdict is Verdict.UNDECIDED
    assert "refers to itself" in outcome.reason


def test_an_undecided_outcome_has_no_certificate() -> None:
    problem = Problem("open", UNREADABLE["a mean without digits"])
    with pytest.raises(ValueError, match="undecided"):
        certificate(problem, identity.decide(problem))


def test_a_variable_that_is_an_angle_and_a_number_has_one_value() -> None:
    for claim in (eq(node("sin", "x"), "x"), eq(node("arctan", "x"), "x")):
        made = evidence(Problem("mixed", claim))
        assert made["point"]["values"] == {"x": 1}
        assert reason(made) is None


def test_equivalent_forms_are_recognised_and_others_are_not() -> None:
    problem = BY_ID["2.12"]
    claim = problem.claim
    assert equivalent(claim, node("=", claim[2], claim[1]), problem)
    assert equivalent(claim, node("=", claim[1], node("*", 1, claim[2])), problem)
    assert not equivalent(claim, node("=", claim[1], node("*", 2, claim[2])), problem)
    assert equivalent(node("<=", "x", "y"), node(">=", mul(2, "y"), mul(2, "x")), problem)
    assert not equivalent(node("<=", "x", "y"), node(">=", mul(2, "x"), mul(2, "y")), problem)
    assert not equivalent(node("<=", "x", "y"), node("<", "x", "y"), problem)


def orthogonal_ideal(*hypotheses: tuple[str, tuple[object, ...]]) -> Ideal:
    problem = Problem("ideal", eq("a_11", 0), (), hypotheses)  # type: ignore[arg-type]
    return starting(problem, ring_of(problem)).ideal()


def test_the_bases_of_orthogonal_matrices_have_the_known_sizes() -> None:
    assert len(orthogonal_ideal(ORTHOGONAL).polys()) == 27
    assert len(orthogonal_ideal(ORTHOGONAL, RIGHT).polys()) == 20


def test_cofactors_lead_back_to_the_given_relations() -> None:
    for problem in (BY_ID["2.12"], BY_ID["2.13"], BY_ID["row 2 from rows 3 and 1"]):
        ring = ring_of(problem)
        known = starting(problem, ring)
        goal = ring.difference(problem.claim)
        cofactors = known.ideal().cofactors(goal)
        assert cofactors is not None
        facts = dict(known.facts)
        assert sum((q * facts[ref] for ref, q in cofactors), ring.number(0)) == goal


def is_basis(basis: Basis) -> bool:
    """Whether all S-polynomials of the basis reduce to zero."""
    for i, j in combinations(basis.active, 2):
        a, b = basis.nodes[i], basis.nodes[j]
        common = lcm(a.lead, b.lead)
        context: Any = a.poly.context()
        left, right = (
            context.from_dict({tuple(c - e for c, e in zip(common, n.lead, strict=True)): 1}) for n in (a, b)
        )
        if basis.reduce(left * a.poly - right * b.poly)[0] != 0:
            return False
    return True


def test_a_groebner_basis_is_one_and_an_extended_ideal_has_the_same_members() -> None:
    ring = Ring(("x", "y", "z"))
    x, y, z = (ring.generator[name] for name in "xyz")
    polys = [x * y - z, y**2 - x, x**2 - y * z]
    assert is_basis(Basis(polys))
    facts = [(Assumed(k), poly) for k, poly in enumerate(polys)]
    whole, grown = Ideal(ring, facts), Ideal(ring, facts[:1]).extended(facts[1:])
    assert {str(p) for p in whole.polys()} == {str(p) for p in grown.polys()}
    member = x**3 - z * y**2 + polys[0] * (x + z)
    for ideal in (whole, grown):
        assert (ideal.cofactors(member) is None) == (ideal.reduce(member) != 0)


def test_a_cut_off_basis_says_so() -> None:
    ring = Ring(("x", "y", "z"))
    x, y, z = (ring.generator[name] for name in "xyz")
    assert not Ideal(
        ring, [(Assumed(k), p) for k, p in enumerate((x**2 * y - z, x * y**2 - z, x * z - y))], pairs=1
    ).complete


def test_a_positive_form_uses_bounds() -> None:
    problem = BY_ID["greatest f_1"]
    known = starting(problem, ring_of(problem))
    poly = known.ring.poly(sub(mul(4, "c"), "J_2"))
    form = positive_form(poly, known)
    assert form is not None
    assert known.sign(form)[0] == 2
    assert positive_form(-poly, known) is None


def test_roots_of_rationals_are_split_into_primes() -> None:
    from fractions import Fraction

    assert square_free(Fraction(12)) == (2, (3,))
    assert square_free(Fraction(1, 6)) == (Fraction(1, 6), (2, 3))
    with pytest.raises(Unsupported):
        square_free(Fraction(-1))


def test_definitions_that_are_not_used_are_not_listed() -> None:
    problem = BY_ID["2.12"]
    assert {name for name, _ in evidence(replace(problem, definitions=J + L))["definitions"]} == {"J_1", "J_3"}


def test_a_witness_divides_by_nothing_that_may_be_zero() -> None:
    claim = node("exists", ("x",), eq(node("+", mul("a", "x"), "b"), 0))
    line = Problem("a zero", claim, hints=(Witness((("x", over(node("-", "b"), "a")),)),))
    assert identity.decide(line).verdict is not Verdict.PROVED
    sloped = replace(line, hypotheses=(("a", (node("!=", "a", 0),)),))
    assert identity.decide(sloped).verdict is Verdict.PROVED
    assert reason(evidence(sloped)) is None
    assert evidence(sloped)["hypotheses"] == {"a": [["!=", "a", 0]]}
