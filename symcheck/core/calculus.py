"""Letters of terms, substitution, derivatives, domains, and what is a polynomial in what."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Set

from symcheck.core.formulas import FALSE, conjuncts
from symcheck.core.terms import (
    Binder,
    Call,
    Connective,
    End,
    Formula,
    Malformed,
    Node,
    Quantified,
    T,
    Term,
    Value,
    mapped,
    node,
)


def nodes(*trees: Term) -> Iterable[Node]:
    """All nodes in them that stand under no binder, once: what is defined may stand in many places."""
    found = {id(tree): tree for tree in trees if isinstance(tree, Node)}
    todo = [*found.values()]
    for tree in todo:  # it grows
        for part in tree.outside:
            if isinstance(part, Node) and id(part) not in found:
                found[id(part)] = part
                todo.append(part)
    return todo


def letters(tree: Term) -> set[str]:
    """The letters that occur free. Names of unknown functions are not among them: see `functions`."""
    free = {tree} if isinstance(tree, str) else set()
    for part in nodes(tree):
        free.update(each for each in part.outside if isinstance(each, str))
        for body in part.inside:
            free |= letters(body) - {*part.bound}
    return free


def functions(tree: Term) -> set[str]:
    """The names of the unknown functions."""
    parts = nodes(tree)
    inner = (functions(body) for part in parts for body in part.inside)
    return {part.function for part in parts if isinstance(part, Call)}.union(*inner)


Lambda = tuple[tuple[str, ...], "Term"]  # letters, and a term in them


def substituted(tree: T, by: Mapping[str, Term], calls: Mapping[str, Lambda] | None = None) -> T:
    """The term or formula with letters replaced by terms, and unknown functions by terms in their arguments.

    A bound letter is renamed where a term put under it contains it. Malformed for a derivative of such a function.
    """
    return _substituted(tree, by, calls or {})  # type: ignore[return-value, arg-type]


def _substituted(tree: Term, by: Mapping[str, Term], calls: Mapping[str, Lambda]) -> Term:
    if not isinstance(tree, Node):
        return by.get(tree, tree) if isinstance(tree, str) else tree
    outside = [_substituted(each, by, calls) for each in tree.outside]
    if isinstance(tree, Call):
        if tree.function not in calls:
            return node(tree.tag, tree.function, tree.orders, *outside)
        own, body = calls[tree.function]
        if any(tree.orders) or len(own) != len(outside):
            raise Malformed(f"a derivative of {tree.function}, or other arguments")
        return _substituted(body, dict(zip(own, outside, strict=True)), {})
    if not tree.bound:
        return tuple.__new__(type(tree), (tree.tag, *outside))
    inner = {x: t for x, t in by.items() if x not in tree.bound}
    put = set().union(*map(letters, inner.values()), *(letters(body).difference(xs) for xs, body in calls.values()))
    new = dict(zip(tree.bound, tree.bound, strict=True))
    for x in put.intersection(tree.bound):
        taken = put.union(inner, new, new.values(), *map(letters, tree.inside))
        new[x] = fresh(x, taken)
    (body,) = [_substituted(each, {**inner, **new}, calls) for each in tree.inside]
    return node(
        tree.tag, *((tuple(new.values()), body) if isinstance(tree, Quantified) else (body, *new.values(), *outside))
    )


class Unknown(Exception):
    """A term about which nothing is known here; the message names it."""


def differentiated(term: Binder) -> Term:
    """What a node "diff" stands for: the derivative of its body, at its place."""
    rate, (order, place) = term.body, term.outside
    assert isinstance(order, int)
    for _ in range(order):
        rate = derivative(rate, term.letter)
    return rate if place == term.letter else substituted(rate, {term.letter: place})


RATES: dict[str, Callable[[Term], Term]] = {  # the derivative of a known function at its argument
    "sin": lambda t: node("cos", t),
    "cos": lambda t: node("-", node("sin", t)),
    "tan": lambda t: node("^", node("cos", t), -2),
    "exp": lambda t: node("exp", t),
    "log": lambda t: node("/", 1, t),
    "sqrt": lambda t: node("/", 1, node("*", 2, node("sqrt", t))),
    "arctan": lambda t: node("/", 1, node("+", 1, node("^", t, 2))),
    "arcsin": lambda t: node("/", 1, node("sqrt", node("+", 1, node("-", node("^", t, 2))))),
    "arccos": lambda t: node("/", -1, node("sqrt", node("+", 1, node("-", node("^", t, 2))))),
}
ENTIRE = ("+", "*", "-", "sin", "cos", "exp")  # these have derivatives everywhere


def is_entire(term: Term, *of: str) -> bool:
    """Whether a term is smooth for all values of letters: of sums, products, sines, exponentials, unknown functions."""
    if not isinstance(term, Node) or letters(term).isdisjoint(of):
        return True
    match term:
        case Value(tag="/", terms=(top, bottom)):
            return letters(bottom).isdisjoint(of) and is_entire(top, *of)
        case Value(tag="^", terms=(base, int(n))):
            return n >= 0 and is_entire(base, *of)
    known = isinstance(term, Call) or term.tag in ENTIRE
    return known and all(is_entire(part, *of) for part in term.outside)


def _under_integral(term: Binder, x: str) -> Term:
    """The derivative of an integral between finite ends of what is smooth everywhere, by Leibniz's rule."""
    low, high = ((substituted(term.body, {term.letter: end}), derivative(end, x)) for end in term.outside)
    inside = derivative(term.body, x) if x != term.letter else 0
    parts = [_times(*high)] * (high[1] != 0) + [node("-", _times(*low))] * (low[1] != 0)
    parts += [node("integral", inside, term.letter, *term.outside)] * (inside != 0)
    return node("+", *parts) if len(parts) > 1 else parts[0] if parts else 0


