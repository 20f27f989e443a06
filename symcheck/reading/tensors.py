r"""Products that print does not tell to be of numbers: `C_{ij} v_j` summed over j, `X^\dagger T X`, blocks.

A repeated index may be summed over, and capitals may be matrices; as numbers they could be exchanged or divided by.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

_RUN = r"(?:[a-z]|\\(?:alpha|beta|kappa|lambda|mu|nu|rho|sigma))"
_INDICES = rf"({_RUN}|\{{ {_RUN}(?: (?:, )?{_RUN})* \}})"
_SYMBOL = r"([A-Za-z]|\\(?!frac|sqrt|left|right|sum|prod)[a-z]+(?: \{ (?:\w|\\[a-z]+) \})?)"
# two factors with indices, the second one perhaps before its argument
_PAIR = re.compile(rf"(?<![A-Za-z\\]){_SYMBOL} _ {_INDICES} (?=(?:\\[,;:!] )*{_SYMBOL} _ {_INDICES})")
# both sides of an equation
_EQUATION = re.compile(r"(?:^|& |\\\\ |quad )((?:(?!\\\\|quad|=).)*?) (?:& )?= (?:& )?((?:(?!\\\\|quad|=).)*)")
# what says what is summed over
_SUM = re.compile(r"\\(?:sum|prod|int)(?![a-z])")
# indices below a letter
_BELOW = re.compile(rf"_ {_INDICES}")
# indices of tensors, which hardly name what stands above them as x, y and s do
_SUMMED = frozenset("ijklmn") | {rf"\{x}" for x in ("alpha", "beta", "kappa", "lambda", "mu", "nu", "rho", "sigma")}
_TOLD = "summed over {}, or not? write \\sum, or say what the letters are"
_MOST = 3  # indices of one letter
_LOW = r"(?: _ (?:\w|\{[^{}]*\}))?"
# a capital with a dagger
_ADJOINT = re.compile(r"(?<![A-Za-z\\])([A-Z])(?: _ (?:\w|\{[^{}]*\}))? \^ (?:\{ \\dagger \}|\\dagger)")
# two capitals side by side
_CAPITALS = re.compile(r"(?<![A-Za-z\\])[A-Z](?: _ (?:\w|\{[^{}]*\}))? (?:\\[,;:!] )*[A-Z](?![A-Za-z])")
# a capital
_CAPITAL = re.compile(r"(?<![A-Za-z\\])[A-Z](?![A-Za-z])")
# an inverse between capitals, which a number would not be printed between
_BETWEEN = re.compile(
    rf"(?<![A-Za-z\\])[A-Z]{_LOW} (?:\\[,;:!] )*[A-Z]{_LOW} \^ \{{ - 1 \}} (?:\\[,;:!] )*[A-Z](?![A-Za-z])"
)
# what shows that there are matrices
_OF_MATRICES = re.compile(r"\^ (?:T|\{ (?:- )?(?:T|\\top) \}|\\top)|m a t r i x|\\(?:mathbf|boldsymbol|bm) ")
# inverses of capitals, and a capital beside one
_INVERSE = re.compile(r"(?<![A-Za-z\\])([A-Z](?: _ (?:\w|\{[^{}]*\}))?) \^ \{ - 1 \}")
# two inverses side by side
_INVERSE_PAIR = re.compile(r"\^ \{ - 1 \} (?:\\[,;:!] )*[A-Z](?: _ (?:\w|\{[^{}]*\}))? \^ \{ - 1 \}")
# an identity of so many rows as an entry
_BLOCK = re.compile(
    r"(?:& |\\\\ |m a t r i x \} |\} \{ [lcr ]+ \} )(?:- )?(I _ (?:[nmNpqkd]|\{ [nmNpqkd] \}))(?= [-+&\\])"
)


# a letter with indices before a second derivative by letters with indices
_DERIVED = re.compile(
    rf"_ {_INDICES} (?:(?!\\partial|[-+=]).)*\\partial (?:(?![-+=]).)*\\partial (?:[A-Za-z]|\\[a-z]+) _ {_INDICES}"
)
# a letter with the same index twice
_TRACE = re.compile(rf"{_SYMBOL} _ \{{ ([i-n]) \2 \}}")


def _runs(below: str) -> set[str]:
    return {text for text in below.split() if text not in "{},"}


def _is_law(text: str) -> bool:
    """Do the same capitals stand on both sides, so that it says nothing of what they are?"""
    sides = [{*_CAPITAL.findall(side)} - {"I", "T"} for side in text.split(" = ")]
    return len(sides) == 2 and sides[0] == sides[1]


def unsaid_products(text: str) -> Iterator[tuple[str, str]]:
    """The letters of a formula, whose tokens stand apart, that may be tensors or matrices, each with the doubt."""
    if " = " in text and not _SUM.search(text):
        for left, right in _EQUATION.findall(text):
            own = {x for below in _BELOW.findall(left) for x in _runs(below)}
            for below, behind in _DERIVED.findall(right):
                if (
                    len(_runs(below)) > 1
                    and (shared := (_runs(below) & _runs(behind) & _SUMMED) - own)
                    and own & _SUMMED
                ):
                    found = re.search(rf"([A-Za-z]|\\[a-z]+(?: \{{ \w \}})?) _ {re.escape(below)}", right)
                    if found:
                        yield found[0], _TOLD.format(min(shared))
            for first, run in _TRACE.findall(right):
                if run not in own and (left.strip("& ") == first or own & _SUMMED):
                    yield f"{first} _ {{ {run} {run} }}", _TOLD.format(run)
            for first, below, second, behind in _PAIR.findall(right):
                if max(len(_runs(below)), len(_runs(behind))) > _MOST:
                    continue  # words
                shared = (_runs(below) & _runs(behind) & _SUMMED) - own
                free = (_runs(below) | _runs(behind)) & own & _SUMMED
                square = (first, below) == (second, behind) and len(_runs(below)) > 1
                if shared and (free or square):
                    yield f"{first} _ {below}", _TOLD.format(min(shared))
    if r"\dagger" in text and "m a t r i x" not in text and _CAPITALS.search(text):
        yield from ((letter, "numbers, or matrices? say what they are") for letter in _ADJOINT.findall(text))
    inverse = {*_INVERSE.findall(text)} if "- 1 }" in text else set()
    between = bool(inverse) and _BETWEEN.search(text) is not None
    paired = between or (len(inverse) > 1 and _INVERSE_PAIR.search(text))
    if paired and not _OF_MATRICES.search(text) and not _is_law(text):
        yield from ((letter, "numbers, or matrices? say what they are") for letter in sorted(inverse))
    if "I _ " in text:
        yield from ((letter, "a block, or a number? say what it is") for letter in _BLOCK.findall(text))
