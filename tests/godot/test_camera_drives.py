"""Cameras in drives: controllers get pictures in lock-step, and they are recorded."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import cv2
import numpy as np
import pytest

import roadlang
from roadlang.api import Trace
from roadlang.cli.main import run
from roadlang.commands import python_controllers
from roadlang.drive.sensors import sensor_recorders
from roadlang.ir.readings import SensorRecord
from roadlang_godot.drive.followed_scene import FollowedScene
from roadlang_godot.drive.simulate import Settings, drive_in
from roadlang_godot.engines.engine import Engine

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] } }
agent ego is car on main at 5m {
  start_speed: 10m/s
  drive with pure_pursuit { speed: 10m/s }
  sense with camera as front {
    width: 64px, height: 36px, every: 100ms, outputs: [rgb, depth, semantic, instance]
  }
  sense with camera as rear {
    width: 32px, height: 16px, yaw: 180deg, every: 500ms, record: [png, mp4]
  }
  sense with gps
}
agent parked is car on main at 60m
simulate with godot
"""
SECONDS = 0.6


def driven(engine: Engine, attempts: int = 1) -> tuple[Trace, Mapping[str, SensorRecord]]:
    """The drive begins, with what its sensors measured: as often as after lost engines."""
    loaded = roadlang.loads(TEXT)
    scene = loaded.sample(1)[0].record
    controllers = python_controllers(scene, loaded.registry)
    recorders = sensor_recorders(controllers)
    with engine.connect("camera drive") as session:
        for _ in range(attempts):
            trace = drive_in(session, scene, Settings(duration=SECONDS, step=0.05), controllers)
    return trace, {kept.sensor: kept.record for kept in recorders}


@pytest.fixture(scope="module")
def drives(drawing_engine: Engine) -> list[tuple[Trace, Mapping[str, SensorRecord]]]:
    return [driven(drawing_engine), driven(drawing_engine, attempts=2)]


Drives = list[tuple[Trace, Mapping[str, SensorRecord]]]


@pytest.mark.godot
def test_pictures_are_taken_as_often_as_the_sensor_says(drives: Drives) -> None:
    _, records = drives[0]
    np.testing.assert_allclose(records["front"].time, np.arange(0.0, 0.55, 0.1))
    np.testing.assert_allclose(records["rear"].time, [0.0, 0.5])
    shapes = {name: array.shape for name, array in records["front"].arrays.items()}
    assert shapes == {
        "rgb": (6, 36, 64, 3),
        "depth": (6, 36, 64),
        "semantic": (6, 36, 64),
        "instance": (6, 36, 64),
    }
    assert list(records["rear"].arrays) == ["rgb"]
    assert list(records["rear"].files) == ["000000.rgb.png", "000001.rgb.png", "mp4"]
    first = np.frombuffer(records["rear"].files["000000.rgb.png"], np.uint8)
    colors = cv2.imdecode(first, cv2.IMREAD_COLOR)[..., ::-1]
    np.testing.assert_array_equal(colors, records["rear"].arrays["rgb"][0])


@pytest.mark.godot
def test_pictures_show_where_the_car_is_at_their_time(drives: Drives) -> None:
    """The rear of the parked car comes nearer as the trace says."""
    trace, records = drives[0]
    front = records["front"]
    ego = np.interp(front.time, trace.time, trace.agents["ego"].x)
    parked = trace.agents["parked"]
    rear = float(parked.x[0]) - 0.5 * parked.length
    seen = [
        float(depth[instance == 2].min())
        for depth, instance in zip(front.arrays["depth"], front.arrays["instance"], strict=True)
    ]
    np.testing.assert_allclose(seen, rear - (ego + 1.5), atol=0.3)


@pytest.mark.godot
def test_a_second_attempt_measures_the_same_and_nothing_twice(drives: Drives) -> None:
    (first_trace, first), (second_trace, second) = drives
    np.testing.assert_array_equal(first_trace.agents["ego"].x, second_trace.agents["ego"].x)
    for name, record in first.items():
        for output, array in record.arrays.items():
            np.testing.assert_array_equal(array, second[name].arrays[output], f"{name} {output}")


@pytest.mark.godot
def test_controllers_see_the_newest_picture(
    drawing_engine: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    pictures: list[Any] = []
    decide = FollowedScene.controls

    def noted(self: FollowedScene) -> Any:
        decided = decide(self)
        seen = self.seen("ego").sensors["front"]
        pictures.append((seen.time, seen.rgb.copy(), seen.depth.copy()))
        return decided

    monkeypatch.setattr(FollowedScene, "controls", noted)
    _, records = driven(drawing_engine)
    assert [time for time, _, _ in pictures] == pytest.approx([k // 2 * 0.1 for k in range(12)])
    for k, (_, rgb, depth) in enumerate(pictures):
        np.testing.assert_array_equal(rgb, records["front"].arrays["rgb"][k // 2])
        np.testing.assert_array_equal(depth, records["front"].arrays["depth"][k // 2])


def test_the_embedded_engine_says_where_cameras_work(
    tmp_path: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "scene.rl"
    file.write_text(TEXT.replace("simulate with godot", "simulate with builtin"))
    assert run(["check", str(file)]) == 1
    assert "`simulate with godot`" in capsys.readouterr().err
