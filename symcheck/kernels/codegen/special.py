"""Powers and gamma functions without loss of digits, and without infinities between finite values.

(1 + x)^y is exp(x y log(1 + x)/x): where x is small and y is large, 1 + x keeps nothing of x, while x y is of ordinary
size; letters that x and y share cancel in it. From a power 1 is taken by expm1. Gamma functions come in quotients,
Gamma(x + h)/Gamma(x) = x^h gamma_ratio(x, h), where the last factor tends to 1 as x grows; x^h is simplified with the
factors beside it. Functions named here are those of NumPy and of `symcheck.kernels.ratios`.
"""

from __future__ import annotations

from typing import Any

from symcheck.core.lazy import lazy

sp = lazy("sympy")

RUNTIME = ("expm1_ratio", "gamma_ratio", "log1p_ratio")


def stable(e: Any) -> Any:
    """The expression with its powers, its differences of a power and 1, and its gamma functions rewritten."""
    if e.is_Mul:
        e = _without_gamma_quotients(_without_growth(e))
    if e.is_Add and (growth := _growth(e)):
        sign, exponent = growth
        return sign * sp.Function("expm1")(stable(exponent))
    if e.is_Pow and (exponent := _exponent(e)) is not None:
        return sp.exp(stable(exponent))
    if e.is_Pow and not e.exp.is_Rational and any(x.is_Pow and x.exp.is_even for x in sp.Mul.make_args(e.base)):
        return sp.Pow(stable(sp.sqrt(e.base)), stable(2 * e.exp), evaluate=False)
    if isinstance(e, sp.log) and (x := _beyond_one(e.args[0])) is not None:
        return sp.Function("log1p")(stable(x))
    if isinstance(e, sp.gamma):
        return sp.Function("gamma_ratio")(sp.Integer(1), stable(e.args[0] - 1))
    return e.func(*map(stable, e.args)) if e.args else e


def _beyond_one(e: Any) -> Any:
    """x, if the expression is 1 + x."""
    one, x = e.as_coeff_Add()
    return x if one == 1 and x != 0 else None


def _exponent(power: Any) -> Any:
    """y log(1 + x), if the expression is (1 + x)^y and y is not a number."""
    x, y = _beyond_one(power.base), power.exp
    if x is None or y.is_Rational:
        return None
    if not x.free_symbols & y.free_symbols:
        return y * sp.Function("log1p")(x)
    return sp.factor(sp.cancel(x * y)) * sp.Function("log1p_ratio")(x)


def _growth(e: Any) -> tuple[int, Any] | None:
    """(1, E) of exp E - 1 and (-1, E) of 1 - exp E, for a power exp E of 1 + x."""
    if len(e.args) == 2 and abs(e.args[0]) == 1:
        sign, power = -int(e.args[0]), e.args[1] * -int(e.args[0])
        if power.is_Pow and (exponent := _exponent(power)) is not None:
            return sign, exponent
    return None


def _without_growth(e: Any) -> Any:
    """A factor exp E - 1, or a power of it, as expm1_ratio(E) E, so that E can be simplified with the other factors."""
    for factor in e.args:
        base, exponent = factor.as_base_exp()
        if base.is_Add and (growth := _growth(base)):
            sign, inside = growth
            shown = inside.replace(sp.Function("log1p"), lambda x: sp.log(1 + x))
            ratio = sp.Function("expm1_ratio")(inside) ** exponent
            others = sp.Mul(*(x for x in e.args if x is not factor))
            return sp.powsimp(others * (sign * shown) ** exponent, combine="base") * ratio
    return e


def _without_gamma_quotients(e: Any) -> Any:
    """Each quotient of two gamma functions in a product as a ratio, by the smallest differences of their arguments."""
    above = [factor.args[0] for factor in e.args if isinstance(factor, sp.gamma)]
    below = [1 / factor for factor in e.args if factor.is_Pow and factor.exp == -1]
    for x in (each.args[0] for each in below if isinstance(each, sp.gamma)):
        distances = sorted(((sp.count_ops(h := sp.expand(u - x)), u, h) for u in above), key=lambda each: each[0])
        if distances:
            _, u, h = distances[0]
            above.remove(u)
            positive = sp.Dummy(positive=True)  # as x is, which makes (c x)^h of c^h x^h
            rest = sp.powsimp(e * sp.gamma(x) / sp.gamma(u) * positive**h, combine="base").subs(positive, x)
            e = rest * sp.Function("gamma_ratio")(x, h)
    return e
