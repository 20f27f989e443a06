"""The grammar of printed formulas (LALR, without conflicts).

It settles what belongs to what by signs and brackets. What an implicit product means - where the argument of a sine
ends, whether brackets behind a letter are a factor or an argument - depends on the letters and is settled in `parser`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from symcheck.reading import tex
from symcheck.reading.lexer import Lexeme
from symcheck.reading.tables import ANY, tables
from symcheck.reading.tree import Name

ParseNode = Any  # a Branch, or a Leaf, whose `value` is a Lexeme

GRAMMAR = r"""
start: listing
listing: entry (separator entry)*
separator: COMMA | SEMI | NEWLINE | COMMA NEWLINE | SEMI NEWLINE | FOR
entry: LABEL? formula (COLON formula)? | FORALL formula
?formula: exists | iff
?iff: implies | implies IFF (implies | exists)
?implies: either | either IMPLIES (implies | exists)
?either: both | both (OR both)+
?both: chain | chain (AND chain)+
exists: EXISTS NAME (COMMA NAME)* COLON implies
?chain: sum | sum (REL sum)+
sum: (MINUS | PM | PLUS)? term ((PLUS | MINUS | PM) term)*
term: product ((SLASH | TIMES) product | TIMES product TIMES product | (OPERATOR product)+)?
product: (item | CDOT)+
item: primary BANG? (CARET LB sum RB TRANSPOSE? | TRANSPOSE | DEGREE | PRIMES | MARK (CARET LB sum RB | TRANSPOSE)?
    | AT LB chain RB (LB sum RB)?)?
primary: NUMBER | BLANK | NAME | FN | D | DOTS | INFINITY | LPAR listing RPAR | LBRA listing RBRA | LSET listing RSET
       | LHALF listing RHALF | LBAR sum RBAR | LNORM sum RNORM | LANGLE sum RANGLE | FRAC LB sum RB LB sum RB
       | SQRT LB sum RB | ROOT LB sum RB LB sum RB | BINOMIAL LB sum RB LB sum RB | LLIST listing RLIST
       | SUM LB listing RB (LB sum RB)? | INT LB sum RB LB sum RB | ANTI | OVER
       | PROD LB listing RB (LB sum RB)? | UNDER | LPAR listing MID listing RPAR | LBRA listing MID listing RBRA
       | LFLOOR sum RFLOOR | LCEIL sum RCEIL
       | DIAG (LPAR listing RPAR | LBRA listing RBRA) | MBEGIN row (ROW row)* MEND
       | CBEGIN case (ROW case)* CEND
case: sum COMMA? CELL COMMA? (chain COMMA? | OTHERWISE)
row: sum (CELL sum)*
%declare NUMBER NAME FN D DOTS LPAR RPAR LBRA RBRA LSET RSET LBAR RBAR LNORM RNORM LB RB FRAC SQRT SUM DIAG MBEGIN MEND
%declare ROW CELL CARET TRANSPOSE DEGREE CDOT SLASH TIMES PLUS MINUS REL AND OR IMPLIES IFF EXISTS COLON COMMA SEMI
%declare NEWLINE FOR OPERATOR LFLOOR RFLOOR LCEIL RCEIL LABEL PRIMES PM INT ANTI INFINITY LANGLE RANGLE LHALF RHALF ROOT
%declare BINOMIAL LLIST RLIST AT BANG CBEGIN CEND OTHERWISE BLANK PROD UNDER MID FORALL MARK OVER
"""


@dataclass(slots=True)
class Branch:
    """What a rule of the grammar is made of, by the rule's name."""

    data: str
    children: list[ParseNode]


@dataclass(slots=True)
class Leaf:
    """A token in the parser's tree."""

    type: str
    value: Lexeme


def parse(source: str, lexemes: list[Lexeme]) -> ParseNode:
    """The tree of a token list; SymcheckError at the first token that does not fit."""
    states, rules, start, end = tables(GRAMMAR)
    path, values = [start], list[Any]()
    for lexeme in (*lexemes, None):
        kind = "$END" if lexeme is None else lexeme.type
        while True:
            row = states[path[-1]]
            where = row.get(kind, row.get(ANY))
            if where is None:
                if lexeme is None:
                    raise tex.fault(source, len(source), "the formula breaks off")
                raise tex.fault(source, lexeme.at, f"{_shown(lexeme)} does not fit here")
            if where >= 0:
                path.append(where)
                values.append(Leaf(kind, lexeme) if lexeme else None)
                break
            name, size, single = rules[~where]
            if size > 1 or not single:
                parts = [part for each in values[-size:] for part in (each if each.__class__ is list else (each,))]
                alone = single and len(parts) == 1
                values[-size:] = [parts[0] if alone else parts if name[0] == "_" else Branch(name, parts)]
            del path[-size:]
            path.append(states[path[-1]][name])
            if path[-1] == end:
                return values[-1]
    raise AssertionError("the end is no token")


def _shown(lexeme: Lexeme) -> str:
    return lexeme.value.letter if isinstance(lexeme.value, Name) else str(lexeme.value)
