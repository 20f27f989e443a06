"""Wrong statements, made by hand, in the place of right ones: what a tired author or reader might have written."""

from __future__ import annotations

import pytest
from sampling import every

from symcheck.audit import context_of, obligation_of, units
from symcheck.audit.judge import judge
from symcheck.core.ids import Id
from symcheck.core.verdicts import Verdict
from symcheck.reading import read

# by the number of the right statement, with the letter of its link
BAD: dict[str, list[tuple[str, str]]] = {
    "poloskov2004": [
        ("1.1", r"\mathbf{f} = [kx_2x_3, -kx_3x_1, 0]^T"),
        ("2.1b", r"\tilde{x}_2 = a \sin\psi"),
        ("2.3.1a", r"\dot{a} = \dot{x}_1 \sin\psi - \dot{x}_2 \cos\psi"),
        ("2.3.1b", r"\dot{\theta} = \Omega - \frac{\dot{x}_1 \sin\psi + \dot{x}_2 \cos\psi}{a}"),
        ("3.1.2a", r"K_i = v_i"),
        ("3.1.2a", r"K_i = v_i + \sum_{j=1}^3 \sum_{k=1}^6 \frac{\partial h_{ik}}{\partial y_j} h_{jk}"),
        ("3.2.4a", r"\bar{K}_{11} = \frac{1}{2} a^2 \alpha^2 + \frac{1}{2} \beta^2"),
        ("3.2.4b", r"\bar{K}_{22} = \frac{1}{8} \alpha^2 + \frac{1}{2} \beta^2"),
        ("3.2.5a", r"\bar{K}_1 = -\frac{a}{2} \gamma^2 + \frac{3}{16} a\alpha^2 + \frac{1}{4a} \beta^2"),
        ("3.2.5a", r"\bar{K}_1 = -\frac{a}{2} \gamma^2"),
        ("3.2.5b", r"\bar{K}_2 = \frac{1}{2}(d_{12} + d_{21})"),
        ("3.2.5c", r"\bar{K}_3 = (-d_{33} + g_{13}^2) \Omega"),
        (
            "3.3.9a",
            r"\frac{1}{2} \bar{K}_{11} \frac{\partial^2 p_{s1}}{\partial a^2} - \bar{K}_1 \frac{\partial p_{s1}}{\partial a} = 0",
        ),
        ("3.4", r"p_{s1}(a) = 8C_1 \Delta_1^{\kappa_1}"),
        ("3.5b", r"\kappa_1 = -\frac{4\gamma^2}{3\alpha^2}"),
        ("3.5.1b", r"\kappa_2 = -\frac{d_{33}}{g_{13}^2}"),
        ("4.0.3", r"\int_0^\infty a \Delta_1^{\kappa_1} \, da < \infty \Leftrightarrow 4\gamma^2 \geq \alpha^2"),
        ("4.0.5", r"\int_{-\infty}^\infty \Delta_2^{\kappa_2} \, d\Omega < \infty \Leftrightarrow d_{33} > g_{13}^2"),
        (
            "4.0.9",
            r"\int_0^\infty a^m a \Delta_1^{\kappa_1} \, da < \infty \Leftrightarrow 8\gamma^2 > \alpha^2(3 + 2m)",
        ),
        (
            "4.0.11",
            r"\int_0^\infty \Omega^m \Delta_2^{\kappa_2} \, d\Omega < \infty \Leftrightarrow d_{33} > mg_{13}^2",
        ),
        ("4.0.13", r"a_* = \sqrt{\frac{\beta^2}{8\gamma^2 + \alpha^2}}"),
        ("4.0.26", r"C_1 = 2"),
        ("4.0.29", r"\int_{-\infty}^\infty p_{s3}(\Omega) \, d\Omega = 1 \Leftrightarrow C_2 = \frac{2k}{\pi}"),
        ("B.12", r"\bar{K}_{12} = 0"),
    ],
    "esenkov2006": [
        ("2.3.2", r"\eta^2(A - E_1) + \eta(\Delta\omega_0 - A\lambda_1) - \Delta\omega_0\lambda_1 = 0"),
        ("2.3.4a", r"D = (\Delta\omega_0 + \omega_0 E_n - A\lambda_n)^2 - 4(A - E_n)\Delta\omega_0\lambda_n"),
        ("1.31", r"A\eta + (A - C)\omega_0 - \eta(\eta - \omega_0)\sum_n \frac{E_n}{\eta - \lambda_n} = 0"),
        ("1.32", r"A\eta + (C - A)\omega_0 - \eta(\eta + \omega_0)\frac{E_1}{\eta - \lambda_1} = 0"),
        ("1.33", r"\eta^2(A + E_1) + \eta(\Delta\omega_0 + \omega_0 E_1 - A\lambda_1) - \Delta\omega_0\lambda_1 = 0"),
        ("1.33.4", r"(\Delta\omega_0 + \omega_0 E_n - A\lambda_n)^2 + 4A\Delta\omega_0\lambda_n = 0"),
        (
            "1.34",
            r"\left(\Delta + E_n - A\frac{\omega_0}{\lambda_n}\right)^2 + 4(A - E_n)\Delta\frac{\omega_0}{\lambda_n} = 0",
        ),
        ("1.34.3", r"\Delta^2 + \Delta(2Ab_n + 2E_n) + (Ab_n - E_n)^2 = 0"),
        ("1.34.3", r"\Delta^2 + \Delta(2Ab_n + 2E_n - 4E_nb_n) + (A - E_n)^2 = 0"),
        ("1.34.4a", r"D = 4(E_n + b_nA - 2E_nb_n)^2 - (Ab_n - E_n)^2"),
        ("1.34.4b", r"4(E_n + b_nA - 2E_nb_n)^2 - 4(Ab_n - E_n)^2 = 16E_n(b_n - 1)b_n(A - E_n)"),
        ("1.34.5a", r"\Delta_1 = -(Ab_n + E_n - 2E_nb_n) - 2\sqrt{E_n(1 - b_n)b_n(A - E_n)}"),
        ("1.34.5a", r"\Delta_1 = -(Ab_n + E_n - 2E_nb_n) + 4\sqrt{E_n(1 - b_n)b_n(A - E_n)}"),
        (
            "1.35d",
            r"-E_n(1 - b_n) - b_n(A - E_n) - 2\sqrt{E_n(1 - b_n)b_n(A - E_n)} = -(\sqrt{E_n(1 - b_n)} - \sqrt{b_n(A - E_n)})^2",
        ),
        ("B.9", r"\Delta^2 + \Delta(2Ab_n + 2E_n - 4E_nb_n) + (Ab_n - E_n)^2 < 0"),
        ("B.18", r"\Delta^2 + \Delta(2Ab_n + 2E_n - 4E_nb_n) + (Ab_n - E_n)^2 > A^2"),
        ("B.19", r"-(u - v)^2 = 0 \Leftrightarrow A = E_n"),
        ("B.28", r"(\Delta_1 - \Delta_2)^2 = 4E_n(1 - b_n)b_n(A - E_n)"),
    ],
    "ignatov2005": [
        ("2.0.3", r"(\mathbf{e}_i, \mathbf{e}_i) = \sin^2 b"),
        (
            "2.0.8",
            r"0^\circ < b < 45^\circ \Leftrightarrow (\mathbf{e}_4 + \mathbf{e}_1, \mathbf{e}_4 + \mathbf{e}_1) > (\mathbf{e}_4 - \mathbf{e}_3, \mathbf{e}_4 - \mathbf{e}_3)",
        ),
        ("2.1", r"\mathbf{H} = h_1 \mathbf{e}_1 + h_2 \mathbf{e}_2 + h_3 \mathbf{e}_3 - h_4 \mathbf{e}_4"),
        ("2.1.2b", r"H_y = (-h_1 + h_2 + h_3 - h_4) \sin a \cos b"),
        ("2.1.2c", r"H_z = (h_1 + h_2 - h_3 - h_4) \cos a"),
        ("2.1.11b", r"[1, 1, -1, 1] = (0, 0, 0)"),
        ("2.1.28", r"d_1 = 4 \sin a \cos b"),
        ("2.1.31", "d_4 = 4"),
        ("2.1.34b", r"\arctg \sqrt{2} = 54.8^\circ"),
        (
            "T2.1",
            r"4 \sin a \sin b \leq 4 \sin a \cos b \leq 4 \cos a \Leftrightarrow 0 \leq a \leq \arctg\left(\frac{1}{\sin b}\right)",
        ),
        (
            "T2.5",
            r"4 \cos a < 4 \sin a \sin b \leq 4 \sin a \cos b \Leftrightarrow \arctg\left(\frac{1}{\sin b}\right) \leq a \leq \frac{\pi}{2}",
        ),
        ("T3.1a", r"r_1 = \frac{2 \sin 2a \sin b}{\sqrt{1 - \sin^2 a \sin^2 b}}"),
        ("T3.1c", r"r_3 = 2 \sin a \sin b"),
        ("T5.1b", r"r_2 = \frac{\sin 2a \cos b}{\sqrt{1 - \sin^2 a \cos^2 b}}"),
        ("2.2.1c", r"H_z = (-h_1 + h_2 + h_3) \cos a"),
        ("2.2.18", r"d_1 = \sqrt{9\sin^2 a \sin^2 b + 1}"),
        ("2.3b", r"w_y = \frac{H_y}{J_y}"),
        ("2.3.6b", r"\arctg \frac{5}{8} \approx 33^\circ"),
        ("2.3.8", r"\operatorname{tg} a = \frac{2}{\sin b}"),
        ("2.3.10c", r"-w_x \approx 0.003"),
        ("2.3.14", r"(h_1 + h_2 + h_3 + h_4)^2 + (-h_1 + h_2 - h_3 + h_4)^2 + (-h_1 - h_2 + h_3 + h_4)^2 \leq 3^2"),
        ("3.0.4b", r"e_2 = \left( \frac{\sqrt{3}}{2} \sin a, \frac{1}{2} \sin a, \cos a \right)"),
        ("3.1.2a", r"H_x = (h_2 + h_3 - h_5 - h_6) \frac{\sqrt{3}}{2} \sin a"),
        ("3.1.10a", r"[1, -1, 1, 1, -1, -1] = 0"),
        ("3.1.11", r"[h_1, h_2, h_3, h_4, h_5, h_6] = 0 \Leftrightarrow (h_2 = -h_1 \land h_3 = h_1 \land h_4 = -h_1)"),
        (
            "3.1.12a",
            r"\exists h_i : (-1 < h_i \land h_i < 1 \land [h_1, h_2, h_3, h_4, h_5, h_6] = [1, 1, 1, -1, -1, -1])",
        ),
        ("3.1.23c", r"\operatorname{diag}(-1, -1, 1) \mathbf{e}_1 = \mathbf{e}_4"),
        ("3.1.30", r"\sqrt{(\mathbf{V}_2, \mathbf{V}_2)} = 2\sqrt{3\sin^2 a + 1}"),
        (
            "T7.1",
            r"4\sin a < 2\sqrt{2\sin^2 a + 1} < 2\sqrt{3\cos^2 a + 1} < 6\cos a \Leftrightarrow 0^\circ \leq a \leq \arcsin \frac{\sqrt{2}}{2}",
        ),
        (
            "T7.13",
            r"6\cos a < 2\sqrt{3\cos^2 a + 1} < 2\sqrt{2\sin^2 a + 1} < 4\sin a \Leftrightarrow \arccos \frac{1}{\sqrt{6}} < a < 90^\circ",
        ),
        ("T7.10b", r"\arccos \sqrt{\frac{3}{11}} \approx 58.4^\circ"),
        ("T8.1", r"r_1 = 3 \sin 2a \sqrt{\frac{1}{3 + \cos^2 a}}"),
        ("T8.3", r"r_{13} = 2 \sin a"),
        (
            "3.2.13f",
            r"-\mathbf{V}_8 - (\mathbf{V}_1) = 2\mathbf{e}_6 \lor \mathbf{V}_1 - (-\mathbf{V}_8) = 2\mathbf{e}_6",
        ),
        ("3.2.15f", r"\mathbf{W}_1 = (\mathbf{V}_1 + \mathbf{V}_6)/2"),
        ("T10.5", r"\sqrt{(\mathbf{V}_7, \mathbf{V}_7)} = \sqrt{8\cos^2 a + 1}"),
        (
            "T11.2",
            r"r_2 = \frac{5}{2}\sin 2a\sqrt{\frac{3}{4-\sin^2 a}} \land r_5 = 2\sin 2a\sqrt{\frac{3}{4-\sin^2 a}}",
        ),
        ("3.2.20", r"\lambda^2 \leq \frac{1}{3}"),
        ("3.2.27b", r"-1 \leq h_i \leq 1 \Rightarrow H_y \leq 3 \sin a"),
        ("3.2.32a", r"\frac{4 \sin a}{J_y} = \frac{6 \cos a}{J_z} \Leftrightarrow a = \arctg 2"),
        ("3.2.36", r"-w_x \approx 0.0034"),
    ],
}
CASES = [(paper, number, latex) for paper, rows in BAD.items() for number, latex in rows]


@pytest.mark.parametrize("case", every(3, CASES), ids=[f"{paper}:{number}" for paper, number, _ in CASES])
def test_a_wrong_statement_in_the_place_of_a_right_one_is_not_proved(case: tuple[str, str, str]) -> None:
    paper, number, latex = case
    id = Id.of(paper, number)
    context = context_of(obligation_of(str(id.declaration)))
    (unit,) = (each for each in units(context) if each.letter == id.link)
    erratum = context.item.erratum(id.link)
    given = (*context.item.statement.given, *(erratum.needs if erratum else ()))
    assert judge(context, unit, given).verdict is Verdict.PROVED
    wrong = unit.reworded(context, read(latex, context.notation))
    assert judge(context, wrong, given).verdict is not Verdict.PROVED


@pytest.mark.parametrize("paper", BAD)
def test_there_are_enough_of_them(paper: str) -> None:
    assert len(BAD[paper]) >= 15
