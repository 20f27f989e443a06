"""The outermost layer of a printed formula: TeX tokens with their places, groups, tags, and the spelling of letters."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple, NoReturn

from symcheck.core.verdicts import SymcheckError
from symcheck.reading.commands import LETTER_COMMANDS, OVER, ROMAN, known

_TOKEN = re.compile(r"\\[A-Za-z]+\*?|\\.|\S", re.DOTALL)  # a command, an escaped sign, or any other sign
_SPACE = r"(?:\\quad|\\qquad|\\,|\\;|\\:|\\!|\\ |~|\s)"
# the number of a formula at its end: "\tag{2.1}", or "\quad (2.1)"
_TAG = re.compile(
    rf"{_SPACE}*(?:\\(?:tag|eqno)\s*\{{\s*([^{{}}]*?)\s*\}}|\\q?quad{_SPACE}*\((\d+(?:\.\d+)?[a-zа-я]?)\))(?={_SPACE}*$)"
)
_TAGGED = (r"\tag", r"\eqno", "quad")  # one of these stands before it
_TAIL = re.compile(rf"(?:{_SPACE}|(?<!\\right)(?<!\\right )[.,;])+$")  # spaces and punctuation at the end of a formula
_TAILS = ("quad", *"~.,;:!")  # with which such a tail ends

MAX_DEPTH = 30  # of brackets; the papers have less than ten
_LETTERED = OVER | ROMAN
_LETTERS = _LETTERED | LETTER_COMMANDS
_ROMAN = {"{", "}"} | ROMAN  # what a subscript is printed with
_DIGITS = frozenset("0123456789.")
_OPENING, _CLOSING = frozenset({"{", "(", "[", r"\{"}), frozenset({"}", ")", "]", r"\}"})


class Tok(NamedTuple):
    """One TeX token: a command, or a single character; `at` is its place in the source string."""

    text: str
    at: int


def fault(source: str, at: int, message: str) -> SymcheckError:
    """The error of one place: the message, and the source with a pointer before the place."""
    at = min(max(at, 0), len(source))
    before, after = source[max(0, at - 24) : at], source[at : at + 24]
    shown = f"{'...' if at > 24 else ''}{before}▸{after}{'...' if at + 24 < len(source) else ''}"
    return SymcheckError(f"{message}, at character {at + 1}: {' '.join(shown.split())}")


@lru_cache(maxsize=1024)  # a formula is read under several notations
def split_tag(latex: str) -> tuple[str, str | None]:
    r"""Split a displayed formula from its printed number.

    Parameters
    ----------
    latex
        The formula, with a number such as ``(2.7)`` or ``\tag{2.7}`` at the end, or without one.

    Returns
    -------
    tuple of str
        The formula, without a full stop, comma or semicolon at the end, and the number or None.

    Examples
    --------
    >>> split_tag(r"x = 1, \quad (2.7)")
    ('x = 1', '2.7')
    """
    tag = None
    body = latex
    found = _tag(latex) if any(map(latex.__contains__, _TAGGED)) else None
    if found:
        tag = (found[1] or found[2] or "").strip("() ") or None
        body = latex[: found.start()]
    return (_TAIL.sub("", body) if body.endswith(_TAILS) or body[-1:].isspace() else body).strip(), tag


def _tag(latex: str) -> re.Match[str] | None:
    return _TAG.search(_TAIL.sub("", latex) or latex) or _TAG.search(latex)


def tokenize(source: str) -> list[Tok]:
    """All TeX tokens; white space separates and is dropped."""
    return [*map(Tok, *_tokens(source))]


def texts(source: str) -> tuple[str, ...]:
    """The texts of all TeX tokens."""
    return _tokens(source)[0]


@lru_cache(maxsize=2048)  # a formula is scanned for several kinds of evidence, and by the reader
def _tokens(source: str) -> tuple[tuple[str, ...], tuple[int, ...]]:
    """The texts of the tokens, and their places."""
    found = [*_TOKEN.finditer(source)]
    return tuple([m[0] for m in found]), tuple([m.start() for m in found])


@lru_cache(maxsize=2048)
def _closing(source: str) -> dict[int, int]:
    """The place of the brace that closes each brace that opens."""
    found, opened = dict[int, int](), list[int]()
    for k, text in enumerate(texts(source)):
        if text == "{":
            opened.append(k)
        elif text == "}" and opened:
            found[opened.pop()] = k
    return found


@lru_cache(maxsize=2048)
def _too_deep(source: str) -> int | None:
    """The place of the first bracket within too many others."""
    depth = 0
    for text, at in zip(*_tokens(source), strict=True):
        if text in _OPENING:
            depth += 1
            if depth > MAX_DEPTH:
                return at
        elif text in _CLOSING:
            depth -= 1
    return None


def compact(source: str) -> str:
    """The same tokens with spaces only where they would run together: behind commands and between digits."""
    made, end = "", 0
    for tok in tokenize(source):
        command = re.search(r"\\[A-Za-z]+$", made) and tok.text[0].isalpha()
        number = made[-1:].isdigit() and tok.text[0] in "0123456789." and tok.at > end
        made, end = made + " " * bool(command or number) + tok.text, tok.at + len(tok.text)
    return made


@lru_cache(maxsize=2048)
def spaced(source: str) -> str:
    """The same tokens with one space between them, but for digits that make one number: as patterns expect them."""
    made, end = list[str](), 0
    for text, at in zip(*_tokens(source), strict=True):
        number = at == end and made and made[-1] in _DIGITS and text in _DIGITS
        made += [text] if number or not made else [" ", text]
        end = at + len(text)
    return "".join(made)


class Reader:
    """A place in a token list, with the errors that name it."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.texts, self.places = _tokens(source)
        self.i = 0
        self.refuse_depth()

    def refuse_depth(self) -> None:
        """SymcheckError where brackets are nested deeper than any formula; what comes later recurses into them."""
        if (at := _too_deep(self.source)) is not None:
            self.fail(f"nested more than {MAX_DEPTH} deep", at)

    def peek(self, ahead: int = 0) -> str:
        """The text of a coming token; "" past the end."""
        try:
            return self.texts[self.i + ahead]
        except IndexError:
            return ""

    def alignment(self, environment: str) -> None:
        r"""Skip how the columns of a starred matrix are aligned: `[r]`."""
        if environment.endswith("matrix*") and (self.peek(), self.peek(2)) == ("[", "]") and self.peek(1) in "lcr":
            self.i += 3

    def at(self, ahead: int = 0) -> int:
        """The place of a coming token in the source."""
        k = self.i + ahead
        return self.places[k] if k < len(self.places) else len(self.source)

    def fail(self, message: str, at: int | None = None) -> NoReturn:
        raise fault(self.source, self.at() if at is None else at, message)

    def group(self) -> tuple[str, ...]:
        """One TeX argument: the tokens inside of `{...}`, or a single one."""
        start, end = self._argument()
        return self.texts[start:end]

    def placed(self) -> list[Tok]:
        """The same, each with its place."""
        start, end = self._argument()
        return [*map(Tok, self.texts[start:end], self.places[start:end])]

    def _argument(self) -> tuple[int, int]:
        start = self.i
        if self.peek() in ("", "}"):
            self.fail("an argument is missing")
        self.i += 1
        if self.texts[start] != "{":
            return start, self.i
        end = _closing(self.source).get(start)
        if end is None:
            self.i = len(self.texts)
            self.fail("unbalanced brace: this { is never closed", self.places[start])
        self.i = end + 1
        return start + 1, end

    def spelling(self) -> str:
        r"""The canonical spelling of the letter that begins here, accents included: `\dot{\boldsymbol{\omega}}`."""
        text = self.peek()
        if text in ROMAN:
            self.i += 1
            start = self.at()
            inside = self.group()
            if not inside:
                self.fail("an empty name", start)
            return f"\\text{{{''.join(inside)}}}"
        if text in OVER:
            self.i += 1
            start = self.at()
            inside = self.group()
            inner = spelled("".join(_spaced(inside)))
            if inner is None:
                self.fail(f"{text} must stand over one letter", start)
            return f"{text}{{{inner}}}"
        if not is_letter(text):
            self.fail(no_letter(text) if known(text) else "a letter is expected here")
        self.i += 1
        return text


