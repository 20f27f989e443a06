"""`symcheck.decide`: the verdict on one formula."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cache, partial
from itertools import islice, permutations, product
from math import factorial

from symcheck.checker import check
from symcheck.core.calculus import Unknown, functions, letters, nodes, substituted
from symcheck.core.certificates import Certificate
from symcheck.core.formulas import conjuncts
from symcheck.core.problems import Outcome, Problem
from symcheck.core.terms import JSON, End, Node, T, Term, mapped, node
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.core.words import term
from symcheck.proof import certificate, identity, proof_of
from symcheck.proof.algebra.knowledge import ORDERS, larger_first
from symcheck.proof.algebra.polynomial import Unsupported, number_of
from symcheck.proof.rules.compute import Point
from symcheck.proof.search.decide import UNSETTLED
from symcheck.proof.search.number_points import refute_at, refute_at_corners, refute_at_some
from symcheck.proof.search.wellformed import checked
from symcheck.question import (
    bases,
    by_parts,
    events,
    expectations,
    generating,
    growth,
    indices,
    interchange,
    iterated,
    jets,
    known_integrals,
    named,
    orders,
    orthogonal,
    power_series,
    principal,
    series,
    special,
    squares,
)
from symcheck.question.answer import Answer, Status
from symcheck.question.antiderivatives import hinted
from symcheck.question.conventions import constant, mentioned
from symcheck.question.data import with_sums_of_powers
from symcheck.question.divisors import with_plain_divisors
from symcheck.question.doubts import (
    braced,
    defines,
    doubt,
    doubt_of_proofs,
    held,
    spelled_function,
    with_arguments_above,
    with_longer_arguments,
    with_swapped_angles,
)
from symcheck.question.equations import EQUATION, relates
from symcheck.question.factors import with_factors_outside
from symcheck.question.fields import in_fields
from symcheck.question.floors import Whole, with_whole_numbers
from symcheck.question.general import in_general
from symcheck.question.hypergeometric import Summation, added_up, without_gammas, worked_out
from symcheck.question.initial_values import transformed
from symcheck.question.inverses import refuted as refuted_in_exponents
from symcheck.question.inverses import with_exponents
from symcheck.question.kronecker import SIGN, is_of_matrices, without_products
from symcheck.question.limit import OutOfTime, limited
from symcheck.question.matrices import (
    Contradiction,
    OfAnySize,
    covers,
    false_gradients,
    oblong,
    of_any_size,
    open_matrices,
)
from symcheck.question.measured import ONE, measured
from symcheck.question.measured import checked as checked_units
from symcheck.question.parts_of_turns import with_parts_of_turns
from symcheck.question.prepare import (
    DEFINED,
    VARIABLES,
    Asked,
    Reading,
    Understood,
    apart,
    from_zero,
    in_order,
    plainly,
    readings,
    sizes,
    unlowered,
    with_differentials,
    with_each_sign,
    with_entries,
    with_numbers,
    with_primes,
    with_scopes,
    with_whole_ends,
    worded,
)
from symcheck.question.recurrences import FIRST, Induction, induction, with_sequences, with_sums
from symcheck.question.repairs import explained, repairs
from symcheck.question.roots import rooted
from symcheck.question.running import needed, signs
from symcheck.question.solutions import with_solutions
from symcheck.question.unsolved import is_condition, may_be_solved
from symcheck.question.whole import with_half_turns
from symcheck.question.whole_powers import inlined, with_whole_powers
from symcheck.reading import Tree, tex, with_brackets
from symcheck.reading.inference import NUMBERS, VECTORS, Inference
from symcheck.reading.notation import SAID
from symcheck.reading.tree import BigSum, Call, Chain, Name, walk

LIMIT = 6.0  # seconds for one component of a relation; nearly all that are found at all are found in one
DIGITS = 4.0  # seconds for a counterexample by digits: a false relation mostly fails at the first points
CORNERS = 3.0  # seconds for one where vectors are units, before a proof is sought: it takes a third if there is one
TOTAL = 15.0  # seconds for all of them
ALL_SIZES = 2.0  # seconds for a proof about matrices of all sizes: those that are found take less than one
KUMMER = "Kummer function"
REFUSED = "the certificate was not accepted"
DEFINITION = "it says what something is that occurs nowhere else: a definition, which is neither true nor false"
LONGER = "do letters behind the brackets of a function belong to its argument? write brackets around all of it"
LAYOUT = "it may hold if derivatives by a matrix are laid out transposed; write its transpose"
SWAPPED = "which argument of atan2 is the height? it does not fail where the first one is the width"
TURNED = "are arguments of complex numbers from -pi to pi, or from 0 to 2 pi? it depends on that"
SQUARE = (
    "it holds for square matrices; are they? say how many rows and columns they have: A \\in \\mathbb{R}^{m \\times n}"
)
ORDER_OF_SLOPES = "a whole number (the order of a derivative)"
UP_TO = "a whole number (a sum or product runs up to it)"
SYMMETRIC = 1.0  # seconds for proofs of what is refuted, for symmetric matrices; most are found in a tenth
MOST_SYMMETRIC = 4  # matrices of which each alone is taken to be symmetric, if not all can be
CROSS = "is \\times a product of numbers, or of vectors? say what the letters beside it are"
UNTOLD = Verdict.UNDECIDED, None, ()
_SYMBOL = re.compile(r"\\delta_\{?[i-n]{2}\}?|\\(?:var)?epsilon_\{?[i-n]{3}\}?")  # with the usual letters of indices
WHOLE = (1, 2, 0, 3, -1)  # tried for a letter: most false formulas fail for one of them
ENOUGH = (2, 3, 5)  # values that settle an identity between polynomials of the degrees that are printed: at most two
USUALLY_WHOLE = frozenset({"k", "m", "n"})  # letters of which nobody may say that they are whole numbers
FACTORIALS = range(1, 9)  # whole numbers of which the gamma function is worked out
WORKED_OUT = ("integral", "sum", "product", "gamma")  # what is simpler where its letters are numbers
NUMBERS_TRIED = (1, 2, -1)  # exponents too, for which integrals have primitives
FEW = 3  # letters: of more there are too many numbers to try
AT_NUMBERS = 3.0  # seconds for all of them
ROOTS = ("sqrt", "pow", "log")  # what has values for positive numbers
MOST_WHOLE = 25  # of two letters all pairs
UNEQUAL = ((2, 3), (3, 2))  # numbers of rows and columns, tried where those that are equal tell nothing
SIZES = (1, 2, 3)  # one is found to be false for a small one, if at all


def decide(
    relation: str,
    where: Iterable[str] | str = (),
    given: Iterable[str] | str = (),
    letters: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
) -> Answer:
    r"""Decide one formula, without a paper and without declarations.

    Parameters
    ----------
    relation
        The formula, in LaTeX: an equation, an inequality, or a chain of them.
    where
        Definitions and earlier equations: solved for a letter they say what it is, otherwise they are assumed.
    given
        Conditions, such as ``"x > 0"`` or ``r"n \in \mathbb{N}"``.
    letters
        What letters are, where that is not to be inferred: ``{"f": "function of x", r"\omega": "vector"}``.
    units
        What letters measure, for the verdict on dimensions: ``{"F": "N", "m": "kg"}``; ``{"c": "m/s = 1"}`` for a
        quantity that is not printed because it is 1.

    Returns
    -------
    Answer
        The verdict with its evidence. What cannot be read is an answer too, with the reason.

    Raises
    ------
    SymcheckError
        If a unit is none, or of a letter that does not occur.

    See Also
    --------
    check : The audit of whole papers.

    Examples
    --------
    >>> from symcheck import decide
    >>> decide(r"\sin 2a = 2 \sin a \cos a").verdict
    <Status.PROVED: 'proved'>
    >>> decide(r"\ln x = x", given="x > 0").counterexample
    {'x': '1'}
    >>> decide("E = m v", units={"E": "J", "m": "kg", "v": "m/s"}).dimension.sides
    ('kg m^2/s^2', 'kg m/s')
    """
    units = units or {}
    checked_units(units, {})
    answer = answered(relation, where, given, letters)
    checked_units(units, answer.letters)
    if answer.verdict is Status.UNREADABLE:
        return answer
    asked = Asked(relation, _several(where), tuple(apart(_several(given))), tuple((letters or {}).items()))
    answer = replace(answer, measuring=partial(measured, asked, units))
    if answer.verdict is not Status.PROVED or not any(unit.endswith(ONE) for unit in units.values()):
        return answer
    return replace(answer, generalizing=partial(in_general, asked, units, decided_one))


def answered(
    relation: str,
    where: Iterable[str] | str = (),
    given: Iterable[str] | str = (),
    letters: Mapping[str, str] | None = None,
    *,
    wanted: bool = True,
    claimed: bool = False,
    all_sizes: bool = True,
    square: bool = False,
    symmetry: bool = True,
) -> Answer:
    """The answer to a question; repairs of what is refuted are looked for if they are wanted.

    What is claimed for all values of its letters is neither an equation to be solved nor a condition. Proofs for
    matrices of all sizes are left out where they have been looked for before. If matrices are taken to be square unless
    something else is said of them, it is not asked whether a relation holds for others. Of what is refuted it is asked
    whether it holds for symmetric matrices, if that is open.
    """
    question = (relation, where, given, letters)
    answer = _answered(*question, wanted=wanted, claimed=claimed, all_sizes=all_sizes, square=square, symmetry=symmetry)
    if answer.verdict not in (Status.PROVED, Status.REFUTED):
        return answer
    said = {**special.said((letters or {}).items()), **dict.fromkeys(power_series.said(letters or {}), KUMMER)}
    reason = special.passed_over(answer.letters, said, _several(where), refuted=answer.verdict is Status.REFUTED)
    if reason := reason or _of_other_functions(_several(where)):
        return replace(answer, verdict=Status.AMBIGUOUS, certificate=(), counterexample={}, values=(), reason=reason)
    return answer


def _answer_to(one: Asked, *, wanted: bool = False, claimed: bool = False) -> Answer:
    """The answer to a question that another one was made into."""
    return answered(one.relation, one.where, one.given, dict(one.letters), wanted=wanted, claimed=claimed)


# what an equation says a function of a known name is
_SAID_OF_KNOWN = re.compile(r"\s*(\\operatorname\s*\{\s*erfc?\s*\}|\\Gamma|\\zeta)\s*(?:\\left\s*)?\([^()=]*\)\s*=")


def _of_other_functions(where: Iterable[str]) -> str:
    """The doubt whether a function is the one of its name, where what is said of it is false of that; or ""."""
    for text in where:
        if (found := _SAID_OF_KNOWN.match(text)) and answered(text, wanted=False).verdict is Status.REFUTED:
            return f"{text} is false of the function that is usually called {found[1]}; give it another name"
    return ""


def _answered(
    relation: str,
    where: Iterable[str] | str,
    given: Iterable[str] | str,
    letters: Mapping[str, str] | None,
    *,
    wanted: bool,
    claimed: bool,
    all_sizes: bool,
    square: bool,
    symmetry: bool,
) -> Answer:
    """The same before it is asked whether known functions were taken for unknown ones."""
    started = time.perf_counter()
    asked = None
    try:
        by_others = named.said(letters or {})
        kummer = power_series.said(letters or {})
        others = [(x, phrase) for x, phrase in (letters or {}).items() if x not in {*by_others, *kummer}]
        declared = special.said(others)
        plain_letters = tuple((x, phrase) for x, phrase in others if x.partition("_")[0] not in declared)
        printed = Asked(relation, _several(where), tuple(apart(_several(given))), plain_letters)
        asked = plainly(printed)
        spelled = dict(zip((*asked.where, *asked.given), (*printed.where, *printed.given), strict=True))
        if reason := spelled_function((printed.relation, *printed.where, *printed.given)):
            return Answer(Status.AMBIGUOUS, reason=reason)
        asked = with_entries(with_differentials(with_primes(with_scopes(with_each_sign(asked)))))
        if (of_named := _of_named(asked, by_others)) is not None:
            return replace(of_named, seconds=time.perf_counter() - started)
        if (of_powers := _of_power_series(asked, kummer)) is not None:
            return replace(of_powers, seconds=time.perf_counter() - started)
        if (of_events := events.in_cases(asked)) is not None:
            return replace(_of_events(of_events, asked), seconds=time.perf_counter() - started)
        if (of_moments := expectations.in_moments(asked)) is not None:
            return replace(_of_moments(of_moments, asked), seconds=time.perf_counter() - started)
        if (of_cases := orthogonal.in_cases(asked)) is not None:
            return replace(_of_equal_and_different(of_cases, asked), seconds=time.perf_counter() - started)
        if (of_orders := orders.ordered(asked)) is not None:
            return replace(_of_order(of_orders), seconds=time.perf_counter() - started)
        if (whole := with_whole_numbers(asked)) is not None:
            return replace(_of_whole_numbers(asked, whole), seconds=time.perf_counter() - started)
        with limited(TOTAL):
            of_fields = in_fields(asked, decided_one)
        if of_fields is not None:
            return replace(of_fields, seconds=time.perf_counter() - started)
        if all_sizes and (general := _of_any_size(asked) or _of_kronecker(asked)):
            used = tuple(spelled.get(text, text) for text in general.used)
            return replace(general, used=used, seconds=time.perf_counter() - started)
        with limited(TOTAL):
            known = _of_generating_function(asked, declared) or _of_special_functions(asked, declared)
            if (known := known or _by_indices(asked)) is not None:
                return replace(known, seconds=time.perf_counter() - started)
            several = readings(asked)
            several = [each for each in several if not any(constant(each))] or several  # nobody differentiates those
            found = _decided_in_turn(several, asked, wanted, claimed)
    except Understood as error:
        found, other = [], Answer(Status.UNDECIDED, *_shown(error.tree, error.inference), reason=error.reason)
    except SymcheckError as error:
        found, other = [], Answer(Status.UNREADABLE, reason=str(error))
    except OutOfTime:
        reason = f"the search was not over after {TOTAL:g} s"
        return Answer(Status.UNDECIDED, reason=reason, seconds=time.perf_counter() - started)
    open_ = all(answer.verdict is Status.UNDECIDED for _, answer in found)
    if open_ and found and asked and (ended := with_whole_ends(asked)) is not None:
        at_whole = _answer_to(ended)
        if at_whole.verdict is Status.PROVED:
            ends = dict.fromkeys((text.split()[0] for text in ended.given[len(asked.given) :]), UP_TO)
            taken = at_whole.letters | {x: ends.get(x, said) for x, said in at_whole.letters.items()}
            return replace(at_whole, letters=taken, seconds=time.perf_counter() - started)
    shown_as_names = bool(found) and all(answer.verdict is Status.PROVED for _, answer in found)
    if found and asked and not shown_as_names and (sequences := with_sequences(asked)) is not None:
        by_places = _answer_to(sequences, wanted=wanted)
        if by_places.verdict not in (Status.PROVED, Status.REFUTED):
            by_places = replace(by_places, verdict=Status.UNDECIDED, certificate=())
        used = (*printed.where, *printed.given) if by_places.used else ()
        return replace(by_places, used=used, seconds=time.perf_counter() - started)
    if open_ and asked and (summed := with_sums_of_powers(asked)) is not None:
        of_sums = _translated(summed, printed, {}, {})
        if of_sums.verdict is Status.PROVED:
            return replace(of_sums, seconds=time.perf_counter() - started)
    if open_ and asked and (at := _of_some_size(asked)):
        several_values = any(may_be_solved(problem, reading) for reading, _ in found for problem in reading.problems)
        at = replace(found[0][1], reason=EQUATION) if several_values and at.verdict is Status.REFUTED else at
        return replace(at, seconds=time.perf_counter() - started)
    if not found:
        false = _false_gradient(asked) if asked else None
        return replace(false or other, seconds=time.perf_counter() - started)

    seconds = time.perf_counter() - started
    choices = {choice for reading, _ in found for choice in reading.inference.choices}
    if NUMBERS in choices and VECTORS not in choices:
        return replace(found[0][1], verdict=Status.AMBIGUOUS, certificate=(), reason=CROSS, seconds=seconds)
    if (answer := _agreed(found)) is not None:
        if answer.verdict is Status.PROVED and asked and not square and _holds_for_square_alone(asked):
            return replace(answer, verdict=Status.AMBIGUOUS, certificate=(), reason=SQUARE, seconds=seconds)
        reason = braced(printed.relation) if answer.verdict is Status.REFUTED else ""
        if answer.verdict is Status.REFUTED and asked and symmetry:
            reason = reason or _of_symmetric(asked, found[0][0])
        if reason:
            return replace(answer, verdict=Status.AMBIGUOUS, certificate=(), reason=reason, seconds=seconds)
        return replace(answer, used=tuple(spelled.get(text, text) for text in answer.used), seconds=seconds)
    shown = "; ".join(f"{', '.join(r.inference.choices)}: {a.verdict}" for r, a in found)
    return Answer(Status.AMBIGUOUS, reading=" | ".join(a.reading for _, a in found), reason=shown, seconds=seconds)


def _of_whole_numbers(asked: Asked, found: Whole) -> Answer:
    """The answer about a relation with letters for its floors and ceilings, which are whole numbers."""
    answer = _answer_to(found.asked)
    if answer.verdict is Status.REFUTED:
        answer = replace(answer, verdict=Status.UNDECIDED, counterexample={}, values=(), certificate=())
    if answer.verdict is Status.UNDECIDED and (false := _refuted_with_floors(found)) is not None:
        answer = replace(false, letters=answer.letters)
        if not (asked.where or asked.given or found.is_of_all()):
            answer = replace(answer, verdict=Status.UNDECIDED, counterexample={}, certificate=(), reason=EQUATION)
    elif answer.verdict is Status.UNDECIDED:
        parts = [*map(_answer_to, found.sharper())]
        if parts and all(each.verdict is Status.PROVED for each in parts):
            certificates = tuple(made for each in parts for made in each.certificate)
            used = tuple(dict.fromkeys(text for each in parts for text in each.used))
            answer = replace(answer, verdict=Status.PROVED, certificate=certificates, used=used, reason="")
    told = {x: f"{of} (a whole number)" for x, of in found.stand.items()}
    point = {x: value for x, value in answer.counterexample.items() if x not in found.stand}
    used = tuple(text for text in answer.used if text in (*asked.where, *asked.given))
    return replace(answer, letters=answer.letters | told, counterexample=point, used=used)


def _of_named(asked: Asked, declared: Mapping[str, str]) -> Answer | None:
    """The answer with what functions are in the places of their names; None where a letter may mean another one."""
    if (found := named.written_out(asked, declared)) is None:
        return None
    answer = _answer_to(found.asked)
    known = found.sure or answer.verdict is Status.PROVED
    return replace(answer, letters=answer.letters | {**found.told}) if known else None


def _of_events(found: events.Found, asked: Asked) -> Answer:
    """The answer about probabilities of events; not refuted if it holds of those that exclude one another."""
    told = dict.fromkeys(found.cases.events, "an event (its probability is printed)")
    answer = _translated(found.asked, asked, told, found.cases.meant)
    return _unless_special(answer, found.stricter(), law=found.law)


def _of_moments(found: expectations.Found, asked: Asked) -> Answer:
    """The answer about expectations: proved of all moments, or refuted of variables with a few values."""
    told = dict.fromkeys(found.random, "a random variable (what is expected of it is printed)")
    proved = _translated(found.asked, asked, told, found.meant)
    if proved.verdict is Status.PROVED:
        return proved
    answer = _translated(found.of_values, asked, told, {})
    if answer.verdict is not Status.REFUTED:
        return replace(proved, verdict=Status.UNDECIDED, counterexample={}, certificate=(), reason=UNSETTLED)
    return _unless_special(answer, found.special, law=found.law)


def _of_equal_and_different(found: orthogonal.Cases, asked: Asked) -> Answer:
    """The answer about a relation with Kronecker's delta, for equal letters and for different ones."""
    m, n = found.letters
    equal, different = map(_answer_to, (found.equal, found.different))
    given = (*asked.where, *asked.given)
    used = tuple(text for text in dict.fromkeys((*equal.used, *different.used)) if text in given)
    whole = replace(different, reading=asked.relation, letters=equal.letters | different.letters, used=used)
    if equal.verdict is Status.PROVED and different.verdict is Status.PROVED:
        return replace(whole, certificate=(*equal.certificate, *different.certificate))
    for case, answer in ((f"{m} = {n}", equal), (rf"{m} \ne {n}", different)):
        if answer.verdict is Status.REFUTED:
            point = answer.counterexample | ({n: answer.counterexample[m]} if m in answer.counterexample else {})
            return replace(answer, reading=asked.relation, counterexample=point)
        if answer.verdict is not Status.PROVED:
            whole = replace(whole, verdict=answer.verdict, certificate=(), reason=f"where {case}: {answer.reason}")
    return whole


