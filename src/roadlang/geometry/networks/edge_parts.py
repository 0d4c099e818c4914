"""Stretches of the roads of a network, with their lanes, widths and heights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..arrays import Floats
from ..curves.profile import OffsetProfile
from ..curves.width import WidthProfile
from ..lanes.cross_section import CrossSection
from .junction_model import End
from .network import Edge


@dataclass(frozen=True, eq=False)
class EdgePart:
    """An edge from arc length `start` to `stop`, meters; of a closed one `stop` may lie beyond its
    seam."""

    edge: Edge
    start: float
    stop: float

    @property
    def length(self) -> float:
        """Meters of the edge."""
        return self.stop - self.start

    @property
    def is_whole(self) -> bool:
        """Whether it is all of the edge."""
        return self.length >= self.edge.length

    @property
    def ends(self) -> tuple[End, ...]:
        """The ends of the edge that are its ends too: none of a closed edge that was cut."""
        if self.edge.curve.closed and not self.is_whole:
            return ()
        start: tuple[End, ...] = ("start",) if self.start <= 0.0 else ()
        return (*start, "end") if self.stop >= self.edge.length else start

    @cached_property
    def lane_ids(self) -> Mapping[int, int]:
        """The ids that the lanes of the edge have here: lanes without any width are left out."""
        section = self.edge.cross_section
        if section is None:
            return {}
        wide = [lane.id for lane in section.lanes if self._widths(lane.width)[1].any()]
        left, right = (id for id in reversed(wide) if id > 0), (id for id in wide if id < 0)
        renamed = {id: place for place, id in enumerate(left, start=1)}
        return renamed | {id: -place for place, id in enumerate(right, start=1)}

    def cut(self) -> Edge:
        """As an edge whose ids are still those of the whole."""
        edge = self.edge
        if self.is_whole:
            return edge
        curve = edge.curve.between(self.start, self.stop)
        widths = edge.width.at(np.linspace(self.start, self.stop, max(len(edge.widths), 2)))
        return replace(
            edge,
            curve=curve,
            widths=widths,
            cross_section=self._section(curve.length / self.length),
            elevations=self._heights(),
        )

    def _section(self, scale: float) -> CrossSection | None:
        section = self.edge.cross_section
        if section is None:
            return None
        lanes = []
        for lane in section.lanes:
            if lane.id in self.lane_ids:
                s, widths = self._widths(lane.width)
                width = WidthProfile(s * scale, widths)
                lanes.append(replace(lane, id=self.lane_ids[lane.id], width=width))
        offset = section.center_offset
        if offset is not None:
            s, at = self._stations(offset.stations, offset.period)
            offset = OffsetProfile(s * scale, offset.at(at))
        return CrossSection(tuple(lanes), section.center_marking, offset)

    def _widths(self, profile: WidthProfile) -> tuple[Floats, Floats]:
        s, at = self._stations(profile.stations, profile.period)
        return s, profile.at(at)

    def _stations(self, stations: Floats, period: float | None) -> tuple[Floats, Floats]:
        """Those of a profile inside the part, and its ends: from its start, and on the edge."""
        laps = (0.0,) if period is None else (0.0, period)
        every = np.concatenate([stations + lap for lap in laps])
        inner = every[(every > self.start) & (every < self.stop)]
        at = np.concatenate([[self.start], inner, [self.stop]])
        return at - self.start, at

    def _heights(self) -> Floats | None:
        heights, edge = self.edge.elevations, self.edge
        if heights is None:
            return None
        closed = edge.curve.closed
        even = np.linspace(0.0, edge.length, len(heights), endpoint=not closed)
        at = np.linspace(self.start, self.stop, len(heights))
        return np.interp(at, even, heights, period=edge.length if closed else None)
