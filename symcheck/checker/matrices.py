"""Whether a certificate about matrices of all sizes shows what it says.

Its fields: `matrices`, the shapes of the letters; `hypotheses`, equations by name; `inverses`, what certain letters are
the inverses of, which are assumed to have one; `claim`, an equation; `proof`, steps [[kind, name], term], in which the
letter `fact` stands for the difference of both sides of a fact: the terms vanish with it, and their sum is the
difference of both sides of the claim; and a `witness`, numbers for which all that is assumed is so if all sizes are 1.
"""

from __future__ import annotations

from symcheck.checker.residues import require
from symcheck.core.fields import Fields, by_key, listed, raw, text
from symcheck.core.matrices import FACT, Matrix, Shapes, size, words
from symcheck.core.terms import JSON, Reader

Equation = list[JSON]


class MatrixCertificate:
    """What is stated about matrices of all sizes, and its proof."""

    def __init__(self, step: Fields) -> None:
        self.step = step
        require(step.take("verdict", text) == "proved", "of matrices of all sizes there are proofs alone")
        shapes = {x: (n, m) for x, (n, m) in step.take("matrices", by_key(listed(size, 2))).items()}
        require(FACT not in shapes and all(map(Reader.letter, shapes)), "the letter {} stands for facts", FACT)
        self.of = Shapes(shapes)
        self.hypotheses = step.take("hypotheses", by_key(listed(raw, 2)), {})
        self.inverses, self.claim = step.take("inverses", by_key(raw), {}), step.take("claim", listed(raw, 2))
        printed = words([self.claim, *self.hypotheses.values(), *self.inverses.values()])
        require(self.inverses.keys() <= printed, "an inverse is not mentioned: {}", self.inverses.keys() - printed)

    def check(self) -> None:
        """Rejects unless the proof shows the claim of what is assumed, which is so of the witness."""
        left, used = self.of.difference(*self.claim), set[str]()
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
        self.check_witness(self.step.take("witness", by_key(raw)))
        self.step.end()

    def fact(self, kind: str, name: str) -> Matrix:
        """The difference of both sides of a hypothesis, of one turned, or of a product with an inverse and the unit."""
        if kind == "hypothesis":
            return self.of.difference(*self.hypotheses[name])
        if kind == "turned":  # square matrices of which a product is the unit are inverse to each other
            match self.hypotheses[name]:
                case [["*", x, y], ["unit", n]]:
                    square = self.of.value(x).shape == self.of.value(y).shape == (n, n)
                    require(square, "{} is no product of square matrices", name)
                    return self.of.difference(["*", y, x], ["unit", n])
        require(kind in ("left", "right"), "there is no fact {} {}", kind, name)
        x, shape = self.inverses[name], self.of.value(name).shape
        require(self.of.value(x).shape == shape and shape[0] == shape[1], "{} is no inverse: it is not square", name)
        return self.of.difference(["*", name, x] if kind == "left" else ["*", x, name], ["unit", shape[0]])

    def check_witness(self, values: dict[str, JSON]) -> None:
        """Rejects unless all that is assumed is so where all sizes are 1 and the letters have these values."""
        numbers = {x: Shapes({}).value(["number", *listed(raw, 2)(value)]) for x, value in values.items()}
        at = Shapes(self.of.shapes, numbers, single=True)
        inverses: list[Equation] = [[["*", x, y], ["number", 1, 1]] for x, y in self.inverses.items()]
        require(self.of.shapes.keys() == numbers.keys(), "no witness, or of other letters")
        for equation in (*self.hypotheses.values(), *inverses):
            require(not at.difference(*equation).parts, "the witness is none of {}", equation)
