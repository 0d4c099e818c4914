"""The lanes of the roads of a world, as tables: looked up for many agents at once."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import SceneRoad
from ...ir.surroundings import LanePlaces
from .speed_zones import SpeedZones

SPACING = 1.0
"""Meters between two nodes of a table of lanes whose width varies."""
NARROW = 2.2
"""Meters: a lane that was wider and is narrower from here on ends."""
_DIRECTIONS: Mapping[str, float] = {"forward": 1.0, "backward": -1.0}


@dataclass(frozen=True)
class _Section:
    """The lanes of one road from left to right; `borders` (nodes, L + 1) and
    `limits` (nodes, L) are `spacing` meters apart."""

    ids: tuple[int, ...]
    kinds: tuple[str, ...]
    direction: tuple[float, ...]
    drivable: tuple[bool, ...]
    borders: Floats
    limits: Floats
    ends: Floats
    """(nodes, L, 2) meters until a lane is too narrow to drive in, along the road and against it"""
    spacing: float


class RoadLanes:
    """Tables of R roads with at most L lanes. Sections that many roads share are built once."""

    def __init__(self, roads: Sequence[SceneRoad]) -> None:
        known: dict[Any, int] = {}
        sections: list[_Section] = []
        row = []
        for road in roads:
            key = _key(road)
            if key is None or key not in known:
                if key is not None:
                    known[key] = len(sections)
                row.append(len(sections))
                sections.append(_section(road))
            else:
                row.append(known[key])
        self._row = np.array(row, dtype=np.int64)
        self._widest = widest = max((len(section.ids) for section in sections), default=1)
        self._ids = _padded([section.ids for section in sections], widest, 0)
        self._direction = _padded([section.direction for section in sections], widest, 0.0)
        self._drivable = _padded([section.drivable for section in sections], widest, False)
        self._kinds = _padded([section.kinds for section in sections], widest, "").astype(object)
        self._count = np.array([len(section.ids) for section in sections], dtype=np.int64)
        self._nodes = np.array([len(section.borders) for section in sections], dtype=np.int64)
        self._first = np.concatenate([[0], np.cumsum(self._nodes)])[:-1].astype(np.int64)
        self._spacing = np.array([section.spacing for section in sections])
        wide = [
            np.pad(section.borders, ((0, 0), (0, widest - len(section.ids))), mode="edge")
            for section in sections
        ]
        self._borders = np.concatenate(wide) if wide else np.zeros((1, widest + 1))
        ends = [
            np.pad(section.ends, ((0, 0), (0, widest - len(section.ids)), (0, 0)))
            for section in sections
        ]
        self._ends = np.concatenate(ends) if ends else np.zeros((1, widest, 2))
        limits = [row for section in sections for row in section.limits.tolist()]
        self._limits = _padded(limits, widest, math.inf)

    def at(self, road: Integers, station: Floats, backward: Booleans) -> LanesHere:
        """The lanes of roads (N,), -1 for none, at stations (N,), as seen by who goes along the
        roads or `backward`."""
        row = self._row[road] if len(self._row) else np.zeros(len(road), dtype=np.int64)
        place = np.minimum(np.maximum(station / self._spacing[row], 0.0), self._nodes[row] - 1.0)
        low = place.astype(np.int64)
        high = np.minimum(low + 1, self._nodes[row] - 1)
        share = (place - low)[:, None]
        first = self._first[row]
        borders = self._borders[first + low] * (1.0 - share) + self._borders[first + high] * share
        there = np.arange(self._widest) < self._count[row][:, None]
        there &= (road >= 0)[:, None]
        sign = np.where(backward, -1.0, 1.0)[:, None]
        ends = self._ends[first + low, :, backward.astype(np.int64)]
        into = share * self._spacing[row][:, None]
        return LanesHere(
            there, self._ids[row], self._kinds[row], self._drivable[row], self._limits[first + low],
            self._direction[row] * sign, borders * sign,
            np.maximum(ends - np.where(backward[:, None], -into, into), 0.0), backward,
        )  # fmt: skip


@dataclass(frozen=True)
class LanesHere:
    """The lanes at N places: (N, L), in the order of the road from left to right; offsets are left
    of the center line as the agent sees it, so on the way back they grow from lane to lane."""

    there: Booleans
    ids: Integers
    kinds: Any
    drivable: Booleans
    limit: Floats
    direction: Floats
    borders: Floats
    """(N, L + 1)"""
    ends: Floats
    """(N, L) meters ahead at which a lane is too narrow to drive in, infinite where it goes on"""
    backward: Booleans

    def take(self, rows: Integers) -> LanesHere:
        """Those at some of the places."""
        return LanesHere(*(getattr(self, name)[rows] for name in _COLUMNS))

    @property
    def middles(self) -> Floats:
        """Offsets of the middles of the lanes, (N, L)."""
        return 0.5 * (self.borders[:, 1:] + self.borders[:, :-1])

    def index(self, offset: Floats) -> Integers:
        """(N,) the lane at offsets (N,), -1 for none."""
        first, second = self.borders[:, :-1], self.borders[:, 1:]
        low, high = np.minimum(first, second), np.maximum(first, second)
        inside = self.there & (offset[:, None] >= low) & (offset[:, None] <= high) & (high > low)
        return np.where(inside.any(axis=1), inside.argmax(axis=1), -1)

    def place(self, offset: Floats) -> LanePlaces:
        """The lanes at offsets (N,)."""
        index = self.index(offset)
        found = index >= 0
        width = np.abs(self.borders[:, 1:] - self.borders[:, :-1])
        return LanePlaces(
            np.where(found, _of(self.ids, index), 0),
            np.where(found, _of(self.middles, index), math.nan),
            np.where(found, _of(width, index), math.nan),
            np.where(found, _of(self.limit, index), math.inf),
            np.where(found, _of(self.direction, index), math.nan),
            np.where(self.backward, -1.0, 1.0),
        )

    def end(self, offset: Floats) -> Floats:
        """(N,) how far ahead the lanes at offsets (N,) end."""
        index = self.index(offset)
        return np.where(index >= 0, _of(self.ends, index), math.inf)

    def choose(self, which: str, offset: Floats) -> Integers:
        """(N,) the lane that agents at `offset` mean by a word, -1 for none."""
        if which in _SIDES:
            return self._beside(which, offset)
        fits = self.there & (self.kinds == which)
        away = np.where(fits, np.abs(self.middles - offset[:, None]), math.inf)
        return np.where(fits.any(axis=1), away.argmin(axis=1), -1)

    def numbered(self, lane: Floats | Integers | int, rows: Integers) -> Integers:
        """The lane of a number at some of the places, -1 for none."""
        wanted = np.broadcast_to(np.asarray(lane), rows.shape)[:, None]
        fits = self.there[rows] & (self.ids[rows] == wanted)
        return np.where(fits.any(axis=1), fits.argmax(axis=1), -1)

    def _beside(self, side: str, offset: Floats) -> Integers:
        """The lane next to that of agents at `offset`, for motor vehicles."""
        index = self.index(offset)
        step = np.where(self.backward, 1, -1)
        if side in ("inner", "outer"):
            # Lanes run from n to 1, then from -1 on: the middle is to the right of positive ones.
            step = np.where(_of(self.ids, index) > 0, 1, -1)
        if side in ("right", "outer"):
            step = -step
        there = index + step
        last = self.there.sum(axis=1) - 1
        fits = (index >= 0) & (there >= 0) & (there <= last)
        there = np.where(fits, there, 0)
        return np.where(fits & _of(self.drivable, there), there, -1)


_COLUMNS = tuple(field.name for field in fields(LanesHere))
_SIDES = ("left", "right", "inner", "outer")


def _of(columns: Any, index: Integers) -> Any:
    """(N,) one column of each row."""
    return columns[np.arange(len(index)), np.maximum(index, 0)]


def lane_values(columns: Floats, index: Integers) -> Floats:
    """(N,) the number of one lane of each place; NaN where that is -1."""
    return np.where(index >= 0, _of(columns, index), math.nan)


def _key(road: SceneRoad) -> Any:
    """Roads of one key have the same section everywhere; None for widths that vary."""
    widths = [len(lane.width) for lane in road.lane_list]
    if not widths or max(widths) > 1 or len(road.center_offset) > 1 or road.speed_zones:
        return None
    return (road.lane_list, road.center_offset, road.center_marking, road.speed_limit)


def _section(road: SceneRoad) -> _Section:
    section = road.cross_section()
    varies = _key(road) is None
    length, lanes = road.length, len(section.lanes)
    nodes = max(2, math.ceil(length / SPACING) + 1) if varies else 1
    stations = np.linspace(0.0, length, nodes)
    zones = SpeedZones.of(road, section.lanes)
    borders = np.ascontiguousarray(section.border_offsets(stations).T)
    return _Section(
        ids=section.ids,
        kinds=tuple(lane.kind for lane in section.lanes),
        direction=tuple(_DIRECTIONS.get(lane.direction, 0.0) for lane in section.lanes),
        drivable=tuple(lane.drivable for lane in section.lanes),
        borders=borders,
        limits=zones.limits[zones.zone(stations)],
        ends=_ends(borders, length / (nodes - 1)) if varies else np.full((1, lanes, 2), math.inf),
        spacing=length / (nodes - 1) if varies else 1.0,
    )


def _ends(borders: Floats, spacing: float) -> Floats:
    """(nodes, L, 2) as in `_Section`, of borders (nodes, L + 1). A lane that is narrow everywhere
    ends nowhere."""
    width = np.abs(np.diff(borders, axis=1))
    narrow = (width < NARROW) & (width.max(axis=0) >= NARROW)
    out = np.full((*width.shape, 2), math.inf)
    for side, nodes in ((0, range(len(width) - 1, -1, -1)), (1, range(len(width)))):
        left = np.full(width.shape[1], math.inf)
        for node in nodes:
            left = np.where(narrow[node], 0.0, left + spacing)
            out[node, :, side] = left
    return out


def _padded(rows: Sequence[Sequence[Any]], count: int, value: Any) -> Any:
    if not rows:
        return np.array([[value] * count])
    return np.array([[*row, *([value] * (count - len(row)))] for row in rows])
