"""Roads that are moved by hand: each place goes where it is moved, what is far from it stays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.api import BatchRandom, OptionError, RoadBatch
from roadlang_standard.perturb_nudges import Nudges

ONE = BatchRandom(np.ones(1, np.uint64))


def nudges(at: Sequence[Any], by: Sequence[Any]) -> Nudges:
    return Nudges(at, by, 60.0)  # type: ignore[arg-type]


@given(at=st.floats(0, 200), east=st.floats(-20, 20), north=st.floats(-20, 20))
def test_a_place_moves_as_told_and_no_other_moves_more(
    straight: RoadBatch, at: float, east: float, north: float
) -> None:
    moves = nudges([at], [(east, north)]).displacements(straight, ONE)[0]
    there = [np.interp(at, straight.stations, column) for column in moves.T]
    np.testing.assert_allclose(there, (east, north), rtol=0.002, atol=1e-9)
    away = np.abs(straight.stations - at)
    assert (moves[away >= 30.0] == 0.0).all()
    assert np.hypot(*moves.T).max() <= np.hypot(east, north) + 1e-9


def test_places_that_are_near_each_other_add_up(straight: RoadBatch) -> None:
    both = nudges([90.0, 100.0], [(0.0, 2.0), (1.0, 1.0)]).displacements(straight, ONE)
    alone = [nudges([at], [by]).displacements(straight, ONE)
             for at, by in ((90.0, (0.0, 2.0)), (100.0, (1.0, 1.0)))]  # fmt: skip
    np.testing.assert_allclose(both, alone[0] + alone[1])


def test_a_closed_road_has_no_seam(ring: RoadBatch) -> None:
    moves = nudges([0.0], [(-3.0, 2.0)]).displacements(ring, ONE)[0]
    steps = np.abs(np.diff(moves, axis=0)).max()
    assert np.abs(moves[0] - moves[-1]).max() <= 1.5 * steps
    assert np.hypot(*moves[-1]) > 3.0


def test_numbers_may_be_drawn_for_each_variant(straight: RoadBatch) -> None:
    column = np.array([[0.0], [2.0], [4.0]])
    moves = nudges([50.0 + column], [(0.0, column)]).displacements(straight, ONE)
    assert moves.shape == (3, len(straight.stations), 2)
    np.testing.assert_allclose(moves[:, :, 1].max(axis=1), column[:, 0], atol=0.01)


def test_each_place_needs_a_displacement() -> None:
    with pytest.raises(OptionError, match="`by` has 1 moves, but `at` has 2 places"):
        nudges([10.0, 20.0], [(1.0, 1.0)])
