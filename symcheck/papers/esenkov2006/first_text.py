"""Esenkov 2006, page 29: the freely spinning body with ideal liquid.

The OCR put the formulas behind the prose, lost the fractions and most minus signs. The formulas are read here without
regard to the other text; `comparison` shows that the two agree.
"""

from functools import partial

from symcheck.core.claims import Damage, Erratum, Hypothesis
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import claim, definition, premise
from symcheck.papers.esenkov2006 import both_texts, derivation
from symcheck.papers.esenkov2006.both_texts import AT_X, AT_Y, DISCRIMINANT, ONE_MODE, QUADRATIC
from symcheck.papers.esenkov2006.hypotheses import liquid_is_part
from symcheck.papers.esenkov2006.notation import root_letters, sign_letters, three_modes
from symcheck.papers.esenkov2006.scopes import in_delta
from symcheck.proof import existence

symmetric_body = premise(
    "2.0.1", 7, words="The body is dynamically symmetric: its two transverse moments of inertia are equal (A, A, C)."
)

constant_spin = premise(
    "2.0.2",
    8,
    words="In the system (1.13), which is not in the text, the perturbation of the third component of the angular "
    "velocity is zero: the spin stays omega_0. No torque acts along the axis.",
)

EITHER_SIGN = r" \lor ".join(
    rf"(\Omega = \Omega_x {sign} i\Omega_y = p {sign} iq \land M = M_x {sign} iM_y)" for sign in ("+", "-")
)

joined_components = premise(
    "2.1.1",
    10,
    ("Q = iQy = p i q", "М = М х iM у"),
    words="The transverse components are joined into complex numbers. The letter p is an angular velocity here, and the "
    "exponent of the motion two lines further on.",
    damage=Damage(
        EITHER_SIGN,
        reason="The sign is lost three times, and this line does not tell which it was, so both are left open. A minus goes with "
        "i(C - A) and - i omega_0 in the law of angular momentum (C.1), as in the other text; a plus goes with i(A - C) "
        "and + i omega_0 (C.2), as (2.1) prints. For the minus: wherever a lost sign of the two texts can be told, it is one.",
    ),
)

angular_momentum_of_a_mode = definition(
    "2.1.2",
    10,
    "ап = р хп",
    words="The angular momentum of a mode per unit amplitude is the density times its coupling chi_n.",
    states=r"a_n = \rho \chi_n",
    damage=Damage(
        r"a_n = \rho \chi_n",
        reason="p for rho and x for chi, as the Latin letters look; the density makes a_n chi_n / N_n^2 a moment of inertia.",
    ),
    notation=three_modes,
)

no_torque = premise(
    "2.1.3",
    11,
    "М=0",
    words="The motion without torque is considered.",
    damage=Damage("M = 0", reason="a Cyrillic letter for M"),
)

main_term = premise(
    "2.2.1",
    12,
    "(я=1)",
    words="In a first approximation one main term of the infinite sum is kept, n = 1.",
    damage=Damage("n = 1", reason="the italic n of the other text's (n = 1), read as a Cyrillic letter"),
)

frequencies = claim(
    "2.1.4",
    12,
    "(р = IT}, р„ = /Л„)",
    words="With p = i eta and p_n = i lambda_n the system (2.1), as its signs are printed, has the characteristic "
    "equation (2.3) in the frequencies.",
    states=rf"F = {ONE_MODE}",
    where=derivation.characteristic_equations_by_signs,
    uses=["2.1", "2.3"],
    notation=sign_letters,
    errata={
        "": Erratum(
            rf"G = {ONE_MODE} \land H = {ONE_MODE}",
            "contradicting signs",
            Origin.UNCERTAIN,
            "(2.1), the substitution p = i eta, p_n = i lambda_n, and (2.3) contradict each other: with the signs of (2.1), "
            "i(A - C) and + i omega_0, the substitution gives A eta - (C - A) omega_0 and eta (eta + omega_0), and (2.3) has "
            "A eta + (C - A) omega_0 and eta (eta - omega_0). This does not depend on the sign that 2.1.1 has lost. A change "
            "of one place mends all, and there are two such places (C.11): (2.1) with i(C - A) and - i omega_0, the lost sign then "
            "being a minus; or the substitution p = -i eta, p_n = -i lambda_n, the lost sign then being a plus. (2.3) is no "
            "third: all that follows rests on it. The other text speaks for (2.1): it agrees in all else, and it has C - A in this place "
            "(1.0.6). But both signs of (2.1) are legible, and the OCR loses minus signs before letters, so that a minus may be "
            "lost in the substitution; what the author wrote cannot be told.",
            summary=r"(2.1), the substitution $p = i\eta$, $p_n = i\lambda_n$ and (2.3) contradict each other; one of the first two "
            "is to be changed.",
            instead=r"either $i(C - A)$ and $-i\omega_0$ in (2.1), or $p = -i\eta$, $p_n = -i\lambda_n$",
        )
    },
)

