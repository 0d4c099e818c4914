"""Lanes through the sections of a road: which lane of one section goes on as which of the next."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from .lane_kinds import direction, lane_type
from .records import LaneRecord, RoadRecord, SectionRecord


@dataclass(frozen=True)
class LaneTrack:
    """A lane of a road: `id` in the whole road, and its record in each section, None where it has
    no part there."""

    id: int
    records: tuple[LaneRecord | None, ...]

    @property
    def pattern(self) -> LaneRecord:
        """Its first record."""
        return next(record for record in self.records if record is not None)


def lane_tracks(road: RoadRecord) -> tuple[LaneTrack, ...]:
    """The lanes of a road from left to right.

    A lane goes on where the file links it to a lane of the same type; on either side the lanes
    keep their order.
    """
    sides = {sign: _side(road, sign) for sign in (1, -1)}
    found = [
        LaneTrack(sign * (place + 1), tuple(records))
        for sign, columns in sides.items()
        for place, records in enumerate(columns)
    ]
    return tuple(sorted(found, key=lambda track: -track.id))


def ids_in(tracks: Sequence[LaneTrack], section: int) -> Mapping[int, int]:
    """The ids of tracks by those of their lanes in a section (0 the first, -1 the last)."""
    return {
        record.id: track.id for track in tracks if (record := track.records[section]) is not None
    }


def _side(road: RoadRecord, sign: int) -> list[list[LaneRecord | None]]:
    """The columns of one side from the center outward, a record for each section."""
    columns: list[list[LaneRecord | None]] = []
    before: dict[int, list[LaneRecord | None]] = {}
    for number, section in enumerate(road.sections):
        ids = sorted((id for id in section.lanes if id * sign > 0), key=abs)
        place, now = -1, {}
        for id in ids:
            lane = section.lanes[id]
            column = _column_before(road, number, lane, before)
            at = next((at for at, other in enumerate(columns) if other is column), -1)
            if column is None or at <= place:
                column = [None] * number
                at = place + 1
                columns.insert(at, column)
            column.append(lane)
            place, now[id] = at, column
        for column in columns:
            if len(column) == number:
                column.append(None)
        before = now
    return columns


def _column_before(
    road: RoadRecord, number: int, lane: LaneRecord, before: Mapping[int, list[LaneRecord | None]]
) -> list[LaneRecord | None] | None:
    """The column of the lane of the section before that goes on in this one."""
    if not number:
        return None
    id = _linked_before(road.sections[number - 1], lane)
    column = before.get(id) if id is not None else None
    last = column[-1] if column is not None else None
    if last is None or column is None:
        return None
    same = _meaning(last, road) == _meaning(lane, road)
    return column if same else None


def _linked_before(section: SectionRecord, lane: LaneRecord) -> int | None:
    """The id of the lane before, by this one's link, by that one's, or, without links, its own."""
    if lane.predecessor is not None:
        return lane.predecessor
    linked = [other.id for other in section.lanes.values() if other.successor == lane.id]
    if linked:
        return linked[0] if len(linked) == 1 else None
    same = section.lanes.get(lane.id)
    return lane.id if same is not None and same.successor is None else None


def _meaning(lane: LaneRecord, road: RoadRecord) -> tuple[object, str]:
    type = lane_type(lane.type)
    return type, direction(type, lane.id, lane.direction, road.left_hand)
