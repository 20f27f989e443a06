"""What printed formulas mean: ten key results typed by hand, every construct once, and the errors of the reader."""

from __future__ import annotations

import pytest
import sympy
from reading_samples import CHARACTERISTIC, NOTATION, ROTATED, TORQUE

from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI
from symcheck.core.verdicts import SymcheckError
from symcheck.reading import Letter, Notation, edits, lower, read, relations, split_tag, term, to_latex, to_sympy
from symcheck.reading.surface import plain
from symcheck.reading.tree import (
    Chain,
    Cross,
    Interval,
    Mul,
    Name,
    Neg,
    Number,
    Pair,
    Pow,
    Qualifier,
    System,
    Transpose,
)


def formulas(latex, notation=NOTATION):
    return lower(read(latex, notation), notation)


def x(name):
    return sympy.Symbol(name, real=True)


I1, I2, I3, J1, J2, J3, k1, k2, k3 = (x(f"{letter}_{n}") for letter in "IJk" for n in (1, 2, 3))
a = {(n, m): x(f"a_{n}{m}") for n in (1, 2, 3) for m in (1, 2, 3)}
c, p, xi, alpha, beta, gamma = (x(name) for name in ("c", "p", "xi", "alpha", "beta", "gamma"))
row = {n: I1 * a[n, 1] ** 2 + I2 * a[n, 2] ** 2 + I3 * a[n, 3] ** 2 for n in (1, 2, 3)}
column = {n: I2 * I3 * a[n, 1] ** 2 + I3 * I1 * a[n, 2] ** 2 + I1 * I2 * a[n, 3] ** 2 for n in (1, 2, 3)}
sin, cos = sympy.sin, sympy.cos
ds = 1 / sympy.sqrt(3)

BY_HAND = {
    "product of two axial moments": (
        ROTATED,
        [
            (
                "=",
                J1 * J3,
                (I1 * a[1, 1] * a[3, 1] + I2 * a[1, 2] * a[3, 2] + I3 * a[1, 3] * a[3, 3]) ** 2
                + I1 * I2 * a[2, 3] ** 2
                + I2 * I3 * a[2, 1] ** 2
                + I3 * I1 * a[2, 2] ** 2,
            )
        ],
    ),
    "characteristic equation": (
        CHARACTERISTIC,
        [("=", I1 * I2 * I3 * p**3 + (k1 * column[1] + k2 * column[2]) * p**2 + k1 * k2 * k3, 0)],
    ),
    "bounds of the product": (
        r"I_1 I_2 I_3 \leq J_1 J_2 J_3 \leq \left(\frac{I_1 + I_2 + I_3}{3} \right)^3, \quad (2.1)",
        [("<=", I1 * I2 * I3, J1 * J2 * J3), ("<=", J1 * J2 * J3, ((I1 + I2 + I3) / 3) ** 3)],
    ),
    "axial moments as sums": (
        r"J_i = \sum_{k=1}^3 I_k a_{ik}^2.",
        [("=", j, row[n]) for n, j in enumerate((J1, J2, J3), 1)],
    ),
    "triangle inequalities": (
        r"I_1 + I_2 + I_3 \geq 2I_i, \quad i = 1, 2, 3. \quad (2.3)",
        [(">=", I1 + I2 + I3, 2 * moment) for moment in (I1, I2, I3)],
    ),
    "function of one moment": (
        r"f_1(J_2) = \frac{1}{4} J_2 (3c - J_2)^2.",
        [("=", sympy.Function("f_1", real=True)(J2), J2 * (3 * c - J2) ** 2 / 4)],
    ),
    "direction cosine": (
        r"a_{13} = \sin \alpha \cos \gamma + \cos \alpha \sin \beta \sin \gamma,",
        [("=", a[1, 3], sin(alpha) * cos(gamma) + cos(alpha) * sin(beta) * sin(gamma))],
    ),
    "equal moments": (
        r"\operatorname{tg} 2\alpha = \sqrt{3} \frac{I_1 - c}{I_2 - I_3}. \quad (2.9)",
        [("=", sympy.tan(2 * alpha), sympy.sqrt(3) * (I1 - c) / (I2 - I3))],
    ),
    "square of a cosine": (
        r"a_{13}^2 = \frac{1}{3} \left(1 - \frac{1}{2} \cos 2\alpha + \frac{\sqrt{3}}{2} \sin 2\alpha \right).",
        [("=", a[1, 3] ** 2, (1 - cos(2 * alpha) / 2 + sympy.sqrt(3) * sin(2 * alpha) / 2) / 3)],
    ),
    "triple root": (
        r"3\xi^2 I_1 I_2 I_3 = 3k^2 J_1 J_2 J_3,",
        [("=", 3 * xi**2 * I1 * I2 * I3, 3 * x("k") ** 2 * J1 * J2 * J3)],
    ),
    "scalar product by components": (
        r"M_1 = -k_1(\boldsymbol{\omega}, \mathbf{e}_1)",
        [("=", x("M_1"), -k1 * sum(x(f"omega_{n}") * a[1, n] for n in (1, 2, 3)))],
    ),
    "control torque": (
        TORQUE[0] + TORQUE[1].removeprefix("="),
        [("=", x(f"M_{n}"), sum(x(f"N_{m}") * x(f"E_{n}{m}") for m in (1, 2, 3))) for n in (1, 2, 3)],
    ),
}


