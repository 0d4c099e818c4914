"""Positions of the samples, and where the windows of temporal operators begin and end on them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..formula.interval import UNBOUNDED, Interval, NeighborWindow, Reach
from .trace import FloatArray
from .windows import BoolArray, IntArray, Windows

TOLERANCE = 1e-6
"""A sample belongs to a window if it misses it by at most this share of the median step."""


@dataclass(frozen=True)
class EvenPitch:
    """An even grid: the distance of neighbors, and how far a sample is from its place at most."""

    step: float
    unevenness: float


@dataclass(frozen=True)
class SamplePositions:
    """The samples of a trace: `positions` (S,), counted from the first one, and the length of the
    road if it is closed.

    `ends` (S,) differs from `positions` for stand-ins only (`ahead.py`): such a sample is anywhere
    between the two, and they follow the first `seen` samples. `tolerance`: how far from a window a
    sample may lie and still belong to it.
    """

    positions: FloatArray
    tolerance: float
    wrap: float | None = None
    ends: FloatArray | None = None
    pitch: EvenPitch | None = None
    seen: int | None = None

    @classmethod
    def of(cls, positions: FloatArray, wrap: float | None = None) -> SamplePositions:
        """The samples at these positions, whatever the origin of their clock.

        Counted from the first sample, windows of time stamps since 1970 are as exact as those
        that start at 0. The tolerance covers what the stamps themselves cannot resolve.
        """
        counted = positions - positions[0]
        pitch = _pitch(counted)
        if pitch is not None:
            step = pitch.step
        else:
            step = float(np.median(np.diff(positions))) if positions.size > 1 else 0.0
        furthest = max(abs(float(positions[0])), abs(float(positions[-1])))
        return cls(counted, TOLERANCE * step + 2 * math.ulp(furthest), wrap, pitch=pitch)

    @property
    def size(self) -> int:
        """How many samples there are, stand-ins included."""
        return int(self.positions.size)

    def unrolled(self, interval: Interval) -> Interval:
        """The interval as it is used: on a closed road at most one lap long."""
        if self.wrap is None:
            return interval
        return _unrolled(interval, self.wrap, self.tolerance, keep_lead=False)

    def windows(
        self,
        reach: Reach,
        targets: tuple[int, int],
        *,
        past: bool,
        path: bool = False,
    ) -> Windows | None:
        """Windows of the samples `targets` (first, last), or None if all of them are empty.

        `path` extends the operand's span to the samples that are evaluated, as until needs.
        """
        shifts = self._shifts(reach)
        if shifts is not None:
            return self._even_windows(*shifts, targets, past=past, path=path)
        counted = self._counted(reach, targets, past=past, path=path)
        return None if (counted.ends < counted.starts).all() else self._relative(counted, path)

    def _shifts(self, reach: Reach) -> tuple[int, int] | None:
        """By how many samples the ends of each window are ahead, where all of them are alike.

        That is so on an even grid if no sample is near to the end of a window: nearer than the
        grid is uneven.
        """
        if self.pitch is None or self.wrap is not None or self.ends is not None:
            return None
        if isinstance(reach, NeighborWindow):
            return None
        interval, step = reach or UNBOUNDED, self.pitch.step
        near = 2 * self.pitch.unevenness + 16 * math.ulp(float(self.positions[-1]) + interval.lo)
        first = math.ceil((interval.lo - self.tolerance) / step) if interval.lo else 0
        if interval.lo and _is_near(first, interval.lo - self.tolerance, step, near):
            return None
        if math.isinf(interval.hi) or interval.hi > self.positions[-1] + step:
            return first, self.size
        last = math.floor((interval.hi + self.tolerance) / step)
        is_near = _is_near(last, interval.hi + self.tolerance, step, near)
        return None if is_near else (first, last)

    def _even_windows(
        self, first: int, last: int, targets: tuple[int, int], *, past: bool, path: bool
    ) -> Windows | None:
        """Windows [k + first, k + last], clipped at the end."""
        if past:
            targets = (self.size - 1 - targets[1], self.size - 1 - targets[0])
        start, end = targets[0] + first, min(targets[1] + last, self.size - 1)
        if last < first or start > self.size - 1:
            return None
        low = targets[0] if path else start
        limit, count = end - low + 1, targets[1] - targets[0] + 1
        starts = np.arange(start - low, start - low + count, dtype=np.intp)
        ends = starts + (last - first)
        width = min(int(ends[0]), limit - 1) - (start - low) + 1
        return Windows(
            starts=np.minimum(starts, limit, out=starts),
            ends=np.minimum(ends, limit - 1, out=ends),
            first=targets[0] - low,
            span=(self.size - 1 - end, self.size - 1 - low) if past else (low, end),
            flipped=past,
            laps=1,
            known_even=(start - low, width),
        )

    def between_samples(self, reach: Reach, targets: tuple[int, int], *, past: bool) -> BoolArray:
        """Which of the samples `targets` have a window that falls between two samples.

        A window beyond the end of the trace, or before its start, is not one of them.
        """
        counted = self._counted(reach, targets, past=past, path=False)
        if isinstance(reach, NeighborWindow):
            return np.zeros(counted.starts.size, dtype=bool)
        empty = (counted.ends < counted.starts) & (counted.starts < self.size * counted.laps)
        return empty[::-1] if past else empty

    def _counted(
        self, reach: Reach, targets: tuple[int, int], *, past: bool, path: bool
    ) -> _CountedWindows:
        if isinstance(reach, NeighborWindow):
            return self._neighbors(targets, past=past)
        interval = reach or UNBOUNDED
        laps = 1
        if self.wrap is not None:
            interval = _unrolled(interval, self.wrap, self.tolerance, keep_lead=path)
            laps = 1 + math.ceil((interval.hi - self.tolerance) / self.wrap)
        lows, highs = self.positions, self.positions if self.ends is None else self.ends
        if past:
            lows, highs = -highs[::-1], -lows[::-1]
            targets = (self.size - 1 - targets[1], self.size - 1 - targets[0])
        if laps > 1 and self.wrap is not None:
            lows = highs = (lows + self.wrap * np.arange(laps)[:, None]).ravel()
        starts, ends = _bounds(lows, highs, interval, targets, self.tolerance)
        return _CountedWindows(starts, ends, targets, laps, past)

    def _neighbors(self, targets: tuple[int, int], *, past: bool) -> _CountedWindows:
        """Behind the samples seen the neighbor is any of the stand-ins on that side: a stand-in
        stands for many samples, so that its neighbor may be like it."""
        seen = self.size if self.seen is None else self.seen
        samples = np.arange(targets[0], targets[1] + 1)
        if not past:
            unseen = (samples >= seen - 1) & (seen < self.size)
            starts = np.where(unseen, np.maximum(samples, seen), samples + 1)
            ends = np.where(unseen, self.size - 1, samples + 1)
        else:
            unseen = samples >= seen
            starts = np.where(unseen, self.size - 1 - samples, self.size - samples)[::-1]
            ends = np.where(unseen, self.size - seen, self.size - samples)[::-1]
            targets = (self.size - 1 - targets[1], self.size - 1 - targets[0])
        laps = 1 if self.wrap is None else 2
        ends = np.minimum(ends, self.size * laps - 1)
        return _CountedWindows(starts, ends, targets, laps, past)

    def _relative(self, counted: _CountedWindows, path: bool) -> Windows:
        """Counted from the first sample that any of the windows needs."""
        starts, ends, laps = counted.starts, counted.ends, counted.laps
        held = ends >= starts
        low = counted.targets[0] if path else int(starts[held].min())
        low, high = (0, self.size - 1) if laps > 1 else (low, int(ends.max()))
        past = counted.flipped
        span = (self.size - 1 - high, self.size - 1 - low) if past else (low, high)
        limit = (high - low + 1) * laps
        return Windows(
            starts=np.clip(starts - low, 0, limit),
            ends=np.clip(ends - low, -1, limit - 1),
            first=counted.targets[0] - low,
            span=span,
            flipped=past,
            laps=laps,
        )


@dataclass(frozen=True)
class _CountedWindows:
    """As `Windows`, counted from the first sample of the axis as the operator looks at it; of an
    empty window `starts` is the next sample, `targets` are counted likewise."""

    starts: IntArray
    ends: IntArray
    targets: tuple[int, int]
    laps: int
    flipped: bool


def _pitch(positions: FloatArray) -> EvenPitch | None:
    """Of positions that begin with 0; None where they are not even to a thousandth of the
    tolerance."""
    if positions.size < 2:
        return None
    step = float(positions[-1]) / (positions.size - 1)
    places = np.arange(positions.size, dtype=np.float64)
    places *= step
    places -= positions
    unevenness = max(float(places.max()), -float(places.min()))
    return EvenPitch(step, unevenness) if unevenness <= 1e-3 * TOLERANCE * step else None


def _is_near(samples: int, bound: float, step: float, near: float) -> bool:
    """Whether so many steps, or one more or less, end at a bound as far as can be told."""
    return any(abs((samples + k) * step - bound) <= near for k in (-1, 0, 1))


def _bounds(
    lows: FloatArray,
    highs: FloatArray,
    interval: Interval,
    targets: tuple[int, int],
    tolerance: float,
) -> tuple[IntArray, IntArray]:
    """First and last sample that meets the window of each sample that is evaluated."""
    indices = np.arange(targets[0], targets[1] + 1)
    near = lows[indices] + interval.lo
    starts = np.maximum(np.searchsorted(highs, near - slack(near, tolerance), "left"), indices)
    if math.isinf(interval.hi):
        return starts, np.full(starts.shape, lows.size - 1, dtype=np.intp)
    far = highs[indices] + interval.hi
    ends = np.searchsorted(lows, far + slack(far, tolerance), "right") - 1
    return starts, ends


def slack(bounds: FloatArray, tolerance: float) -> FloatArray:
    """The tolerance at each bound of a window, with room for the rounding of the bound itself."""
    with np.errstate(invalid="ignore"):
        rounding: FloatArray = 4 * np.spacing(np.abs(bounds))
    return np.where(np.isinf(bounds), 0.0, tolerance + rounding)


def _unrolled(interval: Interval, period: float, tolerance: float, *, keep_lead: bool) -> Interval:
    """The same window on a closed road, at most one lap long and begun in an early lap.

    Until keeps one whole lap before the window (`keep_lead`): its left operand holds there.
    """
    length = min(interval.hi - interval.lo, period)
    laps = math.floor((interval.lo + tolerance) / period)
    lead = 1 if keep_lead and laps >= 1 else 0
    lo = max(0.0, interval.lo - (laps - lead) * period)
    return Interval(lo, lo + length)
