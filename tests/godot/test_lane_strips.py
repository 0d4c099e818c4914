"""Lanes as strips: which are drawn together, what lies between them, what is raised."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from roadlang.api import CURB_HEIGHT
from roadlang.geometry import CrossSection, WidthProfile
from roadlang.scenes.sampling import SamplingResult
from roadlang_godot.build.agent_specs import line_offset
from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.lane_strips import LaneStrip, StripLine, lane_strips
from roadlang_godot.build.line import line_of
from roadlang_godot.build.road_mesh import road_parts
from roadlang_godot.build.surface_table import surface_number
from roadlang_standard.lane_looks import LaneLook

Sample = Callable[..., SamplingResult]
DRAW = "draw with waypoints { points: [(0m, 0m), (90m, 0m)] }\n"


def strips(sample: Sample, options: str) -> list[LaneStrip]:
    (scene,) = sample("road main {" + options + "\n" + DRAW + "}").scenes
    return list(lane_strips(scene.roads[0].cross_section()))


@pytest.mark.parametrize("lanes", [1, 2, 3])
def test_equal_lanes_are_one_strip_between_edge_lines(lanes: int) -> None:
    section = CrossSection.of_lane_count(lanes, WidthProfile.constant(9.0))
    (strip,) = lane_strips(section)
    assert strip.lanes == lanes
    assert (strip.left, strip.right) == (StripLine.INSIDE_SOLID, StripLine.INSIDE_SOLID)


def test_a_double_line_parts_two_strips() -> None:
    left, right = lane_strips(CrossSection.of_lane_count(4, WidthProfile.constant(12.0)))
    assert left.right == right.left == StripLine.DOUBLE
    assert (left.lanes, right.lanes) == (2, 2)


def test_each_kind_of_lane_has_its_surface(sample: Sample) -> None:
    found = strips(sample, "left: [drive, bike, sidewalk], right: [drive, parking, grass]")
    assert [strip.surface for strip in found] == [
        LaneLook.SIDEWALK,
        LaneLook.BIKE,
        LaneLook.ROADWAY,
        LaneLook.PARKING,
        LaneLook.GRASS,
    ]
    assert [strip.raised for strip in found] == [True, False, False, False, False]
    assert all(one.last == other.first for one, other in pairwise(found))


def test_the_curb_lies_on_the_raised_side(sample: Sample) -> None:
    walk, bike, *_ = strips(sample, "left: [drive, bike, sidewalk], right: [drive]")
    assert walk.right == StripLine.CURB
    assert bike.left == StripLine.NONE


def test_strips_lie_side_by_side_and_raised_ones_above(sample: Sample) -> None:
    text = "road main { left: [drive(3m), sidewalk(2m)], right: [drive(3m)], " + DRAW + "}"
    (scene,) = sample(text).scenes
    walk, drive = road_parts(line_of(scene.roads[0]), 1, SceneOrigin())
    left = np.frombuffer(walk.content, "<f4").reshape(-1, 2, 3)
    right = np.frombuffer(drive.content, "<f4").reshape(-1, 2, 3)
    np.testing.assert_allclose(left[:, 1, [0, 2]], right[:, 0, [0, 2]], atol=1e-4)
    np.testing.assert_allclose(left[..., 1] - right[..., 1], CURB_HEIGHT, atol=1e-6)


def test_an_agent_in_left_hand_traffic_follows_the_middle_of_its_lane(sample: Sample) -> None:
    text = "world { traffic: left }\nroad main { left: [drive(3m)], right: [drive(4m)], " + DRAW
    (scene,) = sample(text + "}\nagent ego is car on main at 5m { lane: 1 }").scenes
    (ego,) = scene.agents
    assert ego.facing == "forward"
    assert line_offset(ego, line_of(scene.roads[0])) == pytest.approx(2.0)


def test_an_agent_from_beside_the_road_enters_the_lane_for_its_direction(sample: Sample) -> None:
    text = "road main { left: [drive(3m)], right: [drive(4m), drive(3m)], " + DRAW + "}\n"
    agents = "agent ego is car on main at 5m { side: right }\n"
    agents += "agent other is car on main at 25m { side: left, facing: back }\n"
    agents += "agent walker is pedestrian on main at 35m { side: right }\n"
    (scene,) = sample(text + agents).scenes
    line = line_of(scene.roads[0])
    offsets = {agent.name: line_offset(agent, line) for agent in scene.agents}
    section = scene.roads[0].cross_section()
    middles = {lane: float(section.offset(lane, 5.0)) for lane in (1, -2)}
    assert offsets == pytest.approx({"ego": middles[-2], "other": middles[1], "walker": 0.0})


def test_a_stretch_of_another_surface_is_a_piece_of_its_own_lane(sample: Sample) -> None:
    patches = "surface_patches: [{ surface: ice, over: [30m, 50m], side: right }]"
    (scene,) = sample("road main {lanes: 2, " + patches + "\n" + DRAW + "}").scenes
    parts = road_parts(line_of(scene.roads[0]), 1, SceneOrigin())
    assert [part.label for part in parts] == [
        "main from 0 m to 30 m",
        "main from 30 m to 50 m",
        "main from 30 m to 50 m",
        "main from 50 m to 90 m",
    ]
    numbers = [part.body[1] for part in parts]
    assert numbers == [0, 0, surface_number("ice") << 4, 0]
    # The line between the two lanes stays broken.
    assert (parts[1].body[3], parts[2].body[2]) == (StripLine.BROKEN, StripLine.BROKEN)