@pytest.mark.parametrize("name", BY_HAND)
def test_what_is_read_is_what_a_hand_typed(name):
    latex, expected = BY_HAND[name]
    found = formulas(latex)[: len(expected)]
    assert len(found) == len(expected)
    for (sign, left, right), (expected_sign, expected_left, expected_right) in zip(found, expected, strict=True):
        assert sign == expected_sign
        assert sympy.expand(to_sympy(left) - expected_left) == 0
        assert sympy.expand(to_sympy(right) - expected_right) == 0


def test_the_tree_is_as_printed():
    tree = read(r"-x_{12} (x_{11} - 2)^2 = 0", Notation([Letter("x", indices=2)]))
    difference = read("x_{11} - 2", Notation([Letter("x", indices=2)]))
    product = Mul((Name("x", (1, 2)), Pow(difference, Number("2"))))
    assert tree == Chain((Neg(product), Number("0")), ("=",))


def test_nothing_is_evaluated():
    assert formulas("k - k = 2/4 + 0") == (("=", ("+", "k", ("-", "k")), ("+", ("/", 2, 4), 0)),)


MEANINGS = {
    r"3c/2": ("/", ("*", 3, "c"), 2),
    r"\frac12 c": ("*", ("/", 1, 2), "c"),
    r"0.75": ("/", 75, 100),
    r"c^{-2}": ("^", "c", -2),
    r"\sin 2\alpha \cos \beta": ("*", ("sin", ("*", 2, "alpha")), ("cos", "beta")),
    r"\sin^2 \beta": ("^", ("sin", "beta"), 2),
    r"\sin \alpha \cdot c": ("*", ("sin", "alpha"), "c"),
    r"\sin(\alpha + \beta) c": ("*", ("sin", ("+", "alpha", "beta")), "c"),
    r"\sin 2\alpha\sqrt{3}": ("*", ("sin", ("*", 2, "alpha")), ("sqrt", 3)),
    r"k(J_1 + c)": ("*", "k", ("+", "J_1", "c")),
    r"I_1": "I_1",
    r"a^2_{12}": ("^", "a_12", 2),
    r"\dot\omega_1": "domega_1",
    r"\bar k_2": "kbar_2",
    r"\sum_{i=1}^3 J_i L_i c": ("+", *(("*", f"J_{n}", f"L_{n}", "c") for n in (1, 2, 3))),
    r"\sum_{i=1}^2 k_i \sum_{j=2}^3 a_{ij}": (
        "+",
        ("*", "k_1", ("+", "a_12", "a_13")),
        ("*", "k_2", ("+", "a_22", "a_23")),
    ),
    r"(\boldsymbol{\omega}, \mathbf{K})": (
        "+",
        ("*", "omega_1", "K_1"),
        ("*", "omega_2", "K_2"),
        ("*", "omega_3", "K_3"),
    ),
    r"\frac{d^2 f_1}{dJ_2^2}": ("call", "f_1", (2,), "J_2"),
    r"\cos(Oy_1, Ox_2)": ("cos", "Oy_1_Ox_2"),
    r"|\begin{pmatrix} p & 1 \\ 2 & c \end{pmatrix}|": ("+", ("*", "p", "c"), ("-", 2)),
    r"\left|\begin{array}{cc} p & 1 \\ 2 & c \end{array}\right|": ("+", ("*", "p", "c"), ("-", 2)),
    r"45^\circ": ("/", ("*", 45, PI), 180),
    r"c^k": ("pow", "c", "k"),
    r"c^{1/2}": ("pow", "c", ("/", 1, 2)),
    r"\sqrt{c + k}": ("sqrt", ("+", "c", "k")),
    r"\exp(-c^2) \ln k": ("*", ("exp", ("-", ("^", "c", 2))), ("log", "k")),
    r"\Gamma(c + 1) \operatorname{arctg} c": ("*", ("gamma", ("+", "c", 1)), ("arctan", "c")),
    r"\int_0^\infty c^k \, dc": ("integral", ("pow", "c", "k"), "c", 0, INFINITY),
    r"\int_{-\infty}^p \int_0^1 c k dc dk": (
        "integral",
        ("integral", ("*", "c", "k"), "c", 0, 1),
        "k",
        MINUS_INFINITY,
        "p",
    ),
    r"\langle c \sin \alpha \rangle_{\alpha}": ("mean", ("*", "c", ("sin", "alpha")), "alpha"),
    r"(c k)''_{ck}": ("diff", ("diff", ("*", "c", "k"), "c", 1, "c"), "k", 1, "k"),
    r"\sin f_1(c) k": ("*", ("sin", ("call", "f_1", (0,), "c")), "k"),
    r"\pi": PI,
}


