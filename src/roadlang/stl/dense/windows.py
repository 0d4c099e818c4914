"""Temporal operators on functions that are linear between breakpoints.

Windows are clipped to the time for which the function is known. Where a function does not attain
its extreme on an interval, the limit counts: robustness is an infimum or a supremum.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from ..evaluate.sliding_and_until import GREATEST, LEAST, Extreme, slide_between, unbounded_until
from ..evaluate.trace import FloatArray
from ..evaluate.windows import BoolArray, IntArray
from ..formula.interval import Interval
from .piecewise import PiecewiseLinear, extreme_of, merged, together


def sliding(
    f: PiecewiseLinear, interval: Interval, extreme: Extreme, *, open_end: bool = False
) -> PiecewiseLinear:
    """The extreme of `f` over t + [lo, hi]; `open_end`: over t + [lo, hi)."""
    low, high, tolerance, end = interval.lo, interval.hi, f.tolerance, f.times[-1]
    events = [f.times[[0, -1]], f.times - low]
    if math.isfinite(high):
        events.append(f.times - high)
    moved = np.concatenate(events)
    inside = (moved >= f.times[0] - tolerance) & (moved <= end + tolerance)
    times = merged(np.clip(moved[inside], f.times[0], end), tolerance)
    at = _at_points(f, times, interval, extreme, open_end)
    first = times[:-1]
    begins = np.searchsorted(f.times, first + low + tolerance, "right")
    ends = np.searchsorted(f.times, np.minimum(first + high, end) + tolerance, "right") - 1
    held = _over_breakpoints(f, begins, ends, extreme)
    empty = first + low >= end - tolerance
    near = _moving(f, times, low, extreme, empty)
    far = _moving(f, times, high, extreme, empty | (first + high >= end - tolerance))
    held[empty] = extreme.identity
    pieces = PiecewiseLinear(times, at, held, held, tolerance)
    for after, before in (near, far):
        end_of_window = PiecewiseLinear(times, at, after, before, tolerance)
        pieces = extreme_of(pieces, end_of_window, extreme)
    return pieces


def _moving(
    f: PiecewiseLinear, times: FloatArray, shift: float, extreme: Extreme, absent: BoolArray
) -> tuple[FloatArray, FloatArray]:
    """(after, before): the value at one end of the window while it moves along a piece of f."""
    if math.isinf(shift):
        nothing = np.full(times.size - 1, extreme.identity)
        return nothing, nothing
    before, _, after = f.limits(np.minimum(times + shift, f.times[-1]))
    return (
        np.where(absent, extreme.identity, after[:-1]),
        np.where(absent, extreme.identity, before[1:]),
    )


def _over_breakpoints(
    f: PiecewiseLinear, first: IntArray, last: IntArray, extreme: Extreme
) -> FloatArray:
    """The extreme of the values and limits at the breakpoints first..last."""
    nothing = np.array([extreme.identity])
    around = extreme.ufunc(np.concatenate([nothing, f.before]), np.concatenate([f.after, nothing]))
    values = extreme.ufunc(f.at, around)[:, None]
    return slide_between(values, first, last, extreme)[:, 0]


def _at_points(
    f: PiecewiseLinear,
    times: FloatArray,
    interval: Interval,
    extreme: Extreme,
    open_end: bool,
) -> FloatArray:
    """The extreme over the window of each of `times`, from one end of it to the other."""
    tolerance, end = f.tolerance, f.times[-1]
    starts, ends = times + interval.lo, np.minimum(times + interval.hi, end)
    _, first, after = f.limits(np.minimum(starts, end))
    before, last, _ = f.limits(ends)
    first_inside = np.searchsorted(f.times, starts + tolerance, "right")
    last_inside = np.searchsorted(f.times, ends - tolerance, "left") - 1
    held = _over_breakpoints(f, first_inside, last_inside, extreme)
    is_long = ends > starts + tolerance
    edges = extreme.ufunc(after, before)
    if not open_end:
        edges = extreme.ufunc(edges, last)
    values = extreme.ufunc(first, np.where(is_long, extreme.ufunc(held, edges), extreme.identity))
    return np.where(starts > end + tolerance, extreme.identity, values)


def reaching(left: PiecewiseLinear, right: PiecewiseLinear, interval: Interval) -> PiecewiseLinear:
    """`left until[lo, hi] right`: as for samples (Donze, Ferrere, Maler, CAV 2013), left before
    the window, right inside it, and the unbounded until at its start."""
    found = _unbounded(left, right)
    width = interval.hi - interval.lo
    if math.isfinite(interval.hi):
        found = extreme_of(found, sliding(right, Interval(0.0, width), GREATEST), LEAST)
    if interval.lo == 0:
        return found
    before = sliding(left, Interval(0.0, interval.lo), LEAST, open_end=True)
    return extreme_of(_earlier(found, interval.lo), before, LEAST)


def _unbounded(left: PiecewiseLinear, right: PiecewiseLinear) -> PiecewiseLinear:
    """Where neither crosses the other, on a piece until is max(right, min(left, onward)), with a
    number `onward` for what follows: a scan over the breakpoints and the limits at them."""
    left, right = together(left, right, crossings=True)
    count = left.times.size
    lefts, rights = np.empty(3 * count - 2), np.empty(3 * count - 2)
    lefts[::3], rights[::3] = left.at, right.at
    for offset, (p, q) in ((1, (left.after, right.after)), (2, (left.before, right.before))):
        lefts[offset::3], rights[offset::3] = p, np.minimum(p, q)
    scanned = unbounded_until(lefts[:, None], rights[:, None])[:, 0]
    at, onward = scanned[::3], scanned[2::3]
    ahead = replace(left, at=at, after=onward, before=onward)
    path = extreme_of(replace(left, at=at), ahead, LEAST)
    return extreme_of(replace(right, at=at), path, GREATEST)


def _earlier(f: PiecewiseLinear, shift: float) -> PiecewiseLinear:
    """f(t + shift) for the times of f; -inf where that is behind its end."""
    start, end = f.times[0], f.times[-1]
    nothing = np.array([-np.inf])
    if start + shift > end + f.tolerance:
        return PiecewiseLinear(
            f.times[[0, -1]], np.repeat(nothing, 2), nothing, nothing, f.tolerance
        )
    times = f.times[f.times > start + shift + f.tolerance]
    part = f.refined(np.append(start + shift, times))
    return PiecewiseLinear(
        np.append(np.append(start, times - shift), end),
        np.append(part.at, nothing),
        np.append(part.after, nothing),
        np.append(part.before, nothing),
        f.tolerance,
    )
