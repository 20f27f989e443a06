"""Curves and a coloured map as parts of SVG drawings: scales, ticks, paths; a picture in the PNG format."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import ceil, floor, log10
from typing import Any

from markupsafe import Markup

from symcheck.views.page.packing import address

WIDTH, HEIGHT, LEFT, BELOW, ABOVE = 560, 340, 52, 46, 10  # of a drawing, in pixels
TICKS = 6  # about so many on an axis
COLOURS = 64  # more cannot be distinguished
PALE, MIDDLE, DARK = (254, 217, 118), (240, 59, 32), (103, 0, 31)  # of a small growth rate, of a middle, of the largest

Scale = Callable[[float], float]


@dataclass(frozen=True)
class Axes:
    """The frame of a drawing: ticks as (place in pixels, number) across and up."""

    across: tuple[tuple[float, str], ...]
    up: tuple[tuple[float, str], ...]
    right: int = WIDTH - 12
    bottom: int = HEIGHT - BELOW
    left: int = LEFT
    top: int = ABOVE


def curves(plot: Mapping[str, Any]) -> tuple[Axes, list[tuple[str, str]]]:
    """The frame of a plot of curves, and each curve as (label, path)."""
    x, highest = plot["x"], max(max(curve["y"]) for curve in plot["curves"])
    axes, right, above = _axes((x[0], x[-1]), (0, 1.05 * highest))
    paths = [
        (curve["label"], _path(zip(map(right, x), map(above, curve["y"]), strict=True))) for curve in plot["curves"]
    ]
    return axes, paths


@dataclass(frozen=True)
class Map:
    """A coloured map: its frame, the picture's address, the path around what is coloured, the value that is darkest."""

    axes: Axes
    image: Markup
    boundary: str
    highest: float


def coloured(plot: Mapping[str, Any]) -> Map:
    """A map of growth rates."""
    rows: Sequence[Sequence[float]] = plot["growth"]
    highest = max(map(max, rows))
    axes, right, above = _axes(plot["x"], plot["y"])
    levels = [bytes(ceil(value / highest * (COLOURS - 1)) for value in row) for row in reversed(rows)]
    image = address("image/png", png(levels, [(0, 0, 0), *map(colour, range(1, COLOURS))]))
    return Map(axes, image, _path((right(x), above(y)) for x, y in plot["boundary"]) + "Z", highest)


def colour(level: int) -> tuple[int, int, int]:
    """The colour of a level, 1 to COLOURS - 1, from pale to dark."""
    share = 2 * (level - 1) / (COLOURS - 2)
    low, high = (PALE, MIDDLE) if share <= 1 else (MIDDLE, DARK)
    part = share if share <= 1 else share - 1
    red, green, blue = (round(a + part * (b - a)) for a, b in zip(low, high, strict=True))
    return red, green, blue


def png(rows: Sequence[bytes], palette: Sequence[tuple[int, int, int]]) -> bytes:
    """A picture in the PNG format, one byte for each point; the first colour of the palette is transparent."""
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 3, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    colours = b"".join(map(bytes, palette))
    chunks = ((b"IHDR", head), (b"PLTE", colours), (b"tRNS", b"\0"), (b"IDAT", body), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)) for name, data in chunks
    )


def _axes(x: Sequence[float], y: Sequence[float]) -> tuple[Axes, Scale, Scale]:
    frame = Axes((), ())
    right = _scale(x, (frame.left, frame.right))
    above = _scale(y, (frame.bottom, frame.top))
    return Axes(_ticks(x, right), _ticks(y, above)), right, above


def _scale(values: Sequence[float], pixels: Sequence[float]) -> Scale:
    slope = (pixels[1] - pixels[0]) / (values[-1] - values[0])
    return lambda value: pixels[0] + slope * (value - values[0])


def _ticks(ends: Sequence[float], scale: Scale) -> tuple[tuple[float, str], ...]:
    """Round numbers between the ends, with their places."""
    low, high = ends[0], ends[-1]
    rough = (high - low) / TICKS
    unit = 10.0 ** floor(log10(rough))
    step = next(factor * unit for factor in (1, 2, 5, 10) if factor * unit >= rough)
    digits = max(0, -floor(log10(step)))
    numbers = [step * n for n in range(ceil(low / step - 1e-9), floor(high / step + 1e-9) + 1)]
    return tuple((round(scale(n), 1), f"{n:.{digits}f}".replace("-", "−")) for n in numbers)


def _path(points: Iterable[tuple[float, float]]) -> str:
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
