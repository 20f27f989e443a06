"""What authors rely on without a word: lengths beside bold letters, Lagrange functions, signs of several fields.

Each of these was once decided wrongly, or is the counterpart of one that was.
"""

from __future__ import annotations

import pytest
from _pytest.mark import ParameterSet

from symcheck import decide
from symcheck.question import ask, repairs
from symcheck.question.ask import answered


@pytest.fixture(autouse=True)
def _little_time_for_repairs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Most verdicts do not depend on repairs, which take up to six seconds for each formula that is refuted."""
    monkeypatch.setattr(repairs, "SECONDS", 1.0)


LAGRANGE = [r"L = \frac12 m \dot q^2 - V(q)"]
PENDULUM = [r"L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta"]
LORENTZ = [r"x' = \gamma(x - vt)", r"t' = \gamma(t - vx/c^2)", r"\gamma = \frac{1}{\sqrt{1 - v^2/c^2}}"]
ORBIT = [r"\ddot{\mathbf r} = -\frac{\mu}{r^3}\mathbf r", r"\mathbf v = \dot{\mathbf r}"]
KEPLER = [r"r = \frac{a(1 - e^2)}{1 + e\cos\nu}", r"\cos\nu = \frac{\cos E - e}{1 - e\cos E}"]
WAVE = [r"\psi = e^{i(kx - \omega t)}", r"\hbar\omega = \frac{\hbar^2 k^2}{2m}"]
TURN = r"R = \begin{pmatrix} \cos\theta & -\sin\theta \\ \sin\theta & \cos\theta \end{pmatrix}"
LYAPUNOV = [
    r"A = \begin{bmatrix} 0 & 1 \\ -1 & -1 \end{bmatrix}",
    r"P = \begin{bmatrix} 3/2 & 1/2 \\ 1/2 & 1 \end{bmatrix}",
    r"Q = \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}",
]
PAULI = [
    r"\sigma_x = \begin{pmatrix} 0 & 1 \\ 1 & 0 \end{pmatrix}",
    r"\sigma_y = \begin{pmatrix} 0 & -i \\ i & 0 \end{pmatrix}",
    r"\sigma_z = \begin{pmatrix} 1 & 0 \\ 0 & -1 \end{pmatrix}",
]

VERDICTS: dict[str, list[tuple[str, list[str]]]] = {
    "proved": [
        ("(AB)^T = B^T A^T", []),
        ("x^T A x = x^T A^T x", []),
        ("R^{-1} = R^T", [TURN]),
        (r"A^T P + P A = -Q", LYAPUNOV),
        (r"\sigma_x \sigma_y = i\sigma_z", PAULI),
        (r"\dot R = R S", [TURN, r"S = \begin{pmatrix} 0 & -\dot\theta \\ \dot\theta & 0 \end{pmatrix}"]),
        (r"u'' + u = \frac{\mu}{h^2}", [r"u = \frac{\mu}{h^2}(1 + e\cos\theta)"]),
        ("c_1 = a_2 b_3 - a_3 b_2", [r"\mathbf{c} = \mathbf{a}\times\mathbf{b}"]),
        (r"\frac{\partial L}{\partial \dot q} = m \dot q", LAGRANGE),
        (r"\frac{\partial L}{\partial q} = -V'(q)", LAGRANGE),
        (r"\frac{d}{dt} \frac{\partial L}{\partial \dot q} = m \ddot q", LAGRANGE),
        (r"\frac{\partial L}{\partial q} = -k q", ["L = T - V", r"T = \frac12 m \dot q^2", r"V = \frac12 k q^2"]),
        (
            r"\frac{d}{dt}\frac{\partial L}{\partial\dot\theta} - \frac{\partial L}{\partial\theta} = "
            r"m l^2 \ddot\theta + m g l \sin\theta",
            PENDULUM,
        ),
        (r"f(x) = x/2", ["2f(x) = x"]),
        (r"\mathbf{a}\times(\mathbf{a}\times\mathbf{r}) = \mathbf{a}(\mathbf{a}\cdot\mathbf{r}) - a^2\mathbf{r}", []),
        (r"\mathbf{r}\cdot\dot{\mathbf{r}} = r\dot{r}", []),
        (r"\sin x = x - \frac{x^3}{6} + O(x^5)", []),
        (r"\tan x = x + \frac{x^3}{3} + \mathcal{O}(x^5)", []),
        (r"\sin x = x + o(x^2)", []),
        (r"f(x + h) = f(x) + h f'(x) + O(h^2)", []),
        (r"T = a(1 + k^2/4 + O(k^4))", [r"T = a \sqrt{1 + k^2/2}"]),
        (r"d(x y) = x\,dy + y\,dx", []),
        (r"\lim_{x \to 0} \frac{\sin a x}{\sin b x} = \frac{a}{b}", []),
        (r"\lim_{h \to 0} \frac{f(x + h) - f(x)}{h} = f'(x)", []),
        (r"\frac{d}{dx} (x e^x) = (x + 1) e^x", []),
        (r"\frac{d e^x}{dx} = e^x", []),
        (r"\frac{d}{dx} e^{ix} = i e^{ix}", []),
        (r"\lim_{x \to 1} \frac{x^2 - 1}{x - 1} = 2", []),
        (r"\lim_{x \to \infty} \frac{2x^2 + 1}{x^2 - x} = 2", []),
        (r"\lim_{s \to 0} s G(s) = \frac{K}{a}", [r"G(s) = \frac{K}{s(s + a)}"]),
        (r"2 \lim_{x \to 0} \frac{1 - \cos x}{x^2} = 1", []),
        (r"\lim_{n \to \infty} (1 + x/n)^n = e^x", []),
        (r"\lim_{x \to 0} (\cos x)^{1/x^2} = e^{-1/2}", []),
        (r"\lim_{x \to 0} \frac{\sin a x}{x} = a \lim_{x \to 0} \frac{\tan x}{x}", []),
        (r"\frac{1}{\lim_{s \to 0} s^2 G(s)} = \frac{1}{K}", [r"G(s) = \frac{K (b s + 1)}{s^2 (a s + 1)}"]),
        (r"\int_0^R \int_0^\pi \int_0^{2\pi} r^2 \sin\theta \,d\phi \,d\theta \,dr = \frac43 \pi R^3", []),
        (r"\int_{-1}^1 \int_0^{\sqrt{1 - x^2}} y \,dy \,dx = \frac23", []),
        (r"dr = \frac{x dx + y dy}{r}", [r"r = \sqrt{x^2 + y^2}"]),
        (r"d\bar z = dx - i\,dy", ["z = x + iy"]),
        (r"|dz|^2 = dx^2 + dy^2", ["z = x + iy"]),
        (r"\mathbf{r}\cdot d\mathbf{r} = r\,dr", []),
        (r"dG = V dp - S dT", ["G = H - TS", "H = U + pV", "dU = T dS - p dV"]),
        (r"x\dot{x} + y \dot{y} = 0", ["x^2 + y^2 = l^2"]),
        (
            r"\dot{\mathbf{R}}^T \mathbf{R} + \mathbf{R}^T \dot{\mathbf{R}} = 0",
            [r"\mathbf{R}^T \mathbf{R} = \mathbf{I}"],
        ),
        (r"x\,dx + y\,dy = r\,dr", ["x^2 + y^2 = r^2"]),
        (r"m\,dv = F\,dt", [r"\frac{dv}{dt} = \frac{F}{m}"]),
        (r"dz = \frac{\partial z}{\partial x} dx + \frac{\partial z}{\partial y} dy", []),
        (r"\operatorname{Im} z = y", ["z = x + iy"]),
        (r"\dot{r} = \frac{\mathbf{r}\cdot\mathbf{v}}{r}", [r"\mathbf{v} = \dot{\mathbf{r}}"]),
        (r"\frac{d}{dt}\frac{1}{r} = -\frac{\mathbf{r}\cdot\dot{\mathbf{r}}}{r^3}", []),
        (r"\mathbf{u}^2 = \mathbf{u}\cdot\mathbf{u}", []),
        (r"[\mathbf{a}]_\times \mathbf{b} = \mathbf{a}\times\mathbf{b}", []),
        (r"[\mathbf{a}]_{\times}^2 = \mathbf{a}\mathbf{a}^T - \|\mathbf{a}\|^2 \mathbf{I}", []),
        (r"|z|^2 = z \bar z", []),
        (r"|z|^2 = x^2 + y^2", ["z = x + iy"]),
        (r"z + \bar z = 2x", ["z = x + iy"]),
        (r"\overline{z} = x - iy", ["z = x + iy"]),
        (r"z z^* = x^2 + y^2", [r"z = x + \mathrm{i} y"]),
        (r"w = z^2", ["w = u + iv", "z = x + iy", "u = x^2 - y^2", "v = 2xy"]),
        (r"u = x^2 - y^2", ["u + iv = (x + iy)^2"]),
        (r"(\cos\theta + i\sin\theta)^3 = \cos 3\theta + i \sin 3\theta", []),
        (r"z - \bar z = 2i \operatorname{Im} z", []),
        (r"i^2 = -1", []),
        ("(AB)^{-1} = B^{-1} A^{-1}", []),
        ("A(B + C) = AB + AC", []),
        ("PV = nRT", ["P = nRT/V"]),
        (
            r"\dot{\mathbf L} = \mathbf r\times \mathbf F",
            [
                r"\mathbf L = \mathbf r\times \mathbf p",
                r"\dot{\mathbf p} = \mathbf F",
                r"\dot{\mathbf r} = \mathbf p/m",
            ],
        ),
        ("y'' + y = 0", [r"y = \sin x"]),
        (r"\frac{d}{dt}\left(\frac{v^2}{2} - \frac{\mu}{r}\right) = 0", ORBIT),
        (r"\frac{d}{dt}(\mathbf r\times\dot{\mathbf r}) = 0", ORBIT),
        (r"r = a(1 - e\cos E)", KEPLER),
        (r"\ddot{x} = -\omega^2 x", [r"x = A e^{i\omega t}"]),
        (r"i\hbar\frac{\partial\psi}{\partial t} = -\frac{\hbar^2}{2m}\frac{\partial^2\psi}{\partial x^2}", WAVE),
        (r"\frac{d}{dx}\left(\frac{f}{g}\right) = \frac{f'g - fg'}{g^2}", []),
        ("y'' + 2y' + y = 0", ["y = (a + bt)e^{-t}"]),
        ("u_{xx} + u_{yy} = 0", ["u = x^2 - y^2"]),
        ("u_x = v_y", ["u = x^2 - y^2", "v = 2xy"]),
        ("u_{tt} = c^2 u_{xx}", ["u(x,t) = f(x-ct) + g(x+ct)"]),
        ("x'^2 - c^2 t'^2 = x^2 - c^2 t^2", LORENTZ),
    ],
    "refuted": [
        (r"\sin x = 2x + O(x^3)", []),
        (r"\left(\sum_{i=1}^n a_i\right)^2 = n \sum_{i=1}^n a_i^2", []),
        (r"\lim_{x \to 0} \frac{\sin a x}{\sin b x} = \frac{b}{a}", []),
        (r"\lim_{x \to 0} \frac{1 - \cos x}{x^2} = 1", []),
        (r"\lim_{x \to 0} \frac{1}{x} = 0", []),
        (r"1 + \lim_{x \to 0} \frac{\sin x}{x} = 1", []),
        (r"\lim_{n \to \infty} (1 + x/n)^n = e^{2x}", []),
        (r"\lim_{x \to 0} (\cos x)^{1/x^2} = e^{1/2}", []),
        (r"\frac{1}{\lim_{s \to 0} s^{-2} G(s)} = \frac{1}{K}", [r"G(s) = \frac{K (b s + 1)}{s^2 (a s + 1)}"]),
        (r"\lim_{x \to \infty} \frac{2x^2 + 1}{x - 1} = 2", []),
        (r"\int_0^1 \int_0^x y \,dy \,dx = \frac13", []),
        (r"\sin x = x + o(x^3)", []),
        (r"f(x + h) = f(x) + 2 h f'(x) + O(h^2)", []),
        (r"d(x y) = x\,dy - y\,dx", []),
        (r"d\bar z = dx + i\,dy", ["z = x + iy"]),
        (r"dF = S dT - p dV", ["F = U - TS", "dU = T dS - p dV"]),
        (r"dE = 2 m v\,dv", [r"E = \frac12 m v^2"]),
        (r"|\mathbf{a} + \mathbf{b}| = 2", [r"|\mathbf{a}| = 1", r"|\mathbf{b}| = 1"]),
        ("(AB)^T = A^T B^T", []),
        ("A^T B = B^T A", []),
        (r"\det R = -1", [TURN]),
        (r"A^T P + P A = Q", LYAPUNOV),
        (r"\dot R = -R S", [TURN, r"S = \begin{pmatrix} 0 & -\dot\theta \\ \dot\theta & 0 \end{pmatrix}"]),
        (r"u'' - u = \frac{\mu}{h^2}", [r"u = \frac{\mu}{h^2}(1 + e\cos\theta)"]),
        ("c_1 = a_3 b_2 - a_2 b_3", [r"\mathbf{c} = \mathbf{a}\times\mathbf{b}"]),
        (r"r = a(1 + e\cos E)", KEPLER),
        (r"\ddot{x} = \omega^2 x", [r"x = A e^{i\omega t}"]),
        (r"x_1 + x_2 = \frac{b}{a}", ["ax^2 + bx + c = a(x - x_1)(x - x_2)"]),
        ("y'' - y = 0", [r"y = \sin x"]),
        ("y' = 2xy", ["y = C e^{-x^2}"]),
        ("u_{xx} + u_{yy} = 0", ["u = x^2 + y^2"]),
        ("x'^2 + c^2 t'^2 = x^2 + c^2 t^2", LORENTZ),
        (r"|z|^2 = x^2 - y^2", ["z = x + iy"]),
        (r"z \bar z = x^2 - y^2", ["z = x + iy"]),
        (r"|z| = x", ["z = x + iy"]),
        (r"z - \bar z = 2 \operatorname{Im} z", []),
        (r"\frac{1}{a+ib} = \frac{a+ib}{a^2+b^2}", []),
        (r"\frac{\partial L}{\partial q} = V'(q)", LAGRANGE),
        (
            r"\frac{d}{dt}\frac{\partial L}{\partial\dot\theta} - \frac{\partial L}{\partial\theta} = "
            r"m l^2 \ddot\theta - m g l \sin\theta",
            PENDULUM,
        ),
        ("L = I x^2", ["2L = I x^2"]),
        (r"\mathbf{r}\cdot\dot{\mathbf{r}} = -r\dot{r}", []),
        (r"\frac{d}{dt}\frac{1}{r} = -\frac{\mathbf{r}\cdot\dot{\mathbf{r}}}{r^2}", []),
        (r"[\mathbf{a}]_\times \mathbf{b} = \mathbf{b}\times\mathbf{a}", []),
    ],
    "ambiguous": [
        (r"a a^\dagger - a^\dagger a = 1", []),
        (r"x p - p x = i \hbar", []),
        (r"\sigma_x \sigma_y - \sigma_y \sigma_x = 2 i \sigma_z", []),
        (r"\hat{\mathbf{a}} = \frac{\mathbf{a}}{|\mathbf{a}|}", []),
        ("x^2 + x + 1 = x^2 + O(x)", []),
        (r"y = \lim_{h \to 0} \frac{f(x + h) - f(x)}{h}", ["f(x) = x^2"]),
        (r"d(x y) = x\,dy", []),
        (r"dE = m v\,dv", [r"E = \frac12 m v^2"]),
        (r"p\,dV + V\,dp = n R\,dT", ["pV = n R T"]),
        ("d_1 + d x = d_1 + x d", []),
        (r"x_1 + x_2 = -\frac{b}{a}", ["ax^2 + bx + c = a(x - x_1)(x - x_2)"]),
        (r"A = \frac12", [r"\frac{1}{x^2 - 1} = \frac{A}{x - 1} + \frac{B}{x + 1}"]),
        ("AB = BA", []),
        ("(A + B)(A - B) = A^2 - B^2", []),
        ("(AB)^{-1} = A^{-1} B^{-1}", []),
        (r"\hat{\mathbf n}\cdot\dot{\hat{\mathbf n}} = 0", []),
        (r"\mathbf{a}\cdot\mathbf{b} = ab\cos\theta", []),
        ("u_y = v_x", ["u = x^2 - y^2", "v = 2xy"]),
        ("F_x = kx", ["F = kx"]),
        (r"a \times b = -b \times a", []),
        (r"\omega\times(\omega\times r) = \omega(\omega\cdot r) - \omega^2 r", []),
        (r"\tilde{\omega} v = \omega\times v", []),
        (r"S(\mathbf{a}) \mathbf{b} = \mathbf{a}\times\mathbf{b}", []),
        (r"L = r \times p", ["p = mv"]),
        (r"\Delta(xy) = x \Delta y + y \Delta x", []),
        (r"\mathrm{d}(xy) = x \, \mathrm{d}y + y \, \mathrm{d}x", []),
    ],
    "unreadable": [
        (r"dx\,dy = r\,dr\,d\theta", [r"x = r\cos\theta", r"y = r\sin\theta"]),
        (r"x^\mu x_\mu = s^2 + 1", []),
        (r"I = \int r^2 dm", []),
    ],
    "undecided": [
        (r"\sigma^2 = E[X^2] - \mu^2", []),
        (r"\int_0^1 f(t)^2 \,dt = \left(\int_0^1 f(t) \,dt\right)^2", []),
        (r"\int_0^1 f(t) \,dt = f(t)", []),
        (r"y = 1 + \frac{x}{2} + O(x^2)", ["y^2 = 1 + x"]),
        (r"\sin n = n + O(n)", []),
        ("x < 1 + O(x)", []),
        ("dU = T dS - p dV", []),
        (r"\lim_{x \to 0} \frac{|x|}{x} = 1", []),
        (r"\lim_{x \to 0} x^x = 1", []),
        (r"\lim_{n \to \infty} (-1)^n = 1", []),
        (r"\lim_{x \to 0^+} x \ln x = 0", []),
        (r"\lim_{x \to 0} f(x) = 1", []),
        (r"\lim_{x \to 0} y = 1", ["y^2 = 1 + x"]),
        ("v^2 = v_0^2 + 2as", []),
        (r"\dot x = -kx", []),
        (r"\frac{dy}{dx} = -\cot t", [r"x = \cos t", r"y = \sin t"]),
        (r"z = r e^{\mathrm{i}\theta}", []),
        (r"y = 0", ["z = x + iy"]),
    ],
}


# what takes several seconds
LONG = (
    r"\mathbf{R}^T\mathbf{R} = \mathbf{R}^{-1}\mathbf{R} = \mathbf{I}_3",
    r"\boldsymbol{A} = \boldsymbol{B}^{-1} = \boldsymbol{B}^T",
    r"\frac{d}{dt}\frac{\partial L}{\partial\dot\theta} - \frac{\partial L}{\partial\theta}"
    r" = m l^2 \ddot\theta - m g l \sin\theta",
)  # fmt: skip


def case(verdict: str, relation: str, where: list[str]) -> ParameterSet:
    return pytest.param(verdict, relation, where, marks=[pytest.mark.slow] * (relation in LONG))


@pytest.mark.parametrize(
    ("verdict", "relation", "where"), [case(v, *each) for v, several in VERDICTS.items() for each in several]
)
def test_what_authors_mean_is_decided(verdict: str, relation: str, where: list[str]) -> None:
    assert decide(relation, where=where).verdict == verdict


# improper integrals, sums up to a letter, conditions beside relations, what only surfaces tell apart
UNDER = {
    "proved": [
        (r"\int_0^\infty e^{-st} \sin(\omega t) dt = \frac{\omega}{s^2+\omega^2}", "s > 0"),
        (
            r"\int_{-\infty}^\infty (x-\mu)^2 \frac{1}{s\sqrt{2\pi}} e^{-\frac{(x-\mu)^2}{2s^2}} dx = s^2",
            "s > 0",
        ),
        (r"\int_0^\infty x^{k-1} e^{-x/\theta} dx = \Gamma(k) \theta^k", "k > 0, \\theta > 0"),
        (r"\int_{-\infty}^\infty \frac{1}{2b} e^{-|x-\mu|/b} dx = 1", "b > 0"),
        (r"\int_a^\infty \frac{G m M}{r^2} dr = \frac{GmM}{a}", "a > 0"),
        (r"\int_0^\infty (e^{-at} - e^{-bt}) dt = \frac{1}{a} - \frac1b", "a > 0, b > 0"),
        (r"\int_{-\infty}^\infty \frac{dx}{1+x^2} = \pi", ""),
        (r"\int_0^1 x^n dx = \frac{1}{n+1}", "n > 0"),
        (r"\int_{-\infty}^0 e^{ax} dx = \frac1a", "a > 0"),
        (r"e^{-\frac{(x-m)^2}{2s^2}} = e^{-\frac{m^2}{2s^2}} e^{\frac{mx}{s^2} - \frac{x^2}{2s^2}}", ""),
        (r"\sin(\omega (t+\tau)) = \sin\omega t\cos\omega\tau+\cos\omega t\sin\omega\tau", ""),
        (r"\sum_{i=1}^n \sum_{j=1}^m a_i b_j = \left(\sum_{i=1}^n a_i\right)\left(\sum_{j=1}^m b_j\right)", ""),
        (r"\sum_{k=1}^n (2k + c a_k) = n(n+1) + c \sum_{k=1}^n a_k", ""),
        (r"\sqrt{x^2} = x, \quad x \ge 0", ""),
        (r"\arcsin(\sin x) = x, \quad -\frac{\pi}{2} \le x \le \frac{\pi}{2}", ""),
        (r"\sqrt{x^2} = x \text{ where } x \ge 0", ""),
        (r"{\bf a} \cdot {\bf b} = {\bf b} \cdot {\bf a}", ""),
        (r"{\left(x+y\right)}^2 = x^2 + 2xy + y^2", ""),
        (r"\int_0^{2\pi/\omega} \cos^2 \omega t \,dt = \frac{\pi}{\omega}", ""),
        (r"\cos^2 x + \cos^2(x + \frac{2\pi}{3}) + \cos^2 (x - \frac{2\pi}{3}) = \frac32", ""),
        (r"\tan 30^\circ = \frac{1}{\sqrt 3}", ""),
        (r"\sin^2(x/y) + \cos^2(x/y) = 1", ""),
        (r"\frac{x^a}{x^b} = x^{a-b}", "x > 0"),
        (r"a^{\ln b} = b^{\ln a}", "a > 0, b > 0"),
        (r"x = \frac{-b \pm \sqrt{b^2-4ac}}{2a}", "ax^2+bx+c=0"),
    ],
    "refuted": [
        (r"\int_0^\infty e^{-st} \sin(\omega t) dt = \frac{s}{s^2+\omega^2}", "s > 0"),
        (r"\int_{-\infty}^\infty e^{-x^2} dx = \pi", ""),
        (r"\int_{-\infty}^\infty e^{-a|t|} dt = \frac{1}{a}", "a > 0"),
        (r"\int_{-\infty}^{\infty} e^{-a x^2 + bx} dx = \sqrt{\frac{\pi}{a}} e^{\frac{b^2}{2a}}", "a > 0"),
        (r"\sum_{i=1}^n (x_i - m)^2 = \sum_{i=1}^n x_i^2 - m^2", ""),
        (r"\sqrt{x^2} = -x, \quad x \ge 0", ""),
        (r"\cos \frac{\pi}{3} = \frac{\sqrt 3}{2}", ""),
        (r"x = \frac{b \pm \sqrt{b^2-4ac}}{2a}", "ax^2+bx+c=0"),
        (r"{\bf A} {\bf B} = {\bf B} {\bf A}", ""),
        (r"\sum_{k=0}^{n} \binom{n}{k} (-1)^k = 0", r"n \in \mathbb{N}_0"),  # false for n = 0, which is said
        ("n^2 > 0", r"n \in \mathbb{N}_{0}"),
    ],
    "undecided": [
        ("(-1)^n = 1", r"n \in \mathbb{Z}_0"),  # whatever that is
        (r"\int_1^\infty \frac{1}{x} dx = 1", ""),
        (r"\int_0^\infty e^{x} dx = -1", ""),
        (r"\int_0^\infty e^{-ax} dx = \frac{1}{a}", ""),
        (r"\int_0^\infty \sin x\, dx = 1", ""),
    ],
    "ambiguous": [
        ("n^2 > 0", r"n \in \mathbb{N}"),
        ("sin^2 x + cos^2 x = 1", ""),
        (r"\frac{sin x}{x} = 1", ""),
        (r"e^{exp x} = 1", ""),
    ],
    "unreadable": [(r"\dot{x^2} = \dot{x}^2", ""), ("{-x}^2 = x^2", "")],
}


@pytest.mark.parametrize(
    ("verdict", "relation", "given"), [(v, *each) for v, several in UNDER.items() for each in several]
)
def test_what_holds_under_conditions_is_decided(verdict: str, relation: str, given: str) -> None:
    assert decide(relation, given=given).verdict == verdict


COMPLEX = r"z \in \mathbb{C}"
OF_COMPLEX = {
    r"|1 + z|^2 = 1 + 2 \operatorname{Re} z + |z|^2": "proved",
    r"|1 + z|^2 = 1 + \operatorname{Re} z + |z|^2": "refuted",
    r"|e^z| = e^{\operatorname{Re} z}": "proved",
    r"z^2 = |z|^2": "refuted",
    r"\sqrt{z^2} = z": "unreadable",
}


@pytest.mark.parametrize(("relation", "verdict"), OF_COMPLEX.items())
def test_complex_letters_are_said_to_be_complex(relation: str, verdict: str) -> None:
    assert decide(relation, given=COMPLEX).verdict == verdict


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [(r"\frac{\partial L}{\partial x} = 2 I x", "refuted"), (r"\frac{\partial L}{\partial x} = I x", "proved")],
)
def test_an_equation_with_a_factor_before_a_letter_holds_for_all_values(relation: str, verdict: str) -> None:
    assert decide(relation, where=["2L = I x^2"]).verdict == verdict


# published without a word: equations, conditions and definitions, which nobody means for all values of their letters
EQUATIONS = [
    (r"F_r + F_r^* = 0", []),
    (r"m\ddot{x} = u + f", []),
    (r"\ddot{\xi} + 4\omega_0^2 \xi = 0", []),
    (r"4 x^2 y'' - 4 x^2 y' + (1-2x)y = 0", []),
    (r"\ddot{\mathbf r} = -\frac{\mu}{r^3}\mathbf r", []),
    (r"{\bf M}({\bf q})\ddot{\bf q} + {\bf C}({\bf q},\dot{\bf q})\dot{\bf q} = {\bf B}{\bf u}", []),
    (r"r^3 - 3 r^2 - r + 3 = 0", []),
    (r"\frac{v^2}{2} - \frac{\mu}{r} = \frac{\mu}{2a}", []),
    (r"\cos E = \frac{e + \cos\nu}{1 + e\cos\nu}", []),
    (r"\tan\frac{\nu}{2} = z - \frac{1}{z}", []),
    (r"T = \frac{1}{2} m v^2 = \frac{1}{2} m (v_x^2 + v_y^2 + v_z^2)", []),
    (r"f(t) = |t| \quad \text{for } -1 < t \leq 1", []),
    (r"V = \begin{cases} V_0, & r < a \\ 0, & r \ge a \end{cases}", []),
    (r"Y(a, b) = Y(b, a)", []),
    (r"f'(a) = f'(b)", []),
    (r"I_3 > I_2 > I_1", []),
    (r"|u| \leq u_{max}", []),
    (r"\omega T = 2\pi", []),
    ("P^2 = P", []),
    (r"\mathbf{R}\mathbf{R}^T = \mathbf{I}_2", []),
    (r"\mathbf{R}^T\mathbf{R} = \mathbf{R}^{-1}\mathbf{R} = \mathbf{I}_3", []),
    ("A^{-1} = A^T", []),
    (r"\cos x \approx 1", []),
    (r"dx/dt = 0", []),
    (r"\partial f/\partial x = 0", []),
    (r"dx/dt = A x + B u", []),
    (r"\frac{d}{dx} c = 0", []),
    # to be solved for what stands on both sides
    ("3^{2x} = 2^{x+3}", []),
    (r"\tan\delta = \delta", []),
    (r"\cos\lambda \cosh\lambda + 1 = 0", []),
    (r"\sqrt{x + 1} = x - 1", []),
    ("x^3 = x", []),
    ("2x + 3 = x - 5", []),
    (r"x = 1 + \frac{1}{x}", []),
    (r"x^{*} = (1 - b)(x^* + a) + c x^*", []),
    (r"X(s) - \frac{1}{s^2} = \frac{1}{s} X(s)", []),
    ("-9 C \\cos 3t = -C \\cos 3t + \\frac23 \\cos 3t", []),
    # what is equal to a number
    ("n! = 120", []),
    (r"\sum_{k=1}^n k = 55", []),
    (r"\int_0^a x \,dx = 8", []),
    (r"\frac{d}{dx}(x^3 - 3x) = 0", []),
    (r"|\mathbf{n}| = 1", []),
    (r"e^{i\theta} = 1", []),
    (r"\int_a^b \delta L \,dt = 0", []),
    # with letters of which nothing else is said
    (r"\frac{s^2 + s + 1}{s^3 + s} = \frac{A}{s} + \frac{B s + C}{s^2 + 1}", []),
    (r"\boldsymbol{M}^T \boldsymbol{J} \boldsymbol{M} = \boldsymbol{J}", []),
    (r"\boldsymbol{A} = \boldsymbol{B}^{-1} = \boldsymbol{B}^T", []),
    (r"\mathbf{a} = \frac{1}{\sqrt{a_x^2 + a_y^2}} \begin{bmatrix} a_x & a_y \end{bmatrix}^T", []),
    # orders that are so of some values
    ("e^x > 100", []),
    (r"\frac{m}{M} + \frac{M}{m} \ge 25", []),
    (r"\left|\frac{x - a}{x + a}\right| < 1 \text{ for } x > 0", []),
]
# one slip in what is meant for all values
SLIPS = [
    (r"\sin(a + b) = \sin a \cos b + \cos a \sin c", []),
    (r"(a + b)^2 = a^2 + 2ab + c^2", []),
    (r"\frac{d}{dx} \arctan(ax) = \frac{1}{1 + a^2 x^2}", []),
    (r"\frac{d}{dx}(f g) = f' g'", []),
    (r"\frac{d}{dt} \sin \omega t = \omega \sin \omega t", []),
    (r"\int_0^\pi \sin(nt) \,dt = 0", []),
    (r"\cos^2 x - \sin^2 x = 1", []),
    (r"\delta_{11} x + x = x + 2 \delta_{11} x", []),
    ("x + x = x", []),
    (r"\sin 3x = 3 \sin x + 4 \sin^3 x", []),
    (r"e^{i\theta} = \cos\theta - i \sin\theta", []),
    (r"\ln(x + y) = \ln x + \ln y", []),
    (r"(\boldsymbol{A} \boldsymbol{B})^T = \boldsymbol{A}^T \boldsymbol{B}^T", []),
    (r"|a + b| \ge |a| + |b|", []),
]
# what depends on what, what brackets and marks mean: unsaid, and a verdict would rest on it
UNSAID = [
    (r"\frac{\partial F}{\partial y'} y' = 0", []),
    (r"\frac{dE}{dt} = 0", [r"E = \frac12 m v^2"]),
    (r"\frac{\partial H}{\partial p_i} = \frac{p_i}{m}", [r"H = \frac{p_1^2 + p_2^2}{2m}"]),
    (r"\frac{\partial H}{\partial p_i} = 0", [r"H = \sum_{i=1}^n p_i^2"]),
    (r"\boldsymbol p = \boldsymbol p(t)", []),
    (r"\mathbf{r} = \begin{bmatrix} r_x \\ r_y \\ r_z \end{bmatrix}", []),
    ("f(b + c) = fb + fc", []),
    ("e^{A + B} = e^A e^B", []),
    ("e^{A t} e^{B t} = e^{(A + B) t}", []),
    (r"\exp(A t) \exp(B t) = \exp(A t + B t)", []),
    ("|z|^2 = z^2", []),
    (r"\mathbf{x}^T A \mathbf{y} = \mathbf{y}^T A \mathbf{x}", []),
    (r"A B \ne B A", []),
    (r"(\mathbf a \times \mathbf b) \times \mathbf c \ne \mathbf a \times (\mathbf b \times \mathbf c)", []),
    (r"\bar v = (\bar v \cdot \hat a_x) \hat a_x + (\bar v \cdot \hat a_y) \hat a_y", []),
    (r"\bar v \cdot \bar w = |\bar v| |\bar w| \cos\theta", []),
    (r"m \ne n \Rightarrow \int_0^\pi \sin(mt) \sin(nt) \,dt = 0", []),
    (r"\sin(n\pi) = 0", []),
    (r"\int_0^{2\pi} \cos(m x) \cos(n x) \,dx = 0", []),
    (r"\mathrm{i}^2 = \mathrm{j}^2 = \mathrm{k}^2 = \mathrm{i}\mathrm{j}\mathrm{k} = -1", []),
    (r"i = \cos^{-1}(h_Z/h)", []),
    (r"\sin x y = y \sin x", []),
    (r"\sqrt{a^2 b} = a \sqrt{b}", []),
    (
        r"\underbrace{A \cos(-\pi k) + B \sin(-\pi k)}_{x(-\pi)} = \underbrace{A \cos(\pi k) + B \sin(\pi k)}_{x(\pi)}",
        [],
    ),
]
# letters before brackets that nobody writes around a factor, and that stand without them too; a sign that may be a sum;
# primes beside dots
APPLIED = [
    (r"\frac{\text{Viscous forces}}{\text{Surface forces}} = C a", []),
    ("v(t) = v t", []),
    (r"\Sigma \xi = \xi_1 + \xi_2 + \Sigma", []),
    (r"\dot x = x'", []),
    (r"0 = e^2 - \frac{r}{a} \cos\nu e - (1 + \frac{r}{a})", []),
    (r"m\text{-}P = P\text{-}m", []),
]
BESIDE_CALLS = [
    ("E[XY] = E[X] Y", []),
    (r"E_n = 2^n E_n\left(\frac{1}{2}\right)", []),
    (r"x = \int_0^t f(\tau) h(t - \tau) d\tau + f", []),
]


@pytest.mark.parametrize(
    ("verdict", "relation", "where"),
    [
        case(verdict, *each)
        for verdict, several in (
            ("undecided", [*EQUATIONS, *BESIDE_CALLS]),
            ("refuted", SLIPS),
            ("ambiguous", UNSAID),
            ("unreadable", APPLIED),
        )
        for each in several
    ],
)
def test_what_is_printed_without_a_word_is_not_accused(verdict: str, relation: str, where: list[str]) -> None:
    assert decide(relation, where=where).verdict == verdict


@pytest.mark.parametrize(
    ("relation", "said"),
    [
        (r"(AB)^n = A^n B^n", {"A": "scalar", "B": "scalar"}),
        (r"\frac{AB + BA}{2} = AB", {"A": "scalar"}),
        (r"\hat p\hat x = \hat x\hat p", {r"\hat p": "scalar"}),
        (r"\hat{a}\hat{a}^\dagger = \hat{a}^\dagger\hat{a}", None),
        (r"a^\dagger a = a a^\dagger", None),
        (r"\sigma_x\sigma_y = \sigma_y\sigma_x", {r"\sigma_x": "scalar"}),
        (r"L_x L_y - L_y L_x = 0", {"L_x": "scalar"}),
        (r"\|A\mathbf{x}\| = \|A\|\|\mathbf{x}\|", {"A": "scalar"}),
        (r"\|AB\| = \|A\|\|B\|", {"A": "scalar", "B": "scalar"}),
        (r"\lVert f + g\rVert = \lVert f\rVert + \lVert g\rVert", None),
    ],
)
def test_what_holds_of_numbers_alone_is_asked_about(relation: str, said: dict[str, str] | None) -> None:
    assert decide(relation).verdict == "ambiguous"
    assert said is None or decide(relation, letters=said).verdict == "proved"


@pytest.mark.parametrize(
    ("relation", "given"),
    [
        (r"(\sigma_x - \sigma_y)^2 = \sigma_x^2 - 2\sigma_x\sigma_y + \sigma_y^2", []),
        (r"(c A)^n = c^n A^n", ["c > 0", "A > 0"]),
        (r"\frac{A}{x} + \frac{B}{x} = \frac{A + B}{x}", []),
        ("ab = ba", []),
        (r"\|x\| = |x|", [r"x \in \mathbb{R}"]),
        (r"\|c \mathbf{x}\| = |c| \|\mathbf{x}\|", []),
        (r"\|c x\| = c \|x\|", ["c > 0", r"x \in \mathbb{R}^3"]),
    ],
)
def test_what_holds_of_numbers_and_is_meant_of_them_is_proved(relation: str, given: list[str]) -> None:
    assert decide(relation, given=given).verdict == "proved"


@pytest.mark.parametrize("name", ["P_k", "p_k"])
def test_functions_with_an_index_up_to_a_letter_are_no_constants(name: str) -> None:
    slope = rf"\frac{{\partial {name}}}{{\partial u}} \frac{{\partial Q_k}}{{\partial v}}"
    turned = rf"\frac{{\partial {name}}}{{\partial v}} \frac{{\partial Q_k}}{{\partial u}}"
    assert decide(rf"\sum_{{k=1}}^n {slope} = \sum_{{k=1}}^n {turned}").verdict != "proved"


def test_a_derivative_with_a_slash_is_one_with_a_fraction() -> None:
    assert decide("dx/dt = y", where=[r"\frac{dx}{dt} = y"]).verdict == "proved"
    assert decide("dy/dx = 2x", where=["y = x^2"]).verdict == "proved"
    assert decide("dy/dx = x", where=["y = x^2"]).verdict == "refuted"


def test_what_only_says_what_another_letter_is_does_not_make_an_equation_false() -> None:
    lagrangian = r"L = \frac{1}{2} m l^2 \dot\theta^2 + m g l \cos\theta"
    assert decide(r"\ddot\theta + \frac{g}{l} \sin\theta = 0", where=[lagrangian]).verdict == "undecided"
    assert decide("(x + 1)^2 = x^2 + 2 x + 2", where=["L = x^2"]).verdict == "refuted"


def test_bases_and_skew_matrices_are_not_taken_for_free_ones() -> None:
    place = r"\mathbf{r} = x \mathbf{i} + y \mathbf{j} + z \mathbf{k}"
    assert decide(r"r = \sqrt{x^2 + y^2 + z^2}", where=[place]).verdict == "ambiguous"
    assert decide(r"[\tilde a]^T = -[\tilde a]").verdict == "ambiguous"


@pytest.mark.parametrize(("w", "x", "y", "z"), ["wxyz", "0123"])
def test_a_bold_letter_beside_four_components_may_be_a_quaternion(w: str, x: str, y: str, z: str) -> None:
    squares = f"q_{w}^2 + q_{x}^2 + q_{y}^2 + q_{z}^2"
    said = rf"\mathbf{{q}} = (q_{w}, q_{x}, q_{y}, q_{z})"
    assert decide(rf"\|\mathbf{{q}}\|^2 = {squares}").verdict == "ambiguous"
    assert decide(rf"\|\mathbf{{q}}\|^2 = {squares}", where=[said]).verdict == "proved"
    unit = [f"{squares} = 1"]
    assert decide(f"1 - 2 (q_{y}^2 + q_{z}^2) = q_{w}^2 + q_{x}^2 - q_{y}^2 - q_{z}^2", where=unit).verdict == "proved"
    wrong = answered(f"1 - 2 (q_{y}^2 + q_{z}^2) = q_{w}^2 + q_{x}^2 - q_{y}^2 + q_{z}^2", unit, wanted=False)
    assert wrong.verdict == "refuted"
    assert [value.strip("-") for value in wrong.counterexample.values()] == ["1/5", "2/5", "2/5", "4/5"]


def test_no_search_is_made_for_what_cannot_change_the_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    asked, proofs = list[str](), list[object]()
    decided, proof_of = ask._decided, repairs.proof_of
    monkeypatch.setattr(ask, "_decided", lambda reading, *more: asked.append(reading) or decided(reading, *more))
    monkeypatch.setattr(repairs, "proof_of", lambda problem: proofs.append(problem) or proof_of(problem))
    assert decide(r"[\mathbf{a}]_{\times}^2 = \mathbf{a}\mathbf{a}^T - \|\mathbf{a}\|^2 I").verdict == "proved"
    assert len(asked) == 1  # that I is another matrix is far from anybody's mind
    skew = r"S = \begin{pmatrix} 0 & -\dot\theta \\ \dot\theta & 0 \end{pmatrix}"
    assert decide(r"\dot R = R S", where=[TURN, skew]).verdict == "proved"
    assert len(asked) == 2  # matrices that are printed have no other numbers of rows
    assert decide(r"\mathbf{a}\mathbf{a}^T = \mathbf{b}\mathbf{b}^T + [\mathbf{a}]_{\times}").verdict == "undecided"
    assert len(proofs) < 40  # of hundreds of slips; the others fail where some numbers stand for the letters


PLACE = r"\mathbf{x} = \begin{pmatrix} x \\ y \end{pmatrix}"
COORDINATES = r"q = \begin{pmatrix} x \\ \theta \end{pmatrix}"
ENERGY = r"L = \frac12 m \dot x^2 + \frac12 J \dot\theta^2 - k x \theta"
GRADIENTS: dict[str, list[tuple[str, list[str]]]] = {
    "proved": [
        (r"\frac{\partial f}{\partial \mathbf{x}} = \begin{pmatrix} 2x \\ 2y \end{pmatrix}", ["f = x^2 + y^2", PLACE]),
        (r"\frac{\partial f}{\partial \mathbf{x}} = 2\mathbf{x}", ["f = x^2 + y^2", PLACE]),
        (r"\frac{\partial L}{\partial q} = \begin{pmatrix} -k\theta \\ -k x \end{pmatrix}", [COORDINATES, ENERGY]),
        (r"\frac{\partial L}{\partial \dot q} = \begin{pmatrix} m\dot x \\ J\dot\theta \end{pmatrix}",
         [COORDINATES, ENERGY]),
        (r"\frac{d}{dt}\left(\frac{\partial L}{\partial \dot q}\right) - \frac{\partial L}{\partial q}"
         r" = \begin{pmatrix} m\ddot x + k\theta \\ J\ddot\theta + k x \end{pmatrix}", [COORDINATES, ENERGY]),
        (r"\frac{\partial V}{\partial \mathbf{r}} = \frac{\mu}{r^3}\mathbf{r}",
         [r"V = -\frac{\mu}{r}", r"r = |\mathbf{r}|"]),
    ],
    "refuted": [
        (r"\frac{\partial f}{\partial \mathbf{x}} = \begin{pmatrix} 2x \\ y \end{pmatrix}", ["f = x^2 + y^2", PLACE]),
        (r"\frac{\partial f}{\partial \mathbf{x}} = \mathbf{0}", ["f = x^2 + y^2", PLACE]),
        (r"\frac{\partial V}{\partial \mathbf{r}} = \frac{\mu}{r^2}\mathbf{r}",
         [r"V = -\frac{\mu}{r}", r"r = |\mathbf{r}|"]),
        (r"\frac{\partial L}{\partial \dot q} = \begin{pmatrix} m\dot x \\ m\dot\theta \end{pmatrix}",
         [COORDINATES, ENERGY]),
    ],
    "undecided": [  # a stationary point, two components that are one letter, and a component that is no letter
        (r"\frac{\partial f}{\partial \mathbf{x}} = \mathbf{0}", []),
        (r"\frac{\partial f}{\partial q} = \begin{pmatrix} 2y \\ 2y \end{pmatrix}",
         ["f = y^2", r"q = \begin{pmatrix} y \\ y \end{pmatrix}"]),
        (r"\frac{\partial f}{\partial q} = \begin{pmatrix} 2x \\ 1 \end{pmatrix}",
         ["f = x^2 + y", r"q = \begin{pmatrix} 2x \\ y \end{pmatrix}"]),
        (r"\frac{\partial \mathbf{f}}{\partial \mathbf{x}} = 0", []),  # rows or columns
        (r"\frac{\partial}{\partial \mathbf{x}} (x^2 + y^2) = \mathbf{0}", []),
    ],
    "ambiguous": [  # they may be components, or constant
        (r"\frac{\partial f}{\partial \mathbf{x}} = \mathbf{0}", ["f = x_1^2"]),
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("verdict", "relation", "where"), [(v, *each) for v, several in GRADIENTS.items() for each in several]
)
def test_a_derivative_by_a_column_of_letters_is_the_column_of_their_derivatives(
    verdict: str, relation: str, where: list[str]
) -> None:
    assert decide(relation, where=where).verdict == verdict


PRODUCTS = {
    r"\frac{d m v^2}{dt} = 2 m v \dot v": "proved",
    r"\frac{d I \omega}{dt} = I \dot\omega": "proved",
    r"\frac{\partial a x^2 y}{\partial x} = 2 a x y": "proved",
    r"\frac{\partial a \sqrt{x}}{\partial x} = \frac{a}{2\sqrt{x}}": "proved",
    r"\frac{d a \sin x}{dx} = a \cos x": "proved",
    r"\frac{\partial a |\mathbf{x}|}{\partial \mathbf{x}} = \frac{a \mathbf{x}}{|\mathbf{x}|}": "proved",
    r"\frac{d uv}{dx} = u \frac{dv}{dx} + v \frac{du}{dx}": "proved",
    r"\frac{d m v^2}{dt} = m v \dot v": "refuted",
    r"\frac{\partial a x^2 y}{\partial x} = a x y": "refuted",
    r"\frac{d uv}{dx} = u \frac{dv}{dx}": "ambiguous",
}


@pytest.mark.parametrize("relation", PRODUCTS)
def test_a_letter_behind_the_d_that_other_factors_follow_may_be_constant(relation: str) -> None:
    assert decide(relation).verdict == PRODUCTS[relation]


MATRIX, COLUMN = r"\begin{bmatrix} 0 & 1 \\ 0 & a \end{bmatrix}", r"\begin{bmatrix} 0 \\ b \end{bmatrix}"


@pytest.mark.parametrize(
    "relation",
    [
        rf"A = {MATRIX}, \quad B = {COLUMN}",
        rf"A &= {MATRIX} \\ B &= {COLUMN}",
        rf"\begin{{aligned}} A &= {MATRIX} \\ B &= {COLUMN} \end{{aligned}}",
        rf"A = {MATRIX} \text{{ and }} B = {COLUMN}",
        rf"A = {MATRIX}, \quad \dot B = {COLUMN}",
        r"A = \left[\begin{array}{cc} 0 & 1 \\ 0 & a \end{array}\right], B = (\begin{array}{c} 0 \\ b \end{array})",
        r"A = \begin{Bmatrix*} 0 & 1 \\ 0 & a \end{Bmatrix*}, B = \begin{pmatrix*}[c] 0 \\ b \end{pmatrix*}",
        r"A = \begin{bmatrix*}[r] 0 & 1 \\ 0 & a \end{bmatrix*}, B = \begin{pmatrix*} 0 \\ b \end{pmatrix*}",
    ],
)
def test_what_is_equal_to_a_printed_matrix_is_one_wherever_that_stands(relation: str) -> None:
    taken = decide(relation).letters
    assert taken["A"].startswith("a matrix")
    assert taken["B"].startswith("a vector")
    assert "r" not in taken


X_T, FORCED = "f = x^2 t", r"L = \frac12 m \dot q^2 - \frac12 k q^2 + q \sin t"
BESIDE_R = [r"\Gamma = \frac{\partial h}{\partial r} - \frac12 \frac{\partial g}{\partial t}", "h = 0", "g = -a(t)^2"]
CHAINS: dict[str, list[tuple[str, list[str]]]] = {
    "proved": [
        (r"\frac{df}{dt} = \frac{\partial f}{\partial t} + \frac{\partial f}{\partial x} \frac{dx}{dt}", [X_T]),
        (r"\dot f = \frac{\partial f}{\partial t} + \frac{\partial f}{\partial x} \dot x", [X_T]),
        (r"\frac{dL}{dt} = \frac{\partial L}{\partial q} \dot q + \frac{\partial L}{\partial\dot q} \ddot q"
         r" + \frac{\partial L}{\partial t}", [FORCED]),
        (r"\frac{\partial f}{\partial t} = x^2", [X_T]),
        (r"\frac{\partial f}{\partial t} + \dot x = x^2 + \dot x", [X_T]),
        (r"\frac{\partial u^2}{\partial t} = 2 u \frac{\partial u}{\partial t}", []),
        (r"\frac{\partial u}{\partial t} = -c \frac{\partial u}{\partial x}", ["u = f(x - ct)"]),
        (r"\Gamma = \dot a a", BESIDE_R),
    ],
    "refuted": [
        (r"\Gamma = -\dot a a", BESIDE_R),
        (r"\frac{df}{dt} = \frac{\partial f}{\partial t} - \frac{\partial f}{\partial x} \frac{dx}{dt}", [X_T]),
    ],
    "undecided": [  # what moves may be held constant, or not
        (r"\frac{\partial f}{\partial t} = x^2", [X_T, r"\dot x = v"]),
        (r"\frac{\partial T}{\partial t} = m \dot x \ddot x", [r"T = \frac12 m \dot x^2"]),
        (r"\frac{\partial u}{\partial t} = r \dot a", ["u = r a(t)"]),
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("verdict", "relation", "where"), [(v, *each) for v, several in CHAINS.items() for each in several]
)
def test_beside_total_derivatives_a_partial_one_holds_constant_what_moves(
    verdict: str, relation: str, where: list[str]
) -> None:
    assert decide(relation, where=where).verdict == verdict


KINETIC = r"T = \frac12 \boldsymbol\omega \cdot \mathbf{J} \boldsymbol\omega"
EULER = r"\mathbf{J} \dot{\boldsymbol\omega} + \boldsymbol\omega \times \mathbf{J} \boldsymbol\omega = \mathbf{u}"
CONTRACTED: dict[str, list[tuple[str, list[str]]]] = {
    "proved": [
        (r"\mathbf{a} \cdot \mathbf{J} \mathbf{b} = \mathbf{a}^T \mathbf{J} \mathbf{b}", []),
        (r"\mathbf{a} \cdot \mathbf{J} \cdot \mathbf{b} = \mathbf{a}^T \mathbf{J} \mathbf{b}", []),
        (r"\mathbf{a} \cdot \mathbf{J} = \mathbf{J}^T \mathbf{a}", []),
        (r"\mathbf{a} \cdot \mathbf{A} \mathbf{B} \mathbf{b} = \mathbf{a}^T \mathbf{A} (\mathbf{B} \mathbf{b})", []),
        (r"\mathbf{a} \cdot \mathbf{J} \mathbf{b}\, \mathbf{c} = (\mathbf{a}^T \mathbf{J} \mathbf{b}) \mathbf{c}", []),
    ],
    "refuted": [
        (r"\mathbf{a} \cdot \mathbf{J} \cdot \mathbf{b} = 2 \mathbf{a}^T \mathbf{J} \mathbf{b}", []),
        (r"\dot T = 2 \boldsymbol\omega \cdot \mathbf{J} \dot{\boldsymbol\omega}", [KINETIC]),
    ],
    "ambiguous": [  # these hold for symmetric matrices, as those of inertia are
        (r"\mathbf{a} \cdot \mathbf{J} \mathbf{b} = \mathbf{b} \cdot \mathbf{J} \mathbf{a}", []),
        (r"\mathbf{a} \cdot \mathbf{J} = \mathbf{J} \mathbf{a}", []),
        (r"\dot T = \boldsymbol\omega \cdot \mathbf{J} \dot{\boldsymbol\omega}", [KINETIC]),
        (r"\dot V = 2 \mathbf{x}^T \mathbf{P} \dot{\mathbf{x}}", [r"V = \mathbf{x}^T \mathbf{P} \mathbf{x}"]),
    ],
    "unreadable": [(r"\mathbf{a} \cdot \mathbf{J} \mathbf{b} \cdot \mathbf{c} = 0", [])],
}  # fmt: skip


@pytest.mark.parametrize(
    ("verdict", "relation", "where"), [(v, *each) for v, several in CONTRACTED.items() for each in several]
)
def test_a_dot_before_a_matrix_contracts_and_symmetry_is_asked_about(
    verdict: str, relation: str, where: list[str]
) -> None:
    assert decide(relation, where=where).verdict == verdict


@pytest.mark.parametrize(
    ("relation", "where"),
    [
        (r"\dot T = \boldsymbol\omega \cdot \mathbf{u}", [KINETIC, EULER]),
        (r"\dot V = 2 \mathbf{x}^T \mathbf{J} \dot{\mathbf{x}}", [r"V = \mathbf{x}^T \mathbf{J} \mathbf{x}"]),
    ],
)
def test_what_holds_for_a_symmetric_matrix_is_proved_if_it_is_said_to_be(relation: str, where: list[str]) -> None:
    answer = decide(relation, where, r"\mathbf{J}^T = \mathbf{J}")
    assert answer.verdict == "proved"
    assert r"\mathbf{J}^T = \mathbf{J}" in answer.used


OF_TWO, OF_THREE = r"A, B \in \mathbb{R}^{2 \times 2}", r"\mathbf{x}, \mathbf{y} \in \mathbb{R}^3"
OF_SAID: dict[str, list[tuple[str, list[str]]]] = {
    "proved": [
        (r"\mathbf{x}^T \mathbf{y} = x_1 y_1 + x_2 y_2 + x_3 y_3", [OF_THREE]),
        (r"\mathbf{x} \cdot \mathbf{y} = x_x y_x + x_y y_y + x_z y_z", [OF_THREE]),
        (r"\sum_{i=1}^3 x_i y_i = \mathbf{x} \cdot \mathbf{y}", [OF_THREE]),
        (r"\mathbf{x}^T \mathbf{x} \ge x_1^2", [OF_THREE]),
        (r"(\mathbf{x} \times \mathbf{y})_1 = x_2 y_3 - x_3 y_2", [OF_THREE]),
        (r"\mathbf{r} \cdot \mathbf{r} = r^2", [r"\mathbf{r} \in \mathbb{R}^3"]),
        (r"\mathbf{x}^T \mathbf{x} - x_{10}^2 \ge x_{1}^2 + x_2^2", [r"\mathbf{x} \in \mathbb{R}^{11}"]),
        (r"\sum_{i=1}^3 x_i^2 = \|x\|^2", [r"x \in \mathbb{R}^3"]),
        (r"q_0^2 + q_1^2 + q_2^2 + q_3^2 = \|q\|^2", [r"q \in \mathbb{R}^4"]),
        (r"\operatorname{tr}\mathbf{A} = A_{11} + A_{22}", [r"\mathbf{A} \in \mathbb{R}^{2 \times 2}"]),
        (r"\operatorname{tr} A = \sum_{i=1}^2 A_{ii}", [OF_TWO]),
        (r"\det A = a_{11} a_{22} - a_{12} a_{21}", [OF_TWO]),
        (r"(A B)_{12} = A_{11} B_{12} + A_{12} B_{22}", [OF_TWO]),
        (r"(A^{-1})_{11} = \frac{a_{22}}{a_{11} a_{22} - a_{12} a_{21}}", [OF_TWO]),
        (r"\operatorname{tr}\boldsymbol\sigma = \sigma_{xx} + \sigma_{yy} + \sigma_{zz}",
         [r"\boldsymbol\sigma \in \mathbb{R}^{3 \times 3}"]),
        (r"R_{11}^2 + R_{12}^2 + R_{13}^2 = 1", [r"R \in SO(3)"]),
    ],
    "refuted": [
        (r"\mathbf{x}^T \mathbf{y} = x_1 y_1 + x_2 y_2 - x_3 y_3", [OF_THREE]),
        (r"\mathbf{x}^T \mathbf{x} = x_1^2 + x_2^2 + x_3^2 + x_4^2 + x_5^2 + x_6^2 + x_7^2 + x_8^2 + x_9^2",
         [r"\mathbf{x} \in \mathbb{R}^{10}"]),
        (r"\sum_{i=1}^3 x_i y_i = 2 \mathbf{x} \cdot \mathbf{y}", [OF_THREE]),
        (r"(\mathbf{x} \times \mathbf{y})_1 = x_3 y_2 - x_2 y_3", [OF_THREE]),
        (r"\det A = a_{11} a_{22} + a_{12} a_{21}", [OF_TWO]),
        (r"(A^{-1})_{11} = \frac{a_{11}}{a_{11} a_{22} - a_{12} a_{21}}", [OF_TWO]),
    ],
    "undecided": [  # other names of components, and numbers below brackets that may be labels
        (r"\mathbf{r} \cdot \mathbf{r} = x^2 + y^2 + z^2", [r"\mathbf{r} \in \mathbb{R}^3"]),
        (r"\mathbf{x} \cdot \mathbf{x} = x^2 + y^2 + z^2", [r"\mathbf{x} \in \mathbb{R}^3"]),
        (r"\mathbf{v}^2 = u^2 + v^2 + w^2", [r"\mathbf{v} \in \mathbb{R}^3"]),
        (r"\|\mathbf{q}\|^2 = q_w^2 + q_x^2 + q_y^2 + q_z^2", [r"\mathbf{q} \in \mathbb{R}^4"]),
        (r"(a + b)_2 = a + b", [r"a \in \mathbb{R}", r"b \in \mathbb{R}"]),
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("verdict", "relation", "given"), [(v, *each) for v, several in OF_SAID.items() for each in several]
)
def test_letters_with_numbers_below_are_entries_of_what_is_said_to_be_a_vector_or_matrix(
    verdict: str, relation: str, given: list[str]
) -> None:
    assert decide(relation, given=given).verdict == verdict


def test_what_an_equation_defines_is_no_component() -> None:
    given = [r"\mathbf{v} \in \mathbb{R}^3", r"\mathbf{u} \in \mathbb{R}^3"]
    answer = decide(r"\|\mathbf{v}\|^2 \ge v_1^2", where=[r"v_1 = \mathbf{v} \cdot \mathbf{u}"], given=given)
    assert answer.verdict == "refuted"


UNIT_RATE = r"\mathbf{n} \cdot \dot{\mathbf{n}} = 0"
LASTING: dict[str, list[tuple[str, str, dict[str, str]]]] = {
    "proved": [
        (UNIT_RATE, r"|\mathbf{n}| = 1", {}),
        (UNIT_RATE, r"\mathbf{n} \cdot \mathbf{n} = 1", {}),
        (r"\dot P^T = \dot P", r"P^T = P", {"P": "matrix that depends on t"}),
        (r"\dot R^T R + R^T \dot R = 0", r"R \in SO(3)", {"R": "matrix that depends on t"}),
    ],
    "undecided": [  # what may be so at one moment
        (UNIT_RATE, r"\mathbf{n} \cdot \mathbf{m} = 1", {}),
        (r"\mathbf{r} \cdot \dot{\mathbf{r}} = 0", r"\mathbf{r} \cdot \mathbf{r} = a^2", {}),
        (r"\mathbf{n} \cdot \dot{\mathbf{n}} = 1", r"|\mathbf{n}| = 1", {}),
    ],
}


@pytest.mark.parametrize(
    ("verdict", "relation", "given", "letters"), [(v, *each) for v, several in LASTING.items() for each in several]
)
def test_the_length_of_a_vector_and_the_symmetry_of_a_matrix_last(
    verdict: str, relation: str, given: str, letters: dict[str, str]
) -> None:
    assert decide(relation, given=[given], letters=letters).verdict == verdict


@pytest.mark.parametrize(("speed", "verdict"), [("c^2", "proved"), ("c", "refuted")])
def test_a_partial_derivative_goes_through_the_argument_of_a_function(speed: str, verdict: str) -> None:
    wave, letters = "u(x, t) = f(x - c t) + g(x + c t)", {"f": "function of x", "g": "function of x"}
    relation = rf"\frac{{\partial^2 u}}{{\partial t^2}} = {speed} \frac{{\partial^2 u}}{{\partial x^2}}"
    assert decide(relation, where=[wave], letters=letters).verdict == verdict


@pytest.mark.parametrize(
    ("verdict", "right"), [("proved", r"\dot{\varphi} \times a"), ("refuted", r"a \times \dot{\varphi}")]
)
def test_the_skew_matrix_of_a_vector_changes_with_it(verdict: str, right: str) -> None:
    letters = {r"\hat{\varphi}": r"skew matrix of \varphi", "S": "matrix", "a": "constant vector"}
    given = [r"\varphi, a \in \mathbb{R}^3"]
    answer = decide(rf"\dot{{S}} a = {right}", where=[r"S = \hat{\varphi}"], given=given, letters=letters)
    assert answer.verdict == verdict


ON_X, ON_XYZ = {"f": "function of x", "g": "function of x"}, {"f": "function of x, y, z"}
OF_SAID_FUNCTIONS: dict[str, list[tuple[str, dict[str, str]]]] = {
    "proved": [
        (r"(f g)' = f' g + f g'", ON_X),
        (r"\left(\frac{f}{g}\right)' = \frac{f' g - f g'}{g^2}", ON_X),
        (r"\nabla \cdot (f \mathbf{F}) = f \nabla \cdot \mathbf{F} + \mathbf{F} \cdot \nabla f", ON_XYZ),
    ],
    "refuted": [
        (r"(f g)' = f' g - f g'", ON_X),
        (r"\nabla \cdot (f \mathbf{F}) = f \nabla \cdot \mathbf{F} - \mathbf{F} \cdot \nabla f", ON_XYZ),
    ],
    "undecided": [(r"(f g)' = f' g + f g'", {**ON_X, "g": "function of y"})],
}


@pytest.mark.parametrize(
    ("verdict", "relation", "letters"), [(v, *each) for v, several in OF_SAID_FUNCTIONS.items() for each in several]
)
def test_letters_that_others_are_said_to_depend_on_need_not_be_printed(
    verdict: str, relation: str, letters: dict[str, str]
) -> None:
    assert decide(relation, letters=letters).verdict == verdict


@pytest.mark.parametrize(
    ("verdict", "relation", "where"),
    [
        ("proved", "C_{11} = A_{11} B_{11} + A_{12} B_{21}", "C = A B"),
        ("proved", "y_1 = a_{11} x_1 + a_{12} x_2", "y = A x"),
        ("refuted", "y_1 = a_{11} x_1 - a_{12} x_2", "y = A x"),
        (
            "undecided",
            "C_{11} = A_{11} B_{11} + A_{21} B_{12}",
            "C = A B",
        ),  # A_{12} and A_{21} have letters of their own
    ],
)
def test_entries_of_what_an_equation_defines_are_those_of_its_right_side(
    verdict: str, relation: str, where: str
) -> None:
    given = [r"A, B, C \in \mathbb{R}^{2 \times 2}", r"x, y \in \mathbb{R}^2"]
    assert decide(relation, where=[where], given=given).verdict == verdict


ROOTS = r"x_{1,2} = \frac{-b \pm \sqrt{b^2 - 4 a c}}{2 a}"


@pytest.mark.parametrize(
    ("verdict", "relation", "where"),
    [
        ("proved", r"x_1 + x_2 = -\frac{b}{a}", ROOTS),
        ("proved", r"x_1 + x_2 = -\frac{b}{a}", ROOTS.replace("1,2", "12")),
        ("refuted", r"x_1 + x_2 = \frac{b}{a}", ROOTS),
        ("proved", r"x_1 = \frac{-b + \sqrt{b^2 - 4 a c}}{2 a}", ROOTS),
        ("proved", r"\lambda_+ - \lambda_- = b", r"\lambda_\pm = \frac{a \pm b}{2}"),
        ("refuted", r"\lambda_+ - \lambda_- = -b", r"\lambda_\pm = \frac{a \pm b}{2}"),
        ("proved", r"\omega_1 \omega_2 = k", r"\omega_{1,2} = \sqrt{\omega^2 + k} \mp \omega"),
        ("proved", r"x_{1,2}^2 + a x_{1,2} + b = 0", r"x_{1,2} = \frac{-a \pm \sqrt{a^2 - 4 b}}{2}"),
        ("ambiguous", r"\lambda_1 + \lambda_2 = a", r"\lambda_{1,2}^2 - a \lambda_{1,2} + b = 0"),
        ("undecided", "R_1 + R_2 = R_{12}", r"R_{12} = R_1 \pm R_2"),
    ],
)
def test_one_letter_with_two_labels_stands_for_two(verdict: str, relation: str, where: str) -> None:
    assert decide(relation, where=[where]).verdict == verdict


@pytest.mark.parametrize(
    ("verdict", "relation"),
    [
        ("proved", r"\det R = 1"),
        ("proved", r"R (x \times y) = (R x) \times (R y)"),
        ("refuted", r"R (x \times y) = (R x) \times y"),
    ],
)
def test_a_rotation_is_orthogonal_with_the_determinant_1(verdict: str, relation: str) -> None:
    assert decide(relation, letters={"R": "rotation", "x": "vector", "y": "vector"}).verdict == verdict


def test_a_value_given_at_one_moment_is_not_that_of_all() -> None:
    assert decide(r"\dot v = 0", given=["v = v_0"]).verdict == "undecided"
    assert decide(r"v = v_0 + g t", where=[r"\dot v = g", "v(0) = v_0"]).verdict == "proved"


@pytest.mark.parametrize(("verdict", "divergence"), [("proved", "3"), ("refuted", "1")])
def test_a_vector_with_three_components_has_no_divergence_in_the_plane(verdict: str, divergence: str) -> None:
    answer = decide(rf"\nabla \cdot \mathbf r = {divergence}", where=[r"\mathbf r = (x, y, z)"])
    assert answer.verdict == verdict


@pytest.mark.parametrize(("verdict", "relation"), [("proved", r"v = 2 v_\infty"), ("refuted", r"v = 3 v_\infty")])
def test_infinity_is_no_sign_of_membership(verdict: str, relation: str) -> None:
    assert decide(relation, given=[r"v = v_\infty u, u = 2"]).verdict == verdict
