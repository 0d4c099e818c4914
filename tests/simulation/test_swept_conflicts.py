"""Where vehicles meet in junctions depends on the ground that they cover, not on lines alone."""

from __future__ import annotations

import math

import pytest

from roadlang.ir.scene_junctions import SceneConnection, SceneLaneEnd
from roadlang.simulation.traffic.swept_paths import SPACING, SweptPath, VehicleSize

CAR = VehicleSize(4.5, 1.8, 1.35, 0.61)
BUS = VehicleSize(12.0, 2.5, 3.0, 0.75)


def connection(
    start: tuple[float, float, float], pieces: tuple[tuple[float, float], ...]
) -> SceneConnection:
    """A connection with a lane of its own at each end."""
    ends = SceneLaneEnd("a", "end", -1), SceneLaneEnd("b", "start", -1)
    length = sum(piece[0] for piece in pieces)
    line = ((start[0], start[1] + 1.75), (start[0], start[1] - 1.75))
    return SceneConnection(1, *ends, "left", start, pieces, length, (3.5, 3.5), line)


LEFT = connection((0.0, 0.0, 0.0), ((0.5 * math.pi * 10.0, 1.0 / 10.0),))
"""A quarter of a circle of 10 m, from east to north."""
BESIDE = connection((0.0, -3.5, 0.0), ((0.5 * math.pi * 13.5, 1.0 / 13.5),))
"""The lane around it."""


def test_a_bus_that_turns_covers_ground_beside_its_lane_and_a_car_does_not() -> None:
    around = SweptPath.of(BESIDE, CAR)
    assert SweptPath.of(LEFT, CAR).meets(around) is None
    assert SweptPath.of(LEFT, BUS).meets(around) is not None


def test_both_of_a_pair_see_the_same_ground() -> None:
    first, second = SweptPath.of(LEFT, BUS), SweptPath.of(BESIDE, CAR)
    found, turned = first.meets(second), second.meets(first)
    assert found is not None
    assert turned is not None
    assert found == turned[::-1]


def test_where_lines_cross_a_car_comes_there_with_its_front_and_leaves_with_its_rear() -> None:
    across = connection((10.0, -20.0, 0.5 * math.pi), ((40.0, 0.0),))
    along = connection((0.0, 0.0, 0.0), ((25.0, 0.0),))
    found = SweptPath.of(along, CAR).meets(SweptPath.of(across, CAR))
    assert found is not None
    (enters, leaves), _ = found
    assert enters == pytest.approx(10.0 - 0.9, abs=3.0 * SPACING)
    assert leaves == pytest.approx(10.0 + 0.9, abs=3.0 * SPACING)


AROUND = ((8.0, 1.0 / 10.0), (16.0, -1.0 / 10.0), (16.0, -1.0 / 10.0), (20.0, 0.0))
"""To the left, and then to the right across the straight line."""


def test_ways_out_of_one_lane_that_part_may_cross_later() -> None:
    along, around = (
        SweptPath.of(connection((0.0, 0.0, 0.0), pieces), CAR)
        for pieces in (((60.0, 0.0),), AROUND)
    )
    found, turned = along.meets_again(around), around.meets_again(along)
    assert found is not None
    assert turned == found[::-1]
    (enters, leaves), (other_enters, _) = found
    assert 15.0 < enters < leaves < 35.0
    assert other_enters > 16.0
    everywhere = along.meets(around)
    assert everywhere is not None
    assert everywhere[0][0] < -5.0


def test_ways_out_of_one_lane_that_part_for_good_do_not_meet_again() -> None:
    along = SweptPath.of(connection((0.0, 0.0, 0.0), ((30.0, 0.0),)), CAR)
    away = SweptPath.of(connection((0.0, 0.0, 0.0), ((15.0, 1.0 / 10.0), (15.0, 0.0))), CAR)
    assert along.meets_again(away) is None
    assert along.meets_again(along) is None
