"""Proved, refuted or undecided: the relations of a declaration put to its proof method, lemmas first."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cache, cached_property

from symcheck import papers
from symcheck.audit.context import Context
from symcheck.core.certificates import Certificate
from symcheck.core.claims import Assertion, Hypothesis, for_letter
from symcheck.core.formulas import conjuncts, contrary
from symcheck.core.ids import Id
from symcheck.core.problems import Method, Outcome, Problem
from symcheck.core.terms import Formula, Term, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.proof import Lemmas, certificate, combined, proof_of, refute
from symcheck.reading import Notation, Relation, System, Tree, from_sympy, lower, read, relations, to_latex

Definitions = tuple[tuple[str, Term], ...]


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
    derived = [from_sympy(value) for value in equation()] if (equation := item.statement.equation) else []
    found = []
    for letter, link in links(item, context.notation):
        count = len(lower(link, context.notation)) if derived else 0
        found.append(Unit(letter, link, tuple(derived[:count]), _formulas(context, link, tuple(derived[:count]))))
        derived = derived[count:]
    if derived:
        raise SymcheckError(f"{context.id}: {len(derived)} more equations are derived than printed")
    return found


def links(item: Assertion, notation: Notation) -> list[tuple[str, Tree]]:
    """The links of a declaration, each with its letter."""
    if item.stated:
        trees = [read(form, notation) for form in item.stated]
    else:
        trees = [_statement(link) for link in relations(read(item.text, notation))]
    letters = [chr(ord("a") + n) for n in range(len(trees))] if len(trees) > 1 else [""]
    return [*zip(letters, trees, strict=True)]


def _statement(link: Relation) -> Tree:
    """One link as a separate statement."""
    return System((link.tree,), link.qualifiers) if link.qualifiers else link.tree


def _formulas(context: Context, tree: Tree, derived: tuple[Term, ...]) -> tuple[Formula, ...]:
    """The lowered statement. With a derived equation E = 0, a printed l = r claims that l - r is E."""
    formulas = lower(tree, context.notation)
    if not derived:
        return formulas
    if len(formulas) != len(derived) or any(formula[0] != "=" for formula in formulas):
        raise SymcheckError(f"{context.id}: {len(derived)} derived equations cannot be compared with {to_latex(tree)}")
    return tuple(
        node("=", left if right == 0 else node("+", left, node("-", right)), term)
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
    sources: tuple[Lemmas, ...]

    @cached_property
    def certificates(self) -> tuple[Certificate, ...]:
        """One for each decided instance.

        A proof from lemmas names these, whose own certificates the checker looks for, and what is assumed for them.
        """
        each = zip(self.problems, self.outcomes, self.sources, strict=True)
        return tuple(
            certificate(problem, outcome, None if problem is start.whole else start)
            for problem, outcome, start in each
            if outcome.verdict is not Verdict.UNDECIDED
        )

    @property
    def reason(self) -> str:
        return "; ".join(dict.fromkeys(o.reason for o in self.outcomes if o.reason))


def proofs(problems: Iterable[Problem]) -> tuple[Certificate, ...] | None:
    """A certificate for each problem, or None if one has no proof."""
    found = []
    for problem in problems:
        if (outcome := proof_of(problem)) is None:
            return None
        found.append(certificate(problem, outcome))
    return tuple(found)


Statement = tuple[tuple[Formula, ...], tuple[Hypothesis, ...], Method]


def _stated(context: Context, unit: Unit, given: tuple[Hypothesis, ...]) -> Statement:
    """What one unit claims, under which hypotheses, and the method that shows it."""
    return unit.formulas, given, context.method(unit.letter)


def _attained(context: Context, unit: Unit, given: tuple[Hypothesis, ...]) -> Statement | None:
    """The same of the set of equality of an inequality, if one is declared."""
    if not (equality := for_letter(context.item.statement.equality, unit.letter)):
        return None
    hypotheses = (*given, *context.item.statement.equality_given)
    return equality_claims(context, unit, equality), hypotheses, combined(context.method(unit.letter))


def _problems(
    context: Context, formulas: tuple[Formula, ...], given: tuple[Hypothesis, ...], method: Method
) -> tuple[Problem, ...]:
    return tuple(context.problem(formula, given, method, n) for n, formula in enumerate(formulas))


def problems(context: Context, unit: Unit, given: tuple[Hypothesis, ...]) -> tuple[Problem, ...]:
    """What there is to prove of one unit: of the relation, and then of its set of equality."""
    context = context.having(letter=unit.letter)
    statements = filter(None, (_stated(context, unit, given), _attained(context, unit, given)))
    return tuple(problem for statement in statements for problem in _problems(context, *statement))


def _find(context: Context, formulas: tuple[Formula, ...], given: tuple[Hypothesis, ...], method: Method) -> Finding:
    concrete = _problems(context, formulas, given, method)
    problems, outcomes = list(concrete), []
    premises = _premises(context, given)
    for n, problem in enumerate(concrete):
        if context.doubted and (point := refute(problem)) is not None:
            outcomes.append(Outcome(Verdict.REFUTED, point=point, used=tuple(name for name, _ in problem.hypotheses)))
            continue
        outcome = None
        if premises:
            stated = _all(tuple(formula for _, formula in premises))
            short = context.abstract().problem(node("=>", stated, formulas[n]), given, method, n)
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
    lemmas = tuple(context.lemmas)
    sources = tuple(_source(context, problem, premises) for problem in concrete)
    return Finding(verdict, tuple(problems), tuple(outcomes), concrete, lemmas, sources)


def _source(context: Context, problem: Problem, premises: tuple[tuple[str, Formula], ...]) -> Lemmas:
    """The lemmas a proof may start from, and of the hypotheses in force those that these are proved under."""
    spoken = [problem.claim, *(f for _, stated in problem.hypotheses for f in stated), *(f for _, f in premises)]
    defined = (
        context.used_definitions(*spoken, *(term for hint in problem.hints for term in hint.terms)) if premises else ()
    )
    under = {name for id in dict(premises) for each in lemma(id)[1] for name in each["hypotheses"]}
    return Lemmas(premises, problem, tuple(h for h in problem.hypotheses if h[0] in under), defined)


def equality_claims(context: Context, unit: Unit, equality: str) -> tuple[Formula, ...]:
    """For l <= r: l = r exactly where `equality` holds, instance by instance."""
    where = context.lower(equality)
    paired = len(unit.formulas) == len(where) > 1
    return tuple(
        node("<=>", node("=", formula[1], formula[2]), where[n] if paired else _all(where))
        for n, formula in enumerate(unit.formulas)
    )


def _all(formulas: tuple[Formula, ...]) -> Formula:
    return formulas[0] if len(formulas) == 1 else node("and", *formulas)


def judge(context: Context, unit: Unit, given: tuple[Hypothesis, ...], extra: tuple[Hypothesis, ...] = ()) -> Finding:
    """The statement of one unit, an inequality together with its set of equality."""
    context, given = context.having(letter=unit.letter), (*given, *extra)
    finding = _find(context, *_stated(context, unit, given))
    if finding.verdict is Verdict.PROVED and any(_is_vacuous(context, each) for each in finding.concrete):
        vacuous = Outcome(Verdict.UNDECIDED, reason="the hypotheses contradict one another, so that anything follows")
        return replace(finding, verdict=vacuous.verdict, outcomes=tuple(vacuous for _ in finding.outcomes))
    equality = _attained(context, unit, given)
    if equality is None or finding.verdict is not Verdict.PROVED:
        return finding
    attained = _find(context, *equality)
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
        sources=finding.sources + attained.sources,
    )


def _is_vacuous(context: Context, problem: Problem) -> bool:
    """Whether the hypotheses are proved to contradict one another."""
    stated = tuple(part for _, formulas in problem.hypotheses for formula in formulas for part in conjuncts(formula))
    return bool(stated) and _contradictory(context.used_definitions(*stated), stated)


@cache
def _contradictory(definitions: Definitions, stated: tuple[Formula, ...]) -> bool:
    """Whether the equations have no solution, or the other conditions imply the contrary of one of them.

    Mostly there is a point at which all of them hold, and to find it takes much less than to look for proofs in vain.
    """
    if refute(Problem("together", node("=", 0, 1), definitions, (("all", stated),))) is not None:
        return False

    def follows(claim: Formula, *left_out: Formula) -> bool:
        rest = tuple(formula for formula in stated if formula not in left_out)
        return proof_of(Problem("contradiction", claim, definitions, (("others", rest),))) is not None

    return follows(node("=", 0, 1)) or any(
        follows(contrary(formula), formula) for formula in stated if formula[0] in ("<", "<=", ">", ">=", "!=")
    )


# --- earlier relations as lemmas


@cache
def lemma(name: str) -> tuple[tuple[Formula, ...], tuple[Certificate, ...]]:
    """The formulas of an earlier relation and the certificates that prove them."""
    id = Id.parse(name)
    paper = papers.load()[id.paper]
    item = next((item for _, _, item in paper.items() if item.number == id.number), None)
    if not isinstance(item, Assertion):
        raise SymcheckError(f"{id} is used as a lemma, but not claimed")
    context = Context(paper, item).without_equality()
    unit = next((unit for unit in units(context) if unit.letter == id.link), None)
    if unit is None:
        raise SymcheckError(f"{id} is used as a lemma, but {id.declaration} has no link {id.link!r}")
    finding = judge(context, unit, item.statement.given)
    if finding.verdict is not Verdict.PROVED:
        raise SymcheckError(f"{id} is used as a lemma, but not proved")
    return tuple(part for formula in unit.formulas for part in conjuncts(formula)), finding.certificates


def _premises(context: Context, given: Iterable[Hypothesis]) -> tuple[tuple[str, Formula], ...]:
    """The earlier relations the proof may start from, as far as they are proved under no more than is given."""
    names = {hypothesis.name for hypothesis in given}
    found: list[tuple[str, Formula]] = []
    for name in context.lemmas:
        formulas, proofs = lemma(name)
        if all(names >= proof["hypotheses"].keys() for proof in proofs):
            found += [(name, formula) for formula in formulas]
    return tuple(found)
