"""How high the ground is along the lines of agents, where roads of a scene pass over others."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...geometry.arrays import Floats
from ...ir.road_heights import has_heights, road_heights
from ...ir.scene import Scene
from ..lines.lines import Lines
from ..lines.route_lines import LineLeg, RouteLine
from ..vehicles.motion import Track

if TYPE_CHECKING:
    from ...ir.road_heights import RoadHeight

SPACING = 2.0
"""Meters along a leg between two places where its height is read, at most."""


@dataclass(frozen=True)
class LineHeights:
    """`cells` (L M,): meters where each cell of the lines of a world begins; NaN for who is on no
    road. On level ground a world has None instead."""

    cells: Floats

    @classmethod
    def of(
        cls, scenes: Sequence[Scene], lines: Lines, routes: Sequence[tuple[int, RouteLine]]
    ) -> LineHeights | None:
        """Of the lines of some scenes, None where all roads are on the ground. `routes`: what each
        line leads over, with the number of its scene."""
        if not any(map(has_heights, scenes)):
            return None
        known = {number: road_heights(scenes[number]) for number, _ in routes}
        names = {number: [road.name for road in scenes[number].roads] for number in known}
        out = np.empty((len(lines.length), lines.cells))
        cell = np.arange(lines.cells)
        for row, (number, route) in enumerate(routes):
            along, height = _along_line(route.legs, known[number], names[number])
            s = lines.origin[row] + cell * lines.spacing[row]
            s = np.mod(s, lines.length[row]) if lines.closed[row] else s
            out[row] = np.interp(s, along, height)
        return cls(out.ravel())

    def at(self, track: Track, along: Floats) -> Floats:
        """Meters at arc lengths of the lines of a track."""
        heights: Floats = self.cells[track.cell(track.wrapped(along))[0]]
        return heights


def _along_line(
    legs: Sequence[LineLeg], heights: Mapping[str, RoadHeight], names: Sequence[str]
) -> tuple[Floats, Floats]:
    """Arc lengths of a line and the heights there: those of its lanes, even between them."""
    found = []
    for leg in legs:
        if leg.turn is not None:
            continue
        span = float(leg.along[-1] - leg.begin)
        along = np.linspace(leg.begin, leg.begin + span, max(2, math.ceil(span / SPACING) + 1))
        station = np.interp(along, leg.along, leg.station)
        is_known = leg.road >= 0
        there = heights[names[leg.road]](station) if is_known else np.full(len(along), math.nan)
        found.append((along, there))
    along, height = (np.concatenate(column) for column in zip(*found, strict=True))
    return along, height
