"""Gaps between agents on one road, by their stations and where they are beside each other's lines.

The formulas are written once, for arrays and for numbers: the loop over pairs is compiled where
numba is loaded, and gives the same bits.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property, partial
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles import compiled
from ..vehicles.vehicle_dynamics import greatest, least

SAME_LANE = 2.0
"""Meters: cars are beside each other rather than behind one another, from here on."""
CLEARANCE = 0.03
"""Extra room that a driver wants beside what it passes, in seconds of its speed, up to `SAME_LANE`
meters. Drivers who crawl in a jam let motorcycles ride between the lanes."""
COMING, STRAYING = 0.7, 0.1
"""Seconds ahead at which drivers see who comes over into their lane, and m/s to the side with which
nobody does."""
ALONG = 0.05
"""Sine of the angle to the road up to which somebody drives along it."""
MARGIN = 0.15
"""Meters to each side between two that pass each other."""


def ahead_of(station: Any, other: Any, sign: Any) -> Any:
    """How far ahead another is along the road. `sign`: -1 for who goes against the road."""
    return sign * (other - station)


def within_lap(ahead: Any, lap: Any) -> Any:
    """The same on a closed road of this length."""
    return ahead - np.floor(ahead / lap) * lap


def gap_between(ahead: Any, length: Any, other: Any) -> Any:
    """From the front of one to the rear of another, of these lengths."""
    return ahead - 0.5 * (length + other)


def beside_line(left: Any, offset: Any, sign: Any) -> Any:
    """How far left of the line of an agent another is, which is `left` of the road."""
    return sign * left - offset


def room_wanted(own: Any, clearance: Any, half: Any) -> Any:
    """How far beside the line of an agent another is in its way. `own`: half of its width, `half`:
    what the other takes to each side."""
    return greatest(least(own + clearance, SAME_LANE - half), own) + half


def room_for_coming(aside: Any, sign: Any, drift: Any) -> Any:
    """So much farther is in the way who comes over with `drift` m/s."""
    return COMING * greatest(-np.sign(aside) * sign * drift - STRAYING, 0.0)


def half_taken(width: Any, length: Any, sine: Any) -> Any:
    """How much of the road agents take to each side of their middle: who is wide, or turned toward
    the lane, takes more."""
    turned = np.abs(sine)
    along = np.sqrt(1.0 - least(turned * turned, 1.0))
    across = 0.5 * length * greatest(turned - ALONG, 0.0)
    return 0.5 * width * along + across + MARGIN


@dataclass(frozen=True)
class RoadColumns:
    """What gaps on roads depend on, as (S, A) over scenes and their agents."""

    station: Floats
    aside: Floats
    """left of the reference line of the agent"""
    speed: Floats
    sine: Floats
    """of the angle to that line"""
    width: Floats
    length: Floats
    lap: Floats
    offset: Floats
    """of the line to follow, left of the reference line"""
    backward: Booleans
    """who goes against the road"""
    closed: Booleans
    there: Booleans
    offsets: Callable[[Floats], Floats] | None
    """(S, A, A) `offset` beside others that are ahead, where lines are not parallel to the road"""

    @classmethod
    def of(cls, world: World) -> RoadColumns:
        """Of the agents of a world, as it is now."""
        bodies, motion = world.bodies, world.motion
        shape = len(world.scenes), world.slots
        columns = (
            world.station, motion.offset, motion.speed, motion.sine, bodies.width, bodies.length,
            world.length, world.line_offset.copy(), world.backward, world.closed, world.present,
        )  # fmt: skip
        offsets = None if world.followed.guides.is_empty else partial(_offsets_beside, world, shape)
        members: Any = *[column.reshape(shape) for column in columns], offsets
        return cls(*members)

    @cached_property
    def sign(self) -> Floats:
        """-1 for who goes against the road."""
        return np.where(self.backward, -1.0, 1.0)

    @cached_property
    def left(self) -> Floats:
        """Left of the road, in the direction of `sign`."""
        return self.sign * self.aside

    @cached_property
    def own(self) -> Floats:
        """Half of the width."""
        return 0.5 * self.width

    @cached_property
    def clearance(self) -> Floats:
        """By how much more than its width it keeps from others, by its speed."""
        return CLEARANCE * self.speed

    @cached_property
    def half(self) -> Floats:
        """How much of the road it takes to each side."""
        taken: Floats = half_taken(self.width, self.length, self.sine)
        return taken

    @cached_property
    def drift(self) -> Floats:
        """m/s to the left of the road."""
        return self.sign * (self.speed * self.sine)

    @cached_property
    def all_there(self) -> bool:
        """Whether nobody has left."""
        return bool(self.there.all())

    @cached_property
    def comes_over(self) -> bool:
        """Whether anybody may come over into the lane of another."""
        return bool((np.abs(self.drift) > STRAYING).any())

    def gaps(self, pairs: Booleans) -> Floats:
        """(S, A, A) gap of the first to the second of pairs that are both there, on the road of
        the first: infinite for what is behind or beside it, and of all others. `pairs`:
        (S, A, A)."""
        return self.least_gaps(pairs)[0]

    def least_gaps(self, pairs: Booleans) -> tuple[Floats, Floats, Integers]:
        """`gaps`, and of each agent (S, A) the least and the place in its scene of whom it is to:
        of several the first, and 0 where it is infinite."""
        if compiled.is_loaded() and self.offsets is None:
            gaps, found = np.empty(pairs.shape), np.empty(self.there.shape)
            first = np.empty(self.there.shape, dtype=np.int64)
            columns = (
                self.station, self.aside, self.speed, self.sine, self.width, self.length, self.lap,
                self.offset,
            )  # fmt: skip
            flags = self.backward, self.closed, self.there
            _compiled_loop()(columns, flags, pairs, gaps, found, first)
            return gaps, found, first
        fits, gap = self._all_gaps()
        both = self.there[:, :, None] & self.there[:, None, :]
        gaps = np.where(fits & pairs & both, gap, math.inf)
        return gaps, *least_of(gaps)

    def _all_gaps(self) -> tuple[Booleans, Floats]:
        """(S, A, A) who is ahead in the lane of whom, and the gaps of all."""
        first, second = (slice(None), slice(None), None), (slice(None), None)
        sign = self.sign[first]
        ahead: Floats = ahead_of(self.station[first], self.station[second], sign)
        if np.count_nonzero(self.closed):
            ahead = np.where(self.closed[first], within_lap(ahead, self.lap[first]), ahead)
        offset = self.offset[first] if self.offsets is None else self.offsets(ahead)
        gap = gap_between(ahead, self.length[first], self.length[second])
        own = offset, self.own[first], self.clearance[first], sign
        other = self.half[second], self.drift[second] if self.comes_over else None
        return is_in_lane(ahead, self.left[second], own, other), gap


def least_of(gaps: Floats) -> tuple[Floats, Integers]:
    """(S, A) the least gap (S, A, A) of each agent, and to whom."""
    first = gaps.argmin(axis=2)
    row = np.arange(0, gaps.size, gaps.shape[2]).reshape(first.shape)
    return gaps.take(row + first), first


def is_in_lane(
    ahead: Floats, left: Floats, own: tuple[Any, ...], other: tuple[Any, Any]
) -> Booleans:  # fmt: skip
    """Who is in the lane ahead of others, `ahead` of them and so far left of the road. `own`: of
    these the offset of the line, half of the width, the clearance and the sign; `other`: how much
    it takes to each side, and its drift (None: nobody's matters)."""
    offset, width, clearance, sign = own
    half, drift = other
    aside = beside_line(left, offset, sign)
    room = room_wanted(width, clearance, half)
    if drift is not None:
        room = room + room_for_coming(aside, sign, drift)
    return np.asarray((ahead > 0.0) & (np.abs(aside) < room))


def _offsets_beside(world: World, shape: tuple[int, ...], ahead: Floats) -> Floats:
    """(S, A, A) how far left of the center line the line of the first is beside the second, which
    is `ahead` of it."""
    rows = np.arange(len(world.present)).reshape(shape)[:, :, None]
    along = world.motion.along[rows] + ahead
    lap = np.where(world.closed, world.length, math.inf)[rows]
    return world.followed.offset(rows, along - np.where(along >= lap, lap, 0.0))


def loop_over_pairs(
    columns: Any, flags: Any, pairs: Any, gaps: Any, found: Any, first: Any
) -> None:  # fmt: skip
    """What `RoadColumns.least_gaps` gives. numba compiles it; Python never runs it."""
    station, aside, speed, sine, width, length, lap, offset = columns
    backward, closed, there = flags
    half, drift, sign = np.empty((3, pairs.shape[1]))
    for s in range(pairs.shape[0]):
        for i in range(pairs.shape[1]):
            sign[i] = -1.0 if backward[s, i] else 1.0
            half[i] = half_taken(width[s, i], length[s, i], sine[s, i])
            drift[i] = sign[i] * (speed[s, i] * sine[s, i])
        for i in range(pairs.shape[1]):
            found[s, i], first[s, i] = np.inf, 0
            for j in range(pairs.shape[1]):
                ahead = ahead_of(station[s, i], station[s, j], sign[i])
                if closed[s, i]:
                    ahead = within_lap(ahead, lap[s, i])
                beside = beside_line(sign[j] * aside[s, j], offset[s, i], sign[i])
                room = room_wanted(0.5 * width[s, i], CLEARANCE * speed[s, i], half[j])
                room = room + room_for_coming(beside, sign[i], drift[j])
                fits = (ahead > 0.0) & (abs(beside) < room) & pairs[s, i, j]
                gap = gap_between(ahead, length[s, i], length[s, j])
                gaps[s, i, j] = gap if fits & there[s, i] & there[s, j] else np.inf
                if gaps[s, i, j] < found[s, i]:
                    found[s, i], first[s, i] = gaps[s, i, j], j


@cache
def _compiled_loop() -> Any:
    formulas = (
        ahead_of, within_lap, gap_between, beside_line, room_wanted, room_for_coming, half_taken,
    )  # fmt: skip
    compiled.register(formulas, (loop_over_pairs,))
    return compiled.compile_loop(loop_over_pairs, sys.modules[__name__])
