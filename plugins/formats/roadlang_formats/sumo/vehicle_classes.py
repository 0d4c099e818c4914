"""The vehicle classes of SUMO: what agents are, and what lanes are for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from roadlang.api import ON_FOOT

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor
    from roadlang.geometry import Lane

_CLASSES = {
    "van": "delivery",
    "truck": "truck",
    "tractor": "truck",
    "bus": "bus",
    "motorcycle": "motorcycle",
    "bicycle": "bicycle",
}
_ROLES = {"taxi": "taxi", "police": "authority", "ambulance": "emergency", "fire": "emergency"}
_BUS_LANE = frozenset({"bus", "taxi", "emergency", "authority"})
LaneUse = Mapping[tuple[str, int], frozenset[str]]
"""Classes of the agents that drive on a lane, by road and lane."""


def class_of(actor: SceneActor) -> str:
    """The `vClass` of an agent with wheels."""
    return _ROLES.get(actor.role) or _CLASSES.get(actor.category, "passenger")


def has_wheels(actor: SceneActor) -> bool:
    """Whether an agent is a vehicle."""
    return actor.category not in ON_FOOT


def lane_use(scene: Scene) -> LaneUse:
    """By which lanes the agents of a scene start and drive."""
    found: dict[tuple[str, int], set[str]] = {}
    for actor in filter(has_wheels, scene.agents):
        lanes = [(actor.road, actor.lane)]
        lanes += [(step.road, step.lane) for step in (actor.route.steps if actor.route else ())]
        for road, lane in lanes:
            if road is not None and lane is not None:
                found.setdefault((road, lane), set()).add(class_of(actor))
    return {place: frozenset(classes) for place, classes in found.items()}


def permissions(lane: Lane, used_by: frozenset[str]) -> str:
    """What a lane is for, as `allow` has it; empty for all on wheels.

    Agents may drive on bus lanes in roadlang: then their classes are allowed there.
    """
    if "pedestrian" in lane.users and not lane.drivable:
        return "pedestrian"
    if not lane.drivable:
        return "bicycle"
    return " ".join(sorted(_BUS_LANE | used_by)) if lane.kind == "bus" else ""