characteristic_equation = claim(
    "2.2",
    12,
    "I п п",
    words="The characteristic equation with the sum over all modes; nothing but a few strokes is left of it.",
    damage=Damage(
        r"A\eta + (C - A)\omega_0 - \eta(\eta - \omega_0)\sum_n \frac{E_n}{\eta - \lambda_n} = 0",
        reason="The next sentence keeps one term of its infinite sum, and that equation, (2.3), is left in both texts. Read "
        "here with three modes; each further mode adds one more term (N.2).",
    ),
    equation=partial(derivation.characteristic_equation, 3),
    where=derivation.mode_inertias,
    uses=["2.1", "2.1.2"],
    notation=three_modes,
)

system = premise(
    "2.1",
    13,
    ("А й + i(A С)сойО.", "+ а„(Sn+ici)aSn) = M(t)"),
    words="The law of angular momentum of the body with its liquid. The equation of the modes is lost: N_n^2 (S_n' - p_n S_n) "
    "+ chi_n Omega' = 0 is what gives the fraction of (2.3).",
    damage=Damage(
        r"A\dot{\Omega} + i(A - C)\omega_0\Omega + \sum_n a_n(\dot{S}_n + i\omega_0 S_n) = M(t)",
        reason="A dot over Omega reads as a short i, omega_0 as 'co' and 'ici)a'; a minus is lost in (A C). The order A - C and the plus "
        "before i omega_0 are legible; the other text has C - A.",
    ),
)

delta = definition(
    "2.3.1",
    13,
    "(А = С А)",
    states=r"\Delta = C - A",
    damage=Damage(r"\Delta = C - A", reason="Delta reads as A; the other text has it with its minus (1.32.1)."),
)

roots_must_be_real = both_texts.roots_must_be_real("2.3.5", 13, "2.3.2")

positive_discriminant_suffices = in_delta.claim(
    "2.3.3",
    13,
    words="A positive discriminant makes them so: with r = sqrt D there are two real roots, and they differ.",
    states=rf"\exists x, y: ({AT_X} = 0 \land {AT_Y} = 0 \land x \ne y)",
    given=[
        Hypothesis("positive discriminant", "D = r^2 with r > 0", rf"{DISCRIMINANT} = r^2, r > 0"),
        liquid_is_part,
    ],
    by=existence(
        x=r"\frac{r - (\Delta\omega_0 + \omega_0 E_1 - A\lambda_1)}{2(A - E_1)}",
        y=r"\frac{-r - (\Delta\omega_0 + \omega_0 E_1 - A\lambda_1)}{2(A - E_1)}",
    ),
    uses=["2.3.2", "2.3.4"],
    notation=root_letters,
)

positive_discriminant_is_needed = both_texts.positive_discriminant_is_needed("2.3.6", 13, "2.3.2", "2.3.4")

one_mode = claim(
    "2.3",
    14,
    ("£ Atj+(C-A)co0-т](г}-щ)— '— =0.", "i i \\"),
    words="The characteristic equation with one mode.",
    damage=Damage(
        rf"{ONE_MODE} = 0",
        reason="eta reads as tj, т], г} and omega_0 as co0, щ; the fraction is lost but for its bar (the first sign may be the sum of (2.2)). The other text keeps its "
        "denominator, eta - lambda_1; multiplied by it the equation is the quadratic 2.3.2, whose coefficients give the numerator E_1.",
    ),
    equation=partial(derivation.characteristic_equation, 1),
    where=partial(derivation.mode_inertias, 1),
    uses=["2.2", "2.2.1"],
)

quadratic = claim(
    "2.3.2",
    15,
    "r f ( A E {) + ^ ( A cOq -Д Л ,)-А <у0/11= 0",
    words="The same multiplied by eta - lambda_1.",
    damage=Damage(
        rf"{QUADRATIC} = 0",
        reason="eta^2 reads as 'r f', Delta as A, A lambda_1 as 'Д Л ,'. The term omega_0 E_1 is missing in the bracket, where there is a gap; it "
        "stands in the square of D on the same line, and in (1.33) of the other text.",
    ),
    equation=derivation.quadratic,
    uses=["2.3", "2.3.1"],
)

discriminant = claim(
    "2.3.4",
    15,
    "D = (Aco0+o)QEnАлпУ + 4(A En)Ай)0Лп>0",
    words="Its discriminant, required to be positive. The mode is called n here, 1 in the quadratic: it is the one that is kept.",
    damage=Damage(
        rf"D = {DISCRIMINANT} > 0",
        reason="Delta omega_0 reads as Aco0 and Ай)0, omega_0 E_n as 'o)QEn', the closing square as У; the minus signs are lost. The other text has "
        "the same and its expansion (1.34.2) besides.",
    ),
    where=derivation.discriminant_in_eta,
    imposed="b",
    uses=["2.3.2"],
)
