r"""Letters side by side that may be one name: `UA`, `rpm`, `LHV`, beside the products `mg` and `Ax`.

Print does not tell a name of several letters in italics from a product. It is a product where each of its letters
stands elsewhere without the others; otherwise it may be either, and what is usual decides the products below alone.
"""

from __future__ import annotations

import itertools
import re
import string
from collections import Counter
from collections.abc import Collection, Iterator, Sequence

ONE_NAME = "one name"  # how the doubt begins
# names, environments and frames, whose letters are no factors
_NAMED = re.compile(
    r"\\(?:text|mathrm|operatorname|begin|end|mathbf|mathsf|bm|boldsymbol|pmb|mathcal|mathbb|mathscr|mathfrak|"
    r"prescript|vec|hat|widehat|bar|tilde|overline|dot|ddot) (?:\{(?:[^{}]|\{[^{}]*\})*\}|\S)(?: \{ [lcr |]+ \})?"
)
# a subscript
_BELOW = re.compile(r" ?_ (?:\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\S+)")
_NUMBER_BELOW = re.compile(r" ?_ (?:\d|\{ \d+ \})")  # the subscript of a component
# the sign of a differential
_DIFFERENTIAL = re.compile(r"(?<![A-Za-z\\])d (?:\^ (?:\w|\{ \w+ \}) )?(?=[A-Za-z])")
_OF_EULER = re.compile(r"(?<![A-Za-z\\])e (?=\^ (?!\d|\{ \d+ \}))")  # the base of a power in letters
_RAISED = re.compile(
    r"([A-Za-z]) (?=\^ (?:[A-Za-z\\]|\{ (?:- )?[A-Za-z\\]))"
)  # to a power in letters, as one letter is
_CHANGE = re.compile(r"\\[Dd]elta [A-Za-z](?= [A-Za-z] _)")  # a change, and a letter with an index behind it
_FUNCTION = re.compile(r"\\(?:sin|cos|tan|ln|log|exp) [^+=()-]*?\\cdot")  # whose argument a dot ends
# what shows that a d is one
_DERIVATIVE = re.compile(r"\\int|\{ d |^d [A-Za-z] =")
# letters side by side
_LETTERS = re.compile(r"(?<![A-Za-z\\])[A-Za-z](?: [A-Za-z])*(?![A-Za-z])")
# what shows that capitals are matrices
_OF_MATRICES = re.compile(
    r"\^ (?:T|\{ (?:T|\\top) \}|\\top)(?![A-Za-z])|\\det(?![A-Za-z])|m a t r i x"
    r"|(?:[A-Z] (?:_ (?:\w|\{[^{}]*\}) )?|\\[a-z]+ \{ [A-Z] \} |[)\]] )\^ \{ - 1 \}"
)
# a sign of multiplication between numbers, which nobody prints who puts factors side by side
_SIGN = re.compile(
    r"[A-Za-z0-9}_)] (?:\\cdot|\*) "
    r"(?:[A-Za-z(]|\\(?:left|frac|text|mathrm|eta|Delta|dot|sin|cos|tan|exp|sqrt)(?![A-Za-z]))"
)
# what shows that letters are vectors
_OF_VECTORS = re.compile(r"\\(?:mathbf|bm|boldsymbol|vec|nabla|hat|pmb|bar)(?![A-Za-z])")
# weights and gravity, gases, circuits, ways and times
_USUAL = re.compile(r".*mg.*|[Mm]g[hl]?|G[Mm]{1,2}|[nz]?RT|kT|RC|LC|r\w|i[A-Z]?\w")
_GREEK = frozenset({"mu", "nu", "xi", "pi"})  # typed without a backslash
# in italics, without brackets
_SPELLED = frozenset({
    "max", "min", "sup", "inf", "var", "cov", "avg", "std", "det", "ln", "log", "exp", "sin", "cos", "tan", "lim",
    "arg",
})  # fmt: skip
_CAPACITIES = frozenset({"Cp", "Cv"})  # of heat
_DEFINED = frozenset({"RT", "RC", "LC", "GM"})  # usual products, of which none is a whole left side
# two letters among the arguments of what is defined: `H(x, sf) =`
_ARGUMENT = re.compile(
    r"(?:^|& |\\\\ )\\?[A-Za-z]+ (?:_ (?:\w|\{[^{}]*\}) )?\( (?:[a-z] , )+([a-z]) ([a-z]) (?:, [a-z] )*\)(?: &)? ="
)
# what is called an identity, with an index below
_IDENTITY = re.compile(r"(?<![A-Za-z\\])(?<![A-Za-z] )i d _ ")
# a letter with itself as its index, behind another one: `bu_u`
_INDEXED_BY_ITSELF = re.compile(r"(?<![A-Za-z\\])(?<![A-Za-z] )([a-z]) ([a-z]) _ (?:\{ )?\2(?: \})?(?![A-Za-z])")
_UNITS = frozenset(
    {"kg", "km", "cm", "mm", "Hz", "kHz", "MHz", "Pa", "kPa", "MPa", "kN", "kJ", "kW", "eV", "keV", "MeV"}
)
_DOUBLED = frozenset(2 * letter for letter in string.ascii_uppercase)  # which is no power of a letter with an index
_APPLIED = re.compile(r"[A-DF-Z][fpqtuvwxyz]|E[fptuvwxyz]")  # a matrix or an operator before what it is applied to
_NO_VECTORS = frozenset("fpt")  # which hardly stand behind a matrix that is a whole left side with them
# two letters that are said to be their product
_OWN_PRODUCT = re.compile(
    r"(?:^|& )([A-Z]) ([A-Za-z]) (?:& )?= (?:& )?\1 (?:\\cdot|\\times|\*) \2(?= ?(?:[.,;&]|\\\\|\\q?quad|$))"
)
_FACTORS_FIRST = frozenset("gkmd")  # gravity, springs, masses, differentials
LONGEST = 3  # small letters of which one that stands elsewhere shows that they are factors
# a name with a digit on the line: `q1`, beside which others may be typed so, too
_TYPED = re.compile(r"\\text \{ [a-z] \d \}")
_CAPITAL_FIRST = re.compile(r"[A-Z][a-z]")  # as in `Tc`
# a number before a matrix
_FACTOR_FIRST = re.compile(r"[a-z][A-Z]")


