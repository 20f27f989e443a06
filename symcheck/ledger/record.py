"""One ledger row: what was printed, what the machine says of it, and the evidence."""

from __future__ import annotations

from dataclasses import asdict, dataclass, fields
from typing import Any

from symcheck.core.verdicts import SLIPS, Certificate, Group, Origin, Reading, Role, SymcheckError, Verdict
from symcheck.ledger.domain import domain, refuse_wider


@dataclass(frozen=True, kw_only=True)
class Record:
    """One relation with its verdict. `id` is "paper:number", with a letter for one link of a chain or system."""

    id: str
    paper: str
    section: str
    line: int
    role: Role
    name: str = ""
    printed: str = ""
    words: str = ""
    read: str = ""  # the parsed form, printed back as LaTeX
    verdict: Verdict | None = None  # None: a definition, premise or exclusion, which claims nothing
    reading: Reading = Reading.AS_PRINTED
    kind: str = ""
    origin: Origin | None = None
    reason: str = ""
    hypotheses: tuple[
        dict[str, Any], ...
    ] = ()  # name, words, given ("printed" | "added"), needed (bool | None), lost, counterexample
    method: str = ""
    certificates: tuple[Certificate, ...] = ()  # one per lowered formula
    counterexample: Certificate | None = None
    corrected: str = ""
    erratum: dict[str, Any] | None = None  # edit, unique, repairs, certificates of the corrected form, row
    uses: tuple[str, ...] = ()
    used_by: tuple[str, ...] = ()
    seconds: float = 0.0

    @property
    def group(self) -> Group | None:
        """Which errata it belongs to, if it is one."""
        if not self.corrected:
            return None
        if self.reading is Reading.DAMAGED:
            return Group.DAMAGED
        if self.kind in SLIPS:
            return Group.SLIP
        return Group.ROW if self.is_row else Group.STATEMENT

    @property
    def domain(self) -> dict[str, list[str]] | None:
        """Over which set a proved relation was shown: hypotheses by name, and what must not vanish."""
        return domain(self.certificates) if self.verdict is Verdict.PROVED else None

    @property
    def is_row(self) -> bool:
        """Whether it is an erratum of a list row or a table cell, whose correction is the whole row."""
        return bool((self.erratum or {}).get("row"))

    def to_json(self) -> dict[str, Any]:
        """The record as plain JSON data, with group and domain; "certificate" has one for each lowered formula."""
        data = asdict(self)
        named = {"certificate" if key == "certificates" else key: value for key, value in data.items()}
        return {**named, "group": self.group, "domain": self.domain}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Record:
        """The inverse of `to_json`; SymcheckError if a field is missing, unknown or of an unknown value."""
        try:
            values = {"certificates" if key == "certificate" else key: value for key, value in data.items()}
            values.pop("group", None)  # these follow from the others
            values.pop("domain", None)
            if unknown := sorted(set(values) - {f.name for f in fields(cls)}):
                raise SymcheckError(f"a record has the unknown field {unknown[0]!r}; delete the file and run again")
            values["role"] = Role(values["role"])
            values["verdict"] = Verdict(values["verdict"]) if values.get("verdict") else None
            values["reading"] = Reading(values.get("reading", Reading.AS_PRINTED))
            values["origin"] = Origin(values["origin"]) if values.get("origin") else None
            for key in ("hypotheses", "certificates", "uses", "used_by"):
                values[key] = tuple(values.get(key, ()))
            record = cls(**values)
            if record.verdict is Verdict.PROVED:
                refuse_wider(record.id, record.certificates, record.hypotheses)
            return record
        except (KeyError, ValueError, TypeError) as error:
            raise SymcheckError(f"a record cannot be read ({error}); delete the file and run again") from error
