"""The checker accepts what is right: every rule, every theorem, lemmas, points and witnesses. It stands alone.

What it must not accept is in `forgeries`.
"""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from forgeries import (
    COS,
    HALF_PI,
    ID,
    INVERSES,
    NOO,
    OO,
    PI,
    SIN,
    above,
    absurd,
    antiderivative,
    by,
    cases,
    choose,
    compute,
    constant,
    each,
    every,
    f,
    have,
    here,
    hyp,
    implies,
    integral,
    minus,
    of,
    proved,
    refuted,
    rising,
    split,
    sq,
    theorem,
    vanish,
    witness,
)

from symcheck.checker import check, check_all, residues
from symcheck.checker.__main__ import main
from symcheck.checker.algebra import Algebra
from symcheck.checker.rules import POLYNOMIAL, RULES
from symcheck.checker.theorems import NAMES
from symcheck.core.terms import Reader, node

pytestmark = pytest.mark.whole
JSON = Any
ROOT = Path(__file__).resolve().parent.parent
DOUBLE = minus(sq(["cos", "y"]), sq(["sin", "y"]))
SIZE: JSON = ["sqrt", sq("x")]  # an absolute value
ARCH: JSON = ["*", ["pow", "x", ["/", 1, 2]], ["pow", ["+", 1, ["-", "x"]], ["/", 1, 2]]]
FALLING, BELL = ["exp", ["-", "x"]], ["exp", ["-", sq("x")]]
NOT_ZERO = implies(absurd([], [here(), "1"]))
EULER = ["pow", ["+", sq("x"), 1], ["-", 1]]
INTEGRAND = ["*", 1, ["^", "x", 0], ["pow", "x", 0], ["pow", ["+", ["*", 1, sq("x")], 1], ["-", 1]]]
PARTS = {"p": 1, "q": 1, "r": 1, "k": 0, "u": 0, "c": 1}

BETWEEN_0_AND_1 = [
    "forall",
    ["x_0"],
    ["=>", ["and", ["<", 0, "x_0"], ["<", "x_0", 1], ["!=", "x_0", 0]], [">=", "x_0", 0]],
]
FALLEN = integral(FALLING, "x", 0, OO)
CONVERGES = theorem(
    "decaying", {"f": of("x", FALLING), "g": of("x", -1), "a": 1, "s": 0}, [above(1), every(["y"], implies(ID))], ID
)

