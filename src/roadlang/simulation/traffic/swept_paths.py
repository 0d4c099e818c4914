"""The ground that vehicles of some size cover on a connection: rectangles along their lines."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.curves.bend_room import LONG
from ...ir.scene_junctions import SceneConnection
from ..bends.leaning import leaned_source
from ..lines.line_sources import LineSource
from ..lines.route_lines import connection_points
from ..vehicles.bodies import Bodies

BEFORE = 6.0
"""Meters before the stop line from which on the front counts."""
SPACING = 0.6
"""Meters between two rectangles along a line."""
STRAIGHT = 25.0
"""Meters before and after a connection that lanes are taken to be straight."""
BESIDE, ALONG = 0.15, 0.25
"""Meters around each vehicle, to its sides and to its front and rear, that others keep out of."""
LENGTH_STEP, WIDTH_STEP = 0.5, 0.1
"""Meters: sizes are rounded up to multiples of these."""


@dataclass(frozen=True)
class VehicleSize:
    """What the ground that a vehicle covers depends on. Meters and radians."""

    length: float
    width: float
    half_base: float
    max_steering: float


def sizes_of(bodies: Bodies, aside: Floats) -> tuple[tuple[VehicleSize, ...], Integers]:
    """The different sizes of agents, and (N,) the number of that of each. Whose line is moved by
    `aside` (N,) meters needs as much more to both sides."""
    rounded = (
        np.ceil(bodies.length / LENGTH_STEP - 1e-6) * LENGTH_STEP,
        np.ceil((bodies.width + 2.0 * aside) / WIDTH_STEP - 1e-6) * WIDTH_STEP,
        np.round(bodies.half_base / WIDTH_STEP) * WIDTH_STEP,
        bodies.max_steering,
    )
    rows = list(zip(*(column.tolist() for column in rounded), strict=True))
    numbers = {row: number for number, row in enumerate(dict.fromkeys(rows))}
    found = tuple(VehicleSize(*row) for row in numbers)
    return found, np.array([numbers[row] for row in rows], dtype=np.int64)


@dataclass(frozen=True)
class SweptPath:
    """Columns (M,): the rectangles that a vehicle covers one after another."""

    s: Floats
    """meters from the stop line to the middle of the vehicle, along its line"""
    x: Floats
    y: Floats
    cosine: Floats
    sine: Floats
    half_length: float
    half_width: float
    """with the space around it"""
    length: float
    """of the vehicle alone"""

    @classmethod
    def of(cls, connection: SceneConnection, size: VehicleSize) -> SweptPath:
        """From where the front is `BEFORE` meters before the line until the rear has left the
        connection. The middle is on the line; the vehicle points along it at its rear axle."""
        source, stop, end = _line(connection, size)
        half = 0.5 * size.length
        first, last = stop - half - BEFORE, end + half
        s = np.linspace(first, last, math.ceil((last - first) / SPACING) + 1)
        x, y = (np.interp(s, source.s, column) for column in (source.x, source.y))
        heading = np.interp(s - size.half_base, source.s, source.heading)
        return cls(
            s - stop, x, y, np.cos(heading), np.sin(heading), half + ALONG,
            0.5 * size.width + BESIDE, size.length,
        )  # fmt: skip

    def meets(self, other: SweptPath) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """Where each of the two covers ground that the other covers too: meters from the stop line
        to its front as it comes there, and to its rear as it has left; None for nowhere."""
        return self._where(other, _overlap(self, other))

    def meets_again(
        self, other: SweptPath
    ) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """The same of two that come out of one lane, beyond the place where their ways part."""
        there = _overlap(self, other)
        mine, its = (int(np.append(there.any(axis=axis), False).argmin()) for axis in (1, 0))
        there[:mine] = False
        there[:, :its] = False
        return self._where(other, there)

    def _where(
        self, other: SweptPath, there: Booleans
    ) -> tuple[tuple[float, float], tuple[float, float]] | None:
        if not there.any():
            return None
        mine, its = (np.flatnonzero(there.any(axis=axis)) for axis in (1, 0))
        return self._interval(mine), other._interval(its)

    def _interval(self, there: Integers) -> tuple[float, float]:
        s, half = self.s[there], 0.5 * self.length
        spacing = float(self.s[1] - self.s[0])
        return float(s[0]) + half - spacing, float(s[-1]) - half + spacing


def _line(connection: SceneConnection, size: VehicleSize) -> tuple[LineSource, float, float]:
    """The line of the middle of a vehicle, with straight lanes before and after the connection,
    and the arc lengths where that begins and ends."""
    s, x, y, heading = connection_points(connection)
    away = np.array([STRAIGHT])
    before = x[0] - STRAIGHT * np.cos(heading[:1]), y[0] - STRAIGHT * np.sin(heading[:1])
    after = x[-1] + STRAIGHT * np.cos(heading[-1:]), y[-1] + STRAIGHT * np.sin(heading[-1:])
    along = np.concatenate([[0.0], s + STRAIGHT, s[-1] + 2.0 * away])
    source = LineSource(
        along,
        np.concatenate([before[0], x, after[0]]),
        np.concatenate([before[1], y, after[1]]),
        np.concatenate([heading[:1], heading, heading[-1:]]),
        connection.widths[0],
    )
    ends = STRAIGHT, STRAIGHT + float(s[-1])
    if size.length <= LONG:
        return source, *ends
    leans, old, new = leaned_source(source, size.length, size.half_base, size.max_steering)
    begin, end = (float(np.interp(place, old, new)) for place in ends)
    return leans, begin, end


def _overlap(first: SweptPath, second: SweptPath) -> Booleans:
    """(M, M) which rectangles overlap, by separating axes."""
    dx = second.x[None, :] - first.x[:, None]
    dy = second.y[None, :] - first.y[:, None]
    radii = (math.hypot(path.half_length, path.half_width) for path in (first, second))
    least = sum(radii)
    out = np.asarray(dx * dx + dy * dy < least * least)
    one, two = np.nonzero(out)
    if not len(one):
        return out
    dx, dy = dx[one, two], dy[one, two]
    axes = (first.cosine[one], first.sine[one]), (second.cosine[two], second.sine[two])
    (cos_a, sin_a), (cos_b, sin_b) = axes
    turn = np.abs(cos_a * cos_b + sin_a * sin_b), np.abs(cos_a * sin_b - sin_a * cos_b)
    fits = np.ones(len(one), dtype=bool)
    for path, other, (cosine, sine) in ((first, second, axes[0]), (second, first, axes[1])):
        ahead, left = np.abs(cosine * dx + sine * dy), np.abs(cosine * dy - sine * dx)
        fits &= ahead < path.half_length + other.half_length * turn[0] + other.half_width * turn[1]
        fits &= left < path.half_width + other.half_length * turn[1] + other.half_width * turn[0]
    out[one, two] = fits
    return out
