"""One ledger row: what was printed, what the machine says of it, and the evidence."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec import UNSET, Struct, UnsetType, ValidationError, convert, field, to_builtins

from symcheck.core.ids import Id
from symcheck.core.verdicts import SLIPS, Group, Origin, Reading, Role, SymcheckError, Verdict
from symcheck.core.words import term
from symcheck.dimensions import Dimensions

if TYPE_CHECKING:
    from symcheck.core.certificates import Certificate, Point
else:
    Certificate = dict  # the fields of a certificate are left to the checker, which is strict and says what is wrong


class _Part(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What is read from JSON as it is declared: any other field, or a missing one, is an error."""


class Need(_Part, frozen=True):
    """Whether a proof needs a hypothesis, and what shows it: what is lost without it, or proofs that do without it."""

    needed: bool | None  # None: it is not known
    lost: str = ""  # a `Loss`
    counterexample: Certificate | None = None
    proofs: tuple[Certificate, ...] = ()

    @property
    def certificates(self) -> list[Certificate]:
        """Those of all that is said here."""
        return [*([self.counterexample] if self.counterexample else []), *self.proofs]


class HypothesisRow(_Part, frozen=True):
    """A hypothesis of a relation: where it comes from, and once that is decided whether it is needed."""

    name: str
    words: str
    states: str
    given: str
    need: Need | None = None


class Edit(_Part, frozen=True):
    """One place where the right form differs from the printed one."""

    printed: str
    corrected: str


class Repair(_Part, frozen=True):
    """A single edit of the printed relation that makes it true."""

    kind: str
    edit: str
    relation: str


class Later(_Part, frozen=True):
    """What becomes of a relation that rests on a wrong one."""

    id: str
    fate: str


class Correction(_Part, frozen=True):
    """What a wrong relation should be, with the proof of that, and which single edits repair it."""

    verdict: Verdict
    reason: str
    certificates: tuple[Certificate, ...]
    edit: tuple[Edit, ...]
    added: tuple[str, ...]  # hypotheses in words that the paper forgot
    repairs: tuple[Repair, ...] | None  # None: they were not searched
    unique: bool | None
    empty: bool  # true as printed, but it says nothing
    row: bool  # of a list row or a table cell, whose correction is the whole row
    summary: str = ""  # one sentence for the authors
    instead: str = ""  # what to print instead, for the authors
    later: tuple[Later, ...] | UnsetType = UNSET
    dimension: Dimensions | None = None  # of the right form