@pytest.mark.parametrize("latex", MEANINGS)
def test_an_expression_means_one_term(latex):
    assert term(latex, NOTATION) == MEANINGS[latex]


SLASH = {
    r"1/2\pi": ("/", 1, ("*", 2, PI)),
    r"-4\gamma^2/3\alpha^2 - 2/3": (
        "+",
        ("-", ("/", ("*", 4, ("^", "gamma", 2)), ("*", 3, ("^", "alpha", 2)))),
        ("-", ("/", 2, 3)),
    ),
}


@pytest.mark.parametrize("latex", SLASH)
def test_what_a_slash_before_a_product_means_is_said_by_the_notation(latex):
    physical = Notation(NOTATION.letters, slash="denominator")
    assert term(latex, physical) == term(latex, physical.extended(Letter("x"))) == SLASH[latex]
    with pytest.raises(SymcheckError, match="ambiguous"):
        term(latex, NOTATION)
    with pytest.raises(SymcheckError, match="ambiguous"):
        term("1/2(c + k)", physical)
    with pytest.raises(SymcheckError, match="meaning"):
        Notation([], slash="numerator")


AXES = Notation(
    [
        *(Letter(letter) for letter in ("a", "u", "v", r"\pi")),
        Letter("h", indices=1, range=(1, 2, 3, 4)),
        Letter(r"\mathbf{e}", kind="vector", indices=1, range=(1, 2, 3, 4)),
        Letter(r"\mathbf{H}", kind="vector"),
        Letter("i", kind="index", range=(1, 2, 3, 4)),
    ],
    bracket=r"\mathbf{e}",
    decimals="rounded",
)


def test_a_list_in_square_brackets_combines_the_vectors_that_the_notation_names():
    (first, second, third) = formulas(r"\mathbf{H} = [u, 1, -1]", AXES)
    assert first == ("=", "H_1", ("+", ("*", "u", "e_11"), "e_21", ("*", ("-", 1), "e_31")))
    assert second == ("=", "H_2", ("+", ("*", "u", "e_12"), "e_22", ("*", ("-", 1), "e_32")))
    assert third[1] == "H_3"
    assert all(left == right for _, left, right in formulas(r"[h_1, \dots, h_4] = \sum_i h_i \mathbf{e}_i", AXES))
    assert formulas(r"-[1, 0, u] + 2 [0, 1, 0] = 0", AXES)[0] == (
        "=",
        ("+", ("-", ("+", "e_11", ("*", "u", "e_31"))), ("*", 2, "e_21")),
        0,
    )
    assert lower(read(r"\mathbf{H} = (u, 1, -1)", AXES), AXES)[0] == ("=", "H_1", "u")  # round ones are components


def test_without_that_habit_square_brackets_hold_components():
    plain = Notation(AXES.letters)
    assert formulas(r"\mathbf{H} = [u, 1, -1]", plain)[0] == ("=", "H_1", "u")
    assert plain != AXES == Notation(AXES.letters, bracket=r"\mathbf{e}", decimals="rounded") == AXES.extended()
    assert formulas(r"\mathbf{H} = [u, 1, -1]", AXES.extended(Letter("w")))[0] != ("=", "H_1", "u")


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"\mathbf{H} = [1, 1, 1, 1, 1]", r"\[1, 1, 1, 1, 1\] has 5 entries"),
        (r"\mathbf{H} = [1, 1]", "no algebraic form"),
        (r"\mathbf{H} = [1, \mathbf{e}_1, 1]", "a scalar is expected"),
        (r"[1, 0, 0] = 2", "do not compare"),
    ],
)
def test_brackets_of_unknown_sizes_are_errors_that_name_the_place(latex, message):
    with pytest.raises(SymcheckError, match=message):
        formulas(latex, AXES)


def test_a_habit_must_make_sense():
    with pytest.raises(SymcheckError, match="vector"):
        Notation(AXES.letters, bracket="h")
    with pytest.raises(SymcheckError, match="unknown letter"):
        Notation(AXES.letters, bracket=r"\mathbf{g}")
    with pytest.raises(SymcheckError, match="decimals"):
        Notation([], decimals="exact")


