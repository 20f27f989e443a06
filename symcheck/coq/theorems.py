"""The theorems that certificates take for granted (`symcheck/checker/theorems.py`), each proved in Coq.

Theorems.v proves them as they stand in the checker's table, those about angles as they are added here to what it says;
then they are applied, one by one.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import groupby

from symcheck.checker import theorems as table
from symcheck.coq.assumptions import State
from symcheck.coq.digits import Enclosure
from symcheck.coq.printing import ATOM, IMPLIES, Printer, name, spelled
from symcheck.coq.terms import Certificate
from symcheck.core.calculus import nodes
from symcheck.core.terms import JSON, Term, node

KINDS = {"n": "Z", "f": "R -> R", "g": "R -> R", "h": "R -> R"}  # of parameters
CONGRUENCE = {"congruence": "st", "congruence of two": "stuv"}  # of functions of one argument, and of two
RELATION_NAMES = {"=": "eq", "!=": "ne", "<": "lt", "<=": "le", ">": "gt", ">=": "ge"}
UNSTATED = {  # theorems without a proof in Theorems.v
    "enclosure": "it is computed anew for each number, by the lemmas of Digits.v",
    "beta": "Euler's beta integral is not in Coq's libraries",
    "beta_diverges": "the divergence of an improper integral is not stated in Coq",
    "power_diverges": "the divergence of an improper integral is not stated in Coq",
    **dict.fromkeys(
        ("antiderivative", "antiderivative_everywhere", "antiderivative_converges", "rising", "rising_strictly"),
        "how smooth a function is, is read off its term",
    ),
    **dict.fromkeys(
        (
            "decaying",
            "half_gaussian",
            "gamma_integral",
            "unit_beta",
            "inverted",
            "moved",
            "log_head",
            "power_tail",
            "tail_converges",
            "power_head",
            "head_converges",
            "sum_of_integrals",
            "scaled",
            "pieces",
            "reflected",
            "halves",
            "even",
            "odd",
        ),
        "an improper integral is not stated in Coq",
    ),
    **dict.fromkeys(
        ("gamma", "gamma_values", "gamma_reflected", "gamma_doubled"),
        "Euler's gamma function is not in Coq's libraries",
    ),
}
LEMMAS = {"principal_value": "below", "first_quadrant": "acute", "known_angle": "known"}  # of a function: atan_below
LIKE = {
    "arctangent": ("tangent", "L H"),
    "arcsine": ("sine", "R1 L H"),
    "arccosine": ("cosine", "R1 L H"),
}  # of an order
OF_THEOREMS = (
    "telescope",
    "telescoping_product",
    "sum_of_sums",
    "shifted",
    "gaussian",
    "gaussian_wave",
)  # of what has a form in theorems alone
MISSING = {  # those that no proof may apply
    **{name: reason for name, reason in UNSTATED.items() if name != "enclosure"},
    **dict.fromkeys(OF_THEOREMS, "a sum, a product or an integral without an end has no form in a claim"),
}


class Application:
    """A theorem with what it is applied to: its premises and its conclusion, as they stand in Coq."""

    def __init__(self, state: State, proof: Certificate) -> None:
        self.state, self.name = state, proof["of"]
        self.terms: dict[str, Term] = {}  # what parameters stand for: a number, or the value of a function at a letter
        self.letters: dict[str, str] = {}  # these letters
        for parameter, data in proof.get("with", {}).items():
            if isinstance(data, dict):
                self.letters[parameter], data = data["letter"], data["term"]
            self.terms[parameter] = state.read(data)
        self.numbers = {x: state.read(data) for x, data in proof.get("numbers", {}).items()}
        given = {p: ((self.letters[p],), t) if p in self.letters else t for p, t in self.terms.items()}
        premises, conclusion = table.instance(self.name, given, self.numbers)
        self.premises, self.conclusion = [*map(state.full, premises)], state.full(conclusion)

    def by(self, names: list[str]) -> str:
        """The tactic that proves the conclusion from the premises, which have names."""
        if self.name == "congruence":
            return "f_equal; assumption"
        if self.name == "enclosure":
            known = {x: (own, self.numbers[x]) for x, own in zip(self.numbers, names, strict=True)}
            found = Enclosure(self.state, known).of(self.terms["t"])
            return f"destruct {found.proof} as [low high]; clear - low high; split; lra"
        arguments = [self.argument(parameter) for parameter in table.theorem(self.name).parameters]
        smooth = ["ltac:(is_polynomial)"] if self.name in table.SMOOTH else []
        return f"exact ({' '.join([identifier(self.name), *arguments, *smooth, *names])})"

    def argument(self, parameter: str) -> str:
        """What stands for a parameter in Coq."""
        term = self.terms[parameter]
        if parameter in self.letters:
            return f"(fun {name(self.letters[parameter])} => {spelled(term)})"
        return spelled(term, ATOM)


def statement(name: str) -> str:
    """What the checker takes for granted under that name, as Coq reads it."""
    stated = _congruence(name) if name in CONGRUENCE else table.theorem(name)
    kinds = KINDS | ({"f": "R -> R -> R"} if name == "congruence of two" else {})
    groups = groupby(stated.parameters, key=lambda parameter: kinds.get(parameter, "R"))
    bound = " ".join(f"({' '.join(own)} : {kind})" for kind, own in groups)
    smooth, *of = table.SMOOTH.get(name, ("",))
    kind = "circle" if of else "waves" if name in table.WAVES else "letter"
    premises = [f"polynomial_in_{kind} {smooth}"] if smooth else []
    counted = [part for part in nodes(stated.conclusion) if part.tag in ("sum", "product")]
    premises += [f"whole {end}" for end in dict.fromkeys(end for part in counted for end in part.outside)]
    text = Printer(whole=("n", "k"), of_theorems=name in OF_THEOREMS).text
    premises += [text(premise, IMPLIES - 1) for premise in stated.premises]
    lines = [f"forall {bound},"] if bound else []
    lines += [*(f"{premise} ->" for premise in premises), text(stated.conclusion)]
    return "\n".join(f"  {line}" for line in lines)


def _congruence(name: str) -> table.Theorem:
    """It has as many premises as the function has arguments; here they are letters."""
    letters = CONGRUENCE[name]
    one, other = (node("call", "f", (0,) * len(own), *own) for own in (letters[::2], letters[1::2]))
    premises, conclusion = table.congruence({"s": one, "t": other})
    return table.Theorem(("f", *letters), tuple(premises), conclusion)


def identifier(name: str) -> str:
    """The name of a theorem in Theorems.v."""
    return "theorem_" + "_".join(RELATION_NAMES.get(word, word) for word in name.split())


def about_angles() -> str:
    """The theorems that lemmas of Symcheck.v give alike, for each function of an angle and each order, with proofs."""
    proofs = {name: _from_lemma(name) for name in table.NAMES}
    return "".join(
        f"\nTheorem {identifier(name)} :\n{statement(name)}.\nProof. {proof}. Qed.\n"
        for name, proof in proofs.items()
        if proof
    )


def _from_lemma(name: str) -> str:
    """The proof from such a lemma; empty if there is none."""
    if of_function := re.fullmatch(rf"({'|'.join(LEMMAS)})_arc(tan|sin|cos)(_\d)?", name):
        kind, function, which = of_function.groups("")
        return f"exact a{function}_{LEMMAS[kind]}{which}"
    kind, *order = name.split()
    if kind not in LIKE:
        return ""
    lemma, premises = LIKE[kind]
    alike = f"alike_{RELATION_NAMES[order[0]]} (alike_{lemma} {premises})"
    return f"intros a t {premises} I. exact (proj{len(order)} ({alike}) I)"


def everything(names: Iterable[str]) -> str:
    """What all of these together assume."""
    used = "\n".join(f"pose proof {own}." for own in names)
    return f"Lemma everything : True.\nProof.\n{used}\nexact I.\nQed.\n\nPrint Assumptions everything.\n"


def missing(proof: JSON) -> str | None:
    """Why a proof has no form in Coq, if it uses a theorem that is not there."""
    parts = proof if isinstance(proof, list) else proof.values() if isinstance(proof, dict) else ()
    own = MISSING.get(str(proof.get("of"))) if isinstance(proof, dict) else None
    return own or next(filter(None, map(missing, parts)), None)
