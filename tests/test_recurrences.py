"""Sequences of which a recurrence is given: proved by induction, refuted at a whole number, or left undecided."""

from __future__ import annotations

import pytest

from symcheck import decide
from symcheck.checker import check

NATURAL, POSITIVE = (r"n \in \mathbb{N}",), (r"n \in \mathbb{Z}_{>0}",)
GEOMETRIC = ("x[n+1] = a x[n]", "x[0] = c")
FIBONACCI = ("F_{n+2} = F_{n+1} + F_n", "F_0 = 0", "F_1 = 1")
CHEBYSHEV = (r"T_{n+1} = 2 T_n \cos\theta - T_{n-1}", "T_0 = 1", r"T_1 = \cos\theta")
FACTORIAL = ("f(n+1) = (n+1) f(n)", "f(0) = 1")
SQUARES = ("f(n+1) = f(n) + 2n + 1", "f(0) = 0")
VECTORS = (r"\mathbf{x}_{n+1} = \mathbf{x}_n + \mathbf{b}", r"\mathbf{x}_0 = \mathbf{a}")
LOGISTIC = (r"x_n = \sin^2(\theta_n)", r"\theta_{n+1} = 2 \theta_n")
ERROR = ("e_n = x_n - x", r"x_{n+1} = \rho x_n + (1-\rho) x")
MATRIX = (
    r"\mathbf{P}[n+1] = \begin{bmatrix} 0 & \rho^n \\ 0 & 1/2 \end{bmatrix} \mathbf{P}[n]",
    r"\mathbf{P}[0] = \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}",
)
LEGENDRE = (r"(n+1) P_{n+1}(x) = (2n+1) x P_n(x) - n P_{n-1}(x)", "P_0(x) = 1", "P_1(x) = x")
HERMITE = (r"H_{n+1}(x) = 2 x H_n(x) - 2 n H_{n-1}(x)", "H_0(x) = 1", "H_1(x) = 2 x")
LAGUERRE = (r"(n+1) L_{n+1}(x) = (2n+1-x) L_n(x) - n L_{n-1}(x)", "L_0(x) = 1", "L_1(x) = 1 - x")
MONIC = ("H_{n+1}(x) = x H_n(x) - n H_{n-1}(x)", "H_0(x) = 1", "H_1(x) = x")  # no Hermite polynomials of physics

