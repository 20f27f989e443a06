"""How the kernels of relations run on numbers and on arrays. Written by `symcheck generate`: what is changed here is lost."""

# mypy: ignore-errors
import math

from numpy import array, ndarray, add, divide, multiply, sin, subtract

from symcheck.kernels.runtime import DOUBLE, FEW, SMALL, UNDEFINED, on_arrays


def time_of_a_turn(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _time_of_a_turn, 2, (0,), 0)

    def call(theta, w, alpha, out=None):
        if out is None:
            if float is type(theta) is type(w) is type(alpha):
                try:
                    return formula(theta, w, alpha)
                except UNDEFINED:
                    pass
            elif ndarray is type(theta) is type(w) is type(alpha) and DOUBLE is theta.dtype is w.dtype is alpha.dtype and () != theta.shape == w.shape == alpha.shape:
                if 0 < theta.size <= SMALL:
                    return _time_of_a_turn(theta, w, alpha)
                return alike(theta, w, alpha)
        return others((theta, w, alpha,), out)

    return call


def _time_of_a_turn(theta, w, alpha, out_s=None, r0=None, r1=None):
    r0 = divide(theta, w, r0)  # t1
    r1 = divide(w, alpha, r1)  # t2
    out_s = add(r0, r1, out_s)  # t3
    return out_s


def momentum_of_a_disturbance(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _momentum_of_a_disturbance, 4, (0,), 5)

    def call(G, T, t, P, omega, Q, out=None):
        if out is None:
            if float is type(G) is type(T) is type(t) is type(P) is type(omega) is type(Q):
                try:
                    return formula(G, T, t, P, omega, Q)
                except UNDEFINED:
                    pass
            elif ndarray is type(G) is type(T) is type(t) is type(P) is type(omega) is type(Q) and DOUBLE is G.dtype is T.dtype is t.dtype is P.dtype is omega.dtype is Q.dtype and () != G.shape == T.shape == t.shape == P.shape == omega.shape == Q.shape:
                if 5 < G.size <= SMALL:
                    return _momentum_of_a_disturbance(G, T, t, P, omega, Q)
                return alike(G, T, t, P, omega, Q)
        return others((G, T, t, P, omega, Q,), out)

    return call


def _momentum_of_a_disturbance(G, T, t, P, omega, Q, out_H=None, r0=None, r1=None, r2=None, r3=None, n1=array(1.0), n1_2=array(1.0 / 2.0), n2=array(2.0)):
    r0 = divide(n1, omega, r0)  # t1
    r1 = multiply(omega, t, r1)  # t2
    r2 = sin(r1, r2)  # t3
    r3 = multiply(P, r0, r3)  # t4
    r3 = multiply(r2, r3, r3)  # t5
    r1 = multiply(n1_2, r1, r1)  # t6
    r1 = sin(r1, r1)  # t7
    r1 = multiply(r1, r1, r1)  # t8
    r0 = multiply(Q, r0, r0)  # t9
    r0 = multiply(r1, r0, r0)  # t10
    r0 = multiply(n2, r0, r0)  # t11
    r1 = multiply(T, t, r1)  # t12
    r3 = add(G, r3, r3)  # t13
    r3 = add(r0, r3, r3)  # t14
    out_H = add(r1, r3, out_H)  # t15
    return out_H


def momentum_with_dumping(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _momentum_with_dumping, 7, (0,), 11)

    def call(G, q, T, k, P, omega, Q, t, out=None):
        if out is None:
            if float is type(G) is type(q) is type(T) is type(k) is type(P) is type(omega) is type(Q) is type(t):
                try:
                    return formula(G, q, T, k, P, omega, Q, t)
                except UNDEFINED:
                    pass
            elif ndarray is type(G) is type(q) is type(T) is type(k) is type(P) is type(omega) is type(Q) is type(t) and DOUBLE is G.dtype is q.dtype is T.dtype is k.dtype is P.dtype is omega.dtype is Q.dtype is t.dtype and () != G.shape == q.shape == T.shape == k.shape == P.shape == omega.shape == Q.shape == t.shape:
                if 11 < G.size <= SMALL:
                    return _momentum_with_dumping(G, q, T, k, P, omega, Q, t)
                return alike(G, q, T, k, P, omega, Q, t)
        return others((G, q, T, k, P, omega, Q, t,), out)

    return call


def _momentum_with_dumping(G, q, T, k, P, omega, Q, t, out_D=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, r6=None, n1=array(1.0), n1_2=array(1.0 / 2.0), n2=array(2.0)):
    r0 = multiply(omega, t, r0)  # t1
    r1 = multiply(k, k, r1)  # k_squared
    r2 = multiply(omega, omega, r2)  # omega_squared
    r2 = add(r1, r2, r2)  # t2
    r2 = divide(n1, r2, r2)  # t3
    r1 = multiply(G, q, r1)  # t4
    r3 = multiply(T, q, r3)  # t5
    r3 = divide(r3, k, r3)  # t6
    r4 = multiply(n1_2, r0, r4)  # t7
    r4 = sin(r4, r4)  # t8
    r4 = multiply(r4, r4, r4)  # t9
    r4 = multiply(n2, r4, r4)  # t10
    r4 = subtract(q, r4, r4)  # t11
    r5 = multiply(P, k, r5)  # t12
    r6 = multiply(Q, omega, r6)  # t13
    r6 = subtract(r5, r6, r6)  # t14
    r4 = multiply(r4, r2, r4)  # t15
    r4 = multiply(r6, r4, r4)  # t16
    r6 = multiply(P, omega, r6)  # t17
    r5 = multiply(Q, k, r5)  # t18
    r5 = add(r6, r5, r5)  # t19
    r0 = sin(r0, r0)  # t20
    r2 = multiply(r5, r2, r2)  # t21
    r2 = multiply(r0, r2, r2)  # t22
    r3 = add(G, r3, r3)  # t23
    r3 = add(r4, r3, r3)  # t24
    r3 = add(r2, r3, r3)  # t25
    out_D = subtract(r3, r1, out_D)  # t26
    return out_D


