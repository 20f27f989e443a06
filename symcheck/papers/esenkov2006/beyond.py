"""Beyond Esenkov 2006, with one mode: when the frequencies are real, and for which C - A they are not.

Square roots appear as letters, u^2 = E_n (1 - b_n), v^2 = b_n (A - E_n), u, v >= 0; (1.35) has them as roots.
"""

from symcheck.core.claims import Hypothesis
from symcheck.papers.declare import by_cases, ours
from symcheck.papers.esenkov2006 import derivation
from symcheck.papers.esenkov2006.both_texts import DISCRIMINANT, QUADRATIC
from symcheck.papers.esenkov2006.hypotheses import liquid_is_part, liquid_moves
from symcheck.papers.esenkov2006.notation import root_letters, three_modes
from symcheck.papers.esenkov2006.scopes import in_b, in_b_and_delta, in_delta, of_roots
from symcheck.papers.esenkov2006.second_text import BOUNDARY
from symcheck.proof import existence, identity, nonnegative

LINEAR = r"(\Delta\omega_0 + \omega_0 E_1 - A\lambda_1)"  # coefficient of eta in (1.33)
MIDDLE = r"(E_n(1 - b_n) + b_n(A - E_n))"  # minus the mean of the two boundaries
PRODUCT = r"E_n(1 - b_n)b_n(A - E_n)"

density = Hypothesis("density", "the liquid has a density", r"\rho > 0", printed=False)
coupled = Hypothesis(
    "coupled",
    "the mode feels the turning of the body; its amplitude is counted so that both numbers are positive",
    r"\chi_n > 0, N_n > 0",
    printed=False,
)
two_coefficients = Hypothesis("mode is not all", "(1.33) is of second degree", r"A \ne E_n")
resonant = Hypothesis("between 0 and 1", "the natural frequency lies between zero and the spin", r"0 < b_n, b_n < 1")
resonant_or_at_an_end = Hypothesis("from 0 to 1", "b_n lies between 0 and 1, ends included", r"0 \le b_n \le 1")
against_the_spin = Hypothesis("against the spin", "the mode turns against the spin", r"b_n < 0")
faster_than_the_spin = Hypothesis("faster than the spin", "the mode is faster than the spin", r"b_n > 1")
roots = Hypothesis(
    "roots",
    "u and v are the roots of E_n (1 - b_n) and b_n (A - E_n)",
    r"u^2 = E_n(1 - b_n), v^2 = b_n(A - E_n), u \ge 0, v \ge 0",
)
double = Hypothesis("boundary", "D = 0", rf"{DISCRIMINANT} = 0")

inertia_of_a_mode = ours(
    "B.1",
    10,
    words="A mode's moment of inertia rho chi_n^2 / N_n^2 is positive.",
    states="E_n > 0",
    given=[density, coupled],
    where=derivation.mode_inertias,
    by=nonnegative(r"\frac{\rho\chi_n^2}{N_n^2}"),
    uses=["2.1.2"],
    notation=three_modes,
)

real_root_needs_discriminant = in_delta.by_cases.ours(
    "B.2",
    34,
    words="A real root needs D >= 0: then D is the square of the derivative there.",
    states=rf"{QUADRATIC} = 0 \Rightarrow {DISCRIMINANT} = (2(A - E_1)\eta + {LINEAR})^2",
    uses=["1.33", "1.33.3"],
)

zero_discriminant_has_a_real_root = of_roots.ours(
    "B.3",
    34,
    words="D > 0, as it is required, is more than real roots need: D = r^2 with r >= 0 is enough, zero included.",
    states=rf"\exists x: {QUADRATIC.replace(chr(92) + 'eta', 'x')} = 0",
    given=[
        Hypothesis("discriminant not negative", "D = r^2 with r >= 0", rf"{DISCRIMINANT} = r^2, r \ge 0"),
        two_coefficients,
    ],
    by=existence(x=rf"\frac{{r - {LINEAR}}}{{2(A - E_1)}}"),
    uses=["B.2"],
    keeping=("Delta",),
)

double_root = in_delta.ours(
    "B.4",
    34,
    words="At D = 0 the root is double.",
    states=rf"4(A - E_1)({QUADRATIC}) = (2(A - E_1)\eta + {LINEAR})^2",
    given=[double],
    uses=["B.2"],
)

