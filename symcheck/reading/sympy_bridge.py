"""Terms to SymPy expressions and back, exactly; SymPy is imported only when one of these is called."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Binder, Call, Term, node
from symcheck.core.verdicts import SymcheckError

if TYPE_CHECKING:
    from sympy import Expr


_FUNCTIONS = {name: name for name in ("sin", "cos", "tan", "sqrt", "exp", "log", "gamma")}
_FUNCTIONS |= {"arctan": "atan", "arcsin": "asin", "arccos": "acos"}
_TERMS = {sympy_name: name for name, sympy_name in _FUNCTIONS.items()}


def to_sympy(term: Term) -> Expr:
    """Turn a term into an expression of SymPy.

    Parameters
    ----------
    term
        The term.

    Returns
    -------
    sympy.Expr
        The expression over real symbols, which SymPy evaluates as it always does.

    See Also
    --------
    from_sympy : The other way.
    """
    import sympy

    if isinstance(term, int):
        return sympy.Integer(term)
    if isinstance(term, str):
        return sympy.Symbol(term, real=True)
    if term in (PI, INFINITY, MINUS_INFINITY):
        return {PI: sympy.pi, INFINITY: sympy.oo, MINUS_INFINITY: -sympy.oo}[term]
    operator = term.tag
    if isinstance(term, Call):
        return _applied(term.function, term.orders, *term.terms)
    if isinstance(term, Binder):
        variable, body = sympy.Symbol(term.letter, real=True), to_sympy(term.body)
        if operator == "diff":
            order, place = term.outside
            slope = _derivative(body, variable, int(str(order)))
            return slope if place == term.letter else slope.subs(variable, to_sympy(place))
        if operator == "integral":
            return sympy.Integral(body, (variable, *map(to_sympy, term.outside)))
        if operator == "mean":
            return sympy.Function("mean")(body, variable)
    values = [to_sympy(argument) for argument in term.terms]
    if operator == "^":
        return values[0] ** values[1]
    if operator == "pow":
        return values[0] ** values[1]
    if operator == "+":
        return sympy.Add(*values)
    if operator == "*":
        return sympy.Mul(*values)
    if operator == "-" and len(values) == 1:
        return -values[0]
    if operator == "/":
        return values[0] / values[1]
    if operator in _FUNCTIONS:
        result: Expr = getattr(sympy, _FUNCTIONS[operator])(values[0])
        return result
    raise SymcheckError(f"the term {term!r} has the unknown operator {operator!r}")


def _applied(name: str, orders: tuple[int, ...], *arguments: Term) -> Expr:
    """An undefined function, or a derivative of it, at its arguments."""
    import sympy

    function, values = sympy.Function(name, real=True), [to_sympy(argument) for argument in arguments]
    if not any(orders):
        found: Expr = function(*values)
        return found
    places = [sympy.Dummy(f"place_{k}", real=True) for k in range(len(values))]
    by = [(place, order) for place, order in zip(places, orders, strict=True) if order]
    slope = sympy.Derivative(function(*places), *by)
    if len(set(values)) == len(values) and all(value.is_Symbol for value in values):
        return slope.xreplace(dict(zip(places, values, strict=True)))
    return sympy.Subs(slope, tuple(places), tuple(values))


def _derivative(body: Expr, variable: Expr, order: int) -> Expr:
    """The derivative taken, or left standing where the body is a bare name that may depend on the variable."""
    import sympy

    if isinstance(body, sympy.Symbol) and body != variable:
        return sympy.Derivative(sympy.Function(body.name, real=True)(variable), (variable, order))
    result: Expr = sympy.diff(body, variable, order)
    return result


def from_sympy(expr: Expr) -> Term:
    """Turn an expression of SymPy into a term.

    Parameters
    ----------
    expr
        The expression.

    Returns
    -------
    Term
        The term.

    Raises
    ------
    SymcheckError
        If there is no exact term, as for floating-point numbers.

    See Also
    --------
    to_sympy : The other way.
    """
    import sympy
    from sympy.core.function import AppliedUndef

    expr = sympy.sympify(expr)
    if isinstance(expr, sympy.Integer):
        value = int(expr)
        return value if value >= 0 else node("-", -value)
    if isinstance(expr, sympy.Rational):
        top: Term = abs(int(expr.p))
        quotient = node("/", top, int(expr.q))
        return quotient if expr.p > 0 else node("-", quotient)
    if isinstance(expr, sympy.Symbol):
        return str(expr.name)
    if expr == sympy.pi:
        return PI
    if isinstance(expr, sympy.Derivative | sympy.Subs | AppliedUndef) and (applied := _call(expr)):
        return applied
    if isinstance(expr, sympy.Add):
        return node("+", *(from_sympy(term) for term in expr.as_ordered_terms()))
    if isinstance(expr, sympy.Mul):
        return _product(expr)
    if isinstance(expr, sympy.Pow):
        return _power(expr)
    if type(expr).__name__ in _TERMS:
        return node(_TERMS[type(expr).__name__], from_sympy(expr.args[0]))
    if type(expr).__name__ == "mean":
        return node("mean", *(from_sympy(part) for part in expr.args))
    if isinstance(expr, sympy.Integral) and len(expr.limits) == 1 and len(expr.limits[0]) == 3:
        variable, *bounds = expr.limits[0]
        return node("integral", from_sympy(expr.function), str(variable), *(_bound(bound) for bound in bounds))
    raise SymcheckError(f"{expr} has no exact term; only rational expressions, powers and elementary functions have")


def _call(expr: Expr) -> Term | None:
    """The term of an undefined function, or of its derivatives by its arguments; None for other derivatives."""
    import sympy
    from sympy.core.function import AppliedUndef

    at: dict[Expr, Expr] = {}
    if isinstance(expr, sympy.Subs):
        at, expr = dict(zip(expr.variables, expr.point, strict=True)), expr.expr
    counts: dict[Expr, int] = {}
    if isinstance(expr, sympy.Derivative):
        counts, expr = {by: int(order) for by, order in expr.variable_count}, expr.expr
    if not isinstance(expr, AppliedUndef) or expr.func.__name__ == "mean":
        return None
    if any(expr.args.count(by) != 1 for by in counts):
        return None
    orders = tuple(counts.get(argument, 0) for argument in expr.args)
    return node("call", expr.func.__name__, orders, *(from_sympy(argument.xreplace(at)) for argument in expr.args))


def _bound(expr: Expr) -> Term:
    import sympy

    if expr == sympy.oo:
        return INFINITY
    return MINUS_INFINITY if expr == -sympy.oo else from_sympy(expr)


def _product(expr: Expr) -> Term:
    import sympy

    sign, factors = "", list(expr.args)
    if factors[0].is_Rational and factors[0] < 0:
        sign, factors[0] = "-", -factors[0]
        factors = [factor for factor in factors if factor != sympy.S.One]
    terms = [from_sympy(factor) for factor in factors]
    product: Term = terms[0] if len(terms) == 1 else node("*", *terms)
    return node("-", product) if sign else product


def _power(expr: Expr) -> Term:
    import sympy

    base, exponent = expr.args
    if isinstance(exponent, sympy.Integer):
        value = int(exponent)
        return node("^", from_sympy(base), value) if value > 0 else node("/", 1, _positive_power(base, -value))
    if isinstance(exponent, sympy.Rational) and exponent.q == 2:
        root: Term = node("sqrt", from_sympy(base))
        power: Term = root if abs(exponent.p) == 1 else node("^", root, abs(int(exponent.p)))
        return power if exponent.p > 0 else node("/", 1, power)
    return node("pow", from_sympy(base), from_sympy(exponent))


def _positive_power(base: Expr, exponent: int) -> Term:
    return from_sympy(base) if exponent == 1 else node("^", from_sympy(base), exponent)
