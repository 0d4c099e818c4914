"""Where in a network copies begin: at random, near a point, or where their route does."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..geometry.arrays import Floats, Integers
from ..geometry.routes.lane_graph import LaneGraph
from ..geometry.routes.nearest_lanes import NearRoads, near_roads
from ..geometry.routes.shortest import LanePlace, PlannedRoute, shortest_route
from ..ir.scenario import ScenarioActor
from .copies import element_of
from .lane_choices import LaneChoice, allowed_lanes, lane_choices
from .lane_graphs import lanes_of_network
from .lane_places import lanes_by_word
from .positions import Others, column
from .road_places import from_root
from .road_poses import LaneStart, WrittenPlace
from .route_points import FARTHEST, route_points

_ROOM = 12.0
"""Meters of a lane that is long enough to begin in at random, where there are such"""
UNREACHED = 1.0
"""What is lacking where no way leads through the points of a route, as if in meters"""


@dataclass(frozen=True, eq=False)
class _Spots:
    """Where copies (R,) begin: arc lengths of the root; `lane` 0 for none."""

    road: Integers
    station: Floats
    lane: Integers
    backward: NDArray[np.bool_]
    lacking: Floats
    """meters beyond `FARTHEST` that a point is from every lane, or `UNREACHED`; else 0"""


def begins_in_network(
    actor: ScenarioActor,
    copies: CopyBatch,
    said: WrittenPlace,
    lengths: Floats,
    others: Others,
) -> tuple[Integers, LaneStart, Floats]:
    """Numbers of roads (R,), where on them copies begin, and what is lacking where no lane is near
    or no way leads on. `lengths` are those of the copies. Raises RL613."""
    network = copies.scenario.networks[str(actor.on)]
    lanes = lanes_of_network(network, copies.candidates)
    choices = lane_choices(actor, copies, said)
    finder = _Finder(actor, copies, lanes, lengths)
    found = _Spots(
        np.zeros(copies.count, np.int64),
        np.zeros(copies.count),
        np.zeros(copies.count, np.int64),
        np.zeros(copies.count, dtype=bool),
        np.zeros(copies.count),
    )
    for choice in dict.fromkeys(choices):
        index = np.flatnonzero([other == choice for other in choices])
        finder.place(choice, index, said, found)
    start = np.empty(copies.count)
    for road in np.unique(found.road).tolist():
        chosen = np.flatnonzero(found.road == road)
        name, rows = f"{actor.on}/{road}", copies.rows[chosen]
        start[chosen] = from_root(name, copies.candidates, rows, found.station[chosen])
    is_directed = found.lane != 0
    begin = LaneStart(start, found.lane, np.zeros(copies.count), found.backward, is_directed)
    return found.road, begin, found.lacking


@dataclass(frozen=True, eq=False)
class _Finder:
    """Finds places in the network for copies of one statement."""

    actor: ScenarioActor
    copies: CopyBatch
    lanes: LaneGraph
    lengths: Floats

    def place(
        self, choice: LaneChoice | None, index: Integers, said: WrittenPlace, into: _Spots
    ) -> None:
        """Fill in where the copies at `index` are, whose lane is chosen so."""
        in_graph = choice is not None and self._has_lanes(choice)
        if choice is None or not in_graph:
            self._on_roads(choice, index, said, into)
            return
        allowed = allowed_lanes(self.actor, self.lanes, choice, self.copies)
        options: list[tuple[LanePlace, ...]]
        if self.actor.at_fraction:
            options = [(place,) for place in self._at_shares(sorted(allowed), index)]
        else:
            options = self._near_points(allowed, index, into)
        vias = route_points(self.actor, self.copies)
        for row, stage in zip(index.tolist(), options, strict=True):
            self._settle(row, tuple(self._inside(place, row) for place in stage), vias, into)

    def _settle(self, row: int, stage: Any, vias: Any, into: _Spots) -> None:
        chosen = min(stage, key=lambda place: place.penalty)
        if vias is not None:
            found = shortest_route(self.lanes, [stage, *vias.stages(self.lanes, row)])
            if isinstance(found, PlannedRoute):
                chosen = LanePlace(found.legs[0].lane, found.legs[0].start)
            else:
                into.lacking[row] = max(into.lacking[row], UNREACHED)
            into.lacking[row] = max(into.lacking[row], vias.beyond(self.lanes, row))
        lane = self.lanes.lanes[chosen.lane]
        into.road[row], into.station[row] = lane.edge, chosen.station
        into.lane[row], into.backward[row] = lane.lane, lane.backward

    def _inside(self, place: LanePlace, row: int) -> LanePlace:
        """With both bumpers in the lane, as far as it is long enough."""
        ends = self.lanes.begin[place.lane], self.lanes.end[place.lane]
        half = min(self.lengths[row], abs(ends[1] - ends[0])) / 2.0
        station = min(max(place.station, min(ends) + half), max(ends) - half)
        return LanePlace(place.lane, station, place.penalty)

    def _has_lanes(self, choice: LaneChoice) -> bool:
        """Whether it is about lanes for vehicles, not a kind such as `parking`."""
        if isinstance(choice[0], int) or choice[0] in ("any", "outer"):
            return True
        graph = self.lanes
        return any(
            graph.sections[lane.edge].lane(lane.lane).kind == choice[0] for lane in graph.lanes
        )

    def _at_shares(self, allowed: list[int], index: Integers) -> list[LanePlace]:
        """A share of the length of all lanes together."""
        ends = [(self.lanes.begin[lane], self.lanes.end[lane]) for lane in allowed]
        numbers, stations = _at_share(self._shares()[index], ends)
        return [
            LanePlace(allowed[number], station)
            for number, station in zip(numbers.tolist(), stations.tolist(), strict=True)
        ]

    def _shares(self) -> Floats:
        return column(evaluate(self.actor.at, self.copies, element_of(self.actor)), self.copies)

    def _points(self) -> Floats:
        """(R, 2) meters."""
        parts = evaluate(self.actor.at, self.copies, element_of(self.actor))
        return np.stack([column(part, self.copies) for part in parts], axis=-1)

    def _near_points(
        self, allowed: frozenset[int], index: Integers, into: _Spots
    ) -> list[tuple[LanePlace, ...]]:
        points, which = np.unique(self._points()[index], axis=0, return_inverse=True)
        near = near_roads(self.lanes, points)
        into.lacking[index] = np.maximum(near.distance.min(axis=0) - FARTHEST, 0.0)[which.ravel()]
        found = [
            near.options(self.lanes, point, allowed.__contains__)
            or _nearest_allowed(near, self.lanes, point, allowed)
            for point in range(len(points))
        ]
        return [found[number] for number in which.ravel().tolist()]

    def _on_roads(
        self, choice: LaneChoice | None, index: Integers, said: WrittenPlace, into: _Spots
    ) -> None:
        """On roads rather than in lanes for vehicles: beside, astride, or in a lane of a kind."""
        graph = self.lanes
        edges = list(graph.of_edge)
        if choice is not None:
            kinds = {edge: [lane.kind for lane in graph.sections[edge].lanes] for edge in edges}
            edges = [edge for edge in edges if choice[0] in kinds[edge]] or edges
        if self.actor.at_fraction:
            lanes = [graph.of_edge[edge][0] for edge in edges]
            ends = [sorted((graph.begin[lane], graph.end[lane])) for lane in lanes]
            numbers, into.station[index] = _at_share(self._shares()[index], ends)
            into.road[index] = np.array(edges)[numbers]
        else:
            near = near_roads(graph, self._points()[index])
            rows = [near.edges.index(edge) for edge in edges]
            numbers = np.argmin(near.distance[rows], axis=0)
            each = np.arange(len(index))
            into.road[index] = np.array(edges)[numbers]
            into.station[index] = near.station[rows][numbers, each]
            beyond = near.distance[rows][numbers, each] - FARTHEST
            into.lacking[index] = np.maximum(beyond, 0.0)
        if choice is not None:
            self._in_lanes_of_kind(str(choice[0]), index, said, into)

    def _in_lanes_of_kind(
        self, kind: str, index: Integers, said: WrittenPlace, into: _Spots
    ) -> None:
        for road in np.unique(into.road[index]).tolist():
            chosen = index[into.road[index] == road]
            part, against = self.copies.chosen(chosen), said.facing[chosen] == "back"
            name = f"{self.actor.on}/{road}"
            into.lane[chosen] = lanes_by_word(name, self.actor, part, kind, against)


def _at_share(shares: Floats, ends: Any) -> tuple[Integers, Floats]:
    """Which of several lanes (n,), and the arc length there, at shares of their whole length; of
    those that are long enough, where there are such."""
    begin, end = np.array(ends, float).T
    lengths = np.abs(end - begin)
    counted = np.where(lengths >= _ROOM, lengths, 0.0) if (lengths >= _ROOM).any() else lengths
    sums = np.concatenate([[0.0], np.cumsum(counted)])
    at = np.clip(shares, 0.0, 1.0) * sums[-1]
    numbers = np.clip(np.searchsorted(sums, at, side="right") - 1, 0, len(lengths) - 1)
    while (counted[numbers] == 0.0).any():
        numbers = np.where(counted[numbers] == 0.0, numbers - 1, numbers)
    share = np.clip((at - sums[numbers]) / counted[numbers], 0.0, 1.0)
    return numbers, begin[numbers] + share * (end - begin)[numbers]


def _nearest_allowed(
    near: NearRoads, lanes: LaneGraph, point: int, allowed: frozenset[int]
) -> tuple[LanePlace, ...]:
    """On the nearest road that has such a lane."""
    places = [
        (float(near.distance[number, point]), LanePlace(lane, float(near.station[number, point])))
        for number, edge in enumerate(near.edges)
        for lane in lanes.of_edge[edge]
        if lane in allowed
    ]
    return (min(places, key=lambda item: item[0])[1],)
