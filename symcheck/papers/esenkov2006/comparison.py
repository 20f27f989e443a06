"""The two texts of esenkov2006 compared, formula by formula, as they are read; and the signs in which they differ."""

from functools import partial

from symcheck.core.claims import Declaration, Hypothesis
from symcheck.papers.declare import ours
from symcheck.papers.esenkov2006 import derivation, first_text, second_text
from symcheck.papers.esenkov2006.hypotheses import spinning
from symcheck.papers.esenkov2006.notation import sign_letters, three_modes
from symcheck.proof import cases, identity


def _read(item: Declaration) -> str:
    """A damaged formula as it is read."""
    return item.source.damage.read_as if item.source.damage else " ".join(item.source.printed)


def _left(item: Declaration) -> str:
    """The left side of an equation "... = 0" as it is read."""
    return _read(item).removesuffix(" = 0")


def _members(item: Declaration) -> list[str]:
    return _read(item).replace(">", "=").split(" = ")


def _same(first: Declaration, second: Declaration) -> str:
    return f"{_left(first)} = {_left(second)}"


clockwise_signs = ours(
    "C.1",
    26,
    words="For Omega = Omega_x - i Omega_y the law of angular momentum is A Omega' + i(C - A) omega_0 Omega + k' - i omega_0 k = M, with "
    "k = sum a_n S_n: the signs of the second text.",
    states=r"g = (C - A)\omega_0 \land h = -\omega_0",
    where=partial(derivation.signs_of_the_momentum_law, derivation.CLOCKWISE),
    by=cases(),
    uses=["1.0.6"],
    notation=sign_letters,
)

anticlockwise_signs = ours(
    "C.2",
    26,
    words="For Omega = Omega_x + i Omega_y it is A Omega' + i(A - C) omega_0 Omega + k' + i omega_0 k = M: the signs of the first text.",
    states=r"g = (A - C)\omega_0 \land h = \omega_0",
    where=partial(derivation.signs_of_the_momentum_law, derivation.ANTICLOCKWISE),
    by=cases(),
    uses=["2.1", "2.1.1"],
    notation=sign_letters,
)

first_equations_differ = ours(
    "C.3",
    26,
    words="So with one meaning of Omega the first text's i(A - C) and the second text's i(C - A) differ, unless all moments are equal.",
    states=r"(A - C)\omega_0 = (C - A)\omega_0 \Leftrightarrow A = C",
    given=[spinning],
    by=cases(),
    uses=["C.1", "C.2"],
)

characteristic_equations_agree = ours(
    "C.4",
    28,
    words="(2.2) and (1.31) agree as they are read; neither is legible. p = i eta and p_n = i lambda_n stand in both (line 12: IT}, /Л„; "
    "line 28: iq, Ц,).",
    states=_same(first_text.characteristic_equation, second_text.characteristic_equation),
    by=identity,
    uses=["2.2", "1.31"],
    notation=three_modes,
)

one_mode_equations_agree = ours(
    "C.5",
    33,
    words="(2.3) and (1.32) agree, with C - A in both. The first has lost both parts of the fraction, the second the numerator.",
    states=_same(first_text.one_mode, second_text.one_mode),
    by=identity,
    uses=["2.3", "1.32"],
)

deltas_agree = ours(
    "C.6",
    34,
    words="Delta is C - A in both; the first text has lost the minus.",
    states=f"{_members(first_text.delta)[1]} = {_members(second_text.delta)[1]}",
    by=identity,
    uses=["2.3.1", "1.32.1"],
)

quadratics_agree = ours(
    "C.7",
    34,
    words="2.3.2 and (1.33) agree. Each has lost one minus sign, which the other has; the first also lost omega_0 E_1.",
    states=_same(first_text.quadratic, second_text.quadratic),
    by=identity,
    uses=["2.3.2", "1.33"],
)

discriminants_agree = ours(
    "C.8",
    34,
    words="2.3.4 and 1.33.3 agree, index n included. Both have lost both minus signs, the first the exponent besides.",
    states=f"{_members(first_text.discriminant)[1]} = {_members(second_text.discriminant)[1]}",
    by=identity,
    uses=["2.3.4", "1.33.3"],
)

lost_term = ours(
    "C.9",
    34,
    words="What the first text's quadratic lacks, taken literally, is eta omega_0 E_1; its own D has it.",
    states=rf"{_left(first_text.quadratic)} - "
    r"(\eta^2(A - E_1) + \eta(\Delta\omega_0 - A\lambda_1) - \Delta\omega_0\lambda_1) = \eta\omega_0 E_1",
    by=identity,
    uses=["2.3.2"],
)

lost_ratio = ours(
    "C.10",
    34,
    words="The square in 1.34.3 taken literally, without b_n, would be right only for b_n = 1, or for the one ratio b_n = 2 E_n / A - 1.",
    states=r"(A - E_n)^2 = (Ab_n - E_n)^2 \Leftrightarrow (b_n = 1 \lor A(1 + b_n) = 2E_n)",
    given=[Hypothesis("body has mass", "A is positive", "A > 0", printed=False)],
    keeping=("b",),
    by=cases(),
    uses=["1.34.3"],
)
