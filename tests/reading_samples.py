"""A notation and printed formulas for the tests of the reader; the displays of the source text where it is at hand."""

from __future__ import annotations

import re
from pathlib import Path

from symcheck.reading import Letter, Notation

NOTATION = Notation(
    [
        *(Letter(index, kind="index") for index in "ijks"),
        *(Letter(latex, indices=1) for latex in ("I", "J", "L", "k", "M", r"\bar{k}", r"\omega", r"\dot{\omega}")),
        *(Letter(latex, indices=2) for latex in "amb"),
        *(Letter(latex, depends="") for latex in ("k", "p", "c", "f", "t", r"\xi", r"\alpha", r"\beta", r"\gamma")),
        Letter(r"\pi"),
        Letter("Ox", indices=1),
        Letter("Oy", indices=1),
        Letter("f_1", kind="function", depends="J_2"),
        Letter("n", kind="index"),
        Letter(r"\zeta", indices=1, range=(1, 2, 3, 4, 5, 6)),
        Letter("d", kind="differential"),
        Letter(r"\boldsymbol{\omega}", kind="vector", components=r"(\omega_1, \omega_2, \omega_3)"),
        Letter(r"\dot{\boldsymbol{\omega}}", kind="vector", components=r"(\dot\omega_1, \dot\omega_2, \dot\omega_3)"),
        Letter(r"\mathbf{e}", kind="vector", indices=1, components=r"(a_{i1}, a_{i2}, a_{i3})"),
        Letter(r"\mathbf{E}", kind="vector", indices=1),
        Letter(r"\mathbf{K}", kind="vector", named=True),
        Letter(r"\mathbf{M}", name="N", kind="vector"),
        Letter(r"\mathbf{A}", kind="matrix", components=r"\|a_{ij}\|"),
        Letter(r"\mathbf{m}", kind="matrix", components=r"\|m_{ij}\|"),
        Letter(r"\mathbf{I}", kind="matrix", components=r"\operatorname{diag}(I_1, I_2, I_3)"),
        Letter(r"\mathbf{S}", kind="matrix"),
        Letter(r"\mathbf{B}", kind="matrix"),
    ]
)
ELLIPSOID = NOTATION.extended(Letter("a"), Letter("b"), Letter("d"))

