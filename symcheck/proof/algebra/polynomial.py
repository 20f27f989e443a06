"""Terms as exact fractions of polynomials over a ring made for one problem (python-flint, degrevlex order).

Sines, cosines, roots of primes and other functions are further variables (`variables.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from fractions import Fraction
from math import comb, prod
from operator import is_
from typing import Any

from symcheck.core.calculus import Unknown, differentiated, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Call, End, Formula, Node, T, Term, Value, mapped, node
from symcheck.core.words import term as in_words
from symcheck.proof.algebra.flint import Poly, Rational, context, fraction, occurring, rational
from symcheck.proof.algebra.variables import Table, atoms, circle, cosine, one_problem, prime, sine, table
from symcheck.proof.algebra.variables import Unsupported as Unsupported

BINDING = ("integral", "diverges", "mean", "sum", "product")
FUNCTIONS = ("sqrt", "pow", "log", "exp", "gamma", "arctan", "arcsin", "arccos", *BINDING, "call")

# what is above these limits would take minutes or gigabytes; the papers stay far below
SHOWN = 80  # characters of a term in a message
MAX_POWER = 999  # exponent
MAX_LENGTH = 200_000  # terms of the power of a sum
MAX_DEGREE = 400  # of the power of a sum, and of what is reduced by equations
MAX_PRODUCTS = 20_000_000  # of terms, in one product of sums: a second or two
MAX_BITS = 12_000  # of a number: Python prints none of more than 4,300 digits
MAX_TURNS = 99  # times an angle: the cosine has as many factors
MAX_PRIME = 43  # of the roots the checker knows


def _bits(value: Rational) -> int:
    return max(int(value.p).bit_length(), int(value.q).bit_length())


def parts(tree: Node) -> tuple[Term, ...]:
    """The terms or formulas that a term or formula is made of."""
    return tree.inside + tree.outside


def subterms(*trees: Term) -> Iterator[Term]:
    """Every term, formula, letter and number inside, the trees themselves included."""
    for tree in trees:
        yield tree
        if isinstance(tree, Node):
            yield from subterms(*parts(tree))


def letters_of(problem: Problem) -> set[str]:
    """Every name in a problem, also of what is bound there and of what is defined."""
    said: list[Term] = [formula for _, formulas in problem.hypotheses for formula in formulas]
    said += [term for _, term in problem.definitions] + [term for hint in problem.hints for term in hint.terms]
    return {name for name, _ in problem.definitions} | _names_in((problem.claim, *said))


def _names_in(tree: object) -> set[str]:
    open_, found = [tree], set[str]()
    while open_:
        part = open_.pop()
        if isinstance(part, tuple):
            open_ += part
        elif isinstance(part, str):
            found.add(part)
    return found


def alone(problem: Problem) -> AbstractContextManager[Table]:
    """A table of variables for this problem alone."""
    return one_problem(letters_of(problem))


def unfold(tree: T, definitions: Mapping[str, Term], active: tuple[str, ...] = ()) -> T:
    """The term or formula with every defined name replaced by what it abbreviates, recursively.

    What a definition says of a letter that is bound where its name stands is said of the bound one.
    """
    return _unfolded(tree, definitions, active)  # type: ignore[return-value, arg-type]


def _unfolded(tree: Term, definitions: Mapping[str, Term], active: tuple[str, ...]) -> Term:
    if isinstance(tree, str):
        if tree in active:
            raise Unsupported(f"the definition of {tree} refers to itself")
        return _unfolded(definitions[tree], definitions, (*active, tree)) if tree in definitions else tree
    if not isinstance(tree, Node):
        return tree
    if not tree.bound:  # most nodes, and most of them stay as they are: this is called a quarter of a million times
        new = [part if type(part) is int else _unfolded(part, definitions, active) for part in tree.outside]
        if all(map(is_, new, tree.outside)):
            return tree
        start = len(tree) - len(new)
        return node(tree.tag, *tree[1:start], *new)
    if tree.tag == "diff" and tree.bound[0] in definitions:
        raise Unsupported(f"a derivative by {tree.bound[0]}, which is not a free variable here")
    free = {name: term for name, term in definitions.items() if name not in tree.bound}
    return mapped(tree, lambda part: _unfolded(part, definitions, active), lambda part: _unfolded(part, free, active))


def derivative(term: Term, definitions: Mapping[str, Term]) -> Term:
    """The term that a node "diff" stands for; the checker takes the same derivatives."""
    plain = unfold(term, definitions)
    assert isinstance(plain, Binder)
    try:
        return differentiated(plain)
    except Unknown as error:
        raise Unsupported(str(error)) from error


def power_of(term: Node) -> tuple[Term, int]:
    """Base and exponent of a whole power."""
    base, exponent = term.terms
    assert isinstance(exponent, int)
    return base, exponent


def constant(term: Term) -> Fraction:
    """The value of a term made of integers only."""
    if isinstance(term, int):
        return Fraction(term)
    if isinstance(term, tuple) and term[0] in ("+", "*", "-", "/", "^"):
        values = [constant(child) for child in term[1:]]
        if term[0] == "+":
            return sum(values, Fraction(0))
        if term[0] == "-":
            return -values[0]
        if term[0] == "/" and values[1]:
            return values[0] / values[1]
        if term[0] == "^" and values[0]:
            size = values[0].numerator.bit_length() + values[0].denominator.bit_length()
            if abs(values[1]) * size > MAX_BITS:
                raise Unsupported(f"the power {values[1]} of {values[0]}")
            return Fraction(values[0] ** int(values[1]))
        if term[0] == "*":
            product = Fraction(1)
            for value in values:
                product *= value
            return product
    raise Unsupported(f"{term!r} is not a rational number")


def _constant(term: Term) -> Fraction:
    """The value of a term that is a rational number, as `number_of` finds it."""
    number = number_of(term)
    if number is None:
        raise Unsupported(f"{term!r} is not a rational number")
    return number


def square_free(value: Fraction) -> tuple[Fraction, tuple[int, ...]]:
    """(r, primes) with sqrt(value) = r * product of sqrt(p) over distinct primes."""
    if value < 0:
        raise Unsupported(f"the root of the negative number {value}")
    if value == 0:
        return Fraction(0), ()
    rest, outside, primes, p = value.numerator * value.denominator, Fraction(1, value.denominator), [], 2
    while rest > 1:
        if p * p > rest:
            p = rest
        if p > MAX_PRIME:
            raise Unsupported(f"the root of {value}: it has a prime factor above {MAX_PRIME}")
        while rest % (p * p) == 0:
            rest, outside = rest // (p * p), outside * p
        if rest % p == 0:
            rest //= p
            primes.append(p)
        p += 1
    return outside, tuple(primes)


def times(left: Poly, right: Poly) -> Poly:
    """The product of two polynomials, unless it is too long to be written out."""
    if len(left) * len(right) > MAX_PRODUCTS:
        raise Unsupported(f"the product of sums of {len(left)} and {len(right)} terms")
    return left * right


Key = tuple[str, str]  # ("letter", x), ("pi", ""), or ("term", its canonical form)


def _multiples(term: Term, times: Fraction) -> Iterator[tuple[Key, Term, Fraction]]:
    """So many times a term, taken apart as the checker does it: letters, pi and other terms with their multiples."""
    match term:
        case str():
            yield ("letter", table().letter(term)), term, times
        case Value(tag="pi"):
            yield ("pi", ""), term, times
        case Value(tag="-", terms=(inner,)):
            yield from _multiples(inner, -times)
        case Value(tag="+", terms=addends):
            for part in addends:
                yield from _multiples(part, times)
        case Value(tag="*", terms=factors) if rest := [t for t in factors if _number(t) is None]:
            scale = prod((n for t in factors if (n := _number(t)) is not None), start=times)
            yield from _multiples(rest[0], scale) if len(rest) == 1 else _other(node("*", *rest), scale)
        case Value(tag="/", terms=(top, bottom)) if number := _number(bottom):
            yield from _multiples(top, times / number)
        case _:
            yield from _other(term, times)


def _number(term: Term) -> Fraction | None:
    """The value of a term made of integers only."""
    try:
        return constant(term)
    except Unsupported:
        return None


def _other(term: Term, times: Fraction) -> Iterator[tuple[Key, Term, Fraction]]:
    """So many times a term that is no letter; it and its contrary go together."""
    if (number := number_of(term)) == 0:
        return
    text, turned = canonical(term), canonical(node("-", term))
    positive = number > 0 if number is not None else text <= turned
    yield ("term", text if positive else turned), term if positive else node("-", term), times if positive else -times


def _whole_multiples(term: Term) -> Iterator[tuple[Key, Term, int]]:
    """A sum of whole multiples; what is no whole multiple is a term of its own."""
    total: dict[Key, tuple[Term, Fraction]] = {}
    for key, part, times in _multiples(term, Fraction(1)):
        total[key] = part, times + (total[key][1] if key in total else 0)
    for key, (part, times) in total.items():
        if times.denominator == 1 or (key[0] == "pi" and times.denominator == 2):
            yield (key, part, int(2 * times)) if key[0] == "pi" else (key, part, int(times))
        else:
            size = abs(times)
            multiple = node("/", node("*", size.numerator, part), size.denominator)
            yield ("part", f"{size} {key}"), multiple, 1 if times > 0 else -1


def angle(term: Term) -> dict[str, int]:
    """An integer combination of angles, {name: coefficient}, and of quarters of a turn, {"pi": count}."""
    found: dict[str, int] = {}
    for key, part, times in _whole_multiples(term):
        if times:
            name = "pi" if key[0] == "pi" else key[1] if key[0] == "letter" else table().angle(key, part)
            found[name] = times
    return found


def exponents(term: Term) -> dict[str, int]:
    """e to a term as a product of powers of variables, all positive."""
    found: dict[str, int] = {}
    for key, part, times in _whole_multiples(term):
        if key[0] == "pi" and times % 2:
            key, part, times = ("part", f"1/2 {key}"), node("/", part, 2), times
        elif key[0] == "pi":
            times //= 2
        if times:
            above, below = table().exponential(key, part)
            found[above if times > 0 else below] = abs(times)
    return found


def atom(tree: Node) -> str | None:
    """The variable that stands for a function of an unfolded term; None for roots of numbers and whole powers.

    Terms with the same arguments, as fractions of polynomials, have the same atom.
    """
    match tree:
        case Call():
            return table().atom((*tree[:3], *map(canonical, tree.terms)), tree)
        case Value(tag="pow", terms=(_, exponent)):
            if (number := number_of(exponent)) is not None and number.denominator == 1:
                return None
        case Value(tag="sqrt", terms=(radicand,)) if number_of(radicand) is not None:
            return None
    arguments = parts(tree)
    if isinstance(tree, Binder):
        variables(tree.body)  # what does not depend on its letter has its variable already
        depth = sum(isinstance(part, Node) and part.tag in BINDING for part in subterms(tree.body))
        arguments = (substituted(tree.body, {tree.letter: f"#{depth}"}), *tree.outside)  # a name no letter has
    return table().atom((tree.tag, *map(canonical, arguments)), tree)


def number_of(term: Term) -> Fraction | None:
    """The rational number a term is equal to, or None."""
    try:
        return constant(term)
    except Unsupported:
        pass
    try:
        value = Ring(variables(term)).ratio(term)
    except Unsupported:
        return None
    quotient, rest = divmod(value.num, value.bottom())
    if quotient == 0 and rest == 0:
        return Fraction(0)
    return fraction(quotient.leading_coefficient()) if rest == 0 and quotient.is_constant() else None


def canonical(term: Term) -> str:
    """A text that is the same for terms that are the same fraction of polynomials, by sin^2 + cos^2 = 1 too."""
    if isinstance(term, End):
        return term.tag
    texts = table().texts
    if term not in texts:
        texts[term] = _canonical(term)
    return texts[term]


def _canonical(term: Term) -> str:
    ring = Ring(variables(term))
    value = ring.ratio(term)
    num, den = value.num, value.bottom()
    for axiom in ring.axioms().values():
        num, den = divmod(num, axiom)[1], divmod(den, axiom)[1]
    if den == 0:
        raise Unsupported("a division by zero")
    common = num.gcd(den)
    top, bottom = divmod(num, common)[0], divmod(den, common)[0]
    scale = bottom.leading_coefficient()
    return f"{top / scale} / {bottom / scale}"


def variables(*trees: Term) -> set[str]:
    """The polynomial variables that unfolded terms or formulas need."""
    return set().union(*map(_variables, trees))


def _variables(tree: Term) -> set[str]:
    if isinstance(tree, str):
        return {table().letter(tree)}
    if not isinstance(tree, Node):
        return set()
    kind = tree.tag
    if kind == "pi":
        return {kind}
    if kind == "tan" and (inner := undone(tree)) is not None:
        return _variables(inner)
    if kind in ("sin", "cos", "tan"):
        return {of(name) for name in angle(tree[1]) if name != "pi" for of in (sine, cosine)}
    if kind == "exp":
        return {name for above in exponents(tree[1]) for name in (above, table().exponentials[above][0])}
    if kind in FUNCTIONS and (name := atom(tree)):
        return {name}
    if kind == "sqrt":
        return {table().root(p) for p in square_free(_constant(tree[1]))[1]}
    if kind == "pow":
        return _variables(tree[1])
    if isinstance(tree, Binder):  # a derivative
        own = variables(tree.body) | {tree.letter} if tree.outside[-1] == tree.letter else set[str]()
        return variables(derivative(tree, {})) | own
    return variables(*parts(tree)).union(tree.bound)


def undone(tangent: Term) -> Term | None:
    """The t of tan(arctan t), which is t: there its cosine is no denominator, for the checker neither."""
    match tangent:
        case Value(tag="tan", terms=(Value(tag="arctan", terms=(inner,)),)):
            return inner
    return None


def function_arguments(tree: Term, bodies: bool) -> Iterator[Term]:
    """The bodies of the integrals and means in an unfolded term, or the other arguments of functions outside them."""
    if not isinstance(tree, Node):
        return
    if tree.tag == "diff":
        yield from function_arguments(derivative(tree, {}), bodies)
        return
    binding = tree.tag in BINDING
    if binding and bodies:
        yield from tree.inside
    elif tree.tag in (*FUNCTIONS, "sin", "cos", "tan", "exp") and not bodies:
        yield from (part for part in tree.outside if not isinstance(part, End))
    for part in tree.outside if binding and not bodies else parts(tree):
        yield from function_arguments(part, bodies)


def with_arguments(names: Iterable[str]) -> set[str]:
    """The variables, and those that the arguments of the functions among them need."""
    found = set(names)
    found |= variables(*(part for name in found for part in beneath(name)))
    open_ = sorted(name for name in found if name in atoms())
    while open_:
        tree = atoms()[open_.pop()]
        bound = turning(tree.bound[0]) if tree.bound else set()
        inner = variables(*parts(tree)) - bound
        if bound:  # a function of bound letters is not among those of the statement, but its other letters are
            inner = {other for name in inner for other in (with_arguments({name}) if name in atoms() else {name})}
            inner = {name for name in inner - bound if not (name in atoms() and bound & with_arguments({name}))}
        open_ += sorted(name for name in inner - found if name in atoms())
        found |= inner
    return found


def beneath(name: str) -> tuple[Term, ...]:
    """What is no letter and stands under an exponential, a sine or a cosine."""
    if name in table().exponentials:
        return table().exponentials[name][1].terms
    turn = circle(name)
    return (table().angles[turn[1]],) if turn and turn[1] in table().angles else ()


def turning(x: str) -> set[str]:
    """A letter, its sine and its cosine."""
    return {x, sine(x), cosine(x)}


@dataclass(frozen=True)
class Ratio:
    """num / product of the divisors, kept apart as they occur: polynomial text -> (polynomial, exponent)."""

    num: Poly
    den: dict[str, tuple[Poly, int]] = field(default_factory=dict)

    def divisors(self) -> tuple[str, ...]:
        """The divisors as texts, each as often as it occurs."""
        return tuple(text for text, (_, exponent) in self.den.items() for _ in range(exponent))

    def bottom(self) -> Poly:
        """The product of the divisors."""
        return prod((poly**exponent for poly, exponent in self.den.values()), start=self.num**0)

    def reduced(self) -> Ratio:
        """The same without divisors that the numerator is a multiple of."""
        num, den = self.num, dict[str, tuple[Poly, int]]()
        for text, (poly, exponent) in self.den.items():
            while exponent and not (divided := divmod(num, poly))[1]:
                num, exponent = divided[0], exponent - 1
            if exponent:
                den[text] = poly, exponent
        return Ratio(num, den)


def _rank(name: str) -> tuple[int, str]:
    """Matrix entries first, letters that are mostly parameters later, roots of numbers last."""
    if prime(name) is not None:
        return 3, name
    if circle(name) is not None:
        return 1, name
    tail = name.rpartition("_")[2]
    return (0 if len(tail) == 2 and tail.isdigit() and name not in atoms() else 2), name


class Ring:
    """Polynomials with rational coefficients in the given variables, and the terms they stand for."""

    def __init__(self, names: Iterable[str], definitions: Mapping[str, Term] | None = None) -> None:
        known = set(names)
        angles = sorted(turn[1] for turn in map(circle, known) if turn is not None)
        known |= {of(x) for x in angles for of in (sine, cosine)}
        known |= {table().exponentials[name][0] for name in known if name in table().exponentials}
        self.names = tuple(sorted(known, key=_rank))
        self.definitions = dict(definitions or {})
        self.context = context(self.names)
        self.generator: dict[str, Poly] = dict(zip(self.names, self.context.gens(), strict=True))
        self.inside = False  # under an integral, where the base of a power is positive: no side condition
        self.divisors: dict[tuple[str, ...], Poly] = {}  # by numerator and the denominators inside
        self._memory: dict[Hashable, Any] = {}
        self._ratios: dict[Term, Ratio] = {}

    def remembered(self, key: Hashable, work_out: Callable[[], T], *kept: object) -> T:
        """An answer that depends on the ring and a key alone; objects whose ids are in the key are kept with it."""
        if key not in self._memory:
            self._memory[key] = work_out(), kept
        answer: T = self._memory[key][0]
        return answer

    def number(self, value: Fraction | int) -> Poly:
        """A constant polynomial."""
        return self.context.constant(rational(value))

    def move(self, poly: Poly) -> Poly:
        """A polynomial of another ring whose variables all exist here."""
        names = poly.context().names()
        position = [self.names.index(name) if name in self.generator else -1 for name in names]
        terms = {}
        for exponents, coefficient in poly.terms():
            moved = [0] * len(self.names)
            for where, exponent in zip(position, exponents, strict=True):
                if exponent:
                    moved[where] = exponent
            terms[tuple(moved)] = coefficient
        return self.context.from_dict(terms)

    def difference(self, relation: Formula) -> Poly:
        """The numerator of left - right of a relation."""
        return self.subtract(relation[1], relation[2]).num

    def subtract(self, left: Term, right: Term) -> Ratio:
        """left - right over a common denominator."""
        return self._add([self.ratio(left), self._negate(self.ratio(right))])

    def poly(self, term: Term) -> Poly:
        """A term without denominators as a polynomial."""
        ratio = self.ratio(term)
        if ratio.den:
            raise Unsupported(f"{term!r} has a denominator")
        return ratio.num

    def ratio(self, term: Term) -> Ratio:
        """The term, definitions unfolded, as numerator and denominator; Unsupported if it has none."""
        known = self._ratios.get(term)
        if known is None:
            known = self._ratios[term] = self._ratio(term)
        return known

    def _ratio(self, term: Term) -> Ratio:
        if isinstance(term, int):
            return Ratio(self.number(term))
        if isinstance(term, str):
            if term in self.definitions:
                return self.ratio(unfold(term, self.definitions))
            return Ratio(self.generator[table().letter(term)])
        kind = term[0]
        if kind == "+":
            return self._add([self.ratio(child) for child in term[1:]])
        if kind == "-":
            return self._negate(self.ratio(term[1]))
        if kind == "*":
            return self._product([self.ratio(child) for child in term[1:]])
        if kind == "/":
            return self._product([self.ratio(term[1]), self._inverse(term[2])])
        if kind == "^":
            base, exponent = power_of(term)
            return self._power(self.ratio(base) if exponent >= 0 else self._inverse(base), abs(exponent))
        if kind == "pi":
            return Ratio(self.generator[kind])
        if kind in ("sin", "cos"):
            return Ratio(self.turn(angle(unfold(term[1], self.definitions)))[kind == "sin"])
        if kind == "tan":
            if (inner := undone(unfold(term, self.definitions))) is not None:
                return self.ratio(inner)
            return self.ratio(node("/", node("sin", term[1]), node("cos", term[1])))
        if kind == "exp":
            powers = exponents(unfold(term[1], self.definitions)).items()
            if any(times > MAX_TURNS for _, times in powers):
                raise Unsupported(f"the exponential {term!r}")
            return Ratio(prod((self.generator[name] ** times for name, times in powers), start=self.number(1)))
        if kind in FUNCTIONS and (name := atom(unfold(term, self.definitions))):
            return Ratio(self.generator[name])
        if kind == "pow":
            whole = number_of(unfold(term[2], self.definitions))
            assert whole is not None
            met = dict(self.divisors)
            value = self.ratio(node("^", term[1], int(whole)))
            self.divisors = met if self.inside else self.divisors
            return value
        if kind == "sqrt":
            return Ratio(self._root(_constant(unfold(term[1], self.definitions))))
        if kind == "diff":
            return self.ratio(derivative(term, self.definitions))
        raise Unsupported(f"the term {kind!r} is not known")

    def _inverse(self, term: Term) -> Ratio:
        """1 / term, product by product so that the divisors stay small."""
        if isinstance(term, tuple) and term[0] == "*":
            return self._product([self._inverse(child) for child in term[1:]])
        if isinstance(term, Node) and term.tag == "^" and power_of(term)[1] > 0:
            base, exponent = power_of(term)
            return self._power(self._inverse(base), exponent)
        value = self.ratio(term)
        num, divisor = value.bottom(), value.num
        if divisor == 0:
            shown = in_words(term)
            raise Unsupported(f"division by zero: {shown if len(shown) <= SHOWN else shown[:SHOWN] + '...'} is 0")
        if divisor.is_constant():
            return Ratio(num / divisor.leading_coefficient())
        if (unit := self._unit_inverse(divisor)) is not None:
            return Ratio(num * unit)
        if any(prime(name) is None for name in occurring(divisor)):
            self.divisors[str(divisor), *value.divisors()] = divisor
        return Ratio(num, {str(divisor): (divisor, 1)})

    def _unit_inverse(self, divisor: Poly) -> Poly | None:
        """1 / (r * product of roots) = product of roots / (r * product of their squares)."""
        terms = list(divisor.terms())
        if len(terms) > 1:
            return None
        exponents, coefficient = terms[0]
        result = self.number(1 / fraction(coefficient))
        for name, exponent in zip(self.names, exponents, strict=True):
            if not exponent:
                continue
            if (p := prime(name)) is None:
                return None
            result *= (self.generator[name] * rational(Fraction(1, p))) ** exponent
        return result

    def _power(self, value: Ratio, exponent: int) -> Ratio:
        """A whole power that is not negative."""
        length = len(value.num)
        small = exponent <= MAX_POWER
        if small and length > 1 and exponent > 2:
            degree = exponent * int(value.num.total_degree())
            small = degree <= MAX_DEGREE and comb(exponent + length - 1, exponent) <= MAX_LENGTH
        if not small or (exponent > 20 and exponent * max(map(_bits, value.num.coeffs()), default=0) > MAX_BITS):
            raise Unsupported(f"the power {exponent} of a sum or of a long number")
        if exponent == 0:
            return Ratio(self.number(1))
        den = {text: (poly, count * exponent) for text, (poly, count) in value.den.items()}
        return Ratio(value.num**exponent, den)

    def _negate(self, value: Ratio) -> Ratio:
        return Ratio(-value.num, value.den)

    def _add(self, values: list[Ratio]) -> Ratio:
        common: dict[str, tuple[Poly, int]] = {}
        for value in values:
            for text, (poly, exponent) in value.den.items():
                common[text] = (poly, max(exponent, common[text][1] if text in common else 0))
        total = self.number(0)
        for value in values:
            num = value.num
            for text, (poly, exponent) in common.items():
                num = times(num, poly ** (exponent - (value.den[text][1] if text in value.den else 0)))
            total += num
        return Ratio(total, common)

    def _product(self, values: list[Ratio]) -> Ratio:
        den: dict[str, tuple[Poly, int]] = {}
        for value in values:
            for text, (poly, exponent) in value.den.items():
                den[text] = (poly, exponent + (den[text][1] if text in den else 0))
        num = self.number(1)
        for value in values:
            if den and (text := str(value.num)) in den:
                poly, exponent = den.pop(text)
                if exponent > 1:
                    den[text] = (poly, exponent - 1)
            else:
                num = times(num, value.num)
        return Ratio(num, den)

    def turn(self, combination: Mapping[str, int]) -> tuple[Poly, Poly]:
        """(cosine, sine) of an integer combination of angles, as `angle` gives it, by the addition theorem."""
        both = self.number(1), self.number(0)
        for name, count in combination.items():
            if abs(count) > MAX_TURNS:
                raise Unsupported(f"{count} times an angle")
            quarter = self.number(0), self.number(1)
            c, s = quarter if name == "pi" else (self.generator[cosine(name)], self.generator[sine(name)])
            s = s if count >= 0 else -s
            for _ in range(abs(count)):
                both = both[0] * c - both[1] * s, both[1] * c + both[0] * s
        return both

    def _root(self, value: Fraction) -> Poly:
        outside, primes = square_free(value)
        result = self.number(outside)
        for p in primes:
            result *= self.generator[table().root(p)]
        return result

    def axioms(self) -> dict[str, Poly]:
        """By variable, a polynomial that is zero by construction: of sines, with their cosines, and of roots."""
        found: dict[str, Poly] = {}
        for name in self.names:
            function, x = circle(name) or ("", "")
            if function == "sin":
                found[name] = self.generator[name] ** 2 + self.generator[cosine(x)] ** 2 - 1
            if (p := prime(name)) is not None:
                found[name] = self.generator[name] ** 2 - p
            other, _ = table().exponentials.get(name, ("", None))
            if other in self.generator and other > name:
                found[name] = self.generator[name] * self.generator[other] - 1
        return found
