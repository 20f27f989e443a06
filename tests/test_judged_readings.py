"""Readings of printed displays that were judged one by one, with what was refused or read wrongly before."""

from __future__ import annotations

import json

import pytest
from bracketed import bracketed
from judged_readings import JUDGED, REFUSED

from symcheck.core.terms import Malformed, Reader
from symcheck.core.verdicts import SymcheckError
from symcheck.question.answer import Status
from symcheck.question.ask import decide
from symcheck.reading import Tree, algebraic, lower, read, to_latex
from symcheck.reading.inference import inferred
from symcheck.reading.notation import Notation
from symcheck.reading.surface import plain, with_plain_differentials


def first_reading(latex: str) -> tuple[Tree, Notation]:
    """The first of the inferred readings that makes a tree; SymcheckError of the first if none does alone."""
    text, errors = with_plain_differentials(plain(latex)), list[SymcheckError]()
    for inference in (each for each in inferred([text], {}, {}) if not each.beside):
        try:
            return read(text, inference.notation), inference.notation
        except SymcheckError as error:
            errors.append(error)
    raise errors[0]


PART = 50  # readings in one test: to run one by one takes longer than to read them


@pytest.mark.parametrize("start", range(0, len(JUDGED), PART))
def test_displays_read_as_they_were_judged(start: int) -> None:
    found = [
        (bracketed(first_reading(latex)[0]), right, source) for latex, right, source in JUDGED[start : start + PART]
    ]
    assert [each for each in found if each[0] != each[1]] == []


@pytest.mark.parametrize(("latex", "source"), REFUSED)
def test_a_display_with_two_readings_states_nothing(latex: str, source: str) -> None:
    assert source
    with pytest.raises(SymcheckError):
        lower(*first_reading(latex))


OPAQUE = (
    r"\max_x \sin x = 2",
    r"y = \arg\min_{x} f(x)",
    r"\max_{x} f(x) = 1",
    r"P(A | B) = P(B | A)",
    r"p(x; n) = p(n; x)",
    r"y = \sum_{i \in S} a_i",
    r"y = \sum_i^N a_i",
    r"y = (a)_n",
    r"x = (A)^+ b",
    r"y = (a + b)'",
    r"x > 0, \quad \forall x \in S",
    r"C = 0 \quad \text{(during eclipse)}",
    r"A = \begin{bmatrix} a & \\ & b \end{bmatrix}",
    r"m = \int_V \rho \, dV",
    r"\oint_C f \, ds = 0",
    r"\sum F = m a",
    r"y = \left\| x \right\|_2^2",
    r"y = \left. \frac{df}{dx} \right|_{x_0}",
    r"\frac{{}^N d\bar{v}}{dt} = \bar{a}",
    r"y = \begin{bmatrix} a \\ b \end{bmatrix}'",
    r"\min_x (x - 1)^2 \quad \text{subject to} \quad x \ge 2",
    r"a = b, \quad \text{or} \quad b = a",
    r"y = \sum_{\substack{n=1 \\ n \text{ odd}}}^\infty a_n",
    r"a_1 = 1 \\ \vdots \\ a_n = n",
    r"= a + b",
    r"x = \begin{bmatrix} a \\ b \end{bmatrix}_{N}",
    r"f(x; a; b) = f(a; x; b)",
    r"v = f(x = a)",
    r"P(X > z) = 1 - P(X \le z)",
    r"P(X > z) = 0",
    r"y = \mathbb{1}(x > 0)",
    r"A = \mathbf{0}_{3 \times 2}",
    r"\partial_t \rho + \partial_x (\rho u) = 0",
    r"F_{\mu \nu} = \partial_\mu A_\nu - \partial_\nu A_\mu",
    r"\partial_t^2 u = c^2 \partial_{xx} u",
    r"\nabla_i Y = Z",
    r"\nabla \Lambda(D) \subsetneq M",
)


@pytest.mark.parametrize("latex", OPAQUE)
def test_what_has_no_algebraic_form_is_stated_as_it_is_printed(latex: str) -> None:
    tree, notation = first_reading(latex)
    assert read(to_latex(tree), notation) == tree
    with pytest.raises(SymcheckError, match="algebraic form"):
        algebraic(tree, notation)
    assert any(formula.tag == "form" for formula in lower(tree, notation))


PRIMED = r"T = \int_a^b \sqrt{1 + y'^2 + y} \, dx"


def test_a_prime_below_an_integral_makes_no_constant() -> None:
    assert decide(PRIMED.replace("T =", r"(b - a) \sqrt{1 + y'^2 + y} =")).verdict is not Status.PROVED
    assert all(formula.tag == "form" for formula in lower(*first_reading(PRIMED)))
    assert all(formula.tag != "form" for formula in lower(*first_reading(PRIMED.replace("'", "_1"))))


AT_A_PLACE = (
    r"\nabla^2 \phi(1) = 0",
    r"\nabla \exp(0) = 0",
    r"\nabla \Phi(2) = 0",
    r"\nabla \mathrm{relu}(3) = 0",
    r"u_{k,l} = u_{kl}, \quad k, l = 1, 2, 3",
)


@pytest.mark.parametrize("latex", AT_A_PLACE)
def test_a_derivative_at_a_place_is_not_that_of_a_constant(latex: str) -> None:
    assert decide(latex).verdict not in (Status.PROVED, Status.REFUTED)


OPEN = (  # of letters of which too little is known, beside another relation that prints other tokens
    (r"c = \langle \psi | \phi \rangle", r"c = \langle \phi | \psi \rangle"),
    (r"E = \langle \psi | \hat{H} | \psi \rangle", r"E = \langle \psi | \hat{V} | \psi \rangle"),
    (r"\rho = \sum_i p_i | \psi_i \rangle \langle \psi_i |", r"\rho = \sum_i p_i \langle \psi_i | \, | \psi_i \rangle"),
    (r"\hat{H} | \psi \rangle = E | \psi \rangle", r"| \psi \rangle \hat{H} = E | \psi \rangle"),
    (r"| a \rangle \langle b | = c", r"\langle b | \, | a \rangle = c"),
    (r"\partial_t u = v", r"\partial_x u = v"),
    (r"\partial_t (u v) = w", r"v \partial_t u = w"),
    (r"\dot{\mathbf{x}} = f(\mathbf{x}, u)", r"\dot{\mathbf{x}} = f(u, \mathbf{x})"),
    (r"\bar{u} = \mathbf{A}^{-1} \bar{b}", r"\bar{u} = \mathbf{A} \bar{b}"),
    (r"\mathbf{A} = (\mathbf{v}, \mathbf{w}, 0)", r"\mathbf{A} = (\mathbf{w}, \mathbf{v}, 0)"),
    (r"\mathbf{p} = \mathbf{q} \mathbf{r}", r"\mathbf{p} = \mathbf{r} \mathbf{q}"),
    (r"x[n+1] = a x[n]", r"x[n] = a x[n+1]"),
    (r"x \in \mathbb{R}^n", r"x \in \mathbb{R}^m"),
    (r"y \approx \sum_{i=1}^n w_i f_i", r"y \approx \sum_{i=0}^n w_i f_i"),
    (r"L = \sum_{i=1}^n m_i \mathbf{v}_i \mathbf{w}_i", r"L = \sum_{i=1}^n m_i \mathbf{w}_i \mathbf{v}_i"),
    (r"Q = Q^T \succeq 0", r"Q = Q^T \preceq 0"),
    (r"W = \int_a^b p \, dV", r"W = \int_a^b p \, dU"),
    (r"a_1 + \dots + a_n = b", r"a_1 - \dots + a_n = b"),
    (r"\mathbb{E}[X] = \sum_{i=1}^n p_i x_i", r"\mathbb{E}[X] = \sum_{i=0}^n p_i x_i"),
    (r"J = E\left[ \int_0^1 x \, dt \right]", r"J = E\left[ \int_0^1 t \, dt \right]"),
)  # fmt: skip


@pytest.mark.parametrize(("latex", "other"), OPEN)
def test_letters_of_unknown_kinds_leave_a_form_in_which_every_token_counts(latex: str, other: str) -> None:
    forms = [repr(lower(*first_reading(each))) for each in (latex, other)]
    assert all("form" in each for each in forms)
    assert forms[0] != forms[1]


@pytest.mark.parametrize("latex", [*OPAQUE, *(each for pair in OPEN for each in pair)])
def test_forms_are_never_decided(latex: str) -> None:
    assert decide(latex).verdict not in (Status.PROVED, Status.REFUTED)


TWO_WAYS = (
    r"u = 2 \pi(\theta, \dot{\theta})",
    r"\mathbf{u} = \sum_{(i, j) \in E} X_i X_j + Y_i Y_j",
    r"\mathcal{L} \{t\} = \mathbf{s}",
    r"\mathbf{M} = \bar{v}_1 \ldots \bar{v}_n",
    r"\delta \int_0^t (L + \mathbf{H}) \, dt = 0",
    r"\mathbf{y} = P_n(z)^m",
    r"\mathbf{u} = \int (x - r)",
    r"\mathbf{u} = \operatorname{some\,gain} f(x)",
    r"\delta \frac{\partial x}{\partial t} = \frac{\partial (\delta x)}{\partial t}",
    r"\mathbf{u} = \sum_n^N s[n] + t[n]",
    r"\mathbf{u} = \mathbf{v} \to \mathbf{w} = \mathbf{x}",
)


@pytest.mark.parametrize("latex", TWO_WAYS)
def test_what_may_be_applied_or_multiplied_has_no_form(latex: str) -> None:
    with pytest.raises(SymcheckError):
        lower(*first_reading(latex))


COMPLEX = (r"U(t) = e^{-i H t}", r"f(i x) = 2 f(x)", r"i \frac{\partial f}{\partial t} = H f")