SINE = ("sin", "u")
ROUNDED = {
    r"\sin u \approx 0.92": (("/", 183, 200), SINE, ("/", 37, 40)),
    r"\sin u \approx -0.9": (("/", -19, 20), SINE, ("/", -17, 20)),
    r"\sin u \approx 0.90": (("/", 179, 200), SINE, ("/", 181, 200)),
    r"\sin u \approx 1": (("/", 1, 2), SINE, ("/", 3, 2)),
    r"\sin u = 0.92": (("/", 183, 200), SINE, ("/", 37, 40)),
    r"0.92 = \sin u": (("/", 183, 200), SINE, ("/", 37, 40)),
    r"u \approx 67^\circ": (("/", ("*", 133, PI), 360), "u", ("/", ("*", 135, PI), 360)),
    r"u = 54.7^\circ": (("/", ("*", 1093, PI), 3600), "u", ("/", ("*", 219, PI), 720)),
    r"u \approx -54.7^\circ": (("/", ("*", -219, PI), 720), "u", ("/", ("*", -1093, PI), 3600)),
}


@pytest.mark.parametrize("latex", ROUNDED)
def test_a_rounded_number_is_right_to_its_last_printed_digit(latex):
    low, value, high = ROUNDED[latex]
    assert formulas(latex, AXES) == (("and", ("<=", low, value), ("<=", value, high)),)
    assert read(to_latex(read(latex, AXES)), AXES) == read(latex, AXES)


def test_only_decimals_are_rounded_and_only_where_that_is_the_habit():
    assert formulas(r"u = 67^\circ", AXES) == (("=", "u", ("/", ("*", 67, PI), 180)),)
    assert formulas("u = 1", AXES) == (("=", "u", 1),)
    assert formulas("0.5 = 0.50", AXES) == (("=", ("/", 5, 10), ("/", 50, 100)),)
    assert formulas("u < 0.5, u = 0.5 v", AXES) == (("<", "u", ("/", 5, 10)), ("=", "u", ("*", ("/", 5, 10), "v")))
    assert formulas("u = 0.5", Notation(AXES.letters)) == (("=", "u", ("/", 5, 10)),)
    assert formulas(r"u \approx 0.5", Notation(AXES.letters)) == formulas("u = 0.5", AXES)
    first, second, third = formulas(r"\mathbf{H} = (0.5, -2, -0.5)", AXES)
    assert (first, third) == (
        ("and", ("<=", ("/", 9, 20), "H_1"), ("<=", "H_1", ("/", 11, 20))),
        ("and", ("<=", ("/", -11, 20), "H_3"), ("<=", "H_3", ("/", -9, 20))),
    )
    assert second == ("=", "H_2", ("-", 2))
    assert formulas("v = u = 0.5", AXES)[0] == ("=", "v", "u")


@pytest.mark.parametrize(
    "latex", [r"u \approx v", r"0.5 \approx u", r"\mathbf{H} \approx (1, 2, 3)", r"u \approx \frac{1}{2}"]
)
def test_nothing_but_a_printed_number_is_rounded(latex):
    with pytest.raises(SymcheckError, match="no algebraic form"):
        formulas(latex, AXES)


def test_every_edit_of_a_rounded_number_is_noticed():
    printed = r"4 \sin a \cos a \approx 1.951"
    right, met = formulas(printed, AXES), {printed}
    for k in range(printed.index("1.951"), len(printed)):
        for new in "0123456789.":
            met.add(printed[:k] + new + printed[k + 1 :])
    changed = [text for text in met if ".." not in text and not text.endswith(".") and text.count(".") < 2]
    assert len(changed) > 35
    assert [text for text in changed if formulas(text, AXES) == right] == [printed]
    for edit in edits(read(printed, AXES), AXES):
        try:
            assert lower(edit.tree, AXES) != right, edit.description
        except SymcheckError:
            continue  # an edit may make no statement at all


def test_a_double_sign_on_one_side_is_an_alternative_and_on_both_sides_two_claims():
    first, upper, lower_ = formulas(r"p = c \pm k = -(c \mp 1)")
    assert first == ("or", ("=", "p", ("+", "c", "k")), ("=", "p", ("+", "c", ("-", "k"))))
    assert upper == ("=", ("+", "c", "k"), ("-", ("+", "c", ("-", 1))))
    assert lower_ == ("=", ("+", "c", ("-", "k")), ("-", ("+", "c", 1)))
    assert formulas(r"J_i = \pm c") == tuple(
        ("or", ("=", f"J_{n}", "c"), ("=", f"J_{n}", ("-", "c"))) for n in (1, 2, 3)
    )
    assert formulas(r"k \ne \pm c") == (("!=", "k", "c"), ("!=", "k", ("-", "c")))
    vector = formulas(r"\mathbf{K} = \pm \mathbf{M}")
    assert vector == (
        (
            "or",
            ("and", *(("=", f"K_{n}", f"N_{n}") for n in (1, 2, 3))),
            ("and", *(("=", f"K_{n}", ("-", f"N_{n}")) for n in (1, 2, 3))),
        ),
    )


