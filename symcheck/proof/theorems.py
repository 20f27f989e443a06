"""What the checker takes for granted of functions: how terms are differentiated, and a table of theorems.

Terms and formulas are nested lists, as in `checker.py`; this file too uses the standard library alone.
"""

from collections import namedtuple
from collections.abc import Callable

from symcheck.proof.enclosures import Any, between
from symcheck.proof.enclosures import Unknown as Unknown

BINDING = ("integral", "diverges", "mean")
OPAQUE = ("sqrt", "pow", "log", "exp", "gamma", "arctan", "arcsin", "arccos")
CONSTANTS = ("pi", "infinity")
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")


def conjuncts(formula: Any) -> list[Any]:
    """The formula taken apart at "and"."""
    return [part for child in formula[1:] for part in conjuncts(child)] if formula[0] == "and" else [formula]


def contrary(formula: Any) -> Any:
    """What is true if and only if the formula is not."""
    kind, *parts = formula
    opposite = {"=": "!=", "!=": "=", "<": ">=", "<=": ">", ">": "<=", ">=": "<", "and": "or", "or": "and"}
    match kind:
        case "and" | "or":
            return [opposite[kind], *map(contrary, parts)]
        case "=>":
            return ["and", parts[0], contrary(parts[1])]
        case "<=>":
            return ["or", ["and", parts[0], contrary(parts[1])], ["and", parts[1], contrary(parts[0])]]
    return [opposite[kind], *parts]


def sides(formula: Any) -> list[Any]:
    """Both sides of every relation in a formula."""
    if formula[0] in RELATIONS:
        return list(formula[1:])
    return [term for part in formula[1 + (formula[0] == "exists") :] for term in sides(part)]


