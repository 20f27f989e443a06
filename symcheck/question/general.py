"""What a relation says in general that is printed for a quantity c that is 1, proved.

The general form has terms that measure the same, and with c = 1 it is what is printed. So its definitions and
hypotheses are those that are printed, of x / c^k instead of x: for each letter the power of c that takes one base
quantity out of its unit. The form is proved anew from these, and its certificate states all of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from itertools import chain
from typing import NamedTuple

from symcheck.audit.context import Context
from symcheck.audit.judge import judge, units
from symcheck.audit.obligation import obligation_of
from symcheck.checker import check
from symcheck.core.calculus import functions, letters, substituted
from symcheck.core.certificates import Certificate
from symcheck.core.claims import Assertion
from symcheck.core.ids import Id
from symcheck.core.problems import Problem
from symcheck.core.terms import Formula, Term, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.core.words import term as words
from symcheck.dimensions import CONSISTENT, Known, Scale, dimensions, inferred
from symcheck.dimensions.general import general, plain
from symcheck.dimensions.rules import Rules, is_base, ratio
from symcheck.proof import certificate as certificate_of
from symcheck.proof.rules.proof import Proof
from symcheck.proof.search.carried import carried
from symcheck.proof.search.methods import whole_proof
from symcheck.question.answer import General
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.measured import known_of
from symcheck.question.prepare import Asked, plainly, readings, with_scopes
from symcheck.reading.measures import measures, scales

LIMIT = 10.0  # seconds; nearly all forms take as long as what is printed
Decide = Callable[[Problem], tuple[Verdict, Certificate | None, tuple[str, ...]]]


def in_general(asked: Asked, said: Mapping[str, str], decide: Decide) -> General | None:
    """The general form of a relation that is printed for a quantity that is 1, with its proofs; None if there is none.

    Parameters
    ----------
    asked
        What is proved as it is printed.
    said
        The units of its letters and of the quantity: ``{"E": "J", "m": "kg", "c": "m/s = 1"}``.
    decide
        What decides a problem, and has its certificate checked.
    """
    with suppress(SymcheckError, OutOfTime), limited(LIMIT):
        printed = with_scopes(plainly(asked))
        several = readings(printed)
        several = [each for each in several if not each.inference.remote] or several
        found = [_proved(each.problems, *known_of(printed, said, each.inference.notation), decide) for each in several]
        return found[0] if all(found) else None
    return None


def of_relation(id: str, decide: Decide) -> General | None:
    """The same of a relation of a paper, by its id: by the units and definitions of the paper."""
    place, item = Id.parse(id), obligation_of(str(Id.parse(id).declaration))
    if not isinstance(item.item, Assertion) or item.item.question:
        return None
    context = Context(item.paper, item.item)
    with suppress(SymcheckError, OutOfTime), limited(LIMIT):
        for unit in units(context):
            if unit.letter == place.link:
                found = judge(context, unit, item.item.statement.given)
                if found.verdict is not Verdict.PROVED:
                    return None
                printed = {problem: o.proof for problem, o in zip(found.problems, found.outcomes, strict=True)}
                known = measures(context.notation), scales(context.notation)
                return _proved(found.concrete, *known, decide, printed.get)
    return None


def _proved(
    every: Sequence[Problem],
    known: Known,
    ones: Sequence[Scale],
    decide: Decide,
    proof_of: Callable[[Problem], Proof | None] = whole_proof,
) -> General | None:
    """The general forms of problems, if all of them are proved: by themselves, or by the proof of what is printed."""
    if len(ones) != 1:
        return None
    made, forms = list[Certificate](), list[Formula]()
    meant = [_general(each, known, ones[0]) for each in every]
    if all(form is None or form.problem.claim == each.claim for form, each in zip(meant, every, strict=True)):
        return None
    for each, form in zip(every, meant, strict=True):
        if form is None:
            return None
        verdict, certificate, _ = decide(form.problem)
        if verdict is not Verdict.PROVED:
            certificate = _carried(proof_of(each), each, form)
        if certificate is None:
            return None
        made.append(certificate)
        forms.append(form.problem.claim)
    return General("; ".join(words(form) for form in forms), tuple(made))


class _Form(NamedTuple):
    """What is to be proved in general, and what the letters of what is printed are in its letters."""

    problem: Problem
    mean: Mapping[str, Term]


def _carried(proof: Proof | None, printed: Problem, form: _Form) -> Certificate | None:
    """The certificate by the proof of what is printed, if the checker accepts it."""
    outcome = None if proof is None else carried(proof, printed, form.mean, form.problem)
    if outcome is None:
        return None
    made = certificate_of(form.problem, outcome)
    return made if check(made) is None else None


def _general(problem: Problem, known: Known, scale: Scale) -> _Form | None:
    """The problem for any value of the quantity; None if it takes no power of it, or nobody knows which."""
    one = plain(scale.letter)
    defined = dict(problem.definitions)
    assumed = [formula for _, formulas in problem.hypotheses for formula in formulas]
    every = [problem.claim, *assumed, *defined.values()]
    if any(map(functions, every)) or one in defined or any(one in letters(each) for each in every):
        return None
    rules = Rules(known)
    rules.state(problem.claim)
    claim = next(iter(general([problem.claim], rules, scale)), None)
    if claim is None:
        return None
    forms = {**known, one: scale.form}
    for each in (claim, *assumed, *(node("=", name, value) for name, value in problem.definitions)):
        forms |= {name: form for name, form in inferred([each], forms).items() if name not in forms}
    if dimensions([claim], forms).verdict != CONSISTENT:
        return None
    powers = _powers(chain(*map(letters, every), defined), forms, scale)
    if powers is None:
        return None
    smaller: dict[str, Term] = {x: _times(one, -k, x) for x, k in powers.items() if k}
    whole = Problem(
        problem.id,
        claim,
        tuple((name, _times(one, powers[name], substituted(value, smaller))) for name, value in problem.definitions),
        (
            *((name, tuple(_assumed(f, smaller) for f in formulas)) for name, formulas in problem.hypotheses),
            (f"{one} > 0", (node(">", one, 0),)),
        ),
    )
    return _Form(whole, {x: term for x, term in smaller.items() if x not in defined})


def _powers(names: Iterable[str], forms: Known, scale: Scale) -> dict[str, int] | None:
    """How often the quantity is in each letter, by one base quantity of its unit; None if it is no whole number."""
    every = {name: forms.get(name) for name in names}
    for base in filter(is_base, scale.form):
        found: dict[str, int] = {}
        for name, form in every.items():
            power = None if form is None else ratio(form.get(base, 0), scale.form[base])
            if not isinstance(power, int):
                break
            found[name] = power
        else:
            return found
    return None


def _times(one: str, power: int, term: Term) -> Term:
    """A term times a power of the quantity."""
    if not power:
        return term
    factor = one if abs(power) == 1 else node("^", one, abs(power))
    return node("*", factor, term) if power > 0 else node("/", term, factor)


def _assumed(formula: Formula, smaller: Mapping[str, Term]) -> Formula:
    """A hypothesis of smaller letters; whether a letter is positive, or 0, stays as it is."""
    if formula.terms and 0 in formula.terms and all(isinstance(each, str | int) for each in formula.terms):
        return formula
    return substituted(formula, smaller)
