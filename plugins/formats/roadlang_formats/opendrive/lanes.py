"""The lanes of a road: their kinds, widths, speed limits and markings."""

from __future__ import annotations

from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np

from roadlang.api import road_surface, surface_stretches

from .direct_links import End
from .elements import linear_pieces, put

if TYPE_CHECKING:
    from roadlang.api import SurfaceName
    from roadlang.geometry import Lane

    from .road_parts import OpenDriveRoad

_FLAT = 1e-3
"""Meters by which widths and offsets may be off."""
_TYPES = {
    "drive": "driving",
    "bus": "driving",
    "bike": "biking",
    "parking": "parking",
    "shoulder": "shoulder",
    "sidewalk": "sidewalk",
    "median": "median",
}
_ONLY = {"bus": "bus"}
"""Whom alone a kind of lane is for. A lane of the type `bus`, which OpenDRIVE 1.8 has
replaced by `access`, is none that netconvert and CARLA drive on."""
_MARKS = {
    "solid": "solid",
    "broken": "broken",
    "double": "solid solid",
    "none": "none",
    "curb": "curb",
}
_MARK_WIDTH = 0.12
_ENDS: tuple[End, ...] = ("start", "end")


def lane_type(lane: Lane) -> str:
    """What OpenDRIVE calls a kind of lane; one of a plugin goes by who drives or walks there."""
    if lane.drivable and lane.direction == "both":
        return "bidirectional"
    if lane.kind in _TYPES:
        return _TYPES[lane.kind]
    if lane.drivable:
        return "driving"
    return "sidewalk" if "pedestrian" in lane.users else "none"


def put_lanes(parent: Element, part: OpenDriveRoad, version: str) -> None:
    """The `lanes` of a road."""
    section, numbers = part.section, part.numbers
    s = part.arc_lengths.tolist()
    lanes = put(parent, "lanes")
    offsets = section.border_offsets(part.stations)[numbers.left]
    for start, value, slope in linear_pieces(s, offsets.tolist(), _FLAT):
        put(lanes, "laneOffset", s=start, a=value, b=slope, c=0.0, d=0.0)
    inside = put(lanes, "laneSection", s=0.0)
    marks = section.markings
    sides = {
        "left": range(numbers.left),
        "center": (),
        "right": range(numbers.left, len(section.lanes)),
    }
    for side, places in sides.items():
        if side == "center":
            center = put(put(inside, side), "lane", id=0, type="none", level="false")
            _put_mark(center, marks[numbers.left])
        elif places:
            group = put(inside, side)
            for place in places:
                lane = section.lanes[place]
                found = _put_lane(group, part, lane, version)
                widths = section.lane_width(lane.id, part.stations)
                widths = np.broadcast_to(widths, part.stations.shape).tolist()
                for start, value, slope in linear_pieces(s, widths, _FLAT):
                    put(found, "width", sOffset=start, a=value, b=slope, c=0.0, d=0.0)
                _put_mark(found, marks[place if side == "left" else place + 1])
                if not lane.raised:
                    _put_materials(found, part, place)
                if lane.speed_limit is not None:
                    put(found, "speed", sOffset=0.0, max=lane.speed_limit, unit="m/s")
                if lane.kind in _ONLY:
                    # netconvert does not know the elements that 1.8 has for the attribute.
                    put(found, "access", sOffset=0.0, rule="allow", restriction=_ONLY[lane.kind])


def _put_lane(group: Element, part: OpenDriveRoad, lane: Lane, version: str) -> Element:
    id = part.numbers.ids[lane.id]
    found = put(group, "lane", id=id, type=lane_type(lane), level="false")
    if version == "1.8" and lane.id in part.numbers.contrary:
        found.set("direction", "reversed")
    before, after = (part.links[end].lanes.get(id) if end in part.links else None for end in _ENDS)
    if before is not None or after is not None:
        link = put(found, "link")
        if before is not None:
            put(link, "predecessor", id=before)
        if after is not None:
            put(link, "successor", id=after)
    return found


def _put_materials(found: Element, part: OpenDriveRoad, place: int) -> None:
    """What a lane is made of, where its road says anything of it."""
    said = part.road.surface is not None or part.road.surface_patches
    stretches = surface_stretches(part.road, part.section.ids) if said else ()
    low, high = float(part.stations[0]), float(part.stations[-1])
    before = None
    for stretch in stretches:
        surface = stretch.surfaces[place]
        if stretch.end <= low or stretch.start >= high or surface == before:
            continue
        start = float(part.line.at(np.array([max(stretch.start, low)]))[0])
        put_material(found, start if before or start > 0.0 else 0.0, surface or "asphalt")
        before = surface


def put_material(lane: Element, start: float, surface: SurfaceName) -> None:
    """From where on a lane is of a surface; its friction is that without any weather."""
    friction = road_surface({}, surface).friction
    put(lane, "material", sOffset=start, surface=surface, friction=friction, roughness=0.0)


def _put_mark(lane: Element, marking: str) -> None:
    mark = put(lane, "roadMark", sOffset=0.0, type=_MARKS[marking], weight="standard")
    mark.set("color", "standard")
    mark.set("width", f"{_MARK_WIDTH if marking != 'none' else 0.0:g}")
    mark.set("laneChange", "none" if marking in ("solid", "double", "curb") else "both")