@pytest.mark.parametrize("latex", COMPLEX)
def test_nothing_says_that_the_values_of_a_function_are_real(latex: str) -> None:
    (formula,) = lower(*first_reading(latex))
    assert formula.tag == "form"
    assert decide(latex).verdict not in (Status.PROVED, Status.REFUTED)


def test_what_is_real_may_be_said_of_complex_numbers() -> None:
    assert decide(r"e^{i x} = \cos x + i \sin x").verdict is Status.PROVED


IDENTITY = {  # whether the letter is the identity
    r"\mathbf{A}^{-1} \mathbf{A} = \mathbf{I}": True,
    r"(\mathbf{A} - \lambda \mathbf{I}) \mathbf{x} = 0": True,
    r"\mathbf{L} = \mathbf{I} \boldsymbol{\omega}": False,
    r"T = \frac12 \boldsymbol{\omega}^T \mathbf{I} \boldsymbol{\omega}": False,
}


@pytest.mark.parametrize("latex", IDENTITY)
def test_a_capital_i_before_a_vector_only_is_no_identity(latex: str) -> None:
    letter = first_reading(latex)[1].find(r"\mathbf{I}", 0)
    assert letter
    assert letter.identity == IDENTITY[latex]


def test_no_certificate_holds_a_form() -> None:
    (formula,) = lower(*first_reading(OPAQUE[0]))
    with pytest.raises(Malformed):
        Reader().formula(json.loads(json.dumps(formula)))


def test_a_row_that_is_transposed_is_a_vector() -> None:
    assert lower(*first_reading(r"\mathbf{q} = \begin{bmatrix} a & b & c & d \end{bmatrix}^T")) == lower(
        *first_reading(r"\mathbf{q} = \begin{bmatrix} a \\ b \\ c \\ d \end{bmatrix}")
    )


SAME = {  # two ways to print one thing
    r"y = x^{\mathrm{1/2}}": r"y = x^{1/2}",
    r"x = \sum_{i=0}^n a_i, \quad 0 \le i, j \le n": r"x = \sum_{i=0}^n a_i, \quad 0 \le i \le n, \quad 0 \le j \le n",
    r"E = \left\langle \psi \middle| \hat{H} \middle| \psi \right\rangle": r"E = \langle \psi | \hat{H} | \psi \rangle",
    r"\ket{\psi} = a \ket{0}": r"| \psi \rangle = a \left| 0 \right\rangle",
    r"a = \braket{b|c}": r"a = \langle b | c \rangle",
    r"E_n = n, \quad n = 0, 1, 2...": r"E_n = n, \quad n = 0, 1, 2, \dots",
    r"\partial_t^2 u = v": r"\partial_{tt} u = v",
    r"\underline{\text{div}} (a \underline{\nabla} b) = 0": r"\text{div} (a \nabla b) = 0",
    r"y = \cos^2 \frac{1}{2} (a - b)": r"y = \cos^2 \left(\frac{1}{2} (a - b)\right)",
    r"\frac{\partial f}{\partial x}(x, y) = 2 x y": r"\frac{\partial f(x, y)}{\partial x} = 2 x y",
    r"\begin{equation} a = b. \tag{1} \end{equation}": r"a = b",
    r"\phi_i(t_j) = \begin{cases} 1 & i = j \\ 0 & i \ne j \end{cases}": (
        r"\phi_i(t_j) = \begin{cases} 1 & \text{if } i = j \\ 0 & \text{if } i \neq j \end{cases}"
    ),
    r"x = r \cos(\omega(t - t_0))": r"x = r \cos(\omega \cdot (t - t_0))",
    r"P = \prod_i x_i^{a_i} b": r"P = \prod_i (x_i)^{a_i} b",
    r"y = \int f(x) \, dx / x^2": r"y = \int \frac{f(x)}{x^2} \, dx",
    r"y = \int_0^1 f(x) \, dx / a": r"y = \frac{\int_0^1 f(x) \, dx}{a}",
    r"x(t), v(t) \in \mathbb{R}^n": r"x(t) \in \mathbb{R}^n, \quad v(t) \in \mathbb{R}^n",
    r"\frac{d g}{d \lambda}(\lambda) = 2 \lambda": r"\frac{d g(\lambda)}{d \lambda} = 2 \lambda",
    r"a = b \\[6pt] c = x": r"a = b \\ c = x",
    r"y = \min_x \|x\|^2 + a g(x)": r"y = \min_x (\|x\|^2 + a g(x))",
    r"M = P^a Q^{(1 - a)}": r"M = P^a Q^{1 - a}",
    r"\mathbf{x} = \mathbf{y} \cdot b + \mathbf{a}": r"\mathbf{x} = \mathbf{y} b + \mathbf{a}",
    r"p = \sum_k \mathbb{1}(y = k) p_k": r"p = \sum_k \mathbf{1}\{y = k\} p_k",
    r"\mathbb{P}[X > z] = a": r"\mathbb{P}(X > z) = a",
    r"w = \underset{x \sim p}{\mathbb{E}} [f(x)]": r"w = \mathbb{E}_{x \sim p}[f(x)]",
    r"x \in \R^3": r"x \in \mathbb{R}^3",
    r"\begin{displaymath} a = b \end{displaymath}": r"a = b",
    r"\Gamma(k - m, m, a) := b": r"\varGamma(k - m, m, a) = b",
    r"u = \frac{d3}{d2}": r"u = \text{d3} / \text{d2}",
    r"d = (x - y)^T M (x - y)": r"d = (x - y)^T \cdot M \cdot (x - y)",
    r"s = \sum_{l=2}^{l=l_{\mathrm{max}}} a_l": r"s = \sum_{l=2}^{l_{\mathrm{max}}} a_l",
    r"y = \max_x [a + b x] - c": r"y = (\max_x (a + b x)) - c",
    r"y = \mathbb{I}^{\text{S}} + b": r"y = (\mathbb{I}^{\text{S}}) + b",
    r"y = \lfloor \mathbf{a} \rfloor_\times \mathbf{b}": r"y = [\mathbf{a}]_\times \mathbf{b}",
    r"y = \tr{A B} + c A": r"y = \tr(A B) + c A",
    r"\Sigma_{i=1}^n a_i = \Pi_{j=1}^n b_j": r"\sum_{i=1}^n a_i = \prod_{j=1}^n b_j",
    r"y = -Li_{j+1}(x)": r"y = -\mathrm{Li}_{j+1}(x)",
    r"y = R \left( \begin{matrix} a \\ b \end{matrix} \right)": r"y = R \begin{pmatrix} a \\ b \end{pmatrix}",
    r"y = a Sinc(x)": r"y = a \mathrm{Sinc}(x)",
    r"y = \Gamma\!\left(a + 1\right)": r"y = \Gamma\left(a + 1\right)",
    r"y = (z - hat{x})^2": r"y = (z - \hat{x})^2",
    r"P = \begin{pmatrix} n \\ k \end{pmatrix} p^k": r"P = \binom{n}{k} p^k",
    r"t = \frac{b}{SE(b)}": r"t = \frac{b}{\mathrm{SE}(b)}",
    r"y = \mathit{gain} + x": r"y = \mathrm{gain} + x",
    r"y = \operatorname{atan}{\left(\frac{x}{2}\right)} b": r"y = \operatorname{atan}\left(\frac{x}{2}\right) b",
    r"\mathbf{q} = \begin{bmatrix} a \ b \ c \end{bmatrix}": r"\mathbf{q} = \begin{bmatrix} a & b & c \end{bmatrix}",
    r"[BN(\bm\sigma)] = \mathbf{x}": r"[BN](\bm\sigma) = \mathbf{x}",
    r"y = \operatorname{arg\,max}_x f(x)": r"y = \operatorname{argmax}_x f(x)",
    r"a = 0 \textbf{ or } b = 0": r"a = 0 \text{ or } b = 0",
    r"\mathbf{u} = y^{\left(m\right)}": r"\mathbf{u} = y^{(m)}",
    r"a + b = 0 \rightarrow c + e = d": r"a + b = 0 \Rightarrow c + e = d",
    r"y = {a_j}^2 b": r"y = a_j^2 b",
    r"y = m_{\text{p}} b": r"y = m_p b",
    r"y = \left. f(x) \right|_{x = 1}": r"y = \left[ f(x) \right]_{x = 1}",
    r"\frac{{}^N d\bar{v}}{dt} = \bar{a}": r"\left(\frac{d\bar{v}}{dt}\right)_N = \bar{a}",
    r"\frac{{}^A \partial \bar{v}}{\partial q} = a": r"\left(\frac{\partial\bar{v}}{\partial q}\right)_A = a",
    r"y = \log \Gamma(x)": r"y = \log(\Gamma(x))",
    r"y = \exp\{ -x \} a": r"y = \exp(-x) a",
    r"y = \max\{ a, b \}": r"y = \max(a, b)",
    r"y = \sum_{i=1}^3 m_i r_i \times v_i": r"y = \sum_{i=1}^3 (m_i r_i \times v_i)",
    r"\mathbf{R_1(\phi)} = 1": r"\mathbf{R}_1(\phi) = 1",
    r"J = \mathbf{x}^T(t) \mathbf{Q} \mathbf{x}(t)": r"J = \mathbf{x}(t)^T \mathbf{Q} \mathbf{x}(t)",
    r"x = {\mathbf{BK}}_1": r"x = \mathbf{B} \mathbf{K}_1",
    r"y = || a + b ||": r"y = \| a + b \|",
    r"x = {}^B \begin{bmatrix} a \\ b \end{bmatrix}": r"x = \begin{bmatrix} a \\ b \end{bmatrix}_B",
    r"A = {n \choose k}": r"A = \binom{n}{k}",
    r"D = \begin{vmatrix} a \\ c \end{vmatrix}": r"D = \left| \begin{matrix} a \\ c \end{matrix} \right|",
    r"v = \begin{bmatrix} a, b \end{bmatrix}": r"v = \begin{bmatrix} a & b \end{bmatrix}",
    r"M^{-T} J = 1": r"\left( M^{-1} \right)^T J = 1",
    r"i = 1 \ldots n": r"i = 1, \ldots, n",
    r"Q = [B \ \ A B]": r"Q = [B, A B]",
    r"P(x) = 3 x(x) - 1": r"P(x) = 3 x x - 1",
    r"A = O_4 \text{, } b = a \text{, and } c = 1": r"A = O_4, \quad b = a, \quad c = 1",
    r"T_j = T_{j-1}^{(n-j)/(n-(j-1))}": r"T_j = (T_{j-1})^{\frac{n-j}{n-(j-1)}}",
    r"\mathbf{H} = [\mathbf{e}'_1 \, \mathbf{e}'_2 \, c]": r"\mathbf{H} = [\mathbf{e}'_1, \mathbf{e}'_2, c]",
    r"y = mcos\theta": r"y = m \cos \theta",
    r"y = \left[ a_1 \ b_1 \ \dot{c} \right]": r"y = [a_1, b_1, \dot{c}]",
    r"\mathbf{B} = {}^b \mathbf{a} ({}^r \mathbf{a})^T": r"\mathbf{B} = {}^b \mathbf{a} \, {}^r \mathbf{a}^T",
    r"a = b \hspace{2cm} c = d": r"a = b, \quad c = d",
    r"a = b \hspace{1pt} c": r"a = b c",
    r"a = b \text{, where } c = d": r"a = b, \quad c = d",
    r"a = 3 \, \mathrm{N \, m}^{-2}": r"a = 3 \, \mathrm{N} \, \mathrm{m}^{-2}",
    r"\operatorname{\text{argmin}}_x f = 1": r"\operatorname{argmin}_x f = 1",
    r"k = 3.2\mathrm{e}{-5} T": r"k = 3.2 \cdot 10^{-5} T",
    r"x = 1.5e{-3} y": r"x = 1.5 \cdot 10^{-3} y",
    r"a = \int_0^1 \frac{2 x^2 \, dx}{1 + x}": r"a = \int_0^1 \frac{2 x^2}{1 + x} \, dx",
    r"y = \textit{sign}(a)": r"y = \mathit{sign}(a)",
    r"\eta = \textbf{ShkStd}_t^2": r"\eta = \text{ShkStd}_t^2",
    r"v = \mathrm{E}[X^2] - \mathrm{E}[X]^2": r"v = \text{E}[X^2] - \left(\text{E}[X]\right)^2",
    r"y = (\mathbf{a} - \mathbf{b})^\mathbf{T} \mathbf{c}": r"y = (\mathbf{a} - \mathbf{b})^T \mathbf{c}",
    r"U[t+1] = b U[t] + I[t+1] - c": r"U[t+1] = b U[t] + (I[t+1]) - c",
    r"y = [C] {^f} {\bf x}": r"y = [C] \, {}^f {\bf x}",
    r"s^{\rm z-space} = s^{\rm true} + a": r"s^{\mathrm{z-space}} = s^{\mathrm{true}} + a",
}


