"""What is done with each letter of formulas: all its places, and what is said of it."""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache

from symcheck.reading import tex
from symcheck.reading.arguments import is_doubled, is_product
from symcheck.reading.commands import ACCENTS
from symcheck.reading.faces import FACES, TENSOR, is_styled
from symcheck.reading.names import INDEX_IN_NAME, INTEGRATED, POWER_OR_LABEL, names_of_several_tokens
from symcheck.reading.occurrences import BOLD, FUNCTIONS_SPELLED, Occurrence, occurrences, words
from symcheck.reading.operators import operators
from symcheck.reading.powers import raised_in_vain
from symcheck.reading.side_by_side import doubted
from symcheck.reading.sides import equated, without_dots
from symcheck.reading.tensors import unsaid_products

# what e is in formulas of orbits: "1 - e^2", "1 + e", "e \cos"
_ECCENTRIC = re.compile(
    r"1\s*[-+]\s*e\s*(?:\^\s*\{?\s*2\s*\}?)?(?!\s*\^|\d)|(?<![A-Za-z\\])e\s*\\(?:cos|sin|cosh|sinh)(?![A-Za-z])"
)
# what i is there: the angle of a function
_INCLINED = re.compile(
    r"\\(?:sin|cos|tan|cot)\s*(?:\^\s*(?:\w|\{[^{}]*\})\s*)?(?:\(\s*|\{\s*)?i(?![A-Za-z])\s*(?![\w\\(])"
)
_TURN = r"[A-Z] _ (?:\{ )?\d (?:\} )?\( "
# and the angle of a turn among those by `\Omega` and `\omega`
_TURNED = re.compile(rf"{_TURN}\\Omega \).*{_TURN}i \)|{_TURN}i \).*{_TURN}\\Omega \)")
_ORBITAL = {"e": _ECCENTRIC, "i": _INCLINED}
# a multiple of the identity, by its tokens
_MULTIPLE = r"(?:\d |\\[a-z]+ |\\[a-z]+ _ (?:\w|\{ \w+ \}) |[sz] )*I"
# `(A - \lambda I)` and `(\lambda I - A)`
_RESOLVENT = re.compile(rf"\( (?:([A-Z]) - {_MULTIPLE}|{_MULTIPLE} - ([A-Z])) (?:\\right )?\)")
_INNER = r"([A-Z]|\\[A-Z][a-z]+)"
_CONJUGATED = re.compile(  # `Q A Q^{-1}` and `Q^{-1} A Q`
    rf"(?<![A-Za-z\\])([A-Z]) {_INNER} \1 \^ \{{ - 1 \}}|([A-Z]) \^ \{{ - 1 \}} {_INNER} \3(?![A-Za-z])"
)
_SKEW = re.compile(r"\[ (.+) \] _ (?:\{ )?\\times(?: \})?")  # `[a]_\times`, by its tokens
# The letter itself, behind the two groups of scripts at its left; what follows it are scripts at its right.
_CAPITAL_IN_FRAME = re.compile(r"\\prescript \{[^{}]*(?:\{[^{}]*\}[^{}]*)*\} \{[^{}]*\} \{ (?:\\\w+ \{ )*[A-Z]")


