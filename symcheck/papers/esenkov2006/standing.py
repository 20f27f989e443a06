"""What the relations of Esenkov 2006 are read under without its being printed, and what holds at the ends and outside.

A relation whose proof needs one of these conditions is marked by it.
"""

from __future__ import annotations

from symcheck.papers.declare import standing
from symcheck.papers.esenkov2006.both_texts import DISCRIMINANT, QUADRATIC
from symcheck.papers.esenkov2006.hypotheses import (
    body_has_mass,
    liquid_is_part,
    liquid_moves,
    roots_are_real_numbers,
    spinning,
)
from symcheck.papers.esenkov2006.scopes import in_b_and_delta, in_delta
from symcheck.papers.esenkov2006.second_text import BOUNDARY

mass = standing("S.1", 7, body_has_mass, "{}", reason="not printed; it is a moment of inertia")

spin = standing("S.2", 7, spinning, "Where it is divided by omega_0: {}.", without="S.6")

mode_moves = standing(
    "S.3", 34, liquid_moves, "In the roots of the boundary: {}.", without="S.7, S.8; it is positive by B.1"
)

mode_is_part = standing(
    "S.4", 34, liquid_is_part, "There, and where D is needed: {}.", without="B.24 (A = E_n), B.25 (E_n > A)"
)

real_square_roots = standing(
    "S.5",
    34,
    roots_are_real_numbers,
    "There too: {}.",
    without="B.9, B.10 (outside there is no boundary), B.22, B.23 (at the ends both roots are one)",
)

body_at_rest = in_delta.by_cases.ours(
    "S.6",
    34,
    words="Without spin (1.34) and b_n have no value; the frequencies are zero and A lambda_1 / (A - E_1), always real: D = (A lambda_n)^2.",
    states=rf"\omega_0 = 0 \Rightarrow ({QUADRATIC} = \eta((A - E_1)\eta - A\lambda_1) \land {DISCRIMINANT} = (A\lambda_n)^2)",
    uses=["1.33", "1.33.3", "1.34"],
)

mode_without_inertia = in_delta.by_cases.ours(
    "S.7",
    34,
    words="A mode without inertia is not coupled to the body: one frequency is lambda_1, the other -Delta omega_0 / A, that of a rigid body; "
    "D is not negative.",
    states=rf"E_1 = 0 \Rightarrow ({QUADRATIC} = (\eta - \lambda_1)(A\eta + \Delta\omega_0) \land "
    rf"{DISCRIMINANT} = (\Delta\omega_0 + A\lambda_n)^2)",
    uses=["1.33", "1.33.3"],
)

boundary_without_inertia = in_b_and_delta.by_cases.ours(
    "S.8",
    34,
    words="Both roots (1.35) of the boundary are then -A b_n.",
    states=rf"E_n = 0 \Rightarrow {BOUNDARY} = (\Delta + Ab_n)^2",
    uses=["1.34.3", "1.35"],
)
