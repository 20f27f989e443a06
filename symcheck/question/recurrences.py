"""Recurrences: what follows by induction from the first values of sequences and an equation for the next one.

A recurrence is said of all whole numbers from that of the first value on; a condition that its letter is whole and not
below some number is a condition of the claim. In each case of the induction the values of sequences are letters.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from symcheck.core.calculus import domain, functions, letters, nodes, substituted
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Call, End, Formula, Node, T, Term, mapped, node
from symcheck.proof.algebra.knowledge import larger_first
from symcheck.question.jets import calls_in
from symcheck.question.prepare import DEFINED, Asked, members

# a letter with a subscript, one in bold or with an accent, a Greek or a Latin one; or what is none
_SUBSCRIPT = re.compile(
    r"(?P<letter>\\[a-z]+\{\\?[A-Za-z]+\}|\\[A-Za-z]+|[A-Za-z])_(?:\{(?P<group>[^{}]*)\}|(?P<token>[A-Za-z0-9]))"
    r"|\\[A-Za-z]+|."
)
# one letter in brackets
_ARGUMENT = re.compile(r"\s*(?:\\left\s*)?\(\s*(\\?[A-Za-z]+)\s*(?:\\right\s*)?\)")
FIRST = 4  # whole numbers at which a claim is looked at: a false one mostly fails at the first or second
MOST = 8  # numbers by which places differ: of longer recurrences people print systems
_PLACE = re.compile(r"[A-Za-z](?:[+-]\d+)?|\d+")  # a subscript that moves along with a letter, or stands
AT, AHEAD = "at", "ahead"  # in names of values: at a number, and so many after the letter


def _name(function: str, kind: str, k: int) -> str:
    """The letter for a value of a sequence."""
    return f"{function}_{kind}_{k}" if k >= 0 else f"{function}_{kind}_minus_{-k}"


class Place(NamedTuple):
    """A place of a sequence: a whole number, or that many more than the letter."""

    moving: bool
    number: int


@dataclass(frozen=True)
class Induction:
    """The cases of a claim about all whole numbers from the first one on.

    Parameters
    ----------
    letter
        The letter of the whole numbers.
    first
        The least of them.
    order
        How many claims the next one rests on: they are shown at so many numbers.
    direct
        The claims at a number, by what is said of the values there and before.
    at
        The claims at one whole number.
    step
        The claims at the next whole number, if they hold at as many before it as the order says.
    """

    letter: str
    first: int
    order: int
    direct: tuple[Problem, ...]
    at: Callable[[int], tuple[Problem, ...]]
    step: tuple[Problem, ...]


def with_sequences(asked: Asked) -> Asked | None:
    """The same with places in brackets for subscripts that move along with a letter: x[n + 1] for x_{n+1}.

    The letter is a whole number then, and no index of a sum. None where no letter has such subscripts, and none but
    these and numbers.
    """
    texts = tuple(_without_arguments((asked.relation, *asked.where, *asked.given)))
    below: dict[str, set[str]] = {}
    for match in (match for text in texts for match in _SUBSCRIPT.finditer(text) if match["letter"]):
        below.setdefault(match["letter"], set()).add(match["group"] or match["token"])
    moving = {x: subscripts for x, subscripts in below.items() if all(map(_PLACE.fullmatch, subscripts))}
    named = {x for x, subscripts in moving.items() if any({"+", "-"} & {*each} for each in subscripts)}
    whole = sorted({each[0] for x in named for each in below[x] if each[0].isalpha()})
    if not named or any(re.search(rf"_\{{?{n}=", text) for n in whole for text in texts):
        return None

    applied = (
        _ARGUMENT.match(text, m.end()) for text in texts for m in _SUBSCRIPT.finditer(text) if m["letter"] in named
    )
    if any(applied):
        return None  # functions of several places, or factors

    def bracketed(match: re.Match[str]) -> str:
        return f"{match['letter']}[{match['group'] or match['token']}]" if match["letter"] in named else match[0]

    relation, *rest = (_SUBSCRIPT.sub(bracketed, text) for text in texts)
    texts = (asked.relation, *asked.where, *asked.given)
    if rest == [*texts[1:]]:
        return None  # of these sequences nothing is said: their values are letters like others
    where, given = tuple(rest[: len(asked.where)]), tuple(rest[len(asked.where) :])
    said = {**members(given, dict(asked.letters))[1], **dict(asked.letters)}
    more = tuple((n, "integer") for n in whole if not said.get(n))
    return Asked(relation, where, given, (*asked.letters, *more))


def _without_arguments(texts: Sequence[str]) -> Iterator[str]:
    """The same without a letter in brackets that stands behind all members of a sequence: P_n for P_n(x)."""
    places: dict[str, set[str]] = {}
    for text in texts:
        for found in _SUBSCRIPT.finditer(text):
            if found["letter"]:
                argument = _ARGUMENT.match(text, found.end())
                places.setdefault(found["letter"], set()).add(argument[1] if argument else "")
    applied = {x for x, several in places.items() if len(several) == 1 and several != {""}}
    for text in texts:
        ends = [found.end() for found in _SUBSCRIPT.finditer(text) if found["letter"] in applied]
        for end in reversed(ends):
            argument = _ARGUMENT.match(text, end)
            text = text[:end] + " " + text[argument.end() :] if argument else text
        yield text


def induction(problems: Sequence[Problem], whole: Iterable[str], conditions: Iterable[str] = ()) -> Induction | None:
    """The cases of an induction; None where no recurrence is given for the sequences of the claims.

    What is a condition, by the name of its hypothesis, may be meant for one place alone.
    """
    known = {*whole}
    claimed = {call for p in problems for call in calls_in(p.claim)}
    free = set().union(*map(letters, claimed)) & known
    hypotheses = [(name, f) for name, fs in problems[0].hypotheses for f in fs]
    free = free or {x for _, f in hypotheses for call in calls_in(f) for x in letters(call) & known}
    if not claimed or len(free) != 1 or any(functions(t) for p in problems for _, t in p.definitions):
        return None
    (n,) = free
    given = [(name, _of(n, part, known)) for name, f in hypotheses for part in conjuncts(f)]
    one = {*conditions}
    if any(name in one for name, f in given for _ in calls_in(f)):
        return None
    stated = [*(p.claim for p in problems), *(f for _, f in given)]
    if any(place_of(call, n) is None for f in stated for call in calls_in(f)):
        return None
    return _Sequences.of(problems, n, given)


UNIT = {"sum": 0, "product": 1}  # what those without addends or factors are
JOINED = {"sum": "+", "product": "*"}


def with_sums(problem: Problem, whole: Iterable[str]) -> Problem | None:
    """The same with sequences for sums and products up to a whole letter, of which a recurrence says what they are.

    None if there are none: the addends must not depend on that letter.
    """
    found = dict[Binder, tuple[str, str]]()

    def put(tree: T) -> T:
        if isinstance(tree, Binder) and tree.tag in UNIT and (n := _last(tree)) in known:
            name, _ = found.setdefault(tree, (f"{tree.tag}_{len(found) + 1}", n))
            return node("call", name, (0,), tree.outside[1])  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) and not tree.bound else tree  # type: ignore[return-value]

    known = {*whole}
    claim = put(problem.claim)
    if not found or any(map(functions, (problem.claim, *found))):
        return None
    hypotheses = list(problem.hypotheses)
    for total, (name, n) in found.items():
        ahead, now = (node("call", name, (0,), at) for at in (node("+", n, 1), n))
        step = node(JOINED[total.tag], now, substituted(total.body, {total.letter: node("+", n, 1)}))
        low = total.outside[0]
        assert isinstance(low, int)
        empty = node("call", name, (0,), low - 1)
        hypotheses.append((name, (node("=", ahead, step), node("=", empty, UNIT[total.tag]))))
    return replace(problem, claim=claim, hypotheses=tuple(hypotheses))


def _last(total: Binder) -> str:
    """The letter up to which a sum from a number on runs, perhaps a few places from it; "" if its addends have it."""
    low, high = total.outside
    inner = [part for part in nodes(total.body) if part.bound]
    if not isinstance(low, int) or isinstance(high, End) or len(letters(high)) != 1 or inner:
        return ""
    (n,) = letters(high)
    place = _place(high, n)
    return n if place is not None and place.moving and n not in letters(total.body) else ""


def _of(n: str, formula: Formula, whole: set[str]) -> Formula:
    """A recurrence in another letter as one in this letter: it is said of all whole numbers."""
    other = set().union(*map(letters, calls_in(formula))) & whole
    return substituted(formula, dict.fromkeys(other, n)) if len(other) == 1 and n not in letters(formula) else formula


def place_of(call: Call, n: str) -> Place | None:
    """The place of a sequence, if it is one."""
    return _place(call.terms[0], n) if call.orders == (0,) else None


def _place(at: Term, n: str) -> Place | None:
    """The place that a term says: a number, the letter, or that many more."""
    match at:
        case str(x) if x == n:
            return Place(True, 0)
        case int(k):
            return Place(False, k)
        case Node(tag="+", outside=(str(x), int(k)) | (int(k), str(x))) if x == n:
            return Place(True, k)
        case Node(tag="+", outside=(str(x), Node(tag="-", outside=(int(k),)))) if x == n:
            return Place(True, -k)
    return None


def _solved(left: Term, right: Term) -> tuple[Term, Term]:
    """An equation of a multiple of one value of a sequence, solved for that value."""
    factors = left.outside if isinstance(left, Node) and left.tag == "*" else ()
    calls = [k for k, factor in enumerate(factors) if isinstance(factor, Call)]
    rest = [factor for factor in factors if not functions(factor)]
    if len(calls) != 1 or len(rest) != len(factors) - 1:
        return left, right
    return factors[calls[0]], node("/", right, node("*", *rest) if len(rest) > 1 else rest[0])


@dataclass(frozen=True)
class _Rule:
    """An equation that says a value of a sequence by earlier ones of the same or of others, or by its number alone."""

    function: str
    top: int
    body: Term
    low: int  # the first place in it; the top where there is no other


class _Sequences:
    """The values of sequences from a first place on."""

    def __init__(self, problems: Sequence[Problem], n: str) -> None:
        self.problems, self.n = problems, n
        self.initial: dict[tuple[str, int], Term] = {}
        self.rules: dict[str, _Rule] = {}
        self.plain: list[tuple[str, Formula]] = []
        self.bounds: list[int] = []
        self.divisors: list[int] = []  # by how much they are ahead of the lowest place

    @classmethod
    def of(cls, problems: Sequence[Problem], n: str, given: Iterable[tuple[str, Formula]]) -> Induction | None:
        """The induction; None if an equation is no recurrence and no first value, or the letter is bounded above."""
        found = cls(problems, n)
        if not all(found._told(name, part) for name, part in given) or not found.rules or not found._sorted():
            return None
        places = [place for _, place in found._calls(*(p.claim for p in problems))]
        shifts = [place.number for place in places if place.moving]
        below = min([0, *shifts])
        lowest = min((k for _, k in found.initial), default=max([0, *found.bounds]) + below)
        first = max([lowest - below, *found.bounds])
        if any(lowest + ahead <= 0 for ahead in found.divisors):
            return None  # below the line is 0 where a rule is used
        if any(f in found.rules and found._is_said(found.rules[f], k, lowest) for f, k in found.initial):
            return None  # a value is said twice
        if first > max(found.bounds, default=first) or any(not k.moving and k.number < lowest for k in places):
            return None  # of what is before the first value nothing is said
        if not shifts:  # at numbers, to which the values are worked out
            last = max(place.number for place in places)
            direct = tuple(found._at(problem, last, lowest) for problem in problems)
            return Induction("", last, 0, direct, lambda number: direct, ()) if last - lowest <= MOST else None
        reach = max(shifts)
        order = max(rule.top - rule.low for rule in found.rules.values())
        if max(order, first - lowest, reach) > MOST:
            return None

        def at(number: int) -> tuple[Problem, ...]:
            return tuple(found._at(problem, number, lowest) for problem in problems)

        direct, step = (tuple(found._step(p, k, reach, first, min(shifts)) for p in problems) for k in (0, order))
        return Induction(n, first, order, direct, at, step)

    def _told(self, name: str, formula: Formula) -> bool:
        """Takes in what is given; False if nothing is known of such a formula here."""
        calls = list(self._calls(formula))
        moving = [(call, place.number) for call, place in calls if place.moving]
        if not calls:
            return self._condition(name, formula)
        if formula.tag != "=":
            return False
        for left, right in (_solved(*pair) for pair in (formula.terms, formula.terms[::-1])):
            if not isinstance(left, Call):
                continue
            place = place_of(left, self.n)
            assert place is not None
            if not moving and not functions(right) and self.n not in letters(right):
                return self.initial.setdefault((left.function, place.number), right) == right
            others = self._places(right)
            before = all(k.moving and k.number < place.number + (f != left.function) for f, k in others)
            if place.moving and before:
                low = min((k.number for _, k in others), default=place.number)
                rule = _Rule(left.function, place.number, right, low)
                return self._is_smooth(rule) and self.rules.setdefault(left.function, rule) == rule
        return False

    def _is_smooth(self, rule: _Rule) -> bool:
        """Whether a rule has a value wherever it is used: below the line, it has the letter and more at most."""
        if rule.low == rule.top:
            return True
        for condition in domain(rule.body, divisors=True):
            if functions(condition) or self.n in letters(condition):
                place = _place(condition.outside[0], self.n) if condition.tag == "!=" else None
                if place is None or not place.moving:
                    return False
                self.divisors.append(place.number - rule.low)
        return True

    def _condition(self, name: str, formula: Formula) -> bool:
        """A condition without sequences: of the letter it says from where on it runs."""
        if self.n not in letters(formula):
            self.plain.append((name, formula))
            return True
        match larger_first(formula):
            case Node(tag=">" | ">=" as sign, outside=(x, int(k))) if x == self.n:
                self.bounds.append(k + (sign == ">"))
                return True
        self.plain.append((name, formula))
        return name == DEFINED  # at each number what is printed has a value

    def _calls(self, *trees: Term) -> Iterator[tuple[Call, Place]]:
        for call in (call for tree in trees for call in calls_in(tree)):
            if (place := place_of(call, self.n)) is not None:
                yield call, place

    def _places(self, tree: Term) -> list[tuple[str, Place]]:
        return [(call.function, place) for call, place in self._calls(tree)]

    def _sorted(self) -> bool:
        """Sorts the rules, those first on whose values others rest at the same number; False if they go in a circle."""
        todo, done = self.rules, dict[str, _Rule]()
        while todo := {f: rule for f, rule in todo.items() if f not in done}:
            ready = {
                f: rule
                for f, rule in todo.items()
                if not any(k.number == rule.top and g in todo for g, k in self._places(rule.body))
            }
            if not ready:
                return False
            done |= ready
        self.rules = done
        return True

    def _is_said(self, rule: _Rule, k: int, lowest: int) -> bool:
        """Whether a rule says the value at a place, by values from the lowest place on."""
        return k - rule.top + rule.low >= lowest

    def _put(self, tree: T, kind: str, shift: int, by: Term) -> T:
        """A tree with letters for the values of sequences, their places moved, and for the letter something else."""

        def put(part: Term) -> Term:
            if isinstance(part, Call) and (place := place_of(part, self.n)) is not None:
                kind_, k = (kind, place.number + shift) if place.moving else (AT, place.number)
                return _name(part.function, kind_, k)
            return mapped(part, put) if isinstance(part, Node) else part

        found: T = put(tree)  # type: ignore[assignment, arg-type]
        return substituted(found, {self.n: by})

    def _at(self, problem: Problem, number: int, lowest: int) -> Problem:
        """A claim at a whole number, with all values up to it."""
        claim = self._put(problem.claim, AT, number, number)
        last = max([number, *(place.number + number for _, place in self._places(problem.claim) if place.moving)])
        said = dict[str, Term]()
        for k in range(lowest, last + 1):
            for function in dict.fromkeys((*self.rules, *(f for f, _ in self.initial))):
                name, rule = _name(function, AT, k), self.rules.get(function)
                if (term := self.initial.get((function, k))) is not None:
                    said[name] = term
                elif rule is not None and self._is_said(rule, k, lowest):
                    said[name] = self._put(rule.body, AT, k - rule.top, k - rule.top)
        return self._problem(problem, claim, said, self._conditions(lambda f: [self._put(f, AT, number, number)]))

    def _step(self, problem: Problem, order: int, reach: int, first: int, lowest: int) -> Problem:
        """A claim at so many numbers after the letter, by the same claims at all numbers between."""

        def moved(tree: T, shift: int) -> T:
            return self._put(tree, AHEAD, shift, node("+", self.n, shift) if shift else self.n)

        said = dict[str, Term]()
        for k in range(lowest, order + reach + 1):
            for function, rule in self.rules.items():
                if rule.low == rule.top or (k >= order and k - rule.top + rule.low >= lowest):
                    said[_name(function, AHEAD, k)] = moved(rule.body, k - rule.top)
        said |= {_name(function, AT, k): term for (function, k), term in self.initial.items()}
        before = tuple(moved(p.claim, shift) for shift in range(order) for p in self.problems)
        defined = self._conditions(lambda f: dict.fromkeys(moved(f, shift) for shift in range(order + 1)))
        hypotheses = (("earlier", before), ("whole", (node(">=", self.n, first),)), *defined)
        return self._problem(problem, moved(problem.claim, order), said, hypotheses)

    def _conditions(self, at: Callable[[Formula], Iterable[Formula]]) -> tuple[tuple[str, tuple[Formula, ...]], ...]:
        """The conditions without sequences, at the numbers of a case; those about numbers alone hold or are claimed."""
        found = dict[str, list[Formula]]()
        for name, formula in self.plain:
            found.setdefault(name, []).extend(f for f in at(formula) if letters(f))
        return tuple((name, tuple(formulas)) for name, formulas in found.items() if formulas)

    def _problem(
        self,
        problem: Problem,
        claim: Formula,
        said: Mapping[str, Term],
        hypotheses: tuple[tuple[str, tuple[Formula, ...]], ...],
    ) -> Problem:
        """The problem with what is needed of the values of sequences."""
        open_: list[Term] = [claim, *(f for _, fs in hypotheses for f in fs)]
        needed = dict[str, Term]()
        while open_:
            fresh = [x for x in letters(open_.pop()) if x in said and x not in needed]
            needed |= {x: said[x] for x in fresh}
            open_ += [said[x] for x in fresh]
        order = [x for x in said if x in needed]
        definitions = (*problem.definitions, *((x, needed[x]) for x in order))
        return replace(problem, claim=claim, definitions=definitions, hypotheses=hypotheses)
