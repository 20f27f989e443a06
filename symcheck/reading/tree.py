"""The tree of a formula as printed: nothing is evaluated, only brackets that change nothing are forgotten."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import TypeVar

T = TypeVar("T", bound="Tree")


class Tree:
    """A node; two trees are equal if they are printed alike."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Number(Tree):
    """A printed number: `2`, `0.75`; never negative."""

    text: str


@dataclass(frozen=True, slots=True)
class Name(Tree):
    """A declared letter with its indices (numbers or index letters), primes, and dots where they are a derivative."""

    letter: str
    subscripts: tuple[int | str, ...] = ()
    primes: int = 0
    dots: int = 0


@dataclass(frozen=True, slots=True)
class Add(Tree):
    """Two or more terms; a subtracted one is a Neg."""

    terms: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Neg(Tree):
    value: Tree


@dataclass(frozen=True, slots=True)
class PlusMinus(Tree):
    r"""A term behind `\pm` (or `\mp`: `minus`); all double signs of a relation switch together."""

    value: Tree
    minus: bool = False


@dataclass(frozen=True, slots=True)
class Mul(Tree):
    """Two or more factors in printed order; before those `dotted` stands a dot that may be one of a scalar product."""

    factors: tuple[Tree, ...]
    dotted: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Div(Tree):
    r"""`\frac{a}{b}` or `a/b`."""

    top: Tree
    bottom: Tree


@dataclass(frozen=True, slots=True)
class Pow(Tree):
    base: Tree
    exponent: Tree


@dataclass(frozen=True, slots=True)
class Call(Tree):
    r"""A function applied: `\sin 2\alpha`, `\cos(Oy_i, Ox_j)`, `f_1(J_2)`; a bare letter has those it depends on."""

    function: str | Name
    arguments: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Sqrt(Tree):
    value: Tree


@dataclass(frozen=True, slots=True)
class Root(Tree):
    r"""`\sqrt[n]{x}`."""

    value: Tree
    order: Tree


@dataclass(frozen=True, slots=True)
class Binomial(Tree):
    r"""`\binom{n}{k}`."""

    top: Tree
    bottom: Tree


@dataclass(frozen=True, slots=True)
class Piecewise(Tree):
    r"""`\begin{cases} a & x < 0 \\ b & x > 0 \end{cases}`; the last condition is None for "otherwise"."""

    cases: tuple[tuple[Tree, Tree | None], ...]


@dataclass(frozen=True, slots=True)
class Factorial(Tree):
    """`n!`."""

    value: Tree


@dataclass(frozen=True, slots=True)
class Degrees(Tree):
    r"""An angle in degrees, `45^\circ`."""

    value: Tree


@dataclass(frozen=True, slots=True)
class BigSum(Tree):
    r"""`\sum_{i=1}^3 body`: the body runs to the end of the product; no bounds: over the range of the index."""

    indices: tuple[str, ...]
    low: Tree | None
    high: Tree | None
    body: Tree


@dataclass(frozen=True, slots=True)
class BigProduct(BigSum):
    r"""`\prod_{i=1}^3 body`, as a sum is printed."""


@dataclass(frozen=True, slots=True)
class Limiting(Tree):
    r"""`\lim_{x \to 0} body`, `\min_x body` and sums over sets: the scripts are kept as printed."""

    operator: str
    scripts: str
    body: Tree


@dataclass(frozen=True, slots=True)
class Marked(Tree):
    r"""A bracket with a script that is no power: `(A)^+`, `(a)_n`; `mark` is the script as printed."""

    value: Tree
    mark: str


@dataclass(frozen=True, slots=True)
class Indexed(Tree):
    """`x[n]`: a letter with places in square brackets, as an entry of a sequence has, or a value of a function."""

    name: Tree
    places: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Operated(Tree):
    r"""`a \otimes b`: two terms with a sign between them of which the notation says nothing."""

    sign: str
    left: Tree
    right: Tree


@dataclass(frozen=True, slots=True)
class Given(Tree):
    """`(a | b)`: what stands before a bar in brackets, on the condition behind it; or `(x; p)`, with parameters."""

    items: tuple[Tree, ...]
    conditions: tuple[Tree, ...]
    sign: str = "|"


