"""`roadlang plugins new`: a plugin that can be installed, passes its tests and is typed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang.cli.plugin_template import VERBS


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def new(*arguments: str) -> int:
    return run(["plugins", "new", *arguments])


def paths_in(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def test_a_plugin_perturbs_where_nothing_else_is_said(folder: Path) -> None:
    assert new("acme") == 0
    assert paths_in(folder) == {
        f"roadlang-acme/{path}"
        for path in (
            ".gitignore",
            "README.md",
            "pyproject.toml",
            "src/roadlang_acme/__init__.py",
            "src/roadlang_acme/perturb_acme.py",
            "src/roadlang_acme/py.typed",
            "tests/test_perturb_acme.py",
            "tests/test_plugin.py",
        )
    }


def test_nothing_of_the_template_is_left_open(folder: Path) -> None:
    assert new("acme_kit", *(word for verb in VERBS for word in ("--kind", verb))) == 0
    for path in (folder / "roadlang-acme-kit").rglob("*"):
        assert path.is_dir() or "{{" not in path.read_text(), path


def test_the_file_that_a_reader_reads_stands_beside_its_tests(folder: Path) -> None:
    assert new("acme", "--kind", "read") == 0
    assert "tests/track.acme" in paths_in(folder / "roadlang-acme")
    assert '"track.acme"' in (folder / "roadlang-acme/README.md").read_text()


def test_an_existing_folder_is_left_alone(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "roadlang-acme").mkdir()
    assert new("acme") == 2
    assert "error[RL929]: `roadlang-acme` already exists" in capsys.readouterr().err
    assert not paths_in(folder)
    assert new("acme", "--folder", "elsewhere/acme") == 0
    assert (folder / "elsewhere/acme/pyproject.toml").exists()


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("my-kit", "did you mean `my_kit`?"),
        ("roadlang-acme", "did you mean `acme`?"),
        ("MyKit", "did you mean `my_kit`?"),
        ("Über-Kit", "did you mean `uber_kit`?"),
        ("9", "beginning with a letter"),
        ("", "beginning with a letter"),
        ("../acme", "did you mean `acme`?"),
        ("with", "it is a keyword"),
        ("standard", "has a plugin with this name"),
        ("sine", "its kind would be called `perturb sine`"),
    ],
)
def test_a_bad_name_is_refused(
    name: str, says: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert new("--", name) == 2
    printed = capsys.readouterr().err
    assert "error[RL938]" in printed
    assert says in printed
    assert not paths_in(folder)


def test_an_unknown_template_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert new("acme", "--kind", "pertub") == 2
    printed = capsys.readouterr().err
    assert "error[RL930]: there is no template called `pertub`" in printed
    assert "did you mean `perturb`?" in printed


def test_a_folder_that_cannot_be_written_is_reported(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "file").write_text("")
    assert new("acme", "--folder", "file/acme") == 2
    assert "error[RL927]" in capsys.readouterr().err
    assert new("acme", "--folder", "x" * 300) == 2
    assert "error[RL927]" in capsys.readouterr().err
    assert paths_in(folder) == {"file"}


@pytest.mark.slow
def test_a_new_plugin_is_installed_passes_its_tests_and_is_typed(folder: Path) -> None:
    pytest.importorskip("mypy")
    assert new("acme", *(word for verb in VERBS for word in ("--kind", verb))) == 0
    project, site = folder / "roadlang-acme", folder / "site"
    python(folder, site, "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation",
           "--target", str(site), str(project))  # fmt: skip
    shown = python(folder, site, "-m", "roadlang", "plugins")
    assert all(f"{verb} acme " in shown for verb in VERBS), shown
    assert " passed" in python(project, site, "-m", "pytest", "-p", "no:cacheprovider")
    assert "Success" in python(project, site, "-m", "mypy", "--strict", "--cache-dir", os.devnull)


def python(cwd: Path, site: Path, *arguments: str) -> str:
    """What Python prints with the packages of `site`; it must succeed."""
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=cwd,
        env={**os.environ, "PYTHONPATH": str(site)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
