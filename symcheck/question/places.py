"""Whether an equation of a function's value holds at all places, as f(x) = 2 x does, or at one, as u(L) = 0."""

from __future__ import annotations

from collections.abc import Iterable

from symcheck.core.calculus import letters
from symcheck.core.terms import Call, Formula, Node, Term, mapped

_LATIN = frozenset("fgijkmnpqrstuvwxyz")
_GREEK = frozenset(
    {"alpha", "beta", "chi", "epsilon", "eta", "gamma", "kappa", "lambda", "mu", "nu", "omega", "phi", "psi", "rho"}
    | {"sigma", "tau", "theta", "varepsilon", "varphi", "vartheta", "xi", "zeta"}
)
INDICES = frozenset("ijk")  # for any of several letters; n and 0 tell one of a sequence


def runs(name: str) -> bool:
    """Is a letter, in LaTeX or by its name, one that usually takes all values, and not L, a or x_0?"""
    base, _, label = name.lstrip("\\").partition("_")
    return base.removesuffix("prime").rstrip("'") in _LATIN | _GREEK and {*label.strip("{} ")} <= INDICES


def is_one_place(name: str, beside: Iterable[str]) -> bool:
    """Is the argument of a function hardly meant to take all values? `beside`: the letters beside the function."""
    labelled = not {*name.partition("_")[2].strip("{} ")} <= INDICES
    return labelled or not (runs(name) or name in beside)


def is_at_one_place(equation: Formula, name: str) -> bool:
    """The same of an equation in which the letter is the argument of functions."""
    return is_one_place(name, letters(_without_values(equation)))


def _without_values(tree: Term) -> Term:
    if isinstance(tree, Call):
        return 0
    return mapped(tree, _without_values) if isinstance(tree, Node) else tree
