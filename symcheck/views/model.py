"""What people read of records, worked out once; terminal, page, exports and notebooks only format it.

A relation with its hypotheses, counterexample, correction and proofs; errata in the order in which a reviewer wants
them, those of one kind together, the parts of one row as one. Nothing is decided here.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from symcheck.coq.confirmed import sentence, summary
from symcheck.core.certificates import Certificate
from symcheck.core.counts import number_of
from symcheck.core.ids import Id
from symcheck.core.terms import JSON
from symcheck.core.verdicts import Group, Loss, Origin, Reading, Role, Verdict
from symcheck.core.words import term
from symcheck.dimensions import CONSISTENT, INCONSISTENT
from symcheck.ledger import HypothesisRow, Record
from symcheck.views.dimensions import unlike
from symcheck.views.latex import is_formula, only_formula
from symcheck.views.steps import compared, coordinates, point, proof_lines, sides

_ORIGINS = (
    "read as they are printed",
    "read otherwise where the text is damaged",
    "read with what the auditor rewrote",
    "stated by the auditor",
    "put into formulas by us from the words",
    "added by us",
)
_GIVEN = {"added": "not printed, added", "standing": "implied by the subject"}  # the other sources are in plain words
_NEEDED = {True: "needed", False: "not needed", None: "not known whether needed"}
_WHOSE = {Origin.PAPER: "the paper's own", Origin.OCR: "from the digitisation"}
_REPAIRS = {0: "no single edit repairs it", 1: "one single edit repairs it"}
_BLAMED = (Origin.PAPER, Origin.UNCERTAIN, Origin.OCR)
_MARKUP = re.compile(r"\\(?:(?:left|right|cdot|q?quad)(?![A-Za-z])|[\\,;:! ])|[\s{}&$]")  # what is a space at most
_STOPS = ".,;"  # behind a formula
_ADDED = re.compile(r" \(given: .*\)$", re.DOTALL)  # how a record writes the conditions of a corrected formula


@dataclass(frozen=True)
class Counterexample:
    """The point at which a relation fails: letters with their values, and what is compared there, each named."""

    values: tuple[tuple[str, str], ...]
    compared: tuple[tuple[str, str], ...]
    sides: str  # the same in words, or what is known instead of two values
    equations: tuple[JSON, ...] = ()  # the values as formulas,
    facts: tuple[JSON, ...] = ()  # and what is shown of numbers that have no value in closed form

    @property
    def line(self) -> str:
        """In one line."""
        at = ", ".join(f"{name} = {value}" for name, value in self.values)
        return ", where ".join(filter(None, (at, self.sides)))


def counterexample(certificate: Certificate) -> Counterexample:
    """The point of a refutation."""
    found = certificate["point"]
    where = [*coordinates(found["values"])]
    at = ((f"{function} {name}".lstrip(), term(value)) for function, name, value in where)
    equations: list[JSON] = [["=", [function, name] if function else name, value] for function, name, value in where]
    both = [*map(term, compared(found))]
    of_parts = certificate["claim"][0] in ("and", "or")
    names = [f"part {number}" for number in range(1, len(both) + 1)] if of_parts else ["left side", "right side"]
    if certificate["claim"][0] == "=>":
        names = ["the condition", "what follows"]
    return Counterexample(
        tuple(at),
        tuple(zip(names, both, strict=False)),
        sides(found),
        tuple(equations),
        () if both else tuple(found.get("shown", ())),
    )


@dataclass(frozen=True)
class Condition:
    """A hypothesis: where it comes from, whether it is needed, and what is lost without it, if that is known."""

    words: str
    states: str
    given: str
    need: bool | None
    without: str

    @property
    def needed(self) -> str:
        """Whether it is needed, in words."""
        return _NEEDED[self.need]

    @property
    def line(self) -> str:
        """In one line, without what is lost."""
        return f"{self.words} ({self.given}, {self.needed})"


def condition(row: HypothesisRow) -> Condition:
    """A hypothesis in words."""
    need = row.need.needed if row.need else None
    given = _GIVEN.get(row.given, row.given)
    return Condition(row.words or row.name, row.states, given, need, _without(row))


def _without(row: HypothesisRow) -> str:
    """What is lost without a hypothesis, and where: "the relation fails at x = 2"; "" if that is not known."""
    if not row.need or not row.need.lost or not row.need.counterexample:
        return ""
    lost, certificate = row.need.lost, row.need.counterexample
    if lost == Loss.EXISTENCE:  # at an angle whose sine and cosine are defined as numbers
        angles = {name: value for name, value in certificate["definitions"] if type(value) is int}
        return f"{lost} where {point(angles)}"
    if lost == Loss.VALUE:
        return f"{lost} at {point(certificate['point']['values'])}: {term(certificate['claim'])} is wrong"
    return f"{lost} at {counterexample(certificate).line}"


@dataclass(frozen=True)
class Proof:
    """A certificate with what it is of."""

    of: str
    certificate: Certificate
    part: int = 0  # which one of the parts of a statement, such as the components of a vector; 0 where there is one
    parts: int = 1

    @property
    def title(self) -> str:
        """What it is of, and its verdict."""
        which = f"part {self.part} of {self.parts}, " if self.part else ""
        return f"{self.of}, {which}{self.certificate['verdict']}"

    @property
    def lines(self) -> str:
        """What the proof starts from, and its steps."""
        return "\n".join(proof_lines(self.certificate))


def _proofs(of: str, certificates: Sequence[Certificate]) -> Iterator[Proof]:
    """One for each certificate, numbered if there are several."""
    parts = len(certificates)
    for part, certificate in enumerate(certificates, 1):
        yield Proof(of, certificate, part if parts > 1 else 0, parts)


@dataclass(frozen=True)
class Relation:
    """A record as people read it."""

    record: Record

    @property
    def name(self) -> str:
        """The name of the declaration in words."""
        return self.record.name.replace("_", " ")

    @property
    def title(self) -> str:
        """Its id and name."""
        return f"{self.record.id}  {self.name}".rstrip()

    @property
    def state(self) -> str:
        """Its verdict, or the role of what claims nothing."""
        return str(self.record.verdict or self.record.role)

    @property
    def exposed(self) -> bool:
        """Whether its error shows in the dimensions, which the right form has right."""
        own, right = self.record.dimension, self.record.erratum.dimension if self.record.erratum else None
        return bool(own and own.verdict == INCONSISTENT and right and right.verdict == CONSISTENT)

    @property
    def reads_otherwise(self) -> bool:
        """Whether what is read differs by more than spaces, and the stop behind it, from what is printed."""
        record = self.record
        return _signs(record.read).rstrip(_STOPS) != _signs(record.printed).rstrip(_STOPS)

    @property
    def statement(self) -> str:
        """What it states: the link of a chain as read, else what is printed, or the words."""
        record = self.record
        return (record.read if record.link else "") or record.printed or record.words or self.name

    @cached_property
    def conditions(self) -> tuple[Condition, ...]:
        """The hypotheses."""
        return tuple(map(condition, self.record.hypotheses))

    @cached_property
    def counterexample(self) -> Counterexample | None:
        """Where it fails as printed."""
        return counterexample(self.record.refutation) if self.record.refutation else None

    @property
    def fails_at(self) -> str:
        """The same in one line, if there is such a point."""
        return self.counterexample.line if self.counterexample else ""

    @property
    def nonzero(self) -> str:
        """What must not vanish where it is proved."""
        return ", ".join(f"{each} ≠ 0" for each in (self.record.domain or {}).get("nonzero", ()))

    @property
    def proofs(self) -> tuple[Proof, ...]:
        """The certificates of the relation, then those of what it should be."""
        corrected = self.record.erratum.certificates if self.record.erratum else ()
        return (
            *_proofs("as printed", self.record.certificates),
            *_proofs("as corrected", corrected),
        )

    @property
    def coq(self) -> str:
        """What Coq says of the proofs."""
        return summary(self.record)

    @property
    def coq_says(self) -> str:
        """The same in a sentence."""
        return sentence(self.record)

    @property
    def whose(self) -> str:
        """Whose the fault is."""
        return _WHOSE.get(self.record.origin or Origin.UNCERTAIN, "whose it is cannot be told")

    @property
    def fault(self) -> str:
        """What is wrong with it, in a line: its name, the kind of fault, whose it is."""
        return ": ".join(filter(None, (self.name, ", ".join(filter(None, (self.record.kind, self.whose))))))

    @property
    def added(self) -> tuple[str, ...]:
        """The hypotheses that the paper forgot, in words."""
        return self.record.erratum.added if self.record.erratum else ()

    @property
    def edits(self) -> list[tuple[str, str]]:
        """Where the right form differs from the printed one, each place as (before, after)."""
        edits = self.record.erratum.edit if self.record.erratum else ()
        return [(edit.printed or "nothing", edit.corrected or "nothing") for edit in edits]

    @property
    def repairs(self) -> str:
        """How many single edits of the printed relation make it true; empty if they were not searched."""
        if not self.record.erratum or self.record.erratum.repairs is None:
            return ""
        count = len(self.record.erratum.repairs)
        return _REPAIRS.get(count, f"{count:,} single edits repair it")

    @property
    def outcome(self) -> str:
        """What was found of the correction."""
        erratum = self.record.erratum
        return f"{erratum.verdict} {erratum.reason}".rstrip() if erratum else ""


class Compared(NamedTuple):
    """Two formulas side by side: what the first one is, that one, and what is right instead."""

    label: str
    before: str
    after: str


class Fact(NamedTuple):
    """One labelled thing to say of a fault: a formula in LaTeX, or words; of ours, with formulas between dollars."""

    label: str
    text: str
    is_formula: bool = False
    is_ours: bool = False


@dataclass(frozen=True)
class Fault:
    """What is wrong at one place: one relation, or several parts of a row that are corrected together."""

    relations: tuple[Relation, ...]

    @property
    def first(self) -> Relation:
        """The relation that stands for all."""
        return self.relations[0]

    @property
    def number(self) -> str:
        """The number of the first relation, with the letters of the others: "2.1V.8a, b"."""
        return ", ".join([self.first.record.number, *(relation.record.link for relation in self.relations[1:])])

    @property
    def printed(self) -> str:
        """What is printed, or of it the link that is wrong, if that stands there as it is read; "" of mere words."""
        record = self.first.record
        is_part = not self._is_whole and bool(record.read) and _signs(record.read) in _signs(record.printed)
        return record.read if is_part else record.printed

    @property
    def _is_whole(self) -> bool:
        """Whether what is right replaces all that is printed: a row, or what is damaged."""
        return self.first.record.is_row or self.first.record.group is Group.DAMAGED

    @property
    def correct(self) -> str:
        """What is right instead, without the hypotheses that it needs."""
        return _ADDED.sub("", self.first.record.corrected)

    @property
    def compared(self) -> Compared:
        """What is wrong beside what is right: as printed where that has the same form, else as it was read."""
        record, printed = self.first.record, self.printed
        if self._is_whole or not record.read or printed == record.read:
            return Compared("printed" if printed else "words", printed or record.words, self.correct)
        instead = only_formula(record.erratum.instead) if record.erratum and is_formula(printed) else ""
        if instead and not record.link:
            return Compared("printed", printed, instead)
        return Compared("read as", record.read, self.correct)

    @property
    def instead(self) -> str:
        """What to print, for the authors, where that is not what is right itself."""
        instead = self.first.record.erratum.instead if self.first.record.erratum else ""
        return "" if only_formula(instead) == self.compared.after else instead

    @property
    def facts(self) -> Iterator[Fact]:
        """What is printed, where it fails, what is right."""
        record, compared = self.first.record, self.compared
        yield Fact("words", record.words if compared.label != "words" else "")
        yield Fact("in the text", record.place)
        yield Fact("printed", self.printed if compared.label != "printed" else "", is_formula=True)
        yield Fact(*compared[:2], is_formula=True)
        yield Fact("correct", compared.after, is_formula=True)
        yield Fact("to print", self.instead, is_ours=True)
        yield Fact("given", "; ".join(self.first.added))
        yield Fact("fails at", "" if record.is_row else self.first.fails_at)
        yield Fact("dimensions", unlike(record.dimension))
        yield Fact("why", record.reason, is_ours=True)


@dataclass(frozen=True)
class FaultList:
    """Faults of one place, kind and origin."""

    place: str
    faults: tuple[Fault, ...]

    @property
    def first(self) -> Relation:
        """The relation whose kind and origin all have."""
        return self.faults[0].first

    @property
    def title(self) -> str:
        """Where, what kind, and whose."""
        return f"{self.place}: {self.first.record.kind}, {self.first.whose}"

    @property
    def relations(self) -> list[Relation]:
        """Those of all faults."""
        return [relation for fault in self.faults for relation in fault.relations]

    @property
    def reasons(self) -> list[str]:
        """The reasons given, that of most relations first."""
        return [
            reason
            for reason, _ in Counter(relation.record.reason for relation in self.relations).most_common()
            if reason
        ]


def _signs(latex: str) -> str:
    r"""A formula without what is seen as a space at most.

    >>> _signs(r"\left( x_{1} \right) \cdot a") == _signs("(x_1)a")
    True
    """
    return _MARKUP.sub("", latex)


def errata(records: Iterable[Record]) -> Iterator[tuple[Group, tuple[FaultList, ...]]]:
    """The groups that have errata, the weightiest first; in each first the authors' own, on which most rests."""
    wrong = sorted((Relation(record) for record in records if record.is_erratum), key=_lightness)
    for group in Group:
        if members := [each for each in wrong if each.record.group is group]:
            yield group, tuple(_lists(members))


