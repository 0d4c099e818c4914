"""The middles of lanes whose widths change: where along a line the line of an agent has to be."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...ir.scene import SceneRoad
from ..lanes.road_forms import RoadForms
from .leading_over import led_over

SPACING = 1.0
"""Meters between two nodes of a table, at most."""
AROUND = 3
"""Nodes to each side over which the middle of a lane is averaged, twice: drivers do not follow each
kink of a lane."""
STRAIGHT = 1e-6
"""Meters by which three nodes in a row may be off a straight line."""
_OFFSET, _SLOPE, _BEND, _MIDDLE = range(4)


@dataclass(frozen=True)
class LaneGuides:
    """Tables of G guides, one for each lane of the lines (L,) whose lanes change their widths.

    A guide is the middle of its lane, left of the reference line. Where the lane ends, it leads
    over to the middle of the next lane whose traffic goes the same way.
    """

    first: Integers
    """(L,) number of the first guide of a line, -1 for lanes of constant widths"""
    ids: tuple[tuple[int, ...], ...]
    """of the lanes of each line"""
    begin: Integers
    """(G,) where the nodes of a guide begin in `nodes`"""
    last: Integers
    """(G,) how many intervals these have"""
    per_meter: Floats
    """(G,)"""
    nodes: Floats
    """(4, nodes) offset, slope (1) and second derivative (1/m) of guides, and the middles of their
    lanes as they are"""

    @classmethod
    def of(cls, roads: Iterable[tuple[SceneRoad, bool] | None]) -> LaneGuides:
        """Of lines: each the road that it is the center line of, and whether it leads against its
        direction; None for other lines."""
        first: list[int] = []
        ids: list[tuple[int, ...]] = []
        columns: list[Floats] = []
        per_meter: list[float] = []
        forms = RoadForms()
        vary: dict[int, bool] = {}  # by form
        for line in roads:
            tables = _tables(*line) if line and _form_may_vary(line[0], forms, vary) else {}
            first.append(len(columns) if tables else -1)
            ids.append(tuple(tables))
            columns += tables.values()
            if line is not None:
                per_meter += [(table.shape[1] - 1) / line[0].length for table in tables.values()]
        counts = np.array([table.shape[1] for table in columns], dtype=np.int64)
        return cls(
            np.array(first, dtype=np.int64), tuple(ids), np.cumsum(counts) - counts, counts - 1,
            np.array(per_meter), np.concatenate([np.zeros((4, 0)), *columns], axis=1),
        )  # fmt: skip

    @cached_property
    def is_empty(self) -> bool:
        """Whether all lanes have constant widths."""
        return len(self.begin) == 0

    def number(self, line: int, lane: int) -> int:
        """The guide of a lane of a line, -1 for none."""
        ids = self.ids[line]
        return int(self.first[line]) + ids.index(lane) if lane in ids else -1

    def offset(self, guide: Integers, along: Floats) -> Floats:
        """(...) of guides, -1 for none, at arc lengths."""
        return self._at(_OFFSET, guide, along)

    def ahead(self, guide: Integers, along: Floats) -> tuple[Floats, Floats, Floats]:
        """(...) offset, slope (1) and second derivative (1/m) of guides at arc lengths."""
        place = self._place(guide, along)
        offset, slope, bend = (
            self._value(which, guide, place) for which in (_OFFSET, _SLOPE, _BEND)
        )
        return offset, slope, bend

    def beside(self, guide: Integers, along: Floats) -> Floats:
        """(...) how far left of guides, -1 for none, the middles of their lanes are."""
        return self._at(_MIDDLE, guide, along) - self._at(_OFFSET, guide, along)

    def nearest(self, line: Integers, offset: Floats, along: Floats) -> tuple[Integers, Floats]:
        """(n,) of the lanes of lines that have guides, the guide of that whose middle is nearest to
        an offset, and how far left of the middle that is."""
        guide, beside = np.full(len(line), -1), offset.copy()
        for place, (row, at) in enumerate(zip(line.tolist(), along, strict=True)):
            mine = self.first[row] + np.arange(len(self.ids[row]))
            away = offset[place] - self._at(_MIDDLE, mine, np.full(len(mine), at))
            nearest = int(np.abs(away).argmin())
            guide[place], beside[place] = mine[nearest], away[nearest]
        return guide, beside

    def _at(self, which: int, guide: Integers, along: Floats) -> Floats:
        return self._value(which, guide, self._place(guide, along))

    def _place(self, guide: Integers, along: Floats) -> tuple[Integers, Floats]:
        known = np.maximum(guide, 0)
        last = self.last[known]
        advance = np.minimum(np.maximum(along * self.per_meter[known], 0.0), last)
        cell = np.minimum(advance.astype(np.int64), last - 1)
        return self.begin[known] + cell, advance - cell

    def _value(self, which: int, guide: Integers, place: tuple[Integers, Floats]) -> Floats:
        node, share = place
        column = self.nodes[which]
        low = column[node]
        return np.where(guide >= 0, low + (column[node + 1] - low) * share, 0.0)


def _tables(road: SceneRoad, backward: bool) -> dict[int, Floats]:
    """(4, nodes) of each lane, by its id; none where no lane changes its place."""
    if not _may_vary(road):
        return {}
    section = road.cross_section()
    count = max(2, math.ceil(road.length / SPACING)) + 1
    stations = np.linspace(0.0, road.length, count)
    middles = np.array([np.broadcast_to(section.offset(id, stations), count) for id in section.ids])
    if not np.ptp(middles, axis=1).any():
        return {}
    sign = -1.0 if backward else 1.0
    spacing = road.length / (count - 1)
    found = {}
    over = led_over(section, middles, stations)
    for id, middle, led in zip(section.ids, middles, over, strict=True):
        offset = _averaged(led, road.closed)
        slope = np.gradient(offset, spacing)
        columns = sign * np.stack([offset, slope, np.gradient(slope, spacing), middle])
        if backward:
            columns = columns[:, ::-1]
            columns[_SLOPE] *= -1.0
        found[id] = columns
    return found


def lane_guide(road: SceneRoad, lane: int) -> tuple[Floats, Floats] | None:
    """Stations (n,) of a road, and how far left of its center line the line lies there that agents
    in a lane follow; None where that is the same everywhere.

    Between two stations it is linear.
    """
    table = _tables(road, backward=False).get(lane)
    if table is None:
        return None
    offset = table[_OFFSET]
    kept = np.ones(len(offset), dtype=bool)
    kept[1:-1] = np.abs(np.diff(offset, 2)) > STRAIGHT
    return np.linspace(0.0, road.length, len(offset))[kept], offset[kept]


def _may_vary(road: SceneRoad) -> bool:
    lists = [lane.width for lane in road.lane_list] or [road.width]
    return any(len(values) > 1 for values in (*lists, road.center_offset))


def _form_may_vary(road: SceneRoad, forms: RoadForms, known: dict[int, bool]) -> bool:
    """The same, asked once for all roads with the same lanes."""
    form = forms.number(road)
    if form is None:
        return _may_vary(road)
    if form not in known:
        known[form] = _may_vary(road)
    return known[form]


def _averaged(values: Floats, closed: bool) -> Floats:
    """(nodes,) twice over `AROUND` nodes to each side; what is constant stays as it is."""
    if not np.ptp(values):
        return values
    for _ in range(2):
        wide: Any = (
            np.concatenate([values[-1 - AROUND : -1], values, values[1 : 1 + AROUND]])
            if closed
            else np.pad(values, AROUND, mode="reflect", reflect_type="odd")
        )
        parts = [wide[k : k + len(values)] for k in range(2 * AROUND + 1)]
        values = np.sum(parts, axis=0) / len(parts)
    return values
