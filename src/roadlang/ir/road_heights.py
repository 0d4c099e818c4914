"""How high the roads of a scene are, and what stands on them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from .scene import Scene, SceneActor, SceneRoad
from .trace import AgentTrace

if TYPE_CHECKING:
    from ..geometry.arrays import Floats

    RoadHeight = Callable[[Floats], Floats]
    """Meters at arc lengths of a road; NaN where nothing says it."""


def has_heights(scene: Scene) -> bool:
    """Whether any road of a scene has them. Else all is on the ground."""
    return any(road.elevation for road in scene.roads)


def standing_trace(scene: Scene, actor: SceneActor, time: Floats) -> AgentTrace:
    """What stands in a scene, at all times (T,)."""
    return AgentTrace.standing(actor, time, *object_heights(scene, [actor]))


def road_heights(scene: Scene) -> Mapping[str, RoadHeight]:
    """Of the roads of a scene, by name; not known where none `has_heights`."""
    roads = {road.name: road for road in scene.roads}
    if not has_heights(scene):
        return dict.fromkeys(roads, _unknown)
    return {name: _height(road, roads) for name, road in roads.items()}


def object_heights(scene: Scene, actors: Sequence[SceneActor]) -> list[float]:
    """Of what stands in a scene; NaN beside all roads."""
    import numpy as np

    if not has_heights(scene):
        return [math.nan] * len(actors)
    known = road_heights(scene)
    return [
        float(known[actor.road](np.array([actor.start]))[0])
        if actor.road is not None and actor.start is not None
        else math.nan
        for actor in actors
    ]


def _unknown(s: Floats) -> Floats:
    import numpy as np

    return np.full(len(s), math.nan)


def _height(road: SceneRoad, roads: Mapping[str, SceneRoad]) -> RoadHeight:
    import numpy as np

    if road.elevation:
        return lambda s: np.interp(s, road.stations, road.elevation)
    if not road.along:  # of a network it is on the ground
        return _unknown if road.network is None else lambda s: np.zeros(len(s))
    begins = np.cumsum([0.0, *(abs(part.stop - part.start) for part in road.along)])
    parts = [(part, _height(roads[part.road], roads)) for part in road.along]

    def over_parts(s: Floats) -> Floats:
        out = np.zeros(len(s))
        for place, (part, height) in enumerate(parts):
            inside = s >= begins[place] if place else np.full(len(s), True)
            there = part.start + np.sign(part.stop - part.start) * (s[inside] - begins[place])
            out[inside] = height(there)
        return out

    return over_parts
