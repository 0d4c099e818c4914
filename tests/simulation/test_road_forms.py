"""Roads with the same lanes are told by their lanes, and not by who has made them."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roadlang.ir.scene import SceneRoad
from roadlang.ir.scene_lane import SceneLane
from roadlang.simulation.lanes.road_forms import RoadForms

from .test_numpy_tapes import STANLEY
from .test_same_bytes import records


@pytest.fixture(scope="module")
def road() -> SceneRoad:
    return records(STANLEY, 1)[0].roads[0]


def test_roads_with_equal_lanes_have_one_number(road: SceneRoad) -> None:
    forms = RoadForms()
    copied = replace(road, lane_list=tuple(replace(lane) for lane in road.lane_list))
    assert copied.lane_list[0] is not road.lane_list[0]
    assert {forms.number(one) for one in (road, copied, replace(road, x=road.y))} == {0}
    assert len(forms._equal) == 1


def test_roads_whose_lanes_lie_elsewhere_have_other_numbers(road: SceneRoad) -> None:
    forms = RoadForms()
    wider: tuple[SceneLane, ...] = tuple(replace(one, width=(5.0,)) for one in road.lane_list)
    others = (
        road,
        replace(road, lane_list=wider),
        replace(road, center_offset=(1.0,)),
        replace(road, center_marking="double"),
    )
    assert [forms.number(one) for one in others] == [0, 1, 2, 3]


def test_lanes_that_are_no_more_are_not_taken_for_new_ones(road: SceneRoad) -> None:
    """A new object may be where another was in memory, also where that one had lanes like those of
    a road that is still there."""
    forms = RoadForms()
    numbers = set()
    for meters in range(1, 40):
        copied = tuple([replace(one) for one in road.lane_list])
        assert forms.number(replace(road, lane_list=copied)) == 0
        del copied
        lanes = tuple([replace(one, width=(0.1 * meters,)) for one in road.lane_list])
        numbers.add(forms.number(replace(road, lane_list=lanes)))
    assert len(numbers) == 39
    assert 0 not in numbers


def test_a_road_that_lists_no_lanes_has_none(road: SceneRoad) -> None:
    assert RoadForms().number(replace(road, lane_list=())) is None