class Record(_Part, frozen=True):
    """One relation with its verdict.

    Parameters
    ----------
    id
        Place of the relation, "paper:number", with a letter for one link of a chain or system.
    paper, section, line, role
        Where it stands in the paper, and as what.
    name
        The variable it is bound to.
    printed, words, read
        The printed LaTeX, what the paper says in words, and the parsed form printed back as LaTeX.
    place
        The first and last word of the sentence that `words` puts in English, and its line.
    verdict
        None for a definition, premise or exclusion, which claims nothing.
    reading
        Whether it was read as printed, otherwise, from words, or is an addition of ours.
    kind, origin, reason
        What is wrong, whose fault it is, and why; the reason also of what is assumed or left out.
    hypotheses
        Hypotheses in force where it is printed.
    method
        The proof method.
    certificates
        One for each lowered formula.
    corrected, erratum
        What it should be, and the proof of that.
    uses, used_by
        Relations it refers to, and those that refer to it.
    seconds
        Time that it took to decide.
    dimension
        What its sides measure, and whether they fit; None for what states no relation.
    """

    id: str
    paper: str
    section: str
    line: int
    role: Role
    name: str = ""
    printed: str = ""
    words: str = ""
    read: str = ""
    place: str = ""
    verdict: Verdict | None = None
    reading: Reading = Reading.AS_PRINTED
    kind: str = ""
    origin: Origin | None = None
    reason: str = ""
    hypotheses: tuple[HypothesisRow, ...] = ()
    method: str = ""
    certificates: tuple[Certificate, ...] = field(default=(), name="certificate")
    corrected: str = ""
    erratum: Correction | None = None
    uses: tuple[str, ...] = ()
    used_by: tuple[str, ...] = ()
    seconds: float = 0.0
    dimension: Dimensions | None = None

    @property
    def number(self) -> str:
        """The id without the paper: "2.1V.3a"."""
        return Id.parse(self.id).place

    @property
    def declaration(self) -> str:
        """The id of the declaration, without the letter of the link."""
        return str(Id.parse(self.id).declaration)

    @property
    def link(self) -> str:
        """The letter of a link of a chain or system; empty for what stands alone."""
        return Id.parse(self.id).link

    @property
    def is_erratum(self) -> bool:
        """Whether it is wrong as printed, or read otherwise: every refutation, corrected or not."""
        return bool(self.corrected) or (self.verdict is Verdict.REFUTED and self.role is not Role.OURS)

    @property
    def group(self) -> Group | None:
        """Which errata it belongs to, if it is one."""
        if not self.is_erratum:
            return None
        if self.reading is Reading.DAMAGED:
            return Group.DAMAGED
        if self.kind in SLIPS:
            return Group.SLIP
        return Group.ROW if self.is_row else Group.STATEMENT

    @property
    def domain(self) -> dict[str, list[str]] | None:
        """The set over which a relation is proved, read off its certificates, never off the declaration.

        The hypotheses that proofs use (or that are in force where a lemma is used), and what must not vanish there.
        """
        if self.verdict is not Verdict.PROVED:
            return None
        proofs = [certificate for certificate in self.certificates if certificate.get("verdict") == Verdict.PROVED]
        names = {name for proof in proofs for name in proof.get("hypotheses", {})}
        conditions = {term(condition) for proof in proofs for condition in proof.get("nonzero", ())}
        return {"hypotheses": sorted(names), "nonzero": sorted(conditions)}

    @property
    def refutation(self) -> Certificate | None:
        """The first certificate that refutes it."""
        return next(
            (certificate for certificate in self.certificates if certificate.get("verdict") == Verdict.REFUTED), None
        )

    @property
    def counterexample(self) -> Point | None:
        """The point at which it fails."""
        return self.refutation.get("point") if self.refutation else None

    @property
    def is_row(self) -> bool:
        """Whether it is an erratum of a list row or a table cell, whose correction is the whole row."""
        return self.erratum is not None and self.erratum.row

    def refuse_wider(self) -> None:
        """SymcheckError if a proof uses a hypothesis that the record does not list: it would claim too much."""
        used = (self.domain or {}).get("hypotheses", ())
        if missing := set(used) - {hypothesis.name for hypothesis in self.hypotheses}:
            names = ", ".join(map(repr, sorted(missing)))
            raise SymcheckError(
                f"{self.id} is shown under {names}, which the record leaves out; list it in given= or needs="
            )

    def all_certificates(self) -> Iterator[Certificate]:
        """Every certificate it rests on: its own, those of what it should be, those of hypotheses left out."""
        yield from self.certificates
        yield from self.erratum.certificates if self.erratum else ()
        for hypothesis in self.hypotheses:
            yield from hypothesis.need.certificates if hypothesis.need else ()

    def to_json(self) -> dict[str, object]:
        """The record as plain JSON data, with what follows from it; "certificate" has one for each lowered formula."""
        data = to_builtins(self)
        for row in data["hypotheses"]:
            row |= row.pop("need") or {}
        return {**data, **self._derived()}

    @classmethod
    def from_json(cls, data: object) -> Record:
        """The inverse of `to_json`; SymcheckError if a field is missing, unknown or of an unknown value."""
        try:
            nested = convert(data, dict[str, object])
            nested["hypotheses"] = [*map(_nested, convert(nested.get("hypotheses", ()), list[dict[str, object]]))]
            derived = {name: nested.pop(name) for name in _DERIVED if name in nested}
            record = convert(nested, cls)
        except ValidationError as error:
            raise SymcheckError(f"a record cannot be read ({error}); delete the file and run again") from error
        if wrong := [name for name, value in record._derived().items() if name in derived and derived[name] != value]:
            raise SymcheckError(
                f"{record.id} has another {wrong[0]} than its certificates; delete the file and run again"
            )
        record.refuse_wider()
        return record

    def _derived(self) -> dict[str, object]:
        return {name: getattr(self, name) for name in _DERIVED}


def by_paper(records: Iterable[Record]) -> dict[str, list[Record]]:
    """The records of each paper, in the order in which the papers come."""
    papers: dict[str, list[Record]] = {}
    for record in records:
        papers.setdefault(record.paper, []).append(record)
    return papers


_DERIVED = ("counterexample", "group", "domain")  # written to JSON though it follows from the others


def _nested(row: Mapping[str, object]) -> dict[str, object]:
    """A row of hypotheses with what is said of its need apart, if anything is."""
    need = {name: value for name, value in row.items() if name in Need.__struct_fields__}
    return {name: value for name, value in row.items() if name not in need} | ({"need": need} if need else {})
