"""Who keeps to a lane needs more than it only where its bend leaves less than half of the gap
between two that pass: with numba and without."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from roadlang.geometry.curves.bend_room import LONG, PASSING_GAP
from roadlang.simulation.traffic import meeting_ways, wide_places

WIDTH, SPARE, LENGTH = 2.0, 0.5, 5.0
ROAD = 2.0 * (0.5 * WIDTH + SPARE + 0.5 * PASSING_GAP)
"""meters: a car of that width has so much to spare in its lane"""


def by_rows(swept: float, routed: bool, length: float) -> bool:
    bodies = SimpleNamespace(width=np.array([WIDTH]), length=np.array([length]))
    world: Any = SimpleNamespace(bodies=bodies, has_route=np.array([routed]))
    agents, columns = np.array([0]), np.array([[swept]])
    return bool(wide_places.is_wide(world, agents, columns, np.array([[ROAD]]))[0, 0])


def by_loops(swept: float, routed: bool, length: float) -> bool:
    one = np.ones(1)
    flags = (None, None, None, np.array([routed]))
    cells = np.array([[0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, ROAD]])
    numbers = np.array([[0.0], [0.0], [1.0], [1.0]])
    track = (one, 100.0 * one, np.array([0]), numbers, cells)
    sweeps = (np.array([0]), np.array([[swept]]), np.zeros((1, 1)))
    ways, found = np.zeros((6, 1, 1)), np.zeros((1, 1), bool)
    sizes = (length * one, WIDTH * one)
    meeting_ways.sample(flags, sizes, track, sweeps, (0, 0, 0), ways, found)
    return bool(found[0, 0])


@pytest.mark.parametrize("is_wide", [by_rows, by_loops])
def test_half_of_the_gap_of_two_that_pass_stays_free(is_wide: Any) -> None:
    assert SPARE > wide_places.LEAST_SWEPT
    assert not is_wide(SPARE - 0.001, True, LENGTH)
    assert is_wide(SPARE + 0.001, True, LENGTH)


@pytest.mark.parametrize("is_wide", [by_rows, by_loops])
@pytest.mark.parametrize(("routed", "length"), [(False, LENGTH), (True, LONG + 0.1)])
def test_long_vehicles_and_those_in_no_lane_have_nothing_to_spare(
    is_wide: Any, routed: bool, length: float
) -> None:
    assert not is_wide(wide_places.LEAST_SWEPT - 0.001, routed, length)
    assert is_wide(wide_places.LEAST_SWEPT + 0.001, routed, length)
