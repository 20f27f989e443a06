"""Terms and formulas: immutable trees with one strict JSON form. The standard library alone.

A term is a whole number (`int`), a letter (`str`, such as "a_12": never a value), or a node; a formula is a node. A
node is a tuple of its tag and its fields, of a class of its own, so that equality is equality of structure and
`json.dumps` writes the very form that `Reader` reads:

    ["+", t, ...]  ["*", t, ...]  ["-", t]  ["/", t, u]  ["^", t, n]      n a whole number
    ["pi"]  ["sin", t]  ... every name in FUNCTIONS, ["pow", t, u] is t to the power u for positive t
    ["call", "f", [n, ...], t, ...]         an unknown smooth function f, or its derivative of these orders, at t, ...
    ["mean", t, "x"]                        over one turn of the angle x
    ["integral", t, "x", u, v]              from u to v, also ["infinity"], ["-infinity"]; 0 if it has no finite value
    ["diverges", t, "x", u, v]              0 if that integral has a finite value, else 1
    ["sum", t, "k", u, v]  ["product", t, "k", u, v]        of whole numbers k; 0 if an endless sum has no value
    ["diff", t, "x", n, u]                  the n-th derivative of t by x, at x = u

    ["=", t, u] and "!=", "<", "<=", ">", ">="
    ["and", f, ...]  ["or", f, ...]  ["=>", f, g]  ["<=>", f, g]  ["exists", ["x", ...], f]  ["forall", ["x", ...], f]

Binders bind: their letter means nothing outside of their body, and substitution renames it where it would be confused.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence, Set
from operator import itemgetter

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias, TypeVar

    T = TypeVar("T")
    Term: TypeAlias = "int | str | Node"
    Formula: TypeAlias = "Node"
    Field: TypeAlias = "int | str | Node | tuple[int, ...] | tuple[str, ...]"
    JSON: TypeAlias = "bool | int | float | str | list[JSON] | dict[str, JSON] | None"
else:
    Term = Formula = JSON = Field = T = object  # the module `typing` takes longer to import than the checker

FUNCTIONS = ("sqrt", "exp", "log", "gamma", "sin", "cos", "tan", "arctan", "arcsin", "arccos")
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
LARGEST = 1 << 20  # nodes of a term after its definitions are unfolded: it bounds the degree of what is computed


class Malformed(ValueError):
    """Data that is no term or formula; the message names the part."""


def field(place: int | slice) -> T:  # type: ignore[type-var]
    """A field of a node, or several, of the type that is declared for it."""
    return property(itemgetter(place))  # type: ignore[return-value]


class Node(tuple["Term", ...]):
    """A tag and fields; made by `node` or by a `Reader`, so that every node is well-formed."""

    __slots__ = ()
    tag: str = field(0)
    bound: tuple[str, ...] = ()  # the letters that a binder binds,
    inside: tuple[Term, ...] = ()  # what stands under it, and
    outside: tuple[Term, ...] = field(slice(1, None))  # all other terms and formulas among the fields
    terms: tuple[Term, ...] = ()  # of a value, an unknown function or a relation
    formulas: tuple[Formula, ...] = ()  # of a connective


class Value(Node):
    """Whatever is made of terms alone: a sum, product, ... or a known function at its arguments."""

    terms: tuple[Term, ...] = field(slice(1, None))


class Call(Node):
    """An unknown function, or a partial derivative of it, at its arguments."""

    function: str = field(1)
    orders: tuple[int, ...] = field(2)
    terms: tuple[Term, ...] = field(slice(3, None))
    outside = terms


class End(Node):
    """Infinity or minus infinity: an end of an integral, and nothing else."""


class Binder(Node):
    """A mean, integral, sum or product over a letter, or a derivative by it: (tag, body, letter, ...)."""

    body: Term = field(1)
    letter: str = field(2)
    inside: tuple[Term, ...] = field(slice(1, 2))
    bound: tuple[str, ...] = field(slice(2, 3))
    outside: tuple[Term, ...] = field(slice(3, None))


class Form(Node):
    """A printed form without an algebraic meaning, by a word and its parts: a claim that no certificate can hold."""

    outside: tuple[Term, ...] = field(slice(2, None))


class Relation(Node):
    terms: tuple[Term, ...] = field(slice(1, None))


class Connective(Node):
    formulas: tuple[Formula, ...] = field(slice(1, None))


class Quantified(Node):
    bound: tuple[str, ...] = field(1)
    body: Formula = field(2)
    inside: tuple[Term, ...] = field(slice(2, None))
    outside = ()


SHAPES: dict[str, tuple[type[Node], int | None]] = {  # the class of a tag, and how many fields it has if not any number
    "+": (Value, None), "*": (Value, None), "-": (Value, 1), "/": (Value, 2), "^": (Value, 2), "pi": (Value, 0),
    **dict.fromkeys(FUNCTIONS, (Value, 1)), "pow": (Value, 2), "call": (Call, None), "mean": (Binder, 2),
    **dict.fromkeys(("integral", "diverges", "sum", "product", "diff"), (Binder, 4)),
    **dict.fromkeys(("infinity", "-infinity"), (End, 0)), **dict.fromkeys(RELATIONS, (Relation, 2)),
    **dict.fromkeys(("and", "or"), (Connective, None)), **dict.fromkeys(("=>", "<=>"), (Connective, 2)),
    **dict.fromkeys(("exists", "forall"), (Quantified, 2)), "form": (Form, None),
}  # fmt: skip
TERMS = {tag for tag, (kind, _) in SHAPES.items() if kind in (Value, Call, Binder)}
ENDS = TERMS | {"infinity", "-infinity"}
FORMULAS = SHAPES.keys() - ENDS - {"form"}


def node(tag: str, *fields: Field) -> Node:
    """A node of the class of its tag; for fields that are right already."""
    return tuple.__new__(SHAPES[tag][0], (tag, *fields))


PI, INFINITY, MINUS_INFINITY = map(node, ("pi", "infinity", "-infinity"))


def mapped(tree: Node, change: Callable[[Term], Term], inside: Callable[[Term], Term] | None = None) -> Node:
    """The node with all terms or formulas in it changed, those under its bound letters by `inside` if given."""
    new = *map(inside or change, tree.inside), *map(change, tree.outside)
    if isinstance(tree, Call):
        return node(tree.tag, tree.function, tree.orders, *new)
    if isinstance(tree, Quantified):
        return node(tree.tag, tree.bound, *new)
    return node(tree.tag, *new[: len(tree.inside)], *tree.bound, *new[len(tree.inside) :])


class Reader:
    """Reads JSON into nodes; names that are defined are replaced by what they stand for, wherever they are written."""

    def __init__(self) -> None:
        self.names: dict[str, Term] = {}
        self.sizes: dict[str, int] = {}
        self.size = 0  # of what is being read, definitions unfolded

    def define(self, name: str, data: JSON) -> None:
        """One more definition; it may use those before it."""
        if self.letter(name) in self.names:
            raise Malformed(f"{name} is defined twice")
        self.names[name], self.sizes[name] = self.term(data), self.size

    def term(self, data: JSON) -> Term:
        """A term; Malformed if it is none."""
        self.size = 0
        return self._term(data)

    def formula(self, data: JSON) -> Formula:
        """A formula; Malformed if it is none."""
        self.size = 0
        return self._node(data, FORMULAS)

    def without(self, bound: JSON) -> tuple[tuple[str, ...], Reader]:
        """Letters, which a binder binds, and a reader of what stands under it."""
        if not isinstance(bound, list) or not bound or len({*map(str, bound)}) < len(bound):
            raise Malformed(f"{bound!r} are no letters")
        own, inner = tuple(map(self.letter, bound)), Reader()
        inner.names = {name: term for name, term in self.names.items() if name not in own}
        inner.sizes = self.sizes
        return own, inner

    @staticmethod
    def letter(data: JSON) -> str:
        """The name of a letter or of a function."""
        if type(data) is not str or not (data.isascii() and data.isidentifier() and data[0] != "_"):
            raise Malformed(f"{data!r} is no letter")
        return data

    def _term(self, data: JSON, allowed: Set[str] = TERMS) -> Term:
        """A node, a number, a letter, or what is defined."""
        if type(data) is list:
            return self._node(data, allowed)
        if type(data) is int:
            return data
        if type(data) is str and data in self.names:
            self.size += self.sizes[data]
            return self.names[data]
        return self.letter(data)

    def _node(self, data: JSON, allowed: Set[str]) -> Node:
        if type(data) is not list or not data or type(tag := data[0]) is not str or tag not in allowed:
            raise Malformed(f"{str(data)[:80]} is no {'formula' if allowed is FORMULAS else 'term'}")
        kind, count = SHAPES[tag]
        if count is not None and len(data) != 1 + count:
            raise Malformed(f"{tag} with {len(data) - 1} fields")
        fields: Sequence[Field] = ()
        if tag == "^" or tag == "diff":
            whole = data[-1] if tag == "^" else data[3]
            if type(whole) is not int or (tag == "diff" and not 0 < whole < 9):
                raise Malformed(f"{whole!r} is no whole number that fits")
        if kind is Value or kind is Relation:
            fields = [self._node(each, TERMS) if type(each) is list else self._term(each) for each in data[1:]]
        elif kind is Connective:
            fields = [self._node(each, FORMULAS) for each in data[1:]]
        elif kind is Call:
            name, orders, *arguments = data[1:] if len(data) > 3 else (None, None)
            listed = [n for n in orders if type(n) is int and 0 <= n < 9] if isinstance(orders, list) else []
            if not isinstance(orders, list) or not len(listed) == len(orders) == len(arguments):
                raise Malformed(f"the orders {orders} of the function {name}")
            fields = [self.letter(name), tuple(listed), *map(self._term, arguments)]
        elif kind is Quantified or kind is Binder:
            own, inner = self.without(data[1] if kind is Quantified else data[2:3])
            body = inner._node(data[2], FORMULAS) if kind is Quantified else inner._term(data[1])
            self.size += inner.size
            ends = ENDS if tag in ("integral", "diverges", "sum") else TERMS
            fields = (own, body) if kind is Quantified else (body, *own, *(self._term(each, ends) for each in data[3:]))
        self.size += len(data)
        if self.size > LARGEST:
            raise Malformed("a term that is too large")
        return tuple.__new__(kind, (tag, *fields))