@pytest.mark.parametrize("latex", SAME)
def test_two_ways_to_print_one_thing_read_alike(latex: str) -> None:
    assert bracketed(first_reading(latex)[0]) == bracketed(first_reading(SAME[latex])[0])


KINDS = (  # what letters are taken for: kind, and on what they depend
    (r"\mathbf{v} = \mathbf{\Omega} \times \mathbf{r}", {r"\mathbf{\Omega}": ("vector", "")}),
    (r"\mathbf{y} = \mathbf{A} \mathbf{x}", {r"\mathbf{A}": ("matrix", "")}),
    (r"\mathbf{L} = \mathbf{r} \times m \mathbf{v}", {"m": ("scalar", "")}),
    (r"\mathbf{L} = \mathbf{r} \times m_1 \ddot{\mathbf{r}}", {"m_1": ("scalar", "")}),
    (r"L = r \times v", {"r": ("vector", "")}),
    (r"R = \sum_{i=1}^{N} w_i v_i^T R", {"N": ("scalar", ""), "R": ("matrix", "")}),
    (r"\bar{r} \cdot \hat{n} = 0", {r"\bar{r}": ("vector", ""), r"\hat{n}": ("vector", "")}),
    (r"\bar{x} \cdot \bar{y} = 2", {r"\bar{x}": ("scalar", "")}),
    (r"\bar{x} \cdot \bar{y} = |\bar{x}| |\bar{y}|", {r"\bar{x}": ("vector", "")}),
    (r"x \in \mathbb{R}^{6 \nu \times n}, \quad \nu = n", {r"\nu": ("scalar", ""), "n": ("scalar", "")}),
    (r"I \ddot{\theta} + b \dot{\theta} = \tau", {r"\theta": ("scalar", "t")}),
    (r"\dot{x} + x = u(\tau)", {"x": ("scalar", r"\tau")}),
    (r"\dot{\tau} = f(x, \tau)", {r"\tau": ("scalar", "t")}),
    (r"\rho = [HN](r - s)", {"[ H N ]": ("matrix", "")}),
    (r"\bm{L} = \bm{r} \times \bm{\dot{r}}", {r"\bm{r}": ("vector", "t")}),
    (r"\vec{0} = (A - 2 I) \vec{v}", {"A": ("matrix", ""), "I": ("matrix", None)}),
    (r"G(s) = C (s I - A)^{-1} B + D", {"A": ("matrix", ""), "B": ("matrix", ""), "C": ("matrix", "")}),
    (r"A = Q \Lambda Q^{-1}", {"A": ("matrix", ""), "Q": ("matrix", ""), r"\Lambda": ("matrix", "")}),
    (r"D = P^{-1} A P", {"A": ("matrix", ""), "P": ("matrix", "")}),
    (r"y = Q A^{-1} Q", {"A": ("scalar", ""), "Q": ("scalar", "")}),
    (r"\pi(q) = p q - c", {r"\pi": ("function", "q")}),
    (r"u = \pi(\theta, \dot{\theta})", {r"\theta": ("scalar", "t")}),
    (r"A = \pi (r)^2", {r"\pi": ("scalar", None)}),
    (r"V = (E - r I) R", {"E": ("scalar", ""), "I": ("scalar", "")}),
    (r"\vec{p} = \vec{q} + t \cdot \vec{d}", {"t": ("scalar", "")}),
    (r"W = \mathbf{F} \cdot \mathbf{s}", {r"\mathbf{F}": ("vector", "")}),
    (r"\mathbf{F} = \mathbf{G} \cdot \mathbf{H}", {r"\mathbf{F}": ("matrix", ""), r"\mathbf{H}": ("matrix", "")}),
    (r"J = \left[BM_j\right] A \left[BM_j\right]^T", {"[ B M _ { j } ]": ("matrix", "")}),
    (r"\mathbf{D} = \mathbf{B} (\mathbf{B}^T \mathbf{B})^{-1/2}", {r"\mathbf{B}": ("matrix", "")}),
    (r"f = x \dot{y}_0 - y_0 \dot{x}", {r"\dot { y } _ { 0 }": ("scalar", ""), "y_0": ("scalar", "")}),
    (r"\dot{q}_1 = a \dot{q}_0 + q", {"q_0": ("scalar", "t"), "q_1": ("scalar", "t")}),
    (r"\dot{x}_0 = a x_0", {"x_0": ("scalar", "t")}),
    (r"N = \frac{\partial}{\partial \theta} (r - R) + \frac{\partial}{\partial r} (r - R)", {"r": ("scalar", "")}),
    (r"N = \frac{d r}{d \theta} + \frac{\partial}{\partial r} (r - R)", {"r": ("scalar", r"\theta")}),
    (r"S = \Phi_t P \Phi_t^T", {r"\Phi_t": ("matrix", "")}),
    (r"\frac{{}^B d \mathbf{c}}{dt} = \frac{dx}{dt} \mathbf{b}", {r"\mathbf{c}": ("vector", "t")}),
    (r"\dot{\mathbf{s}} = \frac14 [B(\mathbf{s})] \mathbf{w}", {r"[ B ]": ("function", r"\mathbf { s }")}),
    (r"\bar{H} = \breve{I} \cdot \hat{n}", {r"\breve{I}": ("matrix", ""), r"\hat{n}": ("vector", "")}),
    (r"\ddot{\mathbf{s}} = a \frac{d^2 \mathbf{r}}{dt^2}", {r"\mathbf{r}": ("vector", "t")}),
    (r"\frac{d(v x)}{dt} + y(t) = 1", {"v": ("scalar", "t"), "x": ("scalar", "t")}),
    (r"\Delta G^\circ = -R T \ln K", {r"\Delta G ^ { \circ }": ("scalar", "")}),
    (r"\dot{\omega} = \sin^2 i - 2", {"i": ("scalar", "")}),
    (r"[\mathcal{F} \mathcal{N}] = 2", {r"[ \mathcal { F } \mathcal { N } ]": ("matrix", "")}),
    (r"\mathbf{a} = a \cdot \hat{\mathbf{e}}", {"a": ("scalar", "")}),
    (r"S = k \left(\frac{\partial \ln Z}{\partial U}\right)_{N, V}", {"k": ("scalar", "")}),
    (r"H = \hat{H}^0 + \hat{H}^1", {r"\hat { H } ^ { 0 }": ("scalar", ""), r"\hat { H } ^ { 1 }": ("scalar", "")}),
    (r"y = a_0 x^0 + a_1 x^1 + a_2 x^2", {"x ^ { 1 }": None, "x": ("scalar", "")}),
)  # fmt: skip


