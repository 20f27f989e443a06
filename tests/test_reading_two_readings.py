"""What print leaves open: read where the field or the notation settles it, else refused with both readings."""

from __future__ import annotations

import pytest

from symcheck.core.terms import PI
from symcheck.core.verdicts import SymcheckError
from symcheck.reading import Letter, Notation, lower, read, term, to_latex

PLAIN = Notation(
    [
        *(Letter(index, kind="index") for index in "ij"),
        *(Letter(latex) for latex in ("x", "y", "z", "a", "b", "c", "k", "g", "A", "B", "C", "J", "K", r"\omega")),
        *(Letter(latex, depends="") for latex in ("t", "s", "h")),
        Letter("I", indices=1),
        Letter("f", kind="function"),
        Letter("d", kind="differential"),
        Letter(r"\mathbf{v}", kind="vector"),
    ]
)
MOVING = PLAIN.extended(
    Letter("r", depends="t"),
    Letter("q", indices=1, depends="t"),
    Letter("p", kind="function", depends="x"),
    Letter("u", kind="function", depends="s, t"),
    Letter("w", kind="function", depends="r, t"),
    Letter("U", kind="function", depends="r"),
    Letter("Y", depends="s"),
    Letter("l", indices=1, depends="q_i"),
    Letter("V", kind="function", depends="t"),
    Letter("N", named=True),
    Letter("M", kind="function", depends="t", named=True),
    Letter(r"\mathbf{R}", kind="vector", depends="t"),
    Letter(r"\mathbf{Q}", kind="vector", components="(q_1, q_2, q_3)"),
    Letter(r"\Psi", kind="function", depends=r"\mathbf{v}, t"),
)


def stated(latex: str, notation: Notation = MOVING) -> tuple[object, ...]:
    return lower(read(latex, notation), notation)


def call(name: str, *arguments: object, orders: tuple[int, ...] | None = None) -> tuple[object, ...]:
    return ("call", name, orders or (0,) * len(arguments), *arguments)


R, R1, R2 = (call("r", "t", orders=(n,)) for n in (0, 1, 2))
READ = {
    "f(x) - f(y)": ("+", call("f", "x"), ("-", call("f", "y"))),
    "f(x, y)": call("f", "x", "y"),
    "f(f(x + 1))": call("f", call("f", ("+", "x", 1))),
    "f^2(x)": ("^", call("f", "x"), 2),
    "f(x)^2": ("^", call("f", "x"), 2),
    "f'(x)": call("f", "x", orders=(1,)),
    "f''(2x)": call("f", ("*", 2, "x"), orders=(2,)),
    r"\frac{df(x)}{dx}": call("f", "x", orders=(1,)),
    r"\frac{\partial^2 f(x, y)}{\partial x \partial y}": call("f", "x", "y", orders=(1, 1)),
    r"\frac{d}{dx}(f(x)^2)": ("diff", ("^", call("f", "x"), 2), "x", 1, "x"),
    "r": R,
    "r(t)": R,
    "r^2(t)": ("^", R, 2),
    r"\dot r": R1,
    r"\dot{r}(t)": R1,
    r"\ddot{r}": R2,
    "r''": R2,
    r"\frac{dr}{dt}": R1,
    r"\frac{d^2 r}{dt^2}": R2,
    r"\frac{\mathrm{d} r}{\mathrm{d} t}": R1,
    r"\partial r/\partial t": R1,
    r"\frac{dr(t)}{dt}": R1,
    r"\dot q_2": call("q_2", "t", orders=(1,)),
    "q_2'": call("q_2", "t", orders=(1,)),
    "l_3": call("l_3", call("q_3", "t")),
    r"\frac{\partial u}{\partial t}": call("u", "s", "t", orders=(0, 1)),
    r"\frac{du}{dt}": call("u", "s", "t", orders=(0, 1)),
    r"\dot u": call("u", "s", "t", orders=(0, 1)),
    r"\frac{\partial^2 u}{\partial s^2}": call("u", "s", "t", orders=(2, 0)),
    "u(1, t)": call("u", 1, "t"),
    r"\frac{\partial w}{\partial t}": call("w", R, "t", orders=(0, 1)),
    r"\frac{dw}{dt}": ("diff", call("w", R, "t"), "t", 1, "t"),
    r"\frac{dU}{dt}": ("diff", call("U", R), "t", 1, "t"),
    r"\dot r \cdot (t + 1)": ("*", R1, ("+", "t", 1)),
    r"\int_0^1 r \, dt": ("integral", R, "t", 0, 1),
    r"\Psi(\mathbf{v}, 0)": call("Psi", "v_1", "v_2", "v_3", 0),
    "M(t) + M": ("+", "M", "M"),
    r"\frac{dN}{dt}": ("diff", "N", "t", 1, "t"),
    "h(x)": ("*", "h", "x"),
    "k(x + 1)": ("*", "k", ("+", "x", 1)),
    r"\sin(\omega)(x + 1)": ("*", ("sin", "omega"), ("+", "x", 1)),
    r"2 \cdot \frac12": ("*", 2, ("/", 1, 2)),
    r"2 \frac{x}{2}": ("*", 2, ("/", "x", 2)),
    r"\dot{V}(0) + V'(0)": ("+", call("V", 0, orders=(1,)), call("V", 0, orders=(1,))),
    "2^{(x + 1)}": ("pow", 2, ("+", "x", 1)),
}


