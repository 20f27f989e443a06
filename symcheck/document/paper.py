"""The vocabulary of an audit whose relations are read from a source: each is named by its label, number or line."""

from __future__ import annotations

import os
import re
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cached_property
from itertools import islice
from pathlib import Path
from types import MappingProxyType, ModuleType
from typing import Any, TypeVar

from symcheck.core.claims import (
    Claim,
    Declaration,
    Definition,
    Erratum,
    Exclusion,
    Hypothesis,
    Paper,
    Plan,
    Premise,
    Section,
    Source,
    Statement,
)
from symcheck.core.verdicts import Reading, SymcheckError
from symcheck.document.asked import Inquiry, Relied
from symcheck.document.checks import MOST_CONDITIONS, nearest
from symcheck.document.kernels import kernel
from symcheck.document.letters import shown
from symcheck.document.lock import LOCK, UPDATE, digest, keys, load, located
from symcheck.document.printed import Printed
from symcheck.document.rewriting import Rule, rewritten
from symcheck.document.sources import source
from symcheck.document.units import of_letters
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.papers import key_of
from symcheck.proof import identity
from symcheck.reading import Notation
from symcheck.reading.evidence import spellings
from symcheck.reading.inference import inferred, notation_of

MANY = 5  # places that are named one by one
_TOKEN = re.compile(r"\\[A-Za-z]+|[^\s{}_^]")  # a command or a character; groups and scripts make no letter another one

D = TypeVar("D", bound=Declaration)


@dataclass(frozen=True)
class Said:
    """What is said of one letter."""

    letter: str
    phrase: str = ""
    meaning: str = ""
    unit: str = ""


def letter(letter: str, phrase: str = "", *, meaning: str = "", unit: str = "") -> Said:
    r"""Say what a letter is.

    Parameters
    ----------
    letter
        As it is printed: ``r"\omega"``.
    phrase
        What it is, as `symcheck.decide` takes it: "vector", "constant vector", "vector that depends on t", "matrix",
        "function of x", "depends on t", "integer". "" leaves it to be inferred.
    meaning
        What it stands for.
    unit
        Its unit; "1" of a pure number.

    Examples
    --------
    >>> letter("m", meaning="mass", unit="kg").unit
    'kg'
    """
    return Said(letter, phrase, meaning, unit)


