"""The theorems that certificates take for granted (`symcheck/checker/theorems.py`), each proved in Coq.

Theorems.v proves them as they stand in the checker's table; here they are applied, one by one.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby
from typing import TYPE_CHECKING, Any

from symcheck.checker import theorems as table
from symcheck.core.terms import node
from symcheck.export.coq.digits import Enclosure
from symcheck.export.coq.printing import IMPLIES, name, printed, spelled
from symcheck.export.coq.terms import NotExported
from symcheck.proof.theorems import THEOREMS, Terms, conjuncts

if TYPE_CHECKING:
    from symcheck.export.coq.script import Script

KINDS = {"n": "Z", "f": "R -> R", "g": "R -> R"}  # of parameters
CONGRUENCE = {"congruence": "st", "congruence of two": "stuv"}  # of functions of one argument, and of two
ALIKE = {"=": "eq", "!=": "ne", "<": "lt", "<=": "le", ">": "gt", ">=": "ge"}
UNSTATED = {  # theorems without a proof in Theorems.v
    "enclosure": "it is computed anew for each number, by the lemmas of Digits.v",
    "beta": "Euler's beta integral is not in Coq's libraries",
    "beta_diverges": "the divergence of an improper integral is not stated in Coq",
    "power_diverges": "the divergence of an improper integral is not stated in Coq",
    "even": "an improper integral is not stated in Coq",
    "odd": "an improper integral is not stated in Coq",
    "gamma": "Euler's gamma function is not in Coq's libraries",
    "gamma_values": "Euler's gamma function is not in Coq's libraries",
}
MISSING = {  # theorems that are not applied in proofs
    **{name: reason for name, reason in UNSTATED.items() if name != "enclosure"},
    "power_rule": "the integral of a power with a letter in the exponent",
    "intermediate_value": "the intermediate value theorem",
}


def apply(script: Script, goal: Any, proof: Any) -> None:
    """The premises of a theorem with their proofs, then its conclusion as one more assumption."""
    kind, *given = proof["of"]
    theorem = THEOREMS[kind](Terms(dict(script.statement.definitions.terms)), *given)
    given = [script.full(t) if isinstance(t, (list, str)) and kind not in ("known_angle",) else t for t in given]
    if kind in BINDING:
        BINDING[kind](script, given, proof)
    else:
        names = []
        for premise, inner in zip(map(script.full, theorem.premises), proof["premises"], strict=True):
            names.append(script.anew("t"))
            script.emit(f"assert ({names[-1]} : {spelled(premise)}).")
            script.branch(premise, inner)
        conclusion = script.full(theorem.conclusion)
        script.same_functions([conclusion])
        own = script.anew("t")
        script.emit(f"assert ({own} : {spelled(conclusion)}) by ({BY[kind](script, given, names, theorem)}).")
        script.emit(f"destruct {own} as {taken(script, conclusion, own)}." if len(conjuncts(conclusion)) > 1 else "")
        if len(conjuncts(conclusion)) == 1:
            script.learn(conjuncts(conclusion)[0], own)
    script.emit_later()
    script.prove(goal, proof["then"])


def statement(name: str) -> str:
    """What the checker takes for granted under that name, as Coq reads it."""
    stated = _congruence(name) if name in CONGRUENCE else table.theorem(name)
    kinds = KINDS | ({"f": "R -> R -> R"} if name == "congruence of two" else {})
    groups = groupby(stated.parameters, key=lambda parameter: kinds.get(parameter, "R"))
    bound = " ".join(f"({' '.join(own)} : {kind})" for kind, own in groups)
    smooth, *of = table.SMOOTH.get(name, ("",))
    premises = [f"polynomial_in_{'circle' if of else 'letter'} {smooth}"] if smooth else []
    premises += [printed(_as_exported(premise), IMPLIES - 1) for premise in stated.premises]
    lines = [f"forall {bound},"] if bound else []
    lines += [*(f"{premise} ->" for premise in premises), printed(_as_exported(stated.conclusion))]
    return "\n".join(f"  {line}" for line in lines)


def _congruence(name: str) -> table.Theorem:
    """It has as many premises as the function has arguments; here they are letters."""
    letters = CONGRUENCE[name]
    one, other = (node("call", "f", (0,) * len(own), *own) for own in (letters[::2], letters[1::2]))
    premises, conclusion = table.congruence({"s": one, "t": other})
    return table.Theorem(("f", *letters), tuple(premises), conclusion)


def identifier(name: str) -> str:
    """The name of a theorem in Theorems.v."""
    return "theorem_" + "_".join(ALIKE.get(word, word) for word in name.split())


def _as_exported(tree: Any) -> Any:
    """A term of the checker's language in the form in which this package takes terms."""
    match tree:
        case ("pi",):
            return "pi"
        case ("diff", body, x, n, place) if place == x:
            return ["diff", _as_exported(body), x, n]
        case "n" | "k":  # whole numbers
            return ["IZR", tree]
        case ("^", base, str(n)):
            return ["powerRZ", _as_exported(base), n]
        case ("^", base, n):
            return ["^", _as_exported(base), n]
        case ("call", function, orders, *arguments):
            return ["call", function, list(orders), *map(_as_exported, arguments)]
        case ("forall" | "exists" as kind, bound, body):
            return [kind, list(bound), _as_exported(body)]
        case (str(), *parts):
            return [tree[0], *map(_as_exported, parts)]
    return tree


def missing(proof: Any) -> str | None:
    """Why a proof has no form in Coq, if it uses a theorem that is not there."""
    if isinstance(proof, list):
        return next(filter(None, map(missing, proof)), None)
    if not isinstance(proof, dict):
        return None
    own = MISSING.get(proof["of"][0]) if "of" in proof else None
    return own or next(filter(None, map(missing, proof.values())), None)


