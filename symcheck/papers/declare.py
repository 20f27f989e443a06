"""The vocabulary of a ledger: claim, definition, premise, exclusion, ours; and scopes, which say a thing once for many.

A text is LaTeX, or several pieces of it: of a printed form one for each displayed block, of `states` one for each link.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Self, TypeAlias

from symcheck.core.claims import (
    Claim,
    Damage,
    Declaration,
    Definition,
    Derived,
    Equations,
    Erratum,
    Exclusion,
    Hypothesis,
    Ours,
    Plan,
    Premise,
    Source,
    Statement,
)
from symcheck.core.problems import Method
from symcheck.proof import cases, identity
from symcheck.reading import Notation

Text: TypeAlias = str | Sequence[str]
Methods: TypeAlias = Method | Mapping[str, Method]


@dataclass(frozen=True)
class Scope:
    """What is in force in a run of declarations, unless one of them says otherwise.

    notation  letters that mean something else than in the rest of the paper
    where     names and their derived expressions, in force instead of the paper's own definitions
    by        the proof method
    keeping   defined letters that stay free
    free      defined letters that are not unfolded in the lemmas
    """

    notation: Notation | None = None
    where: Derived | None = None
    by: Methods = identity
    keeping: Sequence[str] = ()
    free: Sequence[str] = ()

    @property
    def by_cases(self) -> Self:
        """The same with the method `cases()`."""
        return replace(self, by=cases())

    def claim(
        self,
        number: str,
        line: int,
        printed: Text = (),
        *,
        words: str = "",
        damage: Damage | None = None,
        lines: Mapping[str, int] | None = None,
        states: Text = (),
        given: Sequence[Hypothesis] = (),
        equation: Equations | None = None,
        imposed: str = "",
        equality: str | Mapping[str, str] = "",
        equality_given: Sequence[Hypothesis] = (),
        by: Methods | None = None,
        where: Derived | None = None,
        keeping: Sequence[str] = (),
        lemmas: Sequence[str] = (),
        free: Sequence[str] = (),
        uses: Sequence[str] = (),
        errata: Mapping[str, Erratum] | None = None,
        notation: Notation | None = None,
    ) -> Claim:
        """Declare a relation that the paper asserts.

        Parameters
        ----------
        number
            The printed number, or for an unnumbered place the last number before it and a counter: "2.13.1".
        line
            1-based line of the source text on which the printed form (or the sentence) begins.
        printed
            Verbatim LaTeX, one piece for each displayed block it runs over.
        words
            What the paper says in words, in English.
        damage
            What to read instead of a printed form that is damaged or says nothing.
        lines
            By link letter: the line of a link that begins further on.
        states
            LaTeX forms of what is said in words, in a list row or in a table, link by link.
        given
            Hypotheses in force where it is printed.
        equation
            Gives the derived expressions E of a printed equation l = r; the claim is that l - r is E.
        imposed
            Letters of the links that are conditions imposed rather than claims.
        equality
            Where an inequality (or each link of it) is an equality, under `given` and `equality_given`.
        equality_given
            Hypotheses in force only there.
        by
            The proof method with its hints, or one for each link letter; by default that of the scope, which is
            `identity` unless the scope names another.
        where
            Gives derived SymPy expressions by name, in force instead of the paper's own definitions.
        keeping
            Defined letters that stay free.
        lemmas
            Places of earlier relations that the proof may start from.
        free
            Defined letters that are not unfolded in the lemmas.
        uses
            Places of the relations it refers to.
        errata
            By link letter ("" for the only one): what a wrong relation should be.
        notation
            Letters that mean something else here.

        Examples
        --------
        >>> from symcheck.papers.declare import claim
        >>> claim("2.12", 316, r"\\cos^2 a + \\sin^2 a = 1").source.line
        316
        """
        return Claim(
            number=number,
            source=Source(line, _pieces(printed), words, damage, lines or {}),
            statement=Statement(_pieces(states), tuple(given), equation, imposed, equality, tuple(equality_given)),
            plan=self._plan(by, where, keeping, lemmas, free),
            errata=errata or {},
            uses=tuple(uses),
            notation=notation or self.notation,
        )

    def ours(
        self,
        number: str,
        line: int,
        *,
        words: str,
        states: Text,
        given: Sequence[Hypothesis] = (),
        equation: Equations | None = None,
        equality: str | Mapping[str, str] = "",
        equality_given: Sequence[Hypothesis] = (),
        by: Methods | None = None,
        where: Derived | None = None,
        keeping: Sequence[str] = (),
        lemmas: Sequence[str] = (),
        free: Sequence[str] = (),
        uses: Sequence[str] = (),
        notation: Notation | None = None,
    ) -> Ours:
        """Declare a statement that the paper does not print.

        Parameters
        ----------
        number
            As for `claim`.
        line
            The line of the source text that it belongs to.
        words, states, given, equation, equality, equality_given, by, where, keeping, lemmas, free, uses, notation
            As for `claim`.

        See Also
        --------
        claim : A relation that the paper asserts.
        """
        return Ours(
            number=number,
            source=Source(line, words=words),
            statement=Statement(_pieces(states), tuple(given), equation, "", equality, tuple(equality_given)),
            plan=self._plan(by, where, keeping, lemmas, free),
            uses=tuple(uses),
            notation=notation or self.notation,
        )

    def definition(
        self,
        number: str,
        line: int,
        printed: Text = (),
        *,
        words: str = "",
        states: str = "",
        damage: Damage | None = None,
        opaque: bool = False,
        notation: Notation | None = None,
    ) -> Definition:
        """Declare what a letter means; it is unfolded in every claim that contains the letter.

        Parameters
        ----------
        number, line, printed, words
            As for `claim`.
        states
            The LaTeX form of a definition in words.
        damage
            As for `claim`.
        opaque
            Whether it defines by something outside algebra (an angle between axes), and is not unfolded.
        notation
            As for `claim`.
        """
        source = Source(line, _pieces(printed), words, damage)
        return Definition(
            number=number, source=source, states=states, opaque=opaque, notation=notation or self.notation
        )

    def premise(
        self,
        number: str,
        line: int,
        printed: Text = (),
        *,
        words: str = "",
        states: str = "",
        damage: Damage | None = None,
        reason: str = "",
        notation: Notation | None = None,
    ) -> Premise:
        """Declare what the paper assumes, chooses or cites.

        Parameters
        ----------
        number, line, printed, words
            As for `claim`.
        states
            The LaTeX form of what is said in words.
        damage
            As for `claim`.
        reason
            Why it is assumed, where that needs to be said.
        notation
            As for `claim`.
        """
        source = Source(line, _pieces(printed), words, damage)
        return Premise(number=number, source=source, states=states, why=reason, notation=notation or self.notation)

    def exclusion(self, number: str, line: int, printed: Text = (), *, words: str = "", reason: str) -> Exclusion:
        """Declare that something printed asserts nothing decidable, with the reason.

        Parameters
        ----------
        number, line, printed, words
            As for `claim`.
        reason
            Why there is nothing to decide.
        """
        return Exclusion(number=number, source=Source(line, _pieces(printed), words), why=reason)

    def _plan(
        self,
        by: Methods | None,
        where: Derived | None,
        keeping: Sequence[str],
        lemmas: Sequence[str],
        free: Sequence[str],
    ) -> Plan:
        return Plan(
            by or self.by,
            where or self.where,
            tuple(keeping or self.keeping),
            tuple(lemmas),
            tuple(free or self.free),
        )


_paper = Scope()
claim, ours = _paper.claim, _paper.ours
definition, premise, exclusion = _paper.definition, _paper.premise, _paper.exclusion
by_cases = _paper.by_cases


def standing(
    number: str,
    line: int,
    hypothesis: Hypothesis,
    words: str,
    *,
    without: str = "",
    reason: str = "",
    notation: Notation | None = None,
) -> Premise:
    """Declare that a condition which the paper does not print is in force.

    Parameters
    ----------
    number, line, notation
        As for `claim`.
    hypothesis
        The condition.
    words
        Where it is in force, with {} for its own words.
    without
        Where it is shown what happens without it.
    reason
        Why it is assumed, if it follows from something else.
    """
    shown = reason or f"a standing condition of ours, not printed; what happens without it: {without}"
    said = words.format(hypothesis.words)
    return premise(number, line, words=said, states=hypothesis.states, reason=shown, notation=notation)


def _pieces(text: Text) -> tuple[str, ...]:
    return tuple(piece for piece in ((text,) if isinstance(text, str) else text) if piece)


def body(*items: Declaration | str) -> str:
    """The printed relations of several items as one conjunction, for a statement that refers to them.

    Numbered cases, printed `1). ...; 2). ...`, become a disjunction.
    """
    return r" \land ".join(_body(item if isinstance(item, str) else " ".join(item.source.printed)) for item in items)


def _body(latex: str) -> str:
    text = re.sub(r"\\(begin|end)\{(aligned|array|split)\}", "", latex)
    cases = re.split(r"\b\d+\)\.", text)
    parts = cases[1:] if len(cases) > 1 else cases
    layout = re.compile(r"^(\s|&|\\quad|\\\\)+|(\s|[.,;&]|\\quad|\\\\)+$")
    return "(" + r") \lor (".join(layout.sub("", part) for part in parts) + ")"
