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

from ...geometry.arrays import Booleans, Floats
from ..state.world import World
from ..vehicles import compiled
from ..vehicles.vehicle_dynamics import greatest, least

SAME_LANE = 2.0
"""Meters: cars are beside each other rather than behind one another, from here on."""
CLEARANCE = 0.03
"""Seconds of its speed: so much more room beside what it passes does a driver want, up to
`SAME_LANE`. Who crawls in a jam lets a motorcycle ride between the lanes."""
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


@dataclass(frozen=True)
class RoadColumns:
    """What gaps on roads depend on, as (S, A) over scenes and their agents."""

    station: Floats
    sign: Floats
    """-1 for who goes against the road"""
    left: Floats
    """of the road, in the direction of `sign`"""
    own: Floats
    clearance: Floats
    half: Floats
    drift: Floats
    length: Floats
    lap: Floats
    offset: Floats
    closed: Booleans
    there: Booleans
    offsets: Callable[[Floats], Floats] | None
    """(S, A, A) `offset` beside others that are ahead, where lines are not parallel to the road"""

    @classmethod
    def of(cls, world: World) -> RoadColumns:
        """Of the agents of a world, as it is now."""
        sign, bodies, motion = np.where(world.backward, -1.0, 1.0), world.bodies, world.motion
        shape = len(world.scenes), world.slots
        numbers = (
            world.station, sign, sign * motion.offset, 0.5 * bodies.width,
            CLEARANCE * motion.speed, _half_taken(world), sign * (motion.speed * motion.sine),
            bodies.length, world.length, world.line_offset.copy(),
        )  # fmt: skip
        offsets = None if world.followed.guides.is_empty else partial(_offsets_beside, world, shape)
        flags = world.closed.reshape(shape), world.present.reshape(shape)
        members: Any = *(column.reshape(shape) for column in numbers), *flags, offsets
        return cls(*members)

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
        if compiled.is_loaded() and self.offsets is None:
            out = np.empty(pairs.shape)
            arrays = (
                self.station, self.sign, self.left, self.own, self.clearance, self.half,
                self.drift, self.length, self.lap,
            )  # fmt: skip
            _compiled_loop()(arrays, self.offset, self.closed, pairs, self.there, out)
            return out
        fits, gap = self._all_gaps()
        both = self.there[:, :, None] & self.there[:, None, :]
        return np.where(fits & pairs & both, gap, math.inf)

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


def _half_taken(world: World) -> Floats:
    """(N,) how much of the road agents take to each side of their middle: who is wide, or turned
    toward the lane, takes more."""
    bodies = world.bodies
    turned = np.abs(world.motion.sine)
    along = np.sqrt(1.0 - np.minimum(turned * turned, 1.0))
    across = 0.5 * bodies.length * np.maximum(turned - ALONG, 0.0)
    taken: Floats = 0.5 * bodies.width * along + across + MARGIN
    return taken


def loop_over_pairs(
    arrays: Any, offset: Any, closed: Any, pairs: Any, there: Any, out: Any
) -> None:  # fmt: skip
    """What `RoadColumns.gaps` gives, of pairs that are there. numba compiles it; Python never runs
    it."""
    station, sign, left, own, clearance, half, drift, length, lap = arrays
    for s in range(pairs.shape[0]):
        for i in range(pairs.shape[1]):
            for j in range(pairs.shape[1]):
                ahead = ahead_of(station[s, i], station[s, j], sign[s, i])
                if closed[s, i]:
                    ahead = within_lap(ahead, lap[s, i])
                aside = beside_line(left[s, j], offset[s, i], sign[s, i])
                room = room_wanted(own[s, i], clearance[s, i], half[s, j])
                room = room + room_for_coming(aside, sign[s, i], drift[s, j])
                fits = (ahead > 0.0) & (abs(aside) < room) & pairs[s, i, j]
                gap = gap_between(ahead, length[s, i], length[s, j])
                out[s, i, j] = gap if fits & there[s, i] & there[s, j] else np.inf


@cache
def _compiled_loop() -> Any:
    formulas = ahead_of, within_lap, gap_between, beside_line, room_wanted, room_for_coming
    compiled.register(formulas, (loop_over_pairs,))
    return compiled.compile_loop(loop_over_pairs, sys.modules[__name__])
