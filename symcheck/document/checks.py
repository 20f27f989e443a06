"""What can be asked of a document without knowing more than it prints: questions with definitions and conditions."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from symcheck.document.letters import Letter, said
from symcheck.document.printed import Printed
from symcheck.document.survey import Link, Seen
from symcheck.question import Answer, Status
from symcheck.question.ask import answered
from symcheck.question.limit import OutOfTime, limited

# words before a formula that make it a condition, an equation to be solved, or a case, and no statement
CONDITIONAL = re.compile(
    r"\b(if|when|whenever|unless|suppos\w*|assum\w*|such that|so that|solv\w*|requir\w*|condition\w*|constrain\w*|"
    r"constraint|satisf\w*|choos\w*|choice|set|sets|setting|find|for which|impos\w*|subject to|provided|case|cases|"
    r"equation\w* of|unknown\w*|roots?|initial|boundary|minimi[sz]\w*|maximi[sz]\w*|example|consider\w*|approximat\w*|"
    r"neglect\w*|small|limit\w*|equilibri\w*|wrong|false|incorrect|not true|mistake\w*|naive\w*|instead|replac\w*|"
    r"substitut\w*|modulo|mod|model\w*|law|hypothes\w*|contradict\w*|iterat\w*|updat\w*|assign\w*)\b",
    re.IGNORECASE,
)
# words before a formula that say that it holds for all values of its letters
IDENTITY = re.compile(r"\b(identit\w+|for (?:all|every|any|each)|trigonometric|expand\w*|simplif\w*)\b", re.IGNORECASE)
SENTENCES = 2  # before a formula in which such a word counts
MOST_CONDITIONS = 8  # relations that share letters with one that fails, the nearest ones, which must not save it
NEAR = 3  # formulas behind one that may say for what it holds
SECONDS = 1.0  # for a formula alone; nearly all that are decided at all are decided in a fifth
SEARCH = 4.0  # seconds for one that seems to fail
SMALLEST = 3  # parts of a side that is more than a letter with a sign: of shorter ones nothing can be told


@dataclass(frozen=True)
class Question:
    """One relation with what the document says before it."""

    number: int  # of the formula
    relation: str
    kind: str
    where: tuple[str, ...] = ()
    sources: tuple[int, ...] = ()  # the formulas that define
    given: tuple[str, ...] = ()
    letters: tuple[tuple[str, str], ...] = ()
    sure: bool = False  # does it fail only if a slip of the pen away from it stands what holds?


def decided(question: Question) -> Answer:
    """The answer, without a search for repairs."""
    try:
        with limited(SECONDS):
            return answered(question.relation, question.where, (), dict(question.letters), wanted=False)
    except OutOfTime:
        return Answer(Status.UNDECIDED, reason=f"the search was not over after {SECONDS:g} s")


def confirmed(question: Question) -> Answer:
    """The answer to what seems to fail: with what else the document says of the letters, and with repairs."""
    try:
        with limited(SEARCH):
            return _confirmed(question)
    except OutOfTime:
        return Answer(Status.UNDECIDED, reason=f"the search was not over after {SEARCH:g} s")


def _confirmed(question: Question) -> Answer:
    said = dict(question.letters)
    if question.given:
        together = answered(question.relation, question.where, question.given, said, wanted=False)
        if together.verdict in (Status.PROVED, Status.UNDECIDED, Status.VACUOUS):
            return together
        for condition in question.given if together.verdict is not Status.REFUTED else ():
            alone = answered(question.relation, question.where, (condition,), said, wanted=False)
            if alone.verdict not in (Status.REFUTED, Status.UNREADABLE):
                return alone
    return answered(question.relation, question.where, (), said)


class Checks:
    """The questions that a document raises."""

    def __init__(self, formulas: Sequence[Printed], seen: Sequence[Seen], letters: Sequence[Letter]) -> None:
        self.formulas, self.seen = formulas, seen
        self.letters = {each.letter: each for each in letters}

    def alone(self) -> Iterator[Question]:
        """Whether formulas that define nothing hold for all values."""
        for k, seen in enumerate(self.seen):
            if seen.links and not seen.reason and not (seen.head and len(seen.links) == 1):
                yield Question(k, self.formulas[k].latex, "alone", letters=self._said(seen))

    def _said(self, *seen: Seen) -> tuple[tuple[str, str], ...]:
        found: dict[str, str] = {}
        for each in seen:
            found |= said(each, self.letters)
        return tuple(found.items())

    def is_statement(self, k: int) -> bool:
        """Is a formula printed as something that holds, by the words before it?"""
        formula, seen = self.formulas[k], self.seen[k]
        words = ". ".join(re.split(r"[.;:]\s+(?=[A-Z\\])", formula.before)[-SENTENCES:])
        return formula.display and seen.plain and not seen.reason and not CONDITIONAL.search(words)

    def suspicious(self) -> Iterator[Question]:
        """Relations that ought to hold by what stands before them."""
        for k, seen in enumerate(self.seen):
            if not self.is_statement(k):
                continue
            for n, link in enumerate(seen.links):
                if (question := self._chained(k, link) or self._defined(k, n, link)) is not None:
                    yield question

    def _chained(self, k: int, link: Link) -> Question | None:
        """A link behind another one, with the same letters on both sides."""
        if link.names[0] != link.names[1] or not link.names[0] or min(link.sizes) < SMALLEST:
            return None
        relation = f"{link.left} = {link.right}"
        kind = "chain" if link.chained else "identity"
        if not link.chained and not IDENTITY.search(self.formulas[k].before):
            return None
        conditions = self._conditions(k, link.names[0], ())
        return Question(k, relation, kind, given=conditions, letters=self._said(self.seen[k]), sure=not link.chained)

    def _defined(self, k: int, n: int, link: Link) -> Question | None:
        """A relation between letters that are all defined before it, or free in these definitions."""
        seen = self.seen[k]
        known = self._definitions(k)
        names = link.names[0] | link.names[1]
        used: dict[str, int] = {}
        more = {x for x in names if x in known}
        while more:
            used |= {x: known[x] for x in more}
            more = {x for m in (known[x] for x in more) for x in self._own(m)} & known.keys() - used.keys()
        free = {x for m in used.values() for x in self._own(m)}
        if not used or not names <= free | used.keys() or link.sizes[1] < SMALLEST:
            return None
        first = n == 0 and bool(seen.head)
        if first and seen.head not in known:
            return None
        again = first and self._own(known[seen.head]) != frozenset(names)
        if again:
            return None
        where = tuple(self._definition(m) for m in dict.fromkeys(used.values()))
        sources = tuple(sorted(set(used.values())))
        conditions = self._conditions(k, frozenset(names | free), sources)
        letters = self._said(seen, *(self.seen[m] for m in sources))
        kind = "again" if first else "defined"
        return Question(k, f"{link.left} = {link.right}", kind, where, sources, conditions, letters, sure=True)

    def _own(self, m: int) -> frozenset[str]:
        """The letters of the definition that a formula states."""
        link = self.seen[m].links[0]
        return link.names[0] | link.names[1]

    def _definition(self, m: int) -> str:
        link = self.seen[m].links[0]
        return f"{link.left} = {link.right}"

    def _definitions(self, k: int) -> dict[str, int]:
        """The letters that are defined before a formula, once, in the same part of the document."""
        section, local = self.formulas[k].scope
        found: dict[str, int] = {}
        twice = set()
        for m in range(k):
            theirs = self.formulas[m].scope
            seen = self.seen[m]
            if theirs[0] != section or theirs[1] not in (0, local) or not seen.head or not self.is_statement(m):
                continue
            if not seen.links[0].names[1]:
                continue  # a value in one case
            if seen.head in found and self._definition(found[seen.head]) != self._definition(m):
                twice.add(seen.head)
            found.setdefault(seen.head, m)
        return {letter: m for letter, m in found.items() if letter not in twice}

    def _conditions(self, k: int, names: frozenset[str], used: Sequence[int]) -> tuple[str, ...]:
        """What else the document says of the letters: all before, and what follows at once."""
        own = _bare(self.formulas[k].latex)
        found: list[str] = []
        order = [*range(k + 1, min(k + 1 + NEAR, len(self.seen))), *range(k - 1, -1, -1)]
        for m in order:
            seen = self.seen[m]
            if m in used or seen.reason or not seen.names & names or _bare(self.formulas[m].latex) == own:
                continue
            if not seen.names <= names:
                continue
            found.append(self.formulas[m].latex)
            if len(found) == MOST_CONDITIONS:
                break
        return tuple(dict.fromkeys(found))


def _bare(latex: str) -> str:
    return re.sub(r"\s|[{}]", "", latex)
