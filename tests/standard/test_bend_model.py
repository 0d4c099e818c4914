"""What a search knows of a road from its bends."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from roadlang.api import ROAD_PLACES
from roadlang_standard.bend_model import BendModel
from roadlang_standard.failure_model import FailureModel

Floats = NDArray[np.float64]
BENDS = 12
"""of which each vector says how sharp they are and which way they turn; straight at 0"""


def road_of_bends() -> Floats:
    """(1 + BENDS, ROAD_PLACES): each bend is at four places of its own."""
    road = np.zeros((1 + BENDS, ROAD_PLACES))
    for bend in range(BENDS):
        road[1 + bend, 8 + 4 * bend : 12 + 4 * bend] = 1.0
    return road


def two_bends(first: int, sharp: Floats) -> Floats:
    """Vectors of which bends `first` and the next are as sharp as this (n, 2)."""
    vectors = np.zeros((len(sharp), BENDS))
    vectors[:, first : first + 2] = sharp
    return vectors


def values(sharp: Floats) -> Floats:
    """Bad where the road swings: the second bend turns back."""
    return np.asarray(0.5 + 0.4 * sharp[:, 0] * sharp[:, 1])


def test_a_bend_counts_wherever_it_is_and_whichever_way_it_turns() -> None:
    random = np.random.default_rng(0)
    sharp, other = random.uniform(-1, 1, (120, 2)), random.uniform(-1, 1, (60, 2))
    nothing, model = np.zeros((120, 1)), BendModel()
    model.fit(two_bends(2, sharp), nothing, road_of_bends(), values(sharp))
    for first, turned in ((2, 1.0), (2, -1.0), (7, 1.0), (7, -1.0)):
        vectors = two_bends(first, turned * other)
        predicted = model.predicted(vectors, nothing[:60], optimism=0.0)
        assert np.corrcoef(predicted, values(other))[0, 1] > 0.9, (first, turned)


def test_roads_that_are_all_alike_tell_nothing() -> None:
    vectors, model = np.random.default_rng(0).random((30, BENDS)), BendModel()
    model.fit(vectors, vectors, 0.0 * road_of_bends(), vectors[:, 0])
    assert not model.is_fit


def told(model: FailureModel, first: int, sharp: Floats, found: Floats) -> None:
    vectors = two_bends(first, sharp)
    curvature = vectors @ road_of_bends()[1:]
    model.tell(vectors, found, np.column_stack([curvature, np.zeros((len(sharp), 3))]))


def test_the_bends_count_before_something_fails_and_after() -> None:
    random, model = np.random.default_rng(0), FailureModel()
    sharp, other = random.uniform(-1, 1, (120, 2)), random.uniform(-1, 1, (60, 2))
    alone = sharp[:40] * np.repeat(np.eye(2), 20, axis=0)
    elsewhere = two_bends(7, other)

    def agreement() -> float:
        model.fit()
        return float(np.corrcoef(model.predicted(elsewhere, 0.0)[0], values(other))[0, 1])

    told(model, 2, sharp, values(sharp))
    told(model, 7, alone, values(alone))
    assert agreement() > 0.5
    told(model, 2, np.array([[1.0, -1.0]]), np.array([-0.5]))
    assert agreement() > 0.5
