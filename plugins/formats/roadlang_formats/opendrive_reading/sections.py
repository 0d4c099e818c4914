"""The cross-section of a road of OpenDRIVE: all its lanes, without width where they are not."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roadlang.geometry import CrossSection, Floats, Lane, OffsetProfile, WidthProfile
from roadlang_formats.map_xml import MapFile

from .cubics import knots, value_at
from .lane_kinds import direction, lane_type, marking
from .lane_tracks import LaneTrack
from .records import LaneRecord, MarkRecord, RoadRecord
from .reference_lines import PlanViewCurve

_TOLERANCE = 0.002
"""Meters by which widths and offsets may be off between stations."""
_SEAM = 1e-6
"""Meters before the end of a section at which its lanes still have their widths."""
_NARROWEST = 0.01
"""Meters of a road where its lanes begin at nothing."""


def cross_section(
    file: MapFile, road: RoadRecord, tracks: Sequence[LaneTrack], line: PlanViewCurve
) -> CrossSection:
    """The lanes along the curve of the reference line. Raises RL479 if the road is too short."""
    parts = [_stations(road, number) for number in range(len(road.sections))]
    columns: dict[int, list[Floats]] = {track.id: [] for track in tracks}
    used: list[int] = [number for number, s in enumerate(parts) if len(s)]
    if not used:
        raise file.fault(road.element, f"road `{road.id}` is too short: {road.length:g} m")
    for number in used:
        widths = _widths(road, number, parts[number])
        for track in tracks:
            record = track.records[number]
            none = np.zeros(len(parts[number]))
            columns[track.id].append(none if record is None else widths[record.id])
    s = np.concatenate([parts[number] for number in used])
    at = line.along(s)
    keep = np.append(np.diff(at) > 1e-7, True)
    found = {id: np.concatenate(column)[keep] for id, column in columns.items()}
    _widen(found, tracks)
    lanes = [_lane(road, track, WidthProfile(at[keep], found[track.id])) for track in tracks]
    offsets = value_at(road.lane_offset, s)[keep]
    center = [section.lanes.get(0) for section in road.sections]
    marks = [mark for lane in center if lane is not None for mark in lane.marks[:1]]
    return CrossSection(
        tuple(lanes),
        marking(marks[0].type) if marks else "none",
        OffsetProfile(at[keep], offsets),
    )


def _stations(road: RoadRecord, number: int) -> Floats:
    """`s` between which the widths of a section, and the lane offset, are linear."""
    start = max(road.sections[number].s, 0.0) if number else 0.0
    is_last = number + 1 == len(road.sections)
    stop = road.length if is_last else min(road.sections[number + 1].s, road.length)
    if stop - start <= 2.0 * _SEAM:
        return np.zeros(0)
    found = [0.0, stop - start]
    for lane in road.sections[number].lanes.values():
        found += knots(lane.widths or lane.borders, stop - start, _TOLERANCE)
    found += [s - start for s in knots(road.lane_offset, road.length, _TOLERANCE)]
    inside = np.unique(np.array([s for s in found if 0.0 <= s <= stop - start]))
    # Where a cubic begins with a step, the one before it still counts just before.
    before = inside[1:-1] - _SEAM
    inside = np.unique(np.concatenate((inside, before[before > 0.0])))
    if not is_last:
        inside[-1] -= _SEAM
    return np.asarray(start + inside[np.append(np.diff(inside) > 0.0, True)])


def _widths(road: RoadRecord, number: int, s: Floats) -> dict[int, Floats]:
    """By id, the widths (n,) of the lanes of a section at `s` (n,)."""
    section = road.sections[number]
    found: dict[int, Floats] = {}
    for sign in (1, -1):
        inner = np.zeros(len(s))
        for id in sorted((id for id in section.lanes if id * sign > 0), key=abs):
            lane = section.lanes[id]
            if lane.widths:
                width = value_at(lane.widths, s - section.s)
            else:
                border = sign * value_at(lane.borders, s - section.s)
                width = border - inner if lane.borders else inner * 0.0
            # In real maps, widths may drop slightly below zero where lanes end.
            found[id] = np.maximum(width, 0.0)
            inner = inner + found[id]
    return found


def _widen(widths: dict[int, Floats], tracks: Sequence[LaneTrack]) -> None:
    """Gives a road a width where its lanes have none, because every road of a network needs one."""
    driven = [track.id for track in tracks if lane_type(track.pattern.type).drivable]
    ids = driven or [track.id for track in tracks]
    total = np.sum([widths[id] for id in ids], axis=0)
    missing = np.maximum(_NARROWEST - total, 0.0)
    widest = max(ids, key=lambda id: (float(widths[id].sum()), id))
    widths[widest] = widths[widest] + missing
    for id, width in widths.items():
        if not width.any():  # a lane that the file gives no width anywhere
            widths[id] = width + 1e-6


def _lane(road: RoadRecord, track: LaneTrack, width: WidthProfile) -> Lane:
    record = track.pattern
    type = lane_type(record.type)
    speeds = [lane.speed for lane in track.records if lane is not None and lane.speed is not None]
    limit = min(speeds) if speeds else road.speed if type.drivable else None
    return Lane(
        track.id,
        type.kind,
        width,
        direction(type, record.id, record.direction, road.left_hand),
        type.drivable,
        limit,
        marking(_usual_mark(road, track)),
        type.users,
        type.raised,
    )


def _usual_mark(road: RoadRecord, track: LaneTrack) -> str:
    """The type of line that goes on for longest."""
    lengths: dict[str, float] = {}
    ends = [*(section.s for section in road.sections[1:]), road.length]
    for section, stop, lane in zip(road.sections, ends, track.records, strict=True):
        for type, length in _marks(lane, stop - section.s):
            lengths[type] = lengths.get(type, 0.0) + length
    return max(lengths, key=lambda type: lengths[type], default="none")


def _marks(lane: LaneRecord | None, length: float) -> list[tuple[str, float]]:
    if lane is None:
        return []
    after = [*lane.marks[1:], MarkRecord(length, "")]
    marks = zip(lane.marks, after, strict=False)
    return [(mark.type, max(following.start - mark.start, 0.0)) for mark, following in marks]
