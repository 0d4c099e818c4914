"""A file that is watched is read as it is saved, and one that stays unreadable is reported once."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang_godot.commands.watched_file import WatchedFile


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "a.rl"
    path.write_text("road main")
    return path


def test_the_text_is_what_was_saved_last(file: Path) -> None:
    watched = WatchedFile(str(file))
    assert watched.read(0.0) == "road main"
    file.write_text("road other")
    assert watched.read(0.1) == "road other"


def test_a_moment_without_the_file_is_not_told(
    file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    watched = WatchedFile(str(file))
    file.unlink()
    assert watched.read(0.0) is None
    assert watched.read(0.9) is None
    file.write_text("road main")
    assert watched.read(1.1) == "road main"
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(
    ("content", "code"), [(None, "RL920"), (b"\xff\xe4", "RL922"), (b"road\0", "RL922")]
)
def test_a_file_that_stays_unreadable_is_told_once(
    file: Path, content: bytes | None, code: str, capsys: pytest.CaptureFixture[str]
) -> None:
    watched = WatchedFile(str(file))
    file.unlink()
    if content is not None:
        file.write_bytes(content)
    told = [watched.read(now) for now in (0.0, 0.5, 1.0, 1.5, 9.0)]
    assert told == [None] * 5
    assert capsys.readouterr().err.count(f"error[{code}]") == 1
