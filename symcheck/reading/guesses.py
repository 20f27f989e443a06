"""What one letter may be, by what is done with it: its options, each with the reason."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import lru_cache

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.arguments import (
    is_idle,
    is_listed,
    is_lone,
    is_product,
    is_shift,
    is_shift_of_time,
    is_signed,
    is_sum,
)
from symcheck.reading.commands import LETTER_COMMANDS, OVER
from symcheck.reading.evidence import Evidence, time
from symcheck.reading.faces import ACCENT, HAT, TENSOR, face, is_accented, is_styled
from symcheck.reading.names import is_letter
from symcheck.reading.notation import SAID, Letter
from symcheck.reading.occurrences import FRACTIONS, FUNCTIONS_SPELLED, INTEGRALS, Occurrence

_MASSES = frozenset({"m", "M", r"\rho", "}"})  # before the g of gravity
ECCENTRICITY = "it stands as an eccentricity does"
_TYPICAL = frozenset("fghFGH") | {r"\zeta", r"\phi", r"\psi", r"\varphi", r"\Phi", r"\Psi", r"\Theta", r"\Gamma"}


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
    beside
        Whether it is meant only where the other possibility makes sense, too, so that both are told.
    """

    letter: Letter
    taken: str
    why: str
    remote: bool = False
    beside: bool = False


COMPLEX = "a complex number"


_OPERATOR = re.compile(r"\\math(?:cal|scr)\{[DFHLT]\}")  # of a derivative, a transform, or a linear one
_DIFFERENTIAL = re.compile(r"[dD]_\{?(?:[A-Z]|\\math|\\text)")  # of a map, by or at what is named below
_OF_SPACE = re.compile(r"\\(?:Delta|nabla)_\{?\\(?:mathbf|boldsymbol|bm|vec)")  # a derivative by a place
_MAPS = frozenset({r"\exp", r"\log"})  # functions of matrices, which have differentials
_PRODUCT = re.compile(r"\\Pi_\{?[i-n]\}?")  # with an index below it
_SUM = re.compile(r"\\Sigma_\{?([i-n])\}?")  # likewise
# what stands before a sign of a sum, and hardly before a factor with an index
_BEFORE_SIGN = frozenset({"", "=", "+", "-", "(", "[", "{", "&", r"\\"})
_VARIED = re.compile(r"\\delta\s*(?:[A-Za-z]|\\)")  # a name that begins with the sign of a variation


def options(of: Evidence, every: Mapping[str, Evidence], defined: Mapping[str, tuple[str, ...]]) -> list[Guess]:
    """All that a letter may be, marked if it may be a function of what stands in brackets behind it, or a factor."""
    found = [*_options(of, every, defined)]
    if of.spelling == r"\delta" and not of.said:
        varied = any(x != of.spelling and _VARIED.match(x) for x in every)
        if varied or any(p.after in INTEGRALS for p in of.places):
            return [in_doubt(guess, "a factor, or the sign of a variation? say what it is") for guess in found]
    summed = of.spelling == r"\Sigma" and any(tex.is_letter(place.after) for place in of.places)
    summed &= not any(place.after in ("=", "+", ",", ")") for place in of.places)  # it stands there alone
    if (summed or _runs_over_what_follows(of, every)) and not of.said:
        return [in_doubt(guess, r"a letter, or the sign of a sum? say what it is, or write \sum") for guess in found]
    if _PRODUCT.fullmatch(of.spelling) and not of.said and any(p.after in OVER or p.arguments for p in of.places):
        doubt = r"a letter, or the sign of a product? say what it is, or write \prod"
        return [in_doubt(guess, doubt) for guess in found]
    if of.arguments and not of.said:
        found = _before_brackets(of, every, found)
    if not of.said and _is_normed(of) and sum(map(_is_normed, every.values())) > 1:
        found = [in_doubt(guess, NORMED) if _is_constant(guess) else guess for guess in found]
    operator = (_OPERATOR.fullmatch(of.spelling) or _OF_SPACE.match(of.spelling)) and not of.said
    operated = operator and any(p.after in OVER or tex.is_letter(p.after) for p in of.places)
    mapped = _DIFFERENTIAL.match(of.spelling) and not of.said and any(p.after in _MAPS for p in of.places)
    if operated or mapped:
        return [in_doubt(guess, "a factor, or applied to what follows? say what it is") for guess in found]
    if of.said or not of.arguments:
        return found
    if any(place.role == "bound" and place.arguments is None for place in of.places):
        doubt = "a function, or a number? say what it is"
        found = [in_doubt(guess, doubt) if guess.letter.kind == "function" else guess for guess in found]
    base, _, below = of.spelling.partition("_")
    single = below == "t" or (below in ("x", "y", "z") and sum(_stem(x) == base for x in every) == 1)
    if single and base not in defined and any(len(x) > 1 and below in x for x in of.arguments):
        return [in_doubt(guess, "a derivative, or a label? write it as a fraction") for guess in found]
    letters = [guess.letter for guess in found if not guess.remote]
    applied = all(each.kind == "function" or each.depends for each in letters)
    unclear = [place for place in of.places if place.arguments is not None and not _multiplies(of, place)]
    number = all(each.number for each in letters) and (
        letters[0].number != "i" or all(place.exponent for place in unclear)
    )
    if applied or not unclear or number:
        return found
    sums = all(map(is_sum, (place.arguments or () for place in unclear)))
    named = letters[0].latex[:1] in ("m", "M") or not is_letter(letters[0].latex)  # masses are no functions
    if sums and (letters[0].kind == "matrix" or (letters[0].kind == "scalar" and named)):
        return found
    return [replace(guess, letter=replace(guess.letter, open=True)) for guess in found]


