"""Lanelets, as CommonRoad and Lanelet2 have them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from roadlang.api import SceneConnection, SceneJunction
from roadlang.geometry import Floats

LinePoint = tuple[float, float, float]
"""Meters east, north and up; equal points are one."""


@dataclass(frozen=True)
class Border:
    """A line between lanes, which lanelets on both sides share. `marking`: that of the lane."""

    points: tuple[LinePoint, ...]
    marking: Literal["solid", "broken", "double", "none", "curb"]


@dataclass(frozen=True)
class Side:
    """A border as a lanelet has it: by its number, and whether it runs against the lanelet."""

    border: int
    backward: bool


@dataclass(frozen=True)
class Lanelet:
    """A part of a lane, in its direction of travel.

    `kind`, `users` and `drivable` are those of the lane; `both_ways` is true where those who walk
    go both ways. `speed_limit` is m/s. `left_of` and `right_of` are the numbers of the lanelets
    beside it, and whether they run the same way. `turn` is that of a connection of a junction.
    """

    road: str
    lane: int
    left: Side
    right: Side
    kind: str
    users: tuple[str, ...]
    drivable: bool
    both_ways: bool = False
    speed_limit: float | None = None
    beside_left: tuple[int, bool] | None = None
    beside_right: tuple[int, bool] | None = None
    turn: Literal["", "left", "straight", "right", "u"] = ""


@dataclass(frozen=True)
class LaneletJunction:
    """A junction, and the lanelets of its connections by their ids."""

    name: str
    junction: SceneJunction
    connections: Mapping[int, int]

    def connection(self, id: int) -> SceneConnection:
        """By its id."""
        return next(item for item in self.junction.connections if item.id == id)


@dataclass(frozen=True)
class LaneletMap:
    """Lanelets and borders by their numbers, and which lanelets lead into which (pairs).

    `leaving` and `entering` are the lanelets at the ends of roads, by road, end and lane: those
    by which traffic leaves the road, and by which it enters it.
    """

    borders: tuple[Border, ...]
    lanelets: tuple[Lanelet, ...]
    links: tuple[tuple[int, int], ...]
    junctions: tuple[LaneletJunction, ...]
    leaving: Mapping[tuple[str, str, int], int]
    entering: Mapping[tuple[str, str, int], int]

    def line(self, side: Side) -> tuple[LinePoint, ...]:
        """The points of a border in the direction of a lanelet."""
        points = self.borders[side.border].points
        return points[::-1] if side.backward else points

    def predecessors(self, lanelet: int) -> tuple[int, ...]:
        """The lanelets that lead into it."""
        return tuple(source for source, target in self.links if target == lanelet)


def xy(points: tuple[LinePoint, ...]) -> Floats:
    """(n, 2) points without their heights."""
    import numpy as np

    return np.array(points)[:, :2]
