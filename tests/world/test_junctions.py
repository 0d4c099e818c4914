"""Junctions of networks in scenes: frozen for all variants, exact at the faces of the roads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]
TOWN = '''
image plan from """
  ....#.......#....
  #################
  ....#.......#....
  ....#.......#....
""" { scale: 8m/px, legend: { "#": road } }
network town from plan { extract with pixels }
'''
BENT = "network bent from town { perturb with sine { amplitude: 0.5m..2m, wavelength: 40m..80m } }"


def roads_of(scene: Scene, network: str) -> dict[int, SceneRoad]:
    return {road.edge: road for road in scene.roads if road.network == network and road.edge}


def test_all_variants_of_a_network_share_its_junctions(sample: Sample) -> None:
    scenes = sample(TOWN + BENT, n=4).scenes
    plans = [network.junctions for scene in scenes for network in scene.networks]
    assert len(plans[0]) >= 2
    named = {repr(plan).replace("bent/", "town/") for plan in plans}
    assert len(named) == 1
    assert repr([r.y for r in scenes[0].roads]) != repr([r.y for r in scenes[1].roads])


def test_no_road_is_moved_before_its_trim_and_all_are_beyond(sample: Sample) -> None:
    scene = sample(TOWN + BENT).scenes[0]
    town, bent = roads_of(scene, "town"), roads_of(scene, "bent")
    assert any(any(road.trim) for road in town.values())
    for edge, root in town.items():
        road = bent[edge]
        s = np.array(root.reference_stations)
        inside = (s <= root.trim[0] + 1e-9) | (s >= s[-1] - root.trim[1] - 1e-9)
        at_junction = inside & ((s <= root.trim[0]) == (root.trim[0] > 0))
        moved = np.hypot(np.subtract(road.x, root.x), np.subtract(road.y, root.y))
        if root.trim[0]:
            assert moved[s <= root.trim[0]].max() == 0.0
        if root.trim[1]:
            assert moved[s >= s[-1] - root.trim[1]].max() == 0.0
        assert moved[~at_junction].max() > 0.0 or s[-1] - sum(root.trim) < 5.0


def test_every_trim_is_a_station_where_the_face_of_the_junction_is(sample: Sample) -> None:
    """The corners of the face are half a width beside the station, to a thousandth of a mm."""
    scene = sample(TOWN + BENT).scenes[0]
    roads = roads_of(scene, "bent")
    (network,) = (network for network in scene.networks if network.name == "bent")
    for junction in network.junctions:
        for arm in junction.arms:
            road = roads[int(arm.road.rpartition("/")[2])]
            s = road.trim[0] if arm.end == "start" else road.stations[-1] - road.trim[1]
            place = int(np.abs(np.array(road.stations) - s).argmin())
            assert road.stations[place] == pytest.approx(s, abs=1e-9)
            side = 1.0 if arm.end == "start" else -1.0
            half = side * road.width[place] / 2.0
            across = -np.sin(road.heading[place]), np.cos(road.heading[place])
            left = road.x[place] + half * across[0], road.y[place] + half * across[1]
            assert junction.area[arm.left] == pytest.approx(left, abs=1e-6)


def test_a_road_between_junctions_that_touch_lies_inside_one(sample: Sample) -> None:
    close = TOWN.replace("....#.......#....", "....#.#..........")
    close = close.replace("pixels", "pixels { thickness: 1.5px }")
    (network,) = sample(close).scenes[0].networks
    (junction,) = network.junctions
    assert len(junction.nodes) == 2
    inside = [road for road in sample(close).scenes[0].roads if road.name in junction.inside]
    assert inside
    for road in inside:
        assert sum(road.trim) == pytest.approx(road.length)


def test_a_scene_without_junctions_has_no_trims(sample: Sample) -> None:
    text = "road main { draw with waypoints { points: [(0m, 0m), (90m, 0m)] } }"
    scene = sample(text).scenes[0]
    assert scene == replace(scene, networks=())
    assert scene.roads[0].trim == (0.0, 0.0)


def test_the_curvature_of_a_network_includes_its_turns(sample: Sample) -> None:
    """A right turn round a curb of 4 m has a radius of 4 m and half a lane."""
    text = TOWN + "expect gentle: always (abs(curvature(town)) < 1/20m)\nroad street from town\n"
    text += "expect straight: always (abs(curvature(street)) < 1/20m)\n"
    scene = sample(text).scenes[0]
    gentle, straight = scene.expectations
    assert gentle.robustness is not None
    assert gentle.tightest is not None
    turns = [
        max(abs(curvature) for _, curvature in connection.pieces)
        for junction in scene.networks[0].junctions
        for connection in junction.connections
    ]
    assert gentle.robustness == pytest.approx(1 / 20 - max(turns), abs=1e-3)
    assert gentle.tightest.road.startswith("town/junction ")
    assert straight.robustness is not None
    assert straight.robustness > gentle.robustness
    assert len(gentle.profiles) == len(turns) + len(scene.networks[0].roads)


def test_other_signals_of_a_network_are_measured_on_its_roads_alone(sample: Sample) -> None:
    text = TOWN + BENT + "\nexpect near: always (deviation(bent, town) < 3m)\n"
    scene = sample(text).scenes[0]
    assert len(scene.expectations[0].profiles) == len(scene.networks[0].roads)
