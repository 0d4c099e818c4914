"""`roadlang render` ignores no option: one that does nothing is refused before anything starts."""

from __future__ import annotations

from pathlib import Path

import click
import pytest

from roadlang.cli.main import run
from roadlang_godot.commands.render_options import chosen_view

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"
PICTURE, CLIP, EXPORT, DATASET = (
    ["-o", "a.png"],
    ["-o", "a.avi"],
    ["-o", "a.glb"],
    ["--dataset", "data"],
)
NONE_CHOSEN = {"view": None, "agent": None, "scale": None, "camera": None}


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ([*PICTURE, "--duration", "3"], "--duration is for a clip"),
        ([*PICTURE, "--fps", "4"], "--fps is for a clip"),
        ([*PICTURE, "-n", "3"], "-n is for a dataset"),
        ([*CLIP, "--every", "3"], "--every is for a dataset"),
        ([*PICTURE, "--clips"], "--clips is for a dataset"),
        ([*EXPORT, "--scenes", "3"], "--scenes is for a dataset"),
        ([*EXPORT, "--size", "64x64"], "--size is for a dataset"),
        ([*EXPORT, "--view", "top"], "--view is for a picture"),
        ([*DATASET, "--view", "top"], "--view is for a picture"),
        ([*DATASET, "--camera", "0,0,9,0,0"], "--camera is for a picture"),
        ([*DATASET, "--agent", "ego"], "--agent is for a picture"),
        ([*DATASET, "--scale", "0.5m/px"], "--scale is for a picture"),
        ([*DATASET, "--fps", "5"], "--fps is for a clip"),
        ([*DATASET, "--scene", "5"], "--scene is for a picture"),
        ([*DATASET, "--scenes", "5", "-n", "2"], "--scenes 5 needs as many moments"),
        (
            [*PICTURE, "--view", "top", "--camera", "0,0,9,0,0"],
            "--camera goes with --view free, not with --view top",
        ),
        ([*PICTURE, "--view", "free", "--scale", "1m/px"], "--scale goes with --view top"),
        (
            [*PICTURE, "--scale", "1m/px", "--agent", "ego"],
            "--agent goes with --view chase, not with --scale",
        ),
        ([*PICTURE, "--size", ""], "write WIDTHxHEIGHT"),
        ([*PICTURE, "--size", "8x8"], "both are 16 to 8192 pixels"),
        ([*PICTURE, "--camera", "0m,0m,9m,0deg,0deg"], "five numbers without units"),
        (["--dataset", ""], "give either an output file"),
        ([], "give either an output file"),
        ([*PICTURE, *DATASET], "give either an output file"),
    ],
)
def test_an_option_that_does_nothing_is_refused(
    given: list[str],
    expected: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("scene.rl").write_text(ROAD)
    assert run(["render", "scene.rl", *given]) == 2
    assert expected in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["scene.rl"]


@pytest.mark.parametrize(
    ("options", "view"),
    [
        ({}, "chase"),
        ({"agent": "ego"}, "chase"),
        ({"scale": 0.5}, "top"),
        ({"camera": "0,0,9,0,0"}, "free"),
        ({"view": "free"}, "free"),
        ({"view": "top", "scale": 0.5}, "top"),
    ],
)
def test_an_option_of_one_view_chooses_it(options: dict[str, object], view: str) -> None:
    assert chosen_view({**NONE_CHOSEN, **options}, has_agents=True) == view


def test_without_agents_the_scene_is_seen_from_above() -> None:
    assert chosen_view(NONE_CHOSEN, has_agents=False) == "top"


def test_options_of_two_views_are_refused() -> None:
    with pytest.raises(click.UsageError, match="--scale goes with --view top, not with --camera"):
        chosen_view({**NONE_CHOSEN, "scale": 0.5, "camera": "0,0,9,0,0"}, has_agents=True)
