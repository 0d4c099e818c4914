"""The loop over agents on the way to junctions: what `Approaches.of`, `remember` and `Asking.of`
do, to the last bit, on open lines. numba compiles it; Python never runs it."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..junctions.crossings import STOP_GAP
from . import approaches, asking, grants, remembering


def least_braking(speed: Any, distance: Any) -> Any:
    """`approaches.braking_to_stop` of numbers."""
    least = approaches.LEAST_DISTANCE
    return 0.5 * speed * speed / (distance if distance > least else least)


def looked(
    ways: Any, agents: Any, flags: Any, granted: Any, time: Any, near: Any, ask: Any
) -> None:  # fmt: skip
    """Fill `near`, (N, X) two of numbers and three of truths, with the members `to_line`,
    `to_leave`, `may_go`, `must_stop` and `is_over` of `Approaches`; change `granted`, the arrays of
    `Grants`; fill `ask`, three (N,) of truths, one of integers and one of numbers, with `asks`,
    `comes`, `is_first`, `slot` and `room` of `Asking`. `ways`: (N, X) stop, exit and junction of
    crossings, `in_turn` and `is_short` of `Entrants`, the members of `ShownLights`; `agents`: (N,)
    half length, length, arc length, speed, age, gap to objects and (N, A) gaps; `flags`: (N,)
    present, moving, obeys."""
    speed, gaps, (in_turn, _) = agents[3], agents[6], ways[3]
    present, moving, obeys = flags
    to_line, _, _, must_stop, is_over = near
    order = granted[0]
    count, crossings = to_line.shape
    held = np.empty((count, crossings), np.bool_)
    for i in range(count):
        for x in range(crossings):
            approach(ways, agents, i, x, near)
            who = present[i], moving[i], obeys[i], in_turn[i, x]
            remember(
                i, x, (to_line[i, x], must_stop[i, x], is_over[i, x]), granted, who, speed[i], time
            )
            held[i, x] = order[i, x] < np.inf
    for i in range(count):
        take_back(ways[2], agents, i, obeys[i], to_line, held, order)
    for i in range(count):
        leader, gap = ahead(gaps, i)
        ask_to_go(ways, agents, (i, leader, gap), moving[i] and obeys[i], granted, time, near, ask)


def take_back(
    junction: Any, agents: Any, i: Any, obeys: Any, to_line: Any, held: Any, order: Any
) -> None:  # fmt: skip
    """What `asking` does first, about one agent. `held`: (N, X) which crossings agents may cross
    before that."""
    _, length, _, speed, _, objects, gaps = agents
    leader, gap = ahead(gaps, i)
    for x in range(held.shape[1]):
        braking = least_braking(speed[i], to_line[i, x] - STOP_GAP)
        if not (held[i, x] and obeys and braking < approaches.COMFORTABLE):
            continue
        waits = to_line[i, x] > objects[i]
        if to_line[i, x] > gap + length[leader]:
            for y in range(held.shape[1]):
                same = junction[leader, y] == junction[i, x]
                waits = waits or (same and not held[leader, y])
        if waits:
            order[i, x] = np.inf


def ask_to_go(
    ways: Any, agents: Any, who: Any, takes_part: Any, granted: Any, time: Any, near: Any, ask: Any
) -> None:  # fmt: skip
    """What `Asking.of` gives of one agent. `who`: it, who is ahead of it, and the gap to that."""
    junction, (_, is_short) = ways[2], ways[3]
    (_, length, _, speed, _, objects, gaps), (i, leader, gap) = agents, who
    (to_line, to_leave, _, _, is_over), (order, arrival, _, _) = near, granted
    asks, comes, is_first, slots, room = ask
    slot, distance = 0, np.inf
    for x in range(to_line.shape[1]):
        if not is_over[i, x] and not order[i, x] < np.inf and to_line[i, x] < distance:
            slot, distance = x, to_line[i, x]
    v = speed[i]
    seconds = asking.SHORT_BOOKING if is_short[i, slot] else asking.BOOKING
    asks[i] = takes_part and distance < approaches.horizon(v, seconds)
    comes[i] = takes_part and distance < approaches.horizon(v, asking.SEEN)
    slots[i], room[i] = slot, 0.0
    free = gap > distance
    for y in range(to_line.shape[1]):
        same = junction[leader, y] == junction[i, slot]
        free = free or (same and order[leader, y] < np.inf)
    is_first[i] = free and objects[i] > distance
    if asks[i]:
        if arrival[i, slot] == np.inf:
            arrival[i, slot] = time + distance / (v if v > asking.SLOWEST else asking.SLOWEST)
        room[i] = room_of(gaps, speed, i, to_leave[i, slot] - length[i])


def ahead(gaps: Any, i: Any) -> Any:
    """Who is next ahead of an agent in its lane, and the gap to it."""
    slot_count, place = gaps.shape[1], 0
    for k in range(1, slot_count):
        if gaps[i, k] < gaps[i, place]:
            place = k
    return i // slot_count * slot_count + place, gaps[i, place]


def room_of(gaps: Any, speed: Any, i: Any, beyond: Any) -> Any:
    """`Asking.room` of an agent that asks."""
    slot_count, least = gaps.shape[1], np.inf
    first = i // slot_count * slot_count
    for k in range(slot_count):
        if gaps[i, k] > beyond - asking.SLACK:
            v = speed[first + k]
            tail = gaps[i, k] + asking.TAIL_TIME * (v if v > 0.0 else 0.0)
            if tail < least:
                least = tail
    return least - beyond


def approach(ways: Any, agents: Any, i: Any, x: Any, near: Any) -> None:
    """What `Approaches.of` gives of one crossing of an agent."""
    stop, exit_, junction, _, (cycle, offset, has_signals, begin, yellow, red) = ways
    half, _, along, speed, age, _, _ = agents
    to_line, to_leave, may_go, must_stop, is_over = near
    line = stop[i, x] - along[i] - half[i]
    leave = exit_[i, x] - along[i] + half[i]
    to_line[i, x], to_leave[i, x] = line, leave
    is_over[i, x] = junction[i, x] < 0 or leave < 0.0
    green, left = True, np.inf
    if has_signals[i, x]:
        now = (age[i] + offset[i, x]) % cycle[i, x]
        green, left = False, 0.0
        for p in range(begin.shape[2]):
            if begin[i, x, p] <= now:
                green = green or now < yellow[i, x, p]
                if now < red[i, x, p] and red[i, x, p] - now > left:
                    left = red[i, x, p] - now
    needed = least_braking(speed[i], line - STOP_GAP)
    until = left if left < approaches.FAR else approaches.FAR
    soon = line < approaches.IN_TIME * speed[i] * until
    may_go[i, x] = (green and left >= approaches.WARNING) or (
        needed > approaches.COMFORTABLE and soon
    )
    stops = needed < approaches.HARDEST and line >= 0.0
    must_stop[i, x] = stops and not may_go[i, x]


def remember(i: Any, x: Any, near: Any, granted: Any, who: Any, speed: Any, time: Any) -> None:
    """What `remembering.remember` does about one crossing of an agent."""
    order, arrival, has_stopped, waiting = granted
    (line, must_stop, is_over), (present, moving, obeys, in_turn) = near, who
    if is_over or not present:
        order[i, x], arrival[i, x], has_stopped[i, x] = np.inf, np.inf, False
        waiting[i, x] = 0.0
    if obeys and must_stop:
        order[i, x] = np.inf
    is_ahead = moving and not is_over
    if not obeys and line >= 0.0:
        if speed < approaches.SIGN_SPEED and order[i, x] < np.inf:
            order[i, x] = np.inf
        if is_ahead and least_braking(speed, line) > remembering.UNSTOPPABLE:
            order[i, x] = grants.FIRST
    if is_ahead and not order[i, x] < np.inf and line < -approaches.OVER_LINE:
        order[i, x] = time if obeys else grants.FIRST
    within = line > -approaches.OVER_LINE and line < remembering.WAITS_WITHIN
    if not (is_ahead and within and speed < remembering.WAITS_SLOWER):
        waiting[i, x] = 0.0
        return
    waiting[i, x] += remembering.INTERVAL
    is_close = line < approaches.SIGN_DISTANCE and speed < approaches.SIGN_SPEED
    if is_close and not has_stopped[i, x]:
        has_stopped[i, x] = True
        if in_turn:
            arrival[i, x] = time
