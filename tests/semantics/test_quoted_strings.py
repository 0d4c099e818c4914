"""A param whose default is a string: how a value that is none is written as one."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
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


@pytest.mark.parametrize(
    "value", ["my-file.txt", "x.png", "/tmp/log", "a b", "a:b", "2024-01-01", "3..4", "true"]
)
def test_text_without_quotes_is_one_error_with_the_text_as_it_is_meant(
    value: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Not one for each of its words, as if it were an expression."""
    path = tmp_path / "scene.rl"
    path.write_text(SCENE)
    assert run(["check", str(path), "--set", f"label={value}"]) == 1
    printed = capsys.readouterr().err
    assert printed.count("error[") == 1
    assert "error[RL206]: `label` expects a string" in printed
    assert f"`--set 'label=\"{value}\"'`" in printed
    assert run(["check", str(path), "--set", f'label="{value}"']) == 0


def test_in_python_the_quotes_are_inside_the_text(tmp_path: Path) -> None:
    path = tmp_path / "scene.rl"
    path.write_text(SCENE)
    with pytest.raises(roadlang.DiagnosticError, match=r"label='.x\.png.'"):
        roadlang.load(str(path), label="x.png").sample()
    assert roadlang.load(str(path), label='"x.png"').check() == ()


@pytest.mark.parametrize(("value", "code"), [("left.word", 0), ("left.wrd", 1), ("lft.word", 1)])
def test_a_param_of_an_included_file_is_no_text(
    value: str, code: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """`left.word` is a name with a dot where a file is included as `left`."""
    (tmp_path / "part.rl").write_text('param word = "b"\n')
    path = tmp_path / "scene.rl"
    path.write_text(f'include "part.rl" as left\n{SCENE}')
    assert run(["check", str(path), "--set", f"label={value}"]) == code
    told = {"left.word": "", "left.wrd": "did you mean `left.word`?", "lft.word": "double quotes"}
    assert told[value] in capsys.readouterr().err
