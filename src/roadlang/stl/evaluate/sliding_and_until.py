"""Sliding extremes and the until recursion on arrays (samples, rows).

Cost per sample grows with the logarithm of the window at most. Time is the first axis, so that
a shift in time is one contiguous operation over all rows of a chunk.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .trace import FloatArray
from .windows import IntArray, Windows


@dataclass(frozen=True)
class Extreme:
    """Least or greatest: the ufunc, and what it gives for no samples at all."""

    ufunc: np.ufunc
    identity: float


LEAST = Extreme(np.minimum, np.inf)
GREATEST = Extreme(np.maximum, -np.inf)


def slide(values: FloatArray, windows: Windows, extreme: Extreme) -> FloatArray:
    """The extreme of `values` (n, r) in each window: (windows.count, r)."""
    if windows.count == 1:
        start, end = int(windows.starts[0]), int(windows.ends[0])
        result: FloatArray = extreme.ufunc.reduce(values[start : end + 1], axis=0, keepdims=True)
        return result
    values = np.ascontiguousarray(values)
    if windows.even is not None:
        return _slide_even(values, *windows.even, windows.count, extreme)
    return slide_between(values, windows.starts, windows.ends, extreme)


def _slide_even(
    values: FloatArray, offset: int, width: int, count: int, extreme: Extreme
) -> FloatArray:
    """Windows [k + offset, k + offset + width), clipped at the end, for k < count."""
    samples = len(values)
    width = min(width, samples)
    if width == samples and values.shape[1] == 1:
        table, covered = extreme.ufunc.accumulate(values[::-1], axis=0)[::-1], width
    else:
        table, covered = _doubled(values, width, extreme)
    result = np.empty((count, values.shape[1]))
    near = max(0, min(count, samples - offset))
    far = max(0, min(near, samples - offset - (width - covered)))
    shifted = table[offset + width - covered : offset + width - covered + far]
    extreme.ufunc(table[offset : offset + far], shifted, out=result[:far])
    result[far:near] = table[offset + far : offset + near]
    result[near:] = extreme.identity
    return result


def _doubled(values: FloatArray, width: int, extreme: Extreme) -> tuple[FloatArray, int]:
    """Extremes of windows [k, k + covered), covered the greatest power of two <= width."""
    table, spare, covered = values, np.empty(0), 1
    while 2 * covered <= width:
        out = np.empty_like(values) if spare.size == 0 else spare
        extreme.ufunc(table[:-covered], table[covered:], out=out[:-covered])
        out[-covered:] = table[-covered:]
        spare = table if table is not values else np.empty(0)
        table, covered = out, 2 * covered
    return table, covered


def slide_between(
    values: FloatArray, starts: IntArray, ends: IntArray, extreme: Extreme
) -> FloatArray:
    """The extreme over values[starts[k] : ends[k] + 1] for any windows, from a sparse table."""
    result = np.full((starts.size, values.shape[1]), extreme.identity)
    if not starts.size:
        return result
    widths = ends - starts + 1
    levels = np.frexp(np.maximum(widths, 1))[1] - 1
    levels[widths < 1] = -1
    table, covered = values, 1
    for level in range(int(levels.max()) + 1):
        chosen = np.flatnonzero(levels == level)
        if chosen.size:
            near, far = table[starts[chosen]], table[ends[chosen] - covered + 1]
            result[chosen] = extreme.ufunc(near, far)
        if len(table) > covered:
            table = extreme.ufunc(table[:-covered], table[covered:])
        covered *= 2
    return result


def until(left: FloatArray, right: FloatArray, windows: Windows) -> FloatArray:
    """`left until right` with the witness in each window, for samples first..first+count-1.

    Donze, Ferrere, Maler (CAV 2013) split it: left before the window, right inside it, and the
    unbounded until at its start; an uneven grid changes nothing in their argument.
    """
    present = windows.first + np.arange(windows.count)
    starts, ends = windows.starts, windows.ends
    held = ends >= starts
    if windows.count == 1:
        left, right = left[: ends[0] + 1], right[: ends[0] + 1]
    low = int(starts[held].min())
    last = len(right) - 1
    scanned = unbounded_until(left[low:], right[low:])
    result = scanned[np.clip(starts - low, 0, len(scanned) - 1)]
    if (ends < last).any():
        np.minimum(slide(right, windows, GREATEST), result, out=result)
    if (starts > present).any():
        before = Windows(present, np.minimum(starts, last + 1) - 1, 0, (0, last), False, 1)
        np.minimum(slide(left, before, LEAST), result, out=result)
    result[~held] = -np.inf
    return result


def unbounded_until(left: FloatArray, right: FloatArray) -> FloatArray:
    """u[k] = max(right[k], min(left[k], u[k+1])), u = -inf past the end; arrays (n, r).

    Each step clamps u, and clamps compose: blocks of samples are scanned side by side, from
    u = -inf and from u = +inf at once, then joined from the last to the first.
    """
    samples, rows = right.shape
    blocks = max(1, min(int(np.sqrt(samples)), 2048 // rows))
    length = -(-samples // blocks)
    left, right = (
        _in_blocks(left, blocks, length, np.inf),
        _in_blocks(right, blocks, length, -np.inf),
    )
    bounds = np.empty((2, blocks, length, rows))
    latest = np.empty((2, blocks, rows))
    latest[0], latest[1] = -np.inf, np.inf
    for step in range(length - 1, -1, -1):
        np.minimum(left[:, step], latest, out=latest)
        np.maximum(right[:, step], latest, out=latest)
        bounds[:, :, step] = latest
    carry = np.full(rows, -np.inf)
    for block in range(blocks - 1, -1, -1):
        lower, upper = bounds[0, block], bounds[1, block]
        np.maximum(lower, np.minimum(upper, carry, out=upper), out=lower)
        carry = lower[0]
    result: FloatArray = bounds[0].reshape(blocks * length, rows)[:samples]
    return result


def _in_blocks(values: FloatArray, blocks: int, length: int, padding: float) -> FloatArray:
    samples, rows = values.shape
    missing = blocks * length - samples
    if missing:
        values = np.concatenate([values, np.full((missing, rows), padding)])
    return values.reshape(blocks, length, rows)
