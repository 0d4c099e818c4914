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