@pytest.mark.parametrize(("latex", "kinds"), KINDS)
def test_letters_are_taken_for_what_is_done_with_them(latex: str, kinds: dict[str, tuple[str, str] | None]) -> None:
    _, notation = first_reading(latex)
    found = {name: notation.find(name, 0) for name in kinds}
    assert {name: letter and (letter.kind, letter.depends) for name, letter in found.items()} == kinds


NOT_READ = {  # where two things may be meant
    r"y \, \mathrm{[dB]} = 20 \log_{10} x": "no factor",
    r"\frac{d}{dt} [f, g] = 0": "a list, or a product",
    r"a = b, \text{ where } c = d \\ = e": "which of the relations",
    r"i \hbar \frac{\partial \Psi}{\partial t} = \hat{H} \Psi": "applied to what follows",
    r"[\hat{x}, \hat{p}] = i \hbar": "the bracket of two operators",
    r"\frac{D u}{D t} = g": "a derivative, or a quotient",
    r"[L_x, L_y] = [y p_z, z p_x]": "the bracket of two operators",
    r"f(x) = \mathcal{H}(g)(x - 1)": "of what the operator makes",
    r"S = -\mathrm{Tr} \, \rho \log \rho": "belong to the argument of Tr",
    r"k = 1.2 \sim 1.5": "from one to the other",
    r"\ell = \log{\binom{N}{n}} \theta^n": "belong to the argument of log",
    r"{Ql}_i = n_i": "cannot be read here",
    r"\nabla e^f = e^f \nabla f": "does this power belong to grad",
    r"\Delta \ln x = y": "the change of what follows",
    r"a = 0.5 b = 0.4 c = 0.3": "do several equations stand in a row",
    r"y = \frac{E[x]}{E(x - 1)}": "the expectation of what is in these brackets",
    r"x \stackrel{?}{=} y": "is no letter",
    r"\log p(x) = \log p(z) q(x)": "belong to the argument of log",
    r"\log p(x) = \log p(z) |J|": "belong to the argument of log",
    r"\text{in 2D: } A = x y": "words among factors",
    r"y = \infty x": "infinity is no factor",
    r"\tau = [0, 1]": "all numbers from one to the other, or a list",
    r"I = I_xx + I_yy": "one subscript, or a product",
}


@pytest.mark.parametrize("latex", NOT_READ)
def test_what_may_be_meant_in_two_ways_is_not_read(latex: str) -> None:
    with pytest.raises(SymcheckError, match=NOT_READ[latex]):
        first_reading(latex)


READ = (  # beside what is not read: one thing is meant
    r"y = \mathrm{dB} \log_{10} x",
    r"y = x^T \mathbf{\Sigma} x",
    r"\frac{d}{dt} [f - g] = 0",
    r"a = b, \text{ where } c = d",
    r"\hat{H} x = 2",
    r"[a, b] = [c, d]",
    r"\frac{D u}{C t} = g",
    r"u = v \wedge 1 \le n",
    r"\mathcal{E} = I R + \mathcal{L}",
    r"u = \int k \, dx + k x",
    r"W = \int_a^b p \, dV = p (b - a)",
    r"m = \int_{V} \rho \, dV",
    r"y' y = x",
    r"p = g(\rho h + \rho_0 h_0)",
    r"\mathbf{y} = [A] \mathbf{x}",
    r"x = d_1 \cos \theta",
    r"f(x) = g(x) (y - 1)",
    r"x^0 = 1",
    r"E = T c + c",
    r"T_2^0 = T_1^0 T_2^1",
    r"T_6^0 = T_1^0 T_2^1 T_3^2 T_4^3",
    r"H(T) - H^0 = A T",
    r"\alpha = 90^\circ - \theta^\circ",
    r"\ell = \log{\frac{a}{b}} + c",
    r"x = \underset{t}{argmax} f(t)",
    r"y = x^{H + 1} H",
    r"\log p(x) = \log p(z) + q(x)",
    r"\text{in 2D } A = x y",
    r"y = \infty",
    r"\tau \in [0, 1]",
    r"I = I_{xx} + I_{yy}",
)


@pytest.mark.parametrize("latex", READ)
def test_what_means_one_thing_is_read(latex: str) -> None:
    assert first_reading(latex)


TYPED = {  # what is typed otherwise, and reads as the second one
    r"\bf{R}_{a} = \bf{R}_b^T": r"\mathbf{R}_{a} = \mathbf{R}_b^T",
    r"a \not= b": r"a \ne b",
    r"T = m \parallel\vec{v}\parallel^2 - \frac{k}{\parallel r\parallel}": r"T = m \|\vec{v}\|^2 - \frac{k}{\|r\|}",
    r"azimuth = \arctan x": r"\mathrm{azimuth} = \arctan x",
    r"\mathsf{SNR} = 10 x": r"\mathrm{SNR} = 10 x",
    r"N = [N_1 \, N_2 \, N_3]": r"N = [N_1, N_2, N_3]",
    r"k = 2.8311e-4 x": r"k = 2.8311 \cdot 10^{-4} x",
    r"y = \log_{10}{1 + x}": r"y = \log_{10}(1 + x)",
    r"H_n\!\left(x\right) = 2 x": r"H_n(x) = 2 x",
    r"V(x) = V_0 \,\,\,\, 0 \le x": r"V(x) = V_0, \quad 0 \le x",
    r"A = \begin{bmatrix} a && b \\ c && d \end{bmatrix}": r"A = \begin{bmatrix} a & b \\ c & d \end{bmatrix}",
}


@pytest.mark.parametrize("latex", TYPED)
def test_what_is_typed_otherwise_reads_alike(latex: str) -> None:
    assert bracketed(first_reading(latex)[0]) == bracketed(first_reading(TYPED[latex])[0])


def test_a_question_is_in_doubt_as_its_print_is() -> None:
    for latex in (r"F = \frac{MSB}{MSW}", r"PV = \frac{FV}{(1 + r)^n}", r"E = KE + PE"):
        answer = decide(latex)
        assert answer.verdict is Status.UNREADABLE
        assert "one name" in answer.reason
    said = decide(r"E = KE + PE", letters=dict.fromkeys("KPE", "scalar"))
    assert said.verdict is not Status.UNREADABLE


APART = {  # what is read otherwise, and would be read as the second one if a sign were overlooked
    r"y = g (m_1 + m_2)": r"y = g(t)",
    r"x_i(t + 1) = x_i(t) + v_i(t + 1)": r"x_i(t + 1) = x_i(t) + v_i \cdot (t + 1)",
    r"\dot{x} = a x (1 - x)": r"\dot{x} = a x(1)",
    r"y = Q^E W^{N + 2} + Q^{2 F}": r"y = Q^E W^{N + 2} + Q^F",
    r"y = \sum_{i=1}^3 s_{i1,2}": r"y = \sum_{i=1}^3 s_{i12}",
    r"y = \cos\theta \hat{n}": r"y = \cos(\theta n)",
    r"x'' + x = 0, \quad x'(a) = 0": r"x'' + x = 0, \quad x' \cdot a = 0",
    r"E = E^\circ - R T": r"E = E - R T",
    r"E[X] = 2 [Y]": r"E \cdot [X] = 2 [Y]",
    r"\lambda = 2 \quad \text{with a value} \quad x = 1": r"\lambda = 2, \quad v = x = 1",
    r"\dot{x} = 2 x, \quad x(0) = 1": r"\dot{x} = 2 x, \quad x \cdot 0 = 1",
    r"\sigma^2 = E(X^2) - E(X)^2": r"\sigma^2 = E X^2 - E X^2",
    r"P_n(\pm 1) = (\pm 1)^n": r"P_n \cdot (\pm 1) = (\pm 1)^n",
    r"E d x(t) = A x(t) dt": r"E d x \cdot t = A x(t) dt",
    r"L(t) = E(t - 1) + a(t) b(t)": r"L(t) = E \cdot (t - 1) + a(t) b(t)",
    r"x = a, \quad \forall p, t \in S": r"x = a, \quad t \in S, \quad \forall p",
    r"A = \begin{bmatrix} a && b \\ & c & \end{bmatrix}": r"A = \begin{bmatrix} a & b \\ & c \end{bmatrix}",
}


@pytest.mark.parametrize("latex", APART)
def test_what_looks_alike_reads_apart(latex: str) -> None:
    assert bracketed(first_reading(latex)[0]) != bracketed(first_reading(APART[latex])[0])


