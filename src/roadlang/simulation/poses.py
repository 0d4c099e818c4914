"""Where agents are in the plane, from where they are along their lines."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from .motion import Motion, Track


@dataclass(frozen=True)
class Poses:
    """Columns (N,) over agents: center of the footprint, heading. Meters and radians."""

    x: Floats
    y: Floats
    heading: Floats
    road_width: Floats

    def take(self, rows: Any) -> Poses:
        """Those of some agents."""
        return Poses(self.x[rows], self.y[rows], self.heading[rows], self.road_width[rows])


def poses_of(motion: Motion, track: Track) -> Poses:
    """Where agents in motion are."""
    cell, rest = track.cell(motion.along)
    x, y = line_points(track, cell, rest)
    along = motion.line_heading
    heading = along + np.arctan2(motion.sine, motion.cosine)
    x -= np.sin(along) * motion.offset
    y += np.cos(along) * motion.offset
    return Poses(x, y, heading, track.lines.width[cell])


def line_points(track: Track, cell: Any, rest: Floats) -> tuple[Floats, Floats]:
    """Points of lines, `rest` meters into cells; within a cell a line is an arc."""
    lines, beyond = track.lines, cell + 1
    x, y = lines.x[cell], lines.y[cell]
    slope_x = (lines.x[beyond] - x) * track.per_meter
    slope_y = (lines.y[beyond] - y) * track.per_meter
    bulge = 0.5 * lines.curvature[cell] * rest * (rest - track.spacing)
    return x + slope_x * rest - slope_y * bulge, y + slope_y * rest + slope_x * bulge


def foot_points(track: Track, x: Floats, y: Floats, along: Floats) -> tuple[Floats, Floats, Floats]:
    """(N,) arc lengths of the foot points of places on lines, found from `along`, which is nearly
    that; the distances left of the lines, and the headings of the lines there."""
    offset = np.zeros(len(along))
    for _ in range(2):
        cell, rest = track.cell(along)
        line_x, line_y = line_points(track, cell, rest)
        curvature = track.lines.curvature[cell]
        heading = track.lines.heading[cell] + curvature * rest
        off_x, off_y = x - line_x, y - line_y
        offset = np.cos(heading) * off_y - np.sin(heading) * off_x
        ahead = np.cos(heading) * off_x + np.sin(heading) * off_y
        along = along + ahead / np.maximum(1.0 - offset * curvature, 0.5)
    cell, rest = track.cell(along)
    return along, offset, track.lines.heading[cell] + track.lines.curvature[cell] * rest
