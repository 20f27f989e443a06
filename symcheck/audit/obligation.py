"""What there is to decide, and the fingerprint of everything a result depends on. No algebra, no parsing."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import cache, partial
from importlib.metadata import version
from pathlib import Path
from typing import Any

from msgspec import structs

from symcheck import papers
from symcheck.core.claims import Assertion, Declaration, Definition, Paper, Section
from symcheck.core.ids import Id
from symcheck.core.problems import Method
from symcheck.core.verdicts import SymcheckError
from symcheck.ledger import Record
from symcheck.papers.places import places
from symcheck.reading import Notation

LIBRARIES = ("sympy", "python-flint", "lark")
SOURCES = ("reading", "proof", "mechanics", "audit", "ledger", "checker", "dimensions", "core")
ASKING = ("question", "document")  # besides, of relations that are asked about


@dataclass(frozen=True)
class Obligation:
    """One declaration to decide."""

    id: str
    paper: Paper
    section: Section
    item: Declaration


def expand(paper: Paper) -> tuple[Obligation, ...]:
    """All declarations of a paper in printed order."""
    return tuple(
        Obligation(str(Id(paper.key, item.number)), paper, section, replace(item, name=name))
        for section, name, item in paper.items()
    )


def obligation_of(id: str) -> Obligation:
    """The declaration with this id; SymcheckError if there is none."""
    key = Id.parse(id).paper
    found = _declared(key).get(id)
    if found is None:
        raise SymcheckError(f"{id} is not declared; `symcheck check {key} --json` lists the ids")
    return found


@cache
def _declared(key: str) -> dict[str, Obligation]:
    paper = papers.load().get(key)
    return {each.id: each for each in expand(paper)} if paper else {}


@cache
def users(key: str) -> dict[str, tuple[str, ...]]:
    """By the number of a declaration: the ids of those that refer to it."""
    found: dict[str, tuple[str, ...]] = {}
    for each in _declared(key).values():
        for number in dict.fromkeys(each.item.uses):
            found[number] = (*found.get(number, ()), each.id)
    return found


@cache
def _digest_of_sources(key: str) -> str:
    root = Path(__file__).parents[1]
    derivation = papers.load().folders.get(key, root / "papers" / key) / "derivation.py"
    asked = any(item.question for _, _, item in papers.load()[key].items())
    listed = [root / source for source in (*SOURCES, *(ASKING if asked else ()))] + [derivation]
    files = [f for path in listed for f in (sorted(path.rglob("*")) if path.is_dir() else [path])]
    digest = hashlib.sha256()
    for file in files:
        if file.is_file() and file.suffix != ".pyc":
            digest.update(os.path.relpath(file, root).encode() + b"\0" + file.read_bytes())
    for library in LIBRARIES:
        digest.update(f"{library} {version(library)}".encode())
    return digest.hexdigest()


def _plain(value: Any) -> Any:
    """A value of a declaration as text that depends on its content only."""
    match value:
        case Method():
            return (value.name, value.hints)
        case Notation():
            return value.content
        case Mapping():
            return sorted((key, _plain(each)) for key, each in value.items())
        case partial():
            return (_plain(value.func), value.args)
        case tuple():
            return tuple(_plain(each) for each in value)
        case _ if is_dataclass(value):
            return (type(value).__name__, [(f.name, _plain(getattr(value, f.name))) for f in fields(value)])
        case _ if callable(value):
            return f"{value.__module__}.{value.__qualname__}"
    return value


def _content(item: Declaration) -> str:
    return repr(_plain(item))


@cache
def _paper_context(key: str) -> str:
    paper = papers.load()[key]
    items = [item for _, _, item in paper.items()]
    lemmas = {Id.of(key, p).number for item in items if isinstance(item, Assertion) for p in item.plan.lemmas}
    shared = [_content(item) for item in items if isinstance(item, Definition) or item.number in lemmas]
    uses = [(item.number, item.uses) for item in items]
    return repr((_plain(paper.notation), shared, uses, _digest_of_sources(key)))


def fingerprint(obligation: Obligation) -> str:
    """Hash of all a result depends on: declaration, notation, definitions, lemmas, our sources, library versions.

    What is asked about has all of it in the question, wherever it stands in the source: `placed` says where that is.
    """
    key, item = obligation.paper.key, obligation.item
    if item.question:
        context = repr((obligation.section.number, users(key).get(item.number), _digest_of_sources(key)))
        item = replace(item, source=replace(item.source, line=0, lines={}))
    else:
        context = _paper_context(key)
    text = _content(item) + str(places(key).get(item.number)) + context
    return hashlib.sha256(text.encode()).hexdigest()


def placed(obligation: Obligation, records: Sequence[Record]) -> tuple[Record, ...]:
    """Records of a declaration, of which one that is asked about may have been decided when it stood on other lines."""
    source = obligation.item.source
    if not obligation.item.question:
        return tuple(records)
    own = (source.lines.get(record.id.removeprefix(obligation.id), source.line) for record in records)
    return tuple(structs.replace(record, line=line) for record, line in zip(records, own, strict=True))
