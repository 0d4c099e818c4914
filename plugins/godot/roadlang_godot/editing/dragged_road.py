"""A scene while a place of a road is dragged: what the text will compile to, without compiling."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from roadlang_standard.perturb_nudges import share_of_move

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneRoad


def with_dragged_road(
    scene: Scene, name: str, station: float, by: tuple[float, float], length: float
) -> Scene | None:
    """The scene with a place of a road, `station` meters along its root road, moved `by` meters
    east and north, and with it `length` meters of road around. Agents and objects stay.

    None where the road is not shown by itself, but by a network below it.
    """
    road = next((found for found in scene.roads if found.name == name), None)
    if road is None or road.along:
        return None
    moved = _moved(road, station, by, length)
    return replace(scene, roads=tuple(moved if found is road else found for found in scene.roads))


def _moved(road: SceneRoad, station: float, by: tuple[float, float], length: float) -> SceneRoad:
    at = np.array(road.reference_stations)
    period = float(at[-1] + at[1] - at[0]) if road.closed else None
    share = share_of_move(at, station, length, period)
    points = np.column_stack([road.x, road.y]) + share[:, None] * np.array(by)
    ring = points
    if road.closed:
        ring = np.vstack([points[-2:], points, points[:2]])
    steps = np.hypot(*np.diff(ring, axis=0).T)
    s = np.concatenate([[0.0], np.cumsum(steps)])
    heading = np.unwrap(np.arctan2(*np.gradient(ring, s, axis=0).T[::-1]))
    curvature = np.gradient(heading, s)
    inner = slice(2, -2) if road.closed else slice(None)
    stations = s[inner] - s[inner][0]
    end = float(s[-2] - s[2]) if road.closed else float(stations[-1])
    return replace(
        road,
        x=tuple(points[:, 0].tolist()),
        y=tuple(points[:, 1].tolist()),
        heading=tuple(heading[inner].tolist()),
        curvature=tuple(curvature[inner].tolist()),
        stations=tuple(stations.tolist()),
        length=end,
    )
