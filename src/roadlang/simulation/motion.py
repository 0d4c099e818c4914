"""The state of agents in motion, and its change over some time steps."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from .bodies import Bodies
from .lines import Lines
from .vehicle import accelerated, demand, displaced, forces, loads, steered, turned


@dataclass
class Motion:
    """Columns (N,) over agents, changed as time goes on. SI units and radians."""

    along: Floats
    """arc length of the foot point on the line"""
    offset: Floats
    """left of the line"""
    speed: Floats
    """along the body"""
    slide: Floats
    """speed to the left of the body"""
    yaw_rate: Floats
    cosine: Floats
    """of the heading from that of the line"""
    sine: Floats
    tangent: Floats
    """of the steering angle"""
    line_heading: Floats
    """at the foot point"""
    acceleration: Floats
    """along the body, in the last step"""

    def take(self, rows: Any) -> Motion:
        """That of some agents, in separate arrays."""
        return Motion(**{field.name: getattr(self, field.name)[rows] for field in fields(self)})

    def halt(self, rows: Any) -> None:
        """Some agents stand still, at once."""
        for column in (self.speed, self.slide, self.yaw_rate, self.acceleration):
            column[rows] = 0.0


@dataclass(frozen=True)
class Track:
    """The line of each agent: columns (N,) of `lines` that every step needs."""

    lines: Lines
    row: Any
    first: Any
    last: Floats
    origin: Floats
    spacing: Floats
    per_meter: Floats

    @classmethod
    def of(cls, lines: Lines, row: Any) -> Track:
        """`row`: (N,) the line of each agent."""
        spacing = lines.spacing[row]
        return cls(
            lines,
            row,
            row * lines.cells,
            lines.last[row].astype(np.float64),
            lines.origin[row],
            spacing,
            1.0 / spacing,
        )

    def of_rows(self, rows: Any) -> Track:
        """That of some agents."""
        return Track(
            self.lines, self.row[rows], self.first[rows], self.last[rows], self.origin[rows],
            self.spacing[rows], self.per_meter[rows],
        )  # fmt: skip

    def wrapped(self, along: Floats) -> Floats:
        """Arc lengths, on closed lines within one lap."""
        closed = self.lines.closed[self.row]
        if not closed.any():
            return along
        length = self.lines.length[self.row]
        return np.asarray(along - np.floor(along / length) * closed * length)

    def cell(self, along: Floats) -> tuple[Any, Floats]:
        """(N,) the cells at arc lengths, and the distance from where each begins."""
        gone = along - self.origin
        cell = np.minimum(np.maximum(gone * self.per_meter, 0.0), self.last).astype(np.int64)
        return self.first + cell, gone - cell * self.spacing


def advance(
    motion: Motion, car: Bodies, track: Track, wanted: tuple[Floats, Floats], steps: int, dt: float
) -> None:
    """Move on by some steps of `dt` seconds. `wanted`: tangent of the steering angle, held within
    what the agent can steer; acceleration."""
    headings, curvatures = track.lines.heading, track.lines.curvature
    tires = (car.half_base, car.friction, car.front_slope, car.rear_slope, car.slow)
    walks = car.walks if car.walks.any() else None
    m = motion
    cell, rest = track.cell(m.along)
    curvature = curvatures[cell]
    for _ in range(steps):
        m.tangent = steered(m.tangent, wanted[0], car.lag, car.rate)
        used = demand(wanted[1], m.speed, car.power, car.grip, dt)
        load = loads(m.acceleration, car.transfer)
        force = forces(m.speed, m.slide, m.yaw_rate, m.tangent, used, load, tires)
        speed, slide, yaw_rate, m.acceleration = accelerated(
            (m.speed, m.slide, m.yaw_rate), force, car.half_base, car.inertia,
            (car.drag, car.rolling), dt,
        )  # fmt: skip
        if walks is not None:
            on_foot = np.maximum(m.speed + wanted[1] * dt, 0.0)
            speed = np.where(walks, on_foot, speed)
            slide = np.where(walks, 0.0, slide)
            yaw_rate = np.where(walks, on_foot * m.tangent / (2.0 * car.half_base), yaw_rate)
        ds, dn = displaced(0.5 * (m.speed + speed), slide, m.cosine, m.sine, m.offset, curvature)
        m.speed, m.slide, m.yaw_rate = speed, slide, yaw_rate
        m.along = m.along + ds * dt
        m.offset = m.offset + dn * dt
        cell, rest = track.cell(m.along)
        curvature = curvatures[cell]
        heading = headings[cell] + curvature * rest
        angle = yaw_rate * dt - (heading - m.line_heading)
        m.cosine, m.sine = turned(m.cosine, m.sine, angle)
        m.line_heading = heading
