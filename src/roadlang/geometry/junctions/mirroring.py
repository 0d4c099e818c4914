"""Plans for left-hand traffic: made for the mirror image, and mirrored back."""

from __future__ import annotations

from dataclasses import replace

from ..networks.junction_model import (
    Arm,
    Connection,
    Junction,
    JunctionPlan,
    LaneEnd,
    Point,
    Refusal,
    Turn,
)

_TURNS: dict[Turn, Turn] = {"left": "right", "right": "left", "straight": "straight", "u": "u"}


def mirrored(plan: JunctionPlan) -> JunctionPlan:
    """The plan of the network mirrored at the x axis, with left and right exchanged."""
    return replace(plan, junctions=tuple(_junction(junction) for junction in plan.junctions))


def _junction(junction: Junction) -> Junction:
    count = len(junction.area)
    return replace(
        junction,
        area=tuple((x, -y) for x, y in reversed(junction.area)),
        arms=tuple(_arm(arm, count) for arm in reversed(junction.arms)),
        connections=tuple(_connection(connection) for connection in junction.connections),
        refused=tuple(_refusal(refusal) for refusal in junction.refused),
        left_hand=not junction.left_hand,
    )


def _arm(arm: Arm, count: int) -> Arm:
    return replace(arm, left=count - 1 - arm.right, right=count - 1 - arm.left)


def _connection(connection: Connection) -> Connection:
    x, y, heading = connection.start
    left, right = connection.stop_line
    return replace(
        connection,
        source=_lane(connection.source),
        target=_lane(connection.target),
        turn=_TURNS[connection.turn],
        start=(x, -y, -heading),
        pieces=tuple((length, -curvature) for length, curvature in connection.pieces),
        stop_line=(_point(right), _point(left)),
    )


def _refusal(refusal: Refusal) -> Refusal:
    return replace(
        refusal,
        source=_lane(refusal.source),
        target=_lane(refusal.target),
        turn=_TURNS[refusal.turn],
        angle=-refusal.angle,
    )


def _lane(lane: LaneEnd) -> LaneEnd:
    return replace(lane, lane=-lane.lane)


def _point(point: Point) -> Point:
    return point[0], -point[1]
