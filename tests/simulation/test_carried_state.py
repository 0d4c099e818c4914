"""Agents go on in an edited scene: where they are, with all that conditions and controllers
remember."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Mirror
from roadlang.drive.controllers import python_controllers

STEP = 0.05
ROAD = """road main {{
  draw with waypoints {{ points: [{points}] }}, width: {width}m, lanes: {lanes}
}}
"""
STRAIGHT = "(0m, 0m), (100m, 0m), (200m, 0m)"


def text(agents: str, points: str = STRAIGHT, width: float = 7.0, lanes: int = 2) -> str:
    return ROAD.format(points=points, width=width, lanes=lanes) + agents


def mirror_of(source: str) -> Mirror:
    made = testing.sample(source)[0]
    return Mirror(made.record, python_controllers(made.record, made.registry), STEP)


def driven(mirror: Mirror, steps: int, speed: float = 8.0, y: float = -1.75) -> None:
    """The first agent goes east."""
    for step in range(steps + 1):
        pose = np.array([[10.0 + speed * STEP * step, y, 0.0, speed]])
        mirror.follow(pose, np.zeros(1), passed=step > 0)
        mirror.record()
        mirror.decide()


def continued(before: Mirror, source: str, restarted: frozenset[str] = frozenset()) -> Mirror:
    after = mirror_of(source)
    after.carry_on(before, restarted)
    return after


EGO = "agent ego is car on main at 10m { drive with stanley { speed: %s } }\n"


def test_time_and_place_go_on_along_the_new_line() -> None:
    before = mirror_of(text(EGO % "8m/s"))
    driven(before, 20)
    after = continued(before, text(EGO % "9m/s", "(-50m, 0m), (100m, 0m), (200m, 30m)"))
    assert after.time == pytest.approx(1.0)
    seen = after.seen("ego")
    assert (seen.x, seen.y, seen.speed) == pytest.approx((18.0, -1.75, 8.0), abs=1e-6)
    assert 60.0 < seen.station < 75.0, "the road begins elsewhere, the agent stays"


def test_who_is_restarted_begins_anew() -> None:
    before = mirror_of(text(EGO % "8m/s"))
    driven(before, 20)
    after = continued(before, text(EGO % "8m/s"), frozenset({"ego"}))
    assert after.seen("ego").x == pytest.approx(10.0, abs=1e-6)


def test_a_road_that_crosses_captures_nobody() -> None:
    """The line passes through the place of the agent twice."""
    loop = "(0m, 0m), (60m, 0m), (100m, 0m), (140m, 40m), (100m, 80m), (60m, 40m), (60m, -60m)"
    before = mirror_of(text(EGO % "8m/s", loop))
    driven(before, 120)
    at = before.seen("ego")
    assert at.x == pytest.approx(58.0)
    after = continued(before, text(EGO % "8m/s", loop.replace("(60m, -60m)", "(60m, -70m)")))
    assert after.seen("ego").station == pytest.approx(at.station, abs=0.5)


def test_a_condition_that_came_true_stays_true() -> None:
    agent = (
        "agent ego is car on main at 10m { drive with stanley { speed: %s }\n"
        "  drive with brake { deceleration: 5m/s^2, when: ego.x > 15m } }\n"
    )
    before = mirror_of(text(agent % "8m/s"))
    driven(before, 20)
    # Now it is before the place again.
    after = continued(before, text(agent % "9m/s"))
    after.follow(np.array([[12.0, -1.75, 0.0, 8.0]]), np.zeros(1), passed=True)
    assert float(after.decide().acceleration[0]) == pytest.approx(-5.0)


def test_a_change_of_lanes_goes_on_and_ends_in_the_lane_wherever_it_is_now() -> None:
    agent = (
        "agent ego is car on main at 10m { drive with stanley { speed: %s }\n"
        "  drive with change_lane { to: left, force: true, duration: 2s } }\n"
    )
    before = mirror_of(text(agent % "8m/s"))
    driven(before, 20)
    halfway = before.seen("ego").cross_track_error
    assert halfway < -0.5
    after = continued(before, text(agent % "9m/s", width=9.0))
    assert after.seen("ego").cross_track_error == pytest.approx(halfway, abs=0.05)
    for step in range(60):
        pose = np.array([[18.0 + 0.4 * step, -1.75, 0.0, 8.0]])
        after.follow(pose, np.zeros(1), passed=True)
        after.decide()
    assert after.seen("ego").cross_track_error == pytest.approx(-1.75 - 2.25, abs=0.01)


def test_agents_come_and_go_with_their_own_state() -> None:
    other = "agent late is car on main at 60m { drive with stanley { speed: 3m/s } }\n"
    before = mirror_of(text(EGO % "8m/s"))
    driven(before, 20)
    both = continued(before, text(other + EGO % "8m/s"))
    assert both.seen("late").x == pytest.approx(60.0, abs=1e-6)
    assert both.seen("ego").x == pytest.approx(18.0, abs=1e-6)
    alone = continued(both, text(EGO % "8m/s"))
    assert alone.seen("ego").x == pytest.approx(18.0, abs=1e-6)
    assert math.isclose(alone.time, 1.0)


def test_sensors_go_on() -> None:
    lidar = (
        "\n sense with ranges { every: 200ms, delay: 100ms } \n sense with imu { walk: 1m/s^2 } }"
    )
    source = text((EGO % "8m/s").replace(" }\n", lidar))
    before, alone = mirror_of(source), mirror_of(source)
    driven(before, 10)
    driven(alone, 11)
    after = continued(before, source)
    after.follow(np.array([[14.4, -1.75, 0.0, 8.0]]), np.zeros(1), passed=True)
    after.decide()
    for name in ("ranges", "imu"):
        reading, expected = (mirror.seen("ego").sensors[name] for mirror in (after, alone))
        assert reading.time == expected.time
        for array in expected:
            assert np.array_equal(reading[array], expected[array])
