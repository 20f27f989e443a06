r"""Formulas in the expanded tokens of LaTeX: displays row by row, and inline relations, with labels and numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain

from symcheck.document.macros import MISSING, Expander, Tok, argument, bare, optional, tokens, written
from symcheck.document.printed import Fault, Printed, place
from symcheck.document.units import LISTS, Told, stated
from symcheck.reading import split_tag

ROWS = frozenset(
    {"align", "alignat", "flalign", "xalignat", "xxalignat", "gather", "eqnarray", "IEEEeqnarray", "darray"}
)
WHOLE = frozenset({"equation", "displaymath", "multline", "dmath", "math", "IEEEeqnarraybox"})
INNER = frozenset({"split", "aligned", "alignedat", "gathered", "multlined", "aligned*", "equation", "equation*"})
NUMBERED = (ROWS | WHOLE) - {"displaymath", "math", "xxalignat", "IEEEeqnarraybox"}
COLUMNS = frozenset({"alignat", "xalignat", "xxalignat", "alignedat", "IEEEeqnarray", "darray"})  # take an argument
ENDING = frozenset({r"\par", r"\item", r"\\", "&"})  # the paragraph, an item or a cell
# environments whose letters are their own
LOCAL = re.compile(
    r"example|exercise|problem|question|solution|proof|theorem|lemma|corollary|remark|case|exer|exm", re.I
)
HEADINGS = {r"\part": 0, r"\chapter": 1, r"\section": 2, r"\subsection": 3, r"\subsubsection": 4}
LEVELS = ("part", "chapter", "section", "subsection", "subsubsection")
BOOKS = ("book", "report", "memoir", "scrbook", "scrreprt")  # number formulas within chapters
_SIGNS = (
    "le leq leqslant ge geq geqslant ne neq equiv approx sim simeq cong propto coloneqq triangleq doteq ll gg lesssim "
    "gtrsim"
)
_ARROWS = "implies iff to mapsto in subset Rightarrow Longrightarrow Leftrightarrow Longleftrightarrow rightarrow"
RELATIONS = frozenset({"=", "<", ">", *(f"\\{name}" for name in _SIGNS.split())})
ARROWS = frozenset(f"\\{name}" for name in _ARROWS.split())
STEPPING = frozenset({r"\Longrightarrow", r"\Rightarrow", r"\implies"})  # between the equations of a derivation
# before a display, or a row of it, that follows from what stands above it
LEADING = STEPPING | {r"\rightarrow", r"\longrightarrow", r"\to", r"\therefore"}
WIDE = frozenset({r"\quad", r"\qquad"})
PARTS = frozenset({r"\text", r"\textrm", r"\mbox", r"\forall", r"\exists", r"\land", r"\lor", r"\wedge", r"\vee"})
BINARY = frozenset({"+", "-", r"\cdot", r"\times", r"\pm", r"\mp", "/", "*"})
CLOSING = {r"\[": r"\]", r"\(": r"\)", "$$": "$$", "$": "$"}
# `\thesection.\arabic{equation}`: the number of formulas within something
_WITHIN = re.compile(
    r"(?:\{?\\the(chapter|section|subsection)\}?|\\arabic\{(chapter|section)\})\.?\\arabic\{equation\}"
)
_ENVIRONMENT = re.compile(r"\\(begin|end)\{(.*)\}", re.DOTALL)  # as one token
BEFORE = frozenset(
    {"", "=", ",", r"\in", r"\subset", r"\cup", r"\quad", r"\qquad", r"\times", r"\colon", ":"}
)  # an operand
BEHIND = frozenset({".", ",", ";", r"\quad", r"\qquad", r"\,", "~"})  # an environment that is all of a formula
TAIL = 30  # tokens at the end of a row in which its number may stand: `\quad (12.34a)`
APART = frozenset({r"\quad", r"\qquad", r"\\", "&", ";", ",", ".", "~"})  # what stands before the number of an item
MAX_PROSE = 60  # words before a formula that are looked at: two sentences


@dataclass
class Counters:
    """The counters of LaTeX, as far as formulas are numbered by them."""

    known: bool = False  # in a whole document; nobody knows the numbers in a part of one
    within: str = ""
    values: dict[str, int] = field(default_factory=dict)
    appendix: bool = False
    letter: int = 0  # within subequations the last letter, as a number

    def heading(self, level: str) -> None:
        self.values[level] = self.values.get(level, 0) + 1
        if level != "part":
            for lower in LEVELS[LEVELS.index(level) + 1 :]:
                self.values[lower] = 0
        if self.within and LEVELS.index(level) <= LEVELS.index(self.within) and level != "part":
            self.values["equation"] = 0

    def next(self) -> str:
        """The number of the next formula."""
        if self.letter:
            self.letter += 1
            return self._shown(self.values.get("equation", 0)) + chr(ord("a") + (self.letter - 2) % 26)
        self.values["equation"] = self.values.get("equation", 0) + 1
        return self._shown(self.values["equation"])

    def _shown(self, number: int) -> str:
        levels = LEVELS[1 : LEVELS.index(self.within) + 1] if self.within else ()
        used = [level for level in levels if level != "chapter" or "chapter" in self.values]
        parts = [str(self.values.get(level, 0)) for level in used]
        if self.appendix and parts:
            parts[0] = chr(ord("A") + (int(parts[0]) - 1) % 26)
        return ".".join([*parts, str(number)])


EQUALS = re.compile(r"\$\s*=\s*$")  # words between two formulas within a line, which are one
# words before letters that may be anything, and perhaps others of these between
ANEW = re.compile(r"\b(?:any|all|every|each|arbitrary|two|let)\b[\w\s-]*(?:\$(?:\s|,|and|or)*)*$", re.IGNORECASE)

# words beside a letter that call it the identity matrix
IDENTITY = re.compile(
    r"\b[Ii]dentity(?: matrix)? \$([^$]+)\$|\$([^$]+)\$ (?:is|denotes|being) (?:the|an) (?:[\w$-]+ )?identity\b"
)


@dataclass
class Scanner:
    """Collects the formulas of a document from its expanded tokens."""

    expander: Expander
    found: list[Printed] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)
    counters: Counters = field(default_factory=Counters)
    cell: int = 0
    section: int = 0
    part: int = 0  # headings so far
    mentions: list[tuple[str, int]] = field(default_factory=list)
    prose: list[str] = field(default_factory=list)
    above: Sequence[Tok] = ()  # the formula of the last display, if no other stands behind it
    anew: list[str] = field(default_factory=list)
    local: list[int] = field(default_factory=list)
    places: int = 0  # environments of their own so far
    told: list[Told] = field(default_factory=list)
    units: set[str] = field(default_factory=set)  # the letters that words call identity matrices, bare
    paragraph: list[str] = field(default_factory=list)  # its words, inline formulas between dollars
    lines: list[tuple[str, int]] = field(default_factory=list)  # these formulas
    chapter: int = 0
    beside: Sequence[Tok] = ()  # the last formula within a line
    titled: bool = False  # does it begin with a heading?
    listed: bool = False  # does it stand in a list of symbols?

    def run(self, toks: list[Tok]) -> None:
        """A whole document, or a part of one."""
        k = 0
        while k < len(toks):
            tok = toks[k]
            environment = _ENVIRONMENT.fullmatch(tok.text)
            if environment:
                k = self._environment(toks, k, *environment.groups())
            elif tok.text in CLOSING:
                k = self._delimited(toks, k)
            else:
                k = self._text(toks, k)
        self.end()

    def words(self, text: str) -> None:
        """Words between formulas."""
        self.prose.append(text)
        self.paragraph.append(" " if text in ("$", "~", "{", "}") else text.replace("$", " "))

    def end(self) -> None:
        """A paragraph ends, or a display parts it: what is said in it of letters."""
        self.prose.append(" ")
        text = "".join(self.paragraph)
        self.units |= {bare(each) for found in IDENTITY.finditer(text) for each in found.groups() if each}
        if self.titled and text.strip():
            self.titled, self.listed = False, LISTS.match(text) is not None
        scope = None if self.listed else (self.section, self.local[-1] if self.local else 0)
        for letter, unit in stated(text) if self.lines else ():
            line = next((line for latex, line in self.lines if latex.startswith(letter)), 0)
            self.told.append(Told(letter, unit, place("", line, self.cell), scope))
        self.paragraph.clear()
        self.lines.clear()

    def _environment(self, toks: list[Tok], k: int, which: str, name: str) -> int:
        plain = name.rstrip("*")
        if plain in ROWS | WHOLE and which == "begin":
            end = _end(toks, k, name)
            if end < 0:
                self._fault(toks[k], rf"\begin{{{name}}} is never closed")
                return k + 1
            self.display(toks[k + 1 : end], name)
            return end + 1
        if plain in ROWS | WHOLE:
            self._fault(toks[k], rf"\end{{{name}}} closes nothing")
        elif name == "subequations":
            if which == "begin":
                self.counters.next()
            self.counters.letter = int(which == "begin")
        elif LOCAL.search(name):
            self.places += 1
            self.local = [*self.local, self.places] if which == "begin" else self.local[:-1]
        return k + 1

    def _delimited(self, toks: list[Tok], k: int) -> int:
        opening = toks[k].text
        end = _closing(toks, k)
        if end < 0:
            self._fault(toks[k], f"{opening} is never closed")
            return k + 1
        body = [*toks[k + 1 : end]]
        if opening in ("$$", r"\["):
            self.display(body, opening)
        else:
            self.inline(body)
        if opening == "$" and toks[end].text == "$$":  # two formulas side by side
            toks[end] = toks[end]._replace(text="$")
            return end
        return end + 1

    def _text(self, toks: Sequence[Tok], k: int) -> int:
        """What stands between formulas: headings, counters and words."""
        text = toks[k].text
        stack = [*reversed(toks[k + 1 : k + 400])] if text in _READ else []
        before = len(stack)
        if text in HEADINGS:
            starred = bool(stack) and stack[-1].text == "*"
            self.heading(LEVELS[HEADINGS[text]], numbered=not starred)
        elif text == MISSING:
            self.counters.known = False
        elif text == r"\appendix":
            self.counters.appendix = True
            self.counters.values |= {"chapter": 0} if "chapter" in self.counters.values else {"section": 0}
        elif text == r"\documentclass":
            optional(stack)
            self.counters.known = True
            self.counters.within = "chapter" if written(argument(stack)) in BOOKS else ""
        elif text in (r"\numberwithin", r"\counterwithin"):
            if written(argument(stack)) == "equation" and (level := written(argument(stack))) in LEVELS:
                self.counters.within = level
        elif text in (r"\setcounter", r"\addtocounter"):
            name, value = written(argument(stack)), written(argument(stack))
            number = re.fullmatch(r"-?\d+", value)
            if number and name in (*LEVELS, "equation"):
                old = self.counters.values.get(name, 0) if text == r"\addtocounter" else 0
                self.counters.values[name] = old + int(value)
            elif name == "equation":
                self.counters.known = False
        elif toks[k].is_space:
            self.words(" ")
            if text.count("\n") > 1:
                self.end()
        else:
            self.words(text if text[:1] != "\\" else " ")
            if text in ENDING:
                self.end()
        return k + 1 + before - len(stack)

    def heading(self, level: str, *, numbered: bool = True) -> None:
        """A part of the document begins: definitions may be others in it."""
        self.end()
        self.titled = True
        if numbered:
            self.counters.heading(level)
        self.part += 1
        if level in ("part", "chapter", "section"):
            self.section += 1
            self.chapter += level != "section"
        self.prose.clear()
        self.anew.clear()

    def _fault(self, tok: Tok, message: str) -> None:
        self.faults.append(Fault(len(self.found), place(tok.file, tok.line, self.cell), message))

    def display(self, body: Sequence[Tok], name: str, label: str = "") -> None:
        """A display: its formulas, each with all of its rows."""
        self.end()
        body = _without_arguments(body, name)
        self._brackets(body)
        counts = name in NUMBERED
        plain = name.rstrip("*")
        rows = _rows(body) if plain in ROWS else [[*body]]
        numbered = [_numbered(row) for row in rows]
        numbers = [self._number(row, counts) for row in numbered]
        parts: list[tuple[Row, list[str], list[str]]] = []
        for row, number in zip(numbered, numbers, strict=True):
            if not _trimmed(row.toks):
                continue
            for inner in [row.toks] if plain == "multline" else self._inner(row):
                if parts and _continues(parts[-1][0].toks, inner):
                    last, labels, shown = parts[-1]
                    parts[-1] = Row(_joined(last.toks, inner)), [*labels, row.label], [*shown, number]
                else:
                    parts.append((Row(inner), [row.label], [number]))
        for row, labels, shown in parts:
            for formula in chain.from_iterable(map(_steps, _columns(row.toks))):
                labelled = ", ".join(dict.fromkeys(x for x in (*labels, label) if x))
                self._keep(formula, labelled, ", ".join(dict.fromkeys(filter(None, shown))), display=True)
        self.prose.clear()

    def _brackets(self, body: Sequence[Tok]) -> None:
        """A fault where a bracket has no partner; half-open intervals have one of the other kind."""
        opened: list[Tok] = []
        plain = _without_words(body)
        for k, tok in enumerate(plain):
            before = plain[k - 1].text if k else ""
            closes = bool(opened) and opened[-1].text == "["  # as in [a \times], a matrix
            mirrored = tok.text == "]" and before in BEFORE and not closes  # as in ]a, b[
            if tok.text == "[" and opened and opened[-1].text == "]":
                opened.pop()
            elif mirrored or before == r"\left" or (tok.text in ("(", "[") and before != r"\right"):
                opened.append(tok)
            elif before == r"\right" or tok.text in (")", "]"):
                if opened:
                    opened.pop()
                elif not _ends_number(plain[max(0, k - 3) : k]):
                    self._fault(tok, f"{tok.text} closes nothing")
                    return
        if opened:
            self._fault(opened[-1], f"{opened[-1].text} is never closed")

    def _number(self, row: Row, counts: bool) -> str:
        if row.tag:
            return row.tag
        if not counts or row.unnumbered:
            return ""
        number = self.counters.next()
        theirs = self.expander.macros.get(r"\theequation")
        if theirs is not None:
            within = _WITHIN.fullmatch(written(theirs.body).replace(" ", ""))
            if within is None:
                return ""
            self.counters.within = within[1] or within[2]
        return number if self.counters.known else ""

    def _inner(self, row: Row) -> list[list[Tok]]:
        """The rows of the environment that is all of this one, or itself."""
        toks = _trimmed(row.toks)
        match = _ENVIRONMENT.fullmatch(toks[0].text) if toks else None
        name = match[2] if match and match[1] == "begin" else ""
        if name in INNER or name.rstrip("*") in ROWS:
            end = _end(toks, 0, name)
            if end >= 0 and all(t.is_space or t.text in BEHIND for t in toks[end + 1 :]):
                inside = [_numbered(part).toks for part in _rows(_without_arguments(toks[1:end], name))]
                return [found for part in inside if part for found in self._inner(Row(part))]
        return [_numbered(part).toks for part in _rows(row.toks)]

    def put(self, content: str, line: int, label: str = "", *, display: bool = True) -> None:
        """A formula of another markup, which may be an environment of LaTeX."""
        toks = [*self.expander.run(tokens(content.strip("\n"), "", line))]
        first = next((tok.text for tok in toks if not tok.is_space), "")
        if display and first.startswith(r"\begin{") and first[7:-1].rstrip("*") in ROWS | WHOLE:
            self.run(toks)
        elif display:
            self.display(toks, "$$", label)
        else:
            self.inline(toks, label)

    def inline(self, body: Sequence[Tok], label: str = "") -> None:
        """A formula within a line, if it is a relation, or one side of `$x$ = $y$`."""
        if EQUALS.search("".join(self.prose[-MAX_PROSE:])) and self.beside and body:
            body = [*self.beside, body[0]._replace(text="="), *body]
        self.beside = body
        latex = written(body)
        self.paragraph.append(f"${latex}$")
        self.lines.append((latex, next((tok.line for tok in body if not tok.is_space), 0)))
        if any(tok.text in RELATIONS for tok in _outermost(body)):
            self._keep([*body], label, "", display=False)
        else:
            self.mentions.append((latex, len(self.found)))
            if any(tok.text == r"\in" for tok in body) or ANEW.search("".join(self.prose[-MAX_PROSE:])):
                self.anew.append(latex)
        self.prose.append("$")

    def _keep(self, toks: Sequence[Tok], label: str, number: str, *, display: bool) -> None:
        before = " ".join("".join(self.prose).split()[-MAX_PROSE:])
        if display and (led := _led(toks)) is not None:
            toks, before = led, before or "Hence"
        first = next((tok for tok in toks if not tok.is_space), None)
        begun = display and not before and first is not None and first.text in RELATIONS
        above = _last_side(self.above) if begun else []
        toks = [*above, *toks]
        latex, tag = split_tag(written(toks).replace("^{}", ""))
        if not latex or first is None:
            return
        self.above = toks if display else ()
        scope = (self.section, self.local[-1] if self.local else 0)
        self.found.append(
            Printed(
                latex,
                first.file,
                first.line,
                self.cell,
                label,
                number or tag or "",
                display,
                before,
                scope,
                self.part,
                tuple(self.anew),
                bool(above),
                self.chapter,
            )
        )


_READ = frozenset({*HEADINGS, r"\documentclass", r"\numberwithin", r"\counterwithin", r"\setcounter", r"\addtocounter"})


@dataclass
class Row:
    """One row of a display without its marks."""

    toks: list[Tok]
    label: str = ""
    tag: str = ""
    unnumbered: bool = False


def _numbered(toks: Sequence[Tok]) -> Row:
    r"""A row, with its \label and \tag taken off."""
    row = Row([])
    stack = [*reversed(toks)]
    while stack:
        tok = stack.pop()
        if tok.text == r"\label":
            row.label = written(argument(stack))
        elif tok.text in (r"\tag", r"\eqno", r"\leqno"):
            if stack and stack[-1].text == "*":
                stack.pop()
            inside = argument(stack)
            if tok.text != r"\tag" and inside and inside[0].text == "(":
                inside += [stack.pop() for _ in range(len(stack)) if inside[-1].text != ")"]
            row.tag = written(inside).strip("()$ ")
        elif tok.text in (r"\notag", r"\nonumber"):
            row.unnumbered = True
        elif tok.text in (r"\intertext", r"\shortintertext"):
            argument(stack)
        else:
            row.toks.append(tok)
    if (tag := split_tag(written(row.toks[-TAIL:]))[1]) and not row.tag:
        row.tag = tag
        while row.toks and row.toks.pop().text != "(":
            pass
    return row


def _without_arguments(body: Sequence[Tok], name: str) -> list[Tok]:
    """The body of an environment without what the environment itself takes."""
    stack = [*reversed(body)]
    if name.rstrip("*") in COLUMNS:
        optional(stack)
        argument(stack)
    elif name in INNER and name not in ("split", "equation", "equation*") and stack and stack[-1].text == "[":
        optional(stack)
    return [*reversed(stack)]


def _without_words(toks: Sequence[Tok]) -> list[Tok]:
    """The tokens without spaces, and without what stands in text."""
    found: list[Tok] = []
    stack = [*reversed(toks)]
    while stack:
        tok = stack.pop()
        if tok.text in (r"\text", r"\mbox", r"\textrm", r"\tag", r"\label", r"\intertext"):
            argument(stack)
        elif not tok.is_space:
            found.append(tok)
            if tok.text == r"\begin{array}":
                optional(stack)
                argument(stack)
    return found


def _ends_number(before: Sequence[Tok]) -> bool:
    """Do these tokens, which stand before a bracket, begin the number of an item, as in `12)` and `a)`?"""
    texts = [tok.text for tok in before]
    while texts and len(texts[-1]) == 1 and texts[-1].isalnum():
        texts.pop()
    return len(texts) < len(before) and (not texts or texts[-1] in APART or texts[-1].startswith(r"\begin{"))


def _depths(toks: Sequence[Tok]) -> Iterator[tuple[Tok, int]]:
    """Each token with the number of braces and environments around it."""
    depth = 0
    for tok in toks:
        opens = tok.text == "{" or tok.text.startswith(r"\begin{")
        closes = tok.text == "}" or tok.text.startswith(r"\end{")
        depth -= closes
        yield tok, depth
        depth += opens


def _outermost(toks: Sequence[Tok]) -> Iterator[Tok]:
    return (tok for tok, depth in _depths(toks) if depth <= 0)


def _last_side(toks: Sequence[Tok]) -> list[Tok]:
    """The last side of a relation, or of a chain of them; nothing if there is no relation."""
    found: list[Tok] = []
    related = False
    for tok, depth in _depths(toks):
        if depth <= 0 and tok.text in RELATIONS:
            found, related = [], True
        elif depth > 0 or tok.text != "&":
            found.append(tok)
    return found if related else []


def _rows(body: Sequence[Tok]) -> list[list[Tok]]:
    rows: list[list[Tok]] = [[]]
    for tok, depth in _depths(body):
        if depth == 0 and tok.text in (r"\\", r"\cr"):
            rows.append([])
        else:
            rows[-1].append(tok)
    for row in rows[1:]:
        stack = [*reversed(row)]
        if stack and stack[-1].text == "*":
            stack.pop()
        if stack and stack[-1].text == "[":
            length = optional([*stack])
            if length and re.fullmatch(r"-?[\d.]+\s*[a-z]{2}|.*\\\w+.*", written(length)):
                optional(stack)
        row[:] = reversed(stack)
    return rows


# what may stand before the first sign of a row
_IDLE = frozenset({"&", r"\quad", r"\qquad", r"\,", r"\;", r"\!", "{", "}", "~", r"\:"})


def _continues(before: Sequence[Tok], row: Sequence[Tok]) -> bool:
    """Does a row go on with the formula of the rows before it?"""
    printed = [tok.text for tok in row if not tok.is_space]
    begins = next((text for text in printed if text not in _IDLE), "")
    if not begins:
        return True
    last = next((tok.text for tok in reversed(before) if not tok.is_space and tok.text not in ("&", "~")), "")
    led = _led(row)
    if led is not None and _is_equation(before) and _is_equation(led):
        return False
    if begins in RELATIONS | ARROWS or last in RELATIONS | BINARY or _open(before):
        return True
    empty = next(text for text in printed if text not in "{}") == "&"
    related = any(tok.text in RELATIONS for tok in _outermost(row))
    if empty and not related and last not in (",", ";", ".") and any(tok.text in RELATIONS for tok in before):
        return True  # a factor
    return (begins in BINARY or begins in (")", "]", r"\right")) and (empty or not related)


def _joined(before: Sequence[Tok], row: Sequence[Tok]) -> list[Tok]:
    """A row behind those with which it goes on; a sign that is printed at both ends of the break stands once."""
    last = next((tok for tok in reversed(before) if not tok.is_space and tok.text != "&"), None)
    first = next((k for k, tok in enumerate(row) if not tok.is_space and tok.text != "&"), 0)
    twice = last is not None and row and last.text == row[first].text and last.text in RELATIONS | BINARY
    return [*before, *row[:first], *row[first + bool(twice) :]]


def _open(toks: Sequence[Tok]) -> bool:
    """Is a round or square bracket still open?"""
    texts = [tok.text for tok in toks]
    return texts.count("(") > texts.count(")") and texts.count("[") >= texts.count("]")


def _columns(toks: Sequence[Tok]) -> list[list[Tok]]:
    """The formulas side by side in a row of several columns; otherwise the row without its alignment."""
    cells: list[list[Tok]] = [[]]
    for tok, depth in _depths(toks):
        if depth == 0 and tok.text == "&":
            cells.append([])
        else:
            cells[-1].append(tok)
    pairs = [[*chain.from_iterable(cells[k : k + 2])] for k in range(0, len(cells), 2)]
    pairs = [pair for pair in pairs if any(not tok.is_space for tok in pair)]
    if len(pairs) > 1 and all(sum(t.text in RELATIONS for t in _outermost(pair)) for pair in pairs):
        starts = [next(t.text for t in pair if not t.is_space) for pair in pairs]
        if not any(text in RELATIONS for text in starts):
            return pairs
    return [[*chain.from_iterable(cells)]]


def _steps(toks: Sequence[Tok]) -> list[list[Tok]]:
    r"""The equations of a derivation on one line, `A \quad\Longrightarrow\quad B`, of which each is said to hold.

    An arrow without space around it, behind a value or an equation to be solved, belongs to one statement.
    """
    steps: list[list[Tok]] = [[]]
    for tok, depth in _depths(toks):
        if depth == 0 and tok.text in STEPPING and steps[-1] and _ends_wide(steps[-1]):
            steps.append([])
        else:
            steps[-1].append(tok)
    wide = all(_ends_wide([*reversed(step)]) for step in steps[1:])
    if len(steps) == 1 or not (wide and all(map(_is_equation, steps)) and all(map(_is_general, steps[:-1]))):
        return [[*toks]]
    return [_without_width(step) for step in steps]


def _led(toks: Sequence[Tok]) -> Sequence[Tok] | None:
    """What stands behind an arrow at the beginning; None if there is none."""
    kept = [k for k, tok in enumerate(toks) if not (tok.is_space or tok.text in WIDE or tok.text == "&")]
    return toks[kept[1] :] if len(kept) > 1 and toks[kept[0]].text in LEADING else None


def _without_width(toks: Sequence[Tok]) -> list[Tok]:
    kept = [k for k, tok in enumerate(toks) if not (tok.is_space or tok.text in WIDE)]
    return [*toks[kept[0] : kept[-1] + 1]]


def _ends_wide(toks: Sequence[Tok]) -> bool:
    return next((tok.text in WIDE for tok in reversed(toks) if not tok.is_space), False)


def _is_equation(toks: Sequence[Tok]) -> bool:
    signs = {tok.text for tok in _outermost(toks)}
    return "=" in signs and not signs & (RELATIONS | ARROWS) - {"="} and not signs & PARTS


def _is_general(toks: Sequence[Tok]) -> bool:
    """Is it an equation of more than one letter and its value, or of a function and zero?"""
    texts = [tok.text for tok in toks if not tok.is_space and tok.text not in WIDE]
    sides = " ".join(texts).split(" = ")
    return min(len(side.split()) for side in sides) > 1


def _trimmed(toks: Sequence[Tok]) -> list[Tok]:
    kept = [k for k, tok in enumerate(toks) if not tok.is_space]
    return [*toks[kept[0] : kept[-1] + 1]] if kept else []


def _end(toks: Sequence[Tok], k: int, name: str) -> int:
    """Where the environment that begins here ends; -1 if it does not."""
    depth = 0
    for m in range(k, len(toks)):
        text = toks[m].text
        depth += (text == rf"\begin{{{name}}}") - (text == rf"\end{{{name}}}")
        if not depth:
            return m
        if text in HEADINGS or text == r"\end{document}":
            return -1
    return -1


def _closing(toks: Sequence[Tok], k: int) -> int:
    """Where the formula that begins here ends; -1 if it does not."""
    opening = toks[k].text
    depth = 0
    for m in range(k + 1, len(toks)):
        text = toks[m].text
        depth += (text == "{") - (text == "}")
        if depth <= 0 and (text == CLOSING[opening] or (opening == "$" and text == "$$")):
            return m
        ends = text in HEADINGS or text == r"\end{document}" or (opening != "$$" and text == opening != "$")
        if ends or (opening in ("$", r"\(") and text.count("\n") > 1):
            return -1
    return -1