@dataclass
class Evidence:
    """All places of one letter, and what is said of it; what follows from its places is found when all are known."""

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
    square: bool = False  # does A - \lambda I, or Q A Q^{-1}, show that it is a matrix?
    angle: bool = False  # is a sine or its like taken of it alone?
    endless: bool = False  # does an infinite sum, or a factorial, stand beside it?
    column: bool = False  # does it stand in brackets that are transposed before a factor, or behind a small letter?
    scaling: bool = False  # is it the factor behind a dot of what is equal to a vector?
    turning: bool = False  # is it the rate of a phase: `\\cos(\\omega (t - t_0))`?
    between: bool = False  # does it stand between brackets that are transposed and others?
    shape: tuple[int, ...] = ()  # of the matrix or the column to which it is equal

    @cached_property
    def transposed(self) -> bool:
        """Does it stand with a T above, or with another sign of the transposed?"""
        return any(place.transposed for place in self.places)

    @cached_property
    def capital(self) -> bool:
        """Is it bold, without an arrow, and capital?"""
        line = self.spelling.startswith(r"\underline{") and not TENSOR.match(self.spelling)
        return is_styled(self.spelling, capital=True) and r"\vec" not in self.spelling and not line

    @cached_property
    def multiplied(self) -> bool:
        """Is it capital, and does a bold letter that is not follow without a sign: is it a matrix for certain?"""
        return self.capital and any(place.followed for place in self.places)

    @cached_property
    def crossed(self) -> bool:
        """Does a cross stand beside it?"""
        return any(r"\times" in (place.before, place.after) for place in self.places)

    @cached_property
    def bound(self) -> bool:
        """Does it bound a sum, as a number does?"""
        return any(place.role == "bound" for place in self.places)

    @cached_property
    def factor(self) -> bool:
        """Does a vector follow it behind a dot or a cross, so that it is a factor of that?"""
        return any(place.before in (r"\cdot", r"\times") and place.after in FACES for place in self.places)

    @cached_property
    def idle(self) -> bool:
        """Would all brackets behind it be idle if they were factors?"""
        return all(map(is_product, self.arguments)) and not any(place.powered for place in self.places)

    @cached_property
    def framed(self) -> str:
        """Is it a vector, or a matrix, because a frame stands at its left?"""
        if not self.whole or not self.spelling.startswith(r"\prescript"):
            return ""
        return "matrix" if _CAPITAL_IN_FRAME.match(self.spelling) else "vector"

    @cached_property
    def dotted(self) -> bool:
        return any(place.dots for place in self.places)

    @cached_property
    def derived(self) -> bool:
        """Is it differentiated by another letter?"""
        return any(place.role == "derived" and self.spelling not in place.by for place in self.places)

    @cached_property
    def arguments(self) -> list[tuple[str, ...]]:
        return [place.arguments for place in self.places if place.arguments is not None]

    @cached_property
    def bare(self) -> bool:
        """Does it stand anywhere without brackets behind it?"""
        return any(place.arguments is None and place.role != "subscript" for place in self.places)

    @cached_property
    def by(self) -> list[str]:
        """The letters by which it, or something in which it stands, is differentiated."""
        return list(dict.fromkeys(x for place in self.places for x in place.by))


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
    printed = [without_dots(formula) for formula in formulas if r"\begin" in formula]
    shapes = {letter: shape for letter, other in equated(printed) if (shape := _shape(other))}
    shapes |= {letter: (3, 3) for letter, other in equated(formulas) if letter.isupper() and _SKEW_ADDED.search(other)}
    found: dict[str, Evidence] = {}
    open_ = _in_doubt(formulas) | _forms(formulas)
    square = {
        x
        for formula in formulas
        for each in (_RESOLVENT, _CONJUGATED)
        for m in each.finditer(formula)
        for x in m.groups()
    }
    vectors = [m[1] for f in formulas if r"\cdot" in f for m in _OF_VECTOR.finditer(f)]
    scaling = {canonical(a or b) for other in vectors for a, b in _SCALED.findall(other)}
    turning = {canonical(m[1]) for f in formulas if "omega" in f.lower() for m in _PHASE.finditer(f)}
    forms = [f for f in formulas if _TRANSPOSING.search(f)]
    sums = [m[1] for f in forms for each in (_ROW, _COLUMN) for m in each.finditer(f)]
    columns = {canonical(x) for each in sums for x in re.split(" [-+] ", each.replace(" '", ""))}
    columns |= {canonical(m[1]) for f in forms for m in _BEHIND_ROW.finditer(f)}
    between = {canonical(m[1]) for f in forms for m in _BETWEEN.finditer(f)}
    angles = {m[1] for formula in formulas for m in _ANGLE.finditer(formula)}
    for place in places:
        if place.role == "subscript":
            continue
        tokens, latex = words(place.subscript), place.word
        family = place.word in families and bool(tokens) and all(t in index or t.isdigit() for t in tokens)
        family = family and not _is_mixed(place.subscript or ())
        if tokens and not family:
            latex += tex.subscript(place.subscript or ())
        key = f"{latex} {len(tokens)}" if family else latex
        own = found.setdefault(key, Evidence(latex, indices=len(tokens) if family else 0))
        own.places.append(place)
        own.values |= {int(t) for t in tokens if t.isdigit()} if family else set()
        own.said = phrases.get(latex, "")
        own.index = latex in index and not tokens
        told = "" if own.said else open_.get(latex, "") or open_.get(place.word, "")
        own.whole, own.doubt = latex in wholes, wholes.get(latex, "") or told
        if tokens and not family and (inside := summed.intersection(tokens)):
            own.doubt = own.doubt or f"{INDEX_IN_NAME}: {min(inside)}"
        own.shape = shapes.get(latex, ())
        own.below = latex in below
        own.square = latex in square
        own.scaling = latex in scaling
        own.column, own.between, own.turning = latex in columns, latex in between, latex in turning
        own.angle = latex in angles
        own.endless = latex == "e" and any(r"\infty" in formula or "!" in formula for formula in formulas)
        own.orbital = latex in _ORBITAL and any(map(_ORBITAL[latex].search, formulas))
        own.orbital = own.orbital or (latex == "i" and any(map(_TURNED.search, formulas)))
        for low, high in (ends.get(t, ("", "")) for t in tokens) if family else ():
            low, high = (phrases.get(end, "").removeprefix("the number ") or end for end in (low, high))
            if low.isdigit() and high.isdigit():
                own.values |= {int(low), int(high)}
            elif high:
                own.running = True
    for each in found.values():
        if each.indices and each.spelling in found and _SAID_WHOLE.match(each.said):
            each.said = ""  # the components of what is said to be a vector
    if "T" not in found and any(map(_GROWN.search, formulas)):
        found["T"] = Evidence("T", [Occurrence("T")])  # how often something grows; nobody transposes a number
    _complete(found)
    return found


_SAID_WHOLE = re.compile(r"real \d|(?:constant )?(?:vector|matrix)$")  # phrases about a letter with all its components


def _is_mixed(subscript: Sequence[str]) -> bool:
    """Do commas part this subscript into indices of which one has several letters: `i1,3`?"""
    parts = [part.split() for part in " ".join(subscript).split(",")]
    return len(parts) > 1 and any(len(part) > 1 and not all(map(str.isdigit, part)) for part in parts)