def taken(script: Script, conclusion: Any, own: str) -> str:
    """The pattern for a conclusion of several parts."""
    return script.assume(conclusion)


def exact(lemma: str) -> Callable[..., str]:
    """The lemma applied to the proofs of its premises."""
    return lambda script, given, names, theorem: f"exact ({' '.join([lemma, *names])})"


def known_angle(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """One of the angles 0, 30, 45, 60 and 90 degrees."""
    function, number = given
    return f"exact {function.replace('arc', 'a')}_known_{number}"


def principal(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """The range of an inverse function."""
    lemma = given[0].replace("arc", "a") + "_below"
    return f"exact ({' '.join([lemma, script.bracketed(given[1]), *names])})"


def first_quadrant(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """The angle of a number that is not negative is at most a right one."""
    lemma = given[0].replace("arc", "a") + "_acute"
    return f"exact ({' '.join([lemma, script.bracketed(given[1]), *names])})"


def angle(lemma: str) -> Callable[..., str]:
    """An angle compared with arctan t, arcsin t or arccos t, in one direction or the other."""

    def by(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
        sign, *_, back = given
        *domain, last = names
        way = "proj2" if back else "proj1"
        return f"exact ({way} (alike_{ALIKE[sign]} ({' '.join([lemma, *domain])})) {last})"

    return by


def power_of_power(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """With the exponent as a natural number of Coq."""
    _, n, exponent = given
    if not isinstance(n, int) or n < 0:
        raise NotExported("a power of a power with a negative exponent")
    shown = script.bracketed(exponent)
    power = f"generalize (power_of_power (u := {shown}) {n} {names[0]})"
    return f"{power}; simpl INR; intro Q; exact Q"


def dichotomy(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """A number is positive or it is not."""
    return f"exact (dichotomy {script.bracketed(given[0])})"


def have(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """What has just been shown."""
    return f"exact {names[0]}"


def congruence(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """Equal arguments are exchanged."""
    return "f_equal; assumption"


def enclosure(script: Script, given: list[Any], names: list[str], theorem: Any) -> str:
    """The ends of the interval, step by step."""
    term, _, *letters = given
    known = {x: (own, value) for (_, x, value), own in zip(letters, names, strict=True)}
    found = Enclosure(script, known).of(term)
    return f"destruct {found.proof} as [low high]; clear - low high; split; lra"


BY: dict[str, Callable[..., str]] = {
    "have": have,
    "constant": lambda script, given, names, theorem: "constant_integral",
    "enclosure": enclosure,
    "congruence": congruence,
    "dichotomy": dichotomy,
    "root": exact("root"),
    "root_of_product": exact("root_of_product"),
    "equal_squares": exact("equal_squares"),
    "power": exact("power"),
    "power_of_sum": exact("power_of_sum"),
    "power_of_product": exact("power_of_product"),
    "power_of_power": power_of_power,
    "power_inverse": exact("power_inverse"),
    "circle_number": exact("circle_number"),
    "known_angle": known_angle,
    "principal_value": principal,
    "first_quadrant": first_quadrant,
    "arctangent": angle("alike_tangent"),
    "arcsine": angle("alike_sine"),
    "arccosine": angle("alike_cosine"),
    "right_half": exact("cos_acute"),
}


def mean(script: Script, given: list[Any], proof: Any) -> None:
    """Coquelicot's integral over one turn, by the primitive of the difference from the mean."""
    f, x, m, g = given
    fx, gx = (f"(fun {name(x)} => {spelled(t)})" for t in (f, g))
    own = script.anew("h")
    script.emit(f"assert ({own} : {spelled(['=', ['mean', f, x], m])}).")
    kept = list(script.hints)
    script.emit(f"{{ refine (mean_by (f := {fx}) (g := {gx}) (m := {spelled(m)}) _ _ _).")
    script.emit(f"{{ intros {name(x)}. auto_derive; conditions. }}")
    script.emit(f"{{ intros {name(x)}.")
    script.emit(f"pose proof (circle {name(x)}) as {(hint := script.anew('e'))}.")
    divides, script.divides = script.divides, True
    script.hints = [*kept, hint]
    script.emit(f"auto_derive; [ conditions | {script.algebra} ]. }}")
    script.emit("{ rewrite ?cos_2PI, ?sin_2PI, ?cos_0, ?sin_0. ")
    script.hints = kept
    script.emit(f"{script.algebra}. }} }}")
    script.divides = divides
    script.learn(["=", ["mean", f, x], m], own)


BINDING: dict[str, Callable[[Script, list[Any], Any], None]] = {"mean": mean}


def quarter_turn(script: Script, given: list[Any], proof: Any) -> None:
    """The angle where the function is zero."""
    p, x = given
    own, fact = script.anew("t"), script.anew("h")
    shown = name(x)
    script.emit(f"assert ({own} : exists {shown} : R, {spelled(['=', p, 0])}).")
    script.emit(f"{{ refine (quarter_turn (fun {shown} => {spelled(p)}) _ _).")
    script.emit(f"{{ intros {shown}. auto_derive; conditions. }}")
    script.emit(f"{{ intros {shown}. cbv beta. rewrite ?cos_plus, ?sin_plus, cos_PI2, sin_PI2.")
    script.emit(f"pose proof (circle {shown}) as {(hint := script.anew('e'))}.")
    kept, script.hints = list(script.hints), [*script.hints, hint]
    script.emit(f"{script.algebra}. }} }}")
    script.hints = kept
    script.emit(f"destruct {own} as [{shown} {fact}].")
    script.scope.add(x)
    script.functions([p])
    script.learn(["=", p, 0], fact)


BINDING["quarter_turn"] = quarter_turn
