"""What the letters of formulas mean where nobody has declared them: inferred from what is done with them, and why.

Where two readings are possible there are several inferences, each a whole notation; nothing is chosen silently.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.complex_letters import complexes, equated
from symcheck.reading.lexer import CLOSE, OPEN
from symcheck.reading.names import INDEX_IN_NAME, KINDS_OPEN, is_letter, names_of_several_tokens
from symcheck.reading.notation import SAID, VALUE, Letter, Notation, instances
from symcheck.reading.occurrences import Occurrence, occurrences, words
from symcheck.reading.relatives import Relatives, relatives

SIZES = (3, 2)  # of vectors and matrices whose size nothing tells: what holds of both hardly fails of others
MAX_READINGS = 8  # of one question: three letters with two readings each; more are refused
_STYLED = re.compile(r"(?:\\\w+\{)?\\(mathbf|boldsymbol|bm|pmb|vec|overrightarrow)\{")  # a style, or an accent over it
_MASSES = frozenset({"m", "M", r"\rho", "}"})  # before the g of gravity
_ARGUMENTS = frozenset({"t", r"\tau", "s", "n", "k", "x", "z"})  # what functions of one letter are mostly applied to
_TYPICAL = frozenset("fghFGH") | {r"\zeta", r"\phi", r"\psi", r"\varphi", r"\Phi", r"\Psi", r"\Theta", r"\Gamma"}
# what e is in formulas of orbits: "1 - e^2", "1 + e", "e \cos"
_ECCENTRIC = re.compile(
    r"1\s*[-+]\s*e\s*(?:\^\s*\{?\s*2\s*\}?)?(?!\s*\^|\d)|(?<![A-Za-z\\])e\s*\\(?:cos|sin|cosh|sinh)(?![A-Za-z])"
)
_NUMBER = re.compile(r"\s*[-+]?\s*[\d.\s]+")  # a decimal number, with spaces between its tokens
_SKEW = re.compile(r"\[ (.+) \] _ (?:\{ )?\\times(?: \})?")  # `[a]_\times`, by its tokens


# The letter itself, behind the two groups of scripts at its left; what follows it are scripts at its right.
_CAPITAL_IN_FRAME = re.compile(r"\\prescript \{[^{}]*(?:\{[^{}]*\}[^{}]*)*\} \{[^{}]*\} \{ (?:\\\w+ \{ )*[A-Z]")


@dataclass(frozen=True, slots=True)
class Guess:
    """What one letter is taken for.

    Parameters
    ----------
    letter
        Its declaration.
    taken
        What that means, in words.
    why
        The evidence.
    remote
        Whether hardly anybody would mean this where the other possibility makes sense.
    """

    letter: Letter
    taken: str
    why: str
    remote: bool = False


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
    """

    guesses: tuple[Guess, ...]
    habits: tuple[tuple[str, str], ...] = ()
    choices: tuple[str, ...] = ()
    facts: tuple[str, ...] = ()
    remote: bool = False

    @cached_property
    def notation(self) -> Notation:
        """All letters; made when it is asked for, because most readings are never tried."""
        return _notation(self.guesses, **dict(self.habits))


@dataclass(slots=True)
class Evidence:
    """All places of one letter, and what is said of it."""

    spelling: str
    places: list[Occurrence] = field(default_factory=list)
    indices: int = 0
    values: set[int] = field(default_factory=set)
    said: str = ""
    index: bool = False
    whole: bool = False
    doubt: str = ""
    running: bool = False
    orbital: bool = False
    below: bool = False  # does it stand in a subscript anywhere?
    endless: bool = False  # does an infinite sum, or a factorial, stand beside it?
    shape: tuple[int, ...] = ()  # of the matrix or the column to which it is equal

    @property
    def transposed(self) -> bool:
        """Does it stand with a T above, or with another sign of the transposed?"""
        return any(place.transposed for place in self.places)

    @property
    def capital(self) -> bool:
        """Is it bold, without an arrow, and capital?"""
        return _is_styled(self.spelling, capital=True) and r"\vec" not in self.spelling

    @property
    def multiplied(self) -> bool:
        """Is it capital, and does a bold letter that is not follow without a sign: is it a matrix for certain?"""
        return self.capital and any(place.followed for place in self.places)

    @property
    def idle(self) -> bool:
        """Would all brackets behind it be idle if they were factors?"""
        return all(map(_is_product, self.arguments)) and not any(place.powered for place in self.places)

    @property
    def framed(self) -> str:
        """Is it a vector, or a matrix, because a frame stands at its left?"""
        if not self.whole or not self.spelling.startswith(r"\prescript"):
            return ""
        return "matrix" if _CAPITAL_IN_FRAME.match(self.spelling) else "vector"

    @property
    def dotted(self) -> bool:
        return any(place.dots for place in self.places)

    @property
    def arguments(self) -> list[tuple[str, ...]]:
        return [place.arguments for place in self.places if place.arguments is not None]

    @property
    def bare(self) -> bool:
        """Does it stand anywhere without brackets behind it?"""
        return any(place.arguments is None and place.role != "subscript" for place in self.places)

    @property
    def by(self) -> list[str]:
        """The letters by which it, or something in which it stands, is differentiated."""
        return list(dict.fromkeys(x for place in self.places for x in place.by))


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
        Phrases about letters: "scalar", "constant", "vector", "matrix", "function of x, y", "depends on t", "integer",
        "index", "differential", "imaginary unit", "skew matrix of \omega", "real^3", "real^{m \times n}", "SO(3)".
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
    evidence = gathered(formulas, said)
    _complete(evidence)
    open_ = {key: each for key, each in evidence.items() if not each.said and key not in defined and _is_plain(each)}
    free = {key for key, each in open_.items() if not (each.dotted or _is_derived(each))}
    bold = {key for key in evidence if key in defined and not defined[key] and _STYLED.match(key)}
    related = relatives(evidence.keys(), free, open_.keys() | bold, bold)
    for name in related.entries:
        evidence.setdefault(name, Evidence(name, [Occurrence(name)]))
    loose = [each for plain in _inferred(formulas, evidence, defined) for each in _complexed(plain, formulas)]
    loose = [crossed for each in loose for crossed in _crossed(each, evidence, formulas)]
    if not related:
        return [each for size in sizes for each in _sized(loose, size, first=size == sizes[0])]
    found = [
        *(_related(each, related, defined) for each in _moved(loose, related)),
        *(replace(each, remote=True) for each in loose),
    ]
    return [each for size in sizes for each in _sized(found, size, first=size == sizes[0])]


