"""Relations between fields in Cartesian coordinates: gradients, divergences, curls and Laplacians written out.

Letters under such an operator are functions of x, y and z, and of t where something is differentiated by it, bold ones
with three components; a bold r is the position, and a plain letter beside the same one in bold its length. What is
proved holds for all smooth fields. What fails for some of them is refuted where it can be no law and no condition: all
its addends have the same fields in them, and are differentiated as often; or definitions say what all of them are; or
it is about the position and constants alone.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Set
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, combinations, pairwise, product

from symcheck.core.calculus import domain, functions, letters
from symcheck.core.certificates import Certificate
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Formula, Node, Term, node
from symcheck.core.terms import Call as Applied
from symcheck.core.verdicts import NoForm, SymcheckError, Verdict
from symcheck.core.words import term
from symcheck.question.answer import Answer, Status
from symcheck.question.prepare import DEFINED, Asked, Reading, unlowered
from symcheck.reading import Tree, read, tex, with_brackets
from symcheck.reading.components import Value, dot, each_part, minus, plus, times
from symcheck.reading.faces import face
from symcheck.reading.forms import is_of_value
from symcheck.reading.lowering import Env, Lowering, length
from symcheck.reading.relations import relations
from symcheck.reading.tree import Add, Call, Chain, Cross, Derivative, Div, Integral, Mul, Name, Neg, Number, Pow, nodes

Decide = Callable[[Problem], tuple[Verdict, Certificate | None, tuple[str, ...]]]
Degree = tuple[tuple[str, ...], int]  # the fields of an addend, and how often it is differentiated
COORDINATES = ("x", "y", "z")
PLANE = ("x", "y")
NABLA, POSITION = r"\nabla", "r"
TIME, RATE = "t", r"\partial t"
OPERATORS = {"grad": 1, "div": 1, "curl": 1, "rot": 1, "laplacian": 2}  # and how often they differentiate
FEW = 3  # letters of which each may be constant, or not
# an operator on fields
_PRINTED = re.compile(r"\\nabla|\\operatorname\{(?:grad|div|curl|rot)\}")
_HAT = re.compile(r"\\(?:hat|widehat)\{")  # the accent of unit vectors
FIELDS_SAID = frozenset({"function of x, y, z", "depends on x, y, z"})
FIELD, CONSTANT, PLACE = "a smooth field in x, y, z", "constant", "the position (x, y, z)"


def in_fields(asked: Asked, decide: Decide) -> Answer | None:
    """The answer to a question about fields; None where there is none, or something else stands in it."""
    if not _PRINTED.search(asked.relation):
        return None
    varying = {x for x, phrase in asked.letters if phrase in FIELDS_SAID}
    asked = replace(asked, letters=tuple((x, phrase) for x, phrase in asked.letters if x not in varying))
    try:
        reading = _read(asked)
        constant = {x for x, phrase in asked.letters if phrase in ("constant", "scalar")}
        stated = _Stated.of(reading, _under_operators(reading) - constant)
        verdict, made, names = _verdict(stated.problems(), decide)
        if verdict is not Status.PROVED and stated.hypotheses:  # equations between fields hold everywhere
            more = _verdict(stated.differentiated().problems(), decide)
            verdict, made, names = more if more[0] is Status.PROVED else (verdict, made, names)
        perhaps = stated.fields - varying  # what stands alone under an operator varies, and what is defined as it says
        perhaps = perhaps.difference(reading.source[2], *map(_alone, (reading.tree, *_said(reading).values())))
        others = [_Stated.of(reading, each) for each in _fewer(stated.fields, perhaps) if verdict is not Status.PROVED]
        answers = [_verdict(each.problems(), decide)[0] for each in others]
    except SymcheckError:
        return None
    base = Answer(Status.UNDECIDED, with_brackets(reading.tree), stated.taken())
    if Status.PROVED in answers:
        shown = ", ".join(sorted(stated.fields - others[answers.index(Status.PROVED)].fields))
        return replace(base, verdict=Status.AMBIGUOUS, reason=f"it holds where {shown} is constant; say what it is")
    if verdict is Status.REFUTED and stated.about_position and _holds_in_plane(stated, decide):
        return replace(base, verdict=Status.AMBIGUOUS, reason="it holds in the plane: of how many dimensions is r?")
    if verdict is Status.REFUTED and _verdict(stated.without_sources(), decide)[0] is Status.PROVED:
        return replace(base, verdict=Status.AMBIGUOUS, reason="it holds where divergences are zero: is that meant?")
    calculated = stated.about_position and perhaps == stated.fields and {*answers} <= {Status.REFUTED}
    calculated = calculated or stated.is_of_defined()
    if verdict is Status.REFUTED and (stated.hypotheses or not (calculated or stated.is_even())):
        return replace(base, reason=LAW)
    if not made:
        return None
    point = made[0].get("point", {}) if verdict is Status.REFUTED else {}
    at = {x: term(t) for x, t in point.get("values", {}).items()}
    values = tuple(map(term, point.get("shown", ())))
    hypotheses = {text for text, _ in stated.hypotheses}  # what is no hypothesis is a definition, written out
    used = tuple(text for text in (*asked.where, *asked.given) if text in names or text not in hypotheses)
    return replace(base, verdict=verdict, certificate=made, counterexample=at, values=values, used=used)


def _holds_in_plane(stated: _Stated, decide: Decide) -> bool:
    """Is it proved for fields in two dimensions?"""
    with suppress(SymcheckError):
        return _verdict(_Stated.of(stated.reading, stated.fields, PLANE).problems(), decide)[0] is Status.PROVED
    return False


LAW = "it says how fields depend on each other of which nothing else is said: a law or a condition"


def _read(asked: Asked) -> Reading:
    """The reading in which bold letters and gradients are vectors."""
    vectors = dict[str, str]()
    for _ in range(2):  # with vectors the dots between them are those of scalar products
        said = tuple((x, phrase) for x, phrase in vectors.items() if x not in dict(asked.letters))
        reading = unlowered(replace(asked, letters=(*asked.letters, *said)))[0]
        texts = (text for text in (*asked.where, *asked.given) if _PRINTED.search(text))
        trees = [reading.tree, *(read(text, reading.inference.notation) for text in texts)]
        if any(is_of_value(part) for tree in trees for part in nodes(tree) if isinstance(part, Call)):
            raise NoForm("at this place, or of this value?")
        names = {part.letter for tree in trees for part in nodes(tree) if isinstance(part, Name)}
        names -= {name for tree in trees for name in _applied(tree)}
        vectors = {x: "vector" for x in names if face(x) or (x.startswith(NABLA) and x != NABLA)}
    return reading


def _applied(tree: Tree) -> Iterator[str]:
    """The letters with arguments, as `f(r)`."""
    for part in nodes(tree):
        if isinstance(part, Call) and isinstance(part.function, Name) and part.arguments:
            yield part.function.letter


def _fewer(fields: frozenset[str], perhaps: Set[str]) -> Iterator[frozenset[str]]:
    """The fields without some of those that may be constant."""
    if len(perhaps) > FEW:
        raise NoForm("too many letters that may be constant")
    for k in range(1, len(perhaps) + 1):
        yield from (fields.difference(constant) for constant in combinations(sorted(perhaps), k))


def _alone(tree: Tree) -> set[str]:
    """The letters that are differentiated alone somewhere: nobody prints that of constants."""
    operands = [part.arguments[0] for part in nodes(tree) if isinstance(part, Call) and part.function in OPERATORS]
    for part in nodes(tree):
        if isinstance(part, Mul):
            operands += [after for before, after in pairwise(part.factors) if _along(before)]
        if isinstance(part, Name) and part.letter.startswith(NABLA):
            operands.append(Name(part.letter.removeprefix(NABLA).replace(" ", "")))
        if isinstance(part, Derivative):
            operands.append(part.body)
    operands = [each.function if _is_name(each) else each for each in operands]  # type: ignore[attr-defined]
    return {each.letter for each in operands if isinstance(each, Name)}


def _is_name(tree: Tree) -> bool:
    """Is it a letter that is a function, without its arguments?"""
    return isinstance(tree, Call) and isinstance(tree.function, Name) and not tree.arguments


def _under_operators(reading: Reading) -> frozenset[str]:
    """The letters that are differentiated, and those that say what these are."""
    said, found = _said(reading), set[str]()
    for part in (part for tree in (reading.tree, *said.values()) for part in nodes(tree)):
        if isinstance(part, Call) and part.function in OPERATORS:
            found |= {each.letter for argument in part.arguments for each in nodes(argument) if isinstance(each, Name)}
        elif isinstance(part, Derivative):
            found |= {each.letter for each in nodes(part.body) if isinstance(each, Name)}
        elif isinstance(part, Name) and part.letter.startswith(NABLA):
            found.add(part.letter)
        elif isinstance(part, Mul) and any(map(_along, part.factors)):
            k = max(k for k, each in enumerate(part.factors) if _along(each))
            found |= {x.letter for each in part.factors[k + 1 :] for x in nodes(each) if isinstance(x, Name)}
    for name in [x for x in said if x in found]:
        found |= {each.letter for each in nodes(said[name]) if isinstance(each, Name)}
    bare = {x.removeprefix(NABLA).replace(" ", "") for x in found} - {"", POSITION, TIME, *COORDINATES}
    exponents = (part.exponent for part in nodes(reading.tree) if isinstance(part, Pow))
    raised = {each.letter for exponent in exponents for each in nodes(exponent) if isinstance(each, Name)}
    bare -= raised - _alone(reading.tree)  # an exponent is a number, unless it is differentiated itself
    bare -= {name.removeprefix(NABLA).replace(" ", "") for name in _applied(reading.tree)}
    return frozenset(x for x in bare if _bold(x) != POSITION)


def _said(reading: Reading) -> dict[str, Tree]:
    """What is said beside a relation: what letters are, by these letters, and equations and conditions."""
    _, _, defined, equations, conditions = reading.source
    texts = {name: right for name, (_, _, right) in defined.items()} | {x: x for x in (*equations, *conditions)}
    return {name: read(text, reading.inference.notation) for name, text in texts.items()}


def _bold(latex: str) -> str:
    """The letter that is printed in bold, if one is."""
    return face(latex).rstrip("}")


def _along(tree: Tree) -> bool:
    r"""Is it the operator `\mathbf{v} \cdot \nabla`?"""
    return isinstance(tree, Mul) and tree.factors[-1] == Name(NABLA) and len(tree.factors) > 1


def _verdict(problems: list[Problem], decide: Decide) -> tuple[Status, tuple[Certificate, ...], set[str]]:
    """The verdict on all components with its certificates, of which one refutes, and the hypotheses that are used."""
    certificates, status, names = list[Certificate](), Status.PROVED, set[str]()
    for problem in problems:
        verdict, made, used = decide(problem)
        names.update(used)
        if verdict is Verdict.REFUTED and made is not None:
            return Status.REFUTED, (made,), names
        if made is None:
            status = Status.UNDECIDED
        else:
            certificates.append(made)
    return status, tuple(certificates) if status is Status.PROVED else (), names


@dataclass(frozen=True)
class _Stated:
    """What a reading states where these letters are fields and all others are constant."""

    reading: Reading
    fields: frozenset[str]
    claims: tuple[Formula, ...]
    hypotheses: tuple[tuple[str, tuple[Formula, ...]], ...]

    @classmethod
    def of(cls, reading: Reading, fields: frozenset[str], coordinates: tuple[str, ...] = COORDINATES) -> _Stated:
        _, _, defined, equations, conditions = reading.source
        lowering = _Fields(reading, fields, coordinates)
        for name, (_, arguments, right) in defined.items():
            if arguments:
                raise NoForm(f"{name} is said by its arguments")
            lowering.meant[name] = read(right, reading.inference.notation)
        texts = [*equations, *conditions]
        said = [(text, tuple(lowering.formulas(read(text, reading.inference.notation)))) for text in texts]
        return cls(reading, fields, tuple(lowering.formulas(reading.tree)), tuple(said))

    @property
    def about_position(self) -> bool:
        names = {part.letter for part in nodes(self.reading.tree) if isinstance(part, Name)}
        return POSITION in names or POSITION in map(_bold, names)

    def problems(self) -> list[Problem]:
        """A claim for each component; where it is printed, no divisor is zero."""
        trees = [*self.claims, *(f for _, fs in self.hypotheses for f in fs)]
        valued = tuple(dict.fromkeys(each for each in domain(*trees, divisors=True) if not functions(each)))
        hypotheses = (*self.hypotheses, (DEFINED, valued)) if valued else self.hypotheses
        return [Problem(f"question{n or ''}", claim, (), hypotheses) for n, claim in enumerate(self.claims)]

    def differentiated(self) -> _Stated:
        """The same with the derivatives of the equations between fields that are given; others may be of a surface."""
        variables = _Fields(self.reading, self.fields, COORDINATES).variables_
        hypotheses = [
            (text, (*formulas, *(_rate(each, x) for each in formulas for x in variables if _is_of_fields(each))))
            for text, formulas in self.hypotheses
        ]
        return replace(self, hypotheses=tuple(hypotheses))

    def without_sources(self) -> list[Problem]:
        """The same where vector fields have no divergence, which need not be said of a flow or a magnetic field."""
        lowering = _Fields(self.reading, self.fields, COORDINATES)
        vectors = [Name(x) for x in sorted(self.fields) if _bold(x)]
        zero = tuple(node("=", lowering.scalar(Call("div", (vector,)), {}), 0) for vector in vectors)
        return [replace(each, hypotheses=(*each.hypotheses, ("no sources", zero))) for each in self.problems()]

    def taken(self) -> dict[str, str]:
        """What each letter was taken for."""
        found = dict[str, str]()
        for part in nodes(self.reading.tree):
            if isinstance(part, Name):
                latex = part.letter.removeprefix(NABLA).replace(" ", "")
                if latex and latex not in COORDINATES:
                    found[latex] = PLACE if _bold(latex) == POSITION else FIELD if latex in self.fields else CONSTANT
        return found

    def is_of_defined(self) -> bool:
        """Whether definitions say what all fields in the relation are."""
        names = {
            part.letter.removeprefix(NABLA).replace(" ", "")
            for part in nodes(self.reading.tree)
            if isinstance(part, Name)
        }
        own = self.fields & names
        return bool(own) and own <= self.reading.source[2].keys()

    def is_even(self) -> bool:
        """Whether all addends have the same fields, differentiated as often."""
        if not isinstance(self.reading.tree, Chain):
            return False
        try:
            found = {degree for side in self.reading.tree.members for degree in self.degrees(side)}
        except NoForm:
            return False
        return len(found) == 1 and all(any(degree) for degree in found)

    def degrees(self, tree: Tree) -> set[Degree]:
        """Those of all addends; NoForm where something else than sums and products of fields is printed."""
        match tree:
            case Add(terms):
                return set().union(*map(self.degrees, terms))
            case Neg(inner) | Div(inner, Number()):
                return self.degrees(inner)
            case Number(text) if text != "0":
                return {((), 0)}
            case Name(latex, (), 0, 0):
                bare = latex.removeprefix(NABLA).replace(" ", "")
                bold = {_bold(each): each for each in self.fields if _bold(each)}
                bare = bold.get(bare, bare)
                if bare and bare not in self.fields:
                    raise NoForm(f"{latex} is no field")
                return {((bare,) if bare else (), int(latex.startswith(NABLA)))}
            case Pow(base, Number(text)) if text.isdigit():
                return _products(*[self.degrees(base)] * int(text))
            case Mul(factors):
                return _products(*map(self.degrees, factors))
            case Cross(left, right):
                return _products(self.degrees(left), self.degrees(right))
            case Call(str(name), (inner,)) if name in OPERATORS:
                return {(fields, order + OPERATORS[name]) for fields, order in self.degrees(inner)}
            case Call(Name() as letter, ()):
                return self.degrees(letter)
            case Derivative(body, variables):
                rates = (RATE,) * sum(order for _, order in variables)
                return {(tuple(sorted((*rates, *fields))), order) for fields, order in self.degrees(body)}
        raise NoForm("no sum of products of fields")


def _products(*several: set[Degree]) -> set[Degree]:
    return {
        (tuple(sorted(chain.from_iterable(fields for fields, _ in each))), sum(order for _, order in each))
        for each in product(*several)
    }


class _Fields(Lowering):
    """The evaluator of terms in which some letters are fields."""

    def __init__(self, reading: Reading, fields: frozenset[str], coordinates: tuple[str, ...]) -> None:
        super().__init__(reading.inference.notation)
        self.fields, self.coordinates, self.meant = fields, coordinates, dict[str, Tree]()
        asked = reading.source[0]
        by_time = any(RATE in tex.compact(text) for text in (asked.relation, *asked.where, *asked.given))
        self.variables_ = (*coordinates, TIME) if by_time else coordinates
        self.bold = {_bold(part.letter): part.letter for part in nodes(reading.tree) if isinstance(part, Name)}

    def formulas(self, tree: Tree) -> Iterator[Formula]:
        """The components of a relation."""
        for relation in relations(tree):
            if any(isinstance(part, Integral) or _is_other(part) for part in nodes(relation.tree)):
                raise NoForm("other derivatives beside fields")
            yield from self.whole(relation)

    def of_name(self, tree: Name, env: Env) -> Value:
        latex = tree.letter
        if tree.dots or tree.primes or (tree.subscripts and latex in self.fields):
            raise NoForm(f"{latex} is more than a field")
        if latex.startswith(NABLA):
            bare = latex.removeprefix(NABLA).replace(" ", "")
            return self.gradient(self.of_name(Name(bare), env)) if bare else super().of_name(tree, env)
        if latex in self.meant:
            return self.value(self.meant[latex], env)
        if latex in self.coordinates:
            return latex
        bold = _bold(latex)
        if bold and _HAT.match(latex):
            if bold != POSITION:
                raise NoForm(f"{latex}: along which field?")
            return [node("/", x, length([*self.coordinates])) for x in self.coordinates]
        if bold == POSITION:
            return [*self.coordinates]
        if bold:
            return [self.field(latex, f"{_stem(latex)}_{x}") for x in self.coordinates]
        if latex == POSITION:
            return length([*self.coordinates])
        if latex in self.bold:
            return length(self.of_name(Name(self.bold[latex]), env))
        if latex in self.fields:
            return self.field(latex, _stem(latex))
        if latex.partition("_")[0] in self.bold:
            raise NoForm(f"{latex} is a component")
        value = super().of_name(tree, env)
        if isinstance(value, list) or functions(value):
            raise NoForm(f"{latex} is no number")
        return value

    def field(self, latex: str, name: str) -> Term:
        """A component: a function of the coordinates, or a constant."""
        return node("call", name, (0,) * len(self.variables_), *self.variables_) if latex in self.fields else name

    def of_derivative(self, tree: Derivative, env: Env) -> Value:
        value = self.value(tree.body, env)
        for _ in range(sum(order for _, order in tree.variables)):
            value = each_part(lambda t: _slope(t, TIME), value)
        return value

    def gradient(self, value: Value) -> Value:
        if isinstance(value, list):
            raise NoForm("the gradient of a vector")
        return [_slope(value, x) for x in self.coordinates]

    def of_call(self, tree: Call, env: Env) -> Value:
        name = tree.function
        if isinstance(name, Name):
            if not tree.arguments:
                return self.of_name(name, env)
            if name.letter.startswith(NABLA):
                bare = Name(name.letter.removeprefix(NABLA).replace(" ", ""))
                return self.gradient(self.of_call(Call(bare, tree.arguments), env))
            if name.dots or name.subscripts or len(tree.arguments) != 1 or name.letter in self.meant:
                raise NoForm(f"{name.letter} is no function of one letter")
            return node("call", _stem(name.letter), (name.primes,), self.scalar(tree.arguments[0], env))
        if name not in OPERATORS:
            return super().of_call(tree, env)
        value = self.value(tree.arguments[0], env)
        if name == "grad":
            return self.gradient(value)
        if name == "laplacian":
            return each_part(lambda t: plus(_slope(_slope(t, x), x) for x in self.coordinates), value)
        if not isinstance(value, list):
            raise NoForm("only vectors have a divergence and a curl")
        if len(value) != len(self.coordinates):
            raise NoForm("a vector has as many components as there are coordinates")
        if name == "div":
            return plus(_slope(t, x) for t, x in zip(value, self.coordinates, strict=True))
        if len(value) != len(COORDINATES):
            raise NoForm("in the plane a curl is a number")
        ahead, behind = ((value[k] for k in order) for order in ((2, 0, 1), (1, 2, 0)))
        by = zip("yzx", "zxy", strict=True)
        return [minus(_slope(a, p), _slope(b, q)) for a, b, (p, q) in zip(ahead, behind, by, strict=True)]

    def of_mul(self, tree: Mul, env: Env) -> Value:
        for k, factor in enumerate(tree.factors):
            if isinstance(factor, Mul) and _along(factor) and k + 1 < len(tree.factors):
                along = self.value(_joined(factor.factors[:-1]), env)
                value = self.value(_joined(tree.factors[k + 1 :]), env)
                if not isinstance(along, list):
                    raise NoForm("an operator along a number")
                rate = each_part(lambda t: dot(along, [_slope(t, x) for x in self.coordinates]), value)  # noqa: B023
                before = self.scalar(_joined(tree.factors[:k]), env) if k else 1
                return each_part(lambda t: times(before, t), rate)  # noqa: B023
        for k, factor in enumerate(tree.factors[:-1], 1):
            if isinstance(factor, Name) and factor.letter.startswith(NABLA) and k not in tree.dotted:
                raise NoForm("does an operator belong to all that follows?")
        if any(_along(pair[0]) for pair in pairwise(tree.factors)) or any(x == Name(NABLA) for x in tree.factors):
            raise NoForm("an operator before nothing")
        return super().of_mul(tree, env)


def _is_other(tree: Tree) -> bool:
    """Is it a derivative, and not by time?"""
    return isinstance(tree, Derivative) and any(by != Name(TIME) for by, _ in tree.variables)


def _joined(factors: tuple[Tree, ...]) -> Tree:
    return Mul(factors) if len(factors) > 1 else factors[0]


def _stem(latex: str) -> str:
    """The letter without its type, as a name."""
    return "_".join(re.findall(r"[A-Za-z0-9]+", _bold(latex) or latex))


def _is_of_fields(formula: Formula) -> bool:
    """Is it an equation between fields, in which no coordinate stands alone?"""
    return formula.tag == "=" and bool(functions(formula)) and not _has_coordinate(formula)


def _has_coordinate(tree: Term) -> bool:
    """Does a coordinate stand elsewhere than behind a field, and below a derivative?"""
    if isinstance(tree, Binder) and tree.tag == "diff":
        return _has_coordinate(tree.body)
    if isinstance(tree, Node):
        return not isinstance(tree, Applied) and any(map(_has_coordinate, tree.outside))
    return tree in (*COORDINATES, TIME)


def _rate(equation: Formula, by: str) -> Formula:
    return node("=", *(_slope(side, by) for side in equation.outside))


def _slope(term: Term, by: str) -> Term:
    return node("diff", term, by, 1, by) if by in letters(term) else 0