TRUE = (
    (r"P_4(x) = \frac{1}{8} (35 x^4 - 30 x^2 + 3)", LEGENDRE, ()),
    ("H_3(x) = 8 x^3 - 12 x", HERMITE, ()),
    ("H_3(x) = x^3 - 3 x", MONIC, ()),
    (r"L_2(x) = \frac{x^2 - 4 x + 2}{2}", LAGUERRE, ()),
    ("P_n = 1", ("(n+1) P_{n+1} = (2n+1) P_n - n P_{n-1}", "P_0 = 1", "P_1 = 1"), NATURAL),
    ("x[n] = a^n c", GEOMETRIC, (*NATURAL, "a > 0")),
    ("x[n] = a^{n-1} c", ("x[n+1] = a x[n]", "x[1] = c"), (*POSITIVE, "a > 0")),
    ("x[n] = (-1)^n", ("x[n+1] = -x[n]", "x[0] = 1"), NATURAL),
    ("x[n] > 0", ("x[n+1] = x[n]^2 + 1", "x[0] = 1"), NATURAL),
    ("y[n] = \\frac{1-a^{n+1}}{1-a}", ("y[n] = a y[n-1] + 1", "y[0] = 1"), (*NATURAL, "0 < a < 1")),
    ("f(n) = n!", FACTORIAL, NATURAL),
    ("f(n) = n^2", SQUARES, NATURAL),
    ("F_{n+1} F_{n-1} - F_n^2 = (-1)^n", FIBONACCI, POSITIVE),
    (r"T_n = \cos(n\theta)", CHEBYSHEV, NATURAL),
    (r"\mathbf{x}_n = n \mathbf{b} + \mathbf{a}", VECTORS, NATURAL),
    ("x_{n+1} - x_n = h", ("x_n = n h",), NATURAL),
    ("x_n = x_0 + n h", ("x_{i+1} = x_i + h",), ()),
    ("x_3 = 3 h", ("x_{k+1} = x_k + h", "x_0 = 0"), ()),
    ("x_2 = x_0 + 2 h", ("x_{k+1} = x_k + h",), ()),
    ("a_3 = 6", ("a_n = n a_{n-1}", "a_1 = 1"), ()),
    ("x_{n+1} = 4 x_n (1 - x_n)", LOGISTIC, ()),
    (r"e_{n+1} = \rho e_n", ERROR, ()),
    (
        r"\mathbf{P}[n] = \begin{bmatrix} 0 & (\rho/2)^{n-1} \\ 0 & (1/2)^n \end{bmatrix}",
        MATRIX,
        (*POSITIVE, r"\rho > 0"),
    ),
)
FALSE = (
    ("P_n = 1", ("(n+1) P_{n+1} = (2n+1) P_n + n P_{n-1}", "P_0 = 1", "P_1 = 1"), NATURAL),
    ("x[n] = 2 a^n c", GEOMETRIC, (*NATURAL, "a > 0")),
    ("x[n] = a^n c", ("x[n+1] = a x[n]", "x[1] = c"), (*POSITIVE, "a > 0")),
    ("x[n] > 1", ("x[n+1] = x[n]^2 + 1", "x[0] = 1"), NATURAL),
    ("y[n] = \\frac{1-a^n}{1-a}", ("y[n] = a y[n-1] + 1", "y[0] = 1"), (*NATURAL, "0 < a < 1")),
    ("f(n) = (n+1)!", FACTORIAL, NATURAL),
    ("f(n) = n^2", ("f(n+1) = f(n) + 2n + 1", "f(0) = 1"), NATURAL),
    ("f(n) = n^2", ("f(n+1) = f(n) + 2n + 1",), NATURAL),
    ("F_{n+1} F_{n-1} - F_n^2 = (-1)^{n+1}", FIBONACCI, POSITIVE),
    (r"T_n = \sin(n\theta)", CHEBYSHEV, NATURAL),
    (r"\mathbf{x}_n = n \mathbf{b} - \mathbf{a}", VECTORS, NATURAL),
    ("x_{n+1} - x_n = 2h", ("x_n = n h",), NATURAL),
    (r"e_{n+1} = -\rho e_n", ERROR, ()),
    (
        r"\mathbf{P}[n] = \begin{bmatrix} 0 & (\rho/2)^n \\ 0 & (1/2)^{n-1} \end{bmatrix}",
        MATRIX,
        (*POSITIVE, r"\rho > 0"),
    ),
)
FALSE_AT_A_NUMBER = (
    ("x_3 = 4 h", ("x_{k+1} = x_k + h", "x_0 = 0"), ()),
    ("f(3) = 4 h", ("f(k+1) = f(k) + h", "f(0) = 0"), (r"k \in \mathbb{N}",)),
)
OPEN = {
    "functions at several letters": (r"a_n(x) = x^n", ("a_{n+1}(x) = x a_n(x)", "a_0(y) = 1"), (*NATURAL, "x > 0")),
    "a power of what may be negative": ("x[n] = a^n c", GEOMETRIC, NATURAL),
    "a value that is said twice": ("x[n] = 3", ("x[n+1] = x[n]", "x[0] = 3", "x[5] = 4"), NATURAL),
    "sequences that say each other": ("a_{n+1} = 1", ("b_n = a_n", "a_n = b_n", "a_0 = 1"), NATURAL),
    "a letter that may be no whole number": ("f(n) = 1", ("f(n+1) = f(n)", "f(1) = 1"), ("n > 0",)),
    "a letter that is bounded above": ("f(n) = 2", ("f(n+1) = f(n)", "f(1) = 1"), (*POSITIVE, "n < 10")),
    "a recurrence that may divide by zero": ("x[n] = 7", ("x[n+1] = 1/(x[n] - 1)", "x[0] = 1"), NATURAL),
    "a value before the first one": ("x_0 = 1", ("x_{k+1} = x_k + h", "x_1 = h"), ()),
    "numbers before the first one": ("x[n] = 2 a^{n-1} c", ("x[n+1] = a x[n]", "x[1] = c"), (*NATURAL, "a > 0")),
    "what may be given of one place": ("x_{n+1} = 0", ("y_{n+1} = x_n",), ("x_n = 0",)),
    "a recurrence alone": ("x_{n+1} = a x_n", (), ()),
    "a letter of which nothing else is said": ("f(n) = g", SQUARES, NATURAL),
}
Case = tuple[str, tuple[str, ...], tuple[str, ...]]


@pytest.mark.parametrize("case", TRUE, ids=lambda case: case[0])
def test_a_closed_form_is_proved_by_induction(case: Case) -> None:
    found = decide(case[0], where=case[1], given=case[2])
    assert found.verdict == "proved", found.reason
    assert all(check(each) is None for each in found.certificate)  # type: ignore[arg-type]
    assert found.used


@pytest.mark.parametrize("case", FALSE, ids=lambda case: case[0])
def test_a_wrong_closed_form_is_refuted_at_a_whole_number(case: Case) -> None:
    found = decide(case[0], where=case[1], given=case[2])
    assert found.verdict == "refuted", found.reason
    assert found.counterexample["n"].isdigit()
    assert all(check(each) is None for each in found.certificate)  # type: ignore[arg-type]


@pytest.mark.parametrize("case", FALSE_AT_A_NUMBER, ids=lambda case: case[0])
def test_a_wrong_value_at_a_number_is_refuted(case: Case) -> None:
    assert decide(case[0], where=case[1], given=case[2]).verdict == "refuted"


@pytest.mark.parametrize("name", OPEN)
def test_what_is_not_said_of_all_whole_numbers_is_left_open(name: str) -> None:
    relation, where, given = OPEN[name]
    assert decide(relation, where=where, given=given).verdict in ("undecided", "unreadable", "vacuous")
