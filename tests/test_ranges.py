r"""What holds in the range of an angle: signs, roots, integrals that divide by sines; and exponentials of matrices.

Each table has formulas that are true, near misses that are false, and what must stay open.
"""

from __future__ import annotations

import pytest

from symcheck import decide
from symcheck.checker import check

ACUTE, UPPER = r"0 < x < \frac{\pi}{2}", r"0 < x < \pi"
TRUE = (
    (r"\sin x > 0", (UPPER,)),
    (r"\sin x < 0", (r"\pi < x < 2\pi",)),
    (r"\cos x < 0", (r"\frac{\pi}{2} < x < \frac{3\pi}{2}",)),
    (r"\cos y > 0", (ACUTE, r"0 \le y \le x")),
    (r"\sin 2x > 0", (ACUTE,)),
    (r"\sin(\omega t) > 0", (r"0 < \omega t < \pi",)),
    (r"|\sin x| = \sin x", (r"0 \le x \le \pi",)),
    (r"\sqrt{1 - \cos^2 x} = \sin x", (UPPER,)),
    (r"\frac{\sin x}{\sqrt{1 - \sin^2 x}} = \tan x", (ACUTE,)),
    (r"\int_0^x \frac{1}{\cos^2 t} dt = \tan x", (ACUTE,)),
    (r"\int_{-x}^x \frac{1}{\cos^2 t} dt = 2 \tan x", (ACUTE,)),
    (r"\int_{\pi/6}^{\pi/3} \frac{dt}{\sin^2 t} = \frac{2}{\sqrt 3}", ()),
    (r"\int_0^x \int_0^{1/\cos t} r \, dr \, dt = \frac12 \tan x", (ACUTE,)),
    (
        r"\int_0^{2\pi} \int_0^x \int_0^{a/\cos t} r^4 \sin^3 t \, dr \, dt \, d\phi = \frac{\pi a^5}{10} \tan^4 x",
        (ACUTE,),
    ),
    (r"\int_0^{2\pi} \frac{dx}{2 + \cos x} = \frac{2\pi}{\sqrt 3}", ()),
    (r"\int_{-\pi}^{\pi} \frac{dx}{5 + 3 \sin x} = \frac{\pi}{2}", ()),
    (r"\int_0^{2\pi} \frac{dx}{1 + k \cos x} = \frac{2\pi}{\sqrt{1 - k^2}}", ("0 < k < 1",)),
    (r"\int_{-\pi}^{\pi} \frac{1 - r^2}{1 - 2 r \cos x + r^2} dx = 2 \pi", ("0 < r < 1",)),
)
FALSE = (
    (r"\cos x > 0", ("0 < x < 2",)),
    (r"\sin x > 0", ("0 < x < 4",)),
    (r"\sqrt{1 - \cos^2 x} = \sin x", (r"\pi < x < 2\pi",)),
    (r"|\sin x| = \sin x", (r"0 \le x \le 2\pi",)),
)
FALSE_AFTER_SECONDS = (
    (r"\int_0^x \frac{1}{\cos^2 t} dt = 2 \tan x", (ACUTE,)),
    (r"\int_0^{2\pi} \frac{dx}{2 + \cos x} = \frac{\pi}{\sqrt 3}", ()),
    (r"\int_{-\pi}^{\pi} \frac{1 - r^2}{1 - 2 r \cos x + r^2} dx = 2 \pi", ("r > 0",)),
)
OPEN = (  # integrals that have no value, or may have none
    (r"\int_0^{\pi} \frac{dt}{\cos^2 t} = 0", ()),
    (r"\int_0^{2\pi} \frac{dx}{1 + 2 \cos x} = 0", ()),
)
OSCILLATOR = (r"A = \begin{bmatrix} 0 & 1 \\ -\omega^2 & 0 \end{bmatrix}",)
SHIFT = (r"A = \begin{bmatrix} 0 & 1 & 0 \\ 0 & 0 & 1 \\ 0 & 0 & 0 \end{bmatrix}",)
DIAGONAL = (r"A = \begin{bmatrix} a & 0 \\ 0 & b \end{bmatrix}",)
EXPONENTIALS = {
    "proved": (
        (r"e^A = \begin{bmatrix} e^a & 0 \\ 0 & e^b \end{bmatrix}", DIAGONAL),
        (r"\det e^A = e^{\operatorname{tr} A}", DIAGONAL),
        (r"e^{A t} = \begin{bmatrix} 1 & t & t^2/2 \\ 0 & 1 & t \\ 0 & 0 & 1 \end{bmatrix}", SHIFT),
        (
            r"e^{A t} = \begin{bmatrix} \cos \omega t & \frac{1}{\omega} \sin \omega t \\"
            r" -\omega \sin \omega t & \cos \omega t \end{bmatrix}",
            OSCILLATOR,
        ),
        (
            r"e^A = \begin{bmatrix} \cosh a & \sinh a \\ \sinh a & \cosh a \end{bmatrix}",
            (r"A = \begin{bmatrix} 0 & a \\ a & 0 \end{bmatrix}",),
        ),
        (r"e^K = I + K + O(\omega^2)", (r"K = \begin{bmatrix} 0 & -\omega \\ \omega & 0 \end{bmatrix}",)),
    ),
    "refuted": (
        (r"e^{A t} = \begin{bmatrix} 1 & t & t^2 \\ 0 & 1 & t \\ 0 & 0 & 1 \end{bmatrix}", SHIFT),
        (r"e^A = \begin{bmatrix} e^b & 0 \\ 0 & e^a \end{bmatrix}", DIAGONAL),
        (r"e^K = K + O(\omega^2)", (r"K = \begin{bmatrix} 0 & -\omega \\ \omega & 0 \end{bmatrix}",)),
    ),
    "undecided": ((r"e^A = I", (r"A = \begin{bmatrix} a & b \\ c & d \end{bmatrix}",)),),
}


