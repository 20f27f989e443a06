r"""Authors' macros: TeX tokens with their places, and what is left when every macro and included file is expanded.

Decision: our own expander, of what authors define and no more. Reason: parsers of LaTeX (pylatexenc, TexSoup) know
macros and do not expand them, and whole TeX engines (plasTeX) lose the printed source and its lines.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from symcheck.core.verdicts import SymcheckError
from symcheck.document.packages import PACKAGES, USUAL

MAX_MADE = 1_000_000  # tokens that macros of one document make; those of a book of 500 pages make half of it
MAX_FILES = 30  # included files within one another; TeX itself has 15
ENDS = "\0"  # begins the token that stands where an included file ends; no text that is read has this character
MISSING = "\1"  # stands where a file is missing
LONGEST_NAME = 80  # characters of the name of an environment, a counter or a macro

# what is printed as it is typed, or not at all; then a comment with the spaces of the next line; then tokens
_TOKEN = re.compile(
    r"\\begin\s*\{(?P<env>(?:verbatim|Verbatim|lstlisting|minted|alltt|comment|filecontents|tikzpicture|pgfpicture)\*?)\}"
    r".*?(?:\\end\s*\{(?P=env)\}|\Z)"
    r"|\\(?:verb|lstinline)\*?(?P<mark>[^A-Za-z\s*{])[^\n]*?(?P=mark)"
    r"|(?P<comment>%[^\n]*(?:\n[ \t]*)?)|(?P<token>\\[A-Za-z@]+|\\.|\$\$|[^\S\n]*\n\s*|[^\S\n]+|.)",
    re.DOTALL,
)


class Tok(NamedTuple):
    """A token with the place from which it comes; `final` ones are no macros any more."""

    text: str
    line: int
    file: str = ""
    final: bool = False

    @property
    def is_space(self) -> bool:
        return not self.text.strip()


def tokens(text: str, file: str = "", line: int = 1) -> list[Tok]:
    """The tokens of TeX without comments and without what is printed verbatim."""
    found = []
    for match in _TOKEN.finditer(text):
        if token := match["token"]:
            found.append(Tok(token, line, file))
        elif match["comment"] and "\n\n" in text[match.end() - 1 : match.end() + 1]:
            found.append(Tok("\n", line, file))
        line += match[0].count("\n")
    return found


@lru_cache(4096)
def bare(text: str) -> str:
    """A text without what may be left out between its tokens."""
    return re.sub(r"[\s{}]", "", text)


def written(toks: Sequence[Tok]) -> str:
    """The tokens as LaTeX again, each run of spaces as one."""
    parts: list[str] = []
    for tok in toks:
        text = " " if tok.is_space else tok.text
        if text[:1].isalpha() and parts and parts[-1][:1] == "\\" and parts[-1][-1].isalpha():
            parts.append(" ")
        parts.append(text)
    return re.sub(r"\s+", " ", "".join(parts)).strip()


@dataclass(frozen=True)
class Macro:
    """What a command takes and what it stands for.

    `takes` has one entry for each argument: "m" in braces, "o" in square brackets with `default`, "g" in braces if
    there, "s" a star, "()" in round brackets if there; other texts must follow as they are, as \\def allows.
    """

    takes: tuple[str, ...]
    body: tuple[Tok, ...]
    default: tuple[Tok, ...] | None = None


@dataclass
class Expander:
    """Expands the macros of one document, its files included."""

    folder: Path | None = None
    macros: dict[str, Macro] = field(default_factory=dict)
    environments: dict[str, tuple[Macro, tuple[Tok, ...]]] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    made: int = 0

    def __post_init__(self) -> None:
        deque(self.run(tokens(USUAL)), maxlen=0)

    def run(self, toks: Sequence[Tok]) -> Iterator[Tok]:
        """What is left of the tokens."""
        stack = [*reversed(toks)]
        while stack:
            tok = stack.pop()
            text = tok.text
            if text.startswith(ENDS):
                continue
            if text[:1] != "\\" or tok.final:
                yield tok
            elif text in self.macros:
                self._expand(self.macros[text], tok, stack)
            elif text in _DEFINING:
                _DEFINING[text](self, tok, stack)
            elif text in (r"\begin", r"\end"):
                yield from self._environment(tok, stack)
            else:
                yield tok

    def _count(self, tok: Tok, many: int) -> None:
        self.made += many
        if self.made > MAX_MADE:
            raise SymcheckError(
                f"{_place(tok)}: macros expand to more than {MAX_MADE} tokens at {tok.text[:20]}; "
                "does one of them call itself?"
            )

    def _expand(self, macro: Macro, tok: Tok, stack: list[Tok]) -> None:
        arguments: list[Sequence[Tok]] = []
        if stack and stack[-1].is_space and stack[-1].text.count("\n") < 2 and tok.text[-1:].isalpha():
            stack.pop()  # as TeX does behind a command
        for kind in macro.takes:
            if kind == "m":
                arguments.append(argument(stack))
            elif kind == "o":
                given = optional(stack)
                arguments.append(macro.default or () if given is None else given)
            elif kind == "g":
                _skip_spaces(stack)
                arguments.append(argument(stack) if stack and stack[-1].text == "{" else ())
            elif kind == "s":
                arguments.append([stack.pop()] if stack and stack[-1].text == "*" else ())
            elif kind == "()":
                arguments.append(optional(stack, "()") or ())
            elif kind.startswith("#"):
                arguments.append(_until(stack, kind[1:]))
            else:
                _skip_text(stack, kind)
        made = _substituted(macro.body, arguments, tok)
        self._count(tok, len(made) + 1)
        stack.extend(reversed(made))

    def _environment(self, tok: Tok, stack: list[Tok]) -> Iterator[Tok]:
        name = name_here(stack)
        if name not in self.environments:
            yield Tok(f"{tok.text}{{{name}}}", tok.line, tok.file)
            return
        opening, closing = self.environments[name]
        if tok.text == r"\begin":
            self._expand(opening, tok, stack)
        else:
            self._expand(Macro((), closing), tok, stack)

    def define(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\newcommand{\name}[count][default]{body}."""
        _skip_text(stack, "*")
        name, takes, default = self._head(stack)
        body = tuple(argument(stack))
        if not (tok.text == r"\providecommand" and name in self.macros):
            self._keep(name, Macro(takes, body, default))

    def _head(self, stack: list[Tok]) -> tuple[str, tuple[str, ...], tuple[Tok, ...] | None]:
        name = "".join(t.text for t in argument(stack)).strip()
        count = "".join(t.text for t in optional(stack) or ()).strip()
        default = optional(stack)
        takes = ("m",) * (int(count) if count in "123456789" and count else 0)
        if default is not None:
            takes = ("o", *takes[1:])
        return name, takes, None if default is None else tuple(default)

    def define_plainly(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\def\name#1,#2;{body}."""
        _skip_spaces(stack)
        name = stack.pop().text if stack else ""
        takes: list[str] = []
        while stack and stack[-1].text not in ("{", "}"):
            text = stack.pop().text
            if text == "#" and stack:
                stack.pop()
                takes.append("m")
            elif takes and (takes[-1] == "m" or takes[-1].startswith("#")):
                takes[-1] = f"{'#' if takes[-1] == 'm' else takes[-1]}{text.strip() or ' '}"
            elif text.strip():
                takes.append(text)
        self._keep(name, Macro(tuple(takes), tuple(argument(stack))))

    def define_documented(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\NewDocumentCommand{\name}{s o m}{body}."""
        name = "".join(t.text for t in argument(stack)).strip()
        signature = [t for t in argument(stack) if not t.is_space]
        takes: list[str] = []
        default: tuple[Tok, ...] | None = None
        while signature:
            kind = signature.pop(0).text
            if kind in "OD" and signature and signature[0].text == "{":
                rest = [*reversed(signature)]
                default = tuple(argument(rest))
                signature = [*reversed(rest)]
            if kind in "mogsOD":
                takes.append({"O": "o", "D": "o"}.get(kind, kind))
        self._keep(name, Macro(tuple(takes), tuple(argument(stack)), default))

    def define_operator(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\DeclareMathOperator{\name}{text}."""
        star = "*" if _skip_text(stack, "*") else ""
        name = "".join(t.text for t in argument(stack)).strip()
        body = [Tok(rf"\operatorname{star}", tok.line, tok.file, True), *_braced(argument(stack), tok)]
        self._keep(name, Macro((), tuple(body)))

    def define_delimiters(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\DeclarePairedDelimiter{\name}{left}{right}."""
        name = "".join(t.text for t in argument(stack)).strip()
        left, right = argument(stack), argument(stack)
        inside = [Tok("#", tok.line, tok.file), Tok("3", tok.line, tok.file)]
        both = (Tok(r"\left", tok.line, tok.file), *left, *inside, Tok(r"\right", tok.line, tok.file), *right)
        self._keep(name, Macro(("s", "o", "m"), both))

    def define_environment(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\newenvironment{name}[count][default]{begin}{end}."""
        _skip_text(stack, "*")
        name, takes, default = self._head(stack)
        self.environments[name] = Macro(takes, tuple(argument(stack)), default), tuple(argument(stack))

    def let(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\let\name=\other."""
        _skip_spaces(stack)
        name = stack.pop().text if stack else ""
        _skip_text(stack, "=")
        _skip_spaces(stack)
        other = stack.pop() if stack else tok
        self._keep(name, self.macros.get(other.text, Macro((), (other._replace(final=True),))))

    def _keep(self, name: str, macro: Macro) -> None:
        if name[:1] == "\\":
            self.macros[name] = macro

    def packages(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\usepackage[options]{name, name}."""
        optional(stack)
        for name in "".join(t.text for t in argument(stack)).split(","):
            known = tokens(PACKAGES.get(name.strip(), ""), tok.file, tok.line)
            stack.extend(t._replace(line=tok.line) for t in reversed(known))

    def skip_false(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\iffalse ... \fi."""
        depth = 1
        while stack and depth:
            text = stack.pop().text
            depth += text.startswith(r"\if") and text != r"\iff"
            depth -= text == r"\fi"

    def include(self, tok: Tok, stack: list[Tok]) -> None:
        r"""\input{file}, \include{file}, \subfile{file}, or \input file."""
        _skip_spaces(stack)
        if stack and stack[-1].text != "{":
            word = []
            while stack and not stack[-1].is_space:
                word.append(stack.pop().text)
            name = "".join(word)
        else:
            name = written(argument(stack))
        if self.folder is None or not name or len(name) > LONGEST_NAME or "\\" in name or "#" in name:
            return
        found = [f for f in (self.folder / f"{name}.tex", self.folder / name) if f.is_file()]
        if not found:
            self.notes.append(f"{_place(tok)}: {tok.text}{{{name}}}: there is no such file")
            stack.append(Tok(MISSING, tok.line, tok.file, True))
            return
        self._open(found[0], tok, stack)

    def _open(self, file: Path, tok: Tok, stack: list[Tok]) -> None:
        from symcheck.document.files import text_of

        inner = str(file.relative_to(self.folder)) if self.folder and file.is_relative_to(self.folder) else str(file)
        opened = [t.text for t in stack if t.final and t.text.startswith(ENDS)]
        if ENDS + inner in opened or len(opened) >= MAX_FILES:
            raise SymcheckError(f"{_place(tok)}: {inner} includes itself; remove one of the \\input")
        stack.append(Tok(ENDS + inner, tok.line, tok.file, True))
        stack.extend(reversed(tokens(text_of(file), inner)))


_DEFINING: dict[str, Callable[[Expander, Tok, list[Tok]], None]] = {
    **dict.fromkeys(
        (r"\newcommand", r"\renewcommand", r"\providecommand", r"\DeclareRobustCommand", r"\newrobustcmd"),
        Expander.define,
    ),
    **dict.fromkeys((r"\def", r"\gdef", r"\edef", r"\xdef"), Expander.define_plainly),
    **dict.fromkeys(
        (
            r"\NewDocumentCommand",
            r"\RenewDocumentCommand",
            r"\ProvideDocumentCommand",
            r"\DeclareDocumentCommand",
        ),
        Expander.define_documented,
    ),
    r"\DeclareMathOperator": Expander.define_operator,
    r"\DeclarePairedDelimiter": Expander.define_delimiters,
    **dict.fromkeys((r"\newenvironment", r"\renewenvironment"), Expander.define_environment),
    **dict.fromkeys((r"\let", r"\glet"), Expander.let),
    **dict.fromkeys((r"\usepackage", r"\RequirePackage"), Expander.packages),
    **dict.fromkeys((r"\input", r"\include", r"\subfile"), Expander.include),
    r"\iffalse": Expander.skip_false,
}


def argument(stack: list[Tok]) -> list[Tok]:
    """The next argument: the inside of braces, or one token."""
    _skip_spaces(stack)
    if not stack or stack[-1].text == "}":
        return []
    first = stack.pop()
    if first.text != "{":
        return [first]
    found: list[Tok] = []
    depth = 1
    while stack:
        tok = stack.pop()
        depth += (tok.text == "{") - (tok.text == "}")
        if not depth:
            break
        found.append(tok)
    return found


def optional(stack: list[Tok], pair: str = "[]") -> list[Tok] | None:
    """The inside of the square brackets that follow; None without them."""
    after = next((k for k in range(len(stack) - 1, -1, -1) if not stack[k].is_space), -1)
    if after < 0 or stack[after].text != pair[0]:
        return None
    del stack[after:]
    found: list[Tok] = []
    braces = brackets = 0
    while stack:
        tok = stack.pop()
        if tok.text == pair[1] and not braces and not brackets:
            break
        braces += (tok.text == "{") - (tok.text == "}")
        if not braces:
            brackets += (tok.text == pair[0]) - (tok.text == pair[1])
        found.append(tok)
    return found


def name_here(stack: list[Tok]) -> str:
    """The name in the braces that follow."""
    return "".join(tok.text for tok in argument(stack)).strip()[:LONGEST_NAME]


def _skip_spaces(stack: list[Tok]) -> None:
    while stack and stack[-1].is_space:
        stack.pop()


def _skip_text(stack: list[Tok], text: str) -> bool:
    """Drop this text if it follows."""
    if stack and stack[-1].text == text:
        stack.pop()
        return True
    return False


def _until(stack: list[Tok], text: str) -> list[Tok]:
    """What stands before a text, which goes with it."""
    found: list[Tok] = []
    while stack:
        found.append(stack.pop())
        ending = "".join(" " if t.is_space else t.text for t in found[-len(text) :])
        if ending.endswith(text):
            while text and found:
                text = text[: -len(found.pop().text)]
            break
    return found


def _braced(toks: Sequence[Tok], at: Tok) -> list[Tok]:
    return [Tok("{", at.line, at.file), *toks, Tok("}", at.line, at.file)]


def _substituted(body: Sequence[Tok], arguments: Sequence[Sequence[Tok]], at: Tok) -> list[Tok]:
    """The body with its arguments, at the place where it is called."""
    found: list[Tok] = []
    k = 0
    while k < len(body):
        tok = body[k]
        if tok.text == "#" and k + 1 < len(body):
            number = body[k + 1].text
            if number.isdigit() and 0 < int(number) <= len(arguments):
                found += arguments[int(number) - 1]
            elif number == "#":
                found.append(tok._replace(line=at.line, file=at.file))
            k += 2
            continue
        found.append(tok._replace(line=at.line, file=at.file))
        k += 1
    return found


def _place(tok: Tok) -> str:
    return f"{tok.file or 'the document'}, line {tok.line}"