def test_convergence_is_a_formula():
    (formula,) = formulas(r"\int_0^\infty c^k \, dc < \infty")
    assert formula == ("=", ("diverges", ("pow", "c", "k"), "c", 0, INFINITY), 0)


def test_letters_in_a_list_share_the_relation():
    assert formulas("J_1, J_2 > 0") == ((">", "J_1", 0), (">", "J_2", 0))
    assert formulas(r"(J_1, k \ge c) \Rightarrow c = 1") == (
        ("=>", ("and", (">=", "J_1", "c"), (">=", "k", "c")), ("=", "c", 1)),
    )
    between = [("<", 0, letter) for letter in "kcp"], [("<", letter, 1) for letter in "kcp"]
    assert formulas("0 < k, c, p < 1") == tuple(each for pair in zip(*between, strict=True) for each in pair)
    assert formulas(r"0 < k, \quad c < 1") == (("<", 0, "k"), ("<", "c", 1))


def test_dots_stand_for_the_indices_between():
    assert formulas(r"(\zeta_1, \dots, \zeta_3) = (1, 2, 3)") == tuple(("=", f"zeta_{n}", n) for n in (1, 2, 3))


def test_values_of_a_letter_are_alternatives():
    with pytest.raises(SymcheckError, match="says nothing"):
        formulas("c = 1, 2")
    with pytest.raises(SymcheckError, match="not written out"):
        formulas(r"c = 1, 2, \dots, 4")


def test_square_brackets_around_an_entry_make_the_matrix():
    assert read("[a_{ij}]", NOTATION) == read(r"\|a_{ij}\|", NOTATION)
    assert formulas(r"\mathbf{A} = [a_{ij}]") == formulas(r"\mathbf{A} = \|a_{ij}\|")
    assert read("[a_{12}]", NOTATION) == Name("a", (1, 2))


ENDS = {"[0, c]": (">=", "<="), "[0, c)": (">=", "<"), "(0, c]": (">", "<="), "(0, c)": (">", "<")}


@pytest.mark.parametrize("interval", ENDS)
def test_an_interval_says_whether_it_has_its_ends(interval):
    above, below = ENDS[interval]
    assert formulas(rf"k \in {interval}") == (("and", (above, "k", 0), (below, "k", "c")),)


def test_a_function_may_have_components():
    notation = NOTATION.extended(
        Letter(r"\mathbf{f}", kind="function", depends=r"\mathbf{K}", components="(c k, 0, 0)")
    )
    assert formulas(r"\mathbf{f}(\mathbf{K}) = 0", notation)[0] == ("=", ("*", "c", "k"), 0)
    with pytest.raises(SymcheckError, match="known by its name"):
        formulas(r"\mathbf{f}(\mathbf{M}) = 0", notation)


def test_a_system_keeps_its_qualifier_for_every_part():
    tree = read(r"J_i > 0, \quad (i = 1, 3) \\ k_i > 0", NOTATION)
    assert isinstance(tree, System)
    assert tree.qualifiers == (Qualifier(("i",), (1, 3)),)
    assert lower(tree, NOTATION) == ((">", "J_1", 0), (">", "J_3", 0), (">", "k_1", 0), (">", "k_3", 0))


def test_dots_in_a_qualifier_count_up():
    assert formulas(r"J_i = c, \quad i = 1, \dots, 3") == formulas(r"J_i = c, \quad i = 1, 2, 3")


def test_two_indices_may_share_a_qualifier():
    assert len(formulas(r"a_{ij} = 0, \quad i, j = 1, 2")) == 4


def test_every_link_of_a_chain_is_a_relation():
    links = relations(read(r"J_1 = J_2 \le c \ne 0", NOTATION))
    assert [(link.sign, link.latex) for link in links] == [
        ("=", "J_1 = J_2"),
        (r"\le", r"J_2 \le c"),
        (r"\ne", r"c \ne 0"),
    ]


def test_a_relation_prints_its_qualifier():
    (relation,) = relations(read("J_i = c, i = 1, 2", NOTATION))
    assert relation.latex == r"J_i = c, \quad i = 1, 2"


def test_a_list_of_cases_is_one_disjunction():
    latex = r"1). a_{11} = a_{22} = 1; & \quad 2). a_{12} = 0"
    assert len(relations(read(latex, NOTATION))) == 1
    assert formulas(latex) == (("or", ("and", ("=", "a_11", "a_22"), ("=", "a_22", 1)), ("=", "a_12", 0)),)


def test_a_numbered_list_of_statements_is_no_disjunction():
    with pytest.raises(SymcheckError, match="numbered list"):
        formulas(r"1) J_1 = 0, 2) J_2 = 0")


