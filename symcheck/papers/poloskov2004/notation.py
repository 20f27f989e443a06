"""The letters of Poloskov 2004: what each means, its unit, its components along the principal axes."""

from dataclasses import replace

from symcheck.reading import Letter, Notation

RATE = "rad/s"
NOISE = "1/s^(1/2)"  # white, of unit intensity: its correlation is the delta function of time
DRIFT = "rad/s^2, rad/s, rad/s^2"  # of a, theta, Omega
DIFFUSION = """
    rad^2/s^3, rad^2/s^2, rad^2/s^3; rad^2/s^2, rad^2/s, rad^2/s^2; rad^2/s^3, rad^2/s^2, rad^2/s^3"""
SIX = (1, 2, 3, 4, 5, 6)  # the noises, three of either kind

notation = Notation(
    (
        *(Letter(index, kind="index") for index in "ij"),
        Letter("k", kind="index", range=SIX),
        Letter("A", meaning="equatorial principal moment of inertia", unit="kg m^2"),
        Letter("B", meaning="the other equatorial moment, equal to A", unit="kg m^2"),
        Letter("C", meaning="polar moment of inertia", unit="kg m^2"),
        Letter("k", meaning="(A - C)/B", unit="1"),
        Letter("x", indices=1, meaning="angular velocity in body axes", unit=RATE),
        Letter(r"\dot{x}", indices=1, meaning="its rate of change", unit="rad/s^2"),
        Letter(r"\tilde{x}", indices=1, named=True, meaning="angular velocity for epsilon = 0", unit=RATE),
        Letter("f", indices=1, meaning="gyroscopic terms of Euler's equations", unit="rad/s^2"),
        Letter(r"\varepsilon", depends="", meaning="small positive parameter", unit="1"),
        Letter("d", indices=2, meaning="coefficients of dissipation", unit="1/s"),
        Letter(
            "g",
            indices=2,
            meaning="intensities of the multiplicative (g_1j) and the additive (g_2j) noises",
            unit="1/s^(1/2), rad/s^(3/2), 1",
        ),
        Letter(r"\xi", indices=1, meaning="multiplicative white noises", unit=NOISE),
        Letter(r"\eta", indices=1, meaning="additive white noises", unit=NOISE),
        Letter(r"\zeta", indices=1, range=SIX, meaning="all noises: xi_1 to xi_3, eta_1 to eta_3", unit=NOISE),
        Letter(r"\text{const}", name="const", meaning="a constant", unit="any"),
        Letter("a", meaning="amplitude of the equatorial angular velocity", unit=RATE),
        Letter(r"\dot{a}", meaning="its rate of change", unit="rad/s^2"),
        Letter(r"\psi", meaning="phase", unit="rad"),
        Letter(r"\dot{\psi}", meaning="its rate of change", unit=RATE),
        Letter(r"\theta", meaning="slow part of the phase", unit="rad"),
        Letter(r"\dot{\theta}", meaning="its rate of change", unit=RATE),
        Letter(r"\Omega", meaning="frequency k x_3", unit=RATE),
        Letter(r"\dot{\Omega}", meaning="its rate of change", unit="rad/s^2"),
        Letter("t", meaning="time", unit="s"),
        Letter("v", indices=1, meaning="drift of a, theta, Omega in Stratonovich's sense", unit=DRIFT),
        Letter(
            "h",
            indices=2,
            range=SIX,
            named=True,
            meaning="intensity of the noises zeta_j in a, theta, Omega",
            unit="rad/s^(3/2), rad/s^(1/2), rad/s^(3/2), 1, 1, 1",
        ),
        Letter("y", indices=1, meaning="a, theta, Omega", unit="rad/s, rad, rad/s"),
        Letter("K", indices=1, named=True, meaning="drift coefficients of the FPK equation", unit=DRIFT),
        Letter("K", indices=2, named=True, meaning="diffusion coefficients of the FPK equation", unit=DIFFUSION),
        Letter(
            r"\bar{K}",
            indices=1,
            kind="function",
            named=True,
            meaning="K_i / epsilon averaged over the phase",
            unit=DRIFT,
        ),
        Letter(
            r"\bar{K}",
            indices=2,
            kind="function",
            named=True,
            meaning="K_ij / epsilon averaged over the phase",
            unit=DIFFUSION,
        ),
        Letter(
            "p",
            kind="function",
            depends=r"a, \theta, \Omega, t",
            meaning="joint density of a, theta, Omega",
            unit="s^2/rad^3",
        ),
        Letter("p_0", kind="function", meaning="initial density", unit="s^2/rad^3"),
        Letter(
            "p_s",
            kind="function",
            depends=r"a, \theta, \Omega",
            named=True,
            meaning="stationary density",
            unit="s^2/rad^3",
        ),
        Letter("p_{s1}", kind="function", depends="a", named=True, meaning="stationary density of a", unit="s/rad"),
        Letter(
            "p_{s2}",
            kind="function",
            depends=r"\theta",
            named=True,
            meaning="stationary density of theta",
            unit="1/rad",
        ),
        Letter(
            "p_{s3}",
            kind="function",
            depends=r"\Omega",
            named=True,
            meaning="stationary density of Omega",
            unit="s/rad",
        ),
        Letter(r"\mathbf{L}", name="L", meaning="FPK operator / epsilon", unit="1/s"),
        Letter(r"\bar{L}", meaning="averaged FPK operator / epsilon", unit="1/s"),
        Letter(r"\alpha", depends="", meaning="alpha^2 = g_11^2 + g_12^2", unit="1/s^(1/2)"),
        Letter(r"\beta", depends="", meaning="beta^2 = g_21^2 + g_22^2", unit="rad/s^(3/2)"),
        Letter(r"\gamma", depends="", meaning="gamma^2 = d_11 + d_22", unit="1/s^(1/2)"),
        Letter("C", indices=1, meaning="constants of normalisation; their units depend on kappa", unit="any"),
        Letter(r"\Delta", indices=1, named=True, meaning="8 K_11 and K_33, averaged", unit="rad^2/s^3"),
        Letter(r"\kappa", indices=1, named=True, meaning="exponents of the densities", unit="1"),
        Letter("m", depends="", meaning="order of a moment", unit="1"),
        Letter("a_*", meaning="mode of a", unit=RATE),
        Letter(r"\Omega_*", meaning="mode of Omega", unit=RATE),
        Letter(r"\pi"),
        Letter("d", kind="differential"),
        Letter(r"\mathbf{x}", kind="vector", components="(x_1, x_2, x_3)"),
        Letter(r"\dot{\mathbf{x}}", kind="vector", components=r"(\dot{x}_1, \dot{x}_2, \dot{x}_3)"),
        Letter(r"\mathbf{f}", kind="function", depends=r"\mathbf{x}", components="(f_1, f_2, f_3)"),
        Letter(r"\xi", kind="vector", components=r"(\xi_1, \xi_2, \xi_3)"),
        Letter(r"\eta", kind="vector", components=r"(\eta_1, \eta_2, \eta_3)"),
        Letter(r"\boldsymbol{\zeta}", kind="vector", components=r"(\zeta_1, \dots, \zeta_6)"),
        Letter(r"\mathbf{g}_*", kind="vector", components="(g_{11}, g_{12}, g_{13}, g_{21}, g_{22}, g_{23})"),
        Letter(r"\mathbf{D}", kind="matrix", components=r"\|d_{ij}\|"),
        Letter(r"\mathbf{G}_1", kind="matrix", components=r"\operatorname{diag}(g_{11} x_1, g_{12} x_2, g_{13} x_3)"),
        Letter(r"\mathbf{G}_2", kind="matrix", components=r"\operatorname{diag}(g_{21}, g_{22}, g_{23})"),
        Letter(r"\mathbf{v}", kind="vector", components="(v_1, v_2, v_3)"),
        Letter(r"\mathbf{y}", kind="vector", components="(y_1, y_2, y_3)"),
    ),
    # `1/2\pi` is the density of a uniform phase and `4\gamma^2/3\alpha^2` the exponent that solves the equation
    slash="denominator",
    # `\cos\psi\sin\psi(d_{12} + d_{21})` is a product in the drift of Euler's equations
    argument="short",
)

