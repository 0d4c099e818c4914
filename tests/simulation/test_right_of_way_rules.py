"""The rules of right of way, beside loops over pairs that say them as sentences do."""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from roadlang.geometry.arrays import Booleans, Floats
from roadlang.plugins.kinds import STANDING_GAP
from roadlang.simulation.traffic import rules
from roadlang.simulation.traffic.approaches import braking_to_stop, horizon, seconds_for
from roadlang.simulation.traffic.grants import NEVER, Grants
from roadlang.simulation.traffic.junction_tables import CROSS, MERGE
from roadlang.simulation.traffic.meetings import Meetings
from roadlang.simulation.traffic.swept_paths import SPACING

GROUPS, PLACES = 60, 4
COUNT = GROUPS * PLACES
KINDS = [(CROSS,), (MERGE,), (CROSS, MERGE)]


@dataclass(frozen=True)
class Drawn:
    """Groups of agents that meet, some of which are padding: one crossing each."""

    meetings: Meetings
    near: Any
    grants: Grants
    asks: Booleans
    speed: Floats
    length: Floats
    temper: Floats

    @classmethod
    def of(cls, seed: int, kinds: tuple[int, ...] = KINDS[-1]) -> Drawn:
        rng = np.random.default_rng(seed)
        shape = GROUPS, PLACES
        is_there = rng.random(shape) < 0.8
        both = is_there[:, :, None] & is_there[:, None, :] & ~np.eye(PLACES, dtype=bool)
        begin = rng.uniform(0.0, 8.0, both.shape)
        meetings = Meetings(
            np.arange(GROUPS), np.arange(COUNT).reshape(shape), np.zeros(shape, dtype=np.int64),
            is_there, np.where(both, rng.choice((0, *kinds), both.shape), 0), begin,
            begin + rng.uniform(2.0, 9.0, both.shape), both & (rng.random(both.shape) < 0.5),
            np.zeros(shape, dtype=np.int64),
        )  # fmt: skip
        to_line = rng.uniform(-12.0, 40.0, (COUNT, 1))
        near = SimpleNamespace(
            to_line=to_line, to_leave=to_line + rng.uniform(8.0, 30.0, to_line.shape)
        )
        grants = Grants.none((COUNT, 1))
        may_go = rng.random(COUNT) < 0.5
        grants.order[may_go, 0] = rng.integers(0, 3, may_go.sum())
        grants.waiting[:, 0] = rng.choice([0.0, 2.9, 3.0, 3.1, 14.9, 15.0, 15.1, 20.0], COUNT)
        speed, length = rng.uniform(0.0, 15.0, COUNT), rng.uniform(2.0, 12.0, COUNT)
        asks = is_there & (rng.random(shape) < 0.7)
        return cls(meetings, near, grants, asks, speed, length, rng.random(COUNT))

    def pairs(self) -> Any:
        """Group, first and second, and the numbers of the agents: of different ones that are
        there."""
        there = self.meetings.is_there
        for group, a, b in np.ndindex(GROUPS, PLACES, PLACES):
            if a != b and there[group, a] and there[group, b]:
                yield (group, a, b, *self.meetings.row[group, [a, b]].tolist())

    def goes(self, agent: int) -> bool:
        return bool(self.grants.order[agent, 0] < NEVER)

    def way(self, agent: int) -> float:
        return float(self.near.to_line[agent, 0])

    def left_by(self, group: int, a: int, b: int, other: int) -> float:
        """Meters until the rear of the second has left the ground that the first needs."""
        return float(self.way(other) + self.meetings.end[group, b, a] + self.length[other])

    def behind(self, one: int, other: int) -> float:
        """Meters between the rear of the second and the front of the first where lanes merge."""
        leave = self.near.to_leave[:, 0]
        return float(leave[one] - self.length[one] - leave[other])


def nowhere() -> Booleans:
    return np.zeros((GROUPS, PLACES), dtype=bool)


def seconds(meters: float, speed: float, acceleration: float, fastest: float) -> float:
    return float(seconds_for(np.array(meters), np.array(speed), acceleration, fastest))


