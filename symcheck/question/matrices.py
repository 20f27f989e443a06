"""Equations between matrices of all sizes: from the trees of a reading to statements about them, and their proofs."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import count, pairwise

from symcheck.checker import check
from symcheck.core.certificates import MatrixProof
from symcheck.core.matrices import NUMBER, Shape, Shapes, Size, words
from symcheck.core.problems import Problem
from symcheck.core.terms import JSON, Malformed
from symcheck.core.verdicts import NoForm, SymcheckError
from symcheck.proof.matrices import Statement, proved
from symcheck.question.determinants import DET, Determinants, has
from symcheck.question.prepare import Reading, declared_sizes
from symcheck.question.small_matrices import Small
from symcheck.reading import Notation, Tree, read, with_brackets
from symcheck.reading.faces import face
from symcheck.reading.guesses import PRINTED
from symcheck.reading.inference import Inference
from symcheck.reading.names import KINDS_OPEN
from symcheck.reading.notation import SAID, Letter
from symcheck.reading.tree import (
    Add,
    Bars,
    Call,
    Chain,
    Derivative,
    Diag,
    Div,
    Mul,
    Name,
    Neg,
    Norm,
    Number,
    Pair,
    Pow,
    Sqrt,
    Transpose,
    children,
    nodes,
)

POWERS = range(1, 7)  # exponents that are written out
SIZE_NAMES = ("n", "m", "p", "q", "r", "k", "l")
Key = tuple[str, tuple[int | str, ...], int, int]  # a letter with its subscripts, primes and dots
Typed = tuple[JSON, Shape]


@dataclass(frozen=True)
class OfAnySize:
    """A proof for matrices of all sizes.

    Parameters
    ----------
    certificates
        One for each sign of equality.
    used
        The definitions and conditions that they rest on, as printed.
    taken
        What the letters are, with their shapes.
    told
        What each hypothesis says, by its name in the certificates.
    """

    certificates: tuple[MatrixProof, ...]
    used: tuple[str, ...]
    taken: Mapping[str, str]
    told: Mapping[str, str]


@dataclass(frozen=True)
class Stated:
    """What a reading states of matrices of all sizes: each equation, what is printed of it, what the letters are."""

    statements: tuple[Statement, ...]
    printed: Mapping[str, str]  # hypotheses by their names
    needed: Mapping[str, str]  # that there are the inverses
    taken: Mapping[str, str]
    shapes: Mapping[str, Shape]  # of the letters
    plain: tuple[Statement, ...] = ()  # the same with determinants as they are printed
    varied: str = ""  # the letter by which something is differentiated


def of_any_size(reading: Reading) -> OfAnySize | None:
    """The proof of a reading for matrices of all sizes, if there are matrices and a proof is found.

    Raises
    ------
    Contradiction
        If no shapes fit the reading.
    """
    told = any(letter.kind in MATRICES for letter in reading.inference.notation.letters)
    if not told and not any(isinstance(part, Call) and part.function in ("det", "tr") for part in nodes(reading.tree)):
        return None
    for loose in (False, True) if told else (True,):
        try:
            return _proved(reading, loose=loose)
        except Mismatch:
            continue
        except Contradiction:
            raise
        except (SymcheckError, Malformed, RecursionError):
            return None
    return None


def covers(general: Inference, other: Inference) -> bool:
    """Whether what holds in one reading holds in another, in which some matrices are vectors, of one column."""
    kinds = [(one.letter, two.letter) for one, two in zip(general.guesses, other.guesses, strict=False)]
    return len(general.guesses) == len(other.guesses) and all(
        (one.kind, one.identity) == (two.kind, two.identity) or (one.kind, two.kind) == ("matrix", "vector")
        for one, two in kinds
    )


def open_matrices(reading: Reading) -> list[str]:
    """The matrices of a reading that are no identity, and not made of a vector or of printed components."""
    every = (guess.letter for guess in reading.inference.guesses if guess.letter.kind == "matrix")
    return [x.latex for x in every if not (x.identity or x.skew or x.components)]


class Mismatch(NoForm):
    """Shapes that do not fit together."""


class Contradiction(NoForm):
    """A reading that no shapes fit: as what is said to be a matrix would have to be a row or a column."""


def stated(reading: Reading) -> list[Stated]:
    """What a reading says of matrices of all sizes, in each way that makes sense; nothing is proved."""
    found = []
    for loose in (False, True):
        with suppress(SymcheckError, Malformed, RecursionError):
            found.append(_stated(reading, loose=loose))
    return found


def oblong(reading: Reading) -> list[dict[str, str]]:
    """What vectors and matrices are said to be if numbers of rows and columns that may differ do: 3 and 2, 2 and 3.

    Nothing where all matrices are square for certain, or where that is not known.
    """
    kinds = {x.latex: x.kind for x in reading.inference.notation.letters if not x.identity and not x.skew}
    for said in stated(reading)[:1]:
        shapes = {x: shape for x, shape in said.shapes.items() if kinds.get(x) in MATRICES}
        sizes = [
            *dict.fromkeys(n for shape in shapes.values() for n in shape if isinstance(n, str) and not _is_told(n))
        ]
        if all(n == m for x, (n, m) in shapes.items() if kinds[x] == "matrix") or len(sizes) > len(OBLONG):
            return []
        return [
            {x: _as_said(kinds[x], shape, dict(zip(sizes, numbers, strict=False))) for x, shape in shapes.items()}
            for numbers in (OBLONG, (*OBLONG[1::-1], *OBLONG[2:]))
        ]
    return []


def _as_said(kind: str, shape: Shape, numbers: Mapping[Size, int]) -> str:
    n, m = (str(numbers[size]) if size in numbers else _told(size) for size in shape)
    return f"real {n} {m}" if kind == "matrix" else f"real {n}"


def _proved(reading: Reading, *, loose: bool) -> OfAnySize | None:
    said = _stated(reading, loose=loose)
    certificates = list[MatrixProof]()
    for statement in said.statements:
        if (found := proved(statement)) is None or check(found) is not None:
            return None
        certificates.append(found)
    told = {**said.printed, **said.needed}
    used = dict.fromkeys(
        told[x] for each in certificates for x in (*each["hypotheses"], *each["inverses"]) if x in told
    )
    return OfAnySize(tuple(certificates), tuple(used), said.taken, said.printed)


def _stated(reading: Reading, *, loose: bool) -> Stated:
    asked, inference, defined, equations, conditions = reading.source
    free = {g.letter.latex for g in inference.guesses if g.why != SAID and g.letter.kind == "scalar"} if loose else ()
    shown = {g.letter.latex: g.letter.size for g in inference.guesses if g.why == PRINTED and len(g.letter.size) == 2}
    made = Lowering(inference.notation, shown | declared_sizes(asked), free)
    claims = made.equations(reading.tree)
    hypotheses: dict[str, tuple[JSON, JSON]] = {}
    printed: dict[str, str] = {}
    always = [*(f"{left} = {right}" for left, _, right in defined.values()), *equations]
    for text in (*always, *conditions):
        for both in made.assumed(text):
            if made.varied and made.varied in words(list(both)):
                raise NoForm("a derivative by a matrix of which something is assumed")
            name = f"h{len(hypotheses) + 1}"
            hypotheses[name], printed[name] = both, text
    orders = range(1, made.dots + 1)
    for name, both in [*hypotheses.items()]:
        with suppress(SymcheckError):
            for n in orders if printed[name] in always else ():  # an earlier equation holds at all times
                both = made.rate(both[0]), made.rate(both[1])
                hypotheses[f"{name}_{n}"], printed[f"{name}_{n}"] = both, printed[name]
    hypotheses |= made.known
    shapes, sizes = made.shapes_with_names()
    assumed = {name: (made.sized(left, sizes), made.sized(right, sizes)) for name, (left, right) in hypotheses.items()}
    inverses = {x: made.sized(term, sizes) for x, term in made.inverses.items()}
    sides = [(made.sized(left, sizes), made.sized(right, sizes)) for left, right in claims]
    plain = tuple(Statement({**shapes}, both, {**assumed}, {**inverses}) for both in sides)
    if any(has(side) for both in sides for side in both):
        found = Determinants(shapes, inverses, made.powers())
        inverses |= {x: found.without(term) for x, term in [*inverses.items()] if has(term)}
        sides = [(found.without(left), found.without(right)) for left, right in sides]
        square = {name: both for name, both in assumed.items() if found.square(both[0])}
        assumed |= {f"{name}_{DET}": ([DET, left], [DET, right]) for name, (left, right) in square.items()}
        printed |= {f"{name}_{DET}": text for name, text in printed.items()}
        assumed = {name: told for name, both in assumed.items() if (told := found.both(both)) is not None}
    else:  # determinants in what is assumed make no difference
        assumed = {name: both for name, both in assumed.items() if not any(map(has, both))}
    statements = tuple(Statement(shapes, both, assumed, inverses) for both in sides)
    return Stated(statements, printed, made.needed, made.taken(shapes), made.letters(shapes), plain, made.varied)


def false_gradients(reading: Reading) -> Iterator[list[Problem]]:
    """For a claim about a derivative by a matrix, what it says of two rows and columns, in each layout.

    Nothing where a letter is not said to be a matrix or vector of some size, or where it is no such claim.
    """
    declared = declared_sizes(reading.source[0])
    kinds = {x.latex: x.kind for x in reading.inference.notation.letters}
    if any(kind in MATRICES and x not in declared for x, kind in kinds.items()):
        return
    for said in stated(reading)[:1]:
        for statement in said.plain if said.varied else ():
            left, right = statement.claim
            layouts = [right]
            match right:
                case ["trace", ["*", ["transpose", gradient], change]]:
                    layouts.append(["trace", ["*", gradient, change]])
            for layout in layouts:
                with suppress(Malformed, ValueError):
                    small = Small(statement.shapes, statement.inverses)
                    yield [*small.problems((left, layout), statement.hypotheses)]


def _stem(latex: str) -> str:
    """The letter itself, without its style, index and case."""
    return (face(latex).removesuffix("}") or latex).partition("_")[0].lower()


@dataclass
class Lowering:
    """Trees as terms of matrices, of shapes that fit together; NoForm where they have parts that are none."""

    notation: Notation
    declared: Mapping[str, Shape]
    free: Collection[str] = ()  # letters that are no numbers for certain
    names: dict[Key | Tree | str, str] = field(default_factory=dict)
    shapes: dict[str, Shape] = field(default_factory=dict)
    inverses: dict[str, JSON] = field(default_factory=dict)
    known: dict[str, tuple[JSON, JSON]] = field(default_factory=dict)
    needed: dict[str, str] = field(default_factory=dict)  # that there are the inverses, in words
    same: dict[Size, Size] = field(default_factory=dict)
    dots: int = 0
    varied: str = ""  # the letter by which something is differentiated

    def equations(self, tree: Tree) -> list[tuple[JSON, JSON]]:
        """Both sides of each equation of a chain."""
        if not isinstance(tree, Chain) or {*tree.signs} != {"="}:
            raise NoForm("it is no equation")
        members = tree.members
        for left, right in (members, members[::-1]) if len(members) == 2 else ():
            match left:
                case Derivative(body, ((Name() as variable, 1),)) if self.declaration(variable).kind in MATRICES:
                    return [self.gradient(body, variable, right)]
                case Call(str() as operator, (body,)) if operator.startswith("grad_"):
                    return [self.gradient(body, Name(operator.removeprefix("grad_")), right)]
        if all(isinstance(each, Norm) for each in members):  # lengths are equal if their squares are
            members = tuple(Pow(each, Number("2")) for each in members)
        sides = [self.side(each) for each in members]
        shape = next((shape for _, shape in filter(None, sides)), NUMBER)
        terms: list[Typed] = [(["zero", *shape], shape) if each is None else each for each in sides]
        for (_, one), (_, other) in pairwise(terms):
            self.unify(one, other)
        return [(left, right) for (left, _), (right, _) in pairwise(terms)]

    def assumed(self, text: str) -> list[tuple[JSON, JSON]]:
        """The equations that are printed there; nothing where it has no form."""
        before = {**self.same}
        try:
            return self.equations(read(text, self.notation))
        except Mismatch:
            if not self.free:
                raise
        except SymcheckError:
            pass
        self.same = before | {size: size for size in self.same if size not in before}
        return []

    def side(self, tree: Tree) -> Typed | None:
        """A side of an equation; None for 0, which has the shape of the other side."""
        return None if isinstance(tree, Number) and not Fraction(tree.text) else self.term(tree)

    def term(self, tree: Tree) -> Typed:
        """A term with its shape."""
        match tree:
            case Number(text):
                c = Fraction(text)
                return ["number", c.numerator, c.denominator], NUMBER
            case Name() | Call(Name(), ()):
                return self.letter(tree.function if isinstance(tree, Call) else tree)  # type: ignore[arg-type]
            case Call(Name() as name, (Name() as by,)) if self.declaration(name).depends == by.letter:
                return self.letter(name)
            case Add(terms):
                parts = [self.term(each) for each in terms]
                for _, shape in parts[1:]:
                    self.unify(parts[0][1], shape)
                return ["+", *(term for term, _ in parts)], parts[0][1]
            case Neg(value):
                term, shape = self.term(value)
                return ["-", term], shape
            case Mul(factors, dotted):
                found = self.term(factors[0])
                for k, factor in enumerate(factors[1:], 1):
                    found = (self.dot if k in dotted else self.times)(found, self.term(factor))
                return found
            case Pair(left, right):
                return self.dot(self.term(left), self.term(right))
            case Pow(Norm(value) | Bars(value), Number("2")):
                found = self.term(value)
                return self.dot(found, found)
            case Transpose(value):
                term, (n, m) = self.term(value)
                return ["transpose", term], (m, n)
            case Diag(entries) if all(entry == Number("1") for entry in entries):
                n = _size(len(entries))
                return ["unit", n], (n, n)
            case Div(top, bottom):
                below = self.term(bottom)
                if below[1] != NUMBER:
                    raise NoForm("a quotient of matrices")
                if isinstance(bottom, Number) and Fraction(bottom.text):
                    c = 1 / Fraction(bottom.text)
                    return self.times(self.term(top), (["number", c.numerator, c.denominator], NUMBER))
                return self.times(self.term(top), self.inverse(below, bottom))
            case Pow(base, Neg(Number(text))) if text.isdigit() and int(text) in POWERS:
                return self.power(self.inverse(self.term(base), base), int(text))
            case Pow(base, Number(text)) if text.isdigit() and int(text) in POWERS:
                return self.power(self.term(base), int(text))
            case Pow(Name(letter), exponent) if self.declaration(Name(letter)).number == "e":
                return self.exponential(exponent)
            case Call("exp", (exponent,)):
                return self.exponential(exponent)
            case Call("tr", (value,)):
                return ["trace", self.square(value)[0]], NUMBER
            case Call("det", (value,)):
                return self.determinant(value)
            case Bars(value) if (inner := self.term(value))[1] != NUMBER and inner[1][1] != 1:
                return self.determinant(value)
            case Derivative(body, ((variable, 1),)):
                return self.derivative(body, variable)
            case Call(str()) | Sqrt() | Pow():
                return self.opaque(tree)
        raise NoForm(f"{type(tree).__name__} is no term of matrices of all sizes")

    def determinant(self, tree: Tree) -> Typed:
        """The determinant of a square matrix."""
        return [DET, self.square(tree)[0]], NUMBER

    def square(self, tree: Tree) -> Typed:
        """A square matrix; Mismatch where it would be made of numbers alone, which have no traces and determinants."""
        term, (n, m) = self.term(tree)
        kinds = {self.declaration(part).kind for part in nodes(tree) if isinstance(part, Name)}
        if self.shape(n, m) == NUMBER and kinds.isdisjoint(MATRICES):
            raise Mismatch("a trace or a determinant of a number")
        self.same_size(n, m)
        return term, (n, m)

    def gradient(self, body: Tree, variable: Name, other: Tree) -> tuple[JSON, JSON]:
        """That a matrix is the derivative of a number by another of its shape: the number changes by tr(G^T dX)."""
        (name, shape), change = self.letter(variable), self.names.get("change")
        if not isinstance(name, str) or change is not None or self.declaration(variable).skew:
            raise NoForm("a derivative by several letters, or by a matrix whose entries depend on each other")
        inside, of = {part.letter for part in nodes(body) if isinstance(part, Name)}, variable.letter
        if of not in inside or any(_stem(x) == _stem(of) for x in inside - {of}):
            raise NoForm("what may be a function of it, or one of its components, is no constant")
        self.varied, change = name, self.named("change", f"d{name}")
        self.shapes[change] = shape
        match body:
            case Call("ln" | "log", (Call("det", (inner,)) | Bars(inner),)):
                self.determinant(inner)
                rise = self.relative(self.term(inner)[0], name, change)
            case _:
                term, kind = self.term(body)
                self.unify(kind, NUMBER)
                rise = self.slope(term, name, change)
        side = self.side(other)
        gradient, own = side if side is not None else (_zero(shape), shape)
        self.unify(own, shape)
        return rise, ["trace", ["*", ["transpose", gradient], change]]

    def relative(self, of: JSON, name: str, change: str) -> JSON:
        """The change of a logarithm of a determinant: tr(A^{-1} dA)."""
        inverse, _ = self.inverse((of, self.shape_of(of)), None)
        self.needed[str(inverse)] = "a determinant that is not zero"
        return ["trace", ["*", inverse, self.slope(of, name, change)]]

    def shape_of(self, term: JSON) -> Shape:
        """The shape of a term, as far as it is known."""
        known = {x: self.shape(*shape) for x, shape in self.shapes.items()}
        return Shapes(known).value(self.sized(term, {})).shape

    def slope(self, term: JSON, name: str, change: str) -> JSON:
        """How a term changes with a letter; all others are constant."""
        match term:
            case str():
                if term == name:
                    return change
                if term in self.inverses:
                    return ["-", ["*", term, self.slope(self.inverses[term], name, change), term]]
                key = next(key for key, own in self.names.items() if own == term)
                if not isinstance(key, tuple):
                    raise NoForm("the derivative of a function of a matrix")
                return _zero(self.shapes[term])
            case [tag, of] if tag == DET:
                return ["*", term, self.relative(of, name, change)]
            case ["*", *factors]:
                return [
                    "+",
                    *(
                        ["*", *factors[:k], self.slope(x, name, change), *factors[k + 1 :]]
                        for k, x in enumerate(factors)
                    ),
                ]
            case ["unit", n]:
                return ["zero", n, n]
            case ["number", *_]:
                return ["zero", 1, 1]
            case ["zero", *_]:
                return term
            case [str() as tag, *parts]:
                return [tag, *(self.slope(part, name, change) for part in parts)]
        raise NoForm("no term")

    def declaration(self, name: Name) -> Letter:
        """What is known of a letter."""
        if (found := self.notation.find(name.letter, len(name.subscripts))) is None:
            raise NoForm(f"nothing is known of {name.letter}")
        return found

    def letter(self, name: Name) -> Typed:
        """A letter, by a name of its own for all its indices, primes and dots."""
        letter = self.declaration(name)
        if letter.value is not None and any(letter.latex in shape for shape in self.declared.values()):
            return ["trace", ["unit", letter.latex]], NUMBER
        if (
            letter.running
            or letter.components
            or letter.value is not None
            or letter.number == "i"
            or letter.kind not in KINDS
            or (letter.doubt and not letter.doubt.startswith(KINDS_OPEN))
        ):
            raise NoForm(f"{letter.latex} is no matrix of any size")
        self.dots = max(self.dots, name.dots)
        if letter.identity:
            n = self.fresh()
            return ["unit", n], (n, n)
        key = name.letter, name.subscripts, name.primes, name.dots
        if key not in self.names:
            new = self.named(key, letter.stem)
            if name.dots:
                self.shapes[new] = self.letter(Name(name.letter, name.subscripts, name.primes))[1]
            else:
                kind = "matrix" if letter.latex in self.free else letter.kind
                rows, columns = self.declared.get(letter.latex, KINDS[kind])
                self.shapes[new] = _size(rows) or self.fresh(), _size(columns) or self.fresh()
            if letter.skew:
                self.unify(self.shapes[new], self.shapes[new][::-1])
                self.known[f"{new}_is_skew"] = ["transpose", new], ["-", new]
        return self.names[key], self.shapes[self.names[key]]

    def named(self, key: Key | Tree | str, stem: str) -> str:
        """A new name for a letter or for what is left as it is."""
        plain = re.sub(r"[^A-Za-z0-9]", "", stem).lstrip("0123456789") or "x"
        taken = {*self.names.values(), *WORDS}
        new = next(x for k in count() if (x := f"{plain}_{k}" if k else plain) not in taken)
        self.names[key] = new
        return new

    def times(self, one: Typed, other: Typed) -> Typed:
        """A product, with a number or of what fits together."""
        (x, (n, m)), (y, (k, j)) = one, other
        if NUMBER in (self.shape(n, m), self.shape(k, j)):
            return ["*", x, y], (k, j) if self.shape(n, m) == NUMBER else (n, m)
        self.same_size(m, k)
        return ["*", x, y], (n, j)

    def dot(self, one: Typed, other: Typed) -> Typed:
        """The product of numbers, or the scalar product of columns."""
        (x, shape), (y, others) = one, other
        if NUMBER in (self.shape(*shape), self.shape(*others)):
            return self.times(one, other)
        if self.find(shape[1]) != 1 or self.find(others[1]) != 1:
            raise NoForm("a dot between matrices")
        self.same_size(shape[0], others[0])
        return ["*", ["transpose", x], y], NUMBER

    def inverse(self, of: Typed, tree: Tree | None) -> Typed:
        """A letter for the inverse of a term; without the tree it has one for certain."""
        term, (n, m) = of
        self.same_size(n, m)
        key = f"inverse of {term}"
        if key not in self.names:
            self.inverses[self.named(key, "inverse")] = term
            self.shapes[self.names[key]] = (n, m)
            if tree is not None:
                number = self.shape(n, m) == NUMBER
                self.needed[self.names[key]] = with_brackets(tree) + (r" \ne 0" if number else " is invertible")
        return self.names[key], (n, m)

    def power(self, of: Typed, exponent: int) -> Typed:
        """A power with a whole exponent."""
        term, (n, m) = of
        self.same_size(n, m)
        return (term if exponent == 1 else ["*", *[term] * exponent]), (n, m)

    def exponential(self, exponent: Tree) -> Typed:
        """The exponential of a matrix: of two that are opposite, one is the inverse of the other."""
        if isinstance(exponent, Neg):
            return self.inverse(self.exponential(exponent.value), None)
        _, (n, m) = self.term(exponent)
        self.same_size(n, m)
        key = Call("exp", (exponent,))
        new = self.names.get(key) or self.named(key, "exponential")
        return new, self.shapes.setdefault(new, (n, m))

    def opaque(self, tree: Tree) -> Typed:
        """A function of numbers, of which no more is known than that it is a number."""
        if any(self.term(part)[1] != NUMBER for part in children(tree)):
            raise NoForm("a function of a matrix")
        new = self.names.get(tree) or self.named(tree, "value")
        return new, self.shapes.setdefault(new, NUMBER)

    def derivative(self, body: Tree, variable: Tree) -> Typed:
        """The derivative by what the letters depend on."""
        by = variable.letter if isinstance(variable, Name) else ""
        depends = {self.declaration(part).depends for part in nodes(body) if isinstance(part, Name)} - {None}
        if depends != {by}:
            raise NoForm(f"a derivative by {by}")
        term, shape = self.term(body)
        return self.rate(term), shape

    def rate(self, term: JSON) -> JSON:
        """The derivative of a term by what its letters depend on; letters that depend on nothing are constant."""
        if isinstance(term, str):
            shape = self.shapes[term]
            if term in self.inverses:
                return ["-", ["*", term, self.rate(self.inverses[term]), term]]
            key = next(key for key, name in self.names.items() if name == term)
            if not isinstance(key, tuple):
                raise NoForm("the derivative of a function of a matrix")
            latex, subscripts, primes, dots = key
            if (depends := self.declaration(Name(latex, subscripts)).depends) is None:
                raise NoForm(f"does {latex} vary?")
            if not depends:
                return ["zero", *shape]
            return self.letter(Name(latex, subscripts, primes, dots + 1))[0]
        match term:
            case ["*", *factors]:
                return ["+", *(["*", *factors[:k], self.rate(x), *factors[k + 1 :]] for k, x in enumerate(factors))]
            case ["unit", n]:
                return ["zero", n, n]
            case ["number", *_]:
                return ["zero", 1, 1]
            case ["zero", *_]:
                return term
            case [str() as tag, *parts]:
                return [tag, *map(self.rate, parts)]
        raise NoForm("no term")

    def powers(self) -> dict[tuple[str, str], str]:
        """The names of powers of numbers whose exponents are numbers of rows, by base and exponent."""
        found = dict[tuple[str, str], str]()
        for key, name in self.names.items():
            match key:
                case Pow(Name(base, subscripts), Name(exponent)):
                    own = self.names.get((base, subscripts, 0, 0))
                    found |= {(own, exponent): name} if own is not None else {}
        return found

    def fresh(self) -> Size:
        """A number of rows or columns of which nothing is known."""
        new = f"size_{len(self.same)}"
        self.same[new] = new
        return new

    def find(self, size: Size) -> Size:
        while self.same.get(size, size) != size:
            size = self.same[size]
        return size

    def shape(self, rows: Size, columns: Size) -> Shape:
        return self.find(rows), self.find(columns)

    def unify(self, one: Shape, other: Shape) -> None:
        """Two shapes are the same; NoForm if that cannot be."""
        for a, b in zip(one, other, strict=True):
            self.same_size(a, b)

    def same_size(self, one: Size, other: Size) -> None:
        a, b = self.find(one), self.find(other)
        if a == b:
            return
        if isinstance(a, str) and a.startswith("size_"):
            self.same[a] = b
        elif isinstance(b, str) and b.startswith("size_"):
            self.same[b] = a
        else:
            raise Mismatch(f"matrices with {a} and with {b} rows or columns do not fit together")

    def shapes_with_names(self) -> tuple[dict[str, Shape], dict[Size, Size]]:
        """The shapes of all letters, with short names for numbers of which nothing is known; and these."""
        found = {x: self.shape(*shape) for x, shape in self.shapes.items()}
        for key, x in self.names.items():
            if isinstance(key, tuple) and 1 in found[x][: {"vector": 1, "matrix": 2}.get(self._kind(key), 0)]:
                raise Contradiction(f"{key[0]} would have one row or column")
        taken = {size for shape in (*found.values(), *self.declared.values()) for size in shape}
        free = iter([x for x in SIZE_NAMES if x not in taken])
        names: dict[Size, Size] = {}
        for size in dict.fromkeys(size for shape in found.values() for size in shape):
            if isinstance(size, str) and size.startswith("size_"):
                names[size] = next(free, size)
        return {x: (names.get(n, n), names.get(m, m)) for x, (n, m) in found.items()}, names

    def _kind(self, key: Key) -> str:
        return self.declaration(Name(*key[:2])).kind

    def sized(self, term: JSON, names: Mapping[Size, Size]) -> JSON:
        """A term with the final names of sizes."""
        match term:
            case ["unit" | "zero" as tag, *sizes]:
                return [tag, *(names.get(size, size) for size in map(self.find, sizes))]  # type: ignore[arg-type]
            case [*parts]:
                return [self.sized(part, names) for part in parts]
        return term

    def letters(self, shapes: Mapping[str, Shape]) -> dict[str, Shape]:
        """The shape of each letter."""
        return {key[0]: shapes[x] for key, x in self.names.items() if isinstance(key, tuple) and x in shapes}

    def taken(self, shapes: Mapping[str, Shape]) -> dict[str, str]:
        """What each letter is taken for, with its shape."""
        units = {x.latex: "the identity" for x in self.notation.letters if x.identity}
        return units | {
            x: f"a vector of {_told(n)}, whatever that is"
            if m == 1
            else f"a matrix of {_told(n)} x {_told(m)}, whatever these are"
            for x, (n, m) in self.letters(shapes).items()
            if not (_is_told(n) and _is_told(m))
        }


def _size(number: Size) -> Size:
    """A letter for a number of rows or columns above 1: what holds for all sizes holds for it."""
    return f"size{number}" if isinstance(number, int) and number > 1 else number


def _zero(shape: Shape) -> JSON:
    return ["zero", *shape]


def _told(size: Size) -> str:
    return str(size).removeprefix("size")


def _is_told(size: Size) -> bool:
    return size == 1 or bool(re.fullmatch(r"size\d+", str(size)))


KINDS: dict[str, Shape] = {"scalar": NUMBER, "vector": (0, 1), "matrix": (0, 0), "function": NUMBER}  # 0: any
MATRICES = ("vector", "matrix")
OBLONG = (3, 2, 4)  # different numbers of rows and columns
WORDS = ("unit", "zero", "number", "transpose", "trace", "fact")  # no names of letters
