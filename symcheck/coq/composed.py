"""A claim that is proved from earlier relations: they are applied, so that the statement is the claim itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce
from typing import TYPE_CHECKING

from symcheck.coq.assumptions import pattern
from symcheck.coq.statements import Statement, premise, stated
from symcheck.coq.terms import Certificate, Definitions, NotExported, nodes
from symcheck.core.formulas import conjuncts
from symcheck.core.terms import Connective, Formula, node

if TYPE_CHECKING:
    from symcheck.coq.claims import Claim


def composition(
    certificate: Certificate, step: Statement, lemmas: Sequence[Claim], step_name: str
) -> tuple[Statement, str, list[str]]:
    """The statement without the lemmas as premises, its proof, and the names of the lemmas used."""
    assert isinstance(step.conclusion, Connective)
    given, claim = step.conclusion.formulas
    if any(part.bound for part in nodes(claim)):
        raise NotExported("a letter is bound in a claim that rests on earlier relations")
    force = [formula for formulas in certificate["hypotheses"].values() for formula in formulas]
    defined = dict(certificate["definitions"])
    fitting = [
        (lemma, lemma.statement)
        for lemma in lemmas
        if lemma.statement
        and "lemmas" not in lemma.certificate
        and all(f in force for formulas in lemma.certificate["hypotheses"].values() for f in formulas)
        and all(defined.get(x, term) == term for x, term in lemma.certificate["definitions"])
    ]
    used: dict[str, Statement] = {}
    earlier: Certificate = {}  # what is defined in them
    for part in conjuncts(given):
        source = next((pair for pair in fitting if part in conjuncts(pair[1].conclusion)), None)
        if source is None:
            raise NotExported("an earlier relation that it rests on is not confirmed")
        used[source[0].name] = source[1]
        earlier |= dict(source[0].certificate["definitions"])
    pairs = [(x, term) for x, term in earlier.items() if x not in defined]
    pairs += [(x, term) for x, term in defined.items() if x in earlier or x in step.definitions.terms]
    hypotheses, premises = list(step.hypotheses), list(step.premises)
    for lemma in used.values():
        known = [formula for _, formula in hypotheses]
        hypotheses += [(reference, f) for reference, f in lemma.hypotheses if f not in known]
        premises += [divisor for divisor in lemma.premises if divisor not in premises]
    spoken = node("and", claim, *(lemma.conclusion for lemma in used.values()), given)
    whole = stated(Definitions(pairs), tuple(hypotheses), spoken)
    whole = replace(whole, premises=tuple(premises), conclusion=claim)
    return whole, _proof(given, step, step_name, whole, used), [*used]


def _proof(given: Formula, step: Statement, step_name: str, whole: Statement, used: dict[str, Statement]) -> str:
    context: dict[str, str] = {}
    lines = [f"intros {' '.join(whole.names)}."]
    for text in printed_premises(whole):
        context.setdefault(text, f"h{len(context)}'")
        lines.append(f"intros {context[text]}.")
    facts: dict[Formula, str] = {}
    for name, lemma in used.items():
        names = _pattern(lemma.conclusion, facts)
        tactic = "destruct" if names[0] == "[" else "pose proof"
        lines.append(f"{tactic} {_applied(f'proof_{name}', lemma, context)} as {names}.")
    lines.append(f"exact ({_applied(step_name, step, context)} {_conjunction(given, facts)}).")
    return "\n".join(lines)


def printed_premises(statement: Statement) -> list[str]:
    """The premises as texts: definitions, hypotheses, denominators."""
    hypotheses = [formula for _, formula in statement.hypotheses]
    return [premise(formula) for formula in (*statement.equations, *hypotheses, *statement.divided)]


def _applied(theorem: str, statement: Statement, context: dict[str, str]) -> str:
    try:
        given = [context[text] for text in printed_premises(statement)]
        return f"({' '.join([theorem, *statement.names, *given])})"
    except KeyError as premise:
        raise NotExported(f"an earlier relation needs the premise {premise}") from premise


def _pattern(formula: Formula, facts: dict[Formula, str]) -> str:
    if isinstance(formula, Connective) and formula.tag == "and" and formula.formulas:
        return pattern([_pattern(part, facts) for part in formula.formulas])
    own = f"f{len(facts)}'"
    return facts.setdefault(formula, own) if formula not in facts else "_"


def _conjunction(formula: Formula, facts: dict[Formula, str]) -> str:
    if isinstance(formula, Connective) and formula.tag == "and":
        *front, last = (_conjunction(part, facts) for part in formula.formulas)
        return reduce(lambda shown, part: f"(conj {part} {shown})", reversed(front), last)
    return facts[formula]
