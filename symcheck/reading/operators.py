r"""Capitals before a letter that may be operators: `H\psi = E\psi`, `(1 - L) y_t`, `L u = -u'' + q u`.

Print does not tell an operator that is applied from a factor, and as a factor it could be divided by.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

_BELOW = r"(?: _ (?:\w|\\[a-z]+|\{ [^{}]* \}))?"
_ABOVE = r"(?: \^ (?:\w|\*|\{ [^{}]* \}))?"
_LETTER = rf"(?:[a-z]|\\(?!partial|frac)[a-z]+|\\(?:Psi|Phi)|\\[a-z]+ \{{ \w \}}){_BELOW}{_ABOVE}"
# both sides end in one letter: `L_z Y = m \hbar Y`
_EIGEN = re.compile(
    rf"(?:^|& |quad |\\\\ )([A-Z]|\\hat \{{ \\?[A-Z]\w* \}}){_BELOW} "
    rf"((?:Y|{_LETTER})(?: _ \w| _ \{{ [^{{}}]* \}})?{_ABOVE}) "
    r"(?:& )?= (?:& )?((?:(?!\\\\|\\q?quad|=).)*) \2(?= ?(?:[.,;]|\\q?quad|\\\\|$))"
)
_BRACKETS = re.compile(r"\([^()]*\)")  # whose sums are no addends of what they stand in
_ARGUMENTS = re.compile(r"\([^()]*,[^()]*\)")  # several, which are no factors
_ADDED = re.compile(r"(?<=\S) [-+] ")  # another addend
# what is made of a letter by a convolution with it: `S x(t) = |x \\star \\psi|`
_CONVOLVED = re.compile(
    rf"(?:^|& |quad |\\\\ )([A-Z]{_BELOW}{_ABOVE}) ([a-z]) (?:\( [^()]* \) )?(?:& )?= "
    r"(?:& )?(?:(?!\\\\|\\q?quad|=).)*?(?<![A-Za-z\\])\2 (?:\( [^()]* \) )?(?:\\star|\\ast|\\circledast|\*) "
)
# the energy before a wave function
_ENERGY = re.compile(
    r"(?<![A-Za-z\\])(H)(?: _ (?:\d|\{ \d \}))? (?:\\left )?(?:\| )?\\(?:psi|Psi|phi|Phi|varphi)(?![a-z])"
)
# what stands at a time, as it does beside a lag
_AT_TIME = r"(?:[A-Za-z]|\\[a-z]+|\\[a-z]+ \{ (?:\w|\\[a-z]+) \}) _ (?:t(?![A-Za-z])|\{ (?:[a-z] )*t \})"
# sums and functions of a lag before that: `(1 - L)^d y_t`, `\phi(B) y_t`
_LAGGED = re.compile(
    rf"[(\[] 1 [-+] (?:[^=]*?[^A-Za-z\\])?([LB])(?![A-Za-z]| _)[^=]*?(?:\\right )?[)\]]{_ABOVE} {_AT_TIME}"
    rf"|\\[a-zA-Z]+{_BELOW} (?:\\left )?\( ([LB]){_ABOVE} (?:\\right )?\) {_AT_TIME}"
)
# a lag alone, before a letter that stands without it elsewhere
_LAG = re.compile(rf"(?<![A-Za-z\\])([LB]){_ABOVE} ({_AT_TIME})")
# an equation that says what an operator makes of a letter with derivatives
_OF_DERIVATIVES = re.compile(
    r"(?:^|& |quad |\\\\ )([LTADP]) ([a-z]|\\(?:psi|phi|varphi|rho)) (?:& )?= .*"
    r"(?:(?<![A-Za-z\\])\2 '|\\frac \{ (?:d|\\partial|\\mathrm \{ d \})(?: \^ (?:\d|\{ \d \}))? \2 \}|"
    r"\\(?:nabla|Delta)(?: \^ (?:2|\{ 2 \}))? \2(?![A-Za-z]))"
)
_SYMBOL = r"(?:[A-Za-z]|\\[a-z]+(?: \{ \w \})?)"
# a derivative by the time, printed with a letter below
_BY_TIME = re.compile(
    rf"(?:^|[=+-] |& |\\\\ )d _ (?:t|\{{ t \}}) {_SYMBOL}{_BELOW} (?:\\left )?\("
    rf"|(?:^|& |\\\\ )d _ (?:t|\{{ t \}}) {_SYMBOL}{_BELOW} (?:& )?="
)
_AT = r"(?:_ \w|_ \{ \w \}|(?:\\left )?\[ \w (?:\\right )?\])"
# a change of a letter that is printed without its place: `\\delta_i \\Phi = \\Phi_{i + 1} - \\Phi_{i - 1}`
_DIFFERENCES = re.compile(
    rf"(?:^|& |quad |\\\\ )(\\[dD]elta{_BELOW}|D{_BELOW}) ({_SYMBOL}|\\[A-Z][a-z]+) (?:& )?= (?:& )?"
    r"(?:\\frac \{ )?\2 _ \{ (\w) (?:[-+] [^{}]*)?\} - \2 _ (?:\3 |\{ \3 )"
)
# differences at places or times, of which an operator before a letter may be made: `D u_j = u_{j + 1} - u_j`
_DIFFERENCE = re.compile(
    rf"(?:^|& |quad |\\\\ )((?:[A-Z]|\\[a-z]+ \{{ [A-Z] \}}){_BELOW}) ({_SYMBOL}) {_AT} (?:& )?= "
    r"((?:(?!\\\\|\\q?quad|=).)*)"
)
_SHIFTED = r"[_[] (?:\{ )?\w [-+] "
# a fraction of two sums with one letter, which a group maps to it: `g z = (a z + b)/(c z + d)`
_MAPPED = re.compile(
    r"(?:^|[=&] |quad |\\\\ )([A-Za-z]|\\[a-z]+) ([a-z]|\\tau) (?:& )?= (?:& )?"
    r"\\d?frac \{ (?=[^{}=]*[-+])[^{}=]*(?<![A-Za-z\\])\2(?![A-Za-z])[^{}=]*\} "
    r"\{ (?=[^{}=]*[-+])[^{}=]*(?<![A-Za-z\\])\2(?![A-Za-z])[^{}=]*\}"
)
# an upright sign of a derivative with a letter below, and one in italics at the beginning
_UPRIGHT = re.compile(
    r"(\\(?:text|mathrm) \{ D \} _ (?:[a-z]|\{ [a-z] \}))(?= (?:\\left )?(?:\\[a-z]+ \{|[A-Za-z(]))"
    rf"|(?:^|& |\\\\ )(D _ (?:[txyz]|\{{ [txyz] \}})) {_SYMBOL}{_BELOW} (?:& )?="
)
_ADDENDS = r"(?:[^()\[\]=]|\([^()]*\))*"
# a Delta among the addends of what stands before a function of the place: `(\Delta + k^2) G(\mathbf{r})`
_LAPLACIAN = re.compile(
    rf"[(\[] (?:{_ADDENDS}[-+] )?(?:\\[a-z]+ |[a-z] |\\frac \{{[^{{}}]*\}} \{{[^{{}}]*\}} )*\\Delta (?:\\right )?"
    rf"(?:[)\]]|[-+] {_ADDENDS}[)\]]) (?:\^ (?:\d|\{{ \d \}}) )?(?:\\[,;:!] )*"
    rf"(?:(?:[uvfG]|\\(?:var)?(?:psi|phi)|\\(?:Psi|Phi)){_BELOW}(?![A-Za-z])|{_SYMBOL}{_BELOW} (?:\\left )?\( "
    r"(?:[xr] |\\(?:mathbf|boldsymbol|bm|vec) ))"
)
# the principal value of an integral
_PRINCIPAL = re.compile(
    r"(\\mathcal \{ P \}|\\(?:text|mathrm) \{ (?:P|P V|p v|V P|v p|P \. V \.|p \. v \.) \}) (?:\\[,;:!] )*\\int"
)
_OPERATOR = "applied to what follows, or times it? say what it is"


def operators(text: str) -> Iterator[tuple[str, str]]:
    """The capitals of a formula, whose tokens stand apart, that may be operators, each with the doubt."""
    if " = " in text:
        for letter, _, rest in _EIGEN.findall(text):
            while rest != (rest := _BRACKETS.sub("", rest)):
                pass
            if not _ADDED.search(rest):
                yield letter, _OPERATOR
        yield from ((letter, _OPERATOR) for letter, _ in _OF_DERIVATIVES.findall(text))
        yield from ((letter, _OPERATOR) for letter, _ in _MAPPED.findall(text))
        yield from ((letter, _OPERATOR) for letter, _ in _CONVOLVED.findall(text))
        yield from ((letter, _OPERATOR) for letter, _, _ in _DIFFERENCES.findall(text))
        for letter, of, rest in _DIFFERENCE.findall(text):
            places = rf"(?<![A-Za-z\\]){re.escape(of)} (?:\\left )?(?=[_[])"
            if len(re.findall(places, rest)) > 1 and re.search(places + _SHIFTED, rest) and letter not in rest:
                yield letter, _OPERATOR
    if "D " in text:
        yield from ((letter or other, _OPERATOR) for letter, other in _UPRIGHT.findall(text))
    if "d _ " in text and _BY_TIME.search(text):
        yield "d", _OPERATOR
    if r"\Delta " in text and _LAPLACIAN.search(text):
        yield r"\Delta", "a number, or the Laplacian? write \\nabla^2, or say what it is"
    if r"\int" in text:
        yield from ((letter, "the principal value, or a factor? say what it is") for letter in _PRINCIPAL.findall(text))
    if "H " in text:
        yield from ((letter, _OPERATOR) for letter in _ENERGY.findall(text))
    if "_ t" in text or "t }" in text:
        lags = {a or b for a, b in _LAGGED.findall(text)}
        beside = _ARGUMENTS.sub("", text)
        lags |= {letter for letter, of in _LAG.findall(beside) if beside.count(of.partition(" _")[0] + " _") > 1}
        yield from ((letter, "a lag, or a factor? say what it is") for letter in lags)
