"""Numbers in, numbers out: arrays go through the formulas of the papers. Knows no paper and no algebra.

`attitude`, `inertia`, `random_rotation`, `liquid` and `wheels` are the subjects, `figures` their pictures; `chunked`
and `sweep` go beyond memory and one machine; `domain` and `drawing` are what arguments and pictures have in common.

Functions that are formulas throughout take arrays of any library of the array API standard too, such as JAX and
PyTorch, with array-api-compat: these that follow, and all kernels. The library computes, and can trace, map and
differentiate them. What values must be is looked at wherever there are any, which is not so while a function is traced;
results are not looked at. In `inertia`: direction_cosines, axial_moments, second_order_moments,
product_of_axial_moments, sum_of_products, gains_in_proportion, damping_matrix, characteristic_coefficients,
stability_degree_in_pitch. In `liquid`: mode_inertia, boundary_of_stability. In `random_rotation`: density, moment and
mean square of amplitude and frequency, and distribution, quantile and mode of the amplitude.
"""

__all__ = [
    "attitude",
    "chunked",
    "domain",
    "drawing",
    "figures",
    "inertia",
    "liquid",
    "random_rotation",
    "sweep",
    "wheels",
]