IN_DOUBT = {  # read, but nothing is stated before somebody says what is meant
    r"A = 1 \le n \wedge p < q": "a chain, or what",
    r"\delta \int_0^1 L \, dt = 0": "the sign of a variation",
    r"x = (\mathcal{L} \bar{y})": "applied to what follows",
    r"u = K \int C (x - y) dt": "which letters depend on t",
    r"Re = \frac{v L}{\nu}": "Reynolds number, or R times e",
    r"C = 0.2 Re_D^{0.5}": "Reynolds number, or R times e",
    r"\overline{AB} = 1": "one name, or something done with A B",
    r"\Sigma \xi = \xi_1 + \xi_2": "a letter, or the sign of a sum",
    r"\ddot{x} = x'' + 2 x'": "do its primes say the same as its dots",
    r"F = m \left(\frac{a}{b}\right)^2 [N]": "a matrix in brackets, or the unit",
    r"f_{curved} = \frac{11.6}{De}": "Dean number, or D times e",
    r"r = \frac{P \cdot MW}{T}": "molecular-weight number, or M times W",
    r"x = \frac{n}{MW_i}": "molecular-weight number, or M times W",
    r"x = 2 R_2 NTU_2 / 3": "one name NTU, or a product",
    r"x = \frac{3 Tc^2}{T}": "one name Tc, or a product",
    r"x_{ss} = N_x \cdot ref": "one name ref, or a product",
    r"y = fct(t)": "a factor, or part of the name fc",
    r"y = FDD(t)": "one name FDD, or a product",
    r"\sigma(t) = \sigma \sqrt{1 + t^2}": r"is \\sigma what \\sigma\(t\) is",
    r"e_i \cdot e^j = \delta_i^j": "a power, or a label",
    r"y = \omega [\sin x, \cos x]": "a factor, or applied to what follows",
    r"\mathbf{xf}_i = \mathbf{y}": "one name, or a product",
    r"d_A f(X) = X": "a factor, or applied to what follows",
    r"W = \Delta KE": "one name KE, or a product",
    r"\frac{dP}{dt} = b(aNP) - mP": "a factor, or a function",
    r"VCC = VCC + GND": "one name",
    r"y = T_m^2 (MW)": "a factor, or a function",
    r"\left(\frac{\partial a \alpha}{\partial P}\right)_V = b": "constant, or not",
    r"SS = 2 a": "one name SS, or a product",
    r"SGS = SG + b": "one name SGS, or a product",
    r"y = \mathrm{amp}(3 - a)": "a function, or a factor",
    r"Y = \frac{A T^B}{1 + C T + D}": "a power, or a label",
    r"\sum_{i=1}^k \Gamma(a^i) = b": "a power, or an index",
    r"y = a_1 + a_2 + \prod_{i=1}^{k} x_i^{a^i-1}": "a power, or an index",
    r"\lambda = 31.2 \eta^\circ G": "in degrees, or in the standard state",
    r"y = \sqrt{(x - \mu)^H (x - \mu)}": "conjugated and transposed",
    r"f(x) = C_n^{2 l + 1 / 2}(x)": "a power, or a label",
    r"PV = \frac{FV}{(1 + r)^n}": "one name PV, or a product",
    r"R^2 = 1 - \frac{SS_{res}}{SS_{tot}}": "one name SS, or a product",
    r"F = \frac{MSB}{MSW}": "one name MS., or a product",
    r"e = D^4 P - Do^4 P": "one name Do, or a product",
    r"\pi = p q - c": "the number pi, or a letter",
    r"\beta = (X'X)^{-1} X' y": "does the prime transpose",
    r"s = \frac{e'e}{n - k}": "does the prime transpose",
    r"d_L \exp(X) = L \exp(X)": "applied to what follows",
    r"v = \frac{v_0 [S]}{K + [S]}": "a matrix in brackets, or a concentration",
    r"y = g(W x + b)": "a factor before brackets, or a function",
    r"h = 2.1 P_r + (1 - Pr^2)": "Prandtl number, or P times r",
    r"\mathbf{C} = \mathbf{X} \mathbf{X}^H": "conjugated and transposed",
    r"u = \Delta_{\mathbf{x}} v": "applied to what follows",
    r"T(K) = T(^\circ C) + 273": "degrees of a scale",
    r"\nabla f^2 = 2 f \nabla f": "the gradient of a power",
    r"0 = \dot{m} \cdot (h - h_0) + UA \cdot T": "one name UA, or a product",
    r"y = m \cdot \frac{rpm}{60}": "one name rpm, or a product",
    r"E = KE + PE": "one name KE, or a product",
    r"RH = 100 \frac{a}{b}": "one name RH, or a product",
    r"y = lb_d + ub_d": "one name lb, or a product",
    r"ed(x, y) = x - y": "one name ed, or a product",
    r"m = 496 \frac{kg}{m^3} d^2": "one name kg, or a product",
    r"y = mu_0 x": "one name mu, or a product",
    r"H(t) = h(t) \exp(x' \beta)": "does the prime transpose",
    r"AXA' - X + B = 0": "does the prime transpose",
    r"L = 1 - \Pi_i (1 - L_i)": "a letter, or the sign of a product",
    r"A(f) = A \sqrt{f}": "is A what A\\(f\\) is",
    r"X(a) = \mathcal{L}(\mathbf{c}) \pi(\mathbf{c})": "the number pi, or a function",
    r"y = \left(\frac{h}{a}\right)^\nu K_\nu \left(\frac{h}{a}\right)": "a factor before brackets, or a function",
    r"\frac{u}{\Delta^2 t} = c": "the power of a change",
    r"y = 2F_1(a, b, c, x)": "a hypergeometric one",
    r"q^T y = h - T x": "transposed, or raised to the power of T",
    r"\sum_{j=1}^N (a - a_j) R^j = 0": "a power, or an index",
    r"w = (\delta \Sigma)^{-1} x": "a change, or a factor before a letter",
    r"T = \frac{1}{2} \dot{q}^T M \dot{q}": "transposed, or raised to the power of T",
    r"max = m a, \quad x = 3": "one name max, or a product",
    r"S = \omega_{\mu\nu} M^{\mu\nu}": "a power, or a label",
    r"x_t = E_t x_{t+1}": "what is expected of what follows",
    r"\eta = \frac{\text{load power}(P_L)}{P}": "words with the letter they stand for, or a function",
}


@pytest.mark.parametrize("latex", IN_DOUBT)
def test_a_name_in_doubt_is_read_and_says_both_readings(latex: str) -> None:
    tree, notation = first_reading(latex)
    assert read(to_latex(tree), notation) == tree
    with pytest.raises(SymcheckError, match=IN_DOUBT[latex]):
        lower(tree, notation)


def test_letters_of_an_abbreviated_number_are_factors_where_they_may_be() -> None:
    products = (
        r"AB = BA + C",
        r"R^2 = S S_1 + S",
        r"\frac{b}{R} = a_0 + R a_1",
        r"x = \frac{A B C}{A + B + C}",
        r"\pi = 4 \arctan 1",
    )
    for latex in products:
        assert lower(*first_reading(latex))
    for latex in (r"I = \frac16 M a^2", r"y = D e^{2 x}"):
        assert "Mul" in bracketed(first_reading(latex)[0])
    for latex in (r"z = R e^{i x}", r"\sum_{i=1}^3 r_i \times v = 0", r"y = \int_0 f \, dx"):
        with pytest.raises(SymcheckError):
            first_reading(latex)


SUMS_OVER_NAMES = (r"\sum_{i=1}^2 I_{s_i} = 2 I_{s_i}", r"\sum_{n=1}^2 t_{n-1} = 2 t_{n-1}")


@pytest.mark.parametrize("latex", SUMS_OVER_NAMES)
def test_a_name_with_the_index_of_a_sum_is_no_constant(latex: str) -> None:
    assert decide(latex).verdict not in (Status.PROVED, Status.REFUTED)