def test_a_free_index_in_logic_means_all_values():
    (formula,) = formulas(r"J_i = 0 \Rightarrow (\exists \alpha : \sin \alpha = c \lor k > 0)")
    assert formula == (
        "=>",
        ("and", ("=", "J_1", 0), ("=", "J_2", 0), ("=", "J_3", 0)),
        ("exists", ("alpha",), ("or", ("=", ("sin", "alpha"), "c"), (">", "k", 0))),
    )


def test_a_qualified_implication_is_instantiated_as_a_whole():
    found = formulas(r"(J_i = 0 \Rightarrow k_i = 0), \quad i = 1, 2")
    assert found == tuple(("=>", ("=", f"J_{n}", 0), ("=", f"k_{n}", 0)) for n in (1, 2))


def test_a_vector_equation_has_three_components_and_a_matrix_nine():
    assert len(formulas(r"\mathbf{K} = \mathbf{I} \boldsymbol{\omega}")) == 3
    assert len(formulas(r"\mathbf{m} = \mathbf{A}^T \mathbf{B} \mathbf{A}")) == 9
    assert formulas(r"\mathbf{K} = 0") == (("=", "K_1", 0), ("=", "K_2", 0), ("=", "K_3", 0))


def test_unequal_vectors_differ_somewhere():
    assert formulas(r"\mathbf{K} \ne \mathbf{M}") == (("or", *(("!=", f"K_{n}", f"N_{n}") for n in (1, 2, 3))),)


def test_a_cross_product_takes_the_whole_product_on_its_right():
    tree = read(r"\boldsymbol{\omega} \times \mathbf{I}\boldsymbol{\omega}", NOTATION)
    assert tree == Cross(Name(r"\boldsymbol{\omega}"), Mul((Name(r"\mathbf{I}"), Name(r"\boldsymbol{\omega}"))))
    first, _, _ = formulas(r"\mathbf{K} = \boldsymbol{\omega} \times \mathbf{M}")
    assert first == ("=", "K_1", ("+", ("*", "omega_2", "N_3"), ("-", ("*", "omega_3", "N_2"))))


def test_brackets_tell_pairs_intervals_and_groups_apart():
    assert read(r"(\mathbf{K}, \mathbf{M})", NOTATION) == Pair(Name(r"\mathbf{K}"), Name(r"\mathbf{M}"))
    assert read("[0, c]", NOTATION) == Interval(Number("0"), Name("c"))
    assert read("((c))", NOTATION) == Name("c")
    assert read(r"\mathbf{A}^T", NOTATION) == Transpose(Name(r"\mathbf{A}"))


def test_belonging_to_an_interval_is_two_inequalities():
    assert formulas(r"J_2 \in [0, 3c/2]") == (("and", (">=", "J_2", 0), ("<=", "J_2", ("/", ("*", 3, "c"), 2))),)


def test_a_letter_that_T_names_makes_a_power_of_a_transposition():
    notation = Notation([Letter("T"), Letter("x")])
    assert read("x^T", notation) == Pow(Name("x"), Name("T"))


def test_a_letter_can_mean_something_else_in_one_place():
    local = NOTATION.extended(Letter("d"))
    assert read(r"\frac{1}{d^2}", local) != read(r"\frac{1}{c^2}", local)
    with pytest.raises(SymcheckError, match="differential"):
        read(r"\frac{1}{d^2}", NOTATION)


def test_a_letter_with_and_without_indices_is_two_letters():
    assert term("k k_1", NOTATION) == ("*", "k", "k_1")
    assert [letter.stem for letter in (Letter(r"\dot{\omega}"), Letter(r"\bar{k}"), Letter(r"h_{\max}"))] == [
        "domega",
        "kbar",
        "h_max",
    ]


def test_wide_indices_are_one_number_where_there_is_one_index():
    notation = Notation([Letter("V", indices=1, range=tuple(range(1, 17)), depends="")])
    assert term("V_{12}' - V_1", notation) == ("+", "Vprime_12", ("-", "V_1"))


LINE_BREAKS = [
    (r"J_1 + \\ + J_2 = 0", r"J_1 + J_2 = 0"),
    (r"J_1 = \\ &= J_2", r"J_1 = J_2"),
    (r"\left[ J_1 + \right. \\ \left. + J_2 \right] = 0", r"[J_1 + J_2] = 0"),
    (r"J_1 = c \\ J_2 = c", r"J_1 = c, J_2 = c"),
    (r"J_1 = c, \\ J_2 = c", r"J_1 = c, J_2 = c"),
    (r"\begin{aligned} J_1 &= c. \end{aligned}", r"J_1 = c"),
    (("J_1 =", "= c,"), "J_1 = c"),
    (("J_1 = c,", "J_2 = c."), "J_1 = c, J_2 = c"),
    (r"J_1 = -\\ - c", "J_1 = -c"),
]


