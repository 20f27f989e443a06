r"""Hypergeometric functions, such as {}_2F_1(a, b; c; z), by the coefficients of their power series.

A relation that is linear in functions of one argument whose parameters differ by whole numbers, and in their
derivatives, says of each coefficient that a rational function of its place vanishes. Other relations are about endless
sums. Where a numerator parameter is a whole number that is not positive, the series is a polynomial: there false
relations fail. What is left to trust is that functions with equal coefficients are equal, and that they depend
continuously on their parameters.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from math import factorial

from symcheck.core.calculus import Unknown, derivative, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, PI, Binder, Call, Malformed, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import Unsupported, number_of
from symcheck.question.logarithms import tokens_of
from symcheck.question.named import arguments
from symcheck.question.prepare import Asked
from symcheck.question.special import term_of
from symcheck.reading import from_sympy, to_sympy

HEAD = ("\\prescript", "{", "}", "{", "p", "}", "{", "F", "}", "_", "{", "q", "}")
LETTERS = "FGHKQMNXYZ"
USUAL = "M"  # the letter of Kummer's function
PHRASES = ("Kummer function", "Kummer's function", "confluent hypergeometric function of the first kind")
MOST = 6  # the largest difference of parameters, order of a derivative or power of the argument
CONTINUED = "positive parameters"  # of a condition that holds by continuation where it does not
PLACE, ARGUMENT = "place", "argument_of_series"
FAULTS = (SymcheckError, Malformed, Unknown, Unsupported, ArithmeticError, ValueError, TypeError)
NUMBERS = ((1, 1, 2), (1, 2, 2), (1, 2, 1))  # for parameters in the order of their letters: these have known sums
DEGREES = (1, 2)  # of polynomials that false relations are tried with


@dataclass(frozen=True)
class Series:
    """A question with letters for hypergeometric functions, and how many parameters above and below each has."""

    asked: Asked
    of: Mapping[str, tuple[int, int]]
    told: Mapping[str, str]


def said(letters_: Mapping[str, str]) -> set[str]:
    """The letters that are said to be Kummer's function."""
    plain = {x: phrase.strip().removeprefix("the ").removeprefix("a ") for x, phrase in letters_.items()}
    return {x for x, phrase in plain.items() if phrase in PHRASES}


def with_letters(asked: Asked, kummer: Iterable[str] = ()) -> Series | None:
    """The same with letters for hypergeometric functions; None where there are none, or one has other arguments.

    M of three arguments is taken for Kummer's function, beside the letters that are said to be it.
    """
    row, every = tokens_of(asked.relation), " ".join((asked.relation, *asked.where, *asked.given))
    elsewhere = {x for text in (*asked.where, *asked.given) for x in tokens_of(text)}
    own = ({USUAL} - elsewhere | {*kummer}) - {x for x, _ in asked.letters}
    row = [x for k, text in enumerate(row) for x in _with_head(row, k, text, own)]
    if HEAD[0] not in row or any(r"\prescript" in text for text in (*asked.where, *asked.given)):
        return None
    free = iter([x for x in LETTERS if x not in every.replace("{F}", "")])
    named: dict[tuple[int, int], str] = {}
    for k in reversed(range(len(row))):
        if row[k] != HEAD[0]:
            continue
        head = row[k : k + len(HEAD)]
        if len(head) < len(HEAD) or any(x != y for x, y in zip(head, HEAD, strict=True) if y not in ("p", "q")):
            return None
        call = arguments(row, k + len(HEAD))
        if call is None or not (head[4].isdigit() and head[11].isdigit()):
            return None
        (end, parts, signs), above, below = call, int(head[4]), int(head[11])
        signs = [";", ";"] if (above, below, signs) == (1, 1, [",", ","]) else signs
        if signs != [*[","] * (above - 1), ";", *[","] * (below - 1), ";"] or above > below + 1 or not above * below:
            return None
        if (above, below) not in named:
            if (letter := next(free, None)) is None:
                return None
            named[above, below] = letter
        inside = [x for part in parts for x in (*part, ",")][:-1]
        row[k:end] = [named[above, below], "(", *inside, ")"]
    told = {x: f"the hypergeometric function {{}}_{p}F_{q}" for (p, q), x in named.items()}
    return (
        Series(replace(asked, relation=" ".join(row)), {x: kind for kind, x in named.items()}, told) if named else None
    )