@pytest.mark.parametrize("latex", READ)
def test_what_is_certain_is_read_with_all_its_arguments(latex):
    assert term(latex, MOVING) == READ[latex]
    tree = read(latex, MOVING)
    assert term(to_latex(tree), MOVING) == READ[latex]


def test_a_vector_that_depends_on_time_has_the_derivatives_of_its_components():
    rates = tuple(call(f"R_{n}", "t", orders=(1,)) for n in (1, 2, 3))
    assert stated(r"\dot{\mathbf{R}} = 0") == tuple(("=", rate, 0) for rate in rates)
    assert stated(r"\frac{d\mathbf{R}}{dt} = 0") == stated(r"\dot{\mathbf{R}} = 0")
    rates = tuple(call(f"q_{n}", "t", orders=(1,)) for n in (1, 2, 3))
    assert stated(r"\dot{\mathbf{Q}} = 0") == tuple(("=", rate, 0) for rate in rates)


REFUSED = {
    "0^0 = 1": "no value on which all agree",
    "[x] = 1": "the whole part of x, or idle brackets",
    "x^{[2]} = 1": "index, the order of a derivative, or a power",
    "f = 1": r"without its arguments.*depends='x'",
    r"\frac{df}{dx} = 0": "without its arguments",
    r"\frac{dz}{dt} = 0": r"does z depend on t\? declare z with depends='t' if it does, depends='' if it is constant",
    r"\frac{d}{dt}(r z) = 0": "does z depend on t",
    r"\frac{\partial}{\partial t}(u z) = 0": "does z depend on t",
    r"\frac{dp}{dt} = 0": "does x depend on t",
    r"\frac{\partial}{\partial t}(2 w) = 0": "held constant, or not",
    r"\int_0^1 z \, dt = z": "does z depend on t",
    r"\langle z \rangle_t = z": "does z depend on t",
    "N' = 0": "derivative of N, or another letter",
    "x' = 0": "derivative of x, or another letter.*depends",
    r"\dot z = 0": r"unknown letter \\dot\{z\}: declare it, or say on what z depends",
    r"\dot Y = 0": "no time",
    "u' = 0": "which depends on s, t; write a fraction",
    "f'(x, y) = 0": "by which argument",
    "f(x) = f(x, y)": "another number of arguments",
    "u(t) = 0": "u depends on s, t",
    "M(x) = 0": "known by its name, as a function of t",
    "f^{-1}(x) = 0": "inverse function of f, or its reciprocal",
    r"\sin^{-1} x = 0": "inverse function of sin, or its reciprocal",
    "f^{-1}(x)^2 = 0": "two powers",
    "g(x) = 0": r"of what is in these brackets, or times it\? declare g with kind='function', or with depends=''",
    "g(2x) = 0": "in these brackets, or times it",
    "g[x] = 0": "in these brackets, or times it",
    r"g\left(\frac{x}{2}\right) = 0": "in these brackets, or times it",
    "g(x, y, z) = 0": "in these brackets, or times it",
    "g(x)^2 = 0": "in these brackets, or times it",
    "I_1(x) = 0": "in these brackets, or times it",
    "r(t + 1) = 0": r"declare r with kind='function', or write \\cdot",
    r"\frac{dp}{dx}(0) = 1": "at the place in these brackets, or times it",
    r"\left(\frac{d}{dx}(x^2)\right)(1) = 2": "at the place in these brackets, or times it",
    "(p + 1)(x) = 1": "at the place in these brackets, or times it",
    "0 < x < y, z < 1": "two relations, or letters that lie between",
    "I_{02} = x": "zero before it",
    "x = 02": "zero before it",
    r"\frac{d'x^2}{dx} = x": "no primes",
    "f[x] = 0": "in these brackets, or times it",
    r"2\frac12 = x": "mixed number, or a product",
    "a^{(2)} = x": "an index, the order of a derivative, or a power",
    "a^{(k)} = x": "an index, the order of a derivative, or a power",
    "f^{(2)}(x) = 0": "an index, the order of a derivative, or a power",
    "(a + b)^{(2)} = 0": "an index, the order of a derivative, or a power",
    r"\cos a\,x = 1": r"argument of cos\?.*argument='short' \(it does not\) or 'long' \(it does\)",
    r"\cos a\ x = 1": "argument='short'",
    r"\sin\omega(t - x) = 1": "argument='short'",
    r"\sin\omega [t - x] = 1": "argument='short'",
    r"\sin a \frac{x}{2} = 1": "argument='short'",
    r"\sin 2(a + b) = 1": "does this factor belong to the argument of sin",
    r"A = 1 \Rightarrow B = 1 \Rightarrow C = 1": r"A \\Rightarrow \(B \\Rightarrow C\), or two",
    r"A = 1 \Leftrightarrow B = 1 \Rightarrow C = 1": r"beside \\Rightarrow is ambiguous",
    r"\exists x : x = 1 \Rightarrow y = 1": "for the premise alone or for the whole implication",
    r"J = x^2 \; K = y^2": "part two relations, or two factors",
    r"J = x^2 \ K = y^2": "part two relations, or two factors",
    r"x \quad y = 1": "part two things, or two factors",
    r"x = 1 \quad y": "says nothing",
    "A = B, C": "shares a relation.*only named",
    "A, B = C": "equal to this too, or only named",
    "0 < a, b": "says nothing",
    "a < x, y < b": "two relations, or letters that lie between",
    r"x < \pm y": "for one sign, or for both",
    r"x \in [0, \pm y]": "for one sign, or for both",
    r"x = \pm a, y = \mp b": "switch together",
    r"x = \pm a \Rightarrow y = \mp b": "switch together",
    r"x = a \pm b = c": "switch together",
    r"x = 9.81 \pm 0.02": "both signs, or the error of a measured value",
    r"I_{1,2} = a \pm b": "means several letters",
    r"\begin{cases} x & y > 0 \end{cases} = 1": "a value with its condition",
    "x = 1, i = 1, 2": "values are given for i, which does not occur",
    "I_i = 1, i = 1, 2, i = 3": "given twice",
    "1). x = 1; 3). x = 2": "not numbered",
    r"\mathbf{v} = (x, y, 0) \times (z, 0, 0)": "x is multiplied by 0",
    r"\mathbf{v}^T = (x, y, z)": "do not compare",
    r"\int_0^1 x \partial x = 1": "partial differential",
    r"\frac{\partial^2 f(x, y)}{\partial x \, dy} = 1": "differential",
    r"\|a_{ji}\| = 0": "unknown letter",
}


