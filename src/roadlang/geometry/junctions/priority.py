"""Who yields to whom at a junction. Written for right-hand traffic."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from itertools import combinations

from .model import Arm, Conflict, Connection, Junction, LaneEnd, Point

_OPPOSITE = math.radians(135.0)
_CLEARLY = 1.25


def yields(
    connections: Sequence[Connection],
    conflicts: Sequence[Conflict],
    minor: Collection[int] = (),
) -> tuple[tuple[int, int], ...]:
    """Pairs (a, b) of connection ids: a yields to b.

    What comes from a road in `minor` yields to what does not. Otherwise who turns
    further left yields to oncoming traffic, and everyone to what comes from the right.
    """
    by_id = {connection.id: connection for connection in connections}
    found = []
    for conflict in conflicts:
        a, b = by_id[conflict.a], by_id[conflict.b]
        if conflict.kind == "diverge" or _arm(a.source) == _arm(b.source):
            continue
        if _a_yields(a, b, minor):
            found.append((a.id, b.id))
        elif _a_yields(b, a, minor):
            found.append((b.id, a.id))
    return tuple(sorted(found))


def _a_yields(a: Connection, b: Connection, minor: Collection[int]) -> bool:
    low, high = a.source.edge in minor, b.source.edge in minor
    if low != high:
        return low
    gap = _wrapped(b.start[2] - a.start[2])
    if abs(gap) > _OPPOSITE:
        return _turning(a) > _turning(b) + 1e-6
    return gap > 0.0


def _turning(connection: Connection) -> float:
    """Change of heading, left positive."""
    return sum(length * curvature for length, curvature in connection.pieces)


def _arm(lane: LaneEnd) -> tuple[int, str]:
    return lane.edge, lane.end


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def minor_roads(junction: Junction, *, clearly: bool = True) -> tuple[int, ...]:
    """The roads beside the one that goes on: the widest, straightest pair of arms.

    `clearly`: empty unless that pair is by a quarter more so than the best pair of the others. Of
    equal pairs the first counts.
    """
    arms = junction.arms
    faces = [_face(junction.area, arm) for arm in arms]
    pairs = combinations(range(len(arms)), 2)
    scores = {(i, j): _score(faces[i], faces[j]) for i, j in pairs}
    if not scores:
        return ()
    best = max(scores, key=lambda pair: (round(scores[pair], 6), -pair[0], -pair[1]))
    rest = [score for pair, score in scores.items() if not set(pair) & set(best)]
    rivals = [score for pair, score in scores.items() if set(pair) & set(best) and pair != best]
    rivaled = scores[best] <= max(rivals, default=0.0) * (1.0 + 1e-6)
    if clearly and (rivaled or scores[best] < _CLEARLY * max(rest, default=0.0)):
        return ()
    major = {arms[place].edge for place in best}
    return tuple(sorted({arm.edge for arm in arms} - major))


def _face(ring: Sequence[Point], arm: Arm) -> tuple[float, float]:
    """The width of an arm and its heading away from the junction."""
    (xl, yl), (xr, yr) = ring[arm.left], ring[arm.right]
    return math.hypot(xl - xr, yl - yr), math.atan2(xr - xl, yl - yr)


def _score(first: tuple[float, float], second: tuple[float, float]) -> float:
    deviation = _wrapped(second[1] - first[1] + math.pi)
    return min(first[0], second[0]) * math.cos(deviation)
