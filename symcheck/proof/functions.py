"""Functions that are no polynomials: roots, powers, logarithms, gamma functions, means and integrals.

Each stands in the ring as one variable, an *atom* (`polynomial.atom`). What is known of it is said by the theorems the
checker knows (`symcheck/theorems.py`): here they are found for the atoms of a statement, and their premises are proved.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from math import comb, prod
from typing import Any

from symcheck.proof.equations import identity_here
from symcheck.proof.knowledge import Knowledge, proportional, ring_of, starting
from symcheck.proof.orders import positive_form, prove_order, term_of
from symcheck.proof.polynomial import (
    ATOMS,
    BINDING,
    Instance,
    Poly,
    Ratio,
    Ring,
    Unsupported,
    canonical,
    flatten,
    fraction,
    frozen,
    number_of,
    rational,
    square_free,
    theorem_of,
    unfold,
    variables,
    with_arguments,
)
from symcheck.statement import Certificate, Formula, Problem, Term
from symcheck.theorems import Terms, Unknown

Prover = Callable[[Formula, Knowledge], Certificate | None]
MAX_INSTANCES = 40
MAX_CASES = 4
HALF_LINE = (0, "infinity")
WHOLE_LINE = (("-", "infinity"), "infinity")


def values_of(term: Term, numbers: Mapping[str, Term]) -> Iterator[Term]:
    """What a function may be where letters have these numbers; each is still to be proved."""
    assert isinstance(term, tuple)
    if term[0] == "diverges":
        yield from (0, 1)
        return
    plain = unfold(term, numbers)
    name = next(iter(variables(plain)))
    known = _all_known(Problem("value", ("=", plain, 0)))
    value = known.ideal().reduce(known.ring.generator[name])
    used = {n for n, degree in zip(known.ring.names, value.degrees(), strict=True) if degree} if value != 0 else set()
    if all(n == "pi" or n[:5] == "sqrt_" for n in used):
        yield restored(term_of(value))


def has_functions(ring: Ring) -> bool:
    """Whether atoms are among the variables."""
    return any(name in ATOMS for name in ring.names)


def prove_with_theorems(problem: Problem, prove_here: Prover) -> Certificate | None:
    """A proof of a statement about functions: by theorems as far as their premises can be proved."""
    known, pending = _plan(problem)
    return _prove(problem.claim, known, pending, prove_here, MAX_CASES)


def _plan(problem: Problem) -> tuple[Knowledge, list[Instance]]:
    """What is known at the start, and the theorems about the functions there are."""
    definitions = dict(problem.definitions)
    numbers = dict(_numbers(problem))
    names, seen, pending = set(ring_of(problem).names), set[str](), list[Instance]()
    while (fresh := sorted(name for name in names - seen if name in ATOMS)) and len(pending) < MAX_INSTANCES:
        seen |= set(fresh)
        bound = {ATOMS[name][2] for name in seen if ATOMS[name][0] in BINDING}
        for instance in (i for name in fresh for i in (*_equal(name, numbers), *_instances(name, names))):
            about = variables(("", *instance[1:])) if instance[0] not in _OF_BOUND else set()
            if instance not in pending and not about & bound:  # of a bound variable nothing may be assumed
                pending.append(instance)
                theorem = theorem_of(instance, definitions)
                for formula in (*theorem.premises, theorem.conclusion):
                    names |= variables(unfold(formula, definitions))
    return starting(problem, Ring(names, definitions)), pending


def _all_known(problem: Problem) -> Knowledge:
    """What all theorems say whose premises hold."""
    known, pending = _plan(problem)
    for instance in pending:
        theorem = theorem_of(instance, known.ring.definitions)
        if _premises(theorem.premises, known, lambda goal, known: None) is not None:
            known = known.assume(theorem.conclusion)
    return known


def _prove(
    goal: Formula, known: Knowledge, pending: Sequence[Instance], prove_here: Prover, cases: int
) -> Certificate | None:
    """Assumptions first, then every theorem whose premises hold, then the goal itself, then a case more."""
    if goal[0] == "=>":
        inner = _prove(goal[2], known.assume(goal[1]), pending, prove_here, cases)
        return None if inner is None else {"rule": "implies", "then": inner}
    if goal[0] == "<=>":
        ways = [("=>", goal[1], goal[2]), ("=>", goal[2], goal[1])]
        parts = [_prove(way, known, pending, prove_here, cases) for way in ways]
        return None if None in parts else {"rule": "each", "parts": parts}
    for k, instance in enumerate(pending):
        theorem = theorem_of(instance, known.ring.definitions)
        premises = _premises(theorem.premises, known, prove_here)
        if premises is not None:
            rest = [*pending[:k], *pending[k + 1 :]]
            then = _prove(goal, known.assume(theorem.conclusion), rest, prove_here, cases)
            step = {"rule": "theorem", "of": instance, "premises": premises, "then": then}
            return None if then is None else step
    return prove_here(goal, known) or _by_cases(goal, known, pending, prove_here, cases)


def _premises(formulas: Sequence[Formula], known: Knowledge, prove_here: Prover) -> list[Certificate] | None:
    proofs = []
    for formula in formulas:
        proof = _premise(formula, known, prove_here)
        if proof is None:
            return None
        proofs.append(proof)
    return proofs


def _premise(formula: Formula, known: Knowledge, prove_here: Prover) -> Certificate | None:
    kind = formula[0]
    if kind == "=":
        return identity_here(formula, known)
    if kind == "=>":
        inner = _premise(formula[2], known.assume(formula[1]), prove_here)
        return None if inner is None else {"rule": "implies", "then": inner}
    if kind == "or":
        for index, part in enumerate(formula[1:]):
            if (inner := _premise(part, known, prove_here)) is not None:
                return {"rule": "choose", "index": index, "then": inner}
        return None
    if kind == "!=":
        return prove_here(formula, known)
    return prove_order(formula, known, [])


def _by_cases(
    goal: Formula, known: Knowledge, pending: Sequence[Instance], prove_here: Prover, cases: int
) -> Certificate | None:
    """What a theorem about an integral asks for holds, or it does not."""
    for instance in pending if cases else ():
        if instance[0] != "beta":
            continue
        for premise in theorem_of(instance, known.ring.definitions).premises:
            if premise[0] != ">" or _premise(premise, known, prove_here) is not None:
                continue
            t = _deciding(known.ring.ratio(premise[1]), known)
            proofs, ref = [], ["here", known.count]
            for case in ((">", t, 0), ("<=", t, 0)):
                below = replace(known, count=known.count + 1).assume(case)  # the alternative has a number of its own
                if (inner := _prove(goal, below, pending, prove_here, cases - 1)) is None:
                    return None
                proofs.append(inner)
            split = {"rule": "cases_or", "or": ref, "cases": proofs}
            return {"rule": "theorem", "of": ["dichotomy", t], "premises": [], "then": split}
    return None


def _deciding(value: Ratio, known: Knowledge) -> Term:
    """The factors of a fraction whose signs are not known, as a term that has its sign."""
    unit, factors = value.num.factor()
    sign = 1 if fraction(unit) > 0 else -1
    rest = known.ring.number(1)
    for poly, exponent in factors:
        if positive_form(poly, known) is None and exponent % 2:
            rest *= poly
    return term_of(rest * sign)


# which theorems speak of an atom


def _numbers(problem: Problem) -> Iterator[tuple[str, Term]]:
    """The letters that a hypothesis, or what the claim assumes, gives numbers to."""
    formulas = [part for _, fs in problem.hypotheses for f in fs for part in flatten(f)]
    formulas += flatten(problem.claim[1]) if problem.claim[0] == "=>" else []
    for formula in formulas:
        named = formula[0] == "=" and isinstance(formula[1], str) and formula[1] not in dict(problem.definitions)
        if named and (value := number_of(formula[2])) is not None:
            yield formula[1], _number(value)


def _equal(name: str, numbers: Mapping[str, Term]) -> Iterator[Instance]:
    """A function at arguments in which letters have their numbers."""
    kind, *arguments = ATOMS[name]
    if kind not in BINDING and set(numbers) & set().union(*map(variables, arguments)):
        yield "congruence", kind, tuple(arguments), tuple(unfold(term, numbers) for term in arguments)


def _instances(name: str, names: set[str]) -> Iterator[Instance]:
    """The theorems about an atom, and about it together with other atoms."""
    kind, *arguments = ATOMS[name]
    others = [ATOMS[other] for other in sorted(names) if other in ATOMS and other != name]
    try:
        if kind in _ABOUT:
            yield from _ABOUT[kind](arguments, [rest for k, *rest in others if k == kind])
    except (Unsupported, Unknown):
        return


def _root(arguments: list[Any], others: list[list[Any]]) -> Iterator[Instance]:
    yield "root", arguments[0]
    radicands = [t for (t,) in (arguments, *others)]
    for s, t in combinations(radicands, 2):
        if any(canonical(("*", s, t)) == canonical(r) for r in radicands):
            yield "root_of_product", s, t


def _power(arguments: list[Any], others: list[list[Any]]) -> Iterator[Instance]:
    base, exponent = arguments
    yield "power", base, exponent
    if number_of(base) == 1:
        yield "power_of_power", 1, 1, exponent
    elif (half := _square_root(base)) is not None:
        doubled = number_of(("*", 2, exponent))
        if doubled is not None and doubled.denominator == 1:
            yield "power_of_power", half, 2, exponent
    for other, more in others:
        if canonical(other) == canonical(base):
            gap, whole = (number_of(("+", exponent, (sign, more))) for sign in "-+")
            if gap is not None and gap.denominator == 1:
                yield "power_of_sum", base, more, int(gap)
            if whole is not None and whole.denominator == 1:
                yield "power_of_sum", base, exponent, more


def _square_root(term: Term) -> Term | None:
    """A term whose square is the polynomial, or None."""
    value = Ring(variables(term)).ratio(term)
    unit, factors = value.num.factor() if value.num != 0 and not value.den else (-1, [])
    number = fraction(unit) if factors or value.num == 1 else Fraction(-1)
    outside, primes = square_free(number) if number > 0 else (number, (1,))
    if primes or any(exponent % 2 for _, exponent in factors):
        return None
    bases = (poly ** (exponent // 2) for poly, exponent in factors)
    return restored(term_of(prod(bases, start=value.num**0 * rational(outside))))


def _gamma(arguments: list[Any], others: list[list[Any]]) -> Iterator[Instance]:
    (t,) = arguments
    number = number_of(t)
    if number is not None and number > 1:
        yield "gamma", _number(number - 1)
    elif number in (1, Fraction(1, 2)):
        yield ("gamma_values",)
    for (other,) in others:
        if number is None and number_of(("+", other, ("-", t))) == 1:
            yield "gamma", t
        if number is None and number_of(("+", t, ("-", other))) == 1:
            yield "gamma", other


def _mean(arguments: list[Any], others: list[list[Any]]) -> Iterator[Instance]:
    """The constant Fourier coefficient, and the integral of the rest."""
    body, x = arguments
    ring = Ring({*variables(body), f"sin_{x}", f"cos_{x}"})
    value = ring.ratio(body)
    s, c = (ring.names.index(f"{function}_{x}") for function in ("sin", "cos"))
    mean, primitive = ring.number(0), ring.number(0)
    for exponents, coefficient in value.num.terms():
        i, j = int(exponents[c]), int(exponents[s])
        others_ = tuple(0 if k in (s, c) else int(e) for k, e in enumerate(exponents))
        outside = ring.context.from_dict({others_: coefficient})
        for k, (real, imaginary) in _harmonics(i, j).items():
            if k == 0:
                mean += outside * rational(real)
            elif k > 0:  # 2 Re (a + i b) e^(ikx) = d/dx of 2 (b cos kx + a sin kx) / k
                cosine, sine = ring.turn({x: k})
                primitive += outside * (cosine * rational(2 * imaginary / k) + sine * rational(2 * real / k))
    yield "mean", body, x, _over(mean, value), _over(primitive, value)


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


def _integral(arguments: list[Any], others: list[list[Any]]) -> Iterator[Instance]:
    body, x, *ends = arguments
    if tuple(ends) == WHOLE_LINE:
        mirrored = canonical(frozen(Terms({}).replaced(body, {x: ("-", x)})))
        if mirrored == canonical(body):
            yield "even", body, x
        if mirrored == canonical(("-", body)):
            yield "odd", body, x
    if tuple(ends) in (HALF_LINE, WHOLE_LINE):
        shape = _shape(body, x)
        yield "beta", body, x, *shape
        yield "beta_diverges", body, x, *shape


def _shape(body: Term, x: str) -> tuple[Any, ...]:
    """(c, k, u, r, p, q) with body = c x^(k+u) (p x^2 + q)^(-r); Unsupported if it has another shape."""
    ring = Ring(with_arguments({*variables(body), x}))
    value = ring.ratio(body)
    unit, factors = value.num.factor()
    parts = [*((poly, int(e)) for poly, e in factors), *((poly, -e) for poly, e in value.den.values())]
    outside, inside = ring.number(fraction(unit)), ring.number(1)
    power, exponents, base, r = 0, list[Term](), None, list[Term]()
    quadratic: list[tuple[Poly, int]] = []
    for poly, e in parts:
        name = str(poly)
        if name == x:
            power += e
        elif name in ATOMS and ATOMS[name][0] == "pow" and canonical(ATOMS[name][1]) == canonical(x):
            exponents.append(("*", e, ATOMS[name][2]))
        elif name in ATOMS and ATOMS[name][0] == "pow" and x in variables(ATOMS[name][1]):
            if base is not None and canonical(base) != canonical(ATOMS[name][1]):
                raise Unsupported("powers of two bases")
            base = ATOMS[name][1]
            r.append(("*", -e, ATOMS[name][2]))
        elif poly.degrees()[ring.names.index(x)]:
            quadratic.append((poly, e))
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
    p, zero, q = (_coefficient(ring, base_poly, x, k) for k in (2, 1, 0))
    if zero != 0 or base_poly.degrees()[ring.names.index(x)] != 2:
        raise Unsupported(f"not a power of p {x}^2 + q")
    if power < 0:
        exponents, power = [*exponents, power], 0
    c = _over(outside, Ratio(outside, {"": (inside, 1)}))
    u, exponent = (("+", *terms) if terms else 0 for terms in (exponents, r))
    return c, power, u, exponent, restored(term_of(p)), restored(term_of(q))


def _coefficient(ring: Ring, poly: Poly, x: str, k: int) -> Poly:
    where = ring.names.index(x)
    terms = {
        tuple(0 if n == where else int(e) for n, e in enumerate(exponents)): coefficient
        for exponents, coefficient in poly.terms()
        if exponents[where] == k
    }
    return ring.context.from_dict(terms)


_OF_BOUND = ("mean", "beta", "beta_diverges", "even", "odd")
_ABOUT: dict[str, Callable[[list[Any], list[list[Any]]], Iterator[Instance]]] = {
    "sqrt": _root,
    "pow": _power,
    "gamma": _gamma,
    "mean": _mean,
    "integral": _integral,
    "diverges": _integral,
}


def _over(top: Poly, value: Ratio) -> Term:
    """The term of a polynomial over the denominator of a value."""
    bottoms = [restored(term_of(poly)) for poly, exponent in value.den.values() for _ in range(exponent) if poly != 1]
    return ("/", restored(term_of(top)), ("*", 1, *bottoms)) if bottoms else restored(term_of(top))


def restored(term: Term) -> Term:
    """The term with the functions themselves in the place of their atoms."""
    if isinstance(term, tuple):
        return tuple(restored(part) for part in term)
    if isinstance(term, str) and term[:4] in ("sin_", "cos_"):
        return (term[:3], term[4:])
    return restored(ATOMS[term]) if isinstance(term, str) and term in ATOMS else term


def number_term(poly: Poly) -> Term:
    """A constant polynomial as a term."""
    return _number(fraction(poly.leading_coefficient()) if poly != 0 else Fraction(0))


def _number(value: Fraction) -> Term:
    return value.numerator if value.denominator == 1 else ("/", value.numerator, value.denominator)
