"""Kernels of the pendulum."""

from symcheck.kernels.codegen.kernel import Argument, Kernel, Output
from symcheck.papers.pendulum import derivation

length = Kernel(
    says="Length of the simple pendulum that swings as the body does.",
    arguments=(
        Argument("m", "mass", "kg", low="0"),
        Argument("a", "distance of the axis from the centre of mass", "m", low="0"),
        Argument("I_c", "moment of inertia about the centre of mass", "kg m^2", low="0"),
    ),
    outputs=(Output("l", "length", "m"),),
    derived=derivation.length,
    claims=("4", "5"),
)
