"""Letting agents go: at each junction at most one at a time, by class, arrival and number."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...plugins.kinds import STANDING_GAP
from . import rules
from .asking import Asking
from .crowd import Crowd
from .meetings import Meetings

WAVED_THROUGH = 1.0
"""Seconds after which, where all wait for each other, the first goes."""


def let_go(crowd: Crowd, asking: Asking, last_grant: Floats) -> Booleans:
    """Let at most one agent go at each junction; `last_grant` (S, J) is when somebody was. (N, X)
    which crossings were asked for, or come closer."""
    coming = np.zeros(crowd.held.shape, dtype=bool)
    if not np.count_nonzero(asking.asks):
        return coming
    agents = asking.comes.nonzero()[0]
    coming[agents, asking.slot[agents]] = True
    may = _may(crowd, asking)
    if not np.count_nonzero(may):
        return coming
    meetings = crowd.entrants.meetings(coming | crowd.held)
    comes = meetings.is_there & meetings.of_crossings(coming)
    wants = comes & meetings.of_agents(asking.asks)
    could = _could(crowd, asking, meetings, wants, may)
    if not np.count_nonzero(could):
        return coming
    able = _able(crowd, asking, meetings, wants, could)
    if not np.count_nonzero(able):
        return coming
    passes, wave = _passes(crowd, meetings, (comes, wants, asking.is_first), able, last_grant)
    rank = np.where(passes, _rank(crowd, asking, meetings, wave), len(asking.slot))
    chosen = np.flatnonzero(passes.any(axis=1))
    best = rank[chosen].argmin(axis=1)
    crowd.grants.order[meetings.row[chosen, best], meetings.slot[chosen, best]] = crowd.time
    scene, junction = divmod(meetings.key[chosen], len(crowd.entrants.places.by_right))
    last_grant[scene, junction] = crowd.time
    return coming


def _passes(
    crowd: Crowd, meetings: Meetings, who: tuple[Booleans, Booleans, Booleans], able: Booleans,
    last_grant: Floats,
) -> tuple[Booleans, Booleans]:  # fmt: skip
    """(G, P) who of those that are `able` to go need not yield to others that come, and (G,) where
    all wait for each other: there the first goes. `who`: (G, P) comes, (G, P) asks to go, and (N,)
    is the first in its lane."""
    comes, wants, is_first = who
    places = crowd.entrants.places
    scene, junction = divmod(meetings.key, len(places.by_right))
    turns = places.tables.turns[meetings.of_crossings(crowd.near.number)]
    motion = crowd.speed, crowd.entrants.length, crowd.aggression
    after = rules.goes_after(meetings, crowd.near, turns, *motion)
    if not np.count_nonzero(after):
        return able, np.zeros(len(scene), dtype=bool)
    first = meetings.of_agents(is_first) & ~rules.let_go(meetings, crowd.grants)
    asks = wants & first & (able | places.by_right[junction][:, None])
    later = comes & ~wants & first & meetings.of_crossings(crowd.near.may_go)
    is_patient = meetings.of_crossings(crowd.grants.waiting) <= rules.LONGEST_WAIT
    free = able & ~((after & later[:, None, :]).any(axis=2) & is_patient)
    passes = free & ~(after & asks[:, None, :]).any(axis=2)
    stuck = free.any(axis=1) & ~passes.any(axis=1)
    wave = stuck & (crowd.time - last_grant[scene, junction] > WAVED_THROUGH)
    return passes | (free & wave[:, None]), wave


def _may(crowd: Crowd, asking: Asking) -> Booleans:
    """(N,) who may go, but for others on the junction and beyond it."""
    stopped = crowd.grants.has_stopped | ~crowd.entrants.must_stop
    may = asking.asks & asking.of_crossings(crowd.near.may_go & stopped) & asking.is_first
    if np.count_nonzero(may) and len(crowd.entrants.places.rings.capacity):
        may &= ~_ring_is_full(crowd, asking)
    return np.asarray(may)


def _could(
    crowd: Crowd, asking: Asking, meetings: Meetings, wants: Booleans, may: Booleans
) -> Booleans:
    """(G, P) who `may` go, but for others on the junction."""
    grants, entrants = crowd.grants, crowd.entrants
    may_go = rules.let_go(meetings, grants)
    used = rules.space_for_others(meetings, may_go, entrants.length)
    free = meetings.of_agents(asking.room - entrants.length) - used
    return np.asarray(wants & meetings.of_agents(may) & (free >= STANDING_GAP))


def _able(
    crowd: Crowd, asking: Asking, meetings: Meetings, wants: Booleans, could: Booleans
) -> Booleans:
    """(G, P) who of those that could go has a free way, but for who comes from the right, and need
    not let one go that has waited for long."""
    near, grants, entrants = crowd.near, crowd.grants, crowd.entrants
    # Who waits for somebody that comes toward it cannot be helped by others that wait too.
    meets_nobody = meetings.of_agents(crowd.oncoming > asking.of_crossings(near.to_leave))
    able = could & meets_nobody
    if meetings.has_conflicts and np.count_nonzero(able):
        able &= ~rules.is_occupied(meetings, near, grants, wants)
        motion = crowd.speed, entrants.length, crowd.aggression
        able &= ~rules.is_blocked(meetings, near, grants, *motion)
        able &= ~rules.lets_in(meetings, near, grants, wants, crowd.speed, crowd.politeness)
    junction = meetings.key % len(entrants.places.by_right)
    in_line = could & entrants.places.by_patience[junction][:, None] & meets_nobody
    return np.asarray(able & ~rules.is_reserved(meetings, grants, in_line, able))


def _ring_is_full(crowd: Crowd, asking: Asking) -> Booleans:
    """(N,) whether the connection asked for leads into a ring that has no more room."""
    entrants = crowd.entrants
    rings, number = entrants.places.rings, entrants.ways.number
    entered = (crowd.held | crowd.near.is_over) & ~entrants.ways.none
    last = np.where(entered, np.arange(entered.shape[1]), -1).max(axis=1)
    on = np.where(last >= 0, rings.onward[number[entrants.each, last]], -1)
    first = int(entrants.scene.min(initial=0))
    counts = np.zeros((int(entrants.scene.max(initial=0)) - first + 1, len(rings.capacity)))
    inside = np.flatnonzero((on >= 0) & crowd.present)
    np.add.at(counts, (entrants.scene[inside] - first, on[inside]), 1.0)
    into = rings.into[asking.of_crossings(number)]
    full = counts[entrants.scene - first, into] >= rings.capacity[into]
    return np.asarray((into >= 0) & full)


def _rank(crowd: Crowd, asking: Asking, meetings: Meetings, wave: Booleans) -> Integers:
    """(G, P) the order in which agents are let go: who yields to nobody first, then by arrival;
    where all wait for each other (`wave`, (G,)) by arrival alone."""
    entrants = crowd.entrants
    yields = asking.of_crossings(entrants.yields_any & ~entrants.in_turn)
    arrival = asking.of_crossings(crowd.grants.arrival)
    each = entrants.each
    found = meetings.of_agents(_places((each, arrival, yields)))
    if np.count_nonzero(wave):
        found = np.where(wave[:, None], meetings.of_agents(_places((each, arrival))), found)
    return found


def _places(keys: tuple[Any, ...]) -> Integers:
    """(N,) the place of each in the order by some keys, the last first."""
    rank = np.empty(len(keys[0]), dtype=np.int64)
    rank[np.lexsort(keys)] = keys[0]
    return rank
