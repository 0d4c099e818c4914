"""Letting agents go: at each junction at most one at a time, by class, arrival and number."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...plugins.kinds import STANDING_GAP
from ..crossings import STOP_GAP
from . import rules
from .approaches import COMFORTABLE, braking_to_stop, horizon
from .crowd import Crowd
from .grants import NEVER
from .junction_tables import ALL_WAY_STOP
from .meetings import Meetings

BOOKING, SHORT_BOOKING = 4.0, 1.0
"""Seconds ahead of its arrival that one asks to go, and one that yields."""
WAVED_THROUGH = 1.0
"""Seconds after which, where all wait for each other, the first goes."""
TAIL_TIME = 2.0
"""Seconds for which who is ahead of the junction makes room."""


@dataclass(frozen=True)
class Asking:
    """Columns (N,): who asks to go at which of its crossings, the first that it may not cross."""

    asks: Booleans
    slot: Integers
    distance: Floats
    """meters to the line"""

    @classmethod
    def of(cls, crowd: Crowd) -> Asking:
        """Of all agents. When one first asks is noted."""
        near, grants, tables = crowd.near, crowd.grants, crowd.places.tables
        distance = np.where(~near.is_over & ~crowd.held, near.to_line, math.inf)
        slot = distance.argmin(axis=1)
        each = np.arange(len(slot))
        distance, number = distance[each, slot], near.number[each, slot]
        short = tables.yields_any[number] | tables.must_stop[number]
        ahead = horizon(crowd.speed, np.where(short, SHORT_BOOKING, BOOKING))
        asks = crowd.is_moving & crowd.obeys & (distance < ahead)
        fresh = np.flatnonzero(asks & (grants.arrival[each, slot] == NEVER))
        arrival = crowd.time + distance[fresh] / np.maximum(crowd.speed[fresh], 1.0)
        grants.arrival[fresh, slot[fresh]] = arrival
        return cls(asks, slot, distance)

    def of_crossings(self, values: np.ndarray) -> np.ndarray:
        """(N,) of an array (N, X), at the crossing that each asks for."""
        return np.asarray(values[np.arange(len(self.slot)), self.slot])


def let_go(crowd: Crowd, last_grant: Floats) -> Booleans:
    """Let at most one agent go at each junction; `last_grant` (S, J) is when somebody was. (N, X)
    which crossings were asked for."""
    _take_back(crowd)
    asking = Asking.of(crowd)
    wanted = np.zeros(crowd.held.shape, dtype=bool)
    if not asking.asks.any():
        return wanted
    askers = np.flatnonzero(asking.asks)
    wanted[askers, asking.slot[askers]] = True
    meetings = crowd.meetings(wanted | crowd.held)
    wants = meetings.is_there & meetings.of_crossings(wanted)
    is_first = _is_first(crowd, asking)
    could = _could(crowd, asking, meetings, wants, is_first)
    able = could & _is_free(crowd, asking, meetings, wants)
    count = len(crowd.places.by_right)
    scene, junction = meetings.key // count, meetings.key % count
    # Who waits for somebody that comes toward it cannot be helped by others that wait too.
    in_line = could & crowd.places.by_patience[junction][:, None]
    in_line &= _meets_nobody(crowd, asking, meetings)
    able &= ~rules.is_reserved(meetings, crowd.grants, in_line, able)
    by_right = crowd.places.by_right[junction]
    arriving = wants & meetings.of_agents(is_first)
    right = rules.waits_for_right(meetings, crowd.near, arriving, crowd.speed)
    passes = able & ~(by_right[:, None] & right)
    stuck = by_right & ~passes.any(axis=1)
    wave = stuck & (crowd.time - last_grant[scene, junction] > WAVED_THROUGH)
    passes |= able & wave[:, None]
    rank = np.where(passes, _rank(crowd, asking, meetings, wave), len(asking.slot))
    chosen = np.flatnonzero(passes.any(axis=1))
    best = rank[chosen].argmin(axis=1)
    crowd.grants.order[meetings.row[chosen, best], meetings.slot[chosen, best]] = crowd.time
    last_grant[scene[chosen], junction[chosen]] = crowd.time
    return wanted


def _take_back(crowd: Crowd) -> None:
    """Somebody has come before one that was let go, and was not itself: it would wait for all who
    wait for the one behind it."""
    near, ahead, slots = crowd.near, crowd.gaps.argmin(axis=1), crowd.gaps.shape[1]
    each = np.arange(len(ahead))
    leader = each // slots * slots + ahead
    junction = crowd.crossings.junction
    waits_too = np.zeros(crowd.held.shape, dtype=bool)
    behind = crowd.held & (
        near.to_line > crowd.gaps[each, ahead][:, None] + crowd.length[leader][:, None]
    )
    behind &= braking_to_stop(crowd.speed[:, None], near.to_line - STOP_GAP) < COMFORTABLE
    for row, slot in zip(*np.nonzero(behind & crowd.obeys[:, None]), strict=True):
        there = junction[leader[row]] == junction[row, slot]
        waits_too[row, slot] = (there & ~crowd.held[leader[row]]).any()
    crowd.grants.order[waits_too] = NEVER


def _could(
    crowd: Crowd, asking: Asking, meetings: Meetings, wants: Booleans, is_first: Booleans
) -> Booleans:
    """(G, P) who may go, but for others on the junction."""
    near, grants, tables = crowd.near, crowd.grants, crowd.places.tables
    number = asking.of_crossings(near.number)
    stopped = asking.of_crossings(grants.has_stopped) | ~tables.must_stop[number]
    may = asking.asks & asking.of_crossings(near.may_go) & stopped & is_first
    may &= ~_ring_is_full(crowd, number)
    may_go = rules.let_go(meetings, grants)
    used = rules.space_for_others(meetings, may_go, crowd.length)
    free = meetings.of_agents(_room(crowd, asking) - crowd.length) - used
    return np.asarray(wants & meetings.of_agents(may) & (free >= STANDING_GAP))


def _is_free(crowd: Crowd, asking: Asking, meetings: Meetings, wants: Booleans) -> Booleans:
    """(G, P) whose way is free of others, but for who comes from the right."""
    near, grants = crowd.near, crowd.grants
    free = _meets_nobody(crowd, asking, meetings)
    free &= ~rules.is_occupied(meetings, near, grants, wants)
    motion = crowd.speed, crowd.length, crowd.aggression
    free &= ~rules.is_blocked(meetings, near, grants, *motion)
    polite = rules.lets_in(meetings, near, grants, wants, crowd.speed, crowd.politeness)
    return np.asarray(free & ~polite)


def _meets_nobody(crowd: Crowd, asking: Asking, meetings: Meetings) -> Booleans:
    """(G, P) who waits for nobody in a narrow place before it has left the junction."""
    return meetings.of_agents(crowd.oncoming > asking.of_crossings(crowd.near.to_leave))


def _is_first(crowd: Crowd, asking: Asking) -> Booleans:
    """(N,) whether nobody is ahead in the lane, or only who may go at the same junction."""
    slots = crowd.gaps.shape[1]
    ahead = crowd.gaps.argmin(axis=1)
    each = np.arange(len(ahead))
    gap = crowd.gaps[each, ahead]
    leader = each // slots * slots + ahead
    junction = asking.of_crossings(crowd.crossings.junction)
    same = crowd.crossings.junction[leader] == junction[:, None]
    leader_goes = (crowd.held[leader] & same).any(axis=1)
    return np.asarray((gap > asking.distance) | leader_goes)


def _room(crowd: Crowd, asking: Asking) -> Floats:
    """(N,) free meters of the lane beyond the junction, up to the next agent there."""
    beyond = asking.of_crossings(crowd.near.to_leave) - crowd.length
    beyond = np.where(asking.asks, beyond, 0.0)[:, None]
    tail = crowd.gaps + TAIL_TIME * np.maximum(crowd.of_mates(crowd.speed), 0.0)
    tail = np.where(crowd.gaps > beyond - 0.5, tail, math.inf)
    return np.asarray(tail.min(axis=1) - beyond[:, 0])


def _ring_is_full(crowd: Crowd, number: Integers) -> Booleans:
    """(N,) whether the connection `number` leads into a ring that has no more room."""
    rings = crowd.places.rings
    if not len(rings.capacity):
        return np.zeros(len(number), dtype=bool)
    entered = (crowd.held | crowd.near.is_over) & (crowd.crossings.junction >= 0)
    slots = np.arange(entered.shape[1])
    last = np.where(entered, slots, -1).max(axis=1)
    each = np.arange(len(last))
    on = np.where(last >= 0, rings.onward[crowd.near.number[each, last]], -1)
    first = int(crowd.scene.min(initial=0))
    counts = np.zeros((int(crowd.scene.max(initial=0)) - first + 1, len(rings.capacity)))
    inside = np.flatnonzero((on >= 0) & crowd.present)
    np.add.at(counts, (crowd.scene[inside] - first, on[inside]), 1.0)
    into = rings.into[number]
    return np.asarray((into >= 0) & (counts[crowd.scene - first, into] >= rings.capacity[into]))


def _rank(crowd: Crowd, asking: Asking, meetings: Meetings, wave: Booleans) -> Integers:
    """(G, P) the order in which agents are let go: who yields to nobody first, then by arrival;
    where all wait for each other (`wave`, (G,)) by arrival alone."""
    tables = crowd.places.tables
    number = asking.of_crossings(crowd.near.number)
    in_turn = tables.rule[np.maximum(asking.of_crossings(crowd.crossings.junction), 0)]
    yields = tables.yields_any[number] & (in_turn != ALL_WAY_STOP)
    arrival = asking.of_crossings(crowd.grants.arrival)
    each = np.arange(len(arrival))
    ranks = []
    for keys in ((each, arrival, yields), (each, arrival)):
        rank = np.empty(len(each), dtype=np.int64)
        rank[np.lexsort(keys)] = each
        ranks.append(meetings.of_agents(rank))
    return np.where(wave[:, None], ranks[1], ranks[0])
