"""An audit to begin with: each relation of a source with a guessed role, and what it seems to follow from."""

from __future__ import annotations

import ast
import json
import keyword
import os
import re
import textwrap
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from symcheck.core.counts import number_of
from symcheck.core.files import put
from symcheck.core.verdicts import SymcheckError
from symcheck.document.checks import Checks
from symcheck.document.guesses import guessed
from symcheck.document.letters import Letter, by_rules, rules, shown, without_parts_of_names
from symcheck.document.lock import LOCK, UPDATE, Accepted, accepted, digest, keys, load, located, written
from symcheck.document.look import known
from symcheck.document.printed import Printed
from symcheck.document.roles import Guess
from symcheck.document.sources import source
from symcheck.document.survey import is_sayable
from symcheck.document.units import Told, of_document
from symcheck.document.work import Work
from symcheck.papers import FILES, key_of
from symcheck.question.doubts import functions_in_letters

ROLES = ("definition", "claim", "premise", "exclusion")
TAKEN = frozenset({"source", "letter", "paper", "Document", "Erratum", "Hypothesis", "Origin"})
WIDTH = 116  # columns of a comment
NOT_READ = "not read: "


@dataclass
class Draft:
    """A source as it is read, and what its relations are taken for."""

    file: Path
    formulas: Sequence[Printed]
    letters: Sequence[Letter]
    guesses: Sequence[Guess]
    said: Sequence[str] = ()  # what is wrong with the source itself, and what is left out of it
    units: Mapping[str, Told] = field(default_factory=dict)  # by letter, where the source says one for all of it
    rules: Sequence[str] = ()  # by which it is rewritten before it is read
    keys: Sequence[str] = field(init=False)

    def __post_init__(self) -> None:
        self.keys = keys(self.formulas)

    def line(self, k: int, names: Mapping[int, str]) -> str:
        """One relation as it stands in an audit; what cannot be read is a comment."""
        guess, key = self.guesses[k], _quoted(self.keys[k])
        if guess.reason:
            return _commented(f"# source.exclusion({key}, reason=)", NOT_READ + guess.reason)
        more = f", follows=[{', '.join(names[m] for m in guess.follows if m in names)}]" if guess.follows else ""
        more += f", imposed={_quoted(guess.imposed)}" if guess.imposed else ""
        return f"{names[k]} = source.{guess.role}({key}{more})"

    def letter(self, each: Letter) -> str:
        """A letter as it is taken, with the evidence, and its unit if the source says one."""
        phrase = f", {_quoted(each.phrase)}" if is_sayable(each.phrase) else ""
        told = f"not the same everywhere: {', '.join(each.others)}" if each.others else f"{each.taken}: {each.why}"
        if unit := self.units.get(each.letter):
            phrase += f", unit={_quoted(unit.unit)}"
            told = f"its unit is said at {unit.place}; {told}"
        return _commented(f"letter({_quoted(shown(each.letter))}{phrase}),", told)


def drafted(file: Path, work: Work) -> Draft:
    """A source, read, with what each relation is taken for."""
    printed = source(file)
    seen, every = known(printed.formulas, work)
    rewriting = rules(printed.formulas, seen, every)
    if (formulas := by_rules(printed.formulas, rewriting)) != [*printed.formulas]:
        seen, every = known(formulas, work)
    every = without_parts_of_names(every, seen)
    said = [f"{file}: {fault.place}: {fault.message}" for fault in printed.faults]
    said += [f"{file}: left out: {note}" for note in printed.notes]
    guesses, unlike = guessed(Checks(formulas, seen, every), every, work)
    said += [f"{file}: {' and '.join(formulas[k].place for k in both)} do not agree" for both in unlike]
    scopes: dict[str, list[tuple[int, int]]] = {}
    for formula, each in zip(formulas, seen, strict=True):
        for x in each.names:
            scopes.setdefault(x, []).append(formula.scope)
    units = {x: told for x, own in scopes.items() if (told := of_document(x, printed.told, own))}
    return Draft(file, printed.formulas, every, guesses, said, units, (*rewriting, *_spelled(formulas)))


