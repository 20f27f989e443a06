"""Complex numbers as pairs of terms: what the imaginary unit, and functions of it, are lowered to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from typing import TypeAlias

from symcheck.core.terms import PI, Node, Term, node
from symcheck.core.verdicts import NoForm
from symcheck.reading.functions import REAL, SPELLED


@dataclass(frozen=True, slots=True)
class Complex:
    """A number by its real and its imaginary part."""

    real: Term
    imaginary: Term


Number: TypeAlias = Term | Complex
UNIT = Complex(0, 1)


def parts(value: Number) -> tuple[Term, Term]:
    """The real and the imaginary part."""
    return (value.real, value.imaginary) if isinstance(value, Complex) else (value, 0)


def _plain(real: Term, imaginary: Term) -> Number:
    return Complex(real, imaginary) if imaginary != 0 else real


def _plus(*terms: Term) -> Term:
    kept: list[Term] = []
    for t in terms:
        if _minus(t) in kept:  # what is added to its conjugate is real
            kept.remove(_minus(t))
        elif isinstance(t, Node) and t.tag == "-" and t.outside[0] in kept:
            kept.remove(t.outside[0])
        elif t != 0:
            kept.append(t)
    return node("+", *kept) if len(kept) > 1 else kept[0] if kept else 0


def _minus(t: Term) -> Term:
    return node("-", t) if t != 0 else 0


def _times(*factors: Term) -> Term:
    kept = [t for t in factors if t != 1]
    if 0 in factors:
        return 0
    return node("*", *kept) if len(kept) > 1 else kept[0] if kept else 1


def added(*values: Number) -> Number:
    """The sum."""
    if not any(isinstance(value, Complex) for value in values):
        return node("+", *values)  # type: ignore[arg-type]
    pairs = [*map(parts, values)]
    return Complex(_plus(*(re for re, _ in pairs)), _plus(*(im for _, im in pairs)))


def negative(value: Number) -> Number:
    """The value with the other sign."""
    return Complex(_minus(value.real), _minus(value.imaginary)) if isinstance(value, Complex) else node("-", value)


def multiplied(*values: Number) -> Number:
    """The product."""
    if not any(isinstance(value, Complex) for value in values):
        return node("*", *values)  # type: ignore[arg-type]
    real = [value for value in values if not isinstance(value, Complex)]
    product = reduce(_product, [value for value in values if isinstance(value, Complex)])
    return Complex(_times(*real, product.real), _times(*real, product.imaginary))


def _product(a: Complex, b: Complex) -> Complex:
    real = _plus(_times(a.real, b.real), _minus(_times(a.imaginary, b.imaginary)))
    return Complex(real, _plus(_times(a.real, b.imaginary), _times(a.imaginary, b.real)))


def divided(top: Number, bottom: Number) -> Number:
    """The quotient."""
    if not isinstance(bottom, Complex):
        if not isinstance(top, Complex):
            return node("/", top, bottom)
        return Complex(node("/", top.real, bottom), node("/", top.imaginary, bottom))
    re, im = bottom.real, bottom.imaginary
    square = _plus(*(node("^", t, 2) for t in (re, im) if t != 0))
    turned = multiplied(top, Complex(re, _minus(im)))
    real, imaginary = parts(turned)
    return Complex(node("/", real, square), node("/", imaginary, square))


def raised(base: Complex, exponent: Number) -> Number:
    """A whole power."""
    if not isinstance(exponent, int):
        raise NoForm("a power of a complex number that is not whole has several values; write exp of a logarithm")
    if exponent == 0:
        return 1
    power = reduce(_product, [base] * abs(exponent))
    return power if exponent > 0 else divided(1, power)


def raised_to_whole(base: Complex, exponent: Term) -> Number:
    """A power whose exponent is a whole letter, by de Moivre; NoForm where no size and angle are seen."""
    found = _size_and_angle(base)
    if found is None:
        raise NoForm("a power of a complex number is read where its size and its angle are printed; write exp")
    size, angle = found
    turned = node("*", exponent, angle)
    power = _size_raised(size, exponent)
    return Complex(_times(power, node("cos", turned)), _times(power, node("sin", turned)))


def _size_raised(size: Term, exponent: Term) -> Term:
    match size:
        case 1:
            return 1
        case Node(tag="sqrt", outside=(inner,)):
            return node("pow", inner, node("/", exponent, 2))
        case Node(tag="*", outside=factors):
            return node("*", *(_size_raised(each, exponent) for each in factors))
    return node("pow", size, exponent)


def _size_and_angle(z: Complex) -> tuple[Term, Term] | None:
    """r and a of r (cos a + i sin a)."""
    (sign, real), (other, imaginary) = _factors(z.real), _factors(z.imaginary)
    if not real and not imaginary:
        real, imaginary = [1], [1]
    if z.real == 0:
        return _times(*imaginary), node("/", node("*", other, PI), 2)
    if sorted(map(repr, real)) == sorted(map(repr, imaginary)) and sign > 0:
        return _times(node("sqrt", 2), *real), node("/", node("*", other, PI), 4)
    for factor in real:
        if isinstance(factor, Node) and factor.tag == "cos":
            angle, rest = factor.outside[0], [each for each in real if each is not factor]
            turned = node("sin", angle)
            if turned in imaginary and sign > 0:
                others = [each for each in imaginary if each != turned]
                if sorted(map(repr, rest)) == sorted(map(repr, others)) and turned not in others:
                    return _times(*rest), angle if other > 0 else node("-", angle)
    return None


def _factors(term: Term) -> tuple[int, list[Term]]:
    """A sign, and what is multiplied; 1 is left out."""
    match term:
        case Node(tag="-", outside=(inner,)):
            sign, factors = _factors(inner)
            return -sign, factors
        case Node(tag="*", outside=parts):
            pairs = [*map(_factors, parts)]
            sign = -1 if sum(each < 0 for each, _ in pairs) % 2 else 1
            return sign, [factor for _, factors in pairs for factor in factors]
        case int(n):
            return (-1 if n < 0 else 1), [] if abs(n) == 1 else [abs(n)]
    return 1, [term]


def conjugate(value: Number) -> Number:
    """The conjugate number."""
    return Complex(value.real, _minus(value.imaginary)) if isinstance(value, Complex) else value


def modulus(value: Complex) -> Term:
    """The absolute value."""
    return node("sqrt", _plus(*(node("^", t, 2) for t in parts(value) if t != 0)))


def _exponential(z: Complex) -> Number:
    turn = Complex(node("cos", z.imaginary), node("sin", z.imaginary))
    return multiplied(node("exp", z.real), turn) if z.real != 0 else turn


def _sine(z: Complex) -> Number:
    sh, ch = REAL["sinh"](z.imaginary), REAL["cosh"](z.imaginary)
    return _plain(_times(_sin(z.real), ch), _times(_cos(z.real), sh))


def _cosine(z: Complex) -> Number:
    sh, ch = REAL["sinh"](z.imaginary), REAL["cosh"](z.imaginary)
    return _plain(_times(_cos(z.real), ch), _minus(_times(_sin(z.real), sh)))


def _sin(t: Term) -> Term:
    return node("sin", t) if t != 0 else 0


def _cos(t: Term) -> Term:
    return node("cos", t) if t != 0 else 1


def _turned(function: Callable[[Complex], Number]) -> Callable[[Complex], Number]:
    """The hyperbolic function of z is the trigonometric one of iz."""

    def built(z: Complex) -> Number:
        inner = Complex(_minus(z.imaginary), z.real)
        value = function(inner)
        return multiplied(Complex(0, -1), value) if function is _sine else value

    return built


_FUNCTIONS: dict[str, Callable[[Complex], Number]] = {
    "exp": _exponential, "sin": _sine, "cos": _cosine, "tan": lambda z: divided(_sine(z), _cosine(z)),
    "overlined": conjugate,
    "cot": lambda z: divided(_cosine(z), _sine(z)), "sec": lambda z: divided(1, _cosine(z)),
    "csc": lambda z: divided(1, _sine(z)), "sinh": _turned(_sine), "cosh": _turned(_cosine),
    "tanh": lambda z: divided(_turned(_sine)(z), _turned(_cosine)(z)),
}  # fmt: skip


def applied(name: str, z: Complex) -> Number:
    """A function of a complex number; NoForm for one with several values there."""
    function = _FUNCTIONS.get(SPELLED.get(name, name))
    if function is None:
        raise NoForm(f"{name} of a complex number is not read: it has several values, or no form; write it out")
    return function(z)
