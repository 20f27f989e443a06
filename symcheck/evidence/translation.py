"""What a search found, in the checker's words: terms with sines, roots and pi as nodes, theorems with named arguments.

The search writes `sin_x`, `cos_x`, `sqrt_2` and `pi` for letters of its polynomials, and steps of a proof as it finds
them. Nothing here is trusted: what comes out is checked.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any

JSON = Any
Proof = dict[str, Any]

_NAME = re.compile(r"[A-Za-z]\w*")
_RELATIONAL = ("arctangent", "arcsine", "arccosine")
# parameters in the order in which the search gives them; "f:x" is a term in the letter x
_PARAMETERS: Mapping[str, str] = {
    "dichotomy": "t", "root": "t", "root_of_product": "s t", "equal_squares": "s t", "power": "b u",
    "power_of_sum": "b s t", "power_of_product": "s t u", "power_of_power": "b n u", "power_inverse": "b u t",
    "gamma": "t", "gamma_values": "", "circle_number": "", "right_half": "a",
    "mean": "f x c g", "quarter_turn": "f x", "intermediate_value": "f x s t", "constant": "c x s t",
    "power_rule": "f x s t c g u", "power_diverges": "f x c u", "even": "f x", "odd": "f x",
    "beta": "f x c k u r p q", "beta_diverges": "f x c k u r p q",
}  # fmt: skip


def stated(node: Any) -> JSON:
    """A term or formula of a statement as JSON for the checker: its names are letters, but for pi and infinity."""
    return term(node, lambda name: [name] if name in ("pi", "infinity") else None)


def term(node: Any, meaning: Callable[[str], Any] | None = None) -> JSON:
    """A term of a proof as JSON for the checker; `meaning` says which names are no letters, and what they are."""
    if isinstance(node, str):
        return (meaning or value_of)(node) or node
    if not isinstance(node, (tuple, list)):
        return node
    match node:
        case ["-", "infinity"]:
            return ["-infinity"]
        case ["diff", body, x, order]:
            return ["diff", term(body, meaning), x, order, x]
        case ["integral" | "diverges" | "mean" | "sum" | "product" as kind, body, x, *ends]:
            return [kind, term(body, meaning), x, *(term(end, meaning) for end in ends)]
        case ["exists" | "forall" as kind, bound, body]:
            return [kind, [*bound], term(body, meaning)]
        case ["call", function, orders, *arguments]:
            return ["call", function, [*orders], *(term(each, meaning) for each in arguments)]
    return [node[0], *(term(each, meaning) for each in node[1:])]


def certificate(found: Mapping[str, Any]) -> dict[str, JSON]:
    """A whole certificate, with the points where all that is assumed holds."""
    claim = stated(found["claim"])
    new = {
        "id": found["id"],
        "verdict": found["verdict"],
        "claim": claim,
        "definitions": [[name, stated(value)] for name, value in found["definitions"]],
        "hypotheses": {name: [*map(stated, formulas)] for name, formulas in found["hypotheses"].items()},
    }
    if "point" in found:
        return {**new, "point": point(found["point"], claim)}
    if facts := found.get("facts"):
        new["claim"] = claim = claim[2]
        new["definitions"] = [[name, stated(value)] for name, value in found["defined"]]
        new["lemmas"] = [[name, stated(formula)] for name, formula in facts]
        for name, formulas in found["under"].items():
            own = new["hypotheses"].setdefault(name, [])
            own += [formula for formula in map(stated, formulas) if formula not in own]
    atoms = {name: term(value) for name, value in found["proof"].get("atoms", {}).items()}
    if conditions := found["proof"].get("nonzero"):
        new["nonzero"] = [
            condition(texts, lambda name: atoms.get(name) or value_of(name) or name) for texts in conditions
        ]
    new["proof"] = proof(found["proof"])
    if free := sorted({name for name, _ in found.get("defined", ())} - {name for name, _ in found["definitions"]}):
        new["proof"]["atoms"] = {**{name: name for name in free}, **new["proof"].get("atoms", {})}
    if points := [*map(witness, found.get("witnesses", ()))]:
        wanted = len(implications(claim)) or 1
        new["witnesses"] = points * wanted if len(points) == 1 else points
    return new


def witness(found: Mapping[str, Any]) -> dict[str, JSON]:
    """A point where something holds, which is computed: the search proves it there together with what it needs."""
    given = {key: value for key, value in found.items() if key in ("values", "calls", "functions")}
    return point(given)


def implications(claim: JSON) -> list[JSON]:
    """The implications among the parts of a claim."""
    if claim[0] == "and":
        return [each for part in claim[1:] for each in implications(part)]
    return [claim] if claim[0] == "=>" else []


def value_of(name: str) -> list[Any] | None:
    """What a letter of the search's polynomials stands for, if it is a constant, a sine, a cosine or a root."""
    if name in ("pi", "infinity"):
        return [name]
    kind, _, rest = name.partition("_")
    if kind in ("sin", "cos") and rest:
        return [kind, term(rest)]
    return ["sqrt", int(rest)] if kind == "sqrt" and rest.isdecimal() else None


