"""`roadlang check`: every fault in its place, params from outside, fixes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.cli.command_lines import SCENE, roadlang


def test_check_json_has_every_fault_with_its_place(folder: Path) -> None:
    (folder / "scene.rl").write_text(SCENE.replace("amplitude", "amplitud").replace("3m", "3s"))
    done = roadlang("check", "scene.rl", "--json", cwd=folder)
    found = json.loads(done.stdout)
    assert done.returncode == 1
    assert {
        "code",
        "severity",
        "message",
        "file",
        "line",
        "column",
        "end_line",
        "end_column",
        "help",
    } <= set(found[0])
    assert {entry["line"] for entry in found} == {2, 3}


def test_set_gives_a_param_another_value(folder: Path) -> None:
    (folder / "scene.rl").write_text("param reach = 2m\n" + SCENE.replace("6m", "reach"))
    roadlang("compile", "scene.rl", "--set", "reach=1m", "-o", "out", cwd=folder)
    scene = json.loads((folder / "out/scene-0000.json").read_text())
    assert scene["values"]["reach"] == 1.0
    assert scene["provenance"]["overrides"] == {"reach": "1m"}


@pytest.mark.parametrize(
    ("content", "code", "status"),
    [
        (None, "RL920", 2),
        (b"\x89PNG\r\n\x1a\n\xff", "RL922", 1),
        (b"road main {\xff}", "RL922", 1),
        ("road main".encode("utf-16"), "RL922", 1),
        (b"#" * 5_000_000, "RL923", 1),
    ],
    ids=["missing", "picture", "latin", "utf16", "huge"],
)
@pytest.mark.parametrize("command", ["check", "compile", "fmt"])
def test_what_is_no_text_is_said_without_a_traceback(
    command: str, content: Any, code: str, status: int, tmp_path: Path
) -> None:
    if content is not None:
        (tmp_path / "scene.rl").write_bytes(content)
    done = roadlang(command, "scene.rl", cwd=tmp_path)
    assert done.returncode == status
    assert code in done.stderr
    assert "Traceback" not in done.stderr


def test_a_folder_is_no_scene_file(folder: Path) -> None:
    (folder / "scenes").mkdir()
    done = roadlang("check", "scenes", cwd=folder)
    assert (done.returncode, "RL921" in done.stderr) == (2, True)


def test_check_goes_on_after_a_file_that_is_not_there(folder: Path) -> None:
    done = roadlang("check", "nope.rl", "scene.rl", "gone.rl", "--json", cwd=folder)
    assert [entry["file"] for entry in json.loads(done.stdout)] == ["nope.rl", "gone.rl"]


def test_standard_input_is_a_file_called_dash(folder: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "roadlang", "fmt", "-"],
        input="param   a=3m\n",
        capture_output=True,
        text=True,
        cwd=folder,
    )
    assert done.stdout == "param a = 3m\n"


def test_check_writes_the_fixes_that_leave_no_choice(folder: Path) -> None:
    (folder / "scene.rl").write_text(
        SCENE.replace("require near:", "requir near=") + "emit teleport\n"
    )
    done = roadlang("check", "--fix", "scene.rl", cwd=folder)
    assert "2 fixes" in done.stderr
    assert "teleport" in done.stderr
    assert done.returncode == 1
    assert (folder / "scene.rl").read_text() == SCENE + "emit teleport\n"


def test_check_fix_leaves_a_good_file_untouched(folder: Path) -> None:
    before = (folder / "scene.rl").stat()
    assert roadlang("check", "--fix", "scene.rl", cwd=folder).returncode == 0
    assert (folder / "scene.rl").stat().st_mtime_ns == before.st_mtime_ns
