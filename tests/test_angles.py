"""Orders of angles: what is true is proved, what is false is refuted at a point, and no theorem is stretched."""

from __future__ import annotations

import copy
import json
import math
import random
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from sampling import every

from symcheck.audit.checked import reason as check
from symcheck.checker.theorems import NAMES, instance
from symcheck.core.certificates import Certificate
from symcheck.core.formulas import contrary
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import RELATIONS, Formula, node
from symcheck.core.verdicts import Verdict
from symcheck.proof import certificate, fails_at, identity
from symcheck.proof.algebra.simplex import positive_relation
from symcheck.reading import Letter, Notation, lower, read
from symcheck.views.steps import point, sides

ANGLES = Notation([Letter("a"), Letter("b"), Letter("c"), Letter(r"\pi")])
COSECANT, SECANT = (rf"\operatorname{{arctg}}\left(\frac{{1}}{{\{f} b}}\right)" for f in ("sin", "cos"))
D = {1: r"4 \sin a \sin b", 2: r"4 \sin a \cos b", 3: r"4 \cos a"}
TRUNCATED = {1: r"\sqrt{8\sin^2 a \sin^2 b + 1}", 2: r"\sqrt{8\sin^2 a \cos^2 b + 1}", 3: r"\sqrt{8\cos^2 a + 1}"}
CELLS = {  # an order of three distances, and where it holds
    (1, 2, 3): (r"0 \leq b \leq \frac{\pi}{4}", rf"0 \leq a \leq {SECANT}"),
    (1, 3, 2): (r"0 \leq b \leq \frac{\pi}{4}", rf"{SECANT} \leq a \leq {COSECANT}"),
    (3, 1, 2): (r"0 \leq b \leq \frac{\pi}{4}", rf"{COSECANT} \leq a \leq \frac{{\pi}}{{2}}"),
    (2, 1, 3): (r"\frac{\pi}{4} \leq b \leq \frac{\pi}{2}", rf"0 \leq a \leq {COSECANT}"),
    (2, 3, 1): (r"\frac{\pi}{4} \leq b \leq \frac{\pi}{2}", rf"{COSECANT} \leq a \leq {SECANT}"),
    (3, 2, 1): (r"\frac{\pi}{4} \leq b \leq \frac{\pi}{2}", rf"{SECANT} \leq a \leq \frac{{\pi}}{{2}}"),
}
H = {1: r"6 \cos a", 2: r"4 \sin a", 3: r"2 \sqrt{3 \cos^2 a + 1}", 4: r"2 \sqrt{2 \sin^2 a + 1}"}
LIMITS = (
    r"\arcsin \frac{\sqrt{2}}{2}",
    r"\arcsin \frac{2}{\sqrt{7}}",
    r"\operatorname{arctg} \sqrt{\frac{3}{2}}",
    r"\operatorname{arctg} \frac{3}{2}",
    r"\arccos \sqrt{\frac{3}{11}}",
    r"\arccos \frac{1}{\sqrt{6}}",
)
ORDERS = (
    "2 < 4 < 3 < 1", "2 = 4 < 3 < 1", "4 < 2 < 3 < 1", "4 < 2 = 3 < 1", "4 < 3 < 2 < 1", "4 = 3 < 2 < 1",
    "3 < 4 < 2 < 1", "3 < 4 < 2 = 1", "3 < 4 < 1 < 2", "3 < 4 = 1 < 2", "3 < 1 < 4 < 2", "3 = 1 < 4 < 2",
    "1 < 3 < 4 < 2",
)  # fmt: skip
QUADRANT = r"0 \leq a \leq 90^\circ"
OPEN = (r"0 < a < \frac{\pi}{2}", r"0 < b < \frac{\pi}{2}")


