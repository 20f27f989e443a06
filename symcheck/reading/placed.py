r"""Brackets with ends behind them, as in `\left[\frac{x^3}{3}\right]_0^1`, beside an integral between the same ends.

The letter of that integral is the one that is at these ends.
"""

from __future__ import annotations

from collections.abc import Sequence

from symcheck.reading import tex

OPENING = {"]": ("[",), "|": (".", "[", "(")}  # what opens brackets that are closed so


def with_places(source: str) -> str:
    """A formula in which what is at two ends says which letter is there."""
    if r"\int" not in source or not any(mark in source for mark in ("]_", "|_")):
        return source
    tokens = [*tex.texts(source)]
    variable = _variable(tokens)
    if variable is None:
        return source
    found = [*tokens]
    for k in range(len(tokens) - 1, 1, -1):
        if tokens[k] != "_" or tokens[k - 1] not in OPENING:
            continue
        start, low, high, end = _opening(tokens, k - 1), *_ends(tokens, k)
        low, high = (each[2:] if each[:2] == [variable, "="] else each for each in (low, high))
        if start is None or not high or not _is_integrated(tokens, low, high):
            continue
        own = start + 2 if tokens[start] == r"\left" else start + 1
        last = k - 2 if tokens[k - 2] == r"\right" else k - 1
        place = [r"\right", "|", "_", "{", variable, "=", *low, "}", "^", "{", *high, "}"]
        found[start:end] = [r"\left", ".", r"\left", "(", *tokens[own:last], r"\right", ")", *place]
        tokens = [*found]
    return tex.compact(" ".join(tokens)) if tokens != [*tex.texts(source)] else source


def _variable(tokens: Sequence[str]) -> str | None:
    """The letter of all integrals; None if there is no such one letter."""
    letters, k = set[str](), 0
    while k < len(tokens):
        if tokens[k] in (r"\frac", r"\dfrac", r"\tfrac"):
            above, middle = _group(tokens, k + 1)
            below, end = _group(tokens, middle)
            if above[:1] == ["d"] and below[:1] == ["d"]:  # a derivative
                k = end
                continue
        if tokens[k] == "d" and k + 1 < len(tokens) and tex.is_letter(tokens[k + 1]):
            letters.add(tokens[k + 1])
        k += 1
    return letters.pop() if len(letters) == 1 else None


def _group(tokens: Sequence[str], start: int) -> tuple[list[str], int]:
    """What stands in the braces at a place, or the token there; and the place behind it."""
    if tokens[start : start + 1] != ["{"]:
        return [*tokens[start : start + 1]], start + 1
    depth = 0
    for k in range(start, len(tokens)):
        depth += (tokens[k] == "{") - (tokens[k] == "}")
        if depth == 0:
            return [*tokens[start + 1 : k]], k + 1
    return [], len(tokens)


def _ends(tokens: Sequence[str], k: int) -> tuple[list[str], list[str], int]:
    """The two ends of which the first is behind the sign at a place, and the place behind both."""
    low, after = _group(tokens, k + 1)
    if tokens[after : after + 1] != ["^"]:
        return low, [], after
    return low, *_group(tokens, after + 1)


def _opening(tokens: Sequence[str], close: int) -> int | None:
    """Where the brackets begin that are closed at a place."""
    sized = tokens[close - 1] == r"\right"
    if tokens[close] == "|" and not sized:
        return None
    depth = 0
    for k in range(close, -1, -1):
        if sized:
            depth += (tokens[k] == r"\right") - (tokens[k] == r"\left") if k < close else 0
            if depth == 0 and k < close - 1:
                return k if tokens[k + 1] in OPENING[tokens[close]] else None
        else:
            depth += (tokens[k] == "]") - (tokens[k] == "[")
            if depth == 0:
                return k
    return None


def _is_integrated(tokens: Sequence[str], low: Sequence[str], high: Sequence[str]) -> bool:
    """Is there an integral between two ends?"""
    for k, token in enumerate(tokens):
        if token == r"\int" and tokens[k + 1 : k + 2] == ["_"] and _ends(tokens, k + 1)[:2] == (low, high):
            return True
    return False
