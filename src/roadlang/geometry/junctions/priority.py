"""Who yields to whom at a junction. Written for right-hand traffic."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from itertools import combinations

from .model import Arm, Conflict, Connection, LaneEnd, Point

_OPPOSITE = math.radians(135.0)
_CLEARLY = 1.25


def yields(
    connections: Sequence[Connection],
    conflicts: Sequence[Conflict],
    minor: Collection[tuple[int, str]] = (),
) -> tuple[tuple[int, int], ...]:
    """Pairs (a, b) of connection ids: a yields to b.

    What comes from an arm in `minor` (edge, end) yields to what does not. Otherwise who turns
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


def _a_yields(a: Connection, b: Connection, minor: Collection[tuple[int, str]]) -> bool:
    low, high = _arm(a.source) in minor, _arm(b.source) in minor
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


def minor_arms(ring: Sequence[Point], arms: Sequence[Arm]) -> frozenset[tuple[int, str]]:
    """The arms that do not belong to the road that clearly goes on: the widest, straightest pair,
    if it is by a quarter more so than the best pair of the others. Empty if none is."""
    faces = [_face(ring, arm) for arm in arms]
    pairs = {
        pair: _score(faces[pair[0]], faces[pair[1]]) for pair in combinations(range(len(arms)), 2)
    }
    if not pairs:
        return frozenset()
    best = max(pairs, key=lambda pair: (round(pairs[pair], 6), -pair[0], -pair[1]))
    rest = [score for pair, score in pairs.items() if not set(pair) & set(best)]
    alike = [score for pair, score in pairs.items() if set(pair) & set(best) and pair != best]
    if pairs[best] <= 0.0 or pairs[best] < _CLEARLY * max(rest, default=0.0):
        return frozenset()
    if pairs[best] <= max(alike, default=0.0) * (1.0 + 1e-6):
        return frozenset()
    return frozenset((arm.edge, arm.end) for place, arm in enumerate(arms) if place not in best)


def _face(ring: Sequence[Point], arm: Arm) -> tuple[float, float]:
    """The width of an arm and its heading away from the junction."""
    (xl, yl), (xr, yr) = ring[arm.left], ring[arm.right]
    return math.hypot(xl - xr, yl - yr), math.atan2(xr - xl, yl - yr)


def _score(first: tuple[float, float], second: tuple[float, float]) -> float:
    deviation = _wrapped(second[1] - first[1] + math.pi)
    return min(first[0], second[0]) * math.cos(deviation)
