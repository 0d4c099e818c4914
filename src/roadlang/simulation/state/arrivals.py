"""Where agents have arrived: at the end of their road or route."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...geometry.arrays import Booleans
from ...ir.scene import Scene
from ...ir.scene_actor import SceneActor

ARRIVED = 0.5
"""Meters before the end of a line from which on an agent has arrived."""
END_BRAKING = 4.0
"""m/s^2, at the end of a road."""
AT_LINE = 0.5
"""Meters: a route that ends so close to a stop line ends there."""
BEFORE_LINE = 0.6
"""Meters before that stop line at which the front of the agent has arrived."""

Lane = tuple[str, int]


class Arrivals:
    """The ends of the lines of the agents of one scene."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._lines: Mapping[Lane, list[float]] | None = None

    def end(self, actor: SceneActor, length: float) -> float:
        """Where on its line of a length the middle of an agent is when it arrives, meters: at the
        end, or with its front before the stop line at which its route ends."""
        if actor.route is None:
            return length
        if self._lines is None:
            self._lines = _stop_lines(self._scene)
        last = actor.route.steps[-1]
        lines = self._lines.get((last.road, last.lane), ())
        if any(abs(last.stop - station) < AT_LINE for station in lines):
            return length - 0.5 * actor.length - BEFORE_LINE
        return length


def all_arrived(at_end: Booleans, has_road: Booleans, filled: Booleans, slots: int) -> Booleans:
    """(..., S) scenes of `slots` agents (..., N) each in which every one with a road is at its
    end; not those of agents without any road, which drive on."""
    there: Booleans = at_end | ~(has_road & filled)
    if slots == 1:
        return np.asarray(there & (has_road | ~filled))
    arrived = there.reshape(*there.shape[:-1], -1, slots).all(axis=-1)
    roadless = filled.reshape(-1, slots).any(axis=-1)
    roadless &= ~(has_road & filled).reshape(-1, slots).any(axis=-1)
    return np.asarray(arrived & ~roadless)


def _stop_lines(scene: Scene) -> dict[Lane, list[float]]:
    """The stations on their roads of the stop lines of lanes that lead into junctions."""
    roads = {road.name: road for road in scene.roads}
    found: dict[Lane, list[float]] = {}
    for network in scene.networks:
        for junction in network.junctions:
            for connection in junction.connections if junction.kind != "joint" else ():
                road = roads[connection.source.road]
                at_start = connection.source.end == "start"
                station = road.trim[0] if at_start else road.length - road.trim[1]
                found.setdefault((connection.source.road, connection.source.lane), []).append(
                    station
                )
    return found
