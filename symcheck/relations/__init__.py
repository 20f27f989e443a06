"""Relations beyond the papers, for wheels and tanks: `relations.md` is read and decided, and kernels are made of it."""

from symcheck.document.paper import Document, letter

__all__ = ["paper"]

MOMENT, MOMENTUM, RATE, TORQUE = "kg m^2", "N m s", "rad/s", "N m"

source = Document(
    __file__,
    "relations.md",
    letters=(
        letter(r"\theta", meaning="angle of the turn", unit="rad"),
        letter("w", meaning="largest angular rate on the way", unit=RATE),
        letter(r"\alpha", meaning="angular acceleration", unit="rad/s^2"),
        letter("s", meaning="time of the turn", unit="s"),
        letter("t", meaning="time", unit="s"),
        letter("G", meaning="momentum at the time 0", unit=MOMENTUM),
        letter("H", meaning="momentum", unit=MOMENTUM),
        letter("D", meaning="momentum with dumping", unit=MOMENTUM),
        letter("T", meaning="constant torque", unit=TORQUE),
        letter("P", meaning="amplitude of the torque that goes with the cosine", unit=TORQUE),
        letter("Q", meaning="amplitude of the torque that goes with the sine", unit=TORQUE),
        letter(r"\omega", meaning="angular frequency of the periodic torque", unit=RATE),
        letter(
            "k", meaning="rate of dumping, 1/s; of the cylinder, the wave number along the spin, 1/m", unit="1/s, 1/m"
        ),
        letter("q", meaning="part of the momentum that is dumped until t", unit="1"),
        letter("e"),
        letter("m", "scalar", meaning="mass of the liquid", unit="kg"),
        letter("a", meaning="semi-axis or radius across the spin", unit="m"),
        letter("c", meaning="semi-axis or half height along the spin", unit="m"),
        letter(r"\Omega", meaning="spin", unit=RATE),
        letter(r"\lambda", meaning="natural frequency of the mode", unit=RATE),
        letter(r"\tau", meaning="natural frequency over spin", unit="1"),
        letter("E", "scalar", meaning="moment of inertia that the mode carries", unit=MOMENT),
        letter("E_1", "scalar", meaning="moment of inertia that a mode of a cylinder carries", unit=MOMENT),
        *(letter(f"v_{i}") for i in (1, 2, 3)),
        *(letter(x) for x in "XYxyz"),
    ),
)

area = source.premise("(1)")
moving = source.premise("line 13")
speeding = source.premise("line 13 #2")
slew_time = source.claim("(2)", follows=[area, moving, speeding])
turning = source.premise("line 17")
shortest = source.claim("(3)", follows=[moving, speeding, turning])

periodic = source.premise("line 23")
undumped = source.definition("(4)")
slope = source.claim("(5)", follows=[periodic])
accumulated = source.claim("(6)", follows=[undumped, periodic])
dumping = source.premise("line 36")
integral = source.definition("(7)")
decaying = source.claim("(8)", given=[])
part = source.definition("(9)")
dumped = source.claim("(10)", follows=[periodic, dumping, integral, part])

null_motion = source.claim("(11)", given=[])

wide = source.premise("line 60")
long = source.premise("line 60 #2")
velocity_1 = source.definition("(12)")
velocity_2 = source.definition("(13)")
velocity_3 = source.definition("(14)")
at_the_wall = source.claim("(15)", follows=[wide, long, velocity_1, velocity_2, velocity_3])
curl_1 = source.claim("(16)", follows=[wide, long, velocity_2, velocity_3])
curl_2 = source.claim("(17)", follows=[wide, long, velocity_1, velocity_3])
by_mean_squares = source.definition("(18)")
momentum_of_the_liquid = source.claim("(19)", follows=[by_mean_squares, wide, long])
vorticity = source.premise("(20)")
liquid_moves = source.premise("line 90")
alone = source.premise("(21)")
natural_frequency = source.claim("(22)", follows=[alone, liquid_moves, wide, long])
response = source.definition("(23)")
following = source.claim("(24)", follows=[vorticity, natural_frequency, response, liquid_moves, wide, long])
carried = source.premise("(25)")
body_moves = source.premise("line 108")
no_constant = source.premise("line 108 #2")
mode_inertia = source.claim("(26)", follows=[response, carried, body_moves, no_constant, wide, long])
transverse_moment = source.definition("(27)")
axial_moment = source.definition("(28)")
ratio = source.definition("(29)")
between_two_shapes = source.claim("(30)", follows=[wide, long, mode_inertia, transverse_moment, axial_moment, ratio])

radius = source.premise("line 129")
height = source.premise("line 129 #2")
not_steady = source.premise("line 131")
inertial = source.premise("line 131 #2")
wave = source.premise("line 132")
dispersion = source.premise("(31)")
wall = source.premise("(32)")
squared_pressure = source.definition("(33)")
squared_gradient = source.definition("(34)")
norm = source.definition("(35)")
moment = source.definition("(36)")
pressure = source.premise("line 151")
odd = source.premise("line 151 #2")
liquid = source.premise("line 151 #3")
of_norm_and_moment = source.definition("(37)")
mode_inertia_in_a_cylinder = source.claim(
    "(38)",
    follows=[
        *(radius, height, not_steady, inertial, wave, dispersion, wall, squared_pressure, squared_gradient),
        *(norm, moment, pressure, odd, liquid, of_norm_and_moment),
    ],
)

cosine_of_the_slope = source.definition("(39)")
sine_of_the_slope = source.definition("(40)")
decay_of_the_slope = source.definition("(41)")
slope_with_dumping = source.claim(
    "(42)", follows=[periodic, dumping, cosine_of_the_slope, sine_of_the_slope, decay_of_the_slope]
)

time_of_a_turn = source.kernel(
    slew_time,
    "The time of a turn from rest to rest about one axis.",
    domain={r"\theta": ("0", ""), "w": ("0", ""), r"\alpha": ("0", "")},
)
momentum_of_a_disturbance = source.kernel(
    accumulated,
    "The momentum that a constant and a periodic torque leave in the wheels.",
    domain={r"\omega": ("0", "")},
    condition="Terms may cancel: counted in units of the last place of the greatest.",
)
momentum_with_dumping = source.kernel(
    dumped,
    "The momentum that a constant and a periodic torque leave in wheels that are dumped in proportion to it.",
    domain={r"\omega": ("0", ""), "k": ("0", "")},
    condition="Terms may cancel: counted in units of the last place of the greatest.",
)
natural_frequency_of_an_ellipsoid = source.kernel(
    natural_frequency,
    "The natural frequency of the mode of a liquid that fills an ellipsoid of revolution.",
    domain={"a": ("0", ""), "c": ("0", ""), r"\Omega": ("0", "")},
)
mode_inertia_of_an_ellipsoid = source.kernel(
    mode_inertia,
    "The moment of inertia that the mode of a liquid carries which fills an ellipsoid of revolution.",
    domain={"a": ("0", ""), "c": ("0", ""), "m": ("0", "")},
)
mode_inertia_of_a_cylinder = source.kernel(
    mode_inertia_in_a_cylinder,
    "The moment of inertia that a mode of a liquid carries which fills a cylinder.",
    domain={"a": ("0", ""), "c": ("0", ""), "k": ("0", ""), "m": ("0", ""), r"\tau": ("-2", "2")},
    ulp=12,
    condition="A product of seven factors, two of them sums.",
)

paper = source.paper(__name__, title="Relations for the design of wheels and tanks")
