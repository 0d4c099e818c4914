"""Where the signals of a junction stand, and whom each is for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..ir.scene_junctions import SceneJunction
from .junction_paint import connections_by_lane

BESIDE = 0.8
"""Meters from the outer end of the stop line."""
APART = 0.6
"""Meters between signals for different lanes of one road."""


@dataclass(frozen=True, slots=True)
class SignalHead:
    """A set of lights that lanes of one road share."""

    x: float
    """meters east"""
    y: float
    """meters north"""
    heading: float
    """of the vehicles that look at it, radians"""
    connections: tuple[int, ...]
    """ids of the connections that it is for: all of them have green together"""


def signal_heads(junction: SceneJunction) -> Iterator[SignalHead]:
    """One for the lanes of a road that have green together, beside the outermost stop line."""
    control = junction.control
    if control.kind != "signals" or not control.phases:
        return
    groups: dict[tuple[str, str], dict[tuple[bool, ...], list[int]]] = {}
    for (road, end, _), connections in connections_by_lane(junction).items():
        green = tuple(connections[0].id in phase.connections for phase in control.phases)
        ids = groups.setdefault((road, end), {}).setdefault(green, [])
        ids += [connection.id for connection in connections]
    for at, by_light in groups.items():
        place, outward, heading = _place(junction, at)
        for number, ids in enumerate(by_light.values()):
            x, y = place + (BESIDE + number * APART) * outward
            yield SignalHead(float(x), float(y), heading, tuple(ids))


def _place(junction: SceneJunction, at: tuple[str, str]) -> tuple[np.ndarray, np.ndarray, float]:
    """The outer end of the stop lines of a road, the direction away from the road, the heading."""
    sources = [c for c in junction.connections if (c.source.road, c.source.end) == at]
    arm = next(arm for arm in junction.arms if (arm.road, arm.end) == at)
    middle = (np.array(junction.area[arm.left]) + np.array(junction.area[arm.right])) / 2.0
    ends = [(np.array(end), side) for c in sources for side, end in enumerate(c.stop_line)]
    # The right side first: it is the outer one of a road that is one-way too.
    ends.sort(key=lambda end: (-round(float(np.hypot(*(end[0] - middle))), 3), -end[1]))
    place, side = ends[0]
    heading = sources[0].start[2]
    left = np.array([-np.sin(heading), np.cos(heading)])
    return place, left if side == 0 else -left, heading
