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
    Field: TypeAlias = "int | str | Node | tuple[int, ...] | tuple[str, ...]"
    JSON: TypeAlias = "bool | int | float | str | list[JSON] | dict[str, JSON] | None"
else:
    Term = Formula = JSON = Field = T = object  # the module `typing` takes longer to import than the checker

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


class Node(tuple["Field", ...]):
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


def node(tag: str, *fields: Field) -> Node:
    """A node of the class of its tag; for fields that are right already."""
    return tuple.__new__(SHAPES[tag][0], (tag, *fields))


class Reader:
    """Reads JSON into nodes; names that are defined are replaced by what they stand for, wherever they are written."""

    good: set[str] = set()  # noqa: RUF012  names that are letters, as was found out

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
        return self._sized(self._fields([None, data])[1])  # type: ignore[arg-type]

    def formula(self, data: JSON) -> Formula:
        """A formula; Malformed if it is none."""
        self.size = 0
        return self._sized(self._node(data, FORMULAS))  # type: ignore[return-value]

    def without(self, *bound: JSON) -> Reader:
        """A reader of what stands under a binder of these letters."""
        inner, own = Reader(), {*map(self.letter, bound)}
        inner.names, inner.sizes = {name: term for name, term in self.names.items() if name not in own}, self.sizes
        return inner

    @staticmethod
    def letter(data: JSON) -> str:
        """The name of a letter or of a function."""
        if type(data) is not str or not (data.isascii() and data.isidentifier() and data[0] != "_"):
            raise Malformed(f"{data!r} is no letter")
        Reader.good.add(data)
        return data

    def _sized(self, found: Term) -> Term:
        if self.size > LARGEST:
            raise Malformed("a term that is too large")
        return found

    def _fields(self, data: list[JSON]) -> list[Field]:
        """The tag, and terms after it."""
        fields: list[Field] = [data[0]]  # type: ignore[list-item]
        for each in data[1:]:
            kind = type(each)
            if kind is list:
                fields.append(self._node(each, TERMS))
            elif kind is int:
                fields.append(each)  # type: ignore[arg-type]
            elif each in self.names:
                self.size += self.sizes[each]
                fields.append(self._sized(self.names[each]))
            else:
                fields.append(each if each in self.good else self.letter(each))
        return fields

    def _node(self, data: JSON, allowed: set[str]) -> Node:
        if type(data) is not list or not data or type(tag := data[0]) is not str or tag not in allowed:
            raise Malformed(f"{str(data)[:80]} is no {'term' if allowed is TERMS else 'formula'}")
        kind, sorts = SHAPES[tag]
        self.size += len(data)
        if sorts[-1:] != "*" and len(data) != 1 + len(sorts):
            raise Malformed(f"{tag} with {len(data) - 1} fields")
        if sorts in ("t*", "tt", "t"):  # most nodes are so
            return tuple.__new__(kind, self._fields(data))
        if sorts == "Ft*":
            return tuple.__new__(kind, (tag, *self._function(data), *self._fields(data[2:])[1:]))
        if sorts == "f*":
            return tuple.__new__(kind, (tag, *(self._node(each, FORMULAS) for each in data[1:])))
        bound = self.without(data[2]) if "x" in sorts else self.without(*letters_of(data[1])) if "X" in sorts else self
        found = tuple.__new__(kind, (tag, *map(bound._field, sorts, data[1:], [self] * len(data))))
        self.size += bound.size if bound is not self else 0
        return found

    def _field(self, sort: str, data: JSON, outside: Reader) -> Field:
        """A field by its sort, read by what is in force under the binder."""
        match sort:
            case "b":
                return self._fields([None, data])[1]
            case "g":
                return self._node(data, FORMULAS)
            case "x":
                return self.letter(data)
            case "X":
                return tuple(map(self.letter, letters_of(data)))
            case "f":
                return outside._node(data, FORMULAS)
            case "e" if data in (["infinity"], ["-infinity"]):
                return node(str(data[0]))
            case "n" | "k" if type(data) is int and (sort == "n" or 0 < data < 9):
                return data
            case "t" | "e":
                return outside._fields([None, data])[1]
        raise Malformed(f"{data!r} is no whole number that fits")

    def _function(self, data: list[JSON]) -> tuple[str, tuple[int, ...]]:
        """The name of an unknown function, and how often it is differentiated by each of its arguments."""
        name, listed = data[1:3] if len(data) > 3 else (None, None)
        orders = tuple(n for n in listed if type(n) is int and 0 <= n < 9) if type(listed) is list else ()
        if type(listed) is not list or not len(orders) == len(listed) == len(data) - 3:
            raise Malformed(f"the orders {listed} of the function {name}")
        return self.letter(name), orders


def letters_of(data: JSON) -> list[JSON]:
    """The letters that a quantifier binds."""
    if type(data) is not list or not data or len({*map(str, data)}) < len(data):
        raise Malformed(f"{data!r} are no letters")
    return data


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
    found: set[str] = set()
    _letters(tree, found)
    return found


def _letters(tree: Term | Formula, found: set[str]) -> None:
    if isinstance(tree, str):
        found.add(tree)
    elif isinstance(tree, (Binder, Quantified, Call)):
        for child, inside in children(tree):
            found |= letters(child).difference(bound(tree)) if inside else letters(child)
    elif isinstance(tree, tuple):
        for part in tree[1:]:
            _letters(part, found)  # type: ignore[arg-type]


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
    if not isinstance(tree, (Binder, Quantified, Call)):
        return tuple.__new__(type(tree), [tree[0], *[_substituted(t, by, calls) for t in tree[1:]]])  # type: ignore[arg-type]
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