def _spaced(tokens: Sequence[str]) -> list[str]:
    return [f"{text} " if text[0] == "\\" else text for text in tokens]


def is_letter(text: str) -> bool:
    """Can this token begin a letter?"""
    return text in _LETTERS or text.isalpha()


def no_letter(latex: str) -> str:
    """What to say of a command or word that is no letter and that nothing is known of here."""
    return f"{latex} is no letter, and the reader does not know it; say it in other words, or exclude the formula"


@lru_cache(maxsize=4096)  # the same letters are met in every formula
def spelled(latex: str) -> str | None:
    """The canonical spelling if `latex` is one letter and nothing else, otherwise None."""
    reader = Reader(latex)
    if not is_letter(reader.peek()):
        return None
    text = reader.spelling()
    return text if reader.i == len(reader.texts) else None


def subscript(tokens: Sequence[str]) -> str:
    r"""The canonical text of a subscript that belongs to the letter: `_1`, `_{\max}`, `_{s1}`."""
    kept = [text for text in tokens if text not in _ROMAN]
    if len(kept) == 1:
        return f"_{kept[0]}"
    parted = (text + " " * _runs_on(text, after) for text, after in itertools.zip_longest(kept, kept[1:], fillvalue=""))
    return f"_{{{''.join(parted)}}}"