def proof(found: Proof) -> Proof:
    """A whole proof: its steps, and the terms that stand as letters in its polynomials."""
    stated = {name: term(value) for name, value in found.get("atoms", {}).items()}
    steps = step(found, lambda name: stated.get(name) or value_of(name) or name)
    used = {name for text in polynomials(steps) for name in _NAME.findall(text)}
    atoms = {name: value for name in sorted(used) if (value := stated.get(name) or value_of(name))}
    positive = [term(each) for each in found.get("positive", ())]
    return {**steps, **({"atoms": atoms} if atoms else {}), **({"positive": positive} if positive else {})}


def polynomials(node: Any) -> Iterator[str]:
    """Every polynomial that a proof mentions."""
    if isinstance(node, dict):
        yield from (text for text in node.get("times", ()) if isinstance(text, str))
        yield from (text for _, *factors in node.get("cofactors", ()) for text in factors)
        for value in node.values():
            yield from polynomials(value)
    elif isinstance(node, list):
        for value in node:
            yield from polynomials(value)


def step(found: Proof, meaning: Callable[[str], JSON]) -> Proof:
    """One step, with those above it."""
    rule = found["rule"]
    if rule == "theorem":
        return theorem(found, meaning)
    new: Proof = {"rule": rule}
    for key, value in found.items():
        match key:
            case "form":
                new[key] = term(value)
            case "point":
                new[key] = {x: term(each) for x, each in value.items()}
            case "then":
                new[key] = step(value, meaning)
            case "parts" | "cases":
                new[key] = [step(each, meaning) for each in value]
            case "factors":
                new["form"] = ["*", *(["^", polynomial(text, meaning), n] for text, n in value)]
            case "clear":
                new["times"] = [*value, *new.get("times", ())]
            case "times":
                positive = [["positive", term(ref[1])] if ref[0] == "positive" else ref for ref in value]
                new[key] = [*new.get("times", ()), *positive]
            case "cofactors" | "index" | "or":
                new[key] = value
    return new


def theorem(found: Proof, meaning: Callable[[str], JSON]) -> Proof:
    """A theorem with its arguments by name; a premise about all values of a letter is proved for a new one."""
    name, *given = found["of"]
    premises, then = [step(each, meaning) for each in found["premises"]], step(found["then"], meaning)
    if name == "have":
        return {"rule": "have", "formula": term(given[0]), "proof": premises[0], "then": then}
    new: Proof = {"rule": "theorem", "of": name, "premises": premises, "then": then}
    if name == "congruence":
        function, one, other = given
        name = [*function] if isinstance(function, (list, tuple)) else [function]
        new["with"] = {"s": [*name, *map(term, one)], "t": [*name, *map(term, other)]}
    elif name == "enclosure":
        t, digits, *letters = given
        new["with"], new["numbers"] = {"t": term(t), "digits": digits}, {x: term(number) for _, x, number in letters}
    elif name == "known_angle":
        new["of"] = f"known_angle_{given[0]}_{given[1]}"
    elif name in ("principal_value", "first_quadrant"):
        new["of"], new["with"] = f"{name}_{given[0]}", {"t": term(given[1])}
    elif name in _RELATIONAL:
        sign, a, t, back = given
        new["of"], new["with"] = f"{name} {sign}{' back' if back else ''}", {"a": term(a), "t": term(t)}
    else:
        arguments = dict(zip(_PARAMETERS[name].split(), given, strict=True))
        x = arguments.pop("x", None)
        new["with"] = {
            key: {"letter": x, "term": term(value)} if key in ("f", "g") else term(value)
            for key, value in arguments.items()
        }
        if name in ("quarter_turn", "intermediate_value"):
            new["letters"] = [x]
        if x is not None and name not in ("intermediate_value", "constant"):
            last = {"power_rule": 1, "power_diverges": 1, "beta": 4, "beta_diverges": 4}.get(name, 0)
            premises[last] = {"rule": "every", "letters": [x], "then": premises[last]}
    return new


def polynomial(text: str, meaning: Callable[[str], JSON]) -> JSON:
    """A printed polynomial as a term, in which its variables are what they mean."""
    addends = []
    for addend in text.replace(" - ", " + -").split(" + "):
        factors: list[JSON] = []
        for factor in addend.removeprefix("-").split("*"):
            name, _, exponent = factor.partition("^")
            base = number(factor) if factor[0].isdigit() else meaning(name)
            factors.append(["^", base, int(exponent)] if exponent else base)
        product = factors[0] if len(factors) == 1 else ["*", *factors]
        addends.append(["-", product] if addend.startswith("-") else product)
    return addends[0] if len(addends) == 1 else ["+", *addends]


def number(text: str) -> JSON:
    """A rational number such as "-2/7" as a term."""
    value = Fraction(text)
    return value.numerator if value.denominator == 1 else ["/", value.numerator, value.denominator]


