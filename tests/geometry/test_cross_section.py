"""Cross-sections: where the lanes of a road lie."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import (
    CrossSection,
    Curve,
    Edge,
    GeometryError,
    Lane,
    Node,
    OffsetProfile,
    Road,
    RoadNetwork,
    WidthProfile,
)

LENGTH = 80.0
S = np.array([0.0, 13.0, 40.0, LENGTH])


def lane(id: int, kind: str, width: float, drivable: bool = False, **options: Any) -> Lane:
    direction: Any = "none" if not drivable else "forward" if id < 0 else "backward"
    return Lane(id, kind, WidthProfile.constant(width), direction, drivable, **options)


def avenue() -> CrossSection:
    return CrossSection(
        (
            lane(3, "sidewalk", 2.0),
            lane(2, "bike", 1.5, marking="curb"),
            lane(1, "drive", 3.0, True, marking="solid"),
            lane(-1, "drive", 3.25, True, marking="broken"),
            lane(-2, "bus", 3.5, True, marking="solid"),
            lane(-3, "parking", 2.3, marking="curb"),
            lane(-4, "sidewalk", 2.5),
        ),
        "double",
    )


@st.composite
def sections(draw: Any) -> CrossSection:
    left, right = draw(st.integers(0, 4)), draw(st.integers(0, 4))
    ids = (*range(left, 0, -1), *range(-1, -right - 1, -1)) or (-1,)
    meters = st.one_of(st.sampled_from([1e-3, 1.0, 3.25, 40.0]), st.floats(0.1, 20.0))
    lanes = []
    for id in ids:
        widths = draw(st.lists(meters, min_size=1, max_size=4))
        stations = np.linspace(0.0, LENGTH, len(widths))
        direction = draw(st.sampled_from(["forward", "backward", "both", "none"]))
        marking = draw(st.sampled_from(["solid", "broken", "double", "none", "curb"]))
        profile = WidthProfile(stations, np.array(widths))
        lanes.append(Lane(id, "drive", profile, direction, draw(st.booleans()), None, marking))
    offset = draw(st.none() | st.floats(-5.0, 5.0))
    center = (
        None if offset is None else OffsetProfile(np.array([0.0, 50.0]), np.array([0.0, offset]))
    )
    return CrossSection(tuple(lanes), draw(st.sampled_from(["solid", "double"])), center)


def same(a: CrossSection, b: CrossSection) -> None:
    assert a.ids == b.ids
    assert a.markings == b.markings
    for one, other in zip(a.lanes, b.lanes, strict=True):
        assert (one.kind, one.direction, one.drivable) == (
            other.kind,
            other.direction,
            other.drivable,
        )
    np.testing.assert_allclose(a.border_offsets(S), b.border_offsets(S), atol=1e-9)


@given(sections())
def test_lanes_lie_side_by_side(section: CrossSection) -> None:
    borders = section.border_offsets(S)
    widths = np.array([section.lane_width(id, S) for id in section.ids])
    np.testing.assert_allclose(-np.diff(borders, axis=0), widths, atol=1e-9)
    np.testing.assert_allclose(section.width(S), widths.sum(axis=0))
    assert len(section.markings) == len(borders)


@given(sections())
def test_the_middle_of_a_lane_lies_in_it(section: CrossSection) -> None:
    for id in section.ids:
        left, right = section.borders(id, S)
        middle = section.offset(id, S)
        assert ((right < middle) & (middle < left)).all()
        np.testing.assert_array_equal(section.lane_at(middle, S), id)
    left, right = section.half_widths(S)
    np.testing.assert_array_equal(section.lane_at([left + 0.1, -right - 0.1], S), 0)


@given(sections())
def test_without_an_offset_the_curve_is_in_the_middle_of_the_drivable_lanes(
    section: CrossSection,
) -> None:
    left, right = section.drivable_extent(S)
    if section.center_offset is None:
        np.testing.assert_allclose(left, -right, atol=1e-9)
    else:
        place = sum(id > 0 for id in section.ids)
        np.testing.assert_allclose(
            section.border_offsets(S)[place], section.center_offset.at(S), atol=1e-9
        )


@given(sections())
def test_two_reversals_and_two_mirrors_change_nothing(section: CrossSection) -> None:
    same(section.reversed(LENGTH).reversed(LENGTH), section)
    same(section.mirrored().mirrored(), section)
    same(section.mirrored().reversed(LENGTH), section.reversed(LENGTH).mirrored())


@given(sections())
def test_a_reversed_road_has_its_lanes_in_the_same_places(section: CrossSection) -> None:
    back = section.reversed(LENGTH)
    np.testing.assert_allclose(
        back.border_offsets(LENGTH - S), -section.border_offsets(S)[::-1], atol=1e-9
    )
    assert back.driving_ids("forward") == tuple(
        sorted((-i for i in section.driving_ids("backward")), key=lambda id: (abs(id), id))
    )


@given(sections())
def test_a_mirrored_road_has_its_lanes_on_the_other_side(section: CrossSection) -> None:
    other = section.mirrored()
    np.testing.assert_allclose(other.border_offsets(S), -section.border_offsets(S)[::-1], atol=1e-9)
    assert {-id for id in other.driving_ids("forward")} == set(section.driving_ids("forward"))


@given(sections(), st.floats(0.5, 3.0))
def test_only_drivable_lanes_stretch(section: CrossSection, factor: float) -> None:
    old = section.drivable_width(S)
    wanted = WidthProfile(S, old * factor + 100.0)
    wide = section.scaled_to(wanted)
    np.testing.assert_allclose(wide.drivable_width(S), wanted.at(S))
    if any(lane.drivable for lane in section.lanes):
        for lane, stretched in zip(section.lanes, wide.lanes, strict=True):
            if not lane.drivable:
                np.testing.assert_array_equal(stretched.width.at(S), lane.width.at(S))


def test_a_width_without_room_for_the_median_is_refused() -> None:
    boulevard = CrossSection(
        (lane(2, "drive", 3.0, True), lane(1, "median", 4.0), lane(-1, "drive", 3.0, True))
    )
    assert float(boulevard.drivable_width(0.0)) == 10.0
    with pytest.raises(GeometryError, match="wider than the road"):
        boulevard.scaled_to(WidthProfile.constant(4.0))


@pytest.mark.parametrize("count", [1, 2, 3, 4, 7])
def test_equal_lanes_share_the_width(count: int) -> None:
    width = WidthProfile(np.array([0.0, LENGTH]), np.array([6.0, 12.0]))
    section = CrossSection.of_lane_count(count, width)
    np.testing.assert_allclose(section.drivable_width(S), width.at(S))
    for id in section.ids:
        np.testing.assert_allclose(section.lane_width(id, S), width.at(S) / count)
    assert len(section.driving_ids("backward")) == (1 if count == 1 else count // 2)
    oneway = CrossSection.of_lane_count(count, width, oneway=True)
    assert oneway.ids == tuple(range(-1, -count - 1, -1))
    assert oneway.driving_ids("backward") == ()
    np.testing.assert_allclose(oneway.border_offsets(S), section.border_offsets(S), atol=1e-12)


def test_lanes_by_direction_begin_at_the_middle() -> None:
    assert avenue().driving_ids() == (-1, 1, -2)
    assert avenue().driving_ids("forward") == (-1, -2)
    assert avenue().driving_ids("backward") == (1,)
    assert avenue().reversed(LENGTH).driving_ids("forward") == (-1,)


def test_markings_are_those_toward_the_outer_neighbor() -> None:
    markings = ("none", "curb", "solid", "double", "broken", "solid", "curb", "none")
    assert avenue().markings == markings


def test_the_extent_of_an_avenue() -> None:
    left, right = avenue().drivable_extent(10.0)
    assert (float(left), float(right)) == pytest.approx((4.875, -4.875))
    left, right = avenue().half_widths(10.0)
    assert (float(left), float(right)) == pytest.approx((4.875 + 3.5, 4.875 + 4.8))


def test_a_lane_may_taper_to_nothing_but_not_a_road() -> None:
    taper = WidthProfile(np.array([0.0, 40.0]), np.array([0.0, 3.5]))
    exit_lane = Lane(-2, "drive", taper)
    section = CrossSection((lane(-1, "drive", 3.5, True), exit_lane))
    np.testing.assert_allclose(section.drivable_width([0.0, 20.0, 40.0]), [3.5, 5.25, 7.0])
    with pytest.raises(GeometryError, match="positive"):
        Road(Curve.through([(0, 0), (40, 0)]), taper)


@pytest.mark.parametrize("ids", [(), (-1, 1), (1, -2), (2, -1), (1, 1), (-2, -1)])
def test_ids_run_from_left_to_right_without_gaps(ids: tuple[int, ...]) -> None:
    with pytest.raises(GeometryError):
        CrossSection(tuple(lane(id, "drive", 3.0, True) for id in ids))


@pytest.mark.parametrize(
    ("id", "options"),
    [(0, {}), (-1, {"marking": "dotted"}), (-1, {"speed_limit": 0.0}), (-1, {"direction": "up"})],
)
def test_impossible_lanes_are_refused(id: int, options: Any) -> None:
    with pytest.raises(GeometryError):
        Lane(id, "drive", WidthProfile.constant(3.0), **options)


def test_a_lane_that_does_not_exist_is_refused_with_those_that_do() -> None:
    with pytest.raises(GeometryError, match="no lane 4; its lanes are 3, 2, 1, -1, -2, -3, -4"):
        avenue().offset(4, 0.0)


def test_a_road_takes_width_and_lanes_from_its_cross_section() -> None:
    road = Road.of(Curve.through([(0, 0), (LENGTH, 0)]), avenue())
    assert road.lanes == 3
    assert float(road.width.at(3.0)) == pytest.approx(9.75)
    assert road.lane_ids == (3, 2, 1, -1, -2, -3, -4)
    left, right = road.edges([0.0, LENGTH])
    np.testing.assert_allclose(left[:, 1], 8.375)
    np.testing.assert_allclose(right[:, 1], -9.675)
    with pytest.raises(GeometryError, match="add up"):
        Road(road.curve, WidthProfile.constant(7.0), 3, avenue())


def test_an_edge_keeps_its_lanes_when_the_network_is_turned_into_meters() -> None:
    curve = Curve.through([(0, 0), (LENGTH, 0)])
    nodes = Node(1, (0.0, 0.0)), Node(2, (LENGTH, 0.0))
    pixels = RoadNetwork(nodes, (Edge.of(1, 1, 2, curve, avenue().scaled(1.0, 2.0)),))
    meters = pixels.transformed([[0.5, 0.0], [0.0, -0.5]], width_factor=0.5).edge(1)
    assert meters.cross_section is not None
    same(meters.cross_section, avenue().mirrored())
    assert float(meters.width.at(0.0)) == pytest.approx(9.75)
    assert meters.road().lanes == 3


def test_the_lane_that_is_entered_from_beside_the_road_is_the_nearest_for_the_direction() -> None:
    kinds: Any = [(2, "backward"), (1, "both"), (-1, "forward"), (-2, "forward")]
    section = CrossSection(tuple(lane(id, "drive", 3.0, True) for id, _ in kinds))
    section = replace(
        section,
        lanes=tuple(
            replace(one, direction=way) for one, (_, way) in zip(section.lanes, kinds, strict=True)
        ),
    )
    assert section.entered_from(-8.0, 0.0, backward=False) == -4.5
    assert section.entered_from(8.0, 0.0, backward=False) == 1.5
    assert section.entered_from(8.0, 0.0, backward=True) == 4.5
    assert section.entered_from(-8.0, 0.0, backward=True) == 1.5
    oneway = CrossSection((lane(-1, "drive", 3.0, True),))
    assert oneway.entered_from(5.0, 0.0, backward=True) == 0.0