def _translated(one: Asked, asked: Asked, told: Mapping[str, str], meant: Mapping[str, str]) -> Answer:
    """The answer to a question in other letters, in terms of the one that was asked."""
    answer = _answer_to(one, claimed=True)
    letters_ = {x: what for x, what in answer.letters.items() if x in {*tex.texts(asked.relation)} - {*told, *meant}}
    point = {meant.get(x, x): value for x, value in answer.counterexample.items()}
    printed = dict(zip((*one.where, *one.given), (*asked.where, *asked.given), strict=False))
    used = tuple(printed[text] for text in answer.used if text in printed)
    return replace(answer, reading=asked.relation, letters={**told} | letters_, counterexample=point, used=used)


def _unless_special(answer: Answer, special: Iterable[tuple[str, Asked]], *, law: bool) -> Answer:
    """The answer; not that it is false if it holds in special cases, or says what something is."""
    if answer.verdict is not Status.REFUTED:
        return answer
    open_ = replace(answer, verdict=Status.AMBIGUOUS, counterexample={}, values=(), certificate=())
    if not law:
        return replace(open_, verdict=Status.UNDECIDED, reason=EQUATION)
    for how, one in special:
        if _answer_to(one, claimed=True).verdict is not Status.REFUTED:
            return replace(open_, reason=f"it holds if {how}; say whether that is meant")
    return answer


