"""The Godot project itself: its own tests, its style, and that it opens."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from roadlang_godot.engines import engine as engines
from tests.godot.godot_engines import require_engine

PROJECT = engines.project()


@pytest.mark.godot
def test_the_projects_own_tests_pass() -> None:
    require_engine()
    command = [
        str(engines.find()),
        "--headless",
        "--path",
        str(PROJECT),
        "-s",
        "res://tests/run.gd",
    ]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-2000:]
    assert ", 0 failed" in done.stdout
    assert "SCRIPT ERROR" not in done.stdout + done.stderr


@pytest.mark.parametrize(
    "tool", [["gdlint", "."], ["gdformat", "--check", "."]], ids=lambda t: t[0]
)
def test_the_project_is_clean_under(tool: list[str]) -> None:
    beside = Path(sys.executable).with_name(tool[0])
    program = str(beside) if beside.exists() else shutil.which(tool[0])
    if program is None:
        pytest.skip(f"no {tool[0]} here: pip install gdtoolkit")
    done = subprocess.run([program, *tool[1:]], cwd=PROJECT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_script_says_what_it_is() -> None:
    for script in PROJECT.rglob("*.gd"):
        lines = script.read_text(encoding="utf-8").splitlines()
        if lines[0] == "@tool" or lines[0].startswith("class_name"):
            lines = lines[1:]
        assert lines[0].startswith("extends"), script
        assert lines[1].startswith("## "), script
        assert len(lines) <= 300, script


def test_paths_are_relative_so_that_the_project_runs_inside_another() -> None:
    for file in [*PROJECT.rglob("*.gd"), *PROJECT.rglob("*.gdshader"), *PROJECT.rglob("*.tscn")]:
        assert "res://" not in file.read_text(encoding="utf-8"), file


SCENE_SCRIPT = """extends SceneTree


func _init() -> void:
	var main: Node = (load("res://main.tscn") as PackedScene).instantiate()
	var seen := main.find_children("*", "GeometryInstance3D", true, false).size()
	root.add_child(main)
	await process_frame
	var left := main.find_children("*", "GeometryInstance3D", true, false).size()
	print("in the editor %d, running %d" % [seen, left])
	quit()
"""


@pytest.mark.godot
def test_the_main_scene_shows_something_in_the_editor_and_runs_empty(tmp_path: Path) -> None:
    require_engine()
    script = tmp_path / "look.gd"
    script.write_text(SCENE_SCRIPT, encoding="utf-8")
    command = [str(engines.find()), "--headless", "--path", str(PROJECT), "-s", str(script)]
    done = subprocess.run([*command, "--", "--port", "0"], capture_output=True, text=True)
    found = [line for line in done.stdout.splitlines() if line.startswith("in the editor ")]
    assert len(found) == 1, done.stdout + done.stderr
    shown, left = (int("".join(filter(str.isdigit, part))) for part in found[0].split(","))
    assert shown > 10
    assert left == 0
