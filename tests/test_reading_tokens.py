"""Every token counts: a formula with one token changed says something else or is refused, unless it is layout."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import cache

import pytest
from declarations import formulas, hypotheses
from formula_grammar import GENERATED, formula

from symcheck import papers
from symcheck.audit import expand
from symcheck.core.verdicts import SymcheckError
from symcheck.reading import Notation, layout, lower, read, relations, split_tag
from symcheck.reading.tex import Tok, tokenize

DIGITS = "0123456789"
GREEK = (r"\alpha", r"\beta", r"\gamma", r"\psi", r"\theta", r"\omega", r"\Omega", r"\lambda", r"\pi", r"\Delta")
KINDS = (
    ("+", "-", r"\pm", r"\mp"),
    ("=", "<", ">", r"\le", r"\ge", r"\ne", r"\in", r"\approx"),
    ("^", "_"),
    ("/", r"\times", "+"),
    (r"\lor", r"\land", r"\Rightarrow", r"\Leftrightarrow"),
    (r"\sin", r"\cos", r"\tan", r"\ln", r"\exp", r"\arctan", r"\max", r"\tanh"),
    (r"\mathbf", r"\boldsymbol", r"\mathcal", r"\mathrm"),
    (r"\dot", r"\ddot", r"\bar", r"\tilde"),
    (r"\frac", r"\sqrt"),
    (r"\int", r"\sum", r"\prod"),
    (r"\partial", "d"),
    ("'", "''"),
    (r"\infty", "1"),
    (r"\circ", "T"),
    GREEK,
)
ALIKE = {
    text: tuple(other for kind in KINDS if text in kind for other in kind if other != text)
    for kind in KINDS
    for text in kind
}


def said(latex: str, notation: Notation) -> object:
    """What a formula states: its formulas, or what is printed where it is an expression or a list of names."""
    tree = read(latex, notation)
    return lower(tree, notation) if relations(tree) else tree


def others(tok: Tok, letters: list[str], rng: random.Random) -> Iterator[str]:
    """What may stand for a token: nothing, another of its kind, itself twice."""
    yield ""
    if tok.text in DIGITS:
        yield from rng.sample([digit for digit in DIGITS if digit != tok.text], 3)
    elif tok.text.isalpha():
        yield from rng.sample([letter for letter in letters if letter != tok.text], 3)
    yield from ALIKE.get(tok.text, ())


def changes(text: str, rng: random.Random) -> Iterator[tuple[str, tuple[str, str]]]:
    """The text with one token dropped or replaced, or exchanged with the next; and the two tokens."""
    tokens, idle = tokenize(text), layout(text)
    letters = sorted({tok.text for tok in tokens if tok.text.isalpha()} | set("abknxyzJ"))
    counting = [tok for tok in tokens if tok.at not in idle and tok.text not in ("{", "}")]
    for tok, after in zip(counting, [*counting[1:], None], strict=True):
        before, behind = text[: tok.at], text[tok.at + len(tok.text) :]
        for other in others(tok, letters, rng):
            yield f"{before} {other} {behind}", (tok.text, other)
        if after is not None and after.text != tok.text and after.text.isalnum() and tok.text.isalnum():
            between = text[tok.at + len(tok.text) : after.at]
            exchanged = f"{before}{after.text}{between}{tok.text}{text[after.at + len(after.text) :]}"
            yield exchanged, (tok.text, after.text)


def unnoticed(latex: str, notation: Notation, rng: random.Random, most: int) -> tuple[list[str], int]:
    """The changes after which the statement is the same, and how many were tried; none of what says nothing itself."""
    try:
        right = said(latex, notation)
    except SymcheckError:
        return [], 0
    tried = list(changes(latex, rng))
    missed = []
    for changed, tokens in rng.sample(tried, min(most, len(tried))):
        try:
            if said(changed, notation) == right and not means_the_same(*tokens, notation):
                missed.append(changed)
        except SymcheckError:
            continue
    return missed, min(most, len(tried))


def means_the_same(one: str, other: str, notation: Notation) -> bool:
    """A free index is every value under any name; an equality may be a rounding where the notation says so."""
    indices = [notation.index(one), notation.index(other)]
    renamed = all(indices) and len({index.range for index in indices if index}) == 1
    return renamed or (notation.decimals == "rounded" and {one, other} == {"=", r"\approx"})


@cache
def accepted(key: str) -> tuple[tuple[str, Notation], ...]:
    """Every formula of a paper with its notation: printed, formal, corrected, and its hypotheses."""
    found: dict[tuple[str, Notation], None] = {}
    paper = papers.load()[key]
    for item in (obligation.item for obligation in expand(paper)):
        notation = item.notation or paper.notation
        given = [each.states for each in hypotheses(item)]
        printed = r" \\ ".join(split_tag(piece)[0] for piece in item.source.printed)
        texts = [printed, *formulas(item)[len(item.source.printed) :], *given]
        found |= dict.fromkeys((text, notation) for text in texts if text)
    return tuple(found)


def lost(formulas: list[tuple[str, Notation]], seed: int, most: int) -> tuple[list[tuple[str, str]], int]:
    """What goes unnoticed in these formulas, and the number of changes tried."""
    rng, found, total = random.Random(seed), [], 0
    for text, notation in formulas:
        missed, count = unnoticed(text, notation, rng, most)
        found += [(text, changed) for changed in missed]
        total += count
    return found, total


@pytest.mark.parametrize("key", papers.load())
def test_every_token_of_a_sample_of_each_paper_counts(key: str) -> None:
    formulas = random.Random(7).sample(accepted(key), 30)
    found, total = lost(formulas, 7, 25)
    assert found == []
    assert total > 300


@pytest.mark.slow
@pytest.mark.parametrize("key", papers.load())
def test_every_token_of_every_paper_counts(key: str) -> None:
    found, total = lost(list(accepted(key)), 11, 40)
    assert found == []
    assert total > 3000


def test_every_token_of_generated_formulas_counts() -> None:
    rng = random.Random(3)
    found, total = lost([(formula(rng), GENERATED) for _ in range(120)], 3, 25)
    assert found == []
    assert total > 1500


@pytest.mark.slow
def test_every_token_of_many_generated_formulas_counts() -> None:
    rng = random.Random(5)
    found, total = lost([(formula(rng), GENERATED) for _ in range(3000)], 5, 40)
    assert found == []
    assert total > 50_000


def test_most_generated_formulas_are_read() -> None:
    rng = random.Random(4)
    read_, count = 0, 400
    for _ in range(count):
        try:
            said(formula(rng), GENERATED)
            read_ += 1
        except SymcheckError:
            continue
    assert read_ > count // 2