def _with_head(row: Sequence[str], k: int, text: str, kummer: set[str]) -> Sequence[str]:
    """A token, or in the place of a letter for Kummer's function of three arguments the head of that."""
    if text in kummer and (call := arguments(row, k + 1)) is not None and call[2] == [",", ","]:
        return [{"p": "1", "q": "1"}.get(x, x) for x in HEAD]
    return [text]


@dataclass(frozen=True)
class Member:
    """A hypergeometric function or a derivative of it: parameters above and below, argument, order."""

    above: tuple[Term, ...]
    below: tuple[Term, ...]
    at: Term
    order: int = 0

    def coefficient(self, k: int) -> Term:
        """That of the k-th power in the function itself."""
        top = [node("+", a, j) if j else a for a in self.above for j in range(k)]
        bottom = [node("+", b, j) if j else b for b in self.below for j in range(k)]
        return node("/", node("*", 1, *top), node("*", factorial(k), *bottom))


def members_in(tree: Term, of: Mapping[str, tuple[int, int]]) -> Iterator[tuple[Node, Member]]:
    """The functions and derivatives in a term, each with what it is."""
    if not isinstance(tree, Node):
        return
    match tree:
        case Call(function=name) if name in of:
            above, _ = of[name]
            if any(tree.orders[:-1]):
                raise SymcheckError("a derivative by a parameter")
            *parameters, at = tree.terms
            yield tree, Member(tuple(parameters[:above]), tuple(parameters[above:]), at, tree.orders[-1])
        case Binder(tag="diff", body=Call(function=name) as inner) if name in of:
            ((_, member),) = members_in(inner, of)
            order, place = tree.outside
            if place != tree.letter or member.at != tree.letter or not isinstance(order, int):
                raise SymcheckError("a derivative of a function of a function")
            yield tree, replace(member, order=member.order + order)
        case _:
            for part in (*tree.inside, *tree.outside):
                yield from members_in(part, of)


def by_coefficients(problem: Problem, of: Mapping[str, tuple[int, int]]) -> tuple[Problem, ...] | None:
    """What a linear relation says of the coefficients; None where it is none."""
    with suppress(*FAULTS):
        return tuple(_linear(problem, of))
    return None


def _linear(problem: Problem, of: Mapping[str, tuple[int, int]]) -> Iterator[Problem]:
    import sympy

    if problem.claim.tag != "=" or problem.definitions:
        raise SymcheckError("no equation")
    found = dict(members_in(problem.claim, of))
    members = [*dict.fromkeys(found.values())]
    places = {each.at for each in members}
    if len(places) != 1 or len({(len(each.above), len(each.below)) for each in members}) != 1:
        raise SymcheckError("functions of several arguments, or of several kinds")
    (at,) = places
    sign = 1
    match at:
        case str():
            x = at
        case Node(tag="-", outside=(str() as x,)) if not any(each.order for each in members):
            sign = -1
        case _:
            raise SymcheckError("a function of a function")
    if any(x in letters(parameter) for each in members for parameter in (*each.above, *each.below)):
        raise SymcheckError("the argument is a parameter")
    names = {each: f"{PLACE}_{k}" for k, each in enumerate(members)}
    left, right = (_with_names(side, found, names) for side in problem.claim.terms)
    symbols = [sympy.Symbol(name, real=True) for name in names.values()]
    argument = sympy.Symbol(x, real=True)
    above, _ = sympy.fraction(sympy.together(to_sympy(node("+", left, node("-", right)))))
    try:
        whole = sympy.Poly(sympy.expand(above.subs(argument, sign * argument)), *symbols, argument)
    except sympy.PolynomialError as error:
        raise SymcheckError("not linear with polynomials for coefficients") from error
    terms = list[tuple[Term, int, Member]]()  # coefficient, power of the argument, function
    for powers, c in whole.terms():
        if sum(powers[:-1]) != 1 or powers[-1] > MOST:
            raise SymcheckError("not linear")
        terms.append((from_sympy(c), powers[-1], members[powers.index(1)]))
    yield from _said_of_coefficients(problem, terms)


