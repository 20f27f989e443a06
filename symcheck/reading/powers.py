r"""Letters above others that are powers by their looks, and hardly by what an equation says: `q^{n + 1} = q^n + h f`.

A step of a scheme is numbered so, and a name that the left side gives stands above what makes it up.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

_BASE = r"(?:[A-Za-z]|\\[A-Za-z]+(?: \{ (?:\w|\\[A-Za-z]+|\w _ (?:\w|\{ \w \})) \})?)"
_BELOW = r"(?: _ (?:\w|\\[a-z]+|\{(?:[^{}]|\{[^{}]*\})*\}))?"
_SIDE = r"(?:^|\\\\ |& |\\q?quad )"
_REST = r"(?:& )?(?:=|\\equiv) ((?:(?!\\\\|\\q?quad| = ).)*)"
_NUMBER = r"(?:\d+|\d / \d|\\frac \{ \d \} \{ \d \}|\\frac \d \d)"
_SHIFT = rf"(?:{_NUMBER}|\\(?:theta|vartheta|alpha)(?: _ (?:\w|\{{[^{{}}]*\}}))?)"
_REST_BEHIND = r"[^=]*(?:=|\\equiv) (.*)"
# the next step, by itself on the left
_NEXT = re.compile(
    rf"{_SIDE}(?:\{{ )?((?:\\[dD]elta )?{_BASE}{_BELOW})(?: \}})? \^ \{{ ([a-z]) \+ {_SHIFT} \}} {_REST}"
)
# what is given by an equation, or its logarithm
_GIVEN = re.compile(rf"{_SIDE}(?:\\(?:ln|log) (?:\( )?)?(\\[a-z]+|[A-Za-z]) (?:\) )?{_REST}")

# what is summed over a letter from 1 to another one
_SUMMED = re.compile(
    r"\\(?:sum|prod) _ \{ ([a-z]) = 1 \} \^ (?:[A-Za-z]|\{ [A-Za-z] \}) ((?:(?!\\\\|\\q?quad| = |\\sum|\\prod).)*)"
)
# a letter above the left side, which stands above others on the right
_ALIKE = re.compile(rf"{_SIDE}({_BASE}){_BELOW} \^ (?:\{{ )?([a-z])(?: \}})? {_REST}")
# a value of a function with letters above its brackets, beside its values at what has them above
_VALUE_RAISED = re.compile(
    rf"\[ ({_BASE}{_BELOW}) (?:\\left )?\( [^\[\]]* (?:\\right )?\) (?:\\right )?\] "
    rf"\^ (?:\{{ )?([a-z])(?![a-z]){_REST_BEHIND}"
)
# a rate with letters above it, and no number
_RATES = re.compile(r"\\d?dot \{ ([A-Za-z]) \} \^ (\{ [a-z](?: [-+] \w)? \}|[a-z](?![A-Za-z]))")
# the change in a step of time: `\\frac{\\rho^{n + 1} - \\rho^n}{\\Delta t}`
_CHANGED = re.compile(
    rf"\{{ ({_BASE}{_BELOW}) \^ (?:\{{ )?([a-z])(?: \+ {_NUMBER})?(?: \}})? "
    rf"- \1 \^ (?:\{{ )?\2(?: - {_NUMBER})?(?: \}})? \}} "
    r"\{ (?:\\Delta|\\delta|h|k|\\tau)(?![A-Za-z])"
)
# a sum or product from 1 on, with its Greek index and its body
_SUMMED_GREEK = re.compile(
    r"\\(?:sum|prod) _ \{ (\\[a-z]+) = 1 \} \^ (?:\S+|\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}) "
    r"((?:(?!\\\\|\\q?quad| = |\\sum|\\prod).)*)"
)
_SEVERAL = 2  # letters with the same one above, of which no powers are multiplied


def raised_in_vain(text: str) -> Iterator[tuple[str, str]]:
    """The letters of a formula, whose tokens stand apart, that have such a letter above, each with that letter."""
    for base, step, rest in _ALIKE.findall(text):
        raised = {
            *re.findall(rf"({_BASE})(?: ')*{_BELOW}(?: ')* \^ (?:{step}(?![A-Za-z])|\{{ (?:\\, )?{step} \}})", rest)
        } - {base}
        if raised and not re.search(
            rf"(?<![A-Za-z\\]){step}(?! [_])(?![A-Za-z])", re.sub(rf"\^ (?:{step}|\{{ (?:\\, )?{step} \}})", "", rest)
        ):
            yield base, step
    for base, step, rest in _VALUE_RAISED.findall(text):
        if re.search(rf"{re.escape(base)} (?:\\left )?\([^=]*\^ (?:\{{ )?{step}(?![A-Za-z])", rest):
            yield base, step
    for base, above in _RATES.findall(text):
        if re.search(rf"(?<![A-Za-z\\{{ ]){base} \^ {re.escape(above)}|[^{{] {base} \^ {re.escape(above)}", text):
            yield base, above.strip("{ }")
    for _, step in _CHANGED.findall(text):
        steps = re.findall(rf"({_BASE}{_BELOW}) \^ (?:{step}(?![A-Za-z])|\{{ {step}(?: [-+] {_NUMBER})? \}})", text)
        yield from ((base, step) for base in steps)
    for base, step, rest in _NEXT.findall(text):
        above = re.compile(rf"\^ (?:{step}(?![A-Za-z])|\{{ {step}(?: [-+] {_SHIFT})?(?: [-+] {_SHIFT})? \}})")
        own = re.sub(r"^\\[dD]elta ", "", base)  # what changes
        before = re.search(rf"(?<![A-Za-z\\]){re.escape(own)}(?: \}})? {above.pattern}", rest)
        if before and not re.search(rf"(?<![A-Za-z\\]){step}(?![A-Za-z])", above.sub("", rest)):
            yield own, step
    for run, rest in _SUMMED.findall(text):
        above = re.compile(
            rf"({_BASE}) _ (?:\w|\\[a-z]+|\{{(?:[^{{}}]|\{{[^{{}}]*\}})*\}}) \^ (?:{run}(?![A-Za-z])|\{{ {run} \}})"
        )
        raised = {*above.findall(rest)}
        if len(raised) >= _SEVERAL and not re.search(rf"(?<![A-Za-z\\]){run}(?![A-Za-z])", above.sub("", rest)):
            yield from ((base, run) for base in sorted(raised))
    for run, rest in _SUMMED_GREEK.findall(text):
        over = re.compile(
            rf"({_BASE}) _ (?:\w|\\[a-z]+|\{{[^{{}}]*\}}) \^ (?:{re.escape(run)}(?![A-Za-z])|\{{ {re.escape(run)} \}})"
        )
        yield from ((base, run) for base in sorted({*over.findall(rest)}))
    for given, rest in _GIVEN.findall(text):
        above = re.compile(rf"({_BASE}){_BELOW} \^ (?:{re.escape(given)}(?![A-Za-z])|\{{ {re.escape(given)} \}})")
        found = above.findall(rest)
        if found and not re.search(rf"(?<![A-Za-z\\]){re.escape(given)}(?![A-Za-z])", above.sub("", rest)):
            yield from ((base, given) for base in found if base not in ("e", r"\text { e }"))
