"""True and false statements about rotated inertia tensors, typed as terms: the proof engine must tell them apart."""

from __future__ import annotations

from symcheck.core.problems import Form, Problem, Witness
from symcheck.core.terms import Formula, Term, node

R = (1, 2, 3)


def add(*terms: Term) -> Term:
    return node("+", *terms)


def mul(*factors: Term) -> Term:
    return node("*", *factors)


def sub(left: Term, right: Term) -> Term:
    return node("+", left, node("-", right))


def sq(term: Term) -> Term:
    return node("^", term, 2)


def over(top: Term, bottom: Term) -> Term:
    return node("/", top, bottom)


def eq(left: Term, right: Term) -> Formula:
    return node("=", left, right)


def all_of(*formulas: Formula) -> Formula:
    return node("and", *formulas)


def cyclic(i: int) -> int:
    return (i - 1) % 3 + 1


def a(i: int, j: int) -> str:
    return f"a_{i}{j}"


def moment(i: int) -> str:
    return f"I_{cyclic(i)}"


def minor(i: int, j: int) -> Term:
    """The cofactor of entry (i, j)."""
    p, q, r, s = cyclic(i + 1), cyclic(i + 2), cyclic(j + 1), cyclic(j + 2)
    return sub(mul(a(p, r), a(q, s)), mul(a(p, s), a(q, r)))


def dot(i: int, j: int) -> Term:
    return add(*(mul(a(i, k), a(j, k)) for k in R))


def column_dot(i: int, j: int) -> Term:
    return add(*(mul(a(k, i), a(k, j)) for k in R))


rows = tuple(eq(dot(i, j), int(i == j)) for i in R for j in R)
columns = tuple(eq(column_dot(i, j), int(i == j)) for i in R for j in R)
ORTHOGONAL = ("orthogonal", rows + columns)
RIGHT = ("right-handed", tuple(eq(a(i, j), minor(i, j)) for i in R for j in R))
POSITIVE = ("positive", tuple(node(">", moment(i), 0) for i in R))
NON_NEGATIVE = ("non-negative", tuple(node(">=", moment(i), 0) for i in R))
DISTINCT = ("distinct", tuple(node("!=", moment(i), moment(i + 1)) for i in R))
DISTINCT_AS_PRINTED = ("distinct", tuple(node("!=", moment(i), moment(i + 1)) for i in (1, 2)))
TRIANGLE = ("triangle", tuple(node(">=", add(moment(i + 1), moment(i + 2)), moment(i)) for i in R))
ANGLES = (
    "angles",
    (
        eq(node("sin", "beta"), over(1, node("sqrt", 3))),
        eq(node("sin", "gamma"), over(1, node("sqrt", 2))),
        eq(node("cos", "gamma"), over(1, node("sqrt", 2))),
    ),
)
DOMAIN = ("domain", (node(">", "c", 0), node(">=", "J_2", 0), node("<=", "J_2", over(mul(3, "c"), 2))))

J = tuple((f"J_{i}", add(*(mul(moment(k), sq(a(i, k))) for k in R))) for i in R)
L = tuple((f"L_{i}", add(*(mul(moment(k + 1), moment(k + 2), sq(a(i, k))) for k in R))) for i in R)
MEAN = (("c", over(add("I_1", "I_2", "I_3"), 3)),)
F1 = (("f_1", mul(over(1, 4), "J_2", sq(sub(mul(3, "c"), "J_2")))),)
KBAR = tuple((f"kbar_{i}", over(f"k_{i}", f"J_{i}")) for i in R)
M = tuple((f"m_{i}{j}", add(*(mul(f"k_{s}", a(s, i), a(s, j)) for s in R))) for i in R for j in R)

