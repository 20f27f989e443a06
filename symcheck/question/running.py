"""What depends on the letters that run under integrals, sums and products, or that stand for numbers at a bar."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from symcheck.core.calculus import letters, nodes, substituted
from symcheck.core.terms import Binder, Call, Formula, Node, T, Term, mapped, node
from symcheck.core.verdicts import NoForm
from symcheck.core.words import term
from symcheck.reading import Notation, Tree, to_latex
from symcheck.reading.lowering import written
from symcheck.reading.occurrences import occurrences
from symcheck.reading.tree import Antiderivative, Evaluated, Name, walk

RUNNING = ("integral", "sum", "product", "mean")


def written_under(tree: T, terms: Mapping[str, Term]) -> T:
    """The same with definitions in the place of their letters where these depend on a letter that runs.

    With F = k x the integral of F by x is that of k x: F is no constant there.
    """
    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, lambda part: written_under(part, terms))
    if not isinstance(new, Binder) or new.tag not in RUNNING:
        return new  # type: ignore[return-value]
    body = new.body
    while named := sorted(x for x in letters(body) & terms.keys() - {new.letter} if new.letter in needed(x, terms)):
        body = written(body, named[0], terms[named[0]])
    return node(new.tag, body, new.letter, *new.outside)  # type: ignore[return-value]


def written_in_functions(equation: Formula, terms: Mapping[str, Term]) -> Formula:
    """An equation between functions with definitions written out where these depend on arguments of the functions."""
    places = {x for part in nodes(equation) if isinstance(part, Call) for x in part.terms if isinstance(x, str)}
    while named := sorted(x for x in letters(equation) & terms.keys() - places if needed(x, terms) & places):
        equation = substituted(equation, {named[0]: terms[named[0]]})
    return equation


def refuse_tied_bodies(
    functions: Mapping[str, tuple[tuple[Tree, ...], Tree]],
    formulas: Iterable[str],
    hypotheses: Iterable[Formula],
    terms: Mapping[str, Term],
    notation: Notation,
) -> None:
    """NoForm where an equation ties a letter to an argument by which a function is said, and that is asked elsewhere.

    With f(x) = u^2 and u - x = 1 nobody says what f(3) is.
    """
    said = [(term(f), needed(f, terms)) for f in hypotheses if f.tag == "=" and not _is_between_functions(f)]
    known = set().union(*(names for _, names in said))
    calls = [place for text in formulas for place in occurrences(text) if place.arguments] if said else []
    for name, (own, body) in functions.items():
        printed = tuple(to_latex(x) for x in own)
        if all(place.arguments == printed for place in calls if place.word == name):
            continue
        inside = _names(known, [each for _, each in walk(body)], notation)
        for by in _names(known, own, notation):
            _refuse_tied(by, inside, said)


def _names(known: Iterable[str], parts: Iterable[Tree], notation: Notation) -> set[str]:
    """Those of some names whose letters are among parts of a formula."""
    owners = {notation.find(n.letter, len(n.subscripts)) for n in parts if isinstance(n, Name)}
    return {name for name in known if notation.owner(name) in owners}


def refuse_tied(
    formulas: Sequence[Formula],
    claimed: int,
    tree: Tree,
    terms: Mapping[str, Term],
    solved: Iterable[str],
    notation: Notation,
) -> None:
    """NoForm where an equation ties a letter under a sign to the one that runs, and is not solved for it.

    Nobody says then whether it is constant. An equation between functions of that letter holds at all its values.
    The first formulas are what is claimed; of the letters that are solved for, nothing is written out behind a bar.
    """
    equations = [f for f in formulas[claimed:] if f.tag == "=" and not _is_between_functions(f)]
    said = [(term(f), needed(f, terms)) for f in equations]
    values = {x: (f"{x} = {term(t)}", {x, *needed(t, terms)}) for x, t in terms.items()}
    printed = [*said, *(values[x] for x in solved)]
    undone = any(isinstance(part, Antiderivative) for _, part in walk(tree))  # their derivatives are nowhere printed
    for part in signs(*formulas, *terms.values(), also=() if undone else ("diff",)):
        own = [values[part.letter]] if part.letter in values else []
        others = {x: t for x, t in terms.items() if x != part.letter}
        _refuse_tied(part.letter, needed(part.body, others), [*said, *own])
    known = set().union(*(names for _, names in printed))
    for by, inside, beside in _printed(tree, known, notation):
        for each in printed:
            tied = inside & each[1] - {by}
            _refuse_tied(by, inside if beside is None else (tied & beside if tied else beside), [each])


def _refuse_tied(by: str, inside: set[str], said: Iterable[tuple[str, set[str]]]) -> None:
    for text, names in said:
        if by in names and (tied := sorted(inside & names - {by})):
            which = f"does {tied[0]} depend" if len(tied) == 1 else f"which of {', '.join(tied)} depends"
            raise NoForm(f"{which} on {by}, as {text}? solve that for it")


def _printed(tree: Tree, known: Iterable[str], notation: Notation) -> Iterator[tuple[str, set[str], set[str] | None]]:
    """The letters with a value behind a bar, and those of integrals without bounds, with the names that stand there.

    Of such integrals also the names that stand beside them: these are differentiated, what is integrated is not.
    """

    found = [(path, part) for path, part in walk(tree) if isinstance(part, Evaluated | Antiderivative)]
    for at, part in found:
        inside = _names(known, (each for _, each in walk(part.body)), notation)
        beside = _names(known, (each for path, each in walk(tree) if path[: len(at)] != at), notation)
        variable = part.variable
        if not isinstance(variable, Name):
            continue
        owner = notation.find(variable.letter, len(variable.subscripts))
        for name in known:
            if owner is not None and notation.owner(name) == owner:
                yield name, inside, beside if isinstance(part, Antiderivative) else None


def signs(*trees: Term, also: Collection[str] = ()) -> Iterator[Binder]:
    """All integrals, sums, products and means, those under others too."""
    for part in nodes(*trees):
        if isinstance(part, Binder) and (part.tag in RUNNING or part.tag in also):
            yield part
        yield from signs(*part.inside, also=also)


def needed(tree: Term, terms: Mapping[str, Term]) -> set[str]:
    """The letters that occur free where all definitions are written out."""
    found = letters(tree)
    while named := found & terms.keys():
        found = found.difference(named).union(*(letters(terms[x]) for x in named))
    return found


def _is_between_functions(formula: Formula) -> bool:
    return any(isinstance(part, Call) or part.tag == "diff" for part in nodes(formula))
