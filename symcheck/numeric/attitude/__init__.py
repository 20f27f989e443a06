"""Orientations as rotations, quaternions and MRPs; turns of a body by its wheels; momentum that disturbances leave.

Wherever the numeric layer takes three orthonormal axes it takes a `scipy.spatial.transform.Rotation` too: the one that
turns the reference axes into them.
"""

from symcheck.numeric.attitude.agility import Agility, AgilityAfterFailures, agility, agility_after_failures, turn_time
from symcheck.numeric.attitude.disturbance import (
    MomentumOfAPeriod,
    momentum_in_time,
    momentum_of_a_period,
    time_to_saturation,
)
from symcheck.numeric.attitude.export import to_42, to_basilisk
from symcheck.numeric.attitude.orientation import (
    axes_of_mrp,
    axes_of_quaternion,
    axes_of_rotation,
    mrp,
    quaternion,
    rotation,
)
from symcheck.numeric.attitude.turn import Flight, Turn, fly, plot_turn, turn

__all__ = [
    "Agility",
    "AgilityAfterFailures",
    "Flight",
    "MomentumOfAPeriod",
    "Turn",
    "agility",
    "agility_after_failures",
    "axes_of_mrp",
    "axes_of_quaternion",
    "axes_of_rotation",
    "fly",
    "momentum_in_time",
    "momentum_of_a_period",
    "mrp",
    "plot_turn",
    "quaternion",
    "rotation",
    "time_to_saturation",
    "to_42",
    "to_basilisk",
    "turn",
    "turn_time",
]
