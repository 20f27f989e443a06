"""Runs of claims about J_i and L_i for any axes, or for axes given by formulas."""

from symcheck.papers.declare import Scope
from symcheck.papers.mirer2009 import derivation
from symcheck.papers.mirer2009.notation import closed_form_letters, family_letters

free_moments = ("J", "L")
in_moments = Scope(keeping=free_moments)
from_lemmas_in_moments = Scope(free=free_moments)
proportional = Scope(where=derivation.proportional_gains, keeping=free_moments)
second_axis = Scope(family_letters, derivation.second_axis_components, keeping=("c",))
equal_moments = Scope(closed_form_letters, derivation.equal_moment_family, keeping=("c",))
