"""What is said before a proof begins: of sines, cosines, roots, derivatives, and of everything that is divided by."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import reduce

from symcheck.checker.algebra import exact
from symcheck.coq.assumptions import State
from symcheck.coq.printing import ATOM, name, spelled
from symcheck.coq.signs import not_zero, positive, sign
from symcheck.coq.terms import NotExported, denominators, factors, fraction, product, subterms
from symcheck.coq.values import QUARTER, number, printed_ratio, quotient, ratio, turns, value
from symcheck.core.calculus import derivative, differentiated, letters
from symcheck.core.terms import Binder, Node, Term, Value, node

OPAQUE = ("sqrt", "pow", "exp", "log", "gamma", "arctan", "arcsin", "arccos")
ARITHMETIC = ("+", "*", "-", "/", "^", "pi")


def function_terms(state: State, spoken: Iterable[Term]) -> Iterator[Node]:
    """The functions and derivatives in what is spoken of, of letters that there are here."""
    for term in subterms(*spoken):
        if isinstance(term, Node) and term.tag not in ARITHMETIC and letters(term) <= state.scope:
            yield term


def add_facts(state: State, spoken: Iterable[Term]) -> None:
    """Equations that are true of sines, cosines and roots of numbers by themselves."""
    angles: dict[str, Term] = {}
    for term in function_terms(state, spoken):
        match term:
            case Value(tag="sin" | "cos", terms=(angle,)):
                angles.setdefault(spelled(angle, ATOM), angle)
            case Value(tag="sqrt", terms=(inner,)) if exact(inner, roots=False):
                _add_root(state, inner)
    for angle in list(angles.values()):
        counts, rest = turns(angle)
        for x in (*(x for x, _ in counts), *([rest] if rest != 0 and counts else [])):
            angles.setdefault(spelled(x, ATOM), x)
    for shown, angle in angles.items():
        if shown not in state.settled:
            state.settled.add(shown)
            _add_angle(state, shown, angle)


def _add_angle(state: State, printed: str, angle: Term) -> None:
    """sin^2 + cos^2 = 1, values at a quarter turn; of a sum the addition theorems."""
    counts, rest = turns(angle)
    if quarter := ratio(angle, QUARTER) == 1:
        for function in ("cos", "sin"):
            state.hint(f"(eq_trans (f_equal {function} (ltac:(field) : {printed} = PI / 2)) {function}_PI2)")
    if quarter or isinstance(angle, str) or (rest != 0 and not counts):
        state.hint(f"(circle {printed})")
        return
    parts: list[Term] = [x if n > 0 else node("-", x) for x, n in counts for _ in range(abs(n))]
    parts += [rest] if rest != 0 else []
    total = spelled(node("+", *parts) if parts else 0)
    cosine, sine = reduce(addition, map(circular, parts)) if parts else (1, 0)
    for function, sum_ in (("cos", cosine), ("sin", sine)):
        by = f"replace {printed} with ({total}) by field; turn"
        _add_equation(state, node(function, angle), sum_, by)


def _add_equation(state: State, left: Term, right: Term, by: str) -> None:
    """Proves an equation, and gives it to `ring` and `field`."""
    state.hints.append(state.prove_aside(node("=", left, right), "e", by))


def _add_root(state: State, inner: Term) -> None:
    """The square of the root of a prime number, or the root of another number by those."""
    shown, root = spelled(inner, ATOM), node("sqrt", inner)
    if f"sqrt {shown}" in state.settled:
        return
    state.settled.add(f"sqrt {shown}")
    if isinstance(inner, int) and inner > 1 and all(inner % p for p in range(2, inner)):
        state.hint(f"(root_of_number {shown} ltac:(lra))")
        return
    known = number(value(inner))
    assert known is not None
    outer, primes = square_part(known)
    for p in primes:
        _add_root(state, p)
    simplified = node("*", quotient(outer), *(node("sqrt", p) for p in primes))
    sides = "lra | repeat apply mul_nn; try apply sqrt_pos; lra | field"
    by = f"apply (root_is (t := {shown}) (v := {spelled(simplified)})); [ {sides}{state.hinted} ]"
    name = state.prove_aside(node("=", root, simplified), "e", by)
    if outer.denominator > 1:  # `ring` takes polynomials alone as hints
        state.emit(f"rewrite {name} in *.")
        state.rewritten[root] = simplified
    else:
        state.hints.append(name)


def show_divisors(state: State, spoken: Iterable[Term]) -> None:
    """That no denominator is zero: by a premise, by a hypothesis, by a number or by a sign."""
    for divisor in denominators(*spoken):
        here = not isinstance(divisor, int) and letters(divisor) <= state.scope
        if here and spelled(divisor) not in state.nonzero:
            show_nonzero(state, divisor)


def prove_nonzero(state: State, term: Term, by: str) -> str:
    """Proves that a term is not zero, and keeps that."""
    name = state.prove_aside(node("!=", term, 0), "n", by)
    keep_nonzero(state, term, name)
    return name


def keep_nonzero(state: State, term: Term, name: str) -> None:
    """A denominator that is not zero; and if it is a sum of fractions, its numerator, which `field` asks for."""
    state.nonzero[spelled(term)] = (name, term)
    several = list(factors(term))
    top, below = fraction(term)
    parts = [
        (part, f"nz_of ({spelled(product([*several[:k], *several[k + 1 :]]))}) {name}); {state.algebra}")
        for k, part in enumerate(several if len(several) > 1 else ())
    ]
    if below:
        parts.append((top, f"nz_over (b := {spelled(product(below))}) {name}); [ nonzero | {state.algebra} ]"))
    for part, by in parts:
        if not isinstance(part, int) and spelled(part) not in state.nonzero:
            own = state.prove_aside(node("!=", part, 0), "n", f"apply ({by}")
            state.nonzero[spelled(part)] = (own, part)


def show_nonzero(state: State, term: Term) -> str | None:
    """A proof that a term is not zero, if one is found."""
    known = [(known.difference, known.apart) for known in state.facts("!=", ">")]
    known += [(other, fact) for fact, other in state.nonzero.values()]
    for other, fact in known:
        if (k := ratio(other, term)) is not None:
            return prove_nonzero(state, term, f"apply (nz_of {printed_ratio(k)} {fact}); {state.algebra}")
    for signed, lemma in ((term, "pos_nz"), (node("-", term), "neg_nz")):
        if proof := positive(state, signed):
            return prove_nonzero(state, term, f"exact ({lemma} {proof})")
    if exact(term) and (square := number(value(node("^", term, 2)))):
        by = f"intro Z; assert (S : ({spelled(term)}) ^ 2 = 0) by (rewrite Z; ring); "
        by += f"assert (T : ({spelled(term)}) ^ 2 = {printed_ratio(square)}) by ({state.algebra}); lra"
        return prove_nonzero(state, term, by)
    return None


def work_out_derivatives(state: State, spoken: Iterable[Term]) -> None:
    """Replaces all derivatives by what they are."""
    slopes = dict.fromkeys(t for t in function_terms(state, spoken) if isinstance(t, Binder) and t.tag == "diff")
    rates: dict[Node, Term] = {slope: state.full(differentiated(slope)) for slope in slopes}
    add_facts(state, rates.values())
    if rates:
        show_divisors(state, [*spoken, *rates.values()])
    for slope in slopes:
        _work_out(state, slope, rates[slope])
    state.rewritten |= rates


def _work_out(state: State, slope: Binder, rate: Term) -> None:
    x, order, place = slope.letter, *slope.outside
    kept, state.divides = state.divides, True
    _show_bases(state, slope.body)
    by = f"apply is_derive_unique; unfold Rpower; auto_derive; [ conditions | powers; {state.algebra} ]"
    if order == 2 and place == x:
        first = state.full(derivative(slope.body, x))
        functions = " ".join(f"(fun {name(x)} => {spelled(t)})" for t in (_nearby(state, slope.body, x), first))
        at, above = state.anew("x"), state.anew("s")
        near = f"intros {at} {above}; cbv beta in {above}; pose proof (pos_nz {above}); {by}"
        by = f"apply (derive_twice {functions}); [ auto_derive; conditions | conditions | {near} | {by} ]"
    elif order != 1:
        raise NotExported("a derivative of third order")
    state.emit(f"rewrite {state.prove_aside(node('=', slope, rate), 'd', by)} in *.")
    state.divides = kept


def _nearby(state: State, body: Term, x: str) -> Term:
    """What is positive at the letter and makes the function differentiable: the letter, or the base of a power."""
    if any(known.sides == (x, 0) for known in state.facts(">")):
        return x
    return next((base for base in arguments(body, "pow") if x in letters(base)), 1)


def _show_bases(state: State, term: Term) -> None:
    """The bases of powers are positive: said once, as `auto_derive` asks for it."""
    for base in arguments(term, "pow", "log", "sqrt"):
        found = sign(state, base)
        found = not_zero(state, base, found) if found else None
        if found and found.level == 2 and spelled(base) not in state.settled:
            state.settled.add(spelled(base))
            state.prove_aside(node("<", 0, base), "s", f"exact {found.proof}")


def equate_functions(state: State, spoken: Iterable[Term]) -> None:
    """Functions of equal arguments that are written differently."""
    for term in function_terms(state, spoken):
        match term:
            case Value(tag="pow", terms=(_, exponent)) if (whole := ratio(exponent, 1)) and whole.denominator == 1:
                raise NotExported("a power whose exponent adds up to a whole number")
            case Value(tag="sqrt", terms=(inner,)) if exact(inner, roots=False):
                continue
        if term.tag not in ("call", *OPAQUE):
            continue
        first = state.functions.setdefault(value(term), term)
        if spelled(first) != spelled(term) and spelled(term) not in state.settled:
            state.settled.add(spelled(term))
            _add_equation(state, term, first, f"f_equal; {state.algebra}")


def arguments(term: Term, *functions: str) -> list[Term]:
    """What stands (first) in these functions."""
    return [t.terms[0] for t in subterms(term) if isinstance(t, Value) and t.tag in functions]


def square_part(value: Fraction) -> tuple[Fraction, list[int]]:
    """The root of a positive number: a rational number, and the primes under the roots."""
    primes: list[int] = []
    whole, outer, p = value.numerator * value.denominator, 1, 2
    while whole > 1:
        while whole % (p * p) == 0:
            whole, outer = whole // (p * p), outer * p
        if whole % p == 0:
            whole, primes = whole // p, [*primes, p]
        p += 1
    return Fraction(outer, value.denominator), primes


def circular(angle: Term) -> tuple[Term, Term]:
    """Cosine and sine of an angle, or of its negative."""
    if isinstance(angle, Value) and angle.tag == "-":
        return node("cos", *angle.terms), node("-", node("sin", *angle.terms))
    return node("cos", angle), node("sin", angle)


def addition(one: tuple[Term, Term], other: tuple[Term, Term]) -> tuple[Term, Term]:
    """Cosine and sine of a sum of two angles."""
    (c, s), (d, t) = one, other
    minus = node("-", node("*", s, t))
    return node("+", node("*", c, d), minus), node("+", node("*", s, d), node("*", c, t))
