"""The parts of roads along which agents go."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from ..surfaces.built import is_loop

if TYPE_CHECKING:
    from roadlang.api import RoadPart, Scene, SceneActor, SceneRoad


@dataclass(frozen=True)
class RoadSpan:
    """A part of a road from one station to another; `back`: against the road."""

    road: str
    start: float
    stop: float
    back: bool


def places_of(scene: Scene, actor: SceneActor) -> list[RoadSpan]:
    """The parts of roads along which an agent goes: its route, or to the end of its road."""
    roads = {road.name: road for road in scene.roads}
    if actor.route is not None:
        steps = actor.route.steps
        found: list[RoadSpan] = []
        for step, before in zip(steps, (None, *steps), strict=False):
            if before is not None and before.turn is None and before.road == step.road:
                found[-1] = replace(found[-1], stop=step.stop)
            else:
                back = step.stop < step.start
                if step.stop == step.start and step.road in roads:
                    back = _against(roads[step.road], step.lane, back)
                found.append(RoadSpan(step.road, step.start, step.stop, back))
        return found
    road = roads.get(actor.road or "")
    if road is None or actor.start is None:
        return []
    back = _against(road, actor.lane, actor.facing == "back")
    if not road.derived:
        return _along(road, actor.start, back)
    first, last = (road.length, 0.0) if back else (0.0, road.length)
    lap = [RoadSpan(road.name, first, actor.start, back)] if is_loop(road) else []
    return [RoadSpan(road.name, actor.start, last, back), *lap]


def _against(road: SceneRoad, lane: int | None, back: bool) -> bool:
    """Whether a vehicle drives against its road: as its lane says, else as it faces (`back`)."""
    ways = {found.direction for found in road.lane_list if found.id == lane}
    if ways <= {"both", "none"}:
        return back
    return ways == {"backward"}


def _along(road: SceneRoad, start: float, back: bool) -> list[RoadSpan]:
    """Of a road that only runs over others."""
    found, at = [], 0.0
    for part in road.along:
        length = abs(part.stop - part.start)
        found.append((at, at + length, part))
        at += length
    if back:
        return [
            RoadSpan(part.road, _inside(part, min(high, start) - low), part.start,
                   part.start <= part.stop)
            for low, high, part in reversed(found) if low < start
        ]  # fmt: skip
    return [
        RoadSpan(part.road, _inside(part, max(low, start) - low), part.stop, part.stop < part.start)
        for low, high, part in found
        if high > start
    ]


def _inside(part: RoadPart, distance: float) -> float:
    return float(part.start + (distance if part.stop >= part.start else -distance))