growth_at_the_double_root = by_cases.ours(
    "B.5",
    34,
    words="There the motion still grows, like t: the matrix of the amplitudes, with entries a_n (eta - omega_0) and chi_n eta outside its "
    "diagonal, would vanish only without spin, so it has rank one and a Jordan block. D > 0 is right for stability, though the roots "
    "are real at D = 0 too.",
    states=r"(a_n(\eta - \omega_0) = 0 \land \chi_n\eta = 0) \Rightarrow \omega_0 = 0",
    given=[density, coupled],
    uses=["B.4", "2.1.2"],
)

complex_pair = by_cases.ours(
    "B.6",
    34,
    words="If D = -r^2 < 0 the roots are x + iy, x - iy with y = r / (2 (A - E_n)): one of them grows.",
    states=r"u = 0 \land v = 0",
    given=[
        Hypothesis(
            "negative discriminant",
            "D = -r^2, and x, y from the formula for the roots",
            rf"{DISCRIMINANT} = -r^2, 2(A - E_1)x = -{LINEAR}, 2(A - E_1)y = r",
        ),
        two_coefficients,
    ],
    where=derivation.quadratic_at_complex_frequency,
    uses=["1.33.1"],
    notation=root_letters,
)

boundary_as_difference = in_b_and_delta.ours(
    "B.7",
    34,
    words="The square completed in 1.34.3.",
    states=rf"{BOUNDARY} = (\Delta + {MIDDLE})^2 - 4{PRODUCT}",
    uses=["1.34.3", "1.34.4"],
)

discriminant_by_boundary = in_delta.ours(
    "B.8",
    34,
    words="D has the sign of the left side of 1.34.3.",
    states=rf"{DISCRIMINANT} = \omega_0^2({BOUNDARY})",
    uses=["1.33.3", "1.34.3"],
)

stable_against_the_spin = in_b_and_delta.ours(
    "B.9",
    34,
    words="If b_n < 0 the frequencies are real and distinct for every C - A.",
    states=rf"{BOUNDARY} > 0",
    given=[liquid_moves, liquid_is_part, against_the_spin],
    by=nonnegative(rf"(\Delta + {MIDDLE})^2 + 4E_n(-b_n)(1 + (-b_n))(A - E_n)"),
    uses=["B.7", "B.8"],
)

stable_faster_than_the_spin = in_b_and_delta.ours(
    "B.10",
    34,
    words="So they are if b_n > 1.",
    states=rf"{BOUNDARY} > 0",
    given=[liquid_moves, liquid_is_part, faster_than_the_spin],
    by=nonnegative(rf"(\Delta + {MIDDLE})^2 + 4E_n((b_n - 1) + 1)(b_n - 1)(A - E_n)"),
    uses=["B.7", "B.8"],
)

boundary_in_factors = of_roots.ours(
    "B.11",
    34,
    words="For 0 <= b_n <= 1 it has the roots -(u - v)^2 and -(u + v)^2: (1.35) with the opposite sign in the square.",
    states=rf"{BOUNDARY} = (\Delta + (u - v)^2)(\Delta + (u + v)^2)",
    given=[roots],
    by=identity,
    uses=["1.35"],
)

inside = Hypothesis("inside", "C - A lies between the two boundaries", r"-(u + v)^2 < \Delta, \Delta < -(u - v)^2")
below = Hypothesis("below", "C - A lies below both boundaries", r"\Delta < -(u + v)^2")
above = Hypothesis("above", "C - A lies above both boundaries", r"\Delta > -(u - v)^2")

unstable_interval = of_roots.ours(
    "B.12",
    34,
    words="D < 0, instability, between the two.",
    states=rf"{BOUNDARY} < 0",
    given=[roots, inside],
    by=nonnegative(r"(\Delta + (u + v)^2)(-(u - v)^2 - \Delta)"),
    uses=["B.11"],
)

stable_below = of_roots.ours(
    "B.13",
    34,
    words="D > 0 below them, in very long bodies.",
    states=rf"{BOUNDARY} > 0",
    given=[roots, below],
    by=nonnegative(r"(-(u + v)^2 - \Delta)((-(u + v)^2 - \Delta) + 4uv)"),
    uses=["B.11"],
)

