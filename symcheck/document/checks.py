"""What can be asked of a document without knowing more than it prints: questions with definitions and conditions."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain

from symcheck.document.conditions import holds_elsewhere
from symcheck.document.letters import Letter, said
from symcheck.document.macros import bare
from symcheck.document.points import compared, slips, symmetric_entries
from symcheck.document.printed import Printed
from symcheck.document.survey import IDENTITY_MATRIX, SMALLEST, Link, Seen, is_open, is_sayable, surveyed
from symcheck.document.written_out import gradient
from symcheck.proof.search.decide import UNSETTLED
from symcheck.question import Answer, Status
from symcheck.question.ask import REFUSED, answered
from symcheck.question.equations import EQUATION
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.prepare import Asked

# words before a formula that make it a condition, an equation to be solved, or a case, and no statement
CONDITIONAL = re.compile(
    r"\b(if|when|whenever|unless|suppos\w*|assum\w*|such that|solv\w*|requir\w*|condition\w*|constrain\w*|"
    r"constraint|satisf\w*|choos\w*|choice|set|sets|setting|find|for which|impos\w*|subject to|provided|case|cases|"
    r"equation\w* of|unknown\w*|roots?|initial|boundary|minimi[sz]\w*|maximi[sz]\w*|example|consider\w*|approximat\w*|"
    r"neglect\w*|small|limit\w*|equilibri\w*|wrong|false|incorrect|not true|mistake\w*|naive\w*|instead|replac\w*|"
    r"substitut\w*|unlike|modulo|mod|model\w*|law|hypothes\w*|contradict\w*|iterat\w*|updat\w*|assign\w*)\b",
    re.IGNORECASE,
)
# words beside an implication that does not hold
MISTAKEN = re.compile(r"\b(?:wrong|false|incorrect|not true|mistake\w*|naive\w*|fallac\w*)\b", re.IGNORECASE)
# a condition that is none: of what is known, or wanted, or that gives something a name
IDLE = re.compile(
    r"\b(?:if|when|once)\b(?:[^.,;:]*\b(?:known|given|needed|desired|wanted|necessary|possible)\b"
    r"| \$ (?:is|denotes) (?:a|an|the)\b)",
    re.IGNORECASE,
)
PURPOSE = re.compile(r"\bso that\b", re.IGNORECASE)  # or a consequence
# between two formulas in a sentence, of which the second one follows from the first
GIVING = re.compile(
    r"\$,? (?:(?:which|and|this) )?(?:gives?|yields?|implies|(?:reduce|simplifie)s to|is equivalent to)\W*$"
)
NAMED = re.compile(r"\bidentit\w+\W*$", re.IGNORECASE)  # what stands behind it at once is an identity
# words before a formula that say that it holds for all values of its letters
IDENTITY = re.compile(r"\b(identit\w+|for (?:all|every|any|each)|trigonometric|expand\w*|simplif\w*)\b", re.IGNORECASE)
# a sum, product or integral with its bounds, whose value is said
EVALUATED = re.compile(r"\\(?:sum|prod|int)(?:\s*\\limits)?\s*_")
INDEFINITE = re.compile(r"\\int(?!\s*[_^])")  # an integral whose derivative is known
AGAIN = re.compile(
    r"\b(recall\w*|again|as before|as above|repeat\w*|remember)\b", re.IGNORECASE
)  # before what is known
# words of which all are that stand before a display that goes on with the one before it
CONNECTING = re.compile(
    r"and|so|or|thus|hence|then|therefore|that|is|are|i|e|finally|equivalently|which|what|it|this|we|one|giv(?:e|es|ing)|"
    r"yield(?:s|ing)?|gets?|obtains?|becomes?|simplifies|reduces|to|have|left|with|in|other|words"
)
# a word behind such ones after which come the words for what is done
OPERATION = re.compile(r"(?:simplif|rearrang|expand|collect|divid|multiply|cancel|factor)\w*")
# words that say that a display follows from those to which they refer
REFERRING = re.compile(r"\b(?:substitut|subsitut|insert|plug|combin|eliminat|add|subtract|solv)\w*\b", re.IGNORECASE)
USING = re.compile(r"\b(?:us(?:e|ing)|from|by)\b", re.IGNORECASE)  # words before those that are named, too
# words before a formula that give a letter a value
CASE = re.compile(
    r"\b(?:for|with|if|when|set|setting|substituting|putting|taking|letting|assuming|where)\b", re.IGNORECASE
)
WHERE = re.compile(r"\b(?:for|if|when) \$", re.IGNORECASE)  # words before a formula that bounds letters
# a bound of negative numbers
NEGATIVE = re.compile(
    r"(?:<|\\le(?:q(?:slant)?)?(?![a-z]))\s*(?:0|-)|(?:0|-[^<>]*)\s*(?:>|\\ge(?:q(?:slant)?)?(?![a-z]))"
)
# words that end with what comes of it
RESULTING = re.compile(
    r"\b(?:becomes?|left with|(?:get|have|obtain|find)s?|(?:give|yield)s?|(?:reduce|simplifie|lead)s? to)\W*$",
    re.IGNORECASE,
)
# words that end with what something is
DEFINED = re.compile(r"\b(?:defined|given|written|expressed)\b[^.,;]*\b(?:as|by)\W*$", re.IGNORECASE)
# to a label, or to a number in brackets
REFERENCE = re.compile(r"ref\{([^{}]+)\}|\{([^{}\s]+)\}|\(([\w.]+)\)|@(eq-[\w-]+)")
ROUNDED = re.compile(r"\d[.,]\d")  # a number that may be so, so that sides are equal to some digits only
LISTS = frozenset({"vector", "matrix"})  # kinds of letters beside which an identity is a matrix
ONE = "the number 1"  # which it is beside numbers
MOST_CONNECTING = 10  # words; longer sentences bring something new
SENTENCES = 2  # before a formula in which such a word counts
MOST_CONDITIONS = 8  # relations that share letters with one that fails, the nearest ones, which must not save it
NEAR = 3  # formulas behind one that may say for what it holds
OVER = "the search was not over after"
SECONDS = 1.0  # for a formula alone; nearly all that are decided at all are decided in a fifth
SEARCH = 4.0  # seconds for one that seems to fail
REPAIRING = 2.5  # of these for slips of the pen; nearly all that are found are found in one


Place = tuple[int, str]  # the number of a formula, and one of its relations


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
    worded: bool = False  # do words say that it follows?

    @property
    def places(self) -> tuple[Place, ...]:
        """The relation, and those from which it may follow, each with the number of its formula."""
        return (self.number, self.relation), *zip(self.sources, self.where, strict=True)


def decided(question: Question) -> Answer:
    """The answer, without a search for repairs."""
    try:
        with limited(SECONDS):
            return answered(question.relation, question.where, (), dict(question.letters), wanted=False)
    except OutOfTime:
        return Answer(Status.UNDECIDED, reason=f"{OVER} {SECONDS:g} s")


def confirmed(question: Question) -> Answer:
    """The answer to what seems to fail: with what else the document says of the letters, and with repairs."""
    try:
        with limited(SEARCH):
            return _confirmed(question)
    except OutOfTime:
        return Answer(Status.UNDECIDED, reason=f"{OVER} {SEARCH:g} s")


def _explained(question: Question) -> bool:
    """Does a relation fail at points, with all else that is said of its letters, and hold there after a slip?"""
    if not (question.worded or question.kind in ("chain", "identity")):
        return False
    given = [(*question.where, condition) for condition in question.given]
    found = [compared(question.relation, sources, question.letters) for sources in (question.where, *given)]
    if found[0] is None or any(each is not None and each.holds for each in found):
        return False
    return next(slips(question.relation, question.where, question.letters), None) is not None


def _confirmed(question: Question) -> Answer:
    said = dict(question.letters)
    if entries := symmetric_entries((question.relation, *question.where)):
        alike = answered(question.relation, question.where, entries, said, wanted=False)
        if not fails(alike):
            return replace(alike, verdict=Status.UNDECIDED, reason="the matrix of these entries may be symmetric")
    if question.given:
        together = answered(question.relation, question.where, question.given, said, wanted=False)
        if together.verdict in (Status.PROVED, Status.UNDECIDED, Status.VACUOUS):
            return replace(together, verdict=Status.REFUTED) if fails(together) and _explained(question) else together
        for condition in question.given if together.verdict is not Status.REFUTED else ():
            alone = answered(question.relation, question.where, (condition,), said, wanted=False)
            if alone.verdict not in (Status.REFUTED, Status.UNREADABLE):
                return alone
    asked = Asked(question.relation, question.where, (), question.letters)
    if elsewhere := holds_elsewhere(asked):
        return Answer(Status.UNDECIDED, reason="it holds for some positive numbers: a condition may be meant")
    found = answered(question.relation, question.where, (), said, wanted=False)
    with suppress(OutOfTime), limited(REPAIRING):
        more = answered(question.relation, question.where, (), said)
        if more.verdict is Status.REFUTED and more.repairs:
            found = more
    if is_open(question.relation):
        return replace(found, verdict=Status.UNDECIDED, reason="some of its letters may be vectors")
    if fails(found) and _explained(question):
        return replace(found, verdict=Status.REFUTED)
    if not found.repairs and (question.sure or elsewhere is None):
        return replace(found, verdict=Status.UNDECIDED, reason="no slip of the pen is near that would explain it")
    return found


def fails(answer: Answer) -> bool:
    """Is something refuted, or is nothing known against the points at which it fails?"""
    open_ = answer.reason == UNSETTLED or answer.reason.startswith((REFUSED, OVER, EQUATION))
    return answer.verdict is Status.REFUTED or (answer.verdict is Status.UNDECIDED and open_)


@dataclass(frozen=True)
class Definition:
    """An equation that says what a letter is, with the number of its formula."""

    number: int
    link: Link

    @cached_property
    def names(self) -> frozenset[str]:
        """All of its letters."""
        return self.link.names[0] | self.link.names[1]


class Checks:
    """The questions that a document raises."""

    def __init__(self, formulas: Sequence[Printed], seen: Sequence[Seen], letters: Sequence[Letter]) -> None:
        self.formulas, self.seen = formulas, seen
        self.letters = {each.letter: each for each in letters}

    def alone(self) -> Iterator[Question]:
        """Whether formulas that define nothing hold for all values."""
        for k, seen in enumerate(self.seen):
            if seen.links and not seen.reason and len(seen.heads) < len(seen.links):
                yield Question(k, self.formulas[k].latex, "alone", letters=self.said(seen))

    def said(self, *seen: Seen, factors: bool = False) -> tuple[tuple[str, str], ...]:
        """What letters of formulas are; if wanted, also which are numbers, and so no parts of names."""
        found: dict[str, str] = {}
        for role in chain.from_iterable(each.roles for each in seen if factors and not each.reason):
            if role.kind == "scalar" and not role.phrase and not self.letters[role.letter].phrase:
                found[role.letter] = "scalar"
        for each in seen:
            found |= said(each, self.letters) | dict(each.said)
            if each.apart:  # its links are as they are read in the whole
                found |= {role.letter: role.phrase for role in each.roles if is_sayable(role.phrase)}
        roles = [role for each in seen for role in each.roles]
        lists = any(role.kind in LISTS for role in roles) or not LISTS.isdisjoint(found.values())
        units = (role.letter for role in roles if role.kind == IDENTITY_MATRIX)
        found |= dict.fromkeys(units, IDENTITY_MATRIX if lists else ONE)
        return tuple(found.items())

    def is_statement(self, k: int) -> bool:
        """Is a display printed as something that holds, by the words before it?"""
        words = self._words(k)
        aside = REFERRING if self.named(k, words)[1] else None
        return self.formulas[k].display and self.is_said(k, aside) and not PURPOSE.search(words)

    def is_said(self, k: int, aside: re.Pattern[str] | None = None) -> bool:
        """Is a formula printed as something that holds, by the words before it? Some of these may be set aside."""
        return self.seen[k].is_sayable and self._is_worded(k, aside)

    def _is_worded(self, k: int, aside: re.Pattern[str] | None = None) -> bool:
        words = IDLE.sub("", aside.sub("", self._words(k)) if aside else self._words(k))
        return self.seen[k].plain and not CONDITIONAL.search(words)

    def _words(self, k: int, most: int = SENTENCES) -> str:
        """The last words before a formula; of displays below each other those before the first.

        The sentence that says from what it follows, or what it defines, stands for itself.
        """
        while k and self.formulas[k].display and self.formulas[k - 1].display and not self.formulas[k].before:
            k -= 1
        sentences = re.split(r"[.;:]\s+(?=[A-Z\\])", self.formulas[k].before)
        last = sentences[-1]
        alone = DEFINED.search(last) or ((REFERRING.search(last) or USING.search(last)) and RESULTING.search(last))
        return ". ".join(sentences[-1 if alone else -most :])

    def suspicious(self) -> Iterator[Question]:
        """Relations that ought to hold by what stands before them."""
        for k, seen in enumerate(self.seen):
            stated = self.is_statement(k) or (seen.plain and seen.is_sayable and self._is_named_identity(k))
            if stated or self._is_bounded(k):
                for link in seen.links:
                    question = self._chained(k, link) or (self._defined(k, link) if stated else None)
                    if question is not None:
                        yield question
            elif self.formulas[k].display and seen.is_sayable and not CONDITIONAL.search(self._words(k, 1)):
                every = (*(seen.links if seen.plain else ()), *seen.premises, *seen.conclusions)
                yield from (each for link in every if link.chained and (each := self._chained(k, link)) is not None)

    def _is_named_identity(self, k: int) -> bool:
        """Does the word for one stand at once before a formula within a sentence?"""
        return not self.formulas[k].display and NAMED.search(self.formulas[k].before) is not None

    def gradients(self, agreed: Container[int]) -> Iterator[Question]:
        """The entries of lists of derivatives of a number that is said before; in what agrees it is said again."""
        said = {x for seen in self.seen for x in seen.heads}  # what may depend on the letters of a gradient
        for k, seen in enumerate(self.seen):
            stated = self.formulas[k].display and self._is_worded(k) and not PURPOSE.search(self._words(k))
            for link in seen.links if stated else ():
                if (lists := gradient(link)) is None:
                    continue
                source = self.definitions(k, agreed, wide=True).get(lists.of)
                if source is None or said & source.names - {lists.of, *lists.by} or source.names.isdisjoint(lists.by):
                    continue
                slope = {lists.of: f"depends on {', '.join(lists.by)}"}
                letters_ = tuple((dict(self.said(seen, self.seen[source.number])) | slope).items())
                where, places = (source.link.latex,), (source.number,)
                for text in lists.equations:
                    alone = surveyed(text, tuple(slope.items()))
                    names = frozenset[str]().union(*(x for link in alone.links for x in link.names))
                    if alone.links and alone.is_sayable and names <= source.names | {*lists.by}:
                        yield Question(k, text, "defined", where, places, letters=letters_, sure=True)

    def _is_bounded(self, k: int) -> bool:
        """Is a display said to hold within bounds, as it then does for some positive numbers?"""
        m = next((m for m in range(k - 1, -1, -1) if self.formulas[m].display), -1)
        between = range(m + 1, k)
        bounds = all(not self.seen[n].links and not NEGATIVE.search(self.formulas[n].latex) for n in between)
        return bounds and self.formulas[k].display and self.is_said(k, WHERE) and not PURPOSE.search(self._words(k))

    def continued(self, asked: Iterable[Question], proved: Container[Question]) -> Iterator[int]:
        """The definitions that go on, where all that follows on the first equation holds."""
        count = Counter(question.number for question in asked if question.kind == "chain" and question in proved)
        for k, number in count.items():
            seen = self.seen[k]
            if number == len(seen.links) - len(seen.heads):
                yield k

    def derivations(self) -> Derivations:
        """Equations that may follow from those on the lines before them: of the same letters, in one derivation."""
        steps = {k: step for k in range(1, len(self.seen)) if (step := self._step(k - 1, k)) is not None}
        beyond = {k: step for k in steps if k + 1 in steps and (step := self._step(k - 1, k + 1)) is not None}
        referred = {k: step for k, step in self.referred.items() if k not in steps}
        return Derivations(steps, beyond, referred)

    def _referred(self, k: int) -> Question | None:
        """Whether an equation follows from those that the words before it name, if it has no other letters."""
        formula = self.formulas[k]
        referring = REFERRING.search(formula.before) or USING.search(formula.before)
        if not (formula.display and referring and self.is_said(k, REFERRING)):
            return None
        if k and self.formulas[k - 1].before == formula.before and self.formulas[k - 1].display:
            return None
        named, sources = self.named(k, formula.before)
        return self._from(k, sources) if len(sources) == len(named) else None

    def _implied(self, k: int) -> Question | None:
        """Whether the right side of an implication between equations follows from the left one."""
        seen = self.seen[k]
        if seen.reason or not seen.premises or len(seen.conclusions) != 1 or MISTAKEN.search(self._words(k)):
            return None
        return self._from_links(k, seen.conclusions[0], seen.premises, [k] * len(seen.premises))

    def _special(self, k: int) -> Question | None:
        """Whether an equation follows from the display before it with the formulas in the words between them.

        As in: for $v = 0$, or setting $v = 0$, it becomes.
        """
        m = next((m for m in range(k - 1, -1, -1) if self.formulas[m].display), k)
        between, words = range(m + 1, k), self.formulas[k].before
        if not (self.formulas[k].display and between and RESULTING.search(words) and self.is_said(k, CASE)):
            return None
        if not CASE.search(words) or self.formulas[m].scope != self.formulas[k].scope:
            return None
        if any(self.seen[n].names.isdisjoint(self.seen[m].names) for n in between):
            return None  # a case of something else
        return self._from(k, [m, *between])

    @cached_property
    def referred(self) -> dict[int, Question]:
        """The equations that follow from others by the words before them."""
        every = ((k, self._implied(k) or self._referred(k) or self._special(k)) for k in range(len(self.seen)))
        return {k: question for k, question in every if question is not None}

    def _from(self, k: int, sources: Sequence[int]) -> Question | None:
        """Whether an equation follows from others, as words say, if it has no other letters."""
        seen, others = self.seen[k], [self.seen[m] for m in sources]
        if seen.reason or not sources or any(x.reason or not x.plain or len(x.links) != 1 for x in (seen, *others)):
            return None
        return self._from_links(k, seen.links[0], [x.links[0] for x in others], sources)

    def _from_links(self, k: int, link: Link, links: Sequence[Link], sources: Sequence[int]) -> Question | None:
        if not link.names[0] | link.names[1] <= frozenset[str]().union(*(x.names[0] | x.names[1] for x in links)):
            return None
        where = tuple(x.latex for x in links)
        said = self.said(self.seen[k], *(self.seen[m] for m in sources), factors=True)
        return Question(k, link.latex, "step", where, tuple(sources), letters=said, sure=True, worded=True)

    def named(self, k: int, words: str) -> tuple[set[str], list[int]]:
        """The labels and numbers in words near a formula, and the formulas before it that have these."""
        names = [next(filter(None, found.groups())) for found in REFERENCE.finditer(words)]
        before = {name: max((m for m in self._places.get(name, ()) if m < k), default=-1) for name in names}
        return {*names}, [*dict.fromkeys(m for m in before.values() if m >= 0)]

    @cached_property
    def _places(self) -> dict[str, list[int]]:
        """The formulas with a label or a number, which chapters may begin anew."""
        found: dict[str, list[int]] = {}
        for m, each in enumerate(self.formulas):
            for name in filter(None, (each.label, each.number)):
                found.setdefault(name, []).append(m)
        return found

    def _step(self, m: int, k: int) -> Question | None:
        """Whether an equation follows from one before it, if both stand below each other and have the same letters."""
        both, seen = (self.formulas[m], self.formulas[k]), (self.seen[m], self.seen[k])
        if len({(f.display, f.scope) for f in both}) > 1 or both[1].goes_on:
            return None
        given = k == m + 1 and not both[0].display and GIVING.search(both[1].before) is not None
        if not both[0].display and not given:
            return None
        worded = both[0].before != both[1].before
        if worded and not given and not (_goes_on(both[1].before) and self.is_said(k)):
            return None
        if both[0].latex == both[1].latex or any(x.reason or not x.plain or len(x.links) != 1 for x in seen):
            return None
        (one,), (two,) = (each.links for each in seen)
        names = one.names[0] | one.names[1]
        if not names or not two.names[0] | two.names[1] <= names:
            return None
        return Question(k, two.latex, "step", (one.latex,), (m,), letters=self.said(*seen), sure=True, worded=worded)

    def _chained(self, k: int, link: Link) -> Question | None:
        """A link behind another one, with the same letters on both sides, or fewer letters than before."""
        if link.chained and not link.names[0] | link.names[1] and not ROUNDED.search(link.latex):
            return Question(k, link.latex, "chain")
        kind = "chain" if link.chained else "identity"
        fewer = link.names[1] < link.names[0]
        if kind == "identity":
            worded = IDENTITY.search(self.formulas[k].before)
            summed = EVALUATED.match(link.left) and self.seen[k].is_of_same_letters(link)
            if not (worded or summed or INDEFINITE.match(link.left)) or max(link.sizes) < SMALLEST:
                return None
        elif not link.names[1] or min(link.sizes) < SMALLEST:
            return None
        if not fewer and link.names[0] != link.names[1]:
            return None
        conditions = self._conditions(k, link.names[0], ())
        return Question(
            k,
            link.latex,
            kind,
            given=conditions,
            letters=self.said(self.seen[k]),
            sure=fewer or not (link.chained and self._of_numbers(k)),
        )

    def _of_numbers(self, k: int) -> bool:
        """Are all letters of a formula numbers, of which words hardly say more?"""
        return all(role.kind in ("scalar", "index", "number", "differential") for role in self.seen[k].roles)

    def _defined(self, k: int, link: Link) -> Question | None:
        """A relation between letters that are all defined before it, or free in these definitions."""
        known = self.definitions(k)
        names = link.names[0] | link.names[1]
        used: dict[str, Definition] = {}
        more = {x for x in names if x in known}
        while more:
            used |= {x: known[x] for x in sorted(more)}
            more = {x for x in more for x in known[x].names} & known.keys() - used.keys()
        free = frozenset(x for each in used.values() for x in each.names)
        if not used or not names <= free | used.keys() or max(link.sizes) < SMALLEST:
            return None
        if link.head and not (link.head in known and AGAIN.search(self.formulas[k].before)):
            return None
        if link.head and known[link.head].names != names:
            return None
        sources = [*dict.fromkeys(used.values())]
        numbers = tuple(each.number for each in sources)
        return Question(
            k,
            link.latex,
            "defined",
            tuple(each.link.latex for each in sources),
            numbers,
            self._conditions(k, names | free, numbers),
            self.said(self.seen[k], *(self.seen[m] for m in numbers)),
            sure=True,
        )

    def definitions(self, k: int, agreed: Container[int] = (), *, wide: bool = False) -> dict[str, Definition]:
        """The letters that are defined before a formula, once, in the same part of the document.

        Or again in a formula that agrees with those before it. A wide part is a chapter.
        """
        section, local = self.formulas[k].scope
        found: dict[str, Definition] = {}
        twice = set()
        for m in range(k):
            theirs = self.formulas[m].scope
            beside = theirs[0] == section or (wide and self.formulas[m].chapter == self.formulas[k].chapter)
            if not beside or theirs[1] not in (0, local) or not self.is_statement(m):
                continue
            for head, link in self.seen[m].heads.items():
                if not link.names[1]:
                    continue  # a value in one case
                if head in found and m in agreed:
                    found[head] = Definition(m, link)
                elif head in found and found[head].link.latex != link.latex:
                    twice.add(head)
                found.setdefault(head, Definition(m, link))
        return {letter: each for letter, each in found.items() if letter not in twice}

    def _conditions(self, k: int, names: frozenset[str], used: Sequence[int]) -> tuple[str, ...]:
        """What else the document says of the letters: all before, and what follows at once."""
        own = bare(self.formulas[k].latex)
        found: list[str] = []
        for m in nearest(k, len(self.seen)):
            seen = self.seen[m]
            if m in used or seen.reason or not seen.names & names or bare(self.formulas[m].latex) == own:
                continue
            if not seen.names <= names:
                continue
            found.append(self.formulas[m].latex)
            if len(found) == MOST_CONDITIONS:
                break
        return tuple(dict.fromkeys(found))


@dataclass(frozen=True)
class Derivations:
    """Lines below each other: whether each follows from the one before it, and from the one before that."""

    steps: dict[int, Question]
    beyond: dict[int, Question]  # by the number of the line that is left out
    referred: dict[int, Question]  # lines that are said to follow from others, named by their numbers

    @property
    def questions(self) -> list[Question]:
        """Those to be asked first, each once."""
        return [*dict.fromkeys((*self.steps.values(), *self.referred.values()))]

    def further(self, proved: Container[Question]) -> list[Question]:
        """Those to be asked where a line does not follow from the one before it."""
        return [self.beyond[k] for k, step in self.steps.items() if step not in proved and k in self.beyond]

    def unlike(self, proved: Container[Question]) -> Iterator[Question]:
        """The steps that are not proved, where others beside them are, but for one behind a line that is left out.

        Or where words say that they follow.
        """
        yield from (step for step in self.referred.values() if step not in proved)
        for k, step in self.steps.items():
            near = (self.beyond.get(k), self.steps.get(k - 1), self.steps.get(k + 1))
            expected = step.worded or any(each in proved for each in near)
            if step not in proved and expected and self.beyond.get(k - 1) not in proved:
                yield step

    def is_certain(self, step: Question, proved: Container[Question]) -> bool:
        """Is it the line of a step that is wrong, and not the one before it?"""
        near = (self.beyond.get(step.number), self.steps.get(step.number - 1))
        return step.worded or any(each in proved for each in near)


def _goes_on(before: str) -> bool:
    """Do words say no more than that a formula follows from the one before it, or what is done to it?"""
    words = re.findall(r"[a-z]+", before.lower())
    end = next((n for n, word in enumerate(words) if OPERATION.fullmatch(word)), len(words))
    return len(words) <= MOST_CONNECTING and all(map(CONNECTING.fullmatch, words[:end]))


def nearest(k: int, count: int) -> list[int]:
    """The formulas that may say for what one holds: those that follow at once, then all before, the nearest first."""
    return [*range(k + 1, min(k + 1 + NEAR, count)), *range(k - 1, -1, -1)]