def _with_names(tree: T, found: Mapping[Node, Member], names: Mapping[Member, str]) -> T:
    if tree in found:
        return names[found[tree]]  # type: ignore[index, return-value]
    return mapped(tree, lambda part: _with_names(part, found, names)) if isinstance(tree, Node) else tree  # type: ignore[return-value]


def _said_of_coefficients(problem: Problem, terms: Sequence[tuple[Term, int, Member]]) -> Iterator[Problem]:
    """That the sum of multiples of powers times functions has no coefficient but zero."""
    reference = terms[0][2]
    terms = [
        (c, n, replace(each, above=_paired(each.above, reference.above), below=_paired(each.below, reference.below)))
        for c, n, each in terms
    ]
    members = [each for _, _, each in terms]
    above = [_extreme([each.above[i] for each in members], -1) for i in range(len(members[0].above))]
    below = [_extreme([each.below[i] for each in members], 1) for i in range(len(members[0].below))]
    ahead = [each.order - power for _, power, each in terms]
    first = min(ahead)
    k = _free(PLACE, problem)

    def falling(place: Term, order: int) -> list[Term]:
        return [node("+", place, -j) if j else place for j in range(order)]

    addends = list[Term]()  # in units of the coefficient at k of the function with the parameters above and below
    for (c, _, each), more in zip(terms, ahead, strict=True):
        place: Term = node("+", k, more - first) if more != first else k
        top, bottom = [c, *falling(place, each.order)], list[Term]()
        for base, own in zip(above, each.above, strict=True):
            for j in range(_difference(own, base)):
                top.append(node("+", base, place, j))
                bottom.append(node("+", base, j))
        for base, own in zip(below, each.below, strict=True):
            for j in range(1, _difference(base, own) + 1):
                top.append(node("+", base, place, -j))
                bottom.append(node("+", base, -j))
        for j in range(more - first):
            top += [node("+", base, k, j) for base in above]
            bottom += [node("+", k, j + 1), *(node("+", base, k, j) for base in below)]
        addends.append(node("/", node("*", *top), node("*", 1, *bottom)))
    hypotheses = (*problem.hypotheses, (PLACE, (node(">=", k, 0),)))
    yield replace(problem, claim=node("=", node("+", 0, *addends), 0), hypotheses=hypotheses)
    for n in range(-first):  # where the first of them is none: the others have to cancel
        parts = list[Term]()
        for (c, _, each), more in zip(terms, ahead, strict=True):
            if n + more >= 0:
                times = [c, *falling(n + more, each.order), each.coefficient(n + more)]
                parts.append(node("*", *times))
        yield replace(problem, claim=node("=", node("+", 0, *parts), 0))


def _paired(parameters: Sequence[Term], reference: Sequence[Term]) -> tuple[Term, ...]:
    """Parameters, whose order makes no difference, in that of others from which they differ by whole numbers."""
    left, found = [*parameters], list[Term]()
    for other in reference:
        for own in left:
            with suppress(SymcheckError):
                _difference(own, other)
                found.append(own)
                left.remove(own)
                break
    if left:
        raise SymcheckError("parameters that do not differ by whole numbers")
    return tuple(found)


def _extreme(terms: Sequence[Term], sign: int) -> Term:
    """The least or the greatest of terms that differ by whole numbers."""
    return max(terms, key=lambda t: sign * _difference(t, terms[0]))


def _difference(one: Term, other: Term) -> int:
    gap = number_of(node("+", one, node("-", other)))
    if gap is None or gap.denominator != 1 or abs(gap) > MOST:
        raise SymcheckError("parameters that do not differ by a small whole number")
    return int(gap)


def _free(stem: str, problem: Problem) -> str:
    taken = letters(problem.claim).union(*(letters(f) for _, fs in problem.hypotheses for f in fs))
    return next(x for x in (stem, *(f"{stem}_{k}" for k in range(1, len(taken) + 2))) if x not in taken)


# --- values at numbers


@dataclass(frozen=True)
class Value:
    """The value of {}_2F_1(a, b; c; z) at a number, where the arguments of gamma functions are positive.

    Parameters
    ----------
    at
        The number.
    below
        What c has to be.
    value
        The value.
    """

    at: Fraction
    below: str
    value: str


