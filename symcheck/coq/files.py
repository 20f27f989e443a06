"""The files for Coq: statements, proofs in parts of about a minute each, witnesses, and a list of it all."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from importlib.resources import files as resources
from textwrap import fill
from typing import Any

from symcheck.coq import confirmed
from symcheck.coq.claims import Exported, exported
from symcheck.coq.statements import WIDTH
from symcheck.coq.witnesses import witnesses
from symcheck.ledger.record import Record

PART = 120_000  # characters of proof scripts in a file: under a minute for Coq
LIBRARIES = "Require Import Reals.\nFrom Coquelicot Require Import Coquelicot.\n"
SCOPE = "Open Scope R_scope.\n"
MANIFEST = "manifest.json"


def files(records: Sequence[Record]) -> Mapping[str, str]:
    """The text of each file by its name: Symcheck.v, a folder per paper, and the manifest."""
    papers: dict[str, list[Record]] = {}
    for record in records:
        papers.setdefault(record.paper, []).append(record)
    own = resources(__package__)
    out = {name: own.joinpath(name).read_text(encoding="utf-8") for name in ("Symcheck.v", "Digits.v", "Theorems.v")}
    listed: dict[str, Any] = {}
    for paper, rows in papers.items():
        found = exported(rows)
        places: dict[str, str] = {}
        parts = [f"Proofs{k}" for k in range(1, len(list(_parts(found))) + 1)]
        out[f"{paper}/Claims.v"] = claims_file(paper, found)
        for name, part in zip(parts, _parts(found), strict=True):
            out[f"{paper}/{name}.v"] = proofs_file(paper, part, places)
            places |= {each.name: name for each in part}
        out[f"{paper}/Witnesses.v"], unwitnessed = witnesses(found)
        listed[paper] = {
            "files": ["Claims", *parts, "Witnesses"],
            "claims": _listed(found),
            "no witness": unwitnessed,
        }
    out[MANIFEST] = json.dumps(listed, indent=1, ensure_ascii=False) + "\n"
    return out


def _listed(found: Sequence[Exported]) -> dict[str, Any]:
    """By the key of what Coq is asked: its claims in Coq, the certificates, and reasons if it has no claim."""
    out: dict[str, Any] = {}
    for each in found:
        entry = out.setdefault(confirmed.key(each.record, each.corrected), _empty())
        entry["certificates"].append(each.digest)
        if each.statement is None:
            entry["reasons"] = list(dict.fromkeys([*entry["reasons"], each.reason]))
        else:
            entry["claims"].append(each.name)
    return out


def _empty() -> dict[str, list[str]]:
    return {"claims": [], "certificates": [], "reasons": []}


def claims_file(paper: str, found: Sequence[Exported]) -> str:
    """The statements in printed order, each below what is printed."""
    lines = [f"(* {paper}: what is confirmed. Made by `symcheck export --format coq`. *)\n", LIBRARIES + SCOPE]
    seen = ""
    for each in found:
        title = f"{each.record.id}{' as corrected' if each.corrected else ''}"
        if title != seen:
            lines.append(f"(* {title}\n{printed_form(each)} *)")
            seen = title
        if each.statement is None:
            lines.append(f"(* {each.name} is not stated here: {comment(each.reason)}. *)\n")
        else:
            lines.append(f"Definition claim_{each.name} : Prop :=\n{each.text}.\n")
    return "\n".join(lines)


def printed_form(each: Exported) -> str:
    """What is printed, for a comment."""
    record = each.record
    shown = record.corrected if each.corrected else record.printed or record.words
    texts = [comment(shown), *([f"read as: {comment(record.read)}"] if record.read not in ("", record.printed) else [])]
    return "\n".join(fill(text, WIDTH, initial_indent="   ", subsequent_indent="   ") for text in texts)


def comment(text: str) -> str:
    """Text that stands in a comment of Coq, where quotes and the marks of comments would mean something."""
    return " ".join(text.split()).replace("(*", "( *").replace("*)", "* )").replace('"', "''")


def _ordered(found: Sequence[Exported]) -> Iterator[Exported]:
    """Lemmas before what rests on them, and what is stated twice together, as it is proved once."""
    by_name = {each.name: each for each in found if each.statement is not None}
    done: set[str] = set()
    alike: dict[str, list[Exported]] = {}
    for each in by_name.values():
        alike.setdefault(each.text, []).append(each)

    def visit(each: Exported) -> Iterator[Exported]:
        if each.name not in done:
            for lemma in each.after:
                yield from visit(by_name[lemma])
            done.add(each.name)
            yield each

    for each in by_name.values():
        for same in alike[each.text]:
            yield from visit(same)


def _parts(found: Sequence[Exported]) -> Iterator[list[Exported]]:
    part: list[Exported] = []
    size, texts = 0, set()
    for each in _ordered(found):
        own = 0 if each.text in texts else len(each.script) + len(each.step)
        texts.add(each.text)
        if part and size + own > PART:
            yield part
            part, size = [], 0
        part.append(each)
        size += own
    if part:
        yield part


def proofs_file(paper: str, part: Sequence[Exported], places: Mapping[str, str]) -> str:
    """A proof of each claim, and at the end what all of them together assume; lemmas are in `places`."""
    earlier = sorted({places[lemma] for each in part for lemma in each.after if lemma in places})
    imports = [
        "Symcheck.Symcheck",
        "Symcheck.Digits",
        "Symcheck.Theorems",
        *(f"Symcheck.{paper}.{name}" for name in ("Claims", *earlier)),
    ]
    lines = ["Require Import Lra.\n" + LIBRARIES + "".join(f"Require Import {name}.\n" for name in imports) + SCOPE]
    shown: dict[str, str] = {}
    for each in part:
        same = shown.setdefault(each.text, each.name)
        script = f"unfold claim_{each.name}.\n{each.script}" if same == each.name else f"exact proof_{same}."
        step = f"{each.step}\n\n" if each.step and same == each.name else ""
        lines.append(f"{step}Theorem proof_{each.name} : claim_{each.name}.\nProof.\n{script}\nQed.\n")
    used = "\n".join(f"pose proof proof_{each.name}." for each in part)
    lines.append(f"Lemma everything : True.\nProof.\n{used}\nexact I.\nQed.\n\nPrint Assumptions everything.\n")
    return "\n".join(lines)
