"""The lanes of a road in many candidates, some of whose widths and speed limits are drawn."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.geometry import CrossSection, Lane, OffsetProfile, WidthProfile
from roadlang.world.lanes.cross_sections import LaneBatch

STATIONS = np.array([0.0, 50.0, 100.0])
WIDTH = WidthProfile(STATIONS, np.array([3.0, 3.0, 3.0]))
WALK = WidthProfile(STATIONS, np.array([1.0, 2.0, 3.0]))

PATTERN = CrossSection((
    Lane(1, "drive", WIDTH, "backward"),
    Lane(-1, "drive", WIDTH, "forward", speed_limit=14.0),
    Lane(-2, "sidewalk", WALK, "none", drivable=False),
))  # fmt: skip
BATCH = LaneBatch(PATTERN, {-1: np.array([[3.0], [6.0]])}, {1: np.array([10.0, 20.0]), -2: 1.5})


def test_there_are_as_many_variants_as_the_drawn_columns_have() -> None:
    assert BATCH.variants == 2
    assert LaneBatch(PATTERN, {}, {1: 9.0}).variants == 1


def test_the_drivable_lanes_share_the_width_and_the_others_keep_theirs() -> None:
    s = np.array([0.0, 100.0])
    widths = BATCH.lane_widths(np.full((2, 2), 9.0), s)
    assert widths[0].tolist() == [[4.5, 4.5], [3.0, 3.0]]
    assert widths[1].tolist() == [[4.5, 4.5], [6.0, 6.0]]
    assert widths[2].tolist() == [[1.0, 3.0], [1.0, 3.0]]
    assert BATCH.extent().tolist() == [[6.0], [9.0]]


def test_borders_lie_around_the_middle_of_the_drivable_lanes() -> None:
    left, center, right, outer = BATCH.border_offsets(np.full((2, 1), 9.0), np.array([100.0]))
    assert left.tolist() == [[4.5], [4.5]]
    assert center.tolist() == [[0.0], [1.5]]
    assert right.tolist() == [[-4.5], [-4.5]]
    assert outer.tolist() == [[-7.5], [-7.5]]


def test_a_road_without_width_has_no_room_for_lanes() -> None:
    with pytest.raises(DiagnosticError, match="RL431"):
        BATCH.lane_widths(np.zeros((2, 1)), np.array([0.0]))


def test_the_cross_section_of_one_candidate_has_its_numbers() -> None:
    second = BATCH.take(np.array([1]))
    assert second.variants == 1
    section = second.cross_section(WidthProfile(STATIONS, np.array([9.0, 9.0, 12.0])), STATIONS)
    assert [lane.speed_limit for lane in section.lanes] == [20.0, 14.0, 1.5]
    assert [lane.width.widths.tolist() for lane in section.lanes] == [
        [3.0, 3.0, 4.0], [6.0, 6.0, 8.0], [1.0, 2.0, 3.0],
    ]  # fmt: skip


def test_rows_are_taken_of_columns_and_numbers_stay() -> None:
    taken = BATCH.take(np.array([1, 0, 1]))
    assert taken.widths[-1].tolist() == [[6.0], [3.0], [6.0]]
    assert taken.speed_limits[1].tolist() == [20.0, 10.0, 20.0]
    assert taken.speed_limits[-2] == 1.5
    shared = LaneBatch(PATTERN, {-1: np.array([[3.0]])}, {}).take(np.array([4, 5]))
    assert shared.widths[-1].tolist() == [[3.0]], "one row is that of all candidates"


def test_the_other_way_round_lanes_change_sides_with_all_that_is_drawn_of_them() -> None:
    other = BATCH.reversed(100.0)
    assert other.pattern.ids == (2, 1, -1)
    assert {id: column.tolist() for id, column in other.widths.items()} == {1: [[3.0], [6.0]]}
    assert other.speed_limits[-1].tolist() == [10.0, 20.0]
    assert other.speed_limits[2] == 1.5
    s = np.array([0.0, 30.0])
    there = BATCH.lane_widths(np.full((2, 2), 9.0), s)
    back = other.lane_widths(np.full((2, 2), 9.0), 100.0 - s)
    np.testing.assert_allclose(back, there[::-1])


def test_an_offset_of_the_center_moves_all_borders() -> None:
    offset = OffsetProfile(STATIONS, np.array([0.0, 1.0, 2.0]))
    moved = LaneBatch(CrossSection(PATTERN.lanes, "none", offset), {}, {})
    borders = moved.border_offsets(np.full((1, 3), 6.0), STATIONS)
    assert borders[1].tolist() == [[0.0, 1.0, 2.0]]
    assert borders[0].tolist() == [[3.0, 4.0, 5.0]]
    section = moved.cross_section(WidthProfile(STATIONS[:2], np.array([6.0, 6.0])), STATIONS[1:])
    assert section.center_offset is not None
    assert section.center_offset.offsets.tolist() == [1.0, 2.0]
