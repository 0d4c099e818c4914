"""Runs of one scene file with different params: a folder for each, and a table of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from ..files.writing import remove_set, write_file
from ..ir.manifest import MANIFEST_FILE
from ..ir.result_files import numbered_runs, run_name
from .loading import LoadedScenario
from .manifest_files import files_named_in
from .param_files import read_params
from .tables import columns_of, to_csv

TABLE = "runs.csv"


def variants(loaded: LoadedScenario, params: str | None) -> tuple[Sequence[LoadedScenario], bool]:
    """The scenario with the params of a file, and whether that holds a list of them."""
    if params is None:
        return [loaded], False
    found = read_params(params)
    return loaded.with_param_file(found), found.is_list


def run_folders(target: Path, count: int) -> list[Path]:
    """`run-000`, `run-001`, ... in `target`."""
    return [target / run_name(number) for number in range(count)]


def remove_later_runs(target: Path, count: int, remove: Callable[[Path], None]) -> None:
    """Remove the runs of an earlier table beyond the first `count`."""
    folders = run_folders(target, count)
    for path in numbered_runs(target):
        if path not in folders:
            remove(path)


def write_runs(target: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Write the table of runs, and remove the sets of earlier runs beyond these.

    Raises `DiagnosticError` RL460.
    """
    folders = run_folders(target, len(rows))
    named = [{"run": path.name, **row} for path, row in zip(folders, rows, strict=True)]
    write_file(target / TABLE, to_csv(columns_of(named)))
    remove_later_runs(target, len(rows), _remove_set)


def _remove_set(folder: Path) -> None:
    remove_set(folder, MANIFEST_FILE, files_named_in)
