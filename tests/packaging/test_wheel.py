"""The wheel holds all that roadlang needs, and works where no checkout is."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

pytestmark = pytest.mark.slow


def pip(*arguments: str) -> None:
    subprocess.run([sys.executable, "-m", "pip", *arguments, "--quiet"], check=True)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    pip("wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", str(folder), str(ROOT))
    return next(folder.glob("roadlang-*.whl"))


@pytest.fixture(scope="module")
def site(wheel, tmp_path_factory) -> Path:
    """A folder that the wheel is installed into, before everything else on the path."""
    folder = tmp_path_factory.mktemp("site")
    pip("install", "--no-deps", "--target", str(folder), str(wheel))
    return folder


def run(site: Path, cwd: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(site)}
    return subprocess.run(
        [sys.executable, *arguments], cwd=cwd, env=environment, capture_output=True, text=True
    )


def test_the_wheel_ships_grammar_catalogue_templates_and_the_godot_project(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {
        "roadlang/_shipped/grammar/roadlang.lark",
        "roadlang/_shipped/godot_backend/project.godot",
        "roadlang/diagnostics/catalogue/RL201.md",
        "roadlang/syntax/tables.json",
        "roadlang/cli/templates/bend.rl",
        "roadlang/py.typed",
        "roadlang_standard/emit_svg.py",
    } <= names


def test_the_wheel_ships_neither_caches_nor_tests(wheel):
    names = zipfile.ZipFile(wheel).namelist()
    strays = ("__pycache__", ".godot/", "/tests/")
    assert not [name for name in names if any(stray in name for stray in strays)]


def test_an_installed_roadlang_is_the_one_that_runs(site, tmp_path):
    done = run(site, tmp_path, "-c", "import roadlang; print(roadlang.__file__)")
    assert done.stdout.startswith(str(site))


def test_an_installed_roadlang_compiles_in_an_empty_folder(site, tmp_path):
    assert run(site, tmp_path, "-m", "roadlang", "init", "scene.rl").returncode == 0
    done = run(site, tmp_path, "-m", "roadlang", "compile", "scene.rl", "-o", "out")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out/scene-0000.svg").exists()


def test_the_grammar_and_the_godot_project_are_found_in_an_install(site, tmp_path):
    code = "from roadlang.syntax.grammar import grammar_path\nprint(grammar_path())\n"
    done = run(site, tmp_path, "-c", code)
    assert done.stdout.strip().startswith(str(site)), done.stdout + done.stderr
