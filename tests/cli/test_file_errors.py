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
