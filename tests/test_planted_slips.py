"""One slip in a short text is told at its line, and the text without it says nothing against itself."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import pytest
from sampling import every

from symcheck import look
from symcheck.document.checks import NEGATIVE


class Planted(NamedTuple):
    """A text with what is printed rightly in place of SLIP, wrongly, and the line at which that is told."""

    text: str
    right: str
    wrong: str
    line: int


CHAPTERS = r"""# Ellipses

The orbit is
$$r = \frac{p}{1 + e \cos\nu}$$
At the pericentre
$$q = \frac{p}{1 + e}$$
and at the apocentre
$$s = \frac{p}{1 - e}$$

## Axes

The semi-major axis is
$$a = \frac{p}{1 - e^2}$$
so that the orbit is
$$r = a \frac{1 - e^2}{1 + e \cos\nu}$$
and the pericentre lies at
$$q = SLIP$$

# Hyperbolas

The orbit is
$$r = \frac{p}{1 + e \cos\nu}$$
with the semi-major axis
$$a = \frac{p}{e^2 - 1}$$
so that the pericentre lies at
$$q = a (e - 1)$$
"""

CHOICES = r"""# Choices

We choose $u = x^2 + 1$. With it
$$\frac{du}{dx} = 2 x.$$
Now we choose $u = x^3 - 1$ and obtain
$$\frac{du}{dx} = 3 x^2.$$
Take $c = p + q$. Then
$$c^2 = p^2 + 2 p q + q^2.$$
Take $c = p - q$. Then
$$c^2 = p^2 - 2 p q + q^2.$$
Setting $c = 2 p$ we find
$$c^2 = SLIP p^2.$$
"""

PLANTED = {
    "the last of several choices": Planted(CHOICES, "4", "5", 12),
    "numbers in a chain": Planted(
        r"The area is $$A = 1 \cdot \left(\frac{1}{2} SLIP \frac{1}{2}\right) = 1$$", "+", "-", 1
    ),
    "sides that words part": Planted(
        "The torque is\n$$T = -G J \\dot\\Omega$$\nor\n$$T = SLIP$$\nwhere $u$ = $J \\dot\\Omega$ is the torque.",
        "-G u",
        "G u",
        5,
    ),
    "bold and plain letters": Planted(
        r"""At the point
$$r = \begin{bmatrix} 0 & b & 0 \end{bmatrix}^T$$
the velocity for a rate of $\omega = \begin{bmatrix} 0 & 0 & w \end{bmatrix}^T$ leads to
$$\boldsymbol{\omega} \times (\boldsymbol{\omega} \times \mathbf{r}) = \begin{bmatrix} 0 \\ SLIP \\ 0 \end{bmatrix}$$
""",
        "-w^2 b",
        "-w b",
        4,
    ),
    "a case in words": Planted(
        "The force is\n$$F = m a + k v^2$$\nFor $v = 0$ this becomes\n$$F = SLIP$$\n", "m a", "2 m a", 4
    ),
    "an implication": Planted(r"From the momentum $$h = r v = r^2 w \Rightarrow w = \frac{h}{SLIP}$$", "r^2", "r^3", 1),
    "an identity with a number": Planted(
        r"We use the hyperbolic identity $$\cosh^2 c SLIP \sinh^2 c = 1$$", "-", "+", 1
    ),
    "a matrix made of a vector": Planted(
        r"""The error of the rate is defined as
$$\delta\bm\omega = \bm\omega - \bm\nu$$
With the gain $[P]$ the rate of the function is
$$\dot V = \delta\bm\omega^T \left(-[P] \delta\bm\omega - [\tilde{\bm\omega}] \bm h + [\tilde{\bm\nu}] \bm h\right)
= \delta\bm\omega^T \left(-[P] \delta\bm\omega - [\widetilde{\delta\bm\omega}] \bm h\right)
= - SLIP\delta\bm\omega^T [P] \delta\bm\omega$$
""",
        "",
        "2 ",
        4,
    ),
    "a frame at the left": Planted(
        r"""The rate of the parameters is
$$\dot{\bm\sigma} = \frac{1}{4} \leftexp{B}{\bm\omega}_{B/R}$$
so that the function $V = 2 \bm\sigma^T \bm\sigma$ changes by
$$\dot V = SLIP \bm\sigma^T \left(\leftexp{B}{\bm\omega}_{B/R}\right)$$
where $\bm\omega_{B/R}$ is the angular velocity.
""",
        "",
        "2",
        4,
    ),
    "labels in two types": Planted(
        r"""The rate of the function is
