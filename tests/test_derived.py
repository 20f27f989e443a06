"""What follows from earlier relations of a document, and which relation does not agree with the others."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice, product
from pathlib import Path

import pytest
from test_new import _apart, begun, verdicts  # noqa: F401

from symcheck import decide, look
from symcheck.document.checks import MOST_CONDITIONS, Checks
from symcheck.document.paper import Document
from symcheck.document.points import Found, compared, slips
from symcheck.document.printed import Printed
from symcheck.document.sources import source
from symcheck.proof.search.number_points import _places

LETTERS = (("e", "scalar"),)
ENERGY = (r"E = \frac{h^2}{2 p^2} - \frac{\mu}{p}", r"p = a (1 - e)", r"a (1 - e^2) = \frac{h^2}{\mu}")
ANOMALY = (r"a \cos\psi = a e + r \cos\nu", r"r = \frac{a (1 - e^2)}{1 + e \cos\nu}")
PERICENTRE = (r"E = -\frac{\mu}{2 a}", ENERGY[0], ENERGY[2])
SIDES = (r"x = y + z", r"z = 2 y")

COMPARED = [
    (r"E = -\frac{\mu}{2 a}", ENERGY, Found(holds=True, bound=True)),
    (r"E = -\frac{\mu}{3 a}", ENERGY, Found(holds=False, bound=True)),
    (r"\cos\psi = \frac{e + \cos\nu}{1 + e \cos\nu}", ANOMALY, Found(holds=True, bound=True)),
    (r"\cos\psi = \frac{e - \cos\nu}{1 + e \cos\nu}", ANOMALY, Found(holds=False, bound=True)),
    (r"p = a (1 - e)", PERICENTRE, Found(holds=True, bound=True)),  # or a (1 + e)
    (r"p = a (1 + e)", PERICENTRE, Found(holds=True, bound=True)),
    (r"p = a (1 - 2 e)", PERICENTRE, Found(holds=False, bound=True)),
    (r"x = 3 y", SIDES, Found(holds=True, bound=True)),
    (r"x = 3 y", SIDES[:1], Found(holds=False, bound=False)),
    (r"x = 3 w", SIDES, None),
    (r"y = 2 z", (r"\frac{1}{x} = 2", "y = 4 x z"), Found(holds=True, bound=True)),  # at x = 0 there is no value
    (r"y = 2 z", ("x = 0", "y = 4 x + 2 z"), Found(holds=True, bound=True)),
    (r"y = 3 z", ("x = 0", "y = 4 x + 2 z"), Found(holds=False, bound=True)),
    (r"x = 3 y", (*SIDES, "x = x + 1"), None),
    (r"\dot V = 2 x \dot x", (r"V = x^2",), Found(holds=True, bound=True)),
    (r"\dot V = 3 x \dot x", (r"V = x^2",), Found(holds=False, bound=True)),
    (r"\dot V = -2 x^2", (r"V = x^2", r"\dot x = -x"), Found(holds=True, bound=True)),
    (r"\ddot x = \alpha \sin t", (r"x = -\alpha \cos t",), Found(holds=False, bound=True)),
    # three equations do not follow from one, and fail without anything being wrong
    (
        r"\mathbf{x} = \mathbf{y} + \mathbf{z}",
        (r"\mathbf{x} \cdot \mathbf{z} = \mathbf{y} \cdot \mathbf{z} + \mathbf{z} \cdot \mathbf{z}",),
        Found(holds=False, bound=False),
    ),
]


@pytest.mark.parametrize(("relation", "sources", "found"), COMPARED)
def test_points_tell_what_holds_and_what_is_bound(relation: str, sources: tuple[str, ...], found: Found | None) -> None:
    assert compared(relation, sources, LETTERS) == found


def test_slips_of_the_pen_hold_at_points_and_other_changes_are_none() -> None:
    assert next(slips(r"E = -\frac{\mu}{3 a}", ENERGY, LETTERS)) == r"E = -\frac{\mu}{2 a}"
    assert not any(slips(r"E = \frac{\mu^2}{3 a} + h", ENERGY, LETTERS))


# well-known relations of an elliptic orbit, none of which defines all letters of the next one
ORBIT = r"""# An orbit

