"""Sums without an end, by what their partial sums are.

An addend f(k) is a multiple of one whose series everybody knows, such as x^k/k!, plus a difference G(k) - G(k + 1),
where G(k) is f(k) times a rational function and tends to 0: it has a factor that decreases like a geometric sequence or
faster, or is a rational function that does. That the addend is that is proved, and that the quotient is below 1. What
is left to trust is that such sums telescope, and the series in the table.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from symcheck.core.calculus import domain, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import INFINITY, PI, Binder, Formula, Malformed, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.proof.algebra.polynomial import Unsupported, number_of
from symcheck.question.hypergeometric import not_zero, plainly, ratio, worked_out
from symcheck.reading import from_sympy, to_sympy
from symcheck.reading.functions import applied

if TYPE_CHECKING:
    from sympy import Expr, Symbol

Hypotheses = tuple[tuple[str, tuple[Formula, ...]], ...]
LARGEST = 6  # the first place of a sum: addends before it are taken off one by one
FAULTS = (SymcheckError, Malformed, Unsupported, ValueError, ArithmeticError, NotImplementedError, TypeError)


@dataclass(frozen=True)
class Series:
    """A claim with values for its endless sums, and what shows that these are the values.

    Parameters
    ----------
    problem
        The claim with the values.
    sides
        The claims about addends, and that quotients are below 1.
    """

    problem: Problem
    sides: tuple[Problem, ...]


@dataclass(frozen=True)
class Known:
    """A multiple of a series that everybody knows: its addend, the place from which on it is, and its value.

    The square of `below` has to be less than 1.
    """

    multiple: Expr
    addend: Expr
    first: int
    value: Term
    below: Expr | int = 0


def with_values(problem: Problem) -> Series | None:
    """The problem with values for its endless sums; None if there are none, or one has none that is known here."""
    sums = {part: None for part in nodes(problem.claim) if isinstance(part, Binder) and part.tag == "sum"}
    sums = {part: None for part in sums if part.outside[-1] == INFINITY}
    meant = {x for x, _ in problem.definitions}
    others = letters(problem.claim).union(*(letters(f) for _, fs in problem.hypotheses for f in fs))
    if not sums or functions(problem.claim):
        return None
    sides, values = list[Problem](), dict[Term, Term]()
    for total in sums:
        low, inside = total.outside[0], letters(total.body)
        if not isinstance(low, int) or not 0 <= low <= LARGEST or inside & meant or total.letter in others:
            return None
        for apart in (False, True):
            with suppress(*FAULTS):
                values[total], more = _summed(total.body, total.letter, low, apart)
                break
        else:
            return None
        given = (*problem.hypotheses, ("place", (node(">=", total.letter, low),)))
        sides += [replace(problem, claim=_as_said(claim, given), hypotheses=given) for claim in more]
    return Series(replace(problem, claim=put(problem.claim, values)), tuple(sides))


def put(tree: T, values: Mapping[Term, Term]) -> T:
    """The same with the values of sums or integrals in their places."""
    if tree in values:
        return values[tree]  # type: ignore[index, return-value]
    return mapped(tree, lambda part: put(part, values)) if isinstance(tree, Node) else tree  # type: ignore[return-value]


def _as_said(claim: Formula, given: Hypotheses) -> Formula:
    """That a quotient is below 1, by its absolute value where a condition is about that."""
    match claim:
        case Node(tag="<", outside=(Node(tag="^", outside=(_, 2)) as square, 1)):
            size = node("sqrt", square)
            if any(size in nodes(formula) for _, formulas in given for formula in formulas):
                return node("<", size, 1)
    return claim


def _summed(body: Term, letter: str, low: int, apart: bool) -> tuple[Term, list[Formula]]:
    """The value of an endless sum, and the claims that show it."""
    import sympy

    k, powers = sympy.Symbol(letter, real=True), _Powers(letter)
    addend = plainly(to_sympy(body), k)
    addend = _apart(addend) if apart else addend
    base = next((each for each in known(addend, k, apart) if each.first <= low and each.multiple != 0), None)
    rest = addend
    if base is not None:
        relative = sympy.gammasimp(sympy.simplify(addend / base.addend)) - base.multiple
        rest = sympy.factor(relative) * base.addend
    gap = _gap(rest, k) if rest != 0 else sympy.Integer(0)
    claims = [*_vanishing(rest, gap, k)] if rest != 0 else []
    own = powers.without(from_sympy(gap))
    value, right = powers.at(own, low), node("+", own, node("-", powers.ahead(own)))
    if base is not None:
        multiple, each = from_sympy(base.multiple), powers.without(from_sympy(base.addend))
        before = (node("-", powers.at(each, j)) for j in range(base.first, low))
        value = node("+", value, node("*", multiple, node("+", base.value, *before)))
        right = node("+", right, node("*", multiple, each))
        if base.below != 0:
            claims.append(node("<", node("^", from_sympy(sympy.sympify(base.below)), 2), 1))
    stated = node("=", powers.without(body), worked_out(right))
    valued = [each for whole in domain(stated, divisors=True) for each in not_zero(whole) if letter in letters(each)]
    return worked_out(value), [*valued, stated, *claims]


def _apart(expr: Expr) -> Expr:
    """The same with powers of products as products of powers, as their exponents are whole."""
    from sympy import expand_power_base

    return expand_power_base(expr, force=True)


class _Powers:
    """Letters for powers whose exponents run with k: what holds of all numbers holds of them."""

    def __init__(self, k: str) -> None:
        self.k, self.letters = k, dict[Term, str]()

    def without(self, term: T) -> T:
        """A term with letters for powers of what does not depend on k, and for cosines of multiples of pi."""
        if not isinstance(term, Node) or self.k not in letters(term):
            return term
        match term:
            case Node(tag="pow", outside=(base, exponent)) if self.k not in letters(base):
                return self._power(base, exponent)  # type: ignore[return-value]
            case Node(tag="cos", outside=(angle,)):
                return self._power(-1, node("/", angle, PI))  # type: ignore[return-value]
        return mapped(term, self.without)  # type: ignore[return-value]

    def _power(self, base: Term, exponent: Term) -> Term:
        import sympy

        match base:
            case 1:
                return 1
            case Node(tag="*", outside=factors):
                return node("*", *(self._power(each, exponent) for each in factors))
            case Node(tag="/", outside=(top, bottom)):
                return node("/", self._power(top, exponent), self._power(bottom, exponent))
        k = sympy.Symbol(self.k, real=True)
        line = sympy.Poly(sympy.expand(to_sympy(exponent)), k)
        steps, start = line.nth(1), line.nth(0)
        if line.degree() != 1 or not steps.is_Integer or not start.is_Integer:
            raise SymcheckError("a power that is no geometric sequence")
        base = -1 if number_of(base) == -1 else base
        letter = self.letters.setdefault(base, f"{self.k}_power_{len(self.letters) + 1}")
        return node("*", node("^", letter, int(steps)), node("^", base, int(start)))

    def at(self, term: Term, number: int) -> Term:
        """Its value at a place."""
        return substituted(term, {self.k: number} | {x: node("^", base, number) for base, x in self.letters.items()})

    def ahead(self, term: Term) -> Term:
        """Its value at the next place."""
        more: dict[str, Term] = {x: node("*", x, base) for base, x in self.letters.items()}
        return substituted(term, {self.k: node("+", self.k, 1)} | more)


def _gap(rest: Expr, k: Symbol) -> Expr:
    """G with rest = G(k) - G(k + 1), by Gosper's algorithm."""
    import sympy
    from sympy.concrete.gosper import gosper_term

    found = gosper_term(rest, k)
    if found is None:
        raise SymcheckError("it does not telescope")
    plain = [factor for factor in sympy.Mul.make_args(rest) if factor.is_rational_function(k)]
    others = [factor for factor in sympy.Mul.make_args(rest) if factor not in plain]
    gap = -sympy.factor(sympy.cancel(found * sympy.Mul(*plain))) * sympy.Mul(*others)
    if gap.is_rational_function(k):  # up to a constant, which makes no difference
        gap = sympy.factor(gap - sympy.limit(gap, k, sympy.oo))
    return gap


