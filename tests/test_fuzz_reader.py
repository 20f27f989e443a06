"""Whatever string the reader gets, it gives a tree or one clean error with a position."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from functools import cache

import pytest
from formula_grammar import GENERATED, formula
from limits import Hung, little_memory, within_a_second

from symcheck import papers
from symcheck.audit import expand
from symcheck.core.verdicts import SymcheckError
from symcheck.reading import Notation, lower, read, relations

FEW, MANY = 3_000, 100_000
CHARACTERS = [*r"{}()[]|\^_'&,;:.=+-/$#%~<>!?@*0123456789abxyzIJ", "\x00", "\n", "\ufeff", "α", "Ж", "𝕏", "²", "\u202e"]
COMMANDS = [
    *(r"\frac", r"\sqrt", r"\sum_{i=1}^3", r"\int_0^1", r"\left(", r"\right)", r"\begin{aligned}", r"\end{aligned}"),
    *(r"\begin{pmatrix}", r"\end{pmatrix}", r"\exists", r"\Rightarrow", r"\Leftrightarrow", r"\langle", r"\rangle"),
    *(r"\sin", r"\dot", r"\bar{", r"\mathbf{e}_", r"\operatorname{diag}", r"\text{", r"\\", r"\quad", r"\le", r"\in"),
    *("999999999999999999999999", "^{99}", "_{", "^{", "{{{{{{{{", "((((((((", "}" * 8, "0.0000001", r"\pm", r"\mp"),
]
POSITION = re.compile(r"(column|position|character|at the end|\n *\^| at )")


@cache
def printed(key: str) -> list[str]:
    """Every printed piece of LaTeX of a paper."""
    items = [obligation.item for obligation in expand(papers.load()[key])]
    return [piece for item in items for piece in (*item.source.printed, *item.stated)]


def invented(rng: random.Random, key: str) -> str:
    """Commands and characters in any order."""
    return "".join(rng.choice(COMMANDS if rng.random() < 0.4 else CHARACTERS) for _ in range(rng.randint(0, 40)))


def mutated(rng: random.Random, key: str) -> str:
    """A printed formula with a few places dropped, doubled, exchanged, cut off, or filled with rubbish."""
    text = rng.choice(printed(key))
    for _ in range(rng.randint(1, 6)):
        at, to = sorted((rng.randrange(len(text) + 1), rng.randrange(len(text) + 1)))
        middle = rng.choice(["", text[at:to] * 2, rng.choice(COMMANDS), rng.choice(CHARACTERS), text[at:to][::-1]])
        text = text[:at] + middle + (text[to:] if rng.random() < 0.95 else "")
        text = text[:4000]
    return text


def spliced(rng: random.Random, key: str) -> str:
    """The beginning of one formula and the end of another."""
    one, other = rng.choice(printed(key)), rng.choice(printed(key))
    return one[: rng.randrange(len(one) + 1)] + other[rng.randrange(len(other) + 1) :]


def made(rng: random.Random, key: str) -> str:
    """A formula of a grammar, with functions, derivatives and lists, and a few places changed."""
    text = formula(rng)
    for _ in range(rng.randint(0, 3)):
        at = rng.randrange(len(text))
        text = (
            text[:at] + rng.choice(["", rng.choice(COMMANDS), rng.choice(CHARACTERS)]) + text[at + rng.randint(0, 2) :]
        )
    return text


BRACKETS = [("(", ")"), ("{", "}"), (r"\sqrt{", "}"), ("-", ""), (r"\frac{1}{", "}"), ("p^{", "}")]


def nested(rng: random.Random, key: str) -> str:
    """One thing inside itself, up to thousands of times."""
    opening, closing = rng.choice(BRACKETS)
    depth = rng.choice([5, 50, 500, 3000])
    return opening * depth + rng.choice(["x", "1", ""]) + closing * rng.choice([depth, depth - 1])


SOURCES: dict[str, Callable[[random.Random, str], str]] = {
    each.__name__: each for each in (invented, mutated, spliced, made, nested)
}
SHARES = {"invented": 25, "mutated": 40, "spliced": 19, "made": 15, "nested": 1}


def outcome(text: str, notation: Notation) -> str | None:
    """What is wrong with how the reader takes a string; None if it reads it or refuses it cleanly.

    What cannot be read has a place; what is read and means nothing is quoted.
    """
    tree = None
    try:
        with within_a_second():
            tree = read(text, notation)
            if relations(tree):
                lower(tree, notation)
    except SymcheckError as error:
        told = str(error)
        placed = POSITION.search(told) or "empty formula" in told or tree is not None
        return None if placed else f"an error without a place: {told}"
    except Hung:
        return "a hang"
    except BaseException as error:
        return f"{type(error).__name__}: {error}"
    return None


def fed(count: int, seed: int) -> list[tuple[str, str, str]]:
    """All strings that the reader does not take well."""
    rng, keys, bad = random.Random(seed), list(papers.load()), []
    names, weights = list(SHARES), list(SHARES.values())
    for _ in range(count):
        key, name = rng.choice(keys), rng.choices(names, weights)[0]
        text = SOURCES[name](rng, key)
        if wrong := outcome(text, GENERATED if name == "made" else papers.load()[key].notation):
            bad.append((wrong, key, text[:300]))
    return bad


def test_rubbish_is_read_or_refused_in_words() -> None:
    with little_memory():
        assert fed(FEW, seed=1) == []


@pytest.mark.slow
@pytest.mark.parametrize("part", range(4))
def test_a_hundred_thousand_strings_are_read_or_refused_in_words(part: int) -> None:
    with little_memory():
        assert fed(MANY // 4, seed=100 + part) == []


@pytest.mark.parametrize("text", ["x = ", r"\frac{1}{", "a + * b", r"\unknown = 1", "((x)", r"J_1 = \left( I_1"])
def test_a_refusal_names_the_place(text: str) -> None:
    with pytest.raises(SymcheckError) as error:
        read(text, papers.load()["mirer2009"].notation)
    assert POSITION.search(str(error.value)), str(error.value)
