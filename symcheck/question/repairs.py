"""What a wrong relation could have meant: the slips of the pen that make it true, each proved, the likeliest first."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from symcheck.checker import check
from symcheck.core import terms
from symcheck.core.calculus import functions
from symcheck.core.problems import Problem
from symcheck.core.terms import JSON, Reader, Term, Value
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.proof import certificate, fails_at, proof_of
from symcheck.proof.algebra.knowledge import ORDERS
from symcheck.proof.algebra.polynomial import number_of, unfold
from symcheck.question import jets
from symcheck.question.antiderivatives import FAULTS, hinted
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.prepare import Reading, worded
from symcheck.question.roots import rooted
from symcheck.question.solutions import with_solutions
from symcheck.reading import Notation, edits, to_latex, to_sympy, with_brackets
from symcheck.reading.evidence import spelling
from symcheck.reading.occurrences import occurrences
from symcheck.reading.tree import (
    Add,
    Antiderivative,
    Call,
    Chain,
    Derivative,
    Div,
    Integral,
    MatrixOf,
    Mul,
    Name,
    Neg,
    Number,
    Path,
    Pow,
    Sqrt,
    Tree,
    children,
    replaced,
    walk,
    with_children,
)

SIMPLIFYING = 1.0  # seconds for SymPy to find what is missing
MISSING = -5.8  # a lost term, where it is known, is as likely as a lost factor
EVERYWHERE = ", everywhere"  # behind what a slip does that is made more than once
OTHERS = ((5, 7), (4, -5))  # first numerators and their steps: numbers that are no whole ones and not alike
MOST = 5  # repairs that are shown
MOST_ORDERS = 20  # that are proved of an order: weaker ones are proved as well
SECONDS = 6.0  # for all of them: nearly all that are found at all are found in one, but for those about integrals
if TYPE_CHECKING:
    from sympy import Expr

# how often corrections in public texts are of a kind, the most frequent first
LIKELY = ("sign", "factor", "exponent", "index", "letter", "number", "function", "term", "relation")
SISTERS = {
    "sin": ("cos",), "cos": ("sin", "cosh"), "tan": ("cot",), "cot": ("tan",), "sinh": ("cosh", "sin"),
    "cosh": ("sinh", "cos"), "ln": ("exp",), "exp": ("ln",), "arcsin": ("arccos",), "arccos": ("arcsin",),
}  # fmt: skip


def repairs(reading: Reading, point: dict[str, JSON]) -> tuple[dict[str, str], ...]:
    """At most five relations that are one slip away from the one that was refuted at a point, and are proved.

    Of orders more are proved than are meant: those come first whose sides are nearest to each other at the point.
    """
    ordered = any(problem.claim.tag in ORDERS for problem in reading.problems)
    found = _proved(reading, point, lambda found: len(found) == (MOST_ORDERS if ordered else MOST))
    if ordered:
        found.sort(key=lambda slip: _apart(reading, slip.tree, point))
    return tuple(
        {"relation": with_brackets(slip.tree), "kind": slip.kind, "edit": slip.description} for slip in found[:MOST]
    )


def explained(reading: Reading, point: dict[str, JSON]) -> bool:
    """Whether one of the first relations that are proved is one slip away, made in one place alone."""
    found = _proved(reading, point, lambda found: _is_single(found[-1]) or len(found) == MOST)
    return any(map(_is_single, found))


def _is_single(slip: Slip) -> bool:
    return not slip.description.endswith(EVERYWHERE)


def _proved(reading: Reading, point: dict[str, JSON], enough: Callable[[list[Slip]], bool]) -> list[Slip]:
    """The slips whose relations are proved, the likeliest first, until there are enough or the time is over."""
    found, points = list[Slip](), _points(point)
    with suppress(OutOfTime), limited(SECONDS):
        for slip in likely(reading, missing(reading)):
            if _is_proved(reading, slip.tree, points):
                found.append(slip)
                if enough(found):
                    break
    return found


def _points(point: dict[str, JSON]) -> list[dict[str, Term]]:
    """The point of a counterexample, and two with other numbers: what fails at one of them needs no search."""
    reader = Reader()
    at = {x: reader.term(value) for x, value in point.items()}
    plain = [x for x, value in at.items() if number_of(value) is not None]
    return [
        at,
        *(at | {x: terms.node("/", step * k + first, 3) for k, x in enumerate(plain)} for first, step in OTHERS),
    ]


def _apart(reading: Reading, tree: Tree, point: dict[str, JSON]) -> float:
    """How far the sides of a relation are from each other at a point."""
    total, reader = 0.0, Reader()
    with suppress(SymcheckError, *FAULTS):
        values = {x: to_sympy(reader.term(value)) for x, value in point.items()}
        for problem in worded(reading, tree):
            left, right = (to_sympy(unfold(side, dict(problem.definitions))) for side in problem.claim.terms)
            gap = left - right
            total += abs(float(gap.subs({x: values[x.name] for x in gap.free_symbols if x.name in values})))
        return total
    return float("inf")


class Slip(NamedTuple):
    """A relation that was meant, perhaps; `unlikely` is added to its rank."""

    kind: str
    description: str
    tree: Tree
    unlikely: float = 0.0


def likely(reading: Reading, others: Iterable[Slip] = ()) -> list[Slip]:
    """The relations that are one slip of the pen away, and others, the likeliest first; nothing is known of them."""
    tree, notation = reading.tree, reading.inference.notation
    counts = Counter(node for _, node in walk(tree) if isinstance(node, Name))
    first = {node for _, node in walk(tree.members[0])} if isinstance(tree, Chain) else set()
    once = {x for x, count in counts.items() if count == 1 and x not in first and not _is_alone(x, tree, notation)}
    words, names = _elsewhere(reading)
    lonely = {x for x in once if x.letter not in (words if x.subscripts else names)}
    size = _size(tree)

    def rank(slip: Slip) -> float:
        odd = not lonely <= {node for _, node in walk(slip.tree)}  # a letter that stands nowhere else is gone
        shorter = 0.01 * (_size(slip.tree) - size)
        return LIKELY.index(slip.kind) + slip.unlikely - 10 * odd + _beside(tree, slip.tree) + shorter

    return sorted((*_slips(tree, notation), *others), key=rank)


def _is_alone(name: Name, tree: Tree, notation: Notation) -> bool:
    """Whether nobody repeats it: the sign of an order, or what is added to an antiderivative."""
    letter = notation.find(name.letter, len(name.subscripts))
    added = any(isinstance(part, Add) and name in part.terms for _, part in walk(tree))
    indefinite = any(isinstance(part, Antiderivative) for _, part in walk(tree))
    return (letter is not None and letter.order is not None) or (added and indefinite)


def _elsewhere(reading: Reading) -> tuple[set[str], set[str]]:
    """The letters of definitions and conditions, without subscripts and with them; not the arguments of definitions."""
    words, names = set[str](), set[str]()
    asked, _, defined, *_ = reading.source
    own = {f"{left} = {right}".replace(" ", ""): arguments for left, arguments, right in defined.values()}
    for text in (*asked.where, *asked.given):
        local = own.get(text.replace(" ", ""), ())
        for place in (place for place in occurrences(text) if spelling(place) not in local):
            words.add(place.word)
            names.add(spelling(place))
    return words, names


def missing(reading: Reading) -> Iterator[Slip]:
    """The factor or the addend that the right side lacks, if it is a product of powers of letters."""
    import sympy

    tree = reading.tree
    if not isinstance(tree, Chain) or len(tree.members) != len(reading.problems) + 1:
        return
    for k, problem in enumerate(reading.problems, start=1):
        if problem.claim.tag != "=" or problem.claim[1] == problem.claim[2]:
            continue
        try:
            with limited(SIMPLIFYING):
                left, right = _sides(problem)
                if all(_powers(side.doit(), reading.inference.notation) is not None for side in (left, right)):
                    continue  # any product becomes any other
                ratio, gap = sympy.simplify(left / right), sympy.expand(sympy.simplify(left - right))
        except (*FAULTS, SymcheckError, OutOfTime):
            continue
        member = tree.members[k]
        if (factors := _powers(ratio, reading.inference.notation)) is not None:
            new = member.value if isinstance(member, Neg) else member
            for factor, exponent in factors:
                for _ in range(abs(exponent)):
                    new = _times(factor, new) if exponent > 0 else _over(new, factor)
            new = Neg(new) if isinstance(member, Neg) != bool(ratio.could_extract_minus_sign()) else new
            yield Slip("factor", f"factor {sympy.latex(ratio)}", replaced(tree, (k,), new), 0.1)
        if (factors := _powers(gap, reading.inference.notation)) is not None:
            new = Number("1")
            for factor, exponent in factors:
                power = factor if abs(exponent) == 1 else Pow(factor, Number(str(abs(exponent))))
                new = _times(power, new) if exponent > 0 else _over(new, power)
            new = _with_term(member, Neg(new) if gap.could_extract_minus_sign() else new)
            yield Slip("term", f"term {sympy.latex(gap)} missing", replaced(tree, (k,), new), MISSING)


def _sides(problem: Problem) -> tuple[Expr, Expr]:
    """Both sides of an equation; the left one by an equation that is given, where it is solved for it."""
    import sympy

    definitions = dict(problem.definitions)
    left, right = (to_sympy(unfold(side, definitions)) for side in problem.claim.terms)
    if not isinstance(problem.claim.terms[0], Value):
        for equation in (f for _, fs in problem.hypotheses for f in fs if f.tag == "="):
            a, b = (to_sympy(unfold(side, definitions)) for side in equation.terms)
            if (a - b).has(left) and len(found := sympy.solve(a - b, left)) == 1:
                return found[0], right
    return left, right


def _with_term(member: Tree, term: Tree) -> Tree:
    """The sum with one more addend; numbers stand last."""
    terms = member.terms if isinstance(member, Add) else (member,)
    last = isinstance(terms[-1].value if isinstance(terms[-1], Neg) else terms[-1], Number) and len(terms) > 1
    return Add((*terms[:-1], term, terms[-1])) if last else Add((*terms, term))


def _powers(expr: Expr, notation: Notation) -> list[tuple[Tree, int]] | None:
    """Numbers and letters with their exponents, of which an expression is the product up to its sign."""
    found: list[tuple[Tree, int]] = []
    for base, exponent in expr.as_powers_dict().items():
        if base == -1:
            continue
        if base.is_Rational and exponent == 1:
            found += [(Number(str(n)), e) for n, e in ((abs(base.p), 1), (base.q, -1)) if n != 1]
            continue
        letter = notation.owner(base.name) if base.is_Symbol else None
        if not exponent.is_Integer or letter is None or letter.indices:
            return None
        found.append((Name(letter.latex), int(exponent)))
    return found or None


def _size(tree: Tree) -> int:
    return sum(1 for _ in walk(tree))


def _beside(tree: Tree, new: Tree) -> float:
    """What is worked out stands on the right, and what it is on the left: a slip is rather where more is written."""
    if not isinstance(tree, Chain) or not isinstance(new, Chain) or len(tree.members) != 2:
        return 0.0
    left = new.members[0] != tree.members[0]
    return left * (3.0 if _is_simple(tree.members[0]) else 0.5)


def _is_simple(tree: Tree) -> bool:
    """Is this the name of something?"""
    inner = tree.value if isinstance(tree, Neg) else tree
    return isinstance(inner, Name | Derivative) or (isinstance(inner, Call) and isinstance(inner.function, Name))


def _slips(tree: Tree, notation: Notation) -> Iterator[Slip]:
    seen, tidy = {tree}, _tidied(tree) == tree
    for slip in (*_plain(tree, notation), *_further(tree, notation), *_repeated(tree, notation)):
        new = _tidied(slip.tree) if tidy else slip.tree
        if new not in seen and not _is_trivial(new):
            seen.add(new)
            yield slip._replace(tree=new)


def _plain(tree: Tree, notation: Notation) -> Iterator[Slip]:
    for edit in edits(tree, notation):
        yield Slip(edit.kind, edit.description, edit.tree)


def _repeated(tree: Tree, notation: Notation) -> Iterator[Slip]:
    """Slips made wherever the same is printed; and an index that runs through a term."""
    counts = Counter(node for _, node in walk(tree) if not isinstance(node, Name | Number))
    for part in (part for part, count in counts.items() if count > 1):
        for edit in edits(part, notation):
            yield Slip(edit.kind, edit.description + EVERYWHERE, _everywhere(tree, part, edit.tree), -0.2)
    known = {letter.latex for letter in notation.letters}
    for path, node in reversed([*walk(tree)]):  # what is printed again is wrong at its second place
        if not isinstance(_above(tree, path), Add):
            continue
        names = {part for _, part in walk(node) if isinstance(part, Name) and "_" in part.letter}
        for index in {name.letter.rpartition("_")[2] for name in names}:
            own = {name for name in names if name.letter.rpartition("_")[2] == index}
            others = {letter.rpartition("_")[2] for letter in known if "_" in letter} - {index}
            for other in sorted(others) if len(own) > 1 else ():
                by = {name: replace(name, letter=f"{name.letter.rpartition('_')[0]}_{other}") for name in own}
                if {name.letter for name in by.values()} <= known:
                    new = node
                    for name, renamed in by.items():
                        new = _everywhere(new, name, renamed)
                    yield Slip("index", f"index {index} -> {other} in {to_latex(node)}", replaced(tree, path, new))


def _everywhere(tree: Tree, part: Tree, new: Tree) -> Tree:
    if tree == part:
        return new
    return with_children(tree, tuple(_everywhere(child, part, new) for child in children(tree)))


def _tidied(tree: Tree) -> Tree:
    """The same without factors and divisors 1, and without a factor before a fraction with the numerator 1."""
    tree = with_children(tree, tuple(map(_tidied, children(tree))))
    match tree:
        case Div(top, Number("1")) | Pow(top, Number("1")):
            return top
        case Mul() if Number("1") in tree.factors:
            kept = tuple(factor for factor in tree.factors if factor != Number("1"))
            return Mul(kept) if len(kept) > 1 else kept[0] if kept else Number("1")
        case Mul((Number() as number, Div(Number("1"), bottom), *rest)):
            return Mul((Div(number, bottom), *rest)) if rest else Div(number, bottom)
    return tree


def _is_trivial(tree: Tree) -> bool:
    if any(isinstance(part, Integral) and part.low == part.high for _, part in walk(tree)):
        return True
    return isinstance(tree, Chain) and any(tree.members[k] == tree.members[k + 1] for k in range(len(tree.signs)))


def _further(tree: Tree, notation: Notation) -> Iterator[Slip]:
    """Slips that those of a printer do not contain: lost factors and roots, other letters of the same text."""
    letters = [Name(x.latex) for x in notation.letters if x.kind == "scalar" and not x.indices and x.value is None]
    numbers = [Number(str(n)) for n in (2, 3, 4)]
    for path, node in walk(tree):
        above = _above(tree, path)
        if isinstance(above, Add | Chain | MatrixOf) or (
            isinstance(above, Neg) and isinstance(_above(tree, path[:-1]), Add | Chain)
        ):
            term = node.value if isinstance(node, Neg) else node
            inside = {part for _, part in walk(term)}
            for factor in (*numbers, *letters):
                again = isinstance(factor, Name) and factor in inside  # then its exponent is wrong, rather
                for new in (_times(factor, term), _over(term, factor)):
                    changed = replaced(tree, path, Neg(new) if isinstance(node, Neg) else new)
                    yield Slip(
                        "factor", f"factor {to_latex(factor)}", changed, 1.5 * again + 0.3 * isinstance(term, Add)
                    )
        if isinstance(node, Neg):
            yield Slip("sign", f"the minus of {to_latex(node.value)} dropped", replaced(tree, path, node.value))
        if isinstance(node, Add) and not any(isinstance(each, Neg) for each in node.terms):
            yield Slip("sign", f"{to_latex(node)} for its product", replaced(tree, path, Mul(node.terms)), 1.0)
        if isinstance(node, Add) and len(node.terms) == 2 and isinstance(node.terms[1], Neg):
            around = Add((node.terms[1].value, Neg(node.terms[0])))
            yield Slip("sign", f"{to_latex(node)} turned around", replaced(tree, path, around), 0.5)
        if isinstance(node, Mul) and len(node.factors) == 2 and not node.dotted:
            yield Slip("sign", f"{to_latex(node)} for its sum", replaced(tree, path, Add(node.factors)), 2.0)
        if isinstance(node, Div) and not isinstance(node.bottom, Number):
            product = replaced(tree, path, _times(node.bottom, node.top))
            yield Slip("factor", f"{to_latex(node.bottom)} as a factor of {to_latex(node.top)}", product, 0.5)
        if isinstance(node, Div):
            above_, below = ({part for _, part in walk(side) if part in letters} for side in (node.top, node.bottom))
            for one, other in itertools.product(
                sorted(above_ - below, key=to_latex), sorted(below - above_, key=to_latex)
            ):
                exchanged = Div(_everywhere(node.top, one, other), _everywhere(node.bottom, other, one))
                yield Slip(
                    "letter", f"{to_latex(one)} and {to_latex(other)} exchanged", replaced(tree, path, exchanged), 0.5
                )
        if isinstance(node, MatrixOf):
            for what, rows in _rearranged(node.rows):
                yield Slip("index", what, replaced(tree, path, MatrixOf(rows)))
        if isinstance(node, Call):
            for letter in notation.letters:
                if letter.kind == "function" and len((letter.depends or "").split(",")) == len(node.arguments):
                    call = replace(node, function=Name(letter.latex))
                    yield Slip("letter", f"{to_latex(call)} for {to_latex(node)}", replaced(tree, path, call))
        if isinstance(node, Call) and isinstance(node.function, str):
            for sister in SISTERS.get(node.function, ()):
                yield Slip(
                    "function", f"{node.function} for {sister}", replaced(tree, path, replace(node, function=sister))
                )
        if isinstance(node, Name) and not node.primes and not node.dots and not isinstance(above, Call):
            yield Slip("exponent", f"root of {to_latex(node)}", replaced(tree, path, Sqrt(node)))
            for other in letters:
                if other != node and notation.find(node.letter, 0) is not None:
                    yield Slip("letter", f"{to_latex(node)} for {to_latex(other)}", replaced(tree, path, other))
        if isinstance(node, Number) and node.text.isdigit():
            for value in _near(int(node.text)):
                yield Slip("number", f"number {node.text} for {value}", replaced(tree, path, Number(str(value))))
            if not isinstance(above, Pow):
                for other in letters:
                    yield Slip("number", f"{node.text} for {to_latex(other)}", replaced(tree, path, other))


def _rearranged(rows: tuple[tuple[Tree, ...], ...]) -> Iterator[tuple[str, tuple[tuple[Tree, ...], ...]]]:
    """A printed matrix transposed, and with two entries beside each other exchanged."""
    if len(rows) == len(rows[0]) and (across := tuple(zip(*rows, strict=True))) != rows:
        yield "a matrix transposed", across
    places = [(k, m) for k, row in enumerate(rows) for m in range(len(row))]
    for (k, m), (j, n) in itertools.combinations(places, 2):
        one, other = rows[k][m], rows[j][n]
        if abs(k - j) + abs(m - n) == 1 and one != other:
            new = {(k, m): other, (j, n): one}
            grid = tuple(tuple(new.get((a, b), x) for b, x in enumerate(row)) for a, row in enumerate(rows))
            yield f"{to_latex(one)} and {to_latex(other)} exchanged", grid


def _near(n: int) -> list[int]:
    return [m for m in {2 * n, n // 2 if n % 2 == 0 else n, n * n, n + 2, n - 2, 4 * n} if m > 0 and m != n]


def _times(factor: Tree, term: Tree) -> Tree:
    """The product as one prints it: a fraction is multiplied above, numbers stand before letters."""
    match term:
        case Number(text) if isinstance(factor, Number) and text.isdigit():
            return Number(str(int(text) * int(factor.text)))
        case Number("1"):
            return factor
        case Number():
            return Mul((term, factor))
        case Div(Add(), _):
            return Mul((term, factor))
        case Div(top, bottom):
            return Div(_times(factor, top), bottom)
        case Mul((Div(Number() as top, bottom), *rest)):
            return Mul((Div(_times(factor, top), bottom), *rest), term.dotted)
        case Mul((Number() as first, *rest)):
            both = _times(factor, first)
            return Mul((*(both.factors if isinstance(both, Mul) else (both,)), *rest))
    return Mul((factor, *(term.factors if isinstance(term, Mul) else (term,))))


def _over(term: Tree, factor: Tree) -> Tree:
    """The quotient as one prints it: what cancels is left out, a fraction is divided below."""
    match term:
        case Number(text) if isinstance(factor, Number) and text.isdigit() and int(text) % int(factor.text) == 0:
            return Number(str(int(text) // int(factor.text)))
        case Div(Mul() as top, bottom) if factor in top.factors:
            return Div(_over(top, factor), bottom)
        case Div(top, bottom):
            return Div(top, _times(factor, bottom))
        case Mul(factors) if factor in factors:
            k = factors.index(factor)
            rest = (*factors[:k], *factors[k + 1 :])
            return Mul(rest) if len(rest) > 1 else rest[0]
        case Mul((Div(top, bottom), *rest)):
            return Mul((Div(top, _times(factor, bottom)), *rest), term.dotted)
    return Number("1") if term == factor else Div(term, factor)


def _above(tree: Tree, path: Path) -> Tree | None:
    if not path:
        return None
    nodes = dict(walk(tree))
    return nodes[path[:-1]]


def _is_proved(reading: Reading, tree: Tree, points: Sequence[Mapping[str, Term]]) -> bool:
    """Whether the relation has a proof that the checker accepts; one that fails at a point needs no search."""
    try:
        problems = worded(reading, tree)
    except SymcheckError:
        return False
    # that real parts are the same, or components of matrices, is what an exponential or a product means, not a name
    products = any(isinstance(node, Mul | Pow | Call) for _, node in walk(tree))
    complex_ = any(letter.number == "i" for letter in reading.inference.notation.letters)
    parts = complex_ or (products and len(problems) > 1)
    before = {problem.claim for problem in reading.problems}
    return all(
        _proof_holds(problem, points, parts)
        for problem in problems
        if problem.claim not in before or not _is_same(problem)
    )


def _is_same(problem: Problem) -> bool:
    """Are both sides the same, which proves nothing?"""
    return problem.claim[1:2] == problem.claim[2:3]


def _proof_holds(problem: Problem, points: Sequence[Mapping[str, Term]], parts: bool) -> bool:
    for way in (jets.of, jets.without):
        if (numbers := way(problem)) is None:
            continue
        tried = numbers.problem
        if _is_same(tried) and not parts:
            return False
        for point in points:
            with suppress(KeyError, ValueError):
                if fails_at(tried, point):
                    return False
        tried = rooted(hinted(tried))
        outcome = proof_of(tried)
        if outcome is None and (solved := with_solutions(problem) if functions(problem.claim) else None) is not None:
            tried, outcome = solved, proof_of(solved)
        if outcome is not None and outcome.verdict is Verdict.PROVED and check(certificate(tried, outcome)) is None:
            return True
    return False
