"""Whatever a method is asked, it answers; and what it says it has proved or refuted, the checker accepts."""

from __future__ import annotations

import ast
import json
import random
from pathlib import Path

import pytest

from symcheck.audit.checked import reason as check
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Formula, Term, node
from symcheck.core.verdicts import Verdict
from symcheck.proof import certificate, identity, proof_of

PROOF = Path(__file__).parents[1] / "symcheck" / "proof"
SIGNS = ("=", "=", "=", "!=", "<", "<=", ">", ">=")


def polynomial(rng: random.Random, depth: int) -> Term:
    if depth == 0 or rng.random() < 0.35:
        return rng.choice(("x", "y", "u", 0, 1, 2, -1))
    kind = rng.choice("+*-^")
    if kind in "-^":
        return node(kind, polynomial(rng, depth - 1), *((rng.choice((2, 3)),) if kind == "^" else ()))
    return node(kind, polynomial(rng, depth - 1), polynomial(rng, depth - 1))


def statement(rng: random.Random, depth: int) -> Formula:
    if depth == 0 or rng.random() < 0.3:
        return node(rng.choice(SIGNS), polynomial(rng, 2), polynomial(rng, 2))
    kind = rng.choice(("and", "or", "or", "=>", "<=>"))
    return node(kind, *(statement(rng, depth - 1) for _ in range(rng.choice((2, 3)) if kind in ("and", "or") else 2)))


def logical(seed: int) -> Problem:
    rng = random.Random(seed)
    definitions = (("u", rng.choice((node("+", "x", "z"), node("*", "z", "z"), "z", 0, node("^", "y", 2)))),)
    hypotheses = tuple((f"h{n}", (statement(rng, 1),)) for n in range(rng.choice((0, 1, 2))))
    return Problem(f"logical {seed}", statement(rng, 2), definitions, hypotheses)


def answered(problem: Problem) -> tuple[Verdict, str | None]:
    """What a method says, and why the checker does not accept it, if so: then the ledger says undecided."""
    outcome = identity.decide(problem)
    if outcome.verdict is Verdict.UNDECIDED:
        assert outcome.reason
        return outcome.verdict, None
    return outcome.verdict, check(json.loads(json.dumps(certificate(problem, outcome))))


def accepted(problem: Problem) -> Verdict:
    verdict, refusal = answered(problem)
    assert refusal is None, problem
    return verdict


def logic(seeds: range) -> None:
    verdicts = [accepted(logical(seed)) for seed in seeds]
    assert {*verdicts} == {*Verdict}


def test_the_checker_accepts_what_a_method_says_of_connectives() -> None:
    logic(range(80))


@pytest.mark.slow
def test_the_checker_accepts_what_a_method_says_of_many_connectives() -> None:
    logic(range(80, 1000))


KINDS = (
    *("+", "*", "-", "/", "/", "^", "^^", "pow", "sqrt", "sqrt", "sin", "cos", "tan"),
    *("exp", "log", "gamma", "arctan", "arcsin", "diff", "call", "integral", "mean"),
)


def function(rng: random.Random, depth: int) -> Term:
    if depth == 0 or rng.random() < 0.2:
        return rng.choice(("x", "y", "a", "Sqrt_1", PI, "turn", 0, 1, 2, -1, 3, 10**12))
    kind = rng.choice(KINDS)
    inner = function(rng, depth - 1)
    match kind:
        case "sin" | "cos" | "tan":
            return node(kind, rng.choice(("x", "a", node("*", 2, "x"), node("+", "x", "a"), node("/", "x", 2), inner)))
        case "^" | "^^":
            return node("^", inner, rng.choice((2, 3, -1, -2, 0) if kind == "^" else (50, 999, 10**9, -(10**9))))
        case "pow":
            exponents = (node("/", 1, 2), node("/", 1, 3), -1, 2, node("/", 1, 0), function(rng, depth - 1))
            return node(kind, inner, rng.choice(exponents))
        case "diff":
            x = rng.choice(("x", "a"))
            return node(kind, inner, x, rng.choice((1, 2, 9)), rng.choice((x, x, 1)))
        case "call":
            return node(kind, rng.choice("fg"), (rng.choice((0, 1)),), inner)
        case "integral":
            ends: tuple[tuple[Term, Term], ...] = ((0, 1), (0, INFINITY), (MINUS_INFINITY, INFINITY), ("a", 2))
            return node(kind, inner, "x", *rng.choice(ends))
        case "mean":
            return node(kind, inner, "x")
        case "+" | "*" | "/":
            return node(kind, inner, function(rng, depth - 1))
    return node(kind, inner)


