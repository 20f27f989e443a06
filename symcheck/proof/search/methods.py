"""The proof methods a claim can name. Each takes hints as LaTeX; what arrives in a problem's hints is lowered already.

All decide statements of any shape the same way; they differ in the hints they carry.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symcheck.core.problems import Applied, Candidate, Form, Method, Outcome, Problem, Witness
from symcheck.core.terms import Term
from symcheck.proof.algebra.polynomial import alone
from symcheck.proof.algebra.variables import Unsupported
from symcheck.proof.rules.compute import Point
from symcheck.proof.rules.proof import Proof
from symcheck.proof.search import counterexample, witnesses
from symcheck.proof.search.decide import decide, prove, proved, with_witnesses
from symcheck.proof.search.wellformed import checked
from symcheck.proof.search.witnesses import ZERO_IS_ONE

LIMITS = (Unsupported, RecursionError, ArithmeticError, ValueError)  # raised where a search reaches a limit


def _decide(problem: Problem) -> Outcome:
    with alone(problem):  # which of equal terms a variable stands for depends on this problem alone
        return decide(problem)


def refute(problem: Problem) -> Point | None:
    """Look for an exact point where the hypotheses hold and the claim does not.

    Parameters
    ----------
    problem
        What to refute. Values of functions at a point are not looked for.

    Returns
    -------
    Point or None
        The values of the letters, with both sides of the claim; None if no point was found.

    See Also
    --------
    proof_of : A proof, without a search for a counterexample.
    """
    with alone(problem):
        try:
            problem = checked(problem)
            return counterexample.refute(problem)
        except LIMITS:
            return None


def whole_proof(problem: Problem) -> Proof | None:
    """The proof alone, or None; see `proof_of`."""
    with alone(problem):
        try:
            problem = checked(problem)
            proof = prove(problem)
            if proof is None or problem.claim == ZERO_IS_ONE:
                return proof
            return with_witnesses(problem, proof)
        except LIMITS:
            return None


def proof_of(problem: Problem) -> Outcome | None:
    """Look for a proof, and for no counterexample.

    Parameters
    ----------
    problem
        What to prove.

    Returns
    -------
    Outcome or None
        The proof; None if none was found.

    Notes
    -----
    What a proof rests on holds at some point, except where ``0 = 1`` is proved: that the hypotheses contradict one
    another.
    """
    proof = whole_proof(problem)
    return None if proof is None else proved(problem, proof)


def find_witnesses(problem: Problem, nonzero: Sequence[Term] = ()) -> list[Point] | None:
    """Find points at which everything that a statement rests on holds.

    Parameters
    ----------
    problem
        The statement. What its functions are at a point is proved.
    nonzero
        Terms that must not vanish there either.

    Returns
    -------
    list of Point or None
        A point for each set of conditions; None if one of them has none.
    """
    with alone(problem):
        return witnesses.find_witnesses(problem, nonzero, prove)


identity = Method("identity", _decide)


def nonnegative(form: str = "") -> Method:
    """Return the method for an order, with a form of the difference that is manifestly not negative.

    Parameters
    ----------
    form
        The larger side less the smaller one, modulo the hypotheses, as LaTeX; a sum of squares, for instance. Without
        a form the search looks for one.

    Returns
    -------
    Method
        For the parameter `by` of a claim.

    See Also
    --------
    cases : For statements that combine several orders.
    """
    return Method("nonnegative", _decide, (Form(form),) if form else ())


def cases(*forms: str) -> Method:
    """Return the method for implications, equivalences and alternatives, which splits into cases.

    Parameters
    ----------
    *forms
        Sums that vanish, as LaTeX.

    Returns
    -------
    Method
        For the parameter `by` of a claim.
    """
    return Method("cases", _decide, tuple(map(Form, forms)))


def existence(**point: str) -> Method:
    """Return the method for a statement that something exists.

    Parameters
    ----------
    **point
        The values of the bound letters, as LaTeX. Without them the search looks for a zero between an angle and the
        angle plus 90 degrees.

    Returns
    -------
    Method
        For the parameter `by` of a claim.
    """
    return Method("existence", _decide, (Witness(tuple(point.items())),) if point else ())


def combined(*methods: Method, forms: Sequence[str] = ()) -> Method:
    """Return a method with the hints of several ones.

    Parameters
    ----------
    *methods
        The methods whose hints are wanted.
    forms
        Further sums that vanish, as LaTeX.

    Returns
    -------
    Method
        For the parameter `by` of a claim.
    """
    own = [hint for method in methods for hint in method.hints]
    kept = dict.fromkeys(hint for hint in own if isinstance(hint, Form))
    applied = dict.fromkeys(hint for hint in own if isinstance(hint, Applied))
    return Method("cases", _decide, (*kept, *map(Form, forms), *applied))


def looking_at(method: Method, **point: str) -> Method:
    """Return a method that tries a point first when it looks for a counterexample.

    Parameters
    ----------
    method
        The method.
    **point
        The values of the letters there, as LaTeX.

    Returns
    -------
    Method
        For the parameter `by` of a claim.
    """
    return replace(method, hints=(*method.hints, Candidate(tuple(point.items()))))


def theorems(*applied: Applied[str]) -> Method:
    """Return the method for statements about functions, which applies theorems of the checker's table.

    Parameters
    ----------
    *applied
        Theorems, each with the terms to which it is applied, as LaTeX. Many theorems are found without help.

    Returns
    -------
    Method
        For the parameter `by` of a claim.

    Notes
    -----
    The table is `symcheck.checker.theorems`. The premises of a theorem are proved like everything else.
    """
    return Method("theorems", _decide, applied)
