"""Terms that are manifestly positive or not negative, found for polynomials and fractions; polynomials as terms."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import product

from symcheck.core.terms import Term, Value, node
from symcheck.proof.algebra.flint import Poly, by_powers, fraction
from symcheck.proof.algebra.knowledge import Knowledge, proportional
from symcheck.proof.algebra.variables import circle, cosine, sine, table

FEW = 6  # addends of a polynomial of which a bound is multiplied by a letter
MAX_BOUNDS = 3  # subtracted one after the other: each is tried at every addend, so the work grows as their power
HALF = Fraction(1, 2)


def fraction_form(term: Term, known: Knowledge, top: Poly | None = None) -> Term | None:
    """A manifestly non-negative term equal to a fraction (its numerator may be given in another form), or None."""
    ratio = known.ring.ratio(term)
    top = ratio.num if top is None else top
    if not ratio.den:
        return form_on_the_circle(top, known)
    for sign in (1, -1):
        bottom = sign * ratio.bottom()
        if (form := form_on_the_circle(sign * top, known)) is None:
            continue
        if bottom == 1:
            return form
        if (below := form_on_the_circle(bottom, known)) is not None:
            return node("/", form, below)
    return None


def positive_form(poly: Poly, known: Knowledge, squares: bool = False) -> Term | None:
    """A manifestly non-negative term equal to the polynomial, or None: factors, expanded sums, known bounds.

    squares  whether squares are completed, of which a proof tells more than of what the hypotheses say
    """
    for bound in known.signs:
        if (multiple := proportional(poly, bound.poly)) is not None and multiple > 0:
            return bound.term if multiple == 1 else node("*", number_term(multiple), bound.term)
    unit, factors = poly.factor()
    sign = fraction(unit)
    parts: list[Term] = []
    for factor, exponent in factors:
        if exponent % 2 == 0:
            parts.append(node("^", term_of(factor), int(exponent)))
            continue
        form = _factor_form(factor, known) or (_squares(factor, known) if squares else None)
        if form is None:
            form = _factor_form(-factor, known) or (_squares(-factor, known) if squares else None)
            sign = -sign
        if form is None:
            return None
        parts.append(form if exponent == 1 else node("^", form, int(exponent)))
    if sign < 0:
        return None
    return node("*", number_term(sign), *parts) if parts else number_term(sign)


def form_on_the_circle(poly: Poly, known: Knowledge) -> Term | None:
    """The same, as sin^2 + cos^2 = 1 allows: 1 + 3 cos^2 a for 4 - 3 sin^2 a."""
    every = [poly, *_on_the_circle(poly)]
    forms = (form(written, known) for form in (positive_form, _within_one) for written in every)
    found = next((form for form in forms if form is not None), None)
    return positive_form(poly, known, squares=True) if found is None else found


def _within_one(poly: Poly, known: Knowledge) -> Term | None:
    """The same of 2 + sin x, 1 - e sin x and the like, as 2 (1 + sin x) = (1 + sin x)^2 + cos^2 x."""
    rest, parts, context = poly, list[Term](), poly.context()
    for k, (name, generator) in enumerate(zip(context.names(), context.gens(), strict=True)):
        if (turn := circle(name)) is None:
            continue
        own = {(*powers[:k], 0, *powers[k + 1 :]): a for powers, a in poly.terms() if powers[k] == 1}
        alone = {powers: a for powers, a in own.items() if not any(powers)}
        sizes = ((sign * context.from_dict(each), sign) for each in (own, alone) if each for sign in (1, -1))
        found = next(((size, sign, form) for size, sign in sizes if (form := positive_form(size, known))), None)
        if found is None:
            continue
        size, sign, form = found
        rest -= sign * generator * size + size
        other = table().term((cosine if turn[0] == "sin" else sine)(turn[1]))
        beside = table().term(name) if sign > 0 else node("-", table().term(name))
        squares = node("+", node("^", node("+", 1, beside), 2), node("^", other, 2))
        if size.is_constant():
            parts.append(node("*", number_term(fraction(size.leading_coefficient()) * HALF), squares))
        else:
            parts.append(node("*", number_term(HALF), form, squares))
    last = positive_form(rest, known) if parts and rest != 0 else 0
    return node("+", *parts, last) if parts and last is not None else None


def _on_the_circle(poly: Poly) -> Iterator[Poly]:
    """The polynomial with the squares of all sines, or of all cosines, replaced by those of the others."""
    context = poly.context()
    generators = dict(zip(context.names(), context.gens(), strict=True))
    angles = [
        x for function, x in filter(None, map(circle, generators)) if function == "sin" and cosine(x) in generators
    ]
    for old, new in ((sine, cosine), (cosine, sine)):
        turned = poly
        for x in angles:
            powers = by_powers(turned, old(x))
            if max(powers, default=0) > 1:
                square, single = 1 - generators[new(x)] ** 2, generators[old(x)]
                turned = sum((c * square ** (n // 2) * single ** (n % 2) for n, c in powers.items()), start=poly * 0)
        if turned != poly:
            yield turned


def number_term(value: Fraction) -> Term:
    """A rational number as a term."""
    return value.numerator if value.denominator == 1 else node("/", value.numerator, value.denominator)


def _factor_form(poly: Poly, known: Knowledge, depth: int = MAX_BOUNDS) -> Term | None:
    """The polynomial as a sum of non-negative addends and positive multiples of known bounds."""
    term = term_of(poly)
    if known.sign(term)[0]:
        return term
    if depth == 0:
        return None
    for bound in known.signs:
        for exponents, coefficient in bound.poly.terms():
            mine = poly[exponents]
            if mine * coefficient <= 0 or len(bound.poly) == 1:
                continue
            number = number_term(fraction(mine / coefficient))
            rest = poly - bound.poly * (mine / coefficient)
            if rest == 0:
                return node("*", number, bound.term)
            if (form := _factor_form(rest, known, depth - 1)) is not None:
                return node("+", node("*", number, bound.term), form)
    return _with_a_multiple(poly, known) if depth == MAX_BOUNDS and len(poly) <= FEW else None


def _with_a_multiple(poly: Poly, known: Knowledge) -> Term | None:
    """The same with one bound times what has a sign: 1 - x y is x (1 - y) + (1 - x)."""
    for bound in known.signs:
        for (own, divisor), (powers, coefficient) in product(bound.poly.terms(), poly.terms()):
            exponents = tuple(b - a for a, b in zip(own, powers, strict=True))
            if divisor * coefficient <= 0 or min(exponents) < 0 or not any(exponents):
                continue
            factor = poly.context().from_dict({exponents: coefficient / divisor})
            if known.sign(times := term_of(factor))[0]:
                rest = poly - bound.poly * factor
                if rest == 0:
                    return node("*", times, bound.term)
                if (form := _factor_form(rest, known, MAX_BOUNDS - 1)) is not None:
                    return node("+", node("*", times, bound.term), form)
    return None


def _squares(poly: Poly, known: Knowledge) -> Term | None:
    """The polynomial as a positive multiple of a square, and a form of what that leaves: (x + 1)^2 + 4.

    Squares of what is known not to be zero are left to the last: they tell a positive form from one that may be zero.
    """
    letters = zip(poly.context().names(), poly.context().gens(), strict=True)
    for name, x in sorted(letters, key=lambda letter: known.sign(node("^", table().term(letter[0]), 2))[0]):
        powers = by_powers(poly, name)
        half, odd = divmod(max(powers), 2)
        first = powers[max(powers)]
        if odd or not half or not first.is_constant():
            continue
        if (a := first.leading_coefficient()) < 0:
            return None
        root = x**half
        for k in range(1, half + 1):  # the square of the root has the same coefficients of half the powers
            left = by_powers(poly / a - root**2, name).get(2 * half - k)
            root += 0 if left is None else left / 2 * x ** (half - k)
        rest = poly - a * root**2
        form = _factor_form(rest, known) or _squares(rest, known) if rest != 0 else 0
        if form is None:
            return None
        square = node("*", number_term(fraction(a)), node("^", term_of(root), 2))
        return square if form == 0 else node("+", square, form)
    return None


def stronger(form: Term, known: Knowledge) -> Term:
    """The same product with a form of one sign for the base of an even power that may be zero."""
    match form:
        case Value(tag="*" | "/", terms=parts):
            return node(form.tag, *(stronger(part, known) for part in parts))
        case Value(tag="^", terms=(base, int(n))) if n % 2 == 0 and known.sign(form)[0] < 2:
            value = known.ring.ratio(base)
            forms = (_factor_form(each, known) for each in (value.num, -value.num)) if not value.den else ()
            return next((node("^", each, n) for each in forms if each is not None), form)
    return form


def term_of(poly: Poly) -> Term:
    """A polynomial as a term, expanded; even powers stay visible."""
    names = poly.context().names()
    addends: list[Term] = []
    for exponents, coefficient in poly.terms():
        value = fraction(coefficient)
        number = number_term(abs(value))
        bases = ((table().term(name), int(e)) for name, e in zip(names, exponents, strict=True) if e)
        powers: list[Term] = [base if e == 1 else node("^", base, e) for base, e in bases]
        factors = powers if number == 1 and powers else [number, *powers]
        term: Term = factors[0] if len(factors) == 1 else node("*", *factors)
        addends.append(term if value > 0 else node("-", term))
    return addends[0] if len(addends) == 1 else node("+", *addends) if addends else 0
