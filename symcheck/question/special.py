r"""Special functions that print knows by their letters, such as J_\nu(x) and P_n(x), by the relations that define them.

Members of a family are related to their neighbours and to their derivatives. A claim follows from so many of these
relations as reach from its lowest member to its highest, or by induction from the first members; it is false if it is
so of members that are written out. What is proved of the family that usually has a letter is proved; what is false of
it is only so if somebody says that it is meant.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache

from symcheck.core.calculus import Unknown, derivative, differentiated, functions, letters, nodes, substituted
from symcheck.core.problems import Problem
from symcheck.core.terms import PI, Binder, Call, Formula, Malformed, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError
from symcheck.question.prepare import DEFINED, Asked, Reading
from symcheck.reading.occurrences import occurrences

ORDER, ARGUMENT = "n", "x"  # in the relations below
ARGUMENT_OF_MEMBERS = "argument_of_members"  # where it is no letter
MOST = 8  # the order up to which members are written out
TRIED = (
    2,
    1,
    3,
    0,
    Fraction(1, 2),
    Fraction(3, 2),
)  # orders at which a claim is looked at: of low ones some false claims hold


@dataclass(frozen=True)
class Family:
    """Functions f(n), each of x, with d(f(n)) for a derivative.

    Parameters
    ----------
    names
        What the functions are called, by the letters that usually stand for them.
    relations
        Equations between members and their derivatives.
    first
        Members that are known, by letter and order.
    step
        The next member by the two before it, by letter.
    mirrored
        The sign for which f(-n) is that power of f(n), for whole n, by letter.
    slopes
        The derivative of some order that is known by others and by lower ones, by letter.
    ordered
        Whether members have an order, which is printed below; otherwise it counts as 0.
    scaled
        What members are multiplied by in the relations, by letter: these are so of rational numbers then.
    """

    names: Mapping[str, str]
    relations: tuple[str, ...]
    first: Mapping[tuple[str, Fraction], str]
    step: Mapping[str, str]
    mirrored: Mapping[str, int]
    slopes: Mapping[str, tuple[int, str]] = field(default_factory=dict)
    ordered: bool = True
    scaled: Mapping[str, Term] = field(default_factory=dict)


def _polynomials(letter: str, name: str, first: str, second: str, step: str, *relations: str) -> Family:
    start = {(letter, Fraction(0)): first, (letter, Fraction(1)): second}
    return Family({letter: name}, relations, start, {letter: step}, {})


def _functions(names: Mapping[str, str], slopes: Mapping[str, tuple[int, str]]) -> Family:
    """Functions without an order: f(n) stands for f."""
    return Family(names, (), {}, {}, {}, slopes, ordered=False)


_HALF = Fraction(1, 2)
_ELLIPTIC = "complete elliptic integral of the"
_WAVE = "sqrt(2/(pi*x))"
FAMILIES = (
    _polynomials(
        "P", "Legendre polynomial", "1", "x", "((2*n + 1)*x*P(n) - n*P(n - 1))/(n + 1)",
        "(n + 1)*P(n + 1) == (2*n + 1)*x*P(n) - n*P(n - 1)",
        "(x**2 - 1)*d(P(n)) == n*x*P(n) - n*P(n - 1)",
        "d(P(n + 1)) == x*d(P(n)) + (n + 1)*P(n)",
        "n*P(n) == x*d(P(n)) - d(P(n - 1))",
    ),
    Family(
        {"T": "Chebyshev polynomial of the first kind", "U": "Chebyshev polynomial of the second kind"},
        (
            "T(n + 1) == 2*x*T(n) - T(n - 1)", "U(n + 1) == 2*x*U(n) - U(n - 1)", "T(n) == U(n) - x*U(n - 1)",
            "d(T(n)) == n*U(n - 1)", "(x**2 - 1)*d(U(n)) == (n + 1)*T(n + 1) - x*U(n)",
        ),
        {("T", Fraction(0)): "1", ("T", Fraction(1)): "x", ("U", Fraction(0)): "1", ("U", Fraction(1)): "2*x"},
        {"T": "2*x*T(n) - T(n - 1)", "U": "2*x*U(n) - U(n - 1)"}, {},
    ),
    _polynomials(
        "H", "Hermite polynomial", "1", "2*x", "2*x*H(n) - 2*n*H(n - 1)",
        "H(n + 1) == 2*x*H(n) - 2*n*H(n - 1)", "d(H(n)) == 2*n*H(n - 1)",
    ),
    _polynomials(
        "He", "probabilist's Hermite polynomial", "1", "x", "x*He(n) - n*He(n - 1)",
        "He(n + 1) == x*He(n) - n*He(n - 1)", "d(He(n)) == n*He(n - 1)",
    ),
    _polynomials(
        "L", "Laguerre polynomial", "1", "1 - x", "((2*n + 1 - x)*L(n) - n*L(n - 1))/(n + 1)",
        "(n + 1)*L(n + 1) == (2*n + 1 - x)*L(n) - n*L(n - 1)", "x*d(L(n)) == n*L(n) - n*L(n - 1)",
        "d(L(n)) == d(L(n - 1)) - L(n - 1)",
    ),
    *(
        Family(
            {letter: f"Bessel function of the {kind} kind"},
            (
                f"2*n*{letter}(n) == x*{letter}(n - 1) + x*{letter}(n + 1)",
                f"2*d({letter}(n)) == {letter}(n - 1) - {letter}(n + 1)",
                f"x*d({letter}(n)) == x*{letter}(n - 1) - n*{letter}(n)",
                f"x*d({letter}(n)) == n*{letter}(n) - x*{letter}(n + 1)",
            ),
            start, {letter: f"2*n/x*{letter}(n) - {letter}(n - 1)"}, {letter: -1},
        )
        for letter, kind, start in (
            ("J", "first", {("J", -_HALF): f"{_WAVE}*cos(x)", ("J", _HALF): f"{_WAVE}*sin(x)"}),
            ("Y", "second", {("Y", -_HALF): f"{_WAVE}*sin(x)", ("Y", _HALF): f"-{_WAVE}*cos(x)"}),
        )
    ),
    Family(
        {"I": "modified Bessel function of the first kind"},
        (
            "2*n*I(n) == x*I(n - 1) - x*I(n + 1)", "2*d(I(n)) == I(n - 1) + I(n + 1)",
            "x*d(I(n)) == x*I(n - 1) - n*I(n)", "x*d(I(n)) == n*I(n) + x*I(n + 1)",
        ),
        {("I", -_HALF): f"{_WAVE}*(exp(x) + exp(-x))/2", ("I", _HALF): f"{_WAVE}*(exp(x) - exp(-x))/2"},
        {"I": "I(n - 1) - 2*n/x*I(n)"}, {"I": 1},
    ),
    Family(
        {"K": "modified Bessel function of the second kind"},
        (
            "2*n*K(n) == x*K(n + 1) - x*K(n - 1)", "-2*d(K(n)) == K(n - 1) + K(n + 1)",
            "x*d(K(n)) == -x*K(n - 1) - n*K(n)", "x*d(K(n)) == n*K(n) - x*K(n + 1)",
        ),
        {("K", -_HALF): "sqrt(pi/(2*x))*exp(-x)", ("K", _HALF): "sqrt(pi/(2*x))*exp(-x)"},
        {"K": "K(n - 1) + 2*n/x*K(n)"}, {"K": 1},
    ),
    *(
        Family(
            {letter: f"spherical Bessel function of the {kind} kind"},
            (
                f"(2*n + 1)*{letter}(n) == x*{letter}(n - 1) + x*{letter}(n + 1)",
                f"x*d({letter}(n)) == x*{letter}(n - 1) - (n + 1)*{letter}(n)",
                f"x*d({letter}(n)) == n*{letter}(n) - x*{letter}(n + 1)",
            ),
            {(letter, Fraction(0)): zeroth, (letter, Fraction(1)): first},
            {letter: f"(2*n + 1)/x*{letter}(n) - {letter}(n - 1)"}, {},
        )
        for letter, kind, zeroth, first in (
            ("j", "first", "sin(x)/x", "sin(x)/x**2 - cos(x)/x"),
            ("y", "second", "-cos(x)/x", "-cos(x)/x**2 - sin(x)/x"),
        )
    ),
    Family(
        {"Li": "polylogarithm"}, ("x*d(Li(n)) == Li(n - 1)",),
        {("Li", Fraction(0)): "x/(1 - x)", ("Li", Fraction(1)): "-log(1 - x)"}, {}, {}, {"Li": (1, "Li(n - 1)/x")},
    ),
    _functions(
        {"Ai": "Airy function of the first kind", "Bi": "Airy function of the second kind"},
        {"Ai": (2, "x*Ai(n)"), "Bi": (1, "(1/pi + d(Ai(n))*Bi(n))/Ai(n)")},
    ),
    *(
        _functions({letter: f"{name} integral"}, {letter: (1, f"({slope})/x")})
        for letter, name, slope in (
            ("Si", "sine", "sin(x)"), ("Ci", "cosine", "cos(x)"), ("Ei", "exponential", "exp(x)"),
            ("Shi", "hyperbolic sine", "(exp(x) - exp(-x))/2"), ("Chi", "hyperbolic cosine", "(exp(x) + exp(-x))/2"),
        )
    ),
    _functions({"Dawson": "Dawson function"}, {"Dawson": (1, "1 - 2*x*Dawson(n)")}),
    *(
        _functions(
            {k: f"{_ELLIPTIC} first kind of the {of}", e: f"{_ELLIPTIC} second kind of the {of}"},
            {k: (1, f"({e}(n) - ({rest})*{k}(n))/({c}*x*({rest}))"), e: (1, f"({e}(n) - {k}(n))/({c}*x)")},
        )
        for k, e, of, c, rest in (
            ("K_of_k", "E_of_k", "modulus", 1, "1 - x**2"), ("K_of_m", "E_of_m", "parameter", 2, "1 - x"),
        )
    ),
)  # fmt: skip


def _joined(one: str, other: str, *relations: str, scaled: Mapping[str, Term] | None = None) -> Family:
    """Two families with relations between them; those within each are linear, so that they hold of multiples too."""
    a, b = (next(family for family in FAMILIES if x in family.names) for x in (one, other))
    return Family(
        {**a.names, **b.names}, (*a.relations, *b.relations, *relations), {**a.first, **b.first}, {**a.step, **b.step},
        {**a.mirrored, **b.mirrored}, scaled=scaled or {},
    )  # fmt: skip


USUAL = {x: family for family in FAMILIES for x in family.names if x not in ("j", "y")}
JOINED = (  # DLMF 10.5.2, 10.28.2, 10.50.1
    _joined("J", "Y", "J(n + 1)*Y(n) - J(n)*Y(n + 1) == 2/x", scaled={"Y": PI}),
    _joined("I", "K", "I(n)*K(n + 1) + I(n + 1)*K(n) == 1/x"),
    _joined("j", "y", "j(n + 1)*y(n) - j(n)*y(n + 1) == 1/x**2"),
)
INTEGRALS = {  # members of whole order, as integrals over half a turn, divided by pi
    "J": "cos(n*t - x*sin(t))",
    "I": "exp(x*cos(t))*cos(n*t)",
    "K_of_k": "pi/(2*sqrt(1 - x**2*sin(t)**2))",
    "E_of_k": "pi*sqrt(1 - x**2*sin(t)**2)/2",
    "K_of_m": "pi/(2*sqrt(1 - x*sin(t)**2))",
    "E_of_m": "pi*sqrt(1 - x*sin(t)**2)/2",
}
NAMED = {name: (x, family) for family in FAMILIES for x, name in family.names.items()}
SAID_SO, ITS_USUAL = "(said so)", "(its usual letter)"
UPRIGHT = ("Ai", "Bi", "Si", "Ci", "Shi", "Chi", "Ei", "Li")  # names that are printed so say what they are
# a letter, perhaps upright
_BARE = re.compile(r"(?:\\(?:text|mathrm)\s*\{\s*)?(?P<stem>[A-Za-z]+)\s*\}?")
# the same with one subscript
_MEMBER = re.compile(
    r"(?:\\(?:text|mathrm)\s*\{\s*)?(?P<stem>[A-Za-z]+)\s*\}?\s*_\s*(?:\{(?P<group>.*)\}|(?P<one>\S+))"
)
_MOVED = re.compile(r"(?P<base>\\?[A-Za-z]+)(?P<shift>[+-]\d+(?:/\d+)?)?")  # n, n+1, \nu-1, n+1/2


def said(letters_: Iterable[tuple[str, str]]) -> dict[str, str]:
    """The letters that are said to be special functions, without their subscripts, with the names of these."""
    found = {}
    for letter, phrase in letters_:
        name = re.sub(r"^(?:an?|the)\s+", "", phrase.strip())
        name = re.sub(r"^(\w+(?:'s)? polynomial|(?:modified |spherical )?Bessel function)s\b", r"\1", name)
        if name in NAMED:
            found[letter.partition("_")[0]] = name
        elif f"{name} of the modulus" in NAMED:
            raise SymcheckError(f"{letter}: {name} of the modulus k, or of the parameter m = k^2? say which")
    return found


def _with_subscripts(text: str, stems: Iterable[str]) -> Iterator[tuple[str, str, bool]]:
    """Letters with a subscript, perhaps upright: these, and whether arguments in brackets follow."""
    letters_ = "|".join(map(re.escape, sorted(stems, key=len, reverse=True)))
    # a command, which is passed over; or a letter, perhaps the end of upright text, its subscript, primes, a bracket
    pattern = (
        rf"\\(?!text\b|mathrm\b)[A-Za-z]+|({letters_})\s*\}}?\s*_\s*(?:\{{((?:[^{{}}]|\{{[^{{}}]*\}})*)\}}|(\\?[A-Za-z]+|\d))\s*"
        r"((?:'|\^\s*\{?\s*(?:\\prime\s*)+\}?)*\s*(?:\\left)?\()?"
    )
    for match in re.finditer(pattern, text):
        if match[1]:
            yield match[1], match[2] or match[3], bool(match[4])


def may_have(texts: Iterable[str], declared: Mapping[str, str]) -> bool:
    """Whether a special function may stand in one of some formulas: a usual or declared letter with a subscript."""
    texts = [*texts]
    plain = [*UPRIGHT, *(x for x, name in declared.items() if not NAMED[name][1].ordered)]
    bare = re.compile(rf"(?<![A-Za-z\\])(?:{'|'.join(map(re.escape, plain))})(?![A-Za-z])")
    return any(map(bare.search, texts)) or any(
        applied for text in texts for _, _, applied in _with_subscripts(text, {*USUAL, *declared})
    )


@dataclass(frozen=True)
class Order:
    """That of a member: a number, or a letter and so many more."""

    base: str
    shift: Fraction

    def term(self, base: Term) -> Term:
        """The order as a term."""
        return _added(base, self.shift) if self.base else _number(self.shift)


def _number(n: Fraction) -> Term:
    return int(n) if n.denominator == 1 else node("/", n.numerator, n.denominator)


def _added(base: Term, shift: Fraction) -> Term:
    return node("+", base, _number(shift)) if shift else base


def _order(text: str) -> Order | None:
    """What a subscript says."""
    plain = re.sub(r"[\s{}]", "", text)
    if fraction := re.fullmatch(r"(-?)(?:\\[dt]?frac)?(\d+)/?(\d+)?", plain):
        if r"\frac" in plain and fraction[3] is None and len(fraction[2]) == 2:
            return Order("", Fraction(int(fraction[2][0]), int(fraction[2][1])) * (-1 if fraction[1] else 1))
        return Order("", Fraction(int(fraction[2]), int(fraction[3] or 1)) * (-1 if fraction[1] else 1))
    moved = _MOVED.fullmatch(re.sub(r"\\[dt]?frac(\d)(\d)", r"\1/\2", plain))
    return Order(moved["base"].lstrip("\\"), Fraction(moved["shift"] or 0)) if moved else None


@dataclass(frozen=True)
class Members:
    """The members of one family that stand in a problem.

    Parameters
    ----------
    family
        Their family.
    of
        The letter that usually stands for each, and its order, by its name in the problem.
    latex
        How each is printed.
    """

    family: Family
    of: Mapping[str, tuple[str, Order]]
    latex: Mapping[str, str]

    @property
    def base(self) -> str:
        """The letter in the orders; "" if they are numbers."""
        return next((order.base for _, order in self.of.values() if order.base), "")

    @property
    def integrals(self) -> bool:
        """Whether a member is written out as an integral."""
        return any(usual in INTEGRALS and order.shift.denominator == 1 for usual, order in self.of.values())


def members(reading: Reading, declared: Mapping[str, str]) -> Members | None:
    """The special functions of a reading, all of one family; None if other unknown functions stand there."""
    problem = reading.problems[0]
    called = functions(problem.claim)
    if not called or any(functions(f) for name, fs in problem.hypotheses if name != DEFINED for f in fs):
        return None
    found, latex = dict[str, tuple[str, Order]](), dict[str, str]()
    families = list[Family]()
    for letter in reading.inference.notation.letters:
        if letter.name not in called and letter.stem not in called:
            continue
        match = _MEMBER.fullmatch(letter.latex) or _BARE.fullmatch(letter.latex)
        if match is None:
            return None
        stem = match["stem"]
        usual, family = NAMED[declared[stem]] if stem in declared else (stem, USUAL.get(stem))
        below = match["group"] or match["one"] if match.re is _MEMBER else None
        order = _order(below) if below is not None else Order("", Fraction(0))
        if family is None or order is None or family.ordered is (below is None):
            return None
        families.append(family)
        found[str(letter.name or letter.stem)], latex[str(letter.name or letter.stem)] = (usual, order), letter.latex
    bases = {order.base for _, order in found.values()}
    letters_ = {usual for usual, _ in found.values()}
    family = next((each for each in (*families[:1], *JOINED) if letters_ <= each.names.keys()), None)
    known = found.keys() == called and family is not None and len(bases) == 1
    return Members(family, found, latex) if family is not None and known else None


def is_upright(found: Members) -> bool:
    """Whether the members are printed with names of several upright letters, which say what they are."""
    return all(usual in UPRIGHT and found.latex[name].startswith("\\") for name, (usual, _) in found.of.items())


def is_telling(found: Members) -> bool:
    """Whether names say what they are, or the formula has more than one first member, which may be anything."""
    orders = [order for _, order in found.of.values()]
    several = len(orders) > 1 or bool(orders[0].base)
    return is_upright(found) or several or orders[0].shift >= 2 or orders[0].shift.denominator > 1


def is_said(found: Members, where: Iterable[str]) -> bool:
    """Does an equation say what members are? Then they are not those that the letter usually stands for."""
    own = {latex.partition("_")[0].strip() for latex in found.latex.values()}
    return any(place.word in own for text in where for place in occurrences(text.partition("=")[0]))


# --- relations


def _calls(tree: Term) -> Iterator[Call]:
    for part in nodes(tree):
        if isinstance(part, Call):
            yield part
        for body in part.inside:
            yield from _calls(body)


def related(problem: Problem, found: Members, more: int) -> Problem | None:
    """The problem with the relations of the members that occur, and of so many before and behind them."""
    claim = problem.claim
    if any(not isinstance(call.terms[0], str) for call in _calls(claim)):  # by the chain rule
        try:
            claim = _without_derivatives(claim)
        except Unknown:
            return None
    scaled = {name: found.family.scaled[x] for name, (x, _) in found.of.items() if x in found.family.scaled}
    calls = [*_calls(claim)]
    claim = _over(claim, scaled)
    arguments = {call.terms for call in calls}
    if not found.family.relations or len(arguments) != 1 or any(len(terms) != 1 for terms in arguments):
        return None
    ((at,),) = arguments
    slopes = max(sum(call.orders) for call in calls) + sum(
        int(part.outside[0]) for part in nodes(claim) if part.tag == "diff" and isinstance(part.outside[0], int)
    )
    own = at if isinstance(at, str) else ARGUMENT_OF_MEMBERS
    base: Term = found.base or 0
    shifts = [order.shift for _, order in found.of.values()]
    low, high = min(shifts) - more, max(shifts) + more
    names = {(usual, order.shift): name for name, (usual, order) in found.of.items()}

    def member(usual: str, shift: Fraction, order: int, argument: Term) -> Term:
        if not found.base and shift.denominator == 1 and shift < 0:
            sign = found.family.mirrored.get(usual)
            if sign is None:
                raise Malformed(f"no member of order {shift}")
            positive = member(usual, -shift, order, argument)
            return node("-", positive) if sign < 0 and shift % 2 else positive
        if not low <= shift <= high:
            raise Malformed("beyond the members that occur")
        name = names.setdefault((usual, shift), f"{usual}_{len(names)}_of_them")
        return node("call", name, (order,), argument)

    formulas = list[Formula]()
    for text in found.family.relations:
        for k in range(int(high - low) + 1):
            with suppress(Malformed, Unknown):
                formula = _read(text, _Place(base, low + k, own, member))
                formulas.append(formula)
                for _ in range(slopes - _steepest(formula)):
                    left, right = formula.outside
                    formula = node("=", derivative(left, own), derivative(right, own))
                    formulas.append(formula)
    formulas = [substituted(formula, {own: at}) for formula in formulas]
    name = " and the ".join(
        found.family.names[usual] for usual in dict.fromkeys(usual for usual, _ in found.of.values())
    )
    return replace(
        problem, claim=claim, hypotheses=(*problem.hypotheses, (f"relations of the {name}", tuple(formulas)))
    )


def _over(tree: T, scaled: Mapping[str, Term]) -> T:
    """The same with members divided by what is said."""
    if isinstance(tree, Call) and tree.function in scaled:
        return node("/", tree, scaled[tree.function])  # type: ignore[return-value]
    return mapped(tree, lambda part: _over(part, scaled)) if isinstance(tree, Node) and scaled else tree  # type: ignore[return-value]


def _without_derivatives(tree: T) -> T:
    """The same with the derivatives of terms with members worked out."""
    if isinstance(tree, Binder) and tree.tag == "diff" and any(_calls(tree)):
        return _without_derivatives(differentiated(tree))  # type: ignore[return-value]
    return mapped(tree, _without_derivatives) if isinstance(tree, Node) else tree  # type: ignore[return-value]


def _steepest(formula: Formula) -> int:
    return max((sum(call.orders) for call in _calls(formula)), default=0)


@dataclass(frozen=True)
class _Place:
    """Where a relation is read: a base, a shift, an argument, and what a member is there."""

    base: Term
    shift: Fraction
    at: Term
    member: Callable[[str, Fraction, int, Term], Term]


@cache
def _parsed(text: str) -> ast.expr:
    return ast.parse(text, mode="eval").body


def _read(text: str, place: _Place) -> Formula:
    found = _part(_parsed(text), place, 0)
    assert isinstance(found, Node)
    return found


_SIGNS = {ast.Add: "+", ast.Mult: "*", ast.Div: "/", ast.Pow: "^", ast.Eq: "="}


def _part(tree: ast.expr, place: _Place, order: int) -> Term:
    match tree:
        case ast.Constant(value=int(number)):
            return number
        case ast.Name(id="n"):
            return _added(place.base, place.shift) if place.base != 0 else _number(place.shift)
        case ast.Name(id="x"):
            return place.at
        case ast.Name(id="pi"):
            return PI
        case ast.Name(id=name):
            return name
        case ast.UnaryOp(operand=inner):
            return node("-", _part(inner, place, order))
        case ast.BinOp(op=ast.Add(), left=ast.Name(id="n"), right=ast.Constant(value=int(more))):
            ahead = replace(place, shift=place.shift + more)
            return _part(tree.left, ahead, order)
        case ast.BinOp(op=ast.Sub(), left=left, right=right):
            return node("+", _part(left, place, order), node("-", _part(right, place, order)))
        case ast.BinOp(op=op, left=left, right=right) | ast.Compare(ops=[op], left=left, comparators=[right]):
            return node(_SIGNS[type(op)], _part(left, place, order), _part(right, place, order))
        case ast.Call(func=ast.Name(id="d"), args=[inner]):
            return _part(inner, place, order + 1)
        case ast.Call(func=ast.Name(id=("sqrt" | "sin" | "cos" | "exp" | "log" | "gamma") as name), args=[inner]):
            return node(name, _part(inner, place, order))
        case ast.Call(func=ast.Name(id=usual), args=[index]):
            return place.member(usual, place.shift + _ahead(index), order, place.at)
    raise AssertionError(ast.dump(tree))


def _ahead(index: ast.expr) -> int:
    """How many more than n."""
    match index:
        case ast.BinOp(op=op, right=ast.Constant(value=int(number))):
            return -number if isinstance(op, ast.Sub) else number
    return 0


# --- members written out


@cache
def written(family_letter: str, name: str, order: Fraction) -> Term | None:
    """A member as a term in x; None where it has none that is known here."""
    family = NAMED[name][1]
    integral = INTEGRALS.get(family_letter)
    if integral is not None and order.denominator == 1:
        inner = _part(_parsed(integral), _Place(0, order, ARGUMENT, _no_member), 0)
        return node("/", node("integral", inner, "t", 0, PI), PI)
    if (text := family.first.get((family_letter, order))) is not None:
        return _part(_parsed(text), _Place(0, order, ARGUMENT, _no_member), 0)
    if family_letter not in family.step:
        return None
    lowest = min((o for x, o in family.first if x == family_letter and (o - order).denominator == 1), default=None)
    if lowest is None or not lowest < order <= MOST:
        return None

    def earlier(usual: str, shift: Fraction, _: int, __: Term) -> Term:
        found = written(usual, name, shift)
        assert found is not None
        return found

    return _part(_parsed(family.step[family_letter]), _Place(0, order - 1, ARGUMENT, earlier), 0)


def step_of(name: str, n: str, x: str) -> tuple[Term, Term]:
    """What the member of order n, and the one before it, are multiplied by in the next one."""
    usual, family = NAMED[name]
    now, before = "member_now", "member_before"

    def member(letter: str, shift: Fraction, _: int, __: Term) -> Term:
        if letter != usual or shift not in (0, -1):
            raise Malformed("a step with other members")
        return now if shift == 0 else before

    step = _part(_parsed(family.step[usual]), _Place(n, Fraction(0), x, member), 0)
    return tuple(substituted(step, {own: 1, other: 0}) for own, other in ((now, before), (before, now)))  # type: ignore[return-value]


def _no_member(*_: object) -> Term:
    raise Malformed("no member stands there")


def term_of(text: str) -> Term:
    """A term of a declaration without members, such as "gamma(a + 1/2)/sqrt(pi)"."""
    return _part(_parsed(text), _Place(0, Fraction(0), ARGUMENT, _no_member), 0)


def written_out(
    problem: Problem, found: Members, number: Fraction | int | None = None, *, partly: bool = False
) -> Problem | None:
    """The problem with members written out, at a whole number for the letter in their orders.

    Partly: known derivatives alone, in which other members may stand.
    """
    family, by = found.family, {} if number is None else {found.base: _number(Fraction(number))}
    places = {name: (usual, order.shift + (number or 0)) for name, (usual, order) in found.of.items()}

    def member(usual: str, order: Fraction, slopes: int, argument: Term) -> Term:
        name = next((name for name, place in places.items() if place == (usual, order)), f"{usual}_{order}_of_them")
        places[name] = usual, order
        return node("call", name, (slopes,), argument)

    def value(call: Call) -> Term | None:
        (usual, order), slopes = places[call.function], sum(call.orders)
        known, text = family.slopes.get(usual, (slopes + 1, ""))
        if slopes >= known:
            term, slopes = _part(_parsed(text), _Place(0, order, ARGUMENT, member), 0), slopes - known
        elif partly and (usual, order) not in family.first:
            return None
        else:
            mirror = order.denominator == 1 and order < 0 and usual in family.mirrored
            own = written(usual, family.names[usual], -order if mirror else order)
            if own is None:
                raise Malformed(f"{call.function} cannot be written out")
            term = node("-", own) if mirror and order % 2 and family.mirrored[usual] < 0 else own
        for _ in range(slopes):
            term = derivative(term, ARGUMENT)
        return put(term)

    def put(tree: T) -> T:
        if isinstance(tree, Binder) and tree.tag == "diff" and family.slopes and any(_calls(tree)):
            return put(differentiated(tree))  # type: ignore[return-value]
        if isinstance(tree, Call) and tree.function in places and (term := value(tree)) is not None:
            return substituted(term, {ARGUMENT: put(tree.terms[0])})  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    with suppress(Unknown, Malformed):
        hypotheses = tuple((name, tuple(substituted(put(f), by) for f in fs)) for name, fs in problem.hypotheses)
        return replace(problem, claim=substituted(put(problem.claim), by), hypotheses=hypotheses)
    return None


# --- sequences


def as_sequences(problem: Problem, found: Members) -> Problem | None:
    """The problem with sequences for members of whole orders at their arguments, with recurrences and first values."""
    n = found.base
    calls = [*_calls(problem.claim)]
    if not n or any(sum(call.orders) or n in letters(call.terms[0]) for call in calls):
        return None
    if any(part.inside for part in nodes(problem.claim)):
        return None
    arguments = list(dict.fromkeys(call.terms[0] for call in calls))
    used = {(found.of[call.function][0], call.terms[0]) for call in calls}

    def named(usual: str, at: Term, place: Term) -> Term:
        return node("call", f"{usual}_at_{arguments.index(at) + 1}", (0,), place)

    def put(tree: T) -> T:
        if isinstance(tree, Call):
            usual, order = found.of[tree.function]
            return named(usual, tree.terms[0], order.term(n))  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    formulas = list[Formula]()
    for usual, at in sorted(used, key=repr):
        if (usual, Fraction(0)) not in found.family.first or (usual, Fraction(1)) not in found.family.first:
            return None

        def member(letter: str, shift: Fraction, _: int, argument: Term) -> Term:
            return named(letter, argument, _added(n, shift))

        place = _Place(n, Fraction(1), at, member)
        after = named(usual, at, node("+", n, 2))
        formulas.append(node("=", after, _part(_parsed(found.family.step[usual]), place, 0)))
        for k in (0, 1):
            text = found.family.first[usual, Fraction(k)]
            value = _part(_parsed(text), _Place(0, Fraction(k), at, _no_member), 0)
            formulas.append(node("=", named(usual, at, k), value))
    name = next(iter(found.family.names.values()))
    hypotheses = (*problem.hypotheses, (f"recurrence of the {name}", tuple(formulas)))
    return replace(problem, claim=put(problem.claim), hypotheses=hypotheses)


def with_whole_orders(asked: Asked, declared: Mapping[str, str]) -> Asked:
    """The same with the letters in orders of polynomials as whole numbers."""
    stems = [x for x in {*USUAL, *declared} if "polynomial" in declared.get(x, USUAL[x].names[x] if x in USUAL else "")]
    orders = (_order(below) for _, below, _ in _with_subscripts(asked.relation, stems))
    whole = dict.fromkeys(order.base for order in orders if order is not None and len(order.base) == 1)
    known = {letter for letter, _ in asked.letters} | {text.split()[0] for text in asked.given if r"\in" in text}
    return replace(asked, letters=(*asked.letters, *((x, "integer") for x in whole if x not in known)))


_BY = re.compile(r"\{d([a-z])(?:\^\{?\d\}?)?\}")  # the letter by which something is differentiated, behind a line


def with_arguments(asked: Asked, declared: Mapping[str, str]) -> Asked:
    """The same where functions without an order stand without arguments: they are functions of the letter in d/dk."""
    text = re.sub(r"\s", "", asked.relation)
    by = {*_BY.findall(text)}
    plain = [x for x, name in declared.items() if not NAMED[name][1].ordered]
    if len(by) != 1 or not plain or any(re.search(rf"(?<![A-Za-z\\]){x}'*(?:\\left)?\(", text) for x in plain):
        return asked
    return replace(asked, letters=(*asked.letters, *((x, f"function of {next(iter(by))}") for x in plain)))


def with_names(asked: Asked, declared: Mapping[str, str]) -> Asked:
    """The same with names of several letters as such, He_n for example, which else are products."""
    several = [x for x in declared if len(x) > 1 and x.isalpha()]
    if not several:
        return asked
    spelled = "|".join(r"\s*".join(x) for x in several)
    bare = re.compile(rf"\\[A-Za-z]+|({spelled})(?=\s*_)")  # a command, which is passed over, or such a name
    relation, *where = (
        bare.sub(lambda found: rf"\mathrm{{{found[1].replace(' ', '')}}}" if found[1] else found[0], text)
        for text in (asked.relation, *asked.where)
    )
    return replace(asked, relation=relation, where=tuple(where))


def inlined(problem: Problem) -> Problem:
    """The problem with what letters are defined as in their places, also where they are differentiated."""
    by = dict(problem.definitions)

    def put(tree: T) -> T:
        if isinstance(tree, str):
            return put(by[tree]) if tree in by else tree  # type: ignore[return-value]
        return mapped(tree, put) if isinstance(tree, Node) else tree  # type: ignore[return-value]

    return replace(problem, claim=put(problem.claim), definitions=())


def passed_over(taken: Mapping[str, str], declared: Mapping[str, str], where: Sequence[str], *, refuted: bool) -> str:
    """Why a verdict does not hold that took a function that is known for any function, or for a number; or "".

    What holds of all functions holds of it. What is defined is what is defined.
    """
    defined = {re.split(r"[(=]", re.sub(r"\s|\\left", "", text))[0] for text in where}
    for letter, what in taken.items():
        plain = re.sub(r"\\mathrm\{(\w+)\}", r"\1", letter).replace(" ", "")
        stem, _, below = plain.partition("_")
        if {plain, letter} & defined or what.endswith((SAID_SO, ITS_USUAL)):
            continue
        if stem in declared and (refuted or not what.startswith("a function")):
            return f"{letter} is said to be a {declared[stem]}, of which nothing is known here"
        if refuted and below and stem in USUAL and what.startswith("a function"):
            return f"is {letter} a {USUAL[stem].names[stem]}? say what it is"
    return ""


def shown(found: Members, declared: Mapping[str, str]) -> dict[str, str]:
    """What the members are taken for."""
    names = {name: found.family.names[usual] for name, (usual, _) in found.of.items()}
    why = SAID_SO if declared else ITS_USUAL
    return {found.latex[name]: f"a {names[name]} {why}" for name in found.of}


def tried(found: Members, whole: Iterable[str]) -> Sequence[int | Fraction | None]:
    """The numbers for the letter in orders at which a claim is looked at."""
    return [n for n in TRIED if found.base not in {*whole} or isinstance(n, int)] if found.base else (None,)
