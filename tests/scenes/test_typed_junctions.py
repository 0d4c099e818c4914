"""Junctions of streets that are typed as text: short dead ends, blocks of two cells, bends."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
import shapely

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.testing import sample

RINGS = {
    "a ring of four cells": """
  ..........#..
  ..........#..
  ##########...
  .........##..
  .........#.##
  .........###.
""",
    "a block behind a road": """
  .........#.......
  .........#.......
  .........#.......
  ###########......
  ........#.#......
  ........#.#######
  ........#.#......
  ........###......
""",
    "dead ends of one cell": """
  .........................#.
  .........................#.
  .........................#.
  ###########################
  .........................#.
""",
}


@pytest.mark.parametrize("text", RINGS.values(), ids=RINGS)
@pytest.mark.parametrize("cell", [7.7, 8.45])
def test_streets_close_together_have_all_their_turns(text: str, cell: float) -> None:
    scenes = sample(f'image plan from """{text}""" {{ scale: {cell}m/px }}\nnetwork town from plan')
    (network,) = scenes[0].record.networks
    assert network.junctions
    assert not [junction.refused for junction in network.junctions if junction.refused]
    assert not [w for w in scenes.result.warnings if "no connection" in w.message]


STUBS = """
image plan from \"\"\"
  ....#.......#....
  #################
  ....#.......#....
  ....#############
  ....#.......#....
\"\"\" { scale: 12m/px }
network town from plan { lanes: 2 }
network bent from town {
  perturb with sine { amplitude: 2m..3m, wavelength: 30m..60m }
}
"""


def surface_beyond(road: SceneRoad, far: float = 15.0) -> list[shapely.Polygon]:
    """The first and the last meters of a road between its trims."""
    s, heading = np.array(road.stations), np.array(road.heading)
    points = np.column_stack([road.x, road.y])
    side = np.column_stack([-np.sin(heading), np.cos(heading)]) * np.array(road.width)[:, None] / 2
    begin, end = road.trim[0], road.length - road.trim[1]
    parts = []
    for low, high in ((begin, min(begin + far, end)), (max(begin, end - far), end)):
        chosen = (s >= low - 1e-9) & (s <= high + 1e-9)
        ring = np.concatenate([(points + side)[chosen], (points - side)[chosen][::-1]])
        parts.append(shapely.Polygon(ring).buffer(0))
    return parts


def deepest_overlap(scene: Scene) -> float:
    """Meters that an area and a road, or two areas, lie over one another."""
    (network,) = (network for network in scene.networks if network.name == "bent")
    areas = [shapely.Polygon(junction.area) for junction in network.junctions]
    parts = [p for road in scene.roads if road.network == "bent" for p in surface_beyond(road)]
    pairs = [*combinations(areas, 2), *((area, part) for area in areas for part in parts)]
    common = [shapely.intersection(a, b) for a, b in pairs]
    return max(2.0 * float(c.area) / max(float(c.length), 1e-9) for c in common)


def test_a_dead_end_right_behind_a_junction_stays_off_it_when_the_roads_are_bent() -> None:
    """2 m are left of dead ends of one cell; a full displacement would turn their ends round."""
    for scene in sample(STUBS, 5):
        assert deepest_overlap(scene.record) < 0.01


def test_two_junctions_side_by_side_under_another_road() -> None:
    """Turns between ends that lie at one point have no curve."""
    text = """
  ..................v............
  ..................v............
  ...............#>>#............
  ################..v............
  ...............################
  ..................v............
  ..................v............
"""
    legend = '"#": road, ">": eastbound, "v": southbound'
    scenes = sample(
        f'image plan from """{text}""" {{ scale: 7.27m/px, legend: {{ {legend} }} }}\n'
        "network town from plan { lanes: 2 }"
    )
    assert len(scenes[0].record.networks[0].junctions) == 3