stable_above = of_roots.ours(
    "B.14",
    34,
    words="D > 0 above them. So D > 0 exactly outside the closed interval, and D = 0 at its ends (B.11).",
    states=rf"{BOUNDARY} > 0",
    given=[roots, above],
    by=nonnegative(r"(\Delta + (u - v)^2)((\Delta + (u - v)^2) + 4uv)"),
    uses=["B.11"],
)

unstable_interval_without_roots = in_b_and_delta.by_cases.ours(
    "B.15",
    34,
    words="The same without square roots: the distance of C - A from the middle, squared, is below 4 E_n (1 - b_n) b_n (A - E_n).",
    states=rf"{BOUNDARY} < 0 \Leftrightarrow (\Delta + {MIDDLE})^2 < 4{PRODUCT}",
    uses=["B.7"],
)

width = of_roots.ours(
    "B.16",
    34,
    words="The interval is 4 u v wide, that is 4 sqrt(E_n (1 - b_n) b_n (A - E_n)).",
    states=rf"-(u - v)^2 - (-(u + v)^2) = 4uv \land (4uv)^2 = 16{PRODUCT}",
    given=[roots],
    uses=["B.12"],
    keeping=("b",),
)

width_is_positive = in_b.ours(
    "B.17",
    34,
    words="It is not empty for 0 < b_n < 1.",
    states=rf"{PRODUCT} > 0",
    given=[liquid_moves, liquid_is_part, resonant],
    by=nonnegative(PRODUCT),
    uses=["B.16"],
)

flattened_body_is_stable = in_b_and_delta.ours(
    "B.18",
    34,
    words="Instability needs C < A: with 0 <= b_n <= 1 and C >= A the left side of 1.34.3, and D with it, is not negative.",
    states=rf"{BOUNDARY} \ge 0",
    given=[liquid_moves, liquid_is_part, resonant_or_at_an_end, Hypothesis("flattened", "C >= A", r"\Delta \ge 0")],
    by=nonnegative(r"\Delta^2 + 2\Delta(b_n(A - E_n) + E_n(1 - b_n)) + (Ab_n - E_n)^2"),
    equality=r"\Delta = 0, Ab_n = E_n",
    uses=["B.9", "B.10", "B.12"],
)

boundary_touches_equal_moments = of_roots.ours(
    "B.19",
    34,
    words="The upper end of the interval is C = A exactly when A b_n = E_n.",
    states=r"-(u - v)^2 = 0 \Leftrightarrow Ab_n = E_n",
    given=[roots],
    uses=["B.12"],
    keeping=("b",),
)

lower_end_is_a_body = of_roots.ours(
    "B.20",
    34,
    words="Every C of the interval is that of a body: at its lower end C = (s - w)^2 >= 0 with s = sqrt(b_n E_n), w = sqrt((1 - b_n)(A - E_n)).",
    states=r"A - (u + v)^2 = (s - w)^2",
    given=[
        roots,
        Hypothesis(
            "further roots",
            "s and w are the roots of b_n E_n and (1 - b_n)(A - E_n), so that u v = s w",
            r"s^2 = b_nE_n, w^2 = (1 - b_n)(A - E_n), s \ge 0, w \ge 0, uv = sw",
        ),
    ],
    by=identity,
    uses=["B.12"],
    keeping=("b",),
)

value_without_axial_moment = in_b_and_delta.by_cases.ours(
    "B.21",
    34,
    words="The same without square roots: at C = 0 the left side of 1.34.3 is a square.",
    states=rf"\Delta = -A \Rightarrow {BOUNDARY} = (A(1 - b_n) - E_n)^2",
    uses=["1.34.3"],
)

mode_at_rest = in_b_and_delta.by_cases.ours(
    "B.22",
    34,
    words="At b_n = 0 the interval shrinks to C - A = -E_n; one frequency is zero, the other -(Delta + E_n) omega_0 / (A - E_n).",
    states=rf"b_n = 0 \Rightarrow ({BOUNDARY} = (\Delta + E_n)^2 \land "
    rf"{QUADRATIC.replace('lambda_1', 'lambda_n')} = \eta((A - E_n)\eta + (\Delta + E_n)\omega_0))".replace(
        r"\lambda_n", r"b_n\omega_0"
    ),
    uses=["1.33", "1.34.3"],
)

