"""What kernels are compared with: their derived expressions in ball arithmetic, at points of their domains.

An enclosure is narrowed until 50 digits of it are certain, however much cancels on the way. The error of a result is
counted in units of the last place of the value, or of the kernel's `scale` where that is larger.

    python -m tests.kernel_reference [PAPER]    # the largest error of each kernel, and where it is
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from flint import arb, ctx, fmpq

from symcheck.codegen import numpy_target
from symcheck.codegen.kernel import Argument, Kernel
from symcheck.codegen.target import Made
from symcheck.evidence import kernels as evidence
from symcheck.papers import load

PRECISIONS = (256, 1024, 4096, 16384)  # bits: the last are for differences beside 1e-300
DIGITS = 170  # bits that must be certain: 50 digits and some
NOTHING = arb(2) ** -4000  # what is not told from 0 and below this is 0
ORDINARY = 3.0  # decades about 1 that random points of an unbounded domain fill
CROWD = 300  # points crowd a place as closely as 10^-300

Columns = tuple[Any, ...]  # an array of doubles for each argument

METHODS = {
    "Abs": "abs({0})",
    "Max": "{0}.max({1})",
    "Min": "{0}.min({1})",
    "atan2": "arb.atan2({0}, {1})",
    "loggamma": "{0}.lgamma()",
    "sign": "{0}.sgn()",
    "erf": "{0}.erf()",
    "erfc": "{0}.erfc()",
    **{name: f"{{0}}.{name}()" for name in ("sin", "cos", "tan", "exp", "log", "atan", "asin", "acos", "gamma")},
    **{name: f"{{0}}.{name}()" for name in ("sinh", "cosh", "tanh", "asinh", "acosh", "atanh")},
}


class Enclosures:
    """Some expressions of some arguments as a function of balls."""

    def __init__(self, names: Sequence[str], expressions: Sequence[Any]) -> None:
        self._lines: list[str] = []
        self._places: dict[Any, str] = {sp.pi: "arb.pi()", sp.E: "arb(1).exp()"}
        self._inputs = {name: f"x{n}" for n, name in enumerate(names)}
        results = ", ".join([self._place(expression) for expression in expressions])
        body = "\n    ".join([*self._lines, f"return [{results}]"])
        space: dict[str, Any] = {"arb": arb, "fmpq": fmpq}
        exec(f"def function({', '.join(self._inputs.values())}):\n    {body}", space)
        self._function = space["function"]

    def __call__(self, point: Sequence[float], enough: Callable[[list[arb]], bool]) -> list[arb]:
        """The values at a point, narrowed until they are enough (or as narrow as it goes)."""
        finite = all(map(math.isfinite, point))
        for bits in PRECISIONS if finite else PRECISIONS[:1]:
            with ctx.workprec(bits):
                values: list[arb] = self._function(*map(arb, point))
                if enough(values):
                    break
        return values

    def _place(self, e: Any) -> str:
        if e not in self._places:
            text = self._text(e)
            self._places[e] = f"v{len(self._places)}"
            self._lines.append(f"{self._places[e]} = {text}")
        return self._places[e]

    def _text(self, e: Any) -> str:
        if e.is_Symbol:
            return self._inputs[e.name]
        if e.is_Rational:
            return f"arb({e.p})" if e.q == 1 else f"arb(fmpq({e.p}, {e.q}))"
        if e.is_Pow and e.exp.is_Rational and e.exp.q == 2:
            root = f"{self._place(e.base)}.sqrt()"
            return root if e.exp == sp.S.Half else f"({root}) ** {e.exp.p}"
        if e.is_Pow and e.exp.is_Integer:
            return f"{self._place(e.base)} ** ({e.exp})"
        operands = [self._place(part) for part in e.args]
        if e.is_Add or e.is_Mul or e.is_Pow:
            return (" + " if e.is_Add else " * " if e.is_Mul else " ** ").join(operands)
        name = e.func.__name__
        if name in ("Max", "Min"):
            return f"{operands[0]}" + "".join(f".{name.lower()}({each})" for each in operands[1:])
        if name not in METHODS:
            raise NotImplementedError(f"no enclosure of {name}; add it to METHODS")
        return METHODS[name].format(*operands)


class Truth(NamedTuple):
    """Points with the values there, high + low to more than 30 digits, and their size; arrays (outputs, points).

    Where the derived expression has no value, at a pole or between numbers that are none, there is nothing to compare
    with: the value here is no number.
    """

    points: Columns
    high: Any
    low: Any
    size: Any  # the value or the scale, whichever is larger

    def error(self, results: Sequence[Any], dtype: Any = np.float64) -> Any:
        """|results - values| in units of the last place of the type; infinite where only the result is no number.

        Zero where the value times its condition number is no double: no digit is certain there.
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
    def made(self) -> Made:
        """What targets write, without the evidence it rests on."""
        return _made(self)

    @property
    def text(self) -> str:
        """The module of this kernel alone."""
        return numpy_target.files(self.paper, {self.name: self.made})[f"{self.paper}.py"]

    @property
    def module(self) -> dict[str, Any]:
        """What is defined in the generated text: the function, its expression `_name` and its block."""
        return _module(self)

    @property
    def function(self) -> Any:
        return self.module[self.name]

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
def source(case: Case) -> str:
    """The generated text of one kernel, without the evidence it rests on."""
    return numpy_target.source(case.name, case.made)


