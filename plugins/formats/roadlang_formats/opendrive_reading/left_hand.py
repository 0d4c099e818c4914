"""Left-hand traffic as `emit opendrive` writes it, with a road for each direction: the two become
one road again, on which traffic keeps to the left."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from .records import (
    OTHER_END,
    Contact,
    Cubic,
    JunctionRecord,
    LaneRecord,
    MarkRecord,
    OpenDriveRecord,
    RoadLink,
    RoadRecord,
    SectionRecord,
)

LEFT_HAND_OF = "roadlang:left_hand_of"
"""The code of `userData` in a road; its value is the id of the road beside it, which runs the other
way."""
_AGAINST = {"+": "-", "-": "+"}


@dataclass(frozen=True)
class _Place:
    """The road of which a road is part now, its lanes there by their ids, and whether it ran
    against that road."""

    road: str
    lanes: Mapping[int, int]
    turned: bool


def with_left_hand(record: OpenDriveRecord) -> OpenDriveRecord:
    """The same map with one road for each such pair."""
    roads = record.roads
    pairs = {
        road.left_hand_of: id
        for id, road in roads.items()
        if road.left_hand_of in roads and _is_whole(road) and _is_whole(roads[road.left_hand_of])
    }
    places: dict[str, _Place] = {}
    for along, against in pairs.items():
        places[along] = _Place(along, _ids(_lanes(roads[along]), 1), turned=False)
        places[against] = _Place(along, _ids(_lanes(roads[against]), -1), turned=True)
    if len(places) < 2 * len(pairs) or not pairs:
        return record
    moved = {id: _relinked(road, places) for id, road in roads.items()}
    return replace(
        record,
        roads={
            id: _joined(road, moved[pairs[id]]) if id in pairs else road
            for id, road in moved.items()
            if id not in places or id in pairs
        },
        junctions={id: _reconnected(item, places) for id, item in record.junctions.items()},
    )


def _is_whole(road: RoadRecord) -> bool:
    return len(road.sections) == 1 and bool(_lanes(road))


def _lanes(road: RoadRecord) -> list[LaneRecord]:
    """Its lanes from left to right."""
    lanes = road.sections[0].lanes
    return [lanes[id] for id in sorted(lanes, reverse=True) if id]


def _ids(lanes: Sequence[LaneRecord], side: int) -> dict[int, int]:
    """New ids of lanes from left to right: the last is next to the center. `side`: 1 or -1."""
    return {lane.id: side * (len(lanes) - place) for place, lane in enumerate(lanes)}


def _relinked(road: RoadRecord, places: Mapping[str, _Place]) -> RoadRecord:
    """A road that leads to the roads, and their lanes, that are left."""
    before, after = road.predecessor, road.successor
    sections = list(road.sections)
    if before is not None and before.kind == "road" and before.id in places:
        sections[0] = _lanes_linked(sections[0], "start", places[before.id].lanes)
    if after is not None and after.kind == "road" and after.id in places:
        sections[-1] = _lanes_linked(sections[-1], "end", places[after.id].lanes)
    links = [
        RoadLink("road", at.road, OTHER_END[link.contact] if at.turned else link.contact)
        if link is not None and link.kind == "road" and (at := places.get(link.id)) is not None
        else link
        for link in (before, after)
    ]
    return replace(road, sections=tuple(sections), predecessor=links[0], successor=links[1])


def _lanes_linked(section: SectionRecord, end: Contact, ids: Mapping[int, int]) -> SectionRecord:
    lanes = {
        id: replace(lane, predecessor=ids.get(lane.predecessor or 0))
        if end == "start"
        else replace(lane, successor=ids.get(lane.successor or 0))
        for id, lane in section.lanes.items()
    }
    return replace(section, lanes=lanes)


def _reconnected(junction: JunctionRecord, places: Mapping[str, _Place]) -> JunctionRecord:
    connections = []
    for item in junction.connections:
        at = places.get(item.incoming)
        if at is not None:
            lanes = tuple((at.lanes[a], b) for a, b in item.lanes if a in at.lanes)
            item = replace(item, incoming=at.road, lanes=lanes)
        connections.append(item)
    return replace(junction, connections=tuple(connections))


def _joined(road: RoadRecord, back: RoadRecord) -> RoadRecord:
    """A road with the lanes of the one beside it, which runs the other way."""
    left, right = _lanes(road), _lanes(back)
    marks, marks_behind = _marks(road), _marks(back)
    ids, ids_behind = _ids(left, 1), _ids(right, -1)
    lanes = [replace(lane, id=ids[lane.id], marks=marks[place]) for place, lane in enumerate(left)]
    lanes += [
        replace(
            lane,
            id=ids_behind[lane.id],
            marks=marks_behind[place],
            widths=_backward(lane.widths, back.length),
            predecessor=lane.successor,
            successor=lane.predecessor,
        )
        for place, lane in enumerate(right)
    ]
    lanes.append(replace(left[-1], id=0, type="none", widths=(), marks=marks[-1]))
    signals = tuple(
        replace(
            signal,
            s=back.length - signal.s,
            orientation=_AGAINST.get(signal.orientation, signal.orientation),
        )
        for signal in back.signals
    )
    return replace(
        road,
        left_hand=True,
        predecessor=road.predecessor or back.successor,
        successor=road.successor or back.predecessor,
        lane_offset=_less(road.lane_offset, [lane.widths for lane in left if lane.id < 0]),
        sections=(replace(road.sections[0], lanes={lane.id: lane for lane in lanes}),),
        signals=(*road.signals, *signals),
    )


def _marks(road: RoadRecord) -> list[tuple[MarkRecord, ...]]:
    """The lines at the borders of lanes from left to right."""
    lanes = road.sections[0].lanes
    center = lanes[0].marks if 0 in lanes else ()
    left = [lane.marks for lane in _lanes(road) if lane.id > 0]
    return [*left, center, *(lane.marks for lane in _lanes(road) if lane.id < 0)]


def _backward(cubics: Sequence[Cubic], length: float) -> tuple[Cubic, ...]:
    """The same values along a road of this length that runs the other way."""
    stops = [*(cubic.start for cubic in cubics[1:]), length]
    found = []
    for cubic, stop in zip(cubics, stops, strict=True):
        end = _from(cubic, stop)
        found.append(Cubic(length - stop, end.a, -end.b, end.c, -end.d))
    return tuple(found[::-1])


def _less(total: Sequence[Cubic], parts: Sequence[Sequence[Cubic]]) -> tuple[Cubic, ...]:
    """A sum of cubics less others."""
    starts = sorted({cubic.start for cubics in (total, *parts) for cubic in cubics} | {0.0})
    found = []
    for start in starts:
        a, b, c, d = (
            getattr(_at(total, start), name)
            - sum(getattr(_at(part, start), name) for part in parts)
            for name in "abcd"
        )
        found.append(Cubic(start, a, b, c, d))
    return tuple(found)


def _at(cubics: Sequence[Cubic], start: float) -> Cubic:
    """That which holds from there on, counted from there."""
    begun = [cubic for cubic in cubics if cubic.start <= start] or list(cubics[:1])
    return _from(begun[-1], start) if begun else Cubic(start, 0.0, 0.0, 0.0, 0.0)


def _from(cubic: Cubic, start: float) -> Cubic:
    t = start - cubic.start
    return Cubic(
        start,
        cubic.a + t * (cubic.b + t * (cubic.c + t * cubic.d)),
        cubic.b + t * (2.0 * cubic.c + 3.0 * t * cubic.d),
        cubic.c + 3.0 * t * cubic.d,
        cubic.d,
    )
