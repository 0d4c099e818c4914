"""A scene file that declares nothing is an error: it used to compile to an empty scene."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
from roadlang.cli.main import run
from tests.straight_road import STRAIGHT


@pytest.mark.parametrize("text", ["", "# to do\n", 'scenario later "Later"\n', "emit json\n"])
def test_a_file_that_declares_nothing(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "empty.rl"
    file.write_text(text)
    for command in (["check"], ["compile", "-o", str(tmp_path / "out")], ["run"]):
        assert run([command[0], str(file), *command[1:]]) == 1
        said = capsys.readouterr().err
        assert "error[RL116]: `empty.rl` declares nothing" in said
        assert "`roadlang init FILE`" in said
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("text", ["param a = 3m..4m\n", "world { weather: rain }\n", STRAIGHT])
def test_a_file_that_declares_something(text: str) -> None:
    assert not any(found.is_error for found in roadlang.loads(text).check())