The energy and the momentum of a satellite give
$$E = \frac{v^2}{2} - \frac{\mu}{r}$$
$$E = \frac{h^2}{2 p^2} - \frac{\mu}{p}$$
The pericentre lies at
$$p = a (1 - e)$$
and the momentum is
$$a (1 - e^2) = \frac{h^2}{\mu}$$
Substituting these we find
$$E = -\frac{\mu}{2 a}$$
and therefore
$$v^2 = \mu \left(\frac{2}{r} - \frac{1}{a}\right)$$
The eccentric anomaly is introduced by
$$a \cos\psi = a e + r \cos\nu \quad\Longrightarrow\quad \cos\psi = \frac{a e + r \cos\nu}{a}$$
where
$$r = \frac{a (1 - e^2)}{1 + e \cos\nu}$$
so that
$$\cos\psi = \frac{e + \cos\nu}{1 + e \cos\nu}$$
$$r = a (1 - e \cos\psi)$$
"""
FOLLOWING = ["line 11", "line 13", "line 15", "line 19", "line 20"]
MISPRINTS = [
    (r"E = -\frac{\mu}{2 a}", r"E = -\frac{\mu}{3 a}", "line 11"),
    (r"\cos\psi = \frac{e + ", r"\cos\psi = \frac{e - ", "line 19"),
    (r"r = a (1 - e \cos\psi)", r"r = a (1 + e \cos\psi)", "line 20"),
    (r"r = \frac{a (1 - e^2)}", r"r = \frac{a (1 + e^2)}", "line 17"),
]


def test_what_follows_from_earlier_relations_is_told_and_nothing_else(tmp_path: Path) -> None:
    (tmp_path / "orbit.md").write_text(ORBIT, encoding="utf-8")
    found = look(tmp_path / "orbit.md")
    assert [*found.follows] == FOLLOWING
    assert not found.findings


@pytest.mark.parametrize(
    ("right", "wrong", "place"),
    [MISPRINTS[0], *(pytest.param(*each, marks=pytest.mark.slow) for each in MISPRINTS[1:])],
)
def test_the_relation_that_does_not_agree_is_found(right: str, wrong: str, place: str, tmp_path: Path) -> None:
    """In what follows, and in what others follow from."""
    (tmp_path / "orbit.md").write_text(ORBIT.replace(right, wrong), encoding="utf-8")
    found = look(tmp_path / "orbit.md")
    assert [each.place for each in found.findings] == [place]
    assert found.findings[0].point


@pytest.mark.slow
def test_of_two_relations_of_which_either_may_be_wrong_both_are_told(tmp_path: Path) -> None:
    wrong = ORBIT.replace(r"\frac{2}{r} - \frac{1}{a}", r"\frac{2}{r} + \frac{1}{a}")
    (tmp_path / "orbit.md").write_text(wrong, encoding="utf-8")
    [finding] = look(tmp_path / "orbit.md").findings
    assert (finding.place, finding.definitions) == ("line 13", (r"line 4: E = \frac{v^2}{2} - \frac{\mu}{r}",))
    assert "refuted" not in verdicts(begun(tmp_path, wrong, "orbit.md")).values()


def test_a_line_that_follows_from_a_wrong_one_is_no_witness_for_it(tmp_path: Path) -> None:
    wrong = ORBIT.replace("and therefore", "or\n$$2 a E = -\\mu$$\nand therefore").replace(r"\mu}{2 a}", r"\mu}{3 a}")
    (tmp_path / "orbit.md").write_text(wrong.replace(r"2 a E", r"3 a E"), encoding="utf-8")
    assert {each.place for each in look(tmp_path / "orbit.md").findings} == {"line 11", "line 13"}


@pytest.mark.slow
@pytest.mark.parametrize(("right", "wrong", "place"), MISPRINTS)
def test_an_audit_refutes_it_and_no_sound_relation(right: str, wrong: str, place: str, tmp_path: Path) -> None:
    audit = begun(tmp_path, ORBIT.replace(right, wrong), "orbit.md")
    code = (audit / "audit.py").read_text(encoding="utf-8")
    assert f'source.claim("{place}", follows=' in code
    assert [*verdicts(audit).values()].count("refuted") == 1


def test_an_audit_proves_what_follows(tmp_path: Path) -> None:
    audit = begun(tmp_path, ORBIT, "orbit.md")
    assert {*verdicts(audit).values()} == {"proved"}
    assert len(verdicts(audit)) == len(FOLLOWING)


# a pendulum of length l on a cart, for small angles; facts of mechanics in our own words
CART = r"""# A pendulum on a cart

