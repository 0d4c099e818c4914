"""Which of many pairs of agents are so close that they may touch; compiled where numba is loaded,
with the same formulas and to the same bits.

Pairs that are far apart are not looked at until they can have come near. Few pairs are all looked
at together, in the compiled loop: then most steps need nothing but one comparison.
"""

from __future__ import annotations

import math
import sys
from functools import cache
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers, inverse_index
from ..vehicles import compiled
from ..vehicles.poses import Poses

FEW = 1_000
"""Pairs: so few are all looked at together."""
_ROUNDING = 1e-6
"""Meters."""
_NONE = np.zeros(0, dtype=np.int64)


def away_from(off_x: Any, off_y: Any) -> Any:
    """The square of how far two are apart."""
    return off_x * off_x + off_y * off_y


def looked_at_next(now: Any, square: Any, radius: Any) -> Any:
    """How far whoever is fastest has to have gone until two that were that far apart may touch.
    `now`: how far that is now; `radius`: of both together."""
    return now + 0.5 * (np.sqrt(square) - radius) - _ROUNDING


class ClosePairs:
    """Pairs of agents, each with a radius (N,), as they move."""

    def __init__(self, pairs: tuple[Integers, Integers], radius: Floats) -> None:
        self.first, self.second = pairs
        self._radius = radius
        self._fastest = 0.0  # meters that whoever went farthest in each step has gone, together
        self._next_look = np.zeros(len(self.first))  # of pairs: not until `_fastest` is that
        self._soonest = 0.0
        """no more than the least of these"""

    def met(
        self, poses: Poses, square: Floats, present: Booleans, halted: Booleans
    ) -> Integers:  # fmt: skip
        """The numbers of pairs whose circles have met in a step in which agents have gone meters
        with these squares (N,): of two that are `present`, and not both `halted`."""
        step = math.sqrt(float(np.fmax.reduce(square)))
        self._fastest += step
        within = self._fastest + step
        if self._soonest > within:
            return _NONE
        shift, few = np.sqrt(square), len(self.first) <= FEW
        if few and compiled.is_loaded():
            close = np.empty(len(self.first), dtype=bool)
            count, self._soonest = _compiled_loop()(
                self.first, self.second, (poses.x, poses.y, self._radius, shift),
                (present, halted), self._next_look, self._fastest, close,
            )  # fmt: skip
            return np.asarray(close.nonzero()[0]) if count else _NONE
        met = self._come_near(poses, shift, math.inf if few else within)
        if not len(met):
            return met
        first, second = self.first.take(met), self.second.take(met)
        counts = present.take(first) & present.take(second)
        return np.asarray(met[counts & ~(halted.take(first) & halted.take(second))])

    def _come_near(self, poses: Poses, shift: Floats, within: float) -> Integers:
        looked = None
        first, second = self.first, self.second
        if within < math.inf:
            looked = (self._next_look <= within).nonzero()[0]
            if not len(looked):
                return looked
            first, second = first.take(looked), second.take(looked)
        square = away_from(
            poses.x.take(first) - poses.x.take(second), poses.y.take(first) - poses.y.take(second)
        )
        radius = self._radius.take(first) + self._radius.take(second)
        following = looked_at_next(self._fastest, square, radius)
        reach = radius + (shift.take(first) + shift.take(second))
        close = (square <= reach * reach).nonzero()[0]
        if looked is None:
            self._next_look, self._soonest = following, float(following.min())
            return np.asarray(close)
        self._next_look[looked] = following
        return np.asarray(looked[close])

    @property
    def can_be_quiet(self) -> bool:
        """Whether there are pairs that are all looked at together, in a compiled loop."""
        return 0 < len(self.first) <= FEW and compiled.is_loaded()

    def gone(self, step: float) -> None:
        """Nobody has gone farther than that, in meters, and no pair has met."""
        self._fastest += step

    def put(self, square: Floats) -> None:
        """Agents were put elsewhere, meters away with these squares (N,)."""
        self._fastest += math.sqrt(float(square.max()))

    def restart(self, agents: Integers) -> None:
        """Some agents are back at the start."""
        back = np.zeros(len(self._radius), dtype=bool)
        back[agents] = True
        self._next_look[back[self.first]] = 0.0
        self._soonest = 0.0

    def take(self, agents: Integers, count: int) -> None:
        """From now on the world has these of its `count` agents alone."""
        place = inverse_index(agents, count)
        remaining = (place[self.first] >= 0) & (place[self.second] >= 0)
        self.first, self.second = place[self.first[remaining]], place[self.second[remaining]]
        self._next_look, self._radius = self._next_look[remaining], self._radius[agents]


def loop_over_close(
    first: Any, second: Any, agents: Any, flags: Any, next_look: Any, fastest: Any, close: Any
) -> Any:  # fmt: skip
    """Fill `close` (P,) with which pairs met; how many, and the soonest next look. numba compiles
    it; Python never runs it."""
    (x, y, around, shift), (present, halted) = agents, flags
    count, soonest = 0, np.inf
    for pair in range(first.shape[0]):
        i, j = first[pair], second[pair]
        square = away_from(x[i] - x[j], y[i] - y[j])
        radius = around[i] + around[j]
        next_look[pair] = looked_at_next(fastest, square, radius)
        soonest = min(soonest, next_look[pair])
        reach = radius + (shift[i] + shift[j])
        counts = present[i] & present[j] & ~(halted[i] & halted[j])
        close[pair] = counts & (square <= reach * reach)
        count += close[pair]
    return count, soonest


@cache
def _compiled_loop() -> Any:
    compiled.register((away_from, looked_at_next), (loop_over_close,))
    return compiled.compile_loop(loop_over_close, sys.modules[__name__])