@dataclass(frozen=True, slots=True)
class Words(Tree):
    r"""`\text{in orbit}` beside relations: when they hold, or what they are, in words."""

    name: Tree


@dataclass(frozen=True, slots=True)
class Forall(Tree):
    r"""`\forall x`, `\forall x \in S`: what a statement beside it holds for."""

    scope: Tree


@dataclass(frozen=True, slots=True)
class Infinity(Tree):
    r"""`\infty`: only as a bound, or to say that an integral converges."""


@dataclass(frozen=True, slots=True)
class Integral(Tree):
    r"""`\int_a^b f \, dx`: the integrand is the product before the differential."""

    body: Tree
    variable: Tree
    low: Tree
    high: Tree


@dataclass(frozen=True, slots=True)
class Antiderivative(Tree):
    r"""`\int f \, dx` without bounds: known up to a constant."""

    body: Tree
    variable: Tree


@dataclass(frozen=True, slots=True)
class Over(Tree):
    r"""`\int_S f \, dx`, `\oint f \, ds`: an integral over what is printed below its sign; `below` is the script."""

    sign: str
    below: str
    body: Tree
    variable: Tree


@dataclass(frozen=True, slots=True)
class Evaluated(Tree):
    r"""`\left[ f \right]_{t=a}^b`: the difference of the values at both ends; without `low` the value at `high`."""

    body: Tree
    variable: Tree
    low: Tree | None
    high: Tree


@dataclass(frozen=True, slots=True)
class Norm(Tree):
    r"""`\|v\|`: the length of a vector."""

    value: Tree


@dataclass(frozen=True, slots=True)
class Mean(Tree):
    r"""`\langle f \rangle_\psi`: the average over one turn of a phase."""

    body: Tree
    phase: Tree


@dataclass(frozen=True, slots=True)
class Pair(Tree):
    """`(u, v)`: the scalar product of two vectors; behind `\\in` the open interval."""

    left: Tree
    right: Tree


@dataclass(frozen=True, slots=True)
class Interval(Tree):
    """`[a, b]`, both ends included; `[a, b)` or `(a, b]` where `ends` says so."""

    low: Tree
    high: Tree
    ends: str = "[]"


@dataclass(frozen=True, slots=True)
class Tuple(Tree):
    r"""A list in brackets of three or more items (or one, or two in `\{ \}`): `kind` is "()", "[]" or "{}"."""

    items: tuple[Tree, ...]
    kind: str


@dataclass(frozen=True, slots=True)
class Cross(Tree):
    left: Tree
    right: Tree


@dataclass(frozen=True, slots=True)
class Transpose(Tree):
    value: Tree


@dataclass(frozen=True, slots=True)
class MatrixOf(Tree):
    rows: tuple[tuple[Tree, ...], ...]


@dataclass(frozen=True, slots=True)
class Diag(Tree):
    entries: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Bars(Tree):
    """`|A|`: the determinant of a matrix, the absolute value of a scalar."""

    value: Tree


@dataclass(frozen=True, slots=True)
class ElementsOf(Tree):
    r"""`\|a_{ij}\|` or `[a_{ij}]`: the matrix of these elements; the first free index counts rows."""

    value: Tree


@dataclass(frozen=True, slots=True)
class Derivative(Tree):
    r"""`\frac{d^2 f}{dx^2}`; `partial` is how it is printed."""

    body: Tree
    variables: tuple[tuple[Tree, int], ...]
    partial: bool = False


@dataclass(frozen=True, slots=True)
class Total(Tree):
    """`dx` outside of a derivative and an integral: the differential of a quantity."""

    value: Tree


@dataclass(frozen=True, slots=True)
class Dots(Tree):
    r"""`\dots` in a list."""


@dataclass(frozen=True, slots=True)
class Blank(Tree):
    """A place of a matrix where nothing is printed."""


