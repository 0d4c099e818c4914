"""For whom one that may go already leaves no gap, beside a loop over pairs."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from roadlang.plugins.kinds import STANDING_GAP
from roadlang.simulation.traffic import rules
from roadlang.simulation.traffic.approaches import seconds_for
from roadlang.simulation.traffic.grants import NEVER, Grants
from roadlang.simulation.traffic.junction_tables import CROSS, MERGE
from roadlang.simulation.traffic.meetings import Meetings

PLACES = 4


def meetings(rng: np.random.Generator, groups: int, kinds: tuple[int, ...]) -> Meetings:
    """Of agents (G, P), some of which are padding, whose ways conflict in some of these ways."""
    shape = groups, PLACES
    is_there = rng.random(shape) < 0.8
    both = is_there[:, :, None] & is_there[:, None, :] & ~np.eye(PLACES, dtype=bool)
    begin = rng.uniform(0.0, 8.0, (*shape, PLACES))
    return Meetings(
        np.arange(groups), np.arange(groups * PLACES).reshape(shape),
        np.zeros(shape, dtype=np.int64), is_there,
        np.where(both, rng.choice((0, *kinds), (*shape, PLACES)), 0), begin,
        begin + rng.uniform(2.0, 9.0, begin.shape), both, np.zeros(shape, dtype=np.int64),
    )  # fmt: skip


def expected(found: Meetings, near: Any, grants: Grants, agents: Any) -> np.ndarray:
    """The rules as sentences have them."""
    blocked = np.zeros(found.is_there.shape, dtype=bool)
    for group, a, b in np.ndindex(len(found.row), PLACES, PLACES):
        one, other = found.row[group, a], found.row[group, b]
        goes = found.is_there[group, b] and grants.order[other, 0] < NEVER
        if not goes:
            continue
        calm = 1.0 - agents.aggression[one]
        if found.conflict[group, a, b] == CROSS:
            way = near.to_line[one, 0] + found.begin[group, a, b]
            left = near.to_line[other, 0] + found.end[group, b, a] + agents.length[other]
            arrives, leaves = (
                float(seconds_for(np.array(meters), np.array(speed), *how))
                for meters, speed, how in (
                    (way, agents.speed[one], (rules.EAGER, rules.EAGER_SPEED)),
                    (left, agents.speed[other], (rules.SLUGGISH, rules.SLUGGISH_SPEED)),
                )
            )
            blocked[group, a] |= left > 0.0 and arrives <= leaves + rules.CLEARANCE * calm
        elif found.conflict[group, a, b] == MERGE:
            gap = near.to_leave[one, 0] - agents.length[one] - near.to_leave[other, 0]
            faster = max(0.0, agents.speed[one] - agents.speed[other])
            keeps = STANDING_GAP + rules.HEADWAY * calm * agents.speed[one] + faster
            blocked[group, a] |= gap <= keeps
    return blocked


@pytest.mark.parametrize("kinds", [(CROSS,), (MERGE,), (CROSS, MERGE)])
@pytest.mark.parametrize("seed", range(3))
def test_who_would_come_too_close_waits(kinds: tuple[int, ...], seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = meetings(rng, 40, kinds)
    count = found.row.size
    to_line = rng.uniform(-12.0, 40.0, (count, 1))
    near: Any = SimpleNamespace(to_line=to_line, to_leave=to_line + rng.uniform(8, 30, (count, 1)))
    grants = Grants.none((count, 1))
    grants.order[rng.random(count) < 0.5] = 3.0
    agents: Any = SimpleNamespace(
        speed=rng.uniform(0.0, 15.0, count), length=rng.uniform(2.0, 12.0, count),
        aggression=rng.random(count),
    )  # fmt: skip
    wanted = expected(found, near, grants, agents)
    assert 0 < wanted.sum() < found.is_there.sum()
    blocked = rules.is_blocked(found, near, grants, agents.speed, agents.length, agents.aggression)
    np.testing.assert_array_equal(blocked, wanted)


def test_nobody_waits_for_whom_nobody_let_go() -> None:
    found = meetings(np.random.default_rng(0), 10, (CROSS, MERGE))
    count = found.row.size
    near: Any = SimpleNamespace(to_line=np.zeros((count, 1)), to_leave=np.zeros((count, 1)))
    still = np.zeros(count)
    assert not rules.is_blocked(found, near, Grants.none((count, 1)), still, still, still).any()
