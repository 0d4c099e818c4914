"""Roads drawn from pieces of linear curvature: straights, arcs and clothoids, end to end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import FARTHEST, Floats, finite, norm
from ..errors import GeometryError
from .curve import Curve

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(10)
_LARGEST_TURN = 0.1
_MOST_SAMPLES = 1_000_000


@dataclass(frozen=True, slots=True)
class Straight:
    """`length` meters straight on; positive."""

    length: float

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvature at start and end, in 1/m."""
        return 0.0, 0.0


@dataclass(frozen=True, slots=True)
class Arc:
    """Part of a circle of `radius` meters, which turns by `angle` radians, left positive."""

    radius: float
    angle: float

    @property
    def length(self) -> float:
        """Arc length in meters."""
        return self.radius * abs(self.angle)

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvature at start and end, in 1/m."""
        curvature = float(np.copysign(1.0 / self.radius, self.angle))
        return curvature, curvature


@dataclass(frozen=True, slots=True)
class Clothoid:
    """`length` meters, positive, over which the curvature (1/m, left positive) changes evenly."""

    length: float
    start_curvature: float
    end_curvature: float

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvature at start and end, in 1/m."""
        return self.start_curvature, self.end_curvature


Segment: TypeAlias = Straight | Arc | Clothoid


@dataclass(frozen=True, eq=False)
class Chain:
    """Exact samples of connected pieces; where the curvature jumps, that of the piece ahead."""

    stations: Floats
    points: Floats
    heading: Floats
    curvature: Floats

    def curve(self, closed: bool = False) -> Curve:
        """The curve through the samples with their headings.

        If closed, the last sample must come back to the first, and is left out.
        """
        if not closed:
            return Curve.hermite(self.points, self.heading)
        gap = float(norm(self.points[-1] - self.points[0]))
        if gap > 1e-3 * float(self.stations[-1]):
            raise GeometryError(f"the pieces do not close: the end is {gap:.3g} m from the start")
        return Curve.hermite(self.points[:-1], self.heading[:-1], closed=True)


def chain(
    segments: Sequence[Segment],
    start: ArrayLike = (0.0, 0.0),
    heading: float = 0.0,
    spacing: float = 1.0,
) -> Chain:
    """Samples of `segments` laid end to end from `start` (x, y) with `heading` radians.

    At most `spacing` meters and a tenth of a radian apart. The positions are the Fresnel-type
    integrals of the heading by Gauss-Legendre quadrature, exact to rounding.
    """
    if not segments:
        raise GeometryError("a road needs at least one piece")
    if not spacing > 0.0:
        raise GeometryError("the spacing of samples must be positive")
    at, direction, s = finite(start, "the start").reshape(2), float(heading), 0.0
    parts: list[tuple[Floats, Floats, Floats, Floats]] = []
    for segment in segments:
        local, points, headings, curvatures = _sampled(segment, direction, spacing)
        parts.append((s + local[:-1], at + points[:-1], headings[:-1], curvatures[:-1]))
        at, direction, s = at + points[-1], float(headings[-1]), s + float(local[-1])
        end = (np.array([s]), at[None], headings[-1:], curvatures[-1:])
    parts.append(end)
    return Chain(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _sampled(
    segment: Segment, heading: float, spacing: float
) -> tuple[Floats, Floats, Floats, Floats]:
    """Stations, points from (0, 0), headings and curvatures of one piece, both ends included."""
    _check(segment)
    length, (first, last) = segment.length, segment.curvatures
    largest = max(abs(first), abs(last))
    wanted = max(length / spacing, length * largest / _LARGEST_TURN, 1.0)
    if wanted > _MOST_SAMPLES:
        raise GeometryError("a piece is too long, or turns too often, to be sampled")
    stations = np.linspace(0.0, length, int(np.ceil(wanted - 1e-9)) + 1)
    rate = (last - first) / length
    points, headings = _integrated(stations, heading, first, rate)
    return stations, points, headings, first + rate * stations


def poses_along(start: Floats, curvatures: tuple[float, float], stations: Floats) -> Floats:
    """(n, 3) x, y and heading at `stations` (n,), increasing from 0, of a curve that begins in the
    pose `start` (3,) and whose curvature (1/m) changes evenly up to the last station."""
    first, last = curvatures
    steps = np.diff(stations)
    turn = float(steps.max(initial=0.0)) * max(abs(first), abs(last))
    parts = max(1, int(np.ceil(turn / _LARGEST_TURN)))
    share = np.arange(parts) / parts
    fine = np.append((stations[:-1, None] + steps[:, None] * share).ravel(), stations[-1])
    points, headings = _integrated(fine, float(start[2]), first, (last - first) / stations[-1])
    return np.column_stack((start[:2] + points, headings))[::parts]


def _integrated(
    stations: Floats, heading: float, curvature: float, rate: float
) -> tuple[Floats, Floats]:
    """Points (n, 2) from (0, 0) and headings (n,) at stations that are close to each other."""
    headings = heading + stations * (curvature + rate * stations / 2.0)
    half = np.diff(stations)[:, None] / 2.0
    inner = stations[:-1, None] + half * (1.0 + _NODES)
    angles = heading + inner * (curvature + rate * inner / 2.0)
    steps = np.stack([np.cos(angles) @ _WEIGHTS, np.sin(angles) @ _WEIGHTS], axis=-1) * half
    return np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)]), headings


def _check(segment: Segment) -> None:
    if isinstance(segment, Arc):
        finite([segment.radius, segment.angle], "the radius and angle of an arc")
        if not segment.radius > 0.0:
            raise GeometryError("the radius of an arc must be positive; its angle has the sign")
        if segment.angle == 0.0:
            raise GeometryError("the angle of an arc must not be zero")
    numbers = finite([segment.length, *segment.curvatures], "the numbers of a piece")
    if not 0.0 < numbers[0] <= FARTHEST:
        raise GeometryError("the length of a piece must be positive")
