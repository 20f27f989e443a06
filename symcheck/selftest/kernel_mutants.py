"""Every single-token mutant of a generated kernel: a constant, an operator, a function, an operand of the same kind.

A mutant with the right values counts as equivalent if a proof says so: both are run on symbols, and the
expressions that come out are compared.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import sympy as sp

from symcheck.kernels.codegen.expression import MATH
from symcheck.kernels.codegen.program import UNARY, order_of
from symcheck.kernels.codegen.special import RUNTIME
from symcheck.selftest.kernel_truth import Case, Truth

BINARY = ("add", "subtract", "multiply", "divide")
OPERATORS = (ast.Add, ast.Sub, ast.Mult, ast.Div)
SYMBOLIC: dict[str, Callable[..., Any]] = {
    "sin": sp.sin,
    "cos": sp.cos,
    "tan": sp.tan,
    "exp": sp.exp,
    "log": sp.log,
    "sqrt": sp.sqrt,
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
SYMBOLIC_MATH = SimpleNamespace(pi=sp.pi, e=sp.E, **{MATH.get(name, name): x for name, x in SYMBOLIC.items()})
OF_MATH = {name: function for function, name in MATH.items()}
UFUNCS = {name: ufunc for name, ufunc in vars(np).items() if name in SYMBOLIC}
EXPRESSION, CALLED, IN_PLACE, FEW = "expression", "call", "block", "block for few"


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
    """The expression of a kernel, its call on numbers and its blocks, as trees of which one token can be changed."""

    def __init__(self, case: Case) -> None:
        self.case = case
        formulas, ways = ({**_functions(ast.parse(text))} for text in case.texts)
        (call,) = _functions(ways[case.name]).values()
        (attempt,) = [node for node in ast.walk(call) if isinstance(node, ast.Try)]
        call.body = attempt.body  # without arrays, and the way out for what `math` does not take
        formulas[case.name].decorator_list = []
        trees = {
            EXPRESSION: formulas[case.name],
            CALLED: call,
            IN_PLACE: ways[f"_{case.name}"],
            FEW: ways.get(f"_{case.name}_few"),
        }
        self._trees = {form: tree for form, tree in trees.items() if tree}
        self._inputs = [argument.name for argument in case.kernel.arguments]
        self._order = order_of(case.compiled.program)

    @property
    def forms(self) -> list[str]:
        """What a kernel has; one whose angles are not acute has one block for all sizes."""
        return list(self._trees)

    def mutants(self) -> Iterator[Mutant]:
        """All mutants; the trees stand as they are."""
        for form, tree in self._trees.items():
            known = [argument.arg for argument in tree.args.args] if form in (IN_PLACE, FEW) else list(self._inputs)
            for statement in (*tree.args.defaults, *tree.body):
                line = ast.unparse(statement)
                for node, field, value in _changes(statement, known):
                    yield Mutant(form, line, node, field, value)
                if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
                    known += [statement.targets[0].id] if statement.targets[0].id not in known else []

    def survives(self, mutant: Mutant, truth: Truth) -> bool:
        """Whether the values at some points are right with a mutant's token."""
        with _applied(mutant):
            return self.right(mutant.form, truth)

    def right(self, form: str, truth: Truth) -> bool:
        """Whether a form as it stands gives the values at some points, and leaves these as they are."""
        inputs = [x.copy() for x in truth.points]
        with np.errstate(all="ignore"):
            try:
                function = self._compiled(form, {**UFUNCS, **self.case.ways, "formula": self.case.function})
                results = [*self._results(form, function, inputs)]
            except (ArithmeticError, AttributeError, NameError, TypeError, ValueError):
                return False
        kept = all(np.array_equal(x, y) for x, y in zip(inputs, truth.points, strict=True))
        return kept and all((truth.error(result) <= self.case.kernel.ulp).all() for result in results)

    def equivalent(self, mutant: Mutant) -> bool:
        """Whether the mutant means what the kernel means, for all arguments."""
        with _applied(mutant):
            changed = self._meaning(mutant.form)
        return all(sp.expand(x - y) == 0 for x, y in zip(changed, self._meaning(mutant.form), strict=True))

    def _results(self, form: str, function: Any, inputs: list[Any]) -> Iterator[Sequence[Any]]:
        """The outputs at some points, of a block in its own arrays and in given ones."""
        if form in (EXPRESSION, CALLED):
            rows = [np.atleast_1d(function(*point)) for point in zip(*(x.tolist() for x in inputs), strict=True)]
            yield list(np.array(rows).T)
            return
        yield [np.broadcast_to(np.asarray(x, float), inputs[0].shape) for x in _as_tuple(function(*inputs))]
        rows = [np.full(inputs[0].shape, np.nan) for _ in self._rows(form)]
        function(*inputs, *rows)
        yield [rows[k] for k in self._order]

    def _rows(self, form: str) -> list[str]:
        """The arrays that a block writes; the numbers stand behind them."""
        arguments = self._trees[form].args
        own = zip(arguments.args[len(self._inputs) :], arguments.defaults, strict=True)
        return [name.arg for name, value in own if isinstance(value, ast.Constant)]

    def _meaning(self, form: str) -> list[Any]:
        """The outputs of one form as expressions of the arguments."""
        symbols = [sp.Symbol(argument.name, real=True) for argument in self.case.kernel.arguments]
        space: dict[str, Any] = SYMBOLIC | {"math": SYMBOLIC_MATH, "array": lambda x: x}
        if form in (EXPRESSION, CALLED):
            space["formula"] = self._compiled(EXPRESSION, space)
            return [_exact(x) for x in _as_tuple(self._compiled(form, space)(*symbols))]
        rows = [_Row(sp.Symbol(f"before_{name}")) for name in self._rows(form)]
        written = {name: partial(_written, function) for name, function in SYMBOLIC.items()}
        results = _as_tuple(self._compiled(form, space | written)(*map(_Row, symbols), *rows))
        return [_exact(_held(x)) for x in (*results, *(rows[k] for k in self._order))]

    def _compiled(self, form: str, space: dict[str, Any]) -> Any:
        tree = self._trees[form]
        # A mutant is a syntax tree of our own, which nothing but a module runs.
        exec(compile(ast.Module([tree], []), self.case.id, "exec"), space)
        return space[tree.name]


class _Row:
    """A register that holds an expression."""

    def __init__(self, value: Any) -> None:
        self.value = value


def _written(function: Callable[..., Any], *operands: Any) -> Any:
    """A call on registers, of which the last is written, or on expressions."""
    if not isinstance(operands[-1], _Row):
        return function(*operands)
    operands[-1].value = function(*map(_held, operands[:-1]))
    return operands[-1]


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


def _functions(tree: ast.Module | ast.FunctionDef) -> dict[str, ast.FunctionDef]:
    """The functions that are defined in a module or a function, by name."""
    return {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}


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
            others = (
                ["e"] if node.attr == "pi" else [MATH.get(x, x) for x in _others(OF_MATH.get(node.attr, node.attr))]
            )
            yield from ((node, "attr", name) for name in others if hasattr(math, name))
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


def _as_tuple(results: Any) -> tuple[Any, ...]:
    return results if isinstance(results, tuple) else (results,)


def _held(x: Any) -> Any:
    return x.value if isinstance(x, _Row) else x


def _exact(x: Any) -> Any:
    return sp.nsimplify(x, rational=True)
