"""From the tree as printed to formulas: indices take their values, vectors and matrices their components.

A scalar is lowered to a term (see `symcheck.core.claims`), a vector to a list of terms, a matrix to a list of rows.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache, partial
from math import comb, factorial
from types import MappingProxyType
from typing import Any, TypeVar

from symcheck.core.calculus import letters, substituted
from symcheck.core.calculus import nodes as nodes_of
from symcheck.core.formulas import contrary
from symcheck.core.terms import INFINITY, MINUS_INFINITY, PI, Binder, Formula, Node, Term, mapped, node
from symcheck.core.terms import Call as Applied
from symcheck.core.verdicts import NoForm, SymcheckError, Unsaid
from symcheck.reading import tree as tree_of
from symcheck.reading.complexes import (
    UNIT,
    Complex,
    Number,
    added,
    divided,
    modulus,
    multiplied,
    negative,
    parts,
    raised,
    raised_to_whole,
)
from symcheck.reading.complexes import applied as applied_complex
from symcheck.reading.components import (
    Row,
    Value,
    det,
    dot,
    each_part,
    exponential,
    flat,
    identity,
    matmul,
    minus,
    plus,
    power,
    says,
    shape,
    skew,
    times,
    worked_out,
    zero,
    zipped,
)
from symcheck.reading.differentials import differential, refuse_uneven, total
from symcheck.reading.faces import face
from symcheck.reading.forms import (
    form,
    is_sequence,
    refuse_bare,
    refuse_doubt,
    refuse_factor,
    refuse_operator,
    refuse_order,
)
from symcheck.reading.functions import SPELLED, applied, extreme
from symcheck.reading.landau import coefficient, terms_of_order, vanishing, without
from symcheck.reading.limits import equated, limit, tends, turns
from symcheck.reading.notation import TIMES, Letter, Notation, variable
from symcheck.reading.parser import dependence, read
from symcheck.reading.printing import to_latex
from symcheck.reading.relations import Relation, relations
from symcheck.reading.rounding import is_decimal, is_number, rounds
from symcheck.reading.tree import (
    Add,
    And,
    Antiderivative,
    Bars,
    BigProduct,
    BigSum,
    Binomial,
    Blank,
    Call,
    CaseList,
    Chain,
    Cross,
    Degrees,
    Derivative,
    Diag,
    Div,
    Dots,
    ElementsOf,
    Evaluated,
    Exists,
    Factorial,
    Forall,
    Iff,
    Implies,
    Indexed,
    Infinity,
    Integral,
    Interval,
    Limiting,
    Marked,
    MatrixOf,
    Mean,
    Mul,
    Name,
    Neg,
    Norm,
    Operated,
    Or,
    Pair,
    Path,
    Piecewise,
    PlusMinus,
    Pow,
    Qualifier,
    Root,
    Sqrt,
    System,
    Total,
    Transpose,
    Tree,
    Tuple,
    Values,
    Words,
    children,
    nodes,
    with_children,
)

SHAPES_DIFFER = "do not compare"  # sides of different shapes
AND_OTHER = "and something else"  # addends of different shapes
MAX_FACTORIAL = 1000  # its digits fill a page
_PLACES = re.compile(r"_\{?([1-9](?:,?[1-9])?)\}?")  # the numbers of an entry below brackets
Env = Mapping[str, Term]  # the values of indices; a letter where a sum cannot be written out

SIGNS = {"=": "=", r"\equiv": "=", r"\ne": "!=", "<": "<", r"\le": "<=", ">": ">", r"\ge": ">="}


Kind = TypeVar("Kind", bound=Tree)
Defined = Mapping[str, tuple[tuple[Tree, ...], Tree]]  # the letters of functions, their arguments, and what they are


def lower(item: Relation | Tree, notation: Notation, defined: Defined = MappingProxyType({})) -> tuple[Formula, ...]:
    r"""Turn a printed relation, or all relations of a statement, into formulas, or into forms.

    Parameters
    ----------
    item, notation, defined
        As for `algebraic`.

    Returns
    -------
    tuple of Formula
        As `algebraic` gives them. Where nobody has declared the letters, a relation that has no algebraic form, or of
        whose letters too little is known, gives its form (see `symcheck.reading.forms`), which keeps all that is
        printed and which no proof can use.

    Raises
    ------
    SymcheckError
        If the relation can be meant in several ways, or does not fit what is declared.
    """
    lowering = Lowering(notation, defined)
    return tuple(formula for relation in _relations(item) for formula in lowering.stated(relation))


def algebraic(
    item: Relation | Tree, notation: Notation, defined: Defined = MappingProxyType({})
) -> tuple[Formula, ...]:
    r"""Turn a printed relation, or all relations of a statement, into formulas.

    Parameters
    ----------
    item
        The relation or the statement.
    notation
        What the letters mean.
    defined
        Functions that stand for expressions in their arguments: (arguments, expression) by their letter.

    Returns
    -------
    tuple of Formula
        In printed order, a formula for each value of the free indices (the first index that occurs varies slowest) and
        for each component of a vector or matrix (by rows).

    Raises
    ------
    SymcheckError
        If something has no algebraic form, shapes do not fit, or an index is misused.

    Notes
    -----
    `\pm` on one side of an equality says that one of the signs holds; on both sides that both hold, each with the upper
    or the lower signs throughout. In a list of cases or a logical formula a free index of one relation means all its
    values.
    """
    lowering = Lowering(notation, defined)
    return tuple(formula for relation in _relations(item) for formula in lowering.whole(relation))


def _relations(item: Relation | Tree) -> tuple[Relation, ...]:
    found = (item,) if isinstance(item, Relation) else relations(item)
    if not found:
        raise NoForm(f"{to_latex(item)} states no relation" if isinstance(item, Tree) else "no relation")
    for tree in (each.tree for each in found):
        first = tree.parts[0] if isinstance(tree, And) else None
        if isinstance(first, Chain) and first.signs[0] == "=" and not {*first.signs} <= {"=", r"\equiv"}:
            raise SymcheckError(f"{to_latex(first)}: a chain, or what the first letter stands for? write brackets")
    return found


def term(latex: str, notation: Notation) -> Term:
    """Read a scalar expression, and turn it into a term.

    Parameters
    ----------
    latex
        The expression, without free indices.
    notation
        What the letters mean.

    Returns
    -------
    Term
        The term.

    Raises
    ------
    SymcheckError
        If it is a relation or has a free index.
    """
    tree = read(latex, notation)
    if relations(tree):
        raise SymcheckError(f"{latex} is a relation; an expression is expected")
    if free := free_indices(tree, notation):
        raise SymcheckError(f"{latex} has the free index {free[0]}; give it a value")
    return Lowering(notation).scalar(tree, {})


def free_indices(tree: Tree, notation: Notation) -> tuple[str, ...]:
    """List the indices that no sum binds.

    Parameters
    ----------
    tree
        A printed formula.
    notation
        What the letters mean.

    Returns
    -------
    tuple of str
        The free indices in order of appearance.

    Raises
    ------
    SymcheckError
        If a bound index is also used outside its sum.
    """
    bound: set[str] = set()
    free = list(dict.fromkeys(_free(tree, notation, frozenset(), bound)))
    if both := [index for index in free if index in bound]:
        raise SymcheckError(f"index {both[0]} is summed over, and used outside of its sum, in {to_latex(tree)}")
    return tuple(free)


def _free(tree: Tree, notation: Notation, inside: frozenset[str], bound: set[str]) -> Iterator[str]:
    if isinstance(tree, Name):
        used = [s for s in tree.subscripts if isinstance(s, str)] or (
            [tree.letter] if _is_index(tree, notation) else []
        )
        yield from (index for index in used if index not in inside)
    elif isinstance(tree, BigSum):
        bound.update(tree.indices)
        for part in (tree.low, tree.high):
            if part is not None:
                yield from _free(part, notation, inside, bound)
        yield from _free(tree.body, notation, inside | set(tree.indices), bound)
    elif isinstance(tree, ElementsOf):
        own = tuple(dict.fromkeys(_free(tree.value, notation, inside, set())))
        bound.update(own)
    else:
        for child in children(tree):
            yield from _free(child, notation, inside, bound)


def _is_index(name: Name, notation: Notation) -> bool:
    return not name.subscripts and notation.find(name.letter, 0) is None and notation.index(name.letter) is not None


@lru_cache(maxsize=512)
def _components(letter: Letter, notation: Notation) -> Tree:
    assert letter.components is not None
    return read(letter.components, notation)


@lru_cache(maxsize=512)
def _vector(letter: Letter, notation: Notation) -> Tree:
    return read(letter.skew, notation)


class Lowering:
    """The evaluator: `env` gives the indices their values."""

    def __init__(self, notation: Notation, defined: Defined = MappingProxyType({})) -> None:
        self.notation, self.defined = notation, defined
        self.standing: dict[Name, Value] = {}  # what the arguments of a defined function stand for
        self.met: dict[str, Name] = {}  # variables of letters that are printed, with one place
        self.arities: dict[str, int] = {}  # how many arguments each function has
        self.tree: Tree = Blank()  # of the relation
        self.kinds: frozenset[type[Tree]] | None = None  # of all parts of the relation, where it is a whole one
        self.entered = set[str]()  # variables that are entries of printed matrices
        self.aside: list[Formula] = []  # that there are the limits in a relation
        self.inside: tuple[str, ...] = ()  # letters whose components or dependence are being written out

    # -- formulas ------------------------------------------------------------------------------------------------

    def stated(self, relation: Relation) -> list[Formula]:
        """The formulas of a relation, or its form if it has none."""
        refuse_operator(relation.tree, self.notation)
        try:
            return self.whole(relation)
        except (NoForm, Unsaid):
            if not self.notation.inferred:
                raise
            self.inside, self.standing = (), {}
            return [form(relation, self.notation)]

    def whole(self, relation: Relation) -> list[Formula]:
        """The formulas of a relation, in which every letter that is printed occurs."""
        self.met.clear()
        self.entered.clear()
        self.tree = relation.tree
        self.kinds = frozenset(type(part) for part in nodes(relation.tree))
        if Total in self.kinds:
            refuse_uneven(relation.tree)
        if Transpose in self.kinds and Call in self.kinds:
            refuse_factor(relation.tree, self.notation)
        self.aside = []
        formulas = [*self.relation(relation), *dict.fromkeys(self.aside)]
        names = _names(tuple(formulas))
        for name, printed in self.met.items():
            if name not in names and self.notation.inferred and MatrixOf in self.kinds and name in self.entered:
                formulas.append(node("=", node("*", 0, name), 0))  # an entry beside a 0: what is said of it is true
            elif name not in names:
                raise SymcheckError(
                    f"{to_latex(printed)} is multiplied by 0 and says nothing in {relation.latex}; leave it out"
                )
        return formulas

    def relation(self, relation: Relation) -> list[Formula]:
        """One formula for each instance and component."""
        tree = relation.tree
        if isinstance(tree, Chain):
            free = free_indices(tree, self.notation)
            envs = self.instances(free, relation.qualifiers)
            return [formula for env in envs for formula in self.link(tree, env)]
        inside = set(_free(tree, self.notation, frozenset(), set()))
        names = [index for q in relation.qualifiers for index in q.indices if index in inside]
        return [self.formula(tree, env) for env in self.instances(names, relation.qualifiers)]

    def instances(self, names: Iterable[str], qualifiers: Iterable[Qualifier] = ()) -> Iterator[dict[str, int]]:
        """All assignments of values to these indices; the first varies slowest."""
        order = list(dict.fromkeys(names))
        ranges = [self.range(index, qualifiers) for index in order]
        for values in itertools.product(*ranges):
            yield dict(zip(order, values, strict=True))

    def range(self, index: str, qualifiers: Iterable[Qualifier] = ()) -> tuple[int, ...]:
        for qualifier in qualifiers:
            if index in qualifier.indices:
                return qualifier.values
        letter = self.notation.index(index)
        if letter is None:
            raise SymcheckError(f"{index} is not an index; declare it as one in the notation")
        return letter.range

    def link(self, tree: Chain, env: Env) -> list[Formula]:
        """The components of every link."""
        found: list[Formula] = []
        for k, sign in enumerate(tree.signs):
            found += self.signed(tree.members[k], sign, tree.members[k + 1], env)
        return found

    def signed(self, left: Tree, sign: str, right: Tree, env: Env) -> list[Formula]:
        """One link; the double signs in it switch together."""
        double = [any(self.held(PlusMinus, side)) for side in (left, right)]
        if not any(double):
            return self.compare(left, sign, right, env)
        upper, lower = (
            self.compare(_choosing(left, lower=which), sign, _choosing(right, lower=which), env)
            for which in (False, True)
        )
        if all(double) or sign == r"\ne":
            return upper + lower
        if sign not in ("=", r"\equiv", r"\approx"):
            raise SymcheckError(
                f"{to_latex(Chain((left, right), (sign,)))}: for one sign, or for both? write a relation for each"
            )
        return [node("or", _and(upper), _and(lower))]

    def held(self, kind: type[Kind], *sides: Tree) -> Iterator[Kind]:
        """The parts of one kind, in printed order."""
        if self.kinds is None or kind in self.kinds:
            yield from (part for side in sides for part in nodes(side) if isinstance(part, kind))

    def compare(self, left: Tree, sign: str, right: Tree, env: Env) -> list[Formula]:
        if found := [*self.held(Piecewise, left, right)]:
            self.refuse_bound(found[0], left, right)
            return [self.by_cases(found[0], left, sign, right, env)]
        if jump := next((each for each in self.held(Call, left, right) if each.function in JUMPS), None):
            self.refuse_bound(jump, left, right)
            return [self.between_jumps(jump, left, sign, right, env)]
        if any(self.held(Antiderivative, left, right)):
            return self.primitive(left, sign, right, env)
        if isinstance(left, Limiting) != isinstance(right, Limiting) and sign == "=":
            return self.limit(left, right, env) if isinstance(left, Limiting) else self.limit(right, left, env)
        if orders := terms_of_order(left, right, notation=self.notation):
            return self.up_to_order(orders, left, sign, right, env)
        if sign == r"\in" and isinstance(right, Interval | Pair):
            low, high = (self.scalar(end, env) for end in children(right))
            ends = right.ends if isinstance(right, Interval) else "()"
            above, below = ">=" if ends.startswith("[") else ">", "<=" if ends.endswith("]") else "<"
            value = self.scalar(left, env)
            return [node("and", node(above, value, low), node(below, value, high))]
        if sign == "<" and isinstance(right, Infinity) and isinstance(left, Integral):
            integral = self.scalar(left, env)
            assert isinstance(integral, tuple)
            return [node("=", node("diverges", *integral[1:]), 0)]
        if sign not in SIGNS and not (sign == r"\approx" and is_number(right)):
            raise Unsaid(f"{to_latex(Chain((left, right), (sign,)))}: {sign} has no algebraic form; state it formally")
        a, b = self._alike(self.value(left, env), self.value(right, env), left, right)
        if sign == r"\approx" or (sign == "=" and self.notation.decimals == "rounded"):
            parts = zip(_parts(left, a), _parts(right, b), flat(a), flat(b), strict=True)
            return [self.rounded(*part, sign=sign) for part in parts]
        if not isinstance(a, list) and not isinstance(a, Complex) and not isinstance(b, Complex):
            return [node(SIGNS[sign], a, b)]
        if self.notation.inferred and any(isinstance(each, Complex) for each in (*flat(a), *flat(b))):
            self.refuse_values(left, right)
        pairs = [node(SIGNS[sign], *pair) for x, y in zip(flat(a), flat(b), strict=True) for pair in self.equated(x, y)]
        if sign == "=" or sign == r"\equiv":
            return pairs
        if sign == r"\ne":
            return [node("or", *pairs)]
        raise Unsaid(f"{to_latex(left)} {sign} {to_latex(right)} orders vectors; only scalars can be")

    def refuse_values(self, *sides: Tree) -> None:
        """An error for a function beside complex numbers whose own values nothing tells."""
        for call in (part for side in sides for part in nodes(side) if isinstance(part, Call)):
            name = call.function
            letter = self.notation.find(name.letter, len(name.subscripts)) if isinstance(name, Name) else None
            if letter is not None and not (letter.named or letter.components or letter.latex in self.defined):
                raise Unsaid(f"{to_latex(call)}: may its values be complex? say what they are")

    def limit(self, tree: Tree, value: Tree, env: Env) -> list[Formula]:
        """An equation that says what a limit is."""
        assert isinstance(tree, Limiting)
        x, at, body = self.approached(tree, value, env)
        found = equated(body, x, at, self.written_out(self.scalar(value, env), tree, env))
        self.met.pop(x, None)
        return found

    def approached(self, tree: Limiting, value: Tree, env: Env) -> tuple[str, Term | None, Term]:
        """What goes where in a limit, and the term that tends to a value."""
        goes = tends(tree.scripts) if tree.operator == "lim" else None
        if tree.operator == "int":
            self.value(tree, env)  # refused
        if goes is None:
            raise NoForm(f"{to_latex(tree)} has no algebraic form; state it formally")
        letter, place = goes
        elsewhere = {part.letter for part in nodes(value) if isinstance(part, Name)}
        for call in (part for part in nodes(tree.body) if isinstance(part, Call)):
            name = call.function
            if isinstance(name, Name) and name.letter not in self.defined and name.letter not in elsewhere:
                raise NoForm(f"{to_latex(tree)}: what is {to_latex(name)}? say it in an equation")
        x = self.variable(read(letter, self.notation), env)
        at = self.scalar(read(place, self.notation), env) if place else None
        return x, at, self.written_out(self.scalar(tree.body, env), tree, env)

    def of_limiting(self, tree: Limiting, env: Env) -> Value:
        """A limit in a term; that it is there is said beside the relation."""
        x, at, body = self.approached(tree, tree_of.Number("0"), env)
        found, there = limit(body, x, at)
        self.aside += there
        self.met.pop(x, None)
        return found

    def up_to_order(
        self, found: list[tuple[Tree, Path, Call]], left: Tree, sign: str, right: Tree, env: Env
    ) -> list[Formula]:
        """A relation with a term O(x^n), where x goes to 0."""
        (side, path, call), printed = found[0], Chain((left, right), (sign,))
        for each in (left, right):
            head = each.function if isinstance(each, Call) else each
            same = [part for part in nodes(printed) if isinstance(part, Name)]
            if not isinstance(head, Name) or head.letter in self.defined or each is call:
                continue
            if same.count(head) == 1:
                raise NoForm(f"{to_latex(printed)}: what is {to_latex(head)}? say it in an equation")
        if len(found) > 1 or sign not in ("=", r"\equiv") or len(call.arguments) > 1:
            raise NoForm(f"{to_latex(printed)}: only an equation with one term of an order is decided")
        assert isinstance(call.function, Name)
        a, b = (self.value(without(each, path) if each is side else each, env) for each in (left, right))
        a, b = self._alike(a, b, left, right)
        gaps = [
            self.written_out(node("+", x, node("-", y)), printed, env)
            for u, v in zip(flat(a), flat(b), strict=True)
            for x, y in self.equated(u, v)
        ]
        size, factor = self.scalar(call.arguments[0], env), self.scalar(coefficient(side, path), env)
        steps = self.notation.letter(call.function.letter, 0).order or 0
        x, formulas = vanishing(gaps, size, steps, self.written_out(factor, printed, env), printed)
        self.met.pop(x, None)
        return formulas

    def equated(self, a: Number, b: Number) -> Iterator[tuple[Term, Term]]:
        """Two numbers that are compared, or their real and imaginary parts."""
        if isinstance(a, Complex) or isinstance(b, Complex):
            real, other = (a, b) if isinstance(b, Complex) else (b, a)
            alone = set() if isinstance(real, Complex) or parts(other)[1] == 0 else letters(real)
            if not isinstance(real, Complex) and any(part.bound for part in nodes_of(real)):
                alone = set()  # integrals are real
            if len(alone) == 1 and not alone & set().union(*map(letters, parts(other))):
                (name,) = alone
                letter = self.notation.owner(name)
                raise SymcheckError(
                    f"{letter.latex if letter else name} is equal to a complex number; say that it is complex, or real"
                )
            yield from zip(parts(a), parts(b), strict=True)
        else:
            yield a, b

    def rounded(self, left: Tree, right: Tree, a: Term, b: Term, *, sign: str) -> Formula:
        """An equality with a printed number, on whichever side; two numbers and whole ones are compared exactly."""
        if sign == r"\approx":
            return rounds(a, right)
        for value, other, number in ((a, left, right), (b, right, left)):
            if is_decimal(number) and not is_number(other):
                return rounds(value, number)
        return node("=", a, b)

    def _alike(self, a: Value, b: Value, left: Tree, right: Tree) -> tuple[Value, Value]:
        """Both sides in one shape; a printed 0 stands for the zero of any shape."""
        one = {shape(a), shape(b)} in ({(), (1,)}, {(), (1, 1)})
        if one and any(isinstance(part, MatrixOf) for part in nodes(left if isinstance(a, list) else right)):
            return (next(flat(a)), b) if isinstance(a, list) else (a, next(flat(b)))  # a row times a column, printed
        if shape(a) != shape(b) or isinstance(a, Row) != isinstance(b, Row):
            if left == tree_of.Number("0"):
                return zero(b), b
            if right == tree_of.Number("0"):
                return a, zero(a)
            for side, other in ((left, right), (right, left)):
                several = isinstance(side, Call) and isinstance(other, Name) and len(side.arguments) > 2
                if several and not any(face(part.letter) for part in nodes(side) if isinstance(part, Name)):
                    raise SymcheckError(f"{to_latex(side)}: a function, or a factor before a vector? write \\cdot")
            raise Unsaid(
                f"{to_latex(left)} ({says(a)}) and {to_latex(right)} ({says(b)}) {SHAPES_DIFFER}; check the notation"
            )
        return a, b

    def formula(self, tree: Tree, env: Env) -> Formula:
        """One formula for a statement: chains, commas and free indices are conjunctions."""
        if isinstance(tree, Chain):
            free = [index for index in free_indices(tree, self.notation) if index not in env]
            return _and(f for more in self.instances(free) for f in self.link(tree, {**env, **more}))
        if isinstance(tree, System):
            names = [index for q in tree.qualifiers for index in q.indices]
            used = set(_free(tree, self.notation, frozenset(), set()))
            envs = self.instances([n for n in names if n in used], tree.qualifiers)
            stated = [part for part in tree.parts if not isinstance(part, Name)]
            return _and(self.formula(part, {**env, **more}) for more in envs for part in stated)
        if isinstance(tree, CaseList):
            if not all(label.endswith(".") for label, _ in tree.cases):
                raise NoForm(f"{to_latex(tree)} is a numbered list; state formally whether all or one of it holds")
            return node("or", *(self.formula(case, env) for _, case in tree.cases))
        if isinstance(tree, And):
            return _and(self.formula(part, env) for part in tree.parts)
        if isinstance(tree, Or):
            return node("or", *(self.formula(part, env) for part in tree.parts))
        if isinstance(tree, Implies | Iff):
            sign = "=>" if isinstance(tree, Implies) else "<=>"
            return node(sign, self.formula(tree.left, env), self.formula(tree.right, env))
        if isinstance(tree, Values):
            if not all(isinstance(value, tree_of.Number) for value in tree.values):
                raise NoForm(f"{to_latex(tree)}: values that are not written out have no algebraic form")
            return node(
                "or", *(node("=", self.scalar(tree.name, env), self.scalar(value, env)) for value in tree.values)
            )
        if isinstance(tree, Exists):
            return node("exists", tuple(self.variables(tree.names, env)), self.formula(tree.body, env))
        if isinstance(tree, Forall | Words):
            raise Unsaid(f"{to_latex(tree)} has no algebraic form; state for what it holds as a condition")
        raise Unsaid(f"{to_latex(tree)} is neither true nor false; a relation is expected")

    def variables(self, names: Iterable[Tree], env: Env) -> Iterator[str]:
        """The variables of a quantifier; a free index means all of its values."""
        for name in names:
            free = [index for index in free_indices(name, self.notation) if index not in env]
            for more in self.instances(free):
                for found in flat([self.value(name, {**env, **more})]):
                    if not isinstance(found, str):
                        raise SymcheckError(f"{to_latex(name)} is no variable; only variables can be quantified")
                    yield found

    # -- expressions ---------------------------------------------------------------------------------------------

    def scalar(self, tree: Tree, env: Env) -> Term:
        """The term of a scalar expression."""
        value = self.complex(tree, env)
        if isinstance(value, Complex):
            raise SymcheckError(f"{to_latex(tree)} is a complex number; a real one is expected here")
        return value

    def complex(self, tree: Tree, env: Env) -> Number:
        """The number, real or complex, of a scalar expression."""
        value: Value = self.value(tree, env)
        if isinstance(value, list):
            raise Unsaid(f"{to_latex(tree)} is a {says(value)}; a scalar is expected here")
        result: Number = value
        return result

    def value(self, tree: Tree, env: Env) -> Value:
        """The term, vector or matrix of an expression."""
        method: Callable[[Any, Env], Value] | None = getattr(self, f"of_{type(tree).__name__.lower()}", None)
        if isinstance(tree, Limiting) and tree.operator == "int":
            raise SymcheckError(f"{to_latex(tree)}: this integral does not say what it is taken over")
        if method is None:
            error = NoForm if isinstance(tree, Limiting | Dots) else Unsaid
            raise error(f"{to_latex(tree) or 'an operator alone'} has no algebraic form; state it formally")
        return method(tree, env)

    def of_number(self, tree: tree_of.Number, env: Env) -> Value:
        whole, _, decimals = tree.text.partition(".")
        if not decimals:
            return int(whole)
        return node("/", int(whole + decimals), 10 ** len(decimals))

    def of_name(self, tree: Name, env: Env) -> Value:
        if tree in self.standing:
            return self.standing[tree]
        if self.standing and self.changes(tree, env):
            return self.value(self.defined[tree.letter][1], env)
        if _is_index(tree, self.notation):
            return self.index(tree.letter, env)
        if not tree.subscripts and tree.letter in env and self.notation.index(tree.letter) is not None:
            raise SymcheckError(f"{tree.letter} is an index here, and a letter; give one of them another name")
        letter = self.notation.letter(tree.letter, len(tree.subscripts))
        refuse_doubt(tree, letter)
        if letter.partial and letter.partial[0] in self.defined:
            function, *by = letter.partial
            return self.put(Name(function), [self.value(x, env) for x in self.defined[function][0]], tree, env, by)
        derived = tree.primes if letter.depends and not letter.named else 0
        if tree.dots or derived:
            value = self.of_name(Name(tree.letter, tree.subscripts, tree.primes - derived), env)
            if tree.dots:
                value = self.derived(value, self.time(letter, env), tree.dots, tree)
            return self.derived(value, self.only(letter, env), derived, tree) if derived else value
        if tree.primes and (letter.depends is None or letter.named):
            error = Unsaid if letter.kind == "function" else SymcheckError
            raise error(
                f"{to_latex(tree)}: the derivative of {letter.latex}, or another letter? declare {letter.latex} with "
                "depends='x' for a function of x, depends='' if the prime makes another letter"
            )
        if letter.running:
            return self.running(letter, tree, env)
        indices = self.places(tree, letter, env)
        if letter.value is not None and not tree.primes:
            return letter.value
        if letter.number:
            if tree.primes:
                raise SymcheckError(f"{to_latex(tree)}: a number has no primes")
            return self.number(letter)
        stem = letter.stem + "prime" * tree.primes
        if letter.components is not None or letter.kind in ("vector", "matrix") or (letter.size and letter.depends):
            return self.components(letter, stem, indices)
        if letter.kind == "function" and letter.depends is None and not letter.named:
            raise Unsaid(f"{to_latex(tree)} stands without its arguments; say what it depends on, as depends='x'")
        return self.instance(letter, stem, indices, tree)

    def places(self, tree: Name, letter: Letter, env: Env) -> tuple[int, ...]:
        """The values of the indices of a letter."""
        indices = []
        for subscript in tree.subscripts:
            value = self.index(subscript, env)
            if not isinstance(value, int):
                raise Unsaid(f"{to_latex(tree)}: the sum over its index cannot be written out")
            if value not in letter.range:
                raise Unsaid(f"index {value} in {to_latex(tree)} is outside the range of {letter.latex}")
            indices.append(value)
        return tuple(indices)

    def number(self, letter: Letter) -> Number:
        """A letter that is a number."""
        if letter.number == "i":
            return UNIT
        return PI if letter.number == "pi" else node("exp", 1)

    def running(self, letter: Letter, tree: Name, env: Env) -> Value:
        """A letter whose indices run up to a letter: a function of them, and of what it depends on."""
        if letter.kind not in ("scalar", "vector", "matrix") or (tree.primes and letter.depends != ""):
            raise NoForm(f"{to_latex(tree)}: only numbers, vectors and matrices have indices that run up to a letter")
        indices = [self.index(subscript, env) for subscript in tree.subscripts]
        if letter.depends:
            indices += self.arguments(letter, ())

        def entry(place: tuple[int, ...]) -> Term:
            name = variable(letter.stem + "prime" * tree.primes, place)
            if not self.inside:
                self.met.setdefault(name, tree)
            return node("call", name, (0,) * len(indices), *indices)

        return self.of_places(letter, entry) if letter.places else entry(())

    def instance(self, letter: Letter, stem: str, indices: tuple[int, ...], printed: Name | None = None) -> Term:
        """A variable, or the function it is of the letters that it depends on."""
        name = variable(stem, indices)
        if printed is not None and not self.inside:
            self.met.setdefault(name, printed)
        if not letter.depends or letter.named:
            return name
        arguments = self.arguments(letter, indices)
        return node("call", name, (0,) * len(arguments), *arguments)

    def arguments(self, letter: Letter, indices: tuple[int, ...]) -> tuple[Term, ...]:
        """The letters that a letter depends on."""
        if letter.latex in self.inside:
            raise Unsaid(f"letter {letter.latex} depends on itself; change depends")
        self.inside = (*self.inside, letter.latex)
        env = dict(zip("ij", indices, strict=False))
        found = tuple(t for tree in self.dependence(letter) for t in flat(self.value(tree, env)))
        self.inside = self.inside[:-1]
        return found

    def dependence(self, letter: Letter) -> tuple[Tree, ...]:
        """The letters that a letter depends on, as they are read."""
        try:
            return dependence(letter, self.notation)
        except SymcheckError as error:
            raise Unsaid(str(error)) from None

    def only(self, letter: Letter, env: Env) -> str:
        """The one letter that primes differentiate by."""
        names = self.dependence(letter)
        if len(names) != 1:
            raise Unsaid(f"a prime of {letter.latex}, which depends on {letter.depends}; write a fraction")
        return self.variable(names[0], env)

    def time(self, letter: Letter, env: Env) -> str:
        """The letter that dots differentiate by."""
        if letter.components is not None and not letter.depends:
            return next((time.stem for name in TIMES if (time := self.notation.find(name, 0))), "t")
        names = [tree for tree in self.dependence(letter) if isinstance(tree, Name) and tree.letter in TIMES]
        if len(names) != 1:
            raise Unsaid(
                f"dots over {letter.latex}, which depends on {letter.depends or 'nothing'}, no time; write a fraction"
            )
        return self.variable(names[0], env)

    def variable(self, tree: Tree, env: Env) -> str:
        """The variable that a derivative, an integral or a mean is taken by."""
        found = self.scalar(tree, env)
        if not isinstance(found, str):
            raise Unsaid(f"{to_latex(tree)} is no variable; a derivative, an integral or a mean is taken by one")
        return found

    def index(self, index: int | str, env: Env) -> Term:
        if isinstance(index, int):
            return index
        if index not in env:
            raise Unsaid(f"the index {index} has no value here; sum over it or let it be free")
        return env[index]

    def components(self, letter: Letter, stem: str, indices: tuple[int, ...]) -> Value:
        if letter.components is not None:
            if stem != letter.stem:
                raise Unsaid(f"the primed {letter.latex} has no components; declare it as a letter of its own")
            env = dict(zip("ij", indices, strict=False))
            self.inside = (*self.inside, letter.latex)
            value = self.value(_components(letter, self.notation), env)
            self.inside = self.inside[:-1]
            return value
        if letter.identity:
            return identity(letter.places[0][-1])
        if letter.skew:
            return skew(self.value(_vector(letter, self.notation), {}))
        return self.of_places(letter, lambda k: self.instance(letter, stem, (*indices, *k)))

    def of_places(self, letter: Letter, entry: Callable[[tuple[int, ...]], Term]) -> Value:
        """A vector or a matrix with an entry for each place."""
        rows, *columns = letter.places
        if not columns:
            return [entry((k,)) for k in rows]
        return [[entry((k, m)) for m in columns[0]] for k in rows]

    def of_marked(self, tree: Marked, env: Env) -> Value:
        """The entry of a vector or matrix in brackets, by numbers below them, or a derivative by primes."""
        value = self.value(tree.value, env)
        variables = {call.terms for call in _calls(value)} if isinstance(value, Node) else set()
        if tree.mark.strip("'") == "" and len(variables) == 1:
            (variable, *more) = variables.pop()
            if not more and isinstance(variable, str):
                return self.derived(value, variable, len(tree.mark), tree)
        found = _PLACES.fullmatch("".join(tree.mark.split()))
        places = [int(x) - 1 for x in found[1] if x != ","] if found else []
        if not isinstance(value, list) or len(places) != len(shape(value)):
            raise NoForm(f"{to_latex(tree)} has no algebraic form; state it formally")
        for k, size in zip(places, shape(value), strict=True):
            if k >= size:
                raise Unsaid(f"{to_latex(tree)}: what stands in these brackets has no such entry")
            value = value[k]
        return value

    def of_add(self, tree: Add, env: Env) -> Value:
        values = [self.value(term, env) for term in tree.terms]
        shapes = {shape(value) for value in values}
        if len(shapes) > 1:
            raise Unsaid(f"{to_latex(tree)} adds a {says(values[0])} {AND_OTHER}; check the notation")
        return zipped(added, values)

    def of_neg(self, tree: Neg, env: Env) -> Value:
        return zipped(negative, [self.value(tree.value, env)])

    def of_mul(self, tree: Mul, env: Env) -> Value:
        refuse_order(tree, self.notation)
        scalars: list[Number] = []
        product: Value = None
        ended, rows = -1, False  # the last factor of a scalar product of two vectors; does a row come of a dot?
        for k, factor in enumerate(tree.factors):
            value = self.value(factor, env)
            if isinstance(value, list) and k in tree.dotted and ended == k - 1:
                raise SymcheckError(f"{to_latex(tree)}: which two vectors does the dot multiply? write brackets")
            contracted = k in tree.dotted and len(shape(value)) == 2 and len(shape(product)) == 1
            if contracted and isinstance(product, list):  # a dot between a vector and a matrix, as in w . J w
                product = Row(product)
            elif isinstance(value, list) and isinstance(product, list) and (k in tree.dotted or rows):
                ended = k
            rows = rows or contracted
            if isinstance(value, list):
                product = value if product is None else self.multiplied(product, value, tree, dotted=k in tree.dotted)
            if not isinstance(value if product is None else product, list):
                rows = False
                scalars.append(value if product is None else product)
                product = None
            elif not isinstance(value, list):
                scalars.append(value)
        if product is None:
            return multiplied(*scalars)
        product = list(product) if rows else product
        return zipped(lambda t: multiplied(*scalars, t), [product]) if scalars else product

    def multiplied(self, a: Value, b: Value, tree: Tree, *, dotted: bool = False) -> Value:
        if isinstance(a, Row) or isinstance(b, Row) or dotted:
            fits = shape(a)[:1] == shape(b)[:1] and not (isinstance(a, Row) and isinstance(b, Row))
            outer = isinstance(b, Row) and len(shape(a)) == 1
            if not (fits or outer) or (isinstance(b, Row) and not outer):
                raise Unsaid(f"{to_latex(tree)}: a {says(a)} before a {says(b)} is no product; check the notation")
            return dot(a, b) if dotted and len(shape(a)) == len(shape(b)) == 1 else matmul(a, b)
        if len(shape(a)) != 2 or shape(a)[1] != shape(b)[0]:
            raise Unsaid(f"{to_latex(tree)}: a {says(a)} before a {says(b)} is no product; check the notation")
        return matmul(a, b)

    def of_div(self, tree: Div, env: Env) -> Value:
        if isinstance(tree.bottom, Limiting):  # that of the reciprocal, which goes to 0 where the other grows
            inverse = Div(tree_of.Number("1"), tree.bottom.body)
            reciprocal = Limiting(tree.bottom.operator, tree.bottom.scripts, inverse)
            x, at, body = self.approached(reciprocal, tree_of.Number("0"), env)
            if at is not None and turns(body, x, at):
                raise NoForm(f"{to_latex(tree.bottom)}: this limit is there from one side alone, if at all")
            return self.value(Mul((tree.top, reciprocal)), env)
        bottom = self.complex(tree.bottom, env)
        return zipped(lambda t: divided(t, bottom), [self.value(tree.top, env)])

    def of_pow(self, tree: Pow, env: Env) -> Value:
        exponent = self.value(tree.exponent, env)
        if isinstance(tree.base, Name) and not tree.base.primes:
            letter = self.notation.find(tree.base.letter, len(tree.base.subscripts))
            if letter is not None and letter.number == "e":
                return self.exponential(tree, exponent, env)
        if isinstance(exponent, list):
            raise Unsaid(f"{to_latex(tree)}: the exponent is a {says(exponent)}")
        if isinstance(exponent, tuple) and exponent[0] == "-" and isinstance(exponent[1], int):
            exponent = -exponent[1]
        base = self.value(tree.base, env)
        if isinstance(base, list):
            return self.matrix_power(tree, base, exponent)
        if base in (-1, node("-", 1)) and self.is_whole(tree.exponent) and not isinstance(exponent, int):
            return node("cos", node("*", PI, exponent))
        if base == 0 and exponent == 0:
            raise SymcheckError(f"{to_latex(tree)} has no value on which all agree; write 1 if that is meant")
        if isinstance(base, Complex):
            whole = self.is_whole(tree.exponent) and not isinstance(exponent, int | list | Complex)
            return raised_to_whole(base, exponent) if whole else raised(base, exponent)
        if isinstance(exponent, Complex):
            return function_of("exp", multiplied(exponent, node("log", base)))
        return node("^", base, exponent) if isinstance(exponent, int) else node("pow", base, exponent)

    def exponential(self, tree: Tree, exponent: Value, env: Env) -> Value:
        """e to a number, or to a matrix whose form shows what that is."""
        if not isinstance(exponent, list):
            return function_of("exp", exponent)
        if len(shape(exponent)) != 2 or len(exponent) != len(exponent[0]):
            raise Unsaid(f"{to_latex(tree)}: the exponent is a {says(exponent)}")
        found = exponential(exponent) or exponential(self.as_defined(exponent, env))
        if found is None:
            raise NoForm(f"{to_latex(tree)}: the exponential of this matrix has no form that is read")
        return found

    def as_defined(self, value: Value, env: Env) -> Value:
        """The same with the entries that definitions give the matrices in it."""
        names = {name for row in value for entry in row for name in _free_names(entry, held=False)}
        owners = {letter.latex: letter for letter in map(self.notation.owner, sorted(names)) if letter is not None}
        by = dict[str, Term]()
        for letter in owners.values():
            by |= self.entries(letter, env)
        for name in by:
            self.met.pop(name, None)  # what is printed stands in its definition
        return [[worked_out(substituted(entry, by)) for entry in row] for row in value]

    def entries(self, letter: Letter, env: Env) -> dict[str, Term]:
        """What a definition says of each component of a letter; nothing if it has none."""
        if letter.latex not in self.defined or self.defined[letter.latex][0] or letter.components is not None:
            return {}
        own, meant = self.components(letter, letter.stem, ()), self.value(self.defined[letter.latex][1], env)
        if shape(own) != shape(meant):
            return {}
        return {name: entry for name, entry in zip(flat(own), flat(meant), strict=True) if isinstance(name, str)}

    def matrix_power(self, tree: Tree, base: Value, exponent: Value) -> Value:
        size = shape(base)
        if len(size) != 2 or size[0] != size[1] or not isinstance(exponent, int):
            if len(size) == 1 and exponent == 2:
                return dot(base, base)
            square = len(size) == 2 and size[0] == size[1]
            raise (NoForm if square else Unsaid)(f"{to_latex(tree)}: only a whole power of a square matrix is read")
        return power(base, exponent)

    def is_whole(self, tree: Tree) -> bool:
        """Is this made of whole numbers alone?"""
        if isinstance(tree, Name):
            letter = self.notation.find(tree.letter, len(tree.subscripts))
            return _is_index(tree, self.notation) or (letter is not None and letter.integer)
        whole = isinstance(tree, tree_of.Number) and tree.text.isdigit()
        return whole or (isinstance(tree, Add | Neg | Mul) and all(map(self.is_whole, children(tree))))

    def of_sqrt(self, tree: Sqrt, env: Env) -> Value:
        return node("sqrt", self.scalar(tree.value, env))

    def of_root(self, tree: Root, env: Env) -> Value:
        value, order = self.scalar(tree.value, env), self.scalar(tree.order, env)
        if order == 2:
            return node("sqrt", value)
        if isinstance(order, int) and order % 2 and not (self.notation.inferred and letters(value)):
            raise NoForm(f"{to_latex(tree)}: a root of odd order is not read; write a power of a positive number")
        return node("pow", value, node("/", 1, order))

    def of_binomial(self, tree: Binomial, env: Env) -> Value:
        top, bottom = self.scalar(tree.top, env), self.scalar(tree.bottom, env)
        if isinstance(bottom, int) and bottom < 0:
            raise NoForm(f"{to_latex(tree)}: the lower number of a binomial coefficient must not be negative")
        if not isinstance(bottom, int):
            first, *others = (node("gamma", node("+", n, 1)) for n in (top, bottom, node("+", top, node("-", bottom))))
            return node("/", first, node("*", *others))
        if isinstance(top, int) and top >= 0:
            return comb(top, bottom)
        if bottom == 0:  # whatever the letters above are
            for name in letters(top):
                self.met.pop(name, None)
            return 1
        factors = [node("+", top, node("-", k)) if k else top for k in range(bottom)]
        return node("/", node("*", *factors), factorial(bottom))

    def of_factorial(self, tree: Factorial, env: Env) -> Value:
        value = self.scalar(tree.value, env)
        if isinstance(value, int):
            if not 0 <= value <= MAX_FACTORIAL:
                raise NoForm(f"{to_latex(tree)}: only of whole numbers from 0 to {MAX_FACTORIAL}")
            return factorial(value)
        return node("gamma", node("+", value, 1))

    def of_norm(self, tree: Norm, env: Env) -> Value:
        value = self.value(tree.value, env)
        if len(shape(value)) > 1:
            raise Unsaid(f"{to_latex(tree)}: which norm of a matrix? write it out")
        return modulus(value) if isinstance(value, Complex) else length(value)

    def of_evaluated(self, tree: Evaluated, env: Env) -> Value:
        by = self.variable(tree.variable, env)
        value = each_part(lambda t: self.written_for(by, t, tree, env), self.value(tree.body, env))
        if not self.inside:
            self.met.pop(by, None)
        ends = [self.scalar(end, env) for end in (tree.high, tree.low) if end is not None]
        at = [each_part(partial(substituted, by={by: end}), value) for end in ends]
        return at[0] if len(at) == 1 else zipped(lambda high, low: added(high, negative(low)), at)

    def by_cases(self, values: Piecewise, left: Tree, sign: str, right: Tree, env: Env) -> Formula:
        """A relation with a value by cases: it holds with each value where its condition does."""
        before: list[Formula] = []
        parts: list[Formula] = []
        for value, where in values.cases:
            sides = [_put(side, values, value) for side in (left, right)]
            stated = _and(self.compare(sides[0], sign, sides[1], env))
            holds = self.formula(where, env) if where is not None else _and(map(contrary, before))
            before.append(holds)
            parts.append(node("=>", holds, stated))
        return _and(parts)

    def refuse_bound(self, values: Tree, *sides: Tree) -> None:
        """Refuses values by cases under an integral, a sum and the like, where a letter runs through all cases."""
        for each in (part for side in sides for part in nodes(side) if isinstance(part, BINDING)):
            if values in nodes(each):
                raise NoForm(f"{to_latex(each)}: values by cases stand under it; write the pieces")

    def between_jumps(self, jump: Call, left: Tree, sign: str, right: Tree, env: Env) -> Formula:
        """A relation with a function that jumps: it holds with each of its values, where it has them."""
        parts: list[Formula] = []
        count = 2 if jump.function in _OF_POINTS else 1
        if len(jump.arguments) != count:
            raise SymcheckError(
                f"{to_latex(jump)}: {jump.function} has {count} argument{'s' * (count > 1)}; write it so"
            )
        for value, where in JUMPS[str(jump.function)](*jump.arguments):
            holds = _and([node(order, self.scalar(each, env), 0) for each, order in where])
            stated = self.compare(_put(left, jump, value), sign, _put(right, jump, value), env)
            parts.append(node("=>", holds, _and(stated)))
        return _and(parts)

    def primitive(self, left: Tree, sign: str, right: Tree, env: Env) -> list[Formula]:
        """An equation with integrals without bounds: both sides have one derivative."""
        found = [node for side in (left, right) for node in nodes(side) if isinstance(node, Antiderivative)]
        for each in found:
            self.refuse_primes(each)
        variables = {self.variable(each.variable, env) for each in found}
        if sign != "=" or len(variables) != 1:
            raise Unsaid(f"{to_latex(Chain((left, right), (sign,)))}: an integral without bounds stands in equations")
        (by,) = variables
        parts = [node for side in (left, right) for node in nodes(side)]
        if parts.count(found[0].variable) == len(found) and not any(
            isinstance(part, Call) and not part.arguments for part in parts
        ):
            raise SymcheckError(f"{to_latex(found[0])}: which letters depend on {to_latex(found[0].variable)}?")
        for side in (left, right):
            own = [*nodes(side)]
            known = any(
                isinstance(p, Antiderivative) or (isinstance(p, Name) and p.letter in self.defined) for p in own
            )
            if not known and by not in letters(self.scalar(side, env)):
                raise NoForm(f"{to_latex(found[0])}: over what? the other side does not depend on {by}")
        return [node("=", self.rate(left, by, env), self.rate(right, by, env))]

    def rate(self, tree: Tree, by: str, env: Env) -> Term:
        """The derivative of a sum in which integrals without bounds are addends."""
        match tree:
            case Antiderivative():
                return self.scalar(tree.body, env)
            case Neg(value=value):
                return node("-", self.rate(value, by, env))
            case Add(terms=terms):
                return node("+", *(self.rate(each, by, env) for each in terms))
            case Mul(factors=(*factors, Antiderivative() as last)):
                constant = [self.scalar(factor, env) for factor in factors]
                if any(by in _names(each) for each in constant):
                    raise Unsaid(f"{to_latex(tree)}: a factor before this integral depends on its letter")
                return node("*", *constant, self.scalar(last.body, env))
        if any(isinstance(part, Antiderivative) for part in nodes(tree)):
            raise Unsaid(f"{to_latex(tree)}: an integral without bounds is an addend of an equation")
        return self.slope(self.scalar(tree, env), by, 1, tree, partial=False)

    def of_degrees(self, tree: Degrees, env: Env) -> Value:
        return node("/", node("*", self.scalar(tree.value, env), PI), 180)

    def of_total(self, tree: Total, env: Env) -> Value:
        """The differential of a quantity: that of each letter is one more letter."""
        return each_part(lambda t: self.total(t, tree), self.value(tree.value, env))

    def total(self, term: Term, tree: Total) -> Term:
        varying = set()
        for x in letters(term):
            letter = self.notation.owner(x)
            if self.notation.owner(differential(x)) is not None:
                raise SymcheckError(f"{to_latex(tree)}: {differential(x)} is a letter too; give it another name")
            if letter is not None and (letter.varies or letter.components is not None or self.is_defined(x)):
                varying.add(x)
        if not varying:
            raise SymcheckError(
                f"{to_latex(tree)}: how does this vary? no differential of what it depends on is printed"
            )
        self.met = {x: at for x, at in self.met.items() if x not in varying}
        return total(term, varying)

    def of_indexed(self, tree: Indexed, env: Env) -> Value:
        """A sequence at a whole number; other brackets behind a letter may be those of a product."""
        name = to_latex(tree.name)
        own = tree.name
        whole = is_sequence(tree) and len(tree.places) == 1 and self.is_whole(tree.places[0])
        if not whole or not isinstance(own, Name) or own.dots or own.primes:
            raise (Unsaid if is_sequence(tree) else SymcheckError)(
                f"{to_latex(tree)}: {name} of what is in these brackets, or times it? write round brackets, or \\cdot"
            )
        letter = self.notation.letter(own.letter, len(own.subscripts))
        place, indices = self.scalar(tree.places[0], env), self.places(own, letter, env)
        if letter.depends or letter.number or letter.components is not None or letter.identity or letter.skew:
            raise Unsaid(f"{to_latex(tree)}: {name} is no sequence")

        def entry(k: tuple[int, ...]) -> Term:
            stem = variable(letter.stem, (*indices, *k))
            if not self.inside:
                self.met.setdefault(stem, own)
            return node("call", stem, (0,), place)

        return self.of_places(letter, entry) if letter.kind in ("vector", "matrix") else entry(())

    def of_call(self, tree: Call, env: Env) -> Value:
        if isinstance(tree.function, Name):
            own, _ = self.defined.get(tree.function.letter, ((), None))
            if own and not tree.arguments:
                return self.put(tree.function, [self.value(each, env) for each in own], tree, env)
            return self.applied(tree, tree.function, env) if tree.arguments else self.value(tree.function, env)
        name = SPELLED.get(tree.function, tree.function)
        name = name if name in ("sin", "cos", "tan") else ""
        if len(tree.arguments) == 2 and name and all(isinstance(a, Name) for a in tree.arguments):
            axes = [str(self.scalar(a, env)) for a in tree.arguments]
            angle = "_".join(axes)
            if self.notation.owner(angle) is not None:
                raise SymcheckError(
                    f"{to_latex(tree)} and a letter would both be lowered to {angle}; rename the letter"
                )
            self.met = {each: at for each, at in self.met.items() if each not in axes}  # they stand in the angle's name
            return node(name, angle)
        if tree.function == "Gamma" and len(tree.arguments) == 2:  # the incomplete one; equations say which
            return node("call", "Gamma", (0, 0), *(self.scalar(a, env) for a in tree.arguments))
        if len(tree.arguments) == 1:
            value = self.value(tree.arguments[0], env)
            if tree.function == "log" and not isinstance(value, list):
                if not self.notation.log:
                    raise SymcheckError(
                        f"{to_latex(tree)}: to the base e, or 10? say log='e' or '10', or write \\ln or \\lg"
                    )
                return function_of("ln" if self.notation.log == "e" else "lg", value)
            if tree.function in OPERATIONS:
                return OPERATIONS[tree.function](tree, value)
            if tree.function == "exp" and isinstance(value, list):
                return self.exponential(tree, value, env)
            if not isinstance(value, list) and (found := function_of(tree.function, value)) is not None:
                return found
        if tree.function in ("min", "max") and len(tree.arguments) > 1:
            return extreme(tree.function, [self.scalar(argument, env) for argument in tree.arguments])
        raise NoForm(f"{to_latex(tree)} has no algebraic form; state it formally")

    def applied(self, tree: Call, name: Name, env: Env) -> Value:
        """A function of the notation with its arguments."""
        letter, met = self.notation.letter(name.letter, len(name.subscripts)), dict(self.met)
        refuse_doubt(tree, letter)
        if letter.partial and letter.partial[0] in self.defined:
            function, *by = letter.partial
            return self.put(Name(function), [self.value(argument, env) for argument in tree.arguments], tree, env, by)
        if self.defined.get(name.letter, ((), None))[0] and not name.subscripts:
            return self.put(name, [self.value(argument, env) for argument in tree.arguments], tree, env)
        arguments = tuple(t for argument in tree.arguments for t in flat(self.value(argument, env)))
        if any(isinstance(argument, Complex) for argument in arguments):
            raise Unsaid(f"{to_latex(tree)}: a function at complex numbers, whose values nothing tells")
        indices = self.places(name, letter, env)
        declared = self.arguments(letter, indices) if letter.depends else None
        if letter.named or letter.components is not None:
            if arguments != declared:
                raise Unsaid(
                    f"{to_latex(tree)}: {letter.latex} is known by its name, as a function of "
                    f"{letter.depends or 'letters that are not said'}; declare depends, or the function without named"
                )
            self.met = met  # the arguments are those that the declaration says
            return self.value(name, env)
        if declared is not None and len(arguments) != len(declared):
            raise SymcheckError(f"{to_latex(tree)}: {letter.latex} depends on {letter.depends}")
        if name.dots and arguments == declared:
            return self.value(name, env)
        if name.dots and len(arguments) == 1:
            if letter.depends is not None or not _is_time(tree.arguments[0]):
                before = dict(self.met)
                self.time(letter, env)
                self.met = before  # the time is not printed there
            name = Name(name.letter, name.subscripts, name.primes + name.dots)
        if name.dots or (name.primes and len(arguments) != 1):
            raise Unsaid(f"{to_latex(tree)}: by which argument? write the derivative as a fraction")
        orders = (name.primes,) if name.primes else (0,) * len(arguments)
        if letter.kind != "function" and letter.kind != "scalar":
            return self.value(name, env)
        if letter.size:
            return self.of_places(
                letter, lambda k: node("call", variable(letter.stem, (*indices, *k)), orders, *arguments)
            )
        stem = variable(letter.stem, indices)
        if self.arities.setdefault(stem, len(arguments)) != len(arguments):
            raise Unsaid(f"{to_latex(tree)}: {letter.latex} has another number of arguments elsewhere")
        if not self.inside:
            self.met.setdefault(stem, name)
        return node("call", stem, orders, *arguments)

    def put(self, name: Name, values: list[Value], tree: Tree, env: Env, by: Sequence[str] = ()) -> Value:
        """A defined function, or its derivative, also by some of its letters, at its arguments."""
        own, body = self.defined[name.letter]
        if len(own) != len(values):
            raise SymcheckError(f"{to_latex(tree)}: {name.letter} is a function of {len(own)} letters")
        order = name.primes + name.dots
        if by:
            return self.partial(name.letter, values, tree, env, by)
        if order and (len(own) != 1 or isinstance(values[0], list | Complex)):
            raise Unsaid(f"{to_latex(tree)}: by which argument? write the derivative as a fraction")
        kept, inside = self.standing, self.inside
        if name.letter in inside:
            raise SymcheckError(f"{to_latex(tree)}: {name.letter} is defined by itself")
        taken = {x for value in values for x in _names(tuple(flat(value)))} & self.bound_over(body, own, env)
        if taken and not order:
            raise Unsaid(f"{to_latex(tree)}: {min(taken)} runs in what {name.letter} is; write another letter")
        self.inside = (*inside, name.letter)
        self.standing = {} if order else {x: v for x, v in zip(own, values, strict=True) if isinstance(x, Name)}
        value = self.value(body, env)
        if order:
            by = self.variable(own[0], env)
            value = each_part(lambda t: node("diff", t, by, order, values[0]), value)
        self.standing, self.inside = kept, inside
        return value

    def bound_over(self, body: Tree, own: Sequence[Tree], env: Env) -> set[str]:
        """The letters that run under integrals, sums and products of the arguments of a function."""
        parts = [*nodes(body)]
        integrals = [part for part in parts if isinstance(part, Integral | Antiderivative) and self.has(part.body, own)]
        sums = [part for part in parts if isinstance(part, BigSum | BigProduct) and self.has(part.body, own)]
        indices = {self.notation.index(x) for part in sums for x in part.indices}
        found = {self.variable(part.variable, env) for part in integrals}
        return found | {letter.stem for letter in indices if letter is not None}

    def has(self, body: Tree, own: Sequence[Tree]) -> bool:
        """May one of some letters stand in a term, or in what is defined there?"""
        return any(isinstance(part, Name) and (part in own or part.letter in self.defined) for part in nodes(body))

    def changes(self, name: Name, env: Env) -> bool:
        """Is a letter in the body of a function defined by arguments for which others stand there?"""
        kept, self.standing = self.standing, {}
        moved = {x for x, value in kept.items() if self.value(x, env) != value}
        self.standing = kept
        todo, seen = [name], set[Name]()
        while moved and todo:
            each = todo.pop()
            seen.add(each)
            own, body = self.defined.get(each.letter, ((each,), each))
            if not own and each.letter not in self.inside and each == Name(each.letter):
                inside = {part for part in nodes(body) if isinstance(part, Name)}
                if inside & moved:
                    return True
                todo += inside - seen
        return False

    def partial(self, function: str, values: list[Value], tree: Tree, env: Env, by: Sequence[str]) -> Value:
        """A partial derivative of a defined function at its arguments."""
        own, body = self.defined[function]
        names = [self.variable(each, env) for each in own]
        value = self.value(body, env)
        for letter in by:
            x = self.variable(read(letter, self.notation), env)
            value = each_part(partial(_slope, by=x), value)
        if any(isinstance(each, list | Complex) for each in values):
            raise SymcheckError(f"{to_latex(tree)}: a partial derivative at numbers only")
        return each_part(lambda t: substituted(t, dict(zip(names, values, strict=True))), value)

    def of_bigsum(self, tree: BigSum, env: Env) -> Value:
        if (ends := self.ends(tree, env)) is not None:
            return self.series(tree, *ends, env)
        ranges = [self.bounds(tree, index, env) for index in tree.indices]
        values = [
            self.value(tree.body, {**env, **dict(zip(tree.indices, at, strict=True))})
            for at in itertools.product(*ranges)
        ]
        if not values:
            raise SymcheckError(f"{to_latex(tree)} is an empty sum; check its bounds")
        return values[0] if len(values) == 1 else zipped(added, values)

    def of_bigproduct(self, tree: BigProduct, env: Env) -> Value:
        if (ends := self.ends(tree, env)) is not None:
            (index,), (low, high) = tree.indices, ends
            letter = self.notation.index(index)
            if letter is None or high == INFINITY:
                raise NoForm(f"{to_latex(tree)}: a product without end has no algebraic form")
            return node("product", self.scalar(tree.body, {**env, index: letter.stem}), letter.stem, low, high)
        ranges = [self.bounds(tree, index, env) for index in tree.indices]
        values = [
            self.complex(tree.body, {**env, **dict(zip(tree.indices, at, strict=True))})
            for at in itertools.product(*ranges)
        ]
        if len(values) < 2:
            raise Unsaid(f"{to_latex(tree)} is a product of fewer than two factors; check its bounds")
        return multiplied(*values)

    def ends(self, tree: BigSum, env: Env) -> tuple[Term, Term] | None:
        """The bounds of a sum that cannot be written out."""
        if tree.low is None or tree.high is None or len(tree.indices) != 1:
            return None
        low, high = self.scalar(tree.low, env), self.bound(tree.high, env)
        return None if isinstance(low, int) and isinstance(high, int) else (low, high)

    def series(self, tree: BigSum, low: Term, high: Term, env: Env) -> Value:
        """A sum up to a letter, or to infinity; its index is a letter in the body."""
        (index,) = tree.indices
        letter = self.notation.index(index)
        if letter is None:
            raise SymcheckError(f"{index} is not an index; declare it as one in the notation")
        body = self.value(tree.body, {**env, index: letter.stem})
        return zipped(lambda *t: _series(letter.stem, low, high, *t), [body])

    def bounds(self, tree: BigSum, index: str, env: Env) -> tuple[int, ...]:
        if tree.low is None or tree.high is None:
            return self.range(index)
        if isinstance(tree.high, Infinity):
            raise NoForm(f"{to_latex(tree)}: a sum without end has no algebraic form; state a finite one")
        low, high = self.scalar(tree.low, env), self.scalar(tree.high, env)
        if not isinstance(low, int) or not isinstance(high, int):
            raise Unsaid(f"{to_latex(tree)}: the bounds of a sum must be whole numbers")
        return tuple(range(low, high + 1))

    def of_pair(self, tree: Pair, env: Env) -> Value:
        u, v = self.value(tree.left, env), self.value(tree.right, env)
        if len(shape(u)) != 1 or shape(u) != shape(v):
            raise Unsaid(f"{to_latex(tree)} is a scalar product of two vectors only; check the notation")
        return dot(u, v)

    def of_tuple(self, tree: Tuple, env: Env) -> Value:
        if tree.kind == "{}":
            raise NoForm(f"{to_latex(tree)} is a set; it has no algebraic form")
        entries = [self.scalar(item, env) for item in _written_out(tree)]
        return self.combination(tree, entries) if tree.kind == "[]" and self.notation.bracket else entries

    def combination(self, tree: Tuple, scalars: list[Term]) -> Value:
        """What a list in square brackets means where it is a combination of vectors: the k-th entry times the k-th."""
        letter = self.notation.letter(self.notation.bracket, 1)
        numbers = range(1, len(scalars) + 1)
        if not set(numbers) <= set(letter.range):
            known = f"{letter.latex} has the indices {', '.join(map(str, letter.range))}"
            raise SymcheckError(f"{to_latex(tree)} has {len(scalars)} entries, but {known}")
        vectors = [self.components(letter, letter.stem, (k,)) for k in numbers]
        return [dot(scalars, list(column)) for column in zip(*vectors, strict=True)]

    def of_cross(self, tree: Cross, env: Env) -> Value:
        u, v = self.value(tree.left, env), self.value(tree.right, env)
        if not isinstance(u, list) and not isinstance(v, list):
            return multiplied(u, v)
        if shape(u) != (3,) or shape(v) != (3,):
            raise Unsaid(f"{to_latex(tree)} is a cross product of two vectors only; check the notation")
        return [minus(times(u[p], v[q]), times(u[q], v[p])) for p, q in ((1, 2), (2, 0), (0, 1))]

    def of_operated(self, tree: Operated, env: Env) -> Value:
        """Kronecker's product of matrices; of vectors the sign means one of several things."""
        a, b = self.value(tree.left, env), self.value(tree.right, env)
        if tree.sign != r"\otimes" or len(shape(a)) != 2 or len(shape(b)) != 2:
            raise NoForm(f"{to_latex(tree)} has no algebraic form; state it formally")
        return [[multiplied(x, y) for x in left for y in right] for left in a for right in b]

    def of_transpose(self, tree: Transpose, env: Env) -> Value:
        if not self.defined:
            refuse_bare(tree, self.notation)
        value = self.value(tree.value, env)
        if len(shape(value)) == 1 and not isinstance(tree.value, Tuple):
            return list(value) if isinstance(value, Row) else Row(value)
        if not isinstance(value, list):
            raise Unsaid(f"{to_latex(tree)} transposes a scalar; declare T as a letter if it is an exponent")
        if len(shape(value)) != 2:
            return value
        columns = [list(column) for column in zip(*value, strict=True)]
        return [entry for (entry,) in columns] if len(value) == 1 else columns  # a column is a vector

    def of_matrixof(self, tree: MatrixOf, env: Env) -> Value:
        rows = [[self.scalar(entry, env) for entry in row] for row in tree.rows]
        self.entered |= {entry for row in rows for entry in row if isinstance(entry, str)}
        return [row[0] for row in rows] if len(rows[0]) == 1 else rows

    def of_diag(self, tree: Diag, env: Env) -> Value:
        entries = [self.scalar(entry, env) for entry in tree.entries]
        return [[entry if k == m else 0 for m in range(len(entries))] for k, entry in enumerate(entries)]

    def of_bars(self, tree: Bars, env: Env) -> Value:
        value = self.value(tree.value, env)
        if isinstance(value, Complex):
            return modulus(value)
        if len(shape(value)) < 2:
            return length(value)
        return determinant(tree, value)

    def of_elementsof(self, tree: ElementsOf, env: Env) -> Value:
        inner = [index for index in free_indices(tree.value, self.notation) if index in tree_indices(tree.value)]
        if len(inner) != 2:
            raise SymcheckError(f"{to_latex(tree)} must have two free indices: row and column")
        row, column = inner
        if row.lstrip("\\") > column.lstrip("\\"):
            raise SymcheckError(
                f"{to_latex(tree)}: does {row} count rows, or columns? write the rows' index as the earlier letter"
            )
        return [
            [self.scalar(tree.value, {**env, row: k, column: m}) for m in self.range(column)] for k in self.range(row)
        ]

    def of_integral(self, tree: Integral, env: Env) -> Value:
        self.refuse_primes(tree)
        by, body = self.variable(tree.variable, env), self.complex(tree.body, env)
        low, high = self.bound(tree.low, env), self.bound(tree.high, env)
        for part in parts(body):
            self.refuse_unsaid(part, by, tree)
        return each_part(lambda t: node("integral", t, by, low, high), body)

    def refuse_primes(self, tree: Integral | Antiderivative) -> None:
        """An error for letters with and without primes under an integral, of which nobody says what the primes are."""
        names = {node for node in nodes(tree.body) if isinstance(node, Name) and self.notation.inferred}
        for name in names:
            letter = self.notation.find(name.letter, len(name.subscripts))
            if name.primes and replace(name, primes=0) in names - {tree.variable} and letter and letter.depends == "":
                raise Unsaid(f"{to_latex(name)}: a derivative by {to_latex(tree.variable)}? say on what it depends")

    def bound(self, tree: Tree, env: Env) -> Term:
        """A bound of an integral; infinity is an end of its own."""
        if isinstance(tree, Infinity):
            return INFINITY
        return MINUS_INFINITY if tree == Neg(Infinity()) else self.scalar(tree, env)

    def of_mean(self, tree: Mean, env: Env) -> Value:
        phase, body = self.variable(tree.phase, env), self.value(tree.body, env)
        for part in flat(body):
            self.refuse_unsaid(part, phase, tree)
        return zipped(lambda t: node("mean", t, phase), [body])

    def of_derivative(self, tree: Derivative, env: Env) -> Value:
        value = self.value(tree.body, env)
        for variable_tree, order in tree.variables:
            by = self.value(variable_tree, env)
            if tree.partial and len(shape(by)) == 1:
                value = self.by_components(value, by, order, tree, env)
            elif isinstance(by, Applied) and not tree.partial:
                value = self.along(value, by, order, tree)
            else:
                place = by if isinstance(by, Applied) else self.variable(variable_tree, env)
                value = self.by_place(value, place, order, tree, env)
        return value

    def by_components(self, value: Value, by: list[Term], order: int, tree: Derivative, env: Env) -> Value:
        """The partial derivatives of a number by the components of a column, or a row, of letters."""
        if isinstance(value, list) or order != 1:
            raise Unsaid(f"{to_latex(tree)}: are its rows those of what is differentiated? write it out")
        places = [self.as_rate(self.written_out(each, tree, env), tree) for each in by]
        if len({*places}) < len(places):
            raise Unsaid(f"{to_latex(tree)}: a derivative by letters of which two are the same; write it out")
        if not all(isinstance(each, str | Applied) for each in places):
            raise Unsaid(f"{to_latex(tree)}: a derivative by what is no letter; write it out")
        return type(by)(self.by_place(value, each, 1, tree, env) for each in places)

    def as_rate(self, term: Term, tree: Tree) -> Term:
        """A derivative of the value of a function as that of its rate."""
        if isinstance(term, Binder) and term.tag == "diff" and isinstance(term.body, Applied):
            order, _ = term.outside
            return self.slope(term.body, term.letter, int(str(order)), tree, partial=False)
        return term

    def by_place(self, value: Value, by: Any, order: int, tree: Derivative, env: Env) -> Value:
        """The derivative by a variable, or the partial one by the value of a function."""
        if isinstance(by, Applied):
            return each_part(partial(self.by_function, by=by, order=order, tree=tree, env=env), value)
        return self.derived(value, by, order, tree, partial=tree.partial)

    def along(self, value: Value, by: Applied, order: int, tree: Derivative) -> Value:
        r"""The total derivative by what depends on another letter, as `\dot r / \dot \theta` for `dr / d\theta`."""
        if len(by.terms) != 1 or not isinstance(by.terms[0], str) or any(by.orders):
            raise SymcheckError(f"{to_latex(tree)}: a total derivative by what is no letter that depends on another")
        time = by.terms[0]
        rate = self.slope(by, time, 1, tree, partial=False)
        for _ in range(order):
            value = each_part(lambda t: node("/", self.slope(t, time, 1, tree, partial=False), rate), value)
        return value

    def by_function(self, term: Term, by: Applied, order: int, tree: Derivative, env: Env) -> Term:
        """The partial derivative by the value of a function, or of its rate, which stands as a letter of its own."""
        letter = "_".join([by.function, "at", *map(str, by.orders)])
        term = self.written_out(term, tree, env)

        def put(part: Term) -> Term:
            if part == by:
                return letter
            return mapped(part, put) if isinstance(part, Node) else part

        if isinstance(term, Applied) and term != by and by.function != term.function:
            raise Unsaid(f"{to_latex(tree)}: how does {term.function} depend on {by.function}? write it out")
        return node("diff", put(term), letter, order, by)

    def written_out(self, term: Term, tree: Tree, env: Env) -> Term:
        """A term without letters that are defined: only their definitions show on what they depend."""
        while named := next(filter(self.is_defined, _free_names(term, held=False)), None):
            letter = self.notation.owner(named)
            if letter is None or letter.latex not in self.defined or letter.latex in self.inside:
                raise SymcheckError(f"{to_latex(tree)}: how does {named} depend on what it is differentiated by?")
            self.met.pop(named, None)  # what is printed stands in its definition
            self.inside = (*self.inside, letter.latex)
            several = letter.kind in ("vector", "matrix")
            meant = self.entries(letter, env).get(named) if several else self.scalar(self.defined[letter.latex][1], env)
            if meant is None:
                raise SymcheckError(f"{to_latex(tree)}: how does {named} depend on what it is differentiated by?")
            term = written(term, named, self.written_out(meant, tree, env))
            self.inside = self.inside[:-1]
        return term

    def written_for(self, by: str, term: Term, tree: Tree, env: Env) -> Term:
        """A term without the letters that definitions say to depend on another."""
        for name in sorted({*_free_names(term, held=False)} - {by}):
            letter = self.notation.owner(name)
            if letter is not None and letter.latex in self.defined:
                met = {**self.met}
                meant = self.written_out(name, tree, env)
                if by in _free_names(meant, held=False):
                    term = written(term, name, meant)
                else:
                    self.met = met
        return term

    def is_defined(self, name: str) -> bool:
        """Is this a variable of a letter that a definition says?"""
        letter = self.notation.owner(name)
        return letter is not None and (letter.named or letter.latex in self.defined)

    def derived(self, value: Value, by: str, order: int, tree: Tree, *, partial: bool = False) -> Value:
        """The derivative of a scalar, or of each component, by a variable."""
        if not order:
            return value
        return each_part(lambda t: self.slope(t, by, order, tree, partial=partial), value)

    def slope(self, term: Term, by: str, order: int, tree: Tree, *, partial: bool) -> Term:
        """The derivative of a term; that of a function by one of its arguments is the function of a higher order."""
        if isinstance(term, Applied):
            name, orders, arguments = term.function, term.orders, term.terms
            elsewhere = any(by in _names(argument) for argument in arguments if argument != by)
            if arguments.count(by) == 1 and (partial or not elsewhere):
                if not partial:
                    self.refuse_unsaid(term, by, tree)
                k = arguments.index(by)
                return node("call", name, (*orders[:k], orders[k] + order, *orders[k + 1 :]), *arguments)
        if partial and _through(term, by):
            raise SymcheckError(
                f"{to_latex(tree)}: are the functions of {by} held constant, or not? write a total derivative"
            )
        if partial:
            self.refuse_through(term, by, tree)
        if partial and (explicit := self.explicit(term, by, tree)) is not None:
            return node("diff", explicit, f"{by}_alone", order, by)
        self.refuse_unsaid(term, by, tree, held=partial)
        return node("diff", term, by, order, by)

    def refuse_through(self, term: Term, by: str, tree: Tree) -> None:
        """Unsaid where a variable stands beside what is defined by it alone: that may be held constant, or not.

        A length such as the root of x^2 + y^2 is none of the coordinates, so that it changes with each of them.
        """
        inside, met = self.inside, {**self.met}
        todo, seen, held = [term], set[str](), ""
        while todo:
            names = {*_free_names(todo.pop(), held=False)} - seen
            seen |= names
            for name in sorted(names - {by}):
                letter = self.notation.owner(name)
                if letter is None or letter.latex not in self.defined or letter.kind != "scalar":
                    continue
                with suppress(SymcheckError):
                    todo.append(self.scalar(self.defined[letter.latex][1], {}))
                    others = {*_free_names(self.written_out(name, tree, {}), held=False)}
                    fellows = [x for x in others - {by} if _is_coordinate(self.notation.owner(x))]
                    if by in others and by in names and (_is_coordinate(letter) or not fellows):
                        held = held or letter.latex
                self.inside, self.met = inside, {**met}
        self.inside, self.met = inside, met
        if held:
            raise Unsaid(f"{to_latex(tree)}: is {held} held constant, or not? write it out")

    def explicit(self, term: Term, by: str, tree: Tree) -> Term | None:
        """The term with another letter in the place of a variable where that stands itself; None if that is all.

        Beside total derivatives a partial one holds constant what depends on the variable alone. Beside partial ones by
        letters that depend on nothing it holds constant only these, its fellow coordinates. Else that is not said.
        """
        inside, met, written = self.inside, self.met, {**self.met}
        self.met = written
        with suppress(SymcheckError):
            term = self.written_out(term, tree, {})
        self.inside, self.met = inside, met
        derivatives = [part for part in nodes(self.tree) if isinstance(part, Derivative)]
        own = {part.function for part in _calls(term) if part.terms == (by,)}
        for body in (part.body for part in derivatives if part.partial):
            name = body.function if isinstance(body, Call) else body
            letter = self.notation.find(name.letter, len(name.subscripts)) if isinstance(name, Name) else None
            own -= {letter.stem} if letter else set()
        own -= self.of_argument(tree, by, own)
        if not own:
            return None
        alone = _alone(term, by, f"{by}_alone")
        total = any(isinstance(part, Name) and part.dots for part in nodes(self.tree)) or any(
            not part.partial for part in derivatives
        )
        others = {name for part in derivatives for name, _ in part.variables if isinstance(name, Name)} - {Name(by)}
        known = [self.notation.find(name.letter, len(name.subscripts)) for name in others]
        if alone == term and not total and any(letter and not letter.depends for letter in known):
            return None
        if alone == term or not total:
            raise Unsaid(f"{to_latex(tree)}: is {min(own)} held constant, or not? write a total derivative, or what is")
        self.met = written  # what is defined stands in its definition
        return alone

    def of_argument(self, tree: Tree, by: str, among: Collection[str]) -> set[str]:
        """The functions that stand in what a function of the letter and of others is, and are none of its arguments."""
        body = tree.body if isinstance(tree, Derivative) else tree
        name = body.function if isinstance(body, Call) else body
        own = self.defined.get(name.letter, ((), None))[0] if isinstance(name, Name) else ()
        letters_ = [self.notation.find(x.letter, len(x.subscripts)) for x in own if isinstance(x, Name)]
        stems = [letter.stem for letter in letters_ if letter is not None]
        return {*among} - {*stems} if len(stems) > 1 and by in stems else set()

    def refuse_unsaid(self, term: Term, by: str, tree: Tree, *, held: bool = False) -> None:
        """SymcheckError where it is not said whether a letter depends on a variable; `held`: arguments are constant."""
        for name in dict.fromkeys(_free_names(term, held=held)):
            letter = self.notation.owner(name)
            index = self.notation.index(name) is not None
            if name == by or index or (letter and (letter.named or letter.depends is not None)):
                continue
            shown = letter.latex if letter else name
            by_letter = self.notation.owner(by)
            raise Unsaid(
                f"{to_latex(tree)}: does {shown} depend on {by}? declare {shown} with "
                f"depends={(by_letter.latex if by_letter else by)!r} if it does, depends='' if it is constant"
            )


