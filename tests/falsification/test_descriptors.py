"""What is kept of a drive, to tell failures apart and to count what a search has covered."""

from __future__ import annotations

import math

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
from roadlang.plugins.discovery import load_registry

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
    gaps = [
        np.hypot(ego.x - other.x, ego.y - other.y)
        - (math.hypot(ego.length, ego.width) + math.hypot(other.length, other.width)) / 2.0
        for other in others
    ]
    assert gaps[0].min() < gaps[1].min()
    found = measures(SCENE.record, trace, "ego")
    assert found["gap"] == pytest.approx(max(gaps[0].min(), 0.0))
    assert found["speed"] == pytest.approx(ego.speed.max())
    assert found["curvature"] == pytest.approx(1.0 / 50.0, rel=1e-6)
    assert measures(SCENE.record, trace, "far")["curvature"] == 0.0
    assert measures(SCENE.record, trace, "no one") == {
        "curvature": pytest.approx(1.0 / 50.0, rel=1e-6), "speed": None, "gap": None,
    }  # fmt: skip


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
