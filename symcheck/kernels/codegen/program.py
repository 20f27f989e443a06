"""Expressions as straight-line programs: every distinct operation once, in an order that keeps few values alive.

Angles go through the tangent where their cosine cannot be negative: cos x = 1/sqrt(1 + tan^2 x), sin x = tan x cos x.
Processors with vector units compute a tangent faster than a sine, and one serves both; neither loses digits at 0 or
at pi/2, where 1 - sin^2 x does.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from symcheck.core.lazy import lazy
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen.special import RUNTIME, stable

sp = lazy("sympy")

Ref = str | Fraction  # a value by name, or a number
INFIX = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/"}
OF_HALF = "gamma_ratio_of_half"
UNARY = ("sin", "cos", "tan", "exp", "expm1", "log", "log1p", "sqrt", "arctan")


@dataclass(frozen=True)
class Operation:
    """result = function(*operands): add, subtract, multiply, divide, negative, power, UNARY or RUNTIME."""

    result: str
    function: str
    operands: tuple[Ref, ...]


def of_half(operation: Operation) -> Operation:
    """The operation; a ratio of gamma functions of x + 1/2 and x, which takes less, by a name of its own."""
    if operation.function == "gamma_ratio" and operation.operands[1] == Fraction(1, 2):
        return Operation(operation.result, OF_HALF, operation.operands[:1])
    return operation


@dataclass
class Program:
    """Operations in order; `outputs` are names or numbers."""

    inputs: tuple[str, ...]
    acute: frozenset[str] = frozenset()
    operations: list[Operation] = field(default_factory=list)
    outputs: dict[str, Ref] = field(default_factory=dict)
    _known: dict[tuple[str, tuple[Ref, ...]], str] = field(default_factory=dict)
    _values: dict[Any, Ref] = field(default_factory=dict)
    _turns: dict[Any, Any] = field(default_factory=dict)

    def apply(self, function: str, *operands: Ref) -> Ref:
        """The value of an operation, computed once; numbers are folded."""
        if all(isinstance(x, Fraction) for x in operands) and function not in (*UNARY, *RUNTIME, "power"):
            return _folded(function, *operands)  # type: ignore[arg-type]
        if function == "sqrt" and (isinstance(operands[0], Fraction) or operands[0] == "pi"):
            return f"sqrt({operands[0]})"  # a number, as pi is
        if function in ("add", "multiply"):
            operands = tuple(sorted(operands, key=_order))
            neutral = Fraction(function == "multiply")
            if neutral in operands:
                return next(x for x in operands if x != neutral)
        key = function, operands
        if key not in self._known:
            name = self._name(function, operands)
            self._known[key] = name
            self.operations.append(Operation(name, function, operands))
        return self._known[key]

    def _name(self, function: str, operands: tuple[Ref, ...]) -> str:
        """A descriptive name where there is one, else a number."""
        (first, *_) = operands
        base = f"{function}_{first}" if function in UNARY and first in self.inputs else ""
        if function == "multiply" and len(set(operands)) == 1 and isinstance(first, str) and not first[1:].isdigit():
            base = f"{first}_squared"
        taken = {operation.result for operation in self.operations} | set(self.inputs)
        if base and base not in taken:
            return base
        numbered = [name for name in taken if name[0] == "t" and name[1:].isdigit()]
        return f"t{len(numbered) + 1}"

    def value(self, expression: Any) -> Ref:
        """The value of a SymPy expression."""
        if expression not in self._values:
            self._values[expression] = self._value(expression)
        return self._values[expression]

    def _value(self, e: Any) -> Ref:
        if e.is_Rational:
            return Fraction(int(e.p), int(e.q))
        if e.is_Symbol:
            if e.name not in self.inputs:
                raise SymcheckError(f"{e.name} is not an argument of the kernel; declare it or substitute it")
            return str(e.name)
        if e is sp.pi:
            return "pi"
        if e.is_Add:
            return self._sum(e.as_ordered_terms())
        if e.is_Mul:
            return self._product(e)
        if e.is_Pow:
            return self._power(e.base, e.exp)
        if isinstance(e, sp.exp):
            return self.apply("exp", self.value(e.args[0]))
        if isinstance(e, (sp.sin, sp.cos, sp.tan)):
            return self._circular(e.func.__name__, e.args[0])
        if isinstance(e, (sp.log, sp.atan)):
            return self.apply({"log": "log", "atan": "arctan"}[e.func.__name__], self.value(e.args[0]))
        if e.func.__name__ in ("expm1", "log1p", *RUNTIME):
            return self.apply(e.func.__name__, *map(self.value, e.args))
        raise SymcheckError(f"{e.func.__name__} has no place in a kernel; rewrite {e}")

    def _circular(self, function: str, angle: Any) -> Ref:
        x = self.value(angle)
        if x not in self.acute or function == "tan":
            return self.apply(function, x)
        tangent = self.apply("tan", x)
        secant = self.apply("sqrt", self.apply("add", Fraction(1), self.apply("multiply", tangent, tangent)))
        return self.apply("divide", Fraction(1) if function == "cos" else tangent, secant)

    def _sum(self, terms: Iterable[Any]) -> Ref:
        plus: list[Ref] = []
        minus: list[Ref] = []
        for term in terms:
            coefficient, rest = term.as_coeff_Mul()
            negative = coefficient < 0
            (minus if negative else plus).append(self.value(-coefficient * rest if negative else term))
        if not plus:
            return self.apply("negative", self._added(minus))
        total = self._added(plus)
        for subtrahend in minus:
            total = self.apply("subtract", total, subtrahend)
        return total

    def _added(self, values: list[Ref]) -> Ref:
        total = values[0]
        for value in values[1:]:
            total = self.apply("add", total, value)
        return total

    def _product(self, e: Any) -> Ref:
        coefficient, factors = e.as_coeff_mul()
        above, below = [], []
        secants: dict[Any, int] = {}
        for factor in factors:
            base, exponent = self._turns.get(factor, factor).as_base_exp()
            if self._acute(base) and exponent.is_Integer and exponent > 0:
                (angle,) = base.args
                secants[angle] = secants.get(angle, 0) + int(exponent)
                above += [self._power(sp.tan(angle), exponent)] if isinstance(base, sp.sin) else []
            elif exponent.is_Rational and exponent < 0:
                below.append(self._power(base, -exponent))
            else:
                above.append(self.value(factor))
        below += self._lengths(secants)
        number = Fraction(int(coefficient.p), int(coefficient.q))
        negative, number = number < 0, abs(number)
        if above:
            top = self._multiplied(above)
            top = self.apply("multiply", number, top) if number != 1 else top
        else:
            top = number
        value = self.apply("divide", top, self._multiplied(below)) if below else top
        return self.apply("negative", value) if negative else value

    def _acute(self, e: Any) -> bool:
        """Whether this is the sine or cosine of an angle whose cosine is positive."""
        return isinstance(e, (sp.sin, sp.cos)) and self.value(e.args[0]) in self.acute

    def _lengths(self, secants: Mapping[Any, int]) -> list[Ref]:
        """What sines and cosines divide tangents by, all of it under one root: it is rounded once."""
        squares = {angle: self.value(1 + sp.tan(angle) ** 2) for angle in secants}
        whole = [self._power_of(squares[angle], n // 2) for angle, n in secants.items() if n > 1]
        odd = [squares[angle] for angle, n in secants.items() if n % 2]
        return [*whole, *([self.apply("sqrt", self._multiplied(odd))] if odd else [])]

    def _power_of(self, value: Ref, n: int) -> Ref:
        return self._multiplied([value] * n)

    def _multiplied(self, values: list[Ref]) -> Ref:
        product = values[0]
        for value in values[1:]:
            product = self.apply("multiply", product, value)
        return product

    def _power(self, base: Any, exponent: Any) -> Ref:
        if exponent.is_Rational and exponent < 0:
            return self.apply("divide", Fraction(1), self._power(base, -exponent))
        if not exponent.is_Rational or exponent.q > 2:
            return self.apply("power", self.value(base), self.value(exponent))
        whole, half = divmod(int(exponent.p), 2) if exponent.q == 2 else (int(exponent), 0)
        factors: list[Ref] = [self.apply("sqrt", self.value(base))] if half else []
        square: Ref = self.value(base)
        while whole:
            if whole & 1:
                factors.append(square)
            whole >>= 1
            square = self.apply("multiply", square, square) if whole else square
        return self._multiplied(factors)


def compiled(inputs: Iterable[str], outputs: Mapping[str, Any], acute: Iterable[str] = ()) -> Program:
    """The program of some expressions, common parts shared, nothing superfluous."""
    program = Program(tuple(inputs), frozenset(acute))
    replaced, reduced = sp.cse(list(map(stable, outputs.values())), order="canonical", list=True)
    for symbol, expression in replaced:
        if program._acute(expression):
            program._turns[symbol] = expression
        program._values[symbol] = program.value(expression)
    for name, expression in zip(outputs, reduced, strict=True):
        program.outputs[name] = program.value(expression)
    needed: set[Ref] = set(program.outputs.values())
    kept = []
    for operation in reversed(program.operations):
        if operation.result in needed:
            kept.append(operation)
            needed.update(operation.operands)
    program.operations = kept[::-1]
    return program


def distinct(program: Program) -> dict[Ref, str]:
    """The values that the program puts out, each once, with the first output that has it."""
    first: dict[Ref, str] = {}
    for name, value in program.outputs.items():
        first.setdefault(value, name)
    return first


def order_of(program: Program) -> list[int]:
    """For each output, which of the distinct values it is."""
    values = [*distinct(program)]
    return [values.index(value) for value in program.outputs.values()]


def under_root(x: Ref) -> Ref | None:
    """What the root is of, if this number is one."""
    if isinstance(x, Fraction) or not x.startswith("sqrt("):
        return None
    return "pi" if x[5:-1] == "pi" else Fraction(x[5:-1])


def is_number(x: Ref) -> bool:
    """Whether this is not a named value."""
    return isinstance(x, Fraction) or x == "pi" or under_root(x) is not None


def _folded(function: str, x: Fraction, y: Fraction = Fraction(0)) -> Fraction:
    return {
        "add": lambda: x + y,
        "subtract": lambda: x - y,
        "multiply": lambda: x * y,
        "divide": lambda: x / y,
        "negative": lambda: -x,
    }[function]()


def _order(x: Ref) -> tuple[bool, str]:
    return isinstance(x, str), str(x)
