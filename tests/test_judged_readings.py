"""Readings of printed displays that were judged one by one, with what was refused or read wrongly before."""

from __future__ import annotations

import pytest
from bracketed import bracketed
from judged_readings import JUDGED, REFUSED

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import Tree, lower, read, to_latex
from symcheck.reading.inference import inferred
from symcheck.reading.notation import Notation
from symcheck.reading.surface import plain, with_plain_differentials


def first_reading(latex: str) -> tuple[Tree, Notation]:
    """The first of the inferred readings that makes a tree; SymcheckError of the first if none does."""
    text, errors = with_plain_differentials(plain(latex)), list[SymcheckError]()
    for inference in inferred([text], {}, {}):
        try:
            return read(text, inference.notation), inference.notation
        except SymcheckError as error:
            errors.append(error)
    raise errors[0]


@pytest.mark.parametrize(("latex", "right", "source"), JUDGED)
def test_a_display_reads_as_it_was_judged(latex: str, right: str, source: str) -> None:
    assert bracketed(first_reading(latex)[0]) == right, source


@pytest.mark.parametrize(("latex", "source"), REFUSED)
def test_a_display_with_two_readings_is_refused(latex: str, source: str) -> None:
    assert source
    with pytest.raises(SymcheckError):
        first_reading(latex)


OPAQUE = (
    r"\max_x \sin x = 2",
    r"y = \arg\min_{x} f(x)",
    r"\max_{x} f(x) = 1",
    r"P(A | B) = P(B | A)",
    r"p(x; n) = p(n; x)",
    r"y = \sum_{i \in S} a_i",
    r"y = \sum_i^N a_i",
    r"y = (a)_n",
    r"x = (A)^+ b",
    r"y = (a + b)'",
    r"x > 0, \quad \forall x \in S",
    r"C = 0 \quad \text{(during eclipse)}",
    r"A = \begin{bmatrix} a & \\ & b \end{bmatrix}",
)


@pytest.mark.parametrize("latex", OPAQUE)
def test_what_has_no_algebraic_form_is_read_but_states_nothing(latex: str) -> None:
    tree, notation = first_reading(latex)
    assert read(to_latex(tree), notation) == tree
    with pytest.raises(SymcheckError, match="algebraic form"):
        lower(tree, notation)
