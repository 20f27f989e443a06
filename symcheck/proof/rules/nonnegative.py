"""Orders l <= r: the difference equals a form that is manifestly not negative (positive, for a strict order)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import ClassVar

from symcheck.core.problems import Problem
from symcheck.core.terms import Formula, Node, Term, mapped, node
from symcheck.proof.algebra.facts import Fact, Signed
from symcheck.proof.algebra.flint import Poly
from symcheck.proof.algebra.forms import fraction_form, stronger
from symcheck.proof.algebra.knowledge import Knowledge
from symcheck.proof.rules.identity import fewest
from symcheck.proof.rules.step import Cofactor, Factor, Step, cleared, combination


@dataclass(frozen=True)
class Nonnegative(Step):
    """An order, as larger - smaller is, up to facts, a form manifestly not negative (positive for <)."""

    rule: ClassVar[str] = "nonnegative"
    optional: ClassVar[tuple[str, ...]] = ("times",)
    form: Signed
    times: tuple[Factor, ...] = ()
    cofactors: tuple[Cofactor, ...] = ()


def prove_order(
    goal: Formula, known: Knowledge, forms: Sequence[Term] = (), problem: Problem | None = None
) -> Nonnegative | None:
    """The proof of an order at one place of a proof; with a problem, over as few of its hypotheses as will do."""
    small, large = goal.terms if goal.tag[0] == "<" else goal.terms[::-1]
    gap: Term = large if small == 0 else node("+", large, node("-", small))
    wanted = 1 if goal.tag.endswith("=") else 2
    stricter = chain(_strict(gap, known), _of_positive_roots(gap, known)) if wanted == 2 else ()
    for form in chain((*forms, gap), _derived(gap, known), stricter):
        level, grounds = known.sign(form)
        if level < wanted:
            continue
        rest = known.ring.subtract(gap, form)
        if (cofactors := _cofactors(rest.num, known, problem)) is not None:
            return Nonnegative(Signed(form, grounds), cleared(rest), combination(cofactors))
    return None


def _cofactors(poly: Poly, known: Knowledge, problem: Problem | None) -> list[Fact] | None:
    if poly == 0:
        return []
    return known.ideal().cofactors(poly) if problem is None else fewest(poly, known, problem)


def _derived(gap: Term, known: Knowledge) -> Iterator[Term]:
    """Forms found from the polynomial itself: its factors, each a combination of known signs."""
    ratio = known.ring.ratio(gap)
    for poly in (ratio.num, known.ideal().reduce(ratio.num)):
        if poly == 0:
            yield 0
        elif (form := fraction_form(gap, known, poly)) is not None:
            yield form


def _strict(gap: Term, known: Knowledge) -> Iterator[Term]:
    """Forms found from strict signs alone, their even powers of what has one sign."""
    strict = replace(known, signs=tuple(sign for sign in known.signs if sign.level == 2))
    for form in _derived(gap, strict):
        yield stronger(form, strict)


def _of_positive_roots(gap: Term, known: Knowledge) -> Iterator[Term]:
    """Forms in which the roots of what is positive are written as t/sqrt(t), which is positive."""

    def written(tree: Term) -> Term:
        if isinstance(tree, Node) and tree.tag == "sqrt" and known.sign(tree.outside[0])[0] == 2:
            return node("/", tree.outside[0], tree)
        return mapped(tree, written) if isinstance(tree, Node) and tree.tag in ("+", "-", "*", "/", "^") else tree

    for form in (gap, *_derived(gap, known)):
        if (new := written(form)) != form:
            yield new