def _is_plain(of: Evidence) -> bool:
    applied = bool(of.arguments) and not of.bare
    return not (of.index or of.whole or applied or of.indices > 0)


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
        if latex in by.components:
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


COMPLEX = "a complex number"
UNIT = r"\text{i}"


_CROSS = re.compile(r"(?<![\d}])\s*\\times(?!\s*\d)|\}\s*\\times(?!\s*\d)")  # not beside a printed number


# what shows that brackets hold a number
_SCALAR = re.compile(r"[(|\[]|\\(?:frac|cdot|sqrt)|\d")


def _crossed(inference: Inference, evidence: Mapping[str, Evidence], formulas: Sequence[str]) -> Iterator[Inference]:
    r"""The readings of a cross between letters that are not bold: a product of vectors, or of numbers."""
    plain = {
        key
        for key, guess in zip(evidence, inference.guesses, strict=False)
        if guess.letter.kind == "scalar" and _may_be_vector(guess.letter) and not evidence[key].said
    }
    crossed = {key for key in plain if any(r"\times" in (p.before, p.after) for p in evidence[key].places)}
    if not crossed or not any(map(_CROSS.search, formulas)):
        yield inference
        return
    for letter, other in equated(formulas):
        if letter in plain and r"\times" in other and not _SCALAR.search(other):
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
    accented = any(map(_ACCENT.match, spelled))
    yield replace(inference, choices=(*inference.choices, NUMBERS), remote=inference.remote or accented)


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
                replace(letter, varies=varies, latex=part, whole=True, name=f"{_plain(own)}_{end}")
                for part, end in zip(parts, ("re", "im"), strict=True)
            ]
            changed += [Guess(each, "a real number", f"a part of {own}") for each in names]
    told = f"{', '.join(why)}: complex"
    return replace(inference, guesses=tuple(changed), choices=(*inference.choices, told))


def _sized(inferences: Iterable[Inference], size: int, *, first: bool) -> Iterator[Inference]:
    """The same with vectors and matrices of so many components, where nothing says how many they have."""
    for inference in inferences:
        guesses = [_of_size(guess, size) for guess in inference.guesses]
        if any(map(_unsized, inference.guesses)):
            told = f"vectors and matrices of {size} components and rows"
            yield replace(inference, guesses=tuple(guesses), choices=(*inference.choices, told))
        elif first:
            yield inference


def _unsized(guess: Guess) -> bool:
    letter = guess.letter
    if letter.kind == "function":
        return 0 in letter.size
    return letter.kind in ("vector", "matrix") and not letter.size and letter.components is None and not letter.skew


def _of_size(guess: Guess, size: int) -> Guess:
    if not _unsized(guess):
        return guess
    sizes = (size,) if guess.letter.kind == "vector" or len(guess.letter.size) == 1 else (size, size)
    return replace(guess, letter=replace(guess.letter, size=sizes), taken=f"{guess.taken} of {size}")


def _inferred(
    formulas: Sequence[str], evidence: Mapping[str, Evidence], defined: Mapping[str, tuple[str, ...]]
) -> list[Inference]:
    """All readings by the options of each letter."""
    options = [_opened(each, [*_options(each, evidence, defined)]) for each in evidence.values()]
    habits = [
        [(name, value) for value in values]
        for name, (pattern, values) in HABITS.items()
        if any(map(pattern.search, formulas))
    ]
    count = 1
    for size in (*map(len, options), *map(len, habits)):
        count *= size
    if count > MAX_READINGS:
        several = ", ".join([o[0].letter.latex for o in options if len(o) > 1] + [h[0][0] for h in habits])
        kinds = not habits and all(
            g.letter.kind in ("vector", "matrix") for o in options for g in o[1:] + o[: len(o) > 1]
        )
        why = KINDS_OPEN if kinds else f"{count} readings are possible"
        doubt = f"{why}; say what these are: {several}"
        chosen = tuple(_in_doubt(o[0], doubt) if len(o) > 1 else o[0] for o in options)
        return [Inference(chosen, tuple(h[0] for h in habits), (doubt,))]
    found = []
    for chosen in itertools.product(*options):
        choices = tuple(
            f"{g.letter.latex}: {g.taken}" for g, each in zip(chosen, options, strict=True) if len(each) > 1
        )
        for meaning in itertools.product(*habits):
            told = (*choices, *(f"{name}={value}" for name, value in meaning))
            found.append(Inference(chosen, meaning, told, remote=any(guess.remote for guess in chosen)))
    return found


def _opened(of: Evidence, options: list[Guess]) -> list[Guess]:
    """The same, each letter marked if it may be a function of what stands in brackets behind it, or a factor."""
    letters = [guess.letter for guess in options if not guess.remote]
    applied = all(each.kind == "function" or each.depends for each in letters)
    unclear = [place for place in of.places if place.arguments is not None and not _multiplies(of, place)]
    if of.said or applied or not unclear:
        return options
    sums = all(map(_is_sum, (place.arguments or () for place in unclear)))
    named = letters[0].latex[:1] in ("m", "M") or not is_letter(letters[0].latex)  # masses are no functions
    if sums and (letters[0].kind == "matrix" or (letters[0].kind == "scalar" and named)):
        return options
    return [replace(guess, letter=replace(guess.letter, open=True)) for guess in options]


