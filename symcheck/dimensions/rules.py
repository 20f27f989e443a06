"""What a formula requires of the dimensions of its letters: linear equations, by one rule for each kind of node.

This is the part to be trusted: who looks for a verdict solves these equations, and who checks it inserts numbers into
them. A dimension is a form: rational coefficients of atoms, which are base quantities `[kg]` and unknown letters. So
the form of m v^2 is m + 2 v, and E = m v^2 requires that E - m - 2 v is 0. What is not understood is an atom of its
own, of which nothing is known.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import StrEnum
from fractions import Fraction
from types import MappingProxyType
from typing import Any, NamedTuple, TypeVar

from symcheck.core.terms import (
    FUNCTIONS,
    RELATIONS,
    Binder,
    Call,
    Connective,
    End,
    Form,
    Formula,
    Node,
    Quantified,
    Term,
    Value,
)
from symcheck.core.words import term as words
from symcheck.dimensions.units import Dimension

K = TypeVar("K")
Rational = int | Fraction  # whole numbers are much faster, and nearly all that occur
Monomial = tuple[str, ...]  # letters in exponents
Atom = str | tuple[Monomial, str]  # of x^n the form is n x, whose atom is (("n",), "x")
Linear = Mapping[Atom, Rational]
Known = dict[str, Linear | None]  # forms by letter; None for one that may measure anything wherever it stands
EMPTY: Linear = MappingProxyType({})
TINY = 1e-12  # below is a sum of decimals that is 0
MOST_TERMS, MOST_BITS = 20, 2048  # monomials of an exponent; digits of a number whose value is kept
_AT: dict[str, Callable[[Any], float]] = {
    "sqrt": math.sqrt, "exp": math.exp, "log": math.log, "gamma": math.gamma, "sin": math.sin, "cos": math.cos,
    "tan": math.tan, "arctan": math.atan, "arcsin": math.asin, "arccos": math.acos,
}  # fmt: skip


class Kind(StrEnum):
    """How binding an equation is."""

    RULE = "rule"
    ARGUMENT = "argument"  # the same function at several places: mostly so, but the delta function is not
    DEFAULT = "default"  # a bound letter measures what the letter of its name does


class Equation(NamedTuple):
    """Two terms that measure the same; the form is that of the first less that of the second.

    The second term is None where the first must be a number.
    """

    form: Linear
    first: Term
    second: Term | None
    forms: tuple[Linear, Linear]
    group: int  # the sum or relation from which it comes
    kind: Kind = Kind.RULE


class Measured(NamedTuple):
    """What is known of a term: None for what may have any dimension, as 0 has; a value if it has no letters.

    `logs` is the form of that whose logarithm it is, which is a - b for log a - log b.
    """

    form: Linear | None
    logs: Linear = EMPTY
    value: Rational | float | None = None


NOTHING = Measured(None, EMPTY, 0)


def base(quantity: str) -> str:
    """The atom of a base quantity."""
    return f"[{quantity}]"


def is_base(atom: Atom) -> bool:
    """Is it a base quantity, and not multiplied by a letter?"""
    return isinstance(atom, str) and atom[0] == "["


def form_of(dimension: Dimension) -> Linear:
    """The form of a known dimension."""
    return {base(quantity): n.numerator if n.denominator == 1 else n for quantity, n in dimension.items()}


def added(one: Mapping[K, Rational], other: Mapping[K, Rational], factor: Rational = 1) -> Mapping[K, Rational]:
    """The first form, or combination of equations, and a multiple of the second."""
    if not other or not factor:
        return one
    if not one and factor == 1:
        return other
    total = dict(one)
    for atom, n in other.items():
        if new := total.get(atom, 0) + factor * n:
            total[atom] = new
        else:
            del total[atom]
    return total


def scaled(form: Mapping[K, Rational], factor: Rational) -> Mapping[K, Rational]:
    """A multiple of a form, or of a combination of equations."""
    return {atom: factor * n for atom, n in form.items()} if factor else {}


def ratio(top: Rational, bottom: Rational) -> Rational:
    """A quotient, a whole number if it is one."""
    found = Fraction(top) / bottom
    return found.numerator if found.denominator == 1 else found


class Scale(NamedTuple):
    """A quantity that is set to 1, and what it measures."""

    letter: str
    form: Linear


class Rules:
    """The equations of formulas. `known` are the forms of letters and of the values of functions, by name."""

    def __init__(self, known: Mapping[str, Linear | None]) -> None:
        self.known, self.equations = known, list[Equation]()
        self.opaque: dict[str, str] = {}  # atoms that stand for what is not understood, in words
        self.sides: list[tuple[int, Linear | None, Linear | None]] = []  # of each relation, with its group
        self.members: dict[int, list[tuple[Term, Linear]]] = {}  # of each sum or relation, by its group
        self.used: Known = {}  # the known letters that occur
        self.groups = self.fresh = 0

    def letter(self, name: str) -> Linear | None:
        """The form of a free letter, or of the value of a function."""
        if name not in self.known:
            return {name: 1}
        form = self.used[name] = self.known[name]
        return form

    # -- formulas ------------------------------------------------------------------------------------------------

    def state(self, formula: Formula, bound: Mapping[str, Linear] = EMPTY) -> None:  # type: ignore[assignment]
        """Note what a formula requires."""
        if isinstance(formula, Connective):
            for part in formula.formulas:
                self.state(part, bound)
        elif isinstance(formula, Quantified):
            own = {x: self._bound(x) for x in formula.bound}
            self.state(formula.body, {**bound, **own})
        elif formula.tag in RELATIONS:
            self._same(formula.terms, bound)
        else:
            self.require(self.unknown(formula), formula, None)

    def _same(self, sides: tuple[Term, ...], bound: Mapping[str, Linear]) -> None:
        """Addends of all sides measure the same, and so do that of which they are logarithms."""
        self.groups += 1
        group = self.groups
        left, right = (self._addends(side, bound) for side in sides)
        self._alike([*left, *right], group)
        if any(each.logs for *_, each in (*left, *right)):
            self.require(added(self._logs(left, bound), self._logs(right, bound), -1), sides[0], None, group)
        self.sides.append((group, _form(left), _form(right)))

    def _sum(self, of: Node, bound: Mapping[str, Linear]) -> Measured:
        self.groups += 1
        group = self.groups
        found = self._addends(of, bound)
        self._alike(found, group)
        logs = self._logs(found, bound) if any(each.logs for *_, each in found) else EMPTY
        values = [sign * each.value for sign, _, each in found if each.value is not None]
        value = sum(values) if len(values) == len(found) else None
        return Measured(_form(found), logs, _short(value))

    def _addends(self, side: Term, bound: Mapping[str, Linear]) -> list[tuple[int, Term, Measured]]:
        """The addends with their signs; numbers of which nothing is left measure anything, as 0 does."""
        found = [(sign, each, self.measured(each, bound)) for sign, each in addends(side)]
        values = [sign * each.value for sign, _, each in found if each.value is not None]
        if values and abs(sum(values)) <= TINY * sum(map(abs, values)):
            return [(sign, each, of if of.value is None else NOTHING) for sign, each, of in found]
        return found

    def _alike(self, found: Sequence[tuple[int, Term, Measured]], group: int) -> None:
        """Note that addends measure the same, but for those that are 0."""
        members = [(each, measured.form) for _, each, measured in found if measured.form is not None]
        for each, form in members[1:]:
            first, other = members[0]
            if form != other:
                self.require(added(form, other, -1), each, first, group, forms=(form, other))
        self.members[group] = members

    def _logs(self, found: Sequence[tuple[int, Term, Measured]], bound: Mapping[str, Linear]) -> Linear:
        """That whose logarithm a sum is; a letter beside logarithms, of which nothing is said, may be one, too."""
        logs: Linear = EMPTY
        for sign, each, measured in found:
            logs = added(logs, measured.logs, sign)
            if isinstance(each, str) and each not in self.known and each not in bound:
                logs = added(logs, {f"log {each}": 1}, sign)
        return logs

    def require(
        self,
        form: Linear,
        first: Term,
        second: Term | None,
        group: int = 0,
        kind: Kind = Kind.RULE,
        forms: tuple[Linear, Linear] | None = None,
    ) -> None:
        """Note that a form vanishes."""
        if form:
            self.equations.append(Equation(form, first, second, forms or (form, EMPTY), group, kind))

    def number(self, measured: Measured, of: Term) -> None:
        """Note that a term is a number, and no logarithm of anything else."""
        if measured.form:
            self.groups += 1
            self.require(measured.form, of, None, self.groups)
        self.plain(measured, of)

    def plain(self, measured: Measured, of: Term) -> None:
        """Note that a term is no logarithm of what is not a number."""
        if measured.logs:
            self.groups += 1
            self.require(measured.logs, of, None, self.groups)

    # -- terms ---------------------------------------------------------------------------------------------------

    def measured(self, of: Term, bound: Mapping[str, Linear]) -> Measured:
        """What a term measures."""
        if isinstance(of, str):
            return Measured(bound[of] if of in bound else self.letter(of))
        if isinstance(of, int):
            return Measured(EMPTY, EMPTY, of) if of else NOTHING
        if isinstance(of, End):
            return Measured(None)
        found = self._node(of, bound)
        return NOTHING if found.value == 0 and not isinstance(found.value, float) else found

    def _node(self, of: Node, bound: Mapping[str, Linear]) -> Measured:
        match of.tag:
            case "+" | "-":
                return self._sum(of, bound)
            case "*":
                return self._product(of, bound)
            case "/":
                return self._quotient(of, bound)
            case "^":
                return self._power(of, bound)
            case "pow":
                return self._general_power(of, bound)
            case "pi":
                return Measured(EMPTY, EMPTY, math.pi)
            case "call" if isinstance(of, Call):
                return self._call(of, bound)
            case _ if of.tag in FUNCTIONS:
                return self._function(of, bound)
            case _ if isinstance(of, Binder):
                return self._binder(of, bound)
        return Measured(self.unknown(of))

    def unknown(self, of: Node) -> Linear:
        """The atom of what is not understood; the same for the same."""
        text = words(of) if not isinstance(of, Form) else str(of[1])
        self.opaque[f"?{text}"] = text
        return {f"?{text}": 1}

    def _bound(self, letter: str) -> Linear:
        """The form of a bound letter; mostly it measures what the letter measures elsewhere."""
        self.fresh += 1
        form: Linear = {f"{letter}@{self.fresh}": 1}
        if letter in self.known and (usual := self.letter(letter)) is not None:
            self.require(added(form, usual, -1), letter, letter, kind=Kind.DEFAULT)
        return form

    def _product(self, of: Node, bound: Mapping[str, Linear]) -> Measured:
        form: Linear = EMPTY
        value: Rational | float | None = 1
        factor: Rational | float = 1
        numbers, nothing, logs = 0, False, list[tuple[Term, Measured]]()
        for term in of.outside:
            each = self.measured(term, bound)
            if each.form is None:
                nothing = True
                continue
            if each.form:
                form = added(form, each.form)
            if each.logs:
                logs.append((term, each))
            if each.value is None:
                value = None
            else:
                numbers += 1
                factor = factor * each.value
                value = None if value is None else _short(value * each.value)
        if nothing:
            return Measured(None)
        if len(logs) == 1 and numbers == len(of.outside) - 1 and not isinstance(factor, float):
            return Measured(form, scaled(logs[0][1].logs, factor), value)
        for term, each in logs:
            self.plain(each, term)
        return Measured(form, EMPTY, value)

    def _quotient(self, of: Node, bound: Mapping[str, Linear]) -> Measured:
        top, bottom = (self.measured(each, bound) for each in of.outside)
        self.plain(bottom, of.outside[1])
        logs = EMPTY
        if isinstance(bottom.value, Rational) and bottom.value:
            logs = scaled(top.logs, Fraction(1) / bottom.value)
        else:
            self.plain(top, of.outside[0])
        if top.form is None or bottom.form is None:
            return Measured(None)
        value = _divided(top.value, bottom.value) if top.value is not None and bottom.value else None
        return Measured(added(top.form, bottom.form, -1), logs, value)

    def _power(self, of: Node, bound: Mapping[str, Linear]) -> Measured:
        under, n = self.measured(of.outside[0], bound), of.outside[1]
        assert isinstance(n, int)
        if n == 1:
            return under
        self.plain(under, of.outside[0])
        value = _value(lambda x: _power(x, n), under.value) if under.value and abs(n) < 100 else None
        return Measured(scaled(under.form, n) if under.form is not None else None, EMPTY, value)

    def _general_power(self, of: Node, bound: Mapping[str, Linear]) -> Measured:
        under, exponent = (self.measured(each, bound) for each in of.outside)
        self.plain(under, of.outside[0])
        self.number(exponent, of.outside[1])
        if not under.form:
            return Measured(under.form)
        if isinstance(exponent.value, Rational):
            return Measured(scaled(under.form, exponent.value))
        form: Linear = EMPTY
        for monomial, n in _polynomial(of.outside[1]).items():
            form = added(form, {_times(monomial, atom): m for atom, m in under.form.items()}, n)
        return Measured(form)

    def _function(self, of: Node, bound: Mapping[str, Linear]) -> Measured:
        (argument,) = of.outside
        inner = self.measured(argument, bound)
        value = _value(_AT[of.tag], inner.value, zeros=of.tag not in ("exp", "gamma"))
        if of.tag == "sqrt":
            self.plain(inner, argument)
            return Measured(
                {atom: ratio(n, 2) for atom, n in inner.form.items()} if inner.form is not None else None, EMPTY, value
            )
        if of.tag == "log":
            self.plain(inner, argument)
            return Measured(EMPTY, inner.form or EMPTY, value)
        if of.tag == "exp":
            self.number(Measured(inner.form), argument)
            return Measured(inner.logs, EMPTY, value)
        self.number(inner, argument)
        return Measured(EMPTY, EMPTY, value)

    def _call(self, of: Call, bound: Mapping[str, Linear]) -> Measured:
        form = self.letter(of.function)
        for k, (argument, order) in enumerate(zip(of.terms, of.orders, strict=True)):
            inner = self.measured(argument, bound)
            self.plain(inner, argument)
            place: Linear = {f"{of.function}#{k + 1}": 1}
            if inner.form is not None:
                self.groups += 1
                forms = (inner.form, place)
                self.require(added(inner.form, place, -1), argument, of, self.groups, Kind.ARGUMENT, forms)
            if form is not None:
                form = added(form, place if inner.form is None else inner.form, -order)
        return Measured(form)

    def _binder(self, of: Binder, bound: Mapping[str, Linear]) -> Measured:
        ends = [each for each in of.outside if not isinstance(each, int) or of.tag != "diff"]
        if of.tag == "mean":
            return Measured(self.measured(of.body, {**bound, of.letter: EMPTY}).form)
        if of.tag in ("sum", "product"):
            return self._repeated(of, bound)
        at = [(each, self.measured(each, bound)) for each in (of.outside[-1:] if of.tag == "diff" else ends)]
        known = [(each, m.form) for each, m in at if m.form is not None]
        form = known[0][1] if known else self._bound(of.letter)
        for each, other in known[1:]:
            self.groups += 1
            self.require(added(other, form, -1), each, known[0][0], self.groups, forms=(other, form))
        inner = self.measured(of.body, {**bound, of.letter: form})
        if of.tag == "diverges":
            return Measured(EMPTY)
        if of.tag == "diff":
            order = of.outside[-2]
            assert isinstance(order, int)
            return Measured(added(inner.form, form, -order) if inner.form is not None else None)
        self.plain(inner, of.body)
        return Measured(added(inner.form, form) if inner.form is not None else None)

    def _repeated(self, of: Binder, bound: Mapping[str, Linear]) -> Measured:
        """A sum or product over whole numbers; of one with these in exponents of what is no number nothing is known."""
        for end in of.outside:
            if not isinstance(end, End):
                self.number(self.measured(end, bound), end)
        before, groups = len(self.equations), self.groups
        inner = self.measured(of.body, {**bound, of.letter: EMPTY})
        forms = [inner.form or EMPTY, inner.logs, *(each.form for each in self.equations[before:])]
        if any(isinstance(atom, tuple) and of.letter in atom[0] for form in forms for atom in form):
            del self.equations[before:]
            self.groups = groups
            return Measured(self.unknown(of))
        self.plain(inner, of.body)
        if of.tag == "product" and inner.form:
            return Measured(self.unknown(of))
        return Measured(inner.form)


def _put(form: Linear, name: str, rest: Linear) -> Linear:
    """A form with another in the place of a base quantity, also where it is multiplied by letters."""
    found: Linear = EMPTY
    for atom, n in form.items():
        monomial, bare = atom if isinstance(atom, tuple) else ((), atom)
        found = added(found, {_times(monomial, each): m for each, m in rest.items()} if bare == name else {atom: 1}, n)
    return found


def _times(monomial: Monomial, atom: Atom) -> Atom:
    if isinstance(atom, tuple):
        monomial, atom = (*monomial, *atom[0]), atom[1]
    return (tuple(sorted(monomial)), atom) if monomial else atom


def addends(of: Term, sign: int = 1) -> Iterable[tuple[int, Term]]:
    """The addends of nested sums and differences, with their signs."""
    if isinstance(of, Value) and of.tag == "+":
        for part in of.outside:
            yield from addends(part, sign)
    elif isinstance(of, Value) and of.tag == "-":
        yield from addends(of.outside[0], -sign)
    else:
        yield sign, of


def _polynomial(of: Term) -> dict[Monomial, Rational]:
    """An exponent as a polynomial; what is none is a letter of its own."""
    alone: dict[Monomial, Rational] = {(words(of),): 1}
    match of:
        case int():
            return {(): of}
        case Value(tag="+", terms=parts):
            total: dict[Monomial, Rational] = {}
            for part in parts:
                for monomial, n in _polynomial(part).items():
                    total[monomial] = total.get(monomial, 0) + n
            return {monomial: n for monomial, n in total.items() if n}
        case Value(tag="-", terms=(part,)):
            return {monomial: -n for monomial, n in _polynomial(part).items()}
        case Value(tag="*", terms=parts):
            product: dict[Monomial, Rational] = {(): 1}
            for part in parts:
                pairs = [(one, n, other, m) for one, n in product.items() for other, m in _polynomial(part).items()]
                product = {}
                for one, n, other, m in pairs:
                    both = tuple(sorted((*one, *other)))
                    product[both] = product.get(both, 0) + n * m
                if len(product) > MOST_TERMS:
                    return alone
            return product
        case Value(tag="/", terms=(top, int(n))) if n:
            return {monomial: Fraction(m, n) for monomial, m in _polynomial(top).items()}
    return alone


def _value(
    function: Callable[[Any], Rational | float], at: Rational | float | None, zeros: bool = False
) -> Rational | float | None:
    """The value of a function of a number, if it has one that is of use; 0 near one of its zeros."""
    try:
        found: Rational | float | None = None if at is None else function(at)
    except (ValueError, OverflowError, ZeroDivisionError):
        return None
    return 0 if zeros and found is not None and -TINY < found < TINY else _short(found)


def _divided(top: Rational | float, bottom: Rational | float) -> Rational | float | None:
    if isinstance(top, float) or isinstance(bottom, float):
        return _value(lambda x: x / float(bottom), float(top))
    return _short(Fraction(top) / bottom)


def _power(under: Rational | float, n: int) -> Rational | float:
    return under**n if isinstance(under, float) or n >= 0 else Fraction(1) / under**-n


def _short(value: Rational | float | None) -> Rational | float | None:
    """A number, unless it has more digits than a printed one, or is a decimal too small to have any."""
    if isinstance(value, float):
        return value or None
    if value is not None and max(abs(value.numerator), value.denominator).bit_length() > MOST_BITS:
        return None
    return value


def scaled_equations(equations: list[Equation], scales: Sequence[Scale]) -> list[Equation]:
    """What is left of equations where these quantities are 1: of each a base quantity is expressed by the others."""
    if not scales:
        return equations
    units: dict[str, Linear] = {}

    def reduced(form: Linear) -> Linear:
        for name, rest in units.items():
            form = _put(form, name, rest)
        return form

    for scale in scales:
        form = reduced(scale.form)
        if pivot := next((atom for atom in form if isinstance(atom, str) and is_base(atom)), None):
            rest = {atom: ratio(-n, form[pivot]) for atom, n in form.items() if atom != pivot}
            units = {name: _put(other, pivot, rest) for name, other in units.items()} | {pivot: rest}
    return [each._replace(form=reduced(each.form)) for each in equations]


def _form(found: Sequence[tuple[int, Term, Measured]]) -> Linear | None:
    """The form of a sum: that of its first addend that is not 0."""
    return next((measured.form for *_, measured in found if measured.form is not None), None)
