"""Kronecker products of matrices of all sizes, by what they do with the columns of another one."""

from __future__ import annotations

import re

import numpy as np
import pytest

from symcheck import decide

TRUE = (
    r"(A \otimes B)(C \otimes D) = AC \otimes BD",
    r"(A \otimes B)^T = A^T \otimes B^T",
    r"(A \otimes B)^{-1} = A^{-1} \otimes B^{-1}",
    r"\operatorname{tr}(A \otimes B) = \operatorname{tr}A \operatorname{tr}B",
    r"\operatorname{tr}(A \otimes B) = \operatorname{tr}(B \otimes A)",
    r"A \otimes (B + C) = A \otimes B + A \otimes C",
    r"(A - B) \otimes C = A \otimes C - B \otimes C",
    r"\operatorname{vec}(AXB) = (B^T \otimes A)\operatorname{vec}(X)",
    r"\operatorname{vec}(AXB) = (B^T \otimes A)\operatorname{vec} X",
)
FALSE = (
    r"(A \otimes B)(C \otimes D) = BD \otimes AC",
    r"(A \otimes B)^T = B^T \otimes A^T",
    r"A \otimes B = B \otimes A",
    r"\operatorname{tr}(A \otimes B) = \operatorname{tr}A + \operatorname{tr}B",
    r"A \otimes (B + C) = A \otimes B - A \otimes C",
    r"\operatorname{vec}(AXB) = (A^T \otimes B)\operatorname{vec}(X)",
)


@pytest.mark.parametrize("relation", TRUE)
def test_what_is_so_of_kronecker_products_is_proved_for_all_sizes(relation: str) -> None:
    answer = decide(relation)
    assert answer.verdict == "proved"
    assert all("matrices" in each for each in answer.certificate)
    printed = {x for x in "ABCDX" if x in re.sub(r"\\[a-z]+", "", relation)}
    assert answer.letters.keys() == printed  # and no letter of ours
    assert all("whatever these are" in what for what in answer.letters.values())


@pytest.mark.parametrize("relation", FALSE)
def test_a_slip_in_a_relation_of_kronecker_products_is_refuted(relation: str) -> None:
    assert decide(relation).verdict == "refuted"


@pytest.mark.parametrize("relation", [r"x \otimes y = y \otimes x", r"A \otimes B \otimes C = A \otimes C \otimes B"])
def test_of_other_products_nothing_is_said_for_all_sizes(relation: str) -> None:
    assert not any("matrices" in each for each in decide(relation).certificate)


def test_a_kronecker_product_does_with_columns_what_is_said_here() -> None:
    rng = np.random.default_rng(1)
    a, b, x = rng.normal(size=(2, 3)), rng.normal(size=(4, 5)), rng.normal(size=(5, 3))

    def columns(m: np.ndarray) -> np.ndarray:
        return m.flatten(order="F")

    assert np.allclose(np.kron(a, b) @ columns(x), columns(b @ x @ a.T))
