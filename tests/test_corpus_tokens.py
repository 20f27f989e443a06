"""Displays of public repositories: every token of what is stated counts, and what is printed back reads the same."""

from __future__ import annotations

import json
import os
import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import Tree, lower, read, tex, to_latex
from symcheck.reading.inference import inferred
from symcheck.reading.lexer import layout
from symcheck.reading.notation import Notation
from symcheck.reading.surface import NOTHING, plain, with_plain_differentials

CORPUS = Path(os.environ.get("SYMCHECK_SOURCES", "/nowhere")).parent / "corpus" / "formulas.jsonl"
SEED, SAMPLE = 20260, 300  # the displays that are looked at; all of them take three minutes
MOST_READINGS = 4  # as in the measurement of the whole corpus
LETTERS, GREEK = "kwzQ", (r"\chi", r"\kappa", r"\upsilon")
OTHERS = {"+": "-", "-": "+", "=": "<", "<": ">", ">": "<", r"\sin": r"\cos", r"\cos": r"\sin", r"\le": r"\ge"}
OTHERS |= {r"\ge": r"\le", r"\times": "+", "/": "+", r"\exp": r"\ln", r"\ln": r"\exp", r"\tan": r"\cot"}
UNSEEN = frozenset({r"\label", r"\tag", r"\hspace", r"\vspace", r"\color", r"\begin", r"\end", *NOTHING})

pytestmark = [pytest.mark.slow, pytest.mark.skipif(not CORPUS.exists(), reason="the displays are not here")]


def stated(latex: str) -> tuple[Tree, Notation, str]:
    """The first likely reading that states something; SymcheckError if none does."""
    text = with_plain_differentials(plain(latex))
    errors = [SymcheckError("no reading")]
    for inference in [each for each in inferred([text], {}, {}) if not each.remote][:MOST_READINGS]:
        try:
            tree = read(text, inference.notation)
            return tree, inference.notation, repr(lower(tree, inference.notation))
        except SymcheckError as error:
            errors.append(error)
    raise errors[-1]


def sample() -> list[str]:
    rows = [json.loads(line)["tex"] for line in CORPUS.read_text(encoding="utf-8").splitlines()]
    return random.Random(SEED).sample(sorted({row for row in rows if len(row) < 200}), SAMPLE)


def unseen(latex: str) -> set[int]:
    """The places of tokens that print nothing: layout, and the arguments of commands of layout."""
    toks, found = tex.tokenize(latex), layout(latex)
    for k, tok in enumerate(toks):
        if tok.text in UNSEEN and k + 1 < len(toks) and toks[k + 1].text == "{":
            end = next((m for m in range(k, len(toks)) if toks[m].text == "}"), k)
            found |= {each.at for each in toks[k : end + 1]}
        elif tok.text in (r"\underbrace", r"\overbrace"):
            body = closing(latex, k + 1)
            note = closing(latex, body + 2) if toks[body + 1].text in ("_", "^") else body
            found |= {each.at for each in toks[body : note + 1]}
    for space in re.finditer(r"\\\\\s*\[[^\]]*\]", latex):
        found |= set(range(*space.span()))
    return found


def closing(latex: str, k: int) -> int:
    """The number of the token that closes the brace that is token k."""
    depth = 0
    for m, tok in enumerate(tex.tokenize(latex)):
        depth += ((tok.text == "{") - (tok.text == "}")) * (m >= k)
        if m >= k and not depth:
            return m
    return k


def changes(latex: str) -> Iterator[tuple[str, str]]:
    """The formula with one token replaced by another, and the token."""
    kept = unseen(latex)
    for tok in tex.tokenize(latex):
        if tok.at in kept:
            continue
        if tok.text in OTHERS:
            new = OTHERS[tok.text]
        elif tok.text.isdigit():
            new = str((int(tok.text) + 3) % 10)
        elif len(tok.text) == 1 and tok.text.isalpha():
            new = next(letter for letter in LETTERS if letter not in latex)
        elif tok.text in tex.LETTER_COMMANDS:
            new = next(letter for letter in GREEK if letter not in latex)
        else:
            continue
        yield f"{latex[: tok.at]}{new} {latex[tok.at + len(tok.text) :]}", f"{tok.text} at {tok.at}"


@pytest.mark.parametrize("latex", sample() if CORPUS.exists() else [])
def test_every_token_of_a_stated_display_counts(latex: str) -> None:
    try:
        _, _, statement = stated(latex)
    except SymcheckError:
        pytest.skip("nothing is stated")
    unnoticed = []
    for changed, token in changes(latex):
        try:
            if stated(changed)[2] == statement:
                unnoticed.append(token)
        except SymcheckError:
            continue
    assert not unnoticed


@pytest.mark.parametrize("latex", sample() if CORPUS.exists() else [])
def test_a_display_printed_back_reads_as_the_same_tree(latex: str) -> None:
    try:
        tree, notation, _ = stated(latex)
    except SymcheckError:
        pytest.skip("nothing is stated")
    assert read(to_latex(tree), notation) == tree
