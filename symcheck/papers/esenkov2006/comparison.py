"""The two texts of esenkov2006 compared: what one has lost stands in the other; and the signs in which they differ.

A lost sign or term is a letter here, so that the agreement of the legible rest is what determines it.
"""

from functools import partial

from symcheck.core.claims import Declaration, Hypothesis
from symcheck.papers.declare import by_cases, ours
from symcheck.papers.esenkov2006 import derivation, first_text, second_text
from symcheck.papers.esenkov2006.hypotheses import body_has_mass, spinning
from symcheck.papers.esenkov2006.notation import comparison_letters, notation, sign_letters, three_modes
from symcheck.papers.esenkov2006.scopes import in_b
from symcheck.reading import Letter

all_positive = Hypothesis(
    "general values",
    "no factor of what is lost is zero: A, E_n, omega_0, lambda_n are positive",
    r"A > 0, E_1 > 0, \omega_0 > 0, \lambda_1 > 0",
)


def _read(item: Declaration) -> str:
    """A damaged formula as it is read."""
    return item.source.damage.read_as if item.source.damage else " ".join(item.source.printed)


def _left(item: Declaration) -> str:
    """The left side of an equation "... = 0" as it is read."""
    return _read(item).removesuffix(" = 0")


def _members(item: Declaration) -> list[str]:
    return _read(item).replace(">", "=").split(" = ")


def _for_every_frequency(first: str, second: str) -> str:
    """That two polynomials of degree two in eta are one: their values and both derivatives."""
    of = (r"\frac{\partial^2}{\partial\eta^2}", r"\frac{\partial}{\partial\eta}", "")
    return r" \land ".join(f"{each}({first}) = {each}({second})" for each in of)


clockwise_signs = by_cases.ours(
    "C.1",
    26,
    words="For Omega = Omega_x - i Omega_y the law of angular momentum is A Omega' + i(C - A) omega_0 Omega + k' - i omega_0 k = M, with "
    "k = sum a_n S_n: the signs of the second text.",
    states=r"g = (C - A)\omega_0 \land h = -\omega_0",
    where=partial(derivation.signs_of_the_momentum_law, derivation.CLOCKWISE),
    uses=["1.0.6"],
    notation=sign_letters,
)

anticlockwise_signs = by_cases.ours(
    "C.2",
    26,
    words="For Omega = Omega_x + i Omega_y it is A Omega' + i(A - C) omega_0 Omega + k' + i omega_0 k = M: the signs of the first text.",
    states=r"g = (A - C)\omega_0 \land h = \omega_0",
    where=partial(derivation.signs_of_the_momentum_law, derivation.ANTICLOCKWISE),
    uses=["2.1", "2.1.1"],
    notation=sign_letters,
)

first_equations_differ = by_cases.ours(
    "C.3",
    26,
    words="So with one meaning of Omega the first text's i(A - C) and the second text's i(C - A) differ, unless all moments are equal.",
    states=r"(A - C)\omega_0 = (C - A)\omega_0 \Leftrightarrow A = C",
    given=[spinning],
    uses=["C.1", "C.2"],
)

sums_keep_one_term = by_cases.ours(
    "C.4",
    28,
    words="Neither (2.2) nor (1.31) is legible, so that the two cannot be compared as printed. As they are read, with one mode kept, "
    "each is the equation of the other text that follows: (2.2) becomes (1.32), and (1.31) becomes (2.3).",
    states=r"(E_2 = 0 \land E_3 = 0) \Rightarrow "
    rf"({_left(first_text.characteristic_equation)} = {_left(second_text.one_mode)} \land "
    rf"{_left(second_text.characteristic_equation)} = {_left(first_text.one_mode)})",
    uses=["2.2", "1.31", "2.3", "1.32"],
    notation=three_modes,
)

LEGIBLE = r"(A\eta + (C - A)\omega_0)"  # of (2.3) and (1.32), before the fraction

lost_fractions = by_cases.ours(
    "C.5",
    33,
    words="(2.3) has lost its fraction, (1.32) the numerator. The fraction that makes (2.3) times eta - lambda_1 the quadratic (1.33) of the "
    "other text is E_1 / (eta - lambda_1), and the numerator that makes (1.32) times it the quadratic 2.3.2 is E_1.",
    states=(
        rf"{LEGIBLE}(\eta - \lambda_1) - \eta(\eta - \omega_0)(\eta - \lambda_1)q = {_left(second_text.quadratic)} "
        r"\Leftrightarrow q = \frac{E_1}{\eta - \lambda_1}",
        rf"{LEGIBLE}(\eta - \lambda_1) - \eta(\eta - \omega_0)q = {_left(first_text.quadratic)} \Leftrightarrow q = E_1",
    ),
    given=[
        Hypothesis("fraction matters", "the fraction has a factor that is not zero", r"\eta(\eta - \omega_0) \ne 0")
    ],
    uses=["2.3", "1.32", "2.3.2", "1.33"],
    notation=notation.extended(Letter("q", meaning="a fraction, or the numerator of one, that is lost")),
)