@pytest.mark.parametrize("kinds", KINDS)
@pytest.mark.parametrize("seed", range(2))
def test_who_would_come_too_close_to_one_that_may_go_waits(
    kinds: tuple[int, ...], seed: int
) -> None:
    drawn = Drawn.of(seed, kinds)
    found, expected = drawn.meetings, nowhere()
    for group, a, b, one, other in drawn.pairs():
        if not drawn.goes(other):
            continue
        calm, kind = 1.0 - drawn.temper[one], found.conflict[group, a, b]
        if kind == CROSS:
            left = drawn.left_by(group, a, b, other)
            way = drawn.way(one) + found.begin[group, a, b]
            arrives = seconds(way, drawn.speed[one], rules.EAGER, rules.EAGER_SPEED)
            leaves = seconds(left, drawn.speed[other], rules.SLUGGISH, rules.SLUGGISH_SPEED)
            expected[group, a] |= left > 0.0 and arrives <= leaves + rules.CLEARANCE * calm
        elif kind == MERGE:
            faster = max(0.0, drawn.speed[one] - drawn.speed[other])
            keeps = STANDING_GAP + rules.HEADWAY * calm * drawn.speed[one] + faster
            expected[group, a] |= drawn.behind(one, other) <= keeps
    assert 0 < expected.sum() < found.is_there.sum()
    blocked = rules.is_blocked(
        found, drawn.near, drawn.grants, drawn.speed, drawn.length, drawn.temper
    )
    np.testing.assert_array_equal(blocked, expected)


@pytest.mark.parametrize("seed", range(3))
def test_nobody_goes_where_one_that_waits_stands_in_the_way(seed: int) -> None:
    """Two that stand in each other's way do not keep each other from going."""
    drawn = Drawn.of(seed)
    found, expected = drawn.meetings, nowhere()

    def stands(group: int, a: int, b: int) -> bool:
        other = found.row[group, b]
        waits = drawn.asks[group, b] and not drawn.goes(other)
        into = -drawn.way(other) - found.begin[group, b, a]
        return bool(found.conflict[group, a, b] == CROSS and waits and into > SPACING)

    for group, a, b, _, _ in drawn.pairs():
        expected[group, a] |= stands(group, a, b) and not stands(group, b, a)
    assert expected.any()
    occupied = rules.is_occupied(found, drawn.near, drawn.grants, drawn.asks)
    np.testing.assert_array_equal(occupied, expected)


@pytest.mark.parametrize("seed", range(3))
def test_all_yield_to_who_has_waited_longest(seed: int) -> None:
    drawn = Drawn.of(seed)
    found, expected = drawn.meetings, nowhere()
    could = drawn.asks
    able = could & (np.random.default_rng(seed).random(could.shape) < 0.5)
    for group in range(GROUPS):
        waited = [
            drawn.grants.waiting[found.row[group, a], 0] * could[group, a] for a in range(PLACES)
        ]
        longest = waited.index(max(waited))
        for a in range(PLACES):
            if a != longest and waited[longest] > rules.LONGEST_WAIT:
                meets = found.conflict[group, a, longest] > 0
                expected[group, a] = meets or not able[group, longest]
    assert expected.any()
    np.testing.assert_array_equal(rules.is_reserved(found, drawn.grants, could, able), expected)
    drawn.grants.waiting[:] = rules.LONGEST_WAIT
    assert not rules.is_reserved(found, drawn.grants, could, able).any()


@pytest.mark.parametrize("seed", range(3))
def test_one_goes_after_whom_it_yields_to_if_that_one_comes_before_it_has_left(seed: int) -> None:
    drawn = Drawn.of(seed)
    found = drawn.meetings
    expected = np.zeros(found.yields.shape, dtype=bool)
    turns = np.random.default_rng(seed).random(found.is_there.shape) < 0.5
    for group, a, b, one, other in drawn.pairs():
        speed, bold = drawn.speed[one], drawn.temper[one]
        slow = min(speed, rules.SLUGGISH_SPEED) if turns[group, a] else speed
        way = drawn.way(one)
        mean = max(0.5 * (speed + slow), 0.5 * rules.SLUGGISH_SPEED)
        ground = min(way, 0.0) + found.end[group, a, b] + drawn.length[one]
        pace = rules.SLUGGISH + bold * (rules.EAGER - rules.SLUGGISH)
        leaves = max(way, 0.0) / mean + seconds(ground, slow, pace, rules.SLUGGISH_SPEED)
        leaves += rules.EASE * (1.0 - bold)
        meters = drawn.way(other) + found.begin[group, b, a]
        comes = meters < leaves * drawn.speed[other] + rules.FROM_RIGHT_DISTANCE
        least = rules.FROM_RIGHT * drawn.speed[other] + rules.FROM_RIGHT_DISTANCE
        expected[group, a, b] = found.yields[group, a, b] and (comes or drawn.way(other) < least)
    assert 0 < expected.sum() < found.yields.sum()
    after = rules.goes_after(found, drawn.near, turns, drawn.speed, drawn.length, drawn.temper)
    np.testing.assert_array_equal(after, expected)


