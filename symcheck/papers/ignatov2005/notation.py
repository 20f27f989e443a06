"""The letters of Ignatov, Davydov, Sazonov 2005. Both configurations use the same letters for different things."""

from symcheck.reading import Letter, Notation

MOMENT = "kg m^2"
RATE = "rad/s"
MOMENTUM = "N m s"
WHEELS = (1, 2, 3, 4, 5, 6)  # of the larger set, section 3
VERTICES = tuple(range(1, 17))

notation = Notation(
    (
        Letter("i", kind="index", range=WHEELS),
        Letter(
            "a", meaning="angle between the axis of a wheel and OZ (the original prints alpha in places)", unit="rad"
        ),
        Letter("b", meaning="angle that turns the side edges in the plane OXY", unit="rad"),
        Letter("h", indices=1, range=WHEELS, meaning="angular momentum of wheel i, in units of h_max", unit=MOMENTUM),
        Letter("u", meaning="parameter of an edge, or the first parameter of a face", unit="1"),
        Letter("v", meaning="second parameter of a face", unit="1"),
        Letter("c", indices=1, meaning="normal of a supporting plane", unit="1"),
        Letter("l", indices=1, range=WHEELS, meaning="coefficients of a combination of axes", unit=MOMENTUM),
        Letter(r"\mathbf{c}", kind="vector", components="(c_1, c_2, c_3)"),
        Letter(
            r"\mathbf{e}",
            kind="vector",
            indices=1,
            range=WHEELS,
            meaning="unit vector of the axis of wheel i",
            unit="1",
        ),
        Letter(
            "d", indices=1, range=(1, 2, 3, 4, 5, 6, 7), meaning="distance of vertices from the centre", unit=MOMENTUM
        ),
        Letter(r"\pi", meaning="the number pi"),
    ),
    bracket=r"\mathbf{e}",
    decimals="rounded",
    argument="short",
    scales=((r"h_{\max}", MOMENTUM),),  # "without loss of generality let h_max = 1"
)