class Document:
    """A source whose relations an audit names.

    Parameters
    ----------
    audit
        The file of the audit, ``__file__``; the lock lies beside it.
    file
        The source, as seen from there.
    letters
        What is said of its letters.
    rules
        Rules by which all relations are rewritten before they are read: ``r"X^{T} Y -> (X, Y)"``. X, Y and Z stand for
        letters, groups and brackets. The ledger calls what they change rewritten.
    """

    def __init__(self, audit: str, file: str, letters: Sequence[Said] = (), rules: Sequence[str] = ()) -> None:
        self.folder, self.file, self.said = Path(audit).resolve().parent, file, tuple(letters)
        self.rules = [*map(Rule.of, rules)]
        self.path = Path(os.path.normpath(self.folder / file))
        printed = source(self.path)
        self.formulas, self.told = printed.formulas, printed.told
        self.keys = keys(self.formulas)
        self.numbers = [*_numbers(self.formulas)]
        self.accepted = load(self.folder / LOCK)
        self.where = located(self.accepted, self.formulas)

    def definition(self, place: str, **said: Any) -> Definition:
        """Declare what a letter means.

        Parameters
        ----------
        place
            The label, "(number)" or "line ..." of the relation.
        **said
            As for `claim`, but for `imposed` and `errata`.
        """
        return Definition(**self._declared(place, **said))

    def premise(self, place: str, *, reason: str = "", **said: Any) -> Premise:
        """Declare what the source assumes, chooses or cites.

        Parameters
        ----------
        place
            The label, "(number)" or "line ..." of the relation.
        reason
            Why it is assumed, where that needs to be said.
        **said
            As for `claim`, but for `imposed` and `errata`.
        """
        return Premise(why=reason, **self._declared(place, **said))

    def exclusion(self, place: str, reason: str) -> Exclusion:
        """Declare that something printed asserts nothing decidable.

        Parameters
        ----------
        place
            The label, "(number)" or "line ..." of the relation.
        reason
            Why there is nothing to decide.
        """
        return Exclusion(why=reason, **self._declared(place))

    def claim(
        self,
        place: str,
        *,
        follows: Sequence[Declaration] = (),
        given: Sequence[str | Hypothesis] | None = None,
        imposed: str = "",
        stated: str = "",
        rules: Sequence[str] = (),
        errata: dict[str, Erratum] | None = None,
    ) -> Claim:
        r"""Declare a relation that the source asserts.

        Parameters
        ----------
        place
            The label, "(number)" or "line ..." of the relation.
        follows
            The earlier relations from which it follows; those from which these follow are added.
        given
            Conditions in LaTeX, such as ``"x > 0"`` or ``r"n \in \mathbb{N}"``. An empty list says that there are none:
            without it what fails is not refuted where a condition may be printed elsewhere.
        imposed
            Letters of the links that say what something is: "a" where `E = a + b = c` defines E.
        stated
            The same relation in other words, if what is printed cannot be read. The ledger says that it is yours.
        rules
            Rules for this relation, after those of the source.
        errata
            By link letter ("" for the only one): what a wrong relation should be.
        """
        declared = self._declared(place, follows=follows, given=given, stated=stated, rules=rules)
        statement = Statement(imposed=imposed)
        return Claim(statement=statement, plan=Plan(identity), errata=errata or {}, **declared)

    def kernel(
        self,
        relation: Claim,
        says: str,
        *,
        link: str = "",
        domain: Mapping[str, tuple[str, str]] = MappingProxyType({}),
        ulp: int = 4,
        condition: str = "",
    ) -> Kernel:
        r"""Make a function of arrays of an equation that says what a letter is; `symcheck generate` writes it.

        Parameters
        ----------
        relation
            The claim that prints `letter = formula` of numbers. If it is not proved, nothing is written.
        says
            One sentence about the function.
        link
            The letter of the link, of a chain: "b" for the second.
        domain
            By letter, as it is printed: both ends of the numbers that the function is for, ``("0", "pi/2")``, "" where
            there is none.
        ulp, condition
            The largest error in units of the last place, and why it exceeds 4.
        """
        return kernel(relation, link, says, self.notation, domain, ulp=ulp, condition=condition)

    def _declared(
        self,
        place: str,
        *,
        follows: Sequence[Declaration] = (),
        given: Sequence[str | Hypothesis] | None = None,
        stated: str = "",
        rules: Sequence[str] = (),
    ) -> dict[str, Any]:
        k = self._find(place)
        formula, letters = self.formulas[k], tuple((each.letter, each.phrase) for each in self.said)
        conditions = tuple(each if isinstance(each, str) else each.states for each in given or ())
        text, applied = rewritten(stated or formula.latex, [] if stated else [*self.rules, *map(Rule.of, rules)])
        reading = Reading.STATED if stated else Reading.REWRITTEN if applied else Reading.AS_PRINTED
        told = "; ".join(f"rewritten by {rule.text}" for rule in applied)
        units = tuple((x, each.unit) for x, each in of_letters(self.told, formula.scope).items()) + tuple(
            (each.letter, each.unit) for each in self.said if each.unit
        )
        relied = tuple(dict.fromkeys(each for item in follows for each in _relied(item)))
        return {
            "number": self.numbers[k],
            "source": Source(formula.line, (formula.latex,), file=self._file(formula)),
            "uses": tuple(item.number for item in follows),
            "question": Inquiry(
                text,
                relied,
                conditions,
                letters,
                reading,
                told,
                alone=given is not None,
                goes_on=formula.goes_on,
                units=units,
            ),
        }

    def _file(self, formula: Printed) -> str:
        """The file in which a relation stands, if that is another one, or a cell of it."""
        return f"{self.path.name}#{formula.cell}" if formula.cell else formula.file

    def _find(self, place: str) -> int:
        """The relation that is named."""
        if (k := self.where.get(place)) is not None:
            return k
        gone = next((each for each in self.accepted if each.key == place), None)
        if gone:
            raise SymcheckError(f"{self.path} has no {place} any more; it was {gone.latex}: take this line out")
        if place in self.keys:
            return self.keys.index(place)
        near = get_close_matches(place, self.keys, n=1)
        hint = f"did you mean {near[0]!r}?" if near else "name a label, a number as '(3)', or 'line 12'"
        raise SymcheckError(f"{self.path} has no relation {place!r}; {hint}")

    @cached_property
    def notes(self) -> tuple[str, ...]:
        """How the source differs from what was accepted."""
        return tuple(self._differences())

    def _differences(self) -> Iterator[str]:
        update = f"accept it with {UPDATE.format(self.folder)}"
        for each in self.accepted:
            k = self.where.get(each.key)
            if k is None:
                yield f"{self.path}: {each.place} is gone: it was {each.latex}; {update}"
            elif digest(self.formulas[k].latex) != each.digest:
                now = self.formulas[k]
                yield (
                    f"{self.path}:{now.line}: {now.place} has changed since it was accepted: "
                    f"was {each.latex}, is {now.latex}; {update}"
                )
        if moved := [key for key, k in self.where.items() if self.keys[k] != key]:
            first = f"{moved[0]} to {self.keys[self.where[moved[0]]]}"
            yield (
                f"{self.path}: {len(moved)} moved since it was accepted: {first}{', ...' if len(moved) > 1 else ''}; "
                f"{UPDATE.format(self.folder)} names them as they are now"
            )
        if new := [f.place for k, f in enumerate(self.formulas) if k not in self.where.values()]:
            shown_ = ", ".join(new[:MANY]) + (f" and {len(new) - MANY} more" if len(new) > MANY else "")
            yield f"{self.path}: new since it was accepted: {shown_}; add it with {UPDATE.format(self.folder)}"

    def paper(self, module: str, title: str) -> Paper:
        """Bind the ledger of the source.

        Parameters
        ----------
        module
            The module that names the relations, ``__name__``.
        title
            Authors, title and year.
        """
        return Paper(
            key=key_of(self.folder),
            title=title,
            source=self.file,
            notation=self.notation,
            sections=tuple(self._sections(vars(sys.modules[module]))),
            notes=self.notes,
        )

    @property
    def notation(self) -> Notation:
        """The letters with meaning and unit, as kernels and pages want them."""
        guesses = [guess for each in self.said for guess in _guessed(each)]
        return notation_of(guesses)

    def _sections(self, names: dict[str, Any]) -> Iterator[Section]:
        """What is declared, by the sections of the source; what is not of the source comes last."""
        section = {number: f.scope[0] for number, f in zip(self.numbers, self.formulas, strict=True)}
        declared = {name: item for name, item in names.items() if isinstance(item, Declaration)}
        claimed = {item.number for item in declared.values() if isinstance(item, Claim | Definition)}
        declared = {name: _with_its_letters(self._beside(item, claimed)) for name, item in declared.items()}
        last = max(section.values(), default=0)
        for k in range(last + 1):
            module = ModuleType(f"section_{k}")
            own = {n: item for n, item in declared.items() if section.get(item.number, last) == k}
            vars(module).update(own)
            if own:
                yield Section(str(k), "", module)

    def _beside(self, item: Declaration, claimed: set[str]) -> Declaration:
        """A claim with the relations beside it that may be its conditions, the nearest first."""
        if not isinstance(item.question, Inquiry) or not isinstance(item, Claim):
            return item
        k, used = self.numbers.index(item.number), set(item.uses)
        own = spellings(item.question.text, *item.question.assumed)
        near = (
            (self.formulas[m].place, rewritten(self.formulas[m].latex, self.rules)[0])
            for m in nearest(k, len(self.formulas))
            if self.formulas[m].scope[0] == self.formulas[k].scope[0] and self.numbers[m] not in claimed | used
        )
        beside = islice((each for each in near if spellings(each[1]) <= own), MOST_CONDITIONS)
        return replace(item, question=replace(item.question, near=tuple(beside)))


