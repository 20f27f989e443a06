"""Formulas made up by a small grammar, in a notation that declares every kind of letter."""

from __future__ import annotations

import itertools
import random

from symcheck.reading import Letter, Notation

GENERATED = Notation(
    [
        *(Letter(index, kind="index") for index in "ij"),
        Letter("n", kind="index", range=(1, 2, 3, 4)),
        *(Letter(latex) for latex in ("x", "y", "z", r"\alpha", r"\beta", r"\lambda", r"\bar{k}", "h_0", r"\pi")),
        *(Letter(latex, depends="") for latex in ("a", "b", "c", "k", "t", r"\omega")),
        Letter("e", number="e"),
        *(Letter(latex, indices=1) for latex in ("I", "J", r"\mu")),
        *(Letter(latex, indices=2) for latex in ("a", "m")),
        Letter("s", indices=1, range=(1, 2, 3, 4)),
        *(Letter(latex, depends="t") for latex in ("r", r"\theta")),
        Letter("q", indices=1, depends="t"),
        Letter("f", kind="function"),
        Letter("g", kind="function", depends="x"),
        Letter("u", kind="function", depends="x, t"),
        Letter("d", kind="differential"),
        Letter(r"\mathbf{v}", kind="vector"),
        Letter(r"\mathbf{w}", kind="vector", components=r"(\mu_1, \mu_2, \mu_3)"),
        Letter(r"\mathbf{e}", kind="vector", indices=1, components="(a_{i1}, a_{i2}, a_{i3})"),
        Letter(r"\mathbf{A}", kind="matrix", components=r"\|a_{ij}\|"),
        Letter(r"\mathbf{M}", kind="matrix"),
    ]
)
PLAIN = [
    "x",
    "y",
    "z",
    r"\alpha",
    r"\beta",
    r"\lambda",
    r"\bar{k}",
    "h_0",
    "a",
    "b",
    "c",
    "k",
    r"\omega",
    "r",
    r"\theta",
]
INDEXED = ["I_{}", "J_{}", r"\mu_{}", "q_{}"]
RELATIONS = ["=", "=", "=", "<", r"\le", ">", r"\ge", r"\ne"]
FUNCTIONS = [r"\sin", r"\cos", r"\tan", r"\ln", r"\exp", r"\operatorname{arctg}"]


def letter(rng: random.Random) -> str:
    """A letter, with indices or without."""
    kind = rng.random()
    if kind < 0.6:
        return rng.choice(PLAIN)
    if kind < 0.85:
        return rng.choice(INDEXED).format(rng.randint(1, 3))
    return f"{rng.choice('am')}_{{{rng.randint(1, 3)}{rng.randint(1, 3)}}}"


def number(rng: random.Random) -> str:
    return rng.choice([str(rng.randint(2, 30)), str(rng.randint(2, 9)), f"{rng.randint(0, 9)}.{rng.randint(1, 99)}"])


def factor(rng: random.Random, depth: int) -> str:
    """One factor."""
    kind = rng.random()
    if depth <= 0 or kind < 0.35:
        return letter(rng)
    if kind < 0.45:
        return rf"\left({total(rng, depth - 1, 2)}\right)"
    if kind < 0.55:
        return f"{letter(rng)}^{{{rng.randint(2, 5)}}}"
    if kind < 0.63:
        return rf"\frac{{{total(rng, depth - 1)}}}{{{total(rng, depth - 1)}}}"
    if kind < 0.68:
        return rf"\sqrt{{{total(rng, depth - 1)}}}"
    if kind < 0.75:
        return rf"{rng.choice(FUNCTIONS)}\left({total(rng, depth - 1)}\right)"
    if kind < 0.8:
        return rf"{rng.choice(FUNCTIONS[:3])}^2 {rng.choice(PLAIN)}"
    return special(rng, depth - 1)


