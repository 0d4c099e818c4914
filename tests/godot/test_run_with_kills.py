"""`roadlang run` with engines that something kills: the files are those of an undisturbed run."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from roadlang.cli import main as cli
from roadlang_godot.engines import engine as engines
from roadlang_godot.net import session as sessions
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
    """Kills one engine after another: each has then sent so many datagrams; 0: it just starts."""

    def __init__(self, moments: list[int]) -> None:
        self._left = moments
        self._start, self._hear = engines._spawn, sessions.Session._take
        self._process: subprocess.Popen[bytes] | None = None
        self._heard = 0

    def spawn(self, command: list[str], log: Path) -> subprocess.Popen[bytes]:
        self._process, self._heard = self._start(command, log), 0
        self._kill()
        return self._process

    def hear(self, session: sessions.Session, datagram: bytes) -> None:
        self._heard += 1
        self._kill()
        self._hear(session, datagram)

    def _kill(self) -> None:
        if self._process is not None and self._left and self._heard == self._left[0]:
            self._left.pop(0)
            self._process.kill()


@BY_BOTH
def test_engines_killed_at_any_moment_change_nothing(
    undisturbed: Callable[[str], dict[str, bytes]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    drive: str,
) -> None:
    alone = undisturbed(drive)
    cores = cores_of_this_thread()
    moments = [0, 3, 12]
    killer = Killer(moments)
    monkeypatch.setattr(engines, "_spawn", killer.spawn)
    monkeypatch.setattr(sessions.Session, "_take", lambda *heard: killer.hear(*heard))
    assert files(tmp_path / "disturbed", drive, "-n", "3") == alone
    assert cores_of_this_thread() == cores
    assert moments == [], "all were killed"