# a capital letter behind a trigonometric function, its power included
_ANGLE = re.compile(
    r"\\(?:arc)?(?:sin|cos|tan|cot|sec|csc)(?:\s*\^\s*(?:\d|\{[^{}]*\}))?[\s({]*(?:\\left\s*\()?\s*([A-Z])\b"
)
_VECTOR = r"\\(?:mathbf|boldsymbol|bm|vec) \{ [a-z] \}(?: _ (?:\w|\{[^{}]*\}))?"
_NUMBER = r"([a-z](?: _ (?:\w|\{[^{}]*\}))?)"
# what a vector is equal to: `\\mathbf{x} = \\mathbf{y} \\cdot b + \\mathbf{a}`
_OF_VECTOR = re.compile(rf"(?:^|& |\\\\ ){_VECTOR} (?:& )?= (?:& )?((?:(?!\\\\|\\q?quad|=).)*)")
# and an addend of it, a number times a vector with a dot between them
_SCALED = re.compile(
    rf"(?:^|[-+] )(?:{_VECTOR} \\cdot {_NUMBER}|{_NUMBER} \\cdot {_VECTOR})(?= ?[-+,.&]| ?$| \\[,;: ])"
)
# the rate of a phase before a time from its beginning
_PHASE = re.compile(
    r"\\(?:sin|cos|exp) (?:\\left )?\( (?:\\?[a-z]+ )*(\\[oO]mega(?: _ (?:\w|\{[^{}]*\}))?) (?:\\left )?\( t [-+]"
)
_RAISED_T = r"\^ (?:T|\{ (?:T|\\top) \}|\\top)(?![A-Za-z])"
# what says that something is transposed
_TRANSPOSING = re.compile(rf"{_RAISED_T}|\) '")
_SMALL = r"(?:[a-z]|\\(?:alpha|beta|gamma|theta|mu|xi|(?:hat|bar) \{ \\?[a-z]+ \}))(?: _ (?:\w|\{[^{}]*\}))?(?: ')?"
# one and a rate, to the power T
_GROWN = re.compile(
    r"\( 1 [-+] (?:[a-z]|\\[a-z]+|\\frac \{ \w \} \{ \w+ \})(?: _ (?:\w|\{[^{}]*\}))? (?:\\right )?\) \^ (?:T|\{ T \})"
)
_FLIPPED = rf"(?:{_RAISED_T}|')"
_MATRIX = r"(?:[A-Z]|\\[A-Z][a-z]+)(?: _ (?:\w|\{[^{}]*\}))?"
# a sum of small letters, transposed, before a factor
_ROW = re.compile(rf"\( ({_SMALL}(?: [-+] {_SMALL})+) (?:\\right )?\) {_FLIPPED} (?=[A-Za-z(]|\\(?:left|[A-Z]))")
# and one behind what is transposed, perhaps with a matrix between them
_COLUMN = re.compile(
    rf"\) {_FLIPPED} (?:{_MATRIX} (?:\^ \{{ - 1 \}} )?)?(?:\\left )?\( ({_SMALL}(?: [-+] {_SMALL})+) (?:\\right )?\)"
)
# a small letter behind another one that is transposed
_BEHIND_ROW = re.compile(
    rf"(?<![A-Za-z\\])(?:[a-df-z]|[A-Z]) (?:_ (?:\w|\{{[^{{}}]*\}}) )?{_RAISED_T} "
    r"([abcp-z](?: _ (?:\w|\{[^{}]*\}))?)(?! [A-Za-z^(\\])"
)
# what stands between brackets that are transposed and others, perhaps inverse
_BETWEEN = re.compile(rf"\) {_FLIPPED} ({_MATRIX}) (?:\^ \{{ - 1 \}} )?(?:\\left )?\(")
# two bold letters with a subscript that an equation begins with, which may be one name
_BOLD_NAME = re.compile(r"\\mathbf \{ ([a-z]) \} \\mathbf \{ [a-z] \} _ (?:\w|\{ [^{}]* \}) =")
# a differential, or a Laplacian, of a function: `d_A f(X)` and `\Delta_q h`
_OPERATOR_BELOW = re.compile(
    r"(?<![A-Za-z\\])(d|\\Delta) _ (?:[A-Zq]|\{ [A-Zq] \}) (?:(?:f|\\[A-Z]\w+) (?:\\left )?\(|[a-z](?! [A-Za-z]))"
)
# the derivative of a product of which only the first letter would depend on the variable
_PRODUCT_DERIVED = re.compile(
    r"\\frac \{ \\partial (?!\\(?:ln|log|exp|det|(?:arc)?(?:sin|cos|tan)h?) )(?:[A-Za-z]|\\[a-z]+) "
    r"(?:_ (?:\w|\{ \w \}) )?((?!\\partial|\\left|\\right|\\frac)(?:[A-Za-z]|\\[a-z]+)) "
    r"(?:\^ (\w|\{ \w \}) )?\} \{ \\partial"
)
# a square before capitals in brackets, which no function has
_SQUARE_OF = re.compile(r"([A-Za-z]|\\[a-z]+) (?:_ (?:\w|\{ \w \}) )?\^ (?:2|\{ 2 \}) \( [A-Z](?: [A-Z])+ \)")
# an addend that ends with a skew matrix
_SKEW_ADDED = re.compile(r"\]\s*_\s*\{?\s*\\times\s*\}?\s*(?:\^\s*\{?\s*\d\s*\}?\s*)?(?:[-+]|$)")
# a coefficient before a product: `b(aNP)`
_OF_PRODUCT = re.compile(r"(?<![A-Za-z\\])(?<![A-Za-z] )([a-eikmr]) \( [a-z](?: [A-Z])+ \)")
# what a function of one letter is equal to: `\sigma(t) = \sigma + b`
_OF_ONE = re.compile(r"(?:^|&|\\quad) ?([A-Za-z]|\\[a-z]+) \( ([A-Za-z]|\\[a-z]+) \) = ((?:(?!\\quad|\\\\|=).)*)")
# words, and letters with what stands at their left
_TEXT = re.compile(r"\\(?:text|mathrm) \{[^{}]*\}|\\prescript (?:\{(?:[^{}]|\{[^{}]*\})*\} ){3}")
# rates, in equations in which letters are functions without brackets
_RATES = re.compile(r"\\d?dot|\\partial|d t|\{ d |\\mathrm \{ d \}")
# a word before brackets that hold a number and a letter
_WORD_TIMES = re.compile(
    r"\\(?:text|mathrm) (\{ [A-Za-z](?: [A-Za-z])+ \}) (?:\\left )?"
    r"\( \d+ [-+] (?:[a-z]|\\(?:text|mathrm) \{[^{}]*\}|\\[a-z]+) (?:\\right )?\)"
)
# what has a number above it that a sum or a product runs over
_ABOVE = re.compile(
    r"([A-Za-z]|\\[a-z]+|\\(?:mathbf|boldsymbol|bm) \{ \w \}) \^ (?:([ij])(?!\w)|\{ ([ij]) (?:- 1 )?\})"
)
_NO_VARIABLES = frozenset("ABCDEFGHKLMNPQRSTUVW")  # of which a series in powers is hardly made
# such a sum or product, from 1 to a number
_FROM_ONE = re.compile(r"_ \{ ([ij]) = 1 \} \^ (?:[a-zA-Z3]|\{ [A-Za-z3] \})")
_RAISED_CHANGE = re.compile(  # `\Delta^2 t` and `\Delta_1^2 F`
    r"\\Delta (?:\^ (?:\d|\{ \d \}) (?:[A-Za-z]|\\(?:theta|phi|tau|nu|lambda))(?![A-Za-z])"
    r"|(_ (?:\w|\{ \w \})) \^ (?:\w|\{ \w \}) (?:[A-Za-z]|\\(?!cdot|times|left|right|frac|q?quad)[a-z]+)(?![A-Za-z]))"
)
# `2F_1(a, b, c, x)`
_HYPERGEOMETRIC = re.compile(
    r"\d F _ (?:\d|\{ \d \}) (?:\\left )?\( [^()]*(?:\([^()]*\)[^()]*)*,[^()]*(?:\([^()]*\)[^()]*)*,"
)
# `fct(x)` and `fc_i(x)`, names of functions
_OF_FUNCTION = re.compile(r"(?<![A-Za-z\\])f ([a-z]) (?:t )?(?:_ (?:\w|\{[^{}]*\}) )?(?:\\left )?\(")
# all that is integrated, and by what
_ALONE = re.compile(
    r"\\int (?:[_^] (?:\w|\\\w+|\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}) )*([A-Za-z]|\\[a-z]+) "
    r"(?:\^ (?:\d|\{ \d \}) )?(?:\\[,;:] )?d (\w|\\\w+)"
)


