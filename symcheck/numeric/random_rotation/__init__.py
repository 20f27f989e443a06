"""A rigid body under dissipative and random torques: stationary laws in closed form, and ensembles of sample paths.

The body is symmetric, and turns under a small dissipative torque and small noises, (1.1). Averaged over the fast turn
of its angular velocity, the amplitude a and the frequency Omega have independent stationary laws in closed form;
ensembles of the full system are what these can be held against.
"""

from symcheck.numeric.random_rotation.amplitude import (
    density_of_amplitude,
    distribution_of_amplitude,
    logarithm_of_constant_of_amplitude,
    mean_square_of_amplitude,
    mode_of_amplitude,
    moment_of_amplitude,
    quantile_of_amplitude,
)
from symcheck.numeric.random_rotation.ensemble import Ensemble, simulate
from symcheck.numeric.random_rotation.frequency import (
    density_of_frequency,
    distribution_of_frequency,
    logarithm_of_constant_of_frequency,
    mean_square_of_frequency,
    mode_of_frequency,
    moment_of_frequency,
    quantile_of_frequency,
)
from symcheck.numeric.random_rotation.plots import plot_amplitude, plot_frequency, plot_paths
from symcheck.numeric.random_rotation.torques import RandomTorques
from symcheck.numeric.random_rotation.variables import (
    Rotation,
    amplitude_phase_frequency,
    angular_velocity,
    stationary_sample,
)

__all__ = [
    "Ensemble",
    "RandomTorques",
    "Rotation",
    "amplitude_phase_frequency",
    "angular_velocity",
    "density_of_amplitude",
    "density_of_frequency",
    "distribution_of_amplitude",
    "distribution_of_frequency",
    "logarithm_of_constant_of_amplitude",
    "logarithm_of_constant_of_frequency",
    "mean_square_of_amplitude",
    "mean_square_of_frequency",
    "mode_of_amplitude",
    "mode_of_frequency",
    "moment_of_amplitude",
    "moment_of_frequency",
    "plot_amplitude",
    "plot_frequency",
    "plot_paths",
    "quantile_of_amplitude",
    "quantile_of_frequency",
    "simulate",
    "stationary_sample",
]
