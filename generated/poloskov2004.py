"""Kernels of poloskov2004. Written by `symcheck generate`: what is changed here is lost."""

import math

from symcheck.kernels.ratios import expm1_ratio, gamma_ratio, log1p_ratio
from symcheck.generated import _poloskov2004 as paths
from symcheck.kernels.runtime import kernel
from symcheck.kernels.specification import Argument, Output, Specification

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
    paths.stratonovich_drift,
    Specification(
        paper='poloskov2004',
        name='stratonovich_drift',
        says="Drift of amplitude, phase and frequency in Stratonovich's sense.",
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('psi', 'phase', unit='rad'),
            Argument('Omega', 'frequency k x_3', unit='rad/s'),
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('varepsilon', 'small parameter of the torques', low='0'),
            Argument('d_11', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_12', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_13', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_21', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_22', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_23', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_31', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_32', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_33', 'coefficient of dissipation', unit='1/s', low='0'),
        ),
        outputs=(
            Output('v_1', 'drift of a', unit='rad/s^2'),
            Output('v_2', 'drift of theta', unit='rad/s'),
            Output('v_3', 'drift of Omega', unit='rad/s^2'),
        ),
        ulp=6,
        condition='These are sums with zeros inside the domain: the ulp are those of the largest addend.',
        claims={
            'poloskov2004:2.4': '5d05a5afbfdd',
            'poloskov2004:2.4.2': '70ba75a388cd',
        },
    ),
)
def stratonovich_drift(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33):
    """Drift of amplitude, phase and frequency in Stratonovich's sense.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    psi : float or ndarray
        Phase, in rad; any number.
    Omega : float or ndarray
        Frequency k x_3, in rad/s; any number.
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    varepsilon : float or ndarray
        Small parameter of the torques, a number; 0 < varepsilon.
    d_11 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_11.
    d_12 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_12.
    d_13 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_13.
    d_21 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_21.
    d_22 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_22.
    d_23 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_23.
    d_31 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_31.
    d_32 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_32.
    d_33 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_33.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    v_1 : float or ndarray
        Drift of a, in rad/s^2.
    v_2 : float or ndarray
        Drift of theta, in rad/s.
    v_3 : float or ndarray
        Drift of Omega, in rad/s^2.

    Notes
    -----
    The function computes ::

        v_1 = varepsilon*(-Omega*d_13*cos(psi)/k + Omega*d_23*sin(psi)/k + a*(-d_11*cos(psi)**2 + d_12*sin(psi)*cos(psi) + d_21*sin(psi)*cos(psi) - d_22*sin(psi)**2))
        v_2 = varepsilon*(Omega*(d_13*sin(psi) + d_23*cos(psi))/(a*k) + d_11*sin(psi)*cos(psi) - d_12*sin(psi)**2 + d_21*cos(psi)**2 - d_22*sin(psi)*cos(psi))
        v_3 = varepsilon*(-Omega*d_33 + a*k*(-d_31*cos(psi) + d_32*sin(psi)))

    Accuracy: 6 ulp over the domain. These are sums with zeros inside the domain: the ulp are those of the largest
    addend.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:2.4 (sha256 5d05a5afbfdd), poloskov2004:2.4.2 (sha256 70ba75a388cd).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import stratonovich_drift
    >>> [f"{x:.6g}" for x in stratonovich_drift(0.07, 1.13, 1.2, 0.27, 0.33, 0.4, 0.47, 0.53, 0.6, 0.67, 0.73, 0.8, 0.87, 0.93)]
    ['0.631863', '16.4439', '-0.365501']
    """
    sin_psi = math.sin(psi)
    t1 = Omega / k
    cos_psi = math.cos(psi)
    cos_psi_squared = cos_psi * cos_psi
    sin_psi_squared = sin_psi * sin_psi
    t2 = cos_psi * sin_psi
    t15 = a * (d_12 * t2 + d_21 * t2 - cos_psi_squared * d_11 - d_22 * sin_psi_squared) + d_23 * (sin_psi * t1)
    t29 = t1 * (d_13 * sin_psi + cos_psi * d_23) / a + (d_11 * t2 + cos_psi_squared * d_21) - d_12 * sin_psi_squared
    return (t15 - d_13 * (cos_psi * t1)) * varepsilon, (t29 - d_22 * t2) * varepsilon, ((d_32 * sin_psi - cos_psi * d_31) * (a * k) - Omega * d_33) * varepsilon


