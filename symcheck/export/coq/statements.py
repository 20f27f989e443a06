"""What is stated in Coq: the letters, the definitions and hypotheses as premises, the conclusion."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from symcheck.export.coq.printing import name, printed
from symcheck.export.coq.terms import (
    Definitions,
    NotExported,
    denominators,
    functions,
    is_number,
    letters,
    subterms,
)
from symcheck.export.coq.values import Values
from symcheck.proof.theorems import Terms

WIDTH = 118


@dataclass(frozen=True)
class Statement:
    """forall variables, definitions -> hypotheses -> denominators are not zero -> conclusion."""

    variables: tuple[str, ...]
    defined: tuple[str, ...]  # those of the variables that stand for something, in an order to unfold them
    hypotheses: tuple[tuple[Any, Any], ...]  # reference, formula
    premises: tuple[Any, ...]  # denominators about which no hypothesis speaks
    conclusion: Any
    definitions: Definitions

    @property
    def functions(self) -> dict[str, int]:
        """The unknown functions, with the numbers of their arguments."""
        terms = [self.definitions.terms[x] for x in self.defined]
        said = [*terms, *(f for _, f in self.hypotheses), *self.premises, self.conclusion]
        met = [*dict.fromkeys(functions(said))]
        found = dict(met)
        if len(found) < len(met) or found.keys() & {*self.variables}:
            raise NotExported("an unknown function has the name of a letter, or two numbers of arguments")
        return found

    @property
    def names(self) -> list[str]:
        """All that the statement is about, by its names in Coq."""
        return [name(x) for x in (*self.functions, *self.variables)]

    def text(self) -> str:
        """As Coq reads it."""
        shown = self.definitions.readable
        lines = [f"{name(x)} = {printed(shown(self.definitions.terms[x]), 70)} ->" for x in self.defined]
        for label, group in groupby(self.hypotheses, key=lambda hypothesis: hypothesis[0][1]):
            lines += [f"(* {label} *)", *(f"{printed(shown(formula), 98)} ->" for _, formula in group)]
        lines += ["(* where it is divided by *)"] * bool(self.premises)
        lines += [f"{printed(shown(divisor), 70)} <> 0 ->" for divisor in self.premises]
        lines += [printed(shown(self.conclusion), 99)]
        bound = [f"({name(f)} : {'R -> ' * arity}R)" for f, arity in self.functions.items()]
        shown_letters = " ".join(map(name, self.variables))
        if shown_letters:
            bound.append(f"({shown_letters} : R)" if bound else f"{shown_letters} : R")
        head = [f"forall {' '.join(bound)},"] if bound else []
        return "\n".join(f"  {piece}" for line in [*head, *lines] for piece in folded(line))


def folded(line: str) -> Iterable[str]:
    """A long line in pieces, broken at spaces."""
    while len(line) > WIDTH and (at := line.rfind(" ", 0, WIDTH)) > 0:
        yield line[:at]
        line = "  " + line[at + 1 :]
    yield line


def statement(certificate: Any) -> Statement:
    """What a certificate of a proof states."""
    definitions = Definitions(certificate["definitions"])
    hypotheses = tuple(
        (("hyp", label, k), formula)
        for label, formulas in certificate["hypotheses"].items()
        for k, formula in enumerate(formulas)
    )
    return stated(definitions, hypotheses, certificate["claim"], certificate["proof"])


def stated(definitions: Definitions, hypotheses: tuple[tuple[Any, Any], ...], claim: Any, proof: Any) -> Statement:
    """The statement with the letters that occur in it, definitions in an order in which each uses earlier ones."""
    shown = [definitions.readable(f) for f in (claim, *(f for _, f in hypotheses))]
    defined: list[str] = []

    def need(node: Any) -> None:
        for x in letters(node):
            if x in definitions.terms and x not in defined:
                need(definitions.readable(definitions.terms[x]))
                defined.append(x)

    need(["and", *shown])
    spoken = [*shown, *(definitions.readable(definitions.terms[x]) for x in defined)]
    premises = tuple(unsettled(definitions, hypotheses, spoken, proof))
    return Statement(
        tuple(letters(["and", *spoken, *defined])), tuple(defined), hypotheses, premises, claim, definitions
    )


def unsettled(definitions: Definitions, hypotheses: Any, spoken: list[Any], proof: Any) -> Iterable[Any]:
    """The denominators of a statement that the certificate lists as assumed not to vanish."""
    if not proof.get("nonzero"):
        return
    from symcheck.export.coq.script import Script

    values, full = Values(), definitions.unfolded
    slopes = (full(t) for each in spoken for t in subterms(each) if isinstance(t, list) and t[0] == "diff")
    spoken = [*spoken, *(Terms({}).derived(*slope[1:]) for slope in slopes)]
    known = [full(f) for _, f in hypotheses if f[0] in ("!=", "<", ">")]
    gaps = [["+", left, ["-", right]] for _, left, right in known]
    found: list[Any] = []
    probe = Script(Statement((), (), hypotheses, (), ["and"], definitions))
    for reference, formula in hypotheses:
        probe.assume(formula, reference)
    for divisor in (d for each in spoken for d in denominators(each)):
        term = full(divisor)
        if (
            is_number(term)
            or any(values.ratio(gap, term) for gap in gaps)
            or any(values.ratio(full(d), term) for d in found)
        ):
            continue
        sign = probe.sign(term)
        if sign is None or sign.level < 2:
            found.append(divisor)
    yield from found
