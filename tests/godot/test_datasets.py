"""Sets of labeled pictures: whole or absent, the same every time, as their schemas say."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import cv2
import jsonschema
import numpy as np
import pytest

from roadlang.api import Dataset, FrameLabels, Scene
from roadlang.cli.main import run
from roadlang.ir.schema import schema_of_dataclass
from roadlang_godot.engines.engine import Engine
from roadlang_godot.rendering.dataset_files import write_dataset
from roadlang_godot.rendering.labeled_frames import Moment, Sampling, moments_of
from roadlang_standard.camera_pictures import depth_numbers
from roadlang_standard.semantic_classes import class_table
from tests.godot.godot_scenes import bend, call, car, pieces, road, scene, straight, thing

MAIN = road("main", pieces(straight(60), bend(50, 60)))
INDEX = Dataset("test", "", "0", "", "test.rl", 0, 0.5, {}, ())


def drive() -> Scene:
    ego = car("ego", MAIN, 5.0, call("pure_pursuit", speed=10.0, lookahead=6.0), start_speed=10.0)
    ahead = car("ahead[1]", MAIN, 25.0, call("pure_pursuit", speed=8.0, lookahead=6.0))
    return scene(MAIN, agents=[ego, ahead], objects=[thing("tree", 40.0, 8.0)])


@pytest.fixture(scope="module")
def moments(drawing_engine: Engine) -> list[list[Moment]]:
    """Of two drives of one scene."""
    with drawing_engine.connect("dataset") as session:
        sampling = Sampling(interval=1.0, size=(160, 90))
        return [moments_of(drive(), {}, sampling, 3, session) for _ in range(2)]


@pytest.mark.godot
def test_a_second_drive_gives_the_same_files(moments: list[list[Moment]], tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    assert write_dataset(first, moments[0], INDEX, clips=True) == 3
    assert write_dataset(second, moments[1], INDEX, clips=True) == 3
    names = sorted(path.name for path in first.iterdir())
    assert len(names) == 3 * 5 + 2
    clip = cv2.VideoCapture(str(first / "scene-0000.ego.front.avi"))
    frames = [frame.shape for good, frame in iter(clip.read, (False, None)) if good]
    assert frames == [(90, 160, 3)] * 3
    assert names == sorted(path.name for path in second.iterdir())
    for name in names:
        assert (first / name).read_bytes() == (second / name).read_bytes(), name


@pytest.mark.godot
def test_files_are_what_their_index_and_schemas_say(
    moments: list[list[Moment]], tmp_path: Path
) -> None:
    write_dataset(tmp_path, moments[0], INDEX)
    index = json.loads((tmp_path / "dataset.json").read_text())
    jsonschema.validate(index, schema_of_dataclass(Dataset))
    assert [frame["time"] for frame in index["frames"]] == [0.0, 1.0, 2.0]
    for frame in index["frames"]:
        files = {output: tmp_path / name for output, name in frame["files"].items()}
        labels = json.loads(files["labels"].read_text())
        jsonschema.validate(labels, schema_of_dataclass(FrameLabels))
        pictures = {
            output: cv2.imread(str(files[output]), cv2.IMREAD_UNCHANGED)
            for output in ("rgb", "depth", "semantic", "instance")
        }
        assert pictures["rgb"].shape == (90, 160, 3)
        for found in labels["things"]:
            of_thing = pictures["instance"] == found["instance"]
            assert of_thing.sum() == found["pixels"]
            assert set(pictures["semantic"][of_thing]) <= {index["classes"][found["category"]]}
        ahead = next(found for found in labels["things"] if found["name"] == "ahead[1]")
        nearest = pictures["depth"][pictures["instance"] == ahead["instance"]].min()
        # Its rear is half a length nearer than its center.
        away = ahead["center_in_camera"][2] - 0.5 * ahead["size"][0]
        assert nearest * index["depth_unit"] == pytest.approx(away, abs=0.3)


@pytest.mark.godot
def test_a_set_that_fails_leaves_the_earlier_one(
    moments: list[list[Moment]], tmp_path: Path
) -> None:
    def failing() -> Iterator[Moment]:
        yield moments[0][0]
        raise RuntimeError("lost")

    folder = tmp_path / "set"
    with pytest.raises(RuntimeError, match="lost"):
        write_dataset(folder, failing(), INDEX)
    assert not folder.exists()
    write_dataset(folder, moments[0], INDEX, clips=True)
    with pytest.raises(RuntimeError, match="lost"):
        write_dataset(folder, failing(), INDEX)
    assert len(list(folder.iterdir())) == 17
    write_dataset(folder, moments[0][:1], INDEX)
    assert len(list(folder.iterdir())) == 6


def test_depth_beyond_16_bits_is_nothing() -> None:
    depth = np.array([[0.1, 655.35, 655.36, np.inf]], np.float32)
    assert depth_numbers(depth).tolist() == [[10, 65535, 0, 0]]


def test_the_page_lists_all_classes() -> None:
    page = (Path(__file__).parents[2] / "docs" / "cameras.md").read_text(encoding="utf-8")
    listed = {name: int(id) for id, name in re.findall(r"\| (\d+) \| `(\w+)`", page)}
    assert listed == class_table()


def test_without_a_screen_nothing_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file, folder = tmp_path / "scene.rl", tmp_path / "set"
    file.write_text(
        "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }\n"
        "agent ego is car on main at 5m\n"
    )
    engine = tmp_path / "godot4"
    engine.write_text("#!/bin/sh\n")
    engine.chmod(0o755)
    monkeypatch.setenv("ROADLANG_GODOT", str(engine))
    monkeypatch.setenv("PATH", str(tmp_path))
    for screen in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(screen, raising=False)
    assert run(["render", str(file), "--dataset", str(folder)]) == 5
    assert "RL508" in capsys.readouterr().err
    assert not folder.exists()


@pytest.mark.parametrize("outputs", [(), ("-o", "a.png", "--dataset", "set")])
def test_either_a_file_or_a_dataset(outputs: tuple[str, ...], tmp_path: Path) -> None:
    file = tmp_path / "scene.rl"
    file.write_text("road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }\n")
    assert run(["render", str(file), *outputs]) == 2


@pytest.mark.parametrize(
    "option",
    ["--every=nan", "--every=inf", "--at=nan", "--at=-1", "--at=1e9", "--duration=inf",
     "--scale=nan", "--camera=0,0,nan,0,0"],
)  # fmt: skip
def test_numbers_that_are_none_are_refused(option: str, tmp_path: Path) -> None:
    file = tmp_path / "scene.rl"
    file.write_text("road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }\n")
    outputs = ["-o", str(tmp_path / "a.avi"), "--view", "top"]
    assert run(["render", str(file), *outputs, option]) == 2
    assert not (tmp_path / "a.avi").exists()
