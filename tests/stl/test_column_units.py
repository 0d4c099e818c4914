"""Numbers with units in formulas, for columns whose file says what they are in."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang import stl
from roadlang.cli.main import run
from roadlang.diagnostics import DiagnosticError
from roadlang.stl.formats.column_units import check_units
from roadlang.stl.formats.trace_stream import samples_of_lines

ROW = "t,speed,e [mm],gap,share\nms,km/h,,m,%\n0,48,3,9,50\n1000,52,4,9,60\n"


@pytest.mark.parametrize(
    ("formula", "column"),
    [
        ("always (speed < 50km/h)", "speed"),
        ("always (gap > 2 and 2 * speed + gap < 50m/s)", "speed"),
        ("always[0, 5s] (speed < 50)", "t"),
        ("duration (speed < 50) > 2s", "t"),
        ("always (`e [mm]` < 5mm)", "e [mm]"),
        ("always (share < 70%)", "share"),
    ],
)
def test_a_number_with_a_unit_is_refused_for_a_column_in_another_unit(
    tmp_path: Path, formula: str, column: str
) -> None:
    (tmp_path / "a.csv").write_text(ROW)
    with pytest.raises(DiagnosticError, match="RL345") as raised:
        check_units(formula, [str(tmp_path / "a.csv")])
    (found,) = raised.value.diagnostics
    assert f"column `{column}` of a.csv" in found.message
    assert run(["monitor", formula, str(tmp_path / "a.csv")]) == 1


@pytest.mark.parametrize(
    "formula",
    [
        "always[0, 1000] (speed < 60)",
        "always (gap < 10m)",
        "always (gap < 10m and speed < 60)",
        "always (`e [mm]` < 5)",
    ],
)
def test_numbers_in_the_unit_of_the_column_and_columns_in_si_are_fine(
    tmp_path: Path, formula: str
) -> None:
    (tmp_path / "a.csv").write_text(ROW)
    assert run(["monitor", formula, str(tmp_path / "a.csv")]) == 0


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("time_ms,x\n0,1\n100,2\n", "ms"),
        ("stamp_NS,x\n0,1\n100,2\n", "ns"),
        ("%time,x\n1711846790000000000,1\n1711846790100000000,2\n", "ns"),
        ("t,x\n,m\n1711846790000000,1\n1711846790100000,2\n", "us"),
        ("# log\nt;x\n1711846790000,0;1\n1711846790100,0;2\n", "ms"),
    ],
)
def test_clocks_that_do_not_count_seconds_are_known(tmp_path: Path, text: str, unit: str) -> None:
    (tmp_path / "a.csv").write_text(text)
    with pytest.raises(DiagnosticError, match=f"is in `{unit}`, but `2s`"):
        check_units("always[0s, 2s] (x < 5)", [str(tmp_path / "a.csv")])
    check_units("always[0, 2] (x < 5m)", [str(tmp_path / "a.csv")])


@pytest.mark.parametrize("start", ["0", "1711846790.25", "2024-03-31T01:59:50Z", "99999999999"])
def test_clocks_of_seconds_are_fine(tmp_path: Path, start: str) -> None:
    (tmp_path / "a.csv").write_text(f"t,x\n{start},1\n")
    check_units("always[0s, 2s] (x < 5)", [str(tmp_path / "a.csv")])


@pytest.mark.parametrize(
    "text",
    ["t,x (left),y\n0,1,2\n", '{"t": [0], "x [mm]": [1]}', "t,x\n,,\n0,1\n", "", "t;x\n0;1,5\n"],
)
def test_files_that_state_no_unit_say_nothing(tmp_path: Path, text: str) -> None:
    file = tmp_path / ("a.json" if text.startswith("{") else "a.csv")
    file.write_text(text)
    check_units("always[0s, 1s] (x < 5mm and `x (left)` < 5mm)", [str(file)])


def test_the_row_of_units_is_skipped_in_files_and_in_streams(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(ROW)
    _, positions, signals = stl.read_trace(tmp_path / "a.csv")
    streamed = list(samples_of_lines(ROW.splitlines(keepends=True)))
    assert positions == [position for position, _ in streamed] == [0, 1000]
    assert signals["speed"] == [values["speed"] for _, values in streamed] == [48, 52]
