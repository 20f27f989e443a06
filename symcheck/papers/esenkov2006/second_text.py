"""Esenkov 2006, pages 34-35: the necessary condition of stability for ideal liquid, and the boundary of stability.

The formulas are read here without regard to the first text; `comparison` shows that the two agree.
"""

from functools import partial

from symcheck.core.claims import Damage, Erratum, Hypothesis
from symcheck.core.problems import Applied
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import claim, definition, exclusion, premise
from symcheck.papers.esenkov2006 import both_texts, derivation
from symcheck.papers.esenkov2006.both_texts import DISCRIMINANT, ONE_MODE, QUADRATIC
from symcheck.papers.esenkov2006.hypotheses import (
    liquid_is_part,
    liquid_moves,
    roots_are_real_numbers,
)
from symcheck.papers.esenkov2006.notation import root_letters, three_modes
from symcheck.papers.esenkov2006.scopes import in_b, in_b_and_delta, in_delta
from symcheck.proof import cases, looking_at, theorems

BOUNDARY = r"\Delta^2 + \Delta(2Ab_n + 2E_n - 4E_nb_n) + (Ab_n - E_n)^2"
RADICAL = r"2\sqrt{E_n(1 - b_n)b_n(A - E_n)}"

viscous_fragment = exclusion(
    "1.0.1",
    18,
    "1 1 Jp + 2i(o0 ylp-2ia)0 1 j [ Any/v ylp-2ic»o J P",
    reason="The end of a formula for viscous liquid, of which the document has no other occurrence: square roots of p + 2 i omega_0 "
    "and p - 2 i omega_0, and a lambda_n times the root of nu, can be guessed, what joins them cannot.",
)

results_are_cited = exclusion(
    "1.0.2", 19, words="What 1.2 and 1.3 contain was published in [17, 24, 67].", reason="refers to other papers"
)

analysis_announced = exclusion(
    "1.0.3", 20, words="It serves to analyse the stability of the unperturbed motion.", reason="says what follows"
)

symmetric_body = premise(
    "1.0.4",
    23,
    words="A necessary condition of stability is sought for a dynamically symmetric body (moments A, A, C) with ideal liquid.",
)

constant_spin = premise(
    "1.0.5",
    24,
    words="In the system (1.13), which is not in the text, the perturbation of the third component of the angular "
    "velocity is zero: the spin stays omega_0.",
)

system = premise(
    "1.0.6",
    26,
    ("АО.", "+ / (С А)"),
    words="The law of angular momentum of the body with its liquid; only its first two terms are left. The equation of the modes "
    "is lost: N_n^2 (S_n' - p_n S_n) + chi_n Omega' = 0 is what gives the fraction of (1.32).",
    damage=Damage(
        r"A\dot{\Omega} + i(C - A)\omega_0\Omega + \sum_n a_n(\dot{S}_n - i\omega_0 S_n) = M",
        reason="The first terms are the other text's (2.1), but for C - A in the place of A - C; the law of angular momentum has C - A and "
        "- i omega_0 for Omega_x - i Omega_y (C.1), and eta - omega_0 in (1.32) demands them.",
    ),
)

no_torque = premise(
    "1.0.7",
    28,
    "М = 0",
    words="The motion without torque is considered.",
    damage=Damage("M = 0", reason="a Cyrillic letter for M"),
)

frequencies = premise(
    "1.0.8",
    28,
    "(p = iq, р„= Ц,)",
    words="The exponents are written as frequencies.",
    damage=Damage(
        r"p = i\eta, p_n = i\lambda_n",
        reason="eta reads as q; i lambda_n as one letter; with these the system is in real frequencies, as (1.32) is.",
    ),
)

characteristic_equation = claim(
    "1.31",
    28,
    "(1.31)",
    words="The characteristic equation with the sum over all modes; only its number is left.",
    damage=Damage(
        r"A\eta + (C - A)\omega_0 - \eta(\eta - \omega_0)\sum_n \frac{E_n}{\eta - \lambda_n} = 0",
        reason="The next sentence keeps one term of its infinite sum, and that equation, (1.32), is left in both texts. Read here with "
        "three modes; each further mode adds one more term (N.2).",
    ),
    equation=partial(derivation.characteristic_equation, 3),
    where=derivation.mode_inertias,
    uses=["1.0.6", "1.0.8"],
    notation=three_modes,
)

main_term = premise(
    "1.31.1",
    28,
    "(п = 1)",
    words="In a first approximation one main term of the infinite sum is kept, n = 1.",
    damage=Damage("n = 1", reason="a Cyrillic letter for n"),
)