def _multiplies(of: Evidence, place: Occurrence) -> bool:
    """Is it a factor for certain: a power with a letter and a number, or before brackets in which it stands itself?"""
    power = place.superscript or ()
    raised = any(map(str.isdigit, power)) and any(map(str.isalpha, power))
    return raised or any(of.spelling in arg.split() for arg in place.arguments or ())


def _is_sum(args: Sequence[str]) -> bool:
    """Is this one sum, or a cross, that does not begin with a usual argument: hardly what a function is applied to?"""
    toks = args[0].split() if len(args) == 1 else []
    return bool({"+", "-", r"\times"} & {*toks[1:]}) and toks[0] not in _ARGUMENTS


def _in_doubt(guess: Guess, doubt: str) -> Guess:
    return replace(guess, letter=replace(guess.letter, doubt=doubt))


def gathered(formulas: Sequence[str], said: Mapping[str, str]) -> dict[str, Evidence]:
    """All letters with their places; those below a sum and those said to be are indices."""
    wholes = names_of_several_tokens(formulas, said)
    places = [place for formula in formulas for place in _paired(occurrences(formula, [*wholes]))]
    summed = {place.word for place in places if place.role == "index"}
    index = summed.copy()
    index |= {canonical(latex) for latex, phrase in said.items() if phrase == "index"}
    ends = {place.word: place.arguments for place in places if place.role == "index" and place.arguments}
    below = {word for place in places if place.role == "subscript" for word in (place.word, *words(place.subscript))}
    for letter, low, high in _ranges(formulas):
        if letter in below and letter not in said:
            index.add(letter)
            ends.setdefault(letter, (low, high))
    families = {p.word for p in places if p.subscript is not None and index.intersection(words(p.subscript))}
    phrases = {latex if latex in wholes else canonical(latex): phrase for latex, phrase in said.items()}
    shapes = {letter: shape for letter, other in equated(formulas) if (shape := _shape(other))}
    found: dict[str, Evidence] = {}
    initials = _initials(formulas) | _forms(formulas)
    for place in places:
        if place.role == "subscript":
            continue
        tokens, latex = words(place.subscript), place.word
        family = place.word in families and bool(tokens) and all(t in index or t.isdigit() for t in tokens)
        family = family and not _is_mixed(place.subscript or ())
        if tokens and not family:
            latex += tex.subscript([tex.Tok(text, 0) for text in place.subscript or ()])
        key = f"{latex} {len(tokens)}" if family else latex
        own = found.setdefault(key, Evidence(latex, indices=len(tokens) if family else 0))
        own.places.append(place)
        own.values |= {int(t) for t in tokens if t.isdigit()} if family else set()
        own.said = phrases.get(latex, "")
        own.index = latex in index and not tokens
        own.whole, own.doubt = latex in wholes, wholes.get(latex, "") or initials.get(place.word, "")
        if tokens and not family and (inside := summed.intersection(tokens)):
            own.doubt = own.doubt or f"{INDEX_IN_NAME}: {min(inside)}"
        own.shape = shapes.get(latex, ())
        own.below = latex in below
        own.endless = latex == "e" and any(r"\infty" in formula or "!" in formula for formula in formulas)
        own.orbital = latex == "e" and any(map(_ECCENTRIC.search, formulas))
        for low, high in (ends.get(t, ("", "")) for t in tokens) if family else ():
            low, high = (phrases.get(end, "").removeprefix("the number ") or end for end in (low, high))
            if low.isdigit() and high.isdigit():
                own.values |= {int(low), int(high)}
            elif high:
                own.running = True
    return found


def _is_mixed(subscript: Sequence[str]) -> bool:
    """Do commas part this subscript into indices of which one has several letters: `i1,3`?"""
    parts = [part.split() for part in " ".join(subscript).split(",")]
    return len(parts) > 1 and any(len(part) > 1 and not all(map(str.isdigit, part)) for part in parts)


# capitals that an equation begins with, which may be one name, and its subscript
_INITIALS = re.compile(r"\s*([A-Z](?:\s*[A-Z])+)\s*(?:_\s*(?:\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|\w)\s*)?=")
# three capitals or more behind the sign
_CAPITALS = re.compile(r"=\s*([A-Z](?:\s*[A-Z]){2,})(?!\s*[\^_'(A-Z])")


def _initials(formulas: Sequence[str]) -> dict[str, str]:
    """Capitals alone before an equality sign that occur nowhere else: one name rather than a product."""
    toks = [tok.text for formula in formulas for tok in tex.tokenize(formula)]
    bare = [text for text, after in itertools.pairwise([*toks, ""]) if after != "_"]
    found: dict[str, str] = {}
    runs = [match for formula in formulas for match in _CAPITALS.finditer(formula)]
    for match in [*filter(None, map(_INITIALS.match, formulas)), *runs]:
        *letters, last = match[1].split()
        once = [bare.count(letter) == 1 for letter in letters] + [(bare.count(last) or toks.count(last)) == 1]
        if all(once) or (len(once) > 2 and any(once)):
            name = "".join([*letters, last])
            told = f"one name {name}, or a product? say what its letters are, or write \\mathrm{{{name}}}"
            found |= dict.fromkeys([*letters, last], told)
    return found


# x'Qx, a quadratic form
_FORM = re.compile(r"(?<![A-Za-z\\])([a-z]) ' (?:[A-Z]|\\mathbf \{ [A-Z] \}) ([a-z])(?![A-Za-z])")