def _with_its_letters(item: Declaration) -> Declaration:
    """A declaration that is told of no letters but its own, so that another one that is edited leaves its answer valid.

    Who shares a command or a character with it may be one of its own.
    """
    asked = item.question
    if not isinstance(asked, Inquiry):
        return item
    errata = item.errata.values() if isinstance(item, Claim) else ()
    mended = (text for each in errata for text in (each.corrected, *(need.states for need in each.needs)))
    own = {token for text in (asked.text, *asked.assumed, *mended) for token in _TOKEN.findall(text)}
    letters, units = (
        tuple((letter, said) for letter, said in every if not own.isdisjoint(_TOKEN.findall(letter)))
        for every in (asked.letters, asked.units)
    )
    return replace(item, question=replace(asked, letters=letters, units=units))


def _guessed(said: Said) -> list[Any]:
    """What one letter is taken for; nothing if its name alone cannot be read. SymcheckError for what is said of it."""
    try:
        found = inferred([said.letter], {said.letter: said.phrase} if said.phrase else {}, {})[0].guesses
    except SymcheckError as error:
        if said.phrase and _guessed(replace(said, phrase="")):
            raise SymcheckError(f"letter {said.letter}: {error}") from error
        return []
    own = [guess for guess in found if shown(guess.letter.latex) == said.letter]
    return [replace(g, letter=replace(g.letter, meaning=said.meaning, unit=said.unit)) for g in own]


def _relied(item: Declaration) -> Iterator[Relied]:
    """What a relation that is relied on rests on, and itself."""
    if not isinstance(item.question, Inquiry):
        raise SymcheckError(f"{item.number} is not of a source; follows= names relations of the source")
    yield from item.question.follows
    asked, imposed = item.question, item.statement.imposed if isinstance(item, Claim) else ""
    yield Relied(asked.text, imposed)


def _numbers(formulas: Sequence[Printed]) -> Iterator[str]:
    """The number of each: as it is printed, else the last one before it and a counter. None ends in a small letter."""
    last, taken = "0", set[str]()
    count = Counter[str]()
    for formula in formulas:
        printed = re.sub(r"[^\w.]+", "", formula.number.partition(", ")[0], flags=re.ASCII).strip(".")
        number = re.sub(r"[a-z]+$", lambda found: found[0].upper(), printed)
        last = number or last
        while not number or number in taken:
            count[last] += 1
            number = f"{last}.{count[last]}"
        taken.add(number)
        yield number