one_mode = claim(
    "1.32",
    33,
    "Arj + (C-A)co0-Tj(}i-(t}0) (П~\\) = 0.",
    words="The characteristic equation with one mode.",
    damage=Damage(
        rf"{ONE_MODE} = 0",
        reason="eta reads as rj, Tj, }i and omega_0 as co0, (t}0. The numerator is lost, of the denominator eta - lambda_1 "
        "'(П~\\)' is left; multiplied by it the equation is (1.33), whose coefficients give the numerator E_1.",
    ),
    equation=partial(derivation.characteristic_equation, 1),
    where=partial(derivation.mode_inertias, 1),
    uses=["1.31", "1.31.1"],
)

delta = definition(
    "1.32.1",
    34,
    "(Д = С-А)",
    states=r"\Delta = C - A",
    damage=Damage(r"\Delta = C - A", reason="a Cyrillic letter for Delta"),
)

quadratic = claim(
    "1.33",
    34,
    "772(Л-£,) + ^(Дй?0 + й?0£, ЛЛ,)-Д<уой1 =0",
    words="The same multiplied by eta - lambda_1.",
    damage=Damage(
        rf"{QUADRATIC} = 0",
        reason="eta reads as 77 and ^, omega_0 as й?0 and <уо, E_1 as '£,', A lambda_1 as 'ЛЛ,', lambda_1 at the end as й1; one minus is lost.",
    ),
    equation=derivation.quadratic,
    uses=["1.32", "1.32.1"],
)


roots_must_be_real = both_texts.roots_must_be_real("1.33.1", 34, "1.33")

positive_discriminant_suffices = claim(
    "1.33.2",
    34,
    words="A positive discriminant makes them so: no root x + iy has y other than zero.",
    states=r"(u = 0 \land v = 0) \Rightarrow y = 0",
    given=[Hypothesis("positive discriminant", "D > 0", rf"{DISCRIMINANT} > 0")],
    where=derivation.quadratic_at_complex_frequency,
    by=cases(rf"4(A - E_1)^2y^2 + 1 \cdot ({DISCRIMINANT})"),
    uses=["1.33", "1.33.3"],
    notation=root_letters,
)

positive_discriminant_is_needed = both_texts.positive_discriminant_is_needed("1.33.5", 34, "1.33", "1.33.3")

discriminant = claim(
    "1.33.3",
    34,
    "D = (Дй?0 + а0Е„ ААп)2 +4(ЛЕп)&б)0Лп > 0",
    words="Its discriminant, required to be positive. The mode is called n from here on, 1 in (1.33): it is the one that is kept.",
    damage=Damage(
        rf"D = {DISCRIMINANT} > 0", reason="Delta reads as Д and &, omega_0 as й?0, а0, б)0; the minus signs are lost."
    ),
    where=derivation.discriminant_in_eta,
    imposed="b",
    uses=["1.33"],
)

boundary = claim(
    "1.33.4",
    34,
    "(Д <у0 +а)0Ел-ААп)2+4(А-Е„) Д <у0Л„ = 0",
    words="At the boundary of stability the discriminant is zero.",
    damage=Damage(rf"{DISCRIMINANT} = 0", reason="the discriminant once more, here with its minus signs"),
    equation=derivation.stability_boundary,
    uses=["1.33.3"],
)

boundary_by_spin = claim(
    "1.34",
    34,
    ("(д + £+ 4(Я-£)Д—= 0", "I ыо)"),
    words="The same divided by omega_0^2.",
    damage=Damage(
        r"\left(\Delta + E_n - A\frac{\lambda_n}{\omega_0}\right)^2 + 4(A - E_n)\Delta\frac{\lambda_n}{\omega_0} = 0",
        reason="Both fractions are lost but for a bar and an omega_0 ('ыо'), so are the square and the indices. It is the line before divided "
        "by omega_0^2, and with b_n for the fractions it expands to the next.",
    ),
    equation=derivation.stability_boundary_by_spin,
    uses=["1.33.4"],
)

boundaries_agree = in_delta.by_cases.claim(
    "1.34.1",
    34,
    words="Both equations have the same solutions.",
    states=rf"{DISCRIMINANT} = 0 \Leftrightarrow "
    r"\left(\Delta + E_n - A\frac{\lambda_n}{\omega_0}\right)^2 + 4(A - E_n)\Delta\frac{\lambda_n}{\omega_0} = 0",
    uses=["1.33.4", "1.34"],
)

frequency_ratio = definition(
    "1.34.2",
    34,
    ("—=Ь„", "<у0"),
    words="The natural frequency of the mode in units of the spin.",
    states=r"b_n = \frac{\lambda_n}{\omega_0}",
    damage=Damage(
        r"b_n = \frac{\lambda_n}{\omega_0}",
        reason="A fraction bar with omega_0 (as '<у0', a few words on) below; (1.34) becomes 1.34.3 with it.",
    ),
    notation=three_modes,
)

