"""From a declaration to its ledger rows: read it, lower it, prove or refute it, and gather the evidence."""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Iterable, Iterator, Mapping
from copy import copy
from dataclasses import dataclass, fields, replace
from functools import cache, partial
from importlib.metadata import version
from pathlib import Path
from typing import Any

from symcheck import papers
from symcheck.evidence.record import Record
from symcheck.proof import cases, certificate, proof_of, refute
from symcheck.reading import Notation, Relation, System, Tree, edits, from_sympy, lower, read, relations, to_latex
from symcheck.statement import (
    Certificate,
    Erratum,
    Formula,
    Hypothesis,
    Item,
    Method,
    Origin,
    Outcome,
    Paper,
    Problem,
    Reading,
    Role,
    Section,
    SymcheckError,
    Term,
    Verdict,
)

LIBRARIES = ("sympy", "python-flint", "lark")
SOURCES = ("reading", "proof", "mechanics", "evidence/decide.py", "evidence/record.py", "statement.py")
DECIDED = (Role.CLAIM, Role.OURS)


@dataclass(frozen=True)
class Obligation:
    """One declaration to decide."""

    id: str
    paper: Paper
    section: Section
    item: Item


def expand(paper: Paper) -> tuple[Obligation, ...]:
    """All declarations of a paper in printed order."""
    return tuple(
        Obligation(f"{paper.key}:{item.number}", paper, section, replace(item, name=name))
        for section, name, item in paper.items()
    )


# --- what a result depends on


@cache
def _digest_of_sources(key: str) -> str:
    root = Path(__file__).parents[1]
    listed = [root / source for source in SOURCES] + [root / "papers" / key / "derivation.py"]
    files = [f for path in listed for f in (sorted(path.rglob("*")) if path.is_dir() else [path])]
    digest = hashlib.sha256()
    for file in files:
        if file.is_file() and file.suffix != ".pyc":
            digest.update(file.relative_to(root).as_posix().encode() + b"\0" + file.read_bytes())
    for library in LIBRARIES:
        digest.update(f"{library} {version(library)}".encode())
    return digest.hexdigest()


def _plain(value: Any) -> Any:
    """A value of a declaration as text that depends on its content only."""
    match value:
        case Method():
            return (value.name, value.hints)
        case Notation():
            return value.letters
        case Mapping():
            return sorted((key, _plain(each)) for key, each in value.items())
        case partial():
            return (_plain(value.func), value.args)
        case tuple():
            return tuple(_plain(each) for each in value)
        case _ if callable(value):
            return f"{value.__module__}.{value.__qualname__}"
    return value


def _content(item: Item) -> str:
    return repr([(f.name, _plain(getattr(item, f.name))) for f in fields(item)])


@cache
def _paper_context(key: str) -> str:
    paper = papers.load()[key]
    shared = [_content(item) for _, _, item in paper.items() if item.role is Role.DEFINITION]
    uses = [(item.number, item.uses) for _, _, item in paper.items()]
    return repr((paper.notation.letters, shared, uses, _digest_of_sources(key)))


def fingerprint(obligation: Obligation) -> str:
    """Hash of all the result depends on: the declaration, notation, definitions, our sources, library versions."""
    text = _content(obligation.item) + _paper_context(obligation.paper.key)
    return hashlib.sha256(text.encode()).hexdigest()


# --- lowering


