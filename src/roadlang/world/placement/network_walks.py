"""Copies in a network that are placed along lanes: by another one, or in a row."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...evaluate.copies import CopyBatch
from ...geometry.arrays import Floats
from ...geometry.routes.lane_graph import LaneGraph, TravelLane
from ...geometry.routes.legs import PlannedRoute, RoutePlace
from ...geometry.routes.walking import WalkPart, parts_ahead, parts_behind, walked
from ...ir.scenario import ScenarioActor
from ..roads.road_places import from_root, to_root
from .lane_choices import LaneChoice
from .lane_places import lanes_by_word
from .positions import Others, row_distances, standing_beside
from .road_poses import WrittenPlace
from .routes import leading_routes
from .spots import NoPlace, Spots


@dataclass(frozen=True, eq=False)
class LaneWalks:
    """Walks along the lanes of a network for the copies of one statement."""

    actor: ScenarioActor
    copies: CopyBatch
    lanes: LaneGraph
    lengths: Floats

    def by_another(
        self,
        choices: Sequence[LaneChoice | None],
        written: WrittenPlace,
        others: Others,
        into: Spots,
    ) -> None:
        """Ahead of, behind or beside another, in its lane or in one of `choices` (R)."""
        other, standing = standing_beside(self.actor, self.copies, others)
        routes = leading_routes(self.actor, self.copies, others)
        rows = row_distances(self.actor, self.copies)
        numbers = {lane: number for number, lane in enumerate(self.lanes.lanes)}
        for row, choice in enumerate(choices):
            road, backward = int(other.road[row, 0]), bool(standing.backward[row, 0])
            if road < 0:
                into.no_place[row] = NoPlace.NO_OTHER
                continue
            lane = self._written_lane(row, road, choice, backward, written)
            said, lane = lane is not None, int(standing.lane[row, 0]) if lane is None else lane
            start, target = float(other.start[row, 0]), float(standing.start[row, 0])
            away = start - target if backward else target - start
            number, route = numbers.get(TravelLane(road, lane, backward)), None
            if number is not None:
                route = routes[row] if routes is not None else None
            elif said:  # the lane of oncoming traffic: toward where it comes from
                number, away = numbers.get(TravelLane(road, lane, not backward)), -away
            if number is None:
                target += rows[row][-1] * (-1.0 if target < start else 1.0)
                into.stand(row, road, target, lane, float(standing.offset[row, 0]), backward)
                into.is_directed[row] = not (said and lane)
                into.lacking[row] = self._beyond(row, road, target)
                continue
            place = RoutePlace(number, self._to_root(row, number, start))
            self._walk(row, place, away, rows[row], route, into)

    def _written_lane(
        self,
        row: int,
        road: int,
        choice: LaneChoice | None,
        backward: bool,
        written: WrittenPlace,
    ) -> int | None:
        """The lane that the statement itself says; None for that of the other, 0 for none."""
        if self.actor.is_beside_road:
            return 0
        if "lane" not in self.actor.options:
            return None
        said = 0 if choice is None else choice[0]
        if isinstance(said, int):
            return said
        one, name = np.array([row]), f"{self.actor.on}/{road}"
        against = np.array([backward != (written.facing[row] == "back")])
        part, sides = self.copies.chosen(one), written.side[one]
        return int(lanes_by_word(name, self.actor, part, said, against, sides)[0])

    def row_behind_first(self, row: int, place: RoutePlace, route: PlannedRoute | None,
                         distances: Sequence[float], into: Spots) -> None:  # fmt: skip
        """One of a row (`spacing`) whose first stands at a place."""
        self._walk(row, place, 0.0, distances, route, into)

    def _walk(
        self,
        row: int,
        place: RoutePlace,
        away: float,
        distances: Sequence[float],
        route: PlannedRoute | None,
        into: Spots,
    ) -> None:
        # A row that is placed by another goes on away from it; any other goes ahead.
        ahead = away > 0.0 or (away == 0.0 and distances[-1] >= 0.0)
        sign = 1.0 if away != 0.0 or ahead else -1.0
        parts: Iterator[WalkPart]
        parts = parts_ahead(self.lanes, place, route) if ahead else parts_behind(self.lanes, place)

        def measure(lane: int, start: float, stop: float) -> float:
            ends = self._from_root(row, lane, (start, stop))
            return abs(ends[1] - ends[0])

        steps = [abs(away) + sign * distance for distance in distances]
        found = walked(parts, steps, float(self.lengths[row]) / 2.0, measure)
        lane = self.lanes.lanes[found.part.lane]
        begin = self._from_root(row, found.part.lane, (found.part.start,))[0]
        forward = lane.backward != ahead
        at = begin + found.along if forward else begin - found.along
        into.stand(row, lane.edge, at, lane.lane, 0.0, lane.backward)
        into.lacking[row] = max(found.lacking, -min(steps))

    def _beyond(self, row: int, road: int, start: float) -> float:
        """Meters beyond the ends of a road outside the junctions."""
        lane = self.lanes.of_edge[road][0]
        ends = self._from_root(row, lane, (self.lanes.begin[lane], self.lanes.end[lane]))
        return max(min(ends) - start, start - max(ends), 0.0)

    def _from_root(self, row: int, lane: int, stations: Sequence[float]) -> list[float]:
        name = f"{self.actor.on}/{self.lanes.lanes[lane].edge}"
        which = np.full(len(stations), self.copies.rows[row])
        found: list[float] = from_root(
            name, self.copies.candidates, which, np.array(stations)
        ).tolist()
        return found

    def _to_root(self, row: int, lane: int, at: float) -> float:
        name = f"{self.actor.on}/{self.lanes.lanes[lane].edge}"
        which = self.copies.rows[row : row + 1]
        return float(to_root(name, self.copies.candidates, which, np.array([at]))[0])
