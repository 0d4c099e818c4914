"""Lateral motion of the lines that agents follow: smooth, also when redirected midway."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers

SLOW = 2.0
"""m/s: of slower agents the lines move more slowly in proportion, and stand still with them."""


@dataclass
class LateralMotion:
    """Columns (N,) of lines, left of the reference lines. A move is a quintic of the share of its
    time that has passed: position, velocity and acceleration are continuous, and end with the line
    at rest (`h (10 u^3 - 15 u^4 + 6 u^5)` from rest over a distance `h`)."""

    start: Floats
    """offsets at the start of the drive"""
    target: Floats
    time: Floats
    """seconds that the move takes"""
    share: Floats
    """of the move that is done, 1 where nothing moves"""
    powers: Floats
    """(6, N) coefficients"""
    offset: Floats
    """now"""
    moves: bool = False
    """whether any line may be moving"""
    is_at_start: bool = True
    """whether all lines are for certain as they were at the start of the drive"""

    @classmethod
    def at_rest(cls, offset: Floats) -> LateralMotion:
        """Lines that do not move."""
        count = len(offset)
        powers = np.zeros((6, count))
        powers[0] = offset
        return cls(
            offset, offset.copy(), np.ones(count), np.ones(count), powers, offset.copy()
        )  # fmt: skip

    def restart(self, agents: Integers) -> None:
        """Those of some agents are as at the start of the drive."""
        if not self.is_at_start:
            self.settle(agents, self.start[agents])

    def take(self, rows: Integers) -> LateralMotion:
        """Those of some agents."""
        return LateralMotion(
            self.start[rows], self.target[rows], self.time[rows], self.share[rows],
            self.powers[:, rows], self.offset[rows], self.moves, self.is_at_start,
        )  # fmt: skip

    def move(self, target: Floats, time: Floats | None) -> bool:
        """Where `target` is a number, and not that of the present move, moves that begin now and
        take `time` seconds; without a time, the line is there at once. Whether any begins."""
        new = np.flatnonzero(np.isfinite(target) & (target != self.target))
        if not len(new):
            return False
        self.is_at_start = False
        seconds = np.zeros(len(new)) if time is None else time[new]
        smooth = np.isfinite(seconds) & (seconds > 0.0)
        lasting = np.where(smooth, seconds, 1.0)
        place, slope, bend = _values(self.powers[:, new], self.share[new])
        scale = lasting / self.time[new]
        fresh = _quintic(place, slope * scale, bend * scale * scale, target[new])
        at_once = np.zeros_like(fresh)
        at_once[0] = target[new]
        self.powers[:, new] = np.where(smooth, fresh, at_once)
        self.target[new], self.time[new] = target[new], lasting
        self.share[new] = np.where(smooth, 0.0, 1.0)
        self.offset[new] = np.where(smooth, place, target[new])
        self.moves = self.moves or bool(smooth.any())
        return True

    def seen_from(self, rows: Integers, shift: Floats, drift: Floats) -> None:
        """From now on, lines of some agents are measured from others, which are `shift` meters to
        the right of those before and go away from these with `drift`, m/s."""
        if not len(rows):
            return
        self.is_at_start = False
        slope = drift * self.time[rows]
        powers = self.powers.copy()
        powers[0, rows] += shift - slope * self.share[rows]
        powers[1, rows] += slope
        self.powers = powers
        self.target[rows] += shift
        self.offset = self.offset.copy()
        self.offset[rows] += shift

    def go_on(self, earlier: LateralMotion, rows: Integers, old: Integers) -> None:
        """Those of some agents move as those of agents `old` do."""
        self.is_at_start = False
        for name in _STATE:
            column = getattr(self, name).copy()
            column[..., rows] = getattr(earlier, name)[..., old]
            setattr(self, name, column)
        self.moves = self.moves or earlier.moves

    def settle(self, rows: Integers, offset: Floats) -> None:
        """Those of some agents are at rest at offsets."""
        self.is_at_start = False
        rest = LateralMotion.at_rest(offset)
        for name in _STATE:
            column = getattr(self, name).copy()
            column[..., rows] = getattr(rest, name)
            setattr(self, name, column)

    def advance(self, speed: Floats, seconds: float) -> None:
        """Time passes; agents go at these speeds."""
        if not self.moves:
            return
        share = self.share + self._pace(speed) * seconds
        self.share = np.minimum(share, 1.0)
        place = _values(self.powers, self.share)[0]
        self.offset = np.where(self.share >= 1.0, self.target, place)
        self.moves = bool((self.share < 1.0).any())

    def ahead(self, rows: Any, distance: Floats | float, speed: Floats) -> Any:
        """Of some agents: offset, slope (1) and curvature (1/m) of the line a distance on, and
        which lines move at all (None: none does)."""
        offset = self.offset[rows]
        if not self.moves:
            return offset, None, None, None
        moving: Booleans = self.share[rows] < 1.0
        if not moving.any():
            return offset, None, None, None
        part = replace(
            self, powers=self.powers[:, rows], time=self.time[rows], share=self.share[rows]
        )
        forward = np.maximum(speed, SLOW)
        per_meter = 1.0 / (part.time * forward)
        share = np.minimum(np.maximum(part.share + per_meter * distance, 0.0), 1.0)
        place, slope, bend = _values(part.powers, share)
        settled = ~moving
        place = np.where(settled, offset, place)
        return place, slope * per_meter, bend * per_meter * per_meter, moving

    def _pace(self, speed: Floats) -> Floats:
        """Shares for each second."""
        return np.minimum(np.maximum(speed / SLOW, 0.0), 1.0) / self.time


_STATE = ("target", "time", "share", "powers", "offset")


def _quintic(place: Floats, slope: Floats, bend: Floats, target: Floats) -> Floats:
    """(6, N) coefficients from a state to rest at `target`, over a unit of time."""
    height = target - place
    return np.stack(
        (
            place,
            slope,
            0.5 * bend,
            10.0 * height - 6.0 * slope - 1.5 * bend,
            -15.0 * height + 8.0 * slope + 1.5 * bend,
            6.0 * height - 3.0 * slope - 0.5 * bend,
        )
    )


def _values(c: Floats, u: Floats) -> tuple[Floats, Floats, Floats]:
    """Value, slope and second derivative of quintics."""
    value = c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))))
    slope = c[1] + u * (2.0 * c[2] + u * (3.0 * c[3] + u * (4.0 * c[4] + u * 5.0 * c[5])))
    bend = 2.0 * c[2] + u * (6.0 * c[3] + u * (12.0 * c[4] + u * 20.0 * c[5]))
    return value, slope, bend