def natural_frequency_of_an_ellipsoid(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _natural_frequency_of_an_ellipsoid, 2, (0,), 1)

    def call(a, Omega, c, out=None):
        if out is None:
            if float is type(a) is type(Omega) is type(c):
                try:
                    return formula(a, Omega, c)
                except UNDEFINED:
                    pass
            elif ndarray is type(a) is type(Omega) is type(c) and DOUBLE is a.dtype is Omega.dtype is c.dtype and () != a.shape == Omega.shape == c.shape:
                if 1 < a.size <= SMALL:
                    return _natural_frequency_of_an_ellipsoid(a, Omega, c)
                return alike(a, Omega, c)
        return others((a, Omega, c,), out)

    return call


def _natural_frequency_of_an_ellipsoid(a, Omega, c, out_lambda=None, r0=None, r1=None, n2=array(2.0)):
    r0 = multiply(a, a, r0)  # a_squared
    r1 = multiply(c, c, r1)  # c_squared
    r1 = add(r0, r1, r1)  # t1
    r0 = multiply(Omega, r0, r0)  # t2
    r0 = multiply(n2, r0, r0)  # t3
    out_lambda = divide(r0, r1, out_lambda)  # t4
    return out_lambda


def mode_inertia_of_an_ellipsoid(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _mode_inertia_of_an_ellipsoid, 4, (0,), 2)

    def call(m, a, c, out=None):
        if out is None:
            if float is type(m) is type(a) is type(c):
                try:
                    return formula(m, a, c)
                except UNDEFINED:
                    pass
            elif ndarray is type(m) is type(a) is type(c) and DOUBLE is m.dtype is a.dtype is c.dtype and () != m.shape == a.shape == c.shape:
                if 2 < m.size <= SMALL:
                    return _mode_inertia_of_an_ellipsoid(m, a, c)
                return alike(m, a, c)
        return others((m, a, c,), out)

    return call


def _mode_inertia_of_an_ellipsoid(m, a, c, out_E=None, r0=None, r1=None, r2=None, r3=None, n5=array(5.0), n4=array(4.0)):
    r0 = multiply(a, a, r0)  # a_squared
    r1 = multiply(c, c, r1)  # c_squared
    r2 = multiply(n5, r0, r2)  # t1
    r3 = multiply(n5, r1, r3)  # t2
    r3 = add(r2, r3, r3)  # t3
    r1 = multiply(r0, r1, r1)  # t4
    r1 = multiply(m, r1, r1)  # t5
    r1 = multiply(n4, r1, r1)  # t6
    out_E = divide(r1, r3, out_E)  # t7
    return out_E


def mode_inertia_of_a_cylinder(formula):
    """The function of numbers and arrays that a formula becomes."""
    alike, others = on_arrays(formula, _mode_inertia_of_a_cylinder, 6, (0,), 8)

    def call(m, tau, c, k, a, out=None):
        if out is None:
            if float is type(m) is type(tau) is type(c) is type(k) is type(a):
                try:
                    return formula(m, tau, c, k, a)
                except UNDEFINED:
                    pass
            elif ndarray is type(m) is type(tau) is type(c) is type(k) is type(a) and DOUBLE is m.dtype is tau.dtype is c.dtype is k.dtype is a.dtype and () != m.shape == tau.shape == c.shape == k.shape == a.shape:
                if 8 < m.size <= SMALL:
                    return _mode_inertia_of_a_cylinder(m, tau, c, k, a)
                return alike(m, tau, c, k, a)
        return others((m, tau, c, k, a,), out)

    return call


def _mode_inertia_of_a_cylinder(m, tau, c, k, a, out_E_1=None, r0=None, r1=None, r2=None, r3=None, r4=None, r5=None, n2=array(2.0), n4=array(4.0)):
    r0 = multiply(c, c, r0)  # c_squared
    r1 = multiply(k, k, r1)  # k_squared
    r2 = multiply(r1, r1, r2)  # k_squared_squared
    r3 = multiply(tau, tau, r3)  # tau_squared
    r4 = subtract(n2, tau, r4)  # t1
    r5 = multiply(a, a, r5)  # a_squared
    r1 = multiply(r5, r1, r1)  # t2
    r1 = multiply(n2, r1, r1)  # t3
    r1 = add(n2, r1, r1)  # t4
    r1 = subtract(r1, tau, r1)  # t5
    r5 = add(n2, tau, r5)  # t6
    r3 = multiply(m, r3, r3)  # t7
    r3 = multiply(r5, r3, r3)  # t8
    r3 = multiply(n4, r3, r3)  # t9
    r2 = multiply(r0, r2, r2)  # t10
    r2 = multiply(r4, r2, r2)  # t11
    r1 = multiply(r2, r1, r1)  # t12
    out_E_1 = divide(r3, r1, out_E_1)  # t13
    return out_E_1
