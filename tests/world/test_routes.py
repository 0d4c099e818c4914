"""Agents in networks: where they begin, and the routes that they follow."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import roadlang
from roadlang.diagnostics import DiagnosticError
from roadlang.ir.encoding import scene_from_json, to_json
from roadlang.ir.scene import Scene, SceneActor
from roadlang.scenes.sampling import SamplingResult
from tests.route_geometry import faults_of, pose_at

Sample = Callable[..., SamplingResult]
TOWN = '''
image plan from """
....#.......#....
#################
....#.......#....
....#.......#....
#################
....#.......#....
""" {{ scale: {scale}m/px, legend: {{ "#": road }} }}
network town from plan {{ extract with pixels, {options} }}
'''
DRIVES = "drive with pure_pursuit { speed: 8m/s }"


def town(options: str = "lanes: 2", scale: int = 10) -> str:
    return TOWN.format(options=options, scale=scale)


def sampled(sample: Sample, text: str, **more: Any) -> Scene:
    (scene,) = sample(town() + text, **more).scenes
    return scene


def agent(scene: Scene, name: str = "ego") -> SceneActor:
    return next(item for item in scene.agents if item.name == name)


def steps_of(actor: SceneActor) -> list[str]:
    assert actor.route is not None
    return [step.road for step in actor.route.steps]


def test_a_route_leads_from_its_first_point_to_its_last(sample: Sample) -> None:
    scene = sampled(sample, "agent ego is car on town { route: [(10m, 45m), (85m, 15m)] }")
    ego = agent(scene)
    assert ego.route is not None
    assert not faults_of(scene, ego.route)
    assert math.hypot(ego.x - 10.0, ego.y - 45.0) < 3.0
    last = ego.route.steps[-1]
    end = pose_at(next(road for road in scene.roads if road.name == last.road), last, last.stop)
    assert math.hypot(end[0] - 85.0, end[1] - 15.0) < 3.0


def test_the_agent_stands_where_its_route_begins(sample: Sample) -> None:
    ego = agent(sampled(sample, "agent ego is car on town { route: [(10m, 45m), (85m, 15m)] }"))
    assert ego.route is not None
    first = ego.route.steps[0]
    assert (ego.road, ego.lane) == (first.road, first.lane)
    assert ego.start == pytest.approx(first.start)
    assert ego.facing == ("back" if first.start > first.stop else "forward")


def test_it_starts_where_at_says_and_passes_every_point(sample: Sample) -> None:
    text = "agent ego is car on town at (85m, 15m) { route: [(45m, 30m), (10m, 45m)] }"
    scene = sampled(sample, text)
    ego = agent(scene)
    assert ego.route is not None
    assert not faults_of(scene, ego.route)
    assert math.hypot(ego.x - 85.0, ego.y - 15.0) < 3.0


def test_a_first_point_just_behind_the_start_has_been_passed(sample: Sample) -> None:
    scene = sampled(sample, """
        agent lead is car on town { route: [(20m, 45m), (85m, 15m)] }
        agent ego is car on town at ahead_of(lead, 3m) { route: [(20m, 45m), (85m, 15m)] }
    """)  # fmt: skip
    lead, ego = scene.agents
    assert lead.route is not None
    assert ego.route is not None
    assert [step.road for step in ego.route.steps] == [step.road for step in lead.route.steps]


def test_an_agent_that_drives_in_a_network_has_a_random_route(sample: Sample) -> None:
    text = (
        f"agent ego is car on town at random {{ {DRIVES} }}\nagent still is car on town at random"
    )
    scene = sampled(sample, text)
    assert agent(scene).route is not None
    assert agent(scene, "still").route is None


def test_a_random_route_is_as_long_as_said(sample: Sample) -> None:
    scene = sampled(sample, "agent ego is car on town { route: random, route_length: 60m }", seed=3)
    ego = agent(scene)
    assert ego.route is not None
    assert not faults_of(scene, ego.route)
    driven = sum(abs(step.stop - step.start) for step in ego.route.steps)
    assert driven < 80.0


def test_every_copy_of_a_group_has_a_route_of_its_own(sample: Sample) -> None:
    scene = sampled(sample, f"agent ego is car on town at random {{ count: 6, {DRIVES} }}")
    assert len({tuple(steps_of(item)) for item in scene.agents}) > 3
    assert not [
        fault for item in scene.agents if item.route for fault in faults_of(scene, item.route)
    ]


def test_things_without_lane_stand_beside_the_roads_of_a_network(sample: Sample) -> None:
    text = "object trees is tree on town at random { count: 8, side: right, offset: 1m }"
    scene = sampled(sample, text)
    assert all(tree.road is not None and tree.lane is None for tree in scene.objects)
    assert len({tree.road for tree in scene.objects}) > 2


@settings(max_examples=5, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    lanes=st.sampled_from(
        ["lanes: 1", "lanes: 2", "lanes: 3", "lanes: 4", "lanes: 2, sidewalks: 2m"]
    ),
    seed=st.integers(0, 2**31),
    bent=st.booleans(),
    side=st.sampled_from(["right", "left"]),
    scale=st.integers(8, 16),
)
def test_every_step_begins_where_the_one_before_leads(
    sample: Sample, lanes: str, seed: int, bent: bool, side: str, scale: int
) -> None:
    bend = "network streets from town" + (
        " { perturb with sine { amplitude: 0.2m..0.8m, wavelength: 40m..80m } }" if bent else ""
    )
    text = (
        f"{town(lanes, scale)}{bend}\nworld {{ traffic: {side} }}\n"
        f"agent ego is car on streets at random {{ count: 4, {DRIVES} }}\n"
    )
    (scene,) = sample(text, seed=seed).scenes
    for item in scene.agents:
        assert item.route is not None
        assert not faults_of(scene, item.route)


def test_a_route_survives_the_file_of_the_scene(sample: Sample) -> None:
    scene = sampled(sample, f"agent ego is car on town at random {{ {DRIVES} }}")
    assert agent(scene_from_json(to_json(scene))).route == agent(scene).route


def test_routes_are_the_same_however_many_scenes_there_are(sample: Sample) -> None:
    text = town() + f"agent ego is car on town at random {{ count: 3, {DRIVES} }}"
    few, many = sample(text, n=2, seed=5).scenes, sample(text, n=6, seed=5).scenes
    assert [to_json(scene) for scene in few] == [to_json(scene) for scene in many[:2]]


def raised(sample: Sample, text: str, options: str = "lanes: 2") -> tuple[str, str, str]:
    with pytest.raises(DiagnosticError) as caught:
        sample(town(options) + text)
    found = caught.value.diagnostics[0]
    assert found.span is not None
    return found.code, found.message, " ".join(found.help)


def test_a_point_far_from_every_lane(sample: Sample) -> None:
    code, message, help_ = raised(
        sample, "agent ego is car on town { route: [(10m, 45m), (10m, 200m)] }"
    )
    assert code == "RL617"
    assert message.startswith("(10m, 200m) is 147m from")
    assert "15m" in help_
    assert "the roads of `town` lie between (5m, 5m) and (165m, 55m)" in help_
    _, message, _ = raised(sample, "agent ego is car on town at (10m, 20045m)")
    assert re.match(r"\(10m, 20045m\) is 199\d\dm from", message)


def test_no_way_against_one_way_roads(sample: Sample) -> None:
    code, message, help_ = raised(
        sample,
        "agent ego is car on town { route: [(125m, 45m), (10m, 45m)] }",
        "lanes: 2, oneway: true",
    )
    assert code == "RL618"
    assert "(10m, 45m)" in message
    assert "other direction" in help_


def test_no_way_from_where_another_has_put_it(sample: Sample) -> None:
    ego = "agent ego is car on town { route: [(10m, 45m), (125m, 45m)], drive with traffic }\n"
    code, message, _ = raised(
        sample,
        ego + "agent lead is car on town at ahead_of(ego, 8m) { route: [(10m, 45m)] }",
        "lanes: 2, oneway: true",
    )
    assert code == "RL618"
    assert "(10m, 45m)" in message
    assert "`lead`" in message


def test_the_point_that_no_way_leads_to_is_named_where_the_first_was_passed(sample: Sample) -> None:
    ego = "agent ego is car on town { route: [(10m, 45m), (125m, 45m)], drive with traffic }\n"
    code, message, _ = raised(
        sample,
        ego + "agent lead is car on town at ahead_of(ego, 8m) { route: [(14m, 45m), (10m, 45m)] }",
        "lanes: 2, oneway: true",
    )
    assert code == "RL618"
    assert "(10m, 45m)" in message


def test_who_is_placed_again_stands_where_a_way_leads_on(sample: Sample) -> None:
    ego = "agent ego is car on town at random { lane: outer }\n"
    lead = "agent lead is car on town at ahead_of(ego, 2m..60m) { route: [(125m, 45m)] }"
    for scene in sample(town("lanes: 2, oneway: true") + ego + lead, n=8, seed=2).scenes:
        assert next(agent for agent in scene.agents if agent.name == "lead").route is not None


def test_a_direction_from_which_no_way_leads(sample: Sample) -> None:
    code, _, help_ = raised(
        sample, "agent ego is car on town { route: [(10m, 45m), (125m, 45m)], facing: back }"
    )
    assert (code, help_) == ("RL618", "without `facing` there is one")


def test_a_lane_that_no_road_of_the_network_has(sample: Sample) -> None:
    code, message, _ = raised(sample, "agent ego is car on town at random { lane: -4 }")
    assert (code, message) == ("RL613", "`town` has no lane -4")


def test_a_network_that_is_all_junction_has_no_lanes(sample: Sample) -> None:
    text = town("left: [drive], right: [drive]", scale=1)
    with pytest.raises(DiagnosticError) as caught:
        sample(text + "agent ego is car on town at random")
    (found,) = caught.value.diagnostics
    assert found.message == "`town` has no lane for vehicles outside its junctions"
    assert "`scale`" in found.help[0]


def test_drawn_points_without_a_way_are_drawn_again(sample: Sample) -> None:
    """Half of the points lie far from the town: their candidates are rejected."""
    text = "agent ego is car on town { route: [(10m, 45m), (125m, 15m..200m)] }"
    result = sample(town() + text, n=4)
    assert len(result.scenes) == 4
    assert result.candidates > 4


def test_a_pedestrian_stands_on_the_sidewalk_at_a_junction(sample: Sample) -> None:
    walker = "agent ego is pedestrian on town at junction(1) { lane: sidewalk }\n"
    (scene,) = sample(town("lanes: 2, sidewalks: 2m", scale=20) + walker).scenes
    ego = agent(scene)
    assert ego.lane in (2, -2)


FORK = '''image plan from """
...#............
...#............
################
...#............
""" { scale: 20m/px, legend: { "#": road } }
network town from plan
param x = 10m..11m
agent ego is car on town { ROUTE }
'''


def test_where_no_lane_leads_on_one_meter_counts_as_lacking() -> None:
    """It is the best robustness that the table of requirements can show."""
    route = "route: [(x, 30m), (99m, 30m)], facing: back"
    with pytest.raises(roadlang.NoSceneError) as caught:
        roadlang.loads(FORK.replace("ROUTE", route)).sample(1)
    (row,) = caught.value.result.rejections
    assert (row.text, row.best) == ("`ego` begins on `town`", -1.0)