def _before_brackets(of: Evidence, every: Mapping[str, Evidence], found: list[Guess]) -> list[Guess]:
    """The same, in doubt if what stands in brackets behind the letter may be a factor as well as its argument."""
    if any(place.arguments is not None and _is_undecided(place) for place in of.places) and not any(
        place.arguments is None and place.superscript is None for place in of.places
    ):
        found = [in_doubt(guess, FACTOR) if guess.letter.kind == "scalar" else guess for guess in found]
    if of.spelling not in _FUNCTIONS and any(map(_holds_gradient, of.places)):
        found = [in_doubt(guess, FACTOR) for guess in found]
    shifted = any(place.primes for place in of.places) and any(map(is_shift_of_time, of.arguments))
    negative = of.spelling[:1].isupper() and any(map(_holds_negative, of.places))
    if shifted or negative or any(map(_holds_power, of.places)):
        found = [in_doubt(guess, FACTOR) if _is_constant(guess) else guess for guess in found]
    if of.capital and _has_members_bare(of, every):
        found = [in_doubt(guess, FACTOR) if guess.letter.kind == "function" else guess for guess in found]
    if of.spelling.endswith(r"\dagger }"):  # which is done to factors
        found = [in_doubt(guess, FACTOR) if guess.letter.kind == "function" else guess for guess in found]
    if any(map(_raises_quotient, of.places)):
        found = [in_doubt(guess, FACTOR) for guess in found]
    form = of.spelling not in _TYPICAL and any(map(_holds_form, of.places))
    if form or (any(map(_raises, of.places)) and _has_coefficients_beside(of, every)):
        found = [in_doubt(guess, FACTOR) for guess in found]
    return found


# a letter of a vector or a matrix
_STYLED = re.compile(r"\\(?:mathbf|boldsymbol|bm|pmb|vec|bar|hat)(?![A-Za-z])")
# a part or a multiple of pi
_ANGLE = re.compile(r"(?:\d |\\pi |/ |\\frac \{ |\} \{ |\} )*\\pi(?: \d| /| \})*")


def _is_undecided(place: Occurrence) -> bool:
    """Is it raised to -1 before a sum, or does an angle in numbers stand in the brackets: 1 over it, or its inverse?"""
    if place.arguments is None or len(place.arguments) != 1 or place.powered:
        return False
    (inside,) = place.arguments
    inverse = place.superscript is not None and [x for x in place.superscript if x not in "{}"] == ["-", "1"]
    return (inverse and not _STYLED.search(inside)) or _ANGLE.fullmatch(inside) is not None


def _multiplies(of: Evidence, place: Occurrence) -> bool:
    """Is it a factor for certain: a power with a letter and a number, or before brackets in which it stands itself?

    Or between a row in brackets and a column.
    """
    power = place.superscript or ()
    raised = of.between or of.turning or (any(map(str.isdigit, power)) and any(map(str.isalpha, power)))
    if raised or not place.arguments:
        return raised
    printed = " ".join(tex.texts(of.spelling))
    return any(f" {printed} " in f" {arg} " for arg in place.arguments)