def new(file: Path, folder: Path, work: Work) -> list[str]:
    """Write an audit of a source to a folder that has none; a line for each thing that is to be said."""
    key_of(folder)
    targets = [folder / FILES[0], folder / LOCK]
    for each in targets:
        if each.exists():
            raise SymcheckError(f"{each} exists; {UPDATE.format(folder)} brings it up to date, --out names another")
    draft = drafted(file, work)
    _both(targets[1], written(accepted(draft.formulas)), targets[0], text(draft, folder).encode())
    unread = "not read"
    count = Counter(unread if each.reason else each.role for each in draft.guesses)
    told = ", ".join(number_of(n, what, what if what == unread else "") for what, n in count.most_common())
    return [*draft.said, f"{targets[0]}: written: {told or 'no relations'}", f"{targets[1]}: written"]


def _both(lock: Path, accepted: bytes, audit: Path, code: bytes) -> None:
    """Write both files, or neither: an audit names relations as they are in its lock."""
    before = lock.read_bytes() if lock.exists() else None
    put(lock, accepted)
    try:
        if not audit.exists() or audit.read_bytes() != code:
            put(audit, code)
    except OSError:
        put(lock, before) if before is not None else lock.unlink()
        raise


def text(draft: Draft, folder: Path) -> str:
    """The audit of a source, as Python."""
    names = named(draft.formulas, draft.keys)
    path = Path(os.path.relpath(draft.file.resolve(), folder.resolve())).as_posix()
    title = f"{draft.file.name}: what is printed is read from the source; this file says what each relation is"
    letters_ = "\n".join(f"        {draft.letter(each)}" for each in draft.letters)
    return "\n".join(
        [
            f'"""Audit of {_plain(title)}."""',
            "",
            "from symcheck.document.paper import Document, letter",
            "",
            "source = Document(",
            "    __file__,",
            f"    {_quoted(path)},",
            *([f"    letters=(\n{letters_}\n    ),"] if draft.letters else []),
            *([f"    rules=[{', '.join(map(_quoted, draft.rules))}],"] if draft.rules else []),
            ")",
            "",
            *_body(draft, names),
            "",
            f"paper = source.paper(__name__, title={_quoted(draft.file.name)})",
            "",
        ]
    )


def _spelled(formulas: Sequence[Printed]) -> list[str]:
    """Rules for functions that are spelled in letters, where they are printed as functions elsewhere in the source."""
    texts = [formula.latex for formula in formulas]
    names = dict.fromkeys(name for text in texts for name in functions_in_letters(text))
    return [rf"{x} -> \{x}" for x in names if any(re.search(rf"\\{x}(?![A-Za-z])", text) for text in texts)]


def _body(draft: Draft, names: Mapping[int, str]) -> Iterator[str]:
    """A line for each relation in printed order, but that of a condition before the claims that need it."""
    section, done = draft.formulas[0].scope[0] if draft.formulas else 0, set[int]()

    def line(k: int) -> Iterator[str]:
        if k not in done:
            done.add(k)
            for m in draft.guesses[k].follows:
                yield from line(m)
            yield draft.line(k, names)

    for k, formula in enumerate(draft.formulas):
        if formula.scope[0] != section:
            yield ""
        section = formula.scope[0]
        yield from line(k)


def named(formulas: Sequence[Printed], keys: Sequence[str], taken: Iterable[str] = ()) -> dict[int, str]:
    """A variable for each relation, by its label, number or line."""
    used, found = {*TAKEN, *taken}, dict[int, str]()
    for k, (formula, key) in enumerate(zip(formulas, keys, strict=True)):
        label = formula.label.partition(", ")[0].rpartition(":")[2]
        name = re.sub(r"\W+", "_", label or key, flags=re.ASCII).strip("_").lower()
        name = name if name[:1].isalpha() else f"eq_{name}"
        name = f"{name}_" if keyword.iskeyword(name) else name
        count = 2
        bare = name
        while name in used:
            name, count = f"{bare}_{count}", count + 1
        used.add(name)
        found[k] = name
    return found