def function_of(name: str, value: Number) -> Number | None:
    """A function by its printed name at a number; None if it has no algebraic form."""
    return applied_complex(name, value) if isinstance(value, Complex) else applied(name, value)


def length(value: Value) -> Term:
    """The absolute value of a number, the length of a vector."""
    return node("sqrt", dot(value, value) if isinstance(value, list) else node("^", value, 2))


def determinant(tree: Tree, value: Value) -> Value:
    """The determinant of a square matrix."""
    size = shape(value)
    if len(size) != 2 or size[0] != size[1]:
        raise Unsaid(f"{to_latex(tree)}: only a square matrix has a determinant")
    return det(value)


def _trace(tree: Tree, value: Value) -> Value:
    size = shape(value)
    if len(size) != 2 or size[0] != size[1]:
        raise Unsaid(f"{to_latex(tree)}: only a square matrix has a trace")
    return plus(value[k][k] for k in range(size[0]))


def _columns(tree: Tree, value: Value) -> Value:
    """The columns of a matrix, one below the other."""
    if len(shape(value)) != 2:
        raise Unsaid(f"{to_latex(tree)}: only a matrix has columns")
    return [entry for column in zip(*value, strict=True) for entry in column]


def _part(k: int) -> Callable[[Tree, Value], Value]:
    def of(tree: Tree, value: Value) -> Value:
        if not any(isinstance(part, Complex) for part in flat(value)):
            raise SymcheckError(f"{to_latex(tree)}: nothing in it is imaginary; say which letter is the imaginary unit")
        return zipped(lambda t: parts(t)[k], [value])

    return of