RIGHT: dict[str, JSON] = {
    "identity": proved(["=", sq(["+", "x", 1]), ["+", sq("x"), ["*", 2, "x"], 1]], ID),
    "identity by a fact": proved(["=", sq("x"), 4], by(hyp(), factor="x + 2"), [["=", "x", 2]], at={"x": 2}),
    "identity, cleared": proved(
        ["=", ["/", "x", "y"], 1],
        {"rule": "identity", "times": ["y"], "cofactors": [[hyp(), "1"]]},
        [["=", "x", "y"]],
        nonzero=["y"],
        at={"x": 1, "y": 1},
    ),
    "identity, times what is not zero": proved(
        ["=", "x", 0],
        {"rule": "identity", "times": [hyp(1)], "cofactors": [[hyp(), "1"]]},
        [["=", ["*", "x", "y"], 0], ["!=", "y", 0]],
        at={"x": 0, "y": 1},
    ),
    "identity with atoms": proved(
        ["=", ["*", SIN, "y"], SIN],
        {**by(hyp(), factor="s"), "atoms": {"s": SIN}},
        [["=", "y", 1]],
        at={"x": 1, "y": 1},
    ),
    "nonnegative": proved([">", ["+", sq("x"), 1], 0], above(["+", sq("x"), 1])),
    "nonnegative by facts": proved(
        [">", ["*", "x", "y"], 0], above(["*", "x", "y"]), [[">", "x", 0], ["<", 0, "y"]], at={"x": 1, "y": 1}
    ),
    "nonnegative by a divisor": proved(
        [">=", ["/", 1, sq("x")], 0], above(["/", 1, sq("x")]), nonzero=["x"], at={"x": 1}
    ),
    "implies": proved(["=>", ["=", "x", 1], ["=", sq("x"), 1]], implies(by(here(), factor="x + 1")), at={"x": 1}),
    "implies a relation": proved(
        ["!=", ["+", sq("x"), 1], 0], implies(absurd([["positive", ["+", sq("x"), 1]]], [here(), "1"]))
    ),
    "each": proved(["and", ["=", "x", "x"], ["=", 0, 0]], each(ID, ID)),
    "each direction": proved(
        ["<=>", ["=", "x", 1], ["=", ["*", 2, "x"], 2]],
        each(implies(by(here(), factor="2")), implies(by(here(), factor="1/2"))),
    ),
    "choose": proved(["or", ["=", 0, 1], ["=", "x", "x"]], choose(1, ID)),
    "cases_or": proved(
        ["=>", ["or", ["=", "x", 1], ["=", "x", -1]], ["=", sq("x"), 1]],
        implies(cases(here(), by(here(1), factor="x + 1"), by(here(1), factor="x - 1"))),
        at={"x": 1},
    ),
    "split": proved(
        ["=>", ["=", ["*", "x", "y"], 0], ["or", ["=", "x", 0], ["=", "y", 0]]],
        implies(split([["x", 1], ["y", 1]], [[here(), "1"]], choose(0, by(here(1))), choose(1, by(here(1))))),
        at={"x": 0, "y": 1},
    ),
    "vanish": proved(
        ["=>", ["=", ["+", sq("x"), sq("y")], 0], ["=", "x", 0]],
        implies(vanish(["+", sq("x"), sq("y")], [[here(), "1"]], split([["x", 2]], [[here(1), "1"]], by(here(3))))),
        at={"x": 0, "y": 0},
    ),
    "absurd": proved(["!=", "x", 0], implies(absurd([hyp()], [here(), "1"])), [[">", "x", 0]], at={"x": 1}),
    "have": proved(
        ["=", sq("x"), 9], have(["=", "x", 3], by(hyp()), by(here(), factor="x + 3")), [["=", "x", 3]], at={"x": 3}
    ),
    "witness": proved(["exists", ["x"], ["=", ["*", 2, "x"], "y"]], witness({"x": ["/", "y", 2]}, ID)),
    "every": proved(["forall", ["x"], [">=", sq("x"), 0]], every(["y"], above(sq("y")))),
    "compute": proved(
        ["and", ["<", ["sqrt", 2], ["/", 3, 2]], ["!=", PI, 3], ["=", ["sin", ["/", PI, 2]], 1]], compute()
    ),
    "compute from a value": proved(
        ["<", f(0), 2], compute(hyp()), [["=", f(0), 1]], witnesses=[{"values": {}, "calls": [[f(0), 1]]}]
    ),
    "nonnegative, an even power": proved([">", sq("x"), 0], above(sq("x")), [["!=", "x", 0]], at={"x": 1}),
    "nonnegative, a root": proved(
        [">", ["sqrt", ["/", "x", "y"]], 0],
        above(["sqrt", ["/", "x", "y"]]),
        [[">", "x", 0], [">", "y", 0]],
        at={"x": 1, "y": 1},
    ),
    "nonnegative, a root of what is not zero": proved(
        [">", ["sqrt", "x"], 0], above(["sqrt", "x"]), [[">=", "x", 0], ["!=", "x", 0]], at={"x": 1}
    ),
    "nonnegative, an exponential": proved([">", ["exp", "x"], 0], above(["exp", "x"])),
    "implies what makes a denominator": proved(
        ["=>", ["!=", "x", 0], ["exists", ["z"], ["=", ["*", "z", "x"], 1]]],
        implies(witness({"z": ["/", 1, "x"]}, ID)),
        at={"x": 1},
    ),
    "cases_or of what makes a denominator": proved(
        ["exists", ["z"], ["=", ["*", "z", "x"], sq("x")]],
        theorem(
            "dichotomy",
            {"t": "x"},
            [],
            cases(here(), witness({"z": ["/", ["^", "x", 3], sq("x")]}, ID), witness({"z": "x"}, ID)),
        ),
    ),
    "identity by the addition theorem": proved(
        ["=", ["exp", ["+", ["*", 2, "x"], ["-", ["*", "x", "y"]]]], ["/", sq(["exp", "x"]), ["exp", ["*", "y", "x"]]]],
        {**ID, "positive": [["exp", ["*", "x", "y"]]]},
    ),
    "compute an exponential": proved(
        ["and", ["<", ["exp", 1], ["/", 272, 100]], ["<", ["/", 69, 100], ["log", 2]], ["=", ["exp", 0], 1]], compute()
    ),
    "compute sums and integrals": proved(
        [
            "and",
            ["<", ["sum", ["exp", ["-", "k"]], "k", 1, 2], ["/", 504, 1000]],
            ["=", ["product", "k", "k", 1, 4], 24],
            ["=", ["sum", "k", "k", 1, 0], 0],
            ["<", integral(["exp", "x"]), ["/", 1719, 1000]],
        ],
        compute(),
    ),
    "positive": proved(
        ["exists", ["z"], ["=", ["*", "z", ["+", 1, sq("x")]], 1]],
        {**witness({"z": ["/", 1, ["+", 1, sq("x")]]}, ID), "positive": [["+", 1, sq("x")]]},
    ),
    "theorem": proved(
        ["=", sq(["sqrt", ["+", 1, sq("x")]]), ["+", 1, sq("x")]],
        theorem("root", {"t": ["+", 1, sq("x")]}, [above(["+", 1, sq("x")])], by(here(1))),
        at={"x": 1},
    ),
    "theorem, an integrand without a bound at an end": proved(
        ["=", integral(["/", 1, ["*", 2, ["sqrt", "x"]]], "x", 0, 1), 1],
        antiderivative(0, 1, by(here()), ["/", 1, ["*", 2, ["sqrt", "x"]]], ["sqrt", "x"], [above("y"), above("y")]),
        witnesses=[{"values": {}, "proof": have(BETWEEN_0_AND_1, every(["y"], implies(above("y"))), compute(here()))}],
    ),
    "compute, by the fact that all terms have values": proved(
        ["=", integral(["sqrt", "x"]), integral(["sqrt", "x"])],
        ID,
        witnesses=[{"values": {}, "proof": have(BETWEEN_0_AND_1, every(["y"], implies(above("y"))), compute(here()))}],
    ),
    "compute, by the fact that an integral converges": proved(
        ["=", minus(FALLEN, FALLEN), 0],
        ID,
        witnesses=[{"values": {}, "proof": {**CONVERGES, "then": compute(here(1))}}],
    ),
    "theorem, what an integrand divides by": proved(
        ["=", INVERSES, ["log", 2]],
        antiderivative(1, 2, theorem("log_of_one", {}, [], {**ID, "cofactors": [[here(), "1"], [here(1), "-1"]]})),
    ),
}

ANGLES = {"arctangent": ["arctan", "t"], "arcsine": ["arcsin", "t"], "arccosine": ["arccos", "t"]}


def angle(name: str, sign: str, back: str) -> JSON:
    """A theorem of angles about the principal value itself, or its negative for the strict signs."""
    value = ANGLES[name]
    domain = [above(minus(1, sq("t")))] if name != "arctangent" else []
    turned = {
        "arctangent": [sign, ["sin", "a"], ["*", "t", ["cos", "a"]]],
        "arcsine": [sign, ["sin", "a"], "t"],
        "arccosine": [sign, "t", ["cos", "a"]],
    }[name]
    given, wanted = (turned, [sign, "a", value]) if back else ([sign, "a", value], turned)
    h = [given, ["<=", sq("t"), 1]]
    inside = (
        [["<=", ["-", HALF_PI], "a"], ["<=", "a", HALF_PI]]
        if name != "arccosine"
        else [["<=", 0, "a"], ["<=", "a", PI]]
    )
    use = {"=": by(here()), "!=": implies(absurd([here()], [here(1), "1"]))}
    last = {"=": by(hyp()), "!=": implies(absurd([hyp()], [here(), "1"]))}

    def order(formula: JSON) -> JSON:
        large, small = formula[2:0:-1] if sign[0] == "<" else formula[1:]
        return above(minus(large, small))

    proofs = [*domain, *(above(minus(part[2], part[1])) for part in inside), last.get(sign, order(given))]
    step = theorem(f"{name} {sign}{back}", {"a": "a", "t": "t"}, proofs, use.get(sign, order(wanted)))
    return proved(wanted, step, [given, *inside, *(h[1:] if domain else [])])


