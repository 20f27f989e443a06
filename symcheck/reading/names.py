r"""Names that are printed with several tokens: `x^*`, `x_i^{(k)}`, `f^{F_c}`, `[P]`, `\Delta x`, `{}^A v^B`.

A superscript is a label where it cannot be a power, and a power where its letters stand for numbers elsewhere. Where
neither is certain the name is in doubt: it is read as it is printed, and not lowered.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.commands import ACCENTS, LETTER_COMMANDS, OVER, ROMAN, STYLES, known
from symcheck.reading.faces import face
from symcheck.reading.lexer import CLOSE, OPEN, SIZES, SPACES
from symcheck.reading.occurrences import SIGNED_SUMS, Occurrence, occurrences

# Capitals that name frames and bodies above a letter; T transposes, and the others are often numbers.
FRAMES = frozenset("ABCEFGOPQRSWXY")
BOLD = (r"\mathbf", r"\boldsymbol", r"\bm", r"\pmb", r"\vec")
_DISCOUNTS = frozenset({r"\beta", r"\gamma", r"\delta", r"\rho", r"\lambda", r"\alpha"})  # raised to a number of times
_AXES = frozenset("XYZ")  # of components, which no coefficient is numbered by
_BOLD = frozenset((style,) for style in BOLD)
_SIGNS = frozenset({"*", "+", "-", r"\star", r"\dagger", r"\ddagger", r"\sharp", r"\flat", r"\times"})
_SIGNS |= {r"\perp", r"\parallel", r"\uparrow", r"\downarrow"}
_STATES = frozenset("HSGU")  # enthalpy, entropy, and energies, whose changes have indices
_OF_ORDERS = frozenset("PQLYCTBDJKHFWMZRgh") | {r"\mathcal{P}", r"\text{P}"}  # functions of a degree and an order
_STATES_ABOVE = frozenset("cfghouvw")  # letters of phases and states, of which no exponent is made
_TRANSPOSING = frozenset({"T", "H", r"\top", r"\intercal"})
_ANGLES = frozenset(  # letters with a circle above of which that hardly says a standard state
    {r"\theta", r"\vartheta", r"\phi", r"\varphi", r"\psi", r"\alpha", r"\beta", r"\gamma", r"\delta", r"\lambda", "x"}
)
_BOUNDED = frozenset({r"\sum", r"\prod", r"\int", r"\oint", r"\iint", r"\bigcup", r"\bigcap"})
_NO_BASE = frozenset(
    {"d", r"\partial", r"\Delta", r"\delta", r"\nabla", "e", r"\text{e}", r"\text{d}", r"\pi", "i", r"\text{i}"}
)
DIMENSIONLESS = {  # numbers that print abbreviates with two letters
    "Re": "Reynolds", "Nu": "Nusselt", "De": "Dean", "Fo": "Fourier", "Sc": "Schmidt", "Gr": "Grashof", "We": "Weber",
    "Sh": "Sherwood", "Bo": "Bond", "Bi": "Biot", "Pe": "Peclet", "Ec": "Eckert", "Eu": "Euler", "Kn": "Knudsen",
    "Oh": "Ohnesorge", "Bd": "Bond", "Ja": "Jakob", "Fr": "Froude", "Pr": "Prandtl", "Ca": "capillary", "St": "Stokes",
    "Ra": "Rayleigh", "Ga": "Galilei", "Ar": "Archimedes", "Gz": "Graetz", "Ma": "Mach",
    "SG": "specific-gravity", "MW": "molecular-weight", "Mo": "Morton", "Le": "Lewis", "Ro": "Rossby", "Ta": "Taylor",
    "Ek": "Ekman", "Ri": "Richardson", "Da": "Damköhler", "Ha": "Hartmann", "Wo": "Womersley", "Wi": "Weissenberg",
    "Eo": "Eötvös", "At": "Atwood",
}  # fmt: skip
# Those of them that may be products too: forces times radii, masses times accelerations.
PRODUCTS = frozenset(
    {"Fr", "Pr", "Ca", "St", "Ra", "Ga", "Ar", "Ja", "Gr", "Sh", "Sc", "Ma", "Mo", "Le", "Ro", "Ta", "Da", "Ha", "At"}
)
TRANSPOSED_OR_LABEL = "transposed, or a label? write brackets around what is transposed"
STANDARD = "in degrees, or in the standard state? say what it is"
DEGREES = "degrees of a scale, or a frame? write the unit beside its number"
_EXPECTED = frozenset({"E", r"\mathbb{E}", r"\text{E}"})  # letters of expectations
KINDS_OPEN = "too many of these may be vectors or matrices"
STATES = "a state, of which nothing is calculated"
MANY_READINGS = "readings are possible"
INTEGRATED = "all that is integrated by"
INDEX_IN_NAME = "an index of a name is not summed over"
LABEL_DOUBT = "a power, or a label?"
POWER_OR_LABEL = LABEL_DOUBT + " say what {} is, or write brackets around the base of the power"


def is_expectation(letter: str) -> bool:
    r"""Whether a letter before square brackets is the sign of an expectation, as `\mathbb{E}_{x \sim p}` is."""
    return letter in _EXPECTED or letter.startswith(r"\mathbb{E}_")


@dataclass(frozen=True, slots=True)
class Scripted:
    """A letter with its scripts, as it is printed."""

    latex: str
    bare: str  # without what stands above it
    word: str  # without what stands below it either
    above: tuple[str, ...]
    framed: bool  # does a script stand at its left?
    plain: bool = False  # is it a power for certain unless it is a label for certain?
    applied: bool = False  # do brackets stand behind it that hold no sum?
    changed: bool = False  # does the sign of a change stand before it?
    below: bool = False  # does anything stand below it?
    derived: bool = False  # is it differentiated?


# where names of the other kinds can be
_SQUARE_OR_CHANGE = re.compile(r"\[|\\(?:Delta|delta|nabla)(?![A-Za-z])")
# accents that make one name of several letters
_ACCENT = re.compile("|".join(re.escape(accent) for accent in sorted(ACCENTS - {*tex.DOTTED})))
# names of numbers like Re, Mach and Prandtl
_ABBREVIATED = re.compile("|".join(rf"{word[0]}\s*{word[1]}" for word in sorted(DIMENSIONLESS)))


def names_of_several_tokens(formulas: Sequence[str], said: Mapping[str, str]) -> dict[str, str]:
    """The names in formulas, each with what is in doubt about it: nothing if it is certain.

    `said` are the letters of which something is said; names of several tokens among them are names.
    """
    found = {latex: "" for latex in said if not is_letter(latex)}
    declared = {re.sub(r"[\s{}]", "", latex) for latex in found}
    raised = [formula for formula in formulas if "^" in formula or r"\prescript" in formula]
    summed = [formula for formula in formulas if any(sign in formula for sign in SIGNED_SUMS)]
    indices = [place for formula in summed for place in occurrences(formula) if place.role == "index"]
    bound, loose = {place.word for place in indices}, {p.word for p in indices if not "".join(p.arguments or ())}
    scripted = [each for formula in raised for each in _scripted(formula)]
    told = Told(
        formulas,
        said.keys(),
        {each.word for each in scripted if _is_power(each.above)},
        {each.above for each in scripted if each.applied and each.below and _letters(each.above)},
        loose,
        {each.word for each in scripted if each.above in (("0",), ("1",)) and each.below},
        {word for formula in raised for word in _APPLIED.findall(formula)},
        {each.above[0] for each in scripted if each.word == r"\delta" and each.below and len(each.above) == 1},
        {each.word for each in scripted if "," in each.above and not each.framed},
        {(each.word, "".join(each.above)) for each in scripted if len(each.above) == 1 or each.above[:1] in _BOLD},
    )
    labelled = {
        each.word for each in scripted for text in each.above if text[:1].isupper() and text not in _TRANSPOSING
    }
    for each in scripted:
        if re.sub(r"[\s{}]", "", each.latex) in declared:
            continue
        if each.word not in bound and (doubt := _doubt(each, told, labelled)) is not None:
            found.setdefault(each.latex, doubt)
        elif each.framed:
            found.setdefault(each.bare, DEGREES if each.bare.startswith(r"\prescript { \circ }") else "")
    for formula in formulas:
        if _SQUARE_OR_CHANGE.search(formula):
            product = r"\delta" in formula and _COEFFICIENTS.search(formula) is not None
            changes = [x for x in _matrices_and_differences(formula) if not (product and x.startswith(r"\delta"))]
            found |= {x: _unit(x, formula) for x in changes if re.sub(r"[\s{}]", "", x) not in declared | found.keys()}
        if _ACCENT.search(formula):
            within = " ".join(found)
            found |= {latex: doubt for latex, doubt in _accented(formula) if latex not in within}
        if _ABBREVIATED.search(formula):
            found |= {latex: doubt for latex, doubt in _dimensionless(formula, said).items() if latex not in found}
    found |= {
        latex: STATES
        for formula in formulas
        if r"\rangle" in formula or r"\langle" in formula
        for latex in _states(formula)
    }
    found = {tex.without_dots(latex): doubt for latex, doubt in found.items()} | dict.fromkeys(_values(formulas), "")
    for latex in found:
        if latex.startswith(r"\Delta ") and any(_is_multiplied(latex.split()[1], formula) for formula in formulas):
            found[latex] = found[latex] or "a change, or a factor before a letter? write \\cdot, or say what it is"
        if inside := bound.intersection(latex.split()[1:]):
            found[latex] = found[latex] or f"{INDEX_IN_NAME}: {min(inside)}"
    return found


# a rate at the beginning, or the largest or smallest one
_VALUE = re.compile(
    r"\\d{1,4}ot\s*\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}\s*_\s*(?:0|\{\s*0\s*\}|\{\s*\\text\s*\{\s*m\s*(?:a\s*x|i\s*n)\s*\}\s*\})"
)


_DEFINED = re.compile(r"\s*&?\s*=")  # behind a name that is defined there
_ONE = re.compile("[1-9]")  # at the end of a subscript that is an index


def _values(formulas: Sequence[str]) -> Iterator[str]:
    r"""Values of rates, such as `\dot{x}_0` beside an `x` or an `x_0`: constants, and no rates of an `x_0`."""
    found = [match for formula in formulas for match in _VALUE.finditer(formula)]
    places = [place for formula in formulas if found for place in occurrences(formula)]
    bare = {place.word for place in places if place.subscript is None}
    begins = {p.word for p in places if p.subscript == ("0",) and not p.dots and not face(p.word)}
    begins -= {p.word for p in places if p.dots > 1}
    own = {p.word for p in places if p.subscript and (_ONE.search(p.subscript[-1]) or _is_of_letters(p))}
    defined = {tex.spelled(match[1]) for match in found if _DEFINED.match(match.string, match.end())}
    for match in found:
        if tex.spelled(match[1]) in (bare | (begins - defined)) - own:
            yield " ".join(tex.texts(match[0]))


def _is_of_letters(place: Occurrence) -> bool:
    return any(map(is_letter, place.arguments or ()))


_APPLIED = re.compile(r"(?<![A-Za-z\\])([A-Z]) (?:\\left )?\(")  # capitals before brackets
# a power with two indices of which the second one is typed too high: `x^{b_i, j}`
_INDEXED_POWER = re.compile(r"([a-z]) _ (?:\{ )?[a-z](?: \})? , [a-z]")
# a step of an iteration within a step of time: `y^{n (m + 1)}`
_STEP_OF_STEP = re.compile(r"([i-n]) \( (?!\1)[i-n](?: [-+] 1)? \)")
# the values that an index takes, from a number on
_VALUED = re.compile(r"(?<![A-Za-z\\])([i-n]) (?:& )?= \d+ , (?:\d+ , )*(?:\\[lc]?dots|\. \. \.|\d+)(?: , \S+)?")
# a number of combinations, or a power
_COMBINATIONS = re.compile(r"C _ (?:[a-z]|\{ [a-z] \})")
# a function of a sphere, whose degree stands below it
_HARMONIC = re.compile(
    r"(?:[YPQ]|[A-Z](?= _ (?:\{ )?(?:l(?![A-Za-z])|\\ell))|\\(?:bar|tilde|mathcal) \{ [YPC] \}) "
    r"_ (?:\{ )?([ln]|\\ell)(?: \})?"
)
# two letters below another one
_PAIR = re.compile(r"_ \{ (?:\\,|- )?([a-z]|\\[a-z]+) (?:, )?([a-z]|\\[a-z]+) \}")
_GREEK_INDICES = frozenset({r"\mu", r"\nu", r"\alpha", r"\beta", r"\rho", r"\sigma", r"\lambda"})
# Greek indices below a letter, as those of tensors are
_INDICES_BELOW = re.compile(r"_ (\\[a-z]+|\{ \\[a-z]+(?: (?:, )?\\[a-z]+)* \})")
# one of several factors with its exponent: `x_i^{a_i}`
_ITS_EXPONENT = re.compile(r"\\?[A-Za-z]+ _ (?:\{ )?([i-n])(?: \})? \^ (?:[a-z]|\\[a-z]+) _ (?:\{ )?\1(?: \})?")
# a Greek letter, but none that counts steps, and a number
_ONE_MORE_OR_LESS = re.compile(
    r"\d+ [-+] \\(?:alpha|beta|gamma|delta|theta|lambda)|\\(?:alpha|beta|gamma|delta|theta|lambda) [-+] \d+"
)
# an exponent of one of several powers, which is named by its base
_EXPONENT = re.compile(r"\\(?:alpha|beta|gamma) _ (?:[A-Z]|\{ (?:[A-Z]|\\[a-z]+ \{[^{}]*\}|[a-z](?: [a-z])+) \})")
# a capital in upright letters, by itself or with an index
_UPRIGHT = re.compile(r"\\(?:text|mathrm) \{ (?:[A-SU-Z]|T(?= \} _))")
_ARGUMENT = r"(?:\\?[A-Za-z]+|\\[a-z]+ \{ \w \})"
# arguments that are letters: `(a, b | x, y)`
_LISTED = re.compile(rf"(?:\\left )?\( {_ARGUMENT}(?: (?:[,;|]|\\mid) {_ARGUMENT})+ (?:\\right )?\)")


# what a sum runs over a set with, but over one of numbers
_MEMBER = re.compile(r"\\(?:sum|prod) _ \{ ([a-z]) \\in (?!\\mathbb \{ [NZQRC] \})")


@dataclass(frozen=True)
class Told:
    """What formulas tell of superscripts."""

    formulas: Sequence[str]
    said: Collection[str]  # letters of which something is said
    powers: Collection[str]  # letters that are raised to powers for certain
    labels: Collection[tuple[str, ...]]  # superscripts of functions that have subscripts too, as in P_n^m(x)
    loose: Collection[str]  # indices of sums without bounds
    framed: Collection[str]  # letters between two frames that have numbers, as in T_2^1
    applied: Collection[str]  # letters before brackets
    mixed: Collection[str]  # indices above Kronecker's delta
    listed_above: Collection[str]  # letters with a list above them, as in a^{n, k}
    raised: Collection[tuple[str, str]]  # letters, each with the one that stands above it elsewhere

    @cached_property
    def numbers(self) -> Collection[str]:
        """Letters that stand for numbers somewhere."""
        return {word for formula in self.formulas for word in _Numbers(formula).run()} | {*self.said}

    @cached_property
    def below(self) -> Collection[str]:
        """Letters that stand alone below another one, or among indices there."""
        found = {text for formula in self.formulas for pair in _INDICES_BELOW.findall(formula) for text in pair.split()}
        return found - {"{", "}", ","}

    @cached_property
    def counting(self) -> Collection[str]:
        """Letters whose values are listed, which stand below other letters, and are no numbers elsewhere."""
        valued = {letter for formula in self.formulas for letter in _VALUED.findall(formula)}
        if not valued:
            return valued
        below = {
            x
            for formula in self.formulas
            for x in valued
            if re.search(rf"_ (?:\{{ )?{x}(?: \}}|(?![A-Za-z]))", formula)
        }
        return below - {word for formula in self.formulas for word in _Numbers(_VALUED.sub("", formula)).run()}

    @cached_property
    def multiplied(self) -> bool:
        """Is a product taken over an index?"""
        return any(r"\prod" in formula for formula in self.formulas)

    @cached_property
    def members(self) -> Collection[str]:
        """Letters that sums and products run over sets with, which need no numbers be."""
        return {letter for formula in self.formulas for letter in _MEMBER.findall(formula)}

    @cached_property
    def paired(self) -> Collection[tuple[str, str]]:
        """Letters that stand side by side below a letter, so that they are indices, in both orders."""
        found = {pair for formula in self.formulas for pair in _PAIR.findall(formula)}
        return found | {(b, a) for a, b in found}

    @cached_property
    def listed(self) -> Collection[str]:
        """Letters that stand among the arguments of functions."""
        return {x for formula in self.formulas for found in _LISTED.findall(formula) for x in found.split()}

    @cached_property
    def placed(self) -> Collection[str]:
        """Those of them that stand elsewhere than among the arguments of functions, which need no numbers be."""
        return {word for formula in self.formulas for word in _Numbers(_LISTED.sub("", formula)).run()} | {*self.said}


def _is_power(above: Sequence[str]) -> bool:
    """Is this superscript a power for certain, as 2n, N + 2 and gamma - 1 are?"""
    texts = [text for text in above if text not in SPACES]
    if _ONE_MORE_OR_LESS.fullmatch(" ".join(texts)):
        return True
    mixed = any(text.isalpha() for text in texts) and any(text.isdigit() for text in texts)
    return mixed and all(text.isalnum() or text in "+-" for text in texts) and not _letters(texts)


def _doubt(of: Scripted, told: Told, labelled: Collection[str]) -> str | None:
    """What is in doubt about a superscript that may be a label; None if it is a power, transposes, or is none."""
    inside = [text for text in of.above if text not in SPACES]
    sign = len(inside) == 1 and inside[0] in ("*", r"\star") and of.word == r"\pi"  # a policy
    sign = sign or (of.word == r"\delta" and _is_word(inside))
    if of.word == "e" and len(inside) == 1 and inside[0] in told.mixed:
        return POWER_OR_LABEL.format(inside[0])  # one of the reciprocal vectors
    if of.word == r"\delta" and of.below and len(inside) == 1 and (_letters(inside) or inside[0] in "01"):
        return ""  # Kronecker's
    if of.word == "d" and len(inside) > 1 and len(_letters(inside)) == len(inside):
        return POWER_OR_LABEL.format(inside[0])
    sign = sign or (of.word.startswith(r"\mathbb") and _UPRIGHT.match(" ".join(inside)) is not None)  # no set
    baseless = of.word in _NO_BASE and not (of.word == "e" and of.below)  # e_i is no number
    if not inside or ((baseless or of.word.startswith(r"\mathbb")) and not sign):
        return None
    if (
        inside == [r"\infty"]
        or _STEP_OF_STEP.fullmatch(" ".join(inside))
        or (inside == ["1"] and of.applied and not of.below)
    ):
        return POWER_OR_LABEL.format(" ".join(inside))  # no powers that anybody prints
    if inside == [r"\circ"] and of.word not in _ANGLES and not of.word[:1].isupper():
        return STANDARD
    if inside in (["0"], ["1"]) and not any((of.word, power) in told.raised for power in "23n"):
        return ""  # nobody prints these powers but in a series of them
    if found := _INDEXED_POWER.fullmatch(" ".join(inside)):
        return POWER_OR_LABEL.format(found[1])
    bracketed = inside[0] == "(" and _is_label(inside)
    powers = [text for text in inside if (of.word, text) in told.raised] if bracketed else []
    if powers:
        return POWER_OR_LABEL.format(powers[0])  # as in z^{(M - 1)} beside z^M
    if _is_label(inside) or (inside == [r"\circ"] and of.word[:1].isupper()):  # the standard state, and no degrees
        return ""
    if of.word in told.listed_above and "," not in inside and (_letters(inside) or "".join(inside).isdigit()):
        return POWER_OR_LABEL.format(" ".join(inside))  # beside `a^{n + 1, k}`
    upright = [text for text in inside if text not in {"{", "}"} | ROMAN]
    if len(upright) == 1 and upright[0] in _TRANSPOSING:
        if upright[0] not in ("T", "H") or of.word not in labelled:
            return None
        return "" if of.framed else TRANSPOSED_OR_LABEL
    letters = _letters(inside)
    if letters and of.word.startswith(r"\underline"):
        return POWER_OR_LABEL.format(letters[0])
    if len(letters) == len(inside) == 1 and letters[0] in told.counting and not of.plain and of.word not in told.powers:
        return POWER_OR_LABEL.format(letters[0])
    if (
        (of.applied or of.derived)
        and not of.below
        and len(inside) == 1
        and inside[0].isupper()
        and inside[0] in told.numbers
    ):
        return POWER_OR_LABEL.format(inside[0])  # behind its argument a power would stand
    if (
        of.below
        and len(letters) == len(inside) > 1
        and "," not in inside
        and {*itertools.pairwise(letters)} <= {*told.paired}
    ):
        return POWER_OR_LABEL.format(" ".join(inside))  # a pair of indices
    index = letters == ["".join(inside)] and letters[0] in _GREEK_INDICES and letters[0] in told.below
    if index and letters[0] not in told.numbers:
        return POWER_OR_LABEL.format(letters[0])  # summed over
    if told.multiplied and _ITS_EXPONENT.fullmatch(f"{of.bare} ^ {' '.join(inside)}"):
        return None
    if len(letters) == 1 and _EXPONENT.fullmatch(" ".join(inside)):
        return None
    if (inside == ["0"] and (of.applied or of.below or of.word in told.applied or of.changed)) or (
        inside == ["1"] and of.below
    ):
        return ""  # nobody prints such a power
    if of.below and of.word in told.framed and (inside[0].isdigit() or letters):
        return ""
    if inside[:1] == ["-"] and of.applied and of.below and tuple(inside[1:]) in told.labels:
        return ""  # as in P_n^{-m}(x)
    if of.applied and len(inside) > 1 and len(letters) == len(inside) and "_" not in of.word:
        return POWER_OR_LABEL.format(letters[0])  # a word above a function
    if of.applied and of.below and not letters and any(map(str.isalpha, inside)):
        return POWER_OR_LABEL.format(next(filter(str.isalpha, inside)))
    if len(letters) > 2 and letters == inside and all(map(str.isalpha, letters)) and not of.framed:
        return POWER_OR_LABEL.format("".join(letters))  # a word
    if not letters or of.plain or of.word in told.powers:
        return None
    if letters == ["t"] and len(inside) > 1 and of.word not in _DISCOUNTS:
        return POWER_OR_LABEL.format("t")  # a step of time
    harmonic = _HARMONIC.fullmatch(of.bare)
    if inside == ["m"] and harmonic and harmonic[1] != "n":
        return ""
    if of.above in told.labels and of.below:
        power = letters[0].islower() and letters[0] in told.numbers and of.word not in _OF_ORDERS
        return POWER_OR_LABEL.format(letters[0]) if power and not of.framed else ""
    loose = letters[0] in told.loose or (of.below and letters == inside and letters[0] in told.members)
    loose = loose or (of.applied and not any(letter[:1].isupper() for letter in letters))
    if loose and not of.framed:
        return POWER_OR_LABEL.format(letters[0])
    if letters[0] in _STATES_ABOVE and len(letters) == 1 and not of.framed:
        return POWER_OR_LABEL.format(letters[0])
    capitals = {above for word, above in told.raised if word == of.word and above.isupper()} - _TRANSPOSING
    if len(capitals) > 1 and inside[0] in capitals and of.below:
        return ""  # as in W_i^Q beside W_i^K
    capitals_alone = len(letters) > 1 and letters == inside and all(map(str.isupper, letters))
    if not of.framed and capitals_alone and 0 < sum(letter in told.numbers for letter in letters) < len(letters):
        return POWER_OR_LABEL.format("".join(letters))  # some of them are factors elsewhere
    if not of.framed and any(letter in told.numbers for letter in letters):
        below = of.bare.rpartition("_")[2].strip(" {}") if of.below else ""
        several = not below and len({above for word, above in told.raised if word == of.word}) > 1
        combined = letters == inside and (_COMBINATIONS.fullmatch(of.bare) or (below, letters[0]) in told.paired)
        listed = letters == ["".join(inside)] and (several or below in told.listed) and letters[0] not in told.placed
        return POWER_OR_LABEL.format(letters[0]) if listed or (harmonic and inside == ["m"]) or combined else None
    members = {number.partition("_")[0] for number in told.numbers if "_" in number}
    if not of.framed and len(letters) == 1 and "_" in letters[0] and letters[0].partition("_")[0] in members:
        return None  # one of several numbers
    points = "_" in letters[0] or len(letters) > 1 or letters[0] in FRAMES
    if of.framed or "," in inside or letters[0].startswith(BOLD):
        return ""
    if points and all(letter[:1].isupper() for letter in letters):
        if {"+", "-"} & {*inside}:
            return POWER_OR_LABEL.format(letters[0])
        series = len(inside) == 1 and not of.below and {chr(ord(inside[0]) + k) for k in (-1, 1)} <= {*told.numbers}
        return POWER_OR_LABEL.format(letters[0]) if series else ""  # among the coefficients A, B and C
    style, _, base = of.word.partition("{")
    if style in BOLD and base[:1].islower() and not {"+", "-"} & set(inside) and not of.applied:
        return ""
    return POWER_OR_LABEL.format(letters[0])


def _letters(inside: Sequence[str]) -> list[str]:
    """The letters of a superscript that may be a label: letters alone, or apart at a comma or slash, or k + 1."""
    reader, found = tex.Reader(" ".join(inside)), list[str]()
    if inside[-2:] in (["+", "1"], ["-", "1"]):
        reader = tex.Reader(" ".join(inside[:-2]))
    try:
        while reader.i < len(reader.texts):
            if reader.peek() in (",", "/") and found and reader.i + 1 < len(reader.texts):
                reader.i += 1
                continue
            word = reader.spelling()
            if known(word) and word[:1] == "\\":
                return []
            if reader.peek() == "_":
                reader.i += 1
                word += tex.subscript(reader.group())
            if reader.peek() == "^":
                reader.i += 1
                if {*reader.group()} - _SIGNS:
                    return []
            found.append(word)
    except SymcheckError:
        return []
    slashed = "/" in inside
    return [] if slashed and not all(word[:1].isupper() for word in found) else found


class _Numbers(tex.Reader):
    """The letters of a formula that stand for numbers somewhere: neither below another letter nor a label above one."""

    def run(self, stop: int | None = None) -> Iterator[str]:
        stop = len(self.texts) if stop is None else stop
        base = ""
        while self.i < stop:
            text = self.peek()
            if text in SPACES:
                self.i += 1
            elif text == r"\prescript":
                self.i += 1
                self._skip(2)
            elif text in (r"\begin", r"\end"):
                self.i += 1
                columns = "".join(self._inside()) == "array" and text == r"\begin" and self.peek() == "{"
                self._skip(1 if columns else 0)
            elif text in ("_", "^"):
                self.i += 1
                start, inside = self.i, self._inside()
                end = self.i
                label = base == "letter" and (_letters(inside) or inside[-1:] in (["T"], [r"\top"]))
                if base == "sign" or (text == "^" and not label):
                    self.i = start
                    yield from self.run(end)
                self.i = end
            elif text in _BOUNDED:
                self.i, base = self.i + 1, "sign"
            elif tex.is_letter(text):
                word = self._word()
                base = "letter" if word and word not in ("e", r"\text{e}") else "other"
                if word and not known(word):
                    yield word
            else:
                base = base if text in "{}" else "other"
                self.i += 1

    def _inside(self) -> list[str]:
        try:
            return [text for text in self.group() if text not in SPACES]
        except SymcheckError:
            return []

    def _skip(self, count: int) -> None:
        for _ in range(count):
            self._inside()

    def _word(self) -> str:
        """The letter here with its subscript; nothing if it is none."""
        start = self.i
        try:
            word = self.spelling()
            if self.peek() == "_":
                self.i += 1
                word += tex.subscript(self.group())
        except SymcheckError:
            self.i = max(self.i, start + 1)
            return ""
        return word


def _scripted(formula: str) -> Iterator[Scripted]:
    """The letters of a formula with a superscript, or with scripts at the left."""
    reader = tex.Reader(formula)
    texts = reader.texts
    while reader.i < len(texts):
        start, text = reader.i, reader.peek()
        framed = text == r"\prescript"
        changed = _change(texts, start) if text in (r"\Delta", r"\delta") else 0
        if not framed and not tex.is_letter(text):
            reader.i += 1
            continue
        try:
            if framed:
                reader.i += 1
                for _ in range(2):
                    reader.group()
                word = " ".join([*texts[start : reader.i], *reader.group()])
            else:
                reader.i += changed
                word = reader.spelling()
            behind = low = end = reader.i
            above = list[str]()
            while not known(word) and reader.peek() in ("_", "^"):
                mark, reader.i = reader.peek(), reader.i + 1
                inside = reader.group()
                if mark == "^" and not (set(inside) - {"'", r"\prime"}):
                    break
                above += inside if mark == "^" else []
                low, end = (low if mark == "^" else reader.i), reader.i
            if framed or above:
                name, bare = (" ".join(texts[start:to]) for to in (end, low))
                before = texts[:start]
                coefficient = before[-len(above) - 3 :] == ("_", "{", *above, "}") and len(_letters(above)) < 2
                coefficient = coefficient and not (len(above) == 1 and above[0] in _AXES)
                derived = before[-1:] in (("d",), (r"\partial",)) and not (len(above) == 1 and above[0].isupper())
                plain = not framed and (derived or coefficient)
                applied = _is_applied(texts[end:])
                yield Scripted(
                    name,
                    bare,
                    word,
                    tuple(above),
                    framed,
                    plain,
                    applied,
                    changed=changed > 0,
                    below=low > behind,
                    derived=before[-1:] == (r"\partial",),
                )
            reader.i = start + 1 if changed and not above else behind
        except SymcheckError:
            reader.i = max(reader.i, start + 1)


def _is_applied(behind: Sequence[str]) -> bool:
    """Do brackets open here that hold no sum, as those of arguments do?"""
    inner = [*itertools.dropwhile(SIZES.__contains__, behind)]
    if inner[:1] != ["("]:
        return False
    end = inner.index(")") if ")" in inner else len(inner)
    return not {"+", "-", "=", r"\pm"} & set(inner[:end]) and inner[end + 1 : end + 2] != ["^"]


# a rate among coefficients that are Greek letters, in which a factor `\delta` is one of them
_COEFFICIENTS = re.compile(
    r"\\frac \{ d ([A-Za-z]) \} \{ d t \} .*"
    r"(?:\\(?:beta|gamma) .*\\delta (?:[A-Za-z] )?\1(?!\w)|\\delta (?:[A-Za-z] )?\1(?!\w).*\\(?:beta|gamma) )"
)


def _matrices_and_differences(formula: str) -> Iterator[str]:
    r"""Matrices in brackets, `[P]`, `[BN]`, and differences, `\Delta x`."""
    reader = tex.Reader(formula)
    texts = reader.texts
    while reader.i < len(texts):
        start, text = reader.i, reader.peek()
        if text == "[" and not _is_place(texts, start) and (end := _bracketed(texts, start)):
            if "+" in texts[texts.index("]", start) : end]:  # the positive part
                reader.i = end
                continue
            yield " ".join(texts[start:end])
            reader.i = end
            continue
        reader.i += 1
        if text not in (r"\Delta", r"\delta", r"\nabla") or not (count := _change(texts, start)):
            continue
        try:
            reader.i = start + count
            reader.spelling()
            while reader.peek() == "_":
                reader.i += 1
                reader.group()
            if texts[reader.i - 1] == "e" and reader.peek() == "^":
                continue  # of a power of Euler's number
            yield " ".join(texts[start : reader.i])
        except SymcheckError:
            reader.i = start + 1


# what stands beside matrices: bold letters and arrows, what is transposed or inverse, letters with accents, two letters
_OF_MATRICES = re.compile(
    r"\\(?:mathbf|boldsymbol|bm|pmb|vec|hat|tilde|det|begin|mathcal|times|top)(?![A-Za-z])"
    r"|\^ \{ (?:T|- 1) \}|\[ [A-Z] [A-Z]"
)


def _unit(latex: str, formula: str) -> str:
    """The doubt about one letter in brackets: at the end behind a factor, or where nothing is a matrix.

    That about a gradient is whether its power is meant.
    """
    if latex.startswith(r"\nabla"):
        raised = re.search(rf"{re.escape(latex)} \^ (?:\{{ )?[\w\\](?<!T)(?!mathrm|top|text|dagger)", formula)
        return "the gradient of a power, or a power of the gradient? write brackets" if raised else ""
    if latex.startswith(r"\Delta") and _is_laplacian(latex.removeprefix(r"\Delta "), formula):
        return "a change, or the Laplacian? write \\nabla^2, or say what it is"
    if latex.startswith(r"\delta") and re.search(rf"\( {re.escape(latex)} (?:\\right )?\) \^ \{{ - 1 \}}", formula):
        return "a change, or a factor before a letter? write \\cdot, or say what it is"
    if not latex.startswith("["):
        return ""
    if formula.count("[") == 1 and re.search(rf"[\w}})] (?:\\[,;:] )?{re.escape(latex)}[ .,;]*$", formula):
        return "a matrix in brackets, or the unit of what stands before them? say what it is"
    compared = re.search(
        rf"(?:[<>]|\\(?:le|ge|leq|geq|leqslant|geqslant)) {re.escape(latex)}|{re.escape(latex)} (?:& )?[<>]", formula
    )
    return (
        ""
        if _OF_MATRICES.search(formula) and not compared
        else "a matrix in brackets, or a concentration? say what it is"
    )


def _is_multiplied(letter: str, formula: str) -> bool:
    """Does the same letter follow with another index, so that the Delta is hardly a sign of a change?"""
    own = re.escape(letter)
    return re.search(rf"\\Delta {own}(?: [_^] (?:\w|\{{[^{{}}]*\}}))+ {own} [_^]", formula) is not None


_POTENTIALS = frozenset({"u", r"\phi", r"\varphi", r"\psi", r"\Phi", r"\Psi"})  # of which equations say the Laplacian


def _is_laplacian(letter: str, formula: str) -> bool:
    """May the letter behind a Delta be a function of the place: has it partial derivatives, or is it all on the left?

    Other changes beside it say that it is one.
    """
    own = re.escape(letter)
    if re.search(rf"\^ (?:2|\{{ 2 \}}) (?:\\[,;:!] )*\\Delta {own}(?! [_^])(?![A-Za-z])", formula) and re.search(
        rf"(?:^|[-+=] ){own} [-+=]", formula
    ):
        return True  # multiplied by the square of a length
    if letter in _POTENTIALS and re.search(
        rf"(?:(?:^|= )(?:& )?- |\\int _ (?:\S|\\\w+|\{{[^{{}}]*\}}) (?:\{{ )?)\\Delta {own}(?![A-Za-z])(?! [_^])",
        formula,
    ):
        return True  # as equations begin, and what is tested by others
    if formula.count(r"\Delta") > formula.count(rf"\Delta {letter}"):
        return False
    if re.search(
        rf"(?:\\frac \{{ \\partial|\\partial _ \S+|\\nabla)(?: \^ (?:\w|\{{[^{{}}]*\}}))? {own}(?![A-Za-z])", formula
    ):
        return True
    alone = letter in _POTENTIALS and len(re.findall(rf"(?<![A-Za-z\\]){own}(?![A-Za-z])", formula)) == 1
    return alone and re.match(rf"(?:& )?(?:- )?\\Delta {own} (?:(?:\\left )?\([^()]*\) )?(?:& )?=", formula) is not None


def _is_place(texts: tuple[str, ...], start: int) -> bool:
    """Do these brackets stand behind a letter behind which others hold a number or a letter, as in `x[0], x[N]`?

    Behind the sign of an expectation they hold its argument.
    """
    before = texts[start - 1] if start else ""
    four = zip(texts, texts[1:], texts[2:], texts[3:], strict=False)
    return (
        before == "E"
        or _OPERATED.search(" ".join(texts[:start])) is not None
        or any((a, b, d) == (before, "[", "]") and (c.isdigit() or c.islower()) for a, b, c, d in four)
    )


# an upright name, perhaps with what stands below it
_OPERATED = re.compile(
    r"(?:\\(?:mathbb|text|mathrm) \{[^{}]*\}|(?<![A-Za-z\\])E)"
    r"(?: _ (?:\S+|\{(?:[^{}]|\{[^{}]*\})*\}))?(?: \\(?:left|[bB]igg?l?))?$"
)


# words and subscripts, whose letters are no factors
NO_FACTORS = re.compile(r"\\(?:text|mathrm|operatorname) \{[^{}]*\}|_ \{(?:[^{}]|\{[^{}]*\})*\}")


def _dimensionless(formula: str, said: Mapping[str, str]) -> dict[str, str]:
    """Abbreviated names of numbers such as Re, each with its doubt: its letters stand side by side, and nowhere else.

    What has an exponent of letters is left to be refused, as in R e^{i x}.
    """
    texts = tex.texts(formula)
    counted = tex.texts(NO_FACTORS.sub("", formula))
    outside = tex.texts(NO_FACTORS.sub("_", formula))
    alone = [text for text, after in itertools.pairwise([*outside, ""]) if after != "_"]  # a P_r is no P
    found = dict[str, str]()
    for k, (a, b) in enumerate(itertools.pairwise(texts)):
        word = a + b
        if word not in DIMENSIONLESS or a in said or b in said:
            continue
        pairs = sum(pair == (a, b) for pair in itertools.pairwise(counted))
        if not alone.count(a) == counted.count(b) == pairs:
            continue
        decimals = any("." in text for text in texts)
        if word in PRODUCTS and k and not decimals:
            continue
        reader = tex.Reader(formula)
        reader.i = k + 2
        if reader.peek() == "_":
            reader.i += 1
            reader.group()
        name = " ".join(texts[k : reader.i])
        if reader.peek() == "^":
            reader.i += 1
            if any(map(tex.is_letter, reader.group())):
                return {}
        found[name] = f"the {DIMENSIONLESS[word]} number, or {a} times {b}? write \\cdot, or name one letter"
    return found


_WITHIN = r"(?! ?(?:[\^_,)]|\\right))(?:(?!\||\\\||\\langle|\\rangle|[=&]|\\\\).)+"
# products of states, perhaps with an operator between them, and states alone
_PRODUCT_OF_STATES = re.compile(rf"\\langle {_WITHIN}(?:\|{_WITHIN})+\\rangle")
# a state alone, at the right or at the left
_STATE = re.compile(rf"\|{_WITHIN}\\rangle|\\langle {_WITHIN}\|")


def _states(formula: str) -> Iterator[str]:
    r"""States in brackets, `| \psi \rangle`, `\langle \phi |`, and their products, `\langle \phi | \psi \rangle`."""
    yield from _PRODUCT_OF_STATES.findall(formula)
    rest = _PRODUCT_OF_STATES.sub(" , ", formula)
    found = _STATE.findall(rest)
    alone = _STATE.sub(" , ", rest)
    if not re.search(r"\\[lr]angle|\|", alone):  # lengths or averages beside them may be what the bars belong to
        yield from found


def _accented(formula: str) -> Iterator[tuple[str, str]]:
    r"""Accents over several letters: `\vec{OP}` from one point to another; others are in doubt."""
    reader = tex.Reader(formula)
    texts = reader.texts
    while reader.i < len(texts):
        start, text = reader.i, reader.peek()
        reader.i += 1
        if text not in ACCENTS or text in tex.DOTTED or reader.peek() != "{":
            continue
        inside = reader.group()
        letters = _outside_scripts(inside)
        own = STYLES | LETTER_COMMANDS | {"(", ")", r"\star"}
        if len(letters) < 2 or not all(letter.isalpha() or letter in own for letter in letters):
            reader.i = start + 1
            continue
        if len(letters) < 3 and letters[0] in STYLES:
            reader.i = start + 1
            continue
        while reader.peek() == "_":
            reader.i += 1
            reader.group()
        name = " ".join(texts[start : reader.i])
        points = text == r"\vec" and len(letters) == 2 and all(letter.isupper() for letter in letters)
        yield name, "" if points else f"one name, or something done with {' '.join(inside)}? say what {name} is"


def _change(texts: Sequence[str], start: int) -> int:
    r"""The number of tokens of the sign of a change that stands here before its letter, as `\Delta` or `\Delta_{vap}`.

    A word below it says of which reaction it is, and a capital letter follows.
    """
    behind = texts[start + 1 : start + 2]
    if behind != ("_",) or texts[start] != r"\Delta" or texts[start + 2 : start + 3] != ("{",):
        upright = texts[start] == r"\Delta" and behind[:1] in ((r"\mathrm",), (r"\text",))
        upright = upright and "".join(texts[start + 3 : start + 5]).isupper()  # a quantity with initials as its name
        letter = behind and _begins_letter(behind[0]) and behind[0] not in (r"\Delta", r"\delta", r"\nabla")
        return 1 if letter or upright else 0
    count, depth = 3, 1
    while depth and start + count < len(texts):
        depth += (texts[start + count] == "{") - (texts[start + count] == "}")
        count += 1
    inside = texts[start + 3 : start + count - 1]
    word = [text for text in inside if text.isalpha()]
    after = "".join(texts[start + count : start + count + 1])
    of_reaction = len(word) > 1 or {*inside} & {*ROMAN, r"\text"} or (inside[0].islower() and after in _STATES)
    return count if word and of_reaction and after.isupper() else 0


def _begins_letter(text: str) -> bool:
    return text in OVER or (tex.is_letter(text) and not known(text))


def _is_label(inside: Sequence[str]) -> bool:
    """Is a superscript a sign, a number in brackets or a word, so that it is no power?"""
    bracketed = len(inside) > 2 and (inside[0], inside[-1]) in {("(", ")"), ("[", "]"), (r"\{", r"\}")}
    bracketed = bracketed and not ("^" in inside or {"_", "+"} <= {*inside})  # that is a power
    bracketed = bracketed and _encloses(inside)
    if "," in inside and not {"(", "[", "="} & set(inside):  # two indices
        return True
    if [*inside] == ["i", "g"]:  # of an ideal gas
        return True
    if r"\times" in inside[1:]:  # rows and columns
        return True
    if len(inside) > 2 and inside[-2] == "/" and inside[1] in "/(" and inside[0].isupper() and inside[-1].isupper():
        return True  # of one point or frame to another
    word = _is_word(inside) and "".join(inside[1:]).strip("{}") not in ("T", "H", "i", "j", "e", "d")
    return (len(inside) == 1 and inside[0] in _SIGNS) or bracketed or word


def _encloses(inside: Sequence[str]) -> bool:
    """Does the bracket that opens first close last: `(n - 1)`, and no `(n - j) / (n + j)`?"""
    depths = itertools.accumulate((text in OPEN) - (text in CLOSE) for text in inside[:-1])
    return all(depth > 0 for depth in depths)


def _is_word(inside: Sequence[str]) -> bool:
    """Is this upright type and nothing more: `\\text{max}`?"""
    if not inside or inside[0] not in ROMAN:
        return False
    return len(inside) == 2 or (inside[1] == "{" and inside.index("}") == len(inside) - 1)


def _bracketed(texts: tuple[str, ...], start: int) -> int:
    """Where a matrix in brackets ends that begins here: one letter with its scripts, or two capitals; 0 without one.

    The letter may be the change of another one, below an accent.
    """
    end = texts.index("]", start) if "]" in texts[start:] else 0
    inner = [*texts[start + 1 : end]]
    if inner[1:2] == ["{"] and inner[2:3] in ([r"\delta"], [r"\Delta"]) and inner[3:4] != ["}"]:
        del inner[2]  # an accent over the change of a letter
    styles = {r"\mathcal"} if texts[end + 1 : end + 2] == ("^",) else STYLES  # or an inverse product
    letters = [text for text in _outside_scripts(inner) if text not in styles]
    pair = len(letters) == 2 and all(len(text) == 1 and text.isupper() for text in letters)
    styled = bool(inner) and ((inner[0].isalpha() and inner[0].isupper()) or inner[0] in OVER)
    if not end or not (pair or (styled and is_letter(" ".join(inner)))):
        return 0
    reader = tex.Reader(" ".join(texts[end + 1 :]))
    while reader.peek() == "_":  # the scripts of the name
        reader.i += 1
        if "=" in reader.group():
            return 0  # its value there
    return end + 1 + reader.i


@lru_cache(maxsize=4096)  # the same letters are met in every formula
def is_letter(latex: str) -> bool:
    """Is this one letter, with a subscript at most?"""
    reader = tex.Reader(latex)
    if not tex.is_letter(reader.peek()):
        return False
    try:
        word = reader.spelling()
        while reader.peek() in ("'", "_"):
            mark, reader.i = reader.peek(), reader.i + 1
            if mark == "_":
                reader.group()
    except SymcheckError:
        return False
    return reader.i == len(reader.texts) and not (known(word) and word != r"\Gamma")


def _outside_scripts(inner: Sequence[str]) -> list[str]:
    """The tokens that stand in no script."""
    reader, found = tex.Reader(" ".join(inner)), list[str]()
    while reader.i < len(reader.texts):
        text = reader.peek()
        reader.i += 1
        if text == "_" and reader.peek():
            reader.group()
        elif text not in ("{", "}"):
            found.append(text)
    return found
