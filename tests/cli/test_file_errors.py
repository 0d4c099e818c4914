"""What is wrong with a file: every command that reads it says so once."""

from __future__ import annotations

import json
import os
import sys
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


def test_a_search_tells_what_no_draw_can_satisfy_as_compile_does(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = MISSPELLED.replace("falsify with cmaes { evaluations: 10 }", "")
    text += "road bent from main { perturb with sine { amplitude: 1m..2m, wavelength: 60m } }\n"
    text += "require far: always (deviation(bent, main) > 5m)\n"
    (tmp_path / "a.rl").write_text(text)
    told = []
    for command in ("compile", "falsify"):
        folder = tmp_path / command
        assert run([command, str(tmp_path / "a.rl"), "-o", str(folder)]) == 3
        told.append([line for line in capsys.readouterr().err.splitlines() if line])
        assert not folder.exists()
    assert "error[RL600]: no draw can satisfy `always (deviation(bent, main) > 5m)`" in told[0]
    assert "  = help: `deviation(bent, main)` is 0m to 2m" in told[0]
    assert sum(line.startswith("warning[RL192]") for line in told[0]) == 1
    told[0].remove("1 error and 1 warning")  # which a search does not tell at the same time
    assert told[1] == told[0]


LONG = "b" * 300
ROAD = "road main { draw with segments { pieces: [straight(100m)] } }\n"


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["view", f"{LONG}.osm"], "RL400"),
        (["convert", f"{LONG}.osm", "map.xodr"], "RL400"),
        (["report", LONG], "RL720"),
        (["extract", f"{LONG}.png"], "RL400"),
        (["monitor", f"{LONG}.csv", "x > 0"], None),
        (["explain", LONG], "RL925"),
    ],
)
def test_a_name_that_is_too_long_for_a_file_is_no_bug(
    words: list[str],
    code: str | None,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(words) in (1, 2)
    told = capsys.readouterr().err
    assert "RL900" not in told
    assert code is None or f"error[{code}]" in told


@pytest.mark.skipif(sys.platform != "linux", reason="names of files are text elsewhere")
def test_the_name_of_a_scene_file_may_hold_bytes_that_are_no_text(tmp_path: Path) -> None:
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    folder.mkdir()
    scene = folder / os.fsdecode(b"stra\xdfe.rl")
    agent = "agent ego is car on main at 5m { drive with pure_pursuit { speed: 9m/s } }\n"
    scene.write_text(f"{ROAD}{agent}simulate with builtin {{ duration: 1s }}\n")
    assert run(["compile", str(scene), "-o", str(folder / "out"), "--emit", "json, svg"]) == 0
    assert run(["run", str(scene), "-o", str(folder / "drives")]) == 0
    manifest = json.loads((folder / "out" / "manifest.json").read_text())
    assert manifest["source"].endswith(r"caf\xe9/stra\xdfe.rl")
    assert manifest["name"] == r"stra\xdfe"


def test_check_finds_a_picture_whose_end_is_missing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    picture = Path(__file__).parents[2] / "examples" / "hairpin.jpg"
    (tmp_path / "cut.jpg").write_bytes(picture.read_bytes()[:20000])
    (tmp_path / "a.rl").write_text(
        'image photo from "cut.jpg" { scale: 0.5m/px }\nnetwork town from photo\n'
    )
    assert run(["check", str(tmp_path / "a.rl")]) == 1
    told = capsys.readouterr().err
    assert told.count("error[") == 1
    assert "error[RL403]: `cut.jpg` is truncated" in told
    assert "a.rl:1:18" in told
    assert "help: copy or download it again" in told
    assert run(["extract", str(tmp_path / "cut.jpg"), "-o", str(tmp_path / "a.json")]) == 1
    assert "help: copy or download it again" in capsys.readouterr().err
