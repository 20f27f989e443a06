"""Random certificates, most of them wrong, and whether what the checker accepts is so by `meaning`.

`python tests/soundness.py 100000 SEED` counts what is accepted and rejected, and prints what is accepted and false.
"""

from __future__ import annotations

import json
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from mpmath import mpf

from symcheck.checker import check_all
from symcheck.checker.algebra import Algebra
from symcheck.checker.residues import PRIME, Reject
from symcheck.checker.theorems import NAMES, instance, theorem
from symcheck.coq.meaning import BINDERS, Meaning, NoValue, Smooth
from symcheck.core.calculus import Unknown, differentiated
from symcheck.core.terms import Malformed, Reader

JSON = Any
LETTERS = ("x", "y", "a", "sin_x", "pi", "sqrt_2", "x_0")  # names as of values, and as substitution makes them
BOUND = ("x", "y", "sin_x", "t")
STRANGE = (None, True, 1.0, "", "infinity", ["infinity"], ["-infinity"], [], ["pi", 1], "_", "x y", ["=", "x", 0])
ORDERS = ("=", "!=", "<", "<=", ">", ">=")
IDENTITY: JSON = {"rule": "identity"}
HERE: JSON = {"rule": "identity", "cofactors": [[["here", 0], "1"]]}


class Forger:
    """Certificates by chance. Each method that draws one leaves it to the checker whether it is right."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)
        self.met: dict[int, JSON] = {}  # a term for each value that the checker gave

    def chance(self, probability: float) -> bool:
        return self.rng.random() < probability

    def letter(self) -> str:
        return self.rng.choice(LETTERS)

    def number(self) -> JSON:
        return self.rng.choice((0, 1, 2, 3, -1, -2, ["/", 1, 2], ["/", -2, 3], ["sqrt", 2], 4))

    def whole(self) -> int:
        return self.rng.choice((0, 1, 2, 3, -1, -2))

    def term(self, depth: int = 2, letters: tuple[str, ...] = LETTERS) -> JSON:
        if self.chance(0.003):
            return self.rng.choice(STRANGE)
        if depth == 0 or self.chance(0.2):
            return self.rng.choice(letters) if self.chance(0.7) else self.number()

        def part() -> JSON:
            return self.term(depth - 1, letters)

        kind = self.rng.random()
        if kind < 0.25:
            return ["+", part(), part()]
        if kind < 0.5:
            return ["*", part(), part()]
        if kind < 0.56:
            return ["-", part()]
        if kind < 0.62:
            return ["/", part(), part()]
        if kind < 0.7:
            return ["^", part(), self.whole()]
        if kind < 0.86:
            return [
                self.rng.choice(("sin", "cos", "sin", "cos", "tan", "sqrt", "exp", "log", "arctan", "arcsin")),
                part(),
            ]
        if kind < 0.89:
            return ["pow", part(), part()]
        if kind < 0.9:
            return ["pi"]
        if kind < 0.95:
            return self.call(part)
        return self.binder(depth, letters)

    def call(self, part: Any) -> JSON:
        number = self.rng.choice((1, 1, 2))
        return [
            "call",
            self.rng.choice("fgx"),
            [self.rng.choice((0, 0, 1)) for _ in range(number)],
            *(part() for _ in range(number)),
        ]

    def binder(self, depth: int, letters: tuple[str, ...]) -> JSON:
        x = self.rng.choice(BOUND)
        body, end = self.term(depth - 1, (x, x, *letters)), self.term(0, letters)
        match self.rng.randrange(6):
            case 0 | 1:
                return ["mean", body, x]
            case 2:
                return ["integral", body, x, 0, end if self.chance(0.6) else 1]
            case 3:
                return [self.rng.choice(("sum", "product")), body, x, 1, self.rng.choice((3, end))]
            case _:
                return ["diff", body, x, self.rng.choice((1, 1, 2)), end]

    def same(self, node: JSON) -> JSON:
        """The term written in another way."""
        if not isinstance(node, list) or not node or self.chance(0.15):
            return self.around(node)
        tag, rest = node[0], node[1:]
        if tag in ("+", "*") and len(rest) == 2:
            one, other = self.same(rest[0]), self.same(rest[1])
            if tag == "*" and isinstance(one, list) and one[:1] == ["+"]:
                return ["+", *(["*", each, other] for each in one[1:])]
            return [tag, other, one] if self.chance(0.6) else [tag, one, other]
        if tag in ("-", "/", "sin", "cos", "tan", "sqrt", "exp", "log", "arctan", "arcsin", "pow"):
            if tag in ("sin", "cos") and self.chance(0.4):
                return self.turned(tag, rest[0])
            return [tag, *map(self.same, rest)]
        if tag == "^" and len(rest) == 2 and rest[1] == 2:
            return ["*", rest[0], self.same(rest[0])]
        if tag == "diff":
            return self.derived(node)
        if tag in ("mean", "integral", "sum", "product") and len(rest) > 1:
            y = self.rng.choice(BOUND)
            body = self.same(rest[0])
            return [
                tag,
                put(body, rest[1], y) if self.chance(0.5) else body,
                y if self.chance(0.5) else rest[1],
                *rest[2:],
            ]
        return node

    def around(self, node: JSON) -> JSON:
        """More work for the same value, or nearly so."""
        t = self.term(1)
        return self.rng.choice((
            node, node, node, ["+", node, 0], ["*", 1, node], ["+", ["+", node, t], ["-", t]], ["/", ["*", node, t], t],
            ["-", ["-", node]], ["*", node, ["+", ["^", ["sin", t], 2], ["^", ["cos", t], 2]]], ["^", node, 1],
            ["diff", ["*", "x", node], "x", 1, t], ["sqrt", ["^", node, 2]], ["pow", node, 1], ["^", ["sqrt", node], 2],
        ))  # fmt: skip

    def turned(self, tag: str, angle: JSON) -> JSON:
        quarter = ["+", angle, ["/", ["pi"], self.rng.choice((2, 2, -2, 1, 3))]]
        half = ["/", angle, 2]
        return self.rng.choice((
            ["cos", quarter] if tag == "sin" else ["sin", quarter], ["-", [tag, ["+", angle, ["pi"]]]],
            ["*", 2, ["sin", half], ["cos", half]], ["-", [tag, ["-", angle]]], [tag, ["-", angle]],
            [tag, ["+", angle, ["*", self.rng.choice((2, 4, 1)), ["pi"]]]],
        ))  # fmt: skip

    def derived(self, node: JSON) -> JSON:
        """What the checker itself says that the derivative is."""
        try:
            return plain(differentiated(Reader().term(node)))  # type: ignore[arg-type]
        except (Unknown, Malformed, ArithmeticError, ValueError, TypeError, AttributeError):
            return node

    def changed(self, node: JSON) -> JSON:
        """One place of a tree changed."""
        places = [*spots(node)]
        if not places:
            return node
        path = self.rng.choice(places)
        old = at(node, path)
        if isinstance(old, str) and old in ORDERS:
            new: JSON = self.rng.choice(ORDERS)
        elif isinstance(old, str) and path and path[-1] == 0:
            new = self.rng.choice(("sin", "cos", "+", "*", "and", "or", "=>", "mean"))
        elif isinstance(old, str):
            new = self.rng.choice((*LETTERS, *BOUND))
        elif isinstance(old, int):
            new = old + self.rng.choice((1, -1))
        else:
            new = self.term(1) if self.chance(0.7) else old[-1] if isinstance(old, list) and old else old
        return replaced(node, path, new)

    def relation(self, sign: str | None = None) -> JSON:
        sign = sign or self.rng.choice(ORDERS)
        t = self.term()
        u = self.same(t) if self.chance(0.6) else self.term(1)
        return [sign, t, self.changed(u) if self.chance(0.2) else u]

    def form(self, goal: JSON) -> JSON:
        """The difference as it is, or as a square, or what a fact may know the sign of."""
        sign, left, right = (*goal, 0, 0)[:3]
        large, small = (right, left) if sign in ("<", "<=") else (left, right)
        gap = large if small == 0 else ["+", large, ["-", small]]
        return self.rng.choice(
            (gap, gap, gap, large, ["^", self.letter(), 2], 1, 0, self.term(1), ["+", ["^", small, 2], 1])
        )

    def cofactors(self, facts: list[JSON]) -> JSON:
        names = [*facts, ["here", 0], ["here", 1]]
        return [
            [self.rng.choice(names), self.rng.choice(("1", "-1", "1", "2", self.letter(), "x - y"))]
            for _ in range(self.rng.choice((0, 1, 1, 2)))
        ]

    def proof(self, goal: JSON, facts: list[JSON], depth: int = 3) -> JSON:
        """A step for the goal, by its form; now and then any other."""
        tag = goal[0] if isinstance(goal, list) and goal else "="
        kind = self.rng.random()
        if kind < 0.08 and depth:
            return self.any_step(goal, facts, depth)
        if tag == "and" and depth:
            return {"rule": "each", "parts": [self.proof(part, facts, depth - 1) for part in goal[1:]]}
        if tag == "<=>" and depth:
            both = [["=>", goal[1], goal[2]], ["=>", goal[2], goal[1]]]
            return {"rule": "each", "parts": [self.proof(part, facts, depth - 1) for part in both]}
        if tag == "=>" and depth:
            return {"rule": "implies", "then": self.proof(goal[2], [*facts, ["here", 0]], depth - 1)}
        if tag == "or" and depth and len(goal) > 1:
            k = self.rng.randrange(len(goal) - 1)
            return {"rule": "choose", "index": k, "then": self.proof(goal[k + 1], facts, depth - 1)}
        if tag == "forall" and depth:
            new = self.rng.choice((*goal[1], "y", "t", "u", "v", "w"))
            body = put(goal[2], goal[1][0], new)
            return {"rule": "every", "letters": [new], "then": self.proof(body, facts, depth - 1)}
        if tag == "exists" and depth:
            value = self.term(1)
            body = put(goal[2], goal[1][0], value)
            return {"rule": "witness", "point": {goal[1][0]: value}, "then": self.proof(body, facts, depth - 1)}
        if tag in ("<", "<=", ">", ">=") and kind < 0.8:
            step = {"rule": "nonnegative", "form": self.form(goal)}
            return step if self.chance(0.6) else {**step, "cofactors": self.cofactors(facts)}
        if tag == "!=" and depth and kind < 0.8:
            return {
                "rule": "implies",
                "then": {"rule": "absurd", "times": facts[:1], "cofactors": self.cofactors(facts)},
            }
        if kind > 0.93:
            return {"rule": "compute"}
        return IDENTITY if self.chance(0.5) else {"rule": "identity", "cofactors": self.cofactors(facts)}

    def any_step(self, goal: JSON, facts: list[JSON], depth: int) -> JSON:
        def more() -> JSON:
            return self.proof(goal, [*facts, ["here", 0]], depth - 1)

        names: list[JSON] = [*facts, ["here", 0], ["here", 1]]
        match self.rng.randrange(7):
            case 0:
                formula = self.relation()
                return {"rule": "have", "formula": formula, "proof": self.proof(formula, facts, 1), "then": more()}
            case 1:
                bases = [[self.letter(), self.rng.choice((1, 1, 2, 0))] for _ in range(self.rng.choice((1, 2)))]
                return {
                    "rule": "split", "form": ["*", *(["^", *base] for base in bases)],
                    "cofactors": self.cofactors(facts), "cases": [more() for _ in bases],
                }  # fmt: skip
            case 2:
                form = ["+", ["^", self.letter(), 2], self.term(1)]
                return {"rule": "vanish", "form": form, "cofactors": self.cofactors(facts), "then": more()}
            case 3:
                return {"rule": "absurd", "times": self.rng.sample(names, 1), "cofactors": self.cofactors(facts)}
            case 4:
                return {"rule": "cases_or", "or": self.rng.choice(names), "cases": [more(), more()]}
            case 5:
                return {**more(), "positive": [self.term(1)], "atoms": {self.letter(): self.term(1)}}
            case _:
                return self.theorem(goal, facts, depth)[0]

    def arguments(self, name: str) -> dict[str, JSON]:
        """Of a theorem: now and then such as it asks for."""
        given: dict[str, JSON] = {}
        for parameter in theorem(name).parameters:
            if parameter in ("n", "k") and self.chance(0.97):
                given[parameter] = self.whole()
            elif parameter in ("f", "g", "h") and self.chance(0.98):
                x = self.rng.choice(BOUND)
                given[parameter] = {"letter": x, "term": self.shape(name, parameter, x)}
            else:
                given[parameter] = self.term(self.rng.choice((0, 0, 1, 2)))
        if self.chance(0.6):
            self.fit(name, given)
        return given

    def fit(self, name: str, given: dict[str, JSON]) -> None:
        """Arguments such as the premises ask for, or nearly."""
        if name.startswith("arc") or "_arc" in name:
            sign = ["-", 1] if self.chance(0.3) else 1
            given["t"] = self.rng.choice(
                (0, 1, -1, ["/", 1, 2], ["/", -2, 3], ["sin", "x"], ["cos", "a"], ["*", sign, "y"])
            )
            kind = {"arct": "arctan", "arcs": "arcsin", "arcc": "arccos"}.get(name[:4], "arctan")
            angle = [kind, given["t"]]
            if "a" in given:
                given["a"] = self.rng.choice((angle, angle, 0, ["/", ["pi"], 2], ["/", ["pi"], -3], ["/", "x", 4]))
        if name == "equal_squares":
            given["s"], given["t"] = self.rng.choice((("x", ["sqrt", ["^", "x", 2]]), ("x", "x"), (2, 2), ("x", "y")))
        if name == "power_inverse":
            given["t"] = ["pow", given["b"], given["u"]]
        if name == "intermediate_value":
            given["s"], given["t"] = self.rng.choice(((-1, 2), (0, 3), ("x", ["+", "x", 5]), (["-", "y"], "y")))
        if name == "intermediate_value":
            given["f"] = {"letter": "x", "term": ["+", ["^", "x", self.rng.choice((1, 2, 3))], self.number()]}
        if name == "power_rule":
            given["s"], given["t"] = self.rng.choice(((1, 2), (0, 1), (0, "y"), ("x", ["+", "x", 1]), (-1, 1)))
            given["c"], given["u"] = self.number(), self.rng.choice((2, ["/", 1, 2], -1, "a"))
        if name == "quarter_turn":
            s, c = ["sin", "x"], ["cos", "x"]
            double = ["+", ["^", c, 2], ["-", ["^", s, 2]]]
            given["f"] = {"letter": "x", "term": ["+", ["*", self.term(1), double], ["*", self.number(), s, c]]}
        if name in ("positive_cosine", "positive_sine"):
            given["a"] = self.rng.choice(
                (["/", ["pi"], 3], ["/", ["pi"], -4], 0, ["pi"], ["arctan", "x"], ["+", "x", 1])
            )
        if name == "full_turn":
            a, b, c, r = self.rng.choice(
                ((5, 3, 0, 4), (3, 2, 2, 1), (2, 1, 0, ["sqrt", 3]), (1, 2, 0, 1), (5, 3, 0, -4))
            )
            given |= {"a": a, "b": b, "c": c, "r": r, "u": self.number(), "s": self.rng.choice((0, ["-", ["pi"]], 1))}
            below = ["+", a, ["*", b, ["cos", "x"]], ["*", c, ["sin", "x"]]]
            given["f"] = {"letter": "x", "term": ["/", given["u"], below]}
        if name in ("even", "odd"):
            k = self.rng.choice((0, 2) if name == "even" else (1, 3))
            bottom = ["+", ["^", "x", 2], self.rng.choice((1, 2, "a"))]
            given["f"] = {
                "letter": "x",
                "term": ["*", self.number(), ["^", "x", k], ["pow", bottom, self.rng.choice((-3, -1))]],
            }
        if name == "mean" and isinstance(given.get("g"), dict):
            x, body = given["g"]["letter"], given["g"]["term"]
            given["f"] = {"letter": x, "term": ["+", given["c"], self.derived(["diff", body, x, 1, x])]}
        if name == "power_rule" and isinstance(given.get("g"), dict):
            x, body = given["g"]["letter"], ["*", given["c"], ["pow", given["g"]["term"], given["u"]]]
            given["f"] = {"letter": x, "term": self.derived(["diff", body, x, 1, x])}
        if name in ("antiderivative", "antiderivative_converges", "rising", "rising_strictly"):
            given["s"], given["t"] = self.rng.choice(((1, 2), (0, 1), (0, "y"), ("x", ["+", "x", 1]), (-1, 1)))
        if name.startswith("antiderivative") and isinstance(given.get("g"), dict):
            x, body = given["g"]["letter"], given["g"]["term"]
            given["f"] = {"letter": x, "term": self.derived(["diff", body, x, 1, x])}
        if name == "telescope":
            given["s"], given["t"] = self.rng.choice(((1, 3), (0, 4), (2, 2), (-1, 2), (3, 2), (1, -1)))
            step, power = self.number(), self.rng.choice((1, 2))
            begun = ["+", ["+", "x", ["-", given["s"]]], 1]
            given["g"] = {"letter": "x", "term": ["*", step, ["^", begun, power]]}
            given["f"] = {"letter": "x", "term": [step, ["*", step, ["+", ["*", 2, begun], -1]]][power - 1]}
        if name == "telescoping_product":
            given["s"], given["t"] = self.rng.choice(((1, 3), (0, 2), (2, 2), (3, 2), (1, -1)))
            factor, count = self.number(), ["+", ["+", "x", ["-", given["s"]]], 1]
            begun, odd = ["+", count, 1], ["+", ["*", 2, count], -1]
            whole, each = self.rng.choice((
                (begun, ["/", begun, count]), (["gamma", begun], count), (["pow", 2, count], 2),
                (["exp", count], ["exp", 1]), (["exp", ["^", count, 2]], ["exp", odd]),
            ))  # fmt: skip
            given["g"] = {"letter": "x", "term": whole}
            given["f"] = {"letter": "x", "term": each if self.chance(0.8) else ["*", factor, each]}
        if name in ("decaying", "gaussian", "gaussian_wave", "half_gaussian") and isinstance(given.get("g"), dict):
            self.decay(name, given)
        if name in ("gamma_integral", "tail_converges", "power_tail", "power_head"):
            given["u"] = self.rng.choice((1, 2, ["/", 1, 2], ["/", -1, 2], -2, ["-", "a"], ["/", -5, 2], 0))
            given |= {p: self.rng.choice((1, 2, 3, ["/", 1, 2], "a", 0, -1)) for p in "as" if p in given}
            more = [["exp", ["-", ["*", given["a"], "x"]]]] if "a" in given else []
            given["f"] = {"letter": "x", "term": ["*", given["c"], ["pow", "x", given["u"]], *more]}
        if name in ("sum_of_integrals", "reflected", "halves"):
            bodies = [["*", self.number(), ["exp", ["-", ["^", "x", 2]]]], ["pow", ["+", ["^", "x", 2], 1], -2]]
            bodies += [["*", "x", bodies[0]], ["exp", ["-", "x"]], ["sin", "x"]]
            given |= {p: {"letter": "x", "term": self.rng.choice(bodies)} for p in "fgh" if p in given}
            given["s"] = self.rng.choice((0, 1, -2, ["/", 1, 3]))
            if name == "sum_of_integrals":
                given["f"] = {"letter": "x", "term": ["+", given["g"]["term"], given["h"]["term"]]}
            if name == "reflected":
                given["f"] = {"letter": "x", "term": put(given["g"]["term"], "x", ["-", "x"])}
        if name in ("gamma_reflected", "gamma_doubled"):
            given["t"] = self.rng.choice((1, 2, -1, ["/", 1, 2], ["/", -1, 2], ["/", 1, 3], "a", ["/", "x", 7]))
        if name in ("unit_beta", "log_head"):
            given |= {p: self.rng.choice((1, 0, -1, ["/", 1, 2], ["/", -1, 2], "a", -2)) for p in "uvs" if p in given}
            rest = ["pow", ["+", 1, ["-", "x"]], given["v"]] if name == "unit_beta" else ["log", "x"]
            given["f"] = {"letter": "x", "term": ["*", given["c"], ["pow", "x", given["u"]], rest]}
        if name == "inverted":
            given["s"] = self.rng.choice((0, 1, 2, ["/", 1, 2], -1))
            bodies = [["^", ["+", "x", self.number()], -self.rng.choice((1, 2, 3))], ["exp", ["-", "x"]]]
            bodies += [["*", ["pow", "x", -2], ["log", "x"]], ["/", "x", ["+", 2, ["^", "x", 4]]], "x"]
            given["f"] = {"letter": "x", "term": self.rng.choice(bodies)}
            there = put(given["f"]["term"], "x", ["+", given["s"], -1, ["/", 1, "x"]])
            given["g"] = {"letter": "x", "term": ["/", there, ["^", "x", 2]] if self.chance(0.9) else there}
        if name == "moved":
            given |= {p: self.rng.choice((0, 1, -1, 2, ["/", -1, 2], "y")) for p in "abst"}
            bodies = [["^", "x", 3], ["exp", "x"], ["sin", "x"], ["^", ["+", 1, ["^", "x", 2]], -1]]
            given["g"] = {"letter": "x", "term": self.rng.choice(bodies)}
            inner = put(given["g"]["term"], "x", ["+", ["*", given["a"], "x"], given["b"]])
            given["f"] = {"letter": "x", "term": inner}
        if name == "shifted":
            bodies = [["exp", ["-", ["^", "x", 2]]], ["pow", ["+", ["^", "x", 2], 1], -2], "x", ["sin", "x"]]
            given |= {"a": self.number(), "g": {"letter": "x", "term": self.rng.choice(bodies)}}
            given["f"] = {"letter": "x", "term": put(given["g"]["term"], "x", ["+", "x", given["a"]])}
        if name == "head_converges":
            given["u"] = self.rng.choice((1, 2, ["/", 1, 2], ["/", -1, 2], -1, ["/", -3, 2], 0))
            bodies = (1, ["exp", ["-", "x"]], ["cos", "x"], ["+", "x", 1], ["/", 1, "x"])
            given |= {"s": self.rng.choice((1, 2, "a")), "g": {"letter": "x", "term": self.rng.choice(bodies)}}
            given["f"] = {"letter": "x", "term": ["*", ["pow", "x", given["u"]], given["g"]["term"]]}
        if name == "scaled":
            given |= {p: self.rng.choice((1, 2, ["/", 1, 2], 3)) for p in "ac"} | {"s": self.rng.choice((0, 1, -1))}
            bodies = [["exp", ["-", "x"]], ["*", "x", ["exp", ["-", ["^", "x", 2]]]], ["sin", "x"]]
            bodies.append(["pow", ["+", ["^", "x", 2], 1], -2])
            given["g"] = {"letter": "x", "term": self.rng.choice(bodies)}
            inner = put(given["g"]["term"], "x", ["*", given["c"], "x"])
            given["f"] = {"letter": "x", "term": ["*", given["a"], inner]}
        if name == "pieces":
            given |= {p: self.rng.choice((0, 1, -1, 2, ["/", -1, 2], "y")) for p in "rst"}
            away = ["sqrt", ["^", ["+", "x", self.number()], 2]]
            shapes = (away, ["*", "x", away], ["sin", away], ["exp", ["-", away]], ["^", ["cos", "x"], 2])
            given["f"] = {"letter": "x", "term": self.rng.choice(shapes)}
        if name == "sum_of_sums" and all(isinstance(given[p], dict) for p in "gh"):
            given["s"], given["t"] = self.rng.choice(((1, 3), (0, 4), (2, 2), (-1, 2), (3, 1)))
            parts = [["*", given[n], put(given[p]["term"], given[p]["letter"], "x")] for n, p in ("ag", "bh")]
            given["f"] = {"letter": "x", "term": ["+", *parts]}
        if name in ("beta", "beta_diverges"):
            self.integrand(given)
        if name == "power_diverges":
            given["u"] = self.number()
            given["f"] = {"letter": "x", "term": ["*", given["c"], ["pow", "x", given["u"]]]}

    def decay(self, name: str, given: dict[str, JSON]) -> None:
        """The derivative of an exponential times g, and what is left of a Gaussian."""
        given["a"] = self.rng.choice((1, 2, ["/", 1, 2], "a", -1, 0))
        given |= {p: self.number() if p != "s" else self.rng.choice((0, 1, -2, "y")) for p in "bcs" if p in given}
        x, g = given["g"]["letter"], given["g"]["term"]
        square = ["-", ["*", given["a"], ["^", x, 2]]]
        linear = ["*", given.get("b", 0), x]
        exponent = ["-", ["*", given["a"], x]] if name == "decaying" else ["+", linear, square]
        rate = self.derived(["diff", ["*", ["exp", exponent], g], x, 1, x])
        rest = [] if name == "decaying" else [["*", given["c"], ["exp", exponent]]]
        if name == "gaussian_wave":
            given |= {p: self.rng.choice((0, 1, 2, ["/", -1, 2])) for p in "uv"}
            rest[0].append(["cos", ["+", ["*", given["u"], x], given["v"]]])
        given["f"] = {"letter": x, "term": ["+", rate, *rest]}

    def integrand(self, given: dict[str, JSON]) -> None:
        """c x^k x^u (p x^2 + q)^-r."""
        for parameter in "urpqc":
            given[parameter] = self.rng.choice((1, 2, 1, ["/", 1, 2])) if self.chance(0.9) else self.term(1)
        given["k"] = self.rng.choice((0, 0, 1, 2, -1))
        c, k, u, r, p, q = (given[parameter] for parameter in "ckurpq")
        sum_ = ["+", ["*", p, ["^", "x", 2]], q]
        given["f"] = {"letter": "x", "term": ["*", c, ["^", "x", k], ["pow", "x", u], ["pow", sum_, ["-", r]]]}

    def shape(self, name: str, parameter: str, x: str) -> JSON:
        s, c, k = ["sin", x], ["cos", x], self.rng.choice((1, 1, 2, 3))
        free = self.term(1)
        wave = ["+", ["*", free, ["^", s, k]], ["*", self.number(), ["^", c, self.rng.choice((1, 1, 3))]]]
        polynomial = ["+", ["*", free, ["^", x, k]], self.number()]
        odd = ["*", free, ["^", x, k]]
        decay = ["*", odd, ["pow", ["+", ["^", x, 2], 1], -3]]
        usual = {
            "mean": wave, "quarter_turn": wave, "intermediate_value": polynomial, "power_rule": polynomial,
            "even": decay, "odd": decay,
        }  # fmt: skip
        return usual.get(name, polynomial) if self.chance(0.75) else self.term(2, (x, x, *LETTERS))

    def theorem(self, goal: JSON, facts: list[JSON], depth: int = 2) -> tuple[JSON, JSON]:
        """A step that applies a theorem, and what it says."""
        name = self.rng.choice(
            (
                *NAMES,
                "congruence",
                "enclosure",
                "mean",
                "quarter_turn",
                "constant",
                "even",
                "odd",
                "beta",
                "beta_diverges",
            )
        )
        step: dict[str, JSON] = {"rule": "theorem", "of": name}
        if name == "congruence":
            t = self.rng.choice(
                (["sin", self.term(1)], self.call(lambda: self.term(1)), ["pow", self.term(1), self.term(1)])
            )
            step["with"] = {"s": t, "t": self.same(t) if self.chance(0.7) else self.term(1)}
            premises, conclusion = [["=", one, other] for one, other in zip(t[1:], t[1:], strict=True)], goal
        elif name == "enclosure":
            term = self.term(2, ("x", "y"))
            step["with"], step["numbers"] = {"t": term, "digits": self.rng.choice((0, 2, 5))}, {"x": self.number()}
            premises, conclusion = [["=", "x", step["numbers"]["x"]]], goal
        else:
            step["with"] = self.arguments(name)
            found = applied(name, step["with"])
            premises, conclusion = found or ([], goal)
        usual = self.chance(0.6)
        step["premises"] = [self.usual(premise) if usual else self.proof(premise, facts, depth) for premise in premises]
        if conclusion[:1] == ["exists"]:
            new = self.rng.choice((*LETTERS, "u", "v"))
            step["letters"] = [new]
            conclusion = put(conclusion[2], conclusion[1][0], new) if self.chance(0.4) else conclusion
        step["then"] = HERE
        return step, conclusion

    def usual(self, goal: JSON, assumed: int = 0) -> JSON:
        """The proof that the form of a premise asks for; so many facts have been assumed before."""
        match goal:
            case ["and", *parts]:
                return {"rule": "each", "parts": [self.usual(part, assumed) for part in parts]}
            case ["or", *parts]:
                k = self.rng.randrange(len(parts))
                return {"rule": "choose", "index": k, "then": self.usual(parts[k], assumed)}
            case ["forall", _, body]:
                return {"rule": "every", "letters": ["w"], "then": self.usual(body, assumed)}
            case ["=>", premise, conclusion]:
                more = len(premise) - 1 if premise[0] == "and" else 1
                return {"rule": "implies", "then": self.usual(conclusion, assumed + more)}
            case ["!=", left, 0]:
                factor = f"1/{left}" if type(left) is int and left > 0 else "1"
                return {"rule": "implies", "then": {"rule": "absurd", "cofactors": [[["here", assumed], factor]]}}
            case ["<" | "<=" | ">" | ">=" as sign, left, right]:
                large, small = (right, left) if sign[0] == "<" else (left, right)
                return {"rule": "nonnegative", "form": ["+", large, ["-", small]]}
        return IDENTITY

    def by_theorem(self) -> JSON:
        """A claim that a theorem makes, or nearly."""
        facts: list[JSON] = []
        hypotheses: dict[str, JSON] = {}
        step, conclusion = self.theorem(["=", self.term(1), self.term(1)], facts)
        if self.chance(0.75) and step["of"] not in ("congruence", "enclosure"):
            found = applied(step["of"], step["with"])
            for k, premise in enumerate(found[0] if found else ()):
                if premise[0] in (*ORDERS, "or") and self.chance(0.7):
                    hypotheses[f"h{k}"] = [premise]
                    step["premises"][k] = self.by_fact(premise, ["hyp", f"h{k}", 0], 0)
        claim = conclusion
        parts = conclusion[1:] if conclusion[:1] == ["and"] else [conclusion]
        if conclusion[:1] == ["exists"]:
            _, (x, *_), body = conclusion
            parts, new = body[1:] if body[0] == "and" else [body], step.get("letters", ["x"])[0]
            k = self.rng.randrange(len(parts))
            claim, last = ["exists", [x], parts[k]], self.by_fact(put(parts[k], x, new), ["here", k], len(parts))
            step["then"] = {"rule": "witness", "point": {x: new}, "then": last}
        else:
            k = self.rng.randrange(len(parts))
            claim = parts[k]
            step["then"] = self.by_fact(claim, ["here", k], len(parts))
        if self.chance(0.25):
            claim = self.changed(claim)
        return self.proved(claim, step, hypotheses)

    def by_fact(self, claim: JSON, name: JSON, assumed: int) -> JSON:
        tag = claim[0] if isinstance(claim, list) and claim else ""
        if tag == "=":
            return {"rule": "identity", "cofactors": [[name, "1"]]}
        if tag in ("<", "<=", ">", ">=") and len(claim) == 3:
            large, small = (claim[2], claim[1]) if tag[0] == "<" else (claim[1], claim[2])
            return {"rule": "nonnegative", "form": ["+", large, ["-", small]]}
        if tag == "!=":
            return {
                "rule": "implies",
                "then": {"rule": "absurd", "times": [name], "cofactors": [[["here", assumed], "1"]]},
            }
        return self.proof(claim, [name], 2)

    def proved(self, claim: JSON, proof: JSON, hypotheses: JSON = None, **more: JSON) -> JSON:
        made = {"id": "t", "verdict": "proved", "claim": claim, "definitions": [], "hypotheses": hypotheses or {}}
        made = {**made, "proof": proof, **more}
        divisors = [*denominators(claim)]
        if divisors and "nonzero" not in made and self.chance(0.8):
            made["nonzero"] = divisors
        made["witnesses"] = self.points(made)
        return made

    def points(self, made: JSON) -> JSON:
        """A point for what is assumed: numbers for all letters, fitted to an equation with a letter alone."""
        values = {x: self.rng.choice((1, 2, 3, ["/", 1, 2], -1, 0)) for x in LETTERS}
        for formulas in made["hypotheses"].values():
            for formula in formulas:
                if formula[:1] == ["="] and len(formula) == 3 and isinstance(formula[1], str):
                    values[formula[1]] = unfold(formula[2], {x: v for x, v in values.items() if x != formula[1]})
        defined = {name for name, _ in made["definitions"]}
        return [{"values": {x: value for x, value in values.items() if x not in defined}}]

    def identity(self) -> JSON:
        if self.chance(0.4):
            return self.proved(self.twins(), IDENTITY)
        return self.proved(self.relation("="), IDENTITY)

    def twins(self) -> JSON:
        """Two terms that have one value for the checker, among many small ones."""
        t: JSON = 0
        for _ in range(12):
            t = self.angular() if self.chance(0.5) else self.term(2, ("x", "y"))
            try:
                algebra = Algebra({})
                value = algebra.value(Reader().term(t)) % PRIME
            except (Reject, Malformed, Unknown, TypeError, ValueError, AttributeError, ArithmeticError):
                continue
            other = self.met.setdefault(value, t)
            if other != t:
                return ["=", other, t]
        return ["=", t, self.same(t)]

    def angular(self) -> JSON:
        """A sine, cosine or tangent of multiples of angles, or a small form of such."""
        if self.chance(0.3):
            part = [self.angular(), self.angular()]
            return self.rng.choice(
                (["*", *part], ["+", *part], ["-", part[0]], ["^", part[0], self.rng.choice((2, 3))])
            )
        return [self.rng.choice(("sin", "cos", "sin", "cos", "tan")), self.angle()]

    def angle(self) -> JSON:
        whole = self.rng.choice((1, 2, 3, -1, -2, -3, 4, 0))
        base = self.rng.choice(("x", "x", "y", ["pi"], ["arctan", 2], ["arctan", ["/", 1, 2]], ["*", "x", "y"], 1))
        match self.rng.randrange(6):
            case 0:
                return ["*", whole, base]
            case 1:
                return ["/", base, self.rng.choice((2, -2, 3, 4))]
            case 2:
                return ["*", ["/", whole, self.rng.choice((2, 3, -2))], base]
            case 3:
                return ["+", self.angle(), self.angle()]
            case 4:
                return ["-", self.angle()]
            case _:
                return base

    def assumed(self) -> JSON:
        """A small statement with hypotheses, and a proof by its form."""
        formulas = [
            [self.rng.choice(("=", "=", ">", "!=", ">=", "<")), self.letter(), self.rng.choice((0, self.term(1)))]
            for _ in range(self.rng.choice((1, 1, 2)))
        ]
        hypotheses = {f"h{k}": [formula] for k, formula in enumerate(formulas)}
        names = [["hyp", name, 0] for name in hypotheses]
        one, other = self.rng.choice(formulas), self.rng.choice(formulas)
        claim: JSON = self.rng.choice((
            [one[0], ["+", one[1], "a"], ["+", one[2], "a"]], [one[0], ["*", 2, one[1]], ["*", 2, one[2]]],
            [one[0], ["+", one[1], other[1]], ["+", one[2], other[2]]], ["=", ["*", one[1], "y"], ["*", one[2], "y"]],
            ["=>", ["=", ["*", "x", "y"], 0], ["or", ["=", "x", 0], ["=", "y", 0]]], self.relation(),
            ["exists", ["t"], [one[0], ["+", "t", one[1]], one[2]]],
            ["forall", ["t"], [one[0], ["*", "t", one[1]], one[2]]],
        ))  # fmt: skip
        if self.chance(0.5) and claim[0] == "=":
            steps = [[name, self.rng.choice(("1", "2", "y", "-1"))] for name in self.rng.sample(names, 1)]
            return self.proved(claim, {"rule": "identity", "cofactors": steps}, hypotheses)
        return self.proved(claim, self.proof(claim, names), hypotheses)

    def defined(self) -> JSON:
        """Definitions, some of them free, with names that binders have too."""
        definitions = []
        for name in self.rng.sample(("d", "x", "t", "y"), 2):
            definitions.append([name, self.term(1, ("a", "x", *(each for each, _ in definitions)))])
        t = self.term(2, ("d", "x", "t", "y", "a"))
        claim = ["=", t, self.same(unfold(t, unfolded(definitions)) if self.chance(0.5) else t)]
        made = self.proved(claim, IDENTITY)
        made = {**made, "definitions": definitions}
        made["witnesses"] = self.points(made)
        return made

    def closed(self) -> JSON:
        """A statement about numbers, proved or refuted by computing it."""
        values = {x: self.rng.choice((0, 1, 2, -1, ["/", 1, 2], ["pi"], ["sqrt", 2])) for x in LETTERS}
        claim = self.statement()
        if self.chance(0.4):
            return self.proved(unfold(claim, values), {"rule": "compute"})
        point: JSON = {"values": values}
        if self.chance(0.3):
            point["calls"] = [[self.call(self.number), self.number()] for _ in range(self.rng.choice((1, 2)))]
        made = {"id": "t", "verdict": "refuted", "claim": claim, "definitions": [], "hypotheses": {}, "point": point}
        if self.chance(0.3):
            made["hypotheses"] = {"h": [self.relation()]}
        if self.chance(0.2):
            point["proof"] = self.proof(["and", contrary(claim)], [["point", k] for k in range(len(values))])
        return made

    def statement(self) -> JSON:
        kind = self.rng.random()
        if kind < 0.6:
            return self.relation()
        if kind < 0.9:
            return [self.rng.choice(("and", "or", "=>", "<=>")), self.relation(), self.relation()]
        return [self.rng.choice(("exists", "forall")), [self.rng.choice(BOUND)], self.relation()]

    def logical(self) -> JSON:
        claim = self.statement()
        return self.proved(claim, self.proof(claim, []))

    def one(self) -> JSON:
        """A certificate of any kind; another one where what is strange cannot even be written about."""
        kinds = (self.identity, self.by_theorem, self.assumed, self.closed, self.defined, self.logical)
        while True:
            (draw,) = self.rng.choices(kinds, (28, 32, 12, 14, 7, 7))
            try:
                made = draw()
                return self.damaged(made) if self.chance(0.08) else made
            except (TypeError, LookupError, AttributeError, ValueError):
                continue

    def damaged(self, made: JSON) -> JSON:
        """One place of the certificate changed, anywhere."""
        key = self.rng.choice([key for key in made if key not in ("id", "verdict")])
        return {**made, key: self.changed(made[key])}


def applied(name: str, given: dict[str, JSON]) -> tuple[list[JSON], JSON] | None:
    """Premises and conclusion of a theorem as raw JSON; None if the arguments do not fit."""
    reader = Reader()
    try:
        read = {
            key: ((value["letter"],), reader.term(value["term"])) if isinstance(value, dict) else reader.term(value)
            for key, value in given.items()
        }
        premises, conclusion = instance(name, read)  # type: ignore[arg-type]
    except (Malformed, TypeError, AttributeError, ValueError):
        return None
    return [*map(plain, premises)], plain(conclusion)


def plain(node: Any) -> JSON:
    return json.loads(json.dumps(node))


def put(node: JSON, x: str, value: JSON) -> JSON:
    return unfold(node, {x: value})


def unfold(node: JSON, names: Mapping[str, JSON]) -> JSON:
    """Names that are defined replaced by their text, but where a binder gives them another meaning."""
    if isinstance(node, str):
        return names.get(node, node)
    if not isinstance(node, list) or not node:
        return node
    tag = node[0]
    if tag in BINDERS:
        inner = {x: text for x, text in names.items() if x != node[2]}
        return [tag, unfold(node[1], inner), node[2], *(unfold(each, names) for each in node[3:])]
    if tag in ("exists", "forall"):
        return [tag, node[1], unfold(node[2], {x: text for x, text in names.items() if x not in node[1]})]
    if tag == "call":
        return [*node[:3], *(unfold(each, names) for each in node[3:])]
    return [tag, *(unfold(each, names) for each in node[1:])]


def unfolded(definitions: list[Any]) -> dict[str, JSON]:
    """The text of every definition, those before it unfolded."""
    names: dict[str, JSON] = {}
    for name, text in definitions:
        names[name] = unfold(text, names)
    return names


def contrary(claim: JSON) -> JSON:
    opposite = {"=": "!=", "!=": "=", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
    return [opposite.get(claim[0], claim[0]), *claim[1:]]


def spots(node: JSON, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    yield path
    for key, child in node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ():
        yield from spots(child, (*path, key))


def at(node: JSON, path: tuple[Any, ...]) -> JSON:
    for key in path:
        node = node[key]
    return node


def replaced(node: JSON, path: tuple[Any, ...], new: JSON) -> JSON:
    if not path:
        return new
    key, *rest = path
    if isinstance(node, dict):
        return {**node, key: replaced(node[key], tuple(rest), new)}
    return [*node[:key], replaced(node[key], tuple(rest), new), *node[key + 1 :]]


def denominators(node: JSON) -> Iterator[JSON]:
    """What the claim divides by, of what stands under no binder."""
    if isinstance(node, list) and node:
        if node[0] in ("mean", "integral", "diverges", "sum", "product", "diff", "exists", "forall"):
            return
        if node[0] == "/" and len(node) == 3 and not isinstance(node[2], int):
            yield node[2]
        if node[0] == "^" and len(node) == 3 and isinstance(node[2], int) and node[2] < 0:
            yield node[1]
        if node[0] == "tan" and len(node) == 2:
            yield ["cos", node[1]]
        for child in node[1:]:
            yield from denominators(child)


class Judge:
    """Whether what was accepted is so."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)
        self.told: Counter[str] = Counter()

    def false(self, made: JSON) -> str | None:
        """Why an accepted certificate is false; None if nothing speaks against it."""
        names = unfolded(made["definitions"])
        claim = unfold(made["claim"], names)
        assumed = [unfold(f, names) for formulas in made["hypotheses"].values() for f in formulas]
        assumed += [["!=", unfold(t, names), 0] for t in made.get("nonzero", ())]
        if made["verdict"] == "refuted":
            return self.refutation(claim, assumed, made["point"], names)
        for point in made.get("witnesses", ()):
            meaning, values, own = self.place(point, names)
            found = [meaning.formula(unfold(formula, own), values) for formula in assumed]
            if False in found:
                return "what is assumed does not hold at the witness"
            if all(found) and meaning.formula(unfold(claim, own), values) is False:
                return "false at the witness"
        tried = 0
        for meaning, values in self.places(assumed, claim):
            if all(meaning.formula(formula, values) for formula in assumed):
                tried += 1
                found_ = meaning.formula(claim, values)
                self.told[f"claim {found_}"] += 1
                if found_ is False:
                    return f"false at {values}"
        self.told["assumptions met" if tried else "assumptions never met"] += 1
        return None

    def place(self, point: JSON, names: dict[str, JSON]) -> tuple[Meaning, dict[str, mpf], dict[str, JSON]]:
        """Functions with the values stated, other letters by chance, and the coordinates, to be put in as terms."""
        smooth = Smooth(self.rng)
        meaning = Meaning(smooth)
        own = {x: unfold(t, names) for x, t in point["values"].items()}
        for x in own:
            meaning.term(own[x], {})
        for call, value in point.get("calls", ()):
            places = [meaning.term(unfold(unfold(t, names), own), {}) for t in call[3:]]
            smooth.state(call[1], call[2], places, meaning.term(unfold(unfold(value, names), own), {}))
        return meaning, {x: mpf(self.rng.randint(-9, 9)) / 7 for x in (*LETTERS, *BOUND, "d")}, own

    def places(self, assumed: list[JSON], claim: JSON) -> Iterator[tuple[Meaning, dict[str, mpf]]]:
        """Random points; letters that an assumption gives alone follow the others."""
        heavy = any(
            kind in json.dumps([claim, assumed]) for kind in ("integral", "diverges", "exists", "product", "gamma")
        )
        for k in range(2 if heavy else 3):
            meaning = Meaning(Smooth(self.rng))
            values = {x: mpf(self.rng.randint(-40, 40)) / (3 if k % 2 else 16) for x in (*LETTERS, *BOUND, "d")}
            if k:
                values |= {x: abs(value) + mpf(1) / 7 for x, value in values.items()}
            for _ in range(2):
                for formula in assumed:
                    if formula[0] == "=" and isinstance(formula[1], str):
                        try:
                            values[formula[1]] = meaning.term(formula[2], values)
                        except (NoValue, ZeroDivisionError, ValueError, OverflowError):
                            break
            yield meaning, values

    def refutation(self, claim: JSON, assumed: list[JSON], point: JSON, names: dict[str, JSON]) -> str | None:
        try:
            meaning, values, own = self.place(point, names)
        except (NoValue, ZeroDivisionError, ValueError, OverflowError) as error:
            return f"a coordinate has no value ({error})"
        if any(meaning.formula(unfold(formula, own), values) is False for formula in assumed):
            return "a hypothesis does not hold at the point"
        found = meaning.formula(unfold(claim, own), values)
        self.told[f"refuted {found}"] += 1
        if found is None and not any(
            kind in json.dumps(claim) for kind in ("integral", "exists", "forall", "mean", "diff")
        ):
            return "a term has no value at the point"
        return "the claim holds at the point" if found is True else None


