"""What is stated in Coq: the letters, the definitions and hypotheses as premises, the conclusion."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby

from symcheck.checker.rules import Reference
from symcheck.coq.printing import IMPLIES, name, printed
from symcheck.coq.terms import Definitions, NotExported, nodes
from symcheck.core.terms import Call, Formula, Term, node

WIDTH = 118
Hypotheses = tuple[tuple[Reference, Formula], ...]


@dataclass(frozen=True)
class Statement:
    """forall variables, definitions -> hypotheses -> denominators are not zero -> conclusion."""

    variables: tuple[str, ...]
    defined: tuple[str, ...]  # those of the variables that stand for something, in an order to unfold them
    hypotheses: Hypotheses
    premises: tuple[Term, ...]  # denominators about which no hypothesis speaks
    conclusion: Formula
    definitions: Definitions

    @property
    def functions(self) -> dict[str, int]:
        """The unknown functions, with the numbers of their arguments."""
        terms = [self.definitions.terms[x] for x in self.defined]
        said = [*terms, *(formula for _, formula in self.hypotheses), *self.premises, self.conclusion]
        met = dict.fromkeys((each.function, len(each.terms)) for each in nodes(*said) if isinstance(each, Call))
        found = dict(met.keys())
        if len(found) < len(met) or found.keys() & {*self.variables}:
            raise NotExported("an unknown function has the name of a letter, or two numbers of arguments")
        return found

    @property
    def names(self) -> list[str]:
        """All that the statement is about, by its names in Coq."""
        return [name(x) for x in (*self.functions, *self.variables)]

    @property
    def equations(self) -> list[Formula]:
        """What defined letters stand for."""
        return [node("=", x, self.definitions.terms[x]) for x in self.defined]

    @property
    def divided(self) -> list[Formula]:
        """That the denominators are not zero."""
        return [node("!=", divisor, 0) for divisor in self.premises]

    def text(self) -> str:
        """As Coq reads it."""
        lines = [f"{premise(each)} ->" for each in self.equations]
        for label, group in groupby(self.hypotheses, key=lambda hypothesis: hypothesis[0][1]):
            lines += [f"(* {label} *)", *(f"{premise(formula)} ->" for _, formula in group)]
        lines += ["(* where it is divided by *)"] * bool(self.premises)
        lines += [f"{premise(each)} ->" for each in self.divided]
        lines += [printed(self.conclusion, IMPLIES)]
        bound = [f"({name(f)} : {'R -> ' * arity}R)" for f, arity in self.functions.items()]
        shown_letters = " ".join(map(name, self.variables))
        if shown_letters:
            bound.append(f"({shown_letters} : R)" if bound else f"{shown_letters} : R")
        head = [f"forall {' '.join(bound)},"] if bound else []
        return "\n".join(f"  {piece}" for line in [*head, *lines] for piece in folded(line))


def premise(formula: Formula) -> str:
    """What stands before an arrow."""
    return printed(formula, IMPLIES - 1)


def folded(line: str) -> Iterable[str]:
    """A long line in pieces, broken at spaces."""
    while len(line) > WIDTH and (at := line.rfind(" ", 0, WIDTH)) > 0:
        yield line[:at]
        line = "  " + line[at + 1 :]
    yield line