def known(name: str, value: JSON, n: JSON) -> JSON:
    return proved(["=", value, n], theorem(name, {}, [], by(here())))


THEOREMS: dict[str, JSON] = {
    "dichotomy": proved(
        [">=", ["+", sq("x"), 1], 0],
        theorem("dichotomy", {"t": "x"}, [], cases(here(), *[above(["+", sq("x"), 1])] * 2)),
    ),
    "root": RIGHT["theorem"],
    "root_of_product": proved(
        ["=", ["sqrt", ["*", sq("x"), 2]], ["*", ["sqrt", sq("x")], ["sqrt", 2]]],
        theorem("root_of_product", {"s": sq("x"), "t": 2}, [above(sq("x")), above(2)], by(here())),
        at={"x": 1},
    ),
    "equal_squares": proved(
        ["=", "x", "y"],
        theorem("equal_squares", {"s": "x", "t": "y"}, [above("x"), above("y"), by(hyp(2))], by(here())),
        [[">=", "x", 0], [">=", "y", 0], ["=", sq("x"), sq("y")]],
        at={"x": 1, "y": 1},
    ),
    "power": proved(
        [">", ["pow", 2, "x"], 0], theorem("power", {"b": 2, "u": "x"}, [above(2)], above(["pow", 2, "x"]))
    ),
    "power_of_sum": proved(
        ["=", ["pow", 2, ["+", "x", 1]], ["*", 2, ["pow", 2, "x"]]],
        theorem("power_of_sum", {"b": 2, "s": "x", "t": 1}, [above(2)], by(here())),
    ),
    "power_of_product": proved(
        ["=", ["pow", 6, "x"], ["*", ["pow", 2, "x"], ["pow", 3, "x"]]],
        theorem("power_of_product", {"s": 2, "t": 3, "u": "x"}, [above(2), above(3)], by(here())),
    ),
    "power_of_power": proved(
        ["=", ["pow", 4, "x"], ["pow", 2, ["*", 2, "x"]]],
        theorem("power_of_power", {"b": 2, "n": 2, "u": "x"}, [above(2)], by(here())),
    ),
    "power_inverse": proved(
        ["=", 2, ["pow", 8, ["/", 1, 3]]],
        theorem(
            "power_inverse", {"b": 2, "u": 3, "t": 8}, [above(2), implies(absurd([], [here(), "1/3"])), ID], by(here())
        ),
    ),
    "gamma": proved(
        ["=", ["gamma", ["/", 3, 2]], ["*", ["/", 1, 2], ["gamma", ["/", 1, 2]]]],
        theorem("gamma", {"t": ["/", 1, 2]}, [above(["/", 1, 2])], by(here(1))),
    ),
    "gamma_reflected": proved(
        ["=", ["*", sq(["gamma", ["/", 1, 2]]), ["sin", ["*", PI, ["/", 1, 2]]]], PI],
        theorem("gamma_reflected", {"t": ["/", 1, 2]}, [above(["/", 1, 2]), above(["/", 1, 2])], by(here())),
    ),
    "gamma_doubled": proved(
        ["=", ["*", ["gamma", 1], ["gamma", ["/", 3, 2]], ["pow", 2, 2]], ["*", 2, ["sqrt", PI], ["gamma", 2]]],
        theorem("gamma_doubled", {"t": 1}, [above(1)], by(here())),
    ),
    "unit_beta": proved(
        ["=", ["*", integral(ARCH), ["gamma", 3]], sq(["gamma", ["/", 3, 2]])],
        theorem(
            "unit_beta",
            {"f": of("x", ARCH), "c": 1, "u": ["/", 1, 2], "v": ["/", 1, 2]},
            [above(["/", 3, 2]), above(["/", 3, 2]), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "inverted": proved(
        ["=", integral(["^", "x", -2], "x", 1, OO), integral(1)],
        theorem(
            "inverted",
            {"f": of("x", ["^", "x", -2]), "g": of("x", 1), "s": 1},
            [every(["y"], implies(have([">", ["+", 1, -1, ["/", 1, "y"]], 0], above(["/", 1, "y"]), ID)))],
            by(here()),
        ),
    ),
    "moved": proved(
        ["=", ["*", 2, integral(sq(["+", ["*", 2, "x"], 1]))], integral(sq("x"), "x", 1, 3)],
        theorem(
            "moved",
            {"f": of("x", sq(["+", ["*", 2, "x"], 1])), "g": of("x", sq("x")), "a": 2, "b": 1, "s": 0, "t": 1},
            [implies(absurd([], [here(), "1/2"])), every(["y"], ID)],
            by(here()),
        ),
    ),
    "log_head": proved(
        ["=", integral(["log", "x"]), minus(["log", 1], 1)],
        theorem(
            "log_head",
            {"f": of("x", ["log", "x"]), "c": 1, "u": 0, "s": 1},
            [above(1), above(1), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "antiderivative_converges": proved(
        ["=", ["diverges", ["cos", "x"], "x", 0, PI], 0],
        theorem(
            "antiderivative_converges",
            {"f": of("x", ["cos", "x"]), "g": of("x", ["sin", "x"]), "s": 0, "t": PI},
            [theorem("circle_number", {}, [], above(PI)), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "gamma_values": proved(["=", sq(["gamma", ["/", 1, 2]]), PI], theorem("gamma_values", {}, [], by(here(1)))),
    "circle_number": proved([">", PI, 0], theorem("circle_number", {}, [], above(PI))),
    "right_half": proved(
        [">=", ["cos", 0], 0],
        theorem(
            "circle_number",
            {},
            [],
            theorem("right_half", {"a": 0}, [above(HALF_PI), above(HALF_PI)], above(["cos", 0])),
        ),
    ),
    "positive_cosine": proved(
        [">", ["cos", 0], 0],
        theorem("positive_cosine", {"a": 0}, [above(HALF_PI), above(HALF_PI)], above(["cos", 0])),
    ),
    "positive_sine": proved(
        [">", ["sin", HALF_PI], 0],
        theorem("positive_sine", {"a": HALF_PI}, [above(HALF_PI), above(HALF_PI)], above(["sin", HALF_PI])),
    ),
    "principal_value_arctan": proved(
        ["<", ["arctan", "x"], HALF_PI],
        theorem("principal_value_arctan", {"t": "x"}, [], above(minus(HALF_PI, ["arctan", "x"]))),
    ),
    "principal_value_arcsin": proved(
        ["<=", ["arcsin", 1], HALF_PI],
        theorem("principal_value_arcsin", {"t": 1}, [above(0)], above(minus(HALF_PI, ["arcsin", 1]))),
    ),
    "principal_value_arccos": proved(
        ["<=", 0, ["arccos", -1]], theorem("principal_value_arccos", {"t": -1}, [above(0)], above(["arccos", -1]))
    ),
    "first_quadrant_arctan": proved(
        ["<=", 0, ["arctan", 2]], theorem("first_quadrant_arctan", {"t": 2}, [above(2)], above(["arctan", 2]))
    ),
    "first_quadrant_arcsin": proved(
        ["<=", 0, ["arcsin", 1]], theorem("first_quadrant_arcsin", {"t": 1}, [above(0), above(1)], above(["arcsin", 1]))
    ),
    "first_quadrant_arccos": proved(
        ["<=", ["arccos", 0], HALF_PI],
        theorem("first_quadrant_arccos", {"t": 0}, [above(1), above(0)], above(minus(HALF_PI, ["arccos", 0]))),
    ),
    **{
        f"known_angle_{kind}_{k}": known(f"known_angle_{kind}_{k}", [kind, t], ["/", PI, n] if n else 0)
        for kind, k, t, n in (
            ("arctan", 0, 0, 0),
            ("arctan", 1, ["/", 1, ["sqrt", 3]], 6),
            ("arctan", 2, 1, 4),
            ("arctan", 3, ["sqrt", 3], 3),
            ("arcsin", 0, 0, 0),
            ("arcsin", 1, ["/", 1, 2], 6),
            ("arcsin", 2, ["/", ["sqrt", 2], 2], 4),
            ("arcsin", 3, ["/", ["sqrt", 3], 2], 3),
            ("arcsin", 4, 1, 2),
            ("arccos", 0, 1, 0),
            ("arccos", 1, ["/", ["sqrt", 3], 2], 6),
            ("arccos", 2, ["/", ["sqrt", 2], 2], 4),
            ("arccos", 3, ["/", 1, 2], 3),
            ("arccos", 4, 0, 2),
        )
    },
    "mean": proved(
        ["=", ["mean", sq(SIN), "x"], ["/", 1, 2]],
        theorem(
            "mean",
            {"f": of("x", sq(SIN)), "c": ["/", 1, 2], "g": of("x", ["-", ["/", ["*", SIN, COS], 2]])},
            [every(["y"], ID)],
            by(here()),
        ),
    ),
    "quarter_turn": proved(
        ["exists", ["x"], ["=", minus(sq(COS), sq(SIN)), 0]],
        theorem(
            "quarter_turn", {"f": of("y", DOUBLE)}, [every(["y"], ID)], witness({"x": "z"}, by(here())), letters=["z"]
        ),
    ),
    "intermediate_value": proved(
        ["exists", ["x"], ["=", sq("x"), 2]],
        theorem(
            "intermediate_value",
            {"f": of("x", minus(sq("x"), 2)), "s": 0, "t": 2},
            [above(2), above(4)],
            witness({"x": "z"}, by(here(2))),
            letters=["z"],
        ),
    ),
    "constant": proved(
        ["=", integral("y", "x", 0, 2), ["*", 2, "y"]], theorem("constant", {"c": "y", "s": 0, "t": 2}, [], by(here()))
    ),
    "power_rule": proved(
        ["=", integral(["*", 2, "x"], "x", 1, 2), 3],
        theorem(
            "power_rule",
            {"f": of("x", ["*", 2, "x"]), "s": 1, "t": 2, "c": 1, "g": of("x", ["+", 1, sq("x")]), "u": 1},
            [above(1), every(["y"], {**implies(each(above(["+", 1, sq("y")]), ID)), "positive": [["+", 1, sq("y")]]})],
            by(here()),
        ),
    ),
    "antiderivative": proved(
        ["=", integral(["cos", "x"], "x", 0, PI), 0],
        theorem(
            "antiderivative",
            {"f": of("x", ["cos", "x"]), "g": of("x", ["sin", "x"]), "s": 0, "t": PI},
            [theorem("circle_number", {}, [], above(PI)), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "antiderivative_everywhere": proved(
        ["=", integral(1, "x", 1, 0), -1],
        theorem(
            "antiderivative_everywhere",
            {"f": of("x", 1), "g": of("x", "x"), "s": 1, "t": 0},
            [every(["y"], ID)],
            by(here()),
        ),
    ),
    "rising": proved([">=", ["exp", "y"], 1], rising("rising", 0, "y"), [[">=", "y", 0]], at={"y": 1}),
    "rising_strictly": proved([">", ["exp", "y"], 1], rising("rising_strictly", 0, "y"), [[">", "y", 0]], at={"y": 1}),
    "telescope": proved(
        ["=", ["sum", "k", "k", 1, "n"], ["/", ["*", "n", ["+", "n", 1]], 2]],
        theorem(
            "telescope",
            {"f": of("k", "k"), "g": of("k", ["/", ["*", "k", ["+", "k", 1]], 2]), "s": 1, "t": "n"},
            [above("n"), ID, every(["y"], implies(ID))],
            by(here()),
        ),
        [[">=", "n", 0]],
        at={"n": 2},
    ),
    "full_turn": proved(
        ["=", integral(["/", 4, ["+", 5, ["*", 3, ["cos", "x"]]]], "x", 0, ["*", 2, PI]), ["*", 2, PI]],
        theorem(
            "full_turn",
            {
                "f": of("x", ["/", 4, ["+", 5, ["*", 3, ["cos", "x"]]]]),
                **{"a": 5, "b": 3, "c": 0, "u": 4, "r": 4, "s": 0},
            },
            [above(5), above(16), above(4), ID, every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "decaying": proved(
        ["=", integral(FALLING, "x", 0, OO), 1],
        theorem(
            "decaying",
            {"f": of("x", FALLING), "g": of("x", -1), "a": 1, "s": 0},
            [above(1), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "gaussian": proved(
        ["=", integral(BELL, "x", NOO, OO), ["sqrt", PI]],
        theorem(
            "gaussian",
            {"f": of("x", BELL), "g": of("x", 0), "a": 1, "b": 0, "c": 1},
            [above(1), every(["y"], ID)],
            by(here()),
        ),
    ),
    "gaussian_wave": proved(
        [
            "=",
            integral(["*", BELL, ["cos", "x"]], "x", NOO, OO),
            ["*", ["exp", ["/", -1, 4]], ["sqrt", PI]],
        ],
        theorem(
            "gaussian_wave",
            {"f": of("x", ["*", BELL, ["cos", "x"]]), "g": of("x", 0), "a": 1, "b": 0, "c": 1, "u": 1, "v": 0},
            [above(1), every(["y"], ID)],
            by(here()),
        ),
    ),
    "shifted": proved(
        ["=", integral(["exp", ["-", sq(["+", "x", 1])]], "x", NOO, OO), integral(BELL, "x", NOO, OO)],
        theorem(
            "gaussian",
            {"f": of("x", BELL), "g": of("x", 0), "a": 1, "b": 0, "c": 1},
            [above(1), every(["y"], ID)],
            theorem(
                "shifted",
                {"f": of("x", ["exp", ["-", sq(["+", "x", 1])]]), "g": of("x", BELL), "a": 1},
                [every(["y"], ID)],
                by(here(2)),
            ),
        ),
    ),
    "half_gaussian": proved(
        ["=", integral(["*", 2, BELL], "x", 0, OO), ["sqrt", PI]],
        theorem(
            "half_gaussian",
            {"f": of("x", ["*", 2, BELL]), "g": of("x", 0), "a": 1, "c": 2},
            [above(1), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "gamma_integral": proved(
        [
            "=",
            integral(["*", ["pow", "x", ["/", 1, 2]], FALLING], "x", 0, OO),
            ["*", ["gamma", ["/", 3, 2]], ["pow", 1, ["/", -3, 2]]],
        ],
        theorem(
            "gamma_integral",
            {"f": of("x", ["*", ["pow", "x", ["/", 1, 2]], FALLING]), "c": 1, "u": ["/", 1, 2], "a": 1},
            [above(1), above(["/", 3, 2]), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "head_converges": proved(
        ["=", ["diverges", ["*", ["pow", "x", ["/", -1, 2]], FALLING], "x", 0, 1], 0],
        theorem(
            "head_converges",
            {
                "f": of("x", ["*", ["pow", "x", ["/", -1, 2]], FALLING]),
                "g": of("x", FALLING),
                "u": ["/", -1, 2],
                "s": 1,
            },
            [above(1), above(["/", 1, 2]), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "tail_converges": proved(
        ["=", ["diverges", ["*", ["pow", "x", ["/", 1, 2]], FALLING], "x", 1, OO], 0],
        theorem(
            "tail_converges",
            {"f": of("x", ["*", ["pow", "x", ["/", 1, 2]], FALLING]), "c": 1, "u": ["/", 1, 2], "a": 1, "s": 1},
            [above(1), above(1), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "power_tail": proved(
        ["=", integral(["pow", "x", -2], "x", 1, OO), 1],
        theorem(
            "power_tail",
            {"f": of("x", ["pow", "x", -2]), "c": 1, "u": -2, "s": 1},
            [above(1), above(1), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "power_head": proved(
        ["=", integral(["pow", "x", 2], "x", 0, 1), ["/", 1, 3]],
        theorem(
            "power_head",
            {"f": of("x", ["pow", "x", 2]), "c": 1, "u": 2, "s": 1},
            [above(1), above(3), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "sum_of_integrals": proved(
        ["=", integral(["+", "x", 1], "x", 0, OO), ["+", integral("x", "x", 0, OO), integral(1, "x", 0, OO)]],
        theorem(
            "sum_of_integrals",
            {"f": of("x", ["+", "x", 1]), "g": of("x", "x"), "h": of("x", 1), "s": 0},
            [by(hyp()), by(hyp(1)), every(["y"], implies(ID))],
            by(here()),
        ),
        [["=", ["diverges", "x", "x", 0, OO], 0], ["=", ["diverges", 1, "x", 0, OO], 0]],
    ),
    "reflected": proved(
        ["=", integral(["exp", "x"], "x", NOO, 0), integral(FALLING, "x", 0, OO)],
        theorem(
            "reflected",
            {"f": of("x", ["exp", "x"]), "g": of("x", FALLING), "s": 0},
            [every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "scaled": proved(
        ["=", ["*", 2, integral(["exp", ["-", ["*", 2, "x"]]], "x", 0, OO)], integral(FALLING, "x", 0, OO)],
        theorem(
            "scaled",
            {"f": of("x", ["exp", ["-", ["*", 2, "x"]]]), "g": of("x", FALLING), "a": 1, "c": 2, "s": 0},
            [above(2), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "pieces": proved(
        ["=", integral(SIZE, "x", -1, 1), ["+", integral(SIZE, "x", -1, 0), integral(SIZE, "x", 0, 1)]],
        theorem("pieces", {"f": of("x", SIZE), "r": 0, "s": -1, "t": 1}, [], by(here())),
    ),
    "halves": proved(
        ["=", integral("x", "x", NOO, OO), ["+", integral("x", "x", NOO, 1), integral("x", "x", 1, OO)]],
        theorem("halves", {"f": of("x", "x"), "s": 1}, [by(hyp()), by(hyp(1))], by(here())),
        [["=", ["diverges", "x", "x", NOO, 1], 0], ["=", ["diverges", "x", "x", 1, OO], 0]],
    ),
    "sum_of_sums": proved(
        [
            "=",
            ["sum", ["+", ["*", 2, "k"], 3], "k", 1, "n"],
            ["+", ["*", 2, ["sum", "k", "k", 1, "n"]], ["*", 3, ["sum", 1, "k", 1, "n"]]],
        ],
        theorem(
            "sum_of_sums",
            {
                "f": of("k", ["+", ["*", 2, "k"], 3]),
                "g": of("k", "k"),
                "h": of("k", 1),
                "a": 2,
                "b": 3,
                "s": 1,
                "t": "n",
            },
            [every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "telescoping_product": proved(
        ["=", ["product", "k", "k", 1, "n"], ["gamma", ["+", "n", 1]]],
        theorem(
            "telescoping_product",
            {"f": of("k", "k"), "g": of("k", ["gamma", ["+", "k", 1]]), "s": 1, "t": "n"},
            [
                above("n"),
                theorem("gamma_values", {}, [], by(here())),
                every(["y"], implies(theorem("gamma", {"t": ["+", "y", 1]}, [above(["+", "y", 1])], by(here(2))))),
            ],
            by(here()),
        ),
        [[">=", "n", 0]],
        at={"n": 2},
    ),
    "exp_of_log": proved(["=", ["exp", ["log", 2]], 2], theorem("exp_of_log", {"t": 2}, [above(2)], by(here()))),
    "log_of_one": proved(["=", ["log", 1], 0], theorem("log_of_one", {}, [], by(here()))),
    "log_of_exp": proved(
        ["=", ["log", ["exp", "x"]], "x"], theorem("log_of_exp", {"t": "x"}, [], by(here())), at={"x": 1}
    ),
    "log_of_product": proved(
        ["=", ["log", 6], ["+", ["log", 2], ["log", 3]]],
        theorem("log_of_product", {"s": 2, "t": 3}, [above(2), above(3)], by(here())),
    ),
    "log_of_power": proved(
        ["=", ["log", ["pow", 2, "x"]], ["*", "x", ["log", 2]]],
        theorem("log_of_power", {"t": 2, "u": "x"}, [above(2)], by(here())),
        at={"x": 1},
    ),
    "log_of_root": proved(
        ["=", ["*", 2, ["log", ["sqrt", 3]]], ["log", 3]], theorem("log_of_root", {"t": 3}, [above(3)], by(here()))
    ),
    "power_as_exp": proved(
        ["=", ["pow", 2, "x"], ["exp", ["*", "x", ["log", 2]]]],
        theorem("power_as_exp", {"b": 2, "u": "x"}, [above(2)], by(here())),
    ),
    "circular_of_arctan": proved(
        ["=", ["*", ["sin", ["arctan", "x"]], ["sqrt", ["+", 1, sq("x")]]], "x"],
        theorem("circular_of_arctan", {"t": "x"}, [], by(here())),
        at={"x": 1},
    ),
    "circular_of_arcsin": proved(
        ["=", ["sin", ["arcsin", ["/", 1, 3]]], ["/", 1, 3]],
        theorem("circular_of_arcsin", {"t": ["/", 1, 3]}, [above(["/", 8, 9])], by(here())),
    ),
    "circular_of_arccos": proved(
        ["=", ["cos", ["arccos", ["/", 1, 3]]], ["/", 1, 3]],
        theorem("circular_of_arccos", {"t": ["/", 1, 3]}, [above(["/", 8, 9])], by(here())),
    ),
    "power_diverges": proved(
        ["=", ["diverges", "x", "x", 0, OO], 1],
        theorem(
            "power_diverges", {"f": of("x", "x"), "c": 1, "u": 1}, [NOT_ZERO, every(["y"], implies(ID))], by(here())
        ),
    ),
    "beta": proved(
        ["=", ["diverges", INTEGRAND, "x", 0, OO], 0],
        {
            **theorem(
                "beta", {**PARTS, "f": of("x", INTEGRAND)}, [above(1)] * 4 + [every(["y"], implies(ID))], by(here())
            ),
            "positive": [["+", sq("y"), 1]],
        },
    ),
    "beta_diverges": proved(
        ["=", ["diverges", "x", "x", 0, OO], 1],
        theorem(
            "beta_diverges",
            {**PARTS, "k": 1, "r": 0, "f": of("x", "x")},
            [above(1), above(1), NOT_ZERO, choose(1, above(2)), every(["y"], implies(ID))],
            by(here()),
        ),
    ),
    "even": proved(
        ["=", integral(sq("x"), "x", ["-infinity"], OO), ["*", 2, integral(sq("x"), "x", 0, OO)]],
        theorem("even", {"f": of("x", sq("x"))}, [every(["y"], ID)], by(here())),
    ),
    "odd": proved(
        ["=", integral("x", "x", ["-infinity"], OO), 0],
        theorem("odd", {"f": of("x", "x")}, [every(["y"], ID), by(hyp())], by(here())),
        [["=", ["diverges", "x", "x", 0, OO], 0]],
    ),
    "congruence": proved(
        ["=", ["exp", "x"], ["exp", "y"]],
        theorem("congruence", {"s": ["exp", "x"], "t": ["exp", "y"]}, [by(hyp())], by(here())),
        [["=", "x", "y"]],
        at={"x": 1, "y": 1},
    ),
    "enclosure": proved(
        ["<=", PI, ["/", 315, 100]], theorem("enclosure", {"t": PI, "digits": 2}, [], above(minus(["/", 315, 100], PI)))
    ),
    **{
        f"{name} {sign}{back}": angle(name, sign, back)
        for name in ANGLES
        for sign in ("=", "!=", "<", "<=", ">", ">=")
        for back in ("", " back")
    },
}
WITHOUT_A_POINT = {
    *(
        "odd",
        "even",
        "sum_of_integrals",
        "halves",
        "reflected",
        "beta",
        "scaled",
        "pieces",
    ),  # their integrals may diverge
    *(
        "decaying",
        "gaussian",
        "gaussian_wave",
        "half_gaussian",
        "shifted",
        "gamma_integral",
        "tail_converges",
        "head_converges",
        "power_tail",
        "power_head",
        "unit_beta",
        "inverted",
        "log_head",
    ),
    *(name for name in THEOREMS if name.startswith(("arctangent", "arcsine", "arccosine"))),
}


@pytest.mark.parametrize("name", RIGHT)
def test_a_rule_accepts_what_is_right(name: str) -> None:
    assert check(RIGHT[name]) is None


def test_every_rule_is_there() -> None:
    assert {name.split()[0].rstrip(",") for name in RIGHT} >= RULES.keys()
    assert THEOREMS.keys() == {*NAMES, "congruence", "enclosure"}


@pytest.mark.parametrize("name", THEOREMS)
def test_a_theorem_can_be_applied(name: str) -> None:
    """Where the hypotheses are of functions without a value at a point, all but that point is accepted."""
    assert check(THEOREMS[name]) == ("no point where all that is assumed holds" if name in WITHOUT_A_POINT else None)


def written(folder: Path, certificates: JSON, **more: JSON) -> Path:
    folder.mkdir(exist_ok=True)
    content = {"schema": 3, "paper": "test", "certificates": certificates, **more}
    (folder / "test.json").write_text(json.dumps(content), encoding="utf-8")
    return folder


LEMMA = {
    **proved(["and", ["=", "d", ["+", "x", 1]], ["=", "x", "x"]], each(ID, ID), definitions=[["d", ["+", "x", 1]]]),
    "id": "l",
}
USE = proved(
    ["=", minus("d", "x"), 1],
    implies(by(here())),
    definitions=[["d", ["+", "x", 1]]],
    lemmas=[["l", ["=", "d", ["+", "x", 1]]]],
)


def test_a_lemma_is_used_of_which_a_part_is_proved() -> None:
    assert [*check_all([USE, LEMMA])] == [None, None]
    assert check(USE) == "a lemma is not proved, or under other assumptions"


def test_a_lemma_of_a_lemma_is_looked_for() -> None:
    middle = {**USE, "id": "m"}
    last = proved(
        ["=", sq(minus("d", "x")), 1],
        implies({**by(here(), factor="d - x + 1"), "atoms": {"d": "d"}}),
        definitions=USE["definitions"],
        lemmas=[["m", USE["claim"]]],
    )
    assert [*check_all([last, middle, LEMMA])] == [None] * 3
    assert [*check_all([last, middle])] == ["a lemma is not proved, or under other assumptions"] * 2


POINTS: dict[str, JSON] = {
    "a number": refuted(["=", "x", 0], {"x": ["/", 1, 3]}, shown=[["=", "x", ["/", 1, 3]]]),
    "a root": refuted(["=", sq("x"), 3], {"x": ["sqrt", 2]}),
    "an angle": refuted(["=", SIN, 0], {"x": ["/", PI, 2]}, shown=[["=", SIN, 1], ["=", 0, 0]]),
    "an angle of an arctangent": refuted(["=", ["+", SIN, COS], 1], {"x": ["*", 2, ["arctan", 2]]}),
    "digits": refuted([">", ["arctan", "x"], 1], {"x": 1}, shown=[["<=", ["/", 78, 100], ["arctan", "x"]]]),
    "a function": refuted(["=", f("x"), 0], {"x": 1}, calls=[[f(1), 2]]),
    "a derivative of a function": refuted(
        ["=", ["diff", f("x"), "x", 1, "x"], f("x")], {"x": 1}, calls=[[f(1), 0], [f(1, orders=[1]), 1]]
    ),
    "a hypothesis": refuted(["=", "x", 1], {"x": 2}, [[">", "x", 1]]),
    "what must not vanish": refuted(["=", ["/", "x", "x"], 2], {"x": 2}, nonzero=["x"]),
    "a definition": refuted(["=", "d", 0], {"x": 0}, definitions=[["d", ["+", "x", 1]]]),
    "a proof": refuted(
        ["exists", ["y"], ["<", sq("y"), "x"]], {"x": 0}, proof=each(every(["z"], above(sq("z"), [["point", 0], "-1"])))
    ),
    "an integral": refuted(["=", integral(1), 2], {}, proof=constant(1, compute(here()))),
}


@pytest.mark.parametrize("name", POINTS)
def test_a_point_refutes(name: str) -> None:
    assert check(POINTS[name]) is None


def test_every_coordinate_counts() -> None:
    made = refuted(["=", ["+", "x", "y"], 3], {"x": 1, "y": 1}, shown=[["=", ["+", "x", "y"], 2]])
    assert check(made) is None
    for x in ("x", "y"):
        values = {**made["point"]["values"], x: 5}
        assert check({**made, "point": {"values": values, "shown": made["point"]["shown"]}})
        del values[x]
        assert check({**made, "point": {"values": values}}) == f"no value for {x}"


def test_every_random_prime_is_another_and_no_number_is_zero_in_every_run() -> None:
    for _ in range(3):
        prime = residues.prime()
        assert prime.bit_length() > 250
        assert prime != residues.PRIME
        assert check(proved(["=", prime, 0], ID))


def test_the_roots_the_checker_computes_with_are_positive() -> None:
    assert residues.root((9, 4)) * 2 % residues.PRIME == 3
    assert residues.root((0, 1)) == 0
    for number in ((47, 1), (47 * 47, 1), (-1, 1), (1, 53), None):
        with pytest.raises(residues.Reject):
            residues.root(number)
    value = Algebra({}).value(node("*", node("sqrt", 2), node("sqrt", 3)))
    assert (value - Algebra({}).value(node("sqrt", 6))) % residues.PRIME == 0


@pytest.mark.parametrize("number", [Fraction(0), Fraction(-3, 7), Fraction(10**20, 3), Fraction(-(2**90), 2**80 + 1)])
def test_a_number_is_found_from_its_residue(number: Fraction) -> None:
    value = number.numerator * residues.inverse(number.denominator)
    assert residues.rational(value) == number.as_integer_ratio()


NO_POLYNOMIALS = (
    *("", "-", "x^-1", "x^1000", "x^y", "x^2^2", "x/2", "2^3", "1/0", "1/x", "1/2/3", "x y", "(x)", "x^½", "2x", "x^"),
    *("1/", "x^ 2", "1_0", "x.y", "x\n"),
)


@pytest.mark.parametrize("text", NO_POLYNOMIALS)
def test_what_is_no_printed_polynomial_is_rejected(text: str) -> None:
    for rest in ("", " + y", " - 1", "*y"):
        assert check(proved(["=", 0, 1], by(hyp(), factor=text + rest), [["=", 1, 0]]))
        with pytest.raises(residues.Reject):
            POLYNOMIAL(text + rest)


def test_a_printed_polynomial_has_the_value_of_the_term() -> None:
    term = ["+", ["*", ["/", -3, 4], ["^", "x", 2], "y"], ["*", -1, "y"], "x", ["-", ["/", 5, 7]], 2]
    value = Algebra({}).value(Reader().term(term))
    assert POLYNOMIAL("-3/4*x^2*y - y + x - 5/7 + 2") == value % residues.PRIME


def test_a_letter_is_free_in_one_certificate_and_defined_in_the_next() -> None:
    for _ in range(2):
        assert check(proved(["=", ["+", "x", "x"], ["*", 2, "x"]], ID)) is None
        assert check(proved(["=", "x", 5], ID, definitions=[["x", 5]])) is None
        assert check(proved(["=", ["*", "x", "y"], ["*", 6, "y"]], ID, definitions=[["x", 6]])) is None
        assert check(proved(["=", "x", 5], ID))


CORE = {
    f"symcheck.core.{name}" for name in ("calculus", "fields", "formulas", "matrices", "terms")
}  # that has to be trusted


def imports(path: Path) -> set[str]:
    """The modules that a file imports, those for type checkers left out."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    body = (each for each in tree.body if not isinstance(each, ast.If) or ast.unparse(each.test) != "TYPE_CHECKING")
    found: set[str] = set()
    for node_ in (part for statement in body for part in ast.walk(statement)):
        found |= {node_.module or ""} if isinstance(node_, ast.ImportFrom) else set()
        found |= {alias.name for alias in node_.names} if isinstance(node_, ast.Import) else set()
    return found


@pytest.mark.parametrize("folder", ["checker", "core"])
def test_the_checker_imports_the_standard_library_only(folder: str) -> None:
    files = sorted((ROOT / "symcheck" / folder).glob("*.py"))
    imported = set[str]().union(*map(imports, files))
    own = {name for name in imported if name.startswith(("symcheck.checker", "symcheck.core"))}
    assert {name.split(".")[0] for name in imported - own} <= set(sys.stdlib_module_names)


def test_what_has_to_be_trusted_is_five_modules_beside_the_checker() -> None:
    trusted = [*(ROOT / "symcheck" / "checker").glob("*.py")]
    trusted += [ROOT / f"{name.replace('.', '/')}.py" for name in CORE]
    own = {name for path in trusted for name in imports(path) if name.startswith("symcheck")}
    assert {name for name in own if not name.startswith("symcheck.checker")} <= CORE


BLOCKED = """
import os, runpy, sys
class Block:
    def find_spec(self, name, path=None, target=None):
        if name.split('.')[0] in ('sympy', 'numpy', 'flint', 'mpmath', 'lark'):
            raise ImportError(name + ' is blocked')
sys.meta_path.insert(0, Block())
sys.path.insert(0, ROOT)
sys.argv = ['checker', sys.argv[2]]
def end(code):
    loaded = {name for name in sys.modules if name.startswith('symcheck.')}
    assert {name for name in loaded if not name.startswith('symcheck.checker')} <= {'symcheck.core', *CORE}, loaded
    sys.exit(code)
os._exit = end
runpy.run_module('symcheck.checker', run_name='__main__')
raise AssertionError('the checker has not ended the process')
"""


def test_the_checker_runs_where_nothing_else_can_be_imported(tmp_path: Path) -> None:
    folder = written(tmp_path / "certificates", [RIGHT["identity"], POINTS["a root"]])
    program = BLOCKED.replace("ROOT", repr(str(ROOT))).replace("CORE", repr(sorted(CORE)))
    command = [sys.executable, "-I", "-S", "-c", program, "-", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("2 certificates, all hold")


def test_a_failure_is_named_and_the_exit_code_is_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bad = {**proved(["=", "x", 0], ID), "id": "2.12"}
    assert main([str(written(tmp_path / "c", [RIGHT["identity"], bad]))]) == 1
    out = capsys.readouterr().out
    assert "2.12: left - right is not the combination" in out
    assert "2 certificates, 1 does not hold" in out


def test_an_outcome_that_cannot_be_written_is_told_in_one_line(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "symcheck.checker", str(written(tmp_path / "c", [RIGHT["identity"]]))]
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False, cwd=ROOT)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "the outcome cannot be written" in done.stderr


DAMAGED = {
    "half a file": '{"schema": 3, "certificates": [',
    "another schema": '{"schema": 1, "certificates": [{}]}',
    "no schema": '{"certificates": [{}]}',
    "no object": "[]",
    "no list": '{"schema": 3, "certificates": 5}',
    "nothing": '{"schema": 3, "certificates": []}',
    "a key twice": '{"schema": 3, "schema": 3, "certificates": [{}]}',
    "an empty file": "",
    "not text": "\udcff",
    "deep": "[" * 100_000,
}


@pytest.mark.parametrize("content", DAMAGED.values(), ids=DAMAGED)
def test_a_damaged_file_is_told_in_one_line(content: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.json").write_bytes(content.encode("utf-8", "surrogateescape"))
    assert main([str(tmp_path)]) == 2
    captured = capsys.readouterr()
    assert captured.err.startswith("checker: ")
    assert captured.err.count("\n") == 1


@pytest.mark.parametrize("certificate", [{}, 7, None, [], "x"])
def test_what_is_no_certificate_does_not_hold(certificate: JSON, tmp_path: Path) -> None:
    assert main([str(written(tmp_path / "c", [certificate]))]) == 1


def test_missing_folders_are_told_in_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(tmp_path / "nowhere")]) == 2
    assert capsys.readouterr().err.count("\n") == 1


MALFORMED: dict[str, JSON] = {
    "a number": 7,
    "empty": [],
    "a word": "x",
    "no right side": ["=", "x"],
    "an unknown sign": ["~", "x", "y"],
    "three sides": ["=", "x", "x", "x"],
    "deep": ["=", *[json.loads("[" * 900 + "1" + "]" * 900)] * 2],
}


@pytest.mark.parametrize("claim", MALFORMED.values(), ids=MALFORMED)
def test_a_malformed_claim_is_rejected_without_an_exception(claim: JSON) -> None:
    assert check(proved(claim, ID))
    assert check(refuted(claim, {"x": 1}))