def _vanishing(rest: Expr, gap: Expr, k: Symbol) -> Iterator[Formula]:
    """The claims that G tends to 0; SymcheckError where it does not, or it is not known."""
    import sympy

    quotient = sympy.limit(ratio(rest, k), k, sympy.oo)
    if quotient.has(k) or (not quotient.is_finite and quotient.is_finite is not None):
        raise SymcheckError("the quotient of neighbouring addends has no limit")
    if quotient == 1:
        if not gap.is_rational_function(k) or sympy.limit(gap, k, sympy.oo) != 0:
            raise SymcheckError("it does not vanish")
    elif quotient != 0:
        yield node("<", node("^", from_sympy(quotient), 2), 1)


def known(addend: Expr, k: Symbol, apart: bool = False) -> Iterator[Known]:
    """Multiples of known series that may stand in an addend, with powers of products as such or apart."""
    import sympy

    step = ratio(addend, k)
    quotient = sympy.limit(step, k, sympy.oo)
    if quotient == 0:
        yield from _exponential(addend, step, k, apart)
    elif quotient == 1 and addend.is_rational_function(k):
        for power, value in ((2, 6), (4, 90)):
            yield Known(_residue(addend, k, power), k**-power, 1, node("/", node("^", PI, power), value))
    elif quotient == -1:
        sign = (-1) ** k
        bare = sympy.simplify(addend / sign)
        if bare.is_rational_function(k):
            yield Known(_residue(bare, k, 1), sign / k, 1, node("-", node("log", 2)))
            yield Known(_residue(bare, k, 1, sympy.Rational(-1, 2)) * 2, sign / (2 * k + 1), 0, node("/", PI, 4))
            yield Known(_residue(bare, k, 2), sign / k**2, 1, node("/", node("^", PI, 2), -12))
    elif not quotient.has(k):
        power = _geometric(quotient, k)
        bare = sympy.simplify(addend / power)
        if bare.is_rational_function(k):
            multiple, logarithm = _residue(bare, k, 1, weight=quotient), node("log", from_sympy(1 - quotient))
            for more in range(LARGEST):
                own = power * quotient**more / (k + more)
                yield Known(multiple, own, 1 - more, node("-", logarithm), quotient)
            yield from _of_odd_powers(_residue(bare, k, 1, sympy.Rational(-1, 2), quotient) * 2, quotient, k)
        else:
            yield from _binomial(addend, step, quotient, k)


