"""What is wrong with a file: every command that reads it says so once."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.cli.main import run

MISSPELLED = """
road main { draw with segments { pieces: [straight(100m)] } }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 12m/s } }
expect in_lane: always (abs(ego.cross_track_error) < 2m)
falsify with cmaes { evaluations: 10 }
"""


@pytest.mark.parametrize("command", ["check", "compile", "run", "falsify", "view"])
def test_an_error_is_told_once(
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("scene.rl").write_text(MISSPELLED)
    assert run([command, "scene.rl"]) == 1
    assert capsys.readouterr().err.count("unknown kind of `falsify`") == 1


@pytest.mark.parametrize("command", ["check", "falsify"])
def test_a_scene_in_place_of_its_scene_file_is_told_what_drives_it(
    command: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "0001.json").write_text('{"schema": "roadlang.scene/2"}\n')
    assert run([command, str(tmp_path / "0001.json")]) == 1
    told = capsys.readouterr().err
    assert told.count("error[") == 1
    assert "`roadlang run scene.json` drives a scene" in told


def test_a_search_without_a_scene_says_which_requirement_rejects(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = MISSPELLED.replace("falsify with cmaes { evaluations: 10 }", "").replace(
        "100m", "100m..150m"
    )
    (tmp_path / "a.rl").write_text(text + "require long: length(main) > 149.9999m\n")
    search = ["falsify", str(tmp_path / "a.rl"), "-o", str(tmp_path / "out")]
    assert run([*search, "--evaluations", "4"]) == 3
    told = capsys.readouterr().err
    assert "error[RL601]: none of 4 candidates" in told
    assert "long: length(main) > 149.9999m  4 of 4    100.0%" in told