def doubted(formulas: Sequence[str]) -> dict[str, str]:
    """The letters of what may be one name, or a product, each with its doubt; formulas have their tokens apart."""
    texts = [_apart(text) for text in formulas]
    runs = Counter(run for text in texts for run in _runs(text))
    several = [run for run in runs if len(run) > 1]
    found = dict(_prefixed(formulas)) if any(r"\text {" in text for text in formulas) else {}
    found |= dict.fromkeys(_unsigned(formulas, texts), "a factor before brackets, or a function? say what it is")
    for text in formulas:
        for first, second in _INDEXED_BY_ITSELF.findall(text) if " _ " in text else ():
            found |= dict.fromkeys((first, second) if first != "d" else (), _told(first + second))
    if any(map(_IDENTITY.search, formulas)):
        found |= dict.fromkeys("id", _told("id"))
    for text in formulas:
        for first, second in _OWN_PRODUCT.findall(text):
            found |= dict.fromkeys((first, second), _told(first + second))
    for run in {"".join(run) for text in formulas if " , " in text for run in _ARGUMENT.findall(text)}:
        found |= dict.fromkeys(run if runs[run] == 1 else (), _told(run))
    if not several:
        return found
    signed = any(_SIGN.search(_FUNCTION.sub("", text)) for text in formulas) and not any(
        map(_OF_VECTORS.search, formulas)
    )
    matrices = any(map(_OF_MATRICES.search, formulas))
    typed = any(map(_TYPED.search, formulas))
    for run in _abbreviated(several, runs):
        found |= dict.fromkeys(run, _told(run))
    for run in several:
        if run[0] in "ij" and any(map(re.compile(rf"(?<![A-Za-z])e \^ \{{ (?:- )?{' '.join(run)}").search, formulas)):
            continue  # the imaginary unit and what it is multiplied with
        alone = {x for x in run if not _stands_elsewhere(x, run, runs)}
        if not alone and _CAPITAL_FIRST.fullmatch(run) and _is_numbered(run[1], texts):
            alone = set() if _is_numbered(" ".join(run), texts) else {run[1]}
        sequence = alone == {run[-1]} and runs[run] > 1 and _stands_before(r"\[", run, texts)
        doubled = run in _DOUBLED and all(_stands_before("[_,]", each, texts) for each in (run, run[0]))
        if sequence or doubled:
            found |= dict.fromkeys(run, _told(run))
            continue
        left = run[0] not in _FACTORS_FIRST and any(
            re.match(rf"(?:& )?{' '.join(run)}_ (?:& )?=", text.strip()) for text in texts
        )
        opening = any(re.match(rf"(?:.*\\\\ )?(?:& )?{' '.join(run)} (?:& )?= ", text.strip()) for text in texts)
        if len(run) == LONGEST and run.islower() and opening and run[0] not in _FACTORS_FIRST:
            found |= dict.fromkeys(run, _told(run))
        if alone and left and len(run) == 2 and run.islower():
            found |= dict.fromkeys(alone, _told(run))
        if run[0] in alone and _is_defined(run, alone, texts):
            found |= dict.fromkeys(alone, _told(run))
            continue
        if alone and typed and len(run) == 2 and run.islower() and run[0] not in _FACTORS_FIRST:
            found |= dict.fromkeys(alone, _told(run))
            continue
        unit = run in _UNITS and any(f"{{ {' '.join(run)} }}" in text for text in texts)  # all of a part of a fraction
        if unit or (
            alone
            and (signed or not _is_coefficient(run, alone, runs))
            and _may_be_name(
                run,
                alone,
                signed=signed,
                matrices=matrices,
                named=_is_name_on_sight(run, several, texts),
                whole=any(re.match(rf"(?:& )?{' '.join(run)} (?:& )?=", text.strip()) for text in texts),
            )
        ):
            found |= dict.fromkeys(alone or run, _told(run))
    return found


