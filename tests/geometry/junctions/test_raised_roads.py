"""Roads that pass over others rise to their level, and are on the ground where they join it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.geometry import RoadNetwork, network_of_polylines
from roadlang.geometry.junctions.raised_roads import LEVEL_HEIGHT, with_heights

NORTH, SOUTH, OFF = (0.0, 200.0), (0.0, -200.0), (0.0, 120.0)
WEST, EAST, ON = (-200.0, 0.0), (200.0, 0.0), (120.0, 0.0)


def network(lines: list[list[tuple[float, float]]], *levels: int) -> RoadNetwork:
    found = network_of_polylines(lines, 7.0)
    edges = zip(found.edges, levels, strict=True)
    return replace(found, edges=tuple(replace(edge, level=level) for edge, level in edges))


def height(network: RoadNetwork, edge: int, *at: float) -> list[float]:
    found: Any = network.edges[edge].elevations
    length = network.edges[edge].length
    stations = np.linspace(0.0, length, len(found))
    return [round(float(value), 2) for value in np.interp(at, stations, found)]


@pytest.mark.parametrize("level", [1, 2, -1])
def test_a_road_is_at_its_level_where_it_passes_another(level: int) -> None:
    found = with_heights(network([[WEST, EAST], [NORTH, SOUTH]], 0, level))
    assert found.edges[0].elevations is None
    assert height(found, 1, 190.0, 200.0, 210.0) == [LEVEL_HEIGHT * level] * 3


def test_it_is_on_the_ground_where_roads_of_the_ground_meet_it() -> None:
    """The bridge goes on as a road of the ground at both ends, 80 m from what it passes."""
    ends = (0.0, 80.0), (0.0, -80.0)
    lines = [[WEST, EAST], [NORTH, ends[0]], list(ends), [ends[1], SOUTH]]
    found = with_heights(network(lines, 0, 0, 1, 0))
    assert [edge.elevations is None for edge in found.edges] == [True, True, False, True]
    assert height(found, 2, 0.0, 10.0, 80.0, 150.0, 160.0) == [0.0, 0.0, LEVEL_HEIGHT, 0.0, 0.0]
    (low, high) = height(found, 2, 30.0, 60.0)
    assert 0.0 < low < high < LEVEL_HEIGHT


def test_a_ramp_leads_from_the_bridge_to_the_ground() -> None:
    lines = [[WEST, ON], [ON, EAST], [NORTH, OFF], [OFF, SOUTH], [OFF, ON]]
    found = with_heights(network(lines, 0, 0, 1, 1, 0))
    length = found.edges[4].length
    ends = height(found, 4, 0.0, length)
    assert ends == [LEVEL_HEIGHT, 0.0]
    heights: Any = found.edges[4].elevations
    assert (np.diff(heights) <= 0.0).all()
    assert np.abs(np.diff(heights)).max() * (len(heights) - 1) / length < 0.1


def test_maps_on_one_level_and_maps_with_heights_stay_as_they_are() -> None:
    flat = network([[WEST, EAST], [NORTH, SOUTH]], 0, 0)
    assert with_heights(flat) is flat
    levels = network([[WEST, EAST], [NORTH, SOUTH]], 0, 1)
    edges = (replace(levels.edges[0], elevations=np.zeros(2)), levels.edges[1])
    known = replace(levels, edges=edges)
    assert with_heights(known) is known
