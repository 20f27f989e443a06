"""From the proof of a certificate to a proof script of Coq, rule by rule as in `symcheck/checker/rules.py`.

The script says everything (cofactors, forms, which fact has which sign), so that Coq searches for nothing. What this
module gets wrong does not compile.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import reduce
from math import lcm, prod
from typing import NamedTuple

from symcheck.checker.rules import Reference
from symcheck.coq.assumptions import State, pattern
from symcheck.coq.functions import (
    OPAQUE,
    add_facts,
    equate_functions,
    keep_nonzero,
    prove_nonzero,
    show_divisors,
    show_nonzero,
    work_out_derivatives,
)
from symcheck.coq.printing import name, spelled
from symcheck.coq.signs import positive, sign
from symcheck.coq.statements import Statement
from symcheck.coq.terms import Certificate, NotExported, denominators, nodes, polynomial, product, subterms
from symcheck.coq.theorems import Application, missing
from symcheck.coq.values import printed_ratio, ratio
from symcheck.core import calculus
from symcheck.core.calculus import substituted
from symcheck.core.formulas import FALSE, contrary
from symcheck.core.terms import FORMULAS, JSON, Connective, Formula, Node, Quantified, Term, Value, node

BY_CONTRADICTION = {
    "!=": "", "<": "apply Rnot_ge_lt. ", "<=": "apply Rnot_gt_le. ",
    ">": "apply Rnot_le_gt. ", ">=": "apply Rnot_lt_ge. ",
}  # fmt: skip
ORDERS = {"<": "combine_lt", "<=": "combine_le", ">": "combine_lt", ">=": "combine_ge"}
HYPOTHESIS = re.compile(r"\bh\d+'")  # the names that `State.assume` gives
Rule = Callable[[State, Formula, Certificate], None]
RULES: dict[str, Rule] = {}


def rule(name: str) -> Callable[[Rule], Rule]:
    """Enters what writes the steps of a rule into the table."""

    def enter(write: Rule) -> Rule:
        RULES[name] = write
        return write

    return enter


class Script(NamedTuple):
    """A proof, and the hypotheses of the statement that it makes use of."""

    text: str
    rests_on: set[Reference]


def script(statement: Statement, certificate: Certificate) -> Script:
    """The proof of a statement from the certificate that it was made of."""
    proof = certificate["proof"]
    if reason := missing(proof):
        raise NotExported(reason)
    state = State(statement.definitions, {*statement.variables})
    if statement.names:
        state.emit(f"intros {' '.join(statement.names)}.")
    for x in statement.defined:
        definition = state.anew("d")
        state.emit(f"intros {definition}. subst {name(x)}.")
    for reference, formula in statement.hypotheses:
        state.emit(f"intros {state.assume(formula, reference)}.")
        state.turn_orders()
    state.hypotheses = len(state.known)
    goal = _prepare(state, statement, proof)
    for data in certificate.get("nonzero", ()):
        match state.read(data):
            case Value(tag="/", terms=(top, below)):
                state.listed.append((top, below))
    prove(state, goal, proof)
    lines = [*filter(None, state.lines)]
    not_used = ("intros h", "apply Rge_le in")
    used = {name for line in lines if not line.startswith(not_used) for name in HYPOTHESIS.findall(line)}
    return Script("\n".join(lines), {name for name, known in state.known.items() if known.hypothesis in used})


def _prepare(state: State, statement: Statement, proof: Certificate) -> Formula:
    """What is said before the proof begins: of functions, of derivatives, and of all that is divided by; the goal."""
    goal = state.full(statement.conclusion)
    facts = [known.formula for known in state.known.values()]
    spoken: list[Term] = [goal, *facts, *(_mentioned_tree(state, data) for data in mentioned(proof))]
    spoken += [known.sides[0] for known in state.facts(">")]
    state.divides = any(calculus.divisor(part) != 1 or part.tag in ("sqrt", "arctan") for part in nodes(*spoken))
    premises = [(state.anew("n"), state.full(divisor)) for divisor in statement.premises]
    for premise, _ in premises:
        state.emit(f"intros {premise}.")
    stated = [*(f for _, f in statement.hypotheses), statement.conclusion, *state.definitions.terms.values()]
    if any(part.tag == "tan" for part in nodes(*stated)):
        state.emit("unfold tan in *.")
    if any(part.tag in ("diff", "sin", "cos", "call", *OPAQUE) for part in nodes(*spoken)):
        state.emit("unfold Rminus in *.")
    add_facts(state, spoken)
    equate_functions(state, [t for t in subterms(*spoken) if not [*denominators(t)]])
    for premise, divisor in premises:
        keep_nonzero(state, divisor, premise)
    work_out_derivatives(state, spoken)
    if state.rewritten:
        goal, spoken = state.worked(goal), [*map(state.worked, spoken)]
        state.known = {n: known._replace(formula=state.worked(known.formula)) for n, known in state.known.items()}
    show_divisors(state, spoken)
    equate_functions(state, spoken)
    return goal


def _mentioned_tree(state: State, data: JSON) -> Term:
    is_formula = isinstance(data, list) and data[0] in FORMULAS
    return state.read_formula(data) if is_formula else state.read(data)


def mentioned(proof: JSON) -> Iterator[JSON]:
    """The terms and formulas that a proof brings in: forms, points, positive factors, what theorems speak of."""
    match proof:
        case ["positive", term]:
            yield term
        case list():
            for part in proof:
                yield from mentioned(part)
        case dict():
            for entry in proof.items():
                match entry:
                    case "form" | "formula", data:
                        yield data
                    case "positive", list(listed):
                        yield from listed
                    case "atoms" | "point" | "numbers" | "with", dict(named):
                        yield from (data["term"] if isinstance(data, dict) else data for data in named.values())
                    case _, data:
                        yield from mentioned(data)


def prove(state: State, goal: Formula, proof: Certificate) -> None:
    """One step of the proof, and with it the steps above it; NotExported for a rule that is not in the table."""
    if proof["rule"] not in RULES:
        raise NotExported(f"the rule {proof['rule']}")
    kept = state.atoms
    if "atoms" in proof:
        state.atoms = {x: state.read(term) for x, term in proof["atoms"].items()}
    for term in map(state.read, proof.get("positive", ())):
        if spelled(term) not in state.nonzero and (fact := positive(state, term)):
            prove_nonzero(state, term, f"exact (pos_nz {fact})")
    RULES[proof["rule"]](state, goal, proof)
    state.atoms = kept


def branch(state: State, goal: Formula, proof: Certificate) -> None:
    """A separate subgoal."""
    with state.inside():
        prove(state, goal, proof)


def combination(state: State, proof: Certificate) -> str:
    """Proofs that the multiplier is not zero, and that the sum of cofactors times facts is zero."""
    apart = [_factor(state, data) for data in proof.get("times", ())]
    rows = []
    for data, *texts in proof["cofactors"]:
        polynomials = [polynomial(text, state.atoms) for text in texts]
        rows.append((state.fact(data, ("=",)), [p for p, _ in polynomials], prod(scale for _, scale in polynomials)))
    scale = lcm(*(denominator for *_, denominator in rows))
    if scale > 1:
        apart.append(f"(num_nz {scale})")
    multiplier = reduce(lambda one, other: f"(mul_nz {one} {other})", apart or ["one_nz"])
    facts = [
        f"(fact ({spelled(product([scale // denominator, *cofactors]))}) {known.hypothesis})"
        for known, cofactors, denominator in rows
    ]
    total = reduce(lambda rest, fact: f"(and_fact {fact} {rest})", reversed(facts or ["no_facts"]))
    return f"{multiplier} {total}"


def combined(state: State, goal: Formula, proof: Certificate, stem: str) -> str:
    """An auxiliary equation that is a combination of facts; its name."""
    return state.prove_aside(goal, stem, f"refine (combine {combination(state, proof)} _); {state.algebra}")


def _factor(state: State, data: JSON) -> str:
    """A proof that a factor of the multiplier is not zero."""
    match data:
        case str():
            return _cleared(state, data)
        case ["positive", term]:
            if fact := positive(state, state.read(term)):
                return f"(pos_nz {fact})"
            raise NotExported("a factor that is not manifestly positive")
    return state.fact(data, ("!=", ">")).apart


def _cleared(state: State, text: str) -> str:
    """A proof that a polynomial by which the equation is multiplied is not zero."""
    term, _ = polynomial(text, state.atoms)
    if known := state.nonzero.get(spelled(term)):
        return known[0]
    if proof := show_nonzero(state, term):
        return proof
    for top, below in state.listed:
        if ratio(top, term) is not None:
            for fact, other in list(state.nonzero.values()):
                if (k := ratio(node("*", other, below), term)) is not None:
                    factor = f"{printed_ratio(k)} * ({spelled(node('/', 1, below))})"
                    return prove_nonzero(state, term, f"apply (nz_of ({factor}) {fact}); {state.algebra}")
    raise NotExported(f"the factor {spelled(term)} is not shown to differ from zero")


@rule("identity")
def _identity(state: State, goal: Formula, proof: Certificate) -> None:
    if proof["cofactors"] or proof.get("times"):
        state.emit(f"refine (combine {combination(state, proof)} _). {state.algebra}.")
    else:
        state.emit(f"{state.algebra}.")


@rule("nonnegative")
def _nonnegative(state: State, goal: Formula, proof: Certificate) -> None:
    form, strict = state.read(proof["form"]), len(goal.tag) == 1
    found = sign(state, form)
    if found is None or (strict and found.level < 2):
        raise NotExported("a form whose sign is not manifest")
    combined = combination(state, proof)
    # the form is written down, as its sign may have been shown of another shape of it
    lemma = f"{ORDERS[goal.tag]} (f := {spelled(form)}) {found.proof if strict else found.weak}"
    state.emit(f"refine ({lemma} {combined} _). {state.algebra}.")


@rule("implies")
def _implies(state: State, goal: Formula, proof: Certificate) -> None:
    match goal:
        case Connective(formulas=(premise, conclusion)):
            state.emit(f"intros {state.assume(premise)}.")
        case _:
            conclusion = FALSE
            state.emit(f"{BY_CONTRADICTION[goal.tag]}intros {state.assume(contrary(goal))}.")
    state.turn_orders()
    prove(state, conclusion, proof["then"])


@rule("each")
def _conjunction(state: State, goal: Formula, proof: Certificate) -> None:
    parts = goal.formulas
    if goal.tag == "<=>":
        parts = node("=>", *parts), node("=>", *reversed(parts))
    for k, (part, inner) in enumerate(zip(parts, proof["parts"], strict=True)):
        if k < len(parts) - 1:
            state.emit("split.")
        branch(state, part, inner)
    if not parts:
        state.emit("exact I.")


@rule("choose")
def _choose(state: State, goal: Formula, proof: Certificate) -> None:
    index, last = proof["index"], len(goal.formulas) - 1
    state.emit("right. " * index + ("left." if index < last else ""))
    prove(state, goal.formulas[index], proof["then"])


@rule("cases_or")
def _cases_or(state: State, goal: Formula, proof: Certificate) -> None:
    known = state.fact(proof["or"], ("or",))
    hypothesis, parts = known.hypothesis, known.formula.formulas
    for k, (part, inner) in enumerate(zip(parts, proof["cases"], strict=True)):
        rest = case = state.anew("c")
        if k < len(parts) - 1:
            state.emit(f"destruct {hypothesis} as [{rest}|{rest}].")
        else:
            case = hypothesis
        with state.inside():
            pattern = state.assume(part)
            state.emit(f"destruct {case} as {pattern}." if pattern[0] == "[" else f"rename {case} into {pattern}.")
            state.turn_orders()
            prove(state, goal, inner)
        hypothesis = rest


@rule("split")
def _split(state: State, goal: Formula, proof: Certificate) -> None:
    form = state.read(proof["form"])
    powers = [power for power in form.outside if isinstance(power, Node)] if isinstance(form, Node) else []
    bases = [(base, exponent) for base, exponent in (power.terms for power in powers) if isinstance(exponent, int)]
    if not bases:
        raise NotExported("a product of nothing")
    state.divides = state.divides or any(isinstance(t, Node) and t.tag == "/" for t in subterms(*powers))
    whole = reduce(lambda rest, power: node("*", power, rest), reversed(powers))
    product = combined(state, node("=", whole, 0), proof, "p")
    for k, ((base, exponent), inner) in enumerate(zip(bases, proof["cases"], strict=True)):
        fact = state.anew("h")
        if k < len(bases) - 1:
            rest = state.anew("p")
            state.emit(f"destruct (first_zero {exponent} {product}) as [{fact}|{rest}].")
            product = rest
        else:
            state.emit(f"pose proof (pow_zero {exponent} {product}) as {fact}.")
        with state.inside():
            state.learn(node("=", base, 0), fact)
            prove(state, goal, inner)


@rule("vanish")
def _vanish(state: State, goal: Formula, proof: Certificate) -> None:
    form = state.read(proof["form"])
    assert isinstance(form, Value)
    addends = form.terms
    names = [combined(state, node("=", form, 0), proof, "v")]
    for k in range(len(addends) - 1, 0, -1):
        front, last = sign(state, node("+", *addends[:k])), sign(state, addends[k])
        if front is None or last is None:
            raise NotExported("an addend that is not manifestly not negative")
        rest, zero = state.anew("v"), state.anew("h")
        state.emit(f"destruct (vanish_both {front.weak} {last.weak} {names[0]}) as [{rest} {zero}].")
        names = [rest, zero, *names[1:]]
    for addend, zero in zip(addends, names, strict=True):
        state.learn(node("=", addend, 0), zero)
    prove(state, goal, proof["then"])


@rule("absurd")
def _absurd(state: State, goal: Formula, proof: Certificate) -> None:
    state.emit(f"exfalso. refine (combine_false {combination(state, proof)} _). {state.algebra}.")


@rule("witness")
def _witness(state: State, goal: Formula, proof: Certificate) -> None:
    assert isinstance(goal, Quantified)
    point = {x: state.read(term) for x, term in proof["point"].items()}
    for x in goal.bound:
        state.emit(f"exists ({spelled(point[x])}).")
    body = substituted(goal.body, point)
    add_facts(state, [body])
    prove(state, body, proof["then"])


@rule("every")
def _every(state: State, goal: Formula, proof: Certificate) -> None:
    body = _opened(state, goal, proof["letters"])
    state.emit(f"intros {' '.join(map(name, proof['letters']))}.")
    add_facts(state, [body])
    work_out_derivatives(state, [body])
    prove(state, state.worked(body), proof["then"])


def _opened(state: State, formula: Formula, new: Sequence[str]) -> Formula:
    """The body with new letters for those bound."""
    assert isinstance(formula, Quantified)
    state.scope.update(new)
    return substituted(formula.body, dict(zip(formula.bound, new, strict=True)))


@rule("have")
def _have(state: State, goal: Formula, proof: Certificate) -> None:
    formula = state.read_formula(proof["formula"])
    fact = _asserted(state, formula, proof["proof"])
    _learn(state, formula, f"exact {fact}")
    prove(state, goal, proof["then"])


@rule("theorem")
def _theorem(state: State, goal: Formula, proof: Certificate) -> None:
    theorem = Application(state, proof)
    pairs = zip(theorem.premises, proof["premises"], strict=True)
    facts = [_asserted(state, premise, inner) for premise, inner in pairs]
    _learn(state, theorem.conclusion, theorem.by(facts), proof.get("letters", []))
    prove(state, goal, proof["then"])


def _asserted(state: State, formula: Formula, proof: Certificate) -> str:
    """The name of a formula that is proved here."""
    fact = state.anew("t")
    state.emit(f"assert ({fact} : {spelled(formula)}).")
    branch(state, formula, proof)
    return fact


def _learn(state: State, conclusion: Formula, by: str, new: Sequence[str] = ()) -> None:
    """One more assumption, with its proof; what it says to exist gets new letters."""
    equate_functions(state, [conclusion])
    fact = _opened(state, conclusion, new) if new else conclusion
    state.emit(f"assert ({spelled(conclusion)}) as {pattern([*map(name, new), state.assume(fact)])} by ({by}).")
    add_facts(state, [fact] if new else [])
    state.turn_orders()
