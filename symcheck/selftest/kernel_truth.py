"""What kernels are compared with: their derived expressions in ball arithmetic, at points of their domains.

An enclosure is narrowed until 50 digits of it are certain, however much cancels on the way. The error of a result is
counted in units of the last place of the value, or of the kernel's `scale` where that is larger.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, reduce
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from flint import arb, ctx, fmpq

from symcheck import kernels
from symcheck.audit import kernels as evidence
from symcheck.kernels.codegen import numpy_target
from symcheck.kernels.codegen.kernel import Kernel
from symcheck.kernels.codegen.target import CompiledKernel
from symcheck.kernels.runtime import DOUBLE
from symcheck.kernels.specification import KernelFunction
from symcheck.papers import load

PRECISIONS = (256, 1024, 4096, 16384)  # bits: the last are for differences near 1e-300
DIGITS = 170  # bits that must be certain: 50 digits and some
NOTHING = arb(2) ** -4000  # what cannot be distinguished from 0 and is below this is 0

Columns = tuple[Any, ...]  # an array of doubles for each argument

METHODS = ("atan2", "erf", "erfc", "sin", "cos", "tan", "exp", "log", "atan", "asin", "acos", "gamma")
FUNCTIONS: dict[str, Callable[..., arb]] = {
    **{name: vars(arb)[name] for name in (*METHODS, "sinh", "cosh", "tanh", "asinh", "acosh", "atanh")},
    "Abs": abs,
    "Max": lambda *balls: reduce(arb.max, balls),
    "Min": lambda *balls: reduce(arb.min, balls),
    "loggamma": arb.lgamma,
    "sign": arb.sgn,
}


class Enclosures:
    """Some expressions of some arguments as a function of balls."""

    def __init__(self, names: Sequence[str], expressions: Sequence[Any]) -> None:
        self._steps: list[tuple[Callable[..., arb], list[int]]] = []
        self._places: dict[Any, int] = {}
        self._inputs = {name: n for n, name in enumerate(names)}
        self._results = [self._place(expression) for expression in expressions]

    def __call__(self, point: Sequence[float], enough: Callable[[list[arb]], bool]) -> list[arb]:
        """The values at a point, narrowed until they are enough (or as narrow as it goes)."""
        finite = all(map(math.isfinite, point))
        for bits in PRECISIONS if finite else PRECISIONS[:1]:
            with ctx.workprec(bits):
                values = [arb(x) for x in point]
                for function, operands in self._steps:
                    values.append(function(*[values[n] for n in operands]))
                found = [values[n] for n in self._results]
                if enough(found):
                    break
        return found

    def _place(self, e: Any) -> int:
        """Where the value of an expression stands, once all steps to it are taken."""
        if e.is_Symbol:
            return self._inputs[e.name]
        if e not in self._places:
            function, parts = _step(e)
            operands = [self._place(part) for part in parts]
            self._places[e] = len(self._inputs) + len(self._steps)
            self._steps.append((function, operands))
        return self._places[e]


def _step(e: Any) -> tuple[Callable[..., arb], Sequence[Any]]:
    """The function of balls that computes an expression, and its operands."""
    if e is sp.pi:
        return arb.pi, ()
    if e is sp.E:
        return lambda: arb(1).exp(), ()
    if e.is_Rational:
        return lambda: arb(fmpq(e.p, e.q)), ()
    if e.is_Pow and e.exp.is_Rational and e.exp.q == 2:
        return lambda base: base.sqrt() ** int(e.exp.p), (e.base,)
    if e.is_Pow and e.exp.is_Integer:
        return lambda base: base ** int(e.exp), (e.base,)
    if e.is_Add or e.is_Mul or e.is_Pow:
        sign = operator.add if e.is_Add else operator.mul if e.is_Mul else operator.pow
        return lambda *balls: reduce(sign, balls), e.args
    name = e.func.__name__
    if name not in FUNCTIONS:
        raise NotImplementedError(f"no enclosure of {name}; add it to FUNCTIONS")
    return FUNCTIONS[name], e.args


class Truth(NamedTuple):
    """Points with the values there, high + low to more than 30 digits, and their size; arrays (outputs, points).

    Where the derived expression has no value, at a pole or for infinite arguments, there is nothing to compare with:
    the value here is NaN.
    """

    points: Columns
    high: Any
    low: Any
    size: Any  # the value or the scale, whichever is larger

    def error(self, results: Sequence[Any], dtype: Any = np.float64) -> Any:
        """|results - values| in units of the last place of the type; infinite where only the result is NaN.

        Zero where the value times its condition number overflows: no digit is certain there.
        """
        found = np.array([np.ravel(result) for result in results], np.float64)
        with np.errstate(all="ignore"):
            high = self.high.astype(dtype)  # in single precision more are infinite
            unit = np.spacing(self.size.astype(dtype)).astype(np.float64)
            error = np.abs((found - self.high) - self.low) / unit
        error[np.isinf(high) & (found == high) | np.isnan(high) | np.isfinite(high) & np.isinf(self.size)] = 0
        return np.where(np.isnan(error), np.inf, error)

    def take(self, places: Any) -> Truth:
        """The same at some of the points, or at points repeated."""
        return Truth(tuple(x[places] for x in self.points), *(x[:, places] for x in self[1:]))


@dataclass(frozen=True, eq=False)
class Case:
    """A kernel that was declared, with all that is made from it."""

    paper: str
    name: str
    kernel: Kernel

    @property
    def id(self) -> str:
        return f"{self.paper}:{self.name}"

    @property
    def compiled(self) -> CompiledKernel:
        """What targets write, without the evidence it rests on."""
        return _compiled(self)

    @property
    def text(self) -> str:
        """The module of this kernel alone."""
        return _text(self)

    @property
    def function(self) -> KernelFunction:
        return kernels.find(self.paper, self.name)

    def of_many(self, *arguments: Any) -> Any:
        """The results of arrays of one shape, computed as those of many points are."""
        count = len(self.kernel.arguments)
        return self.function.ways.plan(True, (1,) * count, 1, DOUBLE).whole(*arguments)

    @property
    def derived(self) -> list[Any]:
        """The derived expression of each output."""
        return _derived(self)

    def truth(self, points: Columns) -> Truth:
        """The values at some points."""
        return _truth(self, points)


@cache
def cases() -> dict[str, Case]:
    """All kernels of all papers, by id."""
    found = (Case(key, name, kernel) for key in load() for name, kernel in evidence.declared(key).items())
    return {case.id: case for case in found}


@cache
def _compiled(case: Case) -> CompiledKernel:
    return CompiledKernel(case.kernel, *evidence.programs(case.kernel))


@cache
def _text(case: Case) -> str:
    return numpy_target.files(case.paper, {case.name: case.compiled})[f"{case.paper}.py"]


@cache
def _derived(case: Case) -> list[Any]:
    values = case.kernel.derived()
    return [values[output.name] for output in case.kernel.outputs]


@cache
def _enclosures(case: Case) -> Enclosures:
    scales = case.kernel.scale() if case.kernel.scale else {}
    values = [*case.derived, *(sp.sympify(scales.get(output.name, 0)) for output in case.kernel.outputs)]
    return Enclosures([argument.name for argument in case.kernel.arguments], values)


def _truth(case: Case, points: Columns) -> Truth:
    outputs, function = len(case.kernel.outputs), _enclosures(case)

    def enough(values: list[arb]) -> bool:
        return all(map(_certain, values[:outputs], values[outputs:]))

    rows: list[list[tuple[float, float, float]]] = []
    for point in zip(*(column.tolist() for column in points), strict=True):
        values = function(point, enough)
        if not all(map(math.isfinite, point)):  # sin(infinity) lies between -1 and 1 and has no value
            values = [value if _certain(value, arb(0)) else arb(math.nan) for value in values]
        rows.append([_split(*pair) for pair in zip(values[:outputs], values[outputs:], strict=True)])
    high, low, size = np.array(rows, np.float64).reshape(-1, outputs, 3).transpose(2, 1, 0)
    return Truth(points, high, low, size)


def _certain(value: arb, scale: arb) -> bool:
    if not value.is_finite():
        return False
    return value.is_exact() or value.rel_accuracy_bits() >= DIGITS or bool(value.rad() * 2**DIGITS < abs(scale))


def _split(value: arb, scale: arb) -> tuple[float, float, float]:
    """(nearest double, the rest, the larger of value and scale); NaN if there is no value."""
    if not value.is_finite():
        infinite = value.lower() == value.upper()
        return (float(value), 0.0, math.inf) if infinite else (math.nan, math.nan, math.nan)
    if not _certain(value, scale):
        if not abs(value).upper() < NOTHING:
            raise ArithmeticError(f"{value} is not certain with {PRECISIONS[-1]} bits")
        value = arb(0)
    with ctx.workprec(DIGITS):
        high = float(value.mid())
        low = float(value.mid() - arb(high)) if math.isfinite(high) else 0.0
    return high, low, max(abs(high), abs(float(scale.mid())))
