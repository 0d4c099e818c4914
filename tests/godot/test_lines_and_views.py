"""Lines of roads, cameras and words for the engine, by hand; no engine runs."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import click
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang.api import Scene
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.line import line_of, polyline
from roadlang_godot.commands.render_options import camera_pose, image_size
from roadlang_godot.net.messages import as_json, text_of
from roadlang_godot.rendering.overview_camera import FIELD, built_places, free_pose
from roadlang_godot.rendering.pictures import Shot, view_of
from tests.godot.godot_scenes import bends, car, pieces, road, scene, straight, thing


def test_a_polyline_has_the_headings_of_its_chords() -> None:
    """East 4 m, then north 3 m: between them the way from 2 m before to 1.5 m after the corner."""
    line = polyline("main", np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]]), 6.0)
    assert line.s.tolist() == [0, 4, 7]
    assert line.length == 7
    assert line.heading[[0, -1]] == pytest.approx([0, math.pi / 2])
    assert 0 < line.heading[1] < math.pi / 2
    assert line.width.tolist() == [6, 6, 6]


def test_a_closed_polyline_comes_back_with_one_heading() -> None:
    """Where a square of 10 m closes, half of its last and half of its first side count."""
    corners = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]])
    ring = polyline("ring", corners, 6.0, closed=True)
    assert ring.s.tolist() == [0, 10, 20, 30, 40]
    assert ring.points[-1].tolist() == [0, 0]
    assert ring.heading[0] == ring.heading[-1] == pytest.approx(-math.pi / 4)


def test_a_line_is_a_cubic_between_its_samples() -> None:
    """A quarter circle of 10 m radius with samples 10 degrees apart, left and right 3 m."""
    angle = np.radians(np.arange(0, 91, 10))
    points = 10 * np.column_stack([np.sin(angle), 1 - np.cos(angle)])
    made = replace(road("arc", points), heading=tuple(angle), stations=tuple(10 * angle))
    line = line_of(made)
    s = 10 * np.radians(np.array([5.0, 45.0, 85.0]))
    at, heading, _ = line.at(s)
    center = np.array([0.0, 10.0])
    assert np.hypot(*(at - center).T) == pytest.approx(np.full(3, 10.0), abs=1e-3)
    assert heading == pytest.approx(s / 10, abs=1e-3)
    left, right = line.beside(s, np.array([[3.0] * 3, [-3.0] * 3]))
    assert np.hypot(*(left - center).T) == pytest.approx(np.full(3, 7.0), abs=2e-3)
    assert np.hypot(*(right - center).T) == pytest.approx(np.full(3, 13.0), abs=2e-3)
    assert line.curvature[1:-1] == pytest.approx(np.full(8, 0.1), rel=1e-3)


def test_edges_of_a_line_are_those_of_its_drivable_lanes() -> None:
    main = road("main", pieces(straight(50)))
    left, right = line_of(main).edges(np.array([10.0]))
    half = main.width[0] / 2
    assert (left.ravel().tolist(), right.ravel().tolist()) == ([10, half], [10, -half])


def test_a_closed_road_goes_on_to_its_start() -> None:
    main = road("main", pieces(straight(50)))
    ring = line_of(replace(main, closed=True, length=120.0))
    assert (ring.s[-1], ring.points[-1].tolist()) == (120.0, ring.points[0].tolist())


COORDINATE = st.floats(-2000, 2000)


def straight_scene() -> Scene:
    main = road("main", pieces(straight(100), start=(200.0, 50.0)))
    return scene(main, agents=[car("ego", main, 5.0), car("other", main, 50.0)])


def test_a_top_view_shows_all_of_the_scene_with_a_margin() -> None:
    """A road of 100 m, 7 m wide: 5 m around."""
    layout = layout_of(straight_scene())
    assert view_of(layout, Shot("top", 1280, 720))["size"] == pytest.approx(100 * 720 / 1280 + 10)
    assert view_of(layout, Shot("top", 300, 3000))["size"] == pytest.approx(1000 + 2 * 0.03 * 1000)
    assert view_of(layout, Shot("top", 1280, 720, scale=0.5)) == {
        "camera": "top", "agent": min(layout.agents.values()), "x": 0.0, "y": 0.0, "size": 360.0
    }  # fmt: skip


def test_a_free_camera_stands_where_it_is_put() -> None:
    """From the middle of the scene at (250 m, 50 m); angles in radians."""
    layout = layout_of(straight_scene())
    view = view_of(layout, Shot("free", pose=(260.0, 40.0, 12.0, 90.0, -30.0), agent="other"))
    assert view == {
        "camera": "free", "agent": layout.agents["other"], "x": pytest.approx(10.0),
        "y": pytest.approx(-10.0), "z": 12.0, "yaw": pytest.approx(math.pi / 2),
        "pitch": pytest.approx(-math.pi / 6),
    }  # fmt: skip


@settings(max_examples=30)
@given(
    st.lists(st.tuples(COORDINATE, COORDINATE), min_size=1, max_size=8),
    st.sampled_from([0.5, 1.0, 16 / 9]),
)
def test_a_free_camera_sees_every_place_and_stands_no_farther_than_it_must(
    points: list[tuple[float, float]], aspect: float
) -> None:
    places = np.array(points)
    pose = free_pose(places, aspect)
    turn = np.array([math.cos(pose.yaw), math.sin(pose.yaw)])
    level = (places - (pose.x, pose.y)) @ turn
    ahead = math.cos(pose.pitch) * level - math.sin(pose.pitch) * pose.z
    up = -math.sin(pose.pitch) * level - math.cos(pose.pitch) * pose.z
    aside = (places - (pose.x, pose.y)) @ (turn[1], -turn[0])
    half = math.tan(FIELD / 2)
    assert (ahead > 0).all()
    shares = np.array([np.abs(aside) / (half * aspect), np.abs(up) / half]) / ahead
    assert shares.max() < 1.0
    assert pose.z == pytest.approx(12.0) or shares.max() > 0.7


def test_a_picture_shows_the_whole_of_large_objects_beside_roads() -> None:
    main = road("main", pieces(straight(100.0)))
    hall = replace(thing("building", 50.0, 30.0, length=60.0, width=10.0), heading=math.pi / 2)
    far = thing("tree", 50.0, 300.0)
    layout = layout_of(scene(main, objects=[hall, far]))
    places = built_places(layout.parts) + np.array([layout.frame.x, layout.frame.y])
    assert places.min(axis=0) == pytest.approx((0.0, -3.5), abs=0.6)
    assert places.max(axis=0) == pytest.approx((100.0, 60.0), abs=0.1)


def test_an_unknown_agent_is_not_followed() -> None:
    layout = layout_of(straight_scene())
    assert view_of(layout, Shot(agent="nobody"))["agent"] == min(layout.agents.values())
    empty = layout_of(scene(bends()))
    assert view_of(empty, Shot()) == {"camera": "chase"}


def test_a_camera_is_five_numbers_and_a_size_two() -> None:
    assert camera_pose("1,2,-3,90,0.5") == (1, 2, -3, 90, 0.5)
    assert image_size("1280x720", "") == (1280, 720)
    for text in ("1,2,3,4", "1,2,3,4,5,6", "1,2,3,4,x", ""):
        with pytest.raises(click.BadParameter, match="five numbers"):
            camera_pose(text)
    for text in ("1280", "1280x", "15x720", "1280x15", "8193x720", "720x8193", "-720x720"):
        with pytest.raises(click.BadParameter, match="is not a size"):
            image_size(text, "")
    assert image_size("16x16", "") == (16, 16)
    assert image_size(None, "8192x8192") == (8192, 8192)


def test_words_of_the_engine_are_read_and_ours_are_ascii() -> None:
    assert text_of(b'{"text": "no such node"}') == "no such node"
    assert text_of(b"{}") == "{}"
    assert text_of(b"\xff" + b"x" * 100) == "\ufffd" + "x" * 79
    assert as_json({"name": "\u00e9", "x": 1.5}) == b'{"name":"\\u00e9","x":1.5}'
    assert json.loads(as_json({"name": "\u00e9"})) == {"name": "\u00e9"}
