"""Matrices of all sizes: normal forms are right, forged proofs are rejected, identities that are printed are proved."""

from __future__ import annotations

import json
import random
from collections import Counter
from copy import deepcopy
from fractions import Fraction
from typing import Any

import pytest

from symcheck import decide
from symcheck.checker import check
from symcheck.core.matrices import Matrix, Shape, Shapes, Size, Word
from symcheck.core.terms import JSON, Malformed
from symcheck.proof.matrices import Statement, proved
from symcheck.question.answer import Status

LETTERS: dict[str, Shape] = {
    "A": ("n", "n"), "B": ("n", "m"), "C": ("m", "n"), "D": ("n", "n"), "u": ("n", 1), "v": ("n", 1), "w": ("m", 1),
    "s": (1, 1), "t": (1, 1), "E": ("k", "k"),
}  # fmt: skip


def drawn(draw: random.Random, shape: Shape, depth: int) -> JSON:
    """A random term of a shape."""
    plain: list[JSON] = [x for x, own in LETTERS.items() if own == shape]
    plain += [["transpose", x] for x, own in LETTERS.items() if own[::-1] == shape]
    plain += [["unit", shape[0]]] * (shape[0] == shape[1]) + [["zero", *shape]] * (not plain)
    if shape == (1, 1):
        plain.append(["number", draw.randint(-3, 3), draw.randint(1, 3)])
        if depth and draw.random() < 0.3:
            n: Size = draw.choice(["n", "m", "k"])
            return ["trace", drawn(draw, (n, n), depth - 1)]
    if not depth or draw.random() < 0.1:
        return draw.choice(plain)
    match draw.randrange(4):
        case 0:
            return ["+", *(drawn(draw, shape, depth - 1) for _ in range(draw.randint(1, 3)))]
        case 1:
            return [draw.choice(["-", "transpose"]), drawn(draw, shape[::-1], depth - 1)] if shape[0] == shape[1] else [
                "-", drawn(draw, shape, depth - 1)
            ]  # fmt: skip
        case 2:
            number, rest = drawn(draw, (1, 1), depth - 1), drawn(draw, shape, depth - 1)
            return ["*", *draw.choice([(number, rest), (rest, number)])]
    inner: Size = draw.choice(["n", "m", 1, "k"])
    return ["*", drawn(draw, (shape[0], inner), depth - 1), drawn(draw, (inner, shape[1]), depth - 1)]


def written(matrix: Matrix) -> JSON:
    """A normal form as a term."""

    def factors(word: Word) -> list[JSON]:
        return [["transpose", x] if transposed else x for x, transposed in word]

    parts: list[JSON] = [["zero", *matrix.shape]]
    for (numbers, word), c in matrix.parts.items():
        product: list[JSON] = [["number", c.numerator, c.denominator]]
        for kind, own in numbers:
            inner: JSON = ["unit", own[0][0]] if kind == "size" else ["*", *factors(own)]
            product.append(inner if kind == "word" else ["trace", inner])
        unit: list[JSON] = [] if word or matrix.shape == (1, 1) else [["unit", matrix.shape[0]]]
        parts.append(["*", *product, *unit, *factors(word)])
    return ["+", *parts]


Rows = list[list[Fraction]]


def at(term: JSON, sizes: dict[str, int], values: dict[str, Rows]) -> Rows:
    """The rows of a term of letters that have these."""
    if isinstance(term, str):
        return values[term]
    assert isinstance(term, list)
    tag, *parts = term
    if tag == "number":
        return [[Fraction(*parts)]]
    if tag in ("unit", "zero"):
        n, m = (sizes.get(size, 1) for size in (parts * 2)[:2])
        return [[Fraction(tag == "unit" and i == k) for k in range(m)] for i in range(n)]
    first, *rest = (at(part, sizes, values) for part in parts)
    if tag == "transpose":
        return [list(column) for column in zip(*first, strict=True)]
    if tag == "trace":
        return [[sum((row[k] for k, row in enumerate(first)), Fraction())]]
    if tag == "-":
        return [[-entry for entry in row] for row in first]
    for other in rest:
        if tag == "+":
            first = [[a + b for a, b in zip(*rows, strict=True)] for rows in zip(first, other, strict=True)]
        elif len(first) == len(first[0]) == 1 or len(other) == len(other[0]) == 1:
            number, matrix = (first, other) if len(first) == len(first[0]) == 1 else (other, first)
            first = [[number[0][0] * entry for entry in row] for row in matrix]
        else:
            columns = [*zip(*other, strict=True)]
            first = [[sum((a * b for a, b in zip(row, c, strict=True)), Fraction()) for c in columns] for row in first]
    return first