The equations of motion are
$$(M + m) \ddot{x} + m l \ddot{\theta} = F$$
$$\ddot{x} + l \ddot{\theta} = g \theta$$
They give
$$\ddot{x} = -\frac{m g}{M} \theta + \frac{1}{M} F$$
$$\ddot{\theta} = \frac{g (M + m)}{l M} \theta - \frac{1}{l M} F$$
or, with matrices,
$$\begin{bmatrix} \ddot{x} \\ \ddot{\theta} \end{bmatrix} = \begin{bmatrix} 0 & -\frac{m g}{M} \\
0 & \frac{(M + m) g}{M l} \end{bmatrix} \begin{bmatrix} x \\ \theta \end{bmatrix} +
\begin{bmatrix} \frac{1}{M} \\ -\frac{1}{M l} \end{bmatrix} F$$
"""
OF_THE_CART = [
    (r"-\frac{m g}{M} \theta +", r"-\frac{M g}{m} \theta +", ["line 7"]),
    (r"\frac{(M + m) g}{M l}", r"\frac{(M + m) g}{M}", ["line 10"]),
    (r"\\ -\frac{1}{M l} \end", r"\\ \frac{1}{M l} \end", ["line 10"]),
]
# the equation of an orbit and its solution: two of these do not agree if a divisor should be a factor
INVERSE = r"""# The inverse radius

Let $\eta = 1/r$. The general solution is
$$\eta = \frac{\mu}{h^2} + C \cos(\theta - \omega)$$
The radius ($r = 1/\eta$) is then
$$r = \frac{h^2}{\mu + C h^2 \cos(\theta - \omega)}$$
"""
# a chain by derivatives, of which one link is what others follow from
CHAIN = r"""# The orbit

The motion obeys
$$\ddot{r} = r \dot{\theta}^2 - \frac{\mu}{r^2} = \frac{h^2}{r^3} - \frac{\mu}{r^2}$$
Let $\eta = 1/r$. Then
$$\frac{d^2\eta}{d\theta^2} = \frac{d}{d\theta}\left(-\frac{1}{r^2} \frac{dr}{d\theta}\right)
= -\frac{1}{r^2} \frac{d^2 r}{d\theta^2} + \frac{2}{r^3} \left[\frac{dr}{d\theta}\right]^2$$
"""


@pytest.mark.parametrize(
    ("right", "wrong", "places"),
    [("", "", []), OF_THE_CART[1], *(pytest.param(*each, marks=pytest.mark.slow) for each in OF_THE_CART[::2])],
)
def test_slips_in_fractions_and_matrices_are_found(right: str, wrong: str, places: list[str], tmp_path: Path) -> None:
    (tmp_path / "cart.md").write_text(CART.replace(right, wrong) if right else CART, encoding="utf-8")
    assert [each.place for each in look(tmp_path / "cart.md").findings] == places


def test_an_equation_that_is_printed_again_otherwise_is_told_with_the_first(tmp_path: Path) -> None:
    again = CART + "\nThe equations were\n$$(M + m) \\ddot{x} - m l \\ddot{\\theta} = F$$\n"
    (tmp_path / "cart.md").write_text(again, encoding="utf-8")
    assert [each.place for each in look(tmp_path / "cart.md").findings] == ["line 15"]


def test_a_divisor_that_should_be_a_factor_is_found(tmp_path: Path) -> None:
    (tmp_path / "inverse.md").write_text(INVERSE, encoding="utf-8")
    assert not look(tmp_path / "inverse.md").findings
    (tmp_path / "wrong.md").write_text(INVERSE.replace(r"C h^2", r"\frac{C}{h^2}"), encoding="utf-8")
    assert [each.place for each in look(tmp_path / "wrong.md").findings] == ["line 6"]


# of a chain one link is an identity, in the other a letter is free; the words name what it rests on
VELOCITY = r"""# The period

