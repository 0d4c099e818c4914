"""When rectangles that keep their velocities meet: time to collision, and encroachment."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats
from .footprints import Footprints, close_pairs, separation

_AT_ONCE = 256
"""Rectangles of one agent that are compared with all of another: some thousand pairs each."""


def time_to_contact(a: Footprints, b: Footprints, velocity: Floats) -> Floats:
    """Seconds until two rectangles touch; 0 where they do, infinite where they never will.

    `velocity` (..., 2): that of `b` minus that of `a`, m/s; both keep it, and their headings. Two
    rectangles overlap while their shadows on the directions of all four sides do, each of which is
    an interval of time (the swept form of the separating axis test, Gottschalk et al. 1996).
    """
    shape = np.broadcast_shapes(a.x.shape, b.x.shape)
    first, last = np.full(shape, -np.inf), np.full(shape, np.inf)
    cosine = np.abs(a.cosine * b.cosine + a.sine * b.sine)
    sine = np.abs(a.sine * b.cosine - a.cosine * b.sine)
    for ego, other in ((a, b), (b, a)):
        along = 0.5 * (ego.length + other.length * cosine + other.width * sine)
        across = 0.5 * (ego.width + other.length * sine + other.width * cosine)
        for x, y, half in ((ego.cosine, ego.sine, along), (-ego.sine, ego.cosine, across)):
            place = (b.x - a.x) * x + (b.y - a.y) * y
            speed = velocity[..., 0] * x + velocity[..., 1] * y
            begin, end = _overlap(place, speed, half)
            first, last = np.maximum(first, begin), np.minimum(last, end)
    meets = (first <= last) & (last >= 0.0)
    return np.where(meets, np.maximum(first, 0.0), np.inf)


def _overlap(place: Floats, speed: Floats, half: Floats) -> tuple[Floats, Floats]:
    """The interval of time in which |place + speed t| <= half; of no such time, it is reversed."""
    moving = speed != 0.0
    divisor = np.where(moving, speed, 1.0)
    with np.errstate(over="ignore"):  # what hardly moves needs longer than there are numbers for
        entry, leaving = (-half - place) / divisor, (half - place) / divisor
    inside = np.abs(place) <= half
    begin = np.where(moving, np.minimum(entry, leaving), np.where(inside, -np.inf, np.inf))
    end = np.where(moving, np.maximum(entry, leaving), np.where(inside, np.inf, -np.inf))
    return begin, end


def encroachment_times(a: Footprints, b: Footprints, time: Floats) -> Floats:
    """(T,) seconds between the times at which two rectangles that move were in one place, the
    least so far; infinite before that, and 0 from when they touch.

    The post-encroachment time (Allen, Shin, Cooper 1978) of a pair is the last value. The
    rectangles (T,) are taken where they are at `time` (T,), increasing: a step must be shorter
    than a rectangle is long.
    """
    found = np.full(len(time), np.inf)
    for start in range(0, len(time), _AT_ONCE):
        part = np.arange(start, min(start + _AT_ONCE, len(time)))
        near, j = close_pairs(a.take(part), b)
        i = part[near]
        overlap = separation(a.take(i), b.take(j)) <= 0.0
        i, j = i[overlap], j[overlap]
        np.minimum.at(found, np.maximum(i, j), np.abs(time[i] - time[j]))
    return np.asarray(np.minimum.accumulate(found))