def test_a_normal_form_has_the_value_of_its_term_for_all_sizes() -> None:
    draw = random.Random(20)
    for k in range(1500):
        shape = draw.choice([("n", "n"), ("n", "m"), (1, 1), ("n", 1), (1, "m"), ("k", "k")])
        term, sizes = drawn(draw, shape, 4), {size: draw.randint(1, 3) for size in "nmk"}
        values = {x: drawn_rows(draw, own, sizes) for x, own in LETTERS.items()}
        found = Shapes(LETTERS).value(term)
        assert found.shape == shape
        assert at(written(found), sizes, values) == at(term, sizes, values), (k, term)


def put(term: JSON, x: str, new: JSON) -> JSON:
    """A term with another in the place of a letter."""
    return [put(part, x, new) for part in term] if isinstance(term, list) else new if term == x else term


def altered(draw: random.Random, tree: Any) -> Any:
    """A tree with a number or a word in it changed."""
    if isinstance(tree, list) and tree:
        k = draw.randrange(len(tree))
        return [*tree[:k], altered(draw, tree[k]), *tree[k + 1 :]]
    if isinstance(tree, dict) and tree:
        key = draw.choice([*tree])
        return {**tree, key: altered(draw, tree[key])}
    return draw.choice([*LETTERS, "+", "*", "-", "fact", "left", "h"]) if isinstance(tree, str) else draw.randint(-2, 2)


def test_what_is_accepted_of_a_sample_is_so() -> None:
    draw, accepted = random.Random(3), Counter[bool]()
    for _ in range(250):
        defined = drawn(draw, ("n", "n"), 2)
        if any(part == "D" for part in json.dumps(defined).split('"')):
            continue
        left = drawn(draw, ("n", "n"), 3)
        right = put(left, "D", defined) if draw.random() < 0.7 else drawn(draw, ("n", "n"), 3)
        made = proved(Statement(LETTERS, (left, right), {"h": ("D", defined)}, {}))
        for certificate in [made, *(altered(draw, json.loads(json.dumps(made))) for _ in range(20))] if made else ():
            if check(certificate) is not None:
                accepted[False] += 1
                continue
            accepted[True] += 1
            sizes = {size: draw.randint(1, 3) for size in "nmk"}
            values = {x: drawn_rows(draw, shape, sizes) for x, shape in LETTERS.items()}
            for name, (head, term) in certificate["hypotheses"].items():
                assert (name, head) == ("h", "D"), certificate
                values["D"] = at(term, sizes, values)
            one, other = certificate["claim"]
            assert at(one, sizes, values) == at(other, sizes, values), certificate
    assert accepted[True] > 150
    assert accepted[False] > 1000


def drawn_rows(draw: random.Random, shape: Shape, sizes: dict[str, int]) -> Rows:
    n, m = (sizes.get(str(size), 1) for size in shape)
    return [[Fraction(draw.randint(-3, 3)) for _ in range(m)] for _ in range(n)]


def test_terms_that_do_not_fit_together_are_refused() -> None:
    of = Shapes(LETTERS)
    for term in (
        ["*", "B", "B"], ["+", "A", "B"], ["trace", "B"], ["unit"], "X", ["number", 1, 0], ["number", 0.5, 1], 3, ["*"],
        ["+", "A", "s"], ["*", "u", "v"], ["number", True, 1], ["unit", 3], ["unit", True], ["zero", 0, 1],
        ["unit", "3"],
        ["*", *[["+", "A", "D"]] * 30],
    ):  # fmt: skip
        with pytest.raises(Malformed):
            of.value(term)


