"""The lines of the lanes of roads in meters, as figures of drives and reports draw them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.curves.simplifying import all_simplified
from ..geometry.curves.unfolding import SEEN_FROM, unfolded_lines
from ..geometry.lanes.cross_section import CrossSection
from ..geometry.lanes.strokes_of_lanes import LaneStroke, lane_strokes
from ..ir.scene import SceneRoad
from ..ir.surface_stretches import SurfaceStretch, surface_stretches

TOLERANCE = 0.1
"""How far a drawn line may be from the road's, meters."""


@dataclass(frozen=True, eq=False)
class ShownPart:
    """What the junctions leave of a road: points (n, 2) and unit vectors to the left."""

    points: Floats
    left: Floats
    section: CrossSection
    borders: Floats
    """(L + 1, n) of the lanes, meters left of the points"""
    width: float
    """meters, of the drivable lanes on average"""
    stations: Floats
    """(n,) of the points; the ends of all stretches are among them"""
    stretches: tuple[SurfaceStretch, ...]

    def beside(self, offset: Floats) -> Floats:
        """(n, 2) points `offset` (n,) meters left of the road."""
        return np.asarray(self.points + offset[:, None] * self.left)


def shown_part(road: SceneRoad) -> ShownPart | None:
    """From where one junction ends to where the next begins, round a closed road; None of a road
    inside a junction."""
    axis, columns = np.array(road.stations), np.array((road.x, road.y, road.heading))
    if road.closed:  # its last station lies before its end, which is its start
        axis, columns = np.append(axis, road.length), np.hstack([columns, columns[:, :1]])
    first, last = axis[0] + road.trim[0], axis[-1] - road.trim[1]
    if not first < last:
        return None
    section = road.cross_section()
    stretches = surface_stretches(road, section.ids)
    every = np.union1d(axis, [one.end for one in stretches]) if len(stretches) > 1 else axis
    inner = every[(every > first) & (every < last)]
    s = np.concatenate([[first], inner, [last]])
    columns[2] = np.unwrap(columns[2])
    x, y, heading = (np.interp(s, axis, part) for part in columns)
    points, left = np.column_stack([x, y]), np.column_stack([-np.sin(heading), np.cos(heading)])
    width = float(np.mean(road.width))
    return ShownPart(points, left, section, section.border_offsets(s), width, s, stretches)


def painted_lines(part: ShownPart, pixels_per_meter: float) -> Iterator[tuple[Floats, LaneStroke]]:
    """The lines (n, 2) along the lanes, and how each is drawn at this scale."""
    section = part.section
    driven = max(sum(lane.drivable for lane in section.lanes), 1)
    lane = part.width * pixels_per_meter / driven
    for stroke in lane_strokes(section.lanes, section.markings, lane, pixels_per_meter):
        line = part.beside(part.borders[stroke.border] + stroke.shift / pixels_per_meter)
        for piece in unfolded_lines(line, part.points, SEEN_FROM / pixels_per_meter):
            yield piece, stroke


def line_beside(road: SceneRoad, offset: Floats) -> Floats:
    """(n, 2) points left of the stations of a road."""
    heading = np.array(road.heading)
    left = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
    return np.asarray(np.stack([road.x, road.y], axis=-1) + offset[:, None] * left)


def with_few_points(lines: Sequence[Floats], tolerance: float = TOLERANCE) -> list[Floats]:
    """Lines (n, 2) that look the same; of many in hardly more time than of one."""
    kept = all_simplified(lines, tolerance)
    return [line[indices] for line, indices in zip(lines, kept, strict=True)]
