"""The files for Coq: statements, proofs in parts of about a minute each, witnesses, and a manifest."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from importlib.resources import files as resources
from pathlib import Path
from textwrap import fill
from typing import TypedDict

from symcheck.coq import confirmed
from symcheck.coq.claims import Claim, claims_of
from symcheck.coq.statements import WIDTH
from symcheck.coq.theorems import about_angles, everything
from symcheck.coq.witnesses import witnesses
from symcheck.ledger import Record, by_paper

PART = 120_000  # characters of proof scripts in a file: under a minute for Coq
OURS = ("Symcheck.v", "Digits.v", "Theorems.v")
LIBRARIES = "Require Import Reals.\nFrom Coquelicot Require Import Coquelicot.\n"
SCOPE = "Open Scope R_scope.\n"
MANIFEST = "manifest.json"


class Row(TypedDict):
    """What Coq is asked of a relation: its claims in Coq, the certificates, and reasons if it has no claim."""

    claims: list[str]
    certificates: list[str]
    reasons: list[str]


Entry = TypedDict("Entry", {"files": list[str], "claims": dict[str, Row], "no witness": dict[str, str]})


def manifest(folder: Path) -> dict[str, Entry]:
    """What was exported to a folder, by paper."""
    entries: dict[str, Entry] = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
    return entries


def files(records: Sequence[Record]) -> Mapping[str, str]:
    """The text of each file by its name: the libraries, a folder per paper, and the manifest."""
    folder = resources(__package__)
    out = {name: folder.joinpath(name).read_text(encoding="utf-8") for name in OURS}
    out["Theorems.v"] += about_angles()
    out["Theorems.v"] += "\n" + everything(re.findall(r"^Theorem (\w+)", out["Theorems.v"], re.MULTILINE))
    entries: dict[str, Entry] = {}
    for paper, rows in by_paper(records).items():
        claims = claims_of(rows)
        out[f"{paper}/Claims.v"] = claims_file(paper, claims)
        parts = {f"Proofs{k}": part for k, part in enumerate(_parts(claims), 1)}
        places: dict[str, str] = {}
        for name, part in parts.items():
            out[f"{paper}/{name}.v"] = proofs_file(paper, part, places)
            places |= {claim.name: name for claim in part}
        out[f"{paper}/Witnesses.v"], missing = witnesses(claims)
        entries[paper] = {"files": ["Claims", *parts, "Witnesses"], "claims": _rows(claims), "no witness": missing}
    out[MANIFEST] = json.dumps(entries, indent=1, ensure_ascii=False) + "\n"
    return out


def _rows(claims: Sequence[Claim]) -> dict[str, Row]:
    """By the key of what Coq is asked."""
    rows: dict[str, Row] = {}
    for claim in claims:
        key = confirmed.key(claim.record, claim.corrected)
        row = rows.setdefault(key, {"claims": [], "certificates": [], "reasons": []})
        row["certificates"].append(claim.digest)
        if claim.statement is not None:
            row["claims"].append(claim.name)
        elif claim.reason not in row["reasons"]:
            row["reasons"].append(claim.reason)
    return rows


def claims_file(paper: str, claims: Sequence[Claim]) -> str:
    """The statements in printed order, each below what is printed."""
    lines = [f"(* {paper}: what is confirmed. Made by `symcheck export --format coq`. *)\n", LIBRARIES + SCOPE]
    last = ""
    for claim in claims:
        title = f"{claim.record.id}{' as corrected' if claim.corrected else ''}"
        if title != last:
            lines.append(f"(* {title}\n{printed_form(claim)} *)")
            last = title
        if claim.statement is None:
            lines.append(f"(* {claim.name} is not stated here: {comment(claim.reason)}. *)\n")
        else:
            lines.append(f"Definition claim_{claim.name} : Prop :=\n{claim.text}.\n")
    return "\n".join(lines)


def printed_form(claim: Claim) -> str:
    """What is printed, for a comment."""
    record = claim.record
    texts = [comment(record.corrected if claim.corrected else record.printed or record.words)]
    texts += [f"read as: {comment(record.read)}"] if record.read not in ("", record.printed) else []
    return "\n".join(fill(text, WIDTH, initial_indent="   ", subsequent_indent="   ") for text in texts)


def comment(text: str) -> str:
    """Text that stands in a comment of Coq, where quotes and the marks of comments would mean something."""
    return " ".join(text.split()).replace("(*", "( *").replace("*)", "* )").replace('"', "''")


def _ordered(claims: Sequence[Claim]) -> list[Claim]:
    """Lemmas before what rests on them, and what is stated twice together, as it is proved once."""
    by_name = {claim.name: claim for claim in claims if claim.statement is not None}
    by_text: dict[str, list[Claim]] = {}
    for claim in by_name.values():
        by_text.setdefault(claim.text, []).append(claim)
    ordered: dict[str, Claim] = {}

    def add(claim: Claim) -> None:
        if claim.name not in ordered:
            for lemma in claim.after:
                add(by_name[lemma])
            ordered[claim.name] = claim

    for claim in by_name.values():
        for same in by_text[claim.text]:
            add(same)
    return [*ordered.values()]


def _parts(claims: Sequence[Claim]) -> Iterator[list[Claim]]:
    part: list[Claim] = []
    size, texts = 0, set()
    for claim in _ordered(claims):
        length = 0 if claim.text in texts else len(claim.script) + len(claim.step)
        texts.add(claim.text)
        if part and size + length > PART:
            yield part
            part, size = [], 0
        part.append(claim)
        size += length
    if part:
        yield part


def proofs_file(paper: str, part: Sequence[Claim], places: Mapping[str, str]) -> str:
    """A proof of each claim, and at the end what all of them together assume; lemmas are in `places`."""
    earlier = sorted({places[lemma] for claim in part for lemma in claim.after if lemma in places})
    modules = [name.removesuffix(".v") for name in OURS]
    modules += [f"{paper}.{name}" for name in ("Claims", *earlier)]
    imports = "".join(f"Require Import Symcheck.{name}.\n" for name in modules)
    lines = [f"Require Import Lra.\n{LIBRARIES}{imports}{SCOPE}"]
    proved: dict[str, str] = {}
    for claim in part:
        same = proved.setdefault(claim.text, claim.name)
        script, step = f"exact proof_{same}.", ""
        if same == claim.name:
            script, step = f"unfold claim_{same}.\n{claim.script}", f"{claim.step}\n\n" if claim.step else ""
        lines.append(f"{step}Theorem proof_{claim.name} : claim_{claim.name}.\nProof.\n{script}\nQed.\n")
    lines.append(everything(f"proof_{claim.name}" for claim in part))
    return "\n".join(lines)
