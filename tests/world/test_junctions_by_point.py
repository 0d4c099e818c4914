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


def test_roads_that_meet_name_their_junction() -> None:
    text = TOWN.replace("POINT", "95m, 35m")
    (scene,) = testing.sample(text, 1)
    for junction in scene.record.networks[0].junctions:
        roads = sorted(int(arm.road.rpartition("/")[2]) for arm in junction.arms)
        agent = f"agent ego is car on town at junction(roads: {roads[:3]}, road: {roads[0]})"
        (placed,) = testing.sample(text + agent, 1)
        assert placed.record.agents[0].road == f"town/{roads[0]}"
    with pytest.raises(Exception, match="do not meet"):
        testing.sample(text + "agent ego is car on town at junction(roads: [1, 99])", 1)


CROSSING = '''
image plan from """
....#....
#########
....#....
""" { scale: 20m/px, legend: { "#": road } }
network town from plan
'''


def test_the_only_junction_needs_no_id() -> None:
    (scene,) = testing.sample(CROSSING + "agent ego is car on town at junction()", 1)
    (named,) = testing.sample(CROSSING + "agent ego is car on town at junction(1)", 1)
    assert scene.record.agents == named.record.agents


def test_one_of_several_junctions_needs_to_be_named() -> None:
    text = TOWN.replace("POINT", "95m, 35m") + "agent ego is car on town at junction()"
    with pytest.raises(Exception, match="it needs `id`, `near` or `roads`"):
        testing.sample(text, 1)