@pytest.mark.parametrize("latex", REFUSED)
def test_two_readings_are_refused_with_both(latex):
    with pytest.raises(SymcheckError, match=REFUSED[latex]):
        stated(latex)


def test_what_a_bracket_or_a_space_behind_an_argument_means_is_said_by_the_notation():
    short, long = (Notation(PLAIN.letters, argument=which) for which in ("short", "long"))
    assert term(r"\cos a\,x", short) == ("*", ("cos", "a"), "x")
    assert term(r"\cos a\,x", long) == ("cos", ("*", "a", "x"))
    assert term(r"\sin\omega(t - x)", short) == ("*", ("sin", "omega"), ("+", "t", ("-", "x")))
    assert term(r"\sin\omega(t - x)", long) == ("sin", ("*", "omega", ("+", "t", ("-", "x"))))
    assert short != long != PLAIN
    assert short.extended().argument == "short"
    with pytest.raises(SymcheckError, match="end 'none' of an argument"):
        Notation([], argument="none")


def test_a_superscript_in_brackets_may_be_part_of_a_declared_letter():
    notation = PLAIN.extended(Letter("a^{(2)}"), Letter("x^{(1)}", name="first", indices=1))
    assert term("a^{(2)} a^2", notation) == ("*", "a2", ("^", "a", 2))
    assert term("x^{(1)}_3", notation) == "first_3"
    assert read(to_latex(read("a^{(2)} x^{(1)}_3", notation)), notation) == read("a^{(2)} x^{(1)}_3", notation)


