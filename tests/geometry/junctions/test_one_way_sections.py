"""What becomes of a section when its road is made one-way."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roadlang.geometry.curves.width import WidthProfile
from roadlang.geometry.junctions.one_way import one_way
from roadlang.geometry.lanes.cross_section import CrossSection


@pytest.mark.parametrize("forward", [True, False])
def test_all_lanes_for_vehicles_run_one_way(forward: bool) -> None:
    found = one_way(CrossSection.of_lane_count(4, WidthProfile.constant(14.0)), forward)
    assert {lane.direction for lane in found.lanes} == {"forward" if forward else "backward"}
    assert [lane.id for lane in found.lanes] == [2, 1, -1, -2]


@pytest.mark.parametrize(
    ("before", "after"), [("double", "broken"), ("solid", "solid"), ("none", "none")]
)
def test_no_double_line_lies_between_lanes_that_run_the_same_way(before: str, after: str) -> None:
    section = CrossSection.of_lane_count(2, WidthProfile.constant(7.0))
    marked = replace(section, center_marking=before)  # type: ignore[arg-type]
    assert one_way(marked, True).center_marking == after


def test_a_section_that_is_one_way_keeps_its_direction() -> None:
    section = CrossSection.of_lane_count(2, WidthProfile.constant(7.0), oneway=True)
    assert one_way(section, False) is section