cos, sin = (lambda x: node("cos", x)), (lambda x: node("sin", x))
A, B, G = "alpha", "beta", "gamma"
COSINES = (
    ("a_11", mul(cos(A), cos(B))),
    ("a_12", sub(mul(sin(A), sin(G)), mul(cos(A), sin(B), cos(G)))),
    ("a_13", add(mul(sin(A), cos(G)), mul(cos(A), sin(B), sin(G)))),
    ("a_21", sin(B)),
    ("a_22", mul(cos(B), cos(G))),
    ("a_23", node("-", mul(cos(B), sin(G)))),
    ("a_31", node("-", mul(sin(A), cos(B)))),
    ("a_32", add(mul(cos(A), sin(G)), mul(sin(A), sin(B), cos(G)))),
    ("a_33", sub(mul(cos(A), cos(G)), mul(sin(A), sin(B), sin(G)))),
)

product_i, product_j = mul("I_1", "I_2", "I_3"), mul("J_1", "J_2", "J_3")
deviation = add(*(mul(moment(k), a(1, k), a(3, k)) for k in R))  # the product of inertia about axes 1 and 3


def gaps(i: int) -> list[Term]:
    """I_1 (I_2 - I_3)^2 a_i2^2 a_i3^2 and cyclic."""
    return [
        mul(moment(k), sq(sub(moment(k + 1), moment(k + 2))), sq(a(i, cyclic(k + 1))), sq(a(i, cyclic(k + 2))))
        for k in R
    ]


mixed = add(*(mul(moment(i), moment(i + 1), sq(a(2, cyclic(i + 2)))) for i in R))
excess = add(*gaps(2), mul("J_2", sq(deviation)))
sum_jl = add(*(mul(f"J_{i}", f"L_{i}") for i in R))
excess_of_sum = add(*(term for i in R for term in gaps(i)))
deficit = add(
    mul(over(1, 4), sq(sub("c", "J_2")), add("J_1", "J_3", "c")), mul(over(1, 4), "J_2", sq(sub("J_1", "J_3")))
)
slack_of_domain = mul(
    over(1, 2), add(*(mul(sub(add(moment(k + 1), moment(k + 2)), moment(k)), sq(a(2, k))) for k in R))
)

PERMUTATIONS = ((1, 2, 3), (1, 3, 2), (2, 1, 3), (2, 3, 1), (3, 1, 2), (3, 2, 1))
six_cases = node("or", *(all_of(*(eq(sq(a(r + 1, p[r])), 1) for r in range(3))) for p in PERMUTATIONS))
parallel = all_of(*(eq(mul(a(i, j), a(i, cyclic(j + 1))), 0) for i in R for j in R))
equal_moments = all_of(eq("J_1", "J_2"), eq("J_2", "J_3"))

characteristic_sum = add(
    mul(product_i, node("^", "p", 3)),
    mul(add(*(mul(f"k_{i}", f"L_{i}") for i in R)), sq("p")),
    mul(add(*(mul(f"k_{cyclic(i + 1)}", f"k_{cyclic(i + 2)}", f"J_{i}") for i in R)), "p"),
    mul("k_1", "k_2", "k_3"),
)


def entry(i: int, j: int) -> Term:
    return add(mul(moment(i), "p"), f"m_{i}{i}") if i == j else f"m_{i}{j}"


determinant = add(
    mul(entry(1, 1), sub(mul(entry(2, 2), entry(3, 3)), mul(entry(2, 3), entry(3, 2)))),
    node("-", mul(entry(1, 2), sub(mul(entry(2, 1), entry(3, 3)), mul(entry(2, 3), entry(3, 1))))),
    mul(entry(1, 3), sub(mul(entry(2, 1), entry(3, 2)), mul(entry(2, 2), entry(3, 1)))),
)
triple_root = all_of(
    eq(mul(3, "xi", "I"), mul("k", "S")),
    eq(mul(3, sq("xi"), "I"), mul(3, sq("k"), "J")),
    eq(mul(node("^", "xi", 3), "I"), mul(node("^", "k", 3), "J")),
)
GAINS = ("gains", (node(">", "k", 0), node(">", "I", 0), node(">", "J", 0)))
cos2, sin2 = cos(mul(2, A)), sin(mul(2, A))