N = ["n", "n"]
ONE = [1, 1]
INVERSE: dict[str, Any] = {  # (A^T)^{-1} = (A^{-1})^T
    "id": "q", "verdict": "proved", "matrices": {"A": N, "a": N, "b": N}, "hypotheses": {},
    "inverses": {"a": "A", "b": ["transpose", "A"]}, "claim": ["b", ["transpose", "a"]],
    "proof": [
        [["left", "b"], ["*", "fact", ["transpose", "a"]]],
        [["left", "a"], ["-", ["*", "b", ["transpose", "fact"]]]],
    ],
    "witness": {"A": ONE, "a": ONE, "b": ONE},
}  # fmt: skip
TURNED: dict[str, Any] = {  # R^T R = 1, so that R R^T = 1
    "id": "q", "verdict": "proved", "matrices": {"R": N}, "inverses": {},
    "claim": [["*", "R", ["transpose", "R"]], ["unit", "n"]],
    "hypotheses": {"h": [["*", ["transpose", "R"], "R"], ["unit", "n"]]}, "proof": [[["turned", "h"], "fact"]],
    "witness": {"R": ONE},
}  # fmt: skip


def changed(certificate: dict[str, Any], *path: Any, to: Any) -> dict[str, Any]:
    """A certificate with something else at a place."""
    new = deepcopy(certificate)
    inner = new
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = to
    return new


FORGED = {
    "another claim": (changed(INVERSE, "claim", to=["b", "a"]), "is not the sum"),
    "matrices commute": (
        {**TURNED, "matrices": {"A": N, "R": N}, "hypotheses": {}, "claim": [["*", "A", "R"], ["*", "R", "A"]],
         "proof": [], "witness": {"A": ONE, "R": ONE}}, "is not the sum"),
    "nothing is shown": (changed(INVERSE, "proof", to=[]), "is not the sum"),
    "no verdict but proved": (changed(INVERSE, "verdict", to="refuted"), "proofs alone"),
    "a step that does not vanish": (
        changed(INVERSE, "proof", to=[[["left", "b"], ["+", "fact", "b", ["-", ["transpose", "a"]]]]]), "not vanish"),
    "an inverse of zero": (
        {**INVERSE, "matrices": {"a": N}, "inverses": {"a": ["zero", "n", "n"]}, "claim": ["a", "a"], "proof": [],
         "witness": {"a": ONE}}, "the witness is none"),
    "a witness that is no inverse": (changed(INVERSE, "witness", "a", to=[2, 1]), "the witness is none"),
    "a witness that is no number": (changed(INVERSE, "witness", "a", to=["b", 1]), "no term"),
    "no witness": (changed(INVERSE, "witness", to={}), "no witness"),
    "an inverse that is not square": (
        {**INVERSE, "matrices": {"A": ["n", "m"], "a": ["m", "n"]}, "inverses": {"a": "A"}, "claim": ["a", "a"],
         "proof": [[["left", "a"], "fact"]]}, "it is not square"),
    "the letter of facts": (changed(INVERSE, "matrices", "fact", to=N), "stands for facts"),
    "a hypothesis that is not used": (changed(INVERSE, "hypotheses", to={"h": ["A", "A"]}), "is not used"),
    "an inverse of what is not mentioned": (changed(INVERSE, "inverses", "c", to="A"), "not mentioned"),
    "a field too many": (changed(INVERSE, "nonzero", to=[]), "superfluous"),
    "a fact that is none": (changed(INVERSE, "proof", to=[[["middle", "a"], "fact"]]), "there is no fact"),
    "a hypothesis that is none": (changed(INVERSE, "proof", to=[[["hypothesis", "a"], "fact"]]), "malformed"),
    "a product of matrices that are not square, turned": (
        {**TURNED, "matrices": {"R": ["m", "n"]}, "claim": [["*", "R", ["transpose", "R"]], ["unit", "m"]]},
        "no product of square matrices"),
    "another equation, turned": (changed(TURNED, "hypotheses", "h", to=[["*", "R", "R"], "R"]), "there is no fact"),
    "a size that is none": (changed(TURNED, "matrices", "R", to=["n", 0]), "no number of rows"),
    "a size of its own": (changed(TURNED, "matrices", "R", to=[3, 3]), "no number of rows"),
    "a letter that is none": (changed(TURNED, "matrices", "R r", to=N), "is no letter"),
    "it contradicts itself": (
        {**TURNED, "hypotheses": {"h": [["unit", "n"], ["zero", "n", "n"]]}, "claim": ["R", ["zero", "n", "n"]],
         "proof": [[["hypothesis", "h"], ["*", "R", "fact"]]]}, "the witness is none"),
}  # fmt: skip


