"""Kernels of poloskov2004. Written by `symcheck generate`: what is changed here is lost."""

from math import cos, exp, expm1, log, log1p, pi, pow, sin, sqrt

from symcheck.kernels.ratios import expm1_ratio, gamma_ratio, log1p_ratio
from symcheck.kernels.runtime import Argument, Output, kernel

__all__ = [
    "averaged_diffusion",
    "averaged_drift",
    "density_of_amplitude",
    "density_of_frequency",
    "diffusion_coefficients",
    "distribution_of_amplitude",
    "drift_coefficients",
    "logarithm_of_constant_of_amplitude",
    "logarithm_of_constant_of_frequency",
    "mean_square_of_amplitude",
    "mean_square_of_frequency",
    "mode_of_amplitude",
    "moment_of_amplitude",
    "moment_of_frequency",
    "noise_intensities",
    "quantile_of_amplitude",
    "stratonovich_drift",
]


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("psi", "phase", "rad"),
    Argument("Omega", "frequency k x_3", "rad/s"),
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("varepsilon", "small parameter of the torques", low="0"),
    Argument("d_11", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_12", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_13", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_21", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_22", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_23", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_31", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_32", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_33", "coefficient of dissipation", "1/s", low="0"),
    Output("v_1", "drift of a", "rad/s^2"),
    Output("v_2", "drift of theta", "rad/s"),
    Output("v_3", "drift of Omega", "rad/s^2"),
    ulp=6,
    condition="These are sums with zeros inside the domain: the ulp are those of the largest addend.",
    claims={"2.4": "5d05a5afbfdd", "2.4.2": "70ba75a388cd"},
)
def stratonovich_drift(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33):
    """Drift of amplitude, phase and frequency in Stratonovich's sense.

    v_1 = varepsilon*(-Omega*d_13*cos(psi)/k + Omega*d_23*sin(psi)/k + a*(-d_11*cos(psi)**2 + d_12*sin(psi)*cos(psi)
        + d_21*sin(psi)*cos(psi) - d_22*sin(psi)**2))
    v_2 = varepsilon*(Omega*(d_13*sin(psi) + d_23*cos(psi))/(a*k) + d_11*sin(psi)*cos(psi) - d_12*sin(psi)**2 +
        d_21*cos(psi)**2 - d_22*sin(psi)*cos(psi))
    v_3 = varepsilon*(-Omega*d_33 + a*k*(-d_31*cos(psi) + d_32*sin(psi)))

    >>> [f"{x:.6g}" for x in stratonovich_drift(0.07, 1.13, 1.2, 0.27, 0.33, 0.4, 0.47, 0.53, 0.6, 0.67, 0.73,
    ...     0.8, 0.87, 0.93)]
    ['0.631863', '16.4439', '-0.365501']
    """
    sin_psi = sin(psi)
    t1 = Omega / k
    cos_psi = cos(psi)
    cos_psi_squared = cos_psi * cos_psi
    sin_psi_squared = sin_psi * sin_psi
    t2 = cos_psi * sin_psi
    t15 = a * (d_12 * t2 + d_21 * t2 - cos_psi_squared * d_11 - d_22 * sin_psi_squared) + d_23 * (sin_psi * t1)
    t29 = t1 * (d_13 * sin_psi + cos_psi * d_23) / a + (d_11 * t2 + cos_psi_squared * d_21) - d_12 * sin_psi_squared
    v_1 = (t15 - d_13 * (cos_psi * t1)) * varepsilon
    v_2 = (t29 - d_22 * t2) * varepsilon
    v_3 = ((d_32 * sin_psi - cos_psi * d_31) * (a * k) - Omega * d_33) * varepsilon
    return v_1, v_2, v_3


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("psi", "phase", "rad"),
    Argument("Omega", "frequency k x_3", "rad/s"),
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("varepsilon", "small parameter of the torques", low="0"),
    Argument("g_11", "intensity of the multiplicative noise of axis 1", "s^(-1/2)", low="0"),
    Argument("g_12", "intensity of the multiplicative noise of axis 2", "s^(-1/2)", low="0"),
    Argument("g_21", "intensity of the additive noise of axis 1", "rad s^(-3/2)", low="0"),
    Argument("g_22", "intensity of the additive noise of axis 2", "rad s^(-3/2)", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Argument("g_23", "intensity of the additive noise of axis 3", "rad s^(-3/2)", low="0"),
    Output("h_11", "intensity of noise 1 in a", "rad/s^(3/2)"),
    Output("h_12", "intensity of noise 2 in a", "rad/s^(3/2)"),
    Output("h_14", "intensity of noise 4 in a", "rad/s^(3/2)"),
    Output("h_15", "intensity of noise 5 in a", "rad/s^(3/2)"),
    Output("h_21", "intensity of noise 1 in theta", "rad/s^(1/2)"),
    Output("h_22", "intensity of noise 2 in theta", "rad/s^(1/2)"),
    Output("h_24", "intensity of noise 4 in theta", "rad/s^(1/2)"),
    Output("h_25", "intensity of noise 5 in theta", "rad/s^(1/2)"),
    Output("h_33", "intensity of noise 3 in Omega", "rad/s^(3/2)"),
    Output("h_36", "intensity of noise 6 in Omega", "rad/s^(3/2)"),
    ulp=5,
    condition="In squares the last place of a sine or cosine counts twice.",
    claims={"2.4.5b": "0fb70605bfb3", "2.4.6": "a2427fbe7674"},
)
def noise_intensities(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23):
    """Intensities of the noises in amplitude, phase and frequency; h_13, h_16, h_23, h_26, h_31, h_32, h_34, h_35 are
        0.

    h_11 = a*g_11*sqrt(varepsilon)*cos(psi)**2
    h_12 = a*g_12*sqrt(varepsilon)*sin(psi)**2
    h_14 = g_21*sqrt(varepsilon)*cos(psi)
    h_15 = -g_22*sqrt(varepsilon)*sin(psi)
    h_21 = -g_11*sqrt(varepsilon)*sin(psi)*cos(psi)
    h_22 = g_12*sqrt(varepsilon)*sin(psi)*cos(psi)
    h_24 = -g_21*sqrt(varepsilon)*sin(psi)/a
    h_25 = -g_22*sqrt(varepsilon)*cos(psi)/a
    h_33 = Omega*g_13*sqrt(varepsilon)
    h_36 = g_23*k*sqrt(varepsilon)

    >>> [f"{x:.6g}" for x in noise_intensities(0.08, 1.17, 1.25, 0.33, 0.42, 0.5, 0.58, 0.67, 0.75, 0.83, 0.92)]
    ... # doctest: +NORMALIZE_WHITESPACE
    ['0.00394595', '0.0254933', '0.169408', '-0.447536', '-0.116405', '0.135029', '-4.99748', '-2.37044',
     '0.672377', '0.196755']
    """
    cos_psi = cos(psi)
    sqrt_varepsilon = sqrt(varepsilon)
    t1 = a * sqrt_varepsilon
    sin_psi = sin(psi)
    t2 = cos_psi * sqrt_varepsilon
    t3 = sin_psi * sqrt_varepsilon
    t4 = sin_psi * t2
    t5 = 1.0 / a
    h_11 = cos_psi * cos_psi * (g_11 * t1)
    h_12 = sin_psi * sin_psi * (g_12 * t1)
    h_14 = g_21 * t2
    h_15 = -(g_22 * t3)
    h_21 = -(g_11 * t4)
    h_22 = g_12 * t4
    h_24 = -(g_21 * (t3 * t5))
    h_25 = -(g_22 * (t2 * t5))
    h_33 = g_13 * (Omega * sqrt_varepsilon)
    h_36 = k * (g_23 * sqrt_varepsilon)
    return h_11, h_12, h_14, h_15, h_21, h_22, h_24, h_25, h_33, h_36


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("psi", "phase", "rad"),
    Argument("Omega", "frequency k x_3", "rad/s"),
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("varepsilon", "small parameter of the torques", low="0"),
    Argument("d_11", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_12", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_13", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_21", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_22", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_23", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_31", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_32", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_33", "coefficient of dissipation", "1/s", low="0"),
    Argument("g_11", "intensity of the multiplicative noise of axis 1", "s^(-1/2)", low="0"),
    Argument("g_12", "intensity of the multiplicative noise of axis 2", "s^(-1/2)", low="0"),
    Argument("g_21", "intensity of the additive noise of axis 1", "rad s^(-3/2)", low="0"),
    Argument("g_22", "intensity of the additive noise of axis 2", "rad s^(-3/2)", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Output("K_1", "drift of a", "rad/s^2"),
    Output("K_2", "drift of theta", "rad/s"),
    Output("K_3", "drift of Omega", "rad/s^2"),
    ulp=8,
    condition="These are sums with zeros inside the domain: the ulp are those of the largest addend.",
    claims={"3.1.2": "5273a157bf0d", "3.2.1": "3ac5751244d0"},
    forms="a15545b5622e",
)
def drift_coefficients(
    a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22,
    g_13,
):
    """Drift coefficients of the Fokker-Planck-Kolmogorov equation for amplitude, phase and frequency.

    K_1 = varepsilon*(-Omega*d_13*cos(psi)/k + Omega*d_23*sin(psi)/k + a*(-2*d_11*cos(psi)**2 +
        2*d_12*sin(psi)*cos(psi) + 2*d_21*sin(psi)*cos(psi) - 2*d_22*sin(psi)**2 + 2*g_11**2*sin(psi)**2*cos(psi)**2
        + g_11**2*cos(psi)**4 + g_12**2*sin(psi)**4 + 2*g_12**2*sin(psi)**2*cos(psi)**2)/2 + (g_21**2*sin(psi)**2 +
        g_22**2*cos(psi)**2)/(2*a))
    K_2 = varepsilon*(Omega*(d_13*sin(psi) + d_23*cos(psi))/(a*k) + d_11*sin(psi)*cos(psi) - d_12*sin(psi)**2 +
        d_21*cos(psi)**2 - d_22*sin(psi)*cos(psi) - g_11**2*sin(psi)**3*cos(psi)/2 + g_11**2*sin(psi)*cos(psi)**3/2
        - g_12**2*sin(psi)**3*cos(psi)/2 + g_12**2*sin(psi)*cos(psi)**3/2 + (g_21**2 -
        g_22**2)*sin(psi)*cos(psi)/a**2)
    K_3 = varepsilon*(-Omega*d_33 + Omega*g_13**2/2 + a*k*(-d_31*cos(psi) + d_32*sin(psi)))

    >>> [f"{x:.6g}" for x in drift_coefficients(0.05, 1.1, 1.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55,
    ...     0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95)]
    ['2.29849', '13.7819', '-0.0707478']
    """
    cos_psi = cos(psi)
    sin_psi = sin(psi)
    t1 = Omega / k
    t2 = 1.0 / a
    g_21_squared = g_21 * g_21
    sin_psi_squared = sin_psi * sin_psi
    g_22_squared = g_22 * g_22
    cos_psi_squared = cos_psi * cos_psi
    t3 = cos_psi * sin_psi
    g_11_squared = g_11 * g_11
    g_12_squared = g_12 * g_12
    t17 = (
        (1.0 + cos_psi_squared) * (g_12_squared * sin_psi_squared) + (1.0 + sin_psi_squared) * (cos_psi_squared *
        g_11_squared)
    )
    t20 = 2.0 * ((d_12 + d_21) * t3) + t17 - 2.0 * (cos_psi_squared * d_11) - 2.0 * (d_22 * sin_psi_squared)
    t33 = (
        (1.0 / 2.0) * (t2 * (g_21_squared * sin_psi_squared + cos_psi_squared * g_22_squared)) + ((1.0 / 2.0) * (a *
        t20) + t1 * (d_23 * sin_psi - cos_psi * d_13))
    )
    t49 = (
        (g_21_squared - g_22_squared) / (a * a) + (d_11 + (1.0 / 2.0) * ((g_11_squared + g_12_squared) *
        (cos_psi_squared - sin_psi_squared)))
    )
    t53 = t3 * (t49 - d_22) + (cos_psi_squared * d_21 + (d_13 * sin_psi + cos_psi * d_23) * (t1 * t2))
    t65 = (Omega * ((1.0 / 2.0) * (g_13 * g_13) - d_33) + (d_32 * sin_psi - cos_psi * d_31) * (a * k)) * varepsilon
    K_1 = t33 * varepsilon
    K_2 = (t53 - d_12 * sin_psi_squared) * varepsilon
    return K_1, K_2, t65


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("psi", "phase", "rad"),
    Argument("Omega", "frequency k x_3", "rad/s"),
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("varepsilon", "small parameter of the torques", low="0"),
    Argument("g_11", "intensity of the multiplicative noise of axis 1", "s^(-1/2)", low="0"),
    Argument("g_12", "intensity of the multiplicative noise of axis 2", "s^(-1/2)", low="0"),
    Argument("g_21", "intensity of the additive noise of axis 1", "rad s^(-3/2)", low="0"),
    Argument("g_22", "intensity of the additive noise of axis 2", "rad s^(-3/2)", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Argument("g_23", "intensity of the additive noise of axis 3", "rad s^(-3/2)", low="0"),
    Output("K_11", "diffusion of a", "rad^2/s^3"),
    Output("K_12", "diffusion of a and theta", "rad^2/s^2"),
    Output("K_22", "diffusion of theta", "rad^2/s"),
    Output("K_33", "diffusion of Omega", "rad^2/s^3"),
    ulp=8,
    condition=(
        "In fourth powers the last place of a sine or cosine counts four times. K_12 is a sum with zeros inside the"
        " domain: its ulp are those of the largest addend."
    ),
    claims={"3.1.2": "5273a157bf0d", "3.2.1": "3ac5751244d0"},
)
def diffusion_coefficients(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23):
    """Diffusion coefficients of the Fokker-Planck-Kolmogorov equation: K_21 = K_12, the others are 0.

    K_11 = varepsilon*(a**2*(g_11**2*cos(psi)**4 + g_12**2*sin(psi)**4) + g_21**2*cos(psi)**2 + g_22**2*sin(psi)**2)
    K_12 = varepsilon*(a*(-g_11**2*cos(psi)**2 + g_12**2*sin(psi)**2) + (-g_21**2 + g_22**2)/a)*sin(psi)*cos(psi)
    K_22 = varepsilon*(g_11**2*sin(psi)**2*cos(psi)**2 + g_12**2*sin(psi)**2*cos(psi)**2 + (g_21**2*sin(psi)**2 +
        g_22**2*cos(psi)**2)/a**2)
    K_33 = varepsilon*(Omega**2*g_13**2 + g_23**2*k**2)

    >>> [f"{x:.6g}" for x in diffusion_coefficients(0.08, 1.17, 1.25, 0.33, 0.42, 0.5, 0.58, 0.67, 0.75, 0.83,
    ...     0.92)]
    ['0.229653', '0.217229', '30.6256', '0.490803']
    """
    g_21_squared = g_21 * g_21
    cos_psi = cos(psi)
    cos_psi_squared = cos_psi * cos_psi
    g_22_squared = g_22 * g_22
    sin_psi = sin(psi)
    sin_psi_squared = sin_psi * sin_psi
    a_squared = a * a
    g_11_squared = g_11 * g_11
    g_12_squared = g_12 * g_12
    t1 = cos_psi_squared * g_11_squared
    t6 = cos_psi_squared * cos_psi_squared * g_11_squared + g_12_squared * (sin_psi_squared * sin_psi_squared)
    t10 = (a_squared * t6 + (cos_psi_squared * g_21_squared + g_22_squared * sin_psi_squared)) * varepsilon
    t19 = (
        (a * (g_12_squared * sin_psi_squared - t1) + (g_22_squared - g_21_squared) / a) * (cos_psi * sin_psi *
        varepsilon)
    )
    t28 = (
        (g_21_squared * sin_psi_squared + cos_psi_squared * g_22_squared) / a_squared + (g_12_squared * (cos_psi_squared
        * sin_psi_squared) + sin_psi_squared * t1)
    )
    K_22 = t28 * varepsilon
    K_33 = (Omega * Omega * (g_13 * g_13) + g_23 * g_23 * (k * k)) * varepsilon
    return t10, t19, K_22, K_33


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("Omega", "frequency k x_3", "rad/s"),
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="0"),
    Argument("d_12", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_21", "coefficient of dissipation", "1/s", low="0"),
    Argument("d_33", "coefficient of dissipation", "1/s", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Output("Kbar_1", "drift of a", "rad/s^2"),
    Output("Kbar_2", "drift of theta", "rad/s"),
    Output("Kbar_3", "drift of Omega", "rad/s^2"),
    ulp=4,
    condition="These are sums with zeros inside the domain: the ulp are those of the largest addend.",
    claims={"3.2.5": "6ac1e8e51fbe", "3.2.7": "eb0bb4c9799c"},
)
def averaged_drift(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13):
    """Drift coefficients divided by epsilon, averaged over the phase.

    Kbar_1 = (5*a**2*alpha**2 - 8*a**2*gamma**2 + 4*beta**2)/(16*a)
    Kbar_2 = -(d_12 - d_21)/2
    Kbar_3 = -Omega*(2*d_33 - g_13**2)/2

    >>> [f"{x:.6g}" for x in averaged_drift(0.1, 1.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)]
    ['0.390313', '0.05', '-0.474']
    """
    a_squared = a * a
    t7 = 5.0 * (a_squared * (alpha * alpha)) + 4.0 * (beta * beta) - 8.0 * (a_squared * (gamma * gamma))
    Kbar_1 = (1.0 / 16.0) * t7 / a
    Kbar_2 = (1.0 / 2.0) * d_21 - (1.0 / 2.0) * d_12
    Kbar_3 = -((1.0 / 2.0) * (Omega * (2.0 * d_33 - g_13 * g_13)))
    return Kbar_1, Kbar_2, Kbar_3


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("Omega", "frequency k x_3", "rad/s"),
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Argument("g_23", "intensity of the additive noise of axis 3", "rad s^(-3/2)", low="0"),
    Output("Kbar_11", "diffusion of a", "rad^2/s^3"),
    Output("Kbar_22", "diffusion of theta", "rad^2/s"),
    Output("Kbar_33", "diffusion of Omega", "rad^2/s^3"),
    ulp=4,
    claims={"3.2.3": "af88768b172f", "3.2.4": "9a0cec31e26c", "3.2.7": "eb0bb4c9799c"},
)
def averaged_diffusion(a, Omega, k, alpha, beta, g_13, g_23):
    """Diffusion coefficients divided by epsilon, averaged over the phase; the mixed ones are 0.

    Kbar_11 = (3*a**2*alpha**2 + 4*beta**2)/8
    Kbar_22 = (a**2*alpha**2 + 4*beta**2)/(8*a**2)
    Kbar_33 = Omega**2*g_13**2 + g_23**2*k**2

    >>> [f"{x:.6g}" for x in averaged_diffusion(0.12, 1.25, 0.38, 0.5, 0.62, 0.75, 0.88)]
    ['0.19355', '13.3785', '0.99073']
    """
    beta_squared = beta * beta
    a_squared = a * a
    t1 = a_squared * (alpha * alpha)
    Kbar_11 = (1.0 / 2.0) * beta_squared + (3.0 / 8.0) * t1
    Kbar_22 = (1.0 / 8.0) * (t1 + 4.0 * beta_squared) / a_squared
    Kbar_33 = g_23 * g_23 * (k * k) + Omega * Omega * (g_13 * g_13)
    return Kbar_11, Kbar_22, Kbar_33


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="alpha/2"),
    Output("p_s1", "density of a", "s/rad"),
    ulp=8,
    condition=(
        "The ulp are those of the value times its condition number, 1 + |kappa_1| log(1 + 3 alpha^2 a^2/(4 "
        "beta^2)), as the exponent is rounded."
    ),
    degenerate="For alpha -> 0 it becomes Rayleigh's density. Where it is below 1e-308 it is 0.",
    claims={"3.4": "1151d266f39f", "3.5": "9b09838828a8", "4.0.3": "ab42d552a443", "B.2": "e5842dbdec58",
        "B.3": "c68c40b1b8ed"},
)
def density_of_amplitude(a, alpha, beta, gamma):
    """Stationary density of the amplitude, normalised.

    p_s1 = 2*a*(-alpha + 2*gamma)*(alpha + 2*gamma)/((3*a**2*alpha**2 + 4*beta**2)*(3*a**2*alpha**2/(4*beta**2) +
        1)**((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2)))

    >>> format(density_of_amplitude(0.2, 0.4, 0.6, 1.0), ".6g")
    '0.946799'
    """
    t1 = 2.0 * gamma
    beta_squared = beta * beta
    a_squared = a * a
    t4 = a_squared * (alpha * alpha)
    t5 = 1.0 / beta_squared
    t12 = (alpha + t1) * (alpha - t1)
    t19 = exp((1.0 / 4.0) * (log1p_ratio((3.0 / 4.0) * (t4 * t5)) * (a_squared * t12 * t5))) * (a * t12)
    return -(2.0 * t19 / (4.0 * beta_squared + 3.0 * t4))


