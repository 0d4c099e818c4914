"""What a controller written in Python is shown of its agent and of the road ahead."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from roadlang.api import Observation, SceneRoad
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.line import line_of
from roadlang_godot.drive.followed_scene import FollowedScene
from roadlang_godot.net.telemetry import CONTACT, POSE, DriveState
from tests.godot.godot_scenes import bend, car, pieces, road, scene, straight

LANE = 1.75


def observed(
    main: SceneRoad, *, station: float, facing: str = "forward", turned: float = 0.0
) -> Observation:
    """A car in its right lane, 25 cm left of the middle and turned, as seen from it, wherever the
    engine's origin is."""
    lane = -1 if facing == "forward" else 1
    ego = car("ego", main, station, lane=lane, offset=lane * LANE, facing=facing)
    made = scene(main, agents=[ego])
    layout = layout_of(made)
    points, headings, _ = line_of(main).at(np.array([station]))
    away = lane * LANE + (0.25 if facing == "forward" else -0.25)
    along = float(headings[0])
    row = np.zeros(1, POSE)
    row["speed"] = 8.0
    row["heading"] = along + (0.0 if facing == "forward" else math.pi) + turned
    row["x"] = points[0, 0] - math.sin(along) * away - layout.frame.x
    row["y"] = points[0, 1] + math.cos(along) * away - layout.frame.y
    driver = FollowedScene(made, layout, 0.05, 60)
    driver.look(DriveState(0, row, np.zeros(0, CONTACT)))
    seen = driver.seen("ego")
    assert (seen.time, seen.step, seen.speed) == (0.0, 0.05, 8.0)
    assert seen.station == pytest.approx(station, abs=0.01)
    assert seen.cross_track_error == pytest.approx(0.25, abs=0.01)
    driver.look(DriveState(3, row, np.zeros(0, CONTACT)))
    assert driver.seen("ego").time == 0.05
    return seen


def test_the_line_ahead_is_the_middle_of_the_lane_and_goes_on_straight_at_the_end() -> None:
    seen = observed(road("main", pieces(straight(100.0))), station=20.0)
    assert seen.line_ahead(0.0) == pytest.approx((20.0, -LANE, 0.0, 0.0), abs=1e-3)
    assert seen.line_ahead(30.0) == pytest.approx((50.0, -LANE, 0.0, 0.0), abs=1e-3)
    assert seen.line_ahead(90.0) == pytest.approx((110.0, -LANE, 0.0, 0.0), abs=1e-3)


def test_who_drives_backward_along_the_road_sees_what_comes_before_its_station() -> None:
    seen = observed(road("main", pieces(straight(100.0))), station=20.0, facing="back")
    x, y, heading, _ = seen.line_ahead(15.0)
    assert (x, y) == pytest.approx((5.0, LANE), abs=1e-3)
    assert math.remainder(heading - math.pi, 2 * math.pi) == pytest.approx(0.0, abs=1e-3)
    assert seen.line_ahead(30.0)[:2] == pytest.approx((-10.0, LANE), abs=1e-3)


@pytest.mark.parametrize(("facing", "sign"), [("forward", 1.0), ("back", -1.0)])
def test_a_left_bend_is_a_right_bend_for_who_comes_the_other_way(facing: str, sign: float) -> None:
    main = road("main", pieces(straight(20.0), bend(40.0, 90.0)))
    seen = observed(main, station=45.0, facing=facing)
    assert seen.line_ahead(0.0)[3] == pytest.approx(sign / 40.0, rel=0.05)


@pytest.mark.parametrize("turned", [0.3, 0.3 + 2 * math.pi, 0.3 - 2 * math.pi])
def test_the_heading_error_is_the_shorter_way_round(turned: float) -> None:
    seen = observed(road("main", pieces(straight(100.0))), station=20.0, turned=turned)
    assert seen.heading_error == pytest.approx(0.3, abs=1e-5)


def test_a_loop_goes_on_where_it_began() -> None:
    angle = np.linspace(0, 2 * math.pi, 241)[:-1]
    ring = road("ring", 50.0 * np.column_stack([np.cos(angle), np.sin(angle)]), closed=True)
    seen = observed(replace(ring, heading=tuple(angle + math.pi / 2)), station=ring.length - 5.0)
    x, y, *_ = seen.line_ahead(5.0)
    assert (x, y) == pytest.approx((50.0 + LANE, 0.0), abs=0.1)
