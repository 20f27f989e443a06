"""The grammar of printed formulas, and the tree built from it. Whatever could be read in two ways is an error."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING, Any

from symcheck.reading import tex
from symcheck.reading.lexer import Lexeme, Lexer
from symcheck.reading.notation import Notation
from symcheck.reading.tree import (
    LOGIC,
    STATEMENTS,
    Add,
    And,
    Bars,
    BigSum,
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
    Exists,
    Iff,
    Implies,
    Interval,
    MatrixOf,
    Mul,
    Name,
    Neg,
    Number,
    Or,
    Pair,
    Pow,
    Qualifier,
    Sqrt,
    System,
    Transpose,
    Tree,
    Tuple,
)
from symcheck.statement import SymcheckError

if TYPE_CHECKING:
    from lark import Lark

GRAMMAR = r"""
start: listing
listing: entry (separator entry)*
separator: COMMA | SEMI | NEWLINE | COMMA NEWLINE | SEMI NEWLINE
entry: LABEL? formula
?formula: exists | iff
?iff: implies | implies IFF (implies | exists)
?implies: either | either IMPLIES (implies | exists)
?either: both | both (OR both)+
?both: chain | chain (AND chain)+
exists: EXISTS NAME (COMMA NAME)* COLON implies
?chain: sum | sum (REL sum)+
sum: MINUS? term ((PLUS | MINUS) term)*
term: product ((SLASH | TIMES) product)?
product: (item | CDOT)+
item: primary (CARET LB sum RB | TRANSPOSE | DEGREE)?
primary: NUMBER | NAME | FN | D | DOTS | LPAR listing RPAR | LBRA listing RBRA | LSET listing RSET
       | LBAR sum RBAR | LNORM sum RNORM | FRAC LB sum RB LB sum RB | SQRT LB sum RB
       | SUM LB listing RB (LB sum RB)? | DIAG (LPAR listing RPAR | LBRA listing RBRA) | MBEGIN row (ROW row)* MEND
row: sum (CELL sum)*
%declare NUMBER NAME FN D DOTS LPAR RPAR LBRA RBRA LSET RSET LBAR RBAR LNORM RNORM LB RB FRAC SQRT SUM DIAG MBEGIN MEND
%declare ROW CELL CARET TRANSPOSE DEGREE CDOT SLASH TIMES PLUS MINUS REL AND OR IMPLIES IFF EXISTS COLON COMMA SEMI
%declare NEWLINE LABEL PRIMES
"""

SIMPLE_KINDS = ("scalar", "index", "function")


@dataclass(frozen=True, slots=True)
class Differential(Tree):
    """The `d^n f` of a derivative, or its `dx^n dy`, before the fraction is put together."""

    order: int
    body: tuple[Tree, ...]
    partial: bool


@dataclass(slots=True)
class Listing:
    """What stands in brackets, or the whole statement: entries with labels and the separators between them."""

    entries: list[tuple[str, Tree]]
    separators: list[str]
    at: int


@dataclass(slots=True)
class Item:
    """One factor before functions, sums and derivatives have taken their arguments.

    kind: "atom", "fraction" (also a root), "group" (round brackets), "function", "sum", "operator", "d", "dot"
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
    partial: bool = False


@cache
def _lark() -> Lark:
    from lark import Lark

    return Lark(GRAMMAR, parser="lalr", lexer="basic")


def read(latex: str | Sequence[str], notation: Notation) -> Tree:
    """The tree of a printed formula, nothing evaluated.

    A sequence is one display continued over several blocks. Tags and the punctuation at the end are dropped.
    Errors: SymcheckError naming the place for an unknown letter, an unbalanced bracket or an ambiguous form.
    """
    pieces = [latex] if isinstance(latex, str) else list(latex)
    source = r" \\ ".join(tex.split_tag(piece)[0] for piece in pieces)
    lexemes = Lexer(source, notation).lexemes()
    if not lexemes:
        raise SymcheckError(f"an empty formula: {latex!r}; give the printed LaTeX")
    return Builder(source, notation).statement(_parse(source, lexemes))


def _parse(source: str, lexemes: list[Lexeme]) -> Any:
    from lark import Token, UnexpectedInput

    interactive = _lark().parse_interactive("")
    for lexeme in lexemes:
        try:
            interactive.feed_token(Token(lexeme.type, lexeme, start_pos=lexeme.at))  # type: ignore[arg-type]
        except UnexpectedInput:
            raise tex.fault(source, lexeme.at, f"{_shown(lexeme)} does not fit here") from None
    try:
        return interactive.feed_eof()
    except UnexpectedInput:
        raise tex.fault(source, len(source), "the formula breaks off") from None


def _shown(lexeme: Lexeme) -> str:
    return lexeme.value.letter if isinstance(lexeme.value, Name) else str(lexeme.value)
