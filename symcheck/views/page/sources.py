"""What else shows a claim: its paper, what its letters mean, the kernels that rest on it, and cells of notebooks."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import lru_cache
from pathlib import Path

from symcheck.audit import kernels as declared
from symcheck.core.claims import Paper
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.ledger import Record
from symcheck.reading import Letter, Notation, read
from symcheck.reading.tree import Name
from symcheck.views.model import Fault, Relation

UNITS = {"1": "a number", "any": "of any unit"}  # in words

_ID = re.compile(r"\b[a-z]+\d{4}:[A-Z]?\d*[\w.]*\w")  # an id of a claim: "mirer2009:2.1a"


@dataclass(frozen=True)
class Excerpt:
    """A piece of text from a file: a generated function, or a cell of a notebook."""

    name: str
    place: str
    text: str


@dataclass(frozen=True)
class Publication:
    """A paper: its title, the file with its text, the titles of its sections by number, where it was published.

    `digest` is the beginning of the SHA-256 of the file; "" where that is not known.
    """

    key: str
    title: str
    source: str
    sections: Mapping[str, str]
    published: str = ""
    digest: str = ""


@dataclass(frozen=True)
class Meaning:
    """What a letter of a formula stands for, and whether it is one of ours, which the paper does not print."""

    latex: str
    says: str
    is_ours: bool


def meanings(papers: Mapping[str, Paper], records: Iterable[Record]) -> dict[str, tuple[Meaning, ...]]:
    """By relation ("mirer2009:2.12") what is said of its letters.

    Those of its formula come first, in the order in which they stand, then those of its hypotheses and of the point
    where it fails.
    """
    items = {key: {item.number: item for _, _, item in paper.items()} for key, paper in papers.items()}
    found = {}
    for record in records:
        paper = papers[record.paper]
        item = items[record.paper].get(Id.parse(record.id).declaration.place)
        letters = (item.notation if item else None) or paper.notation
        if letters:
            formula = (record.read, Fault((Relation(record),)).correct)
            shown = (*formula, *(each.states for each in record.hypotheses))
            said = [each for latex in shown if latex for each in _meanings(latex, letters, paper.notation)]
            said += _of_point(record, letters, paper.notation)
            found[record.id] = tuple(dict.fromkeys(said))
    return found


@lru_cache(maxsize=4096)  # the relations of a paper share their hypotheses
def _meanings(latex: str, letters: Notation, printed: Notation) -> tuple[Meaning, ...]:
    try:
        tree = read(latex, letters)
    except SymcheckError:  # a row of a list is no formula, nor need that be one which an auditor rewrote
        return ()
    found = ((letters.find(name, indices), name, indices) for name, indices in dict.fromkeys(_names(tree)))
    return tuple(
        _meaning(letter, indices, printed.find(name, indices) is None)
        for letter, name, indices in found
        if letter and letter.meaning
    )


def _of_point(record: Record, letters: Notation, printed: Notation) -> Iterator[Meaning]:
    """The letters whose values are given where a relation fails: those of the certificate, "Y_91" for a component."""
    declared = {each.stem: each for each in reversed(letters.letters) if each.meaning}
    for name in record.refutation["point"]["values"] if record.refutation else ():
        letter = declared.get(name) or declared.get(name.partition("_")[0])
        if letter:
            yield _meaning(letter, letter.indices, letter not in printed.letters)


def _meaning(letter: Letter, indices: int, is_ours: bool) -> Meaning:
    index = f"_{{{'ijkl'[:indices]}}}" if indices else ""
    own = re.sub(r"\\[A-Za-z]+|[^A-Za-z]", "", letter.latex)  # "V" of "\mathbf{V}"
    name = f"{letter.name} in proofs" if letter.name not in (None, own) else ""
    says = ", ".join(filter(None, (letter.meaning, UNITS.get(letter.unit, letter.unit), name)))
    return Meaning(f"{letter.latex}{index}", says, is_ours)


def _names(part: object) -> Iterator[tuple[str, int]]:
    """The letters of a tree, each with the number of its indices."""
    if isinstance(part, Name):
        yield part.letter, len(part.subscripts)
    if is_dataclass(part):
        yield from _names([getattr(part, field.name) for field in fields(part)])
    elif isinstance(part, tuple | list):
        yield from (name for each in part for name in _names(each))


def publications(papers: Mapping[str, Paper]) -> tuple[Publication, ...]:
    """The papers as the page names them."""
    return tuple(
        Publication(
            key,
            paper.title,
            paper.source,
            {section.number: section.title for section in paper.sections},
            paper.published,
            paper.digest,
        )
        for key, paper in papers.items()
    )


def kernels(papers: Mapping[str, Paper], folder: Path) -> dict[str, list[Excerpt]]:
    """By claim ("mirer2009:2.12") the functions generated from it, as they stand in `folder`."""
    found: dict[str, list[Excerpt]] = {}
    for key in papers:
        texts = _functions(folder / f"{key}.py", declared.declared(key))
        for name, text in texts.items():
            for number in declared.declared(key)[name].claims:
                found.setdefault(str(Id(key, number)), []).append(Excerpt(name, f"generated/{key}.py", text))
    return found


def cells(folder: Path) -> dict[str, list[Excerpt]]:
    """By claim the cells of the notebooks of a folder that name it; none if there is no such folder."""
    found: dict[str, list[Excerpt]] = {}
    for file in sorted(folder.glob("*.ipynb")):
        try:
            notebook = json.loads(file.read_text(encoding="utf-8"))["cells"]
            texts = ["".join(cell["source"]) for cell in notebook]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise SymcheckError(f"{file} is not a readable notebook ({error}); mend or remove it") from error
        for number, text in enumerate(texts, 1):
            for id in dict.fromkeys(_ID.findall(text)):
                found.setdefault(id, []).append(Excerpt(file.stem, f"{file.name}, cell {number}", text))
    return found


def of_record(excerpts: Mapping[str, Iterable[Excerpt]], id: str) -> list[Excerpt]:
    """The excerpts of a claim, or of the chain it is a link of."""
    return list({excerpt: None for name in (id, str(Id.parse(id).declaration)) for excerpt in excerpts.get(name, ())})


def _functions(file: Path, declared: Mapping[str, Kernel]) -> dict[str, str]:
    """The generated functions of a module, each with what is declared of it in the place of its docstring."""
    if not file.is_file():
        return {}
    lines = file.read_text(encoding="utf-8").splitlines()
    functions = [node for node in ast.parse("\n".join(lines)).body if isinstance(node, ast.FunctionDef)]
    return {node.name: _listing(node, lines, declared[node.name]) for node in functions if node.name in declared}


def _listing(function: ast.FunctionDef, lines: Sequence[str], kernel: Kernel) -> str:
    accuracy = f"{kernel.ulp} ulp. {kernel.condition} {kernel.degenerate}"
    comments = [kernel.says, *(f"{x.name}: {x.meaning}, {x.unit}; {x.domain}" for x in kernel.arguments)]
    comments += [*(f"{x.name}: {x.meaning}, {x.unit}" for x in kernel.outputs), " ".join(accuracy.split())]
    _, first, *_ = function.body
    body = lines[first.lineno - 1 : function.end_lineno]
    return "\n".join([lines[function.lineno - 1], *(f"    # {line}" for line in comments), *body])
