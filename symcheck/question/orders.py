r"""Derivatives whose order is a letter, as in \frac{d^n}{dx^n} e^{ax} = a^n e^{ax}, by induction over the order.

A claim D^n f = g(n) for all n from some number N on follows from D^N f = g(N) and D g(n) = g(n + 1), if f does not
depend on n. If it does, it follows from D^N f(N) = g(N), D f(n + 1) = c f(n) and g(n + 1) = c g(n), where c does not
depend on the letter of the derivative. All of them are asked for; what is left to trust is the induction.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from math import factorial

from symcheck.checker.algebra import Algebra
from symcheck.core.calculus import Unknown, domain, functions, letters, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import number_of
from symcheck.question.prepare import DEFINED, Asked, Reading, readings, sides
from symcheck.question.series import FAULTS
from symcheck.question.whole import with_half_turns
from symcheck.question.whole_powers import inlined, with_claim, with_whole_powers
from symcheck.reading import from_sympy, tex, to_sympy

# the beginning of a derivative, and its order
HEAD = re.compile(r"\\[dt]?frac\{(?P<d>d|\\partial)\^\{?(?P<order>[^{}]+)\}?")
# a letter, so many times it, or so many more
ORDER = re.compile(r"(?P<times>[1-9]?)(?P<letter>[a-zA-Z])(?:\+(?P<more>\d))?")
PRIMED = re.compile(r"(?P<f>[a-zA-Z])\^\{\((?P<order>[^(){}]+)\)\}\((?P<x>[a-zA-Z])\)")  # f^{(n)}(x)
FRESH = "kmpqrshlj"  # letters that may stand for n + 1
TRIED = 3  # orders at which a claim is looked at, and the next ones
# what bounds a letter below; and what bounds it above, so that it holds of smaller ones too
_MEMBER = re.compile(r"\\in\\mathbb\{?(?P<set>[NZ])\}?(?P<part>_.*)?")
# a bound below
_BELOW = re.compile(r"(?:>|\\geq?(?:slant)?)(?P<number>\d)")


@dataclass(frozen=True)
class Ordered:
    """A claim that the derivative of some order is what is said.

    Parameters
    ----------
    asked
        What is asked.
    order
        The order, as many times the letter and so many more.
    letter
        Its letter.
    x
        By what is differentiated.
    sign
        "d", or the sign of partial derivatives.
    body, value
        Of what, and what it is said to be.
    first
        The least order of which it is said.
    whether
        Whether somebody says so, or it is the first one that there may be.
    """

    asked: Asked
    times: int
    more: int
    letter: str
    x: str
    sign: str
    body: str
    value: str
    first: int
    said: bool

    @property
    def depends(self) -> bool:
        """Whether what is differentiated depends on the order."""
        return self.letter in tex.texts(self.body)

    def ahead(self, text: str) -> str:
        """A text with the next number in the place of the letter."""
        return _put(self.letter, self._next)(text)

    def about(self, before: str, after: str, *, ahead: bool = False) -> Asked:
        """That one thing is another, where the next number may stand in them."""
        given = [*self.asked.given, rf"{self.letter}\ge {self.first}"]
        whole, where = [self.letter], list(self.asked.where)
        if ahead:
            given += (self.ahead(text) for text in self.asked.given if not _is_about(text, self.letter))
            whole.append(self._next)
            where.append(f"{self._next}={self.letter}+1")
        said = {x for x in whole if any(_MEMBER.search(text) and _is_about(text, x) for text in given)}
        letters_ = (
            *self.asked.letters,
            *((x, "integer") for x in whole if x not in said | {*dict(self.asked.letters)}),
        )
        return Asked(f"{before}={after}", (*where,), (*dict.fromkeys(given),), letters_)

    def slope(self, text: str, order: int) -> str:
        """A derivative by the letter of this one."""
        power = "" if order == 1 else f"^{{{order}}}"
        head = rf"\frac{{{self.sign}{power}}}{{{self.sign}{_apart(self.sign, self.x)}{power}}}"
        return rf"{head}\left({text}\right)"

    @property
    def _next(self) -> str:
        asked = self.asked
        texts = (asked.relation, *asked.where, *asked.given, *(x for x, _ in asked.letters))
        taken = {token for text in texts for token in tex.texts(text)}
        return next(x for x in FRESH if x not in taken)


def _apart(sign: str, x: str) -> str:
    return f" {x}" if sign != "d" and x.isalpha() else x


def _is_about(text: str, letter: str) -> bool:
    """Does a condition say what a letter alone is?"""
    return re.match(rf"{letter}(?:\\|[<>=])", text) is not None


def _put(letter: str, by: str) -> Callable[[str], str]:
    """What puts a number or another letter in the place of a letter in a text."""

    def put(text: str) -> str:
        made = ""
        for token in tex.texts(text):
            new = by if token == letter else token
            apart = made[-1:].isalnum() and new[:1].isalnum() and (made[-1:].isdigit() and new[:1].isdigit())
            command = re.search(r"\\[A-Za-z]+$", made) and new[:1].isalpha()
            made += (r"\cdot " if apart and token == letter else " " if command else "") + new
        return made

    return put


def ordered(asked: Asked) -> Ordered | None:
    """What is asked about a derivative whose order is a letter; None if it is something else."""
    if HEAD.search(asked.relation) is None and PRIMED.search(asked.relation) is None:
        return None
    if (both := sides(asked.relation)) is None:
        return None
    asked = replace(asked, given=tuple(map(tex.compact, asked.given)))
    for left, right in (both, both[::-1]):
        if (found := _derivative(left) or _primed(left, asked)) is not None:
            sign, order, x, body, where = found
            match = ORDER.fullmatch(order)
            if match is None or match["letter"] == x or not body or _has_order(right) or _has_order(body):
                return None
            n = match["letter"]
            first = _first(asked.given, n)
            plain = all(_is_about(text, n) or _is_open(text, n, x) for text in asked.given)
            if first is None or not plain or any(x in tex.texts(text) for text in where):
                return None
            times, more = int(match["times"] or 1), int(match["more"] or 0)
            said = any(_is_about(text, n) for text in asked.given)
            return Ordered(replace(asked, where=where), times, more, n, x, sign, body, right, first, said)
    return None


def _has_order(text: str) -> bool:
    return any(ORDER.fullmatch(match["order"]) for match in HEAD.finditer(text)) or PRIMED.search(text) is not None


def _first(given: Sequence[str], letter: str) -> int | None:
    """The least number that a letter may be; None if it may be negative, or is bounded by something else."""
    first = 0
    for text in given:
        if not _is_about(text, letter):
            continue
        rest = text[len(letter) :]
        if (member := _MEMBER.fullmatch(rest)) and (member["set"] == "N" or member["part"]):
            positive = re.fullmatch(r"_\{?(?:>0|\+|\\geq?1)\}?", member["part"] or "")
            first = max(first, int(positive is not None))
        elif below := _BELOW.fullmatch(rest):
            first = max(first, int(below["number"]) + (rest[0] == ">"))
        elif not _MEMBER.fullmatch(rest):
            return None
    return first


def _is_open(text: str, n: str, x: str) -> bool:
    """Does a condition leave room around each x, and hold of smaller n?"""
    tokens = tex.texts(text)
    if n in tokens:
        parts = re.split(r"\\geq?(?![a-zA-Z])|>", text)
        return x not in tokens and len(parts) == 2 and parts[1].strip() == n and n not in tex.texts(parts[0])
    return x not in tokens or not re.search(r"=|\\in(?![a-zA-Z])", text)


def _derivative(text: str) -> tuple[str, str, str, str, tuple[str, ...]] | None:
    """Sign, order, letter and body of a derivative that is all of a text."""
    if (match := HEAD.match(text)) is None:
        return None
    end = _end(text, text.index("{"))
    if end is None or text[end : end + 1] != "{" or (last := _end(text, end)) is None:
        return None
    inside, below, rest = text[match.end() : end - 1], text[end + 1 : last - 1], text[last:]
    order = match["order"].strip()
    by = re.fullmatch(re.escape(match["d"]) + r"\s*(\\?[a-zA-Z]+)\^\{?([^{}]+)\}?", below)
    if by is None or by[2].strip() != order or bool(inside) == bool(rest) or _is_sum(rest):
        return None
    return match["d"], order, by[1], inside or rest, ()


def _primed(text: str, asked: Asked) -> tuple[str, str, str, str, tuple[str, ...]] | None:
    """The same of f^{(n)}(x), where it is said what f(x) is."""
    if (match := PRIMED.fullmatch(text)) is None:
        return None
    for said in asked.where:
        left, right = sides(said) or ("", "")
        if re.sub(r"\\left|\\right|\s", "", left) == f"{match['f']}({match['x']})":
            others = tuple(each for each in asked.where if each != said)
            return "d", match["order"], match["x"], right, others
    return None


def _end(text: str, start: int) -> int | None:
    """The place behind the brace that closes the one at a place."""
    depth = 0
    for k in range(start, len(text)):
        depth += (text[k] == "{") - (text[k] == "}")
        if depth == 0:
            return k + 1
    return None


def _is_sum(text: str) -> bool:
    """Does a sign of a sum stand outside of brackets?"""
    depth = 0
    for k, token in enumerate(tex.texts(text)):
        depth += (token in ("{", "(", "[", r"\{")) - (token in ("}", ")", "]", r"\}"))
        if depth == 0 and token in "+-" and k:
            return True
    return False


# --- the cases


def at_number(found: Ordered, number: int) -> tuple[Reading, Problem] | None:
    """The claim at a number, with its reading; None where it is not understood, or has no value there."""
    with suppress(SymcheckError, *FAULTS, Unknown):
        order = number * found.times + found.more
        reading, problem = _understood(replace(found, first=0), found.slope(found.body, order or 1), found.value)
        if not order:
            problem = _of_order_zero(problem)

        def put(tree: T) -> T:
            if not isinstance(tree, Node):
                return number if tree == found.letter else tree  # type: ignore[return-value]
            new = mapped(tree, put)
            if new.tag == "pow" and (power := number_of(new.outside[1])) is not None and power.denominator == 1:
                raised = node("^", new.outside[0], abs(int(power)))
                return 1 if power == 0 else raised if power > 0 else node("/", 1, raised)  # type: ignore[return-value]
            return _with_factorial(new)  # type: ignore[return-value]

        claim = put(inlined(problem).claim)
        given = tuple((name, tuple(map(put, fs))) for name, fs in problem.hypotheses if name != DEFINED)
        if functions(claim):
            return None
        there, valued = replace(problem, claim=claim, definitions=(), hypotheses=given), domain(claim, divisors=True)
        if all(letters(f) or Algebra({}, {}).holds(f) for f in (*valued, *(f for _, fs in given for f in fs))):
            return reading, with_claim(there, claim, (f for f in valued if letters(f)))
    return None


def _of_order_zero(problem: Problem) -> Problem:
    """The problem with what is differentiated in the place of its derivative."""
    left, right = problem.claim.terms
    if not isinstance(left, Binder) or left.tag != "diff":
        raise SymcheckError("no derivative")
    body = substituted(left.body, {left.letter: left.outside[-1]})
    return replace(problem, claim=node("=", body, right))


# --- the step


def steps(found: Ordered) -> list[tuple[Reading, Problem]]:
    """What has to hold for the next order, with the readings of it; nothing if it is not understood."""
    with suppress(SymcheckError, *FAULTS, Unknown):
        value = found.ahead(found.value)
        if not found.depends:
            return [_step(found, *_understood(found, found.slope(found.value, found.times), value, ahead=True))]
        if found.times != 1:
            return []
        slope = _understood(found, found.slope(found.ahead(found.body), 1), found.body, ahead=True)
        by_values = _understood(found, value, found.value, ahead=True)
        ratio = _ratio(with_whole_powers(slope[1], {found.letter}), found.x)
        return [_step(found, reading, _times(problem, ratio)) for reading, problem in (slope, by_values)]
    return []


def _with_factorial(tree: Node) -> Term:
    """A factorial of a number worked out."""
    if tree.tag == "gamma" and (n := number_of(tree.outside[0])) is not None and n.denominator == 1 and n > 0:
        return factorial(int(n) - 1)
    return tree


def _step(found: Ordered, reading: Reading, problem: Problem) -> tuple[Reading, Problem]:
    plain = with_whole_powers(problem, {found.letter})
    return reading, with_half_turns(plain, {found.letter}) or plain


def _understood(found: Ordered, before: str, after: str, *, ahead: bool = False) -> tuple[Reading, Problem]:
    """The reading of a claim, and its problem."""
    (reading, *others) = readings(found.about(before, after, ahead=ahead))
    (problem, *more) = reading.problems
    if others or more:
        raise SymcheckError("several readings")
    return reading, problem


def _ratio(problem: Problem, x: str) -> Term:
    """How many times the right side is the left one, where that does not depend on x."""
    import sympy

    left, right = map(to_sympy, problem.claim.terms)
    ratio = sympy.simplify(sympy.powsimp(sympy.simplify(left / right), force=True))
    if ratio.has(sympy.Symbol(x, real=True)):
        raise SymcheckError("the ratio depends on the letter of the derivative")
    return from_sympy(ratio)


def _times(problem: Problem, ratio: Term) -> Problem:
    left, right = problem.claim.terms
    return replace(problem, claim=node("=", left, node("*", ratio, right)))
