"""Roads that pass above others: no fault of the map, and a warning for simulators whose ground is
level."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry import RoadNetwork, network_of_polylines
from roadlang.geometry.junctions.overlaps import overlaps, passing_above
from roadlang.geometry.lanes.cross_section import CrossSection
from tests.geometry.junctions.crossings_of_roads import sections_of

CROSSING = [[(-60.0, 0.0), (60.0, 0.0)], [(0.0, -60.0), (0.0, 60.0)]]
OSM = """<osm version="0.6">
<node id="1" lat="48.137" lon="11.573"/><node id="2" lat="48.137" lon="11.577"/>
<node id="3" lat="48.139" lon="11.575"/><node id="4" lat="48.135" lon="11.575"/>
<way id="10"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way>
<way id="11"><nd ref="3"/><nd ref="4"/><tag k="highway" v="residential"/>{tags}</way>
</osm>"""
BRIDGE = '<tag k="bridge" v="yes"/>'


def crossing(**second: Any) -> tuple[RoadNetwork, dict[int, CrossSection]]:
    """Two roads that cross without a junction; what is said of the second."""
    network = network_of_polylines(CROSSING, 6.0)
    first, other = network.edges
    network = replace(network, edges=(first, replace(other, **second)))
    return network, sections_of(network)


def test_roads_on_different_levels_are_told_apart_from_a_fault() -> None:
    for level, kind in ((0, "overlap"), (1, "level"), (-2, "level")):
        network, sections = crossing(level=level)
        trims = dict.fromkeys(sections, (0.0, 0.0))
        (found,) = overlaps(network, sections, trims, ())
        assert (found.kind, found.edges) == (kind, tuple(sections))


@pytest.mark.parametrize(("height", "count"), [(0.0, 0), (2.0, 0), (5.5, 1), (-5.5, 1)])
def test_roads_of_a_map_pass_above_others_with_room_between(height: float, count: int) -> None:
    """The second road is level with the first at its ends, and so high in the middle."""
    network, sections = crossing(elevations=np.array([0.0, height, 0.0]))
    found = passing_above(network, sections, dict.fromkeys(sections, (0.0, 0.0)))
    assert [problem.kind for problem in found] == ["level"] * count


@pytest.mark.parametrize(("tags", "agent", "codes"), [
    (BRIDGE, "agent ego is car on town at random\nsimulate with godot", ["RL444"]),
    (BRIDGE, "agent ego is car on town at random\nsimulate with builtin", []),
    (BRIDGE, "agent ego is car on town at random", []),
    (BRIDGE, "simulate with godot", []),
    ("", "agent ego is car on town at random", ["RL436"]),
])  # fmt: skip
def test_a_bridge_is_a_warning_where_agents_drive_on_level_ground(
    tmp_path: Path, tags: str, agent: str, codes: list[str]
) -> None:
    path = tmp_path / "town.osm"
    path.write_text(OSM.format(tags=tags))
    scenes = testing.sample(f'network town from "{path}"\n{agent}')
    assert [found.code for found in scenes.diagnostics] == codes
