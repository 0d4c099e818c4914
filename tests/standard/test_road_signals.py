"""Signals of one road, and the options of perturbers and pieces that decide a sign or a number."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang.api import BatchRandom, RoadBatch
from roadlang.geometry import over
from roadlang.world.perturbing.perturbation import displaced
from roadlang_standard.perturb_harmonics import Harmonics
from roadlang_standard.pieces import ClothoidPiece
from roadlang_standard.signal_clearance import Clearance
from roadlang_standard.signal_curvature import Curvature
from roadlang_standard.signal_deviation import Deviation
from roadlang_standard.signal_distance import Distance
from roadlang_standard.signal_margin import Margin
from roadlang_standard.signal_width import Width
from tests.standard.roads_of_points import road_of


def test_a_road_that_goes_round_counter_clockwise_bends_left(ring: RoadBatch) -> None:
    np.testing.assert_allclose(Curvature(ring).values(), 1 / 60, rtol=0.01)


def test_the_margin_is_to_the_nearest_side_of_the_box(straight: RoadBatch) -> None:
    (values,) = Margin(straight, (-10.0, -5.0), (250.0, 30.0)).values()
    assert values[[0, 100, 200]] == pytest.approx([5.0, 5.0, 5.0])
    (outside,) = Margin(straight, (0.0, 2.0), (200.0, 30.0)).values()
    np.testing.assert_allclose(outside, -2.0)


def test_other_roads_of_the_network_must_be_kept_clear_of(straight: RoadBatch) -> None:
    beside = displaced(straight, np.full((1, len(straight.stations)), 9.0))
    alone = Clearance(straight).values()
    assert alone.min() > 1000.0
    together = Clearance(replace(straight, others=(beside,))).values()
    np.testing.assert_allclose(together, 9.0)


def test_the_deviation_is_from_the_other_road_not_from_the_root(straight: RoadBatch) -> None:
    near, far = (displaced(straight, np.full((1, 201), meters)) for meters in (3.0, 10.0))
    np.testing.assert_allclose(Deviation(far, near).values(), 7.0)


@pytest.mark.parametrize(("closed", "feature"), [(True, 50.0), (False, 100.0)])
def test_the_shortest_of_the_harmonics_is_a_period_of_the_last(
    closed: bool, feature: float
) -> None:
    assert Harmonics(1.0, 4).shortest_feature(200.0, closed) == feature


def test_a_single_mode_is_a_wave(straight: RoadBatch, random: BatchRandom) -> None:
    moves = Harmonics(2.0, 1).displacements(straight, random)
    assert np.abs(moves).max(axis=1).min() > 0.0
    spectrum = np.abs(np.fft.rfft(np.concatenate([moves[:, :-1], -moves[:, :-1]], axis=1)))
    assert (spectrum.argmax(axis=1) == 1).all()


def test_a_clothoid_begins_with_its_own_curvature_where_it_has_one() -> None:
    assert ClothoidPiece(30.0, 0.02).to_segment(0.01).curvatures == (0.01, 0.02)
    assert ClothoidPiece(30.0, 0.02, start=0.0).to_segment(0.01).curvatures == (0.0, 0.02)


def test_long_tapers_meet_in_the_middle_of_the_interval() -> None:
    s = np.linspace(0.0, 100.0, 101)
    window = over(s, 20.0, 60.0, taper=500.0)
    assert window[40] == 1.0
    np.testing.assert_allclose(window[20:61], window[20:61][::-1], atol=1e-12)
    np.testing.assert_allclose(window[20:61], over(s, 20.0, 60.0, taper=20.0)[20:61])


def test_each_candidate_has_its_own_width_at_every_station(straight: RoadBatch) -> None:
    three = displaced(straight, np.zeros((3, len(straight.stations))))
    wide = replace(three, width=np.array([[4.0], [6.0], [9.0]]))
    values = Width(wide).values()
    assert values.shape == (3, len(straight.stations))
    np.testing.assert_array_equal(values[:, [0, -1]], [[4.0, 4.0], [6.0, 6.0], [9.0, 9.0]])


def test_the_distance_is_that_of_the_points_of_the_first_road() -> None:
    """To the nearest point of a road that is shorter: not the same the other way round."""
    long, short = road_of([(0, 0), (100, 0), (200, 0)]), road_of([(0, 3), (20, 3), (40, 3)])
    short = replace(short, name="short", root="short")
    (away,) = Distance(long, short).values()
    assert away[[0, 40, 200]] == pytest.approx([3.0, 3.0, np.hypot(160.0, 3.0)])
    (back,) = Distance(short, long).values()
    np.testing.assert_allclose(back, 3.0)