def _family() -> tuple[Witness[Term]]:
    first = (over(2, node("sqrt", 6)), over(-1, node("sqrt", 6)), over(1, node("sqrt", 6)))
    second = (over(1, node("sqrt", 3)), over(1, node("sqrt", 3)), over(-1, node("sqrt", 3)))
    third = (0, over(1, node("sqrt", 2)), over(1, node("sqrt", 2)))
    values: dict[str, Term] = {}
    for j in range(3):
        values[a(1, j + 1)] = add(mul("u", first[j]), mul("v", third[j]))
        values[a(2, j + 1)] = second[j]
        values[a(3, j + 1)] = sub(mul("u", third[j]), mul("v", first[j]))
    return (Witness(tuple(values.items())),)


TRUE = (
    Problem("row 2 from rows 3 and 1", eq(sq(a(2, 1)), sq(minor(2, 1))), (), (ORTHOGONAL, RIGHT)),
    Problem("row 2, second", eq(sq(a(2, 2)), sq(minor(2, 2))), (), (ORTHOGONAL, RIGHT)),
    Problem("row 2, third", eq(sq(a(2, 3)), sq(minor(2, 3))), (), (ORTHOGONAL, RIGHT)),
    Problem("2.11 without squares", eq(a(2, 1), minor(2, 1)), (), (ORTHOGONAL, RIGHT)),
    Problem("2.12", eq(mul("J_1", "J_3"), add(sq(deviation), mixed)), J, (ORTHOGONAL, RIGHT)),
    Problem("2.13", eq(mul("J_2", mixed), add(product_i, *gaps(2))), J, (ORTHOGONAL,)),
    Problem("expansion of f", eq(product_j, add(product_i, excess)), J, (ORTHOGONAL,)),
    Problem(
        "product chain",
        eq(
            mul("J_1", "J_3"),
            add(sq(deviation), *(mul(moment(i), moment(i + 1), sq(minor(2, cyclic(i + 2)))) for i in R)),
        ),
        J,
    ),
    Problem("sum of J L", eq(sum_jl, add(mul(3, product_i), excess_of_sum)), J + L, (ORTHOGONAL,)),
    Problem("1.3", eq(determinant, characteristic_sum), M + J + L, (ORTHOGONAL,)),
    Problem(
        "1.4",
        eq(
            characteristic_sum,
            add(
                mul(product_i, node("^", "p", 3)),
                mul(add(*(mul(f"kbar_{i}", f"J_{i}", f"L_{i}") for i in R)), sq("p")),
                mul(add(*(mul(f"kbar_{i}", f"kbar_{cyclic(i + 1)}") for i in R)), product_j, "p"),
                mul("kbar_1", "kbar_2", "kbar_3", product_j),
            ),
        ),
        KBAR,
    ),
    Problem("sum of moments", eq(add("J_1", "J_2", "J_3"), mul(3, "c")), J + MEAN, (ORTHOGONAL,)),
    Problem("2.10", node("<=", product_i, product_j), J, (ORTHOGONAL, NON_NEGATIVE), (Form(excess),)),
    Problem("2.18", node(">=", sum_jl, mul(3, product_i)), J + L, (ORTHOGONAL, NON_NEGATIVE), (Form(excess_of_sum),)),
    Problem(
        "2.1 right",
        node("<=", product_j, node("^", "c", 3)),
        J + MEAN,
        (ORTHOGONAL, NON_NEGATIVE),
        (Form(deficit),),
    ),
    Problem(
        "domain of f_1",
        node("<=", "J_2", over(mul(3, "c"), 2)),
        J + MEAN,
        (ORTHOGONAL, TRIANGLE),
        (Form(slack_of_domain),),
    ),
    Problem(
        "six cases",
        node("<=>", eq(product_j, product_i), six_cases),
        J,
        (ORTHOGONAL, POSITIVE, DISTINCT),
        (Form(excess),),
    ),
    Problem(
        "2.20",
        node("<=>", eq(sum_jl, mul(3, product_i)), parallel),
        J + L,
        (ORTHOGONAL, POSITIVE, DISTINCT),
        (Form(excess_of_sum),),
    ),
    Problem("2.20 to 2.17", node("=>", parallel, six_cases), (), (ORTHOGONAL,)),
    Problem(
        "equality on the right",
        node("<=>", eq(product_j, node("^", "c", 3)), equal_moments),
        J + MEAN,
        (ORTHOGONAL, POSITIVE),
        (Form(deficit),),
    ),
    Problem(
        "two of three", node("=>", all_of(eq("J_1", "c"), eq("J_2", "c")), eq("J_3", "c")), J + MEAN, (ORTHOGONAL,)
    ),
    Problem(
        "slope of f_1",
        eq(node("diff", "f_1", "J_2", 1, "J_2"), mul(over(3, 4), sub(mul(3, "c"), "J_2"), sub("c", "J_2"))),
        F1,
    ),
    Problem("curvature of f_1", eq(node("diff", "f_1", "J_2", 2, "J_2"), mul(over(3, 2), sub("J_2", mul(2, "c")))), F1),
    Problem("greatest f_1", node("<=", "f_1", node("^", "c", 3)), F1, (DOMAIN,)),
    Problem("f_1 greatest only at c", node("<=>", eq("f_1", node("^", "c", 3)), eq("J_2", "c")), F1, (DOMAIN,)),
    Problem(
        "triple root", node("<=>", triple_root, all_of(eq("J", "I"), eq("S", mul(3, "I")), eq("k", "xi"))), (), (GAINS,)
    ),
    Problem("rows of cosines", all_of(*(eq(dot(i, j), int(i == j)) for i in R for j in R)), COSINES),
    Problem("cosines right-handed", all_of(*(eq(a(i, j), minor(i, j)) for i in R for j in R)), COSINES),
    Problem("2.8 first", eq(sq("a_11"), mul(over(1, 3), add(1, cos2))), COSINES, (ANGLES,)),
    Problem(
        "2.8 second",
        eq(sq("a_12"), mul(over(1, 3), sub(sub(1, mul(over(1, 2), cos2)), mul(over(node("sqrt", 3), 2), sin2)))),
        COSINES,
        (ANGLES,),
    ),
    Problem("half turn", node("=>", eq(sq(node("sin", A)), 1), eq(node("cos", A), 0))),
    Problem("ratio", eq(over("x", mul("y", "z")), mul(over("x", "y"), over(1, "z")))),
    Problem("tangent", eq(node("tan", mul(2, A)), over(mul(2, sin(A), cos(A)), sub(sq(cos(A)), sq(sin(A)))))),
    Problem("square root", eq(sq(add(1, node("sqrt", 2))), add(3, mul(2, node("sqrt", 2))))),
    Problem("not zero", node("!=", add(sq("x"), 1), 0), (), ()),
    Problem("alternative", node("=>", eq(mul("x", "y"), 0), node("or", eq("x", 0), eq("y", 0)))),
    Problem(
        "an angle makes the moments equal",
        node("exists", ("alpha",), all_of(*(eq(f"J_{i}", "c") for i in R))),
        COSINES + J + MEAN,
        (ANGLES,),
    ),
    Problem(
        "some axes make the moments equal",
        node("exists", tuple(a(i, j) for i in R for j in R), all_of(*rows, *columns, *(eq(f"J_{i}", "c") for i in R))),
        J + MEAN,
        (),
        _family(),
    ),
    Problem(
        "denominators that do not turn",
        node(
            "exists",
            ("u", "v"),
            all_of(eq(add(sq("u"), sq("v")), 1), eq(over(mul("u", "v"), "d"), over(mul("u", "v"), node("-", "e")))),
        ),
    ),
    Problem("a root of x^2 = 2", node("exists", ("x",), eq(sq("x"), 2)), (), (), (Witness((("x", node("sqrt", 2)),)),)),
)

