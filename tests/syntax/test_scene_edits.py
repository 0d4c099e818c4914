"""What is moved in the window is written back into the scene file, and nothing else changes."""

from __future__ import annotations

from roadlang.syntax.scene_edits import object_moved, waypoint_moved

TEXT = """# a street
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, -40m)] }, width: 8m }
object van is parked_van at (100m, 30m) { heading: 30deg }
object tree is tree on main at 20m
"""


def test_an_object_gets_its_new_place() -> None:
    assert object_moved(TEXT, "van", (101.5, -2.25)) == TEXT.replace(
        "(100m, 30m)", "(101.5m, -2.25m)"
    )


def test_the_nearest_waypoint_moves_as_the_hand_does() -> None:
    moved = waypoint_moved(TEXT, "main", (158.0, -38.0), (160.0, -35.0))
    assert moved == TEXT.replace("(160m, -40m)", "(162m, -37m)")


def test_what_is_not_placed_by_numbers_stays() -> None:
    assert object_moved(TEXT, "tree", (1.0, 2.0)) is None
    assert object_moved(TEXT, "nobody", (1.0, 2.0)) is None
    assert waypoint_moved(TEXT, "van", (0.0, 0.0), (1.0, 1.0)) is None
