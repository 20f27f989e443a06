"""For each set of hypotheses a point that satisfies it, so that no statement is true for want of a case."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from symcheck.export.coq.claims import Exported
from symcheck.export.coq.printing import name, spelled
from symcheck.export.coq.statements import Statement
from symcheck.export.coq.terms import Definitions, NotExported, letters, substituted
from symcheck.export.coq.trials import tried
from symcheck.proof import refute
from symcheck.statement import Problem

HEAD = """Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Require Import Symcheck.Symcheck.
Open Scope R_scope.
"""
FALSE = ("=", 0, 1)


def witnesses(found: Sequence[Exported]) -> tuple[str, dict[str, str]]:
    """The file, and the claims for whose hypotheses no point was found, with the reason."""
    sets: dict[str, tuple[Statement, list[str]]] = {}
    for each in found:
        if each.statement is not None and (each.statement.hypotheses or each.statement.premises):
            sets.setdefault(satisfiable(each.statement), (each.statement, []))[1].append(each.name)
    lines = [HEAD]
    missing: dict[str, str] = {}
    for k, (text, (statement, names)) in enumerate(sets.items(), 1):
        try:
            script = proof(statement)
        except NotExported as error:
            missing |= dict.fromkeys(names, str(error))
            continue
        lines.append(f"(* {' '.join(names)} *)\nLemma witness_{k} :\n{text}.\nProof.\n{script}\nQed.\n")
    return "\n".join(lines), missing


def needed(statement: Statement) -> list[str]:
    """The letters of the hypotheses, and of the definitions behind them."""
    kept = set(letters(["and", *(f for _, f in statement.hypotheses), *statement.premises]))
    for x in reversed(statement.defined):
        if x in kept:
            kept |= set(letters(statement.definitions.readable(statement.definitions.terms[x])))
    return [x for x in statement.variables if x in kept]


def settled(statement: Statement) -> Statement:
    """The same with hypotheses that say what a letter is (J = 1000, a = arctan 3) taken as definitions."""
    definitions = dict(statement.definitions.terms)
    for _, formula in statement.hypotheses:
        match formula:
            case ["=", str(x), term] if x not in definitions and x[3:4] != "_" and not _needs(term, x, definitions):
                definitions[x] = term
    ordered: list[str] = []

    def visit(x: str) -> None:
        if x in definitions and x not in ordered:
            for other in letters(definitions[x]):
                visit(other)
            ordered.append(x)

    for x in definitions:
        visit(x)
    pairs = Definitions([[x, definitions[x]] for x in ordered])
    return replace(statement, definitions=pairs, defined=tuple(x for x in ordered if x in statement.variables))


def _needs(term: Any, x: str, definitions: dict[str, Any]) -> bool:
    return any(y == x or (y in definitions and _needs(definitions[y], x, definitions)) for y in letters(term))


def satisfiable(statement: Statement) -> str:
    """exists letters, definitions and hypotheses."""
    kept, shown = needed(statement), statement.definitions.readable
    parts: list[Any] = [["=", x, shown(statement.definitions.terms[x])] for x in statement.defined if x in kept]
    parts += [shown(f) for _, f in statement.hypotheses] + [["!=", shown(d), 0] for d in statement.premises]
    head = f"exists {' '.join(map(name, sorted(kept)))} : R,\n  " if kept else ""
    return f"  {head}{spelled(['and', *parts])}"


def proof(statement: Statement) -> str:
    """The point, and that it satisfies them."""
    statement = settled(statement)
    values = point(statement)
    kept = needed(statement)
    full = statement.definitions.unfolded
    angles = [x for x in kept if x not in statement.definitions.terms and f"sin_{x}" in values]
    lines, scope = [], dict(values)
    for x in angles:
        sine, cosine = (spelled(values[f"{f}_{x}"], 0) for f in ("sin", "cos"))
        lines.append(f"destruct (angle_of {sine} {cosine} ltac:(concrete)) as [{name(x)} [s_{x}' c_{x}']].")
    for x in sorted(kept):
        term = full(statement.definitions.terms[x]) if x in statement.definitions.terms else x
        plain = {y: v for y, v in scope.items() if y[:4] not in ("sin_", "cos_")}
        shown = substituted(term, plain)
        if x in angles:
            shown = x
        if set(letters(shown)) - set(angles):
            raise NotExported("no point was found that satisfies the hypotheses")
        lines.append(f"exists {spelled(shown, 0)}.")
    rewrites = "".join(f"rewrite ?sin_2a, ?cos_2a, ?s_{x}', ?c_{x}'. " for x in angles)
    lines.append(
        f"repeat split; {rewrites.strip().replace('. ', '; ').rstrip('.') + '; ' if rewrites else ''}concrete."
    )
    return "\n".join(lines)


def point(statement: Statement) -> dict[str, Any]:
    """Values of the free letters (of sines and cosines for angles), by the search for counterexamples, or by trial."""
    formulas = [_frozen(f) for _, f in statement.hypotheses] + [("!=", _frozen(d), 0) for d in statement.premises]
    definitions = tuple((x, _frozen(statement.definitions.terms[x])) for x in statement.defined)
    found = refute(Problem("witness", FALSE, definitions, (("given", tuple(formulas)),)))
    if found is not None and "values" in found:
        return {x: _term(v) for x, v in found["values"].items()}
    full = statement.definitions.unfolded
    values = tried([full(_thawed(formula)) for formula in formulas])
    if values is None:
        raise NotExported("no point was found that satisfies the hypotheses")
    return values


def _term(value: Any) -> Any:
    if isinstance(value, str):
        top, _, bottom = value.partition("/")
        if not top.lstrip("-").isdigit():
            raise NotExported(f"the value {value}")
        number: Any = int(top) if int(top) >= 0 else ["-", -int(top)]
        return ["/", number, int(bottom)] if bottom else number
    return value if not isinstance(value, tuple) else [_term(v) if isinstance(v, tuple) else v for v in value]


def _thawed(node: Any) -> Any:
    return [*map(_thawed, node)] if isinstance(node, tuple) else node


def _frozen(node: Any) -> Any:
    return tuple(map(_frozen, node)) if isinstance(node, list) else node