def test_right_proofs_are_accepted() -> None:
    for certificate in (INVERSE, TURNED):
        assert check(certificate) is None
        assert check(json.loads(json.dumps(certificate))) is None


@pytest.mark.parametrize("name", FORGED)
def test_a_forged_proof_is_rejected(name: str) -> None:
    certificate, reason = FORGED[name]
    assert reason in (check(certificate) or pytest.fail("it is accepted"))


def test_what_is_proved_of_matrices_is_no_lemma_of_other_proofs() -> None:
    from symcheck.checker import check_all

    lemma = {"id": "q", "verdict": "proved", "claim": ["=", 0, 1], "lemmas": [["q", ["=", 0, 1]]], "proof": {}}
    assert list(check_all([INVERSE, lemma]))[1] is not None


M = "matrix"
R_N, R_P = (rf"\mathbf{{R}} \in \mathbb{{R}}^{{n\times {p}}}" for p in "np")
OPTIMAL = {
    "where": [
        r"\mathbf{P} = \mathbf{L}\mathbf{M}\mathbf{L}^T + \mathbf{K}\mathbf{R}\mathbf{K}^T",
        r"\mathbf{L} = \mathbf{I} - \mathbf{K}\mathbf{H}",
        r"\mathbf{K} = \mathbf{M}\mathbf{H}^T(\mathbf{H}\mathbf{M}\mathbf{H}^T+\mathbf{R})^{-1}",
    ],
    "given": [r"\mathbf{M}^T=\mathbf{M}", r"\mathbf{R}^T=\mathbf{R}"],
}
LYAPUNOV = [
    r"V = \mathbf{x}^T\mathbf{P}\mathbf{x}", r"\dot{\mathbf{x}} = \mathbf{A}\mathbf{x}",
    r"\mathbf{A}^T\mathbf{P} + \mathbf{P}\mathbf{A} = -\mathbf{Q}",
]  # fmt: skip
LEAST_SQUARES = {
    "where": [r"\hat\beta = (X^TX)^{-1}X^Ty", r"y = X\beta + \varepsilon"],
    "given": [r"X \in \mathbb{R}^{n\times p}"],
}
S_N = r"\mathbf{S} \in \mathbb{R}^{n \times n}"
SKEW = [r"\mathbf{S}^T = -\mathbf{S}", S_N]
PROVED: list[tuple[str, dict[str, Any]]] = [
    (r"(\mathbf{A}\mathbf{B})^T = \mathbf{B}^T\mathbf{A}^T", {}),
    (r"(AB)^{-1} = B^{-1}A^{-1}", {"letters": {"A": M, "B": M}}),
    (r"(A+UCV)^{-1} = A^{-1} - A^{-1}U(C^{-1}+VA^{-1}U)^{-1}VA^{-1}", {"letters": dict.fromkeys("AUCV", M)}),
    (r"(A+uv^T)^{-1} = A^{-1} - \frac{A^{-1}uv^TA^{-1}}{1+v^TA^{-1}u}",
     {"letters": {"A": M, "u": "vector", "v": "vector"}}),
    (r"(I+AB)^{-1}A = A(I+BA)^{-1}", {"letters": {"A": M, "B": M}}),
    (r"\mathbf{P} = (\mathbf{I} - \mathbf{K}\mathbf{H})\mathbf{M}", OPTIMAL),
    (r"\dot V = -\mathbf{x}^T\mathbf{Q}\mathbf{x}", {"where": LYAPUNOV}),
    (r"\hat\beta - \beta = (X^TX)^{-1}X^T\varepsilon", LEAST_SQUARES),
    (r"P^2 = P", {"where": [r"P = X(X^TX)^{-1}X^T"], "letters": {"X": M, "P": M}}),
    (r"\mathbf{R}\mathbf{R}^T = \mathbf{I}", {"given": [r"\mathbf{R}^T\mathbf{R} = \mathbf{I}", R_N]}),
    (r"\operatorname{tr}(ABC) = \operatorname{tr}(CAB)", {"letters": dict.fromkeys("ABC", M)}),
    (r"\operatorname{tr}(\mathbf{x}\mathbf{x}^T\mathbf{A}) = \mathbf{x}^T\mathbf{A}\mathbf{x}", {}),
    (r"\operatorname{tr}(\mathbf{I}-\mathbf{R}) = n-\operatorname{tr}(\mathbf{R})", {"given": R_N}),
    (r"\frac{d}{dt}(\mathbf{A}^{-1}) = -\mathbf{A}^{-1}\dot{\mathbf{A}}\mathbf{A}^{-1}", {}),
    (r"\mathbf{A}\mathbf{B}-\mathbf{B}\mathbf{A} = 0", {"given": [r"\mathbf{B} = \mathbf{A}^2+3\mathbf{A}"]}),
    (r"\|\mathbf{x}+\mathbf{y}\|^2 = \|\mathbf{x}\|^2+2\mathbf{x}\cdot\mathbf{y}+\|\mathbf{y}\|^2", {}),
    (r"\mathbf{x}^T\mathbf{S}\mathbf{x} = 0", {"given": SKEW}),
    (r"\mathbf{x}^T\mathbf{S}\mathbf{y} = -\mathbf{y}^T\mathbf{S}\mathbf{x}", {"given": SKEW}),
    (r"\operatorname{tr}(\mathbf{S}) = 0", {"given": SKEW}),
    (r"\|\mathbf{R}\mathbf{x}\| = \|\mathbf{x}\|", {"given": [r"\mathbf{R}^T\mathbf{R} = \mathbf{I}", R_N]}),
    (r"e^Y = a e^{-X} a^{-1}", {"where": r"a^{-1} e^Y = (a e^X)^{-1}", "letters": {"a": M, "X": M, "Y": M}}),
]  # fmt: skip
NOT_PROVED: list[tuple[str, dict[str, Any]]] = [
    (r"AB = BA", {"letters": {"A": M, "B": M}}),
    (r"\operatorname{tr}(\mathbf{A}\mathbf{A}^{-1}) = n", {"given": R_N}),  # which says nothing of A
    (r"(AB)^T = A^TB^T", {"letters": {"A": M, "B": M}}),
    (r"\operatorname{tr}(ABC) = \operatorname{tr}(ACB)", {"letters": dict.fromkeys("ABC", M)}),
    (r"\mathbf{x}^T\mathbf{A}\mathbf{y} = \mathbf{y}^T\mathbf{A}\mathbf{x}", {}),
    (r"\mathbf{R}\mathbf{R}^T = \mathbf{I}", {"given": [r"\mathbf{R}^T\mathbf{R} = \mathbf{I}", R_P]}),
    (r"\mathbf{P} = (\mathbf{I} + \mathbf{K}\mathbf{H})\mathbf{M}", OPTIMAL),
    (r"\mathbf{P} = \mathbf{P}^T", {**OPTIMAL, "given": [r"\mathbf{R}^T=\mathbf{R}"]}),
    (r"\hat\beta - \beta = (X^TX)^{-1}X\varepsilon", LEAST_SQUARES),
    (r"\mathbf{x}^T\mathbf{S}\mathbf{y} = \mathbf{y}^T\mathbf{S}\mathbf{x}", {"given": SKEW}),
    (r"\mathbf{x}^T\mathbf{S}\mathbf{x} = 0", {"given": [r"\mathbf{S}^T = \mathbf{S}", S_N]}),
    (r"\|\mathbf{R}\mathbf{x}\| = \|\mathbf{y}\|", {"given": [r"\mathbf{R}^T\mathbf{R} = \mathbf{I}", R_N]}),
    (r"\mathbf{B} = \mathbf{C}", {"given": [r"\mathbf{A}\mathbf{B} = \mathbf{A}\mathbf{C}"]}),
    (r"\mathbf{x} = \mathbf{y}",
     {"given": [r"\mathbf{A} = \mathbf{I}", r"\mathbf{A} = 2\mathbf{I}", r"\mathbf{A}\mathbf{x} = \mathbf{y}"]}),
]  # fmt: skip