@kernel(
    Argument("Omega", "frequency k x_3", "rad/s"),
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Argument("g_23", "intensity of the additive noise of axis 3", "rad s^(-3/2)", low="0"),
    Argument("d_33", "coefficient of dissipation", "1/s", low="0"),
    Output("p_s3", "density of Omega", "s/rad"),
    ulp=16,
    condition=(
        "The ulp are those of the value times its condition number, 1 + |kappa_2| log(1 + g_13^2 Omega^2/(g_23 "
        "k)^2), as the exponent is rounded."
    ),
    degenerate="For g_13 -> 0 it becomes normal. Where it is below 1e-308 it is 0.",
    claims={"3.4.2": "6a0fedfb75dc", "3.5.1": "9ebdaa94d36f", "4.0.5": "d9e732415424", "B.5": "e2b65d404ac3"},
)
def density_of_frequency(Omega, k, g_13, g_23, d_33):
    """Stationary density of the frequency, normalised; gamma() is Euler's function.

    p_s3 = g_13*gamma(d_33/g_13**2 + 1/2)/(sqrt(pi)*sqrt(Omega**2*g_13**2 +
        g_23**2*k**2)*(Omega**2*g_13**2/(g_23**2*k**2) + 1)**(d_33/g_13**2)*gamma(d_33/g_13**2))

    >>> format(density_of_frequency(1.17, 0.33, 0.5, 0.67, 0.83), ".6g")
    '0.00079462'
    """
    g_13_squared = g_13 * g_13
    Omega_squared = Omega * Omega
    t1 = Omega_squared * g_13_squared
    t2 = g_23 * g_23 * (k * k)
    t3 = 1.0 / t2
    t16 = (
        gamma_ratio(d_33 / g_13_squared, 1.0 / 2.0) * (sqrt(d_33) * exp(-(log1p_ratio(t1 * t3) * (d_33 *
        (Omega_squared * t3)))))
    )
    return t16 / (sqrt(pi) * sqrt(t1 + t2))


