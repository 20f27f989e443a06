"""What a text says its letters measure: "where $m$ is the mass in kg", "$A$ - area [m^2]", "$g = 9.81$ m/s$^2$".

Texts say so in many ways, and letters are used again for something else. What is not certainly a unit of one letter is
left alone: of it nothing is known, and nothing is told.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass

from symcheck.core.verdicts import SymcheckError
from symcheck.dimensions import dimension
from symcheck.reading.notation import canonical

NUMBER = "1"
NONE = ("-", "–", "—", "dimensionless")  # in the place of a unit
# Symbols with usual prefixes, and names. No atto, hecto, or u for micro: "as", "am", "hs" and "us" are words. Neither
# percent: a rate "in percent" is mostly one per year.
_SYMBOL = r"(?:[pnµμmckMGT]?(?:m|g|s|N|Pa|J|W|V|A|K|Hz|C|F|H|T|S|Wb|eV|Ω|mol|rad)|sr|cd|hPa|bar|min|h|yr|deg)"
_NAMED = (
    r"(?:(?:pico|nano|micro|milli|centi|kilo|mega|giga|tera)?(?:met(?:er|re)|gram|second|newton|pascal|joule|watt|volt|"
    r"amp(?:ere)?|coulomb|farad|henry|tesla|weber|ohm|mole|radian|steradian|kelvin)s?|(?:kilo|mega|giga)?hertz|"
    r"minutes?|hours?|days?|years?)"
)
_POWER = r"(?:\s?\^\s?(?:\(-?\d+(?:/\d+)?\)|-?\d+)|-?\d(?!\d))?"
_FACTOR = rf"(?:{_NAMED}|{_SYMBOL})(?![A-Za-zµμ]){_POWER}"
_TIMES = r"(?:\s*[·⋅*/]\s*|\s*\.\s*(?=[A-Za-zµμΩ])|\s+per\s+|\s+)"
UNIT = rf"(?:1\s*/\s*)?{_FACTOR}(?:{_TIMES}(?:\(\s*{_FACTOR}(?:{_TIMES}{_FACTOR})*\s*\)|{_FACTOR}))*"
_END = r"(?=\s*(?:$|[,.;:)\]\n|]|and\b|or\b|for\b|with\b|where\b|when\b|at\b|if\b|is\b))"
_LETTERS = r"(?P<letters>(?:\$[^$]+\$(?:\s*(?:,\s*and|,|and|or)\s*)?)+)"
_SAYS = r"(?:\s*(?:is|are|denotes?|represents?|be|being|means?|=|:|-|–|—)\s)"
_WORDS = r"(?P<words>[^$.;()\[\]\n|]{0,80}?)"
# after the letter: its unit in brackets, in words, or at once; or a number with its unit
_STATED = (
    re.compile(rf"{_LETTERS}{_WORDS}\s*\[\s*(?P<unit>{UNIT}|-|–|—)\s*\]"),
    re.compile(rf"{_LETTERS}{_WORDS}\s\(\s*(?:in\s+)?(?P<unit>{UNIT})\s*\)"),
    re.compile(rf"{_LETTERS}{_WORDS}\bin\s+(?:units\s+of\s+)?(?P<unit>{UNIT}){_END}(?!\s*(?:,|and|or)\s*{UNIT}(?!\w))"),
    re.compile(rf"(?P<letters>\$[^$]+\$)(?P<words>\s+(?:is|are)\s+(?:a\s+)?)(?P<unit>dimensionless){_END}"),
)
# a letter with its value
_VALUE = re.compile(
    r"\$(?P<letter>[^$=]+?)\s*(?:=|\\approx|\\simeq)\s*-?\d[\d.]*(?:\s*(?:\\times|\\cdot)\s*10\^\{?-?\d+\}?)?"
    rf"(?:\$\s*(?P<behind>{UNIT}){_END}|\s*(?P<within>[^$\d\s][^$]*)\$)"
)
# the same, where a bracket follows
_COPULA = re.compile(_SAYS.replace(r")\s)", r")(?:\s|$))"))
# words of what may be measured, where a letter stands for the unit: no "polynomial in s"
_MEASURED = re.compile(
    r"\b(?:(?:measured|expressed|given)(?=\s*$)|mass|length|distance|position|displacement|height|width|radius|diameter|depth|"
    r"thickness|coordinate|altitude|wavelength|time|duration|period|delay|energy|work|heat|force|thrust|power|voltage|"
    r"potential|temperature|current|charge|capacitance|inductance)\b"
)
# words that turn to something else than the letter: "the number of turns in seconds", "the distance covered in s"
_OTHER = re.compile(r"\b(?:numbers?|count|amount|respectively|(?!measured|expressed|given)\w+[^e\W]ed|whose)\b")
# words before a letter to which its unit does not belong: "the product of n and the number of cells $N$ [V]"
_OF_SEVERAL = re.compile(r"\b(?:product|ratio|sum|difference|quotient|numbers?)\b")
# a letter with its arguments: `v(t)`
_ARGUMENT = re.compile(r"^(.*[^\s\\])\s*\([A-Za-z, ]+\)$")
# titles of lists of symbols, which hold everywhere
LISTS = re.compile(r"\W*(?:\w+ (?:of|and) )?(?:nomenclature|notations?|symbols|variables|parameters|units)\b", re.I)
# of such texts the formulas are not those of the quantities
SCALED = re.compile(
    r"natural units|atomic units|geometri[sz]ed units|non-?dimensional|dimensionless (?:form|variables|units|quantit)|"
    r"normali[sz]ed (?:units|variables|quantit)|scaled (?:units|variables|quantit)",
    re.IGNORECASE,
)
_SUPERSCRIPT = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


@dataclass(frozen=True)
class Told:
    """What a text says of a letter.

    letter   as it is printed
    unit     as `symcheck.dimensions.dimension` takes it
    place    where, in words
    scope    the section and the example of which it is said; None for all of the document
    """

    letter: str
    unit: str
    place: str
    scope: tuple[int, int] | None

    def holds_in(self, scope: tuple[int, int]) -> bool:
        """Is it said of the letter where this is printed?"""
        return self.scope is None or (self.scope[0] == scope[0] and self.scope[1] in (0, scope[1]))


def stated(text: str) -> Iterator[tuple[str, str]]:
    """The letters of a paragraph, whose inline formulas stand between dollars, with their units."""
    text = _plain(text)
    for pattern in _STATED:
        for found in pattern.finditer(text):
            words, unit = found["words"], found["unit"]
            letters = re.findall(r"\$([^$]+)\$", found["letters"])
            before = re.split(r"[.;]\s", text[: found.start()])[-1]
            if _OTHER.search(words) or _OF_SEVERAL.search(before) or not _is_certain(words, unit, found[0]):
                continue
            several = len(letters) > 1 and re.match(r"\s*(?:are|denote|be)\b", words)
            for letter in letters if several else letters[-1:]:
                yield from _letter(letter, unit)
    for found in _VALUE.finditer(text):
        unit = found["behind"] or _plain(f"${found['within']}$")
        if re.fullmatch(UNIT, unit.strip()):
            yield from _letter(found["letter"], unit.strip())


def _is_certain(words: str, unit: str, whole: str) -> bool:
    """Is a unit of one letter, which may be a letter of the text, one all the same?"""
    if len(unit) > 1 or unit in NONE:
        return True
    quantity = _MEASURED.search(words) is not None
    return quantity or (whole.endswith("]") and (not words.strip() or _COPULA.search(words) is not None))


def _letter(letter: str, unit: str) -> Iterator[tuple[str, str]]:
    letter = _ARGUMENT.sub(r"\1", letter.strip())
    unit = NUMBER if unit in NONE else _read(unit)
    with suppress(SymcheckError):
        if canonical(letter):
            dimension(unit)
            yield letter, unit


def _read(unit: str) -> str:
    """A unit as it is taken: without words, and with the signs of powers."""
    unit = re.sub(r"(?<=[A-Za-zµμΩ])(?=-?\d)", "^", unit)
    return re.sub(r"\s+per\s+", "/", unit).replace("Ω", "ohm").replace("μ", "µ")


def _plain(text: str) -> str:
    r"""Words with units in plain letters: `m/s$^2$`, `$\mathrm{kg}\,\mathrm{m}^{-3}$` and `m²` as `kg m^-3`."""
    text = re.sub(r"\$\s*(?:\{\})?\^\s*\{?\s*(-?\d+)\s*\}?\s*\$", r"^\1", text)
    text = re.sub("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda found: "^" + found[0].translate(_SUPERSCRIPT), text)
    text = re.sub(r"\$([^$]*(?:\\(?:mathrm|text|rm|textrm|mathsf)\b|\[)[^$]*)\$", _unit, text)
    text = re.sub(r"\b(square|cubic) (\w+)", lambda found: f"{found[2]}^{2 if found[1] == 'square' else 3}", text)
    return re.sub(r"[^\S\n]+", " ", text)


def _unit(found: re.Match[str]) -> str:
    """A formula that is nothing but a unit, as words; else the formula."""
    words = re.sub(r"\\(?:mathrm|text|rm|textrm|mathsf)\b|\\[,;:! ]|~|[{}]", " ", found[1])
    words = re.sub(r"\\cdot|\\times", "·", words).replace(r"\Omega", "Ω").replace(r"\mu", "µ")
    words = re.sub(r"\\[dt]?frac\s(.*?)\s\s+(.*?)(?=\s*\]|$)", r"\1/(\2)", words)
    words = re.sub(r"\s*\^\s*", "^", " ".join(words.split()))
    return words if re.fullmatch(rf"{UNIT}|\[ ?{UNIT} ?\]", words) else found[0]


def of_letters(told: Iterable[Told], scope: tuple[int, int]) -> dict[str, Told]:
    """What is said where something is printed, by the usual spelling of letters; nothing of one with two units."""
    found: dict[str, list[Told]] = {}
    for each in told:
        if each.holds_in(scope):
            found.setdefault(canonical(each.letter), []).append(each)
    return {letter: every[0] for letter, every in found.items() if len({*map(_measures, every)}) == 1}


def _measures(told: Told) -> frozenset[tuple[str, object]]:
    return frozenset(dimension(told.unit).items())


def of_document(letter: str, told: Sequence[Told], scopes: Iterable[tuple[int, int]]) -> Told | None:
    """What is said of a letter, in its usual spelling, wherever it stands."""
    found = [of_letters(told, scope).get(letter) for scope in dict.fromkeys(scopes)]
    first = next(filter(None, found), None)
    return first if first and all(each and _measures(each) == _measures(first) for each in found) else None
