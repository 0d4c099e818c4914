"""`roadlang run` with a real engine: traces are written, expectations judged, the code says it."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from roadlang.cli import main as cli
from roadlang.drive.trace_files import from_json
from tests.godot.godot_engines import started

pytestmark = pytest.mark.godot

SCENE = """road main {{
  draw with waypoints {{ points: [(0m, 0m), (80m, 0m), (150m, 30m)] }}
  width: 8m
}}
agent ego is car on main at 5m {{ drive with pure_pursuit {{ speed: 8m/s }} }}
expect calm: always (ego.speed < {limit})
expect arrives: eventually[0s, 60s] (ego.progress > 95%)
expect no_crash: always (ego.contacts == 0)
expect forward: always (ego.speed >= 0m/s)
"""


def run(folder: Path, limit: str) -> int:
    started().stop()
    file = folder / "scene.rl"
    file.write_text(SCENE.format(limit=limit), encoding="utf-8")
    return cli.run(["run", str(file), "--engine", "godot", "-o", str(folder / "out")])


def test_kept_expectations_leave_with_0_and_the_trace_is_written(tmp_path: Path) -> None:
    assert run(tmp_path, "9m/s") == 0
    rows = list(csv.DictReader((tmp_path / "out/scene-0000.trace.csv").open()))
    trace = from_json((tmp_path / "out/scene-0000.trace.json").read_text())
    assert len(rows) == len(trace.time)
    assert float(rows[-1]["progress"]) == pytest.approx(trace.agents["ego"].progress[-1])
    assert trace.agents["ego"].progress[-1] > 0.99
    verdicts = json.loads((tmp_path / "out/scene-0000.verdicts.json").read_text())
    assert [v["satisfied"] for v in verdicts["expectations"]] == [True] * 4


def test_a_violated_expectation_leaves_with_4(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, "6m/s") == 4
    output = capsys.readouterr().out
    assert "violated" in output
    assert "robustness -2" in output