def _forms(formulas: Sequence[str]) -> dict[str, str]:
    """The letters of quadratic forms `x' Q x`, where a prime may transpose."""
    found = {match[1] for formula in formulas for match in _FORM.finditer(formula)}
    return dict.fromkeys(found, "does the prime transpose? write a T for that, or name another letter")


_RANGE = re.compile(
    r"((?:(?:[A-Za-z]|\\[a-z]+)\s*,\s*)*(?:[A-Za-z]|\\[a-z]+))\s*=\s*(\d+)\s*,(?:\s*(?:\d+|\\[lc]?dots)\s*,)*"
    r"\s*(\d+|(?<=dots ,)\s*[A-Za-z](?:\s*[-+]\s*\d+)?|\\[lc]?dots)"
)  # `i, j = 0, 1, \dots, n - 1`: the letters, the first value and the last one


def _ranges(formulas: Sequence[str]) -> Iterator[tuple[str, str, str]]:
    """The letters whose values are listed, with the first and the last."""
    for formula in formulas:
        for found in _RANGE.finditer(formula):
            for letter in found[1].split(","):
                yield letter.strip(), found[2], found[3].strip()


def _complete(evidence: dict[str, Evidence]) -> None:
    """Letters that are meant without being printed: the time, where there are dots, and the d of differentials."""
    if any(each.dotted for each in evidence.values()) and not {"t", r"\tau"} & evidence.keys():
        evidence["t"] = Evidence("t", [Occurrence("t")])
    used = any(
        p.role == "variable" or (p.role == "derived" and p.before == "d") for e in evidence.values() for p in e.places
    )
    if used and "d" not in evidence:
        evidence["d"] = Evidence("d", [Occurrence("d")], said="differential")
    own = evidence.get("d")
    behind = {place.after for place in own.places} if own is not None else set()
    if own is not None and not own.said and (len(behind) > 1 or behind == {"t"}):
        forms = all(p.arguments is None and p.superscript is None and tex.is_letter(p.after) for p in own.places)
        own.said = "differential" if forms and not own.dotted else ""
    for each in [*evidence.values()]:
        if each.whole and not each.said and (skew := _SKEW.fullmatch(each.spelling)):
            each.said = f"skew matrix of {skew[1]}"
        if each.said.startswith("skew matrix of "):
            name = canonical(each.said.removeprefix("skew matrix of "))
            own = evidence.setdefault(name, Evidence(name, [Occurrence(name)]))
            own.said = own.said or "vector"


def _paired(places: Sequence[Occurrence]) -> list[Occurrence]:
    """The same, each with the letters beside it behind a dot or a cross."""
    found = list(places)
    own = [k for k, place in enumerate(places) if place.role != "subscript"]
    for k, m in itertools.pairwise(own):
        if places[k].after in (r"\cdot", r"\times") and places[m].before == places[k].after:
            found[k] = replace(found[k], beside=(*found[k].beside, spelling(places[m])))
            found[m] = replace(found[m], beside=(*found[m].beside, spelling(places[k])))
    return found


def spelling(place: Occurrence) -> str:
    """The spelling of the letter at one place, with its subscript."""
    return place.word + (tex.subscript([tex.Tok(t, 0) for t in place.subscript]) if place.subscript else "")


def canonical(latex: str) -> str:
    """The spelling of a letter as evidence is kept."""
    found = occurrences(latex)
    if not found:
        return latex
    return spelling(found[0])


def _is_before_letter(place: Occurrence) -> bool:
    after = place.after
    return (
        place.subscript is None
        and place.superscript is None
        and (after in ("(", r"\left", r"\bigl") or tex.is_letter(after))
    )


ORDERS = {"O": 0, r"\mathcal{O}": 0, "o": 1, r"\mathcal{o}": 1}  # how far terms are above the printed power


# signs around which brackets are needed where a factor stands before them
_SIGNS = frozenset({"+", "-", "/", "*", r"\pm", r"\mp", r"\times", r"\cdot", r"\sum", r"\int", r"\frac"})


