"""What each relation of a document is taken for in an audit: its role, corrected by what follows from what."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from symcheck.document.asked import Inquiry, Relied, is_proved, is_settled, verdicts
from symcheck.document.checks import SEARCH, SECONDS, Checks, Definition, Question, confirmed, decided
from symcheck.document.derived import Derived, Outcome, blamed, sought, with_proofs
from symcheck.document.letters import Letter, shown
from symcheck.document.printed import Printed
from symcheck.document.roles import Guess, Roles
from symcheck.document.survey import CONSTANT, Said, is_sayable
from symcheck.document.work import Work, proved_of, undecided
from symcheck.question import Status
from symcheck.question.ask import TOTAL


def guessed(checks: Checks, letters: Sequence[Letter], work: Work) -> tuple[list[Guess], list[tuple[int, ...]]]:
    """The guess for each relation, and the relations that do not agree, of which nobody knows which is wrong."""
    roles = Roles(checks)
    guesses = [*_with_what_is_near(roles.guesses(), checks.formulas, letters, work)]
    guesses = _with_steps(guesses, checks, letters, work)
    found, unlike = _with_derivations(guesses, Derived(checks, roles), letters, work)
    constant = {k for k, seen in enumerate(checks.seen) if any(CONSTANT.fullmatch(r.letter) for r in seen.roles)}
    # that something is some constant, which is another one in each relation, is no claim about a letter
    return [Guess("premise") if k in constant and _claims(each) else each for k, each in enumerate(found)], unlike


def _with_what_is_near(
    guesses: Sequence[Guess], formulas: Sequence[Printed], letters: Sequence[Letter], work: Work
) -> Iterator[Guess]:
    """The same, but a claim that is settled by what stands in its own part of the document needs nothing else."""
    said = _said(letters)
    asked: dict[int, tuple[Inquiry, str]] = {}
    for k, guess in enumerate(guesses):
        if guess.far:
            near = [m for m in guess.follows if m not in guess.far]
            asked[k] = _inquired(guesses, k, near, formulas, said)
    settled = work.all(_is_settled, [*dict.fromkeys(asked.values())], TOTAL, lambda reason: False)
    for k, guess in enumerate(guesses):
        near_ = tuple(m for m in guess.follows if m not in guess.far)
        yield replace(guess, follows=near_) if k in asked and settled[asked[k]] else guess


def _with_steps(guesses: Sequence[Guess], checks: Checks, letters: Sequence[Letter], work: Work) -> list[Guess]:
    """The same, but what follows from the line before it is a claim, and so is a line that does not where others do.

    That is one between two of which the second follows from the first, or one behind two such: then it is the one that
    is wrong, if a slip of the pen explains it.
    """
    lines = checks.derivations()
    answers = work.all(decided, lines.questions, SECONDS, undecided)
    answers |= work.all(decided, lines.further(proved_of(answers)), SECONDS, undecided)
    proved = proved_of(answers)
    unlike = [step for step in lines.unlike(proved) if lines.is_certain(step, proved)]
    wrong = [step for step in unlike if answers[step].verdict is Status.REFUTED]
    sure = work.all(confirmed, wrong, SEARCH, undecided)
    claimed: dict[int, tuple[int, ...]] = {k: (k - 1,) for k, step in lines.steps.items() if step in proved}
    refuted = [step for step in wrong if sure[step].verdict is Status.REFUTED]
    claimed |= {step.number: tuple(m for m in step.sources if m != step.number) for step in refuted}
    for k, step in lines.referred.items():
        if step in proved and not (k in step.sources and checks.seen[k].links):  # all that stands there follows
            claimed[k] = tuple(m for m in step.sources if m != k)
    claimed |= {k + 1: (k - 1,) for k, step in lines.beyond.items() if step in proved and k + 1 not in claimed}
    said = _said(letters)
    asked = {k: _inquired(guesses, k, guesses[k].follows, checks.formulas, said) for k in claimed}
    open_ = [asked[k] for k in claimed if guesses[k].role == "claim"]
    settled = work.all(_is_settled, [*dict.fromkeys(open_)], TOTAL, lambda reason: False)
    return [
        replace(guess, role="claim", follows=claimed[k], far=frozenset())
        if k in claimed and guess.role in ("premise", "claim") and not (guess.role == "claim" and settled[asked[k]])
        else guess
        for k, guess in enumerate(guesses)
    ]


def _with_derivations(
    guesses: Sequence[Guess], sets: Derived, letters: Sequence[Letter], work: Work
) -> tuple[list[Guess], list[tuple[int, ...]]]:
    """The same, but what follows from earlier relations is a claim, and so is what a slip keeps from following.

    Where a slip in either of several relations would explain it, these are told instead.
    """
    formulas, said = sets.checks.formulas, _said(letters)
    asked = {
        k: _inquired(guesses, k, each.follows, formulas, said) for k, each in enumerate(guesses) if not each.reason
    }
    claims = [task for k, task in asked.items() if _claims(guesses[k])]
    holds = work.all(_is_proved, [*dict.fromkeys(claims)], TOTAL, lambda reason: False)
    own, _ = sought(sets, [k for k, task in asked.items() if not (_claims(guesses[k]) and holds[task])], work)
    own, _ = with_proofs(own, work)
    found = [_derived(sets.usable[k], own[k]) or guess if k in own else guess for k, guess in enumerate(guesses)]
    proofs = [each.proof for every in own.values() for each in every if each.proof]
    for m, links in _assumed(sets, proofs, found).items():
        if m in own and found[m] is guesses[m]:
            imposed = "".join(sorted({*found[m].imposed} | links))
            alone = len(imposed) >= len(sets.checks.seen[m].links)
            found[m] = Guess("premise") if alone else replace(found[m], imposed=imposed)
    new = [k for k in own if _claims(found[k]) and found[k] is not guesses[k]]
    asked = {k: _inquired(found, k, found[k].follows, formulas, said) for k in new}
    holds = work.all(_is_proved, [*dict.fromkeys(asked.values())], TOTAL, lambda reason: False)
    found = [guesses[k] if k in asked and not holds[asked[k]] else guess for k, guess in enumerate(found)]
    open_ = [k for k in own if _claims(found[k]) and found[k] is guesses[k]]
    found = _with_more_sources(found, {k: own[k] for k in open_}, formulas, said, work)
    shown = [
        ((k, one.link.latex), *((m, x.link.latex) for m in each.follows for x in sets.usable[m]))
        for k, each in enumerate(found)
        if _claims(each) and k not in own
        for one in sets.usable[k]
    ]
    wrong, unlike = blamed(sets, [each for every in own.values() for each in every], shown, work)
    for m, question in wrong.items():
        heads = [each.link for each in sets.usable[m] if each.link.head and each.link.latex != question.relation]
        imposed = "".join(chr(ord("a") + link.place) for link in heads)
        found[m] = Guess("claim", tuple(sorted({*question.sources} - {m})), imposed)
        for k in found[m].follows:
            if m in _followed(k, found):
                found[k] = Guess("premise")
    return found, unlike


def _with_more_sources(
    guesses: Sequence[Guess],
    outcomes: Mapping[int, Sequence[Outcome]],
    formulas: Sequence[Printed],
    said: Said,
    work: Work,
) -> list[Guess]:
    """The same, but a chain follows from what one of its links follows from, too, if more is decided then."""
    more = {}
    for k, every in outcomes.items():
        sources = {m for each in every if each.proof for m in each.proof.sources}
        if len(every) > 1 and not sources <= {*guesses[k].follows}:
            more[k] = tuple(sorted({*guesses[k].follows} | sources))
    asked = {
        (k, new): _inquired(guesses, k, follows, formulas, said)
        for k in more
        for new, follows in enumerate((guesses[k].follows, more[k]))
    }
    told = work.all(_verdicts, [*dict.fromkeys(asked.values())], TOTAL, lambda reason: ())
    found = [*guesses]
    for k, follows in more.items():
        before, after = (told[asked[k, new]] for new in (0, 1))
        kept = all(x == y or x not in (Status.PROVED, Status.REFUTED) for x, y in zip(before, after, strict=False))
        if kept and Counter(after)[Status.PROVED] > Counter(before)[Status.PROVED]:
            found[k] = replace(found[k], follows=follows)
    return found


def _assumed(sets: Derived, proofs: Sequence[Question], guesses: Sequence[Guess]) -> dict[int, set[str]]:
    """The claims with links from which others follow: these are assumed where they are not proved themselves.

    A relation of the same letters on both sides says nothing new of them, and stays a claim.
    """
    found: dict[int, set[str]] = {}
    derived = {proof.relation for proof in proofs}
    for proof in proofs:
        for m, text in zip(proof.sources, proof.where, strict=True):
            link = next(each.link for each in sets.usable[m] if each.link.latex == text)
            letter = chr(ord("a") + link.place)
            says = link.names[0] != link.names[1] and letter not in guesses[m].imposed
            if _claims(guesses[m]) and says and text not in derived:
                found.setdefault(m, set()).add(letter)
    return found


def _claims(guess: Guess) -> bool:
    return guess.role == "claim"


def _followed(k: int, guesses: Sequence[Guess]) -> set[int]:
    """What a relation follows from, transitively."""
    reached, more = set[int](), {*guesses[k].follows}
    while more:
        reached |= more
        more = {m for each in more for m in guesses[each].follows} - reached
    return reached


def _derived(usable: Sequence[Definition], outcomes: Sequence[Outcome]) -> Guess | None:
    """A claim of what is proved, if all else of the formula says what letters are."""
    proofs = [each.proof for each in outcomes if each.proof]
    rest = [each.link for each, its in zip(usable, outcomes, strict=True) if not its.proof]
    if not proofs or not all(link.head for link in rest):
        return None
    follows = tuple(sorted({m for proof in proofs for m in proof.sources}))
    imposed = "".join(chr(ord("a") + link.place) for link in rest)
    return Guess("claim", follows, imposed)


def _inquired(
    guesses: Sequence[Guess], k: int, follows: Iterable[int], formulas: Sequence[Printed], said: Said
) -> tuple[Inquiry, str]:
    relied = tuple(Relied(formulas[m].latex, guesses[m].imposed) for m in follows)
    return Inquiry(formulas[k].latex, relied, letters=said, goes_on=formulas[k].goes_on), guesses[k].imposed


def _said(letters: Sequence[Letter]) -> Said:
    return tuple((shown(each.letter), each.phrase if is_sayable(each.phrase) else "") for each in letters)


def _verdicts(task: tuple[Inquiry, str]) -> tuple[Status, ...]:
    return verdicts(*task)


def _is_settled(task: tuple[Inquiry, str]) -> bool:
    return is_settled(*task)


def _is_proved(task: tuple[Inquiry, str]) -> bool:
    return is_proved(*task)
