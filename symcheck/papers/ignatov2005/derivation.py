"""Ignatov 2005 from first principles: the axes of the wheels along the side edges of two pyramids."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from symcheck.core.lazy import lazy
from symcheck.mechanics.zonotope import Envelope, Signs, chirotope, combinatorics
from symcheck.reading.notation import variable

if TYPE_CHECKING:
    from sympy import Expr, Matrix

sp = lazy("sympy")


# --- section 2: the four-sided pyramid; its axes are those the paper defines, by their letters


def _letters(stem: str, number: int) -> Matrix:
    """The vector e_i or V_i in its variables e_i1, e_i2, e_i3."""
    return sp.Matrix([sp.Symbol(variable(stem, (number, k)), real=True) for k in (1, 2, 3)])


def momentum_of_wheels(number: int, stem: str = "e") -> dict[str, Expr]:
    """H_x, H_y, H_z: the sum of h_i e_i over the wheels 1, 2, ... that work."""
    total = sum((sp.Symbol(f"h_{i}", real=True) * _letters(stem, i) for i in range(1, number + 1)), sp.zeros(3, 1))
    return dict(zip(("H_x", "H_y", "H_z"), total, strict=True))


def vertex_distances(vertices: str) -> dict[str, Expr]:
    """d_1, d_2, ...: the distances of the vertices of these names, "V_1, V_6", from the centre."""
    found = {}
    for n, vertex in enumerate(vertices.split(", "), 1):
        stem, number = vertex.split("_")
        place = _letters(stem, int(number))
        found[f"d_{n}"] = sp.sqrt(place.dot(place))
    return found


def distances_of_faces(*faces: str) -> dict[str, Expr]:
    """r_1, r_2, ...: the distances from the centre to the planes of the faces [u, 1, v, -1]."""
    return _distances(*_four_in_letters(), faces)


def _four_in_letters() -> tuple[list[Matrix], dict[Expr, Expr]]:
    """The axes with positive letters for their components but for signs, and what these stand for.

    All three are positive for 0 < a, b < 90 degrees.
    """
    letters = sp.symbols("p q r", positive=True)
    axes = [sp.Matrix([sign * letter for sign, letter in zip(signs, letters, strict=True)]) for signs in FOUR]
    a, b = sp.symbols("a b", real=True)
    return axes, dict(zip(letters, (sp.sin(a) * sp.sin(b), sp.sin(a) * sp.cos(b), sp.cos(a)), strict=True))


def _distances(axes: Sequence[Matrix], meaning: dict[Expr, Expr], faces: tuple[str, ...]) -> dict[str, Expr]:
    """|(n, H)| / |n| for each face: n across both free wheels, H any point of the face, here its middle u = v = 0."""
    found = {}
    for n, face in enumerate(faces, 1):
        signed = list(zip(face.split(", "), axes, strict=False))
        one, other = (axis for sign, axis in signed if sign in "uv")
        middle = sum((int(sign) * axis for sign, axis in signed if sign not in "uv"), sp.zeros(3, 1))
        normal = one.cross(other)
        distance = sp.Abs(sp.expand(normal.dot(middle))) / sp.sqrt(sp.factor(normal.dot(normal)))
        found[f"r_{n}"] = distance.subs(meaning)
    return found


def angular_momentum() -> tuple[Expr, ...]:
    """The components of the total angular momentum: of the body with its principal moments, and of the wheels."""
    tensor = sp.diag(*(sp.Symbol(f"J_{x}", real=True) for x in "xyz"))
    rate, wheels = (sp.Matrix([sp.Symbol(f"{stem}_{x}", real=True) for x in "xyz"]) for stem in "wH")
    return tuple(tensor * rate + wheels)


# --- section 3: the six-sided pyramid


def six_axes() -> dict[str, Expr]:
    """g_11 to g_63: along the side edges of a regular pyramid, 60 degrees apart; wheels 4 to 6 point down their edges.

    The first edge lies in the plane OYZ; the edge k is opposite to the edge k + 3.
    """
    edges = [_edge(sp.Rational(k, 3) - sp.Rational(1, 2)) for k in range(6)]
    axes = edges[:3] + [-edge for edge in edges[3:]]
    return {f"g_{i}{k}": axis[k - 1] for i, axis in enumerate(axes, 1) for k in (1, 2, 3)}


def _edge(azimuth: Expr) -> Matrix:
    """The unit vector at the angle a to OZ, its azimuth counted from OX in half turns."""
    a = sp.Symbol("a", real=True)
    return sp.Matrix([sp.sin(a) * sp.cos(azimuth * sp.pi), sp.sin(a) * sp.sin(azimuth * sp.pi), sp.cos(a)])


def _six() -> tuple[Matrix, ...]:
    found = six_axes()
    return tuple(sp.Matrix([found[f"g_{i}{k}"] for k in (1, 2, 3)]) for i in range(1, 7))


def momentum_of_six(working: int) -> dict[str, Expr]:
    """The axes with H_x, H_y, H_z: the sum of h_i e_i over the wheels 1, 2, ... of the six that work."""
    return {**six_axes(), **momentum_of_wheels(working, "g")}


def _six_in_letters() -> tuple[list[Matrix], dict[Expr, Expr]]:
    """The axes with positive letters for sin a and cos a, and what these stand for: 0 < a < 90 degrees."""
    a = sp.Symbol("a", real=True)
    sine, cosine = sp.symbols("s c", positive=True)
    axes = [axis.subs({sp.sin(a): sine, sp.cos(a): cosine}) for axis in _six()]
    return axes, {sine: sp.sin(a), cosine: sp.cos(a)}


def distances_of_faces_of_six(*faces: str) -> dict[str, Expr]:
    """The same distances for faces [u, 1, v, -1, ...] of the first five or all six wheels, for 0 < a < 90 degrees."""
    return _distances(*_six_in_letters(), faces)


def foot_of_perpendicular(face: str) -> dict[str, Expr]:
    """The axes with u and v at the point of the plane of a face [u, 1, v, -1, ...] that is nearest to the centre."""
    axes, meaning = _six_in_letters()
    places, free = face.split(", "), sp.symbols("u v")
    point = sum((sp.sympify(h) * axis for h, axis in zip(places, axes, strict=False)), sp.zeros(3, 1))
    found = sp.solve([point.dot(axes[places.index(str(letter))]) for letter in free], free)
    return {**six_axes(), **{str(letter): sp.factor(value).subs(meaning) for letter, value in found.items()}}


# --- beyond the paper: both arrays with whole numbers for the components of the axes, times positive units

FOUR = ((1, -1, -1), (1, 1, -1), (1, -1, 1), (1, 1, 1))  # units sin a sin b, sin a cos b, cos a
SIX = ((0, -2, 1), (1, -1, 1), (1, 1, 1), (0, -2, -1), (1, -1, -1), (1, 1, -1))  # sqrt 3/2 sin a, 1/2 sin a, cos a


def _in_letters(stem: str, whole: Sequence[Expr]) -> Envelope:
    """The envelope of the axes in their letters e_11, ..., with the signs of the whole numbers."""
    x, y, z = ([sp.Symbol(f"{stem}_{i}{k}", real=True) for i in range(1, len(whole) + 1)] for k in (1, 2, 3))
    chi = chirotope(whole)
    return Envelope(tuple(zip(x, y, z, strict=True)), chi, combinatorics(chi))


def _normals(polyhedron: Envelope, *faces: Signs) -> dict[str, Expr]:
    """n_11, n_12, n_13 and s_1 for the first of these faces, and so on: its normal n, and (n, H) on it."""
    values: dict[str, Expr] = {}
    for number, face in enumerate(faces, 1):
        values |= {f"n_{number}{k}": component for k, component in enumerate(polyhedron.normal(face), 1)}
        values[f"s_{number}"] = polyhedron.support(face)
    return values


def faces_of_four() -> dict[str, Expr]:
    """The faces F_3, F_5 and F_4 of the four-sided pyramid: one of each kind."""
    return _normals(_in_letters("e", FOUR), (1, 0, 1, 0), (0, 0, 1, 1), (1, 0, 0, -1))


def faces_of_six() -> dict[str, Expr]:
    """The faces F_6, F_1, F_7, F_8, F_13, F_15 of the six-sided pyramid; reflections in the coordinate planes give all."""
    neighbours = (1, 1, 1, -1, 0, 0), (0, 1, 1, -1, -1, 0)
    two_apart = (0, 1, 1, -1, 0, 1), (-1, 0, 1, -1, -1, 0)
    opposite = (0, 1, 1, 0, 1, 1), (-1, -1, 0, -1, -1, 0)
    return {**six_axes(), **_normals(_in_letters("g", SIX), *neighbours, *two_apart, *opposite)}


# --- for kernels: both pyramids with their first wheels working, in the angles

Momenta = Mapping[int, Sequence[int]]  # of the wheels that work, by the number of a vertex


def _in_letters_of(pyramid: int) -> tuple[list[Matrix], dict[Expr, Expr]]:
    """The axes of the pyramid with 4 or 6 wheels in positive letters, and what these stand for."""
    return _four_in_letters() if pyramid == 4 else _six_in_letters()


def _components(pyramid: int, vectors: Mapping[str, Matrix]) -> dict[str, Expr]:
    """V_1x, V_1y, ...: the components of vectors in letters, without those that are zero for all angles."""
    meaning = _in_letters_of(pyramid)[1]
    named = {f"{name}{x}": value for name, vector in vectors.items() for x, value in zip("xyz", vector, strict=True)}
    return {name: sp.factor_terms(sp.together(value)).subs(meaning) for name, value in named.items() if value != 0}


def axes(pyramid: int) -> dict[str, Expr]:
    """e_1x, e_1y, ...: the axes of a pyramid."""
    return _components(pyramid, {f"e_{i}": axis for i, axis in enumerate(_in_letters_of(pyramid)[0], 1)})


def _total(pyramid: int, momenta: Sequence[Expr]) -> Matrix:
    """The sum of h_i e_i in letters, over the wheels 1, 2, ... that work."""
    axes, _ = _in_letters_of(pyramid)
    return sum((h * axis for h, axis in zip(momenta, axes, strict=False)), sp.zeros(3, 1))


def momentum(pyramid: int, working: int) -> dict[str, Expr]:
    """H_x, H_y, H_z: the sum of h_i e_i over the wheels 1, 2, ... that work."""
    momenta = [sp.Symbol(f"h_{i}", real=True) for i in range(1, working + 1)]
    return _components(pyramid, {"H_": _total(pyramid, momenta)})


def rates(pyramid: int, working: int) -> dict[str, Expr]:
    """w_x, w_y, w_z: the rates of the body with which its momentum and that of the wheels are zero together."""
    unknown = sp.symbols("w_x w_y w_z", real=True)
    (found,) = sp.solve(angular_momentum(), unknown, dict=True)
    wheels = {sp.Symbol(name, real=True): value for name, value in momentum(pyramid, working).items()}
    return {rate.name: found[rate].subs(wheels) for rate in unknown}


def largest_rates(pyramid: int) -> dict[str, Expr]:
    """w_x, w_y, w_z: the largest rates about each axis, in absolute value: every wheel does for it what it can."""
    vectors, meaning = _in_letters_of(pyramid)
    largest = {x: sum(abs(axis[k]) for axis in vectors) for k, x in enumerate("xyz")}
    return {f"w_{x}": (sp.S(value) / sp.Symbol(f"J_{x}", real=True)).subs(meaning) for x, value in largest.items()}


def vertices(pyramid: int, vertices: Momenta) -> dict[str, Expr]:
    """V_1x, V_1y, ...: the vertices at which the wheels have these momenta."""
    return _components(pyramid, {f"V_{i}": _total(pyramid, momenta) for i, momenta in vertices.items()})


def distances_of_vertices(pyramid: int, vertices: Momenta) -> dict[str, Expr]:
    """d_1, d_2, ...: the distances from the centre of vertices, by their numbers among the distances."""
    meaning = _in_letters_of(pyramid)[1]
    points = {f"d_{k}": _total(pyramid, momenta) for k, momenta in vertices.items()}
    return {name: sp.sqrt(point.dot(point)).subs(meaning) for name, point in points.items()}


def volume(pyramid: int, working: int) -> dict[str, Expr]:
    """The volume of the envelope of the wheels 1, 2, ... that work."""
    vectors, meaning = _in_letters_of(pyramid)
    chi = chirotope((FOUR if pyramid == 4 else SIX)[:working])
    found = Envelope(tuple(map(tuple, vectors[:working])), chi, combinatorics(chi)).volume()
    return {"volume": sp.expand(found).subs(meaning)}


def _angles(x: Expr, y: Expr, z: Expr) -> dict[str, Expr]:
    """The angles of the four-sided pyramid whose axes have components in these ratios."""
    return {"a": sp.atan(sp.sqrt(x**2 + y**2) / z), "b": sp.atan(x / y)}


def _moments() -> tuple[Expr, Expr, Expr]:
    x, y, z = sp.symbols("J_x J_y J_z", real=True)
    return x, y, z


def angles_for_equal_rates() -> dict[str, Expr]:
    """a, b of four wheels whose components are as the moments are, so that the largest rates 4p/J_x, ... are equal, w.

    Then all faces allow one rate about every axis, w_any: w_any^2 (J_x^2/p^2 + J_y^2/q^2) = 16, and so on.
    """
    moments = _moments()
    length = sp.sqrt(sum(moment**2 for moment in moments))
    return _angles(*moments) | {"w": 4 / length, "w_any": sp.sqrt(8) / length}


def angles_for_rate_about_any_axis() -> dict[str, Expr]:
    """a, b, w: of four wheels, the best ones for a body with J_y >= S = sqrt(J_x^2 + J_z^2).

    The faces across OXY and OYZ bind: w^2 (J_x^2/p^2 + J_y^2/q^2) = 16 = w^2 (J_z^2/r^2 + J_y^2/q^2). So p/r = J_x/J_z, and
    q^2 = 1 - p^2 - r^2 that makes J_y^2/q^2 + S^2/(1 - q^2) least is J_y/(J_y + S).
    """
    x, y, z = _moments()
    root = sp.sqrt(x**2 + z**2)
    return _angles(x, sp.sqrt(root * y), z) | {"w": 4 / (y + root)}


def angle_of_six_for_equal_rates() -> dict[str, Expr]:
    """a, w_x, w_y: of six wheels, with equal largest rates w_y = w_z; and these rates."""
    a, tangent = sp.Symbol("a", real=True), sp.Symbol("t", positive=True)
    rates = largest_rates(6)
    equation = (rates["w_y"] - rates["w_z"]).subs(sp.sin(a), tangent * sp.cos(a)) / sp.cos(a)
    (found,) = sp.solve(sp.expand(equation), tangent)
    above, below = sp.fraction(found)
    length = sp.sqrt(above**2 + below**2)
    sides = {sp.sin(a): above / length, sp.cos(a): below / length}
    return {"a": sp.atan(found), **{name: rates[name].subs(sides) for name in ("w_x", "w_y")}}


def angle_of_six_for_rate_about_any_axis() -> dict[str, Expr]:
    """a, w: of six wheels, where the face F_8 binds: 16/w^2 = J_y^2/sin^2 a + J_z^2/(4 cos^2 a) is least."""
    _, y, z = _moments()
    return {"a": sp.atan(sp.sqrt(2 * y / z)), "w": 8 / (2 * y + z)}