def _of_power_series(asked: Asked, kummer: set[str]) -> Answer | None:
    """The answer about hypergeometric functions; None where there are none, or they have no such arguments."""
    if (found := power_series.with_letters(asked, kummer)) is None:
        return None
    answer = _of_hypergeometric(found)
    sure = kummer or answer is None or answer.verdict is Status.PROVED or power_series.HEAD[0] in asked.relation
    return answer if sure else None


def _of_hypergeometric(found: power_series.Series) -> Answer | None:
    with suppress(SymcheckError, Understood, OutOfTime), limited(TOTAL):
        (reading, *others) = readings(found.asked)
        if others or len(reading.problems) != 1:
            return None
        (problem,) = reading.problems
        latex, taken = _shown(reading.tree, reading.inference)
        base = Answer(Status.UNDECIDED, latex, taken | {**found.told})
        if cases := power_series.by_coefficients(problem, found.of):
            answers = [decided_one(case) for case in cases]
            made = [made for verdict, made, _ in answers if made is not None and verdict is Verdict.PROVED]
            if len(made) == len(cases):
                return _proved_in_cases(base, reading, cases, made)
        if (equal := transformed(problem, found.of, decided_one)) is not None:
            return _proved_in_cases(base, reading, equal.cases, equal.certificates)
        if (valued := power_series.with_values(problem, found.of)) is not None:
            there, conditions = valued
            answers = [decided_one(case) for case in conditions]
            made = [made for verdict, made, _ in answers if made is not None and verdict is Verdict.PROVED]
            if len(made) == len(conditions):
                answer = _decided(replace(reading, problems=(there,)), found.asked, wanted=False)
                if answer.verdict is not Status.UNDECIDED:
                    return replace(answer, letters=base.letters, certificate=(*answer.certificate, *made))
        if (sums := power_series.as_sums(problem, found.of)) is not None:
            answer = _decided(replace(reading, problems=(sums,)), found.asked, wanted=False)
            if answer.verdict is not Status.UNDECIDED:
                return replace(answer, letters=answer.letters | {**found.told})
        for at, there in power_series.terminated(problem, found.of):
            verdict, one, _ = decided_one(there)
            if one is not None and verdict is Verdict.REFUTED:
                if reason := _doubt_of_points(reading):
                    return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
                point = {x: str(n) for x, n in at.items()}
                point |= {x: term(value) for x, value in one["point"]["values"].items()}
                return replace(base, verdict=Status.REFUTED, counterexample=point, certificate=(one,))
        for at, there in power_series.at_numbers(problem, found.of):
            answer = _decided(replace(reading, problems=(there,)), found.asked, wanted=False)
            if answer.verdict is Status.REFUTED:
                point = {x: str(n) for x, n in at.items()} | answer.counterexample
                return replace(answer, letters=base.letters, counterexample=point)
        return replace(base, reason=UNSETTLED)
    return None


def _of_order(found: orders.Ordered) -> Answer:
    """The answer about a derivative whose order is a letter: at the first numbers, and then by induction."""
    base = Answer(Status.UNDECIDED, found.asked.relation, reason=UNSETTLED)
    proved = dict[int, tuple[Certificate, tuple[str, ...]]]()
    for number in range(found.first, found.first + orders.TRIED + 1):
        if (case := orders.at_number(found, number)) is None:
            continue
        reading, problem = case
        taken = _shown(reading.tree, reading.inference)[1]
        base = replace(base, letters=taken | {found.letter: ORDER_OF_SLOPES})
        verdict, made, names = decided_one(problem)
        stated = tuple(reading.stated[name] for name in names if name in reading.stated)
        if made is not None and verdict is Verdict.PROVED:
            proved[number] = made, stated
        elif made is not None and verdict is Verdict.REFUTED and number:
            if reason := _doubt_of_points(reading):
                return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
            if said := _says_otherwise(problem, reading, None):
                return replace(base, reason=said)
            point = {found.letter: str(number)} | {x: term(v) for x, v in made["point"]["values"].items()}
            return replace(
                base, verdict=Status.REFUTED, counterexample=point, used=stated, certificate=(made,), reason=""
            )
    start = next((number for number in (found.first, 1) if number in proved), None)
    if start is None:
        return replace(base, reason=f"it is not decided at {found.letter} = {found.first}")
    certificates, used = [proved[start][0]], [*proved[start][1]]
    for reading, problem in orders.steps(replace(found, first=start)):
        verdict, made, names = decided_one(problem)
        if made is None or verdict is not Verdict.PROVED:
            return replace(base, reason=f"it holds for the first {found.letter}; no induction for the others was found")
        if reason := doubt_of_proofs(reading) or held(reading, ()):
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        certificates.append(made)
        used += (reading.stated[name] for name in names if name in reading.stated)
    if len(certificates) == 1:
        return base
    if found.first < start and found.said:
        reason = f"it is not shown at {found.letter} = {found.first}; is {found.letter} >= {start} meant? say so"
        return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
    used = [text for text in dict.fromkeys(used) if text in found.asked.given]
    return replace(base, verdict=Status.PROVED, used=tuple(used), certificate=tuple(certificates), reason="")


def _refuted_with_floors(found: Whole) -> Answer | None:
    """The answer that it fails for some numbers, with the floors and ceilings that are there."""
    with suppress(SymcheckError, Understood, OutOfTime), limited(AT_NUMBERS):
        (reading, *others) = readings(found.asked)
        for problem in reading.problems if not others else ():
            for point in found.points(problem):
                made, _ = _refuted_with(problem, point)
                if made is None:
                    continue
                base = Answer(Status.UNDECIDED, *_shown(reading.tree, reading.inference))
                if reason := _doubt_of_points(reading):
                    return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
                at = {x: term(value) for x, value in made["point"]["values"].items()}
                return replace(base, verdict=Status.REFUTED, counterexample=at, certificate=(made,))
    return None


def _decided_in_turn(
    several: Sequence[Reading], asked: Asked, wanted: bool, claimed: bool
) -> list[tuple[Reading, Answer]]:
    """The answers in all readings; remote ones are not asked about where all others are proved."""
    near = [each for each in several if not each.inference.remote or each.inference.beside]
    answers = {id(each): _decided(each, asked, wanted, claimed) for each in near}
    if not near or {answer.verdict for answer in answers.values()} != {Status.PROVED}:
        answers |= {id(each): _decided(each, asked, wanted, claimed) for each in several if id(each) not in answers}
    return [(each, answers[id(each)]) for each in several if id(each) in answers]


