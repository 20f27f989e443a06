"""What changes under integrals, sums and derivatives, and what is said of a function at one place alone."""

from __future__ import annotations

import pytest

from symcheck import decide
from symcheck.question.answer import Status

BOYLE, CIRCLE, SPRING = "pV = nRT", r"\frac{x^2}{a^2} + \frac{y^2}{b^2} = 1", "F - kx = 0"
CARDIOID = r"r = a(1 + \cos\theta)"
PROVED = (  # what is defined changes with the letter that runs
    (r"\int_0^L F\,dx = \frac12 k L^2", ("F = kx",)),
    (r"\int_0^x F\,dx = \frac12 F x", ("F = kx",)),
    (r"\int_0^T v\,dt = \frac12 g T^2", ("a = g", "v = at")),
    (r"\frac12\int_0^{2\pi} r^2\,d\theta = \frac{3\pi a^2}{2}", (CARDIOID,)),
    (r"\int_0^1\int_0^1 f\,dx\,dy = \frac14", ("f = xy",)),
    (r"\int_0^R 4\pi r^2\rho\,dr = \pi\rho_0 R^3", (r"\rho = \rho_0\frac{r}{R}",)),
    (r"\int_0^R 4\pi r^2\rho\,dr = \frac43\pi R^3\rho", (r"\rho = \frac{3M}{4\pi R^3}",)),
    (r"\int_0^\infty y e^{-x}\,dx = \frac12", ("2y = x",)),
    (r"\int p\,dV = nRT\ln V + C", (BOYLE, "V > 0")),
    (r"\left. y\right|_{x=0} = 1", ("y = 1 + x",)),
    (r"\left.\mathbf r\right|_{t=0} = 0", (r"\mathbf r = \mathbf v t",)),
    (r"\frac{\partial z}{\partial x} = 1 + \frac{x}{r}", ("z = x + r", r"r = \sqrt{x^2 + y^2}")),
    (r"\int_0^1 x\,dx = \frac12", ("x = 2",)),
    (r"\int_0^1 y\,dy = \frac12", ("y = x^2",)),
    (r"\int_0^L u'(x)\,dx = 0", ("u(0) = 0", "u(L) = 0")),
    ("y(x) = x^2", ("y(s) = s^2",)),
    (r"x(0) = A", (r"x(t) = A\cos\phi", r"\phi = \omega t")),
    (r"\psi(0) = 0", (r"\theta = kx", r"\psi(x) = A\sin\theta")),
    ("f(3) = 18", ("f(x) = a x", "a = 2x")),
    (r"\int_0^1 f(s)\,ds = \frac23", ("f(x) = a x", "a = 2x")),
    ("u(0, t) = -\\sin(ct)", (r"u(x, t) = \sin\xi", r"\xi = x - ct")),
    ("E(2v) = 4 E(v)", (r"E(v) = \frac12 p v", "p = mv")),
    ("a_{n+1} = (n + 1)(n + 2)", ("a_n = b n", "b = n + 1")),
    ("f(2) = 2 f(1)", ("f(x) = u x",)),
    (r"F(t) = \frac{t^2}{2}", (r"F(x) = \int_0^x t\,dt",)),
    (r"F'(t) = \frac32 t^2", (r"F(x) = \int_0^x t x\,dt",)),
    (r"c = \frac{V_0}{R}", (r"\phi(R) = V_0", r"\phi(r) = cr", "R > 0")),
)
REFUTED = (
    (r"\int_0^L F\,dx = k L^2", ("F = kx",)),
    (r"\int_0^x F\,dx = F x", ("F = kx",)),
    (r"\int_0^T v\,dt = g T^2", ("a = g", "v = at")),
    (r"\frac12\int_0^{2\pi} r^2\,d\theta = \frac{\pi a^2}{2}", (CARDIOID,)),
    (r"\int_0^R 4\pi r^2\rho\,dr = \frac43\pi R^3\rho", (r"\rho = \rho_0\frac{r}{R}",)),
    (r"\int_0^\infty y e^{-x}\,dx = 1", ("2y = x",)),
    (r"\int F\,dx = Fx + C", ("F = kx",)),
    (r"\left. y\right|_{x=0} = y", ("y = 1 + x",)),
    (r"\frac{\partial z}{\partial x} = 1 - \frac{x}{r}", ("z = x + r", r"r = \sqrt{x^2 + y^2}")),
    (r"x(0) = A\cos\phi", (r"x(t) = A\cos\phi", r"\phi = \omega t")),
    ("f(0) = u^2", ("f(x) = u^2", "u = x + x^2")),
    (r"\int_0^1 f(s)\,ds = \frac{a}{2}", ("f(x) = a x", "a = 2x")),
    ("E(2v) = 2 E(v)", (r"E(v) = \frac12 p v", "p = mv")),
    ("a_{n+1} = b(n + 1)", ("a_n = b n", "b = n + 1")),
    ("f(2x) = 2 f(x)", ("2 f(x) = u x", "u = x + 1")),
    ("c = V_0 R", (r"\phi(R) = V_0", r"\phi(r) = cr", "R > 0")),
)
UNDECIDED = (  # true and false ones
    (r"\int_{V_1}^{V_2} p\,dV = nRT\ln\frac{V_2}{V_1}", (BOYLE, "V_1 > 0, V_2 > 0"), "does p depend on V"),
    (r"\int_{V_1}^{V_2} p\,dV = p(V_2 - V_1)", (BOYLE, "V_1 > 0, V_2 > 0"), "does p depend on V"),
    (r"\int_0^L F\,dx = F L", (SPRING,), "does F depend on x"),
    (r"\int_0^a y\,dx = y a", (CIRCLE, "a > 0, b > 0"), "does y depend on x"),
    (r"\int F\,dx = Fx + C", (SPRING,), "does F depend on x"),
    (r"\left. y\right|_{x=0} = y", ("y - x = 1",), "does y depend on x"),
    (r"\left. y\right|_{x=2} = y", ("2y = x",), "does y depend on x"),
    (r"\lim_{t \to 0} v = c u", ("v = c u", "2u = t"), "do other letters depend on t"),
    (r"\int_0^1 x\,dy = x", ("y = 3x",), "does x depend on y"),
    (r"\int_0^1 \frac{u}{v}\,dy = \frac{u}{v}", ("\\frac{u}{v} = y",), "which of u, v depends on y"),
    (r"\int_0^{2\pi} \omega\,d\theta = 2\pi\omega", (r"\theta = \omega t",), "does omega depend on theta"),
    (r"\frac{d}{dx}(xy) = y", ("y - x^2 = 0",), "does y depend on x"),
    (r"\frac{d}{dt}(mv) = m\dot v", ("m + kt = m_0",), "what is assumed of {'m'} is not only so at one point"),
    (r"\dot p = m\dot v", ("m + kt = m_0", "p = mv"), "does m depend on t"),
    (r"\frac{\partial z}{\partial x} = 1 + 2x", ("z = x + y", "y = x^2"), "is y held constant"),
    (r"\frac{\partial z}{\partial x} = 1", ("z = x + y", "y = x^2"), "is y held constant"),
    (r"\frac{dz}{dx} = \frac{\partial z}{\partial x}", ("z = x + y", "y = a x^2"), "is y held constant"),
    (r"\int_0^L F\,dx = \frac12 F L", ("F = kx",), "is F outside of the integral meant at one of its ends"),
    ("f(1) = u^2", ("f(x) = u^2", "u - x - x^2 = 0"), "does u depend on x"),
    ("f(2) = 2 f(1)", ("f(x) = u x", "u - x = 1"), "does u depend on x"),
    ("a_{n+1} = b(n + 1)", ("a_n = b n", "b - n = 1"), "not only so at one point"),
    (r"g(t) = \frac13", (r"g(x) = \int_0^1 x t\,dt",), "t runs in what g is"),
    (r"\int_0^L u(x)\,dx = 0", ("u(0) = 0", "u(L) = 0"), ""),
    ("u'(x) = 0", ("u(L) = 0",), "not only so at one point"),
    ("u'(L) = 0", ("u(L) = u_0",), "not only so at one point"),
    ("F'(x_0) = 0", ("F(x_0) = 0",), "not only so at one point"),
    (r"\dot x(t) = 0", ("x(T) = x_0",), "not only so at one point"),
    ("q = 0", ("q = -k T'(x)", "T(L) = T_0"), "not only so at one point"),
)


