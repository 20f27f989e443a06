"""What a paper declares: where it stands, what it says, how it is shown, and what is wrong with it. No algebra."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from types import ModuleType
from typing import TYPE_CHECKING, ClassVar, Protocol, TypeAlias, TypeVar

from symcheck.core.ids import Id
from symcheck.core.problems import Method
from symcheck.core.verdicts import Origin, Role, SymcheckError

if TYPE_CHECKING:
    from symcheck.core.certificates import Certificate
    from symcheck.core.terms import Formula, Term
    from symcheck.ledger import Record
    from symcheck.reading import Notation

T = TypeVar("T", str, Method)
Derived: TypeAlias = Callable[[], Mapping[str, object]]
Equations: TypeAlias = Callable[[], tuple[object, ...]]


def for_letter(value: T | Mapping[str, T], letter: str) -> T | None:
    """What is declared for one link: the entry of its letter, or the one value for all."""
    return value.get(letter) if isinstance(value, Mapping) else value


@dataclass(frozen=True)
class Hypothesis:
    """A named condition.

    Parameters
    ----------
    name
        Name by which records refer to it.
    words
        The condition in words.
    states
        LaTeX in the paper's notation, read by the same reader as the claims.
    printed
        False for a condition that the paper never states but that its subject implies (a body has mass).
    """

    name: str
    words: str
    states: str
    printed: bool = True


@dataclass(frozen=True)
class Damage:
    """Printed text that is damaged or says nothing: what to read instead, why, and whose fault it is.

    `links` are the letters of the links that are damaged, where others are not.
    """

    read_as: str
    reason: str
    kind: str = "damaged text"
    origin: Origin = Origin.OCR
    links: str = ""

    def spares(self, letter: str) -> bool:
        """Whether a link is not damaged."""
        return letter not in self.links if self.links else False


@dataclass(frozen=True)
class Erratum:
    """What a wrong relation should be. The machine proves `corrected`; only kind, origin and reason are human.

    Parameters
    ----------
    corrected
        The right form in LaTeX; empty if the relation is right under the hypotheses that it `needs`.
    kind
        Kind of the error, as "sign".
    origin
        Whose fault it is.
    reason
        Why the relation is wrong.
    forms
        Hints for the proof of `corrected`.
    shown
        What to print instead, where that is more than the statement: a whole row of a list.
    needs
        Hypotheses that the paper forgot.
    summary
        One sentence for the authors: what is wrong and what is right, with formulas between dollar signs. Without it
        the first sentence of the reason.
    instead
        What to print instead, for the authors, where `corrected` is not written as the paper is.
    """

    corrected: str
    kind: str
    origin: Origin
    reason: str
    forms: tuple[str, ...] = ()
    shown: str = ""
    needs: tuple[Hypothesis, ...] = ()
    summary: str = ""
    instead: str = ""


@dataclass(frozen=True)
class Source:
    """Where a declaration stands in the paper, or belongs if it is ours.

    line     1-based line of the source text the printed form (or the sentence) begins on
    printed  verbatim LaTeX, one piece per displayed block it runs over
    words    what the paper says in words, in our English
    damage   what to read instead of the printed form
    lines    by link letter: the line of a link that begins further on
    file     the file, if it is another one than that of the paper
    """

    line: int
    printed: tuple[str, ...] = ()
    words: str = ""
    damage: Damage | None = None
    lines: Mapping[str, int] = field(default_factory=dict)
    file: str = ""

    @property
    def text(self) -> str | tuple[str, ...]:
        """What is read."""
        return self.damage.read_as if self.damage else self.printed


@dataclass(frozen=True)
class Statement:
    """What is claimed.

    states          LaTeX forms of what is said in words, in a list row or in a table, link by link; without them the
                    printed form is read
    given           hypotheses in force where it is printed
    equation        derived expressions E for a printed equation l = r: the claim is that l - r is E
    imposed         letters of the links that are conditions imposed rather than claims ("b" of "2.5b")
    equality        for an inequality (or each link letter): where it is an equality, under given and `equality_given`
    equality_given  hypotheses in force only there
    """

    states: tuple[str, ...] = ()
    given: tuple[Hypothesis, ...] = ()
    equation: Equations | None = None
    imposed: str = ""
    equality: str | Mapping[str, str] = ""
    equality_given: tuple[Hypothesis, ...] = ()

    def imposes(self, letter: str) -> bool:
        """Whether a link is a condition imposed."""
        return letter != "" and letter in self.imposed


@dataclass(frozen=True)
class Plan:
    """How it is shown.

    by       the proof method with its hints, or one for each link letter
    where    names and their derived SymPy expressions, in force instead of the paper's own definitions
    keeping  defined letters (variable stems) that stay free
    lemmas   places of earlier relations ("2.13.1b") that the proof may start from, with the letters `free` not unfolded
    """

    by: Method | Mapping[str, Method]
    where: Derived | None = None
    keeping: tuple[str, ...] = ()
    lemmas: tuple[str, ...] = ()
    free: tuple[str, ...] = ()

    @property
    def methods(self) -> tuple[Method, ...]:
        """All methods, link by link."""
        return tuple(self.by.values()) if isinstance(self.by, Mapping) else (self.by,)


class Stated(Protocol):
    """A statement: what it is, its hypotheses and definitions by name."""

    @property
    def what(self) -> str: ...

    @property
    def hypotheses(self) -> Mapping[str, list[Formula]]: ...

    @property
    def definitions(self) -> Mapping[str, Term]: ...


class Question(Protocol):
    """How a declaration is read and decided whose letters nobody has declared one by one."""

    def records(self, item: Declaration, base: Record) -> tuple[Record, ...]:
        """One for each relation that it prints."""
        ...

    def stated(self, item: Declaration, certificate: Certificate) -> Stated | None:
        """What is printed, read anew: that of which a certificate is one; None if it is none."""
        ...


@dataclass(frozen=True, kw_only=True)
class Declaration:
    """Anything declared of a paper.

    Parameters
    ----------
    number
        The printed number, or for an unnumbered place the last number before it and a counter: "2.13.1".
    source
        Where it stands in the paper.
    uses
        Places of the relations it refers to.
    notation
        Letters that mean something else here.
    name
        The variable it is bound to.
    question
        How it is read and decided, if not in the notation of the paper and by a method of its own.
    """

    role: ClassVar[Role]
    number: str
    source: Source
    uses: tuple[str, ...] = ()
    notation: Notation | None = None
    name: str = ""
    question: Question | None = None

    @property
    def stated(self) -> tuple[str, ...]:
        """LaTeX forms of what is said in words, link by link; without them the printed form is read."""
        return ()

    @property
    def text(self) -> str | tuple[str, ...]:
        """The LaTeX that is read."""
        return self.stated or self.source.text

    @property
    def reason(self) -> str:
        """Why it is read, assumed or left out as it is."""
        return self.source.damage.reason if self.source.damage else ""


@dataclass(frozen=True, kw_only=True)
class Definition(Declaration):
    """What a letter means; unfolded wherever the letter stands.

    states  the LaTeX form of a definition in words
    opaque  whether it defines by something outside algebra (an angle between axes), and is not unfolded
    """

    role = Role.DEFINITION
    states: str = ""
    opaque: bool = False

    @property
    def stated(self) -> tuple[str, ...]:
        return (self.states,) if self.states else ()


@dataclass(frozen=True, kw_only=True)
class Premise(Declaration):
    """What the paper assumes, chooses or cites; `states` is the LaTeX form of what is said in words."""

    role = Role.PREMISE
    states: str = ""
    why: str = ""

    @property
    def stated(self) -> tuple[str, ...]:
        return (self.states,) if self.states else ()

    @property
    def reason(self) -> str:
        return self.why or super().reason


@dataclass(frozen=True, kw_only=True)
class Exclusion(Declaration):
    """Something printed that asserts nothing decidable."""

    role = Role.EXCLUSION
    why: str

    @property
    def text(self) -> str | tuple[str, ...]:
        return ""

    @property
    def reason(self) -> str:
        return self.why


@dataclass(frozen=True, kw_only=True)
class Assertion(Declaration):
    """What there is to decide."""

    statement: Statement
    plan: Plan

    @property
    def stated(self) -> tuple[str, ...]:
        return self.statement.states

    def erratum(self, letter: str) -> Erratum | None:
        """What one link should be, if it is wrong."""
        return None

    @property
    def hypotheses(self) -> tuple[Hypothesis, ...]:
        """All it speaks of: those given, those the paper forgot, those of its sets of equality."""
        return (*self.statement.given, *self.statement.equality_given)


@dataclass(frozen=True, kw_only=True)
class Claim(Assertion):
    """A relation the paper asserts; `errata` are by link letter, "" for the only one."""

    role = Role.CLAIM
    errata: Mapping[str, Erratum] = field(default_factory=dict)

    def erratum(self, letter: str) -> Erratum | None:
        return self.errata.get(letter)

    @property
    def hypotheses(self) -> tuple[Hypothesis, ...]:
        needs = (hypothesis for erratum in self.errata.values() for hypothesis in erratum.needs)
        return (*self.statement.given, *needs, *self.statement.equality_given)


@dataclass(frozen=True, kw_only=True)
class Ours(Assertion):
    """A statement the paper does not print."""

    role = Role.OURS


@dataclass(frozen=True)
class Section:
    """A section of a paper.

    Parameters
    ----------
    number
        The printed number.
    title
        The title in English.
    module
        The module that declares its items, in printed order.
    """

    number: str
    title: str
    module: ModuleType


@dataclass(frozen=True)
class Paper:
    """A paper: its notation and its sections. A number may be declared only once.

    Parameters
    ----------
    key
        Author and year, as "mirer2009": the first part of every id.
    title
        Authors, title and year.
    source
        Name of the file with the text of the paper.
    notation
        What its letters mean.
    sections
        Its sections in printed order.
    excerpt
        Whether only some pages are there, so that the printed numbers begin anywhere.
    notes
        What a reader of its ledger has to know of the source, such as that it has changed.
    published
        Where and when it was published, as far as the text at hand tells.
    digest
        The beginning of the SHA-256 of the file with its text.
    """

    key: str
    title: str
    source: str
    notation: Notation
    sections: tuple[Section, ...]
    excerpt: bool = False
    notes: tuple[str, ...] = ()
    published: str = ""
    digest: str = ""

    def items(self) -> Iterator[tuple[Section, str, Declaration]]:
        """Every declaration in printed order (by line), with the section and the variable it is bound to."""
        seen: dict[str, str] = {}
        for section in self.sections:
            declared = [
                (name, item)
                for name, bound in vars(section.module).items()
                for item in (bound if isinstance(bound, tuple) else (bound,))
                if isinstance(item, Declaration)
            ]
            for name, item in sorted(declared, key=lambda pair: pair[1].source.line):
                if item.number in seen:
                    raise SymcheckError(
                        f"{Id(self.key, item.number)} is declared twice, as {seen[item.number]} and {name}; "
                        "give one of them another number"
                    )
                if Id.of(self.key, item.number).link:
                    raise SymcheckError(
                        f"{Id(self.key, item.number)} ends in a small letter, as links do; give it another number"
                    )
                seen[item.number] = name
                yield section, name, item
