"""Has Coq check exported files: `python -m symcheck.coq.compile FOLDER [PAPER ...] [--jobs N]`.

For each relation it comes out whether Coq confirms it, or the reason why not; with --record that is written to
generated/coq, where outcomes of relations that were not exported stay, with --check compared with what is there. A file
that does not compile is tried again without the proof at which it stopped, so that one bad proof costs no other.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import accumulate
from pathlib import Path

from symcheck import kernels
from symcheck.coq import confirmed
from symcheck.coq.confirmed import Outcome
from symcheck.coq.files import OURS, Row, manifest
from symcheck.core.ids import Id
from symcheck.ledger import digest

MISSING = "coqc is not installed; on Debian: apt-get install coq libcoq-coquelicot"
NO_COQUELICOT = "the Coq library Coquelicot is not installed; on Debian: apt-get install libcoq-coquelicot"
# coqc's message: the line of an error, and the error up to a blank line
STOPPED = re.compile(r"line (\d+), characters.*?\nError:(.*?)(?:\n\n|\Z)", re.DOTALL)
ASSUMPTION = re.compile(r"^([A-Za-z_][\w.']*)\s*:", re.MULTILINE)  # an axiom's name, as `Print Assumptions` lists them
REALS = (  # what the standard library's real numbers rest on, and its arctangent (excluded middle)
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
)


def missing(coqc: str = "coqc") -> str | None:
    """What has to be installed, in a line."""
    if shutil.which(coqc) is None:
        return MISSING
    where = subprocess.run([coqc, "-where"], capture_output=True, text=True, check=False).stdout.strip()
    return None if (Path(where) / "user-contrib" / "Coquelicot").is_dir() else NO_COQUELICOT


def coqc(folder: Path, file: str) -> tuple[int, str, float]:
    """Compiles a file of the folder: exit code, what Coq says, seconds."""
    began = time.monotonic()
    command = ["coqc", "-q", "-w", "-all", "-R", ".", "Symcheck", file]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr, time.monotonic() - began


def without(text: str, line: int) -> tuple[str, list[str]]:
    """The text without the theorem that this line is in and without those that rest on it, and their names."""
    blocks = re.split(r"(?=^(?:Lemma|Theorem) )", text, flags=re.MULTILINE)
    ends = list(accumulate(block.count("\n") for block in blocks))
    stopped = next((block for block, end in zip(blocks, ends, strict=True) if line <= end), "")
    names: list[str] = re.findall(r"\A(?:Lemma|Theorem) (?:proof_|step_)?(\w+)", stopped)
    if not names:
        raise ValueError(f"line {line} is in no theorem")
    for block in blocks:
        own = re.match(r"Theorem proof_(\w+)", block)
        if own and own[1] not in names and re.search(rf"\bproof_(?:{'|'.join(names)})\b", block):
            names.append(own[1])
    heads = tuple(f"{kind}{name} :" for name in names for kind in ("Lemma step_", "Theorem proof_", "Lemma "))
    kept = "".join(block for block in blocks if not block.startswith(heads))
    if kept == text:
        raise ValueError(f"line {line} is in {names[0]}, which does not prove a claim")
    return re.sub(rf"^pose proof proof_(?:{'|'.join(names)})\.\n", "", kept, flags=re.MULTILINE), names


def checked(folder: Path, file: str, failed: dict[str, str]) -> Iterator[str]:
    """Compiles a file, leaving out what fails; a line for each attempt."""
    path = folder / file
    while True:
        code, said, seconds = coqc(folder, file)
        if code == 0:
            axioms = sorted({*ASSUMPTION.findall(said)} - {"Axioms"})
            if strange := [axiom for axiom in axioms if axiom not in REALS]:
                failed[file] = f"axioms beyond those of the standard reals: {', '.join(strange)}"
            short = ", ".join(axiom.rpartition(".")[2] for axiom in axioms)
            yield f"{file}: {seconds:.1f} s" + (f"; Print Assumptions: {short}" if axioms else "")
            return
        stopped = STOPPED.search(said)
        try:
            text, names = without(path.read_text(encoding="utf-8"), int(stopped[1]) if stopped else 0)
        except ValueError:
            failed[file] = " ".join(said.split())[-300:]
            yield f"{file}: does not compile: {failed[file]}"
            return
        reason = "Coq rejects the proof: " + " ".join((stopped[2] if stopped else "").split())[:200]
        failed |= {name if name[:8] != "witness_" else f"{name} in {path.parent.name}": reason for name in names}
        yield f"{file}: {', '.join(names)}: {reason}"
        path.write_text(text, encoding="utf-8")


def confirm(folder: Path, papers: Sequence[str] = (), jobs: int = 1) -> tuple[dict[str, Outcome], list[str]]:
    """Compiles everything, so many files at once; the outcome of each relation, and what went wrong."""
    entries = manifest(folder)
    failed: dict[str, str] = {}
    out: dict[str, Outcome] = {}
    chosen = papers or list(entries)
    files = [*OURS, *(f"{paper}/{name}.v" for paper in chosen for name in entries[paper]["files"])]
    with ThreadPoolExecutor(jobs) as pool:
        while ready := [file for file in files if not needed(folder, file) & {*files}]:
            for lines in pool.map(lambda file: [*checked(folder, file, failed)], ready):
                print(*lines, sep="\n", flush=True)
            files = [file for file in files if file not in ready]
    for paper in chosen:
        out |= {id: _outcome(row, paper, failed) for id, row in entries[paper]["claims"].items()}
    return out, [f"{name}: {reason}" for name, reason in failed.items()]


def needed(folder: Path, file: str) -> set[str]:
    """The files that a file imports."""
    imported = re.findall(r"^Require Import Symcheck\.([\w.]+)\.$", (folder / file).read_text("utf-8"), re.MULTILINE)
    return {f"{name.replace('.', '/')}.v" for name in imported}


def _outcome(row: Row, paper: str, failed: Mapping[str, str]) -> Outcome:
    broken = [failed[name] for name in row["claims"] if name in failed]
    broken += [reason for file, reason in failed.items() if file.startswith(f"{paper}/") or file in OURS]
    return digest(row["certificates"]), "; ".join(dict.fromkeys([*row["reasons"], *broken]))


def summary(outcomes: Mapping[str, Outcome]) -> Iterator[str]:
    """How many of how many, for each paper, and the reasons for the others."""
    for paper in dict.fromkeys(Id.parse(id).paper for id in outcomes):
        reasons = [reason for id, (_, reason) in outcomes.items() if Id.parse(id).paper == paper]
        yield f"{paper}: {reasons.count('')} of {len(reasons)} proved relations and corrections are confirmed by Coq"
        yield from (f"  {reasons.count(reason)} not: {reason}" for reason in dict.fromkeys(reasons) if reason)


def unwitnessed(folder: Path, papers: Sequence[str] = ()) -> Iterator[str]:
    """The statements for whose hypotheses no point was found."""
    entries = manifest(folder)
    for paper in papers or entries:
        for reason, names in grouped(entries[paper]["no witness"]).items():
            yield f"{paper}: {reason}: {', '.join(names)}"


def grouped(reasons: Mapping[str, str]) -> dict[str, list[str]]:
    """The names by the reasons."""
    return {reason: [name for name in reasons if reasons[name] == reason] for reason in dict.fromkeys(reasons.values())}


def main(arguments: Sequence[str]) -> int:
    """0 everything exported compiles, 1 something does not or is not confirmed any more, 2 Coq is not there."""
    if reason := missing():
        print(f"symcheck: {reason}", file=sys.stderr)
        return 2
    parser = argparse.ArgumentParser(prog="compile", description="Has Coq check exported files.")
    parser.add_argument("folder", nargs="?", type=Path, help="what was exported; without it, only whether Coq is there")
    parser.add_argument("papers", nargs="*")
    parser.add_argument("--jobs", type=int, default=1, help="files at once")
    after = parser.add_mutually_exclusive_group()
    after.add_argument("--record", action="store_true", help="write the outcomes to generated/coq")
    after.add_argument("--check", action="store_true", help="fail if something recorded there is not confirmed")
    given = parser.parse_args(arguments)
    if given.folder is None:
        return 0
    outcomes, failed = confirm(given.folder, given.papers, given.jobs)
    print(*failed, *summary(outcomes), *unwitnessed(given.folder, given.papers), sep="\n")
    ours = kernels.folder()
    if given.record:
        print(*(f"recorded in {file}" for file in confirmed.record_all(ours, outcomes)), sep="\n")
    gone = []
    if given.check:
        gone = [*confirmed.lost(ours, outcomes, given.papers)]
        others = confirmed.unrecorded(ours, outcomes)
        print(
            *gone,
            f"{others} outcomes are not as recorded; `make coq` records them" if others else "as recorded",
            sep="\n",
        )
    return int(bool(failed or gone))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
