"""Whether the steps of a route meet, read from the scene alone."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.ir.scene_junctions import SceneConnection
from roadlang.ir.scene_route import RouteStep, SceneRoute

Pose: TypeAlias = tuple[float, float, float]


def faults_of(scene: Scene, route: SceneRoute) -> list[str]:
    """What is wrong with a route: lanes that do not exist or run the other way, steps that do not
    end where the next begins, to 1 cm and half a degree."""
    roads = {road.name: road for road in scene.roads}
    found = []
    for number, step in enumerate(route.steps):
        if not _runs(roads[step.road], step):
            found.append(f"step {number}: {step.road} has no lane {step.lane} that way")
    for number, (step, after) in enumerate(pairwise(route.steps)):
        found += [f"step {number}: {fault}" for fault in _joint(scene, roads, step, after)]
    return found


def _runs(road: SceneRoad, step: RouteStep) -> bool:
    lanes = {lane.id: lane for lane in road.lane_list}
    direction = "backward" if step.start > step.stop else "forward"
    return step.lane in lanes and lanes[step.lane].direction in (direction, "both")


def _joint(
    scene: Scene, roads: dict[str, SceneRoad], step: RouteStep, after: RouteStep
) -> list[str]:
    if step.turn is None:
        same = step.road == after.road and abs(step.stop - after.start) < 1e-6
        return [] if same else ["no turn, and the next step begins elsewhere"]
    connection = connection_of(scene, step)
    ends = (connection.source.road, connection.target.road)
    lanes = (connection.source.lane, connection.target.lane)
    if ends != (step.road, after.road) or lanes != (step.lane, after.lane):
        return [f"the connection leads from {ends[0]} to {ends[1]}"]
    gaps = [
        _gap(pose_at(roads[step.road], step, step.stop), connection.start),
        _gap(end_of(connection), pose_at(roads[after.road], after, after.start)),
    ]
    return [f"{gap:.3f} m or radians apart" for gap in gaps if gap > 0.01]


def connection_of(scene: Scene, step: RouteStep) -> SceneConnection:
    """The connection at the end of a step."""
    assert step.turn is not None
    network = next(item for item in scene.networks if item.name == step.turn.network)
    junction = next(item for item in network.junctions if item.id == step.turn.junction)
    return next(item for item in junction.connections if item.id == step.turn.connection)


def pose_at(road: SceneRoad, step: RouteStep, station: float) -> Pose:
    """The middle of the lane of a step, in its direction of travel."""
    heading = float(np.interp(station, road.stations, road.heading))
    offset = float(road.cross_section().offset(step.lane, station))
    x, y = (float(np.interp(station, road.stations, part)) for part in (road.x, road.y))
    turned = math.pi if step.start > step.stop else 0.0
    return (
        x - offset * math.sin(heading), y + offset * math.cos(heading), heading + turned
    )  # fmt: skip


def end_of(connection: SceneConnection) -> Pose:
    """Where the lines and arcs of a connection end."""
    x, y, heading = connection.start
    for length, curvature in connection.pieces:
        turn = length * curvature
        chord = length if turn == 0.0 else 2.0 * math.sin(turn / 2.0) / curvature
        x += chord * math.cos(heading + turn / 2.0)
        y += chord * math.sin(heading + turn / 2.0)
        heading += turn
    return x, y, heading


def _gap(one: Pose, other: Pose) -> float:
    away = math.hypot(one[0] - other[0], one[1] - other[1])
    return max(away, abs(math.remainder(one[2] - other[2], 2.0 * math.pi)))