@pytest.mark.parametrize(("relation", "context"), PROVED)
def test_what_holds_for_matrices_of_all_sizes_is_proved_for_all(relation: str, context: dict[str, Any]) -> None:
    answer = decide(relation, **context)
    assert answer.verdict is Status.PROVED
    assert all("matrices" in each for each in answer.certificate)
    assert [*map(check, json.loads(json.dumps(answer.certificate)))] == [None] * len(answer.certificate)


@pytest.mark.parametrize(("relation", "context"), NOT_PROVED)
def test_what_does_not_hold_for_matrices_of_all_sizes_is_not_proved(relation: str, context: dict[str, Any]) -> None:
    assert decide(relation, **context).verdict is not Status.PROVED


SQUARE_ALONE = [
    (r"P^2 = I", {"where": [r"P = A(A^TA)^{-1}A^T"]}),  # of tall matrices it is a projection
    (r"\det(AA^T) = \det(A^TA)", {"letters": {"A": M}}),
]
NUMBERS_ALONE = [
    (r"e^{A+B} = e^Ae^B", {"letters": {"A": M, "B": M}}),  # these need not commute
    (r"e^{\mathbf{A} + \mathbf{B}} = e^\mathbf{A} e^\mathbf{B}", {}),
    (r"\exp(A+B) = \exp(A)\exp(B)", {"letters": {"A": M, "B": M}}),
]