def special(rng: random.Random, depth: int) -> str:
    """Functions of the notation, derivatives, sums, integrals."""
    inner = total(rng, depth)
    return rng.choice(
        [
            f"f({inner})",
            f"f({inner}, {letter(rng)})",
            f"f'({inner})",
            f"f^2({inner})",
            f"g({inner})",
            f"u({inner}, {letter(rng)})",
            "r(t)",
            r"\dot{r}",
            r"\ddot{\theta}",
            rf"\dot{{q}}_{rng.randint(1, 3)}",
            "e^{c t}",
            r"\frac{dr}{dt}",
            r"\frac{d^2 \theta}{dt^{2}}",
            rf"\frac{{\partial u}}{{\partial {rng.choice('xt')}}}",
            r"\frac{dg(c)}{dc}",
            rf"\left(\frac{{d}}{{dt}} \left(a r^2 + {rng.randint(2, 9)} t\right)\right)",
            rf"\left(\sum_{{i={rng.randint(1, 2)}}}^3 I_i a_{{i{rng.randint(1, 3)}}}\right)",
            rf"\left(\sum_{{n=1}}^{{{rng.randint(3, 4)}}} s_n\right)",
            rf"\left(\int_{{{rng.randint(0, 3)}}}^{{b}} c^2 t \, dt\right)",
            r"\left(\int_0^\infty e^{-t} r \, dt\right)",
            r"\langle \sin t + r \rangle_{t}",
            r"(\mathbf{v}, \mathbf{w})",
            rf"(\mathbf{{w}}, \mathbf{{e}}_{rng.randint(1, 3)})",
            r"|\mathbf{A}|",
            rf"{rng.randint(10, 80)}^\circ",
        ]
    )


def product(rng: random.Random, depth: int) -> str:
    factors = [factor(rng, depth) for _ in range(rng.choice([1, 1, 2, 2, 3]))]
    if rng.random() < 0.4:
        factors.insert(0, number(rng))
    text = factors[0]
    for before, after in itertools.pairwise(factors):
        sign = (
            r" \cdot "
            if after[0].isdigit() or after.startswith((r"\left(", "(", r"\frac")) or before[:1] == "\\"
            else " "
        )
        text += sign + after
    return text


def total(rng: random.Random, depth: int, least: int = 1) -> str:
    """A sum of products."""
    text = rng.choice(["", "", "-"]) + product(rng, depth)
    for _ in range(rng.randint(least - 1, 1)):
        text += rng.choice([" + ", " - "]) + product(rng, depth)
    return text


def relation(rng: random.Random) -> str:
    if rng.random() < 0.08:
        return f"{letter(rng)} = {total(rng, 1)} {rng.choice([chr(92) + 'pm', chr(92) + 'mp'])} {letter(rng)}"
    return f"{total(rng, 2)} {rng.choice(RELATIONS)} {total(rng, 1)}"


def vectors(rng: random.Random) -> str:
    one, other = (rng.choice([r"\mathbf{v}", r"\mathbf{w}", r"\mathbf{e}_1", r"\mathbf{e}_2"]) for _ in range(2))
    return rng.choice(
        [
            rf"{one} \times {other} = \mathbf{{A}} \mathbf{{w}}",
            rf"\mathbf{{M}}^T {one} = {rng.randint(2, 9)} {other}",
            rf"{one} = (x, {rng.randint(1, 9)}, {letter(rng)})",
            rf"\mathbf{{M}} = \begin{{pmatrix}} a & 1 & {rng.randint(2, 9)} \\ 0 & b & x \\ y & z & c \end{{pmatrix}}",
            rf"{one} \ne \pm {other}",
        ]
    )


def formula(rng: random.Random) -> str:
    """A statement."""
    kind, one, other = rng.random(), relation(rng), relation(rng)
    if kind < 0.45:
        return one
    if kind < 0.55:
        return rf"{one}, \quad {other}"
    if kind < 0.6:
        return rf"{one} \qquad {other}"
    if kind < 0.68:
        return (
            rf"{one} {rng.choice([chr(92) + name for name in ('land', 'lor', 'Rightarrow', 'Leftrightarrow')])} {other}"
        )
    if kind < 0.73:
        return rf"\exists x, y : x = {total(rng, 1)} \land {other}"
    if kind < 0.79:
        return rf"{letter(rng)}, {letter(rng)} > {number(rng)}"
    if kind < 0.84:
        return rf"0 < {letter(rng)}, {letter(rng)} < {number(rng)}"
    if kind < 0.9:
        values = rng.choice(["1, 2", "1, 3", "1, 2, 3"])
        return rf"J_i = {rng.randint(2, 9)} I_i + a_{{i{rng.randint(1, 3)}}}, \quad i = {values}"
    return vectors(rng)
