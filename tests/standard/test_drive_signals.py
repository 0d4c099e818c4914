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
     ("lateral_acceleration", "m/s^2"), ("jerk", "m/s^3"), ("yaw_rate", "rad/s")],
)  # fmt: skip
def test_a_signal_has_its_unit_and_the_column_of_its_name(name: str, unit: str) -> None:
    agent = circling(20.0, 10.0, grip=0.5)
    kind: Any = load_registry().find("drive_signal", name).load()
    assert kind.unit == unit
    if hasattr(agent, name):
        np.testing.assert_array_equal(signal(name, agent), getattr(agent, name))