def _quoted(text: str) -> str:
    r"""A text as Python writes it, raw where it has backslashes: r"\omega"."""
    if "\\" in text and '"' not in text and not text.endswith("\\") and text.isprintable():
        return f'r"{text}"'
    return json.dumps(text, ensure_ascii=not text.isprintable())


def _commented(code: str, comment: str) -> str:
    """Code with a comment, which is cut if the line is too long."""
    return f"{code}  # {textwrap.shorten(comment, max(WIDTH - len(code), 40), placeholder=' ...')}"


def _plain(text: str) -> str:
    return " ".join(text.replace("\\", "/").replace('"', "'").split())


@dataclass(frozen=True)
class Named:
    """A relation that an audit names: its variable if it has one, its key, and where that stands."""

    name: str
    key: str
    line: int
    columns: tuple[int, int]
    end: int  # the last line of the statement


class Audit:
    """The text of an audit, of which only keys are replaced, and to which lines are added."""

    def __init__(self, file: Path) -> None:
        self.file = file
        try:
            self.code = file.read_text(encoding="utf-8")
            self.tree = ast.parse(self.code)
        except (OSError, UnicodeDecodeError) as error:
            why = getattr(error, "strerror", None) or error
            raise SymcheckError(f"{file} cannot be read ({why}); name the folder of an audit") from error
        except (SyntaxError, ValueError) as error:
            raise SymcheckError(f"{file}:{getattr(error, 'lineno', 1)}: {error}; mend this first") from error
        self.lines = self.code.split("\n")
        self.comments = [*self._comments()]
        self.named = [*self._calls(), *self.comments]

    @property
    def source(self) -> str:
        """The name of the file that is audited."""
        for call in (each for each in ast.walk(self.tree) if isinstance(each, ast.Call)):
            if _called(call) == "Document" and isinstance(
                file := getattr(call.args[1:2] and call.args[1], "value", None), str
            ):
                return file
        raise SymcheckError(f"{self.file} has no Document(__file__, ...) that names its source")

    @property
    def letters(self) -> set[object]:
        """The letters of which it says something."""
        calls = (each for each in ast.walk(self.tree) if isinstance(each, ast.Call))
        return {getattr(each.args[0], "value", None) for each in calls if each.args and _called(each) == "letter"}

    def _calls(self) -> Iterator[Named]:
        for statement in self.tree.body:
            target = statement.targets[0] if isinstance(statement, ast.Assign) else None
            name = target.id if isinstance(target, ast.Name) else ""
            for call in (each for each in ast.walk(statement) if isinstance(each, ast.Call) and each.args):
                key = call.args[0]
                if isinstance(call.func, ast.Attribute) and call.func.attr in ROLES and isinstance(key, ast.Constant):
                    columns = self._characters(key)
                    yield Named(name, str(key.value), key.lineno, columns, statement.end_lineno or key.lineno)

    def _characters(self, key: ast.Constant) -> tuple[int, int]:
        """Python counts bytes."""
        text = self.lines[key.lineno - 1].encode()
        return len(text[: key.col_offset].decode()), len(text[: key.end_col_offset].decode())

    def _comments(self) -> Iterator[Named]:
        for n, text in enumerate(self.lines, 1):
            if found := _COMMENT.match(text):
                with suppress(SyntaxError, ValueError):
                    yield Named("", str(ast.literal_eval(found[1])), n, found.span(1), n)

    def renamed(self, keys: Mapping[str, str]) -> int:
        """Name relations by their new keys; how many have another one."""
        changed = [each for each in self.named if keys.get(each.key, each.key) != each.key]
        for each in sorted(changed, key=lambda each: (each.line, each.columns), reverse=True):
            text, (start, end) = self.lines[each.line - 1], each.columns
            self.lines[each.line - 1] = text[:start] + _quoted(keys[each.key]) + text[end:]
        return len(changed)

    def added(self, draft: Draft, places: Sequence[int], keys: Mapping[str, str]) -> None:
        """Add a line for each new relation behind the one that is printed before it."""
        index = {key: k for k, key in enumerate(draft.keys)}
        ends = {index[keys[each.key]]: each for each in self.named if keys.get(each.key) in index}
        used = {each.id for each in ast.walk(self.tree) if isinstance(each, ast.Name)}
        names = named(draft.formulas, draft.keys, used)
        names |= {k: each.name for k, each in ends.items() if each.name}
        top = next((s.end_lineno for s in self.tree.body if "Document(" in ast.unparse(s)), 0) or 0
        top += self.lines[top : top + 1] == [""]
        at = {m: each.end for m, each in ends.items()}
        for k in places:
            at[k] = at.get(max((m for m in ends if m < k), default=-1), top)
        for k in reversed(places):
            before = {m: x for m, x in names.items() if m == k or (m in at and m < k and at[m] <= at[k])}
            self.lines.insert(at[k], draft.line(k, before))

    def text(self) -> str:
        """The audit as it is now."""
        return "\n".join(self.lines)


