"""Drives whose files other processes make: those of one process, and nothing else, whoever is lost
meanwhile."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

import roadlang
from roadlang.drive.batches import DriveTask
from roadlang.files.staging import StagedFile, StagingFolder
from roadlang.files.transaction import PREFIX
from roadlang.search.worker_pool import ALONE, Workers
from roadlang.session.drives_in_parts import drive_in_parts
from roadlang.session.finished_drives import DriveFinishing
from roadlang.session.run_files import RunFolder
from tests.cli.command_lines import roadlang as roadlang_here

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m)] } width: 8m }
agent ego is car on main at 5m..15m { drive with stanley { speed: 50km/h } }
expect slow: always (ego.speed < 13m/s)
simulate with builtin { duration: 1s }
"""
COUNT = 150
"""Scenes that are several parts of each of two workers."""
FILES = 5
"""Of each drive."""
OTHERS = {"journal.jsonl", "provenance.json"}
POSIX = pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")


def files_in(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def drive_into(
    folder: Path, workers: Workers, count: int = COUNT, resume: bool = False
) -> list[type]:
    """Drive what is not finished; of what types the contents were that were handed over."""
    return _drive_into(folder, workers, count, resume, None)


def _drive_into(
    folder: Path, workers: Workers, count: int, resume: bool, marker: Path | None
) -> list[type]:
    scenes = roadlang.loads(TEXT).sample(count, seed=3)
    into = RunFolder(folder, "key", "{}", resume)
    open_ = [scene for scene in scenes if scene.index not in into.finished]
    finishing = DriveFinishing(DriveTask(scenes.loaded.registry, "builtin"), scenes.loaded)
    types: list[type] = []
    with into.staging(workers) as stage:
        if marker is not None:
            assert isinstance(stage.__self__, StagingFolder)  # type: ignore[attr-defined]
            stage = Lost(stage.__self__, marker).stage  # type: ignore[attr-defined]
        for drives in drive_in_parts(open_, replace(finishing, stage=stage), workers):
            types += [type(content) for drive in drives for content in drive.files.values()]
            into.add(drives)
    return types


class Lost:
    """Stages files, but ends its process where it has staged some for the first time."""

    def __init__(self, room: StagingFolder, marker: Path) -> None:
        self.room = room
        self.marker = marker
        self.staged = 0
        self.started_by = os.getpid()

    def stage(self, content: bytes) -> StagedFile:
        """As a staging folder does."""
        place = self.room.stage(content)
        self.staged += os.getpid() != self.started_by
        if self.staged == FILES + 2 and not self.marker.exists():
            self.marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return place


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    folder = tmp_path_factory.mktemp("alone")
    drive_into(folder, ALONE)
    found = files_in(folder)
    assert len(found) == FILES * COUNT + len(OTHERS)
    return found


def test_processes_make_what_one_makes_and_send_no_contents(
    tmp_path: Path, alone: dict[str, bytes]
) -> None:
    types = drive_into(tmp_path, Workers(2))
    assert files_in(tmp_path) == alone
    assert len(types) == FILES * COUNT
    assert set(types) == {StagedFile}


def test_an_executor_may_be_on_other_machines_and_sends_contents(
    tmp_path: Path, alone: dict[str, bytes]
) -> None:
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=context) as executor:
        types = drive_into(tmp_path, Workers(2, executor), 20)
    assert set(types) == {bytes}
    found = files_in(tmp_path)
    assert len(found) == FILES * 20 + len(OTHERS)
    others = found.keys() - OTHERS
    assert {name: found[name] for name in others} == {name: alone[name] for name in others}


@POSIX
def test_a_process_that_is_lost_after_it_staged_files_leaves_nothing(
    tmp_path: Path, alone: dict[str, bytes]
) -> None:
    marker = tmp_path / "marker"
    _drive_into(tmp_path / "out", Workers(2), COUNT, False, marker)
    assert marker.exists()
    assert files_in(tmp_path / "out") == alone


INTERRUPTED = """
import os, signal, sys
from roadlang.cli.main import main
from roadlang.files import journal, staging

how, number = sys.argv[1], getattr(signal, sys.argv[2])
if how == "staging":  # while a worker stages files its parent is ended
    staged = staging.StagingFolder.stage
    def stage(room, content):
        place = staged(room, content)
        if int(place.path.rpartition("-")[2]) == 200:
            try:  # by one worker alone: a second Ctrl-C may end what the first one cleans up
                os.close(os.open("ended", os.O_CREAT | os.O_EXCL))
                os.kill(os.getppid(), number)
            except FileExistsError:
                pass
        return place
    staging.StagingFolder.stage = stage
else:  # between the files of a part and its lines in the journal
    append = journal.JournalFile.append
    count = 0
    def appended(self, lines):
        global count
        count += 1
        if count == 2:
            os.kill(os.getpid(), number)
        append(self, lines)
    journal.JournalFile.append = appended
main(sys.argv[3:])
"""


@POSIX
@pytest.mark.parametrize(
    ("how", "number"),
    [
        ("staging", "SIGKILL"),
        ("staging", "SIGTERM"),
        ("staging", "SIGINT"),
        ("journal", "SIGKILL"),
        ("journal", "SIGTERM"),
    ],
)
def test_a_run_that_was_ended_leaves_whole_files_and_goes_on(
    how: str, number: str, tmp_path: Path
) -> None:
    (tmp_path / "scene.rl").write_text(TEXT)
    command = ["run", "scene.rl", "-n", str(COUNT), "--seed", "3"]
    whole = roadlang_here(*command, "-o", "whole", cwd=tmp_path)
    part = [*command, "-o", "part", "--jobs", "2"]
    ended = subprocess.run(
        [sys.executable, "-c", INTERRUPTED, how, number, *part],
        cwd=tmp_path,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        check=False,
    )
    assert ended.returncode not in (0, 4)
    expected = files_in(tmp_path / "whole")
    left = {path.name for path in (tmp_path / "part").iterdir()}
    for name in left - OTHERS:
        if not name.startswith(PREFIX):
            assert (tmp_path / "part" / name).read_bytes() == expected[name]
    rooms = [name for name in left if name.startswith(PREFIX)]
    assert len(rooms) == (number == "SIGKILL")
    resumed = roadlang_here(*part, "--resume", cwd=tmp_path)
    assert resumed.returncode == whole.returncode
    found = files_in(tmp_path / "part")
    assert found == expected


@POSIX
def test_a_room_of_a_run_that_was_killed_is_removed_by_one_that_begins_anew(
    tmp_path: Path,
) -> None:
    (tmp_path / "scene.rl").write_text(TEXT)
    command = ["run", "scene.rl", "-n", str(COUNT), "--seed", "3", "-o", "out", "--jobs", "2"]
    script = [sys.executable, "-c", INTERRUPTED, "staging", "SIGKILL", *command]
    subprocess.run(script, cwd=tmp_path, stdout=subprocess.DEVNULL, check=False)
    assert list((tmp_path / "out").glob(f"{PREFIX}*"))
    roadlang_here("run", "scene.rl", "-n", "2", "--seed", "3", "-o", "out", cwd=tmp_path)
    names = {path.name for path in (tmp_path / "out").iterdir()}
    stems = {name.partition(".")[0] for name in names - OTHERS}
    assert stems == {"scene-0000", "scene-0001", "results"}
