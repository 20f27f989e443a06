"""A certificate in words: terms and formulas in one line, a proof as indented steps. Nothing is computed here."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

_INFIX = {"*": "*", "/": "/", "^": "^", "and": " and ", "or": " or ", "=>": " ⟹ ", "<=>": " ⟺ "}
_RELATIONS = {"=": "=", "!=": "≠", "<": "<", "<=": "≤", ">": ">", ">=": "≥"}
_PRECEDENCE = {"<=>": 0, "=>": 1, "or": 2, "and": 3, "exists": 4, "+": 6, "*": 7, "/": 8, "^": 9}
_RULES = {
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
}
_BRANCHES = {"premises": "premise", "parts": "part", "cases": "case", "then": "then"}
_TOLD = ("rule", "of", "with", *_BRANCHES)


def term(value: Any) -> str:
    """A term or formula of statement.py, as tuples or as JSON lists, in one line."""
    return _written(value, 0)


def reference(ref: Any) -> str:
    """A usable equality in words: a hypothesis, or a fact added on the way."""
    match ref:
        case ["hyp", name, number]:
            return f"{name} [{number + 1}]"
        case ["here", number]:
            return f"assumption {number + 1}"
        case ["positive", form]:
            return f"{term(form)} > 0"
    return json.dumps(ref)


def steps(proof: Mapping[str, Any], depth: int = 0) -> Iterator[str]:
    """The lines of a proof's rule tree, each indented by its depth; what follows a theorem stands below it."""
    indent = "  " * depth
    yield indent + (_theorem(proof) if "of" in proof else f"{proof['rule']}: {_RULES[proof['rule']]}")
    for key, value in proof.items():
        if key not in _TOLD:
            yield from (f"{indent}  {line}" for line in _detail(key, value))
    for key, label in _BRANCHES.items():
        branches = proof.get(key, [])
        if key == "then" and "of" in proof:
            yield from steps(branches, depth)
            continue
        for number, branch in enumerate([branches] if isinstance(branches, Mapping) else branches, 1):
            yield f"{indent}  {label}:" if isinstance(branches, Mapping) else f"{indent}  {label} {number}:"
            yield from steps(branch, depth + 2)


def _theorem(proof: Mapping[str, Any]) -> str:
    """A theorem with what it is applied to, and what it says."""
    from symcheck.checker.theorems import stated  # takes long, and is seldom needed

    given = {name: value["term"] if isinstance(value, Mapping) else value for name, value in proof["with"].items()}
    applied = f" ({'; '.join(f'{name} = {_number(value)}' for name, value in given.items())})" if given else ""
    return f"theorem {proof['of'].replace('_', ' ')}{applied}: {stated(proof['of'])}"


def point(values: Mapping[str, Any]) -> str:
    """A point as "name = value, ..."."""
    return ", ".join(f"{name} = {_number(value)}" for name, value in values.items())


def sides(counterexample: Mapping[str, Any]) -> str:
    """What is compared at a counterexample: the values of both sides, or the digits of numbers; else the empty text."""
    if both := counterexample.get("sides"):
        return f"the sides are {' against '.join(map(_number, both))}"
    if "proof" in counterexample:
        return "the contrary has a proof"
    shown = counterexample.get("enclosed", ())
    return ", ".join(
        f"{term(number)} lies between {_number(low)} and {_number(high)}" for number, _, low, high in shown
    )


def _detail(key: str, value: Any) -> Iterator[str]:
    if key == "cofactors":
        yield from (f"+ ({') · ('.join(polys)}) · [{reference(ref)}]" for ref, *polys in value)
    elif key == "times":
        yield from (f"not zero: {reference(cond)}" for cond in value)
    elif key == "given":
        yield (
            "rests on " + ", ".join(f"{name} [{number + 1}]" for name, number in value) if value else "rests on nothing"
        )
    elif key == "nonzero":
        yield "wherever these do not vanish: " + ", ".join(" / ".join(texts) for texts in value)
    elif key == "clear":
        yield "multiplied with: " + ", ".join(value)
    elif key == "point":
        yield point(value)
    elif key == "factors":
        yield from (f"factor: {base}" + (f" (power {power})" if power > 1 else "") for base, power in value)
    elif key == "index":
        yield f"alternative {value + 1}"
    elif key == "or":
        yield f"of {reference(value)}"
    elif key == "positive":
        yield "denominators of one sign: " + ", ".join(map(_number, value))
    elif key == "atoms":
        yield from (f"{name} stands for {term(meant)}" for name, meant in value.items())
    elif isinstance(value, list) and key == "form":
        yield f"{key}: {term(value)}"
    elif isinstance(value, list):
        yield f"{key}: {', '.join(str(entry) if isinstance(entry, str) else json.dumps(entry) for entry in value)}"
    else:
        yield f"{key}: {value}"


def _number(value: Any) -> str:
    """A term, or several, as a function of several has them."""
    if not isinstance(value, list | tuple):
        return str(value)
    several = len(value) < 2 or not isinstance(value[0], str)
    return ", ".join(map(_number, value)) if several else term(value)


def _written(value: Any, outer: int) -> str:
    if isinstance(value, int | str):
        return str(value)
    if not isinstance(value, list | tuple) or not value:
        return json.dumps(value)
    head, *parts = value
    if head == "/" and (decimal := _decimal(*parts)):
        return _wrapped(decimal, 6 if decimal[0] == "-" else 9, outer)
    if head in _RELATIONS:
        return f"{_written(parts[0], 5)} {_RELATIONS[head]} {_written(parts[1], 5)}"
    if head == "exists":
        return f"there are {', '.join(parts[0])} with {_written(parts[1], 4)}"
    if head == "-":
        return _wrapped("-" + _written(parts[0], 7), 6, outer)
    if head not in _PRECEDENCE:
        return f"{head}({', '.join(_written(part, 0) for part in parts)})"
    level = _PRECEDENCE[head]
    if head == "+":
        return _wrapped(_written(parts[0], level) + "".join(_addend(part) for part in parts[1:]), level, outer)
    text = _INFIX[head].join(_written(part, level + (head in ("/", "^") or n > 0)) for n, part in enumerate(parts))
    return _wrapped(text, level, outer)


def _decimal(top: Any, bottom: Any) -> str:
    """A fraction with a high power of ten below as a decimal, or the empty text."""
    digits = len(str(bottom)) - 1
    if not isinstance(top, int) or bottom != 10**digits or digits < 6:
        return ""
    whole = str(abs(top)).zfill(digits + 1)
    return f"{'-' * (top < 0)}{whole[:-digits]}.{whole[-digits:]}"


def _addend(value: Any) -> str:
    if isinstance(value, list | tuple) and value[0] == "-":
        return f" - {_written(value[1], 7)}"
    return f" + {_written(value, 7)}"


def _wrapped(text: str, level: int, outer: int) -> str:
    return f"({text})" if level < outer else text