class Terms:
    """Terms over definitions, taken apart by their structure."""

    def __init__(self, definitions: dict[str, Any]) -> None:
        self.definitions = definitions
        self.met: set[str] = set()  # the definitions used
        self.degrees: dict[str, int] = {}  # of defined names

    def definition(self, name: str) -> Any:
        """What a defined name stands for."""
        self.met.add(name)
        return self.definitions[name]

    def degree(self, term: Any) -> int:
        """A bound of the degree, definitions having one already."""
        if type(term) is not list:
            return self.degrees.get(term, 1) if type(term) is str else 0
        return abs(term[2]) * self.degree(term[1]) if term[0] == "^" else sum(map(self.degree, term[1:]))

    def names(self, term: Any) -> set[str]:
        """The letters a term or formula depends on, definitions unfolded."""
        if type(term) is str:
            return self.names(self.definition(term)) if term in self.definitions else {term}
        if type(term) is int or not term:
            return set()
        if term[0] in BINDING:
            return (self.names(term[1]) - {term[2]}).union(*map(self.names, term[3:]))
        if term[0] == "call":
            return set().union(*map(self.names, term[3:]))
        return set().union(*map(self.names, term[1:]))

    def exact(self, term: Any) -> bool:
        """Whether a term is a number made of whole numbers and roots: its residue tells whether it is zero."""
        match term:
            case str():
                return self.exact(self.definitions[term]) if term in self.definitions else term[:5] == "sqrt_"
            case ["+" | "-" | "*" | "/" | "^" | "sqrt", *parts]:
                return all(map(self.exact, parts))
        return isinstance(term, int)

    def derived(self, term: Any, x: str, order: int) -> Any:
        """The derivative of that order, as a term."""
        if x in self.definitions or order not in range(1, 9):
            raise Unknown(f"a derivative by {x}, which is not a free variable, or of the order {order}")
        for _ in range(order):
            term = self.rate(term, x)
        return term

    def rate(self, term: Any, x: str) -> Any:
        """The first derivative."""
        if x not in self.names(term):
            return 0
        match term:
            case str():
                return self.rate(self.definition(term), x) if term in self.definitions else 1
            case ["+" | "-" as sign, *parts]:
                return [sign, *(self.rate(part, x) for part in parts)]
            case ["*", *parts]:
                rates = [(k, self.rate(part, x)) for k, part in enumerate(parts) if x in self.names(part)]
                return ["+", *(["*", *parts[:k], rate, *parts[k + 1 :]] for k, rate in rates)]
            case ["/", top, bottom] if x not in self.names(bottom):
                return ["/", self.rate(top, x), bottom]
            case ["/", top, bottom]:
                gain, loss = ["*", self.rate(top, x), bottom], ["*", top, self.rate(bottom, x)]
                return ["/", ["+", gain, ["-", loss]], ["^", bottom, 2]]
            case ["^", base, int(n)]:
                return ["*", n, ["^", base, n - 1], self.rate(base, x)]
            case ["pow", base, exponent]:
                first, second = ["/", ["*", exponent, self.rate(base, x)], base], self.rate(exponent, x)
                return ["*", term, first if second == 0 else ["+", first, ["*", ["log", base], second]]]
            case ["sin" | "cos" | "tan" | "sqrt" | "log" | "exp" | "arctan" as function, inner]:
                outer = {"sin": ["cos", inner], "cos": ["-", ["sin", inner]], "tan": ["^", ["cos", inner], -2]}
                outer |= {"sqrt": ["/", 1, ["*", 2, term]], "log": ["/", 1, inner], "exp": term}
                outer |= {"arctan": ["/", 1, ["+", 1, ["^", inner, 2]]]}
                return ["*", outer[function], self.rate(inner, x)]
            case ["diff", inner, str(y), int(n)]:
                return self.rate(self.derived(inner, y, n), x)
            case ["call", function, orders, *parts]:  # the chain rule
                return [
                    "+",
                    *(
                        ["*", ["call", function, _one_more(orders, k), *parts], self.rate(part, x)]
                        for k, part in enumerate(parts)
                        if x in self.names(part)
                    ),
                ]
        raise Unknown(f"the derivative of {term!r}")

    def polynomial_in(self, term: Any, *atoms: Any) -> bool:
        """Whether the term is a polynomial in the atoms (x, or sin x and cos x) over what does not depend on them."""
        letters = self.names(["+", *atoms])
        if term in atoms or not self.names(term) & letters:
            return True
        match term:
            case str():
                return term in self.definitions and self.polynomial_in(self.definitions[term], *atoms)
            case ["+" | "*" | "-", *parts]:
                return all(self.polynomial_in(part, *atoms) for part in parts)
            case ["/", top, bottom]:
                return self.polynomial_in(top, *atoms) and not self.names(bottom) & letters
            case ["^", base, int(n)]:
                return n >= 0 and self.polynomial_in(base, *atoms)
        return False

    def replaced(self, term: Any, by: dict[str, Any]) -> Any:
        """The term with each part whose text is a key replaced, definitions unfolded."""
        if str(term) in by:
            return by[str(term)]
        if isinstance(term, str) and term in self.definitions:
            return self.replaced(self.definition(term), by)
        first = 3 if isinstance(term, (list, tuple)) and term[0] == "call" else 1
        parts = term[first:] if isinstance(term, (list, tuple)) else ()
        return [*term[:first], *(self.replaced(part, by) for part in parts)] if parts else term


def _one_more(orders: Any, k: int) -> list[int]:
    """The orders of a partial derivative, one more by the argument with that number."""
    return [order + (number == k) for number, order in enumerate(orders)]


class Theorem(namedtuple("Theorem", "premises conclusion free without anew", defaults=("", (), ""))):
    """The premises imply the conclusion.

    `free` is a letter for whose every value the premises hold: nothing may be assumed of it, and the terms `without`
    do not depend on it. `anew` is a letter said to exist: nothing else may be known or said of it.
    """


def have(_: Terms, formula: Any) -> Theorem:
    """What is proved once may be used often."""
    return Theorem([formula], formula)


