"""What is said before a proof begins: of sines, cosines, roots, derivatives, and of everything that is divided by."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import reduce

from symcheck.checker.algebra import exact
from symcheck.coq.printing import ATOM, name, spelled
from symcheck.coq.signs import Sign, Signs
from symcheck.coq.terms import NotExported, denominators, factors, fraction, product, subterms
from symcheck.coq.values import number, quotient, ratio, shown_ratio, turns, value
from symcheck.core.calculus import differentiated, letters
from symcheck.core.terms import Binder, Call, Node, Term, Value, node

OPAQUE = ("sqrt", "pow", "exp", "log", "gamma", "arctan", "arcsin", "arccos")
ARITHMETIC = ("+", "*", "-", "/", "^", "pi")
QUARTER = node("/", node("pi"), 2)


class Functions(Signs):
    """Facts about functions and denominators."""

    def applied(self, spoken: Iterable[Term]) -> Iterator[Node]:
        """The functions and derivatives in what is spoken of, of letters that there are here."""
        for term in subterms(*spoken):
            if isinstance(term, Node) and term.tag not in ARITHMETIC and letters(term) <= self.scope:
                yield term

    def functions(self, spoken: Iterable[Term]) -> None:
        """What is true of sines, cosines and roots of numbers by themselves."""
        angles: dict[str, Term] = {}
        for term in self.applied(spoken):
            match term:
                case Value(tag="sin" | "cos", terms=(angle,)):
                    angles.setdefault(spelled(angle, ATOM), angle)
                case Value(tag="sqrt", terms=(inner,)) if exact(inner, roots=False):
                    self.root(inner)
        for angle in list(angles.values()):
            counts, rest = turns(angle)
            for x in (*(x for x, _ in counts), *([rest] if rest != 0 and counts else [])):
                angles.setdefault(spelled(x, ATOM), x)
        for shown, angle in angles.items():
            if shown in self.settled:
                continue
            self.settled.add(shown)
            counts, rest = turns(angle)
            if isinstance(angle, str) or (rest != 0 and not counts):
                self.hint(f"(circle {shown})")
                for function in ("cos", "sin") if ratio(angle, QUARTER) == 1 else ():
                    self.hint(f"(eq_trans (f_equal {function} (ltac:(field) : {shown} = PI / 2)) {function}_PI2)")
            elif counts or rest == 0:
                self.turned(shown, counts, rest)

    def turned(self, shown: str, counts: list[tuple[str, int]], rest: Term) -> None:
        """The addition theorems for an angle."""
        parts: list[Term] = [x if n > 0 else node("-", x) for x, n in counts for _ in range(abs(n))]
        parts += [rest] if rest != 0 else []
        total = spelled(node("+", *parts) if parts else 0)
        cosine, sine = reduce(addition, map(circular, parts)) if parts else (1, 0)
        for function, found in (("cos", cosine), ("sin", sine)):
            own = self.anew("e")
            by = f"replace {shown} with ({total}) by field; turn"
            self.emit(f"assert ({own} : {function} {shown} = {spelled(found)}) by ({by}).")
            self.hints.append(own)

    def root(self, inner: Term) -> None:
        """The square of the root of a prime number, or the root of another number by those."""
        shown = spelled(inner, ATOM)
        if f"sqrt {shown}" in self.settled:
            return
        self.settled.add(f"sqrt {shown}")
        if isinstance(inner, int) and inner > 1 and all(inner % p for p in range(2, inner)):
            self.hint(f"(root_of_number {shown} ltac:(lra))")
            return
        known = number(value(inner))
        assert known is not None
        outer, primes = square_part(known)
        for p in primes:
            self.root(p)
        found = node("*", quotient(outer), *(node("sqrt", p) for p in primes))
        sides = "lra | repeat apply mul_nn; try apply sqrt_pos; lra | field"
        by = f"apply (root_is (t := {shown}) (v := {spelled(found)})); [ {sides}{self.hinted} ]"
        own = self.prove_aside(node("=", node("sqrt", inner), found), "e", by)
        if outer.denominator > 1:  # `ring` takes polynomials alone as hints
            self.emit(f"rewrite {own} in *.")
            self.rewritten[node("sqrt", inner)] = found
            return
        self.hints.append(own)

    def divisors(self, spoken: Iterable[Term]) -> None:
        """That no denominator is zero: by a premise, by a hypothesis, by a number or by a sign."""
        for divisor in denominators(*spoken):
            known = isinstance(divisor, int) or not letters(divisor) <= self.scope
            if not known and spelled(divisor) not in self.nonzero:
                self.divisor(divisor)

    def apart(self, term: Term, by: str) -> str:
        """Proves that a term is not zero, and keeps that."""
        own = self.prove_aside(node("!=", term, 0), "n", by)
        self.keep(term, own)
        return own

    def keep(self, term: Term, own: str) -> None:
        """A denominator that is not zero; and if it is a sum of fractions, its numerator, which `field` asks for."""
        self.nonzero[spelled(term)] = (own, term)
        several = list(factors(term))
        top, below = fraction(term)
        parts = [
            (each, f"nz_of ({spelled(product([*several[:k], *several[k + 1 :]]))}) {own}); {self.algebra}")
            for k, each in enumerate(several if len(several) > 1 else ())
        ]
        if below:
            parts.append((top, f"nz_over (b := {spelled(product(below))}) {own}); [ nonzero | {self.algebra} ]"))
        for part, by in parts:
            if not isinstance(part, int) and spelled(part) not in self.nonzero:
                shown = self.prove_aside(node("!=", part, 0), "n", f"apply ({by}")
                self.nonzero[spelled(part)] = (shown, part)

    def divisor(self, term: Term) -> str | None:
        """A proof that a term is not zero, if one is found."""
        known = [(known.difference, known.apart) for known in self.facts("!=", ">")]
        known += [(other, own) for own, other in self.nonzero.values()]
        for other, own in known:
            if (k := ratio(other, term)) is not None:
                return self.apart(term, f"apply (nz_of {shown_ratio(k)} {own}); {self.algebra}")
        for signed, lemma in ((term, "pos_nz"), (node("-", term), "neg_nz")):
            if proof := self.positive(signed):
                return self.apart(term, f"exact ({lemma} {proof})")
        if exact(term) and (square := number(value(node("^", term, 2)))):
            by = f"intro Z; assert (S : ({spelled(term)}) ^ 2 = 0) by (rewrite Z; ring); "
            by += f"assert (T : ({spelled(term)}) ^ 2 = {shown_ratio(square)}) by ({self.algebra}); lra"
            return self.apart(term, by)
        return None

    def slopes(self, spoken: Iterable[Term]) -> None:
        """All derivatives, worked out."""
        found = dict.fromkeys(t for t in self.applied(spoken) if isinstance(t, Binder) and t.tag == "diff")
        worked: dict[Node, Term] = {slope: self.full(differentiated(slope)) for slope in found}
        self.functions(worked.values())
        if worked:
            self.divisors([*spoken, *worked.values()])
        for slope in found:
            self.slope(slope, worked[slope])
        self.rewritten |= worked

    def slope(self, slope: Binder, term: Term) -> None:
        """A derivative, worked out."""
        x, order, place = slope.letter, *slope.outside
        kept, self.divides = self.divides, True
        self.bases(slope.body)
        by = f"apply is_derive_unique; unfold Rpower; auto_derive; [ conditions | powers; {self.algebra} ]"
        if order == 2 and place == x:
            first = self.full(differentiated(node("diff", slope.body, x, 1, x)))  # type: ignore[arg-type]
            functions = " ".join(f"(fun {name(x)} => {spelled(t)})" for t in (self.nearby(slope.body, x), first))
            at, positive = self.anew("x"), self.anew("s")
            near = f"intros {at} {positive}; cbv beta in {positive}; pose proof (pos_nz {positive}); {by}"
            by = f"apply (derive_twice {functions}); [ auto_derive; conditions | conditions | {near} | {by} ]"
        elif order != 1:
            raise NotExported("a derivative of third order")
        self.emit(f"rewrite {self.prove_aside(node('=', slope, term), 'd', by)} in *.")
        self.divides = kept

    def nearby(self, body: Term, x: str) -> Term:
        """What is positive at the letter and makes the function differentiable: the letter, or the base of a power."""
        if any(known.sides == (x, 0) for known in self.facts(">")):
            return x
        return next((base for base in arguments(body, "pow") if x in letters(base)), 1)

    def bases(self, term: Term) -> None:
        """The bases of powers are positive: said once, as `auto_derive` asks for it."""
        for base in arguments(term, "pow", "log", "sqrt"):
            found = self.sign(base)
            if found is not None and found.level == 1 and spelled(base) in self.nonzero:
                found = Sign(2, f"(nz_pos {found.proof} {self.nonzero[spelled(base)][0]})")
            if found is not None and found.level == 2 and spelled(base) not in self.settled:
                self.settled.add(spelled(base))
                self.prove_aside(node("<", 0, base), "s", f"exact {found.proof}")

    def same_functions(self, spoken: Iterable[Term]) -> None:
        """Functions of equal arguments that are written differently."""
        for term in self.applied(spoken):
            match term:
                case Value(tag="pow", terms=(_, exponent)) if (whole := ratio(exponent, 1)) and whole.denominator == 1:
                    raise NotExported("a power whose exponent adds up to a whole number")
                case Value(tag="sqrt", terms=(inner,)) if exact(inner, roots=False):
                    continue
                case Value(tag=tag) if tag in OPAQUE:
                    pass
                case Call():
                    pass
                case _:
                    continue
            first = self.seen.setdefault(value(term), term)
            if spelled(first) != spelled(term) and spelled(term) not in self.settled:
                self.settled.add(spelled(term))
                by = f"f_equal; {self.algebra}"
                self.hints.append(self.prove_aside(node("=", term, first), "e", by))


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
