"""The length of the pendulum from the moments of inertia, as expressions for kernels."""

from symcheck.core.lazy import lazy

sp = lazy("sympy")


def length() -> dict[str, object]:
    """Equation (2) with (1): the length by mass, distance and moment of inertia."""
    mass, distance, moment = sp.symbols("m a I_c", positive=True)
    return {"l": (moment + mass * distance**2) / (mass * distance)}