@cache
def _made(case: Case) -> Made:
    return Made(case.kernel, *evidence.programs(case.kernel), "")


@cache
def _module(case: Case) -> dict[str, Any]:
    space: dict[str, Any] = {"__name__": case.id}
    exec(compile(case.text, case.id, "exec"), space)
    return space


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
    """(nearest double, the rest, the larger of value and scale); no number if there is no value."""
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


# --- points


def random_points(kernel: Kernel, count: int, rng: np.random.Generator, decades: float = ORDINARY) -> Columns:
    """Points spread over the domain, where it is unbounded over some decades about 1."""
    return _sampled(kernel, lambda argument, low, high: _spread(low, high, count, rng, decades))


def crowded_points(kernel: Kernel, count: int, rng: np.random.Generator) -> Columns:
    """Points at which some arguments crowd an end of their domain, as closely as doubles do, or one another."""
    names = [argument.name for argument in kernel.arguments]
    columns = dict(zip(names, random_points(kernel, count, rng), strict=True))

    def moved(argument: Argument, low: Any, high: Any) -> Any:
        column, kind = _spread(low, high, count, rng), rng.integers(0, 4, count)
        column = np.where(kind == 2, _beside_an_end(argument, low, high, count, rng), column)
        alike = [each.name for each in kernel.arguments if each.unit == argument.unit and each.name in columns]
        other = columns[str(rng.choice(alike))] * (1 + _closely(count, rng) * rng.choice([-1, 0, 1], count))
        columns[argument.name] = np.where(kind == 3, _inside(argument, other, low, high), column)
        return columns[argument.name]

    return _sampled(kernel, moved)


def inside(kernel: Kernel, points: Columns) -> Any:
    """Which points lie in the domain."""
    columns = dict(zip((argument.name for argument in kernel.arguments), points, strict=True))
    found = np.ones(points[0].shape, bool)
    for argument in kernel.arguments:
        low, high = _ends(argument, columns)
        column = columns[argument.name]
        found &= np.isfinite(column) & (_inside(argument, column, low, high) == column)
    return found


def unbounded(kernel: Kernel) -> bool:
    """Whether an argument has not two ends, so that doubles may not hold its products and powers."""
    return any(not (argument.low and argument.high) for argument in kernel.arguments)


def _sampled(kernel: Kernel, sample: Callable[[Argument, Any, Any], Any]) -> Columns:
    """A column for each argument; those whose ends are other arguments come after these."""
    columns: dict[str, Any] = {}
    waiting = list(kernel.arguments)
    while waiting:
        argument = waiting.pop(0)
        try:
            low, high = _ends(argument, columns)
        except NameError:
            waiting.append(argument)
            continue
        columns[argument.name] = _inside(argument, sample(argument, low, high), low, high)
    return tuple(columns[argument.name] for argument in kernel.arguments)


def _ends(argument: Argument, columns: dict[str, Any]) -> tuple[Any, Any]:
    """The ends of a domain, infinite where there is none."""
    known = {"pi": math.pi, "sqrt": np.sqrt, "abs": np.abs, "max": np.maximum, "min": np.minimum, **columns}
    low, high = (eval(text, {"__builtins__": {}}, known) if text else None for text in (argument.low, argument.high))
    return -np.inf if low is None else low, np.inf if high is None else high


def _inside(argument: Argument, column: Any, low: Any, high: Any) -> Any:
    """A column, moved into the domain where it is not: an open end itself is not in it, the double below pi/2 is."""
    first, last = low, high
    if not argument.closed:
        first = low if _rounded(argument.low) > 0 else _next(low, np.inf)
        last = high if _rounded(argument.high) < 0 else _next(high, -np.inf)
    return np.clip(column, first, last)


