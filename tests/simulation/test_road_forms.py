"""Roads with the same lanes are recognized by their lanes, not by what made them."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from roadlang.ir.scene import SceneRoad
from roadlang.ir.scene_lane import SceneLane
from roadlang.simulation.building.starting import LineOffsets
from roadlang.simulation.lanes.road_forms import RoadForms
from roadlang.simulation.lines.lane_guides import LaneGuides
from roadlang.simulation.observing.lane_endings import has_lane_endings
from roadlang.simulation.vehicles.verges import Verges

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


def narrowing(road: SceneRoad) -> SceneRoad:
    """The road, whose lanes become narrower all along it."""
    width = tuple(np.linspace(4.0, 1.0, len(road.stations)).tolist())
    return replace(road, lane_list=tuple(replace(one, width=width) for one in road.lane_list))


def test_a_lane_that_narrows_lies_elsewhere_at_each_station(road: SceneRoad) -> None:
    (ego,) = records(STANLEY, 1)[0].agents
    at = [replace(ego, lane=-1, route=None, start=start) for start in (0.0, road.length)]
    offsets = LineOffsets()
    begin, end = (abs(offsets.of(one, narrowing(road), 8.0, -1)) for one in at)
    assert begin > end
    assert len({offsets.of(one, road, 8.0, -1) for one in at}) == 1


def test_only_lanes_that_narrow_have_guides_and_end(road: SceneRoad) -> None:
    narrow = narrowing(road)
    guides = LaneGuides.of([(road, False), (narrow, False), (road, True)])
    assert [bool(one) for one in guides.ids] == [False, True, False]
    assert has_lane_endings([narrow, road])
    assert has_lane_endings([road, narrow])
    assert not has_lane_endings([road, road])


def test_each_lane_has_its_own_edges(road: SceneRoad) -> None:
    lookup: Any = SimpleNamespace(forms=RoadForms(), known={})
    edges = [Verges._edges_or_section(lookup, road, lane) for lane in (1, -1, None, 1)]
    assert edges[0] == edges[3]
    assert len({str(one) for one in edges}) == 3
