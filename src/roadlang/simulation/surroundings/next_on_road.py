"""Who is next ahead in the lane where all agents of a scene are on one road: found in the order of
their stations, without the gaps between all pairs."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Floats, Integers
from .road_gaps import RoadColumns, gap_between, is_in_lane

FAR = 1e15
"""Meters: who is not there is beyond all others."""


def next_on_road(columns: RoadColumns) -> tuple[Floats, Integers]:
    """(S, A) the least gap of each agent, and the place in its scene of whom it is to: of several
    the first, and 0 where the gap is infinite. What `RoadColumns.gaps` gives has the same least
    ones, where all go along one open road."""
    shape = columns.there.shape
    ranked = _Ranked.of(columns)
    gap, first = np.empty(columns.there.size), np.empty(columns.there.size, dtype=np.int64)
    found = _nearest(ranked)
    gap[ranked.agent], first[ranked.agent] = found
    if not columns.all_there:
        gone = ~columns.there.ravel()
        gap[gone], first[gone] = math.inf, 0
    return gap.reshape(shape), first.reshape(shape)


@dataclass(frozen=True)
class _Ranked:
    """Columns (A S,): all that are first of their scenes, then all that are second, and so on."""

    scenes: int
    agent: Integers
    slot: Integers
    station: Floats
    columns: tuple[Floats, ...]
    """what `is_in_lane` looks at"""
    length: Floats
    comes_over: bool

    @classmethod
    def of(cls, columns: RoadColumns) -> _Ranked:
        """`columns` in the order of stations."""
        scenes, slots = columns.there.shape
        station, half = columns.station, columns.half
        if not columns.all_there:
            station = np.where(columns.there, station, FAR)
            half = np.where(columns.there, half, -math.inf)
        order = station.argsort(axis=1, kind="stable")
        slot = np.ascontiguousarray(order.T).ravel()
        agent = slot + np.tile(np.arange(scenes) * slots, slots)
        taken = (
            columns.left, columns.offset, columns.own, columns.clearance, half, columns.drift,
        )  # fmt: skip
        return cls(
            scenes, agent, slot, station.ravel()[agent],
            tuple(column.ravel()[agent] for column in taken), columns.length.ravel()[agent],
            columns.comes_over,
        )  # fmt: skip

    def gaps(self, first: slice | Integers, second: slice | Integers) -> Floats:
        """(n,) from those in the rows `first` to those in `second`, infinite for who is not in
        their lane ahead."""
        left, offset, own, clearance, half, drift = self.columns
        ahead = self.station[second] - self.station[first]
        fits = is_in_lane(
            ahead, left[second], (offset[first], own[first], clearance[first], 1.0),
            (half[second], drift[second] if self.comes_over else None),
        )  # fmt: skip
        return np.where(fits, gap_between(ahead, self.length[first], self.length[second]), math.inf)


def _nearest(ranked: _Ranked) -> tuple[Floats, Integers]:
    """(A S,) the least gaps, and to whom."""
    count, scenes = len(ranked.agent), ranked.scenes
    gap, slot = np.full(count, math.inf), np.zeros(count, dtype=np.int64)
    some: slice | Integers = slice(0, count - scenes)
    other: slice | Integers = slice(scenes, count)
    longest = ranked.length.max()
    for _ in range(1, count // scenes):
        found = ranked.gaps(some, other)
        best, place, nearer = gap[some], slot[some], ranked.slot[other]
        closer = (found < best) | ((found == best) & (nearer < place) & (found < math.inf))
        gap[some] = np.where(closer, found, best)
        slot[some] = np.where(closer, nearer, place)
        some, other = _next(ranked, gap, longest, some, other)
        if isinstance(some, np.ndarray) and not len(some):
            break
    return gap, slot


def _next(
    ranked: _Ranked, gap: Floats, longest: float, some: slice | Integers, other: slice | Integers
) -> tuple[Integers, Integers]:
    """The rows for which one of those behind `other` may be nearer, and the next of these."""
    count, scenes = len(ranked.agent), ranked.scenes
    if isinstance(some, slice) or isinstance(other, slice):
        rows = np.arange(count - 2 * scenes)
        beyond = rows + 2 * scenes
    else:
        beyond = other + scenes
        within = beyond < count
        rows, beyond = some[within], beyond[within]
    ahead = ranked.station[beyond] - ranked.station[rows]
    least = gap_between(ahead, ranked.length[rows], longest)
    may_be = (least <= gap[rows]) & (ahead < 0.5 * FAR)
    return rows[may_be], beyond[may_be]
