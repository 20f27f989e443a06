"""How a relation of a source is decided: as `symcheck.decide` does it, with the relations from which it follows."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, NamedTuple, cast

from msgspec.structs import replace as record_with

from symcheck.audit import differences
from symcheck.core.certificates import Certificate, MatrixProof
from symcheck.core.claims import Assertion, Declaration, Erratum
from symcheck.core.formulas import conjuncts
from symcheck.core.ids import Id
from symcheck.core.problems import Problem
from symcheck.core.terms import JSON, Formula, Term
from symcheck.core.verdicts import Origin, Reading, Role, SymcheckError, Verdict
from symcheck.dimensions import Dimensions
from symcheck.document.conditions import holds_elsewhere
from symcheck.document.letters import depends_on, shown
from symcheck.document.measuring import Measuring, measured_by
from symcheck.document.points import slips
from symcheck.document.survey import SMALLEST, Link, Said, apart, is_open, is_sayable, surveyed
from symcheck.ledger import Correction, HypothesisRow, Need, Record, Repair, line
from symcheck.question import Answer, Status
from symcheck.question.ask import answered, proved_for_all_sizes
from symcheck.question.divisors import with_plain_divisors
from symcheck.question.jets import LEADING
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.matrices import stated
from symcheck.question.measured import spelled
from symcheck.question.prepare import DEFINED, Asked, Understood, plainly, readings, unlowered
from symcheck.question.prepare import Reading as ReadAs
from symcheck.reading import Tree, relations, to_latex
from symcheck.reading.side_by_side import ONE_NAME

METHOD = "decide"
VALUED = "every printed term has a value"
SOLVABLE = "the equations can be solved for the highest rates of change"
REPAIRING = 8.0  # seconds for an answer with repairs, before one without is asked for
DOUBTING = 10.0  # seconds for conditions that may save what fails
PROVING = 5.0  # seconds for a proof with fewer definitions
SAY = "a condition may be printed elsewhere: say it with follows= or given=, or given=[] if there is none"
VERDICTS = {Status.PROVED: Verdict.PROVED, Status.REFUTED: Verdict.REFUTED}
TOLD = {Status.UNREADABLE: "not read: ", Status.AMBIGUOUS: "ambiguous: "}  # before the reason for no verdict
NUMBERS = ("scalar", "index", "number", "differential")  # kinds of letters of which words hardly say more
UNSAID = ("index", "differential", "number")  # letters of which the formula itself says what they are


@dataclass(frozen=True)
class Relied:
    """What a relation rests on.

    text     an earlier relation
    defines  the letters of the links that define, of a chain that goes on; "" means all
    """

    text: str
    defines: str = ""


@dataclass(frozen=True)
class Inquiry:
    """A relation with all that is said before it is decided.

    text     the LaTeX that is read
    follows  the relations it follows from
    given    conditions of the auditor
    letters  what letters are, as `decide` takes it
    reading  how the text comes from the source
    told     the same in words, where it is not as printed
    near     relations beside it of which nobody claims that they hold, with their places: conditions, perhaps
    alone    whether the auditor says that there are no other conditions
    goes_on  whether it begins with a sign in the source, and goes on with the display above it
    units    of letters, as the auditor or the words of the source say them
    """

    text: str
    follows: tuple[Relied, ...] = ()
    given: tuple[str, ...] = ()
    letters: Said = ()
    reading: Reading = Reading.AS_PRINTED
    told: str = ""
    near: tuple[tuple[str, str], ...] = ()
    alone: bool = False
    goes_on: bool = False
    units: Said = ()

    @property
    def assumed(self) -> tuple[str, ...]:
        """All that it rests on."""
        return (*(each.text for each in self.follows), *self.given)

    @property
    def links(self) -> dict[str, str]:
        """Its relations, by the letters of their links."""
        return dict(_links(self.text, self.said(self.text)).lettered)

    def records(self, item: Declaration, base: Record) -> tuple[Record, ...]:
        """One for each relation that it prints, or the one that says why it is not read."""
        rows = self._records(item, base)
        return tuple(record_with(row, dimension=self._dimension(row.read)) if row.read else row for row in rows)

    def _dimension(self, text: str) -> Dimensions | None:
        """Whether the terms of a relation fit by the units of its letters; None if not one of these is known."""
        names = {spelled(name) for each in (text, *self.assumed) for name in surveyed_once(each).names}
        units = tuple((letter, unit) for letter, unit in self.units if spelled(letter) in names)
        where = tuple(each.text for each in self.follows)
        return measured_by(Measuring(text, units, where, self.said(text, *where))) if units else None

    def _records(self, item: Declaration, base: Record) -> tuple[Record, ...]:
        base = record_with(base, reading=self.reading, reason=self._said_of(base.reason))
        if item.role is Role.EXCLUSION:
            return (base,)
        try:
            links = _links(self.text, self.said(self.text))
        except SymcheckError as error:
            open_ = Verdict.UNDECIDED if isinstance(item, Assertion) else None
            return (record_with(base, verdict=open_, reason=self._said_of(f"not read: {error}")),)
        if not isinstance(item, Assertion):
            return (record_with(base, read=links.read),)
        return tuple(self._of_links(item, base, links))

    def _of_links(self, item: Assertion, base: Record, links: Links) -> Iterator[Record]:
        for letter, link in links.lettered:
            row = record_with(base, id=base.id + letter, read=link if letter else links.read)
            row = record_with(row, line=item.source.lines.get(letter, item.source.line))
            if item.statement.imposes(letter):
                yield record_with(row, role=Role.PREMISE, reason="what the letter is, and no claim")
            else:
                chained = self.goes_on or letter not in ("", "a")
                yield self._decided(row, link, item.erratum(letter), chained)

    def _decided(self, row: Record, link: str, erratum: Erratum | None, chained: bool) -> Record:
        whole = self._question(link)
        readable = _readable(whole)
        asked = _independent(readable)
        if general := self._general(row, asked):
            return self._corrected(general, link, erratum, Answer(Status.PROVED)) if erratum else general
        answer = _proof(_fewer(asked)) or _answer(asked, self.alone or (chained and _is_identity(asked)))
        if answer.verdict is Status.REFUTED:
            unread = [each for each in whole.where if each not in readable.where]
            doubt = f"it fails, but nothing is read of {unread[0]}, from which it follows" if unread else ""
            doubt = doubt or (
                f"it fails for matrices; which of its letters are vectors? {SAY}" if is_open(link) else ""
            )
            if not (doubt or self.alone or self.given or erratum):
                doubt = self._doubt(asked, answer)
            if doubt:
                answer = Answer(Status.UNDECIDED, reason=doubt, seconds=answer.seconds)
        verdict = VERDICTS.get(answer.verdict, Verdict.UNDECIDED)
        proofs = self._certificates(row.id, asked, answer)
        row = record_with(row, verdict=verdict, method=METHOD, seconds=round(answer.seconds, 4), certificates=proofs)
        row = record_with(
            row, hypotheses=tuple(self._hypotheses(verdict, proofs)), reason=self._said_of(_reason(answer))
        )
        if verdict is Verdict.REFUTED:
            row = record_with(row, origin=Origin.PAPER, kind="fails")
        return self._corrected(row, link, erratum, answer) if erratum else row

    def _general(self, row: Record, asked: Asked) -> Record | None:
        """The record of a relation that is proved for matrices of all sizes; None if it is not."""
        started = time.perf_counter()
        if (found := _for_all_sizes(row.id, asked)) is None:
            return None
        proofs, taken = found
        return record_with(
            row,
            verdict=Verdict.PROVED,
            method=METHOD,
            certificates=proofs,
            hypotheses=tuple(self._hypotheses(Verdict.PROVED, proofs)),
            reason=self._said_of(taken),
            seconds=round(time.perf_counter() - started, 4),
        )

    def _doubt(self, asked: Asked, answer: Answer) -> str:
        """Why what fails may hold all the same, under a condition that is printed elsewhere; "" if nothing says so."""
        if holds_elsewhere(asked):
            return f"it fails, but holds for some positive numbers; {SAY}"
        with suppress(OutOfTime), limited(DOUBTING):
            for place, text in self._beside(asked):
                if asked.where and _proof(_resting_on(replace(asked, relation=text), asked.where)):
                    continue  # it says nothing new
                said = self.said(asked.relation, *asked.where, text)
                with_it = answered(asked.relation, asked.where, (*asked.given, text), dict(said), wanted=False)
                if with_it.verdict not in (Status.REFUTED, Status.UNREADABLE):
                    return f"it fails, but perhaps not where {text} ({place}); {SAY}"
        identity = not asked.where and all(role.kind in NUMBERS for role in surveyed_once(asked.relation).roles)
        if answer.repairs or identity or any(slips(asked.relation, asked.where, asked.letters)):
            return ""
        if any(_is_explained(each) for each in dict.fromkeys((_fewer(asked), asked))):
            return ""
        return f"it fails, and no slip of the pen would explain it; {SAY}"

    def _beside(self, asked: Asked) -> Iterator[tuple[str, str]]:
        """The relations beside a claim that speak of its letters alone."""
        names = {x for text in (asked.relation, *asked.where) for x in surveyed_once(text).names}
        for place, text in self.near:
            seen = surveyed_once(text)
            if not seen.reason and seen.names and seen.names <= names:
                yield place, text

    def _corrected(self, row: Record, link: str, erratum: Erratum, printed: Answer) -> Record:
        """The same with what is right instead, which is asked as well."""
        needs = tuple(each.states for each in erratum.needs)
        asked = self._asked(erratum.corrected or link, needs)
        general = _for_all_sizes(row.id, asked)
        answer = Answer(Status.PROVED, reason=general[1]) if general else _answer(asked, claimed=True)
        forms = tuple(Repair(**each) for each in printed.repairs)
        correction = Correction(
            verdict=VERDICTS.get(answer.verdict, Verdict.UNDECIDED),
            reason=answer.reason,
            certificates=general[0] if general else self._certificates(row.id, asked, answer),
            edit=differences(link, erratum.corrected) if erratum.corrected else (),
            added=tuple(each.words for each in erratum.needs),
            repairs=forms,
            unique=len(forms) == 1,
            empty=False,
            row=bool(erratum.shown),
            summary=erratum.summary,
            instead=erratum.instead,
        )
        found = Reading.MISPRINT if erratum.corrected else Reading.NEEDS_HYPOTHESIS
        given = "; ".join(each.words for each in erratum.needs)
        return record_with(
            row,
            reading=found if self.reading is Reading.AS_PRINTED else self.reading,
            kind=erratum.kind,
            origin=erratum.origin,
            reason=self._said_of(erratum.reason),
            corrected=erratum.shown or erratum.corrected or f"{link} (given: {given})",
            erratum=correction,
        )

    def _said_of(self, reason: str) -> str:
        """A reason, with how the text comes from the source."""
        return "; ".join(filter(None, (reason, self.told)))

    def _asked(self, link: str, needs: Sequence[str] = ()) -> Asked:
        """The question as `decide` takes it, with what can be read."""
        return _independent(_readable(self._question(link, needs)))

    def _question(self, link: str, needs: Sequence[str] = ()) -> Asked:
        """The question with all that it follows from."""
        where, given = list[str](), [*self.given, *needs]
        for each in self.follows:
            for part, is_equation in _parts(each, self.letters):
                (where if is_equation else given).append(part)
        said = self.said(link, *where, *given)
        return Asked(link, tuple(dict.fromkeys(where)), tuple(dict.fromkeys(given)), said)

    def verdict(self, link: str) -> Status:
        """What is said of one relation, or of another one in its place, with what it follows from."""
        asked = self._asked(link)
        if _for_all_sizes("", asked):
            return Status.PROVED
        return (_proof(_fewer(asked)) or _answer(asked, wanted=False)).verdict

    def readings(self, link: str) -> list[ReadAs]:
        """The likely readings of one relation with what it follows from; of matrices of all sizes without problems."""
        asked = plainly(self._asked(link))
        try:
            found = readings(asked)
        except SymcheckError:
            return unlowered(asked)
        return [each for each in found if not each.inference.remote] or found

    def said(self, *texts: str) -> Said:
        """What is said of letters beyond what each formula alone shows of them."""
        every = {shown(role.letter) for text in texts for role in surveyed_once(text).roles}
        known = {shown(letter): phrase for letter, phrase in self._letters if phrase and depends_on(phrase) <= every}
        roles = [role for text in texts for role in surveyed_once(text).roles if role.kind not in UNSAID]
        found = {role.letter: known.get(shown(role.letter), "") for role in roles}
        named = any(ONE_NAME in surveyed_once(text).reason for text in texts)
        declared = {shown(letter) for letter, _ in self.letters} if named else set()
        plain = {r.letter for r in roles if r.kind == "scalar" and shown(r.letter) in declared and not found[r.letter]}
        found |= dict.fromkeys(plain, "scalar")
        return tuple((x, p) for x, p in found.items() if p and any(r.letter == x and r.phrase != p for r in roles))

    @property
    def _letters(self) -> Said:
        """What letters are; of a relation whose links are read apart, as they are in the whole."""
        seen = surveyed_once(self.text)
        own = tuple((role.letter, role.phrase) for role in seen.roles if seen.apart and is_sayable(role.phrase))
        return (*own, *self.letters)

    def _certificates(self, id: str, asked: Asked, answer: Answer) -> tuple[Certificate, ...]:
        if answer.verdict not in VERDICTS:
            return ()
        made = cast(tuple[Certificate, ...], answer.certificate)  # those about all sizes have been asked for before
        return tuple(_renamed(each, id, _names(asked, each)) for each in made)

    def _hypotheses(self, verdict: Verdict, proofs: Sequence[Certificate]) -> Iterator[HypothesisRow]:
        used = {name for proof in proofs for name in proof["hypotheses"]}
        for text in dict.fromkeys((*self.given, *sorted(used))):
            needless = verdict is Verdict.PROVED and text not in used
            need = Need(needed=False if needless else None)
            yield HypothesisRow(name=text, words=text, states=text, given="printed", need=need)

    def stated(self, item: Declaration, certificate: Certificate) -> Stated | None:
        """What is printed, or put in its place, read anew: that of which a certificate is one; None if it is none."""
        assert isinstance(item, Assertion)
        letter = Id.parse(certificate["id"]).link
        link = dict(_links(self.text, self.said(self.text)).lettered).get(letter)
        if link is None:
            return None
        forms = [("as printed", self._asked(link))]
        if erratum := item.erratum(letter):
            needs = [each.states for each in erratum.needs]
            forms.append(("as corrected", self._asked(erratum.corrected or link, needs)))
        for what, asked in forms:
            if "matrices" in certificate:
                if found := _stated_of_matrices(what, asked, cast(MatrixProof, certificate)):
                    return found
                continue
            names = _names(asked, certificate)
            problems = [problem for reading in readings(plainly(asked)) for problem in reading.problems]
            for problem in (*problems, *map(with_plain_divisors, problems)):
                stated = _stated(what, problem, names)
                if line(problem.claim) == line(certificate["claim"]) and stated.covers(certificate):
                    return stated
        return None


def _for_all_sizes(id: str, asked: Asked) -> tuple[tuple[Certificate, ...], str] | None:
    """The proofs for matrices of all sizes, and what is assumed in words; None if there are none."""
    for each in dict.fromkeys((_fewer(asked), asked)):
        if found := proved_for_all_sizes(plainly(each)):
            names = _unlike(found.told)
            proofs = tuple(_with_names(proof, id, names) for proof in found.certificates)
            return proofs, f"for matrices and vectors of all sizes; assumed: {', '.join(found.used) or 'nothing'}"
    return None


def is_settled(inquiry: Inquiry, imposed: str) -> bool:
    """Whether each relation of a claim is proved, or a slip of the pen would explain that it fails."""
    return all(answer.verdict is Status.PROVED or answer.repairs for answer in _answers(inquiry, imposed))


def is_proved(inquiry: Inquiry, imposed: str) -> bool:
    """Whether each relation of a claim is proved."""
    return all(answer.verdict is Status.PROVED for answer in _answers(inquiry, imposed))


def verdicts(inquiry: Inquiry, imposed: str) -> tuple[Status, ...]:
    """What becomes of each relation of a claim."""
    return tuple(answer.verdict for answer in _answers(inquiry, imposed))


def _answers(inquiry: Inquiry, imposed: str) -> Iterator[Answer]:
    """The answer to each relation of a claim, with repairs when they are asked for."""
    try:
        for letter, link in _links(inquiry.text, inquiry.said(inquiry.text)).lettered:
            if not letter or letter not in imposed:
                asked = inquiry._asked(link)
                yield _proof(_fewer(asked)) or _answer(asked)
    except SymcheckError as error:
        yield Answer(Status.UNREADABLE, reason=str(error))


@dataclass(frozen=True)
class Stated:
    """What is stated: what it is, its hypotheses and definitions by name."""

    what: str
    hypotheses: dict[str, list[Formula]]
    definitions: dict[str, Term]

    def covers(self, certificate: Certificate) -> bool:
        """Whether a certificate rests on nothing else; one that refutes keeps to all hypotheses."""
        own = {name: {*map(line, formulas)} for name, formulas in self.hypotheses.items()}
        theirs = {name: {*map(line, formulas)} for name, formulas in certificate["hypotheses"].items()}
        defined = {name: line(term) for name, term in self.definitions.items()}
        if certificate["verdict"] == Verdict.REFUTED and own != theirs:
            return False
        known = all(formulas <= own.get(name, set()) for name, formulas in theirs.items())
        return known and all(defined.get(name) == line(term) for name, term in certificate["definitions"])


def _stated_of_matrices(what: str, asked: Asked, proof: MatrixProof) -> Stated | None:
    """What is printed of matrices of all sizes, if a certificate claims it of no other shapes and inverses."""
    for each in dict.fromkeys((_fewer(asked), asked)):
        for reading in unlowered(plainly(each)):
            for said in stated(reading):
                names = _unlike(said.printed)
                for statement in said.statements:
                    assumed = {names.get(name, name): [*both] for name, both in statement.hypotheses.items()}
                    shapes = {x: [*statement.shapes[x]] for x in proof["matrices"] if x in statement.shapes}
                    inverses = {x: statement.inverses.get(x) for x in proof["inverses"]}
                    same = proof["claim"] == [*statement.claim] and proof["matrices"] == shapes
                    known = all(assumed.get(name) == both for name, both in proof["hypotheses"].items())
                    if same and known and proof["inverses"] == inverses:
                        return Stated(what, cast(dict[str, list[Formula]], assumed), {})
    return None


def _unlike(printed: Mapping[str, str]) -> dict[str, str]:
    """What hypotheses say, by their names; of several that are printed in one place the second has a number."""
    count = Counter[str]()
    found = {}
    for name, text in printed.items():
        count[text] += 1
        found[name] = text if count[text] == 1 else f"{text} [{count[text]}]"
    return found


def _with_names(proof: MatrixProof, id: str, names: Mapping[str, str]) -> Certificate:
    """The certificate of a question about matrices as that of a relation, with its hypotheses by what they say."""
    steps = [[_with_name(reference, names), term] for reference, term in proof["proof"]]
    assumed = {names.get(name, name): both for name, both in proof["hypotheses"].items()}
    return cast(Certificate, {**proof, "id": id, "hypotheses": assumed, "proof": steps})


def _with_name(reference: JSON, names: Mapping[str, str]) -> JSON:
    match reference:
        case ["hypothesis" | "turned" as kind, str(name)]:
            return [kind, names.get(name, name)]
    return reference


def _stated(what: str, problem: Problem, names: Mapping[str, str]) -> Stated:
    hypotheses = {names.get(name, name): [*_parted(formulas)] for name, formulas in problem.hypotheses}
    return Stated(what, hypotheses, dict(problem.definitions))


surveyed_once = cache(surveyed)


@cache
def _tree(text: str, said: Said) -> Tree:
    """A relation as it is read alone."""
    try:
        return readings(plainly(Asked(text, letters=said)))[0].tree
    except Understood as error:
        return error.tree


class Links(NamedTuple):
    """The relations of a formula: what is read, the relations with the letters of their links, and their signs."""

    read: str
    lettered: list[tuple[str, str]]
    signs: list[str]


def _links(text: str, said: Said) -> Links:
    """The relations of a formula; one alone is asked as it is printed.

    Those of a chain that is not read as a whole are read apart.
    """
    try:
        tree = _tree(text, said)
    except SymcheckError:
        links = apart(text)
        if not surveyed_once(text).apart:
            raise
        return Links(text, _lettered(links), ["="] * len(links))
    every = relations(tree)
    lettered = _lettered([link.latex for link in every]) if len(every) > 1 else [("", text)]
    return Links(to_latex(tree), lettered, [link.sign for link in every] or [""])


def _lettered(links: Sequence[str]) -> list[tuple[str, str]]:
    return [(chr(ord("a") + n), link) for n, link in enumerate(links)]


def _parts(relied: Relied, letters: Said) -> list[tuple[str, bool]]:
    """The relations of one that is relied on, and whether each is an equation."""
    said = Inquiry(relied.text, letters=letters).said(relied.text)
    try:
        links = _links(relied.text, said)
    except SymcheckError:
        return [(relied.text, False)]  # told where it is asked
    chosen = zip(links.lettered, links.signs, strict=False)
    return [(text, sign == "=") for (letter, text), sign in chosen if not relied.defines or letter in relied.defines]


@cache
def _readable(asked: Asked) -> Asked:
    """The question without those relations that it follows from with which it cannot be read, if it can be without."""
    if not asked.where or _is_read(asked) or not _is_read(_resting_on(asked, ())):
        return asked
    kept = tuple[str, ...]()
    for each in asked.where:
        if _is_read(_resting_on(asked, (*kept, each))):
            kept = (*kept, each)
    return _resting_on(asked, kept)


@cache
def _independent(asked: Asked) -> Asked:
    """The question without those equations that follow from one behind them, as the lines of a derivation do."""

    def is_implied(k: int, each: str) -> bool:
        names = surveyed_once(each).names
        behind = [(other, surveyed_once(other).names) for other in asked.where[k + 1 :]]
        later = (other for other, theirs in behind if names and theirs and (names <= theirs or theirs <= names))
        return any(_proof(_resting_on(replace(asked, relation=each), (other,))) for other in later)

    kept = tuple(each for k, each in enumerate(asked.where) if not is_implied(k, each))
    return asked if kept == asked.where else _resting_on(asked, kept)


def _resting_on(asked: Asked, where: tuple[str, ...]) -> Asked:
    """The question with other definitions, and what is said of the letters that are left."""
    every = {shown(role.letter) for x in (asked.relation, *where, *asked.given) for role in surveyed_once(x).roles}
    said = tuple((letter, phrase) for letter, phrase in asked.letters if {shown(letter), *depends_on(phrase)} <= every)
    return replace(asked, where=where, letters=said)


def _is_read(asked: Asked) -> bool:
    try:
        return bool(readings(plainly(asked)))
    except SymcheckError:
        return False


def _answer(asked: Asked, claimed: bool = False, wanted: bool = True) -> Answer:
    """The answer, with repairs if they are wanted and there is time."""
    arguments = asked.relation, asked.where, asked.given, dict(asked.letters)
    answer = None
    with suppress(OutOfTime), limited(REPAIRING):
        answer = answered(*arguments, wanted=wanted, claimed=claimed, all_sizes=False)
    return answer or answered(*arguments, wanted=False, claimed=claimed, all_sizes=False)


def _is_identity(asked: Asked) -> bool:
    """Is the link of a chain meant for all values of its letters? It has the same numbers on both sides."""
    seen = surveyed_once(asked.relation)
    same = all(link.names[0] == link.names[1] and min(link.sizes) >= SMALLEST for link in seen.links)
    return not asked.where and len(seen.links) == 1 and same and all(role.kind in NUMBERS for role in seen.roles)


def _proof(asked: Asked) -> Answer | None:
    """The answer if it is a proof."""
    with suppress(OutOfTime), limited(PROVING):
        said = dict(asked.letters)
        answer = answered(asked.relation, asked.where, asked.given, said, wanted=False, all_sizes=False)
        return answer if answer.verdict is Status.PROVED else None
    return None


def _is_explained(asked: Asked) -> bool:
    """Whether a slip of the pen, in a relation or in a definition, would explain that it fails.

    For a slip in a definition the two change places.
    """
    questions = [(asked.relation, asked.where)]
    for k, definition in enumerate(asked.where):
        questions.append((definition, (*asked.where[:k], asked.relation, *asked.where[k + 1 :])))
    with suppress(OutOfTime), limited(REPAIRING):
        return any(answered(each, where, asked.given, dict(asked.letters)).repairs for each, where in questions)
    return False


def _fewer(asked: Asked) -> Asked:
    """The question with no more definitions than it takes for the same letters on both sides; all if that fails.

    The letter that is defined last is unfolded first.
    """
    seen = surveyed_once(asked.relation)
    if len(seen.links) != 1:
        return asked
    sides = [names & seen.names for names in seen.links[0].names]
    defined = {x: (n, link.names[1]) for n, text in enumerate(asked.where) for x, link in _heads(text)}
    used = set[int]()
    while sides[0] != sides[1]:
        last = max((sides[0] ^ sides[1]) & defined.keys(), key=lambda x: defined[x][0], default="")
        if not last:
            return asked
        n, names = defined.pop(last)
        used.add(n)
        sides = [(side - {last}) | names if last in side else side for side in sides]
    return _resting_on(asked, tuple(text for n, text in enumerate(asked.where) if n in used))


def _heads(text: str) -> Iterable[tuple[str, Link]]:
    return surveyed_once(text).heads.items()


def _reason(answer: Answer) -> str:
    if answer.repairs:
        return "one slip away holds: " + " or ".join(f"${each['relation']}$" for each in answer.repairs[:2])
    if answer.verdict is Status.VACUOUS:
        return answer.reason or "what it follows from contradicts itself, so that anything follows"
    return TOLD.get(answer.verdict, "") + answer.reason


def _parted(formulas: Sequence[Formula]) -> Iterator[Formula]:
    return (part for formula in formulas for part in conjuncts(formula))


def _names(asked: Asked, certificate: Certificate) -> dict[str, str]:
    """What the hypotheses of a certificate are called in print, by their names in the problems."""
    for reading in readings(plainly(asked)):
        printed = {**reading.stated, DEFINED: VALUED}
        names = {name: _printed(name, printed) for problem in reading.problems for name, _ in problem.hypotheses}
        names |= {LEADING: SOLVABLE}
        if {*certificate["hypotheses"]} <= {*names, *names.values()}:
            return names
    return {}


def _printed(name: str, stated: Mapping[str, str]) -> str:
    words, _, last = name.rpartition(" ")
    return f"{words} {stated.get(last, last)}".lstrip() if name not in stated else stated[name]


def _renamed(certificate: Certificate, id: str, names: Mapping[str, str]) -> Certificate:
    """The certificate of a question as that of a relation, with its hypotheses by what they say."""

    def changed(part: Any) -> Any:
        match part:
            case ["hyp", str(name), number]:
                return ["hyp", names.get(name, name), number]
            case list():
                return [changed(each) for each in part]
            case dict():
                return {key: changed(each) for key, each in part.items()}
        return part

    new: Certificate = changed(certificate)
    new["id"], new["hypotheses"] = id, {names.get(n, n): formulas for n, formulas in new["hypotheses"].items()}
    return new