EVIDENCE = {  # what leaves open how it is meant, beside what shows it
    r"y = \delta(r - r_0)": r"y = k_p (r - r_0)",
    r"y = \sigma(W x + b)": r"y = \sigma(1 + b)",
    r"P = U(x_1 - x_2) + U(x_2 - x_3)": r"P = a(1 - e) + a(1 + e)",
    r"b = m + \Phi^{-1}(1 - \alpha)": r"b = n^{-1}(1 - \alpha) + n",
    r"U = R_{(2)}(\pi / 2) V": r"U = R (\pi a / 2) V + R",
    r"q = h(T_1 - T_2)": r"q = h A (T_1 - T_2)",
    r"\dot{x} = 1 / \tau (c - x)": r"\dot{x} = \frac{1}{\tau} (c - x)",
    r"y = \beta' x + c": r"y = \beta x + c",
    r"S = a z^M + b z^{(M - 1)}": r"S = a z^M + b z^{M - 1} + M",
    r"E = \mu^c + m": r"E = \mu^n + n",
    r"\mu^T T = \mu^T": r"\mu^T A = \mu^T",
    r"y = L f(x) L g(x)": r"y = L^2 f(x) g(x)",
    r"T f(x) = a + x": r"a \dot{f}(x) = a + x",
    r"y = \prod_{j \in S} 1 - p_j": r"y = \prod_{j \in S} (1 - p_j)",
    r"y = f(x)_i": r"y = z_i",
    r"F = \left. \frac{E}{a} \right|_b^c": r"F = \left. \frac{x}{a} \right|_{x = 1}",
    r"\dot{q} = \{q, H\}": r"q \in \{a, H\}",
    r"y = \rho[\mathbf{m}_1, \mathbf{m}_2]": r"y = \rho[m, n]",
    r"y = \Theta[\frac{a}{n}, b]": r"V[n, k] = x^2",
    r"CC_4 = \frac{4 a}{b}": r"y = C C_4 + C",
    r"\eta = \frac{IE - EA}{2}": r"\eta = AB - BA",
    r"ts[t] = ts[t - 1] + a": r"x[n] = a x[n - 1]",
    r"\mu\text{FA} = \sqrt{C}": r"\mu \cdot \text{FA} = \sqrt{C}",
    r"y = [\mathbf{G} a]_{ii}(E)": r"y = a (E + 1) a_1 + a",
    r"A = \mathbf{J}(q)^{-T} b": r"A = \mathbf{J}(q)^{-1} b",
    r"y = A \exp(-t) [+ B \exp(-s)]": r"y = A \exp(-t) [a + B \exp(-s)]",
    r"y = \exp(-i2\pi x)": r"y = \exp(-2 i \pi x)",
    r"F_net = \int f \, dx": r"F = x_iy_i + m_av",
    r"c = \mathrm{IFFT\{x\}}": r"c = \mathrm{IFFT}(x)",
    r"\alpha, \beta \sim \frac{1}{\alpha + \beta}": r"\alpha, \beta \sim N(0, 1)",
    r"f: a, b \mapsto c": r"f: a \mapsto c",
    r"y = \sum_k w^2[n - k h]": r"y = \sum_k w^2 (n - k h)",
    r"y = E_{\text{loo}}[x - z]": r"y = E[x - z]",
    r"\text{prox}_f \|x\| = x": r"\text{prox}_f(x) = x",
    r"y = \pi(A^{-1} b)": r"y = \pi(a + b)",
    r"y = \mathbf{Op} x": r"y = \mathbf{Ax}",
    r"lb \le x \le ub": r"l \le x \le u b",
    r"\sum_{i=0}^{nx - 1} a_i = ny": r"\sum_{i=0}^{n x - 1} a_i = n",
    r"pr_i = 1 - p": r"mr_i = 1 - r",
    r"y = x^{head} t": r"y = x^{2 n} t",
    r"y = MRR + \sum_i r_i^{-1}": r"y = M R + M \sum_i r_i^{-1} + R",
    r"x = \frac{A \cdot \cos(a)}{SP^2} \cdot \frac{SC^2}{P C}": r"x = \frac{A \cos(a)}{S P^2} \frac{P C}{S} C P",
    r"y = acf(h) + \sum_t mean(x)_t": r"y = a c(h) + \sum_t x_t",
    r"u_t = a u_{xx}": r"\sigma_{xx} = a \epsilon_{xx}",
    r"m = 1.23(4)": r"m = 2(4)",
    r"x != y": r"x! = y",
    r"x = \{f, H\} + a": r"x = \{f + H\} + a",
    r"i \hbar = [Q, P]": r"x = [Q, P]",
    r"f(x + h) = f(x) + D f(x) h": r"y = C x(t) + D u(t)",
    r"y = J(f)(x)": r"y = J(f)(x + 1)",
    r"H = \nabla^2 f(x) + A^T A": r"a = \nabla^2 f(x) + b",
    r"y = a \cdot s (b \cdot x - c)": r"y = a k (b x - c)",
    r"\log m = \log \frac{1}{n} \sum_i a_i": r"\log m = \log \frac{1}{n} + \sum_i a_i",
    r"c_i^H H(s) = H(s)": r"c_i^n H(s) = H(s) + n",
    r"x = A^{-H} b": r"x = A^{-H} b + H",
    r"\frac{\partial f^{-1}}{\partial x} = a": r"\frac{\partial f}{\partial x} = a",
    r"y = \prod_{j=1}^n e^{-j b X_j}": r"y = \prod_{j=1}^n e^{-b j}",
    r"f = \langle \mathbf{a}, \mathbf{b}, \mathbf{c} \rangle": r"\mathbf{f} = \langle a, b, c \rangle",
    r"A = (\mathbf{b} \mathbf{b}^\text{T}) \text{T}": r"A = \mathbf{b} \mathbf{b}^\text{T}",
    r"C_XX = a C_XY": r"C_X X = a C_Y",
    r"(1) x = a \\ (2) y = b": r"x = a \\ y = b",
    r"a &= b \\ c &= d (e - f) g &= h": r"a &= b \\ c &= d (e - f) g",
    "x = a + b\ny = c": "x = a + b\n+ y = c",
    r"\Sigma = \mathbf{E} r_t r_t": r"\Sigma = q \mathbf{E} \cdot \mathbf{r}",
    r"\text{out} = \text{alpha}(x)": r"\text{out} = \text{relu}(x)",
    r"y = Iobs(1 - t0)": r"y = Iobs(t0)",
    r"w = \sum_m v(t_n + (m - \frac{1}{2}) a)": r"w = \sum_m v_m t_n",
    r"y = \frac{\text{POD}}{\text{1 - POD}}": r"y = \text{1-hop} + \text{POD}",
    r"y = \pi(\phi(x, z))": r"y = \pi(R^2 - r^2)",
    r"b = (y'y)^{-1} a": r"b = y'y + a",
    r"\mathbf{E} = \mathbf{F}_m(\mathbf{r} - \mathbf{r}_i)": r"\mathbf{E} = \mathbf{K}(\mathbf{x} - \mathbf{x}_0)",
    r"K = \frac{1}{2} \dot{q}^T M \dot{q} + T": r"K = \frac{1}{2} \dot{q}^T M \dot{q}",
    r"S = \omega_{\mu\nu} M^{\mu\nu}": r"S = \omega_{\mu\nu} M^{2}",
    r"x_t = E_t x_{t+1}": r"x_t = E_t y_t",
    r"J = \sum_{i=1}^m h(x^{(i)}) - y^{(i)}": r"J = \sum_{i=1}^m (h(x^{(i)}) - y^{(i)})",
    r"y = (D A)^T B W (D A)": r"y = (D A)^T W (D A)",
    r"k_j = W_j^K h_j": r"q_i = W_i^Q h_i, \quad k_j = W_j^K h_j",
    r"L' = L(\vec{v}^2) + L": r"L' = L \vec{v}^2 + L",
    r"c = \frac{A \cdot B}{\|A\| \|B\|}": r"c = \frac{\mathbf{a} \cdot \mathbf{b}}{\|\mathbf{a}\| \|\mathbf{b}\|}",
    r"A x = \lambda x": r"A x = \lambda y",
    r"L_z Y_\ell^m = m \hbar Y_\ell^m": r"L_z = m \hbar Y_\ell^m",
    r"H \psi_n = E_n c_n": r"V \psi_n = E_n c_n",
    r"L y = -(p y')' + q y": r"L y = -p z + q",
    r"(1 - L) y_t = \varepsilon_t": r"(1 - c) y_t = \varepsilon_t",
    r"\phi(B) y_t = \theta(B) \varepsilon_t": r"\phi(b) y_t = \theta(b) \varepsilon_t",
    r"x_{jt} = a L x_{jt} + b": r"x_{t + 1} = A x_t + B u_t",
    r"h_t = [1 - \beta L - (1 - L)^d] \epsilon_t + b": r"h_t = [1 - \beta c - (1 - c)^d] \epsilon_t + b",
    r"d_t \delta = a + b": r"y_t = a + d_t \delta",
    r"H = \sum_{<i, j>} S_i S_j + h S_i": r"H = \sum_{<i, j>} S_i S_j + h",
    r"D(x, y) = \text{tr}(C^x C^y)": r"D(x, y) = \text{tr}(C^2 C)",
    r"K(a, b | x, y) = \rho_b^y": r"K(a, b | x, y) = \rho_b y",
    r"y = P_n^m x + m": r"y = P_l^m x + m",
    r"C_n^k = \frac{n!}{k! (n - k)!}": r"c_n^k = \frac{n}{k}",
    r"U_m^\mu = \delta_{m \mu} + \Theta(\mu)": r"U_m = \delta_{m \mu} + \Theta(\mu)",
    r"H^{t + 1} = H^t + t b": r"\beta^{t + 1} = \beta^t b + t",
    r"y = A D^{B + 1}": r"y = A D^{n + 1} + n",
    r"x = y_t y_{t - j}' + b": r"x = y_1 y_2' - y_2 y_1'",
    r"\Omega = \Lambda + \Lambda'": r"x = a + a'",
    r"A = \begin{bmatrix} a & b \\ b' & c \end{bmatrix}": r"A = \begin{bmatrix} a & b \\ a' & b' \end{bmatrix}",
    r"\mathbf{P} \mathbf{A} \mathbf{P}' = \mathbf{Q} \mathbf{R}": r"\mathbf{P} \mathbf{A} = \mathbf{Q} \mathbf{R}",
    r"\mathcal{D}[a, b] \rho = c": r"\mathcal{D}[a, b] = c",
    r"W = \Theta(1 - k R)": r"W = \theta(1 - k R)",
    r"q = K h (\nabla z)": r"q = K f(\nabla z)",
    r"q = a h(\Delta T) + b": r"q = a f(\Delta T) + b",
    r"y = N(-d_1)": r"y = f(-d_1)",
    r"a = -E + D (+ U)": r"a = -E + D (+1)",
    r"a = \mathtt{\frac{x}{y}}": r"a = \mathtt{gain}",
    r"y = a + bu_{u} + bi_{i}": r"y = a + b u_{i} + b",
    r"x = ln\alpha + b": r"x = \ln\alpha + b",
    r"RT = \frac{a}{b}": r"p = \frac{RT}{V}",
    r"GM = G \cdot M": r"v^2 = \frac{GM}{r}",
    r"\alpha = \frac{k}{\rho Cp}": r"\alpha = \frac{k}{\rho Cx}",
    r"Ft = \frac{x}{b}": r"Ax = b",
    r"eD = \frac{\epsilon}{D}": r"e = \frac{\epsilon}{D}",
    r"H(x, sf) = \sum_f P_f x": r"u(x, ct) = (x - ct)^2",
    r"W = (A \; B)": r"W = (A, B)",
    r"\frac{\partial u}{\partial t} = \Delta u": r"v = \frac{\Delta x}{\Delta t}",
    r"\Delta \phi = 4 \pi G \rho": r"\Delta \phi = k \Delta x",
    r"H = a + \Delta S_i^Z S_j^Z": r"H = a + \Delta S_j",
    r"i = r + \pi": r"\theta = \phi + \pi",
    "x = a \\sum_i b_i\nx_1 = c": "x = a \\sum_i b_i\n+ y",
    "x = a b\n\ny = c": "x = a b +\n\ny",
    r"y = f \circ g(x)": r"y = f \circ g",
    r"y(t_n + h) = y + h y'": r"y(t_n) = c + h y'",
    r"{}_a D_t^q f(t) = g(t)": r"{}_a D_t^q = g(t)",
    r"A = \lfloor \mathbf{p} \rfloor": r"A = \lfloor p \rfloor",
    r"K = \Sigma_i V_i K_i": r"K = \Sigma_i^{-1} V_i K_i",
    r"K = (\Sigma_i \frac{V_i}{K_i})^{-1}": r"K = (\mu_i \Sigma_i \frac{V}{K_i})^{-1}",
    r"F = a^T p(b^T W b)": r"F = a^T \phi(b^T W b)",
    r"G = b_o + b_1 (T)^{0.5}": r"G = b_1(T)^{0.5} + b_2(T)",
    r"y = n \varphi(X^n) + \varphi": r"y = n \varphi(X) + \varphi",
    r"\text{D}_t \mathbf{v} = \mathbf{a}": r"\text{D}_t + a = b",
    r"D_t u = a + b": r"D_t a^2 = a + b",
    r"D u_j = u_{j+1} - u_j": r"D u_j = u_j + b",
    r"\mathbf{D} f[n] = \frac{f[n] - f[n-1]}{h}": r"\mathbf{D} f[n] = \frac{f[n] - g[n-1]}{h}",
    r"w = g z = \frac{a z + b}{c z + d}": r"w = z = \frac{a z + b}{c z + d}",
    r"q_i^{n+1} = a q_i^n + Q_i^{n-2}": r"q_i^{n+1} = a q_i^n + n Q_i^{n-2}",
    r"\ln \gamma = A^{\gamma} z + b": r"\ln \gamma = A^{\gamma} z + \gamma",
    r"y = \sum_{n=1}^N W_t^n X_t^n": r"y = \sum_{n=1}^N W_n X_t^n",
    r"\alpha = c_{1} (1 - \frac{T}{Tc}) + c_{2}": r"\alpha = c_{1} (1 - \frac{T}{Tc}) + c",
    r"d = (m_i \cdot m_j)^2 - 1": r"d = (m_i \cdot h_j)^2 - 1",
    r"B_MX = a + b": r"B_M X = a + b",
    r"(a + c)^*(x^*) = b": r"(a + c)^* = b",
    r"f = 2 J_1(\frac{\pi r}{R})": r"f = 2 b_1(\frac{\pi r}{R})",
    r"y = a + An * \sin(n * E) + Bn * \cos(n * E)": r"y = a + A n \sin(n F) + B n + E",
    r"y = x_k^{b_i, j}": r"y = x_k^{i, j}",
    r"k = [N_h / 2] + 1": r"k = [N_h / h] + 1",
    r"y = 2 a^{\left[\frac{n}{2}\right]}": r"y = 2 a^{\left[\frac{n}{2} + n\right]}",
    r"P = \begin{bmatrix} -a \qquad -b \end{bmatrix}": r"P = \begin{bmatrix} -a & \qquad -b \end{bmatrix}",
    r"l = (x - a)(x - b)...": r"l = (x - a)(x - b).",
    r"\sigma^2 = \mathbb{E}(X - \mu)^2": r"\sigma^2 = \mathbb{E}[(X - \mu)^2]",
    r"v = \mathbb{E}[x - \mu]^2": r"v = \mathbb{E}[x]^2",
    r"u_{k,l} = u_{kl}, \quad k, l = 1, 2, 3": r"u_{k,l} = v_{k,l}, \quad k, l = 1, 2, 3",
    r"s = \sum_{p \in S} V_j^p": r"s = \sum_{p \in \mathbb{Z}} V_j^p",
    r"(\Delta + k^2) \psi = 0": r"(\Delta + k^2) x = 0",
    r"y = \langle x - a \rangle^2": r"y = \langle x \rangle^2",
    r"u_i + i v_i = 0": r"u_i + k v_i = 0",
    r"\Delta_1^2 F = 2": r"\Delta_1^2 = 2",
    r"y = \pi a + (1 - \pi) b": r"y = \pi a + (1 - 2 \pi) b",
    r"y = \nabla \exp(0)": r"y = \nabla \exp(x)",
    r"y = |a| (x) + b": r"y = |a| (x + 1) + b",
    r"\delta_i u = u_{i+1} - u_{i-1}": r"\delta_i u = u_{i+1} - w_{i-1}",
    r"x \in \langle a \rangle": r"x = \langle a \rangle",
    r"h = F_ab + c": r"h = F_ab + b",
    r"y = V^T_{ij} x_j": r"y = V_{ij} x_j",
    r"S = Q r_eff^2": r"S = \pi r_e f^2",
    r"y = (q1, hk)": r"y = (q_1, hk)",
    r"a = p_\mu p^\mu": r"a = p_\mu p^2",
    r"H_0 := f(x) < m": r"h_0 := f(x) < m",
    r"T = \lim_{k \to \infty} T(k)": r"T = \lim_{k \to \infty} S(k)",
    r"M = (W \ y - b)^T c": r"M = (W y - b)^T c",
    r"p_i^{CS} = C p_i^{ML}": r"p_i^{2 C} = C p_i",
    r"y = \mathbf{W}_0 \mathbf{x} + \mathbf{W}_1(f(x))": r"y = \mathbf{W}_0 \mathbf{x} + \mathbf{W}_1 f(x)",
    r"q = \frac{k}{n} F_{k,n}(1 - \alpha)": r"q = \frac{k}{n} f \cdot (1 - \alpha)",
    r"s = \gamma_* \gamma_*' / (\gamma_*' \Sigma \gamma_*)": r"s = \gamma_* \gamma_*'",
    r"b_{one}(t) = b_{two}((t - 1) / t)": r"b_{one} = b_{two} \frac{t - 1}{t}",
    r"q = s \Delta\Delta T + r": r"q = s \Delta T + r",
    r"u = u_1, \ldots, u_n": r"u = v_1, \ldots, v_n",
    r"S x = x \star w": r"S x = y \star w",
    r"G_{ij} = X_i \cdot X_j": r"G_{ij} = X_i X_j",
    r"hs = 4 \sqrt{m}": r"ax = 4 \sqrt{m}",
    r"4 \sqrt{m} = hs": r"4 \sqrt{m} = h s + s",
    r"hk_1 = \frac{k}{2}": r"kx_1 = \frac{k}{2}",
    r"z = \mathbf{cR} y": r"\mathbf{z} = \mathbf{Rc} y",
    r"y = \ln \frac{1}{2} (a + b)": r"y = \ln \frac{x}{2} (a + b)",
    r"y = \sin \frac{\pi}{2} (1 - x)": r"y = \sin \frac{\theta}{2} (1 - x)",
    r"m {^a} b = c": r"m {^2} b = c",
    r"y = \mathcal{P} \int_0^1 f(x) \, dx": r"y = \mathcal{Q} \int_0^1 f(x) \, dx",
    "C_{n} = a_1 + b_1\n\nC_{\\mu_{p}} = c_1": "C_{n} = a_1 + b_1 +\n\nC_{\\mu_{p}}",
    r"e_{ij}^{n+1} = b e_i^{n+1}": r"e_{ij}^2 = b e_i^2",
    r"\frac{\rho^{n+1} - \rho^n}{\Delta t} = c \rho n": r"\frac{\rho^2 - 1}{\Delta t} = c \rho^n n",
    r"a^{n+1, 0} = a^n": r"a^{n+1, 0} = a",
    r"y^{n(m+1)} - y^{n(m)} = a": r"y^{n(n+1)} - y^{m} = a m n",
    r"E^X = E^\infty": r"E^X = E",
    r"\frac{\partial c^i}{\partial t} = d_i + c^i, \quad i = 1, \ldots, 6": (
        r"\frac{\partial c_i}{\partial t} = d_i + c_i, \quad i = 1, \ldots, 6"
    ),
    r"E = \sum_{i, j > i}^N \frac{C_6^{ij}}{R_{ij}^6}": r"E = \sum_{i, j > i}^N \frac{C_6}{R_{ij}^6}",
    r"J(t, z) = f^I(t, z) + I": r"J(t, z) = f(t, z) + I",
    r"R^1(u, v) = u R^2(u, v)": r"R_1(u, v) = u R_2(u, v)",
    r"F = 1 - \frac{2b Ri}{1 + c}": r"F = 1 - \frac{2b R}{1 + c}",
    r"v = \mathcal{EM}(a + b)": r"v = \mathcal{E}(a) + b",
    r"\alpha - L^2 \Delta \alpha = 1": r"\alpha_2 - \alpha_1 = L \Delta \alpha",
    r"s = f_i \left(\frac{a}{b}\right)^{3/2}": r"s = f_i \frac{a}{b}",
    r"u = v \phi_h \left(\frac{z}{L}\right)": r"u = v \phi_h(z, L)",
    r"T = R^\dagger (TX - X^\dagger TX) R": r"T = a + X^\dagger",
    r"\hat\Theta \mathbf{H} = a \mathbf{H}": r"\hat\Theta = a",
    r"\psi_i(x) = C_{\mu i} \phi_\mu(x)": r"\psi_i(x) = C_i \phi_i(x)",
    r"E = \frac{f_{ia} f_{ia}}{e_a - e_i}": r"E = \frac{f_{ia}^2}{e_a - e_i}",
    r"u_t(t, 0, y) = 0": r"u(t, 0, y) = 0",
    r"p = \phi_r + \frac{1}{r} \phi_\theta": r"p = \phi_r + \frac{1}{r}",
    r"B = \begin{pmatrix} I_n + A_0 & A_1 \\ 0 & I_m \end{pmatrix}": (
        r"B = \begin{pmatrix} I_{11} & I_{12} \\ 0 & I_{22} \end{pmatrix}"
    ),
    r"z_n = h q(t_n, y_n) + \sum_{i=1}^q a_i z_{n-i}": r"z_n = h q(t_n, y_n) + \sum_{i=1}^p a_i z_{n-i}",
    r"\underline{a} = \underline{b}": r"\underline{a} = \underline{\nabla} b",
    r"\underline{w}^n \cdot \underline{S} = a": r"\underline{w} \cdot \underline{S} = a",
    r"\text{div} ((\rho \underline{u})^n a) = 0": r"\text{div} ((\rho \underline{u}) a) = 0",
    r"\delta P^{n+\theta} = P^{n+\theta} - P^{n-1+\theta}": r"\delta P = P^{n+\theta} - Q^{n-1+\theta}",
    r"\eta^n_{lm} = D^n_{11} n^2_{1, lm} + D^n_{22} n_2": r"\eta_{lm} = D_{11} n^2_{1, lm} + D_{22} n_2",
    r"\sum_{i=0}^K a_i y^{n-i} + h \sum_{i=0}^K b_i \dot{y}^{n-i} = 0": r"\sum_{i=0}^K a_i y^{n-i} + h \dot{y} = 0",
    r"J = \frac{\partial f^I}{\partial y}": r"J = \frac{\partial f_I}{\partial y}",
    r"\dot\xi = g_p^T + f_p^T \lambda, \quad \xi(T) = 0": r"\dot\xi = g_p + f_p \lambda, \quad \xi(T) = 0",
    r"h_a (e_b - e_I) = h'_{imp} (T_b - T_e)": r"h_a (e_b - e_I) = h_{imp} (T_b - T_e)",
    r"\text{D}_i = \text{P}_1 \text{P}_3 (\text{P}_2 + \text{P}_4)": (
        r"\text{D}_i = \text{P}_1 \text{P}_3 \cdot (\text{P}_2 + \text{P}_4)"
    ),
    r"b = \begin{cases} 1 & [O_2] < 0.01 \\ 0 & [O_2] > 0.01 \end{cases}": (
        r"b = \begin{cases} 1 & x < 0.01 \\ 0 & x > 0.01 \end{cases}"
    ),
    r"yyn = y_p + y_c": r"y_n = y_p + y_c",
    r"Eq = 0.01 + 0.02 \cos\theta": r"E_q = 0.01 + 0.02 \cos\theta",
    r"m = \sum_{i=0}^n (x_i H(id_i))^2": r"m = \sum_{i=0}^n (x_i H(i d))^2",
    r"u_t = \nabla \cdot (D \nabla u) + b": r"u_t = \nabla \cdot (D \nabla v) + b",
    r"\sum_{\kappa=1}^N X_\alpha^\kappa = 1": r"\sum_{\kappa=1}^N X_\kappa = 1",
    r"\nabla^2 f(x) = \begin{pmatrix} a & b \\ b & c \end{pmatrix}": r"\nabla^2 f(x) = a",
    r"-\Delta u + \exp(u) = 0": r"v - \Delta u + \exp(u) = 0",
    r"F(u) = -\Delta u + \exp(u)": r"F(u) = v - \Delta u + \exp(u)",
    r"b(u, q) = 0, \quad \forall q \in L^2(\Omega)": r"b(u, q) = 0, \quad \forall q \in L(\Omega)",
    r"F = B A^{-1} C b": r"F = A^{-1} b",
    r"Q_{ij} = G_{ij} - \delta_{ij} G_{kk}": r"Q_{ij} = G_{ij} - \delta_{ij} G_{12}",
    r"\partial u / \partial t = 2 u_{xx} + b": r"\partial u / \partial t = 2 v_{12} + b",
    r"\hat\pi(v)(\hat{x}) = b": r"\hat\pi(v) \hat{x} = b",
    r"[S(\Phi, a)]^{n+\theta} = b S(\Phi^n, a^n)": r"[S(\Phi, a)]^2 = b S(\Phi, a)",
    r"P = \frac{1}{2} P_{kk}": r"P = \frac{1}{2} P_{12}",
    r"P_{ij} = R_{ik} \frac{\partial u_j}{\partial x_k}": r"P_{ij} = R_{ij} \frac{\partial u_j}{\partial x}",
    r"J = I \frac{\partial f^I}{\partial y}": r"J = I \frac{\partial f}{\partial y}",
    r"A P^{-1} D^{-1} x = b": r"\mathbf{A} \mathbf{P}^{-1} \mathbf{D}^{-1} \mathbf{x} = \mathbf{b}",
}


