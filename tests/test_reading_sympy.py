"""Terms and SymPy expressions say the same."""

from __future__ import annotations

import subprocess
import sys

import pytest
import sympy
from reading_samples import NOTATION

from symcheck.core.terms import node
from symcheck.core.verdicts import SymcheckError
from symcheck.reading import from_sympy, term, to_sympy

x, y = sympy.symbols("x y", real=True)
EXPRESSIONS = [
    sympy.Integer(-3),
    sympy.Rational(-2, 7),
    x + 2 * y - 1,
    -x * y / 3,
    (x - y) ** 3 / (x + y) ** 2,
    1 / x,
    sympy.sqrt(3) * x / 2,
    1 / sympy.sqrt(2),
    sympy.sin(2 * x) * sympy.cos(x - y) + sympy.tan(x),
    sympy.pi / 4,
    sympy.sqrt(sympy.Rational(2, 3)),
    sympy.exp(x) * sympy.log(y**2 + 1) + sympy.atan(x),
    sympy.sqrt(x**2 + 1) / sympy.sqrt(y**2 + 3),
    (x**2 + 1) ** (y / 2) * sympy.gamma(y**2 + 1),
    sympy.Integral(sympy.exp(-(x**2)), (x, -sympy.oo, sympy.oo)) * y,
    sympy.Integral(x**2, (x, 0, y)),
    sympy.Function("mean")(x * sympy.sin(y), y),
]


@pytest.mark.parametrize("expr", EXPRESSIONS, ids=str)
def test_an_expression_survives_the_way_to_a_term_and_back(expr):
    assert sympy.simplify(to_sympy(from_sympy(expr)) - expr) == 0


TERMS = [
    r"\int_0^\infty c^k \exp(-c) \, dc",
    r"\langle c \sin \alpha \rangle_\alpha + \Gamma(k) \operatorname{arctg} c",
    *[r"\frac{3}{4} (3c - J_2)(c - J_2)", r"\sin 2\alpha - \operatorname{tg} \beta", r"\sqrt{3} c^{-2}", "-0.75 k"],
]


@pytest.mark.parametrize("latex", TERMS)
def test_a_term_survives_the_way_to_sympy_and_back(latex):
    expr = to_sympy(term(latex, NOTATION))
    assert to_sympy(from_sympy(expr)) == expr


def test_symbols_are_real_and_named_as_the_variables():
    assert to_sympy("a_12") == sympy.Symbol("a_12", real=True)
    assert to_sympy(node("diff", node("^", "c", 3), "c", 2, "c")) == 6 * sympy.Symbol("c", real=True)


INEXACT = [sympy.Float("0.5"), sympy.erf(x), sympy.I, sympy.oo, sympy.Integral(x, x)]


@pytest.mark.parametrize("expr", INEXACT, ids=str)
def test_what_has_no_exact_term_is_an_error(expr):
    with pytest.raises(SymcheckError, match="no exact term"):
        from_sympy(expr)


def test_reading_a_formula_does_not_import_sympy():
    code = (
        "import sys; from symcheck.reading import *;"
        "n = Notation([Letter('x')]); lower(read('x = 1', n), n); print('sympy' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