mode_at_the_spin = in_b_and_delta.by_cases.ours(
    "B.23",
    34,
    words="At b_n = 1 it shrinks to C - A = -(A - E_n), C = E_n; one frequency is omega_0, the other -Delta omega_0 / (A - E_n).",
    states=rf"b_n = 1 \Rightarrow ({BOUNDARY} = (\Delta + A - E_n)^2 \land "
    rf"{QUADRATIC.replace('lambda_1', 'lambda_n')} = (\eta - \omega_0)((A - E_n)\eta + \Delta\omega_0))".replace(
        r"\lambda_n", r"b_n\omega_0"
    ),
    uses=["1.33", "1.34.3"],
)

mode_is_everything = in_b_and_delta.by_cases.ours(
    "B.24",
    34,
    words="At A = E_n it shrinks to C - A = -E_n (1 - b_n), and (1.33) is of first degree: one frequency has gone to infinity.",
    states=rf"A = E_n \Rightarrow ({BOUNDARY} = (\Delta + E_n(1 - b_n))^2 \land "
    rf"{QUADRATIC} = \omega_0((\Delta + E_n(1 - b_n))\eta - \Delta b_n\omega_0))".replace(r"\lambda_1", r"b_n\omega_0"),
    uses=["1.33", "1.34.3"],
)

more_than_the_body = in_b_and_delta.ours(
    "B.25",
    34,
    words="That the mode is part of the body matters: with E_n > A the roles are exchanged, and 0 < b_n < 1 is stable for every C - A.",
    states=rf"{BOUNDARY} > 0",
    given=[liquid_moves, resonant, Hypothesis("more than the body", "E_n > A", "E_n > A")],
    by=nonnegative(rf"(\Delta + {MIDDLE})^2 + 4E_n(1 - b_n)b_n(E_n - A)"),
    uses=["B.7"],
)


def _critical(sign: str, opposite: str) -> str:
    """(1.33), times A - E_n, at the boundary -(u sign v)^2, where the double root is opposite omega_0 v (u sign v)/(A - E_n)."""
    quadratic = QUADRATIC.replace(r"\lambda_1", r"b_n\omega_0")
    root = rf"((A - E_n)\eta {opposite} \omega_0v(u {sign} v))"
    return rf"\Delta = -(u {sign} v)^2 \Rightarrow (A - E_n)({quadratic}) = {root}^2"


critical_frequency_above = of_roots.ours(
    "B.26",
    34,
    words="At the upper end the double frequency is -omega_0 v (u - v) / (A - E_n).",
    states=_critical("-", "+"),
    given=[roots],
    uses=["B.4", "B.11"],
)

critical_frequency_below = of_roots.ours(
    "B.27",
    34,
    words="At the lower end it is omega_0 v (u + v) / (A - E_n).",
    states=_critical("+", "-"),
    given=[roots],
    uses=["B.4", "B.11"],
)

boundaries_by_their_sum = in_b.ours(
    "B.28",
    34,
    words="The width once more from the coefficients of 1.34.3.",
    states=rf"(\Delta_1 - \Delta_2)^2 = 16{PRODUCT}",
    given=[
        Hypothesis(
            "roots of the boundary",
            "Delta_1 and Delta_2 are the roots of 1.34.3",
            r"\Delta_1 + \Delta_2 = -(2Ab_n + 2E_n - 4E_nb_n), \Delta_1\Delta_2 = (Ab_n - E_n)^2",
        )
    ],
    uses=["1.34.4"],
)

value_at_the_natural_frequency = by_cases.ours(
    "B.29",
    34,
    words="At the natural frequency the left side of (1.33) is below zero off the band, while it grows without bound on both sides: "
    "one frequency on each side. With several modes this is N.6 to N.8.",
    states=rf"\eta = \lambda_1 \Rightarrow {QUADRATIC} = -E_1\lambda_1(\lambda_1 - \omega_0)",
    uses=["1.33"],
)