@dataclass(frozen=True, slots=True)
class Chain(Tree):
    r"""`a = b \le c`: members and the signs between them."""

    members: tuple[Tree, ...]
    signs: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Qualifier(Tree):
    """`i = 1, 2, 3`: the values an index takes."""

    indices: tuple[str, ...]
    values: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Values(Tree):
    r"""`m = 1, 2, \dots`: the values a letter that is no index may take."""

    name: Tree
    values: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class System(Tree):
    """Several statements, or several expressions, side by side.

    Parameters
    ----------
    parts
        The statements or expressions.
    qualifiers
        What holds for all of them.
    """

    parts: tuple[Tree, ...]
    qualifiers: tuple[Qualifier, ...] = ()


@dataclass(frozen=True, slots=True)
class CaseList(Tree):
    """A numbered list; `1). ...; 2). ...` are cases, of which one holds, `1) ...; 2) ...` are just counted."""

    cases: tuple[tuple[str, Tree], ...]


@dataclass(frozen=True, slots=True)
class Located(Tree):
    r"""`V_1 : \mathbf{H} = ...`: a statement about a named thing."""

    place: Tree
    statement: Tree


@dataclass(frozen=True, slots=True)
class And(Tree):
    parts: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Or(Tree):
    parts: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Implies(Tree):
    left: Tree
    right: Tree


@dataclass(frozen=True, slots=True)
class Iff(Tree):
    """Two statements of which each implies the other.

    Parameters
    ----------
    left, right
        The statements.
    """

    left: Tree
    right: Tree


@dataclass(frozen=True, slots=True)
class Exists(Tree):
    names: tuple[Tree, ...]
    body: Tree


STATEMENTS = (Chain, Values, System, CaseList, Located, And, Or, Implies, Iff, Exists, Forall, Words, Qualifier)
BRACKETED = frozenset({"Gamma"})  # functions whose argument always stands in brackets
LOGIC = (And, Or, Implies, Iff, Exists)

LEAVES = frozenset({Number, Name, Infinity, Dots, Blank})  # nodes with nothing below them
Path = tuple[int, ...]


def children(tree: Tree) -> tuple[Tree, ...]:
    """The nodes directly below, in printed order."""
    kind = tree.__class__
    if kind in LEAVES:
        return ()
    names = _FIELDS.get(kind) or _names(kind)
    found: list[Tree] = []
    for name in names:
        value = getattr(tree, name)
        if isinstance(value, Tree):
            found.append(value)
        elif value.__class__ is tuple and value:
            found += _trees(value)
    return tuple(found)


_FIELDS: dict[type[Tree], tuple[str, ...]] = {}


def _names(kind: type[Tree]) -> tuple[str, ...]:
    """The names of the fields of a kind of node."""
    found = _FIELDS.get(kind)
    if found is None:
        found = _FIELDS[kind] = tuple(field.name for field in fields(kind))  # type: ignore[arg-type]
    return found


def _trees(value: object) -> list[Tree]:
    if isinstance(value, Tree):
        return [value]
    if value.__class__ is not tuple:
        return []
    found: list[Tree] = []
    for item in value:
        if isinstance(item, Tree):
            found.append(item)
        elif item.__class__ is tuple:
            found += _trees(item)
    return found


def with_children(tree: T, new: tuple[Tree, ...]) -> T:
    """The same node over other children, given in the order of `children`."""
    supply = iter(new)

    def swap(value: object) -> object:
        if isinstance(value, Tree):
            return next(supply)
        return tuple(map(swap, value)) if isinstance(value, tuple) else value

    return type(tree)(*[swap(getattr(tree, name)) for name in _names(type(tree))])


def walk(tree: Tree, path: Path = ()) -> Iterator[tuple[Path, Tree]]:
    """Every node with the path that leads to it, the root first."""
    yield path, tree
    for k, child in enumerate(children(tree)):
        yield from walk(child, (*path, k))


def nodes(tree: Tree) -> Iterator[Tree]:
    """Every node, the root first, without its path."""
    waiting = [tree]
    while waiting:
        tree = waiting.pop()
        yield tree
        if tree.__class__ not in LEAVES:
            waiting += children(tree)[::-1]


def replaced(tree: Tree, path: Path, new: Tree) -> Tree:
    """The tree with another node at `path`."""
    if not path:
        return new
    below = list(children(tree))
    below[path[0]] = replaced(below[path[0]], path[1:], new)
    return with_children(tree, tuple(below))
