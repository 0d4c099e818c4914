"""`roadlang monitor` judges recorded traces."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from roadlang.cli.main import run


@pytest.fixture
def trace(tmp_path: Path) -> str:
    path = tmp_path / "drive.csv"
    path.write_text("t,e,v\n0,1,5\n0.5,3,5\n1.5,7,6\n2,2,5\n")
    return str(path)


def test_the_table_says_what_decides(trace: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["monitor", "always (e < 6)", trace]) == 4
    told = capsys.readouterr().out
    assert "violated" in told
    assert "decided at 1.5: e < 6, where e = 7" in told
    assert "from 1.5 to 1.5 not e < 6, worst -1 at 1.5" in told


def test_numbers_are_printed_in_six_digits(trace: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["monitor", "always (v < 60km/h and v < 0.5)", trace]) == 4
    told = capsys.readouterr().out
    assert told.startswith("always (v < 16.6667 and v < 0.5)\n")
    assert run(["monitor", "always (v < 16km/h)", trace]) == 4
    assert "decided at 1.5: v < 4.44444, where v = 6" in capsys.readouterr().out


def test_a_robustness_of_zero_has_no_sign(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "log.csv").write_text("t,x\n0,1\n1,1\n")
    assert run(["monitor", "always (x == 1)", str(tmp_path / "log.csv"), "--open"]) == 0
    assert "-0" not in capsys.readouterr().out


@pytest.mark.parametrize("later", ["1711846790100000000", "1711846790.10025", "846791.000001"])
def test_time_stamps_keep_their_digits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], later: str
) -> None:
    (tmp_path / "log.csv").write_text(f"t,x\n0,1\n{later},9\n")
    run(["monitor", "always (x < 5)", str(tmp_path / "log.csv")])
    assert f"from {later} to {later} not x < 5" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("formula", "code", "verdict"),
    [
        ("always[0, 2] (e < 8)", 0, "satisfied"),
        ("always (e < 8)", 0, "satisfied"),
        ("eventually (e > 8)", 4, "violated"),
        ("eventually[0, 1] (v > 5)", 4, "violated"),
    ],
)
def test_exit_codes_and_json(
    trace: Any, capsys: pytest.CaptureFixture[str], formula: str, code: int, verdict: str
) -> None:
    assert run(["monitor", formula, trace, "--json"]) == code
    found = json.loads(capsys.readouterr().out)
    assert found["verdict"] == verdict
    assert len(found["trace"]) == len(found["positions"]) == 4
    assert found["explanation"]["chain"][0]["rho"] == found["robustness"]
    lo, hi = (float(end) for end in found["range"])
    assert lo <= found["robustness"] <= hi


def test_several_traces(trace: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other = tmp_path / "other.json"
    other.write_text('{"t": [0, 1], "e": [0, 1]}')
    assert run(["monitor", "always (e < 6)", trace, str(other), "--json"]) == 4
    assert [found["verdict"] for found in json.loads(capsys.readouterr().out)] == [
        "violated", "satisfied",
    ]  # fmt: skip


def test_the_plot_marks_what_is_violated(trace: Any, tmp_path: Path) -> None:
    picture = tmp_path / "out.svg"
    run(["monitor", "always (e < 6 and abs(v) < 9)", trace, "--plot", str(picture)])
    root = ElementTree.parse(picture).getroot()
    shaded = [node for node in root.iter() if node.get("class") == "violated"]
    assert len(shaded) == 2
    assert sum(node.tag.endswith("polyline") for node in root.iter()) == 3


@pytest.mark.parametrize(
    ("arguments", "code", "told"),
    [
        (["always (f < 6)"], 1, "RL304"),
        (["always (e < "], 1, "RL0"),
        (["e"], 1, "RL320"),
        (["e < 6", "--wrap", "1"], 1, "RL306"),
        (["e < 6", "--wrap", "0.001km"], 1, "RL306"),
        (["e < 6", "--wrap", "1s"], 2, "'1s' is not a length"),
        (["e < 6", "--wrap", "0"], 2, "write a number above 0m"),
        (["e < 6", "--plot", "drive.csv/plot.svg"], 2, "RL460"),
    ],
)
def test_faults_are_explained(
    trace: Any,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    code: int,
    told: str,
) -> None:
    monkeypatch.chdir(os.path.dirname(trace))
    assert run(["monitor", arguments[0], trace, *arguments[1:]]) == code
    assert told in capsys.readouterr().err


def test_files_are_judged_between_samples(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    trace = tmp_path / "a.csv"
    trace.write_text("time,x\n0,0\n1,9\n2,9\n")
    formula = "always[0.2, 0.8] (x < 5)"
    assert run(["monitor", formula, str(trace), "--semantics", "linear", "--json"]) == 4
    found = json.loads(capsys.readouterr().out)
    assert found["verdict"] == "violated"
    assert found["robustness"] == pytest.approx(-2.2)
    assert run(["monitor", formula, str(trace), "--semantics", "held", "--wrap", "3"]) == 2


@pytest.mark.parametrize("semantics", ["sampled", "linear"])
def test_an_open_trace_may_go_on(
    trace: Any, capsys: pytest.CaptureFixture[str], semantics: str
) -> None:
    command = ["monitor", "always (e < 8)", trace, "--semantics", semantics]
    assert run([*command, "--open"]) == 0
    assert "unknown  1           [-inf, 1]" in capsys.readouterr().out
    assert run(command) == 0
    assert "range" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("rows", "told", "help_"),
    [
        ("0,1\n1,\n", "error[RL302]: `x` is nan at position 1", "drop the samples without a value"),
        ("0,1\n0,2\n", "0 is followed by 0 (sample 1)", "sort the samples by position"),
        ("0,1\nnan,2\n", "position 1 is nan", "sort the samples by position"),
    ],
)
@pytest.mark.parametrize(
    "command",
    [["monitor", "always (x < 9)"], ["mine", "always (x < limit)", "--param", "limit=0..9"]],
)
def test_of_several_traces_the_one_at_fault_is_named(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    rows: str,
    told: str,
    help_: str,
    command: list[str],
) -> None:
    right, wrong = tmp_path / "right.csv", tmp_path / "wrong.csv"
    right.write_text("t,x\n0,1\n1,2\n")
    wrong.write_text("t,x\n" + rows)
    assert run([*command, str(right), str(wrong)]) == 1
    text = capsys.readouterr().err
    assert told in text
    assert f"--> {wrong}" in text
    assert f"= help: {help_}" in text
    assert str(right) not in text


@pytest.mark.parametrize("name", ["out.png", "out", "out.svgz"])
def test_a_plot_is_svg(
    trace: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    plot = tmp_path / name
    assert run(["monitor", "always (e < 9)", trace, "--plot", str(plot)]) == 2
    assert "this writes SVG: name a file that ends in `.svg`" in capsys.readouterr().err
    assert not plot.exists()
    assert run(["monitor", "always (e < 9)", trace, "--plot", str(tmp_path / "out.SVG")]) == 0


def test_the_column_of_positions_is_no_signal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As where the time comes last in a table."""
    path = tmp_path / "late.csv"
    path.write_text("e,time\n1,0\n2,1\n")
    assert run(["monitor", "always (e < 6)", str(path)]) == 1
    assert "`e` is the first column, which is taken as the positions" in capsys.readouterr().err


def test_a_name_with_a_hyphen_is_no_difference(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "hyphen.csv"
    path.write_text("time,gap-left\n0,1\n1,2\n")
    assert run(["monitor", "always (gap-left > 0)", str(path)]) == 1
    assert "did you mean `` `gap-left` `` (in back quotes)?" in capsys.readouterr().err
    assert run(["monitor", "always (`gap-left` > 0)", str(path)]) == 0
