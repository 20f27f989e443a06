"""From TeX tokens to the tokens of the grammar: letters are looked up, layout is dropped, line breaks are settled."""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NoReturn

from symcheck.reading import tex
from symcheck.reading.commands import ROMAN, known
from symcheck.reading.functions import NAMES
from symcheck.reading.notation import Notation, undotted
from symcheck.reading.tree import Name

FUNCTIONS = NAMES
COMMANDED = NAMES - {"vec"}  # of these, behind a backslash: \vec is an arrow
THIN = frozenset([r"\,", r"\!", r"\displaystyle", r"\limits", r"\nolimits"])
THICK = frozenset([r"\;", r"\:", "\\ ", "~"])
WIDE = frozenset([r"\quad", r"\qquad", r"\hfill"])
SPACES = THIN | THICK | WIDE
SIZES = frozenset(
    {"\\left", "\\right"} | {f"\\{size}{side}" for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r")}
)
ENVIRONMENTS = frozenset(
    {
        "aligned",
        "align",
        "align*",
        "array",
        "split",
        "cases",
        "gathered",
        "gather",
        "equation",
        "multline",
        "displaymath",
    }
)
VALUES = "values by cases"  # the environment of that kind
CONDITIONS = frozenset({"if", "for", "when", "where", "as", "in", "on", "at"})
OTHERWISE = frozenset({"otherwise", "else", "elsewhere"})
MATRICES = frozenset({"smallmatrix", *(f"{side}matrix{star}" for side in ("", "p", "b", "B") for star in ("", "*"))})
RELATIONS = {
    "=": "=", "<": "<", ">": ">", r"\lt": "<", r"\gt": ">", r"\ne": r"\ne", r"\neq": r"\ne",
    r"\le": r"\le", r"\leq": r"\le", r"\leqslant": r"\le", r"\ge": r"\ge", r"\geq": r"\ge", r"\geqslant": r"\ge",
    r"\in": r"\in", r"\subset": r"\subset", r"\approx": r"\approx", r"\equiv": r"\equiv",
    **{sign: sign for sign in (
        r"\to", r"\rightarrow", r"\leftarrow", r"\longrightarrow", r"\mapsto", r"\sim", r"\propto", r"\simeq", r"\cong",
        r"\ll", r"\gg", r"\subseteq", r"\supset", r"\perp", r"\parallel", r"\notin", r"\prec", r"\succ", r"\doteq",
        r"\subsetneq", r"\supseteq", r"\leftrightarrow", r"\lesssim", r"\gtrsim", r"\preceq", r"\succeq", r"\asymp",
    )},
}  # fmt: skip
LOGIC = {
    r"\land": "AND", r"\wedge": "AND", r"\lor": "OR", r"\vee": "OR", r"\exists": "EXISTS",
    **dict.fromkeys((r"\implies", r"\Rightarrow", r"\Longrightarrow"), "IMPLIES"),
    **dict.fromkeys((r"\iff", r"\Leftrightarrow", r"\Longleftrightarrow"), "IFF"),
}  # fmt: skip
TAKING = {r"\sqrt": ("SQRT", 1), **dict.fromkeys((r"\frac", r"\dfrac", r"\tfrac"), ("FRAC", 2))}  # TeX arguments
TAKING |= dict.fromkeys((r"\binom", r"\dbinom", r"\tbinom"), ("BINOMIAL", 2))
OPEN = {"(": "LPAR", "[": "LBRA", r"\{": "LSET", r"\lbrace": "LSET", r"\lfloor": "LFLOOR", r"\lceil": "LCEIL"}
CLOSE = {")": "RPAR", "]": "RBRA", r"\}": "RSET", r"\rbrace": "RSET", r"\rfloor": "RFLOOR", r"\rceil": "RCEIL"}
PARTNER = {
    "RFLOOR": "LFLOOR", "RCEIL": "LCEIL",
    "RPAR": "LPAR", "RBRA": "LBRA", "RSET": "LSET", "RB": "LB", "RBAR": "LBAR", "RNORM": "LNORM", "MEND": "MBEGIN",
    "RANGLE": "LANGLE", "RHALF": "LHALF", "RLIST": "LLIST", "CEND": "CBEGIN",
}  # fmt: skip
SIMPLE = {
    "+": "PLUS", "-": "MINUS", "/": "SLASH", r"\div": "SLASH", r"\cdot": "CDOT", r"\times": "TIMES", ",": "COMMA",
    ";": "SEMI", ":": "COLON", r"\dots": "DOTS", r"\ldots": "DOTS", r"\cdots": "DOTS", r"\vdots": "DOTS",
    r"\ddots": "DOTS",
    "!": "BANG", r"\pm": "PM", r"\mp": "PM", r"\infty": "INFINITY", r"\langle": "LANGLE",
}  # fmt: skip
OPERATORS = frozenset(  # between two terms, of which no notation says what they are
    {
        r"\otimes", r"\oplus", r"\ominus", r"\odot", r"\boxplus", r"\boxminus", r"\setminus", r"\bmod", r"\mod",
        r"\circ",
        r"\star", r"\cup", r"\cap", r"\bullet", r"\diamond", r"\ltimes", r"\rtimes",
    }
)  # fmt: skip
CLOSED = frozenset({r"\oint", r"\iint", r"\iiint"})  # integrals over curves, surfaces and bodies
LIMITING = frozenset({"lim", "min", "max", "sup", "inf", "argmin", "argmax", "limsup", "liminf"})
MARKS = frozenset(
    {"+", "-", "*", r"\#", r"\dagger", r"\star", r"\ddagger", r"\sharp", r"\flat", r"\perp", r"\parallel"}
)  # scripts that are no power
SETS = frozenset(
    {
        r"\substack",
        r"\bmod",
        r"\mod",
        r"\in",
        "<",
        ">",
        r"\le",
        r"\leq",
        r"\ge",
        r"\geq",
        r"\ne",
        r"\neq",
        r"\notin",
        r"\subset",
    }
)
NUMBERS = frozenset({r"\text{Re}", r"\text{Pr}"})  # with an index they are no functions
BASES = {"10": "lg", "2": "lb", "e": "ln"}  # of logarithms, with the functions that they are
_ENDS = frozenset(
    {"MARK", "BLANK", "NUMBER", "NAME", "BANG", "TRANSPOSE", "DEGREE", "PRIMES", "DOTS", "INFINITY", *PARTNER}
)
_OPERATORS = frozenset(
    {"OPERATOR", "PLUS", "MINUS", "PM", "REL", "AND", "OR", "IMPLIES", "IFF", "CDOT", "TIMES", "SLASH"}
)
_FIELDS = {r"\cdot": "div", r"\times": "curl", "^": "laplacian"}  # operators, by what stands behind \nabla
_ENDS_OPERATOR = frozenset({")", "]", r"\right", "", "+", "-", "=", ",", "&", r"\\", r"\quad"})
_BEHIND_POINT = frozenset({"}", ")", r"\right", "+", "-", "/", "*", r"\cdot", r"\times"})
_MARKED = frozenset({"RPAR", "RBRA", "RSET", "RNORM", "RBAR", "MEND", "RFLOOR"})  # what may have a mark
_BREAKS = frozenset({"COMMA", "SEMI", "COLON", "FOR"})
_NO_FACTORS = _OPERATORS | _BREAKS
WIDE_COMMA = r",\quad"
COMMA_AT_END = r",\\"  # of a line
PARTING = {"and": "COMMA", "for": "FOR"}  # words between relations
_JOINS = (
    _OPERATORS
    | _BREAKS
    | frozenset({"NEWLINE", "CELL", "ROW", "CARET", "MID", "MARK", "TRANSPOSE", "DEGREE", "PRIMES", *PARTNER})
)
# The tokens that may be left out, doubled or exchanged for another of them where the statement stays the same: spaces,
# line breaks and alignment, sizes of brackets, the sign of a product, what separates relations or ends a sentence.
LAYOUT = SPACES | SIZES | frozenset({"&", r"\\", r"\cdot", ",", ";", "."})


@dataclass(frozen=True, slots=True)
class Lexeme:
    """One token of the grammar; `value` is a Name, a number, a sign or the printed text."""

    type: str
    value: Any
    at: int


_FORMULA_IN_TEXT = re.compile(r"\\\{|\(\)|\([^()]*[_^]\{")  # a brace, or scripts in brackets: `\mathrm{Var(x_i)}`


class Lexer(tex.Reader):
    """Reads one formula under one notation; `lexemes` is the result."""

    def __init__(self, source: str, notation: Notation) -> None:
        super().__init__(source)
        self.notation = notation
        self.out: list[Lexeme] = []
        self.open: list[Lexeme] = []
        self.environments: list[tuple[str, int]] = []
        self.lefts: list[tuple[str, int]] = []
        self.closes: dict[int, str] = {}  # the brackets that stand for those on one side only, by their places
        self.spaced: set[int] = set()  # places of tokens behind an explicit space
        self.bounds = -1  # where the sign of a sum or an integral with its bounds ends

    def lexemes(self) -> list[Lexeme]:
        """All tokens, or SymcheckError at the first place that cannot be one."""
        while self.i < len(self.texts):
            self.step()
        if self.open:
            self.fail("unbalanced bracket: this one is never closed", self.open[-1].at)
        if self.environments:
            self.fail(rf"\begin{{{self.environments[-1][0]}}} is never ended", self.environments[-1][1])
        if self.lefts:
            self.fail(r"this \left has no \right", self.lefts[-1][1])
        return self.joined()

    def emit(self, kind: str, value: Any, at: int) -> None:
        """One more token; brackets are matched here."""
        lexeme = Lexeme(kind, value, at)
        if kind in PARTNER:
            opening = self.open.pop() if self.open else None
            if opening is not None and self.half_open(opening, kind):
                ends = f"{opening.value}{value}"
                self.out[self.out.index(opening)] = Lexeme("LHALF", ends, opening.at)
                lexeme = Lexeme("RHALF", ends, at)
            elif opening is None or opening.type != PARTNER[kind]:
                self.fail("unbalanced bracket: nothing of this kind is open", at)
        elif kind in PARTNER.values():
            self.open.append(lexeme)
        self.out.append(lexeme)

    def last(self) -> str:
        """The type of the last token that is no space; the empty text at the beginning."""
        return next((lexeme.type for lexeme in reversed(self.out) if lexeme.type != "GAP"), "")

    def half_open(self, opening: Lexeme, kind: str) -> bool:
        r"""Is this the end of an interval `[a, b)` or `(a, b]`, behind `\in`?"""
        if (opening.type, kind) not in {("LBRA", "RPAR"), ("LPAR", "RBRA")}:
            return False
        return self.is_member(opening)

    def is_member(self, opening: Lexeme) -> bool:
        r"""Does this bracket stand behind `\in`?"""
        before = [lexeme for lexeme in self.out[: self.out.index(opening)] if lexeme.type != "GAP"]
        return bool(before) and (before[-1].type, before[-1].value) == ("REL", r"\in")

    def mean_ends(self) -> None:
        r"""`\rangle_\psi`: the end of an average, with the phase or without, of a list or a scalar product."""
        at = self.at()
        self.i += 1
        if self.peek() != "_":
            opening = self.open[-1] if self.open else None
            between = self.out[self.out.index(opening) :] if opening in self.out else []
            kinds = [each.type for each in between if each.type != "GAP"]
            paired = kinds[1:2] in (["LBAR"], ["LNORM"]) and "MID" not in kinds  # around all of it
            bars = not paired and any(kind in ("MID", "LBAR", "LNORM") for kind in kinds)  # of states
            listed = self.notation.inferred or any(each.type == "COMMA" for each in between)
            if bars:
                self.fail("brackets of states are not read; say in other words what they hold", at)
            if opening in self.out and self.is_member(opening):
                self.fail("an average, or all that is made of what these brackets hold? say what it is", at)
            if opening is None or opening.type != "LANGLE" or not listed:
                self.fail("an average needs the letter it is taken over", at)
            self.out[self.out.index(opening)] = self.open[-1] = Lexeme("LLIST", opening.value, opening.at)
            self.emit("RLIST", r"\rangle", at)
            return
        self.i += 1
        place = self.at()
        word = tex.spelled("".join(f"{text} " for text in self.group()))
        if word is None or self.notation.find(word, 0) is None:
            self.unknown(word or "here", place)
        self.emit("RANGLE", Name(word), at)

    def step(self) -> None:
        """The next token, command or letter."""
        text, at = self.texts[self.i], self.places[self.i]
        if len(text) == 1 and text.isalpha():
            if not (self.notation.wholes and self.whole()):
                self.letter()
        elif text in SPACES:
            self.space()
        elif (self.notation.wholes and self.whole()) or self.condition() or self.parting():
            return
        elif text.isdigit() and text.isascii():
            self.number()
        elif text in SIZES:
            self.sized()
        elif text in (r"\begin", r"\end"):
            self.environment()
        elif text in ("&", r"\\"):
            self.cell()
        elif text == r"\mid" and self.mid():
            return
        elif text == r"\middle" and self.peek(1) == "|":
            self.i += 2
            self.emit("MID", "|", at)
        elif text in ("|", r"\|", r"\Vert"):
            self.bar()
        elif text in TAKING:
            self.i += 1
            kind, count = TAKING[text]
            if text == r"\sqrt" and self.peek() == "[":
                self.emit("ROOT", text, at)
                self.order()
            else:
                self.emit(kind, text, at)
            for _ in range(count):
                self.argument()
        elif text == r"\overline" and self.overlined():
            return
        elif text in CLOSED:
            self.over_domain()
        elif text in (r"\sum", r"\prod", r"\int"):
            self.bounded({r"\sum": "SUM", r"\prod": "PROD"}.get(text, "INT"))
        elif self.limiting():
            return
        elif text == r"\forall":
            if self.last() in _ENDS:
                self.emit("COMMA", WIDE_COMMA, at)
            self.i += 1
            self.emit("FORALL", text, at)
        elif text == r"\rangle":
            self.mean_ends()
        elif text == r"\nabla":
            self.nabla()
        elif text in "^'":
            self.refuse_bracketed()
            self.script()
        elif text == "_":
            self.evaluated(at)
        elif text == "." and self.sentence_ends():
            self.i += 1
        elif text in OPEN or text in CLOSE:
            self.i += 1
            self.emit(OPEN.get(text) or CLOSE[text], text, at)
        elif text == ";" and self.parameters():
            self.i += 1
            self.emit("MID", ";", at)
        elif text == "*" or text in OPERATORS:
            self.i += 1
            self.emit("CDOT" if text == "*" and self.star_multiplies() else "OPERATOR", text, at)
        elif text in "+-" and self.peek(1) == "=":
            self.fail(f"{text}= assigns a value and states nothing; write an equation")
        elif text in SIMPLE or text in RELATIONS or text in LOGIC:
            self.i += 1
            kind = SIMPLE.get(text) or LOGIC.get(text) or "REL"
            self.emit(kind, RELATIONS.get(text, text), at)
        elif text == r"\partial" and self.peek(1) == "_":
            self.derivative()
        elif tex.is_letter(text) or text == r"\partial" or text[1:] in COMMANDED:
            self.letter()
        else:
            meant = self.notation.resembling(text)
            said = tex.no_letter(text) if known(text) else f"{text} cannot be read here"
            self.fail(f"{said}, or did you mean {meant}?" if meant else said)

    def nabla(self) -> None:
        r"""`\nabla` that makes no name with the letter behind it: an operator on fields, or one that stands alone."""
        at, below = self.at(), ""
        self.i += 1
        if self.peek() == "_":
            self.i += 1
            below = tex.subscript(self.group())
        while self.peek() in SPACES:
            self.i += 1
        if self.peek() in _ENDS_OPERATOR:
            self.emit("NAME", Name(rf"\nabla{below}"), at)
            return
        kind = _FIELDS.get(self.peek(), "grad")
        if self.peek() in _FIELDS:
            self.i += 1
        if kind == "laplacian" and self.group() != ("2",):
            self.fail(r"a power of \nabla other than 2", at)
        self.emit("FN", f"{kind}{below}", at)

    def derivative(self) -> None:
        r"""`\partial_x`, `\partial_t^2`: derivatives of what follows by what stands below."""
        at = self.at()
        self.i += 2
        below = [text for text in self.group() if text not in SPACES]
        if self.peek() == "^":
            self.i += 1
            order = "".join(self.group())
            if not order.isdigit() or len(below) != 1:
                self.fail("a derivative of which order? write it as a fraction", at)
            below *= int(order)
        self.emit("FN", f"derivative{tex.subscript(below)}", at)

    def overlined(self) -> bool:
        """A line over more than one letter: a mean, or what is conjugate, of all of it."""
        start, at = self.i, self.at()
        self.i += 1
        if not self.peek() or tex.spelled(" ".join(self.group())) is not None:
            self.i = start
            return False
        stop, self.i = self.i - 1, start + 2
        self.emit("FN", "overlined", at)
        self.emit("LPAR", "(", at)
        while self.i < stop:
            self.step()
        if self.i != stop:
            self.fail("unbalanced brace", at)
        self.i += 1
        self.emit("RPAR", ")", at)
        return True

    def space(self) -> None:
        """A space; what it means where it could part two things is settled in `joined`."""
        text, at = self.peek(), self.at()
        self.i += 1
        comma = self.last() == "COMMA" and self.out[-1].type == "COMMA"
        if comma and text not in THIN:
            self.out[-1] = Lexeme("COMMA", WIDE_COMMA, self.out[-1].at)
        elif text not in THIN and len(self.out) != self.bounds:
            self.out.append(Lexeme("GAP", text, at))
        if text not in (r"\!", r"\displaystyle", r"\limits", r"\nolimits"):
            self.spaced.add(self.at())

    def star_multiplies(self) -> bool:
        """Is the star of this display the sign of a product: does it stand beside a number anywhere?"""
        three = zip(self.texts, self.texts[1:], self.texts[2:], strict=False)
        beside = (a + b for a, text, b in three if text == "*")
        return any(char.isdigit() for both in beside for char in both)

    def sentence_ends(self) -> bool:
        """Is this full stop the last thing on its line?"""
        ahead = 1
        while self.peek(ahead) in SPACES or self.peek(ahead) == r"\end":
            ahead += 1
            if self.peek(ahead - 1) == r"\end":
                while self.peek(ahead) not in ("}", ""):
                    ahead += 1
                ahead += 1
        return self.peek(ahead) in ("", r"\\")

    def number(self) -> None:
        """Digits, with a decimal point between digits; `1).` at the beginning of a clause is the label of a case."""
        at, text = self.at(), self.digits()
        if len(text) > 1 and text[0] == "0":
            self.fail("a number with a zero before it", at)
        if self.peek() == "." and self.peek(1).isdigit() and self.peek(1).isascii():
            self.i += 1
            text += "." + self.digits()
        elif self.peek() == "." and self.peek(1) in _BEHIND_POINT and text:
            self.i += 1  # a point without decimals
        if self.peek() == ")" and not self.open and self.clause_begins():
            text += ")." if self.peek(1) == "." else ")"
            self.i += text.endswith(".") + 1
            self.emit("LABEL", text, at)
        else:
            self.emit("NUMBER", text, at)

    def digits(self) -> str:
        text, start = "", self.at()
        while self.peek().isdigit() and self.peek().isascii():
            if self.at() != start + len(text):
                self.fail("two numbers with nothing but a space between them; write one number, or a sign")
            text += self.peek()
            self.i += 1
        return text

    def clause_begins(self) -> bool:
        return self.last() in {"", "COMMA", "SEMI", "NEWLINE"}

    def argument(self) -> None:
        """One TeX argument as a bracketed run of tokens."""
        while self.peek() in SPACES:
            self.i += 1
        at = self.at()
        end = self.i + self.length()
        self.emit("LB", "{", at)
        braced = self.peek() == "{"
        self.i += braced
        environments, lefts = len(self.environments), len(self.lefts)
        if not braced and self.peek().isdigit() and self.peek().isascii():
            self.emit("NUMBER", self.peek(), self.at())
            self.i += 1
        else:
            stop = end - braced
            while self.i < stop:
                self.step()
            if self.i != stop:
                self.fail("unbalanced brace", at)
        self.i = end
        if len(self.environments) != environments or len(self.lefts) != lefts:
            self.fail("unbalanced environment in an argument", at)
        self.emit("RB", "}", at)

    def order(self) -> None:
        """The order of a root, in square brackets, as a TeX argument."""
        at = self.at()
        self.emit("LB", "[", at)
        self.i += 1
        while self.peek() not in ("]", ""):
            self.step()
        if not self.peek():
            self.fail("unbalanced bracket: this one is never closed", at)
        self.i += 1
        self.emit("RB", "]", at)

    def length(self) -> int:
        """The number of TeX tokens of the next argument, braces included."""
        start = self.i
        self.group()
        size, self.i = self.i - start, start
        return size

    def sized(self) -> None:
        r"""`\left(`: only the bracket counts; `\left.` and `\right.` are layout."""
        text, at = self.peek(), self.at()
        self.i += 1
        bracket = self.peek()
        if text == r"\left":
            self.lefts.append((bracket, at))
        elif text == r"\right":
            if not self.lefts:
                self.fail(r"\right without \left", at)
            self.lefts.pop()
        if text == r"\left" and bracket == ".":
            self.one_sided()
        if self.i in self.closes:
            kind = self.closes[self.i]
            self.i += 1
            self.emit(kind, "[" if kind == "LBRA" else "(" if kind == "LPAR" else "]" if kind == "RBRA" else ")", at)
        elif bracket == ".":
            self.i += 1
        elif bracket in ("|", r"\|", r"\Vert"):
            self.bar(opening={r"\left": True, r"\right": False}.get(text))
        elif bracket not in OPEN and bracket not in CLOSE and bracket not in (r"\langle", r"\rangle"):
            self.fail(f"a bracket must follow {text}")

    def one_sided(self) -> None:
        r"""`\left. f \right|_{x = a}`: what is taken at a place, as in brackets on both sides."""
        depth = 1
        for k in range(self.i + 1, len(self.texts) - 2):
            depth += (self.texts[k] == r"\left") - (self.texts[k] == r"\right")
            if depth:
                continue
            if self.texts[k + 1] in ("|", ")", "]") and self.texts[k + 2] == "_":
                start, self.i = self.i, k + 3
                place = "=" in self.group()
                self.i = start
                self.closes[start], self.closes[k + 1] = ("LBRA", "RBRA") if place else ("LPAR", "RPAR")
            return

    def bar(self, opening: bool | None = None) -> None:
        """Bars: one that can close an open one closes it."""
        text, at = self.peek(), self.at()
        self.i += 1
        kind = "BAR" if text == "|" else "NORM"
        if opening is None and text == "|" and self.divides():
            self.emit("MID", text, at)
            return
        if opening is None:
            opening = not (self.open and self.open[-1].type == f"L{kind}" and self.last() in _ENDS)
        self.emit(f"{'L' if opening else 'R'}{kind}", text, at)

    def parameters(self) -> bool:
        """Is this semicolon the only one in the round brackets behind a letter: `f(x; p)`?"""
        opening = self.open[-1] if self.open else None
        if opening is None or opening.type != "LPAR":
            return False
        start = self.out.index(opening)
        before = self.out[start - 1] if start else None
        if before is None or before.type != "NAME" or any(x.type in ("MID", "SEMI") for x in self.out[start:]):
            return False
        ahead = self.texts[self.i + 1 :]
        return ";" not in ahead[: ahead.index(")")] if ")" in ahead else False

    def mid(self) -> bool:
        """A bar that is printed as a sign of relation, in brackets."""
        at, self.i = self.at(), self.i + 1
        if self.divides():
            self.emit("MID", "|", at)
            return True
        self.i -= 1
        return False

    def divides(self) -> bool:
        """Is this bar, behind its token, the only one in the brackets of a letter: `p(a | b)`?"""
        opening = self.open[-1] if self.open else None
        if opening is None or opening.type not in ("LPAR", "LBRA") or self.last() not in _ENDS:
            return False
        start = self.out.index(opening)
        if (
            not start
            or self.out[start - 1].type not in ("NAME", "FN")
            or any(x.type in ("MID", "LBAR") for x in self.out[start:])
        ):
            return False
        depth = 1
        for text in self.texts[self.i :]:
            depth += (text in OPEN) - (text in CLOSE)
            if not depth:
                return True
            if text in ("|", r"\mid"):
                return False
        return False

    def lists_values(self) -> bool:
        """Is the environment that begins here the whole formula, and its first cell a value?"""
        ahead = [text for text in self.texts[self.i :] if text not in SPACES]
        first = ahead.index("&") if "&" in ahead else len(ahead) - 1
        apart = any(text in RELATIONS for text in ahead[: first + 2])
        return ahead[-8:-7] == [r"\end"] and r"\end" not in ahead[:-8] and first < len(ahead) - 8 and not apart

    def condition(self) -> bool:
        """A word before a condition in a list of values, which is layout, or the one that stands for the rest."""
        if not self.environments or self.environments[-1][0] != VALUES or self.peek() not in ROMAN:
            return False
        start, at = self.i, self.at()
        self.i += 1
        word = "".join(text for text in self.group() if text not in SPACES).strip(",.:").lower()
        if word in CONDITIONS:
            return True
        if word in OTHERWISE:
            self.emit("OTHERWISE", word, at)
            return True
        self.i = start
        return False

    def parting(self) -> bool:
        r"""`\text{and}`, which parts relations, or `\text{for}`, behind which a condition stands."""
        if self.peek() != r"\text" or self.open:
            return False
        start, at = self.i, self.at()
        self.i += 1
        word = "".join(self.group())
        if word not in PARTING:
            self.i = start
            return False
        while self.out and self.out[-1].type in ("GAP", "COMMA", "SEMI", "NEWLINE"):
            self.out.pop()
        if self.out:
            self.emit(PARTING[word], word, at)
        while self.peek() in SPACES | {",", ":"}:
            self.i += 1
        return True

    def environment(self) -> None:
        r"""`aligned` and its kin are layout; matrices keep their cells. An array in brackets is a matrix."""
        begin, at = self.peek() == r"\begin", self.at()
        self.i += 1
        name = "".join(self.group())
        if name not in ENVIRONMENTS | MATRICES:
            self.fail(f"unknown environment {name}", at)
        if begin:
            behind = self.last() in _OPERATORS | _ENDS - {"DOTS", "MARK"}
            if name == "cases" and (behind or (not self.last() and self.lists_values())):
                self.environments.append((VALUES, at))
                self.emit("CBEGIN", name, at)
                return
            self.alignment(name)
            if name == "array":
                self.group()
                inside = self.last() in {"LPAR", "LBRA", "LBAR", "LNORM"}
                name = "array matrix" if inside else name
            self.environments.append((name, at))
            if name not in ENVIRONMENTS:
                self.emit("MBEGIN", name, at)
            return
        opened = self.environments.pop()[0] if self.environments else ""
        if opened == VALUES and name == "cases":
            while self.out and self.out[-1].type in ("GAP", "ROW"):
                self.out.pop()
            self.emit("CEND", name, at)
            return
        if opened.removesuffix(" matrix") != name:
            self.fail(rf"\end{{{name}}} does not match \begin{{{opened}}}", at)
        if opened not in ENVIRONMENTS:
            while self.out and self.out[-1].type == "GAP":
                self.out.pop()
            if self.last() == "ROW":
                self.out.pop()
            if self.last() == "CELL":
                self.emit("BLANK", "", at)
            self.emit("MEND", name, at)

    def cell(self) -> None:
        text, at = self.peek(), self.at()
        self.i += 1
        in_matrix = bool(self.environments) and self.environments[-1][0] not in ENVIRONMENTS
        if text == r"\\" and self.peek() == "[" and self.peek(1).isdigit() and self.spacing_follows():
            while self.peek() != "]":
                self.i += 1
            self.i += 1
        if in_matrix:
            if self.last() in ("MBEGIN", "CELL") or (self.last() == "ROW" and text == "&"):
                self.emit("BLANK", "", at)
            self.emit("ROW" if text == r"\\" else "CELL", text, at)
        elif text == r"\\":
            self.emit("NEWLINE", text, at)
        elif self.environments and self.environments[-1][0] == "cases":
            self.fail("a value with its condition cannot be read; state one implication for each case", at)
        elif len(self.out) != self.bounds:
            self.emit("GAP", text, at)

    def spacing_follows(self) -> bool:
        """Is this `[` the beginning of a length such as `[2pt]`?"""
        ahead = 1
        while self.peek(ahead).isdigit() or self.peek(ahead) in (".", ","):
            ahead += 1
        unit = self.peek(ahead) + self.peek(ahead + 1)
        return unit in {"pt", "em", "ex", "mm", "cm"} and self.peek(ahead + 2) == "]"

    def limiting(self) -> bool:
        r"""`\lim_{x \to 0}`, `\min_x`, `\arg\min_x`: the operator with what is printed below it."""
        if self.peek()[:1] != "\\":
            return False
        start, at = self.i, self.at()
        operator = ""
        while self.peek()[:1] == "\\" and not operator.endswith(("lim", "min", "max", "sup", "inf")):
            text = self.peek()
            self.i += 1
            if text in ROMAN and self.peek() == "{":
                text = "".join(text for text in self.group() if text not in SPACES)
            elif text in SPACES:
                continue
            operator += text.removeprefix("\\")
            if not any(name.startswith(operator) for name in LIMITING):
                break
        if operator in ("min", "max") and self.peek() in (r"\sum", r"\int", r"\max", r"\min"):
            self.emit("UNDER", (operator, ""), at)
            return True
        if operator not in LIMITING or self.peek() != "_" or self.notation.knows(self.texts[start]):
            self.i = start
            return False
        self.i += 1
        below = " ".join(self.group())
        if not below:
            self.fail("an empty subscript", at)
        self.emit("UNDER", (operator, f"_{{ {below} }}"), at)
        self.bounds = len(self.out)
        return True

    def bounded(self, kind: str) -> None:
        """The sign of a sum or an integral with its bounds, the lower one first."""
        at = self.at()
        self.i += 1
        if kind != "INT" and (scripts := self.over_set()):
            self.emit("UNDER", ({"SUM": "sum"}.get(kind, "prod"), scripts), at)
            self.bounds = len(self.out)
            return
        bounds: dict[str, list[Lexeme]] = {}
        while self.peek() in SPACES:
            self.i += 1
        start = self.i
        while self.peek() in ("_", "^") and self.peek() not in bounds:
            which = self.peek()
            self.i += 1
            mark = len(self.out)
            self.argument()
            bounds[which] = self.out[mark:]
            del self.out[mark:]
        if not bounds and kind == "SUM":
            self.emit("UNDER", ("sum", ""), at)
            return
        if "_" not in bounds and kind != "INT":
            self.fail("a sum without an index", at)
        if len(bounds) < 2 and kind == "INT":
            if "^" in bounds or any(lexeme.type in ("NUMBER", "INFINITY") for lexeme in bounds.get("_", [])[1:2]):
                self.fail("an integral with one bound", at)
            if bounds:
                below = " ".join(self.texts[start : self.i])
                self.emit("OVER", (r"\int", below), at)
                return
            if "d" not in self.texts[self.i :]:  # over something that is not printed
                self.emit("UNDER", ("int", ""), at)
                return
            self.emit("ANTI", r"\int", at)
            return
        self.emit(kind, {"SUM": r"\sum", "PROD": r"\prod"}.get(kind, r"\int"), at)
        self.out += bounds["_"] + bounds.get("^", [])
        self.bounds = len(self.out)

    def over_domain(self) -> None:
        r"""`\oint f \, ds`, `\iint_D f \, dA`: the sign of such an integral, with what is printed below it."""
        sign, at = self.peek(), self.at()
        self.i += 1
        start = self.i
        if self.peek() == "_":
            self.i += 1
            self.group()
        if self.peek() == "^":
            self.fail(f"{sign} with two bounds", at)
        self.emit("OVER", (sign, " ".join(self.texts[start : self.i])), at)

    def over_set(self) -> str:
        r"""The scripts of a sum that are no bounds, as printed: `_{i \in S}`, `_{i < j}`, `_i^N`; else nothing."""
        start, found = self.i, dict[str, str]()
        while self.peek() in ("_", "^") and self.peek() not in found:
            mark = self.peek()
            self.i += 1
            found[mark] = " ".join(self.group())
        below = found.get("_", "").split()
        set_like = SETS & set(below) or below[:1] == ["("] if below else False
        if not below or not (set_like or ("^" in found and "=" not in below)):
            self.i = start
            return ""
        return "".join(f"{mark}{{ {found[mark]} }}" for mark in ("_", "^") if mark in found)

    def evaluated(self, at: int) -> None:
        r"""The place at which what is in brackets, or before a bar, is taken: `_{t=0}^1`."""
        self.i += 1
        sized = self.last() == "NUMBER" and r"\times" in self.texts[self.i : self.i + self.length()]
        closed = (self.last() in _MARKED or sized) and bool(self.out) and self.out[-1].type != "GAP"
        if not closed:
            self.fail("a subscript without a letter before it", at)
        inside = self.texts[self.i : self.i + self.length()]
        if "=" not in inside or self.last() != "RBRA":
            self.group()
            if self.peek() in ("_", "'") or not inside:
                self.fail("a subscript and another script behind a bracket", at)
            self.emit("MARK", f"_{' '.join(inside)}", at)
            return
        mark = len(self.out)
        self.emit("AT", "_", at)
        self.argument()
        if not any(lexeme.value == "=" for lexeme in self.out[mark:]):
            self.fail("a subscript without a letter before it", at)
        if self.peek() == "^":
            self.i += 1
            self.argument()

    def script(self) -> None:
        """An exponent, a transposition, a degree sign or primes behind a bracket."""
        at = self.at()
        if self.peek() == "'":
            start, count = self.i, self.primes()
            if self.peek() != "_" and self.last() in ("RPAR", "RBRA", "MEND"):
                self.emit("MARK", "'" * count, at)
                return
            self.i = start
            self.emit("PRIMES", self.primed(at), at)
            return
        self.i += 1
        inside = [text for text in self.texts[self.i : self.i + self.length()] if text not in {"{", "}"} | ROMAN]
        if len(inside) == 1 and inside[0] in MARKS and self.last() in ("RPAR", "RBRA"):
            self.group()
            self.emit("MARK", f"^{inside[0]}", at)
        elif inside == [r"\circ"]:
            self.group()
            self.emit("DEGREE", None, at)
        elif inside[-1:] in (["T"], [r"\top"], [r"\intercal"]) and inside[:-1] in ([], ["-"]) and self.transposes():
            self.group()
            if inside[:-1]:
                for kind, value in (("CARET", "^"), ("LB", "{"), ("MINUS", "-"), ("NUMBER", "1"), ("RB", "}")):
                    self.emit(kind, value, at)
            self.emit("TRANSPOSE", None, at)
        else:
            self.emit("CARET", "^", at)
            self.argument()

    def transposes(self) -> bool:
        """Is this T the sign of a transposed matrix, and no exponent?"""
        base = next((lexeme for lexeme in reversed(self.out) if lexeme.type != "GAP"), None)
        name = base.value if base is not None and base.type == "NAME" else None
        letter = self.notation.find(name.letter, len(name.subscripts)) if name is not None else None
        return not self.notation.knows("T") or (letter is not None and letter.kind in ("vector", "matrix"))

    def primed(self, at: int) -> tuple[Name, ...]:
        """The letters by which primes behind a bracket differentiate: `(...)''_{aa}`."""
        count = self.primes()
        if self.peek() != "_":
            self.fail("primes behind a bracket need the letter they differentiate by", at)
        self.i += 1
        letters = []
        for tok in self.placed():
            if self.notation.find(tok.text, 0) is None:
                self.unknown(tok.text, tok.at)
            letters.append(Name(tok.text))
        if len(letters) != count:
            self.fail("as many letters are needed as there are primes", at)
        return tuple(letters)

    def primes(self) -> int:
        r"""The number of primes here: `'`, `''`, `^{\prime}`."""
        count = 0
        while (mark := self.peek()) in ("'", "^"):
            start = self.i
            self.i += 1
            inside = (mark,) if mark == "'" else self.group() if self.peek() else ()
            if not inside or any(text not in ("'", r"\prime") for text in inside):
                self.i = start
                return count
            count += len(inside)
        return count

    def letter(self) -> None:
        """A letter with its subscripts, the name of a function, or a differential."""
        at = self.at()
        if self.peek() == r"\partial" or (self.peek()[1:] in COMMANDED and not self.notation.knows(self.peek())):
            word = self.peek()
            self.i += 1
        else:
            word = self.word() or self.spelling()
        plain = word.removeprefix(r"\text{").removesuffix("}").removeprefix("\\")
        number = word in NUMBERS and self.peek() == "_"  # of Reynolds, with an index
        if (
            word.startswith("\\")
            and (plain in (FUNCTIONS if word.startswith(r"\text{") else COMMANDED) or plain == "diag")
            and not (number or self.notation.knows(word))
        ):
            if plain == "log" and self.peek() == "_":
                plain = self.based(at)
            self.emit("DIAG" if plain == "diag" else "FN", plain, at)
            return
        remark = "~" in word and word.startswith(r"\text{") and not self.open
        if remark and self.last() in _ENDS:
            self.emit("COMMA", WIDE_COMMA, at)
        self.name(word, at)
        after = next((text for text in self.texts[self.i :] if text not in SPACES), "") if remark else ""
        if remark and (tex.is_letter(after) or after in ("(", "[", r"\left", r"\begin", r"\frac")):
            self.emit("COMMA", WIDE_COMMA, at)

    def based(self, at: int) -> str:
        r"""The function that `\log_{10}` or `\log_2` is."""
        self.i += 1
        base = "".join(self.group())
        if base not in BASES:
            self.fail(f"a logarithm to the base {base}; write a quotient of logarithms", at)
        return BASES[base]

    def word(self) -> str:
        """A declared letter of several characters, such as `Ox`; the longest that begins here."""
        for word in self.notation.words:
            if all(self.peek(k) == c for k, c in enumerate(word)):
                self.i += len(word)
                return word
        return ""

    def whole(self) -> bool:
        """A declared name that is printed with several tokens, such as `E[\\rho]`; the longest that begins here."""
        for tokens, spelling, dots in self.notation.wholes.get(self.peek(), ()):
            if all(self.peek(k) == text for k, text in enumerate(tokens)):
                at = self.at()
                self.i += len(tokens)
                self.emit("NAME", Name(spelling, (), self.primes(), dots), at)
                return True
        return False

    def bracketed(self) -> str:
        """The superscript in brackets that stands here, `^{(2)}`, or the empty text."""
        if self.peek() != "^" or not self.peek(1):
            return ""
        start = self.i
        self.i += 1
        found = tex.superscript(self.group())
        self.i = start
        return found or ""

    def refuse_bracketed(self, word: str = "") -> None:
        """A superscript in brackets is no power where it may be an index or the order of a derivative.

        It stands behind the letter `word`, or behind the last token.
        """
        if not (text := self.bracketed()):
            return
        base = next((lexeme for lexeme in reversed(self.out) if lexeme.type != "GAP"), None)
        name = Name(word) if word else base.value if base is not None and base.type == "NAME" else None
        letter = self.notation.find(name.letter, len(name.subscripts)) if name is not None else None
        number = name is None and base is not None and base.type == "NUMBER"
        if number or (letter is not None and letter.number):
            return
        shown, inside = name.letter if name is not None else "", text[2:-2].strip("()[]")
        self.fail(
            f"{shown}{text} may be an index, the order of a derivative, or a power: declare {shown or 'a letter '}"
            f"{text}, write primes or a fraction, or write {shown}^{{{inside}}}"
        )

    def name(self, word: str, at: int) -> None:
        if (text := self.bracketed()) and self.notation.knows(word + text):
            word += text
            self.i += 1
            self.group()
        self.refuse_bracketed(word)
        primes = self.primes()
        power: list[Lexeme] = []
        tokens: Sequence[tex.Tok] | None = None
        if self.peek() == "^" and self.subscript_after_exponent():
            mark = len(self.out)
            self.script()
            power = self.out[mark:]
            del self.out[mark:]
        place = self.at(1)
        if self.peek() == "_":
            self.i += 1
            tokens = self.placed()
            if self.peek() == "_":
                self.fail("a second subscript")
        primes += 0 if power else self.primes()
        value, kind = self.declared(word, tokens, primes, at, place)
        self.emit(kind, value, at)
        self.out += power

    def subscript_after_exponent(self) -> bool:
        start = self.i
        self.i += 1
        after = False
        if self.peek():
            self.group()
            after = self.peek() == "_"
        self.i = start
        return after

    def declared(
        self, word: str, tokens: Sequence[tex.Tok] | None, primes: int, at: int, place: int
    ) -> tuple[Name, str]:
        """The letter of the notation that stands here, or SymcheckError."""
        notation = self.notation
        if ("$" in word and "\\" in word[5:]) or _FORMULA_IN_TEXT.search(word):
            self.fail("a formula in text; write it outside of the text", at)
        bare, dots = undotted(word)
        below = tex.subscript([tok.text for tok in tokens]) if tokens else ""
        fixed = bare + below
        if dots and not notation.knows(word) and (notation.knows(bare) or notation.knows(fixed)):
            return self.dotted(word, tokens, primes, at, place)
        if tokens is None:
            letter = notation.find(word, 0)
            if primes and (
                word in (r"\partial", r"\text{d}") or (letter is not None and letter.kind == "differential")
            ):
                self.fail("a differential has no primes", at)
            if letter is not None:
                return Name(word, (), primes), "D" if letter.kind == "differential" else "NAME"
            if notation.index(word) is not None and not primes:
                return Name(word), "NAME"
            differential = notation.find("d", 0) if word == r"\text{d}" else None
            if word == r"\partial" or (differential is not None and differential.kind == "differential"):
                return Name(word), "D"
            self.unknown(word, at)
        if not tokens:
            self.fail("an empty subscript", at)
        fixed = word + below
        if notation.find(fixed, 0) is not None:
            return Name(fixed, (), primes), "NAME"
        if not notation.knows(word) or notation.arities(word) == [0]:
            self.unknown(fixed, at)
        self.refuse_digits(word, tokens, place)
        subscripts = self.indices(tokens, notation.arities(word), place)
        letter = notation.find(word, len(subscripts))
        if letter is None:
            pair = f"; if {word}_{{{tokens[0].text},...}} means several letters, write a relation for each"
            several = pair if any(t.text == "," for t in tokens) else ""
            self.fail(f"{word} is not declared with {len(subscripts)} indices{several}", at)
        for value in subscripts:
            if isinstance(value, int) and value not in letter.range:
                self.fail(f"index {value} of {word} is outside its range {', '.join(map(str, letter.range))}", at)
        return Name(word, subscripts, primes), "NAME"

    def refuse_digits(self, word: str, tokens: Sequence[tex.Tok], at: int) -> None:
        """A run of digits is one number or several indices; where both are declared it may be either."""
        digits, single = "".join(tok.text for tok in tokens), self.notation.find(word, 1)
        if single is None or len(digits) < 2 or not digits.isdigit() or not digits.isascii():
            return
        if int(digits) in single.range and self.notation.find(word, len(digits)) is not None:
            self.fail(f"one index {digits}, or {len(digits)} indices? write commas between them, or name a letter", at)

    def dotted(self, word: str, tokens: Sequence[tex.Tok] | None, primes: int, at: int, place: int) -> tuple[Name, str]:
        """A letter below dots that are its derivative by the time."""
        bare, dots = undotted(word)
        found, kind = self.declared(bare, tokens, primes, at, place)
        letter = self.notation.find(found.letter, len(found.subscripts))
        known = letter is not None and (letter.depends or letter.components or letter.kind == "function")
        if kind != "NAME" or not known:
            self.fail(f"unknown letter {word}: declare it, or say on what {bare} depends, as depends='t'", at)
        return replace(found, dots=dots), kind

    def unknown(self, word: str, at: int) -> NoReturn:
        """The error for a letter that is not declared, or not with so many indices."""
        if arities := self.notation.arities(word):
            self.fail(f"{word} stands without an index but is declared with {' or '.join(map(str, arities))}", at)
        self.fail(tex.no_letter(word) if known(word) else f"unknown letter {word}; {self.notation.nearest(word)}", at)

    def indices(self, tokens: Sequence[tex.Tok], arities: list[int], at: int) -> tuple[int | str, ...]:
        """The indices of a subscript; a run of digits is one number where the letter has one index only."""
        found: list[int | str] = []
        together = max(arities) == 1 or any(t.text == "," for t in tokens)
        fresh = True
        for tok in tokens:
            if tok.text == ",":
                fresh = True
            elif tok.text.isdigit() and tok.text.isascii():
                last = found[-1] if found else None
                if last == 0 and together and not fresh:
                    self.fail("a number with a zero before it", tok.at)
                if together and not fresh and isinstance(last, int):
                    found[-1] = 10 * last + int(tok.text)
                else:
                    found.append(int(tok.text))
                fresh = False
            elif self.notation.index(tok.text) is not None:
                found.append(tok.text)
                fresh = False
            else:
                self.fail(f"{tok.text} is not an index; {self.known_indices()}", tok.at)
        return tuple(found)

    def known_indices(self) -> str:
        return f"the index letters are {', '.join(self.notation.indices()) or 'none'}"

    def parted(self) -> None:
        """Spaces settled: between two factors a wide one parts relations, another may; elsewhere they are layout."""
        out: list[Lexeme] = []
        self.refuse_rows()
        for k, lexeme in enumerate(self.out):
            if lexeme.type != "GAP":
                out.append(lexeme)
                continue
            rest = [after for after in self.out[k + 1 :] if after.type != "GAP"]
            if not out or not rest or out[-1].type not in _ENDS or rest[0].type in _JOINS:
                continue
            left, right = _says(reversed(out), PARTNER), _says(rest, PARTNER.values())
            wide = lexeme.value not in THICK or sum(1 for each in self.out[k : k + 3] if each.type == "GAP") > 2
            if not wide:
                if left and right:
                    self.fail(
                        "does this space part two relations, or two factors? write a comma, or no space", lexeme.at
                    )
            elif left:
                out.append(Lexeme("SEMI", lexeme.value, lexeme.at))
            else:
                self.fail("does this space part two things, or two factors? write a comma, or no space", lexeme.at)
        self.out = out

    def refuse_rows(self) -> None:
        """An error for a row of one column with two signs of relation at alignments, where another row has one."""
        rows: list[list[int]] = [[]]  # where the signs are that stand at an alignment; 0 for an alignment elsewhere
        for lexeme, after in itertools.pairwise(self.out):
            if lexeme.type == "NEWLINE":
                rows.append([])
            elif lexeme.type == "GAP" and lexeme.value == "&":
                rows[-1].append(after.at if after.type == "REL" else 0)
        signs = [[at for at in row if at] for row in rows]
        twice = [b for row in rows for a, b in itertools.pairwise(row) if a and b]
        if twice and any(len(row) == 1 for row in signs):
            self.fail("do several equations stand in a row here? write a line for each", twice[0])

    def relates(self, first: Lexeme) -> bool:
        """Does the line that begins here state a relation of its own, so that it may be none of the line before?"""
        k = self.out.index(first)
        end = next((m for m in range(k, len(self.out)) if self.out[m].type == "NEWLINE"), len(self.out))
        return any(lexeme.type == "REL" for lexeme in self.out[k:end])

    def ordered(self, before: Sequence[Lexeme], first: Lexeme) -> bool:
        """Do the lines before and behind this place both say between which values something lies?"""
        k = self.out.index(first)
        end = next((m for m in range(k, len(self.out)) if self.out[m].type == "NEWLINE"), len(self.out))
        start = max((m for m, lexeme in enumerate(before) if lexeme.type == "NEWLINE"), default=-1)
        signs = [[x.value for x in line if x.type == "REL"] for line in (before[start + 1 :], self.out[k:end])]
        return all(len(line) == 2 and {*line} <= {"<", r"\le"} for line in signs)

    def joined(self) -> list[Lexeme]:
        """Line breaks settled: a sign repeated over a break is one sign; one after a comma or at an end is layout."""
        self.parted()
        self.out = _listed(self.out)
        if (
            self.notation.inferred and self.out and self.out[0].type == "REL"
        ):  # a display that goes on from the one before
            self.out.insert(0, Lexeme("BLANK", "", self.out[0].at))
        out: list[Lexeme] = []
        pending: Lexeme | None = None
        line = 0  # where the line begins
        for lexeme in self.out:
            if lexeme.type == "NEWLINE":
                pending = pending or lexeme
                continue
            if out and out[-1].type == "COMMA" and lexeme.type in ("IMPLIES", "IFF"):
                out.pop()
            if pending and out:
                before = out[-1]
                if lexeme.type == "REL" and _several(out[line:]):
                    self.fail("which of the relations on the line before does this one go on from?", lexeme.at)
                line = len(out)
                if (before.type, before.value) == ("COMMA", ","):
                    out[-1] = Lexeme("COMMA", COMMA_AT_END, before.at)
                if before.type in _OPERATORS:
                    if (before.type, before.value) == (lexeme.type, lexeme.value):
                        pending = None
                        continue
                elif before.type not in _BREAKS and before.type not in PARTNER.values():
                    goes_on = _relates(out) and self.relates(lexeme)
                    if lexeme.type in {"MINUS", "PM"} and goes_on and not self.ordered(out, lexeme):
                        self.fail("a line begins with a sign that the line before does not end with", lexeme.at)
                    begins = lexeme.type == "MINUS" and goes_on
                    if (begins or lexeme.type not in _NO_FACTORS) and lexeme.type not in PARTNER:
                        out.append(pending)
            pending = None
            out.append(lexeme)
        if out and out[-1].type in {"COMMA", "SEMI", "FOR"}:
            out.pop()
        return out


def _several(line: Sequence[Lexeme]) -> bool:
    """Are there several relations on a line, one behind another?"""
    depth, parted = 0, False
    for lexeme in line:
        depth += (lexeme.type in PARTNER.values()) - (lexeme.type in PARTNER)
        if depth == 0 and parted and lexeme.type == "REL":
            return True
        parted |= depth == 0 and lexeme.type in _BREAKS
    return False


def _relates(lexemes: Sequence[Lexeme]) -> bool:
    """Does a relation stand behind the last separator of these?"""
    kinds = [lexeme.type for lexeme in lexemes]
    last = max((k for k, kind in enumerate(kinds) if kind in ("NEWLINE", "SEMI")), default=-1)
    return "REL" in kinds[last + 1 :]


def _listed(lexemes: Sequence[Lexeme]) -> list[Lexeme]:
    r"""The same with the commas of the lists `1 \ldots n` and `x_1, \dots x_n`."""
    if not any(lexeme.type == "DOTS" for lexeme in lexemes):
        return [*lexemes]
    out: list[Lexeme] = []
    for k, lexeme in enumerate(lexemes):
        comma = Lexeme("COMMA", ",", lexeme.at)
        before, behind = lexemes[max(k - 1, 0)], lexemes[min(k + 1, len(lexemes) - 1)]
        if lexeme.type == "DOTS" and behind.type in ("NAME", "NUMBER") and behind is not lexeme and k > 1:
            low = lexeme.value != r"\cdots"
            first = before.type == "NUMBER" and lexemes[k - 2].type in ("REL", "COMMA")
            if (low and first) or _in_row(lexemes, k, low=low):
                out += [comma, lexeme, comma]
                continue
            if low and before.type == "COMMA":
                out += [lexeme, comma]
                continue
        ended = behind is lexeme or behind.type in ("RPAR", "NEWLINE", "GAP", "COMMA", "SEMI")
        if lexeme.type == "DOTS" and ended and k > 1 and before.type == "NUMBER" and lexemes[k - 2].type == "COMMA":
            out.append(comma)
        out.append(lexeme)
    return out


def _in_row(lexemes: Sequence[Lexeme], k: int, *, low: bool) -> bool:
    r"""Are these the dots of two letters in square brackets, as in `[\mathbf{v}_1 \cdots \mathbf{v}_n]`?"""
    ends = [lexeme.type for lexeme in (*lexemes[k - 2 : k], *lexemes[k + 1 : k + 3])]
    row = ends == ["LBRA", "NAME", "NAME", "RBRA"]
    return row and (low or "{" in lexemes[k - 1].value.letter.partition("_")[0])


def _says(lexemes: Iterable[Lexeme], into: Collection[str]) -> bool:
    """Does a sign of relation come before the next separator and the end of this bracket? `into` leads into others."""
    depth = 0
    for lexeme in lexemes:
        if lexeme.type in PARTNER or lexeme.type in PARTNER.values():
            depth += 1 if lexeme.type in into else -1
            if depth < 0:
                return False
        elif not depth and lexeme.type in {"COMMA", "SEMI", "FOR", "NEWLINE", "CELL", "ROW"}:
            return False
        elif not depth and lexeme.type == "REL":
            return True
    return False


def layout(source: str) -> set[int]:
    """Find the tokens of a formula that are layout.

    Parameters
    ----------
    source
        The printed LaTeX.

    Returns
    -------
    set of int
        The places of the tokens of `LAYOUT`, of the names and columns of environments, of one of two equal signs on
        both sides of a line break, and of the transposition of a list in brackets, which prints a column as a row.
    """
    tokens = tex.tokenize(source)
    found = {tok.at for tok in tokens if tok.text in LAYOUT}
    for k, tok in enumerate(tokens):
        if tok.text in (r"\begin", r"\end"):
            end = next((m for m in range(k, len(tokens)) if tokens[m].text == "}"), k)
            if (
                end + 1 < len(tokens) and tokens[end + 1].text == "{" and tokens[end - 1].text == "y"
            ):  # an array's columns
                end = next((m for m in range(end + 1, len(tokens)) if tokens[m].text == "}"), end)
            found.update(each.at for each in tokens[k : end + 1])
    counting = [tok for tok in tokens if tok.at not in found]
    for tok, after in itertools.pairwise(counting):
        broken = r"\\" in source[tok.at : after.at]
        if broken and tok.text == after.text:
            found.update((tok.at, after.at))
    for (a, b), c in zip(itertools.pairwise(tokens), tokens[2:], strict=False):
        if (a.text, b.text, c.text) == ("]", "^", "T"):
            found.update((b.at, c.at))
    return found
