"""Files that commands write have names that say what is in them."""

from __future__ import annotations

from pathlib import Path

import click
import pytest

from roadlang.cli.main import run
from roadlang.cli.output_files import FormatFile


@pytest.mark.parametrize("name", ["a.svg", "A.SVG", "folder.png/a.svg"])
def test_a_name_that_fits_is_taken(name: str) -> None:
    assert FormatFile("SVG", ".svg").convert(name, None, None) == name


@pytest.mark.parametrize("name", ["a.png", "a", "a.svg.png", "svg", "", "-"])
def test_a_name_of_another_format_is_refused(name: str) -> None:
    with pytest.raises(click.BadParameter, match="this writes SVG: name a file that ends in"):
        FormatFile("SVG", ".svg").convert(name, None, None)


@pytest.mark.parametrize(
    ("command", "fault"),
    [
        (["compile", "a.rl", "-o", ""], "the name is empty; `.` is the current folder"),
        (["run", "a.rl", "-o", ""], "the name is empty; `.` is the current folder"),
        (["falsify", "a.rl", "-o", ""], "the name is empty; `.` is the current folder"),
        (["shrink", "0001.json", "-o", ""], "'-o' / '--output': the name is empty\n"),
        (["extract", "a.png", "--edit", ""], "'--edit': the name is empty\n"),
    ],
)
def test_no_name_is_not_the_current_folder(
    command: list[str], fault: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Whose files would be replaced."""
    assert run(command) == 2
    assert fault in capsys.readouterr().err


@pytest.mark.parametrize(
    "command",
    [
        ["extract", "a.png", "--overlay", "o.png"],
        ["extract", "a.png", "--mask", "o.jpg"],
        ["view", "a.xodr", "-o", "o.png"],
        ["report", "out", "-o", "o.pdf"],
    ],
)
def test_commands_refuse_such_names_before_they_read(
    command: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(command) == 2
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "command", [["run"], ["run", "--params", "two.yaml"], ["falsify", "--evaluations", "8"]]
)
def test_a_drive_that_cannot_begin_leaves_no_folder(
    command: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "way.csv").write_text("time,x,y,heading\n0,5,0,0\n1,5\n")
    (tmp_path / "two.yaml").write_text("- speed: 30m/s\n- speed: 20m/s\n")
    (tmp_path / "a.rl").write_text(
        "param speed = 30m/s\n"
        "road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] } }\n"
        "agent ego is car on main at 5m..20m { drive with replay { file: 'way.csv' } }\n".replace(
            "'", '"'
        )
        + "expect slow: always (ego.speed < speed)\n"
    )
    for folder in ("out", "out/deep"):
        assert run([*command, "a.rl", "-o", folder]) == 1
        assert not (tmp_path / "out").exists()
