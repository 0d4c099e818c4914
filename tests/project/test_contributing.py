"""CONTRIBUTING.md, the workflows and the metadata name only what there is."""

from __future__ import annotations

import importlib.util
import re
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

import roadlang

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
PROJECT: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
EXTRAS: dict[str, list[str]] = PROJECT["project"]["optional-dependencies"]
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))
#: Programs of the system or of a release, which the extra `dev` does not bring.
FOREIGN = {"awk", "bash", "cd", "gh", "grep", "python", "python3", "sh", "twine"}


def developer_packages() -> set[str]:
    """What `pip install -e ".[dev]"` brings by name, nested extras too."""
    found: set[str] = set()
    waiting = ["dev"]
    while waiting:
        for requirement in EXTRAS[waiting.pop()]:
            nested = re.fullmatch(r"roadlang\[([\w,]+)\]", requirement)
            if nested:
                waiting += nested[1].split(",")
            else:
                found.add(re.split(r"[<>=;~ ]", requirement)[0])
    return found


def commands_of_contributing() -> Iterator[str]:
    """Every command of a console block, and everything in backticks that begins with a program."""
    page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    for block in re.findall(r"^```console\n(.*?)^```$", page, re.M | re.S):
        for line in block.splitlines():
            yield from line.removeprefix("$ ").partition("#")[0].split("&&")
    prose = re.sub(r"^```.*?^```$", "", page, flags=re.M | re.S)
    for span in re.findall(r"`([^`\n]+)`", prose):
        if re.match(r"(python|pytest|roadlang|sh|bash|ruff|mypy|mkdocs|pre-commit) ", span):
            yield span


def commands_of_workflows() -> Iterator[str]:
    for path in WORKFLOWS:
        for job in yaml.safe_load(path.read_text(encoding="utf-8"))["jobs"].values():
            for step in job.get("steps", ()):
                for line in step.get("run", "").splitlines():
                    if re.match(r"(python|pytest|pip|ruff|mypy|mkdocs|bash|roadlang) ?", line):
                        yield line


def check_exists(command: str) -> None:
    """The program, and the scripts, modules, folders and extras that it is called with, exist."""
    words = shlex.split(command)
    if "=" in words[0]:
        words = words[1:]
    program, *arguments = words
    bundled = program in ("roadlang", ".", "pip") or program in FOREIGN
    assert bundled or program in developer_packages(), f"who brings {program}?"
    if program == "roadlang":
        from roadlang.cli.main import run

        assert run([arguments[0], "--help"]) == 0
    if program.startswith("python") and arguments[:1] == ["-m"]:
        module = arguments[1]
        assert module == "venv" or module in developer_packages() or exists(module), module
    for argument in arguments:
        if re.fullmatch(r"[\w.-]+/[\w./-]+", argument) and not argument.startswith((".venv", "$")):
            assert (ROOT / argument).exists(), argument
        for extra in re.findall(r"^\.\[([\w,]+)\]$", argument):
            assert set(extra.split(",")) <= set(EXTRAS), extra


def exists(module: str) -> bool:
    return importlib.util.find_spec(module) is not None


@pytest.mark.parametrize("command", [c.strip() for c in commands_of_contributing()])
def test_a_command_of_contributing_exists(command: str) -> None:
    check_exists(command)


@pytest.mark.parametrize("command", sorted(set(commands_of_workflows())))
def test_a_command_of_a_workflow_exists(command: str) -> None:
    check_exists(command)


def test_every_path_that_contributing_names_is_there() -> None:
    page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    prose = re.sub(r"^```.*?^```$", "", page, flags=re.M | re.S)
    for path in re.findall(r"`([\w.-]+(?:/[\w.-]+)+)`", prose):
        if not re.search(r"[A-Z]{4}\.", path) or path.endswith("LICENSE"):
            assert (ROOT / path).exists(), path


def test_the_matrix_has_every_python_that_the_project_claims() -> None:
    workflow = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8"))
    tested = set(workflow["jobs"]["tests"]["strategy"]["matrix"]["python"])
    prefix = "Programming Language :: Python :: "
    claimed = {name.removeprefix(prefix) for name in PROJECT["project"]["classifiers"]}
    assert tested == {name for name in claimed if re.fullmatch(r"3\.\d+", name)}
    assert PROJECT["project"]["requires-python"] == ">=" + min(tested, key=lambda v: int(v[2:]))


def test_every_hook_of_pre_commit_runs_a_tool_of_the_environment() -> None:
    config = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8"))
    for repository in config["repos"]:
        for hook in repository["hooks"]:
            check_exists(hook["entry"])


def test_the_citation_has_the_version_of_the_package() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert citation["version"] == roadlang.__version__


def test_the_changelog_has_releases_in_order_and_notes_for_the_next() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    titles = re.findall(r"^## (.*)$", text, re.M)
    assert titles[0] == "[Unreleased]" or titles[0].startswith(f"[{roadlang.__version__}] - ")
    dates = [title.partition(" - ")[2] for title in titles if not title.endswith("- unreleased")]
    assert dates == sorted(dates, reverse=True)
    assert all(re.fullmatch(r"\d{4}-\d\d-\d\d", date) for date in dates if date)
    sections = set(re.findall(r"^### (.*)$", text, re.M))
    assert sections <= {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}


def test_links_of_the_project_files_lead_somewhere() -> None:
    for name in ("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md"):
        text = (ROOT / name).read_text(encoding="utf-8")
        for target in re.findall(r"\]\(([^)#\s]+)", text):
            assert target.startswith("https:") or (ROOT / target).exists(), f"{name}: {target}"
