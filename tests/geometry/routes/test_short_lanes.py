"""Routes through streets that are shorter than what is driven beyond the last turn."""

from __future__ import annotations

import pytest

from roadlang.geometry import network_of_polylines
from roadlang.geometry.routes.legs import RoutePlace
from roadlang.geometry.routes.random_routes import random_route
from tests.geometry.routes.test_routes import assert_drivable, graph_of, grid


@pytest.mark.parametrize("number", [0.1, 0.5, 0.9])
def test_a_random_route_ends_where_its_length_does_also_in_short_streets(number: float) -> None:
    graph = graph_of(grid(4, block=24.0, width=6.0))
    assert max(graph.length(lane) for lane in range(len(graph.lanes))) < 20.0
    route = random_route(graph, RoutePlace(0, graph.begin[0]), 200.0, number)
    assert_drivable(graph, route)
    driven = sum(abs(leg.stop - leg.start) for leg in route.legs)
    turned = sum(leg.turn.length for leg in route.legs if leg.turn is not None)
    assert 180.0 < driven + turned < 240.0


def test_a_random_route_does_not_end_in_a_junction() -> None:
    graph = graph_of(network_of_polylines([[(0, 0), (60, 0), (120, 0)], [(60, 0), (60, 90)]], 7.0))
    for length in range(20, 90, 3):
        route = random_route(graph, RoutePlace(0, graph.begin[0]), float(length), 0.4)
        last = route.legs[-1]
        assert last.turn is None
        assert abs(last.stop - last.start) >= 20.0 or len(route.legs) == 1
