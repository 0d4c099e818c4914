"""Files that a user names: only regular ones are read, and no more of them than is meant."""

from __future__ import annotations

import json
import os
import socket
from pathlib import Path

import pytest

from roadlang.files.reading import UnreadableFile, read_file, read_start
from roadlang.session.scene_files import read_scene_file

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] } }\n"


@pytest.fixture
def short_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)  # a socket's path has at most 107 bytes
    return Path("thing")


def refused(path: Path, limit: int = 100) -> UnreadableFile:
    with pytest.raises(UnreadableFile) as caught:
        read_file(path, limit)
    return caught.value


def test_a_file_is_read_up_to_its_limit(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_bytes(b"12345")
    assert read_file(path, 5) == b"12345"
    assert refused(path, limit=4).size == 5
    assert read_start(path, 3) == b"123"
    assert read_start(path, 9) == b"12345"
    (tmp_path / "link").symlink_to(path)
    assert read_file(tmp_path / "link") == b"12345"


def test_what_is_no_file_is_refused_before_it_is_opened(short_path: Path) -> None:
    os.mkfifo(short_path)
    assert "a pipe" in refused(short_path).reason
    short_path.unlink()
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind(str(short_path))
        assert "a socket" in refused(short_path).reason
    assert "a device" in refused(Path("/dev/zero")).reason
    assert refused(Path("/")).is_folder
    assert refused(Path("nope")).is_missing
    assert "null" in refused(Path("a\0b")).reason


def test_a_file_of_the_system_that_tells_no_size_is_read_up_to_its_limit() -> None:
    assert read_file(Path("/proc/self/stat"), 10_000)
    assert refused(Path("/proc/self/stat"), limit=5).size


@pytest.fixture
def things(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a pipe under every ending, and one with a device."""
    monkeypatch.chdir(tmp_path)
    for ending in ("rl", "png", "csv", "json", "yaml"):
        os.mkfifo(tmp_path / f"pipe.{ending}")
        (tmp_path / f"zero.{ending}").symlink_to("/dev/zero")
    return tmp_path


@pytest.mark.parametrize("name", ["pipe", "zero"])
@pytest.mark.parametrize(
    ("text", "ending"),
    [
        ('include "FILE"\n' + ROAD, "rl"),
        ('image p from "FILE" { scale: 1m/px }\nnetwork n from p {}\n', "png"),
        ('network n from "FILE" {}\n', "png"),
        ('road r from "FILE"\n', "csv"),
        ('road r from "FILE" { read with csv }\n', "csv"),
        ('image p from "x.png" { scale: 1m/px }\n', "png"),
    ],
)
@pytest.mark.parametrize("command", ["check", "compile"])
def test_a_scene_that_names_a_pipe_or_a_device_is_refused(
    command: str,
    text: str,
    ending: str,
    name: str,
    things: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    from roadlang.cli.main import run

    (things / "scene.rl").write_text(text.replace("FILE", f"{name}.{ending}"))
    assert run([command, "scene.rl"]) == 1
    words = capsys.readouterr().err
    assert "error[RL" in words
    assert "RL900" not in words


@pytest.mark.parametrize("name", ["pipe", "zero"])
def test_commands_refuse_pipes_and_devices(
    name: str, things: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from roadlang.cli.main import run

    for command in ("check", "compile", "fmt"):
        assert run([command, f"{name}.rl"]) == 2
        assert "`-` reads standard input" in capsys.readouterr().err
    for ending in ("csv", "json"):
        assert run(["monitor", "always (x < 1)", f"{name}.{ending}"]) == 1
        assert "RL340" in capsys.readouterr().err
    assert run(["extract", f"{name}.png", "--scale", "1"]) == 1
    assert "not a file" in capsys.readouterr().err


def test_an_include_has_the_limit_of_a_scene_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from roadlang.cli.main import run

    monkeypatch.chdir(tmp_path)
    (tmp_path / "large.rl").write_bytes(b"#" * 4_000_001)
    (tmp_path / "scene.rl").write_text('include "large.rl"\n' + ROAD)
    assert run(["check", "scene.rl"]) == 1
    assert "it has 4.0 MB, and 4 MB can be read" in capsys.readouterr().err


def test_standard_input_has_the_limit_of_a_scene_file(monkeypatch: pytest.MonkeyPatch) -> None:
    import io
    import sys

    from roadlang import DiagnosticError

    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"#" * 4_000_001)))
    with pytest.raises(DiagnosticError, match="RL923"):
        read_scene_file("-")


def test_a_table_has_a_most_number_of_rows(tmp_path: Path) -> None:
    from roadlang import DiagnosticError, testing

    lines = "\n".join(f"{number},0" for number in range(200_001))
    (tmp_path / "long.csv").write_text(f"x,y\n{lines}\n")
    with pytest.raises(DiagnosticError, match="more than 200,000 rows"):
        testing.sample('road r from "long.csv"\n', folder=tmp_path)


def test_digests_are_those_of_the_files(tmp_path: Path) -> None:
    import roadlang

    (tmp_path / "base.rl").write_text(ROAD)
    (tmp_path / "scene.rl").write_text('include "base.rl"\n')
    roadlang.load(tmp_path / "scene.rl").sample().emit(tmp_path / "out")
    manifest = json.loads((tmp_path / "out/manifest.json").read_text())
    assert len(manifest["inputs"]) == 2


def test_a_file_beyond_the_limit_is_told_with_its_whole_size(tmp_path: Path) -> None:
    (tmp_path / "large.rl").write_bytes(b"x" * 5_600_000)
    with pytest.raises(UnreadableFile) as error:
        read_file(tmp_path / "large.rl", 4_000_000)
    assert error.value.size == 5_600_000
    assert str(error.value) == "it has 5.6 MB, and 4 MB can be read"