@pytest.mark.parametrize(("broken", "whole"), LINE_BREAKS)
def test_a_sign_repeated_over_a_line_break_is_one_sign(broken, whole):
    assert read(broken, NOTATION) == read(whole, NOTATION)


TAGS = [
    (r"x = 1, \quad (2.7)", ("x = 1", "2.7")),
    (r"\end{aligned} \tag{2.17}", (r"\end{aligned}", "2.17")),
    (r"x = 1. \quad (2.12).", ("x = 1", "2.12")),
    (r"J_i, \quad (i = 1, 2, 3)", (r"J_i, \quad (i = 1, 2, 3)", None)),
    ("x (1.5)", ("x (1.5)", None)),
    ("x = 1;", ("x = 1", None)),
]


@pytest.mark.parametrize(("latex", "parts"), TAGS)
def test_a_printed_number_is_no_part_of_the_formula(latex, parts):
    assert split_tag(latex) == parts


MALFORMED = {
    r"\lambda = 1": "unknown letter",
    r"I_4 = 1": "outside its range",
    r"a_1 = 1": "not declared with 1 indices",
    r"a = 1": "without an index",
    r"a_{1x} = 1": "not an index",
    r"I_{} = 1": "empty subscript",
    r"J_1 = 3 2": "nothing but a space",
    r"(J_1 = 1": "never closed",
    r"J_1) = 1": "unbalanced",
    r"\left(J_1 = 1": "never closed",
    r"\left(J_1) = 1": r"no \\right",
    r"\{J_1] = 1": "unbalanced",
    r"|\mathbf{A} = 1": "never closed",
    r"\begin{aligned} J_1": "never ended",
    r"\begin{foo} J_1 \end{foo}": "unknown environment",
    r"\frac{1} = 2": "does not fit",
    r"\frac{1}": "argument is missing",
    r"J_1 = ": "breaks off",
    r"= J_1": "does not fit",
    r"J_1 + - c": "does not fit",
    r"J_1 c^": "argument is missing",
    r"1/2c": "ambiguous",
    r"1/2/c": "does not fit",
    r"c 2": "ambiguous",
    r"c^23": "ambiguous",
    r"\sin \alpha/2": "ambiguous",
    r"\sin \alpha^2": "belong",
    r"\sin (\alpha)^2": "belong",
    r"\sin^{-1} \alpha": "inverse",
    r"\sin": "without an argument",
    r"\sin \frac{\alpha}{2} c": "belong",
    r"\mathbf{K} \times \mathbf{K} \times \mathbf{K}": "which of these",
    r"\sum_{i=1}^3": "sum of nothing",
    r"\sum^3 c": "without an index",
    r"\sum_{c=1}^3 c": "bounds",
    r"d^2 c": "differential",
    r"\frac{d^2 f_1}{dJ_2}": "orders",
    r"J_1 = 0 \Rightarrow k = 0, c = 0": "ambiguous",
    r"\left(\frac{d}{dk} + c\right) f_1(k) J_1 = 0": "applies to is ambiguous",
    r"J_1 \Rightarrow k = 0": "relation is expected",
    r"(J_1 = 1) + 2 = 3": "not a relation",
    r"J_1 = 0, c k": "says nothing",
    r"J_1 = 0, i": "says nothing",
    r"J_i = c, i = 1, 2, j": "says nothing",
    r"c \pm": "breaks off",
    r"\int_0^1 c": "does not say what it is taken over",
    r"\int_0^1 dc": "an integral of nothing",
    r"\int_0^1 c d(c)": "does not say what it is taken over",
    r"\int_0^1 c dc k": "put the integral in brackets",
    r"\int_0 c dc": "with one bound",
    r"\langle c \rangle": "letter it is taken over",
    r"\langle c \rangle_\lambda": "unknown letter",
    r"\langle c": "never closed",
    r"\Gamma c": "must stand in brackets",
    r"[0, c) = 1": "unbalanced",
    r"c \in [0, 1, 2)": "two ends",
    r"1/2(c + k)": "ambiguous",
    r"p = 1, 2": "says nothing",
    r"c_{1}_{2}": "second subscript",
    r"\cdot c": "between two factors",
    r"\begin{pmatrix} 1 & 2 \\ 3 \end{pmatrix}": "differ in length",
    r"c $ 1": "cannot be read",
    "": "empty formula",
    r"\quad": "empty formula",
}


@pytest.mark.parametrize("latex", MALFORMED)
def test_what_cannot_be_read_in_one_way_is_an_error_that_says_why(latex):
    with pytest.raises(SymcheckError, match=MALFORMED[latex]):
        read(latex, NOTATION)


def test_an_error_shows_the_place():
    with pytest.raises(SymcheckError, match=r"at character 7: J_1 \+ ▸\\lambda = 0"):
        read(r"J_1 + \lambda = 0", NOTATION)


