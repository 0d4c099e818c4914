"""`roadlang run` with engines that something kills: the files are those of an undisturbed run."""

from __future__ import annotations

import os
import subprocess
import threading
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from roadlang.cli import main as cli
from roadlang_godot.engines import engine as engines
from tests.godot.godot_engines import require_engine

pytestmark = pytest.mark.godot

SCENE = """param bend = choice(10m, 20m, 30m)
road main {
  draw with waypoints { points: [(0m, 0m), (40m, 0m), (70m, 10m)] }
  width: 8m
}
agent ego is car on main at uniform(4m, 8m) { drive with DRIVE { speed: 8m/s } }
expect calm: always (ego.speed < 9m/s)
"""


def files(folder: Path, drive: str, *words: str) -> dict[str, bytes]:
    file = folder.parent / "scene.rl"
    file.write_text(SCENE.replace("DRIVE", drive), encoding="utf-8")
    command = ["run", str(file), "--engine", "godot", "--duration", "2.5", "-o", str(folder)]
    assert cli.run([*command, *words]) == 0
    names = ("*.csv", "*.json")
    found = {path.name: path.read_bytes() for name in names for path in folder.glob(name)}
    return {name: data for name, data in found.items() if name != "provenance.json"}


# The engine drives by itself, or in lock-step with Python.
BY_BOTH = pytest.mark.parametrize("drive", ["pure_pursuit", "traffic"])


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], dict[str, bytes]]:
    """The files of three drives, which both tests compare."""
    require_engine()
    return cache(lambda drive: files(tmp_path_factory.mktemp(drive) / "alone", drive, "-n", "3"))


@BY_BOTH
def test_more_engines_give_the_same_files(
    undisturbed: Callable[[str], dict[str, bytes]], tmp_path: Path, drive: str
) -> None:
    alone = undisturbed(drive)
    assert len(alone) > 3
    assert files(tmp_path / "both", drive, "-n", "3", "--jobs", "2") == alone


def cores_of_this_thread() -> set[int]:
    return os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else set()


class Killer:
    """Kills the engine that runs, again and again, whatever it does just then."""

    def __init__(self, pauses: list[float]) -> None:
        self._pauses = iter(pauses)
        self._start = engines._spawn
        self.killed: list[int] = []
        self._timers: list[threading.Timer] = []

    def spawn(self, command: list[str], log: Path) -> subprocess.Popen[bytes]:
        process = self._start(command, log)
        pause = next(self._pauses, None)
        if pause is not None:
            timer = threading.Timer(pause, self._kill, [process])
            self._timers.append(timer)
            timer.start()
        return process

    def _kill(self, process: subprocess.Popen[bytes]) -> None:
        if process.poll() is None:
            process.kill()
            self.killed.append(process.pid)

    def end(self) -> None:
        for timer in self._timers:
            timer.join()


@BY_BOTH
def test_engines_killed_at_any_moment_change_nothing(
    undisturbed: Callable[[str], dict[str, bytes]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    drive: str,
) -> None:
    alone = undisturbed(drive)
    cores = cores_of_this_thread()
    killer = Killer([0.05, 0.4, 0.8])
    monkeypatch.setattr(engines, "_spawn", killer.spawn)
    assert files(tmp_path / "disturbed", drive, "-n", "3") == alone
    assert cores_of_this_thread() == cores
    killer.end()
    assert len(killer.killed) >= 2
