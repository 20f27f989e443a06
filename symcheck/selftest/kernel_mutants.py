"""Every single-token mutant of a generated kernel: a constant, an operator, a function, an operand of the same kind.

A mutant that gives the right values is told from a proof that it means the same: both are run on symbols, and the
expressions that come out are compared.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any, ClassVar, NamedTuple

import numpy as np
import sympy as sp

from symcheck.codegen.program import UNARY
from symcheck.codegen.special import RUNTIME
from symcheck.selftest.kernel_truth import Case, Truth

BINARY = ("add", "subtract", "multiply", "divide")
OPERATORS = (ast.Add, ast.Sub, ast.Mult, ast.Div)
SYMBOLIC: dict[str, Callable[..., Any]] = {
    **{name: getattr(sp, name) for name in ("sin", "cos", "tan", "exp", "log", "sqrt")},
    **{name: sp.Function(name) for name in RUNTIME},
    "arctan": sp.atan,
    "expm1": lambda x: sp.exp(x) - 1,
    "log1p": lambda x: sp.log(1 + x),
    "add": lambda x, y: x + y,
    "subtract": lambda x, y: x - y,
    "multiply": lambda x, y: x * y,
    "divide": lambda x, y: x / y,
    "power": lambda x, y: x**y,
    "negative": lambda x: -x,
    "positive": lambda x: x,
}
UFUNCS = {name: getattr(np, name) for name in SYMBOLIC if hasattr(np, name)}
EXPRESSION, IN_PLACE, NUMBERS = "expression", "block", "numbers"


class Mutant(NamedTuple):
    """One token of one form of a kernel, changed: the field of a node gets another value."""

    form: str
    line: str
    node: Any
    field: str
    value: Any

    def __str__(self) -> str:
        return f"{self.form}: {self.line!r} with {_token(getattr(self.node, self.field))} -> {_token(self.value)}"


class Forms:
    """The expression of a kernel, its call on numbers and its block, as trees of which one token can be changed."""

    def __init__(self, case: Case) -> None:
        self.case = case
        functions = {node.name: node for node in ast.parse(case.text).body if isinstance(node, ast.FunctionDef)}
        whole = functions[case.name]
        (attempt,) = [node for node in ast.walk(whole) if isinstance(node, ast.Try)]
        whole.body = attempt.body  # without the way out for what `math` does not take
        forms = (EXPRESSION, f"_{case.name}"), (IN_PLACE, f"_{case.name}_block"), (NUMBERS, case.name)
        self._trees = {form: functions[name] for form, name in forms}
        self._inputs = [argument.name for argument in case.kernel.arguments]
        values = list(case.made.program.outputs.values())
        firsts = list(dict.fromkeys(values))
        self._order = [firsts.index(value) for value in values]

    def mutants(self) -> Iterator[Mutant]:
        """All mutants; the trees stand as they are."""
        for form, tree in self._trees.items():
            known = [each.arg for each in tree.args.args] if form == IN_PLACE else list(self._inputs)
            for statement in (*tree.args.defaults, *tree.body):
                line = ast.unparse(statement)
                for node, field, value in _changes(statement, known):
                    yield Mutant(form, line, node, field, value)
                if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
                    known.append(statement.targets[0].id)

    def survives(self, mutant: Mutant, truth: Truth) -> bool:
        """Whether the values at some points are right with a mutant's token."""
        with _applied(mutant):
            return self.right(mutant.form, truth)

    def right(self, form: str, truth: Truth) -> bool:
        """Whether a form as it stands gives the values at some points, and leaves these as they are."""
        inputs = [x.copy() for x in truth.points]
        with np.errstate(all="ignore"):
            try:
                function = self._compiled(form, UFUNCS | self.case.module)
                results = self._runs[form](self, function, inputs)
            except (ArithmeticError, AttributeError, NameError, TypeError, ValueError):
                return False
        kept = all(np.array_equal(x, y) for x, y in zip(inputs, truth.points, strict=True))
        return kept and bool((truth.error(results) <= self.case.kernel.ulp).all())

    def equivalent(self, mutant: Mutant) -> bool:
        """Whether the mutant means what the kernel means, for all arguments."""
        with _applied(mutant):
            changed = self._meaning(mutant.form)
        return all(sp.expand(x - y) == 0 for x, y in zip(changed, self._meaning(mutant.form), strict=True))

    def _expression(self, function: Any, inputs: list[Any]) -> list[Any]:
        results = function(*inputs)
        values = results if isinstance(results, tuple) else (results,)
        return [np.broadcast_to(value, inputs[0].shape) for value in values]

    def _block(self, function: Any, inputs: list[Any]) -> list[Any]:
        rows = [np.full(inputs[0].shape, np.nan) for _ in self._trees[IN_PLACE].args.args[len(inputs) :]]
        function(*inputs, *rows)
        return [rows[k] for k in self._order]

    def _numbers(self, function: Any, inputs: list[Any]) -> list[Any]:
        rows = [np.atleast_1d(function(*point)) for point in zip(*(x.tolist() for x in inputs), strict=True)]
        return list(np.array(rows).T)

    _runs: ClassVar[dict[str, Callable[..., list[Any]]]] = {
        EXPRESSION: _expression,
        IN_PLACE: _block,
        NUMBERS: _numbers,
    }

    def _meaning(self, form: str) -> list[Any]:
        """The outputs of one form as expressions of the arguments."""
        symbols = [sp.Symbol(argument.name, real=True) for argument in self.case.kernel.arguments]
        space: dict[str, Any] = SYMBOLIC | {"np": _Ufuncs(), "math": _Ufuncs()}
        if form != IN_PLACE:
            self._compiled(EXPRESSION, space)
            results = self._compiled(form, space)(*symbols)
            return [_exact(x) for x in (results if isinstance(results, tuple) else (results,))]
        later = [each.arg for each in self._trees[form].args.args[len(symbols) :]]
        rows = [_Row(sp.Symbol(f"before_{name}")) for name in later]
        written = {name: partial(_written, SYMBOLIC[name]) for name in RUNTIME}
        self._compiled(form, space | written)(*map(_Row, symbols), *rows)
        return [_exact(rows[k].value) for k in self._order]

    def _compiled(self, form: str, space: dict[str, Any]) -> Any:
        tree = self._trees[form]
        exec(compile(ast.Module([tree], []), self.case.id, "exec"), space)
        return space[tree.name]


