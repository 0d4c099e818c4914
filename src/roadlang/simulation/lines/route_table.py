"""What the lines of a world lead over: road, lane, station, limits, by arc length."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from .route_lines import RouteConnection, RouteLine

_NO_LANE = 1_000_000
STAYS = 0.3
"""Share of the first half of a lane change, its last, in which cars reach into the other lane."""
STATION_SPACING = 1.0
"""Meters of a leg between two stations of the table, at most."""


@dataclass(frozen=True)
class RoadPosition:
    """Columns (N,): where on roads and junctions arc lengths of lines are."""

    leg: Integers
    """number of the part of the line"""
    step: Integers
    """of the route"""
    road: Integers
    """number in its scene, -1 for none; on a connection that which it leaves"""
    lane: Integers
    """its id, 0 for none and on a connection"""
    station: Floats
    """arc length along the road; on a connection where the lane ends that it leaves"""
    turn: Integers
    """on a connection its number in `RouteTable.turns`, else -1"""
    direction: Integers
    """1 along the road, -1 against it"""


@dataclass(frozen=True)
class RouteTable:
    """Tables of L lines with at most K legs each. A leg is a part of one lane, or a connection.

    `line` (N,) is the line of each agent; in all methods, `rows` picks some of these agents and
    `along` are arc lengths of their lines, one for each. On closed lines they are within one lap.
    The other arrays have the shape (L, K) over legs; those that a line does not have begin at
    infinity.
    """

    line: Integers
    begin: Floats
    """arc length of the line"""
    step: Integers
    road: Integers
    lane: Integers
    limit: Floats
    """m/s, infinite for none"""
    turn: Integers
    """number in `turns`, -1 for a lane"""
    turns: tuple[RouteConnection, ...]
    """all connections of all lines"""
    first: Integers
    """where the stations of a leg begin in `stations`"""
    last: Integers
    """how many intervals these have"""
    per_meter: Floats
    stations: Floats
    """of all legs, evenly spaced in each"""
    direction: Integers
    """1 along the road, -1 against it"""
    changed: Floats
    """meters before and after its begin in which the line changes to the lane of the leg; 0: not"""
    has_changes: bool
    """whether any line changes lanes"""
    aside: Floats
    """(L,) meters by which a line is moved at junctions, to keep clear of what stands there"""

    @classmethod
    def of(cls, lines: Sequence[RouteLine], line: Integers) -> RouteTable:
        """The table of lines, in their order. `line`: (N,) that of each agent."""
        shape = len(lines), max(len(line.legs) for line in lines)
        begin, limit = np.full(shape, math.inf), np.full(shape, math.inf)
        per_meter, changed = np.zeros(shape), np.zeros(shape)
        step, road, lane, turn, first, last, direction = (
            np.zeros(shape, dtype=np.int64) for _ in range(7)
        )
        road -= 1
        turn -= 1
        turns: list[RouteConnection] = []
        stations: list[Floats] = []
        filled = 0
        for row, route in enumerate(lines):
            for place, leg in enumerate(route.legs):
                at = row, place
                begin[at] = leg.begin if place else -math.inf
                step[at], road[at], lane[at] = leg.step, leg.road, leg.lane
                limit[at], changed[at] = leg.speed_limit, leg.changed
                direction[at] = -1 if leg.station[-1] < leg.station[0] else 1
                if leg.turn is not None:
                    turn[at] = len(turns)
                    turns.append(leg.turn)
                span = float(leg.along[-1] - leg.begin)
                is_straight = len(leg.along) == 2
                last[at] = 1 if is_straight else max(1, math.ceil(span / STATION_SPACING))
                per_meter[at] = last[at] / span if span > 0.0 else 0.0
                nodes = leg.station
                if not is_straight:
                    even = np.linspace(leg.begin, float(leg.along[-1]), last[at] + 1)
                    nodes = np.interp(even, leg.along, leg.station)
                stations.append(nodes)
                first[at] = filled
                filled += len(nodes)
        return cls(
            line, begin, step, road, lane, limit, turn, tuple(turns), first, last, per_meter,
            np.concatenate(stations), direction, changed, bool(changed.any()),
            np.array([route.aside for route in lines]),
        )  # fmt: skip

    def take(self, agents: Integers) -> RouteTable:
        """That of some agents."""
        return replace(self, line=self.line[agents])

    def leg(self, rows: Any, along: Floats) -> Integers:
        """(N,) numbers of the legs there."""
        if self.begin.shape[1] == 1:
            return np.zeros(len(along), dtype=np.int64)
        return np.asarray((along[:, None] >= self.begin[self.line[rows], 1:]).sum(axis=1))

    def leg_ends(self, rows: Any, along: Floats) -> tuple[Floats, Floats]:
        """(N,) arc lengths at which the legs there begin, infinitely far back for the first, and
        end, infinite for the last."""
        line, leg = self.line[rows], self.leg(rows, along)
        last = self.begin.shape[1] - 1
        following = self.begin[line, np.minimum(leg + 1, last)]
        return self.begin[line, leg], np.where(leg < last, following, math.inf)

    def has_several_legs(self, rows: Any) -> Booleans:
        """(N,) whether the line of an agent has more than one leg."""
        if self.begin.shape[1] == 1:
            return np.zeros(len(self.line[rows]), dtype=bool)
        return np.asarray(np.isfinite(self.begin[self.line[rows], 1]))

    def place(self, rows: Any, along: Floats) -> RoadPosition:
        """Where that is on roads and junctions."""
        line, leg = self.line[rows], self.leg(rows, along)
        return RoadPosition(
            leg, self.step[line, leg], self.road[line, leg], self.lane[line, leg],
            self._station(line, leg, along), self.turn[line, leg], self.direction[line, leg],
        )  # fmt: skip

    def coming_place(self, rows: Any, along: Floats) -> RoadPosition:
        """The same, but on a connection that on the lane it leads to: as far before its beginning
        as is left to go."""
        line, leg = self.line[rows], self.leg(rows, along)
        after = np.minimum(leg + 1, self.begin.shape[1] - 1)
        leads = (self.turn[line, leg] >= 0) & (self.turn[line, after] < 0)
        leads &= np.isfinite(self.begin[line, after])
        chosen = np.where(leads, after, leg)
        left = np.where(leads, self.begin[line, after], along) - along
        direction = self.direction[line, chosen]
        station = self._station(line, chosen, along) - direction * left
        return RoadPosition(
            chosen, self.step[line, chosen], self.road[line, chosen], self.lane[line, chosen],
            station, self.turn[line, chosen], direction,
        )  # fmt: skip

    def station(self, rows: Any, along: Floats) -> Floats:
        """(N,) arc lengths along the roads, within the ends of the lines."""
        return self._station(self.line[rows], self.leg(rows, along), along)

    def speed_limit(self, rows: Any, along: Floats) -> Floats:
        """(N,) m/s, infinite for none."""
        return np.asarray(self.limit[self.line[rows], self.leg(rows, along)])

    def speed_limit_ahead(self, rows: Any, there: Floats, braking: Floats | float) -> Floats:
        """(N,) the greatest speeds at arc lengths from which all limits from there on can be kept
        with `braking`, m/s^2: `v^2 = limit^2 + 2 braking distance`."""
        line = self.line[rows]
        square, begin, end = self.limits
        rate = np.asarray(2.0 * braking, dtype=np.float64)
        rate = rate if rate.shape == there.shape else np.full(there.shape, rate)
        distance = np.maximum(begin[line] - there[:, None], 0.0)
        squares = square[line] + rate[:, None] * distance
        ahead = end[line] > there[:, None]
        return np.asarray(np.sqrt(np.where(ahead, squares, math.inf).min(axis=1)))

    @cached_property
    def limits(self) -> tuple[Floats, Floats, Floats]:
        """(L, K) squares of the limits, and where these begin and end; those that a line does not
        have are infinite and begin nowhere, so that no distance counts."""
        end = np.full(self.begin.shape, math.inf)
        end[:, :-1] = self.begin[:, 1:]
        begin = np.where(np.isfinite(self.begin), self.begin, -math.inf)
        return self.limit * self.limit, begin, end

    def lane_changes(
        self, rows: Any, along: Floats, first: Floats, last: Floats
    ) -> tuple[Booleans, Integers, Integers]:
        """(N,) whether lines change lanes between arc lengths `first` and `last`, and of the lanes
        that they change to, up to the next connection from `along` on, the least and the greatest
        id."""
        line = self.line[rows]
        begin, changed = self.begin[line], self.changed[line]
        meets = (changed > 0.0) & (begin - changed < last[:, None])
        meets &= begin + changed > first[:, None]
        turns = (self.turn[line] >= 0) & (begin > along[:, None])
        meets &= np.cumsum(turns, axis=1) == 0
        lane = self.lane[line]
        least = np.where(meets, lane, _NO_LANE).min(axis=1)
        greatest = np.where(meets, lane, -_NO_LANE).max(axis=1)
        return meets.any(axis=1), least, greatest

    def enters_lane(self, rows: Any, along: Floats) -> Floats:
        """(N,) arc lengths of the lines where the next lane change begins to reach into the other
        lane, infinite for none; it lies behind for who is in it with less than its middle."""
        line = self.line[rows]
        begin, changed = self.begin[line], self.changed[line]
        ahead = (changed > 0.0) & (begin > along[:, None])
        return np.asarray(np.where(ahead, begin - STAYS * changed, math.inf).min(axis=1))

    def _station(self, line: Integers, leg: Integers, along: Floats) -> Floats:
        """Linear between the stations of the table."""
        begin = self.begin[line, leg]
        advance = np.where(np.isfinite(begin), along - begin, along) * self.per_meter[line, leg]
        last = self.last[line, leg]
        advance = np.minimum(np.maximum(advance, 0.0), last)
        cell = np.minimum(advance.astype(np.int64), last - 1)
        node = self.first[line, leg] + cell
        low = self.stations[node]
        return np.asarray(low + (self.stations[node + 1] - low) * (advance - cell))
