"""Poloskov 2004, section 2: amplitude, phase and frequency instead of the angular velocity."""

from symcheck.core.claims import Damage, Erratum, Hypothesis
from symcheck.core.verdicts import Origin
from symcheck.papers.declare import Scope, by_cases, claim, definition, exclusion, ours, premise
from symcheck.papers.poloskov2004 import derivation
from symcheck.papers.poloskov2004.hypotheses import amplitude, positive_k, positive_parameter
from symcheck.papers.poloskov2004.notation import distance_letters, functions_of_time, initial_letters, six_columns
from symcheck.proof import existence

system = Scope(where=derivation.stratonovich_system)

free_motion = exclusion("2.0.1", 27, r"\varepsilon = 0", reason="names the case that (2.1) solves")

generating_solution = claim(
    "2.1",
    29,
    r"\tilde{x}_1 = a \cos \psi, \quad \tilde{x}_2 = -a \sin \psi, \quad \tilde{x}_3 = \Omega/k",
    given=[positive_k],
    where=derivation.generating_solution,
    uses=["1.1"],
)

phase_of_generating_solution = claim(
    "2.1.1",
    29,
    r"\psi = \Omega t + \theta",
    words="The phase that turns at the rate Omega from theta.",
    where=derivation.exact_phase,
    uses=["2.1"],
)

generating_solution_solves = claim(
    "2.1.2",
    27,
    words="For epsilon = 0 it solves x' + f = 0; along it time enters by the phase alone, and psi' = Omega.",
    states=r"\Omega \frac{\partial \tilde{x}_i}{\partial \psi} + f_i = 0",
    given=[positive_k],
    where=derivation.generating_equations,
    uses=["1.1", "2.1", "2.1.1"],
)

STATE = r"\exists a, u, v, w: (u^2 + v^2 = 1 \land x_1 = a u \land x_2 = -a v \land x_3 = w/k)"

solution_is_general = claim(
    "2.1.3",
    31,
    words="a, Omega, theta are arbitrary constants: the solution is the general one. Every x_1, x_2, x_3 is attained at t = 0, with "
    "u, v for the cosine and sine of theta and w for Omega (2.1.6 for x_1 = x_2 = 0), and a motion has no second one beside it (2.1.7).",
    states=STATE,
    given=[
        positive_k,
        Hypothesis(
            "not about the polar axis", "r, the length of (x_1, x_2), is not zero", "r^2 = x_1^2 + x_2^2, r > 0"
        ),
    ],
    by=existence(a="r", u=r"\frac{x_1}{r}", v=r"-\frac{x_2}{r}", w="kx_3"),
    uses=["2.1", "2.1.2", "2.1.6", "2.1.7"],
    notation=initial_letters,
)

solution_about_the_polar_axis = ours(
    "2.1.6",
    31,
    words="Where x_1 = x_2 = 0 it is that with a = 0, and any theta.",
    states=STATE,
    given=[positive_k, Hypothesis("about the polar axis", "x_1 and x_2 are zero", "x_1 = 0, x_2 = 0")],
    by=existence(a="0", u="1", v="0", w="kx_3"),
    notation=initial_letters,
)

motions_keep_their_distance = by_cases.ours(
    "2.1.7",
    31,
    words="For epsilon = 0 x_3 is constant, and two motions with the same x_3 keep their distance; so motions that begin "
    "together stay together.",
    states=r"w = 0 \land r = 0",
    where=derivation.distance_of_free_motions,
    uses=["1.1"],
    notation=distance_letters,
)

perturbed_motion = exclusion("2.1.4", 31, r"\varepsilon \neq 0", reason="names the case treated from here on")

slow_change = by_cases.claim(
    "2.1.5",
    31,
    words="a, Omega, theta change slowly: their drift and diffusion vanish with epsilon.",
    states=r"\varepsilon = 0 \Rightarrow (K_i = 0 \land K_{ij} = 0)",
    given=[amplitude, positive_k],
    where=derivation.coefficients,
    uses=["2.4", "3.1.2"],
)

change_of_variables = claim(
    "2.2",
    33,
    r"x_1 = a(t)\cos\psi(t), \quad x_2 = -a(t)\sin\psi(t), \quad x_3 = \Omega(t)/k",
    words="The change of variables that (2.1) suggests.",
    given=[positive_k],
    where=derivation.change_of_variables,
    notation=functions_of_time,
)

