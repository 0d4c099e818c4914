"""Displacements along the normal: smooth, bounded, seamless on closed roads, one row a variant."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.api import BatchRandom, Perturber, RoadBatch
from roadlang.geometry import GeometryError
from roadlang_standard.perturb_bump import Bump
from roadlang_standard.perturb_harmonics import Harmonics
from roadlang_standard.perturb_random_walk import RandomWalk
from roadlang_standard.perturb_scale import Scale
from roadlang_standard.perturb_shift import Shift
from roadlang_standard.perturb_sine import Sine

Make = Callable[[Any], Perturber]
COLUMN = np.linspace(1.0, 8.0, 8)[:, None]
KINDS: dict[str, Make] = {
    "sine": lambda size: Sine(size, 70.0, 0.3),
    "harmonics": lambda size: Harmonics(size, 5),
    "random_walk": lambda size: RandomWalk(size, 25.0),
    "bump": lambda size: Bump(5.0, size, 60.0),
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("shape", ["straight", "ring"])
def test_displacements_stay_within_their_bound(
    request: pytest.FixtureRequest, random: BatchRandom, kind: str, shape: str
) -> None:
    road: RoadBatch = request.getfixturevalue(shape)
    made = KINDS[kind](COLUMN)
    moves = made.displacements(road, random)
    assert moves.shape == (8, len(road.stations))
    assert (np.abs(moves) <= made.displacement_bound() + 1e-12).all()
    assert np.abs(moves).max(axis=1).min() > 0


@pytest.mark.parametrize("kind", KINDS)
def test_a_closed_road_has_no_seam(ring: RoadBatch, random: BatchRandom, kind: str) -> None:
    moves = KINDS[kind](COLUMN).displacements(ring, random)
    steps = np.abs(np.diff(moves, axis=1)).max(axis=1)
    assert (np.abs(moves[:, 0] - moves[:, -1]) <= 1.5 * steps + 1e-12).all()


@pytest.mark.parametrize("kind", KINDS)
def test_the_curvature_has_no_jump(straight: RoadBatch, random: BatchRandom, kind: str) -> None:
    moves = KINDS[kind](COLUMN).displacements(straight, random)
    bend = np.diff(moves, 2, axis=1)
    change = np.abs(np.diff(bend, axis=1)).max(axis=1)
    assert (change < 0.35 * np.abs(bend).max(axis=1)).all()


@pytest.mark.parametrize("kind", KINDS)
def test_a_variant_does_not_depend_on_its_company(
    straight: RoadBatch, random: BatchRandom, kind: str
) -> None:
    together = KINDS[kind](COLUMN).displacements(straight, random)
    for row in range(8):
        alone = KINDS[kind](COLUMN[row : row + 1]).displacements(
            straight, BatchRandom(random.keys[row : row + 1])
        )
        np.testing.assert_allclose(alone[0], together[row], atol=1e-12)


def test_a_sine_is_a_sine(straight: RoadBatch, random: BatchRandom) -> None:
    moves = Sine(3.0, 50.0, np.pi / 2).displacements(straight, random)
    np.testing.assert_allclose(moves[0], 3.0 * np.cos(2 * np.pi * straight.stations / 50.0))


@given(wavelength=st.floats(5, 1000))
def test_a_sine_closes_with_a_whole_number_of_periods(ring: RoadBatch, wavelength: float) -> None:
    moves = Sine(1.0, wavelength).displacements(ring, BatchRandom(np.ones(1, np.uint64)))
    at_start, slope = moves[0, 0], moves[0, 1] - moves[0, -1]
    assert at_start == pytest.approx(0.0, abs=1e-9)
    assert slope > 0


@pytest.mark.parametrize(("wished", "periods"), [(3.0, 3), (2.6, 3), (2.4, 2), (0.3, 1)])
def test_a_sine_on_a_loop_has_the_nearest_number_of_periods(
    ring: RoadBatch, random: BatchRandom, wished: float, periods: int
) -> None:
    assert ring.period is not None
    (moves,) = Sine(1.0, ring.period / wished).displacements(ring, random)
    np.testing.assert_allclose(moves, np.sin(2 * np.pi * periods * ring.stations / ring.period))


def test_a_bump_ends_where_it_says(straight: RoadBatch, random: BatchRandom) -> None:
    moves = Bump(at=100.0, height=2.0, length=40.0).displacements(straight, random)[0]
    assert moves.max() == pytest.approx(2.0)
    assert straight.stations[moves.argmax()] == pytest.approx(100.0)
    assert (moves[np.abs(straight.stations - 100.0) >= 20.0] == 0).all()


def test_scale_zero_makes_a_bend_straight(random: BatchRandom) -> None:
    from roadlang.world.perturbing.perturbation import displaced
    from tests.standard.roads_of_points import road_of

    bend = road_of([(0, 0), (40, 4), (80, 5), (120, 4), (160, 0)])
    flat = displaced(bend, Scale(0.0).displacements(bend, random))
    assert np.abs(flat.points[0, :, 1]).max() < 0.05
    same = Scale(1.0).displacements(bend, random)
    assert (same == 0).all()


@pytest.mark.parametrize("factor", [0.5, 0.816, 1.0, 1.4])
def test_scale_keeps_the_shape_of_a_loop(random: BatchRandom, factor: float) -> None:
    """A loop with bends to both sides: along the normals it would get dents."""
    from roadlang.world.perturbing.perturbation import displaced
    from tests.standard.roads_of_points import road_of

    turn = np.linspace(0, 2 * np.pi, 30, endpoint=False)
    radius = 60 + 18 * np.cos(5 * turn)
    loop = road_of([*zip(radius * np.cos(turn), radius * np.sin(turn), strict=True)], closed=True)
    scale: Any = np.array([[factor]])
    scaled = displaced(loop, Scale(scale).displacements(loop, random))
    np.testing.assert_allclose(scaled.curvature * factor, loop.curvature, atol=1e-3, rtol=0.02)
    np.testing.assert_allclose(scaled.heading, loop.heading, atol=0.01)
    np.testing.assert_allclose(scaled.length, loop.length * factor)
    middle = loop.points.mean(axis=1)
    np.testing.assert_allclose(scaled.points.mean(axis=1), middle, atol=1e-9)
    assert not scaled.folded.any()


def test_scale_moves_an_interval_of_a_loop_along_the_normal(
    ring: RoadBatch, random: BatchRandom
) -> None:
    from dataclasses import replace

    part = replace(ring, interval=(0.0, 60.0))
    moves = Scale(0.5).displacements(part, random)
    assert moves.shape == (1, len(ring.stations))
    sagitta = 60.0 * (1 - np.cos(0.5))
    assert moves[0, 30] == pytest.approx(0.5 * sagitta, abs=0.02)


def test_a_walk_forgets_within_its_correlation(straight: RoadBatch) -> None:
    random = BatchRandom(np.arange(1, 2001, dtype=np.uint64))
    moves = RandomWalk(1.0, 20.0).displacements(straight, random)
    near = np.corrcoef(moves[:, 50], moves[:, 52])[0, 1]
    far = np.corrcoef(moves[:, 50], moves[:, 110])[0, 1]
    assert near > 0.9
    assert abs(far) < 0.25
    assert abs(moves.mean()) < 0.05


def test_a_shift_moves_to_the_side_and_stays_there(
    straight: RoadBatch, random: BatchRandom
) -> None:
    moves = Shift(at=20.0, offset=-3.5, length=30.0).displacements(straight, random)[0]
    before, after = straight.stations <= 20.0, straight.stations >= 50.0
    assert (moves[before] == 0.0).all()
    assert (moves[after] == -3.5).all()
    assert (np.diff(moves) <= 0.0).all()
    middle = np.interp(35.0, straight.stations, moves)
    assert middle == pytest.approx(-1.75, abs=0.02)


def test_a_closed_road_cannot_be_shifted(ring: RoadBatch, random: BatchRandom) -> None:
    with pytest.raises(GeometryError, match="open road"):
        Shift(at=20.0, offset=1.0, length=30.0).displacements(ring, random)


@pytest.mark.parametrize("at", [0.0, 1.0, 60.0])
def test_a_bump_on_a_loop_reaches_over_the_seam(
    ring: RoadBatch, random: BatchRandom, at: float
) -> None:
    assert ring.period is not None
    (moved,) = Bump(at=at, height=2.0, length=20.0).displacements(ring, random)
    away = np.abs(ring.stations - at)
    away = np.minimum(away, ring.period - away)
    assert (moved[away < 9.0] > 0.0).all()
    assert (moved[away > 10.0] == 0.0).all()
