"""Where letters stand in printed formulas, and what is done with them there: the evidence for their kinds."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.commands import ACCENTS, ROMAN, known
from symcheck.reading.lexer import CLOSE, COMMANDED, FUNCTIONS, NUMBERS, OPEN, SIZES, SPACES
from symcheck.reading.notation import undotted

BOLD = frozenset({r"\mathbf", r"\boldsymbol", r"\bm", r"\pmb", r"\vec"})
SIGNED_SUMS = frozenset({r"\sum", r"\prod"})
FRACTIONS = frozenset({r"\frac", r"\dfrac", r"\tfrac"})
# superscripts that transpose a matrix, or its inverse
TRANSPOSED = frozenset((*minus, sign) for minus in ((), ("-",)) for sign in ("T", r"\top", r"\intercal"))
INTEGRALS = frozenset({r"\int", r"\iint", r"\iiint", r"\oint"})
DIFFERENTIALS = frozenset({"d", r"\partial", r"\text{d}"})


@dataclass(slots=True)  # never changed; frozen ones take twice as long to make
class Occurrence:
    """One place where a letter is printed.

    Parameters
    ----------
    word
        The letter in its canonical spelling, without dots.
    dots, primes
        How many there are.
    subscript, superscript
        The tokens of the scripts; None where there is none.
    arguments
        The texts of what stands in round brackets behind it, apart at commas; None without brackets.
    role
        "" in an expression, "index" below a sum, "bound" in one of its bounds, "variable" behind the d of an integral
        or below that of a derivative, "derived" behind the d above, "subscript" within one.
    before, after
        The tokens beside it, spaces left out; "" at the ends.
    """

    word: str
    dots: int = 0
    primes: int = 0
    subscript: tuple[str, ...] | None = None
    superscript: tuple[str, ...] | None = None
    arguments: tuple[str, ...] | None = None
    role: str = ""
    before: str = ""
    after: str = ""
    by: tuple[str, ...] = ()  # the letters below the derivative under which it stands
    beside: tuple[str, ...] = ()  # letters behind a dot or a cross before it or behind it
    exponent: bool = False  # does it stand in an exponent of e?
    transposed: bool = False  # does a T stand above it?
    powered: bool = False  # does an exponent stand behind the brackets that follow it?
    followed: bool = False  # does a small bold letter follow without a sign, behind its arguments?


_SPECIAL = SIGNED_SUMS | FRACTIONS | INTEGRALS | {r"\begin", r"\end", "_", "^", r"\partial"}


@dataclass(slots=True)
class Scope:
    """What is known of the group that is being scanned."""

    role: str = ""
    by: tuple[str, ...] = ()
    integral: bool = False
    exponent: bool = False


def occurrences(source: str, wholes: Sequence[str] = ()) -> list[Occurrence]:
    """All letters of a formula, in printed order; what cannot be a letter is passed over.

    `wholes` are names that are printed with several tokens.
    """
    return [*_occurrences(source, tuple(wholes))]


@lru_cache(maxsize=512)  # several kinds of evidence are taken from one formula
def _occurrences(source: str, wholes: tuple[str, ...]) -> tuple[Occurrence, ...]:
    return tuple(Scan(source, wholes).run(Scope()))


def first(source: str) -> Occurrence | None:
    """The first letter of a formula, if it has any."""
    return next(Scan(source).run(Scope()), None)


class Scan(tex.Reader):
    """Walks over the tokens of a formula; nothing is refused that the reader itself will refuse better."""

    def __init__(self, source: str, wholes: Sequence[str] = ()) -> None:
        super().__init__(source)
        self.wholes = tex.beginning(tuple(wholes))

    def whole(self) -> tuple[str, int]:
        """The name of several tokens that begins here, and the dots over it; "" if none does."""
        for tokens, spelling, dots in self.wholes.get(self.peek(), ()):
            if all(self.peek(k) == text for k, text in enumerate(tokens)):
                self.i += len(tokens)
                return spelling, dots
        return "", 0

    def transposes(self) -> bool:
        """Does a superscript begin here that transposes what stands in brackets before it?"""
        start, self.i = self.i, self.i + 1
        inside = tuple(words(self.group())) if self.i < len(self.texts) else ()
        self.i = start
        return inside in TRANSPOSED

    def transposed(self, place: int) -> bool:
        """Is what ends before this place transposed?"""
        start, self.i = self.i, place
        found = self.peek() == "^" and self.transposes()
        self.i = start
        return found

    def run(self, scope: Scope, stop: int | None = None) -> Iterator[Occurrence]:
        stop = len(self.texts) if stop is None else stop
        while self.i < stop:
            text = self.texts[self.i]
            if not (text in _SPECIAL or tex.is_letter(text) or text in self.wholes):
                self.i += 1
                continue
            before = self.texts[self.i - 1] if self.i else ""
            if self.wholes and (whole := self.whole())[0]:
                name, dots = whole
                arguments = self.arguments()
                yield Occurrence(
                    name,
                    dots,
                    arguments=arguments,
                    powered=arguments is not None and name[0] != "[" and self.peek_at(self.behind()) == "^",
                    role=scope.role,
                    by=scope.by,
                    before=before,
                    after=next((text for text in self.texts[self.i :] if text not in _UNPRINTED), ""),
                    followed=self.vector_follows(),
                )
            elif text in (r"\begin", r"\end"):
                self.environment()
            elif text in SIGNED_SUMS:
                yield from self.bounded(scope)
            elif text in INTEGRALS:
                scope.integral = True
                self.i += 1
            elif text in FRACTIONS:
                yield from self.fraction(scope)
            elif text == "_" and before in INTEGRALS:
                self.i += 1
                yield from self.inside(Scope(scope.role, scope.by, exponent=scope.exponent))
            elif text == "_":
                yield from self.script(scope, "subscript")
            elif text == "^" and self.transposes():
                self.i += 1
                self.group()
            elif text in ("d", r"\partial") and (middle := self.slash()):
                yield from self.slashed(scope, middle)
            elif (text in FUNCTIONS_SPELLED and text != r"\operatorname") or not tex.is_letter(text):
                self.i += 1
            elif text == "d" and scope.integral and self.differential():
                self.i += 1
                yield from self.letter(Scope("variable", scope.by))
            else:
                yield from self.letter(scope)

    def environment(self) -> None:
        self.i += 1
        name = "".join(self.group())
        if name == "array" and self.peek() == "{":
            self.group()
        self.alignment(name)

    def inside(self, scope: Scope) -> Iterator[Occurrence]:
        """The letters of one TeX argument."""
        if self.i >= len(self.texts):
            return
        if self.peek() != "{":
            yield from self.run(scope, self.i + 1)
            return
        start = self.i
        self.group()
        end, self.i = self.i, start + 1
        yield from self.run(scope, end - 1)
        self.i = end

    def script(self, scope: Scope, role: str) -> Iterator[Occurrence]:
        self.i += 1
        yield from self.inside(Scope(role, scope.by, exponent=scope.exponent))

    def bounded(self, scope: Scope) -> Iterator[Occurrence]:
        """A sum or product: the letters below it, before a sign of relation, are its indices."""
        self.i += 1
        while self.peek() in ("_", "^") or self.peek() in SPACES:
            below = self.peek() == "_"
            self.i += 1
            if not below:
                if self.peek(-1) == "^":
                    yield from self.inside(Scope(scope.role or "bound", scope.by, exponent=scope.exponent))
                continue
            start = self.i
            tokens = self.group()
            end, self.i = self.i, start + (self.peek_at(start) == "{")
            signs = [k for k, text in enumerate(tokens) if text in ("=", r"\in")]
            ends = ("".join(tokens[signs[0] + 1 :]) if signs else "", self.above(end))
            for index in self.run(Scope("index", scope.by), self.i + (signs[0] if signs else len(tokens))):
                yield replace(index, arguments=ends)
            yield from self.run(Scope(scope.role or "bound", scope.by, exponent=scope.exponent), end)
            self.i = end

    def above(self, place: int) -> str:
        """The upper bound that stands here, as text."""
        if self.peek_at(place) != "^":
            return ""
        kept, self.i = self.i, place + 1
        text = "".join(self.group()) if self.i < len(self.texts) else ""
        self.i = kept
        return text

    def peek_at(self, place: int) -> str:
        try:
            return self.texts[place]
        except IndexError:
            return ""

    def differential(self) -> bool:
        """Is the d here followed by a letter?"""
        ahead = 1
        while self.peek(ahead) in SPACES:
            ahead += 1
        return tex.is_letter(self.peek(ahead)) and self.peek(ahead) not in FUNCTIONS_SPELLED

    def fraction(self, scope: Scope) -> Iterator[Occurrence]:
        """A fraction; one of differentials is a derivative, with what it applies to above or behind it."""
        self.i += 1
        start = self.i
        above = self.group() if self.i < len(self.texts) else []
        middle = self.i
        below = self.group() if self.i < len(self.texts) else []
        end = self.i
        if not all(map(_begins_with_differential, (above, below))) or len(below) < 2:
            self.i = start
            yield from self.inside(scope)
            yield from self.inside(scope)
            return
        variables = list(self.differentials(middle, end, "variable"))
        yield from variables
        by = _spelled(variables)
        yield from self.differentials(start, middle, "derived", by)
        self.i = end
        if all(text in _OF_DIFFERENTIALS or text.isdigit() for text in above):
            yield from self.operand(scope, by)

    def slash(self) -> int:
        """The place of the slash of a derivative such as dx/dt that begins here, or 0."""
        kept = self.i
        self.i += 1
        if self.peek() == "^":
            self.i += 1
            self.group()
        derived = [*self.letter(Scope())] if tex.is_letter(self.peek()) else []
        while self.peek() in SPACES:
            self.i += 1
        middle, self.i = self.i, kept
        behind = next((k for k in range(middle + 1, len(self.texts)) if self.peek_at(k) not in SPACES), 0)
        sure = derived and self.peek_at(middle) == "/" and self.peek_at(behind) == self.peek()
        return middle if sure and tex.is_letter(self.peek_at(behind + 1)) else 0

    def slashed(self, scope: Scope, middle: int) -> Iterator[Occurrence]:
        """The letters of a derivative that is printed with a slash, the lower one first."""
        start, self.i = self.i, middle + 1
        while self.peek() not in ("d", r"\partial"):
            self.i += 1
        self.i += 1
        variables = [*self.letter(Scope("variable", scope.by))]
        end = self.i
        yield from variables
        yield from self.differentials(start, middle, "derived", _spelled(variables))
        self.i = end

    def differentials(self, start: int, end: int, role: str, by: tuple[str, ...] = ()) -> Iterator[Occurrence]:
        """The letters behind the d in one part of a derivative."""
        self.i = start + (self.peek_at(start) == "{")
        behind = ""  # the d that ends before this place, with its power
        while self.i < end:
            text = self.peek()
            before = behind or (self.peek(-1) if self.i else "")
            if self.wholes and (whole := self.whole())[0]:
                yield Occurrence(whole[0], whole[1], role=role, by=by, before=before)
            elif text in ("d", r"\partial"):
                self.i, behind = self.i + 1, text
                if self.peek() == "^":
                    self.i += 1
                    self.group()
                continue
            elif text in (r"\mathrm", r"\text") and "".join(self.texts[self.i + 1 : self.i + 4]) == "{d}":
                self.i += 4
            elif tex.is_letter(text) and text not in FUNCTIONS_SPELLED:
                places = [*self.letter(Scope(role, by))]
                yield from [replace(place, before=before) for place in places[: bool(behind)]]
                yield from places[bool(behind) :]
            else:
                self.i += 1
            behind = ""

    def operand(self, scope: Scope, by: tuple[str, ...]) -> Iterator[Occurrence]:
        """What stands behind an operator such as d/dx: one factor, or what is in brackets."""
        while self.peek() in _UNPRINTED:
            self.i += 1
        if self.peek() in _ENDS_OPERATOR and (behind := self.behind_brackets()):
            here, self.i = self.i, behind  # it is an addend of an operator in brackets
            yield from self.operand(scope, by)
            self.i = here
        elif self.peek() in OPEN:
            yield from self.run(Scope("derived", by), self.closing())
        elif tex.is_letter(self.peek()) and self.peek() not in FUNCTIONS_SPELLED:
            yield from self.letter(Scope("derived", by))
        elif self.i < len(self.texts):
            yield from self.run(Scope("derived", by), len(self.texts))

    def behind_brackets(self) -> int:
        """The place behind the brackets around what stands here, or 0 where nothing is behind them."""
        depth = 0
        for k in range(self.i, len(self.texts) - 1):
            depth += (self.texts[k] in OPEN) - (self.texts[k] in CLOSE)
            if depth < 0:
                return k + 1
        return 0

    def closing(self) -> int:
        """The place of the bracket that closes the one here, or the end."""
        depth = 0
        for k in range(self.i, len(self.texts)):
            depth += (self.texts[k] in OPEN) - (self.texts[k] in CLOSE)
            if depth == 0:
                return k
        return len(self.texts)

    def letter(self, scope: Scope) -> Iterator[Occurrence]:
        """One letter with its scripts and arguments; then the letters in these."""
        start, before, k = self.i, "", self.i
        while not before and (k := k - 1) >= 0:
            before = self.texts[k] if self.texts[k] not in SPACES else ""
        try:
            word, dots = undotted(self.spelling())
        except SymcheckError:
            self.i = start + 1
            return
        number = word in NUMBERS and self.peek() == "_"
        if (word.removeprefix(r"\text{").removesuffix("}") in FUNCTIONS or known(word)) and not number:
            return
        primes, scripts, inner = 0, dict[str, tuple[str, ...]](), list[Occurrence]()
        transposed = False
        while self.peek() in ("_", "^", "'") and self.peek() not in scripts:
            mark = self.peek()
            self.i += 1
            if mark == "'":
                primes += 1
                continue
            place = self.i
            tokens = self.group() if self.i < len(self.texts) else ()
            if mark == "^" and tuple(words(tokens)) in TRANSPOSED:
                transposed = True
                continue
            if mark == "^" and tokens and set(tokens) <= {"'", r"\prime"}:
                primes += len(tokens)
                continue
            end, self.i = self.i, place
            power = mark == "^" and word in ("e", r"\text{e}")
            inner += self.inside(
                Scope("subscript" if mark == "_" else scope.role, scope.by, exponent=power or scope.exponent)
            )
            self.i = end
            scripts[mark] = tokens
        behind = self.peek_at(self.behind())
        arguments = None if behind == "_" else self.arguments()  # what is in brackets with a subscript is a factor
        if arguments == (word,):
            arguments = None  # and so is the letter itself
        after = next((text for text in self.texts[self.i :] if text not in _UNPRINTED), "")
        if k > 0 and (before, after) == ("(", ")") and self.peek_at(k - 1) in DIFFERENTIALS:
            before = self.peek_at(k - 1)  # alone in brackets behind the d
        yield Occurrence(
            word,
            dots,
            primes,
            scripts.get("_"),
            scripts.get("^"),
            arguments,
            scope.role,
            before,
            after,
            scope.by,
            exponent=scope.exponent,
            transposed=transposed,
            powered=arguments is not None and behind == "^",
            followed=word[:1] == "\\" and self.vector_follows(),
        )
        yield from inner

    def behind(self) -> int:
        """The place behind the brackets that follow here, or here where none do."""
        start, ahead = self.i, self.i
        while self.peek_at(ahead) in SIZES:
            ahead += 1
        if self.peek_at(ahead) != "(":
            return start
        self.i = ahead
        end, self.i = self.closing() + 1, start
        return end

    def vector_follows(self) -> bool:
        """Does a small bold letter stand behind this letter and its arguments, without a sign?"""
        ahead = self.behind()
        while self.peek_at(ahead) in SPACES or self.peek_at(ahead) in ACCENTS or self.peek_at(ahead) == "{":
            ahead += 1
        inner = self.peek_at(ahead + 2 if self.peek_at(ahead + 1) == "{" else ahead + 1)
        return self.peek_at(ahead) in BOLD and inner.lstrip("\\")[:1].islower()

    def arguments(self) -> tuple[str, ...] | None:
        """The texts between round brackets that open here, without moving on."""
        ahead = self.i
        while self.peek_at(ahead) in SIZES:
            ahead += 1
        if self.peek_at(ahead) != "(":
            return None
        found, depth, parts = list[str](), 0, list[list[str]]([[]])
        for k in range(ahead, len(self.texts)):
            text = self.texts[k]
            depth += (text in _OPENING) - (text in _CLOSING)
            if depth == 0:
                if parts[0][:1] == [r"\prescript"] and self.transposed(k + 1):
                    return None  # they are needed around a letter in a frame
                if self.peek_at(ahead + 1) == r"\begin" and _MATRIX.fullmatch(" ".join(self.texts[ahead + 1 : k])):
                    return None  # they are those of a matrix
                break
            if text == "," and depth == 1:
                parts.append([])
            elif not (text == "(" and depth == 1 and not parts[0]) and text not in _UNPRINTED:
                parts[-1].append(text)
        found = [" ".join(part) for part in parts]
        return tuple(found)


# a matrix or an array without brackets of its own
_MATRIX = re.compile(r"\\begin \{ (m a t r i x|a r r a y) \} (?:(?!\\begin).)*\\end \{ \1 \}(?: \\right)?")
_UNPRINTED = SPACES | SIZES
_ENDS_OPERATOR = frozenset({*CLOSE, "+", "-"})
_OPENING, _CLOSING = frozenset({*OPEN, "{", r"\langle"}), frozenset({*CLOSE, "}", r"\rangle"})
_OF_DIFFERENTIALS = DIFFERENTIALS | {"^", "{", "}"}


def _begins_with_differential(part: Sequence[str]) -> bool:
    """Is the first sign a d, upright or not, or a curly one, and no letter that something is added to?"""
    first = [*itertools.islice((text for text in part if text not in _BEFORE_SIGN), 2)]
    if first[1:] in (["+"], ["-"]):
        return False
    behind = [*itertools.dropwhile(_BEFORE_SIGN.__contains__, part)]
    upright = behind[:1] in ([r"\mathrm"], [r"\text"]) and behind[1:4] == ["{", "d", "}"]
    return upright or first[:1] in (["d"], [r"\partial"])


def _spelled(variables: Sequence[Occurrence]) -> tuple[str, ...]:
    """The letters by which it is differentiated, with their subscripts, and without those in these."""
    own = [each for each in variables if each.role == "variable"]
    return tuple(x.word + (tex.subscript(x.subscript) if x.subscript else "") for x in own)


_BEFORE_SIGN = SPACES | {"{", "}"}
FUNCTIONS_SPELLED = frozenset(f"\\{name}" for name in COMMANDED) | {r"\operatorname"}


def words(tokens: Sequence[str] | None) -> list[str]:
    """The tokens of a script that are letters or numbers."""
    return [text for text in tokens or () if text not in _NO_WORDS]


_NO_WORDS = {"{", "}", ","} | ROMAN | SPACES