def _said(conditions: tuple[str, ...]) -> tuple[list[str], list[str]]:
    """Equations, and the conditions that are none."""
    given = [each for each in conditions if ">" in each]
    return [each for each in conditions if each not in given], given


@pytest.mark.parametrize(("relation", "conditions"), PROVED)
def test_definitions_hold_for_all_values_of_the_letter_that_runs(relation: str, conditions: tuple[str, ...]) -> None:
    where, given = _said(conditions)
    assert decide(relation, where=where, given=given).verdict is Status.PROVED


@pytest.mark.parametrize(("relation", "conditions"), REFUTED)
def test_what_is_false_of_all_values_of_the_letter_that_runs_is_refuted(
    relation: str, conditions: tuple[str, ...]
) -> None:
    where, given = _said(conditions)
    assert decide(relation, where=where, given=given).verdict is Status.REFUTED


@pytest.mark.parametrize(("relation", "conditions", "reason"), UNDECIDED)
def test_what_may_be_constant_or_hold_at_one_place_is_not_decided(
    relation: str, conditions: tuple[str, ...], reason: str
) -> None:
    where, given = _said(conditions)
    answer = decide(relation, where=where, given=given)
    assert answer.verdict in (Status.UNDECIDED, Status.AMBIGUOUS)
    assert reason in answer.reason


@pytest.mark.parametrize("relation", [r"\int_0^1 F\,dx = F", r"\frac{d}{dx}(xF) = F"])
def test_conditions_tie_letters_as_earlier_equations_do(relation: str) -> None:
    answer = decide(relation, given=["F = kx"])
    assert answer.verdict is Status.UNDECIDED
    assert "does F depend on x" in answer.reason
