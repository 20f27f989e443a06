r"""Floors and ceilings as whole numbers: for \lfloor x\rfloor stands a letter F, of which F \le x < F + 1 is known.

Of two whole numbers, one is not greater if it is less than the other and one more. That step is no part of the
certificates, as the step of an induction is none.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from math import ceil, floor
from string import ascii_uppercase

from symcheck.core.calculus import letters, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Relation, Term, node
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.logarithms import tokens_of
from symcheck.question.prepare import Asked
from symcheck.reading import tex

SIGNS = {r"\lfloor": r"\rfloor", r"\lceil": r"\rceil"}
SIZES = frozenset({r"\left", r"\right", r"\bigl", r"\bigr", r"\big", r"\Bigl", r"\Bigr"})
# operators that bind a letter, which no condition can be about, and signs of derivatives
_BINDING = re.compile(r"\\(?:sum|prod|i+nt|oint|lim|partial|d?dot|forall|exists)(?![a-z])|\\d?frac\s*\{\s*d|'|\\prime")
# a letter that is said to be a whole number
_WHOLE = re.compile(r"\s*(\\?[A-Za-z]+)\s*\\in\s*\\mathbb\s*\{?\s*[ZN]")
_ORDERS = {r"\le": r"\le", r"\leq": r"\le", r"\ge": r"\ge", r"\geq": r"\ge", "=": "="}
_PLAIN = frozenset({"+", "-", "(", ")", r"\cdot", r"\left", r"\right"})  # make whole numbers of whole numbers


POINTS = 40  # at which it is looked for a counterexample: what is false mostly fails at one of the first
USUALLY_WHOLE = frozenset("ijklmn")  # letters that hardly anybody gives other values beside floors
WHOLE: tuple[Term, ...] = (1, 2, 3, 5, -1, -2)
ANY: tuple[Term, ...] = (
    *(node("/", n, d) for n, d in ((1, 2), (3, 2), (-1, 2), (7, 3), (-5, 4), (9, 4), (-8, 3))),
    2,
    -1,
)


@dataclass(frozen=True)
class Whole:
    """A question with letters for floors and ceilings, and what each of them stands for."""

    asked: Asked
    stand: Mapping[str, str]
    whole: frozenset[str]  # all letters that are whole numbers

    @property
    def sides(self) -> tuple[list[str], str, list[str]] | None:
        """The tokens of both sides with the sign between them; None where there are several, or another one."""
        tokens = tokens_of(self.asked.relation)
        places = [k for k, text in enumerate(tokens) if text in {*_ORDERS, "<", ">", r"\ne", r"\neq", r"\approx"}]
        if len(places) != 1 or tokens[places[0]] not in _ORDERS:
            return None
        return tokens[: places[0]], _ORDERS[tokens[places[0]]], tokens[places[0] + 1 :]

    def points(self, problem: Problem) -> Iterator[dict[str, Term]]:
        """Numbers for all letters of a problem that it is read as, with those that floors and ceilings have there."""
        every = (f for _, formulas in problem.hypotheses for f in formulas)
        bounds = [f.terms for f in every if isinstance(f, Relation) and f.tag == "<="]
        inner = {x: [t for pair in bounds if x in pair for t in pair if t != x] for x in self.stand}
        free = sorted(letters(node("and", problem.claim, *(f for _, fs in problem.hypotheses for f in fs))) - {*inner})
        rng = random.Random(1)
        for _ in range(POINTS):
            point: dict[str, Term] = {
                x: rng.choice(WHOLE if x in self.whole | USUALLY_WHOLE else ANY)
                for x in free
                if x not in dict(problem.definitions)
            }
            for x, latex in self.stand.items():
                values = (number_of(substituted(t, point)) for t in inner[x] if letters(t) <= point.keys())
                value = next((v for v in values if v is not None), None)
                if value is None:
                    break
                point[x] = floor(value) if latex.startswith(r"\lfloor") else ceil(value)
            else:
                yield point

    def sharper(self) -> Iterator[Asked]:
        """What shows the relation, if both sides are whole numbers."""
        if (found := self.sides) is None or not all(self._is_whole(side) for side in (found[0], found[2])):
            return
        left, right = (" ".join(side) for side in (found[0], found[2]))
        if found[1] in ("=", r"\le"):
            yield replace(self.asked, relation=f"{left} < {right} + 1")
        if found[1] in ("=", r"\ge"):
            yield replace(self.asked, relation=f"{right} < {left} + 1")

    def _is_whole(self, side: list[str]) -> bool:
        return all(text in self.whole or text.isdigit() or text in _PLAIN for text in side)

    def is_of_all(self) -> bool:
        """Whether the same letters stand on both sides, so that it is no equation to be solved, and no list of them."""
        if (found := self.sides) is None:
            return re.search(r"\\q?quad(?![A-Za-z])|\\\\|,", self.asked.relation) is None
        own = [
            {x for text in side for x in tex.texts(self.stand.get(text, text)) if tex.is_letter(x)}
            for side in (found[0], found[2])
        ]
        return own[0] == own[1]


def with_whole_numbers(asked: Asked) -> Whole | None:
    """The same with letters for floors and ceilings; None where there are none, or where one is of a bound letter."""
    texts = (asked.relation, *asked.given)
    if not any(sign in text for sign in SIGNS for text in texts):
        return None
    if any(map(_BINDING.search, texts)) or any(sign in text for sign in SIGNS for text in asked.where):
        return None
    every = " ".join((*texts, *asked.where, *(x for x, _ in asked.letters)))
    free = iter([x for x in "FGHKLMNQ" + ascii_uppercase if x not in every])
    stand, written, given = dict[str, str](), dict[str, str](), list[str]()

    def lettered(text: str) -> str | None:
        tokens = tokens_of(text)
        while (start := max((k for k, each in enumerate(tokens) if each in SIGNS), default=None)) is not None:
            opened = tokens[start]
            end = next((k for k in range(start, len(tokens)) if tokens[k] == SIGNS[opened]), None)
            if end is None:
                return None
            inner = tokens[start + 1 : end - (tokens[end - 1] in SIZES)]
            of = " ".join(inner)
            key = f"{opened} {of} {SIGNS[opened]}"
            if key not in written:
                if (letter := next(free, None)) is None:
                    return None
                written[key] = letter
                stand[letter] = " ".join((opened, *(stand.get(x, x) for x in inner), SIGNS[opened]))
                low, high = (letter, of) if opened == r"\lfloor" else (of, letter)
                given.extend((rf"{low} \le {high}", f"{high} < {low} + 1"))
            first = start - (start > 0 and tokens[start - 1] in SIZES)
            tokens[first : end + 1] = [written[key]]
        return " ".join(tokens)

    relation, *conditions = (lettered(text) if any(sign in text for sign in SIGNS) else text for text in texts)
    if relation is None or None in conditions or not stand:
        return None
    said = dict.fromkeys(stand, "integer")
    whole = {found[1] for text in asked.given if (found := _WHOLE.match(text))}
    whole |= {x for x, phrase in asked.letters if phrase in ("integer", "an integer")}
    more = (*filter(None, conditions), *given)
    new = replace(asked, relation=relation, given=more, letters=(*asked.letters, *said.items()))
    return Whole(new, stand, frozenset({*stand, *whole}))
