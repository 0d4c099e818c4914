"""What is measured on surfaces and pictures, on some that are drawn by hand."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roadlang_standard.extraction.curves.edges import (
    CenterLine,
    Sides,
    normals,
    sides_of,
    typical_width,
    widths,
)
from roadlang_standard.extraction.curves.smoothing import (
    curvature,
    resample,
    smooth,
    smooth_values,
    stations,
)
from roadlang_standard.extraction.drawings.surface_roads import roads_of_surface
from roadlang_standard.extraction.masks.hysteresis import hysteresis
from roadlang_standard.extraction.networks.drafting import Draft, draft, typical_width_of
from roadlang_standard.extraction.photos.hints import leave_out, paint, paths_through
from tests.extraction.graph_drawings import dense, graph_of
from tests.extraction.painted_roads import band

# Widths and middles: a band of rows 40 to 59 has its middle at 49.5 and is 20 px wide.


def test_the_edges_of_a_road_are_where_the_surface_falls_through_one_half() -> None:
    """A line at row 47 is 7.5 px from the upper edge and 12.5 px from the lower one."""
    seen = sides_of([CenterLine(dense((20, 47), (180, 47)))], band(40, 60), 20.0)[0]
    assert seen.left == pytest.approx(np.full(161, 12.5), abs=0.15)
    assert seen.right == pytest.approx(np.full(161, 7.5), abs=0.15)
    assert typical_width(seen) == pytest.approx(20, abs=0.1)
    assert seen.seen.all()


def test_an_edge_beyond_the_radius_or_a_line_beside_the_road_is_not_seen() -> None:
    near = sides_of([CenterLine(dense((20, 47), (180, 47)))], band(40, 60), 10.0)[0]
    assert np.isnan(near.left).all()
    assert np.isfinite(near.right).all()
    beside = sides_of([CenterLine(dense((20, 20), (180, 20)))], band(40, 60), 50.0)[0]
    assert not beside.seen.any()
    assert np.isnan(typical_width(beside))


def test_the_level_of_an_edge_may_be_set() -> None:
    """A slope from 1 at row 50 down to 0 at row 70: 0.25 is at row 65."""
    slope = np.clip((70 - np.arange(100.0)) / 20, 0, 1)[:, None].repeat(200, axis=1)
    for level, distance in ((0.25, 15), (0.75, 5)):
        line = CenterLine(dense((50, 50), (150, 50)))
        (seen,) = sides_of([line], slope.astype(np.float32), 30.0, level)
        assert seen.left[50] == pytest.approx(distance, abs=0.2)


def test_normals_are_to_the_right_of_east_in_a_picture() -> None:
    """y runs down: the normal of a line to the right points down."""
    assert normals(dense((0, 0), (9, 0)))[4] == pytest.approx([0, 1])
    assert normals(dense((0, 0), (0, 9)))[4] == pytest.approx([-1, 0])


def both(left: float, right: float, count: int = 200) -> Sides:
    return Sides(np.full(count, left), np.full(count, right))


def test_widths_leave_out_what_is_far_from_the_usual() -> None:
    found = both(10.0, 10.0)
    found.left[50:60] = 45.0  # a lay-by of 55 px
    wide, spread = widths(found, 7.0, 40.0, closed=False)
    assert wide == pytest.approx(np.full(200, 20.0), abs=0.1)
    assert spread == pytest.approx(0, abs=0.05)


def test_the_spread_of_widths_is_their_standard_deviation() -> None:
    noise = np.random.default_rng(1).normal(0, 1.0, 4000)
    _, spread = widths(Sides(10 + noise, np.full(4000, 10.0)), 7.0, 400.0, closed=False)
    assert spread == pytest.approx(1.0, rel=0.06)


def test_unseen_widths_are_the_fallback() -> None:
    nothing = Sides(np.full(5, np.nan), np.full(5, np.nan))
    wide, spread = widths(nothing, 7.0, 40.0, closed=False)
    assert wide.tolist() == [7.0] * 5
    assert np.isnan(spread)


def test_the_typical_width_is_that_of_the_mask_along_the_lines() -> None:
    """Twice the distance from row 49.5 to the edge, 10.5 px to the first pixel outside, less 1."""
    graph = graph_of(((10, 49), (190, 49)))
    assert typical_width_of(graph, band(40, 60) > 0) == pytest.approx(19.5, abs=1.0)
    assert typical_width_of(graph_of(), band(40, 60) > 0) == 1.0


def test_a_straight_road_is_found_where_it_lies_from_edge_to_edge() -> None:
    found = roads_of_surface(band(40, 60), "by hand")
    (road,) = found.roads
    assert road.points[:, 1] == pytest.approx(np.full(len(road.points), 49.5), abs=0.15)
    assert sorted(road.points[[0, -1], 0]) == pytest.approx([-0.5, 199.5], abs=0.6)
    assert road.widths == pytest.approx(np.full(len(road.points), 20.0), abs=0.3)
    assert found.method == "by hand"
    assert road.confidence > 0.95


def test_a_width_that_is_given_is_not_measured() -> None:
    (road,) = roads_of_surface(band(40, 60), "", width=17.0).roads
    assert set(road.widths) == {17.0}
    assert road.width_error == 0.0


def test_specks_and_holes_are_left_out() -> None:
    """A stain of 3 x 3 px beside the road and a hole of 3 x 3 px in it."""
    mask = band(40, 60)
    mask[5:8, 5:8], mask[48:51, 90:93] = 1.0, 0.0
    found = roads_of_surface(mask, "", specks=10.0)
    assert len(found.roads) == 1
    assert not found.mask[6, 6] or len(found.roads) == 1
    assert len(roads_of_surface(mask, "", specks=9.0).roads) > 1


def test_stubs_shorter_than_the_least_length_go() -> None:
    mask = band(46, 54)
    mask[20:50, 96:104] = 1.0
    assert len(roads_of_surface(mask, "").roads) == 3
    assert len(roads_of_surface(mask, "", least=60.0).roads) == 1


# Masks


def test_weak_evidence_counts_where_strong_evidence_touches_it() -> None:
    score = np.zeros((10, 30), np.float32)
    score[4, 2:12] = score[8, 2:12] = 0.5
    score[4, 5] = 0.9
    mask = hysteresis(score, 0.8, 0.4)
    assert np.argwhere(mask).tolist() == [[4, x] for x in range(2, 12)]
    assert not hysteresis(score, 0.9, 0.4).any()
    assert hysteresis(score, 0.8, 0.5).sum() == 1


# Hints


def test_a_box_is_left_out_with_its_edges() -> None:
    score = np.ones((20, 30), np.float32)
    leave_out([score], (((12.0, 4.0), (5.0, 9.0)),))
    assert np.argwhere(score == 0).min(axis=0).tolist() == [4, 5]
    assert np.argwhere(score == 0).max(axis=0).tolist() == [9, 12]
    leave_out([score], (((-50.0, -50.0), (-5.0, -5.0)),))
    assert (score == 0).sum() == 6 * 8


def test_a_way_follows_the_evidence_and_goes_straight_without() -> None:
    """A road along three sides of a rectangle; without it 100 px straight ahead."""
    score = np.full((120, 200), 0.02, np.float32)
    for rows, columns in ((slice(26, 35), slice(46, 155)), (slice(26, 95), slice(46, 55)),
                          (slice(26, 95), slice(146, 155))):  # fmt: skip
        score[rows, columns] = 0.95
    ends = np.array([[50.0, 90.0], [150.0, 90.0]])
    (way,) = paths_through(score, ends)
    assert way[[0, -1]].tolist() == ends.tolist()
    assert way[:, 1].min() == pytest.approx(30, abs=4)
    (straight,) = paths_through(np.full((120, 200), 0.5, np.float32), ends)
    assert np.abs(straight[:, 1] - 90).max() < 0.5
    assert len(paths_through(score, np.vstack([ends, [[20.0, 20.0]]]))) == 2


def test_a_way_is_painted_as_wide_as_a_road() -> None:
    surface_, score = np.zeros((40, 80), np.float32), np.full((40, 80), 0.3, np.float32)
    paint(surface_, score, dense((10, 20), (70, 20)), 7.0)
    assert 7 <= surface_[:, 40].sum() < 10  # its soft edges lie outside
    assert (surface_[20, 40], score[20, 40], score[5, 40]) == pytest.approx((1, 1, 0.3))


# Lines


def test_a_line_is_resampled_evenly_with_its_ends() -> None:
    line = resample(np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 10.0]]), 2.0)
    assert stations(line)[-1] == pytest.approx(11, abs=0.1)
    assert len(line) == 7
    assert line[[0, -1]].tolist() == [[0, 0], [3, 10]]
    assert len(resample(np.array([[0.0, 0.0], [0.1, 0.0]]))) == 2


def test_the_curvature_of_a_circle_is_one_over_its_radius() -> None:
    angle = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    circle = 50 * np.column_stack([np.cos(angle), np.sin(angle)])
    assert curvature(circle, closed=True) == pytest.approx(np.full(400, 0.02), rel=1e-3)


@pytest.mark.parametrize(("wave", "share"), [(20.0, 0.06), (40.0, 0.5), (80.0, 0.94)])
def test_waves_below_the_wavelength_are_taken_out(wave: float, share: float) -> None:
    """At the wavelength itself half of a wave is left: 1 / (1 + (40 / wave)^4)."""
    values = np.sin(2 * np.pi * np.arange(800) / wave)
    left = smooth_values(values, 40.0)[200:600]
    assert np.abs(left).max() == pytest.approx(share, abs=0.02)
    around = smooth_values(values, 40.0, closed=True)
    assert np.abs(around).max() == pytest.approx(share, abs=0.02)


def test_ends_stay_unless_they_are_free() -> None:
    line = dense((0, 0), (100, 0)) + np.outer(np.r_[8.0, np.zeros(100)], [0, 1])
    held = smooth(line, 60.0, 50.0)
    free = smooth(line, 60.0, 50.0, free=(True, False))
    assert held[0].tolist() == [0, 8]
    assert 0 < free[0, 1] < 4
    assert held[-1].tolist() == free[-1].tolist() == [100, 0]


def test_a_ring_with_no_room_for_a_bend_stays_a_ring() -> None:
    """Smoothed and made fair, it would shrink to a point."""
    ring = ((200.0, 111.0), (197.0, 111.0), (197.0, 115.0), (200.0, 115.0), (200.0, 111.0))
    graph = graph_of(((20.0, 40.0), (180.0, 40.0)), ring)
    found = draft(graph, band(37, 44), band(37, 44), Draft(7.0), "test")
    (tiny,) = [road for road in found.roads if road.closed]
    assert np.isfinite(tiny.points).all()
    assert tiny.length > 8


def test_digits_beside_a_road_are_rings_that_keep_their_shape() -> None:
    """A zero has hardly room for the bends of a road: made smooth, it shrank to a point."""
    image = band(30, 39, 120, 200)
    cv2.ellipse(image, (100, 90), (4, 6), 0, 0, 360, 1.0, 1, cv2.LINE_AA)
    found = roads_of_surface(image, "test", least=0.0)
    (zero,) = [road for road in found.roads if road.closed]
    assert zero.length == pytest.approx(32, abs=3)


@pytest.mark.parametrize("thickness", [1, 2, 3, 8])
def test_a_thin_line_is_as_sure_as_a_thick_one(thickness: int) -> None:
    (road,) = roads_of_surface(band(50, 50 + thickness), "test").roads
    assert road.confidence > 0.9


def test_lines_that_are_looked_at_together_do_not_know_of_each_other() -> None:
    bent = np.column_stack([np.linspace(20, 180, 90), 50 + 4 * np.sin(np.linspace(0, 6, 90))])
    straight = (dense((20, 47), (180, 47)), dense((30, 55), (90, 52)))
    lines = [CenterLine(line) for line in (*straight, bent)]
    together = sides_of(lines * 30, band(40, 60), 20.0)
    for index, seen in enumerate(together):
        (alone,) = sides_of([lines[index % 3]], band(40, 60), 20.0)
        assert np.array_equal(seen.left, alone.left, equal_nan=True)
        assert np.array_equal(seen.right, alone.right, equal_nan=True)
