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
    ["sum", t, "k", u, v]  ["product", t, "k", u, v]
    ["diff", t, "x", n, u]                  the n-th derivative of t by x, at x = u

    ["=", t, u] and "!=", "<", "<=", ">", ">="
    ["and", f, ...]  ["or", f, ...]  ["=>", f, g]  ["<=>", f, g]  ["exists", ["x", ...], f]  ["forall", ["x", ...], f]

Binders bind: their letter means nothing outside of their body, and substitution renames it where it would be confused.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from operator import itemgetter

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias, TypeVar

    T = TypeVar("T")
    Term: TypeAlias = "int | str | Node"
    Formula: TypeAlias = "Node"
    JSON: TypeAlias = "bool | int | float | str | list[JSON] | dict[str, JSON] | None"
else:
    Term = Formula = JSON = T = object  # the module `typing` takes longer to import than the checker

FUNCTIONS = ("sqrt", "exp", "log", "gamma", "sin", "cos", "tan", "arctan", "arcsin", "arccos")
INTEGRALS = ("integral", "diverges")
RELATIONS = ("=", "!=", "<", "<=", ">", ">=")
LARGEST = 1 << 20  # nodes of a term after its definitions are unfolded: it bounds the degree of what is computed


class Malformed(ValueError):
    """Data that is no term or formula; the message names the part."""


def part(place: int) -> Term:
    """A field of a node that is a term."""
    return property(itemgetter(place))  # type: ignore[return-value]


def parts(start: int) -> tuple[Term, ...]:
    """The fields of a node from one on, all of them terms."""
    return property(itemgetter(slice(start, None)))  # type: ignore[return-value]


class Node(tuple["int | str | Node | tuple[int, ...] | tuple[str, ...]", ...]):
    """A tag and fields; made by the constructors below or by a `Reader`, so that every node is well-formed."""

    __slots__ = ()
    tag: str = property(itemgetter(0))  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"({', '.join(map(repr, self))})"


class Sum(Node):
    terms = parts(1)


class Product(Node):
    terms = parts(1)


class Minus(Node):
    inner = part(1)


class Quotient(Node):
    top, bottom = part(1), part(2)


class Power(Node):
    base = part(1)
    exponent: int = property(itemgetter(2))  # type: ignore[assignment]


class Value(Node):
    """A known function at its arguments, or pi."""

    arguments = parts(1)


class Call(Node):
    """An unknown function, or a partial derivative of it, at its arguments."""

    function: str = property(itemgetter(1))  # type: ignore[assignment]
    orders: tuple[int, ...] = property(itemgetter(2))  # type: ignore[assignment]
    arguments = parts(3)


class End(Node):
    """Infinity or minus infinity: an end of an integral, and nothing else."""


class Binder(Node):
    """A mean, integral, sum or product over a letter, or a derivative by it: (tag, body, letter, ...)."""

    body = part(1)
    letter: str = property(itemgetter(2))  # type: ignore[assignment]
    ends = parts(3)  # not bound


class Relation(Node):
    left, right = part(1), part(2)


class Connective(Node):
    formulas: tuple[Formula, ...] = property(itemgetter(slice(1, None)))  # type: ignore[assignment]


class Quantified(Node):
    letters: tuple[str, ...] = property(itemgetter(1))  # type: ignore[assignment]
    body: Formula = property(itemgetter(2))  # type: ignore[assignment]


# Sorts of fields: t term, n whole number, k positive whole number, x bound letter, b term under the binder, e end, f
# formula, X bound letters, g formula under them, F name of a function with its orders; "*" repeats the last one.
SHAPES: dict[str, tuple[type[Node], str]] = {
    "+": (Sum, "t*"), "*": (Product, "t*"), "-": (Minus, "t"), "/": (Quotient, "tt"), "^": (Power, "tn"),
    "pi": (Value, ""), **dict.fromkeys(FUNCTIONS, (Value, "t")), "pow": (Value, "tt"), "call": (Call, "Ft*"),
    "mean": (Binder, "bx"), **dict.fromkeys(INTEGRALS, (Binder, "bxee")), "diff": (Binder, "bxkt"),
    **dict.fromkeys(("sum", "product"), (Binder, "bxtt")), **dict.fromkeys(("infinity", "-infinity"), (End, "")),
    **dict.fromkeys(RELATIONS, (Relation, "tt")), **dict.fromkeys(("and", "or"), (Connective, "f*")),
    **dict.fromkeys(("=>", "<=>"), (Connective, "ff")), **dict.fromkeys(("exists", "forall"), (Quantified, "Xg")),
}  # fmt: skip
TERMS = {tag for tag, (kind, _) in SHAPES.items() if not issubclass(kind, (Relation, Connective, Quantified, End))}
FORMULAS = SHAPES.keys() - TERMS - {"infinity", "-infinity"}


