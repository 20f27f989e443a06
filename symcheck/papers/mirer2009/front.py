"""Mirer 2009, title page and abstract."""

from symcheck.papers.declare import exclusion
from symcheck.papers.mirer2009.forms import ALIGNED, excess_of_product
from symcheck.papers.mirer2009.hypotheses import non_negative_moments, orthogonal
from symcheck.papers.mirer2009.scopes import from_lemmas_in_moments
from symcheck.proof import cases

product_minimal_in_principal_axes = from_lemmas_in_moments.claim(
    "0.1",
    25,
    words="The product of the moments of inertia about three orthogonal axes is least when these are principal axes.",
    states=r"(J_1 J_2 J_3 \ge I_1 I_2 I_3) \land "
    rf"({ALIGNED} \Rightarrow J_1 J_2 J_3 = I_1 I_2 I_3)",
    given=[orthogonal, non_negative_moments],
    by=cases(excess_of_product),
    uses=["2.10", "2.17"],
    lemmas=["2.13.4", "2.0.5"],
)

abstract_in_english = exclusion("0.2", 33, words="The abstract once more, in English.", reason="repeats 0.1")