# rates written with letters below: `u_t = u_{xx}`
_RATE_BELOW = re.compile(r"(?<![A-Za-z\\])([A-Za-z]|\\[a-z]+) _ (?:t(?![A-Za-z])|\{ t(?: t)? \})")
# and slopes
_PLACE_BELOW = re.compile(r"(?<![A-Za-z\\])([A-Za-z]|\\[a-z]+) _ (?:[xyz]|\{ (?:[xyz] )+\})")
# spaces of functions whose powers may be integrated
_OF_SPACE = re.compile(r"\\in (L)(?: _ (?:\w|\{ \w \}))? \^ (?:\d|p|\{ [\dp] \}) (?:\\left )?\(")
# second derivatives written below a letter
_CURVED = re.compile(r"(?<![A-Za-z\\])([A-Za-z]|\\[a-z]+) _ \{ ([xyzt]) \2 \}")
# and of what a gradient is taken of
_RATE_OF_FIELD = re.compile(r"(?<![A-Za-z\\])([A-Za-z]|\\[a-z]+) _ (?:t(?![A-Za-z])|\{ t \})")
# and of potentials
_SLOPES = re.compile(r"(\\(?:phi|psi|Phi|Psi)) _ (?:\{ )?([xyzrt]|\\theta)(?: \}|(?! [,\w]))")
# letters with a line below them, and what shows that they are vectors
_LINED = re.compile(r"(\\underline \{ (?:\w|\\[A-Za-z]+)(?: \{ (?:\w|\\[a-z]+) \})? \})")
# what stands beside vectors and tensors alone
_OF_FIELDS = re.compile(
    r"\\underline \{ \\underline|\\(?:nabla|cdot|times|otimes|vec)(?![a-z])|\{ (?:d i v|r o t|g r a d) "
)
_LABELS = "derivatives, or letters with a label? write them as fractions"
_RUN = r"(?:[i-n]|\\(?:alpha|beta|mu|nu|lambda|rho|sigma|ell))"
# two indices with a comma between them
_PARTED = re.compile(rf"(?<![A-Za-z\\])([A-Za-z]|\\[a-z]+(?: \{{ \w \}})?) _ \{{ ({_RUN}) , ({_RUN}) \}}")
# two indices without a comma
_UNPARTED = re.compile(rf"_ \{{ ({_RUN}) ({_RUN}) \}}")
_UNIT_DOUBT = "the imaginary unit, or the index that stands below? say what it is"
_COMMA = "a derivative by what the comma parts, or another index? write the derivative as a fraction"
_DENOTED = "words with the letter they stand for, or a function? leave out one of them"
_FACTOR_OR_FUNCTION = "a factor, or a function of what is in the brackets? say what it is"


# a rate of interest or of growth
_RATE = r"[irRg](?: _ (?:\w|\{ \w \}))?"
# and pi beside it, as an addend
_INFLATION = re.compile(rf"(?:^|[=(+-] ){_RATE} [-+] \\pi(?= [-+=,.)]| ?$)|\\pi [-+] {_RATE}(?= [-+=,.)]| ?$)")
# one minus pi alone, which as a number is negative
_WEIGHT = re.compile(r"[(\[{] 1 - \\pi (?:\\right )?[)\]}]")
# what is expected of the next value of something: `E_t \pi_{t + 1}`
_EXPECTED = re.compile(
    r"(?<![A-Za-z\\])(E|\\(?:mathbb|text|mathrm) \{ E \}) _ (?:\{ )?(\w) (?:\} )?(?:\\[,;:!] |\\Delta )*"
    r"(?:\\[a-z]+ \{ )?(?:\\?[A-Za-z]+) (?:\} )?_ \{ \2 \+"
)