$$\dot V_{\omega} = \bm x^T \left([J_{RW}] \bm y + [K] \bm z\right)$$
Let us assume that a torque acts that is not known. Substituting the motion leads to
$$\dot V_{\bm\omega} = - \bm x^T [P] \bm x SLIP \bm x^T \bm L$$
It yields the motion
$$[J_{\text{RW}}] \bm y + [P] \bm x + [K] \bm z = \bm L$$
""",
        "+",
        "-",
        6,  # or line 4, with which it is told
    ),
    "a rate of change": Planted(
        r"""The function is
$$V = \frac{1}{2} \kappa x^2 + \frac{1}{4} \gamma x^4$$
and the motion is
$$\dot x = -\beta x$$
so that its rate is
$$\dot V = SLIP \beta \kappa x^2 - \beta \gamma x^4$$
""",
        "-",
        "",
        6,
    ),
    "a function of any component": Planted(
        r"""To control how fast it reaches its limit, we add a term:
$$\label{f} f(\sigma_i) = \arctan\left((k \sigma_i + c \sigma_i^3) \frac{\pi}{2 w}\right) \frac{2 w}{\pi}$$
Using the definition in \eqref{f}, its slope is
$$\frac{\partial f}{\partial\sigma_i}
= \frac{k + SLIP c \sigma_i^2}{1 + (k \sigma_i + c \sigma_i^3)^2 \left(\frac{\pi}{2 w}\right)^2}$$
""",
        "3",
        "2",
        4,
    ),
    "sections of a chapter": Planted(CHAPTERS, "a (1 - e)", "a (1 + e)", 17),
    "colons around a formula": Planted(
        ":::{math}\n:label: eq:one\na = b + 2 c\n:::\nand\n:::{math}\n:label: eq:two\nb = c - d\n:::\n"
        "Substituting {eq}`eq:two` into {eq}`eq:one`, we find\n:::{math}\na = SLIP\n:::\n",
        "3 c - d",
        "3 c + d",
        12,
    ),
    "a gradient by a letter that is written out": Planted(
        r"""# Motion

With the coordinates
$$q = \begin{bmatrix} x \\ \varphi \end{bmatrix}$$
the Lagrangian is
$$\mathcal{L} = T - V$$
with
$$T = \frac{1}{2} m \dot{x}^2 + c \dot{x} \dot{\varphi} \cos\varphi$$
and
$$V = g \cos\varphi$$
which gives
$$\mathcal{L} = \frac{1}{2} m \dot{x}^2 + c \dot{x} \dot{\varphi} \cos\varphi - g \cos\varphi$$

## Equations

