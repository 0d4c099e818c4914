"""A controller that decides for one agent at a time decides as it does for many at once."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roadlang import testing
from roadlang.drive.controllers import python_controllers
from roadlang.ir.control import Control
from roadlang.ir.observation import Observation
from roadlang.ir.scene import Scene
from roadlang.plugins.discovery import load_registry
from roadlang.plugins.kinds import Controller
from roadlang.simulation.calling.decision import Decision
from roadlang.simulation.mirroring import Mirror

from .mirrored_scenes import Lines, random_pair

SIDE_BY_SIDE = """
road main {
  draw with segments { pieces: [straight(40m), arc(40m, 50deg), straight(90m)] }
  right: [drive(3.4m), drive(3.2m), sidewalk(2m)], left: [drive(3.4m)], speed_limit: 50km/h
}
agent pursuer is car on main at 10m { lane: -1, drive with pure_pursuit { speed: 9m/s } }
agent keeper is car on main at 12m { lane: -2, drive with stanley { lateral_acceleration: 2m/s^2 } }
agent first is van on main at 60m { lane: -1, drive with lane_follow { speed: 4m/s } }
agent second is car on main at 40m { lane: -1, drive with car_follow }
agent meets is truck on main at 130m { facing: back, drive with traffic { headway: 2s } }
agent changer is car on main at 70m { lane: -2, drive with car_follow, drive with change_lane { to: left } }
agent cutter is car on main at 30m { lane: -2, drive with car_follow, drive with cut_in { target: first } }
agent passer is car on main at 25m { lane: -1, drive with car_follow, drive with overtake { target: first } }
agent merger is car on main at 90m { lane: -2, drive with car_follow, drive with merge { to: left, within: 60m } }
agent walker is pedestrian on main at 50m { side: right, offset: 0.5m, drive with walk }
agent child is pedestrian on main at 100m { side: left, offset: 0.5m, drive with crossing }
agent stopper is car on main at 110m { lane: -1, drive with lane_follow, drive with stop_at { distance: 20m } }
agent slows is car on main at 100m { lane: -2, drive with stanley, drive with brake { speed: 2m/s } }
"""  # noqa: E501


class Alone(Controller):
    """Decides by what one agent sees."""

    def __init__(self, driver: Controller) -> None:
        self._driver = driver

    def control(self, observation: Observation) -> Control:
        return self._driver.control(observation)


def decisions(scene: Scene, mirror: Mirror, time: int, trace: object) -> Decision:
    agents = [trace.agents[actor.name] for actor in scene.agents]  # type: ignore[attr-defined]
    pose = [(one.x[time], one.y[time], one.heading[time], one.speed[time]) for one in agents]
    steering = np.array([one.steering[time] for one in agents])
    mirror.follow(np.array(pose), steering, passed=time > 0)
    return mirror.decide()


@pytest.mark.parametrize("text", [SIDE_BY_SIDE, 0, 6], ids=["road", "cross", "ring"])
def test_alone_as_among_others(text: str | int, tmp_path: Path) -> None:
    if isinstance(text, int):
        pair = random_pair(text)
        pair.write(tmp_path)
        text = pair.right
    (one,) = testing.sample(text, kinds=[Lines], folder=tmp_path, seed=1)
    scene, trace = one.record, one.run(duration=3.0, control_step=0.1).trace
    registry = load_registry()
    alone = {name: Alone(found) for name, found in python_controllers(scene, registry).items()}
    step = float(trace.time[1] - trace.time[0])
    together = Mirror(scene, python_controllers(scene, registry), step)
    apart = Mirror(scene, alone, step)
    # Who changes lanes moves its line, which is not up to a controller that decides alone.
    plain = [len(actor.drive) == 1 and actor.drive[0].when is None for actor in scene.agents]
    assert any(plain)
    for time in range(len(trace.time)):
        expected = decisions(scene, together, time, trace)
        found = decisions(scene, apart, time, trace)
        for name in ("steering", "acceleration"):
            here, there = getattr(found, name), getattr(expected, name)
            same = np.abs(here - there) < 1e-9
            assert (same | ~np.array(plain)).all(), (time, name)
            assert time or same.all(), name
