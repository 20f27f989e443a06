"""`symcheck.look`: the first look at a document, without a declaration."""

from __future__ import annotations

import re
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import dataclass, field
from itertools import accumulate, groupby
from os import PathLike
from pathlib import Path

from symcheck.audit.library import executor
from symcheck.core.counts import number_of
from symcheck.core.terms import JSON
from symcheck.dimensions import INCONSISTENT
from symcheck.document.angles import in_brackets
from symcheck.document.checks import SEARCH, SECONDS, Checks, Place, Question, confirmed, decided, fails
from symcheck.document.derived import LATER, Derived, blamed, sought, with_proofs
from symcheck.document.letters import Letter, elsewhere, factors, in_doubt, in_one_face, letters, of_vectors
from symcheck.document.measuring import UNKNOWN, measured_by, measurings
from symcheck.document.printed import Printed, Source
from symcheck.document.roles import Roles
from symcheck.document.sources import source
from symcheck.document.structure import Mark, marks
from symcheck.document.survey import READING, Seen, surveyed, surveyed_with
from symcheck.document.units import Told
from symcheck.document.work import Progress, Work, proved_of, undecided
from symcheck.document.written_out import with_units
from symcheck.question import Answer, Status
from symcheck.question.measured import LIMIT
from symcheck.reading.lowering import SHAPES_DIFFER

# what distinguishes two refusals of one kind: the place, and what is printed there
_PLACE = re.compile(r",? at character \d+: .*$", re.DOTALL)
_BOUNDS = re.compile(r"(\S+) ≤ (.*) and \2 ≤ (\S+)", re.DOTALL)  # as the decision tells the value of a difference
# reasons of which each names another printed term
VALUELESS = (
    "has no algebraic form", "states no relation", SHAPES_DIFFER, "is no product", "a scalar is expected here",
    "stands without its arguments", "an index of a name is not summed over",
)  # fmt: skip
COMPARING = 7.0  # seconds in which relations are compared; documents of 400 displays take as long
EXPLAINING = 6.0  # seconds more in which slips are sought that explain why some do not agree
PROVING = 2.0  # seconds more in which it is shown that some follow
NEAREST = 2  # relations that are shown in the place of one that fails
FAILS = "fails with these definitions: an error, or a condition printed elsewhere?"
CHAIN = "the links of this chain do not agree: an error, or a condition printed elsewhere?"
UNLIKE = "does not agree with other relations: an error in one of them, or a condition printed elsewhere?"
UNITS = "its terms do not measure the same: an error, or a condition printed elsewhere?"
STEP = "does not follow from what it is said to: an error in one of them, or a condition printed elsewhere?"
ALIKE = ("chain", "identity")  # the kinds of questions whose sides have the same letters
TOLD = {"chain": CHAIN, "step": STEP, "derived": UNLIKE, LATER: UNLIKE}  # by the kind of a question


@dataclass(frozen=True)
class Finding:
    """Something in a document to look at.

    Parameters
    ----------
    place
        The line, and the number if it has one.
    formula
        The relation that fails, or what is printed there.
    message
        What is wrong, or may be.
    point
        Values of the letters at which it fails.
    values
        Both sides there.
    definitions
        The places of the definitions that were put in.
    nearest
        Relations that are one slip of the pen away and hold.
    dimensions
        The smallest set of terms found that do not measure the same, each with what it measures.
    units
        What the text says that letters measure, with the places.
    """

    place: str
    formula: str
    message: str
    point: dict[str, str] = field(default_factory=dict)
    values: tuple[str, ...] = ()
    definitions: tuple[str, ...] = ()
    nearest: tuple[str, ...] = ()
    dimensions: tuple[str, ...] = ()
    units: tuple[str, ...] = ()


@dataclass(frozen=True)
class Refusal:
    """One reason for which formulas are not read, or not decided, with all their places."""

    reason: str
    places: tuple[str, ...]
    example: str


