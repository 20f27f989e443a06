"""Whether a statement is one of the term language, before anything is looked for."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace

from symcheck.core.calculus import letters, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import (
    ENDS,
    FORMULAS,
    RELATIONS,
    SHAPES,
    TERMS,
    Binder,
    Call,
    Malformed,
    Node,
    Quantified,
    Reader,
    Term,
    mapped,
    node,
)
from symcheck.proof.algebra.knowledge import formulas_of
from symcheck.proof.algebra.variables import CONSTANTS, Unsupported, table

MAX_DEPTH = 200  # of a term: what walks through it is recursive
MAX_ORDER = 8  # of a derivative, as in the checker


def checked(problem: Problem) -> Problem:
    """The problem with its letters apart; Unsupported unless claim, hypotheses and definitions are well formed."""
    try:
        for name, term in problem.definitions:
            _letter(name)
            _check(term, TERMS)
        for formula in (problem.claim, *(f for _, formulas in problem.hypotheses for f in formulas)):
            _require(isinstance(formula, Node), f"{formula!r:.80} is not a statement")
            _check(formula, FORMULAS)
    except Malformed as error:
        raise Unsupported(str(error)) from error
    return _apart(problem)


def _apart(problem: Problem) -> Problem:
    """The same problem with other letters bound where one is also free: the search tells letters by their names."""
    defined = dict(problem.definitions)
    free = set().union(*map(letters, (*formulas_of(problem), *defined.values())), defined)

    def renamed(tree: Term) -> Term:
        if not isinstance(tree, Node):
            return tree
        new = mapped(tree, renamed)
        if not isinstance(new, Binder) or new.letter not in free or letters(new.body) & defined.keys():
            return new
        name = table().letter(table().fresh(new.letter))
        return node(new.tag, substituted(new.body, {new.letter: name}), name, *new.outside)

    hypotheses = tuple((name, tuple(mapped(f, renamed) for f in formulas)) for name, formulas in problem.hypotheses)
    definitions = tuple((name, renamed(term)) for name, term in problem.definitions)
    return replace(problem, claim=mapped(problem.claim, renamed), definitions=definitions, hypotheses=hypotheses)


def _require(condition: bool, what: str) -> None:
    if not condition:
        raise Unsupported(what)


def _letter(name: str) -> None:
    _require(Reader.letter(name) not in CONSTANTS, f"{name!r} is not the name of a letter")


def _check(tree: object, allowed: Set[str], depth: int = 0) -> None:
    if isinstance(tree, str):
        _letter(tree)
    if type(tree) is int or isinstance(tree, str):
        return
    if not isinstance(tree, Node) or depth >= MAX_DEPTH:
        raise Unsupported(f"{tree!r:.80} is not a term")
    kind, count = SHAPES[tree.tag]
    _require(tree.tag in allowed and type(tree) is kind, f"{tree!r:.80} is not a {_WORDS[allowed is FORMULAS]}")
    _require(count in (None, len(tree) - 1), f"the term {tree.tag!r} of {len(tree) - 1} parts is not known")
    for x in tree.bound:
        _letter(x)
    _require(not isinstance(tree, Quantified) or tree.bound != (), "a quantifier without letters")
    if isinstance(tree, Call):
        _letter(tree.function)
        whole = all(type(n) is int and 0 <= n <= MAX_ORDER for n in tree.orders)
        _require(whole and 0 < len(tree.orders) == len(tree.terms), f"the orders {tree.orders} of {tree.function}")
    if tree.tag in ("^", "diff"):
        order = tree[2] if tree.tag == "^" else tree[3]
        fits = type(order) is int and (tree.tag == "^" or 0 < order <= MAX_ORDER)
        _require(fits, f"{order!r:.40} does not fit as an exponent or order")
    inner = FORMULAS if tree.tag in FORMULAS and tree.tag not in RELATIONS else TERMS
    outer = ENDS if isinstance(tree, Binder) and tree.tag in ("integral", "diverges", "sum") else inner
    for parts, own in ((tree.inside, inner), (tree.outside, outer)):
        for part in parts:
            _require(own is not FORMULAS or isinstance(part, Node), f"{part!r:.80} is not a statement")
            _check(part, own, depth + 1)


_WORDS = {True: "statement", False: "term"}