def _agreed(found: Sequence[tuple[Reading, Answer]]) -> Answer | None:
    """The verdict of all readings; a remote one cannot contradict a proof, but raises doubts of a refutation.

    One that is possible beside another alone can contradict that.
    """
    near = [answer for reading, answer in found if not reading.inference.remote]
    near += [answer for reading, answer in found if near and reading.inference.beside]
    remote = [answer.verdict for reading, answer in found if reading.inference.remote]
    verdicts = {answer.verdict for answer in near}
    if len(verdicts) == 1 and not (Status.REFUTED in verdicts and Status.PROVED in remote):
        return near[0]
    agreed = not near and len({*remote}) == 1 and Status.REFUTED not in remote
    return found[0][1] if agreed else None


def _of_symmetric(asked: Asked, reading: Reading) -> str:
    """That a relation which is refuted holds for symmetric matrices, as texts rarely say that they are; or ""."""
    known = reading.source[2]
    open_ = [x for x in open_matrices(reading) if x not in known and not mentioned(x, asked.given)]
    with suppress(OutOfTime), limited(SYMMETRIC):
        for those in dict.fromkeys(((*open_,), *((x,) for x in open_[:MOST_SYMMETRIC]))) if open_ else ():
            symmetric = [f"{x}^T = {x}" for x in those]
            question = (asked.relation, asked.where, (*asked.given, *symmetric), dict(asked.letters))
            if answered(*question, wanted=False, symmetry=False).verdict is Status.PROVED:
                return f"it holds if {', '.join(symmetric)}; say whether that is meant"
    return ""


def _holds_for_square_alone(asked: Asked) -> bool:
    """Is a relation that is proved of square matrices not so of others, which the letters may be, too?"""
    with suppress(SymcheckError):
        for reading in unlowered(asked)[:1]:
            several = [dict(asked.letters) | said for said in oblong(reading)]
            verdicts = {
                answered(asked.relation, asked.where, asked.given, said, wanted=False, square=True).verdict
                for said in several
            }
            return bool(verdicts) and (Status.REFUTED in verdicts or Status.PROVED not in verdicts)
    return False


def _of_any_size(asked: Asked) -> Answer | None:
    """The answer that a relation holds for matrices of all sizes, if there is a proof."""
    with suppress(SymcheckError, OutOfTime), limited(ALL_SIZES):
        found = _in_all_readings(asked)
        return _in_general(*found) if found else None
    return None


def _of_kronecker(asked: Asked) -> Answer | None:
    """The answer that a relation of Kronecker products holds for matrices of all sizes, if there is a proof."""
    if SIGN not in asked.relation:
        return None
    with suppress(SymcheckError, ValueError):
        sensible = [reading for reading in unlowered(asked) if is_of_matrices(reading)]
        (reading, *others) = _all_alike(sensible)
        if others or (plain := without_products(reading)) is None or (found := _of_any_size(plain)) is None:
            return None
        latex, taken = _shown(reading.tree, reading.inference)
        return replace(found, reading=latex, letters={x: what for x, what in found.letters.items() if x in taken})
    return None


def _false_gradient(asked: Asked) -> Answer | None:
    """The answer that a derivative by a matrix or vector is false for two rows and columns, in each layout."""
    with suppress(SymcheckError, OutOfTime), limited(LIMIT):
        (reading, *others) = _all_alike(unlowered(asked))
        if others:
            return None
        latex, letters_ = _shown(reading.tree, reading.inference)
        found, whole = None, True
        for problems in false_gradients(reading):
            answers = (decided_one(problem) for problem in problems)
            found = next((made for verdict, made, _ in answers if made and verdict is Verdict.REFUTED), None)
            if found is None:
                return None if whole else Answer(Status.AMBIGUOUS, latex, letters_, reason=LAYOUT)
            whole = False
        if found is not None:
            point = {x: term(value) for x, value in found["point"]["values"].items()}
            return Answer(Status.REFUTED, latex, letters_, counterexample=point, certificate=(found,))
    return None


def _all_alike(several: Sequence[Reading]) -> Sequence[Reading]:
    """One reading, where all say the same of the letters."""
    kinds = {tuple((g.letter.latex, g.letter.kind) for g in reading.inference.guesses) for reading in several}
    return several[:1] if len(kinds) == 1 else several


def proved_for_all_sizes(asked: Asked) -> OfAnySize | None:
    """The proof for matrices of all sizes of a question without layout, unless it rests on a convention."""
    with suppress(SymcheckError, OutOfTime), limited(ALL_SIZES):
        found = _in_all_readings(asked)
        return found[1] if found and not doubt_of_proofs(found[0]) else None
    return None


def _in_all_readings(asked: Asked) -> tuple[Reading, OfAnySize] | None:
    """Proved for matrices of all sizes in all readings, though it cannot be written out by components."""
    found = list[tuple[Reading, OfAnySize]]()
    for reading in unlowered(asked):
        if not any(covers(proved.inference, reading.inference) for proved, _ in found):
            with suppress(Contradiction):  # then it is no reading
                if (general := of_any_size(reading)) is None:
                    return None
                found.append((reading, general))
    return found[0] if found else None


def _in_general(reading: Reading, found: OfAnySize) -> Answer:
    """The answer that a relation holds for matrices of all sizes, unless it rests on a convention."""
    latex, letters_ = _shown(reading.tree, reading.inference)
    why = {g.letter.latex: g.why for g in reading.inference.guesses}
    taken = letters_ | {x: f"{said} ({why[x]})" for x, said in found.taken.items()}
    if reason := doubt_of_proofs(reading):
        return Answer(Status.AMBIGUOUS, latex, taken, reason=reason)
    return Answer(Status.PROVED, latex, taken, used=found.used, certificate=found.certificates)


def _of_some_size(asked: Asked) -> Answer | None:
    """Refuted for one number of components or addends; else undecided, where it can be read for one."""
    answers: list[Answer] = []
    try:
        letters = sizes(asked)
    except SymcheckError:
        return None
    for size in SIZES if letters else ():
        try:
            with limited(LIMIT):
                answers = [_decided(reading, asked, wanted=False) for reading in readings(asked, size)]
        except (SymcheckError, OutOfTime):
            continue
        shown = ", ".join(f"{letter} = {size}" for letter in letters)
        if all(answer.verdict is Status.REFUTED for answer in answers):
            point = {**dict.fromkeys(letters, str(size)), **answers[0].counterexample}
            return replace(answers[0], counterexample=point)
    if not answers:
        return None
    if (false := _of_unequal_sizes(asked, letters)) is not None:
        return false
    return replace(
        answers[0], verdict=Status.UNDECIDED, certificate=(), reason=f"decided for {shown} only, not for all"
    )


def _of_unequal_sizes(asked: Asked, letters: Sequence[str]) -> Answer | None:
    """Refuted for matrices of different numbers of rows and columns, which are said of them and stand nowhere else."""
    others = (text for text in asked.given if with_numbers(text, dict.fromkeys(letters, "1")) == text)
    elsewhere = {text for printed in (asked.relation, *asked.where, *others) for text in tex.texts(printed)}
    if len(letters) != len(UNEQUAL[0]) or not elsewhere.isdisjoint(letters):
        return None
    for numbers in UNEQUAL:
        by = dict(zip(letters, map(str, numbers), strict=True))
        given = tuple(with_numbers(text, by) for text in asked.given)
        answer = answered(asked.relation, asked.where, given, dict(asked.letters), wanted=False, square=True)
        if answer.verdict is Status.REFUTED:
            return replace(answer, counterexample=by | answer.counterexample)
    return None


def _several(texts: Iterable[str] | str) -> tuple[str, ...]:
    return tuple(text for text in ((texts,) if isinstance(texts, str) else texts) if text.strip())


def _shown(tree: Tree, inference: Inference) -> tuple[str, dict[str, str]]:
    """What was understood, with all brackets, and what each letter was taken for."""
    return with_brackets(tree), {g.letter.latex: f"{g.taken} ({g.why})" for g in inference.guesses}


