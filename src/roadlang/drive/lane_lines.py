"""The lines of the lanes of roads in meters, as figures of drives and reports draw them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.simplifying import all_simplified
from ..geometry.strokes_of_lanes import LaneStroke, lane_strokes
from ..geometry.unfolding import unfolded_lines
from ..ir.scene import SceneRoad

TOLERANCE = 0.1
"""How far the drawn line may be from the road's, meters."""
_LOOPS_SEEN_FROM = 0.35
"""Pixels"""


@dataclass(frozen=True, eq=False)
class ShownPart:
    """What the junctions leave of a road: stations, points (n, 2) and unit vectors to the left."""

    stations: Floats
    points: Floats
    left: Floats

    def beside(self, offset: Floats) -> Floats:
        """(n, 2) points `offset` (n,) meters left of the road."""
        return np.asarray(self.points + offset[:, None] * self.left)


def shown_part(road: SceneRoad) -> ShownPart | None:
    """From where one junction ends to where the next begins, round a closed road; None of a road
    inside a junction."""
    axis = np.array(road.stations)
    first, last = axis[0] + road.trim[0], axis[-1] - road.trim[1]
    if not first < last:
        return None
    inner = axis[(axis > first) & (axis < last)]
    s = np.concatenate([[first], inner, [last]])
    heading = np.interp(s, axis, np.unwrap(road.heading))
    points = np.column_stack([np.interp(s, axis, part) for part in (road.x, road.y)])
    left = np.column_stack([-np.sin(heading), np.cos(heading)])
    if road.closed:
        s = np.append(s, axis[0])
        points, left = (np.concatenate([part, part[:1]]) for part in (points, left))
    return ShownPart(s, points, left)


def painted_lines(road: SceneRoad, pixels_per_meter: float) -> Iterator[tuple[Floats, LaneStroke]]:
    """The lines along the lanes of a road outside of junctions (n, 2), in meters with few points,
    and how each is drawn at this scale."""
    section, part = road.cross_section(), shown_part(road)
    if part is None:
        return
    driven = max(sum(lane.drivable for lane in section.lanes), 1)
    lane = float(np.mean(road.width)) * pixels_per_meter / driven
    borders = section.border_offsets(part.stations)
    pieces, strokes = [], []
    for stroke in lane_strokes(section.markings, lane, pixels_per_meter):
        line = part.beside(borders[stroke.border] + stroke.shift / pixels_per_meter)
        for piece in unfolded_lines(line, part.points, _LOOPS_SEEN_FROM / pixels_per_meter):
            pieces.append(piece)
            strokes.append(stroke)
    yield from zip(few_points(*pieces), strokes, strict=True)


def line_beside(road: SceneRoad, offset: Floats) -> Floats:
    """(n, 2) points left of the stations of a road."""
    heading = np.array(road.heading)
    left = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
    return np.asarray(np.stack([road.x, road.y], axis=-1) + offset[:, None] * left)


def few_points(*lines: Floats) -> list[Floats]:
    """Lines with few points, which look the same."""
    kept = all_simplified(lines, TOLERANCE)
    return [line[indices] for line, indices in zip(lines, kept, strict=True)]
