"""`roadlang mine` prints the tightest parameters."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from roadlang.cli.main import run


@pytest.fixture
def trace(tmp_path: Path) -> str:
    path = tmp_path / "drive.csv"
    path.write_text("t,e\n0,1\n1,3\n2,2\n")
    return str(path)


def test_values_in_words_and_json(trace: Any, capsys: pytest.CaptureFixture[str]) -> None:
    mining = ["mine", "always (e <= limit)", "--param", "limit=0..20", trace]
    assert run(mining) == 0
    assert "limit = 3\nalways (e <= 3" in capsys.readouterr().out
    assert run([*mining, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["values"]["limit"] == pytest.approx(3, abs=1e-4)


def test_a_parameter_of_which_larger_values_fail_again_is_warned_of(
    trace: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["mine", "always (e < p or e > p + 1.5)", "--param", "p=-9..9", trace]) == 0
    printed = capsys.readouterr()
    assert "warning[RL344]: the formula is not monotone in `p`" in printed.err
    assert run(["mine", "always (e < p)", "--param", "p=-9..9", trace]) == 0
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(("bounds", "code"), [("limit=0..1", 1), ("limit", 2), ("x=0..1", 1)])
def test_refusals(trace: Any, bounds: str, code: int) -> None:
    assert run(["mine", "always (e <= limit)", "--param", bounds, trace]) == code


def test_a_parameter_that_the_formula_lacks_may_be_a_word_that_is_no_signal(
    trace: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["mine", "always (e < lmit)", "--param", "limit=0..9", trace]) == 1
    assert "did you mean `lmit`?" in capsys.readouterr().err


@pytest.mark.parametrize("command", [["monitor"], ["mine", "--param", "limit=0..9"]])
def test_a_trace_without_a_sample_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], command: list[str]
) -> None:
    (tmp_path / "empty.csv").write_text("t,e\n")
    assert run([*command, "always (e < limit)", str(tmp_path / "empty.csv")]) == 1
    told = capsys.readouterr().err
    assert "error[RL300]" in told
    assert "empty.csv has no rows below" in told


def test_a_parameter_is_given_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "drive.csv").write_text("t,e\n0,1\n")
    twice = ["--param", "a=0..2", "--param", "a=0..5"]
    assert run(["mine", "always (e < a)", *twice, str(tmp_path / "drive.csv")]) == 2
    assert "--param a is given twice" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ([], "always (e < 3.00001)  holds on every trace"),
        (["--margin", "0"], "always (e < 3)  has a robustness of 0 or more on every trace"),
        (["--unknown-holds"], "holds, or can still hold, on every trace"),
    ],
)
def test_what_is_said_of_the_formula_is_what_was_asked_for(
    trace: Any, capsys: pytest.CaptureFixture[str], options: list[str], told: str
) -> None:
    assert run(["mine", "always (e < limit)", "--param", "limit=0..9", *options, trace]) == 0
    assert told in capsys.readouterr().out


@pytest.mark.parametrize("command", [["monitor"], ["mine", "--param", "limit=0..9"]])
def test_a_trace_in_place_of_the_formula_is_told(
    trace: Any, capsys: pytest.CaptureFixture[str], command: list[str]
) -> None:
    assert run([*command, trace, "always (e < limit)"]) == 2
    assert "drive.csv is a file: FORMULA comes first" in capsys.readouterr().err
