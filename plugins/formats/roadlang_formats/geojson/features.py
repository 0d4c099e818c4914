"""What a scene consists of, as lines and areas with properties.

Those of roads and buildings are named as in OpenStreetMap, so that `read with geojson` and others
know them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import Curve, Floats, Footprints, Lane
from roadlang_formats.decimals import bearing
from roadlang_formats.speed_units import in_kmh
from roadlang_formats.surfaces.built import built_roads, is_loop
from roadlang_formats.surfaces.junction_surface import junction_surfaces
from roadlang_formats.surfaces.road_surface import RoadSurface, road_surfaces
from roadlang_formats.surfaces.thinning import thinned

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, SceneRoad

_SPACING = 0.25
"""Meters between points of a line before it is thinned."""
_MOST = 50
"""Points that one chord may skip."""
_LINE, _BORDER = 0.004, 0.01
"""Meters by which chords may be off center lines, and off the borders of lanes."""
_LEAST = 1e-3
"""Square meters of an area."""


@dataclass(frozen=True)
class Feature:
    """`id`: one in the file. `lines`: one (n, 2), or the rings of an area, the outer one first and
    counter-clockwise, each of which ends where it begins; meters east and north."""

    id: str
    lines: tuple[Floats, ...]
    properties: Mapping[str, object]
    is_area: bool = True


def road_features(scene: Scene) -> Iterator[Feature]:
    """The center lines of all that is built, through junctions to where they meet."""
    outside = {road.name for road in built_roads(scene)}
    for road in scene.roads:
        if road.derived:
            within = {} if road.name in outside else {"inside_junction": True}
            street = {"name": road.street} if road.street else {}
            found = {"type": "road", "road": road.name} | street | _traffic(road) | within
            yield Feature(f"road {road.name}", (_center_line(road),), found, is_area=False)


def _center_line(road: SceneRoad) -> Floats:
    curve = Curve.hermite(np.column_stack((road.x, road.y)), road.heading, closed=road.closed)
    s = np.linspace(0.0, curve.length, int(curve.length / _SPACING) + 2)
    points = curve.at(s[:-1] if road.closed else s)
    if road.closed:
        points = np.vstack((points, points[:1]))
    raised = np.column_stack((points, np.zeros(len(points))))
    return np.asarray(points[thinned(raised[None], _LINE, _MOST)])


def _traffic(road: SceneRoad) -> dict[str, object]:
    """Lanes, direction and speed limit, where one holds on the whole road."""
    section = road.cross_section()
    driven = [lane for lane in section.lanes if lane.drivable]
    if not driven:
        return {"highway": "path"}
    ways = [lane.direction for lane in driven]
    found: dict[str, object] = {"highway": "residential", "lanes": len(driven)}
    if set(ways) == {"forward"}:
        found["oneway"] = "yes"
    elif set(ways) == {"backward"}:
        found["oneway"] = "-1"
    elif set(ways) == {"forward", "backward"}:
        found["lanes:forward"] = ways.count("forward")
        found["lanes:backward"] = ways.count("backward")
    return found | _speed_limits(driven, {zone.speed_limit for zone in road.zones()})


def _speed_limits(driven: Sequence[Lane], of_road: set[float | None]) -> dict[str, object]:
    """In km/h, of the road or of its directions, where one holds on the whole road."""
    directions = {lane.direction for lane in driven}
    found: dict[str, object] = {}
    for direction in sorted(directions):
        lanes = (lane for lane in driven if lane.direction == direction)
        limits = {
            limit if lane.speed_limit is None else lane.speed_limit
            for lane in lanes
            for limit in of_road
        }
        limit = limits.pop()
        if not limits and limit is not None and math.isfinite(limit):
            found[f"maxspeed:{direction}"] = float(in_kmh(limit))
    if len(found) == len(directions) and len(set(found.values())) == 1:
        return {"maxspeed": next(iter(found.values()))}
    return found


def junction_features(scene: Scene) -> Iterator[Feature]:
    """The areas of the junctions that are built."""
    for surface in junction_surfaces(scene):
        ring = _closed(surface.ring[:, :2])
        yield Feature(surface.name, (ring,), {"type": "junction", "junction": surface.name})


def lane_features(scene: Scene) -> Iterator[Feature]:
    """The areas of lanes between junctions."""
    for surface in road_surfaces(scene, _BORDER):
        for place, lane in enumerate(surface.section.lanes):
            rings = _lane_rings(surface, place)
            if rings is None:
                continue
            properties = {
                "type": "lane",
                "road": surface.road.name,
                "lane": lane.id,
                "kind": lane.kind,
                "direction": lane.direction,
            }
            yield Feature(f"road {surface.road.name}, lane {lane.id}", rings, properties)


def _lane_rings(surface: RoadSurface, place: int) -> tuple[Floats, ...] | None:
    """The outline of a lane; of a loop, the outer and the inner border."""
    left, right = surface.borders[place, :, :2], surface.borders[place + 1, :, :2]
    if is_loop(surface.road):
        inner, outer = sorted((left, right), key=lambda ring: abs(_area(ring)))
        outer = outer if _area(outer) > 0.0 else outer[::-1]
        return outer, inner if _area(inner) < 0.0 else inner[::-1]
    ring = _closed(np.vstack((right, left[::-1])))
    return (ring,) if _area(ring) > _LEAST else None


def standing_features(actors: Sequence[SceneActor], type: str) -> Iterator[Feature]:
    """The footprints of agents or objects, meters; `bearing` is clockwise from north, degrees,
    `speed` that of the start, m/s."""
    for actor in actors:
        ring = Footprints(*(np.array(value) for value in
            (actor.x, actor.y, actor.heading, actor.length, actor.width))).corners  # fmt: skip
        properties: dict[str, object] = {
            "type": type,
            "name": actor.name,
            "kind": actor.kind,
            "category": actor.category,
            "bearing": bearing(actor.heading, 6),
            "length": round(actor.length, 6),
            "width": round(actor.width, 6),
            "height": round(actor.height, 6),
        }
        if actor.category == "building":
            properties["building"] = "yes"
        if actor.start_speed is not None:
            properties["speed"] = round(actor.start_speed, 6)
        yield Feature(f"{type} {actor.name}", (_closed(ring),), properties)


def _closed(ring: Floats) -> Floats:
    return np.vstack((ring, ring[:1]))


def _area(ring: Floats) -> float:
    """Square meters within a closed ring (n, 2), positive if it is counter-clockwise."""
    x, y = (ring - ring[0]).T
    return float(x[:-1] @ y[1:] - x[1:] @ y[:-1]) / 2.0