@kernel(
    paths.noise_intensities,
    Specification(
        paper='poloskov2004',
        name='noise_intensities',
        says='Intensities of the noises in amplitude, phase and frequency; h_13, h_16, h_23, h_26, h_31, h_32, h_34, h_35 are 0.',
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('psi', 'phase', unit='rad'),
            Argument('Omega', 'frequency k x_3', unit='rad/s'),
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('varepsilon', 'small parameter of the torques', low='0'),
            Argument('g_11', 'intensity of the multiplicative noise of axis 1', unit='s^(-1/2)', low='0'),
            Argument('g_12', 'intensity of the multiplicative noise of axis 2', unit='s^(-1/2)', low='0'),
            Argument('g_21', 'intensity of the additive noise of axis 1', unit='rad s^(-3/2)', low='0'),
            Argument('g_22', 'intensity of the additive noise of axis 2', unit='rad s^(-3/2)', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
            Argument('g_23', 'intensity of the additive noise of axis 3', unit='rad s^(-3/2)', low='0'),
        ),
        outputs=(
            Output('h_11', 'intensity of noise 1 in a', unit='rad/s^(3/2)'),
            Output('h_12', 'intensity of noise 2 in a', unit='rad/s^(3/2)'),
            Output('h_14', 'intensity of noise 4 in a', unit='rad/s^(3/2)'),
            Output('h_15', 'intensity of noise 5 in a', unit='rad/s^(3/2)'),
            Output('h_21', 'intensity of noise 1 in theta', unit='rad/s^(1/2)'),
            Output('h_22', 'intensity of noise 2 in theta', unit='rad/s^(1/2)'),
            Output('h_24', 'intensity of noise 4 in theta', unit='rad/s^(1/2)'),
            Output('h_25', 'intensity of noise 5 in theta', unit='rad/s^(1/2)'),
            Output('h_33', 'intensity of noise 3 in Omega', unit='rad/s^(3/2)'),
            Output('h_36', 'intensity of noise 6 in Omega', unit='rad/s^(3/2)'),
        ),
        ulp=5,
        condition='In squares the last place of a sine or cosine counts twice.',
        claims={
            'poloskov2004:2.4.5b': '0fb70605bfb3',
            'poloskov2004:2.4.6': 'a2427fbe7674',
        },
    ),
)
def noise_intensities(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23):
    """Intensities of the noises in amplitude, phase and frequency; h_13, h_16, h_23, h_26, h_31, h_32, h_34, h_35 are 0.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    psi : float or ndarray
        Phase, in rad; any number.
    Omega : float or ndarray
        Frequency k x_3, in rad/s; any number.
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    varepsilon : float or ndarray
        Small parameter of the torques, a number; 0 < varepsilon.
    g_11 : float or ndarray
        Intensity of the multiplicative noise of axis 1, in s^(-1/2); 0 < g_11.
    g_12 : float or ndarray
        Intensity of the multiplicative noise of axis 2, in s^(-1/2); 0 < g_12.
    g_21 : float or ndarray
        Intensity of the additive noise of axis 1, in rad s^(-3/2); 0 < g_21.
    g_22 : float or ndarray
        Intensity of the additive noise of axis 2, in rad s^(-3/2); 0 < g_22.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    g_23 : float or ndarray
        Intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23.
    out : sequence of ndarray, optional
        10 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    h_11 : float or ndarray
        Intensity of noise 1 in a, in rad/s^(3/2).
    h_12 : float or ndarray
        Intensity of noise 2 in a, in rad/s^(3/2).
    h_14 : float or ndarray
        Intensity of noise 4 in a, in rad/s^(3/2).
    h_15 : float or ndarray
        Intensity of noise 5 in a, in rad/s^(3/2).
    h_21 : float or ndarray
        Intensity of noise 1 in theta, in rad/s^(1/2).
    h_22 : float or ndarray
        Intensity of noise 2 in theta, in rad/s^(1/2).
    h_24 : float or ndarray
        Intensity of noise 4 in theta, in rad/s^(1/2).
    h_25 : float or ndarray
        Intensity of noise 5 in theta, in rad/s^(1/2).
    h_33 : float or ndarray
        Intensity of noise 3 in Omega, in rad/s^(3/2).
    h_36 : float or ndarray
        Intensity of noise 6 in Omega, in rad/s^(3/2).

    Notes
    -----
    The function computes ::

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

    Accuracy: 5 ulp over the domain. In squares the last place of a sine or cosine counts twice.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:2.4.5b (sha256 0fb70605bfb3), poloskov2004:2.4.6 (sha256 a2427fbe7674).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import noise_intensities
    >>> [f"{x:.6g}" for x in noise_intensities(0.08, 1.17, 1.25, 0.33, 0.42, 0.5, 0.58, 0.67, 0.75, 0.83, 0.92)]
    ['0.00394595', '0.0254933', '0.169408', '-0.447536', '-0.116405', '0.135029', '-4.99748', '-2.37044', '0.672377', '0.196755']
    """
    cos_psi = math.cos(psi)
    sqrt_varepsilon = math.sqrt(varepsilon)
    t1 = a * sqrt_varepsilon
    sin_psi = math.sin(psi)
    t2 = cos_psi * sqrt_varepsilon
    t3 = sin_psi * sqrt_varepsilon
    t4 = sin_psi * t2
    t5 = 1.0 / a
    return cos_psi * cos_psi * (g_11 * t1), sin_psi * sin_psi * (g_12 * t1), g_21 * t2, -(g_22 * t3), -(g_11 * t4), g_12 * t4, -(g_21 * (t3 * t5)), -(g_22 * (t2 * t5)), g_13 * (Omega * sqrt_varepsilon), k * (g_23 * sqrt_varepsilon)


