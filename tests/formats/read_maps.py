"""OpenDRIVE maps read, and the lanes and turns that are found."""

from __future__ import annotations

from pathlib import Path

from roadlang import testing
from roadlang.api import Extraction
from roadlang.geometry import CrossSection, Edge
from roadlang.ir.scene import Scene
from roadlang_formats.read_opendrive import OpenDriveMap


def found_in(folder: Path, text: str) -> Extraction:
    """What the reader makes of a file."""
    path = folder / "town.xodr"
    path.write_text(text)
    found: Extraction = OpenDriveMap().read(path)
    return found


def lanes_of(edge: Edge) -> CrossSection:
    """Those of a road, which has some."""
    assert edge.cross_section is not None
    return edge.cross_section


def sampled(folder: Path, text: str, scenario: str = "") -> Scene:
    """The scene of a map; `scenario` follows the network in the scene file."""
    path = folder / "town.xodr"
    path.write_text(text)
    return testing.sample(f'network town from "{path}" {scenario}')[0].record


def turns_of(scene: Scene) -> set[tuple[str, int, str, int]]:
    """Roads and lanes of all connections."""
    return {
        (c.source.road, c.source.lane, c.target.road, c.target.lane)
        for network in scene.networks
        for junction in network.junctions
        for c in junction.connections
    }


CROSSING_TURNS = {
    ("town/1", -1, "town/2", -1),
    ("town/2", 1, "town/1", 1),
    ("town/1", -1, "town/3", 1),
    ("town/3", -1, "town/2", -1),
}
