"""Whether a certificate about matrices of all sizes shows what it says.

Its fields: `matrices`, the shapes of the letters; `hypotheses`, equations by name; `inverses`, what certain letters are
the inverses of, which are assumed to have one; `claim`, an equation; `proof`, steps [[kind, name], term], in which the
letter `fact` stands for the difference of both sides of a fact: the terms vanish with it, and their sum is the
difference of both sides of the claim; and a `witness`, sizes and matrices for which all that is assumed is so.
"""

from __future__ import annotations

from fractions import Fraction

from symcheck.checker.residues import require
from symcheck.core.fields import Fields, by_key, listed, raw, text
from symcheck.core.matrices import Matrix, Rows, Shape, Shapes, Size, at, sized
from symcheck.core.terms import JSON, Malformed, Reader

FACT = "fact"
Equation = list[JSON]


class MatrixCertificate:
    """What is stated about matrices of all sizes, and its proof."""

    def __init__(self, step: Fields) -> None:
        self.step = step
        require(step.take("verdict", text) == "proved", "of matrices of all sizes there are proofs alone")
        shapes = step.take("matrices", by_key(_shape))
        require(FACT not in shapes and all(map(Reader.letter, shapes)), "the letter {} stands for facts", FACT)
        self.of = Shapes(shapes)
        self.hypotheses = step.take("hypotheses", by_key(listed(raw, 2)), {})
        self.inverses, self.claim = step.take("inverses", by_key(raw), {}), step.take("claim", listed(raw, 2))
        printed = _letters([self.claim, *self.hypotheses.values(), *self.inverses.values()])
        require(self.inverses.keys() <= printed, "an inverse is not mentioned: {}", self.inverses.keys() - printed)

    def check(self) -> None:
        """Rejects unless the proof shows the claim of what is assumed, which is so of the witness."""
        left, used = self.of.value(_minus(self.claim)), set[str]()
        for reference, term in self.step.take("proof", listed(listed(raw, 2))):
            kind, name = listed(text, 2)(reference)
            fact = self.fact(kind, name)
            used.add(name if name in self.hypotheses else "")
            own = {**self.of.shapes, FACT: fact.shape}
            nothing = Shapes(own, {FACT: Matrix(fact.shape, {})}).value(term)
            require(not nothing.parts, "{} does not vanish with the fact", term)
            left = self.of.plus(left, Shapes(own, {FACT: fact}).value(["-", term]))
        require(not left.parts, "the difference of both sides is not the sum it is said to be")
        require(self.hypotheses.keys() <= used, "a hypothesis is not used: {}", self.hypotheses.keys() - used)
        self.check_witness(Fields(self.step.take("witness", raw)))
        self.step.end()

    def fact(self, kind: str, name: str) -> Matrix:
        """The difference of both sides of a hypothesis, of one turned, or of a product with an inverse and the unit."""
        if kind == "hypothesis":
            return self.of.value(_minus(self.hypotheses[name]))
        if kind == "turned":  # square matrices of which a product is the unit are inverse to each other
            match self.hypotheses[name]:
                case [["*", x, y], ["unit", n]]:
                    square = self.of.value(x).shape == self.of.value(y).shape == (n, n)
                    require(square, "{} is no product of square matrices", name)
                    return self.of.value(_minus([["*", y, x], ["unit", n]]))
        require(kind in ("left", "right"), "there is no fact {} {}", kind, name)
        x, shape = self.inverses[name], self.of.value(name).shape
        require(self.of.value(x).shape == shape and shape[0] == shape[1], "{} is no inverse: it is not square", name)
        return self.of.value(_minus([["*", name, x] if kind == "left" else ["*", x, name], ["unit", shape[0]]]))

    def check_witness(self, step: Fields) -> None:
        """Rejects unless the matrices have their shapes, and all that is assumed is so of them."""
        sizes = step.take("sizes", by_key(_whole), {})
        values = {name: _rows(rows) for name, rows in step.take("values", by_key(listed(listed(raw)))).items()}
        step.end()
        for name, (n, m) in self.of.shapes.items():
            fits = len(values[name]) == sized(n, sizes) and {*map(len, values[name])} == {sized(m, sizes)}
            require(fits, "the witness {} has another shape", name)
        inverses: list[Equation] = []
        for x, y in self.inverses.items():
            inverses += [[["*", *pair], ["unit", len(values[x])]] for pair in ((x, y), (y, x))]
        for left, right in (*self.hypotheses.values(), *inverses):
            require(at(left, sizes, values) == at(right, sizes, values), "the witness is none of {} = {}", left, right)


def _shape(data: JSON) -> Shape:
    rows, columns = listed(_size, 2)(data)
    return rows, columns


def _size(data: JSON) -> Size:
    if isinstance(data, str):
        return Reader.letter(data)
    if type(data) is not int or data < 1:
        raise Malformed(f"{data!r} is no number of rows or columns")
    return data


def _letters(term: JSON) -> set[str]:
    """All words of a term, its letters among them."""
    return set().union(*map(_letters, term)) if isinstance(term, list) else {term} if isinstance(term, str) else set()


def _minus(equation: Equation) -> JSON:
    return ["+", equation[0], ["-", equation[1]]]


def _rows(data: list[list[JSON]]) -> Rows:
    return [[Fraction(*listed(_whole, 2)(entry)) for entry in row] for row in data]


def _whole(data: JSON) -> int:
    if type(data) is not int:
        raise Malformed(f"{data!r} is no whole number")
    return data
