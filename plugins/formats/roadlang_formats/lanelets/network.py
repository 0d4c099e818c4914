"""All lanelets of a scene: those of its roads, and those through its junctions."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Floats, poses_along
from roadlang_formats.surfaces.built import built_junctions
from roadlang_formats.surfaces.road_surface import road_surfaces
from roadlang_formats.surfaces.thinning import thinned

from .model import Border, LaneletJunction, LaneletMap, LinePoint, Side
from .road_lanelets import Drafts, add_road

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneConnection, SceneLaneEnd

_SPACING = 0.5
"""Meters between points of a connection before they are thinned."""
_MOST = 20
"""Points that one chord may skip."""


def lanelet_map(scene: Scene, tolerance: float) -> LaneletMap:
    """The lanelets of what is built of a scene. Borders are chords within `tolerance` meters."""
    drafts = Drafts([], [], [], {}, {})
    for surface in road_surfaces(scene, tolerance):
        add_road(drafts, surface)
    junctions = []
    for network, junction in built_junctions(scene):
        numbers: dict[int, int] = {}
        for connection in junction.connections:
            number = _add_connection(drafts, connection, tolerance)
            if number is not None:
                numbers[connection.id] = number
        name = f"{network}/junction {junction.id}"
        junctions.append(LaneletJunction(name, junction, numbers))
    return LaneletMap(
        tuple(drafts.borders),
        tuple(drafts.lanelets),
        tuple(drafts.links),
        tuple(junctions),
        drafts.leaving,
        drafts.entering,
    )


def _add_connection(drafts: Drafts, connection: SceneConnection, tolerance: float) -> int | None:
    """The number of its lanelet; None where a lane has no width at its end."""
    source = drafts.leaving.get(_end(connection.source))
    target = drafts.entering.get(_end(connection.target))
    if source is None or target is None:
        return None
    before, after = drafts.lanelets[source], drafts.lanelets[target]
    lines = _borders(connection, tolerance)
    sides = []
    for line, one, other in zip(
        lines, (before.left, before.right), (after.left, after.right), strict=True
    ):
        # From the very end of one border to the very start of another, so that the points are one.
        points = _joined(_last(drafts, one), line, _first(drafts, other))
        sides.append(Side(len(drafts.borders), False))
        drafts.borders.append(Border(points, "none"))
    left, right = sides
    lanelet = replace(
        before, road="", lane=0, left=left, right=right, both_ways=False,
        speed_limit=after.speed_limit, beside_left=None, beside_right=None, turn=connection.turn,
    )  # fmt: skip
    number = drafts.add(lanelet)
    drafts.links += [(source, number), (number, target)]
    return number


def _end(at: SceneLaneEnd) -> tuple[str, str, int]:
    return at.road, at.end, at.lane


def _joined(before: LinePoint, line: Floats, after: LinePoint) -> tuple[LinePoint, ...]:
    """A line (n, 2) between two points, whose heights change evenly."""
    heights = np.linspace(before[2], after[2], len(line))
    inner = [(x, y, round(z, 6)) for (x, y), z in zip(line.tolist(), heights.tolist(), strict=True)]
    return (before, *inner[1:-1], after)


def _last(drafts: Drafts, side: Side) -> LinePoint:
    return drafts.borders[side.border].points[0 if side.backward else -1]


def _first(drafts: Drafts, side: Side) -> LinePoint:
    return drafts.borders[side.border].points[-1 if side.backward else 0]


def _borders(connection: SceneConnection, tolerance: float) -> Floats:
    """(2, n, 2) points of its left and right border."""
    poses, s = [], []
    pose, begin = np.array(connection.start), 0.0
    for length, curvature in connection.pieces:
        at = np.linspace(0.0, length, int(length / _SPACING) + 2)
        along = poses_along(pose, (curvature, curvature), at)
        poses.append(along[:-1])
        s.append(begin + at[:-1])
        pose, begin = along[-1], begin + length
    line = np.vstack((*poses, pose[None]))
    share = np.append(np.concatenate(s), begin) / begin
    before, after = connection.widths
    half = (before + (after - before) * share)[:, None] / 2.0
    normal = np.column_stack((-np.sin(line[:, 2]), np.cos(line[:, 2])))
    both = np.stack((line[:, :2] + half * normal, line[:, :2] - half * normal))
    flat = np.concatenate((both, np.zeros((*both.shape[:2], 1))), axis=2)
    return np.round(both[:, thinned(flat, tolerance, _MOST)], 6)
