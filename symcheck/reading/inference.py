"""What the letters of formulas mean where nobody has declared them: inferred from what is done with them, and why.

Where two readings are possible there are several inferences, each a whole notation; nothing is chosen silently.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from symcheck.reading import tex
from symcheck.reading.complex_letters import complexes
from symcheck.reading.evidence import Evidence, gathered, spelling
from symcheck.reading.faces import ACCENT, STYLED
from symcheck.reading.guesses import COMPLEX, CONSTANT, Guess, in_doubt, options, variable_name
from symcheck.reading.names import KINDS_OPEN, MANY_READINGS
from symcheck.reading.notation import Letter, Notation, is_value
from symcheck.reading.occurrences import Occurrence, occurrences
from symcheck.reading.relatives import Relatives, relatives
from symcheck.reading.sides import equated, without_dots

SIZES = (3, 2)  # of vectors and matrices whose size nothing tells: what holds of both hardly fails of others
_MEMBER = re.compile(r"(\\?[A-Za-z]+)_\{?\w\}?")  # a plain letter with one index
MAX_READINGS = 8  # of one question: three letters with two readings each; more are refused


@dataclass(frozen=True)
class Inference:
    """One reading of a set of formulas: what each letter is taken for, and what was chosen.

    Parameters
    ----------
    guesses
        One for each letter, in order of appearance.
    habits
        What the signs mean that have several meanings, by the names that a notation has for them.
    choices
        What distinguishes this reading from the others; nothing if it is the only one.
    facts
        What is so of the letters in this reading, in LaTeX.
    remote
        Whether hardly anybody would read it so: then it can raise a doubt, and a proof in another reading stands.
    beside
        Whether it is one beside another reading alone, which it can contradict.
    """

    guesses: tuple[Guess, ...]
    habits: tuple[tuple[str, str], ...] = ()
    choices: tuple[str, ...] = ()
    facts: tuple[str, ...] = ()
    remote: bool = False
    beside: bool = False

    @cached_property
    def notation(self) -> Notation:
        """All letters; made when it is asked for, because most readings are never tried."""
        return notation_of(self.guesses, **dict(self.habits))


HABITS = {  # what a sign may mean of which a formula itself does not say which, by what shows that it stands there
    "log": (re.compile(r"\\log(?![a-zA-Z])(?!\s*_)"), ("e", "10")),
    "inverse": (re.compile(r"\\(?:sin|cos|tan|sinh|cosh|tanh)\s*\^\s*\{\s*-\s*1\s*\}"), ("function", "power")),
}


def inferred(
    formulas: Sequence[str],
    said: Mapping[str, str],
    defined: Mapping[str, tuple[str, ...]],
    sizes: Sequence[int] = SIZES,
) -> list[Inference]:
    r"""All readings of formulas that share their letters.

    Parameters
    ----------
    formulas
        Printed LaTeX.
    said
        Phrases about letters: "scalar", "constant", "vector", "constant vector", "vector that depends on t", "matrix",
        "function of x, y", "depends on t", "integer", "index", "differential", "imaginary unit",
        "identity matrix", "skew matrix of \omega", "real^3", "real^{m \times n}", "SO(3)".
    defined
        Letters that an equation defines, with the letters of which they are functions there: ("x", "y") where it is
        printed as f(x, y) = ..., nothing where it is f = ....
    sizes
        Of vectors and matrices whose size nothing tells.

    Returns
    -------
    list of Inference
        At least one.

    Raises
    ------
    SymcheckError
        If a phrase is not understood, or there are too many readings.
    """
    formulas = [*map(tex.spaced, formulas)]
    evidence = gathered(formulas, said)
    for name in _depended_on(said.values()):
        evidence.setdefault(name, Evidence(name, [Occurrence(name)]))
    open_ = {key: each for key, each in evidence.items() if not each.said and key not in defined and _is_plain(each)}
    free = {key for key, each in open_.items() if not (each.dotted or each.derived)}
    bold = {key for key in evidence if key in defined and not defined[key] and STYLED.match(key)}
    told = {key: size for key, each in evidence.items() if not defined.get(key) and (size := _size_said(each))}
    solved = bold | (told.keys() & defined.keys())
    related = relatives(evidence.keys(), free, open_.keys() | bold, solved, formulas, told)
    for name in related.entries:
        evidence.setdefault(name, Evidence(name, [Occurrence(name)]))
    loose = [
        each
        for plain in _inferred(formulas, evidence, defined, related.entries)
        for each in _complexed(plain, formulas)
    ]
    loose = [crossed for each in loose for crossed in _crossed(each, evidence, formulas)]
    if not related:
        return _sized(loose, sizes)
    found = [
        *(
            replace(reading, choices=(*reading.choices, *by.told(related.others)))
            for by in related.readings
            for each in _moved(loose, by)
            for reading in (_related(each, by, defined),)
        ),
        *(replace(each, remote=True) for each in loose),
    ]
    return _sized(found, sizes)


def _depended_on(phrases: Iterable[str]) -> Iterator[str]:
    """The letters on which others are said to depend, printed or not."""
    for phrase in phrases:
        if found := re.search(r"(?:function of|depends on) (.+)", phrase):
            yield from filter(tex.is_letter, found[1].split(", "))


def _is_plain(of: Evidence) -> bool:
    applied = bool(of.arguments) and not of.bare
    return not (of.index or of.whole or applied or of.indices > 0)


def _size_said(of: Evidence) -> tuple[int, ...]:
    """The size that is said of a vector or matrix at rest, 0 for what is left open; () for other letters."""
    if of.dotted or of.derived:
        return ()
    if found := re.fullmatch(r"real (\d+)(?: (\d+))?", of.said):
        return tuple(int(n) for n in found.groups() if n)
    sizes = {"vector": (0,), "matrix": (0, 0), "rotation": (3, 3)}
    return sizes.get(of.said.removeprefix("constant "), ())


def _moved(loose: Sequence[Inference], by: Relatives) -> Sequence[Inference]:
    """The readings in which no length that is differentiated is constant, if there are such."""
    found = [r for r in loose if not any(g.letter.latex in by.lengths and g.taken == CONSTANT for g in r.guesses)]
    return found or loose


def _related(inference: Inference, by: Relatives, defined: Collection[str]) -> Inference:
    """The reading in which plain letters are components and lengths of bold ones."""
    guesses = []
    on = {g.letter.latex: g.letter.depends for g in inference.guesses if g.letter.depends}
    moving = {bold: on[plain] for plain, bold in by.lengths.items() if plain in on and bold not in defined}
    for guess in inference.guesses:
        latex = guess.letter.latex
        if latex in by.components and not guess.letter.indices:
            letter = replace(guess.letter, components=by.components[latex], size=())
            guess = Guess(letter, f"{guess.taken} with the components {by.components[latex]}", guess.why)
        elif latex in by.lengths:
            depends = on.get(by.lengths[latex]) or guess.letter.depends
            letter = replace(guess.letter, depends=depends, named=bool(depends))
            guess = Guess(letter, f"the length of {by.lengths[latex]}", "the same letter stands in bold type")
        elif latex in by.units:
            guess = Guess(guess.letter, "a vector of length 1", "it is bold with a hat")
        elif latex in moving and not guess.letter.depends:
            guess = replace(guess, letter=replace(guess.letter, depends=moving[latex]))
        guesses.append(guess)
    remote = inference.remote and (
        any(guess.remote for guess in guesses) or not any(guess.remote for guess in inference.guesses)
    )
    return replace(inference, guesses=tuple(guesses), facts=by.facts, remote=remote)


def _complexed(inference: Inference, formulas: Sequence[str]) -> Iterator[Inference]:
    """The readings with complex letters, and without where they may be real ones; a remote one raises doubts."""
    guesses = inference.guesses
    letters = [g.letter.latex for g in guesses if g.letter.kind == "scalar" and _is_one_number(g.letter)]
    said = [g.letter.latex for g in guesses if g.taken == COMPLEX]
    units = [g.letter.latex for g in guesses if g.letter.number == "i"]
    found = complexes(formulas, letters, said, units)
    if not found.certain and not found.possible:
        yield inference
        return
    if not units:
        guesses = (*guesses, Guess(Letter(UNIT, number="i"), "the imaginary unit", "complex numbers have one"))
    likely = _with_parts(inference, guesses, found.certain, found.conjugates)
    open_ = dict.fromkeys(found.possible, "its conjugate stands beside it")
    if not found.possible:
        yield likely
        if not units and not said:
            yield replace(inference, choices=(*inference.choices, "all numbers are real"), remote=True)
        return
    yield likely if found.certain else replace(inference, choices=(*inference.choices, "all numbers are real"))
    other = _with_parts(inference, guesses, {**found.certain, **open_}, found.conjugates)
    yield replace(other, remote=True)


UNIT = r"\text{i}"
_CROSS = re.compile(r"(?<![\d}])\s*\\times(?!\s*\d)|\}\s*\\times(?!\s*\d)")  # not beside a printed number
_TWICE = re.compile(r"\(([^()]*\\times[^()]*)\)")  # a cross within another one
# what shows that brackets hold a number
_SCALAR = re.compile(r"[(|\[]|\\(?:frac|cdot|sqrt)|\d")


def _crossed(inference: Inference, evidence: Mapping[str, Evidence], formulas: Sequence[str]) -> Iterator[Inference]:
    r"""The readings of a cross between letters that are not bold: a product of vectors, or of numbers."""
    plain = {
        key
        for key, guess in zip(evidence, inference.guesses, strict=False)
        if guess.letter.kind == "scalar" and _may_be_vector(guess.letter) and not evidence[key].said
    }
    sizes = {spelling(p) for f in formulas for found in _SIZE.finditer(f) for p in occurrences(found[1])}
    crossed = {key for key in plain - sizes if evidence[key].crossed and not evidence[key].factor}
    if not crossed or not any(map(_CROSS.search, formulas)):
        yield inference
        return
    for letter, other in equated([*map(without_dots, formulas)]):
        if letter in plain and r"\times" in other and not _SCALAR.search(_TWICE.sub(r"\1", other)):
            crossed.add(letter)  # it is equal to a cross
    while more := {x for key in crossed for p in evidence[key].places for x in p.beside if x in plain} - crossed:
        crossed |= more
    spelled = {evidence[key].spelling for key in crossed}
    guesses = tuple(
        Guess(replace(g.letter, kind="vector"), "a vector", "a cross stands beside it")
        if g.letter.latex in spelled
        else g
        for g in inference.guesses
    )
    yield replace(inference, guesses=guesses, choices=(*inference.choices, VECTORS))
    accented = any(map(ACCENT.match, spelled))
    yield replace(inference, choices=(*inference.choices, NUMBERS), remote=inference.remote or accented)


_SIZE = re.compile(r"\^\s*\{((?:[^{}]|\{[^{}]*\})*\\times(?:[^{}]|\{[^{}]*\})*)\}")  # rows and columns
VECTORS, NUMBERS = "a cross between vectors", "a cross between numbers"


def _may_be_vector(letter: Letter) -> bool:
    return not (letter.indices or letter.components or letter.number or letter.integer or letter.value is not None)


def _is_one_number(letter: Letter) -> bool:
    free = not letter.depends or letter.named
    return free and not (letter.indices or letter.components or letter.number or letter.integer)


def _with_parts(
    inference: Inference, guesses: Sequence[Guess], why: Mapping[str, str], conjugates: Mapping[str, str]
) -> Inference:
    """The reading in which some letters are complex, with letters for their parts, and others their conjugates."""
    unit = next(g.letter.latex for g in guesses if g.letter.number == "i")
    changed: list[Guess] = []
    for guess in guesses:
        latex, letter = guess.letter.latex, guess.letter
        own = conjugates.get(latex, latex)
        if own not in why:
            changed.append(guess)
            continue
        parts = [f"{own} ^ {{ \\{part} }}" for part in ("Re", "Im")]
        sign, taken = ("+", COMPLEX) if own == latex else ("-", f"the conjugate of {own}")
        components = f"{parts[0]} {sign} {unit} {parts[1]}"
        whole = replace(letter, components=components, named=False)
        changed.append(Guess(whole, taken, why[own]))
        if own == latex:
            varies = any(g.letter.varies for g in guesses if conjugates.get(g.letter.latex, g.letter.latex) == own)
            names = [
                replace(letter, varies=varies, latex=part, whole=True, name=f"{variable_name(own)}_{end}")
                for part, end in zip(parts, ("re", "im"), strict=True)
            ]
            changed += [Guess(each, "a real number", f"a part of {own}") for each in names]
    told = f"{', '.join(why)}: complex"
    return replace(inference, guesses=tuple(changed), choices=(*inference.choices, told))


def _sized(inferences: list[Inference], sizes: Sequence[int]) -> list[Inference]:
    """The same with vectors and matrices of each of the sizes, where nothing says how many components they have."""
    guesses = {id(guess): guess for inference in inferences for guess in inference.guesses}  # readings share them
    unsized = {key for key, guess in guesses.items() if _unsized(guess)}
    if not unsized:
        return inferences
    found = list[Inference]()
    for size in sizes:
        made = {key: _of_size(guess, size) if key in unsized else guess for key, guess in guesses.items()}
        for inference in inferences:
            own = [id(guess) for guess in inference.guesses]
            if not unsized.isdisjoint(own):
                choices = (*inference.choices, told_size(size))
                found.append(replace(inference, guesses=tuple([made[key] for key in own]), choices=choices))
            elif size == sizes[0]:
                found.append(inference)
    return found


def told_size(size: int) -> str:
    """What is said of a reading whose vectors and matrices are taken to have so many components and rows."""
    return f"vectors and matrices of {size} components and rows"


def _unsized(guess: Guess) -> bool:
    letter = guess.letter
    if letter.kind == "function":
        return 0 in letter.size
    return letter.kind in ("vector", "matrix") and not letter.size and letter.components is None and not letter.skew


def _of_size(guess: Guess, size: int) -> Guess:
    sizes = (size,) if guess.letter.kind == "vector" or len(guess.letter.size) == 1 else (size, size)
    return replace(guess, letter=replace(guess.letter, size=sizes), taken=f"{guess.taken} of {size}")


def _inferred(
    formulas: Sequence[str],
    evidence: Mapping[str, Evidence],
    defined: Mapping[str, tuple[str, ...]],
    entries: Collection[str],
) -> list[Inference]:
    """All readings by the options of each letter; entries of vectors and matrices are numbers."""
    every = [options(each, evidence, defined) for each in evidence.values()]
    for k, each in enumerate(every):
        if each[0].letter.latex in entries:
            every[k] = [guess for guess in each if guess.letter.kind == "scalar"] or each
    habits = [
        [(name, value) for value in values]
        for name, (pattern, values) in HABITS.items()
        if any(map(pattern.search, formulas))
    ]
    families = dict[object, list[int]]()  # letters that are alike in all readings, as F_1, F_2 and F_3 are
    for k, each in enumerate(every):
        families.setdefault(_family(each) or k, []).append(k)
    members = [*families.values()]
    count = math.prod([*(len(every[ks[0]]) for ks in members), *map(len, habits)])
    if count > MAX_READINGS:
        several = ", ".join([o[0].letter.latex for o in every if len(o) > 1] + [h[0][0] for h in habits])
        kinds = not habits and all(
            g.letter.kind in ("vector", "matrix") for o in every for g in o[1:] + o[: len(o) > 1]
        )
        why = KINDS_OPEN if kinds else f"{count} {MANY_READINGS}"
        doubt = f"{why}; say what these are: {several}"
        chosen = tuple(in_doubt(o[0], doubt) if len(o) > 1 and not o[0].letter.doubt else o[0] for o in every)
        return [Inference(chosen, tuple(h[0] for h in habits), (doubt,))]
    found = []
    for places in itertools.product(*(range(len(every[ks[0]])) for ks in members)):
        place = {k: n for ks, n in zip(members, places, strict=True) for k in ks}
        chosen = tuple(each[place[k]] for k, each in enumerate(every))
        choices = tuple(f"{g.letter.latex}: {g.taken}" for g, each in zip(chosen, every, strict=True) if len(each) > 1)
        for meaning in itertools.product(*habits):
            told = (*choices, *(f"{name}={value}" for name, value in meaning))
            remote, beside = any(guess.remote for guess in chosen), any(guess.beside for guess in chosen)
            found.append(Inference(chosen, meaning, told, remote=remote or beside, beside=beside and not remote))
    return found


def _family(each: Sequence[Guess]) -> object:
    """What the letters of a family have in common that differ in an index alone; nothing where nothing is open."""
    found = _MEMBER.fullmatch(each[0].letter.latex) if len(each) > 1 else None
    return (found[1], *((g.taken, g.why, g.remote) for g in each)) if found else None


def notation_of(guesses: Iterable[Guess], **habits: Any) -> Notation:
    """The notation of these letters; no two are lowered to one variable."""
    taken: set[str] = set()
    found = []
    for guess in guesses:
        letter = guess.letter
        if letter.kind not in ("index", "differential") and not letter.number:
            stem = f"x_{letter.stem}" if is_value(f"{letter.stem}v1") else letter.stem  # log_x is a logarithm
            names = (f"{stem}{'' if n == 0 else f'v{n}'}" for n in itertools.count())
            letter = next(
                new
                for name in names
                for new in [letter if letter.name == name else replace(letter, name=name)]
                if not any(x in taken or is_value(x) for x, _ in new.instances)
            )
            taken |= {x for x, _ in letter.instances}
        found.append(letter)
    return Notation(found, inferred=True, **habits)
