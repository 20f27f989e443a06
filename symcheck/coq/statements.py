"""What is stated in Coq: the letters, the definitions and hypotheses as premises, the conclusion."""

from __future__ import annotations

from collections.abc import Iterable, Set
from dataclasses import dataclass
from itertools import groupby

from symcheck.checker.rules import Reference
from symcheck.coq.assumptions import State
from symcheck.coq.printing import IMPLIES, name, printed
from symcheck.coq.signs import positive
from symcheck.coq.terms import Certificate, Definitions, NotExported, denominators, in_order, is_number, nodes, subterms
from symcheck.coq.values import ratio
from symcheck.core.calculus import differentiated
from symcheck.core.terms import Binder, Call, Formula, Relation, Term, node

WIDTH = 118  # of a line, so that it fits a screen of 120 columns
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
        stated = [*terms, *(formula for _, formula in self.hypotheses), *self.premises, self.conclusion]
        met = dict.fromkeys((call.function, len(call.terms)) for call in nodes(*stated) if isinstance(call, Call))
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

    def resting_on(self, references: Set[Reference]) -> Statement:
        """The statement under some of its hypotheses alone."""
        kept = tuple((name, formula) for name, formula in self.hypotheses if name in references)
        return stated(self.definitions, kept, self.conclusion, bool(self.premises))

    def text(self) -> str:
        """As Coq reads it."""
        lines = [f"{premise(formula)} ->" for formula in self.equations]
        for label, group in groupby(self.hypotheses, key=lambda hypothesis: hypothesis[0][1]):
            lines += [f"(* {label} *)", *(f"{premise(formula)} ->" for _, formula in group)]
        lines += ["(* where it is divided by *)"] * bool(self.premises)
        lines += [f"{premise(formula)} ->" for formula in self.divided]
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


def statement(certificate: Certificate) -> Statement:
    """What a certificate of a proof states; what is defined in its lemmas alone stays a letter."""
    free = {x for x, term in certificate["proof"].get("atoms", {}).items() if x == term}
    definitions = Definitions([(name, term) for name, term in certificate["definitions"] if name not in free])
    hypotheses = tuple(
        (("hyp", label, k), definitions.formula(formula))
        for label, formulas in certificate["hypotheses"].items()
        for k, formula in enumerate(formulas)
    )
    return stated(definitions, hypotheses, claimed(certificate, definitions), bool(certificate.get("nonzero")))


def claimed(certificate: Certificate, definitions: Definitions) -> Formula:
    """The claim, or that it follows from the lemmas."""
    claim = definitions.formula(certificate["claim"])
    lemmas = [definitions.formula(formula) for _, formula in certificate.get("lemmas", ())]
    return node("=>", node("and", *lemmas), claim) if lemmas else claim


def stated(definitions: Definitions, hypotheses: Hypotheses, claim: Formula, divides: bool = False) -> Statement:
    """The statement with the letters that occur in it, definitions in an order in which each uses earlier ones."""
    shown = [claim, *(formula for _, formula in hypotheses)]
    defined: list[str] = []

    def need(*trees: Term) -> None:
        for x in in_order(*trees):
            if x in definitions.terms and x not in defined:
                need(definitions.terms[x])
                defined.append(x)

    need(*shown)
    spoken = [*shown, *(definitions.terms[x] for x in defined)]
    premises = tuple(unsettled(definitions, hypotheses, spoken)) if divides else ()
    return Statement(tuple(in_order(*spoken, *defined)), tuple(defined), hypotheses, premises, claim, definitions)


def unsettled(definitions: Definitions, hypotheses: Hypotheses, spoken: list[Term]) -> list[Term]:
    """The denominators of a statement that no hypothesis, and no sign, shows not to vanish."""
    full = definitions.unfolded
    slopes = [full(t) for t in subterms(*spoken) if isinstance(t, Binder) and t.tag == "diff"]
    probe = State(definitions, set())
    for reference, formula in hypotheses:
        probe.assume(formula, reference)
    known = [full(f) for _, f in hypotheses if f.tag in ("!=", "<", ">")]
    gaps = [node("+", f.terms[0], node("-", f.terms[1])) for f in known if isinstance(f, Relation)]
    found: dict[Term, Term] = {}
    for divisor in denominators(*spoken, *map(differentiated, slopes)):
        term = full(divisor)
        if is_number(term) or any(ratio(other, term) for other in (*gaps, *found.values())):
            continue
        if not positive(probe, term):
            found[divisor] = term
    return [*found]
