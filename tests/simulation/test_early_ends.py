"""Drives that end once all that is expected of them is violated."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import roadlang
from roadlang.ir.trace import Trace

SLIPPERY = """
param speed = 70km/h
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m), (240m, 40m), (340m, 0m)] }
  width: 8m
}
expect in_lane: always (abs(ego.cross_track_error) < 2m)
agent ego is car on main at 5m {
  drive with stanley { speed: speed, lateral_acceleration: 9m/s^2 }
}
world { friction: 0.45 }
simulate with builtin { control_step: 0.1s }
"""


@cache
def drive(text: str = SLIPPERY, **options: Any) -> Trace:
    return roadlang.loads(text).sample(seed=1)[0].run("builtin", **options).trace


def first_violation(trace: Trace, limit: float = 2.0) -> float:
    return float(trace.time[np.argmax(np.abs(trace.agents["ego"].cross_track_error) >= limit)])


def test_a_drive_ends_some_time_after_its_expectation_is_violated() -> None:
    full, short = drive(), drive(after_violation=2.0)
    assert first_violation(full) + 2.0 < full.time[-1] - 1.0
    assert short.time[-1] == first_violation(full) + 2.0


def test_what_is_recorded_until_then_is_the_same() -> None:
    full, short = drive(), drive(after_violation=2.0)
    count = len(short.time)
    assert np.array_equal(full.agents["ego"].x[:count], short.agents["ego"].x)


def test_a_drive_goes_on_while_another_expectation_may_still_hold() -> None:
    for other in (
        "expect arrives: eventually (ego.progress > 0.99)",
        "expect slow: always (ego.speed < 90km/h)",
        "expect late: always[70s, 80s] (ego.speed > 90km/h)",
    ):
        text = SLIPPERY + other
        assert drive(text, after_violation=2.0).time[-1] == drive(text).time[-1]


def test_a_drive_ends_after_the_last_of_several_violations() -> None:
    text = SLIPPERY + "expect near: always (abs(ego.cross_track_error) < 3m)"
    full = drive(text)
    assert first_violation(full, 3.0) > first_violation(full)
    assert drive(text, after_violation=1.0).time[-1] == first_violation(full, 3.0) + 1.0


def test_an_acceleration_is_known_only_with_the_next_sample() -> None:
    text = SLIPPERY.replace("abs(ego.cross_track_error) < 2m", "ego.acceleration < -50m/s^2")
    assert drive(text, after_violation=0.0).time[-1] == drive(text).time[-1]


def test_a_scene_alone_is_the_same_drive_as_in_a_batch() -> None:
    text = SLIPPERY.replace("70km/h", "40km/h..80km/h")
    scenes = roadlang.loads(text).sample(n=5, seed=2)
    together = scenes.run("builtin", after_violation=1.0)
    for scene, drive_of_many in zip(scenes, together, strict=True):
        alone = scene.run("builtin", after_violation=1.0)
        assert alone.to_csv() == drive_of_many.to_csv()
    assert len({one.trace.time[-1] for one in together}) == 5


def test_a_failure_is_driven_again_as_in_the_search() -> None:
    text = SLIPPERY.replace("70km/h", "40km/h..80km/h")
    found = roadlang.loads(text).falsify(evaluations=20, seed=1)
    for failure in found.failures:
        again = failure.scene.run()
        assert again.to_csv() == failure.drive.to_csv()
        assert again.verdicts["in_lane"].robustness == failure.robustness["in_lane"]
        assert again.trace.time[-1] <= first_violation(again.trace) + 2.0 + 1e-9


def test_where_agents_are_on_the_road_is_known_before_the_drive_is_over() -> None:
    """Lanes and what lies off the road are looked up while it is driven."""
    text = SLIPPERY.replace("width: 8m", "width: 8m, lanes: 2").replace(
        "expect in_lane: always (abs(ego.cross_track_error) < 2m)",
        "expect in_lane: always (abs(ego.lane_offset) < 1.5m)\n"
        "expect on_road: always (ego.off_road <= 0m)",
    )
    full = drive(text).agents["ego"]
    out = np.maximum.reduce(
        [np.argmax(np.abs(full.lane_offset) >= 1.5), np.argmax(full.off_road > 0.0)]
    )
    assert 0 < out < len(full.x) - 20
    short = drive(text, after_violation=1.0)
    assert short.time[-1] == drive(text).time[out] + 1.0
