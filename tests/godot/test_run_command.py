"""`roadlang run` with a real engine: traces are written, expectations judged, the code says it."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from roadlang.cli import main as cli
from roadlang.drive.trace_files import from_json
from tests.godot.godot_engines import require_engine

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
    require_engine()
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


def test_the_summary_says_how_many_hold_and_where_the_files_are(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(tmp_path, "9m/s") == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert last == "all expectations hold in 1 of 1 scene; traces and verdicts in out"


def test_results_are_a_table_of_scenes_by_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    require_engine()
    (tmp_path / "scene.rl").write_text("param limit = 9m/s\n" + SCENE.format(limit="limit"))
    (tmp_path / "runs.yaml").write_text("- limit: 9m/s\n- limit: 6m/s\n")
    words = ["run", str(tmp_path / "scene.rl"), "--params", str(tmp_path / "runs.yaml")]
    assert cli.run([*words, "-o", str(tmp_path / "out"), "--duration", "5"]) == 4
    assert "run-001: scene 0: 5.0 s driven in" in capsys.readouterr().out
    rows = list(csv.DictReader((tmp_path / "out/results.csv").open()))
    assert [row["run"] for row in rows] == ["run-000", "run-001"]
    assert [row["limit"] for row in rows] == ["9", "6"]
    assert [row["calm satisfied"] for row in rows] == ["true", "false"]
    assert float(rows[0]["calm"]) - float(rows[1]["calm"]) == pytest.approx(3.0, abs=0.2)
    assert (tmp_path / "out/run-001/scene-0000.trace.csv").exists()


def test_from_python_a_drive_is_columns_and_verdicts(tmp_path: Path) -> None:
    import numpy as np

    import roadlang
    from roadlang import stl

    require_engine()
    (scene,) = roadlang.loads(SCENE.format(limit="9m/s")).sample()
    drive = scene.run("godot", duration=3.0)
    assert drive.engine.lower().startswith("godot")
    assert drive.duration == pytest.approx(3.0, abs=0.05)
    columns = drive.to_dict()
    assert list(columns)[:3] == ["time", "ego.x", "ego.y"]
    assert {len(column) for column in columns.values()} == {len(drive.trace.time)}
    calm = drive.verdicts["calm"]
    assert calm.satisfied
    speed = columns["ego.speed"]
    assert calm.robustness == pytest.approx(9.0 - float(np.max(speed)))
    again = stl.parse("always (ego_speed < 9)").rho(columns["time"], {"ego_speed": speed})
    assert float(np.min(again)) == pytest.approx(calm.robustness)
    drives = roadlang.loads(SCENE.format(limit="6m/s")).sample().run(duration=3.0)
    assert not drives.satisfied
    assert drives.to_dict()["calm satisfied"] == [False]
    assert [found.name for found in drives.expectations if found.violated] == ["calm", "arrives"]


def test_an_option_that_an_engine_does_not_have_is_said() -> None:
    import roadlang

    (scene,) = roadlang.loads(SCENE.format(limit="9m/s")).sample()
    with pytest.raises(roadlang.DiagnosticError, match=r"RL220(.|\n)*did you mean `duration`"):
        scene.run("godot", durations=3.0)
    with pytest.raises(roadlang.DiagnosticError, match="RL208"):
        scene.run("godot", duration=-3.0)


def test_a_violated_expectation_leaves_with_4(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, "6m/s") == 4
    output = capsys.readouterr().out
    assert "violated" in output
    assert "robustness -2" in output