ROTATED = (
    r"J_1 J_3 = (I_1 a_{11} a_{31} + I_2 a_{12} a_{32} + I_3 a_{13} a_{33})^2"
    r" + I_1 I_2 a_{23}^2 + I_2 I_3 a_{21}^2 + I_3 I_1 a_{22}^2. \quad (2.12)"
)
CHARACTERISTIC = r"""\begin{aligned} I_1 I_2 I_3 p^3
+ \left[k_1 (I_2 I_3 a_{11}^2 + I_3 I_1 a_{12}^2 + I_1 I_2 a_{13}^2) + \right. \\
\left. + k_2 (I_2 I_3 a_{21}^2 + I_3 I_1 a_{22}^2 + I_1 I_2 a_{23}^2) \right] p^2 + \\
+ k_1 k_2 k_3 = 0. \end{aligned} \quad (1.3)"""
TORQUE = (
    r"M_i = (\mathbf{M}, \mathbf{E}_i) = -\sum_{j=1}^3 k_j \left(\sum_{s=1}^3 \omega_s a_{js} \right) a_{ji} =",
    r"= -\sum_{s=1}^3 m_{is} \omega_s,",
)
SAMPLES: tuple[str | tuple[str, ...], ...] = (
    r"\frac{d\mathbf{K}}{dt} = \mathbf{M},",
    r"\mathbf{K} = \mathbf{I}\boldsymbol{\omega}, \quad \mathbf{M} = M_1\mathbf{e}_1 + M_2\mathbf{e}_2.",
    r"M_i = -k_i(\boldsymbol{\omega}, \mathbf{e}_i),",
    r"\mathbf{I}\dot{\boldsymbol{\omega}} + \boldsymbol{\omega} \times \mathbf{I}\boldsymbol{\omega}"
    r" = -\sum_{i=1}^3 k_i(\boldsymbol{\omega}, \mathbf{e}_i)\mathbf{e}_i \quad (1.1)",
    TORQUE,
    r"\mathbf{m} = \mathbf{S}^T \mathbf{B} \mathbf{S}",
    r"\mathbf{m} = \mathbf{A}^T \begin{pmatrix} k_1 & 0 & 0 \\ 0 & k_2 & 0 \\ 0 & 0 & k_3 \end{pmatrix} \mathbf{A},",
    r"\omega_1 = \omega_2 = \omega_3 = 0,",
    CHARACTERISTIC,
    r"""\begin{aligned} J_i &= I_1 a_{i1}^2 + I_2 a_{i2}^2 + I_3 a_{i3}^2, \\
    L_i &= I_2 I_3 a_{i1}^2 + I_3 I_1 a_{i2}^2, \quad (i = 1, 2, 3) \\ \bar{k}_i &= k_i / J_i. \end{aligned}""",
    r"a_{ij} = \cos(Oy_i, Ox_j).",
    r"I_1 I_2 I_3 \leq J_1 J_2 J_3 \leq \left(\frac{I_1 + I_2 + I_3}{3} \right)^3, \quad (2.1)",
    r"f = J_2 \cdot \frac{1}{4} \left[(J_1 + J_3)^2 - (J_1 - J_3)^2 \right] \leq \frac{1}{4} J_2 (3c - J_2)^2,",
    r"f_1(J_2) = \frac{1}{4} J_2 (3c - J_2)^2.",
    r"[0, 3c/2]",
    r"\max f_1",
    r"I_1 + I_2 + I_3 \geq 2I_i, \quad i = 1, 2, 3. \quad (2.3)",
    r"\frac{df_1}{dJ_2} = \frac{3}{4}(3c - J_2)(c - J_2), \quad \frac{d^2 f_1}{dJ_2^2} = \frac{3}{2}(J_2 - 2c),",
    r"J_i = \sum_{k=1}^3 I_k a_{ik}^2 = c, \quad i = 1, 2, 3, \quad (2.4)",
    r"a_{12} = \sin \alpha \sin \gamma - \cos \alpha \sin \beta \cos \gamma,",
    r"\sin \beta = 1/\sqrt{3}, \quad \sin^2 \gamma = 1/2",
    r"a_{12}^2 = \frac{1}{3} \left(1 - \frac{1}{2} \cos 2\alpha - \frac{\sqrt{3}}{2} \sin 2\alpha \right), \quad (2.8)",
    r"\operatorname{tg} 2\alpha = \sqrt{3} \frac{I_1 - c}{I_2 - I_3}. \quad (2.9)",
    ROTATED,
    r"a_{21} a_{22} = 0, \quad a_{22} a_{23} = 0, \quad a_{23} a_{21} = 0; \quad (2.14)",
    r"I_1 \neq I_2 \neq I_3",
    r"""\begin{aligned} 1). \quad a_{11}^2 = a_{22}^2 = a_{33}^2 = 1; & \quad
    2). \quad a_{11}^2 = a_{23}^2 = 1; \\ 3). \quad a_{12}^2 = a_{21}^2 = a_{33}^2 = 1. \end{aligned} \tag{2.17}""",
    r"|\mathbf{A}| = 1",
    r"\mathbf{A} = \|a_{ij}\|",
    r"(a_{11} = 1 \lor a_{12} = 0) \land J_1 = J_2 \Rightarrow \exists \alpha, \beta : \sin \alpha = 0 \land J_i > 0",
    r"J_1 = J_2 = J_3 \Leftrightarrow (I_1 = c, I_2 = c)",
    r"\int_0^\infty c^{m_{12}} (c^2 + 1)^{-k/2} \, dc < \infty \Leftrightarrow k > 1",
    r"\int_{-\infty}^{\infty} \exp(-c^2) \, dc = \sqrt{\pi} = \Gamma(1/2)",
    r"\langle \cos^2 \alpha + p \sin \alpha \rangle_\alpha = \frac{1}{2}",
    r"J_1 = -c \pm 2 \sqrt{k(c - k)} = -(\sqrt{k} \mp \sqrt{c - k})^2",
    r"(\zeta_1, \dots, \zeta_6) = (1, 2, 3, 4, 5, 6)",
    r"\alpha \in [0, 2\pi), \quad \beta \in (0, c], \quad \gamma \in (0, c)",
    r"(c^2 k)''_{cc} - (p k)'_k = \frac{\partial^2}{\partial c \partial k} (c k)",
    r"\ln c = k \operatorname{arctg} p, \quad c = 1, 2, \dots",
    r"J_1, J_2 > 0, \quad 0 < k, c, p < 1",
    r"\frac{df_1(c)}{dc} = f_1'(k) f_1^2(p + 1) - f_1",
    r"c = \sum_{n=1}^{\infty} k^n",
)


def formulas_of(sources: Path, paper: str) -> tuple[list[str], list[str]]:
    """The displayed and the inline formulas of the source text whose name begins so."""
    (path,) = sources.glob(f"{paper}_*.txt")
    text = path.read_text(encoding="utf-8")
    inside = re.sub(r"\$\$.*?\$\$", "", text, flags=re.DOTALL)
    return re.findall(r"\$\$(.*?)\$\$", text, re.DOTALL), re.findall(r"\$(.+?)\$", inside, re.DOTALL)


def displays(sources: Path) -> list[tuple[str | tuple[str, ...], Notation]]:
    """Every displayed block of the first paper; a block that begins with a sign continues the one before."""
    found: list[str | tuple[str, ...]] = []
    for block in formulas_of(sources, "000")[0]:
        if re.match(r"\s*(\\begin\{aligned\})?[\s&]*=", block):
            found[-1] = (str(found[-1]), block)
        else:
            found.append(block)
    return [(block, ELLIPSOID if "d^2}" in str(block) else NOTATION) for block in found]


def inline(sources: Path) -> list[str]:
    """Every inline formula of the first paper that states a relation."""
    return [latex for latex in formulas_of(sources, "000")[1] if re.search(r"=|\\neq|\\leq|\\geq", latex)]
