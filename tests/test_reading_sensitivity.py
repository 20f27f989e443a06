"""Reading notices every change that is not layout, and answers any damage with the one error it has."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from reading_samples import NOTATION, SAMPLES, displays

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import lower, read, relations, split_tag
from symcheck.reading.tex import Tok, tokenize

LAYOUT = {r"\quad", r"\,", r"\;", "&", r"\\", r"\left", r"\right", ".", ",", ";", r"\cdot"}
GREEK = {
    r"\alpha": r"\beta",
    r"\beta": r"\gamma",
    r"\gamma": r"\alpha",
    r"\omega": r"\xi",
    r"\xi": r"\pi",
    r"\pi": r"\xi",
}
SWAPS = {
    "+": "-",
    "-": "+",
    "=": "<",
    "^": "_",
    "_": "^",
    "/": "+",
    r"\times": "+",
    r"\leq": r"\geq",
    r"\geq": r"\leq",
    r"\neq": "=",
    r"\lor": r"\land",
    r"\land": r"\lor",
    r"\Rightarrow": r"\Leftrightarrow",
    r"\Leftrightarrow": r"\Rightarrow",
    r"\sin": r"\cos",
    r"\cos": r"\sin",
    r"\max": r"\min",
    r"\mathbf": r"\boldsymbol",
    r"\boldsymbol": r"\mathbf",
    r"\dot": r"\bar",
    r"\bar": r"\dot",
    r"\frac": r"\sqrt",
    r"\pm": r"\mp",
    r"\mp": r"\pm",
    r"\ln": r"\exp",
    r"\exp": r"\ln",
    r"\int": r"\sum",
    **GREEK,
}
LETTERS = "IJakc"


def pieces(latex):
    return (latex,) if isinstance(latex, str) else tuple(latex)


def names_of_environments(tokens: list[Tok]) -> set[int]:
    """The tokens of `\\begin{array}{lll}` and the like, which are layout."""
    found: set[int] = set()
    for k, tok in enumerate(tokens):
        if tok.text in (r"\begin", r"\end"):
            end = next(m for m in range(k, len(tokens)) if tokens[m].text == "}")
            found.update(range(k, end + 1))
    return found


def repeated(tokens: list[Tok], k: int) -> bool:
    """Is this sign printed twice, at both sides of a line break? Then one of the two is layout."""
    skipped = names_of_environments(tokens)
    significant = [m for m, tok in enumerate(tokens) if tok.text not in LAYOUT and m not in skipped]
    place = significant.index(k)
    near = [significant[m] for m in (place - 1, place + 1) if 0 <= m < len(significant)]
    return any(tokens[m].text == tokens[k].text for m in near)


def changes(text: str) -> Iterator[str]:
    """All texts with one token dropped or replaced by one that means something else."""
    tokens = tokenize(text)
    skipped = names_of_environments(tokens)
    for k, tok in enumerate(tokens):
        if k in skipped or tok.text in LAYOUT or (tok.text in ("+", "-", "=", r"\equiv") and repeated(tokens, k)):
            continue
        before, after = text[: tok.at], text[tok.at + len(tok.text) :]
        yield before + after
        if tok.text.isdigit():
            yield from (before + str(digit) + after for digit in range(4) if str(digit) != tok.text)
        elif tok.text.isalpha():
            yield from (before + letter + after for letter in LETTERS if letter != tok.text)
        elif tok.text in SWAPS:
            yield before + SWAPS[tok.text] + " " + after


def unnoticed(latex, notation) -> tuple[list[str], int]:
    """The changes after which the tree is the same, and how many there were."""
    text = r" \\ ".join(split_tag(piece)[0] for piece in pieces(latex))
    tree = read(latex, notation)
    missed, count = [], 0
    for changed in changes(text):
        count += 1
        try:
            other = read(changed, notation)
        except SymcheckError:
            continue
        if other == tree:
            missed.append(changed)
    return missed, count


def test_no_change_of_a_sample_goes_unnoticed():
    total = 0
    for latex in SAMPLES:
        missed, count = unnoticed(latex, NOTATION)
        assert missed == []
        total += count
    assert total > 2000


@pytest.mark.slow
def test_no_change_of_a_display_of_the_paper_goes_unnoticed(sources: Path):
    total = 0
    for latex, notation in displays(sources):
        missed, count = unnoticed(latex, notation)
        assert missed == []
        total += count
    assert total > 10000


SAME = [
    ("J_1 + J_2 = 0", r"J_1 \, + J_{2} = (0)"),
    (r"J_1 \le c", r"J_1 \leqslant c"),
    (r"J_1 \ne c", r"J_1 \neq c"),
    (r"a_{12}^2 = c", r"a^2_{12} = c"),
    (r"\frac{1}{2} c = k", r"\dfrac12 \left( c \right) = k"),
    (r"\bar{k}_1 = c", r"\bar k_1 = c"),
    (r"3c/2 = k", r"\frac{3c}{2} = k"),
]


@pytest.mark.parametrize(("one", "other"), SAME)
def test_layout_makes_no_difference(one, other):
    assert read(one, NOTATION) == read(other, NOTATION)


INSERTED = [*r"{}()[]|\^_'&,;:.=+-/$#%~0i", r"\right", r"\sum", r"\exists", r"\frac", r"\begin", r"\text"]


def damaged(text: str, rng: random.Random) -> str:
    """The text with a few characters dropped, doubled, copied elsewhere, inserted, or cut off."""
    for _ in range(rng.randint(1, 3)):
        at, to = rng.randrange(len(text)), rng.randrange(len(text))
        here, there = text[at : at + 1], text[to : to + 1]
        inserted = rng.choice(["", here, there, rng.choice(INSERTED)])
        text = text[:at] + inserted + text[at + 1 :] if rng.random() < 0.9 else text[:at]
        text = text or "c"
    return text


def test_damage_gives_a_tree_or_the_error_of_the_reader_and_nothing_else():
    rng = random.Random(20)
    refused = 0
    for latex in SAMPLES:
        for _ in range(100):
            texts = [damaged(piece, rng) for piece in pieces(latex)]
            try:
                tree = read(texts, NOTATION)
                if relations(tree):
                    lower(tree, NOTATION)
            except SymcheckError:
                refused += 1
    assert refused > 1000