def _called(call: ast.Call) -> str:
    return str(getattr(call.func, "id", getattr(call.func, "attr", "")))


# a line of an audit that is commented out, with the key of its relation
_COMMENT = re.compile(r"""\s*#\s*\w*\s*=?\s*source\.\w+\((r?"(?:[^"\\]|\\.)*")""")


def update(folder: Path, work: Work) -> list[str]:
    """Accept the source of an audit as it is now; a line for each thing that has changed, and for what is written."""
    folder = folder.parent if folder.name in FILES else folder
    audit, lock = Audit(folder / FILES[0]), folder / LOCK
    draft = drafted(Path(os.path.normpath(folder / audit.source)), work)
    old = load(lock) if lock.exists() else accepted(draft.formulas)
    where = located(old, draft.formulas)
    said = [*draft.said, *_changes(old, where, draft, audit)]
    keys = {each.key: draft.keys[k] for each in old if (k := where.get(each.key)) is not None}
    if moved := audit.renamed(keys):
        said.append(f"{audit.file}: {moved} of the names of relations brought up to date")
    new = [k for k in range(len(draft.formulas)) if k not in where.values()]
    audit.added(draft, new, keys)
    said += [f"{draft.file}:{draft.formulas[k].line}: new, and added: {draft.formulas[k].latex}" for k in new]
    said += [
        f"{audit.file}: new, and to be added to its letters: {draft.letter(each)}" for each in _new(draft, audit, old)
    ]
    ast.parse(audit.text())
    _both(lock, written(accepted(draft.formulas)), audit.file, audit.text().encode())
    return [*said, f"{lock}: {'written' if said[len(draft.said) :] else 'nothing has changed'}"]


def _new(draft: Draft, audit: Audit, old: Sequence[Accepted]) -> list[Letter]:
    """The letters that stand first in a relation that is new or has changed, and are not in the audit."""
    before = {each.digest for each in old}
    places = {formula.place for formula in draft.formulas if digest(formula.latex) not in before}
    return [each for each in draft.letters if each.first in places and shown(each.letter) not in audit.letters]


def _changes(old: Sequence[Accepted], where: Mapping[str, int], draft: Draft, audit: Audit) -> Iterator[str]:
    lines = {each.key: each.line for each in audit.named}
    for each in old:
        k = where.get(each.key)
        if k is None:
            out = f"; take {audit.file}:{lines[each.key]} out" if each.key in lines else ""
            yield f"{draft.file}: {each.place} is gone: it was {each.latex}{out}"
        elif digest(draft.formulas[k].latex) != each.digest:
            formula = draft.formulas[k]
            yield f"{draft.file}:{formula.line}: {formula.place} has changed: was {each.latex}, is {formula.latex}"
            if each.key in {comment.key for comment in audit.comments} and not draft.guesses[k].reason:
                names = named(draft.formulas, draft.keys)
                yield f"{audit.file}:{lines[each.key]}: it is read now; in its place: {draft.line(k, names)}"