boundary_in_delta = in_b_and_delta.claim(
    "1.34.3",
    34,
    "Д2 + Д (2АЬп + 2£„ 4Е„Ь„) + (Я £„ )2 = 0",
    words="A quadratic equation in Delta.",
    damage=Damage(
        rf"{BOUNDARY} = 0",
        reason="In the last square b_n and the minus are lost: the next line has 4(A b_n - E_n)^2 in its place, as 4 times the "
        "constant term. With A - E_n the equation would not follow from (1.34).",
    ),
    equation=derivation.boundary_in_delta,
    uses=["1.34", "1.34.2"],
)

discriminant_of_boundary = in_b_and_delta.claim(
    "1.34.4",
    34,
    "D = 4 (Е„ + ЬпА 2ЕпЬп)2 -4(АЬп-Еп}2 = 16£л (1 )6„ (Я £„)",
    words="Its discriminant; the letter D stands for another one here than at 1.33.3.",
    damage=Damage(
        r"D = 4(E_n + b_nA - 2E_nb_n)^2 - 4(Ab_n - E_n)^2 = 16E_n(1 - b_n)b_n(A - E_n)",
        reason="b_n reads as Ь and 6; in '(1 )' a minus and b_n are lost, which the radicand in (1.35) has.",
    ),
    where=derivation.discriminant_in_delta,
    uses=["1.34.3"],
)

roots_of_boundary = Hypothesis(
    "roots of the boundary",
    "Delta_1 and Delta_2 are the roots of 1.34.3, Delta_1 not the smaller one",
    r"\Delta_1 + \Delta_2 = -(2Ab_n + 2E_n - 4E_nb_n), \Delta_1\Delta_2 = (Ab_n - E_n)^2, \Delta_1 \ge \Delta_2",
)

roots_by_formula = in_b.claim(
    "1.34.5",
    34,
    "Д12 = -(^6Й + £„ 2ЕпЪ„) ± 2,jEn (\\-Ьп)Ь„(А-Е„)",
    words="Its roots.",
    damage=Damage(
        rf"\Delta_1 = -(Ab_n + E_n - 2E_nb_n) + {RADICAL}, \Delta_2 = -(Ab_n + E_n - 2E_nb_n) - {RADICAL}",
        reason="A b_n reads as '^6Й', a minus is lost, the root sign reads as ',j'. Read with one equation for each sign of the root.",
    ),
    given=[roots_of_boundary, liquid_moves, liquid_is_part, roots_are_real_numbers],
    by=theorems(Applied("equal_squares", (r"\Delta_1 - \Delta_2", rf"2 \cdot {RADICAL}"))),
    uses=["1.34.3", "1.34.4"],
)

roots_as_squares = in_b.claim(
    "1.35",
    34,
    "^2=-En(\\-bn)-b„(A-En)±2.jEn(\\-b„)=-(yjEn(\\-bn) + yjbn(A-En^2",
    words="The same with the radicand split, and as a square.",
    damage=Damage(
        rf"\Delta_1 = -E_n(1 - b_n) - b_n(A - E_n) + {RADICAL} = -(\sqrt{{E_n(1 - b_n)}} + \sqrt{{b_n(A - E_n)}})^2, "
        rf"\Delta_2 = -E_n(1 - b_n) - b_n(A - E_n) - {RADICAL} = -(\sqrt{{E_n(1 - b_n)}} + \sqrt{{b_n(A - E_n)}})^2",
        reason="Delta_{1,2} reads as '^2', the root sign as '.j' and 'yj'; b_n (A - E_n) is lost in the radicand, which the form before has. "
        "Read with one equation for each sign of the root.",
    ),
    given=[roots_of_boundary, liquid_moves, liquid_is_part, roots_are_real_numbers],
    by={
        "a": theorems(Applied("equal_squares", (r"\Delta_1 - \Delta_2", rf"2 \cdot {RADICAL}"))),
        "b": looking_at(cases(), A="2", E_1="1", b_1="1/2", Delta_1="0", Delta_2="-2"),
        "c": theorems(Applied("equal_squares", (r"\Delta_1 - \Delta_2", rf"2 \cdot {RADICAL}"))),
        "d": cases(),
    },
    uses=["1.34.5"],
    errata={
        "b": Erratum(
            rf"-E_n(1 - b_n) - b_n(A - E_n) + {RADICAL} = -(\sqrt{{E_n(1 - b_n)}} - \sqrt{{b_n(A - E_n)}})^2",
            "sign in the square",
            Origin.UNCERTAIN,
            "With the plus that is printed both signs of the root would give one Delta, the one of the minus sign. The root with the plus "
            "is minus the square of the difference: the sign in the square is the opposite of the one before the root. The OCR may "
            "have read such a double sign as a plus, though it kept both double signs before.",
            summary=r"The sign in the square is the opposite of the one before the root; with the plus both would give one $\Delta$.",
            instead=r"$\Delta_{1,2} = \dots = -\left(\sqrt{E_n(1 - b_n)} \mp \sqrt{b_n(A - E_n)}\right)^2$",
        )
    },
)