OPERATIONS: dict[str, Callable[[Tree, Value], Value]] = {  # functions of matrices, and parts of complex numbers
    "det": determinant, "tr": _trace, "Tr": _trace, "vec": _columns, "Re": _part(0), "Im": _part(1),
}  # fmt: skip


COORDINATES = frozenset({"x", "y", "z", "t", "q", "p", r"\theta", r"\phi", r"\varphi"})
BINDING = (Integral, Antiderivative, BigSum, Limiting, Derivative, Total)
Jumps = Iterator[tuple[Tree, tuple[tuple[Tree, str], ...]]]  # values, each with the signs of terms where it is that


def _sign(t: Tree) -> Jumps:
    yield tree_of.Number("1"), ((t, ">"),)
    yield tree_of.Number("0"), ((t, "="),)
    yield Neg(tree_of.Number("1")), ((t, "<"),)


def _angle_of(y: Tree, x: Tree) -> Jumps:
    """The angle of a point in (-pi, pi]."""
    angle, right, half = (
        Call("arctan", (tree_of.Div(y, x),)),
        *(tree_of.Degrees(tree_of.Number(n)) for n in ("90", "180")),
    )
    yield angle, ((x, ">"),)
    yield Add((angle, half)), ((x, "<"), (y, ">="))
    yield Add((angle, Neg(half))), ((x, "<"), (y, "<"))
    yield right, ((x, "="), (y, ">"))
    yield Neg(right), ((x, "="), (y, "<"))


