"""Who asks to go, at which junction, and what is in its way there."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..junctions.crossings import STOP_GAP
from .approaches import COMFORTABLE, braking_to_stop, horizon
from .crowd import Crowd
from .grants import NEVER

BOOKING, SHORT_BOOKING = 4.0, 1.0
"""Seconds ahead of its arrival that one asks to go, and one that yields."""
SEEN = 6.5
"""Seconds ahead of its arrival that those who yield to one see it come."""
TAIL_TIME = 2.0
"""Seconds for which who is ahead of the junction makes room."""
SLOWEST = 1.0
"""m/s: when a slower one arrives is computed as if it went this fast."""
SLACK = 0.5
"""Meters by which the tail of who counts as beyond a junction may still be in it."""


@dataclass(frozen=True)
class Asking:
    """Columns (N,): who asks to go at which of its crossings, the first that it may not cross."""

    asks: Booleans
    comes: Booleans
    """who asks, or would if it did not yield: others see it come"""
    slot: Integers
    each: Integers
    """their numbers"""
    is_first: Booleans
    """whether nobody is ahead in the lane, or only who may go at the same junction, and nothing
    stands in the way before the line: who waits there would keep others from going"""
    room: Floats
    """free meters of the lane beyond the junction, up to the next agent there; of those who ask"""

    @classmethod
    def of(cls, crowd: Crowd) -> Asking:
        """Of all agents. When one first asks is noted; what nobody may go at any more is taken
        back."""
        _take_back(crowd)
        near, grants, entrants = crowd.near, crowd.grants, crowd.entrants
        distance = np.where(near.is_over | crowd.held, math.inf, near.to_line)
        slot, each = distance.argmin(axis=1), entrants.each
        distance = distance[each, slot]
        short = entrants.is_short[each, slot]
        ahead = horizon(crowd.speed, np.where(short, SHORT_BOOKING, BOOKING))
        takes_part = crowd.is_moving & crowd.obeys
        asks = takes_part & (distance < ahead)
        comes = takes_part & (distance < horizon(crowd.speed, SEEN))
        fresh = (asks & (grants.arrival[each, slot] == NEVER)).nonzero()[0]
        if len(fresh):
            arrival = crowd.time + distance[fresh] / np.maximum(crowd.speed[fresh], SLOWEST)
            grants.arrival[fresh, slot[fresh]] = arrival
        if not np.count_nonzero(asks):
            return cls(asks, comes, slot, each, np.zeros(len(asks), dtype=bool), distance)
        is_first = _is_first(crowd, slot, distance)
        return cls(asks, comes, slot, each, is_first, _room(crowd, asks, slot))

    def of_crossings(self, values: np.ndarray) -> np.ndarray:
        """(N,) of an array (N, X), at the crossing that each asks for."""
        return np.asarray(values[self.each, self.slot])


def _take_back(crowd: Crowd) -> None:
    """Somebody has come before one that was let go, and was not itself: it would wait for all who
    wait for the one behind it. Or an object stands there."""
    held = crowd.held
    if not np.count_nonzero(held):
        return
    near, (leader, gap) = crowd.near, crowd.ahead
    stops = braking_to_stop(crowd.speed[:, None], near.to_line - STOP_GAP) < COMFORTABLE
    stops &= crowd.obeys[:, None]
    crowd.grants.order[held & stops & (near.to_line > crowd.objects[:, None])] = NEVER
    behind = held & (near.to_line > (gap + crowd.entrants.length[leader])[:, None])
    if not np.count_nonzero(behind):
        return
    behind &= stops
    junction = crowd.entrants.ways.crossings.junction
    waits_too = np.zeros(held.shape, dtype=bool)
    for row, slot in zip(*np.nonzero(behind), strict=True):
        there = junction[leader[row]] == junction[row, slot]
        waits_too[row, slot] = (there & ~held[leader[row]]).any()
    crowd.grants.order[waits_too] = NEVER


def _is_first(crowd: Crowd, slot: Integers, distance: Floats) -> Booleans:
    """(N,) `Asking.is_first`."""
    leader, gap = crowd.ahead
    crossed = crowd.entrants.ways.crossings.junction
    same = crossed[leader] == crossed[crowd.entrants.each, slot][:, None]
    leader_goes = (crowd.held[leader] & same).any(axis=1)
    free = (gap > distance) | leader_goes
    return np.asarray(free & (crowd.objects > distance))


def _room(crowd: Crowd, asks: Booleans, slot: Integers) -> Floats:
    """(N,) `Asking.room`."""
    beyond = crowd.near.to_leave[crowd.entrants.each, slot] - crowd.entrants.length
    beyond = np.where(asks, beyond, 0.0)[:, None]
    tail = crowd.gaps + TAIL_TIME * np.maximum(crowd.of_mates(crowd.speed), 0.0)
    tail = np.where(crowd.gaps > beyond - SLACK, tail, math.inf)
    return np.asarray(tail.min(axis=1) - beyond[:, 0])
