"""Where agents begin, and which line of their road they should follow."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..geometry.arrays import Booleans
from ..ir.scene import SceneActor, SceneRoad
from .motion import Motion, Track
from .poses import line_points


def start_of(
    actors: Sequence[SceneActor], track: Track, backward: Booleans, has_road: Booleans
) -> Motion:
    """The state at the start: each at the pose of its scene, at its speed."""
    pose = np.array([(one.x, one.y, one.heading) for one in actors], dtype=np.float64)
    station = np.array([one.start or 0.0 for one in actors], dtype=np.float64)
    length = track.lines.length[track.row]
    along = np.where(backward, length - station, station) * has_road
    offset = np.zeros(len(actors))
    heading = np.zeros(len(actors))
    for _ in range(2):  # the foot point of the pose; the station of the scene is nearly that
        cell, rest = track.cell(along)
        x, y = line_points(track, cell, rest)
        curvature = track.lines.curvature[cell]
        heading = track.lines.heading[cell] + curvature * rest
        off_x, off_y = pose[:, 0] - x, pose[:, 1] - y
        offset = np.cos(heading) * off_y - np.sin(heading) * off_x
        ahead = np.cos(heading) * off_x + np.sin(heading) * off_y
        along = along + ahead / np.maximum(1.0 - offset * curvature, 0.5)
    cell, rest = track.cell(along)
    heading = track.lines.heading[cell] + track.lines.curvature[cell] * rest
    error = pose[:, 2] - heading
    zero = np.zeros(len(actors))
    return Motion(
        along, offset, np.array([start_speed(one) for one in actors]), zero, zero.copy(),
        np.cos(error), np.sin(error), zero.copy(), heading, zero.copy(),
    )  # fmt: skip


def start_speed(actor: SceneActor) -> float:
    """Speed at the start, m/s; 0 where the scene does not say."""
    speed = actor.start_speed or actor.options.get("initial_speed", 0.0)
    return float(speed) if isinstance(speed, int | float) else 0.0


def line_offset(actor: SceneActor, road: SceneRoad | None, width: float) -> float:
    """How far left of the center line of its road the line lies that an agent should follow.

    The middle of its lane where it has one, else where it stands; from beside the road, the middle.
    `width`: of the road, where it starts.
    """
    if road is None:
        return 0.0
    if actor.lane is not None:
        return lane_center(actor.lane, road.lanes, width)
    offset = actor.offset or 0.0
    return offset if abs(offset) < width / 2 else 0.0


def lane_center(lane: int, lanes: int, width: float) -> float:
    """Offset of the middle of a lane (OpenDRIVE numbers: -1 first to the right, 1 to the left)."""
    if lanes == 1:
        return 0.0
    side = 1.0 if lane > 0 else -1.0
    return side * (abs(lane) - 0.5) * width / max(lanes, 1)
