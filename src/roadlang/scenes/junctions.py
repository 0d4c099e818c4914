"""The junctions of a network as a scene holds them."""

from __future__ import annotations

from collections.abc import Sequence

from ..geometry.junctions.model import Conflict, Connection, Junction, JunctionPlan, LaneEnd
from ..ir.scene_junctions import (
    SceneArm,
    SceneConflict,
    SceneConnection,
    SceneJunction,
    SceneLaneEnd,
    SceneRefusal,
)


def scene_junctions(network: str, plan: JunctionPlan) -> tuple[SceneJunction, ...]:
    """Those of a plan; roads by their names in the scene, `town/3`."""
    return tuple(_junction(network, junction) for junction in plan.junctions)


def _junction(network: str, junction: Junction) -> SceneJunction:
    arms = (
        SceneArm(_road(network, arm.edge), arm.end, arm.trim, arm.left, arm.right)
        for arm in junction.arms
    )
    return SceneJunction(
        junction.id,
        junction.nodes,
        junction.kind,
        junction.area,
        tuple(arms),
        tuple(_connection(network, connection) for connection in junction.connections),
        _conflicts(junction.conflicts),
        junction.yields,
        tuple(
            SceneRefusal(
                _lane(network, refusal.source),
                _lane(network, refusal.target),
                refusal.turn,
                refusal.reason,
            )
            for refusal in junction.refused
        ),
        tuple(_road(network, edge) for edge in junction.inside),
    )


def _connection(network: str, connection: Connection) -> SceneConnection:
    return SceneConnection(
        connection.id,
        _lane(network, connection.source),
        _lane(network, connection.target),
        connection.turn,
        connection.start,
        connection.pieces,
        connection.length,
        connection.widths,
        connection.stop_line,
    )


def _conflicts(conflicts: Sequence[Conflict]) -> tuple[SceneConflict, ...]:
    return tuple(
        SceneConflict(item.a, item.b, item.kind, item.interval_a, item.interval_b)
        for item in conflicts
    )


def _lane(network: str, lane: LaneEnd) -> SceneLaneEnd:
    return SceneLaneEnd(_road(network, lane.edge), lane.end, lane.lane)


def _road(network: str, edge: int) -> str:
    return f"{network}/{edge}"
