"""What is kept of a drive, to tell failures apart and to count what a search has covered."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import ROAD_PLACES
from roadlang.falsification.descriptors import (
    CURVATURE,
    SPEED,
    STATION,
    descriptor,
    measures,
    moment_of,
    protagonist,
    road_of,
)
from roadlang.falsification.least_gap import least_gap
from roadlang.ir.trace import AgentTrace
from roadlang.plugins.discovery import load_registry
from roadlang_standard.separation import outlines

SCENE = testing.sample(
    """road main { draw with segments { pieces: [straight(40m), arc(50m, 90deg), straight(90m)] } }
road side { draw with waypoints { points: [(0m, 60m), (90m, 60m)] } }
agent far is car on side at 10m { drive with lane_follow { speed: 3m/s } }
agent ego is car on main at 10m { drive with lane_follow { speed: 9m/s } }
agent lead is truck on main at 45m { drive with lane_follow { speed: 2m/s } }
expect apart: always (gap(ego, lead) > 20m)
expect slow: always (far.speed < 1m/s)
"""
)[0]
DRIVE = SCENE.run(duration=4.0)


def test_coverage_is_of_the_nearest_other_and_the_agents_own_road() -> None:
    trace = DRIVE.trace
    ego, others = trace.agents["ego"], [trace.agents["lead"], trace.agents["far"]]
    gaps = [outlines(ego, other) for other in others]
    assert gaps[0].min() < gaps[1].min()
    found = measures(SCENE.record, trace, "ego")
    assert found["gap"] == pytest.approx(gaps[0].min())
    assert found["speed"] == pytest.approx(ego.speed.max())
    assert found["curvature"] == pytest.approx(1.0 / 50.0, rel=1e-6)
    assert measures(SCENE.record, trace, "far")["curvature"] == 0.0
    assert measures(SCENE.record, trace, "no one") == {
        "curvature": pytest.approx(1.0 / 50.0, rel=1e-6), "speed": None, "gap": None,
    }  # fmt: skip


def passing(name: str, x: Any, y: float, present: Any = 1.0) -> AgentTrace:
    zero: Any = np.zeros(len(x))
    rest: Any = (zero,) * 8
    columns: Any = {"present": zero + present}
    return AgentTrace(name, zero, x, zero + y, *rest, **columns)


def test_cars_that_pass_each_other_in_their_lanes_have_a_gap() -> None:
    """The circles around them overlap."""
    ego = passing("ego", np.linspace(0.0, 50.0, 40), 0.0)
    oncoming = passing("oncoming", np.linspace(50.0, 0.0, 40), 3.5)
    far = passing("far", np.linspace(0.0, 50.0, 40), 30.0)
    assert least_gap(ego, [far, oncoming]) == pytest.approx(1.7)
    assert least_gap(ego, [far]) == pytest.approx(28.2)
    assert least_gap(ego, [passing("hit", np.linspace(0.0, 50.0, 40), 1.0)]) == 0.0
    assert least_gap(ego, []) == math.inf


def test_there_is_no_gap_to_those_who_have_left() -> None:
    left = np.where(np.arange(40) < 20, 1.0, 0.0)
    lead = passing("lead", np.minimum(np.linspace(20.0, 70.0, 40), 50.0), 0.0, left)
    ego = passing("ego", np.linspace(0.0, 50.0, 40), 0.0)
    assert least_gap(ego, [lead]) == pytest.approx(15.5)
    gone = passing("gone", np.zeros(40), 0.0, 0.0)
    assert least_gap(ego, [gone]) == math.inf


def strolling(rng: np.random.Generator, times: int) -> AgentTrace:
    """An agent of any size that turns as it goes, comes late, leaves early, and is nowhere once."""
    x, y, heading = np.cumsum(rng.normal(0.0, (2.0, 2.0, 0.3), (times, 3)), axis=0).T
    x[rng.integers(times)] = math.nan
    zero: Any = np.zeros(times)
    rest: Any = (zero,) * 7
    come, leave = rng.integers(0, (times // 2, times // 2))
    there = (np.arange(times) >= come) & (np.arange(times) < times - leave)
    length, width = rng.uniform((1.0, 0.5), (12.0, 3.0))
    columns: Any = {"present": zero + there, "length": length, "width": width}
    place: Any = (x + rng.uniform(-40.0, 40.0), y + rng.uniform(-40.0, 40.0), heading)
    return AgentTrace("a", zero, *place, *rest, **columns)


def test_the_least_gap_is_that_of_all_outlines_at_all_times() -> None:
    """Though few of them are looked at."""
    rng = np.random.default_rng(4)
    for _ in range(60):
        ego, *others = (strolling(rng, 30) for _ in range(4))
        there = [(ego.present > 0.0) & (other.present > 0.0) for other in others]
        gaps = [outlines(ego, o)[at] for o, at in zip(others, there, strict=True)]
        assert least_gap(ego, others) == pytest.approx(np.nanmin(np.concatenate(gaps)))


def test_a_drive_is_described_by_its_road_and_its_deciding_moment() -> None:
    """In units of what counts as distinct."""
    verdict = DRIVE.verdicts["apart"]
    moment = moment_of(verdict, SCENE.record, DRIVE.trace, load_registry())
    assert moment is not None
    *road, speed, station, closing = descriptor(SCENE.record, DRIVE.trace, "ego", moment)
    main = road_of(SCENE.record, "ego")
    assert main is not None
    places = np.linspace(0.0, main.length, ROAD_PLACES)
    arc = (places > 41.0) & (places < 39.0 + 25.0 * math.pi)
    expected = np.array(road)[arc] * CURVATURE * math.sqrt(ROAD_PLACES)
    np.testing.assert_allclose(expected, 1.0 / 50.0, rtol=1e-4)
    assert np.abs(np.array(road)[places < 39.0]).max() == 0.0
    assert [speed * SPEED, station * STATION, closing * SPEED] == pytest.approx(
        [moment.speed, moment.station, moment.closing], abs=1e-4
    )
    *same, speed, station, closing = descriptor(SCENE.record, DRIVE.trace, "ego", None)
    assert (same, station, closing) == (road, 0.0, 0.0)
    assert speed * SPEED == pytest.approx(DRIVE.trace.agents["ego"].speed.mean(), abs=1e-4)


@pytest.mark.parametrize(
    ("names", "expected"), [(["apart"], "ego"), (["slow", "apart"], "far"), ([], "far")]
)
def test_a_drive_is_of_the_agent_that_its_expectation_names(
    names: list[str], expected: str
) -> None:
    assert protagonist(SCENE.record, names) == expected
