"""From the grammar's parse to the tree. Whatever could be read in two ways is an error."""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Any

from symcheck.core.verdicts import SymcheckError
from symcheck.reading import tex
from symcheck.reading.arguments import is_doubled
from symcheck.reading.faces import face
from symcheck.reading.functions import FIELDS, INVERSES
from symcheck.reading.grammar import ParseNode, parse
from symcheck.reading.lexer import COMMA_AT_END, WIDE_COMMA, Lexer
from symcheck.reading.names import DIMENSIONLESS, NO_FACTORS, PRODUCTS, is_expectation
from symcheck.reading.notation import Letter, Notation
from symcheck.reading.printing import to_latex
from symcheck.reading.tree import (
    BRACKETED,
    LOGIC,
    STATEMENTS,
    Add,
    And,
    Antiderivative,
    Bars,
    BigProduct,
    BigSum,
    Binomial,
    Blank,
    Call,
    CaseList,
    Chain,
    Cross,
    Degrees,
    Derivative,
    Diag,
    Div,
    Dots,
    ElementsOf,
    Evaluated,
    Exists,
    Factorial,
    Forall,
    Given,
    Iff,
    Implies,
    Indexed,
    Infinity,
    Integral,
    Interval,
    Limiting,
    Located,
    Marked,
    MatrixOf,
    Mean,
    Mul,
    Name,
    Neg,
    Norm,
    Number,
    Operated,
    Or,
    Over,
    Pair,
    Piecewise,
    PlusMinus,
    Pow,
    Qualifier,
    Root,
    Sqrt,
    System,
    Total,
    Transpose,
    Tree,
    Tuple,
    Values,
    Words,
    children,
    nodes,
)
from symcheck.reading.tree import nodes as walked  # where a rule of the grammar calls its own parts nodes

OF_MATRICES = ("det", "tr", "vec", "log", "exp")  # functions of which one letter without brackets is the argument
_INDICES = re.compile(r"(?<![A-Za-z\\])[a-z](?![A-Za-z])")  # below the sign of a sum
ANGULAR = frozenset({"sin", "cos", "tan", "tg", "cot", "ctg", "sec", "csc"})
LOGARITHMS = frozenset({"log", "ln", "lg", "lb"})
REACHING = ("integral", "antiderivative", "over", "sum", "under")  # to the end of a product
TRACES = frozenset({"tr", "Tr", "sp", "Sp"})
SIMPLE_KINDS = ("scalar", "index", "function")
_BRACKETS_ARE_IDLE = (Name, Number, Call, Sqrt, Pow, Mul, Div, Derivative, Degrees, Pair, Norm)
COUNTERS = frozenset("nkijml")  # letters that count
ANGLES = frozenset({r"\theta", r"\vartheta", r"\phi", r"\varphi", r"\psi", r"\nu"})
OFTEN_ANGLES = frozenset({r"\alpha", r"\beta", r"\gamma", r"\delta", r"\eta", r"\mu", r"\lambda", r"\Omega", "E", "i"})
LENGTHS = frozenset({"t", r"\tau", "x", "y", "z", "s", "l", "L", r"\ell", "n", "k", "T"})  # what wave numbers multiply
AT_OR_TIMES = "at the place in these brackets, or times it? leave out the brackets, or say what is a function"
_D = re.compile(r"(?:\\[a-z]+\{)?(?:[dD]|\\text\{[dD]\})\}?")  # upright or not, with an accent or without
_OPERATOR = re.compile(r"\\(?:hat|mathcal)\{[A-Z]\}")  # before the state to which it is applied
# what is applied to events: the signs of probabilities, and the indicator
_OF_EVENTS = frozenset(
    {"P", r"\mathbb{P}", r"\mathcal{P}", r"\text{P}", r"\text{Pr}", r"\text{Prob}", r"\text{indicator}"}
)
_STATE = re.compile(r"\\(?:psi|Psi|phi|Phi|varphi|chi)(?![a-z])")  # the usual letters for one
SCRIPT = (r"\mathcal", r"\mathscr", r"\mathfrak")  # faces of operators
_REMARK = re.compile(r"\\text\{(?:.*~|[A-Za-z][a-z]{4})")  # several words, or a long one, which is no unit
_SEVERAL = re.compile(r"\\text\{[^}]*[~ $]")  # several words, or a formula among them
_WORD = re.compile(r"\\text\{[a-z]{2,}\}")  # in small letters, as a function is called
_TRANSPOSED = re.compile(r"\^\s*(?:\{\s*)?\\text\s*\{\s*T\s*\}")  # by an upright T
_MATRIX_OF = re.compile(r"(?<![A-Za-z\\])[A-CE-IK-Z]\s*[a-z]\s*\(")  # before a value, as D is in `C x(t) + D u(t)`
_DERIVATIONS = frozenset({"D", "J", r"\text{D}"})  # letters of derivatives, and of their matrices
# what shows that letters are matrices
_OF_MATRICES = re.compile(r"\^\s*(?:\{\s*)?(?:T|\\top|\\intercal)(?![A-Za-z])|\\[sp](?:ucc|rec)eq")
_VERB = re.compile(r"\\text\{[a-z]{3,}\}_")  # a word in small letters with an index, as `prox_f`
_PLAIN = (Number, Dots, Name, Add, Neg, Mul)  # of what the values of an index consist
SUBJECT = r"\text{subject~to}"  # what stands before it is to be found
_BARE_E = re.compile(r"(?<![A-Za-z\\])E(?!\s*(?:\\left|\\[bB]igg?l?)?\s*\[|\s*_)")  # not before square brackets
_MEAN = re.compile(r"(?<![A-Za-z\\])E\s*(?:\\left|\\[bB]igg?l?)?\s*\[")  # the sign of an expectation
_LOOSE = frozenset({"exists", "iff", "implies", "either"})  # rules of logical connectives
# signs beside which an interval stands
_OF_SETS = re.compile(r"\\(?:in|notin|subset|subseteq|supset|cup|cap|setminus)(?![a-z])")
_ARROWS = frozenset({r"\to", r"\rightarrow", r"\longrightarrow"})
_ORDERS = {"<": "up", r"\le": "up", ">": "down", r"\ge": "down"}


@dataclass(frozen=True, slots=True)
class Differential(Tree):
    """The `d^n f` of a derivative, or its `dx^n dy`, before the fraction is put together."""

    order: int
    body: tuple[Tree, ...]
    partial: bool
    bracketed: bool = False


_NO_TERMS = (*STATEMENTS, Differential)


@dataclass(slots=True)
class Listing:
    """What stands in brackets, or the whole statement: entries with labels and the separators between them."""

    entries: list[tuple[str, Tree]]
    separators: list[str]
    at: int
    wide: list[bool]  # is there more than a comma between two entries?
    words: list[str]  # the separators as printed
    loose: bool  # does a logical connective stand here outside of brackets?


def _operates(tree: Tree) -> bool:
    """Is it a sum whose addends are factors, and one or more end with a derivative of nothing?"""
    terms = tree.terms if isinstance(tree, Add) else (tree,)
    return any(map(_is_operator, terms)) and not any(
        isinstance(part, Blank) for term in terms if not _is_operator(term) for part in walked(term)
    )


def _is_operator(term: Tree) -> bool:
    """Is it a derivative of nothing, with factors before it?"""
    last = _bare(term)
    last = last.factors[-1] if isinstance(last, Mul) else last
    return isinstance(last, Derivative) and isinstance(last.body, Blank)


def _bare(term: Tree) -> Tree:
    return term.value if isinstance(term, Neg) else term


def _operated(operator: Tree, body: Tree) -> Tree:
    """What a sum of operators makes of something: each addend applied to it, or times it."""
    if isinstance(operator, Add):
        return Add(tuple(_operated(term, body) for term in operator.terms))
    if isinstance(operator, Neg):
        return Neg(_operated(operator.value, body))
    *before, last = operator.factors if isinstance(operator, Mul) else (operator,)
    dotted = operator.dotted if isinstance(operator, Mul) else ()
    if not isinstance(last, Derivative) or not isinstance(last.body, Blank):
        return body if operator == Number("1") else Mul((*before, last, body), dotted)
    after = replace(last, body=body)
    return Mul((*before, after), dotted) if before else after


@dataclass(slots=True)
class Item:
    """One factor before functions, sums and derivatives have taken their arguments.

    kind: "atom", "fraction" (also a root), "group" (round brackets), "function", "sum", "integral", "operator", "d",
    "dot"
    """

    kind: str
    at: int
    node: Tree | None = None
    name: str = ""
    listing: Listing | None = None
    bounds: tuple[tuple[str, ...], Tree | None, Tree | None] | None = None
    variables: tuple[tuple[Tree, int], ...] = ()
    power: Tree | None = None
    postfix: str = ""
    letters: tuple[Name, ...] = ()
    partial: bool = False
    square: bool = False
    text: str = ""  # what is printed below, or as a mark


def read(latex: str | Sequence[str], notation: Notation) -> Tree:
    r"""Read a printed formula; nothing is evaluated.

    Parameters
    ----------
    latex
        The printed LaTeX; a sequence is one display continued over several blocks. Tags and the punctuation at the end
        are dropped.
    notation
        What the letters mean.

    Returns
    -------
    Tree
        The formula as printed.

    Raises
    ------
    SymcheckError
        If a letter is unknown, a bracket is not closed, or the form has two readings; the message names the place.

    See Also
    --------
    lower : From the tree to formulas.

    Examples
    --------
    >>> from symcheck.reading import Letter, Notation, to_latex
    >>> to_latex(read(r"\dfrac{a}{2}=b, \quad (1.2)", Notation([Letter("a"), Letter("b")])))
    '\\frac{a}{2} = b'
    """
    pieces = [latex] if isinstance(latex, str) else list(latex)
    source = r" \\ ".join(tex.split_tag(piece)[0] for piece in pieces)
    lexer = Lexer(source, notation)
    lexemes = lexer.lexemes()
    if not lexemes:
        raise SymcheckError(f"an empty formula: {latex!r}; give the printed LaTeX")
    return Builder(source, notation, lexer.spaced).statement(parse(source, lexemes))


@lru_cache(maxsize=512)
def dependence(letter: Letter, notation: Notation) -> tuple[Tree, ...]:
    """The letters a letter depends on, as printed in its declaration."""
    if not letter.depends:
        return ()
    own = notation.find(letter.depends, 0)
    if own is not None and own.kind == "scalar" and not own.depends:  # one letter, as mostly
        return (Name(letter.depends),)
    try:
        tree = read(letter.depends, notation)
    except SymcheckError as error:
        raise letter.fault(f"depends={letter.depends!r}: {error}") from None
    parts = tree.parts if isinstance(tree, System) else (tree,)
    found = tuple(part.function if isinstance(part, Call) and not part.arguments else part for part in parts)
    if not all(isinstance(part, Name) and not part.primes for part in found):
        raise letter.fault(f"depends={letter.depends!r} must be letters, separated by commas")
    return found  # type: ignore[return-value]