inverse_change = claim(
    "2.3",
    35,
    r"a^2 = x_1^2 + x_2^2, \quad \operatorname{tg}\psi = -x_2/x_1, \quad \Omega = kx_3",
    given=[amplitude, positive_k],
    where=derivation.change_of_variables,
    uses=["2.2"],
)

rates_of_new_variables = claim(
    "2.3.1",
    39,
    r"\dot{a} = \dot{x}_1 \cos\psi - \dot{x}_2 \sin\psi, \quad "
    r"\dot{\theta} = -\Omega - \frac{\dot{x}_1 \sin\psi + \dot{x}_2 \cos\psi}{a}, \quad \dot{\Omega} = k\dot{x}_3",
    words="The second relation holds for psi' = Omega + theta' (2.3.2).",
    given=[amplitude, positive_k],
    where=derivation.rates,
    uses=["2.2", "2.3.2"],
)

frequency_hardly_changes = Hypothesis(
    "Omega constant", "terms of the order epsilon, the rate of Omega among them, are left out", r"\dot{\Omega} = 0"
)

rate_of_phase = claim(
    "2.3.2",
    41,
    r"\psi = \Omega + \theta",
    given=[frequency_hardly_changes],
    where=derivation.exact_phase,
    uses=["2.1"],
    errata={
        "": Erratum(
            r"\dot{\psi} = \Omega + \dot{\theta}",
            "dots lost",
            Origin.UNCERTAIN,
            "A frequency is added to an angle. What is taken 'up to epsilon', and used in the relation for theta' two lines "
            "above, is psi' = Omega + theta', where the exact psi' has the further term Omega' t. Restoring the time, "
            "psi = Omega t + theta, would make it a definition that (2.1) has given already and that is exact. Whether the "
            "author or the OCR lost the dots cannot be told; the OCR keeps all other dots of the page.",
            summary=r"A frequency is added to an angle; what is used two lines above, and holds up to terms of the order "
            r"$\varepsilon$, is the relation between the rates.",
        )
    },
)

stratonovich_system = claim(
    "2.4",
    43,
    r"\dot{a} &= v_1 + \sum_{j=1}^6 h_{1j}\zeta_j, \quad \dot{\theta} = v_2 + \sum_{j=1}^6 h_{2j}\zeta_j, \quad "
    r"\dot{\Omega} = v_3 + \sum_{j=1}^6 h_{3j}\zeta_j",
    words="Inserting (1.1) gives equations of this form, with v and h of 2.4.2 to 2.4.5.",
    given=[amplitude, positive_k, positive_parameter],
    where=derivation.slow_rates,
    uses=["1.0.1", "2.3.1"],
)

V_1 = (
    r"\frac{\Omega}{k}(-d_{13}\cos\psi + d_{23}\sin\psi) - a(d_{11}\cos^2\psi + d_{22}\sin^2\psi) "
    r"+ a\cos\psi\sin\psi(d_{12} + d_{21})"
)
V_2 = (
    r"\frac{\Omega}{ak}((d_{23}\cos\psi + d_{13}\sin\psi) + \cos\psi\sin\psi(d_{11} - d_{22}) "
    r"+ d_{21}\cos^2\psi - d_{12}\sin^2\psi)"
)
V_3 = r"-d_{33}\Omega - ak(-d_{31}\cos\psi + d_{32}\sin\psi)"

drift_vector = definition(
    "2.4.1",
    43,
    r"\mathbf{v} &= [v_1, v_2, v_3]^T \equiv \\ &\equiv \varepsilon \begin{bmatrix} "
    + rf"{V_1} \\ {V_2} \\ {V_3} \end{{bmatrix}}",
    words="The drift, in Stratonovich's sense; its three components are judged next.",
    opaque=True,
)

drift_of_amplitude = system.claim(
    "2.4.2",
    43,
    V_1,
    words="First component of v.",
    states=rf"v_1 = \varepsilon \left[{V_1}\right]",
    given=[positive_k],
    uses=["1.0.1", "2.3.1"],
)

