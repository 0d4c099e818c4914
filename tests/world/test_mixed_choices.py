"""`choice` of values of several sorts, where an option takes each of them alone."""

from __future__ import annotations

import pytest

from roadlang import testing
from roadlang.diagnostics.errors import DiagnosticError

ROAD = """
road main {
  draw with segments { pieces: [straight(200m)] }
  left: [sidewalk], right: [drive, drive, drive, parking], oneway: true
}
"""
TOWN = '''
image plan from """
...#...
#######
...#...
""" { scale: 25m/px, legend: { "#": road } }
network main from plan { lanes: 4 }
'''


@pytest.mark.parametrize(
    ("items", "lanes"),
    [
        ("-1, outer", {-1, -3}),
        ("outer, -1", {-1, -3}),
        ("-2, parking", {-2, -4}),
        ("-2, none, outer", {-2, -3, None}),
        ("-1, parking, outer", {-1, -4, -3}),
    ],
)
def test_lanes_by_number_and_by_word(items: str, lanes: set[int | None]) -> None:
    text = f"{ROAD}agent ego is car on main at 20m {{ lane: choice({items}) }}"
    assert {scene.record.agents[0].lane for scene in testing.sample(text, 40)} == lanes


def test_lanes_of_a_network() -> None:
    text = f"{TOWN}agent cars is car on main at random {{ count: 12, lane: choice(-1, outer) }}"
    (scene,) = testing.sample(text, 1)
    assert {agent.lane for agent in scene.record.agents} == {-1, -2, 2}


def test_times_of_day_by_hour_and_by_word() -> None:
    text = f"{ROAD}world {{ time_of_day: choice(night, 13h) }}"
    scenes = testing.sample(text, 20)
    assert {scene.record.world["time_of_day"] for scene in scenes} == {0.0, 13 * 3600.0}


@pytest.mark.parametrize(
    "line",
    [
        "agent ego is car on main at 20m { lane: choice(-1, 3m) }",
        "agent ego is choice(car, 3) on main at 20m {}",
        "world { time_of_day: choice(13h, 3m) }",
        "world { time_of_day: choice(night, 3m) }",
        "world { friction: choice(0.5, night) }",
    ],
)
def test_what_the_option_does_not_take_alone_stays_an_error(line: str) -> None:
    with pytest.raises(DiagnosticError):
        testing.sample(ROAD + line, 1)
