"""The quadratic characteristic equation, which both texts print, and what both say of its roots."""

from symcheck.core.claims import Claim, Hypothesis
from symcheck.papers.declare import claim
from symcheck.papers.esenkov2006 import derivation
from symcheck.papers.esenkov2006.hypotheses import liquid_is_part
from symcheck.papers.esenkov2006.notation import conjugate_root_letters, root_letters
from symcheck.papers.esenkov2006.scopes import in_delta
from symcheck.proof import cases, identity

ONE_MODE = r"A\eta + (C - A)\omega_0 - \eta(\eta - \omega_0)\frac{E_1}{\eta - \lambda_1}"
QUADRATIC = r"\eta^2(A - E_1) + \eta(\Delta\omega_0 + \omega_0 E_1 - A\lambda_1) - \Delta\omega_0\lambda_1"
DISCRIMINANT = r"(\Delta\omega_0 + \omega_0 E_n - A\lambda_n)^2 + 4(A - E_n)\Delta\omega_0\lambda_n"

AT_X, AT_Y = QUADRATIC.replace(r"\eta", "x"), QUADRATIC.replace(r"\eta", "y")
# of the quadratic at x - iy
REAL_PART = r"(A - E_1)(x^2 - y^2) + (\Delta\omega_0 + \omega_0 E_1 - A\lambda_1)x - \Delta\omega_0\lambda_1"
IMAGINARY_PART = r"2(A - E_1)x(-y) + (\Delta\omega_0 + \omega_0 E_1 - A\lambda_1)(-y)"


def roots_must_be_real(number: str, line: int, quadratic: str) -> Claim:
    """What stability asks of the roots."""
    return claim(
        number,
        line,
        words="For stability the roots must be real: with x + iy also x - iy is a root (a). As e^{pt} has the modulus "
        "e^{-yt}, neither grows only if y and -y are squares, not negative: then y = 0 (b).",
        states=(
            rf"(u = 0 \land v = 0) \Rightarrow ({REAL_PART} = 0 \land {IMAGINARY_PART} = 0)",
            r"(y = s^2 \land -y = r^2) \Rightarrow y = 0",
        ),
        where=derivation.quadratic_at_complex_frequency,
        by={"a": cases(), "b": cases("s^2 + r^2")},
        uses=[quadratic],
        notation=conjugate_root_letters,
    )


def positive_discriminant_is_needed(number: str, line: int, quadratic: str, discriminant: str) -> Claim:
    """That they are real and differ only where the discriminant is positive."""
    return in_delta.claim(
        number,
        line,
        words="And no other does: for two real roots that differ D is the square (a) of something that is not zero (b). (At D = 0 they are one, and the motion grows: B.4, B.5.)",
        states=(rf"{DISCRIMINANT} = (A - E_1)^2(x - y)^2", r"(A - E_1)(x - y) \ne 0"),
        given=[
            Hypothesis(
                "two real roots", "x and y are real roots, and they differ", rf"{AT_X} = 0, {AT_Y} = 0, x \ne y"
            ),
            liquid_is_part,
        ],
        by={"a": identity, "b": cases()},
        uses=[quadratic, discriminant],
        notation=root_letters,
    )
