"""The letters of Mirer 2009: what each means, its unit, its components in the principal axes x_1, x_2, x_3."""

from symcheck.reading import Letter, Notation

MOMENT = "kg m^2"
GAIN = "N m s/rad"
SEMI_AXIS = "1/(kg^(1/2) m)"

notation = Notation(
    (
        *(Letter(index, kind="index") for index in "ijks"),
        Letter("I", indices=1, meaning="principal central moments of inertia", unit=MOMENT),
        Letter("J", indices=1, meaning="moments of inertia about the axes y_i", unit=MOMENT),
        Letter("L", indices=1, meaning="I_2 I_3 a_i1^2 + I_3 I_1 a_i2^2 + I_1 I_2 a_i3^2", unit="kg^2 m^4"),
        Letter("P", indices=1, meaning="integral of x_i^2 over the mass", unit=MOMENT),
        Letter("a", indices=2, meaning="direction cosine of axis y_i (or e_i) to axis x_j", unit="1"),
        Letter(r"\delta", indices=2, meaning="components of the unit vectors E_i: 1 if i = j, else 0", unit="1"),
        Letter("k", indices=1, meaning="gain of control device i", unit=GAIN),
        Letter("k", meaning="common ratio of the gains to the moments J_i", unit="1/s"),
        Letter(r"\bar{k}", indices=1, meaning="k_i / J_i", unit="1/s"),
        Letter("M", indices=1, meaning="control torque of device i", unit="N m"),
        Letter(r"\mu", indices=1, meaning="components of the control torque in principal axes", unit="N m"),
        Letter(
            r"\kappa",
            indices=1,
            named=True,
            meaning="components of the angular momentum in principal axes",
            unit="kg m^2/s",
        ),
        Letter(r"\omega", indices=1, meaning="angular velocity in principal axes", unit="rad/s"),
        Letter(r"\dot{\omega}", indices=1, meaning="its rate of change in the body", unit="rad/s^2"),
        Letter(r"\rho", indices=1, meaning="left sides of (1.2)", unit="N m"),
        Letter("m", indices=2, meaning="damping matrix", unit=GAIN),
        Letter("p", meaning="root of the characteristic equation", unit="1/s"),
        Letter(r"\xi", meaning="stability degree", unit="1/s"),
        Letter("f", meaning="J_1 J_2 J_3", unit="kg^3 m^6"),
        Letter("c", meaning="mean principal moment", unit=MOMENT),
        Letter(
            "f_1", kind="function", depends="J_2", named=True, meaning="upper bound of f at given J_2", unit="kg^3 m^6"
        ),
        Letter(r"\alpha", meaning="pitch", unit="rad"),
        Letter(r"\beta", meaning="yaw", unit="rad"),
        Letter(r"\gamma", meaning="roll", unit="rad"),
        Letter("Ox", indices=1, meaning="principal axis", unit="1"),
        Letter("Oy", indices=1, meaning="turned axis", unit="1"),
        Letter("t", meaning="time", unit="s"),
        Letter("d", kind="differential"),
        Letter(r"\boldsymbol{\omega}", kind="vector", components=r"(\omega_1, \omega_2, \omega_3)"),
        Letter(
            r"\dot{\boldsymbol{\omega}}", kind="vector", components=r"(\dot{\omega}_1, \dot{\omega}_2, \dot{\omega}_3)"
        ),
        Letter(r"\mathbf{K}", kind="vector", components=r"(\kappa_1, \kappa_2, \kappa_3)"),
        Letter(r"\mathbf{M}", kind="vector", components=r"(\mu_1, \mu_2, \mu_3)"),
        Letter(r"\mathbf{e}", kind="vector", indices=1, components=r"(a_{i1}, a_{i2}, a_{i3})"),
        Letter(r"\mathbf{E}", kind="vector", indices=1, components=r"(\delta_{i1}, \delta_{i2}, \delta_{i3})"),
        Letter(r"\mathbf{I}", kind="matrix", components=r"\operatorname{diag}(I_1, I_2, I_3)"),
        Letter(r"\mathbf{A}", kind="matrix", components=r"\|a_{ij}\|"),
        Letter(r"\mathbf{m}", kind="matrix", components=r"\|m_{ij}\|"),
        Letter(r"\mathbf{U}", kind="matrix", components=r"\operatorname{diag}(1, 1, 1)"),
    )
)

damping_letters = notation.extended(
    Letter("b", indices=2, meaning="entries of the diagonal form of the damping matrix", unit=GAIN),
    Letter("s", indices=2, meaning="entries of the orthogonal matrix S", unit="1"),
    Letter("n", indices=2, meaning="entries of S^T B S", unit=GAIN),
    Letter("q", indices=2, meaning="entries of (-S)^T B (-S)", unit=GAIN),
    Letter(r"\mathbf{S}", kind="matrix", components=r"\|s_{ij}\|"),
    Letter(r"\mathbf{B}", kind="matrix", components=r"\|b_{ij}\|"),
)

torque_letters = notation.extended(Letter("w", meaning="angular acceleration about an axis e_i", unit="rad/s^2"))

turned_letters = notation.extended(
    Letter("u", meaning="cosine of the turn about the diagonal", unit="1"),
    Letter("v", meaning="sine of that turn", unit="1"),
)

ellipsoid_letters = turned_letters.extended(
    Letter("a", meaning="semi-axis along x_1 of the ellipsoid J d^2 = 1", unit=SEMI_AXIS),
    Letter("b", meaning="semi-axis along x_2", unit=SEMI_AXIS),
    Letter("c", meaning="semi-axis along x_3", unit=SEMI_AXIS),
    Letter("d", meaning="distance from the centre to the points on the axes y_i", unit=SEMI_AXIS),
)

optimum_letters = notation.extended(
    Letter("x", indices=1, meaning="real part of an eigenvector", unit="1"),
    Letter("y", indices=1, meaning="imaginary part of an eigenvector", unit="1"),
    Letter("u", indices=1, meaning="real part of (I p + m) z", unit=GAIN),
    Letter("v", indices=1, meaning="imaginary part of (I p + m) z", unit=GAIN),
    Letter("s", indices=1, meaning="excess of a rate over the least one", unit="1/s"),
    Letter(r"\lambda", indices=1, meaning="damping rates: minus the roots of (1.5)", unit="1/s"),
    Letter(r"\tau", meaning="imaginary part of a root", unit="1/s"),
)

family_letters = notation.extended(
    Letter("d", indices=1, meaning="I_i - c", unit=MOMENT),
    Letter("g", indices=1, meaning="d_i a_1i: vector across the first axis, towards the gradient", unit=MOMENT),
    Letter("h", indices=1, meaning="e_1 x g", unit=MOMENT),
    Letter("G", meaning="(g, g)", unit="kg^2 m^4"),
    Letter("r", meaning="square root of G", unit=MOMENT),
    Letter("W", meaning="a_11 a_12 a_13 (d_1 - d_2)(d_2 - d_3)(d_3 - d_1)", unit="kg^3 m^6"),
    Letter("u", meaning="component of the second axis along g, times r", unit=MOMENT),
    Letter("v", meaning="component of the second axis along h, times r", unit=MOMENT),
    Letter("t", meaning="parameter of the family", unit="1/(kg m^2)"),
)

closed_form_letters = family_letters.extended(
    Letter("u", meaning="component of the second axis along g, a cosine", unit="1"),
    Letter("v", meaning="component of the second axis along h, a sine", unit="1"),
)
