"""Agents that go where a recording had them, whatever the equations of motion say."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np

from ..geometry.arrays import Booleans, Floats, Integers, wrapped
from .motion import Motion, Track
from .poses import Poses, foot_points

LOST = 1.0
"""Meters of a foot point from where it was looked for, from which on the whole line is searched."""


@dataclass(frozen=True)
class Placing:
    """R agents of a world on their way between two poses, (R, 4): x, y, heading, speed."""

    rows: Integers
    start: Floats
    end: Floats
    steps: int
    """of the vehicles, from one to the other"""

    @classmethod
    def of(
        cls, poses: Poses, motion: Motion, wanted: Floats, free: Booleans, steps: int
    ) -> Placing | None:
        """`wanted`: (N, 4), NaN for who goes on as physics has it; `free`: who may move at all."""
        rows = np.flatnonzero(np.isfinite(wanted[:, 0]) & free)
        if not len(rows):
            return None
        heading = poses.heading[rows]
        start = np.stack((poses.x[rows], poses.y[rows], heading, motion.speed[rows]), axis=1)
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
        lost = np.flatnonzero(np.abs(along - motion.along[rows]) > LOST)
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
            tangent=motion.tangent[rows],
            speed=now[:, 3],
            slide=np.zeros(len(rows)),
            yaw_rate=(now[:, 2] - self.start[:, 2]) / seconds,
            acceleration=(now[:, 3] - self.start[:, 3]) / seconds,
        )
        for field in fields(Motion):
            column = getattr(motion, field.name).copy()
            column[rows] = getattr(there, field.name)
            setattr(motion, field.name, column)

    def poses(self, poses: Poses, steps: int, halted: Booleans) -> Poses:
        """Those of all agents, with those of who goes by a recording, and is not halted, exact."""
        free = np.flatnonzero(~halted[self.rows])
        rows, now = self.rows[free], self.at(steps)[free]
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
