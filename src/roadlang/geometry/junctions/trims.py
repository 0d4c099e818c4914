"""How far each arm of a place is trimmed: up to where a curb of the corner's radius touches it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from ..arrays import Floats, cross, wrapped_angle
from .arms import DEFAULT_TRIM, FARTHEST_TRIM, SPACING, ArmKey, ArmLine, nearest_on
from .corners import Corner, CurbSize, corner_between

LEAST = 1.0
"""Meters: the trim of an arm that nothing touches."""
_CLEAR_FOR = 5.0
_PARALLEL_TRIM = 30.0
_FLAT = math.radians(135.0)
_ALIKE = math.cos(math.radians(20.0))
_ROUNDS = 3
"""Angles between bent arms are measured where these are trimmed, so often."""


@dataclass(frozen=True)
class Trimmed:
    """The arms of a place counter-clockwise, their trims in meters, and the corners between.

    `covered` are the arms that lie on others farther than any junction reaches.
    """

    arms: tuple[ArmLine, ...]
    trims: Mapping[ArmKey, float]
    corners: tuple[Corner, ...]
    covered: frozenset[ArmKey] = frozenset()


def trimmed(
    arms: Sequence[ArmLine],
    swallowed: Sequence[ArmLine],
    curbs: Mapping[int, CurbSize],
) -> Trimmed:
    """Trims the arms of one place.

    `swallowed` are the roads inside the place, `curbs` the sizes of the curbs beside those roads
    that do not have the default one: at a corner of two roads the smaller counts.
    """
    trims = {arm.key: min(15.0, float(arm.s[-1])) for arm in arms}
    order: tuple[ArmLine, ...] = ()
    corners: tuple[Corner, ...] = ()
    touching: dict[ArmKey, float] = {}
    for _ in range(_ROUNDS):
        following = counter_clockwise(arms, trims)
        found = _corners(following, trims, curbs)
        if order and found == corners:
            break
        order, corners = following, found
        touching = _all_trims(order, corners, swallowed)
        trims = {arm.key: arm.past_folds(_moderate(touching[arm.key])) for arm in order}
    covered = {key for key, trim in touching.items() if trim > FARTHEST_TRIM}
    covered |= {arm.key for arm, other in permutations(order, 2) if _lies_on(arm, other)}
    return Trimmed(order, trims, corners, frozenset(covered))


def counter_clockwise(
    arms: Sequence[ArmLine], trims: Mapping[ArmKey, float]
) -> tuple[ArmLine, ...]:
    """By the angle of the trimmed ends about the middle of the nodes."""
    if not arms:
        return ()
    middle = np.mean([arm.points[0] for arm in arms], axis=0)

    def angle(arm: ArmLine) -> tuple[float, ArmKey]:
        x, y = arm.points[np.searchsorted(arm.s, min(trims[arm.key], arm.s[-1]))] - middle
        return round(math.atan2(y, x), 9), arm.key

    return tuple(sorted(arms, key=angle))


def _corners(
    order: tuple[ArmLine, ...], trims: Mapping[ArmKey, float], curbs: Mapping[int, CurbSize]
) -> tuple[Corner, ...]:
    if len(order) < 2:
        return ()
    found = []
    for place, arm in enumerate(order):
        beside = (place + 1) % len(order)
        pair = (arm, order[beside])
        headings = tuple(
            float(a.heading[np.searchsorted(a.s, min(trims[a.key], a.s[-1]))]) for a in pair
        )
        size = max(curbs.get(a.edge.id, CurbSize.DEFAULT) for a in pair)
        found.append(corner_between(pair, (place, beside), (headings[0], headings[1]), size))
    return tuple(found)


def _all_trims(
    order: tuple[ArmLine, ...], corners: tuple[Corner, ...], swallowed: Sequence[ArmLine]
) -> dict[ArmKey, float]:
    trims = {arm.key: LEAST for arm in order}
    for corner in corners:
        first, second = order[corner.arm], order[corner.neighbor]
        if corner.radius is None:
            touching = _flat_trims(first, second, corner.angle)
        else:
            touching = _corner_trims(first, second, corner.radius)
        for key, trim in touching:
            trims[key] = max(trims[key], trim)
    for i, arm in enumerate(order):
        others = [
            other
            for j, other in enumerate(order)
            if j != i and (other.node != arm.node or not _are_neighbors(i, j, len(order)))
        ]
        for other in (*others, *_seen_from(arm, swallowed)):
            if _leave_apart(arm, other):
                continue
            trims[arm.key] = max(trims[arm.key], _clear_of(arm, other))
    return trims


def _moderate(trim: float) -> float:
    return trim if trim <= FARTHEST_TRIM else DEFAULT_TRIM


def _seen_from(arm: ArmLine, swallowed: Sequence[ArmLine]) -> tuple[ArmLine, ...]:
    """Each road of `swallowed`, which has both its ends, once: from the arm's node on, if there."""
    lines: dict[int, ArmLine] = {}
    for line in swallowed:
        if line.edge.id not in lines or line.node == arm.node:
            lines[line.edge.id] = line
    return tuple(lines.values())


def _are_neighbors(i: int, j: int, count: int) -> bool:
    return i == j or (i - j) % count in (1, count - 1)