def _is_defined(run: str, alone: Collection[str], texts: Sequence[str]) -> bool:
    """Are two small letters one side, and the other one more than a letter or a number: `hs = 4 \\sqrt{m}`?

    Numbers below the second one, as in `hk_1`, may be part of the name.
    """
    if not re.fullmatch(r"[^dgkm\W\d_A-Z][^d\W\d_A-Zt-z]", run):
        return False
    printed = " ".join(run) if len(alone) == 2 else f"{' '.join(run)},"
    pairs = [each for text in texts if len(each := re.split(r" (?:& )?= (?:& )?", text.strip(" .,;&"))) == 2]
    return any(
        side.strip() == printed and re.search(r"\\d?frac|\\sqrt|[-+]|\\exp|\^", other)
        for pair in pairs
        for side, other in itertools.permutations(pair)
    )


def _is_numbered(run: str, texts: Sequence[str]) -> bool:
    """Have these letters a number below wherever they stand alone, as a coefficient has?"""
    printed = rf"(?<![A-Za-z\\])(?<![A-Za-z] ){run}(?! [A-Za-z])(,?)"
    places = [found[1] for text in texts for found in re.finditer(printed, text)]
    return bool(places) and all(places)


def _told(run: str) -> str:
    return f"{ONE_NAME} {run}, or a product? say what its letters are, or write \\mathrm{{{run}}}"


