"""A spinning body with liquid: its frequencies, whether it is stable, and where that ends.

One mode of the liquid, or several on the last axis of E_n and lambda_n; leading axes broadcast.
"""

from symcheck.numeric.liquid.boundary import (
    BoundaryOfStability,
    StabilityMap,
    boundary_of_stability,
    stability_map,
    unstable_intervals,
)
from symcheck.numeric.liquid.plots import (
    plot_frequencies,
    plot_stability_map,
)
from symcheck.numeric.liquid.spectrum import (
    Stability,
    frequencies,
    growth_rate,
    is_stable,
    mode_inertia,
    stability,
)
from symcheck.numeric.liquid.tanks import Liquid, liquid_in_a_cylinder, liquid_in_an_ellipsoid, with_body

__all__ = [
    "BoundaryOfStability",
    "Liquid",
    "Stability",
    "StabilityMap",
    "boundary_of_stability",
    "frequencies",
    "growth_rate",
    "is_stable",
    "liquid_in_a_cylinder",
    "liquid_in_an_ellipsoid",
    "mode_inertia",
    "plot_frequencies",
    "plot_stability_map",
    "stability",
    "stability_map",
    "unstable_intervals",
    "with_body",
]
