"""The letters of the pendulum: what each means and its unit."""

from symcheck.reading import Letter, Notation

notation = Notation(
    (
        Letter("m", meaning="mass", unit="kg"),
        Letter("a", meaning="distance of the axis from the centre of mass", unit="m"),
        Letter("b", meaning="distance of the centre of oscillation from the centre of mass", unit="m"),
        Letter("l", meaning="length of the simple pendulum", unit="m"),
        Letter("r", meaning="radius of gyration", unit="m"),
        Letter("I", meaning="moment of inertia about the axis of suspension", unit="kg m^2"),
        Letter("I_c", meaning="moment of inertia about the centre of mass", unit="kg m^2"),
        Letter("F", meaning="horizontal force", unit="N"),
        Letter("g", meaning="acceleration of gravity", unit="m/s^2"),
    )
)