def _decided(reading: Reading, asked: Asked, wanted: bool = True, claimed: bool = False) -> Answer:
    base = Answer(Status.UNDECIDED, *_shown(reading.tree, reading.inference))
    given = {*reading.source[4]}
    conditions = (name for name, text in reading.stated.items() if text in given)
    if (cases := induction(reading.problems, _whole_letters(reading), conditions)) is not None:
        return _by_induction(base, reading, cases)
    if (shown := _by_ratios(base, reading) or _by_series(reading, asked, wanted, claimed)) is not None:
        return shown
    if (shown := _by_coefficients(base, reading)) is not None and shown.verdict is not Status.UNDECIDED:
        return shown
    if (shown := _with_angles(reading, asked, wanted, claimed)) is not None:
        return shown
    if any(values := [iterated.with_values(problem) for problem in reading.problems]):
        shown = _with_values(values, reading, asked, wanted, claimed)
        if shown is not None and shown.verdict is not Status.UNDECIDED:
            return shown
    beyond = any(map(known_integrals.is_beyond_primitives, reading.problems))
    if beyond:
        shown = _with_known_integrals(reading, asked, wanted, claimed)
        if shown is not None and shown.verdict is not Status.UNDECIDED:
            return shown
    certificates, status, reasons, used = [], Status.PROVED, list[str](), list[str]()
    meant: Callable[[], bool] | None = None  # whether a slip explains it, asked once for all components
    for problem in reading.problems:
        verdict, made, found = decided_one(problem)
        whole = _not_whole(reading, problem, made) if made is not None and verdict is Verdict.REFUTED else []
        if made is None or whole:
            turned = with_half_turns(problem, _whole_letters(reading))
            again = decided_one(turned) if turned is not None else (verdict, None, ())
            if again[0] is Verdict.PROVED and again[1] is not None:
                verdict, made, found = again
            elif whole:
                made, found = _refuted_at_whole_numbers(problem, whole)
        if made is None and verdict is Verdict.UNDECIDED and (at_numbers := _refuted_at_numbers(problem)):
            verdict, made, found = at_numbers
        if made is None and verdict is Verdict.UNDECIDED:
            by_exponents = _refuted_by_digits(jets.without(problem), refuted_in_exponents)
            verdict, made, found = by_exponents or (verdict, made, found)
        if made is not None and verdict is Verdict.REFUTED and (usual := _holds_for_whole(reading, problem, made)):
            reason = f"is it meant for (different) whole numbers {', '.join(usual)} above 0? say so"
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        if made is not None and verdict is Verdict.REFUTED and reading.regular:
            made, found = _refuted_where_regular(reading, problem)
        if verdict is not Verdict.REFUTED and (raised := _whole_power(reading, problem)) is not None:
            if (of_powers := _proved_of_whole_powers(reading, problem)) is not None:
                verdict, (made, found) = Verdict.PROVED, of_powers
            elif made is not None:
                made = None
                found = (f"{term(raised)} may be negative under a whole power; give {term(raised)} > 0 if it is not",)
        if made is not None and verdict is Verdict.REFUTED and (symbols := _usual_symbols(reading)):
            made = None
            found = (f"{symbols} is usually the unit tensor or the tensor of permutations; say what it is",)
        if made is None:
            status = Status.UNDECIDED
            reasons += found
            continue
        if verdict is Verdict.REFUTED and defines(problem, bare=True):
            status = Status.UNDECIDED
            reasons.append(DEFINITION)
            continue
        false = verdict is Verdict.REFUTED
        if reason := _doubt_of_points(reading) if false else doubt_of_proofs(reading) or held(reading, found):
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        if not false and (reason := _doubt_of_arguments(reading)):
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        at = made["point"]["values"] if verdict is Verdict.REFUTED else {}
        meant = meant or cache(partial(explained, reading, at))
        said = _says_otherwise(problem, reading, meant if wanted else None) if verdict is Verdict.REFUTED else ""
        if said and not (claimed and said == EQUATION):
            status = Status.UNDECIDED
            reasons.append(said)
            continue
        if verdict is Verdict.REFUTED and (letters_ := _holds_for_positive(reading, problem, at)):
            reason = f"is it meant for positive {', '.join(letters_)}? say so"
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        if verdict is Verdict.REFUTED and (letter := _perhaps_for_all(problem)):
            reason = f"is what is given meant for all {letter}, or for one? write the equations of its coefficients"
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        if verdict is Verdict.REFUTED and (letter := _perhaps_at_an_end(problem)):
            reason = f"is {letter} outside of the integral meant at one of its ends? write it with its place"
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        certificates.append(made)
        used += (reading.stated[name] for name in found if name in reading.stated)
        valued = made["hypotheses"].get(DEFINED, []) if DEFINED in found else []
        used += map(term, [*valued, *(["!=", divisor, 0] for divisor in made.get("nonzero", ()))])
        if verdict is Verdict.REFUTED:
            return replace(
                base,
                verdict=Status.REFUTED,
                counterexample={x: term(value) for x, value in at.items()},
                values=tuple(map(term, made["point"].get("shown", ()))),
                used=tuple(dict.fromkeys(used)),
                certificate=(made,),
                slips=cache(partial(repairs, reading, at)) if wanted else tuple,
            )
    if status is Status.UNDECIDED and (shown := _by_steps(base, reading)) is not None:
        return shown
    if status is Status.UNDECIDED and not beyond:
        shown = _with_known_integrals(reading, asked, wanted, claimed)
        if shown is not None and shown.verdict is not Status.UNDECIDED:
            return shown
    if status is Status.UNDECIDED and (shown := _with_bases(reading, asked, wanted, claimed)) is not None:
        return shown
    if status is Status.UNDECIDED and (shown := _refuted_of_series(base, reading)) is not None:
        return shown
    if status is Status.UNDECIDED and (shown := _by_squares(base, reading)) is not None:
        return shown
    if status is Status.UNDECIDED and (shown := _written_out(reading, asked, wanted, claimed)) is not None:
        return shown
    if status is Status.UNDECIDED and (shown := _of_primitives(base, reading, asked, wanted, claimed)) is not None:
        return shown
    reason = "; ".join(dict.fromkeys(reasons))
    return replace(
        base, verdict=status, certificate=tuple(certificates), used=tuple(dict.fromkeys(used)), reason=reason
    )


def _refuted_of_series(base: Answer, reading: Reading) -> Answer | None:
    """The answer that a value of a function, which is said to be a series, is not the series that is printed.

    A relation with derivatives, or with series on both sides, may be an equation for the coefficients.
    """
    match reading.tree:
        case Chain((left, right), ("=",)):
            calls = [side for side in (left, right) if isinstance(side, Call)]
            printed = [side for side in (left, right) if any(isinstance(part, BigSum) for _, part in walk(side))]
        case _:
            return None
    heads = [call.function for call in calls if isinstance(call.function, Name) and not call.function.primes]
    known = {name for name, (_, own, _) in reading.source[2].items() if own}
    if len(heads) != 1 or len(printed) != 1 or printed[0] in calls or heads[0].letter not in known:
        return None
    for problem in reading.problems:
        for chosen, there in interchange.with_one_member(problem):
            verdict, made, _ = decided_one(there)
            if made is not None and verdict is Verdict.REFUTED:
                if reason := _doubt_of_points(reading):
                    return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
                point = {**chosen} | {x: term(value) for x, value in made["point"]["values"].items()}
                return replace(base, verdict=Status.REFUTED, counterexample=point, certificate=(made,))
    return None


def _by_squares(base: Answer, reading: Reading) -> Answer | None:
    """The answer that orders hold as those of the squares of both sides do."""
    found = [(problem, squares.squared(problem)) for problem in reading.problems]
    cases = [part for problem, each in found for part in ((each.problem, *each.sides) if each else (problem,))]
    if len(cases) == len(found):
        return None
    made = list[Certificate]()
    for case in cases:
        verdict, certificate_, _ = decided_one(case)
        if certificate_ is None or verdict is not Verdict.PROVED:
            return None
        made.append(certificate_)
    return _proved_in_cases(base, reading, cases, made)


def _written_out(reading: Reading, asked: Asked, wanted: bool, claimed: bool) -> Answer | None:
    """The answer with the sums that letters are defined as in their places."""
    if not any(part.tag == "sum" for each in reading.problems for _, t in each.definitions for part in nodes(t)):
        return None
    answer = _decided(replace(reading, problems=tuple(map(inlined, reading.problems))), asked, wanted, claimed)
    return answer if answer.verdict is not Status.UNDECIDED else None


def _with_bases(reading: Reading, asked: Asked, wanted: bool, claimed: bool) -> Answer | None:
    """The answer with a letter for e^t, where t stands in exponents alone."""
    found = [bases.with_base(problem) for problem in reading.problems]
    based = [each for each in found if each is not None]
    if not based:
        return None
    problems = tuple(
        problem if each is None else each.problem for problem, each in zip(reading.problems, found, strict=True)
    )
    answer = _decided(replace(reading, problems=problems), asked, wanted, claimed)
    if answer.verdict is not Status.PROVED and (
        answer.verdict is not Status.REFUTED or not all(each.whole for each in based)
    ):
        return None
    names = {each.name: f"e^{each.letter}" for each in based}
    return replace(answer, counterexample={names.get(x, x): value for x, value in answer.counterexample.items()})


def _of_generating_function(asked: Asked, declared: Mapping[str, str]) -> Answer | None:
    """The answer about a sum of members of a family with powers of a letter; None if it is something else."""
    if (found := generating.generated(special.with_names(asked, declared), declared)) is None:
        return None
    taken = _shown(found.reading.tree, found.reading.inference)[1]
    kept = {x: what for x, what in taken.items() if x in tex.texts(asked.relation)}
    base = Answer(Status.UNDECIDED, asked.relation, kept | {**found.told}, reason=UNSETTLED)
    made = list[Certificate]()
    for k, problem in enumerate(found.first):
        verdict, certificate_, _ = decided_one(problem)
        if certificate_ is not None and verdict is Verdict.REFUTED:
            if not found.declared:
                letter = next(iter(found.told)).partition("_")[0]
                reason = f"it is false of the {found.name}: say what {letter} is"
                return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
            point = {x: term(value) for x, value in certificate_["point"]["values"].items()}
            reason = f"the coefficients of the power {k} differ"
            return replace(
                base,
                verdict=Status.REFUTED,
                counterexample=point,
                values=(reason,),
                certificate=(certificate_,),
                reason="",
            )
        if k < 2 and (certificate_ is None or verdict is not Verdict.PROVED):
            return base
        made += [certificate_] if k < 2 and certificate_ is not None else []
    if found.equation is None:
        return replace(base, reason="the sum may not converge; give conditions under which it does, as |t| < 1")
    verdict, certificate_, _ = decided_one(found.equation)
    if certificate_ is None or verdict is not Verdict.PROVED:
        return base
    proved = _proved_in_cases(base, found.reading, (found.equation,), (certificate_, *made))
    return replace(proved, reason="") if proved.verdict is Status.PROVED else proved