def congruence(_: Terms, function: Any, one: list[Any], other: list[Any]) -> Theorem:
    """A function has equal values at equal arguments; an unknown one is named as ["call", its name, the orders]."""
    head = [function] if isinstance(function, str) else [*function]
    unknown = head[0] == "call" and len(head) == 3 and len(head[2]) == len(one)
    if (head[0] not in OPAQUE and not unknown) or len(one) != len(other):  # a derivative, say, is no function of values
        raise Unknown(f"{function} of these arguments")
    return Theorem([["=", s, t] for s, t in zip(one, other, strict=True)], ["=", [*head, *one], [*head, *other]])


def dichotomy(_: Terms, t: Any) -> Theorem:
    """A number is positive or it is not."""
    return Theorem([], ["or", [">", t, 0], ["<=", t, 0]])


def root(_: Terms, t: Any) -> Theorem:
    """The square root of a number that is not negative."""
    return Theorem([[">=", t, 0]], ["and", [">=", ["sqrt", t], 0], ["=", ["^", ["sqrt", t], 2], t]])


def root_of_product(_: Terms, s: Any, t: Any) -> Theorem:
    """Of two numbers that are not negative."""
    product = ["=", ["sqrt", ["*", s, t]], ["*", ["sqrt", s], ["sqrt", t]]]
    return Theorem([[">=", s, 0], [">=", t, 0]], product)


def equal_squares(_: Terms, s: Any, t: Any) -> Theorem:
    """Two numbers that are not negative are equal if their squares are."""
    premises = [[">=", s, 0], [">=", t, 0], ["=", ["^", s, 2], ["^", t, 2]]]
    return Theorem(premises, ["=", s, t])


def power(_: Terms, base: Any, exponent: Any) -> Theorem:
    """A power of a positive number is positive."""
    return Theorem([[">", base, 0]], [">", ["pow", base, exponent], 0])


def power_of_sum(_: Terms, base: Any, s: Any, t: Any) -> Theorem:
    """b^(s+t) = b^s b^t for positive b."""
    whole, parts = ["pow", base, ["+", s, t]], ["*", ["pow", base, s], ["pow", base, t]]
    return Theorem([[">", base, 0]], ["=", whole, parts])


def power_of_product(_: Terms, s: Any, t: Any, exponent: Any) -> Theorem:
    """(s t)^u = s^u t^u for positive s, t."""
    whole, parts = ["pow", ["*", s, t], exponent], ["*", ["pow", s, exponent], ["pow", t, exponent]]
    return Theorem([[">", s, 0], [">", t, 0]], ["=", whole, parts])


def power_of_power(_: Terms, base: Any, n: int, exponent: Any) -> Theorem:
    """(b^n)^u = b^(n u) for positive b; 1^u = 1."""
    inner, outer = ["pow", ["^", base, n], exponent], ["pow", base, ["*", n, exponent]]
    return Theorem([[">", base, 0]], ["and", ["=", inner, outer], ["=", ["pow", 1, exponent], 1]])


def power_inverse(_: Terms, base: Any, exponent: Any, value: Any) -> Theorem:
    """b = y^(1/u) if b^u = y, for positive b."""
    premises = [[">", base, 0], ["!=", exponent, 0], ["=", ["pow", base, exponent], value]]
    return Theorem(premises, ["=", base, ["pow", value, ["/", 1, exponent]]])


def circle_number(_: Terms) -> Theorem:
    """pi is positive."""
    return Theorem([], [">", "pi", 0])


def known_angle(_: Terms, function: str, number: int) -> Theorem:
    """The angles 0, 30, 45, 60 and 90 degrees, by tangent, sine or cosine."""
    second, third = ["sqrt", 2], ["sqrt", 3]
    sines = [0, ["/", 1, 2], ["/", second, 2], ["/", third, 2], 1]
    values = {"arctan": [0, ["/", 1, third], 1, third], "arcsin": sines, "arccos": sines[::-1]}
    angles = [0, *(["/", "pi", n] for n in (6, 4, 3, 2))]
    table = [["=", [function, t], angle] for t, angle in zip(values[function], angles, strict=False)]
    return Theorem([], table[number])


