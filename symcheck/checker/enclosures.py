"""Enclosures of numbers: integers, in units of 2^-160, between which the value of a closed term lies.

Interval arithmetic with whole numbers: every operation rounds outward, so that no exact value is ever lost. The series
of sine, cosine and arctangent alternate and decrease where they are broken off: what is left out is smaller than its
first term. pi is 4 arctan 1.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, reduce
from itertools import repeat
from math import isqrt, prod

from symcheck.core.calculus import Unknown, derivative, differentiated
from symcheck.core.terms import Binder, Node, Term, Value, node

PLACES = 160  # binary ones of an enclosure's ends: 48 decimals, far beyond what is printed
ONE = 1 << PLACES
MANY = 1000  # terms of a sum, which are added one by one
CELLS = 128  # of an integral: smooth ones of a few units' length get 5 digits, which tell wrong constants apart
LARGEST = ONE << 2048  # beyond it a certificate is up to no good


class Interval:
    """All numbers from `low` to `high`, in units of 2^-160."""

    def __init__(self, low: int, high: int) -> None:
        self.low, self.high, self.size = low, high, max(-low, high)  # no number in it is farther from zero than `size`
        if self.size > LARGEST:
            raise Unknown("a number with too many digits")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Interval) and (self.low, self.high) == (other.low, other.high)

    def __hash__(self) -> int:
        return hash((self.low, self.high))

    def __add__(self, other: Interval) -> Interval:
        return Interval(self.low + other.low, self.high + other.high)

    def __neg__(self) -> Interval:
        return Interval(-self.high, -self.low)

    def __mul__(self, other: Interval) -> Interval:
        products = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        return Interval(min(products) >> PLACES, -(-max(products) >> PLACES))

    def __truediv__(self, other: Interval) -> Interval:
        if other.low <= 0 <= other.high:
            raise Unknown("a division by what may be zero")
        pairs = [(a << PLACES, b) for a in (self.low, self.high) for b in (other.low, other.high)]
        return Interval(min(a // b for a, b in pairs), max(-(-a // b) for a, b in pairs))

    def __pow__(self, exponent: int) -> Interval:
        if abs(exponent) > 999:
            raise Unknown(f"the exponent {exponent}")
        result = prod(repeat(self, abs(exponent)), start=whole(1))
        return result if exponent >= 0 else whole(1) / result

    def over(self, n: int) -> Interval:
        """Divided by a positive whole number, in a fraction of the time."""
        return Interval(self.low // n, -(-self.high // n))


def whole(n: int) -> Interval:
    """A whole number, exactly."""
    return Interval(n << PLACES, n << PLACES)


def root(x: Interval) -> Interval:
    """The square root."""
    if x.low < 0:
        raise Unknown("the root of what may be negative")
    return Interval(isqrt(x.low << PLACES), isqrt(x.high << PLACES) + 1)


def arctangent(x: Interval) -> Interval:
    """x - x^3/3 + x^5/5 - ... of an angle halved four times: tan(t/2) = tan t / (1 + sqrt(1 + tan^2 t))."""
    for _ in range(4):
        x = x / (whole(1) + root(whole(1) + x * x))
    if 4 * x.size > ONE:
        raise Unknown("an arctangent with too few digits")
    total, power, square, k = whole(0), x, x * x, 1
    while (term := power.over(k)).size > 1:
        total, power, k = total + term, -(power * square), k + 2
    return whole(16) * (total + Interval(-term.size, term.size))


PI = whole(4) * arctangent(whole(1))


def trigonometric(x: Interval, k: int) -> Interval:
    """x^k/k! - x^(k+2)/(k+2)! + ...: the cosine for k = 0, the sine for k = 1; whole turns are left out."""
    turn = whole(2) * PI
    x = x + -(whole((x.low + x.high) // (2 * turn.low)) * turn) + -PI  # between -pi and pi
    if x.size > 4 * ONE:
        raise Unknown("an angle with too few digits")
    total, term, square = whole(0), x if k else whole(1), x * x
    while k < 4 or term.size > 1:  # from x^4 on the terms decrease, as x^2 <= 16 < 5 * 6
        total, k = total + term, k + 2
        term = -(term * square).over(k * (k - 1))
    return -(total + Interval(-term.size, term.size))  # half a turn was left out too many


def arcsine(x: Interval) -> Interval:
    """2 arctan(x / (1 + sqrt(1 - x^2)))."""
    return whole(2) * arctangent(x / (whole(1) + root(whole(1) + -(x * x))))


def exponential(x: Interval) -> Interval:
    """1 + x + x^2/2 + ... of an exponent halved until it is below 1/8; then squared as often."""
    halved = max(0, (x.size >> PLACES - 3).bit_length())
    if halved > 16:
        raise Unknown("an exponent that is too large")
    y = x.over(1 << halved)
    total, term, k = whole(0), whole(1), 1
    while term.size > 1:  # the terms decrease eightfold, so that what is left out is smaller than the last one
        total, term, k = total + term, (term * y).over(k), k + 1
    total += Interval(-term.size - 1, term.size + 1)
    for _ in range(halved):
        total *= total
    return Interval(max(total.low, 0), total.high)


def logarithm(x: Interval) -> Interval:
    """2^n times the logarithm of the 2^n-th root, which is 2 (y + y^3/3 + y^5/5 + ...) for y = (x - 1)/(x + 1)."""
    if x.low <= 0:
        raise Unknown("the logarithm of what may not be positive")
    if x.low == x.high == ONE:
        return whole(0)
    halved = 3 + max(x.high.bit_length() - PLACES, PLACES - x.low.bit_length(), 1).bit_length()
    for _ in range(halved):
        x = root(x)
    y = (x + whole(-1)) / (x + whole(1))
    if 4 * y.size > ONE:
        raise Unknown("a logarithm with too few digits")
    total, power, square, k = whole(0), y, y * y, 1
    while (term := power.over(k)).size > 1:  # the terms decrease sixteenfold
        total, power, k = total + term, power * square, k + 2
    return whole(2 << halved) * (total + Interval(-term.size - 1, term.size + 1))


STIRLING = (  # B_2k/(2k (2k - 1)): their series envelops what it stands for, so that the last term is the error
    (1, 12), (-1, 360), (1, 1260), (-1, 1680), (1, 1188), (-691, 360360), (1, 156), (-3617, 122400), (43867, 244188),
    (-174611, 125400), (77683, 5796),
)  # fmt: skip


def gamma(x: Interval) -> Interval:
    """Stirling's series for log gamma at a number above 40, to which gamma(x) = gamma(x + 1)/x leads."""
    if x.low <= 0:
        raise Unknown("the gamma function of what may not be positive")
    below = whole(1)
    while x.low < 40 * ONE:
        below, x = below * x, x + whole(1)
    total = (x + whole(-1).over(2)) * logarithm(x) + -x + logarithm(whole(2) * PI).over(2)
    for k, (top, bottom) in enumerate(STIRLING):
        term = (whole(top) / x ** (2 * k + 1)).over(bottom)
        total += term
    return exponential(total + Interval(-term.size, term.size)) / below


