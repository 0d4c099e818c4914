"""The greatest level that a function reaches for long enough in a sliding window.

The time that a function is at a level r or above in the window of t is linear in r and t together,
as long as neither r passes a value at a breakpoint or at an end of the window, nor an end of the
window a breakpoint. So the greatest level that is reached for a given time is linear in t between
the moments at which one of these happens; all of them are found here.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..evaluate.trace import FloatArray
from ..formula.interval import Interval
from .piecewise import PiecewiseLinear, merged


def lasting(
    f: PiecewiseLinear, interval: Interval, amount: float, enough: float
) -> PiecewiseLinear:
    """The greatest r such that f is r or more for at least `amount` in t + [lo, hi], clipped to the
    time for which f is known; -inf where the window is shorter.

    `enough` is `amount` with the rounding of sums of times, more where just `amount` is too little.
    Moments at which it is reached are sought with `amount`: with `enough` they would be so much
    earlier or later that the value there were that of the wrong side.
    """
    search = _LevelSearch(f, interval, amount, enough)
    shifted = [f.times[[0, -1]], f.times - interval.lo]
    if np.isfinite(interval.hi):
        shifted.append(f.times - interval.hi)
    moved = np.concatenate(shifted)
    inside = (moved >= f.times[0] - f.tolerance) & (moved <= f.times[-1] + f.tolerance)
    times = merged(np.clip(moved[inside], f.times[0], f.times[-1]), f.tolerance)
    found = [times]
    for start, end in zip(times[:-1].tolist(), times[1:].tolist(), strict=True):
        found.append(search.changes(start, end))
    times = merged(np.concatenate(found), f.tolerance)
    at = np.array([search.level(time) for time in times.tolist()])
    # Linear from one to the next: two levels in between say what the limits at both are.
    third = np.diff(times) / 3
    first = np.array([search.level(time) for time in (times[:-1] + third).tolist()])
    second = np.array([search.level(time) for time in (times[:-1] + 2 * third).tolist()])
    is_flat = first == second
    with np.errstate(invalid="ignore"):
        after = np.where(is_flat, first, 2 * first - second)
        before = np.where(is_flat, first, 2 * second - first)
    return PiecewiseLinear(times, at, after, before, f.tolerance)


@dataclass(frozen=True)
class _Pieces:
    """The pieces of a function in a window: how long each is, and its values at both ends."""

    lengths: FloatArray
    first: FloatArray
    last: FloatArray

    @property
    def levels(self) -> FloatArray:
        """All values at ends, in order."""
        return np.unique(np.concatenate([self.first, self.last]))

    def time_at(self, level: float) -> float:
        """For how long the function is at this level or above."""
        top, bottom = np.maximum(self.first, self.last), np.minimum(self.first, self.last)
        with np.errstate(invalid="ignore", divide="ignore"):
            share = np.clip((top - level) / (top - bottom), 0.0, 1.0)
        share = np.where(bottom >= level, 1.0, np.where(top <= level, 0.0, share))
        return float(self.lengths @ share)

    def time_above(self, level: float) -> float:
        """For how long it is above this level."""
        flat = (self.first == level) & (self.last == level)
        return self.time_at(level) - float(self.lengths[flat].sum())

    def greatest(self, amount: float) -> float:
        """The greatest level that lasts for `amount`; -inf where the pieces are shorter."""
        levels = self.levels
        low, high = -1, levels.size  # levels[low] lasts long enough, levels[high] does not
        while high - low > 1:
            middle = (low + high) // 2
            if self.time_at(float(levels[middle])) >= amount:
                low = middle
            else:
                high = middle
        if low < 0:
            return -np.inf
        level = float(levels[low])
        above = self.time_above(level)
        if high == levels.size or above < amount:
            return level
        following = float(levels[high])
        there = self.time_at(following)
        return level + (following - level) * ((above - amount) / (above - there))


class _LevelSearch:
    """Levels of one function for windows of one shape."""

    def __init__(
        self, f: PiecewiseLinear, interval: Interval, amount: float, enough: float
    ) -> None:
        self.f, self.interval, self.amount, self.enough = f, interval, amount, enough
        self.end = float(f.times[-1])

    def level(self, time: float) -> float:
        """The greatest level that lasts for long enough in the window of `time`."""
        return self._window(time).greatest(self.enough)

    def changes(self, start: float, end: float) -> FloatArray:
        """The moments between two at which the level may begin to go another way, where no end of
        the window passes a breakpoint in between."""
        whole, length = self._window(start), end - start
        low = whole.greatest(self.amount + length)
        # What comes into the window may by itself last for long enough.
        enters = self.amount <= length + self.f.tolerance
        high = np.inf if enters else whole.greatest(self.amount - length)
        if low == high:
            return np.empty(0)
        around = self._between(start + self.interval.lo, min(end + self.interval.hi, self.end))
        levels = np.append(around.levels, -np.inf)  # -inf: where the window is too short
        levels = levels[(levels >= low) & (levels <= high)]
        found = self._edges_meet(start, end)
        for level in levels.tolist():
            found += self._passed(level, start, end)
        times = self._inside(found, start, end)
        for edge in self._moving_edges(start):
            found += self._met(edge, np.concatenate([[start], times, [end]]))
        return self._inside(found, start, end)

    def _inside(self, times: list[float], start: float, end: float) -> FloatArray:
        """In order, those clear of both ends."""
        if not times:
            return np.empty(0)
        clear = 2 * self.f.tolerance
        ordered = merged(np.array(times), self.f.tolerance)
        result: FloatArray = ordered[(ordered > start + clear) & (ordered < end - clear)]
        return result

    def _moving_edges(self, start: float) -> list[float]:
        """How far ahead the ends of the window are that are not at the end of the function yet."""
        edges = (self.interval.lo, self.interval.hi)
        return [edge for edge in edges if start + edge < self.end - self.f.tolerance]

    def _edges_meet(self, start: float, end: float) -> list[float]:
        """When both ends of the window are at one level."""
        edges = self._moving_edges(start)
        if len(edges) < 2:
            return []
        near, far = (self._along(edge, start, end) for edge in edges)
        with np.errstate(invalid="ignore"):
            apart = [near[0] - far[0], near[1] - far[1]]
        return _zeros([start, end], apart)

    def _passed(self, level: float, start: float, end: float) -> list[float]:
        """When an end of the window is at a level, and when the level lasts for just the amount."""
        kinks = [start, end]
        for edge in self._moving_edges(start):
            first, last = self._along(edge, start, end)
            if min(first, last) < level < max(first, last):
                kinks.append(start + (end - start) * (level - first) / (last - first))
        kinks.sort()
        windows = [self._window(time) for time in kinks]
        at = [window.time_at(level) - self.amount for window in windows]
        above = [window.time_above(level) - self.amount for window in windows]
        return kinks[1:-1] + _zeros(kinks, at) + _zeros(kinks, above)

    def _met(self, edge: float, times: FloatArray) -> list[float]:
        """When the level is that at one end of the window."""
        found: list[float] = []
        for start, end in zip(times[:-1].tolist(), times[1:].tolist(), strict=True):
            first, last = self._along(edge, start, end)
            third = (end - start) / 3
            # Linear in between, but not at the ends, where the window may gain a level.
            near = self._window(start + third).time_at(first + (last - first) / 3)
            far = self._window(end - third).time_at(last - (last - first) / 3)
            excess = [2 * near - far - self.amount, 2 * far - near - self.amount]
            found += _zeros([start, end], excess)
        return found

    def _along(self, edge: float, start: float, end: float) -> tuple[float, float]:
        """The values at one end of the window as that moves along a piece."""
        moments = np.minimum(np.array([start, end]) + edge, self.end)
        before, _, after = self.f.limits(moments)
        return float(after[0]), float(before[1])

    def _window(self, time: float) -> _Pieces:
        return self._between(time + self.interval.lo, min(time + self.interval.hi, self.end))

    def _between(self, first: float, last: float) -> _Pieces:
        nothing = np.empty(0)
        if last <= first:
            return _Pieces(nothing, nothing, nothing)
        times = self.f.times
        low = int(np.searchsorted(times, first + self.f.tolerance, "right"))
        high = int(np.searchsorted(times, last - self.f.tolerance, "left"))
        edges = np.concatenate([[first], times[low:high], [last]])
        before, _, after = self.f.limits(edges)
        return _Pieces(np.diff(edges), after[:-1], before[1:])


def _zeros(times: list[float], values: list[float]) -> list[float]:
    """Where what is linear between these times is 0, not counting the times themselves."""
    found = []
    for k in range(len(times) - 1):
        first, last = values[k], values[k + 1]
        if first * last < 0:
            found.append(times[k] + (times[k + 1] - times[k]) * (first / (first - last)))
    return found