def principal_value(_: Terms, function: str, t: Any) -> Theorem:
    """arctan t lies between -90 and 90 degrees, arcsin t from -90 to 90 and arccos t from 0 to 180 degrees."""
    quarter, value = ["/", "pi", 2], [function, t]
    domain, below, low, high = {
        "arctan": ([], "<", ["-", quarter], quarter),
        "arcsin": ([_in_range(t)], "<=", ["-", quarter], quarter),
        "arccos": ([_in_range(t)], "<=", 0, "pi"),
    }[function]
    return Theorem(domain, ["and", [below, low, value], [below, value, high]])


def first_quadrant(_: Terms, function: str, t: Any) -> Theorem:
    """arctan t, arcsin t and arccos t lie from 0 to 90 degrees if t is not negative."""
    if function not in ("arctan", "arcsin", "arccos"):
        raise Unknown(f"the angle {function}")
    value, domain = [function, t], [_in_range(t)] if function != "arctan" else []
    return Theorem([*domain, [">=", t, 0]], ["and", ["<=", 0, value], ["<=", value, ["/", "pi", 2]]])


def arctangent(_: Terms, sign: str, a: Any, t: Any, back: int) -> Theorem:
    """From -90 to 90 degrees an angle is less than arctan t, equal or greater, as its sine is to t times its cosine."""
    quarter = ["/", "pi", 2]
    same = [[_relation(sign), a, ["arctan", t]], [sign, ["sin", a], ["*", t, ["cos", a]]]]
    return Theorem([["<=", ["-", quarter], a], ["<=", a, quarter], same[back]], same[1 - back])


def arcsine(_: Terms, sign: str, a: Any, t: Any, back: int) -> Theorem:
    """From -90 to 90 degrees an angle is less than arcsin t, equal or greater, as its sine is to t."""
    quarter = ["/", "pi", 2]
    same = [[_relation(sign), a, ["arcsin", t]], [sign, ["sin", a], t]]
    return Theorem([_in_range(t), ["<=", ["-", quarter], a], ["<=", a, quarter], same[back]], same[1 - back])


def arccosine(_: Terms, sign: str, a: Any, t: Any, back: int) -> Theorem:
    """From 0 to 180 degrees an angle is less than arccos t, equal or greater, as t is to its cosine."""
    same = [[_relation(sign), a, ["arccos", t]], [sign, t, ["cos", a]]]
    return Theorem([_in_range(t), ["<=", 0, a], ["<=", a, "pi"], same[back]], same[1 - back])


def right_half(_: Terms, a: Any) -> Theorem:
    """The cosine of an angle from -90 to 90 degrees is not negative."""
    quarter = ["/", "pi", 2]
    return Theorem([["<=", ["-", quarter], a], ["<=", a, quarter]], [">=", ["cos", a], 0])


def _in_range(t: Any) -> Any:
    return ["<=", ["^", t, 2], 1]


def _relation(sign: str) -> str:
    if sign not in RELATIONS:
        raise Unknown(f"the relation {sign}")
    return sign


def enclosure(terms: Terms, t: Any, digits: int, *letters: Any) -> Theorem:
    """A number lies between two decimals, by interval arithmetic; its letters stand for what the premises say."""
    numbers = {x: number for _, x, number in letters}

    def meaning(x: str) -> Any:
        if x not in numbers and x not in terms.definitions:
            raise Unknown(f"the digits of {x}")
        return numbers[x] if x in numbers else terms.definition(x)

    low, high = between(t, meaning, digits)
    return Theorem([["=", x, number] for x, number in numbers.items()], ["and", ["<=", low, t], ["<=", t, high]])


def gamma(_: Terms, t: Any) -> Theorem:
    """Euler's gamma function is positive for positive t, and gamma(t + 1) = t gamma(t)."""
    step = ["=", ["gamma", ["+", t, 1]], ["*", t, ["gamma", t]]]
    return Theorem([[">", t, 0]], ["and", [">", ["gamma", t], 0], step])


