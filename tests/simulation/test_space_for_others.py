"""How much of the lane behind a junction others will take, beside a loop over them."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.geometry import Floats
from roadlang.plugins.kinds import STANDING_GAP
from roadlang.simulation.traffic.meetings import Meetings
from roadlang.simulation.traffic.rules import space_for_others

PLACES = 4


def meetings(rng: np.random.Generator, groups: int) -> Meetings:
    """Of agents (G, P), some of which are padding, who enter one of three lanes."""
    shape = groups, PLACES
    rows = np.arange(groups * PLACES).reshape(shape)
    nothing = np.zeros((*shape, PLACES))
    return Meetings(
        np.arange(groups), rows, np.zeros(shape, dtype=np.int64), rng.random(shape) < 0.8,
        nothing.astype(np.int64), nothing, nothing, nothing.astype(bool), rng.integers(0, 3, shape),
    )  # fmt: skip


def expected(found: Meetings, may_go: np.ndarray, length: Floats) -> Floats:
    space = np.zeros(may_go.shape)
    for group, one, other in np.ndindex(len(may_go), PLACES, PLACES):
        both = found.is_there[group, one] and found.is_there[group, other] and one != other
        if both and found.target[group, one] == found.target[group, other] and may_go[group, other]:
            space[group, one] += length[found.row[group, other]] + STANDING_GAP
    return space


@pytest.mark.parametrize("seed", range(3))
def test_those_let_go_into_the_same_lane_take_their_length_and_a_gap(seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = meetings(rng, 6)
    may_go = found.is_there & (rng.random(found.is_there.shape) < 0.6)
    length = rng.uniform(2.0, 12.0, found.row.size)
    wanted = expected(found, may_go, length)
    assert wanted.any()
    np.testing.assert_allclose(space_for_others(found, may_go, length), wanted)
    assert found.shares_any == bool(expected(found, found.is_there, np.ones(found.row.size)).any())
    assert not space_for_others(found, np.zeros_like(may_go), length).any()


def test_who_is_alone_shares_nothing() -> None:
    alone = meetings(np.random.default_rng(0), 1)
    alone.is_there[:] = [[True, False, False, False]]
    assert not alone.shares_any
