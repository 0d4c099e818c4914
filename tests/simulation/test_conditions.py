"""`when:` and `while:` in the embedded engine: a drive signal means there what it means in an
`expect`, which is judged on the trace afterwards."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import AgentName, DriveSignal, Trace, option
from roadlang.geometry.arrays import Floats
from roadlang.plugins.discovery import load_registry
from roadlang.simulation.signals.conditions import ControllerCondition

from .driven_roads import drive

SCENE = """
road main {
  draw with segments { pieces: [straight(60m), arc(60m, 90deg), straight(200m)] }
  width: 8m
  lanes: 2
}
agent ego is car on main at 5m {
  start_speed: 12m/s
  drive with lane_follow { speed: 15m/s }
  drive with brake { speed: 1m/s, deceleration: 3m/s^2, when: CONDITION }
}
agent lead is car on main at 75m { drive with lane_follow { speed: 4m/s } }
agent others is car on main at 110m { count: 2, spacing: 20m, drive with lane_follow { speed: 6m/s } }
agent child is pedestrian on main at 20m { side: right, offset: 2m, drive with crossing { speed: 2m/s } }
object box is barrier on main at 120m { side: left, offset: 1m }
"""  # noqa: E501


@dataclass(frozen=True)
class FarthestSouth(DriveSignal):
    """How far south the agent has been: it depends on all that was before."""

    name: ClassVar[str] = "farthest_south"
    unit: ClassVar[str] = "m"
    agent: AgentName = option(help="the agent")

    def values(self) -> Floats:
        return np.asarray(np.maximum.accumulate(-self.agent.y))


@cache
def trace_with(condition: str) -> Trace:
    """A drive of the scene, in which the car brakes on this condition."""
    text = SCENE.replace("CONDITION", condition)
    scenes = testing.sample(text, 1, kinds=[FarthestSouth])
    (found,) = scenes.run("builtin", duration=10, control_step=0.1)
    return found.trace


def measured(trace: Trace, kind: Any, *names: str) -> Floats:
    """A drive signal of a trace."""
    if isinstance(kind, str):
        kind = load_registry().find("drive_signal", kind).load()
    agents = [trace.named(name) for name in names]
    found: Floats = kind(*(each[0] if kind.member else each for each in agents)).values_in(trace)
    return found


@pytest.mark.parametrize(
    ("condition", "kind", "names", "threshold"),
    [
        ("ego.speed > 13m/s", "speed", ["ego"], 13.0),
        ("ego.x > 40m", "x", ["ego"], 40.0),
        ("ego.heading > 0.3rad", "heading", ["ego"], 0.3),
        ("time > 2s", "time", [], 2.0),
        ("time_to_collision(ego, lead) < 3s", "time_to_collision", ["ego", "lead"], 3.0),
        ("gap(ego, others) < 70m", "gap", ["ego", "others"], 70.0),
        ("gap(ego, child) < 8m", "gap", ["ego", "child"], 8.0),
        ("distance(ego, box) < 60m", "distance", ["ego", "box"], 60.0),
        ("distance(others, lead) > 38m", "distance", ["others", "lead"], 38.0),
        (
            "post_encroachment_time(child, ego) < 6s", "post_encroachment_time",
            ["child", "ego"], 6.0,
        ),
        ("ego.farthest_south > -1m", FarthestSouth, ["ego"], -1.0),
    ],
)  # fmt: skip
def test_a_condition_takes_over_when_its_signal_crosses_the_threshold_in_the_trace(
    condition: str, kind: Any, names: list[str], threshold: float
) -> None:
    trace = trace_with(condition)
    values = measured(trace, kind, *names)
    holds = values > threshold if ">" in condition else values < threshold
    assert holds.any(), "this drive does not test the condition"
    first = int(np.argmax(holds))
    never = trace_with("time > 100s")
    apart = trace.agents["ego"].speed != never.agents["ego"].speed[: len(trace.time)]
    assert int(np.argmax(apart)) == first + 1 or (first == 0 and apart[1])


@pytest.mark.parametrize("name", ["yaw_rate", "lateral_acceleration"])
def test_a_rate_of_now_is_that_of_the_last_two_samples(name: str) -> None:
    never = trace_with("time > 100s")
    ego = never.agents["ego"]
    rate = np.diff(ego.heading) / np.diff(ego.time)
    rate = rate * ego.speed[1:] if name == "lateral_acceleration" else rate
    threshold = 0.8 * float(rate.max())
    unit = {"yaw_rate": "rad/s", "lateral_acceleration": "m/s^2"}[name]
    braked = trace_with(f"ego.{name} > {threshold:.9f}{unit}")
    apart = braked.agents["ego"].speed != never.agents["ego"].speed[: len(braked.time)]
    assert int(np.argmax(apart)) == int(np.argmax(rate > threshold)) + 2


def test_jerk_is_that_of_the_acceleration_that_the_engine_has() -> None:
    never, braked = (
        trace_with(condition).agents["ego"] for condition in ("time > 100s", "ego.jerk > 1m/s^3")
    )
    begins = int(np.argmax(np.diff(never.speed) > 1e-3))
    assert int(np.argmax(braked.speed != never.speed[: len(braked.time)])) == begins + 2


@pytest.mark.parametrize(
    "condition",
    [
        "once (post_encroachment_time(child, ego) < 6s) and gap(ego, others) < 60m",
        "ego.farthest_south > -1m and ego.yaw_rate > 0.1rad/s",
    ],
)
def test_scenes_of_one_block_measure_what_they_measure_alone(condition: str) -> None:
    """Where the agents that a condition names have other places in the list of each."""
    text = SCENE.replace("CONDITION", condition).replace("count: 2", "count: integer(1, 3)")
    world, road_, ego, rest = re.split(r"(?=\n(?:road|agent ego|agent lead))", text)
    text = world + road_ + rest + ego
    scenes = testing.sample(text, 3, kinds=[FarthestSouth])
    assert len({[agent.name for agent in scene.record.agents].index("ego") for scene in scenes}) > 1
    options = {"duration": 7.0, "control_step": 0.1}
    together = [one.trace.agents["ego"].speed for one in scenes.run("builtin", **options)]
    assert any(speed[-1] < 8.0 for speed in together), "it brakes"
    for scene, speed in list(zip(scenes, together, strict=True))[::2]:
        alone = scene.run("builtin", **options).trace.agents["ego"].speed
        np.testing.assert_array_equal(alone, speed)


def test_what_has_happened_is_still_known_when_other_scenes_are_over() -> None:
    text = """
    road main {
      draw with segments { pieces: [straight(choice(60m, 400m))] }, width: 8m, lanes: 2
    }
    agent ego is car on main at 5m {
      drive with lane_follow { speed: 15m/s }
      drive with brake { deceleration: 3m/s^2, when: ego.jerk < -3m/s^3 and ego.station > 150m }
    }"""
    for trace in drive(text, 6, duration=30):
        assert trace.agents["ego"].time[-1] < 30 or trace.agents["ego"].station[-1] > 150


@pytest.mark.parametrize(
    ("formula", "pointwise"),
    [
        ({">": ["x", 3.0]}, True),
        ({"and": [{">": ["x", 3.0]}, {"not": {"<": ["y", 1.0]}}]}, True),
        ({"once": {">": ["x", 3.0]}}, False),
        ({"not": {"and": [{">": ["x", 3.0]}, {"historically": {"<": ["y", 1.0]}}]}}, False),
    ],
)
def test_a_condition_needs_its_past_where_an_operator_looks_back(
    formula: dict[str, Any], pointwise: bool
) -> None:
    assert ControllerCondition(formula, {}, 1).is_pointwise is pointwise