def _next(end: Any, towards: float) -> Any:
    """The next number; beside 0 the nearest that crowds it, since closer doubles have fewer digits."""
    return np.where(end == 0, np.copysign(10.0**-CROWD, towards), np.nextafter(end, towards))


@cache
def _rounded(end: str) -> int:
    """The sign of what rounding did to an end, 0 for other arguments."""
    exact = sp.sympify(end) if end else sp.oo
    if not (exact.is_number and exact.is_finite):
        return 0
    return int(sp.sign(sp.Rational(float(exact)) - exact))


def _spread(low: Any, high: Any, count: int, rng: np.random.Generator, decades: float = ORDINARY) -> Any:
    """Evenly between two ends, else evenly in the logarithm of the distance from the one end or from zero."""
    far = 10 ** rng.uniform(-decades, decades, count)
    if np.all(np.isfinite(low)) and np.all(np.isfinite(high)):
        return low + (high - low) * rng.random(count)
    if np.all(np.isfinite(low)):
        return low + far
    return high - far if np.all(np.isfinite(high)) else far * rng.choice([-1, 1], count)


def _beside_an_end(argument: Argument, low: Any, high: Any, count: int, rng: np.random.Generator) -> Any:
    """Close to an end, or to zero where there is none, or to a quarter turn."""
    near = _closely(count, rng)
    if np.isinf(low).all() and np.isinf(high).all():
        turns = rng.integers(-4, 5, count) if argument.unit == "rad" else 0
        return turns * (math.pi / 2) + near * rng.choice([-1, 1], count)
    from_low = np.isinf(high) | (rng.random(count) < 0.5) & ~np.isinf(low)
    return np.where(from_low, np.where(np.isinf(low), 0, low) + near, np.where(np.isinf(high), 0, high) - near)


def _closely(count: int, rng: np.random.Generator) -> Any:
    """10^-k for k from 1 to 300; half of them within the digits of a double."""
    powers = rng.permutation(np.resize(np.arange(1, CROWD + 1), count))
    return 10.0 ** -np.where(rng.random(count) < 0.5, 1 + powers % 17, powers)


# --- results


def arrays(case: Case, points: Columns) -> Sequence[Any]:
    """The results at some points, computed by blocks."""
    shape = np.broadcast_shapes(*(column.shape for column in points))
    out = [np.empty(shape) for _ in case.kernel.outputs]
    with np.errstate(all="ignore"):
        case.function(*points, out=out if len(out) > 1 else out[0])
    return out


def in_range(case: Case, point: Sequence[float]) -> bool:
    """Whether no intermediate value at a point leaves the range of doubles."""
    with np.errstate(all="raise"):
        try:
            case.module[f"_{case.name}"](*map(np.float64, point))
        except (FloatingPointError, ZeroDivisionError):
            return False
    return True


class Worst(NamedTuple):
    """The largest error of one output, in units of the last place, and the point where it is."""

    ulp: float
    output: str
    point: dict[str, float]


def worst(case: Case, truth: Truth, results: Sequence[Any]) -> Worst:
    """The largest error; points where an unbounded argument takes intermediate values out of range do not count."""
    error = truth.error(results)
    for n in np.flatnonzero((error > case.kernel.ulp).any(axis=0) & unbounded(case.kernel)):
        if not in_range(case, [x[n] for x in truth.points]):
            error[:, n] = 0
    row, column = np.unravel_index(np.argmax(error), error.shape)
    names = [argument.name for argument in case.kernel.arguments]
    point = {name: float(x[column]) for name, x in zip(names, truth.points, strict=True)}
    return Worst(float(error[row, column]), case.kernel.outputs[row].name, point)


def measured(case: Case, count: int, seed: int = 0) -> Worst:
    """The largest error at `count` random points and as many crowded ones."""
    found = []
    for points in (random_points, crowded_points):
        truth = case.truth(points(case.kernel, count, np.random.default_rng(seed)))
        found.append(worst(case, truth, arrays(case, truth.points)))
    return max(found)


def table(papers: Sequence[str] = (), count: int = 2000) -> Iterator[str]:
    """A line for each kernel: its largest error, how much is allowed, and where it is."""
    for case in cases().values():
        if not papers or case.paper in papers:
            found = measured(case, count)
            place = ", ".join(f"{name} = {value:.17g}" for name, value in found.point.items())
            yield f"{case.id:<52} {found.ulp:>8.2f} of {case.kernel.ulp:<3} ulp   {found.output} at {place}"


if __name__ == "__main__":
    for line in table(sys.argv[1:]):
        print(line, flush=True)
