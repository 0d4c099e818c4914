"""Two roads on the same ground that `emit opendrive` makes of one whose lane is for both
directions: they become that road again."""

from __future__ import annotations

from dataclasses import replace

from .records import (
    OTHER_END,
    ConnectionRecord,
    OpenDriveRecord,
    RoadLink,
    RoadRecord,
)

REVERSE_OF = "roadlang:reverse_of"
"""The code of `userData` in a road; its value is the id of the road that it runs against."""


def with_both_ways(record: OpenDriveRecord) -> OpenDriveRecord:
    """The same map without the second road of such pairs."""
    partners = {id: road.reverse_of for id, road in record.roads.items() if road.reverse_of}
    partners = {id: other for id, other in partners.items() if other in record.roads}
    if not partners:
        return record
    shared = set(partners.values()) - partners.keys()
    partners = {id: other for id, other in partners.items() if other in shared}
    back = {other: record.roads[id] for id, other in partners.items()}
    roads = {
        id: _shared(_relinked(road, partners), back[id])
        if id in back
        else _relinked(road, partners)
        for id, road in record.roads.items()
        if id not in partners
    }
    junctions = {
        id: replace(
            junction,
            connections=tuple(_incoming(item, partners) for item in junction.connections),
        )
        for id, junction in record.junctions.items()
    }
    return replace(record, roads=roads, junctions=junctions)


def _relinked(road: RoadRecord, partners: dict[str, str]) -> RoadRecord:
    return replace(
        road,
        predecessor=_link(road.predecessor, partners),
        successor=_link(road.successor, partners),
    )


def _link(link: RoadLink | None, partners: dict[str, str]) -> RoadLink | None:
    if link is None or link.id not in partners or link.kind != "road":
        return link
    return RoadLink("road", partners[link.id], OTHER_END[link.contact])


def _incoming(item: ConnectionRecord, partners: dict[str, str]) -> ConnectionRecord:
    return replace(item, incoming=partners.get(item.incoming, item.incoming))


def _shared(road: RoadRecord, back: RoadRecord) -> RoadRecord:
    """Its lane for vehicles is for both directions, and it has the signals of both roads."""
    opposite = {"+": "-", "-": "+"}
    signals = tuple(
        replace(
            signal,
            s=back.length - signal.s,
            orientation=opposite.get(signal.orientation, signal.orientation),
        )
        for signal in back.signals
    )
    sections = tuple(
        replace(
            section,
            lanes={
                id: replace(lane, direction="both") if lane.type in ("driving", "bus") else lane
                for id, lane in section.lanes.items()
            },
        )
        for section in road.sections
    )
    return replace(road, sections=sections, signals=(*road.signals, *signals))
