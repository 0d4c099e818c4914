"""Agents that go where a recording had them, whatever the equations of motion say."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, wrapped
from .motion import MOTION_COLUMNS, Motion, Track
from .poses import Poses, foot_points, line_widths, poses_of

LOST = 1.0
"""Meters of a foot point from where it was looked for, from which on the whole line is searched."""


@dataclass(frozen=True)
class Placing:
    """R agents of a world on their way between two poses, (R, 4): x, y, heading, speed."""

    rows: Any
    """their columns; a slice where they are all agents, as that copies nothing"""
    start: Floats
    end: Floats
    steps: int
    """of the vehicles, from one to the other"""

    @classmethod
    def of(
        cls, poses: Poses, motion: Motion, wanted: Floats, free: Booleans, steps: int
    ) -> Placing | None:
        """`wanted`: (N, 4), NaN for who goes on as physics has it; `free`: who may move at all."""
        found = (np.isfinite(wanted[:, 0]) & free).nonzero()[0]
        if not len(found):
            return None
        rows = slice(None) if len(found) == len(wanted) else found
        heading = poses.heading[rows]
        start = np.empty((len(found), 4))
        start[:, 0], start[:, 1], start[:, 2] = poses.x[rows], poses.y[rows], heading
        start[:, 3] = motion.speed[rows]
        end = wanted[rows].copy()
        end[:, 2] = heading + wrapped(end[:, 2] - heading)
        return cls(rows, start, end, steps)

    def at(self, steps: int) -> Floats:
        """(R, 4) after some of the steps; the end, to the last bit, after all."""
        if steps == self.steps:
            return self.end
        return self.start + (self.end - self.start) * (steps / self.steps)

    def put(self, motion: Motion, track: Track, steps: int, seconds: float) -> None:
        """Write the state after some of the steps, `seconds` after the begin, into a motion."""
        rows, now = self.rows, self.at(steps)
        part = track.of_rows(rows)
        along, offset, line = foot_points(part, now[:, 0], now[:, 1], motion.along[rows])
        lost = (np.abs(along - motion.along[rows]) > LOST).nonzero()[0]
        if len(lost):
            near = _nearest(part.of_rows(lost), now[lost, 0], now[lost, 1])
            found = foot_points(part.of_rows(lost), now[lost, 0], now[lost, 1], near)
            along[lost], offset[lost], line[lost] = found
        error = now[:, 2] - line
        there = Motion(
            along=along,
            offset=offset,
            line_heading=line,
            cosine=np.cos(error),
            sine=np.sin(error),
            tangent=motion.tangent[rows].copy(),
            speed=now[:, 3].copy(),  # who halts is written in place
            slide=np.zeros(len(now)),
            yaw_rate=(now[:, 2] - self.start[:, 2]) / seconds,
            acceleration=(now[:, 3] - self.start[:, 3]) / seconds,
        )
        for name in MOTION_COLUMNS:
            column = getattr(there, name)
            if not isinstance(rows, slice):
                placed, column = column, getattr(motion, name).copy()
                column[rows] = placed
            setattr(motion, name, column)

    def poses(self, motion: Motion, track: Track, steps: int, stays: Booleans) -> Poses:
        """Those of all agents; exact of who goes by a recording, but for who `stays`."""
        now = self.at(steps)
        if isinstance(self.rows, slice) and not stays.any():
            x, y, heading = now[:, :3].T.copy()
            return Poses(x, y, heading, line_widths(track, motion.along))
        poses, free = poses_of(motion, track), ~stays[self.rows]
        rows, now = np.arange(len(stays))[self.rows][free], now[free]
        columns = [poses.x.copy(), poses.y.copy(), poses.heading.copy()]
        for column, values in zip(columns, now.T[:3], strict=True):
            column[rows] = values
        return replace(poses, x=columns[0], y=columns[1], heading=columns[2])


def _nearest(track: Track, x: Floats, y: Floats) -> Floats:
    """(R,) arc lengths of the nodes of the lines that are nearest to places."""
    lines = track.lines
    grid = np.arange(lines.cells)
    nodes = track.first[:, None] + np.minimum(grid, track.last[:, None].astype(np.int64))
    off_x, off_y = lines.x[nodes] - x[:, None], lines.y[nodes] - y[:, None]
    nearest: Floats = track.origin + (off_x * off_x + off_y * off_y).argmin(axis=1) * track.spacing
    return nearest