def _is_finite_sum(term: Binder, x: str) -> bool:
    """Is it a sum of what is smooth everywhere, between ends that do not depend on the letter?"""
    free = term.tag == "sum" and not any(isinstance(end, End) or x in letters(end) for end in term.outside)
    return free and x != term.letter and is_entire(term.body, x)


def derivative(term: Term, x: str) -> Term:
    """The derivative by a letter, all others constant; Unknown for integrals and functions without a rule."""
    if not isinstance(term, Node):
        return int(term == x)
    if isinstance(term, Binder):
        if (
            term.tag == "integral"
            and is_entire(term.body, term.letter, x)
            and not any(isinstance(end, End) for end in term.outside)
        ):
            return _under_integral(term, x)
        if _is_finite_sum(term, x):
            return node("sum", rate, term.letter, *term.outside) if (rate := derivative(term.body, x)) != 0 else 0
        if term.tag != "diff" and x in letters(term):
            raise Unknown(f"the derivative of {term!r}")
        return derivative(differentiated(term), x) if term.tag == "diff" else 0
    inner = [(k, rate) for k, part in enumerate(term.outside) if (rate := derivative(part, x)) != 0]
    return node("+", *(_times(_partial(term, k), rate) for k, rate in inner)) if inner else 0


def _partial(term: Node, k: int) -> Term:
    """The derivative by the k-th of the terms of which a node is made."""
    match term:
        case Value(tag="+"):
            return 1
        case Value(tag="-"):
            return -1
        case Value(tag="*", terms=factors):
            return node("*", *factors[:k], *factors[k + 1 :]) if factors[1:] else 1
        case Value(tag="/", terms=(top, bottom)):
            return node("-", node("/", top, node("^", bottom, 2))) if k else node("/", 1, bottom)
        case Value(tag="^", terms=(base, int(n))):
            return node("*", n, node("^", base, n - 1)) if n not in (0, 1) else n
        case Value(tag="pow", terms=(base, exponent)):  # exp(exponent * log(base))
            return node("*", term, node("log", base) if k else node("/", exponent, base))
        case Value(tag=function, terms=(inner,)) if function in RATES:
            return RATES[function](inner)
        case Call(function=f, orders=orders, terms=arguments):
            return node("call", f, tuple(n + (i == k) for i, n in enumerate(orders)), *arguments)
    raise Unknown(f"the derivative of {term!r}")


def _times(factor: Term, rate: Term) -> Term:
    return factor if rate == 1 else rate if factor == 1 else node("*", factor, rate)


def polynomial_in(term: Term, *atoms: Term) -> bool:
    """Whether the term is a polynomial in the atoms (x, or sin x and cos x) over what is free of their letter."""
    match term:
        case _ if term in atoms:
            return True
        case Value(tag="+" | "*" | "-", terms=parts):
            return all(polynomial_in(part, *atoms) for part in parts)
        case Value(tag="/", terms=(top, bottom)):
            return polynomial_in(top, *atoms) and not letters(bottom) & letters(atoms[0])
        case Value(tag="^", terms=(base, int(n))) if n >= 0:
            return polynomial_in(base, *atoms)
    return not letters(term) & letters(atoms[0])


DOMAINS: dict[str, Callable[[Term], Formula]] = {  # where a function of t has a real value
    "sqrt": lambda t: node(">=", t, 0),
    **dict.fromkeys(("log", "gamma", "pow"), lambda t: node(">", t, 0)),
    **dict.fromkeys(("arcsin", "arccos"), lambda t: node("<=", node("^", t, 2), 1)),
}


def divisor(term: Node) -> Term:
    """What the term divides by; of a power, the base."""
    match term:
        case Value(tag="/", terms=(_, Value(tag="^", terms=(base, int(n))))) if n > 0:
            return base
        case Value(tag="/", terms=(_, bottom)):
            return bottom
        case Value(tag="^", terms=(base, int(n))) if n < 0:
            return base
        case Value(tag="tan", terms=(angle,)):
            return node("cos", angle)
    return 1


def regular(term: Term) -> list[Formula]:
    """What must be so lest a term fail to be smooth at a place; Malformed for one with binders."""
    found = dict[Formula, None]()
    for part in nodes(term):
        if not isinstance(part, Value | Call):
            raise Malformed(f"{part!r} may not be smooth")
        if part.tag in ("sqrt", "log", "gamma", "pow"):
            found[node(">", part.outside[0], 0)] = None
        if part.tag in ("arcsin", "arccos"):
            found[node("<", node("^", part.outside[0], 2), 1)] = None
        if (below := divisor(part)) != 1:
            found[node("!=", below, 0)] = None
    return [*found]