@kernel(
    paths.drift_coefficients,
    Specification(
        paper='poloskov2004',
        name='drift_coefficients',
        says='Drift coefficients of the Fokker-Planck-Kolmogorov equation for amplitude, phase and frequency.',
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('psi', 'phase', unit='rad'),
            Argument('Omega', 'frequency k x_3', unit='rad/s'),
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('varepsilon', 'small parameter of the torques', low='0'),
            Argument('d_11', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_12', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_13', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_21', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_22', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_23', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_31', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_32', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_33', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('g_11', 'intensity of the multiplicative noise of axis 1', unit='s^(-1/2)', low='0'),
            Argument('g_12', 'intensity of the multiplicative noise of axis 2', unit='s^(-1/2)', low='0'),
            Argument('g_21', 'intensity of the additive noise of axis 1', unit='rad s^(-3/2)', low='0'),
            Argument('g_22', 'intensity of the additive noise of axis 2', unit='rad s^(-3/2)', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
        ),
        outputs=(
            Output('K_1', 'drift of a', unit='rad/s^2'),
            Output('K_2', 'drift of theta', unit='rad/s'),
            Output('K_3', 'drift of Omega', unit='rad/s^2'),
        ),
        ulp=8,
        condition='These are sums with zeros inside the domain: the ulp are those of the largest addend.',
        claims={
            'poloskov2004:3.1.2': '5273a157bf0d',
            'poloskov2004:3.2.1': '3ac5751244d0',
        },
    ),
)
def drift_coefficients(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13):
    """Drift coefficients of the Fokker-Planck-Kolmogorov equation for amplitude, phase and frequency.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    psi : float or ndarray
        Phase, in rad; any number.
    Omega : float or ndarray
        Frequency k x_3, in rad/s; any number.
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    varepsilon : float or ndarray
        Small parameter of the torques, a number; 0 < varepsilon.
    d_11 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_11.
    d_12 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_12.
    d_13 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_13.
    d_21 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_21.
    d_22 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_22.
    d_23 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_23.
    d_31 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_31.
    d_32 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_32.
    d_33 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_33.
    g_11 : float or ndarray
        Intensity of the multiplicative noise of axis 1, in s^(-1/2); 0 < g_11.
    g_12 : float or ndarray
        Intensity of the multiplicative noise of axis 2, in s^(-1/2); 0 < g_12.
    g_21 : float or ndarray
        Intensity of the additive noise of axis 1, in rad s^(-3/2); 0 < g_21.
    g_22 : float or ndarray
        Intensity of the additive noise of axis 2, in rad s^(-3/2); 0 < g_22.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    K_1 : float or ndarray
        Drift of a, in rad/s^2.
    K_2 : float or ndarray
        Drift of theta, in rad/s.
    K_3 : float or ndarray
        Drift of Omega, in rad/s^2.

    Notes
    -----
    The function computes ::

        K_1 = varepsilon*(-Omega*d_13*cos(psi)/k + Omega*d_23*sin(psi)/k + a*(-2*d_11*cos(psi)**2 + 2*d_12*sin(psi)*cos(psi) + 2*d_21*sin(psi)*cos(psi) - 2*d_22*sin(psi)**2 + 2*g_11**2*sin(psi)**2*cos(psi)**2 + g_11**2*cos(psi)**4 + g_12**2*sin(psi)**4 + 2*g_12**2*sin(psi)**2*cos(psi)**2)/2 + (g_21**2*sin(psi)**2 + g_22**2*cos(psi)**2)/(2*a))
        K_2 = varepsilon*(Omega*(d_13*sin(psi) + d_23*cos(psi))/(a*k) + d_11*sin(psi)*cos(psi) - d_12*sin(psi)**2 + d_21*cos(psi)**2 - d_22*sin(psi)*cos(psi) - g_11**2*sin(psi)**3*cos(psi)/2 + g_11**2*sin(psi)*cos(psi)**3/2 - g_12**2*sin(psi)**3*cos(psi)/2 + g_12**2*sin(psi)*cos(psi)**3/2 + (g_21**2 - g_22**2)*sin(psi)*cos(psi)/a**2)
        K_3 = varepsilon*(-Omega*d_33 + Omega*g_13**2/2 + a*k*(-d_31*cos(psi) + d_32*sin(psi)))

    Accuracy: 8 ulp over the domain. These are sums with zeros inside the domain: the ulp are those of the largest
    addend.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.1.2 (sha256 5273a157bf0d), poloskov2004:3.2.1 (sha256 3ac5751244d0).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import drift_coefficients
    >>> [f"{x:.6g}" for x in drift_coefficients(0.05, 1.1, 1.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95)]
    ['2.29849', '13.7819', '-0.0707478']
    """
    sin_psi = math.sin(psi)
    t1 = Omega / k
    cos_psi = math.cos(psi)
    t2 = 1.0 / a
    g_21_squared = g_21 * g_21
    sin_psi_squared = sin_psi * sin_psi
    g_22_squared = g_22 * g_22
    cos_psi_squared = cos_psi * cos_psi
    t3 = 2.0 * cos_psi_squared
    t4 = cos_psi * sin_psi
    t5 = 2.0 * t4
    g_11_squared = g_11 * g_11
    g_12_squared = g_12 * g_12
    t6 = sin_psi_squared * t3
    t7 = (1.0 / 2.0) * g_11_squared
    t9 = sin_psi * (cos_psi * cos_psi_squared)
    t11 = cos_psi * (sin_psi * sin_psi_squared)
    t12 = (1.0 / 2.0) * g_12_squared
    t24 = g_11_squared * t6 + (g_12_squared * (sin_psi_squared * sin_psi_squared) + (d_12 * t5 + d_21 * t5))
    t28 = g_12_squared * t6 + (cos_psi_squared * cos_psi_squared * g_11_squared + t24) - d_11 * t3 - 2.0 * (d_22 * sin_psi_squared)
    t41 = (1.0 / 2.0) * (t2 * (g_21_squared * sin_psi_squared + cos_psi_squared * g_22_squared)) + ((1.0 / 2.0) * (a * t28) + d_23 * (sin_psi * t1))
    t62 = t7 * t9 + ((d_13 * sin_psi + cos_psi * d_23) * (t1 * t2) + (d_11 * t4 + cos_psi_squared * d_21))
    t66 = t4 * (g_21_squared - g_22_squared) / (a * a) + (t12 * t9 + t62) - d_12 * sin_psi_squared - d_22 * t4
    t79 = (1.0 / 2.0) * (Omega * (g_13 * g_13)) + (d_32 * sin_psi - cos_psi * d_31) * (a * k) - Omega * d_33
    return (t41 - d_13 * (cos_psi * t1)) * varepsilon, (t66 - t11 * t7 - t11 * t12) * varepsilon, t79 * varepsilon


@kernel(
    paths.diffusion_coefficients,
    Specification(
        paper='poloskov2004',
        name='diffusion_coefficients',
        says='Diffusion coefficients of the Fokker-Planck-Kolmogorov equation: K_21 = K_12, the others are 0.',
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('psi', 'phase', unit='rad'),
            Argument('Omega', 'frequency k x_3', unit='rad/s'),
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('varepsilon', 'small parameter of the torques', low='0'),
            Argument('g_11', 'intensity of the multiplicative noise of axis 1', unit='s^(-1/2)', low='0'),
            Argument('g_12', 'intensity of the multiplicative noise of axis 2', unit='s^(-1/2)', low='0'),
            Argument('g_21', 'intensity of the additive noise of axis 1', unit='rad s^(-3/2)', low='0'),
            Argument('g_22', 'intensity of the additive noise of axis 2', unit='rad s^(-3/2)', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
            Argument('g_23', 'intensity of the additive noise of axis 3', unit='rad s^(-3/2)', low='0'),
        ),
        outputs=(
            Output('K_11', 'diffusion of a', unit='rad^2/s^3'),
            Output('K_12', 'diffusion of a and theta', unit='rad^2/s^2'),
            Output('K_22', 'diffusion of theta', unit='rad^2/s'),
            Output('K_33', 'diffusion of Omega', unit='rad^2/s^3'),
        ),
        ulp=8,
        condition='In fourth powers the last place of a sine or cosine counts four times. K_12 is a sum with zeros inside the domain: its ulp are those of the largest addend.',
        claims={
            'poloskov2004:3.1.2': '5273a157bf0d',
            'poloskov2004:3.2.1': '3ac5751244d0',
        },
    ),
)
def diffusion_coefficients(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23):
    """Diffusion coefficients of the Fokker-Planck-Kolmogorov equation: K_21 = K_12, the others are 0.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    psi : float or ndarray
        Phase, in rad; any number.
    Omega : float or ndarray
        Frequency k x_3, in rad/s; any number.
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    varepsilon : float or ndarray
        Small parameter of the torques, a number; 0 < varepsilon.
    g_11 : float or ndarray
        Intensity of the multiplicative noise of axis 1, in s^(-1/2); 0 < g_11.
    g_12 : float or ndarray
        Intensity of the multiplicative noise of axis 2, in s^(-1/2); 0 < g_12.
    g_21 : float or ndarray
        Intensity of the additive noise of axis 1, in rad s^(-3/2); 0 < g_21.
    g_22 : float or ndarray
        Intensity of the additive noise of axis 2, in rad s^(-3/2); 0 < g_22.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    g_23 : float or ndarray
        Intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23.
    out : sequence of ndarray, optional
        4 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    K_11 : float or ndarray
        Diffusion of a, in rad^2/s^3.
    K_12 : float or ndarray
        Diffusion of a and theta, in rad^2/s^2.
    K_22 : float or ndarray
        Diffusion of theta, in rad^2/s.
    K_33 : float or ndarray
        Diffusion of Omega, in rad^2/s^3.

    Notes
    -----
    The function computes ::

        K_11 = varepsilon*(a**2*(g_11**2*cos(psi)**4 + g_12**2*sin(psi)**4) + g_21**2*cos(psi)**2 + g_22**2*sin(psi)**2)
        K_12 = varepsilon*(a*(-g_11**2*cos(psi)**2 + g_12**2*sin(psi)**2) + (-g_21**2 + g_22**2)/a)*sin(psi)*cos(psi)
        K_22 = varepsilon*(g_11**2*sin(psi)**2*cos(psi)**2 + g_12**2*sin(psi)**2*cos(psi)**2 + (g_21**2*sin(psi)**2 + g_22**2*cos(psi)**2)/a**2)
        K_33 = varepsilon*(Omega**2*g_13**2 + g_23**2*k**2)

    Accuracy: 8 ulp over the domain. In fourth powers the last place of a sine or cosine counts four times. K_12
    is a sum with zeros inside the domain: its ulp are those of the largest addend.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.1.2 (sha256 5273a157bf0d), poloskov2004:3.2.1 (sha256 3ac5751244d0).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import diffusion_coefficients
    >>> [f"{x:.6g}" for x in diffusion_coefficients(0.08, 1.17, 1.25, 0.33, 0.42, 0.5, 0.58, 0.67, 0.75, 0.83, 0.92)]
    ['0.229653', '0.217229', '30.6256', '0.490803']
    """
    g_21_squared = g_21 * g_21
    cos_psi = math.cos(psi)
    cos_psi_squared = cos_psi * cos_psi
    g_22_squared = g_22 * g_22
    sin_psi = math.sin(psi)
    sin_psi_squared = sin_psi * sin_psi
    a_squared = a * a
    g_11_squared = g_11 * g_11
    g_12_squared = g_12 * g_12
    t1 = cos_psi_squared * g_11_squared
    t6 = cos_psi_squared * cos_psi_squared * g_11_squared + g_12_squared * (sin_psi_squared * sin_psi_squared)
    t10 = (a_squared * t6 + (cos_psi_squared * g_21_squared + g_22_squared * sin_psi_squared)) * varepsilon
    t19 = (a * (g_12_squared * sin_psi_squared - t1) + (g_22_squared - g_21_squared) / a) * (cos_psi * sin_psi * varepsilon)
    t28 = (g_21_squared * sin_psi_squared + cos_psi_squared * g_22_squared) / a_squared + (g_12_squared * (cos_psi_squared * sin_psi_squared) + sin_psi_squared * t1)
    return t10, t19, t28 * varepsilon, (Omega * Omega * (g_13 * g_13) + g_23 * g_23 * (k * k)) * varepsilon


@kernel(
    paths.averaged_drift,
    Specification(
        paper='poloskov2004',
        name='averaged_drift',
        says='Drift coefficients divided by epsilon, averaged over the phase.',
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('Omega', 'frequency k x_3', unit='rad/s'),
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='0'),
            Argument('d_12', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_21', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('d_33', 'coefficient of dissipation', unit='1/s', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
        ),
        outputs=(
            Output('Kbar_1', 'drift of a', unit='rad/s^2'),
            Output('Kbar_2', 'drift of theta', unit='rad/s'),
            Output('Kbar_3', 'drift of Omega', unit='rad/s^2'),
        ),
        ulp=4,
        condition='These are sums with zeros inside the domain: the ulp are those of the largest addend.',
        claims={
            'poloskov2004:3.2.5': '6ac1e8e51fbe',
            'poloskov2004:3.2.7': 'eb0bb4c9799c',
        },
    ),
)
def averaged_drift(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13):
    """Drift coefficients divided by epsilon, averaged over the phase.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    Omega : float or ndarray
        Frequency k x_3, in rad/s; any number.
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); 0 < gamma.
    d_12 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_12.
    d_21 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_21.
    d_33 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_33.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    Kbar_1 : float or ndarray
        Drift of a, in rad/s^2.
    Kbar_2 : float or ndarray
        Drift of theta, in rad/s.
    Kbar_3 : float or ndarray
        Drift of Omega, in rad/s^2.

    Notes
    -----
    The function computes ::

        Kbar_1 = (5*a**2*alpha**2 - 8*a**2*gamma**2 + 4*beta**2)/(16*a)
        Kbar_2 = -(d_12 - d_21)/2
        Kbar_3 = -Omega*(2*d_33 - g_13**2)/2

    Accuracy: 4 ulp over the domain. These are sums with zeros inside the domain: the ulp are those of the largest
    addend.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.2.5 (sha256 6ac1e8e51fbe), poloskov2004:3.2.7 (sha256 eb0bb4c9799c).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import averaged_drift
    >>> [f"{x:.6g}" for x in averaged_drift(0.1, 1.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)]
    ['0.390313', '0.05', '-0.474']
    """
    a_squared = a * a
    t7 = 5.0 * (a_squared * (alpha * alpha)) + 4.0 * (beta * beta) - 8.0 * (a_squared * (gamma * gamma))
    return (1.0 / 16.0) * t7 / a, (1.0 / 2.0) * d_21 - (1.0 / 2.0) * d_12, -((1.0 / 2.0) * (Omega * (2.0 * d_33 - g_13 * g_13)))