# letters in bold type under one command
_BOLD_RUN = re.compile(r"\\(?:mathbf|textbf|boldsymbol|bm|pmb|mathsf)\s*\{\s*([A-Za-z](?:\s*[A-Za-z])*)\s*\}")

_MATRICES_APPLIED = re.compile(r"[A-NP-Z]+[a-np-z]")  # before a vector; an o is hardly a letter


def bold_name(source: str) -> str:
    """The letters under one command for bold type that may be one name: `Op`, but neither `Ax` nor `CD`."""
    runs = Counter(re.sub(r"\s", "", run) for run in _BOLD_RUN.findall(source))
    for run in runs:
        alone = {x for x in run if len(run) > 1 and not _stands_elsewhere(x, run, runs)}
        product = _MATRICES_APPLIED.fullmatch(run)
        column_first = alone and _FACTOR_FIRST.fullmatch(run)  # which no matrix is multiplied by
        named = alone and not product and _may_be_name(run, alone, signed=False, matrices=True, named=False)
        if run == "Id" or column_first or named:
            return run
    return ""


def _abbreviated(several: Sequence[str], runs: Collection[str]) -> Iterator[str]:
    """Pairs with a letter in common none of which stands anywhere else: `IE - EA`, but not `AB - BA`; `lb` and `ub`.

    Small letters have the last one in common, or are counted along the axes: `nx` and `ny`.
    """
    along = [run for run in several if len(run) == 2 and run.islower() and run[0] != "d" and run[1] in "xyz"]
    for run in along:
        alike = [other for other in along if other[0] == run[0] and other != run]
        if alike and not any(run[0] in other for other in runs if other not in along):
            yield run
    for small in (False, True):
        pairs = [run for run in several if len(run) == 2 and (run.islower() if small else run.isupper())]
        pairs = [run for run in pairs if run[0] != "d"]  # no differentials
        others = {letter for run in runs if run not in pairs for letter in run}
        for run in pairs:
            alike = [x for x in pairs if x != run and (x[1] == run[1] if small else {*x} & {*run})]
            if (
                0 < len(alike) < (2 if small else len(pairs))
                and run[::-1] not in pairs
                and not {*run, *"".join(alike)} & others
            ):
                yield run


def _stands_before(token: str, run: str, texts: Sequence[str]) -> bool:
    """Does a bracket or an index stand behind these letters everywhere, as behind the name of a sequence?"""
    printed = rf"(?<![A-Za-z\\]){' '.join(run)}(?:( ?{token})|(?! [A-Za-z]))"
    places = [found[1] for text in texts for found in re.finditer(printed, text)]
    return bool(places) and all(places)


# a letter without a sign before brackets that hold a sum
_BEFORE_SUM = re.compile(r"(?<![A-Za-z\\])([A-Za-z]|\\[a-z]+) (?:\\left )?\( (?=[^()]*[+-])")


def _unsigned(formulas: Sequence[str], texts: Sequence[str]) -> Iterator[str]:
    """The letters without a sign before brackets that hold a sum, where signs stand between all other factors."""
    for formula, text in zip(formulas, texts, strict=True):
        if len(_SIGN.findall(formula)) > 1 and all(len(run) == 1 for run in _runs(text)):
            yield from _BEFORE_SUM.findall(formula)


# a letter before an abbreviation in upright capitals, without a sign
_PREFIX = re.compile(r"(?:^|[=(+-] |& )(\\[a-z]+|[a-z]) \\text \{ ((?:[A-Z] )+[A-Z]) \}")


def _prefixed(formulas: Sequence[str]) -> Iterator[tuple[str, str]]:
    """The letters before abbreviations neither of which stands anywhere else: that of `\\mu\\text{FA}`."""
    for text in formulas:
        for letter, word in _PREFIX.findall(text):
            tokens = [token for each in formulas for token in _BELOW.sub("", each).split()]
            if tokens.count(letter) == 1 and sum(each.count(f"{{ {word} }}") for each in formulas) == 1:
                yield letter, _told(letter + word.replace(" ", ""))


