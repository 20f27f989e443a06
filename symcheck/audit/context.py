"""One declaration with all that is in force in it: notation, definitions, hypotheses, lowered to formulas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from copy import copy
from dataclasses import replace
from functools import cache

from symcheck.audit.obligation import Obligation
from symcheck.core.claims import Assertion, Definition, Erratum, Hypothesis, Paper, for_letter
from symcheck.core.formulas import conjuncts
from symcheck.core.ids import Id
from symcheck.core.problems import Method, Problem
from symcheck.core.terms import Formula, Node, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof import combined
from symcheck.reading import Notation, from_sympy, lower, read


def _names(value: object) -> Iterator[str]:
    """Every string in a term or formula that may be a variable."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        for part in value[1:]:
            yield from _names(part)


@cache
def _definitions(paper: Paper) -> dict[str, Term]:
    """What each defined letter of a paper stands for, instance by instance."""
    table: dict[str, Term] = {}
    for _, _, item in paper.items():
        if not isinstance(item, Definition) or item.opaque:
            continue
        tree = read(item.text, item.notation or paper.notation)
        for formula in lower(tree, item.notation or paper.notation):
            sign, left, right = formula
            if sign != "=" or not isinstance(left, str):
                raise SymcheckError(
                    f"{Id(paper.key, item.number)} does not define a letter; declare it a premise or opaque"
                )
            if table.setdefault(left, right) != right:
                raise SymcheckError(f"{Id(paper.key, item.number)} defines {left} a second time and differently")
    return table


@cache
def _lowered(latex: str, notation: Notation) -> tuple[Formula, ...]:
    return lower(read(latex, notation), notation)


def context_of(obligation: Obligation) -> Context:
    """All that is in force in a declaration that claims something; SymcheckError if it does not."""
    if not isinstance(obligation.item, Assertion):
        raise SymcheckError(f"{obligation.id} is a {obligation.item.role}, of which nothing is decided; name a claim")
    if obligation.item.question:
        raise SymcheckError(f"{obligation.id} is decided without the notation of the paper; name a method with by=")
    return Context(obligation.paper, obligation.item)


class Context:
    """Notation, definitions and hypotheses in force in one declaration."""

    def __init__(self, paper: Paper, item: Assertion) -> None:
        self.paper, self.item, self.letter = paper, item, ""
        self.doubted = False  # a counterexample is looked for before a proof
        self.notation = item.notation or paper.notation
        derived = item.plan.where() if item.plan.where else {}
        local = {letter.stem for letter in self.notation.letters} if item.notation else set()
        shared = {letter.stem for letter in paper.notation.letters if letter in self.notation.letters}
        redefined = local - shared
        table = {
            name: term
            for name, term in _definitions(paper).items()
            if not self._is_free(name) and name not in redefined
        }
        table |= {name: from_sympy(value) for name, value in derived.items()}
        self.table = table

    @property
    def id(self) -> str:
        return str(Id(self.paper.key, self.item.number))

    @property
    def lemmas(self) -> list[str]:
        """The ids of the earlier relations that a proof may start from."""
        return [str(Id.of(self.paper.key, place)) for place in self.item.plan.lemmas]

    def having(
        self, *, item: Assertion | None = None, letter: str | None = None, doubted: bool | None = None
    ) -> Context:
        """A copy with some attributes changed."""
        context = copy(self)
        context.item = item or self.item
        context.letter = self.letter if letter is None else letter
        context.doubted = self.doubted if doubted is None else doubted
        return context

    def _is_free(self, name: str) -> bool:
        return name in self.item.plan.keeping or name.split("_")[0] in self.item.plan.keeping

    def method(self, letter: str) -> Method:
        """The proof method of one link."""
        method = for_letter(self.item.plan.by, letter)
        if method is None:
            raise SymcheckError(f"{self.id}{letter} names no method; add by=...")
        return method

    def lower(self, latex: str) -> tuple[Formula, ...]:
        """The formulas of a statement of ours, in the notation in force."""
        return _lowered(latex, self.notation)

    def hypothesis(self, hypothesis: Hypothesis) -> tuple[str, tuple[Formula, ...]]:
        parts = [part for formula in self.lower(hypothesis.states) for part in conjuncts(formula)]
        return hypothesis.name, tuple({repr(_commuted(part)): part for part in reversed(parts)}.values())[::-1]

    def hint(self, latex: str, instance: int) -> Term:
        """A hint as one flat sum, for an instance of a free index (one for all if it has none)."""
        found = self.lower(f"{latex} = 0")
        return node("+", *_addends(found[instance if len(found) > 1 else 0][1]))

    def used_definitions(self, *values: object) -> tuple[tuple[str, Term], ...]:
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

    def without_equality(self) -> Context:
        """The same declaration without the sets where its inequalities are equalities."""
        return self.having(item=replace(self.item, statement=replace(self.item.statement, equality="")))

    def as_corrected(self, erratum: Erratum) -> Context:
        """The declaration as it is shown for a corrected form: with all methods of its links, and further forms."""
        plan = replace(self.item.plan, by=combined(*self.item.plan.methods, forms=erratum.forms))
        return self.having(item=replace(self.item, plan=plan)).without_equality()

    def abstract(self) -> Context:
        """The same declaration with some defined letters left free, known through earlier relations only."""
        plan = replace(self.item.plan, keeping=self.item.plan.keeping + self.item.plan.free)
        context = self.having(item=replace(self.item, plan=plan))
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
        hints = tuple(hint.mapped(lambda latex: self.hint(latex, instance)) for hint in method.hints)
        bodies = [part for _, formulas in hypotheses for part in formulas]
        self.notation.refuse_undefined(self.table, formula, *bodies)
        definitions = self.used_definitions(formula, *bodies, *(term for hint in hints for term in hint.terms))
        return Problem(self.id + self.letter, formula, definitions, hypotheses, hints)


def _commuted(term: Term) -> Term:
    """The term with factors and addends in one order, to find equations stated twice (A A^T = 1 is symmetric)."""
    if not isinstance(term, Node):
        return term
    new = mapped(term, _commuted)
    return node(new.tag, *sorted(new.outside, key=repr)) if new.tag in ("+", "*") else new


def _addends(term: Term) -> Iterator[Term]:
    if isinstance(term, tuple) and term[0] == "+":
        for part in term[1:]:
            yield from _addends(part)
    else:
        yield term
