"""Which controllers the engine has, and what is sent to it of a call."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from roadlang.api import ON_FOOT, LanePlace

from .conditions import is_known
from .names import plain_name

if TYPE_CHECKING:
    from roadlang.api import Call, Scene, SceneActor

T = TypeVar("T")

MANUAL = "manual"
IN_ENGINE = frozenset({"pure_pursuit", "stanley", "lane_follow", "car_follow", "brake", MANUAL})


def is_walker(actor: SceneActor) -> bool:
    """Whether the engine builds it as someone on foot."""
    return actor.category in ON_FOOT


def drives_alone(scene: Scene) -> bool:
    """Whether the engine has all that the agents of a scene are driven by: no routes, no
    controllers and no sensors of Python."""
    return all(
        actor.route is None and not actor.sensors and all(map(is_in_engine, actor.drive))
        for actor in scene.agents
    )


def drives_by_hand(scene: Scene) -> bool:
    """Whether a human drives any of the agents."""
    return any(plain_name(call.kind) == MANUAL for actor in scene.agents for call in actor.drive)


def decided_in_python(scene: Scene, controllers: Mapping[str, T]) -> dict[str, T]:
    """The controllers that Python is to run: none where the engine has copies of all."""
    alone = drives_alone(scene) and not drives_by_hand(scene)
    return {} if alone else dict(controllers)


def is_in_engine(call: Call) -> bool:
    """Whether the engine has a copy of a controller, and can evaluate its conditions."""
    conditions = [condition for condition in (call.when, call.during) if condition is not None]
    return plain_name(call.kind) in IN_ENGINE and all(map(is_known, conditions))


def undriven_agents(scene: Scene, python_driven: Collection[str]) -> tuple[str, ...]:
    """Agents that Python does not drive, and that the engine cannot."""
    return tuple(
        actor.name
        for actor in scene.agents
        if actor.name not in python_driven and not all(map(is_in_engine, actor.drive))
    )


def default_speed(actor: SceneActor, scene: Scene) -> float:
    """What controllers drive that say no speed, m/s: the speed limit, where there is one."""
    road = next((candidate for candidate in scene.roads if candidate.name == actor.road), None)
    if road is None:
        return LanePlace.default_speed
    limits = [candidate.speed_limit for candidate in road.lane_list if candidate.id == actor.lane]
    limit = limits[0] if limits and limits[0] is not None else road.speed_limit
    return LanePlace.default_speed if limit is None else limit


def option_values(call: Call, default_speed: float = LanePlace.default_speed) -> dict[str, Any]:
    """The options that are numbers or words; an engine knows nothing else. `default_speed`: of a
    controller that says none."""
    out: dict[str, Any] = {}
    if "speed" in call.options and call.options["speed"] is None:
        out["speed"] = default_speed
    for key, value in call.options.items():
        if isinstance(value, str) or (isinstance(value, (int, float)) and math.isfinite(value)):
            out[key] = value if isinstance(value, (str, bool)) else float(value)
    return out
