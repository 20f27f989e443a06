"""Unknown functions of one letter at one place: there, their values and derivatives are numbers like others.

What is proved of all numbers holds of these. What fails for some numbers fails for functions too, if functions with
these values exist for which all conditions hold along the whole way: a condition is then an equation that gives the
highest derivative of a function, which by the theorem of Picard and Lindeloef has a solution; or a strict inequality,
which holds nearby if it holds at the place, as a weak one is made; or it has no function in it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from math import factorial

from symcheck.core.calculus import Unknown, derivative, differentiated, is_entire, letters, nodes, regular, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, Call, End, Formula, Malformed, Node, Relation, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.proof import identity
from symcheck.proof.algebra.polynomial import Unsupported, unfold
from symcheck.reading import from_sympy, to_sympy

_AT_ZERO = {"sin": 0, "tan": 0, "cos": 1, "exp": 1}  # where series are developed
STRICT = {
    "!=": "!=",
    "<": "<",
    ">": ">",
    "<=": "<",
    ">=": ">",
}  # what holds of continuous functions nearby if it holds at a place
LEADING = "leading"  # the name of the condition that equations can be solved for the highest derivatives


@dataclass(frozen=True)
class Jets:
    """A problem about numbers in the place of one about functions.

    Parameters
    ----------
    problem
        The problem with letters for the values of functions and their derivatives.
    calls
        What these letters stand for.
    """

    problem: Problem
    calls: Mapping[str, Call] = field(default_factory=dict)

    def refutable(self) -> Problem | None:
        """The problem with stricter conditions, whose counterexamples are those of functions; None if not known."""
        return _solved(self.problem, self.calls) if self.calls else self.problem


def of(problem: Problem) -> Jets | None:
    """The problem about numbers, if all unknown functions stand at one place, and the place nowhere else."""
    try:
        plain = expanded(problem)
    except (Unknown, Unsupported):
        return None
    stated = [plain.claim, *(f for _, fs in plain.hypotheses for f in fs), *(t for _, t in plain.definitions)]
    calls = {part for tree in stated for part in calls_in(tree)}
    places = {call.terms for call in calls}
    if len(places) != 1 or not all(isinstance(x, str) for x in next(iter(places))):
        return None
    bound = {x for part in nodes(*stated) for x in part.bound}
    if any(set(place) & bound for place in places):
        return None  # these are many places, at which a function has many values
    (place,) = places
    names = {call: _name(call) for call in calls}
    taken = set().union(*map(letters, stated)) | {name for name, _ in plain.definitions}
    if taken & set(names.values()):
        return None

    def put(tree: T) -> T:
        if isinstance(tree, Call):
            return names[tree]  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    definitions = tuple((name, put(term)) for name, term in plain.definitions)
    hypotheses = tuple((name, tuple(map(put, formulas))) for name, formulas in plain.hypotheses)
    found = replace(plain, claim=put(plain.claim), definitions=definitions, hypotheses=hypotheses)
    trees: list[Term] = [found.claim, *(f for _, fs in hypotheses for f in fs), *(t for _, t in definitions)]
    if set().union(*map(letters, trees)) & {str(x) for x in place}:
        return None  # what a function is may depend on its argument
    return Jets(found, {name: call for call, name in names.items()})


def without(problem: Problem) -> Jets:
    """The problem itself, its derivatives at places taken."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs)]
    if any(part.tag == "diff" and part.outside[-1] != part.bound[0] for part in nodes(*trees)):
        with suppress(Unknown, Unsupported):
            problem = expanded(problem)
    return Jets(problem)


def expanded(problem: Problem) -> Problem:
    """The same without derivatives of anything but unknown functions, definitions unfolded where they stand in them."""
    meant = dict(problem.definitions)

    def rate(tree: T) -> T:
        if not isinstance(tree, Node):
            return tree
        if isinstance(tree, Binder):
            tree = unfold(tree, meant)
        if isinstance(tree, Binder) and tree.tag == "diff":
            known = _with_series(tree)
            slope = node("diff", rate(known.body), known.letter, *known.outside)
            return rate(differentiated(slope))  # type: ignore[return-value, arg-type]
        new = mapped(tree, rate)
        return _AT_ZERO[new.tag] if new.tag in _AT_ZERO and new.outside == (0,) else new  # type: ignore[return-value]

    definitions = tuple((name, rate(term)) for name, term in problem.definitions)
    hypotheses = tuple((name, tuple(map(rate, formulas))) for name, formulas in problem.hypotheses)
    return replace(problem, claim=rate(problem.claim), definitions=definitions, hypotheses=hypotheses)