@kernel(
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="alpha/2"),
    Output("log_C_1", "log C_1"),
    ulp=6,
    condition=(
        "An error is a relative error of the constant: the ulp are those of 2, of the larger addend or of the "
        "exponent, whichever is largest."
    ),
    claims={"3.4": "1151d266f39f", "3.5": "9b09838828a8", "4.0.3": "ab42d552a443", "B.2": "e5842dbdec58"},
)
def logarithm_of_constant_of_amplitude(alpha, beta, gamma):
    """The logarithm of the constant in the density 8 C_1 a Delta_1^kappa_1 of the amplitude.

    log_C_1 = log((-alpha + 2*gamma)*(alpha + 2*gamma)/4) + 2*(-alpha + 2*gamma)*(alpha +
        2*gamma)*log(2*beta)/(3*alpha**2)

    >>> format(logarithm_of_constant_of_amplitude(0.25, 0.5, 0.88), ".6g")
    '-0.27605'
    """
    t1 = 2.0 * gamma
    t4 = (alpha + t1) * (t1 - alpha)
    return (2.0 / 3.0) * (t4 * log(2.0 * beta)) / (alpha * alpha) + log((1.0 / 4.0) * t4)


@kernel(
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Argument("g_23", "intensity of the additive noise of axis 3", "rad s^(-3/2)", low="0"),
    Argument("d_33", "coefficient of dissipation", "1/s", low="0"),
    Output("log_C_2", "log C_2"),
    ulp=16,
    condition=(
        "An error is a relative error of the constant: the ulp are those of 2, of the larger addend or of the "
        "exponent, whichever is largest."
    ),
    claims={"3.4.2": "6a0fedfb75dc", "3.5.1": "9ebdaa94d36f", "4.0.5": "d9e732415424", "B.5": "e2b65d404ac3"},
)
def logarithm_of_constant_of_frequency(k, g_13, g_23, d_33):
    """The logarithm of the constant in the density C_2 Delta_2^kappa_2 of the frequency; gamma() is Euler's function.

    log_C_2 = 2*d_33*log(g_23*k)/g_13**2 + log(g_13*gamma(d_33/g_13**2 + 1/2)/(sqrt(pi)*gamma(d_33/g_13**2)))

    >>> format(logarithm_of_constant_of_frequency(0.2, 0.4, 0.6, 0.8), ".6g")
    '-21.9115'
    """
    t1 = d_33 / (g_13 * g_13)
    t10 = 2.0 * (t1 * log(g_23 * k)) + log(sqrt(d_33) * gamma_ratio(t1, 1.0 / 2.0) / sqrt(pi))
    return t10


