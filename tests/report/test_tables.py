"""The table of all drives: columns, cells, and which rows are left out."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from roadlang.report import tables
from roadlang.report.draw_charts import MOST, draw_charts, separation
from roadlang.report.page_text import _units
from roadlang.report.results import ResultRow, Results
from roadlang.report.tables import table_record


def row(number: int, failed: bool = False, **values: Any) -> ResultRow:
    draws = tuple(name for name in values if name not in ("rho", "worst_time"))
    return ResultRow(number, failed, values, {}, draws)


def record(*rows: ResultRow, units: dict[str, str] | None = None, **drives: int) -> Any:
    results: Any = Results(None, (), rows, (), {})  # type: ignore[arg-type]
    return table_record(results, units or {}, {int(key[1:]): n for key, n in drives.items()})


def test_outcomes_come_before_draws_in_their_order() -> None:
    found = record(row(0, speed=1.0, rho=2.0, angle=3.0), row(1, worst_time=4.0))
    assert [column["name"] for column in found["columns"]] == [
        "rho", "worst_time", "speed", "angle",
    ]  # fmt: skip
    assert [column["draw"] for column in found["columns"]] == [0, 0, 1, 1]


def test_angles_are_in_degrees_and_places_in_meters_and_seconds() -> None:
    rows = row(0, angle=math.pi / 3.0), ResultRow(1, True, {"worst time": 1.0, "worst x": 2.0}, {})
    found = record(*rows, units={"angle": "rad"})
    assert {column["name"]: column["unit"] for column in found["columns"]} == {
        "worst time": "s", "worst x": "m", "angle": "deg",
    }  # fmt: skip
    assert found["rows"][0][0] == [None, None, 60.0]


@pytest.mark.parametrize(
    ("value", "cell"),
    [
        (1.23456789, 1.2346), (123456.789, 123460.0), (7, 7), (True, True), (None, None),
        ("word", "word"), ((1, 2), "(1, 2)"),
    ],
)  # fmt: skip
def test_cells_have_five_digits(value: Any, cell: Any) -> None:
    found = record(row(0, it=value))["rows"][0][0][0]
    assert found == cell
    assert type(found) is type(cell)


def test_rows_say_whether_they_failed_and_which_drive_shows_them() -> None:
    found = record(row(3, True, a=1), row(5, a=2), _5=0)
    assert [rest for _, *rest in found["rows"]] == [[1, None], [0, 0]]
    assert found["leftOut"] == 0


def test_in_a_long_table_safe_rows_are_left_out_evenly(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of 400 rows of 10 values 150 stay: the 50 that fail, and every 3.5th of the others."""
    monkeypatch.setattr(tables, "MOST_CELLS", 1500)
    many = {f"v{n}": n for n in range(10)}
    rows = [row(n, n % 8 == 0, **many) for n in range(400)]
    found = record(*rows)
    assert (len(found["rows"]), found["leftOut"]) == (150, 250)
    assert sum(failed for _, failed, _ in found["rows"]) == 50
    assert len(record(*rows[:150])["rows"]) == 150
    short = record(*(row(n, True, a=n) for n in range(2000)))
    assert (len(short["rows"]), short["leftOut"]) == (1500, 500)
    assert [cells[0] for cells, *_ in short["rows"]] == list(range(1500))


def test_however_wide_a_table_a_hundred_rows_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tables, "MOST_CELLS", 10)
    found = record(*(row(n, a=n, b=n) for n in range(300)))
    assert [cells[0] for cells, *_ in found["rows"]] == list(range(0, 300, 3))


@pytest.mark.parametrize(
    ("values", "delta"),
    [
        ([1, 2, 3, 4], 1.0),      # the last two fail
        ([4, 3, 2, 1], -1.0),
        ([1, 3, 2, 3], 0.25),     # 2: one below, one above; 3: one below, one equal
        ([1, 1, 1, 1], 0.0),
        ([1, 2, "3", 4], 0.0),
        ([1, 2, True, 4], 0.0),
        ([1, None, 3, 4], 0.0),
    ],
)  # fmt: skip
def test_separation_by_hand(values: list[object], delta: float) -> None:
    assert separation(values, np.array([False, False, True, True])) == delta


def test_charts_are_of_the_draws_that_set_failures_apart_the_most_first() -> None:
    rows = [
        row(n, n >= 20, apart=float(n), less=-float(n if n != 19 else 99), same=float(n % 5))
        for n in range(40)
    ]
    page = draw_charts(rows, {"apart": "m/s"})
    titles = [part.partition("<")[0] for part in page.split("<strong>")[1:]]
    assert titles == ["apart", "less"]
    assert "larger where it fails: 100" in page
    assert "smaller where it fails: 95" in page
    assert draw_charts(rows[:20], {}) == draw_charts(rows[20:], {}) == ""


def test_there_are_six_charts_at_most() -> None:
    rows = [row(n, n >= 2, **{f"d{k}": float(n) for k in range(9)}) for n in range(4)]
    assert draw_charts(rows, {}).count("<figure>") == MOST == 6


def test_units_are_those_of_draws_and_of_robustness() -> None:
    scene = SimpleNamespace(units={"speed": "m/s", "turn": "rad"})
    judged = [SimpleNamespace(verdict=SimpleNamespace(name="apart"), unit="m")]
    views: Any = [
        SimpleNamespace(drive=SimpleNamespace(scene=scene), judged=judged),
        SimpleNamespace(drive=SimpleNamespace(scene=SimpleNamespace(units={"at": "m"})), judged=[]),
    ]
    assert _units(views) == {"speed": "m/s", "turn": "rad", "apart": "m", "at": "m"}
