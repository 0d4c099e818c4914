"""The controllers of roadlang that OpenSCENARIO has actions for."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import LanePlace
from roadlang_standard.recorded_poses import recording

from ..opendrive.elements import put
from ..target_speed import target_speed
from . import actions
from .entities import rear_axle, vehicle_class, wheelbase
from .positions import Roads
from .triggers import Condition, NotExpressibleError, of_entity

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from roadlang.api import Call, Scene, SceneActor, SceneRoad

_RATE = 2.0
"""m/s^2 where a controller does not say how it speeds up."""


@dataclass(frozen=True)
class DrivenAgent:
    """What the controllers of an agent are translated with. `speed`: that of the controller before,
    m/s."""

    scene: Scene
    roads: Roads
    actor: SceneActor
    speed: list[float] = field(default_factory=list)

    @property
    def road(self) -> SceneRoad | None:
        return next((road for road in self.scene.roads if road.name == self.actor.road), None)

    @property
    def direction(self) -> float:
        return -1.0 if self.actor.facing == "back" else 1.0


Actions = list[tuple[str, tuple[actions.Action, ...], tuple[Condition, ...]]]
"""Names of events with their actions and with conditions beside that of the controller."""


def _drives(agent: DrivenAgent, call: Call) -> Actions:
    """Controllers that drive at a speed."""
    speed = _target_speed(agent, call)
    agent.speed.append(speed)
    rate = float(call.options.get("acceleration") or _RATE)
    if call.when is None and math.isclose(agent.actor.start_speed or 0.0, speed):
        return []
    return [(call.kind, (actions.to_speed(speed, "linear", "rate", rate),), ())]


def _target_speed(agent: DrivenAgent, call: Call) -> float:
    speed = target_speed(agent.scene, agent.actor, call)
    vehicle = vehicle_class(agent.actor)
    return speed if vehicle is None else min(speed, vehicle.speed)


def _brake(agent: DrivenAgent, call: Call) -> Actions:
    rate = float(call.options["deceleration"])
    return [("brake", (actions.to_speed(call.options["speed"], "linear", "rate", rate),), ())]


def _stop_at(agent: DrivenAgent, call: Call) -> Actions:
    """It begins to brake where it must; or within the distance from where it takes over."""
    rate, speed = (
        float(call.options["deceleration"]),
        (agent.speed or [LanePlace.default_speed])[-1],
    )
    station, distance = call.options.get("station"), call.options.get("distance")
    braking = speed * speed / (2.0 * rate)
    brake = actions.to_speed(0.0, "linear", "rate", rate)
    if station is None and distance is None:
        return [("stop", (brake,), ())]
    if distance is None and station is not None:
        return [("stop", (brake,), (_near(agent, float(station), braking),))]
    if distance is not None and station is None and call.when is None:
        far = max(float(distance) - braking, 0.0)
        traveled = of_entity(agent.actor.name, "TraveledDistanceCondition", value=far)
        return [("stop", (brake,), (traveled,))]
    raise NotExpressibleError


def _near(agent: DrivenAgent, station: float, distance: float) -> Condition:
    """That an agent is no farther from a station of its road."""
    actor, road = agent.actor, agent.road
    if road is None or actor.offset is None:
        raise NotExpressibleError
    at = station - agent.direction * 0.5 * wheelbase(actor)
    x, y, heading = (
        float(np.interp(at, road.stations, column)) for column in (road.x, road.y, road.heading)
    )
    x, y = x - actor.offset * math.sin(heading), y + actor.offset * math.cos(heading)
    place = agent.roads.place(x, y, heading, road.name)

    def write(parent: Element) -> None:
        found = put(parent, "ByEntityCondition")
        entities = put(found, "TriggeringEntities", triggeringEntitiesRule="any")
        put(entities, "EntityRef", entityRef=actor.name)
        condition = put(
            put(found, "EntityCondition"),
            "DistanceCondition",
            freespace="false",
            rule="lessOrEqual",
            value=distance,
            relativeDistanceType="euclidianDistance",
            coordinateSystem="entity",
        )
        place.put(condition, turned=False)

    return write


def _speed_profile(agent: DrivenAgent, call: Call) -> Actions:
    """Times of points: between two of them the acceleration is constant."""
    points = sorted((float(at), float(speed)) for at, speed in call.options["points"])
    entries = [(points[0][1], 0.0)]
    for (at, before), (then, after) in pairwise(points):
        if before + after <= 0.0:
            raise NotExpressibleError
        entries.append((after, 2.0 * (then - at) / (before + after)))
    agent.speed.append(points[-1][1])
    return [("speed profile", (actions.speed_profile(entries),), ())]


def _change_lane(agent: DrivenAgent, call: Call) -> Actions:
    options, name = call.options, agent.actor.name
    is_distance = options.get("distance") is not None
    dimension = "distance" if is_distance else "time"
    value = float(options["distance" if is_distance else "duration"])
    to = options["to"]
    if to in ("left", "right"):
        change = actions.lane_change(dimension, value, None, (name, 1 if to == "left" else -1))
        return [("lane change", (change,), ())]
    lane = _nearest_of_kind(agent, to) if isinstance(to, str) else int(to)
    at = agent.roads.at(agent.actor.road or "", lane, agent.actor.start or 0.0)
    if at is None or at.lane is None:
        raise NotExpressibleError
    change = actions.lane_change(dimension, value, at.lane.lane, (name, 0))
    return [("lane change", (change,), ())]


def _nearest_of_kind(agent: DrivenAgent, kind: str) -> int:
    """The lane of a kind, such as `parking`, that is nearest to where an agent begins."""
    road, actor = agent.road, agent.actor
    ids = [] if road is None else [lane.id for lane in road.lane_list if lane.kind == kind]
    if road is None or not ids:
        raise NotExpressibleError
    section, start = road.cross_section(), actor.start or 0.0
    return min(ids, key=lambda id: abs(float(section.offset(id, start)) - (actor.offset or 0.0)))


def _cut_in(agent: DrivenAgent, call: Call) -> Actions:
    """Faster than the target until the gap is there, then into its lane."""
    options, name = call.options, agent.actor.name
    target = str(options["target"])
    if target not in {actor.name for actor in agent.scene.agents}:
        raise NotExpressibleError
    closing, rate = float(options["closing"]), float(options["acceleration"])
    passes = actions.to_speed_beside(target, closing, rate)
    change = actions.lane_change("time", float(options["duration"]), None, (target, 0))
    keeps = actions.to_speed_beside(target, 0.0, float(options["deceleration"]))

    def ahead(parent: Element) -> None:
        # The gap shrinks until it is beside the target, and is there as soon as it grows to that.
        parent.set("conditionEdge", "rising")
        of_entity(
            name,
            "RelativeDistanceCondition",
            entityRef=target,
            freespace="true",
            rule="greaterOrEqual",
            value=float(options["gap"]),
            relativeDistanceType="longitudinal",
            coordinateSystem="lane",
        )(parent)

    return [("pass", (passes,), ()), ("cut in", (change, keeps), (ahead,))]


def _crossing(agent: DrivenAgent, call: Call) -> Actions:
    """Straight across the road, and `beyond` farther."""
    actor, road = agent.actor, agent.road
    speed = float(call.options["speed"])
    if road is None or actor.start is None or actor.offset is None or speed <= 0.0:
        raise NotExpressibleError
    heading = float(np.interp(actor.start, road.stations, road.heading))
    width = float(np.interp(actor.start, road.stations, road.width))
    far = abs(actor.offset) + 0.5 * width + float(call.options["beyond"])
    heading += 0.5 * math.pi if actor.offset < 0.0 else -0.5 * math.pi
    end = actor.x + far * math.cos(heading), actor.y + far * math.sin(heading)
    poses = np.array([(actor.x, actor.y, heading), (*end, heading)])
    times = np.array([0.0, far / speed])
    walk = actions.follow_trajectory(f"{actor.name} across", times, poses, absolute=False)
    return [("crossing", (walk,), ())]


def _replay(agent: DrivenAgent, call: Call) -> Actions:
    actor = agent.actor
    found = recording(str(call.options["file"]), call.options.get("agent") or actor.name)
    poses = np.array([rear_axle(actor, *pose[:3]) for pose in found.pose.tolist()])
    follow = actions.follow_trajectory(f"{actor.name} replay", found.time, poses, absolute=False)
    return [("replay", (follow,), ())]


TRANSLATED: Mapping[str, Callable[[DrivenAgent, Call], Actions]] = {
    **dict.fromkeys(
        ("lane_follow", "car_follow", "traffic", "pure_pursuit", "stanley", "walk"), _drives
    ),
    "brake": _brake,
    "stop_at": _stop_at,
    "speed_profile": _speed_profile,
    "change_lane": _change_lane,
    "cut_in": _cut_in,
    "crossing": _crossing,
    "replay": _replay,
}
"""By kind: makes the actions of a controller. Raises NotExpressibleError."""
