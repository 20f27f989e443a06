"""The proof methods a claim can name. Each takes hints as LaTeX; what arrives in a problem's hints is lowered already.

All decide statements of any shape the same way; they differ in the hints they carry.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symcheck.core.claims import Method, Outcome, Problem
from symcheck.core.terms import Term
from symcheck.proof.algebra.polynomial import alone
from symcheck.proof.algebra.variables import Unsupported
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.proof import Proof
from symcheck.proof.search import counterexample, witnesses
from symcheck.proof.search import decide as deciding
from symcheck.proof.search.decide import decide
from symcheck.proof.search.splitting import prove
from symcheck.proof.search.wellformed import checked
from symcheck.proof.search.witnesses import FALSE


def _decide(problem: Problem) -> Outcome:
    with alone(problem):  # which of equal terms a variable stands for depends on this problem alone
        return decide(problem, prove)


def refute(problem: Problem) -> Point | None:
    """A point where the hypotheses hold and the claim does not, or None; what functions are there is not looked for."""
    with alone(problem):
        try:
            problem = checked(problem)
            return counterexample.refute(problem)
        except (Unsupported, RecursionError, ArithmeticError, ValueError):
            return None


def whole_proof(problem: Problem) -> Proof | None:
    """A proof, or None; unlike a method it looks for no counterexample.

    What it rests on holds at some point, except where "0 = 1" is proved: that its hypotheses contradict one another.
    """
    with alone(problem):
        try:
            problem = checked(problem)
            proof = deciding.prove(problem, prove)
            if proof is None or problem.claim == FALSE:
                return proof
            return deciding.with_witnesses(problem, proof, prove)
        except (Unsupported, RecursionError, ArithmeticError, ValueError):
            return None


def proof_of(problem: Problem) -> Outcome | None:
    """The outcome of such a proof, or None."""
    proof = whole_proof(problem)
    return None if proof is None else deciding.proved(problem, proof)


def find_witnesses(problem: Problem, nonzero: Sequence[Term] = ()) -> list[Point] | None:
    """Points at which all that a statement rests on holds (`witnesses.py`); what functions are there is proved."""
    with alone(problem):
        return witnesses.find_witnesses(problem, nonzero, lambda inner: deciding.prove(inner, prove))


identity = Method("identity", _decide)


def nonnegative(form: str = "") -> Method:
    """An order l <= r: r - l equals `form` (LaTeX) modulo the hypotheses, and the form is manifestly not negative."""
    return Method("nonnegative", _decide, (("form", form),) if form else ())


def cases(*forms: str) -> Method:
    """Logic: implications, equivalences, alternatives, by splitting into cases; forms (LaTeX) are sums that vanish."""
    return Method("cases", _decide, tuple((f"form{k}", form) for k, form in enumerate(forms)))


def existence(**point: str) -> Method:
    """A point (LaTeX values of the bound variables), or a zero between an angle and the angle plus 90 degrees."""
    return Method("existence", _decide, tuple((f"point_{name}", value) for name, value in point.items()))


def combined(*methods: Method, forms: Sequence[str] = ()) -> Method:
    """All hints of the methods, with further forms."""
    own = [hint for method in methods for hint in method.hints]
    kept = dict.fromkeys(latex for name, latex in own if not name.startswith(("point", "theorem.")))
    others = dict.fromkeys(hint for hint in own if hint[0].startswith("theorem."))
    return Method("cases", _decide, (*cases(*kept, *forms).hints, *others))


def looking_at(method: Method, **point: str) -> Method:
    """The method, with the values (LaTeX) of a point to try first when a counterexample is looked for."""
    return replace(method, hints=(*method.hints, *((f"point.{name}", value) for name, value in point.items())))


def theorems(*applied: tuple[str, ...]) -> Method:
    """Facts about functions: (a theorem, what it is applied to in LaTeX), ... beside those found without help."""
    hints = [
        (f"theorem.{k}.{name}.{n}", latex) for k, (name, *parts) in enumerate(applied) for n, latex in enumerate(parts)
    ]
    return Method("theorems", _decide, tuple(hints))
