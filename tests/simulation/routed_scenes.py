"""Scenes of networks whose agents have routes, made without a scene file for each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from roadlang import testing
from roadlang.drive.controllers import python_controllers
from roadlang.drive.simulators import simulator_of
from roadlang.ir.scene import Call, Scene, SceneActor, SceneRoad
from roadlang.ir.scene_junctions import SceneConnection, SceneJunction
from roadlang.ir.scene_route import RouteStep, RouteTurn, SceneRoute
from roadlang.ir.trace import Trace
from roadlang.plugins.discovery import load_registry

ARM = 15
CROSSING = "\n".join(
    ["." * ARM + "#" + "." * ARM] * ARM
    + ["#" * (2 * ARM + 1)]
    + ["." * ARM + "#" + "." * ARM] * ARM
)
"""Four roads of 15 cells each, north, west, east and south of a junction."""
CONTROL_STEP = 0.1
"""Seconds for which a decision holds in tests: with the default of the engine most of them show the
same and take twice as long."""
TEE = "\n".join(["#" * (2 * ARM + 1)] + ["." * ARM + "#" + "." * ARM] * ARM)


def network_scene(
    plan: str, options: str = "", *, cell: str = "8m/px", network: str = "", world: str = "",
    seed: int = 0,
) -> Scene:  # fmt: skip
    """A network from a plan in text, with nobody in it. `options`: of the network `town`."""
    text = f"""
    image plan from \"\"\"
{plan}
\"\"\" {{ scale: {cell} }}
    network town from plan {{ {options} }}
    {network}
    road away {{ draw with segments {{ pieces: [straight(50m)] }} }}
    agent nobody is car on away at 1m {{ drive with car_follow }}
    world {{ {world} }}
    """
    scene = testing.sample(text, 1, seed=seed)[0].record
    return replace(scene, agents=(), roads=tuple(r for r in scene.roads if r.name != "away"))


def route(
    scene: Scene, road: str, lane: int, start: float, turns: Sequence[str], *, network: int = -1
) -> SceneRoute:
    """From a place on a lane on, with these turns (`left`, `straight`, `right`) at junctions."""
    net = scene.networks[network]
    roads = {one.name: one for one in scene.roads}
    steps: list[RouteStep] = []
    left = list(turns)
    while True:
        goes_on = roads[road]
        forward = lane_runs_forward(goes_on, lane)
        end = "end" if forward else "start"
        stop = goes_on.length - goes_on.trim[1] if forward else goes_on.trim[0]
        found = outgoing(net.junctions, road, end, lane)
        wanted = [pair for pair in found if left and pair[1].turn == left[0]]
        joints = [pair for pair in found if pair[0].kind == "joint"]
        if not (wanted or joints):
            steps.append(RouteStep(road, lane, start, stop))
            return SceneRoute(tuple(steps))
        junction, connection = (joints or wanted)[0]
        if not joints:
            left.pop(0)
        turn = RouteTurn(net.name, junction.id, connection.id)
        steps.append(RouteStep(road, lane, start, stop, turn))
        road, lane = connection.target.road, connection.target.lane
        after = roads[road]
        is_start = connection.target.end == "start"
        start = after.trim[0] if is_start else after.length - after.trim[1]


def outgoing(
    junctions: Sequence[SceneJunction], road: str, end: str, lane: int
) -> list[tuple[SceneJunction, SceneConnection]]:
    """The connections that leave a lane."""
    return [
        (junction, one)
        for junction in junctions
        for one in junction.connections
        if (one.source.road, one.source.end, one.source.lane) == (road, end, lane)
    ]


def lane_runs_forward(road: SceneRoad, lane: int) -> bool:
    """Along the road; of a lane for both directions, to the end."""
    direction = next(one.direction for one in road.lane_list if one.id == lane)
    return direction in ("forward", "both")


def car(
    scene: Scene, name: str, path: SceneRoute, *, speed: float = 0.0, drive: Any = None,
    length: float = 4.5, width: float = 1.8,
) -> SceneActor:  # fmt: skip
    """A car at the begin of a route. `drive`: one call or a tuple of calls of controllers."""
    step = path.steps[0]
    road = next(one for one in scene.roads if one.name == step.road)
    x, y, heading, offset = lane_pose(road, step.lane, step.start)
    backward = step.stop < step.start
    calls = drive if isinstance(drive, tuple) else (drive or call("lane_follow"),)
    options = {"wheelbase": 0.6 * length, "mass": 1500.0, "max_steering": 0.61}
    return SceneActor(
        name, name, "car", x, y, heading + (math.pi if backward else 0.0), length, width, 1.5,
        road.name, step.start, offset, step.lane, "back" if backward else "forward", options,
        calls, speed, path,
    )  # fmt: skip


def lane_pose(road: SceneRoad, lane: int, station: float) -> tuple[float, float, float, float]:
    """x, y, heading of the road, and offset of the middle of a lane."""
    offset = float(road.cross_section().offset(lane, station))
    x, y, heading = (
        float(np.interp(station, road.stations, column))
        for column in (road.x, road.y, road.heading)
    )
    return x - math.sin(heading) * offset, y + math.cos(heading) * offset, heading, offset


def call(kind: str, **options: Any) -> Call:
    """A controller with all its options."""
    known = {one.name: one.default for one in load_registry().find("drive", kind).options}
    return Call(kind, {**known, **options})


def drive_scenes(scenes: Sequence[Scene], **settings: Any) -> list[Trace]:
    """The traces of scenes in the embedded engine, by default with few decisions a second."""
    registry = load_registry()
    settings = {"control_step": CONTROL_STEP, **settings}
    _, simulator = simulator_of(scenes[0], registry, "builtin", settings)
    return list(simulator.drive_all(scenes, [python_controllers(s, registry) for s in scenes]))