def domain(*trees: Term, divisors: bool = False) -> list[Formula]:
    """What must be so lest a part of the terms or formulas that stands under no binder have no real value.

    Divisors are told on demand: what a proof divides by has to be shown not to vanish anyhow.
    """
    return conditions(nodes(*trees), divisors)


def conditions(parts: Iterable[Node], divisors: bool = False) -> list[Formula]:
    """The same of nodes, one by one."""
    found = dict[Formula, None]()
    for part in parts:
        if part[0] in DOMAINS:
            found[DOMAINS[part.tag](part.outside[0])] = None
        if divisors and (below := divisor(part)) != 1:
            found[node("!=", below, 0)] = None
        if isinstance(part, Binder) and part.tag == "diff":  # what is differentiated has a value at its place
            at = {part.letter: part.outside[1]}
            found |= dict.fromkeys(substituted(each, at) for each in domain(part.body, divisors=divisors))
    return [*found]


def owed(*trees: Term, under: bool = False) -> list[Formula]:
    """What must be so lest a part that stands under a binder have no real value, whatever bound letters are.

    Divisors are left to the proof, and what is said to exist to `strict`; unknown functions have the values they need.
    """
    found = dict.fromkeys(conditions(nodes(*trees))) if under else {}
    for part in nodes(*trees):
        if part.tag == "diff":
            at = {part.bound[0]: part.outside[1]}
            found |= dict.fromkeys(owed(*(substituted(body, at) for body in part.inside), under=True))
        elif part.inside and (endless(part) or partial(*part.inside)):
            found |= dict.fromkeys(_owed_under(part))
    return [*found]


def partial(*trees: Term) -> bool:
    """Whether something occurs that has no value for some numbers under it."""
    return any(part[0] in DOMAINS or endless(part) or partial(*part.inside) for part in nodes(*trees))


def endless(part: Node) -> bool:
    """Whether it is an integral without an end or an endless sum, which may have no value."""
    return part.tag in ("integral", "sum") and any(isinstance(end, End) for end in part.outside)


def _owed_under(binder: Node) -> Iterable[Formula]:
    """The same of what stands under one binder: for all letters that are bound, with what is so of them.

    There is something between the ends. Zero, a single point, does not count in an integral; but where a power or a
    logarithm has no value there, or at an end, the integral converges. The names of bound letters make no difference.
    """
    new = list[str]()
    for _ in binder.bound:
        new.append(fresh("x", letters(binder).union(new)))
    (body,) = (substituted(each, dict(zip(binder.bound, new, strict=True))) for each in binder.inside)
    fields = ((*new,), body) if isinstance(binder, Quantified) else (body, *new, *binder.outside)
    binder = node(binder.tag, *fields)
    inner, way = owed(*binder.inside, under=True), list[Formula]()
    match binder:
        case Quantified(body=Connective(tag="=>", formulas=(premise, _))):
            way = conjuncts(premise)
        case Binder(letter=x, outside=(low, high)):
            less = "<=" if binder.tag in ("sum", "product") else "<"
            way = [node(less, *pair) for pair in ((low, x), (x, high)) if not any(isinstance(t, End) for t in pair)]
            if less == "<":
                way.append(node("!=", x, 0))
            if inner and not any(isinstance(end, End) for end in binder.outside):
                yield node(less, low, high)
                everywhere = node("and", node("<=", low, x), node("<=", x, high))
                open_ = [each for each in inner if each.tag == ">" and x in letters(each) and not functions(each)]
                if open_ and binder.tag == "integral":
                    closed = node("forall", binder.bound, node("=>", everywhere, node("and", *open_)))
                    yield node("or", closed, node("=", node("diverges", *binder[1:]), 0))
    if endless(binder) and not functions(binder):  # no theorem tells that an endless sum has a value
        yield node("=", node("diverges", *binder[1:]), 0) if binder.tag == "integral" else FALSE
    for each in inner:
        if letters(each).isdisjoint(binder.bound):
            yield each
        elif functions(each):
            continue
        elif each not in way and binder.tag != "exists":
            yield node("forall", binder.bound, node("=>", node("and", *way), each))


def strict(formula: Formula) -> Formula:
    """The formula, where what is said to exist has to be where all terms have values."""
    if not isinstance(formula, Connective | Quantified):
        return formula
    new, bound = mapped(formula, strict), {*formula.bound}  # type: ignore[arg-type]
    more = [each for each in owed(*new.inside, under=True) if formula.tag == "exists" and letters(each) & bound]
    return node("exists", formula.bound, node("and", *new.inside, *more)) if more else new


def fresh(x: str, taken: Set[str]) -> str:
    """A letter like x that is not taken."""
    return next(name for n in range(len(taken) + 1) if (name := f"{x}_{n}") not in taken)
