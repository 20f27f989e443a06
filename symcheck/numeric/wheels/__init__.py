"""Arrays of reaction wheels: what momenta they reach, whether these suffice, how to share them, what failures cost.

One set of wheels has axes of the shape (n, 3), unit vectors in the body's principal axes, and limits, the largest
momenta of the wheels. All functions on many sets broadcast over leading axes.
"""

from symcheck.numeric.wheels.allocation import Allocation, allocate, allocate_least_squares
from symcheck.numeric.wheels.angles import (
    Optimum,
    best_angle_of_six_wheels,
    best_angles_of_four_wheels,
    best_parameters,
    equal_rates_of_four_wheels,
    equal_rates_of_six_wheels,
)
from symcheck.numeric.wheels.arrangement import Arrangement, Design, design
from symcheck.numeric.wheels.faces import Failures, HalfSpaces, face_distances, failures, half_spaces
from symcheck.numeric.wheels.interactive import interactive_axes, interactive_envelope
from symcheck.numeric.wheels.margins import (
    ellipsoid_margin,
    ellipsoid_scale,
    guaranteed_rate,
    largest_momentum,
    margin,
    rates,
)
from symcheck.numeric.wheels.null_motion import ClearMomenta, clear_momenta, null_motions, null_torque
from symcheck.numeric.wheels.plots import (
    plot_axes,
    plot_envelope,
    plot_failures,
    plot_projection,
    plot_projections,
)
from symcheck.numeric.wheels.polytope import Envelope, envelope
from symcheck.numeric.wheels.sets import (
    Wheels,
    four_wheels,
    listed_vertices,
    six_wheels,
    total_momentum,
    volume,
    wheels_of,
)
from symcheck.numeric.wheels.torque import TorqueRange, torque_envelope, torque_half_spaces, torque_range
from symcheck.numeric.wheels.trade import Trade, WheelType, cone, pareto_front, plot_trade, trade

__all__ = [
    "Allocation",
    "Arrangement",
    "ClearMomenta",
    "Design",
    "Envelope",
    "Failures",
    "HalfSpaces",
    "Optimum",
    "TorqueRange",
    "Trade",
    "WheelType",
    "Wheels",
    "allocate",
    "allocate_least_squares",
    "best_angle_of_six_wheels",
    "best_angles_of_four_wheels",
    "best_parameters",
    "clear_momenta",
    "cone",
    "design",
    "ellipsoid_margin",
    "ellipsoid_scale",
    "envelope",
    "equal_rates_of_four_wheels",
    "equal_rates_of_six_wheels",
    "face_distances",
    "failures",
    "four_wheels",
    "guaranteed_rate",
    "half_spaces",
    "interactive_axes",
    "interactive_envelope",
    "largest_momentum",
    "listed_vertices",
    "margin",
    "null_motions",
    "null_torque",
    "pareto_front",
    "plot_axes",
    "plot_envelope",
    "plot_failures",
    "plot_projection",
    "plot_projections",
    "plot_trade",
    "rates",
    "six_wheels",
    "torque_envelope",
    "torque_half_spaces",
    "torque_range",
    "total_momentum",
    "trade",
    "volume",
    "wheels_of",
]
