r"""Probabilities of events, by those of the cases that exclude one another: P(A \cup B) is that of A B, A B^c or A^c B.

What holds of the probabilities of all events holds of those of events among outcomes that are equally likely, with any
numbers of outcomes in the cases. What is left to trust is that, and that P(A|B) is P(A \cap B)/P(B).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations

from symcheck.core.verdicts import NoForm, SymcheckError
from symcheck.question.prepare import Asked, unlowered
from symcheck.reading import Tree, read, tex, to_latex
from symcheck.reading.tree import (
    Add,
    Call,
    Chain,
    Div,
    Given,
    Mul,
    Name,
    Number,
    Operated,
    children,
    nodes,
    with_children,
)

SIGNS = frozenset({"P", r"\mathbb{P}", r"\text{P}", r"\text{Prob}", "Pr"})
MOST = 4  # events: there are 2^n cases
LETTERS = ("n", "m", "w", "u", "v")
# an event, or that it does not take place: A, B_1, A^c, \bar{A}
_EVENT = re.compile(
    r"(?:(?P<over>\\(?:bar|overline)) ?\{ ?)?(?P<event>[A-Z](?:_(?:\w|\{\w+\}))?)(?(over) ?\})"
    r"(?P<above> \^ (?:c|C|\\complement|\{ (?:c|C|\\complement) \}))?"
)
# the sign of a probability before a bracket
_PRINTED = re.compile(r"(?<![A-Za-z])(?:P|Pr|Prob)\s*\}?\s*(?:\\[bB]igg?l?|\\left)?\s*\(")
# what hardly stands in the brackets of another function
_OF_EVENTS = re.compile(r"\\(?:cup|cap|setminus|mid|bar|overline)(?![A-Za-z])|\||\^\{?(?:c|C|\\complement)\}?\)")
Event = Callable[[frozenset[str]], bool]  # whether it takes place in a case


@dataclass(frozen=True)
class Cases:
    """Events, and the letter for the numbers of outcomes in their cases: for which take place together."""

    events: tuple[str, ...]
    letter: str

    @property
    def cases(self) -> list[frozenset[str]]:
        """The sets of events that take place together."""
        return [frozenset(case) for n in range(len(self.events), -1, -1) for case in combinations(self.events, n)]

    @property
    def names(self) -> list[Name]:
        numbers = range(1, len(self.cases) + 1)
        return [Name(f"{self.letter}_{k}" if k < 10 else f"{self.letter}_{{{k}}}") for k in numbers]

    @property
    def meant(self) -> dict[str, str]:
        """The number of which outcomes each letter is, as those of A B^c."""
        parts = (" ".join(x if x in case else f"{x}^c" for x in self.events) for case in self.cases)
        return {to_latex(name): f"outcomes of {part}" for name, part in zip(self.names, parts, strict=True)}

    def conditions(self) -> tuple[str, ...]:
        names = [to_latex(name) for name in self.names]
        return (*(rf"{name} \ge 0" for name in names), rf"{' + '.join(names)} > 0")

    def exclusive(self) -> tuple[str, ...]:
        """That no two of the events take place together."""
        return tuple(
            f"{to_latex(name)} = 0" for name, case in zip(self.names, self.cases, strict=True) if len(case) > 1
        )

    def independent(self) -> tuple[str, ...]:
        """That several of the events take place together as often as the product of their probabilities says."""
        several = [case for case in self.cases if len(case) > 1]
        each = {x: self.sum(_is(x)) for x in self.events}
        sides = ((self.sum(_all([*map(_is, case)])), Mul(tuple(each[x] for x in sorted(case)))) for case in several)
        return tuple(to_latex(Chain(pair, ("=",))) for pair in sides)

    def equal(self) -> tuple[str, ...]:
        """That the events are equally likely."""
        first, *others = (self.sum(_is(x)) for x in self.events)
        return tuple(to_latex(Chain((first, other), ("=",))) for other in others)

    def put(self, tree: Tree) -> Tree:
        """The same with shares of the outcomes for probabilities."""
        if isinstance(tree, Call) and _is_probability(tree):
            return self.probability(tree.arguments)
        if isinstance(tree, Name) and tree.letter in self.events:
            raise NoForm(f"{tree.letter} is an event, and no number")
        return with_children(tree, tuple(map(self.put, children(tree))))

    def probability(self, arguments: Sequence[Tree]) -> Tree:
        match arguments:
            case (Given(items, conditions, "|"),):
                below = _all([*map(self.event, conditions)])
                return Div(self.sum(_all([below, *map(self.event, items)])), self.sum(below))
        return self.sum(_all([*map(self.event, arguments)]))

    def event(self, tree: Tree) -> Event:
        match tree:
            case Name():
                letter, other = _event(tree)
                return _not(_is(letter)) if other else _is(letter)
            case Operated(r"\cup", left, right):
                return _not(_all([_not(self.event(left)), _not(self.event(right))]))
            case Operated(r"\cap", left, right):
                return _all([self.event(left), self.event(right)])
            case Operated(r"\setminus", left, right):
                return _all([self.event(left), _not(self.event(right))])
            case Mul(factors, ()):
                return _all([*map(self.event, factors)])
        raise NoForm(f"{to_latex(tree)} is no event")

    def sum(self, event: Event) -> Tree:
        """The probability of an event."""
        own = (name for name, case in zip(self.names, self.cases, strict=True) if event(case))
        return Div(Add((Number("0"), *own)), Add(tuple(self.names)))


@dataclass(frozen=True)
class Found:
    """A question about the numbers of outcomes in cases.

    Parameters
    ----------
    asked
        The question.
    cases
        The events.
    joint
        Whether several of them are said to take place together, as nobody does of those that exclude one another.
    single
        Whether the probability of one of them alone is printed, as nobody does of several that are equally likely.
    law
        Whether all sides are made of probabilities alone, or something is given: others say what probabilities are.
    """

    asked: Asked
    cases: Cases
    joint: bool
    single: bool
    law: bool

    def stricter(self) -> Iterator[tuple[str, Asked]]:
        """The same of events that authors may mean without saying so, with what is to be said then."""
        ways = [("are independent", self.cases.independent())]
        ways += [] if self.joint else [("exclude one another", self.cases.exclusive())]
        ways += [] if self.single else [("are equally likely", self.cases.equal())]
        for how, more in ways:
            yield f"{', '.join(self.cases.events)} {how}", replace(self.asked, given=(*self.asked.given, *more))


def in_cases(asked: Asked) -> Found | None:
    """The question about probabilities as one about numbers of outcomes; None if there are no events."""
    if not (_PRINTED.search(asked.relation) and _OF_EVENTS.search(asked.relation)):
        return None
    with suppress(SymcheckError, StopIteration):
        reading = unlowered(asked)[0]
        trees = [reading.tree, *(read(text, reading.inference.notation) for text in (*asked.where, *asked.given))]
        calls = [[part for part in nodes(tree) if isinstance(part, Call) and _is_probability(part)] for tree in trees]
        if not any(map(_is_of_events, calls[0])):
            return None
        events = sorted({event for several in calls for call in several for event in _events_of(call)})
        taken = {token for text in (asked.relation, *asked.where, *asked.given) for token in tex.texts(text)}
        cases = Cases(tuple(events), next(x for x in LETTERS if x not in taken))
        if len(events) > MOST:
            return None
        relation, *others = (to_latex(cases.put(tree)) for tree in trees)
        where, given = others[: len(asked.where)], others[len(asked.where) :]
        kept = tuple((x, phrase) for x, phrase in asked.letters if x not in {*events, *SIGNS})
        joint, law = any(map(_is_joint, calls[0])), _is_law(reading.tree) or any(calls[1:])
        single = any(len(call.arguments) == 1 and isinstance(call.arguments[0], Name) for call in calls[0])
        return Found(Asked(relation, tuple(where), (*given, *cases.conditions()), kept), cases, joint, single, law)
    return None


def _is_probability(call: Call) -> bool:
    return (call.function.letter if isinstance(call.function, Name) else call.function) in SIGNS


def _is_of_events(call: Call) -> bool:
    """Does a probability have an argument that no function of numbers has?"""
    parts = [part for argument in call.arguments for part in nodes(argument)]
    return any(isinstance(part, Operated | Given) or (isinstance(part, Name) and _event(part)[1]) for part in parts)


def is_made_of(tree: Tree, is_own: Callable[[Tree], bool], is_number: Callable[[Tree], bool]) -> bool:
    """Is a term, or each side of a relation, made of some terms, among them one, and of numbers?"""
    if is_own(tree):
        return True
    below = children(tree)
    made = [is_made_of(each, is_own, is_number) for each in below]
    if isinstance(tree, Chain):
        return all(made)
    return any(made) and all(whole or is_number(each) for whole, each in zip(made, below, strict=True))


def _is_law(tree: Tree) -> bool:
    return is_made_of(
        tree, lambda part: isinstance(part, Call) and _is_probability(part), lambda part: isinstance(part, Number)
    )


def _is_joint(call: Call) -> bool:
    parts = [part for argument in call.arguments for part in nodes(argument)]
    both = any(isinstance(part, Given | Mul) or (isinstance(part, Operated) and part.sign == r"\cap") for part in parts)
    return both or len(call.arguments) > 1


def _events_of(call: Call) -> Iterator[str]:
    yield from (_event(part)[0] for each in call.arguments for part in nodes(each) if isinstance(part, Name))


def _event(name: Name) -> tuple[str, bool]:
    """The letter of an event, and whether it is printed as the one of its complement."""
    match = _EVENT.fullmatch(name.letter)
    if match is None or name.dots or name.primes > 1 or name.subscripts:
        raise NoForm(f"{to_latex(name)} is no event")
    return match["event"], bool(match["over"] or match["above"] or name.primes)


def _is(event: str) -> Event:
    return lambda case: event in case


def _not(event: Event) -> Event:
    return lambda case: not event(case)


def _all(events: Sequence[Event]) -> Event:
    return lambda case: all(event(case) for event in events)
