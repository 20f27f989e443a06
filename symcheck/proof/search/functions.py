"""Which theorems speak of a function: roots, powers, gamma functions, means and integrals.

A function stands in the ring as one variable, an *atom* (`polynomial.atom`). What is known of it is said by theorems
that the checker knows (`symcheck/checker/theorems.py`); `theorem_search` proves their premises.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from math import comb, prod

from symcheck.checker.theorems import KNOWN, theorem
from symcheck.core.calculus import Unknown, letters, nodes, substituted
from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Binder, End, Node, Relation, Term, mapped, node
from symcheck.proof.algebra.facts import by_construction
from symcheck.proof.algebra.flint import Poly, by_powers, fraction, occurring, rational
from symcheck.proof.algebra.forms import number_term, term_of
from symcheck.proof.algebra.ideal import Ideal
from symcheck.proof.algebra.knowledge import Knowledge, proportional
from symcheck.proof.algebra.polynomial import (
    BINDING,
    Ratio,
    Ring,
    Unsupported,
    angle,
    beneath,
    canonical,
    exponents,
    number_of,
    parts,
    square_free,
    subterms,
    variables,
    with_arguments,
)
from symcheck.proof.algebra.variables import atoms, cosine, sine, table
from symcheck.proof.rules.theorem import Instance, applied, congruence, of

SIGNS = ("positive_cosine", "right_half", "positive_sine")  # theorems about sines and cosines between their zeros
# acute angles, in half turns, and the theorems that say of which numbers they are the inverse functions
ACUTE = {
    Fraction(1, 6): "known_angle_arcsin_1",
    Fraction(1, 4): "known_angle_arctan_2",
    Fraction(1, 3): "known_angle_arccos_3",
}
QUARTERS = (0, -1, 1, -2, 2, -3, 3)  # by which an angle is turned: beyond, authors write multiples of whole turns
MAX_ADDENDS = 8  # of an exponent or angle that is expanded: each becomes a variable
MAX_POWER_SUM = 8  # of an index: the sums that people print have at most the fourth
HALF_LINE = (0, INFINITY)
WHOLE_LINE = (MINUS_INFINITY, INFINITY)

_HALF = Fraction(1, 2)
STEPS = range(2, 9)  # between gamma functions: in printed formulas hardly more


def instances(name: str, names: set[str]) -> Iterator[Instance]:
    """The theorems about an atom, and about it together with other atoms."""
    tree = atoms()[name]
    others = [atoms()[other] for other in sorted(names) if other in atoms() and other != name]
    try:
        if tree.tag in _ABOUT:
            yield from _ABOUT[tree.tag](tree, [other for other in others if other.tag == tree.tag])
    except (Unsupported, Unknown):
        return


def signs(angle: Term) -> Iterator[Instance]:
    """The signs of the sine and the cosine of an angle in every quarter of a turn, from -270 to 270 degrees."""
    if not letters(angle):  # turned, it is another number, whose sine has another name
        yield from (applied(name, angle) for name in ("positive_cosine", "positive_sine"))
        return
    for quarter in QUARTERS:
        turned = node("+", angle, node("*", node("/", quarter, 2), PI)) if quarter else angle
        yield from (applied(name, turned) for name in ("positive_cosine", "right_half"))


def is_compared(angle: Term, known: Knowledge) -> bool:
    """Whether an order is assumed of an angle: one that has a power product of letters with it in common."""
    if not variables(angle) <= {*known.ring.names}:
        return False
    pi = known.ring.names.index("pi") if "pi" in known.ring.names else None

    def products(poly: Poly) -> set[tuple[int, ...]]:
        found = (tuple(int(e) for e in exponents) for exponents, _ in poly.terms())
        return {each for each in found if any(e for k, e in enumerate(each) if k != pi)}

    own = products(known.ring.ratio(angle).num)
    return any(own & products(sign.poly) for sign in known.signs)


def expanded(name: str) -> Iterator[Instance]:
    """An exponential, sine or cosine of anything is that of a sum of multiples of powers of letters."""
    tree = table().term(name)
    if not beneath(name) or not isinstance(tree, Node):
        return
    (term,) = tree.terms
    inverse, _ = table().exponentials.get(name, ("", tree))
    if inverse and term == node("-", *table().exponentials[inverse][1].terms):
        return  # what is said of that other one is enough
    if tree.tag != "exp" and (turns := number_of(node("/", term, PI))) is not None and (2 * turns).denominator != 1:
        yield from _known_turn(tree.tag, turns)
        return
    value = Ring(variables(term)).ratio(term)
    scale, known = fraction(value.bottom().leading_coefficient()), exponents if tree.tag == "exp" else angle
    monic = Ratio(value.num, {"": (value.bottom() / value.bottom().leading_coefficient(), 1)})
    addends: list[Term] = []
    for powers, number in value.num.terms():
        monomial = _over(value.num.context().from_dict({powers: 1}), monic)
        addends.append(node("*", number_term(fraction(number) / scale), monomial))
    if 0 < len(addends) <= MAX_ADDENDS and known(term) != known(whole := node("+", *addends)):
        yield congruence(tree, node(tree.tag, whole))


def _known_turn(function: str, turns: Fraction) -> Iterator[Instance]:
    """The sine or cosine of so many times pi as that of a well-known acute angle and of right ones."""
    right, rest = divmod(2 * turns, 1)
    if rest / 2 not in ACUTE:
        return
    known = theorem(ACUTE[rest / 2]).conclusion
    assert isinstance(known, Relation)
    by_right_angles = node("+", node("*", number_term(Fraction(right, 2)), PI), known.terms[0])
    yield congruence(node(function, node("*", number_term(turns), PI)), node(function, by_right_angles))


def simplified(name: str, known: Knowledge) -> Iterator[Instance]:
    """A function at arguments that the equations in force make simpler."""
    tree = atoms()[name]
    if tree[0] in BINDING:
        return
    arguments = parts(tree)
    simpler = tuple(_simplified(term, known) for term in arguments)
    if [*map(canonical, simpler)] != [*map(canonical, arguments)]:
        yield congruence(tree, mapped(tree, dict(zip(arguments, simpler, strict=True)).__getitem__))


def _simplified(term: Term, known: Knowledge) -> Term:
    """The term with numerator and denominator in normal form."""
    if not variables(term) <= set(known.ring.names):
        return term
    value, ideal = known.ring.ratio(term), known.ideal()
    den = {text: (ideal.reduce(poly**exponent), 1) for text, (poly, exponent) in value.den.items()}
    return _over(ideal.reduce(value.num), Ratio(value.num, den))


def _root(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    yield applied("root", *tree.terms)
    if tree.terms == (PI,):
        yield applied("equal_squares", node("sqrt", PI), node("gamma", node("/", 1, 2)))
    radicands = [radicand for root in (tree, *others) for radicand in root.terms]
    for s, t in combinations(radicands, 2):
        product = node("*", s, t)
        if any(canonical(product) == canonical(r) for r in radicands):
            yield applied("root_of_product", s, t)
        elif (number := number_of(product)) is not None and number > 0:
            roots = node("*", node("sqrt", s), node("sqrt", t))
            yield applied("equal_squares", roots, node("sqrt", number_term(number)))
    for (other,) in (root.terms for root in others):
        if (times := number_of(node("/", *tree.terms, other))) is not None and times > 1:
            yield applied("root_of_product", number_term(times), other)


def _power(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    base, exponent = tree.terms
    powers = [power.terms for power in others]
    yield applied("power", base, exponent)
    if number_of(base) == 1:
        yield applied("power_of_power", 1, 1, exponent)
    elif (half := _square_root(base)) is not None:
        doubled = number_of(node("*", 2, exponent))
        opposite = [canonical(node("*", 2 * sign, exponent)) for sign in (1, -1)]
        partners = [other for other, more in powers if canonical(more) in opposite]
        if (doubled is not None and doubled.denominator == 1) or canonical(half) in map(canonical, partners):
            yield applied("power_of_power", half, 2, exponent)
    same = [more for other, more in powers if canonical(other) == canonical(base)]
    for s, t in combinations(same, 2):
        if canonical(node("+", s, t)) == canonical(exponent):
            yield applied("power_of_sum", base, s, t)
    for (s, first), (t, second) in combinations(powers, 2):
        if canonical(first) == canonical(second) == canonical(exponent) and canonical(node("*", s, t)) == canonical(
            base
        ):
            yield applied("power_of_product", s, t, exponent)
    if any(_nested(power) for power in (tree, *others)):
        yield applied("power_as_exp", base, exponent)
    for other, more in powers:
        if canonical(other) == canonical(base):
            gap, whole = (number_of(node("+", exponent, other)) for other in (node("-", more), more))
            if gap is not None and gap.denominator == 1:
                yield applied("power_of_sum", base, more, int(gap))
            if whole is not None and whole.denominator == 1:
                yield applied("power_of_sum", base, exponent, more)


def _nested(power: Node) -> bool:
    """Whether a power has a power for its base, or a logarithm in its exponent."""
    base, exponent = (term if isinstance(term, Node) else node("pi") for term in power.terms)
    return base.tag == "pow" or any(part.tag == "log" for part in nodes(exponent))


def _square_root(term: Term) -> Term | None:
    """A term whose square is the polynomial, or None."""
    value = Ring(variables(term)).ratio(term)
    if value.num == 0 or value.den:
        return None
    unit, factors = value.num.factor()
    number = fraction(unit)
    if number <= 0 or not (factors or value.num == 1):
        return None
    outside, primes = square_free(number)
    if primes or any(exponent % 2 for _, exponent in factors):
        return None
    bases = (poly ** (exponent // 2) for poly, exponent in factors)
    return term_of(prod(bases, start=value.num**0 * rational(outside)))


def _gamma(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    (t,) = tree.terms
    number = number_of(t)
    if number is not None and number > 1:
        yield applied("gamma", number_term(number - 1))
    elif number in (1, _HALF):
        yield applied("gamma_values")
    doubled = number is None and canonical(node("*", 2, t)) in [canonical(gamma.terms[0]) for gamma in others]
    for (other,) in (gamma.terms for gamma in others):
        if number is None and number_of(node("+", t, other)) == 1:
            yield applied("gamma_reflected", t)
        if doubled and number_of(node("+", other, node("-", t))) == _HALF:
            yield applied("gamma_doubled", t)
        if number is None and number_of(node("+", other, node("-", t))) == 1:
            yield applied("gamma", t)
        ahead = number_of(node("+", t, node("-", other))) if number is None else None
        if ahead == 1:
            yield applied("gamma", other)
        elif ahead in STEPS:  # down to the other one by one
            yield applied("gamma", node("+", t, -1))


def _mean(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    """The constant Fourier coefficient, and the integral of the rest."""
    assert isinstance(tree, Binder)
    body, x = tree.body, tree.letter
    ring = Ring({*variables(body), sine(x), cosine(x)})
    value = ring.ratio(body)
    s, c = ring.names.index(sine(x)), ring.names.index(cosine(x))
    mean, primitive = ring.number(0), ring.number(0)
    for powers, coefficient in value.num.terms():
        i, j = int(powers[c]), int(powers[s])
        others_ = tuple(0 if k in (s, c) else int(e) for k, e in enumerate(powers))
        outside = ring.context.from_dict({others_: coefficient})
        for k, (real, imaginary) in _harmonics(i, j).items():
            if k == 0:
                mean += outside * rational(real)
            elif k > 0:  # 2 Re (a + i b) e^(ikx) = d/dx of 2 (b cos kx + a sin kx) / k
                turned = ring.turn({x: k})
                primitive += outside * (turned[0] * rational(2 * imaginary / k) + turned[1] * rational(2 * real / k))
    yield applied("mean", of(x, body), _over(mean, value), of(x, _over(primitive, value)))


def _harmonics(i: int, j: int) -> dict[int, tuple[Fraction, Fraction]]:
    """cos^i sin^j as sum of (a + i b) e^(ikx), by k >= 0."""
    found: dict[int, tuple[Fraction, Fraction]] = {}
    turn = ((1, 0), (0, -1), (-1, 0), (0, 1))[j % 4]  # (1 / i)^j
    for a in range(i + 1):
        for b in range(j + 1):
            k = i - 2 * a + j - 2 * b
            size = Fraction(comb(i, a) * comb(j, b) * (-1) ** b, 2 ** (i + j))
            real, imaginary = found.get(k, (Fraction(0), Fraction(0)))
            found[k] = real + size * turn[0], imaginary + size * turn[1]
    return found


def _integral(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    assert isinstance(tree, Binder)
    body, x, ends = tree.body, tree.letter, tree.outside
    if ends == WHOLE_LINE:
        mirrored = canonical(substituted(body, {x: node("-", x)}))
        if mirrored == canonical(body):
            yield applied("even", of(x, body))
        if mirrored == canonical(node("-", body)):
            yield applied("odd", of(x, body))
    if not any(isinstance(end, End) for end in ends):
        low, high = ends
        if number_of(node("/", node("+", high, node("-", low)), PI)) == 2:
            yield from _full_turn(body, x, low)
        if x not in letters(body):
            yield applied("constant", body, *ends)
        else:  # c x b^v with b = p x^2 + q is the derivative of c b^(v+1) / (2 p (v + 1))
            c, k, u, r, p, q = _shape(body, x)
            exponent = node("+", 1, node("-", r))
            if (k, u) == (1, 0):
                outside = node("/", c, node("*", 2, p, exponent))
                base = node("+", node("*", p, node("^", x, 2)), q)
                yield applied("power_rule", of(x, body), *ends, outside, of(x, base), exponent)
    if ends == HALF_LINE and (power := _pure_power(body, x)) is not None:
        yield applied("power_diverges", of(x, body), *power)
    if ends in (HALF_LINE, WHOLE_LINE):
        shape = _shape(body, x)
        yield applied("beta", of(x, body), *shape)
        yield applied("beta_diverges", of(x, body), *shape)


def _full_turn(body: Term, x: str, low: Term) -> Iterator[Instance]:
    """What has a sum of sine and cosine below, over one turn."""
    ring = Ring({*variables(body), sine(x), cosine(x)})
    value = ring.ratio(body)
    below = [(poly, exponent) for poly, exponent in value.den.values() if _depends(poly, x)]
    if _depends(value.num, x) or len(below) != 1 or below[0][1] != 1:
        return
    zero = ring.number(0)
    by_sine = by_powers(below[0][0], sine(x))
    by_cosine = by_powers(by_sine.get(0, zero), cosine(x))
    a, b, c = by_cosine.get(0, zero), by_cosine.get(1, zero), by_sine.get(1, zero)
    if {*by_sine, *by_cosine} <= {0, 1} and not any(_depends(poly, x) for poly in (a, b, c)):
        above = Ratio(value.num, {text: each for text, each in value.den.items() if not _depends(each[0], x)})
        square = a * a - b * b - c * c
        whole = Ring({name for name in ring.names if not _depends(ring.generator[name], x)})
        reduced = term_of(Ideal(whole, by_construction(whole)).reduce(whole.poly(term_of(square))))
        roots = [_square_root(reduced)] if square != 0 else []
        values = [each for root in roots if root is not None for each in (root, node("-", root))]
        for root in values or [node("sqrt", reduced)]:
            yield applied("full_turn", of(x, body), *map(term_of, (a, b, c)), _over(value.num, above), root, low)


def _sum(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    """A sum of powers of its index; any other is that of its first addend and that of the rest."""
    assert isinstance(tree, Binder)
    body, x, ends = _linear_inside(tree.body), tree.letter, tree.outside
    addends = _by_index(body, x)
    if len(addends) == 1 and addends[0][0] == 1:
        ring = Ring({x})
        value = ring.ratio(addends[0][1]) if variables(addends[0][1]) <= {x} else None
        if value and not value.den and len(value.num) == 1 and (k := int(value.num.degrees()[0])) <= MAX_POWER_SUM:
            whole = power_sum(k, x)
            first = substituted(whole, {x: node("+", ends[0], -1)})
            yield applied("telescope", of(x, tree.body), of(x, node("+", whole, node("-", first))), *ends)
        return
    for inner in nodes(tree.body):
        if inner.tag == "sum":
            yield from _sum(inner, others)
    if addends:
        (number, first), *rest = addends
        below = node("+", *(node("*", *each) for each in rest)) if rest else 0
        yield applied("sum_of_sums", of(x, tree.body), of(x, first), of(x, below), number, int(bool(rest)), *ends)


def _linear_inside(body: Term) -> Term:
    """The same with sums in it taken apart: what is free of their index stands before them."""
    if isinstance(body, Binder) and body.tag == "sum":
        addends = _by_index(_linear_inside(body.body), body.letter)
        return node("+", 0, *(node("*", c, node("sum", part, body.letter, *body.outside)) for c, part in addends))
    return mapped(body, _linear_inside) if isinstance(body, Node) and not body.bound else body


def _by_index(body: Term, x: str) -> list[tuple[Term, Term]]:
    """Coefficients and what depends on the index, as factors of the addends of a body."""
    value = Ring(with_arguments({*variables(body), x})).ratio(body)
    context, free = value.num.context(), value.num**0
    below = {text: (poly, n) for text, (poly, n) in value.den.items() if _depends(poly, x)}
    depending = [_depends(generator, x) for generator in context.gens()]
    found: dict[tuple[int, ...], Poly] = {}
    for powers, number in value.num.terms():
        inside = tuple(int(n) * depends for n, depends in zip(powers, depending, strict=True))
        outside = tuple(int(n) - k for n, k in zip(powers, inside, strict=True))
        found[inside] = found.get(inside, free * 0) + context.from_dict({outside: number})
    above = Ratio(value.num, {text: each for text, each in value.den.items() if text not in below})
    return [
        (_over(coefficient, above), _over(context.from_dict({inside: 1}), Ratio(value.num, below)))
        for inside, coefficient in found.items()
    ]


def power_sum(k: int, x: str) -> Term:
    """1^k + 2^k + ... + x^k."""
    ring = Ring({x})
    one, n = ring.number(1), ring.generator[x]
    sums: list[Poly] = []
    for j in range(k + 1):  # (x + 1)^(j + 1) - 1 is the sum of C(j + 1, i) times the sums of i-th powers
        rest = sum((poly * comb(j + 1, i) for i, poly in enumerate(sums)), start=ring.number(0))
        sums.append(((n + one) ** (j + 1) - one - rest) / (j + 1))
    return term_of(sums[k])


def _factors(body: Term, x: str) -> tuple[Ring, Poly, list[tuple[Poly, int]]]:
    """A product in the ring of its letters and x: the ring, the number in it, and its factors with their exponents."""
    ring = Ring(with_arguments({*variables(body), x}))
    value = ring.ratio(body)
    unit, factors = value.num.factor()
    below = [(poly, -e) for poly, e in value.den.values()]
    return ring, ring.number(fraction(unit)), [*((poly, int(e)) for poly, e in factors), *below]


def _depends(poly: Poly, x: str) -> bool:
    """Whether x occurs in a polynomial, or in a function that stands there as a variable."""
    return any(x in letters(table().term(name)) for name in occurring(poly))


def _power_named(name: str) -> tuple[Term, ...]:
    """Base and exponent of the power that a variable stands for, if it stands for one."""
    tree = atoms().get(name)
    return tree.terms if tree is not None and tree.tag == "pow" else ()


def _pure_power(body: Term, x: str) -> tuple[Term, Term] | None:
    """(c, u) with body = c x^u, or None."""
    _, outside, factors = _factors(body, x)
    exponents: list[Term] = []
    for poly, e in factors:
        name = str(poly)
        if name == x:
            exponents.append(e)
        elif (power := _power_named(name)) and canonical(power[0]) == canonical(x):
            exponents.append(node("*", e, power[1]))
        elif e > 0 and not _depends(poly, x):
            outside *= poly**e
        else:
            return None
    return term_of(outside), node("+", *exponents) if exponents else 0


def _shape(body: Term, x: str) -> tuple[Term, int, Term, Term, Term, Term]:
    """(c, k, u, r, p, q) with body = c x^(k+u) (p x^2 + q)^(-r); Unsupported if it has another shape."""
    ring, outside, factors = _factors(body, x)
    inside, k, base = ring.number(1), 0, None
    exponents: list[Term] = []
    r: list[Term] = []
    quadratic: list[tuple[Poly, int]] = []
    twice = {canonical(x): 1, canonical(node("^", x, 2)): 2}
    for poly, e in factors:
        name = str(poly)
        power = _power_named(name)
        if name == x:
            k += e
        elif power and (multiple := twice.get(canonical(power[0]))):
            exponents.append(node("*", multiple * e, power[1]))
        elif power and x in variables(power[0]):
            if base is not None and canonical(base) != canonical(power[0]):
                raise Unsupported("powers of two bases")
            base = power[0]
            r.append(node("*", -e, power[1]))
        elif x in occurring(poly):
            quadratic.append((poly, e))
        elif _depends(poly, x):
            raise Unsupported("a function of the variable that is no power")
        elif e > 0:
            outside *= poly**e
        else:
            inside *= poly**-e
    base_poly = ring.poly(base) if base is not None else quadratic[0][0] if quadratic else ring.number(1)
    for poly, e in quadratic:
        if (scale := proportional(poly, base_poly)) is None:
            raise Unsupported("two factors that depend on the variable")
        r.append(-e)
        outside *= rational(scale**e)
    powers = by_powers(base_poly, x)
    if not {2} <= powers.keys() <= {0, 2}:
        raise Unsupported(f"not a power of p {x}^2 + q")
    if k < 0:
        exponents, k = [*exponents, k], 0
    c = _over(outside, Ratio(outside, {"": (inside, 1)}))
    u, exponent = (node("+", *terms) if terms else 0 for terms in (exponents, r))
    return c, k, u, exponent, term_of(powers[2]), term_of(powers.get(0, ring.number(0)))


def _logarithm(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    """The logarithm of a product as the sum of those of its factors; that of an exponential."""
    (t,) = tree.terms
    if isinstance(t, Node) and t.tag == "exp":
        yield applied("log_of_exp", t.terms[0])
    if isinstance(t, Node) and t.tag == "sqrt":
        yield applied("log_of_root", t.terms[0])
    if isinstance(t, Node) and t.tag == "pow":
        yield applied("log_of_power", *t.terms)
    if table().exponentials:
        yield applied("exp_of_log", t)
    if number_of(t) == 1:
        yield applied("log_of_one")
    powers = [*_powers(t)]
    for base, exponent in powers:
        if exponent != 1:
            yield applied("log_of_power", base, exponent)
    factors = [base if exponent == 1 else node("^", base, exponent) for base, exponent in powers]
    for k in range(len(factors) - 1):
        rest = factors[k + 1 :]
        yield applied("log_of_product", factors[k], rest[0] if len(rest) == 1 else node("*", *rest))


def _powers(term: Term) -> Iterator[tuple[Term, int]]:
    """A fraction as powers of primes and of irreducible polynomials."""
    value = Ring(variables(term)).ratio(term)
    unit, factors = value.num.factor()
    number = fraction(unit)
    for p in _PRIMES:
        exponent = 0
        while number.numerator % p == 0 and number:
            number, exponent = number / p, exponent + 1
        while number.denominator % p == 0:
            number, exponent = number * p, exponent - 1
        if exponent:
            yield p, exponent
    if number != 1:
        yield number_term(number), 1
    for poly, e in factors:
        yield term_of(poly), int(e)
    for poly, e in value.den.values():
        yield term_of(poly), -e


def _known_angle(tree: Node, others: Sequence[Node]) -> Iterator[Instance]:
    """The angle of a well-known tangent, sine or cosine; sine and cosine of an angle that is under one."""
    if any(tree in subterms(turned) for turned in table().angles.values()):
        yield applied(f"circular_of_{tree.tag}", *tree.terms)
    known = (theorem(f"known_angle_{tree.tag}_{k}") for k in range(len(KNOWN[tree.tag])))
    for k, each in enumerate(known):
        assert isinstance(each.conclusion, Relation)
        if canonical(each.conclusion.terms[0].terms[0]) == canonical(tree.terms[0]):  # type: ignore[union-attr]
            yield applied(f"known_angle_{tree.tag}_{k}")


_PRIMES = (2, 3, 5, 7, 11, 13)  # factors of numbers under logarithms
_ABOUT: dict[str, Callable[[Node, Sequence[Node]], Iterator[Instance]]] = {
    "sqrt": _root,
    "pow": _power,
    "gamma": _gamma,
    "log": _logarithm,
    "arctan": _known_angle,
    "arcsin": _known_angle,
    "arccos": _known_angle,
    "mean": _mean,
    "integral": _integral,
    "diverges": _integral,
    "sum": _sum,
}


def _over(top: Poly, value: Ratio) -> Term:
    """The term of a polynomial over the denominator of a value, in lowest terms."""
    bottom = value.bottom()
    common = top.gcd(bottom)
    top, bottom = divmod(top, common)[0], divmod(bottom, common)[0]
    return term_of(top) if bottom == 1 else node("/", term_of(top), term_of(bottom))