@kernel(
    paths.averaged_diffusion,
    Specification(
        paper='poloskov2004',
        name='averaged_diffusion',
        says='Diffusion coefficients divided by epsilon, averaged over the phase; the mixed ones are 0.',
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('Omega', 'frequency k x_3', unit='rad/s'),
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
            Argument('g_23', 'intensity of the additive noise of axis 3', unit='rad s^(-3/2)', low='0'),
        ),
        outputs=(
            Output('Kbar_11', 'diffusion of a', unit='rad^2/s^3'),
            Output('Kbar_22', 'diffusion of theta', unit='rad^2/s'),
            Output('Kbar_33', 'diffusion of Omega', unit='rad^2/s^3'),
        ),
        ulp=4,
        claims={
            'poloskov2004:3.2.3': 'af88768b172f',
            'poloskov2004:3.2.4': '9a0cec31e26c',
            'poloskov2004:3.2.7': 'eb0bb4c9799c',
        },
    ),
)
def averaged_diffusion(a, Omega, k, alpha, beta, g_13, g_23):
    """Diffusion coefficients divided by epsilon, averaged over the phase; the mixed ones are 0.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    Omega : float or ndarray
        Frequency k x_3, in rad/s; any number.
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    g_23 : float or ndarray
        Intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23.
    out : sequence of ndarray, optional
        3 arrays for the results, of the broadcast shape and type.

    Returns
    -------
    Kbar_11 : float or ndarray
        Diffusion of a, in rad^2/s^3.
    Kbar_22 : float or ndarray
        Diffusion of theta, in rad^2/s.
    Kbar_33 : float or ndarray
        Diffusion of Omega, in rad^2/s^3.

    Notes
    -----
    The function computes ::

        Kbar_11 = (3*a**2*alpha**2 + 4*beta**2)/8
        Kbar_22 = (a**2*alpha**2 + 4*beta**2)/(8*a**2)
        Kbar_33 = Omega**2*g_13**2 + g_23**2*k**2

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.2.3 (sha256 af88768b172f), poloskov2004:3.2.4 (sha256 9a0cec31e26c),
    poloskov2004:3.2.7 (sha256 eb0bb4c9799c).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import averaged_diffusion
    >>> [f"{x:.6g}" for x in averaged_diffusion(0.12, 1.25, 0.38, 0.5, 0.62, 0.75, 0.88)]
    ['0.19355', '13.3785', '0.99073']
    """
    beta_squared = beta * beta
    a_squared = a * a
    t1 = a_squared * (alpha * alpha)
    return (1.0 / 2.0) * beta_squared + (3.0 / 8.0) * t1, (1.0 / 8.0) * (t1 + 4.0 * beta_squared) / a_squared, g_23 * g_23 * (k * k) + Omega * Omega * (g_13 * g_13)


