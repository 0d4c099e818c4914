"""Where in a network copies begin: at random, near a point, where their route does, by another."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import evaluate
from ...geometry.arrays import Booleans, Floats, Integers
from ...geometry.routes.lane_graph import LaneGraph
from ...geometry.routes.legs import PlannedRoute, RoutePlace
from ...geometry.routes.nearest_lanes import NearRoads, near_roads
from ...geometry.routes.shortest import shortest_route
from ...ir.scenario import ScenarioActor
from ...ir.values import PassCall
from ..networks.lane_graphs import lanes_of_network
from ..roads.road_places import from_root
from .actor_numbers import column
from .begins_with_turns import begins_with_turns
from .copies import element_of
from .lane_choices import LaneChoice, allowed_lanes, is_for_vehicles, lane_choices
from .lane_places import is_on_side, lanes_by_word
from .network_walks import LaneWalks
from .positions import Others, names_another, row_distances
from .road_poses import LaneStart, WrittenPlace
from .route_points import FARTHEST, RoutePoints, route_points
from .route_positions import lane_places_of
from .routes import route_through, start_places
from .shares_of_lanes import at_share, within
from .spots import NoPlace, Spots


def begins_in_network(
    actor: ScenarioActor,
    copies: CopyBatch,
    written: WrittenPlace,
    lengths: Floats,
    others: Others,
) -> tuple[Integers, LaneStart, Floats, Integers]:
    """Numbers of roads (R,), where on them copies begin, the meters that are lacking where no lane
    is near, and `NoPlace`. `lengths` are those of the copies. Raises RL613."""
    network = copies.scenario.networks[str(actor.on)]
    lanes = lanes_of_network(network, copies.candidates)
    choices = lane_choices(actor, copies, written, lanes)
    found = Spots.of(copies.count, lanes.lanes[0].edge if lanes.lanes else 0)
    if names_another(actor, copies.scenario):
        walks = LaneWalks(actor, copies, lanes, lengths)
        walks.by_another(choices, written, others, found)
        _reach_points(actor, copies, lanes, found)
    else:
        first = copies
        if "spacing" in actor.options:
            first = copies.numbered(np.ones(copies.count, np.int64))
        finder = _Finder(actor, copies, first, lanes, lengths)
        for choice in dict.fromkeys(choices):
            index = np.flatnonzero([other == choice for other in choices])
            finder.place(choice, index, written, found)
    begin = LaneStart(found.start, found.lane, found.offset, found.backward, found.is_directed)
    return found.road, begin, found.lacking, found.no_place


def _reach_points(actor: ScenarioActor, copies: CopyBatch, lanes: LaneGraph, into: Spots) -> None:
    """Note from which places, which another has decided, no way leads through written points."""
    points = route_points(actor, copies, lanes)
    if points is None:
        return
    for row, place in enumerate(start_places(actor, into, lanes, copies)):
        # What stands in no lane, as another beside the road has it, has no route at all.
        if place is not None:
            found = route_through(lanes, place, points.stages(row))
            if not isinstance(found, PlannedRoute):
                into.no_place[row] = into.no_place[row] or NoPlace.NO_WAY


@dataclass(frozen=True, eq=False)
class _Finder:
    """Finds places in the network for copies of one statement; those of a row by its `first`."""

    actor: ScenarioActor
    copies: CopyBatch
    first: CopyBatch
    lanes: LaneGraph
    lengths: Floats

    def place(
        self, choice: LaneChoice | None, index: Integers, written: WrittenPlace, into: Spots
    ) -> None:
        """Fill in where the copies at `index` are, whose lane is chosen so."""
        if choice is None or not is_for_vehicles(choice, self.lanes):
            self._on_roads(choice, index, written, into)
            return
        allowed = allowed_lanes(self.actor, self.lanes, choice, self.copies)
        options: list[tuple[RoutePlace, ...]]
        if self.actor.at_fraction:
            lanes, stations = self._at_shares(sorted(allowed), index)
            if self._vias is None and self.first is self.copies:
                self._stand(index, lanes, stations, into)
                return
            places = zip(lanes.tolist(), stations.tolist(), strict=True)
            options = [(RoutePlace(lane, station),) for lane, station in places]
        elif isinstance(self.actor.at, PassCall):
            call, first = self.actor.at, self.first
            options = [
                lane_places_of(self.actor, call, first, row, self.lanes, allowed)
                for row in index.tolist()
            ]
        else:
            options = self._near_points(allowed, index, into)
        self._settle(index, options, into)

    @cached_property
    def _vias(self) -> RoutePoints | None:
        return route_points(self.actor, self.copies, self.lanes)

    @cached_property
    def _rows(self) -> list[list[float]]:
        return row_distances(self.actor, self.copies)

    def _settle(self, index: Integers, options: list[tuple[RoutePlace, ...]], into: Spots) -> None:
        """Fill in where each copy is, of the places that it may be at."""
        found: list[RoutePlace] = []
        for row, places in zip(index.tolist(), options, strict=True):
            stage = tuple(self._inside(place, row) for place in places)
            chosen, route = self._chosen(row, stage, into)
            found.append(chosen)
            if self.first is not self.copies:
                lacking, walks = into.lacking[row], self._walks
                walks.row_behind_first(row, chosen, route, self._rows[row], into)
                into.lacking[row] = max(into.lacking[row], lacking)
        if self.first is self.copies:
            lanes = np.array([place.lane for place in found], dtype=np.intp)
            self._stand(index, lanes, np.array([place.station for place in found]), into)

    def _chosen(
        self, row: int, stage: tuple[RoutePlace, ...], into: Spots
    ) -> tuple[RoutePlace, PlannedRoute | None]:
        """The place of a copy, and its route from there where it has to lead through points."""
        nearest = min(stage, key=lambda place: place.penalty)
        if self._vias is None:
            return nearest, None
        found = shortest_route(self.lanes, stage, self._vias.stages(row))
        into.lacking[row] = max(into.lacking[row], self._vias.beyond(row))
        if not isinstance(found, PlannedRoute):
            into.no_place[row] = NoPlace.NO_WAY
            return nearest, None
        return RoutePlace(found.legs[0].lane, found.legs[0].start), found

    def _stand(self, index: Integers, lanes: Integers, stations: Floats, into: Spots) -> None:
        """Fill in copies at `index` (n,) that stand in lanes at arc lengths of their edges."""
        named = [self.lanes.lanes[lane] for lane in lanes.tolist()]
        edges = np.array([lane.edge for lane in named])
        into.road[index], into.lane[index] = edges, [lane.lane for lane in named]
        into.backward[index], into.is_directed[index] = [lane.backward for lane in named], True
        for edge in np.unique(edges).tolist():
            chosen = edges == edge
            into.start[index[chosen]] = self._from_root(edge, index[chosen], stations[chosen])

    @cached_property
    def _walks(self) -> LaneWalks:
        return LaneWalks(self.actor, self.copies, self.lanes, self.lengths)

    def _inside(self, place: RoutePlace, row: int) -> RoutePlace:
        """With both bumpers in the lane, as far as it is long enough."""
        ends = self.lanes.begin[place.lane], self.lanes.end[place.lane]
        half = min(self.lengths[row], abs(ends[1] - ends[0])) / 2.0
        station = min(max(place.station, min(ends) + half), max(ends) - half)
        return RoutePlace(place.lane, station, place.penalty)

    def _at_shares(self, allowed: list[int], index: Integers) -> tuple[Integers, Floats]:
        """At a share of the length of all lanes together from which their routes can be driven:
        lanes (n,) and arc lengths there, with both bumpers in the lane, as far as it is long
        enough."""
        lanes, stations = np.zeros(len(index), np.intp), np.zeros(len(index))
        shares = self._shares()[index]
        route = route_points(self.actor, self.first, self.lanes)
        for leading, part in begins_with_turns(self.lanes, allowed, route, index):
            ends = np.array([(self.lanes.begin[lane], self.lanes.end[lane]) for lane in leading])
            numbers, at = at_share(shares[part], ends)
            lanes[part] = np.array(leading)[numbers]
            stations[part] = within(ends[numbers], at, self.lengths[index[part]])
        return lanes, stations

    def _shares(self) -> Floats:
        return column(evaluate(self.actor.at, self.first, element_of(self.actor)), self.first)

    def _points(self) -> Floats:
        """(R, 2) meters."""
        parts = evaluate(self.actor.at, self.first, element_of(self.actor))
        return np.stack([column(part, self.first) for part in parts], axis=-1)

    def _near_points(
        self, allowed: frozenset[int], index: Integers, into: Spots
    ) -> list[tuple[RoutePlace, ...]]:
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
        self, choice: LaneChoice | None, index: Integers, written: WrittenPlace, into: Spots
    ) -> None:
        """On roads rather than in lanes for vehicles: beside, astride, or in a lane of a kind."""
        graph = self.lanes
        edges, on_left = list(graph.of_edge), None
        if choice is not None:
            edges = [edge for edge in edges if self._has_lane(edge, choice)] or edges
        lanes = [graph.of_edge[edge][0] for edge in edges]
        ends = [sorted((graph.begin[lane], graph.end[lane])) for lane in lanes]
        if self.actor.at_fraction:
            numbers, station = at_share(self._shares()[index], ends)
            if choice is not None:  # what stands in a lane does so with its whole length
                station = within(np.array(ends)[numbers], station, self.lengths[index])
        elif isinstance(self.actor.at, PassCall):
            numbers, station = self._beside_lanes(edges, index)
        else:
            near = near_roads(graph, self._points()[index])
            rows = [near.edges.index(edge) for edge in edges]
            numbers = np.argmin(near.distance[rows], axis=0)
            each = np.arange(len(index))
            station = near.station[rows][numbers, each]
            beyond = near.distance[rows][numbers, each] - FARTHEST
            into.lacking[index] = np.maximum(beyond, 0.0)
            on_left = self._on_left(np.array(edges)[numbers], index)
        into.road[index] = np.array(edges)[numbers]
        for road in np.unique(into.road[index]).tolist():
            chosen = into.road[index] == road
            into.start[index[chosen]] = self._from_root(road, index[chosen], station[chosen])
            if choice is not None:
                part, facing = self.copies.chosen(index[chosen]), written.facing[index[chosen]]
                name, kind = f"{self.actor.on}/{road}", str(choice[0])
                sides = written.side[index[chosen]]
                ids = lanes_by_word(name, self.actor, part, kind, facing == "back", sides)
                if on_left is not None:  # a point is on one side of the road
                    other = lanes_by_word(name, self.actor, part, kind, facing != "back", sides)
                    crosses = ((ids > 0) != on_left[chosen]) & ((other > 0) == on_left[chosen])
                    ids = np.where(crosses & (facing == ""), other, ids)
                into.lane[index[chosen]] = ids
        if self.first is not self.copies:
            away = np.array([self._rows[row][-1] for row in index.tolist()])
            into.start[index] += away

    def _has_lane(self, edge: int, choice: LaneChoice) -> bool:
        lanes = self.lanes.sections[edge].lanes
        return any(lane.kind == choice[0] and is_on_side(lane.id, choice[2]) for lane in lanes)

    def _on_left(self, edges: Integers, index: Integers) -> Booleans:
        """(n,) whether the points of copies lie left of the lines of roads."""
        points, on_left = self._points()[index], np.zeros(len(index), dtype=bool)
        for edge in np.unique(edges).tolist():
            chosen, curve = edges == edge, self.lanes.edges[edge].curve
            station = curve.project(points[chosen])[0]
            aside = points[chosen] - curve.at(station)
            on_left[chosen] = (aside * curve.normal(station)).sum(axis=-1) > 0.0
        return on_left

    def _beside_lanes(self, edges: list[int], index: Integers) -> tuple[Integers, Floats]:
        """Which of some roads, and where on them, a position among their lanes (`junction(1)`) is.
        Raises RL613 where it is on none of them."""
        call, lanes = self.actor.at, self.lanes
        assert isinstance(call, PassCall)
        allowed = frozenset(n for n, lane in enumerate(lanes.lanes) if lane.edge in edges)
        places = [
            lane_places_of(self.actor, call, self.first, row, lanes, allowed)[0]
            for row in index.tolist()
        ]
        numbers = [edges.index(lanes.lanes[place.lane].edge) for place in places]
        return np.array(numbers), np.array([place.station for place in places])

    def _from_root(self, road: int, index: Integers, station: Floats) -> Floats:
        name, rows = f"{self.actor.on}/{road}", self.copies.rows[index]
        return from_root(name, self.copies.candidates, rows, station)


def _nearest_allowed(
    near: NearRoads, lanes: LaneGraph, point: int, allowed: frozenset[int]
) -> tuple[RoutePlace, ...]:
    """On the nearest road that has such a lane."""
    places = [
        (float(near.distance[number, point]), RoutePlace(lane, float(near.station[number, point])))
        for number, edge in enumerate(near.edges)
        for lane in lanes.of_edge[edge]
        if lane in allowed
    ]
    return (min(places, key=lambda item: item[0])[1],)
