"""Where agents begin that say nothing about where across their road they are."""

from __future__ import annotations

import pytest

from roadlang.testing import sample

STREET = "road main { draw with segments { pieces: [straight(200m)] }, lanes: 2, sidewalks: 2m }\n"
BARE = STREET.replace(", sidewalks: 2m", "")
TOWN = """image plan from \"\"\"
###############
\"\"\" { scale: 25m/px, legend: { "#": road } }
network main from plan { lanes: 2, sidewalks: 2m }
"""


@pytest.mark.parametrize(
    ("road", "agent", "lane"),
    [
        (STREET, "pedestrian on main at 20m", -2),
        (STREET, "pedestrian on main at 20m { facing: back }", 2),
        ("world { traffic: left }\n" + STREET, "pedestrian on main at 20m", 2),
        (STREET, "pedestrian on main at 20m { offset: 0.5m }", -1),
        (STREET, "pedestrian on main at 20m { lane: 1 }", 1),
        (STREET, "animal on main at 20m", -1),
        (STREET, "car on main at 20m", -1),
        (BARE, "pedestrian on main at 20m", -1),
        (TOWN, "pedestrian on main at (100m, 15m)", 2),
        (TOWN, "pedestrian on main at (100m, 10m)", -2),
        (TOWN, "car on main at (100m, 10m)", -1),
    ],
)
def test_pedestrians_begin_on_the_sidewalk_where_there_is_one(
    road: str, agent: str, lane: int
) -> None:
    (scene,) = sample(f"{road}agent ego is {agent}")
    assert scene.record.agents[0].lane == lane


def test_each_copy_of_a_mixed_group_begins_where_its_kind_does() -> None:
    text = f"{STREET}agent all is choice(car, pedestrian) on main at random {{ count: 8 }}"
    (scene,) = sample(text)
    lanes = {(agent.kind, agent.lane) for agent in scene.record.agents}
    assert lanes == {("car", -1), ("pedestrian", -2)}


def test_a_car_and_a_pedestrian_beside_it_are_not_in_one_place() -> None:
    both = "agent ego is car on main at 20m\nagent walker is pedestrian on main at 20m\n"
    assert sample(STREET + both)
