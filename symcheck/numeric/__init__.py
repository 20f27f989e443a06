"""Numbers in, numbers out: arrays go through the formulas of the papers. Knows no paper and no algebra.

`attitude`, `inertia`, `random_rotation`, `liquid` and `wheels` are the subjects, `figures` their pictures; `chunked`
and `sweep` go beyond memory and one machine; `domain` and `drawing` are what arguments and pictures have in common.
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