def _runs_on(text: str, after: str) -> bool:
    """Would what is printed behind a command be read as part of its name?"""
    return text[:1] == "\\" and text[1:].isalpha() and after[:1].isalpha()


def superscript(tokens: Sequence[str]) -> str | None:
    """The canonical text of a superscript in brackets, `^{(2)}` or `^{[2]}`; None if it is another one."""
    text = "".join(tokens)
    pair = {"(": ")", "[": "]"}.get(text[:1])
    if pair is None or len(text) < 3 or text.find(pair) != len(text) - 1 or "," in text:
        return None
    return f"^{{{text}}}"


DOTTED = ("", r"\dot", r"\ddot", r"\dddot")


def _base(tokens: tuple[str, ...]) -> tuple[int, int]:
    """From where to where the letter goes in a name of several tokens."""
    start, groups = 0, 2 if tokens[0] == r"\prescript" else 0
    if groups:
        depth, start = 0, 1
        while groups or depth:
            depth += (tokens[start] == "{") - (tokens[start] == "}")
            groups -= tokens[start] == "}" and not depth
            start += 1
        start += 1  # into the third group
    elif tokens[0] in (r"\Delta", r"\delta") and is_letter("".join(tokens[1:2])):
        start = 1
    end = start + 1
    if {*tokens[start:end]} & _LETTERED and tokens[end : end + 1] == ("{",):
        depth = 1
        while depth:
            end += 1
            depth += (tokens[end] == "{") - (tokens[end] == "}")
        end += 1
    return start, end


def with_dots(latex: str, dots: int) -> str:
    """A name of several tokens with dots over its letter."""
    tokens = texts(latex)
    if not dots:
        return latex
    start, end = _base(tokens)
    return " ".join([*tokens[:start], DOTTED[dots], "{", *tokens[start:end], "}", *tokens[end:]])


def without_dots(latex: str) -> str:
    """A name of several tokens without the dots over its letter."""
    tokens = texts(latex)
    start, end = _base(tokens)
    if start >= len(tokens) or tokens[start] not in DOTTED:
        return latex
    return " ".join([*tokens[:start], *tokens[start + 2 : end - 1], *tokens[end:]])


@lru_cache(maxsize=512)
def names(wholes: tuple[str, ...]) -> tuple[tuple[tuple[str, ...], str, int], ...]:
    """The tokens of names of several tokens, also with dots over their letters, the longest first."""
    forms = {
        (texts(with_dots(latex, dots)), latex, dots)
        for latex in wholes
        for dots in range(1 if latex.startswith("[") else len(DOTTED))
    }
    return tuple(sorted(forms, key=lambda form: (-len(form[0]), form)))


@lru_cache(maxsize=512)  # all readings of a formula have the same
def beginning(wholes: tuple[str, ...]) -> dict[str, list[tuple[tuple[str, ...], str, int]]]:
    """The same by their first tokens."""
    found: dict[str, list[tuple[tuple[str, ...], str, int]]] = {}
    for form in names(wholes):
        found.setdefault(form[0][0], []).append(form)
    return found