@pytest.mark.parametrize("seed", range(3))
def test_the_polite_let_in_who_has_waited_where_lanes_merge(seed: int) -> None:
    drawn = Drawn.of(seed)
    found, expected, waiting = drawn.meetings, nowhere(), drawn.grants.waiting[:, 0]
    for group, a, b, one, other in drawn.pairs():
        meets = found.conflict[group, a, b] == MERGE and found.yields[group, b, a]
        has_waited = drawn.asks[group, b] and waiting[other] > rules.PATIENCE
        way = drawn.way(one) - rules.BEFORE_ZONE
        braking = float(braking_to_stop(drawn.speed[[one]], np.array([way]))[0])
        gentle = braking < rules.COURTEOUS * drawn.temper[one]
        patient = waiting[one] <= rules.LONGEST_WAIT
        expected[group, a] |= bool(meets and has_waited and gentle and patient)
    assert expected.any()
    lets = rules.lets_in(found, drawn.near, drawn.grants, drawn.asks, drawn.speed, drawn.temper)
    np.testing.assert_array_equal(lets, expected)


@pytest.mark.parametrize("kinds", KINDS)
@pytest.mark.parametrize("seed", range(2))
def test_who_was_let_go_later_stops_before_the_way_of_the_earlier_or_follows_it(
    kinds: tuple[int, ...], seed: int
) -> None:
    drawn = Drawn.of(seed, kinds)
    found, order = drawn.meetings, drawn.grants.order[:, 0]
    stops = np.full((GROUPS, PLACES, PLACES), math.inf)
    gaps = stops.copy()
    for group, a, b, one, other in drawn.pairs():
        is_earlier = (order[other], other) < (order[one], one) and drawn.goes(other)
        kind = found.conflict[group, a, b]
        zone = drawn.way(one) + found.begin[group, a, b]
        if is_earlier and kind == CROSS and drawn.left_by(group, a, b, other) > 0.0:
            stops[group, a, b] = zone - rules.BEFORE_ZONE if zone > -rules.IN_ZONE else math.inf
        elif is_earlier and kind == MERGE and drawn.goes(one):
            behind = drawn.behind(one, other)
            if behind < zone - rules.BEFORE_ZONE:
                stops[group, a, b] = zone - rules.BEFORE_ZONE
            else:
                gaps[group, a, b] = behind
    result = rules.zone_stops(found, drawn.near, drawn.grants, drawn.length)
    assert result is not None
    np.testing.assert_allclose(result[0], stops)
    np.testing.assert_allclose(result[1], gaps)


def test_where_nobody_was_let_go_nobody_waits_for_anybody() -> None:
    drawn = Drawn.of(0)
    drawn.grants.order[:] = NEVER
    none = rules.is_blocked(
        drawn.meetings, drawn.near, drawn.grants, drawn.speed, drawn.length, drawn.temper
    )
    assert not none.any()
    assert rules.zone_stops(drawn.meetings, drawn.near, drawn.grants, drawn.length) is None


@pytest.mark.parametrize("fastest", [8.0, 12.0])
@pytest.mark.parametrize("speed", [0.0, 3.0, 8.0, 11.0])
@pytest.mark.parametrize("distance", [-3.0, 0.0, 1.0, 12.0, 60.0])
def test_seconds_for_a_distance_are_those_of_small_steps(
    distance: float, speed: float, fastest: float
) -> None:
    step, now, gone, passed = 1e-3, speed, 0.0, 0.0
    while gone < distance:
        faster = max(now, min(now + 2.0 * step, fastest))
        gone, now, passed = gone + 0.5 * (now + faster) * step, faster, passed + step
    assert seconds(distance, speed, 2.0, fastest) == pytest.approx(passed, abs=2e-3)


def test_a_car_asks_to_go_from_where_it_could_still_stop() -> None:
    assert horizon(np.array([0.0, 6.0, 12.0]), 2.0).tolist() == [6.0, 24.0, 54.0]
    assert braking_to_stop(np.array([10.0, 10.0]), np.array([25.0, -1.0])).tolist() == [2.0, 1000.0]