@kernel(
    paths.density_of_amplitude,
    Specification(
        paper='poloskov2004',
        name='density_of_amplitude',
        says='Stationary density of the amplitude, normalised.',
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='alpha/2'),
        ),
        outputs=(
            Output('p_s1', 'density of a', unit='s/rad'),
        ),
        ulp=8,
        condition='The ulp are those of the value times its condition number, 1 + |kappa_1| log(1 + 3 alpha^2 a^2/(4 beta^2)), as the exponent is rounded.',
        degenerate="For alpha -> 0 it becomes Rayleigh's density.",
        claims={
            'poloskov2004:3.4': '1151d266f39f',
            'poloskov2004:3.5': '9b09838828a8',
            'poloskov2004:4.0.3': 'ab42d552a443',
            'poloskov2004:B.2': 'e5842dbdec58',
            'poloskov2004:B.3': 'c68c40b1b8ed',
        },
    ),
)
def density_of_amplitude(a, alpha, beta, gamma):
    """Stationary density of the amplitude, normalised.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha/2 < gamma.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    p_s1 : float or ndarray
        Density of a, in s/rad.

    Notes
    -----
    The function computes ::

        p_s1 = 2*a*(-alpha + 2*gamma)*(alpha + 2*gamma)/((3*a**2*alpha**2 + 4*beta**2)*(3*a**2*alpha**2/(4*beta**2) + 1)**((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2)))

    Accuracy: 8 ulp over the domain. The ulp are those of the value times its condition number, 1 + |kappa_1|
    log(1 + 3 alpha^2 a^2/(4 beta^2)), as the exponent is rounded. For alpha -> 0 it becomes Rayleigh's density.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.4 (sha256 1151d266f39f), poloskov2004:3.5 (sha256 9b09838828a8), poloskov2004:4.0.3
    (sha256 ab42d552a443), poloskov2004:B.2 (sha256 e5842dbdec58), poloskov2004:B.3 (sha256 c68c40b1b8ed).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import density_of_amplitude
    >>> f"{density_of_amplitude(0.2, 0.4, 0.6, 1.0):.6g}"
    '0.946799'
    """
    t1 = 2.0 * gamma
    beta_squared = beta * beta
    a_squared = a * a
    t4 = a_squared * (alpha * alpha)
    t5 = 1.0 / beta_squared
    t12 = (alpha + t1) * (alpha - t1)
    t19 = math.exp((1.0 / 4.0) * (log1p_ratio((3.0 / 4.0) * (t4 * t5)) * (a_squared * t12 * t5))) * (a * t12)
    return -(2.0 * t19 / (4.0 * beta_squared + 3.0 * t4))


@kernel(
    paths.density_of_frequency,
    Specification(
        paper='poloskov2004',
        name='density_of_frequency',
        says="Stationary density of the frequency, normalised; gamma() is Euler's function.",
        arguments=(
            Argument('Omega', 'frequency k x_3', unit='rad/s'),
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
            Argument('g_23', 'intensity of the additive noise of axis 3', unit='rad s^(-3/2)', low='0'),
            Argument('d_33', 'coefficient of dissipation', unit='1/s', low='0'),
        ),
        outputs=(
            Output('p_s3', 'density of Omega', unit='s/rad'),
        ),
        ulp=16,
        condition='The ulp are those of the value times its condition number, 1 + |kappa_2| log(1 + g_13^2 Omega^2/(g_23 k)^2), as the exponent is rounded.',
        degenerate='For g_13 -> 0 it becomes normal.',
        claims={
            'poloskov2004:3.4.2': '6a0fedfb75dc',
            'poloskov2004:3.5.1': '9ebdaa94d36f',
            'poloskov2004:4.0.5': 'd9e732415424',
            'poloskov2004:B.5': '3a5d29509c0e',
        },
    ),
)
def density_of_frequency(Omega, k, g_13, g_23, d_33):
    """Stationary density of the frequency, normalised; gamma() is Euler's function.

    Parameters
    ----------
    Omega : float or ndarray
        Frequency k x_3, in rad/s; any number.
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    g_23 : float or ndarray
        Intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23.
    d_33 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_33.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    p_s3 : float or ndarray
        Density of Omega, in s/rad.

    Notes
    -----
    The function computes ::

        p_s3 = g_13*gamma(d_33/g_13**2 + 1/2)/(sqrt(pi)*sqrt(Omega**2*g_13**2 + g_23**2*k**2)*(Omega**2*g_13**2/(g_23**2*k**2) + 1)**(d_33/g_13**2)*gamma(d_33/g_13**2))

    Accuracy: 16 ulp over the domain. The ulp are those of the value times its condition number, 1 + |kappa_2|
    log(1 + g_13^2 Omega^2/(g_23 k)^2), as the exponent is rounded. For g_13 -> 0 it becomes normal.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.4.2 (sha256 6a0fedfb75dc), poloskov2004:3.5.1 (sha256 9ebdaa94d36f),
    poloskov2004:4.0.5 (sha256 d9e732415424), poloskov2004:B.5 (sha256 3a5d29509c0e).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import density_of_frequency
    >>> f"{density_of_frequency(1.17, 0.33, 0.5, 0.67, 0.83):.6g}"
    '0.00079462'
    """
    g_13_squared = g_13 * g_13
    Omega_squared = Omega * Omega
    t1 = Omega_squared * g_13_squared
    t2 = g_23 * g_23 * (k * k)
    t3 = 1.0 / t2
    t16 = gamma_ratio(d_33 / g_13_squared, 1.0 / 2.0) * (math.sqrt(d_33) * math.exp(-(log1p_ratio(t1 * t3) * (d_33 * (Omega_squared * t3)))))
    return t16 / (math.sqrt(math.pi) * math.sqrt(t1 + t2))