_MEAN = r"E|\\(?:mathbb|text|mathrm) \{ E \}"
_OF_MEAN = r"(?: _ (?:\w|\\\w+|\{(?:[^{}]|\{[^{}]*\})*\}))?"
_BRACKETED = r"(?:[^()\[\]]|\([^()]*\))*"
# the mean of a difference in square brackets with a power behind them, and what is expected of a power
_MEAN_RAISED = re.compile(
    rf"(?<![A-Za-z\\])({_MEAN}){_OF_MEAN} (?:\\left )?\[ {_BRACKETED} [-+] {_BRACKETED} (?:\\right )?\] \^ (?!T|\{{ T)"
    rf"|(?<![A-Za-z\\])(\\(?:mathbb|text|mathrm) \{{ E \}}|E(?= (?:\\left )?\( (?:[XYZ]|{_BRACKETED}\\mu))){_OF_MEAN} "
    rf"(?:\\left )?\( (?=[^()]* [-+]){_BRACKETED}(?:\\right )?\) \^ (?!T|\{{ T)"
)
# i below a letter that it also stands before, as an addend: `u_i + i v_i`
_UNIT_OR_INDEX = re.compile(
    r"[-+] ([ij]) (?:\\[,;:!] )*(?:[A-Za-z]|\\(?!sum|prod|frac)[a-z]+(?: \{ \w \})?) (?:\^ (?:\S|\{[^{}]*\}) )?"
    r"_ (?:\1(?![A-Za-z])|\{ (?:[^{}]* )?\1 [^{}]*\})"
)


# an entry of a matrix that is one of these letters alone
_UNIT_ENTRY = re.compile(r"(?:& |\\\\ |r i x \} )(?:- )?([ij])(?= (?:&|\\\\|\\end))")


# what is said to be a limit of its own values
_OWN_LIMIT = re.compile(
    r"(?:^|& |quad )([A-Za-z](?: _ (?:\w|\{(?:[^{}]|\{[^{}]*\})*\}))?) (?:& )?= (?:& )?"
    r"\\lim _ \{[^{}]*\} \1 (?:\\left )?\("
)
# a hypothesis, which is a relation
_HYPOTHESIS = re.compile(
    r"(?:^|& )(H _ (?:[01aA]|\{ [01aA] \})) (?:: )?= (?:(?!\\\\|\\q?quad).)*"
    r"(?:[<>]|\\(?:le|ge|leq|geq|ne|neq|in)(?![a-z]))"
)
_ENTRY_TRANSPOSED = "an entry of what is transposed, or a transposed block? write the indices in the other order"
# a transposed letter with two indices: `V^T_{ij}`
_TRANSPOSED_ENTRY = re.compile(
    rf"((?:[A-Z]|\\[a-z]+ \{{ [A-Z] \}}) _ (?:\{{ [i-n] (?:, )?[i-n] \}})) {_RAISED_T}"
    rf"|((?:[A-Z]|\\[a-z]+ \{{ [A-Z] \}})) {_RAISED_T} _ (\{{ [i-n] (?:, )?[i-n] \}})"
)
# two of several in brackets with a dot between them, which needs none between numbers: `(m_i \\cdot m_j)`
_DOTTED_PAIR = re.compile(
    r"\( (?:\\[,;:!] )*(\\?[A-Za-z]+) _ (?:[a-z]|\{ [a-z] \}) \\cdot \1 _ (?:[a-z]|\{ [a-z] \}) (?:\\right )?\)"
    r"|= (?:& )?([A-Z]) _ (?:[a-z]|\{ [a-z] \}) \\cdot \2 _ (?:[a-z]|\{ [a-z] \})(?= ?(?:[.,;]|\\\\|$))"
)


