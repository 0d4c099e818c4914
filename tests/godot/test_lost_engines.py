"""Engines that are killed, clients that are killed, and engines that cannot start."""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from roadlang.api import Scene, Trace
from roadlang_godot.drive import driving, simulate
from roadlang_godot.engines import engine as engines
from roadlang_godot.engines import restarted_engine
from roadlang_godot.faults import EngineError
from roadlang_godot.net.session import Session
from tests.godot.godot_engines import require_engine, until
from tests.godot.godot_scenes import call, car, pieces, road, scene, straight

pytestmark = pytest.mark.godot

SETTINGS = simulate.Settings(duration=2.0, step=0.1)


def scenes() -> list[Scene]:
    main = road("main", pieces(straight(60)))
    return [
        scene(main, agents=[car("ego", main, 5.0, call("pure_pursuit", speed=v, lookahead=5.0))])
        for v in (5.0, 7.0)
    ]


def traces() -> list[Trace]:
    return list(simulate.drive_scenes(scenes(), SETTINGS, [{}, {}]))


@cache
def undisturbed_traces() -> list[Trace]:
    require_engine()
    return traces()


def kills(
    monkeypatch: pytest.MonkeyPatch,
    when: Callable[[int], bool],
    by: signal.Signals = signal.SIGKILL,
) -> list[int]:
    """Engines end by a signal in drives of these numbers. Returns those that ended so far."""
    killed: list[int] = []
    running: list[engines.Engine] = []
    start, drive = engines.start, driving.run
    count = 0

    def noted(**options: object) -> engines.Engine:
        running.append(start(**options))  # type: ignore[arg-type]
        return running[-1]

    def interrupted(session: Session, ticks: int, **options: object) -> driving.GodotDrive:
        nonlocal count
        count += 1
        if when(count):
            session.flush()
            running[-1].process.send_signal(by)
            killed.append(running[-1].process.pid)
        return drive(session, ticks, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(engines, "start", noted)
    monkeypatch.setattr(driving, "run", interrupted)
    return killed


def test_drives_whose_engines_are_killed_give_the_same_traces(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    undisturbed = undisturbed_traces()
    killed = kills(monkeypatch, lambda drive: drive in (1, 2, 4))
    again = traces()
    assert len(killed) == 3
    for one, other in zip(undisturbed, again, strict=True):
        for column in ("x", "y", "heading", "speed", "steering"):
            values = [getattr(trace.agents["ego"], column) for trace in (one, other)]
            np.testing.assert_array_equal(*values)


def test_a_scene_that_loses_every_engine_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    require_engine()
    killed = kills(monkeypatch, lambda drive: drive > 1, signal.SIGSEGV)
    driven = simulate.drive_scenes(scenes(), SETTINGS, [{}, {}])
    next(iter(driven))
    with pytest.raises(EngineError, match=r"RL505.*3 engines were lost in scene 0 of `test`"):
        next(iter(driven))
    assert len(killed) == restarted_engine.MOST_LOSSES


def test_a_scene_in_which_all_engines_are_killed_is_named_as_well(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    require_engine()
    monkeypatch.setattr(restarted_engine, "MOST_KILLS", 2)
    killed = kills(monkeypatch, lambda drive: True)
    with pytest.raises(EngineError, match=r"RL505.*2 engines were lost in scene 0 of `test`"):
        traces()
    assert len(killed) == 2


class Killed:
    """Starts engines, of which the first `count` are killed before anything is built in them."""

    def __init__(self, count: int) -> None:
        self.left = count
        self.start = engines.start

    def __call__(self, **options: object) -> engines.Engine:
        engine = self.start(**options)  # type: ignore[arg-type]
        if self.left:
            self.left -= 1
            engine.process.kill()
            engine.process.wait()
        return engine


def test_engines_that_are_killed_while_they_start_count_against_no_scene(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    undisturbed = undisturbed_traces()
    monkeypatch.setattr(restarted_engine, "MOST_LOSSES", 1)
    killed = Killed(restarted_engine.MOST_LOSSES + 2)
    monkeypatch.setattr(engines, "start", killed)
    again = traces()
    assert killed.left == 0
    for one, other in zip(undisturbed, again, strict=True):
        np.testing.assert_array_equal(one.agents["ego"].x, other.agents["ego"].x)


def test_engines_that_never_start_are_no_fault_of_a_scene(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    require_engine()
    monkeypatch.setattr(restarted_engine, "MOST_KILLS", 2)
    killed = Killed(2)
    monkeypatch.setattr(engines, "start", killed)
    with pytest.raises(EngineError, match="RL505") as found:
        traces()
    assert killed.left == 0
    assert "scene" not in str(found.value)


def test_an_engine_ends_with_whoever_started_it() -> None:
    require_engine()
    program = (
        "from roadlang_godot.engines import engine\n"
        "print(engine.start().process.pid, flush=True)\n"
        "input()\n"
    )
    client = subprocess.Popen(
        [sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert client.stdout is not None
    engine = int(client.stdout.readline())
    assert _runs(engine)
    client.kill()
    client.wait()
    until(lambda: not _runs(engine))
    assert not list(Path(tempfile.gettempdir()).glob(f"roadlang-godot-{client.pid}-*"))


def test_a_port_in_use_is_named() -> None:
    require_engine()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
        with pytest.raises(EngineError, match=rf"RL501(.|\n)*port {port} of 127.0.0.1 is in use"):
            engines.start(port=port)


def test_an_engine_that_is_too_old_is_named_with_its_version(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    old = tmp_path / "godot"
    old.write_text('#!/bin/sh\n[ "$1" = --version ] && echo 3.5.stable\nexit 0\n')
    old.chmod(0o755)
    monkeypatch.setenv("ROADLANG_GODOT", str(old))
    with pytest.raises(EngineError, match=r"RL511(.|\n)*3\.5"):
        engines.start()


def test_an_engine_that_prints_errors_and_does_not_listen_says_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    faulty = tmp_path / "godot"
    faulty.write_text(
        '#!/bin/sh\n[ "$1" = --version ] && echo 4.6.stable && exit\n'
        "echo 'SCRIPT ERROR: Parse Error: no such file'\nexec sleep 600\n"
    )
    faulty.chmod(0o755)
    monkeypatch.setenv("ROADLANG_GODOT", str(faulty))
    with pytest.raises(EngineError, match=r"RL501(.|\n)*Parse Error: no such file"):
        engines.start()


def _runs(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().split(") ")[1][0] != "Z"
    except FileNotFoundError:
        return False