@kernel(
    paths.logarithm_of_constant_of_amplitude,
    Specification(
        paper='poloskov2004',
        name='logarithm_of_constant_of_amplitude',
        says='The logarithm of the constant in the density 8 C_1 a Delta_1^kappa_1 of the amplitude.',
        arguments=(
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='alpha/2'),
        ),
        outputs=(
            Output('log_C_1', 'log C_1'),
        ),
        ulp=6,
        condition='An error is a relative error of the constant: the ulp are those of 2, of the larger addend or of the exponent, whichever is largest.',
        claims={
            'poloskov2004:3.4': '1151d266f39f',
            'poloskov2004:3.5': '9b09838828a8',
            'poloskov2004:4.0.3': 'ab42d552a443',
            'poloskov2004:B.2': 'e5842dbdec58',
        },
    ),
)
def logarithm_of_constant_of_amplitude(alpha, beta, gamma):
    """The logarithm of the constant in the density 8 C_1 a Delta_1^kappa_1 of the amplitude.

    Parameters
    ----------
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha/2 < gamma.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    log_C_1 : float or ndarray
        Log C_1, a number.

    Notes
    -----
    The function computes ::

        log_C_1 = log((-alpha + 2*gamma)*(alpha + 2*gamma)/4) + 2*(-alpha + 2*gamma)*(alpha + 2*gamma)*log(2*beta)/(3*alpha**2)

    Accuracy: 6 ulp over the domain. An error is a relative error of the constant: the ulp are those of 2, of the
    larger addend or of the exponent, whichever is largest.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.4 (sha256 1151d266f39f), poloskov2004:3.5 (sha256 9b09838828a8), poloskov2004:4.0.3
    (sha256 ab42d552a443), poloskov2004:B.2 (sha256 e5842dbdec58).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import logarithm_of_constant_of_amplitude
    >>> f"{logarithm_of_constant_of_amplitude(0.25, 0.5, 0.88):.6g}"
    '-0.27605'
    """
    t1 = 2.0 * gamma
    t4 = (alpha + t1) * (t1 - alpha)
    return (2.0 / 3.0) * (t4 * math.log(2.0 * beta)) / (alpha * alpha) + math.log((1.0 / 4.0) * t4)


@kernel(
    paths.logarithm_of_constant_of_frequency,
    Specification(
        paper='poloskov2004',
        name='logarithm_of_constant_of_frequency',
        says="The logarithm of the constant in the density C_2 Delta_2^kappa_2 of the frequency; gamma() is Euler's function.",
        arguments=(
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
            Argument('g_23', 'intensity of the additive noise of axis 3', unit='rad s^(-3/2)', low='0'),
            Argument('d_33', 'coefficient of dissipation', unit='1/s', low='0'),
        ),
        outputs=(
            Output('log_C_2', 'log C_2'),
        ),
        ulp=16,
        condition='An error is a relative error of the constant: the ulp are those of 2, of the larger addend or of the exponent, whichever is largest.',
        claims={
            'poloskov2004:3.4.2': '6a0fedfb75dc',
            'poloskov2004:3.5.1': '9ebdaa94d36f',
            'poloskov2004:4.0.5': 'd9e732415424',
            'poloskov2004:B.5': '3a5d29509c0e',
        },
    ),
)
def logarithm_of_constant_of_frequency(k, g_13, g_23, d_33):
    """The logarithm of the constant in the density C_2 Delta_2^kappa_2 of the frequency; gamma() is Euler's function.

    Parameters
    ----------
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    g_23 : float or ndarray
        Intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23.
    d_33 : float or ndarray
        Coefficient of dissipation, in 1/s; 0 < d_33.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    log_C_2 : float or ndarray
        Log C_2, a number.

    Notes
    -----
    The function computes ::

        log_C_2 = 2*d_33*log(g_23*k)/g_13**2 + log(g_13*gamma(d_33/g_13**2 + 1/2)/(sqrt(pi)*gamma(d_33/g_13**2)))

    Accuracy: 16 ulp over the domain. An error is a relative error of the constant: the ulp are those of 2, of the
    larger addend or of the exponent, whichever is largest.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:3.4.2 (sha256 6a0fedfb75dc), poloskov2004:3.5.1 (sha256 9ebdaa94d36f),
    poloskov2004:4.0.5 (sha256 d9e732415424), poloskov2004:B.5 (sha256 3a5d29509c0e).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import logarithm_of_constant_of_frequency
    >>> f"{logarithm_of_constant_of_frequency(0.2, 0.4, 0.6, 0.8):.6g}"
    '-21.9115'
    """
    t1 = d_33 / (g_13 * g_13)
    t10 = 2.0 * (t1 * math.log(g_23 * k)) + math.log(math.sqrt(d_33) * gamma_ratio(t1, 1.0 / 2.0) / math.sqrt(math.pi))
    return t10


@kernel(
    paths.distribution_of_amplitude,
    Specification(
        paper='poloskov2004',
        name='distribution_of_amplitude',
        says='The probability that the amplitude is at most a.',
        arguments=(
            Argument('a', 'amplitude of the equatorial angular velocity', unit='rad/s', low='0'),
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='alpha/2'),
        ),
        outputs=(
            Output('F', 'probability'),
        ),
        ulp=8,
        condition='The exponent of the power is rounded.',
        claims={
            'poloskov2004:B.3': 'c68c40b1b8ed',
        },
    ),
)
def distribution_of_amplitude(a, alpha, beta, gamma):
    """The probability that the amplitude is at most a.

    Parameters
    ----------
    a : float or ndarray
        Amplitude of the equatorial angular velocity, in rad/s; 0 < a.
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha/2 < gamma.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    F : float or ndarray
        Probability, a number.

    Notes
    -----
    The function computes ::

        F = 1 - 1/(3*a**2*alpha**2/(4*beta**2) + 1)**((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2))

    Accuracy: 8 ulp over the domain. The exponent of the power is rounded.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:B.3 (sha256 c68c40b1b8ed).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import distribution_of_amplitude
    >>> f"{distribution_of_amplitude(0.2, 0.4, 0.6, 1.0):.6g}"
    '0.100541'
    """
    t1 = 2.0 * gamma
    t2 = a * a / (beta * beta)
    t11 = (1.0 / 4.0) * (log1p_ratio((3.0 / 4.0) * (alpha * alpha * t2)) * ((alpha - t1) * (t2 * (alpha + t1))))
    return -math.expm1(t11)


