"""Beyond Esenkov 2006, with several modes: (1.31) is increasing between its poles, and its roots separate them.

Statements with three modes are proved as they stand. What holds for any number rests on what is proved mode by mode:
(1.31) is a sum over the modes (N.2, N.4), so a bound on each term is one on the sum, finite or convergent.

Open: with several modes in the band, how long a body must be to be unstable, and how many unstable pairs it has.
"""

from functools import partial
from itertools import combinations

from symcheck.core.claims import Hypothesis
from symcheck.papers.declare import Scope, ours
from symcheck.papers.esenkov2006 import derivation
from symcheck.papers.esenkov2006.notation import mode_letters, retaining, weight_letters
from symcheck.proof import cases, nonnegative
from symcheck.reading import Letter

modes = Scope(mode_letters, partial(derivation.left_side, 3))
at_frequencies = Scope(mode_letters, partial(derivation.values_at_natural_frequencies, 3), cases())

LEFT_SIDE = r"A\eta + (C - A)\omega_0 - \eta(\eta - \omega_0)\sum_{n=1}^{%d} \frac{E_n}{\eta - \lambda_n}"
OVER_DISTANCE = r"\sum_{n=1}^3 \frac{%s}{(x - \lambda_n)^2 + y^2}"  # squared distance of x + iy from the pole


def _total(of: str) -> str:
    """The sum of w_k times something over the four weights."""
    return rf"\sum_{{k=1}}^4 w_k {of}"


moving = Hypothesis("modes move", "every mode carries some inertia", "E_n > 0", printed=False)
parts = Hypothesis("modes are parts", "the modes together carry less than A", r"\sum_{n=1}^3 E_n < A", printed=False)
off_the_band = Hypothesis(
    "off the band", "no natural frequency lies between zero and the spin", r"\lambda_n(\lambda_n - \omega_0) > 0"
)
in_order = Hypothesis(
    "in order",
    "the natural frequencies differ; they are numbered upwards",
    r"\lambda_1 < \lambda_2, \lambda_2 < \lambda_3",
)

two_modes = ours(
    "N.1",
    28,
    words="The characteristic equation with two modes.",
    states=f"{LEFT_SIDE % 2} = 0",
    equation=partial(derivation.characteristic_equation, 2),
    where=partial(derivation.mode_inertias, 2),
    uses=["1.31"],
    notation=retaining(2),
)

one_more_mode = modes.ours(
    "N.2",
    28,
    words="A further mode adds its own term and changes nothing else.",
    states=rf"F - ({LEFT_SIDE % 2}) = -\eta(\eta - \omega_0)\frac{{E_3}}{{\eta - \lambda_3}}",
    uses=["1.31", "N.1"],
)

residues = ours(
    "N.3",
    28,
    words="Minus the residue at the pole lambda_n is E_n lambda_n (lambda_n - omega_0).",
    states=r"R_n = E_n\lambda_n(\lambda_n - \omega_0)",
    where=partial(derivation.minus_residues, 3),
    uses=["1.31"],
    notation=mode_letters,
)

partial_fraction = modes.ours(
    "N.4",
    28,
    words="Each term of (1.31), split into a linear function and a pole.",
    states=r"-\eta(\eta - \omega_0)\frac{E_n}{\eta - \lambda_n} = -E_n(\eta + \lambda_n - \omega_0) - "
    r"\frac{E_n\lambda_n(\lambda_n - \omega_0)}{\eta - \lambda_n}",
    uses=["N.3"],
)

band_in_ratios = modes.ours(
    "N.5",
    28,
    words="Off the band means for each mode what b_n < 0 or b_n > 1 means for one: lambda_n (lambda_n - omega_0) = omega_0^2 b_n (b_n - 1).",
    states=r"\lambda_n(\lambda_n - \omega_0) = \omega_0^2b_n(b_n - 1)",
    uses=["1.34.2", "B.9", "B.10"],
)

