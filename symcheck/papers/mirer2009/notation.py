"""The letters of Mirer 2009: what each means, its unit, its components in the principal axes x_1, x_2, x_3."""

from symcheck.reading import Letter, Notation

MOMENT = "kg m^2"
RATE = "rad/s"
TORQUE = "N m"
GAIN = "N m s/rad"

notation = Notation(
    (
        Letter("i", kind="index"),
        Letter("j", kind="index"),
        Letter("s", kind="index"),
        Letter("I", indices=1, meaning="principal central moments of inertia", unit=MOMENT),
        Letter("J", indices=1, meaning="moments of inertia about the axes y_i", unit=MOMENT),
        Letter("L", indices=1, meaning="I_2 I_3 a_i1^2 + I_3 I_1 a_i2^2 + I_1 I_2 a_i3^2", unit="kg^2 m^4"),
        Letter("P", indices=1, meaning="integral of x_i^2 over the mass", unit=MOMENT),
        Letter("a", indices=2, meaning="direction cosine of axis y_i (or e_i) to axis x_j"),
        Letter("k", indices=1, meaning="gain of control device i", unit=GAIN),
        Letter("k", meaning="common ratio of the gains to the moments J_i", unit="1/s"),
        Letter(r"\bar{k}", indices=1, meaning="k_i / J_i", unit="1/s"),
        Letter("M", indices=1, meaning="control torque of device i", unit=TORQUE),
        Letter(r"\mu", indices=1, meaning="components of the control torque in principal axes", unit=TORQUE),
        Letter(r"\kappa", indices=1, meaning="components of the angular momentum in principal axes", unit="kg m^2/s"),
        Letter(r"\omega", indices=1, meaning="angular velocity in principal axes", unit=RATE),
        Letter(r"\dot{\omega}", indices=1, meaning="its rate of change in the body", unit="rad/s^2"),
        Letter("m", indices=2, meaning="damping matrix", unit=GAIN),
        Letter("b", indices=2, meaning="entries of the diagonal form of the damping matrix", unit=GAIN),
        Letter("p", meaning="root of the characteristic equation", unit="1/s"),
        Letter(r"\xi", meaning="stability degree", unit="1/s"),
        Letter("f", meaning="J_1 J_2 J_3", unit="kg^3 m^6"),
        Letter("c", meaning="mean principal moment", unit=MOMENT),
        Letter("f_1", kind="function", meaning="upper bound of f at given J_2", unit="kg^3 m^6"),
        Letter(r"\alpha", meaning="pitch", unit="rad"),
        Letter(r"\beta", meaning="yaw", unit="rad"),
        Letter(r"\gamma", meaning="roll", unit="rad"),
        Letter("Ox", indices=1, kind="label", meaning="principal axis"),
        Letter("Oy", indices=1, kind="label", meaning="turned axis"),
        Letter("t", meaning="time", unit="s"),
        Letter("d", kind="differential"),
        Letter(r"\boldsymbol{\omega}", kind="vector", components=r"(\omega_1, \omega_2, \omega_3)"),
        Letter(r"\dot{\boldsymbol{\omega}}", kind="vector", components=r"(\dot{\omega}_1, \dot{\omega}_2, \dot{\omega}_3)"),
        Letter(r"\mathbf{e}", kind="vector", indices=1, components=r"(a_{i1}, a_{i2}, a_{i3})"),
        Letter(r"\mathbf{M}", kind="vector", components=r"(\mu_1, \mu_2, \mu_3)"),
        Letter(r"\mathbf{K}", kind="vector", components=r"(\kappa_1, \kappa_2, \kappa_3)"),
        Letter(r"\mathbf{E}", kind="matrix"),
    )
)