@kernel(
    paths.quantile_of_amplitude,
    Specification(
        paper='poloskov2004',
        name='quantile_of_amplitude',
        says='The amplitude that is exceeded with the probability 1 - q.',
        arguments=(
            Argument('q', 'probability', low='0', high='1'),
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='3*alpha/5'),
        ),
        outputs=(
            Output('a_q', 'quantile of a', unit='rad/s'),
        ),
        ulp=8,
        condition='The ulp are those of the value times its condition number, 1 + |log(1 - q)|/nu with nu = |kappa_1| - 1.',
        degenerate='Nearer to gamma = alpha/2, where the density ends to exist, quantiles may be infinite.',
        claims={
            'poloskov2004:B.3': 'c68c40b1b8ed',
            'poloskov2004:B.4': '62615be373ca',
        },
    ),
)
def quantile_of_amplitude(q, alpha, beta, gamma):
    """The amplitude that is exceeded with the probability 1 - q.

    Parameters
    ----------
    q : float or ndarray
        Probability, a number; 0 < q < 1.
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); 3*alpha/5 < gamma.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    a_q : float or ndarray
        Quantile of a, in rad/s.

    Notes
    -----
    The function computes ::

        a_q = 2*sqrt(3)*beta*sqrt(-1 + (1 - q)**(-3*alpha**2/((-alpha + 2*gamma)*(alpha + 2*gamma))))/(3*alpha)

    Accuracy: 8 ulp over the domain. The ulp are those of the value times its condition number, 1 + |log(1 -
    q)|/nu with nu = |kappa_1| - 1. Nearer to gamma = alpha/2, where the density ends to exist, quantiles may be
    infinite.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:B.3 (sha256 c68c40b1b8ed), poloskov2004:B.4 (sha256 62615be373ca).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import quantile_of_amplitude
    >>> f"{quantile_of_amplitude(0.2, 0.4, 0.6, 1.04):.6g}"
    '0.279505'
    """
    t1 = 2.0 * gamma
    t2 = alpha + t1
    t4 = math.log1p(-q)
    t6 = 1.0 / (t1 - alpha)
    t20 = math.sqrt(expm1_ratio(-(3.0 * (alpha * alpha * (t4 * t6)) / t2))) * (math.sqrt(-t4) * (beta * math.sqrt(t6)))
    return 2.0 * t20 / math.sqrt(t2)


@kernel(
    paths.moment_of_amplitude,
    Specification(
        paper='poloskov2004',
        name='moment_of_amplitude',
        says="The mean of a^m; gamma() is Euler's function.",
        arguments=(
            Argument('m', 'order of the moment', low='0', high='8', closed=True),
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='alpha*sqrt((2 + 3*m)/8)*(1 + 1e-9)'),
        ),
        outputs=(
            Output('M_a', 'moment', unit='(rad/s)^m'),
        ),
        ulp=16,
        condition='The ulp are those of the value times its condition number, (2 + m) (1 + log(1 + m)) nu/(nu - m/2) with nu = |kappa_1| - 1.',
        degenerate='Beyond the domain the moment is infinite, and the formula means nothing.',
        claims={
            'poloskov2004:4.0.9': '2103dcf0e4fd',
            'poloskov2004:B.2': 'e5842dbdec58',
            'poloskov2004:B.6': '44044af9cd3e',
        },
    ),
)
def moment_of_amplitude(m, alpha, beta, gamma):
    """The mean of a^m; gamma() is Euler's function.

    Parameters
    ----------
    m : float or ndarray
        Order of the moment, a number; 0 <= m <= 8.
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha*sqrt((2 + 3*m)/8)*(1 + 1e-9) < gamma.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    M_a : float or ndarray
        Moment, in (rad/s)^m.

    Notes
    -----
    The function computes ::

        M_a = gamma(-m/2 + (-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2))*gamma(m/2 + 1)/((3*alpha**2/(4*beta**2))**(m/2)*gamma((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2)))

    Accuracy: 16 ulp over the domain. The ulp are those of the value times its condition number, (2 + m) (1 +
    log(1 + m)) nu/(nu - m/2) with nu = |kappa_1| - 1. Beyond the domain the moment is infinite, and the formula
    means nothing.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:4.0.9 (sha256 2103dcf0e4fd), poloskov2004:B.2 (sha256 e5842dbdec58), poloskov2004:B.6
    (sha256 44044af9cd3e).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import moment_of_amplitude
    >>> f"{moment_of_amplitude(1.6, 0.4, 0.6, 1.17):.6g}"
    '0.350571'
    """
    t1 = (1.0 / 2.0) * m
    t2 = 2.0 * gamma
    t3 = alpha + t2
    t4 = t2 - alpha
    t18 = gamma_ratio((1.0 / 3.0) * (t3 * t4) / (alpha * alpha), -t1) * (math.pow(2.0 * beta / (math.sqrt(t3) * math.sqrt(t4)), m) * gamma_ratio(1.0, t1))
    return t18


@kernel(
    paths.moment_of_frequency,
    Specification(
        paper='poloskov2004',
        name='moment_of_frequency',
        says="The mean of |Omega|^m; gamma() is Euler's function.",
        arguments=(
            Argument('m', 'order of the moment', low='0', high='8', closed=True),
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
            Argument('g_23', 'intensity of the additive noise of axis 3', unit='rad s^(-3/2)', low='0'),
            Argument('d_33', 'coefficient of dissipation', unit='1/s', low='m*g_13**2/2*(1 + 1e-9)'),
        ),
        outputs=(
            Output('M_Omega', 'absolute moment', unit='(rad/s)^m'),
        ),
        ulp=16,
        condition='The ulp are those of the value times its condition number, (2 + m) (1 + log(1 + m)) delta/(delta - m/2) with delta = d_33/g_13^2.',
        degenerate='Beyond the domain the moment is infinite, and the formula means nothing.',
        claims={
            'poloskov2004:4.0.11': 'b4ce7a1bf72c',
            'poloskov2004:B.5': '3a5d29509c0e',
            'poloskov2004:B.7': '17993c9067b8',
        },
    ),
)
def moment_of_frequency(m, k, g_13, g_23, d_33):
    """The mean of |Omega|^m; gamma() is Euler's function.

    Parameters
    ----------
    m : float or ndarray
        Order of the moment, a number; 0 <= m <= 8.
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    g_23 : float or ndarray
        Intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23.
    d_33 : float or ndarray
        Coefficient of dissipation, in 1/s; m*g_13**2/2*(1 + 1e-9) < d_33.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    M_Omega : float or ndarray
        Absolute moment, in (rad/s)^m.

    Notes
    -----
    The function computes ::

        M_Omega = gamma(m/2 + 1/2)*gamma(d_33/g_13**2 - m/2)/(sqrt(pi)*(g_13**2/(g_23**2*k**2))**(m/2)*gamma(d_33/g_13**2))

    Accuracy: 16 ulp over the domain. The ulp are those of the value times its condition number, (2 + m) (1 +
    log(1 + m)) delta/(delta - m/2) with delta = d_33/g_13^2. Beyond the domain the moment is infinite, and the
    formula means nothing.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:4.0.11 (sha256 b4ce7a1bf72c), poloskov2004:B.5 (sha256 3a5d29509c0e), poloskov2004:B.7
    (sha256 17993c9067b8).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import moment_of_frequency
    >>> f"{moment_of_frequency(1.33, 0.33, 0.5, 0.67, 1.0):.6g}"
    '0.0820577'
    """
    t1 = (1.0 / 2.0) * m
    t11 = math.pow(g_23 * k / math.sqrt(d_33), m) * gamma_ratio(1.0, t1 - (1.0 / 2.0)) * gamma_ratio(d_33 / (g_13 * g_13), -t1)
    return t11 / math.sqrt(math.pi)