def _of_primitives(base: Answer, reading: Reading, asked: Asked, wanted: bool, claimed: bool) -> Answer | None:
    """The answer about integrals of unknown functions, by primitives; or refuted with simple functions."""
    shown = _with_values([by_parts.with_primitives(each) for each in reading.problems], reading, asked, wanted, claimed)
    if shown is not None and shown.verdict is Status.PROVED:
        return shown
    laws = reading.problems if all(map(by_parts.is_law, reading.problems)) else ()
    for problem in laws if any(map(_is_law_but_for_a_slip, laws)) else ():
        for chosen, there in by_parts.with_samples(problem):
            verdict, made, _ = decided_one(there)
            if made is not None and verdict is Verdict.REFUTED:
                if reason := _doubt_of_points(reading):
                    return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
                point = {f"{f}(x)": value.replace("**", "^") for f, value in chosen.items()}
                point |= {x: term(value) for x, value in made["point"]["values"].items()}
                return replace(base, verdict=Status.REFUTED, counterexample=point, certificate=(made,))
    return None


def _is_law_but_for_a_slip(problem: Problem) -> bool:
    """Is a claim about integrals of all functions true with another sign or factor?"""
    for other in by_parts.with_slips(problem):
        if (found := by_parts.with_primitives(other)) is not None:
            claims = (*found.sides, found.problem)
            if all(decided_one(each)[0] is Verdict.PROVED for each in claims):
                return True
    return False


def _of_special_functions(asked: Asked, declared: Mapping[str, str]) -> Answer | None:
    """The answer about members of a family of special functions; None where there are none, or nothing is found."""
    if not special.may_have((asked.relation, *asked.where), declared):
        return None
    asked = special.with_arguments(special.with_names(asked, declared), declared)
    with suppress(SymcheckError, Understood):
        (reading, *others) = readings(special.with_whole_orders(asked, declared))
        reading = replace(reading, problems=tuple(map(special.inlined, reading.problems)))
        if others or len(reading.problems) != 1 or (found := special.members(reading, declared)) is None:
            return None
        if not declared and (not special.is_telling(found) or special.is_said(found, asked.where)):
            return None
        latex, taken = _shown(reading.tree, reading.inference)
        base = Answer(Status.UNDECIDED, latex, taken | special.shown(found, declared))
        return _proved_of_family(base, reading, found) or (
            _refuted_of_family(base, reading, found, bool(declared) or special.is_upright(found))
            if declared or not found.integrals
            else None
        )
    return None


def _by_indices(asked: Asked) -> Answer | None:
    """The answer about a relation with the symbols of Kronecker and Levi-Civita; None where there are none."""
    if asked.where or asked.given or asked.letters or not indices.SYMBOL.search(asked.relation):
        return None
    with suppress(SymcheckError, Understood):
        reading = unlowered(asked)[0]
        if (found := indices.indexed(reading.tree)) is None:
            return None
        base = Answer(Status.UNDECIDED, with_brackets(reading.tree), indices.shown(found))
        verdicts, made = list[Verdict](), list[Certificate]()
        for dimension in found.dimensions:
            answers = [decided_one(problem) for problem in found.problems(dimension)]
            verdicts.append(next((v for v, _, _ in answers if v is not Verdict.PROVED), Verdict.PROVED))
            made += (c for v, c, _ in answers if c is not None and v is verdicts[-1])
        if {*verdicts} == {Verdict.PROVED}:
            return replace(base, verdict=Status.PROVED, certificate=tuple(made))
        if Verdict.PROVED in verdicts:
            return replace(base, verdict=Status.AMBIGUOUS, reason="of how many dimensions are the indices? say so")
        if {*verdicts} == {Verdict.REFUTED} and found.is_law and found.dimensions == (3,):
            point = {x: term(value) for x, value in made[0]["point"]["values"].items()}
            return replace(base, verdict=Status.REFUTED, counterexample=point, certificate=(made[0],))
    return None


def _proved_of_family(base: Answer, reading: Reading, found: special.Members) -> Answer | None:
    """Proved by the relations of the family, by members written out, or by induction."""
    (problem,) = reading.problems
    plain = not found.base and (not found.integrals or not letters(problem.claim))
    written = special.written_out(problem, found) if plain else None
    partly = special.written_out(problem, found, partly=True) if found.family.slopes and not found.base else None
    for stated in (written, partly, *(special.related(problem, found, more) for more in (0, 1))):
        if stated is not None:
            verdict, made, _ = decided_one(stated)
            if made is not None and verdict is Verdict.PROVED:
                return _proved_in_cases(base, reading, (stated,), (made,))
    sequences = special.as_sequences(problem, found)
    if sequences is not None and (cases := induction((sequences,), {found.base})) is not None:
        answer = _by_induction(base, replace(reading, problems=(sequences,)), cases)
        return answer if answer.verdict in (Status.PROVED, Status.AMBIGUOUS) else None
    return None


def _refuted_of_family(base: Answer, reading: Reading, found: special.Members, declared: bool) -> Answer | None:
    """Refuted by members that are written out, if somebody says what they are; otherwise it is in doubt."""
    for number in special.tried(found, _whole_letters(reading)):
        if (problem := special.written_out(reading.problems[0], found, number)) is None:
            continue
        by_digits = _refuted_by_digits(jets.without(problem))
        verdict, made, used = by_digits or (
            (Verdict.UNDECIDED, None, ()) if found.integrals and letters(problem.claim) else decided_one(problem)
        )
        if made is None or verdict is not Verdict.REFUTED:
            continue
        if not declared:
            names = ", ".join(sorted({x.partition("_")[0] for x in found.latex.values()}))
            kinds = " and ".join(found.family.names.values())
            return replace(base, verdict=Status.AMBIGUOUS, reason=f"it is false of the {kinds}: say what {names} is")
        if reason := _doubt_of_points(reading, (found.base, f"\\{found.base}")):
            return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
        order = {} if number is None else {found.base: str(number)}
        point = order | {x: term(value) for x, value in made["point"]["values"].items()}
        stated = tuple(reading.stated[name] for name in used if name in reading.stated)
        shown = tuple(map(term, made["point"].get("shown", ())))
        base = replace(base, verdict=Status.REFUTED, counterexample=point, values=shown)
        return replace(base, used=stated, certificate=(made,))
    return None


def _by_steps(base: Answer, reading: Reading) -> Answer | None:
    """The answer by induction over the letter up to which sums and products run."""
    whole = _whole_letters(reading)
    problems = tuple(with_sums(problem, whole) or problem for problem in reading.problems)
    if problems == reading.problems or (cases := induction(problems, whole)) is None:
        return None
    answer = _by_induction(base, replace(reading, problems=problems), cases)
    return answer if answer.verdict is Status.PROVED else None


def _by_ratios(base: Answer, reading: Reading) -> Answer | None:
    """The answer that sums of what depends on their ends are what is claimed, by how neighbouring ones differ."""
    found = [added_up(problem, _whole_letters(reading)) for problem in reading.problems]
    for of_any in (False, True):
        shown = [each and _telescoped(each, of_any) for each in found]
        if all(shown):
            cases = [case for each in shown if each for case in each]
            answer = _proved_in_cases(base, reading, *map(list, zip(*cases, strict=True)))
            if answer.verdict is not Status.UNDECIDED:
                return answer
    return None


def _telescoped(found: Summation, of_any: bool) -> list[tuple[Problem, Certificate]] | None:
    """The steps with their certificates; with letters for powers, whatever their bases are, if that is asked for."""
    cases = list[tuple[Problem, Certificate]]()
    for several in (lambda: found.first, found.step):
        for step in several() or (None,):
            if step is None or (shown := _shown_of_whole(step, {*found.whole}, of_any)) is None:
                return None
            cases.append(shown)
    return cases


def _shown_of_whole(step: Problem, whole: set[str], of_any: bool) -> tuple[Problem, Certificate] | None:
    """A claim about whole letters with its certificate, if it is proved."""
    with suppress(Unknown):
        if of_any:
            step = without_gammas(with_whole_powers(replace(step, claim=worked_out(step.claim)), whole))
        turned = with_half_turns(step, whole) if of_any else None
        for stated in (step, turned):
            verdict, certificate_, _ = decided_one(stated) if stated is not None else UNTOLD
            if certificate_ is not None and verdict is Verdict.PROVED and stated is not None:
                return stated, certificate_
    return None


def _by_coefficients(base: Answer, reading: Reading) -> Answer | None:
    """The answer that sums of sequences are equal, as the coefficients of their members are."""
    cases = list[tuple[Problem, Certificate]]()
    for problem in reading.problems:
        if (found := interchange.coefficients(problem)) is None:
            return None
        whole = {found.letter, *_whole_letters(reading)}
        for between, later in found.of:
            sums = [added_up(later, whole)] if interchange.has_sum(later) else []
            ways = [partial(_telescoped, each) for each in sums if each is not None]
            shown = next(filter(None, (way(of_any) for of_any in (False, True) for way in ways)), None)
            if shown is None:
                alone = (_shown_of_whole(between, whole, of_any) for of_any in (False, True))
                one = next(filter(None, alone), None)
                shown = [one] if one else None
            if shown is None:
                return None
            cases += shown
    return _proved_in_cases(base, reading, *map(list, zip(*cases, strict=True)))


def _by_series(reading: Reading, asked: Asked, wanted: bool, claimed: bool) -> Answer | None:
    """The answer with the values of endless sums in their places, if what shows these values is proved."""
    return _with_values([series.with_values(problem) for problem in reading.problems], reading, asked, wanted, claimed)


