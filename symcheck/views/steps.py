"""A certificate in words: a proof as indented steps, a point, what is compared there. Nothing is computed here."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, cast

from symcheck.core.certificates import Certificate, MatrixProof, Point
from symcheck.core.terms import JSON
from symcheck.core.words import term

RULES = {
    "identity": "the difference of the two sides is a combination of what is given",
    "nonnegative": "the larger side less the smaller is the form, whose sign is plain",
    "implies": "suppose what is on the left (of a ≠ goal: that the sides were equal)",
    "each": "each part, or each direction, by itself",
    "choose": "one of the alternatives holds",
    "cases_or": "one case for each alternative",
    "split": "a product is a combination of what is given, so one of its factors vanishes",
    "vanish": "a sum of non-negative addends is a combination of what is given, so each addend vanishes",
    "absurd": "something that is not zero is a combination of what is given: a contradiction",
    "witness": "at this point it holds",
    "every": "for letters of which nothing is assumed, hence for all numbers",
    "compute": "by computing with numbers",
}
_BRANCHES = {"premises": "premise", "proof": "proof", "parts": "part", "cases": "case", "then": "then"}
_FACTS = ("theorem", "have")  # rules that make one more fact known; what follows them stands below
_IN_FIRST_LINE = ("rule", "of", "with", "formula", *_BRANCHES)


def parts_of(certificate: Certificate) -> Iterator[Mapping[str, Any]]:
    """Every step of a proof, those within others after them; nothing of a refutation."""
    waiting: list[object] = [certificate.get("proof")]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Mapping):
            yield from [part] if "rule" in part else []
            waiting += part.values()
        elif isinstance(part, list | tuple):
            waiting += part


def reference(ref: object) -> str:
    """A fact in words: a hypothesis, a coordinate of a point, or what was added on the way."""
    match ref:
        case ["hyp", name, int(number)]:
            return f"{name} [{number + 1}]"
        case ["here", int(number)]:
            return f"assumption {number + 1}"
        case ["point", int(number)]:
            return f"value {number + 1} at the point"
        case ["nonzero", int(number)]:
            return f"denominator {number + 1}"
        case ["positive", form]:
            return f"{term(form)} > 0"
    return json.dumps(ref)


def claim(certificate: Certificate) -> str:
    """What a certificate claims; of matrices of all sizes both sides of an equation."""
    return term(["=", *certificate["claim"]] if "matrices" in certificate else certificate["claim"])


def proof_lines(certificate: Certificate) -> Iterator[str]:
    """The lemmas that a proof starts from, what must not vanish, and its steps; nothing of a refutation."""
    if lemmas := dict(certificate.get("lemmas", ())):
        yield f"from lemmas: {', '.join(lemmas)}"
    if conditions := certificate.get("nonzero"):
        yield f"wherever these do not vanish: {', '.join(map(term, conditions))}"
    if "matrices" in certificate:
        yield from _of_matrices(cast(MatrixProof, certificate))
    else:
        yield from steps(certificate["proof"]) if "proof" in certificate else ()


def _of_matrices(certificate: MatrixProof) -> Iterator[str]:
    """The shapes of the letters, what is inverse to what, and what adds up to the difference of both sides."""
    yield f"matrices: {', '.join(f'{x} is {n} x {m}' for x, (n, m) in certificate['matrices'].items())}"
    for x, inverted in certificate["inverses"].items():
        yield f"{x} is the inverse of {term(inverted)}"
    yield (
        "the difference of both sides is the sum of these, which vanish"
        if certificate["proof"]
        else "both sides are one sum"
    )
    for reference_, vanishing in certificate["proof"]:
        yield f"  {term(vanishing)}, with the fact {' '.join(map(str, cast(list[str], reference_)))}"


def steps(proof: Mapping[str, Any], depth: int = 0) -> Iterator[str]:
    """The lines of a proof's rule tree, each indented by its depth; what follows a new fact stands below it."""
    indent = "  " * depth
    yield indent + _rule(proof)
    for key, value in proof.items():
        if key not in _IN_FIRST_LINE:
            own = "product" if proof["rule"] == "split" and key == "form" else key
            yield from (f"{indent}  {line}" for line in _detail(own, value))
    for key, label in _BRANCHES.items():
        branches = proof.get(key, [])
        if key == "then" and proof["rule"] in _FACTS:
            yield from steps(branches, depth)
            continue
        for number, branch in enumerate([branches] if isinstance(branches, Mapping) else branches, 1):
            yield f"{indent}  {label}:" if isinstance(branches, Mapping) else f"{indent}  {label} {number}:"
            yield from steps(branch, depth + 2)


def _rule(proof: Mapping[str, Any]) -> str:
    """What a step does; of a theorem what it is applied to, and what it says."""
    rule = proof["rule"]
    if rule == "have":
        return f"first: {term(proof['formula'])}"
    if rule != "theorem":
        return f"{rule}: {RULES[rule]}"
    from symcheck.checker.theorems import stated  # takes long, and is seldom needed

    given = "; ".join(f"{name} = {meant}" for name, meant in _applied(proof.get("with", {})))
    applied = f" ({given})" if given else ""
    return f"theorem {proof['of'].replace('_', ' ')}{applied}: {stated(proof['of'])}"


