"""The speed at which a controller wants to drive."""

from __future__ import annotations

from typing import TYPE_CHECKING

from roadlang.api import LanePlace

if TYPE_CHECKING:
    from roadlang.api import Call, Scene, SceneActor


def target_speed(scene: Scene, actor: SceneActor, call: Call) -> float:
    """m/s: that of the controller, else the limit where the agent starts, times its factor."""
    speed = call.options.get("speed")
    if isinstance(speed, (int, float)):
        return float(speed)
    return _limit(scene, actor) * float(call.options.get("speed_factor") or 1.0)


def _limit(scene: Scene, actor: SceneActor) -> float:
    """Of its lane or road."""
    road = next((road for road in scene.roads if road.name == actor.road), None)
    if road is None:
        return LanePlace.default_speed
    own = next((lane.speed_limit for lane in road.lane_list if lane.id == actor.lane), None)
    limit = road.limit_at(actor.start or 0.0, own)
    return LanePlace.default_speed if limit is None else limit