def relation(rng: random.Random) -> Formula:
    left = function(rng, 3)
    return node(rng.choice(SIGNS), left, left if rng.random() < 0.3 else function(rng, 2))


def transcendental(seed: int) -> Problem:
    rng = random.Random(seed)
    hypotheses = (("h", (relation(rng),)),) if rng.random() < 0.3 else ()
    kind = rng.choice(("", "", "and", "or", "=>", "exists"))
    claim = relation(rng)
    if kind:
        claim = node("exists", ("x",), claim) if kind == "exists" else node(kind, claim, relation(rng))
    return Problem(f"transcendental {seed}", claim, (), hypotheses)


def test_a_method_has_an_answer_to_any_functions() -> None:
    for seed in range(50):
        accepted(transcendental(seed))


@pytest.mark.slow
def test_a_method_has_an_answer_to_many_functions() -> None:
    answers = [answered(transcendental(seed)) for seed in range(50, 1500)]
    decided = [refusal for verdict, refusal in answers if verdict is not Verdict.UNDECIDED]
    refused = [refusal for refusal in decided if refusal]  # as means of constants under roots: searched, not computed
    assert len(decided) > 150
    assert len(refused) < 0.1 * len(decided), refused


ENDLESS: dict[str, Formula] = {
    "a long power of a number": node("=", node("^", 2, 10**9), 1),
    "a long power of a long number": node("=", node("^", 10**40, 999), "x"),
    "a long power of a sum": node("=", node("^", node("+", "x", "y", "z"), 998), 1),
    "a long power of a cosine": node("=", node("^", node("cos", node("*", 2, "x")), 999), node("/", 1, 3)),
    "a large multiple of an angle": node("=", node("sin", node("*", 10**9, "x")), node("/", 1, 3)),
    "nothing to a power below nothing": node("=", node("^", 0, -1), 1),
    "nested roots": node(
        "=", node("sqrt", node("sqrt", node("sqrt", node("+", "x", node("sqrt", "y"))))), node("sqrt", 47)
    ),
    "the root of minus one": node("=", node("^", node("sqrt", -1), 2), -1),
    "a fractional power of nothing": node("=", node("pow", 0, node("/", 1, 2)), 0),
    "infinity as a number": node("=", node("+", INFINITY, 1), INFINITY),
    "a bound constant": node("=", node("integral", "pi", "pi", 0, 1), "pi"),
    "a derivative by a constant": node("=", node("diff", node("^", "pi", 2), "pi", 1, "pi"), node("*", 2, "pi")),
    "an unknown operation": node("=", ("sinh", "x"), "x"),
    "a power without an exponent": node("=", ("^", "x"), "x"),
    "an exponent that is a letter": node("=", node("^", "x", "n"), "x"),
    "a truth value": node("=", True, 1),
    "no side": ("=",),
    "no connective": ("nor", node("=", "x", "x"), node("=", "x", "x")),
    "an empty quantifier": node("exists", (), node("=", "x", "x")),
    "a name that is none": ("=", "x y", "x y"),
    "orders that do not fit": node("=", node("call", "f", (0, 1), "x"), node("call", "f", (0, 1), "x")),
    "another order": node("=", node("call", "f", (-1,), "x"), node("call", "f", (-1,), "x")),
}


@pytest.mark.parametrize("claim", ENDLESS.values(), ids=ENDLESS)
def test_what_no_method_can_read_or_finish_is_undecided_with_a_reason(claim: Formula) -> None:
    for problem in (
        Problem("claimed", claim),
        Problem("given", node("=", "x", "x"), (), (("h", (claim,)),)),
    ):
        outcome = identity.decide(problem)
        assert outcome.verdict is Verdict.UNDECIDED
        assert outcome.reason
        assert proof_of(problem) is None


def test_deep_terms_are_undecided() -> None:
    term: Term = "x"
    for _ in range(5000):
        term = node("-", term)
    assert identity.decide(Problem("deep", node("=", term, "x"))).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("file", sorted(PROOF.rglob("*.py")), ids=lambda file: file.stem)
def test_the_provers_use_nothing_of_the_checker_but_theorems_and_digits(file: Path) -> None:
    nodes = [*ast.walk(ast.parse(file.read_text(encoding="utf-8")))]
    imported = [f"{node.module}.{a.name}" for node in nodes if isinstance(node, ast.ImportFrom) for a in node.names]
    imported += [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    shared = ("symcheck.checker.theorems", "symcheck.checker.enclosures")
    assert not [name for name in imported if name.startswith("symcheck.checker") and not name.startswith(shared)]
