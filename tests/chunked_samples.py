"""Arguments for every function that is declared with a signature, by the names of its parameters."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from typing import Any

import numpy as np

import symcheck.numeric
from symcheck.numeric import inertia, wheels
from symcheck.numeric.chunked.arrays import Signature

LEAD = (30, 20)  # more points than a kernel counts as few
NUMBERS = {  # least and greatest value, and last axes
    "A": (1, 2),
    "acceleration": (0.1, 1),
    "angle": (0.1, 3),
    "E_1": (0.01, 0.1),
    "E_n": (0.01, 0.1, 2),
    "alpha": (0.1, 0.2),
    "bias": (-0.1, 0.1, 4),
    "constant": (-0.1, 0.1, 3),
    "cosine": (-0.3, 0.3, 3),
    "d_33": (1, 2),
    "demand": (0.1, 1, 3),
    "direction": (0.1, 1, 3),
    "energy": (1, 2, 7),
    "g_13": (0.1, 0.2),
    "gains": (0, 1, 3),
    "frequency": (1, 2),
    "gamma": (1, 2),
    "initial": (-0.1, 0.1, 3),
    "lambda_n": (-1, 1, 2),
    "limits": (1, 2, 4),
    "moment": (2, 3),
    "momenta": (-1, 1, 4),
    "moments": (2, 3, 3),
    "mrp": (-1, 1, 3),
    "nappe": (1, 1),
    "point": (0.1, 1, 3),
    "quarter_turns": (2, 2),
    "quaternion": (-1, 1, 4),
    "rate": (0.1, 1, 3),
    "semi_axes": (0.1, 1, 3),
    "sine": (-0.3, 0.3, 3),
    "torque": (0.1, 1, 4),
    "x": (0.1, 1, 3),
}


def functions() -> Iterator[tuple[str, Any]]:
    """All functions that are declared elementwise, by part and name."""
    for part in pkgutil.iter_modules(symcheck.numeric.__path__):
        names = vars(importlib.import_module(f"symcheck.numeric.{part.name}")) if part.ispkg else {}
        for name, value in names.items():
            if isinstance(getattr(value, "signature", None), Signature) and inspect.unwrap(value) is not value:
                yield f"{part.name}.{name}", value


def arguments(function: Any) -> list[Any]:
    """Its positional arguments, contiguous as chunks are."""
    rng = np.random.default_rng(1)
    names = [p.name for p in inspect.signature(function).parameters.values() if p.kind is not p.KEYWORD_ONLY]
    return [_contiguous(_sample(rng, function, name)) for name in names]


def is_long(array: Any) -> bool:
    """Whether it has the leading axes."""
    return np.shape(array)[:2] == LEAD


def _sample(rng: np.random.Generator, function: Any, name: str) -> Any:
    one_set = function.__name__.startswith("allocate")
    if name == "axes":
        wheeled = "(n,axis)" in _inputs(function)
        turns = _rotations(rng)
        return (
            wheels.six_wheels(0.9) if one_set else np.concatenate([turns, turns[..., :1, :]], -2) if wheeled else turns
        )
    if name == "rotation":
        return _rotations(rng)
    if name == "count":
        return 5
    if name == "angle" and function.__name__ == "cone":
        return rng.uniform(0.1, 1.4, LEAD)
    if name in ("power", "rotor_inertia"):
        return rng.uniform(0.1, 1, (*LEAD, 4))
    if name == "order":
        return "scalar last"
    if name == "half_spaces" or (name in ("momentum", "torque") and function.__name__ == "agility"):
        turns = _rotations(rng)
        return wheels.half_spaces(np.concatenate([turns, turns[..., :1, :]], -2))
    if name in ("tensor", "damping"):
        return inertia.inertia_tensor(rng.uniform(1, 2, (*LEAD, 3)), _rotations(rng))
    if name == "times":
        return np.arange(7.0)
    if name == "rate" and function.__name__ == "turn_time":
        return rng.uniform(0.1, 1, LEAD)
    if name == "rates":
        return rng.uniform(0.1, 1, (*LEAD, 7, 3) if function.__name__ == "kinetic_energy" else (*LEAD, 3))
    if one_set and name in ("limits", "bias"):
        return 1.0
    low, high, *own = NUMBERS.get(name, (0.1, 0.9))
    return rng.uniform(low, high, (*LEAD, *own))


def _inputs(function: Any) -> str:
    return ",".join(f"({','.join(axes)})" for axes in function.signature.inputs)


def _rotations(rng: np.random.Generator) -> Any:
    axes, triangle = np.linalg.qr(rng.normal(size=(*LEAD, 3, 3)))
    axes = axes * np.sign(np.diagonal(triangle, axis1=-2, axis2=-1))[..., None, :]
    return axes * np.linalg.det(axes)[..., None, None]


def _contiguous(value: Any) -> Any:
    if hasattr(value, "_fields"):
        return type(value)(*map(_contiguous, value))
    return np.ascontiguousarray(value) if np.ndim(value) else value
