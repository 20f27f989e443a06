"""Notation tables with one mistake: two letters swapped, a wrong assumption. The ledger of the paper must notice."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from itertools import combinations, product
from random import Random
from typing import Any, NamedTuple

from symcheck import papers
from symcheck.audit import Context, Unit, expand, units
from symcheck.audit.judge import judge
from symcheck.core.claims import Assertion, Ours, Paper, for_letter
from symcheck.core.problems import Problem
from symcheck.core.terms import Formula, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Record
from symcheck.proof import equivalent
from symcheck.proof.algebra.polynomial import Unsupported, unfold
from symcheck.reading import Letter, Notation
from symcheck.reading.notation import variable
from symcheck.selftest.evidence import ledger_verdict, relettered
from symcheck.selftest.trial import FaultClass, Status, Trial, drawn

SWAPPED, ASSUMED = "letters swapped", "wrong assumption"
PIECES = 8  # tasks for each paper
OTHER_SIGN = {"": "> 0", ">= 0": "", "> 0": ""}
Change = Callable[[Notation], Notation]


class Fault(NamedTuple):
    """A mistake in a notation table, the letters it is about, and which variables it exchanges."""

    words: str
    letters: tuple[str, ...]
    change: Change
    exchanged: Mapping[str, str]


def faults(notation: Notation) -> Iterator[tuple[str, Fault]]:
    """All mistakes of these kinds in one table."""
    plain = [letter for letter in notation.letters if letter.kind not in ("index", "differential")]
    for a, b in combinations(plain, 2):
        if (a.kind, a.indices) == (b.kind, b.indices):
            change = partial(_relettered, changes={a: _spelled(a, b), b: _spelled(b, a)})
            pairs = list(zip(_variables(a), _variables(b), strict=False))
            exchanged = {**dict(pairs), **{second: first for first, second in pairs}}
            yield SWAPPED, Fault(f"{a.latex} and {b.latex}", _spellings(a, b), change, exchanged)
    for letter in notation.letters:
        for name, value in _assumptions(letter):
            change = partial(_relettered, changes={letter: replace(letter, **{name: value})})
            words = f"{name} of {letter.latex}: {getattr(letter, name)} -> {value}"
            yield ASSUMED, Fault(words, _spellings(letter), change, {})


def _spellings(*letters: Letter) -> tuple[str, ...]:
    """What to look for in LaTeX: the longest word of each letter, since `\\bar k` may be printed for `\\bar{k}`."""
    return tuple(max(re.findall(r"\\?[A-Za-z]+", letter.latex), key=len) for letter in letters)


def _spelled(letter: Letter, other: Letter) -> Letter:
    """A letter with the spelling of another one."""
    return replace(letter, latex=other.latex, name=letter.stem)


def _variables(letter: Letter) -> list[str]:
    """The variables that a letter may be lowered to."""
    inner = {"vector": 1, "matrix": 2}.get(letter.kind, 0)
    places = product(*[letter.range] * letter.indices, *[(1, 2, 3)] * inner)
    return [variable(letter.stem, indices) for indices in places]


def _assumptions(letter: Letter) -> Iterator[tuple[str, Any]]:
    if letter.kind != "differential":
        yield "sign", OTHER_SIGN[letter.sign]
    if letter.kind == "index" or letter.indices:
        yield "range", letter.range[:-1]
        yield "range", (*letter.range, letter.range[-1] + 1)
    if letter.kind in ("scalar", "vector"):
        yield "kind", {"scalar": "vector", "vector": "scalar"}[letter.kind]


def _relettered(notation: Notation, changes: Mapping[Letter, Letter]) -> Notation:
    letters = [changes.get(letter, letter) for letter in notation.letters]
    return notation.having(*letters)


def status_of(paper: Paper, fault: Fault) -> Status:
    """Whether the first relation that means something else now has another verdict, or cannot be read.

    A fault is equivalent if no statement changes, or if all change as if two variables had exchanged names throughout.
    """
    changed = 0
    try:
        faulty = replace(paper, notation=fault.change(paper.notation))
        for item, text, verdict in _decided(paper):
            context, other = Context(paper, item), Context(faulty, _item(item, fault.change))
            printed = any(letter in text for letter in fault.letters)
            if not printed and _means_the_same(context, other, fault):
                continue
            for before, after in zip(units(context), units(other), strict=True):
                stated, faulty_stated = _stated(context, before), _stated(other, after)
                if _is_same(stated, faulty_stated) or _is_same(_exchanged(stated, fault.exchanged), faulty_stated):
                    continue
                changed += 1
                judged = judge(other, after, other.item.statement.given)
                if ledger_verdict(other, after, judged) is not verdict(before.letter):
                    return Status.REJECTED
    except (SymcheckError, Unsupported, ValueError):
        return Status.REJECTED  # it cannot be read, or the table contradicts itself
    return Status.ACCEPTED if changed else Status.EQUIVALENT


def _means_the_same(context: Context, other: Context, fault: Fault) -> bool:
    """Whether all definitions mean what they meant."""
    names = fault.exchanged
    return other.table == {_exchanged(x, names): _exchanged(term, names) for x, term in context.table.items()}


def _text(item: Assertion) -> str:
    """All LaTeX of a declaration."""
    given = [hypothesis.states for hypothesis in item.hypotheses]
    statement = item.statement
    return str((item.source.printed, item.text, statement.states, statement.equality, given)).replace("\\\\", "\\")


def _item(item: Assertion, change: Change) -> Assertion:
    return replace(item, notation=change(item.notation)) if item.notation else item


def _stated(context: Context, unit: Unit) -> tuple[Formula, ...]:
    """All that a relation states, definitions unfolded: its formulas, what is given, where it is an equality."""
    given = [context.hypothesis(hypothesis) for hypothesis in context.item.hypotheses]
    equality = for_letter(context.item.statement.equality, unit.letter)
    where = context.lower(equality) if equality else ()
    formulas = (*unit.formulas, *where, *(formula for _, assumed in given for formula in assumed))
    definitions = dict(context.used_definitions(*formulas))
    return tuple(unfold(formula, definitions) for formula in formulas)


def _is_same(stated: tuple[Formula, ...], other: tuple[Formula, ...]) -> bool:
    """Whether the statements are the same by algebra, one by one."""
    if len(stated) != len(other):
        return False
    pairs = zip(stated, other, strict=True)
    return all(f == g or equivalent(f, g, Problem("both", node("and", f, g))) for f, g in pairs)


def _exchanged(value: Any, names: Mapping[str, str]) -> Any:
    """The same with some variables exchanged."""
    return relettered(value, lambda name: names.get(name, name))


@cache
def _decided(paper: Paper) -> tuple[tuple[Assertion, str, Callable[[str], Verdict]], ...]:
    """The declarations without lemmas, each with the verdict of its links; lists, and what is long, come last."""
    decided = []
    for obligation in expand(paper):
        item = obligation.item
        if isinstance(item, Assertion) and not item.plan.lemmas:
            decided.append((item, _text(item), cache(partial(_verdict, Context(paper, item)))))
    return tuple(
        sorted(decided, key=lambda pair: (len(pair[0].statement.states) > 1, isinstance(pair[0], Ours), len(pair[1])))
    )


def _verdict(context: Context, letter: str) -> Verdict:
    unit = next(unit for unit in units(context) if unit.letter == letter)
    return ledger_verdict(context, unit, judge(context, unit, context.item.statement.given))


def trials(place: str, count: int, rng: Random) -> Iterator[Trial]:
    """So many mistakes in the table of one paper."""
    key, _, piece = place.partition("/")
    paper = papers.load()[key]
    own = (pair for n, pair in enumerate(faults(paper.notation)) if n % PIECES == int(piece))
    for kind, fault in drawn(own, count, rng):
        yield Trial(kind, f"{key} {fault.words}", status_of(paper, fault))


def _places(records: Sequence[Record]) -> list[str]:
    return [f"{key}/{n}" for key in dict.fromkeys(record.paper for record in records) for n in range(PIECES)]


CLASS = FaultClass(
    "notation",
    "notation tables with one mistake, before the ledger",
    (SWAPPED, ASSUMED),
    share=30,
    places=_places,
    trials=trials,
)
