"""From a certificate to the statement that its proof shows, with the denominators that have to be premises."""

from __future__ import annotations

from collections.abc import Set

from symcheck.checker.rules import Reference
from symcheck.coq.script import Script
from symcheck.coq.statements import Hypotheses, Statement
from symcheck.coq.terms import Certificate, Definitions, denominators, in_order, is_number, subterms
from symcheck.coq.values import ratio
from symcheck.core.calculus import differentiated
from symcheck.core.terms import Binder, Formula, Relation, Term, node


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
    probe = Script(Statement((), (), hypotheses, (), node("and"), definitions))
    for reference, formula in hypotheses:
        probe.assume(formula, reference)
    known = [full(f) for _, f in hypotheses if f.tag in ("!=", "<", ">")]
    gaps = [node("+", f.terms[0], node("-", f.terms[1])) for f in known if isinstance(f, Relation)]
    found: dict[Term, Term] = {}
    for divisor in denominators(*spoken, *map(differentiated, slopes)):
        term = full(divisor)
        if is_number(term) or any(ratio(each, term) for each in (*gaps, *found.values())):
            continue
        if not probe.positive(term):
            found[divisor] = term
    return [*found]


def resting_on(statement: Statement, references: Set[Reference]) -> Statement:
    """The statement under some of its hypotheses alone."""
    kept = tuple(each for each in statement.hypotheses if each[0] in references)
    return stated(statement.definitions, kept, statement.conclusion, bool(statement.premises))