def _options(of: Evidence, every: Mapping[str, Evidence], defined: Mapping[str, tuple[str, ...]]) -> Iterator[Guess]:
    """All that a letter may be."""
    latex, arguments, bare = of.spelling, of.arguments, of.bare
    if of.said:
        yield _as_said(of, every)
        return
    if of.index:
        yield Guess(Letter(latex, kind="index", name=_plain(latex)), "an index", "a sum runs over it")
        return
    if number := _number(of, every):
        yield from number
        return
    listed = bool(arguments) and all(len(args) > 1 for args in arguments)  # a distance
    if latex == "d" and not listed and all(map(_is_before_letter, of.places)):
        sign = Letter(latex, kind="differential")
        yield Guess(sign, "the sign of a differential", "it stands before letters and brackets only")
        yield Guess(_letter(of, depends=""), "a real number", "nothing else is done with it", remote=True)
        return
    if latex in ORDERS and arguments and not bare and latex not in defined:
        told = f"a term of {'a higher' if ORDERS[latex] else 'this'} order"
        yield Guess(_letter(of, kind="function", order=ORDERS[latex]), told, "it stands before brackets only")
        return
    base, _, below = latex.partition("_")
    parts = below.strip("{}")
    if defined.get(base) and parts and set(parts) <= set(defined[base]):
        derived = _letter(of, kind="function", partial=(base, *parts))
        yield Guess(derived, f"the derivative of {base} by {', '.join(parts)}", f"{base} is a function of these")
        return
    variables = defined.get(latex)
    simple = _common_arguments(of)
    applied = bool(arguments) and not bare and (bool(simple) or not _may_be_factor(of))
    if not variables and applied and _face(latex):
        yield from _of_vectors(of, simple)
    elif variables:
        letters = ", ".join(variables)
        yield Guess(_letter(of, kind="function", depends=letters), f"a function of {letters}", "it is defined as one")
    elif applied:
        depends = ", ".join(simple) if simple else None
        yield Guess(_letter(of, kind="function", depends=depends), "a function", "it stands before its arguments only")
    elif arguments and simple and _varies(of):
        kinds = ("matrix", "vector") if of.capital else ("vector",) if _face(latex) else ("scalar",)
        for kind in kinds:
            dependent = _letter(of, kind=kind, depends=", ".join(simple))
            yield Guess(dependent, f"a function of {', '.join(simple)}", "it stands before them")
    elif arguments and not bare and (re.match(r"\\text\{\w\w", latex) or of.idle):
        function = Guess(_letter(of, kind="function"), "a function", "a product needs no brackets there")
        yield _in_doubt(function, FACTOR) if _holds_factors(of) else function
    elif arguments and not bare and not of.dotted and _is_function(of, every):
        yield Guess(_letter(of, kind="function"), "a function", "it stands before arguments, or its derivative does")
    elif arguments and not bare and not of.dotted and not _face(latex):
        yield from _before_sums(of)
    elif bare and not of.dotted and not _is_derived(of) and any(map(_is_lone, of.places)):
        yield Guess(_letter(of, kind="function"), "a function", "it stands before one letter in brackets")
    elif bare and not of.dotted and not _is_derived(of) and any(map(_is_listed, arguments)):
        yield Guess(_letter(of, kind="function"), "a function", "it stands before several arguments")
    elif of.dotted and not of.shape and not of.capital and any(map(_is_lone, of.places)):
        on = _letter(of, kind="function", depends=_time(every), size=(0,) if _face(latex) else ())
        yield Guess(on, f"a function of {on.depends}", "its rate stands beside its value at a place")
    elif of.dotted or _is_derived(of):
        yield from _dependent(of, every, latex in defined)
    elif of.framed:
        kind = of.framed
        yield Guess(_letter(of, kind=kind, depends=""), f"a {kind}", "a frame stands at its left")
    elif of.whole and latex.startswith("["):
        yield Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it stands in brackets")
    elif latex in _IDENTITIES and (size := _matrix_size(every)) is not None:
        own = (size, size) if size else ()
        yield Guess(_letter(of, kind="matrix", size=own, identity=True), "the identity", "it stands beside matrices")
        if latex != r"\mathbf{1}":
            yield Guess(_letter(of, kind="matrix", size=own), "a matrix", "it is capital", remote=True)
    elif (sized := _sized_identity(latex, every)) and _matrix_size(every) is not None:
        own = (int(sized[2]), int(sized[2]))
        yield Guess(_letter(of, kind="matrix", size=own, identity=True), "the identity", "its size is printed with it")
        yield Guess(_letter(of, kind="matrix"), "a matrix", "it is capital", remote=latex[0] == "\\")
        if latex[0] != "\\":
            yield Guess(_letter(of, depends=""), "a real number", "nothing else is done with it")
    elif of.shape:
        kind = "matrix" if len(of.shape) > 1 else "vector"
        yield Guess(_letter(of, kind=kind, size=of.shape, depends=""), f"a {kind}", PRINTED)
    elif _face(latex):
        yield from _styled(of)
    elif of.transposed and "T" not in every:
        kind = "matrix" if latex[:1].isupper() else "vector"
        yield Guess(_letter(of, kind=kind, depends=""), f"a {kind}", "it is transposed")
    elif latex.isupper() and not of.indices and any(x.transposed and x.spelling.isalpha() for x in every.values()):
        yield Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it is capital beside what is transposed")
        yield Guess(_letter(of, depends=""), "a real number", "nothing else is done with it")
    elif _beside_vectors(of, every):
        yield Guess(_letter(of, kind="vector", depends=""), "a vector", "it is multiplied by one")
    else:
        yield Guess(_letter(of, depends=""), "a real number", "nothing else is done with it")


FACTOR = "a factor before brackets, or a function? say what it is"
# what stands in brackets as a factor rather than as an argument: one fraction, or a number of several digits
_FACTORS = re.compile(r"\\frac \{ .*\}$|(?:\d ){3}|(?:\d )+\. ")


def _before_sums(of: Evidence) -> Iterator[Guess]:
    """A letter that stands before brackets only, of which some hold sums: a factor, or a function."""
    product = Guess(_letter(of, depends=""), "a number", "it stands before brackets with a sum")
    function = Guess(_letter(of, kind="function"), "a function", "it stands before brackets only")
    crossed = all(r"\times" in args[0].split() for args in of.arguments)  # which needs its brackets
    factor = crossed or all(args[0].lstrip()[:1].isdigit() for args in of.arguments)  # as in a(1 - x)
    constant = of.spelling in ("g", "G") and not any(map(_is_shift, of.arguments))  # of gravity
    weight = constant or (of.spelling == "g" and any(place.before in _MASSES for place in of.places))
    coefficient = factor and of.spelling[:1] == "\\" and of.spelling != r"\zeta"  # as in \phi(1.4 - x)
    typical = of.spelling in _TYPICAL and not weight and not coefficient
    doubtful = _holds_factors(of) and (typical or (len(of.spelling) == 1 and of.spelling.isupper()))
    if doubtful or (of.spelling in _MOVING and all(map(_is_shift_of_time, of.arguments))):
        yield _in_doubt(function, FACTOR)
    else:
        yield from (function, product) if typical else (product, replace(function, remote=factor or constant))


_MOVING = frozenset("uvwxyqp")  # letters of what moves, or how fast


def _is_shift_of_time(args: Sequence[str]) -> bool:
    """Is this the time with something added to it: an argument of a function, or how long something moves?"""
    return args[0].split()[:1] in (["t"], [r"\tau"]) and _is_shift(args)


