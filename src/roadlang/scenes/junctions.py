"""The junctions of a network as a scene holds them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..geometry.junctions.priority import yields
from ..geometry.networks.junction_model import Conflict, Connection, Junction, JunctionPlan, LaneEnd
from ..ir.scene_junctions import (
    SceneArm,
    SceneConflict,
    SceneConnection,
    SceneControl,
    SceneJunction,
    SceneLaneEnd,
    SceneRefusal,
)
from ..plugins.kinds import RightOfWay


def scene_junctions(
    network: str, plan: JunctionPlan, rules: Mapping[int, RightOfWay]
) -> tuple[SceneJunction, ...]:
    """Those of a plan, with the `rules` of some by their ids; roads by their names in the scene,
    `town/3`."""
    return tuple(
        _junction(network, junction, rules.get(junction.id)) for junction in plan.junctions
    )


def _junction(network: str, junction: Junction, rule: RightOfWay | None) -> SceneJunction:
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
        junction.yields if rule is None else _yields(junction, rule),
        tuple(
            SceneRefusal(
                _lane(network, refusal.source),
                _lane(network, refusal.target),
                turn=refusal.turn,
                reason=refusal.reason,
            )
            for refusal in junction.refused
        ),
        tuple(_road(network, edge) for edge in junction.inside),
        SceneControl() if rule is None else _control(network, rule),
    )


def _control(network: str, rule: RightOfWay) -> SceneControl:
    minor = tuple(_road(network, edge) for edge in rule.minor)
    return SceneControl(rule.rule, minor, rule.phases, rule.offset)


def _yields(junction: Junction, rule: RightOfWay) -> tuple[tuple[int, int], ...]:
    """Who yields under a rule: nobody where the order of arrival decides, and at signals only to
    what has green in the same phase."""
    if rule.rule == "all_way_stop":
        return ()
    found = yields(
        junction.connections, junction.conflicts, rule.minor, left_hand=junction.left_hand
    )
    if rule.rule != "signals":
        return found
    phases = [set(phase.connections) for phase in rule.phases]
    return tuple(pair for pair in found if any(phase.issuperset(pair) for phase in phases))


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
