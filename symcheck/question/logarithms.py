r"""Logarithms to any base as what they are: \log_a x as \frac{\ln x}{\ln a}, before anything is read."""

from __future__ import annotations

from collections.abc import Sequence

from symcheck.reading import tex
from symcheck.reading.lexer import BASES

OPEN, CLOSE = ("{", "(", "["), ("}", ")", "]")
# behind an argument without brackets, which ends there for certain
ENDS = frozenset(
    {"", "+", "-", "=", "<", ">", ",", ";", ".", "&", r"\\", "}", ")", "]", "|", r"\right", r"\cdot", r"\log", r"\ln"}
    | {r"\le", r"\ge", r"\leq", r"\geq", r"\ne", r"\neq", r"\approx", r"\quad"}
)
_NUMBER = frozenset("0123456789.")
PLACES = {r"\frac": 2, r"\tfrac": 2, r"\dfrac": 2, r"\sqrt": 1}  # groups behind a command that may be an argument


def with_natural_logarithms(latex: str) -> str:
    r"""The same with quotients of natural logarithms; what is no letter, fraction or bracket behind \log_a is left."""
    if r"\log" not in latex:
        return latex
    tokens = tokens_of(latex)
    begun: int | None = None  # where the one behind begins that was written last
    for k in reversed(range(len(tokens))):
        if tokens[k] == r"\log" and tokens[k + 1 : k + 2] == ["_"]:
            base = group_end(tokens, k + 2)
            below = _bare(tokens[k + 2 : base])
            end = _argument_end(tokens, base, begun)
            if below and end and "".join(below) not in BASES:
                of = _bracketed(tokens[base:end])
                begun = k
                tokens[k:end] = [r"\frac", "{", r"\ln", *of, "}", "{", r"\ln", *_bracketed(below), "}"]
    return " ".join(tokens) if begun is not None else latex


def tokens_of(latex: str) -> list[str]:
    """The tokens without spaces, each number as one."""
    found, behind = list[str](), -1
    for token in tex.tokenize(latex):
        if found and token.at == behind and token.text in _NUMBER and found[-1][-1] in _NUMBER:
            found[-1] += token.text
        elif token.text.strip():
            found.append(token.text)
        behind = token.at + len(token.text)
    return found


def group_end(tokens: Sequence[str], start: int) -> int:
    """Where a token, or a group in brackets, that begins there is over; behind all of them if it is not closed."""
    depth = 0
    for k in range(start, len(tokens)):
        depth += (tokens[k] in OPEN) - (tokens[k] in CLOSE)
        if depth <= 0:
            return k + 1
    return len(tokens) + 1


def _argument_end(tokens: Sequence[str], start: int, next_: int | None) -> int:
    """Where the argument is over; 0 where that is open. Where the next logarithm begins it is over."""
    first = tokens[start] if start < len(tokens) else ""
    if first == r"\left" or first == "(":
        end = group_end(tokens, start + (first == r"\left"))
        return end if tokens[end : end + 1] != ["^"] and end <= len(tokens) else 0
    if not (first[:1].isalnum() or tex.is_letter(first) or first in PLACES):
        return 0
    end = start + 1
    for _ in range(PLACES.get(first, 0)):
        end = group_end(tokens, end)
    while end < len(tokens) and tokens[end] in ("_", "^"):
        end = group_end(tokens, end + 1)
    return end if end == next_ or (tokens[end] if end < len(tokens) else "") in ENDS else 0


def _bare(tokens: list[str]) -> list[str]:
    return tokens[1:-1] if tokens[:1] == ["{"] else tokens


def _bracketed(tokens: list[str]) -> list[str]:
    return tokens if tokens[:1] in (["("], [r"\left"]) else [r"\left", "(", *tokens, r"\right", ")"]