The mean motion is
\begin{equation} n = \sqrt{\frac{\mu}{a^3}} \label{mean motion} \end{equation}

# The velocity

With \eqref{mean motion} the square of the velocity becomes
\begin{equation} n^2 a^2 \left(\frac{2 a}{r} - 1\right) = \frac{2 n^2 a^3}{r} - n^2 a^2
= \mu \left(\frac{2}{r} - \frac{1}{a}\right) \end{equation}
"""


def test_a_wrong_link_behind_a_right_one_is_found_by_what_the_words_name(tmp_path: Path) -> None:
    (tmp_path / "orbit.md").write_text(VELOCITY, encoding="utf-8")
    assert not look(tmp_path / "orbit.md").findings
    (tmp_path / "wrong.md").write_text(VELOCITY.replace(r"\frac{2}{r} -", r"\frac{1}{r} -"), encoding="utf-8")
    assert [each.place for each in look(tmp_path / "wrong.md").findings] == ["line 9"]


def test_a_number_that_stands_twice_means_the_last_one_before_the_words(tmp_path: Path) -> None:
    text = "$$a = b \\tag{1}$$\n\n$$c = d \\tag{1}$$\n\nBy (1) it is\n\n$$2 c = 2 d$$\n\n$$e = f \\tag{1}$$\n"
    (tmp_path / "paper.md").write_text(text, encoding="utf-8")
    formulas = source(tmp_path / "paper.md").formulas
    assert Checks(formulas, [], []).named(2, formulas[2].before) == ({"1"}, [1])


# transforms, of which no counterexample can be a proof: functions are not only so at one point
TRANSFORMS = r"""Taking Laplace transforms:
$$s I_{zz} \Omega(s) = T(s)$$
$$s \Sigma(s) = \frac{1}{4} \Omega(s)$$
Eliminating $\Omega(s)$:
$$\Sigma(s) = \frac{1}{4 s} \Omega(s) = \frac{1}{4 s} \cdot \frac{T(s)}{s I_{zz}}$$
$$G(s) = \frac{\Sigma(s)}{T(s)} = \frac{1}{4 I_{zz} s^2}$$
"""


def test_functions_that_do_not_agree_are_told_without_a_point(tmp_path: Path) -> None:
    (tmp_path / "plant.md").write_text(TRANSFORMS, encoding="utf-8")
    assert not look(tmp_path / "plant.md").findings
    (tmp_path / "wrong.md").write_text(TRANSFORMS.replace(r"{T(s)}{s I_{zz}}", r"{T(s)}{s^2 I_{zz}}"), encoding="utf-8")
    assert [(each.place, each.point) for each in look(tmp_path / "wrong.md").findings] == [("line 5", {})]


def test_a_wrong_link_of_a_chain_of_derivatives_is_found(tmp_path: Path) -> None:
    assert {*verdicts(begun(tmp_path, CHAIN, "chain.md")).values()} <= {"proved", "undecided"}
    (tmp_path / "wrong.md").write_text(CHAIN.replace(r"\frac{2}{r^3}", r"\frac{2}{r^2}"), encoding="utf-8")
    assert [each.place for each in look(tmp_path / "wrong.md").findings] == ["line 6"]


# cases, and letters that mean something else: what fails there is no error
CASES = [
    "On a circular orbit\n$$v = \\sqrt{\\frac{\\mu}{r}}$$\nand to escape\n$$v = \\sqrt{\\frac{2 \\mu}{r}}$$",
    "## Ellipses\n$$b = a + c$$\n$$c = a e$$\n## Hyperbolas\n$$c = -a e$$",
    "# One\n$$F = m a$$\n$$a = 2 g$$\n# Two\n$$F = 3 m g$$\n$$a = 5 g + m$$",
    "The energy is\n$$E = -\\frac{\\mu}{2 a}$$\n$$E = \\frac{h^2}{2 p^2} - \\frac{\\mu}{p}$$\n"
    "$$h^2 = \\mu a (1 - e^2)$$\nso that\n$$p = a (1 - e)$$",
    "If the body is at rest\n$$x = 2 y$$\n$$y = z$$\nwe set\n$$x = 3 z$$",
]


@pytest.mark.parametrize("text", CASES)
def test_nothing_is_said_against_other_cases(text: str, tmp_path: Path) -> None:
    (tmp_path / "cases.md").write_text(text + "\n", encoding="utf-8")
    assert not look(tmp_path / "cases.md").findings


GOES_ON = r"""Then
\begin{equation} \frac{y}{r} = \cos b \cos c - \sin b \sin c \end{equation}
\begin{equation} = \cos (b SIGN c) \end{equation}
"""


def test_a_display_that_begins_with_a_sign_goes_on_with_the_one_above_it(tmp_path: Path) -> None:
    for sign, verdict, found in (("+", "proved", []), ("-", "refuted", ["line 3"])):
        text = GOES_ON.replace("SIGN", sign)
        own = tmp_path / verdict
        assert verdicts(begun(own, text, "notes.md"))["0.2"] == verdict
        seen = look(next(own.rglob("notes.md")))
        assert [each.place for each in seen.findings] == found
        assert seen.formulas[1].goes_on
        assert not look_at(tmp_path, text.replace("\n\\begin{equation} =", " that is \\begin{equation} ="))[1].goes_on


def look_at(folder: Path, text: str) -> tuple[Printed, ...]:
    (folder / "other.md").write_text(text, encoding="utf-8")
    return look(folder / "other.md").formulas


def test_html_has_headings_behind_which_letters_may_mean_something_else(tmp_path: Path) -> None:
    text = "<h2>One</h2>\n\n$$L = m \\sqrt{a (1 - c^2)}$$\n\n{}\n\n$$L = m \\sqrt{a}$$\n"
    apart = text.replace("{}", "<h2>Two</h2>")
    assert [each.scope[0] for each in look_at(tmp_path, apart)] == [1, 2]
    assert "refuted" not in verdicts(begun(tmp_path / "apart", apart, "n.md")).values()
    assert "refuted" in verdicts(begun(tmp_path / "together", text.replace("{}", "again"), "n.md")).values()


def test_a_far_relation_of_the_same_letters_may_be_a_condition(tmp_path: Path) -> None:
    apart = "\n\n".join(f"$$u_{k} = {k} v_{k} + w_{k}$$" for k in range(1, 2 * MOST_CONDITIONS))
    audit = begun(tmp_path, f"$$P = m a$$\n\n{apart}\n\n$$f a = f P$$\n", "n.md")
    document = Document(str(audit / "audit.py"), "../n.md")
    claim = document.claim(f"line {5 + 2 * (2 * MOST_CONDITIONS - 1) - 2}")
    beside = document._beside(replace(claim, question=replace(claim.question, text="f a m = f P")), set())
    assert beside.question.near == (("line 1", "P = m a"),)


def test_points_are_tried_by_their_sums_and_then_in_order() -> None:
    for count, size in ((0, 3), (1, 5), (3, 3), (4, 5)):
        assert [*_places(count, size)] == sorted(product(range(size), repeat=count), key=sum)
    assert len([*islice(_places(60, 5), 100)]) == 100  # of five to the sixtieth


def test_a_derivative_by_a_letter_that_is_defined_refutes_nothing() -> None:
    answer = decide(r"\dot{r} = \dot{u} \frac{d r}{d u}", [r"u = \frac{1}{r}"])
    assert answer.verdict in ("undecided", "ambiguous", "unreadable", "proved")


def test_what_may_be_one_name_in_a_formula_may_be_one_in_all_of_a_document(tmp_path: Path) -> None:
    text = "Let $$w = Cr \\sqrt{1 - y^2}$$ and $$w = Cr \\sqrt{S - (x - r)^2}.$$\n"
    (tmp_path / "n.md").write_text(text, encoding="utf-8")
    assert look(tmp_path / "n.md").read == (False, False)
    (tmp_path / "n.md").write_text(text + "\nThe factors are $$C = 2 r$$ here.\n", encoding="utf-8")
    assert look(tmp_path / "n.md").read == (True, True, True)


# what holds nearly does not follow from what holds exactly, and says nothing against it
SWINGING = r"""# A pendulum