def _doubted(text: str) -> Iterator[tuple[str, str]]:
    """The letters of one formula of which its print leaves open what they are, each with what is open."""
    if text.startswith(r"\mathbf") and (bold := _BOLD_NAME.match(text)):
        yield rf"\mathbf{{{bold[1]}}}", "one name, or a product? say what the letters are"
    if "d _ " in text or r"\Delta _ " in text:
        for operator in _OPERATOR_BELOW.findall(text):
            yield operator, "a factor, or applied to what follows? say what it is"
    if r"\partial" in text:
        for letter, above in _PRODUCT_DERIVED.findall(text):
            name = f"{letter} ^ {{ {above.strip('{} ')} }}" if above else letter
            yield name, "constant, or not? write brackets behind what depends on the variable"
    yield from ((x if "^" in x else canonical(x), doubt) for x, doubt in operators(text))
    yield from ((canonical(x), doubt) for x, doubt in unsaid_products(text))
    if "^" in text and (" = " in text or r"\equiv" in text):
        yield from ((canonical(base), POWER_OR_LABEL.format(above)) for base, above in raised_in_vain(text))
    if r"1 - \pi" in text and _WEIGHT.search(text):
        yield r"\pi", "the number pi, or a probability? say what it is"
    if r"\pi" in text and _INFLATION.search(text):
        yield r"\pi", "the number pi, or a letter? say what it is"
    if "^ 2 ( " in text or "^ { 2 } ( " in text:
        yield from ((factor, _FACTOR_OR_FUNCTION) for factor in _SQUARE_OF.findall(text))
    yield from ((factor, _FACTOR_OR_FUNCTION) for factor in _OF_PRODUCT.findall(text))
    if " ) = " in text and not _RATES.search(text):
        for value, by, rest in _OF_ONE.findall(text):
            if re.search(
                rf"(?<![\\A-Za-z])(?<!_ )(?<!_ {{ ){re.escape(value)} (?![_^(]|\\left \()", _TEXT.sub("", rest + " ")
            ):
                yield value, f"is {value} what {value}({by}) is? write {value}({by}), or name the constant otherwise"
    if r"\Delta ^ " in text or r"\Delta _ " in text:
        for below in _RAISED_CHANGE.findall(text):
            yield canonical(rf"\Delta {below}"), "the power of a change, or times what follows? write brackets"
    if _HYPERGEOMETRIC.search(text):
        yield "F", "a factor before a function, or a hypergeometric one? write the number as a subscript at its left"
    if "E _ " in text or "E } _ " in text:
        for expectation, _ in _EXPECTED.findall(text):
            yield canonical(expectation), "what is expected of what follows, or a factor? write square brackets"
    if "E " in text:
        for first, second in _MEAN_RAISED.findall(text):
            yield canonical(first or second), "the power of a mean, or the mean of a power? write brackets around it"
    for letter in _UNIT_OR_INDEX.findall(text):
        if not re.search(rf"\\(?:sum|prod) (?:\\limits )?_ (?:{letter}|\{{ {letter}) ", text):
            yield letter, _UNIT_DOUBT
    for letter in _UNIT_ENTRY.findall(text) if "r i x }" in text or "a r r a y" in text else ():
        if re.search(rf"_ (?:{letter}(?![A-Za-z])|\{{ (?:[^{{}}]* )?{letter} )", text):
            yield letter, _UNIT_DOUBT
    function = _OF_FUNCTION.search(text)
    if function and tex.texts(text).count("f") == len(_OF_FUNCTION.findall(text)):
        yield "f", f"a factor, or part of the name f{function[1]}? say what it is"
    for run in {*_FROM_ONE.findall(text)} if " = 1 } ^ " in text else ():
        over = [base for base, *above in _ABOVE.findall(text) if run in above]
        if tex.texts(text).count(run) != len(over) + len(_FROM_ONE.findall(text)):
            over = [
                base
                for base in over
                if base in _NO_VARIABLES or base.endswith("}") or re.search(rf"{re.escape(base)} _ (?:\{{ )?1", text)
            ]
        yield from ((canonical(base), f"a power, or an index? say what {run} is above it") for base in over)
    if r"\lim" in text:
        yield from (
            (canonical(x), f"is {x} what its limit is of? name the limit otherwise") for x in _OWN_LIMIT.findall(text)
        )
    for x in _HYPOTHESIS.findall(text):
        yield canonical(x), "equal to what follows, or a name of the relation? write the relation alone"
    for x, base, below in _TRANSPOSED_ENTRY.findall(text):
        entry = x or f"{base} _ {below}"
        yield from ((each, _ENTRY_TRANSPOSED) for each in (canonical(entry), canonical(entry.partition(" _ ")[0])))
    if r"\Delta \Delta " in text:
        yield r"\Delta", "the change of a change, or a factor before one? say what it is"
    if r"\cdot" in text:
        yield from ((x or y, "numbers, or vectors? say what they are") for x, y in _DOTTED_PAIR.findall(text))
    if r"\text {" in text or r"\mathrm {" in text:
        for word in _WORD_TIMES.findall(text):
            yield rf"\text{{{''.join(word[2:-2].split())}}}", "a function, or a factor? say what it is"
        for words in _WORDS_NAMED.findall(text):
            yield rf"\text{{{''.join(words.split())}}}", _DENOTED


def _in_doubt(formulas: Sequence[str]) -> dict[str, str]:
    """The letters of which the print leaves open what they are, each with what is open."""
    found = doubted(formulas)
    for text in formulas:
        found |= dict(_doubted(text))
    parted = [found for text in formulas for found in _PARTED.finditer(text)] if "," in "".join(formulas) else []
    beside = {index for text in formulas for pair in (_UNPARTED.findall(text) if parted else ()) for index in pair}
    for match in parted:
        if {match[2], match[3]} <= beside:
            found.setdefault(canonical(match[1]), _COMMA)
    for letter in {x for text in formulas for x in {*_RATE_BELOW.findall(text)} & {*_PLACE_BELOW.findall(text)}}:
        said = re.compile(rf"(?<![A-Za-z\\]){re.escape(letter)} \( \S+ , \S+ \) =")  # of what it is a function
        if not any(map(said.search, formulas)):
            found.setdefault(letter, _LABELS)
    for space in {x for text in formulas for x in _OF_SPACE.findall(text)}:
        found.setdefault(space, "a power of a value, or a space of functions? say what it is")
    for letter, below in {pair for text in formulas for pair in _CURVED.findall(text)}:
        if any(re.search(rf"\\partial {re.escape(letter)}(?! [_^])(?![A-Za-z])", text) for text in formulas):
            found.setdefault(f"{letter}_{{{below}{below}}}", _LABELS)
    for letter in {x for text in formulas for x in _RATE_OF_FIELD.findall(text)}:
        if any(
            re.search(rf"\\nabla(?: \^ \{{ 2 \}}| \^ 2)? {re.escape(letter)}(?! _)(?![A-Za-z])", text)
            for text in formulas
        ):
            found.setdefault(f"{letter}_t", _LABELS)
    slopes = [each for formula in formulas for each in _SLOPES.findall(formula)]
    for letter in {x for x, _ in slopes if len({by for y, by in slopes if y == x}) > 1}:
        found.setdefault(letter, _LABELS)
    lined = {x for formula in formulas if r"\underline {" in formula for x in _LINED.findall(formula)}
    if lined and not any(map(_OF_FIELDS.search, formulas)):
        found |= dict.fromkeys(map(canonical, lined), "a vector, or a bound? say what it is")
    integrated = [each for formula in formulas if r"\int " in formula for each in _ALONE.findall(formula)]
    if integrated:
        toks = [text for formula in formulas for text in tex.texts(formula)]
        bare = Counter(text for text, after in itertools.pairwise([*toks, ""]) if after != "_")
        for letter, by in integrated:
            if bare[letter] == 1 and letter != "d":
                found[letter] = f"{INTEGRATED} {by}: a constant, or a function of it? say what it is"
    return found