@dataclass(frozen=True)
class Look:
    """What a first look at a document shows.

    Parameters
    ----------
    file
        The document.
    formulas
        All of its displays and inline relations, in printed order.
    read
        Whether each of them is read.
    letters
        Each letter with what it is taken for.
    refusals
        Why formulas are not read, each reason once.
    valueless
        Why formulas that are read have no value, so that nothing is decided of them, each reason once.
    holds
        The places of relations that hold for all values of their letters.
    follows
        The places of relations that follow from those before them.
    findings
        What to look at.
    notes
        What was left out, such as files that are missing.
    seconds
        How long it took.
    """

    file: str
    formulas: tuple[Printed, ...]
    read: tuple[bool, ...]
    letters: tuple[Letter, ...]
    refusals: tuple[Refusal, ...]
    valueless: tuple[Refusal, ...]
    holds: tuple[str, ...]
    follows: tuple[str, ...]
    findings: tuple[Finding, ...]
    notes: tuple[str, ...] = ()
    seconds: float = 0.0

    def as_json(self) -> dict[str, JSON]:
        """All of it as JSON data."""
        import json
        from dataclasses import asdict

        data: dict[str, JSON] = json.loads(json.dumps(asdict(self)))
        return data


def look(file: str | PathLike[str], *, jobs: int = 0, progress: Progress = lambda done, total: None) -> Look:
    r"""Look at a document for the first time, without a single declaration.

    Its displays and inline relations are found with lines, labels and numbers, macros expanded; the letters are
    inferred from all formulas together; then it is said what holds for all values of the letters, and what fails
    although everything that it needs is defined before it. Nothing is called refuted: what fails may rest on a
    condition that is printed in words.

    Parameters
    ----------
    file
        LaTeX, Markdown (also of Quarto and MyST), reStructuredText, or a notebook.
    jobs
        Worker processes; 0 works in this process. With workers a script needs ``if __name__ == "__main__"``.
    progress
        Called with the numbers of steps that are done and that are to be done.

    Returns
    -------
    Look
        All of it; nothing is written to disk.

    Raises
    ------
    SymcheckError
        If the file cannot be read, or has no formula.

    See Also
    --------
    decide : One formula.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> from symcheck import look
    >>> with TemporaryDirectory() as folder:
    ...     paper = Path(folder) / "paper.md"
    ...     _ = paper.write_text(r"Then $$E = (a + b)^2 - 4ab = a^2 + 2ab + b^2.$$")
    ...     found = look(paper).findings
    >>> [(each.place, each.point) for each in found]
    [('line 1', {'a': '3', 'b': '2'})]
    """
    started = time.perf_counter()
    printed = source(Path(file))
    with executor(jobs, ["symcheck.document.checks"]).kept() as workers:
        return _looked(str(file), printed, Work(workers, progress), started)


def _looked(file: str, printed: Source, work: Work, started: float) -> Look:
    seen, every = known(printed.formulas, work)
    if (formulas := in_one_face(printed.formulas, seen, every)) != [*printed.formulas]:
        seen, every = known(formulas, work)
    seen = in_brackets((each.latex for each in formulas), with_units(formulas, seen, printed.units))
    checks = Checks(formulas, seen, every)
    alone, suspicious, lines = [*checks.alone()], [*checks.suspicious()], checks.derivations()
    answers = work.all(decided, [*dict.fromkeys((*alone, *suspicious, *lines.questions))], SECONDS, undecided)
    answers |= work.all(decided, lines.further(proved_of(answers)), SECONDS, undecided)
    proved = proved_of(answers)
    failing = [
        q for q in suspicious if (fails(answers[q]) if q.kind in ALIKE else answers[q].verdict is Status.REFUTED)
    ]
    failing += [question for question in lines.unlike(proved) if fails(answers[question])]
    sure = work.all(confirmed, failing, SEARCH, undecided)
    found = [(fault.number, Finding(fault.place, "", fault.message)) for fault in printed.faults]
    found += [(mark.number, _marked(formulas, mark)) for mark in marks(formulas, seen, printed.mentions)]
    found += [(q.number, _finding(formulas, q, sure[q])) for q in failing if sure[q].verdict is Status.REFUTED]
    holding = {question.number for question in alone if question in proved} | {*checks.continued(suspicious, proved)}
    found += _misfits(checks, printed.told, work)
    holds = [formulas[k].place for k in sorted(holding)]
    shown = [q for q in (*suspicious, *lines.questions, *lines.beyond.values()) if q in proved]
    done = {place for question in shown for place in question.places[:1]}
    following = {q.number for q in shown if q.where and _rest(seen, q.number) <= done} - holding
    told = {q.number for q in failing if sure[q].verdict is Status.REFUTED}
    more, disagreeing, left = _derived(checks, holding, following, shown, told, work)
    found += disagreeing
    entries, slopes = _gradients(checks, following | more | holding, told, work)
    found += slopes
    more |= entries
    follows = [formulas[k].place for k in sorted(following | more)]
    return Look(
        file,
        printed.formulas,
        tuple(each.read for each in seen),
        tuple(every),
        tuple(_refusals((each.reason, f) for f, each in zip(formulas, seen, strict=True) if not each.read)),
        tuple(_refusals((_kind(each.reason), f) for f, each in zip(formulas, seen, strict=True) if each.partly)),
        tuple(dict.fromkeys(holds)),
        tuple(dict.fromkeys(follows)),
        tuple(finding for _, finding in sorted(found, key=lambda each: each[0])),
        (*printed.notes, *left, *_broken(work.broken)),
        time.perf_counter() - started,
    )