The equation of motion is
$$m l^2 \ddot\theta + m g l \sin\theta = u l$$
and, since $m \ne 0$ and $l \ne 0$,
$$l \ddot\theta + g \sin\theta = \frac{u}{m}$$

## Near the rest

Linearized about the rest this is
$$l \ddot\theta + g \theta = \frac{u}{m}$$
and therefore
$$\ddot\theta = \frac{u}{m l} - \frac{g}{l} \theta$$

## A model

With its rate the angle satisfies
$$\begin{pmatrix} \dot\theta \\ \ddot\theta \end{pmatrix} = \begin{pmatrix} 0 & 1 \\ -\frac{g}{l} & 0 \end{pmatrix}
\begin{pmatrix} \theta \\ \dot\theta \end{pmatrix} + \begin{pmatrix} 0 \\ \frac{1}{m l} \end{pmatrix} u$$
"""
SWINGS = [
    (r"l \ddot\theta + g \sin", r"m l \ddot\theta + g \sin", ["line 6"]),
    (r"\frac{u}{m l} - \frac{g}{l} \theta", r"\frac{u}{m l} + \frac{g}{l} \theta", ["line 13"]),
    (r"\\ \frac{1}{m l} \end", r"\\ \frac{1}{m} \end", ["line 18"]),
]


def test_what_holds_nearly_is_not_held_against_what_holds_exactly(tmp_path: Path) -> None:
    (tmp_path / "pendulum.md").write_text(SWINGING, encoding="utf-8")
    assert not look(tmp_path / "pendulum.md").findings


@pytest.mark.parametrize(("right", "wrong", "places"), SWINGS)
def test_slips_among_what_holds_nearly_and_exactly_are_found(
    right: str, wrong: str, places: list[str], tmp_path: Path
) -> None:
    assert right in SWINGING
    (tmp_path / "pendulum.md").write_text(SWINGING.replace(right, wrong), encoding="utf-8")
    assert [each.place for each in look(tmp_path / "pendulum.md").findings] == places


def test_a_matrix_of_which_nothing_is_said_may_be_symmetric() -> None:
    rate, energy = r"\dot V = 2 \mathbf{x}^T \mathbf{P} \dot{\mathbf{x}}", (r"V = \mathbf{x}^T \mathbf{P} \mathbf{x}",)
    assert compared(rate, energy, ()) == Found(holds=True, bound=True)
    assert compared(rate.replace("2", "3"), energy, ()) == Found(holds=False, bound=True)
    given = (*energy, r"\mathbf{P} = \begin{pmatrix} 1 & 2 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & 1 \end{pmatrix}")
    assert compared(rate, given, ()) == Found(holds=False, bound=True)
