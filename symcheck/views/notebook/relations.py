"""Relations as cells show them: as printed, as read, with verdict, hypotheses, certificates, steps of the proof."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence

from symcheck.audit import reasons
from symcheck.core.certificates import Certificate
from symcheck.core.counts import number_of
from symcheck.core.ids import Id
from symcheck.core.verdicts import Reading, Verdict
from symcheck.ledger import Record, digest_of, lemmas_of
from symcheck.views.model import Relation, condition
from symcheck.views.notebook.letters import aligned, split
from symcheck.views.notebook.output import Heading, Math, Output, Part, Prose, Table, Verbatim
from symcheck.views.notebook.records import decided, item, list_rows, records
from symcheck.views.steps import proof_lines

_LINES, _COLUMNS = 30, 150  # of a proof that is shown
_DIGEST = 12  # digits of a certificate's SHA-256
_FEW = 3  # certificates that are named


def claim(*ids: str) -> Output:
    """Relations as printed and as read, with verdict, method, hypotheses and certificates.

    id  "mirer2009:2.12", of one link of a chain "mirer2009:2.1b", or of a premise or definition
    """
    return Output(tuple(part for id in ids for part in _claim(records(id))))


def _claim(chain: Sequence[Record]) -> Iterator[Part]:
    first = chain[0]
    yield Heading(f"{title(first, whole=len(chain) > 1)} — {verdicts(chain)}")
    if first.words:
        yield Prose("", first.words)
    yield from statement(chain)
    yield from evidence(chain)


def title(record: Record, whole: bool = False) -> str:
    """Number, name and line of a relation, in Markdown; of the whole chain without the letter of its link."""
    id = Id.parse(record.id)
    return f"**({id.number if whole else id.place})** {Relation(record).name}, line {record.line}".replace("  ", " ")


def verdicts(chain: Sequence[Record]) -> str:
    """The verdict of each link in Markdown; a verdict that several links share is written once."""
    links_of: dict[str, list[str]] = {}
    for record in chain:
        links_of.setdefault(_verdict(record), []).append(letter(record))
    if len(links_of) == 1:
        return next(iter(links_of))
    return "; ".join(f"{', '.join(links)} {verdict}" for verdict, links in links_of.items())


def letter(record: Record) -> str:
    """The letter of a link of a chain, "(b)"; nothing for a relation that stands alone."""
    return f"({record.link})" if record.link else ""


def _verdict(record: Record) -> str:
    if record.verdict is None:
        return f"*{record.role}*"
    reading = "" if record.reading is Reading.AS_PRINTED else f", {record.reading}"
    return f"**{record.verdict}** by `{record.method}`{reading}"


def statement(chain: Sequence[Record], reread: bool = True) -> Iterator[Part]:
    """The printed form, once for all links, and what was read, where that is not simply the printed form.

    reread  False: not again what can be read in the printed form itself
    """
    declaration = item(chain[0].id)
    printed = declaration.source.printed
    legible = _is_latex("\n".join(printed)) or chain[0].reading is not Reading.DAMAGED
    if printed and legible:
        yield from (formula("printed" if n == 0 else "", each) for n, each in enumerate(printed))
    elif printed:
        yield Verbatim("printed, in the text at hand", "\n".join(printed))
    if declaration.stated or declaration.source.damage or not printed or (reread and len(decided(chain[0].id)) > 1):
        label = "read" if printed else "states"
        yield from (formula(f"{label} {letter(each)}".strip(), each.read) for each in chain if each.read)


def _is_latex(printed: str) -> bool:
    """Whether a damaged text can be typeset all the same: what a scanner left has other letters, and no commands."""
    return printed.isascii() and bool(re.search(r"\\[A-Za-z]", printed))


def formula(label: str, latex: str) -> Math:
    """A formula without the full stop or comma of its sentence, in several lines if it is long."""
    lines = split(" ".join(latex.split()).rstrip(",. "))
    return Math(label, lines[0] if len(lines) == 1 else aligned([f"& {line}" for line in lines]))


def evidence(chain: Sequence[Record]) -> Iterator[Part]:
    """The hypotheses, each with where it is given and whether it is needed, and the certificates."""
    if rows := {row.name: row for record in chain for row in record.hypotheses}:
        yield Prose("given", "; ".join(condition(row).line for row in rows.values()))
    if certificates := [each for record in chain for each in record.certificates]:
        yield Prose("certificate", digests(certificates))


def digests(certificates: Sequence[Certificate]) -> str:
    """The first digits of the digests of some certificates, how many there are, and their lemmas."""
    named = ", ".join(digest_of(each)[:_DIGEST] for each in certificates[:_FEW])
    more = f" and {len(certificates) - _FEW} more" if len(certificates) > _FEW else ""
    resting = sorted(lemmas_of(certificates))
    return f"sha256 {named}{more}" + (f", from {', '.join(resting)}" if resting else "")


def proof(id: str) -> Output:
    """The steps of a proof as its certificates have them, and what the independent checker says of each."""
    parts: list[Part] = []
    for record in records(id):
        parts.append(Heading(f"{title(record)} — {_verdict(record)}"))
        for each in record.certificates:
            lines = list(proof_lines(each)) or ["refuted at a point"]
            parts += [Verbatim("", "\n".join(_cut(lines))), Prose("checker", checked([each]))]
    return Output(tuple(parts))


def _cut(lines: Sequence[str]) -> Iterator[str]:
    for line in lines[:_LINES]:
        yield line if len(line) <= _COLUMNS else f"{line[: _COLUMNS - 1]}…"
    if len(lines) > _LINES:
        yield f"… {number_of(len(lines) - _LINES, 'more line')}"


def certificate(id: str) -> Output:
    """The first certificate of a relation as it is stored, in JSON."""
    [first, *_] = (each for record in records(id) for each in record.certificates)
    text = json.dumps(first, ensure_ascii=False, indent=1, sort_keys=True)
    return Output((Verbatim(first["id"], "\n".join(_cut(text.splitlines()))),))


def checked(certificates: Sequence[Certificate]) -> str:
    """What the checker says of some certificates and of their lemmas, asked now."""
    faults = [fault for each in certificates for fault in _faults(each)]
    if faults:
        return f"a certificate does not hold: {faults[0]}"
    count = len(certificates)
    return (
        f"certificate {digest_of(certificates[0])[:_DIGEST]} holds" if count == 1 else f"all {count} certificates hold"
    )


def _faults(certificate: Certificate) -> Iterator[str]:
    needed = [each for id in lemmas_of([certificate]) for record in records(id) for each in record.certificates]
    yield from filter(None, reasons((certificate, *needed)))


def rows(id: str, only_wrong: bool = False) -> Output:
    """The rows of a list or table, "ignatov2005:2.1V", each as printed with its verdict; or those that are wrong."""
    lines = []
    for found in list_rows(id):
        wrong = next((record for record in found if record.corrected), None)
        if wrong or not only_wrong:
            lines.append(_row(found, wrong))
    return Output((Table(("row", "as printed; below it what is right", "verdict", "fault"), tuple(lines)),))


def _row(chain: Sequence[Record], wrong: Record | None) -> tuple[str, ...]:
    first = chain[0]
    number = Id.parse(first.id).row
    said = {Relation(record).state for record in chain}
    verdict = str(Verdict.REFUTED) if Verdict.REFUTED in said else ", ".join(sorted(said))
    mark = "$" if first.printed else ""
    texts = [first.printed or first.words, *([wrong.corrected] if wrong else [])]
    printed = "\n".join(f"{mark}{' '.join(text.split())}{mark}" for text in texts)
    return number, printed, verdict, wrong.kind if wrong else ""
