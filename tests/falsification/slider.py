"""A small simulator for tests: a car slides out of bends, the farther the faster it is."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from roadlang.api import AgentTrace, Controller, Length, Scene, Simulator, Trace, option
from roadlang.session.loading import LoadedScenario
from roadlang.testing import scenario

STEP = 0.1


@dataclass(frozen=True)
class Slider(Simulator):
    """Drives every agent along its road; it leaves its line in proportion to its lateral
    acceleration."""

    name: ClassVar[str] = "slider"
    softness: Length = option(0.25, help="offset for each m/s2")

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        roads = {road.name: road for road in scene.roads}
        speeds = {a.name: float(a.drive[-1].options["speed"]) for a in scene.agents}
        length = min(roads[agent.road or ""].length for agent in scene.agents)
        time = np.arange(0.0, length / max(speeds.values()), STEP)
        agents = {}
        for agent in scene.agents:
            road, speed = roads[agent.road or ""], speeds[agent.name]
            station = (agent.start or 0.0) + speed * time
            curvature = np.interp(station, road.stations, road.curvature)
            still = np.zeros(len(time))
            agents[agent.name] = AgentTrace(
                agent.name,
                time,
                np.interp(station, road.stations, road.x),
                np.interp(station, road.stations, road.y),
                np.interp(station, road.stations, road.heading),
                speed + still,
                still,
                still,
                station,
                -self.softness * curvature * speed**2,
                station / road.length,
                still,
                agent.length,
                agent.width,
            )
        return Trace(time, agents, "slider")


PERTURBED = "perturb with harmonics { modes: 6, amplitude: 30m }"
FEW: dict[str, Any] = {"evaluations": 120, "seed": 3}
TEXT = """
param limit = 1.4m
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m), (240m, 40m), (340m, 0m)] }
}
road bent from main { perturb with harmonics { modes: 6, amplitude: 30m } }
require gentle: always (abs(curvature(bent)) < 1 / 14m)
agent ego is car on bent at 5m { drive with pure_pursuit { speed: 8m/s..14m/s } }
expect in_lane: always (abs(ego.cross_track_error) < limit)
simulate with slider
"""
"""About 3 in 100 of the scenes fail."""


def numbers_in_journal(folder: Path) -> list[int]:
    """The numbers of the outcomes in the journal of a search, in the order of its lines."""
    lines = (folder / "journal.jsonl").read_text(encoding="utf-8").splitlines()
    rows = [json.loads(line) for line in lines]
    return [row["index"] for row in rows if "index" in row]


def slides(text: str = TEXT, **params: Any) -> LoadedScenario:
    return scenario(text, kinds=[Slider], **params)
