"""What changes along a motion: derivatives by letters that depend on others, and letters that may turn or change."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_new import _apart, begun, verdicts  # noqa: F401

from symcheck import decide

# relations in which a derivative is taken by what depends on the time itself
TOTAL = {
    r"\dot r = \frac{dr}{d\theta} \dot\theta": "proved",
    r"\frac{dr}{dt} = \frac{dr}{d\theta} \frac{d\theta}{dt}": "proved",
    r"\frac{dt}{d\theta} = \frac{1}{\dot\theta}": "proved",
    r"\ddot x = \frac{1}{2} \frac{d \dot x^2}{dx}": "proved",
    r"\ddot x = \frac{d \dot x^2}{dx}": "undecided",  # an equation of motion, perhaps
    r"\frac{d^2 r}{d\theta^2} = \frac{\ddot r \dot\theta - \dot r \ddot\theta}{\dot\theta^3}": "proved",
    r"\frac{d^2 r}{d\theta^2} = \frac{\ddot r \dot\theta + \dot r \ddot\theta}{\dot\theta^3}": "refuted",
    r"\frac{d}{d\theta}\left(\frac{\dot r}{\dot\theta}\right) = "
    r"\frac{1}{\dot\theta} \frac{d}{dt}\left(\frac{\dot r}{\dot\theta}\right)": "proved",
    # in a loose notation these may be partial derivatives
    r"\frac{df}{dt} = \frac{\partial f}{\partial t} + \frac{df}{dx} \dot x": "ambiguous",
    r"\dot V = \frac{dV}{dx} \dot x + \frac{dV}{dy} \dot y": "ambiguous",
    r"\frac{d}{dt} \frac{dL}{d\dot q} = \frac{dL}{dq}": "unreadable",
}
TURNING = (r"\mathbf{s} = f \mathbf{u}", r"\mathbf{w} = \mathbf{s} \times \dot{\mathbf{s}}")
KINETIC = (r"K = \frac{1}{2} m v^2",)
# relations, with those that say what their letters are, and what is said of letters
CHANGING = [
    (r"\mathbf{w} \cdot \mathbf{b} = 0", TURNING, {"f": "depends on t"}, "ambiguous"),
    (r"\mathbf{w} \cdot \mathbf{b} = 0", TURNING, {"f": "depends on t", r"\mathbf{u}": "constant vector"}, "proved"),
    (r"\mathbf{w} = f^2 \mathbf{u} \times \dot{\mathbf{u}}", TURNING, {"f": "depends on t"}, "proved"),
    (r"\dot K = 0", KINETIC, {}, "ambiguous"),
    (r"\dot K = F v", KINETIC, {}, "ambiguous"),
    (r"\dot K = m v \dot v", KINETIC, {}, "proved"),
    (r"\dot K = 0", KINETIC, {"m": "constant", "v": "constant"}, "proved"),
    (r"\frac{d}{dt}(f \mathbf{u}) = \dot f \mathbf{u}", (), {}, "ambiguous"),
    (r"\frac{d}{dt}(f \mathbf{u}) = \dot f \mathbf{u}", (), {r"\mathbf{u}": "constant vector"}, "proved"),
    (r"\frac{d}{dt}(m \mathbf{u}) = m \dot{\mathbf{u}}", (), {}, "proved"),
]


@pytest.mark.parametrize("relation", TOTAL)
def test_a_total_derivative_follows_the_motion(relation: str) -> None:
    answer = decide(relation)
    assert answer.verdict == TOTAL[relation], answer.reason


@pytest.mark.parametrize(("relation", "where", "letters", "verdict"), CHANGING)
def test_what_is_differentiated_is_constant_only_where_that_is_said_or_plain(
    relation: str, where: tuple[str, ...], letters: dict[str, str], verdict: str
) -> None:
    answer = decide(relation, where, letters=letters)
    assert answer.verdict == verdict, answer.reason


def test_a_letter_of_a_document_that_may_be_anything_is_a_new_one(tmp_path: Path) -> None:
    text = r"""# Coordinates

We write
$$x = r \cos\theta$$
$$y = r \sin\theta$$

# Products

For any $x, y \in \mathbb{R}^3$ the product is
$$x \cdot y = |x| |y| \cos\theta$$
where $\theta$ is the angle between them.
"""
    assert "refuted" not in verdicts(begun(tmp_path, text, "coordinates.md")).values()


def test_the_length_of_a_bold_letter_says_nothing_of_the_plain_one(tmp_path: Path) -> None:
    text = r"""# Momentum

The momentum is
$$\mathbf{h} = \mathbf{r} \times \dot{\mathbf{r}}$$
$$h = |\mathbf{h}|$$
We have
$$\frac{d}{dt}\left(\frac{r^2 \dot r}{h}\right) = \frac{2 r \dot r^2 + r^2 \ddot r}{h}$$
"""
    assert verdicts(begun(tmp_path, text, "momentum.md")).popitem()[1] == "proved"


def test_an_audit_declares_no_letters_of_what_may_be_one_name(tmp_path: Path) -> None:
    text = "# Energy\n\nWe have\n\n$$E = KE + PE$$\n\nand\n\n$$v = 2 u$$\n"
    code = (begun(tmp_path, text, "energy.md") / "audit.py").read_text(encoding="utf-8")
    assert 'letter("u")' in code
    assert 'letter("K")' not in code
