"""Plain LaTeX in which what is written in several tokens, or in words, has its usual form."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import partial

from symcheck.reading.commands import ACCENTS, STYLES

_FRAME = r"\{ [^{}]*(?:\{[^{}]*\}[^{}]*)? \}"  # at the left of a d
_D = r"(?:d|\\mathrm \{ d \}|\\text \{ d \})"
_ROUND = r"\\left \( (?:(?!\\left|\\right).)* \\right \)"  # brackets without others
_ENVIRONMENT = r"\\begin (?:(?!\\begin|\\end).)*\\end \{ [^{}]* \}"  # without others in it
_GAPS = r"(?:(?:\\[,;: ]|\\quad|~|&) )*"
_QUADS = r"(?:(?:\\q?quad|\\[,;: ]|,|~)\s*)*"
_STOP = re.compile(r"\\text \{ (?:[.,;:~] )+\}")  # punctuation in text
_BRACED = r"\{(?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})*\}"  # an argument, with others in it
_LETTER = r"(?:\\(?:" + "|".join(sorted(each[1:] for each in STYLES | ACCENTS)) + rf") {_BRACED}|[A-Z])"
_FUNCTION_LETTER = rf"(?:\\[a-z]+ {_BRACED}|\\?[A-Za-z]+)(?: _ (?:\w|{_BRACED}))?"
_CELL = rf"(?:\\d?frac {_BRACED} {_BRACED}|(?:\\[a-z]+ {_BRACED}|\\?[A-Za-z]+)(?: [_^] (?:\w|{_BRACED})| ')*)"
# spaces between formulas
_WIDTHS = re.compile(r"(?:\\[,;:] |\\q?quad )+")
_BARS = r"\|(?: & \|)+"
_SIGN = r"(?:[=<>]|\\(?:in|le|ge|leq|geq|ne|neq)(?![a-z]))"
_OF_EVENT = rf"((?:(?!\\[{{}}]|\\left|\\right)[^()\[\]])*{_SIGN}(?:(?!\\[{{}}]|\\left|\\right)[^\[\]])*?)"  # a relation
_EVENT = rf"(?:\\left |\\[bB]igg?l? )?(?:\(|\[|\\\{{) {_OF_EVENT} (?:\\right |\\[bB]igg?r? )?(?:\)|\]|\\\}})"
_SPELLINGS: Sequence[
    tuple[str, re.Pattern[str], str | Callable[[re.Match[str]], str]]
] = (  # of one thing in several tokens, behind what always stands in it, with the usual one
    (r"\operatorname { \text", re.compile(r"\\operatorname \{ \\text (\{ [^{}]* \}) \}"), r"\\operatorname \1"),
    (". ", re.compile(r"(?<![\d.] )\. (?:\\[,;] )?\. (?:\\[,;] )?\.(?= |$)"), r"\\dots"),  # three full stops
    # signs that are typed as two, or as another one
    (r"\left < ", re.compile(r"\\left < "), r"\\left \\langle "),
    (r"\right >", re.compile(r"\\right >"), r"\\right \\rangle"),
    ("< = ", re.compile(r"< = "), r"\\le "),
    ("> = ", re.compile(r"> = "), r"\\ge "),
    (r"\text { .", re.compile(r"(?:\\text \{ (?:\. )+\} ?){3}|\\text \{ \. \. \. \} ?"), r"\\dots "),
    # the operator of fields in bold, or with an arrow
    (r"\nabla", re.compile(r"\\(?:mathbf|boldsymbol|bm|pmb|vec|overrightarrow) \{ \\nabla \}"), r"\\nabla"),
    # the power of what has a star
    (r"^ { ", re.compile(r"\^ \{ (\*|\\star) (\d) \}"), r"^ { \1 } ^ { \2 }"),
    # narrow spaces in subscripts
    (r"_ { ", re.compile(r"_ \{ [^{}]*\\[,!] [^{}]*\}"), lambda found: re.sub(r"\\[,!] ", "", found[0])),
    ('"', re.compile('"'), "' '"),
    # a derivative before the place at which it is taken, which is where its letter is a function
    (
        "} (",
        re.compile(
            rf"(\\d?frac \{{ ({_D}|\\partial)(?: \^ (?:\d|\{{ \d \}}))? {_FUNCTION_LETTER}) \}} "
            r"(\{ (?:\2 (?:\w|\\[a-z]+) (?:\^ (?:\d|\{ \d \}) )?)+\}) "
            r"(\( (?:\w|\\[a-z]+)(?: , (?:\w|\\[a-z]+))* \))"
        ),
        lambda found: _with_place(found),
    ),
    # indices of which each has a place of its own
    (
        "{ } ",
        re.compile(r"\^ (\w|\{ [^{}]* \}) \{ \} _ (\w|\{ [^{}]* \})(?! \{ \})"),
        r"_ \2 ^ \1",
    ),
    # the number of a formula, and the stop before it, in an environment
    (r"\tag ", re.compile(r"(?:(?<!\\right )[.,;] )?\\tag \{[^{}]*\} (?=\\end)"), ""),
    # what is left of 1 as an exponent, in brackets
    ("^ { ( 1 - ", re.compile(r"\^ \{ \( 1 - (\\?[A-Za-z]+) \) \}"), r"^ { 1 - \1 }"),
    # a one in another type before a relation, which tells whether that holds
    (
        " { 1 } ",
        re.compile(rf"\\math(?:bb|bf|bbm|ds) \{{ 1 \}} {_EVENT}"),
        r"\\text { i n d i c a t o r } \\left ( \1 \\right )",
    ),
    # the probability of a relation in square brackets
    (r"\mathbb { P }", re.compile(rf"(\\mathbb \{{ P \}} ){_EVENT}"), r"\1\\left ( \2 \\right )"),
    # what stands below the sign of an expectation
    (
        r"\underset ",
        re.compile(rf"\\underset ({_BRACED}) \{{ (\\mathbb \{{ E \}}|\\mathbb E) \}}"),
        r"\\mathbb { E } _ \1",
    ),
    # the usual names of sets of numbers
    (r"\in ", re.compile(r"(?<=\\in )\\([RNZQC])(?![A-Za-z])"), r"\\mathbb { \1 }"),
    # more space between two lines
    (r"\\ [", re.compile(r"\\\\ \[ (?:- )?[\d. ]+(?:p t|e m|e x|c m|m m|i n) \]"), r"\\\\"),
    # signs and numbers in upright type
    (r"\mathrm { ", re.compile(r"(?<![_^] )\\mathrm \{ ([-+=/] [-+=/ ]*|[\d. ]+)\}"), r"\1"),
    # spaces between a function that is defined and its arguments
    (
        "~ ",
        re.compile(r"^((?:& )?\\?[A-Za-z]+(?: _ (?:\w|\{ [^{}]* \}))? )(?:~ )+(?=\( [^()]* \) (?:~ |& )*= )"),
        r"\1",
    ),
    # a row whose three entries or more are parted by spaces alone
    (
        "[ ",
        re.compile(
            rf"(?<== )(?:\\left |\\[bB]igg?l? )?\[ {_CELL}(?: {_WIDTHS.pattern}{_CELL}){{2,}}"
            r" (?:\\right |\\[bB]igg?r? )?\]"
        ),
        lambda found: _WIDTHS.sub(", ", found[0]),
    ),
    # a narrow space before a script, and between a letter and its arguments
    (r"\! ", re.compile(r"(?:\\! )+(?=[_^(]|\\left \(|\\[bB]igg?l? \()"), ""),
    # the letter of a sum or an integral above its sign, or below the sign of an integral over it
    (
        "} ^ { ",
        re.compile(rf"(\\(?:sum|prod) _ \{{ (\w) = (?:[^{{}}]|{_BRACED})*\}} \^ \{{ )\2 = (?={_BRACED[2:]})"),
        r"\1",
    ),
    (
        r"\int _ { ",
        re.compile(rf"(\\int _ \{{ )(\w) = (?={_BRACED[2:]}.* {_D} (?:\\[,;] )?\2(?!\w))"),
        r"\1",
    ),
    (
        r"\int _ ",
        re.compile(rf"(\\int _ (?:\w|{_BRACED}) \^ \{{ )(\w) = (?={_BRACED[2:]}.* {_D} (?:\\[,;] )?\2(?!\w))"),
        r"\1",
    ),
    # a set for whose points a relation holds, as a remark
    (
        r"\text { ",
        re.compile(
            rf"\\text \{{ (?:~ )*(o n|i n) (?:~ )*\}} {_GAPS}"
            r"((?:\\partial )?\\?[A-Za-z]+(?: _ (?:\w|\{ [^{}]* \}))?)"
            r"(?=(?: [.,;])?(?: $| \\\\| \\q?quad| \\end|$))"
        ),
        r"\\text { \1 ~ \2 }",
    ),
    # values by cases in an array
    (
        r"\left \{ ",
        re.compile(
            rf"(?<=[-+=] )(&? ?(?:(?:\\[,;: ]|~) )*)\\left \\\{{ \\begin \{{ a r r a y \}} \{{ [^{{}}]* \}} "
            rf"((?:(?!\\begin|\\end|\\left \\\{{).|{_ENVIRONMENT})*)\\end \{{ a r r a y \}} \\right \."
        ),
        lambda found: _with_cases(found),
    ),
    # a system of equations in an array with a brace
    (
        r"\left \{ \begin",
        re.compile(r"^\\left \\\{ (\\begin \{ a r r a y \} (?:(?!\\left|\\begin).)*\\end \{ a r r a y \}) \\right \."),
        r"\1",
    ),
    # several spaces that are as wide as a quad
    *(
        (" ".join([each] * 3), re.compile(rf"(?:{re.escape(each)} ){{3,}}"), r"\\quad ")
        for each in (r"\,", r"\;", r"\:", "\\ ", "~")
    ),
    # commas at the ends of the cells of a matrix
    (
        "m a t r i x",
        re.compile(r"(\\begin \{ [bBpvV ]*m a t r i x \}(?:(?!\\begin|\\end).)*)(?=\\end)"),
        lambda found: found[1].replace(" , &", " &"),
    ),
    # the skew matrix of a vector, with the sign of the product within the brackets
    (
        r"\times ",
        re.compile(rf"(?:\\left )?\[ (\\?[a-zA-Z]+(?: {_BRACED})?(?: _ (?:\w|{_BRACED}))?) \\times (?:\\right )?\]"),
        r"[ \1 ] _ { \\times }",
    ),
    (
        r"\times ",
        re.compile(rf"\[ (\\?[a-zA-Z]+(?: {_BRACED})?) _ (?:\{{ )?\\times (?:\}} )?\]"),
        r"[ \1 ] _ { \\times }",
    ),
    (
        r"\lfloor ",
        re.compile(
            rf"\\lfloor (\\?[a-zA-Z]+(?: {_BRACED})?(?: _ (?:\w|{_BRACED}))?) \\rfloor _ (?:\{{ )?\\times(?: \}})?"
        ),
        r"[ \1 ] _ { \\times }",
    ),
    # the logarithm of a determinant, and the determinant of an inverse or a transpose, which is the same as its power
    (
        r"\det ",
        re.compile(rf"(?:(?<=\\ln )|(?<=\\log ))\\det ({_LETTER}|[A-Z])(?! [\^_(])"),
        r"( \\det ( \1 ) )",
    ),
    (r"\det ", re.compile(rf"\\det ((?:{_LETTER}|[A-Z]) \^ (?:\{{ - 1 \}}|T|\{{ T \}}|\\top))"), r"\\det ( \1 )"),
    # a matrix in brackets, and one of zeros
    (r"\left [", re.compile(rf"\\left \[ ((?:{_LETTER}|[A-Z] [A-Z])(?: _ (?:\w|{_BRACED}))?) \\right \]"), r"[ \1 ]"),
    ("[ 0 ]", re.compile(r"\[ 0 \] (?=_ \{ [^{}]*\\times)"), "0 "),
    ("°", re.compile(r"(?<=[\d}]) °"), r" ^ { \\circ }"),
    (r"\degree", re.compile(r"(?<=[\d}]) (?:\^ )?(?:\\degree|\{ \\degree \})"), r" ^ { \\circ }"),
    # a matrix of columns, which are printed between bars
    (
        "| & |",
        re.compile(rf"(?<=x \}} ){_BARS} \\\\ ((?:(?!\\begin|\\end|\\\\).)+) \\\\ {_BARS} (?:\\\\ )?(?=\\end)"),
        r"\1 ",
    ),
    ("v m a t r i x", re.compile(r"\\begin \{ v m a t r i x \}"), r"\\left | \\begin { m a t r i x }"),
    ("v m a t r i x", re.compile(r"\\end \{ v m a t r i x \}"), r"\\end { m a t r i x } \\right |"),
    # a binomial coefficient printed as a column, whose lower number is an exponent too
    (
        "p m a t r i x",
        re.compile(
            r"\\begin \{ p m a t r i x \} (\w) \\\\ (\w) (?:\\\\ )?\\end \{ p m a t r i x \}"
            r"(?=.* \^ (?:\2(?!\w)|\{ \2 \}))"
        ),
        r"\\binom { \1 } { \2 }",
    ),
    # sums and products whose sign is typed as a letter
    (r"\Sigma _ {", re.compile(r"\\Sigma (?=_ \{ [a-zA-Z] = )"), r"\\sum "),
    (r"\Pi _ {", re.compile(r"\\Pi (?=_ \{ [a-zA-Z] = )"), r"\\prod "),
    # a value and its range behind it
    (" 0 ", re.compile(r"(?<=\) )(?=0 (?:\\le|\\leq|<) )"), r", \\quad "),
    ("] ", re.compile(r"(?<=\] )(?=\d+(?:\.\d+)? (?:\\le|\\leq|<) )"), r", \\quad "),
    # a fraction at a place, with a bar on one side
    (
        "| _ {",
        re.compile(rf"(^|[-=+&] |\\[;,] )(\\frac {_BRACED} {_BRACED}) \\[bB]igg?[lr]? \| (?=_ \{{)"),
        r"\1\\left . \2 \\right | ",
    ),
    # a derivative in a frame as an operator on one letter
    (
        r"\frac { \prescript",
        re.compile(
            rf"\\frac \{{ \\prescript ({_FRAME}) \{{ \}} \{{ ({_D}) \}} \}} (\{{ {_D} [^{{}}]* \}}) "
            rf"((?:\\prescript {_BRACED} {_BRACED} {_BRACED}|\\[a-z]+ {_BRACED})(?: [_^] {_BRACED})*|{_ROUND})"
            r"(?= [-+=,&]|$| \\\\| \\cdot)"
        ),
        r"\\left ( \\frac { \2 } \3 ( \4 ) \\right ) _ \1",
    ),
    # the matrix between two frames as a function of their attitude, a bold letter: `[BN(\bm{\sigma})]`, `[B(\bm{x})]`
    *(
        (
            ") ]",
            re.compile(
                rf"{before}\[ ((?:[A-Z] (?:_ (?:\w|\{{ [^{{}}]* \}}) )?){count})(?:\\left )?"
                r"(\( -? ?\\(?:bm|boldsymbol|mathbf|pmb) [^()\[\]]*\)) \]"
            ),
            r"[ \1] \2",
        )
        for before, count in (("", "{2}"), (r"(?:^|(?<=[-+=(] )|(?<=\d \} ))", ""))
    ),
    # a derivative in a frame, which is written below brackets too; `{ d }` or `{ \partial }` with the frame at its left
    (
        r"\frac { \prescript",
        re.compile(
            r"\\frac \{ \\prescript (\{ (?:[A-Z]|\\\w+ \{ [A-Z] \}) \}) \{ \} \{ (d|\\mathrm \{ d \}) \} "
            r"((?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})+) \} (\{ (?:d|\\mathrm \{ d \}) [^{}]* \})"
        ),
        r"\\left ( \\frac { d ( \3 ) } \4 \\right ) _ \1",
    ),
    (
        r"\frac { { } ^",
        re.compile(
            r"\\frac \{ \{ \} \^ (\{ (?:[A-Z]|\\\w+ \{ [A-Z] \}) \}) \\partial "
            r"((?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})+) \} (\{ \\partial (?:[^{}]|\{[^{}]*\})* \})"
        ),
        r"\\left ( \\frac { \\partial ( \2 ) } \3 \\right ) _ \1",
    ),
)
WIDE = r", \quad"
WORDS = tuple(  # that part relations: what stands behind them holds as well, or says when the others hold
    (re.compile(rf"(?:{_QUADS} )?\\(?:text|mathrm) {{ [\s,~]*(?i:{words})[\s,:~]* }}(?: {_QUADS})?"), sign)
    for words, sign in (
        ("w h e r e|w i t h", WIDE),
        ("a n d", r"\text{and}"),
        ("o r", r"\lor"),
        (
            "(?:f o r|i f|w h e n|w h e n e v e r|a s ~ l o n g ~ a s|p r o v i d e d|p r o v i d e d ~ t h a t)",
            r"\text{for}",
        ),
        ("f o r ~ a l l|f o r ~ e v e r y|f o r ~ a n y", r"\forall"),
    )
)
# words before the place at which relations hold, which an equation tells; below a letter they are labels
_PLACE = re.compile(
    rf"(?<![_^] )(?:{_QUADS} )?\\text {{ [\s,~]*(?:o n|a t)[\s,:~]* }}(?: {_QUADS})?"
    rf"(?=[^{{}},;]*(?:{_BRACED}[^{{}},;]*)*= )"
)
_TRANSPOSED = re.compile(r"\^ \{ \\math(?:sf|tt|scr|cal) \{ T \} \}")  # T above in any style
_BOLD_T = r"\mathbf { T }"
_DEFINES = re.compile(r"(?<!:) : =(?! =)|= :(?!\s*[=:])")  # `:=`, and the same from right to left


def phrased(text: str) -> str:
    """The same text with usual spellings, signs between relations for words, and problems with what is to be found."""
    text = _TRANSPOSED.sub("^ { T }", _DEFINES.sub("=", text))
    if _BOLD_T in text and text.count(_BOLD_T) == text.count(above := f"^ {{ {_BOLD_T} }}"):
        text = text.replace(above, "^ { T }")
    for inside, layout, change in _SPELLINGS:
        if inside in text:
            text = layout.sub(change, text)
    text = _STOP.sub(lambda found: next((sign for sign in found[0] if sign in ",;"), ""), text)
    for pattern, sign in WORDS if r"\text {" in text or r"\mathrm {" in text else ():
        text = pattern.sub(partial(_parting, sign), text)
    if r"\text {" in text:
        text = _PLACE.sub(r" \\text{for} ", text)
    if _SPACE in text:
        text = _SPACED.sub(lambda found: f"{found[1]} {_APART.sub(f'{_PARTING[found[1][-1]]} ', found[2])}", text)
    if ":" in text:
        text = _HEADING.sub("", text)
    return _AT_FIRST.sub("", _problem(_MATRIX.sub(_with_cells, text) if "m a t r i x" in text else text))


# a letter or word that heads an equation, as the number of one does: `\mathbf{e}_r: \quad a = b`
_HEADING = re.compile(
    rf"^(?:& )*(?:(?:\\[a-z]+ {_BRACED}|\\?[A-Za-z]+)(?: _ (?:\w|{_BRACED}))? :|\\text {_BRACED[:-2]}: \}})"
    r" (?:& )*\\q?quad (?!.*\\(?:to|rightarrow|mapsto|in) )(?=.*= )"
)
_AT_FIRST = re.compile(r"^ *, \\quad (?=.*\S)")  # what parted relations where none stands before it


def _with_cases(found: re.Match[str]) -> str:
    """An array behind a brace as cases: values, and where each is taken, which may fill several cells."""
    inner = re.findall(_ENVIRONMENT, found[2])  # matrices, whose cells are their own
    rows = [row.split("& ") for row in re.sub(_ENVIRONMENT, "\0", found[2]).split("\\\\ ") if row.strip()]
    if not any(len(row) > 1 for row in rows):
        return found[0]
    body = "\\\\ ".join("& ".join([row[0], "".join(row[1:])]) if len(row) > 1 else row[0] for row in rows)
    for each in inner:
        body = body.replace("\0", each, 1)
    return rf"{found[1]}\begin {{ c a s e s }} {body}\end {{ c a s e s }}"


# a matrix without cells, but with commas
_MATRIX = re.compile(
    r"(\\begin \{ [bBpvV \n]*m a t r i x \})((?:(?!\\begin|\\end|&).)*,(?:(?!\\begin|\\end|&).)*)(?=\\end)"
)
_SPACE, _PARTING = "\\ ", {"}": "&", "[": ","}
_APART = re.compile(r"(?:\\  )+")  # one space or several between two entries
_ENTRY = r"(?:\\[A-Za-z]+(?: \{ [^{}]* \})?|[A-Za-z0-9.]+)(?: _ (?:\w|\{ [^{}]* \}))?"
_ENTRIES = rf"{_ENTRY}(?: {_ENTRY})*"
_PARTED = rf"{_ENTRIES} (?:(?:\\  )+{_ENTRIES} )+"
_SPACED = re.compile(
    rf"(\\begin \{{ [bBpvV ]*m a t r i x \}}|(?:\\left )?\[) ({_PARTED})(?=\\end|(?:\\right )?\])"
)  # parted by spaces


def _with_place(found: re.Match[str]) -> str:
    """A derivative whose letter stands before its place, if the derivative is by letters of that place alone."""
    top, sign, bottom, place = found.groups()
    by = re.sub(r"\^ (?:\d|\{ \d \})", "", f" {bottom[2:-2]} ").replace(f" {sign} ", " ").split()
    return rf"{top} {place} }} {bottom}" if {*by} <= {*place.split()} else found[0]


def _with_cells(found: re.Match[str]) -> str:
    """A matrix whose rows are lists with commas, with cells."""
    cells, depth = list[str](), 0
    for text in found[2].split(" "):
        depth += (text in ("{", "(", "[")) - (text in ("}", ")", "]"))
        cells.append("&" if text == "," and not depth else text)
    return found[1] + " ".join(cells)


# what introduces the conditions of a problem
_SUBJECT = re.compile(
    r"(?:(?:\\q?quad|\\[,;: ]|,|&|\\\\) )*\\text \{ "
    r"(?:~ )?(?:s u b j e c t ~ t o|s u c h ~ t h a t|s \. (?:~ )?t \.)(?: [~:])* \}"
    r"(?: (?:\\q?quad|\\[,;: ]|&))*"
)
# signs of a relation, or of words and lines beside what is to be found
_RELATED = re.compile(
    r"(?<!\\)[=<>] |\\(?:le|ge|leq|geq|approx|in|equiv|ne|to|rightarrow|sim|simeq|ll|gg|preceq|succeq|propto) |"
    r"\\(?:quad|text|left) "
)
# what is to be found: the operator, what is below it, and of what
_OBJECTIVE = re.compile(
    r"((?:(?:&|\\begin \{ [a-z ]* \}) )*)(?:\\operatorname \{ )?\\?(m ?i ?n|m ?a ?x|f ?i ?n ?d)(?: i m i z e)?(?: \})? "
    r"(_ \{ (?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})* \} )?((?:(?:\\q?quad|\\[,;: ]|&) ?)*)(.*)"
)


def _problem(text: str) -> str:
    r"""What is to be found under conditions, `\min_x f(x) \quad \text{subject to} \quad g(x) = 0`, with words."""
    first = _SUBJECT.search(text) if r"\text {" in text else None
    alone = _OBJECTIVE.fullmatch(text) if first is None else None
    if (
        alone is not None and alone[2] != "f i n d" and not _RELATED.search(alone[5])
    ):  # what it is of reaches to the end
        return rf"{alone[1]}\{alone[2].replace(' ', '')} {alone[3] or ''}\left ( {alone[5].rstrip(' .,;')} \right )"
    if first is None:
        return text
    head, rest = text[: first.start()].rstrip() + " ", _SUBJECT.sub(lambda _: f" {WIDE} ", text[first.end() :])
    aim = _OBJECTIVE.fullmatch(head)
    if aim is not None:
        before, what, below, _, of = aim.groups()
        what, below, of = what.replace(" ", ""), below or "", of.strip().rstrip(",")
        if what == "find":
            head = rf"{before}\text {{ f i n d }} {below}{', ' if of else ''}{of}"
        elif of:
            head = rf"{before}\{what} {below}\left ( {of} \right )"
    return rf"{head} {WIDE} \text {{ s u b j e c t ~ t o }} {WIDE} {rest}"


def _parting(sign: str, found: re.Match[str]) -> str:
    """The sign that a word between relations is; `and` with a comma or a wide space ends what is before it.

    A wide `or` may say the same in other words, and is printed as words.
    """
    printed = found[0]
    wide = "," in printed or "quad" in printed
    if wide and sign == r"\lor":
        return rf" {WIDE} \text {{ ~ o r ~ }} {WIDE} "
    return rf" {WIDE} " if wide and sign == r"\text{and}" else f" {sign} "
