"""Lets controllers written in Python see the engine's agents, and passes on what they decide."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from roadlang.api import Observation

from .layout import Layout, line_offset
from .line import RoadSamples, line_of
from .telemetry import Records

if TYPE_CHECKING:
    from roadlang.api import Controller, Scene, SceneActor


class PythonDriver:
    """Turns records into observations. `step` is the time for which a decision holds."""

    def __init__(self, scene: Scene, layout: Layout, step: float) -> None:
        self._layout = layout
        self._step = step
        self._actors = {actor.name: actor for actor in scene.agents}
        self._lines = {road.name: line_of(road) for road in scene.roads}

    def controls(
        self, state: Records, time: float, controllers: Mapping[str, Controller]
    ) -> dict[tuple[int, int], tuple[float, float]]:
        """The decisions of all controllers, as the engine takes them."""
        seen = self.observations(state, time)
        out = {}
        for name, controller in controllers.items():
            decision = controller.control(replace(seen[name], others=seen))
            out[(0, self._layout.agents[name])] = (
                float(decision.steering),
                float(decision.acceleration),
            )
        return out

    def observations(self, state: Records, time: float) -> dict[str, Observation]:
        """The state of each agent, by name."""
        by_number = {int(row["agent"]): row for row in state}
        return {
            name: self._observation(self._actors[name], by_number[number], time)
            for name, number in self._layout.agents.items()
        }

    def _observation(self, actor: SceneActor, row: Any, time: float) -> Observation:
        line = self._lines.get(actor.road or "")
        station = float(row["station"])
        heading = float(row["heading"])
        ahead = _Ahead(actor, line, station, (float(row["x"]), float(row["y"]), heading))
        along = ahead(0.0)[2]
        return Observation(
            time=time,
            step=self._step,
            agent=actor.name,
            x=float(row["x"]) + self._layout.frame.x,
            y=float(row["y"]) + self._layout.frame.y,
            heading=heading,
            speed=float(row["speed"]),
            steering=float(row["steering"]),
            cross_track_error=float(row["cross_track_error"]),
            heading_error=math.remainder(heading - along, 2 * math.pi),
            station=station,
            wheelbase=float(actor.options.get("wheelbase", 0.6 * actor.length)),
            line_ahead=ahead,
            road_offset=float(row["cross_track_error"]) + ahead.offset,
            road_width=ahead.width,
        )


class _Ahead:
    """The line that an agent should follow, by distance ahead along its way."""

    def __init__(
        self,
        actor: SceneActor,
        line: RoadSamples | None,
        station: float,
        pose: tuple[float, float, float],
    ) -> None:
        self._line = line
        self._station = station
        self._pose = pose
        self._sign = -1.0 if actor.facing == "back" else 1.0
        self._offset = line_offset(actor, line) if line is not None else 0.0

    @property
    def offset(self) -> float:
        """Of the line to follow from the center line of the road, left along the way."""
        return self._sign * self._offset

    @property
    def width(self) -> float:
        """Of the road, meters; infinite without one."""
        if self._line is None:
            return math.inf
        return float(np.interp(self._station, self._line.s, self._line.width))

    def __call__(self, distance: float) -> tuple[float, float, float, float]:
        """x, y, heading and curvature; without a road, straight on."""
        if self._line is None:
            x, y, heading = self._pose
            return (
                x + distance * math.cos(heading), y + distance * math.sin(heading), heading, 0.0
            )  # fmt: skip
        line = self._line
        s = self._station + self._sign * distance
        first, last = float(line.s[0]), float(line.s[-1])
        at = first + (s - first) % line.length if line.closed else min(max(s, first), last)
        points, headings, _ = line.at(np.array([at]))
        heading = float(headings[0])
        over = 0.0 if line.closed else s - at
        x = float(points[0, 0]) - math.sin(heading) * self._offset + math.cos(heading) * over
        y = float(points[0, 1]) + math.cos(heading) * self._offset + math.sin(heading) * over
        curvature = self._sign * float(np.interp(at, line.s, line.curvature))
        return x, y, heading if self._sign > 0 else heading + math.pi, curvature
