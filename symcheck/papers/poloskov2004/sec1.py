"""Poloskov 2004, section 1: the equations of motion with dissipation and noise."""

from symcheck.papers.declare import body, claim, exclusion, ours, premise
from symcheck.papers.poloskov2004 import derivation
from symcheck.papers.poloskov2004.hypotheses import body_has_mass

equations_of_motion = premise(
    "1.0.1",
    13,
    r"\dot{\mathbf{x}} + \mathbf{f}(\mathbf{x}) = -\varepsilon \mathbf{D}\mathbf{x} + \sqrt{\varepsilon} \mathbf{G}_1 \xi "
    r"+ \sqrt{\varepsilon} \mathbf{G}_2 \eta",
    words="Euler's equations with a small dissipative torque, a multiplicative and an additive noise.",
)

derivation_starts_here = ours(
    "1.0.2",
    13,
    words="What is derived below starts from these equations as printed.",
    states=body(equations_of_motion),
    equation=derivation.equations_of_motion,
    where=derivation.free_motion,
    uses=["1.0.1", "1.1"],
)

gyroscopic_terms = claim(
    "1.1",
    15,
    r"\mathbf{f} = [-kx_2x_3, kx_3x_1, 0]^T",
    words="The terms of Euler's equations for A = B that hold no torque.",
    given=[body_has_mass],
    where=derivation.gyroscopic_terms,
)

inertia_ratio = claim(
    "1.1.1",
    15,
    r"k = (A - C)/B > 0",
    given=[body_has_mass],
    where=derivation.gyroscopic_terms,
    imposed="b",
    uses=["1.1"],
)

noise_matrices = premise(
    "1.1.2",
    17,
    r"\mathbf{G}_1 = \text{diag}[g_{11}x_1, g_{12}x_2, g_{13}x_3], \quad \mathbf{G}_2 = \text{diag}[g_{21}, g_{22}, g_{23}]",
    words="Each axis has its own multiplicative and its own additive noise.",
)

constant_intensities = premise(
    "1.1.3", 19, r"g_{ij} = \text{const}, \quad i = 1, 2, \quad j = 1, 2, 3", words="The intensities are constant."
)

angular_velocity = premise("1.1.4", 21, r"\mathbf{x} = [x_1, x_2, x_3]^T", words="Angular velocity in body axes.")

dynamic_symmetry = premise(
    "1.1.5",
    21,
    "A = B, C",
    words="A, B, C are the principal central moments of inertia, of which two are equal.",
    states="A = B",
)

small_parameter = premise("1.1.6", 21, words="epsilon is small and positive.", states=r"\varepsilon > 0")

dissipation_matrix = premise(
    "1.1.7", 21, r"\mathbf{D} = [d_{ij}]", words="D is a 3 x 3 matrix whose elements are all positive."
)

multiplicative_noise = premise(
    "1.1.8", 21, r"\xi = [\xi_1, \xi_2, \xi_3]^T", words="Gaussian white noises of unit intensity, independent of eta."
)

additive_noise = premise(
    "1.1.9",
    21,
    r"\eta = [\eta_1, \eta_2, \eta_3]^T",
    words="Gaussian white noises of unit intensity, independent of xi.",
)

sense_of_the_equations = premise(
    "1.1.10", 23, words="The stochastic differential equations (1.1) are meant in Stratonovich's sense."
)

meaning_of_the_torques = exclusion(
    "1.1.11",
    23,
    words="The first two terms on the right are resistance and its perturbation, the third outer fluctuations; where such "
    "torques come from.",
    reason="physics of the model, no relation",
)

no_exact_density = exclusion(
    "1.1.12",
    25,
    words="An analytic density of x is out of reach; the small parameter admits averaging, in the first approximation.",
    reason="motivates the method",
)
