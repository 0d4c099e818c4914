"""Columns of users whose names are those of roadlang's: nothing is overwritten, and all is read."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from roadlang import testing
from roadlang.cli.main import run
from roadlang.ir.result_columns import OF_DRIVES, named_in, robustness_column, value_columns

TEXT = """
param scene = 3..5
param run = 1..2
param evaluation = 1..2
param candidates = 1
param verdict = 1m..2m
road main { draw with segments { pieces: [straight(200m)] } }
agent ego is car on main at 10m { drive with lane_follow { speed: 8m/s..12m/s } }
expect worst: always (ego.speed <= 9m/s)
expect violated: always (ego.speed <= 20m/s)
simulate with builtin { duration: 1s }
falsify with random { evaluations: 6 }
"""


@pytest.fixture(autouse=True)
def scene_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("names.rl").write_text(TEXT)


def rows(path: str) -> list[dict[str, str]]:
    with Path(path).open(newline="") as file:
        return list(csv.DictReader(file))


def test_names_stay_as_they_are_where_the_table_has_no_such_column() -> None:
    values = {"speed": 1.0, "scene": 2.0, "ego/at": 3.0}
    columns = value_columns(values, OF_DRIVES)
    assert columns == {"speed": 1.0, "scene value": 2.0, "ego/at": 3.0}
    assert [named_in(column) for column in columns] == list(values)
    found = [robustness_column(name, OF_DRIVES) for name in ("clear", "worst")]
    assert found == ["clear", "worst robustness"]
    assert [named_in(column) for column in found] == ["clear", "worst"]


def test_a_run_is_written_resumed_and_reported(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["run", "names.rl", "-n", "2", "-o", "out"]
    assert run(words) == 4
    before = rows("out/results.csv")
    assert [row["scene"] for row in before] == ["0", "1"]
    assert {row["worst"] for row in before} == {"worst"}
    assert all(3 <= float(row["scene value"]) <= 5 for row in before)
    assert all(float(row["worst robustness"]) < 0 < float(row["violated"]) for row in before)
    assert run([*words, "--resume"]) == 4
    assert rows("out/results.csv") == before
    assert "worst: scene" in capsys.readouterr().out
    assert run(["report", "out", "-o", "page.html"]) == 0
    assert "scene value" in Path("page.html").read_text()


def test_a_search_is_written_and_reported() -> None:
    assert run(["falsify", "names.rl", "-o", "out"]) == 4
    for row in rows("out/failing.csv"):
        assert row["violated"] == "worst"
        assert float(row["violated robustness"]) > 0 > float(row["worst"])
        assert 1 <= float(row["evaluation value"]) <= 2
        assert 0 <= int(row["evaluation"]) < 6
    assert run(["report", "out", "-o", "page.html"]) == 0
    assert "evaluation value" in Path("page.html").read_text()


def test_runs_with_several_params_are_told_apart() -> None:
    Path("runs.yaml").write_text("- {run: 1, candidates: 3}\n- {run: 2, candidates: 4}\n")
    assert run(["compile", "names.rl", "-n", "1", "--params", "runs.yaml", "-o", "out"]) == 0
    found = rows("out/runs.csv")
    assert [row["run"] for row in found] == ["run-000", "run-001"]
    assert [row["run value"] for row in found] == ["1", "2"]
    assert [row["candidates value"] for row in found] == ["3", "4"]


def test_columns_of_sampled_scenes() -> None:
    found = testing.sample(TEXT, 2).to_dict()
    assert found["scene"] == [0, 1]
    assert all(3 <= value <= 5 for value in found["scene value"])
    assert all(1 <= value <= 2 for value in found["verdict"])
