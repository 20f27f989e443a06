"""The stored tables of the grammar: what lark makes of it, and the trees that lark itself makes with them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from lark import Lark, Token
from lark.lexer import Lexer as LarkLexer

from symcheck.core.verdicts import SymcheckError
from symcheck.reading.grammar import GRAMMAR, Branch, Leaf, ParseNode, parse
from symcheck.reading.inference import inferred
from symcheck.reading.lexer import Lexeme, Lexer
from symcheck.reading.surface import plain
from symcheck.reading.tables import made, tables

WRITE = "after a change of the grammar run `python -m symcheck.reading`"

DISPLAYS = (
    r"x = 1",
    r"-a + b - \frac{c}{d} \le (e_1 + f)^2 g / h",
    r"\sum_{k=1}^n k^2 \cdot x = \int_0^1 \sin x \, dx, \quad a < b < c",
    r"A = \begin{bmatrix} a & b + c \\ d & e \end{bmatrix} \times u \times v",
    r"f(x) = \begin{cases} x & x > 0 \\ -x! & \text{otherwise} \end{cases}",
    r"a = b \land c = d \implies e = f \lor g = h, \quad \forall h",
    r"\left[ x + b \right]_{x=0}^{1} = A^T + \sqrt[3]{y'} + \lfloor z \rfloor",
)


class Given(LarkLexer):
    """Tokens as they are given, for lark's own parser."""

    def __init__(self, _: Any) -> None: ...

    def lex(self, data: Any) -> Any:
        return (Token(lexeme.type, lexeme) for lexeme in data)


def shown(node: Any) -> Any:
    """A tree of lark or of ours, with the types of its tokens."""
    if isinstance(node, Branch | Leaf):
        return (node.data, *map(shown, node.children)) if isinstance(node, Branch) else node.type
    return (str(node.data), *map(shown, node.children)) if hasattr(node, "data") else node.type


def lexed(latex: str) -> list[Lexeme]:
    text = plain(latex)
    return Lexer(text, inferred([text], {}, {})[0].notation).lexemes()


def test_what_is_stored_are_the_tables_of_the_grammar() -> None:
    assert tables(GRAMMAR) == made(GRAMMAR), WRITE


def test_the_tables_of_another_grammar_are_made() -> None:
    other = 'start: "a" b\nb: (NAME NAME)+\n%declare NAME\n'
    assert {rule.name.strip("_")[:1] for rule in tables(other).rules} == {"s", "b"}


@pytest.mark.parametrize("damaged", [None, b"", b"[1, 2", b"5", b"[1, 2]", b"\xff"])
def test_damaged_tables_are_made_again(damaged: bytes | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stored = tmp_path / "tables.json"
    if damaged is not None:
        stored.write_bytes(damaged)
    monkeypatch.setattr("symcheck.reading.tables.STORED", stored)
    assert tables.__wrapped__(GRAMMAR) == made(GRAMMAR)


@pytest.mark.parametrize("latex", DISPLAYS)
def test_the_trees_are_those_of_lark(latex: str) -> None:
    lexemes = lexed(latex)
    found: ParseNode = parse(latex, lexemes)
    assert shown(found) == shown(Lark(GRAMMAR, parser="lalr", lexer=Given).parse(lexemes))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("kinds", "told"), [("NAME REL", "breaks off"), ("NAME REL REL", "does not fit"), ("RPAR", "does not fit")]
)
def test_the_first_token_that_does_not_fit_is_told(kinds: str, told: str) -> None:
    with pytest.raises(SymcheckError, match=told):
        parse("x ==", [Lexeme(kind, "=", k) for k, kind in enumerate(kinds.split())])


def test_to_read_a_formula_imports_no_lark() -> None:
    code = (
        "import sys; from symcheck.reading import Letter, Notation, read; "
        "read('x = 1', Notation([Letter('x')])); print('lark' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
