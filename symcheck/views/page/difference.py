"""Two formulas with what differs marked: letter by letter in their MathML, so that no mark can tear a formula."""

from __future__ import annotations

import re
from difflib import SequenceMatcher

# an element of MathML that holds signs: its name, attributes and signs
_LEAF = re.compile(r"<(mi|mn|mo|mtext)\b([^>]*)>([^<]*)</\1>")
_UNSEEN = "\u2061\u200b\u00a0\u22c5 ,;.:"  # differences without meaning: function application, spaces, dots
_KIND = re.compile(r'\s(?:class|lspace|rspace|form|fence|stretchy|separator|style)="[^"]*"')  # attributes of layout


def marked(before: str, after: str) -> tuple[str, str]:
    """The MathML of both, where leaves that the other has not bear the class "del" or "ins".

    >>> marked("<math><mi>a</mi><mo>+</mo></math>", "<math><mi>a</mi><mo>-</mo></math>")[1]
    '<math><mi>a</mi><mo class="ins">-</mo></math>'
    """
    one, other = ([_signs(leaf) for leaf in _LEAF.finditer(math)] for math in (before, after))
    kept: tuple[set[int], set[int]] = (set(), set())
    for block in SequenceMatcher(None, one, other, autojunk=False).get_matching_blocks():
        for side, begin in enumerate((block.a, block.b)):
            kept[side].update(range(begin, begin + block.size))
    return _with_class(before, kept[0], "del"), _with_class(after, kept[1], "ins")


def _signs(leaf: re.Match[str]) -> tuple[str, str]:
    """What a leaf says: its text and, for a letter, whether it is bold or upright."""
    return leaf[3], _KIND.sub("", leaf[2])


def _with_class(math: str, kept: set[int], name: str) -> str:
    numbers = iter(range(len(math)))

    def changed(leaf: re.Match[str]) -> str:
        if next(numbers) in kept or not leaf[3].strip(_UNSEEN):
            return leaf[0]
        rest = re.sub(r'\sclass="([^"]*)"', "", leaf[2])
        had = re.search(r'class="([^"]*)"', leaf[2])
        classes = f"{had[1]} {name}" if had else name
        return f'<{leaf[1]} class="{classes}"{rest}>{leaf[3]}</{leaf[1]}>'

    return _LEAF.sub(changed, math)