def _leave_apart(arm: ArmLine, other: ArmLine) -> bool:
    """Whether two arms of one node leave it in nearly opposite directions."""
    if arm.node != other.node:
        return False
    gap = abs(wrapped_angle(arm.heading[0] - other.heading[0]))
    return bool(gap >= _FLAT)


def _flat_trims(
    first: ArmLine, second: ArmLine, angle: float
) -> tuple[tuple[ArmKey, float], tuple[ArmKey, float]]:
    """The trims of two arms that leave in nearly opposite directions: where the farther of the
    borders between them meets its mirror image."""
    half = max(float(first.left[0]), float(second.right[0]))
    trim = half * math.tan(max(math.pi - angle, 0.0) / 2.0)
    return (first.key, trim), (second.key, trim)


def _corner_trims(
    first: ArmLine, second: ArmLine, radius: float
) -> tuple[tuple[ArmKey, float], tuple[ArmKey, float]]:
    """The trims of two arms at their corner; where they run side by side, the curb is made tighter
    until both trims are moderate. If none is tight enough, arms of one node keep the curb."""
    found = []
    for attempt in (radius, radius / 3.0, 0.25, 0.0):
        a = _touching(first, second, attempt, left=True)
        b = _touching(second, first, attempt, left=False)
        found.append(((first.key, a), (second.key, b)))
        if max(a, b) <= _PARALLEL_TRIM:
            return found[-1]
    return found[-1] if first.node != second.node else found[0]


def _touching(arm: ArmLine, other: ArmLine, radius: float, *, left: bool) -> float:
    """The distance from which on a circle of the radius that touches the arm's side is clear of
    the facing side of the other arm."""
    side = arm.left if left else -arm.right
    away = side + (radius if left else -radius)
    centers = arm.points + arm.normal * away[:, None]
    gap, side_of = _gap(centers, other, other.right if left else other.left)
    # A circle on the far side of the other arm has not left it yet.
    beyond = side_of > 0.0 if left else side_of < 0.0
    return _first_clear(arm, other, np.where(beyond, -1.0, gap) - radius, gap - radius)


def _clear_of(arm: ArmLine, other: ArmLine) -> float:
    """The distance from which on the arm, across its whole width, does not touch another road."""
    gaps = []
    for across in (arm.left, 0.0 * arm.left, -arm.right):
        points = arm.points + arm.normal * across[:, None]
        gaps.append(_gap(points, other, np.maximum(other.left, other.right))[0])
    gap = np.min(gaps, axis=0)
    return _first_clear(arm, other, gap, gap)


def _lies_on(arm: ArmLine, other: ArmLine) -> bool:
    """Whether an arm is on one of another node from near its own node to its other end."""
    turned = math.cos(float(arm.heading[-1] - other.heading[-1]))
    if arm.node == other.node or arm.length > arm.s[-1] or turned < _ALIKE:
        return False
    gap = _gap(arm.points, other, other.left + 0.0)[0] - np.minimum(arm.left, arm.right)
    away = arm.s > _PARALLEL_TRIM
    return bool(away.any() and (gap[away] < 0.0).all())


def _first_clear(arm: ArmLine, other: ArmLine, strict: Floats, gap: Floats) -> float:
    """The least trim that keeps two arms apart.

    Arms of different nodes, which may lean toward each other and cross where no node is, must be
    clear as far as trims go; if they are not, and for all others, for a few meters. The two ends of
    one road come together anyway.
    """
    within_limit = arm.s <= FARTHEST_TRIM
    if arm.node != other.node and arm.edge is not other.edge:
        bad = np.flatnonzero((gap < 0.0) & within_limit)
        if len(bad) and bad[-1] + 1 < within_limit.sum():
            return _between(arm.s, gap, int(bad[-1]) + 1)
    trim = _clear_from(arm.s, strict)
    return trim if trim < arm.s[-1] else _clear_from(arm.s, gap)


def _gap(points: Floats, other: ArmLine, half: Floats) -> tuple[Floats, Floats]:
    """(n,) meters between points and the side of a road, negative on the road, and on which side
    of its middle they are, left positive."""
    step = 2 if len(other.s) > 8 else 1
    places = np.unique(np.append(np.arange(0, len(other.s), step), len(other.s) - 1))
    line = other.points[places]
    distance, place = nearest_on(points, line)
    first = np.minimum(place.astype(int), len(line) - 2)
    side = cross(line[first + 1] - line[first], points - line[first])
    return np.asarray(distance - np.interp(place, np.arange(len(places)), half[places])), side


def _clear_from(s: Floats, gap: Floats) -> float:
    """The first station from which on `gap` is not negative for `_CLEAR_FOR` meters."""
    bad = np.flatnonzero(gap < 0.0)
    at = 0
    run = math.ceil(_CLEAR_FOR / SPACING)
    for place in bad.tolist():
        if place > at + run:
            break
        at = place + 1
    if at == 0:
        return 0.0
    return _between(s, gap, at) if at < len(s) else float(s[-1])


def _between(s: Floats, gap: Floats, at: int) -> float:
    """Where a gap crosses zero between the sample before and that at an index."""
    below, above = gap[at - 1], gap[at]
    return float(s[at - 1] + (s[at] - s[at - 1]) * below / (below - above))
