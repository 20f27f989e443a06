"""Single edits of a statement: complete by kind, different from it and from each other, printable."""

from __future__ import annotations

import pytest
from reading_samples import NOTATION, ROTATED, SAMPLES

from symcheck.reading import edits, read, to_latex
from symcheck.reading.edits import KINDS

EXPECTED = {
    "J_1 + J_2 = 0": {
        ("sign", "J_1 - J_2 = 0"),
        ("term", "J_1 = 0"),
        ("term", "J_1 + J_2 + J_2 = 0"),
        ("index", "J_3 + J_2 = 0"),
        ("number", "J_1 + J_2 = 1"),
        ("exponent", "J_1^2 + J_2 = 0"),
        ("factor", "J_1 + 2 J_2 = 0"),
        ("relation", "J_1 + J_2 = J_1 + J_2"),
    },
    r"I_1 a_{12}^2 \le \frac{2}{3} c": {
        ("factor", r"I_1 \le \frac{2}{3} c"),
        ("index", r"I_1 a_{21}^2 \le \frac{2}{3} c"),
        ("exponent", r"I_1 a_{12} \le \frac{2}{3} c"),
        ("exponent", r"I_1 a_{12}^3 \le \frac{2}{3} c"),
        ("relation", r"I_1 a_{12}^2 \ge \frac{2}{3} c"),
        ("number", r"I_1 a_{12}^2 \le \frac{2}{4} c"),
        ("factor", r"I_1 a_{12}^2 \le \frac{3}{2} c"),
    },
    r"f = J_1 J_2 \ge I_1 k_2": {
        ("letter", r"f = J_1 J_2 \ge J_1 k_2"),
        ("letter", r"f = I_1 I_2 \ge I_1 k_2"),
        ("index", r"f = J_1 J_2 \ge I_2 k_1"),
        ("relation", r"f = J_1 J_2 \ge f"),
        ("sign", r"f = -J_1 J_2 \ge I_1 k_2"),
    },
    r"\sum_{s=1}^3 k_s a_{si} = \sin c": {
        ("index", r"\sum_{s=1}^3 k_i a_{si} = \sin c"),
        ("index", r"\sum_{s=1}^3 k_s a_{s2} = \sin c"),
        ("letter", r"\sum_{s=1}^3 k_s a_{si} = \cos c"),
        ("number", r"\sum_{s=1}^2 k_s a_{si} = \sin c"),
    },
    r"J_1 = c \pm k": {
        ("sign", r"J_1 = c \mp k"),
        ("term", "J_1 = c"),
    },
    r"\int_0^1 c^k \, dc = \Gamma(c)": {
        ("number", r"\int_0^2 c^k \, dc = \Gamma(c)"),
        ("exponent", r"\int_0^1 c \, dc = \Gamma(c)"),
        ("sign", r"\int_0^1 c^k \, dc = -\Gamma(c)"),
    },
    r"\frac{d^2 f_1}{dJ_2^2} = \sqrt{3}": {
        ("exponent", r"\frac{df_1}{dJ_2} = \sqrt{3}"),
        ("exponent", r"\frac{d^2 f_1}{dJ_2^2} = 3"),
    },
}


@pytest.mark.parametrize("latex", EXPECTED)
def test_the_edits_of_a_statement_hold_what_a_slip_of_the_pen_can_do(latex):
    found = {(edit.kind, edit.tree) for edit in edits(read(latex, NOTATION), NOTATION)}
    for kind, wanted in EXPECTED[latex]:
        assert (kind, read(wanted, NOTATION)) in found, wanted


@pytest.mark.parametrize("latex", SAMPLES, ids=str)
def test_edits_differ_from_the_statement_and_from_each_other(latex):
    tree = read(latex, NOTATION)
    trees = [edit.tree for edit in edits(tree, NOTATION)]
    assert len(set(trees)) == len(trees)
    assert tree not in trees


def test_edits_come_in_a_fixed_order():
    tree = read(ROTATED, NOTATION)
    assert list(edits(tree, NOTATION)) == list(edits(tree, NOTATION))


def test_every_kind_of_edit_occurs():
    kinds = {edit.kind for latex in SAMPLES for edit in edits(read(latex, NOTATION), NOTATION)}
    assert kinds == set(KINDS)


def test_an_edited_statement_can_be_printed_and_read():
    count = 0
    for edit in edits(read(ROTATED, NOTATION), NOTATION):
        assert read(to_latex(edit.tree), NOTATION) == edit.tree
        count += 1
    assert count > 100


def test_edits_are_told_in_words():
    told = {edit.description for edit in edits(read("J_1 = a_{22}", NOTATION), NOTATION)}
    assert "index 2 -> 1 in a_{22}" in told


def test_without_a_notation_vectors_and_scalars_are_told_apart_by_their_print():
    tree = read(r"\mathbf{K} = c \mathbf{M}", NOTATION)
    assert {edit.tree for edit in edits(tree) if edit.kind == "letter"} == {
        read(r"\mathbf{M} = c \mathbf{M}", NOTATION),
        read(r"\mathbf{K} = c \mathbf{K}", NOTATION),
    }
