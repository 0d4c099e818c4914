"""When rectangles that move touch each other first."""

from __future__ import annotations

import math

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from .outlines import Outlines


def first_contact(a: Outlines, b: Outlines, shift: tuple[Floats, Floats]) -> Floats:
    """(N,) when rectangles meet on the last part of their way, as a share of it: 0 at its start, 1
    at its end, where they are at `a` and `b`; infinite for never.

    `shift`: how far `a` has moved relative to `b`. The way is straight, the headings are those at
    the end (separating axes, each with the interval of time in which it does not separate).
    """
    off_x, off_y = a.x - b.x - shift[0], a.y - b.y - shift[1]
    enter = np.zeros(len(off_x))
    leave = np.full(len(off_x), math.inf)
    cosine = np.abs(a.cosine * b.cosine + a.sine * b.sine)
    sine = np.abs(a.sine * b.cosine - a.cosine * b.sine)
    for box, other in ((a, b), (b, a)):
        for axis_x, axis_y, half, shadow in (
            (
                box.cosine, box.sine, box.half_length,
                other.half_length * cosine + other.half_width * sine,
            ),
            (
                -box.sine, box.cosine, box.half_width,
                other.half_length * sine + other.half_width * cosine,
            ),
        ):  # fmt: skip
            first, last = _overlap(
                off_x * axis_x + off_y * axis_y,
                shift[0] * axis_x + shift[1] * axis_y,
                half + shadow,
            )
            enter, leave = np.maximum(enter, first), np.minimum(leave, last)
    return np.where(enter <= leave, enter, math.inf)


def overlapping(a: Outlines, first: Integers, b: Outlines, second: Integers) -> Booleans:
    """(N,) which pairs of rectangles overlap."""
    out = np.zeros(len(first), dtype=bool)
    away = np.hypot(a.x[first] - b.x[second], a.y[first] - b.y[second])
    radius = [np.hypot(each.half_length, each.half_width) for each in (a, b)]
    near = np.flatnonzero(away < radius[0][first] + radius[1][second])
    still = (np.zeros(len(near)), np.zeros(len(near)))
    out[near] = first_contact(a.take(first[near]), b.take(second[near]), still) == 0.0
    return out


def _overlap(start: Floats, change: Floats, distance: Floats) -> tuple[Floats, Floats]:
    """When `|start + change t| <= reach`, from and to."""
    with np.errstate(divide="ignore", invalid="ignore"):
        entry, leaving = (-distance - start) / change, (distance - start) / change
    inside = np.abs(start) <= distance
    at_rest = change == 0.0
    first = np.where(at_rest, np.where(inside, -math.inf, math.inf), np.minimum(entry, leaving))
    last = np.where(at_rest, np.where(inside, math.inf, -math.inf), np.maximum(entry, leaving))
    return first, last