def _holds_factors(of: Evidence) -> bool:
    """Do all brackets behind a Latin letter hold what may be a factor as well?"""
    latin = of.spelling[:1] != "\\" and of.spelling not in ("f", "F") and not any(p.powered for p in of.places)
    return latin and all(map(_FACTORS.match, (args[0] for args in of.arguments)))


def _is_shift(args: Sequence[str]) -> bool:
    """Is this a usual argument alone, or with something added to it?"""
    toks = args[0].split()
    return toks[:1] != [] and toks[0] in _ARGUMENTS and toks[1:2] in ([], ["+"], ["-"])


def _is_function(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Is a letter that stands before brackets only a function for certain, by its face or by what stands beside it?"""
    if of.spelling.startswith((r"\mathcal", r"\mathscr")) or _is_primed(of):
        return True
    accented = _ACCENT.match(of.spelling)
    plain = every.get(of.spelling[accented.end() : -1]) if accented else None
    others = [each for each in every.values() if each.arguments and not each.bare and each is not of]
    return any(
        (any(map(_is_lone, each.places)) or _is_primed(each))
        and (each is plain or bool(set(each.arguments) & set(of.arguments)))
        for each in others
    )


def _is_primed(of: Evidence) -> bool:
    return any(place.primes and place.arguments for place in of.places)


_SIZED = re.compile(r"(.+)_\{?(\d)\}?")  # a letter with a number below, as I_3
_IDENTITIES = frozenset({"I", r"\mathbf{I}", r"\bm{I}", r"\boldsymbol{I}", r"\mathbb{I}", r"\mathbf{1}"})


def _sized_identity(latex: str, every: Mapping[str, Evidence]) -> re.Match[str] | None:
    """An identity with its size below, such as I_3; beside an I_1 it is one of several."""
    sized = _SIZED.fullmatch(latex)
    if not sized or sized[1] not in _IDENTITIES:
        return None
    several = any(x != latex and (other := _SIZED.fullmatch(x)) and other[1] == sized[1] for x in every)
    return None if several else sized


def _matrix_size(every: Mapping[str, Evidence]) -> int | None:
    """The number of rows of the matrices that are said to be some, or are capital and bold; 0 if it is not said."""
    found = None
    for each in every.values():
        if each.spelling in _IDENTITIES:
            continue
        if match := re.fullmatch(r"real (\d+) (\d+)", each.said):
            return int(match[1])
        if each.said.startswith(("matrix", "skew matrix")):
            return 3
        if _is_styled(each.spelling, capital=True):
            found = 0
    return found


_HAT = re.compile(r"\\(hat|widehat|vec)\{")  # accents of unit vectors and of vectors
_ACCENT = re.compile(r"\\(hat|widehat|vec|bar|overline|tilde)\{")  # accents that make a letter of their own


def _beside_vectors(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Does a dot or a cross stand between it and a vector, or is it the length of something with a hat?"""

    def is_vector(spelling: str) -> bool:
        each = every.get(spelling)
        styled = _is_styled(spelling, capital=False) or spelling.startswith(r"\prescript")
        return each is not None and (
            styled or each.said == "vector" or re.fullmatch(r"real \d+", each.said) is not None
        )

    beside = {x for place in of.places for x in place.beside}
    accented = _HAT.match(of.spelling) is not None
    hats = any(map(_HAT.match, (of.spelling, *beside))) and any(r"\cdot" in (p.before, p.after) for p in of.places)
    if hats and any(map(_ACCENT.match, beside)) and _ACCENT.match(of.spelling):
        return True
    return any(map(is_vector, beside)) or (
        accented and any(p.before in ("|", r"\|") and p.after in ("|", r"\|") for p in of.places)
    )


def _as_said(of: Evidence, every: Mapping[str, Evidence]) -> Guess:
    """A letter of which something is said."""
    phrase, why = of.said, SAID
    if phrase in ("scalar", "constant", "integer"):
        whole = phrase == "integer"
        return Guess(_letter(of, depends="", integer=whole), "a whole number" if whole else "a real number", why)
    if match := re.fullmatch(r"the number (\d+)", phrase):
        return Guess(Letter(of.spelling, value=int(match[1]), name=_plain(of.spelling)), phrase, why)
    if phrase == "complex":
        return Guess(_letter(of, depends=""), COMPLEX, why)
    if phrase == "index":
        return Guess(Letter(of.spelling, kind="index", name=_plain(of.spelling)), "an index", why)
    if phrase == "differential":
        return Guess(Letter(of.spelling, kind="differential"), "the sign of a differential", why)
    if phrase == "imaginary unit":
        return Guess(Letter(of.spelling, number="i"), "the imaginary unit", why)
    depends = _time(every) if of.dotted else ""
    if phrase in ("vector", "matrix"):
        return Guess(_letter(of, kind=phrase, depends=depends), f"a {phrase}", why)
    if match := re.fullmatch(r"(function of|depends on) (.+)", phrase):
        kind = "function" if match[1] == "function of" else "scalar"
        return Guess(_letter(of, kind=kind, depends=match[2]), f"a function of {match[2]}", why)
    if phrase == "rotation":
        return Guess(_letter(of, kind="matrix", depends=depends), "a rotation matrix", why)
    if match := re.fullmatch(r"skew matrix of (.+)", phrase):
        return Guess(_letter(of, kind="matrix", skew=match[1]), f"the skew matrix of {match[1]}", why)
    if match := re.fullmatch(r"real (\d+)(?: (\d+))?", phrase):
        size = tuple(int(n) for n in match.groups() if n)
        kind = "vector" if len(size) == 1 else "matrix"
        return Guess(_letter(of, kind=kind, size=size, depends=depends), f"a {kind}", why)
    raise SymcheckError(
        f"{of.spelling} is said to be {phrase!r}, which is not understood; say scalar, constant, complex, vector, "
        "matrix, integer, index, function of x, depends on t, differential, imaginary unit or skew matrix of a vector"
    )


def _number(of: Evidence, every: Mapping[str, Evidence]) -> list[Guess]:
    """What e, i, j and pi may be."""
    latex = of.spelling
    derived = any(p.role == "derived" and p.before in ("d", r"\partial") and p.superscript is None for p in of.places)
    if latex != r"\pi" and (of.dotted or (of.arguments and _common_arguments(of)) or derived):
        return []  # a number depends on nothing
    if latex == r"\pi":
        return [Guess(Letter(latex, number="pi"), "the number pi", "so it is written")]
    if latex in ("e", r"\text{e}"):
        euler = Guess(Letter(latex, number="e"), "Euler's number", "it is raised to a power")
        letter = Guess(_letter(of, depends="", name="e_letter"), "a real number", "it stands without an exponent")
        powers = [place.superscript for place in of.places]
        variable = [power is not None and not "".join(power).strip("{}").isdigit() for power in powers]
        series = all(power is not None and "".join(power).strip("{}") in every for power in powers) and all(
            every["".join(power or ()).strip("{}")].index for power in powers
        )
        if latex == "e" and powers and series:  # in the powers of a letter
            return [replace(letter, why="a series runs over its powers"), euler]
        if of.orbital and not any(variable):
            return [replace(letter, why="it stands as an eccentricity does"), replace(euler, remote=True)]
        if latex != "e" or all(variable):
            return [euler]
        if any(variable) or of.endless:
            return [euler, replace(letter, remote=any(variable))]
        return [letter, euler]
    if latex in ("i", "j", r"\text{i}", r"\text{j}"):
        if {"i", "j"} <= every.keys() and not any(p.exponent for key in "ij" for p in every[key].places):
            doubt = "a unit of quaternions, an index, or the imaginary unit? say what it is"
            return [Guess(replace(_letter(of, depends=""), doubt=doubt), "a letter in doubt", "i and j stand here")]
        unit = Guess(Letter(latex, number="i"), "the imaginary unit", "so it is written")
        plain = Guess(_letter(of, depends="", name=_plain(latex)), "a real number", "it is a letter like others", True)
        if latex[0] == "\\" or any(place.exponent for place in of.places):
            return [unit]
        if of.below:
            return [replace(plain, why="it is an index elsewhere", remote=False)]
        return [unit, plain]
    return []


def _common_arguments(of: Evidence) -> tuple[str, ...]:
    """The letters that stand in brackets behind it wherever there are any: (x, t)."""
    found = set(of.arguments)
    if len(found) != 1:
        return ()
    (args,) = found
    return args if all(tex.spelled(arg) is not None for arg in args) else ()


def _may_be_factor(of: Evidence) -> bool:
    """Could it be multiplied with what stands in brackets behind it, which is more than a letter or a number?"""
    powered = any(place.powered for place in of.places)
    return all(len(args) == 1 and (powered or not _is_idle(args[0])) for args in of.arguments)


def _is_lone(place: Occurrence) -> bool:
    """Does one letter or number stand in brackets behind it, around which nobody writes them for a product?"""
    if place.primes or place.powered or place.arguments is None or len(place.arguments) != 1:
        return False
    (inside,) = place.arguments
    number = all(tok.isdigit() or tok in (".", "{", "}", r"\frac") for tok in inside.split())
    return bool(inside) and (is_letter(inside) or number)


def _is_listed(args: Sequence[str]) -> bool:
    """Are these several arguments, and no components of a vector or factors of a scalar product?"""
    letters = [bool(arg) and is_letter(arg.removesuffix(" ( t )")) for arg in args]
    plain = all(letter or arg == r"\dots" or _NUMBER.fullmatch(arg) for letter, arg in zip(letters, args, strict=True))
    return len(args) > 1 and plain and any(letters) and not all(_STYLED.match(arg.replace(" ", "")) for arg in args)


def _is_product(args: Sequence[str]) -> bool:
    """Is this one product of several letters and numbers, around which brackets would be idle?"""
    return len(args) == 1 and _is_idle(args[0]) and not is_letter(args[0]) and not _NUMBER.fullmatch(args[0])


def _is_idle(text: str) -> bool:
    """Do no signs stand in it but within other brackets, so that none are needed around it?"""
    depth, bars = 0, False
    for tok in text.split():
        depth += (tok in OPEN or tok == "{") - (tok in CLOSE or tok == "}")
        bars ^= tok in ("|", r"\|")
        if depth == 0 and not bars and tok in _SIGNS:
            return False
    return bool(text)


def _varies(of: Evidence) -> bool:
    defined = any(p.after == "=" and p.arguments is None for p in of.places)  # as in x = x(t)
    return all(place.dots or place.primes or place.arguments is not None for place in of.places) or bool(
        (defined and len(of.arguments) == 1) or of.dotted or any(place.role == "derived" for place in of.places)
    )


def _is_derived(of: Evidence) -> bool:
    return any(place.role == "derived" and of.spelling not in place.by for place in of.places)


def _time(every: Mapping[str, Evidence]) -> str:
    return "t" if "t" in every or r"\tau" not in every else r"\tau"


CONSTANT = "constant"
PRINTED = "it is equal to one that is printed"
# a matrix that contains no other environment, perhaps transposed
_ENTRIES = re.compile(
    r"\s*\\begin\{([pbBv]?matrix|smallmatrix)\}((?:(?!\\begin).)*)\\end\{\1\}(\s*\^\s*\{?\s*T\s*\}?)?\s*[.,;]?\s*",
    re.DOTALL,
)


def _shape(latex: str) -> tuple[int, ...]:
    """The numbers of rows and columns of a printed matrix, or of the components of a column; nothing else has any."""
    if not (found := _ENTRIES.fullmatch(tex.compact(latex))):
        return ()
    rows = [row for row in re.split(r"\\\\(?:\[[^\]]*\])?", found[2]) if row.strip()]
    columns = {row.count("&") + 1 for row in rows}
    if len(columns) != 1:
        return ()
    (size, *_) = sizes = (*columns, len(rows)) if found[3] else (len(rows), *columns)
    return sizes if sizes[1] != 1 else (size,)


MOVING = "it is differentiated"


def _dependent(of: Evidence, every: Mapping[str, Evidence], named: bool) -> Iterator[Guess]:
    """A letter with dots, or one in a derivative."""
    on = [_time(every)] if of.dotted else []
    on += [x for x in of.by if x not in on and x != of.spelling]
    words = ", ".join(on)
    if of.shape:
        kind = "matrix" if len(of.shape) > 1 else "vector"
        yield Guess(_letter(of, kind=kind, depends=words, size=of.shape, named=named), f"a {kind}", PRINTED)
        return
    if of.capital:
        for kind in ("matrix", "vector")[: 1 if of.multiplied else 2]:
            yield Guess(_letter(of, kind=kind, depends=words, named=named), f"a {kind}, a function of {words}", MOVING)
        return
    kind = of.framed or ("vector" if _face(of.spelling) else "scalar")
    primed = any(place.primes for place in of.places)
    direct = (
        of.dotted
        or primed
        or any(place.role == "derived" and place.before in ("d", r"\partial") for place in of.places)
    )
    within = any(x in every and _stands_in_body(every[x]) for x in on)
    varying = Guess(_letter(of, kind=kind, depends=words, named=named), f"a function of {words}", MOVING)
    constant = Guess(
        _letter(of, kind=kind, depends=""), CONSTANT, "it has no dot, and the other letter stands beside it"
    )
    if direct or named:
        yield varying
    elif within:
        yield constant
    elif any(each.dotted for each in every.values()):
        yield constant
        yield replace(varying, remote=True)
    else:
        yield varying
        yield constant


def _stands_in_body(of: Evidence) -> bool:
    return any(place.role == "derived" for place in of.places)


def _face(latex: str) -> str:
    """What is printed in bold type or below an arrow, where a letter, or a name of several tokens, is; else nothing."""
    printed = re.sub(r"^\\(?:Delta|delta)(?=\\)", "", latex.replace(" ", ""))
    found = _STYLED.match(printed)
    return printed[found.end() :] if found else ""


def _is_styled(latex: str, *, capital: bool) -> bool:
    """Is a letter bold or with an arrow, and capital or not?"""
    inner = _face(latex).lstrip("\\")
    return bool(inner) and inner[:1].isupper() == capital


def _of_vectors(of: Evidence, simple: Sequence[str]) -> Iterator[Guess]:
    """A bold letter that stands before its arguments only: a function whose values are vectors or matrices."""
    depends = ", ".join(simple) if simple else None
    kinds = (("matrix", (0, 0)), ("vector", (0,)))
    for kind, size in kinds[:1] if of.multiplied else kinds if of.capital else kinds[1:]:
        told = f"a function whose values are {'matrices' if kind == 'matrix' else 'vectors'}"
        yield Guess(_letter(of, kind="function", depends=depends, size=size), told, "it stands before its arguments")


def _styled(of: Evidence) -> Iterator[Guess]:
    """A bold letter, or one with an arrow."""
    vector = Guess(_letter(of, kind="vector", depends=""), "a vector", "it is bold, or has an arrow")
    matrix = Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it is bold and capital")
    if not of.capital:
        yield vector
        return
    long = any(place.before in ("|", r"\|") and place.after in ("|", r"\|") for place in of.places)
    if of.multiplied:
        yield matrix
    else:
        yield from (vector, matrix) if long and not of.transposed else (matrix, vector)


def _letter(of: Evidence, **given: object) -> Letter:
    values = tuple(range(min(of.values, default=1), max(of.values, default=3) + 1))
    given.setdefault("name", _plain(of.spelling))
    given.setdefault("varies", any(place.before == "d" for place in of.places))
    return Letter(
        of.spelling,
        indices=of.indices,
        range=values,
        whole=of.whole,
        running=of.running,
        doubt=of.doubt,
        **given,  # type: ignore[arg-type]
    )


_SPOKEN = {  # signs in the names of variables
    "-": "minus", "+": "plus", "/": "per", "*": "star", "'": "dash", "=": "is", "<": "below", ">": "above",
}  # fmt: skip


@lru_cache(maxsize=4096)  # the same letters are met in every formula
def _plain(latex: str) -> str:
    for sign, word in _SPOKEN.items():
        latex = latex.replace(sign, f" {word} ")
    name = re.sub(r"[^A-Za-z0-9]+", "_", re.sub(r"\\(mathbf|boldsymbol|bm|text|mathrm)\b", "", latex)).strip("_")
    return name if name[:1].isalpha() else f"x{name}"


def _notation(guesses: Iterable[Guess], **habits: str) -> Notation:
    """The notation of these letters; no two are lowered to one variable."""
    taken: set[str] = set()
    found = []
    for guess in guesses:
        letter = guess.letter
        if letter.kind not in ("index", "differential") and not letter.number:
            names = (f"{letter.stem}{'' if n == 0 else f'v{n}'}" for n in itertools.count())
            letter = next(
                new
                for name in names
                for new in [letter if letter.name == name else replace(letter, name=name)]
                if not any(x in taken or VALUE.fullmatch(x) for x, _ in instances(new))
            )
            taken |= {x for x, _ in instances(letter)}
        found.append(letter)
    return Notation(found, inferred=True, **habits)
