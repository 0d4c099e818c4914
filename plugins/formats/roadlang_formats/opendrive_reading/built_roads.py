"""Roads of OpenDRIVE with their curves and lanes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from roadlang.geometry import CrossSection, Curve, Floats, GeometryError
from roadlang_formats.map_xml import MapFile

from .cubics import value_at
from .lane_tracks import LaneTrack, ids_in, lane_tracks
from .records import Contact, LaneRecord, RoadRecord
from .reference_lines import PlanViewCurve, reference_line
from .sections import cross_section

_SPACING = 1.0
_HEIGHT_SPACING = 2.0
_MOST_HEIGHTS = 4001
_FLAT = 1e-6
"""Meters; smaller heights count as zero."""


@dataclass(frozen=True, eq=False)
class BuiltRoad:
    """A road with its reference line, and its lanes through all sections."""

    record: RoadRecord
    line: PlanViewCurve
    tracks: tuple[LaneTrack, ...]
    section: CrossSection

    @classmethod
    def of(cls, file: MapFile, record: RoadRecord) -> BuiltRoad:
        """Raises RL479."""
        line = reference_line(file, record)
        tracks = lane_tracks(record)
        try:
            return cls(record, line, tracks, cross_section(file, record, tracks, line))
        except GeometryError as error:
            reason = f"the lanes of road `{record.id}` cannot be built: {error}"
            raise file.fault(record.element, reason) from None

    @property
    def curve(self) -> Curve:
        """That of the reference line."""
        return self.line.curve

    @cached_property
    def ids(self) -> Mapping[Contact, Mapping[int, int]]:
        """At either end, ids of lanes here by their ids in the file."""
        return {"start": ids_in(self.tracks, 0), "end": ids_in(self.tracks, -1)}

    def lanes_at(self, end: Contact) -> Mapping[int, LaneRecord]:
        """The lanes of the file at an end, by their ids there."""
        section = self.record.sections[0 if end == "start" else -1]
        return {id: lane for id, lane in section.lanes.items() if id}

    def point(self, end: Contact) -> tuple[float, float]:
        """Where the reference line begins or ends."""
        x, y = self.curve.at(0.0 if end == "start" else self.curve.length)
        return float(x), float(y)

    def elevations(self) -> Floats | None:
        """Heights at even arc lengths; None for a road at height 0 that is level."""
        profile = self.record.elevation
        count = min(int(self.curve.length / _HEIGHT_SPACING) + 2, _MOST_HEIGHTS)
        at = np.linspace(0.0, self.curve.length, count)
        heights = value_at(profile, np.interp(at, self.line.arc_lengths, self.line.s))
        return heights if np.abs(heights).max() > _FLAT else None

    def middle(self, lane: int, *, backward: bool) -> Curve | None:
        """The middle of a lane as a curve, against the road if `backward`; None for a point."""
        s = self.curve.stations(spacing=_SPACING)
        offset = self.section.offset(lane, s)
        slope = np.gradient(offset, s)
        points = self.curve.at(s) + offset[:, None] * self.curve.normal(s)
        ahead = 1.0 - offset * self.curve.curvature(s)
        headings = self.curve.heading(s) + np.arctan2(slope, ahead)
        if backward:
            points, headings = points[::-1], headings[::-1] + np.pi
        try:
            return Curve.hermite(points, headings)
        except GeometryError:
            return None