@kernel(
    Argument("a", "amplitude of the equatorial angular velocity", "rad/s", low="0"),
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="alpha/2"),
    Output("F", "probability"),
    ulp=8,
    condition="The exponent of the power is rounded.",
    claims={"B.3": "c68c40b1b8ed"},
)
def distribution_of_amplitude(a, alpha, beta, gamma):
    """The probability that the amplitude is at most a.

    F = 1 - 1/(3*a**2*alpha**2/(4*beta**2) + 1)**((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2))

    >>> format(distribution_of_amplitude(0.2, 0.4, 0.6, 1.0), ".6g")
    '0.100541'
    """
    t1 = 2.0 * gamma
    t2 = a * a / (beta * beta)
    t11 = (1.0 / 4.0) * (log1p_ratio((3.0 / 4.0) * (alpha * alpha * t2)) * ((alpha - t1) * (t2 * (alpha + t1))))
    return -expm1(t11)


@kernel(
    Argument("q", "probability", low="0", high="1"),
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="3*alpha/5"),
    Output("a_q", "quantile of a", "rad/s"),
    ulp=8,
    condition=(
        "The ulp are those of the value times its condition number, 1 + |log(1 - q)|/nu with nu = |kappa_1| - 1."
    ),
    degenerate="Nearer to gamma = alpha/2, where the density ends to exist, quantiles may be infinite.",
    claims={"B.3": "c68c40b1b8ed", "B.4": "62615be373ca"},
)
def quantile_of_amplitude(q, alpha, beta, gamma):
    """The amplitude that is exceeded with the probability 1 - q.

    a_q = 2*sqrt(3)*beta*sqrt(-1 + (1 - q)**(-3*alpha**2/((-alpha + 2*gamma)*(alpha + 2*gamma))))/(3*alpha)

    >>> format(quantile_of_amplitude(0.2, 0.4, 0.6, 1.04), ".6g")
    '0.279505'
    """
    t1 = 2.0 * gamma
    t2 = alpha + t1
    t4 = log1p(-q)
    t6 = 1.0 / (t1 - alpha)
    t20 = sqrt(expm1_ratio(-(3.0 * (alpha * alpha * (t4 * t6)) / t2))) * (sqrt(-t4) * (beta * sqrt(t6)))
    return 2.0 * t20 / sqrt(t2)