def _broken(reasons: Sequence[str]) -> Iterator[str]:
    """That something was not decided for a fault of this program, each once."""
    for reason, count in Counter(reasons).items():
        were = number_of(count, "question was", "questions were")
        yield f"{were} left open for an internal error ({reason}); please report it"


def _rest(seen: Sequence[Seen], k: int) -> set[Place]:
    """The equations of a formula but for those that say what a letter is."""
    return {(k, link.latex) for link in seen[k].links if not link.head}


def _misfits(checks: Checks, told: Sequence[Told], work: Work) -> Iterator[tuple[int, Finding]]:
    """Formulas whose terms cannot measure the same, by the units that the text says of their letters."""
    asked = [*measurings(checks, told)]
    found = work.all(measured_by, [*dict.fromkeys(question for _, question in asked)], LIMIT, lambda reason: UNKNOWN)
    for place, question in asked:
        if (of := found[question]).verdict == INCONSISTENT:
            own, places = checks.formulas[place.number], dict.fromkeys(each.place for each in place.told)
            yield (
                place.number,
                Finding(
                    own.place,
                    own.latex,
                    UNITS,
                    definitions=tuple(
                        f"{checks.formulas[m].place}: {checks.formulas[m].latex}" for m in place.definitions
                    ),
                    dimensions=tuple(f"{each.term} measures {each.measures}" for each in of.conflict),
                    units=tuple(
                        f"{where}: {', '.join(f'{x.letter} in {x.unit}' for x in place.told if x.place == where)}"
                        for where in places
                    ),
                ),
            )


def _derived(
    checks: Checks,
    holding: Set[int],
    following: Set[int],
    shown: Iterable[Question],
    told: Set[int],
    work: Work,
) -> tuple[set[int], list[tuple[int, Finding]], list[str]]:
    """The other formulas that follow from earlier ones, findings of those that do not agree, and what is left out."""
    roles = Roles(checks)
    roles.guesses()
    sets = Derived(checks, roles)
    settled = holding | following
    ends = [*accumulate((COMPARING, EXPLAINING, PROVING), initial=time.perf_counter())][1:]
    own, rest = sought(sets, [k for k in range(len(checks.formulas)) if k not in settled], work, ends[0])
    granted = [question.places for question in shown if question.number not in holding]
    granted += [((k, each.link.latex),) for k in holding for each in sets.usable[k]]
    wrong, unlike = blamed(sets, [each for every in own.values() for each in every], granted, work, ends[1])
    own, more = with_proofs(own, work, ends[2])
    rest += more
    left = f"{rest} relations, of which it takes too long to tell what they follow from; `symcheck new` tells it"
    follows = {k for k, every in own.items() if every and all(each.proof for each in every)}
    answers = work.all(decided, [*wrong.values()], SECONDS, undecided)
    faulty = {m: q for m, q in wrong.items() if m not in told and fails(answers[q])}
    found = [(m, _finding(checks.formulas, question, answers[question])) for m, question in faulty.items()]
    for those in unlike:
        if told & {*those}:
            continue
        others = tuple(f"{checks.formulas[m].place}: {checks.formulas[m].latex}" for m in those[:-1])
        last = checks.formulas[those[-1]]
        found.append((those[-1], Finding(last.place, last.latex, UNLIKE, definitions=others)))
    return follows, found, [left] if rest else []


