"""The handles that can be dragged in a window, and the text that results from dragging one."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from ..geometry.arrays import Floats
from ..ir.scene import Scene, SceneActor, SceneRoad
from ..syntax.moved_places import moved_places_of, with_moved_places
from ..syntax.scene_edits import (
    thing_moved,
    thing_moved_along,
    thing_removed,
    waypoint_inserted,
    waypoint_moved,
    waypoint_removed,
    waypoints_of,
)
from ..syntax.text_edits import Place, declared, place_of
from ..syntax.tree.nodes import Actor, Geometry
from .handle import SPACING, Handle, Sort
from .networks import network_dragged, network_handles, network_restored

MOST = 60
"""Maximum number of handles of a road, besides those that were already moved."""
NEAREST = 0.5
"""Share of the spacing around a moved place that has no other handle."""


def handles_of(text: str, scene: Scene) -> tuple[Handle, ...]:
    """The handles of all that a text declares and a scene shows, in a fixed order."""
    roads = (*_of_roads(text, scene), *network_handles(text, scene))
    return (*roads, *_of_things(text, scene))


def dragged(text: str, scene: Scene, handle: Handle, to: Place, kind: str) -> str | None:
    """The text after a handle was dragged to a place; None where it cannot be written so.

    `kind`: what a road that is not drawn through points is perturbed with.
    """
    if handle.sort == "waypoint":
        return waypoint_moved(text, handle.name, handle.number, to)
    if handle.sort == "place":
        moved = moved_places_of(text, handle.name).moved(
            handle.station, (to[0] - handle.x, to[1] - handle.y)
        )
        return with_moved_places(text, handle.name, moved, kind)
    if handle.sort in ("junction", "street"):
        return network_dragged(text, handle, to)
    actor = next((a for a in (*scene.agents, *scene.standing) if a.name == handle.name), None)
    road = None if actor is None else _road(scene, actor.road)
    if actor is None or road is None or is_at_point(text, handle.name):
        return thing_moved(text, handle.name, to)
    start, offset = nearest_on_road(road, to)
    return thing_moved_along(text, handle.name, start, offset - (actor.offset or 0.0))


def inserted(text: str, scene: Scene, near: Handle, at: Place, kind: str) -> str | None:
    """The text with one more handle of a road at a place; None where the handle is of no road.

    `kind`: as of `dragged`.
    """
    if near.sort == "waypoint":
        points = waypoints_of(text, near.name) or []
        road = _road(scene, near.name)
        closed = road is not None and road.closed
        return waypoint_inserted(text, near.name, _place_between(points, at, closed), at)
    road = _road(scene, near.name)
    if near.sort != "place" or road is None:
        return None
    start, _ = nearest_on_road(road, at)
    station = round(float(np.interp(start, road.stations, road.reference_stations)), 2)
    foot = _point_at(road, station)
    moved = moved_places_of(text, near.name).moved(station, (at[0] - foot[0], at[1] - foot[1]))
    return with_moved_places(text, near.name, moved, kind)


def removed(text: str, handle: Handle) -> str | None:
    """The text without what a handle moves: a waypoint, the move of a place, an agent or object."""
    if handle.sort == "waypoint":
        return waypoint_removed(text, handle.name, handle.number)
    if handle.sort == "place":
        places = moved_places_of(text, handle.name)
        if handle.station not in places.at:
            return None
        return with_moved_places(text, handle.name, places.without(handle.station), "")
    if handle.sort in ("junction", "street"):
        return network_restored(text, handle)
    return thing_removed(text, handle.name)


def nearest_on_road(road: SceneRoad, place: Place) -> tuple[float, float]:
    """Arc length of the point of a road that is nearest to a place, and how far left of the road
    the place is, in meters."""
    points, stations = _polyline(road)
    steps = np.diff(points, axis=0)
    away = np.asarray(place) - points[:-1]
    lengths = np.maximum((steps**2).sum(axis=1), 1e-12)
    share = np.clip((away * steps).sum(axis=1) / lengths, 0.0, 1.0)
    feet = points[:-1] + share[:, None] * steps
    at = int(np.hypot(*(np.asarray(place) - feet).T).argmin())
    cross = steps[at, 0] * away[at, 1] - steps[at, 1] * away[at, 0]
    start = stations[at] + share[at] * (stations[at + 1] - stations[at])
    return float(start), float(cross / math.sqrt(lengths[at]))


def _of_roads(text: str, scene: Scene) -> Iterator[Handle]:
    roads = [road for road in scene.roads if road.network is None and not _is_part(scene, road)]
    driven = {actor.road for actor in scene.agents}
    for road in [road for road in roads if road.derived or road.name in driven] or roads:
        statement = declared(text, road.name)
        if not isinstance(statement, Geometry):
            continue
        passes = () if statement.block is None else statement.block.passes
        points = None
        if all(found.verb.text != "perturb" for found in passes):
            points = waypoints_of(text, road.name)
        if points is not None:
            for number, (x, y) in enumerate(points):
                yield Handle("waypoint", road.name, x, y, number)
        else:
            yield from _place_handles(text, road)


def _is_part(scene: Scene, road: SceneRoad) -> bool:
    """Whether a road only runs over some of the roads of a network, which are what is shown."""
    parts = {part.road for part in road.along}
    return bool(parts) and any(parts < set(found.roads) for found in scene.networks)


def _place_handles(text: str, road: SceneRoad) -> Iterator[Handle]:
    """At the places that were moved already, and evenly between."""
    moved = moved_places_of(text, road.name).at
    last = road.reference_stations[-1]
    count = min(MOST, max(2, round(last / SPACING)))
    spacing = last / count
    even = [round(spacing * i, 2) for i in range(count if road.closed else count + 1)]
    free = [s for s in even if all(abs(s - at) > NEAREST * spacing for at in moved)]
    for station in sorted({*moved, *free}):
        x, y = _point_at(road, station)
        yield Handle("place", road.name, x, y, station=station)


def _of_things(text: str, scene: Scene) -> Iterator[Handle]:
    sorts: tuple[tuple[Sort, tuple[SceneActor, ...]], ...]
    sorts = ("object", scene.standing), ("agent", scene.agents)
    for sort, actors in sorts:
        for actor in actors:
            if actor.name == actor.group and _can_be_moved(text, scene, actor):
                yield Handle(sort, actor.name, actor.x, actor.y)


def _can_be_moved(text: str, scene: Scene, actor: SceneActor) -> bool:
    if not isinstance(declared(text, actor.name), Actor):
        return False
    return is_at_point(text, actor.name) or _road(scene, actor.road) is not None


def is_at_point(text: str, name: str) -> bool:
    """Whether a text has the place of an agent or object in numbers."""
    found = declared(text, name)
    return isinstance(found, Actor) and place_of(found.at) is not None


def _road(scene: Scene, name: str | None) -> SceneRoad | None:
    found = next((road for road in scene.roads if road.name == name), None)
    return None if found is None or found.network is not None else found


def _polyline(road: SceneRoad) -> tuple[Floats, Floats]:
    """(n, 2) points and (n,) arc lengths; of a closed road up to the start again."""
    points = np.column_stack([road.x, road.y])
    stations = np.array(road.stations)
    if road.closed:
        points = np.vstack([points, points[:1]])
        stations = np.append(stations, road.length)
    return points, stations


def _point_at(road: SceneRoad, station: float) -> Place:
    """The point of a road at a station of its root road."""
    x = np.interp(station, road.reference_stations, road.x)
    y = np.interp(station, road.reference_stations, road.y)
    return float(x), float(y)


def _place_between(points: list[Place], at: Place, closed: bool) -> int:
    """The number that a new waypoint gets: between the two whose line is nearest to it, or beyond
    an end of an open road."""
    ends = [*points, points[0]] if closed else points
    best, number = math.inf, len(points)
    for i, (a, b) in enumerate(pairwise(ends)):
        step = (b[0] - a[0], b[1] - a[1])
        size = step[0] ** 2 + step[1] ** 2
        share = ((at[0] - a[0]) * step[0] + (at[1] - a[1]) * step[1]) / max(size, 1e-12)
        inside = min(max(share, 0.0), 1.0)
        away = math.hypot(at[0] - a[0] - inside * step[0], at[1] - a[1] - inside * step[1])
        if away < best:
            first, last = i == 0 and not closed, i == len(ends) - 2 and not closed
            best = away
            number = 0 if first and share < 0.0 else i + 2 if last and share > 1.0 else i + 1
    return number