SPACES = [r"\quad", r"\qquad", r", \ ", r",\;", ", ", r"; \quad", r"\\"]


@pytest.mark.parametrize("space", SPACES)
def test_a_wide_space_parts_relations(space):
    assert stated(f"J = x^2 {space} K = y^2") == (("=", "J", ("^", "x", 2)), ("=", "K", ("^", "y", 2)))


@pytest.mark.parametrize("space", [r"\,", r"\;", r"\quad", "~", "&"])
def test_a_space_beside_a_sign_is_layout(space):
    assert stated(rf"J {space} = {space} x {space} + {space} y {space}") == stated("J = x + y")


def test_columns_of_an_alignment_are_relations():
    assert stated(r"\begin{aligned} J &= x & K &= y \end{aligned}") == (("=", "J", "x"), ("=", "K", "y"))


RESERVED = [r"\to", r"\det", r"\lim", r"\int", r"\sum", r"\times", r"\prod", r"\nabla", r"\forall", r"\quad"]
RESERVED += [
    r"\arccot",
    r"\mapsto",
    r"\cup",
    r"\phantom",
    r"\operatorname{div}",
    r"\mathrm{sinc}",
    r"\sin",
    r"\foo",
]


@pytest.mark.parametrize("latex", RESERVED)
def test_what_has_a_meaning_of_its_own_is_never_a_letter(latex):
    for wrong in ({}, {"name": "x"}, {"indices": 1}, {"kind": "function", "depends": "x"}):
        with pytest.raises(SymcheckError, match="letter"):
            Letter(latex, **wrong)


@pytest.mark.parametrize("latex", [each for each in RESERVED if each not in (r"\quad", r"\sin")])
def test_what_is_not_known_is_refused_without_an_invitation_to_declare_it(latex):
    with pytest.raises(SymcheckError) as refusal:
        stated(f"{latex} x = 1")
    assert "declare" not in str(refusal.value)


NAMES = ["sin_x", "cos_2", "pi", "infinity", "sqrt_2", "sqrt", "exp_x", "Root_0123456789", "mean", "call", "diff_x"]


@pytest.mark.parametrize("name", NAMES)
def test_no_letter_is_lowered_to_a_name_that_has_a_value(name):
    with pytest.raises(SymcheckError, match="which is a value"):
        Notation([Letter("x", name=name)])


@pytest.mark.parametrize("name", ["", "2x", "a b", "x-y", "aprime", "sin x"])
def test_a_name_is_that_of_a_variable(name):
    with pytest.raises(SymcheckError, match="name"):
        Notation([Letter("x", name=name)])


WIDE = tuple(range(1, 13))
COLLISIONS = [
    [Letter("h", indices=1, range=WIDE), Letter("h", indices=2)],
    [Letter("h_1", indices=1), Letter("h", indices=2, range=WIDE), Letter("x", name="h_1_11")],
    [Letter("x", indices=1), Letter("x_2", kind="function")],
    [Letter("x", depends="t"), Letter("y", name="x"), Letter("t")],
    [Letter(r"\mathbf{e}", kind="vector", indices=1), Letter("e", indices=2)],
]


@pytest.mark.parametrize("letters", COLLISIONS)
def test_no_two_instances_of_letters_share_a_name(letters):
    with pytest.raises(SymcheckError, match="would both be lowered to"):
        Notation(letters)


def test_the_names_of_wide_indices_are_all_different():
    notation = Notation([Letter("h", indices=2, range=WIDE), Letter("I", indices=1, range=WIDE)])
    names = {term(f"h_{{{i},{j}}}", notation) for i in WIDE for j in WIDE} | {
        term(f"I_{{{i}}}", notation) for i in WIDE
    }
    assert len(names) == 144 + 12


def test_letters_that_may_be_numbers_say_whether_they_are():
    for latex in ("e", "i", r"\mathrm{e}", r"\mathrm{i}"):
        with pytest.raises(SymcheckError, match="or a letter of its own"):
            Letter(latex)
    with pytest.raises(SymcheckError, match="d of a differential, or a letter"):
        Letter(r"\mathrm{d}")
    for latex in (r"\pi", "e"):
        with pytest.raises(SymcheckError, match="or a letter of its own"):
            Letter(latex, kind="index")
    with pytest.raises(SymcheckError, match="does not fit"):
        Notation([Letter("x", number="e")])
    with pytest.raises(SymcheckError, match="Euler's number"):
        read("e^x = 1", PLAIN)


