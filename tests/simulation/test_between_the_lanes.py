"""Who rides between two lanes is beside the rows that crawl there, and ahead of fast cars."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.trace import Trace

JAM = """
road main {
  draw with segments { pieces: [straight(600m)] }
  lanes: 2, oneway: true, speed_limit: 80km/h
}
agent slow is car on main at 200m { lane: -1, drive with lane_follow { speed: 3m/s } }
agent other is car on main at 203m { lane: -2, drive with lane_follow { speed: 3m/s } }
agent left is car on main at behind(slow, 4m) { count: 6, spacing: 9m, drive with KIND }
agent right is car on main at behind(other, 4m) { count: 6, spacing: 9m, lane: -2, drive with KIND }
agent rider is motorcycle on main at 110m {
  lane: none, offset: 0m, start_speed: 8m/s, drive with lane_follow { speed: 8m/s }
}
"""
FAST = """
road main {
  draw with segments { pieces: [straight(600m)] }
  lanes: 2, oneway: true, speed_limit: 80km/h
}
agent rider is motorcycle on main at 100m {
  lane: none, offset: 0m, start_speed: 8m/s, drive with lane_follow { speed: 8m/s }
}
agent car is car on main at 20m { lane: -2, drive with traffic }
"""


def least_speed(trace: Trace, after: float) -> float:
    rows = [a for name, a in trace.agents.items() if name.startswith(("left", "right"))]
    return min(float(agent.speed[agent.time > after].min()) for agent in rows)


@pytest.mark.parametrize("kind", ["traffic", "car_follow"])
def test_a_motorcycle_between_the_lanes_does_not_stop_a_jam(kind: str) -> None:
    (drive,) = testing.sample(JAM.replace("KIND", kind), 1).run(
        "builtin", duration=25.0, control_step=0.1
    )
    trace = drive.trace
    assert not trace.events
    rider, slow = trace.agents["rider"], trace.agents["slow"]
    assert rider.station[-1] > slow.station[-1] + 20.0
    assert least_speed(trace, 5.0) > 1.2  # all of them stood, and braked with 8 m/s^2
    assert rider.speed.min() > 7.5


@pytest.mark.godot
def test_it_does_not_in_godot_either() -> None:
    few = JAM.replace("KIND", "car_follow").replace("count: 6", "count: 3").replace("110m", "137m")
    (drive,) = testing.sample(few, 1).run("godot", duration=14.0)
    rider, slow = drive.trace.agents["rider"], drive.trace.agents["slow"]
    assert rider.station[-1] > slow.station[-1]
    assert least_speed(drive.trace, 5.0) > 1.2


def test_a_fast_car_does_not_squeeze_past_it() -> None:
    (drive,) = testing.sample(FAST, 1).run("builtin", duration=20.0)
    car, rider = drive.trace.agents["car"], drive.trace.agents["rider"]
    beside = np.abs(car.station - rider.station) < 3.0
    assert car.speed[beside].max(initial=0.0) < 12.0