def _of_odd_powers(multiple: Expr, quotient: Expr, k: Symbol) -> Iterator[Known]:
    """Series of inverse tangents, if the quotient is a square or the contrary of one."""
    import sympy

    circular = quotient.could_extract_minus_sign()
    root = sympy.sqrt(sympy.factor(-quotient if circular else quotient))
    root = root.args[0] if isinstance(root, sympy.Abs) else root
    if not root.is_number and any(each.exp.is_Rational and not each.exp.is_Integer for each in root.atoms(sympy.Pow)):
        return  # it may have no value where the series has one
    value = applied("arctan" if circular else "artanh", from_sympy(root))
    assert value is not None
    own = _geometric(quotient, k) / (2 * k + 1)
    yield Known(multiple, own, 0, node("/", value, from_sympy(root)), quotient)


def _geometric(quotient: Expr, k: Symbol) -> Expr:
    """Its power, as print has it: (-1)^k x^(2 k)."""
    if quotient.could_extract_minus_sign():
        return (-1) ** k * _geometric(-quotient, k)
    base, exponent = quotient.as_base_exp()
    return base ** (exponent * k) if exponent.is_Integer and exponent > 0 else quotient**k


def _binomial(addend: Expr, step: Expr, x: Expr, k: Symbol) -> Iterator[Known]:
    """The series of (1 - x)^-a."""
    import sympy

    top, bottom = (sympy.Poly(each, k) for each in sympy.fraction(sympy.cancel(step / x)))
    if top.degree() == bottom.degree() == 1 and sympy.expand(bottom.nth(0) / bottom.LC()) == 1:
        a = sympy.cancel(top.nth(0) / top.LC())
        own = sympy.gamma(a + k) / (sympy.gamma(a) * sympy.gamma(k + 1)) * x**k
        multiple = sympy.gammasimp(sympy.simplify(addend / own))
        if not multiple.has(k):
            yield Known(multiple, own, 0, node("pow", from_sympy(1 - x), from_sympy(-a)), x)


