"""What each sample of a window weighs for a count or a duration, and how much is enough."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ..formula.interval import UNBOUNDED
from .axis import SamplePositions
from .trace import FloatArray
from .windows import BoolArray, IntArray, Windows

if TYPE_CHECKING:
    from .graph_operations import Measuring


@dataclass(frozen=True)
class WeighedWindows:
    """Samples `starts[k]..ends[k]` of a column for each window k, end < start: none.

    Each sample weighs `weights` (n,), the last one of a window `last` (count,); `enough` (count,)
    is the weight that is to be exceeded.
    """

    starts: IntArray
    ends: IntArray
    weights: FloatArray
    last: FloatArray
    enough: FloatArray


@dataclass(frozen=True)
class UnseenWeights:
    """What samples that are yet to come may add: `more` (count,) weight, at the level of any of
    the samples `starts[k]..ends[k]`, for the windows that are `open`."""

    starts: IntArray
    ends: IntArray
    more: FloatArray
    open: BoolArray


def weighed_windows(
    axis: SamplePositions, windows: Windows, operation: Measuring, targets: tuple[int, int]
) -> tuple[WeighedWindows, UnseenWeights | None]:
    """The windows of the samples `targets`, and for an upper bound what may be added to them."""
    samples = windows.span[1] - windows.span[0] + 1
    ends = np.minimum(windows.ends, windows.starts + samples - 1)  # on a lap each sample once
    if operation.counts:
        weights, last = np.ones(samples * windows.laps), np.ones(windows.count)
    else:
        weights, last = _durations(axis, windows, operation, targets, ends)
    latest = float(axis.positions[-1 if axis.seen is None else axis.seen - 1])
    enough = np.full(windows.count, enough_weight(operation, axis.tolerance, latest))
    weighed = WeighedWindows(windows.starts, ends, weights, last, enough)
    if operation.side is None:
        return weighed, None
    return _bounded(axis, windows, operation, targets, weighed)


def enough_weight(operation: Measuring, tolerance: float, latest: float) -> float:
    """The weight that is to be exceeded: between two counts, or as near to a duration as sums of
    positions up to `latest` are."""
    if operation.counts:
        amount = operation.amount
        return math.floor(amount) + 0.5 if operation.strict else math.ceil(amount) - 0.5
    slack = tolerance + 8 * math.ulp(latest + operation.amount)
    return max(operation.amount + (slack if operation.strict else -slack), 0.0)


def _durations(
    axis: SamplePositions,
    windows: Windows,
    operation: Measuring,
    targets: tuple[int, int],
    ends: IntArray,
) -> tuple[FloatArray, FloatArray]:
    """How long each sample lasts, and how long the last one of each window does within it."""
    low, high = windows.span
    closing = axis.positions[-1] if axis.wrap is None else axis.positions[0] + axis.wrap
    following = np.append(axis.positions[1:], closing)[low : high + 1]
    places = axis.positions[low : high + 1]
    if windows.laps > 1 and axis.wrap is not None:
        lap = axis.wrap * np.arange(windows.laps)[:, None]
        places, following = (places + lap).ravel(), (following + lap).ravel()
    interval = axis.unrolled(operation.interval or UNBOUNDED)
    limit = axis.positions[targets[0] : targets[1] + 1] + interval.hi
    chosen = np.clip(ends, 0, places.size - 1)
    last = np.maximum(np.minimum(following[chosen], limit) - places[chosen], 0.0)
    return following - places, last


def _bounded(
    axis: SamplePositions,
    windows: Windows,
    operation: Measuring,
    targets: tuple[int, int],
    weighed: WeighedWindows,
) -> tuple[WeighedWindows, UnseenWeights | None]:
    """Of the last sample seen it is not known how long it lasts, of later ones nothing is."""
    assert axis.seen is not None
    latest = axis.seen - 1 - windows.span[0]
    weights, last = weighed.weights.copy(), weighed.last.copy()
    if not operation.counts:
        weights[max(latest, 0) :] = 0.0
        last[weighed.ends >= latest] = 0.0
    weighed = replace(weighed, weights=weights, last=last)
    if operation.side == "lower":
        return weighed, None
    is_open = windows.ends > latest
    first = latest + 1 if operation.counts else latest
    starts = np.maximum(windows.starts, first)
    more = np.full(windows.count, np.inf)
    interval = operation.interval or UNBOUNDED
    if not operation.counts and math.isfinite(interval.hi):
        passed = float(axis.positions[axis.seen - 1]) - axis.positions[targets[0] : targets[1] + 1]
        more = interval.hi - np.clip(passed, interval.lo, interval.hi)
    seen = replace(weighed, ends=np.minimum(weighed.ends, latest))
    return seen, UnseenWeights(starts, windows.ends, more, is_open)
