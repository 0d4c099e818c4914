"""What controllers see: columns over agents of a world."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..geometry.arrays import Floats, Integers, wrapped
from ..ir.control import Observation, ObservationBatch
from .bend_speeds import BendSpeeds
from .leaders import leaders
from .poses import Poses, line_points
from .world import World


@dataclass
class View:
    """A world as it is at one time, seen by its agents. `bends` remembers what was computed."""

    world: World
    poses: Poses
    step: float
    bends: BendSpeeds
    _ahead: tuple[Floats, Floats] | None = field(default=None)

    def of(self, chosen: Integers) -> ObservationBatch:
        """What some agents see."""
        everyone = len(chosen) == len(self.world.present)
        rows: Any = slice(None) if everyone else chosen
        world, poses = self.world, self.poses
        motion = world.motion
        error = np.arctan2(motion.sine[rows], motion.cosine[rows])
        return ObservationBatch(
            time=np.full(len(chosen), world.time),
            step=self.step,
            agent=world.names[rows],
            x=poses.x[rows],
            y=poses.y[rows],
            heading=poses.heading[rows],
            speed=motion.speed[rows],
            steering=np.arctan(motion.tangent[rows]),
            cross_track_error=world.cross_track_error[rows],
            heading_error=error,
            station=world.station[rows],
            wheelbase=world.bodies.wheelbase[rows],
            road_offset=motion.offset[rows],
            road_width=np.where(world.has_road[rows], poses.road_width[rows], math.inf),
            line_ahead=lambda distance: self.line_ahead(rows, distance),
            speed_for_bends=lambda *limits: self.bends.at(world, rows, *limits),
            vehicle_ahead=lambda: self.vehicle_ahead(rows),
        )

    def line_ahead(
        self, rows: Any, distance: Floats | float
    ) -> tuple[Floats, Floats, Floats, Floats]:
        """(N,) x, y, heading and curvature of the lines to follow, a distance on."""
        world = self.world
        track = world.track.of_rows(rows)
        cell, rest = track.cell(track.wrapped(world.motion.along[rows] + distance))
        x, y = line_points(track, cell, rest)
        heading = track.lines.heading[cell] + track.lines.curvature[cell] * rest
        offset = world.line_offset[rows]
        x -= np.sin(heading) * offset
        y += np.cos(heading) * offset
        return x, y, heading, track.lines.seen_curvature[cell]

    def vehicle_ahead(self, rows: Any) -> tuple[Floats, Floats]:
        """(N,) gap to the next agent in the lane, and its speed along it."""
        if self._ahead is None:
            self._ahead = leaders(self.world, self.poses)
        return self._ahead[0][rows], self._ahead[1][rows]

    def single(self, agent: int, others: Mapping[str, Observation] | None = None) -> Observation:
        """What one agent sees, as controllers get it that decide for one."""
        rows = np.array([agent])
        seen = self.of(rows)

        def line_ahead(distance: float) -> tuple[float, float, float, float]:
            x, y, heading, curvature = self.line_ahead(rows, distance)
            return float(x[0]), float(y[0]), float(heading[0]), float(curvature[0])

        def vehicle_ahead() -> tuple[float, float]:
            gap, speed = self.vehicle_ahead(rows)
            return float(gap[0]), float(speed[0])

        numbers: dict[str, Any] = {
            name: float(getattr(seen, name)[0])
            for name in (
                "time", "x", "y", "heading", "speed", "steering", "cross_track_error",
                "station", "wheelbase", "road_offset", "road_width",
            )
        }  # fmt: skip
        return Observation(
            **numbers,
            step=self.step,
            agent=seen.agent[0],
            heading_error=float(wrapped(seen.heading_error)[0]),
            line_ahead=line_ahead,
            others=others or {},
            speed_for_bends=lambda *limits: float(self.bends.at(self.world, rows, *limits)[0]),
            vehicle_ahead=vehicle_ahead,
        )
