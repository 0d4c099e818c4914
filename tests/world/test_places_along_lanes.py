"""Ahead, behind, in a row and at junctions: places in a network that follow the lanes."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from roadlang.diagnostics import DiagnosticError
from roadlang.ir.scene import Scene, SceneActor
from roadlang.scenes.sampling import SamplingResult
from tests.route_geometry import connection_of, faults_of
from tests.world.test_routes import DRIVES, agent, town

Sample = Callable[..., SamplingResult]
ROUND_THE_CORNER = f"agent ego is car on town {{ route: [(105m, 135m), (135m, 70m)], {DRIVES} }}\n"


def sampled(sample: Sample, text: str) -> Scene:
    """One scene in a town with streets 240 and 90 m long between junctions at x 135 and 375 m,
    y 135 and 45 m."""
    return sampled_with(sample, "lanes: 2", text)


def sampled_with(sample: Sample, options: str, text: str) -> Scene:
    (scene,) = sample(town(options, scale=30) + text).scenes
    return scene


def distance(one: SceneActor, other: SceneActor) -> float:
    return math.hypot(one.x - other.x, one.y - other.y)


def length_of(scene: Scene, actor: SceneActor, road: str) -> float:
    """Meters along the route of an agent to where it enters a road."""
    assert actor.route is not None
    driven = 0.0
    for step in actor.route.steps:
        if step.road == road:
            return driven
        driven += abs(step.stop - step.start)
        driven += connection_of(scene, step).length if step.turn is not None else 0.0
    raise AssertionError(f"the route does not lead through {road}")


def test_ahead_of_an_agent_is_round_the_corner_that_it_will_take(sample: Sample) -> None:
    scene = sampled(sample, ROUND_THE_CORNER + "agent lead is car at ahead_of(ego, 35m)")
    ego, lead = agent(scene), agent(scene, "lead")
    assert ego.route is not None
    assert lead.road in [step.road for step in ego.route.steps[1:]]
    step = next(step for step in ego.route.steps if step.road == lead.road)
    assert lead.start is not None
    along = length_of(scene, ego, step.road) + abs(lead.start - step.start)
    assert along - 4.5 == pytest.approx(35.0, abs=1e-3)
    assert lead.lane == step.lane


@pytest.mark.parametrize(
    ("options", "lane", "turned"),
    [
        ("lane: parking", -2, False),
        ("lane: parking, side: left", 2, True),
        ("lane: outer, side: left", 1, True),
        ("lane: drive, side: right", -1, False),
        ("lane: 1", 1, True),
        ("side: left", None, False),
    ],
)
def test_a_lane_on_a_side_is_that_of_the_road_of_the_other(
    sample: Sample, options: str, lane: int | None, turned: bool
) -> None:
    lanes = "left: [drive(3m), parking(2m)], right: [drive(3m), parking(2m)]"
    text = f"agent ego is car on town at (150m, 135m) {{ {DRIVES} }}\n"
    text += f"agent van is van at ahead_of(ego, 12m) {{ {options} }}\n"
    text += "agent row is van on town at random { lane: parking, side: left, count: 3 }\n"
    scene = sampled_with(sample, lanes, text)
    ego, van = agent(scene), agent(scene, "van")
    assert (van.road, van.lane) == (ego.road, lane)
    assert math.cos(van.heading - ego.heading) == pytest.approx(-1 if turned else 1, abs=0.02)
    assert distance(ego, van) > 12.0
    assert [agent(scene, f"row[{number}]").lane for number in range(3)] == [2, 2, 2]


def test_what_is_parked_at_random_stands_on_its_road_with_its_whole_length(sample: Sample) -> None:
    lanes = "left: [drive(3m), parking(2m)], right: [drive(3m), parking(2m)]"
    options = "lane: parking, count: 40, length: 6m, overlap: true"
    text = f"agent vans is van on town at random {{ {options} }}"
    scene = sampled_with(sample, lanes, text)
    roads = {road.name: road for road in scene.roads}
    for van in scene.agents:
        road = roads[str(van.road)]
        assert van.start is not None
        first, last = road.trim[0] + 3.0, road.stations[-1] - road.trim[1] - 3.0
        assert first - 1e-6 <= van.start <= last + 1e-6


def test_what_would_stand_in_a_junction_stands_beyond_it(sample: Sample) -> None:
    scene = sampled(sample, ROUND_THE_CORNER + "agent lead is car at ahead_of(ego, 10m)")
    lead = agent(scene, "lead")
    road = next(road for road in scene.roads if road.name == lead.road)
    assert lead.start is not None
    assert road.trim[0] + 2.25 <= lead.start + 1e-6
    assert lead.start - 1e-6 <= road.stations[-1] - road.trim[1] - 2.25


def test_behind_an_agent_is_before_the_junction_that_it_has_left(sample: Sample) -> None:
    text = (
        f"agent ego is car on town at (160m, 135m) {{ route: [(300m, 135m)], {DRIVES} }}\n"
        f"agent tail is car at behind(ego, 20m) {{ {DRIVES} }}"
    )
    scene = sampled(sample, text)
    ego, tail = agent(scene), agent(scene, "tail")
    assert tail.road != ego.road
    assert tail.route is not None
    assert not faults_of(scene, tail.route)
    assert [step.road for step in tail.route.steps][-1] == ego.road


def test_who_is_placed_by_another_takes_the_same_way(sample: Sample) -> None:
    scene = sampled(
        sample, ROUND_THE_CORNER + f"agent tail is car at behind(ego, 10m) {{ {DRIVES} }}"
    )
    ego, tail = agent(scene), agent(scene, "tail")
    assert ego.route is not None
    assert tail.route is not None
    assert tail.route.steps[-1] == ego.route.steps[-1]


def test_a_row_goes_on_round_the_corner(sample: Sample) -> None:
    text = (
        "agent row is car on town { route: [(105m, 135m), (135m, 70m)], "
        f"count: 4, spacing: 12m, {DRIVES} }}"
    )
    scene = sampled(sample, text)
    assert len({car.road for car in scene.agents}) > 1
    assert all(distance(*pair) > 6.0 for pair in pairwise(scene.agents))


@settings(max_examples=4, deadline=None, suppress_health_check=list(HealthCheck))
@given(seed=st.integers(0, 2**31), gap=st.floats(0.5, 40.0), scale=st.integers(8, 16))
def test_nothing_stands_in_a_junction(sample: Sample, seed: int, gap: float, scale: int) -> None:
    bend = "network streets from town { perturb with sine { amplitude: 0.5m, wavelength: 40m } }\n"
    text = (
        f"{town(scale=scale)}{bend}agent ego is car on streets at random {{ {DRIVES} }}\n"
        f"agent lead is car at ahead_of(ego, {gap:g}m)\n"
    )
    (scene,) = sample(text, seed=seed).scenes
    for car in scene.agents:
        road = next(road for road in scene.roads if road.name == car.road)
        assert car.start is not None
        room = road.stations[-1] - sum(road.trim)
        half = min(2.25, room / 2.0)
        assert road.trim[0] + half <= car.start + 1e-6
        assert car.start - 1e-6 <= road.stations[-1] - road.trim[1] - half


def test_at_a_junction_is_at_a_stop_line(sample: Sample) -> None:
    scene = sampled(sample, "agent ego is car on town at junction(1, before: 3m)")
    ego = agent(scene)
    (network,) = scene.networks
    junction = next(item for item in network.junctions if item.id == 1)
    lines = [
        connection.start
        for connection in junction.connections
        if (connection.source.road, connection.source.lane) == (ego.road, ego.lane)
    ]
    assert lines
    assert math.hypot(ego.x - lines[0][0], ego.y - lines[0][1]) == pytest.approx(3.0, abs=0.01)


def test_a_route_leads_through_the_junctions_that_it_names(sample: Sample) -> None:
    scene = sampled(
        sample, "agent ego is car on town { route: [(100m, 135m), junction(7), (100m, 45m)] }"
    )
    ego = agent(scene)
    assert ego.route is not None
    assert not faults_of(scene, ego.route)
    assert 7 in [step.turn.junction for step in ego.route.steps if step.turn is not None]


def test_a_junction_that_is_not_there(sample: Sample) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sampled(sample, "agent ego is car on town at junction(99)")
    (found,) = caught.value.diagnostics
    assert found.code == "RL472"
    assert found.message.startswith(
        "`position junction` asks for a road or place that cannot exist: "
    )
    assert "no lane leads to junction 99; the ids of the junctions are: 1," in found.message


def test_nobody_begins_too_fast_for_the_turn_ahead(sample: Sample) -> None:
    route = "route: [(105m, 135m), (135m, 70m)]"
    fast = "drive with pure_pursuit { speed: 30m/s }"
    turning = agent(sampled(sample, f"agent ego is car on town {{ {route}, {fast} }}"))
    assert turning.start_speed is not None
    assert turning.start_speed < 20.0


def test_traffic_begins_so_slowly_that_it_can_stop_before_the_next_junction(
    sample: Sample,
) -> None:
    """As behind who stands there; 100 m before it, the speed itself decides."""
    drives = "{ drive with traffic { speed: 20m/s } }"
    near, far = (
        agent(
            sampled(sample, f"agent ego is car on town at junction(7, before: {before}m) {drives}")
        )
        for before in (12, 100)
    )
    speed, to_line = near.start_speed or 0.0, 12.0 - 0.5 * 4.5 - 1.0
    assert 2.0 + speed + speed * speed / 5.6 == pytest.approx(1.2 * (to_line + 2.0))
    assert far.start_speed == 20.0
