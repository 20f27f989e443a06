"""What the pictures of the report show, as plain lists: envelopes, stationary densities, a stability map."""

from __future__ import annotations

from itertools import pairwise, product
from typing import Any

import numpy as np

from symcheck.generated import poloskov2004
from symcheck.numeric.domain import Array
from symcheck.numeric.liquid import boundary_of_stability, stability_map
from symcheck.numeric.wheels import envelope, four_wheels, listed_vertices, six_wheels, total_momentum
from symcheck.numeric.wheels.figures import FOUR, SIX

LISTS = {  # number of working wheels: what is shown, and the lists and the table of the paper that name its parts
    4: ("Four wheels", ("2.1V", "2.1E", "2.1F", "T1")),
    3: ("Four wheels, wheel 4 failed", ("2.2V", "2.2E", "2.2F", "T4")),
    6: ("Six wheels", ("3.1V", "3.1E", "3.1F", "T6")),
    5: ("Six wheels, wheel 6 failed", ("3.2V", "3.2E", "3.2F", "T9")),
}
AMPLITUDES = ((1.0, 0.75**0.5, 1.0), (1.0, 0.75**0.5, 0.75), (0.5, 0.75**0.5, 1.0))  # alpha, beta, gamma
FREQUENCIES = ((0.6, 1.0, 1.0, 1.5), (0.6, 1.0, 1.0, 0.8), (0.6, 0.5, 1.5, 1.5))  # k, g_13, g_23, d_33
POINTS, DIGITS = 161, 5  # of a curve: one every three pixels; decimals of its values


def envelopes() -> list[dict[str, Any]]:
    """The momentum envelopes of the paper's four sets of wheels at the angles of its tables, for h_max = 1 N m s.

    Each has vertices (in N m s) with the paper's names and the signs of the wheels' momenta, edges and faces as numbers
    of vertices, the axes, and the paper's lists. Source: (2.1), (3.1), tables 1, 4, 6, 9.

    >>> [len(each["vertices"]) for each in envelopes()]
    [14, 8, 32, 22]
    """
    return [_envelope(working, *shown) for working, shown in LISTS.items()]


def densities() -> list[dict[str, Any]]:
    """Stationary densities of amplitude and frequency, in s/rad against rad/s, for three sets of parameters each.

    Source: (3.4), (3.5).

    >>> [len(each["curves"]) for each in densities()]
    [3, 3]
    """
    amplitude = {
        "title": "Stationary density of the amplitude",
        "source": ["poloskov2004:3.4", "poloskov2004:B.2"],
        "across": "amplitude a, rad/s",
    }
    frequency = {
        "title": "Stationary density of the frequency",
        "source": ["poloskov2004:3.5"],
        "across": "frequency Ω, rad/s",
    }
    names = "α = {:.2f}, β = {:.2f}, γ = {:.2f}", "k = {:.1f}, g₁₃ = {:.1f}, g₂₃ = {:.1f}, d₃₃ = {:.1f}"
    return [
        amplitude | _curves(poloskov2004.density_of_amplitude, np.linspace(0, 3, POINTS), names[0], AMPLITUDES),
        frequency | _curves(poloskov2004.density_of_frequency, np.linspace(-3, 3, POINTS), names[1], FREQUENCIES),
    ]


def stability() -> dict[str, Any]:
    """The growth rate of a body with liquid of one mode, A = 1 and E_1 = 0.2 kg m^2, spin 1 rad/s.

    `growth` has rows of equal b_1, which rise, and columns of equal C - A; it is in 1/s, 0 where the body is stable.
    `boundary` goes around what is unstable, points (C - A, b_1).
    Source: (1.31), (1.35).

    >>> stability()["growth"][0][0]
    0.0
    """
    across, up = np.linspace(-0.999, 0.2, 240), np.linspace(-0.1, 1.1, 181)
    found, ratio = stability_map(1.0, [0.2], across, up), np.sin(np.linspace(0, np.pi / 2, 60)) ** 2
    ends = boundary_of_stability(1.0, 0.2, ratio)
    around = np.concatenate([ends.lower, ends.upper[::-1]]), np.concatenate([ratio, ratio[::-1]])
    return {
        "title": "Stability of a body with liquid",
        "source": ["esenkov2006:1.31", "esenkov2006:1.35a"],
        "across": "C − A, kg m²",
        "up": "natural frequency of the mode / spin, b₁",
        "x": [float(across[0]), float(across[-1])],
        "y": [float(up[0]), float(up[-1])],
        "growth": _plain(found.growth_rate),
        "boundary": _plain(np.transpose(around)),
    }


def _curves(density: Any, x: Array, names: str, sets: tuple[tuple[float, ...], ...]) -> dict[str, Any]:
    drawn = [{"label": names.format(*parameters), "y": _plain(density(x, *parameters))} for parameters in sets]
    return {"up": "density, s/rad", "x": _plain(x), "curves": drawn}


def _envelope(working: int, title: str, lists: tuple[str, ...]) -> dict[str, Any]:
    angles = FOUR if working < 5 else SIX
    axes = (four_wheels(*FOUR) if working < 5 else six_wheels(*SIX))[:working]
    found, names = envelope(axes), listed_vertices(working, *angles)
    momenta = np.array(list(product((1, -1), repeat=working)))
    corners, begins = found.faces
    return {
        "title": title,
        "paper": "ignatov2005",
        "lists": list(lists),
        "angles": [round(float(np.degrees(angle)), 1) for angle in angles],
        "axes": _plain(axes),
        "vertices": _plain(found.vertices),
        "names": [list(names)[_nearest(list(names.values()), place)] for place in found.vertices],
        "signs": [momenta[_nearest(total_momentum(axes, momenta), place)].tolist() for place in found.vertices],
        "edges": found.edges.tolist(),
        "faces": [corners[a:b].tolist() for a, b in pairwise(begins)],
    }


def _nearest(places: Any, place: Array) -> int:
    return int(np.linalg.norm(np.asarray(places) - place, axis=1).argmin())


def _plain(values: Array) -> Any:
    return np.round(values, DIGITS).tolist()
