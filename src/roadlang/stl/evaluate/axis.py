"""Positions of the samples, and which of them each window of a temporal operator holds."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..formula.interval import UNBOUNDED, Interval, NeighborWindow, Reach
from .trace import FloatArray

IntArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]

TOLERANCE = 1e-6
"""A sample belongs to a window if it misses it by at most this share of the median step."""


@dataclass(frozen=True)
class Windows:
    """Samples `starts[k]..ends[k]` of the operand for each sample that is evaluated; end < start:
    none.

    Past operators look at time backwards (`flipped`), closed roads repeat the operand (`laps`);
    `starts`, `ends` and `first` count from the beginning of the operand's `span` seen that way.
    `span` is the samples of the operand that are needed, in their own order.
    """

    starts: IntArray
    ends: IntArray
    first: int
    span: tuple[int, int]
    flipped: bool
    laps: int

    @property
    def count(self) -> int:
        """Number of windows."""
        return int(self.starts.size)

    def samples(self, window: int) -> IntArray:
        """The samples of one window as indices on the axis, from its near end to its far end."""
        return self._on_axis(np.arange(self.starts[window], self.ends[window] + 1))

    def before(self, window: int, sample: int) -> IntArray:
        """For until: the samples from the one that is evaluated to the `sample`-th of its
        window."""
        return self._on_axis(np.arange(self.first + window, self.starts[window] + sample))

    def reached(self, chosen: BoolArray, *, path: bool) -> BoolArray:
        """(span,) which samples of the span the `chosen` windows (count,) hold; `path`: and those
        on the way to them."""
        held = chosen & (self.ends >= self.starts)
        starts = self.first + np.flatnonzero(held) if path else self.starts[held]
        samples = self.span[1] - self.span[0] + 1
        edges = np.zeros(samples * self.laps + 1, dtype=np.intp)
        np.add.at(edges, starts, 1)
        np.add.at(edges, self.ends[held] + 1, -1)
        covered = (np.cumsum(edges[:-1]) > 0).reshape(self.laps, samples)
        reached: BoolArray = np.asarray(covered.any(axis=0))
        return reached[::-1] if self.flipped else reached

    def _on_axis(self, counted: IntArray) -> IntArray:
        low, high = self.span
        counted = counted % (high - low + 1)
        return high - counted if self.flipped else low + counted

    @cached_property
    def even(self) -> tuple[int, int] | None:
        """(offset, width) if window k is [k + offset, k + offset + width), clipped at the end."""
        last = (self.span[1] - self.span[0] + 1) * self.laps - 1
        steps = np.arange(self.count)
        offset = int(self.starts[0])
        width = int((self.ends - steps).max()) - offset + 1
        regular = (self.starts == np.minimum(offset + steps, last + 1)).all()
        clipped = np.minimum(offset + width - 1 + steps, last)
        return (offset, width) if regular and (self.ends == clipped).all() else None


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
    seen: int | None = None

    @classmethod
    def of(cls, positions: FloatArray, wrap: float | None = None) -> SamplePositions:
        """The samples at these positions, whatever the origin of their clock.

        Counted from the first sample, windows of time stamps since 1970 are as exact as those
        that start at 0. The tolerance covers what the stamps themselves cannot resolve.
        """
        steps = np.diff(positions)
        step = float(np.median(steps)) if steps.size else 0.0
        furthest = max(abs(float(positions[0])), abs(float(positions[-1])))
        return cls(positions - positions[0], TOLERANCE * step + 2 * math.ulp(furthest), wrap)

    @property
    def size(self) -> int:
        """How many samples there are, stand-ins included."""
        return int(self.positions.size)

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
        counted = self._counted(reach, targets, past=past, path=path)
        return None if (counted.ends < counted.starts).all() else self._relative(counted, path)

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
