"""The lines that agents follow."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import route_points
from roadlang.geometry import Curve, Floats

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, SceneRoad

_SPACING = 1.0
"""Meters between points."""


def agent_path(scene: Scene, actor: SceneActor) -> Floats | None:
    """(n, 2) points from where an agent starts: its route, or the middle of its lane up to the end
    of the road, once around a loop. None of an agent that is on no road."""
    if actor.route is not None:
        x, y, _, _ = route_points(scene, actor.route)
        return np.column_stack((x, y))
    road = next((road for road in scene.roads if road.name == actor.road), None)
    if road is None:
        return None
    return lane_path(
        road, actor.lane, actor.start or 0.0, actor.offset or 0.0, actor.facing == "back"
    )


def lane_path(
    road: SceneRoad, lane: int | None, start: float, beside: float, backward: bool
) -> Floats:
    """(n, 2) points from a station to the end of a road, or backward to its start: in the middle
    of a lane, or `beside` meters left of the road without one. Around a loop once."""
    curve = Curve.hermite(np.column_stack((road.x, road.y)), road.heading, closed=road.closed)
    if road.closed:
        stop = start - road.length if backward else start + road.length
    else:
        stop = road.trim[0] if backward else road.length - road.trim[1]
    s = np.linspace(start, stop, max(2, int(abs(stop - start) / _SPACING) + 1))
    if road.closed:
        s = np.mod(s[:-1], road.length)
    section = road.cross_section()
    away = section.offset(lane, s) if lane in section.ids else np.full(len(s), beside)
    points = curve.at(s * curve.length / road.length)
    points = points + away[:, None] * curve.normal(s * curve.length / road.length)
    return np.vstack((points, points[:1])) if road.closed else np.asarray(points)