@pytest.mark.parametrize("latex", EVIDENCE)
def test_what_nothing_shows_is_in_doubt(latex: str) -> None:
    with pytest.raises(SymcheckError):
        lower(*first_reading(latex))
    assert lower(*first_reading(EVIDENCE[latex]))


@pytest.mark.parametrize("word", ["log_sigmoid", "mean_t"])
def test_a_word_that_begins_like_a_function_has_a_variable_of_its_own(word: str) -> None:
    assert lower(*first_reading(rf"y = \mathrm{{{word}}}(x)"))


LINED = {  # what stands below a line is another letter, and what stands beside it is kept
    r"\underline{a} \cdot \underline{b}_i = c": r"\underline{a} \cdot \underline{b}_j = c",
    r"\underline{a} \cdot \underline{b}' = c": r"\underline{a} \cdot \underline{b} = c",
    r"\underline{\underline{a}} \, \underline{b} = c": r"\underline{\underline{b}} \, \underline{a} = c",
    r"a = \underline{a} \cdot \underline{b}": r"\underline{a} = a \cdot \underline{b}",
    r"\underline{\nabla}_i a = \underline{b}": r"\underline{\nabla}_j a = \underline{b}",
}


@pytest.mark.parametrize("latex", LINED)
def test_a_line_below_a_letter_makes_it_another_one_and_drops_no_scripts(latex: str) -> None:
    assert lower(*first_reading(latex)) != lower(*first_reading(LINED[latex]))


