"""`emit gltf` in the tools of others: the Khronos validator, and Godot as a game opens a file."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import roadlang
from roadlang import testing
from roadlang.ir.scene import Scene
from roadlang_formats.emit_gltf import GltfBackend
from roadlang_godot.engines import engine
from tests.formats.test_gltf import STREET, TEXTS
from tests.formats.tool_environments import run_tool, tool_folder

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[2]
SCRIPTS = Path(__file__).parent / "tool_scripts"
DRIVE = STREET.replace("{ lane: -1 }", "{ lane: -1, drive with lane_follow }")
CLOSE = 0.01


@pytest.fixture(scope="module")
def scenes() -> dict[str, Scene]:
    found = {name: testing.sample(text)[0].record for name, text in TEXTS.items()}
    for name in ("network", "on_ramp", "parked_row", "roundabout", "signals"):
        found[name] = roadlang.load(ROOT / "examples" / f"{name}.rl").sample(1)[0].record
    return found


@pytest.fixture(scope="module")
def files(scenes: dict[str, Scene], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("glb")
    contents = {name: GltfBackend().files(scene)["glb"] for name, scene in scenes.items()}
    contents["unreal"] = GltfBackend(collision="unreal").files(scenes["town"])["glb"]
    driven = testing.sample(DRIVE + "simulate with builtin { duration: 3s }")[0]
    drive = GltfBackend().drive_files(driven.record, driven.run().trace)
    contents["drive"] = drive["drive.glb"]
    paths = {name: folder / f"{name}.glb" for name in contents}
    for name, path in paths.items():
        path.write_bytes(contents[name])
    return paths


def test_the_khronos_validator_has_no_errors_and_no_warnings(files: dict[str, Path]) -> None:
    folder = tool_folder("gltf-validator")
    done = run_tool(["node", SCRIPTS / "gltf_issues.js", folder, *files.values()])
    assert done.returncode == 0, done.stderr
    answers = json.loads(done.stdout)
    assert set(answers) == set(map(str, files.values()))
    assert {name: issues for name, issues in answers.items() if issues} == {}


@pytest.mark.godot
def test_godot_opens_a_file_and_all_has_the_right_size(
    files: dict[str, Path], scenes: dict[str, Scene], tmp_path: Path
) -> None:
    (tmp_path / "project.godot").write_text("config_version=5\n", encoding="utf-8")
    command: list[str | Path] = [engine.find(), "--headless", "--path", tmp_path]
    done = run_tool([*command, "-s", SCRIPTS / "gltf_boxes.gd", "--", *files.values()])
    (line,) = (line for line in done.stdout.splitlines() if line.startswith("ANSWER "))
    answers = json.loads(line.removeprefix("ANSWER "))
    assert answers[str(files["drive"])]["animations"] == 1
    for name, scene in scenes.items():
        boxes = answers[str(files[name])]
        assert boxes["error"] == 0
        for actor in (*scene.agents, *scene.objects):
            cos, sin = abs(np.cos(actor.heading)), abs(np.sin(actor.heading))
            half = np.array([
                actor.length * cos + actor.width * sin, actor.length * sin + actor.width * cos
            ]) / 2.0  # fmt: skip
            box = boxes[_in_godot(f"{actor.name}-convcol")]
            low = actor.x - half[0], 0.0, -actor.y - half[1]
            high = actor.x + half[0], actor.height, -actor.y + half[1]
            # Turned, a body does not reach into the corners of its box.
            slack = CLOSE if cos * sin < 1e-6 else 0.3 * actor.width
            assert box == pytest.approx([*low, *high], abs=slack)
            assert box[4] == pytest.approx(actor.height, abs=CLOSE)
        for road in scene.roads:
            if road.derived and not road.trim[0] and not road.trim[1]:
                lanes = [_in_godot(f"{road.name} lane {lane.id} {lane.kind}-col")
                         for lane in road.lane_list]  # fmt: skip
                found = np.array([boxes[lane] for lane in lanes if lane in boxes])
                heading = np.array(road.heading)
                sides = road.cross_section().border_offsets(np.array(road.stations))[[0, -1]]
                x = np.array(road.x) - sides * np.sin(heading)
                y = np.array(road.y) + sides * np.cos(heading)
                want = [x.min(), -y.max(), x.max(), -y.min()]
                got = [*found[:, [0, 2]].min(axis=0), *found[:, [3, 5]].max(axis=0)]
                assert got == pytest.approx(want, abs=CLOSE)


def _in_godot(name: str) -> str:
    """The name of a node, in which Godot has no such characters."""
    return "".join("_" if letter in '.:@/"%' else letter for letter in name)
