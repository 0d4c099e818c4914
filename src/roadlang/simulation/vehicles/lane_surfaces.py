"""The surfaces of the lanes of many roads at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from ...geometry import CrossSection
from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene, SceneRoad
from ...ir.surface_stretches import surface_stretches
from ..lanes.lane_columns import LaneSection
from ..lanes.surfaces import road_surface, surface_names

NOTHING_SAID = -1
"""Number of the surface of a lane whose road says nothing of it, and of what is beside roads."""


@dataclass(frozen=True)
class LaneSurfaces:
    """Roads are those of `scenes`, one scene after the other; what is known of one is looked up
    when an agent first comes to it."""

    roads: Sequence[SceneRoad]
    first: Integers
    """(S,) number of the first road of each scene"""
    tires: Floats
    """(S, K, 2) friction and rolling resistance of each surface in each scene"""
    _place: Integers = field(repr=False)
    """(R,) where a road is in `_known`, -1 for nowhere"""
    _known: list[_LanesOfRoad] = field(default_factory=list, repr=False)
    _columns: list[_Columns] = field(default_factory=list, repr=False)
    """of all in `_known`; one, or none where they have to be made again"""

    @classmethod
    def of(cls, scenes: Sequence[Scene]) -> LaneSurfaces:
        """Those of scenes side by side."""
        roads = [road for scene in scenes for road in scene.roads]
        counts = [len(scene.roads) for scene in scenes]
        first = np.cumsum([0, *counts[:-1]])
        patched = [any(road.surface_patches for road in scene.roads) for scene in scenes]
        tires = np.zeros((len(scenes), len(surface_names()), 2))
        for number in np.flatnonzero(patched).tolist():
            for code, name in enumerate(surface_names()):
                surface = road_surface(scenes[number].world, name)
                tires[number, code] = surface.friction, surface.rolling
        return cls(roads, first, tires, np.full(len(roads), -1))

    def at(self, road: Integers) -> _Columns:
        """What is known of the lanes of roads (N,), a row for each."""
        for number in np.unique(road[self._place[road] < 0]).tolist():
            self._place[number] = len(self._known)
            self._known.append(_LanesOfRoad.of(self.roads[number]))
            self._columns.clear()
        if not self._columns:
            self._columns.append(_Columns.of(self._known))
        return self._columns[0].take(self._place[road])


@dataclass(frozen=True)
class _LanesOfRoad:
    """The surfaces of the lanes of a road by station."""

    section: CrossSection
    borders: Floats
    """(L + 1,) from left to right; NaN where they differ from station to station"""
    ends: Floats
    """(T - 1,) of all stretches but the last"""
    codes: Integers
    """(T, L) numbers of surfaces, from left to right"""
    plain: Booleans
    """(T,) whether all lanes of a stretch have the surface that the road says or does not say"""
    period: float
    """the length of a closed road, else infinite"""

    @classmethod
    def of(cls, road: SceneRoad) -> _LanesOfRoad:
        lanes = LaneSection.of(road)
        section, names = lanes.section, surface_names()
        stretches = surface_stretches(road, section.ids)
        said = [[_code(names, name) for name in one.surfaces] for one in stretches]
        codes, period = np.array(said), road.length if road.closed else np.inf
        borders = np.full(len(section.ids) + 1, np.nan)
        if lanes.is_constant:
            borders = section.border_offsets(0.0)
        ends = np.array([stretch.end for stretch in stretches[:-1]])
        plain = (codes == _code(names, road.surface)).all(axis=1)
        return cls(section, borders, ends, codes, plain, period)


def _code(names: Sequence[str], name: str | None) -> int:
    return NOTHING_SAID if name is None else names.index(name)


@dataclass(frozen=True)
class _Columns:
    """Rows are roads, filled up to the longest: ends with inf, borders with -inf, ids with 0."""

    sections: Sequence[CrossSection]
    row: Integers
    """(N,) where the section of each row is"""
    borders: Floats
    ends: Floats
    codes: Integers
    plain: Booleans
    ids: Integers
    last: Integers
    """the place of the rightmost border"""
    period: Floats

    @classmethod
    def of(cls, known: Sequence[_LanesOfRoad]) -> _Columns:
        lanes = max(len(one.section.ids) for one in known)
        stretches = max(len(one.codes) for one in known)
        count = len(known)
        borders = np.full((count, lanes + 1), -np.inf)
        ends = np.full((count, stretches - 1), np.inf)
        codes = np.full((count, stretches, lanes), NOTHING_SAID)
        plain = np.zeros((count, stretches), dtype=bool)
        ids = np.zeros((count, lanes), dtype=np.int64)
        for i, one in enumerate(known):
            here, own = len(one.codes), len(one.section.ids)
            borders[i, : own + 1], ends[i, : here - 1] = one.borders, one.ends
            codes[i, :here, :own], plain[i, :here] = one.codes, one.plain
            ids[i, :own] = one.section.ids
        sections = [one.section for one in known]
        last = np.array([len(section.ids) for section in sections])
        period = np.array([one.period for one in known])
        return cls(sections, np.arange(count), borders, ends, codes, plain, ids, last, period)

    def take(self, rows: Integers) -> _Columns:
        """Some rows."""
        return _Columns(
            self.sections, self.row[rows], self.borders[rows], self.ends[rows], self.codes[rows],
            self.plain[rows], self.ids[rows], self.last[rows], self.period[rows],
        )  # fmt: skip

    def is_plain(self, station: Floats, reach: Floats, has_route: Booleans) -> Booleans:
        """(N,) whether nothing within `reach` of stations (N,) has another surface than the road
        itself, which counts for those who may have begun on another one if it says any."""
        before, after = self._on_loop(station - reach), self._on_loop(station + reach)
        stretch, every = self._stretch(before), np.arange(len(station))
        same = (stretch == self._stretch(after)) & (before <= after)
        says_nothing = (self.codes[every, stretch] == NOTHING_SAID).all(axis=1)
        plain = self.plain[every, stretch] & (says_nothing | ~has_route)
        return np.asarray(same & plain)

    def middle(self, lane: Integers, station: Floats) -> Floats:
        """(N,) how far left of the curve the middle of a lane of each road is."""
        place, every = (self.ids == lane[:, None]).argmax(axis=1), np.arange(len(lane))
        borders = self._borders(station[None])[:, 0]
        return np.asarray((borders[place, every] + borders[place + 1, every]) / 2.0)

    def surface(self, station: Floats, offset: Floats) -> Integers:
        """(W, N) numbers of what is at offsets (W, N) to the left of the curve."""
        station = self._on_loop(station)
        borders, every = self._borders(station), np.arange(len(self.last))
        lane = np.minimum((borders[1:] > offset).sum(axis=0), self.codes.shape[2] - 1)
        on_road = (offset >= borders[self.last, :, every].T) & (offset <= borders[0])
        said = self.codes[every, self._stretch(station), lane]
        return np.where(on_road, said, NOTHING_SAID)

    def _on_loop(self, station: Floats) -> Floats:
        closed = np.isfinite(self.period)
        if not closed.any():
            return station
        return np.where(closed, station % np.where(closed, self.period, 1.0), station)

    def _stretch(self, station: Floats) -> Integers:
        """Which one stations (..., N) are in."""
        return np.asarray((self.ends < station[..., None]).sum(axis=-1))

    def _borders(self, station: Floats) -> Floats:
        """(L + 1, W, N) at stations (W, N)."""
        borders = np.repeat(self.borders.T[:, None], len(station), axis=1)
        changing = np.isnan(self.borders[:, 0])
        for row in np.unique(self.row[changing]).tolist():
            there, section = np.flatnonzero(self.row == row), self.sections[row]
            borders[: len(section.ids) + 1, :, there] = section.border_offsets(station[:, there])
        return borders
