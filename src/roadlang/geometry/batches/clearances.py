"""How far a road is from itself, where it comes back, and from other roads."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Booleans, Floats, Integers, norm
from .batch import CurveBatch
from .crossing import crossings, self_crossings
from .nearest_points import AlongOneLine, AlongTwoLines, WayAlong, nearest_points

RETURNING = 2.0
"""A road comes back to itself where the way along it is more than this many times the straight
way: never on a straight, a bend or a circle, but across a hairpin and at every crossing."""

PARTING = 4.0
"""The same for two roads that meet at a junction: those at more than 29 degrees may part."""

_TOUCH = 1e-6


def clearance(batch: CurveBatch, others: Sequence[CurveBatch] = ()) -> Floats:
    """(V, S) meters from each station to the nearest other part of the road, and other roads.

    Infinite where nothing counts: neighbors along the road do not (see `RETURNING`), nor does the
    surrounding of a junction that two roads share (`PARTING`). Zero at the stations beside a
    crossing. Between stations it is exact to second order in their gap.
    """
    result = np.stack([_to_itself(batch, variant) for variant in range(batch.variants)])
    _close(result, *self_crossings(batch), batch.closed)
    for other in others:
        beside = [_to_other(batch, other, variant) for variant in range(len(result))]
        np.minimum(result, np.stack(beside), out=result)
        variant, step, other_step = crossings(batch, other)
        real = ~_at_shared_end(batch, other, step, other_step)
        _close(result, variant[real], step[real], step[real], batch.closed)
    return result


def _to_itself(batch: CurveBatch, variant: int) -> Floats:
    points, steps = batch.points[variant], batch.steps[variant]
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    along = AlongOneLine(arc[: len(points)], float(arc[-1]) if batch.closed else None)
    return _nearest(points, points, along, RETURNING, batch.closed)


def _to_other(batch: CurveBatch, other: CurveBatch, variant: int) -> Floats:
    """Distance to another road; along both and through the junctions that they share."""
    row = variant % other.variants
    travels = [] if batch.closed or other.closed else _travels(batch, other, variant, row)
    points, theirs = batch.points[variant], other.points[row]
    return _nearest(points, theirs, AlongTwoLines(travels), PARTING, other.closed)


def _travels(
    batch: CurveBatch, other: CurveBatch, variant: int, row: int
) -> list[tuple[Floats, Floats]]:
    """Meters from all stations of both roads to each end that they share."""
    points, theirs = batch.points[variant], other.points[row]
    mine = np.concatenate([[0.0], np.cumsum(batch.steps[variant])])
    arc = np.concatenate([[0.0], np.cumsum(other.steps[row])])
    return [
        (travel, beyond)
        for end, travel in ((0, mine), (-1, mine[-1] - mine))
        for tip, beyond in ((0, arc), (-1, arc[-1] - arc))
        if norm(points[end] - theirs[tip]) <= _TOUCH
    ]


def _nearest(points: Floats, line: Floats, along: WayAlong, ratio: float, closed: bool) -> Floats:
    """(S,) distance from points to the polyline (T, 2), where the way along is more than `ratio`
    times it."""
    middle = line.mean(axis=0)
    p, q = points - middle, line - middle
    index, counted = nearest_points(p, q, along, ratio)
    count = len(line)
    distance = np.full(len(p), np.inf)
    for neighbor in (index - 1, index + 1):
        neighbor = neighbor % count if closed else np.clip(neighbor, 0, count - 1)
        distance = np.minimum(distance, _to_segment(p, q[index], q[neighbor]))
    return np.where(counted, distance, np.inf)


def _to_segment(p: Floats, a: Floats, b: Floats) -> Floats:
    chord = b - a
    size = np.maximum((chord * chord).sum(axis=-1), np.finfo(float).tiny)
    share = np.clip(((p - a) * chord).sum(axis=-1) / size, 0.0, 1.0)
    return norm(p - a - share[:, None] * chord)


def _close(
    result: Floats, variant: Integers, first: Integers, second: Integers, closed: bool
) -> None:
    """Zero at both ends of crossing steps."""
    count = result.shape[1]
    for step in (first, second):
        result[variant, step] = 0.0
        result[variant, (step + 1) % count if closed else step + 1] = 0.0


def _at_shared_end(
    batch: CurveBatch, other: CurveBatch, step: Integers, other_step: Integers
) -> Booleans:
    """Which crossings are the junction itself: both steps at an end of their road."""
    if batch.closed or other.closed:
        return np.zeros(len(step), dtype=bool)
    mine = (step == 0) | (step == len(batch.stations) - 2)
    theirs = (other_step == 0) | (other_step == len(other.stations) - 2)
    return np.asarray(mine & theirs)