def _lightness(relation: Relation) -> tuple[int, int]:
    """By what errata of a group are ordered: whose they are, then how many relations use a statement."""
    record = relation.record
    used = len(record.used_by) if record.group is Group.STATEMENT else 0
    return _BLAMED.index(record.origin or Origin.UNCERTAIN), -used


def _lists(relations: Sequence[Relation]) -> Iterator[FaultList]:
    found: dict[tuple[str, object, object], list[Relation]] = {}
    for relation in relations:
        found.setdefault((place(relation.record), relation.record.kind, relation.record.origin), []).append(relation)
    for (where, *_), members in found.items():
        yield FaultList(where, tuple(_faults(members)))


def _faults(relations: Iterable[Relation]) -> Iterator[Fault]:
    rows: dict[tuple[object, ...], list[Relation]] = {}
    for relation in relations:
        record = relation.record
        row = record.declaration if record.verdict else record.id
        key = (row, record.line, Fault((relation,)).printed, record.corrected, record.reason)
        rows.setdefault(key, []).append(relation)
    yield from (Fault(tuple(members)) for members in rows.values())


def place(record: Record) -> str:
    """The list or table of a row, "ignatov2005:2.1V", or else the paper."""
    return listing(record) if record.is_row else record.paper


def listing(record: Record) -> str:
    """The list or table that a relation is about as a whole, or in one of its rows."""
    id = Id.parse(record.id)
    return str(id.listing if id.row.isdigit() else id.declaration)


