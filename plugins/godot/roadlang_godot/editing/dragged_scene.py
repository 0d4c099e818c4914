"""A scene while something in it is dragged: what the text will compile to, without compiling."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from roadlang.api import geometry
from roadlang.commands import (
    is_at_point,
    moved_places_of,
    nearest_on_road,
    offset_of,
    waypoints_of,
)

from .dragged_road import with_dragged_road

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, SceneRoad
    from roadlang.commands import Handle

    Place = tuple[float, float]

Named = TypeVar("Named", "SceneActor", "SceneRoad")

SAME_LENGTH = 0.01
"""Meters by which a road may be longer than the spline through its waypoints, to be that spline."""


def dragged_scene(
    scene: Scene, taken: Scene, texts: tuple[str, str], handle: Handle, to: Place
) -> Scene | None:
    """A scene with what a handle moves at a place; what depends on it stays. `taken`: the scene
    when it was taken; `texts`: its text then, and now. None for networks, and where only compiling
    tells."""
    text = texts[0]
    if handle.sort in ("agent", "object"):
        known = _named(handle.name, (*taken.agents, *taken.standing))
        return None if known is None else _with_thing(scene, _moved(taken, texts, known, to))
    road: SceneRoad | None = None
    if handle.sort == "waypoint":
        road = _through_moved_waypoint(taken, text, handle, to)
    elif handle.sort == "place":
        by = (to[0] - handle.x, to[1] - handle.y)
        length = moved_places_of(text, handle.name).length
        shown = with_dragged_road(taken, handle.name, handle.station, by, length)
        road = None if shown is None else _named(handle.name, shown.roads)
    if road is None:
        return None
    return replace(scene, roads=tuple(road if r.name == road.name else r for r in scene.roads))


def _through_moved_waypoint(taken: Scene, text: str, handle: Handle, to: Place) -> SceneRoad | None:
    """The road with one waypoint elsewhere; None where it is no spline through its waypoints, or
    would be none."""
    known, points = _named(handle.name, taken.roads), waypoints_of(text, handle.name)
    if known is None or points is None or not _is_spline(known, points):
        return None
    moved = [to if i == handle.number else point for i, point in enumerate(points)]
    try:
        curve = geometry.through_waypoints(moved, known.closed)
    except geometry.GeometryError:
        return None
    count = len(known.x)
    stations = np.linspace(0.0, curve.length, count + 1 if known.closed else count)[:count]
    x, y = curve.at(stations).T
    along = tuple(stations.tolist())
    return replace(
        known,
        stations=along,
        reference_stations=along,
        x=tuple(x.tolist()),
        y=tuple(y.tolist()),
        heading=tuple(curve.heading(stations).tolist()),
        curvature=tuple(curve.curvature(stations).tolist()),
        length=float(curve.length),
    )


def _with_thing(scene: Scene, moved: SceneActor) -> Scene:
    agents, objects, markings = (
        tuple(moved if actor.name == moved.name else actor for actor in actors)
        for actors in (scene.agents, scene.objects, scene.markings)
    )
    return replace(scene, agents=agents, objects=objects, markings=markings)


def _moved(taken: Scene, texts: tuple[str, str], actor: SceneActor, to: Place) -> SceneActor:
    road = _named(actor.road, taken.roads)
    if road is None or is_at_point(texts[0], actor.name):
        return replace(actor, x=to[0], y=to[1])
    before, after = (offset_of(text, actor.name) or 0.0 for text in texts)
    return _beside(actor, road, nearest_on_road(road, to)[0], after - before)


def _beside(actor: SceneActor, road: SceneRoad, start: float, sideways: float) -> SceneActor:
    offset = (actor.offset or 0.0) + sideways
    turned = actor.heading - _heading(road, actor.start or 0.0)
    heading = _heading(road, start)
    x = float(np.interp(start, road.stations, road.x)) - offset * np.sin(heading)
    y = float(np.interp(start, road.stations, road.y)) + offset * np.cos(heading)
    return replace(
        actor, start=start, offset=offset, heading=heading + turned, x=float(x), y=float(y)
    )


def _named(name: str | None, found: Iterable[Named]) -> Named | None:
    return next((one for one in found if one.name == name), None)


def _heading(road: SceneRoad, station: float) -> float:
    return float(np.interp(station, road.stations, np.unwrap(road.heading)))


def _is_spline(road: SceneRoad, points: Sequence[Place]) -> bool:
    length = _spline_length(tuple(points), road.closed)
    return length is not None and abs(length - road.length) < SAME_LENGTH


@lru_cache(maxsize=4)
def _spline_length(points: tuple[Place, ...], closed: bool) -> float | None:
    """Asked at each move of a drag, with the same points."""
    try:
        return float(geometry.through_waypoints(points, closed).length)
    except geometry.GeometryError:
        return None
