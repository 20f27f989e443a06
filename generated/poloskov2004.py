"""Kernels of poloskov2004. Written by `symcheck generate`: what is changed here is lost."""

import math

from numpy import add, cos, divide, exp, expm1, log, log1p, multiply, negative, power, sin, sqrt, subtract, array, ndarray

from symcheck.kernels.ratios import expm1_ratio, gamma_ratio, log1p_ratio
from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, evaluate, evaluate_alike, evaluate_handful

__all__ = ["averaged_diffusion", "averaged_drift", "density_of_amplitude", "density_of_frequency", "diffusion_coefficients", "distribution_of_amplitude", "drift_coefficients", "logarithm_of_constant_of_amplitude", "logarithm_of_constant_of_frequency", "mean_square_of_amplitude", "mean_square_of_frequency", "mode_of_amplitude", "moment_of_amplitude", "moment_of_frequency", "noise_intensities", "quantile_of_amplitude", "stratonovich_drift"]

DECLARED = {  # name, meaning and unit of the arguments and of the results; docstrings may be stripped
    'stratonovich_drift': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('psi', 'phase', 'rad'),
            ('Omega', 'frequency k x_3', 'rad/s'),
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('varepsilon', 'small parameter of the torques', '1'),
            ('d_11', 'coefficient of dissipation', '1/s'),
            ('d_12', 'coefficient of dissipation', '1/s'),
            ('d_13', 'coefficient of dissipation', '1/s'),
            ('d_21', 'coefficient of dissipation', '1/s'),
            ('d_22', 'coefficient of dissipation', '1/s'),
            ('d_23', 'coefficient of dissipation', '1/s'),
            ('d_31', 'coefficient of dissipation', '1/s'),
            ('d_32', 'coefficient of dissipation', '1/s'),
            ('d_33', 'coefficient of dissipation', '1/s'),
        ),
        (
            ('v_1', 'drift of a', 'rad/s^2'),
            ('v_2', 'drift of theta', 'rad/s'),
            ('v_3', 'drift of Omega', 'rad/s^2'),
        ),
    ),
    'noise_intensities': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('psi', 'phase', 'rad'),
            ('Omega', 'frequency k x_3', 'rad/s'),
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('varepsilon', 'small parameter of the torques', '1'),
            ('g_11', 'intensity of the multiplicative noise of axis 1', 's^(-1/2)'),
            ('g_12', 'intensity of the multiplicative noise of axis 2', 's^(-1/2)'),
            ('g_21', 'intensity of the additive noise of axis 1', 'rad s^(-3/2)'),
            ('g_22', 'intensity of the additive noise of axis 2', 'rad s^(-3/2)'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
            ('g_23', 'intensity of the additive noise of axis 3', 'rad s^(-3/2)'),
        ),
        (
            ('h_11', 'intensity of noise 1 in a', '1'),
            ('h_12', 'intensity of noise 2 in a', '1'),
            ('h_14', 'intensity of noise 4 in a', '1'),
            ('h_15', 'intensity of noise 5 in a', '1'),
            ('h_21', 'intensity of noise 1 in theta', '1'),
            ('h_22', 'intensity of noise 2 in theta', '1'),
            ('h_24', 'intensity of noise 4 in theta', '1'),
            ('h_25', 'intensity of noise 5 in theta', '1'),
            ('h_33', 'intensity of noise 3 in Omega', '1'),
            ('h_36', 'intensity of noise 6 in Omega', '1'),
        ),
    ),
    'drift_coefficients': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('psi', 'phase', 'rad'),
            ('Omega', 'frequency k x_3', 'rad/s'),
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('varepsilon', 'small parameter of the torques', '1'),
            ('d_11', 'coefficient of dissipation', '1/s'),
            ('d_12', 'coefficient of dissipation', '1/s'),
            ('d_13', 'coefficient of dissipation', '1/s'),
            ('d_21', 'coefficient of dissipation', '1/s'),
            ('d_22', 'coefficient of dissipation', '1/s'),
            ('d_23', 'coefficient of dissipation', '1/s'),
            ('d_31', 'coefficient of dissipation', '1/s'),
            ('d_32', 'coefficient of dissipation', '1/s'),
            ('d_33', 'coefficient of dissipation', '1/s'),
            ('g_11', 'intensity of the multiplicative noise of axis 1', 's^(-1/2)'),
            ('g_12', 'intensity of the multiplicative noise of axis 2', 's^(-1/2)'),
            ('g_21', 'intensity of the additive noise of axis 1', 'rad s^(-3/2)'),
            ('g_22', 'intensity of the additive noise of axis 2', 'rad s^(-3/2)'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
        ),
        (
            ('K_1', 'drift of a', 'rad/s^2'),
            ('K_2', 'drift of theta', 'rad/s'),
            ('K_3', 'drift of Omega', 'rad/s^2'),
        ),
    ),
    'diffusion_coefficients': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('psi', 'phase', 'rad'),
            ('Omega', 'frequency k x_3', 'rad/s'),
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('varepsilon', 'small parameter of the torques', '1'),
            ('g_11', 'intensity of the multiplicative noise of axis 1', 's^(-1/2)'),
            ('g_12', 'intensity of the multiplicative noise of axis 2', 's^(-1/2)'),
            ('g_21', 'intensity of the additive noise of axis 1', 'rad s^(-3/2)'),
            ('g_22', 'intensity of the additive noise of axis 2', 'rad s^(-3/2)'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
            ('g_23', 'intensity of the additive noise of axis 3', 'rad s^(-3/2)'),
        ),
        (
            ('K_11', 'diffusion of a', 'rad^2/s^3'),
            ('K_12', 'diffusion of a and theta', 'rad^2/s^2'),
            ('K_22', 'diffusion of theta', 'rad^2/s'),
            ('K_33', 'diffusion of Omega', 'rad^2/s^3'),
        ),
    ),
    'averaged_drift': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('Omega', 'frequency k x_3', 'rad/s'),
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
            ('d_12', 'coefficient of dissipation', '1/s'),
            ('d_21', 'coefficient of dissipation', '1/s'),
            ('d_33', 'coefficient of dissipation', '1/s'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
        ),
        (
            ('Kbar_1', 'drift of a', 'rad/s^2'),
            ('Kbar_2', 'drift of theta', 'rad/s'),
            ('Kbar_3', 'drift of Omega', 'rad/s^2'),
        ),
    ),
    'averaged_diffusion': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('Omega', 'frequency k x_3', 'rad/s'),
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
            ('g_23', 'intensity of the additive noise of axis 3', 'rad s^(-3/2)'),
        ),
        (
            ('Kbar_11', 'diffusion of a', 'rad^2/s^3'),
            ('Kbar_22', 'diffusion of theta', 'rad^2/s'),
            ('Kbar_33', 'diffusion of Omega', 'rad^2/s^3'),
        ),
    ),
    'density_of_amplitude': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
        ),
        (
            ('p_s1', 'density of a', 's/rad'),
        ),
    ),
    'density_of_frequency': (
        (
            ('Omega', 'frequency k x_3', 'rad/s'),
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
            ('g_23', 'intensity of the additive noise of axis 3', 'rad s^(-3/2)'),
            ('d_33', 'coefficient of dissipation', '1/s'),
        ),
        (
            ('p_s3', 'density of Omega', 's/rad'),
        ),
    ),
    'logarithm_of_constant_of_amplitude': (
        (
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
        ),
        (
            ('log_C_1', 'log C_1', '1'),
        ),
    ),
    'logarithm_of_constant_of_frequency': (
        (
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
            ('g_23', 'intensity of the additive noise of axis 3', 'rad s^(-3/2)'),
            ('d_33', 'coefficient of dissipation', '1/s'),
        ),
        (
            ('log_C_2', 'log C_2', '1'),
        ),
    ),
    'distribution_of_amplitude': (
        (
            ('a', 'amplitude of the equatorial angular velocity', 'rad/s'),
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
        ),
        (
            ('F', 'probability', '1'),
        ),
    ),
    'quantile_of_amplitude': (
        (
            ('q', 'probability', '1'),
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
        ),
        (
            ('a_q', 'quantile of a', 'rad/s'),
        ),
    ),
    'moment_of_amplitude': (
        (
            ('m', 'order of the moment', '1'),
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
        ),
        (
            ('M_a', 'moment', '(rad/s)^m'),
        ),
    ),
    'moment_of_frequency': (
        (
            ('m', 'order of the moment', '1'),
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
            ('g_23', 'intensity of the additive noise of axis 3', 'rad s^(-3/2)'),
            ('d_33', 'coefficient of dissipation', '1/s'),
        ),
        (
            ('M_Omega', 'absolute moment', '(rad/s)^m'),
        ),
    ),
    'mean_square_of_amplitude': (
        (
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
        ),
        (
            ('S_a', 'mean square of a', 'rad^2/s^2'),
        ),
    ),
    'mean_square_of_frequency': (
        (
            ('k', '(A - C)/A, of the moments of inertia A, A, C', '1'),
            ('g_13', 'intensity of the multiplicative noise of axis 3', 's^(-1/2)'),
            ('g_23', 'intensity of the additive noise of axis 3', 'rad s^(-3/2)'),
            ('d_33', 'coefficient of dissipation', '1/s'),
        ),
        (
            ('S_Omega', 'mean square of Omega', 'rad^2/s^2'),
        ),
    ),
    'mode_of_amplitude': (
        (
            ('alpha', 'multiplicative noise, alpha^2 = g_11^2 + g_12^2', 's^(-1/2)'),
            ('beta', 'additive noise, beta^2 = g_21^2 + g_22^2', 'rad s^(-3/2)'),
            ('gamma', 'dissipation, gamma^2 = d_11 + d_22', 's^(-1/2)'),
        ),
        (
            ('a_star', 'mode of a', 'rad/s'),
        ),
    ),
}