values_at_natural_frequencies = at_frequencies.ours(
    "N.6",
    28,
    words="The value of the polynomial of degree four at each natural frequency, and its leading coefficient.",
    states=r"P_1 = -E_1\lambda_1(\lambda_1 - \omega_0)(\lambda_1 - \lambda_2)(\lambda_1 - \lambda_3) \land "
    r"P_2 = -E_2\lambda_2(\lambda_2 - \omega_0)(\lambda_2 - \lambda_1)(\lambda_2 - \lambda_3) \land "
    r"P_3 = -E_3\lambda_3(\lambda_3 - \omega_0)(\lambda_3 - \lambda_1)(\lambda_3 - \lambda_2) \land "
    r"L = A - E_1 - E_2 - E_3",
    uses=["1.31"],
)

two_modes_change_sign = ours(
    "N.7",
    28,
    words="Two modes off the band: the polynomial of degree three has opposite signs at the two natural frequencies, so a root "
    "between them.",
    states="P_1P_2 < 0",
    given=[
        moving,
        off_the_band,
        Hypothesis("in order", "the second natural frequency is larger", r"\lambda_1 < \lambda_2"),
    ],
    where=partial(derivation.values_at_natural_frequencies, 2),
    by=nonnegative(
        r"E_1E_2(\lambda_1(\lambda_1 - \omega_0))(\lambda_2(\lambda_2 - \omega_0))(\lambda_2 - \lambda_1)^2",
    ),
    uses=["N.6"],
    notation=mode_letters.extended(Letter("n", kind="index", range=(1, 2))),
)

sign_pattern = at_frequencies.ours(
    "N.8",
    28,
    words="Three modes off the band: the signs at lambda_1, lambda_2, lambda_3 are -, +, -. The leading coefficient is positive and the degree even, "
    "so that the polynomial is positive far out on both sides: it changes its sign four times, and all four roots are real, "
    "one below, one above, one between each two neighbouring natural frequencies.",
    states="P_1 < 0, P_2 > 0, P_3 < 0, L > 0",
    given=[moving, parts, off_the_band, in_order],
    by=cases(
        r"E_1(\lambda_1(\lambda_1 - \omega_0))(\lambda_2 - \lambda_1)((\lambda_2 - \lambda_1) + (\lambda_3 - \lambda_2))",
        r"E_2(\lambda_2(\lambda_2 - \omega_0))(\lambda_2 - \lambda_1)(\lambda_3 - \lambda_2)",
        r"E_3(\lambda_3(\lambda_3 - \omega_0))((\lambda_2 - \lambda_1) + (\lambda_3 - \lambda_2))(\lambda_3 - \lambda_2)",
    ),
    uses=["N.6"],
)

between_two_poles = ours(
    "N.9",
    28,
    words="Any number of modes: near two neighbouring poles (1.31) is R_1/(lambda_1 - eta) + R_2/(lambda_2 - eta) + h with h regular on the interval "
    "between. Times (eta - lambda_1)(eta - lambda_2) it has opposite signs at the ends, so a root between, if both modes are off the band.",
    states="V_1V_2 < 0",
    given=[
        Hypothesis("residues", "R_1 and R_2 are positive: N.3 off the band", "R_1 > 0, R_2 > 0"),
        Hypothesis("in order", "the second natural frequency is larger", r"\lambda_1 < \lambda_2"),
    ],
    where=derivation.two_neighbouring_poles,
    by=nonnegative(r"R_1R_2(\lambda_2 - \lambda_1)^2"),
    uses=["N.3", "N.4"],
    notation=mode_letters,
)

slope = modes.ours(
    "N.10",
    28,
    words="The slope of (1.31) is A - sum E_n plus squares, each mode by itself.",
    states=r"\frac{dF}{d\eta} = A - \sum_{n=1}^3 E_n + \sum_{n=1}^3 \frac{E_n\lambda_n(\lambda_n - \omega_0)}{(\eta - \lambda_n)^2}",
    uses=["N.4"],
)

increasing = modes.ours(
    "N.11",
    28,
    words="Off the band (1.31) increases between its poles: exactly one root between two neighbouring ones.",
    states=r"\frac{dF}{d\eta} > 0",
    given=[moving, parts, off_the_band],
    by=nonnegative(
        r"1 \cdot (A - \sum_{n=1}^3 E_n) + \sum_{n=1}^3 \frac{E_n(\lambda_n(\lambda_n - \omega_0))}{(\eta - \lambda_n)^2}"
    ),
    uses=["N.10"],
)

