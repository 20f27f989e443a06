"""Which relations of a document follow from earlier ones: from sets of equations in which no letter stands alone."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import permutations

from symcheck.document.applied import OF
from symcheck.document.checks import ONE, REFERRING, Checks, Definition, Place, Question
from symcheck.document.points import Found, compared, idle, is_source, slips, slips_of_source
from symcheck.document.roles import OF_KNOWN, Roles
from symcheck.document.survey import IDENTITY_MATRIX, SMALLEST, Seen, surveyed
from symcheck.document.work import Work
from symcheck.document.written_out import entries
from symcheck.question import Status
from symcheck.question.ask import answered
from symcheck.question.limit import OutOfTime, limited

MOST_SOURCES = 5  # equations from which one follows; derivations of the audited documents take four
MOST_SETS = 60  # that are looked for, of which the smallest and nearest are asked
FAR = 12  # formulas before and behind one with which it is compared, if nothing before it says whether it holds
AROUND = 3  # words before so many formulas, from one on, tell what it rests on: "We have used x = y and (3)"
LATER = "later"  # the kind of questions of which nothing is proved
MOST_STEPS = 2000  # of the search for sets
SAID = 8  # times that it is said what a letter is; one of which it is said more often is another one in each case
SAME = 2  # sources with the same left side as the relation, of which one holds in another case
ANEW = 2  # sections that say what a letter is, which means the same in all of them all the same
COMPARED = 12  # of these sets, those that bind the letters of the equation
ASKED = 8  # of these, those that are asked, where it holds
EXPLAINED = 4  # of these, those for which slips of the pen are looked for, where it fails
# words before a relation that do not make it a condition, if it may follow from others
DERIVED = re.compile(rf"{OF_KNOWN.pattern}|{REFERRING.pattern}|\b(?:replac\w*|find)\b", re.IGNORECASE)
# the same before what alone says what a letter is: there these words name things
NAMING = re.compile(
    rf"{DERIVED.pattern}|(?<!in the )\blimit(?:s|ed)?\b|\b(?:laws?|models?|examples?|consider\w*)\b", re.IGNORECASE
)
# words before what holds nearly
NEARLY = re.compile(
    r"\b(?:lineari[sz]\w*|neglect\w*|approximation\w*|(?:first|second|leading|lowest|higher)[- ]order"
    r"(?! (?:polynomial|differential|equation|system|tensor|partial|ODE))"
    r"|small[- ](?:\w+ )?(?:angle|perturbation|deviation|oscillation|displacement|rotation|error|motion)s?"
    r"|(?:is|are|be|for|sufficiently|very|enough) small)\b",
    re.IGNORECASE,
)
NEAR = re.compile(r"[A-Za-z].*\\(?:approx|simeq)(?![A-Za-z])")  # a sign of it, behind letters
# a function at letters: `u(x, t)`
_AT_LETTERS = re.compile(r"(\\?[A-Za-z]+(?:_\{?[^{}()]*\}?)?)\s*(?:\\left)?\(([^()]*?)(?:\\right)?\)")
WRITTEN_OUT = re.compile(r"\\begin|\\times")  # what numbers do not have
AS_NUMBERS = {"vector": "scalar", "matrix": "scalar", IDENTITY_MATRIX: ONE}  # matrices of one row and one column
ATTEMPT = 0.4  # seconds for one set; of the proofs in tried documents none took half as long
FOLLOWING = 1.2  # for all sets of a relation
SLIPS = 4.0  # seconds for the slips in one relation
UNBOUND = 1.0  # if the others do not bind its letters, so that a slip has to bring in others
EXPLAINING = 12.0  # for all slips that may explain why a relation fails


@dataclass(frozen=True)
class Outcome:
    """Which set proves a relation, and with which it holds, or fails, at points: those that bind its letters."""

    proof: Question | None = None
    holding: tuple[Question, ...] = ()
    failing: tuple[Question, ...] = ()
    unproved: tuple[Question, ...] = ()  # those that may be proved, the smallest sets first


NOTHING = Outcome()


Outcomes = dict[int, list[Outcome]]  # by the number of a formula: one for each of its equations


def sought(sets: Derived, numbers: Iterable[int], work: Work, until: float = math.inf) -> tuple[Outcomes, int]:
    """How each equation of these formulas compares with others, and how many were left when the time was over.

    What agrees or disagrees with nothing before it is compared with what stands behind it.
    """

    def outcomes(questions: Mapping[int, list[tuple[Question, ...]]]) -> tuple[Outcomes, int]:
        tasks = sorted(dict.fromkeys(each for every in questions.values() for each in every if each), key=_cost)
        found = work.all(outcome, tasks, FOLLOWING, lambda reason: NOTHING, until)
        compared_ = {k: [found.get(each, NOTHING) for each in every] for k, every in questions.items()}
        return compared_, len(tasks) - len(found)

    own, left = outcomes({k: sets.questions(k) for k in numbers})
    alone = [k for k, every in own.items() if not any(each.holding or each.failing for each in every)]
    behind, more = outcomes({k: sets.questions(k, later=True) for k in alone if sets.checks.formulas[k].display})
    for k, every in behind.items():
        own[k] = [replace(x, holding=y.holding, failing=y.failing) for x, y in zip(own[k], every, strict=True)]
    return own, left + more


def _cost(questions: tuple[Question, ...]) -> tuple[int, int]:
    """How long it takes to compare a relation: what stands written out in components takes ten times as long."""
    lists = {x for each in questions for x, phrase in each.letters if phrase in AS_NUMBERS}
    return len(lists), len(questions)


def with_proofs(own: Outcomes, work: Work, until: float = math.inf) -> tuple[Outcomes, int]:
    """The same with proofs, and how many were left; all but a few take longer than to compare."""
    tasks = dict.fromkeys(each.unproved for every in own.values() for each in every if each.unproved)
    proofs = work.all(_proved, sorted(tasks, key=len), FOLLOWING, lambda reason: None, until)
    found = {k: [replace(each, proof=proofs.get(each.unproved)) for each in every] for k, every in own.items()}
    return found, len(tasks) - len(proofs)


def outcome(questions: tuple[Question, ...]) -> Outcome:
    """How a relation compares with different sources, the smallest sets first."""
    compared_ = [*_compared(questions)]
    holding = tuple(
        dict.fromkeys(
            _with_what_it_takes(question, points) for question, points in compared_ if points and points.holds
        )
    )
    failing = dict.fromkeys(
        _with_what_it_takes(question, points)
        for question, points in compared_
        if points and not points.holds and not any({*question.where} < {*more.where} for more in holding)
    )
    unproved = tuple(question for question, points in compared_ if points is None or points.holds)[:ASKED]
    return Outcome(None, holding, tuple(failing), () if questions[0].kind == LATER else unproved)


def _with_what_it_takes(question: Question, found: Found) -> Question:
    """The question without sources that change nothing: relations say nothing for others, or against them, then.

    Of a relation that fails what is left must still bind all letters.
    """
    if len(question.sources) == 1:
        return question
    for n in range(len(question.sources)):
        where = question.where[:n] + question.where[n + 1 :]
        sources = question.sources[:n] + question.sources[n + 1 :]
        fewer = replace(question, where=where, sources=sources)
        less = fewer if found.holds else _without_idle(fewer)
        if less is None:
            continue
        points = compared(less.relation, less.where, less.letters, further=found.holds)
        if points is not None and points.holds == found.holds and points.bound:
            return _with_what_it_takes(less, found)
    return question


def _without_idle(question: Question) -> Question | None:
    """The same without sources that say nothing of it, unless words name them; None if there are no others."""
    if question.worded:
        return question
    rest = {*range(len(question.where))} - idle(question.relation, question.where, question.letters)
    where, sources = (tuple(every[n] for n in sorted(rest)) for every in (question.where, question.sources))
    return replace(question, where=where, sources=sources) if where else None


def _compared(questions: Sequence[Question]) -> Iterator[tuple[Question, Found | None]]:
    """The questions whose sources bind the letters of the relation, or may; of sets that hold none that is larger."""
    holding, done, count = list[frozenset[str]](), set[frozenset[str]](), 0
    for question in questions:
        least = _without_idle(question)
        where = frozenset(least.where if least else question.where)
        if any(each <= where for each in holding):
            continue
        points = compared(least.relation, least.where, least.letters) if least else None
        if least and points is None and (numbers := _of_numbers(least)):
            least, points = numbers, compared(numbers.relation, numbers.where, numbers.letters)
        if least is None or points is None:  # to prove it, rates may be needed
            yield question, None
            count += 1
        elif points.bound and where not in done:
            yield least, points
            count += 1
        done.add(where)
        if points is not None and points.holds and points.bound:
            holding.append(where)
        if count == COMPARED:
            return


def _of_numbers(question: Question) -> Question | None:
    """The same with numbers for vectors and matrices, which may have one row and one column.

    Some texts say of a letter what it is for the first time where it is written out, and then not of all that equal it.
    """
    if any(WRITTEN_OUT.search(text) for text in (question.relation, *question.where)):
        return None
    letters = tuple((x, AS_NUMBERS.get(phrase, phrase)) for x, phrase in question.letters)
    return replace(question, letters=letters) if letters != question.letters else None


def _proved(questions: tuple[Question, ...]) -> Question | None:
    """The first of these that is proved."""
    with suppress(OutOfTime), limited(FOLLOWING):
        return next((question for question in questions if _verdict(question) is Status.PROVED), None)
    return None


@dataclass(frozen=True)
class Slip:
    """A relation that holds after a slip of the pen, at points where its sources hold, and of how many others too."""

    question: Question
    repaired: int


def _slip(question: Question) -> str:
    """The relation after the likeliest slip with which it holds; "" if none is found."""
    with suppress(OutOfTime), limited(SLIPS):
        points = compared(question.relation, question.where, question.letters, further=True)
        if points is not None and points.holds:
            return ""
        if points is not None and points.bound:
            return next(slips(question.relation, question.where, question.letters), "")
        found = ""
        with suppress(OutOfTime), limited(UNBOUND):
            found = next(slips(question.relation, question.where, question.letters), "")
        return found or next(slips_of_source(question.relation, question.where, question.letters), "")
    return ""


def _explaining(task: tuple[tuple[tuple[Question, str], ...], tuple[Question, ...]]) -> Slip:
    """The first of some slips in one relation, of refuted ones first, and with how many sets it holds then."""
    found, questions = task
    refuted = (each for each in found if len(found) > 1 and _verdict(each[0]) is Status.REFUTED)
    question, text = next(refuted, found[0])
    return Slip(question, sum(_holds(replace(each, relation=text)) for each in questions))


def _holds(question: Question) -> bool:
    """Does the relation hold where its sources do, or one of these by the relation and the others?"""
    points = compared(question.relation, question.where, question.letters, further=True)
    if points is not None and (points.holds or points.bound):
        return points.holds
    return is_source(question.relation, question.where, question.letters)


def exchanged(question: Question, place: Place) -> Question:
    """The same, about the relation of one of its sources, which its own takes the place of."""
    own, *others = question.places
    if place == own:
        return question
    others.remove(place)
    sources, where = zip(*others, own, strict=True)
    return replace(question, number=place[0], relation=place[1], where=where, sources=sources)


def _verdict(question: Question) -> Status:
    with suppress(OutOfTime), limited(ATTEMPT):
        said = dict(question.letters)
        return answered(question.relation, question.where, (), said, wanted=False, all_sizes=False).verdict
    return Status.UNDECIDED


class Derived:
    """The sets of earlier equations from which each equation of a document may follow."""

    def __init__(self, checks: Checks, roles: Roles) -> None:
        self.checks, self.roles = checks, roles
        self.chapters = {f.scope[0]: f.chapter for f in checks.formulas}
        where = dict[str, set[int]]()  # by letter: the sections in which it stands
        for f, seen in zip(checks.formulas, checks.seen, strict=True):
            for letter in seen.names:
                where.setdefault(letter, set()).add(f.scope[0])
        every = zip(checks.formulas, checks.seen, strict=True)
        self.saying = {f.scope[0] for f, seen in every if any(len(where.get(x, ())) > 1 for x in seen.heads)}
        self.said = Counter(letter for seen in checks.seen for letter in seen.heads)
        # by letter, in a chapter and in all of the document: the sections that say what it is
        self.anew: dict[tuple[int | None, str], set[int]] = {}
        for f, seen in zip(checks.formulas, checks.seen, strict=True):
            for letter in seen.heads:
                for chapter in (f.chapter, None):
                    self.anew.setdefault((chapter, letter), set()).add(f.scope[0])
        self.functions = dict(_functions(checks.seen))
        words = [each.before for each in checks.formulas]
        self.named = [{*checks.named(k, " ".join(words[k : k + AROUND]))[1]} for k in range(len(words))]
        self.usable = {k: [*self._usable(k)] for k in range(len(checks.formulas))}
        self.stated = {k for k, every in self.usable.items() if every and self.is_said(k)}
        self.entries: dict[int, list[Definition]] = {}  # of printed matrices, by the formula that prints them
        for each in entries(checks.seen):
            numbers = (r for r in checks.seen[each.number].roles if r.kind == "scalar" and r.letter in each.latex)
            read = surveyed(each.latex, tuple((role.letter, role.phrase or "scalar") for role in numbers))
            link = next((x for x in read.links if x.head), None)
            if link is not None and self.usable[each.number]:
                own = replace(link, place=each.place)
                self.entries.setdefault(each.number, []).append(Definition(each.number, own))

    def _usable(self, k: int) -> Iterator[Definition]:
        """The equations of a formula that says something for good: more than the value of a letter in one case."""
        seen, formula = self.checks.seen[k], self.checks.formulas[k]
        if seen.reason or not seen.plain or any(self.said[x] > SAID for x in seen.names):
            return
        for link in seen.links:
            if (formula.display or max(link.sizes) >= SMALLEST) and not link.is_assignment:
                left, right = (names & (seen.names | link.bound) for names in link.names)  # and no numbers
                yield Definition(k, replace(link, names=(left, right)))

    def questions(self, k: int, later: bool = False) -> list[tuple[Question, ...]]:
        """For each equation of a formula those that ask whether it follows, from one set after the other.

        With `later`, whether it agrees with sets of those near to it, of which some stand behind it.
        """
        places = [*range(k - 1, -1, -1)]
        if later:
            places = [m for m in (*range(k + 1, k + 1 + FAR), *places[:FAR]) if m in self.usable]
        stated = self.stated | self.named[k]
        pool = [
            each
            for m in places
            if m in stated and self._serves(m, k)
            for each in (*self.usable[m], *self.entries.get(m, ()))
        ]
        found = []
        for each in self.usable[k]:
            sets = sorted(
                _closed(each, pool), key=lambda every: (len(every), sum(abs(k - one.number) for one in every))
            )
            sets = [every for every in sets if not later or any(one.number > k for one in every)]
            sets = [every for every in sets if sum(one.link.left == each.link.left for one in every) < SAME]
            own = self.checks.referred[k].sources if k in self.checks.referred and not later else ()
            named = tuple(every[0] for m in own if (every := self.usable.get(m)))
            if named:
                sets = [named, *(every for every in sets if every != named)]
            questions = [self._question(each, sources, LATER if later else "derived") for sources in sets]
            if sets and sets[0] == named:
                questions[0] = replace(questions[0], worded=True)
            found.append(tuple(questions))
        return found

    def _serves(self, m: int, k: int) -> bool:
        """Do the letters of a formula mean the same elsewhere? Not if many sections say anew what one of them is.

        In one that the words before or behind the other name they do.
        """
        if m in self.named[k]:
            return True
        names, own = self.checks.seen[m].names, self.roles.anew
        if names & (own[k] ^ own[m]) or not self.roles.is_same_choice(m, k, names):
            return False
        theirs, here = (self.checks.formulas[n].chapter for n in (m, k))
        within = here if theirs == here else None
        return self.roles.is_same_part(m, k) or all(len(self.anew.get((within, x), ())) <= ANEW for x in names)

    def _question(self, each: Definition, sources: Sequence[Definition], kind: str) -> Question:
        seen = [self.checks.seen[x.number] for x in (each, *sources)]
        said = self.checks.said(*seen, factors=True)
        own = {x: phrase for x, phrase in self.functions.items() if any(x in other.names for other in seen)}
        said = tuple((dict(said) | own).items())
        where, numbers = tuple(x.link.latex for x in sources), tuple(x.number for x in sources)
        return Question(each.number, each.link.latex, kind, where, numbers, letters=said)

    def is_said(self, k: int) -> bool:
        """Is a formula printed as something that holds, or follows?"""
        once = any(self.said[x] == 1 for x in self.heads(k))
        return k in self.checks.referred or self.checks.is_said(k, NAMING if once else DERIVED)

    def is_telling(self, question: Question, linked: Set[tuple[int, int]] = frozenset()) -> bool:
        """Is it something wrong if a relation fails, where letters mean the same in sections that are linked?"""
        return (
            (self.checks.formulas[question.number].display or self._is_entry(question))
            and self.is_said(question.number)
            and not self.may_differ(question, linked)
        )

    def _is_entry(self, question: Question) -> bool:
        """Does a relation say what the entry of a printed matrix is from which it does not follow?"""
        left = {each.link.head for m in question.sources for each in self.entries.get(m, ())}
        return any(
            link.latex == question.relation and link.head in left for link in self.checks.seen[question.number].links
        )

    def linked(self, holding: Iterable[tuple[Place, ...]]) -> set[tuple[int, int]]:
        """Pairs of sections of one chapter: of each of them a relation holds together with one of another.

        Where these all go together, a section that says of no letter of others what it is goes with them.
        """
        found = {k: {k} for k in self.chapters}  # by section: those linked to it
        for places in holding:
            for s, t in permutations({self.checks.formulas[m].scope[0] for m, _ in places}, 2):
                if self.chapters[s] == self.chapters[t]:
                    found[s] |= found[t]
                    for each in found[s]:
                        found[each] = found[s]
        for chapter in {*self.chapters.values()}:
            groups = {frozenset(found[s]) for s, own in self.chapters.items() if own == chapter}
            larger = [group for group in groups if len(group) > 1]
            for group in groups - {*larger} if len(larger) == 1 else ():
                for s in group - self.saying:
                    found[s] = {s, *larger[0]}
        return {(t, s) for s, group in found.items() for t in group}

    def nearly(self, holding: Iterable[tuple[Place, ...]]) -> tuple[set[int], set[int]]:
        """The formulas that hold exactly, and those that hold nearly: behind words that say so, or as these do.

        The part of the document that begins with such words goes with them; what stands before all of these is exact.
        """
        formulas = self.checks.formulas
        marks = [k for k, f in enumerate(formulas) if NEARLY.search(f.before) or NEAR.search(f.latex)]
        if not marks:
            return set(), set()
        exact = {*range(marks[0])}
        close = {k for m in marks for k in range(m, len(formulas)) if formulas[k].part == formulas[m].part} - exact
        open_, every = True, [{m for m, _ in places} for places in holding]
        while open_:
            more = {m for own in every for m in own if own & close and not own & exact} - close
            more_exact = {m for own in every for m in own if own & exact and not own & close} - exact
            open_ = bool(more or more_exact)
            close, exact = close | more, exact | more_exact
        return exact, close

    def _says_anew(self, k: int, heads: Set[str], m: int) -> bool:
        """Does a formula say of a letter of another one what it is, as another section does?"""
        section = self.checks.formulas[k].scope[0]
        return any(self.anew.get((None, x), set()) - {section} for x in heads & self.checks.seen[m].names)

    def _is_once(self, m: int, k: int) -> bool:
        """Does no letter of a formula mean something anew in another section of the chapter in which both stand?"""
        formulas, names = self.checks.formulas, self.checks.seen[m].names
        said = all(len(self.anew.get((None, x), ())) <= 1 for x in names)
        return said and formulas[m].chapter == formulas[k].chapter

    def heads(self, k: int) -> Set[str]:
        """The letters that a formula may define."""
        return self.checks.seen[k].heads.keys()

    def _lefts(self, k: int, equations: Set[str]) -> set[str]:
        """The left sides of these equations of a formula."""
        return {link.left for link in self.checks.seen[k].links if link.latex in equations}

    def may_differ(self, question: Question, linked: Set[tuple[int, int]] = frozenset()) -> bool:
        """May letters mean something else in a source, or does it say of a letter what a source says in another case?

        That is so where a source stands in another section, and is not the only one that says what a letter is, or
        says what the same letter is, alone or behind another heading; or what the same side of an equation is, alone.
        Equations of one display may be a system, which is to be solved.
        """
        k, formulas = question.number, self.checks.formulas
        known = {each.number for each in self.roles.known(k).values()}
        heads = {x for x, link in self.checks.seen[k].heads.items() if link.latex == question.relation}
        same = self._lefts(k, {question.relation}) & self._lefts(question.sources[0], {*question.where})
        if (alone := len(question.sources) == 1) and same:
            return True
        words, among = formulas[k].before, range(min(k, *question.sources), max(k, *question.sources) + 1)
        if words and all(formulas[m].before == words for m in among):
            return True
        return any(
            (
                (m not in known | self.named[k] or self._says_anew(k, heads, m))
                and not (self.roles.is_same_part(m, k) or beside)
            )
            or (((formulas[m].part != formulas[k].part and not beside) or alone) and heads & self.heads(m))
            for m in question.sources
            for beside in [(formulas[m].scope[0], formulas[k].scope[0]) in linked or self._is_once(m, k)]
        )


def _functions(seen: Iterable[Seen]) -> Iterator[tuple[str, str]]:
    """The functions that are said at several letters, each with the letters for which it is said for all values.

    Elsewhere its value at a place is said.
    """
    said: dict[str, dict[str, bool]] = {}
    for link in (link for each in seen for link in each.links):
        if head := _AT_LETTERS.fullmatch(link.left):
            letters = {x.strip() for x in head[2].split(",")}
            if letters <= link.names[0] and not link.chained:
                said.setdefault(head[1].strip(), {}).setdefault(head[2], letters <= link.names[1])
    for letter, places in said.items():
        every = {x.strip() for at in places for x in at.split(",")}
        first = next((at for at, general in places.items() if general), "")
        if len(places) > 1 and len(every) > 1 and first:
            yield letter, f"{OF}{first}"


def _closed(relation: Definition, pool: Sequence[Definition]) -> list[tuple[Definition, ...]]:
    """Sets of equations in which, with the relation, no letter stands once: what stands once cannot be eliminated.

    A letter on both sides of the relation may drop out there, or be eliminated like others. One that may have any value
    may stand once; so may what else a function is made of whose derivatives or integrals the relation is about.
    """

    def any_value(each: Definition) -> frozenset[str]:
        function = relation.link.operates and each.link.head and (each.link.bound or each.link.head in relation.names)
        return each.names - {each.link.head} if function else each.link.bound

    found: dict[tuple[Definition, ...], None] = {}
    done = set[frozenset[Definition]]()
    with_name: dict[str, list[Definition]] = {}
    for each in pool:
        for name in each.names:
            with_name.setdefault(name, []).append(each)

    def grow(own: Sequence[frozenset[str]], chosen: tuple[Definition, ...], most: int) -> None:
        if len(found) >= most or len(done) > MOST_STEPS:
            return
        count = Counter(name for names in (*own, *(each.names for each in chosen)) for name in names)
        free = relation.link.bound.union(*map(any_value, chosen))
        alone = sorted(name for name, times in count.items() if times == 1 and name not in free)
        if not alone:
            found.update({chosen: None} if chosen else {})
            return
        if len(chosen) == MOST_SOURCES:
            return
        choices = [[each for each in with_name.get(name, ()) if each not in chosen] for name in alone]
        for each in min(choices, key=len):
            more = frozenset((*chosen, each))
            if more not in done:
                done.add(more)
                grow(own, (*chosen, each), most)

    for own in (relation.link.names, (relation.names,)):
        done.clear()
        grow(own, (), len(found) + MOST_SETS)
    return [*found]


def blamed(
    sets: Derived,
    outcomes: Sequence[Outcome],
    shown: Iterable[tuple[Place, ...]],
    work: Work,
    end: float = math.inf,
) -> tuple[dict[int, Question], list[tuple[int, ...]]]:
    """The wrong relations, each with what it fails with, and those of which one is wrong, nobody knows which.

    Where relations fail together, the wrong one stands in most of them, and seldom in those that hold together; a slip
    of the pen explains it. The fewest that fail together say most, and are explained first, those that fail with what
    is printed before them before others. Relations that say the same are right together, and so is what follows from
    one alone: the line behind a wrong one is no witness for it. `shown` are others with their sources. When the time is
    over no more than the first ones are explained.
    """
    until = math.inf
    wrong, unlike = dict[int, Question](), list[tuple[int, ...]]()
    holding = [*(question.places for each in outcomes for question in each.holding), *shown]
    same = _same(holding)
    several = Counter(same[m] for m in {m for places in holding for m in places})
    linked = sets.linked(holding)
    failing = [question for each in outcomes for question in each.failing if sets.is_telling(question, linked)]
    failing = _comparable(failing, *sets.nearly(holding))
    near = {m for question in failing if sets.is_telling(question) for m in question.places}
    held, failed = (
        Counter(x for places in every for x in {same[m] for m in places})
        for every in ([each for each in holding if len(each) != 2], [question.places for question in failing])
    )
    right = {x for x, times in held.items() if times >= failed[x]}
    left = {question: {m for m in question.places if same[m] not in right} for question in failing}
    with suppress(OutOfTime):
        while left := {q: places for q, places in left.items() if places}:
            first = {q: places for q, places in left.items() if q.kind != LATER} or left
            least = min(len(question.sources) for question in first)
            now = {question: places for question, places in first.items() if len(question.sources) == least}
            votes = Counter(x for places in now.values() for x in {same[m] for m in places})
            share = {x: count / (count + held[x] + 1) for x, count in votes.items()}
            most = {x for x in votes if share[x] == max(share.values())}
            most &= _joined(min(most), [{same[m] for m in places} for places in left.values()])
            voted = {m for places in now.values() for m in places if same[m] in most}
            found = _explained(left, voted, same, work, until)
            beside = {m for slip in found.values() for m in _open(slip.question, same, right)} - found.keys()
            found |= _explained(left, {m for m in beside if same[m] not in most}, same, work, until)
            found = {m: slip for m, slip in found.items() if not held[same[m]] or m in near}
            best = max((slip.repaired for slip in found.values()), default=0)
            likeliest = {same[m] for m, slip in found.items() if slip.repaired == best}
            found = {m: slip for m, slip in found.items() if same[m] in likeliest}
            most |= {same[m] for m in found}
            done = {same[m] for m in found}
            never = {m: slip for m, slip in found.items() if not held[same[m]]}
            unlike_others = {m: slip for m, slip in never.items() if several[same[m]] < 2}
            likely = next((x for x in (never, unlike_others) if len({same[m] for m in x}) == 1), found)
            if len({same[m] for m in likely}) == 1 or len({m for m, _ in likely}) == 1:
                wrong |= {m: slip.question for (m, _), slip in likely.items()}
            elif done:
                unlike.append(tuple(sorted({m for m, _ in found})))
            left = {
                question: {m for m in places if same[m] not in most}
                for question, places in left.items()
                if not done & {same[m] for m in places}
            }
            until = end
    return wrong, unlike


def _comparable(failing: Sequence[Question], exact: Set[int], close: Set[int]) -> list[Question]:
    """The relations that fail where it counts: not what holds nearly with what holds exactly.

    What does not hold with either, and fails with both, is meant to hold nearly.
    """
    own = {question: {m for m, _ in question.places} for question in failing}
    close = close | {m for places in own.values() if places & close for m in places - exact}
    return [question for question, places in own.items() if not (places & exact and places & close)]


def _explained(
    left: Mapping[Question, Set[Place]], wanted: Set[Place], same: Mapping[Place, Place], work: Work, until: float
) -> dict[Place, Slip]:
    """The slips that explain why some of these relations fail with most of the others; OutOfTime if some are open."""
    tasks = {
        m: tuple(exchanged(question, m) for question, places in left.items() if m in places) for m in sorted(wanted)
    }
    first = {m: every[:EXPLAINED] for m, every in tasks.items()}
    open_ = dict.fromkeys(each for every in first.values() for each in every)
    texts = work.all(_slip, [*open_], SLIPS, lambda _: "", until)
    if len(texts) < len(open_):
        raise OutOfTime
    held = {m: tuple((each, texts[each]) for each in every if texts[each]) for m, every in first.items()}
    chosen = {m: (several, tasks[m]) for m, several in held.items() if several}
    told = work.all(_explaining, [*dict.fromkeys(chosen.values())], EXPLAINING, lambda _: None)
    found = {m: slip for m, task in chosen.items() if (slip := told[task]) is not None}
    most = {same[m] for m, slip in found.items() if 2 * slip.repaired > len(tasks[m])}
    return {m: slip for m, slip in found.items() if same[m] in most}


def _joined(first: Place, sets_: Sequence[Set[Place]]) -> set[Place]:
    """What stands in one of some sets with something, or with what stands in one with it, and so on."""
    found, more = set[Place](), {first}
    while more - found:
        found |= more
        more = {x for each in sets_ if found & each for x in each}
    return found


def _open(question: Question, same: Mapping[Place, Place], right: Set[Place]) -> Iterator[Place]:
    """The relations of a question that may be wrong."""
    return (m for m in question.places if same[m] not in right)


class _Same(dict[Place, Place]):
    """For each relation the first one that says the same; itself where nothing is known."""

    def __missing__(self, place: Place) -> Place:
        return place


def _same(holding: Iterable[tuple[Place, ...]]) -> Mapping[Place, Place]:
    """Of two relations, one holds where the other does, if nothing else is needed for that.

    One component alone does not say what a whole column does.
    """
    same = _Same()
    for places in holding:
        if len(places) == 2 and len({WRITTEN_OUT.search(text) is None for _, text in places}) == 1:
            first, second = sorted(same[place] for place in places)
            same.update({k: first for k, each in same.items() if each == second} | {second: first})
    return same