def _with_angles(reading: Reading, asked: Asked, wanted: bool, claimed: bool) -> Answer | None:
    """The answer with what positive numbers in polar form say of their angles; proved of any numbers, or refuted."""
    values = [principal.with_angles(problem) for problem in reading.problems]
    for k, each in enumerate(values):
        general = each and principal.in_general(each.problem)
        if each and general and decided_one(general)[0] is Verdict.PROVED:
            values[k] = replace(each, problem=general)
    shown = _with_values(values, reading, asked, wanted, claimed)
    if shown is None or shown.verdict is Status.UNDECIDED:
        return None
    false = shown.verdict is Status.REFUTED
    return None if false and any(_says_otherwise(each, reading, None) for each in reading.problems) else shown


def _with_known_integrals(reading: Reading, asked: Asked, wanted: bool, claimed: bool) -> Answer | None:
    """The answer with the values of integrals that everybody knows."""
    values = [known_integrals.with_values(each) for each in reading.problems]
    return _with_values(values, reading, asked, wanted, claimed)


def _with_values(
    found: Sequence[series.Series | None], reading: Reading, asked: Asked, wanted: bool, claimed: bool
) -> Answer | None:
    """The answer with values in the places of what has them, if what shows these values is proved."""
    if not any(found):
        return None
    made = list[Certificate]()
    for side in (side for each in found if each is not None for side in each.sides):
        verdict, certificate_, _ = decided_one(side)
        if certificate_ is None or verdict is not Verdict.PROVED:
            return None
        made.append(certificate_)
    problems = tuple(
        problem if each is None else each.problem for problem, each in zip(reading.problems, found, strict=True)
    )
    answer = _decided(replace(reading, problems=problems), asked, wanted, claimed)
    return replace(answer, certificate=(*answer.certificate, *made) if answer.certificate else ())


def _by_induction(base: Answer, reading: Reading, cases: Induction) -> Answer:
    """Refuted at one of the first whole numbers; proved if the claim holds at the first ones, and then at the next."""
    used = tuple(text for text in reading.stated.values())
    direct = [decided_one(problem) for problem in cases.direct]
    made = [made for verdict, made, _ in direct if made is not None and verdict is Verdict.PROVED]
    if len(made) == len(direct):
        return _proved_in_cases(base, reading, cases.direct, made)
    made = []
    for number in range(cases.first, cases.first + max(FIRST, cases.order)):
        for printed, problem in zip(reading.problems, cases.at(number), strict=True):
            definitions = tuple((x, _with_factorials(t)) for x, t in problem.definitions)
            at = replace(problem, claim=_with_factorials(problem.claim), definitions=definitions)
            verdict, certificate_, _ = decided_one(at)
            if certificate_ is not None and verdict is Verdict.REFUTED:
                if reason := _doubt_of_points(reading):
                    return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
                if said := _says_otherwise(printed, reading, None):
                    return replace(base, reason=said)
                point = ({cases.letter: str(number)} if cases.letter else {}) | {
                    x: term(value) for x, value in certificate_["point"]["values"].items()
                }
                return replace(
                    base, verdict=Status.REFUTED, counterexample=point, used=used, certificate=(certificate_,)
                )
            if number < cases.first + cases.order:
                if certificate_ is None:
                    return replace(base, reason=f"it is not decided at {cases.letter} = {number}")
                made.append(certificate_)
    for problem in cases.step:
        verdict, certificate_, _ = decided_one(problem)
        if certificate_ is None or verdict is not Verdict.PROVED:
            return replace(base, reason="it holds for the first whole numbers; no induction for the others was found")
        made.append(certificate_)
    return _proved_in_cases(base, reading, cases.step, made)


def _proved_in_cases(base: Answer, reading: Reading, cases: Iterable[Problem], made: Sequence[Certificate]) -> Answer:
    for problem in cases:
        if (raised := _whole_power(reading, problem)) is not None:
            if (again := _proved_of_whole_powers(reading, problem)) is None:
                reason = f"{term(raised)} may be negative under a whole power; give {term(raised)} > 0"
                return replace(base, reason=reason)
            made = (*made, again[0])
    if reason := doubt_of_proofs(reading) or held(reading, ()):
        return replace(base, verdict=Status.AMBIGUOUS, reason=reason)
    used = tuple(text for text in reading.stated.values())
    return replace(base, verdict=Status.PROVED, used=used, certificate=tuple(made))


def _says_otherwise(problem: Problem, reading: Reading, explained_by_slip: Callable[[], bool] | None) -> str:
    """What a relation that fails somewhere may say: a definition, or an equation to be solved; "" if neither.

    One that may be solved counts as wrong if a slip of the pen in one place explains it.
    """
    if defines(problem):
        return DEFINITION
    if relates(problem, reading):
        return EQUATION
    if explained_by_slip is not None and may_be_solved(problem, reading) and not explained_by_slip():
        return EQUATION
    return EQUATION if is_condition(problem, reading) else ""


def _doubt_of_points(reading: Reading, orders: Collection[str] = ()) -> str:
    """Why what fails somewhere may be meant in another way, in which it does not; the empty text if nothing is seen."""
    if reason := doubt(reading, orders):
        return reason
    others = ((LONGER, with_longer_arguments), (SWAPPED, with_swapped_angles), (TURNED, with_arguments_above))
    return next((why for why, meant in others if _perhaps_otherwise(reading, meant(reading.tree))), "")


def _doubt_of_arguments(reading: Reading) -> str:
    """Whether what is proved fails where arguments of complex numbers are from 0 to 2 pi; or ""."""
    tree = with_arguments_above(reading.tree)
    if tree == reading.tree:
        return ""
    with suppress(SymcheckError):
        if all(decided_one(problem)[0] is Verdict.PROVED for problem in worded(reading, tree)):
            return ""
    return TURNED


def _perhaps_otherwise(reading: Reading, tree: Tree) -> bool:
    """Is a relation not refuted where it is understood in another way?"""
    if tree == reading.tree:
        return False
    with suppress(SymcheckError):
        return all(decided_one(problem)[0] is not Verdict.REFUTED for problem in worded(reading, tree))
    return False


def _usual_symbols(reading: Reading) -> str:
    """The letters spelled as Kronecker's or Levi-Civita's symbols with letters for indices, if not declared."""
    named = (g.letter.latex for g in reading.inference.guesses if g.why != SAID)
    return ", ".join(latex for latex in named if _SYMBOL.fullmatch(latex))


def _perhaps_for_all(problem: Problem) -> str:
    """A letter for all of whose values an equation may be meant, so that the claim would not be refuted; else ""."""
    equations = [f for name, fs in problem.hypotheses if name != DEFINED for f in fs if f.tag == "="]
    others = [problem.claim, *(t for _, t in problem.definitions)]
    for equation in equations:
        rest = set().union(*map(letters, (f for f in (*equations, *others) if f != equation)))
        rest |= {name for name, _ in problem.definitions}
        for letter in sorted(letters(equation) - rest):
            more = tuple(substituted(equation, {letter: n}) for n in ENOUGH)
            stricter = replace(problem, hypotheses=(*problem.hypotheses, ("for all", more)))
            verdict = decided_one(stricter)[0]
            if verdict is Verdict.PROVED or (verdict is Verdict.UNDECIDED and letter in VARIABLES):
                return letter
    return ""


def _perhaps_at_an_end(problem: Problem) -> str:
    """A letter that changes under an integral and stands outside too, where it may be meant at an end; else ""."""
    defined, outside = dict(problem.definitions), letters(problem.claim)
    for part in signs(problem.claim):
        by, ends = part.letter, [end for end in part.outside if not isinstance(end, End)]
        named = sorted(x for x in outside & defined.keys() if by in needed(x, defined))
        for end in ends if part.tag == "integral" and named and by not in outside else ():
            there = {x: substituted(t, {by: end}) for x, t in problem.definitions}
            said = tuple((name, tuple(substituted(f, {by: end}) for f in fs)) for name, fs in problem.hypotheses)
            with suppress(SymcheckError):
                ordered = tuple((x, there[x]) for x in in_order(there))
                if decided_one(replace(problem, definitions=ordered, hypotheses=said))[0] is Verdict.REFUTED:
                    continue
            return named[0]
    return ""


def _not_whole(reading: Reading, problem: Problem, made: Certificate) -> list[str]:
    """The letters said to be whole numbers, if a point gives one of them another value, or none of its own."""
    names = _whole_letters(reading)
    values, defined = made["point"]["values"], dict(problem.definitions)
    wrong = any(not isinstance(values.get(x, 0), int) or (x in defined and x not in values) for x in names)
    trees = [problem.claim, *defined.values(), *(f for _, fs in problem.hypotheses for f in fs)]
    bound = {x for part in nodes(*trees) if part.tag == "diff" for x in part.bound}  # no number can stand for these
    return [x for x in names if (x in values or x in defined) and x not in bound] if wrong else []


def _whole_letters(reading: Reading) -> list[str]:
    return [letter.name for letter in reading.inference.notation.letters if letter.integer and letter.name]


def _holds_for_whole(reading: Reading, problem: Problem, made: Certificate) -> list[str]:
    """The letters that usually are whole numbers, if it fails at others and not at some whole ones above 0."""
    asked = reading.source[0]
    values, said = made["point"]["values"], dict(asked.letters).keys() | from_zero(asked.given)
    usual = sorted(x for x in USUALLY_WHOLE if x in values and x not in said and not _is_below_one(problem, x))
    whole = all(isinstance(value := values[x], int) and value > 0 for x in usual)
    if whole and len({str(values[x]) for x in usual}) == len(usual):
        return []
    return usual if _refuted_at_whole_numbers(problem, usual, SIZES, distinct=whole)[0] is None else []


