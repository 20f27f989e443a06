"""What a wrong relation could have meant: the slips of the pen that make it true, each proved, the likeliest first."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symcheck.checker import check
from symcheck.core.problems import Problem
from symcheck.core.terms import JSON, Reader
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.proof import certificate, fails_at, proof_of
from symcheck.question import jets
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.prepare import Reading, worded
from symcheck.reading import Notation, Tree, edits, to_latex, with_brackets
from symcheck.reading.tree import Add, Call, Chain, Div, Mul, Name, Neg, Number, Path, Pow, Sqrt, replaced, walk

MOST = 5  # repairs that are shown
SECONDS = 4.0  # for all of them: nearly all that are found at all are found in one
# how often corrections in public texts are of a kind, the most frequent first
LIKELY = ("sign", "factor", "exponent", "index", "letter", "number", "function", "term", "relation")
SISTERS = {
    "sin": ("cos",), "cos": ("sin", "cosh"), "tan": ("cot",), "cot": ("tan",), "sinh": ("cosh", "sin"),
    "cosh": ("sinh", "cos"), "ln": ("exp",), "exp": ("ln",), "arcsin": ("arccos",), "arccos": ("arcsin",),
}  # fmt: skip


def repairs(reading: Reading, point: dict[str, JSON]) -> tuple[dict[str, str], ...]:
    """At most five relations that are one slip away from the one that was refuted at a point, and are proved."""
    found: list[dict[str, str]] = []
    try:
        with limited(SECONDS):
            for kind, description, tree in sorted(_slips(reading.tree, reading.inference.notation), key=_rank):
                if _is_proved(reading, tree, point):
                    found.append({"relation": with_brackets(tree), "kind": kind, "edit": description})
                if len(found) == MOST:
                    break
    except OutOfTime:
        pass
    return tuple(found)


Slip = tuple[str, str, Tree]


def _rank(slip: Slip) -> int:
    return LIKELY.index(slip[0])


def _slips(tree: Tree, notation: Notation) -> Iterator[Slip]:
    seen = {tree}
    for kind, description, new in (*_plain(tree, notation), *_further(tree, notation)):
        if new not in seen and not _is_trivial(new):
            seen.add(new)
            yield kind, description, new


def _plain(tree: Tree, notation: Notation) -> Iterator[Slip]:
    for edit in edits(tree, notation):
        yield edit.kind, edit.description, edit.tree


def _is_trivial(tree: Tree) -> bool:
    return isinstance(tree, Chain) and any(tree.members[k] == tree.members[k + 1] for k in range(len(tree.signs)))


def _further(tree: Tree, notation: Notation) -> Iterator[Slip]:
    """Slips that those of a printer do not contain: lost factors and roots, other letters of the same text."""
    letters = [Name(x.latex) for x in notation.letters if x.kind == "scalar" and not x.indices and x.value is None]
    numbers = [Number(str(n)) for n in (2, 3, 4)]
    for path, node in walk(tree):
        above = _above(tree, path)
        if isinstance(above, Add | Chain) or (
            isinstance(above, Neg) and isinstance(_above(tree, path[:-1]), Add | Chain)
        ):
            term = node.value if isinstance(node, Neg) else node
            for factor in (*numbers, *letters):
                for new in (_times(factor, term), Div(term, factor)):
                    changed = Neg(new) if isinstance(node, Neg) else new
                    yield "factor", f"factor {to_latex(factor)}", replaced(tree, path, changed)
        if isinstance(node, Call) and isinstance(node.function, str):
            for sister in SISTERS.get(node.function, ()):
                yield "function", f"{node.function} for {sister}", replaced(tree, path, replace(node, function=sister))
        if isinstance(node, Name) and not node.primes and not node.dots and not isinstance(above, Call):
            yield "exponent", f"root of {to_latex(node)}", replaced(tree, path, Sqrt(node))
            for other in letters:
                if other != node and notation.find(node.letter, 0) is not None:
                    yield "letter", f"{to_latex(node)} for {to_latex(other)}", replaced(tree, path, other)
        if isinstance(node, Number) and node.text.isdigit():
            for value in _near(int(node.text)):
                yield "number", f"number {node.text} for {value}", replaced(tree, path, Number(str(value)))
            if not isinstance(above, Pow):
                for other in letters:
                    yield "number", f"{node.text} for {to_latex(other)}", replaced(tree, path, other)


def _near(n: int) -> list[int]:
    return [m for m in {2 * n, n // 2 if n % 2 == 0 else n, n * n, n + 2, n - 2, 4 * n} if m > 0 and m != n]


def _times(factor: Tree, term: Tree) -> Tree:
    return Mul((factor, *(term.factors if isinstance(term, Mul) else (term,))))


def _above(tree: Tree, path: Path) -> Tree | None:
    if not path:
        return None
    nodes = dict(walk(tree))
    return nodes[path[:-1]]


def _is_proved(reading: Reading, tree: Tree, point: dict[str, JSON]) -> bool:
    """Whether the relation has a proof that the checker accepts; one that fails at the point needs no search."""
    try:
        problems = worded(reading, tree)
    except SymcheckError:
        return False
    return all(_proof_holds(problem, point) for problem in problems)


def _proof_holds(problem: Problem, point: dict[str, JSON]) -> bool:
    numbers = jets.of(problem)
    tried = numbers.problem if numbers else problem
    if tried.claim[1:2] == tried.claim[2:3]:
        return False
    reader = Reader()
    try:
        if fails_at(tried, {x: reader.term(value) for x, value in point.items()}):
            return False
    except (KeyError, ValueError):
        pass
    outcome = proof_of(tried)
    return outcome is not None and outcome.verdict is Verdict.PROVED and check(certificate(tried, outcome)) is None
