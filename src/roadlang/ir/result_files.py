"""The names of files of results, for who writes them and for who reads them."""

from __future__ import annotations

import os
from pathlib import Path

FAILURES, SAFE = "failures", "safe"
"""Folders of a search."""
INDEX, SUMMARY = "index.json", "summary.json"
SCENE, TRACE, TRACE_TABLE = ".json", ".trace.json", ".trace.csv"
"""What the names of the files of a drive end in."""
SCENARIO = ".rl"
"""What the name of a scene file ends in: of scenarios, from which scenes are sampled."""
SHRUNK, SHRUNK_FIGURE, EXPLANATION = ".shrunk.json", ".shrunk.svg", ".explanation.json"
"""What `roadlang shrink` and `roadlang explain` find, in place of the `.json` of the failure."""
REPORT = "report.html"
"""The page that `roadlang report` makes in a folder of results."""
REPORT_GENERATOR = "roadlang report"
"""What such a page says that it was made by."""
_RUN = "run-"


def is_scene_file_name(name: str) -> bool:
    """Whether a file is meant to hold one scene as JSON, rather than a scenario."""
    return name.lower().endswith(SCENE)


def numbered_stem(number: int) -> str:
    """What the names of the files of a drive of a search begin with; failures count from 1."""
    return f"{number:04d}"


def numbered_scenes(folder: Path) -> list[Path]:
    """The scenes of drives of a search in its folder of failures, in order."""
    found = [path for path in folder.glob(f"[0-9]*{SCENE}") if path.stem.isdigit()]
    return sorted(found, key=lambda path: int(path.stem))


def run_name(number: int) -> str:
    """The folder of one of several runs of a scene file, counted from 0."""
    return f"{_RUN}{number:03d}"


def numbered_runs(folder: Path) -> list[Path]:
    """The folders of runs in a folder, in order; none where there is no such folder."""
    if not os.path.isdir(folder):  # `glob` raises where a name is too long for a folder
        return []
    names = ((path, path.name.removeprefix(_RUN)) for path in folder.glob(f"{_RUN}[0-9]*"))
    numbers = {path: int(name) for path, name in names if name.isdecimal() and path.is_dir()}
    return sorted(numbers, key=lambda path: (numbers[path], path))
