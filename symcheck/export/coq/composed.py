"""A claim that is proved from earlier relations: they are applied, so that the statement is the claim itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from symcheck.export.coq.printing import name, printed
from symcheck.export.coq.statements import Statement, stated
from symcheck.export.coq.terms import Definitions, NotExported, bound_letters
from symcheck.proof.theorems import conjuncts

if TYPE_CHECKING:
    from symcheck.export.coq.claims import Exported


def composition(
    certificate: Any, step: Statement, lemmas: Sequence[Exported], step_name: str
) -> tuple[Statement, str, list[str]]:
    """The statement without the lemmas as premises, its proof, and the names of the lemmas used."""
    force = [formula for formulas in certificate["under"].values() for formula in formulas]
    own = dict(certificate["definitions"])
    fitting = [
        lemma
        for lemma in lemmas
        if "lemmas" not in lemma.certificate
        and all(f in force for formulas in lemma.certificate["hypotheses"].values() for f in formulas)
        and all(own.get(x, term) == term for x, term in lemma.certificate["definitions"])
    ]
    used: list[Exported] = []
    for part in conjuncts(certificate["claim"][1]):
        source = next((each for each in fitting if part in conjuncts(each.certificate["claim"])), None)
        if source is None:
            raise NotExported("an earlier relation that it rests on is not confirmed")
        if source not in used:
            used.append(source)
    whole = _statement(certificate, step, used)
    return whole, _proof(certificate, step, step_name, whole, used), [each.name for each in used]


def _statement(certificate: Any, step: Statement, used: Sequence[Exported]) -> Statement:
    if _binds(certificate["claim"][2]):
        raise NotExported("a letter is bound in a claim that rests on earlier relations")
    pairs = {x: term for each in used for x, term in each.certificate["definitions"]} | dict(certificate["definitions"])
    hypotheses = list(step.hypotheses)
    premises = list(step.premises)
    spoken = [certificate["claim"][2]]
    for each in used:
        assert each.statement is not None
        known = [formula for _, formula in hypotheses]
        hypotheses += [(reference, f) for reference, f in each.statement.hypotheses if f not in known]
        premises += [divisor for divisor in each.statement.premises if divisor not in premises]
        spoken += [each.certificate["claim"]]
    whole = stated(Definitions([*pairs.items()]), tuple(hypotheses), ["and", *spoken, certificate["claim"][1]], {})
    return Statement(
        whole.variables, whole.defined, whole.hypotheses, tuple(premises), certificate["claim"][2], whole.definitions
    )


def _binds(node: Any) -> bool:
    return isinstance(node, list) and (bool(bound_letters(node)) or any(map(_binds, node[1:])))


def _proof(certificate: Any, step: Statement, step_name: str, whole: Statement, used: Sequence[Exported]) -> str:
    context: dict[str, str] = {}
    lines = [f"intros {' '.join(whole.names)}."]
    for shown in shown_premises(whole):
        context.setdefault(shown, f"h{len(context)}'")
        lines.append(f"intros {context[shown]}.")
    facts: dict[str, str] = {}
    for each in used:
        assert each.statement is not None
        pattern = _pattern(each.certificate["claim"], facts)
        lines.append(
            f"destruct {_applied(f'proof_{each.name}', each.statement, context)} as {pattern}."
            if pattern[0] == "["
            else f"pose proof {_applied(f'proof_{each.name}', each.statement, context)} as {pattern}."
        )
    given = _conjunction(certificate["claim"][1], facts)
    lines.append(f"exact ({_applied(step_name, step, context)} {given}).")
    return "\n".join(lines)


def shown_premises(statement: Statement) -> list[str]:
    """The premises as texts: definitions, hypotheses, denominators."""
    shown = statement.definitions.readable
    texts = [f"{name(x)} = {printed(shown(statement.definitions.terms[x]), 70)}" for x in statement.defined]
    texts += [printed(shown(formula), 98) for _, formula in statement.hypotheses]
    return texts + [f"{printed(shown(divisor), 70)} <> 0" for divisor in statement.premises]


def _applied(theorem: str, statement: Statement, context: dict[str, str]) -> str:
    try:
        given = [context[text] for text in shown_premises(statement)]
        return f"({' '.join([theorem, *statement.names, *given])})"
    except KeyError as premise:
        raise NotExported(f"an earlier relation needs the premise {premise}") from premise


def _pattern(formula: Any, facts: dict[str, str]) -> str:
    if formula[0] == "and" and len(formula) > 1:
        parts = [_pattern(part, facts) for part in formula[1:]]
        return parts[0] if len(parts) == 1 else f"[{' ['.join(parts[:-1])} {parts[-1]}{']' * (len(parts) - 1)}"
    own = f"f{len(facts)}'"
    return facts.setdefault(str(formula), own) if str(formula) not in facts else "_"


def _conjunction(formula: Any, facts: dict[str, str]) -> str:
    if formula[0] == "and":
        parts = [_conjunction(part, facts) for part in formula[1:]]
        shown = parts[-1]
        for part in reversed(parts[:-1]):
            shown = f"(conj {part} {shown})"
        return shown
    return facts[str(formula)]
