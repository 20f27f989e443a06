"""Theorems of the checker's table applied to terms: what they say of these, and the step of a proof that uses one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from symcheck.checker import theorems
from symcheck.core.calculus import Lambda, Unknown, letters, substituted
from symcheck.core.formulas import sides
from symcheck.core.terms import Binder, Formula, Malformed, Node, Quantified, Term, mapped, node
from symcheck.proof.algebra.polynomial import unfold
from symcheck.proof.algebra.variables import Unsupported
from symcheck.proof.rules.every import Every
from symcheck.proof.rules.step import Step

ENCLOSURE = "enclosure"


class Said(NamedTuple):
    """The premises imply the conclusion."""

    premises: list[Formula]
    conclusion: Formula


class Instance(NamedTuple):
    """A theorem and what it is applied to.

    `letter` is new where it stands: a premise about all numbers is proved for it, a number that exists is called so.
    The premises of an enclosure are that letters are the `numbers`.
    """

    name: str
    given: tuple[tuple[str, Term | Lambda], ...] = ()
    letter: str = ""
    numbers: tuple[tuple[str, Term], ...] = ()

    @property
    def terms(self) -> Iterator[Term]:
        """What it speaks of; letters that are bound stand for themselves."""
        for _, argument in self.given:
            yield argument if isinstance(argument, int | str | Node) else argument[1]

    def said(self, definitions: Mapping[str, Term]) -> Said:
        """What it says of the terms it is applied to; Unsupported if it says nothing of such terms."""
        given = {parameter: _put(argument, definitions, unfold) for parameter, argument in self.given}
        try:
            premises, conclusion = theorems.instance(self.name, given, dict(self.numbers))
        except (Malformed, Unknown) as error:
            raise Unsupported(str(error)) from error
        return Said([_opened(premise, self.letter) for premise in premises], _opened(conclusion, self.letter))

    def at(self, mean: Mapping[str, Term]) -> Instance:
        """The theorem applied to other terms; its letter is new there, too."""
        given = tuple((parameter, _put(argument, mean, substituted)) for parameter, argument in self.given)
        numbers = tuple((letter, substituted(number, mean)) for letter, number in self.numbers)
        return self._replace(given=given, numbers=numbers)

    def step(self, premises: Sequence[Step], then: Step) -> Theorem:
        """The step of a proof: proofs of the premises, and the rest with one fact more."""
        stated = theorems.theorem(self.name).premises if self.name in theorems.NAMES else ()
        every = [isinstance(formula, Quantified) for formula in stated]
        smooth = self.name.startswith(theorems.SMOOTHLY)  # it has more premises than are stated, about all places
        every += [smooth] * (len(premises) - len(every))
        proofs = (
            Every((self.letter,), proof) if of_all else proof for of_all, proof in zip(every, premises, strict=True)
        )
        return Theorem(self, tuple(proofs), then)


@dataclass(frozen=True)
class Theorem(Step):
    """The premises of a theorem have proofs; its conclusion is one more fact. What it says to exist is named."""

    rule: ClassVar[str] = "theorem"
    instance: Instance
    premises: tuple[Step, ...]
    then: Step

    def json(self) -> object:
        name, given, letter, numbers = self.instance
        exists = name in theorems.NAMES and isinstance(theorems.theorem(name).conclusion, Quantified)
        return {
            "rule": self.rule,
            "of": name,
            "with": {parameter: _argument(argument) for parameter, argument in given},
            "then": self.then,
            "premises": self.premises,
            **({"letters": [letter]} if exists else {}),
            **({"numbers": dict(numbers)} if name == ENCLOSURE else {}),
        }

    def at(self, mean: Mapping[str, Term]) -> Theorem:
        own = {x: term for x, term in mean.items() if x != self.instance.letter}
        return Theorem(self.instance.at(own), tuple(each.at(mean) for each in self.premises), self.then.at(own))

    def speaks_of(self, definitions: Mapping[str, Term]) -> Iterable[Term]:
        premises, conclusion = self.instance.said(definitions)
        return [side for formula in (*premises, conclusion) for side in sides(formula)]


def _argument(argument: Term | Lambda) -> object:
    if isinstance(argument, int | str | Node):
        return argument
    (letter, *_), term = argument
    return {"letter": letter, "term": term}


def of(letter: str, term: Term) -> Lambda:
    """A term as a function of a letter."""
    return (letter,), term


def applied(name: str, *given: Term | Lambda) -> Instance:
    """A theorem applied to terms in the order of its parameters; the letter of the first function is the new one."""
    parameters = ("s", "t") if name == "congruence" else theorems.theorem(name).parameters
    functions = (argument for argument in given if not isinstance(argument, int | str | Node))
    return Instance(name, tuple(zip(parameters, given, strict=True)), next((own[0] for own, _ in functions), ""))


def congruence(s: Term, t: Term) -> Instance:
    """That a function has equal values at equal arguments."""
    return applied("congruence", s, t)


def enclosure(term: Term, digits: int, numbers: Mapping[str, Term]) -> Instance:
    """That a number lies between two decimals, where letters are these numbers."""
    return Instance(ENCLOSURE, (("t", term), ("digits", digits)), "", tuple(numbers.items()))


def _put(
    argument: Term | Lambda, mean: Mapping[str, Term], change: Callable[[Term, Mapping[str, Term]], Term]
) -> Term | Lambda:
    """The argument with terms put for letters, but for those that it binds."""
    if isinstance(argument, int | str | Node):
        return change(argument, mean)
    own, body = argument
    return own, change(body, {name: term for name, term in mean.items() if name not in own})


def _opened(formula: Formula, letter: str) -> Formula:
    """What is said of all or of one, of the letter; integrals and means over it, as those are that it is about."""
    if isinstance(formula, Quantified):
        return substituted(formula.body, {formula.bound[0]: letter})
    opened = _over(formula, letter) if letter else formula
    assert isinstance(opened, Node)
    return opened


def _over(tree: Term, letter: str) -> Term:
    """Integrals and means with this letter in place of their own."""
    if isinstance(tree, Binder) and letter not in letters(tree.body):
        return node(tree.tag, substituted(tree.body, {tree.letter: letter}), letter, *tree.outside)
    return mapped(tree, lambda part: _over(part, letter)) if isinstance(tree, Node) else tree
