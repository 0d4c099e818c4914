"""`roadlang run` and `roadlang falsify` in the embedded engine: files, lines, resuming."""

from __future__ import annotations

import csv
import hashlib
import json
import shlex
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from roadlang.cli.main import run
from roadlang.stl import parse, read_trace

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (90m, 25m), (90m, 80m)] }, width: 7m }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 6m/s..16m/s } }
expect slow: always (ego.speed < 11m/s)
simulate with builtin { duration: 6s, control_step: 0.1s }
falsify with random { evaluations: 12, random: 0% }
"""  # noqa: E501


@pytest.fixture(autouse=True)
def scene_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "bend.rl"
    path.write_text(TEXT)
    return path


def results(folder: str = "out") -> list[dict[str, str]]:
    with (Path(folder) / "results.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def test_a_line_for_each_scene_and_the_worst(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["run", "bend.rl", "-o", "out", "-n", "5"]) == 4
    lines = capsys.readouterr().out.splitlines()
    rows = results()
    assert len(lines) == 6
    violated = [row for row in rows if row["slow satisfied"] == "false"]
    assert 0 < len(violated) < 5
    worst = min(rows, key=lambda row: float(row["slow"]))
    assert f"all expectations hold in {5 - len(violated)} of 5 scenes" in lines[-1]
    assert f"worst: scene {worst['scene']}, slow {float(worst['slow']):.3g} at" in lines[-1]
    for line, row in zip(lines, rows, strict=False):
        word = "holds, worst:" if row["slow satisfied"] == "true" else "violated"
        assert line.startswith(f"scene {row['scene']}: {word} slow {float(row['slow']):.3g} at ")
        assert line.endswith(" s driven)")


def test_results_have_draws_robustness_and_the_worst_moment() -> None:
    run(["run", "bend.rl", "-o", "out", "-n", "3"])
    for row in results():
        assert 6 <= float(row["ego/drive 1/speed"]) <= 16
        assert row["verdict"] == ("holds" if row["slow satisfied"] == "true" else "violated")
        assert row["worst"] == "slow"
        assert row["worst agent"] == "ego"
        assert 0 <= float(row["worst time"]) <= 6
        assert 4.9 <= float(row["worst station"]) <= 110


def test_what_run_writes_is_read_by_the_other_commands() -> None:
    run(["run", "bend.rl", "-o", "out"])
    row = results()[0]
    for name in ("scene-0000.trace.csv", "scene-0000.trace.json"):
        _, positions, signals = read_trace(Path("out") / name)
        rho = parse("always (ego.speed < 11)").rho(positions, signals)
        assert float(rho) == pytest.approx(float(row["slow"]), abs=1e-6)
        code = run(["monitor", "always (ego.speed < 11)", f"out/{name}"])
        assert code == (0 if row["slow satisfied"] == "true" else 4)
    figure = ElementTree.parse("out/scene-0000.drive.svg")
    assert len(list(figure.iter("{http://www.w3.org/2000/svg}polyline"))) >= 2


def test_each_scene_is_beside_its_trace_and_replays() -> None:
    run(["run", "bend.rl", "-o", "out", "-n", "2"])
    run(["run", "out/scene-0001.json", "-o", "again"])
    for name in ("scene-0001.json", "scene-0001.trace.json", "scene-0001.drive.svg"):
        assert (Path("again") / name).read_bytes() == (Path("out") / name).read_bytes()


def test_traces_hold_what_moves() -> None:
    tree = "object oak is tree on main at 50m { side: right, offset: 2m }\n"
    clear = "expect clear: always (gap(ego, oak) > 1m)\n"
    Path("bend.rl").write_text(TEXT + tree + clear)
    run(["run", "bend.rl", "-o", "out"])
    assert list(json.loads(Path("out/scene-0000.trace.json").read_text())["agents"]) == ["ego"]
    assert "oak" not in Path("out/scene-0000.trace.csv").read_text()
    assert "oak" in Path("out/scene-0000.drive.svg").read_text()
    assert float(results()[0]["clear"]) > 0


def test_the_worst_is_no_expectation_that_equality_decides() -> None:
    Path("bend.rl").write_text(
        TEXT.replace("16m/s", "7m/s") + "expect calm: always (ego.contacts == 0)\n"
    )
    run(["run", "bend.rl", "-o", "out"])
    row = results()[0]
    assert (row["calm"], row["calm satisfied"]) == ("0", "true")
    assert row["worst"] == "slow"


def test_results_say_what_they_were_made_from_and_how_to_make_them_again() -> None:
    digest = hashlib.sha256(Path("bend.rl").read_bytes()).hexdigest()
    for words in (["run", "-n", "2", "--duration", "5.1000001"], ["falsify", "--evaluations", "6"]):
        folder, again = Path(words[0]), Path(f"{words[0]} again")
        run([words[0], "bend.rl", "-o", str(folder), "--seed", "3", *words[1:]])
        record = json.loads((folder / "provenance.json").read_text())
        assert record["inputs"] == {"bend.rl": digest}
        assert (record["seed"], record["source"]) == (3, "bend.rl")
        table = folder / ("results.csv" if words[0] == "run" else "failing.csv")
        before = table.read_bytes()
        run([*shlex.split(record["again"])[1:], "-o", str(again)])
        assert (again / table.name).read_bytes() == before


def test_processes_change_nothing() -> None:
    run(["run", "bend.rl", "-n", "3", "-o", "one"])
    run(["run", "bend.rl", "-n", "3", "-o", "two", "--jobs", "2"])
    names = {path.name for path in Path("one").iterdir()}
    assert names == {path.name for path in Path("two").iterdir()}
    for name in names:
        assert (Path("one") / name).read_bytes() == (Path("two") / name).read_bytes(), name


def test_an_interrupted_run_goes_on(capsys: pytest.CaptureFixture[str]) -> None:
    run(["run", "bend.rl", "-n", "3", "-o", "whole"])
    run(["run", "bend.rl", "-n", "2", "-o", "part"])
    (Path("part") / "scene-0001.drive.svg").unlink()
    capsys.readouterr()
    run(["run", "bend.rl", "-n", "3", "-o", "part", "--resume"])
    printed = capsys.readouterr().out.splitlines()
    assert [line.split(":")[0] for line in printed[:-1]] == ["scene 1", "scene 2"]
    assert results("part") == results("whole")
    for path in Path("whole").glob("scene-*"):
        assert (Path("part") / path.name).read_bytes() == path.read_bytes()


def test_the_run_of_another_seed_is_not_gone_on_with(capsys: pytest.CaptureFixture[str]) -> None:
    run(["run", "bend.rl", "-o", "out"])
    assert run(["run", "bend.rl", "-o", "out", "--seed", "7", "--resume"]) == 2
    refused = capsys.readouterr().err
    assert "RL702" in refused
    assert "leave out `--resume`" in refused


def test_a_scene_that_compile_wrote_is_driven_as_it_is() -> None:
    run(["compile", "bend.rl", "-n", "2", "-o", "scenes", "--emit", "json"])
    run(["run", "bend.rl", "-n", "2", "-o", "sampled"])
    run(["run", "scenes/scene-0001.json", "-o", "alone"])
    for ending in ("trace.csv", "trace.json", "verdicts.json"):
        alone = (Path("alone") / f"scene-0001.{ending}").read_bytes()
        assert alone == (Path("sampled") / f"scene-0001.{ending}").read_bytes()


def test_a_file_that_is_no_scene_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    Path("other.json").write_text("{}")
    assert run(["run", "other.json"]) == 1
    refused = capsys.readouterr().err
    assert "RL461" in refused
    assert "--> other.json" in refused


@pytest.mark.parametrize(
    "option", [["-n", "3"], ["--seed", "5"], ["--set", "reach=3m"], ["--params", "a.yaml"]]
)
def test_options_of_sampling_are_refused_with_a_scene(
    option: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["run", "scene.json", *option]) == 2
    assert f"{option[0]} applies to scene files" in capsys.readouterr().err


def test_failures_replay_from_the_command_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["falsify", "bend.rl", "-o", "search"]) == 4
    printed = capsys.readouterr().out
    assert "violated  failures/0001.json  slow" in printed
    index = json.loads(Path("search/failures/index.json").read_text())
    summary = json.loads(Path("search/summary.json").read_text())
    assert summary["distinct"] == len(index["failures"]) > 0
    for failure in index["failures"]:
        assert failure["replays"]
        path = Path("search/failures") / failure["scene"]
        assert run(["run", str(path), "-o", "again"]) == 4
        number = failure["evaluation"]
        trace = (Path("again") / f"scene-{number:04d}.trace.json").read_bytes()
        assert trace == path.with_suffix(".trace.json").read_bytes()


def test_tables_of_failing_and_safe_scenes() -> None:
    run(["falsify", "bend.rl", "-o", "search"])
    tables = {}
    for name in ("failing", "safe"):
        with (Path("search") / f"{name}.csv").open(newline="") as file:
            tables[name] = list(csv.DictReader(file))
    assert len(tables["failing"]) + len(tables["safe"]) == 12
    assert all(float(row["slow"]) <= 0 for row in tables["failing"])
    assert all(float(row["slow"]) >= 0 for row in tables["safe"])
    assert all(row["violation station"] for row in tables["failing"])


def test_fewer_failures_of_another_search_replace_the_earlier_ones() -> None:
    run(["falsify", "bend.rl", "-o", "search"])
    Path("search/failures/notes.txt").write_text("mine")
    run(["falsify", "bend.rl", "-o", "search", "--failures", "1"])
    left = {path.name for path in Path("search/failures").iterdir()}
    assert left == {"0001.json", "0001.svg", "0001.trace.csv", "0001.trace.json"} | {
        "index.json",
        "notes.txt",
    }


def test_safe_scenes_are_there_to_compare() -> None:
    run(["falsify", "bend.rl", "-o", "search"])
    index = json.loads(Path("search/safe/index.json").read_text())["safe"]
    assert 2 <= len(index) <= 12
    margins = [entry["robustness"]["slow"] for entry in index]
    assert margins == sorted(margins)
    assert margins[0] >= 0
    for entry in index:
        assert run(["run", f"search/safe/{entry['scene']}", "-o", "again"]) == 0


def test_nothing_found_is_done(capsys: pytest.CaptureFixture[str]) -> None:
    Path("bend.rl").write_text(TEXT.replace("16m/s", "9m/s"))
    assert run(["falsify", "bend.rl", "-o", "out", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["failing"] == 0


def test_readings_of_sensors_are_beside_the_trace() -> None:
    Path("gps.rl").write_text(TEXT.replace("6m/s..16m/s } }", "8m/s }, sense with gps }"))
    run(["run", "gps.rl", "-o", "out", "-n", "2", "--duration", "1"])
    for number in range(2):
        with np.load(f"out/scene-000{number}.ego.gps.npz") as readings:
            assert len(readings["time"]) >= 1


def test_without_a_scene_it_says_what_is_in_the_way(capsys: pytest.CaptureFixture[str]) -> None:
    crowd = "agent crowd is truck on main at 20m..30m { count: 3 }\n"
    row = "agent late is car on main at 61m { count: 9, spacing: 20m }\n"
    Path("bend.rl").write_text(TEXT + crowd + row)
    assert run(["run", "bend.rl", "-o", "out"]) == 3
    found = capsys.readouterr().err
    assert "`late[8]` would stand" in found
    assert "rejected" in found
    Path("bend.rl").write_text(TEXT + crowd)
    assert run(["run", "bend.rl", "-o", "out"]) == 3
    assert "copies of `crowd` are in the way of each other" in capsys.readouterr().err


def test_a_run_removes_the_files_of_an_earlier_run_and_no_others() -> None:
    assert run(["run", "bend.rl", "-o", "out", "-n", "4"]) == 4
    mine = Path("out/notes.txt")
    mine.write_text("mine")
    assert run(["run", "bend.rl", "-o", "out", "-n", "2"]) in (0, 4)
    assert sorted({path.name[:10] for path in Path("out").glob("scene-*")}) == [
        "scene-0000",
        "scene-0001",
    ]
    assert mine.read_text() == "mine"


@pytest.mark.parametrize(("stated", "said"), [("5.1000001", "5.1000001"), ("5", "5")])
def test_the_command_for_the_same_results_has_the_duration_to_its_last_digit(
    stated: str, said: str
) -> None:
    run(["run", "bend.rl", "-n", "1", "-o", "out", "--duration", stated])
    again = json.loads(Path("out/provenance.json").read_text())["again"]
    assert shlex.split(again)[-2:] == ["--duration", said]


def test_a_scene_is_driven_whatever_the_case_of_the_ending_of_its_file() -> None:
    run(["compile", "bend.rl", "-o", "out"])
    Path("out/scene-0000.json").rename("SCENE.JSON")
    assert run(["run", "SCENE.JSON", "-o", "drives"]) in (0, 4)
    assert [row["scene"] for row in results("drives")] == ["0"]