imaginary_part = ours(
    "N.12",
    28,
    words="The imaginary part of (1.31) at eta = x + iy is y times A - sum E_n plus terms of the sign of lambda_n (lambda_n - omega_0).",
    states=r"u = y\left(A - \sum_{n=1}^3 E_n + %s\right)" % (OVER_DISTANCE % r"E_n\lambda_n(\lambda_n - \omega_0)"),
    where=partial(derivation.imaginary_part, 3),
    uses=["N.4"],
    notation=mode_letters,
)

roots_are_real = modes.by_cases.ours(
    "N.13",
    28,
    words="Any number of modes, all off the band, that carry less than A together: y (A - sum E_n + s) = 0 with s >= 0 leaves y = 0. All frequencies are real, "
    "for every C - A.",
    states=r"y(A - \sum_{n=1}^3 E_n + s) = 0 \Rightarrow y = 0",
    given=[parts, Hypothesis("sum", "s is the sum of N.12 over the modes, none of them negative", r"s \ge 0")],
    uses=["N.12"],
)

as_poles = modes.ours(
    "N.14",
    28,
    words="Divided by eta (eta - omega_0) the left side of (1.31) has poles only: a frequency satisfies "
    "C / (eta - omega_0) = (C - A) / eta + sum E_n / (eta - lambda_n).",
    states=r"F = \eta(\eta - \omega_0)\left(\frac{C}{\eta - \omega_0} - \frac{C - A}{\eta} - "
    r"\sum_{n=1}^3 \frac{E_n}{\eta - \lambda_n}\right)",
    uses=["1.31"],
)

imaginary_part_of_the_poles = ours(
    "N.15",
    28,
    words="Its imaginary part at eta = x + iy. Where it is zero and y is not, C / |eta - omega_0|^2 is the same sum of squares.",
    states=r"v = -y\left(\frac{C}{(x - \omega_0)^2 + y^2} - \frac{C - A}{x^2 + y^2} - %s\right)"
    % (OVER_DISTANCE % "E_n"),
    where=partial(derivation.imaginary_part_of_the_poles, 3),
    uses=["N.14"],
    notation=mode_letters,
)

PAIRS = tuple(rf"w_{j}w_{k}((x_{j} - x_{k})^2 + (y_{j} - y_{k})^2)" for j, k in combinations((1, 2, 3, 4), 2))

cauchy_inequality = ours(
    "N.16",
    28,
    words="Cauchy's inequality for weights w_k, here C - A and E_1, E_2, E_3, and the complex numbers x_k + i y_k, here 1 / eta and "
    "1 / (eta - lambda_n).",
    states=rf"({_total('')})({_total('(x_k^2 + y_k^2)')}) \ge ({_total('x_k')})^2 + ({_total('y_k')})^2",
    given=[Hypothesis("weights", "no weight is negative", r"w_1 \ge 0, w_2 \ge 0, w_3 \ge 0, w_4 \ge 0")],
    by=nonnegative(" + ".join(PAIRS)),
    equality=", ".join(f"{addend} = 0" for addend in PAIRS),
    notation=weight_letters,
)

instability_needs_a_long_body = ours(
    "N.17",
    28,
    words="Any number of modes, wherever their frequencies lie: instability needs C < A. Let C >= A, so that no weight is negative; their sum W is less than C, "
    "as the modes carry less than A. With r = 1 / |eta - omega_0|^2 and S the sum of w_k |eta - p_k|^{-2} N.15 says C r = S, and N.14 and N.16 say "
    "C^2 r <= W S. But W S is smaller.",
    states="WS < C^2r",
    given=[
        Hypothesis("imaginary part is zero", "relation N.15 for y not zero", "Cr = S"),
        Hypothesis("modes are parts", "the weights sum up to less than C", "W < C"),
        Hypothesis("positive", "C and r are positive", "C > 0, r > 0"),
    ],
    by=nonnegative("Cr(C - W)"),
    uses=["N.14", "N.15", "N.16"],
    notation=weight_letters,
)

mode_at_an_end_of_the_band = at_frequencies.ours(
    "N.18",
    28,
    words="A natural frequency at an end of the band, zero or the spin, is itself a frequency of the whole, whatever the other modes.",
    states=r"(\lambda_1 = 0 \lor \lambda_1 = \omega_0) \Rightarrow P_1 = 0",
    uses=["N.6", "B.22", "B.23"],
)
