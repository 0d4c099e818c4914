"""CommonRoad and Lanelet2 files of every second example and of random networks, by the tools that
read them."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
from benchmarks.formats.corpus import example_scenes, random_scenes
from roadlang.ir.scene import Scene
from roadlang_formats.emit_commonroad import CommonRoadBackend
from roadlang_formats.emit_lanelet2 import Lanelet2Backend
from tests.formats.lanelet_chains import chains_of, routes_of
from tests.formats.tool_environments import ask_tool

pytestmark = pytest.mark.slow
SEED = 9
EXAMPLES = Path(__file__).parents[2] / "examples"
DRIVEN = ("cut_in", "traffic")


@pytest.fixture(scope="module")
def scenes() -> dict[str, Scene]:
    found = (*example_scenes(SEED, every=2), *random_scenes(1, SEED, with_traffic=True))
    return {name.replace(" ", "_"): scene for name, scene in found}


def test_commonroad_reads_all_and_finds_everybody_on_the_road(
    scenes: dict[str, Scene], tmp_path: Path
) -> None:
    texts = {name: CommonRoadBackend().files(scene)["cr.xml"] for name, scene in scenes.items()}
    for name in DRIVEN:
        sample = roadlang.load(EXAMPLES / f"{name}.rl").sample(1, seed=SEED)[0]
        driven = CommonRoadBackend().drive_files(sample.record, sample.run().trace)
        texts[f"{name}.drive"] = driven["drive.cr.xml"]
    for name, text in texts.items():
        (tmp_path / f"{name}.xml").write_text(text, encoding="utf-8")
    files = [str(path) for path in sorted(tmp_path.iterdir())]
    faults = ask_tool("commonroad", "commonroad_scenarios.py", files)
    assert {file: found for file, found in faults.items() if found} == {}
    assert len(faults) == len(texts)


def test_lanelet2_reads_all_and_routes_through_every_junction(
    scenes: dict[str, Scene], tmp_path: Path
) -> None:
    question = {}
    for name, scene in scenes.items():
        path = tmp_path / f"{name}.osm"
        path.write_text(Lanelet2Backend().files(scene)["lanelet2.osm"], encoding="utf-8")
        origins = [network.origin for network in scene.networks if network.origin is not None]
        place = origins[0] if origins else (0.0, 0.0)
        question[str(path)] = [place, chains_of(scene), routes_of(scene)]
    faults = ask_tool("lanelet2", "lanelet2_maps.py", question)
    assert {file: found for file, found in faults.items() if found} == {}
