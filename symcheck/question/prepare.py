"""From the strings of a question to problems for the provers: definitions and conditions told apart."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from math import lcm

from symcheck.checker.algebra import Algebra
from symcheck.checker.residues import Reject
from symcheck.core.calculus import Lambda, Unknown, derivative, domain, functions, letters, nodes, substituted
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Problem
from symcheck.core.terms import Binder, End, Formula, Node, Relation, T, Term, Value, mapped, node
from symcheck.core.terms import Call as Applied
from symcheck.core.verdicts import Doubt, NoForm, SymcheckError, Unsaid
from symcheck.core.words import term
from symcheck.proof.algebra.polynomial import Unsupported, constant
from symcheck.question.cases import CASE, implied, may_all_hold
from symcheck.question.logarithms import with_natural_logarithms
from symcheck.question.places import INDICES, is_at_one_place, is_one_place, runs
from symcheck.question.running import refuse_tied, refuse_tied_bodies, written_in_functions, written_under
from symcheck.reading import Notation, Tree, algebraic, read, tex, to_latex
from symcheck.reading.complex_letters import with_products_under_lines
from symcheck.reading.differentials import Uneven, differential, slope, total
from symcheck.reading.evidence import canonical, spelling, spellings
from symcheck.reading.inference import SIZES, Inference, inferred
from symcheck.reading.lexer import SPACES
from symcheck.reading.lowering import JUMPS
from symcheck.reading.names import is_letter, names_of_several_tokens
from symcheck.reading.occurrences import occurrences, words
from symcheck.reading.parser import dependence
from symcheck.reading.placed import with_places
from symcheck.reading.surface import plain, with_plain_differentials
from symcheck.reading.tree import BigSum, Call, Chain, Forall, Limiting, Name, System, walk

_MEMBER = re.compile(r"^(.+?)\s*\\in(?![a-zA-Z])\s*(.+)$", re.DOTALL)  # "a, b \in \mathbb{R}"
# the set of complex numbers
_COMPLEX = re.compile(r"\s*\\mathbb\s*\{?C\}?\s*$")
# a density with parameters behind a bar or semicolon
_PARAMETERS = re.compile(r"([A-Za-z](?:_(?:\w|\{[^{}]*\}))?)\(([^()|;=]*)(\||\\mid |;)([^()|;=]*)\)=")
# the mean of a number, which an equation may define
_MEAN = re.compile(r"\\langle(?![^|,]*\\(?:[lr]angle|math|vec|bm|boldsymbol)[^|,]*\\rangle$)[^|,]*\\rangle")
# the sign of a relation
_RELATION = re.compile(r"[<>=]|\\(?:le|ge|lt|gt|ne|leq|geq|neq|leqslant|geqslant)(?![a-zA-Z])")
_SETS = {"R": "", "Z": "integer", "N": "integer", "Q": "", "C": "complex"}
# a set of numbers, the part of it above zero, and its dimension: "\mathbb{R}_{>0}^{n}"
_SET = re.compile(
    r"^\\mathbb\s*\{?([RZNQC])\}?\s*(?:_\{?\s*(>\s*0|\\geq?\s*0|\+|0)\s*\}?)?\s*(?:\^\s*\{?([^{}]*)\}?)?$"
)
Definitions = Mapping[str, tuple[str, tuple[str, ...], str]]  # left side, arguments and right side, by the letter
# a vector or a matrix of some size, of which nothing else is said
SIZE_SAID = re.compile(r"\\in\s*\\mathbb\s*\{?[RC]\}?\s*\^")
# letters for the size of a vector or matrix: "\mathbb{R}^{m \times n}"
_SIZE_OF = re.compile(r"\\mathbb\s*\{?R\}?\s*\^\s*\{?\s*([A-Za-z])\s*(?:\\times\s*([A-Za-z]))?")
# what may say for which letters a relation holds
_SCOPED = re.compile(r"\\forall(?![a-zA-Z])|\\in(?![a-zA-Z])|\\text\s*\{\s*[Ff]or")
# that before a relation, up to a colon
_ALL_AT_FIRST = re.compile(r"^(\s*\\forall(?![a-zA-Z])[^:=]*?)\s*(?::(?!=)|\\colon(?![a-zA-Z]))")
# one letter for two: "x_{1,2}", "\lambda_\pm"
PAIR = re.compile(
    r"(?P<stem>\\[A-Za-z]+|[A-Za-z])_(?:\{(?P<first>\w)\s*[,;/]?\s*(?P<second>\w)\}|\{?(?P<both>\\pm)(?![A-Za-z])\s*\}?)"
)
# a double sign that is no label
_SIGNS = re.compile(r"(?<!_)(?<!_\{)\\(pm|mp)(?![A-Za-z])\s*")
# what the prime of a function of several letters is: f'(x, a) = \partial f/\partial x
_PRIME_SAID = re.compile(
    r"^(?P<of>\\?[A-Za-z]+)'\((?P<at>[^()]*)\)="
    r"(?P<slope>\\frac\{\\partial ?(?P=of)(?:\((?P=at)\))?\}\{\\partial ?(?P<by>\\?[A-Za-z]+)\})$"
)
# an entry of a matrix or vector at any place
_ENTRY = re.compile(r"^(?P<of>\\[A-Za-z]+\{[A-Za-z]\}|[A-Za-z])_\{?(?P<row>[a-z])(?P<column>[a-z])?\}?$")
# a subscript of single letters
_BELOW = re.compile(r"_(?:\{[a-z]{1,3}\}|[a-z](?![A-Za-z]))")
# a letter in a face of vectors
_FACE = re.compile(r"\\(?:mathbf|boldsymbol|bm|vec|mathrm)\s*\{([A-Za-z])\}")
MOST_ENTRIES = 4  # rows and columns that are written out
OTHERS = ((4,), (1,))  # sizes of vectors and matrices where none of the usual ones makes sense
LONGEST = 20_000  # characters; the longest display of the corpora has a tenth of it
VARIABLES = ("x", "t")  # usual ones, for all of whose values identities hold
PRIMED = (*VARIABLES, r"\theta", r"\phi", r"\varphi", "s")  # by which a prime differentiates, if just one is there
DEFINED = "defined"  # the name of the condition that every printed term has a value


@dataclass(frozen=True)
class Asked:
    """What a user asks: everything is LaTeX."""

    relation: str
    where: tuple[str, ...] = ()
    given: tuple[str, ...] = ()
    letters: tuple[tuple[str, str], ...] = ()

    def __post_init__(self) -> None:
        for text in (self.relation, *self.where, *self.given):
            if len(text) > LONGEST:
                raise SymcheckError(f"{text[:40]}... has {len(text)} characters; more than {LONGEST} are no formula")
            if strange := [k for k, c in enumerate(text) if not c.isprintable() and not c.isspace()]:
                raise SymcheckError(
                    f"a control character stands at character {strange[0] + 1} of {text[:40]!r}; remove it"
                )


@dataclass(frozen=True)
class Reading:
    """One way to understand a question."""

    inference: Inference
    tree: Tree
    problems: tuple[Problem, ...]
    stated: Mapping[str, str]  # definitions and conditions as printed, by their names in the problems
    source: tuple[Asked, Inference, Definitions, Sequence[str], Sequence[str]]
    held: Mapping[str, set[str]] = field(default_factory=dict)  # constant in differentials, by hypothesis; "": always
    regular: tuple[Formula, ...] = ()  # what holds besides at counterexamples with differentials


@dataclass
class Understood(SymcheckError):
    """A question that is read whole, of which something has no form in the language of proofs."""

    inference: Inference
    tree: Tree
    reason: str

    def __str__(self) -> str:
        return self.reason


def plainly(asked: Asked) -> Asked:
    """The same without what is layout alone."""

    texts = (asked.relation, *asked.where, *asked.given)

    def made(text: str) -> str:
        return with_places(tex.compact(with_natural_logarithms(with_plain_differentials(plain(text, texts)))))

    given = tuple(text if _MEMBER.match(text) else made(text) for text in asked.given)
    said = tuple((made(letter), phrase) for letter, phrase in asked.letters)
    known = {letter for letter, phrase in said if "complex" in phrase}
    known |= {match[1].strip() for text in given if (match := _MEMBER.match(text)) and _COMPLEX.match(match[2])}
    plain_texts = with_parameters_as_arguments(tuple(map(made, (asked.relation, *asked.where))))
    relation, *where = with_products_under_lines(plain_texts, known)
    defined = (parts[0] for text in where if (parts := sides(text)) and _MEAN.fullmatch(parts[0]))
    said += tuple((mean, "scalar") for mean in defined if mean not in dict(said))
    return Asked(relation, tuple(where), given, said)


def with_parameters_as_arguments(texts: tuple[str, ...]) -> tuple[str, ...]:
    r"""The texts with a comma for the bar or semicolon in a density that one of them says: `p(x|\mu) = ...`.

    Densities of one name are told by what is in their brackets: others of that name leave it as it is.
    """
    for head in filter(None, map(_PARAMETERS.match, texts[1:])):
        name, own, sign, others = head.groups()
        inside = r"[^();|=]*;[^();|=]*" if sign == ";" else re.escape(own + sign + others)
        written = re.compile(rf"\\[A-Za-z]+|{re.escape(name)}\(({inside}\))?")
        found = [match for each in texts for match in written.finditer(each) if match[0][0] != "\\"]
        if all(match[1] for match in found):
            texts = tuple(written.sub(lambda match: match[0].replace(sign, ","), each) for each in texts)  # noqa: B023
    return texts


def with_each_sign(asked: Asked) -> Asked:
    r"""The question with two equations for each of two letters with two signs, if these stand in the relation."""
    return replace(asked, where=tuple(x for text in asked.where for x in _with_each_sign(text, asked.relation)))


def _with_each_sign(equation: str, relation: str) -> tuple[str, ...]:
    r"""An equation of two letters, as `x_{1,2} = a \pm b` of x_1 and x_2, as one of each, if the relation has these."""
    pair = PAIR.search(equation)
    if pair is None or not _SIGNS.search(equation):
        return (equation,)
    stem, *labels = pair["stem"], *(("+", "-") if pair["both"] else (pair["first"], pair["second"]))
    found, own = spellings(relation), {canonical(f"{stem}_{{{x}}}") for x in labels}
    if canonical(pair[0]) in found or not own & found or own & {*spellings(equation)}:
        return (equation,)
    lower = _SIGNS.sub(
        lambda sign: "-" if sign[1] == "pm" else "+", equation.replace(pair[0], f"{stem}_{{{labels[1]}}}")
    )
    upper = _SIGNS.sub(
        lambda sign: "+" if sign[1] == "pm" else "-", equation.replace(pair[0], f"{stem}_{{{labels[0]}}}")
    )
    return upper, lower


def with_scopes(asked: Asked) -> Asked:
    r"""What is printed beside a relation about the letters it holds for, as `\forall x > 0`, among the conditions."""
    if not _SCOPED.search(asked.relation):
        return asked
    relation = _ALL_AT_FIRST.sub(r"\1, ", asked.relation)
    try:
        inference, *_ = _told(replace(asked, relation=relation), 0)[0](SIZES[:1])
        tree = read(relation, inference.notation)
    except SymcheckError:
        return asked
    parts = tree.parts if isinstance(tree, System) else ()
    scopes = [part.scope if isinstance(part, Forall) else part for part in parts if _is_scope(part)]
    rest = tuple(part for part in parts if not _is_scope(part))
    if not scopes or not rest or not isinstance(tree, System):
        return asked
    stated = to_latex(replace(tree, parts=rest) if len(rest) > 1 or tree.qualifiers else rest[0])
    return replace(asked, relation=stated, given=(*asked.given, *(to_latex(s) for s in scopes if isinstance(s, Chain))))


def with_primes(asked: Asked) -> Asked:
    """The question with partial derivatives for the primes of functions of several letters, where it is said so."""
    for text in asked.where:
        said = _PRIME_SAID.match(text)
        if said is None or said["by"] not in said["at"].split(","):
            continue
        primed = re.compile(rf"(?<![A-Za-z\\]){re.escape(said['of'])}'\({re.escape(said['at'])}\)")
        slope_ = said["slope"].replace("\\", r"\\")
        rest = [each for each in asked.where if each != text]
        relation, *where = [primed.sub(slope_, each) for each in (asked.relation, *rest)]
        asked = replace(asked, relation=relation, where=tuple(where))
    return asked


def with_entries(asked: Asked) -> Asked:
    r"""The question with matrices for their entries at any place, as `A_{jk} = x_j y_k`, where it is said how many.

    The letters of the places stand in subscripts alone, and of no sum.
    """
    texts = (asked.relation, *asked.where)
    faces = {x for text in texts for x in _FACE.findall(text)}  # may be the same vector as the plain letter, or not
    known = {x: size for x, size in declared_sizes(asked).items() if x not in faces}
    if not known:
        return asked
    relation, *where = [_with_entries(text, known) for text in texts]
    return replace(asked, relation=relation, where=tuple(where))


def _with_entries(equation: str, known: Mapping[str, tuple[int | str, int | str]]) -> str:
    both = sides(equation)
    head = _ENTRY.match(both[0]) if both else None
    if head is None or both is None or head["of"] not in known:
        return equation
    places = [x for x in (head["row"], head["column"]) if x]
    numbers = [n for n in known[head["of"]] if n != 1][: len(places)]
    if len({*places}) < len(places) or len(numbers) < len(places) or not {*places} <= INDICES:
        return equation
    if any(not isinstance(n, int) or n > MOST_ENTRIES for n in numbers) or head["of"] in both[1]:
        return equation
    below = [match[0] for match in _BELOW.finditer(both[1])]
    beside = _BELOW.sub("", both[1])
    if not below or any(re.search(rf"(?<![A-Za-z\\]){x}(?![A-Za-z])", beside) for x in places):
        return equation

    def at(*place: int) -> str:
        by = dict(zip(places, map(str, place), strict=True))
        return _BELOW.sub(lambda match: "".join(by.get(c, c) for c in match[0]), both[1])

    rows, columns = (range(1, int(n) + 1) for n in (*numbers, 1)[:2])
    entries = [[at(*(j, k)[: len(places)]) for k in columns] for j in rows]
    written = r"\\".join("&".join(row) for row in entries)
    return rf"{head['of']}=\begin{{pmatrix}}{written}\end{{pmatrix}}"


def with_differentials(asked: Asked) -> Asked:
    r"""The question with letters for the differentials that are said to be some, where addends differ in their number.

    Such a relation is about numbers, if it is about anything; elsewhere they are what all differentials are.
    """
    signs = [letter for letter, phrase in asked.letters if phrase == "differential" and letter.startswith("d")]
    if not signs:
        return asked
    asked = replace(asked, letters=tuple(each for each in asked.letters if each[0] not in signs))
    try:
        readings(asked)
    except Uneven:
        for letter in (each for each in signs if each != "d"):
            there = re.compile(rf"(?<![A-Za-z\\]){re.escape(letter)}(?![A-Za-z])")
            name = f"d_{{{letter[1:]}}}".replace("\\", r"\\")
            relation, *where = [there.sub(name, each) for each in (asked.relation, *asked.where)]
            asked = replace(asked, relation=relation, where=tuple(where))
    except SymcheckError:
        pass
    return asked


def _is_scope(part: Tree) -> bool:
    scope = part.scope if isinstance(part, Forall) else part
    member = isinstance(scope, Chain) and scope.signs[-1] == r"\in"
    return member or (isinstance(part, Forall) and isinstance(scope, Name | Chain))


def sizes(asked: Asked) -> list[str]:
    """The letters that say how many components or addends there are."""
    found = [part for text in asked.given for m in [_SIZE_OF.search(text)] if m for part in m.groups() if part]
    for text in (asked.relation, *asked.where):
        found += [place.arguments[1] for place in occurrences(text) if place.role == "index" and place.arguments]
    return [each for each in dict.fromkeys(found) if tex.spelled(each) is not None and each != r"\infty"]


def with_whole_ends(asked: Asked) -> Asked | None:
    """The question with what a sum or product up to a letter says of it: a whole number, not below the first index.

    None where nothing is summed up to a letter of which nothing is said.
    """
    known = {letter for letter, _ in asked.letters} | {text.split()[0] for text in asked.given if _MEMBER.match(text)}
    texts = (asked.relation, *asked.where)
    ends = [place.arguments for text in texts for place in occurrences(text) if place.role == "index"]
    firsts = {end: int(first) for first, end in filter(None, ends) if first.isdigit() and _is_name(end)}
    told = {end: first for end, first in firsts.items() if end not in known and end != r"\infty"}
    if not told:
        return None
    said = [text for end, first in told.items() for text in (rf"{end} \in \mathbb{{Z}}", rf"{end} \ge {first}")]
    return replace(asked, given=(*asked.given, *said))


def apart(conditions: Iterable[str]) -> Iterator[str]:
    r"""Conditions, each of one letter where they are about members of sets: "m, n \in \mathbb{N}, m \ne n"."""
    for condition in conditions:
        found, waiting = list[str](), list[str]()
        for part in _between_commas(condition) if _MEMBER.match(condition) else ():
            if match := _MEMBER.match(part.strip()):
                found += (rf"{letter.strip()} \in {match[2]}" for letter in (*waiting, match[1]))
                waiting = []
            elif _RELATION.search(part):
                found.append(",".join((*waiting, part)).strip())
                waiting = []
            else:
                waiting.append(part)
        yield from found if found and not waiting else [condition]


def _between_commas(text: str) -> Iterator[str]:
    """The parts of a text between the commas that stand in no brackets."""
    depth, start = 0, 0
    for tok in tex.tokenize(text):
        depth += tok.text in ("{", "(", "[", r"\{")
        depth -= tok.text in ("}", ")", "]", r"\}")
        if tok.text == "," and depth == 0:
            yield text[start : tok.at]
            start = tok.at + 1
    yield text[start:]


def declared_sizes(asked: Asked) -> dict[str, tuple[int | str, int | str]]:
    """The numbers of rows and columns that are said of vectors and matrices: letters or numbers."""
    found: dict[str, tuple[int | str, int | str]] = {}
    for condition in asked.given:
        match = _MEMBER.match(condition.strip())
        kind = _SET.match(match[2].strip()) if match else None
        if match and kind and kind[3]:
            numbers = [int(n) if n.isdigit() else n for n in _numbers_of(kind[3])]
            if numbers and all(isinstance(n, int) or re.fullmatch(r"[A-Za-z]", n) for n in numbers):
                found[match[1]] = numbers[0], numbers[1] if len(numbers) > 1 else 1
    return found


def with_numbers(condition: str, numbers: Mapping[str, str]) -> str:
    """What a letter is with numbers for letters in its numbers of rows and columns; other conditions as they are."""
    match = _MEMBER.match(condition.strip())
    kind = _SET.match(match[2].strip()) if match else None
    if not match or not kind or not kind[3]:
        return condition
    size = r" \times ".join(numbers.get(n, n) for n in _numbers_of(kind[3]))
    return rf"{match[1]} \in \mathbb{{{kind[1]}}}^{{{size}}}"


def members(given: Iterable[str], said: Mapping[str, str]) -> tuple[list[str], dict[str, str]]:
    r"""The conditions that are formulas, and what the others, such as `n \in \mathbb{Z}_{>0}`, say of letters."""
    conditions, phrases = list[str](), dict(said)
    for condition in given:
        match = _MEMBER.match(condition.strip())
        if match and re.fullmatch(r"(?:\\(?:mathrm|operatorname|text)\s*\{)?SO\}?\s*\(\s*3\s*\)", match[2].strip()):
            phrases[match[1]] = "rotation"
            continue
        kind = _SET.match(match[2].strip()) if match else None
        if not match or not kind or (kind[2] == "0" and kind[1] != "N"):
            conditions.append(condition)
            continue
        latex, (which, part, size) = match[1], kind.groups()
        if which == "C" and size:
            raise SymcheckError(f"{condition}: vectors of complex numbers are not read; write them out")
        if size:
            phrases[latex] = f"real {_size(size, condition, said)}"
        elif _SETS[which]:
            phrases.setdefault(latex, _SETS[which])
        if part and ">" in part:
            conditions.append(f"{latex} > 0")
        elif part or which == "N":
            conditions.append(rf"{latex} \ge 0")
    for latex in (x for x, phrase in phrases.items() if phrase == "rotation"):
        conditions += [rf"{latex}^T {latex} = \operatorname{{diag}}(1, 1, 1)", rf"\det({latex}) = 1"]
    return conditions, phrases


def from_zero(given: Iterable[str]) -> set[str]:
    """The letters that are said to be whole numbers from 0 on, so that nobody means those above it."""
    found = ((match, _SET.match(match[2].strip())) for text in given if (match := _MEMBER.match(text.strip())))
    return {match[1] for match, kind in found if kind and kind[2] == "0"}


def _numbers_of(text: str) -> list[str]:
    r"""The numbers of rows and columns in `m \times n`, or of components in `n`."""
    found = re.fullmatch(r"\s*(\S+?)\s*(?:\\times\s*(\S+?))?\s*", text)
    return [n for n in found.groups() if n] if found else []


def _size(text: str, condition: str, said: Mapping[str, str]) -> str:
    numbers = [said.get(n, n).removeprefix("the number ") for n in _numbers_of(text)]
    if not numbers or not all(n.isdigit() for n in numbers):
        raise SymcheckError(f"{condition}: nothing can be said of vectors and matrices of all sizes at once")
    return " ".join(numbers)


def sides(latex: str) -> tuple[str, str] | None:
    """Both sides of an equation with one sign, brackets and environments minded."""
    depth, places = 0, []
    for tok in tex.tokenize(latex):
        depth += tok.text in ("{", "(", "[", r"\{", r"\begin")
        depth -= tok.text in ("}", ")", "]", r"\}", r"\end")
        if tok.text == "=" and depth == 0:
            places.append(tok.at)
    return (latex[: places[0]].strip(), latex[places[0] + 1 :].strip()) if len(places) == 1 else None


def definitions(
    where: Sequence[str], formulas: Sequence[str] = ()
) -> tuple[dict[str, tuple[str, tuple[str, ...], str]], list[str]]:
    """Equations solved for a letter, as (left side, its arguments, right side) by the letter, and all others.

    One of which other formulas print derivatives, as in y' or u_{xx}, is a function though it is printed without
    arguments.
    """
    found: dict[str, tuple[str, tuple[str, ...], str]] = {}
    others = []
    for equation in where:
        if (parts := sides(equation)) is None or (head := _head(parts[0])) is None:
            others.append(equation)
            continue
        name, arguments = head
        inside = spellings(parts[1])
        if arguments:  # of which a label may have the name: R(z) and z_R
            inside = frozenset(spelling(place) for place in occurrences(parts[1]) if place.role != "subscript")
        if name in found or name in inside or not _is_for_all(name, arguments, parts[1], formulas):
            others.append(equation)
        else:
            found[name] = (parts[0], arguments or _varied(name, parts[1], formulas), parts[1])
    return found, others


def _varied(name: str, right: str, formulas: Sequence[str]) -> tuple[str, ...]:
    """The letters by which derivatives of a letter are printed: the one for its primes, or those in its subscripts."""
    inside = dict.fromkeys(spelling(place) for place in occurrences(right) if place.role != "subscript")
    places = [place for formula in formulas for place in occurrences(formula) if place.word == name]
    below = {token for place in places for token in place.subscript or () if token not in "{}"}
    if below and below <= inside.keys():
        return tuple(x for x in inside if x in below)
    if not any(place.primes for place in places):
        return ()
    free = [x for x in inside if x in PRIMED] or [*inside]
    return tuple(free) if len(free) == 1 else ()


def _head(left: str) -> tuple[str, tuple[str, ...]] | None:
    """The letter that is defined, with its arguments, if the left side is nothing else."""
    places = [place for place in occurrences(left) if place.role != "subscript"]
    if not places or places[0].dots or places[0].primes or places[0].superscript:
        return None
    first, rest = places[0], places[1:]
    if first.arguments is None:
        return (spelling(first), ()) if _is_name(left) and not rest else None
    name, bracket, _ = left.partition("(")
    own = [spelling(place) for place in rest]
    letters_ = [canonical(each) if is_letter(each) else "" for each in first.arguments]
    if own != letters_ or not bracket or not left.rstrip().endswith(")"):
        return None
    if not _is_name(name.removesuffix(r"\left").rstrip()):
        return None
    return spelling(first), tuple(own)


def _is_for_all(name: str, arguments: Sequence[str], right: str, formulas: Sequence[str]) -> bool:
    """Does an equation say what a function is everywhere: not at one place, nor another for each index?"""
    calls = [place for text in formulas for place in occurrences(text) if place.word == name and place.arguments]
    for k, each in enumerate(arguments):
        if is_one_place(each, spellings(right)):
            return False
        elsewhere = [place.arguments[k : k + 1] for place in calls if place.arguments]
        if not runs(each) and any(x != each and is_letter(x) and runs(x) for own in elsewhere for x in own):
            return False
        below = {x for place in occurrences(each)[:1] for x in words(place.subscript)}
        others = [p for p in occurrences(right) if p.role != "subscript" and spelling(p) != each]
        if below and (not below <= INDICES or each not in spellings(right)):
            return False
        if any(below.intersection((place.word, *words(place.subscript))) for place in others):
            return False
    return True


def _is_name(latex: str) -> bool:
    """Is this a letter, or a name of several tokens such as `x^*`, and nothing more?"""
    spaced = " ".join(text for text in tex.texts(latex) if text not in SPACES)
    return is_letter(spaced) or spaced in names_of_several_tokens([spaced], {})


def readings(asked: Asked, size: int = 0, *, likely: bool = False) -> list[Reading]:
    """All readings that make sense; SymcheckError with the reason of the first if none does.

    With a size the letters that say how many components or addends there are stand for it. Where a likely one is
    wanted, the remote ones alone do not count.
    """
    inferences, defined, equations, conditions = _told(asked, size)
    errors = list[SymcheckError]()
    for tried in (SIZES, *OTHERS):
        found = []
        for inference in inferences(tried):
            try:
                found.append(_reading(asked, inference, defined, equations, conditions))
            except Doubt as error:
                if not (found or inference.remote):
                    raise
                errors.append(error)
            except (NoForm, Unsaid) as error:
                errors.append(_understood(asked, inference, conditions, str(error)))
            except SymcheckError as error:
                families = any(x.running and (x.depends or x.kind != "scalar") for x in inference.notation.letters)
                errors.append(_understood(asked, inference, conditions, str(error)) if families else error)
        if any(not (x.inference.remote if likely else x.inference.beside) for x in found):
            return found
    raise next((error for error in errors if isinstance(error, Understood)), errors[0])


def unlowered(asked: Asked) -> list[Reading]:
    """The usual readings, whose letters alone are told: what is printed may be about matrices of all sizes."""
    inferences, defined, equations, conditions = _told(asked, SIZES[0])
    return [
        Reading(each, read(asked.relation, each.notation), (), {}, (asked, each, defined, equations, conditions))
        for each in inferences(SIZES[:1])
        if not each.remote
    ]


def _told(
    asked: Asked, size: int
) -> tuple[Callable[[Sequence[int]], list[Inference]], Definitions, list[str], list[str]]:
    """How the letters of a question are inferred for some sizes; its definitions, its equations, its conditions."""
    fixed = dict.fromkeys(sizes(asked), f"the number {size}") if size else {}
    conditions, said = members(asked.given, {**dict(asked.letters), **fixed})
    defined, equations = definitions(asked.where, [asked.relation, *asked.where, *asked.given])
    heads = {name: arguments for name, (_, arguments, _) in defined.items()}
    formulas = [asked.relation, *asked.where, *conditions]
    return partial(inferred, formulas, said | fixed, heads), defined, equations, conditions


def _understood(asked: Asked, inference: Inference, conditions: Sequence[str], reason: str) -> SymcheckError:
    """What is known of a question without a form: it is read whole, or what cannot be read."""
    try:
        tree, *_ = [read(text, inference.notation) for text in (asked.relation, *asked.where, *conditions)]
    except SymcheckError as error:
        return error
    return Understood(inference, tree, reason)


def _reading(
    asked: Asked,
    inference: Inference,
    defined: Definitions,
    equations: Sequence[str],
    conditions: Sequence[str],
    tree: Tree | None = None,
) -> Reading:
    notation = inference.notation
    functions_ = functions_of(defined, notation)
    meant = meanings(defined, notation) | functions_
    tree = tree or read(asked.relation, notation)
    claims = algebraic(tree, notation, meant)
    stated: dict[str, str] = {}
    hypotheses: list[tuple[str, tuple[Formula, ...]]] = []
    terms: dict[str, Term] = {}
    solved = set[str]()
    heads = {name: f"{left} = {right}" for name, (left, _, right) in defined.items()}
    families = families_of(asked, (*heads.values(), *equations), notation, meant)
    equations = [text for text in equations if text not in families]
    for name, (left, _, right) in defined.items():
        if name in functions_ or heads[name] in families:
            continue
        for formula in algebraic(read(f"{left} = {right}", notation), notation, meant):
            head, value = formula[1], formula[2]
            if (letter := _solved(formula, terms)) is not None:
                terms[letter] = value
            elif head != value:  # as it is where the definition is written out
                hypotheses.append((_named(stated, f"{left} = {right}"), (formula,)))
    for fact in inference.facts:
        for formula in algebraic(read(fact, notation), notation, meant):
            head, value = formula[1], formula[2]
            if isinstance(head, str) and head not in terms:
                terms[head] = value
            else:
                hypotheses.append((_named(stated, fact), (formula,)))
    for text in equations:
        for formula in algebraic(read(text, notation), notation, meant):
            formula = _without_factor(formula)
            if (letter := _solved(formula, terms)) is not None:
                terms[letter] = formula[2]
                solved.add(letter)
            else:
                hypotheses.append((_named(stated, text), (formula,)))
                rate = _rate(formula) if _has_rates(claims) else None
                if rate is not None:  # an earlier equation holds at all times
                    hypotheses.append((_named(stated, f"the derivative of {text}"), (rate,)))
    for text in conditions:
        condition = read(text, notation)
        formulas = algebraic(condition, notation, meant)
        hypotheses.append((_named(stated, text), formulas))
        if _has_rates(claims) and _is_lasting(condition, notation):
            rates = tuple(rate for formula in formulas if (rate := _rate(formula)) is not None)
            hypotheses += [(_named(stated, f"the derivative of {text}"), rates)] if rates else []
    lambdas = {function: term for several in families.values() for function, term in several.items()}
    stating = [(name, f) for name, fs in hypotheses for f in fs]
    lambdas |= {f[1].function: (f[1].terms, f[2]) for _, f in stating if _says_function(f, notation)}  # type: ignore[union-attr, misc]
    hypotheses = [(name, fs) for name, fs in hypotheses if not any(_says_function(f, notation) for f in fs)]
    for _ in lambdas:  # one may be said by another
        claims = tuple(_said_at(claim, lambdas) for claim in claims)
        hypotheses = [(name, tuple(_said_at(f, lambdas) for f in fs)) for name, fs in hypotheses]
        terms = {name: _said_at(term, lambdas) for name, term in terms.items()}
    if isinstance(tree, System):
        equations_ = [f for _, fs in hypotheses for f in fs if f.tag == "="]
        free = letters(node("and", *claims)).difference(terms, *map(letters, equations_))
        restricting = [claim for claim in claims if _restricts(claim, free)]
        if len(restricting) < len(claims):
            claims = tuple(claim for claim in claims if claim not in restricting)
            hypotheses += [(_named(stated, term(claim)), (claim,)) for claim in restricting]
    claims = tuple(written_under(claim, terms) for claim in claims)
    hypotheses = [(name, tuple(written_under(f, terms) for f in fs)) for name, fs in hypotheses]
    terms = {name: written_under(term, terms) for name, term in terms.items()}
    hypotheses = [(name, tuple(written_in_functions(f, terms) for f in fs)) for name, fs in hypotheses]
    said = [f for _, fs in hypotheses for f in fs]
    refuse_tied_bodies(functions_, (asked.relation, *asked.where, *asked.given), said, terms, notation)
    refuse_tied([*claims, *said], len(claims), tree, terms, solved, notation)
    hypotheses, held, regular = _differentiated(claims, hypotheses, terms, notation)
    claims = tuple(map(rooted, claims))
    hypotheses = [(name, tuple(map(rooted, formulas))) for name, formulas in hypotheses]
    terms = {name: rooted(term) for name, term in terms.items()}
    turned = parted_angles([*claims, *(f for _, fs in hypotheses for f in fs), *terms.values()], terms)
    terms |= turned
    hypotheses = _used(claims, hypotheses, terms)
    order = in_order(terms)
    limiting = any(isinstance(part, Limiting) for _, part in walk(tree))
    if limiting or any(letter.order is not None for letter in notation.letters):
        beside = [node("=", x, terms[x]) for x in solved & set().union(*map(letters, claims))]
        _refuse_unsolved(claims, [*(f for _, fs in hypotheses for f in fs), *beside])
    cases = [(name, case) for name, claim in _numbered(claims) for case in _cases(claim, tree)]
    said = [f for _, fs in hypotheses for f in fs]
    problems = list[Problem]()
    for name, (premises, claim) in cases:
        more = ((CASE, premises),) if premises else ()
        unfolding = _needed((claim, *premises, *said), terms, order)
        needed = (claim, *premises, *said, *(t for _, t in unfolding))
        valued = _valued((*needed, *(t for x, t in terms.items() if x not in dict(unfolding))), terms, limiting)
        free = set().union(*map(letters, needed))
        valued = tuple(each for each in valued if letters(each) <= free)  # of others nothing is asked
        if premises and not may_all_hold([*_stated(hypotheses), *valued, *premises]):
            continue
        given = (*hypotheses, *((DEFINED, valued),) * bool(valued), *more)
        problems.append(Problem(name, claim, unfolding, given))
    return Reading(
        inference, tree, tuple(problems), stated, (asked, inference, defined, equations, conditions), held, regular
    )


def _numbered(claims: Sequence[Formula]) -> Iterator[tuple[str, Formula]]:
    return ((f"question{n or ''}", claim) for n, claim in enumerate(claims))


def _stated(hypotheses: Iterable[tuple[str, tuple[Formula, ...]]]) -> list[Formula]:
    return [part for _, fs in hypotheses for f in fs for part in conjuncts(f)]


def _cases(claim: Formula, tree: Tree) -> Iterable[tuple[tuple[Formula, ...], Formula]]:
    """The claim, or each of its cases with the conditions, where values by cases are printed."""
    jumps = any(isinstance(part, Call) and part.function in JUMPS for _, part in walk(tree))
    return implied(claim) if jumps else (((), claim),)


def _needed(trees: Iterable[Formula], terms: Mapping[str, Term], order: Sequence[str]) -> tuple[tuple[str, Term], ...]:
    """The definitions of letters in formulas, and of letters in these."""
    needed = set().union(*map(letters, trees))
    for letter in reversed(order):
        needed |= letters(terms[letter]) if letter in needed else set()
    return tuple((letter, terms[letter]) for letter in order if letter in needed)


def _valued(trees: Sequence[Term], terms: Mapping[str, Term], limiting: bool) -> tuple[Formula, ...]:
    """That all printed terms have values, as far as it depends on letters; refused where one has none."""
    divided = (each for each in domain(*trees, divisors=True) if each.tag == "!=" and _is_rational(each[1], terms))
    printed = dict.fromkeys((*domain(*trees), *divided, *begun(*trees)))
    valued = tuple(each for each in printed if letters(each) or functions(each))
    for each in printed:
        if each not in valued and not _may_hold(each):
            error = NoForm if limiting else SymcheckError
            raise error(f"a printed term has no value, as {term(each)} is not so")
    return valued


def _differentiated(
    claims: Sequence[Formula],
    hypotheses: Sequence[tuple[str, tuple[Formula, ...]]],
    terms: dict[str, Term],
    notation: Notation,
) -> tuple[list[tuple[str, tuple[Formula, ...]]], dict[str, set[str]], tuple[Formula, ...]]:
    """Definitions and equations differentiated, where differentials are printed.

    With what is constant in them, and where the equations are those of curves in all directions that they allow.
    """
    found = list(hypotheses)
    said = [*claims, *(f for _, fs in hypotheses for f in fs), *terms.values()]
    names = set().union(*map(letters, said)) | terms.keys()
    varying = {x for x in names if differential(x) in names}
    rates = {differential(x) for x in varying}
    if not varying:
        return found, {}, ()
    while more := {x for x, t in terms.items() if letters(t) & varying} - varying - rates:
        varying |= more
    equations = list[Formula]()
    held = {"": _held(said, varying)}
    for x in in_order(terms):
        if x not in varying:
            continue
        rate = total(terms[x], varying)
        if rate == 0:
            raise SymcheckError(f"how does {x} vary? print the differentials of what it depends on")
        if differential(x) not in terms:
            terms[differential(x)] = rate
            held[""] |= _held([rate], varying)
        else:
            found.append((f"differential of {x}", (node("=", differential(x), rate),)))
            held[found[-1][0]] = _held([rate], varying)
    for name, formulas in hypotheses:
        for formula in formulas:
            if formula.tag == "=" and letters(formula) & varying and letters(formula).isdisjoint(rates):
                left, right = (total(side, varying) for side in formula.terms)
                found.append((f"differential of {name}", (node("=", left, right),)))
                equations.append(formula)
                held[found[-1][0]] = letters(formula) - varying
    return found, held, tuple(_regular(f, varying) for f in equations)


def _held(trees: Iterable[Term], varying: set[str]) -> set[str]:
    """The letters that do not vary where slopes by others are taken."""
    slopes = (part for part in nodes(*trees) if part.tag == "diff" and part.outside[-1] in varying)
    inside = set().union(*(letters(slope.inside[0]) - {*slope.bound} for slope in slopes))
    return inside - varying - {differential(x) for x in varying}


def _regular(equation: Formula, varying: Iterable[str]) -> Formula:
    """That some slope of an equation is not 0: then there are curves in each direction that it allows."""
    gap = node("+", equation[1], node("-", equation[2]))
    slopes = [node("^", slope(gap, x), 2) for x in sorted(letters(equation) & {*varying})]
    return node("!=", node("+", *slopes) if len(slopes) > 1 else slopes[0], 0)


def _is_rational(divisor: Term, terms: Mapping[str, Term]) -> bool:
    """Is it made of free letters? Of other divisors the search finds out for itself that they do not vanish."""
    plain = all(part.tag in ("+", "-", "*", "/", "^", "pi") for part in nodes(divisor))
    return plain and letters(divisor).isdisjoint(terms)


def _has_rates(formulas: Iterable[Formula]) -> bool:
    return any(isinstance(part, Applied) and any(part.orders) for part in nodes(*formulas))


def _rate(equation: Formula) -> Formula | None:
    """The derivative of an equation between functions of one letter, as that of a constraint by time."""
    calls = [part for part in nodes(equation) if isinstance(part, Applied)]
    places = {call.terms for call in calls}
    if any(part.tag == "diff" for part in nodes(equation)):
        return None  # an equation of motion already
    if equation.tag != "=" or len(places) != 1 or any(any(call.orders) for call in calls):
        return None
    ((place, *more),) = places
    if more or not isinstance(place, str) or is_at_one_place(equation, place):
        return None
    with suppress(Unknown):
        return node("=", derivative(node("+", equation[1], node("-", equation[2])), place), 0)
    return None


def _is_lasting(tree: Tree, notation: Notation) -> bool:
    """Is it an equation of one vector or matrix with numbers alone, but not with its values: a length, or a symmetry?

    Others, such as that two vectors are perpendicular, may hold at one moment.
    """
    if not isinstance(tree, Chain) or tree.signs != ("=",) or any(isinstance(side, Name) for side in tree.members[:1]):
        return False
    found = {part for _, part in walk(tree) if isinstance(part, Name)}
    letters_ = [notation.find(name.letter, len(name.subscripts)) for name in found if not (name.dots or name.primes)]
    own = [x for x in letters_ if x is not None and not x.identity]
    return len(letters_) == len(found) and len(own) == 1 and own[0].kind in ("vector", "matrix")


def _restricts(claim: Formula, free: Iterable[str]) -> bool:
    """Is this beside other relations their condition, as x > 0 or |x| < 1 are where nothing else is said of the letter?

    Nobody claims that all numbers are positive, or equal to 2.
    """
    if not isinstance(claim, Relation) or not letters(claim) <= {*free}:
        return False
    bare = [isinstance(side, str) or _is_absolute_value(side) for side in claim.terms]
    constant = [not letters(side) for side in claim.terms]
    return any(bare) and (any(constant) or (all(bare) and claim.tag != "="))


def _is_absolute_value(side: Term) -> bool:
    match side:
        case Value(tag="sqrt", terms=(Value(tag="^", terms=(str(), 2)),)):
            return True
    return False


def _used(
    claims: Sequence[Formula], hypotheses: Sequence[tuple[str, tuple[Formula, ...]]], terms: Mapping[str, Term]
) -> list[tuple[str, tuple[Formula, ...]]]:
    """The hypotheses but for those that say what a function is that occurs nowhere else."""

    def is_needed(formula: Formula) -> bool:
        head = formula[1]
        if formula.tag != "=" or not isinstance(head, Applied) or not all(isinstance(x, str) for x in head.terms):
            return True
        others = (f for _, fs in hypotheses for f in fs if f is not formula)
        own = functions(formula[2])
        return head.function in own.union(*map(functions, (*claims, *terms.values(), *others)))

    return [(name, kept) for name, fs in hypotheses if (kept := tuple(filter(is_needed, fs)))]


def _refuse_unsolved(claims: Iterable[Formula], conditions: Iterable[Formula]) -> None:
    """NoForm where other letters may depend on one that goes to 0, by a condition that does not say how."""
    small = {x for part in nodes(*claims) if part.tag == "diff" for x in part.bound}
    for condition in conditions:
        if (inside := letters(condition)) & small and not inside <= small:
            raise NoForm(
                f"do other letters depend on {', '.join(small & inside)} in {term(condition)}? solve it for one"
            )


def _solved(formula: Formula, terms: Mapping[str, Term]) -> str | None:
    """The letter of which an equation says what it is, if no other does and there is no circle."""
    head = formula[1]
    if formula.tag != "=" or not isinstance(head, str) or head in terms:
        return None
    needed, more = set[str](), letters(formula[2])
    while more:
        needed |= more
        more = set().union(*(letters(terms[x]) for x in more if x in terms)) - needed
    return None if head in needed else head


def _without_factor(formula: Formula) -> Formula:
    """An equation of a multiple of a letter, with a number that is not 0, solved for the letter."""
    match formula.outside:
        case (Value(tag="*", terms=factors), right) if formula.tag == "=":
            free = [each for each in factors if letters(each)]
            numbers = [each for each in factors if not letters(each)]
            plain = all(
                isinstance(part, Value) and part.tag in ("pi", "/", "^", "*", "sqrt") for part in nodes(*numbers)
            )
            if (
                len(free) == 1
                and isinstance(free[0], str)
                and plain
                and 0 not in numbers
                and free[0] not in letters(right)
            ):
                return node("=", free[0], node("/", right, node("*", *numbers) if len(numbers) > 1 else numbers[0]))
    return formula


def _may_hold(condition: Formula) -> bool:
    """Whether a condition on numbers is so, or cannot be told."""
    try:
        return Algebra({}, {}).holds(condition)
    except (Reject, Unknown):
        return True


def begun(*trees: Term) -> Iterator[Formula]:
    """That sums and products to a letter have a first addend or factor: nobody prints an empty one."""
    for part in nodes(*trees):
        if part.tag in ("sum", "product") and not any(isinstance(end, End) for end in part.outside):
            low, high = part.outside
            yield node("<=", low, high)


def worded(reading: Reading, tree: Tree) -> tuple[Problem, ...]:
    """The problems with another relation in the place of the one that was asked about."""
    return _reading(*reading.source, tree).problems


def alone_of(reading: Reading) -> Reading:
    """The reading with the same letters and without definitions and conditions."""
    asked, inference, *_ = reading.source
    return _reading(replace(asked, where=(), given=()), replace(inference, facts=()), {}, (), (), reading.tree)


def rooted(tree: T) -> T:
    """The same with powers of halves as powers of roots, negative ones as their reciprocals."""
    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, rooted)
    if isinstance(new, Value) and new.tag == "pow":
        with suppress(Unsupported):
            if (exponent := constant(new.terms[1])).denominator == 2:
                root, count = node("sqrt", new.terms[0]), abs(exponent.numerator)
                power = root if count == 1 else node("^", root, count)
                return power if exponent > 0 else node("/", 1, power)  # type: ignore[return-value]
    return new  # type: ignore[return-value]


def parted_angles(trees: Iterable[Term], defined: Mapping[str, Term]) -> dict[str, Term]:
    """Letters of which parts such as x/2 stand under a sine, cosine or exponential, as multiples of new letters."""
    parts: dict[str, int] = {}
    for tree in trees:
        for x, d in _parts(tree, angle=False):
            parts[x] = lcm(parts.get(x, 1), d)
    return {x: node("*", d, f"{x}_part") for x, d in parts.items() if d > 1 and x not in defined}


def _parts(tree: Term, *, angle: bool) -> Iterator[tuple[str, int]]:
    """The letters under a sine or cosine that are divided by whole numbers, with these; bound ones are left alone."""
    match tree:
        case Value(tag="/", terms=(str(x), int(d))) if angle and d > 0:
            yield x, d
        case Value(tag="/", terms=(Value(tag="*", terms=(*_, str(x))), int(d))) if angle and d > 0:
            yield x, d
        case Value(tag="*", terms=(Value(tag="/", terms=(int(), int(d))), str(x))) if angle and d > 0:
            yield x, d
        case Value(tag="/", terms=(Value(tag="+") as total, int(d))) if angle and d > 0:
            yield from ((x, d) for x in sorted(letters(total)))
        case Node(bound=()):
            for part in tree.outside:
                yield from _parts(part, angle=angle or tree.tag in ("sin", "cos", "tan", "exp"))
        case Binder(tag="diff"):
            return


def meanings(defined: Definitions, notation: Notation) -> dict[str, tuple[tuple[Tree, ...], Tree]]:
    """The definitions of letters without arguments; what cannot be read is refused where it is stated."""
    found: dict[str, tuple[tuple[Tree, ...], Tree]] = {}
    for name, (_, _, right) in defined.items():
        with suppress(SymcheckError):
            found[name] = (), read(right, notation)
    return found


def functions_of(defined: Definitions, notation: Notation) -> dict[str, tuple[tuple[Tree, ...], Tree]]:
    """The definitions of functions: f(x) = ..., or f = ... where f is one of x."""
    found = {}
    for name, (_, arguments, right) in defined.items():
        letter = notation.find(name, 0)
        if letter is None or not letter.applies or letter.named:
            continue
        own = tuple(read(each, notation) for each in arguments) if arguments else dependence(letter, notation)
        if own:
            found[name] = own, read(right, notation)
    return found


def _said_at(tree: T, lambdas: Mapping[str, Lambda]) -> T:
    """The same with what functions are in their place: it is so at all times, also where there is a derivative by time.

    So what depends on the letter of a derivative is differentiated, though its name says nothing of that letter.
    """
    if not isinstance(tree, Node):
        return tree
    new = mapped(tree, lambda part: _said_at(part, lambdas))
    if isinstance(new, Applied) and new.function in lambdas:
        own, body = lambdas[new.function]
        if any(new.orders):
            return substituted(new, {}, lambdas)  # type: ignore[return-value]
        return substituted(body, dict(zip(own, new.terms, strict=True)))  # type: ignore[return-value]
    return new  # type: ignore[return-value]


def _says_function(formula: Formula, notation: Notation) -> bool:
    """Does an equation say what a known function is of two letters, as that of the incomplete gamma function does?"""
    match formula.outside:
        case (Applied(function=name, terms=(str(), str()) as own), body) if formula.tag == "=":
            return own[0] != own[1] and notation.owner(name) is None and name not in functions(body)
    return False


def families_of(
    asked: Asked, texts: Sequence[str], notation: Notation, meant: Mapping[str, tuple[tuple[Tree, ...], Tree]]
) -> dict[str, dict[str, Lambda]]:
    """The equations that say what a letter is at each value of an index over which sums run to a letter, as x_k = 2 k.

    Both sides are read under such a sum: there the letter is a function of its index.
    """
    found: dict[str, dict[str, Lambda]] = {}
    if not any(letter.running for letter in notation.letters):
        return found
    sums: dict[str, BigSum] = {}
    for text in (asked.relation, *texts):
        with suppress(SymcheckError):
            for _, part in walk(read(text, notation)):
                if isinstance(part, BigSum) and len(part.indices) == 1 and part.high is not None:
                    sums.setdefault(part.indices[0], part)
    for text in texts:
        with suppress(SymcheckError):
            found[text] = dict(_family(read(text, notation), sums, notation, meant))
    return {text: family for text, family in found.items() if family}


def _family(
    tree: Tree, sums: Mapping[str, BigSum], notation: Notation, meant: Mapping[str, tuple[tuple[Tree, ...], Tree]]
) -> Iterator[tuple[str, Lambda]]:
    match tree:
        case Chain((Name(subscripts=(str(index),)), _), ("=",)) if index in sums:
            summed = Chain(tuple(replace(sums[index], body=each) for each in tree.members), tree.signs)
            for formula in algebraic(summed, notation, meant):
                match formula.outside:
                    case (
                        Binder(tag="sum", body=Applied() as call, letter=k),
                        Binder(tag="sum", body=body, letter=same),
                    ):
                        own = tuple(x for x in call.terms if isinstance(x, str))
                        if k == same and own == call.terms and call.function not in functions(body):
                            yield call.function, (own, body)


def _named(stated: dict[str, str], text: str) -> str:
    name = f"h{len(stated) + 1}"
    stated[name] = text
    return name


def in_order(terms: Mapping[str, Term]) -> list[str]:
    """Names in an order in which each definition uses those before it."""
    found: list[str] = []
    todo = dict(terms)
    while todo:
        ready = [name for name, term in todo.items() if not letters(term) & todo.keys()]
        if not ready:
            raise SymcheckError(f"the definitions of {', '.join(todo)} go in a circle; give one of them as a condition")
        found += ready
        for name in ready:
            del todo[name]
    return found
