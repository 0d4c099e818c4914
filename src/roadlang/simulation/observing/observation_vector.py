"""What an agent sees as a vector of numbers, for policies that are learned."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ...geometry.arrays import Floats, wrapped
from ...ir.observation import ObservationBatch
from ..vehicles.path_calls import turned
from .lazy_observations import LazyObservations

if TYPE_CHECKING:
    from numpy.typing import NDArray

DISTANCES = (5.0, 10.0, 20.0, 30.0, 50.0)
"""Meters ahead at which the path is seen."""
FASTEST, FARTHEST = 100.0, 200.0
LIMIT_BRAKING = 3.0
"""m/s^2, before lower speed limits"""
_EGO = (
    ("speed", 0.0, FASTEST),
    ("acceleration", -30.0, 30.0),
    ("yaw_rate", -10.0, 10.0),
    ("steering", -1.6, 1.6),
    ("cross_track_error", -50.0, 50.0),
    ("heading_error", -math.pi, math.pi),
    ("left_edge", -50.0, 50.0),
    ("right_edge", -50.0, 50.0),
    ("speed_limit", 0.0, FASTEST),
)
_OTHER = (
    ("seen", 0.0, 1.0),
    ("ahead", -FARTHEST, FARTHEST),
    ("left", -FARTHEST, FARTHEST),
    ("speed_ahead", -FASTEST, FASTEST),
    ("speed_left", -FASTEST, FASTEST),
)


@dataclass(frozen=True)
class ObservationVector:
    """The numbers that a policy gets: SI units and radians, float32, within `low` and `high`.

    First the state of the agent: speed, acceleration, yaw rate, steering angle, cross-track error,
    heading error, distance of its center from the left and the right edge of the road (negative
    outside), and the greatest speed from which all speed limits ahead can be kept by braking with
    3 m/s^2. Then, for each of `distances` (meters along its path), where the
    path is then: meters ahead of the agent and to its left. Then, for each of the `agents` nearest
    other agents within 200 m: 1 (0 where there is none, and all of its numbers are 0), meters ahead
    and to the left from center to center, and its velocity ahead and to the left. Numbers beyond
    the bounds are put at them; so is what is infinite, such as a speed limit where there is none.
    """

    distances: tuple[float, ...] = DISTANCES
    agents: int = 4

    @cached_property
    def _columns(self) -> list[tuple[str, float, float]]:
        far = [abs(distance) + 50.0 for distance in self.distances]
        path = [
            (f"path_{side}_{distance:g}m", -most, most)
            for distance, most in zip(self.distances, far, strict=True)
            for side in ("ahead", "left")
        ]
        others = [
            (f"agent{number}_{name}", low, high)
            for number in range(1, self.agents + 1)
            for name, low, high in _OTHER
        ]
        return [*_EGO, *path, *others]

    @property
    def names(self) -> tuple[str, ...]:
        """What each number is."""
        return tuple(name for name, _, _ in self._columns)

    @cached_property
    def low(self) -> NDArray[np.float32]:
        """(F,) the least value of each number."""
        return np.array([low for _, low, _ in self._columns], dtype=np.float32)

    @cached_property
    def high(self) -> NDArray[np.float32]:
        """(F,) the greatest value of each number."""
        return np.array([high for _, _, high in self._columns], dtype=np.float32)

    def of(self, seen: ObservationBatch) -> NDArray[np.float32]:
        """(N, F) the vectors of N agents. A row depends on its agent alone."""
        count = len(seen.x)
        out = np.empty((len(self.low), count), dtype=np.float32)
        half = 0.5 * seen.road_width
        out[0], out[1], out[2], out[3] = (
            seen.speed, seen.acceleration, seen.yaw_rate, seen.steering,
        )  # fmt: skip
        out[4], out[5] = seen.cross_track_error, wrapped(seen.heading_error)
        out[6], out[7], out[8] = (
            half - seen.road_offset,
            half + seen.road_offset,
            seen.speed_limit_ahead(LIMIT_BRAKING, 0.0),
        )
        axes = np.cos(seen.heading), np.sin(seen.heading)
        place = len(_EGO)
        if self.distances:
            points = _path(seen, tuple(self.distances), axes)
            out[place : place + len(points)] = points
            place += len(points)
        if self.agents:
            place += self._fill_others(seen, axes, out[place:])
        within, (low, high) = out[:place], _bounds(self.low.tobytes(), self.high.tobytes(), count)
        np.maximum(within, low[:place], out=within)
        np.minimum(within, high[:place], out=within)
        found = np.zeros(out.shape[::-1], dtype=np.float32)
        found[:, :place] = within.T
        return found

    def _fill_others(
        self, seen: ObservationBatch, axes: tuple[Floats, Floats], rows: NDArray[np.float32]
    ) -> int:
        """Fill the rows of other agents, (5 agents, N). How many of these there are: none of them,
        if all are 0."""
        x, y, heading, speed = (column.T for column in seen.nearest(self.agents))
        if np.isnan(x[:1]).all():  # nearest first
            return 0
        out = rows.reshape(self.agents, len(_OTHER), -1)
        off_x, off_y = x - seen.x, y - seen.y
        near = off_x * off_x + off_y * off_y <= FARTHEST * FARTHEST  # False where it is NaN
        numbers = (
            near,
            *turned(off_x, off_y, axes),
            *turned(speed * np.cos(heading), speed * np.sin(heading), axes),
        )
        for place, column in enumerate(numbers):
            out[:, place] = np.where(near, column, 0.0)
        return len(rows)


@lru_cache(maxsize=2)
def _bounds(
    lows: bytes, highs: bytes, count: int
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """(F, N) the bounds of the numbers of N agents, of those of one: the lesser and the greater of
    two are found faster than with one bound for all."""
    low, high = (np.frombuffer(each, dtype=np.float32)[:, None] for each in (lows, highs))
    return np.tile(low, count), np.tile(high, count)


def _path(
    seen: ObservationBatch, distances: tuple[float, ...], axes: tuple[Floats, Floats]
) -> Floats:
    """(2 K, N) the points of the path, meters ahead and to the left by turns."""
    if isinstance(seen, LazyObservations):
        places = seen.x, seen.y, *axes
        found: Floats | None = seen.view.path_seen(seen.rows, distances, places)
        if found is not None:
            return found
    x, y = seen.path_ahead(np.array(distances))
    points = np.empty((2 * len(distances), len(seen.x)))
    points[::2], points[1::2] = turned(x - seen.x, y - seen.y, axes)
    return points
