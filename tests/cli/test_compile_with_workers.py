"""Scenes that other processes write: the same files as of one process, and nothing else."""

from __future__ import annotations

import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import pytest

import roadlang
from roadlang.diagnostics import DiagnosticError
from roadlang.files.staging import StagedFile
from roadlang.search.worker_pool import ALONE, Workers
from roadlang.session.compiling import compiled
from roadlang.session.emitting import SetWriting
from tests.search.worker_killer import WorkerKiller

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m)] } width: 8m }
road bent from main {
  perturb with sine { amplitude: 1m..4m, wavelength: 90m, phase: 0deg..360deg }
}
require near: always (abs(deviation(bent, main)) < 3m)
agent ego is car on bent at 5m { drive with stanley { speed: 50km/h } }
emit json
emit svg
"""
MANY = 300
"""Scenes that are several messages of each of two workers."""


def files_in(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    folder = tmp_path_factory.mktemp("alone") / "out"
    compiled(roadlang.loads(TEXT), folder, MANY, 3, ALONE)
    return files_in(folder)


@pytest.fixture
def taken(monkeypatch: pytest.MonkeyPatch) -> list[type]:
    """Of what type the contents were that came from workers."""
    types: list[type] = []
    take = SetWriting.take

    def noted(self: SetWriting, record: object, content: object) -> None:
        types.append(type(content))
        take(self, record, content)  # type: ignore[arg-type]

    monkeypatch.setattr(SetWriting, "take", noted)
    return types


def test_processes_write_what_one_writes_and_send_no_contents(
    tmp_path: Path, alone: dict[str, bytes], taken: list[type]
) -> None:
    compiled(roadlang.loads(TEXT), tmp_path / "out", MANY, 3, Workers(2))
    assert files_in(tmp_path / "out") == alone
    assert os.listdir(tmp_path) == ["out"]
    assert taken.count(StagedFile) == 2 * MANY


def test_in_a_folder_that_is_there_the_rest_stays(tmp_path: Path, alone: dict[str, bytes]) -> None:
    (tmp_path / "mine").write_bytes(b"kept")
    compiled(roadlang.loads(TEXT), tmp_path, MANY, 3, Workers(2))
    assert files_in(tmp_path) == {**alone, "mine": b"kept"}


def test_a_process_that_is_lost_leaves_nothing(tmp_path: Path, alone: dict[str, bytes]) -> None:
    killer = WorkerKiller()
    compiled(roadlang.loads(TEXT), tmp_path / "out", MANY, 3, Workers(2, progress=killer))
    assert killer.killed
    assert files_in(tmp_path / "out") == alone


def test_an_executor_may_be_on_other_machines_and_sends_contents(
    tmp_path: Path, alone: dict[str, bytes], taken: list[type]
) -> None:
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=context) as executor:
        compiled(roadlang.loads(TEXT), tmp_path / "out", 20, 3, Workers(2, executor))
    assert StagedFile not in taken
    names = [f"scene-{number:04}.json" for number in range(20)]
    found = files_in(tmp_path / "out")
    assert {name: found[name] for name in names} == {name: alone[name] for name in names}


@pytest.mark.parametrize("jobs", [1, 2])
def test_two_files_of_one_name_are_refused_and_nothing_is_left(tmp_path: Path, jobs: int) -> None:
    text = TEXT.replace("emit svg", "emit json")
    with pytest.raises(DiagnosticError, match="RL931"):
        compiled(roadlang.loads(text), tmp_path / "out", MANY, 3, Workers(jobs))
    assert os.listdir(tmp_path) == []
