"""Numbers and signals of two roads: of one root by station, of two roots by the nearest point."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.api import RoadBatch
from roadlang.world.perturbing.perturbation import displaced
from roadlang_standard.number_frechet import Frechet
from roadlang_standard.number_lp_distance import LpDistance
from roadlang_standard.number_sup_distance import SupDistance
from roadlang_standard.signal_deviation import Deviation
from roadlang_standard.signal_distance import Distance


def moved(road: RoadBatch, *distances: float) -> RoadBatch:
    """Parallel roads, a row each."""
    return displaced(road, np.array(distances)[:, None] * np.ones(len(road.stations)))


def of_another_root(road: RoadBatch) -> RoadBatch:
    return replace(road, name="other", root="other")


@pytest.mark.parametrize("foreign", [False, True])
def test_parallel_roads_are_as_far_apart_as_they_were_moved(
    straight: RoadBatch, foreign: bool
) -> None:
    beside = moved(straight, 3.0, -4.0)
    other = of_another_root(straight) if foreign else straight
    for kind in (Distance, Deviation):
        values = kind(beside, other).values()
        np.testing.assert_allclose(values, np.array([[3.0], [4.0]]) * np.ones(201), atol=1e-9)
    assert SupDistance(beside, other).values()[:, 0] == pytest.approx([3.0, 4.0])
    assert Frechet(beside, other).values()[:, 0] == pytest.approx([3.0, 4.0])
    assert LpDistance(beside, other, 2).values()[:, 0] == pytest.approx(
        [3.0 * 200**0.5, 4.0 * 200**0.5]
    )


@pytest.mark.parametrize("foreign", [False, True])
def test_the_seam_of_closed_roads_counts(ring: RoadBatch, foreign: bool) -> None:
    assert ring.period is not None
    beside = moved(ring, 5.0)
    other = of_another_root(ring) if foreign else ring
    (around,) = LpDistance(beside, other, 1).values()
    assert around == pytest.approx(5.0 * ring.period, rel=1e-3)


def test_a_drawn_exponent_is_one_for_each_variant(straight: RoadBatch) -> None:
    exponents: Any = np.array([[1.0], [2.0], [np.pi]])
    together = LpDistance(moved(straight, 3.0, 3.0, 3.0), straight, exponents).values()
    assert together[:, 0] == pytest.approx([3.0 * 200 ** (1 / p) for p in (1, 2, np.pi)])


def test_the_part_along_the_road_is_no_deviation(straight: RoadBatch) -> None:
    shift = np.broadcast_to((5.0, 2.0), (1, len(straight.stations), 2))
    shifted = displaced(straight, np.array(shift))
    np.testing.assert_allclose(Deviation(shifted, straight).values(), 2.0)
    np.testing.assert_allclose(Distance(shifted, straight).values(), np.hypot(5.0, 2.0))