def test_numbers_among_the_letters_have_their_values():
    notation = PLAIN.extended(Letter("e", number="e"), Letter("i", number="i"), Letter(r"\pi"))
    assert term("e^x", notation) == ("exp", "x")
    assert term("2 e", notation) == ("*", 2, ("exp", 1))
    assert term(r"e^{(x + 1)} \pi", notation) == ("*", ("exp", ("+", "x", 1)), PI)
    with pytest.raises(SymcheckError, match="a real one is expected"):
        term("2 i", notation)
    assert term("e^x", PLAIN.extended(Letter("e", name="e"))) == ("pow", "e", "x")
    for latex in ("e'", "e'^x"):
        with pytest.raises(SymcheckError, match=r"another letter|no primes"):
            term(latex, notation)


def test_a_quotient_by_a_letter_d_is_no_derivative():
    notation = Notation([Letter("d"), Letter("x"), Letter("y")])
    assert term(r"\frac{x}{d y}", notation) == ("/", "x", ("*", "d", "y"))
    for latex in (r"\frac{d y}{d x}", r"\frac{d^2 y}{d x^2}", r"d/(d x)"):
        with pytest.raises(SymcheckError, match="a derivative, or a quotient"):
            term(latex, notation)


def test_a_dotted_letter_is_not_declared_twice():
    with pytest.raises(SymcheckError, match="this is its derivative"):
        Notation([Letter("t"), Letter("r", depends="t"), Letter(r"\dot{r}")])
    own = Notation([Letter("r"), Letter(r"\dot{r}")])
    assert term(r"\dot r r", own) == ("*", "dr", "r")


BAD_DEPENDENCE = [
    ([Letter("r", depends="t")], "depends='t': unknown letter t"),
    ([Letter("r", depends="2x"), Letter("x")], "must be letters"),
    ([Letter("r", depends="x"), Letter("x", depends="r")], "depends on itself"),
]


@pytest.mark.parametrize(("letters", "message"), BAD_DEPENDENCE)
def test_a_letter_depends_on_letters_of_the_notation(letters, message):
    with pytest.raises(SymcheckError, match=message):
        term("r", Notation(letters))


def test_an_index_or_a_differential_depends_on_nothing():
    for kind in ("index", "differential"):
        with pytest.raises(SymcheckError, match="depends on nothing"):
            Letter("k", kind=kind, depends="t")


def test_an_index_that_is_a_letter_too_is_not_mistaken_for_it():
    notation = Notation([Letter("n", kind="index"), Letter("n"), Letter("s", indices=1)])
    assert term("n", notation) == "n"
    with pytest.raises(SymcheckError, match="an index here, and a letter"):
        term(r"\sum_{n=1}^3 n s_n", notation)


def test_a_named_letter_needs_a_definition_where_it_is_differentiated():
    slope, integral = stated(r"\frac{dN}{dt} = N")[0], stated(r"\int_0^1 N \, dt = 1")[0]
    MOVING.refuse_undefined({"N"}, slope, integral)
    MOVING.refuse_undefined(set(), *stated("N = t"), *stated(r"\int_0^1 x \, dx = N"))
    for formula in (slope, integral):
        with pytest.raises(SymcheckError, match="nothing defines N"):
            MOVING.refuse_undefined({"r"}, formula)


def test_a_double_sign_in_a_conclusion_is_an_alternative():
    (formula,) = stated(r"x^2 = y^2 \Leftrightarrow x = \pm y", PLAIN)
    assert formula[2] == ("or", ("=", "x", "y"), ("=", "x", ("-", "y")))
    assert stated(r"\pm x = \mp z", PLAIN) == (("=", "x", ("-", "z")), ("=", ("-", "x"), "z"))


def test_one_wide_index_is_not_mistaken_for_two():
    notation = Notation([Letter("a", indices=1, range=WIDE, name="b"), Letter("a", indices=2)])
    assert (term("a_{1,2}", notation), term("a_2", notation)) == ("a_12", "b_2")
    with pytest.raises(SymcheckError, match="one index 12, or 2 indices"):
        term("a_{12}", notation)