_BASE = (
    r"(?:[A-Za-z]|\\(?:mathbf|bm|boldsymbol|vec|hat|bar|tilde) \{ (?:\w|\\[A-Za-z]+) \}"
    r"|\\(?:beta|theta|mu|phi|psi|xi|[A-Z][a-z]+|varGamma))"
)
_ENTRY = r"([A-Za-z]|\\[A-Za-z]+(?: \{ (?:\w|\\[A-Za-z]+) \})?)"
# a letter beside itself with a prime in a sum, or across the diagonal of a matrix: `A + A'` and `B \\\\ B'`
_MIRRORED = re.compile(
    r"(?<![A-Za-z\\}])([A-Z]|\\[A-Z][a-z]+|\\mathbf \{ [A-Z] \})((?: _ (?:\w|\{ [^{}]* \}))?) \+ \1\2 '(?! ')"
    rf"|& {_ENTRY}(?: (_ (?:\w|\{{ [^{{}}]* \}}))?)? \\\\ \3 (?:'(?: \4)?|\4 ')(?! ')"
    rf"|& {_ENTRY} '(?: (_ (?:\w|\{{ [^{{}}]* \}})))? \\\\ \5(?: \6)?(?! ['_])"
)
_RUNNING = r"(?:[a-z]|\{ [a-z][^{}]* \})"
_INDEX = r"(?: _ (?:\w|\{ [^{}]* \}))?"
# words before a letter in brackets: `\text{load power}(P_L)`
_WORDS_NAMED = re.compile(
    rf"\\(?:text|mathrm) \{{ ((?:[\w'-] )+~ (?:[\w'~-] )+)\}} (?:\\left )?\( {_BASE}{_INDEX} (?:\\right )?\)"
)
# a prime before a factor, as in x'Qx and X'y, or of a letter that stands in the same product, as in AXA', or beside
# itself, with an index or in an expectation, as in y_t y_s' and E(xx')
_TRANSPOSED = re.compile(
    rf"(?<![A-Za-z\\])({_BASE}){_INDEX} ' (?={_BASE})(?!(?<=\by ' )y)"
    rf"|(?<![A-Za-z\\])({_BASE})({_INDEX}) (?:\\[,;:!] )*(?:{_BASE}{_INDEX} (?:\\[,;:!] )*)+(?=\2\3 '(?! '))"
    r"|(y) ' y (?=\) \^ \{ - )"
    rf"|(?<![A-Za-z\\])({_BASE}|\\[a-z]+) _ {_RUNNING} \5 _ {_RUNNING} '(?! ')"
    rf"|E (?:\}} )?(?:\\left )?[\[(] ({_BASE})({_INDEX}) \6\7 '(?! ')"
    rf"|(?<![A-Za-z\\])(\\?[A-Za-z]+)({_INDEX}) ' (?:\\[a-z]+ \{{ \\?[A-Z]\w* \}}|\\?[A-Z][a-z]*){_INDEX} \8\9(?! ')"
)
# what shows that primes differentiate, or that something else transposes
_NO_TRANSPOSES = re.compile(
    r"' '|\\frac \{ d |\\d?dot |' (?:\\left )?\( [a-z] \)|\^ (?:\{ )?(?:T|\\top|\\mathsf)(?![A-Za-z])"
)


# a letter with one prime, and what stands behind it
_PRIMED = re.compile(
    rf"(?<![A-Za-z\\])((?:\\[a-z]+ \{{ (?:\w|\\[a-z]+) \}}|\\?[A-Za-z]+)){_INDEX} '(?! ['(]| \\left \()"
    rf"{_INDEX}(?: \\[,;:! ])* (\S+)?"
)
# what may be transposed before a factor, where T is a letter, too
_POWER_OF_T = re.compile(
    rf"(?<![A-Za-z\\])((?:[A-Za-z]|\\[a-z]+|\\(?:mathbf|bm|boldsymbol|d+ot) \{{ \w \}})){_INDEX}"
    rf"(?: (?:\\right )?\))? \^ (?:T|\{{ T \}}) (?={_BASE}|\\(?:alpha|gamma|delta|eta|lambda|nu|tau|omega)(?![a-z]))"
)
_ABOVE_T = re.compile(r"\^ (?:T|\{ T \})|\\[a-z]+ \{ T \}")  # where T is no letter
# X^H, conjugated and transposed
_ADJOINT = re.compile(r"\^ (?:H(?![A-Za-z])|\{ (?:- )?H \})")


def _begins_factor(token: str) -> bool:
    return (tex.is_letter(token) and token not in FUNCTIONS_SPELLED) or token in ACCENTS or token in BOLD


