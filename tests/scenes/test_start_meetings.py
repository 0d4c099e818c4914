"""Long vehicles that come toward each other in narrow bends begin slowly."""

from __future__ import annotations

import math

import pytest

from roadlang import testing

ROAD = """
road pass {{
  draw with segments {{ pieces: [arc(radius: {radius}m, angle: 150deg)] }}
  lanes: 2, speed_limit: 50km/h
}}
agent bus is bus on pass at 10m {{ {option}drive with traffic {{ aggression: 1 }} }}
agent other is {kind} on pass at {there}m {{ lane: 1, drive with traffic {{ aggression: 1 }} }}
"""


def speeds(there: float, kind: str = "truck", radius: float = 25, option: str = "") -> list[float]:
    text = ROAD.format(there=there, kind=kind, radius=radius, option=option)
    (scene,) = testing.sample(text, 1)
    return [float(agent.start_speed or 0.0) for agent in scene.record.agents]


def test_each_can_stop_before_the_middle_between_them() -> None:
    gap = 20.0 - 0.5 * (12.0 + 9.0)
    assert speeds(30.0) == pytest.approx([math.sqrt(6.0 * (0.5 * gap - 2.0))] * 2)


@pytest.mark.parametrize(("kind", "radius"), [("car", 60.0), ("truck", 200.0)])
def test_where_there_is_room_for_both_they_begin_as_ever(kind: str, radius: float) -> None:
    assert min(speeds(30.0, kind, radius)) > 8.0


def test_a_speed_that_is_written_stays() -> None:
    bus, truck = speeds(30.0, option="start_speed: 40km/h, ")
    assert bus == pytest.approx(40.0 / 3.6)
    assert truck < 6.0
