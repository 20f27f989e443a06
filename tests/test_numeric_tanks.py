"""The modes of a liquid that fills a tank, against the equations of its motion and what is known of it."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.special import ive, jv, jvp

from symcheck.numeric import liquid
from symcheck.numeric.domain import Array


def test_a_shell_without_mass_is_unstable_exactly_between_one_and_three() -> None:
    shapes = np.array([0.3, 0.9, 0.999, 1.001, 1.5, 2.0, 2.9, 2.999, 3.001, 4.0, 10.0])
    found = liquid.liquid_in_an_ellipsoid(1.0, 1.0, shapes, 1.0)
    stable = liquid.is_stable(found.A, found.C, found.E_n, found.lambda_n, 1.0)
    assert stable.tolist() == [not 1 < shape < 3 for shape in shapes]  # Kelvin


def test_in_a_sphere_the_liquid_does_not_follow_the_wall() -> None:
    found = liquid.liquid_in_an_ellipsoid(2.0, 0.5, 0.5, 3.0)
    assert found.E_n == pytest.approx(0.4 * 2.0 * 0.25)
    assert found.lambda_n == pytest.approx(3.0)
    body = 0.7  # transverse, that of the shell: with the liquid its frequency is that of the shell alone
    eta = liquid.frequencies(body + found.A, 0.9 + found.C, found.E_n, found.lambda_n, 3.0)
    assert np.sort(eta.real) == pytest.approx(np.sort([3.0, -(0.9 - body) * 3.0 / body]))
    assert eta.imag == pytest.approx(0, abs=1e-7)


def test_the_frequencies_are_those_of_the_equations_of_motion() -> None:
    """Body and liquid of uniform vorticity, nonlinear, begun with a small motion of one frequency."""
    m, a, c, spin, body = 1.0, 1.0, 1.8, 1.0, np.array([0.8, 0.8, 1.5])
    tank = liquid.liquid_in_an_ellipsoid(m, a, c, spin)
    A, C = body[0] + tank.A, body[2] + tank.C
    expected = liquid.stability(A, C, tank.E_n, tank.lambda_n, spin)
    frozen = body + np.array([tank.A, tank.A, tank.C])
    coupling = 2 * m * a * c / 5 * np.array([1, 1, a / c])  # momentum of the relative motion for q
    curl = np.array([(a * a + c * c) / (a * c), (a * a + c * c) / (a * c), 2.0])

    def change(_: float, state: Array) -> Array:
        w, q = state[:3], state[3:]
        total = frozen * w + coupling * q
        vorticity = curl * q + 2 * w
        gradient = np.array(  # of the relative velocity: row i of component i
            [[0, -q[2], a * q[1] / c], [q[2], 0, -a * q[0] / c], [-c * q[1] / a, c * q[0] / a, 0]]
        )
        torque, stretched = -np.cross(w, total), gradient @ vorticity
        # frozen w' + coupling q' = torque, 2 w' + curl q' = stretched
        rate = (torque - coupling * stretched / curl) / (frozen - 2 * coupling / curl)
        return np.concatenate([rate, (stretched - 2 * rate) / curl])

    times = np.linspace(0, 200, 4001)
    start = np.array([1e-7, 0, spin, 0, 0.5e-7, 0])
    solved = solve_ivp(change, (0, 200), start, "DOP853", times, rtol=1e-12, atol=1e-18).y
    transverse = solved[0] - 1j * solved[1]  # turns with e^(i eta t)
    basis = np.exp(1j * np.outer(times, expected.frequencies))
    _, residual, *_ = np.linalg.lstsq(basis, transverse, rcond=None)
    assert np.sqrt(residual[0]) < 1e-6 * np.linalg.norm(transverse)


def test_a_body_with_its_liquid_has_the_moments_of_both() -> None:
    tanks = liquid.liquid_in_an_ellipsoid(1.0, 1.0, [1.5, 2.0, 4.0], 1.0)
    whole = liquid.with_body([[0.1], [0.2]], 0.3, tanks)
    assert whole.A.shape == whole.C.shape == (2, 3)
    assert whole.E_n.shape == whole.lambda_n.shape == (2, 3, 1)
    np.testing.assert_allclose(whole.A[1], 0.2 + tanks.A)
    assert liquid.is_stable(*whole, 1.0).shape == (2, 3)


def waves(a: float, c: float, modes: int) -> list[tuple[float, float, float]]:
    """k, x and tau of the modes that `liquid_in_a_cylinder` keeps, from what they satisfy."""
    found = []
    for tau in liquid.liquid_in_a_cylinder(1.0, a, 2 * c, 1.0, modes=modes).lambda_n:
        fits = [
            (abs(x * jvp(1, x) + 2 / tau * jv(1, x)), k, x)
            for k in np.arange(1, 40, 2) * np.pi / 2 / c
            for x in [k * a * np.sqrt(4 - tau**2) / abs(tau)]
        ]
        _, k, x = min(fits)
        found.append((k, x, float(tau)))
    return found


def test_the_modes_of_a_cylinder_carry_what_their_velocities_carry() -> None:
    a, c, modes = 0.7, 0.9, 6
    found = liquid.liquid_in_a_cylinder(1.0, a, 2 * c, 1.0, modes=modes)
    assert (np.diff(found.E_n) <= 0).all()
    for carried, wave in zip(found.E_n, waves(a, c, modes), strict=True):
        assert by_quadrature(a, c, *wave) == pytest.approx(carried, rel=1e-8)


def by_quadrature(a: float, c: float, k: float, x: float, tau: float) -> float:
    """What a mode carries, from the velocities that belong to its pressure."""
    kappa, d = x / a, 4 - tau**2

    def velocity(r: float) -> tuple[float, float]:
        p, slope = jv(1, kappa * r), kappa * jvp(1, kappa * r)
        return -(tau * slope + 2 * p / r) / d, (tau * p / r + 2 * slope) / d

    assert velocity(a)[0] == pytest.approx(0, abs=1e-10)  # no flow through the wall
    cosine, lever = c, 2 * np.sin(k * c) / k**2  # integrals of sin^2 = cos^2, and of z sin(kz)
    radial = quad(lambda r: r * (velocity(r)[0] ** 2 + velocity(r)[1] ** 2), 0, a)[0]
    axial = quad(lambda r: r * (k / tau * jv(1, kappa * r)) ** 2, 0, a)[0]
    norm = 2 * np.pi * cosine * (radial + axial)
    across = quad(lambda r: r * (velocity(r)[0] - velocity(r)[1]), 0, a)[0] * lever
    along = quad(lambda r: r * r * jv(1, kappa * r), 0, a)[0] * 2 * np.sin(k * c) / tau
    density = 1 / (2 * np.pi * a * a * c)
    return float(2 * density * (np.pi * (across - along)) ** 2 / norm)


def at_rest(a: float, c: float) -> float:
    """The moment of inertia of a liquid of the mass 1 at rest in space, in a cylinder that begins to turn across."""
    density = 1 / (2 * np.pi * a * a * c)
    moment = density * np.pi * a * a * 2 * c * (a * a / 4 - c * c / 3)
    for j in range(1, 200):
        k = (2 * j - 1) * np.pi / (2 * c)
        sine, x = np.sin(k * c), k * a
        strength = -4 * sine / (k * k * c) / (k * (ive(0, x) - ive(1, x) / x))
        moment += density * strength * np.pi * 2 * sine * (a * a * ive(2, x) / k - a * ive(1, x) / k**2)
    return float(moment)


@pytest.mark.parametrize("c", [0.5, 1.3, 3.0])
def test_all_modes_of_a_cylinder_carry_what_a_liquid_at_rest_does_not(c: float) -> None:
    found = liquid.liquid_in_a_cylinder(1.0, 1.0, 2 * c, 1.0, modes=50)
    missing = found.A - at_rest(1.0, c) - found.E_n.cumsum()
    assert 0 < missing[-1] < 0.06 * found.A  # what the further modes carry
    # that of the modes after the nth goes down like 1/n: their sum is the one of a liquid at rest
    assert missing[49] / missing[24] == pytest.approx(0.5, abs=0.1)


def test_what_does_not_fit_is_named() -> None:
    with pytest.raises(ValueError, match=r"mass = 0.*positive"):
        liquid.liquid_in_an_ellipsoid(0.0, 1.0, 1.0, 1.0)
    with pytest.raises(ValueError, match="modes = 0"):
        liquid.liquid_in_a_cylinder(1.0, 1.0, 1.0, 1.0, modes=0)
    with pytest.raises(ValueError, match=r"radius.*call once for each"):
        liquid.liquid_in_a_cylinder(1.0, [1.0, 2.0], 1.0, 1.0)
