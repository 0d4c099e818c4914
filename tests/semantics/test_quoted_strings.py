"""A number for a param whose default is a string: how it is written as a string."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.cli.main import run

SCENE = """road main { draw with waypoints { points: [(0m, 0m), (100m, 10m)] } }
param label = "a"
agent ego is car on main at 5m { drive with process { command: ["sh", label] } }
"""


@pytest.mark.parametrize("value", ["9", "9m"])
def test_a_number_is_written_as_a_string_in_double_quotes(
    value: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The shell must not take the quotes."""
    path = tmp_path / "scene.rl"
    path.write_text(SCENE)
    assert run(["check", str(path), "--set", f"label={value}"]) == 1
    printed = capsys.readouterr().err
    assert "error[RL206]" in printed
    written = f'label="{value}"'
    assert f"strings are written in double quotes: `--set '{written}'`" in printed
    assert run(["check", str(path), "--set", written]) == 0
