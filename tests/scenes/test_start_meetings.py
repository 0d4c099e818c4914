"""Long vehicles that come toward each other in narrow bends begin slowly."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from roadlang import testing
from roadlang.scenes.start_meetings import _most
from tests.backends.handmade_scenes import actor

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


ARC = "road pass { draw with segments { pieces: [arc(radius: 50m, angle: 150deg)] }, lanes: 2 }\n"
FIRST = {"length": 12.0, "width": 2.5, "start": 20.0, "offset": -1.75, "facing": "forward"}
LAST = {"length": 4.0, "width": 2.0, "start": 60.0, "offset": 1.75, "facing": "back"}
WAITS = math.sqrt(6.0 * (0.5 * (40.0 - 8.0) - 2.0))
"""m/s: from there each stops 2 m before the middle of the 32 m between them"""


@pytest.mark.parametrize(
    ("first", "last", "radius", "most"),
    [
        ({}, {}, 25, WAITS),
        ({"length": 4.0}, {"length": 12.0}, 25, WAITS),
        ({}, {"start": 31.0}, 25, math.sqrt(6.0 * max(0.0, 1.5 - 2.0))),
        ({}, {"start": 33.0}, 25, math.sqrt(6.0 * (0.5 * 5.0 - 2.0))),
        ({}, {"facing": "forward"}, 25, math.inf),  # one behind the other
        ({"facing": "back"}, {"facing": "back"}, 25, math.inf),
        ({"facing": "back"}, {"facing": "forward"}, 25, math.inf),  # away from each other
        ({"length": 7.0}, {}, 25, math.inf),  # both short
        ({"length": 7.0}, {"length": 7.0, "offset": 1.0}, 25, math.inf),
        ({"length": 7.1}, {"length": 6.9, "offset": 1.0}, 25, math.sqrt(6.0 * (0.5 * 33.0 - 2.0))),
        ({"offset": 0.0}, {"offset": 2.24}, 25, math.inf),  # in each other's way, in any bend
        ({"offset": 0.0}, {"offset": 2.25}, 25, WAITS),
        # 0.16 (12^2 + 4^2) / R + 0.3 m are needed beside 1.25 m
        ({}, {}, 26, WAITS),
        ({}, {}, 28, math.inf),
        ({}, {"start": 260.0}, 25, math.inf),  # too far ahead to matter
    ],
)
def test_how_fast_two_that_come_toward_each_other_begin_at_most(
    first: dict[str, Any], last: dict[str, Any], radius: float, most: float
) -> None:
    (scene,) = testing.sample(ARC.replace("50m", f"{radius}m"), 1)
    (road,) = scene.record.roads
    one = replace(actor("one", "bus", 0, 0), **{**FIRST, **first})
    other = replace(actor("other", "car", 0, 0), **{**LAST, **last})
    assert _most(one, other, road) == pytest.approx(most)
    assert _most(other, one, road) == pytest.approx(most)


@pytest.mark.parametrize(("bus", "truck"), [(30.0, 50.0), (147.0, 167.0), (167.0, 187.0)])
def test_on_a_closed_road_they_also_meet_across_its_start(bus: float, truck: float) -> None:
    length = 2.0 * math.pi * 25.0
    text = f"""
    road ring {{
      draw with segments {{ pieces: [arc(radius: 25m, angle: 360deg)] }}
      closed: true, lanes: 2, speed_limit: 50km/h
    }}
    agent bus is bus on ring at {bus % length}m {{ drive with traffic {{ aggression: 1 }} }}
    agent other is truck on ring at {truck % length}m {{ lane: 1, drive with traffic {{ aggression: 1 }} }}
    """  # noqa: E501
    (scene,) = testing.sample(text, 1)
    gap = 20.0 - 0.5 * (12.0 + 9.0)
    wanted = math.sqrt(6.0 * (0.5 * gap - 2.0))
    assert [agent.start_speed for agent in scene.record.agents] == pytest.approx(
        [wanted] * 2, abs=0.05
    )
