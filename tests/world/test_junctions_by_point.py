"""A point says which junction: in `control with` and in `junction(near: ...)`."""

from __future__ import annotations

import pytest

from roadlang import testing

TOWN = '''
image plan from """
....#........#....
##################
....#........#....
""" { scale: 20m/px, legend: { "#": road } }
network town from plan {
  control with stop
  control with signals { near: [(POINT)] }
}
'''


def junctions(point: str) -> dict[int, str]:
    (scene,) = testing.sample(TOWN.replace("POINT", point), 1)
    (network,) = scene.record.networks
    return {junction.id: junction.control.kind for junction in network.junctions}


def test_the_junction_nearest_to_a_point_is_controlled() -> None:
    west, east = junctions("95m, 35m"), junctions("265m, 20m")
    assert sorted(west.values()) == ["signals", "stop"]
    assert sorted(east.values()) == ["signals", "stop"]
    assert west != east


def test_a_point_far_from_all_junctions_is_refused_with_their_places() -> None:
    with pytest.raises(Exception, match=r"near \(180m, 30m\)") as caught:
        junctions("180m, 30m")
    assert "(90m, 30m)" in str(caught.value)


@pytest.mark.parametrize(("point", "x"), [("100m, 30m", 90.0), ("260m, 30m", 270.0)])
def test_an_agent_is_placed_before_the_junction_near_a_point(point: str, x: float) -> None:
    agent = "agent ego is car on town at junction(near: (POINT)) { drive with traffic }"
    text = TOWN.replace("POINT", "95m, 35m") + agent.replace("POINT", point)
    (scene,) = testing.sample(text, 1)
    (ego,) = scene.record.agents
    assert abs(ego.x - x) < 20.0
