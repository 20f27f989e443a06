"""What a paper declares, and what a proof method is asked and answers: plain records, no algebra."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from types import ModuleType
from typing import TYPE_CHECKING

from symcheck.core.terms import Formula, Term
from symcheck.core.verdicts import Origin, Role, SymcheckError, Verdict

if TYPE_CHECKING:
    from symcheck.proof.rules.compute import Point
    from symcheck.proof.rules.proof import Proof
    from symcheck.reading import Notation


@dataclass(frozen=True)
class Hypothesis:
    """A named condition; `states` is LaTeX in the paper's notation, read by the same reader as the claims.

    `printed` is False for a condition that the paper never states but that its subject implies (a body has mass).
    """

    name: str
    words: str
    states: str
    printed: bool = True


@dataclass(frozen=True)
class Erratum:
    """What a wrong relation should be. The machine proves `corrected`; only kind, origin and reason are human.

    `shown` is what to print instead, where that is more than the statement: a whole row of a list.
    """

    corrected: str
    kind: str
    origin: Origin
    reason: str
    forms: tuple[str, ...] = ()  # hints for the proof of `corrected`
    shown: str = ""


@dataclass(frozen=True)
class Problem:
    """One lowered formula to decide: everything a proof method may know.

    `definitions` are (name, term) pairs in dependency order, to be unfolded; `hypotheses` maps a name to the
    formulas it states. `hints` come from the method's declaration and are never trusted.
    """

    id: str
    claim: Formula
    definitions: tuple[tuple[str, Term], ...] = ()
    hypotheses: tuple[tuple[str, tuple[Formula, ...]], ...] = ()
    hints: tuple[tuple[str, Term], ...] = ()


@dataclass(frozen=True)
class Outcome:
    """What a method answers: with a proof, a point of a refutation, or a reason."""

    verdict: Verdict
    proof: Proof | None = None
    point: Point | None = None
    used: tuple[str, ...] = ()
    reason: str = ""


@dataclass(frozen=True)
class Method:
    """A proof method with the hints of one claim; `decide` never raises on a statement it cannot decide."""

    name: str
    decide: Callable[[Problem], Outcome]
    hints: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, kw_only=True)
class Item:
    """One declaration of a paper's ledger: what is printed, what is given, how it is shown.

    number    the printed number, or for an unnumbered place the last number before it and a counter: "2.13.1"
    line      1-based line of the source text the printed form (or the sentence) begins on
    printed   verbatim LaTeX, one piece per displayed block it runs over
    words     what the paper says in words, in our English; `formal` is its LaTeX form, read by the same reader
    parts     what a list row, table row or sentence says that is several statements: their LaTeX forms, link by link
    read_as   the LaTeX to read where the printed text is damaged or says nothing, with the `reason`, the `kind` of the
              fault and whose it is (`origin`)
    given     hypotheses in force where it is printed; `needs` those the paper forgot
    by        the proof method, or one for each link letter
    where     names and their derived SymPy expressions, in force instead of the paper's own definitions
    equation  derived expressions E for a printed equation l = r: the claim is that l - r is E
    keeping   defined letters (variable stems) that stay free in this claim
    uses      numbers of the items this one refers to
    lines     by link letter: the line of a link that begins further on
    lemmas    numbers of earlier relations ("2.13.1b") the proof may start from, with the letters `free` not unfolded
    imposed   letters of the links that are conditions imposed rather than claims ("b" of "2.5b")
    opaque    a definition by something outside algebra (an angle between axes): it is not unfolded
    equality  for an inequality (or each link letter): where it is an equality, under given and `equality_given`
    errata    by link letter ("" for the only one): what the wrong relation should be
    notation  letters that mean something else here
    """

    number: str
    role: Role
    line: int
    printed: tuple[str, ...] = ()
    words: str = ""
    formal: str = ""
    parts: tuple[str, ...] = ()
    read_as: str = ""
    reason: str = ""
    kind: str = "damaged text"
    origin: Origin = Origin.OCR
    given: tuple[Hypothesis, ...] = ()
    needs: tuple[Hypothesis, ...] = ()
    by: Method | Mapping[str, Method] | None = None
    where: Callable[[], Mapping[str, object]] | None = None
    equation: Callable[[], tuple[object, ...]] | None = None
    keeping: tuple[str, ...] = ()
    uses: tuple[str, ...] = ()
    lines: Mapping[str, int] = field(default_factory=dict)
    lemmas: tuple[str, ...] = ()
    free: tuple[str, ...] = ()
    imposed: str = ""
    opaque: bool = False
    equality: str | Mapping[str, str] = ""
    equality_given: tuple[Hypothesis, ...] = ()
    errata: Mapping[str, Erratum] = field(default_factory=dict)
    notation: Notation | None = None
    name: str = ""


@dataclass(frozen=True)
class Section:
    """A section of a paper: the module that declares its items, in printed order."""

    number: str
    title: str
    module: ModuleType


@dataclass(frozen=True)
class Paper:
    """A paper: its notation and its sections. A number may be declared only once."""

    key: str
    title: str
    source: str
    notation: Notation
    sections: tuple[Section, ...]
    excerpt: bool = False  # only some pages are there, so that the printed numbers begin anywhere

    def items(self) -> Iterator[tuple[Section, str, Item]]:
        """Every declaration in printed order (by line), with the section and the variable it is bound to."""
        seen: dict[str, str] = {}
        for section in self.sections:
            declared = [
                (name, item)
                for name, bound in vars(section.module).items()
                for item in (bound if isinstance(bound, tuple) else (bound,))
                if isinstance(item, Item)
            ]
            for name, item in sorted(declared, key=lambda pair: pair[1].line):
                if item.number in seen:
                    raise SymcheckError(
                        f"{self.key}:{item.number} is declared twice, as {seen[item.number]} and {name}; "
                        "give one of them another number"
                    )
                seen[item.number] = name
                yield section, name, item
