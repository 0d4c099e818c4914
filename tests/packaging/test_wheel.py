"""The wheel holds all that roadlang needs, and works where no checkout is."""

from __future__ import annotations

import ast
import os
import re
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
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    pip("wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", str(folder), str(ROOT))
    return next(folder.glob("roadlang-*.whl"))


@pytest.fixture(scope="module")
def site(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that the wheel is installed into, before everything else on the path."""
    folder = tmp_path_factory.mktemp("site")
    pip("install", "--no-deps", "--target", str(folder), str(wheel))
    return folder


def run(site: Path, cwd: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(site)}
    return subprocess.run(
        [sys.executable, *arguments], cwd=cwd, env=environment, capture_output=True, text=True
    )


def test_the_wheel_ships_grammar_catalog_templates_and_the_godot_project(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {
        "roadlang/_shipped/grammar/roadlang.lark",
        "roadlang/_shipped/godot_backend/project.godot",
        "roadlang/diagnostics/catalog/RL201.md",
        "roadlang/syntax/parsing/tables.json",
        "roadlang/cli/templates/bend.rl",
        "roadlang/py.typed",
        "roadlang_standard/emit_svg.py",
        "roadlang_standard/extraction/photos/weights/wide_roads.onnx",
        "roadlang_standard/extraction/photos/weights/LICENSE-APACHE-2.0.txt",
    } <= names


def test_the_wheel_ships_no_caches(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    strays = ("__pycache__", ".godot/")
    assert not [name for name in names if any(stray in name for stray in strays)]


def test_an_installed_roadlang_is_the_one_that_runs(site: Path, tmp_path: Path) -> None:
    done = run(site, tmp_path, "-c", "import roadlang; print(roadlang.__file__)")
    assert done.stdout.startswith(str(site))


def test_an_installed_roadlang_compiles_in_an_empty_folder(site: Path, tmp_path: Path) -> None:
    assert run(site, tmp_path, "-m", "roadlang", "init", "scene.rl").returncode == 0
    done = run(site, tmp_path, "-m", "roadlang", "compile", "scene.rl", "-o", "out")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out/scene-0000.svg").exists()


def test_the_grammar_and_the_godot_project_are_found_in_an_install(
    site: Path, tmp_path: Path
) -> None:
    code = "from roadlang.syntax.parsing.grammar import grammar_path\nprint(grammar_path())\n"
    done = run(site, tmp_path, "-c", code)
    assert done.stdout.strip().startswith(str(site)), done.stdout + done.stderr


BY_IMPORT = {"cv2": "opencv-python-headless", "yaml": "pyyaml"}
OPTIONAL = {
    "distributed": "the extra `dask`: searches and runs on a cluster",
    "gymnasium": "the extra `gym`: scenes as environments",
    "llvmlite": "comes with numba: calls from compiled loops into numpy",
    "numba": "the extra `fast`: motion of the embedded engine, compiled",
    "onnxruntime": "the extra `onnx`: policy networks that drive",
    "pandas": "traces as data frames, for those who have it",
    "pyproj": "the extra `maps`: grids of pictures other than UTM",
    "pytest": "the fixture of `roadlang.testing`",
    "stable_baselines3": "the extra `sb3`: scenes side by side for Stable-Baselines3",
}


def test_the_dependencies_are_those_that_are_imported() -> None:
    tomllib = pytest.importorskip("tomllib")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    declared = {re.split(r"[<>=]", name)[0] for name in project["dependencies"]}
    used = set()
    for folder in (ROOT / "src", ROOT / "plugins/standard"):
        for path in folder.rglob("*.py"):
            used |= imported(ast.parse(path.read_text(encoding="utf-8")))
    ours = {"roadlang", "roadlang_standard", *OPTIONAL, *sys.stdlib_module_names}
    assert {BY_IMPORT.get(name, name) for name in used - ours} == declared


def imported(tree: ast.AST) -> set[str]:
    """The packages that a module imports when it runs."""
    names: set[str] = set()
    pending: list[ast.AST] = [tree]
    while pending:
        node = pending.pop()
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            pending.extend(node.orelse)
            continue
        if isinstance(node, ast.Import):
            names |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and not node.level:
            names.add((node.module or "").partition(".")[0])
        pending.extend(ast.iter_child_nodes(node))
    return names
