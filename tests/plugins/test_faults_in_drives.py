"""A plugin's fault in one scene leaves the drives of the others as they are alone."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

import roadlang
from roadlang.drive.controllers import python_controllers
from roadlang.ir.scene import Scene
from roadlang.plugins.discovery import load_registry
from roadlang_standard.simulate_builtin import Builtin
from tests.plugins.installed import install

FRAGILE = """
from dataclasses import dataclass
from typing import ClassVar
import numpy as np
from roadlang.api import AgentName, DriveSignal, hookimpl, option

@dataclass(frozen=True)
class Fragile(DriveSignal):
    \"\"\"The speed, of agents that are no faster than 20 m/s.\"\"\"

    name: ClassVar[str] = "fragile"
    unit: ClassVar[str] = "m/s"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self):
        if np.max(self.agent.speed) > 20:
            raise RuntimeError("too fast for me")
        return self.agent.speed

@hookimpl
def roadlang_kinds():
    return [Fragile]
"""
SCENE = """
param first = 1m/s..30m/s
road main { draw with waypoints { points: [(0m, 0m), (800m, 0m)] } width: 8m }
agent ego is car on main at 5m { start_speed: first, drive with lane_follow { speed: 12m/s } }
expect gentle: always (ego.fragile < 8m/s)
"""
PRESENT = """
road main { draw with waypoints { points: [(0m, 0m), (400m, 0m)] } width: 8m }
agent ego is car on main at 5m { start_speed: 1m/s, drive with lane_follow { speed: 10m/s } }
agent lead is car on main at 60m { count: integer(0, 1) }
expect far: always (distance(ego, lead) > 40m)
"""


def seconds(scenes: Sequence[Scene]) -> list[float]:
    """How long scenes are driven side by side; a second beyond their violations."""
    registry, simulator = (
        load_registry(),
        Builtin(after_violation=1.0, duration=20.0, control_step=0.1),
    )
    controllers = [python_controllers(scene, registry) for scene in scenes]
    return [float(trace.time[-1]) for trace in simulator.drive_all(scenes, controllers)]


def scenes_of(text: str, n: int) -> list[Scene]:
    return [scene.record for scene in roadlang.loads(text).sample(n=n, seed=3)]


def test_a_signal_that_fails_in_one_scene_lets_the_others_end_early(site: Path) -> None:
    install(site, "fragile", FRAGILE)
    scenes = scenes_of(SCENE, 5)
    together = seconds(scenes)
    assert together == [seconds([scene])[0] for scene in scenes]
    is_slow = [scene.values["first"] < 20.0 for scene in scenes]
    assert set(is_slow) == {True, False}
    assert [length < 15.0 for length in together] == is_slow


def test_a_search_shows_the_expectation_whose_signal_fails(site: Path) -> None:
    install(site, "fragile", FRAGILE)
    with pytest.raises(roadlang.DiagnosticError) as found:
        roadlang.loads(SCENE).falsify(searcher="random", evaluations=8, seed=3)
    assert "error[RL470]" in str(found.value)
    assert {fault.span and fault.span.line for fault in found.value.diagnostics} == {5}


def test_an_agent_that_one_scene_lacks_lets_the_others_end_early() -> None:
    scenes = scenes_of(PRESENT, 5)
    assert {len(scene.agents) for scene in scenes} == {1, 2}
    together = seconds(scenes)
    assert together == [seconds([scene])[0] for scene in scenes]
    assert [length < 15.0 for length in together] == [len(s.agents) == 2 for s in scenes]
