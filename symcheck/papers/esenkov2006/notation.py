"""The letters of Esenkov 2006. The index n runs over the modes that are kept: one, in the paper's approximation."""

from dataclasses import replace

from symcheck.reading import Letter, Notation

MOMENT = "kg m^2"
RATE = "rad/s"

notation = Notation(
    (
        Letter("n", kind="index", range=(1,)),
        Letter("A", meaning="transverse moment of inertia", unit=MOMENT),
        Letter("C", meaning="axial moment of inertia", unit=MOMENT),
        Letter(r"\Delta", meaning="C - A", unit=MOMENT),
        Letter(r"\Delta", indices=1, meaning="the values of C - A at the boundary of stability", unit=MOMENT),
        Letter(r"\omega_0", meaning="spin", unit=RATE),
        Letter(r"\Omega", meaning="complex transverse angular velocity", unit=RATE),
        Letter(r"\dot{\Omega}", meaning="its rate of change in the body", unit="rad/s^2"),
        Letter(r"\Omega_x", meaning="angular velocity about the body axis x", unit=RATE),
        Letter(r"\Omega_y", meaning="angular velocity about the body axis y", unit=RATE),
        Letter("q", meaning="the same component, as the first text also calls it", unit=RATE),
        Letter("M", kind="function", depends="t", meaning="complex transverse torque", unit="N m"),
        Letter("M_x", meaning="torque about x", unit="N m"),
        Letter("M_y", meaning="torque about y", unit="N m"),
        Letter("t", meaning="time", unit="s"),
        Letter("i", number="i", meaning="imaginary unit; in premises only"),
        Letter("S", indices=1, meaning="complex amplitude of mode n of the liquid", unit="m/s"),
        Letter(r"\dot{S}", indices=1, meaning="its rate of change in the body", unit="m/s^2"),
        Letter(
            "a",
            indices=1,
            meaning="angular momentum of the liquid per unit amplitude of mode n",
            unit="kg m",
        ),
        Letter(r"\chi", indices=1, meaning="coupling of mode n to the turning body", unit="m^4"),
        Letter("N", indices=1, meaning="norm of mode n", unit="m^(3/2)"),
        Letter(r"\rho", meaning="density of the liquid", unit="kg/m^3"),
        Letter(
            "E", indices=1, depends="", meaning="moment of inertia carried by mode n, a_n chi_n / N_n^2", unit=MOMENT
        ),
        Letter("p", meaning="exponent of the motion e^{pt}; in 2.1.1 the angular velocity about x", unit="1/s"),
        Letter("p", indices=1, meaning="exponent of mode n in the body at rest", unit="1/s"),
        Letter(r"\eta", meaning="frequency: p = i eta", unit=RATE),
        Letter(r"\lambda", indices=1, meaning="natural frequency of mode n: p_n = i lambda_n", unit=RATE),
        Letter("b", indices=1, meaning="lambda_n / omega_0", unit="1"),
        Letter("D", meaning="a discriminant: of (1.33) in eta, or of the boundary in Delta"),
    )
)


def retaining(modes: int) -> Notation:
    """The notation with the index n over that many modes."""
    return notation.extended(Letter("n", kind="index", range=tuple(range(1, modes + 1))))


three_modes = retaining(3)
CONSTANT = ("A", "C", r"\Delta", r"\omega_0", r"\lambda", "E")  # what does not depend on the frequency

sign_letters = notation.extended(
    Letter("F", meaning="left side of the characteristic equation of (2.1) with p = i eta, p_n = i lambda_n"),
    Letter("G", meaning="the same with p = -i eta, p_n = -i lambda_n"),
    Letter("H", meaning="that of (2.1) with i(C - A) and - i omega_0, and with p = i eta, p_n = i lambda_n"),
    Letter("K", meaning="the same with p = -i eta, p_n = -i lambda_n"),
    Letter("g", meaning="coefficient of i Omega in the law of angular momentum"),
    Letter("h", meaning="coefficient of i k there, k the angular momentum of the moving liquid"),
)

comparison_letters = three_modes.extended(
    *(replace(letter, depends="") for letter in three_modes.letters if letter.latex in CONSTANT),
    Letter("s", depends="", meaning="a sign that the first text has lost"),
    Letter("r", depends="", meaning="a sign that the second text has lost"),
    Letter("x", depends="", meaning="a term that the first text has lost", unit="kg m^2/s"),
)

root_letters = notation.extended(
    Letter("u", meaning="square root of E_n (1 - b_n); in 1.33.1, 1.33.2, B.6 a real part", unit="kg^(1/2) m"),
    Letter("v", meaning="square root of b_n (A - E_n); there an imaginary part", unit="kg^(1/2) m"),
    Letter("r", meaning="square root of D", unit="kg m^2 rad/s"),
    Letter("s", meaning="square root of b_n E_n", unit="kg^(1/2) m"),
    Letter("w", meaning="square root of (1 - b_n)(A - E_n)", unit="kg^(1/2) m"),
    Letter("x", meaning="real part of a root", unit=RATE),
    Letter("y", meaning="imaginary part of a root", unit=RATE),
)

conjugate_root_letters = root_letters.extended(
    Letter("s", meaning="square root of y", unit="1/s^(1/2)"),
    Letter("r", meaning="square root of -y", unit="1/s^(1/2)"),
)

mode_letters = three_modes.extended(
    Letter("F", named=True, meaning="left side of (1.31)"),
    Letter("d", kind="differential"),
    Letter("P", indices=1, meaning="(1.31) times all eta - lambda_n, at eta = lambda_k"),
    Letter("L", meaning="its leading coefficient", unit=MOMENT),
    Letter(
        "R", indices=1, meaning="minus the residue of (1.31) at its pole lambda_n, E_n lambda_n (lambda_n - omega_0)"
    ),
    Letter(
        "V", indices=1, meaning="(1.31) times (eta - lambda_1)(eta - lambda_2) at eta = lambda_k", unit="kg m^2/s^3"
    ),
    Letter("h", meaning="all of (1.31) that is regular at both poles", unit="kg m^2/s"),
    Letter("x", meaning="real part of a root", unit=RATE),
    Letter("y", meaning="imaginary part of a root", unit=RATE),
    Letter("u", meaning="imaginary part of the left side of (1.31)"),
    Letter("v", meaning="imaginary part of (1.31) divided by eta (eta - omega_0)"),
    Letter("s", meaning="a sum of terms of one sign"),
)

weight_letters = notation.extended(
    Letter("k", kind="index", range=(1, 2, 3, 4)),
    Letter("w", indices=1, range=(1, 2, 3, 4), meaning="weights", unit=MOMENT),
    Letter("x", indices=1, range=(1, 2, 3, 4), meaning="real parts", unit="s"),
    Letter("y", indices=1, range=(1, 2, 3, 4), meaning="imaginary parts", unit="s"),
    Letter("W", meaning="sum of the weights", unit=MOMENT),
    Letter("S", meaning="weighted sum of the squares", unit="kg m^2 s^2"),
    Letter("r", meaning="square of 1 / |eta - omega_0|", unit="s^2"),
)