def _argument(z: Tree) -> Jumps:
    """The angle of a complex number in (-pi, pi]."""
    return _angle_of(Call("Im", (z,)), Call("Re", (z,)))


def _argument_above(z: Tree) -> Jumps:
    """That in [0, 2 pi), as some have it."""
    below = Call("Im", (z,)), "<"
    whole = tree_of.Degrees(tree_of.Number("360"))
    for angle, where in _argument(z):
        if len(where) == 1:
            yield angle, (*where, (below[0], ">="))
            yield Add((angle, whole)), (*where, below)
        else:
            yield (Add((angle, whole)) if below in where else angle), where


ABOVE = "argument in [0, 2 pi)"
JUMPS: dict[str, Callable[..., Jumps]] = {
    "sgn": _sign, "sign": _sign, "atan2": _angle_of, "arctan2": _angle_of, "arg": _argument, "Arg": _argument,
    ABOVE: _argument_above,
}  # fmt: skip
_OF_POINTS = frozenset({"atan2", "arctan2"})  # which have two arguments


def _put(tree: Tree, old: Tree, new: Tree) -> Tree:
    """The tree with another in the place of one that stands in it."""
    if tree == old:
        return new
    return with_children(tree, tuple(_put(child, old, new) for child in children(tree)))


def _series(index: str, low: Term, high: Term, body: Value) -> Value:
    if isinstance(body, Complex):
        return Complex(*(node("sum", part, index, low, high) if part != 0 else 0 for part in parts(body)))
    return node("sum", body, index, low, high)


