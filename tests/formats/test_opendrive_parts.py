"""Where roads of a scene are cut for OpenDRIVE, and the pieces at their ends."""

from __future__ import annotations

import itertools
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang_formats.opendrive.carriageways import left_hand_carriageways
from roadlang_formats.opendrive.road_parts import road_parts

LOOP = """road main {
  draw with waypoints { points: [(0m, 0m), (110m, 0m), (110m, 30m), (0m, 30m)] }, closed: true
}"""
WAVES = """road main {
  draw with segments { pieces: [straight(60m)] }
  perturb with sine { amplitude: 1m, wavelength: 14m }
}"""


def test_loops_are_cut_where_they_are_straight() -> None:
    """netconvert makes a node, and shortens both roads, where one bends on into another."""
    scene = testing.sample(LOOP)[0].record
    parts = road_parts(scene, 0.005, "rule")
    assert len(parts) == 3
    ends = [part.stations[-1] + np.array([-3.0, 3.0]) for part in parts[:-1]]
    turned = [np.diff(part.pose(end)[:, 2]) for part, end in zip(parts, ends, strict=False)]
    assert np.abs(turned).max() < 0.05
    pairs = itertools.pairwise(parts)
    assert all(one.stations[-1] == other.stations[0] for one, other in pairs)


@pytest.mark.parametrize("beyond", [0.03, 0.09])
def test_no_piece_at_the_end_of_a_road_is_very_short(beyond: float) -> None:
    """netconvert takes cubics of less than 0.1 m twice."""
    scene = testing.sample(WAVES)[0].record
    (road,) = scene.roads
    trims = road.stations[3] - beyond, road.length - road.stations[-4] - beyond
    (part,) = road_parts(replace(scene, roads=(replace(road, trim=trims),)), 0.005, "rule")
    assert min(piece.length for piece in part.line.pieces) > 0.2
    assert part.line.length == pytest.approx(road.length - sum(trims), rel=2e-3)


@pytest.mark.parametrize(
    ("directions", "count"),
    [
        (("forward", "forward", "backward", "backward"), 2),
        (("forward", "backward", "backward", "backward"), 2),
        (("forward", "forward", "forward", "forward"), 1),
        (("forward", "forward", "backward", "forward"), 0),
    ],
)
def test_roads_in_left_hand_traffic_are_a_carriageway_for_each_direction(
    directions: tuple[Any, ...], count: int
) -> None:
    """None where lanes run against the traffic beside them."""
    text = "world { traffic: left }\nroad main { draw with segments { pieces: [straight(60m)] }, "
    (road,) = testing.sample(text + "lanes: 4 }")[0].record.roads
    pairs = zip(road.lane_list, directions, strict=True)
    lanes = tuple(replace(lane, direction=direction) for lane, direction in pairs)
    assert len(left_hand_carriageways(replace(road, lane_list=lanes))) == count
