"""Curves through a few points typed by hand, whose distances may differ a lot."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Booleans, Floats, norm, wrapped
from .curve import Curve, distinct_points

LARGEST_RATIO = 2.0
"""A leg that is longer than a neighbor by more than this is held to its straight line."""

_RATIO_BESIDE_WINDING = 0.75
_RATIO_AT_ENDS = 1.2
_FIRST_STEP = 0.35
_STRAIGHT = np.radians(0.5)


def through_waypoints(points: ArrayLike, closed: bool = False) -> Curve:
    """The C2 cubic spline through `points` (n, 2), meters, that stays near its long legs.

    A cubic spline swings far out on a leg beside a much shorter one, since the slope at their
    common point, which the short leg decides, counts by the length of the long one. So legs more
    than `LARGEST_RATIO` times as long as a neighbor, and legs of a straight run, get more points
    on their straight lines: the first a third as far from the common point as the neighbor is
    long, the next at twice that distance, and so on. Where all legs are of similar length, and
    turn from one to the next, this is `Curve.through`. Raises GeometryError as that does.
    """
    corners = distinct_points(points, closed)
    return Curve.through(_with_graded_legs(corners, closed), closed)


def _with_graded_legs(corners: Floats, closed: bool) -> Floats:
    """`corners` and, on the straight lines of long legs, the points that grade them."""
    ring = np.concatenate([corners, corners[:1]]) if closed else corners
    legs = np.diff(ring, axis=0)
    lengths = norm(legs)
    before, after = np.roll(lengths, 1), np.roll(lengths, -1)
    angles = np.arctan2(legs[:, 1], legs[:, 0])
    turns = wrapped(np.roll(angles, -1) - angles)
    if not closed:  # the first and the last leg have no neighbor there
        before[0] = after[-1] = np.inf
        turns[-1] = np.nan
    winding = _is_winding(np.roll(turns, 1), turns)
    parts = []
    for index, leg in enumerate(legs):
        last = (index + 1) % len(legs)
        ratios = (
            _ratio(turns[index], winding[index], winding[index - 1]),
            _ratio(turns[index - 1], winding[index], winding[last]),
        )
        neighbors = float(before[index]), float(after[index])
        shares = _graded(float(lengths[index]), neighbors, ratios) / lengths[index]
        parts.append(ring[index] + np.concatenate([[0.0], shares])[:, None] * leg)
    parts.append(ring[-1:])
    graded = np.concatenate(parts)
    return graded[:-1] if closed else graded


def _is_winding(at_start: Floats, at_end: Floats) -> Booleans:
    """Whether a leg turns one way at its start and the other way at its end."""
    return np.asarray(at_start * at_end < -_STRAIGHT * _STRAIGHT)


def _ratio(other_turn: float, is_winding: bool, neighbor_is_winding: bool) -> float:
    """How much longer than its neighbor at one end a leg may be; `other_turn`: at its other end,
    NaN at the end of an open curve."""
    if is_winding:
        return LARGEST_RATIO
    if neighbor_is_winding or abs(other_turn) <= _STRAIGHT:
        return _RATIO_BESIDE_WINDING
    return _RATIO_AT_ENDS if np.isnan(other_turn) else LARGEST_RATIO


def _graded(length: float, neighbors: tuple[float, float], ratios: tuple[float, float]) -> Floats:
    """Distances from the start of a leg at which it gets points.

    `neighbors`: lengths of the leg before and the leg after; `ratios`: how much longer than each
    the leg may be without more points.
    """
    before, after = neighbors
    from_start = _doubled(length, before) if length > ratios[0] * before else np.empty(0)
    from_end = length - _doubled(length, after)[::-1] if length > ratios[1] * after else np.empty(0)
    if len(from_start) and len(from_end):
        middle = length * before / (before + after)
        from_start = from_start[from_start <= middle]
        from_end = from_end[from_end > middle]
    return np.concatenate([from_start, from_end])


def _doubled(length: float, neighbor: float) -> Floats:
    """Distances f, 2 f, 4 f, ... times `neighbor`, as far as half their own is left beyond."""
    first = _FIRST_STEP * neighbor
    count = int(np.floor(np.log2(length / (1.5 * first)))) + 1
    return first * np.exp2(np.arange(max(count, 0)))