def _with_series(slope: Binder) -> Binder:
    """The same with the series of an integral between fixed ends, whose integrand is smooth at the place, to the order.

    Their derivatives at the place are the same, by Leibniz's rule.
    """
    x, (order, place) = slope.letter, slope.outside
    if place == x or not isinstance(order, int):
        return slope

    def series(tree: Term) -> Term:
        if not isinstance(tree, Node):
            return tree
        if not isinstance(tree, Binder) or tree.tag != "integral" or is_entire(tree.body, tree.letter, x):
            return mapped(tree, series, lambda inner: inner)
        if any(isinstance(end, End) or x in letters(end) for end in tree.outside) or not _is_smooth(tree, x, place):
            return tree
        addends: list[Term] = []
        for n in range(order + 1):
            rate = _worked_out(node("diff", tree.body, x, n, place))
            power = node("^", node("+", x, node("-", place)), n)
            coefficient = node("integral", rate, tree.letter, *tree.outside)
            addends.append(node("*", node("/", 1, factorial(n)), coefficient, power) if n else coefficient)
        return node("+", *addends)

    return node("diff", series(slope.body), x, *slope.outside)  # type: ignore[return-value]


def _is_smooth(integral: Binder, x: str, place: Term) -> bool:
    """Whether an integrand is smooth near a place of x, all the way between the ends."""
    low, high = integral.outside
    between = (node("<=", low, integral.letter), node("<=", integral.letter, high))
    try:
        conditions = [substituted(each, {x: place}) for each in regular(integral.body)]
    except Malformed:
        return False
    problems = (Problem("smooth", each, (), (("between", between),)) for each in conditions)
    return all(identity.decide(problem).verdict is Verdict.PROVED for problem in problems)


def _worked_out(slope: Node) -> Term:
    """A derivative without what vanishes in it."""
    assert isinstance(slope, Binder)
    try:
        return from_sympy(to_sympy(slope))
    except SymcheckError:
        return differentiated(slope)


def calls_in(tree: Term) -> Iterable[Call]:
    """The unknown functions with what they are applied to, also under binders."""
    return (part for part in parts(tree) if isinstance(part, Call))


def parts(tree: Term) -> Iterator[Node]:
    """All nodes of a term as often as they stand there, also under binders."""
    if isinstance(tree, Node):
        yield tree
        for part in (*tree.inside, *tree.outside):
            yield from parts(part)


def _name(call: Call) -> str:
    return "_".join([call.function, "at", *map(str, call.orders)])


def _solved(problem: Problem, jets: Mapping[str, Call]) -> Problem | None:
    """Whether the conditions are equations for highest derivatives; what must not vanish for that is one more."""
    known = dict(problem.definitions)
    formulas = [substituted(f, known) for _, fs in problem.hypotheses for f in fs if isinstance(f, Relation)]
    open_ = [f for f in formulas if letters(f) & jets.keys() and f.tag not in STRICT and not _is_always_so(f)]
    if any(letters(f) & jets.keys() for _, fs in problem.hypotheses for f in fs if not isinstance(f, Relation)):
        return None
    weak = [f for f in formulas if f.tag in ("<=", ">=") and letters(f) & jets.keys()]
    if weak:
        strict = tuple(node(STRICT[f.tag], *f.terms) for f in weak)
        problem = replace(problem, hypotheses=(*problem.hypotheses, ("strict", strict)))
    orders = {name: sum(call.orders) for name, call in jets.items()}
    tops: dict[str, int] = {}
    for formula in open_:
        for name in letters(formula) & jets.keys():
            function = jets[name].function
            tops[function] = max(tops.get(function, 0), orders[name])
    said = letters(substituted(problem.claim, known)) & jets.keys()
    if any(orders[name] > tops.get(jets[name].function, 8) for name in said) or any(
        len(c.orders) > 1 for c in jets.values()
    ):
        return None if open_ else problem
    leading: list[Formula] = []
    while open_:
        chosen = next(
            ((f, x) for f in sorted(open_, key=str, reverse=False) for x in _tops(f, jets, tops, orders)), None
        )
        if chosen is None:
            return None
        formula, x = chosen
        left, right = formula.terms
        gap = node("+", left, node("-", right))
        slope = derivative(gap, x)
        value = node("+", x, node("-", node("/", gap, slope)))
        if not isinstance(slope, int):
            leading.append(node("!=", slope, 0))
        del tops[jets[x].function]
        open_ = [substituted(f, {x: substituted(value, {x: 0})}) for f in open_ if f is not formula]
        open_ = [f for f in open_ if letters(f) & jets.keys()]
    if leading:
        problem = replace(problem, hypotheses=(*problem.hypotheses, (LEADING, tuple(leading))))
    return problem


def _is_always_so(formula: Formula) -> bool:
    """Does it say nothing, as the derivative of an equation beside that equation?"""
    return identity.decide(Problem("always so", formula)).verdict is Verdict.PROVED


def _tops(formula: Formula, jets: Mapping[str, Call], tops: dict[str, int], orders: dict[str, int]) -> Iterable[str]:
    """The highest derivatives for which an equation can be solved."""
    if formula.tag != "=":
        return
    for x in sorted(letters(formula) & jets.keys()):
        function = jets[x].function
        if tops.get(function, 0) != orders[x] or not orders[x]:
            continue
        left, right = formula.terms
        try:
            slope = derivative(node("+", left, node("-", right)), x)
        except Unknown:
            continue
        others = {name for name in letters(slope) & jets.keys() if orders[name] >= tops.get(jets[name].function, 9)}
        if x not in letters(slope) and slope != 0 and not others:
            yield x
