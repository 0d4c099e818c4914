"""What `roadlang watch` does with saves, with what is dragged in the window, and with faults."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import roadlang
from roadlang.cli.main import run
from roadlang_godot.commands.watch import Watcher, _lines
from roadlang_godot.engine import Engine
from roadlang_godot.live import Move
from tests.godot.godot_engines import started, until

pytestmark = pytest.mark.godot

TEXT = """road main { draw with waypoints { points: [(0m, 0m), (40m, 0m), (80m, %sm)] }, width: 8m }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s } }
object kiosk is building at (20m, 30m)
object tree is tree on main at 30m { side: left, offset: 4m }
let bend = abs(curvature(main))
require gentle: always (bend < 0.2/m)
expect slow: always (ego.speed < 3m/s)
expect arrives: eventually (ego.progress > 0.95)
expect moves: eventually (ego.speed > 2m/s)
"""


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    with started() as engine:
        yield engine


class Watched:
    """A watcher of a file, and its scene in a running engine."""

    def __init__(self, engine: Engine, file: Path, save: bool) -> None:
        file.write_text(TEXT % 0, encoding="utf-8")
        self.file = file
        loaded = roadlang.load(file)
        self.scenes = loaded.sample(1, seed=0)
        self.watcher = Watcher(loaded, 0, "mesh", save)
        self.session = engine.connect("watched")
        self.live = self.watcher.start(self.session, self.scenes[0].record)

    def take(self, what: str, name: str, end: tuple[float, float], done: bool = True) -> None:
        start = (80.0, 0.0) if what == "road" else (20.0, 30.0)
        self.watcher.take(Move(what, name, start, end, done))
        self.watcher.settle(self.live)


@pytest.mark.parametrize("save", [False, True])
def test_what_is_dragged_changes_the_scene_and_with_save_the_file(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str], save: bool
) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save)
    with watched.session:
        watched.take("object", "kiosk", (25.0, 31.0), done=False)
        assert watched.live.scene.objects[0].x == 20.0
        watched.take("object", "kiosk", (25.0, 31.0))
        kiosk = watched.live.scene.objects[0]
        assert (kiosk.x, kiosk.y) == (25.0, 31.0)
        watched.take("road", "main", (80.0, 6.0))
        main = watched.live.scene.roads[0]
        assert (main.x[-1], main.y[-1]) == pytest.approx((80.0, 6.0))
        assert ("(25m, 31m)" in watched.file.read_text()) is save
        assert ("(80m, 6m)" in watched.file.read_text()) is save
        printed = capsys.readouterr()
        assert printed.err == ""
        assert printed.out.count(" changes in ") == 2
        watched.take("object", "tree", (25.0, 31.0))
        assert (
            capsys.readouterr().out
            == f"`tree` is not placed by numbers in {watched.file}: it stays\n"
        )


def test_a_save_is_seen_once_and_a_moment_without_a_file_is_none(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save=False)
    with watched.session:
        watched.watcher.settle(watched.live)
        assert "changes" not in capsys.readouterr().out
        watched.file.write_text(TEXT % 5)
        for _ in range(3):
            watched.watcher.settle(watched.live)
        assert watched.live.scene.roads[0].y[-1] == pytest.approx(5.0)
        assert capsys.readouterr().out.count(" changes in ") == 1
        watched.file.unlink()
        watched.watcher.settle(watched.live)
        watched.file.write_text("raod main\n")
        watched.watcher.settle(watched.live)
        assert "raod" in capsys.readouterr().err
        assert watched.live.scene.roads[0].y[-1] == pytest.approx(5.0)


def test_robustness_is_shown_of_requirements_and_of_what_was_driven(
    engine: Engine, tmp_path: Path
) -> None:
    watched = Watched(engine, tmp_path / "scene.rl", save=False)
    with watched.session:
        assert _lines(watched.live, watched.scenes) == ["ok  gentle  0.20"]
        until(lambda: bool(watched.live.listen(0.05)) or watched.live.trace() is not None)
        gentle, slow, arrives, moves = _lines(watched.live, watched.scenes)
        assert gentle == "ok  gentle  0.20"
        assert slow.startswith("BROKEN  slow  -")
        assert arrives.startswith("undecided  arrives  -")
        assert moves.startswith("ok  moves  ")


def test_watching_ends_after_the_time_that_is_said(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "scene.rl"
    file.write_text(TEXT % 0, encoding="utf-8")
    words = ["watch", str(file), "--host", "127.0.0.1", "--port", str(engine.port)]
    assert run([*words, "--for", "0.5"]) == 0
    printed = capsys.readouterr().out
    assert printed == f"{file} is driven; save it to change it, Ctrl-C to leave\n"
