"""Roads without length, which editors leave behind: their neighbors are linked directly."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any, TypeVar

from .records import (
    OTHER_END,
    ConnectionRecord,
    Contact,
    JunctionRecord,
    LaneRecord,
    OpenDriveRecord,
    RoadLink,
    RoadRecord,
)

Linked = TypeVar("Linked", RoadRecord, LaneRecord)

_SHORTEST = 1e-4
"""Meters of a road and of all its pieces together."""
_NAMES: Mapping[Contact, str] = {"start": "predecessor", "end": "successor"}
_SECTIONS: Mapping[Contact, int] = {"start": 0, "end": -1}


def without_short_roads(record: OpenDriveRecord) -> OpenDriveRecord:
    """The roads that have a length, linked across those without, also to junctions. Roads within
    junctions stay, and so do those without length that have no link."""
    roads, junctions = dict(record.roads), dict(record.junctions)
    for id in record.roads:
        gone = roads[id]
        if gone.junction in junctions or not _is_short(gone) or not _is_linked(gone):
            continue
        del roads[id]
        roads = {other: _relinked(road, gone) for other, road in roads.items()}
        junctions = {
            other: replace(junction, connections=tuple(_reconnected(junction, gone)))
            for other, junction in junctions.items()
        }
    return replace(record, roads=roads, junctions=junctions)


def _is_short(road: RoadRecord) -> bool:
    return max(road.length, sum(piece.length for piece in road.geometry)) < _SHORTEST


def _is_linked(road: RoadRecord) -> bool:
    return road.predecessor is not None or road.successor is not None


def _lanes(road: RoadRecord, end: Contact) -> dict[int, int]:
    """What its lanes are linked to at an end, by their ids."""
    lanes = road.sections[_SECTIONS[end]].lanes.values()
    linked = {lane.id: getattr(lane, _NAMES[end]) for lane in lanes}
    return {id: other for id, other in linked.items() if other is not None}


def _relinked(road: RoadRecord, gone: RoadRecord) -> RoadRecord:
    """A road that leads to what lies behind one that is gone, if it led to that."""
    for end in _NAMES:
        link = road.link(end)
        if link is None or link.kind != "road" or link.id != gone.id:
            continue
        back = gone.link(link.contact)
        entered = _lanes(road, end)
        if back is not None and (back.kind, back.id, back.contact) == ("road", road.id, end):
            entered |= {other: id for id, other in _lanes(gone, link.contact).items()}
        behind = _lanes(gone, OTHER_END[link.contact])
        sections = list(road.sections)
        section = sections[_SECTIONS[end]]
        lanes = {
            id: _with_link(lane, end, behind.get(entered.get(id, 0)))
            for id, lane in section.lanes.items()
        }
        sections[_SECTIONS[end]] = replace(section, lanes=lanes)
        beyond = gone.link(OTHER_END[link.contact])
        road = _with_link(replace(road, sections=tuple(sections)), end, beyond)
    return road


def _with_link(part: Linked, end: Contact, to: Any) -> Linked:
    """A road or lane that leads elsewhere at one of its ends."""
    return replace(part, **{_NAMES[end]: to})


def _reconnected(junction: JunctionRecord, gone: RoadRecord) -> Iterator[ConnectionRecord]:
    """The connections of a junction, those of a road that is gone from the road behind it; where
    there is none, they lead nowhere."""
    for item in junction.connections:
        if item.incoming == gone.id:
            ends = [end for end in _NAMES if _leads_to(gone.link(end), junction)]
            beyond = gone.link(OTHER_END[ends[0]]) if ends else None
            if beyond is not None and beyond.kind == "road":
                behind = _lanes(gone, OTHER_END[ends[0]])
                lanes = tuple((behind[a], b) for a, b in item.lanes if a in behind)
                yield replace(item, incoming=beyond.id, lanes=lanes)
        elif item.connecting == gone.id:
            beyond = gone.link(OTHER_END[item.contact])
            if beyond is not None and beyond.kind == "road":
                behind = _lanes(gone, OTHER_END[item.contact])
                lanes = tuple((a, behind[b]) for a, b in item.lanes if b in behind)
                at = beyond.contact
                yield replace(item, connecting=beyond.id, contact=at, lanes=lanes)
        else:
            yield item


def _leads_to(link: RoadLink | None, junction: JunctionRecord) -> bool:
    return link is not None and link.kind == "junction" and link.id == junction.id
