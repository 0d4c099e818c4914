"""Roads without length, which editors leave behind: their neighbors are linked directly."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from .records import Contact, OpenDriveRecord, RoadLink, RoadRecord

_SHORTEST = 1e-4
"""Meters of a road and of all its pieces together."""
Lanes = Mapping[int, int]


def without_short_roads(record: OpenDriveRecord) -> OpenDriveRecord:
    """The roads that have a length, linked across those without. Roads within junctions stay, and
    so do those without length that have no link."""
    roads = dict(record.roads)
    for id, road in record.roads.items():
        if road.junction in record.junctions or not _is_short(road):
            continue
        ends = {"start": roads[id].predecessor, "end": roads[id].successor}
        if not any(ends.values()):
            continue
        road = roads.pop(id)
        before, after = (_lanes(road, end) for end in ("start", "end"))
        passed = {one: after[lane] for lane, one in before.items() if lane in after}
        _relink(roads, id, ends["start"], ends["end"], passed)
        _relink(roads, id, ends["end"], ends["start"], {b: a for a, b in passed.items()})
    return replace(record, roads=roads)


def _is_short(road: RoadRecord) -> bool:
    return max(road.length, sum(piece.length for piece in road.geometry)) < _SHORTEST


def _lanes(road: RoadRecord, end: Contact) -> Lanes:
    """What its lanes are linked to at an end, by their ids."""
    lanes = road.sections[0 if end == "start" else -1].lanes.values()
    linked = {lane.id: lane.predecessor if end == "start" else lane.successor for lane in lanes}
    return {id: other for id, other in linked.items() if other is not None}


def _relink(
    roads: dict[str, RoadRecord],
    gone: str,
    at: RoadLink | None,
    beyond: RoadLink | None,
    passed: Lanes,
) -> None:
    """Leads the end of the road `at` that led to the road `gone` to what lies `beyond` it."""
    road = roads.get(at.id) if at is not None and at.kind == "road" else None
    if at is None or road is None:
        return
    link = road.link(at.contact)
    if link is None or link.id != gone:
        return
    place = 0 if at.contact == "start" else -1
    name = "predecessor" if at.contact == "start" else "successor"
    section = road.sections[place]
    lanes = {
        id: replace(lane, **{name: passed.get(id)})  # type: ignore[arg-type]
        for id, lane in section.lanes.items()
    }
    sections = list(road.sections)
    sections[place] = replace(section, lanes=lanes)
    roads[at.id] = replace(road, **{name: beyond}, sections=tuple(sections))  # type: ignore[arg-type]
