"""The lanes of a network in their directions of travel, and how one goes on in others."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

from ..lanes.cross_section import CrossSection
from ..networks.junction_model import NO_JUNCTION, JunctionPlan, LaneEnd
from ..networks.network import Edge

T = TypeVar("T")
BEND = 3.0
"""Meters over which a bend is measured: shorter ones are those of the drawing"""
NO_STEP = 0.1
"""Meters: a lane whose middle hardly goes on is as sharp as if it went on so far."""
LANE_CHANGE = 20.0
"""Meters of road that a route leaves for each change of lane"""


@dataclass(frozen=True, slots=True, order=True)
class TravelLane:
    """A lane in one direction of travel: against its road, if `backward`."""

    edge: int
    lane: int
    backward: bool


@dataclass(frozen=True, slots=True)
class Turn:
    """A connection into a lane, by its number in the graph. The seam of a closed road, which no
    junction has, is one of length 0 in `NO_JUNCTION`."""

    junction: int
    connection: int
    length: float
    target: int
    turn: str
    curvature: float = 0.0
    """1/m, the greatest of its absolute values"""


@dataclass(frozen=True, slots=True)
class Exit:
    """A turn out of `lane` that is reached by `changes` changes of lane."""

    changes: int
    lane: int
    turn: Turn


@dataclass(frozen=True, eq=False)
class LaneGraph:
    """The lanes of a network that vehicles may drive in, numbered in their order.

    Arc lengths are those of the edges; `begin` and `end` are where traffic enters and leaves each
    lane, outside the junctions. Roads inside a junction have no lanes here.
    """

    lanes: tuple[TravelLane, ...]
    begin: tuple[float, ...]
    end: tuple[float, ...]
    turns: tuple[tuple[Turn, ...], ...]
    """by lane, in the order of junctions and connections"""
    neighbors: tuple[tuple[int, ...], ...]
    """by lane, those beside it that a vehicle may change into"""
    sections: Mapping[int, CrossSection]
    """by edge, along its curve"""
    edges: Mapping[int, Edge]
    joints: frozenset[int] = frozenset({NO_JUNCTION})
    """the junctions at which two roads only go on in one another"""
    ring: frozenset[int] = frozenset()
    """the edges of roundabouts"""
    _searched: dict[int, Any] = field(default_factory=dict)
    _bends: dict[int, float] = field(default_factory=dict)

    def searched(self, source: int, search: Callable[[LaneGraph, int], T]) -> T:
        """What `search` finds from a lane on, searched for once."""
        if source not in self._searched:
            self._searched[source] = search(self, source)
        found: T = self._searched[source]
        return found

    def length(self, lane: int) -> float:
        """Meters from where traffic enters a lane to where it leaves it."""
        return abs(self.end[lane] - self.begin[lane])

    def sharpest_bend(self, lane: int) -> float:
        """1/m: the greatest curvature of the middle of a lane, over a few meters."""
        if lane not in self._bends:
            self._bends[lane] = self._sharpest_bend(lane)
        return self._bends[lane]

    def _sharpest_bend(self, lane: int) -> float:
        edge, id = self.lanes[lane].edge, self.lanes[lane].lane
        curve, low, high = self.edges[edge].curve, *sorted((self.begin[lane], self.end[lane]))
        count = int((high - low) // BEND)
        if count < 1:
            return 0.0
        at = np.linspace(low, high, count + 1)
        middle = curve.at(at) + self.sections[edge].offset(id, at)[:, None] * curve.normal(at)
        steps = np.hypot(*np.diff(middle, axis=0).T)
        turned = np.abs(np.diff(curve.heading(at)))
        return float((turned / np.maximum(steps, NO_STEP)).max())

    def heading(self, lane: int, station: float) -> float:
        """Radians: which way traffic in a lane runs at an arc length of its edge."""
        along = float(self.edges[self.lanes[lane].edge].curve.heading(np.array([station]))[0])
        return along if self.forward(lane) else along + np.pi

    def room(self, lane: int, station: float) -> float:
        """Meters from an arc length to where traffic leaves the lane; negative beyond."""
        return self.end[lane] - station if self.forward(lane) else station - self.end[lane]

    def forward(self, lane: int) -> bool:
        """Whether traffic in the lane runs along its road."""
        return not self.lanes[lane].backward

    def exits(self, lane: int, room: float) -> tuple[Exit, ...]:
        """All turns out of a lane and out of those that it may be changed for within `room`."""
        most = int(max(room, 0.0) // LANE_CHANGE)
        return tuple(
            Exit(changes, other, turn)
            for other, changes in self.changes[lane].items()
            if changes <= most
            for turn in self.turns[other]
        )

    @cached_property
    def changes(self) -> tuple[Mapping[int, int], ...]:
        """By lane, how many changes of lane lead to others of its road, itself first."""
        return tuple(self._changes_from(lane) for lane in range(len(self.lanes)))

    def lanes_between(self, first: int, last: int) -> tuple[int, ...]:
        """The lanes from one to another that it may be changed for, both included."""
        path = [last]
        while path[-1] != first:
            steps = self.changes[first]
            near = (lane for lane in self.neighbors[path[-1]] if lane in steps)
            path.append(min(near, key=lambda lane: (steps[lane], lane)))
        return tuple(reversed(path))

    @cached_property
    def sources(self) -> tuple[tuple[tuple[int, Turn], ...], ...]:
        """By lane, the lanes that lead into it, and by which turn."""
        found: list[list[tuple[int, Turn]]] = [[] for _ in self.lanes]
        for lane, turns in enumerate(self.turns):
            for turn in turns:
                found[turn.target].append((lane, turn))
        return tuple(map(tuple, found))

    @cached_property
    def of_edge(self) -> Mapping[int, tuple[int, ...]]:
        """The lanes of each edge that has some."""
        found: dict[int, list[int]] = {}
        for number, lane in enumerate(self.lanes):
            found.setdefault(lane.edge, []).append(number)
        return {edge: tuple(numbers) for edge, numbers in found.items()}

    @cached_property
    def carriageways(self) -> tuple[tuple[int, ...], ...]:
        """By lane, all lanes of its road in its direction."""
        groups: dict[tuple[int, bool], list[int]] = {}
        for number, lane in enumerate(self.lanes):
            groups.setdefault((lane.edge, lane.backward), []).append(number)
        return tuple(tuple(groups[lane.edge, lane.backward]) for lane in self.lanes)

    def _changes_from(self, lane: int) -> Mapping[int, int]:
        found = {lane: 0}
        waiting = deque([lane])
        while waiting:
            current = waiting.popleft()
            for other in self.neighbors[current]:
                if other not in found:
                    found[other] = found[current] + 1
                    waiting.append(other)
        return found


def lane_graph(
    edges: Iterable[Edge], sections: Mapping[int, CrossSection], plan: JunctionPlan
) -> LaneGraph:
    """The lanes of edges with these cross-sections, outside the junctions of a plan."""
    by_id = {edge.id: edge for edge in sorted(edges, key=lambda edge: edge.id)}
    inside = {edge for junction in plan.junctions for edge in junction.inside}
    lanes = sorted(
        TravelLane(edge, lane.id, backward)
        for edge in by_id.keys() - inside
        for lane in sections[edge].lanes
        for backward in (False, True)
        if lane.drivable and lane.direction in ("both", "backward" if backward else "forward")
    )
    numbers = {lane: number for number, lane in enumerate(lanes)}
    ends = [_ends(lane, by_id[lane.edge].length, plan) for lane in lanes]
    return LaneGraph(
        tuple(lanes),
        tuple(begin for begin, _ in ends),
        tuple(end for _, end in ends),
        _turns(numbers, by_id, plan),
        tuple(_neighbors(lane, sections[lane.edge], numbers) for lane in lanes),
        dict(sections),
        by_id,
        frozenset({NO_JUNCTION, *(item.id for item in plan.junctions if item.kind == "joint")}),
        frozenset(plan.ring),
    )


def _ends(lane: TravelLane, length: float, plan: JunctionPlan) -> tuple[float, float]:
    start, end = plan.trims.get(lane.edge, (0.0, 0.0))
    return (length - end, start) if lane.backward else (start, length - end)


def _turns(
    numbers: Mapping[TravelLane, int], edges: Mapping[int, Edge], plan: JunctionPlan
) -> tuple[tuple[Turn, ...], ...]:
    found: list[list[Turn]] = [[] for _ in numbers]
    for junction in plan.junctions:
        for connection in junction.connections:
            source = numbers.get(_leaving(connection.source))
            target = numbers.get(_entering(connection.target))
            if source is not None and target is not None:
                sharpest = max((abs(bend) for _, bend in connection.pieces), default=0.0)
                turn = connection.turn
                found[source].append(
                    Turn(junction.id, connection.id, connection.length, target, turn, sharpest)
                )
    at_junction = {(arm.edge, arm.end) for junction in plan.junctions for arm in junction.arms}
    for lane, number in numbers.items():
        is_seam = edges[lane.edge].curve.closed and (lane.edge, "start") not in at_junction
        if is_seam:
            found[number].append(Turn(NO_JUNCTION, 0, 0.0, number, "straight"))
    return tuple(map(tuple, found))


def _leaving(lane: LaneEnd) -> TravelLane:
    return TravelLane(lane.edge, lane.lane, lane.end == "start")


def _entering(lane: LaneEnd) -> TravelLane:
    return TravelLane(lane.edge, lane.lane, lane.end == "end")


def _neighbors(
    lane: TravelLane, section: CrossSection, numbers: Mapping[TravelLane, int]
) -> tuple[int, ...]:
    """The lanes beside one in which traffic runs the same way, not across a solid line."""
    place = section.ids.index(lane.lane)
    lines = section.markings
    beside = [(place - 1, _between(lines, section, place - 1)),
              (place + 1, _between(lines, section, place))]  # fmt: skip
    found = []
    for other, line in beside:
        if 0 <= other < len(section.ids) and line in ("broken", "none"):
            number = numbers.get(TravelLane(lane.edge, section.ids[other], lane.backward))
            if number is not None:
                found.append(number)
    return tuple(found)


def _between(lines: tuple[str, ...], section: CrossSection, left: int) -> str:
    """The line between the lane at place `left` and the one to its right."""
    return lines[left + 1] if 0 <= left < len(section.ids) - 1 else "none"