def configuration(axes: str, vertices: str, faces: str, wheels: int = 6, pairs: int = 16) -> Notation:
    """The letters of one configuration: the stems of its axes, vertices and middles of faces, and their numbers.

    V'_i is -V_i, and the middle of F'_i is -F_i.
    """
    each, of_pairs, of_faces = WHEELS[:wheels], VERTICES[:pairs], VERTICES[: wheels * (wheels - 1) // 2]
    return notation.extended(
        Letter("i", kind="index", range=each),
        Letter("h", indices=1, range=each, meaning="angular momentum of wheel i, in units of h_max", unit=MOMENTUM),
        Letter(
            r"\mathbf{e}", name=axes, kind="vector", indices=1, range=each, meaning="unit vector of wheel i", unit="1"
        ),
        Letter(r"\mathbf{V}", name=vertices, kind="vector", indices=1, range=of_pairs, meaning="vertex", unit=MOMENTUM),
        Letter(
            r"\mathbf{F}",
            name=faces,
            kind="vector",
            indices=1,
            range=of_faces,
            meaning="middle of a face",
            unit=MOMENTUM,
        ),
    )


# the total momentum, its largest value for one wheel, the distance of a face
TOTAL = (
    *(Letter(f"H_{x}", meaning="component of the total momentum", unit=MOMENTUM) for x in "xyz"),
    Letter(r"\mathbf{H}", kind="vector", components="(H_x, H_y, H_z)", meaning="total momentum", unit=MOMENTUM),
)
FACE = Letter("r", indices=1, range=VERTICES, meaning="distance of a face from the centre", unit=MOMENTUM)
LIMIT = Letter(r"h_{\max}", meaning="largest momentum of a wheel", unit=MOMENTUM)

# the spacecraft, in sections 2.3 and 3.3
SPACECRAFT = (
    LIMIT,
    *(Letter(f"J_{x}", meaning=f"principal central moment of inertia about O{x.upper()}", unit=MOMENT) for x in "xyz"),
    *(Letter(f"w_{x}", meaning="component of the angular rate of the spacecraft", unit=RATE) for x in "xyz"),
)
NUMBERS = (MOMENT, MOMENT)  # where moments of inertia are numbers, 1000 for 1000 kg m^2
UNITS = (
    Letter(r"\text{ кг}", name="kilogram", meaning="kg", unit="kg"),
    Letter(r"\text{ м}", name="metre", meaning="m", unit="m"),
)

four_wheels = configuration("e", "V", "F", 4, 7).extended(FACE, *TOTAL)  # section 2.1
three_of_four = configuration("e", "W", "K", 3, 4).extended(FACE, *TOTAL)  # section 2.2
four_and_three = four_wheels.extended(  # both at once: the vertices of section 2.2 are written W_i
    Letter(
        r"\mathbf{W}", kind="vector", indices=1, range=(1, 2, 3, 4), meaning="vertex, one wheel failed", unit=MOMENTUM
    )
)
four_wheels_in_spacecraft = four_wheels.extended(*SPACECRAFT)  # section 2.3
four_wheels_in_numbers = four_wheels_in_spacecraft.supposing(NUMBERS)
four_wheels_with_units = four_wheels_in_spacecraft.extended(*UNITS)

# section 1
requirements = notation.extended(
    Letter("A_T", meaning="set of the momenta required", unit=MOMENTUM),
    Letter("A_C", meaning="set of the momenta that the actuators can have", unit=MOMENTUM),
    *(Letter(f"H_{{T{x}}}", meaning="component of the momentum required", unit=MOMENTUM) for x in "XYZ"),
    *(Letter(f"J_{x}", meaning="principal central moment of inertia", unit=MOMENT) for x in "XYZ"),
    *(Letter(f"w_{x}", meaning="largest rate required", unit=RATE) for x in "XYZ"),
)

# section 3: axes are printed in a thin face too
_THIN = Letter(
    "e", kind="vector", indices=1, range=WHEELS, components=r"\mathbf{e}_i", meaning="unit vector of wheel i"
)
six_wheels = configuration("g", "X", "M").extended(FACE, *TOTAL, _THIN)  # section 3.1
five_of_six = configuration("g", "Y", "N", 5, 11).extended(FACE, *TOTAL)  # section 3.2
six_and_five = six_wheels.extended(  # both at once: the vertices of section 3.2 are written W_i
    Letter(
        r"\mathbf{W}", name="Y", kind="vector", indices=1, range=VERTICES[:11], meaning="vertex, one wheel failed",
        unit=MOMENTUM,
    )
)  # fmt: skip
six_wheels_in_spacecraft = six_wheels.extended(*SPACECRAFT)  # section 3.3
six_wheels_in_numbers = six_wheels_in_spacecraft.supposing(NUMBERS)
six_wheels_with_units = six_wheels_in_spacecraft.extended(*UNITS)
four_wheels_and_ellipsoid = four_wheels.extended(  # the closing comparison of section 3.2
    *(Letter(f"A_{x}", meaning=f"semi-axis of an ellipsoid along O{x.upper()}", unit=MOMENTUM) for x in "xyz"),
    Letter(
        r"\lambda", meaning="size of the largest such ellipsoid in P, over the size of the least one around P", unit="1"
    ),
)

# beyond the paper
_SHAPE = (
    *(
        Letter(x, meaning=f"component of the axes of the wheels along O{axis}", unit="1")
        for x, axis in zip("pqr", "XYZ", strict=True)
    ),
    *(Letter(f"A_{x}", meaning=f"semi-axis of an ellipsoid along O{x.upper()}", unit=MOMENTUM) for x in "xyz"),
    Letter("R", meaning="radius of a ball inside the envelope", unit=MOMENTUM),
    Letter("S", meaning="square root of J_x^2 + J_z^2", unit=MOMENT),
    Letter("n", indices=2, range=VERTICES[:6], meaning="normals of faces", unit="1"),
    Letter("n", indices=1, meaning="a normal", unit="1"),
    Letter("s", indices=1, range=VERTICES[:6], meaning="(n, H) on these faces", unit=MOMENTUM),
    Letter("t", meaning="(n, H) on a plane that touches", unit=MOMENTUM),
    *(Letter(f"u_{x}", meaning="component of a unit vector", unit="1") for x in "xyz"),
    Letter("w", meaning="largest rate about every axis", unit=RATE),
)
four_wheels_beyond = four_wheels_in_spacecraft.extended(*_SHAPE)
six_wheels_beyond = six_wheels_in_spacecraft.extended(*_SHAPE)
six_wheels_beyond_in_numbers = six_wheels_beyond.supposing(NUMBERS)
