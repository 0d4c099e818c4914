"""Formulas that compare what differs in dimension are refused for traces of drives."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang.cli.trace_dimensions import check_dimensions
from roadlang.diagnostics import DiagnosticError
from roadlang.drive.trace_files import COLUMNS
from roadlang.ir.trace_document import COLUMN_UNITS

DRIVE = "time,agent,speed,station,progress,cross_track_error\n0,ego,8,1,.1,.2\n1,ego,9,9,.2,.1\n"


def test_every_column_of_a_trace_has_a_unit() -> None:
    assert tuple(COLUMN_UNITS) == ("time", *COLUMNS, "elevation")


@pytest.mark.parametrize(
    ("formula", "reason"),
    [
        ("always (ego.speed < 3m)", "`ego.speed` is a speed and `3m` is a length"),
        ("always (2km > speed)", "`2km` is a length and `speed` is a speed"),
        ("always[0, 5m] (speed < 9)", "`time` is a time and `5m` is a length"),
        ("duration (speed > 3) < 20m", "is a time and `20m` is a length"),
        ("always (abs(cross_track_error) + speed < 4m)", "they cannot be added"),
        ("always (station - speed < 4m)", "they cannot be subtracted"),
        ("always (max(station, speed) < 4)", "`station` is a length and `speed` is a speed"),
        ("always (min(speed, 3, 3m) < 4)", "`speed` is a speed and `3m` is a length"),
        ("always (station * speed < 40m)", "a quantity in m^2/s and `40m` is a length"),
    ],
)
def test_what_differs_in_dimension_is_refused(tmp_path: Path, formula: str, reason: str) -> None:
    (tmp_path / "a.csv").write_text(DRIVE)
    with pytest.raises(DiagnosticError, match="RL205") as raised:
        check_dimensions(formula, [str(tmp_path / "a.csv")])
    assert reason in str(raised.value)


@pytest.mark.parametrize(
    "formula",
    [
        "always (speed < 60km/h)",
        "always[0, 500ms] (speed < 60 and progress < 90%)",
        "always (max(speed, 3, 60km/h) < 90km/h)",
        "always (station / speed < 100s and 2 * speed < 40m/s)",
        "always (other < 3m)",
    ],
)
def test_what_fits_or_is_not_known_passes(tmp_path: Path, formula: str) -> None:
    (tmp_path / "a.csv").write_text(DRIVE)
    check_dimensions(formula, [str(tmp_path / "a.csv"), str(tmp_path / "missing.csv")])


def test_other_files_are_in_whatever_they_are_in(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("time,speed\n0,1\n")
    (tmp_path / "a.json").write_text('{"time": [0], "speed": [1]}')
    check_dimensions("always (speed < 3m)", [str(tmp_path / "a.csv"), str(tmp_path / "a.json")])
    (tmp_path / "b.json").write_text('{"schema":"roadlang.trace/2","time":[0]}')
    with pytest.raises(DiagnosticError, match="RL205"):
        check_dimensions("always (speed < 3m)", [str(tmp_path / "b.json")])


@pytest.mark.parametrize("command", [["monitor"], ["mine", "--param", "limit=0..9"]])
def test_the_commands_refuse_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], command: list[str]
) -> None:
    (tmp_path / "a.csv").write_text(DRIVE)
    assert run([*command, "always (speed < limit + 3m)", str(tmp_path / "a.csv")]) == 1
    assert "error[RL205]" in capsys.readouterr().err
