"""The results of runs: the rows of tables, and which drives are shown."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.files.journal import JOURNAL_FILE, SCHEMA
from roadlang.report.run_results import _chosen, _entries, _Entry, _Judged, results_folder

judged = _Judged


def entry(scene: int, *expectations: _Judged, run: str = "", **columns: Any) -> _Entry:
    return _Entry(run, {"scene": scene, **columns}, expectations, {})


@pytest.mark.parametrize(
    ("columns", "draws"),
    [
        ({"speed": 9.0, "at": 2.0, "apart": 1.5, "worst": "apart"}, ("speed", "at")),
        ({"speed": 9.0, "worst": "", "more": 1.0}, ("speed",)),
        ({"speed": 9.0, "at": 2.0}, ("speed", "at")),
        ({"apart": 1.5, "speed": 9.0}, ()),
    ],
)
def test_params_and_draws_are_the_columns_between_the_scene_and_the_expectations(
    columns: dict[str, Any], draws: tuple[str, ...]
) -> None:
    row = entry(3, judged("apart", 1.5, True), **columns).result_row(7)
    assert (row.number, row.has_failed, row.draws) == (7, False, draws)
    assert row.values == {"scene": 3, **columns}
    assert row.robustness == {"apart": 1.5}


def test_a_drive_of_several_runs_is_named_by_its_run() -> None:
    found = entry(3, judged("a", None, None), judged("b", 0.0, False), run="run-01", speed=9.0)
    row = found.result_row(0)
    assert row.values == {"run": "run-01", "scene": 3, "speed": 9.0}
    assert row.draws == ("speed",)
    assert row.has_failed
    assert (found.stem, entry(3).stem) == ("run-01/scene-0003", "scene-0003")


def test_failing_drives_come_worst_first_and_of_the_others_some_from_near_to_far() -> None:
    rho = [2.0, -1.0, 0.5, -3.0, *(float(n) for n in range(10, 40))]
    entries = [entry(n, judged("a", value, value > 0)) for n, value in enumerate(rho)]
    failing, safe = _chosen(entries, [e.result_row(n) for n, e in enumerate(entries)])
    assert [row.number for row in failing] == [3, 1]
    shown = [row.robustness["a"] for row in safe]
    assert (len(shown), shown[0], shown[1], shown[-1]) == (12, 0.5, 10.0, 39.0)
    few = entries[:1]
    assert [len(part) for part in _chosen(few, [few[0].result_row(0)])] == [0, 1]
    assert _chosen([], []) == ([], [])


HEADER = json.dumps({"schema": SCHEMA, "key": "k"}) + "\n"


def line(scene: int, **row: Any) -> str:
    return json.dumps({"row": {"scene": scene, **row}, "record": {"expectations": []}}) + "\n"


def test_of_a_scene_that_was_driven_again_the_last_line_counts(tmp_path: Path) -> None:
    (tmp_path / JOURNAL_FILE).write_text(HEADER + line(2, v=1) + line(0, v=2) + line(2, v=3))
    found = list(_entries(tmp_path, "run-1"))
    assert [(each.run, each.row["scene"], each.row["v"]) for each in found] == [
        ("run-1", 0, 2), ("run-1", 2, 3),
    ]  # fmt: skip


LINES = {
    '{"row": {}}': "missing required field `record`",
    '{"row": {}, "record": {"expectations": []}}': "`scene` is missing",
    line(0).replace("[]", '[{"name": "a", "robustness": "x", "satisfied": true}]'): "`str`",
    line(0).replace("[]", '[{"name": "a", "robustness": NaN, "satisfied": true}]'): "not JSON",
    '{"measures": "x", ' + line(0)[1:]: "`$.measures`",
    '{"measures": {"gap": "x"}, ' + line(0)[1:]: "`$.measures[...]`",
    line(0, v=float("nan")): "it is not JSON that roadlang writes",
}


@pytest.mark.parametrize("text", LINES)
def test_a_line_that_is_none_is_named(tmp_path: Path, text: str) -> None:
    (tmp_path / JOURNAL_FILE).write_text(HEADER + text.rstrip("\n") + "\n")
    with pytest.raises(DiagnosticError, match="RL721") as caught:
        list(_entries(tmp_path, ""))
    message = caught.value.diagnostics[0].message
    assert "line 2: " in message
    assert LINES[text] in message


def test_several_runs_stand_for_the_first_of_them(tmp_path: Path) -> None:
    assert results_folder(tmp_path) == tmp_path
    for name in ("run-2", "run-1", "other"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "provenance.json").write_text("{}")
    (tmp_path / "run-0").mkdir()
    assert results_folder(tmp_path) == tmp_path / "run-1"
    (tmp_path / "provenance.json").write_text("{}")
    assert results_folder(tmp_path) == tmp_path


def test_a_line_is_read_with_all_that_was_judged_and_measured(tmp_path: Path) -> None:
    verdicts = [
        {"name": "a", "robustness": 2.0, "satisfied": True, "time": 1.0},
        {"name": "b", "robustness": None, "satisfied": False, "time": None},
    ]
    drive = {"row": {"scene": 4}, "record": {"expectations": verdicts}, "measures": {"gap": 3.0}}
    (tmp_path / JOURNAL_FILE).write_text(HEADER + json.dumps(drive) + "\n")
    (found,) = _entries(tmp_path, "")
    assert found.expectations == (judged("a", 2.0, True), judged("b", None, False))
    assert found.measures == {"gap": 3.0}
    assert found.result_row(0).has_failed