def _runs_over_what_follows(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """May it be the sign of a sum over its index, as in `\\Sigma_i m_i r_i`?"""
    found = _SUM.fullmatch(of.spelling)
    if found is None or not any(_SCRIPTED.fullmatch(x) and found[1] in x.partition("_")[2] for x in every):
        return False
    return any(
        place.superscript is None
        and place.before in _BEFORE_SIGN
        and (place.arguments is not None or place.after in OVER | {r"\frac"} or tex.is_letter(place.after))
        for place in of.places
    )


_SCRIPTED = re.compile(r"(?!\\Sigma_).+_(?:\w|\{.*\})")  # a letter with an index
# a product of a row, a matrix and a column
_QUADRATIC = re.compile(r"\S+(?: _ (?:\w|\{[^{}]*\}))? \^ (?:T|\{ T \}|\\top|\{ \\top \}) \S+ \S.*")


def _holds_form(place: Occurrence) -> bool:
    """Do the brackets behind it hold a product of a row, a matrix and a column, and nothing more?"""
    alone = len(place.arguments or ()) == 1 and not place.powered
    return alone and is_product(place.arguments or ()) and any(map(_QUADRATIC.fullmatch, place.arguments or ()))


def _raises_quotient(place: Occurrence) -> bool:
    """Does one fraction stand in brackets with a power behind them, which as a factor needs them too?"""
    alone = place.powered and place.superscript is None and len(place.arguments or ()) == 1
    return alone and place.word in _TYPICAL and any(map(_QUOTIENT.fullmatch, place.arguments or ()))


# a fraction without a sum in it
_QUOTIENT = re.compile(r"\\[dt]?frac \{ [^+-]* \}")


def _raises(place: Occurrence) -> bool:
    """Does one letter stand in brackets with a power behind it?"""
    return (
        place.powered
        and place.superscript is None
        and len(place.arguments or ()) == 1
        and is_letter((place.arguments or ("",))[0])
    )


def _has_coefficients_beside(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Does the same letter stand with another index, and nothing in brackets behind it, as b_0 beside `b_1 (T)^2`?"""
    stem, _, below = of.spelling.partition("_")
    return bool(below) and any(x.partition("_")[0] == stem and not each.arguments for x, each in every.items())


def _is_beside_bare(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Does the same upright letter stand with other indices, and nothing in brackets behind it?"""
    stem, _, below = of.spelling.partition("_")
    alike = (each for x, each in every.items() if x.partition(" ")[0] != of.spelling and x.partition("_")[0] == stem)
    return bool(below) and any(not each.arguments for each in alike)


def _has_members_bare(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Does the same letter stand with another index, and before a letter, as W_0 in `W_0 x` beside `W_1 (x + b)`?"""
    stem, _, below = of.spelling.partition("_")
    alike = (each for x, each in every.items() if x != of.spelling and x.partition("_")[0] == stem)
    return bool(below) and any(
        p.arguments is None and (p.after in OVER or tex.is_letter(p.after)) for each in alike for p in each.places
    )


def in_doubt(guess: Guess, doubt: str) -> Guess:
    """The same guess, of a letter of which this must be said first."""
    return replace(guess, letter=replace(guess.letter, doubt=doubt))


def _is_before_letter(place: Occurrence) -> bool:
    after = place.after
    return (
        place.subscript is None
        and place.superscript is None
        and (after in ("(", r"\left", r"\bigl") or tex.is_letter(after))
    )


ORDERS = {"O": 0, r"\mathcal{O}": 0, "o": 1, r"\mathcal{o}": 1}  # how far terms are above the printed power


def _options(of: Evidence, every: Mapping[str, Evidence], defined: Mapping[str, tuple[str, ...]]) -> Iterator[Guess]:
    latex, arguments, bare = of.spelling, of.arguments, of.bare
    if of.said:
        yield _as_said(of, every)
        return
    if of.index:
        yield Guess(Letter(latex, kind="index", name=variable_name(latex)), "an index", "a sum runs over it")
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
    if of.between and not bare:
        yield Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it stands between a row and a column")
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
    applied = bool(arguments) and not bare and (bool(simple) or not _may_be_factor(of) or _is_stepped(of))
    if not variables and applied and face(latex):
        yield from _of_vectors(of, simple)
    elif variables:
        letters = ", ".join(variables)
        yield Guess(_letter(of, kind="function", depends=letters), f"a function of {letters}", "it is defined as one")
    elif applied:
        depends = ", ".join(simple) if simple else time(every) if of.dotted else None
        shape = (0, 0) if latex.startswith("[") else ()  # of the matrix that is its value
        applied_to = _letter(of, kind="function", depends=depends, size=shape)
        function = Guess(applied_to, "a function", "it stands before its arguments only")
        yield in_doubt(function, FACTOR) if _is_greek(latex) else function
    elif arguments and simple and _varies(of) and not (of.dotted and simple == ("T",) and time(every) == "t"):
        kinds = ("matrix", "vector") if of.capital else ("vector",) if face(latex) else ("scalar",)
        for kind in kinds:
            dependent = _letter(of, kind=kind, depends=", ".join(simple))
            yield Guess(dependent, f"a function of {', '.join(simple)}", "it stands before them")
    elif arguments and not bare and (_NAMED.match(latex) or of.idle):
        function = Guess(_letter(of, kind="function"), "a function", "a product needs no brackets there")
        yield in_doubt(function, FACTOR) if _holds_factors(of) or _is_beside_bare(of, every) else function
    elif arguments and not bare and not of.dotted and _is_function(of, every):
        function = Guess(
            _letter(of, kind="function"), "a function", "it stands before arguments, or its derivative does"
        )
        labelled = _is_primed(of) and "_" in latex and all(map(is_sum, arguments))
        yield in_doubt(function, FACTOR) if labelled else function
    elif arguments and not bare and not of.dotted and not face(latex):
        yield from _before_sums(of, every)
    elif bare and not of.dotted and not of.derived and any(map(is_lone, of.places)):
        by = _primed_by(of, every)
        taken = f"a function{by and f' of {by}'}"
        yield Guess(_letter(of, kind="function", depends=by or None), taken, "it stands before one letter in brackets")
    elif bare and not of.dotted and not of.derived and (any(map(is_listed, arguments)) or _equals_itself(of)):
        yield Guess(_letter(of, kind="function"), "a function", "it stands before several arguments")
    elif of.dotted and not of.shape and not of.capital and any(map(is_lone, of.places)):
        on = _letter(of, kind="function", depends=time(every), size=(0,) if face(latex) else ())
        yield Guess(on, f"a function of {on.depends}", "its rate stands beside its value at a place")
    elif of.dotted or of.derived:
        yield from _dependent(of, every, latex in defined)
    elif of.framed:
        kind = of.framed
        yield Guess(_letter(of, kind=kind, depends=""), f"a {kind}", "a frame stands at its left")
    elif of.whole and latex.startswith("["):
        yield Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it stands in brackets")
    elif latex in _IDENTITIES and not of.angle and (size := _matrix_size(every)) is not None:
        own = (size, size) if size else ()
        unit = Guess(_letter(of, kind="matrix", size=own, identity=True), "the identity", "it stands beside matrices")
        other = Guess(_letter(of, kind="matrix", size=own), "a matrix", "it is capital")
        factor = not any(place.after in _ENDS or place.role == "subscript" for place in of.places)
        factor &= not _in_kronecker_product(of)
        if latex == r"\mathbf{1}":
            yield unit
        else:  # nobody prints an identity only to multiply by it, as a tensor of inertia is printed
            yield from (other, replace(unit, remote=True)) if factor else (unit, replace(other, remote=True))
    elif (sized := _sized_identity(latex, every)) and _matrix_size(every) is not None:
        own = (int(sized[2]), int(sized[2]))
        yield Guess(_letter(of, kind="matrix", size=own, identity=True), "the identity", "its size is printed with it")
        yield Guess(_letter(of, kind="matrix"), "a matrix", "it is capital", remote=latex[0] == "\\")
        if latex[0] != "\\":
            yield Guess(_letter(of, depends=""), "a real number", "nothing else is done with it")
    elif of.shape:
        kind = "matrix" if len(of.shape) > 1 else "vector"
        yield Guess(_letter(of, kind=kind, size=of.shape, depends=""), f"a {kind}", PRINTED)
    elif face(latex):
        yield from _styled(of, every)
    elif of.square or (of.spelling.isupper() and any(each.square for each in every.values()) and not arguments):
        yield Guess(_letter(of, kind="matrix", depends=""), "a matrix", "a multiple of the identity stands beside it")
    elif of.transposed and "T" not in every:
        kind = "matrix" if _ACCENTED.sub("", latex).lstrip("\\")[:1].isupper() else "vector"
        yield Guess(_letter(of, kind=kind, depends=""), f"a {kind}", "it is transposed")
    elif of.column and not of.bound and not arguments and "T" not in every:
        yield Guess(_letter(of, kind="vector", depends=""), "a vector", "it stands in a row, or behind one")
    elif any(latex != x.spelling and _is_outer(of, x) for x in every.values()):
        yield Guess(_letter(of, kind="vector", depends=""), "a vector", "a row stands behind it that is added")
    elif (
        latex.isupper()
        and not of.indices
        and not of.bound
        and any(x.transposed and x.spelling.isalpha() for x in every.values())
    ):
        yield Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it is capital beside what is transposed")
        yield Guess(_letter(of, depends=""), "a real number", "nothing else is done with it")
    elif latex.isupper() and not of.indices and not of.bound and any(map(_in_kronecker_product, every.values())):
        yield Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it is capital in a Kronecker product")
    elif not of.scaling and _beside_vectors(of, every):
        kind = "matrix" if latex.startswith(r"\breve") else "vector"  # a dyadic
        yield Guess(_letter(of, kind=kind, depends=""), f"a {kind}", "it is multiplied by a vector")
    else:
        yield Guess(_letter(of, depends=""), "a real number", "nothing else is done with it")


def _is_outer(of: Evidence, row: Evidence) -> bool:
    """Does this small letter stand behind a sign and before one that is transposed there: `A + u v^T`?"""
    small = of.spelling[0].islower() and row.spelling[0].islower() and row.transposed
    return small and any(p.before in ("+", "-") and p.after == row.spelling[0] for p in of.places)


def _in_kronecker_product(of: Evidence) -> bool:
    """Does a capital letter stand before or behind the sign of this product?"""
    return of.spelling.isupper() and any(r"\otimes" in (place.before, place.after) for place in of.places)


# accents above a letter
_ACCENTED = re.compile(r"^(?:\\(?:bar|overline|hat|widehat|tilde|widetilde|check|breve)\{)+")
_NAMED = re.compile(r"\\text\{(?:\w\w|[A-Z]\}_)")  # several upright letters, or one with an index
NORMED = "a vector, or a number? say what it is"
FACTOR = "a factor before brackets, or a function? say what it is"
# what stands in brackets as a factor rather than as an argument: one fraction, or a number of several digits
_FACTORS = re.compile(r"\\frac \{ .*\}$|(?:\d ){3}|(?:\d )+\. ")
# a power alone, which needs no brackets as a factor
_POWER = re.compile(r"(?:[A-Za-z]|\\[a-z]+(?: \{ \S+ \})?)(?: _ (?:\w|\{[^{}]*\})| ')* \^ (?:\w|\{ [\w ]+ \})")


# a letter with a minus, which capitals that are functions have as arguments as well
_NEGATIVE = re.compile(r"- (?:[A-Za-z]|\\[a-z]+)(?: _ (?:\w|\{[^{}]*\}))*")


def _holds_negative(place: Occurrence) -> bool:
    """Do the brackets behind it hold a letter with a minus, and nothing more?"""
    alone = len(place.arguments or ()) == 1 and not place.powered
    return alone and any(map(_NEGATIVE.fullmatch, place.arguments or ()))


# a gradient alone
_GRADIENT = re.compile(r"\\nabla (?:[A-Za-z]|\\[a-z]+(?: \{ \S+ \})?)(?: _ (?:\w|\{[^{}]*\}))*")
# and a change, which lengths, masses and coefficients are multiplied by
_CHANGED = re.compile(r"\\Delta (?:[A-Za-z]|\\[a-z]+)(?: _ (?:\w|\{[^{}]*\}))*")
_FUNCTIONS = frozenset("fFgGUV")  # letters of functions
_COEFFICIENTS = frozenset("abchkmn")


def _holds_gradient(place: Occurrence) -> bool:
    """Do the brackets behind it hold a gradient alone, or a change behind a coefficient?"""
    if place.arguments is None or len(place.arguments) != 1:
        return False
    (inside,) = place.arguments
    changed = place.word in _COEFFICIENTS and _CHANGED.fullmatch(inside)
    return bool(changed or _GRADIENT.fullmatch(inside))


def _holds_power(place: Occurrence) -> bool:
    """Do the brackets behind it hold a power alone?"""
    alone = len(place.arguments or ()) == 1 and place.superscript is None and not place.powered
    return alone and any(map(_POWER.fullmatch, place.arguments or ()))


def _is_constant(guess: Guess) -> bool:
    return guess.letter.kind == "scalar" and not guess.letter.depends


def _is_normed(of: Evidence) -> bool:
    """Does it stand between the signs of a norm, and beside a dot?"""
    normed = any(place.before == place.after == r"\|" for place in of.places)
    return normed and any(r"\cdot" in (place.before, place.after) for place in of.places)


def _equals_itself(of: Evidence) -> bool:
    """Is it equal to itself before arguments: W = W(x, y)?"""
    return any(
        a.arguments is None and b.arguments is not None and len(b.arguments) > 1 and a.after == b.before == "="
        for a, b in itertools.pairwise(of.places)
    )


def _before_sums(of: Evidence, every: Mapping[str, Evidence]) -> Iterator[Guess]:
    """A letter that stands before brackets only, of which some hold sums: a factor, or a function."""
    product = Guess(_letter(of, depends=""), "a number", "it stands before brackets with a sum")
    if of.turning:
        yield product
        return
    function = Guess(_letter(of, kind="function"), "a function", "it stands before brackets only")
    crossed = all(r"\times" in args[0].split() for args in of.arguments)  # which needs its brackets
    factor = crossed or all(args[0].lstrip()[:1].isdigit() for args in of.arguments)  # as in a(1 - x)
    matrix = Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it stands in brackets, or beside matrices")
    if of.spelling.isupper() and any(each.square for each in every.values()):
        yield matrix
        return
    if of.spelling.startswith("["):
        product = matrix
    constant = of.spelling in ("g", "G") and not any(map(is_shift, of.arguments))  # of gravity
    if (
        constant
        and all(place.before == "=" for place in of.places)
        and any(map(_AFFINE.match, (args[0] for args in of.arguments)))
    ):
        yield in_doubt(product, FACTOR)
        return
    weight = constant or (of.spelling == "g" and any(place.before in _MASSES for place in of.places))
    small = of.spelling[:1] == "\\" and of.spelling[1:2].islower() and of.spelling != r"\zeta"
    coefficient = factor and small  # as in \phi(1.4 - x)
    typical_stem = of.spelling[:1] == "\\" and _stem(of.spelling) in _TYPICAL
    typical = of.spelling in _TYPICAL and not weight and not coefficient
    indexed = of.spelling[:2] in ("f_", "F_", "g_", "h_", "J_") or _OF_ORDER.match(of.spelling) is not None
    if typical_stem and _holds_quotient(of):
        yield in_doubt(function, FACTOR)
        return
    doubtful = _holds_factors(of) and (typical or indexed or (len(of.spelling) == 1 and of.spelling.isupper()))
    if product is not matrix and not typical and (_is_hardly_factor(of) or _has_members_applied(of, every)):
        product = in_doubt(product, FACTOR)
    if of.spelling.startswith("F_") and any(map(_LEVEL.fullmatch, (args[0] for args in of.arguments))):
        product = in_doubt(product, FACTOR)  # a quantile
    if _is_stepped(of) or _is_earlier(of, every):
        yield function
    elif doubtful or (of.spelling in _MOVING and all(map(is_shift_of_time, of.arguments))):
        yield in_doubt(function, FACTOR)
    elif typical and (
        any(place.exponent for place in of.places) or (of.spelling != "f" and not all(map(is_shift, of.arguments)))
    ):
        yield from (in_doubt(function, FACTOR), product)
    else:
        related = any("=" in args[0].split() for args in of.arguments)  # which is no factor
        second = replace(function, remote=factor or constant, beside=not (factor or constant or related))
        yield from (function, product) if typical else (product, second)


# what is left of a level of significance
_LEVEL = re.compile(r"1 - \\alpha(?: / 2)?")


def _has_members_applied(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Does the same letter stand with another label of several letters, and before one letter in brackets only?"""
    stem, _, below = of.spelling.partition("_{")
    alike = (each for x, each in every.items() if x != of.spelling and x.startswith(stem + "_{"))
    return len(below) > len("x}") and any(
        bool(each.arguments) and not each.bare and all(len(args) == 1 and is_letter(args[0]) for args in each.arguments)
        for each in alike
    )


_SCRIPT = r"(?: (?:_ (?:\w|\\\w+|\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\})|'|\^ \{ (?:\\prime |' )*\}))*"
_AT = rf"(?:[xyzrst]|\\tau|\\mathbf \{{ [xyzr] \}}){_SCRIPT}"
# how far one place, or one time, is from another, which a kernel, a potential or a pulse is a function of
_DISTANCE = re.compile(rf"{_AT} - {_AT}")
_BETWEEN = re.compile(rf"\\mathbf \{{ r \}}{_SCRIPT} - \\mathbf \{{ r \}}{_SCRIPT}")  # of a field
# an index below
_BELOW = re.compile(r"_ (?:\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|\S+)")


def _is_hardly_factor(of: Evidence) -> bool:
    """Do the brackets hold a distance, a layer `W x + b`, or several sums, each without a number, as coefficients have?

    Coefficients such as a in `a(1 - e)` and k in `k_p(x - x_d)` have numbers there, or an index below.
    """
    texts = {args[0] for args in of.arguments}
    if any(place.powered for place in of.places) or any(len(args) > 1 for args in of.arguments):
        return False
    if any(r"\times" in text for text in texts):
        return False  # nobody applies a function to a cross product
    if any(map(_AFFINE.match, texts)) or (of.spelling == _stem(of.spelling) and any(map(_DISTANCE.fullmatch, texts))):
        return True
    return len(texts) > 1 and not any(map(str.isdigit, _BELOW.sub("", " ".join(texts))))


def _stem(spelling: str) -> str:
    return spelling.partition("_")[0]


def _is_stepped(of: Evidence) -> bool:
    """Does it stand before several times, of which some lie ahead, as in `v(t + h) = v(t - h) + ...`?"""
    times = {args[0] for args in of.arguments if is_shift_of_time(args)}
    return len(times) > 1 and len(times) == len({*of.arguments}) and any("+" in each.split() for each in times)


_STEP = re.compile(r"(\w|\\[a-z]+) [-+] \d")  # one step before or behind


def _is_earlier(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Does it stand before steps of a letter of which two others are functions, as in `E(t - 1) + a(t) - b(t)`?"""
    found = [_STEP.fullmatch(args[0]) if len(args) == 1 else None for args in of.arguments]
    if not all(found) or any(place.powered for place in of.places):
        return False
    steps = {match[1] for match in found if match}
    return len(steps) == 1 and sum((*steps,) in each.arguments for each in every.values()) > 1


_OF_ORDER = re.compile(r"[A-Z]_\{?\\")  # a Bessel function, say
_AFFINE = re.compile(r"[A-Z](?: _ \S+| _ \{[^{}]*\})* [a-z].*\+")  # W x + b, of which a layer is a function
_MOVING = frozenset("uvwxyqp")  # letters of what moves, or how fast


def _is_greek(latex: str) -> bool:
    """Is this the name of a Greek letter in upright type, as a number is called?"""
    word = latex.removeprefix(r"\text{").removesuffix("}")
    return word != latex and rf"\{word}" in LETTER_COMMANDS


def _holds_factors(of: Evidence) -> bool:
    """Do all brackets behind a Latin letter hold what may be a factor as well?"""
    latin = of.spelling[:1] != "\\" and of.spelling not in ("f", "F") and not any(p.powered for p in of.places)
    return latin and all(map(_FACTORS.match, (args[0] for args in of.arguments)))


def _holds_quotient(of: Evidence) -> bool:
    """Do all brackets behind it hold one fraction, which needs none as a factor?"""
    return not any(p.powered for p in of.places) and all(_QUOTIENT.fullmatch(args[0]) for args in of.arguments)


def _is_function(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Is a letter that stands before brackets only a function for certain, by its face or by what stands beside it?"""
    if of.spelling.startswith((r"\mathcal", r"\mathscr")) or _is_primed(of):
        return True
    accented = ACCENT.match(of.spelling)
    plain = every.get(of.spelling[accented.end() : -1]) if accented else None
    others = [each for each in every.values() if each.arguments and not each.bare and each is not of]
    return any(
        (any(map(is_lone, each.places)) or _is_primed(each))
        and (each is plain or bool(set(each.arguments) & set(of.arguments)))
        for each in others
    )


def _is_primed(of: Evidence) -> bool:
    return any(place.primes and place.arguments for place in of.places)


_SIZED = re.compile(r"(.+)_\{?(\d)\}?")  # a letter with a number below, as I_3
# what stands behind a letter that is no factor of what follows
_ENDS = frozenset(
    {"", "+", "-", "=", ")", "]", "}", ",", ".", ";", "&", r"\right", r"\\", r"\end", "^", "_", r"\pm", r"\mp"}
)
_IDENTITIES = frozenset({"I", r"\mathbf{I}", r"\bm{I}", r"\boldsymbol{I}", r"\mathbb{I}", r"\mathbf{1}"})


def _sized_identity(latex: str, every: Mapping[str, Evidence]) -> re.Match[str] | None:
    """An identity with its size below, such as I_3; beside an I_1 it is one of several."""
    sized = _SIZED.fullmatch(latex)
    if not sized or sized[1] not in _IDENTITIES:
        return None
    several = any(x != latex and (other := _SIZED.fullmatch(x)) and other[1] == sized[1] for x in every)
    return None if several else sized


def _matrix_size(every: Mapping[str, Evidence]) -> int | None:
    """The number of rows of matrices that are printed, said, capital and bold or beside transposes; 0 if unsaid."""
    found = None
    for each in every.values():
        if each.spelling in _IDENTITIES:
            continue
        if match := re.fullmatch(r"real (\d+) (\d+)", each.said):
            return int(match[1])
        if len(each.shape) == 2 and each.shape[0] == each.shape[1]:
            return each.shape[0]
        if each.said.startswith(("matrix", "skew matrix")):
            return 3
        transposed = each.transposed and "T" not in every
        if each.square or is_styled(each.spelling, capital=True) or transposed or _in_kronecker_product(each):
            found = 0
    return found


def _beside_vectors(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Does a dot or a cross stand between it and a vector, or is it the length of something with a hat?"""

    def is_vector(spelling: str) -> bool:
        each = every.get(spelling)
        styled = is_styled(spelling, capital=False) or spelling.startswith(r"\prescript")
        return each is not None and (
            styled or each.said == "vector" or re.fullmatch(r"real \d+", each.said) is not None
        )

    if of.spelling == r"\hbar" or any(face(x) == f"{of.spelling}}}" for x in every):
        return False  # the length of the same letter in bold type
    beside = {x for place in of.places for x in place.beside}
    accented = HAT.match(of.spelling) is not None or _is_dotted(of)
    dotted = map(_is_dotted, every.values()) if accented else [_is_dotted(of)]
    if any(dotted) and any(map(HAT.match, every)):
        return True
    return (any(map(is_vector, beside)) and not of.factor and of.spelling != "t") or (
        accented and any(p.before in ("|", r"\|") and p.after in ("|", r"\|") for p in of.places)
    )


def _is_dotted(of: Evidence) -> bool:
    """Does a dot stand between it and another letter, where both have accents?"""
    near = {x for p in of.places if r"\cdot" in (p.before, p.after) for x in p.beside}
    if of.spelling.startswith(r"\nabla"):
        return any(is_accented(x) or x.startswith(r"\nabla") for x in near)
    return bool(is_accented(of.spelling)) and any(is_accented(x) or x.startswith(r"\nabla") for x in near)


def _as_said(of: Evidence, every: Mapping[str, Evidence]) -> Guess:
    """A letter of which something is said."""
    phrase, why = of.said, SAID
    if phrase in ("scalar", "constant", "integer"):
        whole = phrase == "integer"
        return Guess(_letter(of, depends="", integer=whole), "a whole number" if whole else "a real number", why)
    if match := re.fullmatch(r"the number (\d+)", phrase):
        return Guess(Letter(of.spelling, value=int(match[1]), name=variable_name(of.spelling)), phrase, why)
    if phrase == "complex":
        return Guess(_letter(of, depends=""), COMPLEX, why)
    if phrase == "index":
        return Guess(Letter(of.spelling, kind="index", name=variable_name(of.spelling)), "an index", why)
    if phrase == "differential":
        return Guess(Letter(of.spelling, kind="differential"), "the sign of a differential", why)
    if phrase == "imaginary unit":
        return Guess(Letter(of.spelling, number="i"), "the imaginary unit", why)
    depends = time(every) if of.dotted else ""
    if match := re.fullmatch(r"(constant )?(vector|matrix)(?: that depends on (.+))?", phrase):
        on = "" if match[1] else match[3] or depends
        return Guess(_letter(of, kind=match[2], depends=on), f"a {match[1] or ''}{match[2]}", why)
    if match := re.fullmatch(r"(function of|depends on) (.+)", phrase):
        on = match[2]
        if match[1] == "function of":
            return Guess(_letter(of, kind="function", depends=on), f"a function of {on}", why)
        if not any(place.before == r"\partial" for place in of.places):
            on = ", ".join(dict.fromkeys(y for x in on.split(", ") for y in _at_last(x, every, {of.spelling})))
        return Guess(_letter(of, kind="scalar", depends=on), f"a function of {on}", why)
    if phrase == "identity matrix":
        rows = _matrix_size(every)
        return Guess(_letter(of, kind="matrix", size=(rows, rows) if rows else (), identity=True), "the identity", why)
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
        "constant vector, vector that depends on t, matrix, integer, index, function of x, depends on t, differential, "
        "imaginary unit, identity matrix, rotation or skew matrix of a vector"
    )


def _number(of: Evidence, every: Mapping[str, Evidence]) -> list[Guess]:
    """What e, i, j and pi may be."""
    latex = of.spelling
    derived = any(p.role == "derived" and p.before in ("d", r"\partial") and p.superscript is None for p in of.places)
    alone = all(place.before in ("", "=", "&", r"\\") and not place.powered for place in of.places)
    if latex == r"\pi" and not of.bare and _common_arguments(of):
        if not (alone or of.by or any(place.before.isdigit() or place.powered for place in of.places)):
            function = Guess(_letter(of, kind="function"), "a function", "it stands before one letter in brackets")
            return [in_doubt(function, "the number pi, or a function? say what it is")]
        if alone:
            return []  # a profit, or a policy
    if latex != r"\pi" and (of.dotted or (of.arguments and _common_arguments(of)) or derived):
        return []  # a number depends on nothing
    if latex == r"\pi":
        number = Guess(Letter(latex, number="pi"), "the number pi", "so it is written")
        defined = any(place.before in ("", "&", r"\\") and place.after == "=" for place in of.places)
        others = any(x != latex and not each.index and each.said != "differential" for x, each in every.items())
        doubt = "the number pi, or a letter that is defined here? say what it is"
        return [in_doubt(number, of.doubt or doubt) if of.doubt or (defined and others) else number]
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
            return [replace(letter, why=ECCENTRICITY), replace(euler, remote=True)]
        if latex != "e" or all(variable):
            return [euler]
        if any(variable) or of.endless:
            return [euler, replace(letter, remote=any(variable))]
        return [letter, euler]
    if latex in ("i", "j", r"\text{i}", r"\text{j}"):
        ordered = any({place.before, place.after} & _ORDERED for place in of.places)
        if (of.below or ordered) and all(map(_is_compared, of.places)):
            return [
                Guess(_letter(of, depends="", name=variable_name(latex)), "a real number", "it is an index elsewhere")
            ]
        if {"i", "j"} <= every.keys() and not any(p.exponent for key in "ij" for p in every[key].places):
            doubt = "a unit of quaternions, an index, or the imaginary unit? say what it is"
            return [Guess(replace(_letter(of, depends=""), doubt=doubt), "a letter in doubt", "i and j stand here")]
        unit = Guess(Letter(latex, number="i"), "the imaginary unit", "so it is written")
        plain = Guess(
            _letter(of, depends="", name=variable_name(latex)), "a real number", "it is a letter like others", True
        )
        if latex[0] == "\\" or any(place.exponent for place in of.places):
            return [unit]
        if any((place.before, place.after) == ("", "=") and not place.superscript for place in of.places):
            return [replace(plain, why="it is equal to something", remote=False), unit]
        if any(place.after == r"\in" for place in of.places):
            return [replace(plain, why="it is a member of a set", remote=False)]
        if any((place.before, place.after) == ("(", ",") for place in of.places):
            return [replace(plain, why="a list begins with it", remote=False), unit]
        if of.below or of.orbital:
            return [replace(plain, why="it is an index or an angle elsewhere", remote=False)]
        return [unit, plain]
    return []


_ORDERED = frozenset({"<", ">", r"\le", r"\leq", r"\ge", r"\geq"})  # what no imaginary number is
_COMPARED = frozenset({"=", r"\ne", r"\neq", "<", ">", r"\le", r"\leq", r"\ge", r"\geq"})


def _is_compared(place: Occurrence) -> bool:
    """Does it bound a sum, or stand beside the sign of a relation as an index does and the imaginary unit does not?"""
    return place.role in ("bound", "subscript") or place.before in _COMPARED or place.after in _COMPARED


def _common_arguments(of: Evidence) -> tuple[str, ...]:
    """The letters that stand in brackets behind it wherever there are any: (x, t)."""
    found = set(of.arguments)
    if len(found) != 1:
        return ()
    (args,) = found
    return args if all(tex.spelled(arg) is not None for arg in args) else ()


def _may_be_factor(of: Evidence) -> bool:
    """Could it be multiplied with what stands in brackets behind it, which is more than a letter or a number?"""
    return all(
        place.arguments is None
        or (len(place.arguments) == 1 and (place.powered or not _needs_none(place.arguments[0])))
        for place in of.places
    )


def _needs_none(text: str) -> bool:
    """Would brackets around this be idle, or a number with a sign, if it were a factor?"""
    return is_idle(text) or is_signed(text)


def _varies(of: Evidence) -> bool:
    defined = any(p.after == "=" and p.arguments is None for p in of.places)  # as in x = x(t)
    return all(place.dots or place.primes or place.arguments is not None for place in of.places) or bool(
        (defined and len(of.arguments) == 1) or of.dotted or any(place.role == "derived" for place in of.places)
    )


CONSTANT = "constant"
PRINTED = "it is equal to one that is printed"
MOVING = "it is differentiated"


def _primed_by(of: Evidence, every: Mapping[str, Evidence]) -> str:
    """The letter by which primes differentiate a function that is printed with its argument and without it; or ""."""
    if not any(place.primes and place.arguments is None for place in of.places):
        return ""
    inside = {place.arguments[0] for place in of.places if is_lone(place) and place.arguments}
    own = {x for x in inside if is_letter(x) and "_" not in x} or {x for x in ("x", "t", "s") if x in every}
    return own.pop() if len(own) == 1 else ""


def _dependent(of: Evidence, every: Mapping[str, Evidence], named: bool) -> Iterator[Guess]:
    """A letter with dots, or one in a derivative."""
    on = _variables(of, every)
    words = ", ".join(on)
    if not on:
        yield Guess(_letter(of, depends="", named=named), "a real number", "others depend on it")
        return
    if of.shape:
        kind = "matrix" if len(of.shape) > 1 else "vector"
        yield Guess(_letter(of, kind=kind, depends=words, size=of.shape, named=named), f"a {kind}", PRINTED)
        return
    if of.capital:
        kinds = (
            ("matrix",)
            if of.multiplied
            else ("vector",)
            if of.crossed or _is_field(of, every)
            else ("matrix", "vector")
        )
        for kind in kinds:
            yield Guess(_letter(of, kind=kind, depends=words, named=named), f"a {kind}, a function of {words}", MOVING)
        return
    kind = of.framed or ("vector" if face(of.spelling) else "scalar")
    primed = any(place.primes for place in of.places)
    behind = any(
        place.role == "derived" and place.before in ("d", r"\partial") and not _goes_on(place.after)
        for place in of.places
    )
    direct = of.dotted or primed or behind
    within = any(x in every and _stands_in_body(every[x]) for x in on)
    within |= any(place.role == "variable" and place.before == r"\partial" for place in of.places)
    varying = Guess(_letter(of, kind=kind, depends=words, named=named), f"a function of {words}", MOVING)
    if of.dotted and primed:
        yield in_doubt(varying, "do its primes say the same as its dots? write one of them")
        return
    constant = Guess(
        _letter(of, kind=kind, depends=""), CONSTANT, "it has no dot, and the other letter stands beside it"
    )
    if direct or named:
        yield varying
    elif within:
        yield constant
    elif any(each.dotted for each in every.values()):
        yield constant
        yield replace(varying, remote=kind != "vector")  # directions turn
    else:
        yield varying
        yield constant


def _variables(of: Evidence, every: Mapping[str, Evidence]) -> list[str]:
    """The letters on which a letter depends: for dr/dt and for dr/du too it is t, where u depends on t."""
    own = [time(every)] if of.dotted else []
    own += [x for x in of.by if x not in own and x != of.spelling]
    if any(place.before == r"\partial" or place.arguments for place in of.places):
        return own
    seen = {of.spelling} - {time(every)}
    return list(dict.fromkeys(x for each in own for x in _at_last(each, every, seen) if x != of.spelling))


def _at_last(name: str, every: Mapping[str, Evidence], seen: Set[str]) -> list[str]:
    """The letters on which a letter depends that depend on no others; they are itself if there are none."""
    each = every.get(name)
    if each is None or name == time(every):
        return [name]
    said = re.fullmatch(r"depends on (.+)", each.said)
    moved = any(place.role == "derived" and place.before == "d" for place in each.places)
    own = said[1].split(", ") if said else [time(every)] if each.dotted else each.by if moved and not each.said else []
    further = [x for x in own if x not in seen and x != name]
    return [x for each in further for x in _at_last(each, every, seen | {name})] or [name]


def _goes_on(token: str) -> bool:
    """Does a product go on with this token?"""
    return tex.is_letter(token) or token in OVER | FUNCTIONS_SPELLED | FACTORS


# what factors of a product begin with that are more than a letter
FACTORS = frozenset({r"\sqrt", r"\cdot", r"\times", r"\left", "(", "[", "{", "|", r"\|"}) | FRACTIONS


def _stands_in_body(of: Evidence) -> bool:
    return any(place.role == "derived" and (place.before, place.after) != ("(", ")") for place in of.places)


def _of_vectors(of: Evidence, simple: Sequence[str]) -> Iterator[Guess]:
    """A bold letter that stands before its arguments only: a function whose values are vectors or matrices."""
    depends = ", ".join(simple) if simple else None
    kinds = (("matrix", (0, 0)), ("vector", (0,)))
    for kind, size in kinds[:1] if of.multiplied else kinds if of.capital else kinds[1:]:
        told = f"a function whose values are {'matrices' if kind == 'matrix' else 'vectors'}"
        yield Guess(_letter(of, kind="function", depends=depends, size=size), told, "it stands before its arguments")


# a bold k
_WAVE_VECTOR = re.compile(r"(?:\\hat\{)?\\(?:mathbf|boldsymbol|bm|vec)\{k\}+(?:_.*)?")
_FIELDS = re.compile(r"\\(?:mathbf|boldsymbol|bm|vec)\{([EBHD])\}(?:_.*)?")  # letters of fields


def _is_field(of: Evidence, every: Mapping[str, Evidence]) -> bool:
    """Is it the electric field, or one beside it, as another field, a wave vector or a rate of it shows?"""
    if not (own := _FIELDS.fullmatch(of.spelling)) or of.multiplied:
        return False
    found = {match[1] for x in every if (match := _FIELDS.fullmatch(x)) and not every[x].transposed}
    waves = any(_WAVE_VECTOR.fullmatch(x) for x in every)
    rates = own[1] == "E" and any(place.before == r"\partial" for place in of.places)
    return "E" in found and (len(found) > 1 or waves or rates)


def _styled(of: Evidence, every: Mapping[str, Evidence]) -> Iterator[Guess]:
    """A bold letter, or one with an arrow."""
    shifted = all(is_shift_of_time(args) or _BETWEEN.fullmatch(args[0]) for args in of.arguments)
    if of.arguments and not of.bare and shifted:
        yield in_doubt(Guess(_letter(of, kind="vector", depends=""), "a vector", "it is bold, or has an arrow"), FACTOR)
        return
    vector = Guess(_letter(of, kind="vector", depends=""), "a vector", "it is bold, or has an arrow")
    matrix = Guess(_letter(of, kind="matrix", depends=""), "a matrix", "it is bold and capital")
    if TENSOR.search(of.spelling.replace(" ", "")):
        yield replace(matrix, why="two lines stand below it")
        return
    if not of.capital or of.spelling.startswith(r"\underline"):
        yield vector
        return
    ends = {(place.before.replace("\\", ""), place.after.replace("\\", "")) for place in of.places}
    long = ("|", "|") in ends or {("|", "-"), ("-", "|")} <= ends  # or a distance
    if of.multiplied:
        yield matrix
    elif of.crossed or _is_field(of, every):
        yield vector
    else:
        near = {x for p in of.places if r"\cdot" in (p.before, p.after) for x in p.beside}
        dotted = any(face(x) and not is_styled(x, capital=True) for x in near)
        yield from (vector, matrix) if (long or dotted) and not of.transposed else (matrix, vector)


def _letter(of: Evidence, **given: object) -> Letter:
    values = tuple(range(min(of.values, default=1), max(of.values, default=3) + 1))
    given.setdefault("name", variable_name(of.spelling))
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
def variable_name(latex: str) -> str:
    """The name of the variable that stands for a letter."""
    for sign, word in _SPOKEN.items():
        latex = latex.replace(sign, f" {word} ")
    name = re.sub(r"[^A-Za-z0-9]+", "_", re.sub(r"\\(mathbf|boldsymbol|bm|text|mathrm)\b", "", latex)).strip("_")
    return name if name[:1].isalpha() else f"x{name}"
