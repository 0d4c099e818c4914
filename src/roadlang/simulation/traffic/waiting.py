"""Where agents have to stop for those that were let go before them, and whom they follow where
lanes merge; compiled where numba is loaded, to the same bits."""

from __future__ import annotations

import math
import sys
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..junctions import crossings
from ..junctions.crossings import STOP_GAP
from ..vehicles import compiled
from . import rules
from .crowd import Crowd
from .junction_tables import CROSS, MERGE
from .meetings import Meetings


def waits(crowd: Crowd, wanted: Booleans) -> tuple[Floats, Integers, Floats]:
    """(N,) meters from the fronts of agents to where they have to stop, infinite for no need; the
    place in the crowd of whom they follow, -1 for nobody, and the gap to that one. `wanted`: (N, X)
    requested crossings."""
    near, held, entrants = crowd.near, crowd.held, crowd.entrants
    closed = np.where(held | near.is_over, math.inf, near.to_line - STOP_GAP)
    stop = np.minimum(closed.min(axis=1), crowd.oncoming)
    gap = np.full(len(stop), math.inf)
    leader = np.full(len(stop), -1)
    if not np.count_nonzero(held):
        return stop, leader, gap
    meetings = entrants.meetings(held | wanted)
    if not meetings.has_conflicts:
        return stop, leader, gap
    if compiled.is_loaded():
        _loop()(
            (meetings.row, meetings.slot, meetings.is_there),
            (meetings.conflict, meetings.begin, meetings.end),
            (near.to_line, near.to_leave, crowd.grants.order), entrants.length, stop, leader, gap,
        )  # fmt: skip
        return stop, leader, gap
    found = rules.zone_stops(meetings, near, crowd.grants, entrants.length)
    if found is not None:
        stops, gaps = found
        there, (row, _) = meetings.is_there, meetings.there
        np.minimum.at(stop, row, stops.min(axis=2)[there])
        if meetings.has_merges:
            _follow(meetings, gaps, gap, leader)
    return stop, leader, gap


def _follow(meetings: Meetings, gaps: Floats, gap: Floats, leader: Integers) -> None:
    """Fill in whom each of the agents (N,) follows where lanes merge, and the gap to that one.
    `gaps`: (G, P, P) of all that it might follow."""
    there = meetings.is_there
    least = gaps.min(axis=2)
    np.minimum.at(gap, meetings.row[there], least[there])
    follows = there & np.isfinite(least) & (least == gap[meetings.row])
    group, place = follows.nonzero()
    other = meetings.row[group, gaps[group, place].argmin(axis=1)]
    leader[meetings.row[group, place]] = other


def loop_over_meetings(
    groups: Any, conflicts: Any, arrays: Any, length: Any, stop: Any, leader: Any, gap: Any
) -> None:  # fmt: skip
    """What `rules.zone_stops` and `_follow` do. numba compiles it; Python never runs it."""
    (row, slot, is_there), (conflict, begin, end) = groups, conflicts
    to_line, to_leave, order = arrays
    for g in range(row.shape[0]):
        for p in range(row.shape[1]):
            if not is_there[g, p]:
                continue
            i, x, least = row[g, p], slot[g, p], np.inf
            first = i
            for q in range(row.shape[1]):
                j, y = row[g, q], slot[g, q]
                kind = conflict[g, p, q]
                earlier = order[j, y] < order[i, x] or (order[j, y] == order[i, x] and j < i)
                if not (kind > 0 and earlier and order[j, y] < np.inf):
                    continue
                to_zone = to_line[i, x] + begin[g, p, q]
                leaves_in = to_line[j, y] + end[g, q, p] + length[j]
                waits_at = to_zone - rules.BEFORE_ZONE
                if kind == CROSS and leaves_in > 0.0 and to_zone > -rules.IN_ZONE:
                    stop[i] = min(stop[i], waits_at)
                if kind == MERGE and order[i, x] < np.inf:
                    behind = (to_leave[i, x] - length[i]) - (to_leave[j, y] - length[j]) - length[j]
                    if behind < waits_at:
                        stop[i] = min(stop[i], waits_at)
                    elif behind < least:
                        first, least = j, behind
            if least < np.inf and least <= gap[i]:
                leader[i], gap[i] = first, least


@cache
def _loop() -> Any:
    compiled.register((), (loop_over_meetings,))
    said = sys.modules[__name__], rules, crossings
    return compiled.compile_loop(loop_over_meetings, *said)