def _exponential(addend: Expr, step: Expr, k: Symbol, apart: bool) -> Iterator[Known]:
    """Series of exponentials, and of cosines and sines."""
    import sympy

    x = sympy.limit(step * k, k, sympy.oo)
    if x != 0 and x.is_finite is not False:
        own = (_apart(x**k) if apart else x**k) / sympy.gamma(k + 1)
        factor = sympy.expand(sympy.gammasimp(sympy.simplify(addend / own)))
        if factor.is_polynomial(k):
            multiple, falling = sympy.Integer(0), sympy.Poly(factor, k)
            for j in range(falling.degree() + 1):  # k (k - 1) ... (k - j + 1) x^k/k! makes x^j exp x
                multiple += _falling(falling, k, j) * x**j
            yield Known(multiple, own, 0, node("exp", from_sympy(x)))
        for more in range(1, LARGEST):  # the same from a later addend on
            ahead = own.subs(k, k + more)
            multiple = sympy.gammasimp(sympy.simplify(addend / ahead))
            if not multiple.has(k):
                yield Known(multiple, ahead, -more, node("exp", from_sympy(x)))
        return
    y = sympy.limit(step * k**2, k, sympy.oo) * 4
    if y == 0 or y.is_finite is False:
        return
    sign = -1 if y.could_extract_minus_sign() else 1
    root = sympy.sqrt(sympy.factor(sign * y))
    root = root.args[0] if isinstance(root, sympy.Abs) else root
    for shift, name in enumerate(("cos", "sin") if sign < 0 else ("cosh", "sinh")):
        own = root ** (2 * k + shift) / sympy.gamma(2 * k + shift + 1) * (sympy.Integer(-1) ** k if sign < 0 else 1)
        factor = sympy.gammasimp(sympy.simplify(addend / own))
        if not factor.has(k):
            value = applied(name, from_sympy(root))
            assert value is not None
            yield Known(factor, own, 0, value)


def _falling(poly: Expr, k: Symbol, j: int) -> Expr:
    """The coefficient of the j-th falling factorial: the j-th difference at 0, divided by j!."""
    import sympy

    terms = ((-1) ** (j - i) * sympy.binomial(j, i) * poly.eval(i) for i in range(j + 1))
    return sympy.Add(*terms) / sympy.factorial(j)


def _residue(expr: Expr, k: Symbol, power: int, at: Expr | int = 0, weight: Expr | int = 1) -> Expr:
    """The sum of the coefficients of that power of 1/(k + j), for all whole j; `at` is where one of the poles is.

    Each counts as often as the power of the weight by which it is away from there.
    """
    import sympy

    total = sympy.Integer(0)
    for part in sympy.Add.make_args(sympy.apart(expr, k)):
        top, bottom = sympy.fraction(sympy.together(part))
        roots = sympy.roots(sympy.Poly(bottom, k)) if bottom.has(k) else {}
        if len(roots) == 1:
            ((root, order),) = roots.items()
            if order == power and (root - at).is_integer and not top.has(k):
                total += top / sympy.Poly(bottom, k).LC() * sympy.sympify(weight) ** (root - at)
    return total
