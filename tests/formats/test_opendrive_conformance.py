"""OpenDRIVE files of every second example and of random networks, as the tools that read them see
them. Those of the other examples are in `test_lanelet_conformance.py`.

More networks: `python -m benchmarks.formats --networks 14 --seed 7`.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest
from shapely import LineString, points
from shapely import distance as distances

from benchmarks.formats.corpus import example_scenes, random_scenes
from benchmarks.formats.judges import converted
from roadlang.ir.scene import Scene
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.opendrive.road_parts import road_parts
from tests.formats.lane_middles import lane_middles
from tests.formats.opendrive_reader import ReadFile
from tests.formats.tool_environments import ask_tool, tool_program

pytestmark = pytest.mark.slow
SEED = 5
CLOSE = 0.01
"""Meters between a reference line and the road of the scene."""
LANES_CLOSE = 0.05
"""Meters between the middles of lanes of a scene and of CARLA's map."""
CHECKERS = 22
"""Of the 23 of ASAM; the last one is for versions before 1.7."""


@dataclass(frozen=True)
class Written:
    """A scene and its file."""

    scene: Scene
    file: Path


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> list[Written]:
    folder = tmp_path_factory.mktemp("opendrive")
    found = []
    for name, scene in (*example_scenes(SEED, first=1, every=2), *random_scenes(1, SEED)):
        file = folder / f"{name.replace(' ', '_')}.xodr"
        file.write_text(OpenDriveBackend().files(scene)["xodr"], encoding="utf-8")
        found.append(Written(scene, file))
    return found


@pytest.mark.parametrize("version", ["1.7", "1.8"])
def test_the_asam_checker_finds_nothing(written: list[Written], version: str) -> None:
    files = []
    for item in written[::3] if version == "1.8" else written[1::4]:
        file = item.file.with_suffix(f".{version}.xodr")
        file.write_text(OpenDriveBackend(version=version).files(item.scene)["xodr"], "utf-8")  # type: ignore[arg-type]
        files.append(str(file))
    for file, (completed, issues) in ask_tool("asam", "asam_opendrive.py", files).items():
        assert issues == [], file
        assert completed >= CHECKERS, file


def test_netconvert_has_every_road_and_turn(written: list[Written]) -> None:
    program = str(tool_program("sumo", "netconvert"))
    faults = {item.file.stem: converted(program, item.file) for item in written}
    assert {name: found for name, found in faults.items() if found} == {}


def test_carla_has_every_lane_and_drives_every_turn(written: list[Written]) -> None:
    question = {str(item.file): list(lane_middles(item.scene, every=5)) for item in written}
    for file, (away, undrivable) in ask_tool("carla", "carla_maps.py", question).items():
        assert away < LANES_CLOSE, file
        assert undrivable == [], file


def test_reference_lines_keep_to_the_roads_with_few_pieces(written: list[Written]) -> None:
    pieces, meters = 0, 0.0
    for item in written:
        file = ReadFile.of(item.file.read_text(encoding="utf-8"))
        for part in road_parts(item.scene, 0.005, "one_way_roads"):
            read = file.roads[part.id]
            count = max(2, int(read.length / 0.2))  # chords within 2 mm of a corner
            line = LineString([read.pose(read.length * k / count)[:2] for k in range(count + 1)])
            wanted = points(part.pose(part.stations)[:, :2])
            assert float(distances(wanted, line).max()) < CLOSE, (item.file.stem, part.id)
            pieces += len(read.pieces())
            meters += read.length
    assert pieces <= meters / 5.0
