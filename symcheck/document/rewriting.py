r"""Declared rewriting rules on printed tokens, `X^{T} Y -> (X, Y)`: a relation in a notation that the reader takes.

The letters X, Y and Z stand for a letter with its style and subscript, a group in braces, or a bracket, if they stand
on both sides of the arrow. Everything else stands for itself; braces around one token and spaces do not matter.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from symcheck.core.verdicts import SymcheckError
from symcheck.document.macros import tokens
from symcheck.reading.commands import ARGUMENTS, LETTER_COMMANDS

WILD = ("X", "Y", "Z")
BEHIND = frozenset({"^", "_", "'", "(", "[", r"\left"})  # what would belong to the last letter of a match
BEFORE = frozenset(
    {"=", "+", "-", "<", ">", ",", "(", "[", "&", r"\cdot", r"\times", r"\,"}
)  # no functions of a bracket
CLOSING = {"(": ")", "[": "]"}
_ENDS = CLOSING | {"{": "}"}
Item: TypeAlias = "str | tuple[Item, ...]"  # a token, or a group in braces
Found: TypeAlias = dict[str, tuple[Item, ...]]


@dataclass(frozen=True)
class Rule:
    """What stands for what."""

    text: str
    left: tuple[Item, ...]
    right: tuple[Item, ...]

    @classmethod
    def of(cls, text: str) -> Rule:
        """A rule as it is written; SymcheckError if it is none."""
        left, arrow, right = text.partition("->")
        items = _items(left), _items(right)
        if not arrow or not items[0] or "->" in right:
            raise SymcheckError(f"{text!r} is no rule; write what is printed, ->, and what to read")
        if free := {*_flat(items[1])} & {*WILD} - {*_flat(items[0])}:
            raise SymcheckError(f"{text!r}: {min(free)} stands only behind the arrow; it stands for nothing")
        return cls(text, *items)

    @property
    def wild(self) -> set[str]:
        """The letters that stand for others."""
        return {*_flat(self.left)} & {*_flat(self.right)} & {*WILD}


def rewritten(latex: str, rules: Sequence[Rule]) -> tuple[str, tuple[Rule, ...]]:
    """A formula after all rules, one after the other, and those that applied."""
    items, applied = _items(latex), []
    for rule in rules:
        if (new := _applied(items, rule)) != items:
            items = new
            applied.append(rule)
    return (_written(items) if applied else latex), tuple(applied)


def _items(latex: str) -> tuple[Item, ...]:
    """The tokens without spaces, groups as one; an unbalanced brace stands for itself."""
    stack: list[list[Item]] = [[]]
    for tok in tokens(latex):
        if tok.text == "{":
            stack.append([])
        elif tok.text == "}" and len(stack) > 1:
            group = tuple(stack.pop())
            stack[-1].append(group)
        elif not tok.is_space:
            stack[-1].append(tok.text)
    while len(stack) > 1:
        group = ("{", *stack.pop())
        stack[-1] += group
    return tuple(stack[0])


def _written(items: Sequence[Item]) -> str:
    texts = [f"{{{_written(each)}}}" if isinstance(each, tuple) else each for each in items]
    for k, before in enumerate(texts[:-1]):
        if before in (r"\begin", r"\end"):
            texts[k : k + 2] = ["", before + texts[k + 1].replace(" ", "")]
    return " ".join(filter(None, texts))


def _flat(items: Sequence[Item]) -> Iterator[str]:
    for each in items:
        yield from _flat(each) if isinstance(each, tuple) else (each,)


def _bare(item: Item) -> Item:
    """An item without braces around a single one."""
    while isinstance(item, tuple) and len(item) == 1:
        item = item[0]
    return tuple(map(_bare, item)) if isinstance(item, tuple) else item


def _applied(items: tuple[Item, ...], rule: Rule) -> tuple[Item, ...]:
    """A formula after one rule, from left to right, groups first."""
    inside = [_applied(each, rule) if isinstance(each, tuple) else each for each in items]
    new: list[Item] = []
    k = 0
    while k < len(inside):
        argument = k > 0 and (inside[k - 1] in ("^", "_") or inside[k - 1] in ARGUMENTS)
        found = None if argument and len(rule.left) > 1 else _match(inside, k, rule.left, rule.wild, {})
        if found is None:
            new.append(inside[k])
            k += 1
        else:
            end, values = found
            new += _put(rule.right, values)
            k = end
    return tuple(new)


def _match(
    items: Sequence[Item], k: int, pattern: Sequence[Item], wild: set[str], known: Found
) -> tuple[int, Found] | None:
    """Where a match that begins here ends, and what the letters stand for; None if there is none."""
    for n, part in enumerate(pattern):
        if isinstance(part, str) and part in wild:
            end = _operand(items, k)
            value = tuple(items[k:end])
            last = n == len(pattern) - 1
            if end == k or (last and end < len(items) and items[end] in BEHIND):
                return None
            if known.setdefault(part, value) != value:
                return None
            k = end
        elif k >= len(items):
            return None
        elif isinstance(part, tuple) and {*_flat(part)} & wild:
            inner = items[k] if isinstance(items[k], tuple) else (items[k],)
            found = _match(inner, 0, part, wild, known)
            if found is None or found[0] != len(inner):
                return None
            k += 1
        elif _bare(items[k]) != _bare(part):
            return None
        else:
            k += 1
    return k, known


def _operand(items: Sequence[Item], k: int) -> int:
    """Where what a letter may stand for ends: a letter, a group or a bracket, with its subscript; k if it is none."""
    first = items[k] if k < len(items) else "="
    if isinstance(first, tuple):
        end = k + 1
    elif first in CLOSING:
        end = closed(items, k) if k == 0 or items[k - 1] in BEFORE else k
    elif first in ARGUMENTS:
        end = k + 1 + ARGUMENTS[first]
    else:
        end = k + (first.isalpha() or first in LETTER_COMMANDS)
    return min(end + 2 if k < end < len(items) - 1 and items[end] == "_" else end, len(items))


def closed(items: Sequence[Item], k: int) -> int:
    """The place behind a bracket or brace that opens at k; k if it is never closed."""
    depth = 0
    for end in range(k, len(items)):
        depth += (items[end] == items[k]) - (items[end] == _ENDS[str(items[k])])
        if not depth:
            return end + 1
    return k


def _put(items: Sequence[Item], values: Found) -> list[Item]:
    """What stands behind the arrow, with what the letters stand for."""
    new: list[Item] = []
    for each in items:
        if isinstance(each, tuple):
            new.append(tuple(_put(each, values)))
        else:
            new += values.get(each, (each,))
    return new
