"""Determinants and derivatives by matrices of any size: what is made of them against numbers."""

from __future__ import annotations

import math
import random
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from symcheck import decide
from symcheck.core.matrices import Shapes
from symcheck.core.terms import JSON, Malformed
from symcheck.core.verdicts import NoForm
from symcheck.question.determinants import DET, Determinants
from symcheck.question.small_matrices import Small

SIZES = {"n": 3, "m": 2}
SHAPES: dict[str, tuple[int | str, int | str]] = {
    "A": ("n", "n"), "B": ("n", "n"), "U": ("n", "m"), "V": ("m", "n"), "C": ("m", "m"), "x": ("n", 1), "y": ("n", 1),
    "B_inverse": ("n", "n"), "A_inverse": ("n", "n"),
}  # fmt: skip
INVERSES: dict[str, JSON] = {"A_inverse": "A", "B_inverse": "B"}


def value(term: JSON, env: dict[str, Any]) -> Any:
    """A term by NumPy."""
    match term:
        case str():
            return env[term]
        case ["unit", n]:
            return np.eye(SIZES[n])
        case ["number", p, q]:
            return np.array([[p / q]])
        case ["+", *parts]:
            return sum(value(part, env) for part in parts)
        case ["-", x]:
            return -value(x, env)
        case ["*", first, *rest]:
            found = value(first, env)
            for each in rest:
                other = value(each, env)
                found = found * other if (1, 1) in (found.shape, other.shape) else found @ other
            return found
        case ["transpose", x]:
            return value(x, env).T
        case ["trace", x]:
            return np.array([[np.trace(value(x, env))]])
        case [tag, x] if tag == DET:
            return np.array([[np.linalg.det(value(x, env))]])
    raise AssertionError(term)


def some_square(rng: random.Random) -> JSON:
    """A square matrix: a product, or one with a unit or a letter before it."""
    ways: list[list[JSON]] = [
        ["A"], ["B"], ["A", "B"], ["B", "A"], ["A", "A_inverse"], ["B_inverse", "A"], [["transpose", "A"], "B"],
        ["U", "V"], ["U", "C", "V"], ["x", ["transpose", "y"]], ["A", "x", ["transpose", "y"]], ["V", "U"],
        [["transpose", "V"], ["transpose", "U"]], ["V", "A", "U"], ["A", "U", "V"], ["y", ["transpose", "x"]],
    ]  # fmt: skip
    factors = rng.choice(ways)
    product: JSON = ["*", *factors] if len(factors) > 1 else factors[0]
    small = factors[0] == "V"
    kind = rng.randrange(5)
    if kind == 0:
        return product
    if rng.random() < 0.3:
        product = ["-", product]
    return ["+", ["unit", "m" if small else "n"] if small or kind < 4 else rng.choice(["A", "B"]), product]


def test_terms_that_become_the_same_expression_have_the_same_determinant() -> None:
    rng = np.random.default_rng(7)
    env = {x: rng.normal(size=[SIZES.get(str(size), 1) for size in shape]) for x, shape in SHAPES.items()}
    env |= {x: np.linalg.inv(env[str(of)]) for x, of in INVERSES.items()}
    draw, found = random.Random(7), Determinants({**SHAPES}, {**INVERSES}, {})
    groups = defaultdict[str, list[tuple[JSON, float]]](list)
    for _ in range(600):
        term: JSON = [DET, some_square(draw)]
        try:
            made = Shapes(found.shapes).value(found.without(term))
        except (NoForm, Malformed):
            continue
        groups[str(sorted(made.parts.items()))].append((term, value(term, env).item()))
    assert sum(len({str(term) for term, _ in group}) > 1 for group in groups.values()) > 8
    for group in groups.values():
        for term, exact in group:
            assert abs(exact - group[0][1]) < 1e-9 * (1 + abs(exact)), (term, group[0][0])
    values = [group[0][1] for group in groups.values()]
    assert len({round(each, 9) for each in values}) > 15


def number(term: Any, at: dict[str, float]) -> float:
    """The value of a component."""
    match term:
        case str():
            return at[term]
        case int():
            return term
        case (tag, *parts):
            values = [number(part, at) for part in parts]
            if tag == "/":
                return values[0] / values[1]
            return -values[0] if tag == "-" else sum(values) if tag == "+" else math.prod(values)
    raise AssertionError(term)


def test_components_are_those_of_the_term() -> None:
    draw, rng = random.Random(3), np.random.default_rng(3)
    small = Small(SHAPES, INVERSES)
    sizes = {"n": 2, "m": 2}
    env = {x: rng.normal(size=[sizes.get(str(size), 1) for size in shape]) for x, shape in SHAPES.items()}
    env |= {x: np.linalg.inv(env[str(of)]) for x, of in INVERSES.items()}
    at = {str(name): env[x][i, j] for x in SHAPES if x not in INVERSES for i, j, name in entries(small, x)}
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(SIZES, "n", 2)
        for _ in range(100):
            term: JSON = draw.choice(
                [["transpose", some_square(draw)], ["trace", some_square(draw)], [DET, some_square(draw)]]
            )
            exact = value(term, env)
            found = [[number(entry, at) for entry in row] for row in small.value(term)]
            assert np.allclose(found, exact), term


def entries(small: Small, letter: str) -> Iterator[tuple[int, int, Any]]:
    for i, row in enumerate(small.value(letter)):
        yield from ((i, j, name) for j, name in enumerate(row))


SQUARE = (r"A \in \mathbb{R}^{n \times n}", r"X \in \mathbb{R}^{n \times n}")


@pytest.mark.parametrize(
    "relation",
    [
        r"\frac{\partial}{\partial X}\operatorname{tr}(AX) = A",
        r"\frac{\partial}{\partial X}\ln\det X = X^{-1}",
    ],
)
def test_a_derivative_in_the_other_layout_is_neither_proved_nor_refuted(relation: str) -> None:
    assert decide(relation, given=SQUARE).verdict == "ambiguous"


def test_a_derivative_by_a_matrix_with_entries_that_depend_on_each_other_is_not_decided() -> None:
    relation = r"\frac{\partial}{\partial X}\ln\det X = X^{-T}"
    assert decide(relation, given=SQUARE).verdict == "proved"
    assert decide(relation, given=(*SQUARE, "X^T = X")).verdict not in ("proved", "refuted")


@pytest.mark.parametrize("relation", [r"\operatorname{tr}(ABC) = \operatorname{tr}(BAC)", r"\det(2A) = 2 \det A"])
def test_letters_under_a_trace_or_a_determinant_are_no_numbers(relation: str) -> None:
    assert decide(relation).verdict != "proved"
