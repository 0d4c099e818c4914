"""What is decided in Python before an engine is started, and after it has ended."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roadlang.cli.main import run
from roadlang_godot.build.frame import frame_around
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.line import line_of
from roadlang_godot.build.names import plain_name
from roadlang_godot.build.sky import world_settings
from roadlang_godot.rendering.pictures import Shot, view_of
from tests.godot.godot_scenes import pieces, road, scene, straight

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"


@pytest.mark.parametrize(("width", "height"), [(1280, 720), (720, 1280), (500, 500)])
def test_a_top_view_shows_all_of_the_scene(width: int, height: int) -> None:
    made = scene(road("main", pieces(straight(400.0))))
    layout = layout_of(made)
    scale = view_of(layout, Shot("top", width, height))["size"] / height
    # At least 5 m around 400 m by 7 m; no more than 3 % where that is more.
    assert width * scale >= 400.0 + 10.0
    assert height * scale >= 7.0 + 10.0
    assert width * scale <= 400.0 + 0.06 * max(400.0, height * scale) + 10.0
    assert view_of(layout, Shot("top", width, height, scale=0.3))["size"] == 0.3 * height


@pytest.mark.parametrize(
    "size", ["1280", "1280x", "15x720", "720x15", "9000x720", "720x9000", "axb", "-720x720"]
)
def test_a_size_that_is_none_is_refused_before_anything_starts(
    size: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "scene.rl").write_text(ROAD)
    picture = tmp_path / "a.png"
    assert run(["render", str(tmp_path / "scene.rl"), "-o", str(picture), "--size", size]) == 2
    assert f"`{size}` is not a size such as 1280x720" in capsys.readouterr().err
    assert not picture.exists()


def test_a_line_goes_through_its_samples_and_bends_between_them() -> None:
    """Points of a circle of 30 m every 6 m: the line stays on it within a centimeter."""
    angle = np.linspace(0, 1.2, 7)
    circle = road("arc", 30.0 * np.column_stack([np.sin(angle), 1 - np.cos(angle)]))
    circle = replace(circle, heading=tuple(angle), stations=tuple(30.0 * angle))
    line = line_of(circle)
    s = np.linspace(0, 36, 100)
    points, heading, width = line.at(s)
    np.testing.assert_allclose(np.hypot(points[:, 0], points[:, 1] - 30.0), 30.0, atol=0.01)
    np.testing.assert_allclose(heading, s / 30, atol=0.01)
    np.testing.assert_allclose(width, 7.0)
    left, right = line.edges(s)
    np.testing.assert_allclose(np.hypot(left[:, 0], left[:, 1] - 30.0), 26.5, atol=0.02)
    np.testing.assert_allclose(np.hypot(right[:, 0], right[:, 1] - 30.0), 33.5, atol=0.02)


def test_the_origin_is_in_the_middle_and_the_extent_reaches_the_farthest_point() -> None:
    frame, extent = frame_around(np.array([[0.0, 0.0], [100.0, 10.0], [30.0, -50.0]]))
    assert (frame.x, frame.y) == (50.0, -20.0)
    assert extent == 50.0
    assert frame_around(np.array([[-1.0, 0.0], [0.0, 0.0]]))[1] == 1.0
    np.testing.assert_allclose(frame.ground(np.array([[60.0, -10.0]]), 2.0), [[10.0, 2.0, -10.0]])


@pytest.mark.parametrize(
    ("kind", "name"),
    [("pure_pursuit", "pure_pursuit"), ("roadlang.brake", "brake"), ("standard.brake", "brake"),
     ("acme.brake", "acme.brake")],
)  # fmt: skip
def test_a_kind_of_a_stranger_keeps_its_plugin(kind: str, name: str) -> None:
    assert plain_name(kind) == name


def test_rain_brings_clouds_and_takes_none_away() -> None:
    assert world_settings({"weather": "overcast", "rain": 0.1e-3 / 3600})["cloud"] == 1.0
    assert world_settings({"weather": "clear", "rain": 10e-3 / 3600})["cloud"] == pytest.approx(0.9)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--view", "chase"], "the scene has no agent to follow: choose `top` or `free`"),
        (["--view", "chase", "--agent", "ego"], "the scene has no agent to follow"),
    ],
)
def test_a_chase_view_needs_an_agent(
    options: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "scene.rl").write_text(ROAD)
    picture = tmp_path / "picture.png"
    assert run(["render", str(tmp_path / "scene.rl"), "-o", str(picture), *options]) == 2
    assert said in capsys.readouterr().err
    assert not picture.exists()