def _is_coordinate(letter: Letter | None) -> bool:
    return letter is not None and letter.latex.partition("_")[0] in COORDINATES


def _is_time(tree: Tree) -> bool:
    """Is this the time, or an instant such as `t_0`?"""
    return isinstance(tree, Name) and tree.letter.partition("_")[0] in TIMES


def _names(tree: object) -> set[str]:
    """Every name in a term or in formulas, those of functions too; parts that stand in several places count once."""
    found, met, todo = set[str](), set[int](), [tree]
    while todo:
        part = todo.pop()
        if isinstance(part, str):
            found.add(part)
        elif isinstance(part, tuple) and id(part) not in met:
            met.add(id(part))
            todo += part
    return found


def _free_names(term: Term, *, held: bool) -> Iterator[str]:
    """The variables of a term that no integral binds; with `held` not those that are arguments themselves."""
    if isinstance(term, str):
        yield term
    elif isinstance(term, Node):
        own = [part for part in term.outside if not (held and term.tag == "call" and isinstance(part, str))]
        for part in (*term.inside, *own):
            yield from (name for name in _free_names(part, held=held) if name not in term.bound)


def _through(term: Term, by: str) -> bool:
    """Does a function have an argument with a function of the variable in it?"""
    return any(by in _names(inner) for call in _calls(term) for part in call.terms for inner in _calls(part))