@pytest.mark.parametrize(("relation", "context"), [*SQUARE_ALONE, *NUMBERS_ALONE])
def test_what_holds_for_square_matrices_or_for_numbers_alone_is_not_proved(
    relation: str, context: dict[str, Any]
) -> None:
    answer = decide(relation, **context)
    assert answer.verdict is Status.AMBIGUOUS
    assert "it holds" in answer.reason


def test_what_holds_for_matrices_of_different_numbers_of_rows_and_columns_is_still_proved() -> None:
    answer = decide(r"\operatorname{tr}(AA^T) = \operatorname{tr}(A^TA)", letters={"A": M})
    assert answer.verdict is Status.PROVED
    assert (
        decide(
            r"\det(AB) = \det(BA)", given=[r"A \in \mathbb{R}^{2 \times 2}", r"B \in \mathbb{R}^{2 \times 2}"]
        ).verdict
        is Status.PROVED
    )


@pytest.mark.parametrize(
    ("relation", "more", "verdict"),
    [
        (r"\det(A B) = \det(B A)", [], "refuted"),
        (r"\det(A A^T) = \det(A^T A)", [], "refuted"),
        (r"\operatorname{tr}(A B) = \operatorname{tr}(B A)", [], "proved"),
        (r"\det(I + A B) = \det(I + B A)", [], "proved"),
        (r"\det(A B) = \det(B A)", ["m = n"], "undecided"),  # of other numbers nothing is claimed
    ],
)
def test_what_fails_for_other_numbers_of_rows_than_of_columns_is_refuted(
    relation: str, more: list[str], verdict: str
) -> None:
    given = [r"A \in \mathbb{R}^{m \times n}", r"B \in \mathbb{R}^{n \times m}", *more]
    answer = decide(relation, given=given if "B" in relation else [given[0], *more])
    assert answer.verdict == verdict
    assert verdict != "refuted" or (answer.counterexample["m"], answer.counterexample["n"]) == ("2", "3")


def test_a_projection_is_one_for_all_sizes_as_a_reading_with_a_row_for_a_matrix_is_none() -> None:
    projection = r"P = A(A^T A)^{-1} A^T"
    for relation in ("P^2 = P", "P^T = P", "P A = A"):
        answer = decide(relation, where=projection)
        assert answer.verdict == "proved"
        assert all("matrices" in each for each in answer.certificate)
    assert decide("P A = 2 A", where=projection).verdict == "refuted"


def test_a_letter_that_is_said_to_be_the_identity_is() -> None:
    said = {"A": "matrix", "B": "matrix", "E": "identity matrix"}
    assert decide("(A + E) B = A B + B", letters=said).verdict is Status.PROVED
    assert decide("(A + E) B = A B + A", letters=said).verdict is Status.REFUTED
    assert decide("(A + E) B = A B + B", letters=said | {"E": "matrix"}).verdict is not Status.PROVED