def gamma_values(_: Terms) -> Theorem:
    """gamma(1) = 1, and gamma(1/2) is the root of pi."""
    half = ["gamma", ["/", 1, 2]]
    values = [["=", ["gamma", 1], 1], ["=", ["^", half, 2], "pi"], [">", half, 0]]
    return Theorem([], ["and", *values])


def mean(terms: Terms, f: Any, x: str, m: Any, g: Any) -> Theorem:
    """Over one turn f has the mean m if f = m + g' with polynomials f, g in sin x and cos x."""
    if not all(terms.polynomial_in(t, ["sin", x], ["cos", x]) for t in (f, g)):
        raise Unknown(f"no polynomial in the sine and cosine of {x}")
    return Theorem([["=", f, ["+", m, ["diff", g, x, 1]]]], ["=", ["mean", f, x], m], x, (m,))


def quarter_turn(terms: Terms, p: Any, x: str) -> Theorem:
    """A polynomial p in sin x and cos x with p(x + 90 degrees) = -p(x) is zero somewhere."""
    sine, cosine = ["sin", x], ["cos", x]
    if not terms.polynomial_in(p, sine, cosine):
        raise Unknown(f"no polynomial in the sine and cosine of {x}")
    turned = terms.replaced(p, {str(sine): cosine, str(cosine): ["-", sine]})
    return Theorem([["=", turned, ["-", p]]], ["=", p, 0], anew=x)


def intermediate_value(terms: Terms, p: Any, x: str, low: Any, high: Any) -> Theorem:
    """A polynomial p in x with values of two signs at the ends of an interval is zero inside."""
    if not terms.polynomial_in(p, x):
        raise Unknown(f"no polynomial in {x}")
    ends = ["*", *(terms.replaced(p, {x: end}) for end in (low, high))]
    inside = ["and", ["<", low, x], ["<", x, high], ["=", p, 0]]
    return Theorem([["<", low, high], ["<", ends, 0]], inside, without=(low, high), anew=x)


def beta(_: Terms, f: Any, x: str, c: Any, k: int, u: Any, r: Any, p: Any, q: Any) -> Theorem:
    """The integral of f = c x^(k+u) (p x^2 + q)^(-r) over x > 0, convergent for s = k + u + 1 > 0 and 2 r > s.

    It is c p^(-s/2) q^(s/2-r) gamma(s/2) gamma(r - s/2) / (2 gamma(r)), by Euler's integral of the first kind.
    """
    s, half, rest = ["+", k, u, 1], ["/", ["+", k, u, 1], 2], ["+", r, ["-", ["/", ["+", k, u, 1], 2]]]
    premises = [[">", p, 0], [">", q, 0], [">", s, 0], [">", ["+", ["*", 2, r], ["-", s]], 0]]
    powers = [["pow", p, ["-", half]], ["pow", q, ["-", rest]]]
    gammas = [["gamma", half], ["gamma", rest]]
    value = ["=", ["*", 2, ["gamma", r], ["integral", f, x, 0, "infinity"]], ["*", c, *powers, *gammas]]
    positive = [[">", t, 0] for t in (["gamma", r], *gammas, *powers)]
    finite = ["=", ["diverges", f, x, 0, "infinity"], 0]
    return Theorem([*premises, _shape(f, x, c, k, u, r, p, q)], ["and", finite, value, *positive], x, (c, u, r, p, q))


def beta_diverges(_: Terms, f: Any, x: str, c: Any, k: int, u: Any, r: Any, p: Any, q: Any) -> Theorem:
    """The same integral has no finite value for s <= 0 or 2 r <= s, as its integrand has one sign near both ends."""
    s = ["+", k, u, 1]
    premises = [[">", p, 0], [">", q, 0], ["!=", c, 0], ["or", ["<=", s, 0], ["<=", ["+", ["*", 2, r], ["-", s]], 0]]]
    infinite = ["=", ["diverges", f, x, 0, "infinity"], 1]
    return Theorem([*premises, _shape(f, x, c, k, u, r, p, q)], infinite, x, (c, u, r, p, q))