def node(tag: str, *fields: int | str | Node | tuple[int, ...] | tuple[str, ...]) -> Node:
    """A node of the class of its tag; for fields that are right already."""
    return tuple.__new__(SHAPES[tag][0], (tag, *fields))


class Reader:
    """Reads JSON into nodes; names that are defined are replaced by what they stand for, wherever they are written."""

    def __init__(self) -> None:
        self.names: dict[str, Term] = {}
        self.sizes: dict[str, int] = {}
        self.size = 0  # of the term being read, definitions unfolded

    def define(self, name: str, data: JSON) -> None:
        """One more definition; it may use those before it."""
        if self.letter(name) in self.names:
            raise Malformed(f"{name} is defined twice")
        term = self.term(data)
        self.names[name], self.sizes[name] = term, self.size

    def term(self, data: JSON) -> Term:
        """A term; Malformed if it is none."""
        self.size = 0
        return self._term(data)

    def formula(self, data: JSON) -> Formula:
        """A formula; Malformed if it is none."""
        self.size = 0
        return self._node(data, FORMULAS)

    def under(self, x: str) -> Reader:
        """A reader of what stands under a binder of this letter."""
        inner = Reader()
        inner.names, inner.sizes = {name: term for name, term in self.names.items() if name != x}, self.sizes
        return inner

    @staticmethod
    def letter(data: JSON) -> str:
        """The name of a letter or of a function."""
        if type(data) is not str or not (data.isascii() and data.isidentifier() and data[0] != "_"):
            raise Malformed(f"{data!r} is no letter")
        return data

    def _term(self, data: JSON) -> Term:
        if type(data) is str:
            if data in self.names:
                self._count(self.sizes[data])
                return self.names[data]
            return self.letter(data)
        return data if type(data) is int else self._node(data, TERMS)

    def _count(self, nodes: int) -> None:
        self.size += nodes
        if self.size > LARGEST:
            raise Malformed("a term that is too large")

    def _node(self, data: JSON, allowed: set[str]) -> Node:
        if type(data) is not list or not data or type(tag := data[0]) is not str or tag not in allowed:
            raise Malformed(f"{str(data)[:80]} is no {'term' if allowed is TERMS else 'formula'}")
        kind, sorts = SHAPES[tag]
        self._count(1)
        if sorts == "t*":  # sums and products are most of all nodes
            return tuple.__new__(kind, (tag, *map(self._term, data[1:])))
        if sorts in ("t", "tt") and len(data) == 1 + len(sorts):
            return tuple.__new__(kind, (tag, *map(self._term, data[1:])))
        return tuple.__new__(kind, (tag, *self._fields(tag, sorts, data[1:])))

    def _fields(
        self, tag: str, sorts: str, data: list[JSON]
    ) -> Iterator[int | str | Node | tuple[int, ...] | tuple[str, ...]]:
        if sorts[-1:] == "*":
            sorts = sorts[:-1] + sorts[-2] * (1 + len(data) - len(sorts) + (sorts[0] == "F"))
        if tag == "call":
            function, orders = (*data[:2], None, None)[:2]
            yield self.letter(function)
            listed = orders if type(orders) is list else []
            counts = tuple(n for n in listed if type(n) is int and 0 <= n < 9)
            if not counts or len(counts) != len(listed) or len(counts) != len(data) - 2:
                raise Malformed(f"the orders {orders} of the function {function}")
            yield counts
            yield from map(self._term, data[2:])
            return
        if len(sorts) != len(data):
            raise Malformed(f"{tag} with {len(data)} fields")
        kept = self.names
        for sort, value in zip(sorts, data, strict=True):
            if sort in "bg":
                bound = data[1] if sort == "b" else data[0]
                inner = {self.letter(x) for x in (bound if type(bound) is list else [bound])}
                self.names = {x: t for x, t in kept.items() if x not in inner}
                yield self._term(value) if sort == "b" else self._node(value, FORMULAS)
                self.names = kept
            elif sort == "x":
                yield self.letter(value)
            elif sort == "X":
                if type(value) is not list or not value or len({str(x) for x in value}) < len(value):
                    raise Malformed(f"{value!r} are no letters")
                yield tuple(map(self.letter, value))
            elif sort in "nk":
                if type(value) is not int or (sort == "k" and value not in range(1, 9)):
                    raise Malformed(f"{value!r} is no whole number that fits {tag}")
                yield value
            elif sort == "e" and type(value) is list and value in (["infinity"], ["-infinity"]):
                yield node(str(value[0]))
            else:
                yield self._node(value, FORMULAS) if sort == "f" else self._term(value)


