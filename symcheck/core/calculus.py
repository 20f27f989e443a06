"""Letters of terms, substitution, derivatives, domains, and what is a polynomial in what."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from symcheck.core.terms import Binder, Call, Formula, Malformed, Node, Quantified, T, Term, Value, node


def letters(tree: Term) -> set[str]:
    """The letters that occur free. Names of unknown functions are not among them: see `functions`."""
    if not isinstance(tree, Node):
        return {tree} if isinstance(tree, str) else set()
    found = set[str]().union(*map(letters, tree.outside))
    return found.union(*map(letters, tree.inside)) - {*tree.bound} | found if tree.bound else found


def functions(tree: Term) -> set[str]:
    """The names of the unknown functions."""
    if not isinstance(tree, Node):
        return set()
    return set().union({tree.function} if isinstance(tree, Call) else (), *map(functions, tree.inside + tree.outside))


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
        new[x] = next(name for n in range(len(taken) + 1) if (name := f"{x}_{n}") not in taken)
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


def derivative(term: Term, x: str) -> Term:
    """The derivative by a letter, all others constant; Unknown for integrals and functions without a rule."""
    if x not in letters(term):
        return 0
    match term:
        case str():
            return 1
        case Value(tag="+" | "-" as sign, terms=parts):
            return node(sign, *(derivative(part, x) for part in parts))
        case Value(tag="*", terms=factors):
            rates = [(k, derivative(part, x)) for k, part in enumerate(factors) if x in letters(part)]
            return node("+", *(node("*", *factors[:k], rate, *factors[k + 1 :]) for k, rate in rates))
        case Value(tag="/", terms=(top, bottom)):
            return derivative(node("*", top, node("^", bottom, -1)), x)
        case Value(tag="^", terms=(base, int(n))):
            return node("*", n, node("^", base, n - 1), derivative(base, x))
        case Value(tag="pow", terms=(base, exponent)):  # exp(exponent * log(base))
            return node("*", term, derivative(node("*", exponent, node("log", base)), x))
        case Value(terms=(inner,)):
            return node("*", _outer(term.tag, inner), derivative(inner, x))
        case Call(function=f, orders=orders, terms=arguments):
            steps = [tuple(n + (i == k) for i, n in enumerate(orders)) for k in range(len(orders))]
            chain = zip(steps, [derivative(t, x) for t in arguments], strict=True)
            return node("+", *(node("*", node("call", f, step, *arguments), rate) for step, rate in chain if rate != 0))
        case Binder(tag="diff"):
            return derivative(differentiated(term), x)
    raise Unknown(f"the derivative of {term!r}")


def _outer(function: str, t: Term) -> Term:
    """The derivative of a known function at its argument."""
    known = {
        "sin": node("cos", t),
        "cos": node("-", node("sin", t)),
        "tan": node("^", node("cos", t), -2),
        "exp": node("exp", t),
        "log": node("/", 1, t),
        "sqrt": node("/", 1, node("*", 2, node("sqrt", t))),
        "arctan": node("/", 1, node("+", 1, node("^", t, 2))),
    }
    if function not in known:
        raise Unknown(f"the derivative of {node(function, t)}")
    return known[function]


def polynomial_in(term: Term, *atoms: Term) -> bool:
    """Whether the term is a polynomial in the atoms (x, or sin x and cos x) over what is free of their letters."""
    taken = set().union(*map(letters, atoms))
    if term in atoms or not letters(term) & taken:
        return True
    match term:
        case Value(tag="+" | "*" | "-", terms=parts):
            return all(polynomial_in(part, *atoms) for part in parts)
        case Value(tag="/", terms=(top, bottom)):
            return polynomial_in(top, *atoms) and not letters(bottom) & taken
        case Value(tag="^", terms=(base, int(n))):
            return n >= 0 and polynomial_in(base, *atoms)
    return False


DOMAINS: dict[str, Callable[[Term], Formula]] = {  # where a function of t has a real value
    "sqrt": lambda t: node(">=", t, 0),
    **dict.fromkeys(("log", "gamma", "pow"), lambda t: node(">", t, 0)),
    **dict.fromkeys(("arcsin", "arccos"), lambda t: node("<=", node("^", t, 2), 1)),
}


def divisor(term: Node) -> Term:
    """What the term divides by."""
    match term:
        case Value(tag="/", terms=(_, bottom)):
            return bottom
        case Value(tag="^", terms=(base, int(n))) if n < 0:
            return base
        case Value(tag="tan", terms=(angle,)):
            return node("cos", angle)
    return 1


def domain(*trees: Term, divisors: bool = False) -> list[Formula]:
    """What must be so lest a part of the terms or formulas that stands under no binder have no real value.

    Divisors are told on demand: what a proof divides by has to be shown not to vanish anyhow.
    """
    todo, seen, found = [*trees], set[int](), dict[Formula, None]()
    while todo:
        tree = todo.pop()
        if isinstance(tree, Node) and id(tree) not in seen:  # what is defined may stand in many places
            seen.add(id(tree))
            todo += tree.outside
            if tree.tag in DOMAINS:
                found[DOMAINS[tree.tag](tree.outside[0])] = None
            if divisors and (below := divisor(tree)) != 1:
                found[node("!=", below, 0)] = None
    return [*found]