def _gradients(
    checks: Checks, agreed: Set[int], told: Set[int], work: Work
) -> tuple[set[int], list[tuple[int, Finding]]]:
    """The lists of derivatives that are right in each entry, and findings of the entries that are wrong."""
    asked = [*dict.fromkeys(q for q in checks.gradients(agreed) if q.number not in agreed)]
    answers = work.all(decided, asked, SECONDS, undecided)
    failing = [q for q in asked if q.number not in told and fails(answers[q])]
    sure = work.all(confirmed, failing, SEARCH, undecided)
    wrong = [q for q in failing if sure[q].verdict is Status.REFUTED]
    proved = proved_of(answers)
    right = {q.number for q in asked} - {q.number for q in asked if q not in proved}
    return right, [(q.number, _finding(checks.formulas, q, sure[q])) for q in wrong]


def known(formulas: Sequence[Printed], work: Work) -> tuple[list[Seen], list[Letter]]:
    """What each formula is, and each letter by all of them; what is not read alone is read by what the others say."""
    looked_at = work.all(surveyed, [*dict.fromkeys(each.latex for each in formulas)], READING, Seen)
    seen = [_in_place(looked_at[f.latex], f) for f in formulas]
    every = letters(formulas, seen)
    by_letter = {each.letter: each for each in every}
    read = factors(formulas, seen)
    says = {x: link.names[1] for each in seen for x, link in each.heads.items()}
    open_ = {
        f.latex: (f.latex, elsewhere(each, by_letter, read, says))
        for f, each in zip(formulas, seen, strict=True)
        if each.reason
    }
    again = work.all(surveyed_with, [task for task in open_.values() if task[1]], READING, Seen)
    better = {latex: found for (latex, _), found in again.items() if found.is_known}
    found = zip(formulas, seen, strict=True)
    seen = [_in_place(each.again(better[f.latex]), f) if f.latex in better else each for f, each in found]
    seen = in_doubt(formulas, seen)
    every = letters(formulas, seen)
    vectors = of_vectors(every)
    return [each.made_of(vectors) for each in seen], every


def _in_place(seen: Seen, formula: Printed) -> Seen:
    return seen.behind_another if formula.goes_on else seen


def _finding(formulas: Sequence[Printed], question: Question, answer: Answer) -> Finding:
    return Finding(
        formulas[question.number].place,
        question.relation,
        TOLD.get(question.kind, FAILS),
        answer.counterexample,
        tuple(map(_enclosed, answer.values)),
        tuple(f"{formulas[k].place}: {text}" for k, text in zip(question.sources, question.where, strict=True)),
        tuple(repair["relation"] for repair in answer.repairs[:NEAREST]),
    )


def _enclosed(value: str) -> str:
    """What is shown of the sides at a point; a difference between two bounds in words."""
    between = _BOUNDS.fullmatch(value)
    return f"the left side less the right one is between {between[1]} and {between[3]}" if between else value


def _marked(formulas: Sequence[Printed], mark: Mark) -> Finding:
    formula = formulas[mark.number]
    return Finding(formula.place, formula.latex, mark.message)


def _kind(reason: str) -> str:
    """What has no value, without what is printed there, where many formulas have the same reason."""
    return next((words for words in VALUELESS if words in reason), reason)


def _refusals(told: Iterable[tuple[str, Printed]]) -> list[Refusal]:
    """Each reason once, the most frequent first."""
    unread = sorted(((_PLACE.sub("", reason), formula) for reason, formula in told), key=lambda each: each[0])
    found = []
    for reason, group in groupby(unread, key=lambda each: each[0]):
        those = [formula for _, formula in group]
        found.append(Refusal(reason, tuple(f.place for f in those), those[0].latex))
    return sorted(found, key=lambda each: -len(each.places))
