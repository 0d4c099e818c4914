"""What is sent of an agent: where it starts, what it is, what drives it in the engine."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from roadlang.api import body_of, lane_guide, vehicle_parameters
from roadlang_standard.engine_tables import BODIES

from .conditions import engine_condition
from .drives import default_speed, is_walker, option_values
from .frame import SceneOrigin
from .line import RoadSamples, line_of_route
from .names import plain_name

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor


MOST_OFFSETS = 200
"""Pairs of an arc length and an offset that are sent for an agent, which fits into a datagram."""


@dataclass(frozen=True, slots=True)
class AgentPose:
    """Where an agent is: meters east and north, radians, meters per second."""

    x: float
    y: float
    heading: float
    speed: float


def followed_lines(scene: Scene, lines: Mapping[str, RoadSamples]) -> dict[str, RoadSamples]:
    """The lines that agents follow: their routes, and the roads of those that have none."""
    out = {}
    for actor in scene.agents:
        name = _path_name(actor)
        if actor.route is not None:
            out[name] = line_of_route(name, scene, actor.route)
        elif name in lines:
            out[name] = lines[name]
    return out


def agent_spec(
    actor: SceneActor,
    scene: Scene,
    paths: Mapping[str, int],
    lines: Mapping[str, RoadSamples],
    frame: SceneOrigin,
) -> dict[str, Any]:
    """The specification of an agent but for its look; `docs/godot.md` lists what it holds. `paths`:
    the engine's numbers of the lines that agents follow."""
    heading = math.remainder(actor.heading, math.tau)
    spec: dict[str, Any] = {
        "name": actor.name,
        "x": actor.x - frame.x,
        "y": actor.y - frame.y,
        "heading": heading,
        "length": actor.length,
        "width": actor.width,
        "height": actor.height,
        "speed": float(actor.start_speed or 0.0),
        "body": "walker" if is_walker(actor) else "vehicle",
        "drives": _drives(actor, scene, frame),
    }
    if not is_walker(actor):
        spec["vehicle"] = asdict(vehicle_parameters(actor, body_of(actor, BODIES)))
    name = _path_name(actor)
    if actor.route is not None:
        spec |= {"path": paths[name], "start": 0.0, "offset": 0.0, "direction": 1}
    elif name in paths:
        spec |= {
            "path": paths[name],
            "start": actor.start or 0.0,
            "offset": line_offset(actor, lines[name]),
            "direction": -1 if actor.facing == "back" else 1,
        }
        offsets = _line_offsets(actor, scene)
        if offsets:
            spec["offsets"] = offsets
    return spec


START_MEMBERS = ("x", "y", "heading", "speed", "placed")
"""Of a specification: the pose and speed at the start, and how often an edit has changed it."""


def kept_start(
    spec: dict[str, Any], earlier: Mapping[str, Any], restarted: bool, at: Mapping[str, float]
) -> dict[str, Any]:
    """The specification after an edit of the scene: an agent that goes on keeps its start, for the
    engine begins anew with those whose `placed` has changed. `at`: members of the start of one that
    begins anew elsewhere than the scene says."""
    if restarted:
        return {**spec, **at, "placed": int(earlier.get("placed", 0)) + 1}
    start = {key: earlier[key] for key in START_MEMBERS if key in earlier}
    return {**spec, **start}


def line_offset(actor: SceneActor, line: RoadSamples) -> float:
    """How far left of the center line the line lies that an agent should follow.

    The middle of its lane where it has one, else where it stands, or of the lane that it enters
    from beside the road; who crosses goes its own way.
    """
    if actor.lane is not None and actor.lane in line.cross_section.ids:
        return float(line.cross_section.offset(actor.lane, actor.start or 0.0))
    offset = actor.offset or 0.0
    if abs(offset) < float(line.at(np.array([actor.start or 0.0]))[2][0]) / 2:
        return offset
    if is_walker(actor):
        return 0.0
    backward = actor.facing == "back"
    return line.cross_section.entered_from(offset, actor.start or 0.0, backward=backward)


def _line_offsets(actor: SceneActor, scene: Scene) -> list[list[float]]:
    """Where its lane changes its width: arc lengths of its road, and how far left of the center
    line the line lies there that it should follow."""
    road = next((road for road in scene.roads if road.name == actor.road), None)
    guide = None if road is None or actor.lane is None else lane_guide(road, actor.lane)
    if guide is None:
        return []
    pairs = np.stack(guide, axis=1)
    if len(pairs) > MOST_OFFSETS:  # where the line is straight there are none to leave out
        pairs = pairs[np.linspace(0, len(pairs) - 1, MOST_OFFSETS).round().astype(np.int64)]
    offsets: list[list[float]] = np.round(pairs, 3).tolist()
    return offsets


def _path_name(actor: SceneActor) -> str:
    return (actor.road or "") if actor.route is None else f"the route of {actor.name}"


def _drives(actor: SceneActor, scene: Scene, frame: SceneOrigin) -> list[dict[str, Any]]:
    out = []
    for call in actor.drive:
        drive = {
            "kind": plain_name(call.kind), **option_values(call, default_speed(actor, scene))
        }  # fmt: skip
        for key, condition in (("when", call.when), ("while", call.during)):
            if condition is not None:
                drive[key] = engine_condition(condition, scene, frame)
        out.append(drive)
    return out