Its derivatives are
$$\frac{\partial \mathcal{L}}{\partial \dot{q}} = \begin{bmatrix} m \dot{x} + c \dot{\varphi} \cos\varphi \\
c \dot{x} \cos\varphi \end{bmatrix}$$
and
$$\frac{\partial \mathcal{L}}{\partial q}
= \begin{bmatrix} 0 \\ -c \dot{x} \dot{\varphi} \sin\varphi SLIP g \sin\varphi \end{bmatrix}$$
""",
        "+",
        "-",
        20,
    ),
    "a row of derivatives beside a column": Planted(
        "# Forces\n\nThe energy is\n$$V = \\frac{1}{2} k x^2 + c x y^3$$\nand its gradient is\n"
        r"$$\nabla V = \begin{bmatrix} \frac{\partial V}{\partial x} & \frac{\partial V}{\partial y} \end{bmatrix} = "
        r"\begin{bmatrix} k x + c y^3 \\ SLIP c x y^2 \end{bmatrix}$$",
        "3",
        "2",
        6,
    ),
    "a derivative in another section": Planted(
        "# Springs\n\n## Energy\n\nThe energy is\n$$V = \\frac{1}{2} k x^2 + c x y^3 + m g y$$\n\n## Forces\n\n"
        "Its slope is\n$$\\frac{\\partial V}{\\partial x} = k x + SLIP y^3$$\n",
        "c",
        "2 c",
        11,
    ),
    "the entry of a printed matrix": Planted(
        "# Stability\n\nThe matrix is\n"
        r"$$A = \begin{bmatrix} 0 & 1 \\ \frac{(M + m) g}{l M} & -\frac{d}{l^2} \end{bmatrix}$$"
        "\nNote the entry $A_{2,1} = \\frac{(M SLIP m) g}{l M}$, which is positive.\n",
        "+",
        "-",
        5,
    ),
    "an entry by a small letter": Planted(
        "# Stability\n\nThe matrix is\n"
        r"$$A = \begin{pmatrix} 0 & 1 \\ \frac{(M + m) g}{l M} & -\frac{d}{l^2} \end{pmatrix}$$"
        "\nwith the frequency\n$$w^2 = a_{2 1}$$\nthat is\n$$w^2 = SLIP \\frac{(M + m) g}{l M}$$\n",
        "",
        "2",
        8,
    ),
    "an identity matrix": Planted(
        "# Steps\n\nIn one step the state changes by\n$$\\frac{q_{k+1} - q_k}{h} = A q_k + B u_k$$\n"
        "or, with the identity matrix $I$,\n$$q_{k+1} = (I SLIP A \\cdot h) q_k + (B \\cdot h) u_k$$\n",
        "+",
        "-",
        6,
    ),
    "a difference turned around": Planted(
        "The axes are\n$$b = a \\sqrt{e^2 - 1}$$\nand\n$$c = a e$$\nso that\n$$b = \\sqrt{SLIP}$$\n",
        "c^2 - a^2",
        "a^2 - c^2",
        6,
    ),
    "fields by several coordinates": Planted(
        "# Stresses\n\nWe choose a function $\\phi$ to satisfy the equilibrium equations so that\n"
        "\\begin{align}\n\\sigma_{xx} &= \\frac{\\partial^2 \\phi}{\\partial y^2} + \\psi \\\\\n"
        "\\sigma_{yy} &= \\frac{\\partial^2 \\phi}{\\partial x^2} + \\psi\n\\end{align}\n"
        "We must also satisfy the compatibility equations. For plane strain, we have\n"
        r"$$\left(\frac{\partial^2}{\partial x^2} + \frac{\partial^2}{\partial y^2}\right) (\sigma_{xx} + \sigma_{yy})"
        r" - c \left(\frac{\partial^2 \psi}{\partial x^2} + \frac{\partial^2 \psi}{\partial y^2}\right) = 0$$"
        "\nSubstituting in the stress components leads to\n"
        r"$$\frac{\partial^4 \phi}{\partial x^4} + SLIP \frac{\partial^4 \phi}{\partial x^2 \partial y^2}"
        r" + \frac{\partial^4 \phi}{\partial y^4} + (2 - c)"
        r" \left(\frac{\partial^2 \psi}{\partial x^2} + \frac{\partial^2 \psi}{\partial y^2}\right) = 0$$"
        "\n",
        "2",
        "",
        11,
    ),
    "an operator with a name": Planted(
        "# Oscillators\n\nThe motion is\n$$\\mathcal{D} x(t) = f(t)$$\nwith the operator\n"
        r"$$\mathcal{D} = \frac{d^2}{dt^2} + 2 \beta \frac{d}{dt} + \omega^2$$"
        "\nIt reads\n$$\\frac{d^2 x(t)}{dt^2} + SLIP \\beta \\frac{d x(t)}{dt} + \\omega^2 x(t) = f(t)$$\n",
        "2",
        "3",
        8,
    ),
    "exchanged entries": Planted(
        r"$$L = \begin{pmatrix} 1 & 1 \\ 1 & -1 \end{pmatrix} \begin{pmatrix} u \\ v \end{pmatrix}"
        r" = \begin{pmatrix} SLIP \end{pmatrix}$$",
        r"u + v \\ u - v",
        r"u - v \\ u + v",
        1,
    ),
    "an entry beside a zero": Planted(
        r"$$L = \begin{pmatrix} a & 0 \\ 0 & b \end{pmatrix} \begin{pmatrix} u \\ 0 \end{pmatrix}"
        r" = \begin{pmatrix} SLIP a u \\ 0 \end{pmatrix}$$",
        "",
        "2",
        1,
    ),
    "a chain whose first member may be complex": Planted(
        "The solution is\n$$z(t) = A e^{-i \\delta} e^{i \\omega t} = A e^{i (\\omega t SLIP \\delta)}$$\n", "-", "+", 2
    ),
    "a row times a matrix times a column": Planted(
        r"The energy is $$T = \frac{1}{2} \begin{pmatrix} u & v \end{pmatrix}"
        r" \begin{pmatrix} a & b \\ b & c \end{pmatrix}"
        r" \begin{pmatrix} u \\ v \end{pmatrix} = \frac{1}{2} (a u^2 + SLIP b u v + c v^2)$$",
        "2",
        "",
        1,
    ),
    "a chain behind other words for roots": Planted(
        "The turning points are the roots of the equation. For the potential\n"
        r"$$W = u^2 - SLIP m u = (u - m)^2 - m^2$$",
        "2",
        "",
        2,
    ),
    "a chain before its consequence": Planted(
        r"It is $$2 a = \frac{p (1 - e) + p (1 + e)}{(1 + e) (1 - e)} = \frac{2 p}{1 SLIP e^2}"
        r" \implies p = a (1 - e^2), \qquad b = c$$",
        "-",
        "+",
        1,
    ),
    "a consequence beside another equation": Planted(r"$$u = m + c \implies c = u SLIP m, \qquad d = v$$", "-", "+", 1),
    "an identity within a sentence": Planted(
        "Using the identity $\\mathbf{a} \\times (\\mathbf{b} \\times \\mathbf{c}) = "
        "\\mathbf{b} (\\mathbf{a} \\cdot \\mathbf{c}) SLIP \\mathbf{c} (\\mathbf{a} \\cdot \\mathbf{b})$, we go on.\n",
        "-",
        "+",
        1,
    ),
    "what one formula in a sentence gives": Planted(
        "The equation $(u - 13) (u - 7) - 16 = 0$ gives $u^2 - 20 u + SLIP = 0$, as we know.\n", "75", "65", 1
    ),
    "a slope at the end": Planted(
        "A cable sags by\n$$y(x) = \\frac{q x (L - x)}{2 H}$$\nso that its slope at the support is\n"
        "$$y'(0) = \\frac{q L}{SLIP H}$$\n",
        "2",
        "3",
        4,
    ),
    "a slope at a letter, which stands in the function too": Planted(
        "Oil flows down a wire with the velocity\n$$v(z) = k (b^2 - z^2)$$\nand the stress is\n"
        "$$-\\eta v'(b) = SLIP \\eta k b$$\n",
        "2",
        "",
        4,
    ),
    "a density and its integral": Planted(
        "The layer has the density\n$$n(x) = \\frac{N}{SLIP \\sqrt{\\pi}} e^{-x^2/s^2}$$\n"
        "where $s > 0$. In all there are\n"
        "$$\\int_{-\\infty}^{\\infty} n(x) \\, dx = N$$\nmolecules with the spread\n"
        "$$\\frac{1}{N} \\int_{-\\infty}^{\\infty} x^2 n(x) \\, dx = \\frac{s^2}{2}.$$\n",
        "s",
        "2 s",
        2,
    ),
    "an integral over a letter that stands without brackets": Planted(
        "The load of the ring is\n$$p = 3 - 2 \\cos^2\\theta$$\nwith the mean\n"
        "$$\\frac{1}{2\\pi} \\int_0^{2\\pi} p \\, d\\theta = SLIP.$$\n",
        "2",
        "1",
        2,  # or line 4, with which it is told
    ),
    "a function and its partial derivatives": Planted(
        "A string moves as\n$$y(x, t) = a \\sin(k x) \\cos(c k t)$$\nwhich fulfils\n"
        "$$\\frac{\\partial^2 y}{\\partial t^2} = SLIP \\frac{\\partial^2 y}{\\partial x^2}$$\n",
        "c^2",
        "c",
        4,
    ),
    "a sum with its value": Planted(
        "The numbers have the sums\n$$\\sum_{j=1}^N (2 j - 1) = N^2, \\qquad "
        "\\sum_{j=1}^N j^3 = \\frac{N^2 (N SLIP 1)^2}{4}.$$\n",
        "+",
        "-",
        2,
    ),
    "a rate of a rate": Planted(
        "The charges move as\n$$\\dot x = -\\mu y, \\qquad \\dot y = \\mu x$$\nso that\n$$\\ddot x = -SLIP x$$\n",
        "\\mu^2",
        "\\mu",
        4,
    ),
    "arguments without brackets": Planted(
        "The rod bends as\n$$w(x) = b \\frac{\\sinh n(L - x)}{\\sinh n L}$$\nwith the slope\n"
        "$$w'(x) = SLIP b n \\frac{\\cosh n(L - x)}{\\sinh n L}.$$\n",
        "-",
        "",
        4,
    ),
    "a number named by two letters": Planted(
        "With the Reynolds number\n$$\\mathrm{Re} = \\frac{\\rho v d}{\\eta}$$\nand the friction\n"
        "$$f = \\frac{64}{\\mathrm{Re}}$$\nwe have\n$$f = \\frac{64 \\eta}{\\rho v SLIP}.$$\n",
        "d",
        "d^2",
        6,
    ),
}


def told(folder: Path, text: str) -> list[str]:
    (folder / "paper.md").write_text(text, encoding="utf-8")
    return [finding.place for finding in look(folder / "paper.md").findings]


def test_two_disagreements_that_share_nothing_are_told_each(tmp_path: Path) -> None:
    one, other = PLANTED["a rate of change"], PLANTED["a frame at the left"]
    wrong = [each.text.replace("SLIP", each.wrong) for each in (one, other)]
    assert told(tmp_path, "# One\n\n" + wrong[0] + "\n# Another\n\n" + wrong[1]) == ["line 8", "line 15"]


@pytest.mark.parametrize("name", every(2, PLANTED))
def test_a_slip_is_told_and_the_right_text_is_not_accused(name: str, tmp_path: Path) -> None:
    planted = PLANTED[name]
    assert told(tmp_path, planted.text.replace("SLIP", planted.right)) == []
    places = told(tmp_path, planted.text.replace("SLIP", planted.wrong))
    assert {f"line {planted.line}"} == {*places}


SOUND = {
    "a trial solution": "The motion is\n$$\\ddot x + 2 b \\dot x + c x = 0$$\nWe insert\n$$x(t) = A e^{\\lambda t}$$\n"
    "and find\n$$\\lambda^2 + 2 b \\lambda + c = 0.$$\n",
    "a rate by a letter of the function": "The pressure is\n$$P(v) = \\frac{R T}{v - b} - \\frac{a}{v^2}$$\n"
    "and varies with the temperature as\n$$\\frac{\\partial P}{\\partial T} = \\frac{R}{v - b}.$$\n",
    "a constant that an integral says": "The wave is\n$$\\psi(x) = A e^{-x^2/2}$$\nIts norm is\n"
    "$$\\int_{-\\infty}^{\\infty} \\psi(x)^2 \\, dx = 1,$$\nwhich says what $A$ is.\n",
    "a value at a letter": "The front has the curvature\n"
    "$$R(z) = z \\left(1 + \\left(\\frac{z_R}{z}\\right)^2\\right)$$\n"
    "and at $z_R$ it is\n$$R(z_R) = 2 z_R.$$\nThe width is\n"
    "$$w(z) = w_0 \\sqrt{1 + \\left(\\frac{z}{z_R}\\right)^2}$$\n"
    "and there\n$$w(z_R) = \\sqrt{2} w_0.$$\n",
    "an integral over a period": "With the period $T = 2\\pi/\\omega$ the mean vanishes:\n"
    "$$\\int_0^T \\sin(\\omega t) \\, dt = 0$$\nand the ends are where\n"
    "$$\\int_0^b (x - b^2) \\, dx = \\frac{b^2}{4}$$\nholds.\n",
    "a rate of what is made of another letter": "The level falls as\n$$\\dot x = a x - b y$$\nwhere\n$$y = k x^2$$\n"
    "so that\n$$\\ddot x = a \\dot x - 2 b k x \\dot x.$$\n",
    "two functions of one name": "The first beam bends by\n$$w(x) = a x^2$$\nand has at its end\n$$w(L) = a L^2$$\n"
    "with the slope\n$$w'(L) = 2 a L.$$\n",
    "rounded numbers": r"The sine is $$\sin 30^\circ + 0.1 = 0.5 + 0.1 = 0.6$$ and $$2 \cdot 0.33 = 0.7$$",
    "a length beside its vector": "With\n$$\\mathbf{r} = [x, y, 0]$$\nand\n$$r^2 = x^2 + y^2$$\nwe get\n$$r = 2 x$$\n",
    "another case": "The speed\n$$v = \\sqrt{\\frac{m}{r}}$$\nFor $E = 0$ it becomes\n$$v = \\sqrt{\\frac{2 m}{r}}$$",
    "a half angle": "The half-angle formulas of trigonometric functions give\n"
    r"$$\sin\frac{\theta}{2} = \mathrm{sgn}(\sin\theta) \sqrt{\frac{1 - \cos\theta}{2}}$$",
    "negative numbers": r"For $x < 0$ we have $$y = \sqrt{x^2} + 3 x = -x + 3 x$$",
    "a naive implication": r"It is wrong to say that $$a^2 = b^2 \Rightarrow a = b$$",
    "a gradient of what depends on others": "The distance is\n$$r = \\sqrt{x^2 + y^2}$$\nand the energy\n"
    "$$V = \\frac{1}{2} k r^2$$\nwith the gradient\n"
    r"$$\begin{bmatrix} \frac{\partial V}{\partial x} \\ \frac{\partial V}{\partial y} \end{bmatrix}"
    r" = \begin{bmatrix} k x \\ k y \end{bmatrix}$$",
    "a row counted from zero": "The matrix is\n$$A = \\begin{bmatrix} a & b + c \\\\ 2 b & 3 c \\end{bmatrix}$$\nwith\n"
    "$$A_{01} = b + c$$\nand\n$$A_{11} = 3 c$$\nand\n$$A_{00} = a$$\n",
    "constants of springs beside their matrix": "The stiffness is\n"
    r"$$K = \begin{bmatrix} k_{11} + k_{12} & -k_{12} \\ -k_{12} & k_{22} + k_{12} \end{bmatrix}$$"
    "\nwith\n$$k_{11} = \\frac{a b}{c}$$\nand\n$$k_{12} = \\frac{a}{b + c}$$\n",
    "a moment of inertia": "The energy is\n$$T = \\frac{1}{2} (I + m l^2) w^2$$\nwhere $J$ is the identity, and\n"
    "$$T = \\frac{1}{2} I w^2 + \\frac{1}{2} m l^2 w^2$$\nwith\n$$I = \\frac{1}{12} m l^2$$\nso that\n"
    "$$T = \\frac{13}{24} m l^2 w^2$$\n",
    "some constant": "The momentum is\n$$h = r^2 w = \\text{constant}$$\nand the area\n"
    "$$\\dot A = \\frac{1}{2} r^2 w = \\frac{h}{2} = \\text{constant}$$\n"
    "so that\n$$\\ln p = a + \\mathrm{const}$$\nand\n$$\\ln p = 2 a + \\mathrm{const.}$$\n",
    "symmetric entries": r"The energy is $$T = \begin{pmatrix} u & v \end{pmatrix}"
    r" \begin{pmatrix} I_{xx} & I_{xy} \\ I_{yx} & I_{yy} \end{pmatrix}"
    r" \begin{pmatrix} u \\ v \end{pmatrix} = I_{xx} u^2 + 2 I_{xy} u v + I_{yy} v^2$$",
    "choices in two cases": "# Cases\n\nWe choose\n$$u = a + b$$\nso that\n$$w = (a + b)^2$$\nNow we set\n"
    "$$u = a - b$$\nand\n$$z = u^2$$\n",
    "what holds at a place": "The rod is held, so that\n$$u = 0 \\text{ at } x = l$$\nand its displacement is\n"
    "$$u = \\frac{q x}{2 k} (l - x)$$\n",
    "other sections": "# Orbits\n\n## Circles\n\n$$v = \\sqrt{\\frac{m}{r}}$$\n\n$$h = r v$$\n\n$$h = \\sqrt{m r}$$\n\n"
    "## Escape\n\nThe speed is\n\n$$v = \\sqrt{\\frac{2 m}{r}}$$\n",
}


@pytest.mark.parametrize("name", every(2, SOUND))
def test_nothing_is_said_against_a_sound_text(name: str, tmp_path: Path) -> None:
    assert told(tmp_path, SOUND[name]) == []


# the points that are tried are positive
BOUNDS = {
    "x < 0": True, r"x \le -1": True, r"x \leq 0": True, "-2 < x < -1": True, "0 > x": True,
    r"x \leqslant 0": True, r"-1 \ge x": True,
    "x > 0": False, r"x \ge 1": False, "0 < x < 1": False, r"x \leftarrow 0": False, r"x \leqslant 5": False,
}  # fmt: skip


@pytest.mark.parametrize(("bound", "negative"), BOUNDS.items())
def test_bounds_below_which_numbers_are_negative_are_known(bound: str, negative: bool) -> None:
    assert (NEGATIVE.search(bound) is not None) is negative