def counted(records: Iterable[Record]) -> str:
    """How many relations have which verdict."""
    found = Counter(record.verdict for record in records if record.verdict)
    verdicts = ", ".join(f"{found[verdict]:,} {verdict}" for verdict in Verdict)
    return f"{number_of(found.total(), 'relation')}: {verdicts}"


def roles(counts: Mapping[Role, int] | Mapping[str, int]) -> str:
    """How many declarations have which role: "2 premises, 1 definition, 3 ours"."""
    return ", ".join(number_of(n, str(role), str(role) if role == Role.OURS else "") for role, n in counts.items())


def headline(records: Sequence[Record]) -> Iterator[str]:
    """How many relations have which verdict, where they come from, and whose errors are refuted: a line each."""
    yield counted(records)
    if "," in (said := origins(records)):  # nothing is to be told apart where all have one origin
        yield f"Of these: {said}"
    if blamed := blame(records):
        yield f"Refuted: {blamed}"
    if ":" in (wrong := erring(records)):  # otherwise the errata are what is refuted
        yield wrong


def origins(records: Iterable[Record]) -> str:
    """How many of the relations come from formulas, from words and from us."""
    found = Counter(map(_origin, (record for record in records if record.verdict)))
    return ", ".join(f"{found[origin]:,} {origin}" for origin in _ORIGINS if found[origin])


