"""What is moved in the window is written back into the scene file, and nothing else changes."""

from __future__ import annotations

import pytest

from roadlang.syntax.scene_edits import (
    thing_moved,
    thing_moved_along,
    thing_removed,
    waypoint_inserted,
    waypoint_moved,
    waypoint_removed,
    waypoints_of,
)

TEXT = """# a street
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, -40m)] }, width: 8m }
object van is parked_van at (100m, 30m) { heading: 30deg }
object tree is tree on main at 20m  # an oak
object bench is bench on main at random { side: right, offset: 2m }
agent ego is car on main
"""


def test_a_thing_at_a_point_gets_its_new_place() -> None:
    expected = TEXT.replace("(100m, 30m)", "(101.5m, -2.25m)")
    assert thing_moved(TEXT, "van", (101.5, -2.25)) == expected


def test_places_far_from_the_origin_keep_their_centimeters() -> None:
    moved = thing_moved(TEXT, "van", (1234567.891, -0.001))
    assert moved == TEXT.replace("(100m, 30m)", "(1234567.89m, 0m)")


def test_a_thing_on_a_road_gets_its_new_position_along_it() -> None:
    assert thing_moved_along(TEXT, "tree", 33.333, 5.0) == TEXT.replace("at 20m", "at 33.33m")
    assert thing_moved_along(TEXT, "ego", 7.0, 0.0) == TEXT.replace("on main\n", "on main at 7m\n")


@pytest.mark.parametrize(("sideways", "offset"), [(-1.5, "3.5m"), (1.5, "0.5m"), (9.0, "0m")])
def test_an_offset_from_the_side_follows_the_hand(sideways: float, offset: str) -> None:
    expected = TEXT.replace("at random", "at 12m").replace("offset: 2m", f"offset: {offset}")
    assert thing_moved_along(TEXT, "bench", 12.0, sideways) == expected


def test_waypoints_are_moved_inserted_and_removed() -> None:
    assert waypoints_of(TEXT, "main") == [(0.0, 0.0), (80.0, 0.0), (160.0, -40.0)]
    moved = waypoint_moved(TEXT, "main", 2, (162.0, -37.0))
    assert moved == TEXT.replace("(160m, -40m)", "(162m, -37m)")
    for number, before, after in (
        (0, "[(0m", "[(1m, 2m), (0m"),
        (1, "(80m, 0m)", "(1m, 2m), (80m, 0m)"),
        (3, "-40m)]", "-40m), (1m, 2m)]"),
    ):
        inserted = waypoint_inserted(TEXT, "main", number, (1.0, 2.0))
        assert inserted == TEXT.replace(before, after)
    assert waypoint_removed(TEXT, "main", 0) == TEXT.replace("(0m, 0m), ", "")
    assert waypoint_removed(TEXT, "main", 2) == TEXT.replace(", (160m, -40m)", "")


def test_two_waypoints_are_the_fewest() -> None:
    two = TEXT.replace(", (160m, -40m)", "")
    assert waypoint_removed(two, "main", 0) is None


def test_a_thing_goes_with_its_line() -> None:
    gone = thing_removed(TEXT, "van")
    assert gone == TEXT.replace("object van is parked_van at (100m, 30m) { heading: 30deg }\n", "")


def test_a_comment_behind_what_goes_stays() -> None:
    gone = thing_removed(TEXT, "tree")
    assert gone == TEXT.replace("object tree is tree on main at 20m", "")


def test_what_cannot_be_written_stays() -> None:
    assert thing_moved(TEXT, "tree", (1.0, 2.0)) is None
    assert thing_moved(TEXT, "nobody", (1.0, 2.0)) is None
    assert thing_moved_along(TEXT, "van", 1.0, 2.0) is None
    assert waypoint_moved(TEXT, "van", 0, (0.0, 0.0)) is None
    assert waypoint_inserted(TEXT, "van", 0, (0.0, 0.0)) is None
    assert waypoints_of(TEXT.replace("(80m, 0m)", "(2 * 40m, 0m)"), "main") is None
