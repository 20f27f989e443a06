"""The tables of the grammar's parser, as they are stored beside it, and how they are made.

Reason: to make them takes longer than to read a page of formulas, and every start of the program would.
"""

from __future__ import annotations

import json
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

STORED = Path(__file__).with_name("tables.json")
ANY = ""  # stands for all tokens in a state in which nothing is possible but the end of one rule


class Rule(NamedTuple):
    """A rule of the grammar: its name, the number of its parts, and whether a part that is alone stands for it.

    A repetition, whose name begins with a dash below, is a list of parts of the rule in which it stands.
    """

    name: str
    size: int
    single: bool


class Tables(NamedTuple):
    """The next state by state and token or rule, or ~k where rule k ends; the states of the beginning and the end."""

    states: list[dict[str, int]]
    rules: list[Rule]
    start: int
    end: int


@cache
def tables(grammar: str) -> Tables:
    """Those that are stored, if they are of this grammar and whole; others are made again."""
    with suppress(OSError, ValueError, TypeError):
        of, states, rules, start, end = json.loads(STORED.read_text(encoding="utf-8"))
        if of == grammar:
            return Tables(states, [Rule(*rule) for rule in rules], start, end)
    return made(grammar)


def made(grammar: str) -> Tables:
    """What lark makes of the grammar."""
    from lark import Lark
    from lark.parsers.lalr_analysis import Shift

    parser: Any = Lark(grammar, parser="lalr", lexer="basic").parser
    table = parser.parser._parse_table
    found, rules = [table.start_states["start"]], dict[Any, int]()  # in the order in which they are reached
    states = list[dict[str, int]]()
    for state in found:
        row = dict[str, int]()
        for name, (action, where) in sorted(table.states[state].items()):
            if action is Shift and where not in found:
                found.append(where)
            row[str(name)] = found.index(where) if action is Shift else ~rules.setdefault(where, len(rules))
        only = {*row.values()}
        states.append({ANY: min(only)} if len(only) == 1 and min(only) < 0 else row)
    named = [Rule(str(rule.origin.name), len(rule.expansion), rule.options.expand1) for rule in rules]
    return Tables(states, named, 0, found.index(table.end_states["start"]))


def store(grammar: str) -> None:
    """Write the tables of a grammar beside it."""
    lines = json.dumps([grammar, *made(grammar)], separators=(",", ":")).replace("},{", "},\n{")
    STORED.write_text(f"{lines}\n", encoding="utf-8")
