"""Agents and objects as obstacles of CommonRoad."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from roadlang.api import VEHICLES

from .elements import put, put_exact, put_point, put_rectangle
from .numbering import Numbering

if TYPE_CHECKING:
    from roadlang.api import AgentTrace, Scene, SceneActor, Trace

_TYPES = {
    "car": "car",
    "van": "car",
    "truck": "truck",
    "tractor": "truck",
    "bus": "bus",
    "motorcycle": "motorcycle",
    "bicycle": "bicycle",
    "pedestrian": "pedestrian",
}
_PRIORITY = ("police", "ambulance", "fire")
_STANDING = {
    "cone": "constructionZone",
    "barrier": "constructionZone",
    "guardrail": "roadBoundary",
    **dict.fromkeys(VEHICLES, "parkedVehicle"),
}
_ENVIRONMENT = {"building": "building", "pole": "pillar", "lamp": "pillar"}


def ego_of(scene: Scene) -> SceneActor | None:
    """Whose planning problem it is: the agent `ego`, else the first that drives."""
    driving = [agent for agent in scene.agents if agent.drive]
    named = [agent for agent in scene.agents if agent.name == "ego"]
    return next(iter([*named, *driving]), None)


def put_obstacles(root: Element, scene: Scene, trace: Trace | None, numbering: Numbering) -> None:
    """All but the ego. Agents that drive are dynamic, once they were driven; before, nobody knows
    where they will be, and they are left out."""
    ego = ego_of(scene)
    others = [agent for agent in scene.agents if agent is not ego]
    standing = [thing for thing in scene.objects if thing.category not in _ENVIRONMENT]
    standing += [agent for agent in others if not agent.drive]
    for actor in standing:
        found = put(root, "staticObstacle", id=numbering.next())
        put(found, "type", _STANDING.get(actor.category, "unknown"))
        put_rectangle(put(found, "shape"), actor.length, actor.width)
        _put_state(found, "initialState", 0, actor.x, actor.y, actor.heading)
    for actor in others:
        if trace is not None and actor.drive and actor.name in trace.agents:
            _put_dynamic(root, actor, trace.agents[actor.name], numbering)
    for actor in scene.objects:
        if actor.category in _ENVIRONMENT:
            found = put(root, "environmentObstacle", id=numbering.next())
            put(found, "type", _ENVIRONMENT[actor.category])
            shape = put(found, "shape")
            put_rectangle(shape, actor.length, actor.width, actor.heading, actor.x, actor.y)


def _put_dynamic(root: Element, actor: SceneActor, agent: AgentTrace, numbering: Numbering) -> None:
    found = put(root, "dynamicObstacle", id=numbering.next())
    usual = _TYPES.get(actor.category, "unknown")
    put(found, "type", "priorityVehicle" if actor.role in _PRIORITY else usual)
    put_rectangle(put(found, "shape"), actor.length, actor.width)
    there = max(1, agent.samples_there)
    poses = np.column_stack((agent.x, agent.y, agent.heading, agent.speed))[:there].tolist()
    if len(poses) == 1:
        poses *= 2  # the format demands a state after the initial one
    _put_state(found, "initialState", 0, *poses[0])
    trajectory = put(found, "trajectory")
    for step, pose in enumerate(poses[1:], 1):
        _put_state(trajectory, "state", step, *pose)


def _put_state(
    parent: Element, tag: str, step: int, x: float, y: float, heading: float, speed: float = 0.0
) -> None:
    state = put(parent, tag)
    put_point(put(state, "position"), x, y)
    put_exact(state, "orientation", math.remainder(heading, math.tau))
    put_exact(state, "time", step)
    put_exact(state, "velocity", float(speed))