def _applied(given: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The parameters of a theorem with what they stand for; a function with its letter."""
    for name, value in given.items():
        if isinstance(value, Mapping):
            yield f"{name}({value['letter']})", term(value["term"])
        else:
            yield name, term(value)


def point(values: Mapping[str, JSON]) -> str:
    """A point as "name = value, ..."."""
    return _equal((f"{function} {name}".lstrip(), term(value)) for function, name, value in coordinates(values))


def coordinates(values: Mapping[str, JSON]) -> Iterator[tuple[str, str, JSON]]:
    """A point as people read it: "" (or "sin", "cos"), a letter, and its value there (or that of its sine or cosine).

    An angle whose sine and cosine are rational is given by these. An angle that other values are made of comes before
    them, and stands in them as its letter.
    """
    angles = {name: value for name, value in values.items() if _half(value) is None and _has_angle(value)}
    for name in sorted(values, key=lambda each: _depth(angles.get(each))):
        if (half := _half(values[name])) is not None:
            yield "sin", name, _number(2 * half / (1 + half**2))
            yield "cos", name, _number((1 - half**2) / (1 + half**2))
        else:
            yield "", name, _by_letters(values[name], {x: angle for x, angle in angles.items() if x != name})


def _half(value: object) -> Fraction | None:
    """The rational tangent of half an angle, as such an angle is written in a certificate."""
    match value:
        case ["*", 2, ["arctan", int(t)]]:
            return Fraction(t)
        case ["*", 2, ["arctan", ["/", int(top), int(bottom)]]]:
            return Fraction(top, bottom)
    return None


def _number(value: Fraction) -> JSON:
    return value.numerator if value.denominator == 1 else ["/", value.numerator, value.denominator]


def _has_angle(value: object) -> bool:
    parts = value if isinstance(value, list | tuple) else ()
    return any(str(part).startswith("arc") or _has_angle(part) for part in parts)


def _depth(value: object) -> int:
    return 1 + max(map(_depth, value), default=0) if isinstance(value, list | tuple) else 0


def _by_letters(value: JSON, known: Mapping[str, JSON]) -> JSON:
    """A value, in which letters stand for what they are known to be."""
    if not isinstance(value, list | tuple):
        return value
    return [next((x for x, other in known.items() if other == part), _by_letters(part, known)) for part in value]


def _equal(pairs: Iterable[tuple[str, str]]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in pairs)


def sides(counterexample: Point) -> str:
    """What is compared at a counterexample: the values of both sides, or the digits of numbers; else the empty text."""
    both = compared(counterexample)
    if wrong := [str(number) for number, each in enumerate(both, 1) if each is False]:
        return _parts_that_fail(wrong, len(both))
    if both:
        return f"the sides are {' against '.join(map(term, both))}"
    if "proof" in counterexample:
        return "the contrary has a proof"
    return ", ".join(filter(None, map(_enclosed, counterexample.get("shown", ()))))


def _parts_that_fail(numbers: Sequence[str], total: int) -> str:
    """Which of the parts of a formula are false.

    >>> _parts_that_fail(["1", "3"], 4)
    'parts 1 and 3 of 4 are false'
    """
    if len(numbers) == total:
        return "it is false" if total == 1 else "all its parts are false"
    listed = " and ".join(filter(None, (", ".join(numbers[:-1]), numbers[-1])))
    return f"part {listed} of {total} is false" if len(numbers) == 1 else f"parts {listed} of {total} are false"


def compared(counterexample: Point) -> list[object]:
    """The values of the sides, or whether each part is true; nothing where numbers are compared by their digits."""
    shown = counterexample.get("shown", ())
    false = [bool(_contrary(each)) for each in shown]
    if any(false):  # a part is false wherever there are parts
        return [not each for each in false]
    return [each[2] for each in shown if each[0] == "="]


def _contrary(formula: object) -> object:
    """What a formula "f implies nothing" denies."""
    match formula:
        case ["=>", denied, ["or"]]:
            return denied
    return None


def _enclosed(formula: object) -> str:
    """That a number lies between two others."""
    match formula:
        case ["and", ["<=", low, number], ["<=", again, high]] if number == again:
            return f"{term(number)} lies between {term(low)} and {term(high)}"
    return ""


def _detail(key: str, value: Any) -> Iterator[str]:
    if key == "cofactors":
        yield from (f"+ ({') · ('.join(polys)}) · [{reference(ref)}]" for ref, *polys in value)
    elif key == "times":
        if printed := [each for each in value if isinstance(each, str)]:
            yield f"multiplied with: {', '.join(printed)}"
        yield from (f"not zero: {reference(each)}" for each in value if not isinstance(each, str))
    elif key == "point":
        yield _equal((name, term(number)) for name, number in value.items())
    elif key == "product":
        for factor in value[1:]:
            _, base, power = factor if factor[0] == "^" else ("^", factor, 1)
            yield f"factor: {term(base)}" + (f" (power {power})" if power > 1 else "")
    elif key == "index":
        yield f"alternative {value + 1}"
    elif key == "or":
        yield f"of {reference(value)}"
    elif key == "positive":
        yield "denominators of one sign: " + ", ".join(map(term, value))
    elif key == "atoms":
        yield from (f"{name} stands for {term(meant)}" for name, meant in value.items())
    elif key == "form":
        yield f"form: {term(value)}"
    elif key == "letters":
        yield f"with the new letters {', '.join(value)}"
    elif key == "numbers" and value:
        yield f"where {_equal((name, term(number)) for name, number in value.items())}"
    elif key == "values":
        yield f"from {', '.join(map(reference, value))}"
    elif value:
        yield f"{key}: {json.dumps(value)}"