@kernel(
    Argument("m", "order of the moment", low="0", high="8", closed=True),
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="alpha*sqrt((2 + 3*m)/8)*(1 + 1e-9)"),
    Output("M_a", "moment", "(rad/s)^m"),
    ulp=16,
    condition=(
        "The ulp are those of the value times its condition number, (2 + m) (1 + log(1 + m)) nu/(nu - m/2) with nu "
        "= |kappa_1| - 1."
    ),
    degenerate="Beyond the domain the moment is infinite, and the formula means nothing.",
    claims={"4.0.9": "2103dcf0e4fd", "B.2": "e5842dbdec58", "B.6": "44044af9cd3e"},
)
def moment_of_amplitude(m, alpha, beta, gamma):
    """The mean of a^m; gamma() is Euler's function.

    M_a = gamma(-m/2 + (-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2))*gamma(m/2 +
        1)/((3*alpha**2/(4*beta**2))**(m/2)*gamma((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2)))

    >>> format(moment_of_amplitude(1.6, 0.4, 0.6, 1.17), ".6g")
    '0.350571'
    """
    t1 = (1.0 / 2.0) * m
    t2 = 2.0 * gamma
    t3 = alpha + t2
    t4 = t2 - alpha
    t18 = (
        gamma_ratio((1.0 / 3.0) * (t3 * t4) / (alpha * alpha), -t1) * (pow(2.0 * beta / (sqrt(t3) *
        sqrt(t4)), m) * gamma_ratio(1.0, t1))
    )
    return t18


