r"""Functions that print names and that others say what they are: B(x, y) by gamma functions, \zeta(4) as a sum.

What is proved of the function that usually has a letter is proved; what is false of it is only so if somebody says that
it is meant, or its name, in upright letters, does.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from symcheck.question.logarithms import group_end, tokens_of
from symcheck.question.prepare import Asked
from symcheck.reading import tex

BETA, ZETA = "beta function", "Riemann zeta function"
PHRASES = {BETA: BETA, ZETA: ZETA, "zeta function": ZETA}
USUAL = {"B": BETA, r"\zeta": ZETA}
UPRIGHT = (("\\mathrm", "{", "B", "}"), ("\\operatorname", "{", "B", "}"), ("\\Beta",))
SIZES = frozenset({r"\left", r"\bigl", r"\big", r"\Bigl", r"\biggl"})
ENDS = frozenset({r"\right", r"\bigr", r"\big", r"\Bigr", r"\biggr"})
INDICES = "kjmnilpq"


@dataclass(frozen=True)
class Named:
    """A question without the names, whether these are said to be what they are taken for, and what that is."""

    asked: Asked
    sure: bool
    told: Mapping[str, str]


def said(letters: Mapping[str, str]) -> dict[str, str]:
    """The letters that are said to be such functions, with the names of these."""
    found = {}
    for letter, phrase in letters.items():
        plain = phrase.strip().removeprefix("the ").removeprefix("a ")
        if plain in PHRASES:
            found[letter] = PHRASES[plain]
    return found


def written_out(asked: Asked, declared: Mapping[str, str]) -> Named | None:
    """The same without the names of such functions; None where there are none, or a letter has another meaning."""
    heads: dict[tuple[str, ...], str] = {(x,): name for x, name in {**USUAL, **declared}.items()}
    taken = {x for x, _ in asked.letters}
    texts = (asked.relation, *asked.where, *asked.given)
    if not any(head[-1].strip("\\") in text for head in heads for text in texts) and "Beta" not in " ".join(texts):
        return None
    rows = [tokens_of(text) for text in texts]
    every = {text for row in rows for text in row} | taken
    told, sure = dict[str, str](), True
    for head, name in heads.items():
        plain = [x for row in rows for x in _elsewhere(row, head, name)]
        defined = any(row[:1] == [*head] for row in rows[1:])
        if (head[0] in taken or plain or defined) and head[0] in every:
            return None
        if any(_places(row, (head,), name) for row in rows):
            told[head[0]] = f"the {name} ({'said so' if head[0] in declared else 'its usual letter'})"
            closed = name == ZETA and not any(tex.is_letter(x) for x in every - {r"\zeta", r"\pi"})
            sure = sure and (head[0] in declared or closed)
    every_head = {**dict.fromkeys(UPRIGHT, BETA), **heads}
    index = next((x for x in INDICES if x not in every), "")
    new = [_without(row, every_head, index) for row in rows]
    if new == rows or not index:
        return None
    relation, *others = (" ".join(row) if row != old else text for row, old, text in zip(new, rows, texts, strict=True))
    where, given = tuple(others[: len(asked.where)]), tuple(others[len(asked.where) :])
    return Named(replace(asked, relation=relation, where=where, given=given), sure, told)


def _elsewhere(row: Sequence[str], head: tuple[str, ...], name: str) -> Iterator[str]:
    """A letter wherever it is no such function of arguments."""
    places = {k for k, _, _ in _places(row, (head,), name)}
    upright = {
        k + len(u) - 2 for u in UPRIGHT if len(u) > 1 for k in range(len(row)) if tuple(row[k : k + len(u)]) == u
    }
    yield from (x for k, x in enumerate(row) if (x,) == head and k not in places | upright)


def arguments(row: Sequence[str], start: int) -> tuple[int, list[list[str]], list[str]] | None:
    """What stands in the bracket that opens there: where it is over, the arguments, the signs between them."""
    k = start + (start < len(row) and row[start] in SIZES)
    if k >= len(row) or row[k] not in ("(", "["):
        return None
    end = group_end(row, k)
    if end > len(row):
        return None
    inside = [*row[k + 1 : end - 1]]
    if inside and inside[-1] in ENDS:
        inside.pop()
    parts, signs, depth = [list[str]()], list[str](), 0
    for x in inside:
        depth += (x in ("{", "(", "[")) - (x in ("}", ")", "]"))
        if x in (",", ";") and depth == 0:
            signs.append(x)
            parts.append([])
        else:
            parts[-1].append(x)
    return (end, parts, signs) if all(parts) else None


def _places(row: Sequence[str], heads: Sequence[tuple[str, ...]], name: str) -> list[tuple[int, int, list[list[str]]]]:
    """Where one of the names stands with arguments that fit."""
    found = []
    for k in range(len(row)):
        head = next((each for each in heads if tuple(row[k : k + len(each)]) == each), None)
        if head is None or (
            k
            and row[k - 1] in ("{", "\\mathrm")
            and len(head) == 1
            and row[k - 2 : k - 1] in (["\\mathrm"], ["\\operatorname"])
        ):
            continue
        call = arguments(row, k + len(head))
        if call is not None and _fits(call[1], call[2], name):
            found.append((k, call[0], call[1]))
    return found


def _fits(parts: Sequence[Sequence[str]], signs: Sequence[str], name: str) -> bool:
    if name == BETA:
        return [*signs] == [","]
    return len(parts) == 1 and len(parts[0]) == 1 and parts[0][0].isdigit() and int(parts[0][0]) > 1


def _without(row: list[str], heads: Mapping[tuple[str, ...], str], index: str) -> list[str]:
    """The same with what the functions are, from the last one on, as one may stand in another."""
    row = [*row]
    while True:
        found = [(*place, name) for head, name in heads.items() for place in _places(row, (head,), name)]
        if not found:
            return row
        start, end, parts, name = max(found, key=lambda each: each[0])
        if name == BETA:
            x, y = parts
            gammas = ["{", r"\Gamma", "(", *x, ")", r"\Gamma", "(", *y, ")", "}"]
            new = [r"\frac", *gammas, "{", r"\Gamma", "(", *x, "+", *y, ")", "}"]
        else:
            above = ["_", "{", index, "=", "1", "}", "^", r"\infty"]
            new = [r"\left", "(", r"\sum", *above, r"\frac", "1", "{", index, "^", *parts[0], "}", r"\right", ")"]
        row[start:end] = new
