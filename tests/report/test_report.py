"""`roadlang report`: what is in the page, and what happens without results."""

from __future__ import annotations

import csv
import dataclasses
import html
import json
import math
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang.cli.main import run
from roadlang.diagnostics import DiagnosticError
from roadlang.drive.robustness_colors import COLOR_STEPS, robustness_color
from roadlang.ir.results_record import RESULTS_FILE
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.report.numbers import percent
from roadlang.report.page_text import embedded, page_text
from roadlang.report.report import read_results
from roadlang.report.results import ResultRow
from roadlang.report.tables import table_record
from roadlang.session.reports import write_report
from roadlang.session.scene import installed
from tests.report.made_results import BEND, made


def data_of(page: Path) -> Any:
    text = page.read_text(encoding="utf-8")
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
    assert found is not None
    return json.loads(found[1])


@pytest.fixture(scope="module")
def search(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made("falsify", tmp_path_factory.mktemp("search"))


@pytest.fixture(scope="module")
def bends(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made(
        "run",
        tmp_path_factory.mktemp("bends"),
        *("-n", "40"),
        text=BEND.replace("6m/s..16m/s", "6m/s..12m/s"),
    )


@pytest.fixture
def copy(search: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(search, tmp_path / "copy"))


def test_the_table_has_every_draw_of_every_drive(search: Path) -> None:
    table = data_of(write_report(search))["table"]
    names = [column["name"] for column in table["columns"]]
    rows = []
    for name in ("failing.csv", "safe.csv"):
        with (search / name).open(newline="") as file:
            rows += list(csv.DictReader(file))
    assert len(table["rows"]) == len(rows)
    assert set(names) == {name for row in rows for name in row}
    assert {c["name"]: c["unit"] for c in table["columns"]}["ego/drive 1/speed"] == "m/s"
    by_number = {row[names.index("evaluation")]: row for row, _, _ in table["rows"]}
    for row in rows:
        for name in ("slow", "apart", "ego/drive 1/speed", "oak/offset"):
            shown = by_number[int(row["evaluation"])][names.index(name)]
            assert shown == pytest.approx(float(row[name]), rel=1e-4)


def test_the_summary_has_the_numbers_of_the_search(search: Path) -> None:
    summary = json.loads((search / "summary.json").read_text())
    text = write_report(search).read_text()
    facts = dict(re.findall(r"<dt>([^<]+)</dt><dd>([^<]+)</dd>", text))
    assert facts["Evaluations"] == str(summary["evaluations"])
    assert facts["Failing"] == str(summary["failing"])
    assert facts["Distinct"] == str(summary["distinct"])
    assert facts["First failure"] == str(summary["first_failure"])
    low, high = (100 * summary["failure_rate"][end] for end in ("low", "high"))
    assert facts["Failure rate at random"] == f"{low:.3g}% to {high:.3g}%"
    assert f"{summary['distinct']} distinct failures" in text


def test_the_page_says_what_it_was_made_from(search: Path) -> None:
    record = json.loads((search / "provenance.json").read_text())
    (listed,) = re.findall(r'<dl class="provenance">(.*?)</dl>', write_report(search).read_text())
    cells = re.findall(r"<(dt|dd)>(?:<code>)?(.*?)(?:</code>)?</(?:dt|dd)>", listed)
    assert [name for kind, name in cells if kind == "dt"] == [
        "Command", "Scene file", "Inputs (SHA-256)", "Versions", "Simulator",
    ]  # fmt: skip
    others = [f"{name} {is_}" for name, is_ in record["plugins"].items() if name != "roadlang"]
    assert [html.unescape(text) for kind, text in cells if kind == "dd"] == [
        record["again"],
        record["source"],
        *(f"{name} {digest}" for name, digest in record["inputs"].items()),
        f"roadlang {record['roadlang']}",
        *others,
        "the embedded engine",
    ]


def test_every_failure_and_safe_scene_can_be_stepped_through(search: Path) -> None:
    drives = data_of(write_report(search))["drives"]
    failures = json.loads((search / "failures/index.json").read_text())["failures"]
    safe = json.loads((search / "safe/index.json").read_text())["safe"]
    names = [f"failures/{item['scene'].removesuffix('.json')}" for item in failures]
    names += [f"safe/{item['scene'].removesuffix('.json')}" for item in safe]
    assert [drive["name"] for drive in drives] == names
    for drive, item in zip(drives, [*failures, *safe], strict=True):
        found = {verdict["name"]: verdict["robustness"] for verdict in drive["verdicts"]}
        assert found == pytest.approx(item["robustness"])
        assert {verdict["unit"] for verdict in drive["verdicts"]} == {"m", "m/s"}
        assert [agent["name"] for agent in drive["agents"]] == ["ego", "lead"]
        assert drive["objects"][0][:2] == ["oak", "tree"]


def test_a_path_is_where_the_trace_has_it(search: Path) -> None:
    drive = data_of(write_report(search))["drives"][0]
    trace = json.loads((search / f"{drive['name']}.trace.json").read_text())
    agent = drive["agents"][0]
    time, x = sum(drive["time"]) / 1000, sum(agent["x"]) / 100
    assert time == pytest.approx(trace["time"][-1], abs=1e-3)
    assert x == pytest.approx(trace["agents"]["ego"]["x"][-1], abs=0.01)
    turned = np.cumsum(agent["heading"]) / 1000
    assert turned[-1] > 0.1
    assert math.remainder(turned[-1] - trace["agents"]["ego"]["heading"][-1], math.tau) == (
        pytest.approx(0.0, abs=2e-3)
    )


def test_colors_of_paths_go_from_the_worst_to_the_best(search: Path) -> None:
    shades = data_of(write_report(search))["shades"]
    assert len(shades) == 2 * COLOR_STEPS + 1
    ends = [robustness_color(share) for share in (-1.0, 0.0, 1.0)]
    assert [shades[0], shades[COLOR_STEPS], shades[-1]] == ends


def test_what_sets_failures_apart_is_their_speed(search: Path) -> None:
    text = write_report(search).read_text()
    part = text.partition('<section id="apart"')[2].partition("</section>")[0]
    names = re.findall(r"<figcaption><strong>([^<]+)</strong> (larger|smaller)", part)
    assert names[0] == ("ego/drive 1/speed", "larger")


def test_the_same_results_give_the_same_bytes(copy: Path, search: Path) -> None:
    assert write_report(copy).read_bytes() == write_report(search).read_bytes()


def test_it_names_no_address_and_no_file(search: Path) -> None:
    text = write_report(search).read_text()
    addresses = re.findall(r"(?:https?:)?//[\w.]+/[\w./]*", text)
    assert set(addresses) <= {"http://www.w3.org/2000/svg"}
    assert "src=" not in text
    assert "@import" not in text
    assert "url(" not in text


def test_a_run_with_several_params_is_one_page(tmp_path: Path) -> None:
    text = BEND.replace("6m/s..16m/s", "(top / 2)..top").replace(
        "road main", "param top = 9m/s\nroad main"
    )
    (tmp_path / "values.yaml").write_text("[{top: 9m/s}, {top: 20m/s}]")
    folder = made(
        "run", tmp_path, "-n", "2", "--params", str(tmp_path / "values.yaml"), text=text
    )  # fmt: skip
    data = data_of(write_report(folder))
    names = [drive["name"] for drive in data["drives"]]
    assert sorted(names) == [f"run-00{run}/scene-000{n}" for run in (0, 1) for n in (0, 1)]
    assert data["table"]["columns"][0]["name"] == "run"


def test_a_scene_that_was_driven_alone_has_a_page(search: Path, tmp_path: Path) -> None:
    run(["run", str(search / "failures/0001.json"), "-o", str(tmp_path / "again")])
    page = write_report(tmp_path / "again").read_text()
    assert "One scene, driven" in page
    assert "Failure rate" not in page


def test_from_the_command_line(
    search: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "page.html"
    assert run(["report", str(search), "-o", str(target)]) == 0
    assert f"{target} ({target.stat().st_size / 1e6:.1f} MB)" in capsys.readouterr().out
    assert target.read_text().startswith("<!doctype html>")


SAID = {
    "nothing": "there is no such folder",
    "file": "it is a file",
    "empty": f"there is no {RESULTS_FILE}",
}


@pytest.mark.parametrize("kind", SAID)
def test_without_results_there_is_a_diagnostic(
    kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "out"
    if kind == "file":
        folder.write_text("mine")
    elif kind == "empty":
        folder.mkdir()
    assert run(["report", str(folder)]) == 2
    said = capsys.readouterr().err
    assert "RL720" in said
    assert SAID[kind] in said
    makes = "DIR` makes a folder with results" if kind == "file" else f"{folder}` makes them"
    assert f"`roadlang run FILE -o {makes}" in said
    assert not (folder / "report.html").exists()


NAMES = (
    "provenance.json", "summary.json", "journal.jsonl", "failures/index.json", "safe/index.json",
    "failures/0001.json", "failures/0001.trace.json",
)  # fmt: skip
CONTENTS = ("", "{", "[]", "{}", "null", '{"schema": "roadlang.journal/1"}\n{"index": "x"}\n')


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("content", CONTENTS)
def test_a_file_that_was_changed_is_named(
    name: str, content: str, copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (copy / name).write_text(content)
    assert run(["report", str(copy)]) == 1
    error = capsys.readouterr().err
    assert "RL721" in error
    assert Path(name).name in error
    is_of_all = name == "provenance.json"  # nothing else has the command
    again = "the folder again, with" if is_of_all else "it again with the command in prov"
    assert f"create {again}" in error
    assert "object has no attribute" not in error
    assert "Expecting value" not in error


@pytest.mark.parametrize(
    "name", [name for name in NAMES if "provenance" not in name and "safe" not in name]
)
def test_a_file_that_is_missing_is_named(
    name: str, copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (copy / name).unlink()
    assert run(["report", str(copy)]) == 1
    error = capsys.readouterr().err
    assert "RL721" in error
    assert Path(name).name in error


def test_a_page_that_cannot_be_written_leaves_nothing(copy: Path, tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("mine")
    with pytest.raises(DiagnosticError, match="RL460"):
        write_report(copy, blocked / "page.html")


def test_a_hundred_failures_with_much_traffic_stay_below_five_megabytes(search: Path) -> None:
    """Twenty cars each, on a road of its own, every 0.02 s, in motion that hardly packs."""
    results = read_results(search, installed())
    drive = results.drives[0]
    random = np.random.Generator(np.random.PCG64(1))
    time = np.linspace(0.0, 60.0, 3001)
    columns = {field.name for field in dataclasses.fields(AgentTrace)} - {
        "name",
        "time",
        "length",
        "width",
    }
    drives = []
    for number in range(100):
        if number < 5:  # what is packed apart may be the same
            agents = {}
            for name in ("ego", "lead", *(f"car[{i}]" for i in range(18))):
                moves: dict[str, Any] = {
                    column: random.normal(0.0, 1.0, 3001).cumsum() for column in columns
                }
                agents[name] = dataclasses.replace(
                    drive.trace.agents["ego"], name=name, time=time, **moves
                )
        road = drive.scene.roads[0]
        y = tuple(
            y + float(np.sin(s / 9.0 + number)) for s, y in zip(road.stations, road.y, strict=True)
        )
        scene = dataclasses.replace(drive.scene, roads=(dataclasses.replace(road, y=y),))
        trace = Trace(time, agents, "noise")
        drives.append(dataclasses.replace(drive, row=number, scene=scene, trace=trace))
    page = page_text(dataclasses.replace(results, drives=drives), installed())
    assert 1_000_000 < len(page.encode()) < 5_000_000


def test_data_never_ends_its_element() -> None:
    value = {"name": "</script><!-- <script> ]]> & \u2028", "list": [1.5, None, True]}
    written = embedded(value)
    assert json.loads(written) == value
    assert not set("<>&\u2028\u2029") & set(written)


def test_cells_of_the_table_are_values_as_json_has_them(search: Path) -> None:
    """What a drive does not have is null, not the word `None`."""
    values = {"speed": 10.0, "wet": True, "copies": 3, "apart": None, "kind": "car"}
    results = dataclasses.replace(
        read_results(search, installed()), rows=(ResultRow(0, False, values, {}),)
    )
    table = table_record(results, {"speed": "m/s"}, {})
    shown = dict(zip([c["name"] for c in table["columns"]], table["rows"][0][0], strict=True))
    assert json.loads(json.dumps(shown)) == values


def test_pairs_of_draws_are_told_that_hold_where_neither_does_alone(copy: Path) -> None:
    medians: dict[tuple[str, ...], tuple[float | None, bool | None]] = {
        ("a",): (None, None), ("b",): (0.0, True), ("c",): (-1.0, False), ("a", "c"): (0.0, True),
        ("a", "b"): (0.5, True), ("c", "d"): (None, None), ("c", "e"): (0.0, False),
        ("f",): (-2.5, False), ("g",): (-2.5, False), ("h",): (-3.0, False),
    }  # fmt: skip
    listed = [
        {"draws": draws, "robustness": rho, "holds": holds}
        for draws, (rho, holds) in medians.items()
    ]
    record = {"expectation": "slow", "unit": "m/s", "robustness": -2.5, "medians": listed}
    first = min((copy / "failures").glob("[0-9][0-9][0-9][0-9].json"))
    first.with_suffix(".explanation.json").write_text(json.dumps(record))
    told = [
        found for drive in data_of(write_report(copy))["drives"] if (found := drive["explanation"])
    ]
    expected = [
        ["a", None, None], ["b", 0.0, True], ["c", -1.0, False], ["h", -3.0, False],
        ["a + c", 0.0, True],
    ]  # fmt: skip
    assert told == [{"expectation": "slow", "unit": "m/s", "medians": expected, "others": 2}]


@pytest.mark.parametrize(
    ("change", "has_rate"),
    [
        ({}, True),
        ({"sampler": "random"}, True),
        ({"sampler": "halton"}, False),
        ({"sampler": "standard.grid"}, False),
        ({"seed": None}, False),
    ],
)
def test_a_rate_needs_scenes_drawn_at_random_in_one_run(
    change: dict[str, Any], has_rate: bool, bends: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "out"
    shutil.copytree(bends, folder)
    file = folder / RESULTS_FILE
    file.write_text(json.dumps(json.loads(file.read_text()) | change))
    found = read_results(folder, installed())
    assert (found.rate is not None) is has_rate
    if found.rate is not None:
        assert (found.rate.failures, found.rate.scenes) == (found.failing, 40)
    if change in ({}, {"sampler": "halton"}):
        page = write_report(folder).read_text()
        assert ("Failure rate at random" in page) is has_rate
        assert f"{percent(found.failing / 40)} of the scenes driven" in page


def test_two_runs_are_not_drawn_from_one_distribution(bends: Path, tmp_path: Path) -> None:
    for number in (0, 1):
        shutil.copytree(bends, tmp_path / f"run-00{number}")
    found = read_results(tmp_path, installed())
    assert found.rate is None
    assert len(found.rows) == 80


def test_safe_drives_are_shown_from_the_nearest_to_failing_to_the_farthest(bends: Path) -> None:
    found = read_results(bends, installed())
    worst = {
        row.number: min(rho for rho in row.robustness.values() if rho is not None)
        for row in found.rows
    }
    safe = sorted(worst[row.number] for row in found.rows if not row.has_failed)
    shown = [worst[drive.row] for drive in found.drives if not drive.has_failed]
    assert len(safe) > len(shown) == 12
    assert shown == sorted(shown)
    assert (shown[0], shown[-1]) == (safe[0], safe[-1])
    failed = [worst[drive.row] for drive in found.drives if drive.has_failed]
    assert failed == sorted(failed)
    assert len(failed) == found.failing > 0
    assert found.drives[len(failed) :] == [drive for drive in found.drives if not drive.has_failed]
