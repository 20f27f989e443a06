"""What each relation of a document is taken for in an audit: its role, and the earlier ones from which it follows."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Set
from dataclasses import dataclass

from symcheck.document.checks import AGAIN, NEAR, Checks, Definition
from symcheck.document.letters import shown
from symcheck.document.survey import SMALLEST, Link
from symcheck.document.written_out import COMPONENTS, SEPARATORS
from symcheck.reading.evidence import spellings
from symcheck.reading.faces import face

# words before an equation that make it a law, which says what a letter is all the same
LAWS = re.compile(
    r"\b(law|model\w*|equation\w* of(?: equilibrium)?|equilibrium equation\w*|hypothes\w*|assum\w*|consider\w*|example|"
    r"sets?|setting|choos\w*|choice)\b",
    re.I,
)

# words before a relation within the text that make it a definition
INTRODUCED = re.compile(r"\b(?:where|let|denot\w*|put|call\w*|writ\w*|defin\w*)\W*$", re.I)
# words before a relation that choose what a letter is, which may be chosen otherwise behind it
CHOSEN = re.compile(r"\b(?:let|set|setting|choos\w*|chose|tak(?:e|es|ing)|put|putting|pick\w*)\W*$", re.I)
# bars of a length, and spaces
BARS = re.compile(r"\\(?:left|right)(?![a-zA-Z])|\\[lr][vV]ert(?![a-zA-Z])|\\?\||\s")
# words before a relation within the text that make it a place or a case
AT = re.compile(r"\b(?:at|for|if|when|near|until|unless|on|from|to|as|in)\W*$", re.I)
BEHIND = re.compile(r"\W*(?:where|with|for|in which)\b", re.I)  # words behind a display that go on with it
# words before a relation that make it a condition, unless it speaks of letters that are all known
OF_KNOWN = re.compile(rf"{LAWS.pattern}|\bsatisf\w*", re.I)


@dataclass(frozen=True)
class Guess:
    """What one relation is taken for: its role, what it follows from, the links that define, or why it is not read.

    `far` are those of what it follows from that stand in another part of the document.
    """

    role: str
    follows: tuple[int, ...] = ()
    imposed: str = ""
    reason: str = ""
    far: frozenset[int] = frozenset()


def _is_length(letter: str, link: Link) -> bool:
    """Is a letter the length of the same letter in bold type? So it is understood, and nothing is put in for it."""
    return face(BARS.sub("", link.right)) == f"{letter}}}"


def _letters(text: str) -> frozenset[str]:
    """The letters of which a text says to which set they belong, or all of its letters."""
    return spellings(text.partition(r"\in")[0])


ASSIGNED = "a letter becomes something of itself: an assignment, or an equation to be solved? say what it is"


class Roles:
    """The roles of the relations of a document, in printed order."""

    def __init__(self, checks: Checks) -> None:
        self.checks, self.formulas, self.seen = checks, checks.formulas, checks.seen
        self.defined: dict[str, list[Definition]] = {}  # by letter: where it is said what it is
        self.otherwise: dict[str, list[int]] = {}  # by letter: where it is something else
        self.anew = [frozenset(x for text in f.anew for x in _letters(text)) for f in self.formulas]
        self.chosen = [*self._choices()]

    def _choices(self) -> Iterator[Counter[str]]:
        """For each relation how often letters have been chosen otherwise before it in its section."""
        section, said, often = None, dict[str, set[str]](), Counter[str]()
        for formula, seen in zip(self.formulas, self.seen, strict=True):
            if formula.scope[0] != section:
                section, said, often = formula.scope[0], {}, Counter()
            for x, link in seen.heads.items():
                own = said.setdefault(x, set())
                if own - {link.right} and CHOSEN.search(formula.before):
                    often = often + Counter([x])
                    own.clear()
                own.add(link.right)
            yield often

    def is_same_choice(self, m: int, k: int, names: Iterable[str]) -> bool:
        """Has none of these letters been chosen otherwise between two relations of a section?"""
        alike = self.formulas[m].scope[0] != self.formulas[k].scope[0]
        return alike or all(self.chosen[m][x] == self.chosen[k][x] for x in names)

    def guesses(self) -> list[Guess]:
        """The role of each relation, and the earlier ones that it seems to follow from."""
        return [self._guess(k) for k in range(len(self.formulas))]

    def _guess(self, k: int) -> Guess:
        seen, known = self.seen[k], self.known(k)
        if not (seen.read or seen.apart):
            return Guess("exclusion", reason=" ".join(seen.reason.split()))
        if any(link.is_assignment for link in seen.links):
            return Guess("exclusion", reason=ASSIGNED)
        heads = {x: link for x, link in seen.heads.items() if self._is_new(k, x, link, known)}
        for x, link in heads.items():
            if not _is_length(x, link):
                self.defined.setdefault(x, []).append(Definition(k, link))
        chained = any(link.chained for link in seen.links)
        if heads and not chained:
            return Guess("definition")
        for x, link in {} if chained else seen.heads.items():
            if x in known and (parts := self._open_components(known[x].link)) and not parts & link.names[1]:
                for part in parts:  # it says what the components are
                    self.defined.setdefault(part, []).append(Definition(k, link))
                return Guess("premise")
        for x in (others := [x for x, link in seen.heads.items() if self._is_another(k, x, link, known)]):
            self.otherwise.setdefault(x, []).append(k)
        if not heads and (others or not self._is_claim(k)):
            return Guess("premise")
        imposed = "".join(chr(ord("a") + link.place) for x, link in heads.items())
        needed = tuple(sorted(self._needed(k, known)))
        return Guess("claim", needed, imposed, far=frozenset(m for m in needed if not self.is_same_part(m, k)))

    def _open_components(self, link: Link) -> frozenset[str]:
        """The components that a definition gives to a vector or matrix, if it is not said what they are."""
        found = COMPONENTS.fullmatch(link.right.strip())
        parts = [shown(each) for each in SEPARATORS.split(found[1] or found[2])] if found else []
        names = {shown(name) for name in link.names[1]}
        single = len(parts) > 1 and len(parts) == len(names) and {*parts} == names
        return link.names[1] if single and not link.names[1] & self.defined.keys() else frozenset()

    def known(self, k: int) -> dict[str, Definition]:
        """What the letters are in a relation: as is said before it in its part of the document, else once elsewhere."""
        found = {}
        for letter, every in self.defined.items():
            if letter in self.anew[k]:
                every = [each for each in every if letter in self.anew[each.number]]
            every = [each for each in every if self.is_same_choice(each.number, k, (letter,))]
            own = [each for each in every if self.is_same_part(each.number, k)]
            others = [m for m in self.otherwise.get(letter, ()) if self.is_same_part(m, k)]
            if len(own) == 1 and not others:
                found[letter] = own[0]
            elif not own and not others and len(every) == 1 and not self.formulas[every[0].number].scope[1]:
                found[letter] = every[0]
        return found

    def is_same_part(self, m: int, k: int) -> bool:
        (section, local), theirs = self.formulas[k].scope, self.formulas[m].scope
        return theirs[0] == section and theirs[1] in (0, local)

    def _is_new(self, k: int, letter: str, link: Link, known: Mapping[str, Definition]) -> bool:
        """Does a relation say what a letter is of which nothing was said before?"""
        here = {x: each for x, each in known.items() if self.is_same_part(each.number, k)}
        if not link.names[1] or letter in here:
            return False
        if not self.formulas[k].display and not self._is_introduced(k, letter):
            return False
        return self.checks.is_said(k, LAWS) and letter not in self._reached(link.names[1], here)

    def _is_introduced(self, k: int, letter: str) -> bool:
        """Does a relation within the text say what a letter is, which is new there, or by its words?"""
        before = self.formulas[k].before
        if max(self.seen[k].heads[letter].sizes) == 1:
            return False  # one letter is another one there: a case
        new = not any(letter in self.seen[m].names for m in range(k) if self.is_same_part(m, k))
        return bool(INTRODUCED.search(before)) or (new and not AT.search(before))

    def _is_another(self, k: int, letter: str, link: Link, known: Mapping[str, Definition]) -> bool:
        """Does a relation say what a letter is in another case, and not again what it is?

        It is a claim if it is worded as one, or all of its letters are known from what the letter was said to be.
        """
        if letter not in known or not link.names[1] or AGAIN.search(self.formulas[k].before):
            return False
        own, names = known[letter].link.names[1], link.names[1] & self.seen[k].names
        return link.names[1] == own or not names <= self._reached({letter}, known) | known.keys()

    def _is_claim(self, k: int) -> bool:
        """Does a relation that defines nothing say something of its letters?"""
        seen, known = self.seen[k], self.known(k)
        determined = seen.names & known.keys() and seen.names <= self._reached(seen.names & known.keys(), known)
        if not self.checks.is_said(k, OF_KNOWN if determined else None):
            return False
        if not self.formulas[k].display:
            same = [x.names[0] == x.names[1] and min(x.sizes) >= SMALLEST for x in seen.links]
            return bool(same) and all(same)
        return not seen.links or any(
            link.names[1] if link.head else link.chained or seen.names & known.keys() or seen.is_of_same_letters(link)
            for link in seen.links
        )

    def _needed(self, k: int, known: Mapping[str, Definition]) -> set[int]:
        """The definitions that the letters of a claim need, transitively, and the conditions on all of these letters.

        The links of a chain that goes on with the same letters need no definitions.
        """
        seen = self.seen[k]
        rest = [{*map(seen.names.intersection, link.names)} for link in seen.links if link.chained]
        goes_on = bool(rest) and all(link.chained or link.head for link in seen.links)
        names = {x for sides in rest if len(sides) > 1 for each in sides for x in each} if goes_on else seen.names
        reached = self._reached(names, known)
        used = {known[x].number for x in reached & known.keys()} - {k}
        return used | {*self._conditions(k, reached | seen.names)}

    def _conditions(self, k: int, names: Set[str]) -> Iterator[int]:
        """The inequalities beside the text that speak of these letters alone: those before, and those that follow."""
        behind = range(k + 1, min(k + 1 + NEAR, len(self.formulas)))
        goes_on = behind and BEHIND.match(self.formulas[k + 1].before)
        close = [m for m in behind if goes_on and not any(self.formulas[n].display for n in range(k + 1, m + 1))]
        for m in (*range(k), *close):
            seen, inline = self.seen[m], not self.formulas[m].display
            if inline and not seen.links and seen.names <= names and self.is_same_part(m, k) and self.checks.is_said(m):
                yield m

    def _reached(self, names: Iterable[str], known: Mapping[str, Definition]) -> set[str]:
        """Letters, with those of the definitions that they need."""
        reached, more = set[str](), {*names}
        while more:
            reached |= more
            used = [known[each] for each in more & known.keys()]
            more = {x for each in used for x in each.names & self.seen[each.number].names} - reached
        return reached