class _Row:
    """A register that holds an expression."""

    def __init__(self, value: Any) -> None:
        self.value = value

    def __setitem__(self, everything: Any, value: Any) -> None:
        self.value = _held(value)


def _written(function: Callable[..., Any], *operands: Any) -> Any:
    """A call on registers, of which the last is written, or on expressions."""
    if not isinstance(operands[-1], _Row):
        return function(*operands)
    operands[-1].value = function(*map(_held, operands[:-1]))
    return None


class _Ufuncs:
    """NumPy and `math` for symbols."""

    pi, e = sp.pi, sp.E

    @staticmethod
    def array(x: Any) -> Any:
        return x

    def __getattr__(self, name: str) -> Callable[..., Any]:
        return partial(_written, SYMBOLIC[name])


@contextmanager
def _applied(mutant: Mutant) -> Iterator[None]:
    """The tree with the mutant's token, put back afterwards."""
    old = getattr(mutant.node, mutant.field)
    setattr(mutant.node, mutant.field, mutant.value)
    try:
        yield
    finally:
        setattr(mutant.node, mutant.field, old)


def _changes(statement: Any, known: list[str]) -> Iterator[tuple[Any, str, Any]]:
    called = {id(node.func) for node in ast.walk(statement) if isinstance(node, ast.Call)}
    for node in ast.walk(statement):
        if isinstance(node, ast.Constant) and isinstance(node.value, float):
            yield from ((node, "value", value) for value in (node.value + 1, 2 * node.value) if value != node.value)
        elif isinstance(node, ast.BinOp):
            yield from ((node, "op", kind()) for kind in OPERATORS if not isinstance(node.op, kind))
        elif isinstance(node, ast.UnaryOp):
            yield node, "op", ast.UAdd()
        elif isinstance(node, ast.Attribute):
            others = {"pi": ("e",), "array": ()}.get(node.attr, _others(node.attr))
            yield from ((node, "attr", name) for name in others)
        elif isinstance(node, ast.Name) and id(node) in called and node.id in SYMBOLIC:
            yield from ((node, "id", name) for name in _others(node.id))
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in known:
            yield from ((node, "id", name) for name in known if name != node.id)


def _others(function: str) -> list[str]:
    """Functions of as many operands."""
    if function in (*BINARY, "power"):
        return [name for name in BINARY if name != function]
    return [name for name in (*UNARY, "negative", "positive") if name != function and function != "gamma_ratio"]


def _token(value: Any) -> str:
    return type(value).__name__ if isinstance(value, ast.AST) else str(value)


def _held(x: Any) -> Any:
    return x.value if isinstance(x, _Row) else x


def _exact(x: Any) -> Any:
    return sp.nsimplify(x, rational=True)
