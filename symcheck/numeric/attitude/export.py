"""Arrays of wheels as inputs of simulators: a Python function for Basilisk, lines of a spacecraft file for 42.

Facts of their conventions, as of 2026. Basilisk: `rwFactory.create` of `simIncludeRW` takes the axis in the body frame,
speeds in revolutions per minute, the torque in N m, and the inertia of the rotor in kg m^2; an MRP is that of the body
in the inertial frame. 42: the spacecraft file has a block for each wheel with its initial momentum, axis, largest
torque and momentum, inertia of the rotor, imbalances and where it is mounted; a quaternion has the scalar last.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from symcheck.numeric.attitude.orientation import mrp, quaternion
from symcheck.numeric.domain import Array, Orientation, momentum, positive, require
from symcheck.numeric.wheels.sets import Wheels, wheels_of

RPM = 30 / np.pi  # revolutions per minute in a radian per second


def to_basilisk(
    axes: ArrayLike,
    limits: ArrayLike,
    torque: ArrayLike,
    rotor_inertia: ArrayLike,
    momenta: ArrayLike = 0.0,
    orientation: Orientation | None = None,
) -> str:
    """A Python function that adds the wheels to a spacecraft of Basilisk.

    Parameters
    ----------
    axes
        Unit vectors e_i along the axes of the wheels, in the body frame; shape (n, 3).
    limits
        Largest momenta, N m s; a number or shape (n,), positive.
    torque
        Largest torques, N m; a number or shape (n,), positive.
    rotor_inertia
        Moments of inertia of the rotors about their axes, kg m^2; a number or shape (n,).
    momenta
        Initial momenta, N m s; a number or shape (n,).
    orientation
        Axes of the body in the inertial frame as rows, shape (3, 3), or a rotation. If it is given the initial MRP is
        set, too.

    Returns
    -------
    str
        The text of a module with the function `add_wheels(sc, tag)`.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Source: the docstring of `rwFactory.create` in `src/utilities/simIncludeRW.py` of AVSLab/basilisk.

    Examples
    --------
    >>> text = to_basilisk(np.eye(3), 0.02, 0.002, 3e-5)
    >>> print(text.splitlines()[9].strip())
    ("custom", [1.0, 0.0, 0.0], 0.0, 6366.197723675814, 0.002, 3e-05),
    """
    wheels, gain, rotors, stored = _checked(axes, limits, torque, rotor_inertia, momenta)
    speeds, fastest = stored / rotors * RPM, wheels.limits / rotors * RPM
    rows = [
        f'        ("custom", {axis.tolist()!r}, {speed!r}, {most!r}, {largest!r}, {rotor!r}),'
        for axis, speed, most, largest, rotor in zip(
            wheels.axes, *(each.tolist() for each in (speeds, fastest, gain, rotors)), strict=True
        )
    ]
    lines = [
        '"""Reaction wheels for Basilisk."""',
        "",
        "from Basilisk.simulation import reactionWheelStateEffector",
        "from Basilisk.utilities import simIncludeRW",
        "",
        "",
        "def add_wheels(sc, tag):",
        '    """Add the wheels to the spacecraft; return their factory and their state effector."""',
        "    wheels = [  # type, axis in the body frame, speed and largest speed, rpm, torque, N m, inertia, kg m^2",
        *rows,
        "    ]",
        "    factory, effector = simIncludeRW.rwFactory(), reactionWheelStateEffector.ReactionWheelStateEffector()",
        "    for kind, axis, speed, fastest, torque, inertia in wheels:",
        "        factory.create(kind, axis, Omega=speed, Omega_max=fastest, u_max=torque, Js=inertia)",
        "    factory.addToSpacecraft(tag, effector, sc)",
    ]
    if orientation is not None:
        sigma = [[part] for part in _one(mrp(orientation), 3).tolist()]
        lines.append(f"    sc.hub.sigma_BNInit = {sigma!r}  # MRP of the body in the inertial frame")
    return "\n".join([*lines, "    return factory, effector", ""])


def to_42(
    axes: ArrayLike,
    limits: ArrayLike,
    torque: ArrayLike,
    rotor_inertia: ArrayLike,
    momenta: ArrayLike = 0.0,
    orientation: Orientation | None = None,
) -> str:
    """The section of wheels of a spacecraft file of 42, and the line of its initial quaternion.

    Parameters
    ----------
    axes, limits, torque, rotor_inertia, momenta, orientation
        As for `to_basilisk`.

    Returns
    -------
    str
        Lines that replace those of the same headings in the spacecraft file. The imbalances are 0, the wheels are on
        body 0 and at flex node 0.

    Raises
    ------
    ValueError
        If an argument does not fit; the message names it.

    Notes
    -----
    Source: `Demo/SC_Cubesat3U.txt` of ericstoneking/42 for the lines and their order.

    Examples
    --------
    >>> print(to_42(np.eye(3)[:1], 0.02, 0.002, 3e-5))
    *************************** Wheel Parameters ***************************
    1                             ! Number of wheels
    =============================  Wheel 0  ================================
    0.0                           ! Initial Momentum, N-m-sec
    1.0 0.0 0.0                   ! Wheel Axis Components, [X, Y, Z]
    0.002 0.02                    ! Max Torque (N-m), Momentum (N-m-sec)
    3e-05                         ! Wheel Rotor Inertia, kg-m^2
    0.0                           ! Static Imbalance, g-cm
    0.0                           ! Dynamic Imbalance, g-cm^2
    0                             ! Body
    0                             ! Flex Node Index
    <BLANKLINE>
    """
    wheels, gain, rotors, stored = _checked(axes, limits, torque, rotor_inertia, momenta)
    lines = [" Wheel Parameters ".center(72, "*"), _line(f"{len(gain)}", "Number of wheels")]
    for number, axis in enumerate(wheels.axes):
        lines += [
            f"=============================  Wheel {number}  ================================"[:72],
            _line(_words(stored[number]), "Initial Momentum, N-m-sec"),
            _line(_words(*axis), "Wheel Axis Components, [X, Y, Z]"),
            _line(_words(gain[number], wheels.limits[number]), "Max Torque (N-m), Momentum (N-m-sec)"),
            _line(_words(rotors[number]), "Wheel Rotor Inertia, kg-m^2"),
            _line("0.0", "Static Imbalance, g-cm"),
            _line("0.0", "Dynamic Imbalance, g-cm^2"),
            _line("0", "Body"),
            _line("0", "Flex Node Index"),
        ]
    if orientation is not None:
        lines.append(_line(_words(*_one(quaternion(orientation, "scalar last"), 4)), "Quaternion"))
    return "\n".join([*lines, ""])


def _checked(
    axes: ArrayLike, limits: ArrayLike, torque: ArrayLike, rotor_inertia: ArrayLike, momenta: ArrayLike
) -> tuple[Wheels, Array, Array, Array]:
    wheels = wheels_of(axes, positive("limits", limits))
    require(wheels.limits.ndim == 1, "axes", wheels.axes.shape, "be one set of wheels, of the shape (n, 3)")
    named = {"torque": positive("torque", torque), "rotor_inertia": positive("rotor_inertia", rotor_inertia)}
    named["momenta"] = momentum("momenta", momenta)
    for name, value in named.items():
        require(value.shape in ((), wheels.limits.shape), name, value.shape, "be a number, or one for each wheel")
    gain, rotors, stored = (np.broadcast_to(value, wheels.limits.shape) for value in named.values())
    within = np.abs(stored) <= wheels.limits
    require(within, "momenta", stored, "be within the limits")
    return wheels, gain, rotors, stored


def _one(value: Array, length: int) -> Array:
    require(value.shape == (length,), "orientation", value.shape, "be one orientation")
    return value


def _words(*numbers: float) -> str:
    return " ".join(repr(float(number)) for number in numbers)


def _line(value: str, meaning: str) -> str:
    return f"{value:<29} ! {meaning}"
