r"""Expectations, variances and covariances by moments: that of (aX + b)^2 is a^2 E(X^2) + 2ab E(X) + b^2.

What holds of any numbers in the places of the moments for which Schwarz's inequality holds is so of all random
variables that have these moments. What is false is so of variables with a few values that are
equally likely. What is left to trust is that expectations are linear.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import product

from symcheck.core.verdicts import NoForm, SymcheckError
from symcheck.question.events import is_made_of
from symcheck.question.monomials import ONE, Monomial, Named, expanded, total
from symcheck.question.prepare import Asked, unlowered
from symcheck.reading import Tree, read, tex, to_latex
from symcheck.reading.tree import (
    Add,
    Call,
    Div,
    Indexed,
    Mul,
    Name,
    Neg,
    Number,
    Pow,
    children,
    nodes,
    with_children,
)

MEANS = frozenset({"E", r"\mathbb{E}", r"\text{E}"})
VARIANCES = frozenset({"Var", "var", r"\mathbb{V}"})
COVARIANCES = frozenset({"Cov", "cov"})
LETTERS = ("m", "k", "w", "u", "v")
MOST = 3  # random variables: independent ones have 2^n pairs of values
# what may be expected before a bracket, or vary
_SIGN = re.compile(
    r"(?<![A-Za-z])E\s*\}?\s*(?:\\[bB]igg?l?|\\left)?\s*[\[(]|(?<![A-Za-z])[VvCc](?:ar|ov)(?![A-Za-z])|\\mathbb\s*\{?V"
)
# a capital, as random variables mostly are
_RANDOM = re.compile(r"[A-Z](?:_(?:\w|\{\w+\}))?")
Moments = Callable[[Monomial], Tree]


@dataclass(frozen=True)
class Found:
    """A question about moments.

    Parameters
    ----------
    asked
        The question with letters for moments.
    meant
        What each letter is: "E(X^2)".
    of_values
        The same of variables with three values that are equally likely.
    special
        The same of those that authors may mean without saying so, with what is to be said then.
    law
        Whether all sides are made of expectations and of what stands in them, or something is given.
    random
        The random variables.
    """

    asked: Asked
    meant: Mapping[str, str]
    of_values: Asked
    special: tuple[tuple[str, Asked], ...]
    law: bool
    random: tuple[str, ...]


def in_moments(asked: Asked) -> Found | None:
    """The question about expectations as one about moments; None if there are none."""
    if not any(map(_SIGN.search, (asked.relation, *asked.where))):
        return None
    with suppress(SymcheckError, StopIteration):
        reading = unlowered(asked)[0]
        trees = [reading.tree, *(read(text, reading.inference.notation) for text in (*asked.where, *asked.given))]
        own, *others = ([(_head(part), u) for part in nodes(tree) for u in _arguments(part)] for tree in trees)
        inside = [*own, *(each for several in others for each in several)]
        if not inside or not any(_is_certain(part) for tree in trees for part in nodes(tree)):
            return None
        within = {x.letter for _, u in inside for x in nodes(u) if isinstance(x, Name)} - MEANS
        certain = any(head != "E" for head, _ in inside)  # E[n + 1] may be of a sequence
        random = sorted(x for x in within if _RANDOM.fullmatch(x) and (certain or x[0] in "UVWXYZ"))
        random = random or (sorted(within) if certain and len(within) == 1 else [])
        if not 0 < len(random) <= MOST:
            return None
        taken = {token for text in (asked.relation, *asked.where, *asked.given) for token in tex.texts(text)}
        named = Named(next(x for x in LETTERS if x not in taken))

        def question(moment: Moments) -> Asked:
            relation, *rest = (to_latex(_put(tree, {*random}, moment)) for tree in trees)
            kept = tuple((x, phrase) for x, phrase in asked.letters if x not in random)
            return Asked(relation, tuple(rest[: len(asked.where)]), tuple(rest[len(asked.where) :]), kept)

        about = question(named)
        values = {x: [Name(f"{x}_{k}") for k in (1, 2, 3)] for x in random}
        special = list[tuple[str, Asked]]()
        if len(random) > 1 and not any(head in COVARIANCES for head, _ in inside):
            pairs = [dict(zip(random, each, strict=True)) for each in product(*(values[x][:2] for x in random))]
            special.append(("the variables are independent", question(_over(pairs))))
        if not any(head in MEANS and isinstance(u, Name) and u.letter in random for head, u in inside):
            signs = [{x: each(values[x][0]) for x in random} for each in (lambda x: x, Neg)]
            special.append(("means are 0", question(_over(signs))))
        return Found(
            replace(about, given=(*about.given, *_conditions(named))),
            {name: f"E({product})" for name, product in named.shown().items()},
            question(_over([{x: values[x][k] for x in random} for k in range(3)])),
            tuple(special),
            _is_law(reading.tree) or any(others),
            tuple(random),
        )
    return None


def _head(tree: Tree) -> str:
    head = tree.function if isinstance(tree, Call) else tree.name if isinstance(tree, Indexed) else ""
    return head.letter if isinstance(head, Name) else head if isinstance(head, str) else ""


def _arguments(tree: Tree) -> tuple[Tree, ...]:
    """What stands in the brackets of an expectation, a variance or a covariance; nothing of anything else."""
    head = _head(tree)
    inside = tree.arguments if isinstance(tree, Call) else tree.places if isinstance(tree, Indexed) else ()
    wanted = 1 if head in MEANS | VARIANCES else 2 if head in COVARIANCES else 0
    return inside if wanted and len(inside) == wanted else ()


def _is_certain(tree: Tree) -> bool:
    """Is it an expectation or a variance, and not a function E of a number?"""
    return bool(_arguments(tree)) and not (isinstance(tree, Call) and _head(tree) == "E")


def _is_law(tree: Tree) -> bool:
    """Are all sides made of expectations and of the letters in them?"""
    inside = {x.letter for part in nodes(tree) for u in _arguments(part) for x in nodes(u) if isinstance(x, Name)}

    def is_own(part: Tree) -> bool:
        return bool(_arguments(part))

    def is_number(part: Tree) -> bool:
        return isinstance(part, Number) or all(x.letter in inside for x in nodes(part) if isinstance(x, Name))

    return is_made_of(tree, is_own, is_number)


def _conditions(named: Named) -> Iterator[str]:
    """That mean squares are not negative, nor those of the differences from means, and Schwarz's inequality."""
    names = named.names
    for factors, square in named.even():
        mean = names.get(factors[:1]) if len(factors) == 2 else None
        yield rf"{square} \ge {mean}^2" if mean else rf"{square} \ge 0"
    for (x, y), of_both in ((each, name) for each, name in names.items() if len(each) == 2 and each[0] != each[1]):
        if (x, x) in names and (y, y) in names:
            yield rf"{of_both}^2 \le {names[x, x]} {names[y, y]}"
            if (x,) in names and (y,) in names:
                a, b = names[x,], names[y,]
                yield rf"({of_both} - {a} {b})^2 \le ({names[x, x]} - {a}^2)({names[y, y]} - {b}^2)"


