"""A road of a scene as its stations have it, and where lines and arcs begin between them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats, poses_along

if TYPE_CHECKING:
    from roadlang.api import SceneRoad

EXACT = 1e-5
"""Meters: what is nearer to a line, arc or clothoid is one."""
STRAIGHT = 1e-7
"""1/m: what bends less does not, and curvatures that differ by less are one."""
_BENT = 1e-4
"""1/m: curvatures that differ by less have no seam between them."""
_STEPS = 5
"""Of Newton's method, until both pieces are as long as they are."""
_SHORTEST = 1e-3
"""Meters from a seam to a station."""


@dataclass(frozen=True)
class SampledLine:
    """Stations (n,), poses (n, 3) there, curvatures (n,) there and just before, which differ where
    one piece becomes another, and the poses (n - 1, 3) in between."""

    stations: Floats
    poses: Floats
    curvature: Floats
    curvature_before: Floats
    between: Floats

    @classmethod
    def of(cls, road: SceneRoad, stations: Floats) -> SampledLine:
        """Of a road of a scene, exactly as it has them where the stations are its own."""
        at, curvature = whole_turns(road), np.array(road.curvature)
        if road.closed:
            curvature = np.append(curvature, curvature[0])
        bends = np.interp(stations, at[:, 0], curvature)
        poses = poses_between(at, stations)
        rows, extra, seams, before, after = _seams(stations, poses, bends)
        stations = np.insert(stations, rows, extra)
        middles = (stations[1:] + stations[:-1]) / 2.0
        return cls(
            stations,
            np.insert(poses, rows, seams, axis=0),
            np.insert(bends, rows, after),
            np.insert(bends, rows, before),
            poses_between(at, middles),
        )


def _seams(
    stations: Floats, poses: Floats, curvature: Floats
) -> tuple[list[int], list[float], Floats, list[float], list[float]]:
    """Where, between two stations, a line or an arc becomes another, as anywhere in maps: before
    which rows, stations, poses (k, 3), and curvatures before and after.

    How far the two reach follows from the heading and the place of the second station.
    """
    step = np.diff(curvature)
    even = np.concatenate(([True], np.abs(step) < STRAIGHT, [True]))
    found: list[tuple[int, float, Floats, float, float]] = []
    for row in np.flatnonzero((np.abs(step) > _BENT) & even[:-2] & even[2:]).tolist():
        turns, length = curvature[row : row + 2], float(stations[row + 1] - stations[row])
        reach, seam = _seam(poses[row], poses[row + 1], turns, length)
        if seam is not None:
            station = float(stations[row]) + reach * length
            found.append((row + 1, station, seam, float(turns[0]), float(turns[1])))
    seams = np.array([seam for _, _, seam, _, _ in found]).reshape(-1, 3)
    rows, extra = [item[0] for item in found], [item[1] for item in found]
    return rows, extra, seams, [item[3] for item in found], [item[4] for item in found]


def _seam(one: Floats, other: Floats, bends: Floats, length: float) -> tuple[float, Floats | None]:
    """At which share of the way, and in which pose (3,), a piece of the first curvature becomes one
    of the second; None where no two such pieces lead from one pose to the other."""
    parts, end = np.array([length / 2.0, length / 2.0]), one
    for _ in range(_STEPS):
        seam = poses_along(one, (bends[0], bends[0]), np.array([0.0, parts[0]]))[-1]
        end = poses_along(seam, (bends[1], bends[1]), np.array([0.0, parts[1]]))[-1]
        away = other - end
        along = math.cos(other[2]) * away[0] + math.sin(other[2]) * away[1]
        parts = parts + np.linalg.solve(np.stack((bends, np.ones(2))), np.array([away[2], along]))
        if parts.min() < _SHORTEST:
            return 0.0, None
    off = other - end
    close = np.hypot(*off[:2]) < 10.0 * EXACT and abs(off[2]) < 10.0 * EXACT
    return float(parts[0] / parts.sum()), seam if close else None


def whole_turns(road: SceneRoad) -> Floats:
    """(n, 4) station, x, y and heading of all points of a road; a loop ends where it begins."""
    table = np.column_stack((road.stations, road.x, road.y, road.heading))
    if not road.closed:
        return table
    turn = 2.0 * np.pi * np.round((table[-1, 3] - table[0, 3]) / (2.0 * np.pi))
    return np.vstack((table, (road.length, *table[0, 1:3], table[0, 3] + turn)))


def poses_between(table: Floats, stations: Floats) -> Floats:
    """(n, 3) poses at stations (n,): cubics between the rows of station, x, y and heading."""
    after = np.clip(np.searchsorted(table[:, 0], stations), 1, len(table) - 1)
    one, other = table[after - 1], table[after]
    length = (other[:, 0] - one[:, 0])[:, None]
    p = ((stations - one[:, 0]) / length[:, 0])[:, None]
    leaves, enters = (np.column_stack((np.cos(r[:, 3]), np.sin(r[:, 3]))) for r in (one, other))
    step = (other - one)[:, 1:3]
    c = 3.0 * step - length * (2.0 * leaves + enters)
    d = length * (leaves + enters) - 2.0 * step
    points = one[:, 1:3] + p * (length * leaves + p * (c + p * d))
    slope = length * leaves + p * (2.0 * c + 3.0 * p * d)
    near = one[:, 3] + p[:, 0] * (other[:, 3] - one[:, 3])
    heading = np.arctan2(slope[:, 1], slope[:, 0])
    heading += 2.0 * np.pi * np.round((near - heading) / (2.0 * np.pi))
    return np.column_stack((points, heading))
