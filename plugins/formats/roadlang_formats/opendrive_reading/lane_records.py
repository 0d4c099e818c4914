"""The lanes of OpenDRIVE files as records."""

from __future__ import annotations

from roadlang_formats.map_xml import MapElement, MapFile

from .cubics import cubics
from .records import LaneRecord, MarkRecord, SectionRecord
from .speeds import speed_of

_MOST_LANES = 100
_PUBLIC = {"bus", "taxi"}
"""Whom alone bus lanes are for."""


def section_record(file: MapFile, element: MapElement) -> SectionRecord:
    """A lane section. The ids of each side must run from the center outward without a gap."""
    lanes: dict[int, LaneRecord] = {}
    for side in ("left", "center", "right"):
        for child in element.all(side, "lane"):
            lane = _lane(file, child)
            if lane.id in lanes:
                raise file.fault(child, f"two lanes of a section have the id {lane.id}")
            lanes[lane.id] = lane
    if len(lanes) > _MOST_LANES:
        raise file.fault(element, f"a lane section has {len(lanes)} lanes")
    for lane in lanes.values():
        inner = lane.id - 1 if lane.id > 0 else lane.id + 1
        if lane.id and inner and inner not in lanes:
            raise file.fault(lane.element, f"there is a lane {lane.id}, but no lane {inner}")
    return SectionRecord(element, file.number(element, "s"), lanes)


def _lane(file: MapFile, element: MapElement) -> LaneRecord:
    id = file.integer(element, "id")
    widths = cubics(file, element.all("width"), "sOffset")
    speeds = [speed_of(file, child) for child in element.all("speed")]
    return LaneRecord(
        element,
        id,
        _type(file, element),
        element.attributes.get("direction", "standard"),
        widths,
        () if widths else cubics(file, element.all("border"), "sOffset"),
        tuple(
            MarkRecord(file.number(mark, "sOffset", 0.0), mark.attributes.get("type", "none"))
            for mark in element.all("roadMark")
        ),
        next((speed for speed in speeds if speed is not None), None),
        _linked(file, element.first("link", "predecessor")),
        _linked(file, element.first("link", "successor")),
    )


def _type(file: MapFile, element: MapElement) -> str:
    """The type of a lane. One for driving that only buses and taxis may use is a bus lane."""
    written = file.attribute(element, "type", "none")
    allowed: set[str] = set()
    for access in element.all("access"):
        if access.attributes.get("rule", "allow") == "allow":
            found = [access.attributes.get("restriction")]
            found += [each.attributes.get("type") for each in access.all("restriction")]
            allowed.update(name for name in found if name)
    return "bus" if written == "driving" and allowed and allowed <= _PUBLIC else written


def _linked(file: MapFile, element: MapElement | None) -> int | None:
    return None if element is None else file.integer(element, "id")