def _origin(record: Record) -> str:
    printed, damaged, rewritten, stated, words, ours = _ORIGINS
    if record.role is Role.OURS:
        return ours
    if not record.printed:
        return words
    return {Reading.DAMAGED: damaged, Reading.REWRITTEN: rewritten, Reading.STATED: stated}.get(record.reading, printed)


def erring(records: Iterable[Record]) -> str:
    """What is counted as an erratum: refutations of what is printed, and what is proved although it is misprinted."""
    wrong = [record for record in records if record.is_erratum and record.group is not Group.DAMAGED]
    if not wrong:
        return "no errata"
    refuted = sum(record.verdict is Verdict.REFUTED for record in wrong)
    said = number_of(len(wrong), "erratum", "errata")
    if refuted == len(wrong):
        return f"{said}, {'all ' if len(wrong) > 1 else ''}refuted"
    others = len(wrong) - refuted
    meant = "says nothing or is read as it" if others == 1 else "say nothing or are read as they"
    return f"{said}: {refuted:,} refuted, {others:,} that {meant} must be meant"


def blame(records: Iterable[Record]) -> str:
    """Whose errors the refuted relations are: "68 the paper's own, 98 from the digitisation, 27 cannot tell"."""
    found = Counter(record.origin for record in records if record.verdict is Verdict.REFUTED and record.origin)
    return ", ".join(f"{found[origin]:,} {_WHOSE.get(origin, origin)}" for origin in Origin if found[origin])