def run(number: int, seed: int) -> tuple[Counter[str], list[tuple[str, str]]]:
    """So many certificates: how many are accepted and rejected, and which are accepted and false."""
    forger, judge = Forger(seed), Judge(seed + 1)
    counts: Counter[str] = Counter()
    bad: list[tuple[str, str]] = []
    seen: set[str] = set()
    while number > 0:
        batch = [forger.one() for _ in range(min(number, 500))]
        number -= len(batch)
        for made, reason in zip(
            batch, check_all([{**each, "id": f"t{k}"} for k, each in enumerate(batch)]), strict=True
        ):
            counts["rejected" if reason else "accepted"] += 1
            if reason:
                continue
            text = json.dumps(made)
            if hash(text) in seen:
                continue
            seen.add(hash(text))
            counts[made["verdict"]] += 1
            if made["verdict"] == "proved":
                counts[f"by {made['proof'].get('of', made['proof']['rule'])}"] += 1
            why = judge.false(made)
            if why:
                bad.append((why, text))
    return counts + judge.told, bad


def instances(name: str, number: int, seed: int) -> tuple[int, list[tuple[str, str]]]:
    """Of so many instances of a theorem: those whose premises hold, and among them those whose conclusion does not."""
    forger, judge = Forger(seed), Judge(seed)
    met, bad = 0, []
    for _ in range(number):
        found = applied(name, forger.arguments(name))
        if found is None:
            continue
        premises, conclusion = found
        for meaning, values in judge.places(premises, conclusion):
            if all(meaning.formula(premise, values) for premise in premises):
                met += 1
                if meaning.formula(conclusion, values) is False:
                    bad.append((f"false at {values}", json.dumps([premises, conclusion])))
    return met, bad


if __name__ == "__main__":
    began = time.time()
    total, wrong = run(int(sys.argv[1]), int(sys.argv[2]))
    for line, count in total.most_common():
        print(f"{count:8d} {line}")
    print(f"{time.time() - began:.1f} s, {len(wrong)} accepted and false")
    for why, text in wrong[:20]:
        print(why, text, sep="\n    ")