def _over(outcomes: Sequence[Mapping[str, Tree]]) -> Moments:
    """Moments of variables with these values, which are equally likely."""

    def moment(monomial: Monomial) -> Tree:
        products = (Mul(tuple(values[x] for x in monomial)) for values in outcomes)
        return Div(Add(tuple(products)), Number(str(len(outcomes))))

    return moment


def _put(tree: Tree, random: set[str], moment: Moments) -> Tree:
    """The same with sums of multiples of moments for expectations, variances and covariances."""

    def put(part: Tree) -> Tree:
        return _put(part, random, moment)

    def own(part: Tree) -> str:
        if not isinstance(part, Name) or part.letter not in random or part.dots or part.primes or part.subscripts:
            return ""
        return part.letter

    def with_numbers(part: Tree) -> Tree:
        return put(part) if _arguments(part) else with_children(part, tuple(map(with_numbers, children(part))))

    def expected(argument: Tree) -> Tree:
        return total(expanded(with_numbers(argument), own, put), lambda monomial: moment(monomial) if monomial else ONE)

    match _head(tree) if _arguments(tree) else "", _arguments(tree):
        case head, (u,) if head in MEANS:
            return expected(u)
        case head, (u,) if head in VARIANCES:
            return Add((expected(Pow(u, Number("2"))), Neg(Pow(expected(u), Number("2")))))
        case _, (u, v):
            return Add((expected(Mul((u, v))), Neg(Mul((expected(u), expected(v))))))
    if isinstance(tree, Name) and tree.letter in random:
        raise NoForm(f"{tree.letter} varies, and is no number")
    return with_children(tree, tuple(map(put, children(tree))))