functions_of_time = notation.extended(
    *(
        Letter(latex, kind="function", depends="t", named=True, meaning="as a function of time", unit=unit)
        for latex, unit in (("a", RATE), (r"\psi", "rad"), (r"\Omega", RATE))
    )
)

density_by_y = notation.extended(
    Letter("p", kind="function", depends=r"\mathbf{y}, t", meaning="joint density of y_1, y_2, y_3", unit="s^2/rad^3")
)

six_columns = notation.extended(
    Letter("j", kind="index", range=SIX), Letter(r"\mathbf{H}", kind="matrix", components=r"\|h_{ij}\|")
)

full_noise = notation.extended(
    Letter("q", indices=2, meaning="full matrix of multiplicative intensities", unit="1/s^(1/2)")
)

moment_letters = notation.extended(
    Letter(r"\nu", named=True, meaning="-kappa_1 - 1 = (4 gamma^2 - alpha^2)/(3 alpha^2)", unit="1"),
    Letter(r"\delta", meaning="d_33 / g_13^2", unit="1"),
    Letter("F", kind="function", meaning="distribution function of a", unit="1"),
    Letter("q", meaning="probability", unit="1"),
    Letter("n", depends="", meaning="half the order of a moment, less one half", unit="1"),
    Letter(r"\lambda", meaning="logarithmic derivative of a density", unit="s/rad"),
)

initial_letters = notation.extended(
    Letter("u", meaning="cosine of theta", unit="1"),
    Letter("v", meaning="sine of theta", unit="1"),
    Letter("w", meaning="a value of Omega", unit=RATE),
    Letter("r", meaning="length of (x_1, x_2)", unit=RATE),
)

distance_letters = notation.extended(
    Letter("u", meaning="the difference of two x_1", unit=RATE),
    Letter("v", meaning="the difference of two x_2", unit=RATE),
    Letter("w", meaning="the rate of x_3", unit="rad/s^2"),
    Letter("r", meaning="half the rate of the square of (u, v)", unit="rad^2/s^3"),
)

amplitude_letters = moment_letters.extended(Letter("q", meaning="a value of a", unit=RATE))

ratio_letters = notation.extended(
    Letter(
        "q", kind="function", depends=r"a, \theta, \Omega", meaning="the ratio of a further density to p_s", unit="1"
    )
)

primitive_letters = notation.extended(
    Letter(
        "U",
        named=True,
        depends=r"\psi",
        meaning="integral of K_11 / epsilon - Kbar_11 over the phase",
        unit="rad^2/s^3",
    ),
    Letter(r"\Omega", depends="", meaning="frequency, fixed", unit=RATE),
)

constant_letters = notation.extended(
    *(replace(letter, depends="") for letter in notation.letters if letter.latex in "dgk" and letter.kind == "scalar")
)

in_numbers = notation.supposing(("t", "s"))  # values of an example, for some unit of time