def _shape(f: Any, x: str, c: Any, k: int, u: Any, r: Any, p: Any, q: Any) -> Any:
    base = ["+", ["*", p, ["^", x, 2]], q]
    return ["=>", [">", x, 0], ["=", f, ["*", c, ["^", x, k], ["pow", x, u], ["pow", base, ["-", r]]]]]


def power_diverges(_: Terms, f: Any, x: str, c: Any, u: Any) -> Theorem:
    """The integral of f = c x^u over x > 0 has no finite value, whatever the exponent is."""
    shape = ["=>", [">", x, 0], ["=", f, ["*", c, ["pow", x, u]]]]
    return Theorem([["!=", c, 0], shape], ["=", ["diverges", f, x, 0, "infinity"], 1], x, (c, u))


def _finite(terms: Terms, *ends: Any) -> None:
    if any("infinity" in terms.names(end) for end in ends):
        raise Unknown("an interval without an end")


def constant(terms: Terms, c: Any, x: str, low: Any, high: Any) -> Theorem:
    """The integral of a constant over a finite interval."""
    _finite(terms, low, high)
    return Theorem([], ["=", ["integral", c, x, low, high], ["*", c, ["+", high, ["-", low]]]], x, (c, low, high))


def power_rule(terms: Terms, f: Any, x: str, low: Any, high: Any, c: Any, base: Any, exponent: Any) -> Theorem:
    """The integral of the derivative of c base^exponent, the base a polynomial in x that is positive in between."""
    _finite(terms, low, high)
    if not terms.polynomial_in(base, x):
        raise Unknown(f"no polynomial in {x}")
    primitive = ["*", c, ["pow", base, exponent]]
    between = ["and", ["<=", low, x], ["<=", x, high]]
    premise = ["=>", between, ["and", [">", base, 0], ["=", f, ["diff", primitive, x, 1]]]]
    first, last = (["*", c, ["pow", terms.replaced(base, {x: end}), exponent]] for end in (low, high))
    value = ["=", ["integral", f, x, low, high], ["+", last, ["-", first]]]
    return Theorem([["<=", low, high], premise], value, x, (low, high, c, exponent))


def even(terms: Terms, f: Any, x: str) -> Theorem:
    """An even function over the whole line: twice the half of it."""
    whole, half = (["-", "infinity"], "infinity"), (0, "infinity")
    value = ["=", ["integral", f, x, *whole], ["*", 2, ["integral", f, x, *half]]]
    finite = ["=", ["diverges", f, x, *whole], ["diverges", f, x, *half]]
    return Theorem([["=", terms.replaced(f, {x: ["-", x]}), f]], ["and", value, finite], x)


def odd(terms: Terms, f: Any, x: str) -> Theorem:
    """An odd function over the whole line, if the half of it converges."""
    whole = (["-", "infinity"], "infinity")
    premises = [["=", terms.replaced(f, {x: ["-", x]}), ["-", f]], ["=", ["diverges", f, x, 0, "infinity"], 0]]
    zero = [["=", ["integral", f, x, *whole], 0], ["=", ["diverges", f, x, *whole], 0]]
    return Theorem(premises, ["and", *zero], x)


THEOREMS: dict[str, Callable[..., Theorem]] = {
    each.__name__: each
    for each in (
        have, congruence, dichotomy, equal_squares, root, root_of_product,
        power, power_of_sum, power_of_product, power_of_power, power_inverse,
        gamma, gamma_values, circle_number,
        known_angle, principal_value, first_quadrant, arctangent, arcsine, arccosine, right_half,
        enclosure,
        mean, quarter_turn, intermediate_value,
        constant, power_rule, power_diverges, beta, beta_diverges, even, odd,
    )
}  # fmt: skip
