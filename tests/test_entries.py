"""Entries of matrices and vectors at any place, as `A_{jk} = x_j y_k`, where it is said how many there are."""

from __future__ import annotations

import pytest

from symcheck import decide

WIDE = (r"A \in \mathbb{R}^{2 \times 3}", r"x \in \mathbb{R}^2", r"y \in \mathbb{R}^3")
FAMILY = (r"\mathbf{B} \in \mathbb{R}^{2 \times 2}", r"\mathbf{u}_i \in \mathbb{R}^2", r"\mathbf{v}_i \in \mathbb{R}^2")
SUM = r"\mathbf{B}_{jk} = \sum_{i=1}^m c_i (\mathbf{u}_i)_j (\mathbf{v}_i)_k"


@pytest.mark.parametrize(
    ("verdict", "relation", "where", "given"),
    [
        ("proved", r"A = x y^T", r"A_{jk} = x_j y_k", WIDE),
        ("refuted", r"A = 2 x y^T", r"A_{jk} = x_j y_k", WIDE),
        ("proved", r"A_{jk} = x_j y_k", r"A = x y^T", WIDE),
        ("proved", r"\mathbf{B} = \sum_{i=1}^m c_i \mathbf{u}_i \mathbf{v}_i^T", SUM, FAMILY),
        ("refuted", r"\mathbf{B} = \sum_{i=1}^m c_i \mathbf{v}_i \mathbf{u}_i^T", SUM, FAMILY),
    ],
)
def test_entries_at_any_place_say_what_a_matrix_is(
    verdict: str, relation: str, where: str, given: tuple[str, ...]
) -> None:
    answer = decide(relation, where, given)
    assert answer.verdict == verdict, answer.reason


@pytest.mark.parametrize(
    ("relation", "where", "given"),
    [
        (r"A = x y^T", r"A_{jk} = j x_j y_k", WIDE),  # the letter of a place is a factor
        (r"A = x y^T", r"A_{jj} = x_j y_j", WIDE),  # entries of the diagonal alone
        (r"\mathbf{y}^T \mathbf{y} = x^T x", r"y_j = x_j", (r"y \in \mathbb{R}^2", r"x \in \mathbb{R}^2")),
    ],
)
def test_other_entries_say_nothing_of_the_matrix(relation: str, where: str, given: tuple[str, ...]) -> None:
    assert decide(relation, where, given).verdict not in ("proved", "refuted")
