"""Which controllers the engine has, and what is sent to it of a call."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from roadlang.api import LanePlace

if TYPE_CHECKING:
    from roadlang.api import Call, Scene, SceneActor

IN_ENGINE = frozenset(
    {"pure_pursuit", "stanley", "lane_follow", "car_follow", "brake", "crossing", "manual"}
)

EMBEDDED_ONLY = {"traffic": "right of way"}
"""Controllers that drive in the embedded engine alone, and what they need of it."""


WALKERS = ("pedestrian", "animal")


def is_walker(actor: SceneActor) -> bool:
    """Whether the engine builds it as someone on foot."""
    return plain_name(actor.kind) in WALKERS


def plain_name(kind: str) -> str:
    """`pure_pursuit` of `roadlang.pure_pursuit` or `standard.pure_pursuit`; a stranger's name
    stays whole."""
    plugin, _, name = kind.rpartition(".")
    return name if plugin in ("", "roadlang", "standard") else kind


def usual_speed(actor: SceneActor, scene: Scene) -> float:
    """What controllers drive that say no speed, m/s: the speed limit, where there is one."""
    road = next((one for one in scene.roads if one.name == actor.road), None)
    if road is None:
        return LanePlace.usual_speed
    limits = [one.speed_limit for one in road.lane_list if one.id == actor.lane]
    limit = limits[0] if limits and limits[0] is not None else road.speed_limit
    return LanePlace.usual_speed if limit is None else limit


def option_values(call: Call, usual: float = LanePlace.usual_speed) -> dict[str, Any]:
    """The options that are numbers or words; an engine knows nothing else. `usual`: the speed of a
    controller that says none."""
    out: dict[str, Any] = {}
    if "speed" in call.options and call.options["speed"] is None:
        out["speed"] = usual
    for key, value in call.options.items():
        if isinstance(value, str) or (isinstance(value, (int, float)) and math.isfinite(value)):
            out[key] = value if isinstance(value, (str, bool)) else float(value)
    return out
