"""Straight on, for a length or until the lanes end."""

from __future__ import annotations

import pytest

from roadlang.geometry.routes.lane_graph import LaneGraph
from roadlang.geometry.routes.legs import PlannedRoute, RoutePlace
from roadlang.geometry.routes.walking import straight_on, straight_route
from tests.geometry.routes.test_routes import assert_drivable, graph_of, grid

GRAPH: LaneGraph = graph_of(grid())
PLACES = [
    RoutePlace(lane, GRAPH.begin[lane]) for lane in range(len(GRAPH.lanes)) if GRAPH.turns[lane]
]


def driven(route: PlannedRoute) -> float:
    turns = sum(leg.turn.length for leg in route.legs if leg.turn is not None)
    return turns + sum(abs(leg.stop - leg.start) for leg in route.legs)


@pytest.mark.parametrize("place", PLACES[::5])
def test_it_is_as_long_as_asked_for_where_the_lanes_go_on(place: RoutePlace) -> None:
    whole = list(straight_on(GRAPH, place))[:3]
    room = abs(whole[0].stop - whole[0].start)
    for length in (0.3 * room, room, room + 100.0):
        route = straight_route(GRAPH, place, length)
        assert_drivable(GRAPH, route)
        assert route.legs[0].start == place.station
        assert route.legs[-1].turn is None
        assert (len(route.legs) == 1) == (length <= room)
        if length <= room or route.legs[-1].stop != GRAPH.end[route.legs[-1].lane]:
            assert driven(route) == pytest.approx(length)


@pytest.mark.parametrize("place", PLACES[::5])
def test_at_a_junction_it_takes_the_turn_that_bends_least(place: RoutePlace) -> None:
    first = next(straight_on(GRAPH, place))
    assert first.turn in GRAPH.turns[place.lane]
    straight = [turn for turn in GRAPH.turns[place.lane] if turn.turn == "straight"]
    assert not straight or first.turn in straight
