"""Handbook identities and near misses with known truth: a seeded program that shares no code with the product.

An identity is a pair of terms that a handbook equates, with random terms in place of its letters. A near miss is an
identity with one random edit, of which mpmath shows at a random point that it fails. Both are printed as LaTeX in one
of several styles. Besides, `handbook_pairs.txt` has relations as people print them, each with a slip.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mpmath
from mpmath import mp

DIGITS = 30
Tree = Any  # a letter, a number, or (operation, part, ...)
Env = dict[str, Any]


@dataclass(frozen=True)
class Case:
    """A relation in LaTeX, what is given, and whether it is true."""

    family: str
    relation: str
    given: tuple[str, ...]
    true: bool
    where: tuple[str, ...] = ()
    letters: tuple[tuple[str, str], ...] = ()


# --- values


def value(tree: Tree, env: Env) -> Any:
    """The value of a tree; vectors are lists, matrices lists of rows."""
    if isinstance(tree, str):
        return env[tree] if tree in env else CONSTANTS[tree]()
    if isinstance(tree, int):
        return mpmath.mpf(tree)
    tag, *parts = tree
    if tag in BINDERS:
        return BINDERS[tag](parts, env)
    return FUNCTIONS[tag](*(value(part, env) for part in parts))


def _derivative(parts: Sequence[Tree], env: Env) -> Any:
    body, x = parts
    return mpmath.diff(lambda t: value(body, env | {x: t}), env[x])


def _integral(parts: Sequence[Tree], env: Env) -> Any:
    body, x, low, high = parts
    return mpmath.quad(lambda t: value(body, env | {x: t}), [value(low, env), value(high, env)])


def _sum(parts: Sequence[Tree], env: Env) -> Any:
    body, k, low, high = parts
    first, last = int(value(low, env)), int(value(high, env))
    return mpmath.fsum(value(body, env | {k: mpmath.mpf(n)}) for n in range(first, last + 1))


def _series(parts: Sequence[Tree], env: Env) -> Any:
    body, k, low = parts
    return mpmath.nsum(lambda n: value(body, env | {k: n}), [value(low, env), mpmath.inf])


def _improper(parts: Sequence[Tree], env: Env) -> Any:
    body, x, low = parts
    ends = [value(low, env), *range(2, 12, 3), mpmath.inf] if low != INFINITE else [-mpmath.inf, -3, 0, 3, mpmath.inf]
    return mpmath.quad(lambda t: value(body, env | {x: t}), ends)


def _whole(function: Callable[[int, Any], Any]) -> Callable[..., Any]:
    """A polynomial of whole order; an order that is none has no value."""

    def at(n: Any, x: Any) -> Any:
        if n != int(n) or n < 0:
            raise ValueError(n)
        return function(int(n), x)

    return at


def _sloped(function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda n, x: mpmath.diff(lambda t: function(n, t), x)


def _cross(a: Any, b: Any) -> Any:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _matmul(a: Any, b: Any) -> Any:
    if isinstance(b[0], list):
        return [
            [mpmath.fsum(x * y for x, y in zip(row, column, strict=True)) for column in zip(*b, strict=True)]
            for row in a
        ]
    return [mpmath.fsum(x * y for x, y in zip(row, b, strict=True)) for row in a]


def _each(function: Callable[..., Any], *parts: Any) -> Any:
    if isinstance(parts[0], list):
        return [_each(function, *row) for row in zip(*parts, strict=True)]
    return function(*parts)


def _scaled(a: Any, b: Any) -> Any:
    if isinstance(a, list) and isinstance(b, list):
        raise TypeError
    if isinstance(a, list):
        a, b = b, a
    return [_scaled(a, x) for x in b] if isinstance(b, list) else a * b


def _det(m: Any) -> Any:
    return mpmath.det(mpmath.matrix(m))


CONSTANTS: dict[str, Callable[[], Any]] = {r"\pi": lambda: +mp.pi, "e": lambda: +mp.e}
BINDERS = {"diff": _derivative, "int": _integral, "sum": _sum, "series": _series, "improper": _improper}
INFINITE = "-infinity"  # the lower end of an integral over the whole line
FAMILIES: dict[str, Callable[..., Any]] = {
    "P": _whole(mpmath.legendre),
    "T": _whole(mpmath.chebyt),
    "U": _whole(mpmath.chebyu),
    "H": _whole(mpmath.hermite),
    "J": mpmath.besselj,
    "I": mpmath.besseli,
}
MEANT = {
    "P": "Legendre polynomial", "T": "Chebyshev polynomial of the first kind", "H": "Hermite polynomial",
    "U": "Chebyshev polynomial of the second kind", "J": "Bessel function of the first kind",
    "I": "modified Bessel function of the first kind",
}  # fmt: skip
FUNCTIONS: dict[str, Callable[..., Any]] = {
    "+": lambda *xs: xs[0] if len(xs) == 1 else _each(lambda a, b: a + b, xs[0], FUNCTIONS["+"](*xs[1:])),
    "-": lambda x: _each(lambda a: -a, x),
    "*": lambda *xs: xs[0] if len(xs) == 1 else _scaled(xs[0], FUNCTIONS["*"](*xs[1:])),
    "/": lambda a, b: _scaled(1 / b, a),
    "^": lambda a, b: mpmath.power(a, b),
    "sqrt": mpmath.sqrt,
    "abs": abs,
    "exp": mpmath.exp,
    "ln": mpmath.log,
    **{
        name: getattr(mpmath, name)
        for name in ("sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "factorial", "binomial")
    },
    **FAMILIES,
    **{f"{name}'": _sloped(function) for name, function in FAMILIES.items()},
    "gamma": mpmath.gamma,
    "sgn": mpmath.sign,
    "max": max,
    "min": min,
    "atan2": mpmath.atan2,
    "skew": lambda v: [[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]],
    "unit": lambda: [[int(i == j) for j in range(3)] for i in range(3)],
    "arctan": mpmath.atan,
    "arcsin": mpmath.asin,
    "arccos": mpmath.acos,
    "dot": lambda a, b: mpmath.fsum(x * y for x, y in zip(a, b, strict=True)),
    "cross": _cross,
    "norm": lambda a: mpmath.sqrt(mpmath.fsum(x * x for x in a)),
    "mat": _matmul,
    "T": lambda m: [list(row) for row in zip(*m, strict=True)],
    "det": _det,
    "tr": lambda m: mpmath.fsum(m[k][k] for k in range(len(m))),
    "pmatrix": lambda *rows: [list(row) for row in rows],
    "row": lambda *entries: list(entries),
}


# --- LaTeX

SUM, PRODUCT, POWER, ATOM = range(4)
OPEN = {
    "int",
    "sum",
    "series",
    "improper",
    "diff",
    "sin",
    "cos",
    "tan",
    "sinh",
    "cosh",
    "tanh",
    "ln",
    "arctan",
}  # what follows may belong to
NAMED = {"ln", "sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "arctan", "arcsin", "arccos", "det"}


class Printer:
    """Prints trees in one style: fractions with \\frac or /, functions with or without brackets, e or exp."""

    def __init__(self, rng: random.Random) -> None:
        self.fractions = rng.random() < 0.8
        self.brackets = rng.random() < 0.4
        self.sized = rng.random() < 0.5
        self.dots = rng.random() < 0.2
        self.exp = rng.random() < 0.3

    def bracket(self, text: str) -> str:
        return rf"\left({text}\right)" if self.sized else f"({text})"

    def at(self, tree: Tree, level: int) -> str:
        text, own = self.text(tree)
        return text if own >= level else self.bracket(text)

    def factor(self, tree: Tree, last: bool) -> str:
        text, own = self.text(tree)
        open_ended = isinstance(tree, tuple) and (tree[0] in ("dot", "cross") or (tree[0] in OPEN and not last))
        return self.bracket(text) if own < PRODUCT or open_ended else text

    def text(self, tree: Tree) -> tuple[str, int]:
        if isinstance(tree, str):
            return tree, ATOM
        if isinstance(tree, int):
            return (str(tree), ATOM) if tree >= 0 else (str(tree), SUM)
        tag, *parts = tree
        match tag:
            case "+":
                first, *rest = parts
                out = self.at(first, SUM)
                for part in rest:
                    if isinstance(part, tuple) and part[0] == "-":
                        out += f" - {self.at(part[1], PRODUCT)}"
                    elif isinstance(part, int) and part < 0:
                        out += f" - {-part}"
                    else:
                        out += f" + {self.at(part, PRODUCT)}"
                return out, SUM
            case "-":
                return f"-{self.at(parts[0], PRODUCT)}", SUM
            case "*":
                out = ""
                for n, part in enumerate(parts):
                    piece = self.factor(part, n == len(parts) - 1)
                    glue = r" \cdot " if n and (self.dots or piece[0].isdigit()) else " "
                    out += (glue if n else "") + piece
                return out, PRODUCT
            case "/":
                if self.fractions:
                    return rf"\frac{{{self.text(parts[0])[0]}}}{{{self.text(parts[1])[0]}}}", ATOM - 1
                below = self.at(parts[1], ATOM)
                return f"{self.at(parts[0], POWER)} / {below}", SUM
            case "^":
                base, power = parts
                if (
                    isinstance(base, tuple)
                    and base[0] in NAMED
                    and isinstance(power, int)
                    and power > 1
                    and base[0] != "det"
                ):
                    return rf"\{base[0]}^{{{power}}} {self.argument(base[1])}", PRODUCT
                return f"{self.at(base, ATOM)}^{{{self.text(power)[0]}}}", POWER
            case "sqrt":
                return rf"\sqrt{{{self.text(parts[0])[0]}}}", ATOM
            case "abs":
                return rf"\left|{self.text(parts[0])[0]}\right|", ATOM
            case "norm":
                return rf"\|{self.text(parts[0])[0]}\|", ATOM
            case "exp":
                inner = self.text(parts[0])[0]
                return (rf"\exp\left({inner}\right)", PRODUCT) if self.exp else (f"e^{{{inner}}}", POWER)
            case "factorial":
                return f"{self.at(parts[0], ATOM)}!", POWER
            case "binomial":
                return rf"\binom{{{self.text(parts[0])[0]}}}{{{self.text(parts[1])[0]}}}", ATOM
            case "diff":
                body, x = parts
                return rf"\frac{{d}}{{d{x}}} {self.bracket(self.text(body)[0])}", PRODUCT
            case "int":
                body, x, low, high = parts
                return (
                    rf"\int_{{{self.text(low)[0]}}}^{{{self.text(high)[0]}}} {self.at(body, PRODUCT)} \, d{x}",
                    PRODUCT,
                )
            case "sum":
                body, k, low, high = parts
                return rf"\sum_{{{k}={self.text(low)[0]}}}^{{{self.text(high)[0]}}} {self.at(body, PRODUCT)}", PRODUCT
            case "series":
                body, k, low = parts
                return rf"\sum_{{{k}={self.text(low)[0]}}}^\infty {self.at(body, PRODUCT)}", PRODUCT
            case "improper":
                body, x, low = parts
                start = r"-\infty" if low == INFINITE else self.text(low)[0]
                return rf"\int_{{{start}}}^\infty {self.at(body, PRODUCT)} \, d{x}", PRODUCT
            case "gamma":
                return rf"\Gamma({self.text(parts[0])[0]})", ATOM
            case "sgn" | "atan2":
                inner = ", ".join(self.text(part)[0] for part in parts)
                return rf"\operatorname{{{tag}}}({inner})", ATOM
            case "max" | "min":
                return rf"\{tag}({', '.join(self.text(part)[0] for part in parts)})", ATOM
            case "skew":
                return rf"[{parts[0]}\times]", ATOM
            case "unit":
                return "I", ATOM
            case "dot":
                return rf"{self.at(parts[0], ATOM)} \cdot {self.at(parts[1], ATOM)}", PRODUCT
            case "cross":
                return rf"{self.at(parts[0], ATOM)} \times {self.at(parts[1], ATOM)}", PRODUCT
            case "mat":
                return f"{self.at(parts[0], ATOM)} {self.at(parts[1], ATOM)}", PRODUCT
            case "T":
                return f"{self.at(parts[0], ATOM)}^T", POWER
            case "tr":
                return rf"\operatorname{{tr}}({self.text(parts[0])[0]})", ATOM
            case "pmatrix":
                rows = r" \\ ".join(" & ".join(self.text(entry)[0] for entry in row[1:]) for row in parts)
                return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}", ATOM
        if tag.rstrip("'") in FAMILIES:
            order, at = (self.text(part)[0].replace(" ", "") for part in parts)
            return rf"{tag[0]}_{{{order}}}{tag[1:]}({at})", ATOM
        assert tag in NAMED, tag
        return rf"\{tag} {self.argument(parts[0])}", PRODUCT

    def argument(self, tree: Tree) -> str:
        text, own = self.text(tree)
        return text if own == ATOM and not self.brackets else self.bracket(text)


# --- identities: {family: [(left, right, what is given of A, B, ...)]}, with A, B, C for terms, n for a number

A, B, C, X, Y, N, K = "A", "B", "C", "x", "y", "n", "k"


def plus(*xs: Tree) -> Tree:
    return ("+", *xs)


def minus(a: Tree, b: Tree) -> Tree:
    return ("+", a, ("-", b))


def times(*xs: Tree) -> Tree:
    return ("*", *xs)


def over(a: Tree, b: Tree) -> Tree:
    return ("/", a, b)


def power(a: Tree, b: Tree) -> Tree:
    return ("^", a, b)


def f(name: str) -> Callable[..., Tree]:
    return lambda *xs: (name, *xs)


sin, cos, tan, ln, exp, sqrt = map(f, ("sin", "cos", "tan", "ln", "exp", "sqrt"))
sinh, cosh, tanh, arctan = map(f, ("sinh", "cosh", "tanh", "arctan"))
dot, cross, mat, transposed, det, trace, norm = map(f, ("dot", "cross", "mat", "T", "det", "tr", "norm"))
diff, integral, total = map(f, ("diff", "int", "sum"))
binomial, factorial, series, improper, gamma = map(f, ("binomial", "factorial", "series", "improper", "gamma"))
sgn, atan2, skew = map(f, ("sgn", "atan2", "skew"))
P, T, CU, H, J, I = map(f, FAMILIES)  # noqa: E741 - as they are printed
P1, T1, H1, J1, I1 = map(f, ("P'", "T'", "H'", "J'", "I'"))
UNIT = ("unit",)
PI = r"\pi"
U, V, W = r"\mathbf{u}", r"\mathbf{v}", r"\mathbf{w}"
M1, M2 = r"\mathbf{A}", r"\mathbf{B}"
M = ("pmatrix", ("row", "a", "b"), ("row", "c", "d"))

IDENTITIES: dict[str, list[tuple[Tree, Tree, tuple[str, ...]]]] = {
    "trigonometry": [
        (plus(power(sin(A), 2), power(cos(A), 2)), 1, ()),
        (sin(plus(A, B)), plus(times(sin(A), cos(B)), times(cos(A), sin(B))), ()),
        (cos(plus(A, B)), minus(times(cos(A), cos(B)), times(sin(A), sin(B))), ()),
        (sin(times(2, X)), times(2, sin(X), cos(X)), ()),
        (cos(times(2, X)), minus(1, times(2, power(sin(X), 2))), ()),
        (cos(times(3, X)), minus(times(4, power(cos(X), 3)), times(3, cos(X))), ()),
        (sin(times(3, X)), minus(times(3, sin(X)), times(4, power(sin(X), 3))), ()),
        (times(sin(A), sin(B)), over(minus(cos(minus(A, B)), cos(plus(A, B))), 2), ()),
        (plus(sin(X), sin(Y)), times(2, sin(over(plus(X, Y), 2)), cos(over(minus(X, Y), 2))), ()),
        (power(sin(over(X, 2)), 2), over(minus(1, cos(X)), 2), ()),
        (plus(1, power(tan(X), 2)), over(1, power(cos(X), 2)), ("cos",)),
        (tan(times(2, X)), over(times(2, tan(X)), minus(1, power(tan(X), 2))), ("tan",)),
        (sin(plus(X, over(PI, 2))), cos(X), ()),
        (cos(minus(PI, X)), ("-", cos(X)), ()),
        (sin(arctan(X)), over(X, sqrt(plus(1, power(X, 2)))), ()),
        (minus(power(cosh(A), 2), power(sinh(A), 2)), 1, ()),
        (sinh(times(2, X)), times(2, sinh(X), cosh(X)), ()),
        (tanh(X), over(minus(exp(times(2, X)), 1), plus(exp(times(2, X)), 1)), ()),
    ],
    "logarithms": [
        (ln(times(X, Y)), plus(ln(X), ln(Y)), ("+x", "+y")),
        (ln(over(X, Y)), minus(ln(X), ln(Y)), ("+x", "+y")),
        (ln(power(X, 3)), times(3, ln(X)), ("+x",)),
        (ln(sqrt(X)), over(ln(X), 2), ("+x",)),
        (exp(plus(A, B)), times(exp(A), exp(B)), ()),
        (exp(minus(A, B)), over(exp(A), exp(B)), ()),
        (power(exp(X), 2), exp(times(2, X)), ()),
        (exp(ln(X)), X, ("+x",)),
        (ln(exp(A)), A, ()),
        (exp(times(2, ln(X))), power(X, 2), ("+x",)),
        (ln(over(1, X)), ("-", ln(X)), ("+x",)),
    ],
    "algebra": [
        (power(plus(A, B), 2), plus(power(A, 2), times(2, A, B), power(B, 2)), ()),
        (minus(power(A, 2), power(B, 2)), times(minus(A, B), plus(A, B)), ()),
        (minus(power(A, 3), power(B, 3)), times(minus(A, B), plus(power(A, 2), times(A, B), power(B, 2))), ()),
        (
            power(minus(A, B), 3),
            plus(power(A, 3), ("-", times(3, power(A, 2), B)), times(3, A, power(B, 2)), ("-", power(B, 3))), (),
        ),
        (plus(over(1, X), over(1, Y)), over(plus(X, Y), times(X, Y)), ("+x", "+y")),
        (sqrt(times(X, Y)), times(sqrt(X), sqrt(Y)), ("+x", "+y")),
        (over(1, plus(sqrt(X), sqrt(Y))), over(minus(sqrt(X), sqrt(Y)), minus(X, Y)), ("+x", "+y", "x!=y")),
        (sqrt(power(X, 2)), ("abs", X), ()),
        (over(1, times(X, plus(X, 1))), minus(over(1, X), over(1, plus(X, 1))), ("+x",)),
        (over(plus(over(X, Y), 1), minus(over(X, Y), 1)), over(plus(X, Y), minus(X, Y)), ("+x", "+y", "x!=y")),
        (total(K, K, 1, N), over(times(N, plus(N, 1)), 2), ("n",)),
        (total(power(K, 2), K, 1, N), over(times(N, plus(N, 1), plus(times(2, N), 1)), 6), ("n",)),
        (total(power(2, K), K, 0, N), minus(power(2, plus(N, 1)), 1), ("n",)),
        (total(power(K, 2), K, 1, 5), 55, ()),
    ],
    "derivatives": [
        (diff(power(X, 4), X), times(4, power(X, 3)), ()),
        (diff(sin(times("a", X)), X), times("a", cos(times("a", X))), ()),
        (diff(exp(times("a", X)), X), times("a", exp(times("a", X))), ()),
        (diff(ln(X), X), over(1, X), ("+x",)),
        (diff(times(X, exp(X)), X), times(plus(X, 1), exp(X)), ()),
        (diff(sqrt(plus(power(X, 2), 1)), X), over(X, sqrt(plus(power(X, 2), 1))), ()),
        (diff(arctan(times("a", X)), X), over("a", plus(1, times(power("a", 2), power(X, 2)))), ()),
        (diff(tan(X), X), over(1, power(cos(X), 2)), ("cos",)),
        (diff(over(sin(X), X), X), over(minus(times(X, cos(X)), sin(X)), power(X, 2)), ("+x",)),
        (diff(power(sin(X), 2), X), sin(times(2, X)), ()),
        (diff(cosh(X), X), sinh(X), ()),
        (diff(ln(plus(1, power(X, 2))), X), over(times(2, X), plus(1, power(X, 2))), ()),
        (diff(power(X, "p"), X), times("p", power(X, minus("p", 1))), ("+x",)),
    ],
    "integrals": [
        (integral(power(X, 3), X, 0, 1), over(1, 4), ()),
        (integral(sin(X), X, 0, PI), 2, ()),
        (integral(over(1, X), X, 1, 2), ln(2), ()),
        (integral(over(1, plus(1, power(X, 2))), X, 0, 1), over(PI, 4), ()),
        (integral(exp(X), X, 0, 1), minus("e", 1), ()),
        (integral(power(cos(X), 2), X, 0, PI), over(PI, 2), ()),
        (integral(power("t", 2), "t", 0, X), over(power(X, 3), 3), ()),
        (integral(cos(times("a", "t")), "t", 0, X), over(sin(times("a", X)), "a"), ("+a",)),
        (integral(plus(times("a", "t"), "b"), "t", 0, X), plus(over(times("a", power(X, 2)), 2), times("b", X)), ()),
        (integral(exp(("-", "t")), "t", 0, X), minus(1, exp(("-", X))), ()),
        (integral(times("t", exp("t")), "t", 0, 1), 1, ()),
        (integral(times("t", sin("t")), "t", 0, PI), PI, ()),
        (integral(sqrt("t"), "t", 0, 4), over(16, 3), ()),
        (integral(over(1, sqrt(plus(1, "t"))), "t", 0, 3), 2, ()),
    ],
    "vectors": [
        (dot(U, cross(V, W)), dot(V, cross(W, U)), ()),
        (cross(U, cross(V, W)), minus(times(V, dot(U, W)), times(W, dot(U, V))), ()),
        (dot(U, cross(U, V)), 0, ()),
        (cross(U, V), ("-", cross(V, U)), ()),
        (power(norm(U), 2), dot(U, U), ()),
        (power(norm(cross(U, V)), 2), minus(times(power(norm(U), 2), power(norm(V), 2)), power(dot(U, V), 2)), ()),
        (dot(plus(U, V), plus(U, V)), plus(dot(U, U), times(2, dot(U, V)), dot(V, V)), ()),
        (cross(plus(U, V), W), plus(cross(U, W), cross(V, W)), ()),
        (dot(cross(U, V), cross(U, W)), minus(times(dot(U, U), dot(V, W)), times(dot(U, W), dot(V, U))), ()),
    ],
    "matrices": [
        (det(M), minus(times("a", "d"), times("b", "c")), ()),
        (transposed(mat(M1, M2)), mat(transposed(M2), transposed(M1)), ()),
        (trace(mat(M1, M2)), trace(mat(M2, M1)), ()),
        (det(mat(M1, M2)), times(det(M1), det(M2)), ()),
        (mat(M1, plus(U, V)), plus(mat(M1, U), mat(M1, V)), ()),
        (trace(plus(M1, M2)), plus(trace(M1), trace(M2)), ()),
        (
            mat(M, ("pmatrix", ("row", "x"), ("row", "y"))),
            ("pmatrix", *(("row", plus(times(p, "x"), times(q, "y"))) for p, q in ("ab", "cd"))), (),
        ),
        (det(transposed(M1)), det(M1), ()),
        (dot(U, mat(M1, V)), dot(mat(transposed(M1), U), V), ()),
    ],
    "sums": [
        (total(binomial(N, K), K, 0, N), power(2, N), ("n",)),
        (total(times(K, binomial(N, K)), K, 0, N), times(N, power(2, minus(N, 1))), ("n>",)),
        (total(power(binomial(N, K), 2), K, 0, N), binomial(times(2, N), N), ("n",)),
        (total(times(binomial(N, K), power("p", K), power(minus(1, "p"), minus(N, K))), K, 0, N), 1, ("n", "p")),
        (
            total(times(K, binomial(N, K), power("p", K), power(minus(1, "p"), minus(N, K))), K, 0, N),
            times(N, "p"), ("n", "p"),
        ),
        (total(binomial(plus("m", K), K), K, 0, N), binomial(plus("m", N, 1), N), ("n", "m")),
        (binomial(plus(N, 1), K), times(over(plus(N, 1), plus(N, 1, ("-", K))), binomial(N, K)), ("k",)),
        (series(power("p", K), K, 0), over(1, minus(1, "p")), ("p",)),
        (series(times(K, power("p", K)), K, 0), over("p", power(minus(1, "p"), 2)), ("p",)),
        (series(over(1, times(K, plus(K, 1))), K, 1), 1, ()),
        (series(over(power("p", K), factorial(K)), K, 0), exp("p"), ("p",)),
        (series(over(1, power(K, 2)), K, 1), over(power(PI, 2), 6), ()),
        (series(over(power("p", K), K), K, 1), ("-", ln(minus(1, "p"))), ("p",)),
    ],
    "special functions": [
        (
            times(plus(N, 1), P(plus(N, 1), X)),
            minus(times(plus(times(2, N), 1), X, P(N, X)), times(N, P(minus(N, 1), X))), ("n>",),
        ),
        (minus(P1(plus(N, 1), X), P1(minus(N, 1), X)), times(plus(times(2, N), 1), P(N, X)), ("n>",)),
        (P(2, X), over(minus(times(3, power(X, 2)), 1), 2), ()),
        (T(plus(N, 1), X), minus(times(2, X, T(N, X)), T(minus(N, 1), X)), ("n>",)),
        (T1(N, X), times(N, CU(minus(N, 1), X)), ("n>",)),
        (T(3, X), minus(times(4, power(X, 3)), times(3, X)), ()),
        (H1(N, X), times(2, N, H(minus(N, 1), X)), ("n>",)),
        (H(plus(N, 1), X), minus(times(2, X, H(N, X)), times(2, N, H(minus(N, 1), X))), ("n>",)),
        (plus(J(minus(N, 1), X), J(plus(N, 1), X)), times(over(times(2, N), X), J(N, X)), ("n>", "+x")),
        (minus(J(minus(N, 1), X), J(plus(N, 1), X)), times(2, J1(N, X)), ("n>", "+x")),
        (J1(0, X), ("-", J(1, X)), ("+x",)),
        (plus(I(minus(N, 1), X), I(plus(N, 1), X)), times(2, I1(N, X)), ("n>", "+x")),
        (gamma(plus(X, 1)), times(X, gamma(X)), ("+x",)),
        (gamma(plus(N, 1)), factorial(N), ("n",)),
    ],
    "distributions": [
        (improper(times("a", exp(("-", times("a", X)))), X, 0), 1, ("+a",)),
        (improper(times("a", X, exp(("-", times("a", X)))), X, 0), over(1, "a"), ("+a",)),
        (improper(exp(("-", power(X, 2))), X, INFINITE), sqrt(PI), ()),
        (
            improper(times(power(X, 2), exp(("-", times("a", power(X, 2))))), X, INFINITE),
            over(sqrt(PI), times(2, power("a", over(3, 2)))), ("+a",),
        ),
        (improper(exp(("-", times("a", "t"))), "t", 0), over(1, "a"), ("+a",)),
        (improper(times("t", exp(("-", times("a", "t")))), "t", 0), over(1, power("a", 2)), ("+a",)),
        (improper(times(sin("t"), exp(("-", times("a", "t")))), "t", 0), over(1, plus(power("a", 2), 1)), ("+a",)),
        (improper(over(1, plus(1, power(X, 2))), X, INFINITE), PI, ()),
        (improper(over(1, power(X, 3)), X, 1), over(1, 2), ()),
        (integral(times(X, minus(1, X)), X, 0, 1), over(1, 6), ()),
    ],
    "jumps": [
        (("abs", X), times(X, sgn(X)), ()),
        (sgn(times(X, Y)), times(sgn(X), sgn(Y)), ()),
        (("max", X, Y), over(plus(X, Y, ("abs", minus(X, Y))), 2), ()),
        (("min", X, Y), over(minus(plus(X, Y), ("abs", minus(X, Y))), 2), ()),
        (atan2(Y, X), arctan(over(Y, X)), ("+x",)),
        (atan2(times("a", Y), times("a", X)), atan2(Y, X), ("+a",)),
        (plus(("max", X, Y), ("min", X, Y)), plus(X, Y), ()),
    ],
    "rotations": [
        (mat(skew(U), V), cross(U, V), ()),
        (transposed(skew(U)), ("-", skew(U)), ()),
        (mat(skew(U), skew(V)), minus(mat(V, transposed(U)), times(dot(U, V), UNIT)), ()),
        (mat(skew(U), U), 0, ()),
        (dot(V, mat(skew(U), W)), dot(W, cross(V, U)), ()),
    ],
}  # fmt: skip
TERMS: list[Tree] = [
    "a",
    "b",
    "x",
    "y",
    r"\alpha",
    r"\beta",
    times(2, "x"),
    times(r"\omega", "t"),
    over("x", 2),
    plus("x", 1),
    times(3, "b"),
]
GIVEN = {
    "+x": "x > 0", "+y": "y > 0", "+a": "a > 0", "x!=y": r"x \neq y", "cos": r"\cos x \neq 0",
    "tan": r"\cos x \neq 0, \tan^2 x \neq 1", "n": r"n \in \mathbb{N}",
    "n>": r"n \in \mathbb{Z}_{>0}", "m": r"m \in \mathbb{N}", "p": "0 < p < 1",
    "k": r"n \in \mathbb{N}; k \in \mathbb{N}; k \le n",
}  # fmt: skip


def substituted(tree: Tree, by: dict[str, Tree]) -> Tree:
    if isinstance(tree, tuple):
        return (tree[0], *(substituted(part, by) for part in tree[1:]))
    return by.get(tree, tree) if isinstance(tree, str) else tree


def letters(tree: Tree) -> Iterator[str]:
    if isinstance(tree, str):
        yield tree
    elif isinstance(tree, tuple):
        for part in tree[1:]:
            yield from letters(part)


def point(rng: random.Random, *trees: Tree) -> Env:
    """Random values: of letters between 0.3 and 1.4 (so that every condition holds), of vectors and matrices."""

    def number() -> Any:
        return mpmath.mpf(rng.randrange(3000, 14000)) / 10000

    env: Env = {}
    for x in sorted({x for tree in trees for x in letters(tree)} - {*CONSTANTS}):
        if x in (U, V, W):
            env[x] = [number() for _ in range(3)]
        elif x in (M1, M2):
            env[x] = [[number() for _ in range(3)] for _ in range(3)]
        else:
            env[x] = mpmath.mpf(rng.randrange(3, 7)) if x == "n" else number()
        if x in ("k", "m"):
            env[x] = mpmath.mpf(rng.randrange(1, 3))
        if x == "p":
            env[x] = number() / 2
    return env


def agree(rng: random.Random, left: Tree, right: Tree) -> bool | None:
    """Whether both sides have the same value at random points; None where one has none."""

    def apart(a: Any, b: Any) -> bool:
        if isinstance(a, list):
            return any(apart(x, y) for x, y in zip(a, b, strict=True))
        return bool(abs(a - b) > mpmath.mpf(10) ** -12 * (1 + abs(a)))

    try:
        for _ in range(3):
            env = point(rng, left, right)
            if apart(value(left, env), value(right, env)):
                return False
    except (TypeError, ValueError, ZeroDivisionError):
        return None
    return True


SWAPS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh", "exp": "sin", "sqrt": "ln"}


def edits(tree: Tree) -> Iterator[Tree]:
    """The tree with one edit: a sign, a factor, an exponent, a function or a letter."""
    if isinstance(tree, tuple):
        tag, *parts = tree
        if tag == "+":
            for n, part in enumerate(parts):
                flipped = part[1] if isinstance(part, tuple) and part[0] == "-" else ("-", part)
                yield (tag, *parts[:n], flipped, *parts[n + 1 :])
                if len(parts) > 2:
                    yield (tag, *parts[:n], *parts[n + 1 :])
        if tag == "*" and isinstance(parts[0], int) and len(parts) > 2:
            yield (tag, *parts[1:])
        if tag in SWAPS:
            yield (SWAPS[tag], *parts)
        if tag == "cross" or tag == "mat":
            yield (tag, parts[1], parts[0])
        if tag == "/" and parts[0] != parts[1]:
            yield (tag, parts[1], parts[0])
        for n, part in enumerate(parts):
            if (tag in BINDERS and n == 1) or part == INFINITE:
                continue
            for changed in edits(part):
                yield (tag, *parts[:n], changed, *parts[n + 1 :])
    elif isinstance(tree, int):
        yield tree + 1
        if tree > 2:
            yield tree - 1


def cases(count: int, seed: int = 0) -> Iterator[Case]:
    """Identities and near misses in turn, as many of each, all families alike."""
    rng = random.Random(seed)
    with mp.workdps(DIGITS):
        for n in range(count):
            family = list(IDENTITIES)[n % len(IDENTITIES)]
            yield _case(rng, family, true=True)
            yield _case(rng, family, true=False)


def _case(rng: random.Random, family: str, true: bool) -> Case:
    while True:
        left, right, given = rng.choice(IDENTITIES[family])
        by = dict(zip((A, B, C), rng.sample(TERMS, 3), strict=True))
        left, right = substituted(left, by), substituted(right, by)
        if rng.random() < 0.3 and family not in ("vectors", "matrices", "rotations"):
            extra = rng.choice(["q", times(2, "q"), power("q", 2)])
            left, right = rng.choice(
                [(plus(left, extra), plus(right, extra)), (times(extra, left), times(extra, right))]
            )
        if rng.random() < 0.3:
            left, right = right, left
        if not true:
            slips = [(new, right) for new in edits(left)] + [(left, new) for new in edits(right)]
            if not slips:
                continue
            left, right = rng.choice(slips)
        if agree(rng, left, right) is true:
            printer = Printer(rng)
            relation = f"{printer.text(left)[0]} = {printer.text(right)[0]}"
            letters_ = tuple((x, MEANT[x]) for x in MEANT if f"{x}_{{" in relation and family == "special functions")
            return Case(
                family, relation, tuple(x for each in given for x in GIVEN[each].split("; ")), true, (), letters_
            )


def pairs() -> Iterator[tuple[Case, Case]]:
    """Relations that were typed by hand, true and with a slip, by the parts of the handbook."""
    part = ""
    for line in Path(__file__).with_name("handbook_pairs.txt").read_text(encoding="utf-8").splitlines()[1:]:
        if line.startswith("## "):
            part = line[3:]
        elif line:
            right, wrong, *said = line.split(" @ ")
            given, where, meant = (tuple(text.split("; ")) if text else () for text in (*said, "", "", "")[:3])
            letters_ = tuple((x, what) for each in meant for x, _, what in [each.partition(": ")])
            yield Case(part, right, given, True, where, letters_), Case(part, wrong, given, False, where, letters_)