def _apart(text: str) -> str:
    text = _CHANGE.sub(
        "", _RAISED.sub(r", \1 ", _OF_EULER.sub("", _BELOW.sub("_", _NUMBER_BELOW.sub(",", _NAMED.sub(r"\\", text)))))
    )
    return _DIFFERENTIAL.sub(", ", text) if _DERIVATIVE.search(text) else text


def _runs(text: str) -> Iterator[str]:
    return (match[0].replace(" ", "") for match in _LETTERS.finditer(text))


def _stands_elsewhere(letter: str, run: str, runs: Collection[str]) -> bool:
    """Does a letter of a run stand anywhere alone, or at another place of another run; a small one, at any?

    Of long runs in small letters one shows nothing of another: both may be words.
    """
    small = letter.islower() and len(run) == 2 and run.islower()
    if len(run) > 2 and run.islower():
        runs = [other for other in runs if len(other) < 3 or not other.islower()]
    return any(
        other == letter or any(x == letter and (small or run[k : k + 1] != letter) for k, x in enumerate(other))
        for other in runs
        if other != run and not (small and len(other) == 2 and other[1] == run[1])
    )


def _is_coefficient(run: str, alone: Collection[str], runs: Collection[str]) -> bool:
    """Is it a capital before a small letter that stands elsewhere, among capitals that stand alone, as in `Bs + C`?"""
    return (
        len(run) == 2
        and run[0].isupper()
        and run[1].islower()
        and {*alone} == {run[0]}
        and any(len(other) == 1 and other.isupper() for other in runs)
    )


def _is_name_on_sight(run: str, runs: Collection[str], texts: Sequence[str]) -> bool:
    """Is a run in capitals a whole left side, or one of several with one end; has one in small letters an index?

    Nor is a product said to be something of several arguments.
    """
    printed = " ".join(run)
    if run.isupper():
        paired = any(
            len(other) == 2 and other.isupper() and other[0] != run[0] and other[1] == run[1] for other in runs
        )
        return (len(run) == 2 and paired) or any(
            re.match(rf"(?:& )?{printed}_?(?: ')?(?: \( [^()]* \))?(?: &)? =", text.strip()) for text in texts
        )
    if any(re.match(rf"(?:& )?{printed}_? \( [^()]*,[^()]* \)(?: &)? =", text.strip()) for text in texts):
        return True  # a distance, say
    places = [found[1] for text in texts for found in re.finditer(rf"(?<![A-Za-z\\]){printed} ?(_?)", text)]
    return run[0] not in _FACTORS_FIRST and all(places)


def _may_be_name(
    run: str, alone: Collection[str], *, signed: bool, matrices: bool, named: bool, whole: bool = False
) -> bool:
    """May these letters, of which some stand nowhere else, be one name?"""
    if "o" in run or "O" in run or run in _GREEK | _SPELLED | _CAPACITIES:  # an o is hardly a letter
        return True
    if len({*run}) > 2 and not run.isupper() and 2 * len(alone) <= len({*run}):
        return False
    if (_USUAL.fullmatch(run) and not (named and run in _DEFINED)) or (
        _APPLIED.fullmatch(run) and not signed and not (whole and run[1] in _NO_VECTORS)
    ):
        return False
    if signed or (whole and ((len(alone) == 2 and run[1] in _NO_VECTORS) or _FACTOR_FIRST.fullmatch(run))):
        return True
    if run.isupper() and len(run) == 2 and len(alone) < len({*run}):
        return named and not matrices
    if run.isupper():
        return named or not matrices
    if len(run) == 2 and (run.islower() or _FACTOR_FIRST.fullmatch(run)):
        return named and len(alone) == 2 and run.islower()
    return not run.islower() or len(run) > LONGEST or len(alone) == len({*run})