def _forms(formulas: Sequence[str]) -> dict[str, str]:
    """The letters of products such as `x' Q x` and `X' X`, where a prime may transpose."""
    primed = [formula.replace(r"^ { \prime }", "'") for formula in formulas if "'" in formula or r"\prime" in formula]
    if any(map(_NO_TRANSPOSES.search, primed)):
        primed = []
    found = {
        match[1] or match[2] or match[4] or match[5] or match[6] or match[8]
        for formula in primed
        for match in _TRANSPOSED.finditer(formula)
    }
    found |= {match[1] or match[3] or match[5] for formula in primed for match in _MIRRORED.finditer(formula)}
    places = [match for formula in primed for match in _PRIMED.finditer(f"{formula} ")]
    if not any(match[2] in ("=", "&") for match in places):  # which would say what it is
        other = {match[1] for match in places if not match[2] or not _begins_factor(match[2]) or match[2] == match[1]}
        found |= {match[1] for match in places} - other
    told = dict.fromkeys(map(canonical, found), "does the prime transpose? write a T for that, or name another letter")
    of_t = [formula for formula in formulas if "^ T" in formula or "^ { T }" in formula]
    if any(map(_POWER_OF_T.search, of_t)) and "T" in {x for f in formulas for x in tex.texts(_ABOVE_T.sub("", f))}:
        bases = {m[1] for formula in formulas for m in _POWER_OF_T.finditer(formula)}
        told |= dict.fromkeys(map(canonical, bases), "transposed, or raised to the power of T? say what T is")
    raised = sum(len(_ADJOINT.findall(formula)) for formula in formulas)
    if raised and raised == sum(tex.texts(formula).count("H") for formula in formulas):
        told["H"] = "a power, or conjugated and transposed? say what H is"
    return told


_FIRST_VALUE = re.compile(r"=\s*\d+\s*,")  # and a comma, without which there is no list of them
_RANGE = re.compile(
    r"((?:(?:[A-Za-z]|\\[a-z]+)\s*,\s*)*(?:[A-Za-z]|\\[a-z]+))\s*=\s*(\d+)\s*,(?:\s*(?:\d+|\\[lc]?dots)\s*,)*"
    r"\s*(\d+|(?<=dots ,)\s*[A-Za-z](?:\s*[-+]\s*\d+)?|\\[lc]?dots)"
)  # `i, j = 0, 1, \dots, n - 1`: the letters, the first value and the last one


def _ranges(formulas: Sequence[str]) -> Iterator[tuple[str, str, str]]:
    """The letters whose values are listed, with the first and the last."""
    for formula in formulas:
        for found in _RANGE.finditer(formula) if _FIRST_VALUE.search(formula) else ():
            for letter in found[1].split(","):
                yield letter.strip(), found[2], found[3].strip()


def _complete(evidence: dict[str, Evidence]) -> None:
    """Letters that are meant without being printed: the time, where there are dots, and the d of differentials."""
    if any(each.dotted for each in evidence.values()) and time(evidence) not in evidence:
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
            own.said = own.said or ("" if is_styled(name, capital=False) else "vector")


def time(every: Mapping[str, Evidence]) -> str:
    r"""The letter of the time: `\tau` only where something is a function of it, or differentiated by it."""
    own = every.get(r"\tau")
    if "t" in every or own is None or own.dotted:
        return "t"
    texts = (arg for each in every.values() for args in each.arguments for arg in args)
    used = any(place.role == "variable" for place in own.places) or any(r"\tau" in text.split() for text in texts)
    return r"\tau" if used else "t"


def _paired(places: Sequence[Occurrence]) -> list[Occurrence]:
    """The same, each with the letters beside it behind a dot or a cross."""
    found = list(places)
    own = [k for k, place in enumerate(places) if place.role != "subscript"]
    for k, m in itertools.pairwise(own):
        bracketed = places[k].after == r"\cdot" and places[m].before == "(" and places[m].after in ("+", "-")
        if places[k].after in (r"\cdot", r"\times") and (places[m].before == places[k].after or bracketed):
            found[k] = replace(found[k], beside=(*found[k].beside, spelling(places[m])))
            found[m] = replace(found[m], beside=(*found[m].beside, spelling(places[k])))
    return found


def spelling(place: Occurrence) -> str:
    """The spelling of the letter at one place, with its subscript."""
    return place.word + (tex.subscript(place.subscript) if place.subscript else "")


@lru_cache(4096)
def spellings(*texts: str) -> frozenset[str]:
    """The spellings of all letters that stand in texts."""
    return frozenset(spelling(place) for text in texts for place in occurrences(text))


def canonical(latex: str) -> str:
    """The spelling of a letter as evidence is kept."""
    found = occurrences(latex)
    if not found:
        return latex
    return spelling(found[0])


# a matrix that contains no other environment, perhaps transposed
_ENTRIES = re.compile(
    r"\s*(?:\\begin\{([pbBv]?matrix\*?|smallmatrix)\}(?:\[[lcr]\])?|(?:\\left)?[\[(]\\begin\{(array)\}\{[lcr|]*\})"
    r"((?:(?!\\begin).)*)(?:\\end\{\1\}|\\end\{\2\}(?:\\right)?[\])])(\s*\^\s*\{?\s*T\s*\}?)?\s*[.,;]?\s*",
    re.DOTALL,
)


def _shape(latex: str) -> tuple[int, ...]:
    """The numbers of rows and columns of a printed matrix, or of the components of a column; nothing else has any."""
    if not (found := _ENTRIES.fullmatch(tex.compact(latex))):
        return ()
    rows = [row.split("&") for row in re.split(r"\\\\(?:\[[^\]]*\])?", found[3]) if row.strip()]
    if len({len(row) for row in rows}) != 1:
        return ()
    blank = [not any(map(str.strip, column)) for column in zip(*rows, strict=True)]
    columns = len(blank[:: 2 if is_doubled(blank) else 1])
    (size, *_) = sizes = (columns, len(rows)) if found[4] else (len(rows), columns)
    return sizes if sizes[1] != 1 else (size,)