def _calls(term: Term) -> Iterator[Applied]:
    """The values of functions in a term."""
    if isinstance(term, Applied):
        yield term
    for part in (*term.inside, *term.outside) if isinstance(term, Node) else ():
        yield from _calls(part)


def _alone(term: Term, name: str, other: str) -> Term:
    """A term with another letter in the place of one, but for the arguments of functions."""
    if term == name:
        return other
    if isinstance(term, Applied) or not isinstance(term, Node):
        return term
    return mapped(term, lambda part: _alone(part, name, other))


def _slope(term: Term, by: str) -> Term:
    return node("diff", term, by, 1, by)


def written(term: Term, name: str, meant: Term) -> Term:
    """The term with a definition in the place of its letter; what that says of a bound letter is said of this one."""
    if term == name:
        return meant
    if not isinstance(term, Node) or name in term.bound:
        return term
    return mapped(term, lambda part: written(part, name, meant))


def tree_indices(tree: Tree) -> set[str]:
    """All index letters that occur as subscripts."""
    found = {s for s in tree.subscripts if isinstance(s, str)} if isinstance(tree, Name) else set()
    return found.union(*(tree_indices(child) for child in children(tree)))


def _choosing(tree: Tree, *, lower: bool) -> Tree:
    """The tree with the upper signs of all double ones, or with the lower ones."""
    chosen = with_children(tree, tuple(_choosing(child, lower=lower) for child in children(tree)))
    if isinstance(chosen, PlusMinus):
        return chosen.value if chosen.minus == lower else Neg(chosen.value)
    return chosen