FUNCTIONS: dict[str, Callable[[Interval], Interval]] = {
    "-": Interval.__neg__,
    "sqrt": root,
    "sin": lambda x: trigonometric(x, 1),
    "cos": lambda x: trigonometric(x, 0),
    "tan": lambda x: trigonometric(x, 1) / trigonometric(x, 0),
    "exp": exponential,
    "log": logarithm,
    "gamma": gamma,
    "arctan": arctangent,
    "arcsin": arcsine,
    "arccos": lambda x: PI.over(2) + -arcsine(x),
}


Place = tuple[tuple[str, Interval], ...]  # what bound letters stand for


@lru_cache(4096)
def enclosed(term: Term, at: Place = ()) -> Interval:
    """The value of a term; Unknown if it is no number."""
    match term:
        case int():
            return whole(term)
        case str() if found := [value for name, value in at if name == term]:
            return found[-1]
        case Value(tag="pi"):
            return PI
        case Value(tag="/", terms=(top, bottom)):
            return enclosed(top, at) / enclosed(bottom, at)
        case Value(tag="^", terms=(base, int(n))):
            return enclosed(base, at) ** n
        case Value(tag="pow", terms=(base, exponent)):
            power = enclosed(exponent, at)
            if power.low == power.high and power.low % ONE == 0:
                return enclosed(base, at) ** (power.low >> PLACES)
            return exponential(power * logarithm(enclosed(base, at)))
        case Value(tag="+" | "*" as sign, terms=(first, *rest)):
            values = (enclosed(part, at) for part in rest)
            return reduce(Interval.__add__ if sign == "+" else Interval.__mul__, values, enclosed(first, at))
        case Value(tag=function, terms=(inner,)) if function in FUNCTIONS:
            return FUNCTIONS[function](enclosed(inner, at))
        case Binder(tag="diff", body=body, letter=x, outside=(_, place)):
            enclosed(body, (*at, (x, enclosed(place, at))))  # it has a value there
            return enclosed(differentiated(term), at)
        case Binder(tag="sum" | "product" as kind, body=body, letter=k, outside=ends):
            low, high = (exactly(enclosed(end, at)) for end in ends)
            if high - low > MANY:
                raise Unknown(f"a {kind} of more than {MANY} terms")
            parts = (enclosed(body, (*at, (k, whole(n)))) for n in range(low, high + 1))
            return reduce(Interval.__add__, parts, whole(0)) if kind == "sum" else prod(parts, start=whole(1))
        case Binder(tag="integral", body=body, letter=x, outside=(start, end)):
            return integral(body, x, enclosed(start, at), enclosed(end, at), at)
    raise Unknown(f"the digits of {term!r}")


def exactly(x: Interval) -> int:
    """The whole number that an interval is."""
    if x.low != x.high or x.low % ONE:
        raise Unknown("an end of a sum that is no whole number")
    return x.low >> PLACES


@lru_cache(256)  # of its own: the cells of one integral push all others out of the other cache
def integral(body: Term, x: str, start: Interval, end: Interval, at: Place) -> Interval:
    """Cell by cell h f(m) + h^3 f''/24: the second derivative is enclosed over the whole cell, m is its middle.

    The ends of the integral are intervals, and so is the middle of each cell.
    """
    second = derivative(derivative(body, x), x)
    width = (end + -start).over(CELLS)
    half, square, total = width.over(2), (width * width).over(24), whole(0)
    for k in range(CELLS):
        middle = start + whole(2 * k + 1) * half
        cell = (*at, (x, Interval(middle.low - half.size, middle.high + half.size)))
        enclosed(body, cell)  # it has a value in the whole cell
        total += width * (enclosed(body, (*at, (x, middle))) + square * enclosed(second, cell))
    return total


def between(term: Term, digits: int) -> tuple[Node, Node]:
    """Decimals with so many digits behind the point, as terms, not above and not below the value."""
    if digits not in range(41):
        raise Unknown(f"{digits} digits")
    value, unit = enclosed(term), 10**digits
    return node("/", value.low * unit >> PLACES, unit), node("/", -(-value.high * unit >> PLACES), unit)