@kernel(
    paths.mean_square_of_amplitude,
    Specification(
        paper='poloskov2004',
        name='mean_square_of_amplitude',
        says='The mean of a^2.',
        arguments=(
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='alpha'),
        ),
        outputs=(
            Output('S_a', 'mean square of a', unit='rad^2/s^2'),
        ),
        ulp=4,
        degenerate='Beyond the domain it is infinite, and the formula means nothing.',
        claims={
            'poloskov2004:4.0.9': '2103dcf0e4fd',
            'poloskov2004:B.8': 'd9698f4ddfc7',
        },
    ),
)
def mean_square_of_amplitude(alpha, beta, gamma):
    """The mean of a^2.

    Parameters
    ----------
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha < gamma.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    S_a : float or ndarray
        Mean square of a, in rad^2/s^2.

    Notes
    -----
    The function computes ::

        S_a = -beta**2/((alpha - gamma)*(alpha + gamma))

    Accuracy: 4 ulp over the domain. Beyond the domain it is infinite, and the formula means nothing.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:4.0.9 (sha256 2103dcf0e4fd), poloskov2004:B.8 (sha256 d9698f4ddfc7).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import mean_square_of_amplitude
    >>> f"{mean_square_of_amplitude(0.25, 0.5, 1.0):.6g}"
    '0.266667'
    """
    return -(beta * beta / ((alpha + gamma) * (alpha - gamma)))


@kernel(
    paths.mean_square_of_frequency,
    Specification(
        paper='poloskov2004',
        name='mean_square_of_frequency',
        says='The mean of Omega^2.',
        arguments=(
            Argument('k', '(A - C)/A, of the moments of inertia A, A, C', low='0'),
            Argument('g_13', 'intensity of the multiplicative noise of axis 3', unit='s^(-1/2)', low='0'),
            Argument('g_23', 'intensity of the additive noise of axis 3', unit='rad s^(-3/2)', low='0'),
            Argument('d_33', 'coefficient of dissipation', unit='1/s', low='g_13**2'),
        ),
        outputs=(
            Output('S_Omega', 'mean square of Omega', unit='rad^2/s^2'),
        ),
        ulp=4,
        condition='The ulp are those of the value times its condition number, (d_33 + g_13^2)/|d_33 - g_13^2|, as g_13^2 is rounded.',
        degenerate='Beyond the domain it is infinite, and the formula means nothing.',
        claims={
            'poloskov2004:4.0.11': 'b4ce7a1bf72c',
            'poloskov2004:B.8': 'd9698f4ddfc7',
        },
    ),
)
def mean_square_of_frequency(k, g_13, g_23, d_33):
    """The mean of Omega^2.

    Parameters
    ----------
    k : float or ndarray
        (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k.
    g_13 : float or ndarray
        Intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13.
    g_23 : float or ndarray
        Intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23.
    d_33 : float or ndarray
        Coefficient of dissipation, in 1/s; g_13**2 < d_33.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    S_Omega : float or ndarray
        Mean square of Omega, in rad^2/s^2.

    Notes
    -----
    The function computes ::

        S_Omega = g_23**2*k**2/(2*(d_33 - g_13**2))

    Accuracy: 4 ulp over the domain. The ulp are those of the value times its condition number, (d_33 +
    g_13^2)/|d_33 - g_13^2|, as g_13^2 is rounded. Beyond the domain it is infinite, and the formula means
    nothing.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:4.0.11 (sha256 b4ce7a1bf72c), poloskov2004:B.8 (sha256 d9698f4ddfc7).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import mean_square_of_frequency
    >>> f"{mean_square_of_frequency(0.2, 0.4, 0.6, 0.96):.6g}"
    '0.009'
    """
    return (1.0 / 2.0) * (g_23 * g_23 * (k * k)) / (d_33 - g_13 * g_13)


@kernel(
    paths.mode_of_amplitude,
    Specification(
        paper='poloskov2004',
        name='mode_of_amplitude',
        says='The most probable amplitude, where the density is largest; that of the frequency is 0.',
        arguments=(
            Argument('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', unit='s^(-1/2)', low='0'),
            Argument('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', unit='rad s^(-3/2)', low='0'),
            Argument('gamma', 'dissipation, gamma^2 = d_11 + d_22', unit='s^(-1/2)', low='0'),
        ),
        outputs=(
            Output('a_star', 'mode of a', unit='rad/s'),
        ),
        ulp=4,
        claims={
            'poloskov2004:4.0.13': '7089048da9b5',
            'poloskov2004:4.0.14': '6193d8c6bbde',
            'poloskov2004:4.0.15': 'b03164dba5cf',
        },
    ),
)
def mode_of_amplitude(alpha, beta, gamma):
    """The most probable amplitude, where the density is largest; that of the frequency is 0.

    Parameters
    ----------
    alpha : float or ndarray
        Multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha.
    beta : float or ndarray
        Additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta.
    gamma : float or ndarray
        dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); 0 < gamma.
    out : ndarray, optional
        Array for the results, of the broadcast shape and type.

    Returns
    -------
    a_star : float or ndarray
        Mode of a, in rad/s.

    Notes
    -----
    The function computes ::

        a_star = 2*beta/sqrt(alpha**2 + 8*gamma**2)

    Accuracy: 4 ulp over the domain.

    Arguments broadcast. Floats give floats; arrays give float64, or float32 if all of them are. NaN inputs give
    NaN outputs. A ValueError names what does not broadcast, and an `out` that does not fit.

    Rests on poloskov2004:4.0.13 (sha256 7089048da9b5), poloskov2004:4.0.14 (sha256 6193d8c6bbde),
    poloskov2004:4.0.15 (sha256 b03164dba5cf).

    Examples
    --------
    >>> from symcheck.generated.poloskov2004 import mode_of_amplitude
    >>> f"{mode_of_amplitude(0.25, 0.5, 0.75):.6g}"
    '0.468165'
    """
    return 2.0 * beta / math.sqrt(alpha * alpha + 8.0 * (gamma * gamma))


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
