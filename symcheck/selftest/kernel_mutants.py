"""Every single-token mutant of a generated kernel: a constant, an operator, a function, an operand of the same kind.

A mutant runs on numbers, and on arrays as the runtime makes of it. One with the right values counts as equivalent if a
proof says so: it is run on symbols, and the expressions that come out are compared.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np
import sympy as sp

from symcheck.kernels import ratios
from symcheck.kernels.codegen.program import UNARY
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.kernels.planning import Plan
from symcheck.kernels.runtime import DOUBLE
from symcheck.kernels.tracing import MATH, trace
from symcheck.selftest.kernel_truth import Case, Truth

OPERATORS = (ast.Add, ast.Sub, ast.Mult, ast.Div)
SYMBOLIC: dict[str, Callable[..., Any]] = {
    "sin": sp.sin,
    "cos": sp.cos,
    "tan": sp.tan,
    "exp": sp.exp,
    "log": sp.log,
    "sqrt": sp.sqrt,
    **{name: sp.Function(name) for name in RUNTIME},
    "atan": sp.atan,
    "expm1": lambda x: sp.exp(x) - 1,
    "log1p": lambda x: sp.log(1 + x),
    "pow": lambda x, y: x**y,
}
CONSTANTS = {"pi": sp.pi, "e": sp.E}
FLOATS: dict[str, Any] = {name: getattr(ratios if name in RUNTIME else math, name) for name in (*SYMBOLIC, *CONSTANTS)}
ONE = [MATH.get(name, name) for name in UNARY] + [name for name in RUNTIME if name != "gamma_ratio"]  # of one operand
EXPRESSION, MANY = "formula", "formula for many points"


class Mutant(NamedTuple):
    """One token of one form of a kernel, changed: the field of a node gets another value."""

    form: str
    line: str
    node: Any
    field: str
    value: Any

    def __str__(self) -> str:
        return f"{self.form}: {self.line!r} with {_token(vars(self.node)[self.field])} -> {_token(self.value)}"


class Forms:
    """The formulas of a kernel as trees of which one token can be changed."""

    def __init__(self, case: Case) -> None:
        self.case = case
        functions = {node.name: node for node in ast.parse(case.text).body if isinstance(node, ast.FunctionDef)}
        trees = {EXPRESSION: functions[case.name], MANY: functions.get(f"_{case.name}")}
        self._trees = {form: tree for form, tree in trees.items() if tree}
        for tree in self._trees.values():
            tree.decorator_list = []
            del tree.body[0]  # the docstring
        self._inputs = [argument.name for argument in case.kernel.arguments]

    @property
    def forms(self) -> list[str]:
        """What a kernel has; one whose angles are not acute has one formula for any number of points."""
        return list(self._trees)

    def mutants(self) -> Iterator[Mutant]:
        """All mutants; the trees stand as they are."""
        for form, tree in self._trees.items():
            known = list(self._inputs)
            for statement in tree.body:
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
                results = self._results(self._compiled(form, FLOATS), inputs)
                right = all((truth.error(result) <= self.case.kernel.ulp).all() for result in results)
            except (ArithmeticError, AttributeError, NameError, TypeError, ValueError):
                return False
        return right and all(np.array_equal(x, y) for x, y in zip(inputs, truth.points, strict=True))

    def equivalent(self, mutant: Mutant) -> bool:
        """Whether the mutant means what the kernel means, for all arguments."""
        with _applied(mutant):
            changed = self._meaning(mutant.form)
        return all(sp.expand(x - y) == 0 for x, y in zip(changed, self._meaning(mutant.form), strict=True))

    def _results(self, function: Any, inputs: list[Any]) -> Iterator[Sequence[Any]]:
        """The outputs at some points, one by one and as arrays."""
        rows = [np.atleast_1d(function(*point)) for point in zip(*(x.tolist() for x in inputs), strict=True)]
        yield list(np.array(rows).T)
        found = Plan(trace(function), (1,) * len(inputs), 1, DOUBLE, self.case.name)
        yield _as_tuple(found.whole(*inputs))

    def _meaning(self, form: str) -> list[Any]:
        """The outputs of one form as expressions of the arguments."""
        symbols = [sp.Symbol(argument.name, real=True) for argument in self.case.kernel.arguments]
        found = self._compiled(form, SYMBOLIC | CONSTANTS)(*symbols)
        return [sp.nsimplify(x, rational=True) for x in _as_tuple(found)]

    def _compiled(self, form: str, names: Mapping[str, Any]) -> Any:
        tree, space = self._trees[form], {**names}
        # A mutant is a syntax tree of our own, which nothing but a module runs.
        exec(compile(ast.Module([tree], []), self.case.id, "exec"), space)
        return space[tree.name]


@contextmanager
def _applied(mutant: Mutant) -> Iterator[None]:
    """The tree with the mutant's token, put back afterwards."""
    fields = vars(mutant.node)
    old = fields[mutant.field]
    fields[mutant.field] = mutant.value
    try:
        yield
    finally:
        fields[mutant.field] = old


def _changes(statement: Any, known: list[str]) -> Iterator[tuple[Any, str, Any]]:
    called = {id(node.func) for node in ast.walk(statement) if isinstance(node, ast.Call)}
    for node in ast.walk(statement):
        if isinstance(node, ast.Constant) and isinstance(node.value, float):
            yield from ((node, "value", value) for value in (node.value + 1, 2 * node.value) if value != node.value)
        elif isinstance(node, ast.BinOp):
            yield from ((node, "op", kind()) for kind in OPERATORS if not isinstance(node.op, kind))
        elif isinstance(node, ast.UnaryOp):
            yield node, "op", ast.UAdd()
        elif isinstance(node, ast.Name) and node.id in CONSTANTS:
            yield from ((node, "id", name) for name in CONSTANTS if name != node.id)
        elif isinstance(node, ast.Name) and id(node) in called:
            yield from ((node, "id", name) for name in ONE if node.id in ONE and name != node.id)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in known:
            yield from ((node, "id", name) for name in known if name != node.id)


def _token(value: Any) -> str:
    return type(value).__name__ if isinstance(value, ast.AST) else str(value)


def _as_tuple(results: Any) -> tuple[Any, ...]:
    return results if isinstance(results, tuple) else (results,)
