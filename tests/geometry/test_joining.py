"""Roads joined end to end: the curve goes on, lanes begin and end in tapers."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import (
    Arc,
    CrossSection,
    Curve,
    GeometryError,
    RoadToJoin,
    Straight,
    WidthProfile,
    chain,
    joined_curve,
    joined_section,
    parts_with_cut_tapers,
)

EAST = Curve.through([(0.0, 0.0), (100.0, 0.0)])
NORTH = Curve.through([(500.0, 500.0), (500.0, 560.0)])


def part(curve: Curve, lanes: int, width: float = 3.5, oneway: bool = True) -> RoadToJoin:
    section = CrossSection.of_lane_count(lanes, WidthProfile.constant(lanes * width), oneway=oneway)
    return RoadToJoin(curve, section)


def test_the_second_road_goes_on_where_the_first_ends() -> None:
    joined = joined_curve([EAST, NORTH])
    assert joined.length == pytest.approx(160.0)
    assert joined.at(160.0) == pytest.approx([160.0, 0.0])
    assert joined.heading(np.array([50.0, 130.0])) == pytest.approx([0.0, 0.0])


def test_the_first_road_stays_where_it_is() -> None:
    joined = joined_curve([NORTH, EAST])
    assert joined.at(0.0) == pytest.approx([500.0, 500.0])
    assert joined.at(joined.length) == pytest.approx([500.0, 660.0])


@given(
    st.lists(
        st.tuples(st.floats(20.0, 200.0), st.floats(-2.0, 2.0).filter(lambda a: abs(a) > 0.01)),
        min_size=2,
        max_size=4,
    )
)
def test_positions_and_headings_are_continuous(pieces: list[tuple[float, float]]) -> None:
    curves = [
        chain([Straight(10.0), Arc(radius, angle)], heading=3.0).curve() for radius, angle in pieces
    ]
    joined = joined_curve(curves)
    at = 0.0
    for curve in curves[:-1]:
        at += curve.length
        near = np.array([at - 1e-4, at + 1e-4])
        step = joined.at(near)
        assert math.dist(*step) < 3e-4
        assert np.ptp(joined.heading(near)) < 1e-3
    assert joined.length == pytest.approx(sum(curve.length for curve in curves), rel=1e-9)


def test_the_curvature_of_the_parts_is_kept() -> None:
    arc = chain([Arc(50.0, 1.0)]).curve()
    joined = joined_curve([EAST, arc])
    assert joined.curvature(np.array([60.0, 120.0])) == pytest.approx([0.0, 0.02], abs=1e-5)


def test_a_loop_cannot_be_joined() -> None:
    loop = Curve.through([(0.0, 0.0), (50.0, 0.0), (25.0, 40.0)], closed=True)
    with pytest.raises(GeometryError, match="closed"):
        joined_curve([EAST, loop])


def test_a_lane_that_ends_tapers_over_the_end_of_the_wider_road() -> None:
    section = joined_section([part(EAST, 3), part(NORTH, 2)], taper=30.0)
    assert section.ids == (-1, -2, -3)
    widths = section.lane_width(-3, np.array([0.0, 69.0, 85.0, 100.0, 130.0]))
    assert widths == pytest.approx([3.5, 3.5, 1.75, 0.0, 0.0], abs=1e-6)
    assert section.lane_width(-1, np.array([0.0, 90.0, 130.0])) == pytest.approx([3.5] * 3)


def test_a_lane_that_begins_tapers_over_the_start_of_the_wider_road() -> None:
    section = joined_section([part(EAST, 2), part(NORTH, 3)], taper=20.0)
    widths = section.lane_width(-3, np.array([50.0, 100.0, 110.0, 121.0]))
    assert widths == pytest.approx([0.0, 0.0, 1.75, 3.5], abs=1e-6)


def test_lanes_that_go_on_do_not_swerve() -> None:
    section = joined_section([part(EAST, 3), part(NORTH, 2), part(EAST, 4)], taper=30.0)
    s = np.linspace(0.0, 260.0, 131)
    for lane in (-1, -2):
        assert np.ptp(section.offset(lane, s)) < 1e-9


def test_a_taper_takes_at_most_half_of_a_road() -> None:
    parts = [part(EAST, 2), part(NORTH, 3), part(EAST, 2)]
    section = joined_section(parts, taper=500.0)
    assert section.lane_width(-3, 130.0) == pytest.approx(3.5)


@pytest.mark.parametrize("rounding", [-1e-12, -2e-14, 0.0, 2e-14, 1e-12])
def test_widths_that_change_a_rounding_beside_the_taper_are_no_fault(rounding: float) -> None:
    before, after = (
        part(Curve.through([(0.0, 0.0), (1000.0, 0.0)]), 1),
        part(Curve.through([(0.0, 0.0), (40.0, 0.0)]), 2),
    )
    lane = after.section.lanes[0]
    width = WidthProfile(np.array([0.0, 20.0 + rounding]), np.array([3.0, 3.5]))
    lanes = (replace(lane, width=width), *after.section.lanes[1:])
    joined = joined_section(
        [before, replace(after, section=replace(after.section, lanes=lanes))], 50.0
    )
    widest = max(joined.lanes, key=lambda lane: float(lane.width.at(1040.0)))
    assert widest.width.at(1040.0) == pytest.approx(3.5)


def test_lanes_of_the_same_kind_go_on_outside_of_one_that_ends() -> None:
    def section(*kinds: str) -> CrossSection:
        lanes = CrossSection.of_lane_count(1, WidthProfile.constant(3.0), oneway=True).lanes
        made = tuple(
            replace(lanes[0], id=-1 - place, kind=kind) for place, kind in enumerate(kinds)
        )
        return CrossSection(made)

    parts = [
        RoadToJoin(EAST, section("drive", "sidewalk")),
        RoadToJoin(NORTH, section("drive", "parking", "sidewalk")),
    ]
    joined = joined_section(parts, taper=10.0)
    assert [lane.kind for lane in joined.lanes] == ["drive", "parking", "sidewalk"]
    assert joined.lane_width(-2, 50.0) == 0.0
    assert joined.lane_width(-3, np.array([50.0, 150.0])) == pytest.approx([3.0, 3.0])


def test_the_reference_line_of_a_two_way_road_stays_in_the_middle() -> None:
    section = joined_section([part(EAST, 2, oneway=False), part(NORTH, 4, oneway=False)], 30.0)
    assert section.ids == (2, 1, -1, -2)
    assert section.border_offsets(np.array([10.0, 150.0]))[2] == pytest.approx([0.0, 0.0])


def test_tapers_are_cut_where_a_part_whose_lanes_taper_is_too_short() -> None:
    wide, narrow, short = part(EAST, 3), part(EAST, 2), part(NORTH, 2)
    assert parts_with_cut_tapers([wide, narrow], 51.0) == [0]
    assert parts_with_cut_tapers([narrow, wide], 51.0) == [1]
    assert parts_with_cut_tapers([wide, narrow], 50.0) == []
    assert parts_with_cut_tapers([wide, short], 50.0) == []  # nothing tapers in the short one
    assert parts_with_cut_tapers([part(EAST, 2, width=4.0), narrow], 60.0) == [0]
    assert parts_with_cut_tapers([narrow, short, narrow], 500.0) == []
