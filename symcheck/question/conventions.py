"""What a printed relation leaves unsaid, on which a verdict may rest: what depends on what, and what brackets mean."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Set
from itertools import pairwise

from symcheck.question.prepare import Reading
from symcheck.reading import Notation, Tree, to_latex
from symcheck.reading.evidence import spelling
from symcheck.reading.occurrences import occurrences
from symcheck.reading.parser import dependence
from symcheck.reading.tree import Add, Bars, Call, Chain, Cross, Derivative, MatrixOf, Mul, Name, Pow, Transpose, walk

APPLIED = frozenset({"f", "g", "h", "F", "G", "H", r"\phi", r"\varphi", r"\psi"})  # letters that are usually functions
OPERATIONS = frozenset({"+", "-", "/", "^", r"\times", r"\cdot"})  # brackets around these are those of a factor
# a unit in square brackets: "\mathrm{[dBW]}"
_UNIT = re.compile(r"\\(?:text|mathrm|mbox|textrm|rm)\s*\{\s*\[")
# a hyphen as text, which is neither a letter nor a minus
_HYPHEN = re.compile(r"\\(?:text|mathrm|mbox|textrm)\s*\{\s*-+\s*\}")

_LAYOUT = re.compile(r"[{}\s]")  # that does not tell one name from another

Rate = tuple[str, int, int]  # a letter with its primes and dots


def mentioned(latex: str, texts: Iterable[str]) -> bool:
    """Whether a name of several tokens stands in one of some formulas, with or without braces around its scripts."""
    name = _LAYOUT.sub("", latex)
    return any(name in _LAYOUT.sub("", text) for text in texts)


def unsaid(reading: Reading) -> str:
    """The doubt what is meant, on which even a proof may rest; the empty text if none is seen."""
    said = {letter for letter, _ in reading.source[0].letters}
    known = said | {*reading.source[2]}
    return (
        _signs(reading.source[0].relation)
        or _declared(reading.tree, known)
        or _held(reading)
        or _marks(reading, known)
        or _numbers(reading, known)
    )


def _signs(relation: str) -> str:
    """The doubt about text and signs that may be no factors."""
    if hyphen := _HYPHEN.search(relation):
        return f"{hyphen[0]}: a hyphen in a name, or a minus? write - for a minus"
    if _UNIT.search(relation):
        return "text in square brackets: a unit, or a factor? leave units out"
    return ""


def _held(reading: Reading) -> str:
    for body, by in constant(reading):
        return f"does {body} depend on {by}? its derivative is 0 if not; say 'function of {by}', or leave it out"
    return ""


def _marks(reading: Reading, known: Set[str]) -> str:
    """The doubt about primes beside dots, letters above functions, and brackets that may be those of a function."""
    places = occurrences(reading.source[0].relation)
    own = [place for place in places if place.word not in known]
    both = {spelling(place) for place in own if place.dots} & {spelling(place) for place in own if place.primes}
    if both:
        return f"is the prime of {min(both)} the same derivative as its dot? write one of them, or say what it is"
    applied = [part.function for _, part in walk(reading.tree) if isinstance(part, Call)]
    functions = {each.letter for each in applied if isinstance(each, Name)}
    for place in places:
        if not place.arguments or place.word in known:
            continue
        inside = ", ".join(place.arguments)
        if place.word in functions:
            above = "".join(place.superscript or ()).strip("{}")
            if above.isalpha():
                return f"{place.word}^{above}({inside}): a power, an iterate, or a derivative? write brackets around it"
        elif place.transposed and not {*inside.split()} & OPERATIONS:
            return f"{place.word}^T({inside}): a value of a function, or a product?"
        elif place.word in APPLIED and any(p.word == place.word and not p.arguments for p in places):
            return f"{place.word}({inside}): a value of the function {place.word}, or a product?"
    return ""


def _numbers(reading: Reading, known: Set[str]) -> str:
    """The doubt whether letters are real numbers."""
    tree, guesses = reading.tree, reading.inference.guesses
    spelled = names(tree)
    if (
        len(units := sorted(g.letter.latex for g in guesses if g.letter.number == "i" and g.letter.latex in spelled))
        > 1
    ):
        return f"are {', '.join(units)} the units of quaternions, or of complex numbers? write one of them"
    real = {g.letter.latex for g in guesses if g.taken == "a real number"} - known
    bars = [part for _, part in walk(tree) if isinstance(part, Bars) and "z" in names(part)]
    if bars and "z" in real and not any("z" in x for x in spelled - {"z"}):
        return "is z a real number, or a complex one? say what it is"
    if capitals := next(_exponents(tree, known), None):
        return f"it relies on the order of factors: are {capitals} numbers, or matrices? say what they are"
    printed = reading.source[0].relation
    if r"\cdot" in printed or any(isinstance(part, Transpose | Cross) for _, part in walk(tree)):
        vectors = {g.letter.latex for g in guesses if g.letter.kind == "vector"}
        pairs = (pair for _, part in walk(tree) if isinstance(part, Mul) for pair in pairwise(part.factors))
        for before, after in pairs:
            capital = isinstance(before, Name) and before.letter in real and before.letter.isupper()
            if capital and names(after) & vectors:
                return f"is {to_latex(before)} before a vector a number, or a matrix? say what it is"
    return ""


def names(tree: Tree) -> set[str]:
    """The letters of a tree."""
    return {part.letter for _, part in walk(tree) if isinstance(part, Name)}


def _declared(tree: Tree, known: Set[str]) -> str:
    """What an equation such as f = f(x) is, or one of a bold letter with a matrix of letters."""
    for _, chain in walk(tree):
        if isinstance(chain, Chain):
            plain = [part.value if isinstance(part, Transpose) else part for part in chain.members]
            entries = [each for part in plain if isinstance(part, MatrixOf) for row in part.rows for each in row]
            alone = [part for part in chain.members if isinstance(part, Name) and part.letter not in known]
            if (
                alone
                and len(entries) > 1
                and len({*entries}) == len(entries)
                and all(isinstance(x, Name) for x in entries)
            ):
                return (
                    f"it says what the components of {to_latex(alone[0])} are called, which is neither true nor false"
                )
            for pair, sign in zip(pairwise(chain.members), chain.signs, strict=True):
                bare = [each.function for each in pair if isinstance(each, Call) and not each.arguments]
                full = [each.function for each in pair if isinstance(each, Call) and each.arguments]
                if sign == "=" and bare and bare == full and isinstance(bare[0], Name) and bare[0].letter not in known:
                    return f"it says what {to_latex(bare[0])} depends on, which is neither true nor false"
    return ""


def constant(reading: Reading) -> Iterator[tuple[str, str]]:
    """What is differentiated by a letter on which nothing in it depends, as far as is seen."""
    said = dict(reading.source[0].letters)
    meant = {x: {*free(right)} for x, (_, _, right) in reading.source[2].items()}
    for _, part in walk(reading.tree):
        if not isinstance(part, Derivative):
            continue
        on, todo = set[Rate](), {_rate(each) for _, each in walk(part.body) if isinstance(each, Name)}
        phrases = [said[letter] for letter, *_ in todo if letter in said]
        if not todo or (phrases and (part.partial or {*phrases} <= {"constant", "scalar"})):
            continue
        while todo:
            on |= todo
            todo = {more for each in todo for more in _on(each, meant, reading.inference.notation)} - on
        for variable, _ in part.variables:
            by = variable.function if isinstance(variable, Call) else variable
            if not isinstance(by, Name):
                continue
            if on.isdisjoint(_places(by, meant) if part.partial else _along(by, meant, reading)):
                yield to_latex(part.body), to_latex(variable)


def _places(by: Name, meant: Mapping[str, Set[Rate]]) -> set[Rate]:
    """A letter, and the letters of what it is equal to, as the components of a column are."""
    return {_rate(by), *((x, primes, dots + by.dots) for x, primes, dots in meant.get(by.letter, ()))}


def _along(by: Name, meant: Mapping[str, Set[Rate]], reading: Reading) -> set[Rate]:
    """A letter with those on which it depends: what depends on these depends on it, where its rate is not 0."""
    return {_rate(by), *_on(_rate(by), meant, reading.inference.notation)}


def _rate(name: Name) -> Rate:
    return name.letter, name.primes, name.dots


def free(text: str) -> Iterator[Rate]:
    """The letters of a definition, but for those with an index over which it sums and no dots."""
    places = occurrences(text)
    indices = {place.word for place in places if place.role == "index"}
    for place in places:
        running = {*(place.subscript or ())} & indices
        if place.dots or not running:
            yield place.word if running else spelling(place), place.primes, place.dots


def _on(rate: Rate, meant: Mapping[str, Set[Rate]], notation: Notation) -> Iterator[Rate]:
    """The letters on which a letter depends, by its definition if it has one."""
    if rate[0] in meant:
        yield from meant[rate[0]]
        return
    letter = next((each for each in notation.letters if each.latex == rate[0]), None)
    for each in dependence(letter, notation) if letter else ():
        if isinstance(each, Name):
            yield _rate(each)


def _exponents(tree: Tree, said: Set[str]) -> Iterator[str]:
    """Capital letters that are added in an exponent, perhaps all times the same, where products of powers stand too."""
    exponents: dict[Tree, Tree] = {part: part.exponent for _, part in walk(tree) if isinstance(part, Pow)}
    exponents |= {
        part: part.arguments[0] for _, part in walk(tree) if isinstance(part, Call) and part.function == "exp"
    }
    if not any(isinstance(part, Mul) and sum(f in exponents for f in part.factors) > 1 for _, part in walk(tree)):
        return
    for part in (part for each in exponents.values() for _, part in walk(each) if isinstance(part, Add)):
        added = [{*names(term)} for term in part.terms]
        capitals = sorted({x for x in set[str]().union(*added) if len(x) == 1 and x.isupper() and x not in said})
        one_each = all(len(own.intersection(capitals)) == 1 for own in added)
        if len(capitals) > 1 and one_each and len({frozenset(own.difference(capitals)) for own in added}) == 1:
            yield ", ".join(capitals)
