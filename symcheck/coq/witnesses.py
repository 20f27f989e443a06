"""For each set of hypotheses the point of a certificate at which it holds, so that no statement is vacuously true."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import tan

from symcheck.checker.algebra import exact
from symcheck.coq.claims import Claim
from symcheck.coq.printing import ATOM, name, spelled
from symcheck.coq.statements import Statement
from symcheck.coq.values import number, quotient, value
from symcheck.core.calculus import letters, substituted
from symcheck.core.terms import Node, Reader, Term, Value, mapped, node

HEAD = """Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Require Import Symcheck.Symcheck.
Open Scope R_scope.
"""
MAX_DENOMINATOR = 20  # of the tangent of half the angle: close enough for inequalities, small enough for `nra`
NONE = "no certificate has a point that satisfies the hypotheses"
FUNCTIONS = "a certificate tells some values of an unknown function, and no function that has them"


def witnesses(claims: Sequence[Claim]) -> tuple[str, dict[str, str]]:
    """The file, and the claims for whose hypotheses no point is known, with the reason."""
    sets: dict[str, list[Claim]] = {}
    for claim in claims:
        if claim.statement is not None and (claim.statement.hypotheses or claim.statement.premises):
            sets.setdefault(satisfiable(claim.statement), []).append(claim)
    lines = [HEAD]
    missing: dict[str, str] = {}
    for k, (text, members) in enumerate(sets.items(), 1):
        names = [claim.name for claim in members]
        script = next((script for claim in members for script in proofs(claim)), None)
        if script is None:
            about = members[0].statement
            missing |= dict.fromkeys(names, FUNCTIONS if about and about.functions else NONE)
        else:
            lines.append(f"(* {' '.join(names)} *)\nLemma witness_{k} :\n{text}.\nProof.\n{script}\nQed.\n")
    return "\n".join(lines), missing


def needed(statement: Statement) -> list[str]:
    """The letters of the hypotheses, and of the definitions behind them."""
    kept = letters(node("and", *(formula for _, formula in statement.hypotheses), *statement.divided))
    for x in reversed(statement.defined):
        if x in kept:
            kept |= letters(statement.definitions.terms[x])
    return [x for x in statement.variables if x in kept]


def satisfiable(statement: Statement) -> str:
    """exists letters, definitions and hypotheses."""
    kept = needed(statement)
    parts = [equation for x, equation in zip(statement.defined, statement.equations, strict=True) if x in kept]
    parts += [formula for _, formula in statement.hypotheses] + statement.divided
    head = f"exists {' '.join(map(name, sorted(kept)))} : R,\n  " if kept else ""
    return f"  {head}{spelled(node('and', *parts))}"


def proofs(claim: Claim) -> Iterator[str]:
    """For claim point of the certificate that speaks of all letters: the point, and that it satisfies them."""
    statement = claim.statement
    assert statement is not None
    if statement.functions:
        return
    for point in claim.certificate.get("witnesses", ()):
        values = {x: Reader().term(data) for x, data in point["values"].items()}
        values |= {x: close for x in angles_only(statement) & {*values} if (close := near(values[x]))}
        angles = {x: circular for x, number in values.items() if (circular := circle(number))}
        values |= {x: x for x in angles}
        terms = {x: substituted(statement.definitions.unfolded(x), values) for x in needed(statement)}
        if letters(node("+", *terms.values())) <= angles.keys():
            yield script(terms, {x: angles[x] for x in terms if x in angles})


def angles_only(statement: Statement) -> set[str]:
    """The letters of the hypotheses that stand in sines and cosines of themselves alone."""

    def rest(tree: Term) -> Term:
        match tree:
            case Value(tag="sin" | "cos", terms=(str(),)):
                return 0
            case Node():
                return mapped(tree, rest)
        return tree

    spoken = [formula for _, formula in statement.hypotheses] + statement.divided
    return {*needed(statement)} - letters(rest(statement.definitions.unfolded(node("and", *spoken))))


def near(angle: Term) -> Term | None:
    """For an angle in radians, whose sine Coq does not work out, one close by whose sine and cosine are fractions."""
    size = number(value(angle)) if exact(angle, roots=False) else None
    if size is None:
        return None
    half = Fraction(tan(size / 2)).limit_denominator(MAX_DENOMINATOR)
    return node("*", 2, node("arctan", quotient(half)))


def circle(angle: Term) -> tuple[Term, Term] | None:
    """Sine and cosine of an angle that is given by the tangent of its half."""
    match angle:
        case Value(tag="pi"):
            return 0, -1
        case Value(tag="*", terms=(2, Value(tag="arctan", terms=(half,)))):
            sine, cosine = (number(value(node(function, angle))) for function in ("sin", "cos"))
            if sine is not None and cosine is not None:
                return quotient(sine), quotient(cosine)
            match half:
                case Value(tag="/", terms=(s, Value(tag="+", terms=(1, c)))):
                    return s, c
    return None


def script(terms: Mapping[str, Term], angles: Mapping[str, tuple[Term, Term]]) -> str:
    """Letters by their terms; angles by their sines and cosines."""
    lines = [
        f"destruct (angle_of {spelled(sine, ATOM)} {spelled(cosine, ATOM)} ltac:(concrete))"
        f" as [{name(x)} [s_{x}' c_{x}']]."
        for x, (sine, cosine) in angles.items()
    ]
    lines += [f"exists {spelled(term, ATOM)}." for _, term in sorted(terms.items())]
    rewrites = [f"rewrite ?sin_2a, ?cos_2a, ?s_{x}', ?c_{x}'" for x in angles]
    return "\n".join([*lines, "; ".join(["repeat split", *rewrites, "concrete"]) + "."])
