"""The lines along lanes that figures draw, on lanes of 40 pixels at 10 pixels per meter."""

from __future__ import annotations

import pytest

from roadlang.geometry import (
    Lane,
    LaneStroke,
    WidthProfile,
    are_lines_seen,
    lane_strokes,
    line_width,
)


def drawn(*markings: str, lane: float = 40.0, scale: float = 10.0) -> list[LaneStroke]:
    lanes = [Lane(-id, "drive", WidthProfile.constant(4.0)) for id in range(1, len(markings))]
    return list(lane_strokes(lanes, markings, lane, scale))  # type: ignore[arg-type]


def test_lines_at_the_edges_lie_inside_the_road_and_those_between_lanes_on_the_border() -> None:
    """They are 0.035 of 40 pixels wide; at an edge they lie 0.25 m inside, as in junctions."""
    left, middle, right = drawn("solid", "broken", "solid")
    assert [left.border, middle.border, right.border] == [0, 1, 2]
    assert [left.shift, middle.shift, right.shift] == pytest.approx([-2.5, 0.0, 2.5])
    assert middle.width == pytest.approx(1.4)
    assert [left.dashes, middle.dashes] == [None, (30.0, 60.0)]


def test_where_a_road_is_drawn_small_the_lines_at_its_edges_are_clear_of_them() -> None:
    shifts = [stroke.shift for stroke in drawn("solid", "none", "solid", lane=12.0, scale=3.0)]
    assert shifts == pytest.approx([-1.5, 1.5])


def test_a_double_line_is_one_to_each_side_of_the_border() -> None:
    shifts = [stroke.shift for stroke in drawn("none", "double", "none")]
    assert shifts == pytest.approx([1.68, -1.68])


def test_a_curb_is_20_cm_wide_on_the_border_itself() -> None:
    (curb,) = drawn("curb", "none", "none")
    assert curb == LaneStroke(0, 0.0, 2.0, is_curb=True)
    assert drawn("curb", "none", scale=1.0)[0].width == 0.7, "no thinner than can be seen"


def test_dashes_can_be_seen_on_a_small_map() -> None:
    """3 m and a gap of 6 m, but at least 5 pixels."""
    (middle,) = drawn("none", "broken", "none", scale=1.0)
    assert middle.dashes == pytest.approx((5.0, 10.0))


@pytest.mark.parametrize(("lane", "width"), [(10.0, 0.5), (20.0, 0.7), (100.0, 2.0)])
def test_lines_are_wider_on_wide_lanes_within_limits(lane: float, width: float) -> None:
    assert line_width(lane) == pytest.approx(width)


def test_lanes_below_4_pixels_have_no_lines() -> None:
    assert are_lines_seen(4.0)
    assert not are_lines_seen(3.9)
    assert len(drawn("solid", "broken", "solid", lane=4.0)) == 3
    assert drawn("solid", "broken", "solid", lane=3.9) == []
