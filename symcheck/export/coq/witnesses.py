"""For each set of hypotheses the point of a certificate at which it holds, so that no statement is true for want of
a case."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from symcheck.export.coq.claims import Exported
from symcheck.export.coq.printing import name, spelled
from symcheck.export.coq.statements import Statement
from symcheck.export.coq.terms import letters, substituted

HEAD = """Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Require Import Symcheck.Symcheck.
Open Scope R_scope.
"""
NONE = "no certificate has a point that satisfies the hypotheses"
FUNCTIONS = "a certificate tells some values of an unknown function, and no function that has them"


def witnesses(found: Sequence[Exported]) -> tuple[str, dict[str, str]]:
    """The file, and the claims for whose hypotheses no point is known, with the reason."""
    sets: dict[str, list[Exported]] = {}
    for each in found:
        if each.statement is not None and (each.statement.hypotheses or each.statement.premises):
            sets.setdefault(satisfiable(each.statement), []).append(each)
    lines = [HEAD]
    missing: dict[str, str] = {}
    for k, (text, alike) in enumerate(sets.items(), 1):
        names = [each.name for each in alike]
        script = next((script for each in alike for script in proofs(each)), None)
        if script is None:
            about = alike[0].statement
            missing |= dict.fromkeys(names, FUNCTIONS if about and about.functions else NONE)
        else:
            lines.append(f"(* {' '.join(names)} *)\nLemma witness_{k} :\n{text}.\nProof.\n{script}\nQed.\n")
    return "\n".join(lines), missing


def needed(statement: Statement) -> list[str]:
    """The letters of the hypotheses, and of the definitions behind them."""
    kept = set(letters(["and", *(f for _, f in statement.hypotheses), *statement.premises]))
    for x in reversed(statement.defined):
        if x in kept:
            kept |= set(letters(statement.definitions.readable(statement.definitions.terms[x])))
    return [x for x in statement.variables if x in kept]


def satisfiable(statement: Statement) -> str:
    """exists letters, definitions and hypotheses."""
    kept, shown = needed(statement), statement.definitions.readable
    parts: list[Any] = [["=", x, shown(statement.definitions.terms[x])] for x in statement.defined if x in kept]
    parts += [shown(f) for _, f in statement.hypotheses] + [["!=", shown(d), 0] for d in statement.premises]
    head = f"exists {' '.join(map(name, sorted(kept)))} : R,\n  " if kept else ""
    return f"  {head}{spelled(['and', *parts])}"


def proofs(each: Exported) -> Iterator[str]:
    """For each point of the certificate that speaks of all letters: the point, and that it satisfies them."""
    statement = each.statement
    assert statement is not None
    if statement.functions:
        return
    kept = needed(statement)
    for point in each.certificate.get("witnesses", ()):
        values = coordinates(point["values"])
        angles = [x for x in kept if {f"sin_{x}", f"cos_{x}"} <= values.keys()]
        terms = {x: x if x in angles else substituted(statement.definitions.unfolded(x), values) for x in kept}
        if set(letters(["+", *terms.values()])) <= {*angles}:
            yield script(terms, [(x, values[f"sin_{x}"], values[f"cos_{x}"]) for x in angles])


def script(terms: Mapping[str, Any], angles: Sequence[tuple[str, Any, Any]]) -> str:
    """Letters by their terms; angles by their sines and cosines."""
    lines = [
        f"destruct (angle_of {spelled(sine, 0)} {spelled(cosine, 0)} ltac:(concrete)) as [{name(x)} [s_{x}' c_{x}']]."
        for x, sine, cosine in angles
    ]
    lines += [f"exists {spelled(term, 0)}." for _, term in sorted(terms.items())]
    rewrites = [f"rewrite ?sin_2a, ?cos_2a, ?s_{x}', ?c_{x}'" for x, _, _ in angles]
    return "\n".join([*lines, "; ".join(["repeat split", *rewrites, "concrete"]) + "."])


def coordinates(found: Mapping[str, Any]) -> dict[str, Any]:
    """The values at a point as terms; one may be given by others."""
    values = {x: number(value) if isinstance(value, str) else value for x, value in found.items()}
    for _ in values:
        values = {x: substituted(value, values) for x, value in values.items()}
    return values


def number(text: str) -> Any:
    """A rational number such as "-2/7" as a term."""
    value = Fraction(text)
    top: Any = value.numerator if value >= 0 else ["-", -value.numerator]
    return top if value.denominator == 1 else ["/", top, value.denominator]
