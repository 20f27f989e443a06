"""Theorems of the checker's table applied to terms: what they say of these, and the step of a proof that uses one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from symcheck.checker import theorems
from symcheck.core.calculus import Lambda, Unknown, letters, substituted
from symcheck.core.terms import Binder, Formula, Malformed, Node, Quantified, Term, mapped, node
from symcheck.core.verdicts import Certificate
from symcheck.proof.polynomial import unfold
from symcheck.proof.variables import Unsupported

HAVE = "have"  # no theorem, but used as one: what is proved once may be used often


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


class Theorem(NamedTuple):
    """The premises imply the conclusion."""

    premises: list[Formula]
    conclusion: Formula


def of(letter: str, term: Term) -> Lambda:
    """A term as a function of a letter."""
    return (letter,), term


def applied(name: str, *given: Term | Lambda) -> Instance:
    """A theorem applied to terms in the order of its parameters; the letter of the first function is the new one."""
    parameters = theorems.theorem(name).parameters
    functions = (argument for argument in given if not isinstance(argument, int | str | Node))
    return Instance(name, tuple(zip(parameters, given, strict=True)), next((own[0] for own, _ in functions), ""))


def congruence(s: Term, t: Term) -> Instance:
    """That a function has equal values at equal arguments."""
    return Instance("congruence", (("s", s), ("t", t)))


def enclosure(term: Term, digits: int, numbers: Mapping[str, Term]) -> Instance:
    """That a number lies between two decimals, where letters are these numbers."""
    return Instance("enclosure", (("t", term), ("digits", digits)), "", tuple(numbers.items()))


def have(formula: Formula) -> Instance:
    """That a formula that has a proof is true."""
    return Instance(HAVE, (("formula", formula),))


def theorem_of(instance: Instance, definitions: Mapping[str, Term]) -> Theorem:
    """What a theorem says of the terms it is applied to; Unsupported if it says nothing of such terms."""
    if instance.name == HAVE:
        ((_, formula),) = instance.given
        return Theorem([formula], formula)  # type: ignore[list-item, arg-type]
    given = {parameter: _unfolded(argument, definitions) for parameter, argument in instance.given}
    try:
        premises, conclusion = theorems.instance(instance.name, given, dict(instance.numbers))
    except (Malformed, Unknown) as error:
        raise Unsupported(str(error)) from error
    return Theorem([_opened(premise, instance.letter) for premise in premises], _opened(conclusion, instance.letter))


def _unfolded(argument: Term | Lambda, definitions: Mapping[str, Term]) -> Term | Lambda:
    if isinstance(argument, int | str | Node):
        return unfold(argument, definitions)
    own, body = argument
    return own, unfold(body, {name: term for name, term in definitions.items() if name not in own})


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


def step(instance: Instance, premises: Sequence[Certificate], then: Certificate) -> Certificate:
    """The step of a proof: proofs of the premises, and the rest with one fact more."""
    return {"rule": "theorem", "of": instance, "premises": [*premises], "then": then}