VALUES = (  # of Gauss, Kummer, and Gauss: DLMF 15.4.20, 15.4.26, 15.4.28
    Value(Fraction(1), "c", "gamma(c)*gamma(c - a - b)/(gamma(c - a)*gamma(c - b))"),
    Value(Fraction(-1), "a - b + 1", "gamma(a - b + 1)*gamma(a/2 + 1)/(gamma(a + 1)*gamma(a/2 - b + 1))"),
    Value(Fraction(1, 2), "(a + b + 1)/2", "sqrt(pi)*gamma((a + b + 1)/2)/(gamma((a + 1)/2)*gamma((b + 1)/2))"),
)


def with_values(problem: Problem, of: Mapping[str, tuple[int, int]]) -> tuple[Problem, tuple[Problem, ...]] | None:
    """The problem with known values, and the claims that gamma functions have positive arguments; None without one."""
    with suppress(*FAULTS):
        found = {part: each for part, each in members_in(problem.claim, of) if of[part.function] == (2, 1)}  # type: ignore[attr-defined]
        known = {part: value for part, each in found.items() if (value := _value(each)) is not None}
        if not known:
            return None

        def put(tree: T) -> T:
            if tree in known:
                return known[tree]  # type: ignore[return-value]
            return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

        gammas = dict.fromkeys(part.outside[0] for part in nodes(*known.values()) if part.tag == "gamma")
        conditions = tuple(replace(problem, claim=node(">", argument, 0)) for argument in gammas)
        return replace(problem, claim=put(problem.claim)), conditions
    return None


def _value(member: Member) -> Term | None:
    (a, b), (c,), at = member.above, member.below, number_of(member.at)
    for each, by in product(VALUES, ({"a": a, "b": b, "c": c}, {"a": b, "b": a, "c": c})):
        gap = node("+", c, node("-", substituted(term_of(each.below), by)))
        if member.order == 0 and at == each.at and number_of(gap) == 0:
            return substituted(term_of(each.value), by)
    return None


# --- sums


def as_sums(problem: Problem, of: Mapping[str, tuple[int, int]]) -> Problem | None:
    """The problem with endless sums for functions, or with polynomials where the sums end."""
    with suppress(*FAULTS):
        parameters = {
            x for _, each in members_in(problem.claim, of) for a in (*each.above, *each.below) for x in letters(a)
        }
        claim = _with_terms(problem.claim, of, _sum(_free(PLACE, problem)))
        positive = tuple(node(">", x, 0) for x in sorted(parameters)) if _is_analytic(problem.claim, parameters) else ()
        given = (*problem.hypotheses, (CONTINUED, positive)) if positive else problem.hypotheses
        return replace(problem, claim=claim, hypotheses=given)
    return None


def _is_analytic(tree: Term, of: set[str]) -> bool:
    """Whether a term depends analytically on letters, so that what holds where they are positive holds elsewhere."""
    if not isinstance(tree, Node) or not of & letters(tree):
        return True
    if tree.tag == "pow" and of & letters(tree.outside[0]):
        return False
    known = tree.tag in ("=", "+", "*", "-", "/", "^", "pow", "exp", "gamma", "call")
    return known and all(_is_analytic(part, of) for part in (*tree.inside, *tree.outside))


def _with_terms(tree: T, of: Mapping[str, tuple[int, int]], made: object) -> T:
    if isinstance(tree, Call) and tree.function in of:
        ((_, member),) = members_in(tree, of)
        assert callable(made)
        whole: Term = made(member)
        for _ in range(member.order):
            whole = derivative(whole, ARGUMENT)
        return substituted(whole, {ARGUMENT: member.at})  # type: ignore[return-value]
    return mapped(tree, lambda part: _with_terms(part, of, made)) if isinstance(tree, Node) else tree  # type: ignore[return-value]


def _sum(k: str) -> object:
    def made(member: Member) -> Term:
        if member.order:
            raise SymcheckError("a derivative of a sum")
        ends = [n for a in member.above if (n := number_of(a)) is not None and n <= 0 and n.denominator == 1]
        if ends:
            return _polynomial(member, -int(max(ends)))
        above, below = [*member.above], [*member.below, 1]
        top, bottom = list[Term](), list[Term]()
        for a in member.above:  # (b + n)_k / (b)_k is a product of n fractions
            for b in below:
                gap = number_of(node("+", a, node("-", b)))
                if gap is not None and gap.denominator == 1 and abs(gap) <= MOST:
                    above.remove(a)
                    below.remove(b)
                    for j in range(int(gap)):
                        top.append(node("+", b, j, k))
                        bottom.append(node("+", b, j))
                    for j in range(-int(gap)):
                        top.append(node("+", a, j))
                        bottom.append(node("+", a, j, k))
                    break
        for one, own, other in ((above, top, bottom), (below, bottom, top)):
            for a in one:
                own.append(node("gamma", node("+", a, k)))
                other.append(node("gamma", a) if number_of(a) != 1 else 1)
        body = node("*", node("/", node("*", 1, *top), node("*", 1, *bottom)), *_power(member.at, k))
        return node("sum", body, k, 0, INFINITY)

    return made


