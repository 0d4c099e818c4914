"""Places a distance ahead or behind along lanes, round corners, never inside a junction."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from .lane_graph import LaneGraph, Turn
from .legs import Leg, PlannedRoute, RoutePlace
from .next_turns import Way, is_in_ring, ways_on

MeasureLane = Callable[[int, float, float], float]
"""Meters along a lane of the graph between two arc lengths of its edge, as the road is bent"""
_MOST_PARTS = 1_000
_STRAIGHTNESS = {"straight": 0, "right": 1, "left": 1, "u": 2}


@dataclass(frozen=True, slots=True)
class WalkPart:
    """A part of a lane, in the direction of the walk, and the meters from its end to the next."""

    lane: int
    start: float
    stop: float
    gap: float


@dataclass(frozen=True, slots=True)
class Reached:
    """`along` meters from where a part begins; `lacking` meters are missing at the end of the
    lanes."""

    part: WalkPart
    along: float
    lacking: float = 0.0


def straight_on(graph: LaneGraph, place: RoutePlace) -> Iterator[Leg]:
    """From a place on, straight ahead at junctions where that is possible, of which a roundabout
    is one."""
    for _ in range(_MOST_PARTS):
        through = _through_roundabout(graph, place)
        if through is not None:
            yield from through.legs
            place = through.end
            continue
        turn = _straightest(graph.turns[place.lane])
        yield Leg(place.lane, place.station, graph.end[place.lane], turn)
        if turn is None:
            return
        place = RoutePlace(turn.target, graph.begin[turn.target])


def _through_roundabout(graph: LaneGraph, place: RoutePlace) -> Way | None:
    """The straightest way through a roundabout that begins where the lane ends; None if there is
    none, or none without a change of lane."""
    ends_at_ring = any(is_in_ring(graph, turn.target) for turn in graph.turns[place.lane])
    if not ends_at_ring or is_in_ring(graph, place.lane):
        return None
    ways = [
        way
        for way in ways_on(graph, place)
        if way.legs[0].lane == place.lane and all(leg.turn is not None for leg in way.legs)
    ]
    return min(ways, key=lambda way: _STRAIGHTNESS[way.turn], default=None)


def straight_route(graph: LaneGraph, place: RoutePlace, length: float) -> PlannedRoute:
    """Straight on for `length` meters, or until the lanes end."""
    legs: list[Leg] = []
    left = length
    for leg in straight_on(graph, place):
        room = abs(leg.stop - leg.start)
        if room >= left:
            step = left if graph.forward(leg.lane) else -left
            legs.append(Leg(leg.lane, leg.start, leg.start + step))
            break
        legs.append(leg)
        left = max(left - room - (leg.turn.length if leg.turn else 0.0), 0.0)
    return PlannedRoute((*legs[:-1], replace(legs[-1], turn=None)), length)


def parts_ahead(
    graph: LaneGraph, place: RoutePlace, route: PlannedRoute | None
) -> Iterator[WalkPart]:
    """The way on from a place: in its lane to the end of the road, then as the route leads."""
    lane, station = place.lane, place.station
    turns = _turns_of(graph, place, route)
    for turn in turns:
        yield WalkPart(lane, station, graph.end[lane], 0.0 if turn is None else turn.length)
        if turn is None:
            return
        lane, station = turn.target, graph.begin[turn.target]


def parts_behind(graph: LaneGraph, place: RoutePlace) -> Iterator[WalkPart]:
    """The way back from a place, straight where that is possible."""
    lane, station = place.lane, place.station
    for _ in range(_MOST_PARTS):
        source = _straightest_source(graph.sources[lane])
        gap = 0.0 if source is None else source[1].length
        yield WalkPart(lane, station, graph.begin[lane], gap)
        if source is None:
            return
        lane, station = source[0], graph.end[source[0]]


def walked(
    parts: Iterator[WalkPart], distances: Sequence[float], half: float, measure: MeasureLane
) -> Reached:
    """Where something `2 half` long is that stands the last of `distances` from the beginning.

    Each of them is where another of a row stands. What would be in a junction stands beyond it, and
    whatever follows in the row as much farther. Lanes that are too short are passed over.
    """
    part = next(parts)
    length, at, done = measure(part.lane, part.start, part.stop), 0.0, 0.0
    for distance in distances:
        at += distance - done
        done = distance
        while at > length - half:
            following = next(parts, None)
            if following is None:
                return Reached(part, max(length - half, 0.0), at - (length - half))
            at -= length + part.gap
            part = following
            length = measure(part.lane, part.start, part.stop)
            at = max(at, half)
    return Reached(part, at)


def _turns_of(
    graph: LaneGraph, place: RoutePlace, route: PlannedRoute | None
) -> Iterator[Turn | None]:
    if route is None:
        yield from (leg.turn for leg in straight_on(graph, place))
        return
    legs = list(following_legs(graph, place, route))
    yield from (leg.turn for leg in legs if leg.turn is not None)
    last = legs[-1] if legs else None
    if last is None or last.turn is None:
        goal = place if last is None else RoutePlace(last.lane, last.start)
        yield from (leg.turn for leg in straight_on(graph, goal))


def following_legs(graph: LaneGraph, place: RoutePlace, route: PlannedRoute) -> tuple[Leg, ...]:
    """The legs of a route from the road of a place on; all of them, if it is on none of them."""
    roads = graph.carriageways[place.lane]
    for number, leg in enumerate(route.legs):
        ahead = leg.stop - place.station if graph.forward(leg.lane) else place.station - leg.stop
        if leg.lane in roads and (ahead >= 0.0 or leg.turn is not None):
            return route.legs[number:]
    return route.legs


def _straightest(turns: Sequence[Turn]) -> Turn | None:
    return min(turns, key=lambda turn: _STRAIGHTNESS[turn.turn], default=None)


def _straightest_source(sources: Sequence[tuple[int, Turn]]) -> tuple[int, Turn] | None:
    best = _straightest([turn for _, turn in sources])
    return next((source for source in sources if source[1] is best), None)