def stratonovich_drift(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, out=None):
    """Drift of amplitude, phase and frequency in Stratonovich's sense.

        v_1 = varepsilon*(-Omega*d_13*cos(psi)/k + Omega*d_23*sin(psi)/k + a*(-d_11*cos(psi)**2 + d_12*sin(psi)*cos(psi) + d_21*sin(psi)*cos(psi) - d_22*sin(psi)**2))
        v_2 = varepsilon*(Omega*(d_13*sin(psi) + d_23*cos(psi))/(a*k) + d_11*sin(psi)*cos(psi) - d_12*sin(psi)**2 + d_21*cos(psi)**2 - d_22*sin(psi)*cos(psi))
        v_3 = varepsilon*(-Omega*d_33 + a*k*(-d_31*cos(psi) + d_32*sin(psi)))

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        psi: phase, in rad; any number
        Omega: frequency k x_3, in rad/s; any number
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        varepsilon: small parameter of the torques, a number; 0 < varepsilon
        d_11: coefficient of dissipation, in 1/s; 0 < d_11
        d_12: coefficient of dissipation, in 1/s; 0 < d_12
        d_13: coefficient of dissipation, in 1/s; 0 < d_13
        d_21: coefficient of dissipation, in 1/s; 0 < d_21
        d_22: coefficient of dissipation, in 1/s; 0 < d_22
        d_23: coefficient of dissipation, in 1/s; 0 < d_23
        d_31: coefficient of dissipation, in 1/s; 0 < d_31
        d_32: coefficient of dissipation, in 1/s; 0 < d_32
        d_33: coefficient of dissipation, in 1/s; 0 < d_33

    Returns a tuple:
        v_1: drift of a, in rad/s^2
        v_2: drift of theta, in rad/s
        v_3: drift of Omega, in rad/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 6 ulp over the domain. These are sums with zeros inside the domain: the ulp are those of the largest
    addend.

    Rests on poloskov2004:2.4 (sha256 5d05a5afbfdd), poloskov2004:2.4.2 (sha256 70ba75a388cd).
    """
    if out is None:
        try:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33):
                return _stratonovich_drift(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33)
            if ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is d_11.dtype is d_12.dtype is d_13.dtype is d_21.dtype is d_22.dtype is d_23.dtype is d_31.dtype is d_32.dtype is d_33.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == d_11.shape == d_12.shape == d_13.shape == d_21.shape == d_22.shape == d_23.shape == d_31.shape == d_32.shape == d_33.shape:
                size = a.size
                if 0 < size <= 10:
                    return evaluate_handful(_stratonovich_drift, (a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33,))
                if size <= SMALL:
                    return _stratonovich_drift_block(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33)
                return evaluate_alike(_stratonovich_drift_block, 10, (0, 1, 2,), (a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_stratonovich_drift_block, 10, (0, 1, 2,), (a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33,), out)


def _stratonovich_drift(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33):
    sin_psi = math.sin(psi)
    t1 = Omega / k
    cos_psi = math.cos(psi)
    cos_psi_squared = cos_psi * cos_psi
    sin_psi_squared = sin_psi * sin_psi
    t2 = cos_psi * sin_psi
    t15 = (a * ((((d_12 * t2) + (d_21 * t2)) - (cos_psi_squared * d_11)) - (d_22 * sin_psi_squared))) + (d_23 * (sin_psi * t1))
    t28 = ((t1 * ((d_13 * sin_psi) + (cos_psi * d_23))) / a) + ((d_11 * t2) + (cos_psi_squared * d_21))
    return (t15 - (d_13 * (cos_psi * t1))) * varepsilon, ((t28 - (d_12 * sin_psi_squared)) - (d_22 * t2)) * varepsilon, ((((d_32 * sin_psi) - (cos_psi * d_31)) * (a * k)) - (Omega * d_33)) * varepsilon


def _stratonovich_drift_block(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, out_v_1=None, out_v_2=None, out_v_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None):
    r0 = sin(psi, r0)  # sin_psi
    r1 = divide(Omega, k, r1)  # t1
    r2 = cos(psi, r2)  # cos_psi
    r3 = multiply(r2, r2, r3)  # cos_psi_squared
    r4 = multiply(r0, r0, r4)  # sin_psi_squared
    r5 = multiply(r2, r0, r5)  # t2
    r6 = multiply(r3, d_11, r6)  # t3
    r7 = multiply(d_12, r5, r7)  # t4
    r8 = multiply(d_21, r5, r8)  # t5
    r9 = multiply(d_22, r4, r9)  # t6
    r8 = add(r7, r8, r8)  # t7
    r6 = subtract(r8, r6, r6)  # t8
    r9 = subtract(r6, r9, r9)  # t9
    r9 = multiply(a, r9, r9)  # t10
    r6 = multiply(r2, r1, r6)  # t11
    r6 = multiply(d_13, r6, r6)  # t12
    r8 = multiply(r0, r1, r8)  # t13
    r8 = multiply(d_23, r8, r8)  # t14
    r8 = add(r9, r8, r8)  # t15
    r6 = subtract(r8, r6, r6)  # t16
    out_v_1 = multiply(r6, varepsilon, out_v_1)  # t17
    r6 = multiply(d_11, r5, r6)  # t18
    r4 = multiply(d_12, r4, r4)  # t19
    r3 = multiply(r3, d_21, r3)  # t20
    r5 = multiply(d_22, r5, r5)  # t21
    r8 = multiply(d_13, r0, r8)  # t22
    r9 = multiply(r2, d_23, r9)  # t23
    r9 = add(r8, r9, r9)  # t24
    r9 = multiply(r1, r9, r9)  # t25
    r9 = divide(r9, a, r9)  # t26
    r3 = add(r6, r3, r3)  # t27
    r3 = add(r9, r3, r3)  # t28
    r4 = subtract(r3, r4, r4)  # t29
    r5 = subtract(r4, r5, r5)  # t30
    out_v_2 = multiply(r5, varepsilon, out_v_2)  # t31
    r5 = multiply(Omega, d_33, r5)  # t32
    r2 = multiply(r2, d_31, r2)  # t33
    r0 = multiply(d_32, r0, r0)  # t34
    r2 = subtract(r0, r2, r2)  # t35
    r0 = multiply(a, k, r0)  # t36
    r0 = multiply(r2, r0, r0)  # t37
    r5 = subtract(r0, r5, r5)  # t38
    out_v_3 = multiply(r5, varepsilon, out_v_3)  # t39
    return out_v_1, out_v_2, out_v_3


def noise_intensities(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out=None):
    """Intensities of the noises in amplitude, phase and frequency; h_13, h_16, h_23, h_26, h_31, h_32, h_34, h_35 are 0.

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

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        psi: phase, in rad; any number
        Omega: frequency k x_3, in rad/s; any number
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        varepsilon: small parameter of the torques, a number; 0 < varepsilon
        g_11: intensity of the multiplicative noise of axis 1, in s^(-1/2); 0 < g_11
        g_12: intensity of the multiplicative noise of axis 2, in s^(-1/2); 0 < g_12
        g_21: intensity of the additive noise of axis 1, in rad s^(-3/2); 0 < g_21
        g_22: intensity of the additive noise of axis 2, in rad s^(-3/2); 0 < g_22
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13
        g_23: intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23

    Returns a tuple:
        h_11: intensity of noise 1 in a, a number
        h_12: intensity of noise 2 in a, a number
        h_14: intensity of noise 4 in a, a number
        h_15: intensity of noise 5 in a, a number
        h_21: intensity of noise 1 in theta, a number
        h_22: intensity of noise 2 in theta, a number
        h_24: intensity of noise 4 in theta, a number
        h_25: intensity of noise 5 in theta, a number
        h_33: intensity of noise 3 in Omega, a number
        h_36: intensity of noise 6 in Omega, a number

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 10 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 5 ulp over the domain. In squares the last place of a sine or cosine counts twice.

    Rests on poloskov2004:2.4.5b (sha256 0fb70605bfb3), poloskov2004:2.4.6 (sha256 a2427fbe7674).
    """
    if out is None:
        try:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23):
                return _noise_intensities(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
            if ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is g_11.dtype is g_12.dtype is g_21.dtype is g_22.dtype is g_13.dtype is g_23.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == g_11.shape == g_12.shape == g_21.shape == g_22.shape == g_13.shape == g_23.shape:
                size = a.size
                if 0 < size <= 2:
                    return evaluate_handful(_noise_intensities, (a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,))
                if size <= SMALL:
                    return _noise_intensities_block(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
                return evaluate_alike(_noise_intensities_block, 9, (0, 1, 2, 3, 4, 5, 6, 7, 8, 9,), (a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_noise_intensities_block, 9, (0, 1, 2, 3, 4, 5, 6, 7, 8, 9,), (a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,), out)


def _noise_intensities(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23):
    cos_psi = math.cos(psi)
    sqrt_varepsilon = math.sqrt(varepsilon)
    t1 = a * sqrt_varepsilon
    sin_psi = math.sin(psi)
    t2 = cos_psi * sqrt_varepsilon
    t3 = sin_psi * sqrt_varepsilon
    t4 = sin_psi * t2
    t5 = 1.0 / a
    return (cos_psi * cos_psi) * (g_11 * t1), (sin_psi * sin_psi) * (g_12 * t1), g_21 * t2, -(g_22 * t3), -(g_11 * t4), g_12 * t4, -(g_21 * (t3 * t5)), -(g_22 * (t2 * t5)), g_13 * (Omega * sqrt_varepsilon), k * (g_23 * sqrt_varepsilon)


def _noise_intensities_block(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out_h_11=None, out_h_12=None, out_h_14=None, out_h_15=None, out_h_21=None, out_h_22=None, out_h_24=None, out_h_25=None, out_h_33=None, out_h_36=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, n1=array(1.0)):
    r0 = cos(psi, r0)  # cos_psi
    r1 = sqrt(varepsilon, r1)  # sqrt_varepsilon
    r2 = multiply(a, r1, r2)  # t1
    r3 = sin(psi, r3)  # sin_psi
    r4 = multiply(r0, r1, r4)  # t2
    r5 = multiply(r3, r1, r5)  # t3
    r6 = multiply(r3, r4, r6)  # t4
    r7 = divide(n1, a, r7)  # t5
    r0 = multiply(r0, r0, r0)  # cos_psi_squared
    r8 = multiply(g_11, r2, r8)  # t6
    out_h_11 = multiply(r0, r8, out_h_11)  # t7
    r3 = multiply(r3, r3, r3)  # sin_psi_squared
    r2 = multiply(g_12, r2, r2)  # t8
    out_h_12 = multiply(r3, r2, out_h_12)  # t9
    out_h_14 = multiply(g_21, r4, out_h_14)  # t10
    r2 = multiply(g_22, r5, r2)  # t11
    out_h_15 = negative(r2, out_h_15)  # t12
    r2 = multiply(g_11, r6, r2)  # t13
    out_h_21 = negative(r2, out_h_21)  # t14
    out_h_22 = multiply(g_12, r6, out_h_22)  # t15
    r5 = multiply(r5, r7, r5)  # t16
    r5 = multiply(g_21, r5, r5)  # t17
    out_h_24 = negative(r5, out_h_24)  # t18
    r7 = multiply(r4, r7, r7)  # t19
    r7 = multiply(g_22, r7, r7)  # t20
    out_h_25 = negative(r7, out_h_25)  # t21
    r7 = multiply(Omega, r1, r7)  # t22
    out_h_33 = multiply(g_13, r7, out_h_33)  # t23
    r1 = multiply(g_23, r1, r1)  # t24
    out_h_36 = multiply(k, r1, out_h_36)  # t25
    return out_h_11, out_h_12, out_h_14, out_h_15, out_h_21, out_h_22, out_h_24, out_h_25, out_h_33, out_h_36


def drift_coefficients(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13, out=None):
    """Drift coefficients of the Fokker-Planck-Kolmogorov equation for amplitude, phase and frequency.

        K_1 = varepsilon*(-Omega*d_13*cos(psi)/k + Omega*d_23*sin(psi)/k + a*(-2*d_11*cos(psi)**2 + 2*d_12*sin(psi)*cos(psi) + 2*d_21*sin(psi)*cos(psi) - 2*d_22*sin(psi)**2 + 2*g_11**2*sin(psi)**2*cos(psi)**2 + g_11**2*cos(psi)**4 + g_12**2*sin(psi)**4 + 2*g_12**2*sin(psi)**2*cos(psi)**2)/2 + (g_21**2*sin(psi)**2 + g_22**2*cos(psi)**2)/(2*a))
        K_2 = varepsilon*(Omega*(d_13*sin(psi) + d_23*cos(psi))/(a*k) + d_11*sin(psi)*cos(psi) - d_12*sin(psi)**2 + d_21*cos(psi)**2 - d_22*sin(psi)*cos(psi) - g_11**2*sin(psi)**3*cos(psi)/2 + g_11**2*sin(psi)*cos(psi)**3/2 - g_12**2*sin(psi)**3*cos(psi)/2 + g_12**2*sin(psi)*cos(psi)**3/2 + (g_21**2 - g_22**2)*sin(psi)*cos(psi)/a**2)
        K_3 = varepsilon*(-Omega*d_33 + Omega*g_13**2/2 + a*k*(-d_31*cos(psi) + d_32*sin(psi)))

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        psi: phase, in rad; any number
        Omega: frequency k x_3, in rad/s; any number
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        varepsilon: small parameter of the torques, a number; 0 < varepsilon
        d_11: coefficient of dissipation, in 1/s; 0 < d_11
        d_12: coefficient of dissipation, in 1/s; 0 < d_12
        d_13: coefficient of dissipation, in 1/s; 0 < d_13
        d_21: coefficient of dissipation, in 1/s; 0 < d_21
        d_22: coefficient of dissipation, in 1/s; 0 < d_22
        d_23: coefficient of dissipation, in 1/s; 0 < d_23
        d_31: coefficient of dissipation, in 1/s; 0 < d_31
        d_32: coefficient of dissipation, in 1/s; 0 < d_32
        d_33: coefficient of dissipation, in 1/s; 0 < d_33
        g_11: intensity of the multiplicative noise of axis 1, in s^(-1/2); 0 < g_11
        g_12: intensity of the multiplicative noise of axis 2, in s^(-1/2); 0 < g_12
        g_21: intensity of the additive noise of axis 1, in rad s^(-3/2); 0 < g_21
        g_22: intensity of the additive noise of axis 2, in rad s^(-3/2); 0 < g_22
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13

    Returns a tuple:
        K_1: drift of a, in rad/s^2
        K_2: drift of theta, in rad/s
        K_3: drift of Omega, in rad/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. These are sums with zeros inside the domain: the ulp are those of the largest
    addend.

    Rests on poloskov2004:3.1.2 (sha256 5273a157bf0d), poloskov2004:3.2.1 (sha256 3ac5751244d0).
    """
    if out is None:
        try:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13):
                return _drift_coefficients(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13)
            if ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(d_11) is type(d_12) is type(d_13) is type(d_21) is type(d_22) is type(d_23) is type(d_31) is type(d_32) is type(d_33) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is d_11.dtype is d_12.dtype is d_13.dtype is d_21.dtype is d_22.dtype is d_23.dtype is d_31.dtype is d_32.dtype is d_33.dtype is g_11.dtype is g_12.dtype is g_21.dtype is g_22.dtype is g_13.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == d_11.shape == d_12.shape == d_13.shape == d_21.shape == d_22.shape == d_23.shape == d_31.shape == d_32.shape == d_33.shape == g_11.shape == g_12.shape == g_21.shape == g_22.shape == g_13.shape:
                size = a.size
                if 0 < size <= 17:
                    return evaluate_handful(_drift_coefficients, (a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13,))
                if size <= SMALL:
                    return _drift_coefficients_block(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13)
                return evaluate_alike(_drift_coefficients_block, 23, (0, 1, 2,), (a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_drift_coefficients_block, 23, (0, 1, 2,), (a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13,), out)


def _drift_coefficients(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13):
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
    t24 = (g_11_squared * t6) + ((g_12_squared * (sin_psi_squared * sin_psi_squared)) + ((d_12 * t5) + (d_21 * t5)))
    t27 = ((g_12_squared * t6) + (((cos_psi_squared * cos_psi_squared) * g_11_squared) + t24)) - (d_11 * t3)
    t41 = ((1.0 / 2.0) * (t2 * ((g_21_squared * sin_psi_squared) + (cos_psi_squared * g_22_squared)))) + (((1.0 / 2.0) * (a * (t27 - (2.0 * (d_22 * sin_psi_squared))))) + (d_23 * (sin_psi * t1)))
    t61 = (((d_13 * sin_psi) + (cos_psi * d_23)) * (t1 * t2)) + ((d_11 * t4) + (cos_psi_squared * d_21))
    t65 = (((t4 * (g_21_squared - g_22_squared)) / (a * a)) + ((t12 * t9) + ((t7 * t9) + t61))) - (d_12 * sin_psi_squared)
    t78 = ((1.0 / 2.0) * (Omega * (g_13 * g_13))) + (((d_32 * sin_psi) - (cos_psi * d_31)) * (a * k))
    return (t41 - (d_13 * (cos_psi * t1))) * varepsilon, (((t65 - (d_22 * t4)) - (t11 * t7)) - (t11 * t12)) * varepsilon, (t78 - (Omega * d_33)) * varepsilon


def _drift_coefficients_block(a, psi, Omega, k, varepsilon, d_11, d_12, d_13, d_21, d_22, d_23, d_31, d_32, d_33, g_11, g_12, g_21, g_22, g_13, out_K_1=None, out_K_2=None, out_K_3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None, r13=None, r14=None, r15=None, r16=None, r17=None, r18=None, r19=None, r20=None, r21=None, r22=None, n1=array(1.0), n2=array(2.0), n1_2=array(1.0 / 2.0)):
    r0 = sin(psi, r0)  # sin_psi
    r1 = divide(Omega, k, r1)  # t1
    r2 = cos(psi, r2)  # cos_psi
    r3 = divide(n1, a, r3)  # t2
    r4 = multiply(g_21, g_21, r4)  # g_21_squared
    r5 = multiply(r0, r0, r5)  # sin_psi_squared
    r6 = multiply(g_22, g_22, r6)  # g_22_squared
    r7 = multiply(r2, r2, r7)  # cos_psi_squared
    r8 = multiply(n2, r7, r8)  # t3
    r9 = multiply(r2, r0, r9)  # t4
    r10 = multiply(n2, r9, r10)  # t5
    r11 = multiply(g_11, g_11, r11)  # g_11_squared
    r12 = multiply(g_12, g_12, r12)  # g_12_squared
    r13 = multiply(r5, r8, r13)  # t6
    r14 = multiply(n1_2, r11, r14)  # t7
    r15 = multiply(r2, r7, r15)  # t8
    r15 = multiply(r0, r15, r15)  # t9
    r16 = multiply(r0, r5, r16)  # t10
    r16 = multiply(r2, r16, r16)  # t11
    r17 = multiply(n1_2, r12, r17)  # t12
    r8 = multiply(d_11, r8, r8)  # t13
    r18 = multiply(d_12, r10, r18)  # t14
    r10 = multiply(d_21, r10, r10)  # t15
    r19 = multiply(d_22, r5, r19)  # t16
    r19 = multiply(n2, r19, r19)  # t17
    r20 = multiply(r5, r5, r20)  # sin_psi_squared_squared
    r20 = multiply(r12, r20, r20)  # t18
    r21 = multiply(r11, r13, r21)  # t19
    r22 = multiply(r7, r7, r22)  # cos_psi_squared_squared
    r11 = multiply(r22, r11, r11)  # t20
    r13 = multiply(r12, r13, r13)  # t21
    r10 = add(r18, r10, r10)  # t22
    r10 = add(r20, r10, r10)  # t23
    r10 = add(r21, r10, r10)  # t24
    r10 = add(r11, r10, r10)  # t25
    r10 = add(r13, r10, r10)  # t26
    r8 = subtract(r10, r8, r8)  # t27
    r19 = subtract(r8, r19, r19)  # t28
    r19 = multiply(a, r19, r19)  # t29
    r19 = multiply(n1_2, r19, r19)  # t30
    r8 = multiply(r2, r1, r8)  # t31
    r8 = multiply(d_13, r8, r8)  # t32
    r10 = multiply(r0, r1, r10)  # t33
    r10 = multiply(d_23, r10, r10)  # t34
    r13 = multiply(r4, r5, r13)  # t35
    r11 = multiply(r7, r6, r11)  # t36
    r11 = add(r13, r11, r11)  # t37
    r11 = multiply(r3, r11, r11)  # t38
    r11 = multiply(n1_2, r11, r11)  # t39
    r10 = add(r19, r10, r10)  # t40
    r10 = add(r11, r10, r10)  # t41
    r8 = subtract(r10, r8, r8)  # t42
    out_K_1 = multiply(r8, varepsilon, out_K_1)  # t43
    r8 = multiply(d_11, r9, r8)  # t44
    r5 = multiply(d_12, r5, r5)  # t45
    r7 = multiply(r7, d_21, r7)  # t46
    r10 = multiply(d_22, r9, r10)  # t47
    r11 = multiply(d_13, r0, r11)  # t48
    r19 = multiply(r2, d_23, r19)  # t49
    r19 = add(r11, r19, r19)  # t50
    r3 = multiply(r1, r3, r3)  # t51
    r3 = multiply(r19, r3, r3)  # t52
    r19 = multiply(r14, r15, r19)  # t53
    r14 = multiply(r16, r14, r14)  # t54
    r15 = multiply(r17, r15, r15)  # t55
    r17 = multiply(r16, r17, r17)  # t56
    r16 = multiply(a, a, r16)  # a_squared
    r6 = subtract(r4, r6, r6)  # t57
    r6 = multiply(r9, r6, r6)  # t58
    r16 = divide(r6, r16, r16)  # t59
    r7 = add(r8, r7, r7)  # t60
    r7 = add(r3, r7, r7)  # t61
    r7 = add(r19, r7, r7)  # t62
    r7 = add(r15, r7, r7)  # t63
    r7 = add(r16, r7, r7)  # t64
    r5 = subtract(r7, r5, r5)  # t65
    r10 = subtract(r5, r10, r10)  # t66
    r14 = subtract(r10, r14, r14)  # t67
    r17 = subtract(r14, r17, r17)  # t68
    out_K_2 = multiply(r17, varepsilon, out_K_2)  # t69
    r17 = multiply(Omega, d_33, r17)  # t70
    r14 = multiply(g_13, g_13, r14)  # g_13_squared
    r14 = multiply(Omega, r14, r14)  # t71
    r14 = multiply(n1_2, r14, r14)  # t72
    r2 = multiply(r2, d_31, r2)  # t73
    r0 = multiply(d_32, r0, r0)  # t74
    r2 = subtract(r0, r2, r2)  # t75
    r0 = multiply(a, k, r0)  # t76
    r0 = multiply(r2, r0, r0)  # t77
    r0 = add(r14, r0, r0)  # t78
    r17 = subtract(r0, r17, r17)  # t79
    out_K_3 = multiply(r17, varepsilon, out_K_3)  # t80
    return out_K_1, out_K_2, out_K_3


def diffusion_coefficients(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out=None):
    """Diffusion coefficients of the Fokker-Planck-Kolmogorov equation: K_21 = K_12, the others are 0.

        K_11 = varepsilon*(a**2*(g_11**2*cos(psi)**4 + g_12**2*sin(psi)**4) + g_21**2*cos(psi)**2 + g_22**2*sin(psi)**2)
        K_12 = varepsilon*(a*(-g_11**2*cos(psi)**2 + g_12**2*sin(psi)**2) + (-g_21**2 + g_22**2)/a)*sin(psi)*cos(psi)
        K_22 = varepsilon*(g_11**2*sin(psi)**2*cos(psi)**2 + g_12**2*sin(psi)**2*cos(psi)**2 + (g_21**2*sin(psi)**2 + g_22**2*cos(psi)**2)/a**2)
        K_33 = varepsilon*(Omega**2*g_13**2 + g_23**2*k**2)

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        psi: phase, in rad; any number
        Omega: frequency k x_3, in rad/s; any number
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        varepsilon: small parameter of the torques, a number; 0 < varepsilon
        g_11: intensity of the multiplicative noise of axis 1, in s^(-1/2); 0 < g_11
        g_12: intensity of the multiplicative noise of axis 2, in s^(-1/2); 0 < g_12
        g_21: intensity of the additive noise of axis 1, in rad s^(-3/2); 0 < g_21
        g_22: intensity of the additive noise of axis 2, in rad s^(-3/2); 0 < g_22
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13
        g_23: intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23

    Returns a tuple:
        K_11: diffusion of a, in rad^2/s^3
        K_12: diffusion of a and theta, in rad^2/s^2
        K_22: diffusion of theta, in rad^2/s
        K_33: diffusion of Omega, in rad^2/s^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 4 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. In fourth powers the last place of a sine or cosine counts four times. K_12
    is a sum with zeros inside the domain: its ulp are those of the largest addend.

    Rests on poloskov2004:3.1.2 (sha256 5273a157bf0d), poloskov2004:3.2.1 (sha256 3ac5751244d0).
    """
    if out is None:
        try:
            if float is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23):
                return _diffusion_coefficients(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
            if ndarray is type(a) is type(psi) is type(Omega) is type(k) is type(varepsilon) is type(g_11) is type(g_12) is type(g_21) is type(g_22) is type(g_13) is type(g_23) and DOUBLE is a.dtype is psi.dtype is Omega.dtype is k.dtype is varepsilon.dtype is g_11.dtype is g_12.dtype is g_21.dtype is g_22.dtype is g_13.dtype is g_23.dtype and () != a.shape == psi.shape == Omega.shape == k.shape == varepsilon.shape == g_11.shape == g_12.shape == g_21.shape == g_22.shape == g_13.shape == g_23.shape:
                size = a.size
                if 0 < size <= 11:
                    return evaluate_handful(_diffusion_coefficients, (a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,))
                if size <= SMALL:
                    return _diffusion_coefficients_block(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23)
                return evaluate_alike(_diffusion_coefficients_block, 13, (0, 1, 2, 3,), (a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_diffusion_coefficients_block, 13, (0, 1, 2, 3,), (a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23,), out)


def _diffusion_coefficients(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23):
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
    t6 = ((cos_psi_squared * cos_psi_squared) * g_11_squared) + (g_12_squared * (sin_psi_squared * sin_psi_squared))
    t10 = ((a_squared * t6) + ((cos_psi_squared * g_21_squared) + (g_22_squared * sin_psi_squared))) * varepsilon
    t19 = ((a * ((g_12_squared * sin_psi_squared) - t1)) + ((g_22_squared - g_21_squared) / a)) * ((cos_psi * sin_psi) * varepsilon)
    t28 = (((g_21_squared * sin_psi_squared) + (cos_psi_squared * g_22_squared)) / a_squared) + ((g_12_squared * (cos_psi_squared * sin_psi_squared)) + (sin_psi_squared * t1))
    return t10, t19, t28 * varepsilon, (((Omega * Omega) * (g_13 * g_13)) + ((g_23 * g_23) * (k * k))) * varepsilon


def _diffusion_coefficients_block(a, psi, Omega, k, varepsilon, g_11, g_12, g_21, g_22, g_13, g_23, out_K_11=None, out_K_12=None, out_K_22=None, out_K_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, r7=None, r8=None, r9=None, r10=None, r11=None, r12=None):
    r0 = multiply(g_21, g_21, r0)  # g_21_squared
    r1 = cos(psi, r1)  # cos_psi
    r2 = multiply(r1, r1, r2)  # cos_psi_squared
    r3 = multiply(g_22, g_22, r3)  # g_22_squared
    r4 = sin(psi, r4)  # sin_psi
    r5 = multiply(r4, r4, r5)  # sin_psi_squared
    r6 = multiply(a, a, r6)  # a_squared
    r7 = multiply(g_11, g_11, r7)  # g_11_squared
    r8 = multiply(g_12, g_12, r8)  # g_12_squared
    r9 = multiply(r2, r7, r9)  # t1
    r10 = multiply(r2, r0, r10)  # t2
    r11 = multiply(r3, r5, r11)  # t3
    r12 = multiply(r2, r2, r12)  # cos_psi_squared_squared
    r7 = multiply(r12, r7, r7)  # t4
    r12 = multiply(r5, r5, r12)  # sin_psi_squared_squared
    r12 = multiply(r8, r12, r12)  # t5
    r12 = add(r7, r12, r12)  # t6
    r12 = multiply(r6, r12, r12)  # t7
    r11 = add(r10, r11, r11)  # t8
    r11 = add(r12, r11, r11)  # t9
    out_K_11 = multiply(r11, varepsilon, out_K_11)  # t10
    r11 = multiply(r8, r5, r11)  # t11
    r11 = subtract(r11, r9, r11)  # t12
    r11 = multiply(a, r11, r11)  # t13
    r12 = subtract(r3, r0, r12)  # t14
    r12 = divide(r12, a, r12)  # t15
    r12 = add(r11, r12, r12)  # t16
    r4 = multiply(r1, r4, r4)  # t17
    r4 = multiply(r4, varepsilon, r4)  # t18
    out_K_12 = multiply(r12, r4, out_K_12)  # t19
    r4 = multiply(r2, r5, r4)  # t20
    r4 = multiply(r8, r4, r4)  # t21
    r9 = multiply(r5, r9, r9)  # t22
    r5 = multiply(r0, r5, r5)  # t23
    r3 = multiply(r2, r3, r3)  # t24
    r3 = add(r5, r3, r3)  # t25
    r6 = divide(r3, r6, r6)  # t26
    r9 = add(r4, r9, r9)  # t27
    r9 = add(r6, r9, r9)  # t28
    out_K_22 = multiply(r9, varepsilon, out_K_22)  # t29
    r9 = multiply(Omega, Omega, r9)  # Omega_squared
    r6 = multiply(g_13, g_13, r6)  # g_13_squared
    r6 = multiply(r9, r6, r6)  # t30
    r9 = multiply(g_23, g_23, r9)  # g_23_squared
    r4 = multiply(k, k, r4)  # k_squared
    r4 = multiply(r9, r4, r4)  # t31
    r4 = add(r6, r4, r4)  # t32
    out_K_33 = multiply(r4, varepsilon, out_K_33)  # t33
    return out_K_11, out_K_12, out_K_22, out_K_33


def averaged_drift(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13, out=None):
    """Drift coefficients divided by epsilon, averaged over the phase.

        Kbar_1 = (5*a**2*alpha**2 - 8*a**2*gamma**2 + 4*beta**2)/(16*a)
        Kbar_2 = -(d_12 - d_21)/2
        Kbar_3 = -Omega*(2*d_33 - g_13**2)/2

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        Omega: frequency k x_3, in rad/s; any number
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); 0 < gamma
        d_12: coefficient of dissipation, in 1/s; 0 < d_12
        d_21: coefficient of dissipation, in 1/s; 0 < d_21
        d_33: coefficient of dissipation, in 1/s; 0 < d_33
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13

    Returns a tuple:
        Kbar_1: drift of a, in rad/s^2
        Kbar_2: drift of theta, in rad/s
        Kbar_3: drift of Omega, in rad/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. These are sums with zeros inside the domain: the ulp are those of the largest
    addend.

    Rests on poloskov2004:3.2.5 (sha256 6ac1e8e51fbe), poloskov2004:3.2.7 (sha256 eb0bb4c9799c).
    """
    if out is None:
        try:
            if float is type(a) is type(Omega) is type(alpha) is type(beta) is type(gamma) is type(d_12) is type(d_21) is type(d_33) is type(g_13):
                return _averaged_drift(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13)
            if ndarray is type(a) is type(Omega) is type(alpha) is type(beta) is type(gamma) is type(d_12) is type(d_21) is type(d_33) is type(g_13) and DOUBLE is a.dtype is Omega.dtype is alpha.dtype is beta.dtype is gamma.dtype is d_12.dtype is d_21.dtype is d_33.dtype is g_13.dtype and () != a.shape == Omega.shape == alpha.shape == beta.shape == gamma.shape == d_12.shape == d_21.shape == d_33.shape == g_13.shape:
                size = a.size
                if 0 < size <= 5:
                    return evaluate_handful(_averaged_drift, (a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13,))
                if size <= SMALL:
                    return _averaged_drift_block(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13)
                return evaluate_alike(_averaged_drift_block, 4, (0, 1, 2,), (a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_averaged_drift_block, 4, (0, 1, 2,), (a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13,), out)


def _averaged_drift(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13):
    a_squared = a * a
    t7 = ((5.0 * (a_squared * (alpha * alpha))) + (4.0 * (beta * beta))) - (8.0 * (a_squared * (gamma * gamma)))
    return ((1.0 / 16.0) * t7) / a, ((1.0 / 2.0) * d_21) - ((1.0 / 2.0) * d_12), -((1.0 / 2.0) * (Omega * ((2.0 * d_33) - (g_13 * g_13))))


def _averaged_drift_block(a, Omega, alpha, beta, gamma, d_12, d_21, d_33, g_13, out_Kbar_1=None, out_Kbar_2=None, out_Kbar_3=None, r0=None, r1=None, r2=None, r3=None, n5=array(5.0), n4=array(4.0), n8=array(8.0), n1_16=array(1.0 / 16.0), n1_2=array(1.0 / 2.0), n2=array(2.0)):
    r0 = multiply(a, a, r0)  # a_squared
    r1 = multiply(alpha, alpha, r1)  # alpha_squared
    r1 = multiply(r0, r1, r1)  # t1
    r1 = multiply(n5, r1, r1)  # t2
    r2 = multiply(beta, beta, r2)  # beta_squared
    r2 = multiply(n4, r2, r2)  # t3
    r3 = multiply(gamma, gamma, r3)  # gamma_squared
    r3 = multiply(r0, r3, r3)  # t4
    r3 = multiply(n8, r3, r3)  # t5
    r2 = add(r1, r2, r2)  # t6
    r3 = subtract(r2, r3, r3)  # t7
    r3 = multiply(n1_16, r3, r3)  # t8
    out_Kbar_1 = divide(r3, a, out_Kbar_1)  # t9
    r3 = multiply(n1_2, d_12, r3)  # t10
    r2 = multiply(n1_2, d_21, r2)  # t11
    out_Kbar_2 = subtract(r2, r3, out_Kbar_2)  # t12
    r3 = multiply(n2, d_33, r3)  # t13
    r2 = multiply(g_13, g_13, r2)  # g_13_squared
    r2 = subtract(r3, r2, r2)  # t14
    r2 = multiply(Omega, r2, r2)  # t15
    r2 = multiply(n1_2, r2, r2)  # t16
    out_Kbar_3 = negative(r2, out_Kbar_3)  # t17
    return out_Kbar_1, out_Kbar_2, out_Kbar_3


def averaged_diffusion(a, Omega, k, alpha, beta, g_13, g_23, out=None):
    """Diffusion coefficients divided by epsilon, averaged over the phase; the mixed ones are 0.

        Kbar_11 = (3*a**2*alpha**2 + 4*beta**2)/8
        Kbar_22 = (a**2*alpha**2 + 4*beta**2)/(8*a**2)
        Kbar_33 = Omega**2*g_13**2 + g_23**2*k**2

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        Omega: frequency k x_3, in rad/s; any number
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13
        g_23: intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23

    Returns a tuple:
        Kbar_11: diffusion of a, in rad^2/s^3
        Kbar_22: diffusion of theta, in rad^2/s
        Kbar_33: diffusion of Omega, in rad^2/s^3

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes 3 arrays of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on poloskov2004:3.2.3 (sha256 af88768b172f), poloskov2004:3.2.4 (sha256 9a0cec31e26c),
    poloskov2004:3.2.7 (sha256 eb0bb4c9799c).
    """
    if out is None:
        try:
            if float is type(a) is type(Omega) is type(k) is type(alpha) is type(beta) is type(g_13) is type(g_23):
                return _averaged_diffusion(a, Omega, k, alpha, beta, g_13, g_23)
            if ndarray is type(a) is type(Omega) is type(k) is type(alpha) is type(beta) is type(g_13) is type(g_23) and DOUBLE is a.dtype is Omega.dtype is k.dtype is alpha.dtype is beta.dtype is g_13.dtype is g_23.dtype and () != a.shape == Omega.shape == k.shape == alpha.shape == beta.shape == g_13.shape == g_23.shape:
                size = a.size
                if 0 < size <= 4:
                    return evaluate_handful(_averaged_diffusion, (a, Omega, k, alpha, beta, g_13, g_23,))
                if size <= SMALL:
                    return _averaged_diffusion_block(a, Omega, k, alpha, beta, g_13, g_23)
                return evaluate_alike(_averaged_diffusion_block, 5, (0, 1, 2,), (a, Omega, k, alpha, beta, g_13, g_23,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_averaged_diffusion_block, 5, (0, 1, 2,), (a, Omega, k, alpha, beta, g_13, g_23,), out)


def _averaged_diffusion(a, Omega, k, alpha, beta, g_13, g_23):
    beta_squared = beta * beta
    a_squared = a * a
    t1 = a_squared * (alpha * alpha)
    return ((1.0 / 2.0) * beta_squared) + ((3.0 / 8.0) * t1), ((1.0 / 8.0) * (t1 + (4.0 * beta_squared))) / a_squared, ((g_23 * g_23) * (k * k)) + ((Omega * Omega) * (g_13 * g_13))


def _averaged_diffusion_block(a, Omega, k, alpha, beta, g_13, g_23, out_Kbar_11=None, out_Kbar_22=None, out_Kbar_33=None, r0=None, r1=None, r2=None, r3=None, r4=None, n1_2=array(1.0 / 2.0), n3_8=array(3.0 / 8.0), n4=array(4.0), n1_8=array(1.0 / 8.0)):
    r0 = multiply(beta, beta, r0)  # beta_squared
    r1 = multiply(a, a, r1)  # a_squared
    r2 = multiply(alpha, alpha, r2)  # alpha_squared
    r2 = multiply(r1, r2, r2)  # t1
    r3 = multiply(n1_2, r0, r3)  # t2
    r4 = multiply(n3_8, r2, r4)  # t3
    out_Kbar_11 = add(r3, r4, out_Kbar_11)  # t4
    r0 = multiply(n4, r0, r0)  # t5
    r0 = add(r2, r0, r0)  # t6
    r0 = multiply(n1_8, r0, r0)  # t7
    out_Kbar_22 = divide(r0, r1, out_Kbar_22)  # t8
    r1 = multiply(Omega, Omega, r1)  # Omega_squared
    r0 = multiply(g_13, g_13, r0)  # g_13_squared
    r0 = multiply(r1, r0, r0)  # t9
    r1 = multiply(g_23, g_23, r1)  # g_23_squared
    r2 = multiply(k, k, r2)  # k_squared
    r2 = multiply(r1, r2, r2)  # t10
    out_Kbar_33 = add(r2, r0, out_Kbar_33)  # t11
    return out_Kbar_11, out_Kbar_22, out_Kbar_33


def density_of_amplitude(a, alpha, beta, gamma, out=None):
    """Stationary density of the amplitude, normalised.

        p_s1 = 2*a*(-alpha + 2*gamma)*(alpha + 2*gamma)/((3*a**2*alpha**2 + 4*beta**2)*(3*a**2*alpha**2/(4*beta**2) + 1)**((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2)))

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha/2 < gamma

    Returns:
        p_s1: density of a, in s/rad

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. The ulp are those of the value times its condition number, 1 + |kappa_1|
    log(1 + 3 alpha^2 a^2/(4 beta^2)), as the exponent is rounded. For alpha -> 0 it becomes Rayleigh's density.

    Rests on poloskov2004:3.4 (sha256 1151d266f39f), poloskov2004:3.5 (sha256 9b09838828a8), poloskov2004:4.0.3
    (sha256 c717004439c9), poloskov2004:B.2 (sha256 75e272e9ef26), poloskov2004:B.3 (sha256 4ab1b535ef23).
    """
    if out is None:
        try:
            if float is type(a) is type(alpha) is type(beta) is type(gamma):
                return _density_of_amplitude(a, alpha, beta, gamma)
            if ndarray is type(a) is type(alpha) is type(beta) is type(gamma) and DOUBLE is a.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != a.shape == alpha.shape == beta.shape == gamma.shape:
                size = a.size
                if 0 < size <= 12:
                    return evaluate_handful(_density_of_amplitude, (a, alpha, beta, gamma,))
                if size <= SMALL:
                    return _density_of_amplitude_block(a, alpha, beta, gamma)
                return evaluate_alike(_density_of_amplitude_block, 7, (0,), (a, alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_density_of_amplitude_block, 7, (0,), (a, alpha, beta, gamma,), out)


def _density_of_amplitude(a, alpha, beta, gamma):
    t1 = 2.0 * gamma
    beta_squared = beta * beta
    a_squared = a * a
    t4 = a_squared * (alpha * alpha)
    t5 = 1.0 / beta_squared
    t12 = (alpha + t1) * (alpha - t1)
    t19 = math.exp((1.0 / 4.0) * (log1p_ratio((3.0 / 4.0) * (t4 * t5)) * ((a_squared * t12) * t5))) * (a * t12)
    return -((2.0 * t19) / ((4.0 * beta_squared) + (3.0 * t4)))


def _density_of_amplitude_block(a, alpha, beta, gamma, out_p_s1=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n2=array(2.0), n1=array(1.0), n4=array(4.0), n3=array(3.0), n3_4=array(3.0 / 4.0), n1_4=array(1.0 / 4.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = add(alpha, r0, r1)  # t2
    r0 = subtract(alpha, r0, r0)  # t3
    r2 = multiply(beta, beta, r2)  # beta_squared
    r3 = multiply(a, a, r3)  # a_squared
    r4 = multiply(alpha, alpha, r4)  # alpha_squared
    r4 = multiply(r3, r4, r4)  # t4
    r5 = divide(n1, r2, r5)  # t5
    r2 = multiply(n4, r2, r2)  # t6
    r6 = multiply(n3, r4, r6)  # t7
    r6 = add(r2, r6, r6)  # t8
    r4 = multiply(r4, r5, r4)  # t9
    r4 = multiply(n3_4, r4, r4)  # t10
    r4 = log1p_ratio(r4, r4)  # t11
    r0 = multiply(r1, r0, r0)  # t12
    r3 = multiply(r3, r0, r3)  # t13
    r5 = multiply(r3, r5, r5)  # t14
    r5 = multiply(r4, r5, r5)  # t15
    r5 = multiply(n1_4, r5, r5)  # t16
    r5 = exp(r5, r5)  # t17
    r0 = multiply(a, r0, r0)  # t18
    r0 = multiply(r5, r0, r0)  # t19
    r0 = multiply(n2, r0, r0)  # t20
    r6 = divide(r0, r6, r6)  # t21
    out_p_s1 = negative(r6, out_p_s1)  # t22
    return out_p_s1


def density_of_frequency(Omega, k, g_13, g_23, d_33, out=None):
    """Stationary density of the frequency, normalised; gamma() is Euler's function.

        p_s3 = g_13*gamma(d_33/g_13**2 + 1/2)/(sqrt(pi)*sqrt(Omega**2*g_13**2 + g_23**2*k**2)*(Omega**2*g_13**2/(g_23**2*k**2) + 1)**(d_33/g_13**2)*gamma(d_33/g_13**2))

    Arguments:
        Omega: frequency k x_3, in rad/s; any number
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13
        g_23: intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23
        d_33: coefficient of dissipation, in 1/s; 0 < d_33

    Returns:
        p_s3: density of Omega, in s/rad

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 16 ulp over the domain. The ulp are those of the value times its condition number, 1 + |kappa_2|
    log(1 + g_13^2 Omega^2/(g_23 k)^2), as the exponent is rounded. For g_13 -> 0 it becomes normal.

    Rests on poloskov2004:3.4.2 (sha256 6a0fedfb75dc), poloskov2004:3.5.1 (sha256 9ebdaa94d36f),
    poloskov2004:4.0.5 (sha256 fedbb5637deb), poloskov2004:B.5 (sha256 cbe1a14d6c97).
    """
    if out is None:
        try:
            if float is type(Omega) is type(k) is type(g_13) is type(g_23) is type(d_33):
                return _density_of_frequency(Omega, k, g_13, g_23, d_33)
            if ndarray is type(Omega) is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is Omega.dtype is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != Omega.shape == k.shape == g_13.shape == g_23.shape == d_33.shape:
                size = Omega.size
                if 0 < size <= 14:
                    return evaluate_handful(_density_of_frequency, (Omega, k, g_13, g_23, d_33,))
                if size <= SMALL:
                    return _density_of_frequency_block(Omega, k, g_13, g_23, d_33)
                return evaluate_alike(_density_of_frequency_block, 6, (0,), (Omega, k, g_13, g_23, d_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_density_of_frequency_block, 6, (0,), (Omega, k, g_13, g_23, d_33,), out)


def _density_of_frequency(Omega, k, g_13, g_23, d_33):
    g_13_squared = g_13 * g_13
    Omega_squared = Omega * Omega
    t1 = Omega_squared * g_13_squared
    t2 = (g_23 * g_23) * (k * k)
    t3 = 1.0 / t2
    t16 = gamma_ratio(d_33 / g_13_squared, 1.0 / 2.0) * (math.sqrt(d_33) * math.exp(-(log1p_ratio(t1 * t3) * (d_33 * (Omega_squared * t3)))))
    return t16 / (math.sqrt(math.pi) * math.sqrt(t1 + t2))


def _density_of_frequency_block(Omega, k, g_13, g_23, d_33, out_p_s3=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1=array(1.0), n1_2=array(1.0 / 2.0), sqrt_pi=array(math.sqrt(math.pi))):
    r0 = multiply(g_13, g_13, r0)  # g_13_squared
    r1 = multiply(Omega, Omega, r1)  # Omega_squared
    r2 = multiply(r1, r0, r2)  # t1
    r3 = multiply(g_23, g_23, r3)  # g_23_squared
    r4 = multiply(k, k, r4)  # k_squared
    r4 = multiply(r3, r4, r4)  # t2
    r3 = divide(n1, r4, r3)  # t3
    r5 = sqrt(d_33, r5)  # sqrt_d_33
    r4 = add(r2, r4, r4)  # t4
    r4 = sqrt(r4, r4)  # t5
    r2 = multiply(r2, r3, r2)  # t6
    r2 = log1p_ratio(r2, r2)  # t7
    r3 = multiply(r1, r3, r3)  # t8
    r3 = multiply(d_33, r3, r3)  # t9
    r3 = multiply(r2, r3, r3)  # t10
    r3 = negative(r3, r3)  # t11
    r3 = exp(r3, r3)  # t12
    r0 = divide(d_33, r0, r0)  # t13
    r0 = gamma_ratio(r0, n1_2, r0)  # t14
    r3 = multiply(r5, r3, r3)  # t15
    r3 = multiply(r0, r3, r3)  # t16
    r4 = multiply(sqrt_pi, r4, r4)  # t17
    out_p_s3 = divide(r3, r4, out_p_s3)  # t18
    return out_p_s3


def logarithm_of_constant_of_amplitude(alpha, beta, gamma, out=None):
    """The logarithm of the constant in the density 8 C_1 a Delta_1^kappa_1 of the amplitude.

        log_C_1 = log((-alpha + 2*gamma)*(alpha + 2*gamma)/4) + 2*(-alpha + 2*gamma)*(alpha + 2*gamma)*log(2*beta)/(3*alpha**2)

    Arguments:
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha/2 < gamma

    Returns:
        log_C_1: log C_1, a number

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 6 ulp over the domain. An error is a relative error of the constant: the ulp are those of 2, of the
    larger addend or of the exponent, whichever is largest.

    Rests on poloskov2004:3.4 (sha256 1151d266f39f), poloskov2004:3.5 (sha256 9b09838828a8), poloskov2004:4.0.3
    (sha256 c717004439c9), poloskov2004:B.2 (sha256 75e272e9ef26).
    """
    if out is None:
        try:
            if float is type(alpha) is type(beta) is type(gamma):
                return _logarithm_of_constant_of_amplitude(alpha, beta, gamma)
            if ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                size = alpha.size
                if 0 < size <= 5:
                    return evaluate_handful(_logarithm_of_constant_of_amplitude, (alpha, beta, gamma,))
                if size <= SMALL:
                    return _logarithm_of_constant_of_amplitude_block(alpha, beta, gamma)
                return evaluate_alike(_logarithm_of_constant_of_amplitude_block, 4, (0,), (alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_logarithm_of_constant_of_amplitude_block, 4, (0,), (alpha, beta, gamma,), out)


def _logarithm_of_constant_of_amplitude(alpha, beta, gamma):
    t1 = 2.0 * gamma
    t4 = (alpha + t1) * (t1 - alpha)
    t12 = (((2.0 / 3.0) * (t4 * math.log(2.0 * beta))) / (alpha * alpha)) + math.log((1.0 / 4.0) * t4)
    return t12


def _logarithm_of_constant_of_amplitude_block(alpha, beta, gamma, out_log_C_1=None, r0=None, r1=None, r2=None, r3=None, n2=array(2.0), n1_4=array(1.0 / 4.0), n2_3=array(2.0 / 3.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = add(alpha, r0, r1)  # t2
    r0 = subtract(r0, alpha, r0)  # t3
    r0 = multiply(r1, r0, r0)  # t4
    r1 = multiply(n1_4, r0, r1)  # t5
    r1 = log(r1, r1)  # t6
    r2 = multiply(alpha, alpha, r2)  # alpha_squared
    r3 = multiply(n2, beta, r3)  # t7
    r3 = log(r3, r3)  # t8
    r3 = multiply(r0, r3, r3)  # t9
    r3 = multiply(n2_3, r3, r3)  # t10
    r2 = divide(r3, r2, r2)  # t11
    out_log_C_1 = add(r2, r1, out_log_C_1)  # t12
    return out_log_C_1


def logarithm_of_constant_of_frequency(k, g_13, g_23, d_33, out=None):
    """The logarithm of the constant in the density C_2 Delta_2^kappa_2 of the frequency; gamma() is Euler's function.

        log_C_2 = 2*d_33*log(g_23*k)/g_13**2 + log(g_13*gamma(d_33/g_13**2 + 1/2)/(sqrt(pi)*gamma(d_33/g_13**2)))

    Arguments:
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13
        g_23: intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23
        d_33: coefficient of dissipation, in 1/s; 0 < d_33

    Returns:
        log_C_2: log C_2, a number

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 16 ulp over the domain. An error is a relative error of the constant: the ulp are those of 2, of the
    larger addend or of the exponent, whichever is largest.

    Rests on poloskov2004:3.4.2 (sha256 6a0fedfb75dc), poloskov2004:3.5.1 (sha256 9ebdaa94d36f),
    poloskov2004:4.0.5 (sha256 fedbb5637deb), poloskov2004:B.5 (sha256 cbe1a14d6c97).
    """
    if out is None:
        try:
            if float is type(k) is type(g_13) is type(g_23) is type(d_33):
                return _logarithm_of_constant_of_frequency(k, g_13, g_23, d_33)
            if ndarray is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != k.shape == g_13.shape == g_23.shape == d_33.shape:
                size = k.size
                if 0 < size <= 14:
                    return evaluate_handful(_logarithm_of_constant_of_frequency, (k, g_13, g_23, d_33,))
                if size <= SMALL:
                    return _logarithm_of_constant_of_frequency_block(k, g_13, g_23, d_33)
                return evaluate_alike(_logarithm_of_constant_of_frequency_block, 3, (0,), (k, g_13, g_23, d_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_logarithm_of_constant_of_frequency_block, 3, (0,), (k, g_13, g_23, d_33,), out)


def _logarithm_of_constant_of_frequency(k, g_13, g_23, d_33):
    t1 = d_33 / (g_13 * g_13)
    t10 = (2.0 * (t1 * math.log(g_23 * k))) + math.log((math.sqrt(d_33) * gamma_ratio(t1, 1.0 / 2.0)) / math.sqrt(math.pi))
    return t10


def _logarithm_of_constant_of_frequency_block(k, g_13, g_23, d_33, out_log_C_2=None, r0=None, r1=None, r2=None, n2=array(2.0), n1_2=array(1.0 / 2.0), sqrt_pi=array(math.sqrt(math.pi))):
    r0 = multiply(g_13, g_13, r0)  # g_13_squared
    r0 = divide(d_33, r0, r0)  # t1
    r1 = multiply(g_23, k, r1)  # t2
    r1 = log(r1, r1)  # t3
    r1 = multiply(r0, r1, r1)  # t4
    r1 = multiply(n2, r1, r1)  # t5
    r2 = sqrt(d_33, r2)  # sqrt_d_33
    r0 = gamma_ratio(r0, n1_2, r0)  # t6
    r0 = multiply(r2, r0, r0)  # t7
    r0 = divide(r0, sqrt_pi, r0)  # t8
    r0 = log(r0, r0)  # t9
    out_log_C_2 = add(r1, r0, out_log_C_2)  # t10
    return out_log_C_2


def distribution_of_amplitude(a, alpha, beta, gamma, out=None):
    """The probability that the amplitude is at most a.

        F = 1 - 1/(3*a**2*alpha**2/(4*beta**2) + 1)**((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2))

    Arguments:
        a: amplitude of the equatorial angular velocity, in rad/s; 0 < a
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha/2 < gamma

    Returns:
        F: probability, a number

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. The exponent of the power is rounded.

    Rests on poloskov2004:B.3 (sha256 4ab1b535ef23).
    """
    if out is None:
        try:
            if float is type(a) is type(alpha) is type(beta) is type(gamma):
                return _distribution_of_amplitude(a, alpha, beta, gamma)
            if ndarray is type(a) is type(alpha) is type(beta) is type(gamma) and DOUBLE is a.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != a.shape == alpha.shape == beta.shape == gamma.shape:
                size = a.size
                if 0 < size <= 8:
                    return evaluate_handful(_distribution_of_amplitude, (a, alpha, beta, gamma,))
                if size <= SMALL:
                    return _distribution_of_amplitude_block(a, alpha, beta, gamma)
                return evaluate_alike(_distribution_of_amplitude_block, 4, (0,), (a, alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_distribution_of_amplitude_block, 4, (0,), (a, alpha, beta, gamma,), out)


def _distribution_of_amplitude(a, alpha, beta, gamma):
    t1 = 2.0 * gamma
    t2 = (a * a) / (beta * beta)
    t11 = (1.0 / 4.0) * (log1p_ratio((3.0 / 4.0) * ((alpha * alpha) * t2)) * ((alpha - t1) * (t2 * (alpha + t1))))
    return -math.expm1(t11)


def _distribution_of_amplitude_block(a, alpha, beta, gamma, out_F=None, r0=None, r1=None, r2=None, r3=None, n2=array(2.0), n3_4=array(3.0 / 4.0), n1_4=array(1.0 / 4.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = multiply(a, a, r1)  # a_squared
    r2 = multiply(beta, beta, r2)  # beta_squared
    r2 = divide(r1, r2, r2)  # t2
    r1 = add(alpha, r0, r1)  # t3
    r0 = subtract(alpha, r0, r0)  # t4
    r3 = multiply(alpha, alpha, r3)  # alpha_squared
    r3 = multiply(r3, r2, r3)  # t5
    r3 = multiply(n3_4, r3, r3)  # t6
    r3 = log1p_ratio(r3, r3)  # t7
    r1 = multiply(r2, r1, r1)  # t8
    r1 = multiply(r0, r1, r1)  # t9
    r1 = multiply(r3, r1, r1)  # t10
    r1 = multiply(n1_4, r1, r1)  # t11
    r1 = expm1(r1, r1)  # t12
    out_F = negative(r1, out_F)  # t13
    return out_F


def quantile_of_amplitude(q, alpha, beta, gamma, out=None):
    """The amplitude that is exceeded with the probability 1 - q.

        a_q = 2*sqrt(3)*beta*sqrt(-1 + (1 - q)**(-3*alpha**2/((-alpha + 2*gamma)*(alpha + 2*gamma))))/(3*alpha)

    Arguments:
        q: probability, a number; 0 < q < 1
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); 3*alpha/5 < gamma

    Returns:
        a_q: quantile of a, in rad/s

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 8 ulp over the domain. The ulp are those of the value times its condition number, 1 + |log(1 -
    q)|/nu with nu = |kappa_1| - 1. Nearer to gamma = alpha/2, where the density ends to exist, quantiles may be
    infinite.

    Rests on poloskov2004:B.3 (sha256 4ab1b535ef23), poloskov2004:B.4 (sha256 62615be373ca).
    """
    if out is None:
        try:
            if float is type(q) is type(alpha) is type(beta) is type(gamma):
                return _quantile_of_amplitude(q, alpha, beta, gamma)
            if ndarray is type(q) is type(alpha) is type(beta) is type(gamma) and DOUBLE is q.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != q.shape == alpha.shape == beta.shape == gamma.shape:
                size = q.size
                if 0 < size <= 11:
                    return evaluate_handful(_quantile_of_amplitude, (q, alpha, beta, gamma,))
                if size <= SMALL:
                    return _quantile_of_amplitude_block(q, alpha, beta, gamma)
                return evaluate_alike(_quantile_of_amplitude_block, 7, (0,), (q, alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_quantile_of_amplitude_block, 7, (0,), (q, alpha, beta, gamma,), out)


def _quantile_of_amplitude(q, alpha, beta, gamma):
    t1 = 2.0 * gamma
    t2 = alpha + t1
    t4 = math.log1p(-q)
    t6 = 1.0 / (t1 - alpha)
    t20 = math.sqrt(expm1_ratio(-((3.0 * ((alpha * alpha) * (t4 * t6))) / t2))) * (math.sqrt(-t4) * (beta * math.sqrt(t6)))
    return (2.0 * t20) / math.sqrt(t2)


def _quantile_of_amplitude_block(q, alpha, beta, gamma, out_a_q=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n2=array(2.0), n1=array(1.0), n3=array(3.0)):
    r0 = multiply(n2, gamma, r0)  # t1
    r1 = add(alpha, r0, r1)  # t2
    r2 = negative(q, r2)  # t3
    r2 = log1p(r2, r2)  # t4
    r0 = subtract(r0, alpha, r0)  # t5
    r0 = divide(n1, r0, r0)  # t6
    r3 = sqrt(r1, r3)  # t7
    r4 = sqrt(r0, r4)  # t8
    r5 = negative(r2, r5)  # t9
    r5 = sqrt(r5, r5)  # t10
    r6 = multiply(alpha, alpha, r6)  # alpha_squared
    r0 = multiply(r2, r0, r0)  # t11
    r0 = multiply(r6, r0, r0)  # t12
    r0 = multiply(n3, r0, r0)  # t13
    r1 = divide(r0, r1, r1)  # t14
    r1 = negative(r1, r1)  # t15
    r1 = expm1_ratio(r1, r1)  # t16
    r1 = sqrt(r1, r1)  # t17
    r4 = multiply(beta, r4, r4)  # t18
    r4 = multiply(r5, r4, r4)  # t19
    r4 = multiply(r1, r4, r4)  # t20
    r4 = multiply(n2, r4, r4)  # t21
    out_a_q = divide(r4, r3, out_a_q)  # t22
    return out_a_q


def moment_of_amplitude(m, alpha, beta, gamma, out=None):
    """The mean of a^m; gamma() is Euler's function.

        M_a = gamma(-m/2 + (-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2))*gamma(m/2 + 1)/((3*alpha**2/(4*beta**2))**(m/2)*gamma((-alpha + 2*gamma)*(alpha + 2*gamma)/(3*alpha**2)))

    Arguments:
        m: order of the moment, a number; 0 <= m <= 8
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha*sqrt((2 + 3*m)/8)*(1 + 1e-9) < gamma

    Returns:
        M_a: moment, in (rad/s)^m

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 16 ulp over the domain. The ulp are those of the value times its condition number, (2 + m) (1 +
    log(1 + m)) nu/(nu - m/2) with nu = |kappa_1| - 1. Beyond the domain the moment is infinite, and the formula
    means nothing.

    Rests on poloskov2004:4.0.9 (sha256 3a73e58c5dd1), poloskov2004:B.2 (sha256 75e272e9ef26), poloskov2004:B.6
    (sha256 41c46c7cb035).
    """
    if out is None:
        try:
            if float is type(m) is type(alpha) is type(beta) is type(gamma):
                return _moment_of_amplitude(m, alpha, beta, gamma)
            if ndarray is type(m) is type(alpha) is type(beta) is type(gamma) and DOUBLE is m.dtype is alpha.dtype is beta.dtype is gamma.dtype and () != m.shape == alpha.shape == beta.shape == gamma.shape:
                size = m.size
                if 0 < size <= 15:
                    return evaluate_handful(_moment_of_amplitude, (m, alpha, beta, gamma,))
                if size <= SMALL:
                    return _moment_of_amplitude_block(m, alpha, beta, gamma)
                return evaluate_alike(_moment_of_amplitude_block, 6, (0,), (m, alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_moment_of_amplitude_block, 6, (0,), (m, alpha, beta, gamma,), out)


def _moment_of_amplitude(m, alpha, beta, gamma):
    t1 = (1.0 / 2.0) * m
    t2 = 2.0 * gamma
    t3 = alpha + t2
    t4 = t2 - alpha
    t18 = gamma_ratio(((1.0 / 3.0) * (t3 * t4)) / (alpha * alpha), -t1) * (math.pow((2.0 * beta) / (math.sqrt(t3) * math.sqrt(t4)), m) * gamma_ratio(1.0, t1))
    return t18


def _moment_of_amplitude_block(m, alpha, beta, gamma, out_M_a=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n1_2=array(1.0 / 2.0), n2=array(2.0), n1=array(1.0), n1_3=array(1.0 / 3.0)):
    r0 = multiply(n1_2, m, r0)  # t1
    r1 = multiply(n2, gamma, r1)  # t2
    r2 = add(alpha, r1, r2)  # t3
    r1 = subtract(r1, alpha, r1)  # t4
    r3 = sqrt(r2, r3)  # t5
    r4 = sqrt(r1, r4)  # t6
    r5 = multiply(n2, beta, r5)  # t7
    r4 = multiply(r3, r4, r4)  # t8
    r4 = divide(r5, r4, r4)  # t9
    r4 = power(r4, m, r4)  # t10
    r5 = gamma_ratio(n1, r0, r5)  # t11
    r3 = multiply(alpha, alpha, r3)  # alpha_squared
    r1 = multiply(r2, r1, r1)  # t12
    r1 = multiply(n1_3, r1, r1)  # t13
    r3 = divide(r1, r3, r3)  # t14
    r0 = negative(r0, r0)  # t15
    r0 = gamma_ratio(r3, r0, r0)  # t16
    r5 = multiply(r4, r5, r5)  # t17
    out_M_a = multiply(r0, r5, out_M_a)  # t18
    return out_M_a


def moment_of_frequency(m, k, g_13, g_23, d_33, out=None):
    """The mean of |Omega|^m; gamma() is Euler's function.

        M_Omega = gamma(m/2 + 1/2)*gamma(d_33/g_13**2 - m/2)/(sqrt(pi)*(g_13**2/(g_23**2*k**2))**(m/2)*gamma(d_33/g_13**2))

    Arguments:
        m: order of the moment, a number; 0 <= m <= 8
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13
        g_23: intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23
        d_33: coefficient of dissipation, in 1/s; m*g_13**2/2*(1 + 1e-9) < d_33

    Returns:
        M_Omega: absolute moment, in (rad/s)^m

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 16 ulp over the domain. The ulp are those of the value times its condition number, (2 + m) (1 +
    log(1 + m)) delta/(delta - m/2) with delta = d_33/g_13^2. Beyond the domain the moment is infinite, and the
    formula means nothing.

    Rests on poloskov2004:4.0.11 (sha256 e330cba03040), poloskov2004:B.5 (sha256 cbe1a14d6c97), poloskov2004:B.7
    (sha256 56d9fc5b6314).
    """
    if out is None:
        try:
            if float is type(m) is type(k) is type(g_13) is type(g_23) is type(d_33):
                return _moment_of_frequency(m, k, g_13, g_23, d_33)
            if ndarray is type(m) is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is m.dtype is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != m.shape == k.shape == g_13.shape == g_23.shape == d_33.shape:
                size = m.size
                if 0 < size <= 14:
                    return evaluate_handful(_moment_of_frequency, (m, k, g_13, g_23, d_33,))
                if size <= SMALL:
                    return _moment_of_frequency_block(m, k, g_13, g_23, d_33)
                return evaluate_alike(_moment_of_frequency_block, 4, (0,), (m, k, g_13, g_23, d_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_moment_of_frequency_block, 4, (0,), (m, k, g_13, g_23, d_33,), out)


def _moment_of_frequency(m, k, g_13, g_23, d_33):
    t1 = (1.0 / 2.0) * m
    t11 = (math.pow((g_23 * k) / math.sqrt(d_33), m) * gamma_ratio(1.0, t1 - (1.0 / 2.0))) * gamma_ratio(d_33 / (g_13 * g_13), -t1)
    return t11 / math.sqrt(math.pi)


def _moment_of_frequency_block(m, k, g_13, g_23, d_33, out_M_Omega=None, r0=None, r1=None, r2=None, r3=None, n1_2=array(1.0 / 2.0), n1=array(1.0), sqrt_pi=array(math.sqrt(math.pi))):
    r0 = multiply(n1_2, m, r0)  # t1
    r1 = sqrt(d_33, r1)  # sqrt_d_33
    r2 = multiply(g_23, k, r2)  # t2
    r1 = divide(r2, r1, r1)  # t3
    r1 = power(r1, m, r1)  # t4
    r2 = subtract(r0, n1_2, r2)  # t5
    r2 = gamma_ratio(n1, r2, r2)  # t6
    r3 = multiply(g_13, g_13, r3)  # g_13_squared
    r3 = divide(d_33, r3, r3)  # t7
    r0 = negative(r0, r0)  # t8
    r0 = gamma_ratio(r3, r0, r0)  # t9
    r2 = multiply(r1, r2, r2)  # t10
    r0 = multiply(r2, r0, r0)  # t11
    out_M_Omega = divide(r0, sqrt_pi, out_M_Omega)  # t12
    return out_M_Omega


def mean_square_of_amplitude(alpha, beta, gamma, out=None):
    """The mean of a^2.

        S_a = -beta**2/((alpha - gamma)*(alpha + gamma))

    Arguments:
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); alpha < gamma

    Returns:
        S_a: mean square of a, in rad^2/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. Beyond the domain it is infinite, and the formula means nothing.

    Rests on poloskov2004:4.0.9 (sha256 3a73e58c5dd1), poloskov2004:B.8 (sha256 d9698f4ddfc7).
    """
    if out is None:
        try:
            if float is type(alpha) is type(beta) is type(gamma):
                return _mean_square_of_amplitude(alpha, beta, gamma)
            if ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                size = alpha.size
                if 0 < size <= 1:
                    return evaluate_handful(_mean_square_of_amplitude, (alpha, beta, gamma,))
                if size <= SMALL:
                    return _mean_square_of_amplitude_block(alpha, beta, gamma)
                return evaluate_alike(_mean_square_of_amplitude_block, 3, (0,), (alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_mean_square_of_amplitude_block, 3, (0,), (alpha, beta, gamma,), out)


def _mean_square_of_amplitude(alpha, beta, gamma):
    return -((beta * beta) / ((alpha + gamma) * (alpha - gamma)))


def _mean_square_of_amplitude_block(alpha, beta, gamma, out_S_a=None, r0=None, r1=None, r2=None):
    r0 = multiply(beta, beta, r0)  # beta_squared
    r1 = add(alpha, gamma, r1)  # t1
    r2 = subtract(alpha, gamma, r2)  # t2
    r2 = multiply(r1, r2, r2)  # t3
    r2 = divide(r0, r2, r2)  # t4
    out_S_a = negative(r2, out_S_a)  # t5
    return out_S_a


def mean_square_of_frequency(k, g_13, g_23, d_33, out=None):
    """The mean of Omega^2.

        S_Omega = g_23**2*k**2/(2*(d_33 - g_13**2))

    Arguments:
        k: (A - C)/A, of the moments of inertia A, A, C, a number; 0 < k
        g_13: intensity of the multiplicative noise of axis 3, in s^(-1/2); 0 < g_13
        g_23: intensity of the additive noise of axis 3, in rad s^(-3/2); 0 < g_23
        d_33: coefficient of dissipation, in 1/s; g_13**2 < d_33

    Returns:
        S_Omega: mean square of Omega, in rad^2/s^2

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain. The ulp are those of the value times its condition number, (d_33 +
    g_13^2)/|d_33 - g_13^2|, as g_13^2 is rounded. Beyond the domain it is infinite, and the formula means
    nothing.

    Rests on poloskov2004:4.0.11 (sha256 e330cba03040), poloskov2004:B.8 (sha256 d9698f4ddfc7).
    """
    if out is None:
        try:
            if float is type(k) is type(g_13) is type(g_23) is type(d_33):
                return _mean_square_of_frequency(k, g_13, g_23, d_33)
            if ndarray is type(k) is type(g_13) is type(g_23) is type(d_33) and DOUBLE is k.dtype is g_13.dtype is g_23.dtype is d_33.dtype and () != k.shape == g_13.shape == g_23.shape == d_33.shape:
                size = k.size
                if 0 < size <= 1:
                    return evaluate_handful(_mean_square_of_frequency, (k, g_13, g_23, d_33,))
                if size <= SMALL:
                    return _mean_square_of_frequency_block(k, g_13, g_23, d_33)
                return evaluate_alike(_mean_square_of_frequency_block, 3, (0,), (k, g_13, g_23, d_33,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_mean_square_of_frequency_block, 3, (0,), (k, g_13, g_23, d_33,), out)


def _mean_square_of_frequency(k, g_13, g_23, d_33):
    return ((1.0 / 2.0) * ((g_23 * g_23) * (k * k))) / (d_33 - (g_13 * g_13))


def _mean_square_of_frequency_block(k, g_13, g_23, d_33, out_S_Omega=None, r0=None, r1=None, r2=None, n1_2=array(1.0 / 2.0)):
    r0 = multiply(g_23, g_23, r0)  # g_23_squared
    r1 = multiply(k, k, r1)  # k_squared
    r2 = multiply(g_13, g_13, r2)  # g_13_squared
    r2 = subtract(d_33, r2, r2)  # t1
    r1 = multiply(r0, r1, r1)  # t2
    r1 = multiply(n1_2, r1, r1)  # t3
    out_S_Omega = divide(r1, r2, out_S_Omega)  # t4
    return out_S_Omega


def mode_of_amplitude(alpha, beta, gamma, out=None):
    """The most probable amplitude, where the density is largest; that of the frequency is 0.

        a_star = 2*beta/sqrt(alpha**2 + 8*gamma**2)

    Arguments:
        alpha: multiplicative noise, alpha^2 = g_11^2 + g_12^2, in s^(-1/2); 0 < alpha
        beta: additive noise, beta^2 = g_21^2 + g_22^2, in rad s^(-3/2); 0 < beta
        gamma: dissipation, gamma^2 = d_11 + d_22, in s^(-1/2); 0 < gamma

    Returns:
        a_star: mode of a, in rad/s

    The arguments are numbers or arrays, which broadcast. Numbers give numbers; arrays give float64, or float32 if
    all are. `out` takes an array of the broadcast shape and type; a ValueError names what does not fit. What is
    no number gives no number.

    Accuracy: 4 ulp over the domain.

    Rests on poloskov2004:4.0.13 (sha256 7089048da9b5), poloskov2004:4.0.14 (sha256 6193d8c6bbde),
    poloskov2004:4.0.15 (sha256 c8497c4d28b1).
    """
    if out is None:
        try:
            if float is type(alpha) is type(beta) is type(gamma):
                return _mode_of_amplitude(alpha, beta, gamma)
            if ndarray is type(alpha) is type(beta) is type(gamma) and DOUBLE is alpha.dtype is beta.dtype is gamma.dtype and () != alpha.shape == beta.shape == gamma.shape:
                size = alpha.size
                if 0 < size <= 1:
                    return evaluate_handful(_mode_of_amplitude, (alpha, beta, gamma,))
                if size <= SMALL:
                    return _mode_of_amplitude_block(alpha, beta, gamma)
                return evaluate_alike(_mode_of_amplitude_block, 2, (0,), (alpha, beta, gamma,))
        except (ValueError, ZeroDivisionError, OverflowError):
            pass  # NumPy says whether it is infinite or no number
    return evaluate(_mode_of_amplitude_block, 2, (0,), (alpha, beta, gamma,), out)


def _mode_of_amplitude(alpha, beta, gamma):
    return (2.0 * beta) / math.sqrt((alpha * alpha) + (8.0 * (gamma * gamma)))


def _mode_of_amplitude_block(alpha, beta, gamma, out_a_star=None, r0=None, r1=None, n8=array(8.0), n2=array(2.0)):
    r0 = multiply(alpha, alpha, r0)  # alpha_squared
    r1 = multiply(gamma, gamma, r1)  # gamma_squared
    r1 = multiply(n8, r1, r1)  # t1
    r1 = add(r0, r1, r1)  # t2
    r1 = sqrt(r1, r1)  # t3
    r0 = multiply(n2, beta, r0)  # t4
    out_a_star = divide(r0, r1, out_a_star)  # t5
    return out_a_star