@kernel(
    Argument("m", "order of the moment", low="0", high="8", closed=True),
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Argument("g_23", "intensity of the additive noise of axis 3", "rad s^(-3/2)", low="0"),
    Argument("d_33", "coefficient of dissipation", "1/s", low="m*g_13**2/2*(1 + 1e-9)"),
    Output("M_Omega", "absolute moment", "(rad/s)^m"),
    ulp=16,
    condition=(
        "The ulp are those of the value times its condition number, (2 + m) (1 + log(1 + m)) delta/(delta - m/2) "
        "with delta = d_33/g_13^2."
    ),
    degenerate="Beyond the domain the moment is infinite, and the formula means nothing.",
    claims={"4.0.11": "b4ce7a1bf72c", "B.5": "e2b65d404ac3", "B.7": "084508a0bfaa"},
)
def moment_of_frequency(m, k, g_13, g_23, d_33):
    """The mean of |Omega|^m; gamma() is Euler's function.

    M_Omega = gamma(m/2 + 1/2)*gamma(d_33/g_13**2 -
        m/2)/(sqrt(pi)*(g_13**2/(g_23**2*k**2))**(m/2)*gamma(d_33/g_13**2))

    >>> format(moment_of_frequency(1.33, 0.33, 0.5, 0.67, 1.0), ".6g")
    '0.0820577'
    """
    t1 = (1.0 / 2.0) * m
    t11 = pow(g_23 * k / sqrt(d_33), m) * gamma_ratio(1.0, t1 - (1.0 / 2.0)) * gamma_ratio(d_33 / (g_13 * g_13), -t1)
    return t11 / sqrt(pi)