class Builder:
    """From the parser's tree to ours; one method per rule of the grammar."""

    def __init__(self, source: str, notation: Notation, spaced: Container[int] = ()) -> None:
        self.source = source
        self.notation = notation
        self.spaced = spaced  # places behind an explicit space
        self.first = len(source) - len(source.lstrip())

    def fail(self, at: int, message: str) -> SymcheckError:
        return tex.fault(self.source, at, message)

    def build(self, node: ParseNode) -> Any:
        """The result of one grammar rule."""
        return _RULES[node.data](self, node.children)

    def statement(self, node: ParseNode) -> Tree:
        tree = self.checked(self.statement_of(self.build(node.children[0])), 0)
        self.refuse_signs(tree)
        return tree

    def refuse_signs(self, tree: Tree) -> None:
        """Double signs of several relations may switch together or not; only where both hold it does not matter."""
        if r"\pm" not in self.source and r"\mp" not in self.source:
            return
        chains = [node for node in nodes(tree) if isinstance(node, Chain)]
        signed = [[_is_signed(member) for member in chain.members] for chain in chains]
        links = [pair for chain in signed for pair in itertools.pairwise(chain) if any(pair)]
        if sum(map(any, signed)) > 1 and not all(map(all, links)):
            raise self.fail(
                0, "do the double signs of these relations switch together? write a statement for each sign"
            )
        if any(sum(any(p) and not all(p) for p in itertools.pairwise(c)) > 1 for c in signed):
            raise self.fail(0, "do the double signs of this chain switch together? write a statement for each sign")

    # -- lists and statements ------------------------------------------------------------------------------------

    def on_listing(self, nodes: list[ParseNode]) -> Listing:
        entries: list[tuple[str, Tree]] = [self.build(node) for node in nodes[0::2]]
        for k, ((_, before), (label, tree)) in enumerate(itertools.pairwise(entries), 1):
            if isinstance(before, Forall) and isinstance(before.scope, Name) and _is_of_set(tree):
                entries[k] = (label, Forall(tree))  # of all the letters before it
        separators = [node.children[0] for node in nodes[1::2]]
        wide = [
            len(node.children) > 1 or node.children[0].value.value not in (",", COMMA_AT_END) for node in nodes[1::2]
        ]
        words = [str(separator.value.value) for separator in separators]
        beside = [node.children[0].value.value == WIDE_COMMA for node in nodes[1::2]]
        parted = [before and behind for before, behind in itertools.pairwise([True, *beside, True])]
        logical = [getattr(node.children[0], "data", "") in _LOOSE for node in nodes[0::2]]
        loose = any(each and not apart for each, apart in zip(logical, parted, strict=True))
        return Listing(entries, [separator.type for separator in separators], _place(nodes[0]), wide, words, loose)

    def on_entry(self, nodes: list[ParseNode]) -> tuple[str, Tree]:
        if getattr(nodes[0], "type", "") == "FORALL":
            return "", Forall(self.checked(self.build(nodes[1]), nodes[0].value.at))
        label = nodes.pop(0).value.value if not hasattr(nodes[0], "data") else ""
        tree = self.checked(self.build(nodes[0]), _place(nodes[0]))
        return label, Located(self.term_of(nodes[0]), self.build(nodes[2])) if len(nodes) > 1 else tree

    def statement_of(self, listing: Listing) -> Tree:
        """A whole statement: its qualifiers gathered, its cases told apart."""
        trees = [tree for _, tree in listing.entries]
        if isinstance(trees[0], Located) and any(isinstance(x, Chain) and r"\mapsto" in x.signs for x in trees[1:]):
            raise self.fail(listing.at, "a map of several letters? write brackets around them")
        if "FOR" in listing.separators:
            return self.conditional(listing)
        if any(label for label, _ in listing.entries):
            return self.cases(listing)
        return self.system(self.shared(listing), listing.at, loose=listing.loose)

    def conditional(self, listing: Listing) -> Tree:
        """Statements with the conditions behind them; each condition is one of all statements on its line before it."""
        lines: list[tuple[Listing, Listing | None]] = []
        start, middle = 0, 0  # of the statements, and of their conditions
        for k, separator in enumerate([*listing.separators, "NEWLINE"], 1):
            word = listing.words[k - 1] if k <= len(listing.words) else ""
            if separator == "FOR" and middle:
                raise self.fail(listing.at, "two conditions behind one another; write a line for each")
            if separator == "FOR":
                middle = k
            elif separator != "COMMA" or (middle and word not in (",", "and")):
                after = listing.entries[k][1] if k < len(listing.entries) else None
                if separator == "COMMA" and word == WIDE_COMMA and isinstance(after, Chain) and "=" not in after.signs:
                    raise self.fail(listing.at, "is what stands behind this condition another one, or a statement?")
                end = middle or k
                lines.append((_part(listing, start, end), _part(listing, middle, k) if middle else None))
                start, middle = k, 0
        parts: list[Tree] = []
        for claims, conditions in lines:
            parts += self.under(claims, conditions)
        return self.system(parts, listing.at)

    def under(self, claims: Listing, conditions: Listing | None) -> list[Tree]:
        """Statements under a condition; values of indices that stand behind them are none."""
        stated = self.shared(claims)
        if conditions is None:
            return stated
        holding = self.system(self.shared(conditions), conditions.at, loose=conditions.loose)
        if not isinstance(holding, STATEMENTS):
            raise self.fail(conditions.at, "a relation is expected behind this word, not an expression")
        parts = holding.parts if isinstance(holding, System) else (holding,)
        if not all(isinstance(part, Chain | Implies | Iff | And | Or | Exists) for part in parts) or not parts:
            return [*stated, holding]
        return [Implies(holding, self.system(stated, claims.at, loose=claims.loose))]

    def system(self, trees: list[Tree], at: int, *, loose: bool = False) -> Tree:
        """Statements, or expressions, side by side, with their qualifiers; `loose`: not all logic is in brackets."""
        parts, qualifiers = self.qualified(trees, at)
        self.refuse_idle(parts, qualifiers, at)
        if len(parts) == 1 and not qualifiers:
            return parts[0]
        if any(isinstance(part, STATEMENTS) for part in parts):
            problem = any(_is_words(part) and to_latex(part) == SUBJECT for part in parts)
            aside = (Limiting, Name) if problem else ()
            parts = [Words(part) if _is_words(part) or isinstance(part, (Dots, *aside)) else part for part in parts]
        stated = [isinstance(part, STATEMENTS) for part in parts]
        if not all(stated) and (any(stated) or qualifiers):
            raise self.fail(
                at,
                "an expression stands among relations and says nothing; if it shares a relation, write it out, "
                "if it is only named, leave it out",
            )
        if loose and len(parts) > 1 and any(isinstance(part, LOGIC) and not isinstance(part, And) for part in parts):
            raise self.fail(at, r"a comma beside a logical connective is ambiguous; write \land or brackets")
        return System(tuple(parts), tuple(qualifiers))

    def refuse_idle(self, parts: list[Tree], qualifiers: list[Qualifier], at: int) -> None:
        """A qualifier says something about an index that occurs, and says it once."""
        said = [index for qualifier in qualifiers for index in qualifier.indices]
        if twice := [index for index, count in Counter(said).items() if count > 1]:
            raise self.fail(at, f"the values of {twice[0]} are given twice")
        names = [node for part in parts for node in nodes(part) if isinstance(node, Name)]
        used = {index for name in names for index in (name.letter, *name.subscripts)}
        if parts and (idle := [index for index in said if index not in used]):
            raise self.fail(at, f"values are given for {idle[0]}, which does not occur")

    def shared(self, listing: Listing) -> list[Tree]:
        """The entries of a list, in which letters may share one relation: `a, b > 0`, `0 < a, b < 1`."""
        trees = [tree for _, tree in listing.entries]
        found: list[Tree] = []
        k = 0
        while k < len(trees):
            end = k + 1
            while end < len(trees) and self.is_listed(trees[end]) and not isinstance(trees[end - 1], STATEMENTS):
                end += 1
            first = trees[k]
            if isinstance(first, Chain) and self.is_listed(first.members[-1]):
                end = self.closing(listing, trees, k)
                if end > k + 1:
                    found += self.between(trees[k:end], listing.at)
                    k = end
                    continue
            last = trees[end] if end < len(trees) else None
            valued = end + 1 < len(trees) and isinstance(trees[end + 1], Number | Dots)
            valued |= k > 0 and isinstance(trees[k - 1], Dots)  # the end of `1, \\dots, s`
            if (
                isinstance(last, Chain)
                and last.signs[0] != r"\in"
                and any(map(_is_value, (*trees[k:end], last.members[0])))
            ):
                valued = True  # of equations, a value alone begins none
            if self.is_listed(first) and isinstance(last, Chain) and self.is_listed(last.members[0]) and not valued:
                found += self.having_all(trees[k:end], last, listing.at)
                k = end + 1
                continue
            found.append(first)
            k += 1
        return found

    def closing(self, listing: Listing, trees: list[Tree], k: int) -> int:
        """Where a run such as `0 < a, b, c < 1` ends that begins with entry k; k + 1 if there is none."""
        first, end = trees[k], k + 1
        while end < len(trees) and self.is_listed(trees[end]) and not listing.wide[end - 1]:
            end += 1
        last = trees[end] if end < len(trees) else None
        if not isinstance(first, Chain) or not isinstance(last, Chain) or listing.wide[end - 1]:
            return k + 1
        orders = {_ORDERS.get(sign) for sign in first.signs + last.signs}
        one_way = orders in ({"up"}, {"down"})
        inner = (first.members[-1], last.members[0])
        return end + 1 if one_way and self.is_listed(inner[1]) and inner[0] != inner[1] else k + 1

    def between(self, trees: list[Tree], at: int) -> list[Tree]:
        """The relations of `0 < a, b < 1`: each letter lies between both ends."""
        first, last = trees[0], trees[-1]
        assert isinstance(first, Chain)
        assert isinstance(last, Chain)
        if not isinstance(first.members[0], Number | Neg) or len(first.signs + last.signs) > 2:
            raise self.fail(
                at,
                "two relations, or letters that lie between the same ends? write \\quad behind the comma, or a "
                "relation for each letter",
            )
        letters = [first.members[-1], *trees[1:-1], last.members[0]]
        signs = (*first.signs, *last.signs)
        return [Chain((first.members[0], letter, last.members[-1]), signs) for letter in letters]

    def having_all(self, letters: list[Tree], last: Chain, at: int) -> list[Tree]:
        """The relations of `a, b > 0`: one for each letter."""
        if last.signs[0] == "=" and self.is_listed(last.members[1]):
            raise self.fail(
                at, "are the letters before the comma equal to this too, or only named? write a relation for each"
            )
        if last.signs[0] == r"\sim" and any(letter in nodes(last.members[1]) for letter in letters):
            raise self.fail(at, "are these distributed together? write brackets around them, or a relation for each")
        return [Chain((letter, *last.members[1:]), last.signs) for letter in (*letters, last.members[0])]

    def cases(self, listing: Listing) -> Tree:
        cases: list[tuple[str, list[Tree]]] = []
        for label, tree in listing.entries:
            if label:
                cases.append((label, []))
            elif not cases:
                raise self.fail(listing.at, "a statement stands before the first case")
            cases[-1][1].append(tree)
        built = []
        numbers = [label.rstrip(").") for label, _ in cases if label.endswith(".")]
        if numbers and numbers != [str(n) for n in range(1, len(cases) + 1)]:
            raise self.fail(listing.at, "the cases are not numbered 1, 2, 3, ...")
        for label, trees in cases:
            built.append((label, self.system(trees, listing.at)))
        return CaseList(tuple(built))

    def qualified(self, trees: list[Tree], at: int) -> tuple[list[Tree], list[Qualifier]]:
        """The statements and the qualifiers of a list: `i = 1, 2, 3` is one qualifier."""
        parts: list[Tree] = []
        qualifiers: list[Qualifier] = []
        k = 0
        while k < len(trees):
            several, size = self.several(trees[k:])
            found, size = self.qualifier(trees[k:], at) if not several else (None, size)
            if several:
                parts += several
            elif found is not None:
                qualifiers.append(found)
            elif isinstance(tree := trees[k], System) and not tree.parts:
                qualifiers.extend(tree.qualifiers)
            else:
                parts.append(tree)
            k += size
        return parts, qualifiers

    def qualifier(self, trees: list[Tree], at: int) -> tuple[Qualifier | None, int]:
        """A qualifier at the beginning of the list and the number of entries it takes."""
        names = 0
        while names < len(trees) and self.is_index(trees[names]):
            names += 1
        first = trees[names] if names < len(trees) else None
        if not isinstance(first, Chain) or first.signs != ("=",) or not self.is_index(first.members[0]):
            return None, 1
        values: list[Tree] = [first.members[1]]
        size = names + 1
        while size < len(trees) and isinstance(trees[size], Number | Dots):
            values.append(trees[size])
            size += 1
        letters = tuple(t.letter for t in [*trees[:names], first.members[0]] if isinstance(t, Name))
        alone = len(values) == 1 and any(self.notation.find(letter, 0) for letter in letters)
        if alone or not isinstance(values[0], Number):
            return None, 1
        return Qualifier(letters, self.values(values, at)), size

    def several(self, trees: list[Tree]) -> tuple[list[Tree], int]:
        r"""The values of letters that are not those of an index, `m = 1, 2, \dots` or `i, j = 1, \dots, n`.

        With them comes the number of entries that they take.
        """
        start = 0
        while start < len(trees) and isinstance(trees[start], Name):
            start += 1
        first, run = trees[start] if start < len(trees) else None, start + 1
        if not isinstance(first, Chain) or first.signs != ("=",) or not isinstance(first.members[0], Name):
            return [], 1
        while run < len(trees) and isinstance(trees[run], Number | Dots):
            run += 1
        run += isinstance(trees[run - 1], Dots) and run < len(trees) and not isinstance(trees[run], STATEMENTS)
        names = [tree for tree in (*trees[:start], first.members[0]) if isinstance(tree, Name)]
        values = (first.members[1], *trees[start + 1 : run])
        finite = all(isinstance(value, Number | Dots) for value in values) and not isinstance(values[-1], Dots)
        plain = all(type(part) in _PLAIN for value in values for part in nodes(value))
        if Dots() not in values or not plain or (finite and all(map(self.is_index, names))):
            return [], 1
        first_value = values[0].letter.partition("_") if isinstance(values[0], Name) else ("", "", "")
        if first_value[1] and any(name.letter == first_value[0] for name in names):
            raise self.fail(0, "the values of a letter, or its components? write brackets around these")
        return [Values(name, values) for name in names], run

    def is_listed(self, tree: Tree) -> bool:
        """A letter alone, or a value, which may share a relation with others: those of `a, b > 0`."""
        value = isinstance(tree, Call) and isinstance(tree.function, Name)
        name = tree.function if isinstance(tree, Call) and value else tree
        name = name.name if isinstance(name, Indexed) else name
        if isinstance(name, Name) and _SEVERAL.match(name.letter):
            return False
        index = isinstance(name, Name) and self.is_index(name) and self.notation.inferred
        return isinstance(name, Name) and (
            bool(name.subscripts) or self.notation.find(name.letter, 0) is not None or index
        )

    def is_index(self, tree: Tree) -> bool:
        return isinstance(tree, Name) and not tree.subscripts and self.notation.index(tree.letter) is not None

    def values(self, trees: list[Tree], at: int) -> tuple[int, ...]:
        """The values of a qualifier; dots stand for the integers between their neighbours."""
        values: list[int] = []
        for k, tree in enumerate(trees):
            if isinstance(tree, Number) and tree.text.isdigit():
                if k and isinstance(trees[k - 1], Dots):
                    values.extend(range(values[-1] + 1, int(tree.text)))
                values.append(int(tree.text))
            elif not (isinstance(tree, Dots) and values and k + 1 < len(trees)):
                raise self.fail(at, "the values of an index must be whole numbers")
        return tuple(values)

    # -- logic ---------------------------------------------------------------------------------------------------

    def on_exists(self, nodes: list[ParseNode]) -> Tree:
        if getattr(nodes[-1], "data", "") == "implies":
            at = nodes[0].value.at
            raise self.fail(at, r"does \exists hold for the premise alone or for the whole implication? write brackets")
        names = tuple(node.value.value for node in nodes[1:-1] if node.type == "NAME")
        return Exists(names, self.claim(nodes[-1]))

    def on_iff(self, nodes: list[ParseNode]) -> Tree:
        if "implies" in (nodes[0].data, nodes[2].data):
            raise self.fail(nodes[1].value.at, r"\Leftrightarrow beside \Rightarrow is ambiguous; write brackets")
        return Iff(self.claim(nodes[0]), self.claim(nodes[2]))

    def on_implies(self, nodes: list[ParseNode]) -> Tree:
        if nodes[2].data == "implies":
            raise self.fail(
                nodes[1].value.at,
                r"A \Rightarrow B \Rightarrow C is A \Rightarrow (B \Rightarrow C), or two; write brackets",
            )
        return Implies(self.claim(nodes[0]), self.claim(nodes[2]))

    def on_either(self, nodes: list[ParseNode]) -> Tree:
        return Or(tuple(self.claim(node) for node in nodes[0::2]))

    def on_both(self, nodes: list[ParseNode]) -> Tree:
        return And(tuple(self.claim(node) for node in nodes[0::2]))

    def claim(self, node: ParseNode) -> Tree:
        """Something true or false."""
        tree: Tree = self.build(node)
        if not isinstance(tree, STATEMENTS):
            raise self.fail(_place(node), "a relation is expected here, not an expression")
        return tree

    def on_chain(self, nodes: list[ParseNode]) -> Tree:
        members = [self.term_of(node) for node in nodes[0::2]]
        signs = tuple(node.value.value for node in nodes[1::2])
        for k, sign in enumerate(signs, 1):
            right = members[k]
            whole = not self.notation.bracket and sign == "=" and isinstance(members[0], Name)
            if whole and isinstance(right, Interval) and right.ends == "[]":
                members[k] = Tuple((right.low, right.high), "[]")  # no letter is equal to an interval of numbers
        plain = isinstance(members[0], Name) and not _is_styled(members[0])
        if self.notation.inferred and plain and signs == ("=",) and _is_range(members[1]):
            raise self.fail(_place(nodes[2]), r"all numbers from one to the other, or a list? write \in for the former")
        numbers = itertools.pairwise(isinstance(member, Number) for member in members)
        if any(sign == r"\sim" and all(pair) for sign, pair in zip(signs, numbers, strict=True)):
            raise self.fail(_place(nodes[0]), "numbers from one to the other? write between which a letter is")
        if len(signs) > 2 and isinstance(members[0], Name) and all(map(_is_value_and_name, members[1:-1])):
            raise self.fail(_place(nodes[0]), "do several equations stand in a row here? write commas between them")
        lists = any(isinstance(member, Tuple) for member in members[1:]) and not _is_of_capitals(members[0])
        brackets = any(map(_is_of_two_capitals, members)) and not all(
            isinstance(x, Name | Tuple | Call) for x in members
        )
        if self.notation.inferred and ((_is_bracket(members[0]) and not lists) or ("=" in signs and brackets)):
            raise self.fail(_place(nodes[0]), "the bracket of two operators, or a list? say what it means")
        inner = [k for k in range(1, len(signs) - 1) if signs[k] in _ARROWS]  # between relations
        if inner and (len(inner) > 1 or isinstance(members[inner[0] + 1], Number | Name | Infinity)):
            at, sign = nodes[2 * inner[0] + 1].value.at, signs[inner[0]]
            told = "does one follow from the other, or is it a limit? write"
            raise self.fail(at, rf"{sign} between relations: {told} \Rightarrow")
        if inner:
            end = inner[0] + 1
            return Implies(Chain(tuple(members[:end]), signs[: end - 1]), Chain(tuple(members[end:]), signs[end:]))
        return Chain(tuple(members), signs)

    def term_of(self, node: ParseNode) -> Tree:
        """An expression: neither a relation nor half a derivative."""
        tree: Tree = self.build(node)
        return self.checked(tree, _place(node), statements=False) if isinstance(tree, _NO_TERMS) else tree

    def checked(self, tree: Tree, at: int, *, statements: bool = True) -> Tree:
        if isinstance(tree, STATEMENTS) and not statements:
            raise self.fail(at, "an expression is expected here, not a relation")
        if isinstance(tree, Differential):
            if tree.partial or tree.order != 1 or len(tree.body) != 1:
                raise self.fail(at, "a differential outside of a derivative")
            if isinstance(tree.body[0], Pair | Tuple):
                raise self.fail(at, "a differential of what? name the function d otherwise, as \\rho(x, y)")
            return Total(tree.body[0]) if tree.bracketed else self.total(tree.body[0], at)
        return tree

    def total(self, tree: Tree, at: int) -> Tree:
        """The differential of a letter; `dx^2` is its square."""
        if isinstance(tree, Pow) and isinstance(tree.base, Name):
            return Pow(self.total(tree.base, at), tree.exponent)
        if isinstance(tree, Call) and isinstance(tree.function, Name):
            return Total(tree)
        if isinstance(tree, Mul) and tree.dotted[:1] == (1,):
            return Mul((self.total(tree.factors[0], at), *tree.factors[1:]), tree.dotted)
        if not isinstance(tree, Name):
            raise self.fail(at, "a differential of what? put it last, and what it is taken of in brackets")
        return Total(tree)

    # -- expressions ---------------------------------------------------------------------------------------------

    def on_sum(self, nodes: list[ParseNode]) -> Tree:
        negative = nodes[0].data == "term" if hasattr(nodes[0], "data") else True
        signs = ["PLUS"] if negative and hasattr(nodes[0], "data") else []
        signs += [node.value.value if node.type == "PM" else node.type for node in nodes if not hasattr(node, "data")]
        parts = [node for node in nodes if hasattr(node, "data")]
        if len(parts) == 1 and signs == ["PLUS"]:
            tree: Tree = self.build(parts[0])
            return tree
        terms = [self.term_of(part) for part in parts]
        for sign, term, part in zip(signs, terms, parts, strict=True):
            if sign in (r"\pm", r"\mp") and isinstance(term, Number) and "." in term.text:
                raise self.fail(_place(part), "both signs, or the error of a measured value? write it out")
        for term, part in zip(terms[:-1], parts, strict=False):
            last = term.factors[-1] if isinstance(term, Mul) else term
            limits = isinstance(last, Limiting) and last.operator not in ("sum", "prod")  # which end before a sign
            if (
                term is last
                and term is terms[0]
                and isinstance(last, Limiting)
                and limits
                and _is_below(last, terms[-1])
            ):
                rest = (_signed(sign, each) for sign, each in zip(signs[1:], terms[1:], strict=True))
                return replace(last, body=Add((last.body, *rest)))
            if isinstance(last, Limiting) and limits and self.is_open(part):
                raise self.fail(_place(part), f"does what follows belong to the {last.operator}? write brackets")
        forms = [isinstance(term.factors[-1] if isinstance(term, Mul) else term, Over) for term in terms]
        if any(forms) and any(
            isinstance(node, Total) for term in terms[forms.index(True) + 1 :] for node in walked(term)
        ):
            raise self.fail(_place(parts[forms.index(True)]), "where does this integral end? write brackets")
        signed = tuple(_signed(sign, term) for sign, term in zip(signs, terms, strict=True))
        return signed[0] if len(signed) == 1 else Add(signed)

    def is_open(self, part: ParseNode) -> bool:
        """Does a maximum, or its like, reach to the end of this term, where no brackets are all that is below it?"""
        if part.data != "term" or len(part.children) > 1:
            return True
        items = self.items(part.children[0])
        under = [k for k, item in enumerate(items) if item.kind == "under"]
        if not under:
            return False  # it stands in brackets itself
        behind = items[under[-1] + 1 :]
        return len(behind) != 1 or not self.in_brackets(behind[0]) or bool(behind[0].postfix)

    def on_term(self, nodes: list[ParseNode]) -> Tree:
        left = self.items(nodes[0])
        if len(nodes) == 1:
            return self.product(left)
        right = self.items(nodes[2])
        if nodes[1].type == "OPERATOR":
            return self.operated(nodes)
        if len(nodes) > 3:
            return self.crossed_twice([left, right, self.items(nodes[4])], nodes[3].value.at)
        if nodes[1].type == "TIMES":
            crossed = self.plain(right)
            if (summed := self.summed(left, crossed, Cross)) is not None:
                return summed
            if any(item.kind in ("sum", "integral", "over", "under") for item in left):
                raise self.fail(nodes[1].value.at, "a cross product behind a sum is ambiguous")
            return Cross(self.plain(left), crossed)
        at = nodes[1].value.at
        top, bottom = self.product(left), self.product(right)
        if isinstance(top, Differential) and isinstance(bottom, Differential):
            return self.derivative(top, bottom, at)
        self.refuse_quotient(top, bottom, at)
        below = self.notation.slash == "denominator" and all(item.kind == "atom" for item in right)
        whole = isinstance(bottom, Integral | Antiderivative)
        last = top.factors[-1] if isinstance(top, Mul) else top
        if isinstance(last, Integral | Antiderivative) and (whole or len(right) == 1 or below):
            return self.integrated_over(top, bottom)
        if len(right) > 1 and not isinstance(bottom, Call) and not below:
            raise self.fail(at, "a slash before several factors is ambiguous")
        bare = _ends_bare(left) and right[0].kind != "function"
        if any(item.kind in ("sum", "integral", "over", "under") for item in left + right) or bare:
            raise self.fail(at, "a slash behind a sum or a function without brackets is ambiguous")
        return Div(self.checked(top, at, statements=False), self.checked(bottom, at, statements=False))

    def integrated_over(self, top: Tree, bottom: Tree) -> Tree:
        """An integral before a slash, which reaches on to what is behind it if its variable stands there."""
        last = top.factors[-1] if isinstance(top, Mul) else top
        assert isinstance(last, Integral | Antiderivative)
        if isinstance(bottom, Integral | Antiderivative) or last.variable not in nodes(bottom):
            return Div(top, bottom)
        inner = replace(last, body=Div(last.body, bottom))
        return Mul((*top.factors[:-1], inner)) if isinstance(top, Mul) else inner

    def crossed_twice(self, several: list[list[Item]], at: int) -> Tree:
        """`a \\times a \\times b`, which has one reading that is not zero, and products with numbers."""
        if any(item.kind in ("sum", "integral", "over", "under") for items in several for item in items):
            raise self.fail(at, "a cross product behind a sum is ambiguous")
        first, second, third = map(self.plain, several)
        bare = first.factors[-1] if isinstance(first, Mul) else first
        if bare == second != third and self.is_vector(second):
            return Cross(first, Cross(second, third))
        if isinstance(first.factors[0] if isinstance(first, Mul) else first, Number):
            return Cross(Cross(first, second), third)
        raise self.fail(at, "which of these cross products comes first? write brackets")

    def summed(self, items: list[Item], last: Tree, made: Callable[[Tree, Tree], Tree]) -> Tree | None:
        """The sum of what is made of its last factors and of what is behind their sign, if its index stands there."""
        reaching = [k for k, item in enumerate(items) if item.kind in ("sum", "integral", "over", "under")]
        if len(reaching) != 1 or (k := reaching[0]) + 1 == len(items) or items[k].kind not in ("sum", "under"):
            return None
        sign = items[k]
        indices = sign.bounds[0] if sign.bounds else _INDICES.findall(sign.text) if sign.name in ("sum", "prod") else ()
        if not self.runs_over(indices, last):
            return None
        body = made(self.plain(items[k + 1 :]), last)
        if sign.bounds is None:
            found: Tree = Limiting(sign.name, sign.text, body)
        else:
            found = (BigProduct if sign.name else BigSum)(*sign.bounds, body)
        return self.plain([*items[:k], Item("fraction", sign.at, found)]) if k else found

    def runs_over(self, indices: Sequence[str], crossed: Tree) -> bool:
        """Does an index of a sum stand in what is behind the cross, too?"""
        names = [node for node in nodes(crossed) if isinstance(node, Name)]
        used = {index for name in names for index in (name.letter, *name.subscripts)}
        used |= {text for name in names for text in tex.texts(name.letter)}
        return bool(used.intersection(indices))

    def operated(self, nodes: list[ParseNode]) -> Tree:
        """Terms with signs between them of which nothing is said: from the left to the right."""
        several = [self.items(node) for node in nodes[0::2]]
        if len(several) == 2:
            operated = partial(Operated, str(nodes[1].value.value))
            if (summed := self.summed(several[0], self.plain(several[1]), operated)) is not None:
                return summed
        if any(item.kind in ("sum", "integral", "over", "under") for items in several for item in items):
            raise self.fail(nodes[1].value.at, f"{nodes[1].value.value} behind a sum is ambiguous")
        found = self.plain(several[0])
        for sign, items in zip(nodes[1::2], several[1:], strict=True):
            found = Operated(str(sign.value.value), found, self.plain(items))
        return found

    def refuse_quotient(self, top: Tree, bottom: Tree, at: int) -> None:
        """Where d is a letter, d f / d x is no quotient without a word."""
        firsts = [tree.factors[0] if isinstance(tree, Mul) else tree for tree in (top, bottom)]
        firsts = [tree.base if isinstance(tree, Pow) else tree for tree in firsts]
        if isinstance(bottom, Mul) and all(isinstance(tree, Name) and _D.fullmatch(tree.letter) for tree in firsts):
            raise self.fail(
                at, "a derivative, or a quotient by the letter d? write the d elsewhere, or name the letter D"
            )

    def items(self, node: ParseNode) -> list[Item]:
        return [self.build(n) if hasattr(n, "data") else Item("dot", n.value.at) for n in node.children]

    def plain(self, items: list[Item]) -> Tree:
        return self.checked(self.product(items), items[0].at, statements=False)

    def product(self, items: list[Item]) -> Tree:
        """Implicit products: functions, sums and derivatives take their arguments from the left to the right."""
        if items[0].kind == "d":
            if items[0].postfix:
                raise self.fail(items[0].at, "a differential must be followed by its letter")
            return self.differential(items)
        if len(items) == 1 and items[0].kind in ("group", "atom") and not items[0].postfix:
            return self.alone(items[0])
        first = self.inside(items[0]) if items[0].kind == "group" and not items[0].postfix else None
        if isinstance(first, Number) and items[1].kind in ("atom", "function"):
            raise self.fail(items[0].at, "the number of an equation, or a factor? leave out its brackets")
        factors: list[Tree] = []
        dots: list[int] = []
        k = 0
        dotted = True
        while k < len(items):
            item = items[k]
            if item.kind == "dot":
                if dotted or k + 1 == len(items):
                    raise self.fail(item.at, r"\cdot must stand between two factors")
                dotted, k = True, k + 1
                dots.append(len(factors))
                continue
            self.refuse_numbers(items[k : k + 2])
            node, after = self.operating(items, k) or self.factor(items, k, dotted=dotted)
            factors.append(self.checked(node, item.at, statements=False))
            self.refuse_product(item, factors[-1], items[after:], alone=after == k + 1)
            before, behind = items[max(k - 1, 0) : k], items[k + 1 : k + 2]
            self.refuse_words(factors[-1], item, before, behind)
            k = after
            dotted = False
        if len(factors) > 1 and any(isinstance(factor, Infinity) for factor in factors):
            raise self.fail(items[0].at, "infinity is no factor; write a comma before what follows, or brackets")
        vectors = {k for k in dots if self.is_vector(factors[k - 1]) and self.is_vector(factors[k])}
        vectors |= {k for k in dots if k - 1 not in vectors and self.contracts(factors[k - 1], factors[k])}
        return factors[0] if len(factors) == 1 else Mul(tuple(factors), tuple(sorted(vectors)))

    def operating(self, items: list[Item], k: int) -> tuple[Tree, int] | None:
        """A sum of operators in brackets applied to all that is behind it, one factor: `(d/dt + a) x(t)`."""
        item = items[k]
        if item.kind != "group" or item.postfix or k + 1 == len(items) or items[k + 1].kind == "dot":
            return None
        operator = self.inside(item)
        if operator is None or not _operates(operator):
            return None
        behind = self.operating(items, k + 1)
        if behind is None:
            node, end = self.factor(items, k + 1, dotted=False)
            behind = self.checked(node, items[k + 1].at, statements=False), end
        if behind[1] < len(items) or isinstance(behind[0], Tuple):
            raise self.fail(item.at, "what this operator applies to is ambiguous; put it in brackets")
        return _operated(operator, behind[0]), behind[1]

    def refuse_numbers(self, items: list[Item]) -> None:
        """`Re` without a sign between its letters is hardly R times Euler's number; so with other such numbers."""
        names = [item.node for item in items if isinstance(item.node, Name) and item.kind == "atom"]
        if len(names) < 2 or names[0].subscripts or names[0].primes or items[0].postfix:
            return
        word = names[0].letter + names[1].letter.partition("_")[0]
        told = self.notation.find(names[0].letter, 0)
        if word != "Re" and (names[1].subscripts or (told is not None and told.meaning)):
            return
        power = items[1].power.value if isinstance(items[1].power, Neg) else items[1].power
        if word not in DIMENSIONLESS or (word != "Re" and not isinstance(power, Number | None)):
            return
        toks = tex.texts(NO_FACTORS.sub("", tex.spaced(self.source)))
        pairs = sum(pair == (word[0], word[1]) for pair in itertools.pairwise(toks))
        alone = toks.count(word[0]) == toks.count(word[1]) == pairs
        clear = word not in PRODUCTS or items[0].at == self.first or "." in toks or "." in "".join(toks)
        if word == "Re" or (alone and clear):
            raise self.fail(
                items[0].at,
                f"the {DIMENSIONLESS[word]} number, or {word[0]} times {word[1]}? write \\cdot, or name one letter",
            )

    def refuse_words(self, factor: Tree, item: Item, before: list[Item], behind: list[Item]) -> None:
        """Words are no factor beside others, but a remark, a part of a name, or a function without brackets."""
        if not isinstance(factor, Name) or not factor.letter.startswith(r"\text{"):
            return
        beside = [other for other in (*before, *behind) if other.kind != "dot"]
        if beside and not factor.letter.removeprefix(r"\text{")[:1].isalnum():
            raise self.fail(item.at, "punctuation or brackets in text are no factor; name what is printed with them")
        function = _WORD.fullmatch(factor.letter) and any(self.simple(other) for other in behind)
        if beside and factor.letter == r"\text{T}" and _TRANSPOSED.search(self.source):
            raise self.fail(item.at, "the sign that transposes elsewhere, or a factor? write ^ before it")
        remark = _REMARK.match(factor.letter) or factor.letter.endswith(":}")
        if (beside and remark) or function or ("=" in factor.letter and behind):
            raise self.fail(item.at, "words among factors; leave them out, or write a comma before them, or brackets")

    def refuse_product(self, item: Item, node: Tree, rest: list[Item], *, alone: bool) -> None:
        """What stands behind a factor without a sign must be a factor without a doubt."""
        after = rest[0] if rest else None
        if after is None or after.kind == "dot":
            return
        if after.square and isinstance(node, Name) and node.letter.startswith(("E_", r"\text{E}_")):
            raise self.fail(after.at, "the expectation of what is in these brackets, or times it? write \\cdot")
        if after.kind == "group" and isinstance(node, Indexed) and _is_styled(self.inside(after)):
            raise self.fail(after.at, AT_OR_TIMES)
        length = isinstance(node, Norm | Bars) and alone and isinstance(node.value, Name)
        if length and after.kind == "group" and not after.square and isinstance(self.inside(after), Name):
            raise self.fail(after.at, AT_OR_TIMES)
        beside = isinstance(after.node, Norm | Bars) or self.in_brackets(after)
        if isinstance(node, Name) and _VERB.match(node.letter) and beside:
            raise self.fail(after.at, f"{to_latex(node)} of what follows, or times it? write \\cdot, or brackets")
        if after.square and self.source[after.at + 1 :].lstrip()[:1] == "+":
            raise self.fail(after.at, "a term that may be left out, or a factor? write no sign before it")
        if _is_operated(node) and self.in_brackets(after):
            raise self.fail(after.at, "of what the operator makes, or times it? write \\cdot, or brackets around both")
        applied = isinstance(node, Call) and isinstance(node.function, Name) and bool(node.arguments)
        if applied and after.kind == "group" and not after.postfix and _is_place(self.inside(after)):
            raise self.fail(after.at, AT_OR_TIMES)  # J(f)(x)
        if not alone:
            return
        decimal = isinstance(node, Number) and "." in node.text and item.kind == "atom"
        if decimal and after.kind == "group" and not after.postfix and isinstance(self.inside(after), Number):
            raise self.fail(after.at, "the error of the last digits, or a factor? write \\pm, or \\cdot")
        self.refuse_derivation(item, node, after.node)
        if item.square and isinstance(node, Pow) and isinstance(node.base, Name) and not item.postfix:
            raise self.fail(item.at, "the coefficient of this power, or idle brackets? leave them out")
        fraction = children(after.node) if isinstance(after.node, Div) and not after.postfix else ()
        if fraction and all(isinstance(each, Number) for each in (node, *fraction)):
            raise self.fail(after.at, r"a mixed number, or a product? write \cdot, or one fraction")
        name = node.base if isinstance(node, Pow) else node
        if isinstance(name, Call) and isinstance(name.function, Name) and not name.arguments:
            name = name.function
        bracketed = self.in_brackets(after) or isinstance(after.node, Tuple)
        bold = isinstance(name, Name) and name.letter == r"\mathbf{E}" and not _is_styled(after.node)
        expected = isinstance(name, Name) and name.letter.startswith(r"\mathbb{E}")
        if (expected or (bold and isinstance(after.node, Name))) and not bracketed:
            raise self.fail(after.at, "does what follows belong to the expectation? write brackets")
        if (
            isinstance(name, Name)
            and name.letter == "E"
            and not after.square
            and bracketed
            and _MEAN.search(self.source)
        ):
            raise self.fail(after.at, "the expectation of what is in these brackets, or times it? write square ones")
        if isinstance(name, Name) and name.letter in (r"\Delta", r"\delta") and after.kind == "function":
            raise self.fail(item.at, "the change of what follows, or times it? write \\cdot, or brackets")
        if isinstance(name, Name) and _OPERATOR.match(name.letter) and _STATE.match(to_latex(after.node or Blank())):
            raise self.fail(item.at, f"{to_latex(name)} applied to what follows, or times it? say what it is")
        if after.square and isinstance(name, Name) and self.counts(name, after.node):
            raise self.fail(after.at, f"{to_latex(name)} at the place in these brackets, or times it? write \\cdot")
        inverse = after.node.base if isinstance(after.node, Pow) and after.postfix == "TRANSPOSE" else None
        if isinstance(name, Name) and _is_letter(inverse) and self.source[after.at] == "(":  # J(q)^{-T}
            raise self.fail(after.at, AT_OR_TIMES)
        if not self.in_brackets(after):
            return
        if isinstance(node, Marked) and isinstance(self.inside(after), Name) and not after.postfix:
            raise self.fail(after.at, AT_OR_TIMES)
        if isinstance(node, Derivative) and _is_step(node, self.inside(after)):
            return
        if isinstance(node, Derivative) or (item.kind == "group" and self.has_function(node)):
            raise self.fail(
                after.at, "at the place in these brackets, or times it? write \\cdot, or the function with its place"
            )
        if not isinstance(name, Name):
            if _is_letter(self.inside(after)) and not after.postfix and any(isinstance(x, Name) for x in nodes(node)):
                raise self.fail(after.at, AT_OR_TIMES)
            return
        letter = self.notation.find(name.letter, len(name.subscripts))
        shown, inside = to_latex(name), self.inside(after)
        if letter is not None and self.notation.inferred and _is_factor(name, letter, inside):
            return
        if isinstance(node, Pow) and node.exponent == Neg(Number("1")) and not isinstance(inside, Add | Neg):
            raise self.fail(
                after.at, f"the inverse function of {shown}, or its reciprocal? write a fraction for that one"
            )
        if (
            letter is not None
            and letter.number == "pi"
            and isinstance(inside, Mul | Call)
            and not rest[1:]
            and not after.postfix
        ):
            raise self.fail(after.at, f"{shown} of what is in these brackets, or times it? leave out the brackets")
        if after.square and name in nodes(inside or Blank()):  # nothing is a function of itself
            return
        told = letter is not None and letter.meaning and not letter.applies  # of which a person says what it is
        if after.square and isinstance(inside, _BRACKETS_ARE_IDLE) and not after.postfix and not told:
            raise self.fail(after.at, f"{shown} of what is in these brackets, or times it? write \\cdot")
        if isinstance(inside, Tuple) and letter is not None and letter.whole:
            raise self.fail(after.at, f"{shown} before several arguments; declare it with kind='function'")
        if letter is not None and letter.applies:
            raise self.fail(
                after.at,
                f"{shown} of what is in these brackets, or times it? declare {letter.latex} with kind='function', or "
                r"write \cdot",
            )
        if isinstance(inside, Call) and isinstance(inside.function, str) and inside.function in ("div", "curl"):
            return  # their operator needs brackets behind a factor
        constant = letter is not None and (letter.depends == "" or letter.number)
        # a sum and a power of a product need their brackets, so that they are no sign of a function
        if isinstance(inside, Pair) and all(map(self.is_vector, children(inside))):
            return
        if isinstance(inside, Tuple) and inside.kind == "()":
            inside = inside.items[0]
        idle = (Name, Number, Call) if after.postfix else _BRACKETS_ARE_IDLE
        value = isinstance(inside, Number) and not after.postfix  # a product with a number has it in front
        if (not constant or value) and isinstance(inside, idle):
            raise self.fail(
                after.at,
                f"{shown} of what is in these brackets, or times it? declare {name.letter} with kind='function', or "
                "with depends='' if it is constant, or leave out the brackets",
            )

    def refuse_derivation(self, item: Item, node: Tree, behind: Tree | None) -> None:
        """A D before a function is a derivative, unless other capitals are matrices before values."""
        derives = isinstance(node, Name) and self.notation.inferred and node.letter in _DERIVATIONS
        if not derives or not isinstance(behind, Name) or _is_words(behind) or self.kind(behind) != "function":
            return
        if not _MATRIX_OF.search(self.source):
            raise self.fail(item.at, f"the derivative of {to_latex(behind)}, or times it? write \\cdot")

    def is_value(self, items: list[Item], k: int) -> bool:
        """Is what stands from here on a function letter with its arguments, and nothing else?"""
        if len(items) != k + 2 or items[k].kind != "atom" or items[k + 1].kind != "group":
            return False
        return isinstance(self.applied(items, k)[0], Call)

    def has_function(self, tree: Tree) -> bool:
        """Does a function stand here without its arguments?"""
        calls = [node for node in nodes(tree) if isinstance(node, Call) and not node.arguments]
        return any(isinstance(call.function, Name) and self.kind(call.function) == "function" for call in calls)

    def is_vector(self, tree: Tree) -> bool:
        for node in nodes(tree):
            if isinstance(node, Tuple | Name) and self.kind(node) == "vector":
                return True
            letter = self.notation.find(node.letter, len(node.subscripts)) if isinstance(node, Name) else None
            if letter is not None and len(letter.size) == 1:
                return True
        return False

    def contracts(self, left: Tree, right: Tree) -> bool:
        """Does a dot between these contract a vector with a matrix? With a hat the vector may stand for a matrix."""
        left, right = (
            part.function if isinstance(part, Call) and not isinstance(part.function, str) else part
            for part in (left, right)
        )
        if not (isinstance(left, Name) and isinstance(right, Name)) or r"\hat" in left.letter:
            return False
        return (self.kind(left), self.kind(right)) == ("vector", "matrix")

    def in_brackets(self, item: Item) -> bool:
        return item.kind == "group" or item.square

    def inside(self, item: Item) -> Tree | None:
        """What stands in round or square brackets."""
        return item.node if item.square else self.bracketed(item.listing, "()")

    def factor(self, items: list[Item], k: int, *, dotted: bool) -> tuple[Tree, int]:
        item = items[k]
        if item.kind == "function":
            return self.call(items, k)
        if item.kind == "sum":
            if k + 1 == len(items) or items[k + 1].kind == "dot" or item.bounds is None:
                raise self.fail(item.at, "a sum of nothing")
            made, body = BigProduct if item.name else BigSum, self.plain(items[k + 1 :])
            self.refuse_units(item.bounds[0], body, item.at)
            return made(*item.bounds, body), len(items)
        if item.kind == "under":
            if k + 1 == len(items) or items[k + 1].kind == "dot":
                raise self.fail(item.at, f"{item.name} of nothing")
            body = self.plain(items[k + 1 :])
            self.refuse_units(_INDICES.findall(item.text), body, item.at)
            return Limiting(item.name, item.text, body), len(items)
        if item.kind in ("integral", "antiderivative", "over"):
            return self.integral(items, k), len(items)
        if item.kind == "operator":
            if k + 1 == len(items):
                return Derivative(Blank(), item.variables, item.partial), k + 1
            alone = k + 2 == len(items) and items[k + 1].kind in ("group", "atom", "fraction")
            if not alone and k + 1 < len(items) and items[k + 1].kind == "function":
                alone = self.call(items, k + 1)[1] == len(items)
            alone = alone or (k + 1 < len(items) and items[k + 1].kind in REACHING)
            alone = alone or self.is_value(items, k + 1)
            if not alone:
                raise self.fail(item.at, "what this operator applies to is ambiguous; put it in brackets")
            body, variables, partial = self.plain(items[k + 1 :]), item.variables, item.partial
            if isinstance(body, Tuple):
                raise self.fail(items[k + 1].at, "a list, or a product in these brackets? say what they mean")
            return Derivative(body, variables, partial), len(items)
        if item.kind == "d fraction":
            assert isinstance(item.node, Div)
            return Div(self.total(item.letters[0], item.at), item.node.bottom), k + 1
        if item.kind == "d":
            if item.partial or item.power is not None or k + 1 == len(items):
                raise self.fail(item.at, "a differential outside of a derivative")
            after = items[k + 1]
            bracketed = after.kind == "group" and not after.postfix
            if bracketed:
                return Total(self.atom(after)), k + 2
            value, end = self.applied(items, k + 1)
            return self.total(value, item.at), end
        if isinstance(item.node, Number) and not dotted and not self.ends_clearly(items[k - 1]):
            raise self.fail(item.at, "a number behind a factor is ambiguous")
        if isinstance(item.node, Name):
            return self.applied(items, k)
        return self.alone(item), k + 1

    def refuse_units(self, indices: Sequence[str], body: Tree, at: int) -> None:
        """In an exponent, an index below another letter is hardly a factor too, but the imaginary unit."""
        for unit in {"i", "j"}.intersection(indices):
            exponents = [node.exponent for node in nodes(body) if isinstance(node, Pow) and _is_e(node.base)]
            for names in ([x for x in nodes(each) if isinstance(x, Name)] for each in exponents):
                below = any(unit in x.subscripts or unit in tex.texts(x.letter.partition("_")[2]) for x in names)
                if below and Name(unit) in names:
                    raise self.fail(at, f"is {unit} the index, or the imaginary unit? give one of them another letter")

    def ends_clearly(self, item: Item) -> bool:
        """Does this factor end in a bracket, a factorial or a fraction with letters, behind which a number is one?"""
        if item.postfix and item.postfix != "CARET":
            return False
        lettered = any(isinstance(node, Name) for node in walked(item.node)) if item.node is not None else True
        return (
            (item.kind in ("group", "fraction") and lettered) or item.square or isinstance(item.node, MatrixOf | Dots)
        )

    def integral(self, items: list[Item], k: int) -> Tree:
        r"""`\int_a^b f \, dx`; nothing may stand behind the differential."""
        sign, depth, end = items[k], 1, k + 1
        if inner := self.above(items[k + 1 :]):
            return self.integrated(sign, *inner)
        while end < len(items) and depth:
            depth += {"integral": 1, "antiderivative": 1, "over": 1, "d": -1, "d fraction": -1}.get(items[end].kind, 0)
            end += 1
        if not depth and items[end - 1].kind == "d fraction":
            fraction = items[end - 1]
            if end < len(items):
                raise self.fail(items[end].at, "does this belong to the integral? put the integral in brackets")
            assert fraction.node is not None
            return self.integrated(
                sign, [*items[k + 1 : end - 1], Item("fraction", fraction.at, fraction.node)], fraction.letters[0]
            )
        if not depth and end < len(items) and items[end - 2].kind == "dot" and _is_styled(items[end].node):
            items, end = [*items[: end - 2], *items[end - 1 :]], end - 1  # `F \\cdot ds` along a curve
        if depth or end >= len(items) or items[end].kind != "atom" or items[end].postfix or items[end - 1].power:
            raise self.fail(sign.at, "this integral does not say what it is taken over")
        if items[end - 1].partial:
            raise self.fail(items[end - 1].at, "an integral is taken over dx, not over a partial differential")
        variable, rest = self.atom(items[end]), items[end + 1 :]
        if rest and end == k + 2 and variable in nodes(behind := self.plain(rest)):  # the differential comes first
            return self.integrated(sign, [Item("fraction", rest[0].at, behind)], variable)
        if rest:
            raise self.fail(rest[0].at, "does this belong to the integral? put the integral in brackets")
        return self.integrated(sign, items[k + 1 : end - 1], variable)

    def above(self, items: list[Item]) -> tuple[list[Item], Tree] | None:
        r"""The factors of `f \frac{g \, dx}{h}` without the differential in the numerator, and its letter."""
        tops = [item.node.top if isinstance(item.node, Div) and not item.postfix else None for item in items]
        found = [
            (n, m)
            for n, top in enumerate(tops)
            if isinstance(top, Mul)
            for m, each in enumerate(top.factors)
            if isinstance(each, Total) and isinstance(each.value, Name)
        ]
        bare = any(item.kind in ("d", "d fraction", "integral", "antiderivative", "over") for item in items)
        if len(found) != 1 or bare:
            return None
        ((n, m),) = found
        top, fraction = tops[n], items[n].node
        assert isinstance(top, Mul)
        assert isinstance(fraction, Div)
        rest = (*top.factors[:m], *top.factors[m + 1 :])
        left = rest[0] if len(rest) == 1 else Mul(rest)
        body = [*items[:n], replace(items[n], node=Div(left, fraction.bottom)), *items[n + 1 :]]
        return body, next(each.value for each in top.factors if isinstance(each, Total))

    def integrated(self, sign: Item, body: list[Item], variable: Tree) -> Tree:
        """The integral of a product over a letter, with bounds or without."""
        if not body and sign.kind == "integral":
            raise self.fail(sign.at, "an integral of nothing")
        integrand = self.plain(body) if body else Number("1")
        if sign.kind == "over":
            return Over(sign.name, sign.text, integrand, variable)
        if sign.kind == "antiderivative":
            return Antiderivative(integrand, variable)
        assert sign.bounds is not None
        _, low, high = sign.bounds
        assert low is not None
        assert high is not None
        return Integral(integrand, variable, low, high)

    def kind(self, name: Name | Tuple) -> str:
        if isinstance(name, Tuple):
            return "vector"
        letter = self.notation.find(name.letter, len(name.subscripts))
        return letter.kind if letter else "index"

    def applies(self, name: Name) -> bool:
        """Can this letter stand before arguments?"""
        letter = self.notation.find(name.letter, len(name.subscripts))
        return letter is not None and letter.applies

    def applied(self, items: list[Item], k: int) -> tuple[Tree, int]:
        """A function letter with its arguments in brackets, or alone; any other factor as it is."""
        item, after = items[k], items[k + 1] if k + 1 < len(items) else None
        name = item.node
        if isinstance(name, Name) and after is not None and after.kind == "given" and not item.postfix:
            assert after.node is not None
            return self.postfixed(Call(name, (after.node,)), after), k + 2
        apart = after is None or item.postfix or item.square
        if isinstance(name, Name) and after is not None and not apart and (places := self.places(name, after)):
            return self.postfixed(Indexed(name, places), after), k + 2
        apart = item.postfix not in ("", "CARET", "TRANSPOSE")
        if not isinstance(name, Name) or after is None or after.kind != "group" or apart:
            return self.atom(item), k + 1
        if not self.applies(name):
            return self.atom(item), k + 1
        arguments = self.arguments(after.listing, event=name.letter in _OF_EVENTS)
        if self.kind(name) != "function" and not self.is_declared(name, arguments):
            return self.atom(item), k + 1  # refused as a product
        call = Call(name, arguments)
        if item.postfix == "TRANSPOSE":  # J^T(q), as J(q)^T
            return self.postfixed(Transpose(call), after), k + 2
        if item.power is None:
            return self.postfixed(call, after), k + 2
        letter = self.notation.find(name.letter, len(name.subscripts))
        matrix = letter is not None and len(letter.size) == 2 and item.power == Neg(Number("1"))  # its inverse
        if after.postfix or (isinstance(item.power, Neg) and not matrix):
            shown = to_latex(name)
            if after.postfix:
                raise self.fail(
                    item.at, f"two powers of {shown}; write one behind brackets around {shown} and its argument"
                )
            raise self.fail(
                item.at,
                f"the inverse function of {shown}, or its reciprocal? write \\frac{{1}}{{{shown}(...)}} for that one",
            )
        return Pow(call, item.power), k + 2

    def places(self, name: Name, after: Item) -> tuple[Tree, ...]:
        """What stands in square brackets behind a letter as a place: `x[n]`, `x[n + 1]`, `f[x, y]`; else nothing."""
        letter, inside = self.notation.find(name.letter, len(name.subscripts)), after.node
        told = letter is not None and letter.meaning and not letter.applies
        if not after.square or inside is None or told or self.notation.bracket or self.kind(name) == "index":
            return ()
        if isinstance(inside, Interval | Tuple):
            known = any(isinstance(node, Call) and isinstance(node.function, str) for node in nodes(inside))
            return () if known else children(inside)  # a row of sines and cosines is no place
        if is_expectation(name.letter) and not (name.letter == "E" and _BARE_E.search(self.source)):
            return (inside,)
        counted = isinstance(inside, Add) and all(
            isinstance(part.value if isinstance(part, Neg) else part, Name | Number) for part in inside.terms
        )
        letters = [node.letter for node in nodes(inside) if isinstance(node, Name)]
        counts = counted and (
            self.is_sequence(name) or any(letter in COUNTERS or self.is_place(letter) for letter in letters)
        )
        counts = counts or (self.counts(name, inside) and any(map(self.is_place, letters)))
        upright = name.letter.startswith(r"\text{")
        return (inside,) if counts or upright or isinstance(inside, Name | Number | Call) else ()

    def counts(self, name: Name, inside: Tree | None) -> bool:
        """Is this a sum of letters that count, and of their products: the place of an entry, as in `w^2[n - t h]`?

        Or of the product of one that counts: `x[n M + m]`.
        """
        letter = self.notation.find(name.letter, len(name.subscripts))
        if not isinstance(inside, Add) or (letter is not None and letter.number):
            return False
        plain = all(type(part) in _PLAIN for part in nodes(inside))
        terms = [part for term in inside.terms for part in (term.factors if isinstance(term, Mul) else (term,))]
        return plain and any(term.letter in COUNTERS for term in terms if isinstance(term, Name))

    def is_sequence(self, name: Name) -> bool:
        """Does this letter stand before one letter or number in square brackets anywhere: `x[t]`?"""
        return re.search(rf"{re.escape(name.letter[-1])} ?\}}? ?\[ ?[A-Za-z0-9] ?\]", self.source) is not None

    def is_place(self, letter: str) -> bool:
        """Does this letter stand alone in square brackets behind any letter: the `t` of `x[t]`?"""
        return re.search(rf"[A-Za-z}}] ?\[ ?{re.escape(letter)} ?\]", self.source) is not None

    def is_declared(self, name: Name, arguments: tuple[Tree, ...]) -> bool:
        """Are these the very letters that the letter is declared to depend on?"""
        letter = self.notation.letter(name.letter, len(name.subscripts))
        bare = tuple(a.function if isinstance(a, Call) and not a.arguments else a for a in arguments)
        return bare == dependence(letter, self.notation)

    def call(self, items: list[Item], k: int) -> tuple[Tree, int]:
        r"""`\sin` with its argument: brackets, one fraction or root, or the simple factors that follow."""
        head = items[k]
        k += 1
        field = items[k].node if k < len(items) else None
        second = head.name == "laplacian" and isinstance(field, Name) and not _is_styled(field)
        if second and self.notation.inferred and _OF_MATRICES.search(self.source):
            raise self.fail(head.at, "the sum of second derivatives, or their matrix? write \\Delta for the sum")
        if head.name in BRACKETED and (k == len(items) or items[k].kind != "group"):
            raise self.fail(head.at, f"the argument of {head.name} must stand in brackets")
        if k < len(items) and items[k].kind == "given" and head.power is None:
            given = items[k].node
            assert given is not None
            return self.postfixed(Call(head.name, (given,)), items[k]), k + 1
        if k < len(items) and items[k].kind == "group":
            if head.name == "vec" and items[k].postfix == "TRANSPOSE":  # of the column: that of a matrix stands inside
                return self.postfixed(Call("vec", self.entries(items[k].listing)), items[k]), k + 1
            if items[k].postfix:
                raise self.fail(items[k].at, f"does this power belong to {head.name} or to its argument?")
            return self.powered(head, self.entries(items[k].listing)), k + 1
        if k < len(items) and items[k].square and not items[k].postfix and items[k].node is not None:
            inside = items[k].node
            if not isinstance(inside, Interval | Tuple | None):
                return self.powered(head, (inside,)), k + 1
        if k < len(items) and items[k].kind == "function":  # of a value of another, whose argument stands in brackets
            bracketed = k + 1 < len(items) and (items[k + 1].kind == "group" or items[k + 1].square)
            value, after = self.call(items, k)
            if not bracketed or (after < len(items) and (self.simple(items[after]) or self.in_brackets(items[after]))):
                raise self.fail(items[k].at, f"where does the argument of {head.name} end? write brackets around it")
            return self.powered(head, (value,)), after
        if (
            k < len(items)
            and isinstance(listed := items[k].node, Tuple)
            and listed.kind == "{}"
            and not items[k].postfix
            and (len(listed.items) == 1 or head.name in ("min", "max"))
        ):
            return self.powered(head, listed.items), k + 1
        if k < len(items) and items[k].kind == "fraction" and not items[k].postfix:
            argument: Tree = self.atom(items[k])
            k += 1
            summed = head.name in LOGARITHMS and k < len(items) and items[k].kind in REACHING
            if summed or (k < len(items) and self.simple(items[k])):
                raise self.fail(items[k].at, f"does this factor belong to the argument of {head.name}?")
            if k < len(items) and items[k].kind == "group" and not any(map(self.varies, nodes(argument))):
                if head.name not in ANGULAR or items[k].postfix or not _has_no_letters(argument):
                    raise self.fail(items[k].at, f"does this factor belong to the argument of {head.name}?")
                argument, k = Mul((argument, self.atom(items[k]))), k + 1  # nobody prints the cosine of 1/2
            return self.powered(head, (argument,)), k
        if k < len(items) and isinstance(items[k].node, Bars | Norm | MatrixOf) and not items[k].postfix:
            if k + 1 < len(items) and (self.simple(items[k + 1]) or self.in_brackets(items[k + 1])):
                raise self.fail(items[k + 1].at, f"does this factor belong to the argument of {head.name}?")
            return self.powered(head, (self.atom(items[k]),)), k + 1
        field_ = head.name.partition("_")[0] in FIELDS
        if field_ and k < len(items) and items[k].kind == "function" and items[k].name.partition("_")[0] in FIELDS:
            value, k = self.call(items, k)
            return self.powered(head, (value,)), k
        if field_ and k < len(items) and isinstance(items[k].node, Name):
            if items[k].postfix:
                raise self.fail(items[k].at, f"does this power belong to {head.name} or to its argument?")
            field, k = self.applied(items, k)
            if k < len(items) and items[k].kind != "dot":
                raise self.fail(items[k].at, f"does this factor belong to the argument of {head.name}?")
            return self.powered(head, (field,)), k
        if head.name in OF_MATRICES and k < len(items) and self.is_matrix(items[k]):
            beside = items[k + 1] if k + 1 < len(items) else None
            if items[k].postfix not in ("", "TRANSPOSE") or (
                beside is not None and (beside.kind == "group" or self.is_matrix(beside))
            ):
                raise self.fail(items[k].at, f"does what follows belong to the argument of {head.name}? write brackets")
            return self.powered(head, (self.atom(items[k]),)), k + 1
        start = k
        self.refuse_numbers(items[k : k + 2])
        while k < len(items) and self.simple(items[k]):
            item = items[k]
            if item.postfix and item.postfix != "DEGREE" and not (k == start and self.is_euler(item)):
                raise self.fail(item.at, f"does this power belong to {head.name} or to its argument?")
            if k > start and isinstance(item.node, Number):
                raise self.fail(item.at, "a number behind a factor is ambiguous")
            if k > start and isinstance(item.node, Name) and (item.node.dots or _changes(item.node, items[k - 1].node)):
                break  # no angle is multiplied by a rate, or by its own change
            if k > start and self.ends_clearly_at(items[start : k + 1]):
                break
            if k > start and self.ends_angle(items[start : k + 1]) and not self.runs_on(item, head.name):
                break
            if k > start and item.at in self.spaced and not self.runs_on(item, head.name):
                break
            k += 1
        if k == start:
            raise self.fail(head.at, f"{head.name} without an argument")
        if head.name in TRACES and k < len(items) and items[k].kind == "function":
            raise self.fail(items[k].at, f"does what follows belong to the argument of {head.name}? write brackets")
        factors = tuple(self.atom(item) for item in items[start : k - 1])
        last, k = self.applied(items, k - 1)
        factors += (last,)
        behind = items[k].node if k < len(items) else None
        if head.name in LOGARITHMS and isinstance(last, Call) and isinstance(behind, Bars | Norm | Name):
            raise self.fail(items[k].at, f"does this factor belong to the argument of {head.name}?")
        if k < len(items) and self.continues(items[k]) and not self.sum_behind(items[k - 1], items[k]):
            if all(isinstance(factor, Number) for factor in factors):
                raise self.fail(items[k].at, f"does this factor belong to the argument of {head.name}?")
            if self.runs_on(items[k], head.name):
                factors += (self.atom(items[k]),)
                k += 1
        return self.powered(head, (factors[0] if len(factors) == 1 else Mul(factors),)), k

    def varies(self, tree: Tree) -> bool:
        """Is this a letter for anything but pi?"""
        letter = self.notation.find(tree.letter, len(tree.subscripts)) if isinstance(tree, Name) else None
        return isinstance(tree, Name) and not (letter is not None and letter.number == "pi")

    def ends_clearly_at(self, items: list[Item]) -> bool:
        r"""Does an accented letter follow an angle: `\cos\theta \hat{n}`?"""
        names = [item.node for item in items if isinstance(item.node, Name)]
        first = names[0].letter.partition("_")[0] if names else ""
        accented = len(names) == 2 and names[1].letter.startswith(("\\hat", "\\vec", "\\tilde", "\\widehat"))
        return accented and len(items) == 2 and first in ANGLES | OFTEN_ANGLES

    def sum_behind(self, last: Item, item: Item) -> bool:
        r"""Does a sum in brackets stand apart behind an angle: `\sin\lambda \, (x - y)`?"""
        name = last.node.letter.partition("_")[0] if isinstance(last.node, Name) else ""
        inside = self.inside(item) if item.kind == "group" else None
        spaced = item.at in self.spaced and name in ANGLES | OFTEN_ANGLES
        return self.notation.inferred and spaced and isinstance(inside, Add)

    def ends_angle(self, items: list[Item]) -> bool:
        """Is the first of two letters an angle, which the second hardly multiplies: `\\cos\\theta E`?"""
        names = [item.node for item in items if isinstance(item.node, Name)]
        if len(names) != 2 or len(items) != 2:
            return False
        first, second = (name.letter.partition("_")[0] for name in names)
        if second.startswith(("\\hat", "\\vec", "\\tilde", "\\widehat")):
            return True
        if first in OFTEN_ANGLES and second.isalpha() and second not in LENGTHS:
            return True
        return first in ANGLES and second not in ("t", r"\tau", "x") and second not in ANGLES

    def is_euler(self, item: Item) -> bool:
        """Is this Euler's number with its exponent?"""
        name = item.node
        letter = self.notation.find(name.letter, len(name.subscripts)) if isinstance(name, Name) else None
        return letter is not None and letter.number == "e" and item.postfix == "CARET"

    def continues(self, item: Item) -> bool:
        """Could this factor belong to an argument without brackets before it?"""
        return self.in_brackets(item) or isinstance(item.node, Div)

    def runs_on(self, item: Item, function: str) -> bool:
        """Does an argument without brackets go on behind this space or into these brackets, as the notation says?"""
        if not self.notation.argument:
            raise self.fail(
                item.at,
                f"does this factor belong to the argument of {function}? write brackets around the argument, or say in "
                "the notation argument='short' (it does not) or 'long' (it does)",
            )
        return self.notation.argument == "long"

    def is_matrix(self, item: Item) -> bool:
        return isinstance(item.node, Name) and self.kind(item.node) in ("matrix", "vector")

    def simple(self, item: Item) -> bool:
        if isinstance(item.node, Name):
            return item.kind == "atom" and self.kind(item.node) in SIMPLE_KINDS
        return item.kind == "atom" and isinstance(item.node, Number)

    def powered(self, head: Item, arguments: tuple[Tree, ...]) -> Tree:
        call = Call(head.name, arguments)
        if head.power is None:
            return call
        if isinstance(head.power, Neg):
            inverse = INVERSES.get(head.name)
            if inverse is None or head.power != Neg(Number("1")) or not self.notation.inverse:
                raise self.fail(
                    head.at, f"the inverse function of {head.name}, or its reciprocal? write one or the other"
                )
            return Call(inverse, arguments) if self.notation.inverse == "function" else Pow(call, head.power)
        return Pow(call, head.power)

    def arguments(self, listing: Listing | None, *, event: bool = False) -> tuple[Tree, ...]:
        """What a function is applied to, an event perhaps; semicolons part its arguments from its parameters."""
        assert listing is not None
        if "SEMI" not in listing.separators:
            placed = self.notation.inferred and all(
                not isinstance(tree, STATEMENTS) or (isinstance(tree, Chain) and (event or tree.signs == ("=",)))
                for _, tree in listing.entries
            )  # f(x = a), the value there
            return (
                tuple(tree for _, tree in listing.entries) if placed and _has_chain(listing) else self.entries(listing)
            )
        k = listing.separators.index("SEMI") + 1
        first, rest = _part(listing, 0, k), _part(listing, k, len(listing.entries))
        return (Given(self.entries(first), self.arguments(rest), ";"),)

    def entries(self, listing: Listing | None) -> tuple[Tree, ...]:
        """The expressions in a pair of brackets."""
        assert listing is not None
        if any(label for label, _ in listing.entries) or any(s != "COMMA" for s in listing.separators):
            raise self.fail(listing.at, "only commas may separate what stands in brackets")
        return tuple(self.checked(tree, listing.at, statements=False) for _, tree in listing.entries)

    def alone(self, item: Item) -> Tree:
        """An atom that is no function's argument: of one letter or number in square brackets the whole part is one."""
        node = item.node
        if item.square and isinstance(node, Name | Number) and "_{" not in (shown := to_latex(node)):  # else an entry
            raise self.fail(item.at, f"[{shown}]: the whole part of {shown}, or idle brackets? leave them out")
        return self.atom(item)

    def atom(self, item: Item) -> Tree:
        """A factor that needs nothing from its right."""
        if item.kind == "given":
            raise self.fail(item.at, "a condition in brackets behind nothing that it belongs to")
        if item.kind == "group":
            node = self.bracketed(item.listing, "()")
        elif isinstance(item.node, Name) and self.applies(item.node):
            node = Call(item.node, ())
        elif item.node is not None:
            node = item.node
        else:
            raise self.fail(item.at, "something is missing behind this")
        return self.postfixed(node, item)

    def postfixed(self, node: Tree, item: Item) -> Tree:
        if not item.postfix:
            return node
        self.checked(node, item.at, statements=False)
        if item.postfix == "TRANSPOSE":
            if isinstance(node, Interval) and node.ends == "[]":
                node = Tuple((node.low, node.high), "[]")  # a row, and no interval of numbers
            return Transpose(node)
        if item.postfix == "DEGREE":
            return Degrees(node)
        if item.postfix == "MARK":
            return Marked(node, item.text)
        if item.postfix == "PRIMES":
            return Derivative(node, tuple(Counter(item.letters).items()), partial=True)
        assert item.power is not None
        if isinstance(item.power, Call) and not item.power.arguments and self.has_function(item.power):
            raise self.fail(item.at, f"{to_latex(item.power)} is a function elsewhere; say what it is above a letter")
        if isinstance(node, Number) and isinstance(item.power, Cross):
            raise self.fail(item.at, "rows and columns, or a power? write them below")
        return Pow(node, item.power)

    def bracketed(self, listing: Listing | None, kind: str) -> Tree:
        """Grouping, a pair, an interval, a list, or a statement in brackets."""
        assert listing is not None
        if any(isinstance(tree, STATEMENTS) for _, tree in listing.entries):
            if kind != "()":
                raise self.fail(listing.at, "a relation in brackets of this kind")
            return self.statement_of(listing)
        items = self.entries(listing)
        if len(items) == 1 and kind == "[]" and self.is_entry(items[0]):
            return ElementsOf(items[0])
        if len(items) == 1 and kind != "{}":
            return items[0]
        if len(items) == 2 and kind == "()":
            return Pair(*items)
        if len(items) == 2 and kind == "[]" and self.notation.inferred and not _OF_SETS.search(self.source):
            return Tuple(items, kind)
        if len(items) == 2 and kind in ("[]", "[)", "(]"):
            return Interval(*items, kind)
        if kind in ("[)", "(]"):
            raise self.fail(listing.at, "an interval has two ends")
        return Tuple(items, kind)

    def is_entry(self, tree: Tree) -> bool:
        """The entry of a matrix by two index letters: brackets around it, `[a_{ij}]`, would be idle otherwise."""
        subscripts = tree.subscripts if isinstance(tree, Name) else ()
        return len(subscripts) == 2 and len({s for s in subscripts if isinstance(s, str)}) == 2

    def differential(self, items: list[Item]) -> Differential:
        r"""`d^2 f`, `dx^2`, `\partial y_i \partial y_j`."""
        power, order = items[0].power, 1
        if power is not None:
            order = self.order(power, items[0].at)
        partial = items[0].partial
        if any(item.kind == "d" for item in items[1:]):
            return Differential(order, tuple(self.variables(items)), partial)
        if len(items) == 1:
            return Differential(order, (), partial)
        bracketed = len(items) == 2 and items[1].kind == "group" and not items[1].postfix
        return Differential(order, (self.plain(items[1:]),), partial, bracketed)

    def order(self, tree: Tree, at: int) -> int:
        if not isinstance(tree, Number) or not tree.text.isdigit() or tree.text == "0":
            raise self.fail(at, "the order of a derivative must be a number")
        return int(tree.text)

    def variables(self, items: list[Item]) -> list[Tree]:
        found = []
        for head, item in zip(items[0::2], items[1::2], strict=False):
            if head.kind != "d" or item.kind != "atom" or head.power or head.partial != items[0].partial:
                raise self.fail(head.at, "this differential cannot be read")
            found.append(self.atom(item))
        if len(items) % 2:
            raise self.fail(items[-1].at, "this differential cannot be read")
        return found

    def derivative(self, top: Differential, bottom: Differential, at: int) -> Derivative:
        variables = self.orders(bottom, at)
        if sum(order for _, order in variables) != top.order or len(top.body) != 1 or top.partial != bottom.partial:
            raise self.fail(at, "the orders of this derivative do not agree")
        body = top.body[0]
        base = body.base if isinstance(body, Pow) and body.exponent == Neg(Number("1")) else None
        name = base.function if isinstance(base, Call) else base
        if isinstance(base, Name | Call) and all(name != variable for variable, _ in variables):
            raise self.fail(at, f"the inverse function of {to_latex(base)}, or its reciprocal? write a fraction")
        return Derivative(body, variables, top.partial)

    def orders(self, bottom: Differential, at: int) -> tuple[tuple[Tree, int], ...]:
        """The variables below a derivative with their orders."""
        if bottom.order != 1 or not bottom.body:
            raise self.fail(at, "this derivative has no variable")
        found = []
        for tree in bottom.body:
            name: str | Tree = tree.base if isinstance(tree, Pow) else tree
            order = self.order(tree.exponent, at) if isinstance(tree, Pow) else 1
            if isinstance(name, Call) and not name.arguments:
                name = name.function
            if not isinstance(name, Name):
                raise self.fail(at, "a derivative is taken by a letter that depends on no other")
            found.append((name, order))
        return tuple(found)

    # -- factors -------------------------------------------------------------------------------------------------

    def on_item(self, nodes: list[ParseNode]) -> Item:
        item: Item = self.build(nodes[0])
        if len(nodes) == 1:
            return item
        if nodes[1].type == "BANG":
            if item.kind not in ("atom", "group", "fraction"):
                raise self.fail(nodes[1].value.at, "a factorial of what?")
            item, nodes = Item("fraction", item.at, Factorial(self.atom(item))), [nodes[0], *nodes[2:]]
        if len(nodes) > 2 and nodes[1].type == "MARK":
            marked = Marked(self.atom(item), nodes[1].value.value)
            item, nodes = Item("fraction", item.at, marked), [nodes[0], *nodes[2:]]
        if len(nodes) == 6 and nodes[5].type == "TRANSPOSE":  # of the inverse
            inverse = Item("fraction", item.at, Pow(self.atom(item), self.term_of(nodes[3])))
            item, nodes = inverse, [nodes[0], nodes[5]]
        if len(nodes) > 1:
            item.postfix = nodes[1].type
            if item.kind in ("sum", "integral", "antiderivative", "over", "under") or (
                item.kind in ("function", "operator") and item.postfix != "CARET"
            ):
                raise self.fail(nodes[1].value.at, "this cannot stand here")
        if item.postfix == "AT":
            return Item("atom", item.at, self.evaluated(item, nodes))
        if item.postfix == "MARK":
            item.text = nodes[1].value.value
        if item.postfix == "PRIMES":
            item.letters = nodes[1].value.value
        if item.postfix == "CARET":
            item.power = self.term_of(nodes[3])
            if item.kind in ("function", "d"):
                item.postfix = ""
            elif item.kind == "operator":
                raise self.fail(item.at, "a power of a derivative without its function")
        return item

    def evaluated(self, item: Item, nodes: list[ParseNode]) -> Tree:
        """What is in brackets at a place, or the difference of its values at two places."""
        place = self.build(nodes[3])
        if not isinstance(place, Chain) or place.signs != ("=",) or not isinstance(place.members[0], Name):
            raise self.fail(item.at, "the place at which this is taken cannot be read")
        item.postfix = ""
        variable, low = place.members
        if len(nodes) > 5:
            return Evaluated(self.atom(item), variable, low, self.term_of(nodes[6]))
        return Evaluated(self.atom(item), variable, None, low)

    def on_primary(self, nodes: list[ParseNode]) -> Item:
        head = nodes[0]
        if hasattr(head, "data"):
            return Item("atom", _place(head), MatrixOf(self.rows(nodes, _place(head))))
        item: Item = _HEADS[head.type](self, nodes, head.value.at)
        return item

    def from_number(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Number(nodes[0].value.value))

    def from_name(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, nodes[0].value.value)

    def from_fn(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("function", at, name=nodes[0].value.value)

    def from_d(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("d", at, partial=nodes[0].value.value.letter == r"\partial")

    def from_blank(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Blank())

    def from_dots(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Dots())

    def given(self, nodes: list[ParseNode], at: int) -> Item:
        """What stands in brackets on a condition."""
        items, conditions = ([tree for _, tree in self.build(node).entries] for node in (nodes[1], nodes[3]))
        return Item("given", at, Given(tuple(items), tuple(conditions), nodes[2].value.value))

    def from_under(self, nodes: list[ParseNode], at: int) -> Item:
        operator, scripts = nodes[0].value.value
        return Item("under", at, name=operator, text=scripts)

    def from_prod(self, nodes: list[ParseNode], at: int) -> Item:
        return replace(self.from_sum(nodes, at), name="product")

    def from_lpar(self, nodes: list[ParseNode], at: int) -> Item:
        if len(nodes) > 3:
            return self.given(nodes, at)
        return Item("group", at, listing=self.build(nodes[1]))

    def from_lbra(self, nodes: list[ParseNode], at: int) -> Item:
        if len(nodes) > 3:
            return self.given(nodes, at)
        return Item("atom", at, self.bracketed(self.build(nodes[1]), "[]"), square=True)

    def from_lhalf(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, self.bracketed(self.build(nodes[1]), nodes[0].value.value))

    def from_infinity(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Infinity())

    def from_langle(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Mean(self.term_of(nodes[1]), nodes[2].value.value))

    def from_int(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("integral", at, bounds=((), self.term_of(nodes[2]), self.term_of(nodes[5])))

    def from_lfloor(self, nodes: list[ParseNode], at: int) -> Item:
        inside = self.term_of(nodes[1])
        if isinstance(inside, Name) and face(inside.letter):
            raise self.fail(at, f"the skew matrix of {to_latex(inside)}, or its whole parts? say what it means")
        return Item("atom", at, Call("floor", (inside,)))

    def from_lceil(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Call("ceil", (self.term_of(nodes[1]),)))

    def from_lset(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, self.bracketed(self.build(nodes[1]), "{}"))

    def from_lbar(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Bars(self.term_of(nodes[1])))

    def from_lnorm(self, nodes: list[ParseNode], at: int) -> Item:
        value = self.term_of(nodes[1])
        return Item("atom", at, ElementsOf(value) if self.is_entry(value) else Norm(value))

    def from_root(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("fraction", at, Root(self.term_of(nodes[5]), self.term_of(nodes[2])))

    def from_binomial(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("fraction", at, Binomial(self.term_of(nodes[2]), self.term_of(nodes[5])))

    def from_llist(self, nodes: list[ParseNode], at: int) -> Item:
        items = self.entries(self.build(nodes[1]))
        if len(items) == 1:
            return Item("atom", at, Call("average", items))
        if len(items) > 2 and all(map(self.is_vector, items)):
            raise self.fail(at, "a product of several vectors, or a list of them? say what it means")
        return Item("atom", at, Tuple(items, "()") if len(items) != 2 else Pair(*items))

    def from_over(self, nodes: list[ParseNode], at: int) -> Item:
        sign, below = nodes[0].value.value
        return Item("over", at, name=sign, text=below)

    def from_anti(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("antiderivative", at)

    def from_sqrt(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("fraction", at, Sqrt(self.term_of(nodes[2])))

    def from_diag(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, Diag(self.entries(self.build(nodes[2]))))

    def from_mbegin(self, nodes: list[ParseNode], at: int) -> Item:
        return Item("atom", at, MatrixOf(self.rows(nodes, at)))

    def from_cbegin(self, nodes: list[ParseNode], at: int) -> Item:
        cases = [self.case(node.children) for node in nodes if hasattr(node, "data")]
        if any(condition is None for _, condition in cases[:-1]):
            raise self.fail(at, "what holds otherwise must be the last case")
        return Item("atom", at, Piecewise(tuple(cases)))

    def case(self, nodes: list[ParseNode]) -> tuple[Tree, Tree | None]:
        """A value and where it holds."""
        value, *rest = [node for node in nodes if hasattr(node, "data")]
        if not rest:
            return self.term_of(value), None
        condition: Tree = self.claim(rest[0])
        return self.term_of(value), condition

    def rows(self, nodes: list[ParseNode], at: int) -> tuple[tuple[Tree, ...], ...]:
        rows = [node.children for node in nodes if hasattr(node, "data")]
        if len({len(row) for row in rows}) > 1:
            raise self.fail(at, "the rows of this matrix differ in length")
        cells = [[self.term_of(cell) for cell in row[0::2]] for row in rows]
        blank = [all(isinstance(cell, Blank) for cell in column) for column in zip(*cells, strict=True)]
        every = 2 if is_doubled(blank) else 1
        return tuple(tuple(row[::every]) for row in cells)

    def from_frac(self, nodes: list[ParseNode], at: int) -> Item:
        top, bottom = self.build(nodes[2]), self.build(nodes[5])
        if (
            isinstance(top, Differential)
            and not isinstance(bottom, Differential)
            and top.order == 1
            and len(top.body) == 1
        ):
            below = self.checked(bottom, at, statements=False)
            if isinstance(top.body[0], Name) and not top.partial:
                return Item("d fraction", at, Div(Number("1"), below), letters=(top.body[0],))
        if not isinstance(bottom, Differential):
            top = self.checked(top, at, statements=False)
            self.refuse_quotient(top, bottom, at)
            return Item("fraction", at, Div(top, self.checked(bottom, at, statements=False)))
        if not isinstance(top, Differential):
            raise self.fail(at, "a differential outside of a derivative")
        if top.body:
            return Item("fraction", at, self.derivative(top, bottom, at))
        variables = self.orders(bottom, at)
        if sum(order for _, order in variables) != top.order or top.partial != bottom.partial:
            raise self.fail(at, "the orders of this derivative do not agree")
        return Item("operator", at, variables=variables, partial=top.partial)

    def from_sum(self, nodes: list[ParseNode], at: int) -> Item:
        listing: Listing = self.build(nodes[2])
        trees = [tree for _, tree in listing.entries]
        high = self.term_of(nodes[5]) if len(nodes) > 4 else None
        last, low = trees[-1], None
        if isinstance(last, Chain) and last.signs == ("=",):
            last, low = last.members
        names = [*trees[:-1], last]
        if not all(self.is_index(name) for name in names) or (low is None) != (high is None):
            raise self.fail(at, "the bounds of this sum cannot be read")
        letters = tuple(name.letter for name in names if isinstance(name, Name))
        return Item("sum", at, bounds=(letters, low, high))


_RULES = {name.removeprefix("on_"): rule for name, rule in vars(Builder).items() if name.startswith("on_")}
_HEADS = {name[len("from_") :].upper(): rule for name, rule in vars(Builder).items() if name.startswith("from_")}


# the letter that a minimum is taken by
_TAKEN_BY = re.compile(r"_ ?\{ ?(\\?[A-Za-z]+)(?: ?\\in .*)? ?\}|_ ?(\w)")


def _is_below(limiting: Limiting, end: Tree) -> bool:
    """Does the letter below a minimum, or its like, stand in the last term too, so that it reaches there?"""
    found = _TAKEN_BY.fullmatch(limiting.scripts.strip())
    return found is not None and any(isinstance(x, Name) and x.letter == (found[1] or found[2]) for x in nodes(end))


def _is_value(tree: Tree) -> bool:
    """Is this the value of a function at a place?"""
    return isinstance(tree, Call) and bool(tree.arguments)


def _has_no_letters(tree: Tree) -> bool:
    return not any(isinstance(part, Name) for part in nodes(tree))


def _is_letter(tree: Tree | None) -> bool:
    """Is this one letter without scripts, around which a product needs no brackets?"""
    return isinstance(tree, Name) and tree == Name(tree.letter) and tex.is_letter(tree.letter)


def _is_place(tree: Tree | None) -> bool:
    """Is this one letter, perhaps with an accent, and no change or gradient of one?"""
    return isinstance(tree, Name) and " " not in tree.letter and not tree.subscripts


def _is_step(node: Derivative, inside: Tree | None) -> bool:
    """Is this no place, but a sum in which the variable of the derivative stands, or what is derived?"""
    told = [each for part in (node.body, *(x for x, _ in node.variables)) for each in nodes(part)]
    names = {each for each in told if isinstance(each, Name)}
    return isinstance(inside, Add) and any(each in names for each in nodes(inside))


def _is_factor(name: Name, letter: Letter, inside: Tree | None) -> bool:
    """Does a letter that varies stand before brackets that hold no argument of it: rates, its own value, a fraction?

    A cross product is no place and no time, nor is a number with a multiple of a sine, as in the radius of an orbit.
    """
    kinds = Add | Neg | Mul | Div | Derivative | Cross
    if letter.kind == "function" or not letter.depends or not isinstance(inside, kinds):
        return False
    held = [node for node in nodes(inside) if isinstance(node, Name)]
    if any(each.dots or each.letter == name.letter for each in held):
        return True
    terms = [term.value if isinstance(term, Neg) else term for term in getattr(inside, "terms", ())]
    sums = bool(terms) and any(isinstance(term, Div | Mul | Pow) for term in terms)
    shifted = any(isinstance(term, Number) for term in terms) and any(isinstance(x, Call) for x in nodes(inside))
    return isinstance(inside, Derivative | Cross) or shifted or (bool(name.dots) and sums)


def _changes(name: Name, of: Tree | None) -> bool:
    r"""Is this the change of another letter, `\delta\alpha` behind `\alpha`?"""
    changes = (r"\delta", r"\Delta")
    return isinstance(of, Name) and any(name.letter.split() == [sign, *of.letter.split()] for sign in changes)


def _is_value_and_name(tree: Tree) -> bool:
    """Is this a number before a name, as where values of several letters are printed without a comma?"""
    return isinstance(tree, Mul) and [type(part) for part in tree.factors] == [Number, Name]


def _has_chain(listing: Listing) -> bool:
    return any(isinstance(tree, Chain) for _, tree in listing.entries)


def _part(listing: Listing, start: int, end: int) -> Listing:
    """Some of the entries, with the separators between them."""
    inner = slice(start, end - 1)
    return Listing(
        listing.entries[start:end],
        listing.separators[inner],
        listing.at,
        listing.wide[inner],
        listing.words[inner],
        listing.loose,
    )


def _signed(sign: str, term: Tree) -> Tree:
    """The term with the sign before it."""
    if sign in (r"\pm", r"\mp"):
        return PlusMinus(term, minus=sign == r"\mp")
    return Neg(term) if sign == "MINUS" else term


def _is_signed(tree: Tree) -> bool:
    return any(isinstance(node, PlusMinus) for node in nodes(tree))


def _is_range(tree: Tree) -> bool:
    """Are these two numbers in square brackets, the smaller one first?"""
    ends = tree.items if isinstance(tree, Tuple) and tree.kind == "[]" else ()
    numbers = [float(end.text) for end in ends if isinstance(end, Number)]
    return len(numbers) == len(ends) == 2 and numbers[0] < numbers[1]


def _is_styled(tree: Tree | None) -> bool:
    """Is this a letter in bold, or with an arrow?"""
    return isinstance(tree, Name) and bool(face(tree.letter))


def _is_bracket(tree: Tree) -> bool:
    """Are these two letters in square brackets?"""
    return isinstance(tree, Tuple) and tree.kind == "[]" and len(tree.items) == 2


def _is_operated(tree: Tree) -> bool:
    """Is this a letter in script with its argument, which may be an operator that makes a function of it?"""
    return isinstance(tree, Call) and isinstance(tree.function, Name) and tree.function.letter.startswith(SCRIPT)


def _is_of_capitals(tree: Tree) -> bool:
    """Are these names with capitals, as those of operators are: `[L_x, L_y]`?"""
    return isinstance(tree, Tuple) and all(isinstance(x, Name) and x.letter[:1].isupper() for x in tree.items)


def _is_of_two_capitals(tree: Tree) -> bool:
    """Are these two capitals in square brackets: `[Q, P]`?"""
    return _is_bracket(tree) and _is_of_capitals(tree)


def _is_of_set(tree: Tree) -> bool:
    return isinstance(tree, Chain) and tree.signs == (r"\in",) and isinstance(tree.members[0], Name)


def _is_e(tree: Tree) -> bool:
    return isinstance(tree, Name) and tree.letter in ("e", r"\text{e}")


def _is_words(tree: Tree) -> bool:
    """A name in upright letters that is no letter with an index."""
    name = tree.function if isinstance(tree, Call) and not tree.arguments else tree
    return isinstance(name, Name) and name.letter.startswith(r"\text{") and len(name.letter) > len(r"\text{dx}")


def _place(node: ParseNode) -> int:
    while hasattr(node, "data"):
        node = node.children[0]
    at: int = node.value.at
    return at


def _ends_bare(items: list[Item]) -> bool:
    """Does the product end in a function whose argument has no brackets?"""
    for item in reversed(items):
        if item.kind == "function":
            return True
        if item.kind != "atom" and item.kind != "fraction":
            return False
    return False