drift_of_phase = system.claim(
    "2.4.3",
    43,
    V_2,
    words="Second component of v.",
    states=rf"v_2 = \varepsilon \left[{V_2}\right]",
    given=[amplitude, positive_k],
    uses=["1.0.1", "2.3.1"],
    errata={
        "": Erratum(
            r"v_2 = \varepsilon \left[\frac{\Omega}{ak}(d_{23}\cos\psi + d_{13}\sin\psi) + \cos\psi\sin\psi(d_{11} - d_{22}) "
            r"+ d_{21}\cos^2\psi - d_{12}\sin^2\psi\right]",
            "bracket too long",
            Origin.UNCERTAIN,
            "The outer bracket swallows three terms that must not carry the factor Omega/(ak); as printed their dimension "
            "is wrong, and the average of v_2 would not be the printed Kbar_2. The printed bracket pair is balanced, so it "
            "is no bracket dropped; the author or the OCR may have doubled it.",
            summary=r"The outer bracket is too long: only the first two terms have the factor $\Omega/(ak)$.",
        )
    },
)

drift_of_frequency = system.claim(
    "2.4.4",
    43,
    V_3,
    words="Third component of v.",
    states=rf"v_3 = \varepsilon \left[{V_3}\right]",
    given=[positive_k],
    uses=["1.0.1", "2.3.1"],
    errata={
        "": Erratum(
            r"v_3 = \varepsilon \left[-d_{33}\Omega - ak(d_{31}\cos\psi - d_{32}\sin\psi)\right]",
            "wrong sign",
            Origin.UNCERTAIN,
            "Both terms of the bracket have the wrong sign: v_3 is -k times row 3 of D times x, where x_2 = -a sin psi. The "
            "bracket has the signs of that of v_1, which a plus stands before; the sign before ak or those inside are a "
            "slip of the author's, or a plus was read as a minus. The average of v_3 is not touched.",
            summary=r"Both terms in the inner bracket have the wrong sign, as $x_1 = a\cos\psi$ and $x_2 = -a\sin\psi$.",
        )
    },
)

noise_intensities = claim(
    "2.4.5",
    45,
    r"\mathbf{H} = [h_{ij}] \equiv \sqrt{\varepsilon} \begin{bmatrix} a\cos^2\psi & a\sin^2\psi & 0 & \cos\psi & -\sin\psi & 0 \\ "
    r"-\cos\psi\sin\psi & \cos\psi\sin\psi & 0 & -\frac{1}{a}\sin\psi & -\frac{1}{a}\cos\psi & 0 \\ "
    r"0 & 0 & \Omega & 0 & 0 & k \end{bmatrix} \mathbf{g}_*",
    words="The matrix of the noise intensities, all 18 entries.",
    damage=Damage(
        r"\mathbf{H} = [h_{ij}] \equiv \sqrt{\varepsilon} \begin{bmatrix} a\cos^2\psi & a\sin^2\psi & 0 & \cos\psi & -\sin\psi & 0 \\ "
        r"-\cos\psi\sin\psi & \cos\psi\sin\psi & 0 & -\frac{1}{a}\sin\psi & -\frac{1}{a}\cos\psi & 0 \\ "
        r"0 & 0 & \Omega & 0 & 0 & k \end{bmatrix} \operatorname{diag}(g_{11}, g_{12}, g_{13}, g_{21}, g_{22}, g_{23})",
        reason="As printed a 3 x 6 matrix times the column g_* is a column of three, which H is not. Column j of H belongs to the "
        "noise zeta_j and carries its intensity: g_* stands for diag(g_11, ..., g_23). That g_* is printed as a column twice, "
        "here and in the next display, speaks for the author.",
        kind="vector for a diagonal matrix",
        origin=Origin.PAPER,
    ),
    given=[amplitude, positive_k, positive_parameter],
    where=derivation.stratonovich_system,
    imposed="a",
    uses=["1.0.1", "2.3.1"],
    notation=six_columns,
)

phase_columns_leave_frequency_alone = system.by_cases.ours(
    "2.4.6",
    45,
    words="The noises of Omega are not those of a and theta: the derivative by Omega through psi = Omega t + theta adds nothing "
    "to the Stratonovich correction.",
    states=r"h_{13} = 0, h_{16} = 0, h_{23} = 0, h_{26} = 0, h_{31} = 0, h_{32} = 0, h_{34} = 0, h_{35} = 0",
    uses=["2.4.5"],
)

all_noises = premise(
    "2.4.7",
    47,
    r"\boldsymbol{\zeta} = [\zeta_1, \dots, \zeta_6]^T \equiv [\xi_1, \xi_2, \xi_3, \eta_1, \eta_2, \eta_3]^T",
    words="The six noises in one vector.",
)

all_intensities = premise(
    "2.4.8",
    47,
    r"\mathbf{g}_* = [g_{11}, g_{12}, g_{13}, g_{21}, g_{22}, g_{23}]^T",
    words="The six intensities in one.",
)