def _is_below_one(problem: Problem, x: str) -> bool:
    """Is it said that a letter is less than 1, so that it is no whole number above 0?"""
    for formula in (part for _, fs in problem.hypotheses for f in fs for part in conjuncts(f)):
        match formula.outside:
            case (small, large) if formula.tag in ORDERS:
                small, large = larger_first(formula).outside[::-1]
                number = number_of(large) if small == x else None
                if number is not None and (number < 1 or (number == 1 and len(formula.tag) == 1)):
                    return True
    return False


def _holds_for_positive(reading: Reading, problem: Problem, at: Mapping[str, JSON]) -> list[str]:
    """The letters of a relation without conditions, if it is proved where all are positive, as they often are in print.

    One letter alone is hardly meant to be positive, as in a root of its square.
    """
    names, trees = sorted(at), (problem.claim, *(term for _, term in problem.definitions))
    if reading.source[0].given or len(names) < 2 or not any(map(_is_root, nodes(*trees))):
        return []
    positive = tuple(node(">", x, 0) for x in names)
    stricter = replace(problem, hypotheses=(*problem.hypotheses, ("positive", positive)))
    return names if decided_one(stricter)[0] is Verdict.PROVED else []


def _is_root(part: Node) -> bool:
    """Is it a root or a logarithm, and no absolute value?"""
    inner = part.outside[0] if part.tag in ROOTS else 0
    return part.tag in ROOTS and not (isinstance(inner, Node) and inner.tag == "^")


def _proved_of_whole_powers(reading: Reading, problem: Problem) -> tuple[Certificate, tuple[str, ...]] | None:
    """The certificate with letters for powers that are whole, of any numbers, and what it rests on."""
    names = {*_whole_letters(reading)}
    with suppress(Unknown):
        plain = with_whole_powers(problem, names)
        verdict, made, used = decided_one(with_half_turns(plain, names) or plain)
        return (made, used) if made is not None and verdict is Verdict.PROVED else None
    return None


def _whole_power(reading: Reading, problem: Problem) -> Term | None:
    """A base of a power that is whole, of which nobody but the reader says that it is positive."""
    whole = {*_whole_letters(reading)}
    said = tuple((name, formulas) for name, formulas in problem.hypotheses if name != DEFINED)
    trees = [problem.claim, *(f for _, fs in said for f in fs), *(t for _, t in problem.definitions)]
    bases = (part.outside for part in nodes(*trees) if part.tag == "pow")
    for base in dict.fromkeys(base for base, exponent in bases if letters(base) and letters(exponent) <= whole):
        if decided_one(replace(problem, claim=node(">", base, 0), hypotheses=said))[0] is not Verdict.PROVED:
            return base
    return None


def _refuted_at_whole_numbers(
    problem: Problem, names: list[str], values: Sequence[int] = WHOLE, *, distinct: bool = False
) -> tuple[Certificate | None, tuple[str, ...]]:
    """The certificate that it is false for some small whole numbers, put in for the letters."""
    among = permutations(values, len(names)) if distinct else product(values, repeat=len(names))
    for numbers in islice(among, MOST_WHOLE):
        made, used = _refuted_with(problem, dict(zip(names, numbers, strict=True)))
        if made is not None:
            return made, used
    return None, ("it fails for numbers that are not whole; no whole ones were found for which it does",)


def _refuted_with(problem: Problem, by: Mapping[str, Term]) -> tuple[Certificate | None, tuple[str, ...]]:
    """The certificate that it is false with numbers for some letters, which are then part of the point."""
    hypotheses = tuple((name, tuple(_at(f, by) for f in fs)) for name, fs in problem.hypotheses)
    definitions = tuple((x, _at(t, by)) for x, t in problem.definitions if x not in by)
    at = replace(problem, claim=_at(problem.claim, by), hypotheses=hypotheses, definitions=definitions)
    verdict, made, used = decided_one(at)
    if made is None or verdict is not Verdict.REFUTED:
        return None, ()
    made["point"]["values"] |= {x: json.loads(json.dumps(n)) for x, n in by.items() if x not in made["point"]["values"]}
    return (made, used) if check(made) is None else (None, ())


def _at(tree: T, by: Mapping[str, Term]) -> T:
    """A term or formula with numbers for letters; the gamma function of whole numbers is worked out."""
    return _with_factorials(substituted(tree, by))


def _with_factorials(tree: T) -> T:
    if not isinstance(tree, Node):
        return tree
    if tree.tag == "gamma" and (n := number_of(tree.outside[0])) is not None and n in FACTORIALS:
        return factorial(int(n) - 1)  # type: ignore[return-value]
    return mapped(tree, _with_factorials)  # type: ignore[return-value]


def _refuted_at_numbers(problem: Problem) -> tuple[Verdict, Certificate, tuple[str, ...]] | None:
    """Refuted with small numbers for all letters, where integrals and sums are simpler than for all numbers."""
    trees = [problem.claim, *(f for _, fs in problem.hypotheses for f in fs), *(t for _, t in problem.definitions)]
    if not any(part.tag in WORKED_OUT for part in nodes(*trees)) or any(map(functions, trees)):
        return None
    names = sorted(set().union(*map(letters, trees)).difference(name for name, _ in problem.definitions))
    with suppress(OutOfTime), limited(AT_NUMBERS):
        made, used = _refuted_at_whole_numbers(problem, names, NUMBERS_TRIED) if len(names) <= FEW else (None, ())
        return (Verdict.REFUTED, made, used) if made is not None else None
    return None


def _refuted_where_regular(reading: Reading, problem: Problem) -> tuple[Certificate | None, tuple[str, ...]]:
    """The certificate at a point through which there are curves in all directions that one equation allows."""
    if len(reading.regular) == 1:
        more = replace(problem, hypotheses=(*problem.hypotheses, ("regular", reading.regular)))
        verdict, made, used = decided_one(more)
        if verdict is Verdict.REFUTED:
            return made, used
    return None, ("no point was found at which it fails, with curves in all directions that the equations allow",)


def decided_one(problem: Problem) -> tuple[Verdict, Certificate | None, tuple[str, ...]]:
    """The verdict with its certificate; if there is none, that with what differential equations say of functions."""
    problem = with_factors_outside(problem)
    found = _decided_as_stated(problem)
    if found[1] is None and any(map(functions, (problem.claim, *(f for _, fs in problem.hypotheses for f in fs)))):
        with suppress(OutOfTime), limited(LIMIT):
            if (solved := with_solutions(problem)) is not None:
                verdict, made, used = _decided_as_stated(solved)
                equations = (name for name, fs in problem.hypotheses if any(map(functions, fs)))
                return (verdict, made, (*used, *equations)) if made is not None else found
    if found[1] is None and (turned := with_parts_of_turns(problem)) is not None:
        of_turns = _decided_as_stated(turned)
        return of_turns if of_turns[0] is Verdict.PROVED else found
    if found[1] is None and found[0] is Verdict.UNDECIDED and (formed := squares.with_form(problem)) is not None:
        by_squares = _decided_as_stated(formed)
        return by_squares if by_squares[0] is Verdict.PROVED else found
    if found[1] is None and found[2][0].startswith(REFUSED) and (plain := with_plain_divisors(problem)) != problem:
        return _decided_as_stated(plain)
    return found


def _refuted_by_digits(
    numbers: jets.Jets | None, at: Callable[[Problem], Point | None] = refute_at_some, seconds: float = DIGITS
) -> tuple[Verdict, Certificate, tuple[str, ...]] | None:
    """A counterexample among a few numbers, where the search for a proof takes long."""
    with suppress(OutOfTime, Unsupported, RecursionError), limited(seconds):
        about = numbers.refutable() if numbers is not None else None
        if about is not None and (point := at(checked(about))) is not None:
            used = tuple(name for name, _ in about.hypotheses)
            made = certificate(about, Outcome(Verdict.REFUTED, point=point, used=used))
            return (Verdict.REFUTED, made, used) if check(made) is None else None
    return None


def _hinted(problem: Problem) -> Problem:
    return with_exponents(rooted(hinted(problem)))


def _decided_as_stated(problem: Problem) -> tuple[Verdict, Certificate | None, tuple[str, ...]]:
    """The verdict with its certificate and what it rests on, or why there is none; about numbers first if it can be."""
    reasons, numbers = [], None
    for way in (jets.of, jets.without):
        try:
            with limited(LIMIT):
                if (numbers := way(problem)) is None:
                    continue
                if not numbers.calls and (found := _refuted_by_digits(numbers, refute_at_corners, CORNERS)) is not None:
                    return found
                about = numbers.problem
                outcome = identity.decide(_hinted(about))
                if outcome.verdict is Verdict.UNDECIDED:
                    outcome = next(filter(None, map(proof_of, growth.hinted(about))), outcome)
                if outcome.verdict is Verdict.REFUTED and numbers.calls:
                    if (stricter := numbers.refutable()) is None:
                        reasons.append("no functions are known that have the values of a counterexample")
                        continue
                    if stricter != about:
                        about, outcome = stricter, identity.decide(_hinted(stricter))
                if outcome.verdict is Verdict.UNDECIDED:
                    reasons.append(outcome.reason)
                    continue
                made = certificate(about, outcome)
                fault = check(made)
                if fault is not None and outcome.point is not None and outcome.point.sides:
                    # digits may tell that it fails there where they do not tell what its sides are exactly
                    point = refute_at(checked(about), outcome.point.values)
                    made = made if point is None else certificate(about, replace(outcome, point=point))
                    fault = check(made)
                if fault is None:
                    return outcome.verdict, made, outcome.used
                reasons.append(f"{REFUSED} ({fault})")
        except OutOfTime:
            reasons.append(f"the search was not over after {LIMIT:g} s")
            if (found := _refuted_by_digits(numbers)) is not None:
                return found
    return Verdict.UNDECIDED, None, (reasons[-1],)