def test_lines_below_letters_make_vectors_and_matrices() -> None:
    moving = first_reading(r"\frac{\partial \underline{D}}{\partial t} = \underline{\nabla} b")[1]
    assert (letter := moving.find(r"\underline{D}", 0))
    assert letter.kind == "vector"
    notation = first_reading(r"\underline{\underline{D}} \, \underline{w} = \underline{v}")[1]
    kinds = [notation.find(each, 0) for each in (r"\underline{\underline{D}}", r"\underline{w}", r"\underline{v}")]
    assert [each and each.kind for each in kinds] == ["matrix", "vector", "vector"]


def test_the_last_of_the_values_of_an_index_is_equal_to_nothing_on_the_next_line() -> None:
    tree = first_reading(r"z_i = a, \quad i = 1, \ldots, s, \\ y_n = b")[0]
    assert bracketed(tree) == "System(Chain(z_i, a; =), Values(i; 1, Dots(), s), Chain(y_n, b; =))"


@pytest.mark.parametrize("latex", [r"y = \arg(a, b)", r"y = \operatorname{sgn}(a, b)", r"y = \operatorname{atan2}(a)"])
def test_functions_that_jump_have_as_many_arguments_as_they_have(latex: str) -> None:
    with pytest.raises(SymcheckError, match="has"):
        lower(*first_reading(latex))


def test_an_index_that_is_compared_is_no_imaginary_unit() -> None:
    notation = first_reading(r"a = \begin{cases} 0 & i = 1 \\ b & 2 \le i \le s \end{cases}")[1]
    letter = notation.find("i", 0)
    assert letter
    assert not letter.number
    assert first_reading(r"a = b e^{i t}")[1].find("i", 0).number == "i"  # type: ignore[union-attr]


def test_tr_before_a_tensor_is_its_trace() -> None:
    assert (
        first_reading(r"a = tr{\underline{\underline{T}}}")[0] == first_reading(r"a = tr(\underline{\underline{T}})")[0]
    )
    tree = first_reading(r"a = tr \underline{\underline{T}} b")[0]
    assert bracketed(tree) == r"Chain(a, Mul(Call(tr; \underline{\underline{T}}), b); =)"


FIELDS = {
    r"\mathbf{c} = \mathbf{k} \times \mathbf{E} + \mathbf{B}": "vector",
    r"\mathbf{E} = \mathbf{H}^T \mathbf{H}": "matrix",
}


@pytest.mark.parametrize("latex", FIELDS)
def test_the_electric_field_is_a_vector_where_waves_or_other_fields_are_beside_it(latex: str) -> None:
    letter = first_reading(latex)[1].find(r"\mathbf{E}", 0)
    assert letter
    assert letter.kind == FIELDS[latex]


def test_bars_of_lengths_within_averages_are_no_states() -> None:
    assert bracketed(first_reading(r"a = \langle |x|^2 \rangle")[0]) == "Chain(a, Call(average; Pow(Bars(x); 2)); =)"
    assert bracketed(first_reading(r"a = \langle |x| y \rangle")[0]) == "Chain(a, Call(average; Mul(Bars(x), y)); =)"


def test_what_is_integrated_as_a_power_of_one_letter_may_depend_on_the_variable() -> None:
    assert all(formula.tag == "form" for formula in lower(*first_reading(r"\int_0^L \psi^2 \, dx = 1")))
    assert all(formula.tag != "form" for formula in lower(*first_reading(r"\int_0^L x^2 \, dx = a")))


def test_a_prime_differentiates_by_the_time_and_not_by_its_first_value() -> None:
    letter = first_reading(r"y' = f(t, y), \quad y(t_0) = a")[1].find("y", 0)
    assert letter
    assert letter.depends == "t"


@pytest.mark.parametrize("latex", [r"\bar{L} = \bar{A}^T", r"\bar{u} = \bar{v}^T"])
def test_what_is_transposed_below_an_accent_is_a_matrix_if_it_is_capital(latex: str) -> None:
    letter = first_reading(latex)[1].find(r"\bar{A}" if "A" in latex else r"\bar{v}", 0)
    assert letter
    assert letter.kind == ("matrix" if "A" in latex else "vector")