def row(number: int) -> tuple[str, str]:
    """An order of four distances, and the angles for which it holds."""
    order = "".join(H.get(int(c), "") if c.isdigit() else c for c in ORDERS[number])
    below, above = (LIMITS[k] if 0 <= k < 6 else "" for k in ((number - 1) // 2, number // 2))
    if number % 2:
        return order, f"a = {below}"
    return order, f"{f'{below} <' if below else QUADRANT[:6]} a {f'< {above}' if above else QUADRANT[8:]}"


def chain(table: dict[int, str], order: tuple[int, ...], sign: str = r"\leq") -> str:
    return f" {sign} ".join(table[k] for k in order)


@cache
def formula(latex: str) -> Formula:
    parts = lower(read(latex, ANGLES), ANGLES)
    return parts[0] if len(parts) == 1 else node("and", *parts)


def problem(claim: str, *given: str) -> Problem:
    return Problem("angles", formula(claim), (), tuple((f"given {k}", (formula(g),)) for k, g in enumerate(given)))


def decided(claim: str, *given: str) -> tuple[Outcome, Certificate]:
    """The outcome, and its certificate, which the checker accepts."""
    posed = problem(claim, *given)
    outcome = identity.decide(posed)
    assert outcome.verdict is not Verdict.UNDECIDED, outcome.reason
    plain: Certificate = json.loads(json.dumps(certificate(posed, outcome)))
    assert check(plain) is None
    return outcome, plain


@pytest.mark.parametrize("order", CELLS)
@pytest.mark.parametrize("table", [D, TRUNCATED], ids=["whole", "truncated"])
def test_three_distances_have_their_order(table: dict[int, str], order: tuple[int, ...]) -> None:
    assert decided(chain(table, order), *CELLS[order])[0].verdict is Verdict.PROVED


@pytest.mark.parametrize("order", CELLS)
def test_three_distances_have_that_order_nowhere_else(order: tuple[int, ...]) -> None:
    claim = rf"{chain(D, order)} \Leftrightarrow {CELLS[order][0]} \land {CELLS[order][1]}"
    assert decided(claim, *OPEN)[0].verdict is Verdict.PROVED


@pytest.mark.parametrize("order", every(3, CELLS))
def test_another_order_of_three_distances_is_refuted(order: tuple[int, ...]) -> None:
    assert decided(chain(D, order[::-1]), *CELLS[order])[0].verdict is Verdict.REFUTED
    assert decided(chain(D, order[:2], "<"), *CELLS[order])[0].verdict is Verdict.REFUTED


@pytest.mark.parametrize("number", every(3, range(13)))
def test_four_distances_have_their_order(number: int) -> None:
    order, where = row(number)
    assert decided(order, where)[0].verdict is Verdict.PROVED
    assert decided(rf"{order} \Leftrightarrow {where}", QUADRANT)[0].verdict is Verdict.PROVED


@pytest.mark.parametrize("number", every(4, range(13)))
def test_the_order_of_a_neighbouring_row_is_refuted(number: int) -> None:
    for other in {max(number - 1, 0), min(number + 1, 12)} - {number}:
        assert decided(row(other)[0], row(number)[1])[0].verdict is Verdict.REFUTED


@pytest.mark.parametrize("number", every(4, range(0, 13, 2)))
def test_an_order_does_not_hold_at_the_end_of_its_interval(number: int) -> None:
    order, where = row(number)
    ends = [k for k in ((number - 1) // 2, number // 2) if 0 <= k < 6]
    for k in ends:
        closed = where.replace(f"{LIMITS[k]} <", rf"{LIMITS[k]} \leq").replace(f"< {LIMITS[k]}", rf"\leq {LIMITS[k]}")
        assert closed != where
        outcome, _ = decided(order, closed)
        assert outcome.verdict is Verdict.REFUTED
        assert outcome.point is not None
        assert outcome.point.values["a"] == formula(f"a = {LIMITS[k]}")[2]  # nowhere else


BOTH = rf"{D[1]} = {D[2]} \land {D[2]} = {D[3]}"
TRUE = {
    "equal distances": (rf"{D[1]} = {D[2]} \Leftrightarrow b = \frac{{\pi}}{{4}}", *OPEN),
    "in degrees": (rf"{D[1]} = {D[2]} \Leftrightarrow b = 45^\circ", r"\sin a > 0", r"0 \leq b \leq \frac{\pi}{2}"),
    "three equal distances": (
        rf"{BOTH} \Leftrightarrow a = \operatorname{{arctg}} \sqrt{{2}} \land b = \frac{{\pi}}{{4}}",
        *OPEN,
    ),
    "an angle by its tangent": (
        r"\operatorname{tg} a = \sqrt{2} \Rightarrow a = \operatorname{arctg} \sqrt{2}",
        OPEN[0],
    ),
    "an angle by its sine": (r"a = \arcsin \frac{\sqrt{2}}{2} \Rightarrow a = 45^\circ",),
    "an angle by its sine, without a letter": (r"\arcsin \frac{\sqrt{2}}{2} = 45^\circ",),
    "the sine of 30 degrees": (r"a = 30^\circ \Rightarrow \sin a = \frac{1}{2}",),
    "the cosine of 60 degrees": (r"a = 60^\circ \Rightarrow \cos a = \frac{1}{2}",),
    "the sine of the double angle": (r"\sin 2a > 0", OPEN[0]),
    "sines increase": (r"a \leq \arcsin c \Rightarrow \sin a \leq c", r"-1 \leq c \leq 1", QUADRANT),
    "cosines decrease": (r"a < \arccos c \Leftrightarrow \cos a > c", r"-1 \leq c \leq 1", r"0 \leq a \leq \pi"),
    "a tangent without end": (r"\operatorname{arctg} c < \frac{\pi}{2}",),
}
FALSE = {
    "another angle": (rf"{D[1]} = {D[2]} \Leftrightarrow b = 30^\circ", *OPEN),
    "equal at one more place": (rf"{D[1]} = {D[2]} \Leftrightarrow b = 45^\circ", QUADRANT, r"0 \leq b \leq 90^\circ"),
    "three equal distances elsewhere": (rf"{BOTH} \Leftrightarrow a = 45^\circ \land b = 45^\circ", *OPEN),
    "a tangent for a sine": (r"a = \operatorname{arctg} \frac{1}{2} \Rightarrow \sin a = \frac{1}{2}",),
    "cosines do not increase": (r"a \leq \arccos \frac{1}{3} \Rightarrow \cos a \leq \frac{1}{3}", QUADRANT),
    "beyond the right angle": (r"\sin a \leq \frac{1}{2} \Rightarrow a \leq \arcsin \frac{1}{2}", r"0 \leq a \leq \pi"),
}


@pytest.mark.parametrize("name", TRUE)
def test_a_true_statement_about_angles_is_proved(name: str) -> None:
    assert decided(*TRUE[name])[0].verdict is Verdict.PROVED


@pytest.mark.parametrize("name", every(3, FALSE))
def test_a_false_statement_about_angles_is_refuted(name: str) -> None:
    assert decided(*FALSE[name])[0].verdict is Verdict.REFUTED


NOT_PROVED = {
    "an angle may be turned": (r"\sin a = \frac{1}{2} \Rightarrow a = \arcsin \frac{1}{2}",),
    "a sine above 1": (r"a \leq \arcsin c \Rightarrow \sin a \leq c", QUADRANT),
    "an angle below the quadrant": (r"a < \arccos c \Rightarrow \cos a > c", r"-1 \leq c \leq 1"),
    "tangents of obtuse angles": (
        r"\operatorname{arctg} c \leq a \Rightarrow \sin a \geq c \cos a",
        r"0 \leq c",
        r"a \geq 0",
    ),
    "the sign of a tangent": (r"\operatorname{arctg} c \geq 0",),
}


@pytest.mark.parametrize("name", every(3, NOT_PROVED))
def test_what_needs_another_range_is_not_proved(name: str) -> None:
    assert identity.decide(problem(*NOT_PROVED[name])).verdict is not Verdict.PROVED


@pytest.mark.parametrize("name", ["three equal distances", "cosines decrease", "the sine of the double angle"])
def test_a_proof_with_another_relation_or_angle_is_rejected(name: str) -> None:
    _, plain = decided(*TRUE[name])
    changed = 0
    for path, value in [*places(plain["proof"])]:
        for other in others(path, value):
            changed += 1
            assert check(altered(plain, path, other)), (path, other)
    assert changed > 4


TURNED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "=": "!="}
KINDS = ("arctangent", "arcsine", "arccosine")


def others(path: tuple[Any, ...], value: Any) -> list[str]:
    """Other theorems for one of those that compare angles, and another angle for the one that it is about."""
    if path[-1:] == ("of",) and value.partition(" ")[0] in KINDS:
        kind, sign, *back = value.split()
        return [" ".join((kind, TURNED[sign], *back)), *(" ".join((k, sign, *back)) for k in KINDS if k != kind)]
    return ["b"] if path[-2:-1] == ("with",) and value == "a" else []


def places(node: Any, path: tuple[Any, ...] = ()) -> Any:
    yield path, node
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in children:
        yield from places(child, (*path, key))


def altered(original: Certificate, path: tuple[Any, ...], value: Any) -> Certificate:
    changed = copy.deepcopy(original)
    node: Any = changed["proof"]
    for key in path[:-1]:
        node = node[key]
    node[path[-1]] = value
    return changed


HERE = {"rule": "identity", "cofactors": [[["here", 0], "1"]]}
PLAIN: dict[str, Any] = {"rule": "identity", "cofactors": []}
KNOWN = {"rule": "nonnegative", "form": 0, "cofactors": []}


def forged(claim: Any, of: str, given: dict[str, Any], premises: list[Any], then: Any, **more: Any) -> Certificate:
    proof = {"rule": "theorem", "of": of, "with": given, "premises": premises, "then": then, **more}
    witnesses = [{"values": dict.fromkeys("at", 0)}]
    return {"verdict": "proved", "id": "t", "claim": claim, "proof": proof, "witnesses": witnesses}


GAMMA_ZERO = ["+", ["gamma", 1], ["-", 1]]
ABSURD = {"rule": "absurd", "times": [], "cofactors": [[["here", 0], "Inverse_0"]]}
THIRD = ["/", ["pi"], 3]
FORGED = {
    "an angle with another number": forged(["=", ["arctan", 1], THIRD], "known_angle_arctan_2", {}, [], HERE),
    "an angle that is not in the table": forged(["=", ["arctan", 2], THIRD], "known_angle_arctan_4", {}, [], HERE),
    "a tangent with a largest angle": forged(
        ["<=", ["arctan", "t"], 1], "principal_value_arctan", {"t": "t"}, [], PLAIN
    ),
    "the arcsine of 2": forged(
        ["<=", ["arcsin", 2], ["/", ["pi"], 2]], "principal_value_arcsin", {"t": 2}, [KNOWN], PLAIN
    ),
    "another function": forged(["=", 0, 1], "principal_value_sqrt", {"t": 2}, [], PLAIN),
    "a negative tangent": forged([">=", ["arctan", -1], 0], "first_quadrant_arctan", {"t": -1}, [KNOWN], PLAIN),
    "a cosine beyond the quadrant": forged(["=", 0, 0], "right_half", {"a": "a"}, [KNOWN, KNOWN], PLAIN),
    "a relation that is none": forged(["=", 0, 0], "arctangent ~", {"a": "a", "t": 1}, [KNOWN] * 3, PLAIN),
    "neither forward nor back": forged(["=", 0, 0], "arctangent = away", {"a": "a", "t": 1}, [KNOWN] * 3, PLAIN),
    "an angle without range": forged(
        ["=", ["sin", "a"], ["cos", "a"]], "arctangent =", {"a": "a", "t": 1}, [PLAIN, PLAIN, PLAIN], HERE
    ),
    "a sine without domain": forged(
        ["=", ["sin", "a"], 2], "arcsine =", {"a": "a", "t": 2}, [KNOWN, KNOWN, KNOWN, PLAIN], HERE
    ),
    "a cosine without domain": forged(
        ["=", ["cos", "a"], 2], "arccosine =", {"a": "a", "t": 2}, [KNOWN, KNOWN, KNOWN, PLAIN], HERE
    ),
    "a division by what a theorem says is zero": forged(
        ["=", 0, 1], "gamma_values", {}, [], ABSURD, atoms={"Inverse_0": ["/", 1, GAMMA_ZERO]}
    ),
    "the same with an angle": forged(
        ["=", 0, 1],
        "known_angle_arctan_2",
        {},
        [],
        ABSURD,
        atoms={"Inverse_0": ["/", 1, ["+", ["arctan", 1], ["-", ["/", ["pi"], 4]]]]},
    ),
}


def test_the_proofs_that_are_forged_can_be_right() -> None:
    right = forged(["=", ["arctan", 1], ["/", ["pi"], 4]], "known_angle_arctan_2", {}, [], HERE)
    assert check(right) is None


@pytest.mark.parametrize("name", FORGED)
def test_a_forged_proof_about_angles_is_rejected(name: str) -> None:
    assert check(FORGED[name])


def refuted_by_proof() -> Certificate:
    return decided(rf"{H[2]} < {H[1]}", rf"0 \leq a \leq {LIMITS[3]}")[1]


ENDLESS = {"a": ["arctan", ["/", 3, 2]], "b": ["/", 1, ["+", ["arctan", 1], ["-", ["/", ["pi"], 4]]]]}


def test_a_point_is_refused_unless_everything_is_proved_there() -> None:
    right = refuted_by_proof()
    assert right["point"]["values"] == {"a": ["arctan", ["/", 3, 2]]}
    for values in ({}, {"a": ["arctan", 2]}, {"a": "b"}, {"a": ["arctan", "a"]}, {"sin(a)": 0}, {"pi": 3}, ENDLESS):
        wrong = copy.deepcopy(right)
        wrong["point"]["values"] = values
        assert check(wrong), values
    for claim in (["<=", *right["claim"][1:]], [">=", *right["claim"][1:]]):
        assert check({**right, "claim": claim})
    stronger = copy.deepcopy(right)
    stronger["hypotheses"]["given 0"].append(["<", "a", ["arctan", 1]])
    assert check(stronger)
    conditional = copy.deepcopy(right)
    conditional["point"]["proof"]["nonzero"] = ["a"]
    assert "superfluous" in str(check(conditional))


def test_a_fact_about_a_point_is_checked() -> None:
    _, right = decided(chain(D, (1, 2), "<"), *CELLS[1, 2, 3])
    assert right["point"]["proof"]["rule"] == "have"
    assert right["point"]["proof"]["formula"] == ["!=", ["cos", "b"], 0]
    for fact in (["!=", ["sin", "b"], 0], ["=", ["cos", "b"], 0]):
        wrong = copy.deepcopy(right)
        wrong["point"]["proof"]["formula"] = fact
        assert check(wrong)


def test_a_point_of_angles_is_told_in_words() -> None:
    found = refuted_by_proof()["point"]
    assert (point(found["values"]), sides(found)) == ("a = arctan(3/2)", "the contrary has a proof")


def test_a_point_of_angles_says_nothing_of_other_statements() -> None:
    values = {"a": node("arctan", node("/", 3, 2))}
    assert json.loads(json.dumps(values)) == refuted_by_proof()["point"]["values"]
    assert not fails_at(problem(rf"{H[2]} \leq {H[1]}", QUADRANT), values)


def test_the_contrary_of_a_formula_is_true_where_the_formula_is_not() -> None:
    def truth(f: Any, at: dict[str, int]) -> bool:
        kind, *parts = f
        if kind in ("and", "or", "=>", "<=>"):
            first, second = (truth(part, at) for part in parts)
            return {"and": first and second, "or": first or second, "=>": second or not first}.get(
                kind, first == second
            )
        left, right = (at[x] for x in parts)
        return {"=": left == right, "!=": left != right, "<": left < right, "<=": left <= right}.get(
            kind, left > right if kind == ">" else left >= right
        )

    source = random.Random(5)

    def drawn(depth: int) -> Any:
        if depth == 0:
            return node(source.choice(RELATIONS), source.choice("xyz"), source.choice("xyz"))
        return node(source.choice(["and", "or", "=>", "<=>"]), drawn(depth - 1), drawn(depth - 1))

    for _ in range(200):
        f = drawn(source.randrange(4))
        at = {x: source.randrange(3) for x in "xyz"}
        assert truth(f, at) is not truth(contrary(f), at)


def value(term: Any, at: dict[str, float]) -> float:
    match term:
        case ("pi",):
            return math.pi
        case ("-", inner):
            return -value(inner, at)
        case (str(function), inner):
            return float(getattr(math, function.replace("arc", "a"))(value(inner, at)))
        case ("*", *parts):
            return math.prod(value(part, at) for part in parts)
        case ("/", top, bottom):
            return value(top, at) / value(bottom, at)
        case ("^", base, int(n)):
            return value(base, at) ** n
    return at.get(term, term)


def holds(f: Any, at: dict[str, float]) -> bool:
    kind, *parts = f
    if kind == "and":
        return all(holds(part, at) for part in parts)
    left, right = (value(part, at) for part in parts)
    near = abs(left - right) < 1e-9
    return {"=": near, "!=": not near, "<": left < right and not near, "<=": left < right or near}.get(
        kind, (left > right and not near) if kind == ">" else left > right or near
    )


OF_ANGLES = ("arctangent", "arcsine", "arccosine", "right_half", "positive", "principal_value", "first_quadrant")


@pytest.mark.parametrize("name", [name for name in NAMES if name.startswith(OF_ANGLES)])
def test_a_theorem_about_angles_is_true_at_random_numbers(name: str) -> None:
    given = "a" if name.startswith(OF_ANGLES[3:5]) else "t" if name.startswith(OF_ANGLES[5:]) else "at"
    premises, conclusion = instance(name, {letter: letter for letter in given})
    source, met = random.Random(11), 0
    for _ in range(2000):
        t = source.choice([source.uniform(-1.5, 1.5), 0, 1, -1, 0.5])
        a = source.choice([source.uniform(-4, 4), math.atan(t), math.pi / 2, -math.pi / 2, 0.0])
        at = {"a": a, "t": t}
        try:
            if all(holds(premise, at) for premise in premises):
                met += 1
                assert holds(conclusion, at), at
        except ValueError:  # the arcsine of a number above 1, which the first premise excludes
            assert not holds(premises[0], at)
    assert met > 30


def test_the_table_of_angles_is_true() -> None:
    known = [name for name in NAMES if name.startswith("known_angle")]
    assert len(known) == 4 + 5 + 5
    assert all(holds(instance(name, {})[1], {}) for name in known)


def columns(source: random.Random, weights: list[int], size: int) -> list[list[int]]:
    """Columns whose scalar products with the weights are positive."""
    found: list[list[int]] = []
    while len(found) < size:
        column = [source.randint(-4, 4) for _ in weights]
        if sum(w * c for w, c in zip(weights, column, strict=True)) > 0:
            found.append(column)
    return found


def test_a_positive_relation_is_found_where_there_is_one() -> None:
    source = random.Random(3)
    for _ in range(60):
        rows = source.randint(1, 5)
        base = columns(source, [source.choice([-1, 1, 2]) for _ in range(rows)], source.randint(1, 6))
        signed = [({(k,): Fraction(c) for k, c in enumerate(column) if c}, True) for column in base]
        assert positive_relation(signed) is None
        parts = [source.randint(1, 5) for _ in base]
        last = [-sum(p * column[k] for p, column in zip(parts, base, strict=True)) for k in range(rows)]
        closed = [*signed, ({(k,): Fraction(c, 7) for k, c in enumerate(last) if c}, False)]
        found = positive_relation(closed)
        assert found is not None
        assert all(multiple > 0 for multiple in found.values())
        assert any(closed[k][1] for k in found)
        totals = [sum(multiple * closed[k][0].get((row,), 0) for k, multiple in found.items()) for row in range(rows)]
        assert not any(totals)