@kernel(
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="alpha"),
    Output("S_a", "mean square of a", "rad^2/s^2"),
    ulp=4,
    degenerate="Beyond the domain it is infinite, and the formula means nothing.",
    claims={"4.0.9": "2103dcf0e4fd", "B.8": "d9698f4ddfc7"},
)
def mean_square_of_amplitude(alpha, beta, gamma):
    """The mean of a^2.

    S_a = -beta**2/((alpha - gamma)*(alpha + gamma))

    >>> format(mean_square_of_amplitude(0.25, 0.5, 1.0), ".6g")
    '0.266667'
    """
    return -(beta * beta / ((alpha + gamma) * (alpha - gamma)))


@kernel(
    Argument("k", "(A - C)/A, of the moments of inertia A, A, C", low="0"),
    Argument("g_13", "intensity of the multiplicative noise of axis 3", "s^(-1/2)", low="0"),
    Argument("g_23", "intensity of the additive noise of axis 3", "rad s^(-3/2)", low="0"),
    Argument("d_33", "coefficient of dissipation", "1/s", low="g_13**2"),
    Output("S_Omega", "mean square of Omega", "rad^2/s^2"),
    ulp=4,
    condition=(
        "The ulp are those of the value times its condition number, (d_33 + g_13^2)/|d_33 - g_13^2|, as g_13^2 is "
        "rounded."
    ),
    degenerate="Beyond the domain it is infinite, and the formula means nothing.",
    claims={"4.0.11": "b4ce7a1bf72c", "B.8": "d9698f4ddfc7"},
)
def mean_square_of_frequency(k, g_13, g_23, d_33):
    """The mean of Omega^2.

    S_Omega = g_23**2*k**2/(2*(d_33 - g_13**2))

    >>> format(mean_square_of_frequency(0.2, 0.4, 0.6, 0.96), ".6g")
    '0.009'
    """
    return (1.0 / 2.0) * (g_23 * g_23 * (k * k)) / (d_33 - g_13 * g_13)


