"""Runs of claims that leave the same dimensionless letters as they are: b = lambda_1/omega_0, Delta = C - A."""

from symcheck.papers.declare import Scope
from symcheck.papers.esenkov2006.notation import root_letters

in_b = Scope(keeping=("b",))
in_delta = Scope(keeping=("Delta",))
in_b_and_delta = Scope(keeping=("b", "Delta"))
of_roots = Scope(root_letters, keeping=("b", "Delta")).by_cases