def _power(base: Term, k: str) -> Iterator[Term]:
    """The factors of a power, as print has them: (-x^2)^k as (-1)^k x^(2 k)."""
    match base:
        case Node(tag="-", outside=(inner,)):
            yield node("cos", node("*", k, PI))
            yield from _power(inner, k)
        case Node(tag="^", outside=(inner, int(n))):
            yield node("pow", inner, node("*", n, k))
        case _:
            yield node("pow", base, k)


def _polynomial(member: Member, degree: int) -> Term:
    """A function whose series ends there."""
    if degree > MOST:
        raise SymcheckError("a polynomial of a high degree")
    addends = (node("*", member.coefficient(k), node("^", ARGUMENT, k)) for k in range(1, degree + 1))
    return node("+", 1, *addends)


def at_numbers(problem: Problem, of: Mapping[str, tuple[int, int]]) -> Iterator[tuple[dict[str, int], Problem]]:
    """The problem at small numbers for all parameters, with endless sums for functions, and these numbers."""
    with suppress(*FAULTS):
        names = sorted(
            {x for _, each in members_in(problem.claim, of) for a in (*each.above, *each.below) for x in letters(a)}
        )
        for numbers in NUMBERS if names else ():
            at = dict(zip(names, numbers, strict=False))
            given = tuple((name, tuple(substituted(f, at) for f in fs)) for name, fs in problem.hypotheses)
            there = replace(problem, claim=substituted(problem.claim, at), hypotheses=given)
            if len(at) == len(names) and (sums := as_sums(there, of)) is not None:
                yield at, sums


# --- polynomials


def terminated(problem: Problem, of: Mapping[str, tuple[int, int]]) -> Iterator[tuple[dict[str, int], Problem]]:
    """The problem at numbers for a letter with which all functions are polynomials, and these numbers."""
    with suppress(*FAULTS):
        members = [each for _, each in members_in(problem.claim, of)]
        common = set.intersection(*({x for a in each.above for x in letters(a)} for each in members))
        for x in sorted(common):
            for degree in DEGREES:
                with suppress(*FAULTS):
                    yield {x: (n := _number(members, x, degree))}, _at(problem, of, members, {x: n})


def _number(members: Sequence[Member], x: str, degree: int) -> int:
    """The number for a letter with which all series end, that with the least degree there."""
    values = list[Fraction]()
    for each in members:
        shifts = [number_of(node("+", a, node("-", x))) for a in each.above]
        values += [max(n for n in shifts if n is not None)]
    if any(n.denominator != 1 for n in values):
        raise SymcheckError("no whole number")
    return -degree - int(max(values))


def _at(
    problem: Problem, of: Mapping[str, tuple[int, int]], members: Sequence[Member], at: Mapping[str, Term]
) -> Problem:
    def made(member: Member) -> Term:
        numbers = [number_of(a) for a in member.above]
        ends = [int(-n) for n in numbers if n is not None and n <= 0 and n.denominator == 1]
        if not ends:
            raise SymcheckError("a series without an end")
        return _polynomial(member, min(ends))

    below = [substituted(b, at) for each in members for b in each.below]
    defined = tuple(node(">", b, 0) for b in dict.fromkeys(below) if letters(b))
    if any((n := number_of(b)) is not None and n <= 0 for b in below):
        raise SymcheckError("a parameter below that is not positive")
    given = tuple((name, tuple(substituted(f, at) for f in fs)) for name, fs in problem.hypotheses)
    claim = _with_terms(substituted(problem.claim, at), of, made)
    return replace(problem, claim=claim, hypotheses=(*given, ("parameters", defined)) if defined else given)