def bound(tree: Node) -> tuple[str, ...]:
    """The letters that a node binds."""
    return tree.letters if isinstance(tree, Quantified) else (tree.letter,) if isinstance(tree, Binder) else ()


def children(tree: Node) -> Iterator[tuple[Term | Formula, bool]]:
    """Every term and formula among the fields, and whether it stands under the binder."""
    if isinstance(tree, Quantified):
        yield tree.body, True
    elif isinstance(tree, Binder):
        yield tree.body, True
        yield from ((end, False) for end in tree.ends)
    else:
        yield from ((each, False) for each in (tree[3:] if isinstance(tree, Call) else tree[1:]))  # type: ignore[misc]


def letters(tree: Term | Formula) -> set[str]:
    """The letters that occur free. Names of unknown functions are not among them: see `functions`."""
    if not isinstance(tree, tuple):
        return {tree} if isinstance(tree, str) else set()
    found: set[str] = set()
    for child, inside in children(tree):
        found |= letters(child).difference(bound(tree)) if inside else letters(child)
    return found


def functions(tree: Term | Formula) -> set[str]:
    """The names of the unknown functions."""
    if not isinstance(tree, tuple):
        return set()
    own = {tree.function} if isinstance(tree, Call) else set()
    return own.union(*(functions(child) for child, _ in children(tree)))


Lambda = tuple[tuple[str, ...], "Term"]  # letters, and a term in them


def substituted(tree: T, by: Mapping[str, Term], calls: Mapping[str, Lambda] | None = None) -> T:
    """The term or formula with letters replaced by terms, and unknown functions by terms in their arguments.

    A bound letter is renamed where a term put under it contains it. Malformed for a derivative of such a function.
    """
    return _substituted(tree, by, calls or {})  # type: ignore[return-value, arg-type]


def _substituted(tree: Term | Formula, by: Mapping[str, Term], calls: Mapping[str, Lambda]) -> Term | Formula:
    if not isinstance(tree, tuple):
        return by.get(tree, tree) if isinstance(tree, str) else tree
    if isinstance(tree, Call) and tree.function in calls:
        own, body = calls[tree.function]
        if any(tree.orders) or len(own) != len(tree.arguments):
            raise Malformed(f"a derivative of {tree.function}, or other arguments")
        arguments = [_substituted(t, by, calls) for t in tree.arguments]
        return _substituted(body, dict(zip(own, arguments, strict=True)), {})
    own = bound(tree)
    inner = {x: t for x, t in by.items() if x not in own} if own else by
    if own:
        put = set().union(*map(letters, inner.values()), *(letters(body) - {*xs} for xs, body in calls.values()))
        if put & {*own}:
            taken = put.union(inner, own, *(letters(child) for child, _ in children(tree)))
            new = {
                x: next(f"{x}_{n}" for n in range(len(taken) + 1) if f"{x}_{n}" not in taken) for x in own if x in put
            }
            return _substituted(_renamed(tree, new), by, calls)
    return _map(tree, lambda child, inside: _substituted(child, inner if inside else by, calls))


def _renamed(tree: Node, new: dict[str, str]) -> Node:
    """Other names for the letters that the node binds."""
    changed = _map(tree, lambda child, inside: _substituted(child, new, {}) if inside else child)
    if isinstance(changed, Quantified):
        return node(tree.tag, tuple(new.get(x, x) for x in changed.letters), changed.body)
    assert isinstance(changed, Binder)
    return node(tree.tag, changed.body, new.get(changed.letter, changed.letter), *changed[3:])


def _map(tree: Node, change: Callable[[Term | Formula, bool], Term | Formula]) -> Node:
    """The node with every term and formula among its fields changed."""
    new = iter([change(child, inside) for child, inside in children(tree)])
    kept = {Quantified: (1,), Binder: (2,), Call: (1, 2)}.get(type(tree), ())
    return tuple.__new__(type(tree), (tree[0], *(tree[k] if k in kept else next(new) for k in range(1, len(tree)))))
