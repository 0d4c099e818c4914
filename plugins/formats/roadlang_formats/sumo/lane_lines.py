"""The middles of lanes as lines of few points."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats

from ..opendrive.sampled_line import poses_between, whole_turns

if TYPE_CHECKING:
    from roadlang.api import SceneRoad
    from roadlang.geometry import CrossSection

TOLERANCE = 0.01
"""Meters by which a written line may be off."""
_SAME = 1e-6
"""Meters between stations that are one."""


def lane_line(
    road: SceneRoad, section: CrossSection, lane: int, start: float, stop: float
) -> Floats:
    """(n, 2) points of the middle of a lane between two stations, along the road."""
    table = whole_turns(road)
    inside = table[:, 0][(table[:, 0] > start + _SAME) & (table[:, 0] < stop - _SAME)]
    stations = np.concatenate(([start], inside, [stop]))
    x, y, heading = poses_between(table, stations).T
    offset = np.broadcast_to(section.offset(lane, stations), stations.shape)
    return np.column_stack((x - offset * np.sin(heading), y + offset * np.cos(heading)))


def line_length(points: Floats) -> float:
    """Meters."""
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def simplified(points: Floats, tolerance: float = TOLERANCE) -> Floats:
    """Some of the points (n, 2), the first and the last among them, none of the others farther
    from their line (Douglas and Peucker 1973)."""
    keeps = np.zeros(len(points), dtype=bool)
    keeps[[0, -1]] = True
    open_ = [(0, len(points) - 1)]
    while open_:
        first, last = open_.pop()
        if last - first < 2:
            continue
        along = points[last] - points[first]
        off = points[first + 1 : last] - points[first]
        span = float(np.hypot(*along))
        if span > 0.0:
            away = np.abs(along[0] * off[:, 1] - along[1] * off[:, 0]) / span
        else:
            away = np.hypot(*off.T)
        if away.max() > tolerance:
            middle = first + 1 + int(away.argmax())
            keeps[middle] = True
            open_ += [(first, middle), (middle, last)]
    return points[keeps]
