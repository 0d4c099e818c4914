"""The lanes of roads: from counts, lists, pictures and files, in right- and left-hand traffic."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]

DRAW = "draw with waypoints { points: [(0m, 0m), (100m, 0m)] }\n"
AVENUE = """
  left: [drive(3.25m), bike, sidewalk(2m)]
  right: [drive(3m), drive(3.5m, speed_limit: 30km/h), parking(2.3m), sidewalk(2.5m)]
"""
PLAN = '''
image plan from """
  ............
  ............
  ############
  ............
  ............
""" { scale: 5m/px, legend: { "#": road } }
'''


def scene(sample: Sample, text: str) -> Scene:
    (found,) = sample(text).scenes
    return found


def road(sample: Sample, text: str, name: str = "main") -> SceneRoad:
    return next(road for road in scene(sample, text).roads if road.name == name)


def told(road: SceneRoad, *members: str) -> Any:
    return [tuple(getattr(lane, member) for member in members) for lane in road.lane_list]


def test_a_count_gives_equal_lanes_that_share_the_width(sample: Sample) -> None:
    main = road(sample, "road main { width: 9m, lanes: 3, " + DRAW + "}")
    assert told(main, "id", "kind", "direction", "width") == [
        (1, "drive", "backward", (3.0,)),
        (-1, "drive", "forward", (3.0,)),
        (-2, "drive", "forward", (3.0,)),
    ]
    assert main.width[0] == 9.0
    assert float(main.cross_section().offset(-1, 50.0)) == pytest.approx(0.0)


def test_lists_run_from_the_middle_outwards(sample: Sample) -> None:
    main = road(sample, "road main { speed_limit: 50km/h" + AVENUE + DRAW + "}")
    assert told(main, "id", "kind", "width", "direction", "marking") == [
        (3, "sidewalk", (2.0,), "both", "none"),
        (2, "bike", (1.5,), "backward", "curb"),
        (1, "drive", (3.25,), "backward", "solid"),
        (-1, "drive", (3.0,), "forward", "broken"),
        (-2, "drive", (3.5,), "forward", "solid"),
        (-3, "parking", (2.3,), "none", "curb"),
        (-4, "sidewalk", (2.5,), "both", "none"),
    ]
    assert main.lanes == 3
    assert main.width[0] == pytest.approx(9.75)
    limits = {lane.id: lane.speed_limit for lane in main.lane_list}
    assert limits[-1] == pytest.approx(50 / 3.6)
    assert limits[-2] == pytest.approx(30 / 3.6)
    assert limits[-4] is None
    assert main.speed_limit == pytest.approx(50 / 3.6)


def test_left_hand_traffic_reverses_directions_and_mirrors_counted_lanes(sample: Sample) -> None:
    left = "world { traffic: left }\n"
    listed = road(sample, left + "road main {" + AVENUE + DRAW + "}")
    assert [lane.direction for lane in listed.lane_list][1:5] == [
        "forward",
        "forward",
        "backward",
        "backward",
    ]
    counted = road(sample, left + "road main { lanes: 3, " + DRAW + "}")
    assert told(counted, "id", "direction") == [(2, "forward"), (1, "forward"), (-1, "backward")]
    oneway = road(sample, left + "road main { lanes: 2, oneway: true, " + DRAW + "}")
    assert told(oneway, "id", "direction") == [(2, "forward"), (1, "forward")]


@pytest.mark.parametrize(("lane", "facing"), [(1, "forward"), (-1, "back")])
def test_vehicles_face_the_direction_of_their_lane(sample: Sample, lane: int, facing: str) -> None:
    text = "world { traffic: left }\nroad main {" + DRAW + "}\n"
    (agent,) = scene(sample, text + f"agent ego is car on main at 5m {{ lane: {lane} }}").agents
    assert agent.facing == facing


def test_sidewalks_lie_on_either_side_of_counted_lanes(sample: Sample) -> None:
    main = road(sample, "road main { lanes: 2, sidewalks: 1.5m, width: 6m, " + DRAW + "}")
    assert told(main, "id", "kind", "width", "marking", "raised") == [
        (2, "sidewalk", (1.5,), "none", True),
        (1, "drive", (3.0,), "curb", False),
        (-1, "drive", (3.0,), "curb", False),
        (-2, "sidewalk", (1.5,), "none", True),
    ]


@pytest.mark.parametrize(
    ("lanes", "marking"), [("lanes: 2", "broken"), ("lanes: 4", "double"), ("lanes: 1", "curb")]
)
def test_a_curb_beside_the_reference_line_is_where_a_sidewalk_begins(
    sample: Sample, lanes: str, marking: str
) -> None:
    """With lanes to both sides the line between them is that of traffic."""
    main = road(sample, f"road main {{ {lanes}, oneway: {str(lanes == 'lanes: 1').lower()}, "
                f"sidewalks: 1.5m, width: 6m, {DRAW} }}")  # fmt: skip
    assert main.center_marking == marking


def test_a_thing_beside_the_road_stands_beyond_the_sidewalk(sample: Sample) -> None:
    text = "road main { sidewalks: 2m, width: 6m, " + DRAW + "}\n"
    found = scene(sample, text + "object post is box on main at 5m { side: left, offset: 1m }")
    (post,) = found.objects
    assert post.offset is not None
    assert post.offset - post.width / 2 == pytest.approx(3.0 + 2.0 + 1.0)


def test_lanes_are_inherited_and_replaced(sample: Sample) -> None:
    text = "road main {" + AVENUE + DRAW + "}\n"
    bent = "perturb with sine { amplitude: 1m, wavelength: 50m }"
    text += f"road bent from main {{ {bent} }}\nroad narrow from bent {{ lanes: 1, width: 4m }}"
    found = {road.name: road for road in scene(sample, text).roads}
    assert told(found["bent"], "id", "kind") == told(found["main"], "id", "kind")
    assert told(found["narrow"], "id", "kind", "direction") == [(-1, "drive", "both")]


def test_drawn_widths_are_recorded_and_change_the_width(sample: Sample) -> None:
    text = "road main { left: [drive(3m)], right: [drive(3m..3.5m)], " + DRAW + "}"
    scenes = sample(text, 4).scenes
    drawn = [scene.draws["main/right"] for scene in scenes]
    assert len(set(drawn)) == 4
    for scene, width in zip(scenes, drawn, strict=True):
        (main,) = scene.roads
        assert main.lane_list[1].width == pytest.approx((width,))
        assert main.width[0] == pytest.approx(3.0 + width)


def test_drawn_lanes_differ_between_scenes(sample: Sample) -> None:
    text = "road main { right: [drive(3m), choice(parking(2m), bike(1m))], " + DRAW + "}"
    kinds = {scene.roads[0].lane_list[-1].kind for scene in sample(text, 8).scenes}
    assert kinds == {"parking", "bike"}


def test_a_width_from_a_picture_stretches_the_drivable_lanes_only(sample: Sample) -> None:
    text = PLAN + "network town from plan { left: [drive, bike], right: [drive, sidewalk(2m)] }\n"
    text += "road main from town"
    found = scene(sample, text)
    for one in found.roads:
        lanes = {lane.kind: lane.width for lane in one.lane_list}
        assert lanes["sidewalk"] == (2.0,)
        assert lanes["bike"] == (1.5,)
        section = one.cross_section()
        s = one.length / 2
        assert float(section.drivable_width(s)) == pytest.approx(
            float(section.lane_width(1, s) + section.lane_width(-1, s))
        )
        assert one.width[0] == pytest.approx(float(section.drivable_width(0.0)))
    assert {road.name for road in found.roads} >= {"main", "town/1"}


def test_a_width_that_is_written_later_stretches_the_drivable_lanes(sample: Sample) -> None:
    text = "road main {" + AVENUE + DRAW + "}\nroad wide from main { width: 19.5m }"
    wide = road(sample, text, "wide")
    assert {lane.kind: lane.width[0] for lane in wide.lane_list if lane.id < 0} == pytest.approx(
        {"drive": 7.0, "parking": 2.3, "sidewalk": 2.5}
    )


def test_a_median_lies_between_the_directions(sample: Sample) -> None:
    lists = "left: [median(2m), drive(3m)], right: [drive(3m), drive(3m)], "
    main = road(sample, "road main {" + lists + DRAW + "}")
    assert main.width[0] == pytest.approx(11.0)
    assert main.center_marking == "curb"
    assert told(main, "id", "marking")[:2] == [(2, "solid"), (1, "curb")]


@pytest.mark.parametrize(
    ("lanes", "marking"), [("lanes: 2", "broken"), ("lanes: 4", "double"), ("lanes: 1", "solid")]
)
def test_the_line_between_the_directions(sample: Sample, lanes: str, marking: str) -> None:
    assert road(sample, f"road main {{ {lanes}, {DRAW} }}").center_marking == marking
    stated = f"road main {{ {lanes}, center_marking: none, {DRAW} }}"
    assert road(sample, stated).center_marking == "none"
