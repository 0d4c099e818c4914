"""The quick test of lines that are moved again and again, against the exact ones."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry import displace
from roadlang.geometry.batches.folding import fold_of_points, turns_too_much
from roadlang.geometry.batches.smooth_moves import surely_smooth
from tests.geometry.geometry_shapes import circle, line


@pytest.mark.parametrize("closed", [False, True])
def test_what_passes_the_quick_test_passes_the_exact_ones(closed: bool) -> None:
    road = circle(radius=40.0, count=300) if closed else line(250.0)
    s = road.stations(count=251)
    random = np.random.default_rng(3)
    size = np.geomspace(0.5, 30.0, 200)[:, None]
    waves = 2 * np.pi * random.integers(1, 12, (200, 1)) * s / road.length
    first = displace(road, s, size * np.sin(waves))
    moved = displace(first, s, 0.5 * size[::-1] * np.cos(1.7 * waves if not closed else 2 * waves))
    steps = moved.step_bounds, first.step_bounds
    quick = surely_smooth(*steps, moved.curvature, moved.gaps, closed)
    exact = fold_of_points(moved.points, moved.gaps, closed, (first.points, first.steps))
    exact |= turns_too_much(moved.curvature, moved.steps, closed)
    assert 20 < exact.sum() < 170
    assert not (quick & exact).any()
    assert quick.sum() > 0.5 * (~exact).sum()
    np.testing.assert_array_equal(moved.folded, exact | first.folded)


def test_a_fold_at_the_seam_of_a_closed_road_is_not_passed() -> None:
    ring = circle(radius=30.0, count=200)
    s = ring.stations(count=100)
    moves = np.zeros((1, 100))
    moves[0, 0], moves[0, -1] = 3.0, -3.0
    still = displace(ring, s, 0.0 * moves)
    again = displace(still, s, moves)
    steps = again.step_bounds, still.step_bounds
    assert not surely_smooth(*steps, 0.0 * again.curvature, again.gaps, closed=True).any()
