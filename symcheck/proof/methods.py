"""The proof methods a claim can name. Each takes hints as LaTeX; what arrives in a problem's hints is lowered already.

All decide statements of any shape the same way; they differ in the hints they carry.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symcheck.core.problems import Applied, Candidate, Form, Method, Outcome, Problem, Witness
from symcheck.core.terms import Term
from symcheck.core.verdicts import Certificate, Verdict
from symcheck.proof import counterexample, witness
from symcheck.proof import decide as deciding
from symcheck.proof.decide import decide
from symcheck.proof.polynomial import alone
from symcheck.proof.splitting import prove
from symcheck.proof.variables import Unsupported
from symcheck.proof.wellformed import checked
from symcheck.proof.witness import FALSE


def _decide(problem: Problem) -> Outcome:
    with alone(problem):  # which of equal terms a variable stands for depends on this problem alone
        return decide(problem, prove)


def refute(problem: Problem) -> Certificate | None:
    """A point where the hypotheses hold and the claim does not, or None; what functions are there is not looked for."""
    with alone(problem):
        try:
            problem = checked(problem)
            return counterexample.refute(problem)
        except (Unsupported, RecursionError, ArithmeticError, ValueError):
            return None


def proof_of(problem: Problem) -> Outcome | None:
    """A proof, or None; unlike a method it looks for no counterexample.

    What it rests on holds at some point, except where "0 = 1" is proved: that its hypotheses contradict one another.
    """
    with alone(problem):
        try:
            problem = checked(problem)
            outcome = deciding.prove(problem, prove)
            if outcome is None or problem.claim == FALSE:
                return outcome
            outcome = deciding.with_witnesses(problem, outcome, prove)
            return outcome if outcome.verdict is Verdict.PROVED else None
        except (Unsupported, RecursionError, ArithmeticError, ValueError):
            return None


def find_witnesses(problem: Problem, nonzero: Sequence[Term] = ()) -> list[Certificate] | None:
    """Points at which all that a statement rests on holds (`witness.py`); what functions are there is proved."""
    with alone(problem):
        return witness.find_witnesses(problem, nonzero, lambda inner: deciding.prove(inner, prove))


identity = Method("identity", _decide)


def nonnegative(form: str = "") -> Method:
    """An order l <= r: r - l equals `form` (LaTeX) modulo the hypotheses, and the form is manifestly not negative."""
    return Method("nonnegative", _decide, (Form(form),) if form else ())


def cases(*forms: str) -> Method:
    """Logic: implications, equivalences, alternatives, by splitting into cases; forms (LaTeX) are sums that vanish."""
    return Method("cases", _decide, tuple(map(Form, forms)))


def existence(**point: str) -> Method:
    """A point (LaTeX values of the bound variables), or a zero between an angle and the angle plus 90 degrees."""
    return Method("existence", _decide, (Witness(tuple(point.items())),) if point else ())


def combined(*methods: Method, forms: Sequence[str] = ()) -> Method:
    """All hints of the methods, with further forms."""
    own = [hint for method in methods for hint in method.hints]
    kept = dict.fromkeys(hint for hint in own if isinstance(hint, Form))
    applied = dict.fromkeys(hint for hint in own if isinstance(hint, Applied))
    return Method("cases", _decide, (*kept, *map(Form, forms), *applied))


def looking_at(method: Method, **point: str) -> Method:
    """The method, with the values (LaTeX) of a point to try first when a counterexample is looked for."""
    return replace(method, hints=(*method.hints, Candidate(tuple(point.items()))))


def theorems(*applied: Applied[str]) -> Method:
    """Facts about functions, besides those that are found without help: theorems applied to LaTeX."""
    return Method("theorems", _decide, applied)
