"""Who yields: to the right, left turns to oncoming traffic, minor roads to major ones."""

from __future__ import annotations

import pytest

from roadlang.geometry.junctions.priority import minor_roads, yields
from roadlang.geometry.networks.junction_model import Junction
from tests.geometry.junctions.crossings_of_roads import only, plan_of, star


def connection(junction: Junction, source: int, target: int) -> int:
    (found,) = (
        c.id for c in junction.connections if (c.source.edge, c.target.edge) == (source, target)
    )
    return found


CROSSING = only(plan_of(star(0, 90, 180, 270)))
EAST, NORTH, WEST, SOUTH = 1, 2, 3, 4


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ((SOUTH, NORTH), (EAST, WEST)),  # from the right
        ((SOUTH, WEST), (NORTH, SOUTH)),  # a left turn and who comes toward it
        ((SOUTH, WEST), (EAST, WEST)),  # into one lane
    ],
)
def test_the_first_yields(first: tuple[int, int], second: tuple[int, int]) -> None:
    pair = connection(CROSSING, *first), connection(CROSSING, *second)
    assert pair in CROSSING.yields
    assert pair[::-1] not in CROSSING.yields


def test_who_goes_straight_on_yields_to_nobody_ahead() -> None:
    straight, right = connection(CROSSING, SOUTH, NORTH), connection(CROSSING, NORTH, WEST)
    assert (straight, right) not in CROSSING.yields


def test_a_minor_road_yields_to_a_major_one_from_either_side() -> None:
    minor = {NORTH, SOUTH}
    found = yields(CROSSING.connections, CROSSING.conflicts, minor)
    across = connection(CROSSING, SOUTH, NORTH)
    assert (across, connection(CROSSING, EAST, WEST)) in found
    assert (across, connection(CROSSING, WEST, EAST)) in found


def test_no_pair_yields_both_ways() -> None:
    assert len({frozenset(pair) for pair in CROSSING.yields}) == len(CROSSING.yields)


def test_the_road_that_goes_on_at_a_side_road_is_major() -> None:
    side = only(plan_of(star(0, 180, 90)))
    assert minor_roads(side) == (3,)


def test_equal_roads_that_cross_have_no_major_one() -> None:
    assert minor_roads(CROSSING) == ()


def test_the_wider_road_is_major() -> None:
    network = star(0, 90, 180, 270, width=[14.0, 7.0, 14.0, 7.0])
    wide = only(plan_of(network, [4, 2, 4, 2]))
    assert minor_roads(wide) == (2, 4)
