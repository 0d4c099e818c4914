"""The elements of an OpenDRIVE file as records. Raises RL479 at whatever cannot be right."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import Any, Literal

from roadlang_formats.map_xml import MapElement, MapFile

from .both_ways import REVERSE_OF, with_both_ways
from .cubics import cubics
from .lane_records import section_record
from .left_hand import LEFT_HAND_OF, with_left_hand
from .records import (
    ConnectionRecord,
    Contact,
    GeometryRecord,
    JunctionRecord,
    OpenDriveRecord,
    RoadLink,
    RoadRecord,
    Shape,
    SignalRecord,
)
from .short_roads import without_short_roads
from .speeds import speed_of

_PLAIN_PROJECTIONS = ("tmerc", "aeqd", "stere", "sterea", "laea", "ortho", "gnom")
"""Those whose (0, 0) is at `+lat_0`, `+lon_0`."""
_ORDER = ("line", "arc", "spiral", "poly3", "paramPoly3")
_LINKED: Mapping[str, Literal["road", "junction"]] = {"road": "road", "junction": "junction"}
_NUMBERS: Mapping[Shape, tuple[str, ...]] = {
    "line": (),
    "arc": ("curvature",),
    "spiral": ("curvStart", "curvEnd"),
    "poly3": ("a", "b", "c", "d"),
    "paramPoly3": ("aU", "bU", "cU", "dU", "aV", "bV", "cV", "dV"),
}
VENDOR = "roadlang"
"""Who wrote a file, in its header."""
_OWN_NAME = re.compile(r"[A-Za-z_]\w*/\d+")
_LARGEST_CURVATURE = 100.0
"""1/m"""
_LONGEST = 1e6
"""Meters of a road, and of a piece."""


def parsed_map(file: MapFile) -> OpenDriveRecord:
    """Everything that is read from a file."""
    roads: dict[str, RoadRecord] = {}
    for element in file.root.all("road"):
        road = _road(file, element)
        if road.id in roads:
            raise file.fault(element, f"two roads have the id `{road.id}`")
        roads[road.id] = road
    if not roads:
        raise file.fault(file.root, "it has no road")
    junctions: dict[str, JunctionRecord] = {}
    for element in file.root.all("junction"):
        junction = _junction(file, element)
        if junction.id in junctions:
            raise file.fault(element, f"two junctions have the id `{junction.id}`")
        junctions[junction.id] = junction
    record = without_short_roads(OpenDriveRecord(roads, junctions, _origin(file)))
    return with_left_hand(with_both_ways(record))


def _origin(file: MapFile) -> tuple[float, float] | None:
    element = file.root.first("header", "geoReference")
    if element is None:
        return None
    words = dict(re.findall(r"\+(\w+)=(\S+)", element.text))
    shifted = any(words.get(name, "0").strip("0.-") for name in ("x_0", "y_0"))
    if shifted or words.get("proj", "tmerc") not in _PLAIN_PROJECTIONS:
        return None
    try:
        latitude, longitude = float(words["lat_0"]), float(words["lon_0"])
    except (KeyError, ValueError):
        return None
    inside = abs(latitude) <= 90.0 and abs(longitude) <= 180.0
    return (latitude, longitude) if inside else None


def _street(file: MapFile, element: MapElement) -> str:
    """The name of a road. `emit opendrive` calls those without one `town/5`."""
    name = element.attributes.get("name", "")
    header = file.root.first("header")
    is_ours = header is not None and header.attributes.get("vendor") == VENDOR
    return "" if is_ours and _OWN_NAME.fullmatch(name) else name


def _road(file: MapFile, element: MapElement) -> RoadRecord:
    id = file.attribute(element, "id")
    junction = file.attribute(element, "junction", "-1")
    geometry = tuple(_geometry(file, child) for child in element.all("planView", "geometry"))
    if not geometry:
        raise file.fault(element, f"road `{id}` has no `geometry` in its `planView`")
    length = file.number(element, "length")
    if not 0.0 < length <= _LONGEST:
        raise file.fault(element, f"road `{id}` has the length {length:g}")
    sections = _increasing(
        file, (section_record(file, child) for child in element.all("lanes", "laneSection"))
    )
    if not any(lane for section in sections for lane in section.lanes):
        raise file.fault(element, f"road `{id}` has no lane")
    kinds = [child for child in element.all("type") if child.first("speed") is not None]
    limit = speed_of(file, kinds[0].first("speed")) if kinds else None
    return RoadRecord(
        element,
        id,
        _street(file, element),
        length,
        "" if junction == "-1" else junction,
        element.attributes.get("rule", "RHT") == "LHT",
        _link(file, element.first("link", "predecessor"), "end"),
        _link(file, element.first("link", "successor"), "start"),
        _increasing(file, geometry),
        cubics(file, element.all("elevationProfile", "elevation"), "s"),
        cubics(file, element.all("lanes", "laneOffset"), "s"),
        sections,
        limit,
        _signals(file, element),
        _user_data(element, REVERSE_OF),
        _user_data(element, LEFT_HAND_OF),
    )


def _signals(file: MapFile, element: MapElement) -> tuple[SignalRecord, ...]:
    return tuple(
        SignalRecord(
            file.attribute(child, "id"),
            file.number(child, "s"),
            child.attributes.get("type", ""),
            child.attributes.get("dynamic", "no") == "yes",
            child.attributes.get("orientation", "none"),
        )
        for tag in ("signal", "signalReference")
        for child in element.all("signals", tag)
    )


def _user_data(element: MapElement, code: str) -> str:
    """What `emit opendrive` says of a road that is one of two."""
    marks = [
        child.attributes.get("value", "")
        for child in element.all("userData")
        if child.attributes.get("code") == code
    ]
    return marks[0] if marks else ""


def _increasing(file: MapFile, records: Iterable[Any]) -> tuple[Any, ...]:
    """Records by their `s`, in which they must be written."""
    found = tuple(records)
    for before, record in pairwise(found):
        if record.s < before.s:
            tag = record.element.tag
            raise file.fault(record.element, f"this `{tag}` begins before the one above it")
    return found


def _geometry(file: MapFile, element: MapElement) -> GeometryRecord:
    shapes = [(kind, child) for child in element.children for kind in _NUMBERS if child.tag == kind]
    if len(shapes) != 1:
        known = ", ".join(_ORDER)
        raise file.fault(
            element, f"a `geometry` must have exactly one of {known}; this has {len(shapes)}"
        )
    kind, shape = shapes[0]
    length = file.number(element, "length")
    if not 0.0 <= length <= _LONGEST:
        raise file.fault(element, f"a `geometry` of length {length:g}")
    numbers = tuple(file.number(shape, name) for name in _NUMBERS[kind])
    if kind in ("arc", "spiral") and max(map(abs, numbers)) > _LARGEST_CURVATURE:
        raise file.fault(shape, f"a curvature of more than {_LARGEST_CURVATURE:g} 1/m")
    return GeometryRecord(
        element,
        kind,
        file.number(element, "s"),
        file.number(element, "x"),
        file.number(element, "y"),
        math.remainder(file.number(element, "hdg"), 2.0 * math.pi),
        length,
        numbers,
        # "arcLength" is the exception; "normalized" is the default in version 1.4.
        shape.attributes.get("pRange", "normalized") != "arcLength",
    )


def _link(file: MapFile, element: MapElement | None, default: Contact) -> RoadLink | None:
    if element is None or "elementId" not in element.attributes:
        return None
    written = element.attributes.get("elementType", "road")
    kind = _LINKED.get(written)
    if kind is None:
        raise file.fault(element, f"`elementType` must be road or junction, not `{written}`")
    contact = _contact(file, element, element.attributes.get("contactPoint", default))
    return RoadLink(kind, element.attributes["elementId"], contact)


def _contact(file: MapFile, element: MapElement, written: str) -> Contact:
    if written == "start":
        return "start"
    if written == "end":
        return "end"
    raise file.fault(element, f"`contactPoint` must be start or end, not `{written}`")


def _junction(file: MapFile, element: MapElement) -> JunctionRecord:
    id = file.attribute(element, "id")
    connections = []
    is_virtual = element.attributes.get("type") == "virtual"
    for child in () if is_virtual else element.all("connection"):
        # At railway crossings there are connections without an incoming road.
        if "incomingRoad" not in child.attributes:
            continue
        direct = "connectingRoad" not in child.attributes
        name = "linkedRoad" if direct else "connectingRoad"
        contact = _contact(file, child, child.attributes.get("contactPoint", "start"))
        lanes = tuple(
            (file.integer(link, "from"), file.integer(link, "to")) for link in child.all("laneLink")
        )
        connections.append(
            ConnectionRecord(
                child,
                file.attribute(child, "incomingRoad"),
                file.attribute(child, name),
                contact,
                lanes,
                direct,
            )
        )
    return JunctionRecord(element, id, element.attributes.get("name", ""), tuple(connections))
