"""The page: templates filled with entries, formulas, pictures; what is large is folded."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from symcheck import __version__
from symcheck.coq.confirmed import CONFIRMED, confirmed
from symcheck.core.counts import number_of
from symcheck.core.ids import Id
from symcheck.core.verdicts import Group, Role, Verdict
from symcheck.ledger import Record
from symcheck.ledger.changes import Change
from symcheck.ledger.selftested import evidence, rows
from symcheck.views.dimensions import fits, restored
from symcheck.views.model import Relation, blame, errata, erring, origins
from symcheck.views.page import entry as entries
from symcheck.views.page.entry import Entry
from symcheck.views.page.formulas import Formulas
from symcheck.views.page.graph import graph
from symcheck.views.page.marks import marks
from symcheck.views.page.meanings import COQ, MEANINGS, answer
from symcheck.views.page.packing import address, packed
from symcheck.views.page.plots import coloured, curves
from symcheck.views.page.sources import Excerpt, Meaning, Publication, of_record
from symcheck.views.steps import RULES, parts_of

ROLES = (Role.DEFINITION, Role.PREMISE, Role.EXCLUSION)  # what claims nothing
STATES = (*Verdict, *ROLES)
FONT = "stix-two-math.woff2"
TOLD = ("key", "title", "published", "source", "digest")  # of a paper
SCRIPTS = ("page.js", "terms.js", "own.js", "polytope.js")


@dataclass(frozen=True)
class Extras:
    """What the page shows apart from the records.

    Kernels, notebook cells and meanings of letters by claim, pictures as `symcheck.views.pictures` has them, the result
    of the self-test, the day on which the page is written, the name of an older ledger and what changed since it.
    """

    kernels: Mapping[str, Sequence[Excerpt]] = field(default_factory=dict)
    cells: Mapping[str, Sequence[Excerpt]] = field(default_factory=dict)
    envelopes: Sequence[Mapping[str, Any]] = ()
    densities: Sequence[Mapping[str, Any]] = ()
    stability: Mapping[str, Any] | None = None
    selftest: Mapping[str, Any] | None = None
    letters: Mapping[str, Sequence[Meaning]] = field(default_factory=dict)
    date: str = ""
    older: str = ""
    changes: Sequence[Change] = ()


class _Numbered:
    """Texts by number, each once."""

    def __init__(self) -> None:
        self.numbers: dict[str, int] = {}

    def number(self, text: str | Excerpt) -> int:
        text = text.text if isinstance(text, Excerpt) else text
        return self.numbers.setdefault(text, len(self.numbers))


class _Part:
    """Texts that are unfolded together: those of a paper when one of its claims is opened, or those of the errata."""

    def __init__(self, formulas: Formulas) -> None:
        self.formulas = formulas.apart()
        self.strings, self.tables, self.excerpts = _Numbered(), _Numbered(), _Numbered()

    @property
    def texts(self) -> dict[str, list[str]]:
        """All by number."""
        kinds = {"math": self.formulas.numbered}
        kinds |= {name: list(vars(self)[name].numbers) for name in ("strings", "tables", "excerpts")}
        return kinds


@dataclass(frozen=True)
class _Hypothesis:
    """What is assumed in a paper, and how many relations need it (True), do not, or may (None)."""

    paper: str
    words: str
    needed: Counter[bool | None]


def page(records: Sequence[Record], papers: Sequence[Publication], extras: Extras | None = None) -> str:
    """The audit as one HTML file that needs nothing else: records and papers in the order in which they are shown."""
    extras = extras or Extras()
    tested = extras.selftest or {}
    letters = (each.latex for said in extras.letters.values() for each in said)
    formulas = Formulas((*entries.texts(records), *letters))
    known = {paper.key: paper for paper in papers}
    shown = {
        each.id: Entry(
            each,
            known[each.paper],
            of_record(extras.kernels, each.id),
            of_record(extras.cells, each.id),
            extras.letters.get(each.id, ()),
        )
        for each in records
    }
    environment = Environment(
        loader=PackageLoader(__package__, "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["place"] = lambda id: Id.parse(id).place
    environment.globals |= {"answer": answer, "difference": entries.difference, "entries": shown, "COQ": COQ}
    environment.globals |= {"fits": fits, "restored": restored, "general": entries.general, "number_of": number_of}
    claim = environment.get_template("claim.html")
    of_paper: dict[str, list[Entry]] = {paper.key: [] for paper in papers}
    for each in shown.values():
        of_paper[each.paper.key].append(each)
    folded: dict[str, object] = {}
    for key, members in of_paper.items():
        part = _Part(formulas)
        claims = [claim.render(entry=each, **vars(part)) for each in members]
        said = [_said(each, part) for each in members]
        folded[f"claims-{key}"] = {"claims": claims, "said": said, **part.texts}
        folded[f"proofs-{key}"] = _proofs(members)
    first, names = _Part(formulas), _Numbered()
    graphs = [g for p in papers if (g := graph(p.key, [r for r in records if r.paper == p.key])).nodes]
    parts = {
        "publications": [paper for paper in papers if any(each.paper == paper.key for each in records)],
        "counts": _counts(records),
        "origins": origins(records),
        "blame": blame(records),
        "erring": erring(records),
        "coq": Counter(said == CONFIRMED for record in records for said in confirmed(record).values()),
        "table": {paper.key: Counter(Relation(r).state for r in records if r.paper == paper.key) for paper in papers},
        "states": [str(each) for each in STATES],
        "errata": [*errata(records)],
        "selftest": rows(tested) if tested and tested["evidence"] == evidence(records) else [],
        "recorded": bool(tested),
        "engines": tested.get("engines"),
        "hypotheses": _hypotheses(records),
        "envelopes": extras.envelopes,
        "plots": [_plot(density) for density in extras.densities],
        "stability": extras.stability,
        "map": coloured(extras.stability) if extras.stability else None,
        "graphs": graphs,
        "font": address("font/woff2", (files(__package__) / "vendor" / FONT).read_bytes()),
        "version": __version__,
        "date": extras.date,
        "older": extras.older,
        "changes": extras.changes,
        "style": _asset("style.css"),
        "script": Markup("").join(map(_asset, SCRIPTS)),
    }
    # The page itself asks for formulas too, so that it is made before they are folded.
    text = environment.get_template("page.html").render(**parts, **vars(first), folded={"slot": Markup("")})
    arcs = environment.get_template("graph.html")
    folded |= {
        "index": {
            "rows": [_row(each, names) for each in shown.values()],
            "names": list(names.numbers),
            "roles": [str(role) for role in ROLES],
            "papers": [{name: getattr(each, name) for name in TOLD} for each in papers],
            "meanings": MEANINGS,
        },
        "errata": first.texts,
        "envelopes": [{**envelope, "marks": marks(envelope, records)} for envelope in extras.envelopes],
        "graphs": [arcs.render(g=each) for each in graphs],
    }
    slots = "\n".join(_slot(name, packed(data)) for name, data in folded.items())
    return text.replace(_slot("slot", ""), slots)


def _slot(name: str, data: str) -> str:
    return f'<script type="application/octet-stream" id="folded-{name}">{data}</script>'


def _proofs(relations: Iterable[Relation]) -> dict[str, Any]:
    """The proofs of a paper field by field: similar values next to each other compress to half the size."""
    found = [proof for relation in relations for proof in relation.proofs]
    written = [proof.certificate for proof in found]
    keys = sorted({key for each in written for key in each})
    texts = _Numbered()

    def folded(key: str, value: Any) -> object:
        told_once = key == "definitions" and value is not None
        return [texts.number(_json(each)) for each in value] if told_once else value

    from symcheck.checker.theorems import stated  # takes long

    taken = [step for each in written for step in parts_of(each)]
    return {
        "lines": [proof.lines if "matrices" in proof.certificate else "" for proof in found],
        "fields": {key: [folded(key, each.get(key)) for each in written] for key in keys},
        "texts": list(texts.numbers),
        "rules": {rule: RULES[rule] for rule in dict.fromkeys(step["rule"] for step in taken) if rule in RULES},
        "theorems": {name: stated(name) for name in dict.fromkeys(step["of"] for step in taken if "of" in step)},
        "hypotheses": {each.name: each.words for relation in relations for each in relation.record.hypotheses},
    }


def _json(data: object) -> str:
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"))


def _row(relation: Relation, names: _Numbered) -> list[object]:
    """By what the ledger filters a record, in the order of HEAD in page.js."""
    record = relation.record
    dimension = record.dimension.verdict if record.dimension else ""
    filtered = (relation.state, record.kind, record.origin or "", record.section, relation.coq, dimension)
    return [record.id, *map(names.number, filtered)]


def _said(relation: Relation, part: _Part) -> list[object]:
    """What a row of the ledger shows of a record, and in what it is searched, in the order of SAID in page.js."""
    record = relation.record
    link = record.read if record.link or record.group is Group.DAMAGED else ""
    shown = [part.formulas.number(text) for text in (link, record.printed, record.read) if text]
    math = next((number for number in shown if number >= 0), -1)
    words = "" if link and math >= 0 else record.words or ("" if math >= 0 else record.printed or record.name)
    searched = (record.words, record.printed, record.read, record.corrected, record.reason, relation.name)
    texts = [part.strings.number(text) for text in dict.fromkeys(searched) if text]
    printed = part.strings.number(record.printed) if record.printed else -1
    return [math, part.strings.number(words), printed, texts]


def _counts(records: Iterable[Record]) -> dict[str, int]:
    found = Counter(str(record.verdict) for record in records if record.verdict)
    return {"relations": found.total(), **{str(verdict): found[str(verdict)] for verdict in Verdict}}


def _hypotheses(records: Iterable[Record]) -> list[_Hypothesis]:
    """Those that the papers state or imply, where they were left out of a proof; the least needed first."""
    found: dict[tuple[str, str], Counter[bool | None]] = {}
    for record in records:
        for each in record.hypotheses:
            if record.verdict is Verdict.PROVED and each.given in ("printed", "standing") and each.need:
                found.setdefault((record.paper, each.words), Counter())[each.need.needed] += 1
    return sorted((_Hypothesis(*key, needed) for key, needed in found.items()), key=lambda each: -each.needed[False])


def _plot(plot: Mapping[str, Any]) -> dict[str, Any]:
    axes, paths = curves(plot)
    return {**plot, "axes": axes, "paths": paths}


def _asset(name: str) -> Markup:
    """A style sheet or a script without what is there for who reads its source: indentation and lines of comment."""
    text = (files(__package__) / "templates" / name).read_text(encoding="utf-8")
    return Markup(re.sub(r"(?m)^[ \t]*(?://.*\n)?", "", text))