FALSE = (
    Problem(
        "2.12 with a sign flipped", eq(mul("J_1", "J_3"), add(node("-", sq(deviation)), mixed)), J, (ORTHOGONAL, RIGHT)
    ),
    Problem("2.12 with an index swapped", eq(mul("J_1", "J_2"), add(sq(deviation), mixed)), J, (ORTHOGONAL, RIGHT)),
    Problem("2.12 with a power dropped", eq(mul("J_1", "J_3"), add(deviation, mixed)), J, (ORTHOGONAL, RIGHT)),
    Problem("2.12 with a factor 2", eq(mul("J_1", "J_3"), add(mul(2, sq(deviation)), mixed)), J, (ORTHOGONAL, RIGHT)),
    Problem("2.11 transposed", eq(sq(a(2, 1)), sq(minor(1, 2))), (), (ORTHOGONAL, RIGHT)),
    Problem("2.11 of a reflection", eq(a(2, 1), minor(2, 1)), (), (ORTHOGONAL,)),
    Problem("2.13 without orthogonality", eq(mul("J_2", mixed), add(product_i, *gaps(2))), J, ()),
    Problem("2.13 with a term dropped", eq(mul("J_2", mixed), add(product_i, *gaps(2)[1:])), J, (ORTHOGONAL,)),
    Problem("printed end of the expansion", node(">", product_j, product_j), J, (ORTHOGONAL, NON_NEGATIVE)),
    Problem("2.10 turned", node(">=", product_i, product_j), J, (ORTHOGONAL, NON_NEGATIVE), (Form(excess),)),
    Problem("2.10 strict", node("<", product_i, product_j), J, (ORTHOGONAL, NON_NEGATIVE), (Form(excess),)),
    Problem("2.10 with negative moments", node("<=", product_i, product_j), J, (ORTHOGONAL,), (Form(excess),)),
    Problem(
        "2.18 too strong",
        node(">=", sum_jl, mul(4, product_i)),
        J + L,
        (ORTHOGONAL, POSITIVE),
        (Form(excess_of_sum),),
    ),
    Problem(
        "left equality for equal moments",
        node("=>", equal_moments, eq(product_j, product_i)),
        J,
        (ORTHOGONAL, POSITIVE),
    ),
    Problem(
        "right equality only on principal axes",
        node("=>", eq(product_j, node("^", "c", 3)), six_cases),
        J + MEAN,
        (ORTHOGONAL, POSITIVE),
    ),
    Problem(
        "six cases as printed",
        node("=>", eq(product_j, product_i), six_cases),
        J,
        (ORTHOGONAL, POSITIVE, DISTINCT_AS_PRINTED),
        (Form(excess),),
    ),
    Problem(
        "2.20 with a zero moment",
        node("=>", eq(sum_jl, mul(3, product_i)), parallel),
        J + L,
        (ORTHOGONAL, NON_NEGATIVE, DISTINCT),
    ),
    Problem(
        "slope of f_1 halved",
        eq(node("diff", "f_1", "J_2", 1, "J_2"), mul(over(3, 2), sub(mul(3, "c"), "J_2"), sub("c", "J_2"))),
        F1,
    ),
    Problem(
        "greatest f_1 beyond its domain",
        node("<=", "f_1", node("^", "c", 3)),
        F1,
        (("positive c", (node(">", "c", 0),)),),
    ),
    Problem(
        "looser bound said to be reached",
        node("=>", eq("J_2", "c"), eq("f_1", mul(2, node("^", "c", 3)))),
        F1,
        (DOMAIN,),
    ),
    Problem("2.8 with a sign flipped", eq(sq("a_11"), mul(over(1, 3), sub(1, cos2))), COSINES, (ANGLES,)),
    Problem("root taken of one sign", node("=>", eq(sq("x"), sq("y")), eq("x", "y"))),
    Problem("division by nothing", node("=>", eq(mul("x", "y"), mul("x", "z")), eq("y", "z"))),
    Problem("cosine of the double angle", eq(cos2, sub(1, sq(sin(A)))), ()),
)
