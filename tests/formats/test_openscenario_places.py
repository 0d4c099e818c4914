"""Points of a scene as places on the roads of its OpenDRIVE file."""

from __future__ import annotations

import math

import pytest

from roadlang import testing
from roadlang_formats.opendrive.road_parts import road_parts
from roadlang_formats.openscenario.positions import Roads

MAIN = "road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] }, lanes: 1 }"


@pytest.mark.parametrize(
    ("heading", "road", "s", "offset"),
    [(0.0, 1, 30.0, 0.5), (1.5, 1, 30.0, 0.5), (math.pi, 2, 70.0, -0.5), (-2.0, 2, 70.0, -0.5)],
)
def test_who_drives_against_a_lane_for_both_directions_is_on_the_road_that_runs_its_way(
    heading: float, road: int, s: float, offset: float
) -> None:
    roads = Roads(road_parts(testing.sample(MAIN)[0].record, 0.05, "rule"))
    place = roads.place(30.0, 0.5, heading)
    assert (place.x, place.y, place.heading) == (30.0, 0.5, heading)
    assert place.lane is not None
    assert place.lane.road == road
    assert place.lane.s == pytest.approx(s)
    assert place.lane.offset == pytest.approx(offset)
    assert roads.place(30.0, 50.0, heading).lane is None
