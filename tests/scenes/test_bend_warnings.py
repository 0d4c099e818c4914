"""RL619: who cannot stay in a lane because the road bends too much."""

from __future__ import annotations

import numpy as np
import pytest

import roadlang
from roadlang.scenes.bend_warnings import _aside

ROAD = """road main {
  draw with segments { pieces: [straight(40m), arc(%sm, 170deg), straight(40m)] }, lanes: 2
}
"""
CAR = "agent cars is %s on main at %s { drive with car_follow }\n"


def warned(text: str, count: int = 1) -> list[str]:
    found = roadlang.loads(text).sample(count).result.warnings
    return [item.code for item in found if item.code == "RL619"]


@pytest.mark.parametrize(
    ("radius", "kind", "at", "times"),
    [
        ("4", "bus", "10m", 1),
        ("4", "bicycle", "10m", 0),
        ("4", "car", "10m", 0),  # in the right lane the bend to the left is wider
        ("20", "bus", "10m", 0),
        ("4", "bus", "80m", 0),  # the bend is behind it
    ],
)
def test_who_is_too_long_for_a_bend_is_named(radius: str, kind: str, at: str, times: int) -> None:
    assert warned(ROAD % radius + CAR % (kind, at)) == times * ["RL619"]


def test_all_scenes_and_copies_give_one_warning() -> None:
    row = "{ count: 2, spacing: -14m..-13m, drive with car_follow }"
    assert warned(ROAD % "4" + f"agent cars is bus on main at 36m {row}\n", 3) == ["RL619"]


def test_who_stands_is_not_named() -> None:
    assert warned(ROAD % "4" + "agent cars is bus on main at 10m\n") == []


@pytest.mark.parametrize(("kind", "times"), [("car", 1), ("bicycle", 0)])
def test_the_bend_where_a_closed_road_ends_counts(kind: str, times: int) -> None:
    drop = """road main {
      draw with waypoints { points: [(0m, 0m), (26m, 7m), (36m, -2m), (26m, -7m)] }, closed: true
      lanes: 2, oneway: true
    }
    """
    assert warned(drop + CAR % (kind, "20m")) == times * ["RL619"]


@pytest.mark.parametrize(("radius", "times"), [("5", 1), ("9", 0)])
def test_who_has_no_route_cuts_no_bend(radius: str, times: int) -> None:
    """A truck needs 7.6 m; to the inside of a bend by 60 degrees it would have room enough."""
    bend = ROAD.replace("170deg", "-60deg").replace("lanes: 2", "lanes: 1") % radius
    assert warned(bend + CAR % ("truck", "10m")) == times * ["RL619"]


@pytest.mark.parametrize(
    ("radius", "length", "least", "cuts", "aside"),
    [
        (5.0, 12.0, 10.0, True, 5.0 * (1.0 / np.cos(0.5 * 12.0 / 5.0) - 1.0)),
        (5.0, 40.0, 10.0, True, 5.0 * (1.0 / np.cos(0.5 * 12.0 / 5.0) - 1.0)),
        (-5.0, 40.0, 10.0, True, 5.0 * (1.0 / np.cos(0.5 * 12.0 / 5.0) - 1.0)),
        (5.0, 40.0, 10.0, False, 5.0 * (1.0 - np.cos(12.0 / 5.0))),
        (5.0, 6.0, 10.0, False, 5.0 * (1.0 - np.cos(6.0 / 5.0))),
        (5.0, 3.0, 10.0, False, 5.0 * (1.0 - np.cos(3.0 / 5.0))),
        (4.0, 12.0, 10.0, False, 6.0 * (1.0 - np.cos(2.8))),
        (4.0, 12.0, 10.0, True, 6.0 * (1.0 / np.cos(1.4) - 1.0)),
        (9.9, 40.0, 10.0, False, 0.1 * (1.0 - np.cos(12.0 / 9.9))),
        (10.0, 40.0, 10.0, True, 0.0),
        (30.0, 40.0, 10.0, True, 0.0),
        (np.inf, 40.0, 10.0, False, 0.0),
    ],
)
def test_how_far_who_turns_less_sharply_leaves_an_arc(
    radius: float, length: float, least: float, cuts: bool, aside: float
) -> None:
    """Over 3, 6 and 12 m of it, where it is longest, and round 2.8 rad at most."""
    s = np.arange(0.0, length + 0.75, 0.5)
    heading = s / radius
    steps = np.sinc(0.25 / radius / np.pi) * 0.5 if np.isfinite(radius) else 0.5
    middle = heading[:-1] + 0.25 / radius
    x = np.concatenate([[0.0], np.cumsum(steps * np.cos(middle))])
    y = np.concatenate([[0.0], np.cumsum(steps * np.sin(middle))])
    found = _aside(np.stack([x, y, heading], axis=1), least, cuts)
    assert found == pytest.approx(aside, rel=0.02, abs=0.01)


def test_where_no_lane_is_nobody_leaves_it() -> None:
    assert _aside(np.zeros((0, 3)), 10.0, True) == 0.0