def test_an_unknown_letter_suggests_the_nearest():
    with pytest.raises(SymcheckError, match=r"did you mean \\omega"):
        read(r"\omeg", NOTATION)


SENSELESS = {
    r"\mathbf{K} = c": "do not compare",
    r"\mathbf{K} + c = 0": "adds",
    r"\mathbf{K} \mathbf{M} = c": "no product",
    r"(c, k) = 1": "scalar product",
    r"\mathbf{K} < \mathbf{M}": "orders vectors",
    r"\sum_{j=1}^3 a_{1j} = k_j": "outside of its sum",
    r"\sum_{i=1}^4 k_i = 0": "outside the range",
    r"\max f_1 = c": "no algebraic form",
    r"\sqrt[3]{c} = 1": "a root of odd order",
    r"c = 1, 2, \dots": "not written out",
    r"J_i = c, i = 1, 2, \dots": "not written out",
    r"c < \infty": "no algebraic form",
    r"(\zeta_1, \dots, k) = c": "dots must stand",
    r"\int_0^1 c d\mathbf{K} = 1": "a scalar is expected",
    r"\langle c \rangle_{\mathbf{K}} = 1": "a scalar is expected",
    r"\log c = 1": "to the base e, or 10",
    r"f_1(J_2, c) = c": "f_1 depends on J_2",
    r"k^T = 1": "transposes a scalar",
    r"c \subset k": "no algebraic form",
}


@pytest.mark.parametrize("latex", SENSELESS)
def test_what_has_no_algebraic_meaning_is_an_error_when_lowered(latex):
    with pytest.raises(SymcheckError, match=SENSELESS[latex]):
        formulas(latex)


SAME = {  # what is printed, and other prints that together say the same
    r"\left(\frac{d^2}{dk^2} + 2 c \frac{d}{dk} - J_1\right) f_1(k) = 0": [
        r"\frac{d^2 f_1(k)}{dk^2} + 2 c \frac{d f_1(k)}{dk} - J_1 f_1(k) = 0"
    ],
    r"c: \quad J_1 = k": ["J_1 = k"],
    r"J_1 = k \text{ at } c = 0": [r"J_1 = k \text{ for } c = 0"],
    r"J_1 = c \implies k = c, \qquad J_2 = k": [r"J_1 = c \implies k = c", "J_2 = k"],
    r"\frac{d(c^{-1})}{dc} = k": [r"\frac{d}{dc}(c^{-1}) = k"],
    r"\begin{pmatrix} c & k \end{pmatrix} \begin{pmatrix} c \\ k \end{pmatrix} = J_1": ["c c + k k = J_1"],
}


@pytest.mark.parametrize("latex", SAME)
def test_what_is_printed_in_another_way_has_the_same_meaning(latex):
    assert formulas(plain(latex)) == tuple(found for text in SAME[latex] for found in formulas(plain(text)))


LOWERED = {
    r"|c| = 1": ("=", ("sqrt", ("^", "c", 2)), 1),
    r"\sum_{n=1}^{\infty} k^n = 1": ("=", ("sum", ("pow", "k", "n"), "n", 1, ("infinity",)), 1),
    r"\sqrt[4]{c} = 1": ("=", ("pow", "c", ("/", 1, 4)), 1),
    r"J_1 = c \\ + k": ("=", "J_1", ("+", "c", "k")),
}


@pytest.mark.parametrize("latex", LOWERED)
def test_what_analysis_prints_has_a_meaning(latex):
    (found,) = formulas(latex)
    assert found == LOWERED[latex]


def test_a_letter_is_declared_once_and_properly():
    for letters in (
        [Letter("x"), Letter("x")],
        [Letter("i", kind="index"), Letter("i", kind="index")],
    ):
        with pytest.raises(SymcheckError, match="twice"):
            Notation(letters)
    for wrong in ({"kind": "tensor"}, {"sign": "positive"}):
        with pytest.raises(SymcheckError):
            Letter("x", **wrong)


CLASHES = [
    (Letter("k"), Letter(r"\mathbf{k}")),
    (Letter("f_1"), Letter("f", indices=1)),
    (Letter("M", indices=1), Letter(r"\mathbf{M}", kind="vector")),
    (Letter(r"\omega"), Letter("w", name="omega")),
]


@pytest.mark.parametrize("letters", CLASHES)
def test_two_letters_never_become_one_variable(letters):
    with pytest.raises(SymcheckError, match="both be lowered"):
        Notation(letters)


def test_a_notation_is_a_value():
    assert Notation(NOTATION.letters) == NOTATION
    assert hash(NOTATION) == hash(Notation(NOTATION.letters))
    assert NOTATION.extended(Letter("d")) != NOTATION
    assert to_latex(read(r"\bar k_1", NOTATION)) == r"\bar{k}_1"