def _parts(tree: Tree, value: Value) -> Iterable[Tree]:
    """What is printed for each component of a value: the entries of a list, else the whole."""
    if isinstance(tree, Tuple) and tree.kind == "()":
        return _written_out(tree)
    return itertools.repeat(tree, sum(1 for _ in flat(value)))


def _written_out(tree: Tuple) -> Iterator[Tree]:
    r"""The items of a list, with dots written out: `(\zeta_1, \dots, \zeta_6)`."""
    for k, item in enumerate(tree.items):
        if not isinstance(item, Dots):
            yield item
            continue
        before, after = (tree.items[m] if 0 <= m < len(tree.items) else None for m in (k - 1, k + 1))
        if not isinstance(before, Name) or not isinstance(after, Name) or before.letter != after.letter:
            raise Unsaid(f"{to_latex(tree)}: dots must stand between two indices of one letter")
        match before.subscripts, after.subscripts:
            case (int(low),), (int(high),) if low < high:
                yield from (Name(before.letter, (n,), before.primes) for n in range(low + 1, high))
            case _:
                raise Unsaid(f"{to_latex(tree)}: dots must stand between two indices of one letter")


def _and(formulas: Iterable[Formula]) -> Formula:
    parts = tuple(formulas)
    return parts[0] if len(parts) == 1 else node("and", *parts)
