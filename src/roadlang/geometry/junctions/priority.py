"""Who yields to whom at a junction."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from itertools import combinations

from ..arrays import wrapped_angle
from ..networks.junction_model import Arm, Conflict, Connection, Junction, LaneEnd
from .axes import OPPOSITE, axis_order, heading_of

_CLEARLY = 1.25


def yields(
    connections: Sequence[Connection],
    conflicts: Sequence[Conflict],
    minor: Collection[int] = (),
    *,
    left_hand: bool = False,
) -> tuple[tuple[int, int], ...]:
    """Pairs (a, b) of connection ids: a yields to b.

    What comes from a road in `minor` yields to what does not. Otherwise who turns
    further left yields to oncoming traffic, and everyone to what comes from the right; in
    left-hand traffic further right, and from the left.
    """
    side = -1.0 if left_hand else 1.0
    by_id = {connection.id: connection for connection in connections}
    found = []
    for conflict in conflicts:
        a, b = by_id[conflict.a], by_id[conflict.b]
        if conflict.kind == "diverge" or _arm(a.source) == _arm(b.source):
            continue
        if _a_yields(a, b, minor, side):
            found.append((a.id, b.id))
        elif _a_yields(b, a, minor, side):
            found.append((b.id, a.id))
    return tuple(sorted(found))


def _a_yields(a: Connection, b: Connection, minor: Collection[int], side: float) -> bool:
    low, high = a.source.edge in minor, b.source.edge in minor
    if low != high:
        return low
    gap = side * wrapped_angle(b.start[2] - a.start[2])
    if abs(gap) > OPPOSITE:
        return side * _turning(a) > side * _turning(b) + 1e-6
    return gap > 0.0


def _turning(connection: Connection) -> float:
    """Change of heading, left positive."""
    return sum(length * curvature for length, curvature in connection.pieces)


def _arm(lane: LaneEnd) -> tuple[int, str]:
    return lane.edge, lane.end


def minor_roads(junction: Junction, *, clearly: bool = True) -> tuple[int, ...]:
    """The roads beside the one that goes on: the widest, straightest pair of arms.

    `clearly`: empty unless that pair is by a quarter more so than the best pair of the others. Of
    equal pairs the one that runs east and west counts, so that those of a mirrored drawing with
    traffic on the other side are the mirrored roads.
    """
    arms = junction.arms
    faces = [_face(junction, arm) for arm in arms]
    pairs = combinations(range(len(arms)), 2)
    scores = {(i, j): _score(faces[i], faces[j]) for i, j in pairs}
    if not scores:
        return ()
    axes = {
        (i, j): axis_order((faces[i][1], faces[j][1]), left_hand=junction.left_hand)
        for i, j in scores
    }
    edges = {(i, j): sorted((arms[i].edge, arms[j].edge)) for i, j in scores}
    best = min(scores, key=lambda pair: (-round(scores[pair], 6), axes[pair], edges[pair]))
    rest = [score for pair, score in scores.items() if not set(pair) & set(best)]
    rivals = [score for pair, score in scores.items() if set(pair) & set(best) and pair != best]
    rivaled = scores[best] <= max(rivals, default=0.0) * (1.0 + 1e-6)
    if clearly and (rivaled or scores[best] < _CLEARLY * max(rest, default=0.0)):
        return ()
    major = {arms[place].edge for place in best}
    return tuple(sorted({arm.edge for arm in arms} - major))


def _face(junction: Junction, arm: Arm) -> tuple[float, float]:
    """The width of an arm and its heading away from the junction."""
    width = math.dist(junction.area[arm.left], junction.area[arm.right])
    return width, heading_of(junction, arm)


def _score(first: tuple[float, float], second: tuple[float, float]) -> float:
    deviation = wrapped_angle(second[1] - first[1] + math.pi)
    return min(first[0], second[0]) * math.cos(deviation)
