"""Moments of inertia about turned axes, orientations that equalise them, and the damping of a body's rotation.

A matrix of axes has axis i in row i, as direction cosines to the principal axes. Instead of it every function takes the
`scipy.spatial.transform.Rotation` that turns the principal axes into the given ones. Leading axes of all arguments
broadcast.
"""

from symcheck.numeric.inertia.damping import (
    Devices,
    HarmonicMean,
    characteristic_coefficients,
    characteristic_roots,
    damping_matrix,
    gains_in_proportion,
    harmonic_mean_of_rates,
    optimal_devices,
    orthogonal_devices,
    stability_degree,
    stability_degree_in_pitch,
)
from symcheck.numeric.inertia.decay import (
    angular_acceleration,
    decay_rate,
    free_decay,
    kinetic_energy,
)
from symcheck.numeric.inertia.orientation import (
    AttitudeAngles,
    attitude_angles,
    direction_cosines,
    equal_moment_angles,
    equal_moment_axes,
)
from symcheck.numeric.inertia.plots import (
    plot_attitude_angles,
    plot_bound_of_product,
    plot_damping_over_pitch,
    plot_equal_moment_axes,
    plot_free_decay,
)
from symcheck.numeric.inertia.tensors import (
    BoundedProduct,
    BoundedSum,
    PrincipalInertia,
    axial_moments,
    bound_at_given_moment,
    inertia_tensor,
    principal_inertia,
    product_of_axial_moments,
    second_moments_of_mass,
    second_order_moments,
    sum_of_products,
    triangle_slack,
)

__all__ = [
    "AttitudeAngles",
    "BoundedProduct",
    "BoundedSum",
    "Devices",
    "HarmonicMean",
    "PrincipalInertia",
    "angular_acceleration",
    "attitude_angles",
    "axial_moments",
    "bound_at_given_moment",
    "characteristic_coefficients",
    "characteristic_roots",
    "damping_matrix",
    "decay_rate",
    "direction_cosines",
    "equal_moment_angles",
    "equal_moment_axes",
    "free_decay",
    "gains_in_proportion",
    "harmonic_mean_of_rates",
    "inertia_tensor",
    "kinetic_energy",
    "optimal_devices",
    "orthogonal_devices",
    "plot_attitude_angles",
    "plot_bound_of_product",
    "plot_damping_over_pitch",
    "plot_equal_moment_axes",
    "plot_free_decay",
    "principal_inertia",
    "product_of_axial_moments",
    "second_moments_of_mass",
    "second_order_moments",
    "stability_degree",
    "stability_degree_in_pitch",
    "sum_of_products",
    "triangle_slack",
]