def _names(value: Any) -> Iterator[str]:
    """Every string in a term or formula that may be a variable."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        for part in value[1:]:
            yield from _names(part)


@cache
def _definitions(key: str) -> dict[str, Term]:
    """What each defined letter of a paper stands for, instance by instance."""
    paper = papers.load()[key]
    table: dict[str, Term] = {}
    for _, _, item in paper.items():
        if item.role is not Role.DEFINITION or item.opaque:
            continue
        tree = read(item.formal or item.printed, item.notation or paper.notation)
        for formula in lower(tree, item.notation or paper.notation):
            sign, left, right = formula
            if sign != "=" or not isinstance(left, str):
                raise SymcheckError(f"{key}:{item.number} is no definition of a letter; declare it a premise or opaque")
            if table.setdefault(left, right) != right:
                raise SymcheckError(f"{key}:{item.number} defines {left} a second time and differently")
    return table


@cache
def _lowered(latex: str, notation: Notation) -> tuple[Formula, ...]:
    return lower(read(latex, notation), notation)


class Context:
    """Notation, definitions and hypotheses in force in one declaration."""

    def __init__(self, paper: Paper, item: Item) -> None:
        self.paper, self.item, self.letter = paper, item, ""
        self.doubted = False  # a counterexample is looked for before a proof
        self.notation = item.notation or paper.notation
        derived = item.where() if item.where else {}
        local = {letter.stem for letter in self.notation.letters} if item.notation else set()
        shared = {letter.stem for letter in paper.notation.letters if letter in self.notation.letters}
        redefined = local - shared
        table = {
            name: term
            for name, term in _definitions(paper.key).items()
            if not self._is_free(name) and name not in redefined
        }
        table |= {name: from_sympy(value) for name, value in derived.items()}
        self.table = table

    @property
    def id(self) -> str:
        return f"{self.paper.key}:{self.item.number}"

    def _is_free(self, name: str) -> bool:
        return name in self.item.keeping or name.split("_")[0] in self.item.keeping

    def method(self, letter: str) -> Method:
        """The proof method of one link."""
        method: Method | None = _for_letter(self.item.by, letter)
        if method is None:
            raise SymcheckError(f"{self.id}{letter} names no method; add by=...")
        return method

    def lower(self, latex: str) -> tuple[Formula, ...]:
        """The formulas of a statement of ours, in the notation in force."""
        return _lowered(latex, self.notation)

    def hypothesis(self, hypothesis: Hypothesis) -> tuple[str, tuple[Formula, ...]]:
        parts = [part for formula in self.lower(hypothesis.states) for part in _conjuncts(formula)]
        return hypothesis.name, tuple({repr(_commuted(part)): part for part in reversed(parts)}.values())[::-1]

    def hint(self, latex: str) -> list[Term]:
        """A hint as one flat sum, for each instance of a free index (one for all if it has none)."""
        return [("+", *_addends(formula[1])) for formula in self.lower(f"{latex} = 0")]

    def used_definitions(self, *values: Any) -> tuple[tuple[str, Term], ...]:
        """The definitions that the values need, each after those it needs itself."""
        ordered: dict[str, Term] = {}

        def visit(name: str, above: tuple[str, ...]) -> None:
            if name in ordered or name not in self.table:
                return
            if name in above:
                raise SymcheckError(f"{self.id}: {name} is defined by itself; use keeping=...")
            for other in _names(("", self.table[name])):
                visit(other, (*above, name))
            ordered[name] = self.table[name]

        for name in _names(("", *values)):
            visit(name, ())
        return tuple(ordered.items())

    def lemmas(self, given: Iterable[Hypothesis]) -> Formula | None:
        """The earlier relations the proof may start from, as far as they are proved under no more than is given."""
        names = {hypothesis.name for hypothesis in given}
        found: list[Formula] = []
        for number in self.item.lemmas:
            formulas, proofs = lemma(self.paper.key, number)
            if all(names >= proof["hypotheses"].keys() for proof in proofs):
                found += formulas
        return _all(tuple(found)) if found else None

    def abstract(self) -> Context:
        """The same declaration with some defined letters left free, known through earlier relations only."""
        context = copy(self)
        context.item = replace(self.item, keeping=self.item.keeping + self.item.free)
        context.table = {name: term for name, term in self.table.items() if not context._is_free(name)}
        return context

    def problem(
        self,
        formula: Formula,
        given: Iterable[Hypothesis],
        method: Method,
        instance: int = 0,
    ) -> Problem:
        """What a method is asked: the formula with the definitions and hypotheses in force."""
        hypotheses = tuple(self.hypothesis(each) for each in given)
        lowered = []
        for name, latex in method.hints:
            terms = self.hint(latex)
            lowered.append((name, terms[instance] if len(terms) > 1 else terms[0]))
        bodies = [part for _, formulas in hypotheses for part in formulas]
        definitions = self.used_definitions(formula, *bodies, *(term for _, term in lowered))
        return Problem(self.id + self.letter, formula, definitions, hypotheses, tuple(lowered))


def _commuted(term: Any) -> Any:
    """The term with factors and addends in one order, to find equations stated twice (A A^T = 1 is symmetric)."""
    if not isinstance(term, tuple):
        return term
    parts = [_commuted(part) for part in term[1:]]
    return (term[0], *(sorted(parts, key=repr) if term[0] in ("+", "*") else parts))


def _addends(term: Term) -> Iterator[Term]:
    if isinstance(term, tuple) and term[0] == "+":
        for part in term[1:]:
            yield from _addends(part)
    else:
        yield term


def _conjuncts(formula: Formula) -> Iterator[Formula]:
    if formula[0] == "and":
        for part in formula[1:]:
            yield from _conjuncts(part)
    else:
        yield formula


# --- earlier relations as lemmas


def _letter_of(paper: Paper, number: str) -> tuple[Item, str]:
    """The declaration of "2.13.1b", and "b"."""
    items = {item.number: item for _, _, item in paper.items()}
    for declared, letter in ((number, ""), (number[:-1], number[-1:])):
        if declared in items:
            return items[declared], letter
    raise SymcheckError(f"{paper.key}:{number} is used as a lemma, but not declared")


@cache
def lemma(key: str, number: str) -> tuple[tuple[Formula, ...], tuple[Certificate, ...]]:
    """The formulas of an earlier relation and the certificates that prove them."""
    paper = papers.load()[key]
    item, letter = _letter_of(paper, number)
    context = Context(paper, replace(item, equality=""))
    unit = next((unit for unit in units(context) if unit.letter == letter), None)
    if unit is None:
        raise SymcheckError(f"{key}:{number} is used as a lemma, but {key}:{item.number} has no link {letter!r}")
    finding = judge(context, unit, item.given)
    if finding.verdict is not Verdict.PROVED:
        raise SymcheckError(f"{key}:{number} is used as a lemma, but not proved")
    return tuple(part for formula in unit.formulas for part in _conjuncts(formula)), finding.certificates


# --- deciding


@dataclass(frozen=True)
class Unit:
    """One relation of a declaration: its link letter, its tree, what it is compared with, its lowered instances."""

    letter: str
    tree: Tree
    derived: tuple[Term, ...]
    formulas: tuple[Formula, ...]

    def reworded(self, context: Context, tree: Tree) -> Unit:
        """The same unit with another statement in the place of the printed one."""
        return replace(self, tree=tree, formulas=_formulas(context, tree, self.derived))


def units(context: Context) -> list[Unit]:
    """The relations of a declaration: each link of a chain or system, or the whole formal statement."""
    item = context.item
    tree = read(item.formal or item.read_as or item.printed, context.notation)
    links = [tree] if item.formal else [_statement(link) for link in relations(tree)]
    letters = [chr(ord("a") + n) for n in range(len(links))] if len(links) > 1 else [""]
    derived = [from_sympy(value) for value in item.equation()] if item.equation else []
    found = []
    for letter, link in zip(letters, links, strict=True):
        count = len(lower(link, context.notation)) if derived else 0
        found.append(Unit(letter, link, tuple(derived[:count]), _formulas(context, link, tuple(derived[:count]))))
        derived = derived[count:]
    if derived:
        raise SymcheckError(f"{context.id}: {len(derived)} more equations are derived than printed")
    return found


def _statement(link: Relation) -> Tree:
    """One link as a statement of its own."""
    return System((link.tree,), link.qualifiers) if link.qualifiers else link.tree


def _formulas(context: Context, tree: Tree, derived: tuple[Term, ...]) -> tuple[Formula, ...]:
    """The lowered statement. With a derived equation E = 0, a printed l = r claims that l - r is E."""
    formulas = lower(tree, context.notation)
    if not derived:
        return formulas
    if len(formulas) != len(derived) or any(formula[0] != "=" for formula in formulas):
        raise SymcheckError(f"{context.id}: {len(derived)} derived equations cannot be compared with {to_latex(tree)}")
    return tuple(
        ("=", left if right == 0 else ("+", left, ("-", right)), term)
        for (_, left, right), term in zip(formulas, derived, strict=True)
    )


@dataclass(frozen=True)
class Finding:
    """What came out for one statement: the outcome of each instance, with its problem."""

    verdict: Verdict
    problems: tuple[Problem, ...]
    outcomes: tuple[Outcome, ...]
    concrete: tuple[Problem, ...]
    lemmas: tuple[str, ...]

    @property
    def certificates(self) -> tuple[Certificate, ...]:
        """One for each decided instance.

        A proof from lemmas certifies "the lemmas imply the claim"; it names the lemmas, whose own certificates the
        checker looks for, and the hypotheses in force, which those must not exceed.
        """
        found = []
        for problem, outcome, whole in zip(self.problems, self.outcomes, self.concrete, strict=True):
            if outcome.verdict is not Verdict.UNDECIDED:
                source = {} if problem is whole else {"lemmas": self.lemmas, "under": dict(whole.hypotheses)}
                found.append({**certificate(problem, outcome), **json.loads(json.dumps(source))})
        return tuple(found)

    @property
    def reason(self) -> str:
        return "; ".join(dict.fromkeys(o.reason for o in self.outcomes if o.reason))


def _find(context: Context, formulas: Iterable[Formula], given: Iterable[Hypothesis], method: Method) -> Finding:
    given, formulas = tuple(given), tuple(formulas)
    concrete = tuple(context.problem(formula, given, method, n) for n, formula in enumerate(formulas))
    problems, outcomes = list(concrete), []
    premises = context.lemmas(given)
    for n, problem in enumerate(concrete):
        if context.doubted and (point := refute(problem)) is not None:
            outcomes.append(Outcome(Verdict.REFUTED, point=point, used=tuple(name for name, _ in problem.hypotheses)))
            continue
        outcome = None
        if premises is not None:
            short = context.abstract().problem(("=>", premises, formulas[n]), given, method, n)
            if (outcome := proof_of(short)) is not None:
                problems[n] = short
        outcomes.append(outcome or method.decide(problem))
    verdicts = {outcome.verdict for outcome in outcomes}
    if Verdict.REFUTED in verdicts:
        verdict = Verdict.REFUTED
    elif verdicts == {Verdict.PROVED}:
        verdict = Verdict.PROVED
    else:
        verdict = Verdict.UNDECIDED
    lemmas = tuple(f"{context.paper.key}:{number}" for number in context.item.lemmas)
    return Finding(verdict, tuple(problems), tuple(outcomes), concrete, lemmas)


def _for_letter(value: Any, letter: str) -> Any:
    return value.get(letter) if isinstance(value, Mapping) else value


def equality_claims(context: Context, unit: Unit, equality: str) -> tuple[Formula, ...]:
    """For l <= r: l = r exactly where `equality` holds, instance by instance."""
    where = context.lower(equality)
    paired = len(unit.formulas) == len(where) > 1
    return tuple(
        ("<=>", ("=", formula[1], formula[2]), where[n] if paired else _all(where))
        for n, formula in enumerate(unit.formulas)
    )


def _all(formulas: tuple[Formula, ...]) -> Formula:
    return formulas[0] if len(formulas) == 1 else ("and", *formulas)


def judge(context: Context, unit: Unit, given: tuple[Hypothesis, ...], extra: tuple[Hypothesis, ...] = ()) -> Finding:
    """The statement of one unit, an inequality together with its set of equality."""
    context, item = copy(context), context.item
    context.letter = unit.letter
    method = context.method(unit.letter)
    finding = _find(context, unit.formulas, (*given, *extra), method)
    equality = _for_letter(item.equality, unit.letter)
    if not equality or finding.verdict is not Verdict.PROVED:
        return finding
    by = cases(*(latex for _, latex in method.hints))
    attained = _find(context, equality_claims(context, unit, equality), (*given, *extra, *item.equality_given), by)
    verdict = Verdict.PROVED if attained.verdict is Verdict.PROVED else Verdict.UNDECIDED
    outcomes = tuple(
        replace(o, reason=o.reason or "the set of equality is not as declared")
        if o.verdict is not Verdict.PROVED
        else o
        for o in attained.outcomes
    )
    return replace(
        finding,
        verdict=verdict,
        problems=finding.problems + attained.problems,
        outcomes=finding.outcomes + outcomes,
        concrete=finding.concrete + attained.concrete,
    )


# --- evidence beside the verdict


def _hypotheses(finding: Finding, item: Item, added: tuple[Hypothesis, ...]) -> tuple[dict[str, Any], ...]:
    """Each hypothesis with whether the proof needs it, and the counterexample without it."""
    rows = []
    for hypothesis in (*item.given, *added):
        need, counterexample = _need(finding, item, hypothesis.name)
        rows.append(
            {
                "name": hypothesis.name,
                "words": hypothesis.words,
                "states": hypothesis.states,
                "given": _source(hypothesis, item, added),
                "needed": need,
                "counterexample": counterexample,
            }
        )
    return tuple(rows)


def _source(hypothesis: Hypothesis, item: Item, added: tuple[Hypothesis, ...]) -> str:
    """Where a hypothesis comes from: printed, implied by the subject, added by us, or part of a statement of ours."""
    if item.role is Role.OURS:
        return "stated"
    if hypothesis in added:
        return "added"
    return "printed" if hypothesis.printed else "standing"


def _need(finding: Finding, item: Item, name: str) -> tuple[bool | None, Certificate | None]:
    """Left out, is the claim refuted somewhere (True), or proved everywhere (False)? A lemma may rest on it (None)."""
    if finding.verdict is not Verdict.PROVED:
        return None, None
    claims = [problem for problem in finding.concrete if not (problem.claim[0] == "<=>" and item.equality)]
    without = [replace(problem, hypotheses=tuple(h for h in problem.hypotheses if h[0] != name)) for problem in claims]
    for problem in without:
        if (point := refute(problem)) is not None:
            used = tuple(each for each, _ in problem.hypotheses)
            return True, certificate(problem, Outcome(Verdict.REFUTED, point=point, used=used))
    if item.lemmas or any(proof_of(problem) is None for problem in without):
        return None, None
    return False, None


def _corrected(context: Context, unit: Unit, erratum: Erratum, printed: Finding) -> tuple[Finding, dict[str, Any]]:
    """The proof of the corrected form, the edit from the printed one, and every single edit that repairs it.

    A sentence is not searched for edits (its words are ours), nor a relation that is true but empty.
    """
    item = context.item
    if erratum.corrected:
        tree = read(erratum.corrected, context.notation)
        right = unit.reworded(context, tree)
        repaired = replace(item, equality="", by=cases(*_hints(item), *erratum.forms))
        finding = judge(_with(context, repaired), right, item.given, item.needs)
    else:
        finding = judge(context, unit, item.given, item.needs)
    searched = bool(erratum.corrected) and not item.formal and printed.verdict is Verdict.REFUTED
    repairs = _repairs(context, unit) if searched else []
    return finding, {
        "verdict": finding.verdict,
        "reason": finding.reason,
        "certificates": list(finding.certificates),
        "edit": _edit(to_latex(unit.tree), erratum.corrected and to_latex(read(erratum.corrected, context.notation))),
        "added": [hypothesis.words for hypothesis in item.needs],
        "repairs": repairs if searched else None,
        "unique": len(repairs) == 1 if searched else None,
        "empty": _is_empty(printed),
    }


def _hints(item: Item) -> Iterator[str]:
    methods = item.by.values() if isinstance(item.by, Mapping) else [item.by]
    yield from dict.fromkeys(latex for method in methods if method for _, latex in method.hints)


def _with(context: Context, item: Item) -> Context:
    changed = copy(context)
    changed.item = item
    return changed


def _edit(before: str, after: str) -> list[dict[str, str]]:
    """The places where two LaTeX forms differ, token by token."""
    import difflib
    import re

    if not after:
        return []
    tokens = re.compile(r"\\[A-Za-z]+|\\.|\d+|\S")
    left, right = tokens.findall(before), tokens.findall(after)
    matcher = difflib.SequenceMatcher(None, left, right, autojunk=False)
    return [
        {"printed": " ".join(left[i:j]), "corrected": " ".join(right[k:m])}
        for kind, i, j, k, m in matcher.get_opcodes()
        if kind != "equal"
    ]


def _repairs(context: Context, unit: Unit) -> list[dict[str, str]]:
    """All single edits of the printed relation that are proved and are not empty."""
    found = []
    for edit in edits(unit.tree, context.notation):
        try:
            changed = unit.reworded(context, edit.tree)
            if _is_proved(context, changed):
                found.append({"kind": edit.kind, "edit": edit.description, "relation": to_latex(edit.tree)})
        except SymcheckError:
            continue  # an edit that makes no statement repairs nothing
    return found


def _is_proved(context: Context, unit: Unit) -> bool:
    """Whether an edited relation has a proof and is not empty; counterexamples are not looked for."""
    method, given = context.method(unit.letter), (*context.item.given, *context.item.needs)
    problems = [context.problem(formula, given, method, n) for n, formula in enumerate(unit.formulas)]
    return all(problem.claim[1] != problem.claim[2] and proof_of(problem) is not None for problem in problems)


def _is_empty(finding: Finding) -> bool:
    """Whether an inequality is true only because its sides are equal, always."""
    return finding.verdict is Verdict.PROVED and all(
        problem.claim[0] in ("<=", ">=") and proof_of(replace(problem, claim=("=", *problem.claim[1:]))) is not None
        for problem in finding.concrete
    )


# --- records


def _used_by(paper: Paper, number: str) -> tuple[str, ...]:
    return tuple(f"{paper.key}:{item.number}" for _, _, item in paper.items() if number in item.uses)


def _base(obligation: Obligation) -> Record:
    item, paper = obligation.item, obligation.paper
    return Record(
        id=obligation.id,
        paper=paper.key,
        section=obligation.section.number,
        line=item.line,
        role=item.role,
        name=item.name,
        printed="\n".join(item.printed),
        words=item.words,
        reason=item.reason,
        reading=Reading.DAMAGED if item.read_as else Reading.AS_PRINTED,
        uses=tuple(f"{paper.key}:{number}" for number in item.uses),
        used_by=_used_by(paper, item.number),
    )


def _stated(context: Context, base: Record) -> tuple[Record, ...]:
    """A definition, premise or exclusion: it is read, where it can be, but claims nothing."""
    item = context.item
    text = item.formal or item.read_as or item.printed
    if not text or item.role is Role.EXCLUSION:
        return (base,)
    return (replace(base, read=to_latex(read(text, context.notation))),)


def _claimed(context: Context, base: Record) -> Iterator[Record]:
    item, links = context.item, units(context)
    for place, unit in enumerate(links):
        started = time.perf_counter()
        row = replace(
            base, id=base.id + unit.letter, read=to_latex(unit.tree), line=item.lines.get(unit.letter, item.line)
        )
        if len(item.printed) == len(links) > 1:
            row = replace(row, printed=item.printed[place])
        if unit.letter and unit.letter in item.imposed:
            yield replace(row, role=Role.PREMISE, reason="a condition imposed here, not a claim")
            continue
        row = replace(_judged(context, unit, row), method=context.method(unit.letter).name)
        yield replace(row, seconds=round(time.perf_counter() - started, 4))


def _judged(context: Context, unit: Unit, row: Record) -> Record:
    item = context.item
    erratum = item.errata.get(unit.letter)
    sceptical = copy(context)
    sceptical.doubted = erratum is not None
    finding = judge(sceptical, unit, item.given)
    row = replace(
        row,
        verdict=finding.verdict,
        reason=finding.reason,
        certificates=finding.certificates,
        counterexample=next((o.point for o in finding.outcomes if o.verdict is Verdict.REFUTED), None),
    )
    shown = finding
    if erratum:
        right, repair = _corrected(context, unit, erratum, finding)
        misprint = bool(erratum.corrected)
        row = replace(
            row,
            reading=Reading.MISPRINT if misprint else Reading.NEEDS_HYPOTHESIS,
            kind=erratum.kind,
            origin=Origin(erratum.origin),
            reason=erratum.reason,
            corrected=erratum.corrected or f"{to_latex(unit.tree)} (given: {'; '.join(h.words for h in item.needs)})",
            erratum=repair,
        )
        if item.needs and not misprint:
            shown = right
    added = item.needs if erratum and not erratum.corrected else ()
    return replace(row, hypotheses=_hypotheses(shown, item, added))


def obligation_of(id: str) -> Obligation:
    """The declaration with this id; SymcheckError if there is none."""
    key, _, _ = id.partition(":")
    paper = papers.load().get(key)
    found = [o for o in expand(paper) if o.id == id] if paper else []
    if not found:
        raise SymcheckError(f"{id} is not declared; `symcheck check {key} --json` lists the ids")
    return found[0]


def decide(id: str) -> tuple[Record, ...]:
    """The records of one declaration: one for each relation it prints."""
    obligation = obligation_of(id)
    context = Context(obligation.paper, obligation.item)
    base = _base(obligation)
    if obligation.item.role in DECIDED:
        return tuple(_claimed(context, base))
    return _stated(context, base)
