"""A human drives with real keys; the drive is judged as any other, and replayed exactly."""

from __future__ import annotations

import json
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang.cli import main as cli
from roadlang.drive.trace_files import from_json
from roadlang.ir.trace import AgentTrace
from roadlang_godot.engines import engine as engines
from tests.godot.godot_engines import require_engine
from tests.godot.virtual_screen import Hand

pytestmark = pytest.mark.godot

START = engines.start
SCENE = """road main {{ draw with waypoints {{ points: [(0m, 0m), (200m, 0m)] }}, width: 30m }}
agent ego is car on main at 10m {{ start_speed: 1m/s, {drive} }}
expect moves: eventually (ego.speed > 3m/s)
expect slow: always (ego.speed < 2m/s)
"""


def driven(file: Path, drive: str, *words: str) -> tuple[int, AgentTrace, list[bool]]:
    file.write_text(SCENE.format(drive=drive))
    out = file.with_suffix("")
    command = ["run", str(file), "--engine", "godot", "--duration", "3", "-o", str(out)]
    code = cli.run([*command, *words])
    trace = from_json((out / "scene-0000.trace.json").read_text())
    verdicts = json.loads((out / "scene-0000.verdicts.json").read_text())
    return code, trace.agents["ego"], [v["satisfied"] for v in verdicts["expectations"]]


def small_window(**options: Any) -> engines.Engine:
    """An engine whose window is soon drawn."""
    extra = ["--resolution", "320x180", "--max-fps", "15"] if options.get("window") else []
    return START(**options, extra=extra)


def hold(screen: str, keys: tuple[str, ...], done: threading.Event) -> None:
    """Keys are held down in the window as soon as there is one, until the drive is over."""
    hand = Hand(screen)
    for key in keys:
        hand.do("keydown", key)
    done.wait()
    for key in keys:
        hand.do("keyup", key)


def test_a_human_drives_is_judged_and_is_replayed(
    screen: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    require_engine()
    monkeypatch.setenv("DISPLAY", screen)
    monkeypatch.setattr(engines, "start", small_window)
    done = threading.Event()
    human = threading.Thread(target=hold, args=(screen, ("w", "Left"), done))
    human.start()
    try:
        code, ego, satisfied = driven(tmp_path / "human.rl", "drive with manual", "--window")
    finally:
        done.set()
        human.join()
    assert (code, satisfied) == (4, [True, False])
    assert ego.y[-1] > 0.5, "it turned left"
    assert ego.speed[-1] > ego.speed[0] + 2.0
    recorded = tmp_path / "human" / "scene-0000.trace.csv"
    replay = f'drive with replay {{ file: "{recorded}" }}'
    code, again, judged = driven(tmp_path / "again.rl", replay)
    assert (code, judged) == (4, satisfied)
    inputs = tmp_path / "human" / "scene-0000.ego.inputs.csv"
    driven(tmp_path / "inputs.rl", f'drive with replay {{ file: "{inputs}" }}')
    for ending in ("trace.csv", "trace.json"):
        first_run, same = (tmp_path / name / f"scene-0000.{ending}" for name in ("human", "inputs"))
        assert same.read_bytes() == first_run.read_bytes(), ending
    for column, apart in (("x", 1e-3), ("y", 1e-3), ("heading", 1e-3), ("speed", 0.05)):
        first, second = getattr(ego, column), getattr(again, column)
        np.testing.assert_allclose(second, first[: len(second)], atol=apart, err_msg=column)


def test_nobody_drives_without_a_window(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    require_engine()
    file = tmp_path / "scene.rl"
    file.write_text(SCENE.format(drive="drive with manual"))
    assert cli.run(["run", str(file), "--engine", "godot", "-o", str(tmp_path / "out")]) == 5
    assert "RL510" in (printed := capsys.readouterr().err)
    assert "--window" in printed
