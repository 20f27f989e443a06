r"""The surface of LaTeX made plain: layout without meaning is taken away, and spellings of one thing become one.

`{\bf x}` is `\mathbf{x}`, `{x}` is `x`, `{a \over b}` is `\frac{a}{b}`, `\lvert x \rvert` is `|x|`. What is printed
stays what it is: nothing is dropped that a reader sees, but phantoms, colours, labels and notes under braces.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.commands import ACCENTS, ARGUMENTS, LETTER_COMMANDS, OVER, ROMAN, STYLES
from symcheck.reading.functions import COMMANDS
from symcheck.reading.phrases import phrased
from symcheck.reading.side_by_side import bold_name
from symcheck.reading.typed import typed

FONTS = {  # switches that hold to the end of their group
    r"\bf": r"\mathbf", r"\bm": r"\bm", r"\pmb": r"\pmb", r"\boldsymbol": r"\boldsymbol", r"\rm": r"\mathrm",
    r"\cal": r"\mathcal", r"\it": "", r"\sf": r"\mathsf", r"\tt": r"\mathrm",
    r"\mathbf": r"\mathbf", r"\mathrm": r"\mathrm",
}  # fmt: skip
SAME = {  # other spellings
    r"\lvert": "|", r"\rvert": "|", r"\vert": "|", r"\lVert": r"\|", r"\rVert": r"\|", r"\Vert": r"\|",
    r"\cfrac": r"\frac", r"\nicefrac": r"\frac", r"\sfrac": r"\frac", r"\mathds": r"\mathbb", r"\>": r"\:",
    "−": "-", r"\dotsc": r"\dots", r"\dotsb": r"\dots", r"\dotsm": r"\cdots", r"\hdots": r"\dots",
    r"\textrm": r"\text", r"\mbox": r"\text", r"\textnormal": r"\text", r"\mathop": "", r"\mathrel": "",
    r"\mathbin": "",
    r"\mathord": "", r"\ensuremath": "", r"\boxed": "", r"\smash": "", r"\coloneqq": "=", r"\triangleq": "=",
    r"\overrightarrow": r"\vec", r"\mathbfit": r"\mathbf", r"\textbf": r"\mathbf", r"\mathit": "", r"\mathnormal": "",
    r"\mathtt": r"\mathrm", r"\boldmath": r"\mathbf", r"\textit": "", r"\textsf": r"\mathsf", r"\texttt": r"\text",
    r"\symbf": r"\mathbf",
    r"\enspace": r"\ ", r"\thinspace": r"\,", r"\medspace": r"\:",
    r"\thickspace": r"\;", r"\negthinspace": r"\!", r"\lbrack": "[", r"\rbrack": "]", r"\wedge": r"\wedge",
    r"\leqq": r"\le", r"\gets": r"\leftarrow", r"\iff": r"\iff", r"\longleftarrow": r"\leftarrow", r"\geqq": r"\ge",
    r"\neq": r"\ne", r"\operatorname*": r"\operatorname", r"\dag": r"\dagger",
    r"\ast": "*", r"\prime": r"\prime", r"\lgroup": "(", r"\rgroup": ")", r"\bold": r"\mathbf",
    r"\mathbfcal": r"\mathcal",
}  # fmt: skip
NOTHING = {  # layout, with the number of arguments that go with it
    r"\displaystyle": 0, r"\textstyle": 0, r"\scriptstyle": 0, r"\notag": 0, r"\nonumber": 0, r"\label": 1,
    r"\vspace": 1, r"\phantom": 1, r"\hphantom": 1, r"\vphantom": 1, r"\mathstrut": 0, r"\strut": 0,
    r"\color": 1, r"\nolinebreak": 0, r"\allowbreak": 0, r"\relax": 0, r"\limits": 0, r"\nolimits": 0, r"\noindent": 0,
    r"\small": 0, r"\large": 0, r"\null": 0, r"\hfill": 0, r"\hfil": 0, r"\centering": 0, r"\footnotesize": 0,
    r"\tiny": 0,
}  # fmt: skip
SECOND = frozenset({r"\textcolor", r"\overset", r"\stackrel", r"\underset"})  # the second argument is what counts
BRACED = frozenset({r"\underbrace", r"\overbrace", r"\underbracket", r"\overbracket"})
# functions; braces end their arguments
_BARE = frozenset(f"\\{name}" for name in COMMANDS - {"det", "max", "min"} | {"tr", "Tr", "rank"})
_ENTRY = r"[A-Z](?:_(?:\w|\{[^{}]*\}))?"
# two blocks of a matrix, with a space between them
_BLOCKS = re.compile(
    rf"[(\[]\s*{_ENTRY}\s*\\(?:hspace\s*\{{[^{{}}]*\}}|;|:|quad|\s)\s*(?:{_ENTRY}\s*[)\]]\s*[.,;]?\s*$|[^()]*\)\s*\^\s*(?:T|\\top))"
)
# a term in brackets with its sign, behind another one
_OPTIONAL = re.compile(
    r"(?:(?<![A-Za-z])[A-Za-z]|[0-9})\]])\s*(?:\\left\s*)?\(\s*\+\s*(?!\\infty|[\d.\s]*(?:\\right\s*)?\))"
)
# what is no part of a name in upright type
_NO_NAME = re.compile(
    r"(?<![_^])(?<![_^] )\\(?:mathrm|mathtt|mathsf|text|textrm|texttt)\s*\{[^{}$]*"
    r"\\(?:[dt]?frac|sqrt|sum|int|prod)(?![A-Za-z])"
)
SIGNS_OVER = frozenset({"=", r"\approx", r"\le", r"\ge", r"\leq", r"\geq", "<", ">", r"\rightarrow", r"\to"})
ZEROS = frozenset({r"\mathbf", r"\boldsymbol", r"\bm", r"\pmb", r"\vec", r"\bar"})  # of vectors and matrices
_LETTERED = OVER | ROMAN  # what stands over a letter, or before a name
_ITALIC = re.compile(r"\\(?:math(?:it|sf|tt)|text(?:it|sl|sf))\s*\{\s*([A-Za-z]{2,})\s*\}")  # a name of several letters
_BOLD = re.compile(  # words
    r"\\textbf\s*(\{\s*(?:[a-z]{2}|[A-Za-z]{3,})(?:\s+[a-z]+)*\s*\})|\\(?:mathbf|boldsymbol|textbf)\s*(\{\s*[A-Z][a-z]{2,}\s*\})"
)
# the name of an operator, perhaps with spaces
_OPERATOR = re.compile(
    r"\\operatorname(\*?)\s*\{([^{}]*)\}|(?<!\{)\\(?:mathrm|text|textrm)()\s*\{\s*(arg\W*(?:max|min))\s*\}"
)
# spaces with their lengths; the wide ones part relations
_HSPACE = re.compile(r"\\hspace\*?\s*\{(?:\s*([\d.]*[1-9][\d.]*\s*(?:cm|em|in)|\d{2,}\s*(?:mm|pt|ex))|[^{}]*)\s*\}")
_UNITS = re.compile(  # of which the last has a power
    r"(?<![_^{])\\(?:mathrm|text)\s*\{((?:\s*[A-Za-z]+\s*\\,)*\s*[A-Za-z]+)\s*\\,\s*([A-Za-z]+)\s*\}(?=\s*\^)"
)
# a power of ten with an upright e, or with braces, behind a number
_TEN = re.compile(
    r"(?<=\d)\s*(?:e|E|\\(?:mathrm|text|rm)\s*\{\s*[eE]\s*\})\s*\{\s*([-+]?\d+)\s*\}"
    r"|(?<=\.\d)\\(?:mathrm|text)\{[eE]\}([-+]\d+)"
)
_CALCULATED = re.compile(r"\\(?:text|mbox|textrm|mathrm)\s*\{\s*\d+\s+[-+]\s+[A-Za-z]\w*\s*\}")  # `1 - POD`
_EMPTY = re.compile(r"\\text\s*\{\s*\}")  # a text without letters
_HYPHENATED = re.compile(r"[A-Za-z]+-[A-Za-z]{2,}|[A-Za-z]{2,}-[A-Za-z]+")  # words with a hyphen
_INNER = re.compile(r"\\[,;:! ]|[~\s]")  # spaces between the parts of a name
_HIGH = re.compile(r"\^\s*\{\s*\\left\s*\(([^{}()]*)\\right\s*\)\s*\}")  # a superscript in large brackets


@dataclass(slots=True)
class Group:
    """What stands in braces."""

    parts: list[Part]


Part = str | Group


_COUNT = r"[A-Za-z](?:_(?:\w|\{[^{}]*\}))?(?:\s*[-+]\s*\d)?"
# half a number and the like, around which nobody writes square brackets but for its integer part
_INTEGER_PART = re.compile(
    rf"(?<![A-Za-z0-9)}}\]])\s*(?:\\left\s*)?\[\s*"
    rf"(?:\\[dt]?frac\s*\{{\s*{_COUNT}\s*\}}\s*(?:\d|\{{\s*\d+\s*\}})|\(?\s*{_COUNT}\s*\)?\s*/\s*\d+)"
    r"\s*(?:\\right\s*)?\](?!\s*[\^_,])"
)
# what stands in a matrix, and a wide space in it before a sign, which may part two entries
_CELLS = re.compile(r"\\begin\{[bBpvV]?matrix\}((?:(?!\\begin|\\end).)*)\\end", re.DOTALL)
_WIDE = re.compile(r"[^\s\\&]\s*\\q?quad\s*(?:\\[,:;>]\s*|\\q?quad\s*)*[-+]")  # before a sign


def plain(source: str, beside: Iterable[str] = ()) -> str:
    """The same formula without what is layout alone; what is not balanced is left as it is.

    Formulas beside it tell whether a capital gamma is the function.
    """
    if run := bold_name(_BOLD.sub("", source)):
        bold = "".join(rf"\mathbf{{{letter}}}" for letter in run)
        raise SymcheckError(f"{run} in bold type: one name, or a product? write {bold}, or \\mathrm{{{run}}}")
    if "!=" in source and source.count("!") == 1:
        raise SymcheckError("!=: not equal, or a factorial? write \\ne, or a space before =")
    refuse_row(source)
    if _OPTIONAL.search(source):
        raise SymcheckError(
            "brackets that begin with +: a term that may be left out, or a factor? write it without them"
        )
    if _INTEGER_PART.search(source):
        raise SymcheckError(
            "a quotient in square brackets: its integer part, or idle brackets? write \\lfloor and \\rfloor, or none"
        )
    if any(_WIDE.search(rows) for rows in _CELLS.findall(source) if "&" not in rows):
        raise SymcheckError("a wide space before a sign in a matrix: another entry, or the same one? write &")
    if _BLOCKS.search(source):
        raise SymcheckError("a row of two blocks, or their product? write & between blocks, or no space")
    if _NO_NAME.search(source):
        raise SymcheckError(
            "a fraction, a root or a sum in upright type: write it outside, with its letters in that type"
        )
    if found := _CALCULATED.search(source):
        raise SymcheckError(f"{found[0]}: a formula in text; write it outside of the text")
    source = _TEN.sub(lambda found: rf"\cdot 10^{{{found[1] or found[2]}}}", source)
    source = (
        _STATES.sub(_with_states, source) if "angle" in source or r"\ket" in source or r"\bra" in source else source
    )
    source = _UPRIGHT_NUMBER.sub(r"{\1}", _OPTIONS.sub("", source))
    source = _SYMBOLS.sub(r"\\boldsymbol{\1}", source) if r"\boldmath" in source else source
    source = _ITALIC.sub(r"\\mathrm{\1}", source)
    source = _WORDS.sub(_with_formulas, source)
    source = _HSPACE.sub(lambda found: r"\quad " if found[1] else " ", source)
    source = _UNITS.sub(r"\\mathrm{\1}\\,\\mathrm{\2}", source)
    source = _OPERATOR.sub(_operator, _EMPTY.sub(" ", source))
    source = _HIGH.sub(r"^{(\1)}", _BOLD.sub(r"\\text\1\2", source))
    if not any(map(_GAMMA.search, (source, *beside))) or _FUNCTION_OF.match(source):
        source = re.sub(r"\\Gamma(?![A-Za-z])", r"\\varGamma ", source)  # a letter, and no function
    tokens = typed(source)
    try:
        parts, rest = _groups(tokens, 0)
    except IndexError:
        return source
    if rest != len(tokens):
        return source
    return phrased(_printed(_made_plain(parts)))


_INSIDE = r"((?:(?!\\left|\\right|\\langle|\\rangle).)*?)"
_BAR = r"(?:\||\\vert|\\lvert|\\rvert)"
_BRACED = r"\s*\{((?:[^{}]|\{[^{}]*\})*)\}"
# states in brackets whose sizes are adapted, and the commands that are usual for them
_STATES = re.compile(
    rf"\\left\s*(?:\\langle{_INSIDE}\\right\s*{_BAR}|{_BAR}{_INSIDE}\\right\s*\\rangle|\\langle{_INSIDE}\\right\s*\\rangle)"
    rf"|\\(?:ket{_BRACED}|bra{_BRACED}|braket{_BRACED})",
    re.DOTALL,
)


def _with_states(found: re.Match[str]) -> str:
    """The same in brackets of one size; an average stays as it is."""
    bra, ket, both = found[1] or found[5], found[2] or found[4], found[3] or found[6]
    if bra is not None:
        return rf"\langle {bra} | "
    if ket is not None:
        return rf"| {ket} \rangle "
    if both is None or not re.search(rf"\\middle|{_BAR}", both):
        return found[0]
    inner = re.sub(r"\\(?:vert|lvert|rvert)", "|", both.replace(r"\middle", ""))
    return rf"\langle {inner} \rangle "


_SCRIPTS = r"(?:\s*(?:_|\^)\s*(?:[\w+*-]|\{(?:[^{}]|\{[^{}]*\})*\})|'|\([A-Za-z, ]*\))*"
# a line of the source that begins with what is equal to something
_DEFINES = re.compile(
    rf"&?\s*(?:\\(?!frac|sqrt|left)[A-Za-z]+(?:\{{[^{{}}]*\}})?|[A-Za-z]|\\frac\s*\{{\s*(?:d|\\partial)(?![A-Za-z])[^{{}}]*\}}"
    rf"\s*\{{[^{{}}]*\}}){_SCRIPTS}\s*&?\s*="
)
# the end of a line behind which an equation goes on, or another one is parted
_GOES_ON = re.compile(
    r"(?:[-+*/=<>,.;:(\[{|&]|\\[A-Za-z]+|\\.|\\(?:text|mbox|textrm|begin|end)\s*\{[^{}]*\}|\\(?:sum|prod|int)[^=+]*)\s*$"
)


# the end of a line behind which an equation goes on, even behind a blank line
_UNFINISHED = re.compile(r"(?:[-+*/=<>,;(\[{|&]|\\q?quad|\\(?:text|mbox)\s*\{[^{}]*\})\s*$")


# the letter that a line begins with, of which several lines say what it is
_FIRST = re.compile(r"\s*&?\s*(\\?[A-Za-z]+)")


def refuse_row(source: str) -> None:
    """SymcheckError for equations on lines of the source that print parts by nothing."""
    for row in source.split("\\\\") if "\n" in source else ():
        before, equated, blank = "", False, False
        first = _FIRST.match(row)
        for line in map(str.strip, row.split("\n")):
            alike = first is not None and (found := _FIRST.match(line)) is not None and found[1] == first[1]
            ended = (blank or alike) and not _UNFINISHED.search(before)
            if equated and _DEFINES.match(line) and (ended or not _GOES_ON.search(before)):
                raise SymcheckError(f"do several equations stand in a row here, before {line[:20]}? write \\\\")
            blank = not line
            before, equated = line or before, equated or "=" in line


def _with_formulas(found: re.Match[str]) -> str:
    """Words among which formulas stand, as words and formulas one behind the other."""
    words, formulas = found[1].split("$")[::2], found[1].split("$")[1::2]
    if len(words) == len(formulas):  # a dollar without another one
        return found[0]
    parts = [each for pair in zip(words, [*formulas, ""], strict=True) for each in pair]
    return "".join(
        f" {part} " if k % 2 or not any(map(str.isalpha, part)) else rf"\text{{{part}~}}"  # a remark, and no factor
        for k, part in enumerate(parts)
    )


def _operator(found: re.Match[str]) -> str:
    """An operator with its name as one word."""
    return rf"\operatorname{found[1] or ''}{{{_INNER.sub('', found[2] or found[4] or '')}}}"


def _groups(tokens: Sequence[str], start: int, inside: bool = False) -> tuple[list[Part], int]:
    parts: list[Part] = []
    k = start
    while k < len(tokens):
        if tokens[k] == "{":
            inner, k = _groups(tokens, k + 1, inside=True)
            parts.append(Group(inner))
        elif tokens[k] == "}":
            if not inside:
                raise IndexError
            return parts, k + 1
        else:
            parts.append(tokens[k])
            k += 1
    if inside:
        raise IndexError
    return parts, k


def _made_plain(parts: list[Part]) -> list[Part]:
    """One level of braces, those within first."""
    return _scripts_in_order(_scripts_at_the_left(_made_plain_here(_over(parts))))


_SPACES = frozenset({r"\,", r"\!", r"\;", r"\:", "\\ ", "~"})
_NO_BASE = frozenset("+-=<>(,;|&[/") | {
    r"\|",
    "",
    r"\cdot",
    r"\times",
    r"\left",
    r"\big",
    r"\Big",
    r"\\",
    r"\quad",
    r"\qquad",
    r"\frac",
}


def _scripts_at_the_left(parts: list[Part]) -> list[Part]:
    r"""`{}^A x` as `\prescript{A}{}{x}`: scripts behind nothing belong to the letter that follows."""
    if "^" not in parts and "_" not in parts:
        return parts
    found: list[Part] = []
    k = 0
    while k < len(parts):
        part = parts[k]
        empty = isinstance(part, Group) and not part.parts
        start = k + 1 if empty else k
        if start >= len(parts) or parts[start] not in ("^", "_"):
            found.append(part)
            k += 1
            continue
        before = next((p for p in reversed(found) if not (isinstance(p, str) and p in _SPACES)), "")
        opened = isinstance(before, Group) and r"\begin" in found[-3:]
        opened = opened or (isinstance(before, str) and before in _NO_BASE)
        bare = opened and not (before in ("|", r"\|") and _closes(found, str(before)))
        if empty or bare or _is_apart(parts, start, found):
            scripts: dict[Part, Part] = {}
            m = start
            while m + 1 < len(parts) and parts[m] in ("^", "_") and str(parts[m]) not in scripts:
                scripts[str(parts[m])] = parts[m + 1]
                m += 2
            while m < len(parts) and isinstance(parts[m], str) and parts[m] in _SPACES:
                m += 1
            letter, end = _letter_here(parts, m)
            if letter:
                found += [r"\prescript", scripts.get("^", Group([])), scripts.get("_", Group([])), Group(letter)]
                k = end
                continue
            if parts[m : m + 1] == [r"\begin"] and [*scripts] == ["^"]:  # a matrix in a frame, written below it too
                end = _end_of_environment(parts, m)
                frame = [*_texts([scripts["^"]])][1:-1]
                below = Group([each for each in frame if each not in _SPACES])
                found += [*parts[m:end], "_", below]
                k = end
                continue
        found.append(parts[k])
        k += 1
    return found


def _closes(before: Sequence[Part], bar: str) -> bool:
    """Does the bar that comes last close what is between two bars?"""
    return before[-2:-1] == [r"\right"] or before.count(bar) % 2 == 0


def _is_apart(parts: list[Part], k: int, before: list[Part]) -> bool:
    r"""Does a space part the script here from what stands before it, as in `\mathbf{C} \, ^r \mathbf{m}`?

    One in a calligraphic letter behind a matrix in brackets is a frame of what follows.
    """
    if not before or k + 1 >= len(parts):
        return False
    script = parts[k + 1]
    inside = script.parts if isinstance(script, Group) else [script]
    if before[-1] == "]" and parts[k] == "^" and inside[:1] == [r"\mathcal"]:
        return True
    if before[-1] not in (r"\,", r"\;", r"\:", "\\ "):
        return False
    return len(inside) == 1 and isinstance(inside[0], str) and inside[0].isalpha() and inside[0] != "T"


def _end_of_environment(parts: Sequence[Part], k: int) -> int:
    """Where the environment ends that begins here."""
    depth = 0
    for m in range(k, len(parts)):
        depth += (parts[m] == r"\begin") - (parts[m] == r"\end")
        if not depth:
            return m + 2
    return len(parts)


def _letter_here(parts: list[Part], k: int) -> tuple[list[Part], int]:
    """The letter that begins here, with its style and accents."""
    if k >= len(parts) or not isinstance(parts[k], str) or not tex.is_letter(str(parts[k])):
        return [], k
    if parts[k] in _LETTERED and k + 1 < len(parts):
        return parts[k : k + 2], k + 2
    return parts[k : k + 1], k + 1


def _scripts_in_order(parts: list[Part]) -> list[Part]:
    """Below before above, where a letter has both."""
    found = list(parts)
    for k in range(len(found) - 3):
        if (
            found[k] == "^"
            and found[k + 2] == "_"
            and isinstance(found[k + 1], Group)
            and isinstance(found[k + 3], Group)
        ):
            found[k : k + 4] = [*found[k + 2 : k + 4], *found[k : k + 2]]
    return found


# what may stand behind the bar that closes a length
_BEHIND_BARS = frozenset("^_=+-/)],.;<>&") | {
    r"\right",
    r"\cdot",
    r"\times",
    r"\le",
    r"\ge",
    r"\leq",
    r"\geq",
    r"\\",
    "",
}


def _with_bars(parts: list[Part]) -> list[Part]:
    r"""Pairs of `\parallel` as the bars of lengths, which close where no operand follows."""
    places = [k for k, part in enumerate(parts) if part == r"\parallel"]
    if not places or len(places) % 2 or any([*parts, ""][k + 1] not in _BEHIND_BARS for k in places[1::2]):
        return parts
    return [r"\|" if part == r"\parallel" else part for part in parts]


def _made_plain_here(parts: list[Part]) -> list[Part]:
    found: list[Part] = []
    parts = _with_bars(parts)
    k = 0
    while k < len(parts):
        part = parts[k]
        if isinstance(part, Group):
            inner, after = _made_plain(part.parts), parts[k + 1] if k + 1 < len(parts) else ""
            head = found[-3] if found[-2:-1] == ["_"] else found[-1] if found else ""  # perhaps with a base below it
            argument = bool(inner) and str(head) in _BARE and after not in ("^", "_", "'")
            bracketed = argument and not _is_bracket(inner) and not _is_fraction(inner)
            found += ["(", *inner, ")"] if bracketed else _loose(inner, found, after)
            k += 1
            continue
        part = SAME.get(part, part)
        if part == r"\not" and parts[k + 1 : k + 2] == ["="]:
            found.append(r"\ne")
            k += 2
        elif part in NOTHING:
            k += 1 + _argument_count(parts, k, NOTHING[part])
        elif part in FONTS and not (k + 1 < len(parts) and isinstance(parts[k + 1], Group)) and _is_switch(part):
            return found + _styled(FONTS[part], _made_plain(parts[k + 1 :]))
        elif part in (r"\bf", r"\rm"):  # before a group, as if it took an argument
            found += _styled(FONTS[part], _inner(parts[k + 1]))
            k += 2
        elif part in SECOND and k + 2 < len(parts):
            found += _second(part, parts[k + 1], parts[k + 2])
            k += 3
        elif part == r"\underline" and k + 1 < len(parts):
            found += _underlined(_inner(parts[k + 1]))
            k += 2
        elif part in BRACED and k + 1 < len(parts):
            found += _inner(parts[k + 1])
            k += 2
            if k + 1 < len(parts) and parts[k] in ("_", "^"):
                k += 2  # the note
        elif part in ARGUMENTS or part in ("_", "^"):
            count = ARGUMENTS.get(part, 1)
            found.append(part)
            k += 1
            while k < len(parts) and parts[k] == "[" and part == r"\sqrt":
                end = parts.index("]", k) if "]" in parts[k:] else k
                found += parts[k : end + 1]
                k = end + 1
            for _ in range(count):
                if k < len(parts):
                    taken, k = _argument(parts, k, raw=part in (r"\begin", r"\end", r"\tag"))
                    found.append(taken)
            if (part in ZEROS and _zero(found[-1], parts[k : k + 2])) or _one(found[-2:], parts[k : k + 2]):
                found[-2:] = found[-1].parts if isinstance(found[-1], Group) else []
            elif part in OVER and isinstance(styled := found[-1], Group):
                found[-2:] = _over_letters(part, styled.parts)
            is_array = (
                part == r"\begin" and isinstance(found[-1], Group) and "".join(map(str, found[-1].parts)) == "array"
            )
            if is_array and k < len(parts) and isinstance(parts[k], Group):
                found.append(parts[k])  # its columns
                k += 1
        else:
            if part:
                found.append(part)
            k += 1
    return found


def _underlined(inner: list[Part]) -> list[Part]:
    """A letter with a line below it is one of its own; a line below more stresses it."""
    letter, end = (inner[:2], 2) if inner[:1] == [r"\underline"] else _letter_here(inner, 0)
    rest = inner[end:]
    name = bool(letter) and letter[0] not in ROMAN and letter[0] != r"\nabla" and letter[:1] != [r"\partial"]
    scripts = [part for k, part in enumerate(rest) if part in ("_", "^") or (k and rest[k - 1] in ("_", "^"))]
    if not name or [part for part in rest if part != "'"] != scripts:
        return inner
    return [r"\underline", Group(letter), *rest]


# scripts that are no powers
MARKS = frozenset({"{", "}", "*", "+", "-", "'", r"\ast", r"\star", r"\prime", r"\dagger"})


def _over_letters(command: str, inner: list[Part]) -> list[Part]:
    """An accent or style over a letter with scripts, which stand behind it; a style over several letters is of each."""
    count = 1 + ("'" in inner[-2:-1])
    signs = inner[_letter_here(inner, 0)[1] : -count : 2]
    if inner[-1:] == ["'"] and count < len(inner) and all(each in ("_", "^") for each in signs):
        return [*_over_letters(command, inner[:-count]), *inner[-count:]]  # primes stand behind it
    if command in STYLES and len(inner) == 2 and inner[0] in ACCENTS and isinstance(inner[1], Group):
        return [inner[0], Group(_over_letters(command, inner[1].parts))]  # the style is of the letter
    letter, end = _letter_here(inner, 0)
    rest = inner[end:]
    scripts = all(rest[k] in ("^", "_") and isinstance(rest[k + 1], Group) for k in range(0, len(rest) - 1, 2))
    above = (rest[k + 1] for k in range(0, len(rest) - 1, 2) if rest[k] == "^")
    power = command not in STYLES and any(
        text not in MARKS and not text.isupper() for part in above for text in _texts([part])
    )
    if letter and rest and len(rest) % 2 == 0 and scripts and not power:  # the mean of x^2 is not the square of a mean
        return [*_over_letters(command, letter), *rest]
    scripted = next((k for k in range(0, len(rest), 2) if rest[k] not in ("^", "_")), len(rest))
    if command in STYLES and letter and not power and _is_bracket(rest[scripted:]):
        return [command, Group(letter), *rest[:scripted], *_styled(command, rest[scripted:])]  # bold of all of it
    if command in STYLES and len(inner) > 1 and all(isinstance(part, str) and tex.is_letter(part) for part in inner):
        word = "".join(map(str, inner))
        if command in (r"\mathcal", r"\mathscr", r"\mathfrak") and word.isalpha():
            raise SymcheckError(
                f"{command}{{{word}}}: one name, or a product? write {command} before each of its letters"
            )
        return [each for part in inner for each in (command, Group([part]))]
    return [command, Group(inner)]


def _zero(part: Part, after: Sequence[Part]) -> bool:
    """Is this a bold zero, or one with an arrow, whose size nothing tells, or rows and columns below it?"""
    return isinstance(part, Group) and part.parts == ["0"] and (after[:1] not in (["_"], ["^"]) or _is_size(after))


def _one(styled: Sequence[Part], after: Sequence[Part]) -> bool:
    """Is this a bold one with rows and columns below it?"""
    command, inner = styled if len(styled) == 2 else ("", "")
    bold = isinstance(command, str) and command in ZEROS | {r"\mathbb"}
    return bold and isinstance(inner, Group) and inner.parts == ["1"] and _is_size(after)


def _is_size(script: Sequence[Part]) -> bool:
    r"""Is this a subscript such as `3 \times 2`?"""
    below = script[1] if len(script) > 1 and script[0] == "_" else ""
    return isinstance(below, Group) and r"\times" in below.parts


def _is_switch(command: str) -> bool:
    """Does it hold to the end of the group rather than for an argument?"""
    return command in (r"\bf", r"\rm", r"\cal", r"\it", r"\sf", r"\tt")


def _argument_count(parts: Sequence[Part], k: int, count: int) -> int:
    return min(count, len(parts) - k - 1)


def _argument(parts: list[Part], k: int, *, raw: bool) -> tuple[Part, int]:
    """One TeX argument, in braces; a command takes what belongs to it along."""
    part = parts[k]
    if isinstance(part, Group):
        return (part if raw else Group(_made_plain(part.parts))), k + 1
    part = SAME.get(part, part)
    if part in ARGUMENTS and part not in (r"\begin", r"\end"):
        own: list[Part] = [part]
        k += 1
        for _ in range(ARGUMENTS[part]):
            if k < len(parts):
                taken, k = _argument(parts, k, raw=False)
                own.append(taken)
        return Group(own), k
    if part in FONTS and k + 1 < len(parts):
        taken, k = _argument(parts, k + 1, raw=False)
        return Group(_styled(FONTS[part], _inner(taken))), k
    return Group([part]), k + 1


def _inner(part: Part) -> list[Part]:
    return _made_plain(part.parts) if isinstance(part, Group) else [part]


def _styled(style: str, parts: list[Part]) -> list[Part]:
    """Letters in a style; signs and numbers have none."""
    if not style:
        return parts
    text = "".join(part for part in parts if isinstance(part, str))
    if style == r"\mathrm" and len(parts) > 1 and (text.isalnum() or _HYPHENATED.fullmatch(text)):
        return [style, Group(parts)]
    found: list[Part] = []
    for k, part in enumerate(parts):
        script = k > 0 and parts[k - 1] in ("_", "^")
        letter = isinstance(part, str) and tex.is_letter(part) and part not in _LETTERED
        letter = letter and parts[k - 1 : k + 2] not in (["(", "t", ")"], ["(", r"\tau", ")"])  # time is no vector
        letter = letter and not (style == r"\mathbf" and part in LETTER_COMMANDS and "(" in parts)  # Greek has no bold
        found += [style, Group([part])] if letter and not script else [part]
    return found


def _second(command: str, first: Part, second: Part) -> list[Part]:
    """What stands over or under a sign is a note; over anything else it is refused where it is read."""
    inner = _inner(second)
    sign = "".join(part for part in inner if isinstance(part, str))
    if command == r"\underset" and re.sub(
        r"[^a-z]", "", sign.removeprefix(r"\operatorname").removeprefix(r"\mathrm") + "".join(_texts(inner))
    ).endswith(("lim", "min", "max")):
        return [*inner, "_", first if isinstance(first, Group) else Group([first])]
    asked = "?" in _texts([first])  # whether it holds
    if command == r"\textcolor" or (sign in SIGNS_OVER and not asked):
        return inner
    return [command, first, second]


def _over(parts: list[Part]) -> list[Part]:
    r"""`a \over b` as a fraction, and `n \choose k` as a binomial."""
    for sign, command in ((r"\over", r"\frac"), (r"\choose", r"\binom")):
        if sign in parts:
            k = parts.index(sign)
            return [command, Group(parts[:k]), Group(parts[k + 1 :])]
    return parts


def _loose(inner: list[Part], before: Sequence[Part], after: Part) -> list[Part]:
    """A group that is no argument: its braces print nothing; empty ones before a script carry a script of the left."""
    if not inner and after in ("^", "_"):
        return [Group([])]
    if _is_frame(inner, after):  # `{^f}{\bf J}`
        if before and isinstance(before[-1], str) and tex.is_letter(before[-1]):
            raise SymcheckError("a power, or a script at the left of what follows? write {} before the script")
        return [Group([]), *inner]
    if after in ("^", "_") and len(inner) > 1 and isinstance(inner[0], str) and inner[0][:1].isdigit():
        return [inner[0], *_loose(inner[1:], [*before, inner[0]], after)]  # `{6x}^5` is printed as `6x^5`
    if after == "^" and len(inner) == 3 and inner[1] == "_" and isinstance(inner[2], Group):
        return inner  # `{c_j}^2` is printed as `c_j^2`
    if after == "^" and len(inner) == 4 and inner[0] in OVER and inner[2] == "_":
        return inner
    if after == "_" and len(inner) > 1 and all(isinstance(part, str) and part.isalpha() for part in inner):
        return [Group(inner)]  # one name, or a product; nobody puts braces around that
    if after in ("^", "_", "'") and len(_units(inner)) > 1 and not _is_bracket(inner):
        if after in ("^", "_") and _runs_on(inner):
            return inner
        if after == "^" and all(part in ("_", "^") for part in inner[-4:-1:2]) and len(inner) in (5, 6):
            return ["(", *inner, ")"]  # a letter with scripts of its own
        return [Group(inner)]  # the script belongs to all of it
    return inner


def _is_frame(inner: Sequence[Part], after: Part) -> bool:
    """Is this one letter above nothing, before a group or a letter?"""
    above = _units(inner[1].parts) if len(inner) == 2 and inner[0] == "^" and isinstance(inner[1], Group) else []
    letter = above[0] if len(above) == 1 else ""
    follows = isinstance(after, Group) or (bool(after) and (tex.is_letter(after) or after in OVER))
    return follows and isinstance(letter, str) and letter.isalpha() and letter not in ("T", "H")


def _runs_on(inner: Sequence[Part]) -> bool:
    """Do letters side by side, or brackets or bars, end here, so that the script stands at the last of them?"""
    if inner[-1] in (")", "]", "|", r"\|"):
        return not {"+", "-", "=", r"\pm"} & _outside(inner)
    units = _units(inner)
    return all(isinstance(part, str) and (tex.is_letter(part) or part in _SPACES) for part in units)


def _outside(parts: Sequence[Part]) -> set[str]:
    """The tokens that stand in no brackets."""
    found, depth = set[str](), 0
    for part in parts:
        depth += (part in ("(", "[")) - (part in (")", "]"))
        if not depth and isinstance(part, str):
            found.add(part)
    bars = "|" in found or r"\|" in found
    return found - {"+", "-"} if bars and parts[0] in (r"\left", "|", r"\|") else found


def _is_fraction(parts: Sequence[Part]) -> bool:
    """Is a group one fraction, or one binomial, whose end shows without brackets?"""
    return len(parts) == 3 and isinstance(parts[0], str) and parts[0] in _FRACTIONS


_FRACTIONS = frozenset({r"\frac", r"\dfrac", r"\tfrac", r"\binom", r"\dbinom", r"\tbinom"})


def _is_bracket(parts: Sequence[Part]) -> bool:
    """Is a group one pair of brackets, so that a script behind its braces is of these?"""
    inner = [part for part in parts if not (isinstance(part, str) and part in _SIZED)]
    depth = 0
    for k, part in enumerate(inner):
        depth += (part == "(" or part == "[") - (part == ")" or part == "]")
        if not depth:
            return k > 0 and k == len(inner) - 1
    return False


_SIZED = frozenset(f"\\{size}{side}" for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r"))
_SIZED |= {r"\left", r"\right"}


def _units(parts: Sequence[Part]) -> list[Part]:
    """The letters of a group, each with its style and accents, as far as they can be told."""
    found: list[Part] = []
    k = 0
    while k < len(parts):
        part = parts[k]
        found.append(part)
        k += 1
        while isinstance(part, str) and part in ARGUMENTS and k < len(parts):
            part = ""
            k += 1
    return found


def _printed(parts: Sequence[Part]) -> str:
    return " ".join(_texts(parts))


def _texts(parts: Sequence[Part]) -> Iterator[str]:
    for part in parts:
        if isinstance(part, Group):
            yield "{"
            yield from _texts(part.parts)
            yield "}"
        else:
            yield part


_OPTIONS = re.compile(r"\[\s*[a-z]{3,}=[^\]]*\]\s*(?=\{)")  # of a command that is not there any more
# a fraction in upright or bold digits
_UPRIGHT_NUMBER = re.compile(r"\\(?:mathrm|mathbf|rm)\s*\{\s*(\d+\s*/\s*\d+)\s*\}")
_SYMBOLS = re.compile(r"\\mbox\s*\{\s*\\boldmath\s*\$([^$]*)\$\s*\}")  # a bold letter in text
# words, perhaps with formulas among them
_WORDS = re.compile(
    r"\\(?:text|mbox|textrm|textnormal|hbox)\s*\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\$(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}"
)
# a function of the usual letters that is said to be something without an integral, a product or a factorial
_FUNCTION_OF = re.compile(
    r"\s*\\Gamma\s*\(\s*(?:[fhjkrtuvEG]|\\omega|\\theta|\\tau)\s*\)\s*="
    r"(?!.*\\(?:[Gg]amma\s*\(|int|lim|prod|sum|frac\s*\{\s*\\pi))(?!.*!)"
    r"|\s*\\Gamma\s*\([^(),]*,[^(),]*,[^()]*\)\s*:?=",
    re.DOTALL,
)
# the gamma function, which stands before its argument
_GAMMA = re.compile(r"\\Gamma(?![A-Za-z])(?:\s|\\[!,;:]|_\s*(?:\w|\{[^{}]*\}))*(?:\\left|\\[bB]igg?l?)?\s*\(")
# an upright d before the letter of an integration or derivative
_DIFFERENTIAL = re.compile(r"\\(?:mathrm|text|operatorname|rm)\s*\{\s*d\s*\}(?=\s*(?:[A-Za-z\\^]))")


_IN_WORDS = re.compile(
    r"\\(?:text|mathrm|operatorname|begin|end)\s*\{(?!\s*d\s*\})[^{}]*\}"
)  # no letters of the formula


def with_plain_differentials(source: str) -> str:
    r"""An upright d of a differential as an italic one, unless d is a letter here too."""
    rest = _IN_WORDS.sub("", _DIFFERENTIAL.sub("", source))
    if re.search(r"(?<![A-Za-z\\])d(?![A-Za-z])", rest):
        return source
    return _DIFFERENTIAL.sub("d", source)