def condition(texts: list[str], meaning: Callable[[str], JSON]) -> JSON:
    """A denominator: a numerator, and the denominators in it."""
    top, *below = (polynomial(text, meaning) for text in texts)
    return ["/", top, below[0] if len(below) == 1 else ["*", *below]] if below else top


def point(found: Mapping[str, Any], claim: JSON = None) -> Proof:
    """A point, with the proofs that go with it, and what is shown of the claim there.

    An angle of rational sine and cosine is twice an arctangent.
    """
    given = {x: exactly(value) for x, value in found["values"].items()}
    if constants := given.keys() & {"pi", "infinity"}:
        raise ValueError(f"{', '.join(sorted(constants))} with a value")
    angles = {x[4:] for x in given if x[:4] in ("sin_", "cos_")}
    values = {x: value for x, value in given.items() if x[4:] not in angles or x[:4] not in ("sin_", "cos_")}
    values |= {x: angle(given[f"cos_{x}"], given[f"sin_{x}"]) for x in angles}
    for _ in values:  # coordinates may be given by others
        values = {x: put(value, values) for x, value in values.items()}
    new: Proof = {"values": dict(sorted(values.items()))}
    shown: list[JSON] = []
    if sides := found.get("sides"):
        shown += [value(side, told) for side, told in zip(claim[1:], sides, strict=True)]
    for t, _, low, high in found.get("enclosed", ()):
        shown.append(["and", ["<=", term(low), term(t)], ["<=", term(t), term(high)]])
    if shown:
        new["shown"] = shown
    if calls := found.get("calls"):
        new["calls"] = [
            [["call", name, [*orders], *map(exactly, arguments)], exactly(value)]
            for name, orders, arguments, value in calls
        ]
    known: list[tuple[JSON, Proof]] = [
        (["=", put(term(t), values), term(v)], proof(why)) for t, v, why in found.get("functions", ())
    ]
    known += [(term(fact), proof(why)) for fact, why in found.get("facts", ())]
    last: Proof = {"rule": "compute", "values": [["here", k] for k in range(len(known))]}
    if "proof" in found:
        last = proof(found["proof"])
    if known or "proof" in found:
        facts = 0
        steps: list[tuple[JSON, Proof, int]] = []
        for formula, why in known:
            steps.append((formula, renumbered(why, len(values), facts), facts))
            facts += len(formula) - 1 if formula[0] == "and" else 1
        new["proof"] = renumbered(last, len(values), facts) if "proof" in found else last
        for formula, why, _ in reversed(steps):
            new["proof"] = {"rule": "have", "formula": formula, "proof": why, "then": new["proof"]}
    return new


def value(side: JSON, told: Any) -> JSON:
    """That a side of a claim has a value; a formula is true or false."""
    if told in ("true", "false"):
        return side if told == "true" else ["=>", side, ["or"]]
    return ["=", side, exactly(told)]


def exactly(value: Any) -> JSON:
    """A number at a point, written as "2/7" or as a term."""
    return number(value) if isinstance(value, str) else term(value)


def put(node: JSON, values: Mapping[str, JSON]) -> JSON:
    """A term with letters replaced by numbers; bound letters are left."""
    match node:
        case str():
            return values.get(node, node)
        case [str(kind), body, str(x), *ends] if kind in ("integral", "diverges", "mean"):
            inner = {y: value for y, value in values.items() if y != x}
            return [kind, put(body, inner), x, *(put(end, values) for end in ends)]
        case [kind, *parts]:
            return [kind, *(put(part, values) for part in parts)]
    return node


def renumbered(node: Any, own: int, facts: int) -> Any:
    """References to facts at a point: its coordinates, what was proved there before, and what a step assumes."""
    if isinstance(node, dict):
        return {key: renumbered(value, own, facts) for key, value in node.items()}
    if isinstance(node, list):
        match node:
            case ["hyp", "point", int(k)]:
                return ["point", k] if k < own else ["here", k - own]
            case ["here", int(k)]:
                return ["here", k + facts]
        return [renumbered(value, own, facts) for value in node]
    return node


def angle(cosine: JSON, sine: JSON) -> JSON:
    """The angle of a point of the unit circle."""
    if cosine == -1:
        return ["pi"]
    half = ["/", sine, ["+", 1, cosine]]
    return ["*", 2, ["arctan", rational(half)]]


def rational(node: JSON) -> JSON:
    """A term of whole numbers as one fraction, if it is one."""
    try:
        return number(str(_fraction(node)))
    except TypeError:
        return node


def _fraction(node: JSON) -> Fraction:
    operations: dict[str, Callable[..., Fraction]] = {
        "+": lambda *parts: sum(parts, Fraction(0)), "-": lambda part: -part, "/": lambda top, bottom: top / bottom,
    }  # fmt: skip
    if isinstance(node, int):
        return Fraction(node)
    if node[0] not in operations:
        raise TypeError(node)
    return operations[node[0]](*map(_fraction, node[1:]))
