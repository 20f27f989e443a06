"""What authors rely on without a word: lengths beside bold letters, Lagrange's functions, signs that several fields use.

Each of these was once decided wrongly, or is the counterpart of one that was.
"""

from __future__ import annotations

import pytest

from symcheck import decide

LAGRANGE = [r"L = \frac12 m \dot q^2 - V(q)"]
PENDULUM = [r"L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta"]

VERDICTS: dict[str, list[tuple[str, list[str]]]] = {
    "proved": [
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
        (r"\dot{r} = \frac{\mathbf{r}\cdot\mathbf{v}}{r}", [r"\mathbf{v} = \dot{\mathbf{r}}"]),
        (r"\frac{d}{dt}\frac{1}{r} = -\frac{\mathbf{r}\cdot\dot{\mathbf{r}}}{r^3}", []),
        (r"\mathbf{u}^2 = \mathbf{u}\cdot\mathbf{u}", []),
        (r"[\mathbf{a}]_\times \mathbf{b} = \mathbf{a}\times\mathbf{b}", []),
        (r"[\mathbf{a}]_{\times}^2 = \mathbf{a}\mathbf{a}^T - \|\mathbf{a}\|^2 \mathbf{I}", []),
    ],
    "refuted": [
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
}


@pytest.mark.parametrize(
    ("verdict", "relation", "where"), [(v, *each) for v, several in VERDICTS.items() for each in several]
)
def test_what_authors_mean_is_decided(verdict: str, relation: str, where: list[str]) -> None:
    assert decide(relation, where=where).verdict == verdict


@pytest.mark.parametrize("relation", [r"\frac{\partial L}{\partial x} = 2 I x", r"\frac{\partial L}{\partial x} = I x"])
def test_an_equation_with_a_factor_before_a_letter_does_not_define_it(relation: str) -> None:
    assert decide(relation, where=["2L = I x^2"]).verdict == "undecided"