@kernel(
    Argument("alpha", "multiplicative noise, alpha^2 = g_11^2 + g_12^2", "s^(-1/2)", low="0"),
    Argument("beta", "additive noise, beta^2 = g_21^2 + g_22^2", "rad s^(-3/2)", low="0"),
    Argument("gamma", "dissipation, gamma^2 = d_11 + d_22", "s^(-1/2)", low="0"),
    Output("a_star", "mode of a", "rad/s"),
    ulp=4,
    claims={"4.0.13": "7089048da9b5", "4.0.14": "6193d8c6bbde", "4.0.15": "b03164dba5cf"},
)
def mode_of_amplitude(alpha, beta, gamma):
    """The most probable amplitude, where the density is largest; that of the frequency is 0.

    a_star = 2*beta/sqrt(alpha**2 + 8*gamma**2)

    >>> format(mode_of_amplitude(0.25, 0.5, 0.75), ".6g")
    '0.468165'
    """
    return 2.0 * beta / sqrt(alpha * alpha + 8.0 * (gamma * gamma))


KERNELS = {
    "stratonovich_drift": stratonovich_drift,
    "noise_intensities": noise_intensities,
    "drift_coefficients": drift_coefficients,
    "diffusion_coefficients": diffusion_coefficients,
    "averaged_drift": averaged_drift,
    "averaged_diffusion": averaged_diffusion,
    "density_of_amplitude": density_of_amplitude,
    "density_of_frequency": density_of_frequency,
    "logarithm_of_constant_of_amplitude": logarithm_of_constant_of_amplitude,
    "logarithm_of_constant_of_frequency": logarithm_of_constant_of_frequency,
    "distribution_of_amplitude": distribution_of_amplitude,
    "quantile_of_amplitude": quantile_of_amplitude,
    "moment_of_amplitude": moment_of_amplitude,
    "moment_of_frequency": moment_of_frequency,
    "mean_square_of_amplitude": mean_square_of_amplitude,
    "mean_square_of_frequency": mean_square_of_frequency,
    "mode_of_amplitude": mode_of_amplitude,
}
