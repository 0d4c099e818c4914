"""A scene as the text of an OpenDRIVE file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal
from xml.etree.ElementTree import Element, indent, tostring

import numpy as np

from roadlang_formats.opendrive_reading.both_ways import REVERSE_OF
from roadlang_formats.opendrive_reading.left_hand import LEFT_HAND_OF
from roadlang_formats.opendrive_reading.parsing import VENDOR
from roadlang_formats.place_on_earth import map_origin

from ..file_date import DATE
from .connecting_roads import ConnectingRoad, put_connecting_road
from .direct_links import End
from .elements import linear_pieces, put
from .junctions import end_roads, numbered_junctions, put_junction
from .lanes import put_lanes
from .objects import objects_by_part, put_objects
from .reference import put_elevation, put_plan_view
from .road_parts import LeftHand, OpenDriveRoad, road_parts
from .signals import put_controllers, put_signals, signals

if TYPE_CHECKING:
    from roadlang.api import Scene

_LEVEL = 1e-3
"""Meters by which heights may be off."""


def document(
    scene: Scene, version: str, tolerance: float, geo_reference: str, left_hand: LeftHand
) -> str:
    """The file of a scene. Roads keep to their curves within `tolerance` (meters)."""
    on_left = scene.world.get("traffic") == "left"
    rule = turn_rule(scene, left_hand)
    parts = road_parts(scene, tolerance, left_hand)
    junctions = numbered_junctions(scene, parts, rule)
    lights = signals(junctions)
    ends = end_roads(junctions)
    things = objects_by_part(scene.standing, [part for part in parts if part.reverse_of is None])
    root = Element("OpenDRIVE")
    _put_header(root, scene, parts, version, geo_reference)
    for part in parts:
        road = put(root, "road", name=_name(part), length=part.line.length, id=part.id, junction=-1)
        road.set("rule", part.rule)
        _put_links(road, part, ends)
        _put_types(road, part)
        put_plan_view(road, part.line.pieces)
        put_elevation(road, _heights(part))
        put_lanes(road, part, version)
        put_objects(road, part, things.get(part.id, ()))
        put_signals(road, part, lights, on_left)
        if part.reverse_of is not None:
            code = REVERSE_OF if part.shares_lane else LEFT_HAND_OF
            put(road, "userData", code=code, value=part.reverse_of)
    for junction in junctions:
        for connecting in junction.roads:
            put_connecting_road(root, connecting, rule, _speed(connecting))
    controllers = put_controllers(root, lights)
    for junction in junctions:
        put_junction(root, junction, controllers.get(junction.id, ()))
    indent(root, " ")
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, encoding="unicode") + "\n"


def turn_rule(scene: Scene, left_hand: LeftHand) -> Literal["RHT", "LHT"]:
    """That of the roads through junctions."""
    return "LHT" if scene.world.get("traffic") == "left" and left_hand == "rule" else "RHT"


def _put_header(
    root: Element, scene: Scene, parts: tuple[OpenDriveRoad, ...], version: str, geo_reference: str
) -> None:
    major, _, minor = version.partition(".")
    poses = [part.pose(part.stations) for part in parts]
    x, y = (np.concatenate([pose[:, axis] for pose in poses]) for axis in (0, 1))
    header = put(
        root,
        "header",
        revMajor=int(major),
        revMinor=int(minor),
        name=scene.title or scene.name,
        version="1",
        date=f"{DATE}T00:00:00",
        north=float(y.max()),
        south=float(y.min()),
        east=float(x.max()),
        west=float(x.min()),
        vendor=VENDOR,
    )
    reference = geo_reference or _place(scene)
    if reference:
        put(header, "geoReference").text = reference


def _place(scene: Scene) -> str:
    """The projection of the map that the scene was made from, where it says where (0, 0) is."""
    origin = map_origin(scene)
    if origin is None:
        return ""
    at = f"+lat_0={origin[0]!r} +lon_0={origin[1]!r}"
    return f"+proj=tmerc {at} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs"


def _name(part: OpenDriveRoad) -> str:
    return part.road.street or part.road.name


def _put_links(road: Element, part: OpenDriveRoad, ends: dict[tuple[str, str], int]) -> None:
    link = put(road, "link")
    names: tuple[tuple[End, End, str], ...]
    names = ("start", "end", "predecessor"), ("end", "start", "successor")
    for end, opposite, tag in names:
        junction = ends.get((part.road.name, end if part.reverse_of is None else opposite))
        other = part.links.get(end)
        if other is not None:
            put(link, tag, elementType="road", elementId=other.id, contactPoint=other.end)
        elif junction is not None:
            put(link, tag, elementType="junction", elementId=junction)


def _put_types(road: Element, part: OpenDriveRoad) -> None:
    """The speed limit of the road, zone by zone."""
    first, last = part.stations[0], part.stations[-1]
    for zone, after in zip(part.road.zones(), (*part.road.zones()[1:], None), strict=True):
        if zone.start >= last or (after is not None and after.start <= first):
            continue
        s = float(part.line.at(np.array([max(zone.start, first)]))[0])
        kind = put(road, "type", s=s, type="town")
        if zone.speed_limit is not None:
            put(kind, "speed", max=zone.speed_limit, unit="m/s")


def _heights(part: OpenDriveRoad) -> list[tuple[float, ...]]:
    heights = part.road.elevation
    if not heights:
        return [(0.0, 0.0, 0.0)]
    period = part.road.length if part.road.closed else None
    at = np.interp(part.stations, part.road.stations, heights, period=period)
    return linear_pieces(part.arc_lengths.tolist(), at.tolist(), _LEVEL)


def _speed(connecting: ConnectingRoad) -> float:
    """The limit of the lane that it leads to at the end where it joins, infinite without one."""
    part, end = connecting.target.part, connecting.target.end
    own = next(
        lane.speed_limit
        for lane in part.section.lanes
        if part.numbers.ids[lane.id] == connecting.target.lane
    )
    limit = part.road.limit_at(0.0 if end == "start" else part.road.length, own)
    return np.inf if limit is None else limit