lost_sign_of_delta = by_cases.ours(
    "C.6",
    34,
    words="The sign that the first text has lost in Delta = C - A is the minus of the second.",
    states=rf"C + sA = {_members(second_text.delta)[1]} \Leftrightarrow s = -1",
    given=[body_has_mass],
    uses=["2.3.1", "1.32.1"],
    notation=comparison_letters,
)

lost_parts_of_the_quadratics = by_cases.ours(
    "C.7",
    34,
    words="Each quadratic has lost one sign, the first also a term. With letters in these places the first is (1.33) for every eta "
    "exactly if the sign is a minus and the term omega_0 E_1, and the second is 2.3.2 exactly if its sign is a minus.",
    states=(
        _for_every_frequency(
            r"\eta^2(A + sE_1) + \eta(\Delta\omega_0 + x - A\lambda_1) - \Delta\omega_0\lambda_1",
            _left(second_text.quadratic),
        )
        + r" \Leftrightarrow (s = -1 \land x = \omega_0 E_1)",
        _for_every_frequency(
            r"\eta^2(A - E_1) + \eta(\Delta\omega_0 + \omega_0 E_1 + rA\lambda_1) - \Delta\omega_0\lambda_1",
            _left(first_text.quadratic),
        )
        + r" \Leftrightarrow r = -1",
    ),
    given=[all_positive],
    uses=["2.3.2", "1.33"],
    notation=comparison_letters,
)

lost_signs_of_the_discriminants = by_cases.ours(
    "C.8",
    34,
    words="Both discriminants have lost both signs. The equation of the boundary, 1.33.4, has them: with s and r for the lost signs "
    "D is its left side exactly if both are minus.",
    states=r"(\Delta\omega_0 + \omega_0 E_n + sA\lambda_n)^2 + 4(A + rE_n)\Delta\omega_0\lambda_n = "
    rf"{_left(second_text.boundary)} \Leftrightarrow (s = -1 \land r = -1)",
    given=[
        all_positive,
        Hypothesis("Delta positive", "C is larger than A", r"\Delta > 0"),
        Hypothesis("signs", "s and r are signs", "s^2 = 1, r^2 = 1"),
    ],
    uses=["2.3.4", "1.33.3", "1.33.4"],
    notation=comparison_letters.extended(Letter("n", kind="index", range=(1,))),
)

lost_term = ours(
    "C.9",
    34,
    words="What the first text's quadratic lacks, taken literally, is eta omega_0 E_1; its own D has it.",
    states=rf"{_left(first_text.quadratic)} - "
    r"(\eta^2(A - E_1) + \eta(\Delta\omega_0 - A\lambda_1) - \Delta\omega_0\lambda_1) = \eta\omega_0 E_1",
    uses=["2.3.2"],
)

lost_ratio = in_b.by_cases.ours(
    "C.10",
    34,
    words="The square in 1.34.3 taken literally, without b_n, would be right only for b_n = 1, or for the one ratio b_n = 2 E_n / A - 1.",
    states=r"(A - E_n)^2 = (Ab_n - E_n)^2 \Leftrightarrow (b_n = 1 \lor A(1 + b_n) = 2E_n)",
    given=[body_has_mass],
    uses=["1.34.3"],
)

consistent_signs = by_cases.ours(
    "C.11",
    26,
    words="Of the two sign patterns of the law of angular momentum, i(A - C) with + i omega_0 and i(C - A) with - i omega_0, and the two "
    "substitutions p = i eta and p = -i eta, the first with the second and the second with the first give (2.3). The other two give one "
    "further equation, in which the sign of the spin is changed.",
    states=rf"G = {_left(first_text.one_mode)} \land H = {_left(first_text.one_mode)} \land "
    r"F = A\eta - (C - A)\omega_0 - \eta(\eta + \omega_0)\frac{E_1}{\eta - \lambda_1} \land "
    r"K = A\eta - (C - A)\omega_0 - \eta(\eta + \omega_0)\frac{E_1}{\eta - \lambda_1}",
    where=derivation.characteristic_equations_by_signs,
    uses=["2.1.4", "C.1", "C.2"],
    notation=sign_letters,
)