def verdict(relation: str, given: tuple[str, ...]) -> str:
    found = decide(relation, given=given)
    assert all(check(each) is None for each in found.certificate)  # type: ignore[arg-type]
    return found.verdict


@pytest.mark.parametrize("case", TRUE, ids=lambda case: case[0])
def test_what_holds_in_a_range_is_proved(case: tuple[str, tuple[str, ...]]) -> None:
    assert verdict(*case) == "proved"


@pytest.mark.parametrize("case", FALSE, ids=lambda case: case[0])
def test_what_fails_in_a_range_is_refuted_at_a_point_inside(case: tuple[str, tuple[str, ...]]) -> None:
    assert verdict(*case) == "refuted"


@pytest.mark.slow
@pytest.mark.parametrize("case", FALSE_AFTER_SECONDS, ids=lambda case: case[0])
def test_a_wrong_integral_is_refuted(case: tuple[str, tuple[str, ...]]) -> None:
    assert verdict(*case) == "refuted"


@pytest.mark.slow
@pytest.mark.parametrize("case", OPEN, ids=lambda case: case[0])
def test_an_integral_that_divides_by_zero_is_not_proved(case: tuple[str, tuple[str, ...]]) -> None:
    assert verdict(*case) in ("undecided", "refuted")


@pytest.mark.parametrize("wanted", EXPONENTIALS)
def test_an_exponential_of_a_matrix_is_read_where_its_form_is_known(wanted: str) -> None:
    for relation, where in EXPONENTIALS[wanted]:
        assert decide(relation, where=where).verdict == wanted, relation


@pytest.mark.slow
def test_a_false_statement_about_rotations_fails_at_units_and_quarter_turns() -> None:
    given, letters = (r"a \in SO(3)", r"x \in \mathbb{R}^3"), {"a": "matrix", r"\hat{x}": "skew matrix of x"}
    letters[r"\hat{y}"] = "skew matrix of y"
    where = r"a^{-1} e^{\hat{y}} = (a e^{\hat{x}})^{-1}"
    found = decide(r"e^{\hat{y}} = -a e^{\hat{x}} a^{-1}", where=where, given=given, letters=letters)
    assert found.verdict == "refuted"
    assert {*found.counterexample.values()} <= {"0", "1", "-1"}
