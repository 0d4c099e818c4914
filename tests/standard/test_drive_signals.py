"""Signals over the time of a drive, each against what the agent was made to do."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import AgentTrace
from roadlang.plugins.discovery import load_registry

TIME = np.linspace(0.0, 4.0, 401)
INSIDE = slice(2, -2)  # differences at the ends are one-sided


def circling(radius: float, speed: float, grip: float = 0.0) -> AgentTrace:
    """Someone who goes round a circle to the left, and gets faster by `grip` m/s^3 a second."""
    rate = speed / radius
    angle = rate * TIME
    return testing.agent_trace(
        time=TIME,
        x=radius * np.cos(angle),
        y=radius * np.sin(angle),
        heading=angle + math.pi / 2,
        speed=np.full(len(TIME), speed),
        acceleration=grip * TIME,
        cross_track_error=0.3,
        progress=TIME / 8,
        station=speed * TIME,
        steering=0.1,
        contacts=0,
        lane=-1,
        lane_offset=0.1,
        route_progress=speed * TIME,
        speed_limit=math.inf,
        off_road=-1.0,
        red_light=0,
        collision=0,
    )


def signal(name: str, agent: AgentTrace) -> Any:
    kind: Any = load_registry().find("drive_signal", name).load()
    return kind(agent=agent).values()


def test_who_circles_to_the_left_turns_at_speed_over_radius() -> None:
    np.testing.assert_allclose(signal("yaw_rate", circling(20.0, 10.0))[INSIDE], 0.5)


def test_the_lateral_acceleration_of_a_circle_is_the_square_of_the_speed_over_the_radius() -> None:
    np.testing.assert_allclose(signal("lateral_acceleration", circling(20.0, 10.0))[INSIDE], 5.0)


def test_jerk_is_the_change_of_the_acceleration_and_not_of_the_speed() -> None:
    np.testing.assert_allclose(signal("jerk", circling(20.0, 10.0, grip=1.5))[INSIDE], 1.5)


@pytest.mark.parametrize(
    ("name", "unit"),
    [("speed", "m/s"), ("acceleration", "m/s^2"), ("cross_track_error", "m"), ("progress", ""),
     ("station", "m"), ("steering", "rad"), ("heading", "rad"), ("contacts", ""),
     ("lane", ""), ("lane_offset", "m"), ("route_progress", "m"), ("speed_limit", "m/s"),
     ("off_road", "m"), ("red_light", ""), ("collision", "m/s"),
     ("lateral_acceleration", "m/s^2"), ("jerk", "m/s^3"), ("yaw_rate", "rad/s")],
)  # fmt: skip
def test_a_signal_has_its_unit_and_the_column_of_its_name(name: str, unit: str) -> None:
    agent = circling(20.0, 10.0, grip=0.5)
    kind: Any = load_registry().find("drive_signal", name).load()
    assert kind.unit == unit
    if hasattr(agent, name):
        np.testing.assert_array_equal(signal(name, agent), getattr(agent, name))


def headway(a: AgentTrace, b: AgentTrace) -> Any:
    kind: Any = load_registry().find("drive_signal", "time_headway").load()
    return kind(first=(a,), second=(b,)).values()


def on_straight(name: str, x: float, speed: float, **members: Any) -> AgentTrace:
    """Someone on a straight road to the east, in lane -1 of road 0, who begins at `x`."""
    usual: dict[str, Any] = {
        "time": TIME, "road": 0, "lane": -1, "x": x + speed * TIME, "y": 0.0, "heading": 0.0,
        "speed": speed, "station": x + speed * TIME,
    }  # fmt: skip
    return testing.agent_trace(name, **(usual | members))


def test_headway_is_the_distance_of_the_fronts_over_the_speed_of_the_one_behind() -> None:
    behind, ahead = on_straight("a", 0, 10.0), on_straight("b", 25, 10.0)
    np.testing.assert_allclose(headway(behind, ahead), 2.5)
    long = on_straight("c", 25, 10.0, length=12.5)
    np.testing.assert_allclose(headway(behind, long), 2.5 + (12.5 - 4.5) / 2 / 10)


@pytest.mark.parametrize(
    "other",
    [
        on_straight("behind", -20, 10.0),
        on_straight("beside", 20, 10.0, lane=1, y=3.5),
        on_straight("across", 20, 0.0, road=1, heading=math.pi / 2),
        on_straight("oncoming", 60, 1.0, road=2, heading=math.pi, y=1.0),
    ],
    ids=lambda agent: agent.name,
)
def test_headway_is_infinite_to_who_is_not_ahead_in_the_lane(other: AgentTrace) -> None:
    assert np.isinf(headway(on_straight("a", 0, 10.0), other)).all()


def test_who_stands_has_infinite_headway() -> None:
    assert np.isinf(headway(on_straight("a", 0, 0.0), on_straight("b", 25, 10.0))).all()


def test_around_a_hairpin_headway_is_along_the_road() -> None:
    """Who is ahead by arc length may be behind by heading."""
    angle = 10.0 / 20.0 * TIME

    def at(name: str, begin: float) -> AgentTrace:
        turned = begin / 20.0 + angle
        return testing.agent_trace(
            name, time=TIME, x=20 * np.sin(turned), y=-20 * np.cos(turned), heading=turned,
            speed=10.0, road=0, lane=-1, station=begin + 10.0 * TIME,
        )  # fmt: skip

    np.testing.assert_allclose(headway(at("a", 0.0), at("b", 45.0)), 4.5)
    assert np.isinf(headway(at("b", 45.0), at("a", 0.0))).all()


def test_across_a_junction_headway_is_that_of_the_arc() -> None:
    turning = testing.agent_trace(
        "b", time=TIME, x=20 * math.sin(1.0), y=20 - 20 * math.cos(1.0), heading=1.0, speed=5.0,
        road=-1, lane=-1, station=0.0,
    )  # fmt: skip
    behind = on_straight("a", 0, 10.0)
    assert headway(behind, turning)[0] == pytest.approx(2.0, rel=0.01)
