"""Places where two that come toward each other do not fit side by side; compiled where numba is
loaded, with the same formulas and to the same bits."""

from __future__ import annotations

import math
import sys
from functools import cache
from typing import Any

import numpy as np

from ...geometry.areas.levels import are_apart
from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.curves import bend_room
from ...geometry.curves.bend_room import PASSING_GAP
from ..vehicles import compiled
from . import sampled_ways
from .sampled_ways import SPACING, SampledWays

COARSE = 3
"""Of so many samples, one is looked at first."""
OPPOSED = -0.5
"""Cosine of the angle between the lines of two that come toward each other, at most."""
WIDEST = 8.0
"""Meters: lines farther apart have room for two."""
NEAR = WIDEST + 2.0 * (COARSE - 1) * SPACING
"""Meters: where no samples that are looked at first are that near, no others are within `WIDEST`.
At the end of a line, the last sample can be `COARSE` - 1 beyond the last of those."""


def narrow_places(
    lines: SampledWays, first: Integers, second: Integers
) -> tuple[Floats, Floats] | None:
    """(2, 2 P) meters from the front of each of a pair to the first sample in a place where both do
    not fit side by side, infinite for none, and until its rear has left it: in the next such place
    of the first, and in all others together. None where all pairs fit everywhere. Of pairs whose
    lines do not come close to each other anywhere, there may be none."""
    if lines.height is None and compiled.is_loaded():
        out = np.empty((2, 2, 2 * len(first)))
        ways = lines.x, lines.y, lines.cosine, lines.sine, lines.to_left, lines.to_right
        return (out[0], out[1]) if _loop()(lines.s, ways, first, second, out) else None
    close = _are_close(lines, first, second)
    found = _places(lines, first[close], second[close])
    if found is None:
        return None
    out = np.full((2, 2, 2, len(first)), math.inf)
    out[..., close] = np.reshape(found, (2, 2, 2, -1))
    enter, leave = out.reshape(2, 2, -1)
    return enter, leave


def _are_close(lines: SampledWays, first: Integers, second: Integers) -> Booleans:
    """(P,) whose lines come close to each other somewhere."""
    x, y = lines.x[::COARSE], lines.y[::COARSE]
    dx = x[None, :, second] - x[:, None, first]
    dy = y[None, :, second] - y[:, None, first]
    return np.asarray((dx * dx + dy * dy < NEAR * NEAR).any(axis=(0, 1)))


def _places(lines: SampledWays, first: Integers, second: Integers) -> tuple[Floats, Floats] | None:
    """What `narrow_places` gives of pairs that come close."""
    one, two = lines.take(first), lines.take(second)
    dx, dy = two.x[None] - one.x[:, None], two.y[None] - one.y[:, None]
    square = dx * dx + dy * dy
    opposed = one.cosine[:, None] * two.cosine[None] + one.sine[:, None] * two.sine[None] < OPPOSED
    near = opposed & (square < WIDEST * WIDEST)
    left = one.cosine[:, None] * dy - one.sine[:, None] * dx
    seen = -two.cosine[None] * dy + two.sine[None] * dx
    room = np.where(left > 0.0, one.to_left[:, None], one.to_right[:, None])
    room = room + np.where(seen > 0.0, two.to_left[None], two.to_right[None]) + PASSING_GAP
    meets = near & (square < room * room) & np.isfinite(one.s)[:, None] & np.isfinite(two.s)[None]
    if one.height is not None and two.height is not None:
        meets &= ~are_apart(one.height[:, None], two.height[None])
    if not np.count_nonzero(meets):
        return None
    there: Booleans = np.asarray(meets.any(axis=1))
    begins = there.copy()
    begins[1:] &= ~there[:-1]
    begins[2:] &= ~there[:-2]
    number = np.cumsum(begins, axis=0)
    found = []
    for place in (number == 1, number > 1):
        in_place = meets & place[:, None]
        found.append(
            [
                _ends(line, np.asarray(in_place.any(axis=axis)))
                for line, axis in ((one, 1), (two, 0))
            ]
        )
    ends = np.array(found)  # (place, of the pair, enter or leave, P)
    enter, leave = (np.concatenate(list(ends[:, :, which]), axis=1) for which in (0, 1))
    return enter, leave


def _ends(samples: SampledWays, there: Booleans) -> tuple[Floats, Floats]:
    """(P,) meters from the front to the first sample that is `there` (M, P), infinite for none, and
    until the rear has left the last."""
    half = -samples.s[0]
    enter = np.where(there, samples.s, math.inf).min(axis=0) - half
    return enter, np.where(there, samples.s, -math.inf).max(axis=0) + half + SPACING


def loop_over_ways(s: Any, ways: Any, first: Any, second: Any, out: Any) -> Any:
    """Fill `out`, (2, 2, 2 P), with what `narrow_places` gives of lines (M, I) on level ground.
    Whether there is any such place. numba compiles it; Python never runs it."""
    x, y, cosine, sine, to_left, to_right = ways
    count, samples, any_there = len(first), s.shape[0], False
    for p in range(count):
        i, j = first[p], second[p]
        for of_pair in range(2):
            for k in (p, count + p):
                out[0, of_pair, k], out[1, of_pair, k] = np.inf, -np.inf
        number, before, earlier = 0, False, False
        for m in range(samples if come_close(x, y, i, j) else 0):
            there = False
            for n in range(samples):
                dx, dy = x[n, j] - x[m, i], y[n, j] - y[m, i]
                square = dx * dx + dy * dy
                if not square < WIDEST * WIDEST:
                    continue
                if not cosine[m, i] * cosine[n, j] + sine[m, i] * sine[n, j] < OPPOSED:
                    continue
                left = cosine[m, i] * dy - sine[m, i] * dx
                seen = -cosine[n, j] * dy + sine[n, j] * dx
                room = to_left[m, i] if left > 0.0 else to_right[m, i]
                room = room + (to_left[n, j] if seen > 0.0 else to_right[n, j]) + PASSING_GAP
                if not (square < room * room and np.isfinite(s[m, i]) and np.isfinite(s[n, j])):
                    continue
                if not there and not before and not earlier:
                    number += 1
                there = any_there = True
                k = p if number == 1 else count + p
                out[0, 0, k], out[1, 0, k] = min(out[0, 0, k], s[m, i]), max(out[1, 0, k], s[m, i])
                out[0, 1, k], out[1, 1, k] = min(out[0, 1, k], s[n, j]), max(out[1, 1, k], s[n, j])
            before, earlier = there, before
        for of_pair in range(2):
            half = -s[0, i if of_pair == 0 else j]
            for k in (p, count + p):
                out[0, of_pair, k] -= half
                out[1, of_pair, k] = out[1, of_pair, k] + half + SPACING
    return any_there


def come_close(x: Any, y: Any, i: Any, j: Any) -> Any:
    """What `_are_close` gives of two lines."""
    for m in range(0, x.shape[0], COARSE):
        for n in range(0, x.shape[0], COARSE):
            dx, dy = x[n, j] - x[m, i], y[n, j] - y[m, i]
            if dx * dx + dy * dy < NEAR * NEAR:
                return True
    return False


@cache
def _loop() -> Any:
    compiled.register((), (loop_over_ways, come_close))
    said = sys.modules[__name__], sampled_ways, bend_room
    return compiled.compile_loop(loop_over_ways, *said)
