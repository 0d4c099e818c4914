"""Widths, offsets and batches of curves along stations, by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang.geometry import Curve, CurveBatch, GeometryError, OffsetProfile, WidthProfile
from roadlang.geometry.batches.distances import quadrature

STATIONS = [0.0, 10.0, 30.0]


def widths_of(values: list[float], period: float | None = None, at: Any = STATIONS) -> WidthProfile:
    return WidthProfile(np.array(at, float), np.array(values), period)


def offsets_of(
    values: list[float], period: float | None = None, at: Any = STATIONS
) -> OffsetProfile:
    return OffsetProfile(np.array(at, float), np.array(values), period)


@pytest.mark.parametrize(
    ("s", "width"), [(-5, 4), (0, 4), (5, 5), (10, 6), (20, 4), (30, 2), (99, 2)]
)
def test_a_width_is_linear_between_stations_and_constant_beyond(s: float, width: float) -> None:
    assert widths_of([4.0, 6.0, 2.0]).at(s) == pytest.approx(width)


@pytest.mark.parametrize(("s", "width"), [(35, 3), (40, 4), (45, 5), (75, 3), (-5, 3)])
def test_the_last_width_of_a_ring_runs_on_to_the_first(s: float, width: float) -> None:
    """40 m round: from 2 m at 30 m to 4 m at 40 m."""
    assert widths_of([4.0, 6.0, 2.0], 40.0).at(s) == pytest.approx(width)


def test_even_widths_go_to_the_end_or_once_round() -> None:
    assert WidthProfile.even([1.0, 2.0, 3.0], 60.0).stations.tolist() == [0, 30, 60]
    ring = WidthProfile.even([1.0, 2.0, 3.0], 60.0, closed=True)
    assert (ring.stations.tolist(), ring.period) == ([0, 20, 40], 60)
    assert WidthProfile.constant(3.5).at([0.0, 1e6]).tolist() == [3.5, 3.5]


@pytest.mark.parametrize(
    "widths", [[4.0, -1.0, 2.0], [-1.0, -1.0, -1.0], [0.0, 0.0, 0.0], [4.0, np.nan, 2.0]]
)
def test_a_width_below_zero_anywhere_or_of_zero_everywhere_is_refused(widths: list[float]) -> None:
    with pytest.raises(GeometryError):
        widths_of(widths)


def test_a_lane_may_taper_to_nothing_but_not_a_road() -> None:
    taper = widths_of([4.0, 2.0, 0.0])
    assert taper.at(20) == pytest.approx(1.0)
    with pytest.raises(GeometryError, match="positive"):
        taper.require_positive()
    widths_of([4.0, 2.0, 0.1]).require_positive()


@pytest.mark.parametrize("stations", [[0.0, 0.0, 30.0], [0.0, 30.0, 10.0], [0.0, 10.0], []])
def test_stations_increase_and_are_as_many_as_values(stations: list[float]) -> None:
    with pytest.raises(GeometryError):
        widths_of([4.0, 6.0, 2.0], at=stations)
    with pytest.raises(GeometryError):
        offsets_of([4.0, 6.0, 2.0], at=stations)


def test_profiles_are_scaled_in_length_and_in_size() -> None:
    """By default both by the same factor, as a picture of another scale."""
    widths = widths_of([4.0, 6.0, 2.0], 40.0)
    for scaled, factor in ((widths.scaled(2.0), 2.0), (widths.scaled(2.0, 0.5), 0.5)):
        assert (scaled.stations.tolist(), scaled.period) == ([0, 20, 60], 80)
        assert scaled.widths.tolist() == [4 * factor, 6 * factor, 2 * factor]
    offsets = offsets_of([1.0, -1.0, 2.0], 40.0)
    for moved, factor in ((offsets.scaled(2.0), 2.0), (offsets.scaled(2.0, 0.5), 0.5)):
        assert (moved.stations.tolist(), moved.period) == ([0, 20, 60], 80)
        assert moved.offsets.tolist() == [factor, -factor, 2 * factor]
    assert offsets_of([1.0, -1.0, 2.0]).scaled(3.0).period is None


def test_who_travels_the_other_way_has_left_on_the_right() -> None:
    widths = widths_of([4.0, 6.0, 2.0]).reversed(30.0)
    assert (widths.stations.tolist(), widths.widths.tolist()) == ([0, 20, 30], [2, 6, 4])
    offsets = offsets_of([1.0, -1.0, 2.0]).reversed(30.0)
    assert (offsets.stations.tolist(), offsets.offsets.tolist()) == ([0, 20, 30], [-2, 1, -1])
    assert offsets_of([1.0, -1.0, 2.0]).mirrored().offsets.tolist() == [-1, 1, -2]
    assert OffsetProfile.constant(-1.5).at([0.0, 99.0]).tolist() == [-1.5, -1.5]


def circle(radius: float = 10.0, count: int = 100) -> np.ndarray:
    angle = np.linspace(0.0, 2 * np.pi, count, endpoint=False)
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def test_the_heading_of_a_batch_does_not_jump_at_half_a_turn() -> None:
    """Counter-clockwise from the east it grows by a whole turn, and not back from pi to -pi."""
    arc = CurveBatch(np.linspace(0.0, 20 * np.pi, 100), circle()[None])
    heading = arc.heading[0]
    assert heading[0] == pytest.approx(np.pi / 2, abs=0.01)
    assert np.diff(heading) == pytest.approx(np.full(99, 2 * np.pi / 100), abs=0.002)


def test_a_closed_batch_has_a_step_more_and_the_mean_gap_as_its_last() -> None:
    stations = np.linspace(0.0, 62.0, 100)
    points = circle()[None]
    ring, arc = CurveBatch(stations, points, closed=True), CurveBatch(stations, points)
    assert (ring.steps.shape, arc.steps.shape) == ((1, 100), (1, 99))
    assert ring.length[0] == pytest.approx(100 * 20 * np.sin(np.pi / 100))
    assert ring.period == pytest.approx(62.0 * 100 / 99)
    assert CurveBatch(stations, points, closed=True, period=63.0).period == 63.0
    assert CurveBatch(stations, points, period=63.0).period is None
    assert ring.gaps[-1] == pytest.approx(62.0 / 99)


def test_variants_are_taken_by_index_or_mask() -> None:
    """With the stations, the period and whether it is closed."""
    points = np.stack([circle(10.0), circle(20.0), circle(30.0)])
    batch = CurveBatch(np.linspace(0.0, 62.0, 100), points, closed=True, period=63.0)
    for chosen in (np.array([2, 0]), np.array([True, False, True])):
        taken = batch.take(chosen)
        sizes = sorted(taken.points[:, 0, 0].tolist())
        assert (sizes, taken.closed, taken.period) == ([10, 30], True, 63.0)
    assert batch.take(np.array([2, 0])).points[0, 0, 0] == 30


def test_curvature_is_positive_to_the_left() -> None:
    batch = CurveBatch(
        np.linspace(0.0, 62.0, 100), np.stack([circle(), circle()[::-1]]), closed=True
    )
    assert batch.curvature[0] == pytest.approx(np.full(100, 0.1))
    assert batch.curvature[1] == pytest.approx(np.full(100, -0.1))
    # The first goes round counter-clockwise: left is toward the middle.
    assert batch.normal[0] == pytest.approx(-circle() / 10.0, abs=0.01)


@pytest.mark.parametrize("shape", [(100, 2), (1, 99, 2), (1, 100, 3)])
def test_points_of_a_batch_have_a_place_for_each_station(shape: tuple[int, ...]) -> None:
    with pytest.raises(GeometryError, match="needs points of shape"):
        CurveBatch(np.linspace(0.0, 62.0, 100), np.zeros(shape))


def test_weights_of_an_integral_are_half_the_gaps_beside_each_station() -> None:
    """Gaps of 1, 2 and 3 m; of a ring of 10 m the seam of 4 m belongs to both ends."""
    points = np.array([[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [-2.0, 2.0]]])
    stations = [0.0, 1.0, 3.0, 6.0]
    assert quadrature(CurveBatch(stations, points)).tolist() == [0.5, 1.5, 2.5, 1.5]
    ring = CurveBatch(stations, points, closed=True, period=10.0)
    assert quadrature(ring).tolist() == [2.5, 1.5, 2.5, 3.5]


def test_points_are_projected_with_their_side() -> None:
    """(3, 2) lies 2 m left of a line eastward; beyond its end the end is nearest."""
    line = Curve.through([(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)])
    s, offset = line.project([[3.0, 2.0], [12.0, -1.0]])
    assert s == pytest.approx([3, 12])
    assert offset == pytest.approx([2, -1])
    assert [part.shape for part in line.project(np.zeros((0, 2)))] == [(0,), (0,)]
    assert [part.shape for part in line.project(np.zeros((3, 0, 2)))] == [(3, 0), (3, 0)]
    with pytest.raises(GeometryError, match="pairs"):
        line.project([1.0, 2.0, 3.0])


def test_a_ring_has_no_second_end() -> None:
    ring = Curve.through(circle(), closed=True)
    s, offset = ring.project([[10.0, 0.0], [9.0, 0.0]])
    assert s == pytest.approx([0.0, 0.0], abs=1e-6)
    assert offset[1] == pytest.approx(1.0, abs=1e-3)
